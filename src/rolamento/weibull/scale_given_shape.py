"""How probable a scale is, given the shape and a test; prior 1/η."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Self

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood

__all__ = ["GivenByGamma", "GivenByGrid"]

_NODES: Final = 401
_SUM_NODES: Final = 101
_AT_ONCE: Final = 1_000_000
_NEXT_TO_NOTHING: Final = 40.0


@dataclass(frozen=True, slots=True, eq=False)
class GivenByGamma:
    """Of a right-censored test: given β, η^(-β) has a gamma distribution.

    z: logarithms of the times, from the longest, which is at `middle`. log_total: ln Σ v t^β of the
    shapes that count. search: points of ln β that are looked at to find where the density lies.
    """

    z: FloatArray
    units: FloatArray
    sum_failed: float
    failures: float
    middle: float
    log_total: FloatArray
    search: int = 201

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Prepare a test."""
        y = np.log(test.times)
        longest = float(y.max())
        z = y - longest
        units = test.counts.astype(np.float64)
        sum_failed = float(units @ (z * test.failed))
        return cls(z, units, sum_failed, float(test.failures), longest, np.empty(0))

    def log_marginal(self, shape: FloatArray) -> FloatArray:
        """Logarithm of the likelihood of each shape, with the scale integrated away."""
        r = self.failures
        return np.asarray(
            (r - 1.0) * np.log(shape) + shape * self.sum_failed - r * self._log_total(shape)
        )

    def settled(self, shape: FloatArray) -> Self:
        """Prepare for the shapes that count."""
        return replace(self, log_total=self._log_total(shape))

    def below(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Probability, for each shape, that the logarithm of the scale is less."""
        from scipy.special import gammaincc

        with np.errstate(over="ignore"):
            x = np.exp(self.log_total - shape * (log_scale - self.middle))
        return np.asarray(gammaincc(self.failures, x))

    def _log_total(self, shape: FloatArray) -> FloatArray:
        step = max(_AT_ONCE // len(self.z), 1)
        parts = [shape[i : i + step, np.newaxis] for i in range(0, len(shape), step)]
        return np.concatenate([np.log(np.exp(part * self.z) @ self.units) for part in parts])


@dataclass(frozen=True, slots=True, eq=False)
class GivenByGrid:
    """Of an inspected test: given β, the likelihood over a grid of b = -β ln η.

    grid, cumulated: (shapes, nodes), b from `middle`, and the probability that b is greater.
    """

    likelihood: Likelihood
    middle: float
    grid: FloatArray
    cumulated: FloatArray
    search: int = 61

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Prepare a test."""
        likelihood = Likelihood.of(test)
        nothing = np.empty((0, 0))
        return cls(likelihood, likelihood.origin, nothing, nothing)

    def log_marginal(self, shape: FloatArray) -> FloatArray:
        """Logarithm of the likelihood of each shape, with the scale integrated away."""
        value, step = self._over_scale(shape, _SUM_NODES)[1:]
        top = value.max(axis=1)
        total = np.sum(np.exp(value - top[:, np.newaxis]), axis=1) * step
        return np.asarray(top + np.log(total) - np.log(shape))  # dη/η = db/β

    def settled(self, shape: FloatArray) -> GivenByGrid:
        """Prepare for the shapes that count."""
        b, value, _ = self._over_scale(shape, _NODES)
        density = np.exp(value - value.max(axis=1, keepdims=True))
        # the scale falls as b rises
        tail = np.cumsum(density[:, ::-1], axis=1)[:, ::-1] - 0.5 * density
        return GivenByGrid(
            self.likelihood, self.middle, b, tail / density.sum(axis=1, keepdims=True)
        )

    def below(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Probability, for each shape, that the logarithm of the scale is less."""
        b = -shape * (log_scale - self.middle)
        return np.array(
            [
                np.interp(x, grid, tail, left=1.0, right=0.0)
                for x, grid, tail in zip(b, self.grid, self.cumulated, strict=True)
            ]
        )

    def _over_scale(
        self, shape: FloatArray, nodes: int
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Grid of b around the best, of each shape; logarithm of the likelihood there; its step."""
        low, high = self._ends(shape)
        b = np.linspace(low, high, nodes, axis=1)
        value = np.stack([self.likelihood.value(shape, column) for column in b.T], axis=1)
        return b, np.where(np.isnan(value), -np.inf, value), (high - low) / (nodes - 1)

    def _ends(self, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Where the likelihood of each shape has fallen to next to nothing."""
        best = self._best(shape)
        top = self.likelihood.value(shape, best)
        ends = []
        for sign in (-1.0, 1.0):
            near, far = np.zeros_like(shape), np.ones_like(shape)
            for _ in range(12):
                value = self.likelihood.value(shape, best + sign * far)
                far = np.where(value > top - _NEXT_TO_NOTHING, 2.0 * far, far)
            for _ in range(20):
                middle = 0.5 * (near + far)
                value = self.likelihood.value(shape, best + sign * middle)
                high = value > top - _NEXT_TO_NOTHING
                near, far = np.where(high, middle, near), np.where(high, far, middle)
            ends.append(best + sign * far)
        return ends[0], ends[1]

    def _best(self, shape: FloatArray) -> FloatArray:
        """Best b of each shape, by bisection of the falling derivative."""
        low, high = np.full_like(shape, -800.0), np.full_like(shape, 800.0)
        for _ in range(60):
            middle = 0.5 * (low + high)
            rising = self.likelihood.at(shape, middle).b > 0.0
            low, high = np.where(rising, middle, low), np.where(rising, high, middle)
        return 0.5 * (low + high)
