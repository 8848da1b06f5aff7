"""How a table of text is laid out: separator, headings, units, where the numbers begin."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from rolamento._tables import DecimalMark, Numerals, checked_mark, mark_said, numerals_of
from rolamento.errors import FileError, InputError
from rolamento.vibration.reading._limits import MOST_CHANNELS
from rolamento.vibration.reading._metadata import label_parts, short_name, time_scale
from rolamento.vibration.reading._units import plain_unit

__all__ = ["CsvLayout", "layout_of"]

_NUMBER: Final = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf)", re.I)
_DATE: Final = re.compile(r"\d{1,4}[-/.:]\d{1,2}[-/.:]\d{1,4}[\dT :.,Z+-]*")
_PAIR: Final = re.compile(
    r"\W*([^\W\d][^:=;,\t]{0,60}?)\s*[:=;,\t]\s*([+-]?\d[\d.,eE+-]{0,30})\s*(k?hz|rpm|s)?[\s;,]*",
    re.I,
)
_GROUPED: Final = {
    "comma": re.compile(rb"(?<![\d.,])[1-9]\d{0,2}(?:\.\d{3})+(?![\d.])"),
    "point": re.compile(rb"(?<![\d.,])[1-9]\d{0,2}(?:,\d{3})+(?![\d,])"),
}
"""Whole numbers whose thousands are parted, by the decimal mark."""
_WRONG: Final = "·".encode("latin-1")
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
        that stand above the table by name, such as a sampling rate; in Hz where they are in kHz
    number_units
        of those that have one: Hz or rpm
    two_ways
        what a number above the table is with a decimal point, and with a decimal comma, by name and
        text, if nothing tells which
    numerals
        how the numbers of the table are written
    """

    separator: str | None
    offset: int
    first_line: int
    names: tuple[str, ...]
    units: tuple[str, ...]
    dates: tuple[bool, ...]
    numbers: dict[str, float]
    number_units: dict[str, str]
    two_ways: dict[str, tuple[str, float, float]]
    numerals: Numerals

    def plain(self, content: bytes) -> bytes:
        """Return rows whose numbers have decimal points and no marks between thousands."""
        if not self.numerals.commas:
            return content
        if self.numerals.mark is not None:
            other, mark = (b".", b",") if self.numerals.mark == "comma" else (b",", b".")
            grouped = _GROUPED[self.numerals.mark]
            content = grouped.sub(lambda match: match[0].replace(other, b""), content)
            # what is left parts no thousands: a number that it stands in is none
            content = content.replace(other, _WRONG).replace(mark, b".")
            return content
        return content.replace(b",", b".")

    def time_column(self) -> tuple[int, float] | None:
        """Number of the column of times, and its unit in seconds; None if there is none."""
        for number, (name, unit) in enumerate(zip(self.names, self.units, strict=True)):
            scale = time_scale(name, unit)
            if scale is not None and not self.dates[number]:
                return number, scale
        return None


def layout_of(head: bytes, source: str, mark: DecimalMark | None = None) -> CsvLayout:
    """Return the layout of a table from its first lines.

    mark: the decimal one, if it is given.

    Raises
    ------
    FileError
        If no row of numbers is among them.
    InputError
        If nothing tells whether their points are decimal marks.
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
    dates = tuple(not _is_number(cell, separator) for cell in cells)
    rows = [_cells(line, separator) for line in lines[number:]]
    said = next((found for found in map(mark_said, above) if found is not None), None)
    if mark is None and said is not None:
        mark = checked_mark(said, source)
    numerals = numerals_of(
        (cell for row in rows for cell, date in zip(row, dates, strict=False) if not date),
        commas=separator != ",",
        mark=mark,
    )
    try:
        numerals.check(next((name for name in names if name), "table"))
    except InputError as error:
        raise error.with_details(source=source) from None
    comma = numerals.mark == "comma" or (
        numerals.commas and mark is None and any("," in cell for row in rows for cell in row)
    )
    numbers, number_units, two_ways = _pairs(above, "comma" if comma else mark)
    return CsvLayout(
        separator=separator,
        offset=sum(len(line) + 1 for line in raw[:number]),
        first_line=number + 1,
        names=names,
        units=units,
        dates=dates,
        numbers=numbers,
        number_units=number_units,
        two_ways=two_ways,
        numerals=numerals,
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
    if len(text) >= 60:
        return False
    if _NUMBER.fullmatch(text):
        return True
    return separator != "," and numerals_of([cell], commas=True).number(cell) is not None


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


def _pairs(
    above: Sequence[str], mark: DecimalMark | None
) -> tuple[dict[str, float], dict[str, str], dict[str, tuple[str, float, float]]]:
    """Numbers given by name above the table, units of some, and those that nobody can be sure of.

    mark: the decimal one, if the table or the user tells it.
    """
    found: dict[str, float] = {}
    units: dict[str, str] = {}
    two_ways: dict[str, tuple[str, float, float]] = {}
    for line in above[:100]:
        match = _PAIR.fullmatch(line[:200])
        if not match:
            continue
        name, text, unit = match[1].strip(), match[2].rstrip(","), (match[3] or "").lower()
        numerals = numerals_of([text], commas=True, mark=mark)
        value = numerals.number(text)
        scale = 1e3 if unit == "khz" else 1.0
        if value is None:
            continue
        if numerals.doubt and unit != "khz":
            point, comma = numerals.readings()
            two_ways[name] = (text, point, comma)
        else:
            found[name] = scale * value
        if unit in ("hz", "khz", "rpm"):
            units[name] = unit.removeprefix("k")
    return found, units, two_ways
