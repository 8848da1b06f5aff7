"""Life tests from CSV files, as people write them; and published ones.

One row a bearing, or so many alike. Columns by their names, in English or Portuguese, in any order
and case, with or without a unit in brackets:

=========  ==============================================================  =======================
column     names                                                           holds
=========  ==============================================================  =======================
time       time, life, tempo, vida; hours, horas, Mrev, revolutions, ...   failure or suspension
status     status, event, delta, E; failed, falha; censored, suspenso, ... failed or suspended
lower      lower, left, last_inspection, from, inferior, ...               last inspection passed
upper      upper, right, superior, ... (or a time)                         found failed; blank: none
count      count, quantity, freq, quantidade, ...                          bearings in this row
group      group, lot, condition, grupo, lote, condicao, ...               label
rig        rig, test, bancada, ensaio, ...                                 label: ended together
machine    machine, position, equipment, maquina, posicao, ...             as rig, where it fits
size       size, rig_size, bearings_per_rig, tamanho, ...                  bearings in the rig
mode       mode, failure_mode, cause, modo_de_falha, causa, ...            how a bearing failed
=========  ==============================================================  =======================

Only a time is needed; without a status all failed, unless a column that is not read could be one:
then the user is asked. Of inspections without an upper end the bearings had not failed at the
lower one. Status words: failed, f, 1, true, yes, falha,
sim; suspended, censored, s, c, 0, false, no, suspenso, nao. In a column named failed or falha "s"
means sim; in one named censored or suspenso 1 means suspended. Of two such columns the one that
holds status words is read. Machines whose bearings ended at several times are no rigs: a note says
that they were not read. With `size`, a row is a rig of so
many bearings that stopped at its first failure (sudden death): the others are suspended.

A failed bearing whose mode is blank, or a word such as unknown, failed by an unknown mode. Without
a status the modes say what failed: a word of suspension (or 0) in their column is a suspension, and
a blank cell is asked about. Lives between two dates are brought into this form by
`rolamento.weibull.table_forms`.

Tables are read by `rolamento.io.tables`: any separator, either decimal mark. Of the comments
``# unit: Mrev``, ``# title:`` and ``# source:`` are read. Columns named bearing, id, date, note,
comment, procedure and their like are passed over, and all others that are not known, which a note
names, if they cannot change the result.
"""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from importlib import resources
from typing import Any, Final

