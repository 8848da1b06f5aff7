"""Results as tables, one line a case: CSV and Parquet, with pyarrow."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.status import STATUS_NAMES
from rolamento.studies.plan import BALL, REASON, ROW, Layout, Part, Plan, Variable
from rolamento.studies.study import SAMPLE
from rolamento.words import Note, said

__all__ = ["ATTRIBUTES", "CaseColumn", "KeptCases", "csv_writer", "parquet_writer"]

MOST_KEPT_CASES: Final = 2**20 - 1
"""Lines of a sheet of a workbook below its head."""

ATTRIBUTES: Final = b"rolamento"
"""Key of a Parquet schema's metadata: sizes of the dimensions and attributes, as JSON."""


class _Table:
    """Turns parts into record batches and hands them on."""

    def __init__(
        self, plan: Plan, layout: Layout, schema: Any, write: Callable[[Any], None]
    ) -> None:
        self._plan, self._layout, self._schema, self._write = plan, layout, schema, write

    def put(self, part: Part) -> None:
        arrays = [
            pa.array(c, t.type, from_pandas=True)
            for c, t in zip(self.columns(part), self._schema, strict=True)
        ]
        self._write(pa.record_batch(arrays, schema=self._schema))

    def columns(self, part: Part) -> list[Any]:
        """What the cases of a part have in each column."""
        first, last = self._plan.bounds_of(part)
        return [*self._inputs(first, last), *self._outputs(part)]

    def _inputs(self, first: int, last: int) -> Iterator[Any]:
        places = dict(zip(self._layout.dims, self._plan.places(first, last), strict=True))
        inputs = self._plan.inputs(first, last)
        if SAMPLE in places:
            yield places[SAMPLE]
        for name in self._layout.names:
            yield inputs[name]

    def _outputs(self, part: Part) -> Iterator[Any]:
        names = np.array(list(STATUS_NAMES.values()))
        texts = np.array([*self._layout.reasons, ""])  # the last is that of -1
        for variable in self._layout.outputs:
            values = part.arrays[variable.name]
            if variable.name == "status":
                yield names[values]
                yield texts[part.arrays[REASON]]
            elif variable.name == REASON:
                continue
            elif values.ndim == 2:
                yield from values.T
            else:
                yield values


@frozen
class CaseColumn:
    """What all cases of a study have in one column, in order; SI.

    unit: SI; empty of texts and numbers without one. given: whether it is an input.
    """

    name: str
    unit: str
    values: NDArray[Any]
    given: bool


class KeptCases:
    """Keeps the cases of a run as columns: what a page writes to its own tables.

    Raises
    ------
    InputError
        If they are more than a sheet of a workbook can have.
    """

    def __init__(self, plan: Plan, reasons: tuple[Note, ...]) -> None:
        if plan.cases > MOST_KEPT_CASES:
            raise InputError(
                said(
                    "would hold {cases} cases, and takes {most} at most; `output` writes more",
                    cases=plan.cases,
                    most=MOST_KEPT_CASES,
                ),
                field="cases",
                example="--output result.csv",
            )
        layout = Layout(plan, reasons)
        self._heads = _columns(layout)
        self._given = len(layout.names) + (SAMPLE in layout.dims)
        self._parts: list[list[Any]] = []
        self._table = _Table(plan, layout, None, lambda _: None)

    def put(self, part: Part) -> None:
        """Take in a part."""
        self._parts.append(self._table.columns(part))

    @property
    def columns(self) -> tuple[CaseColumn, ...]:
        """The columns so far."""
        return tuple(
            CaseColumn(name, unit, np.concatenate(values), place < self._given)
            for place, ((name, unit, _), values) in enumerate(
                zip(self._heads, zip(*self._parts, strict=True), strict=True)
            )
        )


@contextmanager
def csv_writer(
    path: Path, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
) -> Iterator[_Table]:
    """Open a CSV file: UTF-8, a header with units, an empty field where there is no number."""
    layout = Layout(plan, reasons)
    names = [f"{name} [{unit}]" if unit else name for name, unit, _ in _columns(layout)]
    schema = pa.schema(
        [(name, kind) for name, (_, _, kind) in zip(names, _columns(layout), strict=True)]
    )
    options = pa.csv.WriteOptions(quoting_style="needed")
    with pa.csv.CSVWriter(str(path), schema, write_options=options) as file:
        yield _Table(plan, layout, schema, file.write_batch)


@contextmanager
def parquet_writer(
    path: Path, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
) -> Iterator[_Table]:
    """Open a Parquet file: a row group a part, units with each column, attributes in the schema."""
    layout = Layout(plan, reasons)
    record = {
        "sizes": {name: layout.sizes[name] for name in layout.dims},
        "balls": layout.sizes.get(BALL, 0),
        "rows": layout.sizes.get(ROW, 0),
        "attributes": layout.attrs(counts),
    }
    fields = [
        pa.field(name, kind, metadata={"units": unit} if unit else None)
        for name, unit, kind in _columns(layout)
    ]
    text = json.dumps(record, ensure_ascii=False)
    schema = pa.schema(fields, metadata={ATTRIBUTES: text})
    with pa.parquet.ParquetWriter(str(path), schema, compression="zstd") as file:
        yield _Table(plan, layout, schema, file.write_batch)


def _columns(layout: Layout) -> list[tuple[str, str, Any]]:
    """Name, unit and type of every column."""
    columns: list[tuple[str, str, Any]] = []
    if SAMPLE in layout.dims:
        columns.append((SAMPLE, "", pa.int64()))
    inputs = {variable.name: variable for variable in (*layout.axes, *layout.samples)}
    for name in layout.names.values():
        columns.append((name, *_unit_and_type(inputs[name])))
    for variable in layout.outputs:
        unit, kind = _unit_and_type(variable)
        if variable.name == "status":
            columns += [(variable.name, "", pa.string()), (REASON, "", pa.string())]
        elif variable.name == REASON:
            continue
        elif (along := variable.dims[-1]) in (BALL, ROW):
            columns += [
                (f"{variable.name}_{place}", unit, kind) for place in range(layout.sizes[along])
            ]
        else:
            columns.append((variable.name, unit, kind))
    return columns


def _unit_and_type(variable: Variable) -> tuple[str, Any]:
    unit = variable.attrs.get("units", "")
    kind = pa.string() if variable.dtype.kind == "U" else pa.from_numpy_dtype(variable.dtype)
    return "" if unit == "1" else unit, kind
