"""Viscosity under pressure.

Both laws leave the viscosity without pressure as it is and rise from there with the slope α.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

_POLE_PRESSURE: Final = 1.0 / 5.1e-9
"""Pa: minus this is where all oils of Roelands meet …"""
_POLE_VISCOSITY: Final = 9.67
"""… in the viscosity e^-9.67 Pa·s = 6.3e-5 Pa·s."""


def barus(
    pressure: ArrayLike, viscosity: ArrayLike, pressure_viscosity_coefficient: ArrayLike
) -> FloatArray:
    """Dynamic viscosity η e^(α p); Pa·s.

    Parameters: arrays that broadcast; Pa, Pa·s at ambient pressure, 1/Pa. Returns the broadcast
    shape, infinite where it passes all numbers. Useless above about 0.5 GPa. Barus (1893);
    Campanha (2008) eq. 2.4.4.
    """
    with np.errstate(over="ignore"):
        return np.asarray(
            np.asarray(viscosity) * np.exp(np.multiply(pressure_viscosity_coefficient, pressure))
        )


def roelands(
    pressure: ArrayLike, viscosity: ArrayLike, pressure_viscosity_coefficient: ArrayLike
) -> FloatArray:
    """Dynamic viscosity by Roelands's law; Pa·s.

    Parameters: arrays that broadcast; Pa, Pa·s at ambient pressure, 1/Pa. Returns the broadcast
    shape. Roelands (1966): ln η_p = ln η + (ln η + 9.67) [(1 + 5.1e-9 p)^Z - 1], with the Z that
    gives the slope α: Z = α / (5.1e-9 (ln η + 9.67)).
    """
    height = np.log(viscosity) + _POLE_VISCOSITY
    exponent = np.asarray(pressure_viscosity_coefficient) * _POLE_PRESSURE / height
    growth = (1.0 + np.asarray(pressure, dtype=np.float64) / _POLE_PRESSURE) ** exponent - 1.0
    with np.errstate(over="ignore"):
        return np.asarray(np.asarray(viscosity) * np.exp(height * growth))
