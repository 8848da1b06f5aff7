"""Results as NetCDF files, with h5netcdf.

Variables are stored whole and uncompressed: the digits of a computed number do not compress (a
sixth is gained for seven times the time), and any run of cases can be written in place.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from math import prod
from pathlib import Path
from typing import Any, Final

import h5netcdf
import numpy as np

from rolamento.io.writing import check_space
from rolamento.studies.plan import Layout, Part, Plan, Variable, slabs
from rolamento.words import Note

__all__ = ["netcdf_writer"]

_SAMPLES_AT_ONCE: Final = 2**16


class _NetCDF:
    def __init__(self, file: Any, plan: Plan, layout: Layout, disk: _Disk) -> None:
        self._plan, self._file, self._layout, self._disk = plan, file, layout, disk

    def put(self, part: Part) -> None:
        first, last = self._plan.bounds_of(part)
        pieces = list(slabs(first, last, self._plan.study.shape))
        for variable in self._layout.outputs:
            target, values = self._file.variables[variable.name], part.arrays[variable.name]
            for place, run in pieces:
                shape = tuple(s.stop - s.start for s in place) + values.shape[1:]
                target[place] = values[run].reshape(shape)
        self._disk.check()


@contextmanager
def netcdf_writer(
    path: Path, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
) -> Iterator[_NetCDF]:
    """Open a NetCDF file for the parts of a result; coordinates are written at once."""
    layout = Layout(plan, reasons)
    check_space(_size(layout), path)
    with _Disk(path) as disk, h5netcdf.File(disk, "w") as file:
        file.attrs.update(_with_sized_integers(layout.attrs(counts)))
        file.dimensions = dict(layout.sizes)
        for variable in layout.axes:
            _write_coordinate(file, variable)
        for variable in (*layout.samples, *layout.outputs):
            _create(file, variable)
        if layout.coordinates:
            for variable in layout.outputs:
                file.variables[variable.name].attrs["coordinates"] = layout.coordinates
        _write_samples(file, plan, layout)
        disk.check()
        yield _NetCDF(file, plan, layout, disk)


class _Disk:
    """A file that never fails while HDF5 writes to it: over a full disk the library crashes.

    What goes wrong is kept, and raised between two variables and at the end.
    """

    def __init__(self, path: Path) -> None:
        self._file = path.open("w+b", buffering=0)
        self._error: OSError | None = None
        self.seek, self.tell = self._file.seek, self._file.tell

    def __enter__(self) -> _Disk:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        try:
            self._file.close()
        except OSError as error:
            self._error = self._error or error
        if kind is None:
            self.check()

    def check(self) -> None:
        """Raise what has gone wrong."""
        if self._error is not None:
            raise self._error

    def write(self, content: Any) -> int:
        """Write all of it, or nothing once something has gone wrong."""
        view = memoryview(content).cast("B")
        done = 0
        try:
            while done < len(view) and self._error is None:
                done += self._file.write(view[done:]) or 0
        except OSError as error:
            self._error = error
        return len(view)

    def readinto(self, buffer: Any) -> int:
        """Read what was written; nothing that was not."""
        view = memoryview(buffer).cast("B")
        try:
            read = self._file.readinto(view) or 0
        except OSError as error:
            self._error, read = error, 0
        view[read:] = bytes(len(view) - read)
        return len(view)

    def read(self, count: int) -> bytes:
        """Read as `readinto`."""
        buffer = bytearray(count)
        self.readinto(buffer)
        return bytes(buffer)

    def truncate(self, size: int | None = None) -> int:
        """Set the length."""
        try:
            return self._file.truncate(size)
        except OSError as error:
            self._error = error
            return size or 0

    def flush(self) -> None:
        """Nothing is held back."""


def _size(layout: Layout) -> int:
    """Bytes of the numbers of a result; what HDF5 says of them is little beside a large one."""
    return sum(
        prod(layout.sizes[name] for name in variable.dims) * variable.dtype.itemsize
        for variable in (*layout.samples, *layout.outputs)
    )


def _create(file: Any, variable: Variable) -> Any:
    created = file.create_variable(variable.name, variable.dims, variable.dtype)
    created.attrs.update(_with_sized_integers(variable.attrs))
    if variable.dtype.kind == "f":
        created.attrs["_FillValue"] = np.float64(np.nan)
    return created


def _write_coordinate(file: Any, variable: Variable) -> None:
    values = variable.values
    assert values is not None
    attrs = dict(variable.attrs)
    if values.dtype.kind == "b":  # as xarray writes and reads them
        values, attrs = values.astype(np.int8), {**attrs, "dtype": "bool"}
    elif values.dtype.kind == "U":
        values = values.astype(object)
    dtype: Any = h5netcdf.core.h5py.string_dtype() if values.dtype == object else values.dtype
    created = file.create_variable(variable.name, variable.dims, dtype)
    created[...] = values
    created.attrs.update(_with_sized_integers(attrs))


def _write_samples(file: Any, plan: Plan, layout: Layout) -> None:
    """Write the scattered fields, which no part holds: they follow from the seed."""
    if plan.sampler is None:
        return
    size = layout.sizes[layout.samples[0].dims[0]]
    names = {layout.names[name]: name for name in layout.names}
    for first in range(0, size, _SAMPLES_AT_ONCE):
        last = min(first + _SAMPLES_AT_ONCE, size)
        drawn = plan.sampler.draw(first, last)
        for variable in layout.samples:
            file.variables[variable.name][first:last] = drawn[names[variable.name]]


def _with_sized_integers(attrs: Mapping[str, Any]) -> dict[str, Any]:
    """Give whole numbers a size."""
    return {name: np.int64(v) if isinstance(v, int) else v for name, v in attrs.items()}
