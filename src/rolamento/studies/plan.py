"""From a study to numbered cases, and to chunks of them that can be solved anywhere.

Cases are counted with the last dimension the fastest. A chunk is a run of cases whose length
follows from the study alone, so that whoever solves it, and with however many threads, gets the
same numbers. It is short enough that a run can be stopped after any of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.arrangement import ARRANGEMENTS
from rolamento.errors import InputError
from rolamento.studies.fields import Value
from rolamento.studies.outputs import Output, Solved, outputs_of
from rolamento.studies.reading import parse_study, study_to_json
from rolamento.studies.sampling import Sampler
from rolamento.studies.solving import INVALID_INPUT, array_fields, base_case, solve, status_names
from rolamento.studies.study import SAMPLE, Study

__all__ = ["Part", "Plan", "Task", "solve_task"]

Indices = NDArray[np.intp]
Floats = NDArray[np.float64]

_CELLS: Final = 2**13
"""Cases times balls of a chunk: some 10 ms of the solver."""
_FEWEST_CASES: Final = 32
"""In a chunk, and all of them where a case takes milliseconds; a call of the solver takes 1 ms."""
_MOST_CASES: Final = 512
_CELLS_TOGETHER: Final = 2**18
"""Cases times balls of chunks that are written together: 2 MB for each array over balls."""
_MOST_CASES_TOGETHER: Final = 2**14
_MOST_MESSAGES: Final = 5
_MOST_GROUPS: Final = 64
"""Base cases in a chunk: each takes some 10 ms."""


@dataclass(frozen=True, slots=True)
class Task:
    """One chunk of a study, to be solved anywhere: `solve_task` needs nothing else.

    study: JSON text; chunk: cases in each; index: of this one.
    """

    study: str
    chunk: int
    index: int


@dataclass(frozen=True, slots=True)
class Part:
    """A solved chunk, or several that follow each other, of which index is the first.

    arrays: "status" and the outputs, over the cases. messages: why some of them are not valid.
    """

    index: int
    arrays: Mapping[str, NDArray[Any]]
    messages: tuple[str, ...] = ()

    @property
    def cases(self) -> int:
        """How many it holds."""
        return len(self.arrays["status"])

    @classmethod
    def joined(cls, parts: Sequence[Part]) -> Part:
        """Return one part of several that follow each other."""
        if len(parts) == 1:
            return parts[0]
        first = parts[0]
        arrays = {name: np.concatenate([p.arrays[name] for p in parts]) for name in first.arrays}
        messages = dict.fromkeys(text for part in parts for text in part.messages)
        return cls(first.index, arrays, tuple(messages))


class Plan:
    """A study in numbers.

    Parameters
    ----------
    study
        What to do.
    chunk
        Cases in a chunk; by default what keeps memory within bounds.
    """

    def __init__(self, study: Study, chunk: int | None = None) -> None:
        self.study = study
        self.outputs: tuple[Output, ...] = outputs_of(study.outputs)
        self.columns = [axis.columns() for axis in study.ordered_axes]
        self.sampler = Sampler(study.scatter, study.seed) if study.scatter is not None else None
        self._groups_shape = tuple(axis.size for axis in study.axes if study.is_grouped(axis))
        self._in_a_group = study.cases // math.prod(self._groups_shape)
        self._base_case = lru_cache(maxsize=256)(self._made_case)
        self.balls = self._greatest_ball_count()
        self.chunk = chunk or self._bounded_chunk()

    @property
    def cases(self) -> int:
        """In all."""
        return self.study.cases

    @property
    def chunks(self) -> int:
        """In all."""
        return -(-self.cases // self.chunk)

    def bounds(self, index: int) -> tuple[int, int]:
        """First case of a chunk, and the first after it."""
        return index * self.chunk, min((index + 1) * self.chunk, self.cases)

    def size(self, index: int) -> int:
        """Cases in a chunk."""
        first, last = self.bounds(index)
        return last - first

    def bounds_of(self, part: Part) -> tuple[int, int]:
        """First case of a part, and the first after it."""
        first, _ = self.bounds(part.index)
        return first, first + part.cases

    @property
    def chunks_together(self) -> int:
        """Chunks that are best written together: what follows from a file does not depend on it."""
        cases = min(_CELLS_TOGETHER // self.balls, _MOST_CASES_TOGETHER)
        return max(cases // self.chunk, 1)

    def places(self, first: int, last: int) -> tuple[Indices, ...]:
        """Place of each case along each dimension."""
        return np.unravel_index(np.arange(first, last), self.study.shape)

    def inputs(self, first: int, last: int) -> dict[str, NDArray[Any]]:
        """What each varied field takes in each of some cases; quantities in SI units."""
        places = self.places(first, last)
        taken: dict[str, NDArray[Any]] = {}
        for columns, place in zip(self.columns, places, strict=False):
            for name, column in columns.items():
                taken[name] = np.asarray(column)[place]
        if self.sampler is not None:
            taken.update(self._drawn(first, last))
        return taken

    def solve(self, index: int, threads: int | None = 1) -> Part:
        """Solve a chunk."""
        first, last = self.bounds(index)
        arrays = self.empty(last - first)
        inputs = self.inputs(first, last)
        varied = {name: inputs[name] for name in inputs if name in array_fields()}
        messages: list[str] = []
        for group, cases in self._groups(first, last):
            # Twice if alone: a single case may be solved by plain Python, or by compiled code,
            # whose last digits differ, as the process happens to have it loaded.
            solved = cases if len(cases) > 1 else np.repeat(cases, 2)
            values = {name: values[solved] for name, values in varied.items()}
            try:
                case = self._base_case(group)
                batch = solve(case, values, cases=len(solved), threads=threads)
            except InputError as error:
                if str(error) not in messages and len(messages) < _MOST_MESSAGES:
                    messages.append(str(error))
                continue
            arrays["status"][solved] = batch.code
            self._put(arrays, solved, Solved(batch, case, values))
        return Part(index, arrays, tuple(messages))

    def task(self, index: int) -> Task:
        """A chunk as a message to another process."""
        return Task(self.text, self.chunk, index)

    @cached_property
    def text(self) -> str:
        """The study as JSON."""
        return study_to_json(self.study)

    def empty(self, cases: int) -> dict[str, NDArray[Any]]:
        """Status and outputs of so many cases, none of them solved."""
        arrays: dict[str, NDArray[Any]] = {
            "status": np.full(cases, status_names()[INVALID_INPUT], np.int8)
        }
        for output in self.outputs:
            shape = (cases, self.balls) if output.per_ball else (cases,)
            arrays[output.name] = np.full(shape, output.absent, output.dtype)
        return arrays

    def _put(self, arrays: Mapping[str, NDArray[Any]], cases: Indices, solved: Solved) -> None:
        """Compute the outputs of a group, and put them to their places."""
        for output in self.outputs:
            values = output.compute(solved)
            if output.per_ball:
                arrays[output.name][cases, : values.shape[1]] = values
            else:
                arrays[output.name][cases] = values

    def _groups(self, first: int, last: int) -> Iterator[tuple[int, Indices]]:
        """Runs of cases that share a base case, each with its number."""
        length = self._in_a_group
        for group in range(first // length, -(-last // length)):
            begin, end = max(first, group * length), min(last, (group + 1) * length)
            yield group, np.arange(begin - first, end - first)

    def _made_case(self, group: int) -> Case:
        """The base case of a group; the grouping axes are the first ones."""
        values: dict[str, Value] = {}
        places = np.unravel_index(group, self._groups_shape) if self._groups_shape else ()
        for columns, place in zip(self.columns, places, strict=False):
            for name, column in columns.items():
                if name not in array_fields():
                    value = column[int(place)]
                    values[name] = float(value) if isinstance(value, np.floating) else value
        return base_case(self.study.case, values) if values else self.study.case

    def _drawn(self, first: int, last: int) -> dict[str, Floats]:
        """Draws of some cases: a run of samples, that begins anew for each point of the axes."""
        assert self.sampler is not None
        samples = self.study.sizes[SAMPLE]
        begin, count = first % samples, last - first
        if samples <= count:
            place = np.arange(first, last) % samples
            return {name: drawn[place] for name, drawn in self.sampler.draw(0, samples).items()}
        end = begin + count
        drawn = self.sampler.draw(begin, min(end, samples))
        if end > samples:
            again = self.sampler.draw(0, end - samples)
            drawn = {name: np.concatenate([drawn[name], again[name]]) for name in drawn}
        return drawn

    def _greatest_ball_count(self) -> int:
        """Of all the cases, over all rows, or somewhat more: the length of that dimension."""
        bearing = self.study.case.bearing
        columns = {name: column for columns in self.columns for name, column in columns.items()}
        counts = columns.get("bearing.ball_count", ())
        arrangements = columns.get("bearing.arrangement", ())
        own = [place.bearing.ball_count for place in bearing.places]
        if not len(counts) and not len(arrangements):
            return sum(own)
        rows = [len(own), *(len(ARRANGEMENTS[name]) for name in arrangements)]  # type: ignore[index]
        return max(*own, *(int(count) for count in counts)) * max(rows)

    def _bounded_chunk(self) -> int:
        bounded = min(max(_CELLS // self.balls, _FEWEST_CASES), _MOST_CASES)
        if self._is_slow():
            bounded = _FEWEST_CASES
        return min(bounded, _MOST_GROUPS * self._in_a_group) if self._groups_shape else bounded

    def _is_slow(self) -> bool:
        """Whether a case takes milliseconds, as far as the study tells."""
        controls: set[object] = {self.study.case.model.raceway_control}
        for columns in self.columns:
            controls.update(columns.get("model.raceway_control", ()))
        return "friction" in controls or any(output.slow for output in self.outputs)


def solve_task(task: Task, threads: int | None = 1) -> Part:
    """Solve one chunk; the study is read once for all its chunks."""
    return _plan(task.study, task.chunk).solve(task.index, threads)


@lru_cache(maxsize=4)
def _plan(study: str, chunk: int) -> Plan:
    return Plan(parse_study(study, format="json"), chunk)
