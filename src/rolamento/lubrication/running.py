"""What the film reads of running balls: the same arrays from a batch or from one state."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any, Final

import numpy as np

from rolamento.contact.hertz import effective_modulus
from rolamento.geometry import Race, race_curvature
from rolamento.lubrication.entrainment import SurfaceSpeeds, surface_speeds
from rolamento.numerics import FloatArray
from rolamento.rows.ball import BatchState, layout
from rolamento.rows.ball.batch_state import RowBatch
from rolamento.rows.ball.detail import ContactTable
from rolamento.solved import Solved
from rolamento.state import State

NO_LOAD: Final = 1e-9
"""Of the load at the other race: what is less is no contact."""
_RACES: Final[tuple[Race, Race]] = ("inner", "outer")


@dataclass(frozen=True, slots=True)
class RunningContacts:
    """The contacts of one race; arrays (cases, balls), SI, NaN where there is no contact.

    rolling_curvature is 1/R_x, ellipticity a/b.
    """

    load: FloatArray
    speeds: SurfaceSpeeds
    rolling_curvature: FloatArray
    ellipticity: FloatArray
    semi_minor: FloatArray
    max_pressure: FloatArray


@dataclass(frozen=True, slots=True)
class RunningBalls:
    """All contacts, and of each ball's row pitch diameter, effective modulus, speed of the rings.

    Arrays (cases, balls), SI; the speed is that of the inner ring seen from the outer, unsigned.
    """

    inner: RunningContacts
    outer: RunningContacts
    pitch_diameter: FloatArray
    modulus: FloatArray
    speed: FloatArray


@dataclass(frozen=True, slots=True)
class _Place:
    """Geometry and speeds of each ball's row; (cases, balls), SI."""

    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    conformity: dict[Race, FloatArray]
    ring_speed: dict[Race, FloatArray]
    modulus: FloatArray


@dataclass(frozen=True, slots=True)
class _Motion:
    orbital_speed: FloatArray
    ball_speed: FloatArray
    attitude: FloatArray
    yaw: FloatArray


def part(batch: BatchState, cases: slice) -> BatchState:
    """Return some cases of a batch."""
    rows_of_balls = []
    for row in batch.rows:
        some: RowBatch = _part(row, cases, but="parameters")
        rows_of_balls.append(replace(some, parameters=row.parameters[:, cases]))
    found: BatchState = _part(batch, cases, but="rows")
    return replace(found, rows=tuple(rows_of_balls))


def _part(record: Any, cases: slice, but: str = "") -> Any:
    """Return some cases of a record of arrays (cases, …), in which records may be nested."""
    if record is None:
        return None
    if isinstance(record, np.ndarray):
        return record[cases]
    own = {
        field.name: _part(getattr(record, field.name), cases)
        for field in fields(record)
        if field.name != but
    }
    return replace(record, **own)


def balls_of_batch(batch: BatchState) -> RunningBalls:
    """Gather the balls of a batch."""
    table = batch.balls()
    place = _place_of_batch(batch)
    motion = _Motion(
        table.motion.orbital_speed, table.motion.ball_speed, table.motion.attitude, table.yaw
    )
    angles = {"inner": table.inner.contact_angle, "outer": table.outer.contact_angle}
    loads = {"inner": _felt(table.inner, table.outer), "outer": _felt(table.outer, table.inner)}
    found = {}
    for race in _RACES:
        hertz = batch.contact(race, table)
        ellipse = (hertz.ellipticity, hertz.semi_minor, hertz.max_pressure)
        found[race] = _running(race, place, motion, angles[race], loads[race], ellipse)
    return _balls(found["inner"], found["outer"], place)


def balls_of_state(state: State) -> RunningBalls:
    """Gather the balls of one state, as a batch of one."""
    place = _place_of_state(state)
    rolling = state.rolling
    motion = _Motion(
        orbital_speed=np.array([[ball.orbital_speed for ball in state.balls]]),
        ball_speed=np.array([[ball.ball_speed for ball in state.balls]]),
        attitude=np.array([[ball.attitude for ball in state.balls]]),
        yaw=np.array(
            [[ball.yaw for ball in rolling.balls] if rolling else [0.0] * len(state.balls)]
        ),
    )
    tables = {race: _contacts_of_state(state, race) for race in _RACES}
    found = {}
    for race, other in (_RACES, _RACES[::-1]):
        columns = {
            name: np.array([[getattr(getattr(ball, race), name) for ball in state.balls]])
            for name in ("semi_major", "semi_minor", "max_pressure")
        }
        with np.errstate(invalid="ignore", divide="ignore"):
            ratio = columns["semi_major"] / columns["semi_minor"]
        ellipse = (ratio, columns["semi_minor"], columns["max_pressure"])
        own = tables[race]
        load = _felt(own, tables[other])
        found[race] = _running(race, place, motion, own.contact_angle, load, ellipse)
    return _balls(found["inner"], found["outer"], place)


