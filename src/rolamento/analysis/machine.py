"""A machine, solved, and all that follows for each of its bearings and for all together."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from rolamento.analysis.analysis import Analysis, analyse, life_of
from rolamento.case.machine import Machine
from rolamento.io.json import dumps, plain
from rolamento.life.duty import DutyLife, lives_of_duty
from rolamento.life.headline import Headline
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.record import Life, slope_of
from rolamento.life.spectrum import revolution_shares
from rolamento.life.summary import LifeSummary
from rolamento.life.system import SystemLife
from rolamento.machines import shaft
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved.machine import SeatedBearing, SolvedMachine
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.friction import Friction
    from rolamento.lubrication import Film
    from rolamento.vibration.machine import MachineFrequency

__all__ = ["BearingLife", "MachineAnalysis", "analyse_machine", "leading_lives"]


@frozen(eq=False)
class BearingLife:
    """Life of a bearing of a machine under all steps of its spectrum.

    Attributes
    ----------
    headline
        the life that leads
    theories
        by name
    reliability
        S that they are for
    """

    headline: DutyLife
    theories: Mapping[str, DutyLife]
    reliability: float

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values: hours, millions of revolutions."""
        return {
            "reliability": self.reliability,
            "headline": {"theory": self.headline.theory or None, **self.headline.to_mapping()},
            "theories": {name: own.to_mapping() for name, own in self.theories.items()},
        }


@frozen(eq=False)
class MachineAnalysis:
    """A solved machine and what follows from it.

    Attributes
    ----------
    solved
        of `rolamento.machines.shaft`
    bearings
        what follows for each, by name: film, friction, life of every step
    lives
        under all steps together, by name; None of a bearing that has none
    together
        of all bearings, by the lives that lead; None without one of each
    theories
        of all bearings together, by the theories that all of them have
    notes
        why a part is missing, by bearing
    """

    solved: SolvedMachine
    bearings: Mapping[str, Analysis]
    lives: Mapping[str, BearingLife | None]
    together: SystemLife | None
    theories: Mapping[str, SystemLife]
    notes: Mapping[str, tuple[Note, ...]]

    @property
    def converged(self) -> bool:
        """Whether every step has a result."""
        return bool(self.solved.status.converged.all())

    @property
    def power(self) -> FloatArray | None:
        """Friction loss of all bearings that have one; (cases,), W; None without any."""
        found = [one.friction.power for one in self.bearings.values() if one.friction is not None]
        return np.sum(found, axis=0) if found else None

    def hardest_step(self, bearing: str | None = None) -> int:
        """Return the step in which a bearing is pressed hardest, or any of them; 0 without one."""
        names = list(self.bearings) if bearing is None else [bearing]
        pressures = [
            np.nan_to_num(contacts.max_pressure, nan=-1.0).max(axis=1)
            for name in names
            for contacts in self.solved.bearings[name].solved.contacts.values()
        ]
        return int(np.max(pressures, axis=0).argmax())

    def frequencies(self, step: int | None = None) -> tuple[MachineFrequency, ...]:
        """Give the frequencies of shafts, gears and bearings, as they are under load.

        Parameters
        ----------
        step
            Of the spectrum, from 0; the hardest if not given.

        Returns
        -------
        tuple of MachineFrequency
        """
        from rolamento.vibration.frequencies import frequencies_of
        from rolamento.vibration.machine import frequencies_of_machine

        case = self.hardest_step() if step is None else step
        machine = self.solved.machine
        factor = machine.spectrum[case].speed_factor if machine.spectrum else 1.0
        by_bearing = {name: frequencies_of(own.solved[case]) for name, own in self.bearings.items()}
        return frequencies_of_machine(machine, by_bearing, factor)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain values: the solved machine, and what follows by bearing."""
        mapping = self.solved.to_mapping()
        for item in mapping["bearings"]:
            own, life = self.bearings[item["name"]], self.lives[item["name"]]
            item["life"] = None if life is None else life.to_mapping()
            item["steps"] = [
                {
                    "life": None if own.life is None else own.life.to_mapping(case),
                    "viscosity_ratio": _at(own.film, "viscosity_ratio", case),
                    "friction_torque": _at(own.friction, "torque", case),
                    "friction_power": _at(own.friction, "power", case),
                }
                for case in range(len(self.solved))
            ]
            item["notes"] = [note.to_mapping() for note in self.notes[item["name"]]]
        step = self.hardest_step()
        mapping["frequencies"] = {
            "step": self.solved.steps[step] or None,
            "lines": [line.to_mapping() for line in self.frequencies(step)],
        }
        together = self.together
        mapping["life"] = {
            "headline": None if together is None else together.to_mapping(),
            "theories": {name: own.to_mapping() for name, own in self.theories.items()},
        }
        return mapping

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object, in SI units and hours.

        `rolamento.solved.machine.SolvedMachine.from_json` reads the solved machine of it.
        """
        return dumps(self.to_mapping(), indent)


