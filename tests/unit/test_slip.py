"""Slip in the contacts against vectors in space, and against the printed equations, corrected."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from rolamento.errors import InputError
from rolamento.friction.slip import (
    BallVelocity,
    Patch,
    maximum_pressure_slip,
    pressure_share,
    relative_motion,
    rolling_lines,
    slip_velocity,
)
from rolamento.friction.traction import ellipse_mesh
from rolamento.geometry import Race
from rolamento.kinematics import ball_motion

COUNT = 200
POINTS = 7
RANDOM = np.random.default_rng(11)
DIAMETER = RANDOM.uniform(3e-3, 40e-3, COUNT)
PITCH = DIAMETER * RANDOM.uniform(3.0, 12.0, COUNT)
CONFORMITY = RANDOM.uniform(0.505, 0.57, COUNT)
SEMI_MAJOR = DIAMETER * RANDOM.uniform(0.01, 0.3, COUNT)
SEMI_MINOR = SEMI_MAJOR * RANDOM.uniform(0.08, 0.9, COUNT)
ANGLE = RANDOM.uniform(-1.4, 1.4, COUNT)
RING = RANDOM.uniform(-800.0, 800.0, COUNT)
BALL = RANDOM.uniform(-3000.0, 3000.0, (3, COUNT))
ACROSS, ALONG = RANDOM.uniform(-0.7, 0.7, (2, COUNT, POINTS))


def patch_of(race: Race) -> Patch:
    load = np.full(COUNT, 100.0)
    return Patch(race, load, ANGLE, SEMI_MAJOR, SEMI_MINOR, DIAMETER, PITCH, CONFORMITY)


def radius_at(x0: np.ndarray) -> np.ndarray:
    """ρ of Braga and Almeida's braces, term by term."""
    big = (2.0 * CONFORMITY * DIAMETER / (2.0 * CONFORMITY + 1.0))[:, None]
    a, half = SEMI_MAJOR[:, None], 0.5 * DIAMETER[:, None]
    return np.sqrt(big**2 - x0**2) - np.sqrt(big**2 - a**2) + np.sqrt(half**2 - a**2)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_slip_is_the_difference_of_two_turning_bodies(race: Race) -> None:
    """ω × r of the race about the shaft less ω × r of the ball about its centre, in space."""
    patch, side = patch_of(race), 1.0 if race == "outer" else -1.0
    slip = slip_velocity(patch, relative_motion(patch, BallVelocity(*BALL), RING), ACROSS, ALONG)
    zero = np.zeros(COUNT)
    tangent = np.stack([np.cos(ANGLE), zero, -np.sin(ANGLE)], axis=-1)[:, None, :]
    normal = np.stack([np.sin(ANGLE), zero, np.cos(ANGLE)], axis=-1)[:, None, :]
    forward = np.array([0.0, 1.0, 0.0])
    x0, y0 = SEMI_MAJOR[:, None] * ACROSS, SEMI_MINOR[:, None] * ALONG
    place = (
        x0[..., None] * tangent + y0[..., None] * forward + side * radius_at(x0)[..., None] * normal
    )
    centre = np.stack([zero, zero, 0.5 * PITCH], axis=-1)[:, None, :]
    ring = np.stack([RING, zero, zero], axis=-1)[:, None, :]
    ball = BALL.T[:, None, :]
    relative = np.cross(ring, centre + place) - np.cross(ball, place)
    scale = np.max(np.abs(np.cross(ring, centre + place)))
    np.testing.assert_allclose(
        slip.rolling, np.sum(relative * forward, axis=-1), rtol=0, atol=1e-14 * scale
    )
    np.testing.assert_allclose(
        slip.transverse, np.sum(relative * tangent, axis=-1), rtol=0, atol=1e-14 * scale
    )


