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

from collections.abc import Callable
from typing import Final, Literal

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.root import ValueAndSlope, increasing_root
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.quantity import Quantity

__all__ = ["Hill", "fisher_limits", "likelihood_ratio_limits", "profile_fall"]

Kind = Literal["shape", "life", "reliability"]
Limits = Callable[["Hill", Kind, FloatArray, list[int]], FloatArray]

_FARTHEST: Final = {"shape": 15.0, "life": 300.0, "reliability": 300.0}
_MUCH: Final = 1e200


def fisher_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], tails: FloatArray
) -> FloatArray:
    """Limits by the observed information: (quantities, tails); tails: probability below."""
    from scipy.special import ndtri

    points = np.asarray(ndtri(tails))

    def limits(hill: Hill, kind: Kind, level: FloatArray, places: list[int]) -> FloatArray:
        top, spread = hill.coordinate(kind, level), hill.spread(kind, level)
        found = top[:, np.newaxis] + points * spread[:, np.newaxis]
        return hill.value_of(kind, found)

    return _by_kind(test, fit, quantities, len(tails), limits)


def likelihood_ratio_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], roots: FloatArray
) -> FloatArray:
    """Limits by the likelihood ratio: (quantities, limits).

    roots: (quantities, limits), the roots of twice the fall of the likelihood there, with the sign
    of the limit less the estimate; quantiles of the normal distribution for many failures.
    """
    count = roots.shape[1]

    def limits(hill: Hill, kind: Kind, level: FloatArray, places: list[int]) -> FloatArray:
        lanes = _limits(hill, kind, np.repeat(level, count), roots[places].ravel())
        return lanes.reshape(len(places), count)

    return _by_kind(test, fit, quantities, count, limits)


def profile_fall(
    test: LifeTest, fit: WeibullFit, quantity: Quantity, value: float
) -> tuple[float, float]:
    """Twice the fall of the likelihood at a value of a quantity, and its side: -1 or 1."""
    hill, level = _hill(test, fit), np.array([quantity.level])
    there = np.array([hill.coordinate_of(quantity.kind, value)])
    side = np.sign(there - hill.coordinate(quantity.kind, level))
    return max(float(hill.fall(quantity.kind, level, there)[0][0]), 0.0), float(side[0])


def _by_kind(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], count: int, limits: Limits
) -> FloatArray:
    """Find the limits of all quantities of one kind at once."""
    found = np.empty((len(quantities), count))
    for kind in {quantity.kind for quantity in quantities}:
        places = [i for i, quantity in enumerate(quantities) if quantity.kind == kind]
        level = np.array([quantities[i].level for i in places])
        found[places] = limits(_hill(test, fit), kind, level, places)
    return found


def _limits(hill: Hill, kind: Kind, level: FloatArray, roots: FloatArray) -> FloatArray:
    """Limits of quantities of one kind, one a lane."""
    side, farthest = np.sign(roots), np.full(len(roots), _FARTHEST[kind])
    top = hill.coordinate(kind, level)

    def excess(distance: FloatArray) -> tuple[FloatArray, FloatArray]:
        fall, slope = hill.fall(kind, level, top + side * distance)
        return fall - roots**2, side * slope

    start = np.minimum(np.abs(roots) * hill.spread(kind, level), 0.5 * farthest)
    moved, found = increasing_root(excess, start, np.zeros_like(start), farthest, tolerance=1e-10)
    # where the likelihood hardly falls however far one goes, that side is open
    if not np.all(found):
        moved = np.where(~found & (excess(farthest)[0] < 0.0), np.inf, moved)
    moved = np.where(roots == 0.0, 0.0, moved)
    with np.errstate(invalid="ignore"):
        return hill.value_of(kind, top + side * moved)


def _hill(test: LifeTest, fit: WeibullFit) -> Hill:
    return Hill(Likelihood.of(test), np.array([fit.shape]), np.log([fit.scale]))


class Hill:
    """The maximum of a likelihood, and how it falls around it; one, or one a lane.

    A quantity is measured where it is nearly normal: ln β, ln t_R from the likelihood's origin,
    -ln(-ln R). What it is for, its level, is that of `Quantity`; arrays (lanes,).

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
        self._near = self._a

    def coordinate(self, kind: Kind, level: FloatArray) -> FloatArray:
        """Coordinates of quantities at the maximum."""
        if kind == "shape":
            return np.asarray(np.log(self._a) + 0.0 * level)
        if kind == "life":
            return np.asarray((level - self._b) / self._a)
        return np.asarray(-self._a * (level - self._origin) - self._b)

    def coordinate_of(self, kind: Kind, value: float) -> float:
        """Coordinate of another value."""
        if kind == "reliability":
            return -float(np.log(-np.log(value)))
        return float(np.log(value)) - (self._origin if kind == "life" else 0.0)

    def value_of(self, kind: Kind, coordinate: FloatArray) -> FloatArray:
        """Turn coordinates back."""
        with np.errstate(over="ignore"):
            if kind == "reliability":
                return np.asarray(np.exp(-np.exp(-coordinate)))
            shift = self._origin if kind == "life" else 0.0
            return np.asarray(np.exp(coordinate + shift))

    def spread(self, kind: Kind, level: FloatArray) -> FloatArray:
        """Standard deviation of the coordinates, by the observed information."""
        slope_a, slope_b = level - self._origin, np.ones_like(self._a)
        if kind == "shape":
            slope_a, slope_b = 1.0 / self._a + 0.0 * level, 0.0 * self._a
        elif kind == "life":
            slope_a, slope_b = self.coordinate(kind, level) / self._a, 1.0 / self._a
        aa, ab, bb = self._top.aa, self._top.ab, self._top.bb
        form = -bb * slope_a**2 + 2.0 * ab * slope_a * slope_b - aa * slope_b**2
        return np.asarray(np.sqrt(np.maximum(form / (aa * bb - ab * ab), 0.0)))

    def fall(
        self, kind: Kind, level: FloatArray, there: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Twice the fall of the likelihood at coordinates, and its slope; arrays (lanes,)."""
        if kind == "shape":
            a = np.exp(there)
            here = self._likelihood.at(a, self._best_b(a))
            slope = -a * here.a
        elif kind == "life":
            a = self._best_a(level, there)
            here = self._likelihood.at(a, level - a * there)
            slope = a * here.b
        else:
            c = level - self._origin
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

        # the last line was near this one
        start = self._near if self._near.shape == w.shape else self._a
        best = self._root(falling, start, w)
        self._near = np.where(np.isfinite(best) & (best > 0.0), best, self._a)
        return best

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
        root, _ = increasing_root(function, zeros + start, zeros, zeros + np.inf, tolerance=1e-10)
        return root


def _bounded(values: FloatArray) -> FloatArray:
    """Keep what overflowed a number, so that a search can come back from it."""
    return np.nan_to_num(values, nan=_MUCH, posinf=_MUCH, neginf=-_MUCH)
