"""A value that lies between two limits."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

__all__ = ["Band", "Limit"]

Limit = Literal["minimum", "mean", "maximum"]


class Band(NamedTuple):
    """Least and greatest value of a clearance or a deviation, in m."""

    low: float
    high: float

    @property
    def middle(self) -> float:
        """Half-way between the limits, in m."""
        return 0.5 * (self.low + self.high)

    @property
    def mirrored(self) -> Band:
        """The limits in the other order, for what makes the clearance smaller as it grows."""
        return Band(self.high, self.low)

    def at(self, limit: Limit) -> Any:
        """The value at a limit, in m."""
        return {"minimum": self.low, "mean": self.middle, "maximum": self.high}[limit]
