"""Limits from the shape of the likelihood: its curvature, or how far it falls.

*Fisher.* The inverse of the observed information gives the variance of (a, b); limits are normal in
ln β, in ln t_R, and in -ln(-ln R).

*Likelihood ratio.* A value of a quantity lies within the limits as long as twice the fall of the
logarithm of the likelihood, at the best of the distributions that have that value, is less than a
quantile of chi-square with one degree of freedom.

With w = ln(-ln R) and c = ln t, a life t_R and the reliability at t are both the line b = w - a c
in the (a, b) of `likelihood`: along it the likelihood has one maximum, which a root finds.

Sources: Lawless (2003), section 5.3; Venzon and Moolgavkar (1988) for the profile.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.reliability.fit import WeibullFit
from rolamento.reliability.life_test import LifeTest
from rolamento.reliability.likelihood import Likelihood
from rolamento.reliability.quantity import Quantity
from rolamento.reliability.roots import ValueAndSlope, rising_root

__all__ = ["Hill", "fisher_limits", "likelihood_ratio_limits", "profile_fall"]

_FARTHEST: Final = {"shape": 15.0, "life": 300.0, "reliability": 300.0}
_MUCH: Final = 1e200


def fisher_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], tails: FloatArray
) -> FloatArray:
    """Limits by the observed information: (quantities, tails); tails: probability below."""
    from scipy.special import ndtri

    hill, points = _hill(test, fit), np.asarray(ndtri(tails))
    return np.array(
        [hill.value_of(q, hill.coordinate(q) + points * hill.spread(q)) for q in quantities]
    )


def likelihood_ratio_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], roots: FloatArray
) -> FloatArray:
    """Limits by the likelihood ratio: (quantities, limits).

    roots: (quantities, limits), the roots of twice the fall of the likelihood there, with the sign
    of the limit less the estimate; quantiles of the normal distribution for many failures.
    """
    hill = _hill(test, fit)
    return np.array([_limits(hill, q, points) for q, points in zip(quantities, roots, strict=True)])


def _limits(hill: Hill, quantity: Quantity, roots: FloatArray) -> FloatArray:
    """Limits of one quantity."""
    side, farthest = np.sign(roots), np.full(len(roots), _FARTHEST[quantity.kind])
    top = hill.coordinate(quantity)

    def excess(distance: FloatArray) -> tuple[FloatArray, FloatArray]:
        fall, slope = hill.fall(quantity, top + side * distance)
        return fall - roots**2, side * slope

    start = np.minimum(np.abs(roots) * hill.spread(quantity), 0.5 * farthest)
    moved, found = rising_root(excess, start, np.zeros_like(start), farthest, tolerance=1e-10)
    # where the likelihood hardly falls however far one goes, that side is open
    if not np.all(found):
        moved = np.where(~found & (excess(farthest)[0] < 0.0), np.inf, moved)
    moved = np.where(roots == 0.0, 0.0, moved)
    with np.errstate(invalid="ignore"):
        return hill.value_of(quantity, top + side * moved)


def profile_fall(
    test: LifeTest, fit: WeibullFit, quantity: Quantity, value: float
) -> tuple[float, float]:
    """Twice the fall of the likelihood at a value of a quantity, and its side: -1 or 1."""
    hill = _hill(test, fit)
    there = np.array([hill.coordinate_of(quantity, value)])
    side = np.sign(there - hill.coordinate(quantity))
    return max(float(hill.fall(quantity, there)[0][0]), 0.0), float(side[0])


def _hill(test: LifeTest, fit: WeibullFit) -> Hill:
    return Hill(Likelihood.of(test), np.array([fit.shape]), np.log([fit.scale]))


class Hill:
    """The maximum of a likelihood, and how it falls around it; one, or one a lane.

    A quantity is measured where it is nearly normal: ln β, ln t_R from the likelihood's origin,
    -ln(-ln R).

    Parameters
    ----------
    likelihood : of one test, or of many with the same times.
    shape, log_scale : (1,) or (lanes,), of its maximum.
    """

    def __init__(self, likelihood: Likelihood, shape: FloatArray, log_scale: FloatArray) -> None:
        self._likelihood = likelihood
        self._origin = likelihood.origin
        self._failures = np.atleast_1d(likelihood.failures)
        self._a, self._b = shape, shape * (self._origin - log_scale)
        self._top = likelihood.at(self._a, self._b)

    def coordinate(self, quantity: Quantity) -> FloatArray:
        """Coordinate of a quantity at the maximum."""
        if quantity.kind == "shape":
            return np.asarray(np.log(self._a))
        if quantity.kind == "life":
            return np.asarray((quantity.log_risk - self._b) / self._a)
        return np.asarray(-self._a * self._log_time(quantity) - self._b)

    def coordinate_of(self, quantity: Quantity, value: float) -> float:
        """The same of another value."""
        if quantity.kind == "reliability":
            return -float(np.log(-np.log(value)))
        return float(np.log(value)) - (self._origin if quantity.kind == "life" else 0.0)

    def value_of(self, quantity: Quantity, coordinate: FloatArray) -> FloatArray:
        """Turn coordinates back."""
        with np.errstate(over="ignore"):
            if quantity.kind == "reliability":
                return np.asarray(np.exp(-np.exp(-coordinate)))
            shift = self._origin if quantity.kind == "life" else 0.0
            return np.asarray(np.exp(coordinate + shift))

    def spread(self, quantity: Quantity) -> FloatArray:
        """Standard deviation of the coordinate, by the observed information."""
        if quantity.kind == "shape":
            slope_a, slope_b = 1.0 / self._a, np.zeros_like(self._a)
        elif quantity.kind == "life":
            slope_a, slope_b = self.coordinate(quantity) / self._a, 1.0 / self._a
        else:
            slope_a, slope_b = (
                np.full_like(self._a, self._log_time(quantity)),
                np.ones_like(self._a),
            )
        aa, ab, bb = self._top.aa, self._top.ab, self._top.bb
        form = -bb * slope_a**2 + 2.0 * ab * slope_a * slope_b - aa * slope_b**2
        return np.asarray(np.sqrt(np.maximum(form / (aa * bb - ab * ab), 0.0)))

    def fall(self, quantity: Quantity, there: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Twice the fall of the likelihood at coordinates, and its slope; arrays (lanes,)."""
        if quantity.kind == "shape":
            a = np.exp(there)
            b = self._best_b(a)
            here = self._likelihood.at(a, b)
            slope = -a * here.a
        elif quantity.kind == "life":
            w = np.full_like(there, quantity.log_risk)
            a = self._best_a(w, there)
            here = self._likelihood.at(a, w - a * there)
            slope = a * here.b
        else:
            c = np.full_like(there, self._log_time(quantity))
            a = self._best_a(-there, c)
            here = self._likelihood.at(a, -there - a * c)
            slope = here.b
        with np.errstate(over="ignore"):
            return np.minimum(2.0 * (self._top.value - here.value), _MUCH), _bounded(2.0 * slope)

    def _best_a(self, w: FloatArray, c: FloatArray) -> FloatArray:
        """Best a on the line b = w - a c."""

        def falling(a: FloatArray) -> tuple[FloatArray, FloatArray]:
            here = self._likelihood.at(a, w - a * c)
            with np.errstate(invalid="ignore", over="ignore"):
                value = -(here.a - c * here.b)
                slope = -(here.aa - 2.0 * c * here.ab + c * c * here.bb)
                return self._compressed(a * value, value + a * slope)

        return self._root(falling, self._a, w)

    def _best_b(self, a: FloatArray) -> FloatArray:
        """Best b at given a."""

        def falling(level: FloatArray) -> tuple[FloatArray, FloatArray]:
            with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
                here = self._likelihood.at(a, np.log(level))
                return self._compressed(-here.b, -here.bb / level)

        return np.asarray(np.log(self._root(falling, np.exp(self._b), a)))

    def _compressed(self, value: FloatArray, slope: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return what has the same root but does not grow like an exponential."""
        value, slope = _bounded(value), _bounded(slope)
        size = np.abs(value) + self._failures
        return np.sign(value) * np.log(size / self._failures), slope / size

    @staticmethod
    def _root(function: ValueAndSlope, start: FloatArray, like: FloatArray) -> FloatArray:
        zeros = np.zeros_like(like)
        root, _ = rising_root(function, zeros + start, zeros, zeros + np.inf, tolerance=1e-12)
        return root

    def _log_time(self, quantity: Quantity) -> float:
        """Logarithm of the time of a reliability, from the origin."""
        return float(np.log(quantity.value)) - self._origin


def _bounded(values: FloatArray) -> FloatArray:
    """Keep what overflowed a number, so that a search can come back from it."""
    return np.nan_to_num(values, nan=_MUCH, posinf=_MUCH, neginf=-_MUCH)
