"""Random draws: their distributions, their correlations, and that they do not depend on order."""

from __future__ import annotations

import math
from hashlib import blake2b

import numpy as np
import pytest
from scipy import stats

from rolamento.errors import InputError
from rolamento.studies import Correlation, Distribution, Scatter
from rolamento.studies.fields import read_field
from rolamento.studies.laws import Lognormal, Normal, Triangular, Weibull, truncated_normal
from rolamento.studies.scatter import Sampler, difference_in_si, factor_of, uniform

COUNT = 40_000
INNER, OUTER = "bearing.inner_conformity", "bearing.outer_conformity"
ANGLE = "bearing.contact_angle"
NORMAL = Distribution(distribution="normal", mean="40 deg", standard_deviation="0.5 deg")
FLAT = Distribution(distribution="uniform", minimum=0.51, maximum=0.53)


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
    ("minimum", "maximum"),
    [(39.8, None), (None, 40.2), (39.5, 40.4), (41.0, 42.0), (37.0, 38.0), (44.0, None)],
)
def test_truncated_normal(minimum: float | None, maximum: float | None) -> None:
    bounds = {
        name: f"{value} deg"
        for name, value in (("minimum", minimum), ("maximum", maximum))
        if value is not None
    }
    scatter = Scatter(count=COUNT, fields={ANGLE: NORMAL.replace(**bounds)})
    drawn = np.degrees(draws(scatter)[ANGLE])
    low = (minimum - 40.0) / 0.5 if minimum is not None else -np.inf
    high = (maximum - 40.0) / 0.5 if maximum is not None else np.inf
    assert agrees(drawn, stats.truncnorm(low, high, 40.0, 0.5).cdf)
    assert drawn.min() >= (minimum or 0.0) - 1e-9
    assert drawn.max() <= (maximum or 90.0) + 1e-9


@pytest.mark.parametrize(("low", "high"), [(-1.0, 2.0), (3.0, 4.0), (-25.0, -24.0), (20.0, 29.0)])
def test_quantile_of_the_truncated_normal(low: float, high: float) -> None:
    shares = np.linspace(0.001, 0.999, 97)
    expected = stats.truncnorm(low, high).ppf(shares)
    assert np.allclose(truncated_normal(shares, low, high), expected, rtol=1e-7, atol=1e-9)


def test_a_symmetric_truncation_is_symmetric() -> None:
    law = Normal(0.0, 1.0, -2.0, 2.0)
    shares = np.array([0.01, 0.3, 0.5])
    assert np.allclose(law.quantile(shares), -law.quantile(1.0 - shares), atol=1e-12)


# --- lognormal, Weibull, triangular ---------------------------------------------------------

LOAD = "duty.load.fx"
SHARES = np.array([1e-9, 1e-4, 0.01, 0.1, 0.5, 0.632120558828558, 0.9, 0.99, 0.9999, 1.0 - 1e-9])


def law_of(field: str = LOAD, **given: object) -> object:
    return Distribution(**given).law(read_field(field), in_file=True)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("given", "known"),
    [
        (
            {"distribution": "lognormal", "median": "2 kN", "factor": 1.5},
            stats.lognorm(math.log(1.5), scale=2000.0),
        ),
        (
            {"distribution": "lognormal", "median": "2 kN", "factor": 3, "threshold": "500 N"},
            stats.lognorm(math.log(3.0), loc=500.0, scale=1500.0),
        ),
        (
            {"distribution": "weibull", "shape": 1.5, "scale": "2 kN"},
            stats.weibull_min(1.5, scale=2000.0),
        ),
        (
            {"distribution": "weibull", "shape": 0.8, "scale": "2 kN", "threshold": "1 kN"},
            stats.weibull_min(0.8, loc=1000.0, scale=2000.0),
        ),
        (
            {"distribution": "triangular", "minimum": "1 kN", "mode": "2 kN", "maximum": "5 kN"},
            stats.triang(0.25, loc=1000.0, scale=4000.0),
        ),
        (
            {"distribution": "triangular", "minimum": "1 kN", "mode": "1 kN", "maximum": "5 kN"},
            stats.triang(0.0, loc=1000.0, scale=4000.0),
        ),
        (
            {"distribution": "triangular", "minimum": "1 kN", "mode": "5 kN", "maximum": "5 kN"},
            stats.triang(1.0, loc=1000.0, scale=4000.0),
        ),
    ],
)
def test_laws_are_scipys(given: dict[str, object], known: object) -> None:
    found = law_of(**given).quantile(SHARES)  # type: ignore[attr-defined]
    np.testing.assert_allclose(found, known.ppf(SHARES), rtol=1e-9)  # type: ignore[attr-defined]


