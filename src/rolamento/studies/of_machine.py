"""Studies of a machine: what of it may vary, and how many of it are solved.

Machines that differ in forces and speeds alone are solved together, others one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case.machine import Machine, machine_to_toml, parts_of_key, with_values
from rolamento.case.machine_fields import field_of_machine, fields_of_machine, place_of_key
from rolamento.catalogue import CatalogueBearing, geometry_of, listed
from rolamento.errors import InputError, UnknownKeyError, guess
from rolamento.machines import acts_alone, solve_machines
from rolamento.records import frozen
from rolamento.status import CONVERGED
from rolamento.studies.axes import Column
from rolamento.studies.fields import Field, Value, read_varied
from rolamento.studies.machine_outputs import (
    DEFAULT_OF_MACHINE,
    MachineEvaluation,
    catalogue_of_machine,
    of_each_part,
)
from rolamento.studies.outputs import Output
from rolamento.studies.subject import Attempt, Indices, Inputs
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.studies.study import Study

__all__ = ["MOST_MACHINES", "MOST_STEPS", "OfMachine"]

MOST_MACHINES: Final = 10_000
"""Points of a study of a machine: one by one some 10 to 200 ms each."""
MOST_STEPS: Final = 100_000
"""Points times steps of the spectrum."""
_STEPS_TOGETHER: Final = 256
_MOST_TOGETHER: Final = 32
"""Points of a chunk, after each of which a study can be stopped."""


@frozen(slots=False)
class OfMachine:
    """A machine that a study varies."""

    machine: Machine

    @property
    def key(self) -> str:
        """What holds it in the file of a study, and in a result."""
        return "machine"

    @property
    def title(self) -> str:
        """Its title."""
        return self.machine.title

    def to_toml(self) -> str:
        """Return it as the text of a machine file."""
        return machine_to_toml(self.machine)

    def check_field(self, name: str, at: str) -> None:
        """Refuse a field that no machine has, or of a part that this one lacks."""
        if field_of_machine(name) is None and name not in self.fields():
            raise UnknownKeyError(
                said(
                    "is not a field of a machine; rolamento sweep STUDY --list fields lists them"
                    " all"
                ),
                field=at,
                value=name,
                example='"loads.0.fz"',
            )
        try:
            with_values(self._tables, [(parts_of_key(name), "")])
        except InputError as error:
            raise error.with_details(field=at, value=name) from None

    def place_of(self, name: str) -> str:
        """Return the key with numbers in the places of names."""
        return ".".join(place_of_key(self.machine, name))

    def varies_in_batch(self, name: str) -> bool:
        """Return True: every point is a machine of its own, whatever varies."""
        return True

    def fields(self) -> Mapping[str, Field]:
        """Return the fields that may vary, by their dotted keys."""
        return fields_of_machine(self.machine)

    def catalogue(self) -> Mapping[str, Output]:
        """Return what may be put out, by name."""
        return catalogue_of_machine(self.machine)

    def default_outputs(self) -> Sequence[str]:
        """Return what is put out where a study does not say."""
        return DEFAULT_OF_MACHINE

    def outputs_of(self, names: Sequence[str]) -> tuple[Output, ...]:
        """Return the outputs of some names, those of each part in the place of theirs."""
        found: dict[str, Output] = {}
        for name in names:
            if name not in self._outputs:
                raise UnknownKeyError(
                    said("is an unknown output; {advice}", advice=guess(name, self._outputs)),
                    field="outputs",
                    value=name,
                )
            found.update({one.name: one for one in self._outputs[name]})
        return tuple(found.values())

    def refuse_missing(self, names: Sequence[str], varied: Sequence[str]) -> None:
        """Refuse unknown outputs; what a machine lacks is NaN in all of them."""
        self.outputs_of(names)

    def check_size(self, cases: int) -> None:
        """Refuse more machines, or steps of all of them, than are solved in a study."""
        steps = len(self.machine.spectrum) or 1
        most = min(MOST_MACHINES, MOST_STEPS // steps)
        if cases > most:
            raise InputError(
                said(
                    "give {cases} points; a study of a machine has at most {points}, and at most"
                    " {steps} steps of spectra",
                    cases=cases,
                    points=MOST_MACHINES,
                    steps=MOST_STEPS,
                )
            )

    def work(self, study: Study, columns: Sequence[Mapping[str, Column]]) -> _Work:
        """Return what solves the points of a study."""
        return _Work(self.machine, self._tables, study.varied, columns)

    @cached_property
    def _tables(self) -> dict[str, Any]:
        return self.machine.to_mapping()

    @cached_property
    def _outputs(self) -> dict[str, tuple[Output, ...]]:
        """The outputs by what a study may call them: one, or one of each part."""
        found = {
            name: of_each_part(self.machine, output) for name, output in self.catalogue().items()
        }
        return {one.name: (one,) for own in found.values() for one in own} | found


class _Found:
    """Solved machines of one structure."""

    def __init__(self, evaluation: MachineEvaluation) -> None:
        self._evaluation = evaluation

    @property
    def number(self) -> NDArray[Any]:
        solved = self._evaluation.solved
        status = solved.status.number
        return np.array([CONVERGED if c is None else status[c] for c in solved.unsolved])

    @property
    def advice(self) -> Sequence[Note | None]:
        solved = self._evaluation.solved
        return tuple(None if case is None else solved.advice[case] for case in solved.unsolved)

    def of(self, output: Output) -> NDArray[Any] | None:
        return output.compute(self._evaluation)


class _Work:
    """Points, each a machine of its own."""

    def __init__(
        self,
        machine: Machine,
        tables: Mapping[str, Any],
        varied: Sequence[str],
        columns: Sequence[Mapping[str, Column]],
    ) -> None:
        self._tables = tables
        self._keys = {name: parts_of_key(name) for name in varied}
        self._fields = {name: read_varied(name) for name in varied}
        self._structural = [
            name for name in varied if not acts_alone(machine, place_of_key(machine, name))
        ]
        self.listed = tuple(dict.fromkeys(_own_bearings(machine, columns)))
        self.balls = self.rows = 1
        steps = len(machine.spectrum) or 1
        self.chunk = min(max(_STEPS_TOGETHER // steps, 1), _MOST_TOGETHER)

    def attempts(
        self, group: int, inputs: Inputs, count: int, threads: int | None
    ) -> Iterator[tuple[Indices, Attempt]]:
        """Solve machines of one structure at once; one that is refused is an attempt alone."""
        alike: dict[tuple[Any, ...], list[tuple[int, Machine]]] = {}
        for place in range(count):
            try:
                machine = self._machine(inputs, place)
            except InputError:
                yield _twice(place), partial(self._made_and_found, inputs, place)
                continue
            structure = tuple(inputs[name][place] for name in self._structural)
            alike.setdefault(structure, []).append((place, machine))
        for some in alike.values():
            yield from self._together(some)

    def qualifications(self, group: int, inputs: Inputs) -> Sequence[Note]:
        """Return the notes on a machine."""
        solved = solve_machines([self._machine(inputs, 0)])
        return tuple(note for notes in solved.notes for note in notes)

    def _together(self, some: Sequence[tuple[int, Machine]]) -> Iterator[tuple[Indices, Attempt]]:
        """Solve some machines at once; one by one if one of them cannot be solved at all."""
        places = np.array([place for place, _ in some]) if len(some) > 1 else _twice(some[0][0])
        machines = [machine for _, machine in some] if len(some) > 1 else [some[0][1]] * 2
        try:
            found = _found(machines)
        except InputError:
            for place, machine in some:
                yield _twice(place), partial(_found, [machine, machine])
            return
        yield places, lambda: found

    def _made_and_found(self, inputs: Inputs, place: int) -> _Found:
        return _found([self._machine(inputs, place)] * 2)

    def _machine(self, inputs: Inputs, place: int) -> Machine:
        """The machine of a point.

        Raises
        ------
        InputError
            If there is none.
        """
        values = [
            (key, self._fields[name].written(_plain(inputs[name][place])))
            for name, key in self._keys.items()
        ]
        with listed(self.listed):
            return Machine.from_mapping(with_values(self._tables, values))


def _twice(place: int) -> Indices:
    """Twice if alone: a single case may be solved by plain Python, or by compiled code."""
    return np.array([place, place])


def _found(machines: Sequence[Machine]) -> _Found:
    return _Found(MachineEvaluation(solve_machines(machines)))


def _plain(value: Any) -> Value:
    plain: Value = value.item() if isinstance(value, np.generic) else value
    return plain


def _own_bearings(
    machine: Machine, columns: Sequence[Mapping[str, Column]]
) -> Iterator[CatalogueBearing]:
    """The records outside the built-in catalogue by which the designations are found."""
    for bearing in machine.bearings:
        resolved = bearing.case.bearing.resolved
        yield from () if resolved is None else resolved.records
    for along in columns:
        for name, values in along.items():
            if name.endswith("designation"):
                for designation in dict.fromkeys(values):
                    with suppress(InputError):  # its points will say so
                        yield from geometry_of(str(designation), with_balls=False).records
