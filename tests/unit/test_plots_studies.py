"""Figures of studies: lines, maps, distributions; what has no result is left out and told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from scipy.stats.mstats import mquantiles

from rolamento.charts.frame import figure_of
from rolamento.errors import InputError
from rolamento.numerics.percentiles import percentile
from rolamento.plots.saving import save_figure
from rolamento.plots.study import axis_of, has_result, most_telling, outputs
from rolamento.plots.sweep import (
    study_histogram,
    study_lines,
    study_map,
    study_scatter,
    telling_kind,
)
from rolamento.studies.tolerance import tolerance_bands
from rolamento.words import speaking

FLAGS = {
    "flag_values": np.array([0, 1, 2], dtype=np.int8),
    "flag_meanings": "converged no_equilibrium overloaded",
}
RPM = 30.0 / np.pi


def sweep(loads: int = 6, speeds: int = 3, failed: tuple[tuple[int, int], ...] = ()) -> xr.Dataset:
    """A study of axial load and speed; a failed case holds a number that must not be drawn."""
    fx, speed = np.linspace(1e3, 20e3, loads), np.linspace(0.0, 1000.0, speeds)
    pressure = 1e8 * np.cbrt(fx)[:, np.newaxis] * (1.0 + 1e-4 * speed)
    status = np.zeros((loads, speeds), dtype=np.int8)
    for place in failed:
        status[place] = 1
    both = ("fx", "inner_speed")
    load = np.repeat(pressure[..., np.newaxis], 16, axis=2) / 1e5
    return xr.Dataset(
        {
            "x": (both, pressure * 1e-14, {"units": "m", "long_name": "axial displacement"}),
            "max_inner_max_pressure": (both, pressure, {"units": "Pa"}),
            "inner_load": ((*both, "ball"), load, {"units": "N"}),
            "status": (both, status, FLAGS),
        },
        coords={
            "fx": ("fx", fx, {"units": "N", "long_name": "axial load"}),
            "inner_speed": ("inner_speed", speed, {"units": "rad/s"}),
        },
        attrs={"title": "a sweep"},
    )


def scatter(samples: int = 400) -> xr.Dataset:
    random = np.random.default_rng(7)
    clearance = 15e-6 + 2e-6 * random.standard_normal(samples)
    load = 5e3 + 1e8 * (clearance - 15e-6)
    status = np.zeros(samples, dtype=np.int8)
    status[:4] = 2
    return xr.Dataset(
        {
            "max_inner_load": ("sample", load, {"units": "N"}),
            "status": ("sample", status, FLAGS),
        },
        coords={
            "sample": np.arange(samples),
            "diametral_clearance": ("sample", clearance, {"units": "m"}),
        },
    )


def labels(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def shares(axes: Axes) -> list[float]:
    """Heights of the steps of the only outline."""
    (outline,) = axes.patches
    corners = outline.get_path().vertices
    return [float(y) for y in np.asarray(corners)[1:-2:2, 1]]


def texts(axes: Axes) -> str:
    return " ".join(text.get_text() for text in axes.texts)


# --- lines ----------------------------------------------------------------------------------


def test_a_line_over_one_axis() -> None:
    study = sweep().isel(inner_speed=[1])
    axes = Figure().add_subplot()
    assert study_lines(study, "x", axes) is axes
    (line,) = axes.lines
    np.testing.assert_allclose(line.get_xdata(), study.fx.values / 1e3)
    np.testing.assert_allclose(line.get_ydata(), study.x.values[:, 0] * 1e6)
    assert axes.get_xlabel() == "Axial load Fx (kN)"
    assert axes.get_ylabel() == "Axial displacement x (µm)"
    assert axes.get_legend() is None


def test_a_second_axis_is_a_family_of_lines() -> None:
    study = sweep()
    axes = study_lines(study)
    assert len(axes.lines) == 3
    assert axes.get_legend().get_title().get_text() == "Inner ring speed (rpm)"
    assert labels(axes) == ["0", "4775", "9549"]
    assert len({(line.get_linestyle(), line.get_marker()) for line in axes.lines}) == 3
    pressure = study["max_inner_max_pressure"].values / 1e6
    np.testing.assert_allclose([line.get_ydata() for line in axes.lines], pressure.T)
    assert axes.get_ylabel() == "Maximum contact pressure, inner race (MPa)"


def test_over_chooses_the_axis_across() -> None:
    study = sweep()
    axes = study_lines(study, "x", over="inner_speed")
    assert len(axes.lines) == 6
    np.testing.assert_allclose(axes.lines[2].get_xdata(), study.inner_speed.values * RPM)
    np.testing.assert_allclose(axes.lines[2].get_ydata(), study.x.values[2] * 1e6)


def test_failed_cases_leave_gaps_and_crosses() -> None:
    study = sweep(failed=((2, 0), (3, 0), (3, 1)))
    axes = study_lines(study, "x")
    assert np.isnan(axes.lines[0].get_ydata()).tolist() == [False, False, True, True, False, False]
    crosses = axes.lines[-1]
    assert crosses.get_marker() == "x"
    np.testing.assert_allclose(crosses.get_xdata(), study.fx.values[[2, 3]] / 1e3)
    assert labels(axes)[-1] == "no result: 3 of 18"


def test_more_lines_than_can_be_told_apart_are_refused() -> None:
    with pytest.raises(InputError, match="would draw 8 lines along inner_speed"):
        study_lines(sweep(speeds=8, loads=9))


def test_words_as_an_axis() -> None:
    study = xr.Dataset(
        {"x": (("raceway_control", "fx"), [[1e-6, 2e-6], [3e-6, 4e-6]], {"units": "m"})},
        coords={"raceway_control": ["outer", "inner"], "fx": ("fx", [1.0, 2.0], {"units": "N"})},
    )
    assert labels(study_lines(study)) == ["outer", "inner"]
    across = study_lines(study, over="raceway_control")
    assert [tick.get_text() for tick in across.get_xticklabels()] == ["outer", "inner"]


def test_inputs_that_vary_together_are_one_axis() -> None:
    study = xr.Dataset(
        {"x": ("duty", [1e-6, 2e-6, 3e-6], {"units": "m"})},
        coords={
            "fx": ("duty", [1e3, 2e3, 3e3], {"units": "N"}),
            "inner_speed": ("duty", [0.0, 100.0, 300.0], {"units": "rad/s"}),
        },
    )
    assert study_lines(study).get_xlabel() == "Axial load Fx (N)"
    axes = study_lines(study, over="inner_speed")
    assert axes.get_xlabel() == "Inner ring speed (rpm)"
    np.testing.assert_allclose(axes.lines[0].get_xdata(), np.array([0.0, 100.0, 300.0]) * RPM)
    with pytest.raises(InputError, match="it has duty, fx, inner_speed"):
        study_lines(study, over="fz")


def test_samples_along_an_axis_are_a_median_and_a_band() -> None:
    values = np.arange(101.0) * 1e-6 + np.array([0.0, 1e-3, 2e-3])[:, np.newaxis]
    values[2] = np.nan
    study = xr.Dataset(
        {"x": (("fx", "sample"), values, {"units": "m"})},
        coords={"fx": ("fx", [0.0, 1.0, 2.0], {"units": "N"})},
    )
    assert telling_kind(study) == "lines"
    axes = study_lines(study)
    np.testing.assert_allclose(axes.lines[0].get_ydata(), [0.05, 1.05, np.nan])
    assert labels(axes) == ["5 % to 95 %", "median", "no result: 101 of 303"]


def test_values_in_steady_ratios_get_a_logarithmic_axis() -> None:
    study = sweep().isel(inner_speed=[0])
    assert study_lines(study).get_xscale() == "linear"
    even = study.assign_coords(fx=("fx", np.geomspace(10.0, 1e6, 6), {"units": "N"}))
    axes = study_lines(even)
    assert axes.get_xscale() == "log"
    axes.figure.draw_without_rendering()
    assert "0.1" in [tick.get_text() for tick in axes.get_xticklabels()]


@pytest.mark.parametrize(
    ("variable", "over", "message"),
    [
        ("max_iner_max_pressure", "", "did you mean max_inner_max_pressure?"),
        ("status", "", 'variable = "status": is not in the study'),
        ("fx", "", "is not in the study; did you mean x?"),
        ("torque", "", "known: x, max_inner_max_pressure, inner_load"),
        ("x", "fz", "is not an axis of x; it has fx, inner_speed"),
        ("inner_load", "", "varies along fx, inner_speed, ball; a figure shows one or two axes"),
    ],
)
def test_lines_refuse(variable: str, over: str, message: str) -> None:
    with pytest.raises(InputError) as refused:
        study_lines(sweep(), variable, over=over)
    assert message in str(refused.value)


def test_one_case_is_no_figure() -> None:
    with pytest.raises(InputError, match="is of a single case"):
        study_lines(sweep().isel(fx=[0], inner_speed=[0]))


def test_lines_of_samples_alone_are_refused() -> None:
    with pytest.raises(InputError, match=r"samples alone .example: histogram"):
        study_lines(scatter())


# --- maps -----------------------------------------------------------------------------------


def mesh_of(axes: Axes) -> QuadMesh:
    (mesh,) = [c for c in axes.collections if isinstance(c, QuadMesh)]
    return mesh


def test_a_map_of_two_axes() -> None:
    study = sweep(8, 9)
    assert telling_kind(study) == "map"
    axes = Figure().add_subplot()
    assert study_map(study, "x", axes) is axes
    values = np.asarray(mesh_of(axes).get_array()).reshape(8, 9)
    np.testing.assert_allclose(values, study.x.values * 1e6)
    assert axes.get_xlabel() == "Inner ring speed (rpm)"
    assert axes.get_ylabel() == "Axial load Fx (kN)"
    bar = figure_of(axes).axes[1]
    assert bar.get_ylabel() == "Axial displacement x (µm)"
    assert axes.get_ylim() == pytest.approx((1.0, 20.0))


def test_a_map_turned_round() -> None:
    study = sweep(8, 9)
    axes = study_map(study, "x", over="fx")
    assert axes.get_xlabel() == "Axial load Fx (kN)"
    values = np.asarray(mesh_of(axes).get_array()).reshape(9, 8)
    np.testing.assert_allclose(values, study.x.values.T * 1e6)


def test_colours_of_a_map_hold_all_values() -> None:
    study = sweep(8, 9)
    mesh = mesh_of(study_map(study, "x"))
    values = study.x.values * 1e6
    bounds = mesh.norm.boundaries
    assert bounds[0] <= values.min() < bounds[1]
    assert bounds[-2] < values.max() <= bounds[-1]


def test_failed_cases_of_a_map_are_hatched() -> None:
    study = sweep(8, 9, failed=((0, 0), (4, 4)))
    axes = study_map(study, "x")
    shown = mesh_of(axes).get_array().reshape(8, 9)
    assert np.argwhere(np.ma.getmaskarray(shown)).tolist() == [[0, 0], [4, 4]]
    (behind,) = [p for p in axes.patches if isinstance(p, Rectangle)]
    assert behind.get_hatch()
    assert labels(axes) == ["no result: 2 of 72"]
    assert study_map(sweep(8, 9), "x").get_legend() is None


def test_a_map_draws_cells_in_order_whatever_the_order_of_the_values() -> None:
    study = sweep(8, 9)
    shuffled = study.isel(fx=[3, 0, 7, 1, 2, 4, 6, 5])
    np.testing.assert_allclose(
        mesh_of(study_map(shuffled, "x")).get_array(), mesh_of(study_map(study, "x")).get_array()
    )


def test_balls_are_an_axis_of_a_map() -> None:
    study = sweep().isel(inner_speed=[0])
    assert telling_kind(study, "inner_load") == "lines"  # 6 loads, 16 balls
    axes = study_map(study, "inner_load", over="ball")
    assert axes.get_xlabel() == "Ball"


def test_a_constant_is_a_map_too() -> None:
    study = sweep(8, 9)
    flat = study.assign(x=(study.x.dims, np.full((8, 9), 5e-6), study.x.attrs))
    save = study_map(flat, "x")
    assert np.unique(np.asarray(mesh_of(save).get_array())) == pytest.approx([5.0])


@pytest.mark.parametrize("study", [sweep().isel(fx=[0]), scatter()])
def test_a_map_needs_two_axes(study: xr.Dataset) -> None:
    with pytest.raises(InputError, match="needs a study with two axes"):
        study_map(study)


# --- samples --------------------------------------------------------------------------------


def test_histogram_of_samples() -> None:
    study = scatter()
    assert telling_kind(study) == "histogram"
    axes = Figure().add_subplot()
    assert study_histogram(study, axes=axes) is axes
    assert sum(shares(axes)) == pytest.approx(100.0)
    good = study.max_inner_load.values[4:]
    for line, percent in zip(axes.lines[-3:], (5, 50, 95), strict=True):
        assert line.get_xdata()[0] == pytest.approx(percentile(good, percent))
    assert len({line.get_linestyle() for line in axes.lines[-3:]}) == 3
    assert axes.get_xlabel() == "Maximum contact load, inner race (N)"
    assert axes.get_ylabel() == "Share of the samples (%)"
    assert labels(axes)[0] == "no result: 4 of 400"
    assert labels(axes)[2].startswith("median: ")
    assert labels(axes)[2].endswith(" N")


def test_figure_and_page_give_one_percentile() -> None:
    """Of 57 draws, definitions differ in the third digit: 56.265 on the page, 56.28 in a figure."""
    drawn = 50.0 + 2.5 * np.random.default_rng(4).normal(size=57)
    known = median_unbiased_quantiles(drawn)
    study = xr.Dataset(
        {
            "max_inner_load": ("sample", drawn, {"units": "N"}),
            "status": ("sample", np.zeros(57, np.int8), FLAGS),
        }
    )
    band = tolerance_bands(study, (5.0, 50.0, 95.0))["max_inner_load"].percentile
    np.testing.assert_allclose(band, known, rtol=1e-12)
    axes = study_histogram(study, axes=Figure().add_subplot())
    np.testing.assert_array_equal([line.get_xdata()[0] for line in axes.lines[-3:]], band)
    assert not np.isclose(np.percentile(drawn, 95.0), band[-1], rtol=1e-4)


def median_unbiased_quantiles(values: np.ndarray) -> list[float]:
    """As SciPy has Hyndman and Fan's definition 8: α = β = 1/3."""
    return [float(q) for q in mquantiles(values, [0.05, 0.5, 0.95], 1 / 3, 1 / 3)]


