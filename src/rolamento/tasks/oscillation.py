"""The life of a bearing that oscillates: at one angle, over angles, and of a histogram of them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from rolamento.case import Case, case_of
from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.life.iso16281 import system_life
from rolamento.life.oscillation import OscillationLife, lives_over_angles, oscillation_life
from rolamento.life.spectrum import miner_life
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.solving import base_case
from rolamento.tasks.life_spectrum import DutySteps, read_spectrum
from rolamento.validate import finite
from rolamento.words import Note, said

__all__ = [
    "OscillationCase",
    "OscillationSpectrum",
    "life_in_oscillation",
    "life_under_oscillations",
]

SCHEMA: Final = 1
_MOST_STEPS: Final = 200
"""Each of them is solved at eight places of its elements."""
_FIRST, _POINTS = 0.25, 61
"""The curve begins at this share of the critical angle and ends at a turn; how many points."""
_MILLION: Final = 1e6
_HOUR: Final = 3600.0

CaseSource = Case | str | os.PathLike[str]
"""A case, or its file."""


@frozen(eq=False)
class OscillationCase:
    """A solved case, its life in oscillations, and that at other angles.

    Attributes
    ----------
    solved
        the case
    life
        at its angle; None without a result
    angles
        (points,), rad
    lives, simple
        there: life, and Harris's form; (points,), millions of oscillations, NaN below the critical
        angles
    """

    solved: Solved
    life: OscillationLife | None
    angles: FloatArray
    lives: FloatArray
    simple: FloatArray

    @property
    def converged(self) -> bool:
        """Whether there is a result."""
        return self.life is not None

    @property
    def notes(self) -> tuple[Note, ...]:
        """What to know of the equilibrium and of the life."""
        own = () if self.life is None else self.life.notes
        return (*own, *self.solved.notes[0])

    def to_json(self) -> str:
        """Return all of it as one JSON object: SI units, millions of oscillations, hours."""
        of_case = self.solved.to_mapping()
        return dumps(
            {
                "schema": SCHEMA,
                "kind": "oscillation",
                **{name: of_case[name] for name in ("title", "status", "notes", "case")},
                "oscillation": None if self.life is None else self.life.to_mapping(),
                "over_angle": {
                    "angle": self.angles,
                    "life": self.lives,
                    "harris": self.simple,
                },
            },
            indent=2,
        )


@frozen(eq=False)
class OscillationSpectrum:
    """Life under a histogram of oscillations: damage gathered race by race.

    Attributes
    ----------
    case
        what does not vary
    steps
        what does, and their shares
    lives
        each step as if it were all of the duty
    life
        millions of oscillations of the mean frequency; NaN if a step that takes part has no life
    hours
        NaN where a step has no frequency
    damage
        (steps,): share of each in what ends the life
    reliability
        S that they are for
    """

    case: Case
    steps: DutySteps
    lives: tuple[OscillationLife, ...]
    life: float
    hours: float
    damage: FloatArray
    reliability: float

    def __len__(self) -> int:
        """Count the steps."""
        return len(self.lives)

    @property
    def converged(self) -> bool:
        """Whether there is a life."""
        return not np.isnan(self.life)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What to know of any step that takes part, each kind once."""
        taking = (one for one, q in zip(self.lives, self.steps.shares, strict=True) if q > 0.0)
        found: dict[str, Note] = {}
        for one in taking:
            for note in one.notes:
                found.setdefault(note.key, note)
        return tuple(found.values())

    def to_json(self) -> str:
        """Return all of it as one JSON object: SI units, millions of oscillations, hours."""
        steps = [
            {"share": float(share), "damage": finite(own), **one.to_mapping()}
            for one, share, own in zip(self.lives, self.steps.shares, self.damage, strict=True)
        ]
        whole: dict[str, Any] = {
            "schema": SCHEMA,
            "kind": "oscillation_spectrum",
            "title": self.case.title,
            "reliability": self.reliability,
            "shares_of": "time" if self.steps.kind == "share" else "oscillations",
            "life": finite(self.life),
            "hours": finite(self.hours),
            "notes": [note.to_mapping() for note in self.notes],
            "steps": steps,
            "case": self.case.to_mapping(),
        }
        return dumps(whole, indent=2)


