"""Figures 5.6 to 5.9: speeds of balls and cage, and what they do to a ball of the 209."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from rolamento.kinematics import ball_mass, ball_motion, centrifugal_force, gyroscopic_moment
from rolamento_reproductions.radaelli_2013.inputs import RPM, bearing, grid, inputs_of, source_of
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
)
from rolamento_reproductions.text import Text, said

__all__ = ["motion_section"]

_LITTLE = 0.25
"""A change over the range of contact angles that still counts as little, beside that by speed."""

_SPEED = said("Inner ring speed n_i", "Rotação do anel interno n_i")
_ANGLE = said("Contact angle α", "Ângulo de contato α")


@dataclass(frozen=True, slots=True)
class _Quantity:
    """One of the four: number of its figure, name, unit, title, and its power of the speed."""

    number: str
    name: str
    unit: str
    title: Text
    caption: Text
    power: int


_QUANTITIES = (
    _Quantity(
        "5.6",
        "ball_speed",
        "rpm",
        said("Ball speed n_R", "Rotação da esfera n_R"),
        said("speed of a ball about its own axis", "rotação da esfera em torno do próprio eixo"),
        1,
    ),
    _Quantity(
        "5.7",
        "orbital_speed",
        "rpm",
        said("Cage speed n_m", "Rotação da gaiola n_m"),
        said("speed of the cage", "rotação da gaiola (separador)"),
        1,
    ),
    _Quantity(
        "5.8",
        "centrifugal_force",
        "N",
        said("Centrifugal force F_c", "Força centrífuga F_c"),
        said("centrifugal force on a ball", "força centrífuga na esfera"),
        2,
    ),
    _Quantity(
        "5.9",
        "gyroscopic_moment",
        "N·m",
        said("Gyroscopic moment |M_g|", "Momento giroscópico |M_g|"),
        said("gyroscopic moment on a ball", "momento giroscópico na esfera"),
        2,
    ),
)


def motion_section(title: Text) -> Section:
    """Compute figures 5.6 to 5.9."""
    given = inputs_of("motion")
    speeds = grid(0.0, given["highest_speed_rpm"], given["speed_step_rpm"])
    angles = grid(0.0, given["highest_angle_deg"], given["angle_step_deg"])
    values = _values(speeds, angles)
    return Section(
        title, tuple(_figure(what, speeds, angles, values[what.name]) for what in _QUANTITIES)
    )


def _values(speeds: Floats, angles: Floats) -> dict[str, Floats]:
    """Evaluate the four, (angles, speeds), in the units of the figures; their sizes."""
    rings = bearing("209")
    alpha = np.radians(angles)[:, np.newaxis]
    motion = ball_motion(alpha, alpha, rings.ball_diameter / rings.pitch_diameter, speeds * RPM)
    mass = ball_mass(rings.ball_diameter, rings.ring_material.density)
    return {
        "ball_speed": np.abs(motion.ball_speed) / RPM,
        "orbital_speed": motion.orbital_speed / RPM,
        "centrifugal_force": centrifugal_force(mass, rings.pitch_diameter, motion.orbital_speed),
        "gyroscopic_moment": np.abs(gyroscopic_moment(mass, rings.ball_diameter, motion)),
    }


def _figure(what: _Quantity, speeds: Floats, angles: Floats, values: Floats) -> Figure:
    given = inputs_of("motion")
    columns = (
        Series("contact_angle", "°", _ANGLE, np.repeat(angles, speeds.size)),
        Series("inner_speed", "rpm", _SPEED, np.tile(speeds, angles.size)),
        Series(what.name, what.unit, what.title, values.ravel()),
    )
    signed = said(
        "The size is drawn; its sign is negative when only the inner ring turns.",
        "Desenha-se o módulo; o sinal é negativo quando só o anel interno gira.",
    )
    return Figure(
        number=what.number,
        caption=said(
            "The 209: {}, over speed and over contact angle; outer ring at rest.",
            "209: {}, em função da rotação e do ângulo de contato; anel externo parado.",
            what.caption,
        ),
        source=source_of("motion"),
        columns=columns,
        picture=Curves((_over_speed(what, given), _over_angle(what, given))),
        claims=(_growth_with_speed(what, speeds, values), _growth_with_angle(what, values)),
        notes=(signed,) if what.name == "gyroscopic_moment" else (),
    )


def _over_speed(what: _Quantity, given: dict[str, Any]) -> Panel:
    lines = tuple(
        Line(what.name, look, said("α = {:.0f}°", "α = {:.0f}°", angle), ("contact_angle", angle))
        for look, angle in enumerate(given["angles_drawn_deg"])
    )
    return Panel("inner_speed", what.title, what.unit, lines, tick=25_000.0)


def _over_angle(what: _Quantity, given: dict[str, Any]) -> Panel:
    lines = tuple(
        Line(
            what.name,
            look,
            said("{:,.0f} rpm", "{:,.0f} rpm", speed),
            ("inner_speed", speed),
        )
        for look, speed in enumerate(given["speeds_drawn_rpm"])
    )
    return Panel("contact_angle", what.title, what.unit, lines, tick=15.0)


def _growth_with_speed(what: _Quantity, speeds: Floats, values: Floats) -> Claim:
    """Fit the exponent of the speed at the greatest contact angle."""
    turning = speeds > 0.0
    x, y = np.log(speeds[turning]), np.log(values[-1][turning])
    exponent = float(np.polynomial.Polynomial.fit(x, y, 1).convert().coef[1])
    statement = (
        said("It is proportional to the speed.", "É proporcional à rotação.")
        if what.power == 1
        else said(
            "It grows with the square of the speed: four times as much at twice the speed.",
            "Cresce com o quadrado da rotação: quatro vezes maior com o dobro da rotação.",
        )
    )
    return Claim(
        statement,
        said("Exponent of the speed: {:.3f}.", "Expoente da rotação: {:.3f}.", exponent),
        abs(exponent - what.power) < 5e-4,
    )


def _growth_with_angle(what: _Quantity, values: Floats) -> Claim:
    """Compare the ends of the range of contact angles, at the greatest speed."""
    first, last = float(values[0, -1]), float(values[-1, -1])
    if what.name == "gyroscopic_moment":
        return Claim(
            said(
                "The contact angle matters as much as the speed does.",
                "O ângulo de contato influi fortemente, assim como a rotação.",
            ),
            said(
                "From nothing at 0° to {:.2f} N·m at {:.0f}°, at the highest speed.",
                "De zero a 0° até {:.2f} N·m a {:.0f}°, na maior rotação.",
                last,
                inputs_of("motion")["highest_angle_deg"],
            ),
            first == 0.0 and last > 0.0,
        )
    change = last / first - 1.0
    return Claim(
        said(
            "The contact angle matters little; with it there is a slight growth.",
            "O ângulo de contato influi pouco; há um aumento discreto com ele.",
        ),
        said(
            "{:+.1f} % from 0° to {:.0f}°.",
            "{:+.1f} % de 0° a {:.0f}°.",
            100.0 * change,
            inputs_of("motion")["highest_angle_deg"],
        ),
        0.0 < change < _LITTLE and bool((np.diff(values[:, -1]) > 0.0).all()),
    )
