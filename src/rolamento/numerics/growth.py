"""What grows with time, and when it reaches a limit: a line through values or their logarithms.

    linear       y = a + b t + ε            exponential       ln y = a + b t + ε

by least squares, ε normal. With s² the residual variance of n - 2 degrees of freedom and
S = Σ (t - t̄)², the line at t lies within ± q s √(1/n + (t - t̄)²/S) of its estimate, q the quantile
of Student's t. The times at which it may reach a limit are those at which the limit lies within
that band (Fieller's theorem): the roots of

    (a + b t - L)² = q² s² (1/n + (t - t̄)²/S).

Where the slope is not significant at the same confidence the set has no end, and the honest answer
is "perhaps never"; where it falls, "not while it falls".

Which law fits better is decided by the likelihood of the values themselves, that of the exponential
law with the Jacobian of the logarithm, -Σ ln y.

Sources: Draper and Smith, Applied Regression Analysis (1998), sections 1.4 and 3.2; Fieller,
Journal of the Royal Statistical Society B 16 (1954).
"""

from __future__ import annotations

from dataclasses import asdict
from math import isfinite, log, nan, pi, sqrt
from typing import Any, Final, Literal, get_args

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.records import frozen

__all__ = [
    "LAWS",
    "Crossing",
    "Forecast",
    "Growth",
    "Law",
    "fit_growth",
    "forecast",
    "growth_rate",
]

Law = Literal["linear", "exponential"]
LAWS: Final = get_args(Law)
LEAST_POINTS: Final = 3
"""Smallest number of different times: fewer leave no residual to judge the slope by."""


@frozen
class Crossing:
    """When a line reaches a limit from below.

    Attributes
    ----------
    code
        "reached" in the future, "exceeded" already, "no_trend" where the slope is not significant,
        "falling", or "too_few"
    limit
        in the unit of the values
    time
        at which the line reaches it; NaN without an answer
    lower, upper
        of that time, at the confidence; upper infinite where no end can be judged
    confidence
        of both limits together
    """

    code: str
    limit: float
    time: float
    lower: float
    upper: float
    confidence: float


@frozen
class Growth:
    """A line through values over time.

    Attributes
    ----------
    law
        "linear", or "exponential": then level, slope and scatter are of the logarithm
    count
        of the values
    last_time, last_value
        of the last measurement
    mean_time, level
        t̄, and the line there
    slope, slope_error
        b and its standard error; 1/time
    scatter
        s, of the residuals
    spread
        S = Σ (t - t̄)²
    log_likelihood
        of the values
    p_value
        of no growth, against growth: one-sided, by Student's t; NaN for fewer than three times
    """

    law: Law
    count: int
    last_time: float
    last_value: float
    mean_time: float
    level: float
    slope: float
    slope_error: float
    scatter: float
    spread: float
    log_likelihood: float
    p_value: float

    def at(self, time: FloatArray) -> FloatArray:
        """Values of the line; array."""
        line = self.level + self.slope * (np.asarray(time) - self.mean_time)
        return np.asarray(np.exp(line) if self.law == "exponential" else line)

    def band(self, time: FloatArray, confidence: float) -> tuple[FloatArray, FloatArray]:
        """Limits of the line at times, each by itself; arrays."""
        away = np.asarray(time) - self.mean_time
        line = self.level + self.slope * away
        width = self._quantile(confidence) * self.scatter
        half = width * np.sqrt(1.0 / self.count + away**2 / self.spread)
        low, high = line - half, line + half
        return (np.exp(low), np.exp(high)) if self.law == "exponential" else (low, high)

    def doubling_time(self) -> float:
        """Time in which an exponential law doubles; NaN of a linear or falling one."""
        rising = self.law == "exponential" and self.slope > 0.0
        return log(2.0) / self.slope if rising else nan

    def reaches(self, limit: float, confidence: float = 0.9) -> Crossing:
        """When the line reaches a limit, with limits of that time.

        Parameters
        ----------
        limit
            Of the values; above zero for an exponential law.
        confidence
            Of both limits together; a slope that is not significant at it gives no time.
        """

        def none(code: str) -> Crossing:
            return Crossing(code, limit, nan, nan, nan, confidence)

        if not isfinite(self.p_value):
            return none("too_few")
        if self.last_value >= limit or float(self.at(np.array(self.last_time))) >= limit:
            return Crossing("exceeded", limit, self.last_time, nan, nan, confidence)
        goal = (log(limit) if self.law == "exponential" else limit) - self.level
        if self.slope <= 0.0:
            return none("falling")
        half = self._quantile(confidence) * self.scatter
        leading = self.slope**2 - half**2 / self.spread
        if leading <= 0.0:
            return none("no_trend")
        # leading x² - 2 b g x + g² - half²/n = 0, x from the mean time
        discriminant = (self.slope * goal) ** 2 - leading * (goal**2 - half**2 / self.count)
        root = sqrt(max(discriminant, 0.0))
        low, high = ((self.slope * goal + sign * root) / leading for sign in (-1.0, 1.0))
        time = self.mean_time + goal / self.slope
        return Crossing(
            "reached",
            limit,
            time,
            max(self.mean_time + low, self.last_time),
            self.mean_time + high,
            confidence,
        )

    def _quantile(self, confidence: float) -> float:
        from scipy.special import stdtrit

        return float(stdtrit(self.count - 2, 0.5 + 0.5 * confidence))


