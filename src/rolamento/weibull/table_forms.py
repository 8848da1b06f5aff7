"""Tables of lives between two dates.

Two columns, of the day a bearing went into service and of the day it failed or was removed, become
a column of lives: the days between, or with a use per day (stated, or from a column such as "hours
per day") days times use. A bearing without a second date is still running on the day of the data,
which has to be stated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date, datetime
from typing import Final

from rolamento.errors import InputError, arguments
from rolamento.io.columns import column_by_name, folded_name, place_of, title_parts
from rolamento.io.dates import Dates, dates_of, days_between, moment_said
from rolamento.io.numerals import Numerals
from rolamento.io.tables import Table
from rolamento.weibull.life_units import life_with_unit
from rolamento.words import Note, said

__all__ = ["DATES", "in_usual_form", "place_of_use"]


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_IN_SERVICE: Final = _words(
    "in_service_date date_in_service installed installed_on install_date installation_date"
    " date_installed date_of_installation start_date date_of_start commissioned commissioning_date"
    " mounted mounted_on mounting_date data_de_instalacao data_instalacao instalado_em instalacao"
    " data_de_montagem data_montagem montado_em data_de_entrada_em_servico entrada_em_servico"
    " data_de_inicio data_inicio"
)
_FAILED_ON: Final = _words(
    "failure_date date_of_failure failed_on date_failed data_da_falha data_de_falha data_falha"
    " falhou_em"
)
_ENDED_ON: Final = _FAILED_ON | _words(
    "end_date date_of_end removal_date removed_on date_removed date_of_removal retired_on"
    " suspension_date replacement_date replaced_on failure_or_suspension_date data_final"
    " data_de_retirada data_retirada retirado_em data_da_troca data_troca trocado_em"
    " data_de_substituicao data_fim data_de_desmontagem"
)
_USE: Final = _words(
    "usage use daily_use use_per_day usage_per_day hours_per_day h_d h_per_day utilisation"
    " utilization uso uso_diario uso_por_dia regime horas_por_dia horas_dia h_dia h_por_dia"
    " utilizacao"
)
_STATUS: Final = ("status", "failed", "suspended")
DATES: Final = ("start", "end", "use_per_day", "as_of", "date_order")
"""What may be stated of lives between two dates, as of `in_usual_form`."""


def in_usual_form(
    table: Table,
    chosen: Mapping[str, str],
    *,
    start: str | None = None,
    end: str | None = None,
    use_per_day: str | None = None,
    as_of: str | date | None = None,
    date_order: str | None = None,
    decimal_mark: str | None = None,
) -> tuple[Table, tuple[Note, ...]]:
    """Return a table with one time a bearing, and what is to be known of how it came about.

    Parameters
    ----------
    table
        As it was read.
    chosen
        Columns that were chosen by their titles: these are left as they are.
    start, end
        Titles of the columns of the two dates, in place of the usual ones.
    use_per_day
        What a bearing runs a day, such as "16 h"; by default lives are in days.
    as_of
        Day of the data, on which a bearing without a second date is still running.
    date_order
        "day_first" or "month_first", where the dates do not show it.
    decimal_mark
        Of the column of the use per day.

    Raises
    ------
    InputError
        With the line, if a cell is no such date, or it is not stated what has to be.
    """
    stated = start is not None or end is not None
    if "time" not in chosen or stated:
        places = _places_of_dates(table, start, end)
        if places is not None:
            return _between_dates(
                table, chosen, places, use_per_day, as_of, date_order, decimal_mark
            )
    for name, value in (("use_per_day", use_per_day), ("as_of", as_of), ("date_order", date_order)):
        if value is not None:
            rule = said("goes with lives between two dates, of which the table has no columns")
            raise InputError(rule, field=name, value=str(value), source=table.source)
    return table, ()


# --- dates ----------------------------------------------------------------------------------------


def _places_of_dates(table: Table, start: str | None, end: str | None) -> tuple[int, int] | None:
    """Places of both columns of dates; None where a table has none, or has times as well."""
    names = [folded_name(title_parts(title)[0]) for title in table.header]
    places = []
    for title, known, other in ((start, _IN_SERVICE, end), (end, _ENDED_ON, start)):
        if title is not None:
            try:
                places.append(place_of(table.header, title))
            except InputError as error:
                raise table.placed(error) from None
            continue
        found = [place for place, name in enumerate(names) if name in known]
        if not found and other is not None:
            rule = said("needs a second column of dates")
            raise InputError(
                rule, field=other, source=table.source, line=table.header_line,
                example=arguments(start="installed", end="removed"),
            )  # fmt: skip
        if not found:
            return None
        places.append(found[0])
    by_choice = start is not None or end is not None
    if not by_choice and any(column_by_name(name) == "time" for name in names):
        return None  # it gives the times themselves
    return places[0], places[1]


def _between_dates(
    table: Table,
    chosen: Mapping[str, str],
    places: tuple[int, int],
    use_per_day: str | None,
    as_of: str | date | None,
    date_order: str | None,
    decimal_mark: str | None,
) -> tuple[Table, tuple[Note, ...]]:
    dates = dates_of([row[place] for row in table.rows for place in places], date_order)
    first, last = places
    dates.check(table.header[first])
    until = _day_of_data(as_of)
    use = place_of_use(table.header, None, set(places)) if use_per_day is None else None
    numerals = table.numerals([] if use is None else [use], decimal_mark)
    daily, unit = (
        (1.0, "d") if use_per_day is None else life_with_unit(use_per_day, "use_per_day", "16 h")
    )
    if use is not None:
        unit = title_parts(table.header[use])[1].partition("/")[0].strip() or "h"
    if unit.casefold() in ("h", "hours", "horas") and daily > 24.0:
        raise InputError(said("must be at most 24 h a day"), field="use_per_day", value=use_per_day)
    kinds = [column_by_name(folded_name(title_parts(title)[0])) for title in table.header]
    has_status = "status" in chosen or any(kind in _STATUS for kind in kinds)
    says_failure = folded_name(table.header[last]) in _FAILED_ON
    rows, running = [], 0
    for number, cells in enumerate(table.rows):
        try:
            begun = _moment(cells[first], dates, table.header[first])
            blank = not cells[last]
            if blank:
                running += 1
                _check_running(table.header[last], until, has_status or says_failure)
                assert until is not None
                ended = until
            else:
                ended = _moment(cells[last], dates, table.header[last])
            each = daily if use is None else _use(cells[use], table.header[use], numerals)
            days = days_between((begun, ended), table.header[last])[1]
            if not days > 0.0:
                rule = said("must be after the day on which the bearing went into service")
                shown = cells[last] if not blank else moment_said(ended)
                raise InputError(rule, field=table.header[last], value=shown)
        except InputError as error:
            raise table.placed(error, number) from None
        status = () if has_status else ("suspended" if blank else "failed",)
        rows.append((*cells, repr(days * each), *status))
    titles = (f"time ({unit})",) if has_status else (f"time ({unit})", "status")
    values = {"first": table.header[first], "last": table.header[last], "unit": unit}
    if use is not None:
        note = Note("lives_from_dates_and_column", {**values, "column": table.header[use]})
    elif use_per_day is not None:
        note = Note("lives_from_dates_and_use", {**values, "use": daily})
    else:
        note = Note("lives_from_dates", values)
    notes: tuple[Note, ...] = (note,)
    if running and until is not None:
        notes += (Note("running_on_day_of_data", {"count": running, "day": moment_said(until)}),)
    kept = [place for place in range(len(table.header)) if place not in (first, last, use)]
    header = (*(table.header[place] for place in kept), *titles)
    behind = len(table.header)
    cut = tuple((*(row[place] for place in kept), *row[behind:]) for row in rows)
    return replace(table, header=header, rows=cut), notes


def _moment(cell: str, dates: Dates, title: str) -> datetime:
    found = dates.moment(cell)
    if found is None:
        raise InputError(said("must be a date"), field=title, value=cell, example="2024-02-29")
    return found


def _day_of_data(as_of: str | date | None) -> datetime | None:
    if not isinstance(as_of, str):
        return None if as_of is None else datetime(as_of.year, as_of.month, as_of.day)
    text = as_of.strip()
    dates = dates_of([text])
    found = dates.moment(text)
    if found is None or dates.doubt:
        rule = said("must be a date whose day and month cannot be taken for each other")
        raise InputError(rule, field="as_of", value=as_of, example=arguments(as_of="2026-12-31"))
    return found


def _check_running(title: str, until: datetime | None, says_what_failed: bool) -> None:
    if not says_what_failed:
        rule = said(
            "is blank for some bearings, and nothing says which of the others failed: a column of"
            " the status is needed"
        )
        raise InputError(rule, field=title, example="failed, suspended")
    if until is None:
        rule = said("is blank: until which day has the bearing been running?")
        raise InputError(rule, field=title, example=arguments(as_of="2026-12-31"))


def _use(cell: str, title: str, numerals: Numerals) -> float:
    value = numerals.number(cell)
    if value is None or not 0.0 < value <= 1e9:
        raise InputError(said("must be a positive number"), field=title, value=cell, example="16")
    return value


def place_of_use(header: Sequence[str], usage: str | None, taken: set[int]) -> int | None:
    """Place of the column of the daily use; None without."""
    if usage is not None:
        return place_of(header, usage)
    for place, title in enumerate(header):
        names = {folded_name(title), folded_name(title_parts(title)[0])}
        if place not in taken and names & _USE:
            return place
    return None
