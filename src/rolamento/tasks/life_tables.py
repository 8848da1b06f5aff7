"""Tables of lives that a user brings: how their columns are found."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Final

from rolamento.tasks.request import DECIMAL_MARK, Input, Request
from rolamento.words import marked

__all__ = ["DATA", "DATE_ORDER", "SHIPPED", "LifeTable"]

DATA: Final = marked("Table")
SHIPPED: Final = ("campanha-2008", "lieblein-zelen-1956")
"""Life tests that come with the package."""
_COLUMNS: Final = (
    "unit", "time", "status", "count", "group", "mode", "ignored", "start", "end", "use_per_day",
    "as_of", "date_order", "decimal_mark",
)  # fmt: skip


def _orders() -> Mapping[str, str]:
    return {"day_first": marked("day first"), "month_first": marked("month first")}


DATE_ORDER: Final = Input(
    "Order of the dates", "choice", DATA, choices=_orders, metavar="ORDER", example="day_first"
)


class LifeTable(Request):
    """A use case that reads a table of lives: what its columns are, where they are not named so.

    Parameters
    ----------
    unit
        Unit of the times, if the file says another.
    time
        Column of the times, if named otherwise.
    status
        Column that says what failed, if named otherwise.
    count
        Column of how many bearings a row stands for, if named otherwise.
    group
        Column of the groups, if named otherwise.
    mode
        Column of the failure modes, if named otherwise.
    ignored
        Column that could say what failed, and does not.
    start
        Column of the days on which bearings went into service, for lives between two dates,
        if named otherwise.
    end
        Column of the days on which bearings failed or were removed, if named otherwise.
    use_per_day
        What a bearing runs a day, such as '16 h', for lives between two dates; by default
        lives are in days.
    as_of
        Day of the data, such as 2026-12-31: bearings without a second date were running
        then.
    date_order
        Order of dates, day_first or month_first, for a table in which 03/04/2024 may be
        either.
    decimal_mark
        Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.
    """

    unit: Annotated[
        str | None, Input("Unit of the times", group=DATA, example="h", metavar="UNIT")
    ] = None
    time: Annotated[
        str | None,
        Input(
            "Column of the times",
            group=DATA,
            example="hours",
            metavar="COLUMN",
            option="--time-column",
        ),
    ] = None
    status: Annotated[
        str | None,
        Input(
            "Column of the status",
            group=DATA,
            example="status",
            metavar="COLUMN",
            option="--status-column",
        ),
    ] = None
    count: Annotated[
        str | None,
        Input(
            "Column of the counts",
            group=DATA,
            example="count",
            metavar="COLUMN",
            option="--count-column",
        ),
    ] = None
    group: Annotated[
        str | None, Input("Column of the groups", group=DATA, example="group", metavar="COLUMN")
    ] = None
    mode: Annotated[
        str | None,
        Input(
            "Column of the failure modes",
            group=DATA,
            example="mode",
            metavar="COLUMN",
            option="--mode-column",
        ),
    ] = None
    ignored: Annotated[
        tuple[str, ...],
        Input(
            "Columns to ignore",
            "list",
            DATA,
            example="remark",
            option="--ignore-column",
            metavar="COLUMN",
            at_computer=True,
        ),
    ] = ()
    start: Annotated[
        str | None,
        Input(
            "Column of the first day in service",
            group=DATA,
            example="installed",
            option="--start-column",
            metavar="COLUMN",
        ),
    ] = None
    end: Annotated[
        str | None,
        Input(
            "Column of the last day in service",
            group=DATA,
            example="failure date",
            option="--end-column",
            metavar="COLUMN",
        ),
    ] = None
    use_per_day: Annotated[
        str | None, Input("Use per day", group=DATA, example="16 h", metavar="TIME")
    ] = None
    as_of: Annotated[
        str | None, Input("Day of the data", group=DATA, example="2026-12-31", metavar="DATE")
    ] = None
    date_order: Annotated[str | None, DATE_ORDER] = None
    decimal_mark: Annotated[str | None, DECIMAL_MARK.below(DATA)] = None

    columns: ClassVar = frozenset({"time", "status", "count", "group", "mode", "unit"})

    @property
    def reading(self) -> dict[str, Any]:
        """What is said of the table, as `rolamento.weibull.read_life_test` takes it."""
        return {name: getattr(self, name) for name in _COLUMNS}
