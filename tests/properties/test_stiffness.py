"""The 5×5 stiffness is the derivative of the solver, speed effects and moving balls included.

Two ways to differentiate: every displacement held, and the reactions followed; every load given,
and the displacements followed, which is the inverse. Five-point differences, so that what remains
is the solver's own precision.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from rolamento import Bearing, Case, Duty, Model
from rolamento.case.duty import AXES, LOADS
from rolamento.contact.hertz import contact_stiffness, effective_modulus, series_stiffness
from rolamento.geometry import race_curvature, ring_geometry
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]

ANGULAR = Bearing(
    ball_count=16,
    ball_diameter="22.23 mm",
    pitch_diameter="125.26 mm",
    contact_angle="40 deg",
    inner_conformity=0.5232,
    outer_conformity=0.5232,
)
DEEP_GROOVE = Bearing(
    ball_count=9,
    ball_diameter="12.7 mm",
    pitch_diameter="65 mm",
    diametral_clearance="0.015 mm",
    inner_conformity=0.515,
    outer_conformity=0.53,
)
CERAMIC = Bearing(
    ball_count=21,
    ball_diameter="7.144 mm",
    pitch_diameter="61 mm",
    contact_angle="15 deg",
    inner_conformity=0.56,
    outer_conformity=0.54,
    ball_material="Si3N4",
)
MOMENTS = {"my": 150.0, "mz": -80.0}
SLOW, FAST = {"inner_speed": 300.0}, {"inner_speed": 1000.0}
# name: bearing, control, duty
POINTS: dict[str, tuple[Bearing, Any, dict[str, float]]] = {
    "at rest": (ANGULAR, "outer", {"fx": 20e3, "fz": 9e3, **MOMENTS}),
    "axial": (ANGULAR, "outer", {"fx": 10e3, "my": 0.0, "mz": 0.0, **FAST}),
    "combined": (ANGULAR, "outer", {"fx": 20e3, "fy": 3e3, "fz": 15e3, **FAST}),
    "moments": (ANGULAR, "outer", {"fx": 20e3, "fz": 9e3, **MOMENTS, **FAST}),
    "tilted": (ANGULAR, "outer", {"fx": 20e3, "fz": 9e3, "ry": 5e-4, "rz": -3e-4, **FAST}),
    "light": (ANGULAR, "outer", {"fx": 800.0, "fz": 900.0, **FAST}),
    "inner control": (ANGULAR, "inner", {"fx": 20e3, "fz": 6e3, **MOMENTS, **FAST}),
    "shared": (ANGULAR, "none", {"fx": 20e3, "fz": 9e3, **MOMENTS, **FAST}),
    "outer turns": (ANGULAR, "outer", {"fx": 20e3, "fz": 9e3, **MOMENTS, "outer_speed": 800.0}),
    "counter": (
        ANGULAR, "outer", {"fx": 20e3, "fz": 6e3, "inner_speed": 700.0, "outer_speed": -500.0},
    ),
    "shared, both turn": (
        ANGULAR, "none", {"fx": 20e3, "fz": 6e3, "inner_speed": 900.0, "outer_speed": 300.0},
    ),
    "ceramic": (CERAMIC, "outer", {"fx": 600.0, "fz": 500.0, "my": 1.0, "inner_speed": 2500.0}),
    "clearance": (DEEP_GROOVE, "outer", {"fx": 1e3, "fz": 4e3, **SLOW}),
    "other side": (DEEP_GROOVE, "outer", {"fx": -1e3, "fz": 1e3, "my": 2.0, "mz": 1.0, **FAST}),
}  # fmt: skip
WEIGHTS = {-2: 1.0 / 12.0, -1: -2.0 / 3.0, 1: 2.0 / 3.0, 2: -1.0 / 12.0}


def solved(bearing: Bearing, control: Any, **fields: Any) -> Solved:
    case = Case(bearing=bearing, duty=Duty(), model=Model(raceway_control=control))
    batch = solve(case, **fields)
    assert batch.converged.all()
    return batch


def lengths(bearing: Bearing) -> Floats:
    """What makes tilts shifts, and moments forces: one unit for the whole matrix."""
    arm = ring_geometry(bearing).inner_groove_radius
    return np.array([1.0, 1.0, 1.0, arm, arm])


def derivative(start: Floats, steps: Floats, names: tuple[str, ...], evaluate: Any) -> Floats:
    """Five-point derivative of five results by five inputs; columns by input."""
    places = [(column, shift) for column in range(5) for shift in WEIGHTS]
    inputs = np.repeat(start[np.newaxis], len(places), axis=0)
    for row, (column, shift) in enumerate(places):
        inputs[row, column] += shift * steps[column]
    results = evaluate(dict(zip(names, inputs.T, strict=True)))
    matrix = np.zeros((5, 5))
    for row, (column, shift) in enumerate(places):
        matrix[:, column] += WEIGHTS[shift] * results[row] / steps[column]
    return matrix


@pytest.mark.parametrize("name", POINTS)
def test_reactions_by_displacements(name: str) -> None:
    bearing, control, duty = POINTS[name]
    point = solved(bearing, control, **duty)
    unit = lengths(bearing)
    speeds = {key: value for key, value in duty.items() if key.endswith("speed")}

    def reactions(inputs: dict[str, Floats]) -> Floats:
        return solved(bearing, control, **inputs, **speeds).load.array

    deepest = max(point.inner.deflection.max(), 1e-6)
    numeric = derivative(point.displacement.array[0], 2e-3 * deepest / unit, AXES, reactions)
    scaled, expected = (k / np.outer(unit, unit) for k in (point.stiffness.array[0], numeric))
    error = np.abs(scaled - expected).max() / np.abs(expected).max()
    assert error < 2e-9, error


@pytest.mark.parametrize("name", [name for name, point in POINTS.items() if "my" in point[2]])
def test_displacements_by_loads(name: str) -> None:
    """The compliance with all loads given is the inverse of the stiffness."""
    bearing, control, duty = POINTS[name]
    point = solved(bearing, control, **duty | {"mz": duty.get("mz", 0.0)})
    unit = lengths(bearing)
    speeds = {key: value for key, value in duty.items() if key.endswith("speed")}

    def displacements(inputs: dict[str, Floats]) -> Floats:
        return solved(bearing, control, **inputs, **speeds).displacement.array

    steps = 1e-3 * duty["fx"] * unit
    numeric = derivative(point.load.array[0], np.abs(steps), LOADS, displacements)
    product = point.stiffness.array[0] @ numeric * np.outer(1.0 / unit, unit)
    np.testing.assert_allclose(product, np.eye(5), atol=1e-5)


def skew_of_stiffness_turning_with_the_angle(batch: Solved, bearing: Bearing) -> Floats:
    """K(x, z) - K(z, x) and K(x, y) - K(y, x) that a stiffness K(α) leaves.

    A contact whose stiffness depends on its angle has the force K(α) δ^1.5 n, which is no
    gradient: the torque -∂/∂α of the energy ⅖ K δ^2.5 is left out, as by all who evaluate Hertz's
    stiffness at the loaded angle. The skew part per ball is -dK/dα δ^1.5/|A|.
    """
    balls, ring = batch, ring_geometry(bearing)
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)

    def series(angle: Floats) -> Floats:
        both = []
        for race in ("inner", "outer"):
            conformity = getattr(bearing, f"{race}_conformity")
            curvature = race_curvature(
                bearing.ball_diameter, bearing.pitch_diameter, conformity, angle, race
            )
            both.append(contact_stiffness(curvature.rolling, curvature.across, modulus))
        return np.asarray(series_stiffness(*both))

    angle, h = balls.inner.contact_angle[0], 1e-4
    slope = (series(angle + h) - series(angle - h)) / (2.0 * h)
    approach = (balls.inner.deflection + balls.outer.deflection)[0]
    skew = -slope * approach**1.5 / (ring.groove_centre_distance + approach)
    c, s = np.cos(balls.elements.azimuth[0]), np.sin(balls.elements.azimuth[0])
    return np.array([(skew * c).sum(), (skew * s).sum()])


@pytest.mark.parametrize(
    ("bearing", "duty", "largest"),
    [
        (ANGULAR, {"fx": 20e3, "fz": 9e3, "my": 150.0, "mz": -80.0}, 1e-4),
        (DEEP_GROOVE, {"fx": 1e3, "fy": -400.0, "fz": 4e3}, 1e-4),
        (CERAMIC, {"fx": 800.0, "fz": 500.0, "my": 2.0, "mz": 1.0}, 1e-4),
    ],
    ids=["angular", "clearance", "ceramic"],
)
def test_nearly_symmetric_at_rest(bearing: Bearing, duty: dict[str, Any], largest: float) -> None:
    """Symmetric but for the slight turning of the contacts' stiffness, which is accounted for."""
    batch = solved(bearing, "outer", **duty)
    unit = lengths(bearing)
    k = batch.stiffness.array[0] / np.outer(unit, unit)
    skew = k - k.T
    greatest = np.abs(k).max()
    assert np.abs(skew).max() < largest * greatest
    expected = skew_of_stiffness_turning_with_the_angle(batch, bearing)
    np.testing.assert_allclose(skew[0, [2, 1]], expected, atol=1e-8 * greatest)
    assert np.abs(expected).max() > 1e-7 * greatest  # so it is not nothing


