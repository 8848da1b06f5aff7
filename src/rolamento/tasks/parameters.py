"""Parameters of tasks: how their values are read, and how an error calls them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final, TypeVar

from rolamento.errors import InputError, arguments, respelled

_SPEED_EXAMPLE: Final = arguments(speed="1797 rpm")

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
        example = arguments(**{parameter: error.example})
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
        Its field or source may be a parameter; its rule and example may be a `Phrase`.
    names
        The other name of each parameter.
    written
        Writes a parameter, by its other name, with a value.
    between
        What to write between two parameters.
    """
    is_of_parameter = error.source in names
    return type(error)(
        respelled(error.rule, names, written, between),
        field=error.field if is_of_parameter else names.get(error.field, error.field),
        value=error.value,
        example=respelled(error.example, names, written, between),
        source=names.get(error.source, error.source),
        line=error.line,
    )
