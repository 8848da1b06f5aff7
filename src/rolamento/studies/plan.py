"""From a study to numbered cases, and to chunks of them that can be solved anywhere.

Cases are counted with the last dimension the fastest. A chunk is a run of cases whose length
follows from the study alone, so that whoever solves it, and with however many threads, gets the
same numbers. It is short enough that a run can be stopped after any of them.

`Layout` shows how a result is laid out, whatever the file.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import cached_property, lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

import rolamento
from rolamento.catalogue import CatalogueBearing, listed
from rolamento.errors import InputError, refusal
from rolamento.records import frozen
from rolamento.status import INVALID_INPUT, STATUS_NAMES
from rolamento.studies.axes import Axis
from rolamento.studies.fields import Field, read_varied
from rolamento.studies.names import variable_long_name
from rolamento.studies.outputs import Output
from rolamento.studies.scatter import Sampler
from rolamento.studies.study import (
    SAMPLE,
    VARIANT,
    Study,
    coordinate_names,
    parse_study,
    study_to_json,
    study_to_toml,
)
from rolamento.studies.subject import Found, Inputs
from rolamento.words import Note, speaking
from rolamento.words.headlines import parted

Indices = NDArray[np.intp]
Floats = NDArray[np.float64]

_CELLS_TOGETHER: Final = 2**18
"""Cases times balls of chunks that are written together: 2 MB for each array over balls."""
_MOST_CASES_TOGETHER: Final = 2**16

REASON: Final = "reason"
"""Why a case has no result, beside its status."""


@frozen
class Task:
    """One chunk of a study, to be solved anywhere: `solve_task` needs nothing else.

    study: JSON text; chunk: cases in each; index: of this one; listed: bearings by which its
    designations are found, beside the built-in catalogue.
    """

    study: str
    chunk: int
    index: int
    listed: tuple[CatalogueBearing, ...] = ()


@frozen
class Part:
    """A solved chunk, or several that follow each other, of which index is the first.

    arrays: "status", "reason" and the outputs, over the cases. reasons: why some of them have no
    result, by the numbers of "reason", which is -1 of a case with one.
    """

    index: int
    arrays: Mapping[str, NDArray[Any]]
    reasons: tuple[Note, ...] = ()

    @property
    def cases(self) -> int:
        """Number of cases in it."""
        return len(self.arrays["status"])

    @classmethod
    def joined(cls, parts: Sequence[Part]) -> Part:
        """Return one part of several that follow each other."""
        if len(parts) == 1:
            return parts[0]
        first, reasons = parts[0], Reasons()
        parts = [reasons.renumbered(part) for part in parts]
        arrays = {name: np.concatenate([p.arrays[name] for p in parts]) for name in first.arrays}
        return cls(first.index, arrays, reasons.notes)


class Reasons:
    """Why cases have no result, each reason once and with a number."""

    def __init__(self) -> None:
        self._numbers: dict[Note, int] = {}

    @property
    def notes(self) -> tuple[Note, ...]:
        """The reasons so far, by their numbers."""
        return tuple(self._numbers)

    def number(self, note: Note) -> int:
        """The number of a reason."""
        return self._numbers.setdefault(note, len(self._numbers))

    def renumbered(self, part: Part) -> Part:
        """Return a part with the numbers that its reasons have here."""
        own = np.array([*map(self.number, part.reasons), -1], np.int32)  # the last is that of -1
        arrays = {**part.arrays, REASON: own[part.arrays[REASON]]}
        return Part(part.index, arrays, self.notes)


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
        self.outputs: tuple[Output, ...] = study.variables
        self.columns = [axis.columns() for axis in study.ordered_axes]
        self.sampler = Sampler(study.scatter, study.seed) if study.scatter is not None else None
        grouped = (axis.size for axis in study.axes if study.is_grouped(axis))
        groups = math.prod((len(study.cases_compared) or 1, *grouped))
        self._in_a_group = study.cases // groups
        self.work = study.subject.work(study, self.columns)
        self.balls, self.rows = self.work.balls, self.work.rows
        self.chunk = chunk or self.work.chunk

    @property
    def cases(self) -> int:
        """Number of cases."""
        return self.study.cases

    @property
    def chunks(self) -> int:
        """Number of chunks."""
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
        longest = max(max(self._shape_of(output), default=1) for output in self.outputs)
        cases = min(_CELLS_TOGETHER // longest, _MOST_CASES_TOGETHER)
        return max(cases // self.chunk, 1)

    def places(self, first: int, last: int) -> tuple[Indices, ...]:
        """Place of each case along each dimension."""
        return np.unravel_index(np.arange(first, last), self.study.shape)

    def inputs(self, first: int, last: int) -> dict[str, NDArray[Any]]:
        """What each varied field takes in each of some cases; quantities in SI units."""
        places = self.places(first, last)
        taken: dict[str, NDArray[Any]] = {}
        if self.study.variants:
            taken[VARIANT] = np.array([one.name for one in self.study.compared])[places[0]]
            places = places[1:]
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
        reasons = Reasons()
        for group, cases in self._groups(first, last):
            own = {name: values[cases] for name, values in inputs.items()}
            for places, attempt in self.work.attempts(group, own, len(cases), threads):
                at = cases[places]
                try:
                    found = attempt()
                except InputError:
                    refused = refusal(attempt)
                    assert refused is not None  # it was a moment ago
                    arrays[REASON][at] = reasons.number(refused)
                    continue
                arrays["status"][at] = found.number
                for place, note in enumerate(found.advice):
                    if note is not None:
                        arrays[REASON][at[place]] = reasons.number(note)
                self._put(arrays, at, found)
        return Part(index, arrays, reasons.notes)

    def values(self, inputs: Inputs, threads: int | None = None) -> dict[str, Floats]:
        """Return the outputs for other inputs, of a study without axes; NaN without a result.

        Raises
        ------
        InputError
            If none of them is a case.
        """
        count = len(next(iter(inputs.values())))
        arrays, refused, done = self.empty(count), None, False
        for places, attempt in self.work.attempts(0, inputs, count, threads):
            try:
                self._put(arrays, places, attempt())
                done = True
            except InputError as error:
                refused = error
        if refused is not None and not done:
            raise refused
        return {one.name: np.asarray(arrays[one.name], np.float64) for one in self.outputs}

    def qualifications(self, case: int) -> tuple[Note, ...]:
        """Return the notes that qualify the outputs of one case, which is solved once more."""
        inputs = self.inputs(case, case + 1)
        return parted(self.work.qualifications(case // self._in_a_group, inputs))[0]

    def task(self, index: int) -> Task:
        """A chunk as a message to another process."""
        return Task(self.text, self.chunk, index, self.work.listed)

    @cached_property
    def text(self) -> str:
        """The study as JSON."""
        return study_to_json(self.study)

    def empty(self, cases: int) -> dict[str, NDArray[Any]]:
        """Status and outputs of so many cases, none of them solved."""
        arrays: dict[str, NDArray[Any]] = {
            "status": np.full(cases, INVALID_INPUT, np.int8),
            REASON: np.full(cases, -1, np.int32),
        }
        for output in self.outputs:
            shape = (cases, *self._shape_of(output))
            arrays[output.name] = np.full(shape, output.absent, output.dtype)
        return arrays

    def _shape_of(self, output: Output) -> tuple[int, ...]:
        """What an output has of each case: nothing more, or balls or rows."""
        return {"ball": (self.balls,), "row": (self.rows,)}.get(output.along, ())

    def _put(self, arrays: Mapping[str, NDArray[Any]], cases: Indices, found: Found) -> None:
        """Put the outputs that some cases have to their places."""
        for output in self.outputs:
            values = found.of(output)
            if values is None:
                continue
            if output.along:
                arrays[output.name][cases, : values.shape[1]] = values
            else:
                arrays[output.name][cases] = values

    def _groups(self, first: int, last: int) -> Iterator[tuple[int, Indices]]:
        """Runs of cases that share a base case, each with its number."""
        length = self._in_a_group
        for group in range(first // length, -(-last // length)):
            begin, end = max(first, group * length), min(last, (group + 1) * length)
            yield group, np.arange(begin - first, end - first)

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


def solve_task(task: Task, threads: int | None = 1) -> Part:
    """Solve one chunk; the study is read once for all its chunks."""
    return _plan(task.study, task.chunk, task.listed).solve(task.index, threads)


@lru_cache(maxsize=4)
def _plan(study: str, chunk: int, bearings: tuple[CatalogueBearing, ...]) -> Plan:
    with listed(bearings):
        return Plan(parse_study(study, format="json"), chunk)


BALL: Final = "ball"
ROW: Final = "row"
REASON_TEXT: Final = "reason_text"
"""The dimension of the reasons, and their texts."""
_UNIT: Final = re.compile(r"[\d.+-]+(?:[eE][+-]?\d+)?\s*(.*)", re.DOTALL)


@frozen
class Variable:
    """A variable of the result.

    values: of coordinates along the axes; ``None`` of what is written chunk by chunk.
    """

    name: str
    dims: tuple[str, ...]
    dtype: np.dtype[Any]
    attrs: Mapping[str, Any] = field(default_factory=dict)
    values: NDArray[Any] | None = None


class Layout:
    """The layout of a study's result.

    Attributes
    ----------
    sizes
        of all dimensions, ``"ball"`` and ``"row"`` included if there are outputs along them
    axes
        coordinates along the axes
    samples
        scattered fields, along ``"sample"``
    outputs
        the status, the number of the reason where some cases have no result, then what was asked
        for
    reasons
        in English, by their numbers
    """

    def __init__(self, plan: Plan, reasons: Sequence[Note] = ()) -> None:
        self.plan = plan
        with speaking("en"):
            self.reasons = tuple(note.text for note in reasons)
        study = plan.study
        self.names = {**({VARIANT: VARIANT} if study.variants else {}), **coordinate_names(study)}
        self.dims = tuple(study.sizes)
        self.sizes = dict(study.sizes)
        for along, size in ((BALL, plan.balls), (ROW, plan.rows)):
            if any(output.along == along for output in plan.outputs):
                self.sizes[along] = size
        if self.reasons:
            self.sizes[REASON_TEXT] = len(self.reasons)
        self.axes = tuple(self._along_axes())
        scattered = tuple(study.scatter.fields) if study.scatter is not None else ()
        self.samples = tuple(
            Variable(
                self.names[name], (SAMPLE,), np.dtype(np.float64), field_attrs(read_varied(name))
            )
            for name in scattered
        )
        self.outputs = (*self._ends(), *self._chosen())

    @property
    def coordinates(self) -> str:
        """Names of the coordinates that are no dimension, as the CF conventions list them."""
        names = [variable.name for variable in (*self.axes, *self.samples)]
        return " ".join(name for name in names if name not in self.sizes)

    def attrs(self, counts: Mapping[str, int]) -> dict[str, Any]:
        """Return the attributes of the whole result; counts: cases by status."""
        study = self.plan.study
        attrs: dict[str, Any] = {
            "title": study.title or study.subject.title,
            study.subject.key: study.subject.to_toml(),
            "study": study_to_toml(study),
            "rolamento_version": rolamento.__version__,
            "seed": study.seed,
            "cases": self.plan.cases,
        }
        attrs.update({f"cases_{name}": count for name, count in counts.items() if count})
        return attrs

    def _along_axes(self) -> Iterator[Variable]:
        study, dims = self.plan.study, self.dims
        if study.variants:
            names = np.array([one.name for one in study.compared])
            attrs = {"long_name": variable_long_name(VARIANT)}
            yield Variable(VARIANT, (VARIANT,), names.dtype, attrs, names)
            dims = dims[1:]
        for axis, dim, columns in zip(study.ordered_axes, dims, self.plan.columns, strict=False):
            for name, column in columns.items():
                attrs = {**field_attrs(read_varied(name)), **_given_unit(axis, name)}
                values = np.asarray(column)
                yield Variable(self.names[name], (dim,), values.dtype, attrs, values)
        for along in (BALL, ROW):
            if along in self.sizes:
                numbers = np.arange(self.sizes[along])
                yield Variable(along, (along,), np.dtype(np.int64), {}, numbers)
        if self.reasons:
            texts = np.array(self.reasons)
            attrs = {"long_name": "why cases have no result"}
            yield Variable(REASON_TEXT, (REASON_TEXT,), texts.dtype, attrs, texts)

    def _ends(self) -> Iterator[Variable]:
        attrs = {
            "long_name": "how the solution ended",
            "flag_values": np.array(list(STATUS_NAMES), np.int8),
            "flag_meanings": " ".join(STATUS_NAMES.values()),
        }
        yield Variable("status", self.dims, np.dtype(np.int8), attrs)
        if self.reasons:
            about = {"long_name": f"number of the reason in {REASON_TEXT}; -1 with a result"}
            yield Variable(REASON, self.dims, np.dtype(np.int32), about)

    def _chosen(self) -> Iterator[Variable]:
        for output in self.plan.outputs:
            dims = (*self.dims, output.along) if output.along else self.dims
            attrs = {"units": output.unit, "long_name": output.long_name}
            yield Variable(output.name, dims, output.dtype, attrs)


def field_attrs(known: Field) -> dict[str, Any]:
    """Return the attributes of a coordinate that holds a field of the case."""
    attrs = {"long_name": known.long_name, "field": known.name}
    return {"units": known.unit, **attrs} if known.unit else attrs


def _given_unit(axis: Axis, name: str) -> dict[str, str]:
    """Return the unit that an axis was given in, if it is one and not the SI unit."""
    units = set()
    for value in axis.given(name):
        match = _UNIT.fullmatch(value) if isinstance(value, str) else None
        units.add(match[1].strip() if match else "")
    unit = units.pop() if len(units) == 1 else ""
    known = read_varied(name)
    return {"given_in": unit} if unit and known.dimension and unit != known.unit else {}


def slabs(
    first: int, last: int, shape: tuple[int, ...]
) -> Iterator[tuple[tuple[slice, ...], slice]]:
    """Cut a run of cases into boxes of the grid: each with its place and its part of the run.

    At most one box less than twice the dimensions: a ragged beginning, whole rows, a ragged end.
    """
    yield from _slabs(first, last, shape, (), 0)


def _slabs(
    first: int, last: int, shape: tuple[int, ...], fixed: tuple[slice, ...], offset: int
) -> Iterator[tuple[tuple[slice, ...], slice]]:
    if first >= last:
        return
    length = int(np.prod(shape[1:], dtype=np.int64))
    if len(shape) == 1:
        yield (*fixed, slice(first, last)), slice(offset, offset + last - first)
        return
    row, begin = divmod(first, length)
    end_row, end = divmod(last, length)
    if row == end_row:
        yield from _slabs(begin, end, shape[1:], (*fixed, slice(row, row + 1)), offset)
        return
    if begin:
        yield from _slabs(begin, length, shape[1:], (*fixed, slice(row, row + 1)), offset)
        offset += length - begin
        row += 1
    if row < end_row:
        whole = (end_row - row) * length
        place = (*fixed, slice(row, end_row), *(slice(0, size) for size in shape[1:]))
        yield place, slice(offset, offset + whole)
        offset += whole
    yield from _slabs(0, end, shape[1:], (*fixed, slice(end_row, end_row + 1)), offset)
