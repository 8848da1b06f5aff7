"""Fault frequencies of a bearing: of its geometry, and of a solved state.

With γ = D cos α/d_m, ring speeds ω_i and ω_o, and a cage that lags by the part s of what it does
against the outer ring,

    ω_m = ω_o + ½ (1 - s) (1 - γ) (ω_i - ω_o)                cage
    ω_R = -½ (1 - s) (d_m/D) (1 - γ²) (ω_i - ω_o)            ball, seen from the cage

and damage to the outer race is met Z |ω_m - ω_o|, to the inner Z |ω_i - ω_m|, to a ball 2 |ω_R|
times in 2π. A slipping ball rolls on the outer race, on which centrifugal force presses it, and
slips on the inner: cage and ball slow down by the same part.

Sources: Harris, Rolling Bearing Analysis, 3rd ed. (1991); Braga and Almeida, equations 19 and 22.
See docs/theory/vibration-frequencies.md.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import cos, isfinite, nan, pi
from typing import Final, Literal, NamedTuple

import numpy as np

from rolamento.case.bearing import Bearing
from rolamento.errors import InputError
from rolamento.geometry import ring_geometry
from rolamento.kinematics import ball_motion
from rolamento.numerics import FloatArray
from rolamento.state import BallState, State
from rolamento.vibration.fault_lines import (
    FAULTS,
    LINES,
    NOTES,
    Band,
    FaultFrequencies,
    FaultKind,
    FaultLine,
    Harmonic,
    LineName,
    Turns,
    missing_line,
    plain_line,
)

__all__ = [
    "FAULTS",
    "LINES",
    "NOTES",
    "Band",
    "FaultFrequencies",
    "FaultKind",
    "FaultLine",
    "Harmonic",
    "Turns",
    "frequencies_of",
    "nominal_frequencies",
    "turns_of",
]

AngleChoice = Literal["zero", "free"]

_TURN: Final = 2.0 * pi
_RIGHT_ANGLE: Final = 0.5 * pi
_MOST_SPEED: Final = 1e7


class _Shaft(NamedTuple):
    """The rings' speeds, and which of them is the shaft; rad/s, NaN if not given."""

    inner: float
    outer: float
    role: Literal["inner", "outer"]
    speed: float

    @property
    def ratios(self) -> tuple[float, float]:
        """Speeds of inner and outer ring over the shaft's."""
        if not isfinite(self.speed) or self.speed == 0.0:
            return 1.0, 0.0
        return self.inner / self.speed, self.outer / self.speed

    @property
    def frequency(self) -> float:
        return abs(self.speed) / _TURN

    @property
    def notes(self) -> tuple[str, ...]:
        if self.speed == 0.0:
            return ("at_rest",)
        return ("turns_alike",) if self.inner == self.outer else ()


def nominal_frequencies(
    bearing: Bearing,
    inner_speed: float | None = None,
    outer_speed: float = 0.0,
    *,
    slip: float = 0.0,
    contact_angle: float | AngleChoice = "zero",
) -> FaultFrequencies:
    """Fault frequencies by the geometry alone.

    Parameters
    ----------
    bearing
        Its free contact angle is taken, if it is given by one.
    inner_speed, outer_speed
        Of the rings, signed (rad/s). With neither, the inner ring turns, and there are orders but
        no Hz.
    slip
        Part s of the cage's speed against the outer ring that it lags behind, from -1 to 1.
    contact_angle
        For a bearing given by its clearance: "zero", as under radial load, or "free", as under
        axial load. Or an angle for any bearing (rad).

    Raises
    ------
    InputError
        If a number is out of range.
    """
    shaft = shaft_of(inner_speed, outer_speed)
    _check_slip(slip)
    rows = [
        _nominal_row(place.bearing, shaft, slip, contact_angle, index)
        for index, place in enumerate(bearing.places)
    ]
    return rows[0] if len(rows) == 1 else replace(rows[0], rows=tuple(rows))


def frequencies_of(state: State, *, slip: float = 0.0) -> FaultFrequencies:
    """Fault frequencies of a solved state, with its loaded contact angles and its cage speed.

    Without friction control every ball would like an orbital speed of its own: the cage has the
    mean of the balls that the inner ring presses on, weighted by their loads. Minimum, mean and
    maximum over these balls stand beside.

    Parameters
    ----------
    state
        One that did not converge has NaN everywhere.
    slip
        Part of the cage's speed against the outer ring that it lags behind what the state says.

    Raises
    ------
    InputError
        If the slip is out of range.
    """
    _check_slip(slip)
    duty = state.case.duty
    shaft = shaft_of(duty.inner_speed, duty.outer_speed)
    rows = [
        _loaded_row(state, place.bearing, shaft, slip, index)
        for index, place in enumerate(state.case.bearing.places)
    ]
    if len(rows) == 1:
        return rows[0]
    carried = [
        sum(ball.inner.load for ball in state.balls if ball.row == index and ball.inner.load > 0.0)
        for index in range(len(rows))
    ]
    return replace(rows[int(np.argmax(carried))], rows=tuple(rows))


