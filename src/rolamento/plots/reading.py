"""What figures read of a state: a solved one, or the JSON that ``solve --json`` wrote.

A file is taken for hostile: every key that a figure needs is looked for, and told when it is
missing or not what it should be.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, nan
from typing import Any, Final, Protocol

from rolamento._reading import format_of_path, format_of_text, parse_mapping, read_text
from rolamento.case import Case
from rolamento.errors import ABSENT, FileError, InputError

__all__ = [
    "PlottedBall",
    "PlottedContact",
    "PlottedState",
    "StateReading",
    "contact_value",
    "read_state",
    "rows_of",
    "state_from_mapping",
]

_SCHEMA: Final = 1
_GREATEST: Final = 1e20
_MOST_ROWS: Final = 1000
_NO_LOAD: Final = 1e-9
"""Of the load at the other race: what is less is rounding, and no contact."""
_EXAMPLE: Final = "rolamento solve case.toml --json state.json"


class PlottedContact(Protocol):
    """What figures show of a contact; units as in `rolamento.state.ContactState`."""

    @property
    def load(self) -> float:
        """Normal load; N."""
        ...

    @property
    def contact_angle(self) -> float:
        """Under load; rad."""
        ...

    @property
    def semi_major(self) -> float:
        """Of the ellipse, across rolling; m."""
        ...

    @property
    def semi_minor(self) -> float:
        """Of the ellipse, along rolling; m."""
        ...

    @property
    def max_pressure(self) -> float:
        """In the middle of the contact; Pa."""
        ...


class PlottedBall(Protocol):
    """What figures show of a ball."""

    @property
    def row(self) -> int:
        """Counted from 0."""
        ...

    @property
    def azimuth(self) -> float:
        """0 at +z, a quarter turn at +y; rad."""
        ...

    @property
    def inner(self) -> PlottedContact:
        """Contact with the inner ring."""
        ...

    @property
    def outer(self) -> PlottedContact:
        """Contact with the outer ring."""
        ...


class PlottedStatus(Protocol):
    """Whether there is a result."""

    @property
    def code(self) -> str:
        """As in `rolamento.state.Status`."""
        ...

    @property
    def converged(self) -> bool:
        """Whether there is a result."""
        ...


class PlottedState(Protocol):
    """What figures show of a state: a `rolamento.State` or a `StateReading`."""

    @property
    def title(self) -> str:
        """Of the case."""
        ...

    @property
    def status(self) -> PlottedStatus:
        """Whether there is a result, and if not, why."""
        ...

    @property
    def balls(self) -> Sequence[PlottedBall]:
        """Row by row."""
        ...

    @property
    def case(self) -> Case | None:
        """What was solved, if it is known."""
        ...


@dataclass(frozen=True, slots=True)
class ContactReading:
    """A contact as a file tells of it."""

    load: float
    contact_angle: float
    semi_major: float
    semi_minor: float
    max_pressure: float


@dataclass(frozen=True, slots=True)
class BallReading:
    """A ball as a file tells of it."""

    row: int
    azimuth: float
    inner: ContactReading
    outer: ContactReading


@dataclass(frozen=True, slots=True)
class StatusReading:
    """A status as a file tells of it."""

    code: str
    converged: bool


@dataclass(frozen=True, slots=True)
class StateReading:
    """A state as a file tells of it; `case` is None if the file does not hold it."""

    title: str
    status: StatusReading
    balls: tuple[BallReading, ...]
    case: Case | None = None


def rows_of(state: PlottedState) -> list[tuple[int, list[PlottedBall]]]:
    """Return the rows of balls with their numbers, each row's balls in order of azimuth."""
    rows: dict[int, list[PlottedBall]] = {}
    for ball in state.balls:
        rows.setdefault(ball.row, []).append(ball)
    return [(row, sorted(rows[row], key=lambda ball: ball.azimuth)) for row in sorted(rows)]


def contact_value(ball: PlottedBall, race: str, quantity: str) -> float:
    """Return a number of a ball's contact, SI; NaN where ball and race do not touch."""
    contact, other = (ball.inner, ball.outer) if race == "inner" else (ball.outer, ball.inner)
    touches = contact.load > _NO_LOAD * abs(other.load)
    return float(getattr(contact, quantity)) if touches else nan


