"""What was measured again and again while bearings ran: clearance, noise and the like.

A record comes from a CSV file: a column of running times, one that names the bearing, and one for
each quantity, with their units in brackets; other columns are passed over. ``x`` stands for a
measurement that was off the scale or rejected, an empty cell for none. Tables are read as
`rolamento._tables` tells: any separator, either decimal mark.

    # title: Radial clearance of two bearings
    time (h),bearing,radial clearance (µm)
    0,9,27
    60,9,36
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento._tables import Numerals, parse_table, table_text
from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull._checks import one_of
from rolamento.weibull.life_test import LONGEST_LABEL, TextArray
from rolamento.weibull.reading import header_of, place_of, word_and_unit
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.clearance.wear import WearFit, WearLaw

PUBLISHED_TRENDS: Final = ("campanha_2008_clearance", "campanha_2008_anderon")
_HEAD: Final = re.compile(r"(.*?)\s*[\[(]([^\[\]()]{1,20})[\])]")
_BEARINGS: Final = (
    *("bearing", "bearings", "id", "specimen", "item", "serial", "machine", "position"),
    *("rolamento", "rolamentos", "identificacao", "peca", "amostra", "maquina", "posicao", "tag"),
)
_EXAMPLE: Final = "time (h),bearing,radial clearance (µm)"
_REJECTED: Final = ("x", "×")
_MAXIMUM_ROWS: Final = 10_000
_MAXIMUM_QUANTITIES: Final = 8
_MAXIMUM_BEARINGS: Final = 50


@dataclass(frozen=True, slots=True, eq=False)
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
        columns of its file that were not read: they have no unit
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
            "passed_over": list(self.passed_over),
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
    decimal_mark: str | None = None,
) -> Trend:
    """Read a record from a CSV file of 5 MB at most; ``"-"`` for standard input.

    Parameters
    ----------
    path
        Of the file.
    time, bearing
        Names of the columns that hold the running times and name the bearing, in place of the usual
        ones.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file shows whether 12.500 is 12.5.

    Raises
    ------
    FileError, InputError
        With the line, if the file cannot be read or is no such record.
    """
    return parse_trend(*table_text(path), time=time, bearing=bearing, decimal_mark=decimal_mark)


def published_trend(name: str, **columns: str | None) -> Trend:
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
    decimal_mark: str | None = None,
) -> Trend:
    """Read a record from the text of a CSV file.

    Parameters
    ----------
    text
        As described in the module.
    source
        What to call the text in messages.
    time, bearing, decimal_mark
        As of `read_trend`.

    Raises
    ------
    FileError, InputError
        If it is no such record.
    """
    table = parse_table(text, source, most_rows=_MAXIMUM_ROWS, example=_EXAMPLE)
    try:
        columns = _Columns.of(table.header, time, bearing)
    except InputError as error:
        raise table.placed(error) from None
    numerals = table.numerals((columns.time, *columns.places), decimal_mark)
    parsed = []
    for number, cells in enumerate(table.rows):
        try:
            parsed.append(columns.row(cells, numerals))
        except InputError as error:
            raise table.placed(error, number) from None
    times, bearings, values, rejected = zip(*parsed, strict=True)
    if len(set(bearings)) > _MAXIMUM_BEARINGS:
        raise InputError(
            said("has more than {most} bearings", most=_MAXIMUM_BEARINGS), source=source
        )
    return Trend(
        np.array(times),
        np.array(bearings, dtype=np.str_),
        columns.quantities,
        columns.units,
        np.array(values),
        np.array(rejected, dtype=np.bool_),
        columns.time_unit,
        table.said.get("title", ""),
        table.said.get("source", source),
        columns.passed_over,
    )


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


@dataclass(frozen=True, slots=True)
class _Columns:
    """Which cell holds what."""

    time: int
    bearing: int
    places: tuple[int, ...]
    quantities: tuple[str, ...]
    units: tuple[str, ...]
    time_unit: str
    passed_over: tuple[str, ...]

    @classmethod
    def of(cls, header: Sequence[str], time: str | None, bearing: str | None) -> _Columns:
        """Find the columns by the cells of the header."""
        heads = [_name_and_unit(cell) for cell in header]
        by_name = {"time": _place_of_time(header), "bearing": _place_of_bearing(header)}
        for column, title in (("time", time), ("bearing", bearing)):
            if title is not None:
                by_name[column] = place_of(header, title)
        first, name = by_name["time"], by_name["bearing"]
        if first is None or name is None or first == name:
            raise InputError(
                said("must have a column of times and one of bearings"),
                field="header",
                example=f'{_EXAMPLE}; or time="name of the column", bearing="name of the column"',
            )
        time_unit = heads[first][1] or word_and_unit(header[first])[1]
        others = [i for i in range(len(header)) if i not in (first, name)]
        places = tuple(i for i in others if heads[i][1])
        if not time_unit or not places:
            missing = header[first] if not time_unit else header[others[0]] if others else "header"
            rule = (
                said("needs its unit in brackets")
                if others
                else said("has no column of a quantity")
            )
            raise InputError(rule, field=missing, example=_EXAMPLE)
        if len(places) > _MAXIMUM_QUANTITIES:
            rule = said("must have 1 to {most} columns of quantities", most=_MAXIMUM_QUANTITIES)
            raise InputError(rule, field="header")
        return cls(
            first,
            name,
            places,
            tuple(heads[i][0] for i in places),
            tuple(heads[i][1] for i in places),
            time_unit,
            tuple(header[i] for i in others if i not in places and header[i]),
        )

    def row(
        self, cells: Sequence[str], numerals: Numerals
    ) -> tuple[float, str, list[float], list[bool]]:
        """Read one row: time, bearing, values, which of them were rejected."""
        name = cells[self.bearing]
        if not name or len(name) > LONGEST_LABEL or not name.isprintable():
            raise InputError(
                said("must be a name of at most {most} characters", most=LONGEST_LABEL),
                field="bearing",
                value=name,
            )
        time = _measured(cells[self.time], "time", numerals)
        if time < 0.0:
            raise InputError(said("must not be negative"), field="time", value=cells[self.time])
        rejected = [cells[place].casefold() in _REJECTED for place in self.places]
        values = [
            np.nan if bad or not cells[place] else _measured(cells[place], quantity, numerals)
            for place, bad, quantity in zip(self.places, rejected, self.quantities, strict=True)
        ]
        return time, name, values, rejected


def _place_of_time(header: Sequence[str]) -> int | None:
    """The first column that a life test would take for times."""
    for place, title in enumerate(header):
        try:
            if header_of([title], {}).places:
                return place
        except InputError:  # it is another column
            continue
    return None


def _place_of_bearing(header: Sequence[str]) -> int | None:
    names = [word_and_unit(title)[0] for title in header]
    return next((place for place, name in enumerate(names) if name in _BEARINGS), None)


def _name_and_unit(cell: str) -> tuple[str, str]:
    match = _HEAD.fullmatch(cell)
    name, unit = (match[1], match[2].strip()) if match else (cell, "")
    if len(name) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            said("must be a name of at most {most} characters", most=LONGEST_LABEL),
            field="header",
            value=cell,
        )
    return name, unit


def _measured(cell: str, field: str, numerals: Numerals) -> float:
    value = numerals.number(cell)
    if value is None or not isfinite(value):
        raise InputError(said("must be a number"), field=field, value=cell, example="36.5")
    return value
