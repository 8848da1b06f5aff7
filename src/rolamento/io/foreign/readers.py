"""What reads MATLAB, HDF5, NetCDF, TDMS and workbooks, in a process of its own (`Isolated`).

These classes know nothing but errors and bounds, and import a library when they need it, so that
the process starts soon.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import field
from datetime import date, datetime, time
from itertools import islice
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import (
    LARGEST_CHUNK,
    check_declared,
    check_inflated,
    most_declared,
)
from rolamento.records import frozen
from rolamento.words import said

__all__ = [
    "MOST_VARIABLES",
    "Hdf5Arrays",
    "MatlabArrays",
    "NetcdfVariables",
    "TdmsChannels",
    "Variable",
    "WorkbookSheets",
]

MOST_VARIABLES: Final = 10_000
_DEEPEST: Final = 5
"""Structures within structures of a MATLAB file."""
_LONGEST_TEXT: Final = 200
_MOST_ATTRIBUTES: Final = 100
_NUMBER_AS_TEXT: Final = re.compile(r"[+-]?[\d.,]*[.,][\d.,]*")
_MOST_NAMED: Final = 6
_MOST_CELLS_OF_ROW: Final = 1000
_LINES_LOOKED_AT: Final = 1000
"""Number of lines of a sheet, to see whether it holds anything."""


@frozen
class Variable:
    """An array of real numbers in a file.

    Attributes
    ----------
    name
        with dots or strokes before it where the file has structures or groups
    shape
        of the array
    value
        of an array of one number; None of others
    numbers, texts
        what the file says of it
    """

    name: str
    shape: tuple[int, ...]
    value: float | None = None
    numbers: Mapping[str, float] = field(default_factory=dict)
    texts: Mapping[str, str] = field(default_factory=dict)


class MatlabArrays:
    """The arrays of a MATLAB file of version 5 to 7, by SciPy; it is held whole.

    Of structures of one element the fields are taken; of those of several, each element under what
    its Name says, or its number: its Data or Value, or else its fields. Cells of structures are
    read likewise; other cells, objects, functions, text, sparse and complex arrays are passed over.
    """

    def __init__(self, path: str) -> None:
        import scipy.io

        size = os.path.getsize(path)
        # what lies in structures is not listed, and counted when it has been read
        listed = sum(math.prod(shape) for _, shape, _ in scipy.io.whosmat(path))
        check_declared(8 * listed, size, path)
        found = scipy.io.loadmat(path, simplify_cells=True)
        top = {name: value for name, value in found.items() if not name.startswith("__")}
        self._arrays = dict(_real_arrays(top, "", 0))
        self._others = [f"{name}: {_kind_of_value(value)}" for name, value in top.items()]
        if len(self._arrays) > MOST_VARIABLES:
            raise FileError(said("has more than {most} arrays", most=MOST_VARIABLES))
        inflated = sum(array.nbytes for array in self._arrays.values())
        check_inflated(inflated, size, path)

    def variables(self) -> list[Variable]:
        """All arrays of real numbers."""
        return [
            Variable(name, array.shape, float(array.reshape(-1)[0]) if array.size == 1 else None)
            for name, array in self._arrays.items()
        ]

    def others(self) -> list[str]:
        """What the file holds at its top, in words."""
        return self._others[:_MOST_NAMED]

    def samples(self, name: str, axis: int, row: int, start: int, count: int) -> NDArray[Any]:
        """Numbers of a row or column of an array, as doubles."""
        array = self._arrays[name]
        line = array if array.ndim == 1 else np.moveaxis(array, axis, 0)[:, row]
        return line[start : start + count].astype(np.float64)


class Hdf5Arrays:
    """The arrays of an HDF5 file, by h5py.

    Only what lies in the file itself is followed: soft and external links, virtual and externally
    stored data sets and references are passed over.
    """

    def __init__(self, path: str) -> None:
        import h5py  # type: ignore[import-untyped]

        self._h5py = h5py
        # a chunk that is inflated is kept for the next block
        self._file = h5py.File(path, "r", rdcc_nbytes=LARGEST_CHUNK)
        self._largest_chunk = min(LARGEST_CHUNK, most_declared(os.path.getsize(path)))

    def variables(self) -> list[Variable]:
        """All arrays of real numbers; what a group says of them is said of all below it."""
        found: list[Variable] = []
        groups = {"": self._attributes(self._file)}

        def visit(name: str, entry: Any) -> None:
            if len(found) + len(groups) > MOST_VARIABLES:
                raise FileError(
                    said("holds more than {most} groups and data sets", most=MOST_VARIABLES)
                )
            if name.split("/")[0] == "#refs#":
                return
            numbers, texts = groups[name.rpartition("/")[0]]
            own_numbers, own_texts = self._attributes(entry)
            numbers, texts = {**numbers, **own_numbers}, {**texts, **own_texts}
            if not isinstance(entry, self._h5py.Dataset):
                groups[name] = numbers, texts
            elif self._is_plain(entry):
                self._check_chunks(entry, name)
                value = float(np.asarray(entry[()]).reshape(-1)[0]) if entry.size == 1 else None
                finite = value is not None and math.isfinite(value)
                found.append(Variable(name, entry.shape, value if finite else None, numbers, texts))

        self._file.visititems(visit)
        return found

    def samples(self, name: str, axis: int, row: int, start: int, count: int) -> NDArray[Any]:
        """Numbers of a row or column of a data set, as doubles."""
        data = self._file[name]
        place = [slice(row, row + 1)] * data.ndim
        place[axis] = slice(start, start + count)
        return np.asarray(data[tuple(place)]).reshape(-1).astype(np.float64)

    def _is_plain(self, data: Any) -> bool:
        """Whether a data set holds real numbers in the file itself."""
        properties = data.id.get_create_plist()
        if properties.get_layout() == self._h5py.h5d.VIRTUAL or properties.get_external_count():
            return False
        try:
            dtype = data.dtype
        except TypeError:  # a kind of number that NumPy does not have
            return False
        if dtype.kind not in "iuf" or dtype.itemsize > 8:
            return False
        if not data.id.get_type().equal(self._h5py.h5t.py_create(dtype)):  # an enumeration
            return False
        return data.shape is not None and len(data.shape) <= 2 and data.size > 0

    def _check_chunks(self, data: Any, name: str) -> None:
        if data.chunks and math.prod(data.chunks) * data.dtype.itemsize > self._largest_chunk:
            limit = self._largest_chunk // 2**20
            raise FileError(
                said('"{name}" has chunks of more than {limit} MB', name=name[:60], limit=limit)
            )

    def _attributes(self, entry: Any) -> tuple[dict[str, float], dict[str, str]]:
        """Single numbers and short texts that an object carries."""
        numbers: dict[str, float] = {}
        texts: dict[str, str] = {}
        h5t = self._h5py.h5t
        for name in list(entry.attrs)[:_MOST_ATTRIBUTES]:
            about = entry.attrs.get_id(name)
            if math.prod(about.shape or ()) != 1 or about.get_storage_size() > 4096:
                continue
            kind = about.get_type().get_class()
            if kind in (h5t.INTEGER, h5t.FLOAT):
                number = float(np.asarray(entry.attrs[name]).reshape(-1)[0])
                if math.isfinite(number):
                    numbers[name[:_LONGEST_TEXT]] = number
            elif kind == h5t.STRING:
                text = _text(np.asarray(entry.attrs[name]).reshape(-1)[0])
                texts[name[:_LONGEST_TEXT]] = text[:_LONGEST_TEXT]
        return numbers, texts


class TdmsChannels:
    """The channels of a TDMS file of LabVIEW and DIAdem, by npTDMS, group by group."""

    def __init__(self, path: str) -> None:
        import nptdms

        size = os.path.getsize(path)
        declared = 0
        with nptdms.TdmsFile.read_metadata(path) as about:
            for group in about.groups():
                declared += 8 * sum(len(channel) for channel in group.channels())
        check_declared(declared, size, path)
        self._file = nptdms.TdmsFile.open(path)
        self._channels = {
            f"{group.name}/{channel.name}": channel
            for group in islice(self._file.groups(), MOST_VARIABLES)
            for channel in islice(group.channels(), MOST_VARIABLES)
            if channel.dtype is not None and channel.dtype.kind in "iuf" and len(channel)
        }
        if len(self._channels) > MOST_VARIABLES:
            raise FileError(said("has more than {most} arrays", most=MOST_VARIABLES))

    def variables(self) -> list[Variable]:
        """All channels of real numbers, with what the file says of them."""
        found = []
        for name, channel in self._channels.items():
            numbers: dict[str, float] = {}
            texts: dict[str, str] = {}
            for key, value in islice(channel.properties.items(), _MOST_ATTRIBUTES):
                if isinstance(value, str):
                    texts[key[:_LONGEST_TEXT]] = value[:_LONGEST_TEXT]
                elif isinstance(value, int | float) and math.isfinite(value):
                    numbers[key[:_LONGEST_TEXT]] = float(value)
            single = float(channel[0]) if len(channel) == 1 else None
            found.append(Variable(name, (len(channel),), single, numbers, texts))
        return found

    def samples(self, name: str, axis: int, row: int, start: int, count: int) -> NDArray[Any]:
        """Numbers of a channel, scaled as the file says, as doubles."""
        values = self._channels[name].read_data(start, count)
        return np.asarray(values, dtype=np.float64)


class NetcdfVariables:
    """The variables of a NetCDF file, with their dimensions and attributes, by h5netcdf."""

    def __init__(self, path: str) -> None:
        import h5netcdf

        self._file = h5netcdf.File(path, "r", decode_vlen_strings=True)
        self._largest_chunk = min(LARGEST_CHUNK, most_declared(os.path.getsize(path)))

    def described(self) -> tuple[dict[str, Any], list[dict[str, Any]]]:
        """Attributes of the file; and name, dims, shape, dtype and attributes of the variables."""
        if len(self._file.variables) > MOST_VARIABLES:
            raise FileError(said("holds more than {most} variables", most=MOST_VARIABLES))
        variables = [self._described(*named) for named in self._file.variables.items()]
        return _plain_attributes(self._file.attrs), variables

    def values(self, name: str, box: tuple[slice, ...]) -> NDArray[Any]:
        """Part of a variable; texts as objects."""
        values = np.asarray(self._file.variables[name][box])
        if values.dtype.kind in "OSU":
            return np.array([_text(text) for text in values.reshape(-1)], dtype=object)
        return values.reshape(-1)

    def _described(self, name: str, variable: Any) -> dict[str, Any]:
        from h5py import check_string_dtype

        kind = variable.dtype
        text = kind is str or check_string_dtype(np.dtype(kind)) is not None
        dtype = np.dtype(object if text else kind)
        if not text and (dtype.kind not in "iufb" or dtype.itemsize > 8):
            raise FileError(said('"{name}" holds neither numbers nor texts', name=name[:60]))
        if variable.chunks and math.prod(variable.chunks) * dtype.itemsize > self._largest_chunk:
            limit = self._largest_chunk // 2**20
            raise FileError(
                said('"{name}" has chunks of more than {limit} MB', name=name[:60], limit=limit)
            )
        return {
            "name": name,
            "dims": tuple(variable.dimensions),
            "shape": tuple(int(length) for length in variable.shape),
            "dtype": dtype,
            "attributes": _plain_attributes(variable.attrs),
        }


class WorkbookSheets:
    """The sheets of a workbook, by openpyxl: values of cells, not their formulas."""

    def __init__(self, path: str) -> None:
        import zipfile

        import openpyxl

        with zipfile.ZipFile(path) as archive:
            inflated = sum(member.file_size for member in archive.infolist())
        check_inflated(inflated, os.path.getsize(path), path)
        self._file = open(path, "rb")  # noqa: SIM115 - of a name without its ending it wants a file
        self._book = openpyxl.load_workbook(self._file, read_only=True, data_only=True)

    def filled(self) -> list[str]:
        """Names of the sheets that are shown and hold something."""
        return [
            sheet.title
            for sheet in self._book.worksheets
            if sheet.sheet_state == "visible"
            and any(
                cell is not None for row in islice(sheet.values, _LINES_LOOKED_AT) for cell in row
            )
        ]

    def text(self, name: str, most: int) -> NDArray[Any]:
        """One sheet as bytes of text, its cells parted by tabs, with decimal points.

        A number is what the sheet holds, not what it shows; a date is written as ISO 8601 has it.
        """
        lines = ["sep=\t", "# decimal mark: point"]
        written = 0
        for row in self._book[name].values:
            line = "\t".join(_cell_text(cell) for cell in row).rstrip("\t")
            written += len(line) + 1
            if written > most:
                raise FileError(said("is larger than {most} MB", most=most // 1_000_000))
            lines.append(line)
        return np.frombuffer("\n".join(lines).encode("utf-8"), np.uint8)

    def cells(self, name: str, most_rows: int, most: int) -> list[list[str | float | bool | None]]:
        """One sheet as it holds its cells: texts, numbers and truths; None of what is empty.

        most_rows: of rows that are looked at; most: characters of all texts.
        """
        sheet = self._book[name]
        sheet.reset_dimensions()  # what a file declares may be far more than it holds
        found: list[list[str | float | bool | None]] = []
        written = 0
        for number, row in enumerate(sheet.values):
            if number >= most_rows:
                raise FileError(said("has more than {most} rows", most=most_rows))
            if len(row) > _MOST_CELLS_OF_ROW:
                raise FileError(said("has more than {most} columns", most=_MOST_CELLS_OF_ROW))
            cells = [
                one if one is None or isinstance(one, bool | int | float) else str(one)
                for one in row
            ]
            written += 8 * len(cells) + sum(len(one) for one in cells if isinstance(one, str))
            if written > most:
                raise FileError(said("is larger than {most} MB", most=most // 1_000_000))
            found.append(cells)
        return found


def _cell_text(cell: Any) -> str:
    """A cell of a workbook as a cell of a table parted by tabs."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return str(int(cell))
    if isinstance(cell, datetime):
        return cell.date().isoformat() if cell.time() == time() else cell.isoformat(" ")
    if isinstance(cell, date | time):
        return cell.isoformat()
    if isinstance(cell, float):
        return repr(int(cell)) if cell.is_integer() and abs(cell) < 1e15 else repr(cell)
    text = " ".join(str(cell).split())
    if _NUMBER_AS_TEXT.fullmatch(text):  # nobody knows which mark it has: it is no number here
        return f"'{text}"
    return '"' + text.replace('"', '""') + '"' if text[:1] == '"' or text[:1] == "#" else text


