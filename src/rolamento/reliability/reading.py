"""Life tests from CSV files, as people write them.

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

Commas, semicolons or tabs part the cells; with the latter two a decimal comma is understood. Lines
that begin with # are comments; ``# unit: Mrev``, ``# title:`` and ``# source:`` are read. Columns
named bearing, id, note, comment, procedure and their like are passed over.
"""

from __future__ import annotations

import csv
import os
import stat
import sys
from typing import Final

from rolamento.errors import FileError, InputError
from rolamento.reliability._columns import MOST_ROWS
from rolamento.reliability.csv_cells import Row, header_of, row_of
from rolamento.reliability.life_test import LifeTest

__all__ = ["parse_life_test", "read_life_test"]

_LARGEST_FILE: Final = 5_000_000
_LONGEST_LINE: Final = 5000
_STANDARD_INPUT: Final = "standard input"
_EXAMPLE: Final = "time,status"
_COMMENTS: Final = ("unit", "title", "source")


def read_life_test(
    path: str | os.PathLike[str], *, group: str | None = None, unit: str | None = None
) -> LifeTest:
    """Read a life test from a CSV file.

    Parameters
    ----------
    path
        Of the file, of 5 MB and 100 000 rows at most; ``"-"`` for standard input.
    group
        Name of the column that holds the groups, in place of the usual ones.
    unit
        Label of the times, in place of what the file says; "h" where it says nothing.

    Raises
    ------
    FileError, InputError
        With line, column and an example, if the file cannot be read or is no life test.
    """
    source = os.fspath(path)
    if source == "-":
        return parse_life_test(_standard_input(), _STANDARD_INPUT, group=group, unit=unit)
    return parse_life_test(_decoded(_content(source), source), source, group=group, unit=unit)


def parse_life_test(
    text: str, source: str = "", *, group: str | None = None, unit: str | None = None
) -> LifeTest:
    """Read a life test from the text of a CSV file.

    Parameters
    ----------
    text
        As the module tells.
    source
        What to call the text in messages.
    group, unit
        As of `read_life_test`.

    Raises
    ------
    FileError, InputError
        If it is no life test.
    """
    said, lines = _split(text, source)
    if not lines:
        raise FileError("holds no table", source=source, example=_EXAMPLE)
    line, first = lines[0]
    separator = next((mark for mark in ";\t" if mark in first), ",")
    rows: list[Row] = []
    try:
        header = header_of(_cells(first, separator), group)
        for number, cells in lines[1:]:
            line = number
            rows.append(row_of(_cells(cells, separator), header, separator != ","))
            if len(rows) > MOST_ROWS:
                raise FileError(f"holds more than {MOST_ROWS} rows")
    except InputError as error:
        raise error.with_details(source=source, line=line) from None
    if not rows:
        raise FileError("has a header and no rows", source=source, example="120.5,failed")
    label = unit or said.get("unit") or header.unit or "h"
    try:
        return _test(rows, header.has_size, label, said, source)
    except InputError as error:
        raise error.with_details(source=source) from None


def _test(rows: list[Row], by_rig: bool, unit: str, said: dict[str, str], source: str) -> LifeTest:
    """Put the rows together; a row of a rig with a size becomes two."""
    if by_rig:
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
    )


def _split(text: str, source: str) -> tuple[dict[str, str], list[tuple[int, str]]]:
    """Part what the comments say from the numbered lines of the table."""
    said: dict[str, str] = {}
    lines: list[tuple[int, str]] = []
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1):
        if len(line) > _LONGEST_LINE:
            raise FileError(
                f"is longer than {_LONGEST_LINE} characters", source=source, line=number
            )
        if line.startswith("#"):
            name, colon, value = line.lstrip("# ").partition(":")
            name = name.strip().casefold()
            if colon and name in _COMMENTS and not lines:
                said.setdefault(name, value.strip())
        elif line.strip(" \t;,"):
            lines.append((number, line))
    return said, lines


def _cells(line: str, separator: str) -> list[str]:
    try:
        cells = next(csv.reader([line], delimiter=separator, strict=True))
    except csv.Error:
        raise FileError("is not a line of a CSV table; look for a lone quotation mark") from None
    return [cell.strip() for cell in cells]


def _content(source: str) -> bytes:
    try:
        kind = os.stat(source).st_mode
        if stat.S_ISDIR(kind):
            raise FileError("is a directory; give a CSV file", source=source)
        if not stat.S_ISREG(kind):
            raise FileError("is not a regular file; use - for standard input", source=source)
        with open(source, "rb") as file:
            return file.read(_LARGEST_FILE + 1)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileError(f"cannot be opened: {reason}", source=source) from None
    except (TypeError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError("is not a possible file name", source=source) from None


def _standard_input() -> str:
    if sys.stdin is None:
        raise FileError("is closed", source=_STANDARD_INPUT)
    return _decoded(sys.stdin.buffer.read(_LARGEST_FILE + 1), _STANDARD_INPUT)


def _decoded(content: bytes, source: str) -> str:
    """Return the text: UTF-8, or else what Windows writes in Western languages."""
    if len(content) > _LARGEST_FILE:
        raise FileError("is larger than 5 MB", source=source)
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise FileError("is UTF-16 text; save it as CSV in UTF-8", source=source)
    if b"\0" in content:
        raise FileError("is a binary file; save the table as CSV", source=source)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")
