"""The data of figures and tables as comma-separated values, the same in every language.

As the table of balls: RFC 4180, units in the header, a decimal point, an empty field for a number
that does not exist.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from io import StringIO
from math import isfinite

from rolamento_reproductions.errata import Errata, power_above
from rolamento_reproductions.printed import Cell
from rolamento_reproductions.record import Figure, Table, TableColumn
from rolamento_reproductions.text import Text

__all__ = ["errata_csv", "figure_csv", "table_csv"]


def figure_csv(figure: Figure) -> str:
    """Return a figure's columns, one row a line."""
    header = [column.header for column in figure.columns]
    columns = [[_written(value) for value in column.values] for column in figure.columns]
    return _text(header, zip(*columns, strict=True))


def table_csv(table: Table) -> str:
    """Return a table; a column of printed numbers becomes three: printed, computed, agreement."""
    header: list[str] = []
    columns: list[list[str]] = []
    for column in table.columns:
        names, values = _spread(column)
        header += names
        columns += values
    return _text(header, zip(*columns, strict=True))


def errata_csv(errata: Errata) -> str:
    """Return misprints and sound equations with their residuals.

    What is left by rounding alone is given as the power of ten above it, the same everywhere.
    """
    names = ("median", "greatest", "corrected_below")
    header = ["place", "printed", "corrected", *(f"residual_{name}" for name in names)]
    rows = [
        [
            one.place.en,
            one.printed.en,
            one.corrected.en,
            f"{one.printed_residual.median:.1e}",
            f"{one.printed_residual.greatest:.1e}",
            f"{power_above(one.corrected_residual.greatest):.0e}",
        ]
        for one in errata.misprints
    ]
    rows += [
        [
            f"Equation ({one.number})",
            one.form.en,
            "",
            "",
            "",
            f"{power_above(one.residual.greatest):.0e}",
        ]
        for one in errata.sound
    ]
    return _text(header, rows)


def _spread(column: TableColumn) -> tuple[list[str], list[list[str]]]:
    """Return the names and the values of what a table's column becomes."""
    cells = column.cells
    if any(isinstance(cell, Cell) for cell in cells):
        numbers = [cell for cell in cells if isinstance(cell, Cell)]
        names = [f"{column.name}_{what}" for what in ("printed", "computed", "agreement")]
        return names, [
            [cell.printed for cell in numbers],
            [_written(cell.computed) for cell in numbers],
            [cell.agreement for cell in numbers],
        ]
    return [column.name], [[c.en if isinstance(c, Text) else str(c) for c in cells]]


def _text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(header)
    writer.writerows(rows)
    return text.getvalue()


def _written(value: object) -> str:
    """Write eight significant digits: finer than any picture, and the same on every machine."""
    if isinstance(value, str):
        return value
    number = float(value)  # type: ignore[arg-type]
    return f"{number + 0.0:.8g}" if isfinite(number) else ""
