"""Ball motions against vectors in space, and against the published single-ring formulas."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.kinematics import (
    LEAST_COSINE,
    BallMotion,
    RacewayControl,
    ball_mass,
    ball_motion,
    centrifugal_force,
    control_codes,
    friction_demand,
    gyroscopic_moment,
    jones_control,
    orbital_speed,
    spin_resistance,
    spin_to_roll,
)

RANDOM = np.random.default_rng(7)
COUNT = 400
OUTER_ANGLE = RANDOM.uniform(-1.4, 1.4, COUNT)
INNER_ANGLE = np.clip(OUTER_ANGLE + RANDOM.uniform(-1.0, 1.0, COUNT), -1.5, 1.5)
RATIO = RANDOM.uniform(0.05, 0.45, COUNT)
INNER_SPEED, OUTER_SPEED = RANDOM.uniform(-2000.0, 2000.0, (2, COUNT))
CONTROL = RANDOM.choice([1, -1, 0], COUNT)


def in_space(x: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Vectors (x, y, z) of a ball at azimuth 0, where r is z."""
    return np.stack([x, np.zeros_like(x), r], axis=-1)


def random_motion() -> BallMotion:
    return ball_motion(INNER_ANGLE, OUTER_ANGLE, RATIO, INNER_SPEED, OUTER_SPEED, CONTROL)


def ball_vector(motion: BallMotion) -> np.ndarray:
    """Absolute angular velocity of the ball."""
    return in_space(
        motion.orbital_speed + motion.ball_speed * np.cos(motion.attitude),
        -motion.ball_speed * np.sin(motion.attitude),
    )


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_surfaces_move_together_at_both_contacts(race: str) -> None:
    """v = ω × r of ring and ball at the contact point, both rings turning (d_m = 2)."""
    motion = random_motion()
    side, angle, speed = (
        (1.0, OUTER_ANGLE, OUTER_SPEED) if race == "outer" else (-1.0, INNER_ANGLE, INNER_SPEED)
    )
    arm = side * RATIO[:, None] * in_space(np.sin(angle), np.cos(angle))  # D/2 = γ'
    centre = in_space(np.zeros(COUNT), np.ones(COUNT))
    shaft = in_space(np.ones(COUNT), np.zeros(COUNT))
    ring = np.cross(speed[:, None] * shaft, centre + arm)
    orbit = np.cross(motion.orbital_speed[:, None] * shaft, centre)
    ball = orbit + np.cross(ball_vector(motion), arm)
    np.testing.assert_allclose(ball, ring, atol=1e-9)


def test_spin_and_roll_are_projections_of_the_relative_rotation() -> None:
    motion = random_motion()
    for angle, speed, into_ball, spin, roll in [
        (INNER_ANGLE, INNER_SPEED, 1.0, motion.inner_spin, motion.inner_roll),
        (OUTER_ANGLE, OUTER_SPEED, -1.0, motion.outer_spin, motion.outer_roll),
    ]:
        relative = ball_vector(motion) - in_space(speed, np.zeros(COUNT))
        normal = into_ball * in_space(np.sin(angle), np.cos(angle))
        tangent = in_space(np.cos(angle), -np.sin(angle))
        np.testing.assert_allclose(spin, np.sum(relative * normal, axis=-1), atol=1e-9)
        np.testing.assert_allclose(roll, np.sum(relative * tangent, axis=-1), atol=1e-9)


def test_controlling_race_does_not_spin() -> None:
    motion = random_motion()
    np.testing.assert_allclose(motion.outer_spin[CONTROL >= 0], 0.0, atol=1e-9)
    np.testing.assert_allclose(motion.inner_spin[CONTROL < 0], 0.0, atol=1e-9)
    assert np.all(np.abs(motion.inner_spin[CONTROL >= 0]) > 0.0)


def test_none_moves_as_under_outer_control() -> None:
    arguments = (0.7, 0.6, 0.17, 1000.0, -50.0)
    assert ball_motion(*arguments, "none") == ball_motion(*arguments, "outer")
    assert ball_motion(*arguments, "inner") != ball_motion(*arguments, "outer")


