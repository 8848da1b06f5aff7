"""A machine as tables, one for each kind of part: sheets of a workbook, or data frames.

A table has a line for each part, its columns called by the keys of a machine file, such as
``bearing.preload.spring``, with a unit in brackets where the numbers below have none. ``machine``
has a line for each key of the machine itself, ``sections`` one for each section of a shaft, which
it names. Texts are as a machine file has them: ``"20 mm"``; what is a list or a table there is
JSON. A matrix stands in a table of its own, which the cell names. Tables whose names begin with #
say nothing.
"""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal, InvalidOperation
from typing import Any, Final

from rolamento.case.case import Case
from rolamento.errors import ABSENT, FileError, InputError, guess
from rolamento.io.sheets import Cell, cells_of_workbook, is_workbook
from rolamento.records import frozen
from rolamento.words import said

__all__ = ["PARTS", "Sheet", "holds_sheets", "read_sheets", "sheets_of_tables", "tables_of_sheets"]

PARTS: Final = (
    "shafts", "bearings", "housings", "springs", "loads", "gears", "belts", "masses", "spectrum",
)  # fmt: skip
"""Lists of parts of a machine, each a table."""
_TOP: Final = "machine"
_SECTIONS: Final = "sections"
_SHAFT: Final = "shaft"
_IGNORED: Final = "#"
_SHEET: Final = "sheet: "
"""Before the name of a table in a cell."""
_MOST_SHEETS: Final = 150
_MOST_ROWS: Final = 12_000
_LARGEST: Final = 5_000_000
_DEEPEST: Final = 8
_HEAD: Final = re.compile(r"\s*([^\[\]]*?)\s*(?:\[([^\[\]]*)\])?\s*")
_NUMBER: Final = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_LONG_NUMBER: Final = re.compile(r"[+-]?(?=(?:\.?\d){17})\d*\.\d+(?:[eE][+-]?\d+)?")
_QUANTITY: Final = re.compile(r"([+-]?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?) (\S.*)")
_NAMES: Final = frozenset({
    "title", "name", "shaft", "of", "designation", "material", "lubricant", "housing",
    "outer_shaft", "to_shaft", "mate", "maker", "case",
})  # fmt: skip
"""Keys that are texts: a number there is the name of something."""
_WITH_AN_OFFSET: Final = ("degC", "degF", "°C", "°F")
"""Units in which nothing is not zero."""


@frozen
class Sheet:
    """A table: names of columns, with units in brackets, and rows of cells; None is empty."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


# --- to tables ------------------------------------------------------------------------------------


def sheets_of_tables(mapping: Mapping[str, Any]) -> dict[str, Sheet]:
    """Return the tables of a machine, which `tables_of_sheets` reads back.

    Parameters
    ----------
    mapping
        As of `rolamento.Machine.to_mapping`.
    """
    found: dict[str, Sheet] = {}
    matrices: dict[str, Sheet] = {}
    top: list[tuple[Cell, ...]] = []
    sections: list[dict[str, Any]] = []
    for kind, value in mapping.items():
        if kind not in PARTS:
            top += [(key, _cell(one)) for key, one in _flat(kind, value, matrices)]
    found[_TOP] = Sheet(("key", "value"), tuple(top))
    for kind in PARTS:
        parts = []
        for part in mapping.get(kind, ()):
            own = dict(part)
            if kind == "shafts":
                sections += [{_SHAFT: own["name"], **one} for one in own.pop(_SECTIONS)]
            parts.append({
                key: one for name, value in own.items() for key, one in _flat(name, value, matrices)
            })  # fmt: skip
        if parts:
            found[kind] = _sheet(parts)
        if kind == "shafts":
            found[_SECTIONS] = _sheet(sections)
    return {**found, **matrices}


def _flat(key: str, value: Any, matrices: dict[str, Sheet]) -> Iterator[tuple[str, Any]]:
    """The dotted keys of a value; matrices go to tables of their own."""
    if isinstance(value, Mapping):
        if not value:
            yield key, "{}"
        for name, inner in value.items():
            yield from _flat(f"{key}.{name}", inner, matrices)
    elif isinstance(value, list | tuple):
        if value and all(isinstance(row, list | tuple) for row in value):
            name = f"matrix {len(matrices) + 1}"
            size = range(1, len(value[0]) + 1)
            matrices[name] = Sheet(tuple(map(str, size)), tuple(tuple(row) for row in value))
            yield key, f"{_SHEET}{name}"
        else:
            yield key, json.dumps(value, ensure_ascii=False)
    elif value is not None:
        yield key, value


def _sheet(parts: Sequence[Mapping[str, Any]]) -> Sheet:
    """A line for each part; numbers with one unit where a column has one."""
    keys = list(dict.fromkeys(key for part in parts for key in part))
    columns, cells = [], []
    for key in keys:
        values = [part.get(key) for part in parts]
        unit = "" if _is_text(key) else _unit_of(values)
        columns.append(f"{key} [{unit}]" if unit else key)
        cells.append([_cell(value, unit) for value in values])
    return Sheet(tuple(columns), tuple(zip(*cells, strict=True)))


def _parted(value: Any) -> tuple[float, str] | None:
    """Number and unit of a text, if a number holds all its digits."""
    match = _QUANTITY.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        return None
    number = float(match[1])
    try:
        exact = Decimal(match[1]) == Decimal(repr(number))
    except InvalidOperation:
        return None
    return (number, match[2]) if exact and math.isfinite(number) else None


def _unit_of(values: Sequence[Any]) -> str:
    """The unit of most of the numbers of a column that are not zero; empty without one."""
    parted = [part for part in map(_parted, values) if part is not None]
    units = [unit for number, unit in parted if number] or [unit for _, unit in parted]
    return max(units, key=units.count) if units else ""


def _cell(value: Any, unit: str = "") -> Cell:
    if unit and (part := _parted(value)) is not None:
        nothing = part[0] == 0.0 and not {part[1], unit} & set(_WITH_AN_OFFSET)
        if part[1] == unit or nothing:
            return part[0]
    if value is None or isinstance(value, str | bool | int | float):
        return value
    return str(value)


# --- from tables ----------------------------------------------------------------------------------


def holds_sheets(path: str | os.PathLike[str]) -> bool:
    """Return whether a file is a workbook, or is called one."""
    return os.fspath(path).lower().endswith(".xlsx") or is_workbook(path)


def read_sheets(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the tables of a machine file that a workbook holds.

    Raises
    ------
    FileError
        If it is damaged, too large, or holds no machine.
    """
    found = cells_of_workbook(path, _MOST_SHEETS, _MOST_ROWS, _LARGEST)
    sheets = {name: _as_sheet(rows) for name, rows in found.items() if name[:1] != _IGNORED}
    try:
        return tables_of_sheets(sheets)
    except InputError as error:
        raise error.with_details(source=os.fspath(path)) from None


