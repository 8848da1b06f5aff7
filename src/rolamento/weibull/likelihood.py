"""Likelihood of many life tests at once, and its maximum.

Lives may be failed, suspended, or failed between inspections. In z = a ln t + b, with a = β and
b = -β ln η, the logarithm of the likelihood is the sum of

    ln a + z - e^z - ln t            of a failure at t
    -e^z                             of a suspension at t
    ln(e^(-L) - e^(-U))              of a failure between two inspections, L, U = e^z there,

and it has no hollow in (a, b), for the density of z is log-concave: what Newton's method finds is
the one maximum.

Of right-censored lives, with d_i failures among the v_i bearings of row i, r = Σ d, the scale drops
out,

    η = (Σ v t^β / r)^(1/β),

and the shape is the one root of the profile equation

    Σ v t^β ln t / Σ v t^β - 1/β - Σ d ln t / r = 0,

whose left side rises with β from minus infinity. Groups that share a shape but not a scale have
r, and the sums over v, of their own:

    Σ_g r_g (Σ v t^β ln t / Σ v t^β)_g - r/β - Σ d ln t = 0.

There is no root where all failures fall together and no bearing ran longer. Times count from the
longest of each group, so that no power overflows.

Sources: Lawless (2003), chapter 5; Burridge (1981) for the concavity; Cohen (1965) and McCool
(1970) for the profile equation; for groups, McCool (1979).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.weibull.life_test import LifeTest

CONVERGED: Final = 0
NO_FAILURES: Final = 1
NO_SPREAD: Final = 3
NOT_CONVERGED: Final = 4
NO_MAXIMUM: Final = 5

_MINIMUM_SPREAD: Final = 1e-9
_TOLERANCE: Final = 1e-12
_AT_ONCE: Final = 60_000
_STEPS: Final = 100
_HALVINGS: Final = 40
_DECREMENT: Final = 1e-20
_NOISE: Final = 1e-13
_MINIMUM_STEP: Final = 0.2
_MINIMUM_SHAPE: Final = 1e-4


class Derivatives(NamedTuple):
    """Logarithm of the likelihood with its derivatives by a and b; each (lanes,)."""

    value: FloatArray
    a: FloatArray
    b: FloatArray
    aa: FloatArray
    ab: FloatArray
    bb: FloatArray


@frozen(eq=False)
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

        Suspensions before the location show nothing; a failure before it cannot be.
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
        """Number of failures; 0-d, or (lanes,)."""
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


# --- right-censored lives: the profile equation ---------------------------------------------------


class Rows(NamedTuple):
    """Right-censored lives of many samples.

    log_time: (samples, rows), of failure or suspension. failures, units: how many bearings failed
    at that time, and how many were under test until then and stopped, failed ones included; both
    (rows,) or (samples, rows). A row without units counts for nothing.
    """

    log_time: FloatArray
    failures: FloatArray
    units: FloatArray

    def part(self, which: slice | NDArray[np.bool_]) -> Rows:
        """Return some of the samples."""
        return Rows(*(array if array.ndim == 1 else array[which] for array in self))


class BatchFit(NamedTuple):
    """Fits of many samples; NaN where there is none.

    shape, code: (samples,). log_scale: (groups, samples), infinite for a group without failures.
    """

    shape: FloatArray
    log_scale: FloatArray
    code: NDArray[np.int64]


def fit_rows(rows: Rows) -> BatchFit:
    """Shape and scale of every sample; log_scale (1, samples)."""
    return fit_common_shape([rows])


def fit_common_shape(groups: Sequence[Rows]) -> BatchFit:
    """Shape that groups share, and the scale of each, for every sample.

    Parameters
    ----------
    groups : with the same number of samples each.
    """
    samples = len(groups[0].log_time)
    width = sum(rows.log_time.shape[1] for rows in groups)
    step = max(_AT_ONCE // width, 1)
    parts = [
        _fit_at_once([rows.part(slice(first, first + step)) for rows in groups])
        for first in range(0, samples, step)
    ]
    return joined(parts)


def joined(parts: Sequence[BatchFit]) -> BatchFit:
    """Put fits of samples one behind the other."""
    return BatchFit(
        np.concatenate([part.shape for part in parts]),
        np.concatenate([part.log_scale for part in parts], axis=1),
        np.concatenate([part.code for part in parts]),
    )


class _Group(NamedTuple):
    """A group with times from its longest: z ≤ 0, and the sums over its failures."""

    z: FloatArray
    units: FloatArray
    longest: FloatArray
    failures: FloatArray
    sum_failed: FloatArray

    def part(self, which: NDArray[np.bool_]) -> _Group:
        units = self.units if self.units.ndim == 1 else self.units[which]
        return _Group(
            self.z[which],
            units,
            self.longest[which],
            self.failures[which],
            self.sum_failed[which],
        )


def _fit_at_once(groups: Sequence[Rows]) -> BatchFit:
    """Fit so many samples as the processor's cache holds."""
    prepared = [_prepared(rows) for rows in groups]
    total = np.sum([group.failures for group in prepared], axis=0)
    reach = -np.sum([group.sum_failed for group in prepared], axis=0)
    code = np.full(len(total), CONVERGED, dtype=np.int64)
    code[reach <= _MINIMUM_SPREAD * total] = NO_SPREAD
    code[total == 0.0] = NO_FAILURES
    good = code == CONVERGED
    shape = np.full(len(total), np.nan)
    log_scale = np.full((len(groups), len(total)), np.nan)
    if np.any(good):
        fine = prepared if np.all(good) else [group.part(good) for group in prepared]
        shape[good], converged = _profile_root(fine, total[good], reach[good])
        code[good] = np.where(converged, CONVERGED, NOT_CONVERGED)
        log_scale[:, good] = [_log_scale(group, shape[good]) for group in fine]
    return BatchFit(shape, log_scale, code)


