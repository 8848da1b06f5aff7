"""The heat of a machine: conduction along shafts, a set taken apart, spectra, hostile inputs."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, analyse, load_case, shaft
from rolamento.case.machine import Machine, Section, Shaft, machine_of_tables, machine_to_toml
from rolamento.cli.app import app
from rolamento.heat import NODES, heat_balance
from rolamento.heat.machine import (
    _Balance,
    machine_heat,
    section_resistance,
    shaft_conductance,
)

WAYS = {
    "inner_ring_elements": "8 W/K",
    "elements_outer_ring": "9 W/K",
    "inner_ring_shaft": "30 W/K",
    "outer_ring_housing": "60 W/K",
    "shaft_ambient": "1 W/K",
    "housing_ambient": "3 W/K",
}
STIFF = {
    "name": "stiff", "youngs_modulus": "2000 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m^3",
}  # fmt: skip


def spindle(**changes: Any) -> Machine:
    """Two 7014 C back to back, 100 mm apart, on a stiff shaft."""
    parts = [("A", 50, "+x"), ("B", 150, "-x")]
    speed = changes.pop("speed", "4000 rpm")
    tables = {
        "lubricant": "ISO VG 32",
        "shafts": [
            {
                "name": "s",
                "speed": speed,
                "sections": [{"length": "200 mm", "diameter": "70 mm"}],
                "material": STIFF,
            }
        ],
        "bearings": [
            {
                "name": name,
                "shaft": "s",
                "position": f"{x} mm",
                "designation": "7014 C",
                "faces": faces,
                "preload": "240 N",
                "mounting": {"shaft_interference": "0 um", "housing_interference": "0 um"},
                "heat": WAYS,
                **changes.get(name, {}),
            }
            for name, x, faces in parts
        ],
    }
    return machine_of_tables({**tables, **changes.get("tables", {})})


def wheel_shaft(*designations: str, **changes: Any) -> Machine:
    """Deep-groove bearings on a shaft, the first one held."""
    return machine_of_tables(
        {
            "lubricant": "ISO VG 68",
            "heat": WAYS,
            "shafts": [
                {
                    "name": "s",
                    "speed": "3000 rpm",
                    "sections": [{"length": "400 mm", "diameter": "40 mm"}],
                }
            ],
            "bearings": [
                {
                    "name": f"B{index}",
                    "shaft": "s",
                    "position": f"{50 + 150 * index} mm",
                    "designation": designation,
                    **({} if index == 0 else {"located": "floating"}),
                }
                for index, designation in enumerate(designations)
            ],
            "loads": [{"shaft": "s", "position": "125 mm", "fz": "6 kN"}],
            **changes,
        }
    )


# --- the shaft ------------------------------------------------------------------------------------


def test_what_a_shaft_conducts() -> None:
    cylinder = Section(length=0.2, diameter=0.04, bore=0.02)
    assert section_resistance(cylinder) == pytest.approx(0.2 / (np.pi / 4 * (0.04**2 - 0.02**2)))
    cone = Section(length=0.1, diameter=0.03, end_diameter=0.06)
    assert section_resistance(cone) == pytest.approx(4 * 0.1 / (np.pi * 0.03 * 0.06), rel=1e-3)
    both = Shaft(name="s", sections=[cylinder, cone])
    whole = 46.0 / (section_resistance(cylinder) + section_resistance(cone))
    assert shaft_conductance(both, 0.0, 0.3) == pytest.approx(whole)
    assert shaft_conductance(both, 0.3, 0.0) == pytest.approx(whole)
    half = 46.0 / (0.5 * section_resistance(cylinder))
    assert shaft_conductance(both, 0.0, 0.1) == pytest.approx(half)


def test_heat_is_kept_at_every_node() -> None:
    found = machine_heat(wheel_shaft("6208", "6308", heat={**WAYS, "housing_along": "2 W/K"}))
    assert found.converged
    into = np.zeros((2, len(NODES)))
    for index, net in enumerate(found.networks):
        for flow in net.flows(found.temperatures[index], float(found.power[index])):
            for name, sign in ((flow.start, -1.0), (flow.end, 1.0)):
                if name in NODES:
                    into[index, NODES.index(name)] += sign * flow.power
    for link, flow in zip(found.links, found.link_flows(), strict=True):
        for name, node, sign in zip(
            (link.first, link.second), link.nodes, (-1.0, 1.0), strict=True
        ):
            into[found.bearings.index(name), NODES.index(node)] += sign * flow
    assert [link.part for link in found.links] == ["shaft", "housing"]
    np.testing.assert_allclose(into, 0.0, atol=1e-10 * found.power.sum())


def test_a_bearing_without_neighbours_is_the_bearing_alone() -> None:
    """One loaded bearing carries all, the other turns with it: a shaft so thin conducts nothing."""
    machine = wheel_shaft("6208", "6208")
    thin = machine_of_tables(
        {
            **machine.to_mapping(),
            "shafts": [
                {
                    "name": "s",
                    "speed": "3000 rpm",
                    "sections": [{"length": "400 mm", "diameter": "40 mm"}],
                }
            ],
        }
    )
    found = machine_heat(thin)
    alone = found.warm.bearings["B0"].solved.load  # type: ignore[union-attr]
    case = load_case(
        "6208",
        {
            "duty.load.fz": float(alone.fz[0]),
            "duty.inner_speed": "3000 rpm",
            "lubricant": "ISO VG 68",
            **{f"heat.{name}": value for name, value in WAYS.items()},
        },
    )
    own = heat_balance(case)
    # alike on both sides: nothing flows along the shaft
    assert found.power[0] == pytest.approx(own.power, rel=0.02)
    np.testing.assert_allclose(found.power[0], found.power[1], rtol=1e-3)


# --- preload --------------------------------------------------------------------------------------


@pytest.mark.parametrize("warm", [(20.0, 20.0), (50.0, 40.0), (60.0, 60.0), (35.0, 45.0)])
def test_a_set_taken_apart_is_the_set(warm: tuple[float, float]) -> None:
    """Rows of a set and two bearings on a stiff shaft: the same force at the same temperatures."""
    inner, outer = (value + 273.15 for value in warm)
    balance = _Balance(spindle(speed="100 rpm"))
    at = np.tile([inner, 0.5 * (inner + outer), outer, inner, outer], (2, 1))
    force = float(balance.solved(at).bearings["A"].solved.load.fx[0])
    pair = Case(
        bearing={"designation": "7014 C DB", "preload": "240 N", "spacing": "100 mm"},
        duty={"inner_speed": "100 rpm"},
        mounting={"shaft_interference": "0 um", "housing_interference": "0 um"},
        lubricant="ISO VG 32",
        temperature={
            "inner_ring": inner, "balls": 0.5 * (inner + outer), "outer_ring": outer,
            "shaft": inner, "housing": outer,
        },
    )  # fmt: skip
    preload = analyse(pair, quick=True).solved.preload
    assert preload is not None
    assert force == pytest.approx(preload.at_speed, rel=2e-3)  # the shaft gives a little


def test_the_cold_machine_is_the_one_that_shaft_solves() -> None:
    machine = spindle()
    cold = machine_heat(machine).cold.bearings["A"].solved
    own = shaft(machine).bearings["A"].solved
    np.testing.assert_allclose(cold.load.fx, own.load.fx, rtol=1e-6)


def test_a_fixed_shaft_is_pressed_and_a_floating_one_is_not() -> None:
    found = machine_heat(spindle())
    assert found.converged
    assert found.growth < 1.0
    assert found.warm is not None
    cold, warm = (one.bearings["A"].solved.load.fx[0] for one in (found.cold, found.warm))
    assert warm > 1.5 * cold
    spring = {"located": "floating", "spring_force": "240 N", "preload": None}
    sprung = machine_heat(spindle(B=spring, A={"preload": None}))
    assert sprung.warm is not None
    assert sprung.warm.bearings["A"].solved.load.fx[0] == pytest.approx(240.0, rel=1e-6)
    assert sprung.power.sum() < found.power.sum()


def test_past_the_limit_there_is_no_state() -> None:
    still = {**WAYS, "shaft_ambient": "0.1 W/K", "housing_ambient": "30 W/K"}
    found = machine_heat(spindle(speed="12000 rpm", A={"heat": still}, B={"heat": still}))
    assert found.status == "thermal_runaway"
    assert found.warm is None
    assert np.isnan(found.power).all()
    assert found.notes[0].key == "machine_runaway"


def test_heat_from_outside_warms_the_neighbour_along_the_shaft() -> None:
    plain = machine_heat(wheel_shaft("6208", "6208"))
    hot = machine_heat(
        wheel_shaft("6208", "6208", heat={**WAYS, "shaft_heat": "30 W"}),
    )
    assert (hot.temperatures > plain.temperatures).all()


def test_a_spectrum_warms_by_its_mean() -> None:
    steps = [{"share": 0.5, "speed_factor": 1.0}, {"share": 0.5, "speed_factor": 0.01}]
    whole = machine_heat(wheel_shaft("6208", "6208"))
    half = machine_heat(wheel_shaft("6208", "6208", spectrum=steps))
    assert 0.4 * whole.power[0] < half.power[0] < 0.8 * whole.power[0]


# --- files, commands, hostile inputs --------------------------------------------------------------


def test_the_table_survives_its_file(tmp_path: Any) -> None:
    machine = spindle()
    text = machine_to_toml(machine)
    assert "housing_ambient" in text
    assert Machine.from_toml(text) == machine
    (tmp_path / "m.toml").write_text(text, encoding="utf-8")
    picture = str(tmp_path / "m.png")
    run = CliRunner().invoke(
        app, ["shaft", str(tmp_path / "m.toml"), "--heat", "--json", "-", "--plot", picture]
    )
    assert run.exit_code == 0, run.output
    found = json.loads(run.stdout)
    assert found["status"] == "converged"
    assert [one["name"] for one in found["bearings"]] == ["A", "B"]
    page = CliRunner().invoke(app, ["shaft", str(tmp_path / "m.toml"), "--heat", "--lang", "pt"])
    assert "peça mais quente" in page.output
    refused = CliRunner().invoke(
        app, ["shaft", str(tmp_path / "m.toml"), "--heat", "--over", "loads.0.fz=1..2N"]
    )
    assert refused.exit_code == 2


def test_what_is_missing_is_named() -> None:
    with pytest.raises(InputError, match=r"bearings\.0\."):
        machine_heat(wheel_shaft("6208", lubricant=None))
    closed = {**WAYS, "shaft_ambient": "0 W/K", "housing_ambient": "0 W/K"}
    with pytest.raises(InputError, match="no way for the heat"):
        machine_heat(wheel_shaft("6208", "6208", heat=closed))
    with pytest.raises(InputError, match="bearings"):
        machine_heat(
            machine_of_tables(
                {"shafts": [{"name": "s", "sections": [{"length": "1 m", "diameter": "40 mm"}]}]}
            )
        )
