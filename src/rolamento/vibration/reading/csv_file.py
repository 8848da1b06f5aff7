"""Tables of text: CSV with any of the usual separators, decimal points or commas, in blocks.

What recorders write above their numbers is read: sampling rate or interval, units and names, in the
forms of LabVIEW, catman, DEWESoft, Simcenter, PicoScope, Tektronix and spreadsheets.
"""

from __future__ import annotations

import csv
import io
import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Final, get_args

import numpy as np

from rolamento.errors import FileError, InputError, arguments, phrase
from rolamento.io.columns import NAMES, folded_name, is_unit_word
from rolamento.io.dates import DateOrder, Dates, dates_of, is_time_of_day
from rolamento.io.foreign.bounds import check_whole, guarded, size_of_file
from rolamento.io.numerals import DecimalMark, Numerals, checked_mark, numerals_of
from rolamento.io.tables import decoded, encoding_of, mark_said, separator_said
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.reading.channels import MOST_CHANNELS, Channel, Source, checked_channels
from rolamento.vibration.reading.metadata import (
    RateClaim,
    RateClaims,
    Timeline,
    TwoWays,
    is_rate_or_step,
    is_unit_name,
    label_parts,
    rate_of,
    rates_among,
    short_name,
    speed_among,
    time_scale,
    time_scale_perhaps,
)
from rolamento.vibration.reading.units import is_unit, plain_unit, quantity_of_unit
from rolamento.words import marked, said

__all__ = ["CsvSource"]

_LARGEST: Final = 16 * 2**30
_HEAD: Final = 64 * 2**10
_LONGEST_LINE: Final = 64 * 2**10
_PIECE: Final = 4 * 2**20
_MOST_AT_ONCE: Final = 65_536


class CsvSource(Source):
    """An open table of text.

    The file is run through once for the places of its rows; numbers are read as they are needed.

    Parameters
    ----------
    path
        Of the file.
    mark
        The decimal one, if it is given.
    content
        Its text as UTF-8, where the file holds it in another form, as a workbook does.
    """

    def __init__(
        self, path: Path, mark: DecimalMark | None = None, content: bytes | None = None
    ) -> None:
        self._source = str(path)
        size = size_of_file(path) if content is None else len(content)
        if size > _LARGEST:
            limit = said(
                "a text table is read up to {most} GB; store it as Parquet",
                most=_LARGEST // 2**30,
            )
            raise FileError(limit, source=self._source)
        self._file: BinaryIO
        if content is None and (wide := _wide_text(path, size)) is not None:
            size, content = len(wide), wide
        self._file = path.open("rb") if content is None else io.BytesIO(content)
        try:
            with guarded(self._source, marked("table")):
                head = _head(self._file, size, self._source)
                self._layout = layout_of(head, self._source, mark)
                self._rows = _Rows(self._file, self._layout.offset, self._source)
                self._timeline = self._times()
                self._stamped_rate = None if self._timeline else self._rate_of_stamps()
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
        count = self._rows.count
        found = self._layout.time_column() or self._times_perhaps()
        if found is None:
            return None
        column, scale = found
        first, last = (self._block(row, 1, [column])[0, 0] for row in (0, count - 1))
        return column, Timeline.between(float(first), float(last), count, scale, self._source)

    def _times_perhaps(self) -> tuple[int, float] | None:
        """The first column of which name or unit may be those of times, if it rises evenly."""
        count = self._rows.count
        rate = rate_of(_claims(self._layout, None)).value
        for column, scale in self._layout.columns_of_times_perhaps(rate):
            block = self._block(0, min(count, _ROWS_OF_TIMES), [column])[:, 0]
            with np.errstate(all="ignore"):
                steps = np.diff(block)
                even = len(steps) > 1 and steps.min() > 0.0 and steps.max() < 2.0 * steps.min()
                if even and not self._layout.names[column] and rate is not None:
                    even = bool(abs(float(steps.mean()) * rate - 1.0) < _SAME_STEP)
            if even:
                return column, scale
        return None

    def _rate_of_stamps(self) -> float | None:
        """Rate by the moments beside the samples, Hz; None if there are none, or not evenly."""
        places = [n for n, date in enumerate(self._layout.dates) if date]
        count = self._rows.count
        if not places or count < _ROWS_COMPARED:
            return None
        content = self._rows.take(0, _ROWS_COMPARED) + self._rows.take(count - 1, 1)
        lines = content.decode("utf-8", "replace").splitlines()
        rows = [_cells_of(line, self._layout.separator) for line in lines]
        seconds = _seconds_of_stamps(rows, places)
        if seconds is None:
            return None
        steps = np.diff(seconds[:-1])
        mean = (seconds[-1] - seconds[0]) / (count - 1)
        even = mean > 0.0 and bool(np.all(np.abs(steps / mean - 1.0) < _STAMPS_OFF))
        return 1.0 / mean if even else None

    def _columns_of_channels(self) -> list[int]:
        time = None if self._timeline is None else self._timeline[0]
        columns = range(len(self._layout.names))
        return [n for n in columns if n != time and not self._layout.dates[n]]

    def _channel(self, number: int) -> Channel:
        layout = self._layout
        times = self._stamped_rate if self._timeline is None else self._timeline[1].rate
        rate = rate_of(_claims(layout, times), times)
        named = {
            f"{name} {layout.number_units.get(name, '')}": value
            for name, value in layout.numbers.items()
        }
        alone = sum(not layout.units[column] for column in self._columns) == 1
        unit = layout.units[number] or (layout.unit if alone else "")
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


