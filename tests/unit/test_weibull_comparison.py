"""Comparing groups, ratios of lives, a calculated life, bearings in series."""

from __future__ import annotations

import json

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.weibull import (
    LifeTest,
    against_calculated_life,
    bounds,
    compare,
    fixed_shape,
    life_ratio,
    maximum_likelihood,
    series_life,
    series_reliability,
    system_rating_life,
)
from rolamento.words import Note

A = LifeTest([3.0, 5.0, 9.0, 11.0, 4.0])
B = LifeTest([7.0, 15.0, 12.0, 30.0, 30.0], [1, 1, 1, 1, 0])
NOTHING = LifeTest([30.0] * 5, False)


def test_statistics_are_differences_of_likelihoods() -> None:
    groups = {"A": A, "B": B}
    own = sum(maximum_likelihood(t).log_likelihood for t in groups.values())
    pooled = maximum_likelihood(
        LifeTest(np.append(A.times, B.times), np.append(A.failed, B.failed))
    ).log_likelihood
    common = compare(groups, "common_shape", samples=200)
    shared = sum(fixed_shape(t, common.shape).log_likelihood for t in groups.values())
    assert common.statistic == pytest.approx(2.0 * (own - shared), rel=1e-9)
    assert common.scales == pytest.approx([fixed_shape(t, common.shape).scale for t in (A, B)])
    same = compare(groups, "same_life", samples=200)
    assert same.statistic == pytest.approx(2.0 * (shared - pooled), rel=1e-9)
    both = compare(groups, "homogeneous", samples=200)
    assert both.statistic == pytest.approx(2.0 * (own - pooled), rel=1e-9)
    assert [c.freedom for c in (common, same, both)] == [1, 1, 2]
    # the common shape is the best of the shared ones
    for factor in (0.99, 1.01):
        near = sum(fixed_shape(t, factor * common.shape).log_likelihood for t in (A, B))
        assert near < shared


def test_groups_of_one_test() -> None:
    test = LifeTest(
        np.append(A.times, B.times), np.append(A.failed, B.failed), group=["A"] * 5 + ["B"] * 5
    )
    whole = compare(test, samples=300)
    parts = compare({"A": A, "B": B}, samples=300)
    assert (whole.groups, whole.statistic) == (("A", "B"), pytest.approx(parts.statistic))
    assert whole.p_value == parts.p_value
    assert json.loads(json.dumps(whole.to_mapping(), allow_nan=False))["groups"] == ["A", "B"]


@pytest.mark.parametrize("hypothesis", ["common_shape", "same_life", "homogeneous"])
@pytest.mark.sweep
def test_p_values_are_even_if_the_hypothesis_is_true(hypothesis: str) -> None:
    random = np.random.default_rng(3)
    values, chi_square = [], []
    for i in range(120):
        groups = {name: LifeTest(random.weibull(1.4, 4)) for name in "ab"}
        found = compare(groups, hypothesis, samples=200, seed=i)  # type: ignore[arg-type]
        values.append(found.p_value)
        chi_square.append(found.p_value_chi_square)
    assert np.mean(np.array(values) < 0.2) == pytest.approx(0.2, abs=0.11)
    assert np.mean(values) == pytest.approx(0.5, abs=0.08)
    # with eight failures chi-square rejects too often
    assert np.mean(np.array(chi_square) < 0.1) > np.mean(np.array(values) < 0.1)


def test_groups_that_differ() -> None:
    random = np.random.default_rng(4)
    short, long = (LifeTest(scale * random.weibull(2.0, 12)) for scale in (1.0, 8.0))
    steep = LifeTest(random.weibull(12.0, 12))
    assert compare({"a": short, "b": long}, "same_life").rejected(0.99)
    assert not compare({"a": short, "b": long}, "common_shape").rejected()
    assert compare({"a": short, "b": steep}, "common_shape").rejected(0.99)
    assert compare({"a": short, "b": steep}, "homogeneous").rejected(0.99)


def test_a_group_without_failures() -> None:
    found = compare({"A": A, "N": NOTHING}, "same_life", samples=1000)
    assert found.converged
    assert found.rejected(0.95)  # 11 the longest life there, none of five failed by 30 here
    assert Note("censoring_modelled") in found.notes
    shapes = compare({"A": A, "B": B, "N": NOTHING}, "common_shape", samples=200)
    assert shapes.groups == ("A", "B")
    assert Note("group_without_failures") in shapes.notes
    alone = compare({"A": A, "N": NOTHING}, "common_shape")
    assert alone.code == "group_without_fit"
    assert np.isnan(alone.p_value)
    nobody = compare({"M": NOTHING, "N": NOTHING}, "same_life")
    assert nobody.code == "no_failures"
    assert nobody.advice
    json.dumps(nobody.to_mapping(), allow_nan=False)


