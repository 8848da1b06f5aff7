"""Misprints of Braga and Almeida: those of orbit and conclusion, and one of Radaelli's."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np

from rolamento_reproductions.braga_almeida.contacts import (
    COUNT,
    Floats,
    attitudes,
    contact_misprints,
    equation,
    valid_contact_equations,
)
from rolamento_reproductions.braga_almeida.inputs import said
from rolamento_reproductions.record import (
    Errata,
    Misprint,
    Proof,
    Residual,
    Section,
    ValidEquation,
    proven,
    residual,
)
from rolamento_reproductions.text import Text, formula

_SEED: Final = 50
_SIGNALS: Final = 100
_SAMPLES: Final = 2048
_HARMONICS: Final = 6


@dataclass(frozen=True, slots=True)
class Orbits:
    """Balls that roll at both contacts without slip along rolling; arrays (attitudes,), SI.

    r_e, r_i: rolling radii; speed: of the inner ring to the outer; outer, inner, ball: ω_e, ω_i
    and ω_R as seen from the cage, from vectors.
    """

    pitch_radius: Floats
    r_e: Floats
    r_i: Floats
    theta_e: Floats
    theta_i: Floats
    beta: Floats
    yaw: Floats
    speed: Floats

    def turn(self, angle: Floats) -> Floats:
        """Cos β cos β′ cos θ + sin β sin θ, the braces of (38) and (45)."""
        return np.asarray(
            np.cos(self.beta) * np.cos(self.yaw) * np.cos(angle) + np.sin(self.beta) * np.sin(angle)
        )

    @property
    def outer_part(self) -> Floats:
        """(d_m/2 + r_e cos θ_e) over r_e times the braces."""
        arm = self.pitch_radius + self.r_e * np.cos(self.theta_e)
        return np.asarray(arm / (self.r_e * self.turn(self.theta_e)))

    @property
    def inner_part(self) -> Floats:
        """(d_m/2 − r_i cos θ_i) over r_i times the braces."""
        arm = self.pitch_radius - self.r_i * np.cos(self.theta_i)
        return np.asarray(arm / (self.r_i * self.turn(self.theta_i)))

    def inner_speed(self) -> Floats:
        """ω_i by (48), corrected."""
        return np.asarray(self.speed / (1.0 + self.inner_part / self.outer_part))

    def inner_speed_printed(self) -> Floats:
        """ω_i by (48) as printed."""
        arm = self.pitch_radius - self.r_e * np.cos(self.theta_e)
        outer_part = arm / (self.r_e * self.turn(self.theta_e))
        return np.asarray(self.speed / (1.0 + self.inner_part / outer_part))

    def outer_speed(self) -> Floats:
        """ω_e by (49)."""
        return np.asarray(-self.speed / (1.0 + self.outer_part / self.inner_part))

    def ball_speed(self) -> Floats:
        """ω_R by (50)."""
        return np.asarray(-self.speed / (1.0 / self.outer_part + 1.0 / self.inner_part))

    def from_vectors(self) -> tuple[Floats, Floats, Floats]:
        """ω_e, ω_i and ω_R: no slip along y at both points, and ω_i − ω_e = ω; solved."""
        zero = np.zeros_like(self.speed)
        axis = np.stack(
            [
                np.cos(self.beta) * np.cos(self.yaw),
                np.cos(self.beta) * np.sin(self.yaw),
                np.sin(self.beta),
            ],
            axis=-1,
        )
        shaft = np.array([1.0, 0.0, 0.0])
        centre = np.stack([zero, zero, self.pitch_radius], axis=-1)
        system = np.zeros((self.speed.size, 3, 3))
        contacts = ((self.r_e, self.theta_e, 1.0), (self.r_i, self.theta_i, -1.0))
        for row, (radius, angle, side) in enumerate(contacts):
            normal = side * np.stack([-np.sin(angle), zero, np.cos(angle)], axis=-1)
            place = radius[:, None] * normal
            system[:, row, row] = np.cross(shaft, centre + place)[:, 1]
            system[:, row, 2] = -np.cross(axis, place)[:, 1]
        system[:, 2, :2] = [-1.0, 1.0]
        right = np.stack([zero, zero, self.speed], axis=-1)
        found: Floats = np.asarray(np.linalg.solve(system, right[..., None])[..., 0], np.float64)
        return found[:, 0], found[:, 1], found[:, 2]


@cache
def _orbits() -> Orbits:
    """Draw them with the ball's axis on the side of the contacts, as rolling has it."""
    random = np.random.default_rng(_SEED)
    diameter = random.uniform(3e-3, 40e-3, COUNT)
    return Orbits(
        pitch_radius=0.5 * diameter * random.uniform(3.0, 12.0, COUNT),
        r_e=0.5 * diameter * random.uniform(0.95, 1.0, COUNT),
        r_i=0.5 * diameter * random.uniform(0.95, 1.0, COUNT),
        theta_e=random.uniform(0.1, 1.2, COUNT),
        theta_i=random.uniform(0.1, 1.2, COUNT),
        beta=random.uniform(0.05, 1.2, COUNT),
        yaw=random.uniform(-0.7, 0.7, COUNT),
        speed=random.uniform(50.0, 1500.0, COUNT),
    )


