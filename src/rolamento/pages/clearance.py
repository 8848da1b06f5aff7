"""The page of `clearance`: from before mounting to operation, step by step."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento.clearance.operating import PERCENTILES
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.pages.preload import stage_table
from rolamento.records import frozen
from rolamento.words import in_unit, manner, marked, said, said_in

if TYPE_CHECKING:
    from rolamento.clearance import ClearanceSamples, OperatingClearance
    from rolamento.tasks.clearance import Mounted

__all__ = ["STEPS", "ChainLine", "chain_lines", "clearance_page", "limit_heads"]

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
    "effective_interference": marked("interference in operation"),
    "pressure": marked("contact pressure"),
}
"""What goes into a fit."""


def clearance_page(
    found: Mounted, samples: ClearanceSamples | None = None, *, title: str = ""
) -> doc.Document:
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
    head = [doc.Section("", (doc.Title(title),), "head")] if title else []
    sections = [*head, *cautions_section(found.notes)]
    if found.stages:
        stages = stage_table(found.stages)
        sections.append(doc.Section(said("Preload"), (stages,), "preload"))
    for place, row in enumerate(found.rows):
        sections.append(_chain(row, place if len(found.rows) > 1 else None))
    sections.append(_sources(found.rows[0]))
    if samples is not None:
        sections.append(_scatter(samples))
    sections += notes_section(remarks_of(found.notes))
    return doc.Document(title or said("Diametral clearance"), tuple(sections), kind="clearance")


@frozen
class ChainLine:
    """A line of a chain of clearances: smallest, mean and largest; where it comes from."""

    label: str
    values: Sequence[float]
    path: str
    unit: str = "µm"
    tone: doc.Tone = ""
    source: str = ""


def limit_heads() -> dict[str, str]:
    """Return what the limits of a clearance are called."""
    return {
        "minimum": said_in("clearance", "minimum"),
        "mean": said_in("clearance", "mean"),
        "maximum": said_in("clearance", "maximum"),
    }


def chain_lines(found: OperatingClearance) -> Iterator[ChainLine]:
    """Yield the steps, what went into each fit, and the clearance in operation."""
    for place, step in enumerate(found.steps):
        path, name = f"clearance.steps.{place}", said(STEPS[step.name])
        yield ChainLine(name, step.change, f"{path}.change", source=step.source.text)
        for key, label in _DETAILS.items():
            values = step.details.get(key)
            if values is not None and (any(values) or key == "interference"):
                unit = "MPa" if key == "pressure" else "µm"
                yield ChainLine(f"  {said(label)}", values, f"{path}.details.{key}", unit, "faint")
    limits = (found.minimum, found.mean, found.maximum)
    yield ChainLine(said("in operation"), limits, "clearance", tone="strong")


def _chain(found: OperatingClearance, place: int | None = None) -> doc.Section:
    """The steps one below the other, what went into the fits beneath them, and their sum."""
    rows = list(chain_lines(found))
    tones = [row.tone for row in rows]
    columns = [
        doc.Column("", [_with_unit(row) for row in rows], "step", tones=tones),
        doc.Column(said("unit"), [row.unit for row in rows], "unit", only_in_files=True),
    ]
    for limit, (name, text) in enumerate(limit_heads().items()):
        numbers = [_number(row.values, limit, row.unit) for row in rows]
        columns.append(doc.Column(text, numbers, name, tones=tones))
    heading, key = said("Diametral clearance (µm)"), "clearance"
    if place is not None:
        heading = said("Diametral clearance (µm), row {number}", number=place)
        key = f"clearance_{place}"
    table = doc.Table(tuple(columns), key, gap=3)
    return doc.Section(heading, (table,), key)


def _with_unit(line: ChainLine) -> str:
    """Return the label of a line, with its unit where that is not the one of the heading."""
    return line.label if line.unit == "µm" else f"{line.label} ({line.unit})"


def _number(values: Sequence[float], place: int, unit: str) -> doc.CellContent:
    decimals = 2 if max(abs(float(in_unit(value, unit))) for value in values) < 1.0 else 1
    return doc.Number(values[place], f".{decimals}f [{unit}]")


def _sources(found: OperatingClearance) -> doc.Section:
    entries = tuple(
        doc.Entry(f"{said(STEPS[step.name])}:", f"{step.formula.text}; {step.source.text}", "faint")
        for step in found.steps
    )
    return doc.Section(said("Origin of the steps"), (doc.KeyValues(entries, 2),), "sources")


def _scatter(samples: ClearanceSamples) -> doc.Section:
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
    blocks = tuple(doc.Statement(text, indent=2) for text in texts)
    return doc.Section(heading, blocks, "samples")
