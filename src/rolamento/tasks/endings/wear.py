"""Wear: at work where the film is so thin that the surfaces carry the load by themselves.

Below a viscosity ratio of 0.1 no life is calculated (ISO 281:2007, 9.3.3.3): there is boundary
lubrication, and nothing says how long it lasts.
"""

from __future__ import annotations

from math import nan
from typing import TYPE_CHECKING, Final

from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["LAW"]

_BOUNDARY: Final = 0.1


def _evaluate(found: Analysis) -> Ending | None:
    ratio = nan if found.film is None else float(found.film.viscosity_ratio[0])
    if not ratio < _BOUNDARY:
        return None
    note = Note("wear_at_boundary", {"ratio": ratio})
    return Ending("wear", nan, basis="untimed", acting=True, notes=(note,))


LAW: Final = EndingLaw("wear", _evaluate)
