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

from rolamento_reproductions.record import Misprint, Proof, ValidEquation, proven, residual
from rolamento_reproductions.text import Text, formula, said

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
    return number, said("Equation ({})", "Equação ({})", number)


def _equations(first: str, second: str) -> tuple[str, Text]:
    return first, said("Equations ({}) and ({})", "Equações ({}) e ({})", first, second)


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
    what = said("rotation at the inner contact", "rotação no contato interno")
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
        said("the ball's angular velocity along y", "velocidade angular da esfera em y"),
        (formula("ω_y = ω_R cos β sin β"), formula("ω_y = ω_R cos β sin β′")),
        said(
            "The projection of ω_R on the plane x, y has the length ω_R cos β and stands at β′ to"
            " x. Only so do the squares of (25), (26) and (27) add up to ω_R².",
            "A projeção de ω_R no plano x, y tem comprimento ω_R cos β e faz o ângulo β′ com x. Só"
            " assim os quadrados de (25), (26) e (27) somam ω_R².",
        ),
        Proof(plane * np.sin(a.beta), plane * np.sin(a.yaw), a.ball[:, _ALONG], a.ball_speed),
    )


def _direction(c: Contact) -> Misprint:
    forward = np.array([0.0, 1.0, 0.0])
    along = (c.ring * np.cos(c.angle))[:, None] * c.tangent
    beside = (c.ring * np.sin(c.angle))[:, None]
    return proven(
        ("", said("Text before equation (28)", "Texto antes da equação (28)")),
        said("direction of ω_e sin θ_e", "direção de ω_e sin θ_e".replace("sin", "sen")),
        (
            said(
                "ω_e = ω_e cos θ_e t + ω_e sin θ_e y: the second part lies along the minor axis",
                "ω_e = ω_e cos θ_e t + ω_e sen θ_e y: a segunda parcela está no eixo menor",
            ),
            said(
                "ω_e = ω_e cos θ_e t − ω_e sin θ_e n_e: it lies along the normal",
                "ω_e = ω_e cos θ_e t − ω_e sen θ_e n_e: está na direção normal",
            ),
        ),
        said(
            "The shaft's direction has no part along y, the direction of rolling: x·y = 0,"
            " x·t = cos θ_e, x·n_e = −sin θ_e. So with the other parts said to lie along the minor"
            " axis: ω_x sin θ_e and ω_z cos θ_e. Equation (35) uses them rightly, about the"
            " normal.",
            "A direção do eixo não tem parcela em y, o sentido do rolamento: x·y = 0,"
            " x·t = cos θ_e, x·n_e = −sen θ_e. O mesmo vale para as outras parcelas ditas do eixo"
            " menor: ω_x sen θ_e e ω_z cos θ_e. A equação (35) as usa corretamente, na normal.",
        ),
        Proof(along + beside * forward, along - beside * c.normal, c.ring_vector, np.abs(c.ring)),
    )


def _outer_ring(c: Contact) -> Misprint:
    printed = -c.pitch_radius * c.ring - c.radius * c.ring * np.cos(c.angle)
    return proven(
        equation("28"),
        said("velocity of the outer race", "velocidade da pista externa"),
        (
            formula("v_e = −ω_e d_m/2 − ρ_e ω_e cos θ_e"),
            formula("v_e = −ω_e d_m/2 − ρ_e ω_e cos θ_e − x_0 ω_e sin θ_e"),
        ),
        said(
            "x × r has the y part −r_z, and r_z = d_m/2 + p_z with p_z = x_0 sin θ_e + ρ_e cos θ_e:"
            " the race is further out on one side of the ellipse than on the other.",
            "x × r tem a componente −r_z em y, e r_z = d_m/2 + p_z com"
            " p_z = x_0 sen θ_e + ρ_e cos θ_e: a pista está mais afastada do eixo de um lado da"
            " elipse do que do outro.",
        ),
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
        said("velocity of the ball, outer contact", "velocidade da esfera, contato externo"),
        (
            formula("v_D = −ρ_e (ω_x cos θ_e + ω_z sin θ_e)"),
            formula("v_D = −ρ_e (ω_x cos θ_e + ω_z sin θ_e) + x_0 (ω_z cos θ_e − ω_x sin θ_e)"),
        ),
        said(
            "(ω × p)·y = ω_z p_x − ω_x p_z with p_x = x_0 cos θ_e − ρ_e sin θ_e and"
            " p_z = x_0 sin θ_e + ρ_e cos θ_e. Print has the parts with ρ_e only.",
            "(ω × p)·y = ω_z p_x − ω_x p_z com p_x = x_0 cos θ_e − ρ_e sen θ_e e"
            " p_z = x_0 sen θ_e + ρ_e cos θ_e. O impresso só traz as parcelas com ρ_e.",
        ),
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
        said("slip along rolling, outer contact", "deslizamento no rolamento, contato externo"),
        (
            formula("v = −ω_e d_m/2 + ρ_e (ω_x cos θ_e + ω_z sin θ_e − ω_e cos θ_e)"),
            formula(
                "v = −ω_e d_m/2 + ρ_e (ω_x cos θ_e + ω_z sin θ_e − ω_e cos θ_e) − x_0 ω_s, "
                + _OUTER_SPIN
            ),
        ),
        said(
            "(28) less (29), both with their parts in x_0: these join to −x_0 ω_s, the spin about"
            " the normal as in (35). Off the ellipse's middle it is a large part of the slip.",
            "(28) menos (29), ambas com as parcelas em x_0: elas se reúnem em −x_0 ω_s, a rotação"
            " em torno da normal, como em (35). Fora do centro da elipse é grande parcela do"
            " deslizamento.",
        ),
        Proof(printed, printed - c.x * spin, c.slip[:, _ALONG], c.speed_scale),
    )


