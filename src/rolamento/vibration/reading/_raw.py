"""Samples that lie in a file as they are, one channel beside another."""

from __future__ import annotations

from collections.abc import Callable
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

    def read(self, column: int, start: int, count: int) -> FloatArray:
        """Return samples of one channel, in pieces: memory is taken for that channel only."""
        frame = self.item_size * self.width
        at_once = max(1, _PIECE // frame)
        samples = np.empty(count)
        for first in range(0, count, at_once):
            number = min(at_once, count - first)
            self.file.seek(self.offset + (start + first) * frame)
            content = exactly(self.file, number * frame, self.source)
            samples[first : first + number] = self.decode(content)[column :: self.width]
        return samples
