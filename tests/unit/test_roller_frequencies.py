"""Fault frequencies of roller bearings: of a record, in words, and back out of a made signal."""

from __future__ import annotations

import json
from math import cos, pi, radians, sin, tan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento.case import Bearing, Case, Duty, Load
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import catalogue, rolling_bearings
from rolamento.cli.app import app
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.geometry import apex_half_angle
from rolamento.pages.turn import turn_page
from rolamento.plots.cage_turn import cage_turn_figure
from rolamento.solution import solve
from rolamento.studies.cage_turn import cage_turn
from rolamento.tasks.diagnosis import DiagnosisResult, diagnose
from rolamento.tasks.frequencies import fault_frequencies
from rolamento.tasks.synthesis import SynthesisResult, synthesise
from rolamento.vibration.frequencies import (
    LINES,
    FaultFrequencies,
    frequencies_of,
    nominal_frequencies,
)
from rolamento.vibration.frequency_band import Tolerances, banded_frequencies
from rolamento.vibration.lookalikes import orders_of as lookalike_orders
from rolamento.vibration.synthesis import (
    Fault,
    LoadDistribution,
    Noise,
    Waviness,
)
from rolamento.words.naming import of_element
from rolamento.words.note import Note
from rolamento.words.sentences import sentence

SPEED = 1500.0 * pi / 30.0
NU205: dict[str, Any] = {
    "element": "cylindrical",
    "roller_count": 13,
    "roller_diameter": 0.0075,
    "effective_length": 0.0082,
    "pitch_diameter": 0.039,
    "diametral_clearance": 3e-5,
}
TAPER: dict[str, Any] = {
    "element": "tapered",
    "roller_count": 17,
    "roller_diameter": 0.0072,
    "effective_length": 0.01,
    "pitch_diameter": 0.0463,
    "contact_angle": radians(14.0),
}


def tapered(**changes: Any) -> RollerBearing:
    """A tapered bearing, of one apex unless a half angle is given."""
    fields = {**TAPER, **changes}
    half = float(
        apex_half_angle(
            fields["roller_diameter"], fields["pitch_diameter"], fields["contact_angle"]
        )
    )
    return RollerBearing(**{"roller_half_angle": half, **fields})


def orders(found: FaultFrequencies) -> dict[str, float]:
    return {name: line.order for name, line in found.lines.items()}


def test_cylindrical_rollers_have_the_frequencies_of_balls_at_contact_angle_zero() -> None:
    found = nominal_frequencies(RollerBearing(**NU205), SPEED)
    ball = Bearing(
        ball_count=13,
        ball_diameter=0.0075,
        pitch_diameter=0.039,
        contact_angle=0.0,
        inner_conformity=0.52,
        outer_conformity=0.52,
    )
    assert orders(found) == orders(nominal_frequencies(ball, SPEED))
    assert found.element == "cylindrical"
    assert found.to_mapping()["element"] == "cylindrical"
    assert "element" not in nominal_frequencies(ball, SPEED).to_mapping()


@pytest.mark.parametrize("outer_speed", [0.0, -40.0, 300.0])
def test_tapered_rollers_of_one_apex_go_by_the_angles_of_their_cones(outer_speed: float) -> None:
    bearing = tapered()
    found = nominal_frequencies(bearing, SPEED, outer_speed)
    inner, outer = sin(bearing.inner_contact_angle), sin(bearing.row_angle)
    cage = (SPEED * inner + outer_speed * outer) / (inner + outer)
    assert found.turns.cage * SPEED == pytest.approx(cage, rel=1e-12)
    assert found.ball_pass_outer.order == pytest.approx(17 * abs(cage - outer_speed) / SPEED)
    # the roller's surface meets both races at the middle of its line
    axis = bearing.row_angle - (bearing.roller_half_angle or 0.0)
    track = 0.5 * bearing.pitch_diameter + 0.5 * bearing.roller_diameter * cos(axis)
    spin = (outer_speed - cage) * track / (0.5 * bearing.roller_diameter)
    assert found.turns.ball * SPEED == pytest.approx(spin, rel=1e-12)
    assert found.inner_contact_angle == bearing.inner_contact_angle
    assert found.outer_contact_angle == bearing.row_angle
    assert not found.notes


