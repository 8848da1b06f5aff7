"""Life over one field of a case: every theory at every point, and where it holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.life import Headline
from rolamento.numerics import BoolArray, FloatArray
from rolamento.studies.life_solving import (
    LifeBlock,
    gathered,
    gathered_headline,
    gathered_notes,
    life_blocks,
    theories_of,
)
from rolamento.studies.ranges import Range, read_range, refuse_many_singles
from rolamento.studies.solving import CONVERGED, INVALID_INPUT, array_fields

if TYPE_CHECKING:
    from rolamento.life.l_able import FactorTable

__all__ = ["LifeCurve", "Range", "life_curve", "read_range"]


@dataclass(frozen=True, slots=True, eq=False)
class LifeCurve:
    """Lives of a case over the values of one field.

    Attributes
    ----------
    case
        what does not vary
    label
        what sets this curve apart from others beside it; empty of the case itself
    over
        the range that was chosen: the field and its values
    status
        (points,), of each solved case; "invalid_input" where there is no such case
    revolutions
        by theory (names as in `rolamento.life`): millions of revolutions, (points,); infinite where
        fatigue never ends it, NaN without a life
    lives
        the same in hours; NaN where nothing turns
    holds, below
        by theory, (points,): whether it is for such a case, and whether the number is a bound
    headline
        the life that leads, by `rolamento.life.Headline`
    notes
        by theory, and by name of the note (`rolamento.life.record.NOTES`), where it is true
    viscosity_ratio, contamination_factor
        κ and e_C, (points,); NaN where they are not known
    """

    case: Case
    label: str
    over: Range
    status: NDArray[np.str_]
    revolutions: Mapping[str, FloatArray]
    lives: Mapping[str, FloatArray]
    holds: Mapping[str, BoolArray]
    below: Mapping[str, BoolArray]
    headline: Headline
    notes: Mapping[str, Mapping[str, BoolArray]]
    viscosity_ratio: FloatArray
    contamination_factor: FloatArray

    def __len__(self) -> int:
        """Count the points."""
        return len(self.over.values)

    @property
    def field(self) -> str:
        """Dotted name of what varies."""
        return self.over.field.name

    @property
    def values(self) -> FloatArray:
        """What it takes, (points,), SI."""
        return self.over.values

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return bool(np.all(self.status == CONVERGED))


def life_curve(
    case: Case, over: Range, *, label: str = "", nsk_table: FactorTable | None = None
) -> LifeCurve:
    """Solve a case over a range, and find its life by every theory.

    Parameters
    ----------
    case
        With its [life] table, designation and lubricant, if it has them.
    over
        From `read_range`.
    label
        What sets this case apart.
    nsk_table
        a_NSK of L_able.

    Raises
    ------
    InputError
        If no point of the range makes a case with a life; of the first point.
    """
    name, count = over.field.name, len(over.values)
    if name not in array_fields():
        refuse_many_singles(count)
    blocks = list(life_blocks(case, {name: over.values.tolist()}, nsk_table=nsk_table))
    if all(block.summary is None for block in blocks):
        assert blocks[0].refused is not None
        raise blocks[0].refused
    status = np.full(count, INVALID_INPUT, dtype="U16")
    for block in blocks:
        status[block.index] = block.status
    theories = theories_of(blocks)
    return LifeCurve(
        case=case,
        label=label,
        over=over,
        status=status,
        revolutions={t: gathered(blocks, t, "life", count) for t in theories},
        lives={t: gathered(blocks, t, "hours", count) for t in theories},
        holds={t: gathered(blocks, t, "holds", count) > 0.0 for t in theories},
        below={t: gathered(blocks, t, "below", count) > 0.0 for t in theories},
        headline=gathered_headline(blocks, count),
        notes={t: gathered_notes(blocks, t, count) for t in theories},
        viscosity_ratio=_numbers(blocks, "viscosity_ratio", count),
        contamination_factor=_numbers(blocks, "contamination_factor", count),
    )


def _numbers(blocks: Sequence[LifeBlock], name: str, count: int) -> FloatArray:
    found = np.full(count, np.nan)
    for block in blocks:
        values = None if block.summary is None else getattr(block.summary, name)
        if values is not None:
            found[block.index] = values
    return found
