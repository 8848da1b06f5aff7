"""Planning of life tests: demonstrations, precision, test times; closed forms and simulation."""

from __future__ import annotations

from math import comb, exp, gamma, log
from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.weibull import (
    LifeTest,
    all_bounds,
    demonstrate,
    failure_time,
    mean_failure_times,
    plan_for_ratio,
    plan_of,
)
from rolamento.words import Note


def lieblein(rank: int, size: int, shape: float, power: int = 1) -> float:
    """Moment of the r-th of n, by Lieblein's alternating sum."""
    total = sum(
        (-1) ** j * comb(rank - 1, j) / (size - rank + 1 + j) ** (1.0 + power / shape)
        for j in range(rank)
    )
    return rank * comb(size, rank) * gamma(1.0 + power / shape) * total


# --- when the r-th of n fails ----------------------------------------------------------------


@pytest.mark.parametrize("shape", [0.1, 0.5, 1.0, 1.5, 8.0])
@pytest.mark.parametrize(("rank", "size"), [(1, 1), (1, 7), (3, 3), (5, 10), (10, 10)])
def test_moments_are_those_of_the_closed_form(rank: int, size: int, shape: float) -> None:
    found = failure_time(rank, size, shape, 3.0)
    mean = lieblein(rank, size, shape)
    assert found.mean == pytest.approx(3.0 * mean, rel=1e-10)
    deviation = (lieblein(rank, size, shape, 2) - mean**2) ** 0.5
    assert found.deviation == pytest.approx(3.0 * deviation, rel=1e-8)
    assert mean_failure_times(rank, size, shape)[-1] == pytest.approx(mean, rel=1e-10)


def test_the_first_of_n_is_a_weibull_of_its_own() -> None:
    found = failure_time(1, 8, 2.0, 100.0, probability=0.8)
    for limit, share in ((found.lower, 0.1), (found.median, 0.5), (found.upper, 0.9)):
        assert exp(-8.0 * (limit / 100.0) ** 2) == pytest.approx(1.0 - share, rel=1e-12)


def test_limits_hold_as_often_as_they_say() -> None:
    times = np.sort(np.random.default_rng(1).weibull(1.5, (100_000, 12)), axis=1)[:, 6]
    found = failure_time(7, 12, 1.5)
    inside = np.mean((times > found.lower) & (times < found.upper))
    assert inside == pytest.approx(0.9, abs=0.004)
    assert np.mean(times < found.median) == pytest.approx(0.5, abs=0.006)


def test_many_bearings_lose_nothing() -> None:
    half = failure_time(50_000, 100_000, 1.5)
    assert half.mean == pytest.approx(log(2.0) ** (1 / 1.5), rel=1e-4)
    assert half.deviation < 0.01
    last = failure_time(100_000, 100_000, 1.0)
    harmonic = log(100_000) + 0.5772156649015329 + 0.5 / 100_000
    assert last.mean == pytest.approx(harmonic, rel=1e-9)


@pytest.mark.parametrize(
    ("arguments", "field"),
    [
        ((0, 5, 1.5), "rank"),
        ((6, 5, 1.5), "rank"),
        ((2.0, 5, 1.5), "rank"),
        ((True, 5, 1.5), "rank"),
        ((1, 100_001, 1.5), "size"),
        ((1, 5, 0.05), "shape"),
        ((1, 5, float("nan")), "shape"),
        ((1, 5, 1.5, -1.0), "scale"),
        ((1, 5, 1.5, 1.0, 1.0), "probability"),
    ],
)
def test_wrong_ranks_are_refused(arguments: tuple[Any, ...], field: str) -> None:
    with pytest.raises(InputError) as caught:
        failure_time(*arguments)
    assert caught.value.field == field


# --- demonstration ---------------------------------------------------------------------------


def test_success_run_has_the_closed_form() -> None:
    plan = demonstrate(1000.0, shape=1.5, bearings=10)
    time = 1000.0 * (log(1 / 0.1) / (10 * log(1 / 0.9))) ** (1 / 1.5)
    assert plan.code == "planned"
    assert plan.time == pytest.approx(time, rel=1e-12)
    assert plan.total_time == pytest.approx(10 * time)