def test_symmetric_at_rest_where_the_angle_is_the_same_all_round() -> None:
    """Of shifts under axial load, where the balls' skew parts cancel; of all where α = 0."""
    axial = solved(ANGULAR, "outer", fx=np.array([500.0, 20e3]), my=0.0, mz=0.0)
    radial = solved(DEEP_GROOVE, "outer", fz=np.array([500.0, 8.9e3]))
    for k in (*axial.stiffness.array[:, :3, :3], *radial.stiffness.array):
        np.testing.assert_allclose(k, k.T, rtol=1e-12, atol=1e-12 * np.abs(k).max())


def test_not_symmetric_at_speed() -> None:
    """Inertia loads that follow the angles are no gradient: the matrix is not symmetrised."""
    _, _, duty = POINTS["combined"]
    k = solved(ANGULAR, "outer", **duty).stiffness.array[0]
    assert np.abs(k - k.T)[:3, :3].max() > 1e-3 * np.abs(k[:3, :3]).max()


@pytest.mark.parametrize("name", POINTS)
def test_stable_where_preloaded(name: str) -> None:
    """Positive definite: every way to push the ring is resisted."""
    bearing, control, duty = POINTS[name]
    unit = lengths(bearing)
    k = solved(bearing, control, **duty).stiffness.array[0] / np.outer(unit, unit)
    assert np.linalg.eigvalsh(0.5 * (k + k.T)).min() > 0.0
    assert np.linalg.eigvals(k).real.min() > 0.0


def test_stiffness_rises_with_load_and_falls_with_speed() -> None:
    """As every book shows of angular-contact bearings."""
    loads = np.array([1e3, 3e3, 10e3, 30e3])
    by_load = solved(ANGULAR, "outer", fx=loads, my=0.0, mz=0.0).stiffness.array[:, 0, 0]
    assert (np.diff(by_load) > 0.0).all()
    speeds = np.array([0.0, 3000.0, 6000.0, 10000.0]) * np.pi / 30.0
    at_speed = solved(ANGULAR, "outer", fx=5e3, my=0.0, mz=0.0, inner_speed=speeds)
    assert (np.diff(at_speed.stiffness.array[:, 0, 0]) < 0.0).all()