def _as_sheet(rows: Sequence[Sequence[Cell]]) -> Sheet:
    filled = [tuple(row) for row in rows]
    width = max(map(len, filled), default=0)
    head, *body = (row + (None,) * (width - len(row)) for row in filled)
    return Sheet(tuple("" if one is None else _text(one) for one in head), tuple(body))


def tables_of_sheets(sheets: Mapping[str, Sheet]) -> dict[str, Any]:
    """Return the tables of a machine file, which are not validated.

    Parameters
    ----------
    sheets
        By their names.

    Raises
    ------
    InputError
        If a table or a column has a name that is none, or a cell does not fit.
    """
    matrices = {name: sheet for name, sheet in sheets.items() if name.startswith("matrix")}
    known = (_TOP, _SECTIONS, *PARTS)
    mapping: dict[str, Any] = {}
    for name, sheet in sheets.items():
        if name in matrices:
            continue
        if name not in known:
            raise InputError(
                said("is no table of a machine; {guess}, or begin its name with # if it is none",
                     guess=guess(name, known)), field=name, value=ABSENT,
            )  # fmt: skip
        lines = list(_lines(name, sheet, matrices))
        if name == _TOP:
            mapping.update(_nested((str(key), value) for key, value in _pairs(lines)))
        elif name != _SECTIONS:
            mapping[name] = [_nested(line.items()) for line in lines]
    for index, shaft in enumerate(mapping.get("shafts", ())):
        if _SECTIONS not in shaft:
            shaft[_SECTIONS] = []
            if _SHAFT in shaft:
                raise InputError(said("is an unknown key"), field=f"shafts.{index}.{_SHAFT}")
    if _SECTIONS in sheets:
        _put_sections(mapping, list(_lines(_SECTIONS, sheets[_SECTIONS], matrices)))
    return mapping


def _put_sections(mapping: dict[str, Any], lines: Sequence[dict[str, Any]]) -> None:
    shafts: dict[str, dict[str, Any]] = {}
    for index, shaft in enumerate(mapping.get("shafts", ())):
        name = str(shaft.get("name"))
        if name in shafts:
            raise InputError(said("is given twice"), field=f"shafts.{index}.name", value=name)
        shafts[name] = shaft
    only = next(iter(shafts), None) if len(shafts) == 1 else None
    for index, line in enumerate(lines):
        name = str(line.pop(_SHAFT, only))
        if name not in shafts:
            raise InputError(
                said("is an unknown name; {guess}", guess=guess(name, shafts)),
                field=f"{_SECTIONS}.{index}.{_SHAFT}",
                value=name,
            )
        shafts[name][_SECTIONS].append(_nested(line.items()))


