"""Overload: permanent deformation of races and rolling elements by the load of the case."""

from __future__ import annotations

from math import inf, isfinite
from typing import TYPE_CHECKING, Final

from rolamento.safety import static_safety_of
from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["LAW"]


def _evaluate(found: Analysis) -> Ending | None:
    safety = float(static_safety_of(found.solved).minimum("stress")[0])
    if not isfinite(safety):
        return None  # nothing is loaded
    if safety < 1.0:
        note = Note("permanent_deformation", {"safety": safety})
        return Ending("overload", 0.0, 0.0, 0.0, basis="static", notes=(note,))
    return Ending("overload", inf, inf, inf, basis="static")


LAW: Final = EndingLaw("overload", _evaluate)
