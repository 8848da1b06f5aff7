"""Life tests from CSV files, as people write them; and published ones.

One row a bearing, or so many alike. Columns by their names, in English or Portuguese, in any order
and case, with or without a unit in brackets:

=========  ==============================================================  =======================
column     names                                                           holds
=========  ==============================================================  =======================
time       time, life, tempo, vida; hours, horas, Mrev, revolutions, ...   failure or suspension
status     status, state, estado; failed, falha; censored, suspenso, ...   failed or suspended
lower      lower, last_inspection, from, inferior, ultima_inspecao, ...    last inspection passed
count      count, quantity, freq, quantidade, ...                          bearings in this row
group      group, lot, condition, grupo, lote, condicao, ...               label
rig        rig, test, bancada, ensaio, ...                                 label: ended together
machine    machine, position, equipment, maquina, posicao, ...             as rig, where it fits
size       size, rig_size, bearings_per_rig, tamanho, ...                  bearings in the rig
=========  ==============================================================  =======================

Only a time is needed; without a status all failed. Status words: failed, f, 1, true, yes, falha,
sim; suspended, censored, s, c, 0, false, no, suspenso, nao. In a column named failed or falha "s"
means sim; in one named censored or suspenso 1 means suspended. Of two such columns the one that
holds status words is read. Machines whose bearings ended at several times are no rigs: a note says
that they were not read. With `size`, a row is a rig of so
many bearings that stopped at its first failure (sudden death): the others are suspended.

Tables are read as `rolamento.io.tables` tells: any separator, either decimal mark. Of the comments
``# unit: Mrev``, ``# title:`` and ``# source:`` are read. Columns named bearing, id, date, note,
comment, procedure and their like are passed over, and all others that are not known, which a note
names.
"""

from __future__ import annotations

import difflib
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import resources
from typing import Any, Final

from rolamento.errors import InputError, UnknownKeyError
from rolamento.io.columns import (
    COLUMN_OF,
    check_names,
    column_by_name,
    folded_name,
    place_of,
    word_and_unit,
)
from rolamento.io.tables import Numerals, Table, parse_table, table_text
from rolamento.weibull._checks import one_of
from rolamento.weibull.life_test import (
    LONGEST_LABEL,
    MAXIMUM_ROWS,
    MAXIMUM_TIME,
    MAXIMUM_UNITS,
    MINIMUM_TIME,
    LifeTest,
)
from rolamento.words import said


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_EXAMPLE: Final = "time,status"
PUBLISHED: Final = ("lieblein_zelen_1956", "campanha_2008")
"""Life tests of ball bearings that come with the package.

"lieblein_zelen_1956": 23 deep-groove ball bearings, all failed, in millions of revolutions.
"campanha_2008": 24 bearings 6305 in two conditions (the groups), most of them in pairs, in hours.
"""
_FAILED: Final = _words(
    "failed failure fail f x 1 true yes y broken dead falha falhou falhado sim quebrou quebrado"
    " avaria avariado avariou broke breakdown defect spalled corrective defeito defeituoso"
    " quebra quebrada falhada com_falha corretiva corretivo manutencao_corretiva troca_corretiva"
)
_SUSPENDED: Final = _words(
    "suspended suspension censored s c 0 false no n nao suspenso suspensao censurado runout running"
    " survived unfailed removed in_service in_operation ok sem_falha nao_falhou em_operacao"
    " operando rodando em_servico em_funcionamento sobreviveu retirado suspensa censurada"
    " no_failure not_failed good working operational active preventive right_censored censoring"
    " sem_defeito sem_avaria em_uso em_trabalho funcionando bom boa ativo ativa preventiva"
    " preventivo manutencao_preventiva troca_preventiva retirada suspensoes"
)
_YES: Final = _words("1 true yes y x sim s v verdadeiro")
_NO: Final = _words("0 false no n nao f falso") | {""}
_SAYINGS: Final = {
    "status": (_FAILED, _SUSPENDED, "failed, suspended"),
    "failed": (_YES | _FAILED - {"f"}, _NO | _SUSPENDED - {"s"}, "yes, no"),
    "suspended": (_NO | {"failed"}, _YES | _SUSPENDED - _NO, "yes, no"),
}
"""Words for failed and for suspended in a column of each kind, and examples."""
_KINDS_OF_STATUS: Final = ("status", "failed", "suspended")
_CHOICES: Final = ("time", "group", "count", *_KINDS_OF_STATUS)
_SILENT: Final = ("bearing", "remark", "date")
"""Columns that a life test has no use for, and everybody knows."""
_UNREAD: Final = ("value", "tag")
_READ: Final = [
    word for word, column in COLUMN_OF.items() if column not in (*_SILENT, *_UNREAD, "machine")
]
_NEAR: Final = 0.8
"""Likeness of a name to a known one from which on it is a slip of the pen, not another column."""


