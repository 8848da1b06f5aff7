"""Small tables that a user writes: comma-separated values with a header, bounded in every way."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from io import StringIO
from typing import Final

from rolamento._reading import read_text
from rolamento.errors import FileError, InputError

__all__ = ["CsvTable", "read_csv_table"]

_LONGEST_CELL: Final = 200
_MOST_COLUMNS: Final = 1000
_DECIMAL_COMMA: Final = re.compile(r"^([+-]?\d+),(\d+)")


@dataclass(frozen=True, slots=True)
class CsvTable:
    """Cells as text.

    Attributes
    ----------
    source
        what to call the file in messages
    header
        names of the columns
    header_line, lines
        of the header and of the rows in the file, counted from 1
    rows
        cells, as many in each row as there are columns
    """

    source: str
    header: tuple[str, ...]
    header_line: int
    rows: tuple[tuple[str, ...], ...]
    lines: tuple[int, ...]

    def placed(self, error: InputError, row: int) -> InputError:
        """Return an error with the place of its row."""
        return error.with_details(source=self.source, line=self.lines[row])


def read_csv_table(path: str | os.PathLike[str], most_rows: int, example: str) -> CsvTable:
    """Read a table from a file, or from standard input for ``"-"``.

    Commas separate the cells, or semicolons as spreadsheets write them where the comma is the
    decimal mark. Empty lines and lines that begin with # count nothing.

    Parameters
    ----------
    path
        UTF-8 text of at most 1 MB.
    most_rows
        Below the header.
    example
        Of a header, for messages.

    Raises
    ------
    FileError
        If it cannot be read, is no such table, or is too large.
    """
    text, source = read_text(path)
    separator = ";" if ";" in _first_line(text) else ","
    reader = csv.reader(StringIO(text), delimiter=separator, strict=True)
    found: list[tuple[int, tuple[str, ...]]] = []
    try:
        for cells in reader:
            if not any(map(str.strip, cells)) or cells[0].lstrip().startswith("#"):
                continue
            if len(found) > most_rows:
                raise FileError(f"has more than {most_rows} rows", source=source)
            found.append((reader.line_num, _cleaned(cells, separator)))
            _check_row(found, source)
    except csv.Error as error:
        rule = f"is not a table of comma-separated values: {error}"
        raise FileError(rule, source=source, line=reader.line_num) from None
    if len(found) < 2:
        raise FileError("needs a header and a row below it", source=source, example=example)
    (header_line, header), *rows = found
    return CsvTable(
        source, header, header_line, tuple(cells for _, cells in rows), tuple(n for n, _ in rows)
    )


def _first_line(text: str) -> str:
    lines = (line.strip() for line in text.splitlines())
    return next((line for line in lines if line and not line.startswith("#")), "")


def _cleaned(cells: Sequence[str], separator: str) -> tuple[str, ...]:
    stripped = (cell.strip() for cell in cells)
    if separator == ",":
        return tuple(stripped)
    return tuple(_DECIMAL_COMMA.sub(r"\1.\2", cell) for cell in stripped)


def _check_row(found: Sequence[tuple[int, tuple[str, ...]]], source: str) -> None:
    """Refuse a row that is too large or not as long as the header, and a header that repeats."""
    line, cells = found[-1]
    header = found[0][1]
    if len(cells) > _MOST_COLUMNS or max(map(len, cells)) > _LONGEST_CELL:
        raise FileError(
            f"must be at most {_MOST_COLUMNS} cells of {_LONGEST_CELL} characters a line",
            source=source,
            line=line,
        )
    if len(cells) != len(header):
        rule = f"has {len(cells)} cells, and the header has {len(header)}"
        raise FileError(rule, source=source, line=line)
    repeated = [name for name in header if name and header.count(name) > 1]
    if len(found) == 1 and repeated:
        raise FileError("names a column twice", field=repeated[0], source=source, line=line)
