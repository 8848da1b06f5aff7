"""What one unit of a file's samples is worth, by the sensitivity of a sensor."""

from __future__ import annotations

import re
from math import isfinite
from typing import Any, Final, NamedTuple

import numpy as np

from rolamento.errors import InputError
from rolamento.vibration.reading._units import RAW_UNITS, plain_unit, quantity_of_unit
from rolamento.vibration.signal import SI_UNITS, Quantity, unit_scale

__all__ = ["Scale", "checked_scale"]

_LEAST: Final = 1e-15
_MOST: Final = 1e15
_LONGEST: Final = 60
_TEXT: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*([^\d\s.,].*)")
_VOLTS: Final = {"V": 1.0, "mV": 1e-3, "uV": 1e-6}
_EXAMPLE: Final = 'scale="100 mV/g"'


class Scale(NamedTuple):
    """What one unit of the samples is worth.

    Attributes
    ----------
    factor
        in the SI unit of the quantity
    quantity
        that the samples are of when they are multiplied by it
    """

    factor: float
    quantity: Quantity


def checked_scale(scale: Any, unit: str, quantity: Quantity | None) -> Scale:
    """Return what one unit of the samples is worth.

    Parameters
    ----------
    scale
        a number of SI units, or text: "100 mV/g", "0.5 g/V", or "10 g" for one of whatever the
        samples are in
    unit
        that the samples are in before, "" if nobody says
    quantity
        of the samples after; by default that of the text, and acceleration for a number

    Raises
    ------
    InputError
        If the scale is none, or does not fit the unit or the quantity.
    """
    if quantity_of_unit(unit) != "unknown":
        raise InputError(
            f"is for samples in {', '.join(RAW_UNITS)}, and these are in {unit} already; what "
            f'one of them is worth is written as scale="10 {unit}", without unit',
            field="scale",
            value=scale,
        )
    if quantity is not None:
        unit_scale(quantity, SI_UNITS.get(quantity, ""))  # refuses what is no quantity
    if quantity == "unknown":
        raise InputError(
            f"needs a quantity that it leads to: {', '.join(SI_UNITS)}",
            field="scale",
            value=scale,
            example='quantity="acceleration"',
        )
    if isinstance(scale, str):
        found = _of_text(scale, unit)
    else:
        plain = isinstance(scale, int | float | np.integer | np.floating)
        number = _as_float(scale) if plain and not isinstance(scale, bool) else float("nan")
        found = Scale(number, quantity or "acceleration")
    if not (isfinite(found.factor) and _LEAST <= abs(found.factor) <= _MOST):
        raise InputError(
            f"must be a number of a size from {_LEAST:g} to {_MOST:g} SI units, or text with units",
            field="scale",
            value=scale,
            example=_EXAMPLE,
        )
    if quantity is not None and found.quantity != quantity:
        raise InputError(
            f"leads to {found.quantity}, and the quantity is to be {quantity}",
            field="scale",
            value=scale,
        )
    return found


def _of_text(text: str, unit: str) -> Scale:
    match = _TEXT.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise _unreadable(text)
    number, units = float(match[1]), match[2]
    worth = _worth(units)
    if worth is not None:
        return Scale(number * worth.factor, worth.quantity)
    for place, sign in enumerate(units):
        if sign != "/":
            continue
        above, below = _bare(units[:place]), _bare(units[place + 1 :])
        worth, raw = _worth(below), plain_unit(above)
        if worth is not None and raw in RAW_UNITS:  # "100 mV/g"
            sensitivity = number / _in_samples(raw, unit, text)
            factor = worth.factor / sensitivity if sensitivity else float("inf")
            return Scale(factor, worth.quantity)
        worth, raw = _worth(above), plain_unit(below)
        if worth is not None and raw in RAW_UNITS:  # "0.5 g/V"
            return Scale(number * worth.factor * _in_samples(raw, unit, text), worth.quantity)
    raise _unreadable(text)


def _bare(text: str) -> str:
    return text.strip().removeprefix("(").removesuffix(")")


def _worth(text: str) -> Scale | None:
    """SI value of one unit that a signal can have; None of others."""
    unit = plain_unit(text)
    quantity = quantity_of_unit(unit)
    return None if quantity == "unknown" else Scale(unit_scale(quantity, unit), quantity)


def _in_samples(raw: str, unit: str, text: str) -> float:
    """How many of a scale's raw unit go into one unit of the samples."""
    if raw == unit or (raw == "counts" and not unit):
        return 1.0
    if raw in _VOLTS and unit in _VOLTS:
        return _VOLTS[unit] / _VOLTS[raw]
    if not unit:
        raise InputError(
            f'of the samples is not in the file; give it with the scale "{text}"',
            field="unit",
            example=f'unit="{"V" if raw in _VOLTS else raw}"',
        )
    raise InputError(
        f"is by {raw}, and the samples are in {unit}; say with unit what one of them is",
        field="scale",
        value=text,
        example=f'unit="{raw}"',
    )


def _as_float(number: Any) -> float:
    try:
        return float(number)
    except OverflowError:
        return float("inf")


def _unreadable(text: str) -> InputError:
    return InputError(
        "is no sensitivity: a number and its units, of a signal and of its samples before "
        f"({', '.join(RAW_UNITS)})",
        field="scale",
        value=text,
        example=_EXAMPLE,
    )
