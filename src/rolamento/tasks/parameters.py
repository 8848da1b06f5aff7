"""Parameters of tasks: how their values are read."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rolamento.errors import InputError, arguments

_SPEED_EXAMPLE: Final = arguments(speed="1797 rpm")

Progress = Callable[[int, int], None]
"""Called with how much is done, and of how much."""


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