def test_median_and_factor_enclose_two_thirds() -> None:
    """68.27 % of the draws lie within a factor of the median: one standard deviation."""
    law = law_of(distribution="lognormal", median="2 kN", factor=1.5)
    one = stats.norm.cdf([-1.0, 1.0])
    np.testing.assert_allclose(law.quantile(one), [2000.0 / 1.5, 3000.0])  # type: ignore[attr-defined]


@pytest.mark.parametrize("threshold", [None, "1 kN", "-3 kN"])
def test_lognormal_by_mean_and_standard_deviation(threshold: str | None) -> None:
    given = {"distribution": "lognormal", "mean": "2 kN", "standard_deviation": "400 N"}
    law = law_of(**given, **({} if threshold is None else {"threshold": threshold}))
    assert isinstance(law, Lognormal)
    known = stats.lognorm(law.deviation, loc=law.minimum, scale=law.median)
    assert known.mean() == pytest.approx(2000.0)
    assert known.std() == pytest.approx(400.0)


def test_characteristic_value_of_weibull() -> None:
    """A share of 1 − 1/e lies below threshold + scale, whatever the shape (IEC 61649)."""
    for shape in (0.5, 1.1, 4.0):
        law = law_of(distribution="weibull", shape=shape, scale="2 kN", threshold="1 kN")
        found = law.quantile(np.array([1.0 - math.exp(-1.0)]))  # type: ignore[attr-defined]
        assert found[0] == pytest.approx(3000.0)


def test_moments_of_weibull_and_triangle() -> None:
    """Mean η Γ(1 + 1/β) and (a + b + c)/3; variance of the triangle (Johnson, Kotz, 1995)."""
    shares = (np.arange(400_000) + 0.5) / 400_000
    weibull = Weibull(0.0, 2.0, 1.5).quantile(shares)
    assert weibull.mean() == pytest.approx(2.0 * math.gamma(1.0 + 1.0 / 1.5), rel=1e-5)
    a, c, b = 1.0, 2.0, 5.0
    triangle = Triangular(a, c, b).quantile(shares)
    assert triangle.mean() == pytest.approx((a + b + c) / 3.0, rel=1e-9)
    variance = (a * a + b * b + c * c - a * b - a * c - b * c) / 18.0
    assert triangle.var() == pytest.approx(variance, rel=1e-5)


@pytest.mark.parametrize(("low", "high"), [(1.0, 2.5), (-math.inf, 1.0), (6.0, math.inf)])
def test_laws_that_are_cut_off(low: float, high: float) -> None:
    """What is left between the bounds, not draws moved onto them."""
    for law, known in (
        (Weibull(0.2, 2.0, 1.7, low, high), stats.weibull_min(1.7, loc=0.2, scale=2.0)),
        (Lognormal(0.2, 1.4, 0.6, low, high), stats.lognorm(0.6, loc=0.2, scale=1.4)),
    ):
        below, above = known.cdf(low), known.cdf(high)
        expected = known.ppf(below + SHARES * (above - below))
        np.testing.assert_allclose(law.quantile(SHARES), expected, rtol=1e-6)


def test_weibull_is_exact_far_out() -> None:
    """Beyond 20 deviations nothing underflows: an exponential forgets what came before."""
    law = Weibull(0.0, 1.0, 1.0, 400.0)
    expected = 400.0 + stats.expon.ppf(SHARES)
    np.testing.assert_allclose(law.quantile(SHARES), expected, rtol=1e-12)


