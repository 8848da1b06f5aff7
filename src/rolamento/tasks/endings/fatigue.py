"""Fatigue in rotation: the life that leads, for 90 %, with that of 99 % and of half of them."""

from __future__ import annotations

from math import isnan, nan
from typing import TYPE_CHECKING, Final

from rolamento.life.iso16281_modified import THEORY as MODIFIED
from rolamento.life.reliability import reliability_factor
from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["LAW"]


def _evaluate(found: Analysis) -> Ending | None:
    case = found.solved.case
    if case.duty.oscillation is not None:
        return None
    if found.life is None:
        return Ending("fatigue", nan, notes=(Note("fatigue_without_rating"),))
    leading = found.life.headline
    edition = found.life.conditions.edition
    basis = "l10mh" if str(leading.theory[0]) == MODIFIED.name else "l10h"
    if not leading.leads[0]:
        reason = leading.reason_of()
        return Ending("fatigue", nan, basis=basis, notes=() if reason is None else (reason,))
    hours = float(leading.hours[0])
    if isnan(hours):
        return Ending("fatigue", nan, basis=basis, notes=(Note("fatigue_without_speed"),))
    ninety = hours / float(reliability_factor(leading.reliability, edition))
    reason = leading.reason_of()
    return Ending(
        name="fatigue",
        hours=ninety,
        low=ninety * float(reliability_factor(0.99, edition)),
        high=ninety * float(reliability_factor(0.5, edition)),
        basis=basis,
        bound=bool(leading.below[0]),
        notes=(*(() if reason is None else (reason,)), *found.life.qualifications()),
    )


LAW: Final = EndingLaw("fatigue", _evaluate)