def _running(
    race: Race,
    place: _Place,
    motion: _Motion,
    contact_angle: FloatArray,
    load: FloatArray,
    ellipse: tuple[FloatArray, FloatArray, FloatArray],
) -> RunningContacts:
    speeds = surface_speeds(
        race,
        place.ball_diameter,
        place.pitch_diameter,
        contact_angle,
        place.ring_speed[race],
        motion.orbital_speed,
        motion.ball_speed,
        motion.attitude,
        motion.yaw,
    )
    curvature = race_curvature(
        place.ball_diameter, place.pitch_diameter, place.conformity[race], contact_angle, race
    )
    return RunningContacts(load, speeds, curvature.rolling, *ellipse)


def _balls(inner: RunningContacts, outer: RunningContacts, place: _Place) -> RunningBalls:
    speed = np.abs(place.ring_speed["inner"] - place.ring_speed["outer"])
    return RunningBalls(inner, outer, place.pitch_diameter, place.modulus, np.asarray(speed))


def _felt(own: ContactTable, other: ContactTable) -> FloatArray:
    """Load of a race's contacts; NaN where there is none."""
    return np.where(own.load > NO_LOAD * other.load, own.load, np.nan)


def _place_of_batch(batch: BatchState) -> _Place:
    def spread(row: int) -> FloatArray:
        parts = [
            np.broadcast_to(own.parameters[row][:, np.newaxis], own.azimuth.shape)
            for own in batch.rows
        ]
        return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=1)

    diameter = spread(layout.BALL_DIAMETER)
    return _Place(
        ball_diameter=diameter,
        pitch_diameter=diameter / spread(layout.GAMMA),
        conformity={
            "inner": 0.5 + spread(layout.INNER_LENGTH) / diameter,
            "outer": 0.5 + spread(layout.OUTER_LENGTH) / diameter,
        },
        ring_speed={"inner": spread(layout.INNER_SPEED), "outer": spread(layout.OUTER_SPEED)},
        modulus=spread(layout.MODULUS),
    )


def _place_of_state(state: State) -> _Place:
    bearings = [place.bearing for place in state.case.bearing.places]
    own = [bearings[ball.row] for ball in state.balls]
    moduli = [effective_modulus(row.ring_material, row.ball_material) for row in bearings]
    duty, shape = state.case.duty, (1, len(own))
    return _Place(
        ball_diameter=np.array([[row.ball_diameter for row in own]]),
        pitch_diameter=np.array([[row.pitch_diameter for row in own]]),
        conformity={
            "inner": np.array([[row.inner_conformity for row in own]]),
            "outer": np.array([[row.outer_conformity for row in own]]),
        },
        ring_speed={
            "inner": np.full(shape, duty.inner_speed),
            "outer": np.full(shape, duty.outer_speed),
        },
        modulus=np.array([[moduli[ball.row] for ball in state.balls]]),
    )


def _contacts_of_state(state: State, race: Race) -> ContactTable:
    contacts = [getattr(ball, race) for ball in state.balls]
    return ContactTable(
        *(
            np.array([[getattr(contact, name) for contact in contacts]])
            for name in ("load", "contact_angle", "deflection")
        )
    )


def running_balls(solved: Solved) -> RunningBalls:
    """Gather the elements of solved cases."""
    found = {}
    for race, other in (_RACES, _RACES[::-1]):
        own, opposite = solved.contacts[race], solved.contacts[other]
        found[race] = RunningContacts(
            np.where(own.load > NO_LOAD * opposite.load, own.load, np.nan),
            own.surface_speeds,
            own.rolling_curvature,
            own.ellipticity,
            own.semi_minor,
            own.max_pressure,
        )
    speed = np.abs(solved.field("duty.inner_speed") - solved.field("duty.outer_speed"))
    return RunningBalls(
        found["inner"],
        found["outer"],
        solved.inner.pitch_diameter,
        solved.inner.modulus,
        np.broadcast_to(speed[:, np.newaxis], solved.inner.load.shape),
    )