def test_cones_without_a_common_apex_roll_at_their_middle_and_are_told() -> None:
    bearing = tapered(roller_half_angle=radians(1.5))
    found = nominal_frequencies(bearing, SPEED)
    assert found.cage.order == pytest.approx(
        0.5 * (1.0 - 0.0072 / 0.0463 * cos(radians(12.5))), rel=1e-12
    )
    (note,) = found.notes
    assert note.key == "no_common_apex"
    inner, outer = sin(radians(11.0)), sin(radians(14.0))
    assert note.values["order_by_angles"] == pytest.approx(inner / (inner + outer))
    half = note.values["apex_half_angle"]
    assert tan(half) == pytest.approx(0.0072 / 0.0463 * sin(radians(14.0) - half))
    assert "no common apex" in note.text


def test_a_set_has_the_frequencies_of_every_row() -> None:
    ring = tapered(arrangement="DB", spacing=0.02)
    found = nominal_frequencies(ring, SPEED)
    assert [row.row for row in found.rows] == [0, 1]
    assert orders(found.rows[1]) == orders(nominal_frequencies(tapered(), SPEED))


def test_bands_hold_what_the_tolerances_leave_open() -> None:
    allowed = Tolerances(ball_diameter=1e-4, pitch_diameter=2e-4, contact_angle=radians(0.5))
    for bearing in (RollerBearing(**NU205), tapered()):
        found = banded_frequencies(bearing, SPEED, tolerances=allowed)
        for name in LINES:
            band = found.lines[name].band
            assert band is not None
            assert band.order_low < found.lines[name].order < band.order_high
    # a cylindrical roller has no angle that could be off
    alone = banded_frequencies(
        RollerBearing(**NU205), SPEED, tolerances=Tolerances(contact_angle=0.1)
    )
    band = alone.cage.band
    assert band is not None
    assert band.order_low == band.order_high == alone.cage.order


def test_rollers_keep_the_angles_of_their_raceways() -> None:
    with pytest.raises(InputError, match="rollers keep the angles"):
        nominal_frequencies(tapered(), SPEED, contact_angle=0.3)
    with pytest.raises(InputError) as caught:
        fault_frequencies(tapered(), speed=SPEED, angle="15 deg")
    assert caught.value.field == "angle"
    # of a bearing given by its clearance both choices are the same
    free = nominal_frequencies(RollerBearing(**NU205), SPEED, contact_angle="free")
    assert orders(free) == orders(nominal_frequencies(RollerBearing(**NU205), SPEED))


def test_the_page_calls_rollers_rollers(tmp_path: Path) -> None:
    path = tmp_path / "nu205.toml"
    path.write_text(
        "[bearing]\nelement = 'cylindrical'\nroller_count = 13\nroller_diameter = '7.5 mm'\n"
        "effective_length = '8.2 mm'\npitch_diameter = '39 mm'\ndiametral_clearance = '30 um'\n"
        "[duty]\ninner_speed = '1500 rpm'\n",
        "utf-8",
    )
    shown = CliRunner().invoke(app, ["frequencies", str(path), "--lang", "en"])
    assert shown.exit_code == 0
    assert "13 rollers of 7.5 mm" in shown.output
    assert "roller, both races" in shown.output
    assert "ball" not in shown.output
    written = CliRunner().invoke(app, ["frequencies", str(path), "--json"])
    told = json.loads(written.output)
    assert told["nominal"]["element"] == "cylindrical"
    assert told["nominal"]["ball_pass_outer"]["order"] == pytest.approx(5.25)


# --- synthetic signals and their diagnosis -------------------------------------------------------


CASE = Case(bearing=tapered(), duty=Duty(inner_speed=1610.0 * pi / 30.0))
"""No line near a multiple of the mains' frequency."""


def made(path: Path, *faults: Fault, **options: Any) -> SynthesisResult:
    given = {"noise": Noise(ratio=0.0, of="faults"), "duration": 4.0, "seed": 3, **options}
    found = synthesise(CASE, path, faults=faults, **given)
    return found


