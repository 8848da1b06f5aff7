"""Goodness of fit: the statistic against its formulas, what it finds, and what it does not."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from rolamento.weibull import (
    LifeTest,
    LifeTestRequest,
    goodness_of_fit,
    maximum_likelihood,
    published_life_test,
    summarise,
)
from rolamento.weibull.estimates import rows_of
from rolamento.weibull.goodness import anderson_darling
from rolamento.weibull.likelihood import Rows


def distance(test: LifeTest, shape: float, scale: float) -> float:
    order = np.lexsort((~test.failed, test.times))
    return float(
        anderson_darling(rows_of(test.select(order)), np.array([shape]), np.log([scale]))[0]
    )


def test_of_complete_data_it_is_the_usual_sum() -> None:
    """Anderson and Darling (1954): A² = -n - Σ (2i - 1)[ln u_i + ln(1 - u_(n+1-i))]/n."""
    test = published_life_test("lieblein_zelen_1956")
    fit = maximum_likelihood(test)
    u = np.sort(1.0 - fit.reliability_at(test.times))
    n = len(u)
    i = np.arange(1, n + 1)
    usual = -n - np.mean((2 * i - 1) * (np.log(u) + np.log1p(-u[::-1])))
    assert distance(test, fit.shape, fit.scale) == pytest.approx(usual, rel=1e-9)


def test_of_a_test_that_ended_at_a_failure_it_is_that_of_pettitt_and_stephens() -> None:
    """D'Agostino and Stephens (1986), section 4.7.3: A² of the r smallest of n."""
    random = np.random.default_rng(3)
    n, r = 20, 12
    u = np.sort(random.random(n))[:r]
    times = (-np.log1p(-u)) ** (1.0 / 1.7)
    i = np.arange(1, r + 1)
    published = (
        -np.sum((2 * i - 1) * (np.log(u) - np.log1p(-u))) / n
        - 2.0 * np.sum(np.log1p(-u))
        - ((r - n) ** 2 * np.log1p(-u[-1]) - r**2 * np.log(u[-1]) + n**2 * u[-1]) / n
    )
    test = LifeTest([*times, times[-1]], [True] * r + [False], counts=[1] * r + [n - r])
    assert distance(test, 1.7, 1.0) == pytest.approx(published, rel=1e-9)


def test_with_suspensions_it_is_the_integral() -> None:
    times = [0.2, 0.5, 0.6, 0.9, 1.1, 1.4]
    test = LifeTest(times, [True, False, True, True, False, False])

    def failed(t: float) -> float:
        alive, running = 1.0, len(times)
        for time, flag in zip(times, test.failed, strict=True):
            if time <= t and flag:
                alive *= 1.0 - 1.0 / running
            running -= 1
        return 1.0 - alive

    def integrand(u: float) -> float:
        t = (-np.log1p(-u)) ** (1.0 / 1.3)
        return (failed(t) - u) ** 2 / (u * (1.0 - u))

    ends = [1.0 - np.exp(-(t**1.3)) for t in (0.0, *times)]
    parts = [quad(integrand, a, b)[0] for a, b in pairwise(ends)]
    assert distance(test, 1.3, 1.0) == pytest.approx(6.0 * sum(parts), rel=1e-7)


def test_equal_bearings_are_one_row_or_many() -> None:
    many = LifeTest([1.0, 1, 2, 3, 3, 3, 4], [True, True, True, False, False, False, True])
    few = LifeTest([1.0, 2, 3, 4], [True, True, False, True], counts=[2, 1, 3, 1])
    assert distance(many, 2.0, 3.0) == pytest.approx(distance(few, 2.0, 3.0), rel=1e-12)


def test_times_in_another_unit_change_nothing() -> None:
    random = np.random.default_rng(1)
    times = random.weibull(2.0, 20)
    one, other = goodness_of_fit(times, samples=200), goodness_of_fit(3600.0 * times, samples=200)
    assert one.statistic == pytest.approx(other.statistic, rel=1e-6)
    assert one.p_value == other.p_value
    assert one.dog_leg is not None
    assert other.dog_leg is not None
    assert other.dog_leg.time == pytest.approx(3600.0 * one.dog_leg.time, rel=1e-6)
    assert goodness_of_fit(times, samples=200) == one


