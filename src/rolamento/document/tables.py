"""Tables to files: CSV (RFC 4180) for one of them, a workbook (XLSX) with a sheet for each.

Columns are called by their keys, in every language, numbers are not rounded, and what has no value
is empty. Units are those that the page shows (rpm, µm, MPa), or SI.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from dataclasses import replace
from math import isfinite
from typing import TYPE_CHECKING, Final

from rolamento.document.model import CellContent, Column, Document, Number, Table
from rolamento.errors import InputError, nearest, printable
from rolamento.io.sheets import FORMULA, NOT_IN_SHEET, book_bytes, put_text
from rolamento.records import frozen
from rolamento.words import UNITS, in_unit, manner, said, unit_of

if TYPE_CHECKING:
    from openpyxl.worksheet.worksheet import Worksheet

__all__ = ["SI_UNITS", "table_of", "to_csv", "to_xlsx"]

SI_UNITS: Final = {
    "mm": "m", "µm": "m", "nm": "m", "mm²": "m²", "mm³": "m³", "mrad": "rad", "µrad": "rad",
    "°": "rad", "rpm": "rad/s", "kHz": "Hz", "kN": "N", "N·mm": "N·m", "µN·m": "N·m",
    "N/mm": "N/m", "N/µm": "N/m", "N/mrad": "N/rad", "N·m/mm": "N·m/m", "N·m/mrad": "N·m/rad",
    "MPa": "Pa", "GPa": "Pa", "1/GPa": "1/Pa", "mW": "W", "µW": "W", "°C": "K", "10⁻⁶/K": "1/K",
    "mm²/s": "m²/s", "mPa·s": "Pa·s", "mm/s": "m/s", "µm/s": "m/s", "10⁶ mm·rpm": "m·rad/s",
    "l/min": "m³/s",
    "pF": "F", "nJ": "J", "A/mm²": "A/m²", "V/µm": "V/m",
    "ms": "s", "min": "s", "h": "s", "10⁶ rev": "rev", "10⁶ osc.": "osc.", "%": "", "–": "",
}  # fmt: skip
"""Units that a page shows, and those of SI; what does not stand here is of SI."""

_PLAIN_UNITS: Final = (
    ("10⁶ rev", "Mrev"), ("10⁶ osc.", "Mosc"), ("10⁶ mm·rpm", "1e6_mm_rpm"),
    ("10⁻⁶", "ppm"), ("%", "percent"), ("°C", "degC"), ("°", "deg"), ("µ", "u"), ("²", "2"),
    ("³", "3"), ("·", ""), ("–", ""), ("(", ""), (")", ""),
)  # fmt: skip
_NUMBER: Final = re.compile(r"[+-]?[\d.,]+(?:[eE][+-]?\d+)?\Z")
_NOT_IN_SHEET_NAME: Final = re.compile(r"[\[\]:*?/\\\x00-\x1f]+")
_LONGEST_SHEET_NAME: Final = 31
_MOST_ROWS: Final = 1_048_576
_WIDTHS: Final = (8, 44)


def table_of(document: Document, key: str = "") -> Table:
    """Return the table of a key; without one the main table of a document.

    Raises
    ------
    InputError
        If there is none.
    """
    tables = {table.key: table for table in document.tables()}
    if not tables:
        raise InputError(said("this page has no table to write"))
    wanted = key or document.main
    if wanted in tables:
        return tables[wanted]
    if key:
        raise InputError(
            said("must be one of {names}", names=", ".join(tables)),
            value=key,
            example=nearest(key, tables),
        )
    return next(iter(tables.values()))


def to_csv(
    document: Document, key: str = "", *, separator: str = ",", decimal: str = ".", si: bool = False
) -> str:
    """Return one table of a document as CSV, lines ending in CR LF.

    Parameters
    ----------
    document
        The page that the table stands on.
    key
        Of the table; by default its main one.
    separator
        A comma, a semicolon, a tab or a bar.
    decimal
        A point or a comma.
    si
        SI units instead of those that the page shows.

    Raises
    ------
    InputError
        If there is no such table, or separator and decimal mark are the same.
    """
    if separator == decimal:
        raise InputError(
            said("the separator and the decimal mark must differ"), value=separator, example=";"
        )
    fields = _fields(table_of(document, key), si)
    text = io.StringIO(newline="")
    writer = csv.writer(text, delimiter=separator)
    writer.writerow([one.plain_name for one in fields])
    for row in zip(*(one.values for one in fields), strict=True):
        writer.writerow([_csv_cell(value, decimal) for value in row])
    return text.getvalue()


def to_xlsx(document: Document, *, si: bool = False) -> bytes:
    """Return the tables of a document as a workbook, a sheet for each.

    Parameters
    ----------
    document
        The page that they stand on.
    si
        SI units instead of those that the page shows.

    Raises
    ------
    InputError
        If there is no table, or one has more rows than a sheet can hold.
    """
    from openpyxl import Workbook

    table_of(document)
    book = Workbook()
    book.remove(book.worksheets[0])
    book.properties.title = NOT_IN_SHEET.sub(" ", document.title)
    book.properties.creator = "Rolamento"
    taken: set[str] = set()
    for table in document.tables():
        _fill(book.create_sheet(_sheet_name(table.key, taken)), _fields(table, si))
    return book_bytes(book)


# --- columns -----------------------------------------------------------------------------------

Value = float | int | str | None


@frozen
class _Field:
    """A column of a file: its name, its unit, its values."""

    name: str
    unit: str
    values: Sequence[Value]

    @property
    def plain_name(self) -> str:
        """Name and unit in characters that every program can read: ``deflection_um``."""
        unit = self.unit
        for character, plain in _PLAIN_UNITS:
            unit = unit.replace(character, plain)
        over = unit.removeprefix("1/") if unit.startswith("1/") else ""
        unit = f"per_{over}" if over else unit.replace("/", "_per_")
        return f"{self.name}_{unit}" if unit else self.name

    @property
    def readable_name(self) -> str:
        """Name and unit as they stand above a column: ``deflection [µm]``."""
        return f"{self.name} [{self.unit}]" if self.unit not in ("", "–") else self.name


def _fields(table: Table, si: bool) -> list[_Field]:
    taken: set[str] = set()
    fields: list[_Field] = []
    for place, column in enumerate((one for one in table.columns if not one.bar), 1):
        plain = re.sub(r"\W+", "_", column.head).strip("_")
        unit = _unit(column)
        values = [_value(value, column, unit, si) for value in column.values]
        shown = _in_si(unit) if si else unit
        named = _Field(column.key or plain or f"column_{place}", shown, values)
        while named.plain_name.casefold() in taken:
            named = replace(named, name=f"{named.name}_{place}")
        taken.add(named.plain_name.casefold())
        fields.append(named)
    return fields


def _unlike(name: str, taken: set[str]) -> str:
    """Return a name that is not taken yet, which then is."""
    names = (name if again == 1 else f"{name}_{again}" for again in range(1, len(taken) + 2))
    free = next(one for one in names if one.casefold() not in taken)
    taken.add(free.casefold())
    return free


def _unit(column: Column) -> str:
    """Return the one unit of a column; nothing where its numbers have several."""
    if column.unit or column.form:
        return column.unit or unit_of(column.form)
    units = {unit_of(value.form) for value in column.values if isinstance(value, Number)}
    return units.pop() if len(units) == 1 else ""


def _value(value: CellContent, column: Column, unit: str, si: bool) -> Value:
    """Return what a file has of a cell."""
    if value is not None and hasattr(value, "item"):  # a number of NumPy
        value = value.item()
    if isinstance(value, str):
        names_units = column.key.endswith("unit") or any(
            isinstance(one, Number) for one in column.values
        )
        return _in_si(value) if si and names_units and value in UNITS else value.strip()
    if isinstance(value, bool) or value is None:
        return None if value is None else int(value)
    if isinstance(value, int):
        return value
    number = value.value if isinstance(value, Number) else value
    if not isfinite(number):
        return None
    own = unit or (unit_of(value.form) if isinstance(value, Number) else "")
    if isinstance(value, Number) and value.before.strip() in ("<", ">", "≤", "≥", "~", "≈"):
        return value.before + manner().number(value.value, value.form)
    return float(number) if si else _tidy(float(number), own)


def _tidy(number: float, unit: str) -> float:
    """Return a number in a unit, without the rounding of the conversion: 40, not 39.999…9."""
    converted = float(in_unit(number, unit))
    return number if converted == number else float(f"{converted:.15g}")


def _in_si(unit: str) -> str:
    return SI_UNITS.get(unit, unit)


# --- CSV ---------------------------------------------------------------------------------------


def _csv_cell(value: Value, decimal: str) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return _harmless(printable(value))
    text = repr(value)
    return text.removesuffix(".0").replace(".", decimal)


def _harmless(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula."""
    return f"'{text}" if FORMULA.match(text) and not _NUMBER.match(text) else text