def test_scatter_of_samples() -> None:
    study = scatter()
    axes = study_scatter(study, over="diametral_clearance")
    points = axes.lines[0]
    np.testing.assert_allclose(points.get_xdata(), study.diametral_clearance.values * 1e6)
    np.testing.assert_allclose(points.get_ydata()[4:], study.max_inner_load.values[4:])
    assert np.isnan(points.get_ydata()[:4]).all()
    assert axes.get_xlabel() == "Diametral clearance (µm)"
    assert study_scatter(study).get_xlabel() == axes.get_xlabel()


def test_equal_samples_have_a_histogram() -> None:
    study = scatter(20).drop_vars("status")
    study["max_inner_load"][:] = 5.0
    axes = study_histogram(study)
    assert sum(shares(axes)) == pytest.approx(100.0)


@pytest.mark.parametrize("draw", [study_histogram, study_scatter])
def test_samples_are_needed(draw: Any) -> None:
    with pytest.raises(InputError, match="varies along the samples alone; x varies along fx"):
        draw(sweep(), "x")


def test_scatter_refuses_what_is_no_input() -> None:
    with pytest.raises(InputError, match="did you mean diametral_clearance"):
        study_scatter(scatter(), over="diametral_clearence")
    with pytest.raises(InputError, match="names no input"):
        study_scatter(scatter().drop_vars("diametral_clearance"))


