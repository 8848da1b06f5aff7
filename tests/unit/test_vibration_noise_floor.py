"""Scores of lines above noise: against closed forms, direct integration and drawn noise."""

from __future__ import annotations

from math import exp, factorial, log

import numpy as np
import pytest
from scipy import integrate, stats

from rolamento.vibration.noise_floor import (
    HALF_WIDTH,
    LOWEST_LINE,
    line_scores,
    log_gamma_tail,
    mean_over_median,
    mean_scores,
    reaches,
    running_medians,
)


@pytest.mark.parametrize(("count", "x"), [(1, 800.0), (3, 5.0), (3, 900.0), (10, 1200.0)])
def test_tail_of_a_gamma_variable_of_whole_shape(count: int, x: float) -> None:
    """Q(n, x) = e^-x Σ x^k/k!, k < n."""
    total = sum(x**k / factorial(k) for k in range(count))
    assert log_gamma_tail(count, np.array([x]))[0] == pytest.approx(log(total) - x)


def test_tail_where_it_is_too_small_for_a_number() -> None:
    def integrand(u: float, a: float, x: float) -> float:
        return exp((a - 1.0) * np.log1p(u / x) - u)

    for a, x in ((360.0, 2500.0), (50.5, 1000.0)):
        rest = integrate.quad(integrand, 0.0, 400.0, args=(a, x))[0]
        wanted = (
            -x + (a - 1.0) * log(x) - float(stats.gamma(a).logpdf(1.0) * -1.0 - 1.0) + log(rest)
        )
        assert log_gamma_tail(a, np.array([x]))[0] == pytest.approx(wanted)


def test_score_of_one_line_is_the_product_of_rohling() -> None:
    """p = Π (M - i)/(M - i + T) over the ranks up to the median's."""
    others, reach = 2 * HALF_WIDTH, HALF_WIDTH
    for ratio in (1.5, 5.0, 20.0):
        wanted = sum(log((others - i + ratio) / (others - i)) for i in range(reach + 1))
        one = np.ones((1, 1))
        found = mean_scores(ratio * one, one, one.astype(int), np.full((1, 1), reach), 1)
        assert found[0, 0] == pytest.approx(wanted, rel=5e-4)


def test_score_of_a_mean_by_direct_integration() -> None:
    """∫ Q(cK, cT x) over the density of the median of M gamma variables."""
    reach, count, averages, ratio = 40, 4, 3, 2.2
    rank, others = reach + 1 - count // 2, 2 * reach + 1 - count
    gamma, beta = stats.gamma(averages), stats.beta(rank, others - rank + 1)

    def integrand(x: float) -> float:
        tail = stats.gamma(averages * count).sf(count * ratio * x)
        return float(tail * beta.pdf(gamma.cdf(x)) * gamma.pdf(x))

    wanted = -log(integrate.quad(integrand, 1.0, 6.0, points=(2.0, 3.0))[0])
    shape = (1, 1)
    found = mean_scores(
        np.full(shape, ratio),
        np.ones(shape),
        np.full(shape, count),
        np.full(shape, reach),
        averages,
    )
    assert found[0, 0] == pytest.approx(wanted, rel=1e-3)


@pytest.mark.parametrize("averages", [1, 4, 60])
def test_scores_of_noise_are_exponential(averages: int) -> None:
    """Whatever the level does, as long as it is slow."""
    random = np.random.default_rng(averages)
    level = 1e-3 * np.exp(-np.arange(8000) / 1500.0)
    scores = line_scores(random.gamma(averages, size=(30, 8000)) * level, averages=averages)
    found = scores[~np.isnan(scores)]
    assert len(found) == 30 * (8000 - LOWEST_LINE - HALF_WIDTH)
    assert np.mean(found) == pytest.approx(1.0, abs=0.01)
    for limit in (1.0, 3.0, 6.0):
        number = np.count_nonzero(found > limit)
        wanted = len(found) * exp(-limit)
        assert number == pytest.approx(wanted, abs=5.0 * wanted**0.5 + 0.01 * wanted)
    low = scores[:, LOWEST_LINE:60]
    assert np.mean(low) == pytest.approx(1.0, abs=0.1)


def test_scores_of_means_of_noise_are_exponential() -> None:
    random = np.random.default_rng(7)
    power = random.exponential(size=(40, 6000))
    width = 8
    means = np.lib.stride_tricks.sliding_window_view(power, width, axis=1).mean(axis=2)[:, ::width]
    centres = np.arange(means.shape[1]) * width + (width - 1) // 2
    medians = running_medians(power)[:, centres]
    count = np.full(means.shape, width)
    scores = mean_scores(means, medians, count, np.broadcast_to(reaches(centres), means.shape), 1)
    found = scores[~np.isnan(scores)]
    assert np.mean(found) == pytest.approx(1.0, abs=0.03)
    assert np.mean(found > 4.0) == pytest.approx(exp(-4.0), rel=0.25)


def test_a_line_stands_out_of_noise_by_its_power() -> None:
    random = np.random.default_rng(8)
    power = random.exponential(size=(1, 3000))
    power[0, 1500] = 40.0
    assert line_scores(power, averages=1)[0, 1500] == pytest.approx(40.0, rel=0.2)
    assert line_scores(1e-30 * power, averages=1)[0, 1500] == pytest.approx(
        line_scores(power, averages=1)[0, 1500]
    )


def test_where_there_is_nothing_to_compare_with() -> None:
    scores = line_scores(np.zeros((2, 2000)), averages=1)
    assert np.all(np.isnan(scores))
    short = line_scores(np.ones((1, 20)), averages=1)
    assert np.all(np.isnan(short[0, :LOWEST_LINE]))


def test_mean_over_median() -> None:
    assert mean_over_median(1) == pytest.approx(1.0 / log(2.0))
    assert mean_over_median(1000) == pytest.approx(1.0, abs=1e-3)
