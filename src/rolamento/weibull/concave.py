"""Maximum of a likelihood of lives of any kind, by Newton's method, many samples at once.

For inspected tests, whose likelihood has no profile equation; the likelihood is concave in (a, b)
of `likelihood`, so that a damped Newton's method finds its one maximum from anywhere. There is none
where one time could stand for all failures with no bearing running longer (any steeper line fits
better), or where the data say that fewer fail as time goes on (β falls to zero).
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull import profile
from rolamento.weibull.likelihood import Derivatives, Likelihood

__all__ = ["NO_MAXIMUM", "ConcaveFit", "maximise"]

NO_MAXIMUM: Final = 5

_STEPS: Final = 100
_HALVINGS: Final = 40
_DECREMENT: Final = 1e-20
_NOISE: Final = 1e-13
_LEAST_STEP: Final = 0.2
_LEAST_SHAPE: Final = 1e-4


class ConcaveFit(NamedTuple):
    """a, b (counted from time 1), value, code: (lanes,); NaN where there is no maximum."""

    a: FloatArray
    b: FloatArray
    value: FloatArray
    code: NDArray[np.int64]


def maximise(likelihood: Likelihood) -> ConcaveFit:
    """Find the maximum for every lane."""
    lanes = max((n.shape[0] for n in _counts(likelihood) if n.ndim == 2), default=1)
    code = np.where(_no_spread(likelihood, lanes), profile.NO_SPREAD, profile.CONVERGED)
    failures = np.broadcast_to(likelihood.failures, (lanes,))
    code = np.where(failures == 0.0, profile.NO_FAILURES, code)
    a, b = _start(likelihood, lanes)
    good = code == profile.CONVERGED
    a, b, value, converged = _newton(likelihood, a, b, good)
    reach = _reach(likelihood)
    code = np.where(good & ~converged, profile.NOT_CONVERGED, code)
    code = np.where(good & ~converged & (a * reach < _LEAST_SHAPE), NO_MAXIMUM, code)
    fine = code == profile.CONVERGED
    b = b - a * likelihood.origin
    a, b, value = (np.where(fine, x, np.nan) for x in (a, b, value))
    return ConcaveFit(a, b, value, code)


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
            room = np.where(step_a < 0.0, -(1.0 - _LEAST_STEP) * a / step_a, np.inf)
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
    counts = [np.broadcast_to(n, (lanes, n.shape[-1])) for n in _counts(likelihood)]
    units = np.concatenate(counts, axis=1)
    failures = np.concatenate([counts[0], counts[1], np.zeros_like(counts[2])], axis=1)
    log_time = np.broadcast_to(np.concatenate(times), units.shape)
    fit = profile.fit_rows(profile.Rows(log_time, failures, units))
    found = fit.code == profile.CONVERGED
    a = np.where(found, fit.shape, 2.0 / max(_reach(likelihood), 0.2))
    with np.errstate(divide="ignore", invalid="ignore"):
        plain = -np.log(np.sum(units * np.exp(a[:, np.newaxis] * log_time), axis=1))
        plain += np.log(np.maximum(failures.sum(axis=1), 0.5))
    b = np.where(found, -a * fit.log_scale[0], plain)
    return a, np.where(np.isfinite(b), b, 0.0)


def _no_spread(likelihood: Likelihood, lanes: int) -> BoolArray:
    """One time could stand for all failures, and no bearing ran longer."""
    n_failed, n_interval, n_suspended = _counts(likelihood)
    longest = (
        (likelihood.failed, n_failed),
        (likelihood.lower, n_interval),
        (likelihood.suspended, n_suspended),
    )
    shortest = ((likelihood.failed, n_failed), (likelihood.upper, n_interval))
    low = np.max([_greatest(times, counts, lanes) for times, counts in longest], axis=0)
    high = -np.max([_greatest(-times, counts, lanes) for times, counts in shortest], axis=0)
    return np.asarray(low <= high)


def _greatest(times: FloatArray, counts: FloatArray, lanes: int) -> FloatArray:
    present = np.broadcast_to(counts > 0.0, (lanes, len(times)))
    return np.asarray(np.max(np.where(present, times, -np.inf), axis=1, initial=-np.inf))


def _counts(likelihood: Likelihood) -> tuple[FloatArray, FloatArray, FloatArray]:
    return likelihood.failed_counts, likelihood.interval_counts, likelihood.suspended_counts


def _reach(likelihood: Likelihood) -> float:
    """Distance of the shortest from the longest time, in logarithms."""
    low = likelihood.lower[np.isfinite(likelihood.lower)]
    times = np.concatenate([likelihood.failed, likelihood.suspended, low, likelihood.upper])
    return float(np.ptp(times))
