"""Pictures of a machine: everything is drawn, at its place, inside the frame."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, PathPatch, Polygon, Rectangle
from typer.testing import CliRunner

import rolamento as ro
from rolamento.case.machine import Machine
from rolamento.charts.frame import figure_of
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.plots import (
    campbell_figure,
    draw_bearings_in_place,
    draw_deflection,
    draw_machine,
    draw_section_forces,
    machine_figure,
    modes_figure,
)
from rolamento.plots.machine_drawing import levels
from rolamento.rotors import campbell, natural_modes
from rolamento.solved.machine import SolvedMachine
from rolamento.words import speaking

mpl.use("Agg")

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"
PARALLEL = """
[[shafts]]
name = "input"
speed = "1000 rpm"
sections = [
    { length = "300 mm", diameter = "50 mm" },
    { length = "100 mm", diameter = "50 mm", end_diameter = "30 mm" },
]
[[shafts]]
name = "output"
ratio = -0.5
of = "input"
sections = [{ length = "400 mm", diameter = "50 mm" }]
[[bearings]]
name = "spherical"
shaft = "input"
position = "30 mm"
designation = "22210"
[[bearings]]
name = "four-point"
shaft = "input"
position = "280 mm"
designation = "QJ210"
[[bearings]]
name = "one way"
shaft = "output"
position = "30 mm"
designation = "6210"
located = "+x"
[[bearings]]
name = "other way"
shaft = "output"
position = "370 mm"
designation = "6210"
located = "-x"
[[gears]]
name = "pinion"
shaft = "input"
position = "150 mm"
pitch_diameter = "80 mm"
torque = "50 N m"
drives = true
mesh_azimuth = "180 deg"
[[gears]]
name = "wheel"
shaft = "output"
position = "150 mm"
pitch_diameter = "160 mm"
mate = "pinion"
[[belts]]
name = "chain"
shaft = "input"
position = "380 mm"
diameter = "100 mm"
tight = "800 N"
slack = "200 N"
azimuth = "0 deg"
drives = false
[[masses]]
name = "flywheel"
shaft = "output"
position = "250 mm"
mass = "12 kg"
[[springs]]
name = "support"
shaft = "output"
position = "300 mm"
stiffness = ["0 N/um", "1 N/um", "1 N/um"]
[[loads]]
name = "coupling"
shaft = "output"
position = "400 mm"
fx = "200 N"
fz = "-100 N"
[[loads]]
name = "beside"
shaft = "output"
position = "395 mm"
fy = "-300 N"
"""
"""Two parallel shafts with what no example has."""


@pytest.fixture(scope="module")
def solved() -> SolvedMachine:
    """A spectrum of three steps."""
    return ro.shaft(EXAMPLES / "gear_shaft.toml")


@pytest.fixture(scope="module")
def parallel() -> SolvedMachine:
    """Solved."""
    return ro.shaft(Machine.from_toml(PARALLEL))


def clear(axes: Axes) -> None:
    """Check that texts are within the figure, and that none covers another."""
    figure = figure_of(axes)
    figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in axes.texts if text.get_text()]
    for index, box in enumerate(boxes):
        assert figure.bbox.x0 <= box.x0 < box.x1 <= figure.bbox.x1
        assert axes.bbox.y0 - 1.0 <= box.y0 < box.y1 <= figure.bbox.y1
        for other in boxes[:index]:
            assert not box.overlaps(other)


def labelled(axes: Axes) -> dict[str, list[str]]:
    """What is written beside a machine: first lines, and what stands below them."""
    texts = [text.get_text().split("\n") for text in axes.texts if text.get_text()]
    return {lines[0]: lines[1:] for lines in texts}


def pressure_centres(axes: Axes) -> list[float]:
    return sorted(
        float(np.asarray(line.get_xdata())[0])
        for line in axes.lines
        if line.get_marker() == "o" and line.get_markersize() == 2.5
    )


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_every_example_is_drawn(path: Path) -> None:
    """Sections above and below the axis; a ball or roller for each row, twice; loads with text."""
    solved = ro.shaft(path)
    figure = machine_figure(solved)
    figure.draw_without_rendering()
    drawing, *lower = figure.axes[:5]
    machine = solved.machine
    sections = sum(len(shaft.sections) for shaft in machine.shafts)
    assert sum(isinstance(p, Polygon) for p in drawing.patches) == 2 * sections
    rows = [place for one in machine.bearings for place in one.case.bearing.element_rows]
    balls = sum(place.bearing.element == "ball" for place in rows)
    assert sum(isinstance(p, Ellipse) for p in drawing.patches) == 2 * balls
    rings = [p for p in drawing.patches if isinstance(p, Rectangle)]
    assert len(rings) >= 4 * len(rows)
    names = {text.get_text().split("\n")[0] for text in drawing.texts}
    assert {one.name for one in machine.bearings} <= names
    assert len({axes.get_xlim() for axes in lower}) == 1


def test_the_line_of_deflection_is_the_result() -> None:
    """In µm, over the machine's x in mm; of the step that is asked for."""
    solved = ro.shaft(EXAMPLES / "gear_shaft.toml")
    figure = machine_figure(solved, step=2)
    one = solved.shafts["output shaft"]
    lines = {line.get_label(): line for line in figure.axes[1].lines}
    np.testing.assert_allclose(lines["z"].get_ydata(), 1e6 * one.displacement[2, :, 2])
    np.testing.assert_allclose(lines["z"].get_xdata(), 1e3 * one.position)
    moments, forces = (figure.axes[panel].lines[0].get_ydata() for panel in (2, 3))
    np.testing.assert_allclose(moments, one.bending_moment[2].ravel())
    np.testing.assert_allclose(forces, one.shear_force[2].ravel())