def test_published_ratios_of_outer_control() -> None:
    """Radaelli (2013) eqs. 43 to 46, one ring turning at a time."""
    ai, ao, g = 0.75, 0.55, 0.1775
    inner, outer = (ball_motion(ai, ao, g, *w, "outer") for w in [(1.0, 0.0), (0.0, 1.0)])
    both = 1.0 + np.cos(ai - ao)
    beta = np.arctan(np.sin(ao) / (np.cos(ao) + g))
    size = (np.cos(ao) + g) * (1.0 - g * np.cos(ai)) / (g * np.cos(beta) * both)
    assert inner.attitude == pytest.approx(beta)
    assert inner.orbital_speed == pytest.approx((1.0 - g * np.cos(ai)) / both)
    assert outer.orbital_speed == pytest.approx((np.cos(ai - ao) + g * np.cos(ai)) / both)
    assert inner.ball_speed == pytest.approx(-size)
    assert outer.ball_speed == pytest.approx(size)
    spin = (1.0 - g * np.cos(ai)) * np.tan(ai - beta) + g * np.sin(ai)
    assert inner.inner_spin_to_roll == pytest.approx(spin)
    assert inner.outer_spin_to_roll == pytest.approx(0.0, abs=1e-15)


def test_mirror_image_under_inner_control() -> None:
    ai, ao, g = 0.75, 0.55, 0.1775
    motion = ball_motion(ai, ao, g, 1.0, 0.0, "inner")
    both = 1.0 + np.cos(ai - ao)
    beta = np.arctan(np.sin(ai) / (np.cos(ai) - g))
    assert motion.attitude == pytest.approx(beta)
    assert motion.orbital_speed == pytest.approx((np.cos(ai - ao) - g * np.cos(ao)) / both)
    speed = -(1.0 + g * np.cos(ao)) * (np.cos(ai) - g) / (g * np.cos(beta) * both)
    assert motion.ball_speed == pytest.approx(speed)
    spin = -((1.0 + g * np.cos(ao)) * np.tan(ao - beta) - g * np.sin(ao))
    assert motion.outer_spin_to_roll == pytest.approx(spin)


@pytest.mark.parametrize("control", ["outer", "inner"])
def test_equal_angles_give_the_textbook_cage_speed(control: str) -> None:
    """n_m = ½ [n_i (1 - γ) + n_o (1 + γ)], whichever race controls; Radaelli (2013) eq. 38."""
    gamma = 0.17 * np.cos(0.6)
    found = orbital_speed(0.6, 0.6, 0.17, 300.0, -80.0, RacewayControl[control.upper()])
    assert found == pytest.approx(0.5 * (300.0 * (1.0 - gamma) - 80.0 * (1.0 + gamma)))


def test_radial_contact_rolls_without_spin_and_without_gyroscopic_moment() -> None:
    motion = ball_motion(0.0, 0.0, 0.2, 100.0)
    assert motion.inner_spin == motion.outer_spin == motion.attitude == 0.0
    assert gyroscopic_moment(0.01, 0.02, motion) == 0.0
    # Ball speed of eq. 40: ½ d_m/D (1 - γ²)(ω_o - ω_i).
    assert motion.ball_speed == pytest.approx(-0.5 / 0.2 * (1.0 - 0.04) * 100.0)


def test_rings_turning_together_carry_the_ball_along() -> None:
    motion = ball_motion(0.7, 0.5, 0.2, 100.0, 100.0, [1, -1])
    np.testing.assert_allclose(motion.orbital_speed, 100.0)
    np.testing.assert_allclose(motion.ball_speed, 0.0, atol=1e-12)
    assert np.all(np.isnan(motion.inner_spin_to_roll) | (np.abs(motion.inner_roll) < 1e-12))


def test_what_only_spins_has_no_ratio_of_spin_to_roll() -> None:
    """A rounding in the place of no roll, as cos 90° is 6e-17, gives none either."""
    spin = np.array([300.0, -300.0, 0.0, 3.0])
    roll = np.array([300.0 * np.cos(0.5 * np.pi), 0.0, 0.0, 300.0])
    ratio = np.asarray(spin_to_roll(spin, roll))
    np.testing.assert_array_equal(ratio, [np.nan, np.nan, np.nan, 0.01])


