"""Balls that one race holds, or none: laws of random duties, and cases that once broke them.

The laws are those of `benchmarks.laws`, worked out anew from the numbers that a user gets: Hertz's
exact theory, every ball and the ring in balance, all contacts on their grooves, all orbits between
the rings' speeds. `make bench` takes a million cases through them.
"""

from __future__ import annotations

import importlib
import math
import sys
from collections import Counter
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.one_case import solve_one

from rolamento import Bearing, Case, Displacement, Duty, Load, Model
from rolamento.solution import solve

Floats = NDArray[np.float64]
RPM = math.pi / 30.0

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 8,
    "ball_diameter": "10.319 mm",
    "pitch_diameter": "44.5 mm",
    "inner_conformity": 0.505,
    "outer_conformity": 0.53,
}
CONTROLS = ["outer", "inner", "none"]


@pytest.fixture(scope="module")
def laws() -> ModuleType:
    """The benchmark of the laws, which stands beside the package."""
    root = str(Path(__file__).resolve().parents[2])
    sys.path.insert(0, root)
    try:
        return importlib.import_module("benchmarks.laws")
    finally:
        sys.path.remove(root)


def test_laws_of_random_duties(laws: ModuleType) -> None:
    random, worst, counts = np.random.default_rng(21), laws.Worst(), Counter[str]()
    for _ in range(30):  # `make bench` tries a million
        case = laws.random_case(random)
        duty = laws.random_duty(random, case.bearing, 100)
        batch = solve(case, **duty)
        counts.update(batch.status.code.tolist())
        assert (batch.status.residual[batch.converged] <= 1e-8).all()
        laws.check(case, batch, duty, worst)
    broken = {law: (worst.values[law], worst.cases[law]) for law in worst.values}
    assert not +worst.broken, {law: broken[law] for law in worst.broken if worst.broken[law]}
    total = sum(counts.values())
    assert counts["converged"] > 0.8 * total
    assert counts["not_converged"] <= 0.01 * total


def case_of(speeds: tuple[float, float], **model: Any) -> Case:
    duty = Duty(inner_speed=speeds[0] * RPM, outer_speed=speeds[1] * RPM)
    return Case(bearing=Bearing(**ANGULAR), duty=duty, model=Model(**model))


@pytest.mark.parametrize("clearance", [0.0, 20e-6, 50e-6, 60e-6, 100e-6, 200e-6])
@pytest.mark.parametrize("load", [500.0, 5e3, 10.8e3])
def test_at_rest_both_races_press_alike_and_no_groove_is_a_full_circle(
    clearance: float, load: float
) -> None:
    """The ball opposite the load is far from its groove, on the open side of it."""
    bearing = Bearing(diametral_clearance=clearance, **DEEP_GROOVE)
    batch = solve(Case(bearing=bearing, duty=Duty()), fz=[load])
    balls = batch
    np.testing.assert_allclose(balls.inner.load, balls.outer.load, rtol=1e-9, atol=1e-9 * load)
    carried = (balls.inner.load * np.cos(balls.elements.azimuth)).sum()
    assert carried == pytest.approx(load, rel=1e-8)
    away = np.cos(balls.elements.azimuth) < -1e-9
    assert (balls.inner.load[away] == 0.0).all()


def test_a_ball_past_the_edge_of_its_groove_is_not_pressed() -> None:
    """45°, lightly loaded: the groove leaves some balls, and the ring comes to rest without them.

    The displacement is that of the rule that a contact presses at |α| < 90° only.
    """
    bearing = Bearing(**ANGULAR | {
        "contact_angle": "45 deg", "inner_conformity": 0.515, "outer_conformity": 0.525,
    })  # fmt: skip
    duty = Duty(load=Load(fx=1e3, fz=1e3), inner_speed=2865.0 * RPM)
    state = solve_one(Case(bearing=bearing, duty=duty))
    assert state.status.converged
    assert state.displacement.z == pytest.approx(144.3e-6, abs=0.05e-6)
    assert all(
        abs(ball.inner.contact_angle) < math.pi / 2 for ball in state.balls if ball.inner.load > 0
    )


def test_a_shoulder_ends_the_groove() -> None:
    """A heavy thrust carries a deep-groove bearing's contacts up to its shoulder, and not beyond.

    With a given height h the groove ends where cos α = 1 - h/(f D).
    """
    thrust = np.linspace(1e3, 12e3, 23)
    high = Bearing(diametral_clearance="0.03 mm", **DEEP_GROOVE)
    angles = solve(Case(bearing=high, duty=Duty()), fx=thrust).inner.contact_angle
    edge = float(angles[11:13, 0].mean())  # of neither, which the last digit would decide
    height = 0.505 * 10.319e-3 * (1.0 - math.cos(edge))
    low = Bearing(diametral_clearance="0.03 mm", inner_shoulder_height=height, **DEEP_GROOVE)
    batch = solve(Case(bearing=low, duty=Duty()), fx=thrust)
    np.testing.assert_array_equal(batch.converged, angles[:, 0] < edge)
    assert set(batch.status.code[~batch.converged]) <= {"over_shoulder", "no_equilibrium"}
    assert np.isnan(batch.displacement.array[~batch.converged]).all()


