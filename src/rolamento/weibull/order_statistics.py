"""When the r-th of n bearings fails: mean, spread and percentiles.

The share of a population that has failed when the r-th of n does has a Beta(r, n + 1 - r)
distribution, and a time is t = η (-ln(1 - F))^(1/β) of it. Percentiles follow at once. Means have a
closed form whose terms alternate in sign and cancel when there are many; here they are summed over
ln t, where the density falls off at both ends, so that the trapezoidal rule is as good as exact.

Sources: Lieblein (1955) for the moments; David and Nagaraja (2003) for order statistics.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.weibull._checks import MOST_SHAPE, positive, shape_of, share

__all__ = ["FailureTime", "failure_time", "mean_failure_times", "planned_shape", "whole_number"]

MOST: Final = 100_000
LEAST_SHAPE: Final = 0.1
_POINTS: Final = 801
_NEXT_TO_NOTHING: Final = 1e-18
_AT_ONCE: Final = 1000


@dataclass(frozen=True, slots=True)
class FailureTime:
    """When a failure comes; in the unit of the scale.

    Attributes
    ----------
    mean, deviation
        expected time, and its standard deviation
    median
        as often earlier as later
    lower, upper
        limits that it lies between with the probability, as much left out on each side
    probability
        of that
    """

    mean: float
    deviation: float
    median: float
    lower: float
    upper: float
    probability: float

    def to_mapping(self) -> dict[str, Any]:
        """Give the time as plain values; None where it is beyond any number."""
        names = ("mean", "deviation", "median", "lower", "upper", "probability")
        values = {name: getattr(self, name) for name in names}
        return {name: value if np.isfinite(value) else None for name, value in values.items()}


def failure_time(
    rank: int, size: int, shape: float, scale: float = 1.0, probability: float = 0.9
) -> FailureTime:
    """Time of the r-th failure among n bearings that start together.

    Parameters
    ----------
    rank, size
        r and n, up to 100 000.
    shape, scale
        β, η.
    probability
        Of the two limits.

    Raises
    ------
    InputError
        If a number is out of range.
    """
    r, n = _ranked(rank, size)
    beta, eta = planned_shape(shape), positive(scale, "scale", "1000.0")
    tail = 0.5 * (1.0 - share(probability, "probability"))
    # each limit from its own side, so that none is lost in 1 - F
    risks = _risk_below(r, n, tail), _risk_below(r, n, 0.5), _risk_above(r, n, tail)
    lower, median, upper = (eta * float(risk) ** (1.0 / beta) for risk in risks)
    mean, deviation = (eta * float(moment[0]) for moment in _moments(np.array([r]), n, beta))
    return FailureTime(mean, deviation, median, lower, upper, probability)


def mean_failure_times(count: int, size: int, shape: float, scale: float = 1.0) -> FloatArray:
    """Mean times of the first failures among n bearings: (count,); parameters as `failure_time`."""
    r, n = _ranked(count, size)
    beta, eta = planned_shape(shape), positive(scale, "scale", "1000.0")
    ranks = np.arange(1, r + 1)
    parts = [_moments(ranks[i : i + _AT_ONCE], n, beta)[0] for i in range(0, r, _AT_ONCE)]
    return np.asarray(eta * np.concatenate(parts))


def planned_shape(value: object) -> float:
    """Return a shape that plans can be made with."""
    shape = shape_of(value)
    if shape < LEAST_SHAPE:
        raise InputError(
            f"must be from {LEAST_SHAPE:g} to {MOST_SHAPE:g}",
            field="shape",
            value=value,
            example="1.5",
        )
    return shape


def whole_number(value: object, field: str, least: int, most: int) -> int:
    """Return a whole number between limits."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= int(value) <= most:  # type: ignore[call-overload]
        raise InputError(
            f"must be a whole number from {least} to {most}",
            field=field,
            value=value,
            example=str(max(least, 10) if most >= 10 else least),
        )
    return int(value)  # type: ignore[call-overload, no-any-return]


def _ranked(rank: int, size: int) -> tuple[int, int]:
    n = whole_number(size, "size", 1, MOST)
    return whole_number(rank, "rank", 1, n), n


def _risk_below(rank: FloatArray | int, size: int, probability: float) -> FloatArray:
    """Cumulated risk -ln(1 - F) that the r-th failure comes before with a probability."""
    from scipy.special import betaincinv

    r = np.asarray(rank, dtype=np.float64)
    return np.asarray(-np.log1p(-betaincinv(r, size + 1.0 - r, probability)))


def _risk_above(rank: FloatArray | int, size: int, probability: float) -> FloatArray:
    """Cumulated risk that it comes after with a probability."""
    from scipy.special import betaincinv

    r = np.asarray(rank, dtype=np.float64)
    return np.asarray(-np.log(betaincinv(size + 1.0 - r, r, probability)))


def _moments(rank: NDArray[np.int64], size: int, shape: float) -> tuple[FloatArray, FloatArray]:
    """Mean and standard deviation of the times of some failures, over the scale."""
    from scipy.special import betaln

    r = rank.astype(np.float64)[:, np.newaxis]
    left = size + 1.0 - r
    low = np.log(_risk_below(r, size, _NEXT_TO_NOTHING))
    # where the times weigh more than the density does: z^(2/β) e^(-left z) has its end there
    weight = 2.0 / shape
    heavy = (60.0 + weight + 10.0 * weight**0.5) / left
    high = np.log(np.maximum(_risk_above(r, size, _NEXT_TO_NOTHING), heavy))
    x = low + (high - low) * np.linspace(0.0, 1.0, _POINTS)
    risk = np.exp(x)
    log_density = (r - 1.0) * np.log(-np.expm1(-risk)) - left * risk + x - betaln(r, left)
    share_ = np.exp(log_density) * (high - low) / (_POINTS - 1)
    middle = np.log(_risk_below(r, size, 0.5))
    time = np.exp((x - middle) / shape)  # over the median
    mean = np.sum(share_ * time, axis=1, keepdims=True)
    variance = np.sum(share_ * (time - mean) ** 2, axis=1)
    unit = np.exp(middle[:, 0] / shape)
    return unit * mean[:, 0], unit * np.sqrt(variance)
