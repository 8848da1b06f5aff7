"""What stands beside a machine file: tables of sections, stiffness matrices, cases of bearings.

A machine file names them (`sections = "shaft.csv"`); here they are put in the place of their names,
so that a machine that was read is written whole. They must lie in the folder of the machine file or
below it.
"""

from __future__ import annotations

import io
import math
import os
import re
import warnings
from collections.abc import Mapping
from typing import Any, Final, NoReturn

from rolamento.case.housing_nodes import MOST_ROWS, nodes_in_file, reduced_to_rings
from rolamento.case.quantity import finite_number
from rolamento.errors import ABSENT, FileError, InputError, guess
from rolamento.io.tables import decoded, read_columns, separator_said
from rolamento.io.text import (
    LineIndex,
    TextFormat,
    format_of_path,
    format_of_text,
    lines_of_keys,
    parse_mapping,
    read_bytes,
    read_text,
)
from rolamento.validate import one_of
from rolamento.words import counted, marked, said

__all__ = [
    "CASE_TABLES",
    "MOST_SECTIONS",
    "MOST_UNKNOWNS",
    "lines_of_machine",
    "with_files",
]

MOST_SECTIONS: Final = 200
MOST_UNKNOWNS: Final = 100
"""Rows of the stiffness matrix of one housing."""
CASE_TABLES: Final = (
    "bearing", "model", "lubricant", "surface", "temperature", "mounting", "film", "heat", "life",
)  # fmt: skip
"""Tables of a case that are a bearing's; its duty is the machine's."""
_LARGEST: Final = 5_000_000
_EXAMPLE: Final = "length [mm],diameter [mm],bore [mm]"
_COLUMNS: Final = {
    "length": "length l comprimento länge laenge longitud",
    "diameter": "diameter outer_diameter outside_diameter d diametro durchmesser",
    "bore": "bore inner_diameter bore_diameter furo bohrung",
    "end_diameter": "end_diameter diameter_end diametro_final enddurchmesser",
    "end_bore": "end_bore bore_end furo_final",
}
_NEEDED: Final = ("length", "diameter")
_PARTS: Final = re.compile(r"[;,\t ]+")


def with_files(mapping: Mapping[str, Any], folder: str | os.PathLike[str] | None) -> dict[str, Any]:
    """Return the tables of a machine file with the files that they name in their places.

    Parameters
    ----------
    mapping
        As it was read.
    folder
        That of the machine file; None of a text that is in no folder.

    Raises
    ------
    InputError
        If a file is not to be read, or holds something else.
    """
    result = dict(mapping)
    for name, key, reader in (
        ("shafts", "sections", _sections),
        ("housings", "matrix", _matrix),
        ("bearings", "case", _case_tables),
    ):
        tables = result.get(name)
        if isinstance(tables, list):
            result[name] = [
                {**table, key: reader(_beside(table[key], folder, f"{name}.{index}.{key}"))}
                if isinstance(table, Mapping) and isinstance(table.get(key), str)
                else table
                for index, table in enumerate(tables)
            ]
    if isinstance(housings := result.get("housings"), list):
        result["housings"] = [
            _between_rings(table, folder, f"housings.{index}")
            if isinstance(table, Mapping) and {"nodes", "others"} & table.keys()
            else table
            for index, table in enumerate(housings)
        ]
    return result


def _between_rings(
    table: Mapping[str, Any], folder: str | os.PathLike[str] | None, field: str
) -> dict[str, Any]:
    """Return the table of a housing with its matrix between the rings of its bearings, in SI."""
    kept = {name: value for name, value in table.items() if name not in ("nodes", "others")}
    nodes, others, matrix = (table.get(name) for name in ("nodes", "others", "matrix"))
    for missing, given, beside in (("nodes", nodes, "others"), ("matrix", matrix, "nodes")):
        if not isinstance(given, str | list):
            raise InputError(
                said("is missing; {beside} needs it", beside=beside),
                field=f"{field}.{missing}",
                example='matrix = "housing.mtx", nodes = "nodes.csv"',
            )
    if others is not None:
        one_of(others, f"{field}.others", ("free", "held"), 'others = "free"')
    rows: Any = nodes
    listed = None
    if isinstance(nodes, str):
        rows, listed = nodes_in_file(_beside(nodes, folder, f"{field}.nodes"))
    try:
        bearings, stiffness = reduced_to_rings(
            _numbers(matrix),
            rows,
            bearings=[str(one) for one in table.get("bearings") or ()],
            units=table.get("units"),
            others=others,
        )
    except InputError as error:
        _, of_nodes, place = error.field.partition("nodes.")
        row, _, column = place.partition(".")
        if of_nodes and listed is not None:
            raise listed.placed(error.with_details(field=column), int(row)) from None
        raise error.with_details(field=f"{field}.{error.field}") from None
    return {**kept, "bearings": list(bearings), "matrix": stiffness.tolist(), "units": "N/m"}


