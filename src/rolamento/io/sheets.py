"""Workbooks (.xlsx): their sheets as text or cells, and what is written to them.

They are read by openpyxl, in a process of its own.
"""

from __future__ import annotations

import io
import os
import re
import stat
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import check_whole, size_of_file
from rolamento.io.foreign.isolated import Isolated
from rolamento.io.foreign.readers import WorkbookSheets
from rolamento.words import marked, said

if TYPE_CHECKING:
    from openpyxl import Workbook

__all__ = [
    "FORMULA",
    "NOT_IN_SHEET",
    "Cell",
    "begins_as_archive",
    "book_bytes",
    "cells_of_workbook",
    "is_workbook",
    "put_text",
    "text_of_workbook",
]

FORMULA: Final = re.compile(r"[=+\-@\t\r](?!\Z)")
"""How a text begins that a spreadsheet takes for a formula."""
NOT_IN_SHEET: Final = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")
"""Characters that no sheet holds."""
_DAY: Final = (1980, 1, 1, 0, 0, 0)
"""The day of every file in a workbook: the same tables give the same bytes."""

_ENDINGS: Final = (".xlsx", ".xlsm")
_MOST_LISTED: Final = 12
_OLD: Final = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
"""How workbooks before 2007 begin."""


def is_workbook(path: str | os.PathLike[str]) -> bool:
    """Return whether a name, but for a sheet behind #, is that of a workbook that is there.

    Raises
    ------
    FileError
        If it is one of before 2007 (.xls), or an OpenDocument spreadsheet (.ods).
    """
    file, _ = _file_and_sheet(path)
    try:
        if not stat.S_ISREG(os.stat(file).st_mode):  # a pipe would be waited for
            return False
        with open(file, "rb") as stream:
            head = stream.read(120)
    except (OSError, ValueError):
        return False
    name = os.fspath(file).lower()
    if head.startswith(_OLD):
        rule = said("is a workbook of before 2007 (.xls); save it as .xlsx or as CSV")
        raise FileError(rule, source=file)
    if begins_as_archive(head) and b"opendocument.spreadsheet" in head:
        rule = said("is an OpenDocument spreadsheet; save it as .xlsx or as CSV")
        raise FileError(rule, source=file)
    return begins_as_archive(head) and (name.endswith(_ENDINGS) or _holds_workbook(file))


def _holds_workbook(file: str) -> bool:
    """Whether an archive under any name has the parts of a workbook."""
    try:
        with zipfile.ZipFile(file) as archive:
            return "xl/workbook.xml" in archive.NameToInfo
    except (OSError, ValueError, zipfile.BadZipFile, NotImplementedError):
        return False


def begins_as_archive(head: bytes) -> bool:
    """Return whether first bytes are those of a ZIP archive."""
    return head[:4] in (b"PK\x03\x04", b"PK\x05\x06")


def text_of_workbook(path: str | os.PathLike[str], most: int) -> str:
    """Return a sheet as text whose cells are parted by tabs, with decimal points.

    Parameters
    ----------
    path
        Of the workbook; the name of a sheet may stand behind ``#``.
    most
        Characters of the text.

    Raises
    ------
    FileError
        If it is damaged or too large, has no such sheet, or has several and none is named.
    """
    source = os.fspath(path)
    file, wanted = _file_and_sheet(path)
    check_whole(size_of_file(file), source)
    with Isolated(WorkbookSheets, Path(file), marked("workbook")) as workbook:
        names: list[str] = workbook.ask("filled")
        if not names:
            raise FileError(said("is a workbook without a table"), source=source)
        known = ", ".join(names[:_MOST_LISTED])
        if wanted is None and len(names) > 1:
            raise FileError(
                said(
                    "has several sheets ({names}); name one after the name of the file", names=known
                ),
                source=source,
                example=f"{os.path.basename(file)}#{names[0]}",
            )
        if wanted is not None and wanted not in names:
            raise FileError(
                said("has no such sheet with anything in it; it has {names}", names=known),
                field=wanted,
                source=file,
                example=f"{os.path.basename(file)}#{names[0]}",
            )
        text: bytes = workbook.ask("text", names[0] if wanted is None else wanted, most).tobytes()
    return text.decode("utf-8")


Cell = str | float | bool | None
"""What stands in a cell; None of an empty one."""


def cells_of_workbook(
    path: str | os.PathLike[str], most_sheets: int, most_rows: int, most: int
) -> dict[str, list[list[Cell]]]:
    """Return what the cells of all sheets hold that are shown and not empty, by their names.

    Parameters
    ----------
    path
        Of the workbook.
    most_sheets, most_rows
        Sheets, and rows of each.
    most
        Characters of all texts of a sheet.

    Raises
    ------
    FileError
        If it is damaged or holds more.
    """
    source = os.fspath(path)
    check_whole(size_of_file(source), source)
    with Isolated(WorkbookSheets, Path(source), marked("workbook")) as workbook:
        names: list[str] = workbook.ask("filled")
        if not names:
            raise FileError(said("is a workbook without a table"), source=source)
        if len(names) > most_sheets:
            raise FileError(said("has more than {most} sheets", most=most_sheets), source=source)
        return {name: workbook.ask("cells", name, most_rows, most) for name in names}


def _file_and_sheet(path: str | os.PathLike[str]) -> tuple[str, str | None]:
    """Name of the file, and of the sheet if one stands behind #."""
    whole = os.fspath(path)
    file, mark, sheet = whole.rpartition("#")
    if mark and file.lower().endswith(_ENDINGS) and not os.path.exists(whole):
        return file, sheet
    return whole, None


# --- what is written ------------------------------------------------------------------------------


def put_text(cell: Any, text: str) -> None:
    """Write a text to a cell of openpyxl as a text, whatever it begins with."""
    cell.value = NOT_IN_SHEET.sub("\ufffd", text)
    cell.data_type = "s"
    cell.quotePrefix = bool(FORMULA.match(text))


def book_bytes(book: Workbook) -> bytes:
    """Return a workbook of openpyxl as a file that does not say when it was written."""
    written = io.BytesIO()
    book.save(written)
    content = io.BytesIO()
    with zipfile.ZipFile(written) as old, zipfile.ZipFile(content, "w") as new:
        for name, data in _parts(old):
            entry = zipfile.ZipInfo(name, _DAY)
            entry.compress_type = zipfile.ZIP_DEFLATED
            new.writestr(entry, data)
    return content.getvalue()


def _parts(book: zipfile.ZipFile) -> Iterator[tuple[str, bytes]]:
    for name in book.namelist():
        data = book.read(name)
        if name == "docProps/core.xml":
            data = re.sub(rb"<dcterms:(created|modified)\b.*?</dcterms:\1>", b"", data)
        yield name, data
