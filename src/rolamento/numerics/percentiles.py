"""The one definition of a percentile of a sample that pages, figures and files share; a median."""

from __future__ import annotations

from math import nan

import numpy as np

from rolamento.numerics import FloatArray

__all__ = ["median", "percentile", "percentile_of_sorted"]

_OFFSET = 1.0 / 3.0


def percentile(values: FloatArray, percent: float) -> float:
    """Return the median-unbiased percentile of a sample.

    Parameters
    ----------
    values
        The sample, in any order; what is not finite is left out.
    percent
        Between 0 and 100.

    Returns
    -------
    float
        NaN where the percentile lies beyond the least or the greatest value, so that it takes a
        larger sample.

    Hyndman and Fan, The American Statistician 50 (1996) 361, definition 8, which they recommend:
    between the neighbours of the place p (n + 1/3) + 1/3, counted from 1, linear.
    """
    flat = np.asarray(values, dtype=np.float64).ravel()
    return percentile_of_sorted(np.sort(flat[np.isfinite(flat)]), percent)


def median(values: FloatArray) -> FloatArray:
    """Return the median along the last axis, (…,), of values without NaN.

    It is that of `numpy.median`, which takes ten times as long: it parts the values at two places,
    for which NumPy has no vector code, and looks for NaN.
    """
    middle = values.shape[-1] // 2
    parted = np.partition(values, middle, axis=-1)
    upper = parted[..., middle]
    if values.shape[-1] % 2 == 1:
        return np.asarray(upper)
    return np.asarray(0.5 * (np.max(parted[..., :middle], axis=-1) + upper))


def percentile_of_sorted(ordered: FloatArray, percent: float) -> float:
    """Return the percentile of finite values that rise, as `percentile` does."""
    last = len(ordered) - 1
    place = (len(ordered) + _OFFSET) * (percent / 100.0) - 2.0 * _OFFSET  # counted from 0
    if not 0.0 <= place <= last:
        return nan
    below = min(int(place), max(last - 1, 0))
    above = min(below + 1, last)
    return float(ordered[below] + (place - below) * (ordered[above] - ordered[below]))
