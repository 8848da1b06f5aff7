"""What every part of the report is made with: words, numbers, and a medium to fit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from rich.box import Box
from rich.table import Table
from rich.text import Text

from rolamento.report.language import Words
from rolamento.report.medium import Medium
from rolamento.report.numbers import Digits

__all__ = ["Page"]

_BLANK: Final = "    \n"
_RULED: Final = Box(2 * _BLANK + " ── \n" + 5 * _BLANK)
_RULED_IN_ASCII: Final = Box(2 * _BLANK + " -- \n" + 5 * _BLANK, ascii=True)


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

    def heading(self, content: str) -> Text:
        """Return the heading of a part."""
        return self.text(content, "bold cyan")

    def grid(self, gap: int = 1) -> Table:
        """Return an empty table without header."""
        return Table.grid(padding=(0, gap, 0, 0))

    def table(self) -> Table:
        """Return an empty table with a ruled header."""
        return Table(
            box=_RULED if self.medium.shows("─") else _RULED_IN_ASCII,
            show_edge=False,
            pad_edge=False,
            padding=(0, 1, 0, 0),
            collapse_padding=True,
            header_style="",
        )
