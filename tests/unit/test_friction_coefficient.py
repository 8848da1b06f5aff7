"""The coefficient of friction by the regime: a named oil is enough, in every door."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case
from rolamento.analysis import analyse
from rolamento.case import Lubricant
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.friction import friction
from rolamento.friction.coefficient import (
    SLIDING_AT_START,
    blended,
    boundary_share,
    coefficient_by_regime,
)
from rolamento.friction.skf import series_constants, skf_moment
from rolamento.pages.friction import friction_page
from rolamento.pages.report import report_page
from rolamento.solution import solve
from rolamento.studies.outputs import Evaluation, catalogue, supplied
from rolamento.tasks.report import calculation_report

RPM = np.pi / 30.0


def case(designation: str = "6310", rpm: float = 1480.0, **changes: Any) -> Case:
    return Case.from_mapping(
        {
            "bearing": {"designation": designation},
            "duty": {"inner_speed": f"{rpm} rpm", "load": {"fz": "5 kN", "fx": "1 kN"}},
            "lubricant": "ISO VG 68",
            "temperature": {"lubricant": "70 degC"},
            **changes,
        }
    )


def test_part_of_the_asperities_by_hand() -> None:
    """6310 at 1480 r/min in 20 mm²/s: exp(-2.6e-8 29600^1.4 80) = exp(-3.777)."""
    part = float(boundary_share(20e-6, 1480 * RPM, 80e-3))
    assert part == pytest.approx(np.exp(-2.6e-8 * 29600.0**1.4 * 80.0))
    assert part == pytest.approx(0.0229, abs=2e-4)
    assert float(boundary_share(20e-6, 0.0, 80e-3)) == 1.0
    assert float(blended(part, 0.12, 0.05)) == pytest.approx(0.05 + 0.07 * part)


def test_the_sliding_coefficient_is_that_of_the_model_of_skf() -> None:
    made = skf_moment(
        series_constants("deep_groove", "63"), speed=np.array([1.0, 50.0, 300.0]),
        bore_diameter=50e-3,
        outside_diameter=110e-3, kinematic_viscosity=20e-6, radial_load=5e3,
    )  # fmt: skip
    part = boundary_share(20e-6, np.array([1.0, 50.0, 300.0]), 80e-3)
    np.testing.assert_allclose(made.sliding_coefficient, blended(part, 0.12, 0.05))


def test_it_falls_from_boundary_to_full_film() -> None:
    found = [coefficient_by_regime(solve(case(rpm=rpm))) for rpm in (0.0, 1.0, 100.0, 1e3, 6e3)]
    likely, low, high = (np.array([one[i].balls[0, 0] for one in found]) for i in range(3))
    assert likely[0] == 0.12
    assert likely[-1] == pytest.approx(0.05)
    assert np.all(np.diff(likely) < 0.0)
    assert np.all((low <= likely) & (likely <= high))
    assert (low[0], high[0]) == (0.12, 0.15)
    assert (low[-1], high[-1]) == pytest.approx((0.04, 0.05))


@pytest.mark.parametrize(
    ("lubricant", "film", "limits"),
    [
        ("ISO VG 68", 0.05, (0.04, 0.05)),
        ("Pennzane SHF X-2000", 0.04, (0.04, 0.05)),
        ("Rheolube 2000", 0.04, (0.04, 0.05)),
        ({"viscosity_40": "68 mm^2/s", "viscosity_100": "8.6 mm^2/s", "density": "880 kg/m^3"},
         0.05, (0.04, 0.05)),
        ({"base_oil": "ISO VG 68", "oil_type": "transmission_fluid"}, 0.1, (0.1, 0.1)),
    ],
)  # fmt: skip
def test_full_film_by_the_type_of_oil(
    lubricant: Any, film: float, limits: tuple[float, float]
) -> None:
    solved = solve(case(rpm=20e3, lubricant=lubricant))
    found = coefficient_by_regime(solved)
    assert found[0].balls[0, 0] == pytest.approx(film, rel=1e-6)
    assert [one.balls[0, 0] for one in found[1:]] == pytest.approx(limits, rel=1e-6)


@pytest.mark.parametrize(
    ("designation", "film"), [("NU 210", 0.02), ("30206", 0.002), ("NA 4910", 0.02)]
)
def test_full_film_of_rollers(designation: str, film: float) -> None:
    load = {"fz": "5 kN", **({"fx": "3 kN"} if designation == "30206" else {})}
    own = case(designation, duty={"inner_speed": "30000 rpm", "load": load})
    found = friction(solve(own))
    assert found.friction_coefficient[0] == pytest.approx(film, rel=1e-6)
    low, high = found.coefficient_range[0]
    assert (low, high) == pytest.approx((0.002, 0.02))
    assert found.torque_range[0, 0] <= found.torque[0] <= found.torque_range[0, 1]


def test_every_grade_on_file_says_its_type() -> None:
    for table in Lubricant.tables():
        lubricant = Lubricant.named(table["name"])
        if lubricant.kind != "dry":
            assert lubricant.oil.oil_type in ("mineral", "synthetic"), table["name"]


# --- what the result says -----------------------------------------------------------------------


def test_the_range_of_the_torque_is_that_of_the_coefficient() -> None:
    solved = solve(case(rpm=50.0))
    found = friction(solved)
    assert found.by_regime
    for index in range(2):
        given = friction(solved, friction_coefficient=float(found.coefficient_range[0, index]))
        assert found.torque_range[0, index] == pytest.approx(given.torque[0], rel=1e-9)
        assert not given.by_regime
        assert given.torque_range[0].tolist() == [given.torque[0]] * 2
    same = friction(solved, friction_coefficient=float(found.friction_coefficient[0]))
    assert same.torque[0] == pytest.approx(found.torque[0], rel=1e-12)
    assert found.starting_torque[0] == pytest.approx(
        friction(solved, friction_coefficient=SLIDING_AT_START).starting_torque[0]
    )


def test_a_full_film_refuses_a_given_coefficient_only() -> None:
    smooth = {
        "inner_roughness": "0.02 um",
        "outer_roughness": "0.02 um",
        "ball_roughness": "0.01 um",
    }
    solved = solve(case(surface=smooth))
    by_regime, given = friction(solved), friction(solved, friction_coefficient=0.05)
    assert by_regime.regime[0] == "full_film"
    assert "jones_full" in by_regime.valid_models()
    assert "jones_full" not in given.valid_models()


def test_the_headline_has_every_note_that_could_change_it() -> None:
    analysis = analyse(case("7014 C DB", 15e3, bearing={
        "designation": "7014 C DB", "spacing": "20 mm", "preload": "240 N"}))  # fmt: skip
    assert analysis.friction is not None
    notes = analysis.friction.qualifications(analysis.solved)
    assert {"inlets_flooded", "coefficient_by_regime"} <= {note.key for note in notes}
    assert {note.key for note in notes} <= {n["key"] for n in analysis.to_mapping()["notes"]}
    page = " ".join(terminal(friction_page(analysis)).split())
    head = page[: page.index("Friction torque by model")]
    assert "power loss, at most" in head
    for note in notes:
        assert note.text in head
    mapping = analysis.friction.to_mapping()
    assert mapping["upper_bound"] is True
    assert mapping["coefficient_by_regime"] is True
    low, high = mapping["torque_range"]
    assert low <= mapping["torque"] <= high


# --- every door ---------------------------------------------------------------------------------


OPTIONS = ("6310", "--fr", "5 kN", "--fa", "1 kN", "--speed", "1480 rpm", "--lubricant",
           "ISO VG 68", "--temperature", "70 degC")  # fmt: skip


@pytest.fixture(scope="module")
def power() -> float:
    found = analyse(case()).friction
    assert found is not None
    return float(found.power[0])


@pytest.mark.parametrize("command", ["friction", "solve"])
def test_commands_need_no_coefficient(command: str, power: float) -> None:
    result = CliRunner().invoke(app, [command, *OPTIONS, "--json"], env={"LC_ALL": "C.UTF-8"})
    assert result.exit_code == 0, result.output
    assert json.loads(result.stdout)["friction"]["power"] == pytest.approx(power, rel=1e-9)
    shown = CliRunner().invoke(app, [command, *OPTIONS], env={"LC_ALL": "C.UTF-8"})
    assert "power loss" in shown.stdout
    assert "by the regime of lubrication" in shown.stdout


def test_a_curve_needs_no_coefficient() -> None:
    result = CliRunner().invoke(
        app, ["friction", *OPTIONS, "--over", "duty.inner_speed=500..3000rpm", "--points", "3",
              "--json"], env={"LC_ALL": "C.UTF-8"},
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    (curve,) = json.loads(result.stdout)["curves"]
    assert np.all(np.array(curve["power"]) > 0.0)
    assert {"palmgren", "skf"} <= set(curve["models"])


def test_a_report_has_the_power(power: float) -> None:
    report = calculation_report([case()])
    text = terminal(report_page(report))
    assert "power loss" in text
    assert f"{power:.4g}" in text
    assert "Friction: requires" not in text


def test_studies_have_the_power(power: float) -> None:
    output = catalogue()["friction_power_jones_full"]
    own = case()
    assert supplied(output, own, ())
    assert output.compute(Evaluation(solve(own)))[0] == pytest.approx(power, rel=1e-9)
    cold = case(temperature=None)
    assert not supplied(output, cold, ())
    assert supplied(output, cold, ("temperature.lubricant",))


def test_batches_are_as_single_cases() -> None:
    speeds = np.array([10.0, 100.0, 300.0])
    many = friction(solve(case(), inner_speed=speeds), model="jones_simplified")
    for index, speed in enumerate(speeds):
        one = friction(solve(case(rpm=speed / RPM)), model="jones_simplified")
        assert many.torque[index] == pytest.approx(one.torque[0], rel=1e-9)
        np.testing.assert_allclose(many.torque_range[index], one.torque_range[0], rtol=1e-9)
        assert many.upper_bound[index] == one.upper_bound[0]


def test_without_a_temperature_this_is_said() -> None:
    cold = case(temperature=None)
    analysis = analyse(cold)
    assert analysis.friction is None
    assert [note.key for note in analysis.notes] == ["no_temperature_no_friction"]
    with pytest.raises(InputError, match="or a coefficient of friction"):
        friction(solve(cold))
