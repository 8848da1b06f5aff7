"""Checks of the numbers and words that callers give, each with the message that goes with it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf, isfinite, nan
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import ABSENT, InputError, kind_of
from rolamento.numerics import FloatArray
from rolamento.numerics.masked import filled
from rolamento.words import marked, said

__all__ = [
    "check_count",
    "finite",
    "generator",
    "number",
    "numbers",
    "one_of",
    "positive",
    "scalar",
    "share",
    "shares",
    "whole_number",
    "within",
]


def numbers(value: ArrayLike | None, field: str, example: str = "") -> FloatArray:
    """Return numbers as an array of any shape, NaN where they are masked or None.

    Raises
    ------
    InputError
        If it is neither a number nor a list, an array or a series of them: text and tables are not.
    """
    kind: type = type(value)
    if kind is float or (kind is np.ndarray and getattr(value, "dtype", None) == np.float64):
        return np.asarray(value)  # most of what comes: plain numbers, of which none is masked
    try:
        given = value if isinstance(value, np.ndarray) else np.asarray(value)
        objects = given.flat if given.dtype.kind == "O" else ()
        words = any(isinstance(one, str | bool) for one in objects)
        table = value is None or hasattr(value, "columns")
        if given.dtype.kind in "iufO" and not words and not table:
            return filled(given)
    except (TypeError, ValueError):
        pass
    raise InputError(
        said("must be a number or an array of numbers"),
        field=field,
        value=kind_of(value),
        example=example or f"{field} = 1.0",
    )


def positive(
    value: ArrayLike, field: str, *, zero: bool = False, finite: bool = False
) -> FloatArray:
    """Return numbers above zero (or zero as well) as an array; NaN, no result, passes.

    Parameters
    ----------
    value
        Array of any shape.
    field
        Its name, for the message.
    zero
        Whether zero is allowed.
    finite
        Whether NaN and infinity are refused as well.

    Raises
    ------
    InputError
        If one is not.
    """
    array = numbers(value, field)
    if array.size == 1 and 0.0 < array.item() < inf:
        return array
    wrong = array < 0.0 if zero else array <= 0.0
    if finite:
        wrong = wrong | ~np.isfinite(array)
    if wrong.any():
        raise InputError(
            said("must not be negative") if zero else said("must be positive"),
            field=field,
            value=float(array[wrong].flat[0]),
        )
    return array


def within(
    value: ArrayLike,
    field: str,
    unit: str,
    least: float,
    most: float,
    *,
    example: str = "",
    least_too: bool = True,
    nan_too: bool = True,
) -> FloatArray:
    """Return numbers of a range as an array.

    Parameters
    ----------
    value
        Array of any shape.
    field, unit, example
        For the message.
    least, most
        Limits; the greater is allowed itself.
    least_too
        Whether the lesser is allowed itself.
    nan_too
        Whether NaN, no result, passes.

    Raises
    ------
    InputError
        If one is outside.
    """
    array = numbers(value, field, example)
    if array.size == 1:
        inside = least < array.item() <= most
    else:
        inside = array.size > 1 and least < array.min() and array.max() <= most
    if inside:
        return array
    outside = (array < least if least_too else array <= least) | (array > most)
    if not nan_too:
        outside = outside | np.isnan(array)
    if outside.any():
        low = {"least": least} if least_too else {"above": least}
        raise InputError(
            _rule({**low, "most": most}, unit),
            field=field,
            value=float(array[outside].flat[0]),
            example=example,
        )
    return array


def number(
    value: object,
    field: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
    unit: str = "",
    example: str,
) -> float:
    """Return one finite number within its limits.

    Raises
    ------
    InputError
        If it is not.
    """
    found = scalar(value)
    low, high = -inf if least is None else least, inf if most is None else most
    if not (isfinite(found) and low <= found <= high and (above is None or found > above)):
        limits = {"above": above, "least": least, "most": most}
        given = {name: limit for name, limit in limits.items() if limit is not None}
        raise InputError(_rule(given, unit), field=field, value=value, example=example)
    return found


def whole_number(value: object, field: str, least: int, most: int, example: str = "") -> int:
    """Return a whole number between limits, both allowed.

    Raises
    ------
    InputError
        If it is not.
    """
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= int(value) <= most:  # type: ignore[call-overload]
        raise InputError(
            said("must be an integer from {least} to {most}", least=least, most=most),
            field=field,
            value=value,
            example=example or str(max(least, 10) if most >= 10 else least),
        )
    return int(value)  # type: ignore[call-overload, no-any-return]


def share(value: object, field: str, example: str = "0.9") -> float:
    """Return a number between 0 and 1, both excluded.

    Raises
    ------
    InputError
        If it is not.
    """
    return float(shares(scalar(value), field, example, given=value))


def shares(
    value: ArrayLike, field: str, example: str = "0.9", *, given: Any = ABSENT
) -> FloatArray:
    """Return numbers between 0 and 1, both excluded, as an array.

    Raises
    ------
    InputError
        If one is not; `given` is what the message shows.
    """
    array = numbers(value, field, example)
    bad = ~((array > 0.0) & (array < 1.0))
    if bad.any():
        raise InputError(
            said("must be between 0 and 1, exclusive"),
            field=field,
            value=float(array[bad].flat[0]) if given is ABSENT else given,
            example=example,
        )
    return array


def generator(seed: object) -> np.random.Generator:
    """Return the random numbers that a seed stands for.

    Raises
    ------
    InputError
        If it is no whole number from 0.
    """
    whole = isinstance(seed, int | np.integer) and not isinstance(seed, bool)
    if not whole or not 0 <= int(seed) < 2**128:  # type: ignore[call-overload]
        raise InputError(
            said("must be a non-negative integer"), field="seed", value=seed, example="0"
        )
    return np.random.default_rng(int(seed))  # type: ignore[call-overload]


def one_of(
    value: object, field: str, allowed: Iterable[str], example: str = "", *, source: str = ""
) -> None:
    """Refuse a word that is not among the allowed ones.

    Raises
    ------
    InputError
        If it is not.
    """
    words = tuple(allowed)
    if not (isinstance(value, str) and value in words):
        raise InputError(
            said("must be one of {known}", known=", ".join(words)),
            field=field,
            value=value,
            example=example or words[0],
            source=source,
        )


def check_count(field: str, count: int, most: int) -> None:
    """Refuse more of something than there may be.

    Raises
    ------
    InputError
        If there is.
    """
    if count > most:
        raise InputError(said("may have at most {most}", most=most), field=field, value=count)


def finite(value: float) -> float | None:
    """Return a number as plain value; None where there is none, or it is infinite."""
    return float(value) if isfinite(value) else None


def scalar(value: object) -> float:
    """Return one plain number; NaN of anything else, and of one that no float holds."""
    try:
        if isinstance(value, bool | np.bool_ | str | bytes) or np.ndim(value):  # type: ignore[arg-type]
            return nan
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return nan


_RULES: Final[dict[tuple[str, ...], str]] = {
    (): marked("must be a number"),
    ("above",): marked("must be a number greater than {above:.6g}{unit}"),
    ("least",): marked("must be a number of at least {least:.6g}{unit}"),
    ("most",): marked("must be a number of at most {most:.6g}{unit}"),
    ("above", "most"): marked(
        "must be a number greater than {above:.6g} and at most {most:.6g}{unit}"
    ),
    ("least", "most"): marked("must be from {least:.6g} to {most:.6g}{unit}"),
}


def _rule(limits: Mapping[str, float], unit: str) -> str:
    return said(_RULES[tuple(limits)], **limits, unit=f" {unit}" if unit else "")
