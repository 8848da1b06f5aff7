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

Sources: Johnson (1964) for sudden death; McCool (1970, 1974).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, exp, inf, isfinite, log, nan
from typing import Any, Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.weibull import profile
from rolamento.weibull._checks import generator, positive, sample_count, share
from rolamento.weibull.censoring import FirstFailures, draw_fits
from rolamento.weibull.order_statistics import (
    FailureTime,
    failure_time,
    mean_failure_times,
    planned_shape,
    whole_number,
)
from rolamento.weibull.planning import PLAN_ADVICE

__all__ = ["LifeTestPlan", "plan_for_ratio", "plan_of", "plans_for_ratio"]

MOST_FAILURES: Final = 1000
MOST_GROUPS: Final = 20_000
MOST_IN_GROUP: Final = 1000
_RARELY: Final = 0.9
_EVALUATIONS: Final = 80
_GUESSES: Final = 12
_FIRST_GUESS: Final = 10

Evaluate = Callable[[int], float]
Progress = Callable[[int, int], None]


@dataclass(frozen=True, slots=True, eq=False)
class LifeTestPlan:
    """A life test before it is made, and what may be expected of it; NaN where nothing may.

    Attributes
    ----------
    code
        "planned", or why there is no plan, a key of `PLAN_ADVICE`
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
    def advice(self) -> str | None:
        """What a person can do, where there is none."""
        return PLAN_ADVICE.get(self.code)

    @property
    def bearings(self) -> int:
        """How many bearings it takes."""
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
        found = {name: getattr(self, name) for name in numbers}
        return {
            "status": {"code": self.code, "planned": self.planned, "advice": self.advice},
            **{name: getattr(self, name) for name in counts},
            **{name: value if isfinite(value) else None for name, value in found.items()},
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
    """Tell what may be expected of a test.

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
    r = whole_number(failures, "failures", 1, MOST_FAILURES)
    g = r if groups is None else whole_number(groups, "groups", r, MOST_GROUPS)
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
    wanted = positive(ratio, "ratio", "5.0")
    if wanted <= 1.0:
        raise InputError("must be above 1", field="ratio", value=ratio, example="5.0")
    part = positive(failed_share, "failed_share", "0.5")
    if part > 1.0:
        raise InputError("must be 1 or less", field="failed_share", value=part, example="0.5")
    most = MOST_FAILURES
    if groups is not None:
        most = min(whole_number(groups, "groups", 1, MOST_GROUPS), most)
    expected = _Expected.of(group_size, shape, life, reliability, confidence, samples, seed)

    def groups_for(failures: int) -> int:
        return ceil(failures / part - 1e-9) if groups is None else groups

    most = min(most, int(MOST_GROUPS * part)) if groups is None else most
    found = _least(lambda r: log(expected.plan(groups_for(r), r).ratio), log(wanted), most)
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


@dataclass(frozen=True, slots=True)
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
            whole_number(group_size, "group_size", 1, MOST_IN_GROUP),
            planned_shape(shape),
            positive(life, "life", "1000.0"),
            share(reliability, "reliability"),
            share(confidence, "confidence"),
            sample_count(samples),
            int(seed),
        )

    def without(self, code: str, groups: int) -> LifeTestPlan:
        """Tell that there is no plan, and why."""
        return LifeTestPlan(
            code, groups, self.group_size, 0, self.life, self.reliability, self.shape,
            self.confidence,
        )  # fmt: skip

    def plan(self, groups: int, failures: int) -> LifeTestPlan:
        """Draw what may be expected of a test."""
        if failures < 2:
            return self.without("too_few_failures", groups)
        ratio_of_shape, shift = _pivots(groups, failures, self.samples, self.seed)
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
            _exp(width / w_median),
            _exp(width / w_rare),
            float(w_high / w_low),
            failure_time(failures, groups, self.shape, scale),
            rig_time * self.group_size,
            rig_time,
            self.samples,
            self.seed,
        )


@lru_cache(maxsize=32)
def _pivots(groups: int, failures: int, samples: int, seed: int) -> tuple[FloatArray, FloatArray]:
    """β̂/β and β̂ ln(η̂/η) of drawn tests stopped at the r-th failure of g; those that have a fit."""
    fits = draw_fits(FirstFailures(groups, failures), 1.0, 0.0, samples, generator(seed))
    good = fits.code == profile.CONVERGED
    shape = fits.shape[good]
    shift = shape * fits.log_scale[0, good]
    for array in (shape, shift):
        array.setflags(write=False)
    return shape, shift


def _least(evaluate: Evaluate, wanted: float, most: int) -> int | None:
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


def _exp(value: float) -> float:
    return exp(value) if value < 700.0 else inf
