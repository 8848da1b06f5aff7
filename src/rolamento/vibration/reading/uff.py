"""Universal files with data sets 58 (text) and 58b (binary): records over time.

The layout is that of the data sets 58 and 164 as the Structural Dynamics Research Laboratory of
the University of Cincinnati publishes them.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from itertools import cycle
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import check_whole, guarded, size_of_file
from rolamento.numerics import FloatArray
from rolamento.vibration.reading.channels import Channel, Source, checked_channels
from rolamento.vibration.reading.metadata import Timeline, positive, short_name
from rolamento.vibration.reading.units import plain_unit, quantity_of_unit
from rolamento.vibration.signal import SI_UNITS, Quantity
from rolamento.words import marked, said

__all__ = ["UffSource"]

_MARK: Final = b"    -1"
_MARK_LINE: Final = re.compile(rb"\n    -1[ \t\r]*(?:\n|\Z)")
_MOST_SETS: Final = 10_000
_HEADER_LINES: Final = 11
_LONGEST_LINE: Final = 200
_OVER_TIME: Final = (0, 1)
"""Types of function: general or unknown, time response."""
_TIME: Final = (0, 17)
"""Types of abscissa: unknown, time."""
_FREQUENCY: Final = 18
_FUNCTIONS: Final = {
    2: marked("auto spectra"), 3: marked("cross spectra"), 4: marked("frequency responses"),
    5: marked("transmissibilities"), 6: marked("coherences"), 7: marked("autocorrelations"),
    8: marked("cross correlations"), 9: marked("power spectral densities"),
    10: marked("energy spectral densities"), 12: marked("spectra"),
}  # fmt: skip
"""Types of function of data set 58 that are no records over time."""
_QUANTITIES: Final[dict[int, Quantity]] = {8: "displacement", 11: "velocity", 12: "acceleration"}
_SINGLE: Final = 2
_DOUBLE: Final = 4
_PIECE: Final = 2 * 2**20
"""Bytes of text made into numbers at once."""


class _Form(NamedTuple):
    """How numbers are kept: byte order ("" for text), precision, spacing, and how many."""

    order: str
    double: bool
    even: bool
    length: int


class _Numbers(NamedTuple):
    """The numbers of a record."""

    content: memoryview
    form: _Form

    def samples(self, source: str) -> FloatArray:
        """All samples."""
        if not self.form.even:
            return self.pairs(source)[1]
        _, double, _, length = self.form
        if self.form.order:
            dtype = f"{self.form.order}f{8 if double else 4}"
            return np.frombuffer(self.content, dtype, length).astype(np.float64)
        return _from_text(self.content, (20,) if double else (13,), length, source)

    def pairs(self, source: str) -> tuple[FloatArray, FloatArray]:
        """Instants and samples of a record that is not evenly spaced."""
        order, double, _, length = self.form
        if order:
            # the standard's instants are of single precision; some writers' are of double
            wide = double and len(self.content) == 16 * length
            pair = [("x", f"{order}f{8 if wide else 4}"), ("y", f"{order}f{8 if double else 4}")]
            both = np.frombuffer(self.content, pair, length)
            return both["x"].astype(np.float64), both["y"].astype(np.float64)
        widths = (13, 20) if double else (13, 13)
        numbers = _from_text(self.content, widths, 2 * length, source)
        return numbers[::2], numbers[1::2]


class _Set(NamedTuple):
    """A record over time."""

    channel: Channel
    numbers: _Numbers


class UffSource(Source):
    """A universal file, held whole."""

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        check_whole(size_of_file(path), self._source)
        self._held: dict[int, FloatArray] = {}
        with guarded(self._source, marked("universal file")):
            reader = _Reader(path.read_bytes(), self._source)
            self._sets = list(reader.records())
        if not self._sets and reader.passed_over:
            raise FileError(
                said(
                    "is a universal file that holds {kinds}; a record over time is needed",
                    kinds=", ".join(said(kind) for kind in reader.passed_over),
                ),
                source=self._source,
            )
        channels = [record.channel for record in self._sets]
        self.channels = checked_channels(channels, self._source, marked("universal file"))

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels."""
        self._held = {n: samples for n, samples in self._held.items() if n in channels}
        for channel in channels:
            if channel not in self._held:
                with guarded(self._source, marked("universal file")):
                    self._held[channel] = self._sets[channel].numbers.samples(self._source)
        return np.stack([self._held[channel][start : start + count] for channel in channels])

    def close(self) -> None:
        """Let go of what was read."""
        self._sets = []
        self._held = {}


