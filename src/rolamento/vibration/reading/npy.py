"""NumPy's files: one array in .npy, read in blocks; several in .npz, read whole.

The header of an array is matched against the one form in which NumPy writes it: nothing in it is
evaluated, and arrays of objects, which would need pickle, are refused.
"""

from __future__ import annotations

import re
import struct
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO, Final, cast

import numpy as np

from rolamento._foreign.bounds import check_inflated
from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._arrays import ArraysSource
from rolamento.vibration.reading._channel import Source, checked_channels
from rolamento.vibration.reading._limits import (
    check_size,
    exactly,
    file_size,
    guarded,
    opened,
)
from rolamento.vibration.reading._raw import RawSamples
from rolamento.vibration.reading._variables import (
    MOST_VARIABLES,
    Place,
    Variable,
    check_shape,
    columns_of,
)

__all__ = ["NpySource", "NpzSource"]

_LONGEST_HEADER: Final = 4096
_COMPRESSIONS: Final = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_ENCRYPTED: Final = 1
_LARGEST_LIST: Final = 2 * 2**20
"""Bytes of the list of an archive's members."""
_HEADER: Final = re.compile(
    r"\{\s*'descr':\s*(?P<descr>'[^']{1,20}'|\[[^{}]*\]),\s*'fortran_order':\s*(?P<fortran>True|"
    r"False),\s*'shape':\s*\((?P<shape>[\d,\sL]*)\),?\s*\}\s*"
)
_REAL: Final = re.compile(r"'(?P<dtype>[<>|=][iuf][1248])'")


class _Array:
    """The header of an array: type, shape, order, and where its numbers begin."""

    def __init__(self, file: BinaryIO, source: str) -> None:
        magic = exactly(file, 8, source)
        if magic[:6] != b"\x93NUMPY" or magic[6] not in (1, 2, 3):
            raise FileError("is not a NumPy array of version 1 to 3", source=source)
        long = magic[6] > 1
        length = struct.unpack("<I" if long else "<H", exactly(file, 4 if long else 2, source))[0]
        if length > _LONGEST_HEADER:
            rule = f"must be at most {_LONGEST_HEADER} bytes"
            raise FileError(rule, field="length of the header", value=length, source=source)
        header = _HEADER.fullmatch(exactly(file, length, source).decode("latin-1"))
        if header is None:
            raise FileError("has a header that NumPy does not write", source=source)
        real = _REAL.fullmatch(header["descr"])
        if real is None or real["dtype"][1:] == "f1":
            raise FileError(
                "must be real numbers: arrays of objects, structures and text are not read",
                field="type of the array",
                value=header["descr"][:40],
                example="numpy.save(path, samples.astype(float), allow_pickle=False)",
                source=source,
            )
        self.dtype = np.dtype(real["dtype"])
        self.shape = _shape(header["shape"], source)
        self.fortran = header["fortran"] == "True"
        self.offset = len(magic) + (4 if long else 2) + length


