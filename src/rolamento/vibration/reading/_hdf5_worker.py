"""Reads HDF5 in a process of its own; run as a script by `hdf5`, never imported.

The HDF5 library is not made for damaged files: one wrong byte may send it into memory that is not
its own, or round in circles. Here that ends a child, not the program. The child is asked over its
standard input, one line of JSON a question, and answers with a line of JSON and the bytes that it
announces. It knows nothing but h5py and NumPy, so that it starts soon.

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
_LARGEST_CHUNK: Final = 256 * 2**20
_MOST_HELD: Final = 3
"""Chunks kept, one a data set: of samples, speed and time."""
_MOST_MEMORY: Final = 3 * 2**30
_LONGEST_TEXT: Final = 200
_MOST_ATTRIBUTES: Final = 100
_DEFLATE, _SHUFFLE, _CHECKSUM = 1, 2, 3
_CHECKSUM_SIZE: Final = 4


class _RefusedError(Exception):
    """A sentence for the user."""


class _Worker:
    def __init__(self, path: str) -> None:
        self._file = h5py.File(path, "r")
        self._sets: list[Any] = []
        self._held: dict[int, tuple[tuple[int, ...], Any]] = {}

    def variables(self) -> dict[str, Any]:
        """All arrays of real numbers."""
        found = list(self._walk(self._file, "", {}, {}, set(), 0))
        return {"variables": found}

    def numbers(self, variable: int, axis: int, place: int, start: int, count: int) -> bytes:
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
    _check_filters(data, path)
    single = data.size == 1 and data.chunks is None
    value = float(np.asarray(data[()]).reshape(-1)[0]) if single else None
    return {
        "name": path,
        "shape": data.shape,
        "value": value if value is None or math.isfinite(value) else None,
        "numbers": {**numbers, **own[0]},
        "texts": {**texts, **own[1]},
    }


def _check_filters(data: Any, path: str) -> None:
    """Refuse compression that is not inflated here, and chunks that are too large."""
    if data.chunks is None:
        return
    properties = data.id.get_create_plist()
    for number in range(properties.get_nfilters()):
        code, _, _, name = properties.get_filter(number)
        if code not in (_DEFLATE, _SHUFFLE, _CHECKSUM):
            kind = bytes(name)[:40].decode("latin-1") or str(code)
            raise _RefusedError(f'"{path[:60]}" is compressed with {kind}; only gzip is read')
    if math.prod(data.chunks) * data.dtype.itemsize > _LARGEST_CHUNK:
        limit = _LARGEST_CHUNK // 2**20
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


def _bound_memory() -> None:
    """Let the system refuse more memory than a file may ask for, where it can."""
    try:
        import resource
    except ImportError:
        return
    for limit, most in ((resource.RLIMIT_AS, _MOST_MEMORY), (resource.RLIMIT_CORE, 0)):
        try:
            resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
        except (ValueError, OSError):
            continue


def _answer(reply: dict[str, Any], content: bytes = b"") -> None:
    line = json.dumps({**reply, "bytes": len(content)}) + "\n"
    sys.stdout.buffer.write(line.encode("ascii") + content)
    sys.stdout.buffer.flush()


def _serve(path: str) -> None:
    worker: _Worker | None = None
    for line in sys.stdin:
        try:
            if worker is None:
                worker = _Worker(path)
                _answer(worker.variables())
            else:
                _answer({}, worker.numbers(**json.loads(line)))
        except _RefusedError as refusal:
            _answer({"refusal": str(refusal)})
        except MemoryError:
            _answer({"refusal": "asks for more memory than a file may"})
        except Exception as error:
            reason = (str(error) or type(error).__name__).partition("\n")[0][:120]
            _answer({"refusal": f"is not a readable HDF5 file: {reason.lower()}"})


if __name__ == "__main__":
    _bound_memory()
    _serve(sys.argv[1])
