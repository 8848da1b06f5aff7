"""Values of fields over many cases, checked: what a batch varies beside the case it begins from."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, Final, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case.case import Case
from rolamento.case.duty import SHORT_NAMES
from rolamento.case.fields import Field, field_of
from rolamento.case.hints import LISTED, hint
from rolamento.errors import InputError, UnknownKeyError, kind_of
from rolamento.numerics.masked import may_be_masked
from rolamento.units import to_si
from rolamento.words import said

__all__ = [
    "SHORT_NAMES",
    "DutyFields",
    "batch_fields",
    "bounded",
    "is_of_mounting",
    "varied_arrays",
]

Floats = NDArray[np.float64]

_EXAMPLE: Final = "fx=[1e3, 2e3]"


class DutyFields(TypedDict, total=False):
    """What a batch may vary by keyword: scalars, or arrays of one length, in SI units or text."""

    inner_speed: ArrayLike
    outer_speed: ArrayLike
    first_ball_azimuth: ArrayLike
    fx: ArrayLike
    fy: ArrayLike
    fz: ArrayLike
    my: ArrayLike
    mz: ArrayLike
    x: ArrayLike
    y: ArrayLike
    z: ArrayLike
    ry: ArrayLike
    rz: ArrayLike


@cache
def batch_fields() -> tuple[str, ...]:
    """Return the dotted names of the fields that a batch may vary as arrays, in SI units."""
    return tuple(name for name, field in Case.fields().items() if field.varies)


def is_of_mounting(field: str) -> bool:
    """Return whether a field of a batch takes effect through a mounting alone."""
    return field.startswith(("temperature.", "mounting.")) and field != "temperature.lubricant"


def varied_arrays(values: Any = None, /, **short: Any) -> dict[str, Floats]:
    """Return values of fields by full name, checked for names, kinds, shapes and rivals.

    Parameters
    ----------
    values
        By the dotted names of `batch_fields`, or the short names of the duty: a mapping, or a
        table whose columns are such names (a data frame of pandas or its like). Each a number in
        SI units, a text with a unit, or an array, list or series of one length of either; None is
        no values at all.
    short
        Likewise by the short names of the duty.

    Returns
    -------
    dict
        Of scalars or arrays (cases,), SI; NaN where a value is missing or masked. What a field
        would refuse is its own case's affair: see `bounded`.

    Raises
    ------
    InputError
        For an unknown field, what is no number, arrays of different lengths, or fields that
        exclude each other.
    """
    arrays: dict[str, Floats] = {}
    columns = () if values is None else _columns(values)
    for key, value in (*columns, *short.items()):
        name = SHORT_NAMES.get(key, key) if isinstance(key, str) else str(key)
        field = field_of(Case, name)
        if field is None or not field.varies:
            known = batch_fields()
            guess = hint(name, known, (*SHORT_NAMES, *known), said(LISTED))
            raise UnknownKeyError(
                said("is not a field that can vary; {guess}", guess=guess),
                field=name,
                example=_EXAMPLE,
            )
        if name in arrays:
            raise InputError(said("is given twice"), field=name, example=_EXAMPLE)
        before = next((one for one in arrays if one in field.rivals), None)
        if before is not None:
            raise InputError(
                said("cannot be combined with {before}", before=before),
                field=name,
                example=_EXAMPLE,
            )
        arrays[name] = _numbers(field, value)
    shapes = {array.shape for array in arrays.values() if array.ndim}
    if len(shapes) > 1 or any(len(shape) != 1 for shape in shapes):
        raise InputError(
            said("must be scalars or one-dimensional arrays of one length"),
            field=", ".join(arrays),
            value=str(sorted(shapes)),
            example=f"{_EXAMPLE}, fz=[0.0, 500.0]",
        )
    return arrays


def bounded(arrays: Mapping[str, Floats]) -> dict[str, Floats]:
    """Return the arrays of `varied_arrays` with NaN for values that their fields would refuse."""
    found: dict[str, Floats] = {}
    for name, array in arrays.items():
        bounds = Case.fields()[name].bounds
        assert bounds is not None  # else it would not vary
        allowed = bounds.allows(array)
        found[name] = array if allowed.all() else np.where(allowed, array, np.nan)
    return found


def _columns(values: Any) -> list[tuple[Any, Any]]:
    if isinstance(values, Mapping):
        return list(values.items())
    if hasattr(values, "columns") and hasattr(values, "__getitem__"):
        return [(name, values[name]) for name in values.columns]
    raise InputError(
        said("must be values by field names, or a table whose columns are field names"),
        field="values",
        value=kind_of(values),
        example='{"duty.load.fx": [1e3, 2e3]}',
    )


def _numbers(field: Field, value: Any) -> Floats:
    """Return a column as floats that nobody writes to; NaN for what is missing or masked."""
    if type(value) is np.ndarray and value.dtype == np.float64 and _is_frozen(value):
        return value
    numbers = _copied(field, value)
    numbers.flags.writeable = False
    return numbers


def _is_frozen(array: NDArray[Any]) -> bool:
    """Whether nobody can write to an array, here or where it comes from."""
    return array.base is None and not array.flags.writeable


def _copied(field: Field, value: Any) -> Floats:
    if may_be_masked(value):
        plain, mask = value.data, np.ma.getmaskarray(value)
        if plain.dtype.kind in "OUT":
            plain = plain.astype(object)
            plain[mask] = None
    elif hasattr(value, "magnitude") or hasattr(value, "to_value"):  # of pint, of astropy
        raise _refused(field, type(value), said("must be a plain number or text with its unit"))
    else:
        plain, mask = _array(field, value), None
    if plain.dtype.kind in "fiu":
        numbers = plain.astype(np.float64)
    elif plain.dtype.kind in "OUT":
        numbers = np.array([_number(field, one) for one in plain.ravel()], np.float64)
        numbers = numbers.reshape(plain.shape)
    else:
        raise _refused(field, value, said("must be numbers"))
    return numbers if mask is None else np.where(mask, np.nan, numbers)


def _array(field: Field, value: Any) -> NDArray[Any]:
    try:
        if isinstance(value, list | tuple) and any(isinstance(one, str) for one in value):
            return np.array(value, dtype=object)  # NumPy would make texts of the numbers too
        return np.asarray(value)
    except (TypeError, ValueError):  # of lists of different lengths
        raise _refused(field, value, said("must be a number or a list of numbers")) from None


def _number(field: Field, value: Any) -> float:
    """Return one of some values that are not all numbers."""
    if value is None or type(value).__name__ in ("NAType", "NaTType"):  # missing, for pandas
        return float("nan")
    if isinstance(value, str) and field.dimension is not None:
        try:
            return to_si(value, field.dimension)
        except InputError as error:
            raise error.with_details(field=field.name) from None
    if isinstance(value, bool | str) or not hasattr(value, "__float__"):
        raise _refused(field, value, said("must be a number"))
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise _refused(field, value, said("must be a finite number")) from None


def _refused(field: Field, value: Any, rule: str) -> InputError:
    example = f"{field.leaf} = {field.example}"
    return InputError(rule, field=field.name, value=value, example=example)