# --- all ------------------------------------------------------------------------------------


@pytest.mark.parametrize("draw", [study_lines, study_map])
def test_a_study_without_any_result_is_an_empty_frame(draw: Any) -> None:
    study = sweep(8, 3)
    study["status"][:] = 1
    axes = draw(study, "x")
    assert not axes.lines
    assert "No result: there is no equilibrium" in texts(axes)
    assert not has_result(study, "x")


@pytest.mark.parametrize("draw", [study_histogram, study_scatter])
def test_samples_without_any_result_are_an_empty_frame(draw: Any) -> None:
    study = scatter()
    study["status"][:] = 2
    assert "overloaded" in texts(draw(study))
    with speaking("pt"):
        assert "sobrecarga" in texts(draw(study))


def test_not_a_number_counts_without_a_status() -> None:
    study = sweep().drop_vars("status").isel(inner_speed=[0])
    study["x"][2] = np.nan
    axes = study_lines(study, "x")
    assert labels(axes) == ["no result: 1 of 6"]
    study["x"][:] = np.nan
    assert texts(study_lines(study, "x")) == "No case has this number"


def test_outputs_are_numbers() -> None:
    study = sweep().assign(remark=(("fx",), ["a"] * 6))
    assert outputs(study) == ["x", "max_inner_max_pressure", "inner_load"]
    assert most_telling(study) == "max_inner_max_pressure"
    with pytest.raises(InputError, match="no output"):
        most_telling(study[["status"]])


