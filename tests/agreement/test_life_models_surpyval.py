"""Other distributions beside SurPyval's fits, on drawn lives."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

from rolamento.weibull import LifeTest, life_models, maximum_likelihood


@pytest.fixture(scope="module")
def surpyval() -> Any:
    """Importing it warns of what is not ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import surpyval

    return surpyval


def drawn(seed: int, kind: str) -> LifeTest:
    random = np.random.default_rng(seed)
    size = 80
    if kind == "mixture":
        weak = random.random(size) < 0.3
        times = np.where(weak, 60.0 * random.weibull(2.0, size), 900.0 * random.weibull(4.0, size))
    elif kind == "limited":
        times = np.where(random.random(size) < 0.5, 200.0 * random.weibull(2.0, size), np.inf)
    else:
        times = np.exp(6.0 + 0.7 * random.standard_normal(size))
    end = 1000.0
    return LifeTest(np.minimum(times, end), times <= end)


def fitted(maker: Any, test: LifeTest, **more: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return maker(test.times, c=(~test.failed).astype(int), **more)


@pytest.mark.parametrize("seed", [1, 2])
def test_lognormal(surpyval: Any, seed: int) -> None:
    test = drawn(seed, "lognormal")
    (ours,) = life_models(test, ["lognormal"])
    theirs = fitted(surpyval.LogNormal.fit, test)
    assert [ours.parameters["mu"], ours.parameters["sigma"]] == pytest.approx(
        list(theirs.params), rel=1e-4
    )
    assert ours.log_likelihood == pytest.approx(-theirs.neg_ll(), abs=1e-5)


@pytest.mark.parametrize("seed", [1, 2])
def test_limited_population(surpyval: Any, seed: int) -> None:
    test = drawn(seed, "limited")
    (ours,) = life_models(test, ["limited_population"])
    theirs = fitted(surpyval.Weibull.fit, test, lfp=True)
    assert ours.parameters["share"] == pytest.approx(theirs.lfp_p, rel=1e-3)
    assert ours.log_likelihood == pytest.approx(-theirs.neg_ll(), abs=1e-4)
    assert ours.l10 < np.inf


@pytest.mark.parametrize("seed", [1, pytest.param(3, marks=pytest.mark.sweep)])
def test_mixture(surpyval: Any, seed: int) -> None:
    test = drawn(seed, "mixture")
    (ours,) = life_models(test, ["mixture"])
    theirs = surpyval.MixtureModel(dist=surpyval.Weibull, m=2)
    fitted(theirs.fit, test)
    assert ours.log_likelihood >= -theirs.neg_ll() - 1e-4
    assert ours.log_likelihood == pytest.approx(-theirs.neg_ll(), abs=0.01)
    assert ours.parameters["scale"] < ours.parameters["scale_2"]


def test_competing_modes(surpyval: Any) -> None:
    """Each mode with the others censored: their fit and ours."""
    random = np.random.default_rng(7)
    one, other = 900.0 * random.weibull(0.8, 60), 500.0 * random.weibull(3.5, 60)
    end = random.uniform(100.0, 700.0, 60)
    times = np.minimum(np.minimum(one, other), end)
    mode = np.where(times == end, "", np.where(times == one, "a", "b"))
    test = LifeTest(times, mode != "", mode=mode)
    for name in ("a", "b"):
        theirs = fitted(surpyval.Weibull.fit, test.for_mode(name))
        ours = maximum_likelihood(test.for_mode(name))
        assert (ours.scale, ours.shape) == pytest.approx(tuple(theirs.params), rel=1e-5)