def test_without_equilibrium_the_machine_is_drawn_all_the_same() -> None:
    """And the panels below say why they are empty."""
    machine = ro.load_machine(EXAMPLES / "gear_shaft.toml", ["bearings.locating.designation=NU308"])
    figure = machine_figure(ro.shaft(machine))
    assert [axes.texts[0].get_text() for axes in figure.axes[1:]] == ["no equilibrium"] * 4


def test_vibration_is_drawn() -> None:
    """A line a branch, a point a critical speed, a panel a mode."""
    motor = EXAMPLES / "motor.toml"
    found = campbell(motor, np.linspace(50.0, 3000.0, 8), count=5, orders=(1.0, 2.0))
    axes = campbell_figure(found).axes[0]
    (points,) = [line for line in axes.lines if line.get_linestyle() == "None"]
    assert len(np.asarray(points.get_xdata())) == len(found.critical) > 0
    figure = modes_figure(natural_modes(motor, count=6), count=3)
    assert len(figure.axes) == 3
    assert "Hz" in figure.axes[0].get_ylabel()


def test_the_command_draws(tmp_path: Path) -> None:
    """One step of the spectrum, by its number."""
    path = tmp_path / "machine.svg"
    arguments = ["shaft", str(EXAMPLES / "gear_shaft.toml"), "--plot", str(path), "--step", "3"]
    assert CliRunner().invoke(app, arguments).exit_code == 0
    assert path.stat().st_size > 10_000
    for kind in ("drawing", "deflection", "forces", "bearings"):
        own = tmp_path / f"{kind}.png"
        command = [*arguments[:3], str(own), "--kind", kind]
        assert CliRunner().invoke(app, command).exit_code == 0
        assert own.stat().st_size > 10_000
    wrong = CliRunner().invoke(app, [*arguments[:-1], "9"])
    assert wrong.exit_code == 2


# --- the machine to scale -------------------------------------------------------------------------


@pytest.mark.parametrize("language", ["en", "pt"])
@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_no_text_covers_another(path: Path, language: str) -> None:
    """Beside the drawing, over deflections, above shear forces."""
    solved = ro.shaft(path)
    with speaking(language):
        clear(draw_machine(solved))
        clear(draw_deflection(solved))
        clear(draw_section_forces(solved).axes[0])
        whole = machine_figure(solved)
        clear(whole.axes[0])
        clear(whole.axes[1])


