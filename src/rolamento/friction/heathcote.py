"""Friction of a contact that rolls on a curved band: Heathcote slip.

The contact lies on an arc of radius R, so only two lines of it roll; between them the surfaces
slip one way, outside the other way. Without a force along rolling, ∫ q sign(v) = 0 puts the lines
at x0 = ±k a with k³ - 3k + 1 = 0, k = 2 sin 10°, and the moment about the rolling axis is

    M_H = (3/8) μ Q (a²/R) ∫ (1 - s²) |s² - k²| ds  over -1 < s < 1

Sources: Heathcote (1921); Johnson, Contact Mechanics (1985), section 8.5; the pressure is
Hertz's, summed along the ellipse.
"""

from __future__ import annotations

from math import pi, sin
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.slip import Patch
from rolamento.numerics import FloatArray

ROLLING_LINE: Final = 2.0 * sin(pi / 18.0)
"""k = 0.347296: where the lines of pure rolling lie, as x0/a."""


def _primitive(s: float) -> float:
    """∫ (1 - s²)(s² - k²) ds."""
    k2 = ROLLING_LINE**2
    return (1.0 + k2) * s**3 / 3.0 - s**5 / 5.0 - k2 * s


MOMENT_COEFFICIENT: Final = 0.375 * 2.0 * (_primitive(1.0) - 2.0 * _primitive(ROLLING_LINE))
"""0.080571 in M_H = 0.080571 μ Q a²/R."""


def rolling_moment(patch: Patch, coefficient: ArrayLike) -> FloatArray:
    """Moment M_H about the axis of rolling; N·m.

    Parameters
    ----------
    patch : contacts, arrays (...).
    coefficient : μ, array that broadcasts; dimensionless.

    Returns
    -------
    M_H of the broadcast shape; 0 without load. The arc's sagitta is taken as x0²/(2R), which is
    off by (a/R)²/4 of itself at most.
    """
    squared = patch.semi_major**2 / patch.deformed_radius
    return np.asarray(MOMENT_COEFFICIENT * np.asarray(coefficient) * patch.load * squared)