def read_life_test(
    path: str | os.PathLike[str],
    *,
    group: str | None = None,
    unit: str | None = None,
    time: str | None = None,
    status: str | None = None,
    count: str | None = None,
    decimal_mark: str | None = None,
) -> LifeTest:
    """Read a life test from a CSV file.

    Parameters
    ----------
    path
        Of the file, of 5 MB and 100 000 rows at most; ``"-"`` for standard input.
    group, time, status, count
        Names of the columns that hold the groups, the times, whether a bearing failed, and how many
        bearings a row stands for, in place of the usual ones.
    unit
        Label of the times, in place of what the file says; "h" where it says nothing.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file shows whether 12.500 is 12.5.

    Raises
    ------
    FileError, InputError
        With line, column and an example, if the file cannot be read or is no life test.
    """
    return parse_life_test(
        *table_text(path),
        group=group,
        unit=unit,
        time=time,
        status=status,
        count=count,
        decimal_mark=decimal_mark,
    )


def parse_life_test(
    text: str,
    source: str = "",
    *,
    group: str | None = None,
    unit: str | None = None,
    time: str | None = None,
    status: str | None = None,
    count: str | None = None,
    decimal_mark: str | None = None,
) -> LifeTest:
    """Read a life test from the text of a CSV file.

    Parameters
    ----------
    text
        As described in the module.
    source
        What to call the text in messages.
    group, unit, time, status, count, decimal_mark
        As of `read_life_test`.

    Raises
    ------
    FileError, InputError
        If it is no life test.
    """
    table = parse_table(text, source, most_rows=MAXIMUM_ROWS, example=_EXAMPLE)
    wanted = {"group": group, "time": time, "status": status, "count": count}
    chosen = {name: title for name, title in wanted.items() if title is not None}
    try:
        check_names(table.header, _EXAMPLE)
        header = header_of(table.header, chosen, table.rows)
        check_status(header, table.rows)
    except InputError as error:
        raise table.placed(error) from None
    rows = _rows_of(table, header, decimal_mark)
    label = unit or table.said.get("unit") or header.unit or "h"
    try:
        return _life_test_of(rows, header, label, table.said, source)
    except InputError as error:
        raise error.with_details(source=source) from None


def _rows_of(table: Table, header: Header, decimal_mark: str | None) -> list[Row]:
    numbers = [header.places[name] for name in ("time", "lower") if name in header.places]
    numerals = table.numerals(numbers, decimal_mark)
    rows: list[Row] = []
    for number, cells in enumerate(table.rows):
        try:
            rows.append(row_of(cells, header, numerals))
        except InputError as error:
            raise table.placed(error, number) from None
    return rows


def _life_test_of(
    rows: list[Row], header: Header, unit: str, said: Mapping[str, str], source: str
) -> LifeTest:
    """Put the rows together; a row of a rig with a size becomes two."""
    if header.has_size:
        rows = [part for i, row in enumerate(rows) for part in row.parted(f"rig {i + 1}")]
    columns: dict[str, Any] = {
        "lower": [row.lower for row in rows],
        "counts": [row.count for row in rows],
        "group": [row.group for row in rows],
        "unit": unit,
        "title": said.get("title", ""),
        "source": said.get("source", source),
        "passed_over": header.passed_over,
    }
    times, failed = [row.time for row in rows], [row.failed for row in rows]
    try:
        return LifeTest(times, failed, rig=[row.rig for row in rows], **columns)
    except InputError as error:
        if error.field != "rig" or not header.machines:
            raise
    return LifeTest(times, failed, machines=header.machines, **columns)


def published_life_test(name: str, **columns: str | None) -> LifeTest:
    """Return a published life test.

    Parameters
    ----------
    name
        One of `PUBLISHED`.
    **columns
        As of `read_life_test`: ``group="procedure"`` of Campanha.
    """
    return parse_life_test(published_text(name), f"{name}.csv", **columns)


def published_text(name: str) -> str:
    """Return a published life test as CSV, with its source in the comments."""
    one_of(name, "name", PUBLISHED)
    file = resources.files("rolamento.weibull") / "data" / f"{name}.csv"
    return file.read_text(encoding="utf-8")