def test_texts_are_staggered() -> None:
    """As far as is needed, and no further."""
    assert levels([(0.0, 10.0), (20.0, 10.0), (8.0, 8.0), (8.5, 8.0)]) == [0, 0, 1, 2]
    assert levels([]) == []


def test_loads_have_their_values(solved: SolvedMachine) -> None:
    """Those of the step that is asked for, in N or kN."""
    machine = solved.machine
    for step in (0, 2):
        (force,) = machine.forces(machine.spectrum[step])
        lines = dict(
            line.split(" ", 1) for line in labelled(draw_machine(solved, step=step))["wheel"]
        )
        for name, value in zip(("Fx", "Fy", "Fz"), force.force[:3], strict=True):
            shown, unit = lines[name].replace("\u2212", "-").split()
            assert float(shown) * {"N": 1.0, "kN": 1e3}[unit] == pytest.approx(value, rel=5e-3)


def test_arrangements_can_be_seen() -> None:
    """Pressure centres are apart back to back, and close together face to face."""
    apart, close = (
        pressure_centres(draw_machine(ro.shaft(EXAMPLES / name)))
        for name in ("pinion.toml", "pinion_x.toml")
    )
    assert apart[0] < 60.0 < 140.0 < apart[1]
    assert 60.0 < close[0] < close[1] < 140.0
    pair = pressure_centres(draw_machine(ro.shaft(EXAMPLES / "spindle.toml")))
    assert pair[0] < 250.0 < 270.0 < pair[1]


def test_parallel_shafts_lie_one_below_the_other(parallel: SolvedMachine) -> None:
    """Coaxial ones about one axis; each name and load once."""
    axes = draw_machine(parallel)
    clear(axes)
    middles = {round(float(np.mean(p.get_xy()[:-1, 1])), 6) for p in axes.patches
               if isinstance(p, Polygon)}  # fmt: skip
    assert len(middles) > 2
    shown = labelled(axes)
    assert shown.keys() == {
        "spherical", "four-point", "one way", "other way", "pinion", "wheel", "chain", "coupling",
        "beside", "flywheel", "support",
    }  # fmt: skip
    assert shown["flywheel"] == ["12 kg"]
    assert shown["one way"] == ["6210"]
    assert any(isinstance(patch, PathPatch) for patch in axes.patches)  # barrels, gears, the pulley
    coaxial = draw_machine(ro.shaft(EXAMPLES / "coaxial.toml"))
    heights = [p.get_xy()[:, 1] for p in coaxial.patches if isinstance(p, Polygon)]
    assert {float(abs(y).max()) for y in heights} == {45.0, 20.0}


def test_a_ring_is_held_on_the_side_that_it_is_located(parallel: SolvedMachine) -> None:
    """By a shoulder: "+x" against motion toward +x."""
    axes = draw_machine(parallel)
    hatched = [p for p in axes.patches if isinstance(p, Rectangle) and p.get_hatch()]
    places = [p.get_x() + 0.5 * p.get_width() for p in hatched if p.get_width() < 8.0]
    own = [x for x in places if abs(x - 30.0) < 20.0]
    # the spherical one at the same x of the other shaft is held on both sides
    assert sum(x > 30.0 for x in own) == 4
    assert sum(x < 30.0 for x in own) == 2


