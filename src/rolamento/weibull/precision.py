"""Planning the precision of a life: how many failures bring its bounds so near each other.

A test of g groups of m bearings each stops a group at its first failure, and all at the r-th of
them. Groups of one are the plain test, in which all fail (r = g) or which stops at the r-th failure
of n; greater groups are sudden death. A group's life has the shape β of its bearings, and the scale
η m^(-1/β): the test of the groups is a plain one, and a life t_R of the bearings is a life t_(R^m)
of the groups.

Of fits to such tests W = β̂/β and U = β̂ ln(t̂_R/t_R) have distributions that know no β and η; with
u_p the quantiles of U, the bounds with the confidence C are in the ratio

    upper/lower = exp((u_((1+C)/2) - u_((1-C)/2))/(β W)),

which itself varies from test to test, by W. Its median is what a plan is judged by, as McCool does,
beside the ratio that only one test in ten exceeds. The distributions are drawn, by the engine that
fits real tests.

*When a failure comes.* The share of a population that has failed when the r-th of n does has a
Beta(r, n + 1 - r) distribution, and a time is t = η (-ln(1 - F))^(1/β) of it. Percentiles follow at
once. Means have a closed form whose terms alternate in sign and cancel when there are many; here
they are summed over ln t, where the density falls off at both ends, so that the trapezoidal rule is
as good as exact.

Sources: Johnson (1964) for sudden death; McCool (1970, 1974); Lieblein (1955) for the moments;
David and Nagaraja (2003) for order statistics.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict
from functools import lru_cache
from math import ceil, exp, inf, isfinite, log, nan
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, generator, number, share, whole_number
from rolamento.weibull.drawing import FirstFailures, draw_fits
from rolamento.weibull.likelihood import CONVERGED
from rolamento.weibull.limits import sample_count
from rolamento.weibull.planning import (
    MAXIMUM_BEARINGS,
    advice_on_plan,
    planned_shape,
    status_of_plan,
)
from rolamento.words import Note, said

MAXIMUM_FAILURES: Final = 1000
MAXIMUM_RIGS: Final = 20_000
MAXIMUM_RIG_SIZE: Final = 1000
_RARELY: Final = 0.9
_EVALUATIONS: Final = 80
_GUESSES: Final = 12
_FIRST_GUESS: Final = 10

Evaluate = Callable[[int], float]
Progress = Callable[[int, int], None]
_POINTS: Final = 801
_NEXT_TO_NOTHING: Final = 1e-18
_RANKS_AT_ONCE: Final = 1000


@frozen
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
        return {name: finite(value) for name, value in asdict(self).items()}


@frozen(eq=False)
class LifeTestPlan:
    """A life test before it is made, and what may be expected of it; NaN where nothing may.

    Attributes
    ----------
    code
        "planned", or why there is no plan, a code that `advice` explains
    groups, group_size, failures
        g groups of m bearings, each stopped at its first failure; all stopped at the r-th failure
    life, reliability
        that the bearings are expected to have: times are in its unit
    shape
        β, that they are expected to have
    confidence
        of the bounds
    ratio
        upper over lower bound of the life, median over such tests
    ratio_rarely_exceeded
        the same, exceeded in one test of ten
    shape_ratio
        upper over lower bound of the shape; it does not vary
    duration
        until the test ends, all groups running at once
    bearing_time, rig_time
        expected sum of the times of all bearings, and of all groups
    samples, seed
        tests drawn, and what they were drawn with
    """

    code: str
    groups: int
    group_size: int
    failures: int
    life: float
    reliability: float
    shape: float
    confidence: float
    ratio: float = nan
    ratio_rarely_exceeded: float = nan
    shape_ratio: float = nan
    duration: FailureTime | None = None
    bearing_time: float = nan
    rig_time: float = nan
    samples: int = 0
    seed: int = 0

    @property
    def planned(self) -> bool:
        """Whether there is a plan."""
        return self.code == "planned"

    @property
    def advice(self) -> Note | None:
        """What a person can do, where there is none."""
        return advice_on_plan(self.code)

    @property
    def bearings(self) -> int:
        """Number of bearings needed."""
        return self.groups * self.group_size

    @property
    def scheme(self) -> str:
        """How the test ends: "complete", "type_ii" or "sudden_death"."""
        if self.group_size > 1:
            return "sudden_death"
        return "complete" if self.failures == self.groups else "type_ii"

    def to_mapping(self) -> dict[str, Any]:
        """Give the plan as plain values; None where there is no number."""
        counts = ("groups", "group_size", "failures", "bearings", "scheme", "samples", "seed")
        numbers = (
            "life", "reliability", "shape", "confidence", "ratio", "ratio_rarely_exceeded",
            "shape_ratio", "bearing_time", "rig_time",
        )  # fmt: skip
        return {
            "status": status_of_plan(self.code),
            **{name: getattr(self, name) for name in counts},
            **{name: finite(getattr(self, name)) for name in numbers},
            "duration": None if self.duration is None else self.duration.to_mapping(),
        }


def plan_of(
    failures: int,
    groups: int | None = None,
    group_size: int = 1,
    *,
    shape: float,
    life: float = 1.0,
    reliability: float = 0.9,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
) -> LifeTestPlan:
    """Say what may be expected of a test.

    Parameters
    ----------
    failures
        r, after which the test stops; up to 1000.
    groups
        g; as many as the failures if not given, so that every group fails. Up to 20 000.
    group_size
        m; 1 for a plain test, in which the groups are bearings.
    shape
        β, expected.
    life
        For the reliability, expected; times come in its unit. By default times are multiples of it.
    reliability
        Of the life that the bounds are for: 0.9 for L10.
    confidence
        Of the bounds, two-sided.
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with.

    Raises
    ------
    InputError
        For a number out of range.
    """
    r = whole_number(failures, "failures", 1, MAXIMUM_FAILURES)
    g = r if groups is None else whole_number(groups, "groups", r, MAXIMUM_RIGS)
    expected = _Expected.of(group_size, shape, life, reliability, confidence, samples, seed)
    return expected.plan(g, r)


def plan_for_ratio(
    ratio: float,
    *,
    groups: int | None = None,
    group_size: int = 1,
    failed_share: float = 1.0,
    shape: float,
    life: float = 1.0,
    reliability: float = 0.9,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
) -> LifeTestPlan:
    """Find the least number of failures that brings the bounds of a life so near each other.

    Parameters
    ----------
    ratio
        Upper over lower bound, in half of the tests at most; above 1.
    groups
        g, as given; found together with the failures if not.
    failed_share
        Part of the groups that are to fail, where their number is found; 1 for all.
    group_size, shape, life, reliability, confidence, samples, seed
        As of `plan_of`.

    Returns
    -------
    LifeTestPlan
        Code "not_reached" where even all of the given groups do not bring it, "too_many_failures"
        where it takes more than 1000.

    Raises
    ------
    InputError
        For a number out of range.
    """
    wanted = number(ratio, "ratio", above=0.0, example="5.0")
    if wanted <= 1.0:
        raise InputError(said("must be above 1"), field="ratio", value=ratio, example="5.0")
    part = number(failed_share, "failed_share", above=0.0, example="0.5")
    if part > 1.0:
        raise InputError(said("must be at most 1"), field="failed_share", value=part, example="0.5")
    most = MAXIMUM_FAILURES
    if groups is not None:
        most = min(whole_number(groups, "groups", 1, MAXIMUM_RIGS), most)
    expected = _Expected.of(group_size, shape, life, reliability, confidence, samples, seed)

    def groups_for(failures: int) -> int:
        return ceil(failures / part - 1e-9) if groups is None else groups

    most = min(most, int(MAXIMUM_RIGS * part)) if groups is None else most
    found = _minimum_failures(
        lambda r: log(expected.plan(groups_for(r), r).ratio), log(wanted), most
    )
    if found is None:
        code = "too_many_failures" if groups is None else "not_reached"
        return expected.without(code, 0 if groups is None else groups)
    return expected.plan(groups_for(found), found)


def plans_for_ratio(
    ratio: float,
    *,
    failed_shares: Sequence[float] = (1.0, 0.5, 0.25),
    group_sizes: Sequence[int] = (2, 3, 4, 6, 8, 12),
    shape: float,
    life: float = 1.0,
    reliability: float = 0.9,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
    progress: Progress | None = None,
) -> tuple[LifeTestPlan, ...]:
    """Plan tests that are as precise: plain ones, stopped earlier and later, and sudden death.

    Parameters
    ----------
    ratio
        Upper over lower bound of the life, as of `plan_for_ratio`.
    failed_shares
        Parts of the bearings that fail before a plain test is stopped.
    group_sizes
        Bearings in a group of sudden death; all groups fail.
    shape, life, reliability, confidence, samples, seed
        As of `plan_of`.
    progress
        Called with plans made and plans in all.
    """
    kinds = [(1, part) for part in failed_shares] + [(size, 1.0) for size in group_sizes]
    plans = []
    for size, part in kinds:
        plans.append(
            plan_for_ratio(
                ratio,
                group_size=size,
                failed_share=part,
                shape=shape,
                life=life,
                reliability=reliability,
                confidence=confidence,
                samples=samples,
                seed=seed,
            )
        )
        if progress is not None:
            progress(len(plans), len(kinds))
    return tuple(plans)


@frozen
class _Expected:
    """What all plans of one search have in common."""

    group_size: int
    shape: float
    life: float
    reliability: float
    confidence: float
    samples: int
    seed: int

    @classmethod
    def of(
        cls,
        group_size: int,
        shape: float,
        life: float,
        reliability: float,
        confidence: float,
        samples: int,
        seed: int,
    ) -> _Expected:
        """Check what the caller gives."""
        generator(seed)
        return cls(
            whole_number(group_size, "group_size", 1, MAXIMUM_RIG_SIZE),
            planned_shape(shape),
            number(life, "life", above=0.0, example="1000.0"),
            share(reliability, "reliability"),
            share(confidence, "confidence"),
            sample_count(samples),
            int(seed),
        )

    def without(self, code: str, groups: int) -> LifeTestPlan:
        """Say that there is no plan, and why."""
        return LifeTestPlan(
            code, groups, self.group_size, 0, self.life, self.reliability, self.shape,
            self.confidence,
        )  # fmt: skip

    def plan(self, groups: int, failures: int) -> LifeTestPlan:
        """Draw what may be expected of a test."""
        if failures < 2:
            return self.without("too_few_failures", groups)
        ratio_of_shape, shift = _drawn_pivots(groups, failures, self.samples, self.seed)
        # the life of a bearing for R is that of a group for R^m
        log_risk = log(-log(self.reliability) * self.group_size)
        tail = 0.5 * (1.0 - self.confidence)
        low, high = np.quantile(log_risk * ratio_of_shape - shift, [tail, 1.0 - tail])
        w_low, w_rare, w_median, w_high = np.quantile(
            ratio_of_shape, [tail, 1.0 - _RARELY, 0.5, 1.0 - tail]
        )
        width = float(high - low) / self.shape
        scale = self.life * (-log(self.reliability) * self.group_size) ** (-1.0 / self.shape)
        times = mean_failure_times(failures, groups, self.shape, scale)
        rig_time = float(times.sum() + (groups - failures) * times[-1])
        return LifeTestPlan(
            "planned",
            groups,
            self.group_size,
            failures,
            self.life,
            self.reliability,
            self.shape,
            self.confidence,
            _exponential(width / w_median),
            _exponential(width / w_rare),
            float(w_high / w_low),
            failure_time(failures, groups, self.shape, scale),
            rig_time * self.group_size,
            rig_time,
            self.samples,
            self.seed,
        )


@lru_cache(maxsize=32)
def _drawn_pivots(
    groups: int, failures: int, samples: int, seed: int
) -> tuple[FloatArray, FloatArray]:
    """β̂/β and β̂ ln(η̂/η) of drawn tests stopped at the r-th failure of g; those that have a fit."""
    fits = draw_fits(FirstFailures(groups, failures), 1.0, 0.0, samples, generator(seed))
    good = fits.code == CONVERGED
    shape = fits.shape[good]
    shift = shape * fits.log_scale[0, good]
    for array in (shape, shift):
        array.setflags(write=False)
    return shape, shift


def _minimum_failures(evaluate: Evaluate, wanted: float, most: int) -> int | None:
    """Least r from 2 to the most whose value is not above the wanted one; None without.

    The value falls with r, about as 1/√(r - 1).
    """
    low, high = 1, most + 1
    guess = min(_FIRST_GUESS, most)
    for evaluation in range(_EVALUATIONS):
        if high - low <= 1 or guess < 2:
            break
        value = evaluate(guess)
        low, high = (low, guess) if value <= wanted else (guess, high)
        reach = (value / wanted) ** 2 if isfinite(value) else 4.0
        guess = ceil(1.0 + (guess - 1) * min(max(reach, 0.01), 100.0))
        if evaluation > _GUESSES:
            guess = (low + high) // 2
        guess = min(max(guess, low + 1), high - 1)
    return high if 2 <= high <= most else None


def _exponential(value: float) -> float:
    return exp(value) if value < 700.0 else inf


# --- when a failure comes -------------------------------------------------------------------------


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
    beta, eta = planned_shape(shape), number(scale, "scale", above=0.0, example="1000.0")
    tail = 0.5 * (1.0 - share(probability, "probability"))
    # each limit from its own side, so that none is lost in 1 - F
    risks = _risk_below(r, n, tail), _risk_below(r, n, 0.5), _risk_above(r, n, tail)
    lower, median, upper = (eta * float(risk) ** (1.0 / beta) for risk in risks)
    mean, deviation = (
        eta * float(moment[0]) for moment in _moments_of_times(np.array([r]), n, beta)
    )
    return FailureTime(mean, deviation, median, lower, upper, probability)


def mean_failure_times(count: int, size: int, shape: float, scale: float = 1.0) -> FloatArray:
    """Mean times of the first failures among n bearings: (count,); parameters as `failure_time`."""
    r, n = _ranked(count, size)
    beta, eta = planned_shape(shape), number(scale, "scale", above=0.0, example="1000.0")
    ranks = np.arange(1, r + 1)
    parts = [
        _moments_of_times(ranks[i : i + _RANKS_AT_ONCE], n, beta)[0]
        for i in range(0, r, _RANKS_AT_ONCE)
    ]
    return np.asarray(eta * np.concatenate(parts))


def _ranked(rank: int, size: int) -> tuple[int, int]:
    n = whole_number(size, "size", 1, MAXIMUM_BEARINGS)
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


def _moments_of_times(
    rank: NDArray[np.int64], size: int, shape: float
) -> tuple[FloatArray, FloatArray]:
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
