"""Friction of a contact that spins about its normal and does nothing else."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.slip import Patch
from rolamento.kinematics import spin_resistance
from rolamento.numerics import FloatArray


def spin_moment(patch: Patch, coefficient: ArrayLike) -> FloatArray:
    """Moment M_s = (3/8) μ Q a E(m), m = 1 - (b/a)², about the normal; N·m.

    Parameters
    ----------
    patch : contacts, arrays (...).
    coefficient : μ, array that broadcasts; dimensionless.

    Returns
    -------
    M_s of the broadcast shape; 0 without load. Exact for Hertz pressure and Coulomb friction.

    Poritsky, Hewlett and Coleman (1947); Jones (1959).
    """
    touching = patch.load > 0.0
    ratio = np.where(touching, patch.semi_major, 1.0) / np.where(touching, patch.semi_minor, 1.0)
    moment = 0.375 * np.asarray(coefficient) * spin_resistance(patch.load, patch.semi_major, ratio)
    return np.asarray(moment)
