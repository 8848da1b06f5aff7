"""Laws of life tests: units, order, counts, powers of time, limits; hostile text."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from rolamento.errors import InputError
from rolamento.weibull import (
    METHODS,
    LifeTest,
    ShapePrior,
    all_bounds,
    bounds,
    compare,
    fixed_shape,
    life_ratio,
    maximum_likelihood,
    parse_life_test,
    plotting_positions,
    posterior,
    rank_regression,
    series_life,
    series_reliability,
    three_parameter,
)

times = st.lists(st.floats(1e-3, 1e4), min_size=2, max_size=12)
SETTINGS = settings(max_examples=40)
LOG_OF_RATE = st.floats(-12.0, 12.0)


@st.composite
def life_tests(draw: Any, inspected: bool) -> LifeTest:
    """Tests with a fit, not too steep to be computed."""
    found = draw(times)
    failed = draw(st.lists(st.booleans(), min_size=len(found), max_size=len(found)))
    counts = draw(st.lists(st.integers(1, 3), min_size=len(found), max_size=len(found)))
    lower = [
        t * draw(st.floats(0.0, 0.9)) if inspected and f else np.nan
        for t, f in zip(found, failed, strict=True)
    ]
    test = LifeTest(found, failed, counts=counts, lower=lower)
    fit = maximum_likelihood(test)
    assume(fit.converged and 1e-3 < fit.shape < 50.0)
    return test


RIGHT_CENSORED = life_tests(False)


def changed(test: LifeTest, **fields: Any) -> LifeTest:
    given_ = {
        "times": test.times,
        "failed": test.failed,
        "lower": test.lower,
        "counts": test.counts,
    }
    return LifeTest(**(given_ | fields))


@SETTINGS
@given(st.one_of(RIGHT_CENSORED, life_tests(True)), LOG_OF_RATE)
def test_another_unit_of_time(test: LifeTest, log_rate: float) -> None:
    k = float(np.exp(log_rate))
    fit, other = (
        maximum_likelihood(t)
        for t in (test, changed(test, times=test.times * k, lower=test.lower * k))
    )
    assert other.shape == pytest.approx(fit.shape, rel=1e-6)
    assert other.l10 == pytest.approx(k * fit.l10, rel=1e-5)


@SETTINGS
@given(RIGHT_CENSORED, st.floats(0.2, 5.0))
def test_times_to_a_power(test: LifeTest, power: float) -> None:
    """t^p of a Weibull law is one with β/p."""
    fit, other = (maximum_likelihood(t) for t in (test, changed(test, times=test.times**power)))
    assert other.shape == pytest.approx(fit.shape / power, rel=1e-7)
    assert other.scale == pytest.approx(fit.scale**power, rel=1e-6)


@SETTINGS
@given(RIGHT_CENSORED, LOG_OF_RATE, st.sampled_from(METHODS[:-1]))
def test_bounds_in_another_unit_with_the_same_seed(
    test: LifeTest, log_rate: float, method: Any
) -> None:
    k = float(np.exp(log_rate))
    here, there = (
        all_bounds(t, ["shape", "L10"], method=method, samples=100, seed=7)
        for t in (test, changed(test, times=test.times * k))
    )
    assert there[0].code == here[0].code
    if here[0].code == "converged":
        assert there[0].lower == pytest.approx(here[0].lower, rel=1e-6)
        assert there[0].upper == pytest.approx(here[0].upper, rel=1e-6)
        with np.errstate(over="ignore"):
            assert there[1].lower == pytest.approx(k * here[1].lower, rel=1e-6)
            assert there[1].upper == pytest.approx(k * here[1].upper, rel=1e-6)


@SETTINGS
@given(RIGHT_CENSORED, st.randoms(use_true_random=False))
def test_the_order_of_the_rows_is_nothing(test: LifeTest, random: Any) -> None:
    order = list(range(len(test)))
    random.shuffle(order)
    fit, other = maximum_likelihood(test), maximum_likelihood(test.select(order))
    assert other.shape == pytest.approx(fit.shape, rel=1e-10)
    assert other.scale == pytest.approx(fit.scale, rel=1e-10)
    assert list(plotting_positions(test.select(order)).rank) == pytest.approx(
        list(plotting_positions(test).rank)
    )


@SETTINGS
@given(RIGHT_CENSORED)
def test_a_count_is_as_many_rows(test: LifeTest) -> None:
    rows = np.repeat(np.arange(len(test)), test.counts)
    alone = changed(test.select(rows), counts=1)
    assert alone.size == test.size
    for find in (maximum_likelihood, rank_regression, three_parameter):
        one, other = find(test), find(alone)
        assert one.code == other.code
        if one.converged:
            assert other.shape == pytest.approx(one.shape, rel=1e-5)
            assert other.scale == pytest.approx(one.scale, rel=1e-5)


@SETTINGS
@given(RIGHT_CENSORED, st.floats(1.01, 3.0))
def test_longer_suspensions_are_longer_lives(test: LifeTest, factor: float) -> None:
    assume(test.suspensions > 0)
    longer = changed(test, times=np.where(test.failed, test.times, factor * test.times))
    at = 1.5
    assert fixed_shape(longer, at).scale > fixed_shape(test, at).scale
    if longer.scheme == test.scheme:  # no longer ended by a failure: on the safe side instead
        assert bounds(longer, "L10", shape=at).lower >= bounds(test, "L10", shape=at).lower


@SETTINGS
@given(RIGHT_CENSORED, st.floats(0.5, 0.9), st.floats(0.91, 0.99), st.sampled_from(METHODS[:-1]))
def test_more_confidence_is_wider(test: LifeTest, less: float, more: float, method: Any) -> None:
    wide, narrow = (
        bounds(test, "L10", method=method, samples=200, confidence=c) for c in (more, less)
    )
    assert wide.code == narrow.code
    if wide.code == "converged":
        assert wide.lower <= narrow.lower * (1.0 + 1e-9)
        assert wide.upper >= narrow.upper * (1.0 - 1e-9)


@SETTINGS
@given(RIGHT_CENSORED, st.floats(1e-6, 1.0 - 1e-6))
def test_life_and_reliability_go_there_and_back(test: LifeTest, reliability: float) -> None:
    fit = maximum_likelihood(test)
    assert float(fit.reliability_at(fit.life_at(reliability))) == pytest.approx(
        reliability, abs=1e-9
    )


@SETTINGS
@given(RIGHT_CENSORED)
def test_the_likelihood_of_three_parameters_is_not_less(test: LifeTest) -> None:
    fit, plain = three_parameter(test), maximum_likelihood(test)
    if fit.converged:
        assert 0.0 <= fit.location < test.times[test.failed].min()
        assert fit.log_likelihood >= plain.log_likelihood - 1e-6 * abs(plain.log_likelihood) - 1e-6


@SETTINGS
@given(RIGHT_CENSORED, st.floats(0.05, 0.95), st.floats(0.05, 0.95))
def test_posterior_quantiles_rise(test: LifeTest, one: float, other: float) -> None:
    low, high = sorted((one, other))
    found = posterior(test, ShapePrior(0.8, 3.0))
    for name in ("shape", "L10"):
        assert found.quantile(name, low) <= found.quantile(name, high)
        middle = found.quantile(name, one)
        assert found.probability_below(name, middle) == pytest.approx(one, abs=5e-3)


@SETTINGS
@given(RIGHT_CENSORED, RIGHT_CENSORED, LOG_OF_RATE)
def test_comparisons_in_another_unit(first: LifeTest, second: LifeTest, log_rate: float) -> None:
    k = float(np.exp(log_rate))
    scaled = [changed(t, times=t.times * k) for t in (first, second)]
    here = compare({"a": first, "b": second}, samples=100, seed=2)
    there = compare(dict(zip("ab", scaled, strict=True)), samples=100, seed=2)
    assert there.code == here.code
    if here.converged:
        assert there.statistic == pytest.approx(here.statistic, rel=1e-5, abs=1e-6)
    # only one of the groups in another unit: the ratio follows
    one = life_ratio({"a": first, "b": second}, samples=100, seed=2)
    other = life_ratio({"a": scaled[0], "b": second}, samples=100, seed=2)
    if one.converged and other.converged:
        assert other.ratio == pytest.approx(k * one.ratio, rel=1e-5)


laws = st.lists(st.tuples(st.floats(0.5, 6.0), st.floats(1.0, 1e5)), min_size=1, max_size=6)


@given(laws, st.floats(1e-6, 1.0 - 1e-6))
def test_a_series_is_shorter_than_its_shortest(
    law: list[tuple[float, float]], reliability: float
) -> None:
    shapes, scales = zip(*law, strict=True)
    life = float(series_life(reliability, shapes, scales))
    alone = np.array(scales) * (-np.log(reliability)) ** (1.0 / np.array(shapes))
    assert life <= alone.min() * (1.0 + 1e-9)
    assert float(series_reliability(life, shapes, scales)) == pytest.approx(reliability, abs=1e-9)


WORDS = (
    "time status lower count group rig size note hours Mrev failed suspended 1 2.5 1,5 -3 nan 1e9"
    " f s A \" '' é # ; 0 1e-40 999999999999"
)
cells = st.sampled_from(WORDS.split())


@settings(max_examples=300)
@given(
    st.one_of(
        st.text(max_size=200),
        st.builds(
            "\n".join,
            st.lists(st.builds(";".join, st.lists(cells, max_size=4)), max_size=6),
        ),
        st.builds(
            lambda head, rows: head + "\n" + "\n".join(rows),
            st.sampled_from(["time;status", "time;count;rig", "hours;size", "from;to", "time"]),
            st.lists(st.builds(";".join, st.lists(cells, max_size=3)), max_size=6),
        ),
    )
)
@example("time\n\u2028\n1")
@example("time;time\u0301\n1;2")
def test_any_text_is_a_test_or_refused_in_words(text: str) -> None:
    try:
        test = parse_life_test(text, "any")
    except InputError as error:
        assert "\n" not in str(error)
        assert len(str(error)) < 800
    else:
        assert test.size >= 1
        assert maximum_likelihood(test).code in (
            "converged", "no_failures", "one_failure", "no_spread", "no_maximum",
        )  # fmt: skip
