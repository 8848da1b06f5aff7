"""Many cases of one bearing at once: columns of values in, columns of results out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.varied import varied_arrays
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.studies.outputs import DEFAULT_OUTPUTS, Evaluation, outputs_of, refuse_missing
from rolamento.words import said

__all__ = ["MOST_CASES", "Batch", "batch"]

SCHEMA: Final = 3
MOST_CASES: Final = 20_000
_MOST_OUTPUTS: Final = 100


@frozen(eq=False)
class Batch:
    """Cases of one bearing, each with a status and its results.

    Attributes
    ----------
    case
        what does not vary
    fields
        (cases,) of each field that varies, by its dotted name, SI
    status
        of each case, ``"converged"`` or why it has no result
    outputs
        (cases,), or (cases, balls) or (cases, rows), by name; NaN without a result
    units
        of the outputs: SI, but of lives
    """

    case: Case
    fields: Mapping[str, FloatArray]
    status: tuple[str, ...]
    outputs: Mapping[str, Any]
    units: Mapping[str, str]

    def to_mapping(self) -> dict[str, Any]:
        """Give all columns as plain values."""
        return {
            "schema": SCHEMA,
            "kind": "batch",
            "title": self.case.title,
            "cases": len(self.status),
            "fields": dict(self.fields),
            "status": list(self.status),
            "units": dict(self.units),
            "outputs": dict(self.outputs),
            "case": self.case.to_mapping(),
        }


def batch(case: Case, fields: Mapping[str, Any], outputs: Sequence[str] = DEFAULT_OUTPUTS) -> Batch:
    """Solve many cases of one bearing; one that is wrong stops no other.

    Parameters
    ----------
    case
        What does not vary.
    fields
        By dotted names, such as ``{"duty.load.fz": ["1 kN", "2 kN"]}``: text with a unit or SI
        numbers, lists of one length, or one value for all cases.
    outputs
        Names of what ``rolamento sweep --list outputs`` shows.

    Raises
    ------
    InputError
        For a field that cannot vary, lists of several lengths, too many cases, an unknown output,
        or one that the case lacks something for. A value that a field would refuse is its own
        case's affair: that has the status "invalid_input".
    """
    if len(outputs) > _MOST_OUTPUTS or len(set(outputs)) < len(outputs):
        rule = said("must be different names, at most {most}", most=_MOST_OUTPUTS)
        raise InputError(rule, field="outputs", example='["x", "stiffness_zz"]')
    arrays = varied_arrays(fields)
    count = max((array.size for array in arrays.values() if array.ndim), default=0)
    if not 1 <= count <= MOST_CASES:
        raise InputError(
            said("must have a list of 1 to {most} values", most=MOST_CASES),
            field="fields",
            value=count,
            example='{"duty.load.fz": ["1 kN", "2 kN"]}',
        )
    chosen = outputs_of(outputs)
    refuse_missing(chosen, case, arrays)
    every = {name: np.broadcast_to(array, count) for name, array in arrays.items()}
    # twice if alone: one case may be solved by plain Python, many are by compiled code
    given = {name: np.repeat(array, 2) if count == 1 else array for name, array in every.items()}
    solved = Evaluation(solve(case, given, threads=1))
    return Batch(
        case=case,
        fields=every,
        status=tuple(map(str, solved.solved.status.code[:count])),
        outputs={output.name: output.compute(solved)[:count] for output in chosen},
        units={output.name: output.unit for output in chosen},
    )
