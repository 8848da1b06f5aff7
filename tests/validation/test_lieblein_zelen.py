"""Lieblein and Zelen (1956): 23 deep-groove ball bearings, all failed, in the form of the reprints.

Maximum likelihood: β 2.10, η 81.88 millions of revolutions (Lawless 2003, section 5.2). The bias of
the shape: Thoman, Bain and Antle (1969), table of unbiasing factors.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from rolamento.weibull import (
    maximum_likelihood,
    published_life_test,
    three_parameter,
    unbiased,
)

TEST = published_life_test("lieblein_zelen_1956")


def test_two_parameters() -> None:
    fit = maximum_likelihood(TEST)
    assert TEST.unit == "Mrev"
    assert (TEST.size, TEST.failures, TEST.scheme) == (23, 23, "complete")
    assert fit.shape == pytest.approx(2.10, abs=0.005)
    assert fit.scale == pytest.approx(81.88, abs=0.005)
    assert fit.log_likelihood == pytest.approx(-113.691, abs=0.001)
    # the score equations, by plain sums
    t, beta = TEST.times, fit.shape
    assert np.sum(t**beta * np.log(t)) / np.sum(t**beta) - 1.0 / beta == pytest.approx(
        np.mean(np.log(t)), rel=1e-12
    )
    assert fit.scale == pytest.approx(np.mean(t**beta) ** (1.0 / beta), rel=1e-12)


def test_the_scale_is_not_the_mean_life() -> None:
    fit = maximum_likelihood(TEST)
    assert fit.mean == pytest.approx(TEST.times.mean(), rel=0.005)
    assert fit.scale > 1.12 * fit.mean


def test_three_parameters_stand_on_a_hilltop() -> None:
    """The likelihood by SciPy's density, and its slopes there."""
    fit = three_parameter(TEST)
    assert 0.0 < fit.location < 17.88

    def value(shape: float, location: float, scale: float) -> float:
        return float(stats.weibull_min.logpdf(TEST.times, shape, location, scale).sum())

    at = np.array([fit.shape, fit.location, fit.scale])
    assert value(*at) == pytest.approx(fit.log_likelihood, rel=1e-12)
    for step in 1e-3 * np.diag(at):
        up, down = value(*(at + step)), value(*(at - step))
        assert max(up, down) < fit.log_likelihood
        assert abs(up - down) < 0.02 * (2.0 * fit.log_likelihood - up - down)
    # twice the gain is far below what a third parameter has to bring
    assert 2.0 * (fit.log_likelihood - maximum_likelihood(TEST).log_likelihood) < 2.71


def test_bias_of_the_shape() -> None:
    """Thoman, Bain and Antle: 0.938 for 22, 0.943 for 24."""
    factor = unbiased(TEST, "mean", samples=40_000).shape / maximum_likelihood(TEST).shape
    assert factor == pytest.approx(0.9405, abs=0.004)
