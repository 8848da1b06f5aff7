"""Confidence bounds: each method against plain calculation, statuses, seeds, sizes."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy import stats
from scipy.optimize import brentq, minimize_scalar

from rolamento.errors import InputError
from rolamento.weibull import (
    METHODS,
    Estimand,
    LifeTest,
    Method,
    all_bounds,
    bounds,
    maximum_likelihood,
    pivotal_draws,
)
from rolamento.weibull.drawing import (
    Blocks,
    FirstFailures,
    draw_fits,
    model_of,
)
from rolamento.words import Note

TIMES = [54.0, 187, 216, 240, 244, 335, 361, 373, 375, 386, 500]
CLOCKED = LifeTest(TIMES, [True] * 10 + [False], counts=[1] * 10 + [10])
COMPLETE = LifeTest(TIMES)
RIGS = LifeTest.sudden_death([120.0, 300, 500, 700, 450], 4)
WITHDRAWN = LifeTest(TIMES, [1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 0])
INSPECTED = LifeTest([100.0, 200, 300, 300], [1, 1, 1, 0], lower=[0.0, 100, 200, np.nan], counts=3)
ALL = (CLOCKED, COMPLETE, RIGS, WITHDRAWN, INSPECTED)
DRAWING = tuple(m for m in METHODS if m not in ("fisher", "likelihood_ratio", "fixed_shape"))
NAMES = ("shape", "scale", "L10", "R100")


def test_words_of_quantities() -> None:
    assert Estimand.of("L10").value == pytest.approx(0.9)
    assert Estimand.of("l0.1").name == "L0.1"
    assert Estimand.of("R1.5e3").value == 1500.0
    assert Estimand.of("scale").log_risk == pytest.approx(0.0, abs=1e-15)
    assert Estimand.of(Estimand.life(0.95)).name == "L5"
    for wrong in ("L100", "L0", "R0", "L", "mean", "L10x", "", "R-1", "R1e99", None, 10):
        with pytest.raises(InputError, match="quantity"):
            Estimand.of(wrong)  # type: ignore[arg-type]


def test_values_of_quantities() -> None:
    shape, log_scale = np.array([2.0, 0.5]), np.log([100.0, 100.0])
    law = stats.weibull_min([2.0, 0.5], scale=100.0)
    assert Estimand.of("shape").at(shape, log_scale) == pytest.approx([2.0, 0.5])
    assert Estimand.of("scale").at(shape, log_scale) == pytest.approx(100.0)
    assert Estimand.of("L10").at(shape, log_scale) == pytest.approx(law.ppf(0.1))
    assert Estimand.of("R50").at(shape, log_scale) == pytest.approx(law.sf(50.0))


@pytest.mark.parametrize("test", ALL, ids=lambda t: t.scheme)
@pytest.mark.parametrize("method", METHODS[:-1])
@pytest.mark.thirds
def test_bounds_of_every_method_for_every_kind_of_test(method: Method, test: LifeTest) -> None:
    fit = maximum_likelihood(test)
    found = all_bounds(test, NAMES, method=method, samples=2000)
    for bound, estimate in zip(
        found, (fit.shape, fit.scale, fit.l10, float(fit.reliability_at(100.0))), strict=True
    ):
        assert bound.code == "converged"
        assert bound.method == method
        assert bound.estimate == pytest.approx(estimate, rel=1e-12)
        assert 0.0 < bound.lower < bound.upper
        assert bound.lower < 1.3 * estimate
        assert bound.upper > 0.7 * estimate
        assert bound.unit == ("h" if bound.quantity in ("scale", "L10") else "")
        json.dumps(bound.to_mapping(), allow_nan=False)


def test_likelihood_ratio_against_plain_profiles() -> None:
    x = np.array(TIMES[:10] + [500.0] * 10)
    failed = np.arange(20) < 10
    fit = maximum_likelihood(CLOCKED)
    limit = stats.chi2.ppf(0.9, 1)

    def value(shape: float, log_scale: float) -> float:
        z = shape * (np.log(x) - log_scale)
        return float(np.sum(failed * (np.log(shape) + z - np.log(x))) - np.sum(np.exp(z)))

    def best(w: float, c: float) -> float:
        """Through the point (c, w) of the Weibull plot."""
        found = minimize_scalar(
            lambda u: -value(np.exp(u), c - w / np.exp(u)),
            bounds=(-3.0, 4.0),
            method="bounded",
            options={"xatol": 1e-12},
        )
        return -float(found.fun)

    def best_scale(shape: float) -> float:
        return value(shape, float(np.log(np.sum(x**shape) / 10.0) / shape))

    w, c = np.log(-np.log(0.9)), np.log(100.0)
    w0 = fit.shape * (c - np.log(fit.scale))
    expected = {
        "L10": [
            np.exp(brentq(lambda u: 2 * (fit.log_likelihood - best(w, u)) - limit, a, b))
            for a, b in ((2.0, np.log(fit.l10)), (np.log(fit.l10), 8.0))
        ],
        "R100": [
            np.exp(-np.exp(brentq(lambda u: 2 * (fit.log_likelihood - best(u, c)) - limit, a, b)))
            for a, b in ((w0, w0 + 5.0), (w0 - 6.0, w0))
        ],
        "shape": [
            brentq(lambda u: 2 * (fit.log_likelihood - best_scale(u)) - limit, a, b)
            for a, b in ((0.2, fit.shape), (fit.shape, 9.0))
        ],
    }
    for name, limits in expected.items():
        found = bounds(CLOCKED, name, method="likelihood_ratio")
        assert (found.lower, found.upper) == pytest.approx(limits, rel=1e-6), name


def test_fisher_against_numerical_curvature() -> None:
    fit = maximum_likelihood(WITHDRAWN)
    x, failed = np.array(TIMES), WITHDRAWN.failed

    def value(u: np.ndarray) -> float:
        z = np.exp(u[0]) * (np.log(x) - u[1])
        return float(np.sum(failed * (u[0] + z)) - np.sum(np.exp(z)))

    at, h = np.array([np.log(fit.shape), np.log(fit.scale)]), 1e-4
    bend = np.empty((2, 2))
    for i in range(2):
        for j in range(2):
            e, f = h * np.eye(2)[i], h * np.eye(2)[j]
            bend[i, j] = (
                value(at + e + f) - value(at + e - f) - value(at - e + f) + value(at - e - f)
            ) / (4 * h * h)
    spread = np.sqrt(np.diag(np.linalg.inv(-bend)))
    for name, center, s in zip(("shape", "scale"), at, spread, strict=True):
        found = bounds(WITHDRAWN, name, method="fisher")
        expected = np.exp(center + stats.norm.ppf([0.05, 0.95]) * s)
        assert (found.lower, found.upper) == pytest.approx(expected, rel=1e-5)


def test_pivots_by_hand() -> None:
    """Bounds from quantiles of β̂/β and of β̂ ln(t̂/t), drawn apart."""
    fits = draw_fits(FirstFailures(11, 11), 1.0, 0.0, 40_000, np.random.default_rng(5))
    fit = maximum_likelihood(COMPLETE)
    found = bounds(COMPLETE, "shape", samples=40_000)
    w = np.quantile(fits.shape, [0.95, 0.05])
    assert (found.lower, found.upper) == pytest.approx(fit.shape / w, rel=0.02)
    risk = np.log(-np.log(0.9))
    u = np.quantile(fits.shape * (fits.log_scale[0] + risk / fits.shape - risk), [0.95, 0.05])
    found = bounds(COMPLETE, "L10", samples=40_000)
    assert (found.lower, found.upper) == pytest.approx(fit.l10 * np.exp(-u / fit.shape), rel=0.04)


def test_pivots_do_not_depend_on_what_they_are_drawn_from() -> None:
    for model in (FirstFailures(8, 5), Blocks.of(RIGS)):
        one = draw_fits(model, 0.7, 3.0, 5000, np.random.default_rng(2))
        other = draw_fits(model, 4.0, -9.0, 5000, np.random.default_rng(2))
        assert one.shape / 0.7 == pytest.approx(other.shape / 4.0, rel=1e-8)
        shift = other.shape * (other.log_scale[0] + 9.0)
        assert one.shape * (one.log_scale[0] - 3.0) == pytest.approx(shift, rel=1e-7, abs=1e-7)


def test_reliability_bounds_are_life_bounds_read_the_other_way() -> None:
    low = bounds(WITHDRAWN, "L20", sides="lower", samples=2000).lower
    back = bounds(WITHDRAWN, Estimand.reliability(low), sides="lower", samples=2000)
    assert back.lower == pytest.approx(0.8, abs=2e-3)


def test_one_side_is_half_of_two() -> None:
    for method in METHODS[:-1]:
        two = bounds(RIGS, "L10", method=method, samples=1000)
        lower = bounds(RIGS, "L10", method=method, confidence=0.95, sides="lower", samples=1000)
        upper = bounds(RIGS, "L10", method=method, confidence=0.95, sides="upper", samples=1000)
        assert (lower.lower, lower.upper) == (pytest.approx(two.lower), np.inf)
        assert (upper.lower, upper.upper) == (0.0, pytest.approx(two.upper))
    assert bounds(RIGS, "R100", sides="lower", samples=100).upper == 1.0


@pytest.mark.parametrize("method", DRAWING)
def test_the_same_seed_the_same_bounds(method: Method) -> None:
    first, again, other = (
        bounds(CLOCKED, "L10", method=method, samples=500, seed=seed) for seed in (3, 3, 4)
    )
    assert (first.lower, first.upper) == (again.lower, again.upper)
    assert first.lower != other.lower
    assert first.seed == 3
    assert first.samples == 500


def test_methods_agree_where_failures_are_many() -> None:
    times = 1000.0 * np.random.default_rng(8).weibull(1.5, 600)
    test = LifeTest(times)
    reference = bounds(test, "L10", method="likelihood_ratio")
    for method in METHODS[:-1]:
        found = bounds(test, "L10", method=method, samples=2000)
        assert found.lower == pytest.approx(reference.lower, rel=0.04), method
        assert found.upper == pytest.approx(reference.upper, rel=0.04), method


def test_fixed_shape_is_chi_square() -> None:
    test = LifeTest([3.0, 5.0, 9.0], [True, True, False])
    total, k = 9.0 + 25.0 + 81.0, -np.log(0.9)
    found = bounds(test, "L10", shape=2.0)
    assert found.method == "fixed_shape"
    expected = [np.sqrt(k * 2.0 * total / stats.chi2.ppf(p, f)) for p, f in ((0.95, 6), (0.05, 4))]
    assert (found.lower, found.upper) == pytest.approx(expected)
    failed = LifeTest([3.0, 5.0, 9.0])  # ended by a failure: exact on both sides
    found = bounds(failed, "scale", shape=2.0)
    expected = [np.sqrt(2.0 * total / stats.chi2.ppf(p, 6)) for p in (0.95, 0.05)]
    assert (found.lower, found.upper) == pytest.approx(expected)
    time = bounds(failed, "R4", shape=2.0)
    risk = [(4.0 / scale) ** 2 for scale in expected]
    assert (time.lower, time.upper) == pytest.approx(np.exp(-np.array(risk)))


def test_no_failures_still_bound_from_below() -> None:
    test = LifeTest([160.0] * 10, False)
    free = bounds(test, "L10")
    assert (free.code, free.advice) == ("no_failures", Note("weibull_no_failures"))
    assert np.isnan([free.lower, free.upper, free.estimate]).all()
    found = bounds(test, "L10", shape=1.5, sides="lower")
    # all ten survive with probability 0.1 if the life is that
    assert np.exp(10.0 * np.log(0.9) * (160.0 / found.lower) ** 1.5) == pytest.approx(0.1)
    assert found.upper == np.inf
    assert found.to_mapping()["upper"] is None


def test_inspected_failures_bound_on_the_safe_side() -> None:
    exact = bounds(LifeTest([200.0, 300, 300], [1, 1, 0]), "L10", shape=1.5)
    found = bounds(
        LifeTest([220.0, 320, 300], [1, 1, 0], lower=[180.0, 280, np.nan]), "L10", shape=1.5
    )
    assert found.lower < exact.lower
    assert found.upper > exact.upper
    zero = bounds(LifeTest([220.0], lower=[0.0]), "L10", shape=1.5)
    assert zero.lower == 0.0


@pytest.mark.parametrize(
    ("code", "test"),
    [
        ("no_failures", LifeTest([5.0], False)),
        ("one_failure", LifeTest([5.0, 6.0], [1, 0])),
        ("no_spread", LifeTest([5.0], counts=4)),
    ],
)
def test_no_fit_no_bounds(code: str, test: LifeTest) -> None:
    for method in METHODS[:-1]:
        found = bounds(test, "L10", method=method, samples=100)
        assert found.code == code
        assert np.isnan([found.lower, found.upper]).all()


def test_what_cannot_be_drawn() -> None:
    mixed = LifeTest([3.0, 5.0, 8.0], lower=[np.nan, 4.0, 6.0])
    for method in ("pivotal", "parametric_percentile", "calibrated_likelihood_ratio"):
        assert bounds(mixed, method=method, samples=100).code == "not_modelled"
    assert bounds(mixed).method == "likelihood_ratio"
    assert bounds(mixed).converged
    assert bounds(mixed, method="bootstrap_percentile", samples=200).converged
    large = LifeTest([3.0, 5.0, 8.0], counts=10_000)
    assert bounds(large, method="pivotal").code == "too_large"
    assert bounds(large, method="bootstrap_bca", samples=200).code == "too_large"
    assert bounds(large).method == "likelihood_ratio"
    many = LifeTest(np.linspace(1.0, 9.0, 2001))
    assert bounds(many, method="bootstrap_percentile", samples=100).code == "too_large"


def test_notes_say_what_was_assumed() -> None:
    assert bounds(COMPLETE, samples=100).notes == ()
    assert bounds(RIGS, samples=100).notes == ()
    assert bounds(CLOCKED, samples=100).notes == (Note("censoring_modelled"),)
    assert bounds(INSPECTED, samples=100).notes == (Note("inspections_shared"),)
    assert Note("large_sample_method") in bounds(COMPLETE, method="fisher").notes
    few = LifeTest([3.0, 5.0, 5.0], [1, 1, 0], counts=[1, 1, 8])
    assert bounds(few, samples=200).notes == (Note("few_failures"),)
    clocked = LifeTest([3.0, 5.0, 6.0], [1, 1, 0], counts=[1, 1, 40])
    found = bounds(clocked, samples=1000)
    assert found.dropped > 0
    assert Note("many_without_fit") in found.notes
    assert all(note.text != note.key for note in found.notes)


@pytest.mark.parametrize(
    ("match", "given"),
    [
        ("method", {"method": "wald"}),
        ("confidence", {"confidence": 90}),
        ("confidence", {"confidence": None}),
        ("sides", {"sides": "both"}),
        ("samples", {"samples": 10}),
        ("samples", {"samples": 1e4}),
        ("samples", {"samples": True}),
        ("seed", {"seed": -1}),
        ("seed", {"seed": 1.5}),
        ("shape", {"shape": 0.0}),
        ("shape", {"shape": 1.5, "method": "pivotal"}),
        ("shape", {"method": "fixed_shape"}),
        ("quantity", {"quantity": "B10 life"}),
        ("shape", {"quantity": "shape", "shape": 2.0}),
    ],
)
def test_wrong_questions(match: str, given: dict[str, object]) -> None:
    with pytest.raises(InputError, match=match):
        bounds(COMPLETE, **given)  # type: ignore[arg-type]


def test_quantities_are_one_at_least_and_not_too_many() -> None:
    with pytest.raises(InputError, match="quantities"):
        all_bounds(COMPLETE, [])
    with pytest.raises(InputError, match="quantities"):
        all_bounds(COMPLETE, ["L10"] * 1001)


def test_clock_times_are_drawn_beyond_the_failure() -> None:
    """Kaplan-Meier of the suspensions, by hand: 0.3 at 4, 0.35 at 6, the rest at 9."""
    test = LifeTest([2.0, 4.0, 5.0, 6.0, 9.0], [1, 0, 1, 0, 0], counts=[1, 3, 3, 2, 2])
    model = model_of(test)
    assert isinstance(model, Blocks)
    assert not model.exact
    ends = np.exp(model.ends(20_000, np.random.default_rng(0)))
    of_first, of_second = ends[:, 0], ends[:, 1]
    assert np.mean(np.isclose(of_first, 4.0)) == pytest.approx(0.3, abs=0.02)
    assert np.mean(np.isclose(of_first, 6.0)) == pytest.approx(0.35, abs=0.02)
    assert np.mean(np.isclose(of_second, 4.0)) == 0.0
    assert np.mean(np.isclose(of_second, 6.0)) == pytest.approx(0.5, abs=0.02)


def test_drawn_tests_of_one_clock_stop_at_it() -> None:
    model = model_of(CLOCKED)
    assert isinstance(model, Blocks)
    rows = model.rows(1.5, np.log(600.0), 500, np.random.default_rng(0))
    assert np.exp(rows.log_time).max() == pytest.approx(500.0)
    suspended = rows.failures == 0.0
    assert np.allclose(np.exp(rows.log_time[suspended]), 500.0)
    share = 1.0 - np.exp(-((500.0 / 600.0) ** 1.5))
    assert rows.failures.mean() == pytest.approx(share, abs=0.02)


def test_order_statistics_of_the_first_failures() -> None:
    rows = FirstFailures(10, 4).rows(2.0, np.log(5.0), 40_000, np.random.default_rng(0))
    plain = np.sort(5.0 * np.random.default_rng(1).weibull(2.0, (40_000, 10)), axis=1)[:, :4]
    assert np.exp(rows.log_time).mean(axis=0) == pytest.approx(plain.mean(axis=0), rel=0.01)
    assert np.exp(rows.log_time).std(axis=0) == pytest.approx(plain.std(axis=0), rel=0.02)
    assert list(rows.units) == [1.0, 1.0, 1.0, 7.0]


def test_draws_answer_any_question() -> None:
    draws = pivotal_draws(COMPLETE, maximum_likelihood(COMPLETE), 4000, np.random.default_rng(0))
    found = bounds(COMPLETE, "L10", samples=4000)
    limits = np.quantile(draws.of(Estimand.of("L10")), [0.05, 0.95])
    assert (found.lower, found.upper) == pytest.approx(limits)


@pytest.mark.parametrize("quantity", ["shape", "L10"])
@pytest.mark.sweep
def test_pivotal_bounds_hold_as_often_as_they_say(quantity: str) -> None:
    """Six bearings, four failures; 400 tests: 90 % within three standard errors."""
    random = np.random.default_rng(12)
    true = {"shape": 1.5, "L10": (-np.log(0.9)) ** (1.0 / 1.5)}[quantity]
    hits = 0
    for i in range(400):
        times = np.sort(random.weibull(1.5, 6))
        test = LifeTest(np.minimum(times, times[3]), np.arange(6) < 4)
        found = bounds(test, quantity, samples=400, seed=i)
        hits += found.lower <= true <= found.upper
    assert hits / 400 == pytest.approx(0.9, abs=0.045)


@pytest.mark.sweep
def test_likelihood_ratio_with_few_failures_does_not_hold_and_its_calibration_does() -> None:
    random = np.random.default_rng(13)
    hits = {"likelihood_ratio": 0, "calibrated_likelihood_ratio": 0}
    for i in range(100):
        times = np.sort(random.weibull(1.5, 6))
        test = LifeTest(np.minimum(times, times[2]), np.arange(6) < 3)
        for method in hits:
            found = bounds(test, "shape", method=method, samples=400, seed=i)  # type: ignore[arg-type]
            hits[method] += found.lower <= 1.5 <= found.upper
    assert hits["likelihood_ratio"] < 85
    assert hits["calibrated_likelihood_ratio"] == pytest.approx(90, abs=9)


def test_a_side_on_which_the_likelihood_hardly_falls_is_open() -> None:
    """It falls by so much nowhere within what is searched; the end of the search is no limit."""
    test = LifeTest(np.array([1.0, 2.0]), np.array([True, True]))
    found = bounds(test, "L10", method="likelihood_ratio", confidence=1.0 - 1e-13)
    assert found.converged
    assert found.lower == 0.0
    assert found.upper == np.inf
