"""A scatter study's result, taken apart: what was drawn, what came out, what has no result."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

__all__ = ["FINEST", "FLAT", "SAMPLE", "Input", "Samples", "samples_of"]

Floats = NDArray[np.float64]

SAMPLE: Final = "sample"

FLAT: Final = 1e-10
"""Of the greatest output in the same unit: what varies less is rounding."""

FINEST: Final[Mapping[str, float]] = {
    "m": 1e-13,
    "rad": 1e-12,
    "N": 1e-6,
    "N*m": 1e-8,
    "Pa": 1.0,
    "N/m": 10.0,
    "N/rad": 1.0,
    "N*m/rad": 0.01,
}
"""By SI unit, what is rounding on any bearing: a load that balances to zero varies less."""


@dataclass(frozen=True, slots=True, eq=False)
class Input:
    """A scattered input: its name, its field of the case, words, unit, and draws (samples,)."""

    name: str
    field: str
    long_name: str
    units: str
    values: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """A scatter study in arrays.

    Attributes
    ----------
    inputs
        the scattered fields
    outputs
        by name; the last dimension is the sample
    solved
        whether a sample has a result: over the axes of the study, then the samples
    axes
        names of the study's axes
    coordinates
        of the axes, by name, where they have any
    failures
        samples without a result by the reason, over all axes
    """

    inputs: tuple[Input, ...]
    outputs: Mapping[str, DataArray]
    solved: DataArray
    axes: tuple[str, ...]
    coordinates: Mapping[str, DataArray]
    failures: Mapping[str, int]

    def __len__(self) -> int:
        """Count the samples."""
        return int(self.solved.sizes[SAMPLE])


def samples_of(dataset: Dataset) -> Samples:
    """Take the scatter out of a study's result.

    Raises
    ------
    InputError
        If the study has no scatter, or no output.
    """
    if SAMPLE not in dataset.sizes or "status" not in dataset:
        raise InputError(
            "has no scatter: its result has no samples",
            field="scatter",
            example='[scatter] with count = 1000 and [scatter.fields."duty.load.fx"]',
        )
    status = dataset["status"]
    outputs = {
        str(name): array.transpose(..., SAMPLE)
        for name, array in dataset.data_vars.items()
        if name != "status" and SAMPLE in array.dims and array.dtype.kind in "fiu"
    }
    if not outputs:
        raise InputError("has no output over the samples", field="outputs")
    status = status.transpose(..., SAMPLE)
    axes = tuple(str(name) for name in status.dims if name != SAMPLE)
    return Samples(
        inputs=tuple(_inputs(dataset)),
        outputs=outputs,
        solved=status == 0,
        axes=axes,
        coordinates={name: dataset.coords[name] for name in axes if name in dataset.coords},
        failures=_failures(status),
    )


def _inputs(dataset: Dataset) -> Iterator[Input]:
    for name, array in dataset.coords.items():
        if array.dims == (SAMPLE,) and name != SAMPLE and array.dtype.kind in "fiu":
            attributes = array.attrs
            yield Input(
                name=str(name),
                field=str(attributes.get("field", name)),
                long_name=str(attributes.get("long_name", name)),
                units=str(attributes.get("units", "")),
                values=np.asarray(array.values, dtype=np.float64),
            )


def _failures(status: DataArray) -> dict[str, int]:
    """Count the samples without a result by reason, by the file's own flags."""
    codes, counts = np.unique(np.asarray(status.values), return_counts=True)
    values = np.atleast_1d(np.asarray(status.attrs.get("flag_values", ()))).tolist()
    meanings = str(status.attrs.get("flag_meanings", "")).split()
    names = dict(zip(values, meanings, strict=False)) or dict(enumerate(meanings))
    found = zip(codes.tolist(), counts.tolist(), strict=True)
    return {names.get(code, f"status {code}"): count for code, count in found if code != 0}
