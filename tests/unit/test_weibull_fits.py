"""Fits of Weibull's distribution: statuses, ties, censoring, ranks, fixed shape, prior, bias."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy import stats

from rolamento.errors import InputError
from rolamento.weibull import (
    LifeTest,
    ShapePrior,
    WeibullFit,
    fixed_shape,
    maximum_likelihood,
    median_rank,
    plotting_positions,
    posterior,
    rank_regression,
    three_parameter,
    unbiased,
)
from rolamento.weibull.drawing import FirstFailures, draw_fits
from rolamento.weibull.likelihood import Likelihood, Rows, fit_rows
from rolamento.weibull.sampled import bias_factor
from rolamento.words import Note

FIT = WeibullFit("maximum_likelihood", "converged", 2.0, 100.0, 50.0, size=3, failures=3)
WITHOUT = [
    ("no_failures", LifeTest([5.0, 6.0], False)),
    ("one_failure", LifeTest([5.0, 6.0], [True, False])),
    ("no_spread", LifeTest([5.0, 5.0, 4.0], [True, True, False])),
    ("no_spread", LifeTest([5.0], counts=7)),
    ("no_spread", LifeTest([5.0, 6.0], lower=[3.0, 4.0])),
    ("no_spread", LifeTest([5.0, 4.0], [True, False], lower=[0.0, np.nan], counts=2)),
    ("no_maximum", LifeTest([1.0, 9.0], [True, False], lower=[0.0, np.nan], counts=2)),
]


def test_life_and_reliability_are_each_others_inverse() -> None:
    r = np.array([0.999, 0.9, 0.5, np.exp(-1.0), 0.01])
    assert FIT.reliability_at(FIT.life_at(r)) == pytest.approx(r, rel=1e-13)
    assert FIT.l10 == pytest.approx(50.0 + 100.0 * np.sqrt(-np.log(0.9)))
    assert FIT.l50 == float(FIT.life_at(0.5))
    assert FIT.mean == pytest.approx(50.0 + stats.weibull_min(2.0, scale=100.0).mean())
    assert list(FIT.reliability_at([0.0, 50.0])) == [1.0, 1.0]


def test_the_scale_is_not_the_mean() -> None:
    """63.2 % do not reach the scale; of the usual shapes the mean is less."""
    fit = WeibullFit("maximum_likelihood", "converged", 2.0, 100.0)
    assert float(fit.reliability_at(100.0)) == pytest.approx(np.exp(-1.0))
    assert fit.mean < fit.scale
    assert WeibullFit("maximum_likelihood", "converged", 0.001, 1.0).mean == np.inf


@pytest.mark.parametrize("wrong", [90.0, 0.0, 1.0, np.nan, "most"])
def test_a_reliability_is_a_share(wrong: object) -> None:
    with pytest.raises(InputError, match=r"reliability.*(between 0 and 1|numbers)"):
        FIT.life_at(wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize(("code", "test"), WITHOUT, ids=lambda x: x if isinstance(x, str) else "")
def test_no_number_where_there_is_no_fit(code: str, test: LifeTest) -> None:
    fit = maximum_likelihood(test)
    assert (fit.code, fit.converged) == (code, False)
    assert np.isnan([fit.shape, fit.scale, fit.l10, fit.mean, fit.log_likelihood]).all()
    assert np.isnan(fit.reliability_at(5.0))
    assert fit.advice == Note(f"weibull_{code}")
    plain = json.loads(json.dumps(fit.to_mapping(), allow_nan=False))
    assert plain["l10"] is None
    assert plain["status"]["code"] == code


def test_likelihood_is_that_of_scipy() -> None:
    test = LifeTest([3.0, 5.0, 9.0, 9.0], [True, True, False, True], lower=[np.nan, 4.0, np.nan, 0])
    law = stats.weibull_min(1.7, scale=6.0)
    expected = (
        law.logpdf(3.0) + np.log(law.cdf(5.0) - law.cdf(4.0)) + law.logsf(9.0) + law.logcdf(9.0)
    )
    likelihood = Likelihood.of(test)
    a, b = np.array([1.7]), np.array([1.7 * (likelihood.origin - np.log(6.0))])
    assert likelihood.at(a, b).value[0] == pytest.approx(expected, rel=1e-13)
    assert likelihood.value(a, b)[0] == pytest.approx(expected, rel=1e-13)


def test_derivatives_of_the_likelihood() -> None:
    test = LifeTest(
        [3.0, 5.0, 9.0, 9.5, 7.0],
        [True, True, False, True, True],
        lower=[np.nan, 4.0, np.nan, 0.0, 1.0],
        counts=[1, 2, 3, 1, 2],
    )
    likelihood = Likelihood.of(test)
    a, b, step = np.array([1.7]), np.array([0.3]), 1e-5
    here = likelihood.at(a, b)
    for name, da, db in (("a", step, 0.0), ("b", 0.0, step)):
        more, less = likelihood.at(a + da, b + db), likelihood.at(a - da, b - db)
        slope = (more.value - less.value) / (2.0 * step)
        assert getattr(here, name) == pytest.approx(slope, rel=1e-8)
        for second in ("a", "b"):
            bend = (getattr(more, second) - getattr(less, second)) / (2.0 * step)
            field = {"aa": "aa", "ab": "ab", "ba": "ab", "bb": "bb"}[name + second]
            assert getattr(here, field) == pytest.approx(bend, rel=1e-7)


def test_maximum_likelihood_is_the_maximum() -> None:
    test = LifeTest([3.0, 5.0, 9.0, 9.5, 7.0], [1, 1, 0, 1, 1])
    fit = maximum_likelihood(test)
    likelihood = Likelihood.of(test)
    near = [
        likelihood.value(
            np.array([fit.shape * x]),
            np.array([fit.shape * x * (likelihood.origin - np.log(fit.scale * y))]),
        )[0]
        for x, y in ((1.001, 1.0), (0.999, 1.0), (1.0, 1.001), (1.0, 0.999))
    ]
    assert max(near) < fit.log_likelihood


def test_inspections_close_together_are_times() -> None:
    times = np.array([3.0, 5.0, 9.0, 9.5, 7.0])
    exact = maximum_likelihood(LifeTest(times))
    near = maximum_likelihood(LifeTest(times * (1.0 + 1e-7), lower=times * (1.0 - 1e-7)))
    assert near.shape == pytest.approx(exact.shape, rel=1e-8)
    assert near.scale == pytest.approx(exact.scale, rel=1e-8)


def test_times_over_six_decades() -> None:
    times = np.array([1.0, 30.0, 1e3, 4e4, 1e6])
    fit = maximum_likelihood(LifeTest(times))
    expected = stats.weibull_min.fit(times, floc=0.0)
    assert fit.shape == pytest.approx(expected[0], rel=1e-3)
    assert fit.scale == pytest.approx(expected[2], rel=1e-3)
    tight = maximum_likelihood(LifeTest([1e6, 1e6 + 1.0, 1e6 + 2.0]))
    assert tight.converged
    assert tight.shape > 1e5


def test_batch_fits_are_single_fits() -> None:
    random = np.random.default_rng(1)
    times = random.weibull(1.5, (60, 8))
    ends = random.uniform(0.05, 2.0, (60, 8))
    failed = times <= ends
    times = np.minimum(times, ends)
    batch = fit_rows(Rows(np.log(times), failed.astype(float), np.ones(8)))
    codes = {0: "converged", 1: "no_failures", 3: "no_spread"}
    seen = set()
    for i in range(60):
        fit = maximum_likelihood(LifeTest(times[i], failed[i]))
        if fit.failures == 1:
            continue
        assert fit.code == codes[int(batch.code[i])]
        seen.add(fit.code)
        if fit.converged:
            assert batch.shape[i] == pytest.approx(fit.shape, rel=1e-11)
            assert np.exp(batch.log_scale[0, i]) == pytest.approx(fit.scale, rel=1e-11)
    assert "converged" in seen


def test_a_batch_of_what_has_no_fit_poisons_nothing() -> None:
    log_time = np.log([[1.0, 2.0, 3.0], [1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0]])
    failures = np.array([[1.0, 1, 1], [1, 1, 1], [0, 0, 0], [1, 1, 1]])
    batch = fit_rows(Rows(log_time, failures, np.ones(3)))
    assert list(batch.code) == [0, 3, 1, 0]
    assert np.isnan(batch.shape[[1, 2]]).all()
    assert batch.shape[0] == pytest.approx(batch.shape[3], rel=1e-12)


def test_three_parameters_find_a_life_free_of_failures() -> None:
    random = np.random.default_rng(3)
    times = 500.0 + 200.0 * random.weibull(1.8, 400)
    fit = three_parameter(LifeTest(times))
    assert fit.converged
    assert fit.location == pytest.approx(500.0, abs=10.0)
    assert fit.shape == pytest.approx(1.8, rel=0.1)
    assert fit.location < times.min()
    assert fit.log_likelihood > maximum_likelihood(LifeTest(times)).log_likelihood
    assert Note("likelihood_unbounded") in fit.notes
    rounded = LifeTest(np.ceil(times), lower=np.floor(times))
    assert three_parameter(rounded).location == pytest.approx(fit.location, abs=1.0)


def test_three_parameters_may_be_two() -> None:
    times = [271.3, 402.2, 430.3, 460.9]
    fit, plain = three_parameter(LifeTest(times)), maximum_likelihood(LifeTest(times))
    assert fit.location == 0.0
    assert Note("location_at_zero") in fit.notes
    assert fit.shape == pytest.approx(plain.shape, rel=1e-12)
    assert fit.log_likelihood == pytest.approx(plain.log_likelihood, rel=1e-12)


def test_three_parameters_may_be_none() -> None:
    # the first far ahead in density: the likelihood only grows toward it
    times = [152.7, 172.0, 172.5, 173.3, 193.0, 204.7, 216.5, 234.9, 262.6, 422.6]
    fit = three_parameter(LifeTest(times))
    assert fit.code == "no_maximum"
    assert np.isnan(fit.location)
    assert three_parameter(LifeTest([1.0, 2.0])).code == "no_maximum"
    assert three_parameter(LifeTest([1.0, 2.0], [1, 0])).code == "one_failure"
    assert three_parameter(LifeTest([2.0], counts=4)).code == "no_spread"


def test_median_ranks() -> None:
    assert median_rank([1.0, 2.0, 3.0, 4.0], 4) == pytest.approx(
        stats.beta([1, 2, 3, 4], [4, 3, 2, 1]).median(), rel=1e-12
    )
    assert median_rank(1.0, 1) == pytest.approx(0.5)
    assert median_rank(2.0, 9, "benard") == pytest.approx(1.7 / 9.4)
    assert median_rank([3.0, 7.0], 10, "benard") == pytest.approx(
        median_rank([3.0, 7.0], 10), abs=2e-3
    )


def test_adjusted_ranks_of_johnson() -> None:
    """Abernethy's eight: three suspensions, ranks 1.125, 2.4375, 3.75, 5.0625, 6.375."""
    test = LifeTest([10, 30, 45, 49, 82, 90, 96, 100], [0, 1, 0, 1, 1, 1, 1, 0])
    points = plotting_positions(test)
    assert list(points.rank) == pytest.approx([1.125, 2.4375, 3.75, 5.0625, 6.375])
    assert list(points.times) == [30.0, 49.0, 82.0, 90.0, 96.0]
    assert np.exp(points.x) == pytest.approx(points.times)
    assert 1.0 - np.exp(-np.exp(points.y)) == pytest.approx(points.failed_share)


