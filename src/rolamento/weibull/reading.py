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

Tables are read as `rolamento._tables` tells: any separator, either decimal mark. Of the comments
``# unit: Mrev``, ``# title:`` and ``# source:`` are read. Columns named bearing, id, note, comment,
procedure and their like are passed over, and all others that are not known, which are told.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Final

from rolamento._tables import Table, parse_table, table_text
from rolamento.errors import InputError
from rolamento.weibull._columns import MOST_ROWS
from rolamento.weibull.csv_cells import Header, Row, check_status, header_of, row_of
from rolamento.weibull.life_test import LifeTest

__all__ = ["parse_life_test", "read_life_test"]

_EXAMPLE: Final = "time,status"


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
        ``"point"`` or ``"comma"``, where nothing in the file tells whether 12.500 is 12.5.

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
        As the module tells.
    source
        What to call the text in messages.
    group, unit, time, status, decimal_mark
        As of `read_life_test`.

    Raises
    ------
    FileError, InputError
        If it is no life test.
    """
    table = parse_table(text, source, most_rows=MOST_ROWS, example=_EXAMPLE)
    wanted = {"group": group, "time": time, "status": status}
    try:
        header = header_of(table.header, {name: t for name, t in wanted.items() if t is not None})
        check_status(header, table.rows)
    except InputError as error:
        raise table.placed(error) from None
    rows = _rows(table, header, decimal_mark)
    label = unit or table.said.get("unit") or header.unit or "h"
    try:
        return _test(rows, header, label, table.said, source)
    except InputError as error:
        raise error.with_details(source=source) from None


def _rows(table: Table, header: Header, decimal_mark: str | None) -> list[Row]:
    numbers = [header.places[name] for name in ("time", "lower") if name in header.places]
    numerals = table.numerals(numbers, decimal_mark)
    rows: list[Row] = []
    for number, cells in enumerate(table.rows):
        try:
            rows.append(row_of(cells, header, numerals))
        except InputError as error:
            raise table.placed(error, number) from None
    return rows


def _test(
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
