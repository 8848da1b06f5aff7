"""How a table of text is laid out: separator, headings, units, where the numbers begin."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from rolamento.errors import FileError
from rolamento.vibration.reading._limits import MOST_CHANNELS
from rolamento.vibration.reading._metadata import label_parts, short_name, time_scale
from rolamento.vibration.reading._units import plain_unit

__all__ = ["CsvLayout", "layout_of"]

_NUMBER: Final = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf)", re.I)
_DATE: Final = re.compile(r"\d{1,4}[-/.:]\d{1,2}[-/.:]\d{1,4}[\dT :.,Z+-]*")
_PAIR: Final = re.compile(
    r"\W*([^\W\d][^:=;,\t]{0,60}?)\s*[:=;,\t]\s*([+-]?\d[\d.,eE+-]{0,30})\s*(?:hz|rpm|s)?[\s;,]*",
    re.I,
)
_SEPARATORS: Final = (";", "\t", "|", ",", None)
_ROWS_COMPARED: Final = 5


@dataclass(frozen=True, slots=True)
class CsvLayout:
    """Layout of a table.

    Attributes
    ----------
    separator
        between cells; None for blanks
    offset
        of the first row of numbers, bytes
    first_line
        its line, counted from 1
    names, units
        of the columns
    dates
        whether a column holds dates or nothing in the first row: it is no channel
    numbers
        that stand above the table by name, such as a sampling rate
    """

    separator: str | None
    offset: int
    first_line: int
    names: tuple[str, ...]
    units: tuple[str, ...]
    dates: tuple[bool, ...]
    numbers: dict[str, float]

    @property
    def decimal_comma(self) -> bool:
        """Whether a comma can only be a decimal one."""
        return self.separator != ","

    def time_column(self) -> tuple[int, float] | None:
        """Number of the column of times, and its unit in seconds; None if there is none."""
        for number, (name, unit) in enumerate(zip(self.names, self.units, strict=True)):
            scale = time_scale(name, unit)
            if scale is not None and not self.dates[number]:
                return number, scale
        return None


def layout_of(head: bytes, source: str) -> CsvLayout:
    """Return the layout of a table from its first lines.

    Raises
    ------
    FileError
        If no row of numbers is among them.
    """
    raw = head.split(b"\n")
    lines = [_text(line) for line in raw]
    number, separator = _first_row(lines, source)
    cells = _cells(lines[number], separator)
    above = [line.lstrip("#% ") for line in lines[:number] if line.strip()]
    if separator == "," and above and all(len(_cells(line, ",")) == 1 for line in above[-1:]):
        separator = ";"  # one heading over "0,25": a decimal comma
        cells = _cells(lines[number], separator)
    if len(cells) == 1:
        separator = ";"  # blanks in the heading of one column separate nothing
    if len(cells) > MOST_CHANNELS:
        rule = f"must be at most {MOST_CHANNELS}"
        raise FileError(rule, field="number of columns", value=len(cells), source=source)
    names, units = _headings(above, separator, len(cells))
    return CsvLayout(
        separator=separator,
        offset=sum(len(line) + 1 for line in raw[:number]),
        first_line=number + 1,
        names=names,
        units=units,
        dates=tuple(not _is_number(cell, separator) for cell in cells),
        numbers=_pairs(above),
    )


def _text(line: bytes) -> str:
    try:
        return line.decode("utf-8").removeprefix("\ufeff").rstrip("\r")
    except UnicodeDecodeError:
        return line.decode("cp1252", "replace").rstrip("\r")


def _first_row(lines: Sequence[str], source: str) -> tuple[int, str | None]:
    """Line with which a table of equally long rows of numbers begins, and its separator."""
    for number, line in enumerate(lines):
        for separator in _SEPARATORS:
            if (separator is not None and separator not in line) or not _is_row(line, separator):
                continue
            following = [row for row in lines[number + 1 : number + _ROWS_COMPARED] if row.strip()]
            width = len(_cells(line, separator))
            if all(_is_row(r, separator) and len(_cells(r, separator)) == width for r in following):
                return number, separator
    raise FileError(
        "has no table of numbers in its first lines",
        example="time (s);acc (g) over rows such as 0,0001;0,25",
        source=source,
    )


def _cells(line: str, separator: str | None) -> list[str]:
    cells = line.split() if separator is None else next(csv.reader([line], delimiter=separator), [])
    cells = [cell.strip().strip('"') for cell in cells]
    return cells[:-1] if len(cells) > 1 and not cells[-1] else cells


def _is_row(line: str, separator: str | None) -> bool:
    cells = _cells(line, separator)
    numbers = [_is_number(cell, separator) for cell in cells]
    others = (cell for cell, number in zip(cells, numbers, strict=True) if not number)
    return any(numbers) and all(not cell or _DATE.fullmatch(cell) for cell in others)


def _is_number(cell: str, separator: str | None) -> bool:
    text = cell if separator == "," else cell.replace(",", ".")
    return len(text) < 60 and _NUMBER.fullmatch(text) is not None


def _headings(
    above: Sequence[str], separator: str | None, width: int
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the columns, from the last one or two lines above the numbers."""
    rows = [_cells(line, separator) for line in above[-2:]]
    rows = [row for row in rows if len(row) == width]
    if not rows or _PAIR.fullmatch(above[-1]) or len(_cells(above[-1], separator)) != width:
        return ("",) * width, ("",) * width
    brackets = [cell.strip("[]() ") for cell in rows[-1]]
    if len(rows) == 2 and all(label_parts(f"x ({unit})")[1] for unit in brackets if unit):
        units = tuple(plain_unit(unit) for unit in brackets)
        return tuple(short_name(cell) for cell in rows[0]), units
    names, units = zip(*(label_parts(cell) for cell in rows[-1]), strict=True)
    return names, units


def _pairs(above: Sequence[str]) -> dict[str, float]:
    """Numbers given by name above the table."""
    found: dict[str, float] = {}
    for line in above[:100]:
        match = _PAIR.fullmatch(line[:200])
        if match and _NUMBER.fullmatch(text := match[2].rstrip(",").replace(",", ".")):
            found[match[1].strip()] = float(text)
    return found
