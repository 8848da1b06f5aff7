"""The page of `life --over`: the life by every theory over a field, and where each is valid."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.life.record import note_of
from rolamento.life.theories import THEORIES
from rolamento.pages.across import cautions_over, failures, field_column, place_text, read_text
from rolamento.pages.given import title_of
from rolamento.pages.life import MILLION, remarks
from rolamento.studies.names import setting_name
from rolamento.units import HOUR
from rolamento.words import said
from rolamento.words.theories import theory_heads, theory_name

if TYPE_CHECKING:
    from rolamento.life import Headline, Life
    from rolamento.tasks.life_over import LifeCurve

__all__ = ["life_over_page"]

_INVALID: Final = "*"
_LESS: Final = "<"
_RELIABILITY: Final = 0.9


def life_over_page(curves: Sequence[LifeCurve]) -> doc.Document:
    """Return the page of life over a field.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    """
    title = title_of(curves[0].case)

    field = curves[0].over.field.label
    figure = doc.Figure(
        said("Life over {field}", field=field), lambda: plots.life_figure(curves), "life"
    )
    return doc.Document(
        title,
        (
            doc.Section("", (doc.Title(title),)),
            *(_curve(curve, place) for place, curve in enumerate(curves)),
            doc.Section("", (figure, _points(curves)), "points"),
        ),
        kind="life_over",
        main="points",
    )


def _curve(curve: LifeCurve, place: int) -> doc.Section:
    blocks: list[doc.Block] = []
    if curve.label:
        setting = setting_name(curve.label)
        blocks.append(doc.Statement(said("with {setting}", setting=setting), indent=2))
    blocks += [_table(curve, place), *_extremes(curve)]
    blocks += cautions_over(curve.over.field, curve.values, curve.cautions)
    blocks += [*_remarks(curve), *failures(curve.status)]
    heading = said("Life over {field}", field=curve.over.field.label)
    return doc.Section(heading, tuple(blocks), f"life{place or ''}")


def _table(curve: LifeCurve, place: int) -> doc.Table:
    """Set the lives below each other; the theories that matter less may stand below."""
    order = sorted(curve.theories, key=lambda name: not THEORIES[name].standard)
    columns = [field_column(curve.over.field, curve.values)]
    columns += [_column(curve, curve[name], theory_heads(name), name) for name in order]
    leading = curve.headline
    bounded = leading.theory[leading.below].tolist()
    if any(theory not in curve.theories for theory in bounded):
        heads = (said("leading"), said("life"))
        columns.insert(1, _column(curve, leading, heads, "headline"))
    first = next(
        (n for n, column in enumerate(columns) if not _standard(column.key) and n > 1), None
    )
    return doc.Table(
        tuple(columns),
        f"life{place or ''}",
        legends=_legends(curve),
        breaks=() if first is None else (doc.Break(first, ""),),
    )


def _standard(name: str) -> bool:
    return name not in THEORIES or THEORIES[name].standard


def _column(
    curve: LifeCurve, life: Life | Headline, heads: tuple[str, str], key: str
) -> doc.Column:
    """Lives of a theory, marked where it is not valid or only a bound."""
    form = ".3r [h]" if curve.in_hours else ".3r [10⁶ rev]"
    scale = HOUR if curve.in_hours else MILLION
    values: list[doc.CellContent] = [
        doc.Number(
            scale * float(value),
            form,
            before=_LESS if below else "",
            behind=_INVALID if isfinite(value) and not valid and not below else " ",
        )
        for value, valid, below in zip(curve.shown(life), life.valid, life.below, strict=True)
    ]
    return doc.Column(
        "\n".join(f"{head} " for head in heads),
        values,
        key,
        "h" if curve.in_hours else "10⁶ rev",
        align="right",
        tones=["" if valid else "warning" for valid in life.valid],
    )


def _legends(curve: LifeCurve) -> tuple[str, ...]:
    legends = []
    if curve.field != "life.reliability":
        own = curve.case.life
        reliability = _RELIABILITY if own is None else own.reliability
        legends.append(said("for {reliability:.7 %} reliability", reliability=reliability))
    lives: list[Life | Headline] = [*curve.theories.values(), curve.headline]
    if any(not np.all(life.valid | life.below) for life in curve.theories.values()):
        legends.append(said("* the theory is not valid there"))
    if any(np.any(life.below) for life in lives):
        legends.append(said("< the life is below the number"))
    return tuple(legends)


def _extremes(curve: LifeCurve) -> list[doc.Block]:
    """Say where the life that leads is longest and shortest, where it is valid."""
    leading = curve.headline
    led = curve.shown(leading)
    usable = leading.valid & np.isfinite(led)
    if np.count_nonzero(usable) < 2:
        return []
    most = int(np.argmax(np.where(usable, led, -np.inf)))
    least = int(np.argmin(np.where(usable, led, np.inf)))
    names = dict.fromkeys(map(theory_name, leading.theory[usable].tolist()))
    text = said(
        "{theory}: longest at {most_at}, {most}; shortest at {least_at}, {least}",
        theory="; ".join(names),
        most_at=_at(curve, most),
        most=_written(curve, float(led[most])),
        least_at=_at(curve, least),
        least=_written(curve, float(led[least])),
    )
    return [doc.Statement(text, indent=2)]


def _at(curve: LifeCurve, place: int) -> str:
    return read_text(curve.over.field, curve.values, float(curve.values[place]))


def _written(curve: LifeCurve, life: float) -> str:
    if curve.in_hours:
        return said("{hours:.3r h}", hours=life * HOUR)
    return said("{life:.3r 10⁶ rev}", life=life * MILLION)


def _remarks(curve: LifeCurve) -> Sequence[doc.Block]:
    solved = curve.status == "converged"
    found = [
        (theory, note_of(key, life.element), place_text(curve.over.field, curve.values, where))
        for theory, life in curve.theories.items()
        for key, where in ((key, where & solved) for key, where in life.notes.items())
        if where.any()
    ]
    return remarks(found, len(curve.theories))


# --- files -------------------------------------------------------------------------------------


def _points(curves: Sequence[LifeCurve]) -> doc.Table:
    """Return all points of all curves, for files."""
    field = curves[0].over.field
    theories = list(dict.fromkeys(name for curve in curves for name in curve.theories))
    columns = [
        doc.Column(
            said("variant"), [curve.label for curve in curves for _ in range(len(curve))], "variant"
        ),
        doc.Column(
            field.label,
            [float(value) for curve in curves for value in curve.values],
            field.name,
            field_column(field, curves[0].values).unit,
        ),
        doc.Column(
            said("status"), [str(code) for curve in curves for code in curve.status], "status"
        ),
    ]
    for name in theories:
        columns += _of_points(curves, [curve.theories.get(name) for curve in curves], name)
    columns += _of_points(curves, [curve.headline for curve in curves], "headline")
    columns.append(
        doc.Column(
            said("leading theory"),
            [str(name) for curve in curves for name in curve.headline.theory],
            "headline_theory",
        )
    )
    for key, symbol in (("viscosity_ratio", "κ"), ("contamination_factor", "e_C")):
        columns.append(
            doc.Column(
                symbol, [float(value) for curve in curves for value in getattr(curve, key)], key
            )
        )
    return doc.Table(tuple(columns), "points", only_in_files=True)


def _of_points(
    curves: Sequence[LifeCurve], records: Sequence[Life | Headline | None], key: str
) -> list[doc.Column]:
    def gathered(attribute: str, absent: Any) -> list[Any]:
        return [
            value
            for curve, own in zip(curves, records, strict=True)
            for value in ([absent] * len(curve) if own is None else getattr(own, attribute))
        ]

    name = theory_name(key) if key in THEORIES else said("leading life")
    yes, no = said("yes"), said("no")
    columns = [
        doc.Column(name, [HOUR * float(h) for h in gathered("hours", np.nan)], key, "h"),
        doc.Column(name, [MILLION * float(n) for n in gathered("life", np.nan)], key, "10⁶ rev"),
    ]
    marks = (("valid", "valid", said("valid")), ("below", "upper_bound", said("bound")))
    for attribute, end, head in marks:
        values = [yes if one else no for one in gathered(attribute, False)]
        columns.append(doc.Column(head, values, f"{key}_{end}"))
    return columns