class NpySource(Source):
    """An open .npy file."""

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        size = file_size(path)
        self._file = opened(path)
        try:
            self._array = array = _Array(self._file, self._source)
            check_shape(array.shape, array.dtype.itemsize, size - array.offset, self._source)
            self._columns = list(columns_of([Variable(path.stem, array.shape)]))
            channels = [column.channel for column in self._columns]
            self.channels = checked_channels(channels, self._source, "NumPy array")
        except BaseException:
            self._file.close()
            raise

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels."""
        array = self._array
        axis = self._columns[0].place.axis
        rows = [self._columns[channel].place.row for channel in channels]
        if (axis == 0) != array.fortran:  # side by side
            width = array.shape[1 - axis] if len(array.shape) == 2 else 1
            return self._raw(0, width).read(rows, start, count)
        # one channel after the other
        return np.concatenate(
            [self._raw(row * array.shape[axis], 1).read([0], start, count) for row in rows]
        )

    def _raw(self, first: int, width: int) -> RawSamples:
        """Samples of so many channels side by side, from a number of the array on."""
        dtype = self._array.dtype
        offset = self._array.offset + first * dtype.itemsize
        return RawSamples(
            self._file,
            offset,
            dtype.itemsize,
            width,
            lambda content: np.frombuffer(content, dtype),
            self._source,
        )

    def close(self) -> None:
        """Let go of the file."""
        self._file.close()


class NpzSource(ArraysSource):
    """An open .npz file; what it inflates to is bounded as a file read whole is."""

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        self._size = file_size(path)
        check_size(self._size, self._source)
        self._held: dict[int, np.ndarray[Any, Any]] = {}
        self._file = opened(path)
        try:
            with guarded(self._source, "NumPy archive"):
                self._zip = _archive(self._file, self._source)
                self._members = [m for m in self._listed() if m.filename.endswith(".npy")]
                variables = [self._variable(member) for member in self._members]
                self._take(variables, self._source, "NumPy archive")
        except BaseException:
            self._file.close()
            raise

    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        # all members together inflate to no more than a file that is read whole
        if place.variable not in self._held:
            with guarded(self._source, "NumPy archive"):
                self._held[place.variable] = self._inflated(self._members[place.variable])
        array = self._held[place.variable]
        row = array if array.ndim == 1 else np.moveaxis(array, place.axis, 0)[:, place.row]
        return row[start : start + count].astype(np.float64)

    def close(self) -> None:
        """Let go of the file."""
        self._held = {}
        self._file.close()

    def _listed(self) -> list[zipfile.ZipInfo]:
        members = self._zip.infolist()
        if len(members) > MOST_VARIABLES:
            raise FileError(f"holds more than {MOST_VARIABLES} arrays", source=self._source)
        check_inflated(sum(member.file_size for member in members), self._size, self._source)
        if any(member.compress_type not in _COMPRESSIONS for member in members):
            rule = "is compressed in another way than numpy.savez_compressed does"
            raise FileError(rule, source=self._source)
        if any(member.flag_bits & _ENCRYPTED for member in members):
            raise FileError("is encrypted", source=self._source)
        return members

    def _variable(self, member: zipfile.ZipInfo) -> Variable:
        """What a member holds; one that is not an array of real numbers is no channel."""
        name = member.filename.removesuffix(".npy")
        with self._zip.open(member) as stream:
            file = cast(BinaryIO, stream)
            try:
                array = _Array(file, self._source)
            except FileError:
                return Variable(name, (0, 0, 0))
            check_shape(
                array.shape, array.dtype.itemsize, member.file_size - array.offset, self._source
            )
            value = None
            if array.shape in ((), (1,), (1, 1)):
                content = exactly(file, array.dtype.itemsize, self._source)
                value = float(np.frombuffer(content, array.dtype)[0])
        return Variable(name, array.shape, value)

    def _inflated(self, member: zipfile.ZipInfo) -> np.ndarray[Any, Any]:
        with self._zip.open(member) as stream:
            file = cast(BinaryIO, stream)
            array = _Array(file, self._source)
            count = int(np.prod(array.shape, dtype=np.int64))
            content = exactly(file, count * array.dtype.itemsize, self._source)
        numbers = np.frombuffer(content, array.dtype)
        if array.fortran:
            return numbers.reshape(array.shape[::-1]).T
        return numbers.reshape(array.shape)


class _Directory:
    """An archive's file while its list of members is read, which is taken whole."""

    def __init__(self, file: BinaryIO, source: str) -> None:
        self._file = file
        self._source = source
        self.seek = file.seek
        self.tell = file.tell

    def read(self, count: int = -1) -> bytes:
        content = self._file.read(
            min(count, _LARGEST_LIST + 1) if count >= 0 else _LARGEST_LIST + 1
        )
        if len(content) > _LARGEST_LIST:
            rule = f"has a list of members of more than {_LARGEST_LIST // 2**20} MB"
            raise FileError(rule, source=self._source)
        return content


def _archive(file: BinaryIO, source: str) -> zipfile.ZipFile:
    """An archive whose list of members was bounded as it was read."""
    archive = zipfile.ZipFile(cast(BinaryIO, _Directory(file, source)))
    archive.fp = file
    return archive


def _shape(text: str, source: str) -> tuple[int, ...]:
    lengths = [part.strip().rstrip("L") for part in text.split(",") if part.strip()]
    if len(lengths) > 8 or not all(part.isdecimal() and len(part) <= 15 for part in lengths):
        raise FileError("has a shape that is not one of an array", source=source)
    return tuple(int(part) for part in lengths)