def test_huge_studies_are_refused() -> None:
    study = xr.Dataset({"x": (("fx", "fz"), np.zeros((2001, 2000)), {"units": "m"})})
    with pytest.raises(InputError, match="too large for a figure"):
        study_map(study)


def test_an_axis_that_is_not_a_number_is_refused() -> None:
    study = sweep().assign_coords(fx=("fx", [np.nan, 1.0, 2.0, 3.0, 4.0, 5.0]))
    with pytest.raises(InputError, match="fx: contains something that is not a number"):
        study_lines(study, "x")


def test_portuguese_studies(tmp_path: Path) -> None:
    with speaking("pt"):
        axes = study_lines(sweep(failed=((1, 1),)), "x")
        samples = study_histogram(scatter())
        scattered = study_scatter(scatter())
        matrix = study_lines(sweep().rename(x="stiffness_xry"), "stiffness_xry")
    assert axes.get_xlabel() == "Carga axial Fx (kN)"
    assert axes.get_ylabel() == "Deslocamento axial x (µm)"
    assert axes.get_legend().get_title().get_text() == "Rotação do anel interno (rpm)"
    assert "sem resultado: 1 de 18" in labels(axes)
    assert samples.get_ylabel() == "Parcela das amostras (%)"
    assert scattered.get_xlabel() == "Folga diametral (µm)"
    assert matrix.get_ylabel() == "Rigidez x–ry (µm)"  # the unit is what the file says