def test_as_many_as_everybody_knows() -> None:
    """R90 C90 takes 22 bearings for the whole life, R99 C90 takes 230, R90 C95 takes 29."""
    for reliability, confidence, bearings in ((0.9, 0.9, 22), (0.99, 0.9, 230), (0.9, 0.95, 29)):
        plan = demonstrate(
            500.0, shape=2.0, time=500.0, reliability=reliability, confidence=confidence
        )
        assert plan.bearings == bearings
        assert plan.shown >= confidence


def test_bearings_and_time_trade_by_n_times_t_to_the_shape() -> None:
    few, many = (demonstrate(1.0, shape=2.0, bearings=n) for n in (4, 16))
    assert few.time / many.time == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize("allowed", [0, 1, 3])
def test_time_and_bearings_are_inverse(allowed: int) -> None:
    by_bearings = demonstrate(1000.0, shape=1.3, bearings=17, failures_allowed=allowed)
    by_time = demonstrate(1000.0, shape=1.3, time=by_bearings.time, failures_allowed=allowed)
    assert by_time.bearings == 17
    one_less = demonstrate(
        1000.0, shape=1.3, time=by_bearings.time, bearings=16, failures_allowed=allowed
    )
    assert one_less.code == "not_shown"
    assert one_less.advice == Note("plan_not_shown")
    assert 0.0 < one_less.shown < 0.9


def test_chance_of_passing_is_that_of_drawn_tests() -> None:
    plan = demonstrate(1000.0, shape=1.5, bearings=10, failures_allowed=2)
    assert plan.chance_of_passing(1.0) == pytest.approx(0.1, rel=1e-9)
    scale = 2.0 * 1000.0 * log(1 / 0.9) ** (-1 / 1.5)
    lives = scale * np.random.default_rng(2).weibull(1.5, (100_000, 10))
    third = np.sort(lives, axis=1)[:, 2]
    assert np.mean(third > plan.time) == pytest.approx(plan.chance_of_passing(2.0), abs=0.005)
    ends = np.minimum(third, plan.time)
    assert ends.mean() == pytest.approx(plan.expected_time(2.0), rel=0.004)
    assert plan.chance_of_passing(plan.life_ratio_for(0.9)) == pytest.approx(0.9, rel=1e-9)


def test_success_run_passes_with_one_less_confidence_to_a_power() -> None:
    plan = demonstrate(1000.0, shape=1.5, bearings=5)
    ratio = np.array([0.0, 0.5, 1.0, 3.0])
    with np.errstate(divide="ignore"):
        expected = 0.1 ** (ratio**-1.5)
    np.testing.assert_allclose(plan.chance_of_passing(ratio), expected, rtol=1e-12)
    assert np.isnan(plan.chance_of_passing(-1.0))


def test_the_shape_matters_unless_the_test_is_as_long_as_the_life() -> None:
    whole = demonstrate(1000.0, shape=1.5, time=1000.0)
    np.testing.assert_allclose(whole.confidence_at([1.0, 3.0]), whole.shown, rtol=1e-12)
    longer = demonstrate(1000.0, shape=1.5, bearings=5)
    assert longer.time > 1000.0
    low, as_planned, high = longer.confidence_at([1.0, 1.5, 3.0])
    assert low < as_planned < high
    assert as_planned == pytest.approx(0.9)


def test_lower_bound_of_the_engine_agrees() -> None:
    """A test without failures as planned has just the wanted life as its lower bound."""
    plan = demonstrate(1000.0, shape=1.5, bearings=7, confidence=0.95)
    test = LifeTest([plan.time], [False], counts=7)
    (bound,) = all_bounds(test, ["L10"], shape=1.5, confidence=0.95, sides="lower")
    assert bound.lower == pytest.approx(1000.0, rel=1e-9)