def _at(record: Film | Friction | None, name: str, case: int) -> float | None:
    return None if record is None else plain(float(getattr(record, name)[case]))


def analyse_machine(machine: Machine | SolvedMachine | str | os.PathLike[str]) -> MachineAnalysis:
    """Solve a machine, and find what follows for its bearings: film, friction, life.

    Parameters
    ----------
    machine
        A `Machine`, its file, or what `rolamento.shaft` returned.

    Returns
    -------
    MachineAnalysis
        The solved machine, and by bearing its film, friction and life; a step without equilibrium
        has none, and a note says why.

    Raises
    ------
    InputError
        As `rolamento.machines.shaft`, or as `rolamento.analyse` of a bearing.
    FileError
        If the file cannot be read.
    """
    solved = machine if isinstance(machine, SolvedMachine) else shaft(machine)
    bearings, lives = {}, {}
    notes: dict[str, tuple[Note, ...]] = {}
    for name, seated in solved.bearings.items():
        own = analyse(seated.solved)
        bearings[name], notes[name] = own, own.notes
        lives[name] = _life(solved, seated, own.life)
    known = [life for life in lives.values() if life is not None]
    whole = len(known) == len(lives)
    slopes = _slopes([life.headline for life in known])
    names = set.intersection(*(set(life.theories) for life in known)) if whole and known else set()
    return MachineAnalysis(
        solved=solved,
        bearings=bearings,
        lives=lives,
        together=_together([life.headline for life in known], slopes) if whole else None,
        theories={
            name: _together([life.theories[name] for life in known], slopes)
            for name in (known[0].theories if known else ())
            if name in names
        },
        notes=notes,
    )


def _life(
    solved: SolvedMachine, seated: SeatedBearing, summary: LifeSummary | None
) -> BearingLife | None:
    """The life under all steps; None without one in each."""
    if summary is None or not solved.status.converged.all():
        return None
    races = np.concatenate([summary.reference.inner, summary.reference.outer], axis=1)
    found = _under_steps(
        summary.theories, summary.headline, races, summary.reference.race_slopes,
        solved.share, seated.relative_speed,
    )  # fmt: skip
    return None if found is None else BearingLife(*found, summary.headline.reliability)


def _under_steps(
    theories: Mapping[str, Life],
    headline: Headline,
    races: FloatArray,
    slopes: FloatArray,
    share: FloatArray,
    speed: FloatArray,
) -> tuple[DutyLife, dict[str, DutyLife]] | None:
    """The life that leads and that by each theory; None of a bearing that never turns."""
    if not np.any(speed[share > 0.0] > 0.0):
        return None
    turns = revolution_shares(share, speed)
    return lives_of_duty(theories, headline, races, slopes, turns, float(share @ speed))


def leading_lives(
    solved: SolvedMachine,
) -> tuple[tuple[Mapping[str, DutyLife | None], SystemLife | None], ...]:
    """Find the lives that lead, of each machine by bearing, and of its bearings together.

    As `analyse_machine` has them, for many machines of one structure at once.
    """
    found: list[dict[str, DutyLife | None]] = [{} for _ in solved.machines]
    unsolved = solved.unsolved
    for name, seated in solved.bearings.items():
        (summary, _), speed = life_of(seated.solved, stress_volume=False), seated.relative_speed
        for index, machine in enumerate(solved.machines):
            cases, life = solved.cases_of(index), None
            if summary is not None and unsolved[index] is None:
                reference = {REFERENCE.name: _of_cases(summary.theories[REFERENCE.name], cases)}
                life = _under_steps(
                    reference,
                    _of_cases(summary.headline, cases),
                    np.concatenate(
                        [summary.reference.inner[cases], summary.reference.outer[cases]], axis=1
                    ),
                    summary.reference.race_slopes,
                    machine.step_shares,
                    speed[cases],
                )
            found[index][name] = None if life is None else life[0]
    return tuple((own, _all_together(list(own.values()))) for own in found)


def _all_together(lives: list[DutyLife | None]) -> SystemLife | None:
    known = [life for life in lives if life is not None]
    return _together(known, _slopes(known)) if len(known) == len(lives) else None


def _slopes(lives: list[DutyLife]) -> FloatArray:
    return np.array([slope_of(life.steps.element) for life in lives])


_Record = TypeVar("_Record", Life, Headline)


def _of_cases(record: _Record, cases: slice) -> _Record:
    """Some cases of a record of arrays over cases; what is no array is shared."""
    changed: dict[str, Any] = {}
    for part in fields(record):
        value = getattr(record, part.name)
        if isinstance(value, np.ndarray):
            changed[part.name] = value[cases]
        elif isinstance(value, Mapping):
            changed[part.name] = {name: own[cases] for name, own in value.items()}
    return replace(record, **changed)


def _together(lives: list[DutyLife], slopes: FloatArray) -> SystemLife:
    return SystemLife.combined(
        [life.theory for life in lives],
        np.array([life.hours for life in lives]),
        slopes,
        valid=all(life.valid for life in lives),
        below=any(life.below for life in lives),
    )
