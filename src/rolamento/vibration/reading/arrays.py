"""Files of named arrays: NumPy's here, MATLAB's and HDF5 in a process of their own.

Which of the arrays are channels, which are numbers about them, and which the times beside them.
"""

from __future__ import annotations

import io
import zipfile
from abc import abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from math import pi, prod
from pathlib import Path
from typing import Any, BinaryIO, Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import check_inflated, check_whole, guarded, size_of_file
from rolamento.io.foreign.isolated import Isolated
from rolamento.io.foreign.readers import (
    MOST_VARIABLES,
    Hdf5Arrays,
    MatlabArrays,
    TdmsChannels,
    Variable,
)
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.reading.channels import Channel, Source, checked_channels
from rolamento.vibration.reading.metadata import (
    RateClaims,
    Timeline,
    label_parts,
    positive,
    rate_of,
    rates_among,
    short_name,
    speed_among,
    time_scale,
    unit_among,
)
from rolamento.vibration.reading.units import quantity_of_unit
from rolamento.words import marked, said

__all__ = ["ArraysSource", "IsolatedSource", "NumpySource"]

_MOST_COLUMNS: Final = 64
"""Maximum number of columns of a matrix whose columns, or rows, are channels."""
_PIECE: Final = 1_000_000
"""Samples that are asked for, or times that are looked at, together."""
_LONGEST_HEADER: Final = 10_000
_ENCRYPTED: Final = 1
_COMPRESSIONS: Final = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


class Place(NamedTuple):
    """A row or column of a variable.

    Attributes
    ----------
    variable
        its number
    row
        number of the row or column of a matrix
    axis
        along which the samples run
    """

    variable: int
    row: int
    axis: int


class Times(NamedTuple):
    """An array of times.

    Attributes
    ----------
    place
        where it lies
    scale
        seconds in its unit
    """

    place: Place
    scale: float


@frozen
class Column:
    """A channel and where its samples lie, their times if the file has them, and its rates."""

    channel: Channel
    place: Place
    times: Times | None
    rates: RateClaims


