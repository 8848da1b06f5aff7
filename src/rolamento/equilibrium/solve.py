"""Solve a case, or many: from what the user gives to the internal state."""

from __future__ import annotations

from typing import Unpack

import numpy as np

from rolamento.case import Case
from rolamento.equilibrium import accept, rows
from rolamento.equilibrium.batch_state import BatchState
from rolamento.equilibrium.columns import DutyFields, spread
from rolamento.equilibrium.problem import Floats, case_parameters, ring_arms
from rolamento.equilibrium.record import state_of
from rolamento.equilibrium.run import ball_azimuths, solve_by_jones, solve_columns
from rolamento.state import State


def solve(case: Case) -> State:
    """Find the internal state of the bearing: Jones-Harris equilibrium, five degrees of freedom.

    Never raises for a duty that has no solution: the state's status tells, with advice.

    Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8; Jones (1960); Radaelli (2013),
    chapter 4. See docs/theory/equilibrium.md.
    """
    batch = solve_columns_of(case, case_parameters(case)[:, np.newaxis], threads=1)
    return state_of(case, batch)


def solve_batch(
    case: Case, *, threads: int | None = None, **fields: Unpack[DutyFields]
) -> BatchState:
    """Solve a case for many duties at once.

    Parameters
    ----------
    case
        Supplies what is not in `fields`.
    threads
        As many as there are processors by default.
    fields
        Arrays of one length, or scalars, in SI units: inner_speed, outer_speed (rad/s),
        first_ball_azimuth (rad), loads fx, fy, fz (N), my, mz (N·m) and displacements x, y, z
        (m), ry, rz (rad). A load frees its degree of freedom, a displacement holds it.

    Raises
    ------
    InputError
        For an unknown field, arrays of different lengths, or both a load and a displacement on
        one degree of freedom. A value that is not finite is that case's affair: its status is
        "invalid_input".
    """
    return solve_columns_of(case, spread(case, fields), threads=threads)


def solve_columns_of(
    case: Case, p: Floats, *, threads: int | None = None, fast: bool = True
) -> BatchState:
    """Solve columns of parameters that share the case's bearing and model."""
    bearing, balls = case.bearing, case.bearing.ball_count
    mode = case.model.raceway_control
    if mode == "jones":
        solution, control, verdict = solve_by_jones(bearing, p, threads=threads, fast=fast)
    else:
        control = np.full((1, balls), -1.0 if mode == "inner" else 1.0)
        solution = solve_columns(p, control, balls, threads=threads, fast=fast)
        control = np.broadcast_to(control, (p.shape[1], balls))
        verdict = control.astype(np.int64)

    arms = ring_arms(p).T
    free = p[rows.FREE : rows.FREE + 5].T > 0.0
    applied = p[rows.APPLIED : rows.APPLIED + 5].T
    failed = solution.code != accept.CONVERGED
    load = np.where(free, applied, solution.reaction) * arms
    displacement = solution.displacement / arms
    stiffness = solution.stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :]
    for array in (load, displacement, stiffness, solution.position):
        array[failed] = np.nan
    return BatchState(
        code=solution.code,
        unsupported=solution.unsupported,
        residual=solution.residual,
        iterations=solution.iterations,
        safe_path=solution.safe,
        displacement=displacement,
        load=load,
        stiffness=stiffness,
        bearing=bearing,
        raceway_control=verdict,
        _parameters=p,
        _control=control,
        _position=solution.position,
        _azimuth=ball_azimuths(p, balls),
    )
