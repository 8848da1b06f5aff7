"""What other materials of the rolling elements make of the ratings of a steel bearing.

The load at which a contact has a given pressure is proportional to 1/E'² of points, and to 1/E' of
lines (Hertz). C_0 and C_u are loads at a given pressure, so that with elements of another stiffness

    C_0 = C_0,steel (E'_steel/E')²   (points),   C_0,steel E'_steel/E'   (lines),

E' of the pair of element and ring, E'_steel that of two bodies of the rings' material. With balls
of silicon nitride (310 GPa, 0.26) in steel it is 0.71; catalogues of hybrid bearings list about 0.7
of the C_0 of their steel bearings. C itself stays: hybrid bearings live at least as long (abstract
of DIN ISO 281, supplement 5, replaced by DIN ISO 20056-1:2019). The standards of hybrid bearings,
ISO 20056, were not at hand: nothing here bears their name.
"""

from __future__ import annotations

from typing import Final

from rolamento.case.rolling_bearing import RollingBearing
from rolamento.contact.hertz import effective_modulus

__all__ = ["is_of_steel", "static_share"]

_ALIKE: Final = 0.1
"""Relative difference of Young's moduli up to which two materials count as one."""


def is_of_steel(bearing: RollingBearing) -> bool:
    """Whether the elements are as stiff as the rings, within a tenth.

    Parameters
    ----------
    bearing
        A row or a bearing.
    """
    ring, element = bearing.ring_material, bearing.element_material
    return abs(element.youngs_modulus / ring.youngs_modulus - 1.0) <= _ALIKE


def static_share(bearing: RollingBearing) -> float:
    """Return C_0 and C_u over those of the same bearing with elements of the rings' material.

    Parameters
    ----------
    bearing
        A row or a bearing; 1 where its elements are as stiff as its rings, within a tenth.

    Hertz, at the same pressure: (E'_steel/E')² of points, E'_steel/E' of lines.

    >>> from rolamento.case import case_of
    >>> f"{static_share(case_of('6310/HC5').bearing):.2f}"
    '0.71'
    """
    if is_of_steel(bearing):
        return 1.0
    ring, element = bearing.ring_material, bearing.element_material
    ratio = float(effective_modulus(ring, ring) / effective_modulus(element, ring))
    lines = bearing.bearing_type.has_rollers and not bearing.bearing_type.barrels
    return ratio if lines else ratio**2
