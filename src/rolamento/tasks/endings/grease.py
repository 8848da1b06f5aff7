"""The grease of a sealed bearing ends it; that of an open one wants renewing."""

from __future__ import annotations

from math import isnan, nan
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError
from rolamento.grease.estimate import life_of_mean
from rolamento.grease.of_case import GreaseCase, grease_of_solved
from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["LAW", "RENEWAL"]


def _grease(found: Analysis) -> GreaseCase | None:
    """The grease of a case, if it has one: by its lubricant, or sealed without a word on it."""
    lubricant = found.solved.case.lubricant
    if lubricant is not None and lubricant.kind != "grease":
        return None
    try:
        grease = grease_of_solved(found.solved)
    except InputError:  # a set of different elements has no limiting speed
        return None
    return grease if lubricant is not None or grease.sealed else None


def _life(found: Analysis) -> Ending | None:
    grease = _grease(found)
    if grease is None or not grease.sealed:
        return None
    low, high = grease.spread
    if isnan(grease.hours):
        reasons = tuple(note for one in grease.lives for note in one.notes)
        told = (Note("grease_without_life"),) if reasons or not grease.notes else ()
        return Ending("grease", nan, basis="grease_l10", notes=(*told, *grease.notes))
    return Ending(
        name="grease",
        hours=grease.l10,
        low=life_of_mean(low, 0.99),
        high=high,
        basis="grease_l10",
        notes=grease.notes,
    )


def _renewal(found: Analysis) -> Ending | None:
    grease = _grease(found)
    if grease is None or grease.sealed or not grease.intervals:
        return None
    low, high = grease.interval
    of_skf = next(one.low for one in grease.intervals if one.name == "skf")
    return Ending(
        name="relubrication",
        hours=of_skf,
        low=low,
        high=high,
        basis="interval",
        kind="upkeep",
        notes=grease.notes,
    )


LAW: Final = EndingLaw("grease", _life)
RENEWAL: Final = EndingLaw("relubrication", _renewal)
