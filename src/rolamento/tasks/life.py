"""The life of a bearing, and of several on one shaft: of each, and of all together."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Final

from rolamento.analysis import analyse
from rolamento.case import Case, case_of
from rolamento.errors import InputError
from rolamento.friction import Friction
from rolamento.io.json import dumps
from rolamento.life import (
    Change,
    LifeConditions,
    LifeSummary,
    conditions_of,
    life,
    sensitivity,
)
from rolamento.life.l_able import NSK_CLEANLINESS, FactorTable, read_factor_table
from rolamento.life.lamina import one_number_of_slices
from rolamento.life.system import SystemLife
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.words import said

__all__ = [
    "MOST_BEARINGS", "CaseLife", "ShaftLife", "SystemLife", "life_of_case", "life_of_shaft",
    "names_of",
]  # fmt: skip

MOST_BEARINGS: Final = 50
SCHEMA: Final = 3
_OF_LIFE: Final = ("dynamic_rating", "viscosity_ratio")
"""Fields of the [life] table that the engine names by their last part."""

CaseSource = Case | str | os.PathLike[str]
"""A case, or its file."""
TableSource = FactorTable | str | os.PathLike[str] | None
"""a_NSK off the maker's chart, or its file."""


@frozen(eq=False)
class CaseLife:
    """A solved case, its life by every theory, what would help, and the friction beside it.

    None without a result; friction also without a lubricant that it could be of.
    """

    solved: Solved
    life: LifeSummary | None
    changes: tuple[Change, ...]
    friction: Friction | None = None

    @property
    def converged(self) -> bool:
        """Whether there is a result."""
        return self.life is not None

    def to_json(self) -> str:
        """Return all of it as one JSON object: SI units, hours, millions of revolutions."""
        of_case = self.solved.to_mapping()
        return dumps(
            {
                "schema": SCHEMA,
                "kind": "life",
                **{name: of_case[name] for name in ("title", "status", "notes", "case")},
                "life": None if self.life is None else self.life.to_mapping(),
                "sensitivity": [
                    {
                        "change": change.name,
                        "life_ratio": change.life_ratio,
                        "what": change.note.to_mapping(),
                    }
                    for change in self.changes
                ],
            },
            indent=2,
        )


@frozen(eq=False)
class ShaftLife:
    """Lives of bearings on one shaft.

    Attributes
    ----------
    bearings
        solved, each a single case
    lives
        by every theory; None of a bearing without a result
    theories
        by name, of those that all bearings have
    headline
        the lives that lead, of each and of all together
    reliability
        S, the same for all
    """

    bearings: tuple[Solved, ...]
    lives: tuple[LifeSummary | None, ...]
    theories: Mapping[str, SystemLife]
    headline: SystemLife
    reliability: float

    def __len__(self) -> int:
        """Count the bearings."""
        return len(self.bearings)

    def __getitem__(self, theory: str) -> SystemLife:
        """Return the life by one theory."""
        return self.theories[theory]

    @property
    def converged(self) -> bool:
        """Whether every bearing has a result."""
        return all(bool(solved.converged[0]) for solved in self.bearings)

    def to_json(self, names: Sequence[str]) -> str:
        """Return all of it as one JSON object: hours, millions of revolutions.

        names: of the bearings.
        """
        leading = self.headline
        return dumps(
            {
                "schema": SCHEMA,
                "kind": "shaft_life",
                "reliability": self.reliability,
                "bearings": [
                    {
                        "name": name,
                        "status": str(solved.status.code[0]),
                        "life": None if summary is None else summary.to_mapping(),
                        "case": solved.case.to_mapping(),
                    }
                    for name, solved, summary in zip(names, self.bearings, self.lives, strict=True)
                ],
                "headline": {
                    "theories": leading.theories,
                    "hours": leading.hours,
                    "valid": leading.valid,
                    "upper_bound": leading.below,
                    "risk": leading.risk,
                },
                "together": {name: own.to_mapping() for name, own in self.theories.items()},
            },
            indent=2,
        )


def life_of_case(
    case: CaseSource, *, nsk_table: TableSource = None, decimal_mark: str | None = None
) -> CaseLife:
    """Solve a case, and find its life and what would help.

    Parameters
    ----------
    case
        Or its file.
    nsk_table, decimal_mark
        a_NSK of L_able, or its file; and the decimal mark in it, ``"point"`` or ``"comma"``, where
        nothing there says which.

    Raises
    ------
    InputError
        If the bearing is a thrust bearing, or has no rating and none follows.
    """
    base = case_of(case)
    table = factor_table(nsk_table, [base], decimal_mark)
    solved = solve(base)
    given = conditions_with(solved, table)
    found = _life(solved, given)
    if found is None:
        return CaseLife(solved, None, ())
    friction = analyse(solved, quick=True).friction
    return CaseLife(solved, found, sensitivity(solved, given), friction)