def test_draws_of_each_law_and_their_correlation() -> None:
    weibull = Distribution(distribution="weibull", shape=2, scale=0.004, threshold=0.515)
    lognormal = Distribution(distribution="lognormal", median=0.52, factor=1.002)
    pair = Correlation(fields=(INNER, OUTER), coefficient=0.7)
    scatter = Scatter(count=COUNT, fields={INNER: weibull, OUTER: lognormal}, correlations=[pair])
    drawn = draws(scatter)
    assert agrees(drawn[INNER], stats.weibull_min(2.0, loc=0.515, scale=0.004).cdf)
    assert agrees(drawn[OUTER], stats.lognorm(math.log(1.002), scale=0.52).cdf)
    rank = stats.spearmanr(drawn[INNER], drawn[OUTER]).statistic
    assert rank == pytest.approx(6.0 / math.pi * math.asin(0.35), abs=0.015)


@pytest.mark.parametrize(
    ("field", "given", "place", "rule"),
    [
        (LOAD, {"distribution": "lognormal", "median": "2 kN"}, "factor", "missing"),
        (LOAD, {"distribution": "lognormal", "median": "2 kN", "factor": 1}, "factor", "than 1"),
        (LOAD, {"distribution": "lognormal", "median": "2 kN", "factor": 2, "mean": "1 N"},
         "mean", "median, factor"),
        (LOAD, {"distribution": "lognormal", "median": "2 kN", "factor": 2, "threshold": "3 kN"},
         "median", "threshold"),
        (LOAD, {"distribution": "lognormal", "median": "-2 kN", "factor": 2},
         "median", "threshold"),
        (LOAD, {"distribution": "lognormal", "median": "2 kN", "factor": 2, "maximum": "-1 N"},
         "maximum", "threshold"),
        (LOAD, {"distribution": "lognormal", "median": "2 kN", "factor": 1.01,
                "threshold": "0 N", "minimum": "20 kN"}, "minimum", "nothing"),
        (LOAD, {"distribution": "weibull", "shape": 0, "scale": "1 kN"}, "shape", "than 0"),
        (LOAD, {"distribution": "weibull", "shape": 2}, "scale", "missing"),
        (LOAD, {"distribution": "weibull", "shape": 2, "scale": 5}, "scale", "unit"),
        (LOAD, {"distribution": "weibull", "shape": 2, "scale": "-1 N"}, "scale", "positive"),
        (LOAD, {"distribution": "weibull", "shape": 9, "scale": "1 N", "threshold": "0 N",
                "minimum": "3 N"}, "minimum", "nothing"),
        (LOAD, {"distribution": "weibull", "shape": 2, "scale": "1 N", "mode": "1 N"},
         "mode", "shape, scale"),
        (LOAD, {"distribution": "triangular", "minimum": "1 N", "mode": "3 N", "maximum": "2 N"},
         "mode", "minimum to maximum"),
        (LOAD, {"distribution": "triangular", "minimum": "1 N", "maximum": "2 N"},
         "mode", "missing"),
        (INNER, {"distribution": "weibull", "shape": 2, "scale": 0.1}, "scale", "median of"),
        (INNER, {"distribution": "triangular", "minimum": -0.4, "mode": 0.52, "maximum": 0.53},
         "minimum", "at least 0.501"),
        ("temperature.lubricant", {"distribution": "weibull", "shape": 2, "scale": "30 K"},
         "threshold", "natural zero"),
        ("temperature.lubricant", {"distribution": "weibull", "shape": 2, "scale": "30 degC",
                                   "threshold": "20 degC"}, "scale", "in K"),
    ],
)  # fmt: skip
def test_what_no_law_is(field: str, given: dict[str, object], place: str, rule: str) -> None:
    with pytest.raises(InputError, match=rule) as refused:
        law_of(field, **given)
    assert refused.value.field == place


def test_laws_are_written_as_they_are_read() -> None:
    warm = Distribution(
        distribution="weibull", shape=2.5, scale=30.0, threshold=293.15, maximum=400.0
    )
    field = read_field("temperature.lubricant")
    written = warm.written(field)
    assert (written.scale, written.threshold) == ("30.0 K", "20 degC")
    assert written.law(field, in_file=True) == warm.law(field, in_file=False)


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
