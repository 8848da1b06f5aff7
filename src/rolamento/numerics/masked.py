"""Arrays with some of their values masked."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

__all__ = ["filled"]


def filled(values: ArrayLike) -> FloatArray:
    """Return numbers as an array, with NaN where they are masked.

    What lies below a mask is no number: NumPy's own conversion would bring it to light.
    """
    if not isinstance(values, np.ma.MaskedArray):
        return np.asarray(values, dtype=np.float64)
    return np.asarray(np.ma.asarray(values, dtype=np.float64).filled(np.nan))
