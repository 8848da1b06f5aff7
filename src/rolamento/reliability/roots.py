"""Roots of functions that cross zero once, from below; many at a time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rolamento.numerics import BoolArray, FloatArray

ValueAndSlope = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


def rising_root(
    function: ValueAndSlope,
    start: FloatArray,
    lower: FloatArray,
    upper: FloatArray,
    *,
    tolerance: float = 1e-12,
    steps: int = 200,
) -> tuple[FloatArray, BoolArray]:
    """Root by Newton steps that shrink, inside a bracket that shrinks.

    A Newton step that leaves the bracket, or is more than half of the last step, is replaced by the
    middle of the bracket, or by twice the distance from `lower` while there is no upper end. So
    two steps that lead to and fro between two places end, as do steps along an exponential.

    Parameters
    ----------
    function : takes an array x, returns value and slope of that shape, element by element; the
        value is below zero before the root and above it behind, and need not rise everywhere.
    start, lower, upper : arrays of one shape, lower ≤ start ≤ upper; `upper` may be infinite.
    tolerance : relative size of the last step.
    steps : most evaluations.

    Returns
    -------
    x : array, NaN where not converged.
    converged : boolean array of that shape.
    """
    x = np.array(start, dtype=np.float64)
    low = np.broadcast_to(np.asarray(lower, dtype=np.float64), x.shape)
    high = np.broadcast_to(np.asarray(upper, dtype=np.float64), x.shape)
    origin = low
    last = np.full(x.shape, np.inf)
    converged = np.zeros(x.shape, dtype=np.bool_)
    for _ in range(steps):
        value, slope = function(x)
        low = np.where(value < 0.0, x, low)
        high = np.where(value > 0.0, x, high)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            newton = x - value / slope
            near = np.abs(newton - x) <= 0.5 * last
            middle = np.where(np.isinf(high), origin + 2.0 * (x - origin), 0.5 * (low + high))
        usable = near & (newton >= low) & (newton <= high)
        moved = np.where(usable, newton, middle)
        moved = np.where(value == 0.0, x, moved)
        last = np.abs(moved - x)
        settled = ~np.isnan(value) & np.isfinite(moved) & (last <= tolerance * np.abs(moved))
        x = np.where(converged, x, moved)
        converged = converged | settled
        if np.all(converged | np.isnan(value) | np.isinf(x)):
            break
    return np.where(converged, x, np.nan), converged
