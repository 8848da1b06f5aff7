"""Sheets of workbooks (.xlsx) as text: what openpyxl finds in one, in a process of its own."""

from __future__ import annotations

import os
import stat
import zipfile
from pathlib import Path
from typing import Final

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import check_whole, size_of_file
from rolamento.io.foreign.isolated import Isolated
from rolamento.io.foreign.readers import WorkbookSheets
from rolamento.words import marked, said

__all__ = ["begins_as_archive", "is_workbook", "text_of_workbook"]

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


def _file_and_sheet(path: str | os.PathLike[str]) -> tuple[str, str | None]:
    """Name of the file, and of the sheet if one stands behind #."""
    whole = os.fspath(path)
    file, mark, sheet = whole.rpartition("#")
    if mark and file.lower().endswith(_ENDINGS) and not os.path.exists(whole):
        return file, sheet
    return whole, None
