"""What must hold for the motions of any ball: superposition, mirror images, frames."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from rolamento.kinematics import ball_motion, gyroscopic_moment

angles = st.floats(-1.2, 1.2)
leans = st.floats(-0.8, 0.8)
ratios = st.floats(0.02, 0.45)
speeds = st.floats(-3000.0, 3000.0)
controls = st.sampled_from(["outer", "inner", "none"])


@given(angles, leans, ratios, speeds, speeds, speeds, controls)
def test_an_observer_that_turns_sees_the_same_relative_motions(
    angle: float, lean: float, ratio: float, inner: float, outer: float, turn: float, control: str
) -> None:
    """Adding a speed to both rings adds it to the orbit and to nothing else."""
    code = {"outer": 1, "inner": -1, "none": 0}[control]
    still = ball_motion(angle + lean, angle, ratio, inner, outer, code)
    moving = ball_motion(angle + lean, angle, ratio, inner + turn, outer + turn, code)
    np.testing.assert_allclose(moving.orbital_speed, still.orbital_speed + turn, atol=1e-8)
    for name in ("ball_speed", "inner_spin", "outer_spin", "inner_roll", "outer_roll"):
        np.testing.assert_allclose(getattr(moving, name), getattr(still, name), atol=1e-7)


@given(angles, leans, ratios, speeds, speeds, st.sampled_from([1, -1]))
def test_the_bearing_turned_round_mirrors_spin_and_moment(
    angle: float, lean: float, ratio: float, inner: float, outer: float, code: int
) -> None:
    one = ball_motion(angle + lean, angle, ratio, inner, outer, code)
    other = ball_motion(-angle - lean, -angle, ratio, inner, outer, code)
    np.testing.assert_allclose(other.orbital_speed, one.orbital_speed, atol=1e-9)
    np.testing.assert_allclose(other.inner_spin, -one.inner_spin, atol=1e-8)
    np.testing.assert_allclose(other.outer_roll, one.outer_roll, atol=1e-8)
    moments = [gyroscopic_moment(1.0, 1.0, motion) for motion in (one, other)]
    np.testing.assert_allclose(moments[1], -moments[0], atol=1e-4)


@given(angles, ratios, speeds, speeds)
def test_both_controls_agree_on_cage_speed_when_the_angles_do(
    angle: float, ratio: float, inner: float, outer: float
) -> None:
    motion = ball_motion(angle, angle, ratio, inner, outer, [1, -1])
    np.testing.assert_allclose(motion.orbital_speed[0], motion.orbital_speed[1], atol=1e-9)