def test_gyroscopic_moment_turns_the_angular_momentum() -> None:
    """M_g about y is the rate of change J ω_m x × Ω of the ball's angular momentum."""
    motion = random_motion()
    mass, diameter = 0.04, 0.02
    momentum = mass * diameter**2 / 10.0 * ball_vector(motion)
    rate = np.cross(in_space(motion.orbital_speed, np.zeros(COUNT)), momentum)
    np.testing.assert_allclose(gyroscopic_moment(mass, diameter, motion), rate[:, 1], rtol=1e-10)


def test_gyroscopic_moment_in_ring_speeds() -> None:
    motion = random_motion()
    sigma = np.where(CONTROL < 0, -1.0, 1.0)
    slave = np.where(CONTROL < 0, OUTER_ANGLE, INNER_ANGLE)
    own = np.where(CONTROL < 0, INNER_ANGLE, OUTER_ANGLE)
    w = (1.0 - sigma * RATIO * np.cos(slave)) / (1.0 + np.cos(INNER_ANGLE - OUTER_ANGLE))
    moment = -(INNER_SPEED - OUTER_SPEED) * motion.orbital_speed * w * np.sin(own) / RATIO
    np.testing.assert_allclose(gyroscopic_moment(10.0, 1.0, motion), moment, rtol=1e-10)


def test_sign_of_the_gyroscopic_moment_follows_the_driven_ring() -> None:
    driven = [ball_motion(0.7, 0.65, 0.18, *speed) for speed in [(1.0, 0.0), (0.0, 1.0)]]
    signs = [float(np.sign(gyroscopic_moment(1.0, 1.0, motion))) for motion in driven]
    assert signs == [-1.0, 1.0]
    backwards = ball_motion(0.7, 0.65, 0.18, -1.0)
    assert gyroscopic_moment(1.0, 1.0, backwards) == gyroscopic_moment(1.0, 1.0, driven[0])


def test_inertia() -> None:
    assert ball_mass(0.02, 7810.0) == pytest.approx(7810.0 * np.pi * 0.02**3 / 6.0)
    assert centrifugal_force(0.03, 0.1, -200.0) == pytest.approx(0.03 * 0.05 * 200.0**2)


def test_ball_without_inner_contact_stays_finite() -> None:
    """Angles more than 120° apart: cos(α_i - α_o) counts as -1/2 and nothing blows up."""
    speed = orbital_speed(3.0, 0.0, 0.2, 0.0, 1.0)
    assert speed == pytest.approx(1.0 - (1.0 - 0.2 * np.cos(3.0)) / (1.0 + LEAST_COSINE))


def test_jones_criterion() -> None:
    codes = jones_control([1.0, 1.0, 1.0, 0.0, 0.0], [2.0, 0.5, 1.01, 1.0, 0.0], 0.7, 0.5)
    assert codes.tolist() == [1, -1, 0, 1, 0]
    assert jones_control(1.0, 1.01, 0.5, 0.5) == RacewayControl.OUTER


def test_spin_resistance_of_a_circle() -> None:
    """E = π/2 at k = 1: (3/8) μ Q a π/2 = 3π/16 μ Q a, the friction moment of a Hertz circle."""
    assert 0.375 * spin_resistance(10.0, 0.5, 1.0) == pytest.approx(3.0 * np.pi / 16.0 * 5.0)
    assert spin_resistance(10.0, 0.5, 1e6) == pytest.approx(5.0)


def test_friction_demand() -> None:
    found = friction_demand(
        [-2.0, -2.0, 0.0, 1.0], 0.02, [1e4, 1e4, 0.0, 0.0], [2.0, 1.0, 2.0, 2.0]
    )
    np.testing.assert_allclose(found, [0.02, 0.01, 0.0, np.inf])


def test_control_names_and_codes() -> None:
    assert [int(control_codes(n)) for n in ("outer", "inner", "none")] == [1, -1, 0]
    with pytest.raises(ValueError, match="one of"):
        control_codes("jones")
    with pytest.raises(ValueError, match="codes"):
        control_codes([1, 2])


def test_shapes_broadcast() -> None:
    motion = ball_motion(np.zeros((3, 1)), np.zeros(4), 0.2, 1.0, 0.0, "inner")
    assert motion.inner_spin.shape == motion.attitude.shape == (3, 4)
