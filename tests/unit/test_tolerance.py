"""Tolerance bands against distributions whose percentiles are known."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from scipy import stats

from rolamento import Bearing, InputError, load_case
from rolamento.plots.tolerance import tolerance_figure
from rolamento.solution import solve
from rolamento.studies import parse_study, run
from rolamento.studies.sensitivity import ToleranceStudy
from rolamento.studies.tolerance import clearance_from_temperature, samples_of, tolerance_bands


def study(
    outputs: dict[str, Any],
    inputs: dict[str, Any] | None = None,
    status: Any = None,
    dims: tuple[str, ...] = ("sample",),
    units: str = "N",
) -> xr.Dataset:
    """What a scatter study writes, with the given numbers."""
    shape = np.shape(next(iter(outputs.values())))
    codes = np.zeros(shape, np.int8) if status is None else np.asarray(status, np.int8)
    flags = {
        "flag_values": np.array([0, 1, 2], np.int8),
        "flag_meanings": "converged no_equilibrium not_converged",
    }
    data: dict[str, Any] = {"status": (dims, codes, flags)}
    for name, values in outputs.items():
        data[name] = (dims, values, {"units": units, "long_name": f"the {name}"})
    coordinates = {
        name: ("sample", values, {"units": "N", "long_name": name, "field": f"duty.load.{name}"})
        for name, values in (inputs or {}).items()
    }
    return xr.Dataset(data, coordinates)


@pytest.fixture
def normal() -> Any:
    """Draws in the middle of equal shares of a normal distribution."""
    return stats.norm(10.0, 2.0).ppf((np.arange(4000) + 0.5) / 4000)


def test_percentiles_of_a_normal_distribution(normal: Any) -> None:
    shuffled = np.random.default_rng(1).permutation(normal)
    band = tolerance_bands(study({"q": shuffled}))["q"]
    expected = stats.norm(10.0, 2.0).ppf(np.array([0.135, 5, 50, 95, 99.865]) / 100.0)
    np.testing.assert_allclose(band.percentile, expected, atol=0.03)
    assert band.mean == pytest.approx(10.0)
    assert band.standard_deviation == pytest.approx(2.0, rel=2e-3)
    assert int(band.count) == 4000
    assert (band.units, band.long_name) == ("N", "the q")


def test_percentiles_are_scipys(normal: Any) -> None:
    drawn = np.random.default_rng(2).choice(normal, 501)
    band = tolerance_bands(study({"q": drawn}), (1.0, 30.0, 99.0))["q"]
    expected = np.quantile(drawn, [0.01, 0.3, 0.99], method="median_unbiased")
    np.testing.assert_allclose(band.percentile, expected, rtol=1e-13)


@pytest.mark.parametrize("count", [5, 40, 1000])
@pytest.mark.parametrize("confidence", [0.9, 0.99])
def test_intervals_are_those_of_scipys_quantile_test(count: int, confidence: float) -> None:
    drawn = np.random.default_rng(3).gamma(2.0, size=count)
    percentiles = (0.135, 5.0, 50.0, 95.0)
    band = tolerance_bands(study({"q": drawn}), percentiles, confidence=confidence)["q"]
    for index, percent in enumerate(percentiles):
        tested = stats.quantile_test(drawn, p=percent / 100.0)
        interval = tested.confidence_interval(confidence_level=confidence)
        np.testing.assert_array_equal(
            [band.low[index], band.high[index]], [interval.low, interval.high]
        )


def test_an_interval_covers_as_often_as_it_says() -> None:
    drawn = np.random.default_rng(4).normal(size=(400, 60))
    band = tolerance_bands(study({"q": drawn}, dims=("run", "sample")), (80.0,))["q"]
    truth = stats.norm.ppf(0.8)
    covered = np.mean((band.low[0] <= truth) & (truth <= band.high[0]))
    assert 0.94 <= covered <= 1.0


def test_a_percentile_beyond_the_samples_is_not_guessed() -> None:
    few = tolerance_bands(study({"q": np.arange(100.0)}))["q"]
    assert np.isnan(few.percentile[[0, -1]]).all()
    assert np.isfinite(few.percentile[1:-1]).all()
    assert np.isnan(few.low[0])
    assert np.isnan(few.high[-1])
    enough = tolerance_bands(study({"q": np.arange(600.0)}))["q"]
    assert np.isfinite(enough.percentile).all()


def test_samples_without_a_result_are_counted_and_left_out(normal: Any) -> None:
    status = np.zeros(4000)
    status[:200], status[200:300] = 1, 2
    values = normal.copy()
    values[:300] = np.nan
    values[:5] = 1e9  # never shown, whatever stands there
    bands = tolerance_bands(study({"q": values}, status=status))
    assert bands.samples == 4000
    assert int(bands.without_result) == 300
    assert bands.share_without_result == pytest.approx(0.075)
    assert bands.failures == {"no_equilibrium": 200, "not_converged": 100}
    assert int(bands["q"].count) == 3700
    assert bands["q"].mean == pytest.approx(normal[300:].mean())


def test_nothing_but_failures_gives_no_numbers() -> None:
    bands = tolerance_bands(study({"q": np.full(10, np.nan)}, status=np.ones(10)))
    band = bands["q"]
    assert int(band.count) == 0
    assert np.isnan(band.percentile).all()
    assert np.isnan(band.mean)
    assert bands.share_without_result == 1.0


def test_further_axes_remain(normal: Any) -> None:
    values = np.stack([normal, 3.0 * normal])
    status = np.zeros((2, 4000))
    status[1, :7] = 1
    data = study({"q": values}, status=status, dims=("speed", "sample"))
    data = data.assign_coords(speed=("speed", [1.0, 2.0], {"units": "rad/s"}))
    bands = tolerance_bands(data, (50.0,))
    band = bands["q"]
    assert band.axes == ("speed",)
    np.testing.assert_allclose(band.percentile[0], [10.0, 30.0], rtol=1e-2)
    np.testing.assert_array_equal(band.count, [4000, 3993])
    np.testing.assert_array_equal(bands.without_result, [0, 7])
    assert samples_of(data).axes == ("speed",)


def test_the_order_of_the_dimensions_does_not_matter(normal: Any) -> None:
    data = study({"q": np.stack([normal, 3.0 * normal])}, dims=("speed", "sample"))
    turned = data.transpose("sample", "speed")
    one, other = tolerance_bands(data)["q"], tolerance_bands(turned)["q"]
    np.testing.assert_array_equal(one.percentile, other.percentile)


@pytest.mark.parametrize("percentiles", [(), (0.0,), (100.0,), (float("nan"),), range(1, 60)])
def test_percentiles_have_bounds(percentiles: Any, normal: Any) -> None:
    with pytest.raises(InputError, match="percentiles"):
        tolerance_bands(study({"q": normal}), percentiles)


@pytest.mark.parametrize("confidence", [0.0, 1.0, -1.0, float("nan")])
def test_the_confidence_has_bounds(confidence: float, normal: Any) -> None:
    with pytest.raises(InputError, match="between 0 and 1"):
        tolerance_bands(study({"q": normal}), confidence=confidence)


def test_a_study_without_scatter_is_refused() -> None:
    sweep = study({"q": np.arange(4.0)}, dims=("speed",))
    with pytest.raises(InputError, match="has no scatter"):
        tolerance_bands(sweep)
    with pytest.raises(InputError, match="has no output"):
        tolerance_bands(study({"q": np.arange(4.0)})[["status"]])


# --- clearance and temperature ----------------------------------------------------------------


DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.015 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
}


def test_a_warmer_inner_ring_takes_up_clearance() -> None:
    """12.5e-6 of 77.7 mm a kelvin: 9.7 µm over 10 K."""
    bearing = Bearing(**DEEP_GROOVE)
    found = clearance_from_temperature(bearing, [0.0, 10.0, -10.0])
    np.testing.assert_allclose(1e6 * found, [15.0, 15.0 - 9.7125, 15.0 + 9.7125], rtol=1e-12)


def test_for_the_6308_it_agrees_with_the_makers_rule() -> None:
    """NSK's outer raceway diameter (4 D + d)/5 of 90 mm and 40 mm stands for d_m + D."""
    bearing = Bearing(
        **DEEP_GROOVE | {"ball_count": 8, "ball_diameter": "15.081 mm", "pitch_diameter": "65 mm"}
    )
    taken = 15e-6 - float(clearance_from_temperature(bearing, 5.0))
    assert taken == pytest.approx(12.5e-6 * 5.0 * (4 * 0.090 + 0.040) / 5, rel=0.01)


