"""Solve any case: by the equilibrium alone, or with the lubricant film in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Unpack, cast

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.varied import DutyFields, bounded, varied_arrays
from rolamento.numerics.threads import thread_count
from rolamento.rows import ball as equilibrium
from rolamento.rows.ball import BatchState
from rolamento.rows.ball.columns import spread
from rolamento.rows.ball.record import state_of
from rolamento.state import State
from rolamento.status import CONVERGED, NOT_CONVERGED

__all__ = ["solve", "solve_batch"]


def solve(case: Case) -> State:
    """Find the internal state of the bearing: Jones-Harris equilibrium, five degrees of freedom.

    A set of rows shares one rigid inner ring. Never raises for a duty that has no solution: the
    state's status tells, with advice. A case with a mounting is solved with the clearance in
    operation: `state.case` is the case that it comes to (see `rolamento.clearance`).

    Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8; Jones (1960); Radaelli (2013),
    chapter 4. See docs/theory/equilibrium.md.

    Raises
    ------
    InputError
        If the mounting is not one for this bearing, or closes it.
    """
    if case.mounting is not None:
        return _solve_mounted(case)
    if not case.model.needs_film:
        return equilibrium.solve(case)
    return state_of(case, _on_film(case, {}, threads=1))


def _solve_mounted(case: Case) -> State:
    """Solve with the clearance in operation, which the notes tell."""
    from rolamento.clearance import clearance_notes, clearance_of_case, operating_case

    notes = clearance_notes(clearance_of_case(case))
    state = solve(operating_case(case))
    return replace(state, notes=notes + state.notes)


def solve_batch(
    case: Case,
    values: Mapping[str, ArrayLike] | None = None,
    *,
    threads: int | None = None,
    **fields: Unpack[DutyFields],
) -> BatchState:
    """Solve a case for many values of its fields at once.

    Parameters
    ----------
    case
        Supplies what is not given otherwise.
    values
        Arrays of one length, or scalars, in SI units, by the dotted names of the case's fields,
        such as ``{"bearing.contact_angle": [0.6, 0.7]}``; `batch_fields` lists them.
    threads
        As many as there are processors by default.
    fields
        Likewise by the short names of the duty's fields: inner_speed, outer_speed (rad/s),
        first_ball_azimuth (rad), loads fx, fy, fz (N), my, mz (N·m) and displacements x, y, z
        (m), ry, rz (rad). A load frees its degree of freedom, a displacement holds it.

    A mounted bearing runs with the clearance in operation of each case: that of its temperatures,
    speeds and whatever else varies.

    Raises
    ------
    InputError
        For an unknown field, arrays of different lengths, fields that exclude each other, or
        fewer threads than one. A value that the case would refuse is that case's affair: its
        status is "invalid_input"; so is that of a case with a masked value.
    """
    thread_count(threads)
    given = {**(values or {}), **cast("dict[str, ArrayLike]", fields)}
    if case.mounting is not None:
        case, given = _mounted(case, given)
    if not case.model.needs_film:
        return equilibrium.solve_batch(case, given, threads=threads)
    return _on_film(case, given, threads=threads)


def _on_film(case: Case, given: Mapping[str, ArrayLike], threads: int | None) -> BatchState:
    """Solve with the film that `rolamento.solving` finds."""
    from rolamento import assembly
    from rolamento.lubrication.film_control import balanced_on_film
    from rolamento.rows.ball.assemble import solve_columns_of

    _, settled, film = balanced_on_film(assembly.spread(case, given, threads=threads))
    batch = solve_columns_of(spread(case, given), threads=threads, film=film)
    batch.code[~settled & (batch.code == CONVERGED)] = NOT_CONVERGED
    failed = batch.code != CONVERGED
    arrays = [batch.displacement, batch.load, batch.stiffness]
    for row in batch.rows:
        arrays += [row.displacement, row.load, row.position]
        if row.rolling is not None:
            row.rolling.forget(failed)
    for array in arrays:
        array[failed] = np.nan
    return batch


def _mounted(case: Case, given: Mapping[str, ArrayLike]) -> tuple[Case, dict[str, ArrayLike]]:
    """The case without its mounting, and the fields with the clearance in operation."""
    from rolamento.clearance import operating_batch

    running, fields = operating_batch(case, bounded(varied_arrays(given)))
    return running, dict(fields)
