"""What a study found, for a terminal or as plain text: how its cases ended, and their ranges."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.study_words import STUDY_WORDS, StudyWords
from rolamento.studies import OutputRange, Summary

__all__ = ["study_report"]


class _Shown(NamedTuple):
    """The unit in which people read a quantity, and how many of it make the SI unit."""

    unit: str
    scale: float


_SHOWN: Final = {
    "m": _Shown("µm", 1e6),
    "rad": _Shown("mrad", 1e3),
    "Pa": _Shown("MPa", 1e-6),
    "rad/s": _Shown("rpm", 30.0 / math.pi),
    "N/m": _Shown("N/µm", 1e-6),
    "N*m": _Shown("N·m", 1.0),
    "N*m/rad": _Shown("N·m/mrad", 1e-3),
    "N/rad": _Shown("N/mrad", 1e-3),
    "1": _Shown("", 1.0),
}
_DEGREES: Final = _Shown("deg", 180.0 / math.pi)
_ANGLES: Final = ("contact_angle", "azimuth", "attitude")


def study_report(
    summary: Summary, title: str = "", words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the report of a study as text that ends in a newline.

    Parameters
    ----------
    summary
        From `rolamento.studies.run_to_file`.
    title
        Of the study.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page, said = Page(words, medium or Medium()), STUDY_WORDS[words.code]
    head = page.hanging(Text(), title, "bold") if title else []
    parts: list[Lines] = [[*head, *_counts(page, said, summary)]]
    if summary.converged:
        parts.append(_ranges(page, said, summary.ranges))
    parts.append(page.hanging(Text(), said.written.format(path=summary.path)))
    return rendered(page.medium, parts)


def _counts(page: Page, said: StudyWords, summary: Summary) -> Lines:
    """Show how many cases there are, how fast they were solved, and how they ended."""
    number = page.digits.fixed
    first = said.cases.format(
        count=number(summary.cases, 0), seconds=page.digits.short(summary.seconds, 2)
    )
    if summary.solved > 0 and summary.seconds > 0.0:
        first += said.rate.format(rate=number(_rounded(summary.solved / summary.seconds), 0))
    if summary.solved < summary.cases:
        first += said.kept.format(count=number(summary.cases - summary.solved, 0))
    failed = summary.cases - summary.converged
    if not failed:
        mark = page.text(f"✓ {said.all_converged}", "green")
        return [*page.hanging(Text(), first), mark]
    ended = said.converged.format(count=number(summary.converged, 0), failed=number(failed, 0))
    lines = [*page.hanging(Text(), first), page.text(f"✗ {ended}", "yellow")]
    for status, count in sorted(summary.counts.items(), key=lambda item: -item[1]):
        if status in page.words.reasons:
            label = page.text(f"  {number(count, 0):>12}  ")
            lines += page.hanging(label, page.words.reasons[status])
    for message in summary.messages:
        lines += page.hanging(page.text(f"  {said.because}: ", "dim"), message)
    return lines


def _ranges(page: Page, said: StudyWords, ranges: tuple[OutputRange, ...]) -> Lines:
    """Show the range of each output in the units that people read."""
    heads = (said.output, said.least, said.median, said.greatest, "")
    rows = [[page.text(head, "dim") for head in heads]]
    for found in ranges:
        shown = _shown(found)
        values = [v * shown.scale for v in (found.minimum, found.median, found.maximum)]
        cells = page.digits.column(values, digits=5)
        rows.append([page.text(text) for text in (found.output.name, *cells, shown.unit)])
    lines = page.columns(rows, "lrrrl")
    every = max(found.every for found in ranges)
    if every > 1:
        lines += page.hanging(Text("  "), said.some.format(every=every), "dim")
    return lines


def _shown(found: OutputRange) -> _Shown:
    unit = found.output.unit
    if unit == "rad" and found.output.name.endswith(_ANGLES):
        return _DEGREES
    return _SHOWN.get(unit, _Shown(unit, 1.0))


def _rounded(value: float) -> float:
    """Two significant digits: a rate is not known better."""
    return float(f"{value:.2g}")