@pytest.mark.parametrize("part", ["outer_race", "ball"])
def test_a_planted_fault_of_a_tapered_bearing_is_found_again(tmp_path: Path, part: Any) -> None:
    path = tmp_path / "made.npz"
    planted = made(path, Fault(kind=part)).faults[0].truth
    found = diagnose(path, CASE)
    assert isinstance(found, DiagnosisResult)
    assert found.diagnosis.faults == (part,)
    assert found.diagnosis.of(part).order == pytest.approx(planted.order, rel=2e-3)
    told = json.dumps(found.to_mapping()["statement"])
    assert ("A roller" in told) is (part == "ball")
    assert "ball" not in " ".join(note.text for part in found.diagnosis.components
                                  for note in part.reasons)  # fmt: skip


def test_loads_between_rollers_go_with_the_power_of_a_line_contact() -> None:
    rollers = LoadDistribution.radial(extent=0.5, element="roller")
    balls = LoadDistribution.radial(extent=0.5)
    at = np.array([0.0, 0.3, 1.0, 2.0])
    approach = np.maximum(np.cos(at), 0.0)
    np.testing.assert_allclose(rollers.at(at, "outer"), approach ** (10.0 / 9.0), atol=1e-4)
    np.testing.assert_allclose(balls.at(at, "outer"), approach**1.5, atol=1e-4)


def test_waviness_of_rollers_says_what_it_is_of(tmp_path: Path) -> None:
    wavy = (Waviness(surface="outer", amplitudes=((17, 1e-8), (16, 1e-8))),)
    found = made(tmp_path / "wavy.npz", waviness=wavy, noise=None, duration=1.0)
    assert [note.key for note in found.notes] == ["waviness_of_rollers"]
    line = found.lines[0]
    assert line.waves == 16  # Z - 1, of which the ring feels the passage of all rollers
    assert line.order == pytest.approx(17.0 * found.recipe.frequencies.cage.order)


def test_notes_name_what_rolls() -> None:
    note = Note("carries_the_ball")
    assert of_element(note, "ball") is note
    assert "damaged roller" in of_element(note, "roller").text
    nested = of_element(Note("undecided_speed", {"speeds": [["ball", 10.0]]}), "roller")
    assert nested.values["speeds"] == [["roller", 10.0]]
    assert "a roller" in sentence(nested.key, nested.values)


# --- of a designation, whose number of rollers is open -------------------------------------------


def test_another_number_of_rollers_moves_the_orders_of_the_races_alone() -> None:
    found = fault_frequencies("NU 205")
    assert len(found.alternatives) > 1
    for one in found.alternatives:
        assert one.orders["ball_pass_outer"] == pytest.approx(one.ball_count * one.orders["cage"])
        assert one.orders["cage"] == pytest.approx(found.nominal.cage.order)
    band = found.nominal.ball_pass_outer.band
    assert band is not None
    assert band.order_high - band.order_low > 2.0 * found.nominal.cage.order
    assert "roller_count_open" in [note.key for note in found.notes]
    counted = fault_frequencies("NU 205", changes=["bearing.roller_count=12"])
    assert [one.ball_count for one in counted.alternatives] == [12]
    assert "roller_count_open" not in [note.key for note in counted.notes]


def test_a_diagnosis_says_which_number_of_rollers_its_peak_would_fit(tmp_path: Path) -> None:
    """With 12 rollers the outer race is within 3.3 % of what the 13 strike twice a turn."""
    path = tmp_path / "twelve.npz"
    synthesise(
        "NU 205",
        path,
        changes=["bearing.roller_count=12"],
        speed="1530 rpm",
        faults=[Fault(kind="outer_race")],
        noise=Noise(ratio=0.0, of="faults"),
        duration=4.0,
    )
    found = diagnose(path, "NU 205", speed="1530 rpm")
    assert isinstance(found, DiagnosisResult)
    told = {note.key: note for note in found.advice}
    assert told["peak_of_other_count"].values["count"] == 12
    assert told["peak_of_other_count"].values["part"] == "outer_race"
    assert "peak_of_other_count" in [one["key"] for one in found.to_mapping()["advice"]]
    counted = diagnose(path, "NU 205", speed="1530 rpm", changes=["bearing.roller_count=12"])
    assert isinstance(counted, DiagnosisResult)
    assert counted.diagnosis.faults == ("outer_race",)
    assert "peak_of_other_count" not in [note.key for note in counted.advice]
    assert counted.lookalikes is not None
    assert "NU 2205 ET" in [one.designation for one in counted.lookalikes.found]


