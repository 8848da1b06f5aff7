"""The figures of the standards, from their data file, and checks of what callers give."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import numbers
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.words import said


def figures() -> dict[str, Any]:
    """Return the tables of data/iso281.toml; not to be changed."""
    return toml_of("iso281")


def positive(value: ArrayLike, field: str, *, zero: bool = False) -> FloatArray:
    """Return numbers above zero (or zero as well) as an array; NaN, no result, passes.

    Raises
    ------
    InputError
        If one is below.
    """
    array = numbers(value, field)
    low = array < 0.0 if zero else array <= 0.0
    if low.any():
        raise InputError(
            (said("must not be negative") if zero else said("must be positive")),
            field=field,
            value=float(array[low].flat[0]),
        )
    return array


def within(value: ArrayLike, field: str, least: float, most: float, example: str) -> FloatArray:
    """Return numbers of a closed range as an array.

    Raises
    ------
    InputError
        If one lies outside, or is not a number.
    """
    try:
        array = numbers(value, field)
    except InputError:
        array = np.asarray(np.nan)
    outside = ~((array >= least) & (array <= most))
    if outside.any():
        raise InputError(
            said("must be from {least:.6g} to {most:.6g}", least=least, most=most),
            field=field,
            value=value if array.ndim == 0 else float(array[outside].flat[0]),
            example=example,
        )
    return array
