"""Tables of text: CSV with any of the usual separators, decimal points or commas, in blocks."""

from __future__ import annotations

import csv
import io
import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np

from rolamento.errors import FileError, InputError
from rolamento.io.foreign.bounds import guarded, size_of_file
from rolamento.io.tables import DecimalMark, Numerals, checked_mark, mark_said, numerals_of
from rolamento.numerics import FloatArray
from rolamento.vibration.reading.channels import MOST_CHANNELS, Channel, Source, checked_channels
from rolamento.vibration.reading.metadata import (
    RateClaim,
    RateClaims,
    Timeline,
    TwoWays,
    label_parts,
    rate_of,
    rates_among,
    short_name,
    speed_among,
    time_scale,
)
from rolamento.vibration.reading.units import plain_unit, quantity_of_unit
from rolamento.words import marked, said

__all__ = ["CsvSource"]

_LARGEST: Final = 16 * 2**30
_HEAD: Final = 64 * 2**10
_LONGEST_LINE: Final = 64 * 2**10
_PIECE: Final = 4 * 2**20
_MOST_AT_ONCE: Final = 65_536
_MARKS: Final = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}


class CsvSource(Source):
    """An open table of text.

    The file is run through once for the places of its rows; numbers are read as they are needed.
    """

    def __init__(self, path: Path, mark: DecimalMark | None = None) -> None:
        self._source = str(path)
        size = size_of_file(path)
        if size > _LARGEST:
            limit = said(
                "a text table is read up to {most} GB; store it as Parquet",
                most=_LARGEST // 2**30,
            )
            raise FileError(limit, source=self._source)
        self._file = path.open("rb")
        try:
            with guarded(self._source, marked("table")):
                head = _head(self._file, size, self._source)
                self._layout = layout_of(head, self._source, mark)
                self._rows = _Rows(self._file, self._layout.offset, self._source)
                self._timeline = self._times()
                self._columns = self._columns_of_channels()
                self.numbers = self._layout.numbers
                channels = [self._channel(number) for number in self._columns]
            self.channels = checked_channels(channels, self._source, marked("table"))
        except BaseException:
            self._file.close()
            raise

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels; the times beside them are checked."""
        columns = [self._columns[channel] for channel in channels]
        if self._timeline is not None:
            columns.append(self._timeline[0])
        samples = np.empty((len(channels), count))
        step = min(_MOST_AT_ONCE, max(1, _PIECE // self._rows.longest))
        for first in range(0, count, step):
            number = min(step, count - first)
            with guarded(self._source, marked("table")):
                block = self._block(start + first, number, columns)
            if self._timeline is not None:
                self._timeline[1].check(block[:, -1], start + first, self._source)
            samples[:, first : first + number] = block.T[: len(channels)]
        return samples

    def close(self) -> None:
        """Let go of the file."""
        self._file.close()

    def _times(self) -> tuple[int, Timeline] | None:
        found = self._layout.time_column()
        if found is None:
            return None
        column, scale = found
        count = self._rows.count
        first, last = (self._block(row, 1, [column])[0, 0] for row in (0, count - 1))
        return column, Timeline.between(float(first), float(last), count, scale, self._source)

    def _columns_of_channels(self) -> list[int]:
        time = None if self._timeline is None else self._timeline[0]
        columns = range(len(self._layout.names))
        return [n for n in columns if n != time and not self._layout.dates[n]]

    def _channel(self, number: int) -> Channel:
        layout = self._layout
        times = None if self._timeline is None else self._timeline[1].rate
        rate = rate_of(_claims(layout, times), times)
        named = {
            f"{name} {layout.number_units.get(name, '')}": value
            for name, value in layout.numbers.items()
        }
        unit = layout.units[number]
        return Channel(
            layout.names[number],
            self._rows.count,
            rate.value,
            unit,
            quantity_of_unit(unit),
            speed_among(named),
            rate.doubt,
            rate.aside,
            rate.two_ways,
        )

    def _block(self, start: int, count: int, columns: list[int]) -> FloatArray:
        """Rows of some columns; (rows, columns)."""
        layout = self._layout
        line = layout.first_line + start
        content = self._rows.take(start, count)
        content = layout.plain(content)
        if not content.strip():
            raise FileError(said("is blank within the table"), source=self._source, line=line)
        try:
            block = np.loadtxt(
                io.StringIO(content.decode("latin-1")),
                delimiter=layout.separator,
                usecols=columns,
                comments=None,
                quotechar='"',
                ndmin=2,
            )
        except ValueError as error:
            raise _cell_error(error, layout, line, self._source) from None
        if len(block) != count:
            rule = said("has blank or joined lines among the next {count}", count=count)
            raise FileError(rule, source=self._source, line=line)
        return np.asarray(block)


def _claims(layout: CsvLayout, times: float | None) -> RateClaims:
    """Sampling rates above the table; of one that is two, that which the times bear out."""
    found = rates_among([layout.numbers])
    doubtful: list[RateClaim] = []
    two_ways = None
    for line in layout.two_ways:
        for value in Numerals(commas=True, doubt=line.text).readings():
            claims = rates_among([{line.name: value}])
            if times is not None and rate_of(claims, times).value is not None:
                doubtful, two_ways = [*claims.clear], None
                break
            for claim in (*claims.clear, *claims.loose):
                doubtful.append(RateClaim(f'"{line.name}: {line.text}"', claim.value))
                two_ways = line
    return RateClaims((*found.clear, *doubtful), found.loose, two_ways)


class _Rows:
    """Places of the rows of a table in its file."""

    def __init__(self, file: BinaryIO, offset: int, source: str) -> None:
        self._file = file
        self._places = [(0, offset)]
        self._after = (0, offset)
        self.longest = 1
        self.count = 0
        file.seek(offset)
        place = last_end = offset
        ends = 0
        while content := file.read(_PIECE):
            if b"\0" in content:
                raise FileError(said("is a binary file, not a text table"), source=source)
            line_ends = np.flatnonzero(np.frombuffer(content, np.uint8) == 10) + place
            if len(line_ends):
                gaps = np.diff(line_ends, prepend=last_end)
                self.longest = max(self.longest, int(np.max(gaps)))
                last_end = int(line_ends[-1])
                self._places.append((ends + len(line_ends), last_end + 1))
            filled = content.rstrip()
            if filled:
                self.count = ends + filled.count(b"\n") + 1
            ends += len(line_ends)
            place += len(content)
            self.longest = max(self.longest, place - last_end)
            if self.longest > _LONGEST_LINE and place - last_end > _LONGEST_LINE:
                break
        if self.longest > _LONGEST_LINE:
            limit = _LONGEST_LINE // 2**10
            raise FileError(said("has a line of more than {limit} kB", limit=limit), source=source)

    def take(self, start: int, count: int) -> bytes:
        """Lines of `count` rows from `start` on."""
        row, place = self._places[bisect_right(self._places, (start, 2**63)) - 1]
        if row <= self._after[0] <= start:
            row, place = self._after
        self._file.seek(place)
        for _ in islice(self._file, start - row):
            pass
        content = b"".join(islice(self._file, count))
        self._after = (start + count, self._file.tell())
        return content


def _head(file: BinaryIO, size: int, source: str) -> bytes:
    """Whole lines from the beginning of the file."""
    head = file.read(_HEAD)
    wrong = _MARKS.get(head[:2])
    if wrong:
        raise FileError(said("is {encoding} text; save it as UTF-8", encoding=wrong), source=source)
    if b"\0" in head:
        raise FileError(said("is a binary file, not a text table"), source=source)
    if size > len(head):
        head = head[: head.rfind(b"\n") + 1]
    return head


def _cell_error(error: ValueError, layout: CsvLayout, line: int, source: str) -> FileError:
    """Which cell is no number."""
    text = str(error)
    row = re.search(r"at row (\d+)", text)
    column = re.search(r"column (?:index )?(\d+)", text)
    given = re.search(r"string '([^']{0,40})", text)
    rule = said("is not a number") if given else said("has fewer columns than the first row")
    # NumPy counts columns from 1 and rows from 0 in the one complaint, and the reverse in the other
    number = (int(column[1]) if column else 0) + (0 if given else 1)
    below = (int(row[1]) if row else 0) - (0 if given or not row else 1)
    name = layout.names[number - 1] if 0 < number <= len(layout.names) else ""
    failure = FileError(
        rule,
        field=f'column {number} "{name}"' if name else f"column {number}",
        line=line + below,
        source=source,
    )
    return failure.with_details(value=given[1]) if given else failure


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
        lines above the table whose number nothing shows how to read
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
    two_ways: tuple[TwoWays, ...]
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
        If nothing shows whether their points are decimal marks.
    """
    raw = head.split(b"\n")
    lines = [_text(line) for line in raw]
    number, separator = _first_row(lines, source)
    cells = _cells_of(lines[number], separator)
    above = [line.lstrip("#% ") for line in lines[:number] if line.strip()]
    if separator == "," and above and all(len(_cells_of(line, ",")) == 1 for line in above[-1:]):
        separator = ";"  # one heading over "0,25": a decimal comma
        cells = _cells_of(lines[number], separator)
    if len(cells) == 1:
        separator = ";"  # blanks in the heading of one column separate nothing
    if len(cells) > MOST_CHANNELS:
        rule = said("must be at most {most}", most=MOST_CHANNELS)
        raise FileError(rule, field=marked("number of columns"), value=len(cells), source=source)
    names, units = _headings(above, separator, len(cells))
    dates = tuple(not _is_number(cell, separator) for cell in cells)
    rows = [_cells_of(line, separator) for line in lines[number:]]
    given = next((found for found in map(mark_said, above) if found is not None), None)
    if mark is None and given is not None:
        mark = checked_mark(given, source)
    numerals = numerals_of(
        (cell for row in rows for cell, date in zip(row, dates, strict=False) if not date),
        commas=separator != ",",
        mark=mark,
    )
    try:
        numerals.check(next((name for name in names if name), marked("table")))
    except InputError as error:
        raise error.with_details(source=source) from None
    comma = numerals.mark == "comma" or (
        numerals.commas and mark is None and any("," in cell for row in rows for cell in row)
    )
    numbers, number_units, two_ways = _pairs(lines[:number], "comma" if comma else mark)
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
            width = len(_cells_of(line, separator))
            if all(
                _is_row(r, separator) and len(_cells_of(r, separator)) == width for r in following
            ):
                return number, separator
    raise FileError(
        said("has no table of numbers in its first lines"),
        example=said("time (s);acc (g) over rows such as 0,0001;0,25"),
        source=source,
    )