def test_ranks_step_by_step() -> None:
    random = np.random.default_rng(7)
    times, failed = random.permutation(40) + 1.0, random.random(40) < 0.6
    order = np.argsort(times)
    rank, expected = 0.0, []
    for place, index in enumerate(order):
        if failed[index]:
            rank += (41.0 - rank) / (1.0 + 40.0 - place)
            expected.append(rank)
    assert list(plotting_positions(LifeTest(times, failed)).rank) == pytest.approx(expected)


def test_ties_take_successive_ranks_and_failures_come_first() -> None:
    points = plotting_positions(LifeTest([5.0, 5.0, 8.0], [True, False, True], counts=[2, 1, 1]))
    assert list(points.rank) == pytest.approx([1.0, 2.0, 3.5])
    assert list(points.times) == [5.0, 5.0, 8.0]


def test_rank_regression_on_points_of_a_line() -> None:
    share = median_rank(np.arange(1.0, 9.0), 8)
    times = 300.0 * (-np.log1p(-share)) ** (1.0 / 1.4)
    for regression in ("x_on_y", "y_on_x"):
        fit = rank_regression(LifeTest(times), regression)
        assert fit.shape == pytest.approx(1.4, rel=1e-10)
        assert fit.scale == pytest.approx(300.0, rel=1e-10)
        assert fit.correlation == pytest.approx(1.0)


