"""Options that give a record by its fields: ``inner_race,jitter=0.02,azimuth=90 deg``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.cli.quantities import Kind, value_of
from rolamento.errors import InputError, nearest

__all__ = ["fields_of"]

_LONGEST: Final = 1000


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
        raise InputError(f"must be at most {_LONGEST} characters", source=option, example=example)
    found: dict[str, Any] = {}
    for place, part in enumerate(text.split(",")):
        key, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals and first and place == 0:
            key, value = first, key
        elif not equals or key not in known:
            _refuse(key, option, known, example)
        if key in found:
            raise InputError("is given twice", source=option, field=key, example=example)
        found[key] = value_of(value, option, key, known[key], example)
    if first and first not in found:
        raise InputError("is missing", source=option, field=first, example=example)
    return found


def _refuse(key: str, option: str, known: Mapping[str, Kind], example: str) -> None:
    near = nearest(key, known)
    raise InputError(
        f"must be KEY=VALUE, with a KEY of {', '.join(known)}"
        + (f"; perhaps {near}" if near else ""),
        source=option,
        value=key,
        example=example,
    )
