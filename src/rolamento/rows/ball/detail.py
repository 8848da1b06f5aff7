"""What happens at every ball, once its place is known: arrays over cases and balls."""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.contact.hertz import HertzContact, elliptical_contact
from rolamento.geometry import Angle, Race, race_curvature
from rolamento.kinematics import (
    BallMotion,
    ball_motion,
    cage_speed,
    grip,
    jones_control,
    orbital_speed,
)
from rolamento.records import frozen
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import TINY
from rolamento.rows.ball.problem import Columns, directions
from rolamento.rows.ball.rolling import Rolling, motion_of
from rolamento.solved import Pressed

Floats = NDArray[np.float64]


class ContactTable(NamedTuple):
    """One race's contacts: load (N), angle, deflection (m); (cases, balls).

    approach (m) is the deflection, or a gap below zero; past the edge of the groove it is into the
    groove's flank, were that higher.
    """

    load: Floats
    angle: Angle
    deflection: Floats
    approach: Floats


@frozen
class BallTable:
    """The balls of a batch; every field (cases, balls), SI, NaN where a case has no result."""

    inner: Pressed
    outer: Pressed
    motion: BallMotion
    centrifugal_force: Floats
    gyroscopic_moment: Floats
    yaw: Floats


def contact_tables(
    p: Columns,
    displacement: Floats,
    position: Floats,
    rolling: Rolling | None = None,
) -> tuple[ContactTable, ContactTable]:
    """The contacts of every ball with inner and outer race; arguments as of `ball_table`."""
    column = p.over_balls()
    a1, a2 = groove_centres(p, displacement, position.shape[1])
    x1, x2 = position[..., 0], position[..., 1]
    lift = np.zeros(2) if rolling is None else np.moveaxis(rolling.lift, -1, 0)
    outer = _contacts(x1, x2, column, "outer", lift[1])
    return _contacts(a1 - x1, a2 - x2, column, "inner", lift[0]), outer


def ball_table(
    p: Columns,
    control: Floats,
    displacement: Floats,
    position: Floats,
    rolling: Rolling | None = None,
    contacts: tuple[ContactTable, ContactTable] | None = None,
) -> BallTable:
    """Evaluate every ball; rolling: how friction moves them, instead of raceway control.

    control: +1 or -1 (cases or 1, balls); displacement (cases, 5) in the scaled form of `rows`;
    position (cases, balls, 2); contacts: `contact_tables` of these, if at hand.
    """
    column = p.over_balls()
    inner, outer = contacts or contact_tables(p, displacement, position, rolling)
    yaw = np.zeros_like(inner.load)
    motion = _motion(p, control.astype(np.int64), inner, outer)
    if rolling is not None:
        motion, yaw = motion_of(p, rolling, inner.angle.value, outer.angle.value, motion)
    # J / gamma' D is the parameter: times gamma' D, it is J again
    inertia = column[layout.GYROSCOPIC] * column[layout.GAMMA] * column[layout.BALL_DIAMETER]
    return BallTable(
        inner=Pressed(*inner, motion.inner_spin, motion.inner_roll),
        outer=Pressed(*outer, motion.outer_spin, motion.outer_roll),
        motion=motion,
        centrifugal_force=column[layout.CENTRIFUGAL] * motion.orbital_speed**2,
        gyroscopic_moment=inertia
        * motion.ball_speed
        * motion.orbital_speed
        * np.sin(motion.attitude),
        yaw=yaw,
    )


def _motion(
    p: Columns, control: NDArray[np.int64], inner: ContactTable, outer: ContactTable
) -> BallMotion:
    """How the balls move under raceway control, and where it holds none, with the cage."""
    column = p.over_balls()
    rings = (
        inner.angle, outer.angle, column[layout.GAMMA], column[layout.INNER_SPEED],
        column[layout.OUTER_SPEED], control,
    )  # fmt: skip
    own = orbital_speed(*rings)
    hold = grip(inner.load, column[layout.HOLD_RATE], column[layout.HOLD_OFFSET])
    mean = cage_speed(hold * inner.load, own, p[layout.NOMINAL_ORBIT], p[layout.CAGE_WEIGHT])
    cage = mean[:, np.newaxis]
    return ball_motion(
        *rings, orbit=cage + column[layout.OWN_ORBIT] * hold * (own - cage), hold=hold
    )


