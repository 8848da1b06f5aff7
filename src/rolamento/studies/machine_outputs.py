"""Outputs of machines: of all bearings together, of each bearing, of each shaft.

An output of each has a variable for each of them, ``"ring_tilt of drive end"``; a study names one
of these, or all at once, ``"ring_tilt"``. Under a spectrum they are the greatest of all steps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis.analysis import film_and_friction
from rolamento.analysis.machine import leading_lives
from rolamento.case.machine import Machine
from rolamento.life.duty import DutyLife
from rolamento.life.system import SystemLife
from rolamento.numerics import FloatArray
from rolamento.solved.machine import SeatedBearing, SolvedMachine, SolvedShaft
from rolamento.status import CONVERGED
from rolamento.studies.outputs import OF, Along, Kind, Output
from rolamento.words import marked, said
from rolamento.words.quantities import CALLED, called

__all__ = [
    "DEFAULT_OF_MACHINE",
    "MachineEvaluation",
    "called_of_machines",
    "catalogue_of_machine",
    "in_files",
    "of_each_part",
]

DEFAULT_OF_MACHINE: Final = (
    "life_hours", "radial_force", "ring_tilt", "max_pressure", "bearing_life_hours",
    "shaft_deflection", "shaft_stress",
)  # fmt: skip


class MachineEvaluation:
    """Solved machines of one structure, and what follows from them, found once for all outputs."""

    def __init__(self, solved: SolvedMachine) -> None:
        self.solved = solved

        self._found: dict[str, NDArray[Any]] = {}

    def of(self, output: Output) -> NDArray[Any]:
        """Return an output of each part, found once; (machines, parts)."""
        if output.name not in self._found:
            self._found[output.name] = output.compute(self)
        return self._found[output.name]

    @cached_property
    def lives(self) -> tuple[tuple[Mapping[str, DutyLife | None], SystemLife | None], ...]:
        """The lives that lead, of each machine by bearing, and of its bearings together."""
        return leading_lives(self.solved)

    @cached_property
    def power(self) -> Mapping[str, FloatArray]:
        """Friction loss of each bearing that has one; (machines,), W."""
        found = {}
        for name, one in self.solved.bearings.items():
            _, friction = film_and_friction(one.solved, threads=1)
            if friction is not None:
                found[name] = self.solved.greatest(friction.power)
        return found

    def number(self, bearing: str) -> NDArray[np.int64]:
        """How a bearing of each machine ended: in the first step without a result, if any."""
        own = self.solved.bearings[bearing].solved.status.number.reshape(
            len(self.solved.machines), -1
        )
        place = (own != CONVERGED).argmax(axis=1)
        return np.asarray(own[np.arange(len(own)), place], np.int64)


Of = Callable[[MachineEvaluation, str], NDArray[Any]]


def catalogue_of_machine(machine: Machine) -> dict[str, Output]:
    """Return what a study of a machine may name: outputs of the whole, and of each of its parts."""
    bearings = tuple(bearing.name for bearing in machine.bearings)
    shafts = tuple(shaft.name for shaft in machine.shafts)
    of_parts = (
        *(_of_each(described, bearings, "bearing") for described in _of_bearings()),
        *(_of_each(described, shafts, "shaft") for described in _of_shafts()),
    )
    return {output.name: output for output in (*_of_all(), *of_parts)}


def called_of_machines() -> dict[str, Callable[[], str]]:
    """Return what says how each output of a machine is called, by name."""
    of_parts = ((base, called) for base, _, called, *_ in (*_of_bearings(), *_of_shafts()))
    return {output.name: output.called for output in _of_all()} | {
        base: partial(said, called) for base, called in of_parts
    }


def _of_all() -> tuple[Output, ...]:
    return (
        Output("life_hours", "h", lambda: said("life"), _together),
        Output(
            "life_valid", "1", lambda: said("life valid (1) or not (0)"), _all_valid, kind="whole"
        ),
        Output(
            "weakest_bearing",
            "1",
            lambda: said("bearing that limits the life, counted from 0"),
            _weakest,
        ),
        Output("friction_power", "W", lambda: called("power"), _power, slow=True),
    )


def of_each_part(machine: Machine, output: Output) -> tuple[Output, ...]:
    """Return an output of a machine, or one for each of its parts."""
    names = {
        "bearing": [bearing.name for bearing in machine.bearings],
        "shaft": [shaft.name for shaft in machine.shafts],
    }.get(output.along, [])
    return tuple(
        replace(
            output,
            name=f"{output.name}{OF}{in_files(name)}",
            called=partial(_of_part, output, in_files(name)),
            compute=partial(_column, output, place),
            along="",
        )
        for place, name in enumerate(names)
    ) or (output,)


def _of_part(output: Output, part: str) -> str:
    return said("{quantity}, {part}", quantity=output.label, part=part)


def _column(output: Output, place: int, given: MachineEvaluation) -> NDArray[Any]:
    return np.asarray(given.of(output)[:, place])


def in_files(name: str) -> str:
    """Return a name as it may be called in NetCDF, where a stroke would part it."""
    return name.replace("/", "∕")


_Described = tuple[str, str, str, Of, Kind]


def _of_each(described: _Described, names: tuple[str, ...], along: Along) -> Output:
    base, unit, called, get, kind = described

    def compute(given: MachineEvaluation) -> NDArray[Any]:
        return np.stack([get(given, name) for name in names], axis=1)

    return Output(base, unit, partial(said, called), compute, along, kind)


def _of_bearings() -> Iterator[_Described]:
    for base, unit, text, read in (
        ("radial_force", "N", marked("radial force"), lambda one: one.radial_force),
        ("axial_force", "N", marked("axial force"), lambda one: np.abs(one.force[:, 0])),
        (
            "tilting_moment",
            "N*m",
            marked("moment"),
            lambda one: np.hypot(one.force[:, 3], one.force[:, 4]),
        ),
        ("ring_tilt", "rad", CALLED["ring_tilt"], lambda one: one.tilt),
        ("max_pressure", "Pa", CALLED["max_pressure"], lambda one: one.max_pressure),
    ):
        yield base, unit, text, _of_bearing(read), "real"
    yield "bearing_life_hours", "h", marked("life"), _life, "real"
    yield "bearing_life_valid", "1", marked("life valid (1) or not (0)"), _valid, "whole"
    status = marked("how the solution ended")
    yield "bearing_status", "1", status, lambda given, name: given.number(name), "whole"


def _of_shafts() -> Iterator[_Described]:
    for base, unit, text, read in (
        ("shaft_deflection", "m", marked("deflection"), lambda one: one.deflection),
        ("shaft_slope", "rad", marked("slope"), lambda one: one.slope),
        ("shaft_bending_moment", "N*m", marked("bending moment"), lambda one: one.bending_moment),
        ("shaft_stress", "Pa", marked("nominal stress"), lambda one: one.stress),
    ):
        yield base, unit, text, _of_shaft(read), "real"


def _of_bearing(read: Callable[[SeatedBearing], FloatArray]) -> Of:
    return lambda given, name: given.solved.greatest(read(given.solved.bearings[name]))


def _of_shaft(read: Callable[[SolvedShaft], FloatArray]) -> Of:
    return lambda given, name: given.solved.greatest(read(given.solved.shafts[name]))


def _life(given: MachineEvaluation, name: str) -> FloatArray:
    own = (lives[name] for lives, _ in given.lives)
    return np.array([np.nan if life is None else life.hours for life in own])


def _valid(given: MachineEvaluation, name: str) -> NDArray[np.int32]:
    own = (lives[name] for lives, _ in given.lives)
    return np.array([life is not None and life.valid for life in own], np.int32)


def _together(given: MachineEvaluation) -> FloatArray:
    return np.array([np.nan if whole is None else whole.hours for _, whole in given.lives])


def _all_valid(given: MachineEvaluation) -> NDArray[np.int32]:
    return np.array([whole is not None and whole.valid for _, whole in given.lives], np.int32)


def _weakest(given: MachineEvaluation) -> FloatArray:
    return np.array(
        [
            np.nan
            if whole is None or not np.isfinite(whole.risk).all()
            else float(whole.risk.argmax())
            for _, whole in given.lives
        ]
    )


def _power(given: MachineEvaluation) -> FloatArray:
    if not given.power:
        return np.full(len(given.solved.machines), np.nan)
    return np.asarray(np.sum(list(given.power.values()), axis=0))
