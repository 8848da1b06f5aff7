"""Roller motions against vectors in space, cones that roll step by step, and their limits."""

from __future__ import annotations

from math import cos, pi, radians, sin, tan

import numpy as np
import pytest

from rolamento.geometry import apex_half_angle
from rolamento.kinematics import (
    apex_mismatch,
    ball_mass,
    ball_motion,
    gyroscopic_moment,
    nominal_orbit,
    rib_motion,
    roller_body,
    roller_gyroscopic_moment,
    roller_motion,
)

RANDOM = np.random.default_rng(11)
COUNT = 300
RATIO = RANDOM.uniform(0.03, 0.35, COUNT)
PITCH = RANDOM.uniform(0.02, 0.5, COUNT)
DIAMETER = RATIO * PITCH
AXIS = RANDOM.uniform(0.02, 1.3, COUNT)
APEX = np.arctan(RATIO * np.sin(AXIS))
"""Half angles of cones with one apex."""
TAPER = RANDOM.uniform(0.0, 0.1, COUNT)
INNER, OUTER = RANDOM.uniform(-800.0, 800.0, (2, COUNT))
LENGTH = DIAMETER * RANDOM.uniform(0.8, 2.0, COUNT)


def in_space(x: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Vectors (x, y, z) at azimuth 0, where r is z."""
    return np.stack([x, np.zeros_like(x), r], axis=-1)


def surfaces(
    race: str, taper: np.ndarray, along: np.ndarray, above: np.ndarray | float = 0.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Velocities of ring and roller, and of a frame that orbits, where both meet.

    `along` the contact line from its middle toward the large end, and `above` the raceway.
    """
    side = -1.0 if race == "inner" else 1.0
    angle = AXIS + side * taper
    motion = roller_motion(DIAMETER, PITCH, AXIS, taper, INNER, OUTER)
    centre = in_space(np.zeros(COUNT), 0.5 * PITCH)
    point = (
        centre
        + side * 0.5 * DIAMETER[:, None] * in_space(np.sin(AXIS), np.cos(AXIS))
        + along[:, None] * in_space(-np.cos(angle), np.sin(angle))
        - side * np.broadcast_to(above, COUNT)[:, None] * in_space(np.sin(angle), np.cos(angle))
    )
    shaft = in_space(np.ones(COUNT), np.zeros(COUNT))
    turn = motion.orbital_speed[:, None] * shaft
    own = motion.ball_speed[:, None] * in_space(np.cos(AXIS), -np.sin(AXIS))
    ring = (INNER if race == "inner" else OUTER)[:, None] * shaft
    roller = np.cross(turn, centre) + np.cross(turn + own, point - centre)
    return np.cross(ring, point), roller, np.cross(turn, point)


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.parametrize("place", [-0.5, -0.2, 0.0, 0.3, 0.5])
def test_cones_with_one_apex_roll_all_along_both_lines(race: str, place: float) -> None:
    ring, roller, _ = surfaces(race, APEX, place * LENGTH)
    np.testing.assert_allclose(roller, ring, atol=1e-10)
    motion = roller_motion(DIAMETER, PITCH, AXIS, APEX, INNER, OUTER)
    for spin in (motion.inner_spin, motion.outer_spin):
        np.testing.assert_allclose(spin, 0.0, atol=1e-9)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_other_cones_roll_at_the_middle_and_slide_by_the_spin_elsewhere(race: str) -> None:
    ring, roller, _ = surfaces(race, TAPER, np.zeros(COUNT))
    np.testing.assert_allclose(roller, ring, atol=1e-10)
    place = 0.4 * LENGTH
    ring, roller, _ = surfaces(race, TAPER, place)
    motion = roller_motion(DIAMETER, PITCH, AXIS, TAPER, INNER, OUTER)
    spin = getattr(motion, f"{race}_spin")
    assert np.abs(spin).max() > 1.0
    np.testing.assert_allclose(
        np.linalg.norm(roller - ring, axis=-1), np.abs(spin) * place, atol=1e-10
    )


def test_the_cage_of_one_apex_goes_by_the_angles_alone() -> None:
    inner, outer = np.sin(AXIS - APEX), np.sin(AXIS + APEX)
    found = roller_motion(DIAMETER, PITCH, AXIS, APEX, INNER, OUTER)
    expected = (INNER * inner + OUTER * outer) / (inner + outer)
    np.testing.assert_allclose(found.orbital_speed, expected, rtol=1e-12, atol=1e-9)


def test_a_cylinder_is_the_limit_of_a_taper_and_turns_as_a_ball_at_contact_angle_zero() -> None:
    cylinder = roller_motion(DIAMETER, PITCH, 0.0, 0.0, INNER, OUTER)
    ball = ball_motion(0.0, 0.0, RATIO, INNER, OUTER)
    for field in ("orbital_speed", "ball_speed", "inner_roll", "outer_roll", "inner_spin"):
        np.testing.assert_allclose(
            getattr(cylinder, field), getattr(ball, field), rtol=1e-12, atol=1e-9
        )
    slight = np.full(COUNT, 1e-7)
    tapered = roller_motion(
        DIAMETER, PITCH, slight, apex_half_angle(DIAMETER, PITCH, slight), INNER, OUTER
    )
    np.testing.assert_allclose(tapered.orbital_speed, cylinder.orbital_speed, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(tapered.ball_speed, cylinder.ball_speed, rtol=1e-9, atol=1e-6)


def test_the_mean_diameter_at_the_outer_angle_comes_near_and_at_the_axis_angle_hits() -> None:
    """Catalogues take γ = D cos α_o/d_m: about 1 % off the cage of a 30206, exact by the axis."""
    ratio, outer = 0.16, radians(14.0361)
    taper = float(apex_half_angle(ratio, 1.0, outer))
    exact = sin(outer - 2.0 * taper) / (sin(outer - 2.0 * taper) + sin(outer))
    by_axis = float(nominal_orbit(ratio * cos(outer - taper), 1.0, 0.0))
    by_outer = float(nominal_orbit(ratio * cos(outer), 1.0, 0.0))
    assert by_axis == pytest.approx(exact, rel=1e-14)
    assert 1e-4 < abs(by_outer / exact - 1.0) < 0.01


def test_a_cone_that_is_rolled_step_by_step_gets_round_with_the_cage() -> None:
    """Turned about the line on which it lies, the outer raceway still, in small steps."""
    ratio, axis = 0.2, radians(20.0)
    taper = np.arctan(ratio * np.sin(axis))

    def rolled(steps: int) -> tuple[float, float]:
        direction = np.array([-cos(axis), 0.0, sin(axis)])  # from the apex to the roller's middle
        outer = axis + taper
        orbit = inner = 0.0
        for _ in range(steps):
            line = np.array([-cos(outer), sin(outer) * sin(orbit), sin(outer) * cos(orbit)])
            turn, middle = 0.05 / steps, direction
            cross = np.cross(line, direction)
            direction = direction * cos(turn) + cross * sin(turn)
            direction += line * (line @ middle) * (1.0 - cos(turn))
            # what the roller's surface moves at the inner raceway turns the inner ring
            low = np.array(
                [-cos(axis - taper), sin(axis - taper) * sin(orbit), sin(axis - taper) * cos(orbit)]
            )
            moved = np.cross(line, low) * turn
            around = np.array([0.0, cos(orbit), -sin(orbit)])
            inner += float(moved @ around) / sin(axis - taper)
            orbit = float(np.arctan2(direction[1], direction[2]))
        return orbit, inner

    motion = roller_motion(ratio, 1.0, axis, taper, 1.0)
    expected = float(motion.orbital_speed)
    errors = []
    for steps in (20, 40, 80):
        orbit, inner = rolled(steps)
        errors.append(abs(orbit / inner - expected))
    assert errors[-1] < 1e-4
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.parametrize("one_apex", [True, False])
def test_the_end_slides_over_a_rib_as_vectors_in_space_say(race: str, one_apex: bool) -> None:
    taper = APEX if one_apex else TAPER
    height = 0.1 * DIAMETER
    place = 0.5 * LENGTH / np.cos(taper) - height * np.tan(taper)
    ring, roller, cage = surfaces(race, taper, place, height)
    found = rib_motion(race, DIAMETER, PITCH, LENGTH, AXIS, taper, height, INNER, OUTER)  # type: ignore[arg-type]
    np.testing.assert_allclose(
        found.sliding, np.linalg.norm(roller - ring, axis=-1), rtol=1e-9, atol=1e-9
    )
    mean = 0.5 * (roller + ring) - cage
    np.testing.assert_allclose(
        found.entrainment, np.linalg.norm(mean, axis=-1), rtol=1e-9, atol=1e-9
    )
    # a plane end has its normal along the roller's axis
    motion = roller_motion(DIAMETER, PITCH, AXIS, taper, INNER, OUTER)
    speed = (motion.orbital_speed - (INNER if race == "inner" else OUTER)) * np.cos(AXIS)
    np.testing.assert_allclose(np.abs(found.spin), np.abs(speed + motion.ball_speed), rtol=1e-9)


def test_sliding_at_the_rib_grows_from_zero_at_the_edge_of_the_raceway() -> None:
    heights = np.array([0.0, 1e-3, 2e-3])
    axis, taper = radians(12.0), float(np.arctan(0.15 * sin(radians(12.0))))
    found = rib_motion("inner", 0.015, 0.1, 0.02, axis, taper, heights, 300.0)
    motion = roller_motion(0.015, 0.1, axis, taper, 300.0)
    np.testing.assert_allclose(found.sliding, abs(motion.inner_roll) * heights, atol=1e-12)


def test_an_end_that_is_round_about_the_apex_spins_by_all_of_the_roll_at_the_raceway() -> None:
    """There its normal is the contact line, about which the roller turns."""
    diameter, axis = 0.015, radians(12.0)
    taper = float(np.arctan(0.15 * sin(axis)))
    length = 0.02
    edge = (0.5 * diameter / tan(taper) + 0.5 * length) / cos(taper)
    found = rib_motion("inner", diameter, 0.1, length, axis, taper, 0.0, 1.0, 0.0, edge)
    motion = roller_motion(diameter, 0.1, axis, taper, 1.0)
    assert float(found.spin) == pytest.approx(float(motion.inner_roll), rel=1e-12)
    flat = rib_motion("inner", diameter, 0.1, length, axis, taper, 0.0, 1.0)
    assert float(flat.spin) == pytest.approx(float(motion.inner_roll) * cos(taper), rel=1e-12)
    small = rib_motion("inner", diameter, 0.1, length, axis, taper, 0.0, 1.0, 0.0, 0.001)
    assert np.isnan(small.spin)


def test_half_angles_of_one_apex_solve_their_triangle() -> None:
    outer = np.linspace(0.0, 0.5 * pi, 37)[:, None]
    ratio = np.array([0.01, 0.1, 0.3, 0.6])
    taper = apex_half_angle(ratio, 1.0, outer)
    np.testing.assert_allclose(np.tan(taper), ratio * np.sin(outer - taper), atol=1e-15)
    assert np.all((taper >= 0.0) & (taper <= outer))
    mismatch = apex_mismatch(ratio, 1.0, outer - taper, taper)
    np.testing.assert_allclose(mismatch, 0.0, atol=1e-12)
    assert float(apex_mismatch(0.1, 1.0, 0.2, 0.0)) == -1.0


def test_a_frustum_weighs_what_its_slices_weigh() -> None:
    diameter, length, taper, density = 0.012, 0.02, radians(3.0), 7800.0
    s = (np.arange(200_000) + 0.5) / 200_000 * length - 0.5 * length
    r, ds = 0.5 * diameter + s * tan(taper), length / 200_000
    mass = density * pi * float((r**2).sum()) * ds
    centroid = density * pi * float((s * r**2).sum()) * ds / mass
    polar = 0.5 * density * pi * float((r**4).sum()) * ds
    transverse = density * pi * float((0.25 * r**4 + (s - centroid) ** 2 * r**2).sum()) * ds
    found = roller_body(diameter, length, taper, density)
    expected = [mass, centroid, polar, transverse]
    fields = [found.mass, found.centroid, found.polar_inertia, found.transverse_inertia]
    np.testing.assert_allclose(fields, expected, rtol=1e-8)


def test_a_cylinder_has_the_textbook_inertias() -> None:
    found = roller_body(0.01, 0.012, 0.0, 7850.0)
    mass = 7850.0 * pi * 0.005**2 * 0.012
    assert float(found.mass) == pytest.approx(mass, rel=1e-14)
    assert float(found.centroid) == 0.0
    assert float(found.polar_inertia) == pytest.approx(0.5 * mass * 0.005**2, rel=1e-14)
    assert float(found.transverse_inertia) == pytest.approx(
        mass * (3.0 * 0.005**2 + 0.012**2) / 12.0, rel=1e-14
    )


def test_the_gyroscopic_moment_is_that_of_a_ball_where_all_inertias_are_alike() -> None:
    body = roller_body(DIAMETER, DIAMETER * np.sqrt(0.75), 0.0, 7850.0)  # J_p = J_t
    np.testing.assert_allclose(body.polar_inertia, body.transverse_inertia, rtol=1e-12)
    motion = roller_motion(DIAMETER, PITCH, AXIS, 0.0, INNER, OUTER)
    found = roller_gyroscopic_moment(body, motion)
    ball = gyroscopic_moment(ball_mass(DIAMETER, 7850.0), DIAMETER, motion)
    inertia = ball_mass(DIAMETER, 7850.0) * DIAMETER**2 / 10.0
    np.testing.assert_allclose(found / body.polar_inertia, ball / inertia, rtol=1e-9)


def test_the_gyroscopic_moment_is_the_change_of_angular_momentum() -> None:
    """By finite differences of H of a tapered roller that goes round."""
    body = roller_body(0.02, 0.03, 0.04, 7850.0)
    motion = roller_motion(0.02, 0.12, 0.3, 0.04, 500.0, -100.0)
    orbit, speed = float(motion.orbital_speed), float(motion.ball_speed)

    def momentum(time: float) -> np.ndarray:
        psi = orbit * time  # about +x: from z toward -y
        radial = np.array([0.0, -sin(psi), cos(psi)])
        axis = cos(0.3) * np.array([1.0, 0.0, 0.0]) - sin(0.3) * radial
        total = speed * axis + np.array([orbit, 0.0, 0.0])
        about = float(total @ axis)
        return np.asarray(
            float(body.polar_inertia) * about * axis
            + float(body.transverse_inertia) * (total - about * axis)
        )

    step = 1e-7
    change = (momentum(step) - momentum(-step)) / (2.0 * step)
    found = float(roller_gyroscopic_moment(body, motion))
    assert change[1] == pytest.approx(found, rel=1e-6)
    np.testing.assert_allclose(change[[0, 2]], 0.0, atol=1e-6 * abs(found))
