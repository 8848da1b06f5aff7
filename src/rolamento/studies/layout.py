"""How a result is laid out, whatever the file: dimensions, coordinates, variables, attributes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

import rolamento
from rolamento.case import case_to_toml
from rolamento.studies.axes import Axis
from rolamento.studies.fields import Field, read_field
from rolamento.studies.plan import Plan
from rolamento.studies.reading import study_to_toml
from rolamento.studies.solving import status_names
from rolamento.studies.study import SAMPLE, coordinate_names

__all__ = ["BALL", "Layout", "Variable", "slabs"]

BALL: Final = "ball"
_UNIT: Final = re.compile(r"[\d.+-]+(?:[eE][+-]?\d+)?\s*(.*)", re.DOTALL)


@dataclass(frozen=True, slots=True)
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
        of all dimensions, ``"ball"`` included if there are outputs per ball
    axes
        coordinates along the axes
    samples
        scattered fields, along ``"sample"``
    outputs
        the status, then what was asked for
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        study = plan.study
        self.names = coordinate_names(study)
        self.dims = tuple(study.sizes)
        self.sizes = dict(study.sizes)
        if any(output.per_ball for output in plan.outputs):
            self.sizes[BALL] = plan.balls
        self.axes = tuple(self._along_axes())
        scattered = tuple(study.scatter.fields) if study.scatter is not None else ()
        self.samples = tuple(
            Variable(
                self.names[name], (SAMPLE,), np.dtype(np.float64), field_attrs(read_field(name))
            )
            for name in scattered
        )
        self.outputs = (self._status(), *self._chosen())

    @property
    def coordinates(self) -> str:
        """Names of the coordinates that are no dimension, as the CF conventions list them."""
        names = [variable.name for variable in (*self.axes, *self.samples)]
        return " ".join(name for name in names if name not in self.sizes)

    def attrs(self, counts: Mapping[str, int], messages: tuple[str, ...]) -> dict[str, Any]:
        """Return the attributes of the whole result.

        counts: cases by status; messages: why some are not valid.
        """
        study = self.plan.study
        attrs: dict[str, Any] = {
            "title": study.title or study.case.title,
            "case": case_to_toml(study.case),
            "study": study_to_toml(study),
            "rolamento_version": rolamento.__version__,
            "seed": study.seed,
            "cases": self.plan.cases,
        }
        attrs.update({f"cases_{name}": count for name, count in counts.items() if count})
        if messages:
            attrs["invalid_input_messages"] = "\n".join(messages)
        return attrs

    def _along_axes(self) -> Iterator[Variable]:
        for axis, dim, columns in zip(
            self.plan.study.ordered_axes, self.dims, self.plan.columns, strict=False
        ):
            for name, column in columns.items():
                attrs = {**field_attrs(read_field(name)), **_given_unit(axis, name)}
                values = np.asarray(column)
                yield Variable(self.names[name], (dim,), values.dtype, attrs, values)
        if BALL in self.sizes:
            yield Variable(BALL, (BALL,), np.dtype(np.int64), {}, np.arange(self.plan.balls))

    def _status(self) -> Variable:
        attrs = {
            "long_name": "how the solution ended",
            "flag_values": np.array(list(status_names().values()), np.int8),
            "flag_meanings": " ".join(status_names()),
        }
        return Variable("status", self.dims, np.dtype(np.int8), attrs)

    def _chosen(self) -> Iterator[Variable]:
        for output in self.plan.outputs:
            dims = (*self.dims, BALL) if output.per_ball else self.dims
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
    known = read_field(name)
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
