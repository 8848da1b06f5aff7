"""What happens at every ball, once its place is known: arrays over cases and balls."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rolamento.contact.hertz import HertzContact, elliptical_contact
from rolamento.equilibrium import rows
from rolamento.equilibrium.rolling import Rolling, motion_of
from rolamento.geometry import Race, race_curvature
from rolamento.kinematics import BallMotion, ball_motion, jones_control, spin_resistance

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class ContactTable:
    """One race's contacts: load (N), contact_angle (rad), deflection (m); (cases, balls)."""

    load: Floats
    contact_angle: Floats
    deflection: Floats


@dataclass(frozen=True, slots=True)
class BallTable:
    """The balls of a batch; every field (cases, balls), SI, NaN where a case has no result."""

    azimuth: Floats
    inner: ContactTable
    outer: ContactTable
    motion: BallMotion
    centrifugal_force: Floats
    gyroscopic_moment: Floats
    yaw: Floats


def ball_table(
    p: Floats,
    control: Floats,
    displacement: Floats,
    position: Floats,
    azimuth: Floats,
    rolling: Rolling | None = None,
) -> BallTable:
    """Evaluate every ball; rolling: how friction moves them, instead of raceway control.

    p: parameters (rows.PARAMETERS, cases); control: +1 or -1 (cases, balls); displacement
    (cases, 5) in the scaled form of `rows`; position (cases, balls, 2); azimuth (cases, balls).
    """
    column = p[:, :, np.newaxis]
    a1, a2 = groove_centres(p, displacement, azimuth)
    x1, x2 = position[..., 0], position[..., 1]
    lift = np.zeros(2) if rolling is None else np.moveaxis(rolling.lift, -1, 0)
    outer = _contacts(x1, x2, column, rows.OUTER_LENGTH, rows.OUTER_STIFFNESS, lift[1])
    inner = _contacts(a1 - x1, a2 - x2, column, rows.INNER_LENGTH, rows.INNER_STIFFNESS, lift[0])
    yaw = np.zeros_like(azimuth)
    motion = ball_motion(
        inner.contact_angle,
        outer.contact_angle,
        column[rows.GAMMA],
        column[rows.INNER_SPEED],
        column[rows.OUTER_SPEED],
        control.astype(np.int64),
    )
    if rolling is not None:
        motion, yaw = motion_of(p, rolling, inner.contact_angle, outer.contact_angle, motion)
    # J / gamma' D is the parameter: times gamma' D, it is J again
    inertia = column[rows.GYROSCOPIC] * column[rows.GAMMA] * column[rows.BALL_DIAMETER]
    return BallTable(
        azimuth=azimuth,
        inner=inner,
        outer=outer,
        motion=motion,
        centrifugal_force=column[rows.CENTRIFUGAL] * motion.orbital_speed**2,
        gyroscopic_moment=inertia
        * motion.ball_speed
        * motion.orbital_speed
        * np.sin(motion.attitude),
        yaw=yaw,
    )


def groove_centres(p: Floats, displacement: Floats, azimuth: Floats) -> tuple[Floats, Floats]:
    """A1, A2 of the inner groove's centre at every ball, as in `ball_table`; (cases, balls)."""
    column = p[:, :, np.newaxis]
    x, y, z, tilt_y, tilt_z = (displacement[:, i, np.newaxis] for i in range(5))
    c, s = np.cos(azimuth), np.sin(azimuth)
    a1 = column[rows.AXIAL_OFFSET] + x + c * tilt_y - s * tilt_z
    a2 = column[rows.RADIAL_OFFSET] + c * z + s * y
    return a1, a2


def _contacts(
    y1: Floats, y2: Floats, column: Floats, length: int, stiffness: int, lift: Floats
) -> ContactTable:
    """Load, angle and approach of the springs along (y1, y2), as `ball.contact` has them.

    lift: the film between, which presses ball and groove in by as much.
    """
    distance = np.hypot(y1, y2)
    approach = np.maximum(distance - (column[length] - lift), 0.0)
    cosine = y2 / distance
    value = column[stiffness + rows.COEFFICIENTS - 1]
    for power in range(rows.COEFFICIENTS - 2, -1, -1):
        value = value * cosine + column[stiffness + power]
    return ContactTable(value * approach * np.sqrt(approach), np.arctan2(y1, y2), approach)


def hertz(p: Floats, contacts: ContactTable, race: Race) -> HertzContact:
    """Ellipse and pressure of every contact of a race at its loaded angle; (cases, balls)."""
    column = p[:, :, np.newaxis]
    diameter = column[rows.BALL_DIAMETER]
    length = column[rows.INNER_LENGTH if race == "inner" else rows.OUTER_LENGTH]
    curvature = race_curvature(
        diameter,
        diameter / column[rows.GAMMA],
        0.5 + length / diameter,
        contacts.contact_angle,
        race,
    )
    return elliptical_contact(
        contacts.load, curvature.rolling, curvature.across, column[rows.MODULUS]
    )


def criterion(p: Floats, table: BallTable) -> NDArray[np.int64]:
    """Which race controls every ball by Jones's criterion: codes (cases, balls)."""
    inner, outer = hertz(p, table.inner, "inner"), hertz(p, table.outer, "outer")
    return jones_control(
        spin_resistance(inner.load, inner.semi_major, inner.ellipticity),
        spin_resistance(outer.load, outer.semi_major, outer.ellipticity),
        table.inner.contact_angle,
        table.outer.contact_angle,
    )