def test_rank_regressions_differ_by_the_correlation() -> None:
    test = LifeTest([271.3, 402.2, 430.3, 460.9])
    x, y = rank_regression(test, "x_on_y"), rank_regression(test, "y_on_x")
    assert y.shape / x.shape == pytest.approx(x.correlation**2, rel=1e-12)


def test_rank_regression_without_a_line() -> None:
    assert rank_regression(LifeTest([5.0], counts=3)).code == "no_spread"
    assert rank_regression(LifeTest([5.0, 6.0], [0, 1])).code == "one_failure"
    assert rank_regression(LifeTest([5.0, 6.0], False)).code == "no_failures"
    early = LifeTest([1.0, 1.1, 1.2, 5.0, 6.0], [0, 0, 0, 1, 1])
    assert Note("suspensions_early") in rank_regression(early).notes
    with pytest.raises(InputError, match="inspections"):
        rank_regression(LifeTest([5.0, 6.0], lower=[1.0, 2.0]))
    with pytest.raises(InputError, match=r"regression.*x_on_y"):
        rank_regression(LifeTest([5.0, 6.0]), "z_on_y")  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"ranks.*median"):
        rank_regression(LifeTest([5.0, 6.0]), ranks="mean")  # type: ignore[arg-type]


def test_fixed_shape() -> None:
    test = LifeTest([3.0, 5.0, 9.0], [True, True, False])
    fit = fixed_shape(test, 2.0)
    assert fit.scale == pytest.approx(np.sqrt((9.0 + 25.0 + 81.0) / 2.0))
    assert fixed_shape(test, maximum_likelihood(test).shape).scale == pytest.approx(
        maximum_likelihood(test).scale, rel=1e-10
    )
    nothing = fixed_shape(LifeTest([3.0], False), 2.0)
    assert (nothing.code, nothing.shape) == ("no_failures", 2.0)
    assert np.isnan(nothing.scale)
    one = fixed_shape(LifeTest([3.0, 4.0], [True, False]), 1.0)
    assert one.scale == pytest.approx(7.0)
    inspected = LifeTest([3.0, 5.0, 9.0], lower=[1.0, 3.0, 5.0])
    free = maximum_likelihood(inspected)
    assert fixed_shape(inspected, free.shape).scale == pytest.approx(free.scale, rel=1e-9)
    with pytest.raises(InputError, match="shape"):
        fixed_shape(test, 0.0)


