"""The columns of a life test, checked and of one length."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray

TextArray = NDArray[np.str_]
IntArray = NDArray[np.int64]

MOST_ROWS: Final = 100_000
MOST_UNITS: Final = 1_000_000
LONGEST_LABEL: Final = 60
LEAST_TIME: Final = 1e-30
MOST_TIME: Final = 1e30


def numbers(values: ArrayLike, field: str, rows: int | None = None) -> FloatArray:
    """Return an array of its own, of the wanted length."""
    try:
        array = np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("must be numbers", field=field, example="[120.5, 88.0, 300.0]") from None
    if rows is None:
        _check_rows(array, field)
        return array
    return _spread(array, field, rows)


def flags(values: ArrayLike, rows: int) -> BoolArray:
    """Return true or false, one a row."""
    array = _array(values, "failed")
    if array.dtype != np.bool_ and not (
        array.dtype.kind in "iuf" and np.all((array == 0) | (array == 1))
    ):
        raise InputError(
            "must be true or false, one a row", field="failed", example="[True, False, True]"
        )
    return _spread(array.astype(np.bool_), "failed", rows)


def counts(values: ArrayLike, rows: int, field: str = "counts") -> IntArray:
    """Return whole numbers above zero, one a row."""
    try:
        array = np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.array(np.nan)
    bad = ~((array >= 1.0) & (array <= MOST_UNITS) & (array == np.floor(array)))
    if np.any(bad):
        raise InputError(
            f"must be whole numbers from 1 to {MOST_UNITS}",
            field=field,
            value=float(array[bad].flat[0]),
            example="[1, 1, 4]",
        )
    counts = _spread(array, field, rows).astype(np.int64)
    if counts.sum() > MOST_UNITS:
        raise InputError(f"must be {MOST_UNITS} bearings at most, all together", field=field)
    return counts


def labels(values: ArrayLike, field: str, rows: int) -> TextArray:
    """Return short texts, one a row."""
    array = _array(values, field)
    if array.size == 0:
        array = np.array([], dtype=np.str_)
    texts = np.array([label(v, field) for v in array.ravel().tolist()], dtype=np.str_)
    return _spread(texts.reshape(array.shape), field, rows)


def label(value: object, field: str) -> str:
    """Return a short text."""
    text = str(value).strip()
    if len(text) > LONGEST_LABEL or not text.isprintable():
        raise InputError(
            f"must be one line of {LONGEST_LABEL} characters at most", field=field, value=text
        )
    return text


def _array(values: ArrayLike, field: str) -> NDArray[Any]:
    try:
        return np.array(values)
    except ValueError:  # lists in lists of several lengths
        raise InputError("must be a list, one entry a row", field=field) from None


def _check_rows(array: NDArray[Any], field: str) -> None:
    if array.ndim != 1 or not 1 <= len(array) <= MOST_ROWS:
        raise InputError(
            f"must be a list of 1 to {MOST_ROWS} numbers",
            field=field,
            example="[120.5, 88.0, 300.0]",
        )


def _spread(array: NDArray[Any], field: str, rows: int) -> NDArray[Any]:
    """Give one value to all rows, or check that there is one for each."""
    if array.ndim == 0:
        return np.full(rows, array[()])
    if array.shape != (rows,):
        raise InputError(
            f"must be as long as the times, which are {rows}", field=field, value=array.shape
        )
    return array


def check_times(times: FloatArray, failed: BoolArray, lower: FloatArray) -> None:
    """Refuse times that cannot be, and inspections that do not precede their failure."""
    bad = ~((times >= LEAST_TIME) & (times <= MOST_TIME))
    if np.any(bad):
        raise InputError(
            "must be finite numbers above zero; leave out a bearing that never ran",
            field="times",
            value=float(times[bad][0]),
            example="[120.5, 88.0, 300.0]",
        )
    given = ~np.isnan(lower)
    bad = given & ~((lower >= 0.0) & (lower < times) & failed)
    if np.any(bad):
        raise InputError(
            "must lie below the time of its row, and only a failed bearing has one",
            field="lower",
            value=float(lower[bad][0]),
            example="lower = [100.0], times = [150.0]",
        )


def check_rigs(
    times: FloatArray, failed: BoolArray, lower: FloatArray, counts: IntArray, rig: TextArray
) -> None:
    """Refuse a rig that does not end as one, at its first failure."""
    labelled = rig != ""
    if not np.any(labelled):
        return
    names, which = np.unique(rig[labelled], return_inverse=True)
    ends = times[labelled]
    first, last = np.full(len(names), np.inf), np.zeros(len(names))
    np.minimum.at(first, which, ends)
    np.maximum.at(last, which, ends)
    failures = np.bincount(which, weights=(counts * failed)[labelled])
    inspected = np.bincount(which, weights=~np.isnan(lower[labelled]))
    for wrong, what in (
        (first < last, "ends at several times"),
        (failures > 1.0, "has several failures"),
        (inspected > 0.0, "has a failure found at an inspection"),
    ):
        if np.any(wrong):
            raise InputError(
                f"{what}, and a rig ends as one, at its first failure; leave the rig out where its"
                " bearings ran on",
                field="rig",
                value=str(names[wrong][0]),
            )
