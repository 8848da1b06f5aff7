"""Misprints of equations 26 to 44: velocities at the contacts, against ω × r in space.

Random balls stand between random rings. Axes and angles are the authors': x along the shaft, z
radial, y = z × x; the outer contact lies on the -x side of the ball. At both contacts
t = (cos θ, 0, sin θ); the normals out of the ball are n_e = (-sin θ_e, 0, cos θ_e) and
n_i = (sin θ_i, 0, -cos θ_i). Speeds are seen from the cage.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento_reproductions.braga_almeida.inputs import said
from rolamento_reproductions.record import Misprint, Proof, ValidEquation, proven, residual
from rolamento_reproductions.text import Text, formula

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


_ALONG: Final = 1
_OUTER_SPIN: Final = "ω_s = ω_z cos θ_e − ω_x sin θ_e + ω_e sin θ_e"
_INNER_SPIN: Final = "ω_s = ω_x sin θ_i − ω_z cos θ_i − ω_i sin θ_i"


def equation(number: str) -> tuple[str, Text]:
    """Return an equation's number, and where it stands."""
    return number, said("equation", number=number)


def _equations(first: str, second: str) -> tuple[str, Text]:
    return first, said("equations", first=first, second=second)


def contact_misprints() -> tuple[Misprint, ...]:
    """Return those of sections 3 and 4, in the order of the paper."""
    a = attitudes()
    return (
        _ball_across(a),
        _direction(a.outer),
        _outer_ring(a.outer),
        _outer_ball(a.outer),
        _outer_slip(a.outer),
        _outer_transverse(a.outer),
        _outer_spin(a.outer),
        _outer_spin_by_angles(a),
        _inner_ring(a.inner),
        _inner_ball(a.inner),
        _inner_slip(a),
        _inner_transverse(a),
    )


def valid_contact_equations() -> tuple[ValidEquation, ...]:
    """Return the equations of the rotation at the inner contact, which hold."""
    a = attitudes()
    c = a.inner
    x, _, z = a.ball.T
    sine, cosine = np.sin(c.angle), np.cos(c.angle)
    by_parts = x * sine - c.ring * sine - z * cosine
    ratio = a.ball_speed / c.ring
    turn = np.cos(a.beta) * np.cos(a.yaw) * sine - np.sin(a.beta) * cosine
    by_angles = c.ring * (ratio * turn - sine)
    what = said("valid_contact_equations.rotation_at_inner")
    return (
        ValidEquation(
            "43",
            what,
            formula("ω_rot = ω_x sin θ_i − ω_i sin θ_i − ω_z cos θ_i"),
            residual(by_parts, c.spin, _turning(c)),
        ),
        ValidEquation(
            "44",
            what,
            formula("ω_rot = ω_R (cos β cos β′ sin θ_i − sin β cos θ_i) − ω_i sin θ_i"),
            residual(by_angles, c.spin, _turning(c)),
        ),
    )


def _turning(c: Contact) -> Floats:
    return np.asarray(np.linalg.norm(c.ball, axis=-1) + np.abs(c.ring))


def _angles(c: Contact) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """ω_x, ω_y, ω_z, sin θ and cos θ."""
    return (*c.ball.T, np.sin(c.angle), np.cos(c.angle))


# --- outer contact ----------------------------------------------------------


def _ball_across(a: Attitudes) -> Misprint:
    plane = a.ball_speed * np.cos(a.beta)
    return proven(
        equation("26"),
        said("ball_across.what"),
        (formula("ω_y = ω_R cos β sin β"), formula("ω_y = ω_R cos β sin β′")),
        said("ball_across.derivation"),
        Proof(plane * np.sin(a.beta), plane * np.sin(a.yaw), a.ball[:, _ALONG], a.ball_speed),
    )


