"""Maps of slip, pressure and their product: the data are those of the contact."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

import rolamento as ro
from rolamento.charts.frame import figure_of
from rolamento.errors import InputError
from rolamento.friction.slip import (
    Patch,
    maximum_pressure_slip,
    rolling_lines,
    solved_motion,
)
from rolamento.plots.slip import QUANTITIES, slip_map, slip_maps
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.words import speaking


@pytest.fixture(scope="module")
def state(case_218: ro.Case) -> Solved:
    return solve(case_218)


def test_map_shows_line_and_maximum_where_they_are(state: Solved) -> None:
    patch, motion = Patch.of(state.inner), solved_motion(state, "inner")
    heaviest = int(np.argmax(patch.load[0]))
    a = 1e3 * patch.semi_major[0, heaviest]
    axes = slip_map(state, quantity="pressure_slip")
    _edge, *lines, cross = axes.get_lines()
    expected = rolling_lines(patch, motion)[0, heaviest]
    drawn = [line.get_xdata()[0] for line in lines]  # type: ignore[index]
    np.testing.assert_allclose(drawn, a * expected[np.isfinite(expected)])
    found = maximum_pressure_slip(patch, motion)
    assert cross.get_xdata()[0] == pytest.approx(a * found.across[0, heaviest])  # type: ignore[index]
    value = 1e-6 * found.value[0, heaviest]
    legend = axes.get_legend()
    assert legend is not None
    assert any(f"{value:.4g}" in text.get_text() for text in legend.get_texts())


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_all_three_maps_have_units_and_can_be_drawn(state: Solved, race: str) -> None:
    frames = slip_maps(state, race=race)  # type: ignore[arg-type]
    assert len(frames) == len(QUANTITIES)
    figure = figure_of(frames[0])
    labels = {axes.get_ylabel() for axes in figure.axes}
    assert {"Slip (m/s)", "Pressure (MPa)", "Pressure times slip (W/mm²)"} <= labels
    FigureCanvasAgg(figure).print_png(io.BytesIO())


def test_portuguese(state: Solved) -> None:
    with speaking("pt"):
        axes = slip_map(state, ball=3)
    assert axes.get_xlabel() == "Transversal ao rolamento (mm)"


def test_frames_that_say_why(case_218: ro.Case, examples: Path) -> None:
    unsolved = solve(ro.override(case_218, ["duty.load.fx=-20 kN"]))
    assert "No result" in slip_map(unsolved).texts[0].get_text()
    radial = solve(ro.load_case(examples / "209_radial.toml"))
    free = int(np.argmin(radial.inner.load[0]))
    assert "do not touch" in slip_map(radial, ball=free).texts[0].get_text()


def test_refusals(state: Solved) -> None:
    with pytest.raises(InputError, match="ball"):
        slip_map(state, ball=99)
    with pytest.raises(InputError, match="quantity"):
        slip_map(state, quantity="heat")  # type: ignore[arg-type]