def test_scattered_temperature_becomes_scattered_clearance() -> None:
    """Linear: the mean shifts, the standard deviation scales."""
    bearing = Bearing(**DEEP_GROOVE)
    drawn = np.random.default_rng(5).normal(8.0, 2.0, 5000)
    found = clearance_from_temperature(bearing, drawn)
    factor = 12.5e-6 * 77.7e-3
    assert found.mean() == pytest.approx(15e-6 - factor * drawn.mean())
    assert found.std() == pytest.approx(factor * drawn.std())


def test_what_has_no_clearance_or_no_sense_is_refused() -> None:
    angular = Bearing(
        **{k: v for k, v in DEEP_GROOVE.items() if k != "diametral_clearance"},
        contact_angle="15 deg",
    )
    with pytest.raises(InputError, match="no clearance to change"):
        clearance_from_temperature(angular, 1.0)
    for difference in (float("nan"), 201.0, [1.0, -1e9]):
        with pytest.raises(InputError, match="200 K"):
            clearance_from_temperature(Bearing(**DEEP_GROOVE), difference)


def test_a_scatter_of_temperature_is_studied_as_one_of_clearance(examples: Path) -> None:
    """The study of docs/tolerance.md against draws of temperature and manufacture by themselves."""
    radial = load_case(examples / "209_radial.toml")
    generator = np.random.default_rng(7)
    warmer = clearance_from_temperature(radial.bearing, generator.normal(8.0, 2.0, 4000))
    drawn = warmer + generator.normal(0.0, 3e-6, 4000)
    direct = solve(radial, {"bearing.diametral_clearance": drawn})

    text = """
    outputs = ["z", "max_inner_load"]
    [scatter]
    count = 4000
    [scatter.fields."bearing.diametral_clearance"]
    distribution = "normal"
    mean = "7.23 um"
    standard_deviation = "3.574 um"
    """
    studied = parse_study(f'case = "209_radial.toml"\n{text}', folder=examples)
    band = tolerance_bands(run(studied), (5.0, 50.0, 95.0))["z"]
    expected = np.quantile(direct.displacement.array[:, 2], [0.05, 0.5, 0.95])
    np.testing.assert_allclose(band.percentile, expected, atol=0.4e-6)  # four deviations
    assert band.units == "m"


# --- the figure -------------------------------------------------------------------------------


def test_the_figure_has_a_panel_for_each_output() -> None:
    generator = np.random.default_rng(6)
    load, other = generator.normal(1e3, 50.0, (2, 500))
    data = study({"q": 3.0 * load, "p": load - 2.0 * other}, {"fx": load, "fz": other})
    figure = tolerance_figure(ToleranceStudy.of(data))
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert [title for title in titles if title] == ["The q", "The p"]
    bars = [patch.get_width() for patch in figure.axes[1].patches]
    assert max(bars) == pytest.approx(1.0, abs=1e-6)


def test_the_figure_of_nothing_but_failures_says_so() -> None:
    data = study({"q": np.full(10, np.nan)}, {"fx": np.arange(10.0)}, status=np.ones(10))
    figure = tolerance_figure(ToleranceStudy.of(data))
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert any("no sample has a result" in text for text in texts)