@pytest.mark.parametrize("size", [4, 6, 10, 20, 50])
@pytest.mark.thirds
def test_unbiasing_formula_of_ross(size: int) -> None:
    """Ross (1994) against drawn tests."""
    fits = draw_fits(FirstFailures(size, size), 1.0, 0.0, 100_000, np.random.default_rng(size))
    assert bias_factor(size) * fits.shape.mean() == pytest.approx(1.0, abs=0.008)


def test_unbiasing_factors_of_thoman_bain_and_antle() -> None:
    """Their table 1 (1969), from 10 000 samples each, is within its own scatter."""
    for size, factor in ((10, 0.859), (14, 0.901), (20, 0.931), (30, 0.955), (40, 0.966)):
        fits = draw_fits(FirstFailures(size, size), 1.0, 0.0, 50_000, np.random.default_rng(size))
        assert 1.0 / fits.shape.mean() == pytest.approx(factor, abs=0.006)


def test_unbiased_fits() -> None:
    test = LifeTest([3.0, 5.0, 9.0, 11.0, 4.0, 7.0])
    plain = maximum_likelihood(test)
    ross, mean, median = (unbiased(test, c, seed=1) for c in ("ross", "mean", "median"))
    assert ross.shape == pytest.approx(plain.shape * 4.0 / 5.32)
    assert mean.shape == pytest.approx(ross.shape, rel=0.02)
    assert mean.shape < median.shape < plain.shape
    assert median.scale == plain.scale
    assert median.log_likelihood < plain.log_likelihood
    suspended = LifeTest([3.0, 5.0, 9.0, 9.0], [1, 1, 1, 0])
    assert unbiased(suspended, "median").notes[-1:] == (Note("few_failures"),)
    clocked = unbiased(LifeTest([3.0, 5.0, 7.0, 9.0], [1, 1, 1, 0]))
    assert clocked.shape < maximum_likelihood(LifeTest([3.0, 5.0, 7.0, 9.0], [1, 1, 1, 0])).shape
    assert Note("censoring_modelled") in clocked.notes


def test_no_mean_no_correction() -> None:
    assert unbiased(LifeTest([3.0, 5.0]), "mean").code == "no_mean"
    assert unbiased(LifeTest([3.0, 5.0, 7.0, 9.0], [1, 1, 1, 0]), "mean").code == "no_mean"
    assert unbiased(LifeTest([3.0], counts=3)).code == "no_spread"
    mixed = LifeTest([3.0, 5.0, 8.0], lower=[np.nan, 4.0, 6.0])
    assert unbiased(mixed).code == "not_modelled"
    with pytest.raises(InputError, match="ross"):
        unbiased(LifeTest([3.0, 5.0, 7.0, 9.0], [1, 1, 1, 0]), "ross")