def _direction(c: Contact) -> Misprint:
    forward = np.array([0.0, 1.0, 0.0])
    along = (c.ring * np.cos(c.angle))[:, None] * c.tangent
    beside = (c.ring * np.sin(c.angle))[:, None]
    return proven(
        ("", said("direction.place")),
        said("direction.what"),
        (said("direction.printed"), said("direction.corrected")),
        said("direction.derivation"),
        Proof(along + beside * forward, along - beside * c.normal, c.ring_vector, np.abs(c.ring)),
    )


def _outer_ring(c: Contact) -> Misprint:
    printed = -c.pitch_radius * c.ring - c.radius * c.ring * np.cos(c.angle)
    return proven(
        equation("28"),
        said("outer_ring.what"),
        (
            formula("v_e = −ω_e d_m/2 − ρ_e ω_e cos θ_e"),
            formula("v_e = −ω_e d_m/2 − ρ_e ω_e cos θ_e − x_0 ω_e sin θ_e"),
        ),
        said("outer_ring.derivation"),
        Proof(
            printed,
            printed - c.x * c.ring * np.sin(c.angle),
            c.ring_velocity[:, _ALONG],
            c.speed_scale,
        ),
    )


def _outer_ball(c: Contact) -> Misprint:
    x, _, z, sine, cosine = _angles(c)
    printed = -(x * cosine + z * sine) * c.radius
    return proven(
        equation("29"),
        said("outer_ball.what"),
        (
            formula("v_D = −ρ_e (ω_x cos θ_e + ω_z sin θ_e)"),
            formula("v_D = −ρ_e (ω_x cos θ_e + ω_z sin θ_e) + x_0 (ω_z cos θ_e − ω_x sin θ_e)"),
        ),
        said("outer_ball.derivation"),
        Proof(
            printed,
            printed + c.x * (z * cosine - x * sine),
            c.ball_velocity[:, _ALONG],
            c.speed_scale,
        ),
    )


def _outer_slip(c: Contact) -> Misprint:
    x, _, z, sine, cosine = _angles(c)
    printed = -c.pitch_radius * c.ring + c.radius * (x * cosine + z * sine - c.ring * cosine)
    spin = z * cosine - x * sine + c.ring * sine
    return proven(
        _equations("31", "32"),
        said("outer_slip.what"),
        (
            formula("v = −ω_e d_m/2 + ρ_e (ω_x cos θ_e + ω_z sin θ_e − ω_e cos θ_e)"),
            formula(
                "v = −ω_e d_m/2 + ρ_e (ω_x cos θ_e + ω_z sin θ_e − ω_e cos θ_e) − x_0 ω_s, "
                + _OUTER_SPIN
            ),
        ),
        said("outer_slip.derivation"),
        Proof(printed, printed - c.x * spin, c.slip[:, _ALONG], c.speed_scale),
    )


def _outer_transverse(c: Contact) -> Misprint:
    x, y, z, sine, cosine = _angles(c)
    spin = z * cosine - x * sine + c.ring * sine
    truth = np.einsum("ij,ij->i", c.slip, c.tangent)
    return proven(
        _equations("33", "34"),
        said("outer_transverse.what"),
        (formula("v_t = −ρ_e ω_y"), formula("v_t = −ρ_e ω_y + y_0 ω_s, " + _OUTER_SPIN)),
        said("outer_transverse.derivation"),
        Proof(-c.radius * y, -c.radius * y + c.y * spin, truth, c.speed_scale),
    )


def _outer_spin(c: Contact) -> Misprint:
    x, _, z, sine, cosine = _angles(c)
    ball = -x * sine + z * cosine
    return proven(
        equation("35"),
        said("outer_spin.what"),
        (
            formula("ω_rot = −ω_e sin θ_e − ω_x sin θ_e + ω_z cos θ_e"),
            formula("ω_rot = +ω_e sin θ_e − ω_x sin θ_e + ω_z cos θ_e"),
        ),
        said("outer_spin.derivation"),
        Proof(ball - c.ring * sine, ball + c.ring * sine, c.spin, _turning(c)),
    )


