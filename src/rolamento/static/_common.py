"""What the closed analyses share: how each ended."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray

StatusArray = NDArray[np.int64]


class StaticStatus(IntEnum):
    """How a closed analysis ended; anything but CONVERGED comes with NaN."""

    CONVERGED = 0
    NOT_CONVERGED = 1
    INVALID_LOAD = 2
    """A load that is NaN, infinite, or negative where only its size is asked for."""
    NO_EQUILIBRIUM = 3
    """The bearing cannot carry this load: a one-sided bearing pulled apart, or too much radial
    for the axial load."""


def status_codes(converged: BoolArray, valid: BoolArray, supported: BoolArray) -> StatusArray:
    """Status of each case; the gravest reason wins."""
    status = np.where(converged, StaticStatus.CONVERGED, StaticStatus.NOT_CONVERGED)
    status = np.where(supported, status, StaticStatus.NO_EQUILIBRIUM)
    return np.asarray(np.where(valid, status, StaticStatus.INVALID_LOAD), dtype=np.int64)