def names_of(cases: Sequence[Case], otherwise: Iterable[object]) -> list[str]:
    """Return what bearings are called: by their titles if these differ, else as is given."""
    titles = [case.title for case in cases]
    distinct = all(titles) and len(set(titles)) == len(titles)
    return titles if distinct else [str(one) for one in otherwise]


def life_of_shaft(
    cases: Sequence[CaseSource],
    *,
    nsk_table: TableSource = None,
    decimal_mark: str | None = None,
) -> ShaftLife:
    """Find the lives of several bearings, and of all of them together.

    Parameters
    ----------
    cases
        Two or more, or their files, one for each bearing; their lives in hours count, so that they
        may turn at different speeds.
    nsk_table, decimal_mark
        a_NSK of L_able, or its file; and the decimal mark in it, ``"point"`` or ``"comma"``, where
        nothing there says which.

    Raises
    ------
    InputError
        If there are too many, their reliabilities differ, or one has no life for its geometry.
    """
    read = checked_shaft(cases)
    table = factor_table(nsk_table, read, decimal_mark)
    bearings = tuple(solve(case) for case in read)
    lives = tuple(_life(solved, conditions_with(solved, table)) for solved in bearings)
    known = [summary for summary in lives if summary is not None]
    one_number_of_slices(summary.slices for summary in known)
    theories = [
        name
        for name in (known[0].theories if known else ())
        if all(name in summary.theories for summary in known)
    ]
    return ShaftLife(
        bearings=bearings,
        lives=lives,
        theories={
            name: SystemLife.of([None if own is None else own[name] for own in lives])
            for name in theories
        },
        headline=_leading(lives),
        reliability=_reliability(read[0]),
    )


def checked_shaft(cases: Sequence[CaseSource]) -> list[Case]:
    """Return the cases of the bearings of a shaft.

    Raises
    ------
    InputError
        If there are too few or too many, or their reliabilities differ.
    """
    if not 2 <= len(cases) <= MOST_BEARINGS:
        raise InputError(
            said("must be from 2 to {most} on one shaft", most=MOST_BEARINGS),
            field="CASE",
            value=len(cases),
        )
    read = [case_of(case) for case in cases]
    reliabilities = {_reliability(case) for case in read}
    if len(reliabilities) > 1:
        raise InputError(
            said("must be the same for all bearings of a shaft"),
            field="life.reliability",
            value=", ".join(f"{value:g}" for value in sorted(reliabilities)),
            example="--reliability 0.9",
        )
    return read


def _reliability(case: Case) -> float:
    return 0.9 if case.life is None else case.life.reliability


def _leading(lives: Sequence[LifeSummary | None]) -> SystemLife:
    """Put together the lives that lead; where one is a bound, they do not all hold."""
    found = SystemLife.of([None if own is None else own.headline for own in lives])
    return replace(found, valid=found.valid and not found.below)


def _life(solved: Solved, given: LifeConditions) -> LifeSummary | None:
    if not solved.converged[0]:
        return None
    try:
        return life(solved, given)
    except InputError as error:
        if error.field in _OF_LIFE:
            raise error.with_details(field=f"life.{error.field}") from None
        raise


def factor_table(
    source: TableSource, cases: Sequence[Case], decimal_mark: str | None
) -> FactorTable | None:
    """Return a user's a_NSK; read from its file if that is given.

    Raises
    ------
    InputError
        If one of the cases has no a_c, which the columns of the table hold with the load.
    """
    if source is None:
        return None
    if not all(NSK_CLEANLINESS.met(case) for case in cases):
        raise InputError(
            said("is missing: the columns of the a_NSK table depend on it"),
            field=NSK_CLEANLINESS.name,
            example="--set life.nsk_cleanliness=0.8",
        )
    if isinstance(source, FactorTable):
        return source
    return read_factor_table(source, decimal_mark=decimal_mark)


def conditions_with(solved: Solved, nsk_table: FactorTable | None) -> LifeConditions:
    """Return what solved cases say of their life, with the user's a_NSK if there is one."""
    return replace(conditions_of(solved), nsk_table=nsk_table)
