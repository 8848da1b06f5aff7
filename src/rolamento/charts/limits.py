"""Round limits of axes, which stay where they are while a slider moves a little."""

from __future__ import annotations

from math import ceil, floor, inf, isfinite, log10
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["decades", "reach", "rounded_up"]

_STEPS: Final = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_ROOM: Final = 1.03
_PARTS: Final = 5
"""Into which an axis that does not begin at zero is divided, at least."""


def rounded_up(value: float) -> float:
    """Return the least round number that is not below a positive one."""
    if not (isfinite(value) and value > 0.0):
        return 1.0
    power = 10.0 ** floor(log10(value))
    return next(step * power for step in _STEPS if step * power >= value * (1.0 - 1e-12))


def reach(*values: ArrayLike, zero: bool = False, least: float = 0.0) -> list[float]:
    """Return round limits with room for all values; zero: from there on; least: so far apart.

    They stay where they are while a slider moves a little.
    """
    found = np.concatenate([np.ravel(np.asarray(one, dtype=np.float64)) for one in values])
    found = found[np.isfinite(found)]
    if not found.size:
        return [0.0, 1.0]
    low, high = float(found.min()), float(found.max())
    if zero and low >= 0.0:
        return [0.0, rounded_up(_ROOM * high)]
    if zero:
        return [-rounded_up(-_ROOM * low), rounded_up(_ROOM * high) if high > 0.0 else 0.0]
    step = rounded_up(max(high - low, 1e-2 * max(abs(low), abs(high)), least, 1e-9) / _PARTS)
    room = 0.1 * step
    return [step * floor((low - room) / step), step * ceil((high + room) / step)]


def decades(*values: ArrayLike) -> list[float] | None:
    """Return the logarithms of round limits around all positive values; None without any."""
    least, greatest = inf, 0.0
    for one in values:
        found = np.asarray(one, dtype=np.float64)
        found = found[np.isfinite(found) & (found > 0.0)]
        if found.size:
            least, greatest = min(least, float(found.min())), max(greatest, float(found.max()))
    if not greatest:
        return None
    low, high = log10(least), log10(greatest)
    return [floor(2.0 * low - 0.1) / 2.0, ceil(2.0 * high + 0.1) / 2.0]
