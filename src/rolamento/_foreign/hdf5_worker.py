"""Reads HDF5 in a process of its own; run as a script by `child`, never imported.

It is told how to read, within which bounds and what file, and asked over its standard input, one
line of JSON a question. It answers with a line of JSON and the bytes that it announces. It knows
nothing but h5py and NumPy, and h5netcdf for data sets, so that it starts soon.

Only what lies in the file itself is followed: soft and external links, virtual and externally
stored data sets and references are passed over. Chunks are inflated here, up to the size that the
file declares, and not by the library, which would go on.
"""

from __future__ import annotations

import json
import math
import sys
import zlib
from collections.abc import Iterator
from typing import Any, Final

import h5py  # type: ignore[import-untyped]
import numpy as np

_MOST_OBJECTS: Final = 10_000
_DEEPEST: Final = 10
_MOST_HELD: Final = 3
"""Chunks kept, one a data set: of samples, speed and time."""
_LONGEST_SECONDS: Final = 3600
"""Of work, should nobody be left to end it."""
_LONGEST_TEXT: Final = 200
_MOST_ATTRIBUTES: Final = 100
_DEFLATE, _SHUFFLE, _CHECKSUM = 1, 2, 3
_CHECKSUM_SIZE: Final = 4


class _RefusedError(Exception):
    """A sentence for the user."""


