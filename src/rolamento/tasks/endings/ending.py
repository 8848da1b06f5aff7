"""What an ending is: when something ends a bearing, with its spread, and how that is found.

Each stands in a file of its own and in the list of `laws`; its words are in
`rolamento.words.sentences.service_life`. Nothing else names them one by one.
"""

from __future__ import annotations

from collections.abc import Callable
from math import isinf, isnan, nan
from typing import TYPE_CHECKING, Any, Literal

from rolamento.records import frozen
from rolamento.validate import finite
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["Ending", "EndingLaw", "Kind"]

Kind = Literal["end", "upkeep"]
"""Whether it ends the bearing, or is what somebody has to do by then."""


@frozen
class Ending:
    """One thing that may end a bearing.

    Attributes
    ----------
    name
        key of its words, such as ``"fatigue"``
    hours
        until 10 % of such bearings have ended by it; 0 where it does so at once, infinite where it
        never does, NaN where nothing says when
    low, high
        its spread, h: until 1 % and until half of them have, by all laws that there are of it
    basis
        key of the words for what the hours are, such as ``"l10mh"``
    kind
        whether it ends the bearing, or is upkeep such as relubrication
    acting
        whether it is at work though no law says how long: fretting, or a current
    bound
        whether the hours are an upper bound
    notes
        what qualifies it
    """

    name: str
    hours: float
    low: float = nan
    high: float = nan
    basis: str = ""
    kind: Kind = "end"
    acting: bool = False
    bound: bool = False
    notes: tuple[Note, ...] = ()

    @property
    def known(self) -> bool:
        """Whether something says when."""
        return not isnan(self.hours)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; hours, infinite and NaN as None."""
        return {
            "name": self.name,
            "hours": finite(self.hours),
            "low": finite(self.low),
            "high": finite(self.high),
            "basis": self.basis,
            "kind": self.kind,
            "acting": self.acting,
            "upper_bound": self.bound,
            "never": isinf(self.hours),
            "notes": [note.to_mapping() for note in self.notes],
        }


@frozen
class EndingLaw:
    """How an ending is found.

    Attributes
    ----------
    name
        of the ending
    evaluate
        from the analysis of a single case with a result; None where the ending is not of such a
        case
    """

    name: str
    evaluate: Callable[[Analysis], Ending | None]
