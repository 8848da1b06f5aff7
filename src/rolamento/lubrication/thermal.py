"""What the heat of shear in the inlet leaves of the film.

Both take the loading parameter L = η b u²/k_f with b = -d ln η/dT at the inlet.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.numerics import FloatArray


def thermal_loading(
    viscosity: ArrayLike,
    viscosity_temperature_coefficient: ArrayLike,
    entrainment_speed: ArrayLike,
    thermal_conductivity: ArrayLike,
) -> FloatArray:
    """Loading parameter L = η b u²/k_f; dimensionless.

    Parameters: arrays that broadcast; Pa·s, 1/K, m/s, W/(m·K). Returns the broadcast shape.
    Raises InputError if a number is negative, not finite, or far beyond any oil.
    """
    eta = in_reach(viscosity, "viscosity", "Pa·s", 0.0, 1e9)
    falling = in_reach(
        viscosity_temperature_coefficient, "viscosity_temperature_coefficient", "1/K", 0.0, 1e3
    )
    u = in_reach(entrainment_speed, "entrainment_speed", "m/s", 0.0, 1e6)
    conductivity = in_reach(thermal_conductivity, "thermal_conductivity", "W/(m·K)", 1e-6, 1e6)
    return np.asarray(eta * falling * u**2 / conductivity)


def murch_wilson(loading: ArrayLike) -> FloatArray:
    """Share of the film that is left, 3.94/(3.94 + L^0.62); at most 1.

    Parameters: L, array, at least 0. Returns its shape. Murch and Wilson (1975), for rolling.
    """
    return np.asarray(3.94 / (3.94 + in_reach(loading, "loading", "", 0.0, 1e40) ** 0.62))


def gupta_cheng(
    loading: ArrayLike, max_pressure: ArrayLike, modulus: ArrayLike, slide_to_roll: ArrayLike
) -> FloatArray:
    """Share of the film that is left under load and sliding; at least 0.

    Parameters
    ----------
    loading : array, L.
    max_pressure, modulus : arrays, Hertz pressure and E'; Pa.
    slide_to_roll : array, sliding over entrainment speed.
        All broadcast against each other.

    Gupta, Cheng, Zhu, Forster and Schrand (1992):
    (1 - 13.2 (p_0/E') L^0.42) / (1 + 0.213 (1 + 2.23 S^0.83) L^0.64).
    """
    loading = in_reach(loading, "loading", "", 0.0, 1e40)
    pressure = in_reach(max_pressure, "max_pressure", "Pa", 0.0, 1e15)
    modulus = in_reach(modulus, "modulus", "Pa", 1.0, 1e15)
    strained = 1.0 - 13.2 * pressure / modulus * loading**0.42
    sliding = 1.0 + 2.23 * in_reach(slide_to_roll, "slide_to_roll", "", 0.0, 1e40) ** 0.83
    return np.asarray(np.maximum(strained, 0.0) / (1.0 + 0.213 * sliding * loading**0.64))
