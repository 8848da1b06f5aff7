"""Rank correlation and Sobol's indices against functions whose answers are known."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from rolamento import InputError
from rolamento.studies import laws as laws_
from rolamento.studies.outputs import outputs_of
from rolamento.studies.sensitivity import rank_correlation, sobol, sobol_of_model

PI = np.pi


def study(outputs: Mapping[str, Any], inputs: Mapping[str, Any], **given: Any) -> xr.Dataset:
    status = given.get("status", np.zeros(len(next(iter(inputs.values()))), np.int8))
    data: dict[str, Any] = {"status": ("sample", status)}
    data |= {name: ("sample", values, {"units": "N"}) for name, values in outputs.items()}
    coordinates = {name: ("sample", values, {"units": "N"}) for name, values in inputs.items()}
    return xr.Dataset(data, coordinates)


def draws(count: int = 4000, seed: int = 0, inputs: int = 3) -> Any:
    return np.random.default_rng(seed).normal(size=(inputs, count))


# --- rank correlation -------------------------------------------------------------------------


def test_a_linear_function_has_the_coefficients_of_its_weights() -> None:
    """Of normal inputs: Spearman's is 6/π asin(ρ/2) with ρ a weight over the whole spread."""
    a, b, c = draws(20_000)
    found = rank_correlation(study({"y": 3.0 * a - 2.0 * b + 0.0 * c}, {"a": a, "b": b, "c": c}))
    rho = np.array([3.0, -2.0, 0.0]) / np.sqrt(13.0)
    expected = 6.0 / PI * np.arcsin(0.5 * rho)
    np.testing.assert_allclose(found["y"].coefficient, expected, atol=0.02)
    assert (found["y"].low < expected).all()
    assert (expected < found["y"].high).all()
    assert found.ranking("y") == (0, 1, 2)
    assert not found.correlated


def test_coefficients_are_scipys() -> None:
    a, b, _ = draws(300)
    found = rank_correlation(study({"y": a**3 + b}, {"a": a, "b": b}))["y"]
    assert found.coefficient[0] == pytest.approx(stats.spearmanr(a, a**3 + b).statistic)
    assert found.coefficient[1] == pytest.approx(stats.spearmanr(b, a**3 + b).statistic)


@given(st.integers(0, 1000), st.floats(0.1, 3.0), st.floats(-2.0, 2.0))
def test_rising_transforms_change_nothing(seed: int, scale: float, shift: float) -> None:
    a, b = draws(200, seed, 2)
    y = a + 0.5 * b
    plain = rank_correlation(study({"y": y}, {"a": a, "b": b}))["y"]
    bent = rank_correlation(
        study({"y": np.exp(scale * y)}, {"a": np.arctan(a + shift), "b": b**3})
    )["y"]
    np.testing.assert_allclose(bent.coefficient, plain.coefficient, atol=1e-12)
    np.testing.assert_allclose(bent.partial, plain.partial, atol=1e-10)


def test_a_correlated_bystander_is_cleared_by_the_partial_coefficient() -> None:
    a, noise, c = draws(5000)
    bystander = 0.8 * a + 0.6 * noise
    found = rank_correlation(study({"y": a + 0.3 * c}, {"a": a, "b": bystander, "c": c}))
    one = found["y"]
    assert found.correlated
    assert one.coefficient[1] > 0.7
    assert abs(one.partial[1]) < 0.06
    assert one.partial[0] > 0.9
    assert found.ranking("y")[0] == 0
    assert found.telling("y")[0] is one.partial


def test_partial_coefficients_are_those_of_the_inverse_matrix() -> None:
    """Anderson (1958): -P_ij/√(P_ii P_jj) with the inverse P of the correlation matrix."""
    a, noise, c = draws(400)
    b = a + noise
    y = a - 2.0 * b + c
    found = rank_correlation(study({"y": y}, {"a": a, "b": b, "c": c}))["y"]
    inverse = np.linalg.inv(stats.spearmanr(np.stack([a, b, c, y]), axis=1).statistic)
    expected = -inverse[3, :3] / np.sqrt(inverse[3, 3] * np.diagonal(inverse)[:3])
    np.testing.assert_allclose(found.partial, expected, rtol=1e-9)