def fit_growth(times: FloatArray, values: FloatArray, law: Law) -> Growth:
    """Put a line through values over time, or through their logarithms.

    Parameters
    ----------
    times, values
        (count,), finite; above zero for the exponential law.
    law
        "linear" or "exponential".

    Returns
    -------
    Growth
        Without scatter, errors and p-value for fewer than three different times.
    """
    t, y = np.asarray(times, dtype=float), np.asarray(values, dtype=float)
    order = np.argsort(t, kind="stable")
    t, y = t[order], y[order]
    w = np.log(y) if law == "exponential" else y
    count, mean = len(t), float(np.mean(t))
    away = t - mean
    spread, level = float(np.sum(away**2)), float(np.mean(w))
    slope = float(np.sum(away * w)) / spread if spread > 0.0 else nan
    residuals = w - level - slope * away
    square = float(np.sum(residuals**2))
    error = scatter = p_value = likelihood = nan
    if len(np.unique(t)) >= LEAST_POINTS:
        scatter = sqrt(square / (count - 2))
        error = scatter / sqrt(spread)
        p_value = _one_sided(slope, error, count - 2)
        variance = max(square / count, np.finfo(float).tiny)
        likelihood = -0.5 * count * (log(2.0 * pi * variance) + 1.0)
        likelihood -= float(np.sum(w)) if law == "exponential" else 0.0
    return Growth(
        law, count, float(t[-1]), float(y[-1]), mean, level, slope, error, scatter, spread,
        likelihood, p_value,
    )  # fmt: skip


@frozen
class Forecast:
    """When values that grow reach a limit, by both laws.

    Attributes
    ----------
    growths, crossings
        one a law; the exponential one only where all values are above zero
    chosen
        place of the law that was asked for, or else of the one that fits better
    """

    growths: tuple[Growth, ...]
    crossings: tuple[Crossing, ...]
    chosen: int

    @property
    def growth(self) -> Growth:
        """Growth of the chosen law."""
        return self.growths[self.chosen]

    @property
    def crossing(self) -> Crossing:
        """Crossing of the chosen law."""
        return self.crossings[self.chosen]

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in the units of times and values."""
        return {
            "law": self.growth.law,
            "laws": [
                asdict(growth) | {"crossing": asdict(crossing)}
                for growth, crossing in zip(self.growths, self.crossings, strict=True)
            ],
        }


def forecast(
    times: FloatArray,
    values: FloatArray,
    limit: float,
    *,
    confidence: float = 0.9,
    law: Law | None = None,
) -> Forecast:
    """When values that grow reach a limit.

    Parameters
    ----------
    times, values
        (count,), finite.
    limit
        Above zero.
    confidence
        Of the limits of the time.
    law
        The one to choose, if it is known; else the likelier one.
    """
    laws = LAWS if np.all(np.asarray(values) > 0.0) else LAWS[:1]
    growths = tuple(fit_growth(times, values, one) for one in laws)
    if law in laws:
        chosen = laws.index(law)
    else:
        chosen = int(np.argmax([np.nan_to_num(one.log_likelihood) for one in growths]))
    crossings = tuple(one.reaches(limit, confidence) for one in growths)
    return Forecast(growths, crossings, chosen)


def growth_rate(times: FloatArray, values: FloatArray) -> float:
    """Slope of the logarithm of values, 1/time; NaN for fewer than two different times."""
    if len(times) < 2 or np.ptp(times) == 0.0:
        return nan
    return fit_growth(np.asarray(times), np.asarray(values), "exponential").slope


def _one_sided(slope: float, error: float, freedom: int) -> float:
    from scipy.special import stdtr

    if error == 0.0:
        return 0.0 if slope > 0.0 else 1.0
    return float(stdtr(freedom, -slope / error))
