"""The solver against a plain, independent implementation, and against the closed static ones.

The reference (`reference_equilibrium`) shares only the input classes with the package, evaluates
Hertz's contact exactly at every loaded angle, and comes from standstill by raising the speed.
What is left between the two is the polynomial in cos α with which the package replaces the exact
stiffness: 1e-10 or less.
"""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Displacement, Duty, Load, Model
from rolamento.solution import solve
from rolamento.static import axial_load, radial_load


def _load_reference() -> ModuleType:
    """Import the module beside this file: test directories are not packages."""
    path = Path(__file__).with_name("reference_equilibrium.py")
    spec = importlib.util.spec_from_file_location("reference_equilibrium", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


reference = _load_reference()

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.015 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
}
SPINDLE: dict[str, Any] = {
    "ball_count": 21,
    "ball_diameter": "7.144 mm",
    "pitch_diameter": "61 mm",
    "contact_angle": "15 deg",
    "inner_conformity": 0.54,
    "outer_conformity": 0.53,
    "ball_material": "Si3N4",
}


def case(
    title: str,
    bearing: dict[str, Any],
    load: dict[str, Any],
    held: dict[str, Any] | None = None,
    model: dict[str, Any] | None = None,
    **duty: Any,
) -> Case:
    return Case(
        title=title,
        bearing=Bearing(**bearing),
        duty=Duty(load=Load(**load), displacement=Displacement(**held or {}), **duty),
        model=Model(**model or {}),
    )


INNER, SHARED = {"raceway_control": "inner"}, {"raceway_control": "none"}
COMBINED = {"fx": "20 kN", "fz": "8 kN"}
FIVE = {"fx": "20 kN", "fy": "-3 kN", "fz": "9 kN", "my": "200 N m", "mz": "-120 N m"}
CASES = [
    case("combined", ANGULAR, {"fx": "20 kN", "fz": "15 kN"}, inner_speed="10000 rpm"),
    case("axial", ANGULAR, {"fx": "10 kN"}, inner_speed="15000 rpm"),
    case("moments given", ANGULAR, FIVE, inner_speed="8000 rpm"),
    case("x held", ANGULAR, {"fz": "30 kN"}, {"x": 0.0}, inner_speed="6000 rpm"),
    case("tilts held", ANGULAR, COMBINED, {"ry": "0.05 deg", "rz": 5e-4}, inner_speed="1e4 rpm"),
    case("outer turns", ANGULAR, COMBINED, outer_speed="6000 rpm"),
    case("both turn", ANGULAR, COMBINED, inner_speed="9000 rpm", outer_speed="3000 rpm"),
    case("counter", ANGULAR, COMBINED, inner_speed="6000 rpm", outer_speed="-4000 rpm"),
    case("inner control", ANGULAR, COMBINED, model=INNER, inner_speed="9000 rpm"),
    case("inner control, moments", ANGULAR, FIVE, model=INNER, inner_speed="9000 rpm"),
    case(
        "inner control, both turn", ANGULAR, COMBINED, model=INNER,
        inner_speed="9000 rpm", outer_speed="-2000 rpm",
    ),
    case("shared, moments", ANGULAR, FIVE, model=SHARED, inner_speed="12000 rpm"),
    case(
        "no gyroscopic moment", ANGULAR, {"fx": "15 kN", "fz": "15 kN"},
        model={"gyroscopic_moment": False}, inner_speed="15000 rpm",
    ),
    case(
        "no centrifugal force", ANGULAR, {"fx": "25 kN", "fz": "8 kN"},
        model={"centrifugal_force": False}, inner_speed="15000 rpm",
    ),
    case(
        "neither", ANGULAR, {"fx": "15 kN", "fz": "15 kN"},
        model={"centrifugal_force": False, "gyroscopic_moment": False}, inner_speed="15000 rpm",
    ),
    case(
        "ceramic", SPINDLE, {"fx": "500 N", "fy": "100 N", "fz": "600 N"},
        inner_speed="24000 rpm", first_ball_azimuth="4 deg",
    ),
    case(
        "ceramic, shared, moments", SPINDLE, {"fx": "800 N", "fz": "500 N", "my": "2 N m", "mz": 0},
        model=SHARED, inner_speed="24000 rpm",
    ),
    case("free balls", ANGULAR, {"fx": "5 kN", "fz": "25 kN"}, inner_speed="15000 rpm"),
    case(
        "free balls, rigid cage", ANGULAR, {"fx": "5 kN", "fz": "25 kN"}, model={"cage": "rigid"},
        inner_speed="15000 rpm",
    ),
    case(
        "no cage", ANGULAR, {"fx": "10 kN", "fz": "12 kN"}, model={"cage": "none"},
        inner_speed="10000 rpm",
    ),
    case(
        "free balls, outer turns", ANGULAR, {"fx": "5 kN", "fz": "15 kN"}, outer_speed="8000 rpm"
    ),
    case(
        "free balls, inner control", ANGULAR, {"fx": "8 kN", "fz": "20 kN"}, model=INNER,
        inner_speed="10000 rpm",
    ),
    case(
        "free balls, shared", ANGULAR, {"fx": "8 kN", "fz": "20 kN"}, model=SHARED,
        inner_speed="10000 rpm",
    ),
    case("clearance", DEEP_GROOVE, {"fx": "1 kN", "fz": "4 kN"}, inner_speed="8000 rpm"),
    case(
        "clearance, negative axial", DEEP_GROOVE, {"fx": "-1 kN", "fz": "3 kN", "my": 0, "mz": 0},
        inner_speed="8000 rpm",
    ),
    case("clearance, radial", DEEP_GROOVE, {"fz": "8.9 kN"}, inner_speed="5000 rpm"),
    case("at rest, moments", DEEP_GROOVE, {"fx": "1 kN", "fz": "4 kN", "my": "5 N m", "mz": 0}),
    case(
        "interference", DEEP_GROOVE | {"diametral_clearance": "-0.008 mm"},
        {"fx": "0.4 kN", "fz": "2 kN"}, inner_speed="9000 rpm",
    ),
    case(
        "three balls", ANGULAR | {"ball_count": 3}, {"fx": "6 kN", "fz": "1 kN"},
        inner_speed="3000 rpm",
    ),
]  # fmt: skip
TOLERANCE = 1e-9  # of the greatest displacement, load or unit angle; the promise is 1e-7


