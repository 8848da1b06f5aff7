"""The likelihood ratio with limits that hold for few failures.

Let R be the signed root of twice the fall of the likelihood from its maximum to a value of a
quantity, positive where the estimate lies above the value. For many failures R is normal. For few
it is drawn: of tests drawn at the fit, at the value that the fit has. Where the test ended with
failures the distribution of R knows neither shape nor scale, and the limits are exact; where the
clock ended it R depends on them but little, much less than the pivots of `sampled` do.

Sources: Jeng and Meeker (2000); Doganaksoy and Schmee (1993).
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.weibull import profile
from rolamento.weibull.asymptotic import Hill, likelihood_ratio_limits, profile_fall
from rolamento.weibull.censoring import fits_of, model_of
from rolamento.weibull.drawing import Drawing, portions
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.profile import Rows
from rolamento.weibull.quantity import Quantity

__all__ = ["calibrated_limits", "calibrated_p_value", "signed_roots"]

_MUCH: Final = 1e200


def calibrated_limits(
    test: LifeTest,
    fit: WeibullFit,
    quantities: list[Quantity],
    tails: FloatArray,
    samples: int,
    random: np.random.Generator,
) -> tuple[FloatArray, Drawing]:
    """Limits by the calibrated likelihood ratio: (quantities, tails), and how they were drawn.

    tails: probability of lying below the limit.
    """
    roots, drawing = signed_roots(test, fit, quantities, samples, random)
    if drawing.code != "converged":
        return np.full((len(quantities), len(tails)), np.nan), drawing
    points = -np.quantile(roots, 1.0 - tails, axis=1).T
    return likelihood_ratio_limits(test, fit, quantities, points), drawing


def calibrated_p_value(
    test: LifeTest,
    fit: WeibullFit,
    quantity: Quantity,
    value: float,
    samples: int,
    random: np.random.Generator,
) -> float:
    """How often, of two sides, R would be as far out as at a value of a quantity."""
    roots, drawing = signed_roots(test, fit, [quantity], samples, random)
    if drawing.code != "converged":
        return float("nan")
    fall, side = profile_fall(test, fit, quantity, value)
    here = -side * fall**0.5
    beyond = min(int(np.sum(roots[0] >= here)), int(np.sum(roots[0] <= here)))
    return float(min(2.0 * (1 + beyond) / (1 + roots.shape[1]), 1.0))


def signed_roots(
    test: LifeTest,
    fit: WeibullFit,
    quantities: list[Quantity],
    samples: int,
    random: np.random.Generator,
) -> tuple[FloatArray, Drawing]:
    """R of tests drawn at a fit, at its own values: (quantities, samples that have a fit)."""
    model = model_of(test)
    if isinstance(model, str):
        return np.empty((len(quantities), 0)), Drawing(model)
    of_portion = _inspected if model.inspected else _right_censored
    log_scale = float(np.log(fit.scale))
    counts = portions(model.width, samples)
    parts = [of_portion(model, fit.shape, log_scale, quantities, n, random) for n in counts]
    roots = np.concatenate(parts, axis=1)
    return roots, Drawing.of(model, sum(counts), sum(counts) - roots.shape[1])


def _right_censored(
    model: Any,
    shape: float,
    log_scale: float,
    quantities: list[Quantity],
    samples: int,
    random: np.random.Generator,
) -> FloatArray:
    rows = model.rows(shape, log_scale, samples, random)
    failures = np.broadcast_to(rows.failures, rows.log_time.shape).sum(axis=1)
    fit = profile.fit_rows(rows)
    good = fit.code == profile.CONVERGED
    lanes = _Lanes(rows.part(good), failures[good], fit.shape[good], fit.log_scale[0, good])
    return np.array([lanes.root(q, shape, log_scale) for q in quantities])


def _inspected(
    model: Any,
    shape: float,
    log_scale: float,
    quantities: list[Quantity],
    samples: int,
    random: np.random.Generator,
) -> FloatArray:
    likelihood = model.likelihood(shape, log_scale, samples, random)
    fit = fits_of(likelihood)
    good = fit.code == profile.CONVERGED
    hill = Hill(likelihood.lanes(good), fit.shape[good], fit.log_scale[0, good])
    roots = []
    for quantity in quantities:
        true = float(quantity.at(np.array([shape]), np.array([log_scale]))[0])
        there = np.full(np.count_nonzero(good), hill.coordinate_of(quantity.kind, true))
        level = np.full_like(there, quantity.level)
        side = np.sign(hill.coordinate(quantity.kind, level) - there)
        fall = hill.fall(quantity.kind, level, there)[0]
        roots.append(side * np.sqrt(np.maximum(fall, 0.0)))
    return np.array(roots)


class _Lanes:
    """Drawn tests with their fits."""

    def __init__(
        self, rows: Rows, failures: FloatArray, shape: FloatArray, log_scale: FloatArray
    ) -> None:
        self.y, self.units = rows.log_time, rows.units
        self.r = failures
        self.failed = np.einsum("ij,ij->i", np.broadcast_to(rows.failures, self.y.shape), self.y)
        self.shape, self.log_scale = shape, log_scale
        self.top = self._value(self.shape, self.r, -self.shape * self.log_scale)

    def root(self, quantity: Quantity, shape: float, log_scale: float) -> FloatArray:
        """Signed root at the value of a quantity that a distribution has."""
        true = float(quantity.at(np.array([shape]), np.array([log_scale]))[0])
        above = np.sign(quantity.at(self.shape, self.log_scale) - true)
        if quantity.kind == "shape":
            value = self._at_shape(true)
        else:
            # a life, and the reliability at a time, are points on the Weibull plot
            life = quantity.kind == "life"
            c = np.log(true) if life else np.log(quantity.value)
            w = quantity.log_risk if life else np.log(-np.log(true))
            value = self._through(float(c), float(w))
        return np.asarray(above * np.sqrt(np.maximum(2.0 * (self.top - value), 0.0)))

    def _value(self, a: FloatArray | float, risk: FloatArray, b: FloatArray) -> FloatArray:
        """Logarithm of the likelihood, but for Σ ln t of the failures."""
        return np.asarray(self.r * np.log(a) + a * self.failed + self.r * b - risk)

    def _at_shape(self, a: float) -> FloatArray:
        """Greatest at a shape."""
        longest = self.y.max(axis=1)
        weight = np.exp(a * (self.y - longest[:, np.newaxis])) * self.units
        b = np.log(self.r) - a * longest - np.log(weight.sum(axis=1))
        return self._value(a, self.r, b)

    def _through(self, c: float, w: float) -> FloatArray:
        """Greatest of the lines through the point (c, w) of the Weibull plot."""
        x, level = self.y - c, np.exp(w)
        sum_failed = self.failed - self.r * c

        def falling(a: FloatArray) -> tuple[FloatArray, FloatArray]:
            with np.errstate(over="ignore", invalid="ignore"):
                each = np.exp(a[:, np.newaxis] * x)
                each *= self.units
                each *= x
                first = level * each.sum(axis=1)
                second = level * np.einsum("ij,ij->i", each, x)
                value = a * (first - sum_failed) - self.r
                slope = first - sum_failed + a * second
            value = np.nan_to_num(value, nan=_MUCH, posinf=_MUCH)
            size = np.abs(value) + self.r
            bounded = np.nan_to_num(slope, nan=_MUCH, posinf=_MUCH)
            return np.sign(value) * np.log(size / self.r), bounded / size

        zeros = np.zeros_like(self.shape)
        a, _ = increasing_root(falling, self.shape, zeros, zeros + np.inf, tolerance=1e-10)
        risk = np.sum(np.exp(a[:, np.newaxis] * x) * self.units, axis=1) * level
        return self._value(a, risk, w - a * c)