def _pairs(lines: Sequence[Mapping[str, Any]]) -> Iterator[tuple[Any, Any]]:
    seen = set()
    for line in lines:
        key, value = str(line.get("key", "")), line.get("value")
        if key in seen:
            raise InputError(said("is given twice"), field=f"{_TOP}.{key}")
        seen.add(key)
        if key and value is not None:
            yield key, _text(value) if _is_text(key) and isinstance(value, int | float) else value


def _lines(name: str, sheet: Sheet, matrices: Mapping[str, Sheet]) -> Iterator[dict[str, Any]]:
    """The parts of a table, as a machine file has their values; lines without any are none."""
    heads = [_HEAD.fullmatch(column) for column in sheet.columns]
    keys = ["" if head is None else head[1] for head in heads]
    for place, (key, column) in enumerate(zip(keys, sheet.columns, strict=True)):
        if key and key in keys[:place]:
            raise InputError(said("is given twice"), field=f"{name}.{key}")
        if not key and any(row[place] not in (None, "") for row in sheet.rows):
            raise InputError(
                said("is a column without a name that holds something"), field=name,
                value=column or ABSENT,
            )  # fmt: skip
    units = ["" if head is None else (head[2] or "").strip() for head in heads]
    for row in sheet.rows:
        table = f"{name}.{row[0]}" if name == _TOP else name
        line = {
            key: _value(f"{table}.{key}", key, cell, unit, matrices)
            for key, unit, cell in zip(keys, units, row, strict=True)
            if key and cell is not None and cell != ""
        }
        if line:
            yield line


def _value(field: str, key: str, cell: Cell, unit: str, matrices: Mapping[str, Sheet]) -> Any:
    """What a machine file has in the place of a cell."""
    if isinstance(cell, str):
        text = cell.strip()
        if text.startswith(_SHEET):
            return _matrix(field, text.removeprefix(_SHEET).strip(), matrices)
        if text[:1] in ("[", "{"):
            return _json(field, text)
        if _NUMBER.fullmatch(text) and unit and not _is_text(key):
            return f"{text} {unit}"
        # a sheet holds 16 digits of a number; what has more is written as text
        return float(text) if _LONG_NUMBER.fullmatch(text) else text
    if _is_text(key) and not isinstance(cell, bool):
        return _text(cell)
    if unit and cell is not None and not isinstance(cell, bool):
        return f"{_text(cell)} {unit}"
    # a spreadsheet has no whole numbers: 23 teeth are 23.0
    whole = isinstance(cell, float) and cell.is_integer() and abs(cell) < 2**53
    return int(cell) if whole and cell is not None else cell


def _is_text(key: str) -> bool:
    """Whether what stands under a key is a text, though a sheet may hold it as a number."""
    if key.rpartition(".")[2] in _NAMES:
        return True
    field = Case.fields().get(key)
    return field is not None and field.kind == "text"


def _text(cell: Cell) -> str:
    if isinstance(cell, float) and cell.is_integer() and abs(cell) < 1e15:
        return str(int(cell))
    return cell if isinstance(cell, str) else repr(cell)


def _matrix(field: str, name: str, matrices: Mapping[str, Sheet]) -> list[list[Any]]:
    sheet = matrices.get(name)
    if sheet is None:
        raise InputError(
            said("is an unknown name; {guess}", guess=guess(name, matrices)), field=field,
            value=name,
        )  # fmt: skip
    return [[_entry(cell) for cell in row] for row in sheet.rows]


def _entry(cell: Cell) -> Any:
    number = isinstance(cell, str) and _NUMBER.fullmatch(cell.strip())
    return float(str(cell)) if number else cell


def _json(field: str, text: str) -> Any:
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise InputError(said("is not valid JSON"), field=field, value=text[:80]) from None
    level = [found]
    for _ in range(_DEEPEST):
        level = [
            inner
            for one in level
            if isinstance(one, list | dict)
            for inner in (one.values() if isinstance(one, dict) else one)
        ]
    if level:
        raise InputError(said("is nested too deeply"), field=field)
    return found


def _nested(pairs: Any) -> dict[str, Any]:
    """Tables of dotted keys."""
    found: dict[str, Any] = {}
    for key, value in pairs:
        *names, last = str(key).split(".")
        if len(names) > _DEEPEST:
            raise FileError(said("is nested too deeply"), field=str(key)[:100])
        table = found
        for name in names:
            inner = table.setdefault(name, {})
            if not isinstance(inner, dict):
                raise InputError(said("must be a table"), field=str(key), value=inner)
            table = inner
        if last in table:
            raise InputError(said("is given twice"), field=str(key))
        table[last] = value
    return found