def life_in_oscillation(case: CaseSource) -> OscillationCase:
    """Solve a case whose duty oscillates, and find its life in oscillations.

    Parameters
    ----------
    case
        With `duty.oscillation`; or its file.

    Raises
    ------
    InputError
        If the duty does not oscillate, or no theory of life is for such a bearing.

    >>> found = life_in_oscillation(
    ...     Case(bearing="6310", duty={"load": {"fz": "5 kN"}, "oscillation": {"angle": "90 deg"}})
    ... )
    >>> found.life.fretting, found.life.frequency is None
    (False, True)
    """
    base = _oscillating(case_of(case))
    solved = solve(base)
    nothing = np.empty(0)
    if not solved.converged[0]:
        return OscillationCase(solved, None, nothing, nothing, nothing)
    found = oscillation_life(solved)
    last = max(2.0 * np.pi, found.angle)
    angles = np.geomspace(min(_FIRST * found.critical, found.angle), last, _POINTS)
    return OscillationCase(solved, found, angles, *lives_over_angles(solved, angles))


def _oscillating(case: Case) -> Case:
    if case.duty.oscillation is None:
        raise InputError(
            said("is missing: how far the ring swings"),
            field="duty.oscillation.angle",
            example="--angle 30deg --frequency 2Hz",
        )
    return case


def life_under_oscillations(
    case: CaseSource,
    steps: DutySteps | str | os.PathLike[str],
    *,
    decimal_mark: str | None = None,
) -> OscillationSpectrum:
    """Find the life under steps of a duty that oscillates, such as a histogram of angles.

    Miner's rule race by race: each step uses up its share over the life that it alone would allow.

    Parameters
    ----------
    case
        Supplies what does not vary; or its file.
    steps
        From `rolamento.tasks.read_spectrum`, or their file: a column ``share`` of the time or
        ``revolutions``, here shares of the oscillations, and fields such as
        ``duty.oscillation.angle``.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file says which.

    Raises
    ------
    InputError
        If a step is no valid case, does not oscillate or has no equilibrium, shares of time lack
        a frequency, or there are too many steps.
    """
    base = case_of(case)
    duty = (
        steps if isinstance(steps, DutySteps) else read_spectrum(steps, decimal_mark=decimal_mark)
    )
    if len(duty) > _MOST_STEPS:
        raise InputError(
            said("has {count} steps; at most {most}", count=len(duty), most=_MOST_STEPS),
            source=duty.source,
        )
    lives = tuple(_step(base, duty, row) for row in range(len(duty)))
    rates = np.array([np.nan if one.frequency is None else one.frequency for one in lives])
    by_time = duty.kind == "share"
    if by_time and np.isnan(rates[duty.shares > 0.0]).any():
        raise InputError(
            said("is missing: the steps have shares of time"),
            field="duty.oscillation.frequency",
            source=duty.source,
            example="--frequency 2Hz",
        )
    turns = duty.shares
    if by_time:
        turns = np.where(duty.shares > 0.0, duty.shares * np.nan_to_num(rates), 0.0)
        turns = turns / turns.sum()
    mean = 1.0 / float((turns / np.where(turns > 0.0, rates, 1.0)).sum())
    return _gathered(base, duty, lives, turns, mean)


def _gathered(
    case: Case, duty: DutySteps, lives: Sequence[OscillationLife], turns: FloatArray, mean: float
) -> OscillationSpectrum:
    """Gather the damage of the races; turns: shares of the oscillations."""
    taking = turns > 0.0
    races = np.array([one.races for one in lives])
    fretting = any(one.fretting for one, part in zip(lives, taking, strict=True) if part)
    slopes = lives[0].slopes
    together = miner_life(races, turns, axis=0)
    life = (
        np.nan
        if fretting
        else lives[0].reliability_factor * float(system_life(together, slope=slopes))
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        used = np.where(taking[:, np.newaxis], turns[:, np.newaxis] / races, 0.0)
        of_race = used.sum(axis=0)
        risk = (of_race / of_race.max()) ** slopes
        share = (used / of_race * (risk / risk.sum())).sum(axis=1)
    return OscillationSpectrum(
        case=case,
        steps=duty,
        lives=tuple(lives),
        life=life,
        hours=_MILLION * life / mean / _HOUR,
        damage=np.full(len(turns), np.nan) if fretting else np.asarray(share),
        reliability=lives[0].reliability,
    )


def _step(base: Case, duty: DutySteps, row: int) -> OscillationLife:
    """Life of one step alone; what is wrong with it is said with its line."""
    values = {name: column[row] for name, column in duty.values.items()}
    try:
        solved = solve(_oscillating(base_case(base, values)))
        return oscillation_life(solved)
    except InputError as error:
        raise error.with_details(source=duty.source, line=duty.lines[row]) from None