# --- columns and cells ----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Header:
    """Which cell holds what, by column.

    titles: of all cells. names: titles by column. unit: that the header tells, or an empty text.
    passed_over: titles of what is not known. machines: title of the rigs if they are machines,
    which need not end as one.
    """

    places: dict[str, int]
    titles: tuple[str, ...]
    names: dict[str, str]
    unit: str
    passed_over: tuple[str, ...] = ()
    machines: str = ""

    @property
    def has_size(self) -> bool:
        """Whether rows are rigs."""
        return "size" in self.places


@dataclass(frozen=True, slots=True)
class Row:
    """One row of the table; size 0 without."""

    time: float
    failed: bool
    lower: float
    count: int
    group: str
    rig: str
    size: int

    def parted(self, label: str) -> list[Row]:
        """Part a rig into the bearing that failed and those that were suspended."""
        rig = self.rig or label
        failed = replace(self, count=1, rig=rig)
        others = self.size - 1 if self.failed else self.size
        suspended = replace(self, failed=False, count=others, rig=rig)
        return [failed] * self.failed + [suspended] * (others > 0)


def header_of(
    cells: Sequence[str], wanted: Mapping[str, str], rows: Sequence[Sequence[str]] = ()
) -> Header:
    """Find the columns by the cells of the header.

    wanted: titles of the columns ``time``, ``status``, ``group`` and ``count``, over the usual
    names. rows: of the table; of two columns that may be the status they tell which one is.
    """
    chosen = _chosen_columns(cells, wanted)
    places: dict[str, int] = {}
    unit = ""
    unknown: list[int] = []
    for place, column in enumerate(_columns_told(cells, wanted, rows)):
        if place in chosen:
            kind = chosen[place]
            column = column if kind == "status" and column in _KINDS_OF_STATUS else kind
        elif column in _SILENT:
            continue
        elif column is None or _kind_of(column) in wanted:
            unknown.append(place)
            continue
        if column == "time":
            unit = word_and_unit(cells[place])[1]
        if column in places:
            title = cells[place]
            example = f'{_kind_of(column)}="{title}"' if column in _CHOICES else ""
            raise InputError(
                said("occurs twice, perhaps under another name"), field=title, example=example
            )
        places[column] = place
    machine = places.pop("machine", None)
    if machine is not None and "rig" in places:
        unknown.append(machine)
        machine = None
    elif machine is not None:
        places["rig"] = machine
    _refuse_slips(cells, unknown, places)
    _check_columns(places)
    return Header(
        places,
        tuple(cells),
        {column: cells[place] for column, place in places.items()},
        unit,
        tuple(cells[place] for place in unknown),
        "" if machine is None else cells[machine],
    )


def _columns_told(
    cells: Sequence[str], wanted: Mapping[str, str], rows: Sequence[Sequence[str]]
) -> list[str | None]:
    """What each cell of the header names that a life test has; None for what is not known."""
    columns = [column_by_name(word_and_unit(title)[0]) for title in cells]
    found = [None if column in _UNREAD else column for column in columns]
    statuses = [place for place, column in enumerate(found) if column in _KINDS_OF_STATUS]
    readable = [place for place in statuses if _holds_status(found[place], place, rows)]
    if "status" in wanted or len(readable) != 1:
        return found
    others = set(statuses) - set(readable)
    return [None if place in others else column for place, column in enumerate(found)]


def _holds_status(column: str | None, place: int, rows: Sequence[Sequence[str]]) -> bool:
    failed, not_failed, _ = _SAYINGS[column or ""]
    return {folded_name(row[place]) for row in rows} <= failed | not_failed


def check_status(header: Header, rows: Sequence[Sequence[str]]) -> None:
    """Refuse a test without a status that has it in a column that was passed over.

    All bearings would count as failed.
    """
    if any(kind in header.places for kind in _KINDS_OF_STATUS):
        return
    known = {word for word in _FAILED | _SUSPENDED if len(word) > 1 and not word.isdecimal()}
    for place, title in enumerate(header.titles):
        if title not in header.passed_over:
            continue
        words = {folded_name(row[place]) for row in rows}
        letters = words <= {"f", "s", "c"} and "f" in words and len(words) > 1
        if words <= known or letters:
            raise InputError(
                said(
                    "seems to say what failed, but by an unknown name; choose it as the "
                    "status, or leave it out"
                ),
                field=title,
                example=f'status="{title}"',
            )


