"""Numbers as a person reads them: as many digits as matter, the decimal marks in line."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import floor, isfinite, log10
from typing import Final

__all__ = ["ABSENT", "Digits", "aligned", "decimals_for"]

ABSENT: Final = "–"
"""What stands for a number that does not exist."""

_MINUS: Final = "−"
_SMALLEST_GROUPED: Final = 10_000


def decimals_for(values: Iterable[float], digits: int, most: int = 4) -> int:
    """Return how many decimals give the maximum of the values so many significant digits."""
    maximum = max((abs(value) for value in values if isfinite(value)), default=0.0)
    if maximum == 0.0:
        return 0
    return min(max(digits - 1 - floor(log10(maximum)), 0), most)


class Digits:
    """Writes numbers with one decimal mark.

    Parameters
    ----------
    mark
        ``"."`` or ``","``.
    """

    def __init__(self, mark: str) -> None:
        self._mark = mark

    def fixed(self, value: float, decimals: int) -> str:
        """Write a number with so many decimals, groups of three from ten thousand on."""
        if not isfinite(value):
            return ABSENT
        text = f"{abs(value):,.{decimals}f}"
        grouped = text.replace(",", " " if abs(value) >= _SMALLEST_GROUPED else "")
        negative = value < 0.0 and any(digit in "123456789" for digit in text)
        return (_MINUS if negative else "") + grouped.replace(".", self._mark)

    def column(self, values: Sequence[float], digits: int = 5, most: int = 4) -> list[str]:
        """Write numbers that stand below each other, with the same decimals."""
        decimals = decimals_for(values, digits, most)
        return [self.fixed(value, decimals) for value in values]

    def short(self, value: float, digits: int = 5) -> str:
        """Write one number without trailing zeros."""
        if not isfinite(value):
            return ABSENT
        text = self.fixed(value, decimals_for([value], digits, most=9))
        return text.rstrip("0").rstrip(self._mark) if self._mark in text else text

    def exponent(self, value: float) -> str:
        """Write one number by its order of magnitude."""
        if not isfinite(value):
            return ABSENT
        return f"{value:.1e}".replace(".", self._mark)

    def localised(self, quantity: str) -> str:
        """Write a quantity of a case file, such as ``"22.23 mm"``, with the decimal mark."""
        number, space, unit = quantity.partition(" ")
        try:
            value = float(number)
        except ValueError:
            return quantity
        if abs(value) >= _SMALLEST_GROUPED and value.is_integer():
            number = self.fixed(value, 0)
        return number.replace("-", _MINUS).replace(".", self._mark) + space + unit


def aligned(cells: Sequence[str], mark: str) -> list[str]:
    """Pad numbers on the right so that their decimal marks fall below each other."""
    tails = [len(cell) - cell.index(mark) if mark in cell else 0 for cell in cells]
    return [cell + " " * (max(tails) - tail) for cell, tail in zip(cells, tails, strict=True)]