def groove_centres(p: Columns, displacement: Floats, balls: int) -> tuple[Floats, Floats]:
    """A1, A2 of the inner groove's centre at every ball, as in `ball_table`; (cases, balls)."""
    column = p.over_balls()
    x, y, z, tilt_y, tilt_z = (displacement[:, i, np.newaxis] for i in range(5))
    c0, s0 = p[layout.COS_FIRST][:, np.newaxis], p[layout.SIN_FIRST][:, np.newaxis]
    cosines, sines = directions(balls)
    c, s = cosines * c0 - sines * s0, sines * c0 + cosines * s0
    a1 = column[layout.AXIAL_OFFSET] + x + c * tilt_y - s * tilt_z
    a2 = column[layout.RADIAL_OFFSET] + c * z + s * y
    return a1, a2


def axial_load(p: Columns, a1: Floats, a2: Floats) -> tuple[Floats, ...]:
    """A ball at rest on the line of groove centres (a1, a2); (cases,) each.

    Its load Q, sin α, cos α, the approach, and d(Q sin α)/da1, K's own change left out.
    """
    free = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
    distance = np.hypot(a1, a2)
    sine, cosine = a1 / distance, a2 / distance
    approach = np.maximum(distance - free, 0.0)
    stiffness = _stiffness(p, layout.SERIES_STIFFNESS, cosine)
    load = stiffness * approach * np.sqrt(approach)
    slope = 1.5 * stiffness * np.sqrt(approach) * sine**2 + load * cosine**2 / distance
    return load, sine, cosine, approach, slope


def _contacts(y1: Floats, y2: Floats, column: Columns, race: Race, lift: Floats) -> ContactTable:
    """Load, angle and approach of the springs along (y1, y2), as `ball.contact` has them.

    lift: the film between, which presses ball and groove in by as much. Past 90° nothing presses.
    """
    length, stiffness = _ROWS[race]
    up = np.maximum(y2, 0.0)
    distance = np.sqrt(y1 * y1 + up * up + TINY)
    cosine = up / distance
    approach = distance - (column[length] - lift)
    pressed = np.maximum(approach, 0.0)
    pressed = np.where(cosine > 0.0, pressed, 0.0 * pressed)
    value = _stiffness(column, stiffness, cosine)
    angle = Angle(np.arctan2(y1, up))
    return ContactTable(value * pressed * np.sqrt(pressed), angle, pressed, approach)


_ROWS: Final[dict[Race, tuple[int, int]]] = {
    "inner": (layout.INNER_LENGTH, layout.INNER_STIFFNESS),
    "outer": (layout.OUTER_LENGTH, layout.OUTER_STIFFNESS),
}


def _stiffness(column: Columns, first: int, cosine: Floats) -> Floats:
    """K at an angle: a polynomial in cos α, of as many coefficients as the longest of the cases."""
    count = layout.COEFFICIENTS
    if len(column.bearing) > layout.COLUMN - layout.DUTY:
        first, count = layout.long_polynomial(first), layout.MOST_TERMS
    *lower, value = column[first : first + count]
    for coefficient in reversed(lower):
        value = value * cosine + coefficient
    return np.asarray(value)


def hertz(p: Columns, contacts: Pressed, race: Race) -> HertzContact:
    """Ellipse and pressure of every contact of a race at its loaded angle; (cases, balls)."""
    column = p.over_balls()
    diameter = column[layout.BALL_DIAMETER]
    length = column[layout.INNER_LENGTH if race == "inner" else layout.OUTER_LENGTH]
    curvature = race_curvature(
        diameter,
        diameter / column[layout.GAMMA],
        0.5 + length / diameter,
        contacts.angle,
        race,
    )
    return elliptical_contact(
        contacts.load, curvature.rolling, curvature.across, column[layout.MODULUS]
    )


def criterion(p: Columns, table: BallTable) -> NDArray[np.int64]:
    """Which race controls every ball by Jones's criterion: codes (cases, balls)."""
    inner, outer = hertz(p, table.inner, "inner"), hertz(p, table.outer, "outer")
    return jones_control(
        inner.resistance_to_spin,
        outer.resistance_to_spin,
        table.inner.angle.value,
        table.outer.angle.value,
    )