def test_too_large_to_draw_still_has_chi_square() -> None:
    groups = {k: LifeTest([3.0, 5.0, 8.0], counts=10_000) for k in "ab"}
    found = compare(groups, "common_shape")
    assert found.code == "too_large"
    assert np.isnan(found.p_value)
    assert found.p_value_chi_square == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("match", "groups"),
    [
        ("groups.*2 to 50", {"A": A}),
        ("groups.*2 to 50", {str(i): A for i in range(51)}),
        ("groups.*inspections", {"A": A, "B": LifeTest([2.0, 3.0], lower=[1.0, 2.0])}),
        (
            'groups = "Mrev, h": must have the same unit',
            {"A": A, "B": LifeTest([2.0, 3.0], unit="Mrev")},
        ),
    ],
)
def test_what_cannot_be_compared(match: str, groups: dict[str, LifeTest]) -> None:
    with pytest.raises(InputError, match=match):
        compare(groups)


def test_ratio_of_lives() -> None:
    found = life_ratio({"B": B, "A": A}, samples=4000)
    common = compare({"B": B, "A": A}, "common_shape", samples=100)
    assert found.ratio == pytest.approx(common.scales[0] / common.scales[1])
    assert found.shape == pytest.approx(common.shape)
    assert found.lower < found.ratio < found.upper
    # at one shape the ratio is the same for every reliability
    assert life_ratio({"B": B, "A": A}, 0.5, samples=4000).ratio == pytest.approx(found.ratio)
    back = life_ratio({"A": A, "B": B}, samples=4000)
    assert back.ratio == pytest.approx(1.0 / found.ratio)
    assert back.upper == pytest.approx(1.0 / found.lower, rel=0.1)
    assert (found.p_value < 0.1) == (found.lower > 1.0 or found.upper < 1.0)
    json.dumps(found.to_mapping(), allow_nan=False)


def test_ratio_without_a_common_shape() -> None:
    found = life_ratio({"B": B, "A": A}, common_shape=False, samples=2000)
    expected = maximum_likelihood(B).l10 / maximum_likelihood(A).l10
    assert found.ratio == pytest.approx(expected)
    assert Note("bounds_approximate") in found.notes
    common = life_ratio({"B": B, "A": A}, samples=2000)
    # a shape known twice as well
    assert found.upper / found.lower > common.upper / common.lower


@pytest.mark.sweep
def test_ratio_holds_as_often_as_it_says() -> None:
    random = np.random.default_rng(5)
    hits = {True: 0, False: 0}
    for i in range(150):
        groups = {
            "a": LifeTest(3.0 * random.weibull(1.5, 5)),
            "b": LifeTest(random.weibull(1.5, 5)),
        }
        for common in hits:
            found = life_ratio(groups, common_shape=common, samples=400, seed=i)
            hits[common] += found.lower <= 3.0 <= found.upper
    assert hits[True] / 150 == pytest.approx(0.9, abs=0.075)
    assert hits[False] / 150 == pytest.approx(0.92, abs=0.075)  # tends to hold more often


def test_ratio_without_failures() -> None:
    found = life_ratio({"A": A, "N": NOTHING})
    assert found.code == "group_without_fit"
    assert np.isnan(found.ratio)
    assert life_ratio({"M": NOTHING, "N": NOTHING}).code == "no_failures"
    assert life_ratio({"A": A, "N": NOTHING}, common_shape=False).code == "no_failures"
    with pytest.raises(InputError, match="must be two"):
        life_ratio({"A": A, "B": B, "C": A})


def test_against_a_calculated_life() -> None:
    test = LifeTest([54.0, 187, 216, 240, 244, 335, 361, 373, 375, 386])
    life = bounds(test, "L10")
    inside = against_calculated_life(test, life.estimate)
    assert inside.verdict == "data do not contradict calculation"
    assert inside.bearings_live == ""
    assert inside.ratio == pytest.approx(1.0)
    assert (inside.lower, inside.upper) == pytest.approx(
        (life.lower / life.estimate, life.upper / life.estimate)
    )
    assert inside.p_value > 0.5
    longer = against_calculated_life(test, 0.9 * life.lower)
    assert longer.verdict == "data contradict calculation"
    assert longer.bearings_live == "longer"
    assert longer.p_value < 0.1
    shorter = against_calculated_life(test, 1.1 * life.upper)
    assert shorter.bearings_live == "shorter"
    json.dumps(longer.to_mapping(), allow_nan=False)


