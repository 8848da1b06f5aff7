"""The page of `clearance`: from before mounting to operation, step by step."""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan
from typing import TYPE_CHECKING, Final

from rolamento.clearance.operating import PERCENTILES
from rolamento.document import (
    CellContent,
    Column,
    Document,
    Entry,
    KeyValues,
    Number,
    Section,
    Statement,
    Table,
    Title,
    Tone,
)
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.pages.preload import stage_table
from rolamento.words import in_unit, manner, marked, said, said_in

if TYPE_CHECKING:
    from rolamento.clearance import ClearanceSamples, OperatingClearance
    from rolamento.tasks.clearance import Mounted

__all__ = ["STEPS", "clearance_page"]

STEPS: Final = {
    "initial": marked("before mounting"),
    "measuring_load": marked("measuring load"),
    "shaft_fit": marked("fit on the shaft"),
    "housing_fit": marked("fit in the housing"),
    "temperature": marked("temperature"),
    "speed": marked("centrifugal expansion"),
    "wear": marked("wear"),
}
_DETAILS: Final = {
    "interference": marked("interference as mounted"),
    "smoothing": marked("loss by smoothing"),
    "expansion": marked("gain by thermal expansion"),
    "rotation": marked("loss by rotation"),
    "effective_interference": marked("effective in operation"),
    "pressure": marked("pressure (MPa)"),
}


def clearance_page(
    found: Mounted, samples: ClearanceSamples | None = None, *, title: str = ""
) -> Document:
    """Return the chain of clearances, and what becomes of the preload of a set.

    Parameters
    ----------
    found
        What `mounted_clearance` gives.
    samples
        Its scatter, if it was drawn.
    title
        Of the case.
    """
    head = [Section("", (Title(title),), "head")] if title else []
    sections = [*head, *cautions_section(found.notes)]
    if found.stages:
        stages = stage_table(found.stages)
        sections.append(Section(said("Preload"), (stages,), "preload"))
    for place, row in enumerate(found.rows):
        sections.append(_chain(row, place if len(found.rows) > 1 else None))
    sections.append(_sources(found.rows[0]))
    if samples is not None:
        sections.append(_scatter(samples))
    sections += notes_section(remarks_of(found.notes))
    return Document(title or said("Diametral clearance"), tuple(sections), kind="clearance")


def _chain(found: OperatingClearance, place: int | None = None) -> Section:
    """The steps one below the other, what went into the fits beneath them, and their sum."""
    rows: list[tuple[str, Sequence[float], str, Tone]] = []
    for step in found.steps:
        rows.append((said(STEPS[step.name]), step.change, "µm", ""))
        rows += [
            (f"  {said(label)}", step.details[name], "MPa" if name == "pressure" else "µm", "faint")
            for name, label in _DETAILS.items()
            if name in step.details and (any(step.details[name]) or name == "interference")
        ]
    limits = (found.minimum, found.mean, found.maximum)
    rows.append((said("in operation"), limits, "µm", "strong"))
    tones = [tone for _, _, _, tone in rows]
    columns = [
        Column("", [label for label, _, _, _ in rows], "step", tones=tones),
        Column(said("unit"), [unit for _, _, unit, _ in rows], "unit", only_in_files=True),
    ]
    heads = {
        "minimum": said_in("clearance", "minimum"),
        "mean": said_in("clearance", "mean"),
        "maximum": said_in("clearance", "maximum"),
    }
    columns += [
        Column(
            text,
            [_number(values, place, unit) for _, values, unit, _ in rows],
            key,
            align="right",
            tones=tones,
        )
        for place, (key, text) in enumerate(heads.items())
    ]
    heading, key = said("Diametral clearance (µm)"), "clearance"
    if place is not None:
        heading = said("Diametral clearance (µm), row {number}", number=place)
        key = f"clearance_{place}"
    table = Table(tuple(columns), key, gap=3)
    return Section(heading, (table,), key)


def _number(values: Sequence[float], place: int, unit: str) -> CellContent:
    decimals = 2 if max(abs(float(in_unit(value, unit))) for value in values) < 1.0 else 1
    return Number(values[place], f".{decimals}f [{unit}]")


def _sources(found: OperatingClearance) -> Section:
    entries = tuple(
        Entry(f"{said(STEPS[step.name])}:", f"{step.formula.text}; {step.source.text}", "faint")
        for step in found.steps
    )
    return Section(said("Origin of the steps"), (KeyValues(entries, 2),), "sources")


def _scatter(samples: ClearanceSamples) -> Section:
    percentiles = ", ".join(
        said("{percent:.5} %: {clearance:.1f µm}", percent=p, clearance=clearance)
        for p in PERCENTILES
        if not isnan(clearance := samples.percentile(p))  # beyond so few samples
    )
    texts = (
        said(
            "mean {mean:.1f µm}, standard deviation {deviation:.1f µm}",
            mean=samples.mean,
            deviation=samples.standard_deviation,
        ),
        percentiles,
        said("{share:.3 %} have a negative clearance", share=samples.preloaded),
    )
    heading = said(
        "{count} bearings sampled from their tolerances",
        count=manner().fixed(len(samples.clearance), 0),
    )
    blocks = tuple(Statement(text, indent=2) for text in texts)
    return Section(heading, blocks, "samples")
