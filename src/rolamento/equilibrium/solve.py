"""Solve a case, or many: from what the user gives to the internal state."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Unpack, cast

from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.equilibrium.assemble import solve_columns_of
from rolamento.equilibrium.batch_state import BatchState
from rolamento.equilibrium.columns import DutyFields, spread
from rolamento.equilibrium.notes import with_preload
from rolamento.equilibrium.preload import preload_of
from rolamento.equilibrium.record import state_of
from rolamento.errors import InputError
from rolamento.state import State


def solve(case: Case) -> State:
    """Find the internal state of the bearing: Jones-Harris equilibrium, five degrees of freedom.

    A set of rows shares one rigid inner ring. Never raises for a duty that has no solution: the
    state's status tells, with advice.

    Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8; Jones (1960); Radaelli (2013),
    chapter 4. See docs/theory/equilibrium.md.
    """
    refuse_film(case)
    state = state_of(case, solve_columns_of(spread(case, {}), threads=1))
    if case.bearing.preload is None or not state.status.converged:
        return state
    return with_preload(state, preload_of(case))


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

    Raises
    ------
    InputError
        For an unknown field, arrays of different lengths, or fields that exclude each other. A
        value that the case would refuse is that case's affair: its status is "invalid_input".
    """
    refuse_film(case)
    given = {**(values or {}), **cast("dict[str, ArrayLike]", fields)}
    return solve_columns_of(spread(case, given), threads=threads)


def refuse_film(case: Case) -> None:
    """A film in the balance of the balls is found where films are known: `rolamento.solution`.

    Raises
    ------
    InputError
        If the case wants one.
    """
    if case.model.needs_film:
        raise InputError(
            "is solved by rolamento.solve and rolamento.solve_batch",
            field=case.model.film_field or "",
            example="rolamento.solve(case)",
        )
