"""Files of named arrays: their channels, and the arrays of times beside them."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.reading._channel import Channel, Source, checked_channels
from rolamento.vibration.reading._metadata import rate_of
from rolamento.vibration.reading._timeline import Timeline
from rolamento.vibration.reading._variables import Column, Place, Variable, columns_of

__all__ = ["ArraysSource"]

_PIECE: Final = 1_000_000
"""Times that are looked at together."""


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
        self._columns = list(columns_of(variables))
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
