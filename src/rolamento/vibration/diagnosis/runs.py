"""Neighbouring lines that are alike."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray

__all__ = ["runs"]


def runs(lines: BoolArray) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First places of runs of true values, and the places after their last."""
    edges = np.flatnonzero(np.diff(lines, prepend=False, append=False))
    return edges[::2], edges[1::2]