def test_prior() -> None:
    prior = ShapePrior(1.0, 2.0, 0.8)
    u = np.linspace(-8.0, 8.0, 20001)
    density = np.exp(prior.log_density(u))
    inside = (u > 0.0) & (u < np.log(2.0))
    assert density[inside].sum() / density.sum() == pytest.approx(0.8, abs=1e-3)
    for wrong, message in (
        ({"low": 2.0, "high": 1.0}, "high.*greater than low"),
        ({"low": 0.0, "high": 1.0}, "low"),
        ({"low": 1.0, "high": 2.0, "probability": 90.0}, "probability"),
        ({"low": 1.0, "high": 2.0, "kind": "gamma"}, "kind"),
    ):
        with pytest.raises(InputError, match=message):
            ShapePrior(**wrong)  # type: ignore[arg-type]


def test_posterior_against_a_plain_sum() -> None:
    """Over a fine grid of both parameters."""
    times, failed = np.array([3.0, 5.0, 9.0, 9.0]), np.array([True, True, True, False])
    prior = ShapePrior(1.0, 3.0)
    u, v = np.linspace(-1.2, 3.0, 1201)[:, np.newaxis], np.linspace(-1.0, 6.0, 1601)
    beta = np.exp(u)
    log_density = prior.log_density(u) + np.zeros_like(v)
    for t, f in zip(times, failed, strict=True):
        log_density = log_density - np.exp(beta * (np.log(t) - v))
        log_density = log_density + f * (np.log(beta) + beta * (np.log(t) - v))
    weight = np.exp(log_density - log_density.max())
    weight /= weight.sum()
    found = posterior(LifeTest(times, failed), prior)
    quantities = {
        "shape": beta + 0.0 * v,
        "scale": np.exp(v) + 0.0 * beta,
        "L10": np.exp(v + np.log(-np.log(0.9)) / beta),
        "R4": np.exp(-np.exp(beta * (np.log(4.0) - v))),
    }
    for name, values in quantities.items():
        order = np.argsort(values.ravel())
        sums = np.cumsum(weight.ravel()[order])
        for p in (0.05, 0.5, 0.95):
            expected = values.ravel()[order][np.searchsorted(sums, p)]
            assert found.quantile(name, p) == pytest.approx(expected, rel=2e-3), (name, p)
            assert found.probability_below(name, expected) == pytest.approx(p, abs=2e-3)
    low, high = found.interval("L10", 0.9)
    assert (low, high) == pytest.approx((found.quantile("L10", 0.05), found.quantile("L10", 0.95)))


def test_posterior_of_a_sure_shape_is_that_of_a_fixed_one() -> None:
    from rolamento.weibull import bounds

    test = LifeTest([3.0, 5.0, 9.0, 4.0])
    sure = posterior(test, ShapePrior(1.4999, 1.5001, kind="uniform"))
    known = bounds(test, "L10", shape=1.5)
    assert sure.interval("L10") == pytest.approx((known.lower, known.upper), rel=1e-3)


def test_posterior_of_inspections() -> None:
    times, prior = np.array([3.0, 5.0, 9.0, 4.0]), ShapePrior(1.0, 2.5)
    exact = posterior(LifeTest(times), prior)
    near = posterior(LifeTest(times * 1.0001, lower=times * 0.9999), prior)
    for name in ("shape", "scale", "L10", "R4"):
        assert near.interval(name) == pytest.approx(exact.interval(name), rel=2e-3)


def test_posterior_with_one_failure_and_with_none() -> None:
    prior = ShapePrior(1.0, 2.5)
    one = posterior(LifeTest([5.0, 9.0, 9.0], [1, 0, 0]), prior)
    assert 0.0 < one.quantile("L10", 0.05) < one.quantile("L10", 0.95)
    none = posterior(LifeTest([5.0], False), prior)
    assert none.code == "no_failures"
    assert none.advice == Note("weibull_no_failures")
    assert np.isnan(none.quantile("L10", 0.5))
    assert np.isnan(none.probability_below("L10", 0.5))
    early = posterior(LifeTest([5.0], lower=[0.0]), prior)
    assert early.code == "no_maximum"


def test_few_failures_are_noted() -> None:
    assert maximum_likelihood(LifeTest([1.0, 2.0])).notes == (Note("few_failures"),)