@pytest.mark.parametrize("designation", ["NU 205", "30206", "NA 4905"])
def test_the_catalogue_rolls_as_its_bearings_do(designation: str) -> None:
    own = RollerBearing.named(designation)
    turns = nominal_frequencies(own).turns
    listed = {one.designation: one for one in rolling_bearings(of_rollers=True)}
    name = catalogue().find(designation).bearing.designation
    assert lookalike_orders(listed[name]).cage == pytest.approx(turns.cage, rel=1e-6)
    assert name not in [one.designation for one in rolling_bearings()]


# --- under load ----------------------------------------------------------------------------------


@pytest.mark.parametrize("speeds", [(SPEED, 0.0), (0.0, -SPEED), (0.0, 0.0)])
def test_under_load_rollers_roll_as_by_their_geometry(speeds: tuple[float, float]) -> None:
    for bearing, load in (
        (RollerBearing(**NU205), Load(fz=3000.0)),
        (tapered(), Load(fz=3000.0, fx=2000.0)),
    ):
        duty = Duty(inner_speed=speeds[0], outer_speed=speeds[1], load=load)
        loaded = frequencies_of(solve(Case(bearing=bearing, duty=duty)))
        nominal = nominal_frequencies(bearing, *speeds)
        assert loaded.element == bearing.element
        for name in LINES:
            line = loaded.lines[name]
            assert line.order == pytest.approx(nominal.lines[name].order, rel=1e-12)
            assert line.minimum == pytest.approx(line.maximum, rel=1e-12)
        assert loaded.outer_contact_angle == pytest.approx(bearing.row_angle)
        assert loaded.inner_contact_angle == pytest.approx(bearing.inner_contact_angle)


def test_loads_of_a_solved_case_give_the_strengths_of_impacts() -> None:
    duty = Duty(inner_speed=SPEED, load=Load(fz=3000.0))
    solved = solve(Case(bearing=RollerBearing(**NU205), duty=duty))
    loads = LoadDistribution.of_solved(solved, positions=4)
    assert loads.exponent == pytest.approx(10.0 / 9.0)
    assert float(loads.at(0.0, "outer")) == pytest.approx(1.0, abs=0.01)
    assert float(loads.at(pi, "inner")) == 0.0
    assert 0.0 < float(loads.at(pi, "outer")) < 1e-3  # by centrifugal force


def test_a_ball_bearing_beside_a_roller_bearing_each_has_its_own_frequencies() -> None:
    balls = {
        "element": "ball",
        "ball_count": 9,
        "ball_diameter": 0.0079375,
        "pitch_diameter": 0.0385,
        "diametral_clearance": 1e-5,
        "inner_conformity": 0.515,
        "outer_conformity": 0.53,
        "position": -0.01,
    }
    rollers = {**NU205, "position": 0.01}
    found = nominal_frequencies(Bearing(rows=(balls, rollers)), SPEED)  # type: ignore[arg-type]
    assert [row.element for row in found.rows] == ["ball", "cylindrical"]
    assert orders(found.rows[1]) == orders(nominal_frequencies(RollerBearing(**NU205), SPEED))


def test_a_turn_of_the_cage_speaks_of_rollers() -> None:
    duty = Duty(inner_speed=SPEED, load=Load(fz=3000.0))
    turn = cage_turn(Case(bearing=RollerBearing(**NU205), duty=duty), points=8)
    assert turn.converged
    assert turn.passage_frequency == pytest.approx(
        nominal_frequencies(RollerBearing(**NU205), SPEED).ball_pass_outer.frequency, rel=1e-12
    )
    shown = terminal(turn_page(turn), Medium())
    assert "rollers pass under the load" in shown
    assert "ball" not in shown
    figure = cage_turn_figure(turn)  # without stiffness along x, and without a warning
    assert "roller" in figure.axes[0].get_xlabel() + figure.axes[1].get_title()
