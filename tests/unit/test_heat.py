"""The heat balance: the network, its roots, what becomes of the preload, and hostile inputs."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, analyse, load_case
from rolamento.cli.app import app
from rolamento.friction.palmgren import palmgren
from rolamento.heat import (
    CONDUCTANCES,
    NODES,
    HeatBalance,
    Network,
    heat_balance,
)
from rolamento.heat.balance import _Balances
from rolamento.oil.state import oil_state
from rolamento.speeds import reference_heat_flow

RPM = np.pi / 30.0
ZERO = 273.15
GIVEN = {
    "inner_ring_elements": 8.0,
    "elements_outer_ring": 9.0,
    "inner_ring_shaft": 30.0,
    "outer_ring_housing": 60.0,
    "shaft_ambient": 2.0,
    "housing_ambient": 5.0,
}


def network(**changes: float) -> Network:
    own = {name: changes.pop(name, value) for name, value in GIVEN.items()}
    rest = {"oil": 0.0, "ambient": 293.15, "oil_inlet": 293.15, "outside": (0.0, 0.0)}
    return Network(conductances=own, **{**rest, "inner_share": 0.5, **changes})  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def wheel() -> Case:
    """A deep-groove bearing whose friction is Palmgren's."""
    return load_case(
        "6220",
        {
            "duty.load.fz": "10 kN",
            "duty.inner_speed": "3000 rpm",
            "lubricant": "ISO VG 68",
            "heat.friction": "palmgren",
        },
    )


@pytest.fixture(scope="module")
def pair() -> Case:
    """A rigid spindle pair with grease, that a shaft of its own heats through."""
    return Case(
        bearing={"designation": "7014 C DB", "preload": "240 N", "spacing": "20 mm"},
        duty={"inner_speed": "6000 rpm"},
        mounting={"shaft_interference": "5 um", "housing_interference": "-2 um"},
        lubricant="ISO VG 32",
        heat={"shaft_ambient": 2.0, "housing_ambient": 6.0},
    )


# --- the network ----------------------------------------------------------------------------------


def test_a_chain_by_hand() -> None:
    """All heat at the inner ring, and only the housing lets it out: five resistances in a row."""
    found = network(inner_share=1.0, shaft_ambient=0.0).temperatures(90.0)
    drop = 90.0 / np.array([8.0, 9.0, 60.0, 5.0])
    inner, elements, outer, shaft, housing = found - 293.15
    np.testing.assert_allclose(housing, drop[3])
    np.testing.assert_allclose(outer, drop[2:].sum())
    np.testing.assert_allclose(elements, drop[1:].sum())
    np.testing.assert_allclose([inner, shaft], drop.sum())


def test_temperatures_are_linear_in_the_friction_and_the_heat_is_kept() -> None:
    net = network(oil=15.0, oil_inlet=313.15, outside=(20.0, -7.0))
    at = net.temperatures(np.array([0.0, 50.0, 100.0]))
    np.testing.assert_allclose(at[:, 1], 0.5 * (at[:, 0] + at[:, 2]))
    for node in NODES:
        flows = net.flows(at[:, 2], 100.0)
        balance = sum(one.power for one in flows if one.end == node) - sum(
            one.power for one in flows if one.start == node
        )
        assert abs(balance) < 1e-10 * 100.0
    out = sum(one.power for one in net.flows(at[:, 2], 100.0) if one.end in ("ambient", "oil"))
    assert out == pytest.approx(100.0 + 20.0 - 7.0, rel=1e-10)


def test_a_perfect_sink_and_no_way_out() -> None:
    sink = network(**dict.fromkeys(GIVEN, 1e9))
    np.testing.assert_allclose(sink.temperatures(1e3), 293.15, atol=1e-5)
    assert network(housing_ambient=1e-9, shaft_ambient=1e-9).most_power(423.15) < 1e-5
    with pytest.raises(InputError, match="leaves no way for the heat"):
        network(housing_ambient=0.0, shaft_ambient=0.0).temperatures(1.0)
    with pytest.raises(InputError, match=r"heat\.inner_ring_shaft"):
        network(inner_ring_shaft=0.0, shaft_ambient=0.0).temperatures(1.0)


def test_oil_alone_takes_the_heat_at_its_inlet_temperature() -> None:
    still = dict.fromkeys(("shaft_ambient", "housing_ambient"), 0.0)
    found = network(oil=30.0, oil_inlet=313.15, **still).temperatures(60.0)
    assert found[NODES.index("elements")] == pytest.approx(313.15 + 2.0)


