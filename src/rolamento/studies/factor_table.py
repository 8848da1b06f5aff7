"""a_NSK as a user reads it off the maker's chart: from a file to a `FactorTable`."""

from __future__ import annotations

import os
from math import isfinite
from typing import Final

import numpy as np

from rolamento._tables import read_table
from rolamento.errors import FileError, InputError
from rolamento.life.l_able import FactorTable

__all__ = ["read_factor_table"]

_MOST_ROWS: Final = 1000
_NAMES: Final = {
    "viscosity_ratio": "κ of the rows",
    "load_parameter": "load parameters of the header",
    "factor": "a_NSK",
}
_EXAMPLE: Final = "kappa,0.01,0.05,0.2"


def read_factor_table(
    path: str | os.PathLike[str], *, decimal_mark: str | None = None
) -> FactorTable:
    """Read a table of a_NSK.

    Parameters
    ----------
    path
        Comma-separated values. The header has any word, then the load parameters (P - P_u)/(C a_c)
        of the columns, rising; every row below has κ, rising from row to row, and a_NSK.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the table tells whether 1.500 is 1.5.

    Raises
    ------
    FileError
        If it is not such a file; with line and column.
    """
    table = read_table(path, most_rows=_MOST_ROWS, example=_EXAMPLE).plain(decimal_mark)
    loads = [_number(text, table.source, table.header_line, text) for text in table.header[1:]]
    rows = [
        [
            _number(text, table.source, line, "κ" if column == 0 else table.header[column])
            for column, text in enumerate(cells)
        ]
        for cells, line in zip(table.rows, table.lines, strict=True)
    ]
    if len(loads) < 2 or len(rows) < 2:
        raise FileError(
            "needs at least two rows (κ) of two columns (load parameters)",
            source=table.source,
            example=_EXAMPLE,
        )
    array = np.array(rows)
    try:
        return FactorTable(array[:, 0], np.array(loads), array[:, 1:])
    except InputError as error:
        field = _NAMES.get(error.field, error.field)
        raise error.with_details(source=table.source, field=field) from None


def _number(text: str, source: str, line: int, column: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        raise FileError(
            "must be a number", field=column, value=text, source=source, line=line, example="0.5"
        )
    return value
