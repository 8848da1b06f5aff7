"""What ends a bearing first: fatigue, grease, oscillation and others on one time line."""

from __future__ import annotations

import os
from math import isinf
from typing import Any, Final

from rolamento.analysis import Analysis, analyse
from rolamento.case import Case, case_of
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.tasks.endings import ENDINGS, Ending
from rolamento.units import HOUR
from rolamento.validate import finite
from rolamento.words import Note

__all__ = ["ServiceLife", "service_life", "service_life_of"]

SCHEMA: Final = 1

CaseSource = Case | str | os.PathLike[str]
"""A case, or its file."""


@frozen(eq=False)
class ServiceLife:
    """All endings of one case.

    Attributes
    ----------
    solved
        the case
    endings
        that apply to it, in the order of the registry; empty without a result
    required
        life that is required, h; None if none is
    """

    solved: Solved
    endings: tuple[Ending, ...]
    required: float | None

    def _shown(self) -> dict[str, str]:
        first = self.first
        lines = {one.name: f"{one.hours:.4g} h" for one in self.endings}
        return {"": self.solved.title, "first": "not known" if first is None else first.name,
                **lines}  # fmt: skip

    def __getitem__(self, name: str) -> Ending:
        """Return an ending by its name; KeyError where it does not apply."""
        for one in self.endings:
            if one.name == name:
                return one
        raise KeyError(name)

    @property
    def converged(self) -> bool:
        """Whether the case has a result."""
        return bool(self.solved.converged[0])

    @property
    def first(self) -> Ending | None:
        """What ends it first; what is at work without a time comes before what has one."""
        ends = [one for one in self.endings if one.kind == "end"]
        at_once = [one for one in ends if one.hours == 0.0]
        acting = [one for one in ends if one.acting]
        known = sorted((one for one in ends if one.known), key=lambda one: one.hours)
        return next(iter((*at_once, *acting, *known)), None)

    @property
    def beside_fatigue(self) -> bool:
        """Whether anything but fatigue in rotation is known of its end."""
        return any(one.name != "fatigue" and not isinf(one.hours) for one in self.endings)

    @property
    def rivals(self) -> tuple[Ending, ...]:
        """Endings whose spread reaches into that of the first: they may come before it."""
        first = self.first
        if first is None or not first.known:
            return ()
        return tuple(
            one
            for one in self.endings
            if one is not first and one.kind == "end" and one.known and one.low <= first.high
        )

    @property
    def unknown(self) -> tuple[Ending, ...]:
        """Endings of which nothing says when."""
        return tuple(one for one in self.endings if not one.known and not one.acting)

    @property
    def reaches_required(self) -> bool | None:
        """Whether 90 % of such bearings reach the required life; None where that is open."""
        if self.required is None or self.first is None:
            return None
        if self.first.known and self.first.hours < self.required:
            return False
        if self.first.acting or self.first.bound or self.unknown:
            return None
        return True

    @property
    def notes(self) -> tuple[Note, ...]:
        """What qualifies any of the endings, each once."""
        return tuple(dict.fromkeys(note for one in self.endings for note in one.notes))

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values: hours, NaN and infinite as None."""
        first = self.first
        return {
            "first": None if first is None else first.name,
            "hours": None if first is None else finite(first.hours),
            "may_come_first": [one.name for one in self.rivals],
            "required_life": None if self.required is None else self.required * HOUR,
            "reaches_required": self.reaches_required,
            "endings": [one.to_mapping() for one in self.endings],
        }

    def to_json(self) -> str:
        """Return all of it as one JSON object."""
        of_case = self.solved.to_mapping()
        return dumps(
            {
                "schema": SCHEMA,
                "kind": "service_life",
                **{name: of_case[name] for name in ("title", "status", "notes", "case")},
                "service_life": self.to_mapping(),
            },
            indent=2,
        )


def service_life(case: CaseSource) -> ServiceLife:
    """Solve a case, and find what ends it first.

    Parameters
    ----------
    case
        Or its file, or a designation.

    Raises
    ------
    InputError
        If it is no valid case.

    >>> case = Case(
    ...     bearing="6205-2RS1",
    ...     duty={"inner_speed": "3000 rpm", "load": {"fz": "500 N"}},
    ...     temperature={"lubricant": "80 degC"},
    ... )
    >>> found = service_life(case)
    >>> found.first.name, found["fatigue"].hours > found["grease"].hours
    ('grease', True)
    """
    return service_life_of(analyse(case_of(case), quick=True))


def service_life_of(found: Analysis) -> ServiceLife:
    """Find what ends a case first that is analysed already.

    Parameters
    ----------
    found
        Of a single case.
    """
    solved = found.solved
    wishes = solved.case.life
    required = None if wishes is None or wishes.required_life is None else wishes.required_life
    endings: tuple[Ending, ...] = ()
    if solved.converged[0]:
        tried = (law.evaluate(found) for law in ENDINGS.values())
        endings = tuple(one for one in tried if one is not None)
    return ServiceLife(solved, endings, None if required is None else required / HOUR)
