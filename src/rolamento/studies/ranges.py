"""A field and its values over a range, from text such as ``"duty.load.fx=10..200N"``."""

from __future__ import annotations

import re
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.studies.fields import Field, no_range, read_field, read_varied
from rolamento.words import said

__all__ = [
    "MOST_POINTS",
    "MOST_SINGLE",
    "Range",
    "check_points",
    "ends_of",
    "number_and_unit",
    "range_of_field",
    "read_range",
    "refuse_many_singles",
]

MOST_POINTS: Final = 1000
MOST_SINGLE: Final = 200
"""Points over a field that needs a case for each of its values."""
_RANGE: Final = re.compile(r"(.+?)\.\.(.+)", re.DOTALL)
_NUMBER: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.DOTALL)
_LONGEST: Final = 200
_EXAMPLE: Final = "duty.load.fx=10..200N"


@frozen
class Range:
    """A field and its values, (points,), SI."""

    field: Field
    values: NDArray[np.float64]


def read_range(
    text: str, points: int = 40, *, log: bool = False, of_machine: bool = False
) -> Range:
    """Read a range such as ``"duty.load.fx=10..200N"`` or ``"duty.load.fx=10N..2kN"``.

    Parameters
    ----------
    text
        Field, first and last value; a first value without a unit has that of the last.
    points
        How many values, ends included.
    log
        Equal ratios instead of equal steps.
    of_machine
        Whether the field may be one of a part of a machine, such as ``"loads.0.fz"``.

    Raises
    ------
    InputError
        If it is not of that form, the field takes no range, or a value is out of bounds.
    """
    name, first, last = range_of_field(text, _EXAMPLE)
    check_points(points, MOST_POINTS)
    field = (read_varied if of_machine else read_field)(name, at="over")
    if not field.continuous:
        raise InputError(no_range(name), field="over", value=name, example=_EXAMPLE)
    begin, end = _value(field, first), _value(field, last)
    if log and not begin * end > 0.0:
        raise InputError(
            said("must not be zero or change sign in a range with logarithmic spacing"),
            field="over",
            value=text,
            example=_EXAMPLE,
        )
    space = np.geomspace if log else np.linspace
    return Range(field, space(begin, end, points).astype(np.float64))


def range_of_field(text: str, example: str) -> tuple[str, str, str]:
    """Return a field's name, and the first and last value of a range as of `ends_of`.

    Raises
    ------
    InputError
        If it is not ``FIELD=FIRST..LAST``, with an example that is.
    """
    name, _, values = text.partition("=")
    ends = ends_of(values) if len(text) <= _LONGEST and name else None
    if ends is None:
        raise InputError(
            said("must be FIELD=FIRST..LAST"),
            field="over",
            value=text[:_LONGEST],
            example=example,
        )
    return name.strip(), *ends


def ends_of(text: str) -> tuple[str, str] | None:
    """Return first and last value of ``"10..200N"``, a bare first one with the unit of the last.

    None if it is not of that form.
    """
    match = _RANGE.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        return None
    first, last = (part.strip() for part in match.groups())
    bare, other = number_and_unit(first), number_and_unit(last)
    if bare is not None and not bare[1] and other is not None and other[1]:
        first = f"{first} {other[1]}"
    return first, last


def number_and_unit(text: str) -> tuple[float, str] | None:
    """Return a number and the unit behind it, empty if there is none; None if it is no number."""
    match = _NUMBER.fullmatch(text)
    return None if match is None else (float(match[1]), match[2].strip())


def check_points(points: int, most: int) -> None:
    """Refuse a number of points that makes no range, or is more than `most`.

    Raises
    ------
    InputError
        Naming the field ``points``.
    """
    if not 2 <= points <= most:
        raise InputError(said("must be 2 to {most}", most=most), field="points", value=points)


def refuse_many_singles(points: int) -> None:
    """Refuse more points than are solved where each needs a case of its own.

    Raises
    ------
    InputError
        Naming the field ``points``.
    """
    if points > MOST_SINGLE:
        raise InputError(
            said(
                "must be at most {most} for a field of which each value needs a case of its own",
                most=MOST_SINGLE,
            ),
            field="points",
            value=points,
        )


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
