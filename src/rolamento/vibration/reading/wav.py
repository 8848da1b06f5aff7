"""WAV files, by libsndfile: integers of 8 to 32 bits and floats; RIFF, RIFX and RF64."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Final

import numpy as np
import soundfile

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import guarded, size_of_file
from rolamento.numerics import FloatArray
from rolamento.vibration.reading.channels import MOST_CHANNELS, Channel, Source, checked_channels
from rolamento.words import Note, marked, said

__all__ = ["WavSource"]

_BITS: Final = {"PCM_U8": 8, "PCM_16": 16, "PCM_24": 24, "PCM_32": 32}
_FLOATS: Final = ("FLOAT", "DOUBLE")
_AT_ONCE: Final = 500_000
"""Numbers of all channels together."""


class WavSource(Source):
    """An open WAV file.

    Integers are scaled to full scale: what the recorder takes at most is 1.
    """

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        size = size_of_file(path)
        with guarded(self._source, marked("WAV file")):
            _refuse_cut_off(path, size, self._source)
            try:
                self._file = soundfile.SoundFile(self._source)
            except soundfile.LibsndfileError as error:  # whose text begins with the path
                rule = said(
                    "is not a readable WAV file: {what}",
                    what=error.error_string.rstrip(".").lower(),
                )
                raise FileError(rule) from None
        try:
            bits = _BITS.get(self._file.subtype, 0)
            if not bits and self._file.subtype not in _FLOATS:
                raise FileError(
                    said("is not supported; integers of 8, 16, 24 and 32 bits and floats are"),
                    field=marked("sample format"),
                    value=self._file.subtype_info,
                    source=self._source,
                )
            if self._file.channels > MOST_CHANNELS:
                raise FileError(
                    said("has more than {most} channels", most=MOST_CHANNELS), source=self._source
                )
            if bits:
                self.notes = (Note("bits_to_full_scale", {"bits": bits}),)
            rate = float(self._file.samplerate)
            each = Channel("", self._file.frames, rate, "1" if bits else "")
            self.channels = checked_channels(
                [each] * self._file.channels, self._source, marked("WAV file")
            )
        except BaseException:
            self._file.close()
            raise

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels, in pieces: memory is taken for those channels only."""
        samples = np.empty((len(channels), count))
        at_once = max(1, _AT_ONCE // self._file.channels)
        with guarded(self._source, marked("WAV file")):
            self._file.seek(start)
            for first in range(0, count, at_once):
                number = min(at_once, count - first)
                frames = self._file.read(number, dtype="float64", always_2d=True)
                if len(frames) != number:
                    raise FileError(said("ends before its last sample"), source=self._source)
                samples[:, first : first + number] = frames.T[list(channels)]
        return samples

    def close(self) -> None:
        """Let go of the file."""
        self._file.close()


def _refuse_cut_off(path: Path, size: int, source: str) -> None:
    """Refuse a file that is shorter than it says; libsndfile would read what is there.

    A recorder that did not know the size when it began wrote a size of all ones, or none.
    """
    with path.open("rb") as file:
        head = file.read(28)
    declared = int.from_bytes(head[4:8], "big" if head[:4] == b"RIFX" else "little")
    if head[:4] == b"RF64" and head[12:16] == b"ds64" and len(head) == 28:
        declared = struct.unpack("<Q", head[20:28])[0]
    if declared not in (0, 0xFFFFFFFF) and declared + 8 > size + 1:  # a last odd byte is padded
        raise FileError(
            said(
                "is truncated: it declares {declared} bytes, and there are {size}",
                declared=declared + 8,
                size=size,
            ),
            source=source,
        )
