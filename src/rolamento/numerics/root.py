"""Roots of increasing functions, many at a time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rolamento.numerics import BoolArray, FloatArray

ValueAndSlope = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


def increasing_root(
    function: ValueAndSlope,
    start: FloatArray,
    lower: FloatArray,
    upper: FloatArray,
    *,
    tolerance: float = 1e-14,
    steps: int = 300,
) -> tuple[FloatArray, BoolArray]:
    """Root of an increasing function by Newton steps kept inside a shrinking bracket.

    A Newton step that leaves the bracket is replaced by its middle, or by twice the distance
    from `lower` while `upper` is infinite. The slope may be approximate: it sets the pace, not
    the answer.

    Parameters
    ----------
    function : takes an array x, returns value and slope of the same shape, element by element.
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
    converged = np.zeros(x.shape, dtype=np.bool_)
    for _ in range(steps):
        value, slope = function(x)
        low = np.where(value < 0.0, x, low)
        high = np.where(value > 0.0, x, high)
        with np.errstate(divide="ignore", invalid="ignore"):
            newton = x - value / slope
        middle = np.where(np.isinf(high), origin + 2.0 * (x - origin), 0.5 * (low + high))
        usable = np.isfinite(newton) & (newton >= low) & (newton <= high)
        moved = np.where(usable, newton, middle)
        moved = np.where(value == 0.0, x, moved)
        settled = np.isfinite(value) & (np.abs(moved - x) <= tolerance * np.abs(moved))
        x = np.where(converged, x, moved)
        converged = converged | settled
        if np.all(converged | ~np.isfinite(value)):
            break
    return np.where(converged, x, np.nan), converged
