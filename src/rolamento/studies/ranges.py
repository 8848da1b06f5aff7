"""A field and its values over a range, from text such as ``"duty.load.fx=10..200N"``."""

from __future__ import annotations

import re
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.studies.fields import Field, no_range, read_field
from rolamento.words import said

__all__ = ["MOST_POINTS", "MOST_SINGLE", "Range", "read_range", "refuse_many_singles"]

MOST_POINTS: Final = 1000
MOST_SINGLE: Final = 200
"""Points over a field that needs a case for each of its values."""
_RANGE: Final = re.compile(r"([^=]+)=(.+?)\.\.(.+)", re.DOTALL)
_NUMBER: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.DOTALL)
_LONGEST: Final = 200
_EXAMPLE: Final = "duty.load.fx=10..200N"


@frozen
class Range:
    """A field and its values, (points,), SI."""

    field: Field
    values: NDArray[np.float64]


def read_range(text: str, points: int = 40, *, log: bool = False) -> Range:
    """Read a range such as ``"duty.load.fx=10..200N"`` or ``"duty.load.fx=10N..2kN"``.

    Parameters
    ----------
    text
        Field, first and last value; a first value without a unit has that of the last.
    points
        How many values, ends included.
    log
        Equal ratios instead of equal steps.

    Raises
    ------
    InputError
        If it is not of that form, the field takes no range, or a value is out of bounds.
    """
    match = _RANGE.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise InputError(
            said("must be FIELD=FIRST..LAST"),
            field="--over",
            value=text[:_LONGEST],
            example=_EXAMPLE,
        )
    if not 2 <= points <= MOST_POINTS:
        raise InputError(
            said("must be 2 to {most}", most=MOST_POINTS), field="--points", value=points
        )
    name, first, last = (part.strip() for part in match.groups())
    field = read_field(name, at="--over")
    if not field.continuous:
        raise InputError(no_range(name), field="--over", value=name, example=_EXAMPLE)
    begin, end = _value(field, _with_unit(first, last)), _value(field, last)
    if log and not begin * end > 0.0:
        raise InputError(
            said("must not be zero or change sign with --log"),
            field="--over",
            value=text,
            example=_EXAMPLE,
        )
    space = np.geomspace if log else np.linspace
    return Range(field, space(begin, end, points).astype(np.float64))


def refuse_many_singles(points: int) -> None:
    """Refuse more points than are solved where each needs a case of its own.

    Raises
    ------
    InputError
        Naming the option.
    """
    if points > MOST_SINGLE:
        raise InputError(
            said(
                "must be at most {most} for a field of which each value needs a case of its own",
                most=MOST_SINGLE,
            ),
            field="--points",
            value=points,
        )


def _with_unit(first: str, last: str) -> str:
    """Give a bare number the unit of the other end."""
    bare, other = _NUMBER.fullmatch(first), _NUMBER.fullmatch(last)
    if bare is not None and not bare[2] and other is not None and other[2]:
        return f"{first} {other[2]}"
    return first


def _value(field: Field, text: str) -> float:
    given: Any = text
    if field.dimension is None:
        try:
            given = float(text)
        except ValueError:
            raise InputError(
                said("must be a number"), field=field.name, value=text, example=field.example
            ) from None
    return float(field.checked(given, in_file=True))
