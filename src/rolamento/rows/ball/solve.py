"""Solve a case, or many: from what the user gives to the internal state."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Unpack, cast

from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.varied import DutyFields
from rolamento.errors import InputError
from rolamento.rows.ball.assemble import solve_columns_of
from rolamento.rows.ball.batch_state import BatchState
from rolamento.rows.ball.columns import spread
from rolamento.rows.ball.notes import with_preload
from rolamento.rows.ball.preload import preload_of
from rolamento.rows.ball.record import state_of
from rolamento.state import State


def solve(case: Case) -> State:
    """Find the internal state of a bearing whose balance has no film in it.

    As `rolamento.solution.solve`, which solves any case.

    Raises
    ------
    InputError
        If the case wants a film in the balance.
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
    """Solve a case without a film in its balance for many values of its fields at once.

    As `rolamento.solution.solve_batch`, which solves any case.

    Raises
    ------
    InputError
        As there, and if the case wants a film in the balance.
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
