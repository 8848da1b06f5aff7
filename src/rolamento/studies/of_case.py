"""Studies of a bearing: its case, and how many cases of it are solved."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis import analyse
from rolamento.case import Case, case_to_toml
from rolamento.case.arrangement import ARRANGEMENTS
from rolamento.case.machine_fields import field_of_machine
from rolamento.catalogue import CatalogueBearing, geometry_of, listed
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.studies.axes import Column
from rolamento.studies.fields import Field, Value, known_fields, read_field
from rolamento.studies.outputs import (
    DEFAULT_OUTPUTS,
    Evaluation,
    Output,
    catalogue,
    outputs_of,
    refuse_missing,
    supplied,
)
from rolamento.studies.solving import array_fields, base_case, solve
from rolamento.studies.subject import Attempt, Indices, Inputs
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.studies.study import Study

__all__ = ["OfCase"]

_CELLS: Final = 2**13
"""Cases times balls of a chunk: some 10 ms of the solver."""
_FEWEST_CASES: Final = 32
"""In a chunk, and all of them where a case takes milliseconds; a call of the solver takes 1 ms."""
_MOST_CASES: Final = 512
_MOST_OF_BALLS: Final = 4096
"""In a chunk of a large study whose cases take microseconds: fewer calls of the solver."""
_LARGE: Final = 64
"""Chunks that a study has before they grow: enough for any number of threads."""
_MOST_GROUPS: Final = 64
"""Base cases in a chunk: each takes some 10 ms."""


@frozen
class OfCase:
    """A case that a study varies, and its variants or itself."""

    case: Case
    compared: tuple[Case, ...]

    @property
    def key(self) -> str:
        """What holds it in the file of a study, and in a result."""
        return "case"

    @property
    def title(self) -> str:
        """Its title."""
        return self.case.title

    def to_toml(self) -> str:
        """Return it as the text of a case file."""
        return case_to_toml(self.case)

    def check_field(self, name: str, at: str) -> None:
        """Refuse a field that no case has."""
        if field_of_machine(name) is not None:
            raise InputError(
                said("is a field of a machine, and the study is of a case"),
                field=at,
                value=name,
                example='machine = "machine.toml"',
            )
        read_field(name, at=at)

    def place_of(self, name: str) -> str:
        """Return the name as it is."""
        return name

    def varies_in_batch(self, name: str) -> bool:
        """Return whether a field may differ among cases that are solved together."""
        return name in array_fields()

    def fields(self) -> Mapping[str, Field]:
        """Return the fields that may vary, by their dotted names."""
        return known_fields()

    def catalogue(self) -> Mapping[str, Output]:
        """Return what may be put out, by name."""
        return catalogue()

    def default_outputs(self) -> Sequence[str]:
        """Return what is put out where a study does not say."""
        return DEFAULT_OUTPUTS

    def outputs_of(self, names: Sequence[str]) -> tuple[Output, ...]:
        """Return the outputs of some names, which must be known."""
        return outputs_of(names)

    def refuse_missing(self, names: Sequence[str], varied: Sequence[str]) -> None:
        """Refuse an output that no variant has, or the case itself where there is none."""
        outputs = outputs_of(names)
        for output in outputs:
            if not any(supplied(output, case, varied) for case in self.compared):
                refuse_missing([output], self.case, varied)
        if self.compared == (self.case,):
            refuse_missing(outputs, self.case, varied)

    def check_size(self, cases: int) -> None:
        """There may be as many cases as a study may have."""

    def work(self, study: Study, columns: Sequence[Mapping[str, Column]]) -> _Work:
        """Return what solves the cases of a study."""
        return _Work(study, self.compared, columns)


class _Found:
    """Solved cases, and the outputs that their case has."""

    def __init__(self, evaluation: Evaluation, case: Case, study: Study) -> None:
        self._evaluation, self._case, self._study = evaluation, case, study

    @property
    def number(self) -> NDArray[Any]:
        return self._evaluation.solved.status.number

    @property
    def advice(self) -> Sequence[Note | None]:
        solved = self._evaluation.solved
        return () if solved.converged.all() else solved.advice

    def of(self, output: Output) -> NDArray[Any] | None:
        if self._study.variants and not supplied(output, self._case, self._study.varied):
            return None
        return output.compute(self._evaluation)


class _Work:
    """Cases in groups, each of a base case of its own, within which arrays vary."""

    def __init__(
        self, study: Study, compared: tuple[Case, ...], columns: Sequence[Mapping[str, Column]]
    ) -> None:
        self._study, self._compared, self._columns = study, compared, columns
        grouped = (axis.size for axis in study.axes if study.is_grouped(axis))
        self._groups_shape = (len(compared), *grouped)
        self.listed = tuple(dict.fromkeys(self._own_bearings()))
        self._base_case = lru_cache(maxsize=256)(self._made_case)
        self.balls, self.rows = self._maximum_counts()
        self.chunk = self._bounded_chunk()

    def attempts(
        self, group: int, inputs: Inputs, count: int, threads: int | None
    ) -> Iterator[tuple[Indices, Attempt]]:
        """Solve all cases of the group at once."""
        # Twice if alone: a single case may be solved by plain Python, or by compiled code,
        # whose last digits differ, as the process happens to have it loaded.
        cases = np.arange(count) if count > 1 else np.zeros(2, np.intp)
        values = {name: inputs[name][cases] for name in inputs if name in array_fields()}

        def attempt() -> _Found:
            case = self._base_case(group)
            solved = solve(case, values, cases=len(cases), threads=threads)
            return _Found(Evaluation(solved), case, self._study)

        yield cases, attempt

    def qualifications(self, group: int, inputs: Inputs) -> Sequence[Note]:
        """Return the notes on a state; on life and friction where an output is of these."""
        values = {name: np.repeat(inputs[name], 2) for name in inputs if name in array_fields()}
        solved = solve(self._base_case(group), values, cases=2, threads=1)[0]
        needs = {need for output in outputs_of(self._study.outputs) for need in output.needs}
        notes = [*solved.notes[0]]
        if needs & {"life", "friction"} and solved.converged[0]:
            found = analyse(solved, quick=True)
            if "life" in needs and found.life is not None:
                notes += found.life.qualifications()
            if "friction" in needs and found.friction is not None:
                notes += found.friction.qualifications(solved)
        return notes

    def _made_case(self, group: int) -> Case:
        """The base case of a group; the grouping axes are the first ones."""
        values: dict[str, Value] = {}
        variant, *places = np.unravel_index(group, self._groups_shape)
        case = self._compared[int(variant)]
        for columns, place in zip(self._columns, places, strict=False):
            for name, column in columns.items():
                if name not in array_fields():
                    value = column[int(place)]
                    values[name] = float(value) if isinstance(value, np.floating) else value
        if not values:
            return case
        with listed(self.listed):
            return base_case(case, values)

    def _own_bearings(self) -> Iterator[CatalogueBearing]:
        """The records outside the built-in catalogue by which the designations are found."""
        for case in self._compared:
            resolved = case.bearing.resolved
            yield from () if resolved is None else resolved.records
        for columns in self._columns:
            for designation in dict.fromkeys(columns.get("bearing.designation", ())):
                with suppress(InputError):  # its cases will say so
                    yield from geometry_of(str(designation), with_balls=False).records

    def _maximum_counts(self) -> tuple[int, int]:
        """Balls, over all rows, and rows of all the cases, or somewhat more: those dimensions."""
        columns = {name: column for columns in self._columns for name, column in columns.items()}
        counts = [int(count) for count in columns.get("bearing.ball_count", ())]
        arrangements = columns.get("bearing.arrangement", ())
        rows = [len(ARRANGEMENTS[name]) for name in arrangements]  # type: ignore[index]
        balls = []
        for case in self._compared:
            own = [place.bearing.element_count for place in case.bearing.places]
            rows.append(len(own))
            balls.append(sum(own))
            counts += own
        varies = len(columns.keys() & {"bearing.ball_count", "bearing.arrangement"}) > 0
        return (max(counts) * max(rows) if varies else max(balls)), max(rows)

    def _bounded_chunk(self) -> int:
        bounded = min(max(_CELLS // self.balls, _FEWEST_CASES), _MOST_CASES)
        if not any(self._has_rollers()):
            growth = min(self._study.cases // (_LARGE * bounded), _MOST_OF_BALLS // _MOST_CASES)
            bounded *= max(growth, 1)
        if self._is_slow():
            bounded = _FEWEST_CASES
        in_a_group = self._study.cases // math.prod(self._groups_shape)
        return min(bounded, _MOST_GROUPS * in_a_group)

    def _has_rollers(self) -> Iterator[bool]:
        """Whether each case may have rollers, whose balance takes milliseconds."""
        yield any("bearing.designation" in columns for columns in self._columns)
        for case in self._compared:
            yield any(place.bearing.element != "ball" for place in case.bearing.places)

    def _is_slow(self) -> bool:
        """Whether a case takes milliseconds, as far as the study says."""
        controls: set[object] = {one.model.raceway_control for one in self._compared}
        for columns in self._columns:
            controls.update(columns.get("model.raceway_control", ()))
        slow = any(output.slow for output in outputs_of(self._study.outputs))
        return "friction" in controls or slow
