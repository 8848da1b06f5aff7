"""The viscosity ratio κ: the oil's viscosity over the one that the bearing needs."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.numerics import FloatArray

_SLOW: Final = 1000.0 * (1.0 - 1e-9)
"""r/min below which the formula changes: 1000, and rounding of a speed in rad/s does not decide.
There ν_1 falls by 2.3 %; the formulas meet at 10^(100/33) = 1072 r/min."""


def reference_viscosity(speed: ArrayLike, pitch_diameter: ArrayLike) -> FloatArray:
    """Kinematic viscosity ν_1 that is needed for adequate lubrication; m²/s.

    Parameters
    ----------
    speed : array, of the rings against each other; rad/s, its size counts.
    pitch_diameter : array that broadcasts with it; m.

    Returns
    -------
    ν_1 of the broadcast shape: 45000 n^-0.83 D^-0.5 below 1000 r/min, 4500 n^-0.5 D^-0.5 from there
    on, in mm²/s, r/min and mm; infinite at rest.

    ISO 281:2007, 9.3.3.
    """
    n = np.abs(in_reach(speed, "speed", "rad/s", -1e9, 1e9)) * 30.0 / np.pi
    with np.errstate(divide="ignore"):
        slow, fast = 45000.0 * n**-0.83, 4500.0 * n**-0.5
    root = np.sqrt(in_reach(pitch_diameter, "pitch_diameter", "m", 1e-9, 1e3) * 1e3)
    return np.asarray(np.where(n < _SLOW, slow, fast) / root * 1e-6)


def viscosity_ratio(
    viscosity: ArrayLike, speed: ArrayLike, pitch_diameter: ArrayLike
) -> FloatArray:
    """Ratio κ = ν/ν_1 of kinematic viscosities; 0 at rest.

    Parameters: arrays that broadcast; m²/s, rad/s, m. Returns the broadcast shape.
    ISO 281:2007, 9.3.3.
    """
    nu = in_reach(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    return np.asarray(nu / reference_viscosity(speed, pitch_diameter))
