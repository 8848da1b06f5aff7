"""Distributions in numbers, by their quantiles: what a share of the draws lies below.

Whoever draws turns shares in (0, 1) into values: pseudo-random ones, Sobol's, or correlated ones.
A law that is cut off at bounds is the distribution between them, not draws moved onto them.

Sources: Johnson, Kotz and Balakrishnan, Continuous Univariate Distributions, 2nd ed., vol. 1
(1994), chapters 13 (normal), 14 (lognormal), 21 (Weibull); vol. 2 (1995), chapter 26 (uniform,
triangular).
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.records import frozen

__all__ = ["Law", "Lognormal", "Normal", "Triangular", "Uniform", "Weibull", "truncated_normal"]

Floats = NDArray[np.float64]


class Law(Protocol):
    """A distribution, SI."""

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        ...


@frozen
class Uniform:
    """Every value between two bounds alike."""

    low: float
    high: float

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        drawn = self.low + (self.high - self.low) * probability
        return np.clip(drawn, self.low, self.high)


@frozen
class Normal:
    """Mean and standard deviation, of the distribution before it is cut off at the bounds."""

    mean: float
    spread: float
    low: float = -math.inf
    high: float = math.inf

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        from scipy.special import ndtri

        if math.isinf(self.low) and math.isinf(self.high):
            return np.asarray(self.mean + self.spread * ndtri(probability))
        low, high = (self.low - self.mean) / self.spread, (self.high - self.mean) / self.spread
        drawn = self.mean + self.spread * truncated_normal(probability, low, high)
        return np.clip(drawn, self.low, self.high)


@frozen
class Lognormal:
    """What exceeds a minimum has a logarithm that is normally distributed.

    median: of the excess; deviation: of its natural logarithm; both before it is cut off.
    """

    minimum: float
    median: float
    deviation: float
    low: float = -math.inf
    high: float = math.inf

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        logarithm = Normal(
            math.log(self.median),
            self.deviation,
            self._logarithm(self.low),
            self._logarithm(self.high),
        )
        drawn = self.minimum + np.exp(logarithm.quantile(probability))
        return np.clip(drawn, self.low, self.high)

    def _logarithm(self, bound: float) -> float:
        return math.log(bound - self.minimum) if bound > self.minimum else -math.inf


@frozen
class Weibull:
    """F = 1 − exp(−((x − minimum)/scale)^shape), before it is cut off."""

    minimum: float
    scale: float
    shape: float
    low: float = -math.inf
    high: float = math.inf

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        below, above = self.hazard(self.low), self.hazard(self.high)
        # −ln(1 − F), exact however far out the bounds
        hazard = below - np.log1p(probability * math.expm1(below - above))
        drawn = self.minimum + self.scale * hazard ** (1.0 / self.shape)
        return np.clip(drawn, self.low, self.high)

    def hazard(self, value: float) -> float:
        """Return −ln(1 − F) of a value: the cumulative hazard."""
        reach = (value - self.minimum) / self.scale
        try:
            return reach**self.shape if reach > 0.0 else 0.0
        except OverflowError:
            return math.inf


@frozen
class Triangular:
    """Density that rises in a line from the least value to the mode, and falls to the greatest."""

    low: float
    mode: float
    high: float

    def quantile(self, probability: Floats, /) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        width = self.high - self.low
        rising = self.low + np.sqrt(probability * width * (self.mode - self.low))
        falling = self.high - np.sqrt((1.0 - probability) * width * (self.high - self.mode))
        drawn = np.where(probability < (self.mode - self.low) / width, rising, falling)
        return np.clip(drawn, self.low, self.high)


def truncated_normal(probability: Floats, low: float, high: float) -> Floats:
    """Quantile of the standard normal distribution cut off at two bounds.

    In logarithms, and in the left tail whichever side it is: exact however far out the bounds.
    """
    from scipy.special import log_ndtr, ndtri_exp

    if low > 0.0:
        return -truncated_normal(1.0 - probability, -high, -low)
    below = np.log1p(-probability) + log_ndtr(low)
    return np.asarray(ndtri_exp(np.logaddexp(below, np.log(probability) + log_ndtr(high))))
