"""Printed numbers beside computed ones, and whether the digits agree."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from typing import Final, Literal

__all__ = ["Agreement", "Cell"]

Agreement = Literal["printed", "tie", "cut", "differs"]

_TIE: Final = 0.01
"""Of half a unit of the last digit: how near a tie rounding may go either way."""


@dataclass(frozen=True, slots=True)
class Cell:
    """A number as printed, and as computed in the same unit; cut: printed without rounding."""

    printed: str
    computed: float
    cut: bool = False

    @property
    def unit(self) -> float:
        """One unit of the last printed digit."""
        exponent = Decimal(self.printed).as_tuple().exponent
        assert isinstance(exponent, int)
        return 10.0**exponent

    @property
    def agreement(self) -> Agreement:
        """How the computed number agrees.

        "printed": it rounds to the printed digits; "tie": it lies so near the middle between two
        roundings that the last digit may be either; "cut": of a number known to be printed so, its
        digits cut off are the printed ones; "differs": anything else, NaN too.
        """
        if not math.isfinite(self.computed):
            return "differs"
        halves = abs(self.computed - float(self.printed)) / (0.5 * self.unit)
        if halves <= 1.0 + 1e-9:
            return "printed"
        if halves <= 1.0 + _TIE:
            return "tie"
        beyond = (self.computed - float(self.printed)) / self.unit
        outward = math.copysign(beyond, beyond * float(self.printed))
        return "cut" if self.cut and 0.0 <= outward < 1.0 else "differs"

    @property
    def text(self) -> str:
        """The computed number with two digits more than printed, three where that shows a tie."""
        more = 3 if self.agreement == "tie" else 2
        number = Decimal(self.printed)
        digits = number.as_tuple()
        assert isinstance(digits.exponent, int)
        if "e" in self.printed.lower():
            return f"{self.computed:.{len(digits.digits) - 1 + more}e}".replace("e+0", "e")
        return f"{self.computed:.{max(-digits.exponent, 0) + more}f}"