def test_the_estimates_are_those_of_the_guide(wheel: Case) -> None:
    found = heat_balance(wheel).network
    assert set(found.estimated) == set(CONDUCTANCES)
    d, outside, width = 0.1, 0.18, 0.034
    flow = reference_heat_flow(d, outside, width) / 50.0
    both = found.conductances["shaft_ambient"] + found.conductances["housing_ambient"]
    assert both == pytest.approx(flow)
    assert found.conductances["housing_ambient"] / both == pytest.approx(outside / (d + outside))
    assert found.conductances["inner_ring_shaft"] == pytest.approx(5e3 * np.pi * d * width)
    given = heat_balance(wheel.with_({"heat.housing_ambient": "7 W/K"})).network
    assert given.conductances["housing_ambient"] == 7.0
    assert "housing_ambient" not in given.estimated


# --- the balance ----------------------------------------------------------------------------------


def test_palmgrens_friction_over_the_temperature_and_the_balance(wheel: Case) -> None:
    found = heat_balance(wheel)
    rings = found.curve.temperatures[[0, 2]].mean(axis=0)
    assert wheel.lubricant is not None
    state = oil_state(wheel.lubricant, rings)
    speed = 3000.0 * RPM
    published = wheel.bearing.published
    assert published is not None
    assert published.static_rating is not None
    closed = palmgren(
        kind="deep_groove",
        lubrication="oil_bath",
        speed=np.full(len(rings), speed),
        mean_diameter=0.14,
        kinematic_viscosity=state.kinematic_viscosity,
        radial_load=10e3,
        axial_load=0.0,
        static_load_ratio=10e3 / published.static_rating,
    )
    np.testing.assert_allclose(found.curve.friction, closed.total * speed, rtol=1e-3)
    root = found.root
    assert root is not None
    assert found.warm is not None
    assert found.warm.power == pytest.approx(root.power, rel=1e-7)
    assert sum(one.power for one in found.flows if one.end == "ambient") == pytest.approx(
        root.power, rel=1e-10
    )
    assert root.stable
    assert root.slope < 0.0


def test_the_warm_state_is_the_analysis_of_the_case_with_its_temperatures(pair: Case) -> None:
    found = heat_balance(pair)
    assert found.converged
    assert found.warm is not None
    alone = analyse(found.warm.case)
    assert alone.friction is not None
    assert found.root is not None
    assert float(alone.friction.power[0]) == pytest.approx(found.power, rel=1e-6)
    assert alone.solved.preload is not None
    assert found.warm.preload == pytest.approx(alone.solved.preload.at_speed, rel=1e-9)


def test_the_root_does_not_depend_on_the_grid(pair: Case, monkeypatch: pytest.MonkeyPatch) -> None:
    power = heat_balance(pair).power
    for points in (7, 33):
        monkeypatch.setattr("rolamento.heat.balance._POINTS", points)
        assert heat_balance(pair).power == pytest.approx(power, rel=1e-7)


class Made(_Balances):
    """A balance whose friction is a formula of the warmest temperature."""

    def __init__(self, case: Case, friction: object) -> None:
        super().__init__(case, {}, (case,), None)
        self.formula = friction

    def friction_over(
        self, temperatures: np.ndarray, which: np.ndarray, factor: np.ndarray | float = 1.0
    ) -> np.ndarray:
        return np.asarray(factor * self.formula(temperatures.max(axis=0)))  # type: ignore[operator]

    def looked_at(
        self, temperatures: np.ndarray, which: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, object]:
        torque, _, batch = super().looked_at(temperatures, which)
        return torque, self.friction_over(temperatures, which), batch

    def answer(self, look_for_speed: bool) -> HeatBalance:
        return self.answers(look_for_speed)[0]


def folded(warm: np.ndarray) -> np.ndarray:
    """Friction that falls, and rises again where the preload grows."""
    return 200.0 * np.exp(-(warm - 293.15) / 40.0) + 8e-4 * (warm - 293.15) ** 3


def test_two_roots_are_found_and_the_colder_one_is_the_answer(wheel: Case) -> None:
    found = Made(wheel, folded).answer(look_for_speed=True)
    assert [root.stable for root in found.roots] == [True, False]
    assert found.root is found.roots[0]
    for root in found.roots:
        assert folded(np.array(max(root.temperatures.values()))) == pytest.approx(root.power)
    assert "hotter_unstable_state" in [note.key for note in found.notes]
    low, high = (max(root.temperatures.values()) for root in found.roots)
    assert low < high < found.limit


