"""How balls move that friction alone controls: what `traction` finds, in the words of a result."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
from numpy.typing import NDArray

from rolamento.geometry import Race
from rolamento.kinematics import BallMotion
from rolamento.records import frozen
from rolamento.rows.ball import layout
from rolamento.rows.ball.problem import Columns, Floats


@frozen
class Rolling:
    """How friction-controlled balls move, and what that costs; cases without a result hold NaN.

    Rings that turn alike move no ball, and have no result here either.

    cage_speed, control_cage_speed (cases,), rad/s: under friction, and under outer raceway control.
    angular_velocity (cases, balls, 3): of the balls along x, along increasing azimuth, and
    outward, absolute, rad/s; NaN of balls that nothing touches. inner, outer (cases, balls, 6):
    force (x, azimuth last; N) and moment about the ball's centre (x, azimuth, outward; N·m) of
    the race on the ball, the normal load included. power (cases, balls, 2): friction loss at the
    inner and the outer race, W. imbalance (cases,): what is missing between the work of shaft and
    housing and the losses, over the losses. radius (cases,): of the balls' orbit, m. lift (cases,
    balls, 2): film between the ball and the inner and outer race that enters the geometry, m.
    """

    cage_speed: Floats
    control_cage_speed: Floats
    angular_velocity: Floats
    inner: Floats
    outer: Floats
    power: Floats
    imbalance: Floats
    radius: Floats
    lift: Floats

    @classmethod
    def empty(cls, cases: int, balls: int, radius: Floats, control_cage_speed: Floats) -> Rolling:
        """Make room for so many cases."""
        return cls(
            cage_speed=np.full(cases, np.nan),
            control_cage_speed=control_cage_speed,
            angular_velocity=np.full((cases, balls, 3), np.nan),
            inner=np.full((cases, balls, 6), np.nan),
            outer=np.full((cases, balls, 6), np.nan),
            power=np.full((cases, balls, 2), np.nan),
            imbalance=np.full(cases, np.nan),
            radius=radius.copy(),
            lift=np.zeros((cases, balls, 2)),
        )

    def forget(self, cases: NDArray[np.bool_]) -> None:
        """Leave cases without a result."""
        for array in (self.cage_speed, self.angular_velocity, self.inner, self.outer, self.power):
            array[cases] = np.nan

    def torque(self, race: Race) -> Floats:
        """Torque about x that the shaft or the housing puts on a ring to turn it; (cases,), N·m."""
        forces = self.inner if race == "inner" else self.outer
        own = forces[..., 3] - self.radius[:, np.newaxis] * forces[..., 2]
        return np.asarray(own.sum(axis=1))


def motion_of(
    p: Columns, rolling: Rolling, inner_angle: Floats, outer_angle: Floats, controlled: BallMotion
) -> tuple[BallMotion, Floats]:
    """The motion as raceway control describes it, and the yaw β' of the balls' axes.

    inner_angle, outer_angle: contact angles, (cases, balls). controlled: the motion under raceway
    control, which rings that turn alike leave to the balls. The ball turns at ω_R about the axis
    (cos β cos β', cos β sin β', -sin β), along x, toward increasing azimuth and outward, seen from
    the cage: β' = atan(ω_y/ω_x). Harris (1971).
    """
    orbit = np.broadcast_to(rolling.cage_speed[:, np.newaxis], inner_angle.shape)
    inner, outer = p[layout.INNER_SPEED][:, np.newaxis], p[layout.OUTER_SPEED][:, np.newaxis]
    sign = np.where(outer >= inner, 1.0, -1.0)
    x, along, out = (rolling.angular_velocity[..., i] for i in range(3))
    speed = sign * np.sqrt((x - orbit) ** 2 + along**2 + out**2)
    motion = BallMotion(
        orbital_speed=orbit.copy(),
        ball_speed=speed,
        attitude=np.arctan2(-sign * out, np.hypot(x - orbit, along)),
        inner_spin=(x - inner) * np.sin(inner_angle) + out * np.cos(inner_angle),
        outer_spin=-(x - outer) * np.sin(outer_angle) - out * np.cos(outer_angle),
        inner_roll=(x - inner) * np.cos(inner_angle) - out * np.sin(inner_angle),
        outer_roll=(x - outer) * np.cos(outer_angle) - out * np.sin(outer_angle),
    )
    yaw = np.arctan2(sign * along, sign * (x - orbit))
    alike = inner == outer
    chosen = (
        np.where(alike, getattr(controlled, f.name), getattr(motion, f.name))
        for f in fields(BallMotion)
    )
    return BallMotion(*chosen), np.where(alike, 0.0, yaw)