class _Reader:
    def __init__(self, content: bytes, source: str) -> None:
        self._content = content
        self._source = source
        self._metric = False
        self.passed_over: dict[str, None] = {}

    def records(self) -> Iterator[_Set]:
        """Data sets of real numbers over time."""
        place = 0
        for _ in range(_MOST_SETS):
            begin = self._mark(place)
            if begin < 0:
                return
            head, after = self._line(begin)
            place = begin
            if head[:6].strip() == "58":
                place, record = self._record(head, self._lines(after))
                if record is not None:
                    yield record
            elif head.strip() != "-1":  # two marks in a row: the second begins a data set
                self._metric |= head.strip() == "164" and _whole(self._line(after)[0], 0, 10) == 1
                end = self._mark(after)
                place = len(self._content) if end < 0 else end
        raise FileError(
            said("has more than {most} data sets", most=_MOST_SETS), source=self._source
        )

    def _mark(self, place: int) -> int:
        """Place after the next line that is a mark and nothing else, or -1."""
        if place == 0 and self._content.startswith(_MARK):
            line, after = self._line(0)
            if not line[len(_MARK) :].strip():
                return after
        found = _MARK_LINE.search(self._content, max(place - 1, 0))
        return found.end() if found else -1

    def _line(self, place: int) -> tuple[str, int]:
        """One line and the place after it."""
        end = self._content.find(b"\n", place, place + _LONGEST_LINE)
        stop = min(place + _LONGEST_LINE, len(self._content)) if end < 0 else end
        text = self._content[place:stop].decode("latin-1").rstrip("\r")
        return text, stop if end < 0 else end + 1

    def _lines(self, place: int) -> list[tuple[str, int]]:
        """Lines of a header, each with the place after it."""
        lines = []
        for _ in range(_HEADER_LINES):
            text, place = self._line(place)
            lines.append((text, place))
        return lines

    def _record(self, head: str, lines: list[tuple[str, int]]) -> tuple[int, _Set | None]:
        """Place after a data set 58, and its record if it is one of real numbers over time."""
        texts = [text for text, _ in lines]
        begin = lines[-1][1]
        form = texts[6]
        kind, count, even = (_whole(form, 10 * n, 10) for n in range(3))
        if head[6:7].lower() == "b":
            sizes = (_whole(head, 31, 12), *(count * width for width in _widths(kind, even == 1)))
            stop = self._binary_end(begin, sizes)
            place = self._line(max(self._content.find(_MARK, stop, stop + 100), stop))[1]
            order = "<" if _whole(head, 7, 6) == 1 else ">"
        else:
            place = self._mark(begin)
            stop = place = len(self._content) if place < 0 else place
            order = ""
        wanted = _whole(texts[5], 0, 5) in _OVER_TIME and _whole(texts[7], 0, 10) in _TIME
        if kind not in (_SINGLE, _DOUBLE) or not wanted or count < 1:
            function = _whole(texts[5], 0, 5)
            over = _whole(texts[7], 0, 10)
            named = _FUNCTIONS.get(function, marked("spectra"))
            if function in _FUNCTIONS or over == _FREQUENCY:  # else a header without anything
                self.passed_over[named] = None
            return place, None
        content = memoryview(self._content)[begin:stop]
        kept = _Form(order, kind == _DOUBLE, even == 1, count)
        return place, self._described(texts, _Numbers(content, kept))

    def _binary_end(self, begin: int, sizes: Sequence[int]) -> int:
        """Place where binary numbers end: of the sizes they may have, one has a mark after it."""
        for size in sizes:
            after = self._content[begin + size : begin + size + 8] if size > 0 else b""
            if after.lstrip(b"\r\n").startswith(_MARK):
                return begin + size
        raise FileError(
            said("is truncated or damaged: a binary record does not end where it should"),
            source=self._source,
        )

    def _described(self, texts: list[str], numbers: _Numbers) -> _Set:
        count = numbers.form.length
        # each number takes a byte at the very least
        if count > len(numbers.content):
            raise FileError(
                said("is truncated or damaged: a record is too short"), source=self._source
            )
        unit, quantity = self._unit(texts[8])
        step = _real(texts[6], 43, 13)
        rate = 1.0 / step if numbers.form.even and positive(step) else None
        if not numbers.form.even:
            times = numbers.pairs(self._source)[0]
            timeline = Timeline.between(float(times[0]), float(times[-1]), count, 1.0, self._source)
            timeline.check(times, 0, self._source)
            rate = timeline.rate
        name = short_name(texts[0]) if texts[0].strip() != "NONE" else ""
        return _Set(Channel(name or _node(texts[5]), count, rate, unit, quantity), numbers)

    def _unit(self, line: str) -> tuple[str, Quantity]:
        """Unit and quantity of the ordinate: by its label, or by its type in an SI file."""
        label = plain_unit(line[46:67])
        quantity = _QUANTITIES.get(_whole(line, 0, 10), "unknown")
        if label and label.upper() != "NONE":
            return label, quantity_of_unit(label)
        if quantity != "unknown" and self._metric:
            return SI_UNITS[quantity], quantity
        return "", quantity


