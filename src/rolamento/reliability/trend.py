"""What was measured again and again while bearings ran: clearance, noise and the like.

A record comes from a CSV file: a column of running times, one that names the bearing, and one for
each quantity, all with their units in brackets. ``x`` stands for a measurement that was off the
scale or rejected, an empty cell for none.

    # title: Radial clearance of two bearings
    time (h),bearing,radial clearance (µm)
    0,9,27
    60,9,36
"""

from __future__ import annotations

import csv
import os
import re
from dataclasses import dataclass
from importlib import resources
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento._reading import read_text
from rolamento.clearance.wear import WearFit, WearLaw, fit_wear
from rolamento.errors import FileError, InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.reliability._checks import one_of
from rolamento.reliability._columns import LONGEST_LABEL, TextArray

__all__ = [
    "PUBLISHED_TRENDS",
    "Trend",
    "parse_trend",
    "published_trend",
    "published_trend_text",
    "read_trend",
    "wear_of_each",
]

PUBLISHED_TRENDS: Final = ("campanha_2008_clearance", "campanha_2008_anderon")
_HEAD: Final = re.compile(r"(.*?)\s*[\[(]([^\[\]()]{1,20})[\])]")
_NUMBER: Final = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,3})?")
_TIMES: Final = ("time", "tempo", "running time", "hours", "horas")
_BEARINGS: Final = ("bearing", "rolamento", "id")
_REJECTED: Final = ("x", "×")
_MOST_ROWS: Final = 10_000
_MOST_QUANTITIES: Final = 8
_MOST_BEARINGS: Final = 50
_LONGEST_LINE: Final = 2000


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


def read_trend(path: str | os.PathLike[str]) -> Trend:
    """Read a record from a CSV file of 1 MB at most; ``"-"`` for standard input.

    Raises
    ------
    FileError, InputError
        With the line, if the file cannot be read or is no such record.
    """
    return parse_trend(*read_text(path))


def published_trend(name: str) -> Trend:
    """Return a published record, one of `PUBLISHED_TRENDS`."""
    return parse_trend(published_trend_text(name), f"{name}.csv")


def published_trend_text(name: str) -> str:
    """Return a published record as CSV, with its source in the comments."""
    one_of(name, "name", PUBLISHED_TRENDS)
    file = resources.files("rolamento") / "examples" / f"{name}.csv"
    return file.read_text(encoding="utf-8")


def parse_trend(text: str, source: str = "") -> Trend:
    """Read a record from the text of a CSV file.

    Raises
    ------
    FileError, InputError
        If it is no such record.
    """
    said: dict[str, str] = {}
    rows: list[tuple[int, list[str]]] = []
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("#"):
            key, _, value = line.lstrip("# ").partition(":")
            said.setdefault(key.strip().casefold(), value.strip())
        elif line.strip():
            rows.append((number, _cells(line, source, number)))
        if len(rows) > _MOST_ROWS + 1:
            raise FileError(f"holds more than {_MOST_ROWS} rows", source=source)
    if len(rows) < 2:
        raise FileError(
            "holds no table", source=source, example="time (h),bearing,radial clearance (µm)"
        )
    place = rows[0][0]
    parsed = []
    try:
        columns = _Columns.of(rows[0][1])
        for number, cells in rows[1:]:
            place = number
            parsed.append(columns.row(cells))
    except InputError as error:
        raise error.with_details(source=source, line=place) from None
    times, bearings, values, rejected = zip(*parsed, strict=True)
    if len(set(bearings)) > _MOST_BEARINGS:
        raise InputError(f"has more than {_MOST_BEARINGS} bearings", source=source)
    return Trend(
        np.array(times),
        np.array(bearings, dtype=np.str_),
        columns.quantities,
        columns.units,
        np.array(values),
        np.array(rejected, dtype=np.bool_),
        columns.time_unit,
        said.get("title", ""),
        said.get("source", source),
    )


def wear_of_each(trend: Trend, law: WearLaw = "running_in") -> dict[str, WearFit]:
    """Fit a law of wear to the clearance of each bearing; SI, as of `fit_wear`.

    Raises
    ------
    InputError
        If the first quantity is no length, the times are no times, or there are too few.
    """
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

    @classmethod
    def of(cls, header: list[str]) -> _Columns:
        """Find the columns by the cells of the header."""
        heads = [_head(cell) for cell in header]
        names = [name.casefold() for name, _ in heads]
        time = next((i for i, name in enumerate(names) if name in _TIMES), None)
        bearing = next((i for i, name in enumerate(names) if name in _BEARINGS), None)
        if time is None or bearing is None:
            raise InputError(
                "must have a column of times and one of bearings",
                field="header",
                example="time (h),bearing,radial clearance (µm)",
            )
        places = tuple(i for i in range(len(header)) if i not in (time, bearing))
        if not 1 <= len(places) <= _MOST_QUANTITIES:
            raise InputError(
                f"must have 1 to {_MOST_QUANTITIES} columns of quantities", field="header"
            )
        missing = [header[i] for i in (time, *places) if not heads[i][1]]
        if missing:
            raise InputError(
                "needs its unit in brackets",
                field=missing[0],
                example="time (h),bearing,radial clearance (µm)",
            )
        return cls(
            time,
            bearing,
            places,
            tuple(heads[i][0] for i in places),
            tuple(heads[i][1] for i in places),
            heads[time][1],
        )

    def row(self, cells: list[str]) -> tuple[float, str, list[float], list[bool]]:
        """Read one row: time, bearing, values, which of them were rejected."""
        if len(cells) != len(self.places) + 2:
            raise FileError(f"has {len(cells)} cells where the header has {len(self.places) + 2}")
        name = cells[self.bearing]
        if not name or len(name) > LONGEST_LABEL or not name.isprintable():
            raise InputError(
                f"must be a name of {LONGEST_LABEL} characters at most", field="bearing", value=name
            )
        time = _number(cells[self.time], "time")
        if time < 0.0:
            raise InputError("must not be negative", field="time", value=cells[self.time])
        rejected = [cells[place].casefold() in _REJECTED for place in self.places]
        values = [
            np.nan if bad or not cells[place] else _number(cells[place], quantity)
            for place, bad, quantity in zip(self.places, rejected, self.quantities, strict=True)
        ]
        return time, name, values, rejected


def _head(cell: str) -> tuple[str, str]:
    match = _HEAD.fullmatch(cell)
    name, unit = (match[1], match[2].strip()) if match else (cell, "")
    if len(name) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            f"must be a name of {LONGEST_LABEL} characters at most", field="header", value=cell
        )
    return name, unit


def _number(cell: str, field: str) -> float:
    if len(cell) > LONGEST_LABEL or not _NUMBER.fullmatch(cell) or not isfinite(float(cell)):
        raise InputError("must be a number", field=field, value=cell, example="36.5")
    return float(cell)


def _cells(line: str, source: str, number: int) -> list[str]:
    if len(line) > _LONGEST_LINE:
        raise FileError(f"is longer than {_LONGEST_LINE} characters", source=source, line=number)
    try:
        return [cell.strip() for cell in next(csv.reader([line], strict=True))]
    except (csv.Error, StopIteration):
        raise FileError("is not a line of a CSV table", source=source, line=number) from None
