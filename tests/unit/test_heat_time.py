"""Heat in time, and what a balance is asked for: transients, plans, springs, oil, speeds."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from typer.testing import CliRunner

from rolamento import Case, InputError, load_case
from rolamento.case.heat import HeatStep
from rolamento.cli.app import app
from rolamento.heat import NODES, heat_balance, heat_balances, heat_transient
from rolamento.heat.answers import highest_speed, neutral_distance, oil_needed, variants_of
from rolamento.heat.network import capacities_of
from rolamento.heat.transient import _Course
from rolamento.heat.warmed import Warmed
from rolamento.tasks.heat import heat_answers, limit_of_text, warm_up

RPM = np.pi / 30.0


@pytest.fixture(scope="module")
def pair() -> Case:
    """A rigid spindle pair."""
    return Case(
        bearing={"designation": "7014 C DB", "preload": "240 N", "spacing": "20 mm"},
        duty={"inner_speed": "6000 rpm"},
        mounting={"shaft_interference": "5 um", "housing_interference": "-2 um"},
        lubricant="ISO VG 32",
        heat={"shaft_ambient": 2.0, "housing_ambient": 6.0},
    )


@pytest.fixture(scope="module")
def wheel() -> Case:
    """A deep-groove bearing without a mounting."""
    return load_case(
        "6220", {"duty.load.fz": "10 kN", "duty.inner_speed": "3000 rpm", "lubricant": "ISO VG 68"}
    )


# --- in time --------------------------------------------------------------------------------------


def test_in_time_it_comes_to_the_steady_state(pair: Case) -> None:
    steady = heat_balance(pair)
    assert steady.warm is not None
    found = heat_transient(pair, 20.0 * 3600.0)
    assert found.converged
    for node in NODES:
        assert found.final[node] == pytest.approx(steady.temperatures[node], abs=1e-5)
    assert found.power[-1] == pytest.approx(steady.power, rel=1e-6)
    assert found.preload[-1] == pytest.approx(steady.warm.preload, rel=1e-5)
    assert found.preload[0] == pytest.approx(steady.cold.preload, rel=1e-9)


def test_the_preload_passes_a_maximum_that_no_steady_state_knows(pair: Case) -> None:
    found = heat_transient(pair, 3600.0)
    largest, when = found.largest_preload
    assert largest > 1.5 * found.preload[-1]
    assert 60.0 < when < 900.0
    inner, housing = (found.temperatures[NODES.index(node)] for node in ("inner_ring", "housing"))
    assert np.argmax(inner - housing) < len(found) - 1


def test_it_is_what_a_general_integrator_finds(wheel: Case) -> None:
    """LSODA at 1e-8 with the friction itself in every evaluation."""
    found = heat_transient(wheel, 1800.0)
    warmed = Warmed(wheel)
    net = found.network
    matrix, source, share = net.equations()

    def change(_: float, at: np.ndarray) -> np.ndarray:
        power = warmed.power(at[:, np.newaxis])[0]
        return (source + power * share - matrix @ (at - net.ambient)) / found.capacities

    times = [60.0, 600.0, 1800.0]
    exact = solve_ivp(
        change, (0.0, 1800.0), found.temperatures[:, 0], "LSODA", times, rtol=1e-8, atol=1e-6
    )
    for place, time in enumerate(times):
        own = [np.interp(time, found.time, one) for one in found.temperatures]
        tolerance = 0.01 if time == found.time[-1] else 0.2  # the points lie minutes apart
        np.testing.assert_allclose(own, exact.y[:, place], atol=tolerance)


def test_heat_is_kept(pair: Case) -> None:
    """What friction gave is stored or gone to the surroundings: the integral over time."""
    found = heat_transient(pair, 1200.0)
    stored = found.capacities @ (found.temperatures[:, -1] - found.temperatures[:, 0])
    g = found.network.conductances
    gone = g["shaft_ambient"] * (found.temperatures[3] - found.network.ambient) + g[
        "housing_ambient"
    ] * (found.temperatures[4] - found.network.ambient)
    given = np.trapezoid(found.power, found.time)
    assert stored + np.trapezoid(gone, found.time) == pytest.approx(given, rel=2e-3)


def test_without_friction_a_node_cools_by_its_own_time_constant(wheel: Case) -> None:
    """One node that only the surroundings cool: an exponential, by hand."""
    alone = dict.fromkeys(
        ("inner_ring_elements", "elements_outer_ring", "outer_ring_housing"), 1e-9
    )
    still = wheel.with_(
        {
            "duty.inner_speed": 0.0,
            **{f"heat.{name}": value for name, value in alone.items()},
            "heat.inner_ring_shaft": 1e-9,
            "heat.housing_ambient": 5.0,
            "heat.housing_capacity": 3000.0,
        }
    )
    found = heat_transient(still, 900.0, start={"housing": 353.15})
    assert found.final["housing"] - 293.15 == pytest.approx(60.0 * np.exp(-900.0 / 600.0), rel=1e-6)


def test_steps_follow_each_other(pair: Case) -> None:
    steps = (
        HeatStep(duration=600.0, speed_factor=0.5, name="slow"),
        HeatStep(duration=1200.0),
        HeatStep(duration=600.0, speed_factor=0.0),
    )
    found = heat_transient(pair.with_({"heat.steps": [one.to_mapping() for one in steps]}))
    assert found.steps == steps
    assert found.time[-1] == pytest.approx(2400.0)
    assert set(found.speed) == {0.5, 1.0, 0.0}
    assert found.power[-1] == 0.0
    slow = heat_transient(pair, steps=steps[:1])
    at = np.argmin(np.abs(found.time - 600.0))
    np.testing.assert_allclose(found.temperatures[:, at], slow.temperatures[:, -1], atol=1e-6)
    hottest = found.temperatures[0]
    assert hottest.max() > hottest[-1]


def test_past_the_limit_it_ends_and_says_when(pair: Case) -> None:
    hot = pair.with_({"duty.inner_speed": "16000 rpm"})
    found = heat_transient(hot, 3600.0)
    assert found.status == "thermal_runaway"
    assert found.temperatures.max() <= 423.15
    assert found.notes[0].key == "limit_passed_at"
    assert found.time[-1] < 3600.0


def test_capacities_are_those_of_the_guide(wheel: Case) -> None:
    values, estimated = capacities_of(wheel)
    assert len(estimated) == 5
    shaft = 460.0 * 7800.0 * 0.25 * np.pi * 0.1**2 * 3.0 * 0.034
    assert values[NODES.index("shaft")] == pytest.approx(shaft)
    given, rest = capacities_of(wheel.with_({"heat.shaft_capacity": "2 kJ/K"}))
    assert given[NODES.index("shaft")] == 2000.0
    assert "shaft_capacity" not in rest
    assert heat_transient(wheel, 60.0).notes[1].key == "capacities_estimated"


def test_no_duration_is_refused(wheel: Case) -> None:
    with pytest.raises(InputError, match="steps in"):
        heat_transient(wheel)
    with pytest.raises(InputError, match="cannot be combined"):
        heat_transient(wheel, 10.0, steps=(HeatStep(duration=10.0),))
    with pytest.raises(InputError, match="greater than"):
        HeatStep(duration=0.0)


def test_an_overloaded_bearing_keeps_its_status(wheel: Case) -> None:
    found = heat_transient(wheel.with_({"duty.load.fz": "9000 kN"}), 600.0)
    assert found.status not in ("converged", "thermal_runaway")
    assert len(found) == 1


def test_json_of_time_reads_back(pair: Case) -> None:
    found = heat_transient(pair, 300.0)
    mapping = json.loads(found.to_json())
    assert mapping["largest_preload"]["value"] == found.largest_preload[0]
    assert len(mapping["temperatures"]["shaft"]) == len(found)


# --- plans ----------------------------------------------------------------------------------------


def test_a_plan_stays_below_the_limit_that_full_speed_breaks(pair: Case) -> None:
    plan = warm_up(pair, preload=4000.0)
    assert plan.needed
    assert plan.transient is not None
    assert plan.at_once.largest_preload[0] > 4000.0
    assert plan.transient.largest_preload[0] <= 4000.0
    factors = [step.speed_factor for step in plan.steps]
    assert factors == sorted(factors)
    assert factors[-1] == 1.0


def test_a_limit_below_the_steady_state_has_no_plan(pair: Case) -> None:
    assert warm_up(pair, preload=2000.0).transient is None
    assert not warm_up(pair, temperature=400.0).needed
    with pytest.raises(InputError, match="one of them"):
        warm_up(pair)
    with pytest.raises(InputError, match="preload or a temperature"):
        limit_of_text("3 mm")
    assert limit_of_text("60 degC")["temperature"] == pytest.approx(333.15)


# --- answers --------------------------------------------------------------------------------------


def test_many_balances_are_those_of_one(pair: Case) -> None:
    speeds = np.array([1000.0, 4000.0, 20000.0]) * RPM
    for one, speed in zip(heat_balances(pair, {"duty.inner_speed": speeds}), speeds, strict=True):
        own = pair.with_({"duty.inner_speed": float(speed)})
        alone = heat_balance(own, look_for_speed=False)
        assert one.status == alone.status
        np.testing.assert_allclose(one.power, alone.power, rtol=1e-7)
    cooled = heat_balances(pair, {"heat.housing_ambient": np.array([6.0, 9.0])})
    assert cooled[0].power == pytest.approx(heat_balance(pair).power, rel=1e-9)
    alone = heat_balance(pair.with_({"heat.housing_ambient": 9.0}))
    assert cooled[1].power == pytest.approx(alone.power, rel=1e-9)
    assert cooled[1].power > cooled[0].power  # a colder housing presses harder


def test_springs_keep_their_force_and_ceramic_grows_less(pair: Case) -> None:
    found = {one.name: one.balance for one in variants_of(pair)}
    assert set(found) == {"as_given", "spring", "ceramic"}
    spring, ceramic, own = found["spring"].warm, found["ceramic"].warm, found["as_given"].warm
    assert spring is not None
    assert ceramic is not None
    assert own is not None
    assert spring.preload == pytest.approx(240.0, rel=1e-6)
    assert ceramic.preload < own.preload  # type: ignore[operator]
    sprung = pair.with_({"bearing.preload": {"spring": 240.0}})
    assert [one.name for one in variants_of(sprung)] == ["as_given", "rigid", "ceramic"]
    hybrid = pair.with_({"bearing.ball_material": "Si3N4"})
    assert "steel" in [one.name for one in variants_of(hybrid)]


def test_at_the_neutral_distance_the_preload_is_that_of_the_cold_set(pair: Case) -> None:
    found = heat_balance(pair)
    neutral = neutral_distance(found)
    assert neutral is not None
    far = pair.with_({"bearing.spacing": neutral.distance})
    at = {f"temperature.{name}": found.temperatures[node] for name, node in
          (("inner_ring", "inner_ring"), ("balls", "elements"), ("outer_ring", "outer_ring"),
           ("shaft", "shaft"), ("housing", "housing"))}  # fmt: skip
    cool = dict.fromkeys(at, 293.15)
    from rolamento import analyse

    preloads = []
    for temperatures in (cool, at):
        solved = analyse(far.with_(temperatures), quick=True).solved
        assert solved.preload is not None
        preloads.append(solved.preload.at_speed)
    assert preloads[1] == pytest.approx(preloads[0], rel=2e-3)
    assert (
        neutral_distance(heat_balance(pair.with_({"bearing.preload": {"spring": 240.0}}))) is None
    )


def test_an_x_pair_has_no_neutral_distance(pair: Case) -> None:
    face = pair.with_({"bearing.designation": "7014 C DF", "duty.inner_speed": "2000 rpm"})
    neutral = neutral_distance(heat_balance(face))
    assert neutral is not None
    assert np.isnan(neutral.distance)


def test_beyond_the_highest_speed_there_is_no_state(pair: Case) -> None:
    factor, _ = highest_speed(heat_balance(pair))
    assert factor > 1.0
    speed = pair.duty.inner_speed
    below, above = (pair.with_({"duty.inner_speed": speed * factor * x}) for x in (0.999, 1.002))
    assert heat_balance(below).converged
    assert not heat_balance(above, look_for_speed=False).converged
    assert np.isnan(highest_speed(heat_balance(pair.with_({"duty.inner_speed": 0.0})))[0])


def test_the_oil_that_is_needed_keeps_it_cool(pair: Case) -> None:
    flow = oil_needed(pair, 333.15)
    for factor, cool in ((1.002, True), (0.99, False)):
        found = heat_balance(pair.with_({"heat.oil_flow": factor * flow}))
        assert (max(found.temperatures.values()) <= 333.15) is cool
    assert oil_needed(pair, 390.0) == 0.0
    with pytest.raises(InputError, match="above that of the oil"):
        oil_needed(pair, 290.0)


def test_all_answers_and_the_speed_of_the_standard() -> None:
    case = load_case(
        "6210",
        {"duty.load.fz": "2 kN", "duty.inner_speed": "3000 rpm", "lubricant": "ISO VG 32"},
    )
    found = heat_answers(case, 340.0)
    assert found.neutral is None
    assert found.permissible_speed > 0.0
    assert found.speed > case.duty.inner_speed
    assert json.loads(found.to_json())["oil"]["limit"] == 340.0


def test_a_course_does_not_depend_on_its_tolerance(
    wheel: Case, monkeypatch: pytest.MonkeyPatch
) -> None:
    coarse = heat_transient(wheel, 1800.0)
    monkeypatch.setattr("rolamento.heat.transient.TOLERANCE", 0.001)
    fine = heat_transient(wheel, 1800.0)
    assert len(fine) > len(coarse)
    np.testing.assert_allclose(coarse.temperatures[:, -1], fine.temperatures[:, -1], atol=0.01)
    assert isinstance(_Course(wheel, (), None).capacities, np.ndarray)


# --- the command ----------------------------------------------------------------------------------

COMMAND = ["heat", "6220", "--fr", "10 kN", "--speed", "3000 rpm", "--lubricant", "ISO VG 68"]


def test_the_command_in_time(tmp_path: object) -> None:
    plot, table = f"{tmp_path}/time.png", f"{tmp_path}/time.csv"
    run = CliRunner().invoke(app, [*COMMAND, "--time", "10 min", "--plot", plot, "--csv", table])
    assert run.exit_code == 0, run.output
    assert "In time" in run.output
    with open(table, encoding="utf-8") as lines:
        assert len(lines.readlines()) > 20
    data = CliRunner().invoke(app, [*COMMAND, "--time", "10 min", "--json", "-"])
    assert json.loads(data.stdout)["time"][-1] == pytest.approx(600.0)


def test_the_command_with_answers() -> None:
    run = CliRunner().invoke(app, [*COMMAND, "--compare", "--oil-for", "45 degC"])
    assert run.exit_code == 0, run.output
    for part in ("highest speed", "ceramic elements", "l/min"):
        assert part in run.output
    spoken = CliRunner().invoke(app, [*COMMAND, "--compare", "--lang", "pt"])
    assert "corpos cerâmicos" in spoken.output


def test_the_command_with_a_plan() -> None:
    run = CliRunner().invoke(app, [*COMMAND, "--warm-up", "80 degC"])
    assert run.exit_code == 0, run.output
    assert "Full speed at once stays below" in run.output


@pytest.mark.parametrize(
    ("options", "rule"),
    [
        (["--time", "3 mm"], "--time"),
        (["--time", "steps"], "steps in"),
        (["--time", "1 h", "--compare"], "cannot be combined"),
        (["--oil-for", "60 degC"], "needs --compare"),
        (["--warm-up", "3 mm"], "preload or a temperature"),
        (["--warm-up", "500 N"], "has none"),
    ],
)
def test_options_that_make_no_sense(options: list[str], rule: str) -> None:
    run = CliRunner().invoke(app, [*COMMAND, *options])
    assert run.exit_code == 2, run.output
    assert rule in " ".join(run.output.replace("│", " ").split())
