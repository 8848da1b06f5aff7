"""Checks of what callers give, with the messages that go with them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.masked import filled

MOST_SAMPLES: Final = 1_000_000
MOST_SHAPE: Final = 1000.0


def share(value: object, field: str, example: str = "0.9") -> float:
    """Return a number between 0 and 1, both excluded."""
    number = _number(value)
    if not 0.0 < number < 1.0:
        raise InputError(
            "must be between 0 and 1, both excluded", field=field, value=value, example=example
        )
    return number


def shares(value: ArrayLike, field: str, example: str = "0.9") -> FloatArray:
    """Return numbers between 0 and 1, both excluded, as an array."""
    try:
        array = filled(value)
    except (TypeError, ValueError):
        array = np.asarray(np.nan)
    bad = ~((array > 0.0) & (array < 1.0))
    if np.any(bad):
        raise InputError(
            "must be between 0 and 1, both excluded",
            field=field,
            value=value if array.ndim == 0 else float(array[bad].flat[0]),
            example=example,
        )
    return array


def positive(value: object, field: str, example: str) -> float:
    """Return a finite number above zero."""
    number = _number(value)
    if not (0.0 < number < np.inf):
        raise InputError(
            "must be a number greater than zero", field=field, value=value, example=example
        )
    return number


def shape_of(value: object, field: str = "shape") -> float:
    """Return a Weibull shape within reason."""
    number = positive(value, field, "1.5")
    if number > MOST_SHAPE:
        raise InputError(f"must be {MOST_SHAPE:g} or less", field=field, value=value, example="1.5")
    return number


def sample_count(value: object, least: int = 100) -> int:
    """Return how many samples to draw."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= int(value) <= MOST_SAMPLES:  # type: ignore[call-overload]
        raise InputError(
            f"must be a whole number from {least} to {MOST_SAMPLES}",
            field="samples",
            value=value,
            example="10000",
        )
    return int(value)  # type: ignore[call-overload, no-any-return]


def generator(seed: object) -> np.random.Generator:
    """Return the random numbers that a seed stands for."""
    whole = isinstance(seed, int | np.integer) and not isinstance(seed, bool)
    if not whole or not 0 <= int(seed) < 2**128:  # type: ignore[call-overload]
        raise InputError(
            "must be a whole number, not negative", field="seed", value=seed, example="0"
        )
    return np.random.default_rng(int(seed))  # type: ignore[call-overload]


def one_of(value: object, field: str, allowed: Iterable[str]) -> None:
    """Refuse a word that is not among the allowed ones."""
    words = tuple(allowed)
    if not (isinstance(value, str) and value in words):
        raise InputError(
            f"must be one of {', '.join(words)}", field=field, value=value, example=words[0]
        )


def _number(value: object) -> float:
    if isinstance(value, bool):
        return float("nan")
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return float("nan")
