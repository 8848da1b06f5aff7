"""Replacing bearings at an age, or when they fail: what costs least per hour.

A bearing is replaced at the age T, at the cost c_p, or when it fails before, at the cost c_f, which
holds the damage and the stop as well. As good as new each time, in the long run it costs

    C(T) = [c_p R(T) + c_f F(T)] / ∫_0^T R(t) dt

per unit of time, and C(∞) = c_f/mean if one waits for failures. With h the hazard, the least is at
the one root of

    h(T) ∫_0^T R(t) dt - F(T) = c_p/(c_f - c_p),

whose left side rises from 0 without end if β > 1: there is an optimum if failures come with age
(β > 1) and cost more than a planned replacement (c_f > c_p), and only then. Otherwise nothing is
won by replacing bearings that run. For the Weibull distribution, with τ = T/η,

    ∫_0^T R dt = (η/β) Γ(1/β) P(1/β, τ^β),    h(T) = (β/η) τ^(β-1),

P the regularised incomplete gamma function; and T is in proportion to η.

Sources: Barlow and Proschan, Mathematical Theory of Reliability (1965), chapter 4, section 2;
Glasser, Technometrics 9 (1967), for the Weibull distribution.
"""

from __future__ import annotations

from math import log
from typing import Any, Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.validate import finite, number, share
from rolamento.weibull.distribution import Interval, LifeDistribution
from rolamento.words import said

__all__ = [
    "AgeReplacement",
    "IfShape",
    "age_replacement",
    "cost_rate",
    "optimum_age",
]

_FACTORS: Final = (0.8, 0.9, 1.0, 1.1, 1.25)
"""Multiples of the shape, for which the cost of the same policy is given."""
_NEAR: Final = 0.05
"""Fraction of the least cost, within which other ages are as good."""
_GREATEST_COST: Final = 1e12
_LEAST_SAVING: Final = 1e-3
"""Fraction of the cost per hour, below which an optimum is not worth the name."""
_SHORTEST, _LONGEST = 1e-12, 1e6
"""T/η between which it is looked for."""


def cost_rate(
    age: FloatArray | float,
    shape: FloatArray | float,
    scale: FloatArray | float,
    planned: float,
    failure: float,
) -> FloatArray:
    """Cost per unit of time of replacing at an age, infinite for never; arrays or numbers."""
    from scipy.special import gamma, gammainc

    beta, eta = np.asarray(shape, dtype=float), np.asarray(scale, dtype=float)
    t = np.asarray(age, dtype=float)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        z = (t / eta) ** beta
        running = eta / beta * gamma(1.0 / beta) * gammainc(1.0 / beta, z)
        return np.asarray((planned * np.exp(-z) - failure * np.expm1(-z)) / running)


def optimum_age(
    shape: FloatArray | float, scale: FloatArray | float, planned: float, failure: float
) -> FloatArray:
    """Age of least cost; infinite where replacing bearings that run wins nothing; array."""
    from scipy.special import gamma, gammainc

    beta, eta = np.broadcast_arrays(
        np.atleast_1d(np.asarray(shape, dtype=float)), np.asarray(scale, dtype=float)
    )
    best = np.full(beta.shape, np.inf)
    wears = beta > 1.0
    if failure <= planned or not np.any(wears):
        return best
    b = beta[wears]
    factor = gamma(1.0 / b) / b
    goal = planned / (failure - planned)

    def excess(log_age: FloatArray) -> tuple[FloatArray, FloatArray]:
        x = np.exp(log_age)
        z = x**b
        hazard = b * x ** (b - 1.0)
        running = factor * gammainc(1.0 / b, z)
        value = hazard * running + np.expm1(-z) - goal
        return value, (b - 1.0) * hazard * running

    low, high = (np.full(b.shape, np.log(end)) for end in (_SHORTEST, _LONGEST))
    # for a small goal (β - 1) τ^β ≈ goal
    start = np.clip(np.log(goal / (b - 1.0)) / b, low, np.log(2.0))
    root, found = increasing_root(excess, start, low, high, tolerance=1e-12)
    best[wears] = np.where(found, np.exp(root), np.inf) * eta[wears]
    return best


@frozen
class IfShape:
    """What comes of a policy if the shape is another, with the same L10.

    Attributes
    ----------
    shape
        β
    best
        age of least cost
    saving
        part of the cost per hour of waiting for failures that the planned age saves there
    regret
        cost of the planned age over the least cost there, less one
    """

    shape: float
    best: float
    saving: float
    regret: float


