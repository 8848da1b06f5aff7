"""WAV files: integers of 8 to 32 bits and floats, RIFF, RIFX and RF64."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._channel import Channel, Source, checked_channels
from rolamento.vibration.reading._limits import MOST_CHANNELS, exactly, file_size, opened
from rolamento.vibration.reading._raw import RawSamples

__all__ = ["WavSource"]

Order = Literal["<", ">"]

_PCM: Final = 1
_FLOAT: Final = 3
_EXTENSIBLE: Final = 0xFFFE
_STREAMED: Final = 0xFFFFFFFF
"""The size of a chunk that was not known when it was begun."""
_MOST_CHUNKS: Final = 1000
_LONGEST_FORMAT: Final = 4096


@dataclass(frozen=True, slots=True)
class _Format:
    code: int
    channels: int
    rate: int
    frame: int
    bits: int


class WavSource(Source):
    """An open WAV file.

    Integers are scaled to full scale: what the recorder takes at most is 1.
    """

    def __init__(self, path: Path) -> None:
        source = str(path)
        size = file_size(path)
        self._file = opened(path)
        try:
            order, form, offset, length = _found(self._file, size, source)
            item, decode = _decoder(form, order, source)
            if form.frame != item * form.channels:
                raise FileError("has a frame that does not fit its channels", source=source)
            self._raw = RawSamples(self._file, offset, item, form.channels, decode, source)
        except BaseException:
            self._file.close()
            raise
        unit = "1" if form.code == _PCM else ""
        if form.code == _PCM:
            self.notes = (f"samples of {form.bits} bits are scaled to a full scale of 1",)
        each = Channel("", length // form.frame, float(form.rate), unit)
        self.channels = checked_channels([each] * form.channels, source, "WAV file")

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels."""
        return self._raw.read(channels, start, count)

    def close(self) -> None:
        """Let go of the file."""
        self._file.close()


def _found(file: BinaryIO, size: int, source: str) -> tuple[Order, _Format, int, int]:
    """Walk over the chunks up to the samples: byte order, format, place and size of the samples."""
    head = exactly(file, 12, source)
    order: Order = ">" if head[:4] == b"RIFX" else "<"
    if head[:4] not in (b"RIFF", b"RIFX", b"RF64") or head[8:] != b"WAVE":
        raise FileError("is not a WAV file", source=source)
    form: _Format | None = None
    long_size: int | None = None
    place = 12
    for _ in range(_MOST_CHUNKS):
        file.seek(place)
        name, length = struct.unpack(f"{order}4sI", exactly(file, 8, source))
        if name == b"data":
            break
        if name == b"ds64":
            long_size = struct.unpack("<QQ", exactly(file, 16, source))[1]
        if name == b"fmt ":
            form = _format(exactly(file, min(length, _LONGEST_FORMAT), source), order, source)
        place += 8 + length + length % 2
    else:
        raise FileError(f"has {_MOST_CHUNKS} chunks and no samples among them", source=source)
    if form is None:
        raise FileError("does not say how its samples are stored", source=source)
    rest = size - place - 8
    if length == _STREAMED:
        length = rest if long_size is None else long_size
    if length > rest:
        raise FileError(
            f"is cut off: it says that it holds {length} bytes of samples, and there are {rest}",
            source=source,
        )
    return order, form, place + 8, length


def _format(content: bytes, order: Order, source: str) -> _Format:
    if len(content) < 16:
        raise FileError("does not say how its samples are stored", source=source)
    code, channels, rate, _, frame, bits = struct.unpack(f"{order}HHIIHH", content[:16])
    if code == _EXTENSIBLE and len(content) >= 26:
        code = struct.unpack(f"{order}H", content[24:26])[0]
    if not 1 <= channels <= MOST_CHANNELS:
        rule = f"must be from 1 to {MOST_CHANNELS}"
        raise FileError(rule, field="number of channels", value=channels, source=source)
    if rate == 0:
        raise FileError("must be over 0", field="sampling rate", value=rate, source=source)
    return _Format(code, channels, rate, frame, bits)


def _decoder(
    form: _Format, order: Order, source: str
) -> tuple[int, Callable[[bytes], NDArray[Any]]]:
    """Bytes of one sample, and what turns bytes into numbers."""
    kind = (form.code, form.bits)
    if kind == (_PCM, 8):
        return 1, lambda content: (np.frombuffer(content, np.uint8) - 128.0) / 128.0
    if kind == (_PCM, 24):
        return 3, lambda content: _from_24_bits(content, order)
    if form.code == _PCM and form.bits in (16, 32):
        full = 2.0 ** (form.bits - 1)
        dtype = np.dtype(f"{order}i{form.bits // 8}")
        return dtype.itemsize, lambda content: np.frombuffer(content, dtype) / full
    if form.code == _FLOAT and form.bits in (32, 64):
        floats = np.dtype(f"{order}f{form.bits // 8}")
        return floats.itemsize, lambda content: np.frombuffer(content, floats)
    raise FileError(
        "is not read; integers of 8, 16, 24 and 32 bits and floats of 32 and 64 are",
        field="sample format and bits",
        value=f"{form.code}, {form.bits}",
        source=source,
    )


def _from_24_bits(content: bytes, order: Order) -> FloatArray:
    triples = np.frombuffer(content, np.uint8).reshape(-1, 3)
    padded = np.zeros((len(triples), 4), np.uint8)
    # the three bytes take the upper part of four, so that the sign comes right by itself
    padded[:, 1:] = triples if order == "<" else triples[:, ::-1]
    return np.asarray(padded.view("<i4")[:, 0] / 2.0**31)
