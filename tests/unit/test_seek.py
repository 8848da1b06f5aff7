"""`rolamento seek`: the input for an output, all of them, and what is said where there is none."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import analyse, load_case, solve
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.tasks import GoalSeek
from rolamento.words import in_unit, speaking

LOADED = {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}


def run(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(app, ["seek", *arguments])
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.stdout, result.stderr


def test_what_is_found_gives_the_output() -> None:
    asked = GoalSeek(
        case="6310", changes=LOADED, vary="duty.load.fz=2..20kN", wanted="max_inner_load=3 kN"
    )
    found = asked.run()
    (force,) = found.found
    again = solve(load_case("6310", LOADED), fz=force)
    assert np.nanmax(again.inner.load) == pytest.approx(3e3, rel=2e-6)
    assert found.status == "found"
    assert found.cases[0].duty.load.fz == force


def test_a_preload_for_a_stiffness_is_found_beyond_twice_its_value() -> None:
    case = {"bearing.preload": "100 N", "duty.inner_speed": "1000 rpm"}
    wanted = "stiffness_xx=150 N/um"
    found = GoalSeek(case="7014 C DB", changes=case, vary="bearing.preload", wanted=wanted).run()
    (force,) = found.found
    assert force > 200.0
    again = solve(load_case("7014 C DB", {**case, "bearing.preload": f"{force!r} N"}))
    assert again.stiffness.array[0, 0, 0] == pytest.approx(150e6, rel=2e-6)


def test_all_solutions_of_a_curve_that_turns_are_found() -> None:
    """The stiffness across is even in the load: the same forwards and backwards."""
    axial = {"bearing.preload": "300 N", "duty.inner_speed": "100 rpm"}
    asked = GoalSeek(
        case="7014 C DB",
        changes=axial,
        vary="duty.load.fx=-150..150N",
        wanted="max_inner_max_pressure=900 MPa",
    )
    curve = asked.run().curve
    middle = float(np.interp(104.3, curve.values, curve.numbers))
    asked = asked.replace(wanted=f"max_inner_max_pressure={middle / 1e6} MPa")
    left, right = asked.run().found
    assert left == pytest.approx(-right, rel=1e-6)
    beyond = asked.replace(changes={**axial, "duty.load.fx": "-140 N"})
    assert beyond.run().found == pytest.approx((left, right), rel=1e-6)


def test_what_is_nowhere_is_said_with_what_there_is() -> None:
    asked = GoalSeek(
        case="6310", changes=LOADED, vary="duty.load.fz=2..20kN", wanted="max_inner_load=1 N"
    )
    found = asked.run()
    assert (found.status, found.found) == ("not_in_range", ())
    assert "wider range" in found.complaint
    assert json.dumps(found.to_mapping())


def test_loads_that_nothing_carries_have_no_answer() -> None:
    asked = GoalSeek(
        case="6310", changes=LOADED, vary="duty.load.fz=1e8..1e9N", wanted="max_inner_load=1 N"
    )
    found = asked.run()
    assert not found.found
    assert found.complaint


@pytest.mark.parametrize(
    ("vary", "wanted", "field"),
    [
        ("duty.load.fz", "max_inner_load", "wanted"),
        ("duty.load.fz", "max_inner_load=", "wanted"),
        ("duty.load.fz", "max_inner_load=3", "wanted"),
        ("duty.load.fz", "max_inner_load=3 rpm", "wanted"),
        ("duty.load.fz", "max_inner=3 N", "wanted"),
        ("duty.load.fz", "inner_load=3 N", "wanted"),
        ("duty.load", "max_inner_load=3 N", "vary"),
        ("bearing.designation", "max_inner_load=3 N", "vary"),
        ("duty.load.fz=2", "max_inner_load=3 N", "vary"),
        ("duty.load.fz=2..1kN", "max_inner_load=3 N", "vary"),
        ("duty.load.fz=2..1e400kN", "max_inner_load=3 N", "vary"),
    ],
)
def test_what_is_refused(vary: str, wanted: str, field: str) -> None:
    with pytest.raises(InputError) as caught:
        GoalSeek(case="6310", changes=LOADED, vary=vary, wanted=wanted).run()
    assert caught.value.field == field


def test_the_command(tmp_path: Path) -> None:
    given = ("6310", "--fr", "5 kN", "--vary", "duty.load.fz=2..20kN")
    picture = tmp_path / "seek.svg"
    code, out, err = run(*given, "--for", "max_inner_load=3 kN", "--plot", str(picture))
    assert (code, err) == (0, "")
    assert out.startswith("Radial load Fz of 5.2")
    assert "Now, at 5 kN" in out
    assert picture.stat().st_size > 5000
    code, out, _ = run(*given, "--for", "max_inner_load=3 kN", "--lang", "pt")
    assert code == 0
    assert "Agora" in out
    code, out, err = run(*given, "--for", "max_inner_load=1 N", "--json")
    assert code == 1
    assert json.loads(out)["status"] == "not_in_range"
    assert "wider range" in err
    code, _, err = run(*given, "--for", "max_inner_load=1 rpm")
    assert code == 2
    assert err.startswith("rolamento: --for: ")


def test_a_page_in_both_languages() -> None:
    asked = GoalSeek(
        case="6310", changes=LOADED, vary="duty.load.fz=2..20kN", wanted="max_inner_load=3 kN"
    )
    found = asked.run()
    with speaking("pt"):
        page = asked.page(found)
    assert page.main == "curve"
    (table,) = page.tables()
    assert len(table.columns[0].values) == len(found.curve.values) + 1


@pytest.mark.parametrize(
    ("wanted", "unit", "value"),
    [("life_hours=20000 h", "h", 20000.0), ("life_revolutions=1000 Mrev", "10⁶ rev", 1000.0)],
)
def test_the_table_has_the_goal_in_its_unit(wanted: str, unit: str, value: float) -> None:
    """Lives are no SI quantities of a study; the table, as each, holds SI."""
    asked = GoalSeek(case="6310", changes=LOADED, vary="duty.load.fz=2..20kN", wanted=wanted)
    found = asked.run()
    column = asked.page(found).sections[-1].blocks[-1].columns[1]
    (goal,) = [cell for cell, tone in zip(column.values, column.tones, strict=True) if tone]
    assert column.unit == unit
    assert in_unit(goal, unit) == pytest.approx(value, rel=1e-12)


OILED = {**LOADED, "lubricant": "ISO VG 68", "temperature.lubricant": "70 degC"}


def test_a_torque_is_qualified_by_what_its_friction_rests_on() -> None:
    """Its coefficient of friction is assumed: the headline of `friction` says so, this one too."""
    wanted = "friction_torque_jones_simplified=0.2 N*m"
    asked = GoalSeek(case="6310", changes=OILED, vary="duty.load.fz=2..20kN", wanted=wanted)
    found = asked.run()
    friction = analyse(found.cases[0])
    expected = {note.key for note in friction.friction.qualifications(friction.solved)}
    assert expected
    assert expected <= {note.key for note in found.notes}


@pytest.mark.parametrize(
    ("vary", "wanted", "says"),
    [
        ("duty.load.fz", "life.hours=20000", '--for: "life.hours": is an unknown output'),
        ("duty.load.fq", "life_hours=20000", '--vary: "duty.load.fq": is not a field'),
    ],
)
def test_a_name_that_is_unknown_is_that_of_its_option(vary: str, wanted: str, says: str) -> None:
    given = ("6310", "--fr", "5 kN", "--speed", "1480 rpm")
    code, _, err = run(*given, "--vary", vary, "--for", wanted)
    assert code == 2
    assert err.startswith(f"rolamento: {says}")
