"""A printed number as one row: as printed, with the author's choices, as it should be, and why."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from typing import Final

from rolamento_reproductions.page import PRINTED
from rolamento_reproductions.record import Cell, Claim, Table, TableColumn
from rolamento_reproductions.text import Text, said, same

__all__ = ["NONE", "NUMBER_HEADS", "Number", "by_key", "numbers_table", "said_like"]

NUMBER_HEADS: Final = (PRINTED, said("with the author's choices", "com as escolhas do autor"))
NONE: Final = said("none", "nenhum")
"""Where there is no right number, because the method does not hold for the case."""


@dataclass(frozen=True, slots=True)
class Number:
    """One printed number.

    quantity: with its unit; choices: computed with the author's choices; right: as it should be, a
    number in the same unit, or words; reason: why the two differ, or what the number rests on; cut:
    printed with its digits cut.
    """

    key: str
    quantity: Text
    printed: str
    choices: float
    right: float | Text
    reason: Text
    cut: bool = False

    @property
    def cell(self) -> Cell:
        """The printed number beside that of the author's choices."""
        return Cell(self.printed, self.choices, cut=self.cut)

    @property
    def right_text(self) -> Text:
        """The right number, with as many decimals as printed."""
        return self.right if isinstance(self.right, Text) else said_like(self.printed, self.right)


def said_like(printed: str, value: float) -> Text:
    """Say a number with as many decimals as a printed one."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    template = f"{{:.{max(-exponent, 0)}f}}"
    return said(template, template, value)


def by_key(numbers: tuple[Number, ...]) -> dict[str, Number]:
    """Return the numbers by their keys."""
    return {number.key: number for number in numbers}


def numbers_table(
    number: str,
    caption: Text,
    source: Text,
    rows: tuple[Number, ...],
    *,
    claims: tuple[Claim, ...] = (),
    notes: tuple[Text, ...] = (),
    heads: tuple[Text, Text] = NUMBER_HEADS,
) -> Table:
    """Put numbers together as a table.

    Parameters
    ----------
    number
        Of the table.
    caption, source
        Of the table.
    rows
        The numbers, in the order of the dissertation.
    claims, notes
        Below it.
    heads
        Over the printed number and the one beside it, where that is not by the author's choices.
    """
    return Table(
        number=number,
        caption=caption,
        source=source,
        columns=(
            TableColumn(
                "quantity", said("Quantity", "Grandeza"), tuple(row.quantity for row in rows)
            ),
            TableColumn("number", same(""), tuple(row.cell for row in rows), heads=heads),
            TableColumn("right", said("right", "correto"), tuple(row.right_text for row in rows)),
            TableColumn(
                "reason", said("why", "por quê"), tuple(row.reason for row in rows), sentences=True
            ),
        ),
        claims=claims,
        notes=notes,
    )
