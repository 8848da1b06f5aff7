"""Laws of friction torque: least power, proportion to μ, balance, order of the models."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty, Load
from rolamento.friction.harris_1971 import harris_1971
from rolamento.friction.jones_control import jones_control
from rolamento.friction.jones_full import jones_full, jones_full_motion
from rolamento.friction.jones_simplified import jones_simplified
from rolamento.friction.minimum_power import loaded_contacts
from rolamento.friction.slip import BallVelocity, relative_motion
from rolamento.friction.todd import todd
from rolamento.friction.traction import contact_friction, ellipse_mesh
from rolamento.solution import solve
from rolamento.solved import Solved

bearings = st.builds(
    lambda count, diameter, ratio, angle, inner, outer: Bearing(
        ball_count=count,
        ball_diameter=diameter,
        pitch_diameter=ratio * diameter,
        contact_angle=angle,
        inner_conformity=inner,
        outer_conformity=outer,
    ),
    st.integers(3, 9),
    st.floats(3e-3, 30e-3),
    st.floats(4.0, 9.0),
    st.floats(0.1, 1.2),
    st.floats(0.51, 0.56),
    st.floats(0.51, 0.56),
)


def under(bearing: Bearing, pressure: float, slant: float = 0.0) -> Solved:
    """The balls under a thrust that goes with the square of the ball's diameter."""
    load = pressure * bearing.ball_diameter**2 * bearing.ball_count
    duty = Duty(load=Load(fx=load, fz=slant * load))
    return solve(Case(bearing=bearing, duty=duty))


@settings(max_examples=30)
@given(bearings, st.floats(1e5, 5e7), st.floats(0.0, 0.8))
@pytest.mark.sweep
def test_models_stand_in_order_and_in_proportion(
    bearing: Bearing, pressure: float, slant: float
) -> None:
    balls = under(bearing, pressure, slant)
    full, control = jones_full(balls, 0.1), jones_control(balls, 0.1)
    assert full.converged.all()
    assert control.converged.all()
    harris = harris_1971(balls, 0.1)
    assert harris.converged.all()
    # least power: no control takes less, and leaving slip across out takes no more
    assert full.total[0] <= control.total[0] * (1.0 + 2e-3)
    assert full.total[0] <= jones_control(balls, 0.1, control="outer").total[0] * (1.0 + 2e-3)
    assert full.total[0] <= jones_control(balls, 0.1, control="inner").total[0] * (1.0 + 2e-3)
    assert harris.total[0] <= full.total[0] * (1.0 + 2e-3)
    # friction has one direction: added sources are an upper bound
    assert control.total[0] <= jones_simplified(balls, 0.1).total[0] * (1.0 + 2e-3)
    assert todd(balls, 0.1, hysteresis=0.0).total[0] <= jones_simplified(balls, 0.1).total[0]
    for model in (jones_full, jones_control, harris_1971, jones_simplified):
        one, three = model(balls, 0.05), model(balls, 0.15)  # type: ignore[operator]
        np.testing.assert_allclose(three.total, 3.0 * one.total, rtol=1e-9)


@settings(max_examples=30)
@given(bearings, st.floats(1e5, 5e7), st.lists(st.floats(-1.0, 1.0), min_size=4, max_size=4))
def test_no_other_motion_takes_less_power(
    bearing: Bearing, pressure: float, change: list[float]
) -> None:
    """By the rounded law, of which the motion found is the minimum; also with β' ≠ 0."""
    balls = under(bearing, pressure)
    _, motion = jones_full_motion(balls, 0.1)
    assert motion is not None
    mesh = ellipse_mesh()
    inner, outer, _ = loaded_contacts(balls)

    def power(step: float) -> np.ndarray:
        dx, dy, dz, orbit = (step * np.asarray(c) for c in change)
        cage = motion.orbit + orbit
        ball = BallVelocity(motion.ball_x + dx - cage, dy + 0.0 * cage, motion.ball_z + dz)
        total = 0.0
        for patch, ring in ((inner, 1.0), (outer, 0.0)):
            seen = relative_motion(patch, ball, ring - cage)
            f = contact_friction(patch, seen, 0.1, rounding=motion.rounding, mesh=mesh)
            # the rounded power √(v² + v0²) itself: f·v + v0² f/v
            total = total + f.power + _rest(patch, seen, motion.rounding, mesh)
        return np.asarray(total)

    least = power(0.0)
    for step in (1e-5, 1e-3, 1e-1):
        assert np.all(power(step) >= least * (1.0 - 1e-9))


def _rest(patch: object, seen: object, rounding: np.ndarray, mesh: object) -> np.ndarray:
    from rolamento.friction.slip import slip_velocity

    slip = slip_velocity(patch, seen, mesh.across, mesh.along)  # type: ignore[arg-type,attr-defined]
    width = rounding[:, None]
    speed = np.sqrt(slip.rolling**2 + slip.transverse**2 + width**2)
    share = patch.load[:, None] * mesh.weight  # type: ignore[attr-defined]
    return np.asarray(0.1 * np.sum(share * width**2 / speed, axis=-1))


@settings(max_examples=20)
@given(bearings, st.floats(1e5, 5e7))
def test_torque_is_power_to_a_millionth(bearing: Bearing, pressure: float) -> None:
    balls = under(bearing, pressure)
    _, motion = jones_full_motion(balls, 0.1)
    assert motion is not None
    sums = [
        contact_friction(
            patch,
            motion.relative_motion(patch),
            0.1,
            rounding=motion.rounding,
            mesh=ellipse_mesh().folded,
        )
        for patch in loaded_contacts(balls)[:2]
    ]
    power = sums[0].power + sums[1].power
    np.testing.assert_allclose(-sums[0].race_torque, power, rtol=1e-6)
    np.testing.assert_allclose(sums[1].race_torque, power, rtol=1e-6)