def turns_of(
    diameter_ratio: float,
    contact_angle: float,
    inner: float = 1.0,
    outer: float = 0.0,
    slip: float = 0.0,
) -> Turns:
    """Signed speeds of cage and ball between rings that turn; in the unit of inner and outer.

    Parameters
    ----------
    diameter_ratio
        γ' = D/d_m.
    contact_angle
        α, of both contacts (rad).
    inner, outer
        Speeds of the rings, signed.
    slip
        Part of the cage's speed against the outer ring that it lags behind.

    Braga and Almeida, equations 19 and 22, with the slip.
    """
    gamma = diameter_ratio * cos(contact_angle)
    lead = (1.0 - slip) * (inner - outer)
    cage = outer + 0.5 * (1.0 - gamma) * lead
    ball = -0.5 * (1.0 - gamma**2) / diameter_ratio * lead
    return Turns(inner, outer, cage, ball)


def shaft_of(inner_speed: float | None, outer_speed: float) -> _Shaft:
    """Return which ring is the shaft; InputError for speeds out of range."""
    for field, value in (("inner_speed", inner_speed), ("outer_speed", outer_speed)):
        if value is not None and not abs(value) <= _MOST_SPEED:
            raise InputError(
                f"must be a finite number up to {_MOST_SPEED:g} rad/s",
                field=field,
                value=value,
                example=f"{field} = 188.2",
            )
    if outer_speed != 0.0 and not inner_speed:
        return _Shaft(0.0, outer_speed, "outer", outer_speed)
    if inner_speed is None:
        return _Shaft(nan, 0.0, "inner", nan)
    return _Shaft(inner_speed, outer_speed, "inner", inner_speed)


def line_orders(turns: Turns, ball_count: int) -> dict[LineName, float]:
    """Return the signed orders of all lines, for speeds over the shaft's."""
    return {
        "cage": turns.cage,
        "ball_pass_outer": ball_count * (turns.cage - turns.outer),
        "ball_pass_inner": ball_count * (turns.inner - turns.cage),
        "ball_spin": turns.ball,
        "ball_spin_twice": 2.0 * turns.ball,
    }


def nominal_angle(
    bearing: Bearing, contact_angle: float | AngleChoice
) -> tuple[float, tuple[str, ...]]:
    """Return the contact angle of a plain bearing (rad), and what to say about it."""
    if isinstance(contact_angle, str):
        if contact_angle not in ("zero", "free"):
            raise InputError(
                "must be zero or free, or an angle in rad",
                field="contact_angle",
                value=contact_angle,
                example='contact_angle = "free"',
            )
        if bearing.contact_angle is not None:
            return bearing.contact_angle, ()
        if contact_angle == "zero":
            return 0.0, ("angle_zero",)
        return ring_geometry(bearing).free_contact_angle, ("angle_free",)
    if not 0.0 <= contact_angle < _RIGHT_ANGLE:
        raise InputError(
            "must be at least 0 and less than a right angle, in rad",
            field="contact_angle",
            value=contact_angle,
            example="contact_angle = 0.26",
        )
    return contact_angle, ()


def _nominal_row(
    bearing: Bearing, shaft: _Shaft, slip: float, contact_angle: float | AngleChoice, row: int
) -> FaultFrequencies:
    angle, notes = nominal_angle(bearing, contact_angle)
    turns = turns_of(bearing.ball_diameter / bearing.pitch_diameter, angle, *shaft.ratios, slip)
    orders = line_orders(turns, bearing.ball_count)
    lines = {name: plain_line(order, shaft.frequency) for name, order in orders.items()}
    row_of = _Row("nominal", bearing, shaft, slip, row)
    return row_of.record((angle, angle), turns, lines, (*shaft.notes, *notes))


