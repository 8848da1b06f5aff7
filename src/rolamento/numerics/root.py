"""Roots of increasing functions, many at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray

__all__ = ["MOST_EVALUATIONS", "ValueAndSlope", "increasing_root"]

ValueAndSlope = Callable[[FloatArray], tuple[FloatArray, FloatArray]]

_GUARDED_STEPS: Final = 100
_HALVINGS: Final = 70
"""64 separate any two numbers, the others look at the ends."""
MOST_EVALUATIONS: Final = _GUARDED_STEPS + _HALVINGS
_GREATEST: Final = float(np.finfo(np.float64).max)
_LEAST_BITS: Final = np.iinfo(np.int64).min


def increasing_root(
    function: ValueAndSlope,
    start: FloatArray,
    lower: FloatArray,
    upper: FloatArray,
    *,
    tolerance: float = 1e-14,
) -> tuple[FloatArray, BoolArray]:
    """Root by Newton steps that shrink, inside a bracket that shrinks.

    A Newton step that leaves the bracket, or is more than half of the last step, is replaced by the
    middle of the bracket, or by twice the distance from `lower` while there is no upper end. So
    two steps that lead to and fro between two places end, as do steps along an exponential. What
    is not found in this way is found by halving all the numbers that there are between the ends,
    which ends whatever the function: there are never more than `MOST_EVALUATIONS`.

    The slope sets the pace, not the answer: it may be approximate, zero or NaN. But a step that it
    makes smaller than the tolerance is believed to be the last.

    Parameters
    ----------
    function : takes an array x, returns value and slope of that shape, element by element; the
        value is below zero before the root and above it behind, and need not rise everywhere. It
        may overflow far from the root; a NaN is the end of the search.
    start, lower, upper : arrays of one shape, lower ≤ start ≤ upper; `upper` may be infinite.
    tolerance : relative size of the last step, or of the last bracket.

    Returns
    -------
    x : array, NaN where there is no root: where the value has one sign from end to end, or is NaN.
    found : boolean array of that shape.
    """
    x = np.array(start, dtype=np.float64)
    bracket = _Bracket.of(lower, upper, x.shape)
    last = np.full(x.shape, np.inf)
    found, lost = np.zeros(x.shape, dtype=np.bool_), np.zeros(x.shape, dtype=np.bool_)
    for step in range(MOST_EVALUATIONS):
        with np.errstate(all="ignore"):
            value, slope = function(x)
            newton = np.where(slope > 0.0, x - value / slope, np.nan)
            length = np.abs(newton - x)
            small = np.isfinite(slope) & (length <= tolerance * np.abs(x))
        outside = bracket.is_outside(x, value)
        bracket = bracket.narrowed(x, value)
        if step < _GUARDED_STEPS:
            middle = bracket.middle(x)
            usable = np.isfinite(newton) & np.isfinite(slope) & (length <= 0.5 * last)
            usable = usable & (newton >= bracket.low) & (newton <= bracket.high)
        else:
            middle, usable = bracket.number_between(), small
        tight = bracket.is_tight(middle, tolerance)
        moved = np.where(usable, newton, np.where(tight, bracket.unseen_end(middle), middle))
        moved = np.where(small, np.clip(newton, bracket.low, bracket.high), moved)
        moved = np.where(value == 0.0, x, moved)
        last = np.abs(moved - x)
        settled = small | (value == 0.0) | (tight & bracket.low_seen & bracket.high_seen)
        x = np.where(found | lost, x, moved)
        lost = lost | ~found & (np.isnan(value) | outside & ~settled)
        found = found | settled & ~lost
        if np.all(found | lost):
            break
    return np.where(found, x, np.nan), found


class _Bracket(NamedTuple):
    """Where the roots may be, and whether the signs of the values at the ends have been seen."""

    origin: FloatArray
    """The lower ends that were given."""
    low: FloatArray
    high: FloatArray
    low_seen: BoolArray
    high_seen: BoolArray

    @classmethod
    def of(cls, lower: FloatArray, upper: FloatArray, shape: tuple[int, ...]) -> _Bracket:
        low = np.broadcast_to(np.asarray(lower, dtype=np.float64), shape)
        high = np.broadcast_to(np.asarray(upper, dtype=np.float64), shape)
        unseen = np.zeros(shape, dtype=np.bool_)
        return cls(low, low, high, unseen, unseen)

    def is_outside(self, x: FloatArray, value: FloatArray) -> BoolArray:
        """Return whether a value at an end says that the root lies beyond it."""
        before = (value > 0.0) & (x <= self.low) & ~self.low_seen
        return np.asarray(before | (value < 0.0) & (x >= self.high) & ~self.high_seen)

    def narrowed(self, x: FloatArray, value: FloatArray) -> _Bracket:
        below, above = value < 0.0, value > 0.0
        return _Bracket(
            self.origin,
            np.where(below, x, self.low),
            np.where(above, x, self.high),
            self.low_seen | below,
            self.high_seen | above,
        )

    def middle(self, x: FloatArray) -> FloatArray:
        """Middle, or twice as far from the origin while there is no upper end."""
        step = np.where(x > self.origin, x - self.origin, np.maximum(np.abs(x), 1.0))
        with np.errstate(over="ignore"):
            farther = np.minimum(x + step, _GREATEST)
        return np.where(np.isinf(self.high), farther, 0.5 * self.low + 0.5 * self.high)

    def number_between(self) -> FloatArray:
        """Number with as many numbers below as above it, down to the lower end."""
        low, high = _ordinal(self.low), _ordinal(self.high)
        between = (low >> 1) + (high >> 1) + (low & high & 1)
        return _ordinal(between.view(np.float64)).view(np.float64)

    def is_tight(self, middle: FloatArray, tolerance: float) -> BoolArray:
        """Return whether the ends lie as near as they should, or nothing is between them."""
        width = self.high - self.low
        near = width <= tolerance * np.abs(middle)
        return np.asarray(near | (middle <= self.low) | (middle >= self.high))

    def unseen_end(self, otherwise: FloatArray) -> FloatArray:
        """End whose value has not been seen, the lower one first."""
        upper = np.where(~self.high_seen & np.isfinite(self.high), self.high, otherwise)
        return np.where(self.low_seen, upper, self.low)


def _ordinal(x: FloatArray) -> NDArray[np.int64]:
    """Whole numbers in the order of the floating-point numbers; its own inverse on their bits."""
    bits = np.asarray(x, dtype=np.float64).view(np.int64)
    return np.where(bits < 0, _LEAST_BITS - bits, bits)
