"""What every part of the report is made with: words, numbers, lines that stand in columns.

A part is a list of lines. They are set here and not by Rich's tables, which take longer for sixty
balls than the solver does; Rich does the colours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from io import StringIO
from itertools import zip_longest
from math import isfinite
from textwrap import wrap
from typing import Final, TypeAlias

from rich.console import Console
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.language import Words
from rolamento.report.numbers import Digits, decimals_for
from rolamento.units import Dimension, from_si

_LONGEST_GIVEN: Final = 12
"""Characters of a number that a person writes; a longer one is computed."""

_LONGEST_LINE: Final = 200
FIGURES: Final = 4
"""Significant figures of a life; its bounds are seldom known to two."""
_SMALLEST, _GREATEST = 1e-6, 1e9
"""Beyond these a number is written by its order of magnitude."""
_ENDLESS: Final = "∞"

Lines: TypeAlias = list[Text]


@dataclass(frozen=True, slots=True)
class Page:
    """The words, the numbers and the medium of one report."""

    words: Words
    medium: Medium

    @property
    def digits(self) -> Digits:
        """How numbers are written."""
        return Digits(self.words.decimal_mark)

    def text(self, content: str, style: str = "") -> Text:
        """Return plain text that the medium can show: never read as markup."""
        return Text(self.medium.fitted(content), style)

    def quantity(self, value: float, dimension: Dimension) -> str:
        """Write a value of a case with its unit, as in a case file; a computed one shorter."""
        number, _, unit = from_si(value, dimension).partition(" ")
        if len(number) > _LONGEST_GIVEN:
            number = f"{float(number):.6g}"
        return self.digits.localised(f"{number} {unit}").replace(" deg", "°")

    def heading(self, content: str) -> Text:
        """Return the heading of a part."""
        return self.text(content, "bold cyan")

    def title(self, content: str) -> Lines:
        """Return the title of a page, with a line below it."""
        return [*self.hanging(Text(), content, "bold"), self.rule(self.medium.width)]

    def rule(self, width: int) -> Text:
        """Return a line across."""
        return self.text(("─" if self.medium.shows("─") else "-") * width, "dim")

    def labelled(
        self, entries: Sequence[tuple[str, str, str]], *, indent: str = "", style: str = "dim"
    ) -> Lines:
        """Set texts beside a column of labels.

        Parameters
        ----------
        entries
            Label, text, style of the text.
        indent
            Before the labels.
        style
            Of the labels.
        """
        width = max(len(label) for label, _, _ in entries)
        lines: Lines = []
        for label, content, own in entries:
            lines += self.hanging(self.text(f"{indent}{label:{width}}  ", style), content, own)
        return lines

    def columns(self, rows: Sequence[Sequence[Text]], justify: str, gap: int = 2) -> Lines:
        """Set cells in columns, indented by two.

        Parameters
        ----------
        rows
            The cells of each line.
        justify
            A letter for each column: ``l`` for left, ``r`` for right.
        gap
            Between columns, in characters.
        """
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        return [_set(row, widths, justify, gap) for row in rows]

    def table(self, columns: Sequence[Lines]) -> Lines:
        """Set columns of numbers beside each other, a rule below the two lines of their heads."""
        lines = self.columns(list(zip(*columns, strict=True)), "r" * len(columns))
        return [*lines[:2], self.rule(self.width_of(columns)), *lines[2:]]

    def width_of(self, columns: Sequence[Lines], gap: int = 2) -> int:
        """Return how wide such columns are, the indentation included."""
        return 2 + sum(max(map(len, column)) for column in columns) + gap * (len(columns) - 1)

    def hanging(self, label: Text, content: str, style: str = "") -> Lines:
        """Break a text into lines that begin to the right of its label."""
        width = self.medium.width - len(label)
        pieces = [
            piece
            for line in self.medium.fitted(content).split("\n")
            for piece in wrap(line, width, break_on_hyphens=False) or [""]
        ]
        margins = [label] + [Text(" " * len(label))] * (len(pieces) - 1)
        return [
            Text.assemble(margin, (piece, style))
            for margin, piece in zip(margins, pieces, strict=True)
        ]


def notes_part(page: Page, notes: Sequence[str]) -> Lines:
    """List what the user should know."""
    lines = [page.heading(page.words.notes)]
    for note in notes:
        lines += page.hanging(page.text("  • ", "yellow"), note)
    return lines


def rendered(medium: Medium, parts: Sequence[Lines]) -> str:
    """Return the parts one below the other, with an empty line between them."""
    console = Console(
        file=StringIO(),
        width=medium.width,
        color_system=medium.colors,
        force_terminal=medium.colors is not None,
        no_color=medium.colors is None,
        legacy_windows=False,
        highlight=False,
        markup=False,
        emoji=False,
    )
    with console.capture() as capture:
        for number, part in enumerate(parts):
            for line in [Text(), *part] if number else part:
                line.rstrip()
                console.print(line, no_wrap=True, overflow="ignore", crop=False)
    return capture.get()


def beside(left: Lines, right: Lines, gap: int) -> Lines:
    """Set two parts next to each other."""
    width = max(map(len, left)) + gap
    pairs = zip_longest(left, right, fillvalue=Text())
    return [Text.assemble(one, " " * (width - len(one)), other) for one, other in pairs]


def _set(cells: Sequence[Text], widths: Sequence[int], justify: str, gap: int) -> Text:
    line = Text("  ")
    for number, (cell, width, side) in enumerate(zip(cells, widths, justify, strict=True)):
        room = " " * (width - len(cell))
        line.append(" " * gap if number else "")
        line.append(room if side == "r" else "")
        line.append_text(cell)
        line.append(room if side == "l" else "")
    return line


def table(
    page: Page, heads: Sequence[str], rows: Sequence[Sequence[str]], justify: str = ""
) -> Lines:
    """Set cells in columns under faint heads: the first to the left, the others to the right."""
    texts = [[page.text(head, "dim") for head in heads]]
    texts += [[page.text(cell) for cell in row] for row in rows]
    return page.columns(texts, justify or "l" + "r" * (len(heads) - 1))


def one_line(text: str) -> str:
    """Return a text of others as one line that a terminal can be given."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text[:2000]).split())
    return plain if len(plain) <= _LONGEST_LINE else plain[: _LONGEST_LINE - 1] + "…"