def test_two_modes_bend_the_plot_upward() -> None:
    random = np.random.default_rng(4)
    times = np.minimum(60_000.0 * random.weibull(0.8, 80), 22_000.0 * random.weibull(4.0, 80))
    found = goodness_of_fit(times, samples=500)
    assert found.contradicted
    assert found.bent is not None
    assert found.bent.shape_before < 1.3 < found.bent.shape_after
    assert [note.key for note in found.contradictions("h")] == ["dog_leg_steeper"]
    # the two parts meet at the break
    ends = found.bent.life_at_ordinate(np.array([found.bent.ordinate]))
    assert ends[0] == pytest.approx(found.bent.time)


def test_a_limited_population_bends_it_downward() -> None:
    random = np.random.default_rng(4)
    times = np.where(random.random(120) < 0.4, 100.0 * random.weibull(3.0, 120), np.inf)
    found = goodness_of_fit(LifeTest(np.minimum(times, 5000.0), times < 5000.0), samples=500)
    assert found.bent is not None
    assert [note.key for note in found.contradictions("h")] == ["dog_leg_flatter"]


def test_the_broken_line_is_at_least_as_likely_as_any_other_of_its_break() -> None:
    """The likelihood of the piecewise hazard, written out, is nowhere greater nearby."""
    random = np.random.default_rng(8)
    times = np.sort(np.minimum(random.weibull(0.9, 40), 0.8 * random.weibull(5.0, 40)))
    bend = goodness_of_fit(times, samples=100).dog_leg
    assert bend is not None

    def value(before: float, after: float, level: float) -> float:
        slope = np.where(times < bend.time, before, after)
        risk = level * (times / bend.time) ** slope
        return float(np.sum(np.log(slope * risk / times) - risk))

    best = value(bend.shape_before, bend.shape_after, float(np.exp(bend.ordinate)))
    assert best == pytest.approx(bend.log_likelihood, rel=1e-9)
    for a, b, c in np.random.default_rng(0).uniform(0.9, 1.1, (50, 3)):
        there = value(a * bend.shape_before, b * bend.shape_after, c * np.exp(bend.ordinate))
        assert there <= best + 1e-9
    assert bend.statistic == pytest.approx(
        2.0 * (best - maximum_likelihood(times).log_likelihood), rel=1e-6
    )


def test_a_lognormal_sample_is_contradicted() -> None:
    random = np.random.default_rng(2)
    found = goodness_of_fit(np.exp(0.5 * random.standard_normal(150)), samples=300)
    assert found.p_value < 0.05


@pytest.mark.parametrize("kind", ["complete", "type_ii", "random"])
def test_a_true_distribution_is_seldom_contradicted(kind: str) -> None:
    """p-values of true samples are even where failures end a test, and larger otherwise."""
    values = []
    for seed in range(40):
        random = np.random.default_rng(seed)
        times = random.weibull(1.8, 20)
        if kind == "complete":
            test = LifeTest(times)
        elif kind == "type_ii":
            end = np.sort(times)[11]
            test = LifeTest(np.minimum(times, end), times <= end)
        else:
            end = random.uniform(0.3, 1.5, 20)
            test = LifeTest(np.minimum(times, end), times <= end)
        found = goodness_of_fit(test, samples=100, seed=seed)
        if found.converged:
            values.append(found.p_value)
    share = np.mean(np.array(values) < 0.1)
    assert share <= 0.1 + 3.0 * (0.1 * 0.9 / len(values)) ** 0.5