def _cells_of(line: str, separator: str | None) -> list[str]:
    cells = line.split() if separator is None else next(csv.reader([line], delimiter=separator), [])
    cells = [cell.strip().strip('"') for cell in cells]
    return cells[:-1] if len(cells) > 1 and not cells[-1] else cells


def _is_row(line: str, separator: str | None, width: int | None = None) -> bool:
    cells = _cells_of(line, separator)
    if width not in (None, len(cells)):
        return False
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
    rows = [_cells_of(line, separator) for line in above[-2:]]
    rows = [row for row in rows if len(row) == width]
    if not rows or _PAIR.fullmatch(above[-1]) or len(_cells_of(above[-1], separator)) != width:
        return ("",) * width, ("",) * width
    brackets = [cell.strip("[]() ") for cell in rows[-1]]
    if len(rows) == 2 and all(label_parts(f"x ({unit})")[1] for unit in brackets if unit):
        units = tuple(plain_unit(unit) for unit in brackets)
        return tuple(short_name(cell) for cell in rows[0]), units
    names, units = zip(*(label_parts(cell) for cell in rows[-1]), strict=True)
    return names, units


def _pairs(
    above: Sequence[str], mark: DecimalMark | None
) -> tuple[dict[str, float], dict[str, str], tuple[TwoWays, ...]]:
    """Numbers given by name above the table, units of some, and those that nobody can be sure of.

    mark: the decimal one, if the table or the user gives it.
    """
    found: dict[str, float] = {}
    units: dict[str, str] = {}
    two_ways: list[TwoWays] = []
    for number, line in enumerate(above[:200], start=1):
        match = _PAIR.fullmatch(line.lstrip("#% ")[:200])
        if not match:
            continue
        name, text, unit = match[1].strip(), match[2].rstrip(","), (match[3] or "").lower()
        numerals = numerals_of([text], commas=True, mark=mark)
        value = numerals.number(text)
        scale = 1e3 if unit == "khz" else 1.0
        if value is None:
            continue
        if numerals.doubt and unit != "khz":
            two_ways.append(TwoWays(name, text, number))
        else:
            found[name] = scale * value
        if unit in ("hz", "khz", "rpm"):
            units[name] = unit.removeprefix("k")
    return found, units, tuple(two_ways)
