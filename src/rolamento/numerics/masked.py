"""Arrays with some of their values masked."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

__all__ = ["filled", "may_be_masked"]


def may_be_masked(values: Any) -> bool:
    """Return whether numbers may be masked; `numpy.ma` is imported by who made such an array."""
    return hasattr(values, "filled")


def filled(values: ArrayLike) -> FloatArray:
    """Return numbers as an array, with NaN where they are masked.

    What lies below a mask is no number: NumPy's own conversion would bring it to light.
    """
    if not may_be_masked(values):
        return np.asarray(values, dtype=np.float64)
    return np.asarray(np.ma.asarray(values, dtype=np.float64).filled(np.nan))
