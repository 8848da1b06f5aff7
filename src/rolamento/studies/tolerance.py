"""Tolerance bands: within what limits every output of a scatter study stays, and how surely.

Percentiles, mean and standard deviation over the samples that have a result; how many have none
stands beside them. The confidence interval of a percentile is that of order statistics, which
supposes no distribution: Conover, Practical Nonparametric Statistics, 3rd ed. (1999), section 3.2.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case.bearing import Bearing
from rolamento.clearance.effects import EXPANSION_100CR6, clearance_change_of_rings
from rolamento.errors import InputError
from rolamento.numerics.percentiles import percentile_of_sorted
from rolamento.records import frozen
from rolamento.studies.study import SAMPLE
from rolamento.validate import share
from rolamento.words import said

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

Floats = NDArray[np.float64]

FLAT: Final = 1e-10
"""Fraction of the greatest output in the same unit: what varies less is rounding."""

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


@frozen(eq=False)
class Input:
    """A scattered input: its name, its field of the case, words, unit, and draws (samples,)."""

    name: str
    field: str
    long_name: str
    units: str
    values: Floats


@frozen(eq=False)
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

    def values(self, name: str) -> Floats:
        """Return an output, NaN where there is no result; the samples are its last axis."""
        there = self.outputs[name].where(self.solved).transpose(..., SAMPLE)
        return np.asarray(there.values, dtype=np.float64)

    def axes_of(self, name: str) -> tuple[str, ...]:
        """Return the names of an output's axes but the samples."""
        return tuple(str(axis) for axis in self.outputs[name].dims[:-1])


def samples_of(dataset: Dataset) -> Samples:
    """Take the scatter out of a study's result.

    Raises
    ------
    InputError
        If the study has no scatter, or no output.
    """
    if SAMPLE not in dataset.sizes or "status" not in dataset:
        raise InputError(
            said("has no scatter: its result has no samples"),
            field="scatter",
            example='[scatter] count = 1000, [scatter.fields."duty.load.fx"]',
        )
    status = dataset["status"]
    outputs = {
        str(name): array.transpose(..., SAMPLE)
        for name, array in dataset.data_vars.items()
        if name not in ("status", "reason") and SAMPLE in array.dims and array.dtype.kind in "fiu"
    }
    if not outputs:
        raise InputError(said("has no output over the samples"), field="outputs")
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


PERCENTILES: Final = (0.135, 5.0, 50.0, 95.0, 99.865)
"""The outer ones are those of three standard deviations of a normal distribution."""

_BINS: Final = (8, 50)
_MOST_PERCENTILES: Final = 50
_LARGEST_DIFFERENCE: Final = 200.0  # K


@frozen(eq=False)
class ToleranceBand:
    """One output over the samples, SI; NaN where there are too few of them.

    Attributes
    ----------
    name, long_name, units
        of the output
    axes
        dimensions that remain: those of the arrays below
    percentile
        (percentiles, …) below which that percentage of the samples lies; NaN where it lies
        beyond the least or the greatest sample, so that more samples are needed
    low, high
        (percentiles, …) confidence interval of each; NaN where it is open on that side
    mean, standard_deviation
        (…) of the samples, the latter with n - 1
    count
        (…) samples that have a result and a value
    """

    name: str
    long_name: str
    units: str
    axes: tuple[str, ...]
    percentile: Floats
    low: Floats
    high: Floats
    mean: Floats
    standard_deviation: Floats
    count: NDArray[np.int64]


@frozen(eq=False)
class ToleranceBands:
    """All outputs of a scatter study.

    Attributes
    ----------
    percentiles
        in per cent
    confidence
        of the intervals, 0 to 1
    samples
        of the study
    without_result
        (axes …) samples that have no result: not part of any band
    failures
        their number by reason, over all axes
    bands
        one for each output
    """

    percentiles: tuple[float, ...]
    confidence: float
    samples: int
    without_result: NDArray[np.int64]
    failures: Mapping[str, int]
    bands: tuple[ToleranceBand, ...]

    def __getitem__(self, name: str) -> ToleranceBand:
        """Return the band of an output."""
        for band in self.bands:
            if band.name == name:
                return band
        raise KeyError(name)

    @property
    def share_without_result(self) -> float:
        """Part of all samples, over all axes, that have no result."""
        return float(np.mean(self.without_result)) / self.samples


def varies(values: Floats, units: str) -> bool:
    """Whether finite values of a unit, one or more, differ by more than rounding."""
    rounding = max(FLAT * float(np.abs(values).max()), FINEST.get(units, 0.0))
    return float(np.ptp(values)) > rounding


def histogram(values: Floats) -> tuple[Floats, Floats]:
    """Return the shares of finite values, 0 to 1, and the edges that they lie between.

    Twice the cube root of their number are the bins, by the rule of Rice: 8 to 50.
    """
    bins = int(np.clip(np.ceil(2.0 * values.size ** (1.0 / 3.0)), *_BINS))
    counts, edges = np.histogram(values, bins)
    return counts / values.size, edges


def tolerance_bands(
    dataset: Dataset,
    percentiles: Sequence[float] = PERCENTILES,
    *,
    confidence: float = 0.95,
) -> ToleranceBands:
    """Take percentiles of every output of a scatter study over its samples.

    Parameters
    ----------
    dataset
        A study's result with the dimension ``"sample"``; further dimensions remain.
    percentiles
        In per cent, between 0 and 100.
    confidence
        Of the intervals, above 0 and below 1.

    Raises
    ------
    InputError
        If the result has no scatter, or a percentile is out of range.

    The percentile is that of `rolamento.numerics.percentiles`, as on figures.
    """
    wanted = checked_percentiles(percentiles)
    share(confidence, "confidence", "0.95")
    samples = samples_of(dataset)
    return ToleranceBands(
        percentiles=wanted,
        confidence=confidence,
        samples=len(samples),
        without_result=np.asarray((~samples.solved).sum(SAMPLE).values, dtype=np.int64),
        failures=samples.failures,
        bands=tuple(_band(name, samples, wanted, confidence) for name in samples.outputs),
    )