def read_state(path: str | os.PathLike[str]) -> StateReading:
    """Read the JSON of a state; ``"-"`` is standard input.

    Raises
    ------
    FileError
        If the file cannot be read, is not JSON, or is not the JSON of a state.
    InputError
        If a key that figures need is missing or not what it should be.
    """
    text, source = read_text(path)
    if (format_of_path(path) or format_of_text(text)) != "json":
        raise FileError(
            "is not the JSON of a state; a case has to be solved first",
            source=source,
            example=_EXAMPLE,
        )
    try:
        return state_from_mapping(parse_mapping(text, "json", source))
    except InputError as error:
        raise error if error.source else error.with_details(source=source) from None


def state_from_mapping(mapping: Mapping[str, Any]) -> StateReading:
    """Return the state that a mapping as of `State.to_mapping` describes.

    Raises
    ------
    FileError
        If this is no state at all, or one of another schema.
    InputError
        If a key that figures need is missing or not what it should be.
    """
    schema = mapping.get("schema")
    if schema is None or "balls" not in mapping:
        raise FileError("is not the JSON of a state", example=_EXAMPLE)
    if schema is True or schema != _SCHEMA:
        raise FileError("is of another release: known is 1", field="schema", value=schema)
    status = _table(mapping, "status")
    title, case = mapping.get("title") or "", mapping.get("case")
    if not isinstance(title, str):
        raise InputError("must be text", field="title", value=title)
    return StateReading(
        title=title,
        status=StatusReading(_text(status, "status.code"), _truth(status, "status.converged")),
        balls=tuple(_ball(item, f"balls.{j}") for j, item in enumerate(_balls(mapping))),
        case=None if case is None else _case(case),
    )


def _balls(mapping: Mapping[str, Any]) -> list[Any]:
    balls = mapping["balls"]
    if not isinstance(balls, list) or not balls:
        raise InputError("must be a list of at least one ball", field="balls", value=balls)
    return balls


def _case(value: object) -> Case:
    if not isinstance(value, dict):
        raise InputError("must be a table", field="case", value=value)
    try:
        return Case.from_mapping(value)
    except InputError as error:
        raise error.with_details(field=f"case.{error.field}") from None


def _ball(item: object, field: str) -> BallReading:
    if not isinstance(item, dict):
        raise InputError("must be a table", field=field, value=item)
    inner, outer = (_contact(_table(item, f"{field}.{r}"), f"{field}.{r}") for r in _RACES)
    return BallReading(_row(item, f"{field}.row"), _number(item, f"{field}.azimuth"), inner, outer)


_RACES: Final = ("inner", "outer")


def _contact(item: Mapping[str, Any], field: str) -> ContactReading:
    numbers = {name: _number(item, f"{field}.{name}") for name in ContactReading.__slots__}
    for name in ("load", "semi_major", "semi_minor", "max_pressure"):
        if numbers[name] < 0.0:
            raise InputError("must not be negative", field=f"{field}.{name}", value=numbers[name])
    return ContactReading(**numbers)


def _value(item: Mapping[str, Any], field: str) -> Any:
    """Return what stands under the last name of a dotted field."""
    value = item.get(field.rpartition(".")[2], ABSENT)
    if value is ABSENT:
        raise InputError("is missing", field=field)
    return value


def _table(item: Mapping[str, Any], field: str) -> Mapping[str, Any]:
    value = _value(item, field)
    if not isinstance(value, dict):
        raise InputError("must be a table", field=field, value=value)
    return value


def _text(item: Mapping[str, Any], field: str) -> str:
    value = _value(item, field)
    if not isinstance(value, str):
        raise InputError("must be text", field=field, value=value)
    return value


def _truth(item: Mapping[str, Any], field: str) -> bool:
    value = _value(item, field)
    if not isinstance(value, bool):
        raise InputError("must be true or false", field=field, value=value)
    return value


def _row(item: Mapping[str, Any], field: str) -> int:
    value = _value(item, field)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < _MOST_ROWS:
        raise InputError("must be the number of a row, from 0", field=field, value=value)
    return value


def _number(item: Mapping[str, Any], field: str) -> float:
    """Return a number; null stands for one that does not exist."""
    value = _value(item, field)
    if value is None:
        return nan
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError("must be a number or null", field=field, value=value)
    if abs(value) > _GREATEST or not isfinite(value):
        raise InputError(f"must be within ±{_GREATEST:g}", field=field, value=value)
    return float(value)
