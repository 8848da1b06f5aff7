"""The sampling rate of a column of times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.errors import FileError
from rolamento.numerics import FloatArray

__all__ = ["SAME_RATE", "Timeline"]

SAME_RATE: Final = 1e-3
"""Part by which two statements of a sampling rate may differ: files round the step of time."""

_STEP_OFF: Final = 0.3
"""Of a step: what rounding to the file's digits may do to one. A sample left out does more."""
_PLACE_OFF: Final = 1.0
"""Of a step: how far an instant may lie from the straight line of its number."""


@dataclass(frozen=True, slots=True)
class Timeline:
    """Evenly spaced instants.

    Attributes
    ----------
    first
        instant of sample 0, in the column's unit
    step
        between samples, in the column's unit
    scale
        seconds in the column's unit
    """

    first: float
    step: float
    scale: float

    @classmethod
    def between(cls, first: float, last: float, count: int, scale: float, source: str) -> Timeline:
        """Return the even spacing between the first and the last instant of a column.

        Raises
        ------
        FileError
            If there are fewer than two, or time does not run forward.
        """
        with np.errstate(all="ignore"):
            step = float((np.float64(last) - first) / (count - 1)) if count > 1 else float("nan")
        if not 1e-12 < step * scale < 1e12:
            raise FileError(
                "does not run forward from its first row to its last",
                field="time column",
                example="0.0, 0.0001, 0.0002",
                source=source,
            )
        return cls(first, step, scale)

    @property
    def rate(self) -> float:
        """Hz."""
        return 1.0 / (self.step * self.scale)

    def check(self, times: FloatArray, start: int, source: str) -> None:
        """Refuse instants, of which the first is that of sample `start`, that are not even.

        Raises
        ------
        FileError
            If a sample is missing, doubled, or out of step.
        """
        with np.errstate(all="ignore"):
            place = (times - self.first) / self.step - (start + np.arange(len(times)))
            wrong = ~(np.abs(place) <= _PLACE_OFF)
            wrong[1:] |= ~(np.abs(np.diff(place)) <= _STEP_OFF)
        if np.any(wrong):
            number = int(np.argmax(wrong))
            raise FileError(
                f"is not evenly spaced: sample {start + number} (counted from 0) is off the mean "
                f"step of {self.step * self.scale:.6g} s; a sample is missing, or time was stored "
                "with too few digits",
                field="time column",
                value=float(times[number]),
                source=source,
            )
