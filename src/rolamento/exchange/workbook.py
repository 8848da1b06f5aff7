"""A machine as a workbook (.xlsx), one sheet a table, or as data frames; and back.

`rolamento.load_machine` takes workbooks; how tables are read is `rolamento.case.machine_sheets`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.case.case import Case
from rolamento.case.fields import Field, fields_of
from rolamento.case.machine import Machine, Section
from rolamento.case.machine_files import CASE_TABLES
from rolamento.case.machine_sheets import PARTS, Sheet, sheets_of_tables, tables_of_sheets
from rolamento.case.record import records_of
from rolamento.errors import InputError, kind_of
from rolamento.io.sheets import Cell, book_bytes, put_text
from rolamento.words import said

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["machine_of_frames", "machine_to_frames", "machine_to_xlsx"]

_ABOUT: Final = (
    "A machine, one sheet a table. Change it and save; rolamento shaft FILE.xlsx solves it.",
    "A line is a part; columns are the keys of a machine file, with a unit in brackets for numbers"
    " without one. A cell may have its own: 20 mm.",
    "Columns that are not needed may be left out, others of the sheet # fields added. Sheets whose"
    " names begin with # are not read.",
)
_WIDTHS: Final = (8, 44)


def machine_to_xlsx(machine: Machine) -> bytes:
    """Return a machine as a workbook, which `rolamento.load_machine` reads back identically.

    The same bytes for the same machine. Sheets # read me and # fields say how it is read and which
    columns there are.
    """
    from openpyxl import Workbook
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    sheets = {
        "# read me": Sheet(_ABOUT[:1], tuple((line,) for line in _ABOUT[1:])),
        **sheets_of_tables(machine.to_mapping()),
        "# fields": Sheet(("sheet", "column", "example", "meaning"), tuple(_known())),
    }
    book = Workbook()
    book.remove(book.worksheets[0])
    book.properties.creator = "Rolamento"
    for name, sheet in sheets.items():
        own = book.create_sheet(name)
        for row, cells in enumerate([sheet.columns, *sheet.rows], 1):
            for column, value in enumerate(cells, 1):
                if isinstance(value, float) and float(f"{value:.16g}") != value:
                    put_text(own.cell(row, column), repr(value))  # openpyxl writes 16 digits
                elif isinstance(value, str):
                    put_text(own.cell(row, column), value)
                elif value is not None:
                    own.cell(row, column, value)
        for column, head in enumerate(sheet.columns, 1):
            own.cell(1, column).font = Font(bold=True)
            texts = [head, *(row[column - 1] for row in sheet.rows)]
            longest = max(len(one) for one in texts if isinstance(one, str))
            width = min(max(longest + 2, _WIDTHS[0]), _WIDTHS[1])
            own.column_dimensions[get_column_letter(column)].width = width
        own.freeze_panes = "A2"
    return book_bytes(book)


def _known() -> Iterator[tuple[Cell, ...]]:
    """The columns of each sheet, with an example and what each is."""
    for kind in PARTS:
        for record in records_of(Machine.model_fields[kind].annotation):
            for name, field in fields_of(record).items():
                if name not in (*CASE_TABLES, "sections"):
                    yield _described(kind, name, field)
        if kind == "shafts":
            yield "sections", "shaft", "shaft", said("name of the shaft, from left to right")
            for name, field in fields_of(Section).items():
                yield _described("sections", name, field)
        if kind == "bearings":
            for name, field in Case.fields().items():
                if name.partition(".")[0] in CASE_TABLES:
                    yield _described(kind, name, field)


def _described(sheet: str, name: str, field: Field) -> tuple[Cell, ...]:
    return sheet, name, str(field.example), field.meaning


# --- data frames ----------------------------------------------------------------------------------


def machine_to_frames(machine: Machine) -> dict[str, pd.DataFrame]:
    """Return a machine as data frames, a table each: shafts, sections, bearings and so on.

    Columns are as in a workbook, with their units: ``position [mm]``.

    >>> import rolamento as ro
    >>> from rolamento.exchange.workbook import machine_of_frames, machine_to_frames
    >>> machine = ro.Machine.from_mapping({
    ...     "shafts": [{"name": "s", "speed": "900 rpm",
    ...                 "sections": [{"length": "90 mm", "diameter": "30 mm"}]}],
    ...     "bearings": [{"name": "A", "shaft": "s", "position": "20 mm", "designation": "6206"}],
    ... })
    >>> frames = machine_to_frames(machine)
    >>> frames["sections"].columns.tolist()
    ['shaft', 'length [mm]', 'diameter [mm]', 'bore [mm]']
    >>> frames["bearings"].loc[0, "designation"] = "6306"
    >>> machine_of_frames(frames).bearings[0].designation
    '6306'
    """
    import pandas as pd

    return {
        name: pd.DataFrame([list(row) for row in sheet.rows], columns=list(sheet.columns))
        for name, sheet in sheets_of_tables(machine.to_mapping()).items()
    }


def machine_of_frames(frames: Mapping[str, pd.DataFrame]) -> Machine:
    """Return the machine of data frames as `machine_to_frames` gives them.

    Parameters
    ----------
    frames
        By the names of their tables; what is missing in a frame (NaN, None) is not given.

    Raises
    ------
    InputError
        If they describe no valid machine.
    """
    import pandas as pd

    sheets = {}
    for name, frame in frames.items():
        if not isinstance(frame, pd.DataFrame):
            raise InputError(said("must be a data frame"), field=name, value=kind_of(frame))
        rows = tuple(
            tuple(_cell(value) for value in row)
            for row in frame.astype(object).itertuples(index=False, name=None)
        )
        sheets[str(name)] = Sheet(tuple(map(str, frame.columns)), rows)
    return Machine.from_mapping(tables_of_sheets(sheets))


def _cell(value: Any) -> Cell:
    if hasattr(value, "item"):
        value = value.item()
    if value is None or value != value or isinstance(value, str | bool | int | float):  # NaN
        return None if value is None or value != value else value
    return str(value)