def braga(race: Race) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Equations 31 to 36 and 41 to 44 with their errata: rolling slip, transverse slip, spin.

    The authors draw the outer contact on the -x side: their angle is minus ours. Angles of the
    ball: ω_x = ω_R cos β cos β', ω_y = ω_R cos β sin β' (not sin β, equation 26), ω_z = ω_R sin β.
    """
    speed = np.sqrt(np.sum(BALL**2, axis=0))
    beta = np.arcsin(BALL[2] / speed)
    nutation = np.arctan2(BALL[1], BALL[0])
    theta = -ANGLE
    x0, y0 = SEMI_MAJOR[:, None] * ACROSS, SEMI_MINOR[:, None] * ALONG
    rho = radius_at(x0)
    along = speed * (np.cos(beta) * np.cos(nutation) * np.cos(theta) + np.sin(beta) * np.sin(theta))
    about = speed * (np.sin(beta) * np.cos(theta) - np.cos(beta) * np.cos(nutation) * np.sin(theta))
    side = 1.0 if race == "outer" else -1.0
    spin = side * (about + RING * np.sin(theta))  # (36): the ring's term is added
    rolling = (
        -0.5 * (PITCH * RING)[:, None]
        + side * rho * (along - RING * np.cos(theta))[:, None]
        - side * x0 * spin[:, None]  # left out in print
    )
    sideways = (speed * np.cos(beta) * np.sin(nutation))[:, None]
    transverse = -side * rho * sideways + side * y0 * spin[:, None]  # (42): + on a common t
    return rolling, transverse, spin


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_printed_equations_hold_once_their_misprints_are_put_right(race: Race) -> None:
    patch = patch_of(race)
    motion = relative_motion(patch, BallVelocity(*BALL), RING)
    slip = slip_velocity(patch, motion, ACROSS, ALONG)
    rolling, transverse, spin = braga(race)
    np.testing.assert_allclose(slip.rolling, rolling, rtol=0, atol=1e-10)
    np.testing.assert_allclose(slip.transverse, transverse, rtol=0, atol=1e-10)
    # theirs about the normal out of the ball, ours about the one into it
    np.testing.assert_allclose(motion.spin, -spin, rtol=0, atol=1e-9)


def test_printed_sign_of_the_ring_in_equation_36_contradicts_control_by_the_outer_race() -> None:
    angle, ratio = 0.7, 0.18
    motion = ball_motion(0.75, angle, ratio, 1.0, 0.0, "outer")
    cage, ball = float(motion.orbital_speed), float(motion.ball_speed)
    attitude, ring, theta = float(motion.attitude), -cage, -angle
    x, z = ball * np.cos(attitude), -ball * np.sin(attitude)
    about = z * np.cos(theta) - x * np.sin(theta)
    assert abs(about + ring * np.sin(theta)) < 1e-14
    assert abs(about - ring * np.sin(theta)) > 0.1


@pytest.mark.parametrize("inner_turns", [True, False])
def test_orbit_and_ball_speed_reduce_to_radaelli_appendix_a(inner_turns: bool) -> None:
    """Braga's equations 48 to 50 as corrected, at r' = D/2 and β' = 0, are Radaelli's 35, 41, 48.

    They follow from no slip in the rolling direction at both contacts, as slip_velocity has it.
    """
    inner, outer, ratio = 0.6, 0.45, 0.17
    pitch, diameter = 1.0, ratio
    tan_beta = np.sin(outer) / (np.cos(outer) + ratio)
    beta = np.arctan(tan_beta)
    r = 0.5 * diameter

    def turn(angle: float) -> float:
        return np.cos(beta) * np.cos(angle) + np.sin(beta) * np.sin(angle)

    at_outer = (0.5 * pitch + r * np.cos(outer)) / (r * turn(outer))
    at_inner = (-0.5 * pitch + r * np.cos(inner)) / (r * turn(inner))
    # ω_R = at_outer ω_o = at_inner ω_i seen from the cage, and ω = ω_i - ω_o
    ball = 1.0 / (1.0 / at_inner - 1.0 / at_outer)
    motion = ball_motion(
        inner, outer, ratio, 1.0 if inner_turns else 0.0, 0.0 if inner_turns else 1.0, "outer"
    )
    sign = 1.0 if inner_turns else -1.0
    assert float(motion.ball_speed) == pytest.approx(sign * ball, rel=1e-14)
    cage = -ball / at_outer if inner_turns else ball / at_inner
    assert float(motion.orbital_speed) == pytest.approx(cage, rel=1e-14)
    common = 1.0 + np.cos(inner - outer)
    expected = (
        (1.0 - ratio * np.cos(inner)) / common
        if inner_turns
        else (np.cos(inner - outer) + ratio * np.cos(inner)) / common
    )
    assert float(motion.orbital_speed) == pytest.approx(expected, rel=1e-14)


def test_spin_and_roll_are_those_of_the_kinematics() -> None:
    gamma = DIAMETER / PITCH
    inner_angle = np.clip(ANGLE + 0.1, -1.4, 1.4)
    motion = ball_motion(inner_angle, ANGLE, gamma, 300.0, -120.0, "inner")
    ball = BallVelocity(
        motion.ball_speed * np.cos(motion.attitude),
        np.zeros(COUNT),
        -motion.ball_speed * np.sin(motion.attitude),
    )
    for race, angle, speed, spin, roll in (
        ("inner", inner_angle, 300.0, motion.inner_spin, motion.inner_roll),
        ("outer", ANGLE, -120.0, motion.outer_spin, motion.outer_roll),
    ):
        base = patch_of(race)  # type: ignore[arg-type]
        patch = Patch(base.race, base.load, angle, *base.arrays[2:])
        seen = relative_motion(patch, ball, speed - motion.orbital_speed)
        np.testing.assert_allclose(seen.spin, spin, atol=1e-10)
        np.testing.assert_allclose(seen.roll, roll, atol=1e-10)
        # the pure-rolling radius of the kinematics is D/2: where ρ = D/2, nothing slips
        rest = seen.drift + patch.side * 0.5 * DIAMETER * seen.roll
        np.testing.assert_allclose(rest, 0.0, atol=1e-10)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_rolling_lines_are_the_zeros_of_slip(race: Race) -> None:
    patch = patch_of(race)
    # near pure rolling, so that there are lines: two, one and none
    roll = RANDOM.uniform(0.5, 1.5, COUNT)
    lift = RANDOM.uniform(-0.3, 1.3, COUNT) * SEMI_MAJOR**2 / (2.0 * patch.deformed_radius)
    drift = -patch.side * roll * (patch.rolling_radius(np.zeros(COUNT)) - lift)
    twist = RANDOM.uniform(-0.3, 0.3, COUNT) * SEMI_MAJOR / DIAMETER
    motion = relative_motion(patch, BallVelocity(*BALL), RING)
    motion = type(motion)(drift, roll, twist, 0.0 * roll, patch.side)
    lines = rolling_lines(patch, motion)
    counted = np.isfinite(lines).sum(axis=-1)
    assert set(counted) == {0, 1, 2}
    grid = np.linspace(-1.0, 1.0, 4001)
    values = slip_velocity(patch, motion, grid, 0.0 * grid).rolling
    for k in range(COUNT):
        changes = np.flatnonzero(np.sign(values[k, 1:]) != np.sign(values[k, :-1]))

        def rolling(u: float, k: int = k) -> float:
            return float(slip_velocity(patch, motion, np.array([u]), np.zeros(1)).rolling[k, 0])

        found = [brentq(rolling, grid[j], grid[j + 1], xtol=1e-14) for j in changes]
        mine = lines[k][np.isfinite(lines[k])]
        if len(found) == len(mine):  # two lines closer than the grid are not counted
            np.testing.assert_allclose(mine, found, atol=2e-9)
        else:
            assert len(mine) == 2
            assert np.ptp(mine) < 2e-3


@pytest.mark.sweep
def test_maximum_pressure_slip_is_that_of_a_dense_grid() -> None:
    patch = patch_of("inner")
    motion = relative_motion(patch, BallVelocity(*BALL), RING)
    found = maximum_pressure_slip(patch, motion)
    steps = np.linspace(-1.0, 1.0, 301)
    u, v = (array.ravel() for array in np.meshgrid(steps, steps))
    dense = pressure_share(u, v) * slip_velocity(patch, motion, u, v).speed
    best = np.max(dense, axis=-1) * patch.max_pressure
    assert np.all(found.value >= best * (1.0 - 1e-9))
    np.testing.assert_allclose(found.value, best, rtol=2e-4)
    at = slip_velocity(patch, motion, found.across[:, None], found.along[:, None]).speed[:, 0]
    again = at * patch.max_pressure * pressure_share(found.across, found.along)
    np.testing.assert_allclose(again, found.value, rtol=1e-12)


def test_mesh_carries_the_load_and_polynomials_exactly() -> None:
    mesh = ellipse_mesh(6, 4)
    assert np.sum(mesh.weight) == pytest.approx(1.0, abs=1e-14)
    # moments of (3/2π) √(1 - u² - v²): <u²> = 1/5, <u⁴> = 3/35, <u²v²> = 1/35
    for power, expected in (((2, 0), 0.2), ((0, 2), 0.2), ((4, 0), 3 / 35), ((2, 2), 1 / 35)):
        value = np.sum(mesh.weight * mesh.across ** power[0] * mesh.along ** power[1])
        assert value == pytest.approx(expected, abs=1e-14)
    assert abs(np.sum(mesh.weight * mesh.across * mesh.along**2)) < 1e-15


@pytest.mark.parametrize("along", [4, 5])
def test_folded_mesh_is_half_of_an_even_integral(along: int) -> None:
    mesh, half = ellipse_mesh(9, along), ellipse_mesh(9, along).folded
    assert np.all(half.along > -1e-9)
    for g in (np.abs, np.cosh):
        whole = np.sum(mesh.weight * g(mesh.along) * np.exp(mesh.across))
        assert np.sum(half.weight * g(half.along) * np.exp(half.across)) == pytest.approx(whole)


@pytest.mark.parametrize(("across", "along"), [(1, 5), (5, 0), (10_000_000, 5), (5, 10_000)])
def test_meshes_are_bounded(across: int, along: int) -> None:
    with pytest.raises(InputError, match=r"mesh\.a"):
        ellipse_mesh(across, along)


def test_ellipse_wider_than_the_ball_has_no_slip() -> None:
    wide = Patch("inner", *(np.array([x]) for x in (1.0, 0.5, 6e-3, 1e-3, 10e-3, 50e-3, 0.52)))
    motion = relative_motion(wide, BallVelocity(*np.ones((3, 1))), 1.0)
    assert np.isnan(slip_velocity(wide, motion, np.zeros(1), np.zeros(1)).rolling).all()
    assert np.isnan(rolling_lines(wide, motion)).all()
