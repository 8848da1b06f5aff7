"""Lives of a case at many values of its fields: in batches where the fields allow it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.life import Headline, LifeSummary, conditions_of, life_of_batch
from rolamento.numerics import BoolArray, FloatArray
from rolamento.studies.fields import Value
from rolamento.studies.solving import INVALID_INPUT, array_fields, base_case, solve

if TYPE_CHECKING:
    from rolamento.life.l_able import FactorTable

__all__ = [
    "LifeBlock",
    "gathered",
    "gathered_headline",
    "gathered_notes",
    "life_blocks",
    "theories_of",
]


@dataclass(frozen=True, slots=True, eq=False)
class LifeBlock:
    """Some of the points, and their lives.

    Attributes
    ----------
    index
        of the points, (block,)
    status
        of each, (block,)
    summary
        their lives, arrays (block,); None where there is no such case
    refused
        why there is none
    """

    index: NDArray[np.int64]
    status: NDArray[np.str_]
    summary: LifeSummary | None
    refused: InputError | None = None


def life_blocks(
    case: Case,
    columns: Mapping[str, Sequence[Value]],
    *,
    stress_volume: bool = True,
    nsk_table: FactorTable | None = None,
) -> Iterator[LifeBlock]:
    """Solve a case for every row of a table, and find the lives.

    Parameters
    ----------
    case
        Supplies what does not vary. A mounted one is solved with its clearance in operation.
    columns
        Values of one length, checked, SI, by the dotted names of the fields.
    stress_volume
        Whether to evaluate the theory of Ioannides and Harris.
    nsk_table
        a_NSK of L_able.

    Yields
    ------
    LifeBlock
        Rows that differ in arrays only, together; every row in one of them.
    """
    arrays = [name for name in columns if name in array_fields()]
    single = [name for name in columns if name not in array_fields()]
    count = len(next(iter(columns.values())))
    groups: dict[tuple[Value, ...], list[int]] = {}
    for row in range(count):
        groups.setdefault(tuple(columns[name][row] for name in single), []).append(row)
    for own, members in groups.items():
        index = np.array(members, dtype=np.int64)
        varied = {
            name: np.array([columns[name][i] for i in members], np.float64) for name in arrays
        }
        try:
            changed = base_case(case, dict(zip(single, own, strict=True))) if single else case
            yield _solved(changed, index, varied, stress_volume, nsk_table)
        except InputError as error:
            yield LifeBlock(index, np.full(len(index), INVALID_INPUT), None, error)


def _solved(
    case: Case,
    index: NDArray[np.int64],
    varied: dict[str, NDArray[np.float64]],
    stress_volume: bool,
    nsk_table: FactorTable | None,
) -> LifeBlock:
    """Solve a batch of rows, and find their lives."""
    conditions = conditions_of(case, varied)
    if nsk_table is not None:
        conditions = replace(conditions, nsk_table=nsk_table)
    batch = solve(case, varied, cases=len(index), threads=None)
    found = life_of_batch(case, batch, conditions, stress_volume=stress_volume)
    return LifeBlock(index, batch.status, found)


def theories_of(blocks: Sequence[LifeBlock]) -> tuple[str, ...]:
    """Name the theories that were evaluated in any of the blocks."""
    summaries = (block.summary for block in blocks if block.summary is not None)
    return tuple(dict.fromkeys(theory for summary in summaries for theory in summary.theories))


def gathered(blocks: Sequence[LifeBlock], theory: str, name: str, count: int) -> FloatArray:
    """Return an array of a theory's record over all rows; NaN where it was not evaluated."""
    found = np.full(count, np.nan)
    for block in blocks:
        if block.summary is not None and theory in block.summary.theories:
            found[block.index] = getattr(block.summary[theory], name)
    return found


def gathered_headline(blocks: Sequence[LifeBlock], count: int) -> Headline:
    """Return the life that leads over all rows; NaN, and no theory, where there is none."""
    found: dict[str, NDArray[Any]] = {}
    reliability = float("nan")
    for block in blocks:
        if block.summary is None:
            continue
        own = block.summary.headline
        reliability = own.reliability
        for field in fields(Headline):
            array = getattr(own, field.name)
            if isinstance(array, np.ndarray):
                blank = np.nan if array.dtype.kind == "f" else np.zeros((), array.dtype)
                found.setdefault(field.name, np.full(count, blank, dtype=array.dtype))
                found[field.name][block.index] = array
    return Headline(reliability=reliability, **found)


def gathered_notes(blocks: Sequence[LifeBlock], theory: str, count: int) -> dict[str, BoolArray]:
    """Return where each note of a theory is true; those that are nowhere are left out."""
    found: dict[str, BoolArray] = {}
    for block in blocks:
        if block.summary is None or theory not in block.summary.theories:
            continue
        for name, where in block.summary[theory].notes.items():
            if np.any(where):
                found.setdefault(name, np.zeros(count, dtype=np.bool_))[block.index] = where
    return found