def test_plans_that_cannot_be_say_why() -> None:
    many = demonstrate(1000.0, shape=3.0, time=1.0)
    assert (many.code, many.bearings) == ("too_many_bearings", 0)
    assert np.isnan(many.shown)
    assert np.isnan(many.chance_of_passing(2.0))
    assert np.isnan(many.expected_time())
    long = demonstrate(1e29, shape=0.1, bearings=1)
    assert long.code == "too_long"
    assert np.isnan(long.time)
    assert long.to_mapping()["time"] is None
    assert (many.advice, long.advice) == (Note("plan_too_many_bearings"), Note("plan_too_long"))


@pytest.mark.parametrize(
    ("keywords", "field"),
    [
        ({}, "bearings"),
        ({"bearings": 0}, "bearings"),
        ({"bearings": 2, "failures_allowed": 2}, "bearings"),
        ({"bearings": 10**9}, "bearings"),
        ({"bearings": "ten"}, "bearings"),
        ({"time": 0.0}, "time"),
        ({"time": float("inf")}, "time"),
        ({"bearings": 5, "shape": 0.0}, "shape"),
        ({"bearings": 5, "life": -5.0}, "life"),
        ({"bearings": 5, "reliability": 1.0}, "reliability"),
        ({"bearings": 5, "confidence": 90.0}, "confidence"),
        ({"bearings": 5, "failures_allowed": -1}, "failures_allowed"),
    ],
)
def test_wrong_demonstrations_are_refused(keywords: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        demonstrate(**{"life": 1000.0, "shape": 1.5, **keywords})
    assert caught.value.field == field


# --- precision -------------------------------------------------------------------------------


def drawn_ratios(test_of: Any, tests: int) -> np.ndarray[Any, Any]:
    """Ratios of the engine's own bounds, of drawn tests."""
    ratios = []
    for seed in range(tests):
        (bound,) = all_bounds(test_of(np.random.default_rng(seed)), ["L10"], samples=1000)
        ratios.append(bound.upper / bound.lower)
    return np.array(ratios)


def test_half_of_real_tests_have_bounds_nearer_than_planned() -> None:
    plan = plan_of(6, 12, shape=1.5)

    def drawn(random: np.random.Generator) -> LifeTest:
        times = np.sort(random.weibull(1.5, 12))[:6]
        return LifeTest([*times, times[-1]], [True] * 6 + [False], counts=[1] * 6 + [6])

    ratios = drawn_ratios(drawn, 200)
    assert np.mean(ratios < plan.ratio) == pytest.approx(0.5, abs=0.1)
    assert np.mean(ratios > plan.ratio_rarely_exceeded) == pytest.approx(0.1, abs=0.06)


def test_sudden_death_is_planned_as_it_is_evaluated() -> None:
    plan = plan_of(8, group_size=5, shape=1.5)

    def drawn(random: np.random.Generator) -> LifeTest:
        return LifeTest.sudden_death(random.weibull(1.5, (8, 5)).min(axis=1), 5)

    ratios = drawn_ratios(drawn, 200)
    assert np.mean(ratios < plan.ratio) == pytest.approx(0.5, abs=0.1)
    assert plan.scheme == "sudden_death"
    assert plan.bearings == 40


def test_the_shape_of_the_bearings_only_stretches_the_ratio() -> None:
    one, two = (plan_of(10, shape=shape) for shape in (1.0, 2.0))
    assert log(one.ratio) == pytest.approx(2.0 * log(two.ratio), rel=1e-12)
    assert one.shape_ratio == two.shape_ratio


def test_groups_of_one_are_the_plain_test() -> None:
    plain, grouped = plan_of(6, 10, shape=1.5), plan_of(6, 10, 1, shape=1.5)
    assert plain.to_mapping() == grouped.to_mapping()
    assert plain.scheme == "type_ii"
    assert plan_of(6, shape=1.5).scheme == "complete"


def test_the_life_of_a_bearing_is_another_life_of_its_group() -> None:
    """Sudden death for t_R has the ratio that a plain test has for t_(R^m)."""
    sudden = plan_of(9, group_size=4, shape=1.5, reliability=0.9)
    plain = plan_of(9, shape=1.5, reliability=0.9**4)
    assert sudden.ratio == pytest.approx(plain.ratio, rel=1e-12)


def test_times_of_a_plan_are_those_of_drawn_tests() -> None:
    plan = plan_of(5, 8, 3, shape=1.4, life=100.0)
    scale = 100.0 * log(1 / 0.9) ** (-1 / 1.4)
    lives = scale * np.random.default_rng(3).weibull(1.4, (50_000, 8, 3))
    stops = np.sort(lives.min(axis=2), axis=1)
    end = stops[:, 4]
    assert plan.duration is not None
    assert plan.duration.mean == pytest.approx(end.mean(), rel=0.01)
    rig_time = np.minimum(stops, end[:, np.newaxis]).sum(axis=1)
    assert plan.rig_time == pytest.approx(rig_time.mean(), rel=0.01)
    assert plan.bearing_time == pytest.approx(3.0 * plan.rig_time)


def test_the_least_number_of_failures_is_found() -> None:
    for keywords in ({}, {"group_size": 6}, {"failed_share": 0.5}, {"groups": 40}):
        plan = plan_for_ratio(5.0, shape=1.5, samples=4000, **keywords)
        assert plan.planned
        assert plan.ratio <= 5.0
        groups = keywords.get("groups")
        one_less = plan.failures - 1
        part = keywords.get("failed_share", 1.0)
        less = plan_of(
            one_less,
            int(groups or np.ceil(one_less / part)),
            int(keywords.get("group_size", 1)),
            shape=1.5,
            samples=4000,
        )
        assert less.ratio > 5.0


def test_sudden_death_ends_sooner_and_takes_more_bearings() -> None:
    full = plan_for_ratio(5.0, shape=1.5, life=1000.0)
    sudden = plan_for_ratio(5.0, shape=1.5, life=1000.0, group_size=8)
    assert full.duration is not None
    assert sudden.duration is not None
    assert sudden.duration.mean < 0.3 * full.duration.mean
    assert sudden.bearings > full.bearings
    assert sudden.failures < full.failures


def test_what_cannot_be_reached_says_so() -> None:
    few = plan_for_ratio(2.0, shape=1.5, groups=8, samples=1000)
    assert few.code == "not_reached"
    assert np.isnan(few.ratio)
    assert few.to_mapping()["ratio"] is None
    assert few.advice == Note("plan_not_reached")
    assert plan_for_ratio(1.01, shape=1.5, samples=100).code == "too_many_failures"
    assert plan_for_ratio(5.0, shape=1.5, groups=1).code == "not_reached"
    one = plan_of(1, 10, shape=1.5)
    assert one.code == "too_few_failures"
    assert one.duration is None


def test_the_same_seed_gives_the_same_plan() -> None:
    first, again, other = (plan_of(5, shape=1.5, samples=500, seed=seed) for seed in (1, 1, 2))
    assert first.to_mapping() == again.to_mapping()
    assert first.ratio != other.ratio


@pytest.mark.parametrize(
    ("keywords", "field"),
    [
        ({"ratio": 1.0}, "ratio"),
        ({"ratio": float("nan")}, "ratio"),
        ({"group_size": 0}, "group_size"),
        ({"groups": 0}, "groups"),
        ({"failed_share": 0.0}, "failed_share"),
        ({"failed_share": 1.5}, "failed_share"),
        ({"shape": -1.0}, "shape"),
        ({"samples": 99}, "samples"),
        ({"seed": -1}, "seed"),
        ({"confidence": 1.0}, "confidence"),
        ({"life": 0.0}, "life"),
    ],
)
def test_wrong_plans_are_refused(keywords: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_for_ratio(**{"ratio": 5.0, "shape": 1.5, **keywords})
    assert caught.value.field == field


def test_failures_must_be_among_the_groups() -> None:
    with pytest.raises(InputError):
        plan_of(5, 4, shape=1.5)
    with pytest.raises(InputError):
        plan_of(1001, shape=1.5)