def _prepared(rows: Rows) -> _Group:
    log_time, failures, units = rows
    present = units > 0.0
    longest = np.max(np.where(present, log_time, -np.inf), axis=1, initial=-np.inf)
    longest = np.where(np.isfinite(longest), longest, 0.0)
    z = np.where(present, log_time - longest[:, np.newaxis], 0.0)
    each = np.broadcast_to(failures, z.shape)
    return _Group(z, units, longest, each.sum(axis=1), np.einsum("ij,ij->i", each, z))


def _profile_root(
    groups: Sequence[_Group], total: FloatArray, reach: FloatArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Root of the profile equation times β, which is nearly a straight line."""

    def function(shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        value, slope = reach.copy(), np.zeros_like(shape)
        for group in groups:
            mean, variance = _moments(group, shape)
            value += group.failures * mean
            slope += group.failures * variance
        return shape * value - total, value + shape * slope

    lower = total / reach
    return increasing_root(
        function, 1.3 * lower, lower, np.full_like(lower, np.inf), tolerance=_TOLERANCE
    )


def _moments(group: _Group, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Mean and variance of z, weighted with v t^β."""
    weight = np.exp(shape[:, np.newaxis] * group.z)
    weight *= group.units
    first = weight * group.z
    total = weight.sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):  # a group without bearings
        mean = first.sum(axis=1) / total
        variance = np.einsum("ij,ij->i", first, group.z) / total - mean * mean
    return np.nan_to_num(mean), np.nan_to_num(variance)


def _log_scale(group: _Group, shape: FloatArray) -> FloatArray:
    weight = np.exp(shape[:, np.newaxis] * group.z) * group.units
    with np.errstate(divide="ignore"):
        return np.asarray(
            group.longest + (np.log(weight.sum(axis=1)) - np.log(group.failures)) / shape
        )


# --- lives of any kind: Newton's method -----------------------------------------------------------


class ConcaveFit(NamedTuple):
    """a, b (counted from time 1), value, code: (lanes,); NaN where there is no maximum."""

    a: FloatArray
    b: FloatArray
    value: FloatArray
    code: NDArray[np.int64]


def maximise(likelihood: Likelihood) -> ConcaveFit:
    """Find the maximum of a likelihood of lives of any kind for every lane, by Newton's method.

    For inspected tests, whose likelihood has no profile equation; it is concave in (a, b), so that
    a damped Newton's method finds its one maximum from anywhere. There is none where one time could
    stand for all failures with no bearing running longer (any steeper line fits better), or where
    the data say that fewer fail as time goes on (β falls to zero).
    """
    lanes = max((n.shape[0] for n in _counts_of(likelihood) if n.ndim == 2), default=1)
    code = np.where(_no_spread(likelihood, lanes), NO_SPREAD, CONVERGED)
    failures = np.broadcast_to(likelihood.failures, (lanes,))
    code = np.where(failures == 0.0, NO_FAILURES, code)
    a, b = _start(likelihood, lanes)
    good = code == CONVERGED
    a, b, value, converged = _newton(likelihood, a, b, good)
    reach = _log_range(likelihood)
    code = np.where(good & ~converged, NOT_CONVERGED, code)
    code = np.where(good & ~converged & (a * reach < _MINIMUM_SHAPE), NO_MAXIMUM, code)
    fine = code == CONVERGED
    b = b - a * likelihood.origin
    a, b, value = (np.where(fine, x, np.nan) for x in (a, b, value))
    return ConcaveFit(a, b, value, code)


def fits_of(likelihood: Likelihood) -> BatchFit:
    """Fit shape and scale of every lane of a likelihood."""
    fit = maximise(likelihood)
    return BatchFit(fit.a, (-fit.b / fit.a)[np.newaxis], fit.code)


