"""Times and lives on the command line: a number with a unit, in the unit of the data."""

from __future__ import annotations

import re
from typing import Final

from rolamento.errors import InputError

__all__ = ["given_life", "life_in", "named_life"]

_WRITTEN: Final = re.compile(r"\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*(.*?)\s*")
_LONGEST: Final = 100
_REVOLUTIONS: Final = {
    "rev": 1.0, "revs": 1.0, "revolutions": 1.0, "krev": 1e3, "mrev": 1e6, "10^6 rev": 1e6,
    "1e6 rev": 1e6, "million revolutions": 1e6,
}  # fmt: skip
_TIMES: Final = {
    "s": 1.0, "min": 60.0, "minutes": 60.0, "h": 3600.0, "hr": 3600.0, "hour": 3600.0,
    "hours": 3600.0, "horas": 3600.0, "kh": 3.6e6, "d": 86400.0, "day": 86400.0, "days": 86400.0,
    "dias": 86400.0, "years": 365.25 * 86400.0, "anos": 365.25 * 86400.0,
}  # fmt: skip


def given_life(text: str, option: str, example: str = "1000 h") -> tuple[float, str]:
    """Read a life with its unit, which may be any.

    Raises
    ------
    InputError
        If it is no number above zero followed by a unit.
    """
    match = _WRITTEN.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise InputError(
            "must be a number with its unit", source=option, value=text, example=f'"{example}"'
        )
    value, unit = float(match[1]), match[2]
    if not unit:
        raise InputError("needs its unit", source=option, value=text, example=f'"{example}"')
    if not 0.0 < value < float("inf"):
        raise InputError(
            "must be greater than zero", source=option, value=text, example=f'"{example}"'
        )
    return value, unit


def life_in(text: str, unit: str, option: str) -> float:
    """Read a life in the unit of the data, or in one that can be turned into it.

    Raises
    ------
    InputError
        If its unit is another, or it has none.
    """
    example = f"100 {unit}"
    value, said = given_life(text, option, example)
    factor = _factor(said, unit)
    if factor is None:
        raise InputError(
            f"must be in the unit of the data, {unit}",
            source=option,
            value=text,
            example=f'"{example}"',
        )
    return value * factor


def named_life(text: str, unit: str, option: str) -> tuple[str, float]:
    """Read a life with or without a name before it: ``"ISO 281=58 h"``."""
    name, equals, life = text.rpartition("=")
    return name.strip() if equals else "", life_in(life, unit, option)


def _factor(said: str, unit: str) -> float | None:
    """What one unit is in another; None if they have nothing to do with each other."""
    first, second = said.casefold(), unit.casefold()
    if first == second:
        return 1.0
    for known in (_REVOLUTIONS, _TIMES):
        if first in known and second in known:
            return known[first] / known[second]
    return None
