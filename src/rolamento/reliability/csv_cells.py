"""The header and the cells of a life test in CSV: names and words to columns and values."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final

from rolamento.errors import FileError, InputError, UnknownKeyError, nearest
from rolamento.reliability._columns import LEAST_TIME, LONGEST_LABEL, MOST_TIME, MOST_UNITS

__all__ = ["Header", "Row", "header_of", "row_of"]


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_MOST_COLUMNS: Final = 100
_NAMES: Final = {
    "time": (
        "time times t life lives lifetime duration end time_to_failure age tempo tempos vida vidas"
        " duracao idade fim to ate"
    ),
    "status": "status state event outcome estado situacao evento resultado",
    "failed": "failed failure fail is_failed falhou falha falhado avaria",
    "suspended": (
        "suspended suspension censored censoring runout suspenso suspensao censurado censura"
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
}
_COLUMN_OF: Final = {word: column for column, words in _NAMES.items() for word in words.split()}
_UNIT_OF: Final = {word: unit for unit, words in _UNITS.items() for word in words.split()}
_FAILED: Final = _words("failed failure fail f x 1 true yes y falha falhou falhado sim")
_SUSPENDED: Final = _words(
    "suspended suspension censored s c 0 false no n nao suspenso suspensao censurado runout running"
    " survived sem_falha nao_falhou"
)
_YES: Final = _words("1 true yes y x sim s v verdadeiro")
_NO: Final = _words("0 false no n nao f falso") | {""}
_SAYINGS: Final = {
    "status": (_FAILED, _SUSPENDED, "failed, suspended"),
    "failed": (_YES | _FAILED - {"f"}, _NO | _SUSPENDED - {"s"}, "yes, no"),
    "suspended": (_NO | {"failed"}, _YES | _SUSPENDED - _NO, "yes, no"),
}
"""Words for failed and for suspended in a column of each kind, and examples."""
_NUMBER: Final = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?")
_LONGEST_NUMBER: Final = 40


@dataclass(frozen=True, slots=True)
class Header:
    """Which cell holds what, by column.

    titles: of all cells. names: titles by column. unit: that the header tells, or an empty text.
    """

    places: dict[str, int]
    titles: tuple[str, ...]
    names: dict[str, str]
    unit: str

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


def header_of(cells: list[str], group: str | None) -> Header:
    """Find the columns by the cells of the header."""
    if len(cells) > _MOST_COLUMNS:
        raise FileError(f"has more than {_MOST_COLUMNS} columns")
    places: dict[str, int] = {}
    unit = ""
    wanted = None if group is None else _folded(group)
    for place, title in enumerate(cells):
        word, said = _word_and_unit(title)
        if wanted is not None and _folded(title) == wanted:
            column = "group"
        elif wanted is not None and _COLUMN_OF.get(word) == "group":
            continue
        else:
            column = _column(title, word)
        if column == "time":
            unit = said
        if not column:
            continue
        if column in places:
            raise InputError("is there twice, perhaps by another name", field=title)
        places[column] = place
    _check(places, wanted, group)
    names = {column: cells[place] for column, place in places.items()}
    return Header(places, tuple(cells), names, unit)


def row_of(cells: list[str], header: Header, decimal_comma: bool) -> Row:
    """Read one row."""
    if len(cells) != len(header.titles):
        advice = "" if decimal_comma else "; with decimal commas part the cells by semicolons"
        raise FileError(f"has {len(cells)} cells where the header has {len(header.titles)}{advice}")
    given = {column: cells[place] for column, place in header.places.items()}
    titles = header.names
    time = _number(given["time"], titles["time"], decimal_comma)
    if not LEAST_TIME <= time <= MOST_TIME:
        raise InputError(
            f"must be above zero, and {MOST_TIME:g} at most",
            field=titles["time"],
            value=given["time"],
            example="120.5",
        )
    failed = _failed(given, titles)
    return Row(
        time,
        failed,
        _lower(given, titles, time, failed, decimal_comma),
        _whole(given, titles, "count"),
        _text(given, titles, "group"),
        _text(given, titles, "rig"),
        _whole(given, titles, "size") if "size" in given else 0,
    )


def _column(title: str, word: str) -> str:
    if word in _COLUMN_OF:
        return _COLUMN_OF[word]
    if word in _UNIT_OF or word.rpartition("_")[0] in _NAMES["time"].split():
        return "time"
    if not word:
        return ""
    near = nearest(word, _COLUMN_OF)
    known = ", ".join(name for name in _NAMES if name not in ("", "failed", "suspended"))
    advice = f"did you mean {near}?" if near else f"known here: {known} (note is passed over)"
    raise UnknownKeyError(f"is not a known column; {advice}", field=title)


def _check(places: dict[str, int], wanted: str | None, group: str | None) -> None:
    if "time" not in places:
        raise InputError("has no column of times", field="header", example="time,status")
    if sum(name in places for name in ("status", "failed", "suspended")) > 1:
        raise InputError("tells in two columns whether a bearing failed", field="header")
    if "size" in places and ("count" in places or "lower" in places):
        raise InputError("has sizes of rigs beside counts or inspections", field="header")
    if wanted is not None and "group" not in places:
        raise InputError("is not a column of the file", field=str(group))


def _word_and_unit(title: str) -> tuple[str, str]:
    """Return the folded name of a column, and the unit that it tells."""
    match = re.fullmatch(r"(.*?)[\[(]([^\[\]()]{1,40})[\])]\s*", title)
    name, said = (match[1], match[2].strip()) if match else (title, "")
    word = _folded(name)
    if said:
        return word, _UNIT_OF.get(_folded(said), said)
    if word in _UNIT_OF:
        return word, _UNIT_OF[word]
    head, _, tail = word.partition("_")
    return (word, _UNIT_OF[tail]) if head in _COLUMN_OF and tail in _UNIT_OF else (word, "")


def _failed(given: dict[str, str], titles: dict[str, str]) -> bool:
    for column, (failed, not_failed, examples) in _SAYINGS.items():
        if column not in given:
            continue
        word = _folded(given[column])
        if word in failed or word in not_failed:
            return word in failed
        raise InputError(
            f"must say whether the bearing failed: {examples}, 1 or 0",
            field=titles[column],
            value=given[column],
            example=examples.split(",")[0],
        )
    return True


def _lower(
    given: dict[str, str], titles: dict[str, str], time: float, failed: bool, decimal_comma: bool
) -> float:
    cell = given.get("lower", "")
    if not cell:
        return float("nan")
    lower = _number(cell, titles["lower"], decimal_comma)
    if not failed:
        raise InputError(
            "must be empty for a bearing that did not fail", field=titles["lower"], value=cell
        )
    if not 0.0 <= lower < time:
        raise InputError("must be 0 or more, and below the time", field=titles["lower"], value=cell)
    return lower


def _number(cell: str, title: str, decimal_comma: bool) -> float:
    example = "120,5" if decimal_comma else "120.5"
    if len(cell) > _LONGEST_NUMBER or not _NUMBER.fullmatch(cell):
        raise InputError(
            "must be a number, without unit and without marks between thousands",
            field=title,
            value=cell,
            example=example,
        )
    if "," in cell and not decimal_comma:
        raise InputError(
            "must have a decimal point where commas part the cells",
            field=title,
            value=cell,
            example="120.5",
        )
    return float(cell.replace(",", "."))


def _whole(given: dict[str, str], titles: dict[str, str], column: str) -> int:
    cell = given.get(column, "1")
    number = _number(cell, titles.get(column, column), True)
    if not 1.0 <= number <= MOST_UNITS or number != int(number):
        raise InputError(
            f"must be a whole number from 1 to {MOST_UNITS}",
            field=titles[column],
            value=cell,
            example="4",
        )
    return int(number)


def _text(given: dict[str, str], titles: dict[str, str], column: str) -> str:
    cell = given.get(column, "")
    if len(cell) > LONGEST_LABEL or not cell.isprintable():
        raise InputError(
            f"must be one line of {LONGEST_LABEL} characters at most",
            field=titles[column],
            value=cell,
        )
    return cell


@lru_cache(maxsize=4096)
def _folded(word: str) -> str:
    """Return a name without accents and case, its words joined by underscores."""
    plain = unicodedata.normalize("NFKD", word[:200])
    plain = "".join(c for c in plain if not unicodedata.combining(c)).casefold()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")
