"""Catalogues for a reader: a list of bearings, a page of one; JSON in SI."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any, Final

from rich.text import Text

from rolamento._json import dumps
from rolamento.catalogue import (
    Candidate,
    CatalogueBearing,
    InternalGeometry,
    ambiguity_axis,
    ball_name,
)
from rolamento.document.medium import Medium
from rolamento.errors import InputError
from rolamento.report.catalogue_words import CATALOGUE_WORDS, CatalogueWords
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.units import MILLIMETRE, from_si

SCHEMA: Final = 1
_SHORT_NAMES: Final = {"dynamic_rating": "C", "static_rating": "C0", "f0": "f0"}


def search_report(
    found: Sequence[CatalogueBearing],
    words: Words = ENGLISH,
    medium: Medium | None = None,
    *,
    is_all: bool = True,
) -> str:
    """Return a list of bearings as text that ends in a newline.

    Parameters
    ----------
    found
        Results of a search.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    is_all
        Whether the search found no more.
    """
    page, said = Page(words, medium or Medium()), _words(words)
    if not found:
        return rendered(page.medium, [page.hanging(Text(), said.nothing)])
    heads = ("", "", "d", "D", "B", "α", "C", "C0", said.balls)
    units = ("", "", "mm", "mm", "mm", "°", "N", "N", "")
    rows = [[page.text(cell, "dim") for cell in line] for line in (heads, units)]
    rows += [_line_of_bearing(page, bearing) for bearing in found]
    lines = page.columns(rows, "llrrrrrrr", gap=2)
    if not is_all:
        lines += page.hanging(Text("  "), said.more, "dim")
    return rendered(page.medium, [lines])


def _line_of_bearing(page: Page, bearing: CatalogueBearing) -> list[Text]:
    lengths = (bearing.bore, bearing.outside_diameter, bearing.width)
    angle = bearing.contact_angle
    balls = ""
    if bearing.ball_count is not None and bearing.ball_diameter is not None:
        size = page.digits.short(bearing.ball_diameter / MILLIMETRE)
        balls = f"{bearing.ball_count} × {size} mm"
    numbers = [
        *(None if length is None else length / MILLIMETRE for length in lengths),
        None if angle is None else degrees(angle),
        bearing.dynamic_rating,
        bearing.static_rating,
    ]
    cells = ["" if number is None else page.digits.short(number) for number in numbers]
    return [
        page.text(bearing.designation, "bold"),
        page.text(bearing.maker),
        *map(page.text, cells),
        page.text(balls),
    ]


def bearing_report(
    geometry: InternalGeometry | None,
    bearing: CatalogueBearing,
    words: Words = ENGLISH,
    medium: Medium | None = None,
) -> str:
    """Return the page of one bearing as text that ends in a newline.

    Parameters
    ----------
    geometry
        Its inside; None if nothing tells of it.
    bearing
        What the catalogue holds.
    words, medium
        As in `search_report`.
    """
    page, said = Page(words, medium or Medium()), _words(words)
    parts = [
        _heading_and_meanings(page, said, bearing, geometry),
        _published_figures(page, said, bearing),
    ]
    if geometry is None:
        parts.append(page.hanging(Text(), said.no_inside, "bold"))
        return rendered(page.medium, parts)
    parts.append(_inside(page, said, geometry))
    if geometry.candidates:
        parts.append(_candidates(page, said, geometry.candidates))
    return rendered(page.medium, parts)


def _heading_and_meanings(
    page: Page, said: CatalogueWords, bearing: CatalogueBearing, geometry: InternalGeometry | None
) -> Lines:
    named = " ".join(part for part in (bearing.maker, bearing.designation) if part)
    kind = page.medium.fitted(said.kinds[bearing.kind])
    lines = [
        Text.assemble((page.medium.fitted(named), "bold"), f"  {kind}"),
        page.rule(page.medium.width),
    ]
    if geometry is None:
        return lines
    designation = geometry.designation
    parts = [
        f"{part}: {said.translated.get(meaning, meaning)}" for part, meaning in designation.meanings
    ]
    if geometry.clearance_class:
        parts.append(f"{said.clearance_class} {geometry.clearance_class}")
    if designation.unknown:
        parts.append(said.unknown.format(parts=" ".join(designation.unknown)))
    if parts:
        label = page.text(f"{said.meanings}  ", "dim")
        lines += page.hanging(label, "; ".join(parts))
    return lines


def _published_figures(page: Page, said: CatalogueWords, bearing: CatalogueBearing) -> Lines:
    rows = [
        [page.text(said.names[name]), page.text(_with_unit(page, name, value))]
        for name, value in bearing.figures.items()
    ]
    lines = [page.heading(said.figures), *page.columns(rows, "lr", gap=2)]
    for source in dict.fromkeys(bearing.sources.values()):
        lines += page.hanging(Text("  "), source, "dim")
    return lines


def _inside(page: Page, said: CatalogueWords, geometry: InternalGeometry) -> Lines:
    rows = []
    for name, value in geometry.fields.items():
        origin = geometry.origins[name]
        style = "" if origin == "published" else "yellow"
        size = ball_name(value) if name == "ball_diameter" else ""
        size = "" if size.endswith("mm") else size
        rows.append(
            [
                page.text(said.names[name]),
                page.text(_with_unit(page, name, value)),
                page.text(said.origins[origin], style),
                page.text(size, "dim"),
            ]
        )
    lines = [page.heading(said.inside), *page.columns(rows, "lrll", gap=2)]
    if geometry.is_inferred:
        figures = ", ".join(_SHORT_NAMES.get(n, n) for n in geometry.candidates[0].rests_on)
        lines += page.hanging(Text("  "), said.warning.format(figures=figures), "yellow")
        if not geometry.candidates[0].reproduces:
            lines += page.hanging(Text("  "), said.unfit, "bold yellow")
    return lines


def _candidates(page: Page, said: CatalogueWords, candidates: Sequence[Candidate]) -> Lines:
    rows = [[page.text(head, "dim") for head in said.heads]]
    for one in candidates:
        digits = page.digits
        low, high = one.pitch_diameter_range
        name = ball_name(one.ball_diameter)
        cells = [
            str(one.rank),
            str(one.ball_count),
            digits.fixed(one.ball_diameter / MILLIMETRE, 3),
            name if name.endswith("in") else "",
            digits.fixed(one.pitch_diameter / MILLIMETRE, 1),
            digits.fixed(low / MILLIMETRE, 1),
            digits.fixed(high / MILLIMETRE, 1),
            digits.short(one.inner_conformity, 4),
            digits.short(one.outer_conformity, 4),
            _signed(page, one.dynamic_error, 100.0, 1),
            _signed(page, one.static_error, 100.0, 1),
            _signed(page, one.f0_error, 1.0, 2),
            digits.fixed(one.misfit, 1) + ("" if one.reproduces else " ×"),
            digits.fixed(100.0 * one.weight, 0),
        ]
        rows.append([page.text(cell, "bold" if one.rank == 1 else "") for cell in cells])
    lines = [page.heading(said.candidates), *page.columns(rows, "rrrlrrrrrrrrlr", gap=1)]
    return lines + page.hanging(Text("  "), said.legend, "dim")


def _signed(page: Page, value: float | None, factor: float, decimals: int) -> str:
    if value is None:
        return ""
    text = page.digits.fixed(factor * value, decimals)
    return text if value < 0.0 else f"+{text}"


def _with_unit(page: Page, name: str, value: float) -> str:
    if name == "ball_count":
        return str(value)
    if name == "contact_angle":
        return f"{page.digits.short(degrees(value), 4)}°"
    if name in ("dynamic_rating", "static_rating"):
        return f"{page.digits.short(value)} N"
    if name in ("f0", "inner_conformity", "outer_conformity"):
        return page.digits.short(value, 4)
    digits = 6 if name == "pitch_diameter" else 5
    return f"{page.digits.short(value / MILLIMETRE, digits)} mm"


def _words(words: Words) -> CatalogueWords:
    return CATALOGUE_WORDS.get(words.code, CATALOGUE_WORDS["en"])


def axis_toml(geometry: InternalGeometry) -> str:
    """Return the axis of a study file over the candidates that the ratings allow.

    Parameters
    ----------
    geometry
        With candidates.

    Raises
    ------
    InputError
        If its balls are published: there is nothing to vary.
    """
    if not geometry.candidates:
        raise InputError(
            "has published balls: there are no candidates",
            field="designation",
            value=geometry.designation.text,
        )
    axis = ambiguity_axis(geometry.candidates)
    lines = ["[[axes]]", f'name = "{axis["name"]}"', "[axes.zipped]"]
    for name, values in axis["zipped"].items():
        is_length = name.endswith("diameter")
        texts = [f'"{from_si(value, "length")}"' if is_length else str(value) for value in values]
        lines.append(f'"{name}" = [{", ".join(texts)}]')
    return "\n".join(lines) + "\n"


# --- data -------------------------------------------------------------------------------------


def search_json(found: Sequence[CatalogueBearing]) -> str:
    """Return a list of bearings as one JSON object in SI."""
    mapping = {
        "schema": SCHEMA,
        "kind": "catalogue",
        "bearings": [_bearing_mapping(b) for b in found],
    }
    return dumps(mapping)


def bearing_json(geometry: InternalGeometry | None, bearing: CatalogueBearing) -> str:
    """Return one bearing as one JSON object in SI; ``inside`` is null if nothing tells of it."""
    mapping: dict[str, Any] = {
        "schema": SCHEMA,
        "kind": "bearing",
        "bearing": _bearing_mapping(bearing),
        "clearance_class": None,
        "meanings": {},
        "unknown": [],
        "inside": None,
        "candidates": [],
    }
    if geometry is not None:
        mapping |= {
            "clearance_class": geometry.clearance_class,
            "meanings": dict(geometry.designation.meanings),
            "unknown": list(geometry.designation.unknown),
            "inside": {
                name: {"value": value, "origin": geometry.origins[name]}
                for name, value in geometry.fields.items()
            },
            "candidates": [_candidate_mapping(one) for one in geometry.candidates],
        }
    return dumps(mapping)


def _bearing_mapping(bearing: CatalogueBearing) -> dict[str, Any]:
    return {
        "designation": bearing.designation,
        "maker": bearing.maker,
        "kind": bearing.kind,
        "figures": {
            name: {"value": value, "source": bearing.sources.get(name, "")}
            for name, value in bearing.figures.items()
        },
    }


def _candidate_mapping(one: Candidate) -> dict[str, Any]:
    names = one.__dataclass_fields__
    return {
        name: list(value) if isinstance(value := getattr(one, name), tuple) else value
        for name in names
    }