@pytest.mark.parametrize("method", ["pivotal", "calibrated_likelihood_ratio", "likelihood_ratio"])
def test_p_value_turns_where_the_interval_ends(method: str) -> None:
    test = LifeTest([54.0, 187, 216, 240, 244, 335, 400.0], [1, 1, 1, 1, 1, 1, 0], counts=2)
    life = bounds(test, "L10", method=method, samples=5000)  # type: ignore[arg-type]
    for end in (life.lower, life.upper):
        found = against_calculated_life(test, end, method=method, samples=5000)  # type: ignore[arg-type]
        assert found.p_value == pytest.approx(0.1, rel=2e-2 if "like" in method else 1e-2)


def test_a_calculated_life_and_no_failures() -> None:
    test = LifeTest([160.0] * 10, False)
    assert against_calculated_life(test, 50.0).verdict == "no verdict"
    known = against_calculated_life(test, 50.0, shape=1.5)
    assert known.verdict == "data contradict calculation"
    assert known.bearings_live == "longer"
    # ten survivors if the life is 50
    assert known.p_value == pytest.approx(2.0 * 0.9 ** (10.0 * 3.2**1.5), rel=1e-9)
    assert against_calculated_life(test, 500.0, shape=1.5).bearings_live == ""
    failed = LifeTest([3.0, 5.0, 9.0])
    life = bounds(failed, "L10", shape=2.0)
    for end in (life.lower, life.upper):
        found = against_calculated_life(failed, end, shape=2.0)
        assert found.p_value == pytest.approx(0.1, rel=1e-9)


def test_wrong_calculated_lives() -> None:
    for life in (0.0, -1.0, np.inf, np.nan, "long"):
        with pytest.raises(InputError, match="calculated"):
            against_calculated_life(A, life)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"method.*for a verdict"):
        against_calculated_life(A, 3.0, method="fisher")


def test_lives_in_series() -> None:
    assert system_rating_life([1000.0, 1000.0]) == pytest.approx(1000.0 * 2.0 ** (-0.9))
    assert system_rating_life([1000.0, 1000.0], "roller") == pytest.approx(
        1000.0 * 2.0 ** (-8.0 / 9.0)
    )
    assert system_rating_life([500.0, np.inf]) == pytest.approx(500.0)
    assert system_rating_life([np.inf, np.inf]) == np.inf
    lives = np.array([[1000.0, 2000.0, 3000.0], [10.0, 10.0, 10.0]])
    expected = np.sum(lives**-1.5, axis=1) ** (-1.0 / 1.5)
    assert system_rating_life(lives, exponent=1.5) == pytest.approx(expected)
    for wrong in ([], [0.0], [-1.0], [np.nan], "long"):
        with pytest.raises(InputError, match="lives"):
            system_rating_life(wrong)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="kind"):
        system_rating_life([1.0], "plain")  # type: ignore[arg-type]


def test_series_of_equal_shapes_is_the_formula() -> None:
    shape = 10.0 / 9.0
    lives = np.array([1000.0, 2500.0, 700.0])
    scales = lives / (-np.log(0.9)) ** (1.0 / shape)
    assert series_life(0.9, shape, scales) == pytest.approx(system_rating_life(lives), rel=1e-12)


def test_series_of_any_shapes() -> None:
    shapes, scales, locations = [1.1, 3.0, 0.7], [1000.0, 200.0, 5000.0], [0.0, 50.0, 0.0]
    r = np.array([0.999, 0.9, 0.5, 1e-3])
    t = series_life(r, shapes, scales, locations)
    assert np.all(np.diff(t) > 0.0)
    assert series_reliability(t, shapes, scales, locations) == pytest.approx(r, rel=1e-10)
    one = np.prod(
        [series_reliability(t, b, n, g) for b, n, g in zip(shapes, scales, locations, strict=True)],
        axis=0,
    )
    assert one == pytest.approx(r, rel=1e-10)
    alone = series_life(0.9, 2.0, 10.0, 5.0)
    assert alone == pytest.approx(5.0 + 10.0 * np.sqrt(-np.log(0.9)))


@pytest.mark.parametrize(
    ("match", "given"),
    [
        ("reliability", (90.0, 2.0, 10.0, 0.0)),
        ("shapes", (0.9, 0.0, 10.0, 0.0)),
        ("scales", (0.9, 2.0, np.inf, 0.0)),
        ("locations", (0.9, 2.0, 10.0, -1.0)),
        ("locations", (0.9, [1.0, 2.0], [1.0, 2.0, 3.0], 0.0)),
        ("locations", (0.9, 2.0, 10.0, "none")),
    ],
)
def test_wrong_series(match: str, given: tuple[float, ...]) -> None:
    with pytest.raises(InputError, match=match):
        series_life(*given)
