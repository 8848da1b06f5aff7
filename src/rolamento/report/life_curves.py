"""Life over a field for a reader: every theory at every value, and where each is valid."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from math import isinf
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.life.theories import FIRST_LEFT_OUT
from rolamento.plots.axes_units import read_values
from rolamento.report.across import place_text, written_values
from rolamento.report.language import ENGLISH, Words
from rolamento.report.life_statement import given_percent, life_text, lives_column, remarks, said_of
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import csv_number, json_text

if TYPE_CHECKING:
    from rolamento.life import Headline, Life
    from rolamento.tasks.life_over import LifeCurve

__all__ = ["curves_csv", "curves_json", "curves_report"]

SCHEMA: Final = 1
_MARK: Final = "*"
_LESS: Final = "<"
_LEADS: Final = "headline"
_RELIABILITY: Final = 0.9


@dataclass(frozen=True, slots=True)
class _Words:
    heading: str
    variant: str
    legend: str
    legend_varied: str
    fails: str
    left_out: str
    below: str
    leads: str
    longest: str
    failed: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        heading="Life over {field}",
        variant="with {label}",
        legend="in {unit}, for {reliability} reliability",
        legend_varied="in {unit}",
        fails="* the theory does not hold there",
        below="< the life is below the number",
        leads="leads",
        left_out="no room here, but in --csv and --json: {names}",
        longest=(
            "{theory}: longest at {most_at} {symbol}, {most}; shortest at {least_at} {symbol},"
            " {least}"
        ),
        failed="{failed} of {count} points without a result: {reasons}",
    ),
    "pt": _Words(
        heading="Vida em função de {field}",
        variant="com {label}",
        legend="em {unit}, para {reliability} de confiabilidade",
        legend_varied="em {unit}",
        fails="* a teoria não vale ali",
        below="< a vida está abaixo do número",
        leads="conduz",
        left_out="sem lugar aqui, mas em --csv e --json: {names}",
        longest=(
            "{theory}: a maior em {most_at} {symbol}, {most}; a menor em {least_at} {symbol},"
            " {least}"
        ),
        failed="{failed} de {count} pontos sem resultado: {reasons}",
    ),
}


def curves_report(
    curves: Sequence[LifeCurve], words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return life over a field as text that ends in a newline.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    head = page.hanging(Text(), curves[0].case.title or words.untitled, "bold")
    parts: list[Lines] = [[*head, page.rule(page.medium.width)]]
    return rendered(page.medium, [*parts, *(_curve(page, curve) for curve in curves)])


def _curve(page: Page, curve: LifeCurve) -> Lines:
    own, said = _WORDS.get(page.words.code, _WORDS["en"]), said_of(page)
    lines = [page.heading(own.heading.format(field=curve.field))]
    if curve.label:
        lines += page.hanging(Text("  "), own.variant.format(label=curve.label))
    unit = said.hour if curve.in_hours else said.million
    leading = curve.headline
    table, left_out = _life_table(page, curve)
    lines += table
    reliability = _RELIABILITY if curve.case.life is None else curve.case.life.reliability
    varied = curve.field == "life.reliability"
    legend = (own.legend_varied if varied else own.legend).format(
        unit=unit,
        reliability=given_percent(page, reliability),
    )
    lines += page.hanging(Text("  "), legend, "dim")
    if left_out:
        lines += page.hanging(Text("  "), own.left_out.format(names="; ".join(left_out)), "dim")
    if any(not np.all(life.valid | life.below) for life in curve.theories.values()):
        lines += page.hanging(Text("  "), own.fails, "dim")
    if np.any(leading.below) or any(np.any(life.below) for life in curve.theories.values()):
        lines += page.hanging(Text("  "), own.below, "dim")
    lines += _extremes(page, own, curve, unit)
    return lines + _remarks(page, curve) + _failures(page, own, curve)


def _life_table(page: Page, curve: LifeCurve) -> tuple[Lines, list[str]]:
    """Set the lives below each other; theories for which there is no room are named instead."""
    own, said = _WORDS.get(page.words.code, _WORDS["en"]), said_of(page)
    across, symbol = read_values(curve.over.field, curve.values)
    values = written_values(page, across)
    columns: dict[str, Lines] = {
        "": [Text(), page.text(symbol, "dim"), *map(page.text, values)],
        **{
            name: _column(page, said.short[name], curve, life)
            for name, life in curve.theories.items()
        },
    }
    leading = curve.headline
    if any(theory not in curve.theories for theory in leading.theory[leading.below].tolist()):
        columns[_LEADS] = _column(page, ("", own.leads), curve, leading)
    left_out = []
    for name in FIRST_LEFT_OUT:
        if name in columns and page.width_of(list(columns.values())) > page.medium.width:
            del columns[name]
            left_out.append(said.names[name])
    rows = list(zip(*columns.values(), strict=True))
    return page.columns(rows, "r" * len(columns)), left_out


def _column(page: Page, heads: Sequence[str], curve: LifeCurve, life: Life | Headline) -> Lines:
    """A theory's name, and its lives, marked where it is not valid."""
    cells = zip(lives_column(page, curve.shown(life).tolist()), life.valid, life.below, strict=True)
    return [
        *(page.text(f"{word} ") for word in heads),
        *(_marked(page, cell, bool(held), bool(bound)) for cell, held, bound in cells),
    ]