def test_a_pair_of_roots_between_two_points_of_the_grid_is_found(
    wheel: Case, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Just below the speed at which they merge both lie within a step of the grid."""
    wheel = wheel.with_({"heat.inner_ring_elements": 9.0, "heat.elements_outer_ring": 9.0})
    found = Made(wheel, lambda warm: 4.0 * folded(warm)).answer(look_for_speed=True)
    assert found.status == "thermal_runaway"
    assert found.merges
    assert 0.0 < found.runaway < 1.0
    below = Made(wheel, lambda warm: 4.0 * (found.runaway - 1e-4) * folded(warm))
    assert below.answer(look_for_speed=False).converged
    above = Made(wheel, lambda warm: 4.0 * (found.runaway + 1e-3) * folded(warm))
    assert above.answer(look_for_speed=False).status == "thermal_runaway"


def test_a_runaway_has_no_numbers_and_names_the_speed_with_a_state(pair: Case) -> None:
    fast = pair.with_({"duty.inner_speed": "14000 rpm"})
    found = heat_balance(fast)
    assert found.status == "thermal_runaway"
    assert found.warm is None
    assert np.isnan(found.power)
    assert all(np.isnan(list(found.temperatures.values())))
    assert found.notes[0].key == "thermal_runaway"
    assert "rpm" in found.notes[0].text
    speed = found.runaway_speeds[0]
    assert 0.0 < speed < fast.duty.inner_speed
    assert heat_balance(fast.with_({"duty.inner_speed": 0.999 * speed})).converged
    assert not heat_balance(
        fast.with_({"duty.inner_speed": 1.002 * speed}), look_for_speed=False
    ).converged


def test_a_duty_without_a_solution_keeps_its_status(wheel: Case) -> None:
    found = heat_balance(wheel.with_({"duty.load.fz": "9000 kN"}))
    assert found.status == str(
        analyse(wheel.with_({"duty.load.fz": "9000 kN"})).solved.status.code[0]
    )
    assert found.status != "converged"
    assert found.warm is None


def test_at_rest_nothing_warms_it(wheel: Case) -> None:
    found = heat_balance(wheel.with_({"duty.inner_speed": "0 rpm"}))
    assert found.converged
    assert found.power == 0.0
    assert set(found.temperatures.values()) == {293.15}


# --- preload --------------------------------------------------------------------------------------


def preload(case: Case, **temperatures: float) -> float:
    warm = {f"temperature.{name}": ZERO + value for name, value in temperatures.items()}
    found = analyse(case.with_(warm), quick=True).solved.preload
    assert found is not None
    return found.at_speed


def test_a_spring_keeps_its_force_and_a_rigid_pair_does_not(pair: Case) -> None:
    still = pair.with_({"duty.inner_speed": "1000 rpm"})
    spring = still.with_({"bearing.preload": {"spring": "240 N"}})
    sprung = heat_balance(spring.with_({"duty.inner_speed": "6000 rpm"}))
    assert sprung.warm is not None
    assert sprung.cold.preload is not None
    assert sprung.warm.preload == pytest.approx(sprung.cold.preload, rel=0.02)
    forces = [preload(still, inner_ring=20.0 + rise, outer_ring=20.0) for rise in (0, 5, 10)]
    assert forces[0] < forces[1] < forces[2]


def test_along_the_shaft_o_is_relieved_x_is_loaded_and_there_is_a_neutral_distance(
    pair: Case,
) -> None:
    """A warm shaft lengthens: far apart that wins over the growth across, in O pairs."""
    warm = {"inner_ring": 30.0, "outer_ring": 20.0, "shaft": 30.0, "housing": 20.0}
    cool = dict.fromkeys(warm, 20.0)

    def change(arrangement: str, spacing: float) -> float:
        case = pair.with_(
            {
                "bearing.designation": f"7014 C {arrangement}",
                "bearing.spacing": spacing,
                "duty.inner_speed": "100 rpm",
            }
        )
        return preload(case, **warm) - preload(case, **cool)

    near, far = change("DB", 0.02), change("DB", 0.4)
    assert near > 0.0 > far
    assert change("DF", 0.4) > change("DF", 0.02) > 0.0
    low, high = 0.02, 0.4
    for _ in range(12):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if change("DB", middle) > 0.0 else (low, middle)
    assert abs(change("DB", low)) < 0.02 * near


# --- what is refused, and what is said ------------------------------------------------------------


@pytest.mark.parametrize(
    ("field", "value", "rule"),
    [
        ("heat.limit", "10 degC", "above the ambient temperature"),
        ("heat.oil_inlet", "40 degC", "has no effect without oil_flow"),
        ("heat.inner_share", "1.2", "at most 1"),
        ("heat.housing_ambient", "-1 W/K", "at least 0 W/K"),
        ("heat.oil_flow", "3 mm", "flow rate"),
        ("heat.friction", "coulomb", "must be one of"),
    ],
)
def test_wrong_inputs_are_named(field: str, value: str, rule: str) -> None:
    with pytest.raises(InputError, match=rule):
        load_case("6220", [f"{field}={value}"])


def test_missing_sizes_are_named() -> None:
    case = Case(
        bearing={"ball_count": 9, "ball_diameter": 0.01, "pitch_diameter": 0.05,
                 "inner_conformity": 0.52, "outer_conformity": 0.52, "contact_angle": 0.26},
        duty={"inner_speed": "2000 rpm", "load": {"fx": "500 N"}},
        lubricant="ISO VG 32",
    )  # fmt: skip
    with pytest.raises(InputError, match=r"heat\.bore"):
        heat_balance(case)
    sized = case.with_(
        {"heat.bore": "35 mm", "heat.outside_diameter": "65 mm", "heat.width": "14 mm"}
    )
    assert heat_balance(sized).converged
    with pytest.raises(InputError, match=r"heat\.friction"):
        heat_balance(sized.with_({"heat.friction": "palmgren"}))
    with pytest.raises(InputError, match=r"friction_coefficient|lubricant"):
        heat_balance(sized.with_({"lubricant": None}))


def test_thrust_bearings_need_their_conductances() -> None:
    case = load_case(
        "51108", {"duty.load.fx": "5 kN", "duty.inner_speed": "500 rpm", "lubricant": "ISO VG 68"}
    )
    with pytest.raises(InputError, match="for radial bearings"):
        heat_balance(case)
    ways = {name: 5.0 for name in GIVEN if not name.startswith("inner_ring_e")}
    assert heat_balance(case.with_({f"heat.{name}": value for name, value in ways.items()})).warm


def test_what_the_balance_rests_on_is_said(wheel: Case, pair: Case) -> None:
    keys = [note.key for note in heat_balance(wheel).notes]
    assert {"conductances_estimated", "heat_without_mounting"} <= set(keys)
    hot = heat_balance(wheel.with_({"temperature.lubricant": "70 degC"}))
    assert "lubricant_keeps_temperature" in [note.key for note in hot.notes]
    assert hot.root is not None
    assert hot.root.slope == pytest.approx(0.0, abs=1e-9)
    given = pair.with_({"temperature.inner_ring": "60 degC", "temperature.outer_ring": "50 degC"})
    found = heat_balance(given)
    assert "temperatures_of_balance" in [note.key for note in found.notes]
    assert found.power == pytest.approx(heat_balance(pair).power, rel=1e-9)
    outside = heat_balance(wheel.with_({"heat.shaft_heat": "100 kW"}))
    assert outside.status == "thermal_runaway"
    assert outside.notes[0].key == "heated_past_limit"


def test_json_is_exact_and_whole(pair: Case) -> None:
    found = heat_balance(pair)
    mapping = json.loads(found.to_json())
    assert mapping["temperatures"] == found.temperatures
    assert mapping["power"] == found.power
    assert Case.from_mapping(mapping["warm"]["case"]) == found.warm.case  # type: ignore[union-attr]
    runaway = heat_balance(pair.with_({"duty.inner_speed": "16000 rpm"}), look_for_speed=False)
    assert json.loads(runaway.to_json())["temperatures"] == dict.fromkeys(NODES)


def test_records_are_frozen(pair: Case) -> None:
    found = heat_balance(pair)
    with pytest.raises(AttributeError):
        found.status = "converged"  # type: ignore[misc]
    assert replace(found, status="not_converged").root is None


# --- the command ----------------------------------------------------------------------------------

COMMAND = ["heat", "6220", "--fr", "10 kN", "--speed", "3000 rpm", "--lubricant", "ISO VG 68"]


def test_the_command_shows_and_draws(tmp_path: object) -> None:
    run = CliRunner().invoke(app, [*COMMAND, "--plot", f"{tmp_path}/heat.png"])
    assert run.exit_code == 0, run.output
    for part in ("Temperatures", "Heat flows", "Cold and warm", "stable"):
        assert part in run.output
    in_portuguese = CliRunner().invoke(app, [*COMMAND, "--lang", "pt"])
    assert "Fluxos de calor" in in_portuguese.output


def test_the_command_over_a_field(tmp_path: object) -> None:
    over = ["--over", "duty.inner_speed=1000..4000rpm", "--points", "3"]
    run = CliRunner().invoke(app, [*COMMAND[:4], *COMMAND[6:], *over, "--json", "-"])
    assert run.exit_code == 0, run.output
    found = json.loads(run.stdout)
    power = found["power"]
    assert power[0] < power[1] < power[2]
    assert len(found["temperatures"]["housing"]) == 3
    drawn = CliRunner().invoke(app, [*COMMAND, *over, "--plot", f"{tmp_path}/over.png"])
    assert drawn.exit_code == 0, drawn.output
    refused = CliRunner().invoke(app, [*COMMAND, "--over", "temperature.housing=20..60degC"])
    assert refused.exit_code == 2


def test_the_command_without_a_state_ends_with_one() -> None:
    run = CliRunner().invoke(app, [*COMMAND, "--set", "heat.limit=30 degC"])
    assert run.exit_code == 1
    assert "no stable temperature" in run.output
