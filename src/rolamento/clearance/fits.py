"""Press fits of a ring on a shaft and in a housing: Lamé's thick-walled cylinders.

Two cylinders of equal length, of the interference δ between them (on the diameter d), meet with

    p = δ / { (d/E_o) [(1 + q²)/(1 - q²) + ν_o] + (d/E_i) [(1 + k²)/(1 - k²) - ν_i] },

q = d over the outside of the outer part, k = bore of the inner part over d. The far side of each
part then moves by

    outside of the outer part:  + 2 p d q / (E_o (1 - q²))
    bore of the inner part:     - 2 p d k / (E_i (1 - k²)).

With one material this is ΔD = δ q (1 - k²)/(1 - q² k²), as makers print it. Plane stress; no
friction; the ring taken for a plain cylinder up to the bottom of its groove.

Sources: Lamé (1852); Timoshenko and Goodier, Theory of Elasticity, 3rd ed. (1970), section 28;
Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 3. Smoothing: DIN 7190-1:2017 (as MESYS
takes it); NSK, Rolling Bearings (E1102), chapter 9.1.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.clearance.tables import MILLIMETRE
from rolamento.contact.hertz import ElasticMaterial
from rolamento.numerics import FloatArray

__all__ = [
    "FIT_SOURCE",
    "Finish",
    "bore_shrinkage",
    "contact_pressure",
    "finish_loss",
    "outside_growth",
    "roughness_loss",
]

FIT_SOURCE: Final = "Lamé; Harris 1991, chapter 3"

Finish = Literal["ground", "turned"]
_FINISH_LENGTHS: Final[dict[Finish, float]] = {"ground": 2.0, "turned": 3.0}
"""mm in NSK's d/(d + 2) and d/(d + 3)."""
_ROUGHNESS_SHARE: Final = 0.4
"""Of Rz of both surfaces; the standard's edition of 2001 had 0.8."""


def contact_pressure(
    interference: ArrayLike,
    diameter: float,
    *,
    bore: float,
    outside: float,
    inner: ElasticMaterial,
    outer: ElasticMaterial,
) -> FloatArray:
    """Pressure between two cylinders pressed into each other; Pa.

    Parameters
    ----------
    interference
        δ on the diameter, in m; array. Where it is negative there is a gap, and no pressure.
    diameter
        d, in m.
    bore
        Of the inner part, in m; 0 if it is solid.
    outside
        Outside diameter of the outer part, in m; may be infinite.
    inner, outer
        Materials.
    """
    k, q = bore / diameter, diameter / outside
    compliance = diameter * (
        ((1.0 + q * q) / (1.0 - q * q) + outer.poisson_ratio) / outer.youngs_modulus
        + ((1.0 + k * k) / (1.0 - k * k) - inner.poisson_ratio) / inner.youngs_modulus
    )
    return np.asarray(np.maximum(interference, 0.0) / compliance)


def outside_growth(
    pressure: ArrayLike, diameter: float, outside: float, material: ElasticMaterial
) -> FloatArray:
    """Growth of the outside diameter of a cylinder under pressure in its bore; m."""
    q = diameter / outside
    return np.asarray(
        2.0 * np.asarray(pressure) * diameter * q / (material.youngs_modulus * (1.0 - q * q))
    )


def bore_shrinkage(
    pressure: ArrayLike, diameter: float, bore: float, material: ElasticMaterial
) -> FloatArray:
    """Shrinkage of the bore of a cylinder under pressure on its outside diameter; m."""
    k = bore / diameter
    return np.asarray(
        2.0 * np.asarray(pressure) * diameter * k / (material.youngs_modulus * (1.0 - k * k))
    )


def roughness_loss(interference: ArrayLike, roughness: float) -> FloatArray:
    """What pressing takes from an interference by smoothing the surfaces; m.

    Parameters
    ----------
    interference
        Before, in m; array.
    roughness
        Sum of the Rz of both surfaces, in m.

    0.4 Rz, and no more than there is. DIN 7190-1:2017.
    """
    return np.asarray(np.minimum(np.maximum(interference, 0.0), _ROUGHNESS_SHARE * roughness))


def finish_loss(interference: ArrayLike, diameter: float, finish: Finish) -> FloatArray:
    """What pressing takes from an interference, by the finish of the seat; m.

    δ - δ d/(d + 2 mm) for ground, δ - δ d/(d + 3 mm) for turned seats. NSK (E1102).
    """
    length = _FINISH_LENGTHS[finish] * MILLIMETRE
    return np.asarray(np.maximum(interference, 0.0) * length / (diameter + length))
