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
rig        rig, position, machine, test, bancada, posicao, ensaio, ...     label: ended together
size       size, rig_size, bearings_per_rig, tamanho, ...                  bearings in the rig
=========  ==============================================================  =======================

Only a time is needed; without a status all failed. Status words: failed, f, 1, true, yes, falha,
sim; suspended, censored, s, c, 0, false, no, suspenso, nao. In a column named failed or falha "s"
means sim; in one named censored or suspenso 1 means suspended. With `size`, a row is a rig of so
many bearings that stopped at its first failure (sudden death): the others are suspended.

Tables are read as `rolamento._tables` tells: any separator, either decimal mark. Of the comments
``# unit: Mrev``, ``# title:`` and ``# source:`` are read. Columns named bearing, id, note, comment,
procedure and their like are passed over, and all others that are not known, which are told.
"""

from __future__ import annotations

import difflib
import os
import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib import resources
from typing import Final

from rolamento._tables import Numerals, Table, parse_table, table_text
from rolamento.errors import InputError, UnknownKeyError
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
_NAMES: Final = {
    "time": (
        "time times t life lives lifetime duration end time_to_failure age tempo tempos vida vidas"
        " duracao idade fim to ate ttf tbf run_time running_time runtime operating_time"
        " service_life"
        " hours_run run_hours running_hours operating_hours hours_to_failure time_on_test"
        " tempo_de_operacao tempo_operacao tempo_ate_falha tempo_ate_a_falha tempo_de_vida"
        " tempo_de_funcionamento tempo_de_teste tempo_de_ensaio vida_util horimetro"
        " horas_de_operacao horas_operacao horas_de_trabalho horas_trabalhadas horas_ate_falha"
        " horas_ate_a_falha horas_de_funcionamento horas_rodadas"
    ),
    "status": "status state event outcome estado situacao evento resultado",
    "failed": "failed failure fail is_failed broken falhou falha falhado avaria avariado quebrou",
    "suspended": (
        "suspended suspension censored censoring right_censored runout survived unfailed suspenso"
        " suspensao censurado censura sobreviveu"
    ),
    "lower": (
        "lower lower_bound last_inspection inspection from start previous inferior"
        " limite_inferior ultima_inspecao inspecao inspecao_anterior de"
    ),
    "count": "count counts quantity qty number n freq frequency quantidade contagem qtd numero",
    "group": (
        "group groups lot batch condition series population grupo lote condicao serie populacao"
    ),
    "rig": (
        "rig position machine test stand test_rig station bancada posicao maquina ensaio"
        " dispositivo"
    ),
    "size": (
        "size rig_size group_size bearings_per_rig m tamanho tamanho_do_grupo"
        " rolamentos_por_bancada"
    ),
    "": (
        "bearing bearings id name item specimen sample serial note notes remark remarks comment"
        " comments procedure mode date rolamento rolamentos identificacao nome peca amostra nota"
        " observacao observacoes comentario procedimento modo data"
    ),
}
_UNITS: Final = {
    "h": "h hr hrs hour hours hora horas",
    "Mrev": (
        "mrev mrevs million_revolutions millions_of_revolutions 10_6_rev 10_6_revolutions 1e6_rev"
        " milhoes_de_rotacoes milhoes_de_revolucoes milhoes_de_voltas 10_6_rot"
    ),
    "rev": "rev revs revolutions rotacoes revolucoes voltas",
    "cycles": "cycles ciclos",
    "d": "d day days dia dias",
}
_COLUMN_OF: Final = {word: column for column, words in _NAMES.items() for word in words.split()}
_UNIT_OF: Final = {word: unit for unit, words in _UNITS.items() for word in words.split()}
_FAILED: Final = _words(
    "failed failure fail f x 1 true yes y broken dead falha falhou falhado sim quebrou quebrado"
    " avaria avariado avariou"
)
_SUSPENDED: Final = _words(
    "suspended suspension censored s c 0 false no n nao suspenso suspensao censurado runout running"
    " survived unfailed removed in_service in_operation ok sem_falha nao_falhou em_operacao"
    " operando rodando em_servico em_funcionamento sobreviveu retirado suspensa censurada"
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
_CHOICES: Final = ("time", "group", *_KINDS_OF_STATUS)
_NEAR: Final = 0.8
"""Likeness of a name to a known one from which on it is a slip of the pen, not another column."""


def read_life_test(
    path: str | os.PathLike[str],
    *,
    group: str | None = None,
    unit: str | None = None,
    time: str | None = None,
    status: str | None = None,
    decimal_mark: str | None = None,
) -> LifeTest:
    """Read a life test from a CSV file.

    Parameters
    ----------
    path
        Of the file, of 5 MB and 100 000 rows at most; ``"-"`` for standard input.
    group, time, status
        Names of the columns that hold the groups, the times, and whether a bearing failed, in place
        of the usual ones.
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
    decimal_mark: str | None = None,
) -> LifeTest:
    """Read a life test from the text of a CSV file.

    Parameters
    ----------
    text
        As described in the module.
    source
        What to call the text in messages.
    group, unit, time, status, decimal_mark
        As of `read_life_test`.

    Raises
    ------
    FileError, InputError
        If it is no life test.
    """
    table = parse_table(text, source, most_rows=MAXIMUM_ROWS, example=_EXAMPLE)
    wanted = {"group": group, "time": time, "status": status}
    try:
        header = header_of(table.header, {name: t for name, t in wanted.items() if t is not None})
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
    return LifeTest(
        [row.time for row in rows],
        [row.failed for row in rows],
        lower=[row.lower for row in rows],
        counts=[row.count for row in rows],
        group=[row.group for row in rows],
        rig=[row.rig for row in rows],
        unit=unit,
        title=said.get("title", ""),
        source=said.get("source", source),
        passed_over=header.passed_over,
    )


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
    passed_over: titles of what is not known.
    """

    places: dict[str, int]
    titles: tuple[str, ...]
    names: dict[str, str]
    unit: str
    passed_over: tuple[str, ...] = ()

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


def header_of(cells: Sequence[str], wanted: Mapping[str, str]) -> Header:
    """Find the columns by the cells of the header.

    wanted: titles of the columns ``time``, ``status`` and ``group``, over the usual names.
    """
    chosen = _chosen_columns(cells, wanted)
    places: dict[str, int] = {}
    unit = ""
    unknown: list[int] = []
    for place, title in enumerate(cells):
        word, its_unit = word_and_unit(title)
        column = _column_by_name(word)
        if place in chosen:
            kind = chosen[place]
            column = column if kind == "status" and column in _KINDS_OF_STATUS else kind
        elif column is None or (column and _kind_of(column) in wanted):
            unknown.append(place)
            continue
        if column == "time":
            unit = its_unit
        if not column:
            continue
        if column in places:
            example = f'{_kind_of(column)}="{title}"' if column in _CHOICES else ""
            raise InputError(
                said("occurs twice, perhaps under another name"), field=title, example=example
            )
        places[column] = place
    _refuse_slips(cells, unknown, places)
    _check_columns(places)
    names = {column: cells[place] for column, place in places.items()}
    return Header(places, tuple(cells), names, unit, tuple(cells[place] for place in unknown))


def check_status(header: Header, rows: Sequence[Sequence[str]]) -> None:
    """Refuse a test without a status that has it in a column that was passed over.

    All bearings would count as failed.
    """
    if any(kind in header.places for kind in _KINDS_OF_STATUS):
        return
    known = {word for word in _FAILED | _SUSPENDED if len(word) > 1 and not word.isdecimal()}
    for place, title in enumerate(header.titles):
        if title in header.passed_over and {folded_name(row[place]) for row in rows} <= known:
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
    time = _number_in(given["time"], titles["time"], numerals)
    if not MINIMUM_TIME <= time <= MAXIMUM_TIME:
        raise InputError(
            said("must be positive and at most {most:.6g}", most=MAXIMUM_TIME),
            field=titles["time"],
            value=given["time"],
            example="120.5",
        )
    failed = _says_failed(given, titles)
    return Row(
        time,
        failed,
        _last_inspection(given, titles, time, failed, numerals),
        _whole_number_in(given, titles, "count"),
        _label_in(given, titles, "group"),
        _label_in(given, titles, "rig"),
        _whole_number_in(given, titles, "size") if "size" in given else 0,
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


def place_of(cells: Sequence[str], title: str) -> int:
    """Place of a column by its name as written, or else without accents, case and unit.

    Raises
    ------
    InputError
        If there is none.
    """
    wanted = folded_name(title)
    for names in (
        [cell.casefold() == title.strip().casefold() for cell in cells],
        [wanted == folded_name(cell) for cell in cells],
        [wanted == word_and_unit(cell)[0] for cell in cells],
    ):
        if True in names:
            return names.index(True)
    rule = said(
        "is not a column of the file; the columns are {known}", known=", ".join(filter(None, cells))
    )
    raise InputError(rule, field=title)


def _column_by_name(word: str) -> str | None:
    """What a column holds by its name; empty for remarks and blanks, None if unknown."""
    if word in _COLUMN_OF:
        return _COLUMN_OF[word]
    if word in _UNIT_OF or word.rpartition("_")[0] in _NAMES["time"].split():
        return "time"
    return None if word else ""


def _refuse_slips(cells: Sequence[str], unknown: Sequence[int], places: Mapping[str, int]) -> None:
    """Refuse names that are nearly those of a column that is not there: they are misspelt."""
    there = {_kind_of(column) for column in places}
    for place in unknown:
        word, _ = word_and_unit(cells[place])
        near = difflib.get_close_matches(word[:60], _COLUMN_OF, n=1, cutoff=_NEAR)
        column = _COLUMN_OF[near[0]] if near else ""
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


def word_and_unit(title: str) -> tuple[str, str]:
    """Return the folded name of a column, and its unit."""
    match = re.fullmatch(r"(.*?)[\[(]([^\[\]()]{1,40})[\])]\s*", title)
    name, said = (match[1], match[2].strip()) if match else (title, "")
    word = folded_name(name)
    if said:
        return word, _UNIT_OF.get(folded_name(said), said)
    if word in _UNIT_OF:
        return word, _UNIT_OF[word]
    head, _, tail = word.rpartition("_")
    if head in _COLUMN_OF and tail in _UNIT_OF:
        return word, _UNIT_OF[tail]
    return word, "h" if set(word.split("_")) & {"hours", "horas", "horimetro"} else ""


def _says_failed(given: dict[str, str], titles: dict[str, str]) -> bool:
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
    lower = _number_in(cell, titles["lower"], numerals)
    if not failed:
        raise InputError(
            said("must be empty for a bearing that did not fail"), field=titles["lower"], value=cell
        )
    if not 0.0 <= lower < time:
        raise InputError(
            said("must be at least 0 and below the time"), field=titles["lower"], value=cell
        )
    return lower


def _number_in(cell: str, title: str, numerals: Numerals) -> float:
    value = numerals.number(cell)
    if value is None:
        rule = said("must be a number without unit")
        if "," in cell and not numerals.commas:
            rule = said("must have a decimal point where commas separate the cells")
        raise InputError(rule, field=title, value=cell, example="120.5")
    return value


def _whole_number_in(given: dict[str, str], titles: dict[str, str], column: str) -> int:
    cell = given.get(column, "1")
    number = _number_in(cell, titles.get(column, column), Numerals(commas=True))
    if not 1.0 <= number <= MAXIMUM_UNITS or number != int(number):
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


@lru_cache(maxsize=4096)
def folded_name(word: str) -> str:
    """Return a name without accents and case, its words joined by underscores."""
    plain = unicodedata.normalize("NFKD", word[:200])
    plain = "".join(c for c in plain if not unicodedata.combining(c)).casefold()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")
