"""Parameters of tasks: how their values are read, and how an error calls them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Final, TypeVar

from rolamento.errors import InputError

_VALUE: Final = r'("[^"]*"|\["[^"]*"\]|True|[-+.\d]+(?:e-?\d+)?|…)(?:, (?=([a-z_][a-z_0-9]*)=))?'
_IN_RULE: Final = re.compile(r"(?<![\w.])([a-z_][a-z_0-9]*)=" + _VALUE)
_IN_EXAMPLE: Final = re.compile(r"(?<![\w.])([a-z_][a-z_0-9]*)(?:=| = )" + _VALUE)
"""A parameter with a value, and the name of another one that follows after a comma."""
_SPEED_EXAMPLE: Final = 'speed="1797 rpm"'

Progress = Callable[[int, int], None]
"""Called with how much is done, and of how much."""

Refused = TypeVar("Refused", bound=InputError)


def quietly(done: int, total: int) -> None:
    """Show nobody how far a task is."""


def speed_of(given: str | float | None, parameter: str) -> float | None:
    """Return a speed that is given as text with a unit, or as a number in rad/s; None if it is not.

    Raises
    ------
    InputError
        If it is none.
    """
    if given is None or not isinstance(given, str):
        return given
    from rolamento.units import refuse_thousands, to_si

    try:
        refuse_thousands(given)
    except InputError as error:
        example = f'{parameter}="{error.example}"'
        raise error.with_details(field=parameter, example=example) from None
    try:
        return to_si(given, "angular_speed")
    except InputError as error:
        raise error.with_details(field=parameter, example=_SPEED_EXAMPLE) from None


def renamed(
    error: Refused,
    names: Mapping[str, str],
    written: Callable[[str, str], str] = "{}={}".format,
    between: str = ", ",
) -> Refused:
    """Return an error that calls the parameters by other names.

    Parameters
    ----------
    error
        Its field or source may be a parameter; its rule and example may hold ``name="value"``.
    names
        The other name of each parameter.
    written
        Writes a parameter, by its other name, with a value.
    between
        What to write between two parameters; a comma stays between two values of one.
    """

    def argument(found: re.Match[str]) -> str:
        name, value, following = found.groups()
        if name not in names:
            return found[0]
        comma = "" if following is None else ", " if following == name else between
        return written(names[name], value) + comma

    is_of_parameter = error.source in names
    return type(error)(
        _IN_RULE.sub(argument, error.rule),
        field=error.field if is_of_parameter else names.get(error.field, error.field),
        value=error.value,
        example=_IN_EXAMPLE.sub(argument, error.example),
        source=names.get(error.source, error.source),
        line=error.line,
    )
