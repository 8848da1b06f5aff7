"""What press fits, temperature and rotation do to the clearance of a bearing and to its seats.

Press fits of a ring on a shaft and in a housing: Lamé's thick-walled cylinders.

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

What temperatures do to clearance and interference, for parts that expand freely.

Each part has one temperature. With raceways d_i and d_e, balls D and the temperatures counted from
the one at which everything was measured,

    ΔP_d = α_r T_e d_e - α_r T_i d_i - 2 α_b T_b D.

With one material, and the balls as warm as the inner ring, this is -α (T_i - T_e) d_e, but for the
clearance itself, which is nothing beside d_e: the rule of makers, who put (4 D + d)/5 for d_e.

Sources: NSK, Rolling Bearings (E1102), chapter 9.2; Harris, Rolling Bearing Analysis, 3rd ed.
(1991), chapter 3.

Growth of a ring by its own rotation: a spinning annulus, plane stress.

A part of bore 2a and outside diameter 2b moves outward at radius r by

    u = ρ ω² r / (8 E) · { (1 - ν)(3 + ν)(a² + b²) + (1 + ν)(3 + ν) a² b²/r² - (1 - ν²) r² };

a = 0 is a solid shaft. A fit that both parts leave with different growth loses the difference of
its interference.

Source: Timoshenko and Goodier, Theory of Elasticity, 3rd ed. (1970), section 32.
"""

from __future__ import annotations

from typing import Final, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.material import Material
from rolamento.contact.hertz import ElasticMaterial
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.units import MILLIMETRE
from rolamento.words import said

Finish = Literal["ground", "turned"]
_FINISH_LENGTHS: Final[dict[Finish, float]] = {"ground": 2.0, "turned": 3.0}
"""mm in NSK's d/(d + 2) and d/(d + 3)."""
_ROUGHNESS_SHARE: Final = 0.4
"""Fraction of Rz of both surfaces; the standard's edition of 2001 had 0.8."""


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


EXPANSION_100CR6: Final = 12.5e-6
"""Coefficient of thermal expansion of bearing steel; 1/K. NSK, Rolling Bearings (catalogue
E1102), on the internal clearance."""


def clearance_change(
    *,
    inner_raceway: float,
    outer_raceway: float,
    ball_diameter: float,
    inner_rise: ArrayLike,
    outer_rise: ArrayLike,
    ball_rise: ArrayLike,
    ring_expansion: float,
    ball_expansion: float,
) -> FloatArray:
    """Change of the diametral clearance as rings and balls warm up; m.

    Parameters
    ----------
    inner_raceway, outer_raceway, ball_diameter
        d_i and d_e at the bottom of the grooves, D; m.
    inner_rise, outer_rise, ball_rise
        Of the temperatures; K, arrays that broadcast.
    ring_expansion, ball_expansion
        Coefficients of linear expansion; 1/K.
    """
    rings = ring_expansion * (
        np.asarray(outer_rise) * outer_raceway - np.asarray(inner_rise) * inner_raceway
    )
    return np.asarray(rings - 2.0 * ball_expansion * np.asarray(ball_rise) * ball_diameter)


def clearance_change_of_rings(
    outer_raceway: float, difference: ArrayLike, expansion: float = EXPANSION_100CR6
) -> FloatArray:
    """Change of the diametral clearance by the makers' rule, -α ΔT d_e; m.

    Parameters
    ----------
    outer_raceway
        d_e, in m: d_m + D, or `catalogue_outer_raceway`.
    difference
        ΔT, inner ring less outer; K, array. The balls are as warm as the inner ring.
    expansion
        Of rings and balls; 1/K.
    """
    return np.asarray(-expansion * outer_raceway * np.asarray(difference, dtype=np.float64))


def catalogue_outer_raceway(bore: float, outside_diameter: float) -> float:
    """Diameter of the outer raceway by the makers' rule for ball bearings, (4 D + d)/5; m.

    >>> print(f"{1e3 * catalogue_outer_raceway(0.05, 0.11):.1f} mm")
    98.0 mm
    """
    return (4.0 * outside_diameter + bore) / 5.0


def interference_change(
    diameter: float,
    *,
    inner_expansion: float,
    inner_rise: float,
    outer_expansion: float,
    outer_rise: float,
) -> float:
    """Change of the interference of two parts on one diameter as they warm up; m.

    The inner part (shaft, or outer ring) makes it grow, the outer one (inner ring, or housing)
    makes it less. Rises in K, expansions in 1/K, diameter in m.
    """
    return diameter * (inner_expansion * inner_rise - outer_expansion * outer_rise)


def expansion_of(material: Material, field: str) -> float:
    """Coefficient of linear expansion of a named material of rings or balls; 1/K.

    Raises
    ------
    InputError
        If none is on file, naming the field that gives it.
    """
    known = toml_of("expansion", "rolamento.clearance")
    if material.name not in known:
        raise InputError(
            said(
                "is missing: the thermal expansion of {name} is not on file, only that of {known}",
                name=material.name,
                known=", ".join(known),
            ),
            field=field,
            example=f'{field.rpartition(".")[2]} = "12.5e-6 1/K"',
        )
    return float(known[material.name]["expansion"])


class SpinningMaterial(Protocol):
    """What the rotation reads of a material."""

    @property
    def youngs_modulus(self) -> float:
        """E; Pa."""
        ...

    @property
    def poisson_ratio(self) -> float:
        """ν."""
        ...

    @property
    def density(self) -> float:
        """ρ; kg/m³."""
        ...


def spin_growth(
    speed: ArrayLike, diameter: float, *, bore: float, outside: float, material: SpinningMaterial
) -> FloatArray:
    """Growth of a diameter of a spinning annulus, free on both sides; m.

    Parameters
    ----------
    speed
        ω, in rad/s; array.
    diameter
        Where, from bore to outside; m.
    bore, outside
        Of the annulus, in m; a bore of 0 is solid.
    material
        A `SpinningMaterial`.
    """
    nu = material.poisson_ratio
    a, b, r = 0.5 * bore, 0.5 * outside, 0.5 * diameter
    shape = (
        (1.0 - nu) * (3.0 + nu) * (a * a + b * b)
        + (1.0 + nu) * (3.0 + nu) * (a * b / r) ** 2
        - (1.0 - nu * nu) * r * r
    )
    omega = np.asarray(speed, dtype=np.float64)
    return np.asarray(
        material.density * omega**2 * diameter * shape / (8.0 * material.youngs_modulus)
    )