def _numbers(matrix: Any) -> list[list[float]]:
    """The rows of a matrix that stands in the file itself, or was read."""
    if any(not isinstance(row, list | tuple) or len(row) != len(matrix) for row in matrix):
        raise InputError(
            said("must be a matrix of {size} rows and columns", size=len(matrix)), field="matrix"
        )
    return [[finite_number(one) for one in row] for row in matrix]


def _beside(name: str, folder: str | os.PathLike[str] | None, field: str) -> str:
    """Return the path of a file that a machine file names.

    Raises
    ------
    InputError
        If it is not in the folder of the machine file, or that has none.
    """

    def refused(rule: str) -> NoReturn:
        raise InputError(rule, field=field, value=name, example=f'{field.rpartition(".")[2]} = '
                         '"shaft.csv"')  # fmt: skip

    if folder is None:
        refused(said("names a file, which only a machine file in a folder can"))
    parts = re.split(r"[\\/]", name)
    if "\0" in name or os.path.isabs(name) or ".." in parts or ":" in name or name == "-":
        refused(said("must be a file in the folder of the machine file"))
    top = os.path.realpath(os.fspath(folder) or ".")
    path = os.path.realpath(os.path.join(top, *parts))
    if os.path.commonpath([top, path]) != top:
        refused(said("must be a file in the folder of the machine file"))
    return path


# --- sections -------------------------------------------------------------------------------------


def _sections(path: str) -> list[dict[str, str]]:
    """Read a table of sections, units in its header.

    Raises
    ------
    FileError
        If it is no such table.
    """
    table, places = read_columns(path, _COLUMNS, _NEEDED, most_rows=MOST_SECTIONS, example=_EXAMPLE)
    for place, unit in places.values():
        if not unit:
            rule = said("needs a unit in its heading")
            raise table.placed(FileError(rule, field=table.header[place], example=_EXAMPLE))
    numerals = table.numerals([place for place, _ in places.values()], argument=False)
    found = []
    for index, row in enumerate(table.rows):
        section = {}
        for column, (place, unit) in places.items():
            cell = row[place]
            if not cell and column not in _NEEDED:
                continue
            number = numerals.plain(cell)
            if number is None:
                error = FileError(said("must be a number"), field=column, value=cell)
                raise table.placed(error, index)
            section[column] = f"{number} {unit}"
        found.append(section)
    return found


# --- matrices -------------------------------------------------------------------------------------