def orbit_misprint() -> Misprint:
    """Return that of equation (48)."""
    orbits = _orbits()
    numerator = "r_e [(d_m/2) − r_i cos θ_i] (cos β cos β′ cos θ_e + sin β sin θ_e)"
    printed = "r_i [(d_m/2) − r_e cos θ_e] (cos β cos β′ cos θ_i + sin β sin θ_i)"
    corrected = printed.replace("− r_e", "+ r_e")
    return proven(
        equation("48"),
        said("orbit_misprint.what"),
        (
            formula(f"ω_i = ω / {{1 + {numerator} / {printed}}}"),
            formula(f"ω_i = ω / {{1 + {numerator} / {corrected}}}"),
        ),
        said("orbit_misprint.derivation"),
        Proof(
            orbits.inner_speed_printed(),
            orbits.inner_speed(),
            orbits.from_vectors()[1],
            orbits.speed,
        ),
    )


def valid_orbit_equations() -> tuple[ValidEquation, ...]:
    """Return the equations of sections 2 and 5 that hold."""
    orbits = _orbits()
    outer, inner, ball = orbits.from_vectors()
    ratio = said("valid_orbit_equations.ball_speed_over")
    cage, middle = _mean_speeds()
    return (
        ValidEquation(
            "19", said("equation_19.what"), formula("n_m = ½ [n_i (1 − γ) + n_e (1 + γ)]"), cage
        ),
        ValidEquation(
            "22", said("ball_speed"), formula("n_R = ½ (d_m/D) (1 − γ) (1 + γ) (n_e − n_i)"), middle
        ),
        ValidEquation(
            "38",
            ratio,
            formula("ω_R/ω_e = (d_m/2 + r_e cos θ_e)/[r_e (cos β cos β′ cos θ_e + sin β sin θ_e)]"),
            residual(orbits.outer_part * outer, ball, np.abs(ball)),
        ),
        ValidEquation(
            "45",
            ratio,
            formula(
                "ω_R/ω_i = (−d_m/2 + r_i cos θ_i)/[r_i (cos β cos β′ cos θ_i + sin β sin θ_i)]"
            ),
            residual(-orbits.inner_part * inner, ball, np.abs(ball)),
        ),
        ValidEquation(
            "49",
            said("equation_49.what"),
            formula("ω_e = −ω/{1 + (38) r_i (cos β cos β′ cos θ_i + …)/[(d_m/2) − r_i cos θ_i]}"),
            residual(orbits.outer_speed(), outer, orbits.speed),
        ),
        ValidEquation(
            "50",
            said("ball_speed"),
            formula("ω_R = −ω/{1/(38) − 1/(45)}"),
            residual(orbits.ball_speed(), ball, np.abs(ball)),
        ),
    )


def _mean_speeds() -> tuple[Residual, Residual]:
    """Residuals of (19) and (22): one contact angle, the ball about the tangent."""
    o = _orbits()
    radius = np.maximum(o.r_e, o.r_i)
    angle = o.theta_e
    alike = Orbits(
        o.pitch_radius, radius, radius, angle, angle, angle, np.zeros_like(angle), o.speed
    )
    outer, inner, ball = alike.from_vectors()
    turned = o.yaw * o.speed  # the outer ring, in space; the inner turns by ω more
    gamma = radius * np.cos(angle) / o.pitch_radius
    cage = 0.5 * ((turned + o.speed) * (1.0 - gamma) + turned * (1.0 + gamma))
    speed = -0.5 * o.pitch_radius / radius * (1.0 - gamma) * (1.0 + gamma) * o.speed
    return (
        residual(cage, turned - outer, np.abs(inner) + np.abs(outer)),
        residual(speed, ball, np.abs(ball)),
    )