def test_inspected_failures_are_tested_by_their_intervals() -> None:
    random = np.random.default_rng(6)
    ends = np.arange(0.2, 2.01, 0.2)

    def inspected(times: np.ndarray) -> LifeTest:
        cell = np.searchsorted(ends, times)
        failed = cell < len(ends)
        upper = ends[np.minimum(cell, len(ends) - 1)]
        starts = np.append(0.0, ends[:-1])
        lower = np.where(failed, starts[np.minimum(cell, len(ends) - 1)], np.nan)
        return LifeTest(upper, failed, lower=lower)

    good = goodness_of_fit(inspected(random.weibull(2.0, 150)), samples=200)
    assert good.method == "likelihood_ratio"
    assert good.p_value > 0.1
    two = np.minimum(random.weibull(0.6, 150) * 4.0, random.weibull(9.0, 150) * 1.5)
    bad = goodness_of_fit(inspected(two), samples=200)
    assert bad.p_value < 0.05
    assert [note.key for note in bad.contradictions("h")] == ["weibull_contradicted_by_intervals"]
    # a failure that was not seen for two inspections fits no cell of the schedule
    test = inspected(random.weibull(2.0, 40))
    lower = test.lower.copy()
    lower[int(np.argmax(test.times * test.failed))] = 0.2
    assert goodness_of_fit(LifeTest(test.times, test.failed, lower=lower)).code == "not_modelled"


def test_a_known_shape_is_tested_as_given() -> None:
    times = np.random.default_rng(0).weibull(3.0, 60)
    assert goodness_of_fit(times, shape=3.0, samples=200).p_value > 0.1
    wrong = goodness_of_fit(times, shape=1.0, samples=200)
    assert wrong.p_value < 0.05
    assert wrong.dog_leg is None
    assert [note.key for note in wrong.contradictions("h")] == ["weibull_contradicted"]


@pytest.mark.parametrize(
    ("test", "code"),
    [
        (LifeTest([1.0, 2.0], [True, False]), "one_failure"),
        (LifeTest([1.0, 2.0, 3.0], [True, True, False]), "few_to_test"),
        (LifeTest([1.0, 1.0, 1.0]), "no_spread"),
        (LifeTest([1.0, 2.0], False), "no_failures"),
    ],
)
def test_too_little_to_test_has_a_reason(test: LifeTest, code: str) -> None:
    found = goodness_of_fit(test)
    assert (found.code, found.contradicted) == (code, False)
    assert np.isnan(found.p_value)
    assert found.advice is not None
    assert found.advice.text
    assert found.to_mapping()["p_value"] is None


def test_few_failures_have_no_dog_leg() -> None:
    assert goodness_of_fit([1.0, 2.0, 3.0, 4.0, 5.0], samples=100).dog_leg is None


def test_other_distributions_stand_beside_what_is_contradicted() -> None:
    random = np.random.default_rng(4)
    times = np.minimum(60_000.0 * random.weibull(0.8, 80), 22_000.0 * random.weibull(4.0, 80))
    (bad,) = summarise(times, LifeTestRequest(samples=300)).groups
    assert bad.models
    (good,) = summarise(random.weibull(2.0, 20), LifeTestRequest(samples=300)).groups
    assert not good.models
    (asked,) = summarise(random.weibull(2.0, 20), LifeTestRequest(samples=300, models=True)).groups
    assert len(asked.models) == 6


def test_samples_of_several_lengths_go_through_the_same_arithmetic() -> None:
    """A batch gives each sample what it has alone."""
    random = np.random.default_rng(1)
    log_time = np.sort(np.log(random.weibull(2.0, (3, 8))), axis=1)
    failures = np.ones((3, 8))
    failures[1, 3] = 0.0
    units = np.ones((3, 8))
    shape, log_scale = np.array([1.0, 2.0, 3.0]), np.zeros(3)
    together = anderson_darling(Rows(log_time, failures, units), shape, log_scale)
    alone = [
        anderson_darling(
            Rows(log_time[i : i + 1], failures[i : i + 1], units[i : i + 1]),
            shape[i : i + 1],
            log_scale[i : i + 1],
        )[0]
        for i in range(3)
    ]
    assert together.tolist() == pytest.approx(alone, rel=1e-13)