class ArraysSource(Source):
    """An open file of arrays that have names.

    An array of times gives the rate of the channels beside it that are as long, and is read with
    them, as the column of times in a table is.
    """

    def _take(self, variables: Sequence[Variable], source: str, kind: str) -> None:
        """Find the channels among the variables.

        Raises
        ------
        FileError
            If there are none or too many, or an array of times is not one.
        """
        self._name = source
        self.numbers = {v.name: v.value for v in variables if v.value is not None}
        self._columns = list(_columns_of(variables))
        found = checked_channels((c.channel for c in self._columns), source, kind)
        self._timelines: dict[Place, Timeline] = {}
        self.channels = tuple(
            channel if column.times is None else self._timed(channel, column)
            for channel, column in zip(found, self._columns, strict=True)
        )

    @abstractmethod
    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        """Part of a row or column of a variable."""

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels; the times beside them are checked."""
        samples = np.empty((len(channels), count))
        for row, channel in zip(samples, channels, strict=True):
            row[:] = self._samples(self._columns[channel].place, start, count)
        for times in {self._columns[channel].times for channel in channels} - {None}:
            assert times is not None
            for first in range(start, start + count, _PIECE):
                piece = self._samples(times.place, first, min(_PIECE, start + count - first))
                self._timelines[times.place].check(piece, first, self._name)
        return samples

    def _timed(self, channel: Channel, column: Column) -> Channel:
        """Return a channel with its rate by the array of times and by name."""
        times = column.times
        assert times is not None
        if times.place not in self._timelines:
            first, last = (self._samples(times.place, row, 1)[0] for row in (0, channel.length - 1))
            self._timelines[times.place] = Timeline.between(
                float(first), float(last), channel.length, times.scale, self._name
            )
        rate = rate_of(column.rates, self._timelines[times.place].rate)
        return replace(channel, rate=rate.value, rate_doubt=rate.doubt, rate_aside=rate.aside)


class NumpySource(ArraysSource):
    """The array of an .npy file, mapped, or those of an .npz archive, each read as it is needed.

    A file is mapped anew for each piece: what has been read does not stay in memory. Nothing is
    unpickled. What an archive inflates to is bounded as a file read whole is.
    """

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        self._arrays: dict[int, NDArray[Any]] = {}
        self._file: BinaryIO | None = None
        self._map: Callable[[], NDArray[Any]] | None = None
        size = size_of_file(path)
        with path.open("rb") as file:
            is_archive = file.read(2) == b"PK"
        kind = marked("NumPy archive") if is_archive else marked("NumPy array")
        with guarded(self._source, kind):
            try:
                variables = self._members(path, size) if is_archive else self._mapped(path, size)
                self._take(variables, self._source, kind)
            except BaseException:
                self.close()
                raise

    def close(self) -> None:
        """Let go of the file."""
        self._arrays, self._map = {}, None
        if self._file is not None:
            self._file.close()

    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        if self._map is not None:
            with guarded(self._source, marked("NumPy array")):
                array = self._map()
        else:
            if place.variable not in self._arrays:
                with guarded(self._source, marked("NumPy archive")):
                    self._arrays[place.variable] = self._archive[self._names[place.variable]]
            array = self._arrays[place.variable]
        line = array if array.ndim == 1 else np.moveaxis(array, place.axis, 0)[:, place.row]
        return line[start : start + count].astype(np.float64)

    def _mapped(self, path: Path, size: int) -> list[Variable]:
        self._file = path.open("rb")
        header = _Header.of(self._file)
        header.check(size - header.offset, self._source)
        if prod(header.shape):
            self._map = partial(
                np.memmap, self._file, header.dtype, "r", header.offset, header.shape, header.order
            )
        return [Variable(path.stem, header.shape)]

    def _members(self, path: Path, size: int) -> list[Variable]:
        check_whole(size, self._source)
        # of a damaged archive NumPy would not close the file
        self._file = path.open("rb")
        self._archive = np.load(self._file, allow_pickle=False)
        members = [m for m in self._archive.zip.infolist() if m.filename.endswith(".npy")]
        if len(members) > MOST_VARIABLES:
            raise FileError(
                said("has more than {most} arrays", most=MOST_VARIABLES), source=self._source
            )
        check_inflated(sum(member.file_size for member in members), size, self._source)
        if any(member.compress_type not in _COMPRESSIONS for member in members):
            rule = said("is compressed in another way than by numpy.savez_compressed")
            raise FileError(rule, source=self._source)
        if any(member.flag_bits & _ENCRYPTED for member in members):
            raise FileError(said("is encrypted"), source=self._source)
        self._names = [member.filename.removesuffix(".npy") for member in members]
        return [self._variable(member) for member in members]

    def _variable(self, member: zipfile.ZipInfo) -> Variable:
        """What a member holds; one that is not an array of real numbers is no channel."""
        name = member.filename.removesuffix(".npy")
        try:
            with self._archive.zip.open(member) as stream:
                header = _Header.of(stream)
        except (FileError, ValueError):
            return Variable(name, (0, 0, 0))
        header.check(member.file_size - header.offset, self._source)
        single = header.shape in ((), (1,), (1, 1))
        value = float(self._archive[name].reshape(-1)[0]) if single else None
        return Variable(name, header.shape, value)


class IsolatedSource(ArraysSource):
    """A MATLAB file of version 5 to 7, an HDF5 file, MATLAB 7.3 among them, or a TDMS file."""

    def __init__(self, path: Path, kind: Literal["MATLAB", "HDF5", "TDMS"]) -> None:
        self._source = str(path)
        size = size_of_file(path)
        if kind == "MATLAB":
            check_whole(size, self._source)
        elif kind == "TDMS" and find_spec("nptdms") is None:
            raise FileError(
                said(
                    "is a TDMS file, which is read with npTDMS; install it, or export the channel"
                    " as CSV"
                ),
                source=self._source,
                example="pip install rolamento[tdms]",
            )
        reader, named = _ISOLATED[kind]
        self._process = Isolated(reader, path, named)
        try:
            variables = self._process.ask("variables")
            self._names = [variable.name for variable in variables]
            if kind == "MATLAB" and all(variable.value is not None for variable in variables):
                self._refuse_others(named)
            self._take(variables, self._source, named)
        except BaseException:
            self.close()
            raise

    def _refuse_others(self, named: str) -> None:
        """Refuse a file of other things than arrays of real numbers, and say of which."""
        others: list[str] = self._process.ask("others")
        if others:
            raise FileError(
                said(
                    "is a {kind} that holds {others}, which is not read, and no channel of real"
                    " numbers",
                    kind=said(named),
                    others=", ".join(others),
                ),
                source=self._source,
            )

    def close(self) -> None:
        """End the process that has the file open."""
        self._process.end()

    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        samples = np.empty(count)
        name = self._names[place.variable]
        for first in range(0, count, _PIECE):
            number = min(_PIECE, count - first)
            piece = self._process.ask("samples", name, place.axis, place.row, start + first, number)
            if len(piece) != number:
                raise FileError(said("ends before its last sample"), source=self._source)
            samples[first : first + number] = piece
        return samples


_ISOLATED: Final[Mapping[str, tuple[Callable[[str], Any], str]]] = {
    "MATLAB": (MatlabArrays, marked("MATLAB file")),
    "HDF5": (Hdf5Arrays, marked("HDF5 file")),
    "TDMS": (TdmsChannels, marked("TDMS file")),
}
"""The reader of a kind of file, and what the file is called."""


class _Header(NamedTuple):
    """The header of a NumPy array, and where its numbers begin."""

    shape: tuple[int, ...]
    order: Literal["C", "F"]
    dtype: np.dtype[Any]
    offset: int

    @classmethod
    def of(cls, file: BinaryIO) -> _Header:
        # as long as it says it is, a header would be read before it is refused
        head = io.BytesIO(file.read(_LONGEST_HEADER))
        version = np.lib.format.read_magic(head)
        if version == (1, 0):
            shape, fortran, dtype = np.lib.format.read_array_header_1_0(head)
        else:
            shape, fortran, dtype = np.lib.format.read_array_header_2_0(head)
        if dtype.kind not in "iuf" or dtype.itemsize > 8:
            raise FileError(
                said("must be real numbers: arrays of objects, structures and text are not read"),
                field=marked("array type"),
                value=str(dtype)[:40],
                example="numpy.save(path, samples.astype(float), allow_pickle=False)",
            )
        return cls(shape, "F" if fortran else "C", dtype, head.tell())

    def check(self, size: int, source: str) -> None:
        """Refuse an array that declares more bytes than there are."""
        if min(self.shape, default=0) < 0 or prod(self.shape) * self.dtype.itemsize > size:
            raise FileError(
                said(
                    "is truncated or damaged: an array of shape {shape} does not fit into it",
                    shape=self.shape,
                ),
                source=source,
            )


def _columns_of(variables: Sequence[Variable]) -> Iterator[Column]:
    """Channels among the variables: rows, columns, and matrices much longer than wide.

    Single numbers are read by their name: a sampling rate of all channels in the same group or
    structure, or a speed such as `X097RPM` of the channels that begin with `X097`. An array of
    times beside channels of its length is none itself.
    """
    singles = {v.name: v.value for v in variables if v.value is not None}
    within: dict[str, dict[str, float]] = {"": {}, **{_group(v.name): {} for v in variables}}
    for name, value in singles.items():
        group = _group(name)
        within[group][name[len(group) + 1 if group else 0 :]] = value
    rates = {group: rates_among((numbers, within[""])) for group, numbers in within.items()}
    speeds = _Speeds(singles)
    shafts = {group: speed_among(numbers) for group, numbers in within.items()}
    layouts = [_layout(variable.shape) for variable in variables]
    times = _times_of(variables, layouts)
    stamps = {found.place.variable for found in times.values()}
    for number, (variable, layout) in enumerate(zip(variables, layouts, strict=True)):
        if layout is None or number in stamps:
            continue
        axis, columns = layout
        group = _group(variable.name)
        unit = unit_among(variable.texts)
        claims = rates[group]
        if variable.numbers:
            claims = rates_among((variable.numbers, within[group], within[""]))
        rate = rate_of(claims)
        by_name = (speed_among(variable.numbers), shafts[group], speeds.of(variable.name))
        speed = next((found for found in by_name if found is not None), shafts[""])
        for row in range(columns):
            name = short_name(variable.name) + (f"[{row + 1}]" if columns > 1 else "")
            channel = Channel(
                name,
                variable.shape[axis],
                rate.value,
                unit,
                quantity_of_unit(unit),
                speed,
                rate.doubt,
                rate.aside,
            )
            yield Column(channel, Place(number, row, axis), times.get(number), claims)


def _times_of(
    variables: Sequence[Variable], layouts: Sequence[tuple[int, int] | None]
) -> dict[int, Times]:
    """Times of the variables that have them, by number: of the same group, or from the top."""
    lengths = [
        0 if layout is None else variables[n].shape[layout[0]] for n, layout in enumerate(layouts)
    ]
    stamps: dict[tuple[str, int], Times] = {}
    named: set[int] = set()
    for number, (variable, layout) in enumerate(zip(variables, layouts, strict=True)):
        scale = _scale_of_times(variable)
        if scale is not None and layout is not None and layout[1] == 1:
            named.add(number)
            place = Place(number, 0, layout[0])
            stamps.setdefault((_group(variable.name), lengths[number]), Times(place, scale))
    found = {}
    for number, variable in enumerate(variables):
        if number not in named and lengths[number]:
            keys = [(group, lengths[number]) for group in (_group(variable.name), "")]
            times = next((stamps[key] for key in keys if key in stamps), None)
            if times is not None:
                found[number] = times
    return found


def _scale_of_times(variable: Variable) -> float | None:
    """Seconds in the unit of a variable, if its name is that of times."""
    cut = len(_group(variable.name))
    name, unit = label_parts(variable.name[cut:].lstrip("./"))
    return time_scale(name, unit_among(variable.texts) or unit)


class _Speeds:
    """Speeds of the shaft among the single numbers, by what stands before RPM in their names."""

    def __init__(self, singles: Mapping[str, float]) -> None:
        self._by_prefix = {
            name[:-3].rstrip("_ ."): value * pi / 30.0
            for name, value in singles.items()
            if name.lower().endswith("rpm") and positive(abs(value))
        }

    def of(self, name: str) -> float | None:
        """Return the speed with the longest prefix that a channel's name begins with."""
        fitting = [prefix for prefix in self._by_prefix if name.startswith(prefix)]
        return self._by_prefix[max(fitting, key=len)] if fitting else None


def _layout(shape: Sequence[int]) -> tuple[int, int] | None:
    """Axis of the samples and number of channels; None of what is no channel."""
    if len(shape) == 1:
        return (0, 1) if shape[0] != 1 else None
    if len(shape) != 2 or max(shape) <= 1:
        return None
    axis = 0 if shape[0] >= shape[1] else 1
    columns = shape[1 - axis]
    return (axis, columns) if 1 <= columns <= _MOST_COLUMNS else None


def _group(name: str) -> str:
    """What stands before the last dot or stroke of a name."""
    return name[: max(name.rfind("."), name.rfind("/"), 0)]
