"""Tables of bearings in service: how long each has run, and how much it runs a day.

The columns are those of life tests (`rolamento.weibull.reading`): a time, if any a status and a
count; a row whose status says failed is left out, and without a status all are in service. A column
such as "hours per day" or "uso por dia" holds the use of each: in the unit of the times, a day.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.io.columns import (
    check_names,
    column_by_name,
    folded_name,
    heads_table,
    title_parts,
)
from rolamento.io.tables import parse_table, table_text
from rolamento.numerics import FloatArray, IntArray
from rolamento.records import frozen
from rolamento.weibull.life_test import MAXIMUM_TIME, LifeTest, passed_over_notes
from rolamento.weibull.reading import (
    check_status,
    header_of,
    number_in,
    says_failed,
    whole_number_in,
)
from rolamento.weibull.table_forms import place_of_use
from rolamento.words import Note, said

__all__ = ["FleetTable", "parse_fleet", "read_fleet"]

_EXAMPLE: Final = "time (h),count"
_MAXIMUM_ROWS: Final = 10_000
_NAMING: Final = ("bearing", "tag", "machine", "rig", "group")
_STATUS: Final = ("status", "failed", "suspended")


@frozen(eq=False)
class FleetTable:
    """Bearings in service, as a table gives them.

    Attributes
    ----------
    ages
        (rows,) run so far
    counts
        (rows,) bearings alike
    usage
        (rows,) use a day, in the unit of the ages; NaN where the table does not say
    names
        (rows,) of the bearings or machines; empty where there are none
    unit
        label of times
    left_out
        bearings that have failed
    notes
        what of the table was not read
    """

    ages: FloatArray
    counts: IntArray
    usage: FloatArray
    names: tuple[str, ...]
    unit: str
    left_out: int
    notes: tuple[Note, ...]

    @classmethod
    def of_test(cls, test: LifeTest) -> FleetTable:
        """Take the suspended bearings of a life test for those in service."""
        running = ~test.failed
        names = tuple(str(name) for name in test.group[running])
        return cls(
            test.times[running],
            test.counts[running],
            np.full(int(running.sum()), np.nan),
            names,
            test.unit,
            test.failures,
            (),
        )


def read_fleet(
    path: str | os.PathLike[str],
    *,
    unit: str | None = None,
    time: str | None = None,
    status: str | None = None,
    count: str | None = None,
    usage: str | None = None,
    decimal_mark: str | None = None,
    ignored: Sequence[str] = (),
) -> FleetTable:
    """Read a table of bearings in service from a CSV file.

    Parameters
    ----------
    path
        Of the file; ``"-"`` for standard input.
    unit
        Label of the times, in place of what the file says; "h" where it says nothing.
    time, status, count, usage
        Names of the columns, in place of the usual ones.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file shows whether 12.500 is 12.5.
    ignored
        Names of columns that have nothing to say, though they could.

    Raises
    ------
    FileError, InputError
        With the line, if the file cannot be read or is no such table.
    """
    text, source = table_text(path)
    return parse_fleet(
        text, source, unit=unit, time=time, status=status, count=count, usage=usage,
        decimal_mark=decimal_mark, ignored=ignored,
    )  # fmt: skip


def parse_fleet(
    text: str,
    source: str = "",
    *,
    unit: str | None = None,
    time: str | None = None,
    status: str | None = None,
    count: str | None = None,
    usage: str | None = None,
    decimal_mark: str | None = None,
    ignored: Sequence[str] = (),
) -> FleetTable:
    """Read a table of bearings in service from text; arguments as of `read_fleet`."""
    wanted = {"time": time, "status": status, "count": count}
    chosen = {name: title for name, title in wanted.items() if title is not None}
    is_header = heads_table(*chosen.values(), usage or "")
    table = parse_table(
        text, source, most_rows=_MAXIMUM_ROWS, example=_EXAMPLE, is_header=is_header
    )
    try:
        check_names(table.header, _EXAMPLE)
        header = header_of(table.header, chosen, table.rows, ignored)
        check_status(header, table.rows, ignored)
        use = place_of_use(table.header, usage, set(header.places.values()))
    except InputError as error:
        raise table.placed(error) from None
    places = header.places
    numeric = [places["time"], *([] if use is None else [use])]
    numerals = table.numerals(numeric, decimal_mark)
    ages, counts, uses, names, failed = [], [], [], [], 0
    label_at = _place_of_names(table.header)
    for number, cells in enumerate(table.rows):
        given = {column: cells[place] for column, place in places.items()}
        try:
            many = whole_number_in(given, header.names, "count")
            if any(kind in places for kind in _STATUS) and says_failed(given, header.names):
                failed += many
                continue
            age = number_in(given["time"], header.names["time"], numerals)
            if not 0.0 <= age <= MAXIMUM_TIME:
                raise InputError(
                    said("must be from {least:.6g} to {most:.6g}", least=0.0, most=MAXIMUM_TIME),
                    field=header.names["time"],
                    value=given["time"],
                    example="8200",
                )
            daily = np.nan
            if use is not None:
                daily = number_in(cells[use], table.header[use], numerals)
                if not 0.0 <= daily <= MAXIMUM_TIME:
                    raise InputError(
                        said("must not be negative"), field=table.header[use], value=cells[use]
                    )
        except InputError as error:
            raise table.placed(error, number) from None
        ages.append(age)
        counts.append(many)
        uses.append(daily)
        names.append("" if label_at is None else cells[label_at])
    if not ages:
        raise InputError(said("has no bearing in service"), source=source)
    read = {table.header[place] for place in (use, label_at) if place is not None}
    passed_over = tuple(title for title in header.passed_over if title not in read)
    label = unit or table.said.get("unit") or header.unit or "h"
    return FleetTable(
        np.array(ages),
        np.array(counts, dtype=np.int64),
        np.array(uses),
        tuple(names),
        label,
        failed,
        passed_over_notes(passed_over),
    )


def _place_of_names(header: tuple[str, ...]) -> int | None:
    """Place of the column that names the bearings, the nearest to a bearing first."""
    kinds = [column_by_name(folded_name(title_parts(title)[0])) for title in header]
    return next((kinds.index(kind) for kind in _NAMING if kind in kinds), None)
