"""Random balls between random rings, and their surfaces' velocities from vectors in space.

Axes and angles are the authors': x along the shaft, z radial, y = z × x; the outer contact lies on
the -x side of the ball. At both contacts t = (cos θ, 0, sin θ); the normals out of the ball are
n_e = (-sin θ_e, 0, cos θ_e) and n_i = (sin θ_i, 0, -cos θ_i). Speeds are seen from the cage.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

__all__ = ["COUNT", "Attitudes", "Contact", "attitudes"]

Floats = NDArray[np.float64]
Side = Literal["outer", "inner"]

COUNT: Final = 2000
_SEED: Final = 1998


@dataclass(frozen=True, slots=True)
class Contact:
    """Random points in the contacts of one race; arrays (attitudes,), SI.

    x and y: of the point in the ellipse; radius: ρ there; ring: the ring's speed.
    """

    side: Side
    angle: Floats
    ring: Floats
    x: Floats
    y: Floats
    radius: Floats
    pitch_radius: Floats
    ball: Floats

    @property
    def tangent(self) -> Floats:
        """t, (attitudes, 3)."""
        zero = np.zeros_like(self.angle)
        return np.stack([np.cos(self.angle), zero, np.sin(self.angle)], axis=-1)

    @property
    def normal(self) -> Floats:
        """Out of the ball, (attitudes, 3)."""
        sign = 1.0 if self.side == "outer" else -1.0
        zero = np.zeros_like(self.angle)
        return np.asarray(sign * np.stack([-np.sin(self.angle), zero, np.cos(self.angle)], axis=-1))

    @property
    def place(self) -> Floats:
        """From the ball's centre, (attitudes, 3)."""
        forward = np.array([0.0, 1.0, 0.0])
        return np.asarray(
            self.x[:, None] * self.tangent
            + self.y[:, None] * forward
            + self.radius[:, None] * self.normal
        )

    @property
    def ring_vector(self) -> Floats:
        """The ring's angular velocity, (attitudes, 3)."""
        return np.asarray(self.ring[:, None] * np.array([1.0, 0.0, 0.0]))

    @property
    def ring_velocity(self) -> Floats:
        """ω × r of the ring about the shaft, (attitudes, 3)."""
        centre = self.pitch_radius[:, None] * np.array([0.0, 0.0, 1.0])
        return np.cross(self.ring_vector, centre + self.place)

    @property
    def ball_velocity(self) -> Floats:
        """ω × r of the ball about its centre, (attitudes, 3)."""
        return np.cross(self.ball, self.place)

    @property
    def slip(self) -> Floats:
        """Ring less ball, (attitudes, 3)."""
        return self.ring_velocity - self.ball_velocity

    @property
    def speed_scale(self) -> Floats:
        """The greater of both velocities; m/s."""
        sizes = (np.linalg.norm(v, axis=-1) for v in (self.ring_velocity, self.ball_velocity))
        return np.asarray(np.maximum(*sizes))

    @property
    def spin(self) -> Floats:
        """Ball relative to ring about the normal out of the ball; rad/s."""
        return np.asarray(np.einsum("ij,ij->i", self.ball - self.ring_vector, self.normal))


@dataclass(frozen=True, slots=True)
class Attitudes:
    """Random attitudes; arrays (attitudes,), SI and rad."""

    ball_speed: Floats
    beta: Floats
    yaw: Floats
    outer: Contact
    inner: Contact

    @property
    def ball(self) -> Floats:
        """The ball's angular velocity, (attitudes, 3)."""
        return self.outer.ball


@cache
def attitudes() -> Attitudes:
    """Draw them: bearings from 3 to 40 mm of ball diameter, any attitude of the ball."""
    random = np.random.default_rng(_SEED)

    def between(low: float, high: float) -> Floats:
        return random.uniform(low, high, COUNT)

    diameter = between(3e-3, 40e-3)
    pitch_radius = 0.5 * diameter * between(3.0, 12.0)
    ball_speed = between(100.0, 3000.0)
    beta, yaw = between(-1.5, 1.5), between(-np.pi, np.pi)
    ball = _turned(ball_speed, beta, yaw)

    def contact(side: Side) -> Contact:
        angle, ring = between(0.1, 1.4), between(50.0, 800.0)
        conformity, semi_major = between(0.505, 0.57), diameter * between(0.02, 0.3)
        semi_minor = semi_major * between(0.08, 0.9)
        across, turn = np.sqrt(between(0.0, 1.0)), between(0.0, 2.0 * np.pi)
        x, y = semi_major * across * np.cos(turn), semi_minor * across * np.sin(turn)
        arc = 2.0 * conformity * diameter / (2.0 * conformity + 1.0)
        radius = (
            np.sqrt(arc**2 - x**2)
            - np.sqrt(arc**2 - semi_major**2)
            + np.sqrt(0.25 * diameter**2 - semi_major**2)
        )
        return Contact(side, angle, ring, x, y, radius, pitch_radius, ball)

    return Attitudes(ball_speed, beta, yaw, contact("outer"), contact("inner"))


def _turned(speed: Floats, beta: Floats, yaw: Floats) -> Floats:
    """Turn ω_R along x by β toward z, then by β′ from x toward y, with matrices."""
    zero, one = np.zeros_like(beta), np.ones_like(beta)
    rise = np.array(
        [[np.cos(beta), zero, -np.sin(beta)], [zero, one, zero], [np.sin(beta), zero, np.cos(beta)]]
    )
    swing = np.array(
        [[np.cos(yaw), -np.sin(yaw), zero], [np.sin(yaw), np.cos(yaw), zero], [zero, zero, one]]
    )
    turn = np.einsum("ijn,jkn->nik", swing, rise)
    return np.asarray(turn @ np.array([1.0, 0.0, 0.0]) * speed[:, None])