def assert_close(value: Any, expected: Any, scale: float, tolerance: float = TOLERANCE) -> None:
    assert np.abs(np.asarray(value) - expected).max() <= tolerance * scale


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.title)
@pytest.mark.thirds
def test_independent_implementation(case: Case) -> None:
    expected = reference.solve_reference(case)
    assert expected.error < 1e-10
    batch = solve(case, threads=1)
    assert batch.status.code[0] == "converged"
    balls = batch
    arm = case.bearing.pitch_diameter / 2.0
    lengths = np.array([1.0, 1.0, 1.0, arm, arm])

    shift = expected.displacement * lengths
    assert_close(batch.displacement.array[0] * lengths, shift, np.abs(shift).max())
    load = expected.load / lengths
    assert_close(batch.load.array[0] / lengths, load, np.abs(load).max())
    heaviest = expected.outer.load.max()
    for found, wanted in ((balls.inner, expected.inner), (balls.outer, expected.outer)):
        assert_close(found.load[0], wanted.load, heaviest)
        assert_close(found.deflection[0], wanted.deflection, wanted.deflection.max())
        touching = wanted.load > 1e-12 * heaviest
        np.testing.assert_array_equal(found.load[0] > 1e-12 * heaviest, touching)
        assert_close(found.contact_angle[0, touching], wanted.angle[touching], 1.0)
    assert_close(balls.elements.centrifugal_force[0], expected.centrifugal_force, heaviest)
    diameter = case.bearing.ball_diameter
    assert_close(
        balls.elements.gyroscopic_moment[0], expected.gyroscopic_moment, heaviest * diameter
    )
    if not case.duty.inner_speed and not case.duty.outer_speed:
        return
    orbit = expected.orbital_speed
    assert_close(balls.elements.orbital_speed[0], orbit, np.abs(orbit).max())


def test_reference_gives_a_printed_number() -> None:
    """Radaelli (2013), table 5.4: the reference is not merely like the package."""
    found = reference.solve_reference(CASES[0])
    assert found.displacement[2] == pytest.approx(0.0989e-3, abs=0.5e-7)
    assert found.gyroscopic_moment.max() < 0.0


@pytest.mark.parametrize("clearance", ["0.015 mm", "0 mm", "-0.01 mm"])
@pytest.mark.parametrize("azimuth", [0.0, 0.3])
def test_radial_load_at_rest(clearance: str, azimuth: float) -> None:
    bearing = Bearing(**DEEP_GROOVE | {"diametral_clearance": clearance})
    loads = np.array([20.0, 500.0, 8900.0])
    closed = radial_load(bearing, loads, distribution="discrete", first_ball_azimuth=azimuth)
    free = Case(bearing=bearing, duty=Duty(first_ball_azimuth=azimuth))
    batch = solve(free, fz=loads)
    assert batch.converged.all()
    scale = float(closed.radial_displacement.max())
    assert_close(batch.displacement.array[:, 2], closed.radial_displacement, scale)
    assert_close(batch.displacement.array[:, 1], closed.lateral_displacement, scale)
    assert_close(batch.displacement.array[:, [0, 3, 4]], 0.0, scale)
    for row, largest in enumerate(closed.max_ball_load):
        assert_close(batch.inner.load[row], closed.ball_loads[row], float(largest))


@pytest.mark.parametrize("bearing", [ANGULAR, SPINDLE, DEEP_GROOVE], ids=["40°", "15°", "clear"])
def test_axial_load_at_rest(bearing: dict[str, Any]) -> None:
    given = Bearing(**bearing)
    loads = np.array([10.0, 500.0, 17800.0])
    closed = axial_load(given, loads)
    batch = solve(Case(bearing=given, duty=Duty()), fx=loads, my=0.0, mz=0.0)
    assert batch.converged.all()
    balls = batch
    for row in range(3):
        travel = float(closed.axial_displacement[row])
        assert_close(batch.displacement.array[row, 0], travel, travel)
        assert_close(batch.displacement.array[row, 1:], 0.0, travel)
        assert_close(balls.inner.load[row], closed.ball_load[row], float(closed.ball_load[row]))
        for contact in (balls.inner, balls.outer):
            assert_close(contact.contact_angle[row], closed.contact_angle[row], 1.0)
