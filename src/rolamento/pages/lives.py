"""Lives and reliabilities on a page: numbers that may be of any size, and what they are called.

Times are in the unit of the data, which a page names.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, isfinite
from typing import Final

from rolamento.document import CellContent, Number
from rolamento.weibull import Estimand
from rolamento.words import decimals_for, manner

__all__ = ["FIGURES", "alike", "brief", "life_name", "percent", "written"]

FIGURES: Final = 4
"""Significant figures of a life; its bounds are seldom known to two."""
_SMALLEST, _GREATEST = 1e-6, 1e9
"""Beyond these a number is written by its order of magnitude."""
_INFINITE: Final = "∞"


def alike(
    values: Sequence[float], figures: int = FIGURES, *, share: bool = False
) -> list[CellContent]:
    """Return numbers of one quantity with the same decimals, by the least of them.

    Where that would give the greatest more figures than are known, each has its own decimals.
    share: they are written in per cent.
    """
    scale, unit = (100.0, " [%]") if share else (1.0, "")
    sizes = [scale * abs(value) for value in values if isfinite(value) and value != 0.0]
    of_least = decimals_for([min(sizes, default=0.0)], figures - 1, most=6) - 1
    of_greatest = decimals_for(sizes, figures, most=6)
    decimals = max(of_least, of_greatest)
    form, least = f".{decimals}f", 0.5 * 10.0**-decimals
    if of_least > of_greatest and not share:  # whose 99.9 % would be 100 %
        form, least = f".{figures - 1}r", _SMALLEST
    return [
        _INFINITE
        if value == inf
        else Number(value, (".1e" if _is_far_out(scale * value, least) else form) + unit)
        for value in values
    ]


def brief(value: float, figures: int = FIGURES) -> Number | str:
    """Return a number without trailing zeros; by its order of magnitude if it is far out."""
    if value == inf:
        return _INFINITE
    return Number(value, ".1e" if _is_far_out(value, _SMALLEST) else f".{figures}")


def written(number: CellContent) -> str:
    """Write a number of `alike` or `brief` in a sentence."""
    if isinstance(number, Number):
        return manner().number(number.value, number.form)
    return str(number)


def percent(share: float) -> str:
    """Write a share in per cent, without the sign."""
    return manner().short(100.0 * share, 6)


def life_name(quantity: Estimand) -> str:
    """Write the name of a life with the decimal mark: L10, L0,1."""
    return quantity.name.replace(".", manner().mark)


def _is_far_out(value: float, smallest: float) -> bool:
    return isfinite(value) and value != 0.0 and not smallest <= abs(value) < _GREATEST