def test_the_interval_covers_as_often_as_it_says() -> None:
    rho, covered = 0.6, 0
    truth = 6.0 / PI * np.arcsin(0.5 * rho)
    for seed in range(300):
        a, noise = draws(80, seed, 2)
        y = rho * a + np.sqrt(1.0 - rho**2) * noise
        one = rank_correlation(study({"y": y}, {"a": a}))["y"]
        covered += bool(one.low[0] <= truth <= one.high[0])
    assert 0.91 <= covered / 300 <= 0.99


def test_an_input_that_fixes_the_output_has_one() -> None:
    (a,) = draws(50, inputs=1)
    one = rank_correlation(study({"y": -np.exp(a)}, {"a": a}))["y"]
    assert one.coefficient[0] == pytest.approx(-1.0)
    assert one.partial[0] == pytest.approx(-1.0)
    assert one.high[0] < -0.99


def test_an_output_that_is_rounding_has_no_rank() -> None:
    a, b, noise = draws(200)
    data = study({"y": 1e3 * a, "zero": 1e-12 * noise, "same": np.full(200, 2.0)}, {"a": a, "b": b})
    found = rank_correlation(data)
    for name in ("zero", "same"):
        assert np.isnan(found[name].coefficient).all()
        assert np.isnan(found[name].partial).all()
        assert found.ranking(name) == ()


def test_an_input_that_does_not_vary_has_no_coefficient() -> None:
    a, b, _ = draws(200)
    found = rank_correlation(study({"y": a + b}, {"a": a, "b": b, "c": np.full(200, 1.0)}))
    one = found["y"]
    assert np.isnan(one.coefficient[2])
    assert np.isnan(one.partial[2])
    assert np.isfinite(one.coefficient[:2]).all()
    assert not found.correlated


def test_samples_without_a_result_have_no_say() -> None:
    a, b, _ = draws(300)
    y = a + b
    status = np.zeros(300, np.int8)
    status[::3] = 2
    spoilt = np.where(status == 2, 1e9, y)
    found = rank_correlation(study({"y": spoilt}, {"a": a, "b": b}, status=status))["y"]
    kept = status == 0
    expected = rank_correlation(study({"y": y[kept]}, {"a": a[kept], "b": b[kept]}))["y"]
    np.testing.assert_allclose(found.coefficient, expected.coefficient)


def test_too_few_samples_give_no_coefficient() -> None:
    a, b, _ = draws(7)
    assert np.isnan(rank_correlation(study({"y": a}, {"a": a, "b": b}))["y"].coefficient).all()


def test_without_inputs_there_is_nothing_to_rank() -> None:
    data = xr.Dataset({"status": ("sample", np.zeros(9, np.int8)), "y": ("sample", np.arange(9.0))})
    with pytest.raises(InputError, match="no scattered input"):
        rank_correlation(data)


# --- Sobol's indices --------------------------------------------------------------------------


class Uniform:
    """From low to high."""

    def __init__(self, low: float, high: float) -> None:
        self._low, self._high = low, high

    def quantile(self, probability: Any, /) -> Any:
        return self._low + (self._high - self._low) * probability


class Normal:
    def quantile(self, probability: Any, /) -> Any:
        return stats.norm.ppf(probability)


def ishigami(inputs: Mapping[str, Any]) -> dict[str, Any]:
    a, b, c = (inputs[name] for name in "abc")
    return {"y": np.sin(a) + 7.0 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a)}


