"""Several bearings on one shaft: the life of each, and of all together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.life import LifeConditions, LifeSummary, conditions_of, life
from rolamento.life.iso16281 import SLOPE
from rolamento.life.spectrum import shaft_life
from rolamento.numerics import FloatArray
from rolamento.solution import solve
from rolamento.state import State

if TYPE_CHECKING:
    from rolamento.life.l_able import FactorTable

__all__ = [
    "MOST_BEARINGS",
    "ShaftHeadline",
    "ShaftLife",
    "conditions_with",
    "life_of_case",
    "life_of_shaft",
]

MOST_BEARINGS: Final = 50
_OF_LIFE: Final = ("dynamic_rating", "viscosity_ratio")
"""Fields of the [life] table that the engine names by their last part."""


@dataclass(frozen=True, slots=True, eq=False)
class ShaftHeadline:
    """The life that leads of each bearing, and of all together; h.

    Attributes
    ----------
    theories
        of the bearings; empty without a result
    bearing_hours
        (bearings,); NaN without a result or rotation
    hours
        of all together
    risk
        (bearings,): share of each in what ends the life
    holds
        whether all of these lives hold
    below
        whether the life of all together is a bound: that of some bearing is
    """

    theories: tuple[str, ...]
    bearing_hours: FloatArray
    hours: float
    risk: FloatArray
    holds: bool
    below: bool

    @classmethod
    def of(cls, lives: Sequence[LifeSummary | None]) -> ShaftHeadline:
        """Put together the lives that lead."""
        known = [None if summary is None else summary.headline for summary in lives]
        hours = np.array([np.nan if own is None else own.hours[0] for own in known])
        leads = all(own is not None and bool(own.leads[0]) for own in known)
        below = leads and any(own is not None and bool(own.below[0]) for own in known)
        return cls(
            theories=tuple("" if own is None else str(own.theory[0]) for own in known),
            bearing_hours=hours,
            hours=float(shaft_life(hours)),
            risk=_risk(hours),
            holds=leads and not below,
            below=below,
        )


@dataclass(frozen=True, slots=True, eq=False)
class ShaftLife:
    """Lives of bearings that all have to survive, for the reliability of each.

    Attributes
    ----------
    states
        of the bearings
    lives
        by every theory; None of a bearing without a result
    bearing_hours
        by theory that all bearings have, (bearings,); NaN without a result or rotation
    hours
        by theory, of all together
    risk
        by theory, (bearings,): share of each in what ends the life
    holds
        by theory: whether it holds for all of them
    headline
        the lives that lead, of each and of all together
    reliability
        S, the same for all
    """

    states: tuple[State, ...]
    lives: tuple[LifeSummary | None, ...]
    bearing_hours: Mapping[str, FloatArray]
    hours: Mapping[str, float]
    risk: Mapping[str, FloatArray]
    holds: Mapping[str, bool]
    headline: ShaftHeadline
    reliability: float

    def __len__(self) -> int:
        """Count the bearings."""
        return len(self.states)

    @property
    def converged(self) -> bool:
        """Whether every bearing has a result."""
        return all(state.status.converged for state in self.states)


def life_of_case(
    case: Case, *, nsk_table: FactorTable | None = None
) -> tuple[State, LifeSummary | None]:
    """Solve a case, and find its life; None without a result.

    Raises
    ------
    InputError
        If the bearing is a thrust bearing, or has no rating and none follows.
    """
    state = solve(case)
    if not state.status.converged:
        return state, None
    try:
        return state, life(state, conditions_with(state.case, nsk_table))
    except InputError as error:
        if error.field in _OF_LIFE:
            raise error.with_details(field=f"life.{error.field}") from None
        raise


def conditions_with(case: Case, nsk_table: FactorTable | None) -> LifeConditions:
    """Return what a case says of its life, with the user's a_NSK if there is one."""
    return replace(conditions_of(case), nsk_table=nsk_table)


def life_of_shaft(cases: Sequence[Case], *, nsk_table: FactorTable | None = None) -> ShaftLife:
    """Find the lives of several bearings, and of all of them together.

    Parameters
    ----------
    cases
        Two or more, one for each bearing; their lives in hours count, so that they may turn at
        different speeds.
    nsk_table
        a_NSK of L_able.

    Raises
    ------
    InputError
        If there are too many, their reliabilities differ, or one has no life for its geometry.
    """
    if not 2 <= len(cases) <= MOST_BEARINGS:
        raise InputError(
            f"must be 2 to {MOST_BEARINGS} on one shaft", field="CASE", value=len(cases)
        )
    wanted = {0.9 if case.life is None else case.life.reliability for case in cases}
    if len(wanted) > 1:
        raise InputError(
            "must be one for all bearings of a shaft",
            field="life.reliability",
            value=", ".join(f"{value:g}" for value in sorted(wanted)),
            example="--reliability 0.9",
        )
    states, lives = zip(*(life_of_case(case, nsk_table=nsk_table) for case in cases), strict=True)
    known = [summary for summary in lives if summary is not None]
    theories = [
        name
        for name in (known[0].theories if known else ())
        if all(name in summary.theories for summary in known)
    ]
    hours = {name: np.array([_hours(summary, name) for summary in lives]) for name in theories}
    return ShaftLife(
        states=states,
        lives=lives,
        bearing_hours=hours,
        hours={name: float(shaft_life(values)) for name, values in hours.items()},
        risk={name: _risk(values) for name, values in hours.items()},
        holds={
            name: all(s is not None and bool(s[name].holds[0]) for s in lives) for name in theories
        },
        headline=ShaftHeadline.of(lives),
        reliability=wanted.pop(),
    )


def _hours(summary: LifeSummary | None, theory: str) -> float:
    return float("nan") if summary is None else float(summary[theory].hours[0])


def _risk(hours: FloatArray) -> FloatArray:
    """Share of each bearing in the risk; that of an endless one is zero."""
    with np.errstate(divide="ignore", invalid="ignore"):
        risk = (np.min(hours) / hours) ** SLOPE
        return np.asarray(risk / risk.sum())
