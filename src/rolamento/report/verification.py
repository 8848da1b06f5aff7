"""The published numbers beside the computed ones: for a terminal, as plain text, as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from math import floor, isfinite, log10
from typing import Final, NamedTuple

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.verification_words import VERIFICATION_WORDS, VerificationWords
from rolamento.verification import VERDICTS, Check, CheckVerdict, SourceResult, Verification

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
            part = [page.heading(said.term(source)), *_terminal_table(page, said, checks)]
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


def _terminal_table(page: Page, words: VerificationWords, checks: list[Check]) -> Lines:
    """Set one table with its notes; the column of proofs only where there is one."""
    notes, mark = Notes(checks), words.decimal_mark
    heads = [words.printed, words.computed, words.difference, words.tolerance, words.proof]
    rows = [list(cells(check, mark)) for check in checks]
    if not any(row[-1] for row in rows):
        heads, rows = heads[:-1], [row[:-1] for row in rows]
    lines = [[page.text(head, "dim") for head in (words.quantity, *heads, words.verdict)]]
    lines += [
        [
            page.text(_quantity_with_unit(check, words)),
            *(
                page.text(cell, _cell_style(column, check.verdict))
                for column, cell in enumerate(row)
            ),
            page.text(_marked_verdict(check, words, notes), _STYLES[check.verdict]),
        ]
        for check, row in zip(checks, rows, strict=True)
    ]
    body = _columns_that_fit(page, lines, "l" + "r" * len(heads) + "l")
    for number, text in enumerate(notes.texts, start=1):
        body += page.hanging(page.text(f"  [{number}] ", "dim"), words.sentence(text), "dim")
    return body


def _quantity_with_unit(check: Check, words: VerificationWords) -> str:
    """Return the quantity with its unit."""
    unit = f" [{words.term(check.unit)}]" if check.unit else ""
    return (words.term(check.quantity) + unit).replace(".", words.decimal_mark)


def _marked_verdict(check: Check, words: VerificationWords, notes: Notes) -> str:
    return f"{words.verdicts[check.verdict]} {notes.mark(check)}".rstrip()


def _columns_that_fit(page: Page, lines: list[list[Text]], justify: str) -> Lines:
    """Set the columns; closer to each other, and to the margin, where there is no room."""
    for gap in (2, 1):
        body = page.columns(lines, justify, gap)
        if max(len(line.plain.rstrip()) for line in body) <= page.medium.width:
            return body
    return [line[2:] for line in body]


def _cell_style(column: int, verdict: CheckVerdict) -> str:
    """Return the style of a cell: computed numbers stand out, wrong ones more so."""
    if column != Cells._fields.index("computed"):
        return ""
    return _STYLES[verdict] if verdict == "fails" else "bold"


COMMAND: Final = "rolamento verify --markdown docs/verification.md"
"""What writes the page."""

_INTRODUCTION: Final = """\
# Verification

Published numbers beside those that this program gives. This page is written by

    {command}

and `rolamento verify` prints the same in a terminal, with exit code 1 if a number fails.

*Printed* is the published number with its digits; *computed* is what the program gives by its own
models, with one digit more; the *tolerance* is half a unit of the last printed digit, unless a
note says otherwise. A number **agrees** if the difference is within the tolerance, is **explained**
if it is not and the explanation has been put to the proof, and **fails** otherwise.

{proof}

**{summary}.**
"""


def verification_page(verification: Verification) -> str:
    """Return the page as Markdown text; numbers in so few digits that any machine writes the same.

    Parameters
    ----------
    verification
        From `rolamento.verification.run`.
    """
    head = _INTRODUCTION.format(
        command=COMMAND,
        proof=VERIFICATION_WORDS["en"].proof_note,
        summary=summary(verification, VERIFICATION_WORDS["en"]),
    )
    sections = ("\n".join(_markdown_section(result)) for result in verification.results)
    return "\n".join([head, *sections])


def _markdown_section(result: SourceResult) -> Iterator[str]:
    yield f"## {_escaped_markdown(result.title)}\n"
    for source, checks in tables(result.checks):
        yield f"### {_escaped_markdown(source)}\n"
        yield from _markdown_table(checks)
        yield ""


def _markdown_table(checks: list[Check]) -> Iterator[str]:
    words, notes = VERIFICATION_WORDS["en"], Notes(checks)
    heads = (words.quantity, "unit", *cells(checks[0])._fields, words.verdict)
    yield _markdown_row(heads)
    yield _markdown_row(("---", "---", *("---:" for _ in cells(checks[0])), "---"))
    for check in checks:
        verdict = words.verdicts[check.verdict]
        bold = verdict if check.verdict == "agrees" else f"**{verdict}**"
        texts = map(_escaped_markdown, (check.quantity, check.unit, *cells(check)))
        yield _markdown_row((*texts, f"{bold} {_escaped_markdown(notes.mark(check))}".rstrip()))
    for number, text in enumerate(notes.texts, start=1):
        yield f"\n\\[{number}\\] {_escaped_markdown(text)}"


def _markdown_row(texts: tuple[str, ...]) -> str:
    return f"| {' | '.join(texts)} |"


def _escaped_markdown(text: str) -> str:
    """Keep what Markdown would read as its own."""
    for character in "\\*_|[]<":
        text = text.replace(character, "\\" + character)
    return text
