"""The page of a study that was run to a file: how its cases ended, and the ranges of outputs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento import document as doc
from rolamento.charts.axes_units import ANGLES
from rolamento.words import counted, decimals_for, in_unit, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from rolamento.studies import OutputRange, Summary
    from rolamento.studies.subject import Subject
    from rolamento.studies.tables import CaseColumn

__all__ = ["cases_table", "in_row", "study_page"]

_SHOWN: Final = {
    "m": "µm",
    "rad": "mrad",
    "Pa": "MPa",
    "rad/s": "rpm",
    "N/m": "N/µm",
    "N*m": "N·m",
    "N*m/rad": "N·m/mrad",
    "F": "pF",
    "A/m^2": "A/mm²",
    "V/m": "V/µm",
    "N/rad": "N/mrad",
    "N": "N",
    "W": "W",
    "s": "s",
    "m/s": "m/s",
    "1": "",
}
"""The unit in which people read a quantity; others are shown in SI."""
_GIVEN: Final = {**_SHOWN, "m": "mm", "K": "°C"}
"""That in which they give one."""
_LIVES: Final = {"h": ("h", 3600.0), "Mrev": ("10⁶ rev", 1e6)}
"""Outputs that are not in SI units: what people read them in, and what one is in SI."""


def study_page(summary: Summary, title: str = "") -> doc.Document:
    """Return the page of a study that was run.

    Parameters
    ----------
    summary
        From `rolamento.studies.run_to_file`.
    title
        Of the study.
    """
    blocks: list[doc.Block] = [doc.Statement(title, "strong")] if title else []
    sections = [doc.Section(blocks=(*blocks, *_counts(summary)), key="head")]
    if summary.converged:
        blocks = [_ranges(summary.ranges), *_cautions(summary)]
        sections.append(doc.Section(blocks=tuple(blocks), key="ranges"))
    written = said("Written to {path}.", path=str(summary.path))
    sections.append(doc.Section(blocks=(doc.Statement(written),)))
    if summary.columns:
        sections.append(doc.Section(blocks=(cases_table(summary.columns),)))
    return doc.Document(title or said("Study"), tuple(sections), "sweep", main="cases")


def cases_table(columns: Sequence[CaseColumn]) -> doc.Table:
    """Return the cases of a study, a line each, in the units that people read; for files only."""
    return doc.Table(
        tuple(
            doc.Column(one.name, _in_si(one).tolist(), one.name, _unit_in_files(one))
            for one in columns
        ),
        "cases",
        only_in_files=True,
    )


def _in_si(column: CaseColumn) -> NDArray[Any]:
    """The values of a column as tables take them: lives, too, in SI units."""
    if column.unit not in _LIVES:
        return column.values
    return np.asarray(column.values * _LIVES[column.unit][1])


def _unit_in_files(column: CaseColumn) -> str:
    """The unit of a column: lengths that are given in mm, those that come out in µm."""
    if column.unit in _LIVES:
        return _LIVES[column.unit][0]
    if column.unit == "rad" and re.sub(r"_\d+$", "", column.name).endswith(ANGLES):
        return "°"
    shown = _GIVEN if column.given else _SHOWN
    return shown.get(column.unit, column.unit.replace("*", "·"))


def _counts(summary: Summary) -> list[doc.Block]:
    """Show how many cases there are, how fast they were solved, and how they ended."""
    first = counted(
        "{n} case in {seconds:.2} s", "{n} cases in {seconds:.2} s", summary.cases,
        seconds=summary.seconds,
    )  # fmt: skip
    if summary.solved > 0 and summary.seconds > 0.0:
        first += said(", {rate:.0f} cases/s", rate=_rounded(summary.solved / summary.seconds))
    blocks: list[doc.Block] = [doc.Statement(first)]
    if summary.solved < summary.cases:
        kept = said("{count} of them from an earlier run", count=summary.cases - summary.solved)
        blocks.append(doc.Statement(kept))
    failed = summary.cases - summary.converged
    if not failed:
        return [*blocks, doc.Statement(said("all cases have a result"), "good", mark="✓")]
    ended = said(
        "cases with a result: {count}; without: {failed}", count=summary.converged, failed=failed
    )
    blocks.append(doc.Statement(ended, "warning", mark="✗"))
    reasons = {
        reason(status): count
        for status, count in sorted(summary.counts.items(), key=lambda item: -item[1])
        if count and reason(status) != status
    }
    if reasons:
        columns = (
            doc.Column(said("cases"), list(reasons.values()), "cases"),
            doc.Column(said("reason"), list(reasons), "reason"),
        )
        blocks.append(doc.Table(columns, "failures", headless=True, indent=4))
    for status, one in summary.first.items():
        text = said(
            "{reason}, first in case {number}: {why}",
            reason=reason(status),
            number=one.case + 1,
            why=one.reason.text,
        )
        blocks.append(doc.Statement(text, indent=2))
    return blocks


def _ranges(ranges: tuple[OutputRange, ...]) -> doc.Table:
    """Show the range of each output in the units that people read."""
    units = [_unit(found) for found in ranges]
    rows = [
        in_row([found.minimum, found.median, found.maximum], unit)
        for found, unit in zip(ranges, units, strict=True)
    ]
    heads = {"minimum": said("minimum"), "median": said("median"), "maximum": said("maximum")}
    shown = [
        unit or ("" if found.output.unit == "1" else found.output.unit)
        for found, unit in zip(ranges, units, strict=True)
    ]
    columns = (
        doc.Column(said("output"), [found.output.name for found in ranges], "output"),
        *(
            doc.Column(head, values, key, align="right")
            for (key, head), values in zip(heads.items(), zip(*rows, strict=True), strict=True)
        ),
        doc.Column("", shown, "unit", align="left"),
    )
    every = max(found.every for found in ranges)
    legend = said("The medians are those of one case in {every}.", every=every)
    return doc.Table(columns, "ranges", legends=(legend,) if every > 1 else ())


def _cautions(summary: Summary) -> Iterator[doc.Notes]:
    """Show what qualifies the cases at the ends of the ranges."""
    remarks = tuple(
        doc.Remark(
            said(
                "{note} ({count} of {ends} cases at the ends of the ranges)",
                note=note.text,
                count=count,
                ends=summary.ends,
            ),
            note.key,
            "warning",
        )
        for note, count in summary.cautions
    )
    if remarks:
        yield doc.Notes(remarks)


def _unit(found: OutputRange) -> str:
    unit = found.output.unit
    if unit == "rad" and found.output.name.endswith(ANGLES):
        return "°"
    return _SHOWN.get(unit, "")


def in_row(values: Sequence[float], unit: str = "") -> list[doc.CellContent]:
    """Return the SI numbers of a row, with the same decimals, in a unit that stands elsewhere."""
    decimals = decimals_for([float(in_unit(value, unit)) for value in values], 5)
    form = f".{decimals}f" + (f" [{unit}]" if unit else "")
    return [doc.Number(float(value), form) for value in values]


def _rounded(value: float) -> float:
    """Two significant digits: a rate is not known better."""
    return float(f"{value:.2g}")


# --- what a study may vary and give --------------------------------------------------------------


def fields_text(subject: Subject | None = None) -> str:
    """Return the fields, one a line: name, SI unit, an example, and whether it can be scattered.

    Parameters
    ----------
    subject
        Whose fields; those of any case if not given.
    """
    from rolamento.studies.fields import known_fields
    from rolamento.studies.solving import array_fields

    fields = known_fields() if subject is None else subject.fields()
    rows = []
    for name, field in fields.items():
        in_batch = name in array_fields() if subject is None else subject.varies_in_batch(name)
        both = field.continuous and in_batch
        kinds = said("axes, scatter") if both else said("axes")
        rows.append((name, field.unit, field.example, kinds))
    return _columns([(said("field"), said("unit"), said("example"), said("for")), *rows])


def outputs_text(subject: Subject | None = None) -> str:
    """Return the outputs, one a line: name, SI unit, whether it is one of several, meaning.

    Parameters
    ----------
    subject
        Whose outputs; those of any case if not given.
    """
    from rolamento.studies.outputs import DEFAULT_OUTPUTS, catalogue

    known = catalogue() if subject is None else subject.catalogue()
    usual = DEFAULT_OUTPUTS if subject is None else subject.default_outputs()
    along = {
        "": "",
        "ball": said("per ball"),
        "row": said("per row"),
        "bearing": said("per bearing"),
        "shaft": said("per shaft"),
    }
    rows = [
        (
            f"{name}{'*' if name in usual else ''}",
            output.unit,
            along[output.along],
            output.label,
        )
        for name, output in known.items()
    ]
    foot = f"\n* {said('by default, if a study names no outputs')}\n"
    return _columns([(said("output"), said("unit"), "", said("meaning")), *rows]) + foot


def _columns(rows: list[tuple[str, ...]]) -> str:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ("  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)) for row in rows)
    return "".join(f"{line.rstrip()}\n" for line in lines)
