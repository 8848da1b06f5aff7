"""Checks of what callers give, with the messages that go with them."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import ABSENT, InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.masked import filled
from rolamento.words import said

MAXIMUM_SAMPLES: Final = 1_000_000
MAXIMUM_SHAPE: Final = 1000.0
LONGEST_TIME: Final = 1e12
"""Maximum of an age or a mission, in any unit."""


def numbers(values: Any, field: str, example: str) -> FloatArray:
    """Return numbers as an array of its own, of any shape; NaN where they are masked or None.

    Lists, arrays and series will do; text, tables and lists of several lengths will not.
    """
    array: FloatArray | None = None
    try:
        given = values if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
        text = given.dtype.kind == "O" and any(isinstance(one, str) for one in given.flat)
        if given.dtype.kind in "iufO" and given.dtype != np.bool_ and not text:
            array = np.array(filled(given))
    except (TypeError, ValueError):
        pass
    if array is None or values is None or hasattr(values, "columns"):
        raise InputError(
            said("must be numbers: a list, an array or a series"),
            field=field,
            value=values if values is None or isinstance(values, str | bool) else ABSENT,
            example=example,
        )
    return array


def share(value: object, field: str, example: str = "0.9") -> float:
    """Return a number between 0 and 1, both excluded."""
    number = _scalar(value)
    if not 0.0 < number < 1.0:
        raise InputError(
            said("must be between 0 and 1, exclusive"),
            field=field,
            value=value,
            example=example,
        )
    return number


def shares(value: ArrayLike, field: str, example: str = "0.9") -> FloatArray:
    """Return numbers between 0 and 1, both excluded, as an array."""
    array = numbers(value, field, example)
    bad = ~((array > 0.0) & (array < 1.0))
    if np.any(bad):
        raise InputError(
            said("must be between 0 and 1, exclusive"),
            field=field,
            value=value if array.ndim == 0 else float(array[bad].flat[0]),
            example=example,
        )
    return array


def positive(value: object, field: str, example: str) -> float:
    """Return a finite number above zero."""
    number = _scalar(value)
    if not (0.0 < number < np.inf):
        raise InputError(
            said("must be a positive number"), field=field, value=value, example=example
        )
    return number


def time_of(value: object, field: str, *, least: float | None = None) -> float:
    """Return a time within reason: above zero, or from a least one on."""
    number = _scalar(value)
    above = number > 0.0 if least is None else number >= least
    if not (above and number <= LONGEST_TIME):
        rule = (
            said("must be positive and at most {most:.6g}", most=LONGEST_TIME)
            if least is None
            else said("must be from {least:.6g} to {most:.6g}", least=least, most=LONGEST_TIME)
        )
        raise InputError(rule, field=field, value=value, example="2000.0")
    return number


def shape_of(value: object, field: str = "shape") -> float:
    """Return a Weibull shape within reason."""
    number = positive(value, field, "1.5")
    if number > MAXIMUM_SHAPE:
        raise InputError(
            said("must be at most {most:.6g}", most=MAXIMUM_SHAPE),
            field=field,
            value=value,
            example="1.5",
        )
    return number


def sample_count(value: object, least: int = 100) -> int:
    """Return how many samples to draw."""
    return whole_number(value, "samples", least, MAXIMUM_SAMPLES, "10000")


def whole_number(value: object, field: str, least: int, most: int, example: str = "") -> int:
    """Return a whole number between limits."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= int(value) <= most:  # type: ignore[call-overload]
        raise InputError(
            said("must be an integer from {least} to {most}", least=least, most=most),
            field=field,
            value=value,
            example=example or str(max(least, 10) if most >= 10 else least),
        )
    return int(value)  # type: ignore[call-overload, no-any-return]


def generator(seed: object) -> np.random.Generator:
    """Return the random numbers that a seed stands for."""
    whole = isinstance(seed, int | np.integer) and not isinstance(seed, bool)
    if not whole or not 0 <= int(seed) < 2**128:  # type: ignore[call-overload]
        raise InputError(
            said("must be a non-negative integer"), field="seed", value=seed, example="0"
        )
    return np.random.default_rng(int(seed))  # type: ignore[call-overload]


def one_of(value: object, field: str, allowed: Iterable[str]) -> None:
    """Refuse a word that is not among the allowed ones."""
    words = tuple(allowed)
    if not (isinstance(value, str) and value in words):
        raise InputError(
            said("must be one of {known}", known=", ".join(words)),
            field=field,
            value=value,
            example=words[0],
        )


def _scalar(value: object) -> float:
    try:
        if isinstance(value, bool | str) or np.ndim(value):  # type: ignore[arg-type]
            return float("nan")
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return float("nan")


def finite_or_none(value: float) -> float | None:
    """Return a number as plain value; None where there is none, or it is infinite."""
    return float(value) if isfinite(value) else None