def _real_arrays(
    structure: Mapping[str, Any], parent: str, depth: int
) -> Iterator[tuple[str, NDArray[Any]]]:
    """Arrays of real numbers in a structure of MATLAB, by name with dots."""
    for name, value in structure.items():
        path = f"{parent}{name[:_LONGEST_TEXT]}"
        if isinstance(value, dict):
            if depth < _DEEPEST:
                yield from _real_arrays(value, f"{path}.", depth + 1)
        elif elements := _elements(value):
            if depth < _DEEPEST:
                yield from _real_arrays(_by_name(elements), f"{path}.", depth + 1)
        elif isinstance(value, np.ndarray | np.generic | int | float):
            array = np.asarray(value)
            if array.dtype.kind in "iufb" and array.size:
                yield path, array


def _kind_of_value(value: Any) -> str:
    """What a variable of MATLAB is, in words."""
    if elements := _elements(value):
        return said("a structure of {count} elements", count=len(elements))
    if isinstance(value, dict):
        return said("a structure")
    array = np.asarray(value)
    if not array.size:
        return said("nothing")
    words = {"U": said("text"), "S": said("text"), "c": said("complex numbers")}
    if array.dtype.kind in "iufb":
        return said("a single number") if array.size == 1 else said("real numbers")
    return words.get(array.dtype.kind, said("cells or objects"))