def _newton(
    likelihood: Likelihood, a: FloatArray, b: FloatArray, active: BoolArray
) -> tuple[FloatArray, FloatArray, FloatArray, BoolArray]:
    here = likelihood.at(a, b)
    converged = np.zeros_like(active)
    for _ in range(_STEPS):
        step_a, step_b, decrement = _step(here, a)
        settled = decrement <= _DECREMENT * np.maximum(1.0, np.abs(here.value))
        converged |= active & settled
        open_ = active & ~converged & np.isfinite(decrement)
        if not np.any(open_):
            break
        length = np.where(open_, 1.0, 0.0)
        # a stays above zero
        with np.errstate(divide="ignore", invalid="ignore"):
            room = np.where(step_a < 0.0, -(1.0 - _MINIMUM_STEP) * a / step_a, np.inf)
        length = np.minimum(length, room)
        for _ in range(_HALVINGS):
            there = likelihood.at(a + length * step_a, b + length * step_b)
            noise = _NOISE * np.maximum(1.0, np.abs(here.value))
            worse = open_ & ~(there.value >= here.value - noise)
            if not np.any(worse):
                break
            length = np.where(worse, 0.5 * length, length)
        still = open_ & (np.abs(length * step_a) <= 1e-15 * a) & (length > 0.0)
        a, b, here = a + length * step_a, b + length * step_b, there
        converged |= still & (decrement <= 1e-10 * np.maximum(1.0, np.abs(here.value)))
    return a, b, here.value, converged


def _step(here: Derivatives, a: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Newton's step, and how much the value could rise by it, twice."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        determinant = here.aa * here.bb - here.ab**2
        step_a = (here.ab * here.b - here.bb * here.a) / determinant
        step_b = (here.ab * here.a - here.aa * here.b) / determinant
        decrement = here.a * step_a + here.b * step_b
    usable = np.isfinite(decrement) & (determinant > 0.0)
    return (
        np.where(usable, step_a, 0.0),
        np.where(usable, step_b, 0.0),
        np.where(usable, np.maximum(decrement, 0.0), np.nan),
    )


def _start(likelihood: Likelihood, lanes: int) -> tuple[FloatArray, FloatArray]:
    """Maximum with each failure in the (geometric) middle of its interval, or something like it."""
    low = np.where(np.isfinite(likelihood.lower), likelihood.lower, likelihood.upper - 1.0)
    times = [likelihood.failed, 0.5 * (low + likelihood.upper), likelihood.suspended]
    counts = [np.broadcast_to(n, (lanes, n.shape[-1])) for n in _counts_of(likelihood)]
    units = np.concatenate(counts, axis=1)
    failures = np.concatenate([counts[0], counts[1], np.zeros_like(counts[2])], axis=1)
    log_time = np.broadcast_to(np.concatenate(times), units.shape)
    fit = fit_rows(Rows(log_time, failures, units))
    found = fit.code == CONVERGED
    a = np.where(found, fit.shape, 2.0 / max(_log_range(likelihood), 0.2))
    with np.errstate(divide="ignore", invalid="ignore"):
        plain = -np.log(np.sum(units * np.exp(a[:, np.newaxis] * log_time), axis=1))
        plain += np.log(np.maximum(failures.sum(axis=1), 0.5))
    b = np.where(found, -a * fit.log_scale[0], plain)
    return a, np.where(np.isfinite(b), b, 0.0)


def _no_spread(likelihood: Likelihood, lanes: int) -> BoolArray:
    """One time could stand for all failures, and no bearing ran longer."""
    n_failed, n_interval, n_suspended = _counts_of(likelihood)
    longest = (
        (likelihood.failed, n_failed),
        (likelihood.lower, n_interval),
        (likelihood.suspended, n_suspended),
    )
    shortest = ((likelihood.failed, n_failed), (likelihood.upper, n_interval))
    low = np.max([_longest(times, counts, lanes) for times, counts in longest], axis=0)
    high = -np.max([_longest(-times, counts, lanes) for times, counts in shortest], axis=0)
    return np.asarray(low <= high)


def _longest(times: FloatArray, counts: FloatArray, lanes: int) -> FloatArray:
    present = np.broadcast_to(counts > 0.0, (lanes, len(times)))
    return np.asarray(np.max(np.where(present, times, -np.inf), axis=1, initial=-np.inf))


def _counts_of(likelihood: Likelihood) -> tuple[FloatArray, FloatArray, FloatArray]:
    return likelihood.failed_counts, likelihood.interval_counts, likelihood.suspended_counts


def _log_range(likelihood: Likelihood) -> float:
    """Distance of the shortest from the longest time, in logarithms."""
    low = likelihood.lower[np.isfinite(likelihood.lower)]
    times = np.concatenate([likelihood.failed, likelihood.suspended, low, likelihood.upper])
    return float(np.ptp(times))
