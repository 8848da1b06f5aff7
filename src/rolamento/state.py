"""What solving a case returns: the internal state of the bearing, with a status.

Plain frozen records in SI units. A number that does not exist is NaN, and null in JSON.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from math import isfinite
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case

SCHEMA = 1


class RingDisplacement(NamedTuple):
    """Displacement of the inner ring: x, y, z (m), ry, rz (rad)."""

    x: float
    y: float
    z: float
    ry: float
    rz: float


class RingLoad(NamedTuple):
    """What the shaft puts on the inner ring: fx, fy, fz (N), my, mz (N·m)."""

    fx: float
    fy: float
    fz: float
    my: float
    mz: float


@dataclass(frozen=True, slots=True)
class Status:
    """How the solution ended.

    code: "converged", or why there is no result: "no_equilibrium", "not_converged", "overloaded",
    "unheld_ball", "over_shoulder" (docs/theory/equilibrium.md). residual: the greatest unbalanced
    load of ring and balls, each over the scale of its own loads. advice: what a person can do, or
    None.
    """

    code: str
    converged: bool
    residual: float
    iterations: int
    advice: str | None = None


@dataclass(frozen=True, slots=True)
class ContactState:
    """One contact of a ball.

    Attributes
    ----------
    load
        normal to the contact (N)
    contact_angle
        under load (rad)
    deflection
        approach of ball and groove (m)
    semi_major, semi_minor
        of the contact ellipse, across and along rolling (m)
    max_pressure, mean_pressure
        Hertz pressure (Pa)
    max_shear, max_shear_depth
        the greatest shear stress under the centre (Pa) and its depth (m)
    orthogonal_shear, orthogonal_shear_depth
        amplitude of the shear that alternates along the surface (Pa) and its depth (m)
    spin_to_roll
        ratio of the relative angular speeds about the normal and along the surface
    """

    load: float
    contact_angle: float
    deflection: float
    semi_major: float
    semi_minor: float
    max_pressure: float
    mean_pressure: float
    max_shear: float
    max_shear_depth: float
    orthogonal_shear: float
    orthogonal_shear_depth: float
    spin_to_roll: float


@dataclass(frozen=True, slots=True)
class BallState:
    """One ball: its place, its contacts, its motion.

    Attributes
    ----------
    row
        of balls, counted from 0
    azimuth
        of the ball (rad), 0 at +z, a quarter turn at +y
    inner, outer
        the contacts
    centrifugal_force
        (N)
    gyroscopic_moment
        (N·m), signed: negative when the inner ring turns
    orbital_speed
        of the ball about the bearing's axis (rad/s)
    ball_speed
        about its own axis (rad/s), signed against the orbit
    attitude
        angle of the ball's axis to the bearing's axis (rad)
    raceway_control
        the race that the ball rolls on without spin: "outer", "inner", "indeterminate" (Jones's
        criterion favours neither), "none" (the gyroscopic moment shared) or "friction"
    """

    row: int
    azimuth: float
    inner: ContactState
    outer: ContactState
    centrifugal_force: float
    gyroscopic_moment: float
    orbital_speed: float
    ball_speed: float
    attitude: float
    raceway_control: str


@dataclass(frozen=True, slots=True)
class RollingContact:
    """Friction of a race on a ball that only friction controls.

    Attributes
    ----------
    power
        lost in the contact (W)
    slip
        speed of the ball's surface over the race at the ellipse's centre, along increasing azimuth
        (m/s)
    force_along, force_across
        friction on the ball, along increasing azimuth and along t = (cos α, -sin α) (N)
    """

    power: float
    slip: float
    force_along: float
    force_across: float


@dataclass(frozen=True, slots=True)
class RollingBall:
    """How a ball turns that only friction controls.

    Attributes
    ----------
    angular_velocity
        along x, along increasing azimuth, and outward (rad/s)
    yaw
        of its axis, β' = atan(ω_y/ω_x), toward increasing azimuth and seen from the cage (rad)
    inner, outer
        the friction of the races
    """

    angular_velocity: tuple[float, float, float]
    yaw: float
    inner: RollingContact
    outer: RollingContact


@dataclass(frozen=True, slots=True)
class RollingState:
    """The motion of balls and cage under friction alone, and what it costs.

    Attributes
    ----------
    cage_speed
        of all balls about the bearing's axis (rad/s)
    control_cage_speed
        the same solved under outer raceway control, the balls' mean weighted by their loads (rad/s)
    skid
        how far the cage lags behind that, relative to it; below zero where it leads
    inner_torque, outer_torque
        that shaft and housing put on the rings against the friction at the races (N·m)
    power
        lost at all races (W)
    imbalance
        what is missing between the work of shaft and housing and the losses, over the losses
    balls
        in the order of the state's balls
    """

    cage_speed: float
    control_cage_speed: float
    skid: float
    inner_torque: float
    outer_torque: float
    power: float
    imbalance: float
    balls: tuple[RollingBall, ...]


@dataclass(frozen=True, slots=True)
class RowState:
    """One row of balls of a bearing.

    Attributes
    ----------
    row
        counted from 0 along +x
    orientation
        "+" where the row carries axial load of the shaft toward +x, "-" where it faces the other
        way
    position
        of the balls' plane along x (m)
    load
        that the shaft puts on the inner ring through this row, about the bearing's origin
    loaded_balls
        that the inner ring presses on
    """

    row: int
    orientation: str
    position: float
    load: RingLoad
    loaded_balls: int


@dataclass(frozen=True, slots=True)
class PreloadState:
    """How the rows of a set press on each other, and what takes that away.

    Attributes
    ----------
    kind
        "force", "offset" or "level" where the rings are clamped, "spring"
    at_rest
        axial force between the rows that face each other, without external load, at rest (N)
    at_speed
        the same at the duty's speeds (N)
    lift_factor
        multiple of the external load at which a ball first loses contact with the inner ring; NaN
        as below
    lift_row
        whose ball that is; None if none
    loss_factor
        the preload-loss point: multiple of the external load at which a row first loses all
        contact with the inner ring; NaN where there is no external load, or none is lost before
        the set has no equilibrium
    lost_row
        which row that is; None if none
    """

    kind: str
    at_rest: float
    at_speed: float
    lift_factor: float
    lift_row: int | None
    loss_factor: float
    lost_row: int | None


@dataclass(frozen=True, slots=True)
class State:
    """The internal state of a bearing under a duty.

    Attributes
    ----------
    case
        what was solved
    status
        whether and how it was solved
    displacement
        of the inner ring
    load
        that the shaft puts on the inner ring: given loads, and the reactions of what is held
    stiffness
        5 x 5, derivative of the load by the displacement, in the order x, y, z, ry, rz (N/m,
        N/rad, N·m/m, N·m/rad), the speed's effects included
    balls
        from the first ball on, row after row
    notes
        what the user should know about the result
    rows
        of balls, along +x; one, unless the bearing is a set
    preload
        of a set whose rows face each other; None otherwise
    rolling
        under friction control; None otherwise
    """

    case: Case
    status: Status
    displacement: RingDisplacement
    load: RingLoad
    stiffness: NDArray[np.float64]
    balls: tuple[BallState, ...]
    notes: tuple[str, ...] = ()
    rows: tuple[RowState, ...] = ()
    preload: PreloadState | None = None
    rolling: RollingState | None = None

    @property
    def title(self) -> str:
        """The title of the case."""
        return self.case.title

    def to_mapping(self) -> dict[str, Any]:
        """Give the state as plain mappings and lists in SI units, NaN as None."""
        mapping = {
            "schema": SCHEMA,
            "title": self.title,
            "status": asdict(self.status),
            "displacement": self.displacement._asdict(),
            "load": self.load._asdict(),
            "stiffness": self.stiffness.tolist(),
            "balls": [asdict(ball) for ball in self.balls],
            "rows": [{**asdict(row), "load": row.load._asdict()} for row in self.rows],
            "preload": None if self.preload is None else asdict(self.preload),
            "rolling": None if self.rolling is None else asdict(self.rolling),
            "notes": list(self.notes),
            "case": self.case.to_mapping(),
        }
        nulled: dict[str, Any] = _without_nan(mapping)
        return nulled

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give the state as one JSON object."""
        return json.dumps(self.to_mapping(), indent=indent, ensure_ascii=False, allow_nan=False)


def _without_nan(value: Any) -> Any:
    """Replace what is not finite by None, at any depth."""
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_without_nan(item) for item in value]
    if isinstance(value, float) and not isfinite(value):
        return None
    return value
