"""The page of the documentation that shows the verification, in Markdown."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.report.verification import Notes, cells, summary, tables
from rolamento.report.verification_words import ENGLISH
from rolamento.verification import Check, SourceResult, Verification

__all__ = ["COMMAND", "verification_page"]

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
        command=COMMAND, proof=ENGLISH.proof_note, summary=summary(verification, ENGLISH)
    )
    sections = ("\n".join(_section(result)) for result in verification.results)
    return "\n".join([head, *sections])


def _section(result: SourceResult) -> Iterator[str]:
    yield f"## {_escaped(result.title)}\n"
    for source, checks in tables(result.checks):
        yield f"### {_escaped(source)}\n"
        yield from _table(checks)
        yield ""


def _table(checks: list[Check]) -> Iterator[str]:
    words, notes = ENGLISH, Notes(checks)
    heads = (words.quantity, "unit", *cells(checks[0])._fields, words.verdict)
    yield _row(heads)
    yield _row(("---", "---", *("---:" for _ in cells(checks[0])), "---"))
    for check in checks:
        verdict = words.verdicts[check.verdict]
        bold = verdict if check.verdict == "agrees" else f"**{verdict}**"
        texts = map(_escaped, (check.quantity, check.unit, *cells(check)))
        yield _row((*texts, f"{bold} {_escaped(notes.mark(check))}".rstrip()))
    for number, text in enumerate(notes.texts, start=1):
        yield f"\n\\[{number}\\] {_escaped(text)}"


def _row(texts: tuple[str, ...]) -> str:
    return f"| {' | '.join(texts)} |"


def _escaped(text: str) -> str:
    """Keep what Markdown would read as its own."""
    for character in "\\*_|[]<":
        text = text.replace(character, "\\" + character)
    return text
