"""What noise statistics do not hold for: stretches that do not change, and copies of the record."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis.runs import runs

__all__ = ["MOST_GAPS", "Watch"]

_BEGINNING: Final = 64
"""Samples that noise does not give twice."""


_GAP: Final = 8
"""Equal samples that follow each other, from which on they are a gap."""
MOST_GAPS: Final = 20
"""That a record may have: more may well be periodic."""


class Watch:
    """Looks at a record block by block.

    Attributes
    ----------
    still
        blocks that hardly change
    repeats_after
        samples after which the record begins anew, one by one the same; None if it does not
    gaps
        runs of samples that only repeat the one before, in blocks that do change
    """

    def __init__(self) -> None:
        self.still = 0
        self.gaps = 0
        self.repeats_after: int | None = None
        self._beginning: FloatArray | None = None
        self._read = 0

    def usable(self, samples: FloatArray) -> bool:
        """Look at the next samples; tell whether there is anything in them."""
        if self.repeats_after is None:
            self._look_for_beginning(samples)
        self._read += len(samples)
        still = _still(samples)
        self.still += still
        if not still:
            self.gaps += _gaps(samples)
        return not still

    def _look_for_beginning(self, samples: FloatArray) -> None:
        first = self._beginning is None
        if self._beginning is None:
            self._beginning = samples[:_BEGINNING].copy()
        # the beginning itself is no copy
        again = _place_of(self._beginning, samples[1:] if first else samples)
        if again is not None:
            self.repeats_after = self._read + first + again


def _gaps(samples: FloatArray) -> int:
    """How often so many samples follow each other that are equal."""
    starts, ends = runs(np.diff(samples) == 0.0)
    return int(np.count_nonzero(ends - starts >= _GAP))


def _still(samples: FloatArray) -> bool:
    """Whether most samples only repeat the one before: silence, steps, a sensor that hangs."""
    return 2 * int(np.count_nonzero(np.diff(samples))) < len(samples) - 1


def _place_of(sequence: FloatArray, samples: FloatArray) -> int | None:
    """Where a sequence that changes comes in samples; None if nowhere."""
    count = len(sequence)
    if len(samples) < count or np.ptp(sequence) == 0.0:
        return None
    places = np.flatnonzero(samples[: len(samples) - count + 1] == sequence[0])
    for step in range(1, count):
        if len(places) == 0:
            return None
        places = places[samples[places + step] == sequence[step]]
    return int(places[0]) if len(places) else None