def _marked(page: Page, cell: str, valid: bool, below: bool) -> Text:
    """A life, with a mark where it is a bound or does not hold."""
    if below:
        return page.text(f"{_LESS}{cell} ", "" if valid else "yellow")
    return page.text(f"{cell} ") if valid else page.text(f"{cell}{_MARK}", "yellow")


def _extremes(page: Page, own: _Words, curve: LifeCurve, unit: str) -> Lines:
    """Say where the life that leads is longest and shortest, where it is valid."""
    leading = curve.headline
    led = curve.shown(leading)
    usable = leading.valid & np.isfinite(led)
    if np.count_nonzero(usable) < 2:
        return []
    across, symbol = read_values(curve.over.field, curve.values)
    most = int(np.argmax(np.where(usable, led, -np.inf)))
    least = int(np.argmin(np.where(usable, led, np.inf)))
    names = dict.fromkeys(said_of(page).names[theory] for theory in leading.theory[usable].tolist())
    text = own.longest.format(
        theory="; ".join(names),
        symbol=symbol,
        most_at=page.digits.short(float(across[most]), 4),
        most=f"{life_text(page, float(led[most]))} {unit}",
        least_at=page.digits.short(float(across[least]), 4),
        least=f"{life_text(page, float(led[least]))} {unit}",
    )
    return page.hanging(Text("  "), text)


def _remarks(page: Page, curve: LifeCurve) -> Lines:
    solved = curve.status == "converged"
    found = [
        (theory, name, place_text(page, curve.over.field, curve.values, where))
        for theory, life in curve.theories.items()
        for name, where in ((name, where & solved) for name, where in life.notes.items())
        if where.any()
    ]
    return remarks(page, found, len(curve.theories))


def _failures(page: Page, own: _Words, curve: LifeCurve) -> Lines:
    failed = curve.status[curve.status != "converged"]
    if not failed.size:
        return []
    reasons = ", ".join(page.words.reasons.get(code, code) for code in np.unique(failed).tolist())
    text = own.failed.format(failed=failed.size, count=len(curve), reasons=reasons)
    return page.hanging(Text("  "), text, "bold red")


# --- data -------------------------------------------------------------------------------------


def curves_csv(curves: Sequence[LifeCurve]) -> str:
    """Return the points, one a line below a header that names the units (RFC 4180).

    SI units, hours and millions of revolutions; a decimal point, ten significant digits, an empty
    field for what does not exist, ``inf`` for a life without an end.
    """
    text = StringIO(newline="")
    writer = csv.writer(text)
    field = curves[0].over.field
    theories = list(dict.fromkeys(name for curve in curves for name in curve.theories))
    writer.writerow(
        [
            "variant",
            f"{field.name}_{field.unit}",
            "status",
            *(f"{name}_h" for name in theories),
            *(f"{name}_Mrev" for name in theories),
            *(f"{name}_holds" for name in theories),
            "headline_theory",
            "headline_h",
            "headline_Mrev",
            "headline_holds",
            "headline_below",
            "viscosity_ratio",
            "contamination_factor",
        ]
    )
    for curve in curves:
        records = [curve.theories.get(name) for name in theories]
        leading = curve.headline
        for point in range(len(curve)):
            writer.writerow(
                [
                    curve.label,
                    csv_number(curve.values[point]),
                    str(curve.status[point]),
                    *("" if own is None else _life_cell(own.hours[point]) for own in records),
                    *("" if own is None else _life_cell(own.life[point]) for own in records),
                    *(_yes_or_no(own is not None and own.valid[point]) for own in records),
                    str(leading.theory[point]),
                    _life_cell(leading.hours[point]),
                    _life_cell(leading.life[point]),
                    _yes_or_no(leading.valid[point]),
                    _yes_or_no(leading.below[point]),
                    csv_number(curve.viscosity_ratio[point]),
                    csv_number(curve.contamination_factor[point]),
                ]
            )
    return text.getvalue()


def _yes_or_no(value: bool) -> str:
    return "yes" if value else "no"


def _life_cell(value: float) -> str:
    return "inf" if isinf(value) else csv_number(value)


def curves_json(curves: Sequence[LifeCurve]) -> str:
    """Return everything as one JSON object in SI units, hours and millions of revolutions."""
    first = curves[0]
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "life_curve",
            "title": first.case.title,
            "field": first.field,
            "unit": first.over.field.unit,
            "values": first.values,
            "curves": [_curve_mapping(curve) for curve in curves],
        }
    )


def _curve_mapping(curve: LifeCurve) -> dict[str, Any]:
    theories = {
        name: {
            "hours": own.hours,
            "life": own.life,
            "endless": np.isinf(own.life).tolist(),
            "holds": own.valid.tolist(),
            "below": own.below.tolist(),
            "notes": {note: where.tolist() for note, where in own.notes.items() if np.any(where)},
        }
        for name, own in curve.theories.items()
    }
    leading = curve.headline
    return {
        "label": curve.label,
        "status": curve.status.tolist(),
        "headline": {
            "theory": leading.theory.tolist(),
            "hours": leading.hours,
            "life": leading.life,
            "holds": leading.valid.tolist(),
            "below": leading.below.tolist(),
            "reason": leading.reason.tolist(),
        },
        "theories": theories,
        "viscosity_ratio": curve.viscosity_ratio,
        "contamination_factor": curve.contamination_factor,
        "case": curve.case.to_mapping(),
    }
