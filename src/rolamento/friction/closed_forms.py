"""Friction of a contact that spins, or rolls on a curved band, and elastic hysteresis.

Spin: a contact that spins about its normal and does nothing else is held back by

    M_s = (3/8) μ Q a E(m),   m = 1 - (b/a)²

exact for Hertz pressure and Coulomb friction (Poritsky, Hewlett and Coleman 1947; Jones 1959).

Heathcote slip: a rolling contact lies on an arc of radius R, so only two lines of it roll; between
them the surfaces slip one way, outside the other way. Without a force along rolling,
∫ q sign(v) = 0 puts the lines at x0 = ±k a with k³ - 3k + 1 = 0, k = 2 sin 10°, and the moment
about the rolling axis is

    M_H = (3/8) μ Q (a²/R) ∫ (1 - s²) |s² - k²| ds  over -1 < s < 1

(Heathcote 1921; Johnson, Contact Mechanics, 1985, section 8.5; the pressure is Hertz's, summed
along the ellipse).

Elastic hysteresis: a part α_h of the work that the front half of the contact does is lost in the
rear half:

    M_h = (3/16) α_h Q b        about the axis of rolling

(Greenwood, Minshall and Tabor 1961, for an ellipse with b along rolling.) α_h belongs to the
material; no primary value for bearing steel was found, and what is used ranges over 0.002 to
0.02. Kakuta (1961) writes 0.375 f_h Q b: his f_h is half of α_h.
"""

from __future__ import annotations

from math import pi, sin
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.slip import Patch
from rolamento.numerics import FloatArray
from rolamento.solved import Contacts

DEFAULT_HYSTERESIS: Final = 0.01
"""α_h where none is given; 0.002 to 0.02 is found in use."""

ROLLING_LINE: Final = 2.0 * sin(pi / 18.0)
"""k = 0.347296: where the lines of pure rolling lie, as x0/a."""


def _primitive(s: float) -> float:
    """∫ (1 - s²)(s² - k²) ds."""
    k2 = ROLLING_LINE**2
    return (1.0 + k2) * s**3 / 3.0 - s**5 / 5.0 - k2 * s


MOMENT_COEFFICIENT: Final = 0.375 * 2.0 * (_primitive(1.0) - 2.0 * _primitive(ROLLING_LINE))
"""0.080571 in M_H = 0.080571 μ Q a²/R."""


def spin_moment(patch: Patch | Contacts, coefficient: ArrayLike) -> FloatArray:
    """Moment M_s about the normal; N·m.

    Parameters
    ----------
    patch : contacts, arrays (...).
    coefficient : μ, array that broadcasts; dimensionless.

    Returns
    -------
    M_s of the broadcast shape; 0 without load.
    """
    return np.asarray(0.375 * np.asarray(coefficient) * patch.resistance_to_spin)


def rolling_moment(patch: Patch, coefficient: ArrayLike) -> FloatArray:
    """Moment M_H of Heathcote slip about the axis of rolling; N·m.

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


def hysteresis_moment(patch: Patch | Contacts, loss: ArrayLike = DEFAULT_HYSTERESIS) -> FloatArray:
    """Moment M_h of elastic hysteresis about the axis of rolling; N·m.

    Parameters
    ----------
    patch : contacts, arrays (...).
    loss : α_h, array that broadcasts; dimensionless.

    Returns
    -------
    M_h of the broadcast shape.
    """
    return np.asarray(0.1875 * np.asarray(loss) * patch.load * patch.semi_minor)