def _outer_transverse(c: Contact) -> Misprint:
    x, y, z, sine, cosine = _angles(c)
    spin = z * cosine - x * sine + c.ring * sine
    truth = np.einsum("ij,ij->i", c.slip, c.tangent)
    return proven(
        _equations("33", "34"),
        said("slip across rolling, outer contact", "deslizamento transversal, contato externo"),
        (formula("v_t = −ρ_e ω_y"), formula("v_t = −ρ_e ω_y + y_0 ω_s, " + _OUTER_SPIN)),
        said(
            "With t × y = n_e: (ω × p)·t = ρ_e ω_y − y_0 ω·n_e for the ball, and y_0 ω_e sin θ_e"
            " for the race. Their difference has the spin times y_0. (The ω_y of (26) is needed.)",
            "Com t × y = n_e: (ω × p)·t = ρ_e ω_y − y_0 ω·n_e para a esfera e y_0 ω_e sen θ_e para"
            " a pista. A diferença contém a rotação vezes y_0. (É preciso o ω_y corrigido de"
            " (26).)",
        ),
        Proof(-c.radius * y, -c.radius * y + c.y * spin, truth, c.speed_scale),
    )


def _outer_spin(c: Contact) -> Misprint:
    x, _, z, sine, cosine = _angles(c)
    ball = -x * sine + z * cosine
    return proven(
        equation("35"),
        said("rotation at the outer contact", "rotação no contato externo"),
        (
            formula("ω_rot = −ω_e sin θ_e − ω_x sin θ_e + ω_z cos θ_e"),
            formula("ω_rot = +ω_e sin θ_e − ω_x sin θ_e + ω_z cos θ_e"),
        ),
        said(
            "ω_rot = (ω − ω_e x)·n_e with n_e = (−sin θ_e, 0, cos θ_e): the ring's part is"
            " subtracted, and x·n_e is negative.",
            "ω_rot = (ω − ω_e x)·n_e com n_e = (−sen θ_e, 0, cos θ_e): a parcela do anel é"
            " subtraída, e x·n_e é negativo.",
        ),
        Proof(ball - c.ring * sine, ball + c.ring * sine, c.spin, _turning(c)),
    )


