"""What temperatures do to clearance and interference, for parts that expand freely.

Each part has one temperature. With raceways d_i and d_e, balls D and the temperatures counted from
the one at which everything was measured,

    ΔP_d = α_r T_e d_e - α_r T_i d_i - 2 α_b T_b D.

With one material, and the balls as warm as the inner ring, this is -α (T_i - T_e) d_e, but for the
clearance itself, which is nothing beside d_e: the rule of makers, who put (4 D + d)/5 for d_e.

Sources: NSK, Rolling Bearings (E1102), chapter 9.2; Harris, Rolling Bearing Analysis, 3rd ed.
(1991), chapter 3.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.material import Material
from rolamento.clearance.tables import table
from rolamento.errors import InputError
from rolamento.numerics import FloatArray

__all__ = [
    "EXPANSION_100CR6",
    "TEMPERATURE_SOURCE",
    "catalogue_outer_raceway",
    "clearance_change",
    "clearance_change_of_rings",
    "expansion_of",
    "interference_change",
]

EXPANSION_100CR6: Final = 12.5e-6
"""Coefficient of thermal expansion of bearing steel; 1/K. NSK, Rolling Bearings (catalogue
E1102), on the internal clearance."""

TEMPERATURE_SOURCE: Final = "free expansion; NSK E1102, chapter 9.2"


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
    """Diameter of the outer raceway by the makers' rule for ball bearings, (4 D + d)/5; m."""
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
    known = table("expansion")
    if material.name not in known:
        raise InputError(
            f"is missing: no expansion is on file for {material.name}, only for {', '.join(known)}",
            field=field,
            example=f'{field.rpartition(".")[2]} = "12.5e-6 1/K"',
        )
    return float(known[material.name]["expansion"])