def checked_percentiles(percentiles: Sequence[float]) -> tuple[float, ...]:
    """Return percentiles in rising order, each once.

    Raises
    ------
    InputError
        If there is none, there are more than 50, or one is not between 0 and 100.
    """
    wanted = tuple(sorted({float(value) for value in percentiles}))
    if not 1 <= len(wanted) <= _MOST_PERCENTILES:
        raise InputError(
            said("must be 1 to {most} numbers", most=_MOST_PERCENTILES),
            field="percentiles",
            value=len(wanted),
        )
    for value in wanted:
        if not 0.0 < value < 100.0:
            raise InputError(
                said("must be between 0 and 100"),
                field="percentiles",
                value=value,
                example="5, 50, 95",
            )
    return wanted


def _band(
    name: str, samples: Samples, percentiles: tuple[float, ...], confidence: float
) -> ToleranceBand:
    values = samples.values(name)
    shape = values.shape[:-1]
    quantiles = np.full((3, len(percentiles), *shape), np.nan)
    moments = np.full((2, *shape), np.nan)
    count = np.zeros(shape, dtype=np.int64)
    for place in np.ndindex(shape):
        there = np.sort(values[place][np.isfinite(values[place])])
        count[place] = len(there)
        moments[(slice(None), *place)] = _moments(there)
        for index, percent in enumerate(percentiles):
            quantiles[(slice(None), index, *place)] = _quantile(there, percent, confidence)
    attributes = samples.outputs[name].attrs
    return ToleranceBand(
        name=name,
        long_name=str(attributes.get("long_name", name)),
        units=str(attributes.get("units", "")),
        axes=samples.axes_of(name),
        percentile=quantiles[0],
        low=quantiles[1],
        high=quantiles[2],
        mean=moments[0],
        standard_deviation=moments[1],
        count=count,
    )


def _moments(values: Floats) -> tuple[float, float]:
    """Mean and standard deviation, as far as so many values have them."""
    if len(values) == 0:
        return np.nan, np.nan
    return float(values.mean()), float(values.std(ddof=1)) if len(values) > 1 else np.nan


def _quantile(ordered: Floats, percent: float, confidence: float) -> tuple[float, float, float]:
    """Percentile of sorted values, and the ends of its interval."""
    count, share = len(ordered), percent / 100.0
    low, high = _order_statistics(count, share, confidence)
    return (
        percentile_of_sorted(ordered, percent),
        float(ordered[low]) if low >= 0 else np.nan,
        float(ordered[high]) if high < count else np.nan,
    )


@lru_cache(maxsize=4096)
def _order_statistics(count: int, share: float, confidence: float) -> tuple[int, int]:
    """Places of the order statistics that enclose a quantile; -1 and count where none does."""
    from scipy.stats import binom

    if count == 0:
        return -1, 0
    tail = 0.5 * (1.0 - confidence)
    low, high = binom.ppf(tail, count, share), binom.isf(tail, count, share)
    return int(low) - 1, int(high)


# --- clearance and temperature ----------------------------------------------------------------


def clearance_from_temperature(
    bearing: Bearing,
    temperature_difference: ArrayLike,
    *,
    expansion: float = EXPANSION_100CR6,
) -> Floats:
    """Diametral clearance when the inner ring is warmer than the outer.

    The inner ring and the balls grow beyond the outer ring by the expansion of the outer
    raceway's diameter d_m + D over the difference of temperature:

        P_d = P_d,0 - expansion · ΔT · (d_m + D)

    Parameters
    ----------
    bearing
        Given by its diametral clearance at one temperature.
    temperature_difference
        ΔT, inner ring less outer; K, at most 200 either way. A number or an array of draws.
    expansion
        Coefficient of thermal expansion of rings and balls; 1/K.

    Returns
    -------
    Diametral clearance of that shape; m.

    Raises
    ------
    InputError
        If the bearing is given by its contact angle, or a difference is out of range.

    Linear: a mean difference shifts the mean clearance, and a standard deviation s of the
    difference adds one of expansion · s · (d_m + D). Valid for rings that are each of one
    temperature and grow freely, balls as warm as the inner ring, and one material; a fit that
    hinders the growth, or ceramic balls, changes it. Source: NSK, Rolling Bearings (catalogue
    E1102), which takes (4 D_bearing + d_bore)/5 for the outer raceway's diameter.
    """
    if bearing.diametral_clearance is None:
        raise InputError(
            said("is needed: a bearing given by its contact angle has no clearance to change"),
            field="bearing.diametral_clearance",
            example='diametral_clearance = "0.015 mm" instead of contact_angle',
        )
    difference = np.asarray(temperature_difference, dtype=np.float64)
    if not np.all(np.abs(difference) <= _LARGEST_DIFFERENCE):
        raise InputError(
            said(
                "must be between −{most:.6g} K and {most:.6g} K",
                most=_LARGEST_DIFFERENCE,
            ),
            field="temperature_difference",
            value=_worst(difference),
            example="10.0",
        )
    raceway = bearing.pitch_diameter + bearing.ball_diameter
    change = clearance_change_of_rings(raceway, difference, expansion)
    return np.asarray(bearing.diametral_clearance + change)


def _worst(values: Floats) -> Any:
    flat = np.atleast_1d(values).ravel()
    return float(flat[int(np.argmax(np.where(np.isnan(flat), np.inf, np.abs(flat))))])
