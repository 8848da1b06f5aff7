"""Results in memory, as xarray Datasets."""

from __future__ import annotations

import os
from collections.abc import Mapping
from math import prod
from pathlib import Path
from typing import Any, Final

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import check_declared
from rolamento.io.foreign.isolated import Isolated
from rolamento.io.foreign.readers import NetcdfVariables
from rolamento.studies.plan import Layout, Plan, Variable, slabs
from rolamento.studies.study import SAMPLE
from rolamento.words import Note, marked, said

__all__ = ["dataset", "load_result"]

_MOST_BYTES: Final = 4 * 2**30
_PIECE: Final = 1_000_000
"""Values asked for at once."""


def dataset(
    plan: Plan,
    arrays: Mapping[str, NDArray[Any]],
    counts: Mapping[str, int],
    reasons: tuple[Note, ...],
) -> xr.Dataset:
    """Return the result of a plan whose status and outputs are given over all its cases."""
    layout = Layout(plan, reasons)
    coords = {variable.name: _coordinate(variable, variable.values) for variable in layout.axes}
    if plan.sampler is not None:
        drawn = plan.sampler.draw(0, layout.sizes[SAMPLE])
        fields = {layout.names[name]: values for name, values in drawn.items()}
        coords.update({v.name: _coordinate(v, fields[v.name]) for v in layout.samples})
    shape = plan.study.shape
    variables = {
        variable.name: xr.Variable(
            variable.dims,
            arrays[variable.name].reshape(shape + arrays[variable.name].shape[1:]),
            dict(variable.attrs),
        )
        for variable in layout.outputs
    }
    return xr.Dataset(variables, coords, layout.attrs(counts))


def load_result(path: str | os.PathLike[str]) -> xr.Dataset:
    """Read a result that `run_to_file` wrote as NetCDF.

    Parameters
    ----------
    path
        A ``.nc`` file. Of a larger one than memory takes, `xarray.open_dataset` reads parts.

    Raises
    ------
    FileError
        If the file cannot be read, is damaged, is no NetCDF file of a study, takes more than 4 GB,
        or declares far more than it has.
    """
    source = os.fspath(path)
    if not Path(source).is_file():
        rule = said("cannot be opened: no such file")
        raise FileError(rule, source=source, example="result.nc")
    try:
        with Isolated(NetcdfVariables, Path(source), marked("NetCDF file")) as process:
            loaded = xr.decode_cf(_read(process, source)).load()
    except FileError:
        raise
    except Exception as error:  # whatever xarray makes of variables that do not go together
        reason = type(error).__name__
        raise FileError(
            said("is not a readable NetCDF file ({reason})", reason=reason), source=source
        ) from None
    if "status" not in loaded or "study" not in loaded.attrs:
        raise FileError(said("is not the result of a study"), source=source)
    return loaded


def _read(process: Isolated, source: str) -> xr.Dataset:
    """The variables of a NetCDF file, as they are stored."""
    attributes, described = process.ask("described")
    needed = sum(prod(found["shape"]) * found["dtype"].itemsize for found in described)
    check_declared(needed, os.path.getsize(source), source)
    if needed > _MOST_BYTES:
        raise FileError(
            said("has {needed:.1f} GB; xarray.open_dataset reads it in parts", needed=needed / 1e9),
            source=source,
        )
    variables = {
        found["name"]: xr.Variable(
            found["dims"], _values(process, found, source), found["attributes"]
        )
        for found in described
    }
    return xr.Dataset(variables, attrs=attributes)


def _values(process: Isolated, found: Mapping[str, Any], source: str) -> NDArray[Any]:
    """All of a variable, a piece at a time."""
    values = np.empty(prod(found["shape"]), found["dtype"])
    for first in range(0, len(values), _PIECE):
        last = min(first + _PIECE, len(values))
        for box, run in slabs(first, last, found["shape"] or (1,)):
            held = process.ask("values", found["name"], box if found["shape"] else ())
            piece = values[first + run.start : first + run.stop]
            if len(held) != len(piece):
                raise FileError(said("ends before its last value"), source=source)
            piece[:] = held
    return values.reshape(found["shape"])


def _coordinate(variable: Variable, values: NDArray[Any] | None) -> xr.Variable:
    assert values is not None
    held = values.astype(object) if values.dtype.kind == "U" else values
    return xr.Variable(variable.dims, np.asarray(held), dict(variable.attrs))
