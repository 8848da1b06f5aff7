"""Fatigue of a bearing that oscillates; below half the critical angle fretting, without a time."""

from __future__ import annotations

from math import nan
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError
from rolamento.life.oscillation import oscillation_life
from rolamento.life.reliability import reliability_factor
from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["FRETTING", "LAW"]


def _evaluate(found: Analysis) -> Ending | None:
    if found.solved.case.duty.oscillation is None:
        return None
    try:
        life = oscillation_life(found.solved)
    except InputError as error:
        if error.field not in ("bearing.contact_angle", "dynamic_rating"):
            raise
        return Ending("oscillation", nan, notes=(Note("fatigue_without_rating"),))
    if life.fretting:
        return None  # see the next one
    ninety = life.hours / life.reliability_factor
    return Ending(
        name="oscillation",
        hours=ninety,
        low=ninety * float(reliability_factor(0.99)),
        high=ninety * float(reliability_factor(0.5)),
        basis="l10h",
        notes=life.notes,
    )


def _frets(found: Analysis) -> Ending | None:
    if found.solved.case.duty.oscillation is None:
        return None
    try:
        life = oscillation_life(found.solved)
    except InputError:
        return None
    if not life.fretting:
        return None
    return Ending("fretting", nan, basis="untimed", acting=True, notes=life.notes)


LAW: Final = EndingLaw("oscillation", _evaluate)
FRETTING: Final = EndingLaw("fretting", _frets)
