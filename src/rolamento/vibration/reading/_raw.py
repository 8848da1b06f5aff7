"""Samples that lie in a file as they are, one channel beside another."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, BinaryIO, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray
from rolamento.vibration.reading._limits import exactly

__all__ = ["RawSamples"]

_PIECE: Final = 4 * 2**20
"""Bytes read at once."""


@dataclass(frozen=True, slots=True)
class RawSamples:
    """Interleaved samples.

    Attributes
    ----------
    file
        open for reading
    offset
        of the first sample, bytes
    item_size
        bytes of one sample
    width
        number of channels side by side
    decode
        from bytes to as many numbers
    source
        what to call the file
    """

    file: BinaryIO
    offset: int
    item_size: int
    width: int
    decode: Callable[[bytes], NDArray[Any]]
    source: str

    def read(self, columns: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels, in pieces: memory is taken for those channels only.

        The shape is (columns, samples).
        """
        frame = self.item_size * self.width
        at_once = max(1, _PIECE // frame)
        samples = np.empty((len(columns), count))
        for first in range(0, count, at_once):
            number = min(at_once, count - first)
            self.file.seek(self.offset + (start + first) * frame)
            content = exactly(self.file, number * frame, self.source)
            frames = self.decode(content)
            for row, column in zip(samples, columns, strict=True):
                row[first : first + number] = frames[column :: self.width]
        return samples