class _Signals:
    """The arrays of a file, as channels of a signal."""

    def __init__(self, path: str, bounds: dict[str, int]) -> None:
        self._file = h5py.File(path, "r")
        self._bounds = bounds
        self._sets: list[Any] = []
        self._held: dict[int, tuple[tuple[int, ...], Any]] = {}

    def answer(self, question: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        """What the file holds, or numbers of it."""
        return ({}, self._numbers(**question)) if question else (self._variables(), b"")

    def _variables(self) -> dict[str, Any]:
        """All arrays of real numbers."""
        found = list(self._walk(self._file, "", {}, {}, set(), 0))
        return {"variables": found}

    def _numbers(self, variable: int, axis: int, place: int, start: int, count: int) -> bytes:
        """Samples of one channel as little-endian doubles."""
        data = self._sets[variable]
        row = [slice(place, place + 1)] * len(data.shape)
        row[axis] = slice(start, start + count)
        values = data[tuple(row)] if data.chunks is None else self._chunked(variable, row, axis)
        return np.asarray(values).reshape(-1).astype("<f8").tobytes()

    def _walk(
        self,
        group: Any,
        path: str,
        numbers: dict[str, float],
        texts: dict[str, str],
        seen: set[int],
        depth: int,
    ) -> Iterator[dict[str, Any]]:
        """Data sets below a group; what a group says of them holds for all below it."""
        own = _attributes(group)
        numbers, texts = {**numbers, **own[0]}, {**texts, **own[1]}
        for name in group:
            if name == "#refs#" or not isinstance(group.get(name, getlink=True), h5py.HardLink):
                continue
            entry = group[name]
            address = h5py.h5o.get_info(entry.id).addr
            if address in seen:
                continue
            seen.add(address)
            if len(seen) > _MOST_OBJECTS:
                raise _RefusedError(f"holds more than {_MOST_OBJECTS} groups and data sets")
            inner = f"{path}/{name}" if path else str(name)
            if isinstance(entry, h5py.Group):
                if depth < _DEEPEST:
                    yield from self._walk(entry, inner, numbers, texts, seen, depth + 1)
            elif isinstance(entry, h5py.Dataset) and _is_plain(entry):
                self._sets.append(entry)
                _check_filters(entry, inner, self._bounds["chunk"])
                yield _described(entry, inner, numbers, texts)

    def _chunked(self, variable: int, row: list[slice], axis: int) -> Any:
        """Part of a data set in chunks; those that were never written hold the fill value."""
        data = self._sets[variable]
        first, last = row[axis].start, row[axis].stop
        parts = []
        length = data.chunks[axis]
        for begin in range(first - first % length, last, length):
            corner = tuple(
                begin if n == axis else piece.start - piece.start % data.chunks[n]
                for n, piece in enumerate(row)
            )
            chunk = self._chunk(variable, corner)
            inside = tuple(
                slice(max(piece.start - at, 0), min(piece.stop - at, size))
                for piece, at, size in zip(row, corner, data.chunks, strict=True)
            )
            parts.append(chunk[inside].reshape(-1))
        return np.concatenate(parts)

    def _chunk(self, variable: int, corner: tuple[int, ...]) -> Any:
        if variable in self._held and self._held[variable][0] == corner:
            return self._held[variable][1]
        data = self._sets[variable]
        size = math.prod(data.chunks) * data.dtype.itemsize
        stored = data.id.get_chunk_info_by_coord(corner)
        if stored.byte_offset is None:
            chunk = np.full(data.chunks, data.fillvalue, data.dtype)
        else:
            if stored.size > size + size // 8 + 4096:
                raise _RefusedError("is damaged: a chunk is larger than its data")
            mask, content = data.id.read_direct_chunk(corner)
            content = _unfiltered(data, bytes(content), mask, size)
            chunk = np.frombuffer(content, data.dtype).reshape(data.chunks)
        self._held.pop(variable, None)
        if len(self._held) == _MOST_HELD:
            del self._held[next(iter(self._held))]
        self._held[variable] = (corner, chunk)
        return chunk


def _is_plain(data: Any) -> bool:
    """Whether a data set holds real numbers in the file itself, in a way that is read here."""
    properties = data.id.get_create_plist()
    if properties.get_layout() == h5py.h5d.VIRTUAL or properties.get_external_count():
        return False
    try:
        dtype = data.dtype
    except TypeError:  # a kind of number that NumPy does not have
        return False
    if dtype.kind not in "iuf" or dtype.itemsize > 8:
        return False
    if not data.id.get_type().equal(h5py.h5t.py_create(dtype)):
        return False
    return data.shape is not None and len(data.shape) <= 2 and data.size > 0


def _described(
    data: Any, path: str, numbers: dict[str, float], texts: dict[str, str]
) -> dict[str, Any]:
    own = _attributes(data)
    single = data.size == 1 and data.chunks is None
    value = float(np.asarray(data[()]).reshape(-1)[0]) if single else None
    return {
        "name": path,
        "shape": data.shape,
        "value": value if value is None or math.isfinite(value) else None,
        "numbers": {**numbers, **own[0]},
        "texts": {**texts, **own[1]},
    }


def _check_filters(data: Any, path: str, largest: int) -> None:
    """Refuse compression that is not inflated here, and chunks that are too large."""
    if data.chunks is None:
        return
    properties = data.id.get_create_plist()
    for number in range(properties.get_nfilters()):
        code, _, _, name = properties.get_filter(number)
        if code not in (_DEFLATE, _SHUFFLE, _CHECKSUM):
            kind = bytes(name)[:40].decode("latin-1") or str(code)
            raise _RefusedError(f'"{path[:60]}" is compressed with {kind}; only gzip is read')
    if math.prod(data.chunks) * data.dtype.itemsize > largest:
        limit = largest // 2**20
        raise _RefusedError(f'"{path[:60]}" has chunks of more than {limit} MB')


def _unfiltered(data: Any, content: bytes, mask: int, size: int) -> bytes:
    """Undo the filters of a chunk from the last to the first."""
    properties = data.id.get_create_plist()
    for number in reversed(range(properties.get_nfilters())):
        if mask & (1 << number):
            continue
        code = properties.get_filter(number)[0]
        if code == _CHECKSUM:
            content = content[:-_CHECKSUM_SIZE]
        elif code == _DEFLATE:
            # a checksum that was taken before the compression comes out with it
            content = zlib.decompressobj().decompress(content, size + _CHECKSUM_SIZE)
        else:
            width = data.dtype.itemsize
            whole = len(content) // width * width
            planes = np.frombuffer(content[:whole], np.uint8).reshape(width, -1)
            content = planes.T.tobytes() + content[whole:]
    if len(content) != size:
        raise _RefusedError("is damaged: a chunk does not inflate to its size")
    return content


def _attributes(entry: Any) -> tuple[dict[str, float], dict[str, str]]:
    """Single numbers and short texts that an object carries."""
    numbers: dict[str, float] = {}
    texts: dict[str, str] = {}
    for count, name in enumerate(entry.attrs):
        if count == _MOST_ATTRIBUTES:
            break
        about = entry.attrs.get_id(name)
        if math.prod(about.shape or ()) != 1 or about.get_storage_size() > 4096:
            continue
        kind = about.get_type().get_class()
        if kind in (h5py.h5t.INTEGER, h5py.h5t.FLOAT):
            number = float(np.asarray(entry.attrs[name]).reshape(-1)[0])
            if math.isfinite(number):
                numbers[name[:_LONGEST_TEXT]] = number
        elif kind == h5py.h5t.STRING:
            text = np.asarray(entry.attrs[name]).reshape(-1)[0]
            plain = text.decode("utf-8", "replace") if isinstance(text, bytes) else str(text)
            texts[name[:_LONGEST_TEXT]] = plain[:_LONGEST_TEXT]
    return numbers, texts


class _Dataset:
    """The variables of a NetCDF file, with their dimensions and attributes."""

    def __init__(self, path: str, bounds: dict[str, int]) -> None:
        import h5netcdf

        # h5py decodes what is no text with surrogates, which JSON takes
        self._file = h5netcdf.File(path, "r", decode_vlen_strings=True)
        self._bounds = bounds

    def answer(self, question: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        """What the file holds, or a box of a variable: bytes, or texts."""
        if not question:
            return self._described(), b""
        variable = self._file.variables[question["variable"]]
        box = tuple(slice(first, last) for first, last in question["box"])
        values = np.asarray(variable[box])
        if values.dtype.kind in "OSU":
            texts = [_plain_text(text) for text in values.reshape(-1)]
            return {"texts": texts}, b""
        return {}, np.ascontiguousarray(values).tobytes()

    def _described(self) -> dict[str, Any]:
        if len(self._file.variables) > _MOST_OBJECTS:
            raise _RefusedError(f"holds more than {_MOST_OBJECTS} variables")
        return {
            "attributes": _all_attributes(self._file.attrs),
            "variables": [
                self._variable(name, variable) for name, variable in self._file.variables.items()
            ],
        }

    def _variable(self, name: str, variable: Any) -> dict[str, Any]:
        kind = variable.dtype
        text = kind is str or h5py.check_string_dtype(np.dtype(kind)) is not None
        if not text and (np.dtype(kind).kind not in "iufb" or np.dtype(kind).itemsize > 8):
            raise _RefusedError(f'"{name[:60]}" holds neither numbers nor texts')
        chunks = variable.chunks
        size = 8 if text else np.dtype(kind).itemsize
        if chunks is not None and math.prod(chunks) * size > self._bounds["chunk"]:
            limit = self._bounds["chunk"] // 2**20
            raise _RefusedError(f'"{name[:60]}" has chunks of more than {limit} MB')
        return {
            "name": name,
            "dims": list(variable.dimensions),
            "shape": [int(length) for length in variable.shape],
            "dtype": "text" if text else np.dtype(kind).str,
            "attributes": _all_attributes(variable.attrs),
        }


def _all_attributes(attrs: Any) -> dict[str, Any]:
    """Texts as they are, numbers with their types."""
    found: dict[str, Any] = {}
    for count, name in enumerate(attrs):
        if count == _MOST_ATTRIBUTES:
            raise _RefusedError(f"holds more than {_MOST_ATTRIBUTES} attributes in one place")
        value = attrs[name]
        if isinstance(value, str | bytes):
            found[name] = _plain_text(value)
            continue
        values = np.asarray(value)
        if values.dtype.kind in "OSU":
            found[name] = [_plain_text(text) for text in values.reshape(-1)]
        elif values.dtype.kind in "iufb" and values.ndim <= 1:
            found[name] = {"dtype": values.dtype.str, "values": values.tolist()}
        else:
            raise _RefusedError(f'"{name[:60]}" is neither numbers nor a text')
    return found


def _plain_text(text: Any) -> str:
    return text.decode("utf-8", "replace") if isinstance(text, bytes) else str(text)


def _bound(memory: int) -> None:
    """Let the system refuse more than a file may ask for, where it can."""
    try:
        import resource
    except ImportError:
        return
    for limit, most in (
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, _LONGEST_SECONDS),
    ):
        try:
            resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
        except (ValueError, OSError):
            continue


def _answer(reply: dict[str, Any], content: bytes = b"") -> None:
    line = json.dumps({**reply, "bytes": len(content)}) + "\n"
    sys.stdout.buffer.write(line.encode("ascii") + content)
    sys.stdout.buffer.flush()


def _serve(kind: str, bounds: dict[str, int], path: str) -> None:
    reader: _Signals | _Dataset | None = None
    for line in sys.stdin:
        try:
            if reader is None:
                reader = (_Dataset if kind == "dataset" else _Signals)(path, bounds)
            _answer(*reader.answer(json.loads(line)))
        except _RefusedError as refusal:
            _answer({"refusal": str(refusal)})
        except MemoryError:
            _answer({"refusal": "asks for more memory than a file may"})
        except Exception as error:
            reason = (str(error) or type(error).__name__).partition("\n")[0][:120]
            name = "NetCDF" if kind == "dataset" else "HDF5"
            _answer({"refusal": f"is not a readable {name} file: {reason.lower()}"})


if __name__ == "__main__":
    _bounds = json.loads(sys.argv[2])
    _bound(_bounds["memory"])
    _serve(sys.argv[1], _bounds, sys.argv[3])
