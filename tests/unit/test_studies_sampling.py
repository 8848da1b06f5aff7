"""Random draws: their distributions, their correlations, and that they do not depend on order."""

from __future__ import annotations

import math
from hashlib import blake2b

import numpy as np
import pytest
from scipy import stats

from rolamento.studies import Correlation, Distribution, Scatter
from rolamento.studies.scatter import (
    Law,
    Sampler,
    difference_in_si,
    factor_of,
    truncated_normal,
    uniform,
)

COUNT = 40_000
INNER, OUTER = "bearing.inner_conformity", "bearing.outer_conformity"
ANGLE = "bearing.contact_angle"
NORMAL = Distribution(distribution="normal", mean="40 deg", standard_deviation="0.5 deg")
FLAT = Distribution(distribution="uniform", least=0.51, greatest=0.53)


def draws(scatter: Scatter, seed: int = 1) -> dict[str, np.ndarray]:
    return Sampler(scatter, seed).draw(0, scatter.count)


def agrees(sample: np.ndarray, law: object) -> bool:
    """Whether a Kolmogorov-Smirnov test at a fixed seed does not speak against it."""
    return bool(stats.kstest(sample, law).pvalue > 0.01)  # type: ignore[attr-defined]


def test_shares_are_uniform_and_never_at_the_ends() -> None:
    shares = uniform(3, "a", 0, COUNT)
    assert agrees(shares, stats.uniform.cdf)
    assert shares.min() > 0.0
    assert shares.max() < 1.0
    # neighbours tell nothing of each other
    assert abs(np.corrcoef(shares[1:], shares[:-1])[0, 1]) < 0.02


def test_normal() -> None:
    drawn = draws(Scatter(count=COUNT, fields={ANGLE: NORMAL}))[ANGLE]
    mean, deviation = math.radians(40.0), math.radians(0.5)
    assert agrees(drawn, stats.norm(mean, deviation).cdf)


def test_uniform() -> None:
    drawn = draws(Scatter(count=COUNT, fields={INNER: FLAT}))[INNER]
    assert agrees(drawn, stats.uniform(0.51, 0.02).cdf)
    assert drawn.min() >= 0.51
    assert drawn.max() <= 0.53


@pytest.mark.parametrize(
    ("least", "greatest"),
    [(39.8, None), (None, 40.2), (39.5, 40.4), (41.0, 42.0), (37.0, 38.0), (44.0, None)],
)
def test_truncated_normal(least: float | None, greatest: float | None) -> None:
    bounds = {
        name: f"{value} deg"
        for name, value in (("least", least), ("greatest", greatest))
        if value is not None
    }
    scatter = Scatter(count=COUNT, fields={ANGLE: NORMAL.replace(**bounds)})
    drawn = np.degrees(draws(scatter)[ANGLE])
    low = (least - 40.0) / 0.5 if least is not None else -np.inf
    high = (greatest - 40.0) / 0.5 if greatest is not None else np.inf
    assert agrees(drawn, stats.truncnorm(low, high, 40.0, 0.5).cdf)
    assert drawn.min() >= (least or 0.0) - 1e-9
    assert drawn.max() <= (greatest or 90.0) + 1e-9


@pytest.mark.parametrize(("low", "high"), [(-1.0, 2.0), (3.0, 4.0), (-25.0, -24.0), (20.0, 29.0)])
def test_quantile_of_the_truncated_normal(low: float, high: float) -> None:
    shares = np.linspace(0.001, 0.999, 97)
    expected = stats.truncnorm(low, high).ppf(shares)
    assert np.allclose(truncated_normal(shares, low, high), expected, rtol=1e-7, atol=1e-9)


def test_a_symmetric_truncation_is_symmetric() -> None:
    law = Law(0.0, 1.0, -2.0, 2.0)
    shares = np.array([0.01, 0.3, 0.5])
    assert np.allclose(law.quantile(shares), -law.quantile(1.0 - shares), atol=1e-12)


@pytest.mark.parametrize("coefficient", [-0.9, -0.3, 0.6, 0.99])
def test_correlation_of_normal_fields(coefficient: float) -> None:
    normal = Distribution(distribution="normal", mean=0.52, standard_deviation=0.001)
    pair = Correlation(fields=(INNER, OUTER), coefficient=coefficient)
    scatter = Scatter(count=COUNT, fields={INNER: normal, OUTER: normal}, correlations=[pair])
    drawn = draws(scatter)
    assert np.corrcoef(drawn[INNER], drawn[OUTER])[0, 1] == pytest.approx(coefficient, abs=0.015)
    for name in (INNER, OUTER):
        assert agrees(drawn[name], stats.norm(0.52, 0.001).cdf)


