"""Lives, shares and forces as a person reads them: three digits tell what a life is worth."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, isfinite, log10
from typing import Final

from rolamento.report.life_words import LIFE_WORDS, LifeWords
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Page

__all__ = [
    "factor_text",
    "force_text",
    "given_percent",
    "life_text",
    "percent",
    "said_of",
    "significant",
]

_LONGEST: Final = 1e8
"""From which a life is written by its order of magnitude."""
_SHORTEST: Final = 1e-4
_LEAST_PERCENT, _MOST_PERCENT = 0.1, 99.9
_KILO: Final = 1e3


def said_of(page: Page) -> LifeWords:
    """Return what is said of life in the page's language."""
    return LIFE_WORDS.get(page.words.code, LIFE_WORDS["en"])


def significant(value: float, digits: int = 3) -> float:
    """Round to so many significant digits."""
    if value == 0.0 or not isfinite(value):
        return value
    return round(value, digits - 1 - floor(log10(abs(value))))


def life_text(page: Page, value: float) -> str:
    """Write a life in hours or millions of revolutions: three digits, or that it has no end."""
    if value == float("inf"):
        return said_of(page).endless
    if not isfinite(value):
        return ABSENT
    if value >= _LONGEST or 0.0 < value < _SHORTEST:
        mantissa, _, exponent = f"{value:.2e}".partition("e")
        return f"{mantissa.replace('.', page.words.decimal_mark)}e{int(exponent)}"
    rounded = significant(value)
    decimals = max(2 - floor(log10(rounded)), 0) if rounded > 0.0 else 0
    return page.digits.fixed(rounded, decimals)


def lives_column(page: Page, values: Sequence[float]) -> list[str]:
    """Write lives that stand below each other, their decimal marks in line."""
    cells, mark = [life_text(page, value) for value in values], page.words.decimal_mark
    tails = [
        len(cell) - cell.index(mark) if mark in cell and "e" not in cell else 0 for cell in cells
    ]
    return [cell + " " * (max(tails) - tail) for cell, tail in zip(cells, tails, strict=True)]


def factor_text(page: Page, value: float) -> str:
    """Write a factor with three digits, trailing zeros left out."""
    return page.digits.short(significant(value), 3)


def percent(page: Page, share: float) -> str:
    """Write a share or a reliability that was found, with three digits; nearly sure is not sure."""
    if not isfinite(share):
        return ABSENT
    number = significant(100.0 * share)
    if share < 1.0 and number >= 100.0:
        return said_of(page).more_than.format(value=f"{page.digits.short(_MOST_PERCENT)} %")
    if 0.0 < number < _LEAST_PERCENT:
        return said_of(page).less_than.format(value=f"{page.digits.short(_LEAST_PERCENT)} %")
    return f"{page.digits.short(number, 3)} %"


def given_percent(page: Page, share: float) -> str:
    """Write a reliability that was given, with all its digits."""
    return f"{page.digits.short(100.0 * share, 7)} %"


def unit_of_force(values: Sequence[float]) -> tuple[float, str]:
    """Return factor and unit of forces that stand below each other; values in N."""
    greatest = max((abs(value) for value in values if isfinite(value)), default=0.0)
    return (1.0 / _KILO, "kN") if greatest >= _KILO else (1.0, "N")


def force_text(page: Page, value: float) -> str:
    """Write a force in its unit, with four digits and no more than three decimals."""
    return page.digits.short(round(significant(value, 4), 3), 4)