# --- workbook ----------------------------------------------------------------------------------


def _sheet_name(key: str, taken: set[str]) -> str:
    plain = _NOT_IN_SHEET_NAME.sub(" ", key).strip(" '") or "table"
    return _unlike(plain[: _LONGEST_SHEET_NAME - 3].strip(" '"), taken)


def _fill(sheet: Worksheet, fields: Sequence[_Field]) -> None:
    from openpyxl.styles import Alignment, Font
    from openpyxl.utils import get_column_letter

    rows = max((len(one.values) for one in fields), default=0)
    if rows >= _MOST_ROWS:
        raise InputError(
            said(
                "a sheet of a workbook has at most {most} rows, the table {rows}; write CSV",
                most=_MOST_ROWS - 1,
                rows=rows,
            ),
            example="--csv",
        )
    for column, one in enumerate(fields, 1):
        head = sheet.cell(1, column)
        put_text(head, one.readable_name)
        head.font = Font(bold=True)
        text = any(isinstance(value, str) for value in one.values)
        head.alignment = Alignment(horizontal="left" if text else "right")
        longest = len(one.readable_name) + 1
        for row, value in enumerate(one.values, 2):
            if isinstance(value, str):
                put_text(sheet.cell(row, column), value)
            elif value is not None:
                sheet.cell(row, column, value)
            longest = max(longest, len(value) if isinstance(value, str) else 0)
        width = min(max(longest + 1, _WIDTHS[0]), _WIDTHS[1])
        sheet.column_dimensions[get_column_letter(column)].width = width
    sheet.freeze_panes = "A2"
