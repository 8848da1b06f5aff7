"""What was measured again and again while bearings ran: clearance, noise and the like.

A record comes from a CSV file: a column of running times or of dates, one that names the bearing or
the machine, which a record of a single one can do without, and one for each quantity: with its unit
in brackets, or under a usual name. A note names the columns that were passed over. ``x`` stands for
a measurement that was off the scale or rejected, an empty cell for none. Tables are read as
`rolamento.io.tables` reads them: any separator, either decimal mark; names and dates as
`rolamento.io.columns` and `rolamento.io.dates` read them. Dates may have a time of day, in the same
cell or in a column beside. Of the comments ``# title:``, ``# source:``, ``# dates: day first``.

    # title: Radial clearance of two bearings
    time (h),bearing,radial clearance (µm)
    0,9,27
    60,9,36
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import field
from datetime import datetime
from importlib import resources
from math import isfinite
from typing import TYPE_CHECKING, Any, Final, get_args

import numpy as np

from rolamento.errors import InputError, arguments, phrase
from rolamento.io.columns import (
    check_names,
    column_by_name,
    heads_table,
    place_of,
    title_parts,
    word_and_unit,
)
from rolamento.io.dates import (
    DateOrder,
    Dates,
    dates_of,
    days_between,
    is_time_of_day,
    moment_said,
)
from rolamento.io.numerals import DECIMAL_COMMA, Numerals
from rolamento.io.tables import Table, parse_table, table_text
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import one_of
from rolamento.weibull.life_test import LONGEST_LABEL, TextArray, passed_over_notes
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from rolamento.clearance.wear import WearFit, WearLaw

PUBLISHED_TRENDS: Final = ("campanha_2008_clearance", "campanha_2008_anderon")
_EXAMPLE: Final = "time (h),bearing,radial clearance (µm)"
_REJECTED: Final = ("x", "×")
_MAXIMUM_ROWS: Final = 10_000
_MAXIMUM_QUANTITIES: Final = 8
_MAXIMUM_BEARINGS: Final = 50
_BEARINGS: Final = ("bearing", "tag", "rig", "machine")
"""Columns that name what was measured, the nearest to a bearing first."""
_ORDER: Final = "dates"
_UNITS: Final = ("mm/s", "m/s²", "m/s2", "g", "µm", "μm", "um", "mm", "°C", "dB", "A", "gE")
"""Units of a quantity, where they stand behind its name without brackets."""


@frozen(eq=False)
class Trend:
    """Quantities of some bearings over their running time.

    Attributes
    ----------
    times, bearings
        (rows,) running time, and the bearing that was measured
    quantities, units
        names of the columns, and the unit of each
    values
        (rows, quantities); NaN where nothing was measured, or it was rejected
    rejected
        (rows, quantities) whether it was
    time_unit
        of the times
    title, source
        what the record is, and where it comes from
    passed_over
        columns of its file that were not read: they have neither a unit nor a usual name
    start
        moment from which the times count, as 2024-02-29 or 2024-02-29 08:00:00, if the file has
        dates; empty without
    dates
        how its dates were read
    """

    times: FloatArray
    bearings: TextArray
    quantities: tuple[str, ...]
    units: tuple[str, ...]
    values: FloatArray
    rejected: BoolArray
    time_unit: str
    title: str
    source: str
    passed_over: tuple[str, ...] = ()
    start: str = ""
    dates: Dates = field(default_factory=Dates)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What of their file was not read, and how dates were that could be read in two ways."""
        return (*self.dates.notes, *passed_over_notes(self.passed_over))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the bearings, in the order in which they appear."""
        return tuple(dict.fromkeys(str(name) for name in self.bearings))

    def of_bearing(self, name: str, quantity: int = 0) -> tuple[FloatArray, FloatArray]:
        """Times and values of one bearing, in the order of time, without gaps."""
        rows = (self.bearings == name) & np.isfinite(self.values[:, quantity])
        order = np.argsort(self.times[rows], kind="stable")
        return self.times[rows][order], self.values[rows, quantity][order]

    def to_mapping(self) -> dict[str, Any]:
        """Give the record as plain values; None where there is no number."""
        return {
            "title": self.title,
            "source": self.source,
            "time_unit": self.time_unit,
            "start": self.start or None,
            "passed_over": list(self.passed_over),
            "notes": [note.to_mapping() for note in self.notes],
            "quantities": [
                {"name": name, "unit": unit}
                for name, unit in zip(self.quantities, self.units, strict=True)
            ],
            "rows": [
                {
                    "time": float(time),
                    "bearing": str(bearing),
                    "values": [float(x) if isfinite(x) else None for x in row],
                    "rejected": [bool(x) for x in rejected],
                }
                for time, bearing, row, rejected in zip(
                    self.times, self.bearings, self.values, self.rejected, strict=True
                )
            ],
        }


def read_trend(
    path: str | os.PathLike[str],
    *,
    time: str | None = None,
    bearing: str | None = None,
    values: Sequence[str] = (),
    decimal_mark: str | None = None,
    date_order: str | None = None,
) -> Trend:
    """Read a record from a CSV file of 5 MB at most; ``"-"`` for standard input.

    Parameters
    ----------
    path
        Of the file.
    time, bearing
        Names of the columns that hold the running times or dates and name the bearing, in place of
        the usual ones.
    values
        Names of the columns of the quantities; if none is named, those with a unit in brackets, or
        else under a usual name.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file shows whether 12.500 is 12.5.
    date_order
        ``"day_first"`` or ``"month_first"``, where nothing shows what 03/04/2024 is.

    Raises
    ------
    FileError, InputError
        With the line, if the file cannot be read or is no such record.
    """
    return parse_trend(
        *table_text(path),
        time=time,
        bearing=bearing,
        values=values,
        decimal_mark=decimal_mark,
        date_order=date_order,
    )


def published_trend(name: str, **columns: Any) -> Trend:
    """Return a published record, one of `PUBLISHED_TRENDS`; columns as of `read_trend`."""
    return parse_trend(published_trend_text(name), f"{name}.csv", **columns)


def published_trend_text(name: str) -> str:
    """Return a published record as CSV, with its source in the comments."""
    one_of(name, "name", PUBLISHED_TRENDS)
    file = resources.files("rolamento") / "examples" / f"{name}.csv"
    return file.read_text(encoding="utf-8")


def parse_trend(
    text: str,
    source: str = "",
    *,
    time: str | None = None,
    bearing: str | None = None,
    values: Sequence[str] = (),
    decimal_mark: str | None = None,
    date_order: str | None = None,
) -> Trend:
    """Read a record from the text of a CSV file.

    Parameters
    ----------
    text
        As described in the module.
    source
        What to call the text in messages.
    time, bearing, values, decimal_mark, date_order
        As of `read_trend`.

    Raises
    ------
    FileError, InputError
        If it is no such record.
    """
    is_header = heads_table(*(name for name in (time, bearing, *values) if name))
    table = parse_table(
        text, source, most_rows=_MAXIMUM_ROWS, example=_EXAMPLE, is_header=is_header
    )
    try:
        check_names(table.header, _EXAMPLE)
        columns = _Columns.of(table, time, bearing, values)
    except InputError as error:
        raise table.placed(error) from None
    numerals = table.numerals(columns.of_numbers, decimal_mark)
    dates = _dates_of(table, columns, date_order)
    parsed = []
    for number, cells in enumerate(table.rows):
        try:
            parsed.append(columns.row(cells, numerals, dates))
        except InputError as error:
            raise table.placed(error, number) from None
    stamps, bearings, measured, rejected = zip(*parsed, strict=True)
    if len(set(bearings)) > _MAXIMUM_BEARINGS:
        raise InputError(
            said("has more than {most} bearings", most=_MAXIMUM_BEARINGS), source=source
        )
    start, times = "", stamps
    if columns.dated:
        try:
            times = tuple(days_between(stamps, columns.time_title))
        except InputError as error:
            raise error.with_details(source=source) from None
        start = moment_said(min(stamps))
    return Trend(
        np.array(times, dtype=np.float64),
        np.array(bearings, dtype=np.str_),
        columns.quantities,
        columns.units,
        np.array(measured),
        np.array(rejected, dtype=np.bool_),
        columns.time_unit,
        table.said.get("title", ""),
        table.said.get("source", source),
        columns.passed_over,
        start,
        dates,
    )


def _dates_of(table: Table, columns: _Columns, order: str | None) -> Dates:
    """How the dates are written; those that may be read in two ways are refused."""
    if not columns.dated:
        return Dates()
    cells = [row[columns.time] for row in table.rows]
    found = dates_of(
        cells,
        table.said.get(_ORDER) if order is None else order,
        title=table.header[columns.time],
        decimal_commas=table.separator != ","
        and any(DECIMAL_COMMA.fullmatch(row[i]) for row in table.rows for i in columns.places),
    )
    try:
        found.check(table.header[columns.time])
    except InputError as error:
        raise table.placed(error, cells.index(found.doubt)) from None
    return found


def wear_of_each(trend: Trend, law: WearLaw = "running_in") -> dict[str, WearFit]:
    """Fit a law of wear to the clearance of each bearing; SI, as of `fit_wear`.

    Raises
    ------
    InputError
        If the first quantity is no length, the times are no times, or there are too few.
    """
    from rolamento.clearance.wear import fit_wear
    from rolamento.units import to_si

    unit, time_unit = trend.units[0], trend.time_unit
    try:
        scale, second = to_si(f"1 {unit}", "length"), to_si(f"1 {time_unit}", "time")
    except InputError as error:
        raise error.with_details(field=trend.quantities[0]) from None
    fits = {}
    for name in trend.names:
        times, values = trend.of_bearing(name)
        fits[name] = fit_wear(second * times, scale * values, law)
    return fits


@frozen
class _Columns:
    """Which cell holds what; no bearing where all rows are of one."""

    time: int
    clock: int | None
    bearing: int | None
    places: tuple[int, ...]
    quantities: tuple[str, ...]
    units: tuple[str, ...]
    time_unit: str
    dated: bool
    time_title: str
    passed_over: tuple[str, ...]

    @property
    def of_numbers(self) -> tuple[int, ...]:
        """Places of the columns of numbers."""
        return self.places if self.dated else (self.time, *self.places)

    @classmethod
    def of(
        cls, table: Table, time: str | None, bearing: str | None, values: Sequence[str]
    ) -> _Columns:
        """Find the columns by the cells of the header, and dates by those of the first rows."""
        header = table.header
        heads = [_name_and_unit(cell) for cell in header]
        kinds = [column_by_name(word_and_unit(title)[0]) for title in header]
        first, clock = _places_of_time(
            table, kinds, None if time is None else place_of(header, time)
        )
        name = next((kinds.index(kind) for kind in _BEARINGS if kind in kinds), None)
        name = name if bearing is None else place_of(header, bearing)
        if first is None or first == name:
            raise InputError(
                said("must have a column of running times or dates"),
                field="header",
                example=phrase(
                    marked("{header}; or {argument}"),
                    header=_EXAMPLE,
                    argument=arguments(time="name of the column"),
                ),
            )
        dated = _holds_dates(table, first)
        time_unit = "d" if dated else heads[first][1] or word_and_unit(header[first])[1]
        others = [i for i in range(len(header)) if i not in (first, clock, name)]
        places = [place_of(header, value) for value in dict.fromkeys(values)]
        if not values:
            places = [i for i in others if heads[i][1]] or [
                i for i in others if kinds[i] == "value"
            ]
        _check_time_of_day(table, first)
        _check_quantities(header, first, time_unit, places, others)
        if name is None:
            _check_names_of_bearings(table, [i for i in others if i not in places], kinds)
        return cls(
            first,
            clock,
            name,
            tuple(places),
            tuple(heads[i][0] for i in places),
            tuple(heads[i][1] for i in places),
            time_unit,
            dated,
            header[first],
            tuple(header[i] for i in others if i not in places and header[i]),
        )

    def row(
        self, cells: Sequence[str], numerals: Numerals, dates: Dates
    ) -> tuple[Any, str, list[float], list[bool]]:
        """Read one row: time, bearing, values, which of them were rejected."""
        name = "" if self.bearing is None else cells[self.bearing]
        if (
            len(name) > LONGEST_LABEL
            or not name.isprintable()
            or (not name) != (self.bearing is None)
        ):
            raise InputError(
                said("must be a name of at most {most} characters", most=LONGEST_LABEL),
                field="bearing",
                value=name,
            )
        stamp = cells[self.time]
        if self.clock is not None and cells[self.clock]:
            stamp = f"{stamp} {cells[self.clock]}"
        time = self._time(stamp, numerals, dates)
        rejected = [cells[place].casefold() in _REJECTED for place in self.places]
        values = [
            np.nan if bad or not cells[place] else _measured(cells[place], quantity, numerals)
            for place, bad, quantity in zip(self.places, rejected, self.quantities, strict=True)
        ]
        return time, name, values, rejected

    def _time(self, cell: str, numerals: Numerals, dates: Dates) -> float | datetime:
        """A time in its unit, or a moment."""
        if self.dated:
            moment = dates.moment(cell)
            if moment is None:
                raise InputError(
                    said("must be a date, with or without a time of day"),
                    field=self.time_title,
                    value=cell,
                    example="2024-02-29 08:30",
                )
            return moment
        time = _measured(cell, self.time_title, numerals)
        if time < 0.0:
            raise InputError(said("must not be negative"), field=self.time_title, value=cell)
        return time


def _places_of_time(
    table: Table, kinds: Sequence[str | None], chosen: int | None
) -> tuple[int | None, int | None]:
    """The column of running times or dates, and that of times of day beside dates."""
    running = [i for i, kind in enumerate(kinds) if kind in ("time", "clock")]
    clock = next((i for i in running if is_time_of_day(_first_cell(table, i))), None)
    others = [i for i in running if i != clock and kinds[i] == "time"]
    dated = [i for i, kind in enumerate(kinds) if kind == "date"]
    first = chosen
    if first is None:
        first = next(iter((*others, *dated)), clock)
    is_day = first is not None and first != clock and _holds_dates(table, first)
    bare = is_day and first is not None and ":" not in _first_cell(table, first)
    return first, clock if bare else None


def _first_cell(table: Table, place: int) -> str:
    """The first cell of a column that has something in it."""
    return next((row[place] for row in table.rows if row[place]), "")


def _holds_dates(table: Table, place: int) -> bool:
    """Whether the first cell of a column that has one is a date."""
    filled = _first_cell(table, place)
    return any(Dates(order).moment(filled) is not None for order in get_args(DateOrder))


def _check_time_of_day(table: Table, place: int) -> None:
    """Refuse times of day without a column of dates: nobody knows their day."""
    cell = _first_cell(table, place)
    if is_time_of_day(cell):
        raise InputError(
            said("holds times of day; a column of dates is needed beside it"),
            field=table.header[place],
            value=cell,
            example="date,time,velocity (mm/s)",
        )


def _check_quantities(
    header: Sequence[str], time: int, time_unit: str, places: Sequence[int], others: Sequence[int]
) -> None:
    """Refuse a table without quantities, or whose times have no unit."""
    if not time_unit:
        raise InputError(said("needs its unit in brackets"), field=header[time], example=_EXAMPLE)
    if not places and others:
        raise InputError(
            said("needs its unit in brackets"),
            field=header[others[0]],
            example=phrase(
                marked("{header}; or {argument}"),
                header=_EXAMPLE,
                argument=arguments(values=[header[others[0]]]),
            ),
        )
    if not places:
        raise InputError(said("has no column of a quantity"), field="header", example=_EXAMPLE)
    if len(places) > _MAXIMUM_QUANTITIES:
        rule = said("must have 1 to {most} columns of quantities", most=_MAXIMUM_QUANTITIES)
        raise InputError(rule, field="header")


def _check_names_of_bearings(
    table: Table, unread: Sequence[int], kinds: Sequence[str | None]
) -> None:
    """Refuse a record of a single bearing in which an unread column may name several."""
    for place in unread:
        cells = [row[place] for row in table.rows]
        words = [cell for cell in cells if cell and Numerals(commas=True).number(cell) is None]
        if words and kinds[place] not in ("remark", "mode", "date"):
            raise InputError(
                said("may name what was measured; choose it as the bearing, or leave it out"),
                field=table.header[place],
                value=words[0],
                example=arguments(bearing=table.header[place]),
            )


def _name_and_unit(cell: str) -> tuple[str, str]:
    """Name of a column and its unit, in brackets or behind the name: "velocidade mm/s"."""
    name, unit = title_parts(cell)
    if len(name) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            said("must be a name of at most {most} characters", most=LONGEST_LABEL),
            field="header",
            value=cell,
        )
    tail = name.replace("_", " ").rpartition(" ")[2]
    if not unit and tail in _UNITS and tail != name:
        return name[: -len(tail) - 1], tail
    return name, unit


def _measured(cell: str, field: str, numerals: Numerals) -> float:
    value = numerals.number(cell)
    if value is None or not isfinite(value):
        raise InputError(said("must be a number"), field=field, value=cell, example="36.5")
    return value
