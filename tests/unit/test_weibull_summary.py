"""All that a life test says: fits, bounds, band, regions of equal likelihood."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.weibull import (
    Estimand,
    LifeTest,
    LifeTestRequest,
    ShapePrior,
    against_calculated_life,
    all_bounds,
    compare,
    confidence_band,
    life_ratio,
    likelihood_region,
    maximum_likelihood,
    published_life_test,
    summarise,
)

SAMPLES = 500


@pytest.fixture(scope="module")
def campanha() -> LifeTest:
    return published_life_test("campanha_2008")


def inspected() -> LifeTest:
    nan = float("nan")
    return LifeTest(
        [100, 150, 200, 250, 250],
        [True, True, True, True, False],
        lower=[50, 100, 150, 200, nan],
        counts=[1, 3, 4, 2, 10],
    )


def test_a_group_is_told_as_the_engine_tells_it(campanha: LifeTest) -> None:
    wanted = LifeTestRequest(samples=SAMPLES, times=(100.0,), calculated={"ISO 281": 58.0})
    found = summarise(campanha, wanted)
    first, second = found.groups
    part = campanha.by_group()["I"]
    assert (first.name, second.name) == ("I", "II")
    assert first.main.shape == maximum_likelihood(part).shape
    (bound,) = all_bounds(part, ["L10"], samples=SAMPLES)
    own = first.bound(Estimand.of("L10"))
    assert own is not None
    assert (own.lower, own.upper) == (bound.lower, bound.upper)
    assert [one.quantity for one in first.bounds] == ["shape", "scale", "L10", "L50", "R100"]
    verdict = against_calculated_life(part, 58.0, samples=SAMPLES)
    assert first.calculated["ISO 281"].p_value == verdict.p_value
    assert not second.has_result
    assert found.has_result


def test_a_group_without_failures_is_told_for_usual_shapes(campanha: LifeTest) -> None:
    group = summarise(campanha, LifeTestRequest(samples=SAMPLES)).groups[1]
    assert not group.bounded
    for assumed in group.assumed:
        (bound,) = all_bounds(
            group.test, ["L10"], shape=assumed.shape, sides="lower", confidence=0.95
        )
        assert assumed.bounds[0].lower == bound.lower
        assert assumed.bounds[0].sides == "lower"


def test_a_known_shape_bounds_a_test_without_failures(campanha: LifeTest) -> None:
    found = summarise(campanha, LifeTestRequest(shape=1.5, samples=SAMPLES))
    for group in found.groups:
        assert group.main.method == "fixed_shape"
        assert group.has_result
        assert not group.assumed
        assert all(bound.method == "fixed_shape" for bound in group.bounds)
    failed, whole = found.groups
    assert failed.bounds[0].sides == "two"
    assert whole.bounds[0].sides == "lower"
    assert np.isfinite(whole.bounds[0].lower)


def test_groups_are_compared_as_the_engine_compares_them(campanha: LifeTest) -> None:
    found = summarise(campanha, LifeTestRequest(samples=SAMPLES))
    assert [one.hypothesis for one in found.comparisons] == [
        "common_shape",
        "same_life",
        "homogeneous",
    ]
    same = compare(campanha, "same_life", samples=SAMPLES)
    assert found.comparisons[1].p_value == same.p_value
    assert found.ratios[0].code == "group_without_fit"
    pooled = summarise(campanha, LifeTestRequest(samples=SAMPLES), by_group=False)
    assert len(pooled.groups) == 1
    assert pooled.comparisons == pooled.ratios == ()


def test_the_ratio_takes_a_common_shape_unless_the_data_deny_it() -> None:
    random = np.random.default_rng(4)
    alike = LifeTest(
        np.concatenate([random.weibull(1.5, 12), 3.0 * random.weibull(1.5, 12)]),
        group=["a"] * 12 + ["b"] * 12,
    )
    (ratio,) = summarise(alike, LifeTestRequest(samples=SAMPLES)).ratios
    assert ratio.common_shape
    assert ratio.ratio == life_ratio(alike, samples=SAMPLES).ratio
    unlike = LifeTest(
        np.concatenate([random.weibull(0.7, 30), random.weibull(8.0, 30)]),
        group=["a"] * 30 + ["b"] * 30,
    )
    (ratio,) = summarise(unlike, LifeTestRequest(samples=SAMPLES)).ratios
    assert not ratio.common_shape


def test_progress_counts_every_step(campanha: LifeTest) -> None:
    steps: list[tuple[int, int]] = []
    summarise(campanha, LifeTestRequest(samples=100), progress=lambda *step: steps.append(step))
    assert steps == [(i, 6) for i in range(1, 7)]


def test_inspected_tests_have_no_ranks_and_no_comparison() -> None:
    test = inspected()
    grouped = LifeTest(
        test.times, test.failed, lower=test.lower, counts=test.counts, group=list("aabbb")
    )
    found = summarise(grouped, LifeTestRequest(samples=SAMPLES))
    assert found.comparisons == ()
    assert {fit.method for fit in found.groups[0].fits} == {"maximum_likelihood", "unbiased"}
    assert found.groups[0].to_mapping()["points"] == []


def test_a_prior_makes_one_failure_enough() -> None:
    test = LifeTest([50.0, 100.0, 100.0], [True, False, False])
    plain = summarise(test, LifeTestRequest(samples=SAMPLES))
    assert plain.groups[0].main.code == "one_failure"
    assert len(plain.groups[0].assumed) == 3
    assert not plain.has_result
    prior = ShapePrior(1.0, 2.5)
    (group,) = summarise(test, LifeTestRequest(samples=SAMPLES, prior=prior)).groups
    assert group.has_result
    assert group.assumed == ()
    life = next(one for one in group.credible if one.quantity == "L10")
    assert 0.0 < life.lower < life.median < life.upper
    none = LifeTest([50.0, 100.0], False)
    (group,) = summarise(none, LifeTestRequest(samples=SAMPLES, prior=prior)).groups
    assert (group.prior_code, group.credible) == ("no_failures", ())


@pytest.mark.parametrize(
    ("keywords", "field"),
    [
        ({"methods": ("guess",)}, "method"),
        ({"reliabilities": ()}, "reliability"),
        ({"shape": 1.5, "bounds": "pivotal"}, "shape"),
    ],
)
def test_wrong_wishes_are_refused(keywords: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        LifeTestRequest(**keywords)
    assert caught.value.field == field


def test_too_many_groups_are_refused() -> None:
    test = LifeTest(np.arange(1.0, 22.0), group=[str(i) for i in range(21)])
    with pytest.raises(InputError, match="groups = 21: must be at most 20"):
        summarise(test)
    assert summarise(test, LifeTestRequest(samples=100), by_group=False).has_result


# --- band ------------------------------------------------------------------------------------


def test_the_band_is_made_of_bounds(campanha: LifeTest) -> None:
    part = campanha.by_group()["I"]
    band = confidence_band(part, samples=SAMPLES)
    assert band.converged
    place = int(np.argmin(abs(band.reliability - 0.9)))
    quantity = Estimand.life(float(band.reliability[place]))
    (bound,) = all_bounds(part, [quantity], samples=SAMPLES)
    assert band.lower[place] == bound.lower
    assert band.upper[place] == bound.upper
    assert np.all(band.lower < band.estimate)
    assert np.all(band.estimate < band.upper)
    np.testing.assert_allclose(band.failed_share[[0, -1]], [0.001, 0.999], rtol=1e-9)


def test_the_band_of_no_failures_is_a_lower_line() -> None:
    test = LifeTest([100.0], [False], counts=[8])
    assert confidence_band(test).code == "no_failures"
    band = confidence_band(test, shape=2.0)
    assert (band.converged, band.sides) == (True, "lower")
    assert np.all(np.isinf(band.upper))
    # 8 t^2 without failure shows η with 90 % where 8 (t/η)^2 = ln 10
    scale = 100.0 * (8.0 / np.log(10.0)) ** 0.5
    np.testing.assert_allclose(band.lower, scale * (-np.log(band.reliability)) ** 0.5, rtol=1e-9)


# --- regions of equal likelihood -------------------------------------------------------------


def test_the_region_falls_from_the_fit(campanha: LifeTest) -> None:
    region = likelihood_region(campanha, "L10", samples=SAMPLES)
    assert region.converged
    assert region.drawn
    assert region.fall.min() < 0.02
    row, column = np.unravel_index(np.argmin(region.fall), region.fall.shape)
    assert region.shape[column] == pytest.approx(region.fit.shape, rel=0.02)
    assert region.life[row] == pytest.approx(region.fit.l10, rel=0.02)
    # the grid holds the greatest region whole
    edge = np.concatenate([region.fall[[0, -1]].ravel(), region.fall[:, [0, -1]].ravel()])
    assert edge.min() > max(region.levels)


def test_few_failures_need_a_greater_fall() -> None:
    chi_square = np.array([1.38629, 4.60517, 5.99146])
    few = likelihood_region(LifeTest([100.0, 160.0, 200.0]), samples=4000)
    assert np.all(np.array(few.levels) > 1.15 * chi_square)
    random = np.random.default_rng(5)
    many = likelihood_region(LifeTest(random.weibull(1.5, 400)), samples=4000)
    np.testing.assert_allclose(many.levels, chi_square, rtol=0.06)


def test_regions_hold_the_truth_as_often_as_they_say() -> None:
    """Where the test ends with failures, whatever the shape and the scale."""
    random, inside = np.random.default_rng(6), 0
    tests = 300
    levels = likelihood_region(LifeTest(np.arange(1.0, 6.0)), samples=20_000).levels
    for _ in range(tests):
        times = 70.0 * random.weibull(2.3, 5)
        fit = maximum_likelihood(LifeTest(times))
        true = np.sum(np.log(2.3 / 70.0) + 1.3 * np.log(times / 70.0) - (times / 70.0) ** 2.3)
        inside += 2.0 * (fit.log_likelihood - true) <= levels[1]
    assert inside / tests == pytest.approx(0.9, abs=0.05)


def test_inspected_tests_have_regions_for_many_failures() -> None:
    region = likelihood_region(inspected(), "L10")
    assert region.converged
    assert not region.drawn
    np.testing.assert_allclose(region.levels, [1.38629, 4.60517, 5.99146], rtol=1e-5)


def test_without_a_fit_there_is_no_region() -> None:
    region = likelihood_region(LifeTest([1.0, 2.0], False))
    assert (region.code, region.fall.size) == ("no_failures", 0)
    for quantity in ("shape", "R100", "x"):
        with pytest.raises(InputError):
            likelihood_region(LifeTest([1.0, 2.0]), quantity)
