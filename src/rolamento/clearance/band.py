"""A value that lies between two limits."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["Band"]


class Band(NamedTuple):
    """Least and greatest value of a clearance or a deviation, in m."""

    low: float
    high: float

    @property
    def middle(self) -> float:
        """Half-way between the limits, in m."""
        return 0.5 * (self.low + self.high)