def test_quarter_turns_are_alike() -> None:
    """At zero clearance the balls at 90° and 270° of a radial load are mirror images."""
    bearing = Bearing(diametral_clearance=0.0, **DEEP_GROOVE)
    for speed in (0.0, 6000.0 * RPM):
        duty = Duty(load=Load(fz=2e3), inner_speed=speed)
        state = solve_one(Case(bearing=bearing, duty=duty))
        left, right = state.balls[2], state.balls[6]
        for one, other in ((left.inner, right.inner), (left.outer, right.outer)):
            assert one.load == pytest.approx(other.load, abs=1e-15)
            assert one.contact_angle == pytest.approx(other.contact_angle, abs=1e-9)
            assert one.max_pressure == pytest.approx(other.max_pressure, abs=1e3)
        assert left.orbital_speed == pytest.approx(right.orbital_speed, rel=1e-12)
        assert left.centrifugal_force == pytest.approx(right.centrifugal_force, rel=1e-12)


@pytest.mark.parametrize("cage", ["loose", "rigid", "none"])
@pytest.mark.parametrize("control", CONTROLS)
def test_turned_about_and_mirrored_duties(control: str, cage: str) -> None:
    """The speeds reversed: the same loads. The load to the other side: the mirror image."""
    model = {"raceway_control": control, "cage": cage}
    forth, back = case_of((9e3, 2e3), **model), case_of((-9e3, -2e3), **model)
    loads: dict[str, Any] = {"fx": 8e3, "fz": np.array([5e3, 15e3]), "fy": 1e3}
    one, other = solve(forth, **loads), solve(back, **loads)
    mirror = solve(forth, **loads | {"fy": -1e3})
    np.testing.assert_array_equal(one.status.number, other.status.number)
    done = one.converged
    scale = np.nanmax(np.abs(one.displacement.array[:, :3]))
    np.testing.assert_allclose(
        one.displacement.array[done], other.displacement.array[done], atol=1e-7 * scale
    )
    flip = np.array([1.0, -1.0, 1.0, 1.0, 1.0])
    np.testing.assert_allclose(
        one.displacement.array[done], (mirror.displacement.array * flip)[done], atol=1e-7 * scale
    )


def test_light_load_at_speed_has_an_equilibrium() -> None:
    """Found by continuation from rest: the ring is far from where it stands without speed."""
    bearing = Bearing(
        ball_count=9, ball_diameter="33.67 mm", pitch_diameter="164.77 mm",
        diametral_clearance="0.116 mm", inner_conformity=0.548, outer_conformity=0.519,
    )  # fmt: skip
    duty = Duty(
        load=Load(fz=0.698, fy=-0.203), displacement=Displacement(x=-1.65e-6),
        inner_speed=-8398.0 * RPM,
    )  # fmt: skip
    state = solve_one(Case(bearing=bearing, duty=duty))
    assert state.status.converged
    assert state.status.residual < 1e-8


def test_work_without_end_is_cut_short() -> None:
    """500 balls at 89° under loads that nothing supports: a name, not a quarter of an hour."""
    bearing = Bearing(
        ball_count=500, ball_diameter="12.2656 mm", pitch_diameter="3507.4 mm",
        contact_angle="89 deg", inner_conformity=0.52, outer_conformity=1.0,
        ring_material={"youngs_modulus": "2000 GPa", "poisson_ratio": 0.3,
                       "density": "100 kg/m^3"},
    )  # fmt: skip
    duty = Duty(load=Load(fy=6538.57, fz=653.857), inner_speed=1e-9 * RPM, outer_speed=-500.0 * RPM)
    state = solve_one(Case(bearing=bearing, duty=duty))
    assert not state.status.converged


@pytest.mark.parametrize("ratio", [0.1, 0.25, 0.35, 0.5, 0.6, 0.75, 0.85])
def test_stiffness_is_exact_at_any_size_of_ball(laws: ModuleType, ratio: float) -> None:
    """Loads against Hertz's exact theory for balls up to what three of them leave room for."""
    worst = laws.Worst()
    count = max(3, min(40, int(math.pi / math.asin(ratio))))
    bearing = Bearing(
        ball_count=count, ball_diameter=0.02, pitch_diameter=0.02 / ratio,
        contact_angle="35 deg", inner_conformity=0.52, outer_conformity=0.53,
    )  # fmt: skip
    case = Case(bearing=bearing, duty=Duty())
    fields = {
        "fx": np.linspace(1e3, 8e3, 20), "fz": np.linspace(0.0, 4e3, 20),
        "inner_speed": np.linspace(0.0, 500.0, 20), "outer_speed": np.zeros(20),
    }  # fmt: skip
    batch = solve(case, **fields)
    assert batch.converged.all()
    laws.check(case, batch, fields, worst)
    assert worst.values["inner load against exact Hertz"] < 1e-9
    assert worst.values["outer load against exact Hertz"] < 1e-9
    assert not +worst.broken
