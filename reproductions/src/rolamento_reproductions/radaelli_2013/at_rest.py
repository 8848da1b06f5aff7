"""Figures 5.1 to 5.9: the 209 and the 218 at rest, and the speeds of balls and cage of the 209."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from rolamento.kinematics import ball_mass, ball_motion, centrifugal_force, gyroscopic_moment
from rolamento.static import RadialSolution, axial_load, radial_load
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI, grid
from rolamento_reproductions.radaelli_2013.inputs import bearing, inputs_of, said, source_of
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
from rolamento_reproductions.text import Text, same

_MAX_BEND = 0.03
"""How far from a straight line, as a part of the maximum value, still reads as one in print."""
_FIRST, _LAST = 5.0, -5.0  # kN, ends of a curve that are compared

_RADIAL = said("radial.radial_load_f")
_AXIAL = said("axial_load_f")
_LOAD = said("load.maximum_ball_load")


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
            said("distribution.diametral_clearance"),
            np.repeat(clearances, azimuth.size),
        ),
        Series("azimuth", "°", said("azimuth"), np.tile(azimuth, len(clearances))),
        Series("ball", "", said("ball"), np.tile(ball, len(clearances))),
        Series(
            "ball_load",
            "N",
            said("ball_load_q"),
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
        caption=said("distribution.caption", radial_load_n=given["radial_load_N"]),
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
            said("claims_on_clearance.statement"),
            said("claims_on_clearance.finding", *zones),
            zones == sorted(zones, reverse=True) and len(set(zones)) == len(zones),
        ),
        Claim(
            said("claims_on_clearance.statement.without_clearance_load"),
            same("±{:.4f}°.", none),
            abs(none - 90.0) < 1e-6,
        ),
        Claim(
            said("claims_on_clearance.statement.greater_clearance_greater"),
            same("{:.0f} N, {:.0f} N, {:.0f} N.", *maximum),
            maximum == sorted(maximum) and len(set(maximum)) == len(maximum),
        ),
        Claim(
            said("claims_on_clearance.statement.greater_clearance_fewer"),
            said("claims_on_clearance.finding.and_nine_balls", *counts),
            counts == sorted(counts, reverse=True) and counts[0] > counts[-1],
        ),
    )


def _note_on_integral() -> Text:
    """Return what counting the balls gives instead."""
    load = inputs_of("radial_distribution")["radial_load_N"]
    states = [
        radial_load(bearing("209"), load, distribution=distribution)
        for distribution in ("continuous", "discrete")
    ]
    return said("note_on_integral", *(float(state.max_ball_load) for state in states))


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
        said("radial_curves.radial_displacement"),
        state.radial_displacement / MILLI,
    )
    ball = Series("max_ball_load", "kN", _LOAD, state.max_ball_load / KILO)
    return (
        _figure_over_load(
            "5.2",
            said("figure_5_2.caption"),
            (x, shift),
            _stiffening(loads, shift.numbers),
            (said("figure_5_2.at_no_load", numbers=float(shift.numbers[0])),),
        ),
        _figure_over_load(
            "5.3", said("figure_5_3.caption"), (x, ball), _proportion(loads, ball.numbers)
        ),
    )


def _axial_curves() -> tuple[Figure, Figure]:
    loads = _static_loads()
    state = axial_load(bearing("218"), loads * KILO, stiffness_angle="free")
    x = Series("axial_load", "kN", _AXIAL, loads)
    shift = Series(
        "axial_displacement",
        "mm",
        said("axial_displacement_delta"),
        state.axial_displacement / MILLI,
    )
    ball = Series("ball_load", "kN", _LOAD, state.ball_load / KILO)
    frozen = said("axial_curves.contact_stiffness_is")
    return (
        _figure_over_load(
            "5.4",
            said("figure_5_4.caption"),
            (x, shift),
            _stiffening(loads, shift.numbers),
            (frozen,),
        ),
        _figure_over_load(
            "5.5",
            said("figure_5_5.caption"),
            (x, ball),
            _proportion(loads, ball.numbers),
            (said("figure_5_5.line_bends_little", *np.degrees(state.contact_angle[[0, -1]])),),
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
        said("stiffening.statement"),
        said("stiffening.finding", first=first, last=last),
        bool(last < first and (np.diff(shift, 2) < 0.0).all()),
    )


def _proportion(loads: Floats, ball: Floats) -> Claim:
    """Measure how far the curve is from the best straight line."""
    line = np.polynomial.Polynomial.fit(loads, ball, 1)
    miss = float(np.abs(ball - line(loads)).max() / ball.max())
    return Claim(
        said("proportion.statement"),
        said("proportion.finding", miss=100.0 * miss),
        miss < _MAX_BEND,
    )


_LITTLE_CHANGE = 0.25
"""A change over the range of contact angles that still counts as little, beside that by speed."""

_SPEED = said("inner_ring_speed_n")
_ANGLE = said("contact_angle")


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
        said("figure_5_6.ball_speed_n"),
        said("figure_5_6.speed_ball_about"),
        1,
    ),
    _Motion(
        "5.7",
        "orbital_speed",
        "rpm",
        said("figure_5_7.cage_speed_n"),
        said("figure_5_7.speed_cage"),
        1,
    ),
    _Motion(
        "5.8",
        "centrifugal_force",
        "N",
        said("figure_5_8.centrifugal_force_f"),
        said("figure_5_8.centrifugal_force_on"),
        2,
    ),
    _Motion(
        "5.9",
        "gyroscopic_moment",
        "N·m",
        said("gyroscopic_moment_m_g"),
        said("figure_5_9.gyroscopic_moment_on"),
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
    signed = said("motion_figure.size_is_drawn")
    return Figure(
        number=what.number,
        caption=said("motion_figure.caption", caption=what.caption),
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
        Line(what.name, look, same("{:.0f} rpm", speed), ("inner_speed", speed))
        for look, speed in enumerate(given["speeds_drawn_rpm"])
    )
    return Panel("contact_angle", what.title, what.unit, lines, tick=15.0)


def _growth_with_speed(what: _Motion, speeds: Floats, values: Floats) -> Claim:
    """Fit the exponent of the speed at the maximum contact angle."""
    turning = speeds > 0.0
    x, y = np.log(speeds[turning]), np.log(values[-1][turning])
    exponent = float(np.polynomial.Polynomial.fit(x, y, 1).convert().coef[1])
    statement = (
        said("growth_with_speed.it_is_proportional")
        if what.power == 1
        else said("growth_with_speed.it_grows_with")
    )
    return Claim(
        statement,
        said("growth_with_speed.finding", exponent=exponent),
        abs(exponent - what.power) < 5e-4,
    )


def _growth_with_angle(what: _Motion, values: Floats) -> Claim:
    """Compare the ends of the range of contact angles, at the maximum speed."""
    first, last = float(values[0, -1]), float(values[-1, -1])
    if what.name == "gyroscopic_moment":
        return Claim(
            said("growth_with_angle.statement"),
            said(
                "growth_with_angle.finding",
                last=last,
                highest_angle_deg=inputs_of("motion")["highest_angle_deg"],
            ),
            first == 0.0 and last > 0.0,
        )
    change = last / first - 1.0
    return Claim(
        said("growth_with_angle.statement.contact_angle_matters"),
        said(
            "growth_with_angle.finding.from_0_to",
            change=100.0 * change,
            highest_angle_deg=inputs_of("motion")["highest_angle_deg"],
        ),
        0.0 < change < _LITTLE_CHANGE and bool((np.diff(values[:, -1]) > 0.0).all()),
    )
