"""Which format a file has: by its first bytes, whatever it is called."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import BinaryIO, Final, Literal

from rolamento.errors import FileError, InputError
from rolamento.io.foreign.bounds import check_declared, guarded, size_of_file
from rolamento.io.numerals import DecimalMark
from rolamento.io.sheets import is_workbook, text_of_workbook
from rolamento.io.tables import decoded, encoding_of
from rolamento.vibration.reading.channels import Source
from rolamento.words import marked, said

__all__ = ["ENDINGS", "open_source"]

ENDINGS: Final = {
    "WAV": (".wav", ".wave", ".rf64"),
    "CSV": (".csv", ".txt", ".tsv", ".dat", ".asc"),
    "NumPy": (".npy", ".npz"),
    "MATLAB": (".mat",),
    "HDF5": (".h5", ".hdf5", ".hdf", ".he5", ".nc"),
    "Parquet": (".parquet", ".pq"),
    "UFF": (".uff", ".unv", ".uf", ".bunv"),
    "TDMS": (".tdms",),
    "XLSX": (".xlsx", ".xlsm"),
}
"""Endings by format."""

_HDF5: Final = b"\x89HDF\r\n\x1a\n"
_HDF5_PLACES: Final = (0, 512, 1024, 2048, 4096)
_DOUBLE: Final = 8
_TDMS: Final = b"TDSm"
_HEAD: Final = 64 * 2**10
_LARGEST_SHEET: Final = 256 * 2**20
"""Characters of a sheet, which has a million rows at most."""
_NO_TEXT: Final = re.compile(rb"[\x00-\x08\x0e-\x1a\x1c-\x1f]")
_OTHERS: Final = {
    b"<rexs": marked("is a REXS model of a gear unit, not a signal; `rolamento import` reads it"),
    b"\xd0\xcf\x11\xe0": marked(
        "is a file of Microsoft Office of before 2007; save it as .xlsx or as CSV"
    ),
}
"""Formats that are known and not read, by what stands among the first bytes, and what to do."""
_UFF: Final = re.compile(rb"\s{0,200}-1[ \r]*\n *\d{1,5}[bB]?[ \d]*\r?\n")


def open_source(path: str | os.PathLike[str], mark: DecimalMark | None = None) -> Source:
    """Open a file with the reader of its format.

    mark: the decimal one of a table of text, over what the table says.

    Raises
    ------
    FileError
        If it cannot be opened, is of no known format, is damaged, or declares far more than it has.
    """
    file = _path(path)
    source = str(file)
    if is_workbook(source):
        text = text_of_workbook(source, _LARGEST_SHEET)
        from rolamento.vibration.reading.csv_file import CsvSource

        return CsvSource(file, mark, text.encode("utf-8"))
    size = size_of_file(file)
    with guarded(source, marked("signal file")), file.open("rb") as stream:
        head = stream.read(512)
        kind = _kind(head, stream, size, file.suffix.lower())
    if not kind:
        raise _unknown(head, file.suffix.lower(), source)
    with guarded(source, marked("signal file")):
        opened_source = _source_of(kind, file, mark)
        try:
            for channel in opened_source.channels:
                check_declared(_DOUBLE * channel.length, size, source)
        except FileError:
            opened_source.close()
            raise
        return opened_source


def _path(path: str | os.PathLike[str]) -> Path:
    given: object = os.fspath(path) if isinstance(path, os.PathLike) else path
    if not isinstance(given, str) or "\0" in given or not given:
        raise FileError(
            said("must be the name of a file"), field="path", value=given, example='"bearing.wav"'
        )
    return Path(given)


def _kind(head: bytes, stream: BinaryIO, size: int, ending: str) -> str:
    """Format of a file, or "" if it is none that is read."""
    if head[:4] in (b"RIFF", b"RIFX", b"RF64") and head[8:12] == b"WAVE":
        return "wav"
    if head[:6] == b"\x93NUMPY":
        return "numpy"
    if head[:4] in (b"PK\x03\x04", b"PK\x05\x06"):
        return "numpy"
    if head[:4] == b"PAR1":
        return "parquet"
    for place in _HDF5_PLACES:
        if place < size:
            stream.seek(place)
            if stream.read(8) == _HDF5:
                return "hdf5"
    if head[126:128] in (b"IM", b"MI") and head[124:126] in (b"\x00\x01", b"\x01\x00"):
        return "matlab"
    if _UFF.match(head):
        return "uff"
    if head.startswith(_TDMS):
        return "tdms"
    return "csv" if ending in ENDINGS["CSV"] or _is_table(head, stream) else ""


def _is_table(head: bytes, stream: BinaryIO) -> bool:
    """Whether text begins as a table of numbers does, with or without lines above them."""
    from rolamento.vibration.reading.csv_file import layout_of

    if encoding_of(head) == "utf-8" and _NO_TEXT.search(head):
        return False
    stream.seek(0)
    try:
        text = decoded(stream.read(_HEAD), "")
        layout_of(text[: text.rfind("\n") + 1].encode("utf-8"), "")
    except FileError:
        return False
    except InputError:  # a table in which something may be read in two ways
        return True
    return True


def _unknown(head: bytes, ending: str, source: str) -> FileError:
    other = next((rule for begin, rule in _OTHERS.items() if begin in head), "")
    if other:
        return FileError(said(other), source=source)
    named = next((kind for kind, endings in ENDINGS.items() if ending in endings), "")
    if ending == ".mat":
        rule = said("is not a MATLAB file of version 5 to 7.3; in MATLAB, save it with -v7")
    elif named:
        rule = said("is not a {named} file, although its name says so", named=named)
    else:
        known = "; ".join(f"{kind} ({', '.join(ends)})" for kind, ends in ENDINGS.items())
        rule = said("is not of a format that can be read: {known}", known=known)
    return FileError(rule, source=source)


def _source_of(kind: str, path: Path, mark: DecimalMark | None) -> Source:
    """Return the reader of a format; each is imported when a file asks for it."""
    if kind == "csv":
        from rolamento.vibration.reading.csv_file import CsvSource

        return CsvSource(path, mark)
    if kind == "wav":
        from rolamento.vibration.reading.wav import WavSource

        return WavSource(path)
    if kind == "parquet":
        from rolamento.vibration.reading.parquet import ParquetSource

        return ParquetSource(path)
    if kind == "uff":
        from rolamento.vibration.reading.uff import UffSource

        return UffSource(path)
    from rolamento.vibration.reading.arrays import IsolatedSource, NumpySource

    if kind == "numpy":
        return NumpySource(path)
    kinds: dict[str, Literal["HDF5", "MATLAB", "TDMS"]] = {"hdf5": "HDF5", "tdms": "TDMS"}
    return IsolatedSource(path, kinds.get(kind, "MATLAB"))