def _seconds_of_stamps(rows: Sequence[Sequence[str]], places: Sequence[int]) -> FloatArray | None:
    """Seconds from the first row to each, by cells with days, times of day, or both."""
    texts = [" ".join(row[n] for n in places if n < len(row)).strip() for row in rows]
    if all(is_time_of_day(text) for text in texts):
        texts = [f"2000-01-01 {text}" for text in texts]
    dates = dates_of(texts)
    order = dates.order or (get_args(DateOrder)[0] if dates.doubt else None)  # a step is the same
    moments = [Dates(order).moment(text) for text in texts]
    known = [moment for moment in moments if moment is not None]
    if len(known) < len(rows) or len({moment.tzinfo is None for moment in known}) > 1:
        return None
    return np.array([(moment - known[0]).total_seconds() for moment in known])


def _claims(layout: CsvLayout, times: float | None) -> RateClaims:
    """Sampling rates above the table; of one that is two, that which the times bear out."""
    found = rates_among([layout.numbers])
    of_unit = tuple(
        RateClaim(f'"{name}"', value)
        for name, value in layout.numbers.items()
        if layout.number_units.get(name) == _SAMPLES
        and all(name not in c.name for c in found.clear)
    )
    loose = tuple(claim for claim in found.loose if claim.name not in {c.name for c in of_unit})
    found = RateClaims((*found.clear, *of_unit), loose)
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


def _wide_text(path: Path, size: int) -> bytes | None:
    """Text that is UTF-16 as UTF-8; None of other text. It is held whole."""
    with path.open("rb") as file:
        if encoding_of(file.read(200)) == "utf-8":
            return None
    check_whole(size, str(path))
    return decoded(path.read_bytes(), str(path)).encode("utf-8")


def _head(file: BinaryIO, size: int, source: str) -> bytes:
    """Whole lines from the beginning of the file."""
    head = file.read(_HEAD)
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
    r"\W*([^\W\d][^:=;,\t]{0,60}?)[\s\"]*[:=;,\t][\s\"=:]*([+-]?[.,]?\d[\d.,eE+-]{0,30})"
    r"[\s\";,]*([kMG]?hz|[kMG]?sa?/s(?:ec)?|[kM]?samples?\s?(?:/|per )\s?s(?:ec(?:ond)?)?"
    r"|sps|rpm|[mnuµμ]?s(?:ec(?:onds?)?)?)?[\s\";,]*",
    re.I,
)
_TEXT_PAIR: Final = re.compile(
    r"\W*([^\W\d][^:=;,\t\[(]{0,40}?)[\s\"]*[:=;,\t][\s\"=:]*"
    r"([^\s;,\"\t][^;,\"\t]{0,20}?)[\s\";,]*"
)
_SAMPLES: Final = "samples/s"
_PREFIXES: Final = {"k": 1e3, "M": 1e6, "G": 1e9, "m": 1e-3, "u": 1e-6, "n": 1e-9}
_ROWS_OF_TIMES: Final = 1000
_MOST_HEADS: Final = 6
_MOST_LINES_READ: Final = 200
_SAME_STEP: Final = 1e-2
_STAMPS_OFF: Final = 0.05
"""Fraction of a step: what rounding to the digits of time stamps may do to one."""
_ONE_COMMA: Final = re.compile(r"[+-]?\d+,\d+(?:[eE][+-]?\d+)?")
_COMMENT_WORDS: Final = frozenset(NAMES["remark"].split())
_GROUPED: Final = {
    "comma": re.compile(rb"(?<![\d.,])[1-9]\d{0,2}(?:\.\d{3})+(?![\d.])"),
    "point": re.compile(rb"(?<![\d.,])[1-9]\d{0,2}(?:,\d{3})+(?![\d,])"),
}
"""Whole numbers whose thousands are parted, by the decimal mark."""
_WRONG: Final = "·".encode("latin-1")
_SEPARATORS: Final = (";", "\t", "|", ",", None)
_ROWS_COMPARED: Final = 5


