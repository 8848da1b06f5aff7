"""How the noise of a bearing changes over a test, and the records of Campanha (2008)."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf, isfinite, isnan, nan
from typing import Any, Final

import numpy as np

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics.growth import growth_rate
from rolamento.records import frozen
from rolamento.vibration.anderon import BANDS, BandName
from rolamento.words import said

_LETTERS: Final[dict[str, BandName]] = {"L": "low", "M": "medium", "H": "high"}
_REJECTED: Final = "x"


@frozen
class AnderonRecord:
    """One measurement of a bearing during a test.

    Attributes
    ----------
    bearing
        its number
    hours
        of the test
    anderons
        by band; inf if the bearing was rejected there without a value, NaN if not measured
    """

    bearing: int
    hours: float
    anderons: dict[BandName, float]


@frozen
class BandTrend:
    """How the noise in one band changes.

    Attributes
    ----------
    name
        low, medium or high
    hours, anderons
        of the measurements with a value
    growth
        of the values, per hour: slope of their logarithm by least squares; NaN for fewer than two
        different times
    ratio
        last value over the first; NaN without two
    rejected_after
        hours of the last measurement before the first rejection; NaN if never rejected, 0 if none
        was before
    rejected_by
        hours of the first measurement at which it was rejected; NaN if never
    """

    name: BandName
    hours: tuple[float, ...]
    anderons: tuple[float, ...]
    growth: float
    ratio: float
    rejected_after: float
    rejected_by: float


@frozen
class AnderonTrend:
    """How the noise of one bearing changes over a test, by band."""

    bearing: int
    bands: tuple[BandTrend, ...]

    def of(self, name: BandName) -> BandTrend:
        """Return one band."""
        return next(band for band in self.bands if band.name == name)


def trend_of(
    records: Iterable[AnderonRecord], limits: dict[BandName, float] | None = None
) -> tuple[AnderonTrend, ...]:
    """How the noise of each bearing changes over its test.

    Parameters
    ----------
    records
        Of any bearings, in any order.
    limits
        Anderons by band above which a bearing is rejected; by default only what a record marks.

    Raises
    ------
    InputError
        If hours or a value are negative or not numbers, or a limit is not positive.
    """
    by_bearing: dict[int, list[AnderonRecord]] = {}
    for record in records:
        _check_record(record)
        by_bearing.setdefault(record.bearing, []).append(record)
    for name, limit in (limits or {}).items():
        if name not in BANDS or not limit > 0.0:
            raise InputError(said("must be positive, by band"), field=f"limits.{name}", value=limit)
    return tuple(
        AnderonTrend(
            bearing,
            tuple(
                _band_trend(
                    name, sorted(found, key=lambda r: r.hours), (limits or {}).get(name, inf)
                )
                for name in BANDS
            ),
        )
        for bearing, found in by_bearing.items()
    )


def campanha_records() -> tuple[AnderonRecord, ...]:
    """Return the records of Campanha (2008), table 4.1.4: bearings 9 and 10, test 5."""
    return tuple(
        AnderonRecord(
            bearing=row["bearing"],
            hours=float(row["hours"]),
            anderons={
                name: inf if row[letter] == _REJECTED else float(row[letter])
                for letter, name in _LETTERS.items()
            },
        )
        for row in _campanha_rows("trend")
    )


def _check_record(record: AnderonRecord) -> None:
    if not isfinite(record.hours) or record.hours < 0.0:
        raise InputError(
            said("must be a number of hours, not negative"),
            field="hours",
            value=record.hours,
            example="60.0",
        )
    for name, value in record.anderons.items():
        if name not in BANDS or value < 0.0:
            raise InputError(
                said("must be a non-negative number, in one of {bands}", bands=", ".join(BANDS)),
                field=f"anderons.{name}",
                value=value,
            )


def _band_trend(name: BandName, records: list[AnderonRecord], limit: float) -> BandTrend:
    times = [(record.hours, record.anderons.get(name, nan)) for record in records]
    measured = [(hours, value) for hours, value in times if not isnan(value)]
    values = [(hours, value) for hours, value in measured if isfinite(value) and value > 0.0]
    wrong = [place for place, (_, value) in enumerate(measured) if value > limit or value == inf]
    rejected_by = measured[wrong[0]][0] if wrong else nan
    before = (measured[wrong[0] - 1][0] if wrong[0] > 0 else 0.0) if wrong else nan
    return BandTrend(
        name=name,
        hours=tuple(hours for hours, _ in values),
        anderons=tuple(value for _, value in values),
        growth=growth_rate(*np.array(values).reshape(-1, 2).T),
        ratio=values[-1][1] / values[0][1] if len(values) > 1 else nan,
        rejected_after=before,
        rejected_by=rejected_by,
    )


def _campanha_data() -> dict[str, Any]:
    return toml_of("campanha_2008_anderon", "rolamento.vibration")


def _campanha_rows(name: str) -> list[dict[str, Any]]:
    table = _campanha_data()[name]
    return [dict(zip(table["columns"], row, strict=True)) for row in table["rows"]]