@frozen(eq=False)
class AgeReplacement:
    """When to replace bearings at least cost per hour.

    Attributes
    ----------
    code
        "optimum"; or "not_worn" (β ≤ 1), "not_dearer" (a failure costs no more than a planned
        replacement), "no_saving" (an optimum that saves next to nothing): replace on failure
    distribution
        of the lives
    planned, failure
        c_p and c_f, in one unit
    confidence
        of the intervals
    age
        T of least cost, with its interval; infinite without one
    cost, cost_on_failure
        per unit of time: at that age, and of waiting for failures
    saving
        1 - the ratio of the two, with its interval at that age
    no_optimum
        part of the draws in which nothing is won by planned replacements; NaN without draws
    failed
        part of the bearings that fail before that age
    interval
        mean time between replacements
    near
        ages between which the cost is at most 5 % above the least one
    if_shape
        what comes of it if the shape is another
    """

    code: str
    distribution: LifeDistribution
    planned: float
    failure: float
    confidence: float
    age: Interval
    cost: float
    cost_on_failure: float
    saving: Interval
    no_optimum: float
    failed: float
    interval: float
    near: tuple[float, float]
    if_shape: tuple[IfShape, ...]

    @property
    def worthwhile(self) -> bool:
        """Whether planned replacements save anything."""
        return self.code == "optimum"

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the units of the distribution and of the costs."""
        return {
            "code": self.code,
            "distribution": self.distribution.to_mapping(),
            "cost_planned": self.planned,
            "cost_failure": self.failure,
            "confidence": self.confidence,
            "age": self.age.to_mapping(),
            "cost_per_time": finite(self.cost),
            "cost_per_time_on_failure": finite(self.cost_on_failure),
            "saving": self.saving.to_mapping(),
            "share_without_optimum": finite(self.no_optimum),
            "share_failed": finite(self.failed),
            "mean_time_between_replacements": finite(self.interval),
            "ages_within_5_percent": [finite(age) for age in self.near],
            "if_shape": [
                {
                    "shape": one.shape,
                    "age": finite(one.best),
                    "saving": finite(one.saving),
                    "regret": finite(one.regret),
                }
                for one in self.if_shape
            ],
        }


def age_replacement(
    distribution: LifeDistribution, planned: float, failure: float, *, confidence: float = 0.9
) -> AgeReplacement:
    """Find the age of replacement at least cost per unit of time.

    Parameters
    ----------
    distribution
        Of the lives.
    planned, failure
        Costs of a planned replacement and of a failure with all that it brings; any one unit.
    confidence
        Of the intervals.

    Raises
    ------
    InputError
        For a number that cannot be.
    """
    law = distribution
    c_p, c_f = _cost(planned, "planned"), _cost(failure, "failure")
    share(confidence, "confidence")
    on_failure = float(cost_rate(np.inf, law.shape, law.scale, c_p, c_f))
    best = float(optimum_age(law.shape, law.scale, c_p, c_f)[0])
    least = float(cost_rate(best, law.shape, law.scale, c_p, c_f))
    code = _code(law.shape, c_p, c_f, least, on_failure)
    if code != "optimum":
        best, least = np.inf, on_failure
    drawn = optimum_age(law.shapes, law.scales, c_p, c_f) if law.uncertain else np.empty(0)
    saved = np.empty(0)
    if law.uncertain and np.isfinite(best):
        rates = cost_rate(np.array([[best], [np.inf]]), law.shapes, law.scales, c_p, c_f)
        saved = 1.0 - rates[0] / rates[1]
    saving = 1.0 - least / on_failure if code == "optimum" else 0.0
    one = (law.shape, law.scale)
    failed = -float(np.expm1(-((best / law.scale) ** law.shape))) if np.isfinite(best) else 1.0
    mean_cost = c_p * (1.0 - failed) + c_f * failed
    return AgeReplacement(
        code,
        law,
        c_p,
        c_f,
        confidence,
        law.interval(best, drawn, confidence),
        least,
        on_failure,
        law.interval(saving, saved, confidence),
        float(np.mean(~np.isfinite(drawn))) if len(drawn) else np.nan,
        failed,
        mean_cost / least if least > 0.0 else np.inf,
        _near(best, least, *one, c_p, c_f) if np.isfinite(best) else (np.nan, np.nan),
        _if_shape(law, best, c_p, c_f) if np.isfinite(best) else (),
    )


def _cost(value: float, field: str) -> float:
    cost = number(value, field, above=0.0, example="500.0")
    if cost > _GREATEST_COST:
        raise InputError(
            said("must be at most {most:.6g}", most=_GREATEST_COST), field=field, value=value
        )
    return cost


def _code(shape: float, planned: float, failure: float, least: float, on_failure: float) -> str:
    if failure <= planned:
        return "not_dearer"
    if shape <= 1.0:
        return "not_worn"
    return "optimum" if least < (1.0 - _LEAST_SAVING) * on_failure else "no_saving"


def _near(
    best: float, least: float, shape: float, scale: float, planned: float, failure: float
) -> tuple[float, float]:
    """Ages on either side at which the cost is a little above the least."""
    from scipy.optimize import brentq

    def excess(log_age: float) -> float:
        rate = cost_rate(float(np.exp(log_age)), shape, scale, planned, failure)
        return float(rate) / least - (1.0 + _NEAR)

    middle = float(np.log(best))
    low = middle - np.log(1e6)
    high = middle + np.log(1e3)
    lower = float(np.exp(brentq(excess, low, middle))) if excess(low) > 0.0 else 0.0
    upper = float(np.exp(brentq(excess, middle, high))) if excess(high) > 0.0 else np.inf
    return lower, upper


def _if_shape(
    law: LifeDistribution, best: float, planned: float, failure: float
) -> tuple[IfShape, ...]:
    """Cost of the planned age at other shapes, with the L10 of the estimate."""
    risk = -log(0.9)
    l10 = law.scale * risk ** (1.0 / law.shape)
    found = []
    for factor in _FACTORS:
        shape = factor * law.shape
        scale = l10 * risk ** (-1.0 / shape)
        own = float(optimum_age(shape, scale, planned, failure)[0])
        here, there, never = (
            float(cost_rate(age, shape, scale, planned, failure)) for age in (best, own, np.inf)
        )
        found.append(IfShape(shape, own, 1.0 - here / never, here / there - 1.0))
    return tuple(found)
