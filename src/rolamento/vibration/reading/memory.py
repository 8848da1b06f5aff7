"""A signal in memory, as if it were a file: one door for both."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.reading.channels import Channel, Source
from rolamento.vibration.signal import Signal

__all__ = ["SPEED", "MemorySource"]

SPEED: Final = "speed"
"""Name of the channel with the speed of a signal whose shaft did not turn steadily."""


class MemorySource(Source):
    """A signal's samples, and its speed beside them where that is known along it."""

    def __init__(self, signal: Signal) -> None:
        count, speed = len(signal.samples), signal.speed
        steady = None if speed is None or speed.ndim else float(speed)
        self._rows = [signal.samples]
        channels = [Channel("", count, signal.rate, signal.unit, signal.quantity, steady)]
        if speed is not None and speed.ndim:
            self._rows.append(speed)
            channels.append(Channel(SPEED, count, signal.rate, "rad/s"))
        self.channels = tuple(channels)

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels."""
        return np.stack([self._rows[number][start : start + count] for number in channels])
