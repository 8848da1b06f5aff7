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
from rolamento.numerics.root import ValueAndSlope, increasing_root
from rolamento.reliability.fit import WeibullFit
from rolamento.reliability.life_test import LifeTest
from rolamento.reliability.likelihood import Likelihood
from rolamento.reliability.quantity import Quantity

__all__ = ["fisher_limits", "likelihood_ratio_limits", "profile_fall"]

_FARTHEST: Final = {"shape": 15.0, "life": 300.0, "reliability": 300.0}
_MUCH: Final = 1e200


def fisher_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], tails: FloatArray
) -> FloatArray:
    """Limits by the observed information: (quantities, tails); tails: probability below."""
    from scipy.special import ndtri

    place, points = _Place(test, fit), np.asarray(ndtri(tails))
    return np.array(
        [
            place.value_of(quantity, place.coordinate(quantity) + points * place.spread(quantity))
            for quantity in quantities
        ]
    )


def likelihood_ratio_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Quantity], tails: FloatArray
) -> FloatArray:
    """Limits by the likelihood ratio: (quantities, tails); tails: probability below."""
    from scipy.special import ndtri

    place, points = _Place(test, fit), np.asarray(ndtri(tails))
    limits = []
    for quantity in quantities:
        side, farthest = np.sign(points), np.full(len(points), _FARTHEST[quantity.kind])
        start = np.minimum(np.abs(points) * place.spread(quantity), 0.5 * farthest)

        def excess(
            distance: FloatArray, quantity: Quantity = quantity, side: FloatArray = side
        ) -> tuple[FloatArray, FloatArray]:
            fall, slope = place.fall(quantity, side, distance)
            return fall - points**2, slope

        moved, found = increasing_root(
            excess, start, np.zeros_like(start), farthest, tolerance=1e-10
        )
        # where the likelihood hardly falls however far one goes, that side is open
        if not np.all(found):
            moved = np.where(~found & (excess(farthest)[0] < 0.0), np.inf, moved)
        moved = np.where(points == 0.0, 0.0, moved)
        with np.errstate(invalid="ignore"):
            limits.append(place.value_of(quantity, place.coordinate(quantity) + side * moved))
    return np.array(limits)


def profile_fall(
    test: LifeTest, fit: WeibullFit, quantity: Quantity, value: float
) -> tuple[float, float]:
    """Twice the fall of the likelihood at a value of a quantity, and its side: -1 or 1."""
    place = _Place(test, fit)
    moved = place.coordinate_of(quantity, value) - place.coordinate(quantity)
    side = np.array([np.sign(moved)])
    fall = place.fall(quantity, side, np.array([abs(moved)]))[0]
    return max(float(fall[0]), 0.0), float(side[0])


class _Place:
    """The maximum of a likelihood, and the likelihood around it."""

    def __init__(self, test: LifeTest, fit: WeibullFit) -> None:
        self._likelihood = Likelihood.of(test)
        self._origin = self._likelihood.origin
        self._failures = float(test.failures)
        self._a = fit.shape
        self._b = fit.shape * (self._origin - float(np.log(fit.scale)))
        top = self._likelihood.at(np.array([self._a]), np.array([self._b]))
        self._top = float(top.value[0])
        aa, ab, bb = float(top.aa[0]), float(top.ab[0]), float(top.bb[0])
        self._variance = np.array([[-bb, ab], [ab, -aa]]) / (aa * bb - ab * ab)

    def coordinate(self, quantity: Quantity) -> float:
        """Value of a quantity at the maximum, where it is nearly normal."""
        if quantity.kind == "shape":
            return float(np.log(self._a))
        if quantity.kind == "life":
            return (quantity.log_risk - self._b) / self._a
        return -self._a * self._log_time(quantity) - self._b

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

    def spread(self, quantity: Quantity) -> float:
        """Standard deviation of the coordinate."""
        if quantity.kind == "shape":
            slope = np.array([1.0 / self._a, 0.0])
        elif quantity.kind == "life":
            slope = np.array([self.coordinate(quantity), 1.0]) / self._a
        else:
            slope = np.array([self._log_time(quantity), 1.0])
        return float(np.sqrt(max(float(slope @ self._variance @ slope), 0.0)))

    def fall(
        self, quantity: Quantity, side: FloatArray, distance: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Twice the fall of the likelihood so far away, and its slope; arrays (lanes,)."""
        there = self.coordinate(quantity) + side * distance
        if quantity.kind == "shape":
            a = np.exp(there)
            b = self._best_b(a)
            here = self._likelihood.at(a, b)
            slope = -side * a * here.a
        elif quantity.kind == "life":
            w = np.full_like(there, quantity.log_risk)
            a = self._best_a(w, there)
            here = self._likelihood.at(a, w - a * there)
            slope = side * a * here.b
        else:
            c = np.full_like(there, self._log_time(quantity))
            a = self._best_a(-there, c)
            here = self._likelihood.at(a, -there - a * c)
            slope = side * here.b
        with np.errstate(over="ignore"):
            return np.minimum(2.0 * (self._top - here.value), _MUCH), _bounded(2.0 * slope)

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

        return np.asarray(np.log(self._root(falling, float(np.exp(self._b)), a)))

    def _compressed(self, value: FloatArray, slope: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return what has the same root but does not grow like an exponential."""
        value, slope = _bounded(value), _bounded(slope)
        size = np.abs(value) + self._failures
        return np.sign(value) * np.log(size / self._failures), slope / size

    @staticmethod
    def _root(function: ValueAndSlope, start: float, like: FloatArray) -> FloatArray:
        zeros = np.zeros_like(like)
        root, _ = increasing_root(function, zeros + start, zeros, zeros + np.inf, tolerance=1e-12)
        return root

    def _log_time(self, quantity: Quantity) -> float:
        """Logarithm of the time of a reliability, from the origin."""
        return float(np.log(quantity.value)) - self._origin


def _bounded(values: FloatArray) -> FloatArray:
    """Keep what overflowed a number, so that a search can come back from it."""
    return np.nan_to_num(values, nan=_MUCH, posinf=_MUCH, neginf=-_MUCH)
