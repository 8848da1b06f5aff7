"""How balls move that friction alone controls: what `traction` finds, in the words of a result."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.equilibrium import rows
from rolamento.equilibrium.problem import Floats
from rolamento.geometry import Race
from rolamento.kinematics import BallMotion


@dataclass(frozen=True, slots=True)
class Rolling:
    """How friction-controlled balls move, and what that costs; cases without a result hold NaN.

    cage_speed (cases,), rad/s. angular_velocity (cases, balls, 3): of the balls along x, along
    increasing azimuth, and outward, absolute, rad/s. inner, outer (cases, balls, 6): force (x,
    outward, along azimuth; N) and moment about the ball's centre (x, azimuth, outward; N·m) of
    the race on the ball, the normal load included. power (cases, balls, 2): friction loss at the
    inner and the outer race, W.
    """

    cage_speed: Floats
    angular_velocity: Floats
    inner: Floats
    outer: Floats
    power: Floats
    radius: Floats

    def torque(self, race: Race) -> Floats:
        """Torque about x that the shaft or the housing puts on a ring to turn it; (cases,), N·m."""
        forces = self.inner if race == "inner" else self.outer
        own = forces[..., 3] - self.radius[:, np.newaxis] * forces[..., 2]
        return np.asarray(own.sum(axis=1))


def motion_of(
    p: Floats, rolling: Rolling, inner_angle: Floats, outer_angle: Floats
) -> tuple[BallMotion, Floats]:
    """The motion as raceway control describes it, and the yaw β' of the balls' axes.

    inner_angle, outer_angle: contact angles, (cases, balls). The yaw is the angle of the ball's
    axis out of the bearing's axial plane, toward increasing azimuth.
    """
    orbit = np.broadcast_to(rolling.cage_speed[:, np.newaxis], inner_angle.shape)
    inner, outer = p[rows.INNER_SPEED][:, np.newaxis], p[rows.OUTER_SPEED][:, np.newaxis]
    sign = np.where(outer >= inner, 1.0, -1.0)
    x, along, out = (rolling.angular_velocity[..., i] for i in range(3))
    speed = sign * np.sqrt((x - orbit) ** 2 + along**2 + out**2)
    motion = BallMotion(
        orbital_speed=orbit.copy(),
        ball_speed=speed,
        attitude=np.arctan2(-sign * out, sign * (x - orbit)),
        inner_spin=(x - inner) * np.sin(inner_angle) + out * np.cos(inner_angle),
        outer_spin=-(x - outer) * np.sin(outer_angle) - out * np.cos(outer_angle),
        inner_roll=(x - inner) * np.cos(inner_angle) - out * np.sin(inner_angle),
        outer_roll=(x - outer) * np.cos(outer_angle) - out * np.sin(outer_angle),
    )
    yaw = np.arcsin(np.clip(sign * along / np.abs(speed), -1.0, 1.0))
    return motion, yaw
