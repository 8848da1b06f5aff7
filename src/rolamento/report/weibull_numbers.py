"""Quantities, numbers and texts of others, as the pages of life tests write them."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Final

from rolamento.report.numbers import decimals_for
from rolamento.report.page import Lines, Page
from rolamento.report.weibull_words import WeibullWords
from rolamento.weibull import Estimand

__all__ = [
    "FIGURES",
    "alike",
    "endless",
    "label_of",
    "life_name",
    "one_line",
    "p_text",
    "percent",
    "scale_of",
    "short_number",
    "shortened",
    "spelt",
    "table",
]

FIGURES: Final = 4
"""Significant figures of a life; its bounds are seldom known to two."""
_LONGEST: Final = 200
_LEAST_P: Final = 0.001
_LONGEST_UNIT: Final = 12
_SMALLEST, _GREATEST = 1e-6, 1e9
"""Beyond these a number is written by its order of magnitude."""
_ENDLESS: Final = "∞"
_LETTERS: Final = {"β": "beta", "η": "eta"}


def alike(page: Page, values: Sequence[float], figures: int = FIGURES) -> list[str]:
    """Write numbers of one quantity, all with the same decimals, by the least of them."""
    sizes = [abs(value) for value in values if isfinite(value) and value != 0.0]
    decimals = decimals_for([min(sizes, default=0.0)], figures - 1, most=6)
    fewest = decimals_for(sizes, figures, most=6)
    return [_written(page, value, max(decimals - 1, fewest)) for value in values]


def _written(page: Page, value: float, decimals: int) -> str:
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


def p_text(page: Page, p: float) -> str:
    """Write a p-value; the smallest only as being small."""
    if isfinite(p) and p < _LEAST_P:
        return "< " + page.digits.short(_LEAST_P, 1)
    return page.digits.short(p, 2)


def scale_of(quantity: Estimand) -> float:
    """Return what a quantity is multiplied with to be read: reliabilities in per cent."""
    return 100.0 if quantity.kind == "reliability" else 1.0


def label_of(page: Page, said: WeibullWords, quantity: Estimand, unit: str) -> str:
    """Write what a quantity is, with its unit."""
    if quantity.kind == "shape":
        return spelt(page, said.shape)
    unit = shortened(one_line(unit), _LONGEST_UNIT)
    if quantity.kind == "reliability":
        return said.reliability_at.format(time=page.digits.short(quantity.value, 6), unit=unit)
    name = spelt(page, said.scale) if quantity.name == "scale" else life_name(page, quantity)
    return f"{name} {unit}"


def spelt(page: Page, text: str) -> str:
    """Spell out the letters of shape and scale where they cannot be shown."""
    for letter, name in _LETTERS.items():
        text = text if page.medium.shows(letter) else text.replace(letter, name)
    return text


def life_name(page: Page, quantity: Estimand) -> str:
    """Write the name of a life, with our decimal mark: L10, L0,1."""
    return quantity.name.replace(".", page.words.decimal_mark)


def one_line(text: str) -> str:
    """Return a text of others as one line that a terminal can be given."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text[:2000]).split())
    return plain if len(plain) <= _LONGEST else plain[: _LONGEST - 1] + "…"


def shortened(text: str, longest: int = 20) -> str:
    """Return a text that fits into a cell."""
    return text if len(text) <= longest else text[: longest - 1] + "…"


def table(
    page: Page, heads: Sequence[str], rows: Sequence[Sequence[str]], justify: str = ""
) -> Lines:
    """Set cells in columns under faint heads: the first to the left, the others to the right."""
    texts = [[page.text(head, "dim") for head in heads]]
    texts += [[page.text(cell) for cell in row] for row in rows]
    return page.columns(texts, justify or "l" + "r" * (len(heads) - 1))
