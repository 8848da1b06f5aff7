"""Laws of competing failure modes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.weibull import LifeTest, fixed_shape, maximum_likelihood, series_reliability

lives = st.lists(
    st.tuples(st.floats(1.0, 1e4), st.sampled_from(["", "a", "b", "c"])), min_size=4, max_size=30
)


def life_test(rows: list[tuple[float, str]]) -> LifeTest:
    modes = np.array([mode for _, mode in rows])
    return LifeTest([time for time, _ in rows], modes != "", mode=modes)


@given(lives, st.floats(0.5, 5.0))
def test_at_one_shape_the_modes_together_are_all_failures(
    rows: list[tuple[float, str]], shape: float
) -> None:
    """η_j^β = T/r_j with the same T for all modes, so that Σ η_j^(-β) = η^(-β)."""
    test = life_test(rows)
    if not test.modes:
        return
    whole = fixed_shape(test, shape)
    parts = [fixed_shape(test.for_mode(name), shape) for name in test.modes]
    times = np.array([0.5, 1.0, 2.0]) * whole.scale
    together = series_reliability(times, shape, [fit.scale for fit in parts])
    assert together.tolist() == pytest.approx(whole.reliability_at(times).tolist(), rel=1e-9)
    assert sum(fit.failures for fit in parts) == test.failures


@given(lives, st.randoms(use_true_random=False))
def test_neither_order_nor_names_matter(rows: list[tuple[float, str]], random: object) -> None:
    test = life_test(rows)
    order = list(range(len(rows)))
    random.shuffle(order)  # type: ignore[attr-defined]
    names = {"": "", "a": "x", "b": "y", "c": "z"}
    other = life_test([(rows[i][0], names[rows[i][1]]) for i in order])
    for name in test.modes:
        one = maximum_likelihood(test.for_mode(name))
        again = maximum_likelihood(other.for_mode(names[name]))
        assert one.code == again.code
        assert (one.shape, one.scale) == pytest.approx(
            (again.shape, again.scale), rel=1e-6, nan_ok=True
        )