def test_rank_correlation_whatever_the_distributions() -> None:
    """A Gaussian copula has Spearman's rank correlation (6/π) asin(ρ/2)."""
    pair = Correlation(fields=(ANGLE, INNER), coefficient=0.7)
    scatter = Scatter(count=COUNT, fields={ANGLE: NORMAL, INNER: FLAT}, correlations=[pair])
    drawn = draws(scatter)
    rank = stats.spearmanr(drawn[ANGLE], drawn[INNER]).statistic
    assert rank == pytest.approx(6.0 / math.pi * math.asin(0.35), abs=0.015)
    assert agrees(drawn[INNER], stats.uniform(0.51, 0.02).cdf)


def test_three_fields() -> None:
    wanted = {(INNER, OUTER): 0.5, (INNER, ANGLE): -0.4, (OUTER, ANGLE): 0.2}
    pairs = [Correlation(fields=pair, coefficient=c) for pair, c in wanted.items()]
    normal = Distribution(distribution="normal", mean=0.52, standard_deviation=0.001)
    fields = {INNER: normal, OUTER: normal, ANGLE: NORMAL}
    drawn = draws(Scatter(count=COUNT, fields=fields, correlations=pairs))
    for (a, b), coefficient in wanted.items():
        assert np.corrcoef(drawn[a], drawn[b])[0, 1] == pytest.approx(coefficient, abs=0.02)


def test_full_correlation() -> None:
    pair = Correlation(fields=(INNER, OUTER), coefficient=1.0)
    scatter = Scatter(count=100, fields={INNER: FLAT, OUTER: FLAT}, correlations=[pair])
    drawn = draws(scatter)
    assert np.allclose(drawn[INNER], drawn[OUTER], rtol=0.0, atol=1e-12)


def test_a_sample_depends_on_seed_field_and_number_alone() -> None:
    scatter = Scatter(count=1000, fields={ANGLE: NORMAL, INNER: FLAT})
    whole = draws(scatter)
    for first, last in ((0, 1), (1, 2), (7, 100), (998, 1000)):
        part = Sampler(scatter, 1).draw(first, last)
        for name in whole:
            assert (part[name] == whole[name][first:last]).all()
    alone = draws(Scatter(count=1000, fields={INNER: FLAT}))
    assert (alone[INNER] == whole[INNER]).all()
    assert not (draws(scatter, seed=2)[INNER] == whole[INNER]).any()


def philox(counter: int, key: tuple[int, int]) -> list[int]:
    """Philox4x64-10 as Salmon et al. (2011) define it, in plain Python."""
    mask, (k0, k1) = 2**64 - 1, key
    x0, x1, x2, x3 = ((counter >> 64 * i) & mask for i in range(4))
    for _ in range(10):
        first, second = 0xD2E7470EE14C6C93 * x0, 0xCA5A826395121157 * x2
        x0, x1, x2, x3 = (
            (second >> 64) ^ x1 ^ k0,
            second & mask,
            (first >> 64) ^ x3 ^ k1,
            first & mask,
        )
        k0, k1 = (k0 + 0x9E3779B97F4A7C15) & mask, (k1 + 0xBB67AE8584CAA73B) & mask
    return [x0, x1, x2, x3]


def test_draws_are_those_of_philox() -> None:
    """Results of today can be had again with whatever is there tomorrow."""
    key = blake2b(f"218 {ANGLE}".encode(), digest_size=16).digest()
    words = int.from_bytes(key[:8], "little"), int.from_bytes(key[8:], "little")
    for block in (0, 1, 12345):
        # NumPy counts up before it draws
        expected = [((bits >> 12) + 0.5) / 2**52 for bits in philox(block + 1, words)]
        assert uniform(218, ANGLE, 4 * block, 4 * block + 4).tolist() == expected


def test_factor() -> None:
    matrix = np.array([[1.0, 0.5, 0.2], [0.5, 1.0, -0.3], [0.2, -0.3, 1.0]])
    factor = factor_of(matrix)
    assert np.allclose(factor, np.linalg.cholesky(matrix), atol=1e-14)


def test_a_difference_of_temperatures_is_in_kelvin() -> None:
    assert difference_in_si("2 K", "temperature") == 2.0
    with pytest.raises(ValueError, match="difference"):
        difference_in_si("2 degC", "temperature")
