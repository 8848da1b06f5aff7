"""Isothermal, fully flooded film of an elliptical contact.

Every group takes the radius R_x of the rolling direction, 1/R_x summed over both bodies with a
hollow negative, and k is the exact ratio of the semi-axes, across over along rolling:

    U = η u / (E' R_x)      W = Q / (E' R_x²)      G = α E'      H = h / R_x
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.numerics import FloatArray

COMPUTED_RANGE: Final[dict[str, tuple[float, float]]] = {
    "U": (8e-13, 5.1e-11),
    "W": (1.1e-7, 1.3e-6),
    "G": (2300.0, 6800.0),
    "k": (1.0, 8.0),
}
"""What the formulas were fitted to, rounded outward; rolling bearings mostly lie beyond in W."""


@dataclass(frozen=True, slots=True)
class FilmGroups:
    """Dimensionless groups of a contact; arrays of one shape."""

    speed: FloatArray
    """U"""
    load: FloatArray
    """W"""
    material: FloatArray
    """G"""
    ellipticity: FloatArray
    """k = a/b"""


def film_groups(
    entrainment_speed: ArrayLike,
    load: ArrayLike,
    rolling_curvature: ArrayLike,
    ellipticity: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity_coefficient: ArrayLike,
) -> FilmGroups:
    """Dimensionless groups U, W, G and k.

    Parameters
    ----------
    entrainment_speed, load : arrays; m/s, N.
    rolling_curvature : array, 1/R_x; 1/m.
    ellipticity : array, a/b.
    modulus : array, effective modulus E' (2/E' = Σ (1 - ν²)/E); Pa.
    viscosity, pressure_viscosity_coefficient : arrays, at the inlet; Pa·s, 1/Pa.
        All broadcast against each other.

    Raises
    ------
    InputError
        If a number is negative, not finite, or far beyond any contact.

    Hamrock and Dowson (1977).
    """
    u = in_reach(entrainment_speed, "entrainment_speed", "m/s", 0.0, 1e6)
    q = in_reach(load, "load", "N", 0.0, 1e12)
    curvature = in_reach(rolling_curvature, "rolling_curvature", "1/m", 1e-9, 1e12)
    e = in_reach(modulus, "modulus", "Pa", 1.0, 1e15)
    eta = in_reach(viscosity, "viscosity", "Pa·s", 0.0, 1e9)
    alpha = in_reach(
        pressure_viscosity_coefficient, "pressure_viscosity_coefficient", "1/Pa", 0.0, 1e-3
    )
    return FilmGroups(
        speed=np.asarray(eta * u * curvature / e),
        load=np.asarray(q * curvature**2 / e),
        material=np.asarray(alpha * e),
        ellipticity=in_reach(ellipticity, "ellipticity", "", 0.0, 1e9),
    )


def central_film(groups: FilmGroups) -> FloatArray:
    """Central film over R_x: 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k)).

    NaN without load. Hamrock and Dowson (1977), part III.
    """
    shape = 1.0 - 0.61 * np.exp(-0.73 * groups.ellipticity)
    return np.asarray(
        2.69 * groups.speed**0.67 * groups.material**0.53 * _loaded(groups) ** -0.067 * shape
    )


def minimum_film(groups: FilmGroups) -> FloatArray:
    """Minimum film over R_x: 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k)).

    NaN without load. Hamrock and Dowson (1977), part III.
    """
    shape = 1.0 - np.exp(-0.68 * groups.ellipticity)
    return np.asarray(
        3.63 * groups.speed**0.68 * groups.material**0.49 * _loaded(groups) ** -0.073 * shape
    )


def _loaded(groups: FilmGroups) -> FloatArray:
    return np.where(groups.load > 0.0, groups.load, np.nan)