def shortened(text: str, longest: int = 20) -> str:
    """Return a text that fits into a cell."""
    return text if len(text) <= longest else text[: longest - 1] + "…"


# --- numbers that may be anything -------------------------------------------------------------


def alike(page: Page, values: Sequence[float], figures: int = FIGURES) -> list[str]:
    """Write numbers of one quantity, all with the same decimals, by the least of them."""
    sizes = [abs(value) for value in values if isfinite(value) and value != 0.0]
    decimals = decimals_for([min(sizes, default=0.0)], figures - 1, most=6)
    fewest = decimals_for(sizes, figures, most=6)
    return [_with_decimals(page, value, max(decimals - 1, fewest)) for value in values]


def _with_decimals(page: Page, value: float, decimals: int) -> str:
    if value == float("inf"):
        return endless(page)
    if _beyond_reading(value, 0.5 * 10.0**-decimals):
        return page.digits.exponent(value)
    return page.digits.fixed(value, decimals)


def short_number(page: Page, value: float, figures: int = FIGURES) -> str:
    """Write one number without trailing zeros; by its order of magnitude if it is far out."""
    if value == float("inf"):
        return endless(page)
    if _beyond_reading(value, _SMALLEST):
        return page.digits.exponent(value)
    return page.digits.short(value, figures)


def _beyond_reading(value: float, smallest: float) -> bool:
    return isfinite(value) and value != 0.0 and not smallest <= abs(value) < _GREATEST


def endless(page: Page) -> str:
    """Write what is beyond any number."""
    return _ENDLESS if page.medium.shows(_ENDLESS) else "inf"


def percent(page: Page, share: float) -> str:
    """Write a share in per cent, without the sign."""
    return page.digits.short(100.0 * share, 6)
