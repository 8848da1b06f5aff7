"""From arrays to the record of one case: every number a user sees, and what he should know."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.bearing import Bearing
from rolamento.case import Case
from rolamento.contact.hertz import HertzContact
from rolamento.contact.subsurface import greatest_shear, orthogonal_shear
from rolamento.equilibrium.advice import advise
from rolamento.equilibrium.batch_state import STATUS_NAMES, BatchState
from rolamento.equilibrium.detail import BallTable, ContactTable
from rolamento.equilibrium.notes import notes_on
from rolamento.equilibrium.problem import Floats
from rolamento.kinematics import RacewayControl
from rolamento.state import (
    BallState,
    ContactState,
    RingDisplacement,
    RingLoad,
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
    rows = np.stack([*(column[0] for column in columns), spin_to_roll[0] + 0.0], axis=1)
    return [ContactState(*row) for row in rows.tolist()]


def _shears(bearing: Bearing, contact: HertzContact) -> tuple[Floats, Floats, Floats, Floats]:
    """Greatest shear in the ring under the centre and orthogonal shear, each with its depth."""
    ellipse = contact.semi_major, contact.semi_minor
    greatest = greatest_shear(contact.max_pressure, *ellipse, bearing.ring_material.poisson_ratio)
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


def _ball_states(
    case: Case,
    batch: BatchState,
    table: BallTable,
    inner: list[ContactState],
    outer: list[ContactState],
) -> tuple[BallState, ...]:
    shared = case.model.raceway_control == "none"
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
            raceway_control="none" if shared else _CONTROL_NAMES[int(batch.raceway_control[0, j])],
        )
        for j, row in enumerate(batch.row)
    )