def _elements(value: Any) -> list[dict[str, Any]]:
    """The elements of a structure of several; none of what is no such structure."""
    if isinstance(value, np.ndarray) and value.dtype == object:
        value = value.reshape(-1)[:MOST_VARIABLES].tolist()
    if isinstance(value, list) and value and all(isinstance(one, dict) for one in value):
        return value
    return []


def _by_name(elements: list[dict[str, Any]]) -> dict[str, Any]:
    """Elements of a structure by what each says its name is, or else by number from 1.

    One that has a name and its data under a usual word stands for these data.
    """
    found: dict[str, Any] = {}
    for number, element in enumerate(elements, start=1):
        words = {key.casefold(): value for key, value in element.items()}
        name = next((words[key] for key in _NAMING if isinstance(words.get(key), str)), "")
        data = next((words[key] for key in _HOLDING if words.get(key) is not None), None)
        label = name.strip() or str(number)
        if label in found:
            label = f"{label} {number}"
        found[label] = element if data is None or not name else data
    return found


_NAMING: Final = ("name", "signalname", "channelname", "label", "title")
_HOLDING: Final = ("data", "value", "values", "samples", "signal", "y")


def _plain_attributes(attrs: Any) -> dict[str, Any]:
    """Attributes of a NetCDF file: texts, lists of texts, and numbers with their types."""
    if len(attrs) > _MOST_ATTRIBUTES:
        raise FileError(
            said("holds more than {most} attributes in one place", most=_MOST_ATTRIBUTES)
        )
    found: dict[str, Any] = {}
    for name, value in attrs.items():
        values = np.asarray(value)
        if isinstance(value, str | bytes):
            found[name] = _text(value)
        elif values.dtype.kind in "OSU":
            found[name] = [_text(text) for text in values.reshape(-1)]
        elif values.dtype.kind in "iufb" and values.ndim <= 1:
            found[name] = values[()] if values.ndim == 0 else values
        else:
            raise FileError(said('"{name}" is neither numbers nor a text', name=name[:60]))
    return found


def _text(text: Any) -> str:
    return text.decode("utf-8", "replace") if isinstance(text, bytes) else str(text)