@frozen
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
        that stand above the table by name, such as a sampling rate; in Hz and s where they are in
        kHz or ms
    number_units
        of those that have one: Hz, rpm, s or samples/s
    two_ways
        lines above the table whose number nothing shows how to read
    numerals
        how the numbers of the table are written
    unit
        that stands above the table, of its only channel
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
    unit: str = ""

    def columns_of_times_perhaps(self, rate: float | None) -> Iterator[tuple[int, float]]:
        """Columns that are of times if they rise evenly, and the unit of each in seconds.

        One without a name is if it rises with the step that the file states elsewhere.

        rate: that the file states; Hz.
        """
        for number, (name, unit) in enumerate(zip(self.names, self.units, strict=True)):
            scale = time_scale_perhaps(name, unit)
            if self.dates[number]:
                continue
            if scale is not None:
                yield number, scale
            elif not name and not unit and rate is not None and len(self.names) > 1:
                yield number, 1.0

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
    given_separator = separator_said(lines[0])
    begin, separator = _first_row(lines, source, given_separator)
    number = _first_row_beside_labels(lines, begin, separator)
    cells = _cells_of(lines[begin], separator)
    above = [line.lstrip("#% ") for line in lines[:number] if line.strip()]
    if separator == "," and above and all(len(_cells_of(line, ",")) == 1 for line in above[-1:]):
        separator = ";"  # one heading over "0,25": a decimal comma
    if separator == "," and not given_separator and len(cells) == 2:
        separator = _comma_of(lines[begin:], above, mark, source, begin + 1)
    if separator == ";" or len(cells) == 1:
        separator = ";"  # blanks in the heading of one column separate nothing
        cells = _cells_of(lines[begin], separator)
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
    labelled = [_saying(line, separator) for line in lines[:begin]]
    numbers, number_units, two_ways = _pairs(labelled, "comma" if comma else mark)
    units, unit = _units_above(lines[:begin], separator, units)
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
        unit=unit,
    )


def _comma_of(
    rows: Sequence[str], above: Sequence[str], mark: DecimalMark | None, source: str, line: int
) -> str:
    """What parts the cells of lines such as 0,12345: a comma, or nothing if it is a decimal one.

    Raises
    ------
    InputError
        If nothing shows which.
    """
    if mark == "comma":
        return ";"
    if mark == "point" or (above and len(_cells_of(above[-1], ",")) == 2):
        return ","
    filled = [row.strip() for row in rows if row.strip()][:_ROWS_OF_TIMES]
    if not all(_ONE_COMMA.fullmatch(row) for row in filled):
        return ","
    raise InputError(
        said("may be one channel with decimal commas, or two channels; nothing shows which"),
        field=marked("table"),
        value=filled[0],
        example=phrase(
            marked("{one} for one channel, {two} for two; or a line of names above the numbers"),
            one=arguments(decimal_mark="comma"),
            two=arguments(decimal_mark="point"),
        ),
        source=source,
        line=line,
    )


def _text(line: bytes) -> str:
    try:
        return line.decode("utf-8").removeprefix("\ufeff").rstrip("\r")
    except UnicodeDecodeError:
        return line.decode("cp1252", "replace").rstrip("\r")


def _first_row(lines: Sequence[str], source: str, given: str = "") -> tuple[int, str | None]:
    """Line with which a table of equally long rows of numbers begins, and its separator.

    given: separator that the file says.
    """
    for number, line in enumerate(lines):
        for separator in (given,) if given else _SEPARATORS:
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


def _first_row_beside_labels(lines: Sequence[str], begin: int, separator: str | None) -> int:
    """First row of numbers, where labels of an oscilloscope stand beside the first of them.

    begin: the first row without a label.
    """
    cells = _cells_of(lines[begin], separator)
    filled = [place for place, cell in enumerate(cells) if cell]
    if separator is None or len(filled) == len(cells) or not filled or filled[0] < 2:
        return begin
    first = begin
    while first > 0:
        above = _cells_of(lines[first - 1], separator)
        if len(above) != len(cells) or not all(_is_number(above[n], separator) for n in filled):
            break
        first -= 1
    return first


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
    """Names and units of the columns, from the last lines above the numbers."""
    rows = [_headings_of_width(_cells_of(line, separator), width) for line in above[-_MOST_HEADS:]]
    last = len(rows) - 1
    nothing = ("",) * width, ("",) * width
    if not rows or not rows[last] or _PAIR.fullmatch(above[-1][:200]):
        return nothing
    place = next((n for n in range(last, -1, -1) if rows[n] and _are_units(rows[n])), None)
    if place is not None and place > 0 and rows[place - 1]:
        bare = [cell.strip("[]() ") for cell in rows[place]]
        units = tuple(plain_unit(unit) for unit in bare)
        return tuple(short_name(cell) for cell in rows[place - 1]), units
    names, units = zip(*(label_parts(cell) for cell in rows[last]), strict=True)
    return names, units