@pytest.mark.parametrize("name", ["map.png", "map.svg", "map.pdf"])
@pytest.mark.thirds
def test_maps_are_saved_alike(name: str, tmp_path: Path) -> None:
    contents = []
    for attempt in ("a", "b"):
        (tmp_path / attempt).mkdir()
        save_figure(study_map(sweep(8, 9, failed=((0, 0),)), "x"), tmp_path / attempt / name)
        contents.append((tmp_path / attempt / name).read_bytes())
    assert contents[0] == contents[1]


def test_hostile_names_are_not_mathematics(tmp_path: Path) -> None:
    study = sweep().isel(inner_speed=[0])
    study["x"].attrs.update(long_name="$\\frac{1}$\n" + "y" * 500, units="$^$" * 50)
    study["fx"].attrs.update(long_name="$_$")
    axes = study_lines(study, "x")
    save_figure(axes, tmp_path / "hostile.svg")
    assert len(axes.get_ylabel()) <= 90


def test_colours_grow_lighter(tmp_path: Path) -> None:
    """In black and white, more is lighter."""
    mesh = mesh_of(study_map(sweep(8, 9), "x"))
    bounds = mesh.norm.boundaries
    middles = 0.5 * (bounds[1:] + bounds[:-1])
    colours = np.array([to_rgba(c) for c in mesh.cmap(mesh.norm(middles))])
    lightness = colours[:, :3] @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(lightness) > 0.0).all()


def test_a_temperature_is_read_in_the_scale_it_was_given_in() -> None:
    """In °C; a difference, which is given in K, stays as it is."""
    study = sweep(loads=2, speeds=1)
    study["fx"].attrs = {"units": "K", "given_in": "degC"}
    study = study.assign_coords(fx=("fx", [343.15, 383.15], study["fx"].attrs))
    shown = axis_of(study, "fx", 2)
    assert shown.values.tolist() == [70.0, 110.0]
    assert shown.axis.title.endswith("(°C)")
    del study["fx"].attrs["given_in"]
    assert axis_of(study, "fx", 2).values.tolist() == [343.15, 383.15]
