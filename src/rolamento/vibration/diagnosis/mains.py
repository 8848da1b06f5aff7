"""Lines of the electric supply, whose harmonics may lie where a part's are looked for."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray

__all__ = ["MAINS", "is_near_mains"]

MAINS: Final = (50.0, 60.0)
"""Hz."""
_OFF: Final = 0.001
"""Part by which a grid's frequency may be off."""
_LINES: Final = 1.5


def is_near_mains(hertz: FloatArray, resolution: float, mains: float) -> BoolArray:
    """Which frequencies are multiples of the mains', as far as lines so far apart can tell; Hz."""
    number = np.maximum(np.rint(hertz / mains), 1.0)
    return np.abs(hertz - number * mains) <= np.maximum(_LINES * resolution, _OFF * hertz)