def _outer_spin_by_angles(a: Attitudes) -> Misprint:
    c = a.outer
    sine, cosine = np.sin(c.angle), np.cos(c.angle)
    ball = a.ball_speed * (np.sin(a.beta) * cosine - np.cos(a.beta) * np.cos(a.yaw) * sine)
    return proven(
        equation("36"),
        said(
            "rotation at the outer contact, by β and β′", "rotação no contato externo, por β e β′"
        ),
        (
            formula("ω_rot = ω_R (sin β cos θ_e − cos β cos β′ sin θ_e) − ω_e sin θ_e"),
            formula("ω_rot = ω_R (sin β cos θ_e − cos β cos β′ sin θ_e) + ω_e sin θ_e"),
        ),
        said(
            "(35) with (25) and (27). At β′ = 0 and a rolling radius of D/2, ω_rot = 0 and (38)"
            " mean tan(θ_e − β) = γ′ sin θ_e/(1 + γ′ cos θ_e), γ′ = D/d_m, hence"
            " tan β = sin θ_e/(cos θ_e + γ′): outer raceway control, as in Radaelli (2013), eq. 43."
            " The printed sign turns the left side round.",
            "(35) com (25) e (27). Com β′ = 0 e raio de rolamento D/2, ω_rot = 0 e (38) dão"
            " tg(θ_e − β) = γ′ sen θ_e/(1 + γ′ cos θ_e), γ′ = D/d_m, logo"
            " tg β = sen θ_e/(cos θ_e + γ′): controle pela pista externa, como em Radaelli (2013),"
            " eq. 43. O sinal impresso inverte o lado esquerdo.",
        ),
        Proof(ball - c.ring * sine, ball + c.ring * sine, c.spin, _turning(c)),
    )


# --- inner contact ----------------------------------------------------------


def _inner_ring(c: Contact) -> Misprint:
    drift, arm = -c.pitch_radius * c.ring, c.radius * c.ring * np.cos(c.angle)
    return proven(
        equation("39"),
        said("velocity of the inner race", "velocidade da pista interna"),
        (
            formula("v_i = −ω_i d_m/2 − ρ_i ω_i cos θ_i"),
            formula("v_i = −ω_i d_m/2 + ρ_i ω_i cos θ_i − x_0 ω_i sin θ_i"),
        ),
        said(
            "As (28), with p_z = x_0 sin θ_i − ρ_i cos θ_i: the inner contact lies nearer to the"
            " shaft than the ball's centre. Only with + does (39) less (40) give (41).",
            "Como (28), com p_z = x_0 sen θ_i − ρ_i cos θ_i: o contato interno está mais perto do"
            " eixo do que o centro da esfera. Só com + (39) menos (40) resulta em (41).",
        ),
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
        said("velocity of the ball, inner contact", "velocidade da esfera, contato interno"),
        (
            formula("v_D = ρ_i (ω_x cos θ_i + ω_z sin θ_i)"),
            formula("v_D = ρ_i (ω_x cos θ_i + ω_z sin θ_i) + x_0 (ω_z cos θ_i − ω_x sin θ_i)"),
        ),
        said(
            "As (29), with p_x = x_0 cos θ_i + ρ_i sin θ_i and p_z = x_0 sin θ_i − ρ_i cos θ_i. The"
            " text before it says outer race and means the inner.",
            "Como (29), com p_x = x_0 cos θ_i + ρ_i sen θ_i e p_z = x_0 sen θ_i − ρ_i cos θ_i. O"
            " texto que a antecede diz pista externa, mas trata da interna.",
        ),
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
        said("slip along rolling, inner contact", "deslizamento no rolamento, contato interno"),
        (
            formula(
                "v = −ω_i d_m/2 − ρ_i [ω_R (cos β cos β′ cos θ_i + sin β sin θ_i) − ω_i cos θ_i]"
            ),
            formula(
                "v = −ω_i d_m/2 − ρ_i [ω_R (cos β cos β′ cos θ_i + sin β sin θ_i) − ω_i cos θ_i]"
                " + x_0 ω_s, " + _INNER_SPIN
            ),
        ),
        said(
            "(39) less (40) as corrected; the parts in x_0 join to x_0 ω_s with the rotation ω_s of"
            " (43).",
            "(39) menos (40), corrigidas; as parcelas em x_0 se reúnem em x_0 ω_s, com a rotação"
            " ω_s de (43).",
        ),
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
        said("slip across rolling, inner contact", "deslizamento transversal, contato interno"),
        (
            formula("v_t = −ρ_i ω_R cos β sin β′"),
            formula("v_t = +ρ_i ω_R cos β sin β′ − y_0 ω_s, " + _INNER_SPIN),
        ),
        said(
            "On the t of both contacts the inner contact lies on the other side of the ball:"
            " t × y = −n_i, so that (ω × p)·t = −ρ_i ω_y + y_0 ω·n_i. The sign changes, and the"
            " spin comes in.",
            "Com o mesmo t nos dois contatos, o interno está do outro lado da esfera:"
            " t × y = −n_i, de modo que (ω × p)·t = −ρ_i ω_y + y_0 ω·n_i. O sinal se inverte, e"
            " entra a rotação.",
        ),
        Proof(-across, across - c.y * spin, truth, c.speed_scale),
    )
