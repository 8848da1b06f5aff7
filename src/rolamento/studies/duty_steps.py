"""The steps of a duty, read from a table."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Final, Literal

import numpy as np

from rolamento._tables import Table, read_table
from rolamento.errors import FileError, InputError
from rolamento.numerics import FloatArray
from rolamento.studies.fields import Field, Value, read_field, refuse_rivals

__all__ = ["MOST_STEPS", "DutySteps", "read_spectrum"]

MOST_STEPS: Final = 10_000

Kind = Literal["share", "revolutions"]
"""Shares of time, or of revolutions."""

_EXAMPLE: Final = "share,duty.load.fz,duty.inner_speed"
_ROUNDING: Final = 0.01 + 1e-9
"""By which the shares may miss 1: 33 % three times."""
_FIXED: Final = ("life.reliability", "life.edition", "life.wanted_life", "bearing.arrangement")
"""Of the bearing and its life as a whole, not of a step."""


@dataclass(frozen=True, slots=True, eq=False)
class DutySteps:
    """The steps of a duty.

    Attributes
    ----------
    source
        the file
    kind
        what the shares are of: "share" (time) or "revolutions"
    shares
        (steps,), summing to 1
    given_sum
        what they summed to as given
    fields, values
        what varies, and its checked value in every step, by name
    cells
        the same as written in the file
    lines
        of the steps in the file
    """

    source: str
    kind: Kind
    shares: FloatArray
    given_sum: float
    fields: tuple[Field, ...]
    values: Mapping[str, tuple[Value, ...]]
    cells: Mapping[str, tuple[str, ...]]
    lines: tuple[int, ...]

    def __len__(self) -> int:
        """Count the steps."""
        return len(self.shares)


def read_spectrum(path: str | os.PathLike[str], *, decimal_mark: str | None = None) -> DutySteps:
    """Read the steps of a duty.

    Parameters
    ----------
    path
        Comma-separated values: a column ``share`` (of the time) or ``revolutions`` (shares of
        them), as numbers or per cent, and columns by the dotted names of a case's fields, with
        units in their cells as in a case file.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the table tells whether 12.500 is 12.5.

    Raises
    ------
    InputError
        If it is not such a file, a cell is refused, or the shares do not sum to 1; with line,
        column and an example.
    """
    table = read_table(path, most_rows=MOST_STEPS, example=_EXAMPLE).plain(decimal_mark)
    _check_header(table)
    kind = _kind(table)
    column = table.header.index(kind)
    shares = np.array([_share(table, row, column) for row in range(len(table.rows))])
    total = float(shares.sum())
    if not abs(total - 1.0) <= _ROUNDING:
        raise InputError(
            "must sum to 1", field=kind, value=f"{total:.4g}", source=table.source, example="0.25"
        )
    fields = _fields(table)
    cells = {
        field.name: tuple(row[table.header.index(field.name)] for row in table.rows)
        for field in fields
    }
    return DutySteps(
        source=table.source,
        kind=kind,
        shares=shares / total,
        given_sum=total,
        fields=fields,
        values={field.name: _checked(table, field, cells[field.name]) for field in fields},
        cells=cells,
        lines=table.lines,
    )


def _check_header(table: Table) -> None:
    for name in table.header:
        if name and table.header.count(name) > 1:
            raise FileError(
                "names a column twice", field=name, source=table.source, line=table.header_line
            )


def _kind(table: Table) -> Kind:
    kinds: tuple[Kind, Kind] = ("share", "revolutions")
    given = [kind for kind in kinds if kind in table.header]
    if len(given) != 1:
        raise FileError(
            "needs a column named share (of the time) or revolutions (shares of them)"
            if not given
            else "has both a column share and a column revolutions; give one",
            source=table.source,
            line=table.header_line,
            example=_EXAMPLE,
        )
    return given[0]


def _share(table: Table, row: int, column: int) -> float:
    text = table.rows[row][column]
    try:
        value = float(text.removesuffix("%")) / (100.0 if text.endswith("%") else 1.0)
    except ValueError:
        value = float("nan")
    if not (isfinite(value) and 0.0 <= value <= 1.0 + _ROUNDING):
        raise table.placed(
            InputError(
                "must be from 0 to 1, or from 0 % to 100 %",
                field=table.header[column],
                value=text,
                example="0.25",
            ),
            row,
        )
    return value


def _fields(table: Table) -> tuple[Field, ...]:
    """The fields that the columns name."""
    try:
        names = [name for name in table.header if name not in ("share", "revolutions")]
        fields = tuple(read_field(name, at="column") for name in names)
        for name in names:
            if name in _FIXED:
                raise InputError(
                    "is of the whole duty, not of a step; give it in the case",
                    field="column",
                    value=name,
                )
        refuse_rivals(tuple(names), at="column")
    except InputError as error:
        raise error.with_details(
            source=table.source, line=table.header_line, example=_EXAMPLE
        ) from None
    return fields


def _checked(table: Table, field: Field, cells: Sequence[str]) -> tuple[Value, ...]:
    known: dict[str, Value] = {}
    for row, text in enumerate(cells):
        if text not in known:
            try:
                known[text] = _value(field, text)
            except InputError as error:
                raise table.placed(error, row) from None
    return tuple(known[text] for text in cells)


def _value(field: Field, text: str) -> Value:
    """Read a cell: as text, as a file has quantities and names, else as a number or a truth."""
    if not text:
        raise InputError("is empty", field=field.name, example=field.example)
    plain = {"true": True, "false": False}.get(text, _number(text))
    if plain is None or field.dimension is not None:
        return field.checked(text, in_file=True)
    try:
        return field.checked(plain, in_file=True)
    except InputError as error:
        try:
            return field.checked(text, in_file=True)
        except InputError:
            raise error from None


def _number(text: str) -> int | float | None:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return None
