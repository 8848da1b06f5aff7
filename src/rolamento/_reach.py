"""Numbers that a formula takes: what lies beyond is refused by name, before it overflows."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.words import said

__all__ = ["in_reach", "numbers"]


def numbers(value: ArrayLike, field: str) -> FloatArray:
    """Return numbers as an array.

    Raises
    ------
    InputError
        If it is neither a number nor an array of them.
    """
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(
            said("must be a number or an array of numbers"),
            field=field,
            value=value,
            example=f"{field} = 1.0",
        ) from None


def in_reach(
    value: ArrayLike, field: str, unit: str, least: float, most: float, *, least_too: bool = True
) -> FloatArray:
    """Return numbers as an array; NaN, no result, passes.

    Parameters
    ----------
    value
        Array of any shape.
    field, unit
        What it is, for the message.
    least, most
        What it may be: far beyond what occurs, so that nothing overflows.
    least_too
        Whether the least is allowed itself.

    Raises
    ------
    InputError
        If one is outside.
    """
    array = numbers(value, field)
    if array.size and least < array.min() and array.max() <= most:
        return array
    low = array < least if least_too else array <= least
    outside = low | (array > most)
    if outside.any():
        limits = {"least": least, "most": most, "unit": f" {unit}" if unit else ""}
        raise InputError(
            said("must be from {least:.6g} to {most:.6g}{unit}", **limits)
            if least_too
            else said("must be greater than {least:.6g} and at most {most:.6g}{unit}", **limits),
            field=field,
            value=float(array[outside].flat[0]),
        )
    return array
