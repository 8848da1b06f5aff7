"""Numerical methods that know no bearings."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
ComplexArray = NDArray[np.complex128]
IntArray = NDArray[np.int64]

__all__ = ["BoolArray", "ComplexArray", "FloatArray", "IntArray"]
