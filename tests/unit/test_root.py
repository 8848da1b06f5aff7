"""The one root finder: awkward functions, bad slopes, ends, and how long it may take."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.numerics.root import MOST_EVALUATIONS, ValueAndSlope, increasing_root

Array = np.ndarray


def counted(function: ValueAndSlope) -> tuple[ValueAndSlope, Callable[[], int]]:
    calls = []

    def counting(x: Array) -> tuple[Array, Array]:
        calls.append(1)
        return function(x)

    return counting, lambda: len(calls)


def signed_root(x: Array) -> tuple[Array, Array]:
    """Newton's steps lead from 3 + u to 3 - u and back."""
    size = np.abs(x - 3.0)
    return np.sign(x - 3.0) * np.sqrt(size), 0.5 / np.sqrt(size)


def test_two_places_to_which_newton_leads_in_turn() -> None:
    """Inside a bracket that they are the ends of, so that no step ever leaves it."""
    here = np.array([3.75])
    for there in (2.25, 3.75, 2.25, 3.75):
        value, slope = signed_root(here)
        here = here - value / slope
        assert here[0] == there
    start = np.array([3.75, 2.25, 3.1, 1e4, 3.0])
    function, evaluations = counted(signed_root)
    x, found = increasing_root(function, start, np.full(5, -10.0), np.full(5, 1e5))
    assert found.all()
    np.testing.assert_allclose(x, 3.0, rtol=1e-14)
    assert evaluations() < 70


def test_a_curve_that_newton_runs_past() -> None:
    def curve(x: Array) -> tuple[Array, Array]:
        return np.arctan(x - 3.0), 1.0 / (1.0 + (x - 3.0) ** 2)

    start = np.array([0.5, 4.39174520, 1.60825480, 500.0])
    x, found = increasing_root(curve, start, np.full(4, -10.0), np.full(4, np.inf))
    assert found.all()
    np.testing.assert_allclose(x, 3.0, rtol=1e-14)


def test_newton_is_as_fast_as_it_is_by_itself() -> None:
    function, evaluations = counted(lambda x: (x * x - 2.0, 2.0 * x))
    x, _ = increasing_root(function, np.array([1.0, 2.0]), np.zeros(2), np.full(2, np.inf))
    np.testing.assert_allclose(x, np.sqrt(2.0), rtol=1e-15)
    assert evaluations() <= 6


@pytest.mark.parametrize("slope", [0.0, -1.0, np.nan, np.inf, 1e-200])
def test_roots_of_any_size_without_a_useful_slope(slope: float) -> None:
    target = np.array([1e-300, 1e-6, 1.0, 1e12, 1e300, 0.0])

    def line(x: Array) -> tuple[Array, Array]:
        return x - target, np.full_like(x, slope)

    function, evaluations = counted(line)
    x, found = increasing_root(function, np.full(6, 1.0), np.zeros(6), np.full(6, np.inf))
    assert found.all()
    np.testing.assert_allclose(x, target, rtol=2e-14)
    assert evaluations() <= MOST_EVALUATIONS
    from_the_end, found = increasing_root(line, np.zeros(6), np.zeros(6), np.full(6, np.inf))
    assert found.all()
    np.testing.assert_allclose(from_the_end, target, rtol=2e-14)


def test_a_single_root_by_halving_alone() -> None:
    for low, high, target in ((0.0, np.inf, 1e300), (-1e300, 1e300, -1e-300), (-7.0, 0.0, -2.0)):
        x, found = increasing_root(
            lambda x, target=target: (np.sign(x - target), np.zeros_like(x)),
            np.array(high if np.isfinite(high) else low),
            np.array(low),
            np.array(high),
        )
        assert found
        assert x == pytest.approx(target, rel=2e-14)


def test_one_sign_from_end_to_end_is_no_root() -> None:
    """Nor is the end at which the search arrives."""

    def above(x: Array) -> tuple[Array, Array]:
        return x, np.ones_like(x)

    def below(x: Array) -> tuple[Array, Array]:
        return np.full_like(x, -1.0), np.zeros_like(x)

    start, low = np.array([1.5, 1.0, 2.0]), np.ones(3)
    for function in (above, below):
        for high in (np.full(3, 2.0), np.full(3, np.inf)):
            counting, evaluations = counted(function)
            x, found = increasing_root(counting, start, low, high)
            assert not found.any()
            assert np.isnan(x).all()
            assert evaluations() <= MOST_EVALUATIONS