def _matrix(path: str) -> list[list[float]]:
    """Read a square matrix from a table of numbers or a Matrix Market file.

    Raises
    ------
    FileError
        If it holds none, or one that is too large.
    """
    content = read_bytes(path, _LARGEST, marked("a CSV table"))
    if len(content) > _LARGEST:
        rule = said("is larger than {most} MB", most=_LARGEST // 1_000_000)
        raise FileError(rule, source=path)
    if content.lstrip()[:14].lower() == b"%%matrixmarket":
        return _market(content, path)
    rows: list[list[float]] = []
    mark = ""
    for number, line in enumerate(decoded(content, path).splitlines(), start=1):
        line = line.strip()
        mark = mark or separator_said(line)
        if not line or line.startswith(("#", "%")) or separator_said(line):
            continue
        rows.append(_row(line, mark, path, number))
        if len(rows) > MOST_ROWS:
            _too_large(path)
        if len(rows[-1]) != len(rows[0]):
            rule = counted(
                "has {n} number where the first row has {columns}",
                "has {n} numbers where the first row has {columns}",
                len(rows[-1]),
                columns=len(rows[0]),
            )
            raise FileError(rule, source=path, line=number)
    if not rows or len(rows) != len(rows[0]):
        _not_square(path, len(rows), len(rows[0]) if rows else 0)
    return rows


def _row(line: str, mark: str, path: str, number: int) -> list[float]:
    """The numbers of a line; where semicolons or tabs part them a comma is a decimal one."""
    parting = mark or next((one for one in (";", "\t") if one in line), "")
    cells = line.strip(";\t, ")
    parts = cells.split(parting) if parting else _PARTS.split(cells)
    if len(parts) > MOST_ROWS:
        _too_large(path)
    found = []
    for part in parts:
        try:
            value = float(part.strip().replace(",", ".") if parting != "," else part)
        except ValueError:
            raise FileError(
                said("must be a number"), value=part.strip(), source=path, line=number
            ) from None
        if not math.isfinite(value):
            raise FileError(
                said("must be a finite number"), value=part.strip(), source=path, line=number
            )
        found.append(value)
    return found


def _market(content: bytes, path: str) -> list[list[float]]:
    import numpy as np
    from scipy.io import mminfo, mmread

    try:
        rows, columns, _, _, kind, _ = mminfo(io.BytesIO(content))
        if max(rows, columns) > MOST_ROWS:
            _too_large(path)
        if rows != columns or not rows:
            _not_square(path, rows, columns)
        if kind not in ("real", "integer", "double", "unsigned-integer"):
            raise FileError(said("must be a matrix of real numbers"), source=path)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            read = mmread(io.BytesIO(content))
    except FileError:
        raise
    except (ValueError, OverflowError, TypeError, MemoryError, IndexError, KeyError):
        raise FileError(said("is not a valid Matrix Market file"), source=path) from None
    matrix = np.asarray(read.toarray() if hasattr(read, "toarray") else read, dtype=float)
    if not np.isfinite(matrix).all():
        raise FileError(said("must contain finite numbers only"), source=path)
    found: list[list[float]] = matrix.tolist()
    return found


def _too_large(path: str) -> NoReturn:
    rule = said("has more than {most} rows or columns", most=MOST_ROWS)
    raise FileError(rule, source=path)


def _not_square(path: str, rows: int, columns: int) -> NoReturn:
    rule = said(
        "must be a square matrix, and has {rows} rows of {columns}", rows=rows, columns=columns
    )
    raise FileError(rule, source=path)


# --- cases of bearings ----------------------------------------------------------------------------


def _case_tables(path: str) -> dict[str, Any]:
    """Read the tables of a case file that are the bearing's; duty and title are the machine's."""
    text, source = read_text(path)
    mapping = parse_mapping(text, format_of_path(path) or format_of_text(text), source)
    if "bearing" not in mapping:
        rule = said("is missing")
        raise InputError(rule, field="bearing", source=source, example='designation = "6308"')
    known = (*CASE_TABLES, "title", "duty", "report")
    for name in mapping:
        if name not in known:
            rule = said("is an unknown key; {guess}", guess=guess(name, known))
            raise InputError(rule, field=name, value=ABSENT, source=source)
    return {name: mapping[name] for name in CASE_TABLES if name in mapping}


# --- lines ----------------------------------------------------------------------------------------

_HEADING: Final = re.compile(r"[ \t]*(\[\[?)[ \t]*([A-Za-z0-9_.\- ]+?)[ \t]*\]")
_KEY: Final = re.compile(r"[ \t]*([A-Za-z0-9_.\-]+)[ \t]*=")


def lines_of_machine(text: str, text_format: TextFormat) -> LineIndex:
    """Return the line of every key, those of lists of tables by their place: shafts.0.name."""
    if text_format == "json":
        return lines_of_keys(text, text_format)
    index: LineIndex = {}
    counts: dict[tuple[str, ...], int] = {}
    table: tuple[str, ...] = ()
    for number, line in enumerate(text.split("\n"), start=1):
        if heading := _HEADING.match(line):
            table = ()
            parts = [part.strip() for part in heading[2].split(".")]
            for depth, part in enumerate(parts, start=1):
                table = (*table, part)
                if heading[1] == "[[" and depth == len(parts):
                    counts[table] = counts.get(table, -1) + 1
                    index.setdefault(table, number)
                if table in counts:
                    table = (*table, str(counts[table]))
            index.setdefault(table, number)
        elif key := _KEY.match(line):
            index.setdefault((*table, *key[1].split(".")), number)
    return index
