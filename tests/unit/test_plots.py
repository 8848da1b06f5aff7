"""Figures of states and curves: the data are those of the state, the axes have units."""

from __future__ import annotations

import dataclasses
import json
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure

import rolamento as ro
from rolamento import plots
from rolamento.charts.axes_units import readable_unit
from rolamento.charts.frame import PlainNumbers, add_title, figure_of
from rolamento.charts.texts import number
from rolamento.errors import FileError, InputError
from rolamento.plots.balls import ball_loads, contact_angles, load_rosette, pressures
from rolamento.plots.curves import (
    contact_angle_over_speed,
    load_displacement,
    stiffness_over_speed,
)
from rolamento.plots.ellipses import SCALE_BAR, contact_ellipses, ellipses_of_both_races
from rolamento.plots.saving import save_figure
from rolamento.plots.study import variable_label
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.words import speaking

OF_STATES: tuple[Callable[..., Axes], ...] = (
    ball_loads,
    contact_angles,
    pressures,
    load_rosette,
    contact_ellipses,
)


@pytest.fixture(scope="module")
def state(case_218: ro.Case) -> Solved:
    return solve(case_218)


@pytest.fixture(scope="module")
def unsolved(case_218: ro.Case) -> Solved:
    """Nothing supports the inner ring toward -x."""
    return solve(ro.override(case_218, ["duty.load.fx=-20 kN"]))


@pytest.fixture(scope="module")
def radial(examples: Path) -> Solved:
    """Some balls bear nothing."""
    return solve(ro.load_case(examples / "209_radial.toml"))


@pytest.fixture
def two_rows(state: Solved) -> Solved:
    """The row of the 218, and beside it one that bears half as much the other way."""
    mapping: dict[str, Any] = json.loads(state.to_json())
    beside = json.loads(json.dumps(mapping["balls"]))
    for ball in beside:
        ball["row"] = 1
        for race in ("inner", "outer"):
            ball[race]["load"] *= 0.5
            ball[race]["contact_angle"] *= -1.0
    mapping["balls"] += beside
    mapping["rows"].append({**mapping["rows"][0], "row": 1, "orientation": "-"})
    mapping["case"] = state.case.replace(
        bearing=state.case.bearing.replace(arrangement="DB", spacing="24 mm")
    ).to_mapping()
    return Solved.from_mapping(mapping)


def axes_for(draw: Callable[..., Axes]) -> Axes:
    projection = "polar" if draw is load_rosette else None
    return Figure().add_subplot(projection=projection)