from rolamento.errors import InputError, UnknownKeyError, arguments, phrase
from rolamento.io.columns import (
    COLUMN_OF,
    check_names,
    column_by_name,
    folded_name,
    heads_table,
    place_of,
    word_and_unit,
)
from rolamento.io.numerals import Numerals
from rolamento.io.tables import Table, parse_table, table_text
from rolamento.records import frozen
from rolamento.validate import one_of
from rolamento.weibull.life_test import (
    LONGEST_LABEL,
    MAXIMUM_ROWS,
    MAXIMUM_TIME,
    MAXIMUM_UNITS,
    MINIMUM_TIME,
    LifeTest,
)
from rolamento.weibull.table_forms import in_usual_form
from rolamento.words import Note, marked, said


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
_YES: Final = _words("1 true yes y x sim s v verdadeiro ja j si wahr verdadero")
_NO: Final = _words("0 false no n nao f falso nein falsch") | {""}
_SAYINGS: Final = {
    "status": (_FAILED, _SUSPENDED, "failed, suspended"),
    "failed": (_YES | _FAILED - {"f"}, _NO | _SUSPENDED - {"s"}, "yes, no"),
    "suspended": (_NO | {"failed"}, _YES | _SUSPENDED - _NO, "yes, no"),
}
"""Words for failed and for suspended in a column of each kind, and examples."""
_KINDS_OF_STATUS: Final = ("status", "failed", "suspended")
_UNKNOWN: Final = _words(
    "unknown not_known unidentified undetermined n_a na nd desconhecido desconhecida"
    " indeterminado indeterminada nao_identificado nao_identificada ignorado ignorada"
) | {""}
"""Words of a mode that is not known; one without letters, such as a dash or "?", is none either."""
_NO_MODE: Final = {word for word in _SUSPENDED if len(word) > 1} | _words(
    "0 cen cens none no_failure nenhum nenhuma"
)
"""Words in a column of modes that say that a bearing did not fail, where no status does."""
_CHOICES: Final = ("time", "group", "count", "mode", *_KINDS_OF_STATUS)
_SILENT: Final = ("bearing", "remark", "date")
"""Columns that a life test has no use for, and everybody knows."""
_UNREAD: Final = ("value", "tag", "clock")
_READ: Final = [
    word for word, column in COLUMN_OF.items() if column not in (*_SILENT, *_UNREAD, "machine")
]
_NO_END: Final = frozenset(("", "inf", "infinity", "infinite", "oo", "na", "nan", "infinito"))
"""Upper ends of an interval, folded, in which a bearing has not failed; ∞ and - fold to nothing."""
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
    mode: str | None = None,
    decimal_mark: str | None = None,
    ignored: Sequence[str] = (),
    **dates: Any,
) -> LifeTest:
    """Read a life test from a CSV file.

    Parameters
    ----------
    path
        Of the file, of 5 MB and 100 000 rows at most; ``"-"`` for standard input.
    group, time, status, count, mode
        Names of the columns that hold the groups, the times, whether a bearing failed, how many
        bearings a row stands for, and by which mode they failed, in place of the usual ones.
    unit
        Label of the times, in place of what the file says; "h" where it says nothing.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the file shows whether 12.500 is 12.5.
    ignored
        Names of columns that have nothing to say, though they could.
    **dates
        start, end, use_per_day, as_of and date_order of lives between two dates, as of
        `rolamento.weibull.table_forms.in_usual_form`.

    Raises
    ------
    FileError, InputError
        With line, column and an example, if the file cannot be read, is no life test, or has a
        column that is not read and could say what failed.
    """
    return parse_life_test(
        *table_text(path),
        group=group,
        unit=unit,
        time=time,
        status=status,
        count=count,
        mode=mode,
        decimal_mark=decimal_mark,
        ignored=ignored,
        **dates,
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
    mode: str | None = None,
    decimal_mark: str | None = None,
    ignored: Sequence[str] = (),
    **dates: Any,
) -> LifeTest:
    """Read a life test from the text of a CSV file.

    Parameters
    ----------
    text
        As described in the module.
    source
        What to call the text in messages.
    group, unit, time, status, count, mode, decimal_mark, ignored, **dates
        As of `read_life_test`.

    Raises
    ------
    FileError, InputError
        If it is no life test.
    """
    wanted = {"group": group, "time": time, "status": status, "count": count, "mode": mode}
    chosen = {name: title for name, title in wanted.items() if title is not None}
    is_header = heads_table(*chosen.values())
    table = parse_table(text, source, most_rows=MAXIMUM_ROWS, example=_EXAMPLE, is_header=is_header)
    try:
        check_names(table.header, _EXAMPLE)
    except InputError as error:
        raise table.placed(error) from None
    table, remarks = in_usual_form(table, chosen, decimal_mark=decimal_mark, **dates)
    try:
        header = header_of(table.header, chosen, table.rows, ignored)
        check_status(header, table.rows, ignored)
    except InputError as error:
        raise table.placed(error) from None
    rows = _rows_of(table, header, decimal_mark)
    label = unit or table.said.get("unit") or header.unit or "h"
    _refuse_modes_as_groups(rows, header, table)
    try:
        return _life_test_of(rows, header, label, table.said, source, remarks)
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
    rows: list[Row],
    header: Header,
    unit: str,
    said: Mapping[str, str],
    source: str,
    remarks: tuple[Note, ...],
) -> LifeTest:
    """Put the rows together; a row of a rig with a size becomes two."""
    idle = sum(row.count for row in rows if row.mode and not row.failed)
    if idle:
        remarks = (*remarks, Note("modes_of_suspended", {"count": idle}))
    if header.has_size:
        rows = [part for i, row in enumerate(rows) for part in row.parted(f"rig {i + 1}")]
    columns: dict[str, Any] = {
        "lower": [row.lower for row in rows],
        "counts": [row.count for row in rows],
        "group": [row.group for row in rows],
        "mode": [row.mode if row.failed else "" for row in rows],
        "remarks": remarks,
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


def published_life_test(name: str, **columns: Any) -> LifeTest:
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


@frozen
class Header:
    """Which cell holds what, by column.

    titles: of all cells. names: titles by column. unit: that of the header, or an empty text.
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


@frozen
class Row:
    """One row of the table; size 0 without."""

    time: float
    failed: bool
    lower: float
    count: int
    group: str
    rig: str
    size: int
    mode: str = ""

    def parted(self, label: str) -> list[Row]:
        """Part a rig into the bearing that failed and those that were suspended."""
        rig = self.rig or label
        failed = replace(self, count=1, rig=rig)
        others = self.size - 1 if self.failed else self.size
        suspended = replace(self, failed=False, count=others, rig=rig)
        return [failed] * self.failed + [suspended] * (others > 0)


def header_of(
    cells: Sequence[str],
    wanted: Mapping[str, str],
    rows: Sequence[Sequence[str]] = (),
    ignored: Sequence[str] = (),
) -> Header:
    """Find the columns by the cells of the header.

    wanted: titles of the columns ``time``, ``status``, ``group``, ``count`` and ``mode``, over the
    usual names. rows: of the table; of two columns that may be the status they decide which one is.
    ignored: titles of columns that are not read, whatever their names say.
    """
    chosen = _chosen_columns(cells, wanted)
    left_out = {folded_name(title) for title in ignored}
    places: dict[str, int] = {}
    unit = ""
    unknown: list[int] = []
    passed_over: list[int] = []
    for place, column in enumerate(_columns_told(cells, wanted, rows)):
        if place in chosen:
            kind = chosen[place]
            column = column if kind == "status" and column in _KINDS_OF_STATUS else kind
        elif folded_name(cells[place]) in left_out:
            passed_over.append(place)
            continue
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
    upper = places.pop("upper", None)
    if upper is not None and "time" in places:
        unknown.append(upper)
    elif upper is not None:
        places["time"] = upper
        unit = word_and_unit(cells[upper])[1]
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
        tuple(cells[place] for place in sorted({*unknown, *passed_over})),
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


def check_status(
    header: Header, rows: Sequence[Sequence[str]], ignored: Sequence[str] = ()
) -> None:
    """Refuse a test whose status may be read in two ways, or lies in a column that is not read.

    All bearings would count as failed.

    ignored: titles of columns that have nothing to say.
    """
    kinds = [kind for kind in _KINDS_OF_STATUS if kind in header.places]
    if kinds:
        _check_letters(kinds[0], header, rows)
        return
    left_out = {folded_name(title) for title in ignored}
    for place, title in enumerate(header.titles):
        kind = column_by_name(word_and_unit(title)[0])
        if place in header.places.values() or folded_name(title) in left_out or kind == "date":
            continue
        words = {folded_name(row[place]) for row in rows}
        named = title in header.passed_over and kind in (None, "mode")
        if not _may_say_what_failed(words, kind, named=named):
            continue
        rule = said(
            "seems to say what failed, but by an unknown name; choose it as the status, or leave"
            " it out"
        )
        if kind == "mode" and "" in words:
            rule = said(
                "is blank where nothing failed, it seems; add a column status, or leave it out"
            )
        elif folded_name(title) in _EITHER:
            rule = said(
                "may hold 1 for what failed or for what was censored; call it failed or censored,"
                " or choose it as the status if 1 is a failure"
            )
        raise InputError(rule, field=title, example=arguments(status=title, ignored=[title]))


_EITHER: Final = _words("c cens censor censor_flag cens_flag ic zens")
"""Names of columns in which 1 is a failure in some programs and a suspension in others."""


def _may_say_what_failed(words: set[str], kind: str | None, *, named: bool) -> bool:
    """Whether a column that is not read holds what decides: words of failure, or one of two.

    named: whether it is a column that a note names; others, as of bearings, are known to be none.
    """
    filled = words - {""}
    known = {word for word in _FAILED | _SUSPENDED if len(word) > 1 and not word.isdecimal()}
    if filled and filled <= known:
        return True
    if not named:
        return False
    letters = filled <= {"f", "s", "c"} and "f" in words and len(words) > 1
    numbers = all(re.fullmatch(r"[\d_]+", word) for word in filled)
    flags = filled <= {"0", "1"} and bool(filled)
    if len(words) == 2 and numbers:
        return flags
    return (
        letters
        or flags
        or (len(words) == 2 and bool(filled))
        or (kind == "mode" and "" in words and bool(filled))
    )


def _check_letters(kind: str, header: Header, rows: Sequence[Sequence[str]]) -> None:
    """Refuse a status of S and N: sim and não, or suspended and no."""
    words = {folded_name(row[header.places[kind]]) for row in rows}
    if kind == "status" and {"s", "n"} <= words <= {"s", "n", ""}:
        raise InputError(
            said("may hold yes and no (sim, não) or suspended; call it failed, or write the words"),
            field=header.titles[header.places[kind]],
            value="S",
        )


def row_of(cells: Sequence[str], header: Header, numerals: Numerals) -> Row:
    """Read one row."""
    given = {column: cells[place] for column, place in header.places.items()}
    titles = header.names
    is_open = "lower" in given and folded_name(given["time"]) in _NO_END
    end = "lower" if is_open else "time"
    time = number_in(given[end], titles[end], numerals)
    if not MINIMUM_TIME <= time <= MAXIMUM_TIME:
        raise InputError(
            said("must be positive and at most {most:.6g}", most=MAXIMUM_TIME),
            field=titles[end],
            value=given[end],
            example="120.5",
        )
    states = any(kind in given for kind in _KINDS_OF_STATUS)
    failed = says_failed(given, titles) if states or not is_open else False
    if failed and is_open:
        rule = said("has no upper end, but the bearing is said to have failed")
        raise InputError(rule, field=titles["time"], value=given["time"], example="120.5")
    found = "" if is_open or given.get("lower") == given["time"] else given.get("lower", "")
    return Row(
        time,
        failed,
        _last_inspection(found, titles, time, failed, numerals),
        whole_number_in(given, titles, "count"),
        _label_in(given, titles, "group"),
        _label_in(given, titles, "rig"),
        whole_number_in(given, titles, "size") if "size" in given else 0,
        _mode_in(given, titles),
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
            example=phrase(
                marked("{header}; or {argument}"),
                header="time,status",
                argument=arguments(time="name of the column"),
            ),
        )
    if sum(name in places for name in _KINDS_OF_STATUS) > 1:
        raise InputError(
            said("says in two columns whether a bearing failed"),
            field="header",
            example=arguments(status="name of the column"),
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
    return "mode" not in given or _mode_says_failed(given["mode"], titles["mode"])


def _mode_says_failed(cell: str, title: str) -> bool:
    """Whether a bearing failed, by the mode alone."""
    if not cell:
        raise InputError(
            said(
                "is blank, and no column says what failed: write suspended for a bearing that did"
                " not fail, and unknown for a failure whose mode is not known"
            ),
            field=title,
            example="suspended",
        )
    return folded_name(cell) not in _NO_MODE


def _last_inspection(
    cell: str, titles: dict[str, str], time: float, failed: bool, numerals: Numerals
) -> float:
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


def _mode_in(given: dict[str, str], titles: dict[str, str]) -> str:
    """Label of the mode; empty where it is not known, and for words that name none."""
    label = _label_in(given, titles, "mode")
    return "" if folded_name(label) in _UNKNOWN | _NO_MODE else label


def _refuse_modes_as_groups(rows: Sequence[Row], header: Header, table: Table) -> None:
    """Refuse groups that only failed bearings have: they are modes of failure.

    A group whose every bearing failed would make a life of the failures alone.
    """
    groups = {row.group for row in rows if row.failed}
    if len(groups) < 2 or "" in groups or all(row.failed for row in rows):
        return
    if any(row.group for row in rows if not row.failed):
        return
    title = header.names["group"]
    raise InputError(
        said(
            "is blank for all bearings that did not fail: it seems to hold failure modes, which"
            " are no groups, as any bearing may fail by any of them"
        ),
        field=title,
        example=arguments(mode=title),
        source=table.source,
        line=table.header_line,
    )


def _label_in(given: dict[str, str], titles: dict[str, str], column: str) -> str:
    cell = given.get(column, "")
    if len(cell) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            said("must be one line of at most {most} characters", most=LONGEST_LABEL),
            field=titles[column],
            value=cell,
        )
    return cell
