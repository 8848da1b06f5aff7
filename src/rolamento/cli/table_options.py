"""Options of tables that a user brings, and what is wrong with them in the words of options."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Final

import typer

from rolamento.errors import InputError
from rolamento.tasks.asked import LIFE_TEST, by_name

__all__ = [
    "BearingColumnOption",
    "CountColumnOption",
    "DateOrderOption",
    "DecimalMarkOption",
    "IgnoreColumnOption",
    "StatusColumnOption",
    "TimeColumnOption",
    "ValueColumnOption",
    "told_in_options",
]

_ASKED: Final = by_name(LIFE_TEST)
_OPTIONS: Final = {
    "decimal_mark": "--decimal-mark",
    "date_order": "--date-order",
    "time": "--time-column",
    "status": "--status-column",
    "bearing": "--bearing-column",
    "group": "--group",
    "count": "--count-column",
    "values": "--value-column",
    "ignored": "--ignore-column",
}
_ARGUMENT: Final = re.compile(rf'\b({"|".join(_OPTIONS)})=\[?"([^"]*)"\]?')

DecimalMarkOption = Annotated[
    str | None,
    typer.Option(
        "--decimal-mark",
        metavar="MARK",
        help=_ASKED["decimal_mark"].meaning,
    ),
]
TimeColumnOption = Annotated[
    str | None,
    typer.Option("--time-column", metavar="COLUMN", help=_ASKED["time"].meaning),
]
StatusColumnOption = Annotated[
    str | None,
    typer.Option(
        "--status-column",
        metavar="COLUMN",
        help=_ASKED["status"].meaning,
    ),
]


CountColumnOption = Annotated[
    str | None,
    typer.Option(
        "--count-column",
        metavar="COLUMN",
        help=_ASKED["count"].meaning,
    ),
]
IgnoreColumnOption = Annotated[
    list[str] | None,
    typer.Option(
        "--ignore-column",
        metavar="COLUMN",
        help="Column that could say what failed, and does not. Repeatable.",
    ),
]
BearingColumnOption = Annotated[
    str | None,
    typer.Option(
        "--bearing-column", metavar="COLUMN", help="Column of the bearings, if named otherwise."
    ),
]
ValueColumnOption = Annotated[
    list[str] | None,
    typer.Option(
        "--value-column",
        metavar="COLUMN",
        help="Column of a quantity. Repeatable; by default all with a unit in brackets.",
    ),
]
DateOrderOption = Annotated[
    str | None,
    typer.Option(
        "--date-order",
        metavar="ORDER",
        help="Order of dates, day_first or month_first, for a table in which 03/04/2024 may be"
        " either.",
    ),
]


@contextmanager
def told_in_options(**options: str) -> Iterator[None]:
    """Tell what is wrong with a table, or with an argument, in the words of the command.

    options: those that arguments come from, by their names: ``times="--time"``.
    """
    try:
        yield
    except InputError as error:
        if error.field in options and not error.source:
            raise error.with_details(field="", source=options[error.field]) from None
        if error.source in options:
            raise error.with_details(source=options[error.source]) from None
        raise _told(error) from None


def _told(error: InputError) -> InputError:
    def option(match: re.Match[str]) -> str:
        value = f"'{match[2]}'" if " " in match[2] else match[2]
        return f"{_OPTIONS[match[1]]} {value}"

    own = error.field in ("decimal_mark", "date_order")
    return type(error)(
        _ARGUMENT.sub(option, error.rule),
        field=_OPTIONS[error.field] if own else error.field,
        value=error.value,
        example=_ARGUMENT.sub(option, error.example),
        source=error.source,
        line=error.line,
    )
