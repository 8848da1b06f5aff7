"""The clearance in operation, step by step, for a reader; JSON in SI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from rich.text import Text

from rolamento._json import dumps
from rolamento.clearance import ClearanceSamples, OperatingClearance, Step
from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.units import MICROMETRE

SCHEMA: Final = 2
PERCENTILES: Final = (0.135, 5.0, 50.0, 95.0, 99.865)

_MEGAPASCAL: Final = 1e6


@dataclass(frozen=True, slots=True)
class _ClearanceWords:
    heading: str
    columns: tuple[str, str, str]
    steps: Mapping[str, str]
    result: str
    details: Mapping[str, str]
    sources: str
    samples: str
    moments: str
    preloaded: str
    notes: str


_WORDS: Final[Mapping[str, _ClearanceWords]] = {
    "en": _ClearanceWords(
        heading="Diametral clearance (µm)",
        columns=("minimum", "mean", "maximum"),
        steps={
            "initial": "before mounting",
            "measuring_load": "measuring load",
            "shaft_fit": "fit on the shaft",
            "housing_fit": "fit in the housing",
            "temperature": "temperature",
            "speed": "speed",
            "wear": "wear",
        },
        result="in operation",
        details={
            "interference": "interference as mounted",
            "smoothing": "less smoothing",
            "expansion": "more by expansion",
            "rotation": "less by rotation",
            "effective_interference": "left in operation",
            "pressure": "pressure (MPa)",
        },
        sources="Where the steps come from",
        samples="{count} bearings drawn from their tolerances",
        moments="mean {mean} µm, standard deviation {deviation} µm",
        preloaded="{share} % have a negative clearance",
        notes="Notes",
    ),
    "pt": _ClearanceWords(
        heading="Folga diametral (µm)",
        columns=("mínima", "média", "máxima"),
        steps={
            "initial": "antes da montagem",
            "measuring_load": "carga de medição",
            "shaft_fit": "ajuste no eixo",
            "housing_fit": "ajuste no alojamento",
            "temperature": "temperatura",
            "speed": "rotação",
            "wear": "desgaste",
        },
        result="em operação",
        details={
            "interference": "interferência na montagem",
            "smoothing": "menos alisamento",
            "expansion": "mais por dilatação",
            "rotation": "menos por rotação",
            "effective_interference": "resta em operação",
            "pressure": "pressão (MPa)",
        },
        sources="De onde vêm os passos",
        samples="{count} rolamentos sorteados das suas tolerâncias",
        moments="média {mean} µm, desvio-padrão {deviation} µm",
        preloaded="{share} % têm folga negativa",
        notes="Observações",
    ),
}


def clearance_report(
    found: OperatingClearance,
    samples: ClearanceSamples | None = None,
    words: Words = ENGLISH,
    medium: Medium | None = None,
) -> str:
    """Return the chain of clearances as text that ends in a newline.

    Parameters
    ----------
    found
        What `operating_clearance` gives.
    samples
        Its scatter, if it was drawn.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = _WORDS[words.code]
    parts = [_chain_of_steps(page, said, found), _sources(page, said, found)]
    if samples is not None:
        parts.append(_scatter(page, said, samples))
    if found.warnings:
        parts.append(_warnings(page, said, found))
    return rendered(page.medium, parts)


def clearance_json(
    found: OperatingClearance, samples: ClearanceSamples | None = None, *, indent: int | None = 2
) -> str:
    """Return everything as one JSON object, in SI units."""
    whole = {"schema": SCHEMA, **found.to_mapping()}
    if samples is not None:
        whole["samples"] = {
            "count": len(samples.clearance),
            "mean": samples.mean,
            "standard_deviation": samples.standard_deviation,
            "percentiles": {f"{p:g}": samples.percentile(p) for p in PERCENTILES},
            "preloaded": samples.preloaded,
        }
    return dumps(whole, indent)


def _chain_of_steps(page: Page, said: _ClearanceWords, found: OperatingClearance) -> Lines:
    """The steps one below the other, what went into the fits beneath them, and their sum."""
    rows = [_styled_cells(page, "", said.columns, "dim")]
    for step in found.steps:
        rows.append(_row_of_limits(page, said.steps[step.name], step.change, MICROMETRE))
        rows += _fit_details(page, said, step)
    limits = (found.minimum, found.mean, found.maximum)
    rows.append(_row_of_limits(page, said.result, limits, MICROMETRE, "bold"))
    return [page.heading(said.heading), *page.columns(rows, "lrrr", gap=3)]


def _fit_details(page: Page, said: _ClearanceWords, step: Step) -> list[list[Text]]:
    rows = []
    for name, values in step.details.items():
        if name in said.details and (any(values) or name == "interference"):
            unit = _MEGAPASCAL if name == "pressure" else MICROMETRE
            rows.append(_row_of_limits(page, f"  {said.details[name]}", values, unit, "dim"))
    return rows


def _row_of_limits(
    page: Page, label: str, values: Sequence[float], unit: float, style: str = ""
) -> list[Text]:
    decimals = 2 if max(map(abs, values)) / unit < 1.0 else 1
    cells = [page.digits.fixed(value / unit, decimals) for value in values]
    return _styled_cells(page, label, cells, style)


def _styled_cells(page: Page, label: str, cells: Sequence[str], style: str) -> list[Text]:
    return [page.text(cell, style) for cell in (label, *cells)]


def _sources(page: Page, said: _ClearanceWords, found: OperatingClearance) -> Lines:
    lines = [page.heading(said.sources)]
    for step in found.steps:
        label = page.text(f"  {said.steps[step.name]}: ")
        formula, source = page.words.note(step.formula), page.words.note(step.source)
        lines += page.hanging(label, f"{formula}; {source}", "dim")
    return lines


def _scatter(page: Page, said: _ClearanceWords, samples: ClearanceSamples) -> Lines:
    def micrometres(value: float) -> str:
        return page.digits.fixed(value / MICROMETRE, 1)

    count = page.digits.fixed(len(samples.clearance), 0)
    percentiles = ", ".join(
        f"{page.digits.short(percent)} %: {micrometres(samples.percentile(percent))} µm"
        for percent in PERCENTILES
    )
    sentences = (
        said.moments.format(
            mean=micrometres(samples.mean), deviation=micrometres(samples.standard_deviation)
        ),
        percentiles,
        said.preloaded.format(share=page.digits.short(100.0 * samples.preloaded, 3)),
    )
    lines = [page.heading(said.samples.format(count=count))]
    for sentence in sentences:
        lines += page.hanging(Text("  "), sentence)
    return lines


def _warnings(page: Page, said: _ClearanceWords, found: OperatingClearance) -> Lines:
    lines = [page.heading(said.notes)]
    for note in found.warnings:
        lines += page.hanging(page.text("  • "), page.words.note(note))
    return lines
