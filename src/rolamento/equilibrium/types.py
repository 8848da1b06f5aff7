"""The shapes of numbers that the kernels pass to each other; for readers and type checkers."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Output: TypeAlias = tuple[NDArray[Any], ...]

Two: TypeAlias = tuple[float, float]
Three: TypeAlias = tuple[float, float, float]
Four: TypeAlias = tuple[float, float, float, float]
Six: TypeAlias = tuple[float, float, float, float, float, float]
Seven: TypeAlias = tuple[float, float, float, float, float, float, float]
Ten: TypeAlias = tuple[float, float, float, float, float, float, float, float, float, float]

Coefficients: TypeAlias = Seven
"""Of a contact's stiffness, a polynomial in cos a."""
Race: TypeAlias = tuple[float, Coefficients]
"""Free length L and stiffness of a contact."""
Motion: TypeAlias = Six
"""gamma', c_f, c_g, inner speed, outer speed, f_i D / R_i."""
Found: TypeAlias = tuple[bool, float, float]
"""Whether a ball's place was found, and X1, X2."""
Linearised: TypeAlias = tuple[Two, Six, Three, Six, float, Three]
"""Residual, step, force, stiffness, scale and touch of a ball (see `ball.linearised`)."""
StaticBall: TypeAlias = tuple[float, float, Three, Six, float, Three]
"""X1, X2, force, stiffness, scale and touch of a ball without inertia."""
