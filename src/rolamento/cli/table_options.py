"""Options of tables that a user brings, and what is wrong with them in the words of options."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Final

import typer

from rolamento.errors import InputError, respelled

__all__ = ["DecimalMarkOption", "told_in_options"]

_OPTIONS: Final = {"decimal_mark": "--decimal-mark"}
DecimalMarkOption = Annotated[
    str | None,
    typer.Option(
        "--decimal-mark",
        metavar="MARK",
        help="Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.",
    ),
]


@contextmanager
def told_in_options() -> Iterator[None]:
    """Say what is wrong with a table in the words of the command."""
    from rolamento.cli.option_names import written

    try:
        yield
    except InputError as error:
        raise error.with_details(
            rule=respelled(error.rule, _OPTIONS, written, between=" "),
            field=_OPTIONS.get(error.field, error.field),
            example=respelled(error.example, _OPTIONS, written, between=" "),
        ) from None
