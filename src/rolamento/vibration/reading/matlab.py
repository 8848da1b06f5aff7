"""MATLAB's files of version 5 to 7, as `save -v6` and `save -v7` write them.

The reader is bounded in every step: of each variable the class, shape, name and the numbers are
taken, of structures of one element their fields; cells, objects, functions, text, sparse and
complex arrays are passed over. The layout is that of "MAT-File Format", The MathWorks, chapter 1.
SciPy's reader is not meant for files of which nobody knows where they come from.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np

from rolamento._foreign.bounds import check_inflated
from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._arrays import ArraysSource
from rolamento.vibration.reading._limits import (
    check_size,
    file_size,
    guarded,
)
from rolamento.vibration.reading._variables import (
    MOST_VARIABLES,
    Place,
    Variable,
    check_shape,
)

__all__ = ["MatlabSource"]

_MATRIX: Final = 14
_COMPRESSED: Final = 15
_STRUCTURE: Final = 2
_NUMERIC: Final = range(6, 16)
_COMPLEX: Final = 0x0800
_DEEPEST: Final = 5
_MOST_FIELDS: Final = 1000
_MOST_ELEMENTS: Final = 10 * MOST_VARIABLES
"""Of all kinds: an array has four or five."""
_TYPES: Final = {
    **{1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4"},
    **{7: "f4", 9: "f8", 12: "i8", 13: "u8"},
}


class _Element(NamedTuple):
    kind: int
    content: memoryview
    after: int


@dataclass(frozen=True, slots=True)
class _Numbers:
    name: str
    shape: tuple[int, ...]
    dtype: np.dtype[np.generic]
    content: memoryview


class MatlabSource(ArraysSource):
    """A MATLAB file of version 5 to 7, held whole."""

    def __init__(self, path: Path) -> None:
        source = str(path)
        check_size(file_size(path), source)
        with guarded(source, "MATLAB file"):
            content = path.read_bytes()
            self._arrays = list(_Reader(content, source).variables())
        self._take([_variable(array) for array in self._arrays], source, "MATLAB file")

    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        array = self._arrays[place.variable]
        numbers = np.frombuffer(array.content, array.dtype).reshape(array.shape, order="F")
        row = np.moveaxis(numbers, place.axis, 0)[:, place.row]
        return row[start : start + count].astype(np.float64)

    def close(self) -> None:
        """Let go of what was read."""
        self._arrays = []


class _Reader:
    def __init__(self, content: bytes, source: str) -> None:
        self._source = source
        marks = {b"IM": "<", b"MI": ">"}
        self._order = marks.get(content[126:128], "")
        if not self._order or len(content) < 136:
            raise FileError("is not a MATLAB file of version 5 to 7", source=source)
        self._content = memoryview(content)
        self._inflated = 0
        self._found = 0
        self._elements = 0

    def variables(self) -> Iterator[_Numbers]:
        """Arrays of real numbers, those within structures too."""
        place = 128
        while place + 8 <= len(self._content):
            element = self._element(self._content, place, aligned=False)
            place = element.after
            if element.kind == _COMPRESSED:
                element = self._element(memoryview(self._inflate(element.content)), 0)
            if element.kind == _MATRIX:
                yield from self._matrix(element.content, "", 0)

    def _element(self, content: memoryview, place: int, aligned: bool = True) -> _Element:
        """One tagged element; small ones have their content within the tag."""
        self._elements += 1
        if self._elements > _MOST_ELEMENTS:
            raise FileError(f"holds more than {_MOST_ELEMENTS} elements", source=self._source)
        if place + 8 > len(content):
            raise FileError("is cut off", source=self._source)
        kind, size = struct.unpack_from(f"{self._order}II", content, place)
        if kind >> 16:
            kind, size, begin, after = kind & 0xFFFF, kind >> 16, place + 4, place + 8
            if size > 4:
                raise FileError("is damaged: a small element is too large", source=self._source)
        else:
            begin = place + 8
            after = begin + size
            if aligned and kind != _COMPRESSED:
                after += -size % 8
        if begin + size > len(content):
            raise FileError(
                f"is cut off or damaged: {size} bytes are to follow where there are "
                f"{len(content) - begin}",
                source=self._source,
            )
        return _Element(kind, content[begin : begin + size], after)

    def _inflate(self, content: memoryview) -> bytes:
        """Inflate as much as the first tag declares, which is within the limit, and no more."""
        inflater = zlib.decompressobj()
        tag = inflater.decompress(content, 8)
        if len(tag) < 8:
            raise FileError("is cut off", source=self._source)
        size = struct.unpack(f"{self._order}II", tag)[1]
        self._inflated += size
        check_inflated(self._inflated, len(self._content), self._source)
        return tag + (inflater.decompress(inflater.unconsumed_tail, size) if size else b"")

    def _matrix(self, content: memoryview, parent: str, depth: int) -> Iterator[_Numbers]:
        self._found += 1
        if self._found > MOST_VARIABLES:
            raise FileError(f"holds more than {MOST_VARIABLES} arrays", source=self._source)
        if len(content) == 0:
            return
        flags = self._element(content, 0)
        lengths = self._element(content, flags.after)
        label = self._element(content, lengths.after)
        if len(flags.content) < 8 or len(lengths.content) % 4 or len(lengths.content) > 32:
            raise FileError("is damaged: an array has no shape", source=self._source)
        flag = struct.unpack_from(f"{self._order}I", flags.content)[0]
        shape = struct.unpack(f"{self._order}{len(lengths.content) // 4}i", lengths.content)
        name = parent or bytes(label.content[:200]).decode("latin-1").rstrip("\0")
        kind = flag & 0xFF
        if kind in _NUMERIC and not flag & _COMPLEX and len(shape) == 2:
            yield self._numbers(content, label.after, name, shape)
        elif kind == _STRUCTURE and prod(shape) == 1 and depth < _DEEPEST:
            yield from self._fields(content, label.after, name, depth)

    def _numbers(
        self, content: memoryview, place: int, name: str, shape: tuple[int, ...]
    ) -> _Numbers:
        if prod(shape) == 0:
            return _Numbers(name, (0, 0, 0), np.dtype("f8"), content[:0])
        element = self._element(content, place)
        if element.kind not in _TYPES:
            raise FileError("is damaged: numbers of an unknown type", source=self._source)
        dtype = np.dtype(self._order + _TYPES[element.kind])
        check_shape(shape, dtype.itemsize, len(element.content), self._source)
        if prod(shape) * dtype.itemsize != len(element.content):
            raise FileError("is damaged: an array does not fill its shape", source=self._source)
        return _Numbers(name, shape, dtype, element.content)

    def _fields(
        self, content: memoryview, place: int, parent: str, depth: int
    ) -> Iterator[_Numbers]:
        width = self._element(content, place)
        labels = self._element(content, width.after)
        if len(width.content) != 4:
            raise FileError("is damaged: a structure without fields", source=self._source)
        step = struct.unpack(f"{self._order}i", width.content)[0]
        count = len(labels.content) // step if step > 0 else 0
        if count > _MOST_FIELDS:
            raise FileError(
                f"has more than {_MOST_FIELDS} fields in a structure", source=self._source
            )
        place = labels.after
        for number in range(count):
            field = bytes(labels.content[number * step : (number + 1) * step])
            element = self._element(content, place)
            place = element.after
            name = field.partition(b"\0")[0][:200].decode("latin-1")
            if element.kind == _MATRIX:
                yield from self._matrix(element.content, f"{parent}.{name}", depth + 1)


def _variable(array: _Numbers) -> Variable:
    value = None
    if array.shape == (1, 1):
        value = float(np.frombuffer(array.content, array.dtype)[0])
    return Variable(array.name, array.shape, value)
