"""The exponential of a small matrix.

`scipy.linalg.expm` starts the threads of its BLAS even for nine rows, which takes a thousand times
as long as the arithmetic where other work runs beside it.
"""

from __future__ import annotations

from math import ceil, log2
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.words import said

__all__ = ["exponential"]

_TERMS: Final = 14
_LARGEST: Final = 0.5
"""Norm of the scaled matrix: 0.5^15/15! is below the rounding of doubles."""
_MOST_SQUARINGS: Final = 200


def exponential(matrix: FloatArray) -> FloatArray:
    """Return exp(M) of a small square matrix by scaling, a Taylor sum and squaring.

    Parameters
    ----------
    matrix
        (n, n), finite.

    Returns
    -------
    (n, n)

    Raises
    ------
    InputError
        If it is not finite, or its norm is above 2^200.

    Moler and Van Loan, SIAM Review 45 (2003), 3, method 3.

    >>> print(exponential(np.array([[0.0, 1.0], [0.0, 0.0]])))
    [[1. 1.]
     [0. 1.]]
    """
    size = float(np.abs(matrix).sum(axis=1).max())
    squarings = max(0, ceil(log2(size / _LARGEST))) if size > 0.0 and np.isfinite(size) else 0
    if not np.isfinite(size) or squarings > _MOST_SQUARINGS:
        raise InputError(said("must be a finite number"), field="matrix", value=size)
    scaled = matrix / 2.0**squarings
    one = np.eye(len(matrix))
    found = one
    for term in range(_TERMS, 0, -1):
        found = one + scaled @ found / term
    for _ in range(squarings):
        found = found @ found
    return found