def _widths(kind: int, even: bool) -> tuple[int, ...]:
    """Bytes that one sample may take, with the instant before it where the spacing is uneven."""
    own = {_SINGLE: 4, _DOUBLE: 8, 5: 8, 6: 16}.get(kind, 0)
    return (own,) if even else (own + 4, own + 8)


def _from_text(content: memoryview, widths: tuple[int, ...], count: int, source: str) -> FloatArray:
    """Numbers in columns of fixed widths, or between blanks where a writer keeps to none."""
    numbers = np.empty(count)
    filled = 0
    stream = io.BytesIO(content)
    while filled < count and (lines := stream.readlines(_PIECE)):
        text = b"".join(lines).upper().replace(b"D", b"E")
        try:
            found = _as_floats(text.split())
        except ValueError:  # numbers that touch
            found = _as_floats([cell for line in text.split(b"\n") for cell in _cut(line, widths)])
        found = found[: count - filled]
        numbers[filled : filled + len(found)] = found
        filled += len(found)
    if filled < count:
        rule = said(
            "ends before its last sample: {filled} of {count} numbers are present",
            filled=filled,
            count=count,
        )
        raise FileError(rule, source=source)
    return numbers


def _as_floats(cells: list[bytes]) -> FloatArray:
    cells = cells[: cells.index(b"-1")] if b"-1" in cells[-2:] else cells  # the mark at the end
    return np.array(cells, dtype="S26").astype(np.float64) if cells else np.empty(0)


def _cut(line: bytes, widths: tuple[int, ...]) -> Iterator[bytes]:
    line = line.rstrip()
    place = 0
    for width in cycle(widths):
        if place >= len(line):
            return
        yield line[place : place + width].strip()
        place += width


def _whole(line: str, place: int, width: int) -> int:
    text = line[place : place + width].strip()
    return int(text) if text.lstrip("-").isdecimal() else 0


def _real(line: str, place: int, width: int) -> float:
    try:
        return float(line[place : place + width].upper().replace("D", "E"))
    except ValueError:
        return 0.0


def _node(line: str) -> str:
    """Name of the point of response: its entity and number."""
    entity = line[31:41].strip()
    return short_name(f"{entity if entity not in ('', 'NONE') else 'point'} {_whole(line, 41, 10)}")
