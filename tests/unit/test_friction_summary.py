"""The summary of friction: torque, power, heat by source, and which models hold."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

import rolamento as ro
from rolamento import Case
from rolamento.errors import InputError
from rolamento.friction import CONTACT_MODELS, MachineBearing, friction
from rolamento.friction.skf import SkfConstants
from rolamento.solution import solve
from rolamento.solved import Solved

OIL = MachineBearing(
    kind="angular_contact",
    bore_diameter=90e-3,
    outside_diameter=160e-3,
    kinematic_viscosity=20e-6,
    static_load_rating=120e3,
    static_load_ratio=0.2,
    contact_angle=float(np.radians(40.0)),
    constants=SkfConstants("angular_contact", 4e-7, 2.0, 1.5e-2, 0.7, k_z=4.4),
)


@pytest.fixture(scope="module")
def slow(case_218: Case) -> Solved:
    return solve(ro.override(case_218, ["duty.inner_speed=20 rpm"]))


@pytest.fixture(scope="module")
def fast(case_218: Case) -> Solved:
    return solve(case_218)


def test_heat_by_source_and_contact_is_the_power(slow: Solved) -> None:
    found = friction(slow, friction_coefficient=0.1, dynamic_viscosity=0.05)
    assert set(found.heat) == {"spin", "rolling_slip", "hysteresis", "rolling_resistance"}
    heat = sum(loss.total for loss in found.heat.values())
    np.testing.assert_allclose(heat, found.power, rtol=1e-12)
    np.testing.assert_allclose(sum(found.torque_by_source.values()), found.torque, rtol=1e-12)
    np.testing.assert_allclose(found.power, found.torque * 20.0 * np.pi / 30.0, rtol=1e-12)
    assert all(loss.inner.shape == (1, 16) for loss in found.heat.values())


def test_what_is_printed_shows_no_rounding(slow: Solved) -> None:
    found = friction(slow, friction_coefficient=0.1)
    parts = {"spin": np.array([1e-31]), "rolling_slip": np.array([0.05]), "rib": np.array([np.nan])}
    shown = repr(replace(found, torque_by_source=parts))
    assert "\n  torque by source, N mm: spin 0, rolling_slip 50, rib nan\n" in shown
    parts["rib"] = np.array([0.02])
    shown = repr(replace(found, torque_by_source=parts))
    assert "\n  torque by source, N mm: spin 0, rolling_slip 50, rib 20\n" in shown


def test_mapping_is_plain_json(slow: Solved, case_218: Case) -> None:
    found = friction(slow, friction_coefficient=0.1, machine=OIL, film_parameter=0.5)
    read = json.loads(json.dumps(found.to_mapping(), allow_nan=False))
    assert read["torque"] == found.torque[0]
    heat = sum(sum(of[race]) for of in read["heat"].values() for race in ("inner", "outer"))
    assert heat == pytest.approx(read["power"])
    assert len(read["heat"]["spin"]["inner"]) == 16
    assert read["friction_coefficient"] == 0.1
    assert read["models"]["skf"]["valid"] is False
    assert read["models"]["skf"]["reasons"][0]["key"] == "no_film"
    unsolved = solve(ro.override(case_218, ["duty.load.fx=-20 kN"]))
    none = friction(unsolved, friction_coefficient=0.1).to_mapping()
    assert none["torque"] is None
    json.dumps(none, allow_nan=False)


def test_all_models_of_a_state_and_one_of_a_batch(slow: Solved, case_218: Case) -> None:
    found = friction(slow, friction_coefficient=0.1, machine=OIL)
    assert set(found.models) == {*CONTACT_MODELS, "palmgren", "skf"}
    batch = solve(case_218, inner_speed=[1.0, 2.0])
    assert set(friction(batch, friction_coefficient=0.1).models) == {"jones_full"}
    both = friction(batch, friction_coefficient=0.1, compare=True, model="todd")
    assert set(both.models) == set(CONTACT_MODELS)
    expected = both.models["todd"].total + both.torque_by_source["hysteresis"]
    np.testing.assert_allclose(both.torque, expected)


def test_inertia_takes_the_low_speed_models_out(slow: Solved, fast: Solved) -> None:
    assert friction(slow, friction_coefficient=0.1).valid_models() == CONTACT_MODELS
    found = friction(fast, friction_coefficient=0.1, machine=OIL)
    assert found.valid_models() == ("palmgren", "skf")
    noted = {validity.model: set(validity.notes) for validity in found.validity}
    assert noted["jones_full"] == {"inertia"}
    assert noted["skf"] == set()


@pytest.mark.parametrize(
    ("film", "regime", "holding"),
    [
        (0.4, "boundary", set(CONTACT_MODELS)),
        (2.0, "mixed", {*CONTACT_MODELS, "palmgren", "skf"}),
        (5.0, "full_film", {"palmgren", "skf"}),
    ],
)
def test_film_decides(slow: Solved, film: float, regime: str, holding: set[str]) -> None:
    found = friction(slow, friction_coefficient=0.1, film_parameter=film, machine=OIL)
    assert found.regime[0] == regime
    assert set(found.valid_models()) == holding
    for validity in found.validity:
        assert all(note.text.endswith(".") for note in validity.notes_of())


def test_film_of_every_case_of_a_batch(case_218: Case) -> None:
    batch = solve(case_218, inner_speed=[1.0, 1.0, 0.0])
    found = friction(batch, friction_coefficient=0.1, film_parameter=[0.5, 4.0, np.nan])
    assert list(found.regime) == ["boundary", "full_film", "unknown"]
    (validity,) = found.validity
    assert list(validity.valid) == [True, False, True]
    assert list(validity.notes["torque_at_rest"]) == [False, False, True]
    assert found.power[2] == 0.0
    assert found.torque[2] > 0.0


def test_starting_torque_by_the_static_coefficient(slow: Solved) -> None:
    found = friction(slow, friction_coefficient=0.1, static_coefficient=0.15)
    sliding = found.torque_by_source["spin"] + found.torque_by_source["rolling_slip"]
    expected = 1.5 * sliding + found.torque_by_source["hysteresis"]
    np.testing.assert_allclose(found.starting_torque, expected)
    same = friction(slow, friction_coefficient=0.1, dynamic_viscosity=0.05)
    no_oil = same.torque - same.torque_by_source["rolling_resistance"]
    np.testing.assert_allclose(same.starting_torque, no_oil)


def test_unsolved_state_has_no_torque(case_218: Case) -> None:
    unsolved = solve(ro.override(case_218, ["duty.load.fx=-20 kN"]))
    assert not unsolved.converged[0]
    found = friction(unsolved, friction_coefficient=0.1, dynamic_viscosity=0.05)
    assert np.isnan(found.torque).all()
    assert np.isnan(found.power).all()
    assert found.valid_models() == ()
    assert all(validity.notes["torque_unknown"].all() for validity in found.validity)


def test_frictionless_bearing_loses_only_by_hysteresis(slow: Solved) -> None:
    found = friction(slow, friction_coefficient=0.0)
    np.testing.assert_allclose(found.torque, found.torque_by_source["hysteresis"])
    assert friction(slow, friction_coefficient=0.0, hysteresis=0.0).torque[0] == 0.0


@pytest.mark.parametrize(
    ("wrong", "field"),
    [
        ({"model": "coulomb"}, "model"),
        ({"friction_coefficient": -1.0}, "friction_coefficient"),
        ({"static_coefficient": 2.0}, "static_coefficient"),
        ({"hysteresis": -0.1}, "hysteresis"),
        ({"dynamic_viscosity": -0.1}, "dynamic_viscosity"),
        ({"control": "both"}, "control"),
        ({"friction_coefficient": "much"}, "friction_coefficient"),
        ({"friction_coefficient": [0.1, 0.2]}, "friction_coefficient"),
        ({"film_parameter": [0.1, 0.2]}, "film_parameter"),
        ({"friction_coefficient": None}, "lubricant.friction_coefficient"),
    ],
)
def test_wrong_arguments_are_named(slow: Solved, wrong: dict[str, object], field: str) -> None:
    given: dict[str, object] = {"friction_coefficient": 0.1, **wrong}
    with pytest.raises(InputError, match=field):
        friction(slow, **given)  # type: ignore[arg-type]