def test_a_root_at_an_end_is_found() -> None:
    def cube(x: Array) -> tuple[Array, Array]:
        return (x - 1.0) ** 3, 3.0 * (x - 1.0) ** 2

    low, high = np.array([1.0, 0.0, 1.0, 0.0]), np.array([2.0, 1.0, np.inf, 1.0])
    x, found = increasing_root(cube, np.array([1.75, 0.25, 1.0, 1.0]), low, high)
    assert found.all()
    np.testing.assert_allclose(x, 1.0, rtol=3e-14)


def test_an_end_just_beside_the_root_by_rounding() -> None:
    """A bracket without width whose function is not quite zero there."""
    at = np.array([0.1 + 0.2])
    x, found = increasing_root(lambda x: (x - 0.3, np.ones_like(x)), at, at, at)
    assert found.all()
    assert x == at


def test_elements_do_not_disturb_each_other() -> None:
    """NaN, no root, an overflow and a root side by side; the same alone."""
    target = np.array([np.nan, -1.0, 2.0, 1e3, 5.0])

    def exponential(x: Array) -> tuple[Array, Array]:
        value = np.exp(x)
        return value - np.exp(np.minimum(target, 700.0)), value

    start, low, high = np.full(5, 1.0), np.zeros(5), np.full(5, np.inf)
    start[3] = 1e3  # overflows there: no warning, and back again
    x, found = increasing_root(exponential, start, low, high)
    np.testing.assert_array_equal(found, [False, False, True, True, True])
    assert np.isnan(x[:2]).all()
    np.testing.assert_allclose(x[2:], [2.0, 700.0, 5.0], rtol=1e-14)
    target = target[2]
    alone, _ = increasing_root(exponential, start[2], low[2], high[2])
    assert alone.shape == ()
    assert alone == x[2]


def test_a_value_without_number_is_no_root() -> None:
    function, evaluations = counted(lambda x: (x * np.nan, x))
    x, found = increasing_root(function, np.ones(2), np.zeros(2), np.full(2, np.inf))
    assert not found.any()
    assert np.isnan(x).all()
    assert evaluations() == 1


def test_the_tolerance_is_that_of_the_answer() -> None:
    for tolerance in (1e-3, 1e-8, 1e-14):
        x, found = increasing_root(
            lambda x: (x**3 - 7.0, np.zeros_like(x)),
            np.array([1.0]),
            np.array([0.0]),
            np.array([64.0]),
            tolerance=tolerance,
        )
        assert found.all()
        assert x == pytest.approx(np.cbrt(7.0), rel=tolerance)


@given(
    root=st.floats(-1e6, 1e6),
    power=st.sampled_from([1.0 / 3.0, 0.5, 0.7, 1.0, 1.5, 3.0]),
    lean=st.floats(1e-3, 1e3),
    pace=st.sampled_from([0.0, 0.02, 0.5, 1.0, 2.0, 50.0, np.nan, np.inf]),
    place=st.floats(0.0, 1.0),
    widths=st.tuples(st.floats(0.0, 1e7), st.floats(0.0, 1e7)),
)
def test_whatever_has_a_root_between_its_ends_is_solved(
    root: float, power: float, lean: float, pace: float, place: float, widths: tuple[float, float]
) -> None:
    """Powers of the distance, steeper on one side, with slopes that are wrong by a factor."""
    low, high = np.array([root - widths[0]]), np.array([root + widths[1]])
    start = np.clip(low + place * (high - low), low, high)

    def value_of(x: Array) -> Array:
        distance = x - root
        return np.where(distance > 0.0, lean, 1.0) * np.sign(distance) * np.abs(distance) ** power

    def function(x: Array) -> tuple[Array, Array]:
        value = value_of(x)
        return value, pace * power * np.abs(value) / np.abs(x - root)

    counting, evaluations = counted(function)
    x, found = increasing_root(counting, start, low, high)
    assert found.all()
    assert evaluations() <= MOST_EVALUATIONS
    # the step is a part of the distance when the slope is too large, and so is what it leaves
    assert value_of(x) == 0.0 or abs(x[0] - root) <= 1e-11 * abs(root) + 1e-300
