"""Values with units that options give: speeds, rates, times, levels, alone or by fields.

A field list is a record in one option: ``inner_race,jitter=0.02,azimuth=90 deg``.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite, nan
from typing import Any, Final, Literal

from rolamento.errors import InputError, guess
from rolamento.units import to_si, typed
from rolamento.words import said

__all__ = ["Kind", "fields_of", "number_given", "number_of", "part_of_one"]

Kind = Literal["number", "whole", "text", "angle", "length", "frequency", "time", "acceleration"]

_UNITS: Final[dict[str, dict[str, float]]] = {
    "frequency": {"Hz": 1.0, "kHz": 1e3, "MHz": 1e6},
    "time": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
    "acceleration": {"m/s^2": 1.0, "m/s²": 1.0, "mm/s^2": 1e-3, "g": 9.80665, "mg": 9.80665e-3},
}
"""Units of what is no dimension of a case file; a bare number is in the first."""
_LONGEST: Final = 1000
_MOST: Final = 1e12


def number_given(text: str | None, option: str, kind: Kind, example: str) -> float | None:
    """Return a number from 0 on with a unit of its kind; None if it is not given.

    Raises
    ------
    InputError
        If it is none, or negative.
    """
    if text is None:
        return None
    try:
        value = number_of(text, option, kind, example)
    except InputError:
        value = nan
    if not 0.0 <= value <= _MOST:
        rule = _rule(kind, least=True)
        raise InputError(rule, source=option, value=text, example=example)
    return value


def number_of(text: str, option: str, kind: Kind, example: str) -> float:
    """Return a number with a unit of its kind; a bare one is in Hz, s or m/s².

    Raises
    ------
    InputError
        If it is none.
    """
    return float(_value_of(text, option, "", kind, example))


def part_of_one(text: str, parameter: str, example: str) -> float:
    """Return a part of one, given as a number or in percent.

    Raises
    ------
    InputError
        If it is none.
    """
    number = typed(text.strip())
    try:
        value = float(number.removesuffix("%"))
    except ValueError:
        rule = said("must be a fraction such as 0.03, or a percentage")
        raise InputError(rule, field=parameter, value=text, example=example) from None
    return value / 100.0 if number.endswith("%") else value


def _value_of(text: str, option: str, key: str, kind: Kind, example: str) -> Any:
    """Return a value of some kind, in SI units; a text as it is.

    Parameters
    ----------
    text
        As it was written.
    option, key
        What gives it, and which field of that; "" for the option itself.
    kind
        What it has to be.
    example
        What would be accepted.

    Raises
    ------
    InputError
        If it is none.
    """
    if kind == "text":
        return text
    try:
        if kind == "whole":
            return int(text)
        if kind in ("angle", "length"):
            return _with_unit(text, kind)
        number, unit = _split(typed(text))
        units = {"": 1.0, **_UNITS.get(kind, {})}
        value = float(number) * units[unit]
    except (ValueError, KeyError) as error:
        rule = error.rule if isinstance(error, InputError) else _rule(kind)
        raise InputError(rule, source=option, field=key, value=text, example=example) from None
    if not isfinite(value):
        rule = _rule(kind)
        raise InputError(rule, source=option, field=key, value=text, example=example)
    return value


def _with_unit(text: str, kind: Literal["angle", "length"]) -> float:
    return to_si(text, kind)


def _split(text: str) -> tuple[str, str]:
    """Divide a number from its unit, with or without a blank between."""
    number, blank, unit = text.strip().partition(" ")
    if not blank:
        cut = next((i for i, c in enumerate(text) if c.isalpha() and c not in "eE"), len(text))
        number, unit = text[:cut], text[cut:]
    return number, unit.strip()


def _rule(kind: Kind, *, least: bool = False) -> str:
    """Return what a value of a kind has to be, from 0 on or whatever its size."""
    if kind == "whole":
        return said("must be an integer")
    units = ", ".join(unit for unit in _UNITS.get(kind, {}) if "²" not in unit)
    if least:
        return said("must be a number of at least 0, alone or in {units}", units=units)
    if units:
        return said("must be a number, alone or in {units}", units=units)
    return said("must be a number")


def fields_of(
    text: str, option: str, known: Mapping[str, Kind], example: str, *, first: str = ""
) -> dict[str, Any]:
    """Return the fields that an option gives, as plain SI values.

    Parameters
    ----------
    text
        ``KEY=VALUE`` with commas between.
    option
        What to call it.
    known
        The keys, and what their values are.
    example
        What would be accepted.
    first
        Key of the first value, which may stand alone; then it must be given.

    Raises
    ------
    InputError
        If a key is unknown or given twice, or a value is none.
    """
    if len(text) > _LONGEST:
        raise InputError(
            said("must be at most {most} characters long", most=_LONGEST),
            source=option,
            example=example,
        )
    found: dict[str, Any] = {}
    for place, part in enumerate(text.split(",")):
        key, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals and first and place == 0:
            key, value = first, key
        elif not equals or key not in known:
            _refuse(key, option, known, example)
        if key in found:
            raise InputError(said("is given twice"), source=option, field=key, example=example)
        found[key] = _value_of(value, option, key, known[key], example)
    if first and first not in found:
        raise InputError(said("is missing"), source=option, field=first, example=example)
    return found


def _refuse(key: str, option: str, known: Mapping[str, Kind], example: str) -> None:
    raise InputError(
        said("must be KEY=VALUE with a known KEY; {guess}", guess=guess(key, known)),
        source=option,
        value=key,
        example=example,
    )
