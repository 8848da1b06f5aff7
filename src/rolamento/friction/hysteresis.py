"""Elastic hysteresis: what the material does not give back when a contact rolls over it.

A part α_h of the work that the front half of the contact does is lost in the rear half:

    M_h = (3/16) α_h Q b        about the axis of rolling

(Greenwood, Minshall and Tabor 1961, for an ellipse with b along rolling.) α_h belongs to the
material; no primary value for bearing steel was found, and what is used ranges over 0.002 to
0.02. Kakuta (1961) writes 0.375 f_h Q b: his f_h is half of α_h.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.slip import Patch
from rolamento.friction.torque import ContactLoss
from rolamento.kinematics import BallMotion
from rolamento.numerics import FloatArray

DEFAULT_LOSS: Final = 0.01
"""α_h where none is given; 0.002 to 0.02 is found in use."""


def hysteresis_moment(patch: Patch, loss: ArrayLike = DEFAULT_LOSS) -> FloatArray:
    """Moment M_h about the axis of rolling; N·m.

    Parameters
    ----------
    patch : contacts, arrays (...).
    loss : α_h, array that broadcasts; dimensionless.

    Returns
    -------
    M_h of the broadcast shape.
    """
    return np.asarray(0.1875 * np.asarray(loss) * patch.load * patch.semi_minor)


def hysteresis_loss(balls: LoadedBalls, motion: BallMotion, loss: ArrayLike) -> ContactLoss:
    """Loss of every contact for the motion at a unit relative speed of the rings; N·m."""
    loaded = balls.loaded
    return ContactLoss(
        np.where(loaded, hysteresis_moment(balls.inner, loss) * np.abs(motion.inner_roll), 0.0),
        np.where(loaded, hysteresis_moment(balls.outer, loss) * np.abs(motion.outer_roll), 0.0),
    )
