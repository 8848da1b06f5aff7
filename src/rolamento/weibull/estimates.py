"""Fits of a Weibull distribution to a life test: maximum likelihood, a known shape, ranks.

*Maximum likelihood* of two parameters is the fit that everything else is measured by. Suspensions
count with the time that they ran.

*A known shape* from experience leaves only the scale to the test ("Weibayes"). The times t^β are
exponential then: η^β = Σ v t^β / r, and 2 Σ v t^β / η^β has a chi-square distribution: with 2r
degrees of freedom where the test ended with a failure; where it was ended by the clock 2r + 2 are
on the safe side for the lower bound. So it bounds the life from below even if nothing failed:

    η > (2 Σ v t^β / χ²_{C; 2r+2})^(1/β).

*Three parameters*: with a time γ before which nothing fails. For every γ below the first failure
the two-parameter fit of the times beyond it gives the profile of the likelihood. As γ nears a first
failure that is known exactly, with β < 1, the profile grows without bound: that spike shows
nothing. What is taken is the greatest of the maxima before it and of the value at γ = 0, since no
bearing fails before it runs. If the profile rises all the way to the spike there is no estimate.

*Ranks.* The i-th of n failures has the median rank, the median of the Beta(i, n + 1 - i)
distribution, close to (i - 0.3)/(n + 0.4). A suspension takes an unknown place among the later
failures; Johnson gives a failure with m bearings still running, itself included, the rank

    i_new = i_old + (n + 1 - i_old)/(1 + m),

so that n + 1 - i is a product over the failures. Failures at the same time take successive ranks,
and a failure comes before a suspension at the same time. On the Weibull plot a straight line goes
through the ranked failures by least squares, ln ln 1/(1 - F) = β ln t - β ln η: either the ordinate
is regressed on ln t ("Y on X") or ln t on the ordinate ("X on Y"), which makes the line steeper by
1/correlation². At a known shape only the place of the line is fitted: it passes through the mean
of the points either way. Of suspensions only the order counts, not how long they ran.

Sources: Abernethy (2006), chapters 2 and 6; Epstein and Sobel (1953); Rockette, Antle and Klimko
(1974); Lawless (2003), section 5.4; Johnson (1964); Benard and Bos-Levenbach (1953); IEC
61649:2008.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.validate import numbers, one_of, whole_number
from rolamento.weibull.fit import Estimand, WeibullFit, plot_ordinate
from rolamento.weibull.life_test import MAXIMUM_UNITS, LifeTest
from rolamento.weibull.likelihood import (
    CONVERGED,
    NO_FAILURES,
    NO_MAXIMUM,
    NO_SPREAD,
    NOT_CONVERGED,
    Likelihood,
    Rows,
    fit_rows,
    fits_of,
    maximise,
)
from rolamento.weibull.limits import shape_of
from rolamento.words import Note, said

Ranks = Literal["median", "benard"]
Regression = Literal["x_on_y", "y_on_x"]

CODES: Final = {
    CONVERGED: "converged",
    NO_FAILURES: "no_failures",
    NO_SPREAD: "no_spread",
    NOT_CONVERGED: "not_converged",
    NO_MAXIMUM: "no_maximum",
}
FEW: Final = 5
ENDED_BY_FAILURES: Final = ("complete", "type_ii", "sudden_death")

_METHOD: Final = "three_parameter"
_POINTS: Final = 241
_POINTS_INSPECTED: Final = 61
_NEAREST: Final = 1e-8
_ROUNDS: Final = 60
_AT_ONCE: Final = 1_000_000
_GOLDEN: Final = 0.5 * (5.0**0.5 - 1.0)


def maximum_likelihood(test: LifeTest | ArrayLike) -> WeibullFit:
    """Fit shape and scale by maximum likelihood.

    Parameters
    ----------
    test
        With any kind of censoring; or times alone, of bearings that all failed. So all functions
        here take a test.

    Returns
    -------
    WeibullFit
        Without numbers for fewer than two failures, or where all fall together.
    """
    test = LifeTest.of(test)
    code = _too_few(test)
    if code:
        return WeibullFit.without(test, "maximum_likelihood", code)
    fit = fits_of(Likelihood.of(test)) if test.inspected else fit_rows(rows_of(test))
    code = CODES[int(fit.code[0])]
    if code != "converged":
        return WeibullFit.without(test, "maximum_likelihood", code)
    shape, log_scale = float(fit.shape[0]), float(fit.log_scale[0, 0])
    return _fitted(test, "maximum_likelihood", shape, float(np.exp(log_scale)))


def rows_of(test: LifeTest) -> Rows:
    """Give a right-censored test as one sample for the batch fit."""
    counts = test.counts.astype(np.float64)
    return Rows(np.log(test.times)[np.newaxis], counts * test.failed, counts)


def _too_few(test: LifeTest) -> str:
    """Return the code of a test that has too few failures for a shape; empty otherwise."""
    return {0: "no_failures", 1: "one_failure"}.get(test.failures, "")


def _fitted(test: LifeTest, method: str, shape: float, scale: float, **more: float) -> WeibullFit:
    """Give the record of a fit to a test, with its likelihood and what to note."""
    location = more.get("location", 0.0)
    value = log_likelihood(test, shape, scale, location)
    notes = (Note("few_failures"),) if test.failures < FEW else ()
    return WeibullFit(
        method,
        "converged",
        shape,
        scale,
        log_likelihood=value,
        failures=test.failures,
        size=test.size,
        unit=test.unit,
        notes=notes,
        **more,
    )


def log_likelihood(test: LifeTest, shape: float, scale: float, location: float = 0.0) -> float:
    """Logarithm of the likelihood of a test under a Weibull distribution."""
    likelihood = Likelihood.of(test, location)
    a, b = np.array([shape]), np.array([shape * (likelihood.origin - np.log(scale))])
    return float(likelihood.at(a, b).value[0])


# --- a known shape --------------------------------------------------------------------------------


def fixed_shape(test: LifeTest | ArrayLike, shape: float) -> WeibullFit:
    """Fit the scale by maximum likelihood at a known shape.

    Parameters
    ----------
    test
        With any kind of censoring; one failure is enough.
    shape
        β, from earlier tests of the same kind.

    Returns
    -------
    WeibullFit
        With the shape but no scale if nothing failed (see `fixed_shape_limits`).
    """
    test, beta = LifeTest.of(test), shape_of(shape)
    if not test.failures:
        return replace(
            WeibullFit.without(test, "fixed_shape", "no_failures"), shape=beta, location=0.0
        )
    log_scale = _log_scale_at(test, beta)
    if not np.isfinite(log_scale):
        return WeibullFit.without(test, "fixed_shape", "no_maximum")
    return _fitted(test, "fixed_shape", beta, float(np.exp(log_scale)))


def fixed_shape_limits(
    test: LifeTest, shape: float, quantity: Estimand, tails: FloatArray
) -> FloatArray:
    """Limits of a life or a reliability at a known shape.

    Parameters
    ----------
    test
        With any kind of censoring, and any number of failures.
    shape
        β.
    quantity
        A life, the scale, or a reliability.
    tails
        (limits,) probability of being below the limit: 0.05 for a lower limit at 95 %.

    Returns
    -------
    (limits,); infinite, or 1, for an upper limit without failures.
    """
    from scipy.stats import chi2

    beta = shape_of(shape)
    limits = []
    for tail in tails:
        freedom, log_total = _chi_square_evidence(test, beta, lower=bool(tail < 0.5))
        point = chi2.ppf(1.0 - tail, freedom) if freedom else 0.0
        with np.errstate(divide="ignore"):
            limits.append((np.log(2.0) + log_total - np.log(point)) / beta)
    return quantity.at(np.full(len(limits), beta), np.array(limits))


def fixed_shape_tails(
    test: LifeTest, shape: float, quantity: Estimand, life: float
) -> tuple[float, float]:
    """Confidence with which a life is less, and more, than a value, at a known shape.

    Both on the safe side; parameters as of `fixed_shape_limits`.
    """
    from scipy.stats import chi2

    beta = shape_of(shape)
    log_risk = quantity.log_risk - beta * np.log(life)
    tails = []
    for lower in (True, False):
        freedom, log_total = _chi_square_evidence(test, beta, lower=lower)
        with np.errstate(over="ignore"):
            point = 2.0 * np.exp(log_total + log_risk)
        below = float(chi2.cdf(point, freedom)) if freedom else 0.0
        tails.append(1.0 - below if lower else (below if freedom else 1.0))
    return tails[0], tails[1]


def _chi_square_evidence(test: LifeTest, shape: float, *, lower: bool) -> tuple[int, float]:
    """Degrees of freedom, and ln Σ v t^β, for a lower or an upper limit."""
    exact = test.scheme in ENDED_BY_FAILURES
    freedom = 2 * test.failures + (2 if lower and not exact else 0)
    # an inspected failure counts from where it was last seen whole, or to where it was found
    early = lower & ~np.isnan(test.lower)
    with np.errstate(divide="ignore"):
        log_time = np.log(np.where(early, test.lower, test.times))
    longest = float(log_time.max())
    if not np.isfinite(longest):
        return freedom, -np.inf
    total = np.sum(test.counts * np.exp(shape * (log_time - longest)))
    return freedom, shape * longest + float(np.log(total))


def _log_scale_at(test: LifeTest, shape: float) -> float:
    """Logarithm of the scale that fits best at a shape; NaN where there is none."""
    if not test.inspected:
        y = np.log(test.times)
        longest = y.max()
        total = np.log(np.sum(test.counts * np.exp(shape * (y - longest))))
        return float(longest + (total - np.log(test.failures)) / shape)
    likelihood = Likelihood.of(test)
    a = np.array([shape])

    def falling(level: FloatArray) -> tuple[FloatArray, FloatArray]:
        here = likelihood.at(a, np.log(level))
        return -here.b, -here.bb / level

    middle = np.concatenate([likelihood.failed, likelihood.suspended, likelihood.upper])
    start = np.exp(-shape * np.array([middle.mean()]))
    root, converged = increasing_root(falling, start, np.array([0.0]), np.array([np.inf]))
    if not converged[0]:
        return float("nan")
    return float(likelihood.origin - np.log(root[0]) / shape)


# --- three parameters -----------------------------------------------------------------------------


def three_parameter(test: LifeTest | ArrayLike) -> WeibullFit:
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
    test = LifeTest.of(test)
    code = _too_few(test) or ("no_maximum" if test.failures < 3 else "")
    if code:
        return WeibullFit.without(test, _METHOD, code)
    first = float(test.times[test.failed].min())
    # dense toward the first failure, where a maximum is narrow
    points = _POINTS_INSPECTED if test.inspected else _POINTS
    gaps = first * np.geomspace(1.0, _NEAREST, points)
    grid = np.append(0.0, (first - gaps)[1:])
    over_grid = _profile_over(test, grid)
    if not np.isfinite(over_grid[0]):
        return WeibullFit.without(test, _METHOD, "no_spread")
    location = _best_location(test, grid, over_grid)
    if location is None:
        return WeibullFit.without(test, _METHOD, "no_maximum")
    shape, scale = _shape_and_scale(test, location)
    fit = _fitted(test, _METHOD, shape, scale, location=location)
    if location == 0.0:
        fit = fit.with_notes(Note("location_at_zero"))
    return fit.with_notes(Note("likelihood_unbounded")) if _unbounded(test, first) else fit


def _best_location(test: LifeTest, grid: FloatArray, value: FloatArray) -> float | None:
    """Location of the highest maximum before the spike."""
    inner = np.flatnonzero((value[1:-1] >= value[:-2]) & (value[1:-1] > value[2:])) + 1
    candidates = [_golden_section(test, grid[i - 1], grid[i + 1]) for i in inner]
    if value[0] > value[1]:
        candidates.append((float(value[0]), 0.0))
    return max(candidates)[1] if candidates else None


def _golden_section(test: LifeTest, low: float, high: float) -> tuple[float, float]:
    """Maximum of the profile between two locations, by golden section: value, location."""
    left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_left, at_right = _profile_over(test, np.array([left, right]))
    for _ in range(_ROUNDS):
        if at_left >= at_right:
            high, right, at_right = right, left, at_left
            left = high - _GOLDEN * (high - low)
            at_left = _profile_over(test, np.array([left]))[0]
        else:
            low, left, at_left = left, right, at_right
            right = low + _GOLDEN * (high - low)
            at_right = _profile_over(test, np.array([right]))[0]
    return max((float(at_left), float(left)), (float(at_right), float(right)))


def _profile_over(test: LifeTest, locations: FloatArray) -> FloatArray:
    """Logarithm of the likelihood at each location, at the best shape and scale."""
    if test.inspected:
        return np.array([maximise(Likelihood.of(test, g)).value[0] for g in locations])
    step = max(_AT_ONCE // len(test), 1)
    if len(locations) > step:
        parts = [locations[i : i + step] for i in range(0, len(locations), step)]
        return np.concatenate([_profile_over(test, part) for part in parts])
    with np.errstate(divide="ignore", invalid="ignore"):
        y = np.log(test.times - locations[:, np.newaxis])
    present = np.isfinite(y)
    y = np.where(present, y, 0.0)
    failures = np.broadcast_to((test.counts * test.failed).astype(np.float64), y.shape)
    fit = fit_rows(Rows(y, failures, np.where(present, test.counts, 0.0)))
    r = float(test.failures)
    # at the best scale Σ v (t/η)^β is r
    return np.asarray(
        r * np.log(fit.shape)
        - fit.shape * r * fit.log_scale[0]
        + (fit.shape - 1.0) * np.sum(failures * y, axis=1)
        - r
    )


def _shape_and_scale(test: LifeTest, location: float) -> tuple[float, float]:
    if test.inspected:
        fit = maximise(Likelihood.of(test, location))
        return float(fit.a[0]), float(np.exp(-fit.b[0] / fit.a[0]))
    present: BoolArray = test.times > location
    counts = test.counts[present].astype(np.float64)
    y = np.log(test.times[present] - location)[np.newaxis]
    batch = fit_rows(Rows(y, counts * test.failed[present], counts))
    return float(batch.shape[0]), float(np.exp(batch.log_scale[0, 0]))


def _unbounded(test: LifeTest, first: float) -> bool:
    """Return whether the first failure is known exactly, so that the spike is there."""
    exact = test.failed & np.isnan(test.lower)
    return bool(np.any(exact & (test.times == first)))


# --- ranks ----------------------------------------------------------------------------------------


@frozen(eq=False)
class PlottingPositions:
    """Where the failures stand on a Weibull plot, in the order of their times.

    Attributes
    ----------
    times
        (failures,) of failure; unit of the test
    rank
        (failures,) adjusted for suspensions
    failed_share
        (failures,) F: share of the bearings taken to have failed by then, 0 to 1
    """

    times: FloatArray
    rank: FloatArray
    failed_share: FloatArray

    @property
    def x(self) -> FloatArray:
        """Abscissa ln t of the Weibull plot."""
        return np.asarray(np.log(self.times))

    @property
    def y(self) -> FloatArray:
        """Ordinate ln ln 1/(1 - F) of the Weibull plot."""
        return plot_ordinate(self.failed_share)


def plotting_positions(test: LifeTest | ArrayLike, ranks: Ranks = "median") -> PlottingPositions:
    """Rank the failures of a test.

    Parameters
    ----------
    test
        Complete or right-censored.
    ranks
        "median" (exact, of the beta distribution) or "benard" (the approximation).

    Raises
    ------
    InputError
        For an inspected test, whose times of failure are not known.
    """
    one_of(ranks, "ranks", get_args(Ranks))
    test = LifeTest.of(test)
    if test.inspected:
        raise InputError(
            said(
                "ranks need failure times, which inspections do not give; fit by maximum likelihood"
            ),
            field="lower",
        )
    order = np.lexsort((~test.failed, test.times))
    counts, failed = test.counts[order], test.failed[order]
    before = np.cumsum(counts) - counts
    ones = np.repeat(before[failed], counts[failed])
    # successive places of failures that share a row
    start = np.repeat(np.cumsum(counts[failed]) - counts[failed], counts[failed])
    running = test.size - ones - (np.arange(len(ones)) - start)
    product = np.cumprod(running / (running + 1.0), dtype=np.float64)
    rank = np.asarray((test.size + 1.0) * (1.0 - product))
    times = np.asarray(np.repeat(test.times[order][failed], counts[failed]))
    return PlottingPositions(times, rank, median_rank(rank, test.size, ranks))


def median_rank(rank: ArrayLike, size: int, ranks: Ranks = "median") -> FloatArray:
    """Share taken to have failed at a rank, which need not be whole, among so many bearings.

    Raises
    ------
    InputError
        If a rank is not above 0, or above the size.

    >>> print(f"{median_rank(1, 1):.1f}")
    0.5
    """
    one_of(ranks, "ranks", get_args(Ranks))
    i = numbers(rank, "rank", "[1, 2, 3]")
    n = whole_number(size, "size", 1, MAXIMUM_UNITS)
    if np.any(~((i > 0.0) & (i <= n))):
        raise InputError(said("must be above 0 and at most the size"), field="rank", example="1")
    if ranks == "benard":
        return np.asarray((i - 0.3) / (n + 0.4))
    from scipy.special import betaincinv

    return np.asarray(betaincinv(i, n + 1.0 - i, 0.5))


def rank_regression(
    test: LifeTest | ArrayLike,
    regression: Regression = "x_on_y",
    ranks: Ranks = "median",
    *,
    shape: float | None = None,
) -> WeibullFit:
    """Fit shape and scale by rank regression; or the scale alone, at a known shape.

    Parameters
    ----------
    test
        Complete or right-censored.
    regression
        "x_on_y": distances along the times are least, as IEC 61649 has it. "y_on_x": along the
        ordinate, as a spreadsheet does it.
    ranks
        "median" or "benard".
    shape
        β from experience: the line of that slope through the mean of the points, which is the same
        whatever is regressed on what; one failure is enough.

    Returns
    -------
    WeibullFit
        Without numbers for fewer than two different times of failure.

    Raises
    ------
    InputError
        For an inspected test.
    """
    one_of(regression, "regression", get_args(Regression))
    test = LifeTest.of(test)
    points = plotting_positions(test, ranks)
    method = f"rank_regression_{regression}"
    x, y = points.x, points.y
    if shape is not None:
        known = shape_of(shape)
        if not test.failures:
            return WeibullFit.without(test, method, "no_failures")
        return _fitted(test, method, known, float(np.exp(x.mean() - y.mean() / known)))
    code = _too_few(test)
    if not code and np.ptp(x) <= 1e-12 * max(1.0, float(np.abs(x).max())):
        code = "no_spread"
    if code:
        return WeibullFit.without(test, method, code)
    dx, dy = x - x.mean(), y - y.mean()
    xx, xy, yy = float(dx @ dx), float(dx @ dy), float(dy @ dy)
    slope = xy / xx if regression == "y_on_x" else yy / xy
    scale = float(np.exp(x.mean() - y.mean() / slope))
    fit = _fitted(test, method, slope, scale, correlation=xy / (xx * yy) ** 0.5)
    early = ~test.failed & (test.times < test.times[test.failed].min())
    if 2 * int(test.counts[early].sum()) > test.suspensions > 0:
        return fit.with_notes(Note("suspensions_early"))
    return fit
