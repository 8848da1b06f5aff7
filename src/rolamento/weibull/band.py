"""The band around a fitted line: bounds of the lives for a whole range of reliabilities."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.weibull.bounds import Method, Sides, all_bounds
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.quantity import Quantity

__all__ = ["Band", "confidence_band"]

_LEAST, _MOST, _POINTS = 0.001, 0.999, 61
MOST_SAMPLES: Final = 10_000
"""More make no difference that a picture could show."""


@dataclass(frozen=True, slots=True, eq=False)
class Band:
    """Bounds of lives over a range of reliabilities, each by itself.

    Attributes
    ----------
    code
        "converged", or why there is none, a key of `fit.ADVICE`
    method, confidence, sides
        of the bounds: two-sided, or lower ones where nothing failed
    reliability
        (points,), falling
    estimate, lower, upper
        (points,) lives; NaN or infinite where there is no bound
    unit
        label of times
    """

    code: str
    method: str
    confidence: float
    sides: Sides
    reliability: FloatArray
    estimate: FloatArray
    lower: FloatArray
    upper: FloatArray
    unit: str

    @property
    def converged(self) -> bool:
        """Whether there is a band."""
        return self.code == "converged"

    @property
    def failed_share(self) -> FloatArray:
        """F = 1 - R."""
        return 1.0 - self.reliability


def confidence_band(
    test: LifeTest,
    *,
    method: Method | None = None,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
    shape: float | None = None,
) -> Band:
    """Bounds of the lives that 99.9 % down to 0.1 % of the bearings reach.

    Parameters
    ----------
    test
        With any kind of censoring.
    method, confidence, samples, seed, shape
        As of `bounds`; samples above 10 000 are not drawn.
    """
    first, last = (float(np.log(-np.log1p(-failed))) for failed in (_LEAST, _MOST))
    ordinate = np.linspace(first, last, _POINTS)
    reliability = np.exp(-np.exp(ordinate))
    sides: Sides = "two" if test.failures else "lower"
    found = all_bounds(
        test,
        [Quantity.life(float(r)) for r in reliability],
        method=method,
        confidence=confidence,
        sides=sides,
        samples=min(samples, MOST_SAMPLES),
        seed=seed,
        shape=shape,
    )
    estimate, lower, upper = np.array([[one.estimate, one.lower, one.upper] for one in found]).T
    code = next((one.code for one in found if one.converged), found[0].code)
    return Band(
        code, found[0].method, confidence, sides, reliability, estimate, lower, upper, test.unit
    )