def test_the_ishigami_function_has_its_known_indices() -> None:
    """Ishigami and Homma (1990): 0.3139, 0.4424, 0; totals 0.5576, 0.4424, 0.2437."""
    found = sobol_of_model(ishigami, {name: Uniform(-PI, PI) for name in "abc"}, samples=8192)
    variance = 49.0 / 8.0 + 0.1 * PI**4 / 5.0 + 0.01 * PI**8 / 18.0 + 0.5
    first = np.array([0.5 * (1.0 + 0.1 * PI**4 / 5.0) ** 2, 49.0 / 8.0, 0.0]) / variance
    shared = 0.01 * PI**8 * (1.0 / 18.0 - 1.0 / 50.0) / variance
    np.testing.assert_allclose(first[:2], [0.3139, 0.4424], atol=1e-4)
    np.testing.assert_allclose(found.first_order[0], first, atol=0.01)
    np.testing.assert_allclose(found.total[0], first + np.array([shared, 0.0, shared]), atol=0.01)
    assert (found.first_low[0] <= first + 0.005).all()
    assert (first - 0.005 <= found.first_high[0]).all()
    assert found.runs == 8192 * 5


def test_a_sum_of_normals_shares_its_variance_by_the_squares_of_the_weights() -> None:
    weights = np.array([1.0, 2.0, 3.0])

    def model(inputs: Mapping[str, Any]) -> dict[str, Any]:
        drawn = np.stack([inputs[name] for name in "abc"])
        return {"y": 1e6 + weights @ drawn, "one": drawn[1], "flat": np.full(drawn.shape[1], 3.0)}

    found = sobol_of_model(model, {name: Normal() for name in "abc"}, samples=2048)
    expected = weights**2 / 14.0
    np.testing.assert_allclose(found.first_order[0], expected, atol=0.01)
    np.testing.assert_allclose(found.total[0], expected, atol=0.01)
    np.testing.assert_allclose(found.total[1], [0.0, 1.0, 0.0], atol=0.01)
    for array in (found.first_order, found.total, found.first_low, found.total_high):
        assert np.isnan(array[2]).all()
    assert (found.first_low[:2] <= found.first_order[:2] + 1e-9).all()
    assert (found.first_order[:2] <= found.first_high[:2] + 1e-9).all()


def test_a_product_of_lognormals_shares_its_variance_as_the_formula_has_it() -> None:
    """Y = A B of ln-deviations s: S_A = (exp s_A² − 1)/(exp(s_A² + s_B²) − 1)."""
    deviations = {"a": 0.5, "b": 0.3}
    laws = {name: laws_.Lognormal(0.0, 2.0, s) for name, s in deviations.items()}
    found = sobol_of_model(lambda given: {"y": given["a"] * given["b"]}, laws, samples=4096)
    whole = np.expm1(sum(s * s for s in deviations.values()))
    first = np.array([np.expm1(s * s) for s in deviations.values()]) / whole
    np.testing.assert_allclose(found.first_order[0], first, atol=0.01)
    np.testing.assert_allclose(found.total[0], 1.0 - first[::-1], atol=0.01)


def test_a_sum_of_weibull_and_triangle_shares_its_variance() -> None:
    weibull, triangle = laws_.Weibull(0.0, 1.0, 1.5), laws_.Triangular(0.0, 1.0, 3.0)
    found = sobol_of_model(
        lambda given: {"y": given["w"] + given["t"]}, {"w": weibull, "t": triangle}, samples=4096
    )
    variances = np.array([stats.weibull_min(1.5).var(), stats.triang(1 / 3, scale=3.0).var()])
    np.testing.assert_allclose(found.first_order[0], variances / variances.sum(), atol=0.01)


def test_the_same_seed_gives_the_same_numbers() -> None:
    given_inputs = {name: Uniform(-PI, PI) for name in "abc"}
    one, again, other = (
        sobol_of_model(ishigami, given_inputs, samples=64, seed=seed, resamples=20)
        for seed in (7, 7, 8)
    )
    np.testing.assert_array_equal(one.first_order, again.first_order)
    np.testing.assert_array_equal(one.total_high, again.total_high)
    assert (one.first_order != other.first_order).any()


