"""Viscosity under pressure.

Both laws leave the viscosity without pressure as it is and rise from there with the slope α.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
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
    p, eta, alpha = _checked(pressure, viscosity, pressure_viscosity_coefficient, 0.0)
    with np.errstate(over="ignore"):
        return np.asarray(eta * np.exp(alpha * p))


def roelands(
    pressure: ArrayLike, viscosity: ArrayLike, pressure_viscosity_coefficient: ArrayLike
) -> FloatArray:
    """Dynamic viscosity by Roelands's law; Pa·s.

    Parameters: arrays that broadcast; Pa, Pa·s at ambient pressure, 1/Pa. Returns the broadcast
    shape. Roelands (1966): ln η_p = ln η + (ln η + 9.67) [(1 + 5.1e-9 p)^Z - 1], with the Z that
    gives the slope α: Z = α / (5.1e-9 (ln η + 9.67)). For η above the pole, 6.3e-5 Pa·s.
    """
    pole = float(np.exp(-_POLE_VISCOSITY))
    p, eta, alpha = _checked(pressure, viscosity, pressure_viscosity_coefficient, pole)
    height = np.log(eta) + _POLE_VISCOSITY
    with np.errstate(over="ignore"):
        growth = (1.0 + p / _POLE_PRESSURE) ** (alpha * _POLE_PRESSURE / height) - 1.0
        return np.asarray(eta * np.exp(height * growth))


def _checked(
    pressure: ArrayLike, viscosity: ArrayLike, coefficient: ArrayLike, thinnest: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    return (
        in_reach(pressure, "pressure", "Pa", 0.0, 1e12),
        in_reach(viscosity, "viscosity", "Pa·s", thinnest, 1e9, least_too=False),
        in_reach(coefficient, "pressure_viscosity_coefficient", "1/Pa", 0.0, 1e-3),
    )
