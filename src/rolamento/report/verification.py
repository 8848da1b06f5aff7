"""The published numbers beside the computed ones, for a terminal or as plain text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from math import floor, isfinite, log10
from typing import Final, NamedTuple

from rich.text import Text

from rolamento.report.language import ENGLISH, Words
from rolamento.report.medium import Medium
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.verification_words import VERIFICATION_WORDS, VerificationWords
from rolamento.verification import VERDICTS, Check, Verdict, Verification

__all__ = ["Cells", "Notes", "cells", "summary", "tables", "verification_report"]

_STYLES: Final = {"agrees": "green", "explained": "yellow", "fails": "bold red"}
_MINUS: Final = "−"
_MARKS: Final = {"agrees": "✓", "fails": "✗"}


class Cells(NamedTuple):
    """The numbers of a check as text, each with one digit more than the print."""

    printed: str
    computed: str
    difference: str
    tolerance: str
    proof: str


class Notes:
    """The explanations below a table, each of them once and numbered."""

    def __init__(self, checks: Iterable[Check]) -> None:
        self.texts = list(dict.fromkeys(c.explanation for c in checks if c.explanation))

    def mark(self, check: Check) -> str:
        """Return the mark of a check's explanation, such as ``"[1]"``, or nothing."""
        return f"[{self.texts.index(check.explanation) + 1}]" if check.explanation else ""


def verification_report(
    verification: Verification, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the report of a verification as text that ends in a newline.

    Parameters
    ----------
    verification
        From `rolamento.verification.run`.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = VERIFICATION_WORDS[words.code]
    parts: list[Lines] = []
    for result in verification.results:
        head = [*page.hanging(Text(), result.title, "bold"), page.rule(page.medium.width)]
        for number, (source, checks) in enumerate(tables(result.checks)):
            part = [page.heading(said.term(source)), *_table(page, said, checks)]
            parts.append(part if number else [*head, *part])
    style = _STYLES["agrees" if verification.passed else "fails"]
    mark = _MARKS["agrees" if verification.passed else "fails"]
    parts.append(page.hanging(Text(), said.proof_note, "dim"))
    parts.append([page.text(f"{mark} {summary(verification, said)}", style)])
    return rendered(page.medium, parts)


def summary(verification: Verification, words: VerificationWords) -> str:
    """Return how many numbers there are, and how many of each verdict."""
    counts = {verdict: verification.count(verdict) for verdict in VERDICTS}
    return words.summary.format(count=len(verification.checks), **counts)


def tables(checks: Sequence[Check]) -> Iterator[tuple[str, list[Check]]]:
    """Group checks that follow each other by their citation."""
    for source, group in groupby(checks, lambda check: check.source):
        yield source, list(group)


def cells(check: Check, mark: str = ".") -> Cells:
    """Write the numbers of a check, with a decimal mark."""
    mantissa, _, exponent = check.printed.partition("e")
    power = int(exponent or 0)
    decimals = len(mantissa.partition(".")[2]) + 1
    tail = f"e{exponent}" if exponent else ""

    def like_print(value: float) -> str:
        return _fixed(value / 10.0**power, decimals) + (tail if isfinite(value) else "")

    plain = max(decimals - power, 0)
    proof = check.corrected
    if not proof and check.evidence is not None:
        proof = like_print(check.evidence)
    texts = (
        check.printed.replace("-", _MINUS),
        like_print(check.computed),
        _fixed(check.difference, plain, sign=True),
        _tolerance(check.tolerance),
        proof,
    )
    return Cells(*(text.replace(".", mark) for text in texts))


def _fixed(value: float, decimals: int, *, sign: bool = False) -> str:
    if not isfinite(value):
        return ABSENT
    text = f"{value:{'+' if sign else ''}.{decimals}f}"
    if not any(digit in "123456789" for digit in text):
        text = text.lstrip("+-")
    return text.replace("-", _MINUS)


def _tolerance(value: float) -> str:
    """Write a tolerance with two significant digits at most, never as a power of ten."""
    if value == 0.0:
        return "0"
    decimals = max(1 - floor(log10(value)), 0)
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def _table(page: Page, words: VerificationWords, checks: list[Check]) -> Lines:
    """Set one table with its notes; the column of proofs only where there is one."""
    notes, mark = Notes(checks), words.decimal_mark
    heads = [words.printed, words.computed, words.difference, words.tolerance, words.proof]
    rows = [list(cells(check, mark)) for check in checks]
    if not any(row[-1] for row in rows):
        heads, rows = heads[:-1], [row[:-1] for row in rows]
    lines = [[page.text(head, "dim") for head in (words.quantity, *heads, words.verdict)]]
    lines += [
        [
            page.text(_name(check, words)),
            *(page.text(cell, _style(column, check.verdict)) for column, cell in enumerate(row)),
            page.text(_verdict(check, words, notes), _STYLES[check.verdict]),
        ]
        for check, row in zip(checks, rows, strict=True)
    ]
    body = _set(page, lines, "l" + "r" * len(heads) + "l")
    for number, text in enumerate(notes.texts, start=1):
        body += page.hanging(page.text(f"  [{number}] ", "dim"), words.sentence(text), "dim")
    return body


def _name(check: Check, words: VerificationWords) -> str:
    """Return the quantity with its unit."""
    unit = f" [{words.term(check.unit)}]" if check.unit else ""
    return (words.term(check.quantity) + unit).replace(".", words.decimal_mark)


def _verdict(check: Check, words: VerificationWords, notes: Notes) -> str:
    return f"{words.verdicts[check.verdict]} {notes.mark(check)}".rstrip()


def _set(page: Page, lines: list[list[Text]], justify: str) -> Lines:
    """Set the columns; closer to each other, and to the margin, where there is no room."""
    for gap in (2, 1):
        body = page.columns(lines, justify, gap)
        if max(len(line.plain.rstrip()) for line in body) <= page.medium.width:
            return body
    return [line[2:] for line in body]


def _style(column: int, verdict: Verdict) -> str:
    """Return the style of a cell: computed numbers stand out, wrong ones more so."""
    if column != Cells._fields.index("computed"):
        return ""
    return _STYLES[verdict] if verdict == "fails" else "bold"
