"""From arrays to the record of one case: every number a user sees, and what he should know."""

from __future__ import annotations

from math import nan
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.contact.hertz import HertzContact
from rolamento.contact.subsurface import maximum_shear, orthogonal_shear
from rolamento.geometry import Race
from rolamento.kinematics import RacewayControl
from rolamento.rows.ball import layout
from rolamento.rows.ball.advice import advise
from rolamento.rows.ball.batch_state import STATUS_NAMES, BatchState
from rolamento.rows.ball.detail import BallTable, ContactTable
from rolamento.rows.ball.notes import notes_on
from rolamento.rows.ball.problem import Floats
from rolamento.rows.ball.rolling import Rolling
from rolamento.state import (
    BallState,
    ContactState,
    RingDisplacement,
    RingLoad,
    RollingBall,
    RollingContact,
    RollingState,
    RowState,
    State,
    Status,
)

NO_LOAD: Final = 1e-9
"""Of the load at the other race: what is less is no contact."""
_CONTROL_NAMES: Final = {
    int(RacewayControl.OUTER): "outer",
    int(RacewayControl.INNER): "inner",
    int(RacewayControl.INDETERMINATE): "indeterminate",
}


def state_of(case: Case, batch: BatchState) -> State:
    """Make the record of a batch of one."""
    converged = bool(batch.converged[0])
    table = batch.balls()
    inner_spin, outer_spin = table.motion.inner_spin_to_roll, table.motion.outer_spin_to_roll
    inner = _contact_states(case.bearing, batch.contact("inner", table), table.inner, inner_spin)
    outer = _contact_states(case.bearing, batch.contact("outer", table), table.outer, outer_spin)
    state = State(
        case=case,
        status=Status(
            code=STATUS_NAMES[int(batch.code[0])],
            converged=converged,
            residual=float(batch.residual[0]),
            iterations=int(batch.iterations[0]),
            advice=advise(case, batch),
        ),
        displacement=RingDisplacement(*batch.displacement[0].tolist()),
        load=RingLoad(*batch.load[0].tolist()),
        stiffness=batch.stiffness[0],
        balls=_ball_states(case, batch, table, inner, outer),
        rows=_row_states(case, batch, table),
        rolling=_rolling_state(batch, table) if converged else None,
    )
    return state if not converged else notes_on(state, batch)


def _contact_states(
    bearing: Bearing, contact: HertzContact, table: ContactTable, spin_to_roll: Floats
) -> list[ContactState]:
    """The contacts of the first case's balls with one race."""
    shear = _shears(bearing, contact)
    columns = (
        table.load, table.contact_angle, table.deflection, contact.semi_major, contact.semi_minor,
        contact.max_pressure, contact.mean_pressure, *shear,
    )  # fmt: skip
    numbers = np.stack([*(column[0] for column in columns), spin_to_roll[0] + 0.0], axis=1)
    return [ContactState(*contact) for contact in numbers.tolist()]


def _shears(bearing: Bearing, contact: HertzContact) -> tuple[Floats, Floats, Floats, Floats]:
    """Greatest shear in the ring under the centre and orthogonal shear, each with its depth."""
    ellipse = contact.semi_major, contact.semi_minor
    greatest = maximum_shear(contact.max_pressure, *ellipse, bearing.ring_material.poisson_ratio)
    orthogonal = orthogonal_shear(contact.max_pressure, *ellipse)
    return greatest.shear, greatest.depth, orthogonal.amplitude, orthogonal.depth


def _row_states(case: Case, batch: BatchState, table: BallTable) -> tuple[RowState, ...]:
    loaded = table.inner.load[0] > NO_LOAD * table.outer.load[0]
    return tuple(
        RowState(
            row=index,
            orientation="+" if place.sign > 0.0 else "-",
            position=place.position,
            load=RingLoad(*(row.load[0] + 0.0).tolist()),
            loaded_balls=int(loaded[batch.row == index].sum()),
        )
        for index, (place, row) in enumerate(zip(case.bearing.places, batch.rows, strict=True))
    )


def _rolling_state(batch: BatchState, table: BallTable) -> RollingState | None:
    """How friction moves the balls of a bearing of one row."""
    row = batch.rows[0]
    rolling, p = row.rolling, row.parameters
    if rolling is None or not np.isfinite(rolling.cage_speed[0]):
        return None
    angles: dict[Race, Floats] = {
        "inner": table.inner.contact_angle[0],
        "outer": table.outer.contact_angle[0],
    }
    contacts = {
        race: _rolling_contacts(rolling, index, race, angles[race], p[:, 0])
        for index, race in enumerate(angles)
    }
    usual = float(rolling.control_cage_speed[0])
    cage = float(rolling.cage_speed[0])
    balls = zip(
        rolling.angular_velocity[0].tolist(), table.yaw[0].tolist(), contacts["inner"],
        contacts["outer"], strict=True,
    )  # fmt: skip
    return RollingState(
        cage_speed=cage,
        control_cage_speed=usual,
        skid=1.0 - cage / usual if usual else nan,
        inner_torque=float(rolling.torque("inner")[0]),
        outer_torque=float(rolling.torque("outer")[0]),
        power=float(rolling.power[0].sum()),
        imbalance=float(rolling.imbalance[0]),
        balls=tuple(RollingBall(tuple(omega), yaw, *races) for omega, yaw, *races in balls),
    )


def _rolling_contacts(
    rolling: Rolling, index: int, race: Race, angle: Floats, p: Floats
) -> list[RollingContact]:
    """The friction of one race on the balls of the first case."""
    forces = (rolling.inner if race == "inner" else rolling.outer)[0]
    speed = p[layout.INNER_SPEED if race == "inner" else layout.OUTER_SPEED]
    omega = rolling.angular_velocity[0]
    across = (omega[:, 0] - speed) * np.cos(angle) - omega[:, 2] * np.sin(angle)
    radius = 0.5 * p[layout.BALL_DIAMETER] * (1.0 if race == "outer" else -1.0)
    slip = (speed - rolling.cage_speed[0]) * rolling.radius[0] - radius * across
    # the normal load has no part along t, nor along the orbit
    sideways = forces[:, 0] * np.cos(angle) - forces[:, 1] * np.sin(angle)
    slip = np.where(forces.any(axis=1), slip, np.nan)
    columns = (rolling.power[0, :, index], slip, forces[:, 2], sideways)
    return [RollingContact(*map(float, numbers)) for numbers in zip(*columns, strict=True)]


def _ball_states(
    case: Case,
    batch: BatchState,
    table: BallTable,
    inner: list[ContactState],
    outer: list[ContactState],
) -> tuple[BallState, ...]:
    mode = case.model.raceway_control
    motion = table.motion
    return tuple(
        BallState(
            row=int(row),
            azimuth=float(table.azimuth[0, j]),
            inner=inner[j],
            outer=outer[j],
            centrifugal_force=float(table.centrifugal_force[0, j]),
            gyroscopic_moment=float(table.gyroscopic_moment[0, j]),
            orbital_speed=float(motion.orbital_speed[0, j]),
            ball_speed=float(motion.ball_speed[0, j]),
            attitude=float(motion.attitude[0, j]),
            raceway_control=mode
            if mode in ("none", "friction")
            else _CONTROL_NAMES[int(batch.raceway_control[0, j])],
        )
        for j, row in enumerate(batch.row)
    )