class _Row(NamedTuple):
    """What all frequencies of one row have in common."""

    source: Literal["nominal", "loaded"]
    bearing: Bearing
    shaft: _Shaft
    slip: float
    row: int

    def record(
        self,
        angles: tuple[float, float],
        turns: Turns,
        lines: Mapping[LineName, FaultLine],
        notes: tuple[str, ...],
    ) -> FaultFrequencies:
        """Put the record together; angles: of the inner and the outer contact."""
        return FaultFrequencies(
            source=self.source,
            ball_count=self.bearing.ball_count,
            inner_speed=self.shaft.inner,
            outer_speed=self.shaft.outer,
            shaft=self.shaft.role,
            shaft_frequency=self.shaft.frequency,
            slip=self.slip,
            inner_contact_angle=angles[0],
            outer_contact_angle=angles[1],
            turns=turns,
            cage=lines["cage"],
            ball_pass_outer=lines["ball_pass_outer"],
            ball_pass_inner=lines["ball_pass_inner"],
            ball_spin=lines["ball_spin"],
            ball_spin_twice=lines["ball_spin_twice"],
            row=self.row,
            notes=notes,
        )

    def without_result(self, note: str) -> FaultFrequencies:
        """Return the record of a row that has no answer."""
        lines = {name: missing_line() for name in LINES}
        return self.record((nan, nan), Turns(*self.shaft.ratios, nan, nan), lines, (note,))


# --- of a state ------------------------------------------------------------------------------


class _Balls(NamedTuple):
    """What the loaded balls of a row do; arrays (balls,), speeds over the shaft's."""

    cage: FloatArray
    ball: FloatArray
    weight: FloatArray
    inner_angle: FloatArray
    outer_angle: FloatArray

    def mean(self, values: FloatArray) -> float:
        """Mean weighted by the loads."""
        return float(np.average(values, weights=self.weight))


def _loaded_row(
    state: State, bearing: Bearing, shaft: _Shaft, slip: float, row: int
) -> FaultFrequencies:
    loaded = [ball for ball in state.balls if ball.row == row and ball.inner.load > 0.0]
    row_of = _Row("loaded", bearing, shaft, slip, row)
    if not state.status.converged:
        return row_of.without_result("no_result")
    if not loaded:
        return row_of.without_result("no_loaded_ball")
    balls = _loaded_balls(state, loaded, bearing, shaft, slip)
    inner, outer = shaft.ratios
    turns = Turns(inner, outer, balls.mean(balls.cage), balls.mean(balls.ball))
    each = [
        line_orders(Turns(inner, outer, float(cage), float(ball)), bearing.ball_count)
        for cage, ball in zip(balls.cage, balls.ball, strict=True)
    ]
    lines = {
        name: _spread_line(order, [one[name] for one in each], shaft.frequency)
        for name, order in line_orders(turns, bearing.ball_count).items()
    }
    angles = (balls.mean(balls.inner_angle), balls.mean(balls.outer_angle))
    friction = () if state.rolling is None else ("friction",)
    return row_of.record(angles, turns, lines, (*shaft.notes, *friction))


def _loaded_balls(
    state: State, loaded: Sequence[BallState], bearing: Bearing, shaft: _Shaft, slip: float
) -> _Balls:
    """Gather what loaded balls do; at rest, what they would do with the inner ring turning."""
    inner_angle = np.array([ball.inner.contact_angle for ball in loaded])
    outer_angle = np.array([ball.outer.contact_angle for ball in loaded])
    if shaft.speed == 0.0:
        control = [-1 if ball.raceway_control == "inner" else 1 for ball in loaded]
        ratio = bearing.ball_diameter / bearing.pitch_diameter
        motion = ball_motion(inner_angle, outer_angle, ratio, 1.0, control=control)
        cage, ball_speed = motion.orbital_speed, motion.ball_speed
    else:
        cage = np.array([ball.orbital_speed for ball in loaded]) / shaft.speed
        ball_speed = np.array([ball.ball_speed for ball in loaded]) / shaft.speed
    if state.rolling is not None and shaft.speed != 0.0:
        cage = np.full(len(loaded), state.rolling.cage_speed / shaft.speed)
    outer = shaft.ratios[1]
    return _Balls(
        cage=outer + (1.0 - slip) * (cage - outer),
        ball=(1.0 - slip) * ball_speed,
        weight=np.array([ball.inner.load for ball in loaded]),
        inner_angle=inner_angle,
        outer_angle=outer_angle,
    )


def _spread_line(order: float, orders: Sequence[float], shaft_frequency: float) -> FaultLine:
    sizes = np.abs(orders)
    return FaultLine(
        order=abs(order),
        frequency=abs(order) * shaft_frequency,
        minimum=float(sizes.min()),
        mean=float(sizes.mean()),
        maximum=float(sizes.max()),
    )


def _check_slip(slip: float) -> None:
    if not -1.0 <= slip <= 1.0:
        raise InputError(
            "must be between -1 and 1", field="slip", value=slip, example="slip = 0.01"
        )
