"""Times and lives as people write them: a number with a unit, turned into the unit of the data."""

from __future__ import annotations

import re
from typing import Final

from rolamento.errors import InputError
from rolamento.units import doubt_of_thousands, typed
from rolamento.validate import number
from rolamento.words import said

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


def life_with_unit(text: object, field: str, example: str = "1000 h") -> tuple[float, str]:
    """Read a life with its unit, which may be any.

    Raises
    ------
    InputError
        If it is no number above zero followed by a unit.
    """
    match = None
    if isinstance(text, str) and len(text) <= _LONGEST:
        match = _WRITTEN.fullmatch(typed(text))
    rule = ""
    if match is None:
        rule = said("must be a number with its unit")
    elif not match[2]:
        rule = said("needs a unit")
    elif not 0.0 < float(match[1]) < float("inf"):
        rule = said("must be positive")
    elif rule := doubt_of_thousands(match[1]):
        example = f"{match[1].replace('.', '')} {match[2]}"
    if match is None or rule:
        raise InputError(rule, field=field, value=text, example=f'"{example}"')
    return float(match[1]), match[2]


def life_in(life: float | str, unit: str, field: str) -> float:
    """Return a life in the unit of the data.

    Parameters
    ----------
    life
        A number in that unit, or a text with a unit that can be turned into it: "2 days".
    unit
        Of the data.
    field
        What to call it in messages.

    Raises
    ------
    InputError
        If its unit is another, or a text has none.
    """
    example = f"100 {unit}"
    if not isinstance(life, str):
        return number(life, field, above=0.0, example=f'"{example}"')
    value, given = life_with_unit(life, field, example)
    factor = _factor(given, unit)
    if factor is None:
        raise InputError(
            said("must be in the unit of the data, {unit}", unit=unit),
            field=field,
            value=life,
            example=f'"{example}"',
        )
    return value * factor


def _factor(said: str, unit: str) -> float | None:
    """What one unit is in another; None if they have nothing to do with each other."""
    first, second = said.casefold(), unit.casefold()
    if first == second:
        return 1.0
    for known in (_REVOLUTIONS, _TIMES):
        if first in known and second in known:
            return known[first] / known[second]
    return None
