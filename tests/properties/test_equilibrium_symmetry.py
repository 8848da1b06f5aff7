"""What must stay the same when a duty is turned, mirrored, reversed or scaled.

Exact properties of the equations, checked over random duties by Hypothesis. Forces and
displacements mirror as vectors, moments and tilts as axial vectors, both about the bearing's
centre. Gyroscopic moments and centrifugal forces are even in the speeds, so that reversing both
rings changes no force.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from rolamento import Bearing, Case, Duty, Material, Model
from rolamento.case.duty import AXES, LOADS
from rolamento.geometry import ring_geometry
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]
EXAMPLES = 25
TOLERANCE = 1e-8
RPM = np.pi / 30.0

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
BEARINGS = {"angular": ANGULAR, "clearance": DEEP_GROOVE}
CONTROLS = ["outer", "inner", "none"]


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(Case(bearing=ANGULAR, duty=Duty()), fx=np.full(100, 1e4), inner_speed=100.0)


bearings = st.sampled_from(list(BEARINGS.values()))
controls = st.sampled_from(CONTROLS)


def between(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_subnormal=False).map(lambda value: round(value, 6))


@st.composite
def duties(draw: st.DrawFn, moving: bool = True) -> dict[str, float]:
    """A duty that an angular-contact bearing supports: radial load below 0.7 of the axial."""
    fx = draw(between(3e3, 40e3)) * 0.2
    duty = {
        "fx": fx,
        "fy": fx * draw(between(-0.3, 0.3)),
        "fz": fx * draw(between(-0.6, 0.6)),
        "first_ball_azimuth": draw(between(0.0, 6.28)),
    }
    if draw(st.booleans()):
        duty |= {"my": fx * draw(between(-3e-3, 3e-3)), "mz": fx * draw(between(-3e-3, 3e-3))}
    else:
        duty |= {"ry": draw(between(-3e-4, 3e-4)), "rz": draw(between(-3e-4, 3e-4))}
    if moving:
        speeds = draw(st.sampled_from([(1.0, 0.0), (0.0, 1.0), (1.0, 0.4), (1.0, -0.5)]))
        rpm = draw(between(100.0, 9000.0))
        duty |= {"inner_speed": speeds[0] * rpm * RPM, "outer_speed": speeds[1] * rpm * RPM}
    return duty


def solved(bearing: Bearing, duty: dict[str, float], control: Any = "outer") -> Solved:
    case = Case(bearing=bearing, duty=Duty(), model=Model(raceway_control=control))
    return solve(case, threads=1, **duty)


def both(
    bearing: Bearing, one: dict[str, float], other: dict[str, float], control: Any = "outer"
) -> tuple[Solved, Solved]:
    """Both duties solved; an example without a result must lack it on both sides."""
    first, second = solved(bearing, one, control), solved(bearing, other, control)
    np.testing.assert_array_equal(first.status.number, second.status.number)
    assume(bool(first.converged.all()))
    return first, second


def close(found: Any, expected: Any, tolerance: float = TOLERANCE) -> None:
    """Equal to a tolerance of the greatest."""
    scale = np.abs(expected).max()
    assert np.abs(np.asarray(found) - expected).max() <= tolerance * scale


def close_ring(
    bearing: Bearing,
    found: Solved,
    displacement: Floats,
    load: Floats,
    *,
    length: float = 1.0,
    force: float = 1.0,
) -> None:
    """Displacement and load of the ring, tilts and moments on the arm of the pitch radius."""
    arm = bearing.pitch_diameter / 2.0
    lengths = np.array([1.0, 1.0, 1.0, arm, arm])
    close(found.displacement.array[0] / length * lengths, displacement * lengths)
    close(found.load.array[0] / force / lengths, load / lengths)


def close_balls(found: Solved, expected: Solved, order: Any, side: float = 1.0) -> None:
    """Ball by ball in the given order; angles mirrored where side is -1."""
    one, other = found, expected
    for race in ("inner", "outer"):
        a, b = getattr(one, race), getattr(other, race)
        close(a.load[0], b.load[0][order])
        touching = a.load[0] > 1e-3 * a.load[0].max()
        expected_angle = side * b.contact_angle[0][order]
        assert np.abs(a.contact_angle[0] - expected_angle)[touching].max() < TOLERANCE
    close(one.elements.centrifugal_force[0] + 1.0, other.elements.centrifugal_force[0][order] + 1.0)
    close(
        one.elements.gyroscopic_moment[0] + side,
        side * other.elements.gyroscopic_moment[0][order] + side,
    )


def turned(duty: dict[str, float], angle: float) -> dict[str, float]:
    """Loads and displacements turned about the shaft, from z toward y."""
    new = dict(duty)
    for y, z in (("fy", "fz"), ("my", "mz"), ("ry", "rz")):
        if y in duty:
            new[y] = duty[y] * np.cos(angle) + duty[z] * np.sin(angle)
            new[z] = duty[z] * np.cos(angle) - duty[y] * np.sin(angle)
    return new


def turned_five(five: Floats, angle: float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    x, y, z, ry, rz = five
    return np.array([x, y * c + z * s, z * c - y * s, ry * c + rz * s, rz * c - ry * s])


def mirrored(duty: dict[str, float], signs: Floats) -> dict[str, float]:
    """Five signs for the degrees of freedom."""
    by_name = dict(zip(LOADS, signs, strict=True)) | dict(zip(AXES, signs, strict=True))
    return {name: by_name.get(name, 1.0) * value for name, value in duty.items()}


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), st.integers(1, 5))
def test_turning_the_load_by_ball_pitches_permutes_the_balls(
    bearing: Bearing, control: str, duty: dict[str, float], pitches: int
) -> None:
    angle = 2.0 * np.pi * pitches / bearing.ball_count
    straight, shifted = both(bearing, duty, turned(duty, angle), control)
    close_ring(
        bearing,
        shifted,
        turned_five(straight.displacement.array[0], angle),
        turned_five(straight.load.array[0], angle),
    )
    order = (np.arange(bearing.ball_count) - pitches) % bearing.ball_count
    close_balls(shifted, straight, order)


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), between(-3.0, 3.0))
def test_turning_load_and_balls_alike_changes_nothing(
    bearing: Bearing, control: str, duty: dict[str, float], angle: float
) -> None:
    other = turned(duty, angle)
    other["first_ball_azimuth"] = (duty["first_ball_azimuth"] + angle) % (2.0 * np.pi)
    straight, shifted = both(bearing, duty, other, control)
    close_ring(
        bearing,
        shifted,
        turned_five(straight.displacement.array[0], angle),
        turned_five(straight.load.array[0], angle),
    )
    close_balls(shifted, straight, slice(None))


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), st.integers(1, 5))
def test_starting_with_another_ball_permutes_the_balls(
    bearing: Bearing, control: str, duty: dict[str, float], pitches: int
) -> None:
    other = dict(duty)
    other["first_ball_azimuth"] += 2.0 * np.pi * pitches / bearing.ball_count
    other["first_ball_azimuth"] %= 2.0 * np.pi
    straight, shifted = both(bearing, duty, other, control)
    close_ring(bearing, shifted, straight.displacement.array[0], straight.load.array[0])
    order = (np.arange(bearing.ball_count) + pitches) % bearing.ball_count
    close_balls(shifted, straight, order)


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), st.booleans())
def test_mirror_of_y(bearing: Bearing, control: str, duty: dict[str, float], reverse: bool) -> None:
    """In the mirror the rings turn the other way, but no force knows the way they turn."""
    signs = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
    other = mirrored(duty, signs)
    other["first_ball_azimuth"] *= -1.0
    for speed in ("inner_speed", "outer_speed"):
        other[speed] *= -1.0 if reverse else 1.0
    straight, image = both(bearing, duty, other, control)
    close_ring(
        bearing, image, signs * straight.displacement.array[0], signs * straight.load.array[0]
    )
    close_balls(image, straight, -np.arange(bearing.ball_count))


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties())
def test_mirror_of_z(bearing: Bearing, control: str, duty: dict[str, float]) -> None:
    signs = np.array([1.0, 1.0, -1.0, -1.0, 1.0])
    other = mirrored(duty, signs)
    other["first_ball_azimuth"] = np.pi - duty["first_ball_azimuth"]
    straight, image = both(bearing, duty, other, control)
    close_ring(
        bearing, image, signs * straight.displacement.array[0], signs * straight.load.array[0]
    )
    close_balls(image, straight, -np.arange(bearing.ball_count))


@settings(max_examples=EXAMPLES)
@given(controls, duties())
def test_mirror_of_x_of_a_bearing_that_touches_on_either_side(
    control: str, duty: dict[str, float]
) -> None:
    signs = np.array([-1.0, 1.0, 1.0, -1.0, -1.0])
    straight, image = both(DEEP_GROOVE, duty, mirrored(duty, signs), control)
    close_ring(
        DEEP_GROOVE, image, signs * straight.displacement.array[0], signs * straight.load.array[0]
    )
    close_balls(image, straight, slice(None), side=-1.0)


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties())
def test_reversing_both_rings(bearing: Bearing, control: str, duty: dict[str, float]) -> None:
    """Loads, displacements and stiffness stay; every speed changes its sign."""
    other = duty | {name: -duty[name] for name in ("inner_speed", "outer_speed")}
    straight, reverse = both(bearing, duty, other, control)
    close_ring(bearing, reverse, straight.displacement.array[0], straight.load.array[0])
    close_balls(reverse, straight, slice(None))
    close(reverse.stiffness.array[0], straight.stiffness.array[0])
    one, back = straight.elements, reverse.elements
    for name in ("orbital_speed", "ball_speed"):
        close(-getattr(back, name) + 1.0, getattr(one, name) + 1.0)
    close(-reverse.inner.spin + 1.0, straight.inner.spin + 1.0)
    close(-reverse.outer.roll + 1.0, straight.outer.roll + 1.0)
    close(back.attitude, one.attitude)


@settings(max_examples=EXAMPLES)
@given(controls, duties())
def test_a_contact_angle_bearing_agrees_with_its_clearance_twin(
    control: str, duty: dict[str, float]
) -> None:
    """The twin counts x from the centre, BD sin α before first contact."""
    ring = ring_geometry(ANGULAR)
    given = ANGULAR.model_dump(exclude={"contact_angle"}, exclude_none=True)
    given |= {"ring_material": ANGULAR.ring_material, "ball_material": ANGULAR.ball_material}
    twin = Bearing(**given | {"diametral_clearance": ring.diametral_clearance})
    angular, clear = solved(ANGULAR, duty, control), solved(twin, duty, control)
    assume(bool(angular.converged.all()))
    assert clear.converged.all()
    travel = ring.groove_centre_distance * np.sin(ring.free_contact_angle)
    shifted = clear.displacement.array[0] - np.array([travel, 0.0, 0.0, 0.0, 0.0])
    close(shifted, angular.displacement.array[0], 1e-8)
    close_balls(clear, angular, slice(None))
    close(clear.stiffness.array[0], angular.stiffness.array[0])


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), between(0.2, 5.0))
def test_scaling_all_lengths(
    bearing: Bearing, control: str, duty: dict[str, float], scale: float
) -> None:
    """Lengths by s, forces by s², moments by s³, speeds by 1/s: the same stresses and angles."""
    large = bearing.model_dump(exclude={"ring_material", "ball_material"}, exclude_none=True) | {
        "ring_material": bearing.ring_material,
        "ball_material": bearing.ball_material,
    }
    for name in ("ball_diameter", "pitch_diameter", "diametral_clearance"):
        if name in large:
            large[name] *= scale
    powers = {"f": 2, "m": 3, "i": -1, "o": -1}
    other = {
        name: value * scale ** (0 if name.startswith("first") else powers.get(name[0], 0))
        for name, value in duty.items()
    }
    one, big = solved(bearing, duty, control), solved(Bearing(**large), other, control)
    np.testing.assert_array_equal(one.status.number, big.status.number)
    assume(bool(one.converged.all()))
    shift = np.array([scale, scale, scale, 1.0, 1.0])
    force = np.array([scale**2, scale**2, scale**2, scale**3, scale**3])
    close_ring(bearing, big, one.displacement.array[0] * shift / scale,
               one.load.array[0] * force / scale**2, length=scale, force=scale**2,
               )  # fmt: skip
    for race in ("inner", "outer"):
        a, b = getattr(big, race), getattr(one, race)
        close(a.load, scale**2 * b.load)
        touching = b.load > 1e-3 * b.load.max()
        assert np.abs(a.contact_angle - b.contact_angle)[touching].max() < TOLERANCE


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(), between(0.3, 3.0))
def test_scaling_modulus_density_and_loads(
    bearing: Bearing, control: str, duty: dict[str, float], scale: float
) -> None:
    """Stiffer, heavier and harder loaded by one factor: the same displacements."""
    steel = bearing.ring_material
    other_steel = Material(
        youngs_modulus=steel.youngs_modulus * scale,
        poisson_ratio=steel.poisson_ratio,
        density=steel.density * scale,
    )
    other_bearing = bearing.model_copy(
        update={"ring_material": other_steel, "ball_material": other_steel}
    )
    other = {name: value * (scale if name in LOADS else 1.0) for name, value in duty.items()}
    one, stiff = solved(bearing, duty, control), solved(other_bearing, other, control)
    np.testing.assert_array_equal(one.status.number, stiff.status.number)
    assume(bool(one.converged.all()))
    close_ring(bearing, stiff, one.displacement.array[0], one.load.array[0], force=scale)
    close(stiff.stiffness.array[0] / scale, one.stiffness.array[0])


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties(moving=False))
def test_slow_rings_approach_the_static_state(
    bearing: Bearing, control: str, duty: dict[str, float]
) -> None:
    """With the square of the speed; unloaded balls lie elsewhere, but carry nothing."""
    rest = solved(bearing, duty, control)
    assume(bool(rest.converged.all()))
    arm = bearing.pitch_diameter / 2.0
    lengths = np.array([1.0, 1.0, 1.0, arm, arm])
    previous = np.inf
    for rpm, tolerance in ((100.0, 1e-2), (1.0, 1e-6), (1e-3, 1e-9)):
        slow = solved(bearing, duty | {"inner_speed": rpm * RPM}, control)
        assert slow.converged.all()
        change = np.abs((slow.displacement.array - rest.displacement.array)[0] * lengths).max()
        relative = change / np.abs(rest.displacement.array[0] * lengths).max()
        assert relative < tolerance
        assert relative <= previous
        previous = relative
        load = rest.inner.load
        assert np.abs(slow.inner.load - load).max() < 10.0 * tolerance * load.max()


@settings(max_examples=EXAMPLES)
@given(bearings, controls, duties())
def test_without_inertia_the_speed_does_not_matter(
    bearing: Bearing, control: Any, duty: dict[str, float]
) -> None:
    model = Model(raceway_control=control, centrifugal_force=False, gyroscopic_moment=False)
    case = Case(bearing=bearing, duty=Duty(), model=model)
    turning = solve(case, **duty)
    still = solve(case, **duty | {"inner_speed": 0.0, "outer_speed": 0.0})
    np.testing.assert_array_equal(turning.status.number, still.status.number)
    np.testing.assert_array_equal(turning.displacement.array, still.displacement.array)
    np.testing.assert_array_equal(turning.stiffness.array, still.stiffness.array)
    np.testing.assert_array_equal(turning.inner.load, still.inner.load)
    if turning.converged.all():
        assert (turning.elements.ball_speed != 0.0).all()


@pytest.mark.parametrize("control", CONTROLS)
def test_relative_speed_of_zero_leaves_only_centrifugal_force(control: str) -> None:
    """Both rings at one speed carry the balls round: no rolling, no gyroscopic moment."""
    duty = {"fx": 20e3, "fz": 5e3, "inner_speed": 600.0, "outer_speed": 600.0}
    batch = solved(ANGULAR, duty, control)
    assert batch.converged.all()
    balls = batch
    np.testing.assert_allclose(balls.elements.orbital_speed, 600.0, rtol=1e-12)
    assert np.abs(balls.elements.gyroscopic_moment).max() < 1e-12
    assert balls.elements.centrifugal_force.min() > 0.0
