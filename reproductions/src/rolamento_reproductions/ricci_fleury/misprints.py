"""Misprints of Ricci and Fleury: equations 10 to 19, against Hertz's theory and against ω × r."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np

from rolamento.contact.hertz import elliptical_contact
from rolamento.numerics.elliptic import complete
from rolamento_reproductions.record import (
    Errata,
    Floats,
    Misprint,
    Proof,
    Section,
    ValidEquation,
    proven,
    residual,
)
from rolamento_reproductions.ricci_fleury.inputs import said
from rolamento_reproductions.text import Text, formula

_COUNT: Final = 2000
_SEED: Final = 1993


@dataclass(frozen=True, slots=True)
class _Contacts:
    """Random contacts of balls with grooves; arrays (contacts,), SI and rad."""

    load: Floats
    rolling: Floats
    across: Floats
    moduli: tuple[Floats, Floats]
    ratios: tuple[Floats, Floats]
    diameter: Floats
    pitch_radius: Floats
    arc: Floats
    semi_major: Floats
    angle: Floats
    ring: Floats
    ball: Floats

    @property
    def compliance(self) -> tuple[Floats, Floats]:
        """(1 − ν²)/E of both bodies; 1/Pa."""
        first, second = ((1.0 - nu**2) / e for nu, e in zip(self.ratios, self.moduli, strict=True))
        return first, second


@cache
def _contacts() -> _Contacts:
    random = np.random.default_rng(_SEED)

    def between(low: float, high: float) -> Floats:
        return random.uniform(low, high, _COUNT)

    diameter, f = between(2e-3, 20e-3), between(0.505, 0.57)
    return _Contacts(
        load=between(1.0, 2000.0),
        rolling=between(1.2, 3.0) / diameter,
        across=(2.0 - 1.0 / f) / diameter,
        moduli=(between(180e9, 320e9), between(180e9, 320e9)),
        ratios=(between(0.2, 0.35), between(0.2, 0.35)),
        diameter=diameter,
        pitch_radius=0.5 * diameter * between(3.0, 12.0),
        arc=2.0 * f * diameter / (2.0 * f + 1.0),
        semi_major=diameter * between(0.02, 0.3),
        angle=between(0.1, 1.2),
        ring=between(1.0, 800.0),
        ball=random.uniform(-3000.0, 3000.0, (_COUNT, 3)),
    )


def misprints_section(title: Text) -> Section:
    """Derive the misprints and prove them."""
    errata = Errata(
        caption=said("misprints_section.caption"),
        source=said("misprints_section.source"),
        remarks=_REMARKS,
        misprints=(_curvature(), _modulus(), _arc_centre(), _inner_line()),
        valid=(*_clearances(), _outer_line()),
        attitudes=_COUNT,
    )
    return Section(title, (errata,))


_REMARKS = (said("remarks.symbols_as_in"), said("remarks.18_is_right"))


def _ellipse(modulus: Floats, radius: Floats) -> Floats:
    """a, b and δ by (10), (11) and (12), (contacts, 3), with the exact k, K and E."""
    c = _contacts()
    k = elliptical_contact(c.load, c.rolling, c.across, 1.0).ellipticity
    first, second = complete(1.0 / k**2)
    common = 6.0 * second * c.load * radius / (np.pi * modulus)
    pressed = 4.5 / (second * radius) * (c.load / (np.pi * k * modulus)) ** 2
    return np.stack(
        [np.cbrt(k**2 * common), np.cbrt(common / k), first * np.cbrt(pressed)], axis=-1
    )


def _curvature() -> Misprint:
    c = _contacts()
    total = c.rolling + c.across
    first, second = c.compliance
    contact = elliptical_contact(c.load, c.rolling, c.across, 2.0 / (first + second))
    truth = np.stack([contact.semi_major, contact.semi_minor, contact.deflection], axis=-1)
    modulus = 2.0 / (first + second)
    return proven(
        ("10", said("equations_10_to_12")),
        said("curvature.what"),
        (said("curvature.r_c_sum"), said("curvature.r_c_reduced")),
        said("curvature.derivation"),
        Proof(
            _ellipse(modulus, total) / truth,
            _ellipse(modulus, 1.0 / total) / truth,
            np.ones_like(truth),
            np.ones_like(total),
        ),
    )


def _modulus() -> Misprint:
    c = _contacts()
    first, second = c.compliance
    printed = 2.0 / (1.0 - c.ratios[0] ** 2 / c.moduli[0] + second)
    # what E′ has to be, from the exact ellipse
    radius = 1.0 / (c.rolling + c.across)
    contact = elliptical_contact(c.load, c.rolling, c.across, 2.0 / (first + second))
    e = complete(1.0 / contact.ellipticity**2)[1]
    truth = 6.0 * contact.ellipticity**2 * e * c.load * radius / (np.pi * contact.semi_major**3)
    return proven(
        ("13", said("equation", number="13")),
        said("modulus.what"),
        (
            formula("E′ = 2/[1 − ν_a²/E_a + (1 − ν_b²)/E_b]"),
            formula("E′ = 2/[(1 − ν_a²)/E_a + (1 − ν_b²)/E_b]"),
        ),
        said("modulus.derivation"),
        Proof(printed, 2.0 / (first + second), truth, truth),
    )


def _arc_centre() -> Misprint:
    c = _contacts()
    chord = np.sqrt(c.arc**2 - c.semi_major**2)
    half = 0.5 * c.diameter
    # the effective rolling radius: the arc at the line of pure rolling of Heathcote, 0.347 a
    line = np.sqrt(c.arc**2 - (0.347 * c.semi_major) ** 2)
    effective = line - chord + np.sqrt(half**2 - c.semi_major**2)
    normal = np.stack([np.sin(c.angle), np.cos(c.angle)], axis=-1)
    tangent = np.stack([np.cos(c.angle), -np.sin(c.angle)], axis=-1)

    def edge(radius: Floats) -> Floats:
        """How far the arc's end, ±a from its middle, is from the ball's centre."""
        shift = -(chord - np.sqrt(radius**2 - c.semi_major**2))
        end = (shift + chord)[:, None] * normal + c.semi_major[:, None] * tangent
        return np.asarray(np.linalg.norm(end, axis=-1))

    sagitta = 0.5 * c.semi_major**2 / c.arc
    return proven(
        ("16", said("equations_16_and_17")),
        said("arc_centre.what"),
        (said("arc_centre.with_r_e"), said("arc_centre.r_e_d")),
        said("arc_centre.derivation"),
        Proof(edge(effective), edge(half), half, sagitta),
    )


def _line_terms(side: float) -> tuple[Floats, Floats, Floats, Floats]:
    """x′ and z′ of a point of a contact, the ring's slip there along y, and the speeds' size."""
    c = _contacts()
    x, z = (side * 0.5 * c.diameter * part for part in (np.sin(c.angle), np.cos(c.angle)))
    zero = np.zeros_like(x)
    place = np.stack([x, zero, z], axis=-1)
    centre = np.stack([zero, zero, c.pitch_radius], axis=-1)
    ring = c.ring[:, None] * np.array([1.0, 0.0, 0.0])
    velocities = np.cross(ring, centre + place), np.cross(c.ball, place)
    size = np.linalg.norm(velocities[0], axis=-1) + np.linalg.norm(velocities[1], axis=-1)
    return x, z, (velocities[0] - velocities[1])[:, 1], size


def _inner_line() -> Misprint:
    c = _contacts()
    x, z, slip, size = _line_terms(-1.0)
    ball_x, ball_z = c.ball[:, 0], -c.ball[:, 2]
    return proven(
        ("19", said("equation", number="19")),
        said("inner_line.what"),
        (
            formula("ω_1 (e − z′) + ω_z x′ + ω_x z′ = 0"),
            formula("ω_1 (e + z′) − ω_z x′ − ω_x z′ = 0"),
        ),
        said("inner_line.derivation"),
        Proof(
            c.ring * (c.pitch_radius - z) + ball_z * x + ball_x * z,
            c.ring * (c.pitch_radius + z) - ball_z * x - ball_x * z,
            -slip,
            size,
        ),
    )


def _outer_line() -> ValidEquation:
    c = _contacts()
    x, z, slip, size = _line_terms(1.0)
    form = c.ring * (c.pitch_radius + z) + c.ball[:, 2] * x - c.ball[:, 0] * z
    return ValidEquation(
        "18",
        said("equation_18.what"),
        formula("ω_0 (e + z′) − ω_z x′ − ω_x z′ = 0"),
        residual(form, -slip, size),
    )


def _clearances() -> tuple[ValidEquation, ...]:
    """Angle and play of a bearing from where its grooves touch the balls."""
    c = _contacts()
    distance = c.diameter * 0.05
    clearance = 2.0 * distance * (1.0 - np.cos(c.angle))
    radial = distance - 0.5 * clearance
    axial = np.sqrt(distance**2 - radial**2)  # shift until the groove centres are D apart
    return (
        ValidEquation(
            "5",
            said("equation_5.what"),
            formula("cos β_f = (D − P_d/2)/D"),
            residual(radial / distance, np.cos(np.arctan2(axial, radial)), np.ones_like(axial)),
        ),
        ValidEquation(
            "8",
            said("equation_8.what"),
            formula("P_a = 2 D sin β_f"),
            residual(2.0 * distance * np.sin(c.angle), 2.0 * axial, distance),
        ),
    )
