"""Pictures of a machine: everything is drawn, at its place, inside the frame."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.patches import Ellipse, Polygon, Rectangle
from typer.testing import CliRunner

import rolamento as ro
from rolamento.cli.app import app
from rolamento.plots import campbell_figure, machine_figure, modes_figure
from rolamento.rotors import campbell, natural_modes

mpl.use("Agg")

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_every_example_is_drawn(path: Path) -> None:
    """Sections above and below the axis; a ball or roller for each row, twice; loads with text."""
    solved = ro.shaft(path)
    figure = machine_figure(solved)
    figure.draw_without_rendering()
    drawing, *lower = figure.axes[:4]
    machine = solved.machine
    sections = sum(len(shaft.sections) for shaft in machine.shafts)
    assert sum(isinstance(p, Polygon) for p in drawing.patches) == 2 * sections
    rows = [place for one in machine.bearings for place in one.case.bearing.element_rows]
    balls = sum(place.bearing.element == "ball" for place in rows)
    assert sum(isinstance(p, Ellipse) for p in drawing.patches) == 2 * balls
    rings = [p for p in drawing.patches if isinstance(p, Rectangle)]
    assert len(rings) >= 4 * len(rows)
    names = {text.get_text() for text in drawing.texts}
    assert {one.name for one in machine.bearings} <= names
    low, high = drawing.get_ylim()
    for text in drawing.texts:
        assert low <= text.xy[1] <= high  # type: ignore[attr-defined]
    for axes in lower:
        assert axes.get_shared_x_axes().joined(axes, drawing)


def test_the_line_of_deflection_is_the_result() -> None:
    """In µm, over the machine's x in mm; of the step that is asked for."""
    solved = ro.shaft(EXAMPLES / "gear_shaft.toml")
    figure = machine_figure(solved, step=2)
    one = solved.shafts["output shaft"]
    lines = {line.get_label(): line for line in figure.axes[1].lines}
    np.testing.assert_allclose(lines["z"].get_ydata(), 1e6 * one.displacement[2, :, 2])
    np.testing.assert_allclose(lines["z"].get_xdata(), 1e3 * one.position)
    moments = figure.axes[2].lines[0].get_ydata()
    np.testing.assert_allclose(moments, one.bending_moment[2].ravel())


def test_without_equilibrium_the_machine_is_drawn_all_the_same() -> None:
    """And the panels below say why they are empty."""
    machine = ro.load_machine(EXAMPLES / "gear_shaft.toml", ["bearings.locating.designation=NU308"])
    figure = machine_figure(ro.shaft(machine))
    assert [axes.texts[0].get_text() for axes in figure.axes[1:4]] == ["no equilibrium"] * 3


def test_vibration_is_drawn() -> None:
    """A line a branch, a point a critical speed, a panel a mode."""
    motor = EXAMPLES / "motor.toml"
    found = campbell(motor, np.linspace(50.0, 3000.0, 8), count=5, orders=(1.0, 2.0))
    axes = campbell_figure(found).axes[0]
    points = [
        line for line in axes.lines if line.get_marker() == "o" and line.get_color() == "black"
    ]
    assert len(points) == len(found.critical) > 0
    figure = modes_figure(natural_modes(motor, count=6), count=3)
    assert len(figure.axes) == 3
    assert "Hz" in figure.axes[0].get_ylabel()


def test_the_command_draws(tmp_path: Path) -> None:
    """One step of the spectrum, by its number."""
    path = tmp_path / "machine.svg"
    arguments = ["shaft", str(EXAMPLES / "gear_shaft.toml"), "--plot", str(path), "--step", "3"]
    assert CliRunner().invoke(app, arguments).exit_code == 0
    assert path.stat().st_size > 10_000
    wrong = CliRunner().invoke(app, [*arguments[:-1], "9"])
    assert wrong.exit_code == 2