def test_draws_without_a_result_are_refused_with_their_number() -> None:
    def model(inputs: Mapping[str, Any]) -> dict[str, Any]:
        return {"y": np.where(inputs["a"] > 0.5, np.nan, inputs["a"])}

    with pytest.raises(InputError, match=r"24 of 48 draws have no result"):
        sobol_of_model(model, {"a": Uniform(0.0, 1.0)}, samples=16)


@pytest.mark.parametrize(
    ("given_numbers", "words"),
    [
        ({"samples": 100}, "power of two"),
        ({"samples": 8}, "power of two"),
        ({"samples": 2**22}, "runs with"),
        ({"confidence": 1.0}, "between 0 and 1"),
        ({"resamples": 1}, "from 10 to 10"),
    ],
)
def test_numbers_out_of_range_are_refused(given_numbers: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        sobol_of_model(ishigami, {name: Uniform(0.0, 1.0) for name in "abc"}, **given_numbers)


# --- of a study -------------------------------------------------------------------------------


STUDY = """
outputs = ["x", "max_inner_load"]
case = "218_combined.toml"
[scatter]
count = 100
[scatter.fields."duty.load.fx"]
distribution = "normal"
mean = "20 kN"
standard_deviation = "1 kN"
[scatter.fields."duty.load.fz"]
distribution = "uniform"
minimum = "2 kN"
maximum = "3 kN"
[scatter.fields."bearing.ball_diameter"]
distribution = "normal"
mean = "22.23 mm"
standard_deviation = "0.1 um"
"""


def test_a_study_is_run_for_its_indices(examples: Path) -> None:
    """The displacement follows the axial load, and the grain of the balls by a hair."""
    from rolamento.studies import parse_study

    found = sobol(parse_study(STUDY, folder=examples), samples=128, resamples=20)
    assert found.inputs == ("duty.load.fx", "duty.load.fz", "bearing.ball_diameter")
    assert found.outputs == ("x", "max_inner_load")
    assert found.first_order[0, 0] > 0.97
    assert abs(found.total[0, 2]) < 0.01
    assert found.first_order[1, 1] > 0.02
    np.testing.assert_allclose(found.first_order.sum(axis=1), 1.0, atol=0.05)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"scatter": None}, "is missing: Sobol's indices need scattered fields"),
        ({"axes": (1,)}, "must be left out for Sobol's indices, which are of one point"),
        (
            {"outputs": ("inner_load",)},
            "is one value for each ball; Sobol's indices are for outputs",
        ),
    ],
)
def test_a_study_of_another_kind_is_refused(
    examples: Path, changes: dict[str, Any], words: str
) -> None:
    from rolamento.studies import parse_study

    study_given = parse_study(STUDY, folder=examples)
    fields = ("scatter", "axes", "variants", "outputs", "case", "seed")
    given = {name: getattr(study_given, name) for name in fields} | changes
    stand_in = SimpleNamespace(**given, variables=outputs_of(given["outputs"]))
    with pytest.raises(InputError, match=words):
        sobol(stand_in)  # type: ignore[arg-type]


def test_correlated_inputs_are_refused_by_name(examples: Path) -> None:
    from rolamento.studies import parse_study

    text = STUDY + (
        '[[scatter.correlations]]\nfields = ["duty.load.fx", "duty.load.fz"]\ncoefficient = 0.5\n'
    )
    with pytest.raises(InputError, match=r"duty.load.fx and duty.load.fz.*independent"):
        sobol(parse_study(text, folder=examples))


def test_a_load_that_balances_to_zero_has_no_rank() -> None:
    """Beside nothing else in its unit, a moment of 1e-10 N·m is known for rounding."""
    a, b, noise = draws(200)
    data = study({"y": a, "mz": 1e-10 * noise}, {"a": a, "b": b})
    data["mz"].attrs["units"] = "N*m"
    assert rank_correlation(data).ranking("mz") == ()
    data["mz"].attrs["units"] = "1"
    assert len(rank_correlation(data).ranking("mz")) == 2
