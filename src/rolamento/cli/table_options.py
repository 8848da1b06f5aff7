"""Options of tables that a user brings, and what is wrong with them in the words of options."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields
from typing import Annotated, Any, Final

import typer

from rolamento.cli.option_records import with_record
from rolamento.errors import InputError, respelled
from rolamento.records import frozen
from rolamento.tasks.life_tables import LifeTable

__all__ = [
    "ALL_COLUMNS",
    "COLUMN_OPTIONS",
    "DateOrderOption",
    "DecimalMarkOption",
    "LifeColumns",
    "TimeColumnOption",
    "told_in_options",
    "with_life_columns",
]

_ASKED: Final = LifeTable.meanings()
_OPTIONS: Final = {
    "decimal_mark": "--decimal-mark",
    "date_order": "--date-order",
    "time": "--time-column",
    "status": "--status-column",
    "group": "--group",
    "count": "--count-column",
    "mode": "--mode-column",
    "only_mode": "--mode",
    "start": "--start-column",
    "end": "--end-column",
    "use_per_day": "--use-per-day",
    "as_of": "--as-of",
    "ignored": "--ignore-column",
}
DecimalMarkOption = Annotated[
    str | None,
    typer.Option(
        "--decimal-mark",
        metavar="MARK",
        help=_ASKED["decimal_mark"],
    ),
]
TimeColumnOption = Annotated[
    str | None,
    typer.Option("--time-column", metavar="COLUMN", help=_ASKED["time"]),
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


@frozen
class LifeColumns:
    """What options say of a table of lives."""

    unit: Annotated[str | None, typer.Option("--unit", metavar="UNIT", help=_ASKED["unit"])] = None
    time_column: TimeColumnOption = None
    status_column: Annotated[
        str | None,
        typer.Option("--status-column", metavar="COLUMN", help=_ASKED["status"]),
    ] = None
    count_column: Annotated[
        str | None,
        typer.Option("--count-column", metavar="COLUMN", help=_ASKED["count"]),
    ] = None
    mode_column: Annotated[
        str | None,
        typer.Option("--mode-column", metavar="COLUMN", help=_ASKED["mode"]),
    ] = None
    ignore_column: Annotated[
        list[str] | None,
        typer.Option(
            "--ignore-column",
            metavar="COLUMN",
            help="Column that could say what failed, and does not. Repeatable.",
        ),
    ] = None
    start_column: Annotated[
        str | None,
        typer.Option("--start-column", metavar="COLUMN", help=_ASKED["start"]),
    ] = None
    end_column: Annotated[
        str | None, typer.Option("--end-column", metavar="COLUMN", help=_ASKED["end"])
    ] = None
    use_per_day: Annotated[
        str | None,
        typer.Option("--use-per-day", metavar="TIME", help=_ASKED["use_per_day"]),
    ] = None
    as_of: Annotated[str | None, typer.Option("--as-of", metavar="DATE", help=_ASKED["as_of"])] = (
        None
    )
    date_order: DateOrderOption = None
    decimal_mark: DecimalMarkOption = None

    def arguments(self) -> dict[str, Any]:
        """Return them as `rolamento.weibull.read_life_test` calls them."""
        own = {name.removesuffix("_column"): getattr(self, name) for name in COLUMN_OPTIONS}
        ignored = own.pop("ignore")
        return {**own, "ignored": tuple(ignored or ())}


COLUMN_OPTIONS: Final = tuple(one.name for one in fields(LifeColumns))
"""Names of the options of `LifeColumns`."""
ALL_COLUMNS: Final = LifeColumns()
with_life_columns = with_record("columns", LifeColumns)
"""Give a command the options of `LifeColumns`, which it takes as one argument, ``columns``."""


@contextmanager
def told_in_options(**options: str) -> Iterator[None]:
    """Say what is wrong with a table, or with an argument, in the words of the command.

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
    from rolamento.cli.option_names import written

    own = error.field in ("decimal_mark", "date_order", "use_per_day", "as_of", "start", "end")
    return type(error)(
        respelled(error.rule, _OPTIONS, written, between=" "),
        field=_OPTIONS[error.field] if own else error.field,
        value=error.value,
        example=respelled(error.example, _OPTIONS, written, between=" "),
        source=error.source,
        line=error.line,
    )