def radaelli_misprint() -> Misprint:
    """Return that of the same coordinates in Radaelli (2013), equation (41)."""
    a = attitudes()
    random = np.random.default_rng(41)
    azimuth = random.uniform(-np.pi, np.pi, COUNT)
    local = a.ball / a.ball_speed[:, None]
    radius = a.outer.pitch_radius
    sine, cosine = np.sin(azimuth), np.cos(azimuth)
    zero, one = np.zeros_like(sine), np.ones_like(sine)
    # local axes of a ball at ψ, from +z toward +y: x, along the orbit, outward
    turn = np.array([[one, zero, zero], [zero, cosine, sine], [zero, -sine, cosine]])
    outward = np.stack([zero, zero, radius], axis=-1)
    truth = np.einsum("ijn,nj->ni", turn, outward + local)
    corrected = np.stack(
        [
            local[:, 0],
            radius * sine + local[:, 1] * cosine + local[:, 2] * sine,
            radius * cosine - local[:, 1] * sine + local[:, 2] * cosine,
        ],
        axis=-1,
    )
    printed = corrected.copy()
    printed[:, 2] = radius * cosine + local[:, 1] * sine + local[:, 2] * cosine
    return proven(
        ("41", said("radaelli_misprint.place")),
        said("radaelli_misprint.what"),
        (
            formula("z = (d_m/2) cos ψ + y′ sin ψ + z′ cos ψ"),
            formula("z = (d_m/2) cos ψ − y′ sin ψ + z′ cos ψ"),
        ),
        said("radaelli_misprint.derivation"),
        Proof(printed, corrected, truth, one),
    )


def modulation_misprint() -> Misprint:
    """Return that of the conclusion: which modulation the impacts are."""
    from scipy.signal import hilbert

    random = np.random.default_rng(2)
    phase = 2.0 * np.pi * np.arange(_SAMPLES) / _SAMPLES
    envelope = np.ones((_SIGNALS, _SAMPLES))
    shares = random.uniform(0.05, 0.15, (_SIGNALS, _HARMONICS))
    passages = random.integers(4, 12, _SIGNALS)[:, None]
    for order in range(1, _HARMONICS + 1):
        start = random.uniform(0.0, 2.0 * np.pi, (_SIGNALS, 1))
        envelope += shares[:, order - 1, None] * np.cos(order * passages * phase + start)
    natural = random.integers(150, 400, _SIGNALS)[:, None]
    of_amplitude = envelope * np.cos(natural * phase)
    of_frequency = np.cos(natural * phase + np.sin(passages * phase))
    by_fm, by_am = (np.abs(hilbert(signal, axis=-1)) for signal in (of_frequency, of_amplitude))
    return proven(
        ("", said("modulation_misprint.place")),
        said("modulation_misprint.what"),
        (said("modulation_misprint.printed"), said("modulation_misprint.corrected")),
        said("modulation_misprint.derivation", signals=_SIGNALS),
        Proof(by_fm, by_am, envelope, envelope.max(axis=1)),
    )


def misprints_section(title: Text) -> Section:
    """Derive the misprints and prove them."""
    found = (*contact_misprints(), orbit_misprint(), modulation_misprint(), radaelli_misprint())
    valid = sorted(
        (*valid_orbit_equations(), *valid_contact_equations()), key=lambda one: int(one.number)
    )
    errata = Errata(
        caption=said("misprints_section.caption"),
        source=said("misprints_section.source"),
        remarks=_REMARKS,
        misprints=found,
        valid=tuple(valid),
        attitudes=COUNT,
    )
    return Section(title, (errata,))


_REMARKS = (
    said("remarks.axes_as_in"),
    said("remarks.point_contact_lies"),
    said("remarks.attitudes_balls_3"),
    said("remarks.before_36_and"),
)
