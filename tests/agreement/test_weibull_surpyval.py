"""Fits and Fisher bounds beside SurPyval, another package for survival data, on random tests."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

from rolamento.weibull import (
    LifeTest,
    bounds,
    maximum_likelihood,
    rank_regression,
)


@pytest.fixture(scope="module")
def weibull() -> Any:
    """SurPyval's distribution; importing it warns of what is not ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import surpyval

    return surpyval.Weibull


def fitted(weibull: Any, **data: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return weibull.fit(**data)


def random_test(seed: int, censored: bool) -> LifeTest:
    random = np.random.default_rng(seed)
    size, shape = int(random.integers(5, 40)), random.uniform(0.6, 4.0)
    times = np.round(1000.0 * random.weibull(shape, size), 2) + 0.01
    ends = 1000.0 * random.uniform(0.4, 2.0, size) if censored else np.full(size, np.inf)
    counts = random.integers(1, 4, size)
    return LifeTest(np.minimum(times, ends), times <= ends, counts=counts)


@pytest.mark.parametrize("censored", [False, True])
@pytest.mark.parametrize("seed", range(8))
def test_maximum_likelihood(weibull: Any, seed: int, censored: bool) -> None:
    test = random_test(seed, censored)
    theirs = fitted(weibull, x=test.times, c=(~test.failed).astype(int), n=test.counts)
    ours = maximum_likelihood(test)
    assert (ours.scale, ours.shape) == pytest.approx(tuple(theirs.params), rel=1e-5)
    assert ours.log_likelihood == pytest.approx(-theirs.neg_ll(), rel=1e-9)
    assert ours.log_likelihood >= -theirs.neg_ll() - 1e-9 * abs(ours.log_likelihood)


@pytest.mark.parametrize("seed", range(6))
def test_inspections(weibull: Any, seed: int) -> None:
    random = np.random.default_rng(seed)
    times = 1000.0 * random.weibull(1.6, 30)
    grid = np.array([0.0, 200, 500, 800, 1300])
    cell = np.searchsorted(grid, times)
    failed = cell < len(grid)
    upper = grid[np.minimum(cell, len(grid) - 1)]
    lower = np.where(failed, grid[cell - 1], np.nan)
    ours = maximum_likelihood(LifeTest(upper, failed, lower=lower))
    theirs = fitted(
        weibull,
        xl=np.where(failed, lower, upper),
        xr=np.where(failed, upper, np.inf),
    )
    assert (ours.scale, ours.shape) == pytest.approx(tuple(theirs.params), rel=1e-4)


@pytest.mark.parametrize("regression", ["x_on_y", "y_on_x"])
@pytest.mark.parametrize("seed", range(6))
def test_rank_regression(weibull: Any, seed: int, regression: str) -> None:
    random = np.random.default_rng(seed)
    times = np.sort(1000.0 * random.weibull(1.6, 12))
    failed = random.random(12) < 0.7
    failed[:2] = True
    ours = rank_regression(LifeTest(times, failed), regression, "benard")  # type: ignore[arg-type]
    theirs = fitted(
        weibull,
        x=times,
        c=(~failed).astype(int),
        how="MPP",
        heuristic="Benard",
        rr=regression[0],
    )
    assert (ours.scale, ours.shape) == pytest.approx(tuple(theirs.params), rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_fisher_bounds(weibull: Any, seed: int) -> None:
    test = random_test(seed, True)
    theirs = fitted(weibull, x=test.times, c=(~test.failed).astype(int), n=test.counts)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        reliability = np.ravel(theirs.cb(np.array([300.0]), on="R", alpha_ci=0.1))
        shape = np.ravel(theirs.param_cb("beta", alpha_ci=0.1))
    for name, limits in (("R300", reliability), ("shape", shape)):
        found = bounds(test, name, method="fisher")
        assert [found.lower, found.upper] == pytest.approx(sorted(limits), rel=1e-4)