def test_axes_of_others_are_drawn_on(solved: SolvedMachine) -> None:
    figure = Figure(figsize=(8.0, 5.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    assert draw_machine(solved, above) is above
    assert draw_deflection(solved, below, step=1) is below
    figure.draw_without_rendering()
    low, high = below.get_xlim()
    assert low < 0.0 < 270.0 < high


@pytest.mark.parametrize(
    "draw",
    [draw_machine, draw_deflection, draw_section_forces, draw_bearings_in_place, machine_figure],
)
def test_other_steps_and_things_are_refused(draw: Any, solved: SolvedMachine) -> None:
    with pytest.raises(InputError, match="step = 3: must be at least 0 and at most 2"):
        draw(solved, step=3)
    with pytest.raises(InputError, match="must be a SolvedMachine"):
        draw(solved.machine, step=0)


# --- along the axis -------------------------------------------------------------------------------


def test_deflections_of_all_steps(solved: SolvedMachine) -> None:
    """Three lines a step; slopes at bearings and gears, the greatest of the steps."""
    axes = draw_deflection(solved)
    shaft = solved.shafts["output shaft"]
    lines = [line for line in axes.lines if len(line.get_xdata()) == len(shaft.position)]  # type: ignore[arg-type]
    assert len(lines) == 9
    for step in range(3):
        np.testing.assert_allclose(lines[3 * step + 2].get_ydata(), 1e6 * shaft.deflection[step])
    slope = 1e3 * shaft.slope[:, np.abs(shaft.position - 0.175).argmin()].max()
    (text,) = [one.get_text() for one in axes.texts if one.get_text().startswith("locating")]
    assert float(text.split()[-2]) == pytest.approx(slope, rel=0.05)
    assert len(axes.texts) == 3


def test_too_many_lines_are_refused() -> None:
    machine = ro.load_machine(EXAMPLES / "coaxial.toml")
    steps = [{"share": 0.25, "load_factor": factor} for factor in (1.0, 0.9, 0.8, 0.7)]
    many = ro.shaft(machine.replace(spectrum=steps))
    with pytest.raises(InputError, match="would make 8 lines"):
        draw_deflection(many)
    draw_deflection(many, step=3)


def test_section_forces_are_the_results(solved: SolvedMachine) -> None:
    """Both sides of each node, so that the lines have steps."""
    figure = draw_section_forces(solved, step=1)
    shaft = solved.shafts["output shaft"]
    x = np.repeat(1e3 * shaft.position, 2)
    expected = [
        shaft.shear_force, shaft.bending_moment, shaft.force[..., 0], shaft.torque,
        1e-6 * shaft.stress,
    ]  # fmt: skip
    for axes, values, line in zip(figure.axes, expected, (2, 2, 0, 0, 0), strict=True):
        np.testing.assert_allclose(axes.lines[line].get_xdata(), x)
        np.testing.assert_allclose(axes.lines[line].get_ydata(), values[1].ravel(), atol=1e-12)
    units = [axes.get_ylabel().partition("\n")[2] for axes in figure.axes]
    assert units == ["(N)", "(N·m)", "(N)", "(N·m)", "(MPa)"]


# --- bearings in their places ---------------------------------------------------------------------


def test_bearings_stand_in_order_on_one_scale() -> None:
    """Along the machine's x, whatever shaft they are on; arrows as long as their forces."""
    solved = ro.shaft(EXAMPLES / "coaxial.toml")
    figure = draw_bearings_in_place(solved)
    shown = [axes for axes in figure.axes if axes.get_visible()]
    names = [axes.get_title().split("\n")[0] for axes in shown]
    assert names == ["inner, left", "hollow, left", "between", "hollow, right"]
    assert len({axes.get_ylim() for axes in shown}) == 1
    for axes, name in zip(shown, names, strict=True):
        own = solved.bearings[name]
        np.testing.assert_allclose(
            np.sort(np.unique(axes.lines[1].get_ydata())),
            np.sort(np.unique(own.solved.outer.load[0])),
        )
        (arrow,) = [text for text in axes.texts if not text.get_text()]
        angle, length = arrow.xy  # type: ignore[attr-defined]
        fy, fz = own.force[0, 1:3]
        assert np.cos(angle - np.arctan2(fy, fz)) == pytest.approx(1.0)
        most = max(float(one.radial_force[0]) for one in solved.bearings.values())
        assert length / axes.get_ylim()[1] == pytest.approx(own.radial_force[0] / most)


def test_bearings_without_a_result_say_why() -> None:
    """Each in its frame; so do lines along the axis."""
    machine = ro.load_machine(EXAMPLES / "gear_shaft.toml", ["bearings.locating.designation=NU308"])
    lost = ro.shaft(machine)
    for axes in draw_bearings_in_place(lost).axes:
        assert axes.texts[0].get_text()
    assert draw_deflection(lost).texts[0].get_text() == "no equilibrium"
    assert draw_section_forces(lost).axes[0].texts[0].get_text() == "no equilibrium"
    assert "wheel" in labelled(draw_machine(lost))
