"""Likelihood of lives of any kind: failed, suspended, failed between inspections.

In z = a ln t + b, with a = β and b = -β ln η, the logarithm of the likelihood is the sum of

    ln a + z - e^z - ln t            of a failure at t
    -e^z                             of a suspension at t
    ln(e^(-L) - e^(-U))              of a failure between two inspections, L, U = e^z there,

and it has no hollow in (a, b), for the density of z is log-concave: what Newton's method finds is
the one maximum.

Sources: Lawless (2003), chapter 5; Burridge (1981) for the concavity.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple, Self

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull.life_test import LifeTest

__all__ = ["Derivatives", "Likelihood"]


class Derivatives(NamedTuple):
    """Logarithm of the likelihood with its derivatives by a and b; each (lanes,)."""

    value: FloatArray
    a: FloatArray
    b: FloatArray
    aa: FloatArray
    ab: FloatArray
    bb: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Likelihood:
    """Rows of a life test by their kind, with how many bearings each stands for.

    failed, suspended: logarithms of times. lower, upper: of the inspections around a failure, lower
    minus infinity where there was none before. The counts are (rows,), or (lanes, rows) for many
    tests with the same times. Times count from exp(origin).
    """

    origin: float
    failed: FloatArray
    failed_counts: FloatArray
    suspended: FloatArray
    suspended_counts: FloatArray
    lower: FloatArray
    upper: FloatArray
    interval_counts: FloatArray

    @classmethod
    def of(cls, test: LifeTest, location: float = 0.0) -> Self:
        """Likelihood of a test whose lives begin at a location.

        Suspensions before the location tell nothing; a failure before it cannot be.
        """
        with np.errstate(divide="ignore", invalid="ignore"):
            y = np.log(test.times - location)
            low = np.log(np.maximum(test.lower - location, 0.0))
        counts = test.counts.astype(np.float64)
        interval = ~np.isnan(test.lower)
        exact = test.failed & ~interval
        suspended = ~test.failed & (test.times > location)
        known = y[test.failed | suspended]
        origin = float(known.mean())
        return cls(
            origin,
            y[exact] - origin,
            counts[exact],
            y[suspended] - origin,
            counts[suspended],
            low[interval] - origin,
            y[interval] - origin,
            counts[interval],
        )

    def lanes(self, which: BoolArray) -> Likelihood:
        """Return some of the lanes."""
        return replace(
            self,
            failed_counts=self.failed_counts[which],
            suspended_counts=self.suspended_counts[which],
            interval_counts=self.interval_counts[which],
        )

    @property
    def failures(self) -> FloatArray:
        """How many failed; 0-d, or (lanes,)."""
        return np.asarray(self.failed_counts.sum(axis=-1) + self.interval_counts.sum(axis=-1))

    def at(self, a: FloatArray, b: FloatArray) -> Derivatives:
        """Evaluate at a and b, counted from the origin; arrays (lanes,)."""
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            return self._sum(a, b)

    def _sum(self, a: FloatArray, b: FloatArray) -> Derivatives:
        parts = [
            part(a[:, np.newaxis], b[:, np.newaxis])
            for part, rows in (
                (self._failed, len(self.failed)),
                (self._suspended, len(self.suspended)),
                (self._intervals, len(self.upper)),
            )
            if rows
        ]
        return Derivatives(*(np.sum(terms, axis=0) for terms in zip(*parts, strict=True)))

    def value(self, a: FloatArray, b: FloatArray) -> FloatArray:
        """Logarithm of the likelihood alone; a and b as in `at`."""
        a, b = a[:, np.newaxis], b[:, np.newaxis]
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            z = a * self.failed + b
            total = np.sum(self.failed_counts * (np.log(a) + z - np.exp(z)), axis=-1)
            total -= np.sum(self.failed_counts * (self.failed + self.origin), axis=-1)
            total -= np.sum(self.suspended_counts * np.exp(a * self.suspended + b), axis=-1)
            risk, step = self._risks(a, b)
            between = self.interval_counts * (-risk + np.log(-np.expm1(-step)))
        return np.asarray(total + np.sum(between, axis=-1))

    def _risks(self, a: FloatArray, b: FloatArray) -> tuple[FloatArray, FloatArray]:
        """L, and U - L, of the failures between inspections."""
        seen = np.isfinite(self.lower)
        low = np.where(seen, self.lower, 0.0)
        risk = np.where(seen, np.exp(a * low + b), 0.0)
        near = risk * np.expm1(a * (self.upper - low))
        return risk, np.where(risk > 0.0, near, np.exp(a * self.upper + b))

    def _failed(self, a: FloatArray, b: FloatArray) -> Derivatives:
        y, n = self.failed, self.failed_counts
        z = a * y + b
        risk = n * np.exp(z)
        total = n.sum(axis=-1)
        constant = np.sum(n * (y + self.origin), axis=-1)
        alone, slope = a[:, 0], np.sum(n * y, axis=-1)
        return Derivatives(
            total * np.log(alone) + np.sum(n * z, axis=-1) - risk.sum(axis=1) - constant,
            total / alone + slope - np.sum(risk * y, axis=1),
            total - risk.sum(axis=1),
            -total / alone**2 - np.sum(risk * y * y, axis=1),
            -np.sum(risk * y, axis=1),
            -risk.sum(axis=1),
        )

    def _suspended(self, a: FloatArray, b: FloatArray) -> Derivatives:
        y = self.suspended
        risk = self.suspended_counts * np.exp(a * y + b)
        first, second = np.sum(risk * y, axis=1), np.sum(risk * y * y, axis=1)
        none = risk.sum(axis=1)
        return Derivatives(-none, -first, -none, -second, -first, -none)

    def _intervals(self, a: FloatArray, b: FloatArray) -> Derivatives:
        """With D = U - L and q = 1/(e^D - 1): ln(e^-L - e^-U) = -L + ln(1 - e^-D)."""
        n, up = self.interval_counts, self.upper
        low = np.where(np.isfinite(self.lower), self.lower, 0.0)
        risk_low, step = self._risks(a, b)
        risk_up = np.exp(a * up + b)
        q = 1.0 / np.expm1(step)
        value = -risk_low + np.log(-np.expm1(-step))
        bend = q * (1.0 + q)
        low_1, up_1 = -(1.0 + q) * risk_low, q * risk_up
        low_2, up_2 = low_1 - bend * risk_low**2, up_1 - bend * risk_up**2
        mixed = bend * risk_low * risk_up
        up_1, up_2, mixed = (np.where(np.isfinite(x), x, 0.0) for x in (up_1, up_2, mixed))
        return Derivatives(
            np.sum(n * value, axis=1),
            np.sum(n * (low_1 * low + up_1 * up), axis=1),
            np.sum(n * (low_1 + up_1), axis=1),
            np.sum(n * (low_2 * low * low + 2.0 * mixed * low * up + up_2 * up * up), axis=1),
            np.sum(n * (low_2 * low + mixed * (low + up) + up_2 * up), axis=1),
            np.sum(n * (low_2 + 2.0 * mixed + up_2), axis=1),
        )
