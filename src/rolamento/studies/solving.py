"""The one place where studies meet the solver."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.fields import Value

if TYPE_CHECKING:
    from rolamento.solved import Solved

CONVERGED: Final = "converged"
INVALID_INPUT: Final = "invalid_input"


@cache
def array_fields() -> frozenset[str]:
    """Return the fields that may vary within a batch; each value of another needs its own case."""
    from rolamento.case.varied import batch_fields

    return frozenset(batch_fields())


def base_case(case: Case, values: Mapping[str, Value]) -> Case:
    """Return a case with some fields changed; each takes the place of its rival.

    Raises
    ------
    InputError
        If there is no such case.
    """
    return case.with_(values)


def solve(
    case: Case, values: Mapping[str, NDArray[np.float64]], *, cases: int, threads: int | None
) -> Solved:
    """Solve a case for so many values of its fields.

    Raises
    ------
    InputError
        If fields that vary do not go with the case, whatever their values.
    """
    from rolamento.solution import solve as solve_cases

    if not values:  # every case the same: the length has to come from somewhere
        values = {"duty.inner_speed": np.full(cases, case.duty.inner_speed)}
    return solve_cases(case, values, threads=threads)
