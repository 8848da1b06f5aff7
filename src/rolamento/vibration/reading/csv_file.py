"""Tables of text: CSV with any of the usual separators, decimal points or commas, in blocks."""

from __future__ import annotations

import io
import re
from bisect import bisect_right
from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np

from rolamento._tables import DecimalMark
from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._channel import Channel, Source, checked_channels
from rolamento.vibration.reading._csv_layout import CsvLayout, layout_of
from rolamento.vibration.reading._limits import file_size, guarded, opened
from rolamento.vibration.reading._metadata import (
    RateClaim,
    RateClaims,
    rate_of,
    rates_among,
    speed_among,
)
from rolamento.vibration.reading._timeline import Timeline
from rolamento.vibration.reading._units import quantity_of_unit

__all__ = ["CsvSource"]

_LARGEST: Final = 16 * 2**30
_HEAD: Final = 64 * 2**10
_LONGEST_LINE: Final = 64 * 2**10
_PIECE: Final = 4 * 2**20
_MOST_AT_ONCE: Final = 65_536
_MARKS: Final = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}


class CsvSource(Source):
    """An open table of text.

    The file is run through once for the places of its rows; numbers are read as they are wanted.
    """

    def __init__(self, path: Path, mark: DecimalMark | None = None) -> None:
        self._source = str(path)
        size = file_size(path)
        if size > _LARGEST:
            limit = f"a table of text is read up to {_LARGEST // 2**30} GB; store it as Parquet"
            raise FileError(limit, source=self._source)
        self._file = opened(path)
        try:
            with guarded(self._source, "table"):
                head = _head(self._file, size, self._source)
                self._layout = layout_of(head, self._source, mark)
                self._rows = _Rows(self._file, self._layout.offset, self._source)
                self._timeline = self._times()
                self._columns = self._columns_of_channels()
                self.numbers = self._layout.numbers
                channels = [self._channel(number) for number in self._columns]
            self.channels = checked_channels(channels, self._source, "table")
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
            with guarded(self._source, "table"):
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
        )

    def _block(self, start: int, count: int, columns: list[int]) -> FloatArray:
        """Rows of some columns; (rows, columns)."""
        layout = self._layout
        line = layout.first_line + start
        content = self._rows.take(start, count)
        content = layout.plain(content)
        if not content.strip():
            raise FileError("is blank within the table", source=self._source, line=line)
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
            rule = f"has blank or joined lines among the next {count}"
            raise FileError(rule, source=self._source, line=line)
        return np.asarray(block)


def _claims(layout: CsvLayout, times: float | None) -> RateClaims:
    """Sampling rates above the table; of one that is two, that which the times bear out."""
    found = rates_among([layout.numbers])
    doubtful = []
    for name, (text, *readings) in layout.two_ways.items():
        for value, reading in zip(readings, ("decimal", "thousands"), strict=True):
            claims = rates_among([{name: value}])
            if times is not None and rate_of(claims, times).value is not None:
                doubtful = [*claims.clear]
                break
            doubtful += [
                RateClaim(f'"{name}: {text}" with a {reading} point', claim.value)
                for claim in (*claims.clear, *claims.loose)
            ]
    return RateClaims((*found.clear, *doubtful), found.loose)


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
                raise FileError("is a binary file, not a table of text", source=source)
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
            raise FileError(f"has a line of more than {limit} kB", source=source)

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
        raise FileError(f"is {wrong} text; save it as UTF-8", source=source)
    if b"\0" in head:
        raise FileError("is a binary file, not a table of text", source=source)
    if size > len(head):
        head = head[: head.rfind(b"\n") + 1]
    return head


def _cell_error(error: ValueError, layout: CsvLayout, line: int, source: str) -> FileError:
    """Which cell is no number."""
    text = str(error)
    row = re.search(r"at row (\d+)", text)
    column = re.search(r"column (?:index )?(\d+)", text)
    given = re.search(r"string '([^']{0,40})", text)
    rule = "is not a number" if given else "has fewer columns than the first row"
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
