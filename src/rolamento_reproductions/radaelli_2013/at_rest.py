"""Figures 5.1 to 5.9: the 209 and the 218 at rest, and the speeds of balls and cage of the 209."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from rolamento.kinematics import ball_mass, ball_motion, centrifugal_force, gyroscopic_moment
from rolamento.static import RadialSolution, axial_load, radial_load
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI, grid
from rolamento_reproductions.radaelli_2013.inputs import bearing, inputs_of, source_of
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
from rolamento_reproductions.text import Text, said, same

_MAX_BEND = 0.03
"""How far from a straight line, as a part of the maximum value, still reads as one in print."""
_FIRST, _LAST = 5.0, -5.0  # kN, ends of a curve that are compared

_RADIAL = said("Radial load F_r", "Carga radial F_r")
_AXIAL = said("Axial load F_a", "Carga axial F_a")
_LOAD = said("Maximum ball load Q_max", "Carga máxima na esfera Q_max")


def static_section(title: Text) -> Section:
    """Compute figures 5.1 to 5.5."""
    return Section(title, (_distribution(), *_radial_curves(), *_axial_curves()))


# --- figure 5.1 -------------------------------------------------------------


def _distribution() -> Figure:
    given = inputs_of("radial_distribution")
    clearances = [float(value) for value in given["clearances_mm"]]
    solved = {
        value: radial_load(
            bearing("209").replace(diametral_clearance=value * MILLI), given["radial_load_N"]
        )
        for value in clearances
    }
    azimuth = grid(-180.0, 180.0, 1.0)
    spacing = 360.0 / bearing("209").ball_count
    # balls at 0, ±40°, …: their number, from 1 on, and nothing between them
    place = np.mod(azimuth, 360.0) / spacing
    ball = np.where(np.isclose(place, np.round(place)), np.round(place) + 1.0, np.nan)
    columns = (
        Series(
            "diametral_clearance",
            "mm",
            said("Diametral clearance P_d", "Folga diametral P_d"),
            np.repeat(clearances, azimuth.size),
        ),
        Series("azimuth", "°", said("Azimuth ψ", "Azimute ψ"), np.tile(azimuth, len(clearances))),
        Series("ball", "", said("Ball", "Esfera"), np.tile(ball, len(clearances))),
        Series(
            "ball_load",
            "N",
            said("Ball load Q", "Carga na esfera Q"),
            np.concatenate([solved[v].load_at(np.radians(azimuth)) for v in clearances]),
        ),
    )
    lines = tuple(
        Line(
            "ball_load",
            look,
            same("P_d = {:.2f} mm", value),
            by=("diametral_clearance", value),
            marked="ball",
        )
        for look, value in enumerate(clearances)
    )
    return Figure(
        number="5.1",
        caption=said(
            "The 209 under a radial load of {:,.0f} N, at rest: ball load round the ring, with"
            " clearance, without, and with interference. Markers: the nine balls.",
            "209 sob carga radial de {:,.0f} N, parado: carga nas esferas ao redor do anel, com"
            " folga, sem folga e com interferência. Marcadores: as nove esferas.",
            given["radial_load_N"],
        ),
        source=source_of("radial_distribution"),
        columns=columns,
        picture=Curves((Panel("azimuth", columns[3].title, "N", lines, tick=45.0, around=True),)),
        claims=_claims_on_clearance(solved),
        notes=(_note_on_integral(),),
    )


def _claims_on_clearance(solved: dict[float, RadialSolution]) -> tuple[Claim, ...]:
    states = [solved[value] for value in sorted(solved)]
    zones = [float(np.degrees(state.load_zone_half_angle)) for state in states]
    maximum = [float(state.max_ball_load) for state in states]
    counts = [int((state.ball_loads > 0.0).sum()) for state in states]
    none = float(np.degrees(solved[0.0].load_zone_half_angle))
    return (
        Claim(
            said(
                "The greater the clearance, the sooner a ball is without load.",
                "Quanto maior a folga, menor o ângulo em que a esfera perde a carga.",
            ),
            said(
                "The load zone ends at ±{:.1f}° with interference, ±{:.1f}° without clearance and"
                " ±{:.1f}° with it.",
                "A zona de carga termina em ±{:.1f}° com interferência, ±{:.1f}° sem folga e"
                " ±{:.1f}° com folga.",
                *zones,
            ),
            zones == sorted(zones, reverse=True) and len(set(zones)) == len(zones),
        ),
        Claim(
            said(
                "Without clearance the load zone ends at exactly ±90°.",
                "Sem folga, a zona de carga termina exatamente em ±90°.",
            ),
            same("±{:.4f}°.", none),
            abs(none - 90.0) < 1e-6,
        ),
        Claim(
            said(
                "The greater the clearance, the greater the load on the ball at ψ = 0.",
                "Quanto maior a folga, maior a carga na esfera em ψ = 0.",
            ),
            same("{:,.0f} N, {:,.0f} N, {:,.0f} N.", *maximum),
            maximum == sorted(maximum) and len(set(maximum)) == len(maximum),
        ),
        Claim(
            said(
                "The greater the clearance, the fewer balls carry load.",
                "Quanto maior a folga, menos esferas sob carga.",
            ),
            said("{}, {} and {} of the nine balls.", "{}, {} e {} das nove esferas.", *counts),
            counts == sorted(counts, reverse=True) and counts[0] > counts[-1],
        ),
    )


def _note_on_integral() -> Text:
    """Tell what counting the balls gives instead."""
    load = inputs_of("radial_distribution")["radial_load_N"]
    states = [
        radial_load(bearing("209"), load, distribution=distribution)
        for distribution in ("continuous", "discrete")
    ]
    return said(
        "The load integral of a continuous ring of balls is used, as in the dissertation. With"
        " the bearing's own clearance it gives {:,.0f} N on the ball at ψ = 0; summing over the"
        " nine balls gives {:,.0f} N.",
        "Usa-se a integral de carga de um anel contínuo de esferas, como na dissertação. Com a"
        " folga própria do rolamento ela dá {:,.0f} N na esfera em ψ = 0; a soma sobre as nove"
        " esferas dá {:,.0f} N.",
        *(float(state.max_ball_load) for state in states),
    )


# --- figures 5.2 to 5.5 -----------------------------------------------------


def _static_loads() -> Floats:
    given = inputs_of("static_curves")
    return grid(0.0, given["highest_load_kN"], given["step_kN"])


def _radial_curves() -> tuple[Figure, Figure]:
    loads = _static_loads()
    state = radial_load(bearing("209"), loads * KILO)
    x = Series("radial_load", "kN", _RADIAL, loads)
    shift = Series(
        "radial_displacement",
        "mm",
        said("Radial displacement δ_r", "Deslocamento radial δ_r"),
        state.radial_displacement / MILLI,
    )
    ball = Series("max_ball_load", "kN", _LOAD, state.max_ball_load / KILO)
    return (
        _figure_over_load(
            "5.2",
            said(
                "The 209 under radial load, at rest: displacement of the inner ring.",
                "209 sob carga radial, parado: deslocamento do anel interno.",
            ),
            (x, shift),
            _stiffening(loads, shift.numbers),
            (
                said(
                    "At no load the ring rests at half the clearance, {:.4f} mm.",
                    "Sem carga, o anel repousa na metade da folga, {:.4f} mm.",
                    float(shift.numbers[0]),
                ),
            ),
        ),
        _figure_over_load(
            "5.3",
            said(
                "The 209 under radial load, at rest: load on the ball at ψ = 0.",
                "209 sob carga radial, parado: carga na esfera em ψ = 0.",
            ),
            (x, ball),
            _proportion(loads, ball.numbers),
        ),
    )


def _axial_curves() -> tuple[Figure, Figure]:
    loads = _static_loads()
    state = axial_load(bearing("218"), loads * KILO, stiffness_angle="free")
    x = Series("axial_load", "kN", _AXIAL, loads)
    shift = Series(
        "axial_displacement",
        "mm",
        said("Axial displacement δ_a", "Deslocamento axial δ_a"),
        state.axial_displacement / MILLI,
    )
    ball = Series("ball_load", "kN", _LOAD, state.ball_load / KILO)
    frozen = said(
        "The contact stiffness is kept as at the free contact angle, as table C.2 shows that the"
        " dissertation does.",
        "A rigidez do contato é mantida como no ângulo de contato livre, como a tabela C.2 mostra"
        " que a dissertação faz.",
    )
    return (
        _figure_over_load(
            "5.4",
            said(
                "The 218 under axial load, at rest: displacement of the inner ring.",
                "218 sob carga axial, parado: deslocamento do anel interno.",
            ),
            (x, shift),
            _stiffening(loads, shift.numbers),
            (frozen,),
        ),
        _figure_over_load(
            "5.5",
            said(
                "The 218 under axial load, at rest: load on each ball.",
                "218 sob carga axial, parado: carga em cada esfera.",
            ),
            (x, ball),
            _proportion(loads, ball.numbers),
            (
                said(
                    "The line bends a little because the contact angle rises from {:.1f}° to"
                    " {:.1f}°.",
                    "A linha se curva um pouco porque o ângulo de contato sobe de {:.1f}° a"
                    " {:.1f}°.",
                    *np.degrees(state.contact_angle[[0, -1]]),
                ),
            ),
        ),
    )


def _figure_over_load(
    number: str,
    caption: Text,
    columns: tuple[Series, Series],
    claim: Claim,
    notes: tuple[Text, ...] = (),
) -> Figure:
    x, y = columns
    return Figure(
        number=number,
        caption=caption,
        source=source_of("static_curves"),
        columns=columns,
        picture=Curves((Panel(x.name, y.title, y.unit, (Line(y.name, 0),)),)),
        claims=(claim,),
        notes=notes,
    )


def _stiffening(loads: Floats, shift: Floats) -> Claim:
    """Compare what the first and the last 5 kN move."""
    first = float(np.interp(_FIRST, loads, shift) - shift[0])
    last = float(shift[-1] - np.interp(loads[-1] + _LAST, loads, shift))
    return Claim(
        said(
            "The ring grows stiffer with load: the more it carries, the less a further load moves"
            " it.",
            "O anel fica mais rígido com a carga: quanto mais carrega, menos uma carga adicional o"
            " desloca.",
        ),
        said(
            "The first 5 kN move it by {:.4f} mm, the last 5 kN by {:.4f} mm.",
            "Os primeiros 5 kN o deslocam {:.4f} mm; os últimos 5 kN, {:.4f} mm.",
            first,
            last,
        ),
        bool(last < first and (np.diff(shift, 2) < 0.0).all()),
    )


def _proportion(loads: Floats, ball: Floats) -> Claim:
    """Measure how far the curve is from the best straight line."""
    line = np.polynomial.Polynomial.fit(loads, ball, 1)
    miss = float(np.abs(ball - line(loads)).max() / ball.max())
    return Claim(
        said("The ball load is linear in the load.", "A carga na esfera é linear com a carga."),
        said(
            "The best straight line misses it by at most {:.2f} % of the maximum value.",
            "A melhor reta erra no máximo {:.2f} % do maior valor.",
            100.0 * miss,
        ),
        miss < _MAX_BEND,
    )


_LITTLE_CHANGE = 0.25
"""A change over the range of contact angles that still counts as little, beside that by speed."""

_SPEED = said("Inner ring speed n_i", "Rotação do anel interno n_i")
_ANGLE = said("Contact angle α", "Ângulo de contato α")


@dataclass(frozen=True, slots=True)
class _Motion:
    """One of the four: number of its figure, name, unit, title, and its power of the speed."""

    number: str
    name: str
    unit: str
    title: Text
    caption: Text
    power: int


_MOTIONS = (
    _Motion(
        "5.6",
        "ball_speed",
        "rpm",
        said("Ball speed n_R", "Rotação da esfera n_R"),
        said("speed of a ball about its own axis", "rotação da esfera em torno do próprio eixo"),
        1,
    ),
    _Motion(
        "5.7",
        "orbital_speed",
        "rpm",
        said("Cage speed n_m", "Rotação da gaiola n_m"),
        said("speed of the cage", "rotação da gaiola (separador)"),
        1,
    ),
    _Motion(
        "5.8",
        "centrifugal_force",
        "N",
        said("Centrifugal force F_c", "Força centrífuga F_c"),
        said("centrifugal force on a ball", "força centrífuga na esfera"),
        2,
    ),
    _Motion(
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
    values = _speeds_and_forces(speeds, angles)
    return Section(
        title, tuple(_motion_figure(what, speeds, angles, values[what.name]) for what in _MOTIONS)
    )


def _speeds_and_forces(speeds: Floats, angles: Floats) -> dict[str, Floats]:
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


def _motion_figure(what: _Motion, speeds: Floats, angles: Floats, values: Floats) -> Figure:
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
        picture=Curves((_panel_over_speed(what, given), _panel_over_angle(what, given))),
        claims=(_growth_with_speed(what, speeds, values), _growth_with_angle(what, values)),
        notes=(signed,) if what.name == "gyroscopic_moment" else (),
    )


def _panel_over_speed(what: _Motion, given: dict[str, Any]) -> Panel:
    lines = tuple(
        Line(what.name, look, same("α = {:.0f}°", angle), ("contact_angle", angle))
        for look, angle in enumerate(given["angles_drawn_deg"])
    )
    return Panel("inner_speed", what.title, what.unit, lines, tick=25_000.0)


def _panel_over_angle(what: _Motion, given: dict[str, Any]) -> Panel:
    lines = tuple(
        Line(what.name, look, same("{:,.0f} rpm", speed), ("inner_speed", speed))
        for look, speed in enumerate(given["speeds_drawn_rpm"])
    )
    return Panel("contact_angle", what.title, what.unit, lines, tick=15.0)


def _growth_with_speed(what: _Motion, speeds: Floats, values: Floats) -> Claim:
    """Fit the exponent of the speed at the maximum contact angle."""
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


def _growth_with_angle(what: _Motion, values: Floats) -> Claim:
    """Compare the ends of the range of contact angles, at the maximum speed."""
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
        0.0 < change < _LITTLE_CHANGE and bool((np.diff(values[:, -1]) > 0.0).all()),
    )
