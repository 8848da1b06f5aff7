"""A roller on a race: load, deflection, width and pressure of a line contact.

How far roller and race approach is not a matter of the contact's surroundings alone (a line on an
infinite body has no finite approach): it is taken from Palmgren's measurements, to which ISO/TS
16281 gives its constant,

    Q = c_L δ^(10/9),      c_L = 35948 L_we^(8/9) N/mm^(10/9),

for both contacts of a roller together, steel on steel. With δ and L_we both lengths the exponents
10/9 + 8/9 make 2, so that c_L/E' is a pure number: other materials scale it by their E', and this
is the only scaling that agrees with the dimensions. Width and pressure are those of Hertz's line
contact at the load per length of the place:

    b = √(8 q / (π E' Σρ)),      p0 = 2 q / (π b) = √(q E' Σρ / (2 π)).

Sources: ISO/TS 16281:2008; Palmgren (1959); Hertz (1881); Johnson, Contact Mechanics (1985),
section 4.2(c); ISO 76:2006 for the limit.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.hertz import ElasticMaterial, effective_modulus
from rolamento.numerics import FloatArray

__all__ = [
    "EXPONENT",
    "PRESSURE_LIMIT",
    "contact_constant",
    "half_width",
    "max_pressure",
    "pair_constant",
    "roller_share",
    "slice_places",
]

EXPONENT: Final = 10.0 / 9.0
"""Exponent of the deflection, in Q = c δ^(10/9)."""

PRESSURE_LIMIT: Final = 4.0e9
"""Pa: the pressure at which a roller and its race keep a permanent deformation of 0.0001 of the
roller's diameter together, by ISO 76:2006: the limit of plasticity in use for line contacts. The
first yielding beneath the surface begins far below (`contact.subsurface.line_von_mises`)."""

_ISO_STEEL: Final = 207e9 / (1.0 - 0.3**2)
"""E' of the steel that the standard means (as for its balls), 207 GPa and 0.3; Pa."""

_ISO_CONSTANT: Final = 35948e6 / _ISO_STEEL
"""c_L/(E' L^(8/9)), both contacts together: 0.1580. N/mm^(10/9)/mm^(8/9) is N/mm²."""


def pair_constant(effective_length: ArrayLike, modulus: ArrayLike) -> FloatArray:
    """Return c_L in Q = c_L δ^(10/9), δ being the approach of the two races of a roller.

    Parameters
    ----------
    effective_length : array, L_we; m.
    modulus : array that broadcasts with it, effective modulus E'; Pa.

    Returns
    -------
    c_L of the broadcast shape; N/m^(10/9). Divided by L_we it is the constant of a slice, which
    gives its load per length.

    ISO/TS 16281:2008, for steel; scaled by E'.
    """
    length = np.asarray(effective_length, dtype=np.float64)
    return np.asarray(_ISO_CONSTANT * np.asarray(modulus, np.float64) * length ** (8.0 / 9.0))


def contact_constant(effective_length: ArrayLike, modulus: ArrayLike) -> FloatArray:
    """Return c in Q = c δ^(10/9) of one contact of a roller with a race.

    Two of them in line, with one load, make c_L of `pair_constant`: c = 2^(10/9) c_L.

    Parameters and Returns: as `pair_constant`.
    """
    return np.asarray(2.0**EXPONENT * pair_constant(effective_length, modulus))


def half_width(load_per_length: ArrayLike, curvature: ArrayLike, modulus: ArrayLike) -> FloatArray:
    """Return the half width b of a line contact.

    Parameters
    ----------
    load_per_length : array, q ≥ 0; N/m.
    curvature : array, Σρ in the rolling direction, summed over both bodies; 1/m, positive.
    modulus : array, effective modulus E'; Pa.
        All broadcast against each other.

    Returns
    -------
    b of the broadcast shape; m. NaN for a negative load or curvature.

    Johnson (1985), eq. 4.43.

    >>> print(f"{1e6 * half_width(1e5, 200.0, 2.3e11):.1f} um")
    74.4 um
    """
    q, rho, e = (np.asarray(v, np.float64) for v in (load_per_length, curvature, modulus))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.sqrt(8.0 * q / (np.pi * e * rho)))


def max_pressure(
    load_per_length: ArrayLike, curvature: ArrayLike, modulus: ArrayLike
) -> FloatArray:
    """Return the maximum pressure p0 across the width of a line contact.

    Parameters and Returns: as `half_width`, in Pa.

    Johnson (1985), eq. 4.45.

    >>> print(f"{1e-6 * max_pressure(1e5, 200.0, 2.3e11):.0f} MPa")
    856 MPa
    """
    q, rho, e = (np.asarray(v, np.float64) for v in (load_per_length, curvature, modulus))
    with np.errstate(invalid="ignore"):
        return np.asarray(np.sqrt(q * e * rho / (2.0 * np.pi)))


def roller_share(roller: ElasticMaterial, ring: ElasticMaterial) -> float:
    """Return the part of the roller in the compliance 2/E' of the two bodies: ½ if they are alike.

    Parameters
    ----------
    roller, ring : materials, with E (Pa) and ν.
    """
    return (
        (1.0 - roller.poisson_ratio**2) / roller.youngs_modulus * effective_modulus(roller, ring)
    ) / 2.0


def slice_places(effective_length: ArrayLike, slices: int) -> FloatArray:
    """Return the middles of the slices of equal width into which a roller is cut.

    Parameters
    ----------
    effective_length : array of any shape, L_we; m.
    slices : how many; odd numbers have one in the middle.

    Returns
    -------
    x_k from the roller's middle, rising; m, of the shape (..., slices).
    """
    step = (2.0 * np.arange(slices) + 1.0 - slices) / (2.0 * slices)
    return np.asarray(np.asarray(effective_length, np.float64)[..., np.newaxis] * step)
