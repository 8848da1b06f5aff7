"""The pressure-viscosity coefficient α where nobody has measured it.

Two correlations of mineral oils. Neither is meant for other fluids: give the measured value.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.numerics import FloatArray


def wooster(dynamic_viscosity: ArrayLike) -> FloatArray:
    """Coefficient α = (0.6 + 0.965 log10 η) 10⁻⁸, η in mPa·s; 1/Pa.

    Parameters: dynamic viscosity at the temperature in question, array; Pa·s. Returns its shape.
    Wooster, in Hutchings (1992); Campanha (2008) eq. 4.4.1.
    """
    eta = in_reach(dynamic_viscosity, "dynamic_viscosity", "Pa·s", 1e-9, 1e9)
    return np.asarray((0.6 + 0.965 * np.log10(eta * 1e3)) * 1e-8)


def so_klaus(kinematic_viscosity: ArrayLike, density: ArrayLike, slope: ArrayLike) -> FloatArray:
    """Coefficient α from viscosity, density and the steepness of viscosity over temperature; 1/Pa.

    Parameters
    ----------
    kinematic_viscosity, density : arrays, at the temperature in question; m²/s, kg/m³.
    slope : array, of the oil's line by ASTM D341.
        All broadcast against each other.

    Returns
    -------
    α of the broadcast shape, NaN below 1 mm²/s.

    So and Klaus (1980): with s = log10 ν in mm²/s, ρ in g/cm³, α in 10⁻⁸/Pa,
    1.216 + 4.143 s^3.0627 + 2.848e-4 B^5.1903 s^1.5976 - 3.999 s^3.0975 ρ^0.1162.
    """
    s = np.log10(in_reach(kinematic_viscosity, "kinematic_viscosity", "m²/s", 1e-12, 1e6) * 1e6)
    s = np.where(s >= 0.0, s, np.nan)
    rho = in_reach(density, "density", "kg/m^3", 0.0, 1e6) * 1e-3
    steep = in_reach(slope, "slope", "", 0.0, 1e6)
    return np.asarray(
        1e-8
        * (
            1.216
            + 4.143 * s**3.0627
            + 2.848e-4 * steep**5.1903 * s**1.5976
            - 3.999 * s**3.0975 * rho**0.1162
        )
    )