def row_of(cells: Sequence[str], header: Header, numerals: Numerals) -> Row:
    """Read one row."""
    given = {column: cells[place] for column, place in header.places.items()}
    titles = header.names
    time = number_in(given["time"], titles["time"], numerals)
    if not MINIMUM_TIME <= time <= MAXIMUM_TIME:
        raise InputError(
            said("must be positive and at most {most:.6g}", most=MAXIMUM_TIME),
            field=titles["time"],
            value=given["time"],
            example="120.5",
        )
    failed = says_failed(given, titles)
    return Row(
        time,
        failed,
        _last_inspection(given, titles, time, failed, numerals),
        whole_number_in(given, titles, "count"),
        _label_in(given, titles, "group"),
        _label_in(given, titles, "rig"),
        whole_number_in(given, titles, "size") if "size" in given else 0,
    )


def _kind_of(column: str) -> str:
    """The column that can be chosen in its place."""
    return "status" if column in _KINDS_OF_STATUS else column


def _chosen_columns(cells: Sequence[str], wanted: Mapping[str, str]) -> dict[int, str]:
    """Columns that were chosen, by their places."""
    chosen: dict[int, str] = {}
    for column, title in wanted.items():
        place = place_of(cells, title)
        if place in chosen:
            raise InputError(said("is chosen for two purposes"), field=title)
        chosen[place] = column
    return chosen


def _refuse_slips(cells: Sequence[str], unknown: Sequence[int], places: Mapping[str, int]) -> None:
    """Refuse names that are nearly those of a column that is not there: they are misspelt."""
    there = {_kind_of(column) for column in places}
    for place in unknown:
        word, _ = word_and_unit(cells[place])
        near = difflib.get_close_matches(word[:60], _READ, n=1, cutoff=_NEAR)
        column = COLUMN_OF[near[0]] if near else ""
        if column and _kind_of(column) not in there:
            raise UnknownKeyError(
                said("is an unknown column; did you mean {near}?", near=near[0]),
                field=cells[place],
            )


def _check_columns(places: Mapping[str, int]) -> None:
    if "time" not in places:
        raise InputError(
            said("has no column of times under a usual name"),
            field="header",
            example='time,status; or time="name of the column"',
        )
    if sum(name in places for name in _KINDS_OF_STATUS) > 1:
        raise InputError(
            said("says in two columns whether a bearing failed"),
            field="header",
            example='status="name of the column"',
        )
    if "size" in places and ("count" in places or "lower" in places):
        raise InputError(said("has rig sizes besides counts or inspections"), field="header")


def says_failed(given: dict[str, str], titles: dict[str, str]) -> bool:
    """Return whether a row says that its bearing failed; all did where nothing says it."""
    for column, (failed, not_failed, examples) in _SAYINGS.items():
        if column not in given:
            continue
        word = folded_name(given[column])
        if word in failed or word in not_failed:
            return word in failed
        raise InputError(
            said("must say whether the bearing failed: {examples}, 1 or 0", examples=examples),
            field=titles[column],
            value=given[column],
            example=examples.split(",")[0],
        )
    return True


def _last_inspection(
    given: dict[str, str], titles: dict[str, str], time: float, failed: bool, numerals: Numerals
) -> float:
    cell = given.get("lower", "")
    if not cell:
        return float("nan")
    lower = number_in(cell, titles["lower"], numerals)
    if not failed:
        raise InputError(
            said("must be empty for a bearing that did not fail"), field=titles["lower"], value=cell
        )
    if not 0.0 <= lower < time:
        raise InputError(
            said("must be at least 0 and below the time"), field=titles["lower"], value=cell
        )
    return lower


def number_in(cell: str, title: str, numerals: Numerals) -> float:
    """Return the number of a cell; refuse what is none, by the title of its column."""
    value = numerals.number(cell)
    if value is None:
        rule = said("must be a number without unit")
        if "," in cell and not numerals.commas:
            rule = said("must have a decimal point where commas separate the cells")
        raise InputError(rule, field=title, value=cell, example="120.5")
    return value


def whole_number_in(given: dict[str, str], titles: dict[str, str], column: str) -> int:
    """Return how many a row says in a column; 1 where there is no such column."""
    cell = given.get(column, "1")
    number = Numerals(commas=True).number(cell)
    if number is None or not 1.0 <= number <= MAXIMUM_UNITS or number != int(number):
        raise InputError(
            said("must be an integer from 1 to {most}", most=MAXIMUM_UNITS),
            field=titles[column],
            value=cell,
            example="4",
        )
    return int(number)


def _label_in(given: dict[str, str], titles: dict[str, str], column: str) -> str:
    cell = given.get(column, "")
    if len(cell) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            said("must be one line of at most {most} characters", most=LONGEST_LABEL),
            field=titles[column],
            value=cell,
        )
    return cell
