"""What a person sees of roller bearings: pictures, pages, notes, the equations of a report."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from typer.testing import CliRunner

import rolamento as ro
from rolamento.cli.app import app
from rolamento.document import Table
from rolamento.errors import InputError
from rolamento.pages.elements import element_sections
from rolamento.pages.equations import equations_of, references_of
from rolamento.pages.state import state_page
from rolamento.plots.balls import ball_loads, load_rosette
from rolamento.plots.ellipses import contact_ellipses
from rolamento.plots.roller import (
    compared_rollers,
    pressure_along_rollers,
    pressures_of_both_races,
    roller_between_races,
)
from rolamento.plots.slip import slip_map
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.solved.outline import roller_outline
from rolamento.tasks.report import calculation_report
from rolamento.types import TYPES

NU = """
title = "NU"
[bearing]
element = "cylindrical"
roller_count = 13
roller_diameter = "7.5 mm"
effective_length = "9 mm"
pitch_diameter = "38.5 mm"
diametral_clearance = "20 um"
[duty]
inner_speed = "3000 rpm"
[duty.load]
fz = "5 kN"
[duty.displacement]
x = "0 mm"
ry = "3 mrad"
"""
PAIR = """
[bearing]
element = "tapered"
roller_count = 17
roller_diameter = "7.6 mm"
effective_length = "10.3 mm"
pitch_diameter = "46 mm"
contact_angle = "14 deg"
arrangement = "DB"
spacing = "60 mm"
preload = "500 N"
[duty]
inner_speed = "1500 rpm"
[duty.load]
fx = "1 kN"
fz = "4 kN"
my = "-100 N m"
"""


BALL = """
[bearing]
ball_count = 9
ball_diameter = "7.9 mm"
pitch_diameter = "38.5 mm"
diametral_clearance = "10 um"
inner_conformity = 0.52
outer_conformity = 0.52
[duty.load]
fz = "3 kN"
"""


def of(text: str, *settings: str) -> Solved:
    return solve(ro.override(ro.parse_case(text), list(settings)))


@pytest.fixture(scope="module")
def tilted() -> Solved:
    return of(NU)


@pytest.fixture(scope="module")
def pair() -> Solved:
    return of(PAIR)


@pytest.fixture(scope="module")
def coupled() -> Solved:
    return of(NU, "model.roller_contact=coupled")


@pytest.fixture(scope="module")
def unsolved() -> Solved:
    """No ribs carry the axial load."""
    return of(NU, 'duty.displacement={ ry = "3 mrad" }', "duty.load.fx=1 kN")


def labels(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def keys(solved: Solved) -> list[str]:
    return [note.key for note in solved.notes[0]]


# --- pictures -----------------------------------------------------------------------------------


def test_the_most_loaded_roller_stands_out(tilted: Solved) -> None:
    axes = pressure_along_rollers(tilted, race="outer")
    assert labels(axes) == ["the other rollers", "roller #0 at 0°"]
    rollers = tilted.rollers
    assert rollers is not None
    x, y = (np.asarray(part, dtype=float) for part in axes.lines[-3].get_data())
    np.testing.assert_allclose(x, 1e3 * rollers.slice_place[0, 0])
    np.testing.assert_allclose(y, 1e-6 * rollers.outer.pressure[0, 0])
    ends = [line.get_xdata()[0] for line in axes.lines[-2:]]
    assert ends == pytest.approx([-4.5, 4.5])
    assert axes.get_ylabel() == "Pressure at the outer race (MPa)"


def test_rollers_that_bear_nothing_are_not_drawn(tilted: Solved) -> None:
    loaded = int(tilted.loaded[0].sum())
    axes = pressure_along_rollers(tilted, race="inner")
    assert len(axes.lines) == loaded + 2  # and the ends of the effective length


def test_both_races_have_one_scale(pair: Solved) -> None:
    inner, outer = pressures_of_both_races(pair)
    assert inner.get_ylim() == outer.get_ylim()
    assert sum("row 0" in label for label in labels(inner)) == 1
    assert sum("row 1" in label for label in labels(inner)) == 1
    assert outer.get_xlabel().endswith("toward +x of its row (mm)")  # row 1 is mirrored


def test_models_are_compared_along_the_most_loaded_roller(
    tilted: Solved, coupled: Solved, unsolved: Solved
) -> None:
    axes = compared_rollers({"slices": tilted, "coupled": coupled, "failed": unsolved})
    assert labels(axes) == ["slices, roller #0 at 0°", "coupled, roller #0 at 0°",
                            "failed: No result"]  # fmt: skip
    with pytest.raises(InputError, match="would make 8 lines"):
        compared_rollers({str(number): tilted for number in range(8)})


@pytest.mark.parametrize("text", [NU, PAIR])
def test_the_outline_is_what_the_solver_pressed(text: str) -> None:
    """A slice bears where roller and race overlap, q = c δ^(10/9) with one c for all."""
    solved = of(text)
    rollers = solved.rollers
    assert rollers is not None
    for one in np.flatnonzero(solved.loaded[0]).tolist():
        outline = roller_outline(solved, one)
        for race, line in (("inner", rollers.inner), ("outer", rollers.outer)):
            overlap, load = getattr(outline, race), line.load_per_length[0, one]
            bears = load > 0.0
            assert np.array_equal(overlap > 0.0, bears)
            constant = load[bears] / overlap[bears] ** (10.0 / 9.0)
            np.testing.assert_allclose(constant, constant[0], rtol=1e-9)


def test_heights_are_exaggerated_as_is_said(tilted: Solved) -> None:
    axes = roller_between_races(tilted)
    said = re.search(r"(\d+) times", axes.get_ylabel())
    assert said is not None
    left, right = axes.get_xlim()
    low, high = axes.get_ylim()
    per_mm, per_um = 1.0 / (right - left), float(axes.get_box_aspect()) / (high - low)
    assert 1e3 * per_um / per_mm == pytest.approx(float(said[1]))
    outer = next(line for line in axes.lines if line.get_label() == "outer race")
    assert np.ptp(outer.get_ydata()) < 1e-6  # it stands straight, the rest is tilted
    assert "tilt −1.5 mrad" in labels(axes)[0]
    assert any("inner race, tilt −3 mrad" in label for label in labels(axes))
    with pytest.raises(InputError, match="0 to 12"):
        roller_between_races(tilted, roller=13)


def test_pictures_of_the_other_kind_are_refused(tilted: Solved, case_218: ro.Case) -> None:
    balls = solve(case_218)
    for draw in (pressure_along_rollers, roller_between_races):
        with pytest.raises(InputError, match="this bearing has balls"):
            draw(balls)
    for refuse in (contact_ellipses, slip_map):
        with pytest.raises(InputError, match="rollers touch along lines"):
            refuse(tilted)


def test_pictures_of_balls_suit_rollers_too(tilted: Solved) -> None:
    assert ball_loads(tilted).get_xlabel() == "Azimuth of the roller (°)"
    loads = np.asarray(load_rosette(tilted).lines[0].get_ydata(), dtype=float)[:-1]
    np.testing.assert_allclose(loads, tilted.inner.load[0])


def test_without_a_result_a_frame_says_why(unsolved: Solved) -> None:
    for axes in (pressure_along_rollers(unsolved), roller_between_races(unsolved)):
        text = " ".join(one.get_text() for one in axes.texts).replace("\n", " ")
        assert "no equilibrium" in text


def test_plot_draws_rollers_of_a_file(
    tilted: Solved, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("state.json").write_text(tilted.to_json(), encoding="utf-8")
    for kind in ("along", "between", "rosette"):
        run = CliRunner().invoke(app, ["plot", "state.json", "--kind", kind, "-o", f"{kind}.svg"])
        assert (run.exit_code, run.output) == (0, f"Wrote {kind}.svg\n")
    run = CliRunner().invoke(app, ["plot", "state.json", "--kind", "ellipses"])
    assert run.exit_code == 2
    two = ["plot", "state.json", "state.json", "--label", "a", "--label", "b", "--kind", "along"]
    assert CliRunner().invoke(app, two).exit_code == 0


# --- pages --------------------------------------------------------------------------------------


def test_a_state_shows_its_rollers(tilted: Solved) -> None:
    page = state_page(tilted)
    assert page.main == "rollers"
    headings = [section.heading for section in page.parts()]
    assert "Rollers" in headings
    assert "Balls" not in headings
    assert any(heading.startswith("Heaviest roller: #0") for heading in headings)
    assert "Along the rollers" in headings
    tables = {table.key: table for table in page.tables()}
    assert {"rollers", "slices"} <= tables.keys()
    rollers = tilted.rollers
    assert rollers is not None
    columns = {column.key or column.head: column.values for column in tables["slices"].columns}
    assert len(columns["slice"]) == 13 * 35
    np.testing.assert_allclose(
        np.array(columns["inner_pressure"], dtype=float).reshape(13, 35), rollers.inner.pressure[0]
    )


def test_the_csv_of_rollers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(NU, encoding="utf-8")
    run = CliRunner().invoke(app, ["solve", "case.toml", "--csv", "rollers.csv"])
    assert run.exit_code == 0
    rows = list(csv.DictReader(Path("rollers.csv").read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 13
    assert float(rows[0]["tilt_mrad"]) == pytest.approx(-1.5, rel=1e-3)
    assert float(rows[0]["inner_peak_place_mm"]) < 0.0
    assert not any("ball" in name for name in rows[0])


def test_a_state_without_a_result_has_its_rollers_in_files(unsolved: Solved) -> None:
    (section,) = element_sections(unsolved)
    tables = [block for block in section.blocks if isinstance(block, Table)]
    assert {table.key for table in tables} == {"rollers", "slices"}
    assert all(table.only_in_files for table in tables)


def test_the_head_names_rollers_profile_and_model(tilted: Solved, coupled: Solved) -> None:
    texts = [
        str(entry.content)
        for solved in (tilted, coupled)
        for block in next(iter(state_page(solved).parts())).blocks
        for entry in getattr(block, "entries", ())
    ]
    whole = "\n".join(texts)
    assert "13 cylindrical rollers of 7.5 mm, effective length 9 mm" in whole
    assert "ribs: inner ring none, outer ring both sides" in whole
    assert "rollers with the logarithmic profile of ISO/TS 16281" in whole
    assert "35 independent slices (ISO/TS 16281)" in whole
    assert "35 slices coupled by the elastic half-space" in whole


def test_a_set_of_balls_and_rollers_has_a_table_of_each() -> None:
    rows = (
        'bearing.rows=[{ position = "-20 mm" }, { element = "cylindrical", position = "20 mm", '
        'roller_count = 13, roller_diameter = "7.5 mm", effective_length = "9 mm", '
        'pitch_diameter = "38.5 mm", diametral_clearance = "20 um" }]'
    )
    solved = of(BALL, rows)
    assert solved.converged[0]
    page = state_page(solved)
    tables = {table.key: table for table in page.tables()}
    assert len(tables["balls"].columns[0].values) == 9
    assert len(tables["rollers"].columns[0].values) == 13
    assert page.main == "balls"


# --- notes --------------------------------------------------------------------------------------


def test_what_is_to_be_known_of_a_tilted_roller_bearing(tilted: Solved, coupled: Solved) -> None:
    assert keys(tilted) == ["rollers_unloaded", "rollers_misaligned", "edges_bear"]
    assert "edges_bear" not in keys(coupled)  # it sees what there is of a peak
    straight = of(NU, "model.roller_contact=coupled", "bearing.roller_profile=none")
    (peak,) = [note for note in straight.notes[0] if note.key == "edge_pressure_peak"]
    assert peak.values["max_pressure"] == pytest.approx(
        max(straight.inner.max_pressure.max(), straight.outer.max_pressure.max())
    )
    assert peak.values["ratio"] > 1.2
    assert "peaks at the end of" in peak.text


def test_the_limit_of_tilt_is_a_limit() -> None:
    limit = TYPES["cylindrical"].usual_misalignment
    below, above = (of(NU, f"duty.displacement.ry={part * limit} rad") for part in (0.99, 1.01))
    assert "rollers_misaligned" not in keys(below)
    assert "rollers_misaligned" in keys(above)


def test_a_pressure_that_dents_is_told() -> None:
    heavy = of(NU, "duty.load.fz=60 kN", "duty.displacement.ry=0 mrad")
    note = next(note for note in heavy.notes[0] if note.key == "line_pressure_high")
    assert note.values["max_pressure"] > note.values["limit"] == 4.0e9
    assert "rollers" in note.values


def test_ribs_that_are_not_there_hold_nothing(unsolved: Solved) -> None:
    advice = unsolved.advice[0]
    assert advice is not None
    assert advice.key == "ribs_do_not_hold"
    alone = re.sub(r"(arrangement|spacing|preload) = .*\n", "", PAIR)
    single = of(alone, 'duty.load={ fx = "-1 kN", fz = "4 kN" }')
    assert single.advice[0] is not None
    assert single.advice[0].key == "tapered_unsupported_axially"


# --- reports ------------------------------------------------------------------------------------


def test_a_report_rests_on_the_equations_of_rollers() -> None:
    (case,) = calculation_report([ro.parse_case(NU)]).cases
    names = {one.name for one in equations_of([case])}
    assert {"Load of an independent slice", "Hertz line contact: half-width and maximum pressure",
            "Basic dynamic load rating", "Logarithmic profile of a roller"} <= names  # fmt: skip
    assert not any("ball" in name.lower() or "point contact" in name for name in names)
    assert "Slices coupled by the elastic half-space" not in names
    symbols = {one.symbol: one.meaning for law in equations_of([case]) for one in law.symbols}
    assert "ball" not in " ".join(symbols.values())
    assert any("ISO/TS 16281" in text for text in references_of([case]))
    checks = {check.name: check for check in case.checks}
    assert "pressure" not in checks
    assert checks["line_pressure"].met
    assert not checks["misalignment"].met
    assert case.number("extremes.roller_tilt") == pytest.approx(1.5e-3, rel=1e-3)
    assert case.number("extremes.inner_roller") == 0.0
    fields = {one.field for one in case.inputs}
    assert "model.slices" in fields
    assert "model.raceway_control" not in fields