def _outer_spin_by_angles(a: Attitudes) -> Misprint:
    c = a.outer
    sine, cosine = np.sin(c.angle), np.cos(c.angle)
    ball = a.ball_speed * (np.sin(a.beta) * cosine - np.cos(a.beta) * np.cos(a.yaw) * sine)
    return proven(
        equation("36"),
        said("outer_spin_by_angles.what"),
        (
            formula("ω_rot = ω_R (sin β cos θ_e − cos β cos β′ sin θ_e) − ω_e sin θ_e"),
            formula("ω_rot = ω_R (sin β cos θ_e − cos β cos β′ sin θ_e) + ω_e sin θ_e"),
        ),
        said("outer_spin_by_angles.derivation"),
        Proof(ball - c.ring * sine, ball + c.ring * sine, c.spin, _turning(c)),
    )


# --- inner contact ----------------------------------------------------------


def _inner_ring(c: Contact) -> Misprint:
    drift, arm = -c.pitch_radius * c.ring, c.radius * c.ring * np.cos(c.angle)
    return proven(
        equation("39"),
        said("inner_ring.what"),
        (
            formula("v_i = −ω_i d_m/2 − ρ_i ω_i cos θ_i"),
            formula("v_i = −ω_i d_m/2 + ρ_i ω_i cos θ_i − x_0 ω_i sin θ_i"),
        ),
        said("inner_ring.derivation"),
        Proof(
            drift - arm,
            drift + arm - c.x * c.ring * np.sin(c.angle),
            c.ring_velocity[:, _ALONG],
            c.speed_scale,
        ),
    )


def _inner_ball(c: Contact) -> Misprint:
    x, _, z, sine, cosine = _angles(c)
    printed = (x * cosine + z * sine) * c.radius
    return proven(
        equation("40"),
        said("inner_ball.what"),
        (
            formula("v_D = ρ_i (ω_x cos θ_i + ω_z sin θ_i)"),
            formula("v_D = ρ_i (ω_x cos θ_i + ω_z sin θ_i) + x_0 (ω_z cos θ_i − ω_x sin θ_i)"),
        ),
        said("inner_ball.derivation"),
        Proof(
            printed,
            printed + c.x * (z * cosine - x * sine),
            c.ball_velocity[:, _ALONG],
            c.speed_scale,
        ),
    )


def _inner_slip(a: Attitudes) -> Misprint:
    c = a.inner
    x, _, z, sine, cosine = _angles(c)
    turn = np.cos(a.beta) * np.cos(a.yaw) * cosine + np.sin(a.beta) * sine
    printed = -c.pitch_radius * c.ring - c.radius * (a.ball_speed / c.ring * turn - cosine) * c.ring
    spin = x * sine - z * cosine - c.ring * sine
    return proven(
        equation("41"),
        said("inner_slip.what"),
        (
            formula(
                "v = −ω_i d_m/2 − ρ_i [ω_R (cos β cos β′ cos θ_i + sin β sin θ_i) − ω_i cos θ_i]"
            ),
            formula(
                "v = −ω_i d_m/2 − ρ_i [ω_R (cos β cos β′ cos θ_i + sin β sin θ_i) − ω_i cos θ_i]"
                " + x_0 ω_s, " + _INNER_SPIN
            ),
        ),
        said("inner_slip.derivation"),
        Proof(printed, printed + c.x * spin, c.slip[:, _ALONG], c.speed_scale),
    )


def _inner_transverse(a: Attitudes) -> Misprint:
    c = a.inner
    x, _, z, sine, cosine = _angles(c)
    spin = x * sine - z * cosine - c.ring * sine
    across = a.ball_speed * np.cos(a.beta) * np.sin(a.yaw) * c.radius
    truth = np.einsum("ij,ij->i", c.slip, c.tangent)
    return proven(
        equation("42"),
        said("inner_transverse.what"),
        (
            formula("v_t = −ρ_i ω_R cos β sin β′"),
            formula("v_t = +ρ_i ω_R cos β sin β′ − y_0 ω_s, " + _INNER_SPIN),
        ),
        said("inner_transverse.derivation"),
        Proof(-across, across - c.y * spin, truth, c.speed_scale),
    )