def drawn(axes: Axes, index: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a line's points within one turn."""
    x, y = axes.lines[index].get_data()
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    turn = (x >= 0.0) & (x < 360.0)
    return x[turn], y[turn]


def labels(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def texts(axes: Axes) -> str:
    return " ".join(text.get_text() for text in axes.texts).replace("\n", " ")


# --- states ---------------------------------------------------------------------------------


@pytest.mark.parametrize("draw", OF_STATES)
def test_axes_given_are_returned(draw: Callable[..., Axes], state: Solved) -> None:
    axes = axes_for(draw)
    assert draw(state, axes) is axes
    assert draw(state) is not axes


@pytest.mark.parametrize(
    ("draw", "quantity", "factor", "unit"),
    [
        (ball_loads, "load", 1.0, "(N)"),
        (contact_angles, "contact_angle", 180.0 / np.pi, "(°)"),
        (pressures, "max_pressure", 1e-6, "(MPa)"),
    ],
)
def test_lines_over_azimuth_hold_the_data_of_the_state(
    draw: Callable[..., Axes], quantity: str, factor: float, unit: str, state: Solved
) -> None:
    axes = draw(state)
    for index, race in enumerate(("inner", "outer")):
        azimuth, values = drawn(axes, index)
        np.testing.assert_allclose(azimuth, np.degrees(state.elements.azimuth[0]))
        expected = factor * getattr(getattr(state, race), quantity)[0]
        np.testing.assert_allclose(values, expected)
    assert labels(axes)[:2] == ["inner", "outer"]
    assert axes.get_ylabel().endswith(unit)
    assert axes.get_xlabel().endswith("(°)")


def test_the_first_ball_comes_again_after_a_turn(state: Solved) -> None:
    x, y = ball_loads(state).lines[0].get_data()
    again = np.isclose(x, 360.0)
    assert y[again] == pytest.approx(state.inner.load[0, 0])


def test_azimuths_below_zero_are_put_in_order(case_218: ro.Case) -> None:
    turned = solve(ro.override(case_218, ["duty.first_ball_azimuth=-100 deg"]))
    azimuth, load = drawn(ball_loads(turned), 0)
    assert (np.diff(azimuth) > 0.0).all()
    assert azimuth.size == len(turned.elements.row)
    first = int(np.argmin(np.abs(azimuth - 260.0)))
    assert load[first] == pytest.approx(turned.inner.load[0, 0])


def test_a_ball_without_contact_has_a_load_of_zero_and_no_angle(radial: Solved) -> None:
    free = radial.inner.load[0] == 0.0
    assert free.any()
    assert (drawn(ball_loads(radial), 0)[1][free] == 0.0).all()
    assert np.isnan(drawn(contact_angles(radial), 0)[1][free]).all()
    assert np.isnan(drawn(pressures(radial), 0)[1][free]).all()


def test_free_contact_angle_is_drawn_where_it_is_given(state: Solved, radial: Solved) -> None:
    assert contact_angles(state).lines[-1].get_ydata()[0] == pytest.approx(40.0)
    assert "free (unloaded)" in labels(contact_angles(state))
    assert "free (unloaded)" not in labels(contact_angles(radial))


def test_races_differ_by_more_than_colour(state: Solved) -> None:
    inner, outer = ball_loads(state).lines
    assert inner.get_linestyle() != outer.get_linestyle()
    assert inner.get_marker() != outer.get_marker()


def test_rows_are_drawn_apart(two_rows: Solved) -> None:
    axes = ball_loads(two_rows)
    assert labels(axes) == ["inner, row 0", "outer, row 0", "inner, row 1", "outer, row 1"]
    np.testing.assert_allclose(drawn(axes, 2)[1], 0.5 * drawn(axes, 0)[1])
    looks = {(line.get_linestyle(), line.get_marker()) for line in axes.lines}
    assert len(looks) == 4
    assert (drawn(contact_angles(two_rows), 2)[1] < 0.0).all()
    assert len(load_rosette(two_rows).lines) == 4


@pytest.mark.parametrize("draw", OF_STATES)
def test_a_state_without_a_result_is_an_empty_frame_that_says_why(
    draw: Callable[..., Axes], unsolved: Solved
) -> None:
    axes = axes_for(draw)
    assert draw(unsolved, axes) is axes
    assert not axes.lines
    assert "No result: there is no equilibrium" in texts(axes)
    with speaking("pt"):
        assert "Sem resultado: não há equilíbrio" in texts(draw(unsolved))


def test_both_races_without_a_result(unsolved: Solved) -> None:
    for axes in ellipses_of_both_races(unsolved):
        assert "no equilibrium" in texts(axes)


# --- rosette --------------------------------------------------------------------------------


def test_rosette_looks_from_plus_x(state: Solved) -> None:
    axes = load_rosette(state)
    assert axes.get_theta_offset() == pytest.approx(np.pi / 2)  # 0 at the top
    assert axes.get_theta_direction() == -1  # clockwise, over +y on the right
    names = [label.get_text() for label in axes.get_xticklabels()]
    assert names[0] == "0°, +z"
    assert names[2] == "90°\n+y"
    assert axes.get_xlabel() == "Contact load (N), seen from +x"


def test_rosette_holds_closed_loads(state: Solved) -> None:
    axes = load_rosette(state)
    for line, race in zip(axes.lines, ("inner", "outer"), strict=True):
        loads = getattr(state, race).load[0]
        np.testing.assert_allclose(line.get_ydata(), [*loads, loads[0]])
        azimuths = state.elements.azimuth[0]
        np.testing.assert_allclose(line.get_xdata(), [*azimuths, azimuths[0]])


def test_rosette_numbers_stand_away_from_the_loads(state: Solved) -> None:
    axes = load_rosette(state)
    position = np.radians(axes.get_rlabel_position())
    assert np.cos(position) < 0.0  # the load is toward +z
    assert any(label.get_text() for label in axes.get_yticklabels())


def test_rosette_refuses_axes_that_are_not_polar(state: Solved) -> None:
    with pytest.raises(InputError, match="must be polar"):
        load_rosette(state, Figure().add_subplot())


def test_many_newtons_are_kilonewtons(case_218: ro.Case) -> None:
    heavy = solve(ro.override(case_218, ["duty.load.fx=200 kN"]))
    axes = ball_loads(heavy)
    assert axes.get_ylabel() == "Contact load (kN)"
    np.testing.assert_allclose(drawn(axes, 0)[1], heavy.inner.load[0] / 1e3)


# --- ellipses -------------------------------------------------------------------------------


def ellipse_collections(axes: Axes) -> list[EllipseCollection]:
    return [c for c in axes.collections if isinstance(c, EllipseCollection)]


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_ellipses_are_to_scale_and_in_place(race: str, state: Solved) -> None:
    axes = contact_ellipses(state, race=race)
    (ellipses,) = ellipse_collections(axes)
    contacts = getattr(state, race)
    np.testing.assert_allclose(ellipses.get_heights(), 2e3 * contacts.semi_major[0])
    np.testing.assert_allclose(ellipses.get_widths(), 2e3 * contacts.semi_minor[0])
    radius = 0.5232 * 22.23
    across = np.asarray(ellipses.get_offsets())[:, 1]
    np.testing.assert_allclose(across, radius * contacts.contact_angle[0])
    assert axes.get_aspect() == 1.0
    assert axes.get_ylabel() == f"Across {race} groove (mm)"
    assert "(°)" in axes.get_xlabel()


def test_ellipses_of_chosen_balls(state: Solved) -> None:
    axes = contact_ellipses(state, balls=[0, 3])
    (ellipses,) = ellipse_collections(axes)
    heights = 2e3 * state.inner.semi_major[0, [0, 3]]
    np.testing.assert_allclose(ellipses.get_heights(), heights)
    assert [label.get_text() for label in axes.get_xticklabels()] == ["0", "67.5"]


@pytest.mark.parametrize("balls", [[16], [-1], []])
def test_ellipses_refuse_balls_that_are_not_there(balls: list[int], state: Solved) -> None:
    with pytest.raises(InputError, match="balls"):
        contact_ellipses(state, balls=balls)


def test_scale_bar_is_as_long_as_it_says(state: Solved) -> None:
    axes = contact_ellipses(state)
    (bar,) = [line for line in axes.lines if line.get_gid() == SCALE_BAR]
    length = float(np.ptp(bar.get_xdata()))
    assert f"{length:g} mm" in texts(axes)
    assert length > 0.0


def test_edges_of_the_groove_and_ellipses_over_them(state: Solved) -> None:
    bearing = state.case.bearing.replace(inner_shoulder_height="4.5 mm")
    shouldered = dataclasses.replace(state, case=state.case.replace(bearing=bearing))
    axes = contact_ellipses(shouldered)
    radius = 0.5232 * 22.23
    edge = radius * np.arccos(1.0 - 4.5 / radius)
    drawn = np.concatenate([line.get_ydata() for line in axes.lines if not line.get_gid()])
    heights = sorted(set(drawn[np.isfinite(drawn)].tolist()))
    assert heights == pytest.approx([-edge, 0.0, edge])
    reach = radius * np.abs(state.inner.contact_angle[0]) + 1e3 * state.inner.semi_major[0]
    over = int(np.sum(reach > edge))
    assert over > 0
    hatched = [c for c in ellipse_collections(axes) if c.get_hatch()]
    assert sum(len(c.get_offsets()) for c in hatched) == over
    assert "ellipse over the edge" in labels(axes)
    assert "edge of the groove" not in labels(contact_ellipses(state))


def test_a_ball_without_contact_has_no_ellipse(radial: Solved) -> None:
    (ellipses,) = ellipse_collections(contact_ellipses(radial))
    assert len(ellipses.get_offsets()) == np.sum(radial.inner.load > 0.0)


def test_both_races_are_drawn_to_one_scale(state: Solved) -> None:
    inner, outer = ellipses_of_both_races(state)
    assert inner.get_xlim() == outer.get_xlim()
    assert inner.get_ylim() == outer.get_ylim()


def test_rows_of_ellipses_stand_apart(two_rows: Solved) -> None:
    axes = contact_ellipses(two_rows)
    (ellipses,) = ellipse_collections(axes)
    along = np.sort(np.asarray(ellipses.get_offsets())[:, 0])
    steps = np.diff(along)
    assert np.argmax(steps) == 15
    assert steps.max() == pytest.approx(2.0 * steps.min())
    assert "row 1" in texts(axes)


@pytest.mark.parametrize("draw", OF_STATES)
def test_what_is_no_solved_case_is_refused(
    draw: Callable[..., Axes], state: Solved, case_218: ro.Case
) -> None:
    with pytest.raises(InputError, match=r"must be the result of rolamento\.solve"):
        draw(case_218)
    with pytest.raises(InputError, match="must be a single case"):
        draw(state[[0, 0]])
    with pytest.raises(InputError, match="axes"):
        draw(state, axes=3)


def test_the_package_offers_its_figures() -> None:
    for name in dir(plots):
        assert getattr(plots, name) is not None
    assert plots.load_rosette is load_rosette
    with pytest.raises(AttributeError, match="no attribute 'rosete'"):
        plots.rosete  # noqa: B018


# --- curves ---------------------------------------------------------------------------------


def test_load_over_displacement() -> None:
    axes = Figure().add_subplot()
    shift = np.linspace(0.0, 50e-6, 11)
    load = np.stack([1e9 * shift, 1.2e9 * shift])
    assert load_displacement(shift, load, axes, labels=["slow", "fast"]) is axes
    for line, row in zip(axes.lines, load, strict=True):
        np.testing.assert_allclose(line.get_xdata(), shift * 1e6)
        np.testing.assert_allclose(line.get_ydata(), row / 1e3)
    assert axes.get_xlabel() == "Axial displacement x (µm)"
    assert axes.get_ylabel() == "Axial load Fx (kN)"
    assert labels(axes) == ["slow", "fast"]
    assert load_displacement(shift, 1e9 * shift).get_legend() is None


def test_moment_over_tilt() -> None:
    axes = load_displacement([0.0, 1e-3], [0.0, 50.0], direction="ry")
    assert axes.get_xlabel() == "Tilt about y (mrad)"
    assert axes.get_ylabel() == "Moment My (N·m)"


@pytest.mark.parametrize(
    ("shift", "load", "keywords"),
    [
        ([0.0, 1.0], [0.0, 1.0, 2.0], {}),
        ([0.0, 1.0], [0.0, 1.0], {"direction": "q"}),
        ([0.0, 1.0], [0.0, 1.0], {"labels": ["a", "b"]}),
    ],
)
def test_load_displacement_refuses(shift: Any, load: Any, keywords: Any) -> None:
    with pytest.raises(InputError):
        load_displacement(shift, load, **keywords)


def test_stiffness_over_speed_from_matrices_and_from_columns() -> None:
    speed = np.linspace(0.0, 1000.0, 8)
    matrix = np.zeros((8, 5, 5))
    for j in range(5):
        matrix[:, j, j] = (j + 1) * 1e8
    matrix[3] = np.nan
    axes = stiffness_over_speed(speed, matrix, directions=("x", "z"))
    np.testing.assert_allclose(axes.lines[0].get_xdata(), speed * 30.0 / np.pi)
    np.testing.assert_allclose(axes.lines[1].get_ydata(), matrix[:, 2, 2] / 1e6)
    assert np.isnan(axes.lines[0].get_ydata()[3])
    assert axes.get_xlabel().endswith("(rpm)")
    assert axes.get_ylabel() == "Stiffness (N/µm)"
    columns = stiffness_over_speed(speed, matrix[:, [0, 2], [0, 2]], directions=("x", "z"))
    np.testing.assert_array_equal(columns.lines[1].get_ydata(), axes.lines[1].get_ydata())
    tilts = stiffness_over_speed(speed, matrix, directions=("ry", "rz"))
    assert tilts.get_ylabel() == "Stiffness (N·m/mrad)"


def test_stiffness_over_speed_refuses() -> None:
    speed = np.linspace(0.0, 1000.0, 3)
    with pytest.raises(InputError, match="different units"):
        stiffness_over_speed(speed, np.ones((3, 5, 5)), directions=("x", "ry"))
    with pytest.raises(InputError, match="3 speeds"):
        stiffness_over_speed(speed, np.ones((4, 5, 5)))


def test_contact_angle_over_speed() -> None:
    speed = np.linspace(0.0, 1000.0, 5)
    inner = np.radians([[40.0, 41.0, 45.0]] * 5)
    outer = np.radians([38.0, 37.0, np.nan, 35.0, 34.0])
    axes = contact_angle_over_speed(speed, inner, outer)
    np.testing.assert_allclose(axes.lines[0].get_ydata(), 41.0)
    np.testing.assert_allclose(axes.lines[1].get_ydata(), np.degrees(outer))
    (band,) = axes.collections
    heights = band.get_paths()[0].vertices[:, 1]
    assert heights.min() == pytest.approx(40.0)
    assert heights.max() == pytest.approx(45.0)
    assert axes.get_ylabel() == "Contact angle (°)"
    with pytest.raises(InputError, match="inner"):
        contact_angle_over_speed(speed, inner[:3], outer)


def test_curves_without_a_result_are_empty_frames() -> None:
    nothing = np.full(3, np.nan)
    for axes in (
        load_displacement(nothing, nothing),
        stiffness_over_speed(np.ones(3), np.full((3, 5, 5), np.nan)),
        contact_angle_over_speed(np.ones(3), nothing, nothing),
    ):
        assert not axes.lines
        assert "No result" in texts(axes)


def test_curves_of_a_batch(case_218: ro.Case) -> None:
    speed = np.array([100.0, 500.0])
    batch = solve(case_218, inner_speed=speed, threads=1)
    axes = stiffness_over_speed(speed, batch.stiffness.array)
    assert axes.lines[0].get_ydata() == pytest.approx(batch.stiffness["fx", "x"] / 1e6)
    angles = contact_angle_over_speed(speed, batch.inner.contact_angle, batch.outer.contact_angle)
    median = np.degrees(np.median(batch.inner.contact_angle, axis=1))
    assert angles.lines[0].get_ydata() == pytest.approx(median)


# --- units, numbers, words ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "greatest", "symbol", "value"),
    [
        ("N", 9000.0, "N", 9000.0),
        ("N", 20e3, "kN", 20.0),
        ("m", 30e-6, "µm", 30.0),
        ("m", 0.02, "mm", 20.0),
        ("rad", 2e-4, "mrad", 0.2),
        ("rad", np.pi / 4, "°", 45.0),
        ("rad/s", 1000.0 * np.pi / 30.0, "rpm", 1000.0),
        ("Pa", 2e9, "MPa", 2000.0),
        ("Pa", 208e9, "GPa", 208.0),
        ("N/m", 5e8, "N/µm", 500.0),
        ("N*m", 0.05, "N·mm", 50.0),
        ("N m", 50.0, "N·m", 50.0),
        ("N·m", 2e4, "kN·m", 20.0),
        ("N*m/rad", 3e5, "N·m/mrad", 300.0),
        ("1", 0.52, "–", 0.52),
        ("kg/m^3", 7800.0, "kg/m³", 7800.0),
        ("furlong", 3.0, "furlong", 3.0),
    ],
)
def test_readable_units(unit: str, greatest: float, symbol: str, value: float) -> None:
    readable = readable_unit(unit, [np.nan, -greatest, 0.0])
    assert readable.symbol == symbol
    assert readable.of(greatest) == pytest.approx(value)


def test_units_of_nothing() -> None:
    assert readable_unit("N", []).symbol == "N"
    assert readable_unit("m", [np.nan]).symbol == "µm"


def test_numbers_have_the_mark_of_the_language() -> None:
    axes = Figure().add_subplot()
    axes.set_xlim(0.0, 1.0)
    with speaking("pt"):
        axes.xaxis.set_major_formatter(PlainNumbers())
    axes.figure.draw_without_rendering()
    assert "0,2" in [label.get_text() for label in axes.get_xticklabels()]
    assert number(12345.6) == "12\u2009346"
    with speaking("pt"):
        assert number(-0.25) == "−0,25"


def test_portuguese_labels(state: Solved) -> None:
    with speaking("pt"):
        axes = ball_loads(state)
        inner, outer = ellipses_of_both_races(state)
        rosette = load_rosette(state)
        stiffness = stiffness_over_speed([0.0, 1.0], np.ones((2, 5, 5)))
    assert axes.get_ylabel() == "Carga no contato (N)"
    assert axes.get_xlabel() == "Azimute da esfera (°)"
    assert labels(axes) == ["interna", "externa"]
    assert inner.get_ylabel() == "Através da pista interna (mm)"
    assert "esferas lado a lado" in outer.get_xlabel()
    assert rosette.get_xlabel() == "Carga no contato (N), visto de +x"
    assert stiffness.get_ylabel() == "Rigidez (N/µm)"


@pytest.mark.parametrize(
    ("variable", "english", "portuguese"),
    [
        ("fx", "Axial load Fx", "Carga axial Fx"),
        ("stiffness_zry", "Stiffness z–ry", "Rigidez z–ry"),
        ("inner_load", "Contact load, inner race", "Carga no contato, pista interna"),
        ("max_orbital_speed", "Maximum orbital speed", "Rotação orbital (máx.)"),
        (
            "max_inner_max_pressure",
            "Maximum contact pressure, inner race",
            "Pressão de contato, pista interna (máx.)",
        ),
        (
            "mean_outer_contact_angle",
            "Mean contact angle, outer race, loaded balls",
            "Ângulo de contato, pista externa, esferas carregadas (média)",
        ),
        ("contact_angle", "Free contact angle", "Ângulo de contato livre"),
        ("youngs_modulus", "What the file says", "What the file says"),
    ],
)
def test_names_of_variables(variable: str, english: str, portuguese: str) -> None:
    assert variable_label(variable, {"long_name": "what the file says"}) == english
    with speaking("pt"):
        assert variable_label(variable, {"long_name": "what the file says"}) == portuguese


def test_names_of_unknown_variables_without_a_long_name() -> None:
    assert variable_label("youngs_modulus") == "Youngs modulus"
    density = {"field": "bearing.ball_material.density"}
    assert variable_label("density", density) == "Density ρ (balls)"


# --- saving ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ending", "begin"),
    [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF"), ("PNG", b"\x89")],
)
@pytest.mark.thirds
def test_saving_gives_the_same_bytes_again(
    ending: str, begin: bytes, state: Solved, tmp_path: Path
) -> None:
    contents = []
    for attempt in range(2):
        path = tmp_path / f"{attempt}.{ending}"
        save_figure(ball_loads(state), path)
        contents.append(path.read_bytes())
    assert contents[0] == contents[1]
    assert contents[0].startswith(begin)
    for word in (b"CreationDate", b"dc:date", b"Matplotlib v"):
        assert word not in contents[0]


@pytest.mark.parametrize("name", ["figure", "figure.jpg", "figure.png.txt", ""])
def test_saving_refuses_other_formats(name: str, state: Solved, tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"must end in \.png, \.svg or \.pdf"):
        save_figure(ball_loads(state), tmp_path / name if name else "")


def test_saving_tells_where_it_cannot_write(state: Solved, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be written: no such file"):
        save_figure(ball_loads(state), tmp_path / "nowhere" / "figure.png")


@pytest.mark.parametrize("title", [r"price $5 and \frac{1}", "漢字 bearing", "\x07" * 9, "x" * 999])
def test_any_title_can_be_drawn(title: str, state: Solved, tmp_path: Path) -> None:
    axes = ball_loads(state)
    add_title(figure_of(axes), title)
    save_figure(axes, tmp_path / "titled.png")
    assert (tmp_path / "titled.png").stat().st_size > 1000


def test_nothing_is_global_and_no_display_is_asked_for(tmp_path: Path) -> None:
    """Neither is pyplot imported nor are the settings of the program changed."""
    script = (
        "import matplotlib, sys\n"
        # Only to look at the backend chooses one.
        "def settings():\n"
        "    return {k: matplotlib.rcParams[k] for k in matplotlib.rcParams if k != 'backend'}\n"
        "before = settings()\n"
        "from rolamento.plots import balls, curves, ellipses, saving, study, sweep\n"
        "axes = curves.load_displacement([0.0, 1e-6], [0.0, 100.0])\n"
        "saving.save_figure(axes, sys.argv[1])\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
        "assert 'xarray' not in sys.modules\n"
        "assert settings() == before\n"
    )
    target = tmp_path / "curve.png"
    subprocess.run([sys.executable, "-W", "error", "-c", script, str(target)], check=True)
    assert target.exists()


GUIDE = Path(__file__).resolve().parents[2] / "docs" / "plots.md"


@pytest.mark.parametrize(
    "block", re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
)
def test_examples_of_the_guide_run(
    block: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(examples / "218_combined.toml", tmp_path / "case.toml")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})
    drawn_files = {path.suffix for path in tmp_path.iterdir()} - {".toml"}
    assert drawn_files <= {".png", ".svg", ".pdf"}
    assert drawn_files


def test_pictures_of_the_guide_are_there() -> None:
    pictures = re.findall(r"!\[[^]]*\]\(([^)]+)\)", GUIDE.read_text("utf-8"))
    assert len(pictures) == 10
    assert all((GUIDE.parent / picture).is_file() for picture in pictures)


# --- reading --------------------------------------------------------------------------------


def test_a_state_read_back_draws_the_same(state: Solved, tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    path.write_text(state.to_json(), encoding="utf-8")
    read = Solved.read(path)
    assert read.title == state.title
    for draw in (ball_loads, contact_angles, pressures, load_rosette):
        for mine, theirs in zip(draw(read).lines, draw(state).lines, strict=False):
            np.testing.assert_array_equal(mine.get_xydata(), theirs.get_xydata())


def test_a_state_read_back_with_its_case_draws_ellipses(state: Solved) -> None:
    read = Solved.from_json(state.to_json())
    (mine,), (theirs,) = (ellipse_collections(contact_ellipses(s)) for s in (read, state))
    np.testing.assert_allclose(mine.get_offsets(), theirs.get_offsets())


def test_null_is_not_a_number(unsolved: Solved) -> None:
    read = Solved.from_mapping(json.loads(unsolved.to_json()))
    assert np.isnan(read.inner.load).all()
    assert not read.converged.any()


def spoilt(state: Solved, change: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
    mapping: dict[str, Any] = json.loads(state.to_json())
    change(mapping)
    return mapping


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda m: m.pop("schema"), "is not the JSON of a solved state"),
        (lambda m: m.pop("balls"), "is not the JSON of a solved state"),
        (lambda m: m.update(schema=4), "schema = 4: is of another release"),
        (lambda m: m.update(schema=True), "is of another release"),
        (lambda m: m.update(balls=[]), "balls = a list: must be a list of at least 1"),
        (lambda m: m.update(balls=7), "balls = 7: must be a list"),
        (lambda m: m.pop("status"), "status: is missing"),
        (lambda m: m["status"].pop("code"), r"status\.code: is missing"),
        (lambda m: m["status"].update(code=3), r"status\.code = 3: must be text"),
        (lambda m: m["status"].update(converged=1), r"status\.converged = 1: must be true"),
        (lambda m: m["balls"].__setitem__(2, 5), r"balls\.2 = 5: must be a table"),
        (lambda m: m["balls"][3].pop("azimuth"), r"balls\.3\.azimuth: is missing"),
        (lambda m: m["balls"][3].pop("outer"), r"balls\.3\.outer: is missing"),
        (lambda m: m["balls"][3].update(row=-1), r"balls\.3\.row = -1"),
        (lambda m: m["balls"][3].update(row=0.5), r"balls\.3\.row = 0\.5"),
        (lambda m: m["balls"][1]["inner"].pop("load"), r"balls\.1\.inner\.load: is missing"),
        (lambda m: m["balls"][1]["inner"].update(load="9"), "must be a number or null"),
        (lambda m: m["balls"][1]["inner"].update(load=True), "must be a number or null"),
        (lambda m: m["balls"][1]["inner"].update(load=10**400), "must be within"),
        (lambda m: m["balls"][1]["inner"].update(load=float("inf")), "must be within"),
        (lambda m: m["balls"][1]["inner"].update(load=-1.0), "must not be negative"),
        (lambda m: m.update(case=3), "case = 3: must be a table"),
        (lambda m: m.update(case={"bearing": {}}), r"case\."),
    ],
)
def test_spoilt_states_are_refused(
    change: Callable[[dict[str, Any]], object], message: str, state: Solved
) -> None:
    with pytest.raises(InputError, match=message):
        Solved.from_mapping(spoilt(state, change))


def test_a_case_file_is_told_to_be_solved_first(examples: Path) -> None:
    with pytest.raises(
        FileError, match="is not the JSON of a solved state; solve a case first"
    ) as refused:
        Solved.read(examples / "218_combined.toml")
    assert "218_combined.toml" in str(refused.value)
    assert "rolamento solve" in str(refused.value)
