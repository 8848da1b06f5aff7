"""What a bound is for: shape, scale, a life, or the reliability at a time.

Written as a word: "shape", "scale", "L10" (the life that 90 % reach), "L50", "L0.1", and "R100"
(the reliability at time 100, in the unit of the test).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import exp
from typing import Final, Literal, Self

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.weibull._checks import positive, share
from rolamento.weibull._columns import MOST_TIME

__all__ = ["Quantity"]

_WRITTEN: Final = re.compile(r"([LlRr])([0-9]{1,20}(?:\.[0-9]{1,20})?(?:[eE][+-]?[0-9]{1,2})?)")


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of a Weibull distribution.

    Attributes
    ----------
    kind
        "shape", "life" or "reliability"
    value
        the reliability that the life is for; or the time that the reliability is for, in the unit
        of the test; NaN for the shape
    name
        as it is written
    """

    kind: Literal["shape", "life", "reliability"]
    value: float
    name: str

    @classmethod
    def of(cls, written: str | Quantity) -> Self | Quantity:
        """Read a quantity.

        Raises
        ------
        InputError
            If it is none.
        """
        if isinstance(written, Quantity):
            return written
        word = str(written).strip()
        if word in ("shape", "scale"):
            return cls("shape", np.nan, word) if word == "shape" else cls("life", exp(-1.0), word)
        match = _WRITTEN.fullmatch(word)
        number = float(match[2]) if match else np.nan
        if match and match[1] in "Ll" and 0.0 < number < 100.0:
            return cls.life(1.0 - number / 100.0)
        if match and match[1] in "Rr" and 0.0 < number <= MOST_TIME:
            return cls.reliability(number)
        raise InputError(
            "must be shape, scale, a life such as L10 (of the 10 % that fail first), or a"
            " reliability at a time such as R100",
            field="quantity",
            value=written,
            example="L10",
        )

    @classmethod
    def life(cls, reliability: float) -> Self:
        """Life that a share of the bearings reach."""
        r = share(reliability, "reliability")
        return cls("life", r, f"L{100.0 * (1.0 - r):.6g}")

    @classmethod
    def reliability(cls, time: float) -> Self:
        """Share of the bearings that reach a time."""
        t = positive(time, "time", "100.0")
        return cls("reliability", t, f"R{t:.12g}")

    @property
    def log_risk(self) -> float:
        """Of a life: ln(-ln R), the ordinate of the Weibull plot."""
        return float(np.log(-np.log(self.value)))

    @property
    def level(self) -> float:
        """What it is for: ln(-ln R) of a life, ln t of a reliability, 0 of the shape."""
        if self.kind == "shape":
            return 0.0
        return self.log_risk if self.kind == "life" else float(np.log(self.value))

    @property
    def ends(self) -> tuple[float, float]:
        """The least and the greatest that it can be."""
        return (0.0, 1.0) if self.kind == "reliability" else (0.0, np.inf)

    def at(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Value for distributions given by shape and logarithm of the scale; arrays of one shape.

        NaN where the distribution has none.
        """
        if self.kind == "shape":
            return shape
        with np.errstate(over="ignore", invalid="ignore"):
            if self.kind == "life":
                return np.asarray(np.exp(log_scale + self.log_risk / shape))
            return np.asarray(np.exp(-np.exp(shape * (np.log(self.value) - log_scale))))