def _headings_of_width(cells: list[str], width: int) -> list[str]:
    """Headings of so many columns; one of comments behind them has no numbers. Empty of others."""
    extra = cells[width:]
    if len(cells) < width or any(
        cell and folded_name(cell) not in _COMMENT_WORDS for cell in extra
    ):
        return []
    return cells[:width]


def _saying(line: str, separator: str | None) -> str:
    """What a line above a table says: where commas part cells, the first two of them or three."""
    cells = _cells_of(line, separator) if separator == "," else []
    if len(cells) < 2 or not cells[0]:
        return line
    unit = cells[2] if len(cells) > 2 and not _is_number(cells[2], ",") else ""
    return f"{cells[0]}: {cells[1]} {unit}".rstrip()


def _are_units(cells: Sequence[str]) -> bool:
    """Whether cells that are filled are units, with or without brackets."""
    bare = [cell.strip("[]() ") for cell in cells if cell]
    return bool(bare) and all(is_unit_word(unit) or label_parts(f"x ({unit})")[1] for unit in bare)


def _units_above(
    above: Sequence[str], separator: str | None, units: Sequence[str]
) -> tuple[tuple[str, ...], str]:
    """Units of the columns, and the one that stands above the table for its only channel.

    A line such as ``Y_Unit_Label  g  V`` gives those of columns without one.
    """
    found = list(units)
    alone = ""
    for line in above[:_MOST_LINES_READ]:
        cells = _cells_of(line, separator)
        if len(cells) == len(found) > 1 and is_unit_name(cells[0]) and _are_units(cells[1:]):
            pairs = zip(found, ["", *cells[1:]], strict=True)
            found = [own or plain_unit(cell) for own, cell in pairs]
            continue
        match = _TEXT_PAIR.fullmatch(_saying(line, separator).lstrip("#% ")[:200])
        if match and is_unit_name(match[1]) and is_unit(plain_unit(match[2])):
            alone = plain_unit(match[2])
    return tuple(found), alone


def _pairs(
    above: Sequence[str], mark: DecimalMark | None
) -> tuple[dict[str, float], dict[str, str], tuple[TwoWays, ...]]:
    """Numbers given by name above the table, units of some, and those that nobody can be sure of.

    mark: the decimal one, if the table or the user gives it.
    """
    found: dict[str, float] = {}
    units: dict[str, str] = {}
    two_ways: list[TwoWays] = []
    for number, line in enumerate(above[:_MOST_LINES_READ], start=1):
        match = _PAIR.match(line.lstrip("#% ")[:200])
        if not match or not _ends_saying(line.lstrip("#% ")[match.end() : 200]):
            continue
        name, text, unit = match[1].strip(), match[2].rstrip(","), match[3] or ""
        numerals = numerals_of([text], commas=True, mark=mark)
        value = numerals.number(text)
        kind, scale = _kind_of_unit(unit)
        if value is None:
            continue
        if kind == "s" and is_rate_or_step(name) != "step":
            scale = 1.0  # "shaft: 29.95 s"? it is what it says, and nobody reads it
        if numerals.doubt and scale == 1.0:
            two_ways.append(TwoWays(name, text, number))
        else:
            found[name] = scale * value
        if kind:
            units[name] = kind
    return found, units, tuple(two_ways)


def _ends_saying(rest: str) -> bool:
    """Whether nothing stands behind a number but the same of other channels."""
    return not rest.strip(' \t;,"') or bool(re.fullmatch(r"[\t;,\s\d.eE+\-\"]*", rest))


def _kind_of_unit(unit: str) -> tuple[str, float]:
    """Hz, rpm, s or samples/s for the unit of a number above a table, and how many they are."""
    plain = unit.replace("µ", "u").replace("μ", "u")
    lower = plain.lower()
    if not plain:
        return "", 1.0
    if lower == "rpm":
        return "rpm", 1.0
    prefix = _PREFIXES.get(plain[0].upper() if plain[0] in "gG" else plain[0], 1.0)
    if lower.endswith("hz"):
        return "Hz", (prefix if len(plain) > 2 else 1.0)
    if lower == "sps" or "/" in plain or "per" in lower:
        with_prefix = plain[0] in "kMG" and plain[1:2] in ("S", "s")
        return _SAMPLES, (prefix if with_prefix else 1.0)
    return "s", (prefix if plain[0] in "mnu" and len(plain) > 1 and plain[1:2] == "s" else 1.0)
