"""A record of what grew while bearings ran, for a reader, and as JSON."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import isfinite
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.clearance.wear import WearFit
from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, one_line, rendered, shortened, table
from rolamento.report.plain_data import json_text
from rolamento.units import to_si
from rolamento.weibull import Trend

if TYPE_CHECKING:
    from rolamento.tasks.weibull import TrendStudy

__all__ = ["trend_json", "trend_report"]

SCHEMA: Final = 1
_MOST_ROWS: Final = 60
_FIGURES: Final = 3
_REJECTED: Final = "×"


@dataclass(frozen=True, slots=True)
class _Words:
    untitled: str
    source: str
    bearing: str
    quantities: Mapping[str, str]
    rejected: str
    passed_over: str
    more: str
    law: str
    laws: Mapping[str, str]
    constants: Mapping[str, str]
    off: str
    legend: str
    beyond: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        untitled="Record",
        source="source",
        bearing="bearing",
        quantities={},
        rejected="× rejected",
        passed_over="Columns of the table that were passed over, as they have no unit: {columns}.",
        more="{count} measurements; the first {shown} are shown.",
        law="Law of wear: {law}",
        laws={
            "running_in": "P_0 + A (1 − e^(−t/τ))",
            "running_in_and_steady": "P_0 + A (1 − e^(−t/τ)) + w t",
            "power": "P_0 + A (t/t_last)^n",
        },
        constants={
            "initial_clearance": "P_0 {length}",
            "running_in_wear": "A {length}",
            "wear_at_last": "A {length}",
            "running_in_time": "τ {time}",
            "wear_rate": "w {length}/1000 {time}",
            "exponent": "n",
        },
        off="points off {length}",
        legend="± standard error, from the curvature at the best fit; without it, the measurements"
        " do not tell.",
        beyond="A law describes what was measured. Beyond the last measurement, and of another"
        " bearing, it tells nothing.",
    ),
    "pt": _Words(
        untitled="Registro",
        source="fonte",
        bearing="rolamento",
        quantities={"radial clearance": "folga radial"},
        rejected="× reprovado",
        passed_over="Colunas da tabela que não foram lidas, pois não têm unidade: {columns}.",
        more="{count} medições; são mostradas as primeiras {shown}.",
        law="Lei de desgaste: {law}",
        laws={
            "running_in": "P_0 + A (1 − e^(−t/τ))",
            "running_in_and_steady": "P_0 + A (1 − e^(−t/τ)) + w t",
            "power": "P_0 + A (t/t_final)^n",
        },
        constants={
            "initial_clearance": "P_0 {length}",
            "running_in_wear": "A {length}",
            "wear_at_last": "A {length}",
            "running_in_time": "τ {time}",
            "wear_rate": "w {length}/1000 {time}",
            "exponent": "n",
        },
        off="pontos distam {length}",
        legend="± erro padrão, da curvatura no melhor ajuste; sem ele, as medições não o dizem.",
        beyond="Uma lei descreve o que foi medido. Além da última medição, e de outro rolamento,"
        " ela não diz nada.",
    ),
}


def trend_json(found: TrendStudy) -> str:
    """Return a record and its fits as one JSON object; the fits in SI units."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "trend",
            **found.trend.to_mapping(),
            "wear": {name: asdict(fit) for name, fit in found.fits.items()},
        }
    )


def trend_report(found: TrendStudy, words: Words = ENGLISH, medium: Medium | None = None) -> str:
    """Return the page of a record as text that ends in a newline.

    Parameters
    ----------
    found
        Of `rolamento.tasks.weibull.trend_study`.
    words, medium
        The language, and what the text is shown on; by default plain text of 80 columns.
    """
    page, said = Page(words, medium or Medium()), _WORDS[words.code]
    trend = found.trend
    head = page.hanging(Text(), one_line(trend.title) or said.untitled, "bold")
    head.append(page.rule(page.medium.width))
    head += page.hanging(page.text(f"{said.source}  ", "dim"), one_line(trend.source))
    parts = [head, _measurements(page, said, trend)]
    if trend.passed_over:
        columns = ", ".join(shortened(one_line(name), 30) for name in trend.passed_over)
        parts.append(page.hanging(Text("  "), said.passed_over.format(columns=columns), "dim"))
    if found.fits:
        parts.append(_laws_of_wear(page, said, trend, found.fits))
    return rendered(page.medium, parts)


def _measurements(page: Page, said: _Words, trend: Trend) -> Lines:
    """One line a measurement."""
    places = {name: place for place, name in enumerate(trend.names)}
    order = sorted(
        range(len(trend.times)),
        key=lambda row: (places[str(trend.bearings[row])], float(trend.times[row])),
    )
    shown = order[:_MOST_ROWS]
    heads = [said.bearing, trend.time_unit]
    heads += [
        f"{shortened(said.quantities.get(name, name))} {unit}"
        for name, unit in zip(trend.quantities, trend.units, strict=True)
    ]
    columns = [
        _column_of(page, trend, shown, quantity) for quantity in range(len(trend.quantities))
    ]
    rows = [
        [
            ""
            if place and trend.bearings[row] == trend.bearings[shown[place - 1]]
            else str(trend.bearings[row]),
            page.digits.short(float(trend.times[row]), 6),
            *(column[place] for column in columns),
        ]
        for place, row in enumerate(shown)
    ]
    lines = table(page, heads, rows)
    if trend.rejected.any():
        lines += page.hanging(Text("  "), said.rejected, "dim")
    if len(order) > len(shown):
        more = said.more.format(count=page.digits.fixed(len(order), 0), shown=_MOST_ROWS)
        lines += page.hanging(Text("  "), more, "dim")
    return lines


def _column_of(page: Page, trend: Trend, rows: Sequence[int], quantity: int) -> list[str]:
    values = [float(trend.values[row, quantity]) for row in rows]
    cells = [page.digits.short(value, 5) for value in values]
    return [
        _REJECTED if trend.rejected[row, quantity] else cell
        for row, cell in zip(rows, cells, strict=True)
    ]


def _laws_of_wear(page: Page, said: _Words, trend: Trend, fits: Mapping[str, WearFit]) -> Lines:
    """One line a bearing: the constants of its law, with their errors."""
    length, time = trend.units[0], trend.time_unit
    metre, second = to_si(f"1 {length}", "length"), to_si(f"1 {time}", "time")
    scales = {
        "initial_clearance": metre,
        "running_in_wear": metre,
        "wear_at_last": metre,
        "running_in_time": second,
        "wear_rate": metre / (1000.0 * second),
        "exponent": 1.0,
    }
    first = next(iter(fits.values()))
    heads = [said.bearing]
    heads += [said.constants[name].format(length=length, time=time) for name in first.constants]
    heads.append(said.off.format(length=length))
    rows = []
    for bearing, fit in fits.items():
        cells = [shortened(one_line(bearing))]
        for name, value in fit.constants.items():
            error = fit.standard_errors[name] / scales[name]
            shown = page.digits.short(value / scales[name], _FIGURES)
            told = f" ± {page.digits.short(error, 2)}" if isfinite(error) else ""
            cells.append(shown + told)
        rows.append([*cells, page.digits.short(fit.residual / metre, 2)])
    return [
        page.heading(said.law.format(law=said.laws[first.law])),
        *table(page, heads, rows),
        *page.hanging(Text("  "), said.legend, "dim"),
        *page.hanging(Text("  "), said.beyond, "dim"),
    ]
