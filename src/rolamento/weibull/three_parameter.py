"""Maximum likelihood of three parameters: with a time γ before which nothing fails.

For every γ below the first failure the two-parameter fit of the times beyond it gives the profile
of the likelihood. As γ nears a first failure that is known exactly, with β < 1, the profile grows
without bound: that spike tells nothing. What is taken is the greatest of the maxima before it and
of the value at γ = 0, since no bearing fails before it runs. If the profile rises all the way to
the spike there is no estimate.

Sources: Rockette, Antle and Klimko (1974); Lawless (2003), section 5.4.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull import concave, profile
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.maximum_likelihood import found, too_few

__all__ = ["three_parameter"]

_METHOD: Final = "three_parameter"
_POINTS: Final = 241
_POINTS_INSPECTED: Final = 61
_NEAREST: Final = 1e-8
_ROUNDS: Final = 60
_AT_ONCE: Final = 1_000_000
_GOLDEN: Final = 0.5 * (5.0**0.5 - 1.0)


def three_parameter(test: LifeTest) -> WeibullFit:
    """Fit shape, scale and location by maximum likelihood.

    Parameters
    ----------
    test
        With any kind of censoring; at least three failures.

    Returns
    -------
    WeibullFit
        Code "no_maximum" where the likelihood only grows toward the first failure, or there are
        fewer than three failures. The scale counts from the location.
    """
    code = too_few(test) or ("no_maximum" if test.failures < 3 else "")
    if code:
        return WeibullFit.without(test, _METHOD, code)
    first = float(test.times[test.failed].min())
    # dense toward the first failure, where a maximum is narrow
    points = _POINTS_INSPECTED if test.inspected else _POINTS
    gaps = first * np.geomspace(1.0, _NEAREST, points)
    grid = np.append(0.0, (first - gaps)[1:])
    profile_ = _profile(test, grid)
    if not np.isfinite(profile_[0]):
        return WeibullFit.without(test, _METHOD, "no_spread")
    location = _best(test, grid, profile_)
    if location is None:
        return WeibullFit.without(test, _METHOD, "no_maximum")
    shape, scale = _at(test, location)
    fit = found(test, _METHOD, shape, scale, location=location)
    if location == 0.0:
        fit = fit.with_notes("location_at_zero")
    return fit.with_notes("likelihood_unbounded") if _unbounded(test, first) else fit


def _best(test: LifeTest, grid: FloatArray, value: FloatArray) -> float | None:
    """Location of the greatest maximum before the spike."""
    inner = np.flatnonzero((value[1:-1] >= value[:-2]) & (value[1:-1] > value[2:])) + 1
    candidates = [_refined(test, grid[i - 1], grid[i + 1]) for i in inner]
    if value[0] > value[1]:
        candidates.append((float(value[0]), 0.0))
    return max(candidates)[1] if candidates else None


def _refined(test: LifeTest, low: float, high: float) -> tuple[float, float]:
    """Maximum of the profile between two locations, by golden section: value, location."""
    left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_left, at_right = _profile(test, np.array([left, right]))
    for _ in range(_ROUNDS):
        if at_left >= at_right:
            high, right, at_right = right, left, at_left
            left = high - _GOLDEN * (high - low)
            at_left = _profile(test, np.array([left]))[0]
        else:
            low, left, at_left = left, right, at_right
            right = low + _GOLDEN * (high - low)
            at_right = _profile(test, np.array([right]))[0]
    return max((float(at_left), float(left)), (float(at_right), float(right)))


def _profile(test: LifeTest, locations: FloatArray) -> FloatArray:
    """Logarithm of the likelihood at each location, at the best shape and scale."""
    if test.inspected:
        return np.array([concave.maximise(Likelihood.of(test, g)).value[0] for g in locations])
    step = max(_AT_ONCE // len(test), 1)
    if len(locations) > step:
        parts = [locations[i : i + step] for i in range(0, len(locations), step)]
        return np.concatenate([_profile(test, part) for part in parts])
    with np.errstate(divide="ignore", invalid="ignore"):
        y = np.log(test.times - locations[:, np.newaxis])
    present = np.isfinite(y)
    y = np.where(present, y, 0.0)
    failures = np.broadcast_to((test.counts * test.failed).astype(np.float64), y.shape)
    fit = profile.fit_rows(profile.Rows(y, failures, np.where(present, test.counts, 0.0)))
    r = float(test.failures)
    # at the best scale Σ v (t/η)^β is r
    return np.asarray(
        r * np.log(fit.shape)
        - fit.shape * r * fit.log_scale[0]
        + (fit.shape - 1.0) * np.sum(failures * y, axis=1)
        - r
    )


def _at(test: LifeTest, location: float) -> tuple[float, float]:
    if test.inspected:
        fit = concave.maximise(Likelihood.of(test, location))
        return float(fit.a[0]), float(np.exp(-fit.b[0] / fit.a[0]))
    present: BoolArray = test.times > location
    counts = test.counts[present].astype(np.float64)
    y = np.log(test.times[present] - location)[np.newaxis]
    batch = profile.fit_rows(profile.Rows(y, counts * test.failed[present], counts))
    return float(batch.shape[0]), float(np.exp(batch.log_scale[0, 0]))


def _unbounded(test: LifeTest, first: float) -> bool:
    """Tell whether the first failure is known exactly, so that the spike is there."""
    exact = test.failed & np.isnan(test.lower)
    return bool(np.any(exact & (test.times == first)))
