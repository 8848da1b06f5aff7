"""What is left of a life: the chance of a bearing that has run t to run x more, and how long.

    R(x | t) = R(t + x)/R(t) = exp(-[((t + x)/η)^β - (t/η)^β]),
    x_p      = η [(t/η)^β - ln p]^(1/β) - t            reached with the probability p
    m(t)     = ∫_0^∞ R(x | t) dx = (η/β) e^z Γ(1/β, z),   z = (t/η)^β     mean residual life

With β > 1 the chance falls with the age, with β < 1 it rises, and with β = 1 age does not matter.

Sources: Lawless (2003), section 1.2; Rinne, The Weibull Distribution (2009), section 2.4, for the
mean residual life.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import share
from rolamento.weibull.distribution import Interval, LifeDistribution
from rolamento.weibull.limits import time_of

__all__ = [
    "RemainingLife",
    "conditional_reliability",
    "mean_residual_life",
    "remaining_life",
    "residual_life",
]

_FAR: Final = 600.0
"""z beyond which e^z Γ(a, z) is summed as an asymptotic series: its terms fall by 1/z."""
_TERMS: Final = 6


def conditional_reliability(
    shape: FloatArray | float, scale: FloatArray | float, age: float, mission: FloatArray | float
) -> FloatArray:
    """Chance to run a mission more at an age; arrays of one shape, or numbers."""
    return np.asarray(np.exp(-_more_risk(shape, scale, age, mission)))


def _more_risk(
    shape: FloatArray | float, scale: FloatArray | float, age: float, mission: FloatArray | float
) -> FloatArray:
    """Cumulated hazard over a mission; without loss of figures where the mission is short."""
    beta, eta = np.asarray(shape, dtype=float), np.asarray(scale, dtype=float)
    x = np.asarray(mission, dtype=float)
    with np.errstate(over="ignore", invalid="ignore"):
        if age == 0.0:
            return np.asarray((x / eta) ** beta)
        longer = (age / eta) ** beta * np.expm1(beta * np.log1p(x / age))
        whole = ((age + x) / eta) ** beta  # where a power is beyond any number
        return np.asarray(np.where(np.isnan(longer) & ~np.isnan(x), whole, longer))


def residual_life(
    shape: FloatArray | float, scale: FloatArray | float, age: float, probability: float
) -> FloatArray:
    """Time that is left and reached with a probability, at an age; array."""
    beta, eta = np.asarray(shape, dtype=float), np.asarray(scale, dtype=float)
    more = -np.log(probability)
    with np.errstate(over="ignore"):
        if age == 0.0:
            return np.asarray(eta * more ** (1.0 / beta))
        return np.asarray(age * np.expm1(np.log1p(more * (eta / age) ** beta) / beta))


def mean_residual_life(
    shape: FloatArray | float, scale: FloatArray | float, age: float
) -> FloatArray:
    """Mean of the time that is left at an age; array, infinite where it is beyond any number."""
    from scipy.special import gamma, gammaincc

    beta, eta = np.broadcast_arrays(np.asarray(shape, dtype=float), np.asarray(scale, dtype=float))
    a = 1.0 / beta
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        z = (age / eta) ** beta
        near = np.minimum(z, _FAR)
        value = np.exp(near) * gamma(a) * gammaincc(a, near)
        # Γ(a, z) e^z ~ z^(a-1) [1 + (a-1)/z + (a-1)(a-2)/z² + …]
        term = np.ones_like(z)
        series = np.ones_like(z)
        for place in range(1, _TERMS):
            term = term * (a - place) / np.maximum(z, 1.0)
            series = series + term
        far = z ** (a - 1.0) * series
        return np.asarray(eta / beta * np.where(z > _FAR, far, value))


@frozen(eq=False)
class RemainingLife:
    """What is left of the life of a bearing that has run so long.

    Attributes
    ----------
    distribution
        of the lives
    age, mission
        run already, and wanted; mission NaN without one
    confidence
        of the intervals
    reliability
        chance to run the mission, with its interval
    new
        chance of a new bearing to run the mission
    median, mean
        residual life, with intervals
    quantiles
        probability, and the residual life that is reached with it
    """

    distribution: LifeDistribution
    age: float
    mission: float
    confidence: float
    reliability: Interval
    new: float
    median: Interval
    mean: Interval
    quantiles: tuple[tuple[float, Interval], ...]

    def curve(self, missions: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Chances over missions, and their limits, NaN where none are known; arrays."""
        law = self.distribution
        value = conditional_reliability(law.shape, law.scale, self.age, missions)
        if not law.uncertain:
            return value, np.full(len(missions), np.nan), np.full(len(missions), np.nan)
        limits = [
            law.interval(
                0.0,
                conditional_reliability(law.shapes, law.scales, self.age, float(x)),
                self.confidence,
            )
            for x in missions
        ]
        return (
            value,
            np.array([limit.lower for limit in limits]),
            np.array([limit.upper for limit in limits]),
        )

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the unit of the distribution."""
        return {
            "distribution": self.distribution.to_mapping(),
            "age": self.age,
            "mission": self.mission,
            "confidence": self.confidence,
            "reliability": self.reliability.to_mapping(),
            "reliability_new": self.new,
            "median_residual_life": self.median.to_mapping(),
            "mean_residual_life": self.mean.to_mapping(),
            "residual_lives": [
                {"probability": p, **interval.to_mapping()} for p, interval in self.quantiles
            ],
        }


def remaining_life(
    distribution: LifeDistribution,
    age: float,
    mission: float | None = None,
    *,
    confidence: float = 0.9,
    probabilities: tuple[float, ...] = (0.99, 0.95, 0.9, 0.5),
) -> RemainingLife:
    """Find what is left of a life.

    Parameters
    ----------
    distribution
        Of the lives.
    age
        Run without failure, in the unit of the distribution; 0 for a new bearing.
    mission
        Time to run more.
    confidence
        Of the intervals.
    probabilities
        With which residual lives are to be reached.

    Raises
    ------
    InputError
        For a number that cannot be.
    """
    t = time_of(age, "age", least=0.0)
    x = np.nan if mission is None else time_of(mission, "mission")
    share(confidence, "confidence")
    law = distribution
    one, many = (law.shape, law.scale), (law.shapes, law.scales)

    def interval(value: FloatArray, drawn: FloatArray) -> Interval:
        return law.interval(float(value), drawn, confidence)

    def residual(p: float) -> Interval:
        return interval(residual_life(*one, t, p), residual_life(*many, t, p))

    return RemainingLife(
        law,
        t,
        x,
        confidence,
        interval(
            conditional_reliability(*one, t, x),
            conditional_reliability(*many, t, x) if mission is not None else np.empty(0),
        ),
        float(conditional_reliability(*one, 0.0, x)),
        residual(0.5),
        interval(mean_residual_life(*one, t), mean_residual_life(*many, t)),
        tuple((share(p, "probabilities"), residual(p)) for p in probabilities),
    )
