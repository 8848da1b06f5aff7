"""Formulas of many numbers, each by itself: by NumPy as they are written, or as one compiled loop.

NumPy carries an array to the processor and back for every operation, which takes longer than the
operation; a loop over the whole formula takes a tenth to a twentieth of the time. In it only
arithmetic and roots become vector instructions: logarithms and powers are better left to NumPy.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import Kernel, at_hand
from rolamento.numerics.threads import goes_plainly, ready

__all__ = ["MANY", "of_each"]

MANY: Final = 4096
"""Numbers from which a compiled loop is worth finding."""


def of_each(
    formula: Kernel[..., tuple[Any, ...]],
    loop: Kernel[..., None],
    count: int,
    *arrays: NDArray[Any],
) -> tuple[FloatArray, ...]:
    """Return what a formula makes of each number, the same to the last bit either way.

    Parameters
    ----------
    formula
        Of numbers or arrays alike, `inline_exact`; returns a tuple.
    loop
        A `kernel` that fills the rows of its last argument, (count, numbers), with it.
    count
        What the formula returns.
    arrays
        They broadcast against each other.

    Returns
    -------
    Arrays of the broadcast shape. The loop runs where a process has the compiler: over many
    numbers, and over few where it is loaded.
    """
    whole = np.broadcast(*arrays)
    if not at_hand() or goes_plainly(loop, little=whole.size < MANY):
        return formula(*arrays)
    out = np.empty((count, whole.size))
    ready(loop)(*(_flat(array, whole.shape) for array in arrays), out)
    return tuple(out.reshape(count, *whole.shape))


def _flat(array: NDArray[Any], shape: tuple[int, ...]) -> FloatArray:
    if array.shape == shape:
        return np.ascontiguousarray(array, np.float64).reshape(-1)
    whole = np.empty(shape)
    whole[...] = array
    return whole.reshape(-1)
