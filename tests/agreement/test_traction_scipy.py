"""Balls that friction controls, against a plain model in vectors solved by SciPy.

`benchmarks/friction_model.py` shares the input classes with the package and nothing else. With a
wide smoothing the friction is smooth and two different quadratures meet closely; with the
package's own, what is left are the kinks of Coulomb's law between the nodes.
"""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.one_case import solve_one

from rolamento import Bearing, Case, Displacement, Load, Lubricant, Model
from rolamento import Duty as CaseDuty
from rolamento.rows.ball.traction import solve as traction

ROOT = Path(__file__).resolve().parents[2]
MU = 0.08


@pytest.fixture(scope="module")
def rival() -> Any:
    """The model that stands beside the package."""
    sys.path.insert(0, str(ROOT))
    try:
        return importlib.import_module("benchmarks.friction_model")
    finally:
        sys.path.remove(str(ROOT))


def bearing(balls: int, **changes: Any) -> Bearing:
    given: dict[str, Any] = {
        "ball_count": balls,
        "ball_diameter": "12 mm",
        "pitch_diameter": "60 mm",
        "contact_angle": "25 deg",
        "inner_conformity": 0.53,
        "outer_conformity": 0.52,
    }
    return Bearing(**{**given, **changes})


def case_of(of: Bearing, duty: CaseDuty, **model: Any) -> Case:
    return Case(
        bearing=of,
        duty=duty,
        model=Model(raceway_control="friction", **model),
        lubricant=Lubricant(kind="dry", friction_coefficient=MU),
    )


def solved_by_scipy(
    rival: Any,
    state: SimpleNamespace,
    nodes: tuple[int, int],
    smoothing: list[float],
    drag: float = 0.0,
) -> Any:
    """The rival's solution, from a place a little off the package's."""
    case, rolling = state.case, state.rolling
    assert rolling is not None
    duty = rival.Duty(
        np.array(case.duty.applied_load),
        np.array(case.duty.imposed_displacement),
        np.array(case.duty.free),
        case.duty.inner_speed,
        case.duty.outer_speed,
        MU,
        drag,
    )
    places = np.array([place_of(case, ball) for ball in state.balls])
    spins = np.array([spin_of(ball, motion) for ball, motion in pairs(state)])
    start = rival.Found(
        True, 1.002 * np.array(state.displacement), 1.002 * rolling.cage_speed, places + 1e-7,
        1.002 * spins, 0.0, 0.0,
    )  # fmt: skip
    return rival.FrictionModel(case.bearing, *nodes).solve(duty, start, smoothing)


def pairs(state: SimpleNamespace) -> list[tuple[Any, Any]]:
    assert state.rolling is not None
    return list(zip(state.balls, state.rolling.balls, strict=True))


def place_of(case: Case, ball: Any) -> tuple[float, float]:
    length = (case.bearing.outer_conformity - 0.5) * case.bearing.ball_diameter
    reach = length + ball.outer.deflection
    return reach * np.sin(ball.outer.contact_angle), reach * np.cos(ball.outer.contact_angle)


def spin_of(ball: Any, motion: Any) -> tuple[float, float, float]:
    x, along, out = motion.angular_velocity
    c, s = np.cos(ball.azimuth), np.sin(ball.azimuth)
    return x, along * c + out * s, -along * s + out * c


THRUST = CaseDuty(inner_speed="12000 rpm", load=Load(fx="1500 N"))
COMBINED = CaseDuty(inner_speed="9000 rpm", load=Load(fx="2 kN", fy="200 N", fz="500 N"))
TILTING = CaseDuty(
    inner_speed="6000 rpm", outer_speed="-1000 rpm", load=Load(fx="2 kN", fz="300 N", my=1.0, mz=0)
)
HELD = CaseDuty(inner_speed="8000 rpm", load=Load(fz="300 N"), displacement=Displacement(x=2e-5))


@pytest.mark.parametrize(
    ("balls", "duty", "drag"),
    [(3, THRUST, 0.0), (3, COMBINED, 0.0), (4, TILTING, 0.05), (3, HELD, 0.0)],
)
def test_smooth_friction_agrees_closely(
    rival: Any, monkeypatch: pytest.MonkeyPatch, balls: int, duty: CaseDuty, drag: float
) -> None:
    monkeypatch.setattr(traction, "SMOOTHING", 0.02)
    monkeypatch.setattr(traction, "SMOOTHEST", 0.2)
    state = solve_one(case_of(bearing(balls), duty, cage_drag=drag))
    assert state.status.converged
    assert state.rolling is not None
    found = solved_by_scipy(rival, state, (32, 64), [0.02], drag)
    assert found.success
    assert found.cage == pytest.approx(state.rolling.cage_speed, rel=1e-6)
    assert found.power == pytest.approx(state.rolling.power, rel=1e-6)
    assert found.torque == pytest.approx(state.rolling.inner_torque, rel=1e-6)
    size = np.linalg.norm(state.displacement)
    np.testing.assert_allclose(found.ring, state.displacement, rtol=0, atol=1e-6 * size)
    spins = np.array([spin_of(*pair) for pair in pairs(state)])
    np.testing.assert_allclose(found.speeds, spins, rtol=0, atol=1e-6 * np.abs(spins).max())


@pytest.mark.parametrize("duty", [THRUST, COMBINED])
def test_friction_as_sharp_as_it_is_solved(rival: Any, duty: CaseDuty) -> None:
    state = solve_one(case_of(bearing(3, ball_material="Si3N4"), duty))
    assert state.status.converged
    assert state.rolling is not None
    found = solved_by_scipy(rival, state, (40, 80), [0.1, 0.01, 1e-3, 1e-4])
    assert found.success
    assert found.cage == pytest.approx(state.rolling.cage_speed, rel=1e-4)
    assert found.power == pytest.approx(state.rolling.power, rel=2e-3)
    spins = np.array([spin_of(*pair) for pair in pairs(state)])
    np.testing.assert_allclose(found.speeds, spins, rtol=0, atol=2e-3 * np.abs(spins).max())


def test_balls_of_the_218_in_thrust(rival: Any, bearing_218: Bearing) -> None:
    """One ball of sixteen carries its share: the symmetry that the rival's one ball rests on."""
    duty = CaseDuty(inner_speed="10000 rpm", load=Load(fx="20 kN"))
    state = solve_one(case_of(bearing_218, duty))
    one = bearing_218.model_copy(update={"ball_count": 1})
    share = CaseDuty(
        inner_speed="10000 rpm", load=Load(fx="1250 N"), displacement=Displacement(y=0.0, z=0.0)
    )
    assert state.rolling is not None
    start = solve_one(case_of(bearing_218, duty, mesh="coarse"))
    duty_of_one = rival.Duty(
        np.array(share.applied_load), np.zeros(5), np.array(share.free),
        share.inner_speed, 0.0, MU,
    )  # fmt: skip
    first = rival.Found(
        True, np.array(start.displacement), start.rolling.cage_speed,  # type: ignore[union-attr]
        np.array([place_of(start.case, start.balls[0])]),
        np.array([spin_of(*pairs(start)[0])]), 0.0, 0.0,
    )  # fmt: skip
    found = rival.FrictionModel(one, 40, 80).solve(duty_of_one, first, [1e-3, 1e-4])
    assert found.success
    assert found.cage == pytest.approx(state.rolling.cage_speed, rel=1e-4)
    assert 16.0 * found.power == pytest.approx(state.rolling.power, rel=1e-3)
