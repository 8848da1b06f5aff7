"""What every element bears: loads, contact angles, pressures over azimuth; the load rosette."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import DEGREE, MEGAPASCAL, ReadableUnit
from rolamento.charts.contacts import (
    QuantityName,
    Shown,
    azimuth_name,
    contact_quantity,
    free_angle,
    load_unit,
    race_name,
    race_word,
    rows_in_order,
)
from rolamento.charts.limits import rounded_up
from rolamento.charts.palette import SERIES, Look, race_look, series_look
from rolamento.charts.record import Axis, Chart, Line, Mark
from rolamento.charts.texts import number
from rolamento.contact.line import PRESSURE_LIMIT
from rolamento.geometry import Race
from rolamento.solved import RACES, Solved
from rolamento.solved.notes import pressure_limit
from rolamento.words import said

__all__ = [
    "contact_chart",
    "greatest",
    "limit_marks",
    "listed",
    "over_azimuth",
    "rosette_chart",
    "row_charts",
    "with_unit",
]

Floats = NDArray[np.float64]
Case = TypeVar("Case", bound=Shown)
Of = Callable[[Case, Race], Floats]
"""A number of the contacts with a race, SI, (elements,)."""

MOST_LINES: Final = len(SERIES)
_TURN: Final = 360.0
_MARGIN: Final = 8.0
_NEAR: Final = 0.5
"""Fraction of a limit: from there on it is drawn."""
_DIRECTIONS: Final = (112.5, 67.5, 157.5, 22.5, 202.5, 247.5, 292.5, 337.5)
"""Azimuths for the numbers of circles, on the right first: there the page writes them upright."""
_LITTLE: Final = 0.3
"""Fraction of the greatest circle."""


def contact_chart(
    cases: Sequence[Shown], column: QuantityName, *, most: int | None = None
) -> Chart:
    """Return a number of the contacts over the azimuth of the elements, for each race and row.

    Parameters
    ----------
    cases
        Single cases with a result, at least one.
    column
        ``"load"``, ``"contact_angle"``, beside the free angle, or ``"max_pressure"``, beside its
        limit where it comes near.
    most
        Lines that there is room for: where there were more, the inner race alone, and of it the
        most loaded rows; by default all are drawn.
    """
    quantity = contact_quantity(column)
    unit = quantity.unit or load_unit([one.solved for one in cases])
    marks: list[Mark] = []
    if column == "contact_angle":
        marks = _free_angles(cases)
    elif column == "max_pressure":
        most_of_all = greatest(quantity.of(one.solved, race) for one in cases for race in RACES)
        marks = limit_marks((one.solved for one in cases), most_of_all)
    return over_azimuth(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, unit,
        zero=quantity.from_zero, marks=marks, most=most,
    )  # fmt: skip


def _free_angles(cases: Iterable[Shown]) -> list[Mark]:
    found = ((one, free_angle(one.solved)) for one in cases)
    return [
        Mark(
            float(DEGREE.of(angle)),
            one.named(said("free (unloaded)")),
            Look("grey", "dot" if one.place else "longdash", width=0.75),
        )
        for one, angle in found
        if angle is not None
    ]


def limit_marks(solved: Iterable[Solved], largest: float) -> list[Mark]:
    """Return the limits of pressure (Pa) that the largest comes near."""
    limits = set()
    for one in solved:
        rollers = one.are_rollers
        limits |= {PRESSURE_LIMIT} if rollers.any() else set()
        limits |= set() if rollers.all() else {pressure_limit(one.case)}
    return [
        Mark(float(MEGAPASCAL.of(limit)), said("limit {limit:.4 MPa}", limit=limit),
             Look("bad", "longdash", width=0.75))
        for limit in sorted(limits)
        if largest > _NEAR * limit
    ]  # fmt: skip


def over_azimuth(
    cases: Sequence[Case],
    of: Of[Case],
    name: str,
    unit: ReadableUnit,
    *,
    zero: bool = False,
    least: bool = False,
    marks: Sequence[Mark] = (),
    most: int | None = None,
) -> Chart:
    """Return a number of every contact over azimuth.

    Parameters
    ----------
    cases, most
        As of `contact_chart`.
    of
        The number, of a case and a race, SI, (elements,).
    name, unit
        What it is called, and in what it is read.
    zero
        Whether its axis begins at zero.
    least
        Whether the least of them matters most.
    marks
        Lines beside it.
    """
    races, rows = _chosen(cases, of, most)
    series: list[Line] = []
    for one in cases:
        by_row = rows_in_order(one.solved)
        for row in rows[one.place]:
            azimuth = np.mod(DEGREE.of(one.solved.elements.azimuth[0, by_row[row]]), _TURN)
            for race in races:
                look = _look(race, one, row, cases, len(series))
                values = unit.of(of(one, race)[by_row[row]])
                series.append(
                    Line(*_all_round(azimuth, values), one.named(race_name(race, row, len(by_row))),
                         look, "both", (1, 1))
                )  # fmt: skip
    elements = [own for one in cases for own in one.solved.rows.element]
    return Chart(
        tuple(series),
        Axis(azimuth_name(elements), DEGREE.symbol, (-_MARGIN, _TURN + _MARGIN), step=45.0),
        Axis(name, unit.symbol, zero=zero, least=1.0 if unit is DEGREE else 0.0),
        _extremes(cases, of, name, unit, least=least),
        marks=tuple(marks),
    )


def _look(race: Race, one: Shown, row: int, cases: Sequence[Shown], index: int) -> Look:
    """Return the look of a line: by race and row for up to two cases, else by its place."""
    return race_look(race, one.place, row) if len(cases) <= 2 else series_look(index)


def _chosen(
    cases: Sequence[Case], of: Of[Case], most: int | None
) -> tuple[Sequence[Race], Mapping[int, Sequence[int]]]:
    """Return races and rows to draw, most loaded row first."""
    rows = {one.place: list(range(len(one.solved.rows))) for one in cases}
    count = sum(map(len, rows.values()))
    races: Sequence[Race] = RACES if most is None or count * len(RACES) <= most else ("inner",)
    if most is None or count * len(races) <= most:
        return races, rows
    for one in cases:
        values, own = of(one, "inner"), one.solved.elements.row
        order = sorted(rows[one.place], key=lambda row: -greatest([values[own == row]]))
        rows[one.place] = sorted(order[: most // len(cases)])
    return races, rows


def greatest(arrays: Iterable[Floats]) -> float:
    """Return the greatest number; NaN where there is none."""
    found = np.concatenate([np.ravel(one) for one in arrays])
    found = found[np.isfinite(found)]
    return float(found.max()) if found.size else float("nan")


def _extremes(
    cases: Sequence[Case], of: Of[Case], name: str, unit: ReadableUnit, *, least: bool = False
) -> str:
    """Say which contact of each race has the greatest value, or the least, and where it is."""
    facts = []
    for one in cases:
        for race in RACES:
            values = of(one, race)
            if np.isfinite(values).any():
                place = int(np.nanargmin(values) if least else np.nanargmax(values))
                facts.append(
                    said(
                        "{name} {value} at {azimuth:.4 °}",
                        name=one.named(race_word(race)),
                        value=with_unit(float(unit.of(values[place])), unit),
                        azimuth=float(np.mod(one.solved.elements.azimuth[0, place], 2.0 * np.pi)),
                    )
                )
    return listed(name, facts, least=least)


def listed(name: str, facts: Sequence[str], *, least: bool = False) -> str:
    """Say the greatest values of a quantity, or the least."""
    if least:
        return said("{name}, least: {values}.", name=name, values="; ".join(facts))
    return said("{name}, greatest: {values}.", name=name, values="; ".join(facts))


def with_unit(value: float, unit: ReadableUnit) -> str:
    """Write a number with its unit."""
    return Axis(unit=unit.symbol).with_unit(number(value))


def _all_round(azimuth: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Put elements in order; the last one before the first, the first one after the last."""
    order = np.argsort(azimuth, kind="stable")
    around, own = azimuth[order], values[order]
    ends = around[-1] - _TURN, around[0] + _TURN
    return np.r_[ends[0], around, ends[1]], np.r_[own[-1], own, own[0]]


def rosette_chart(
    cases: Sequence[Shown], *, unit: ReadableUnit | None = None, most: int | None = None
) -> Chart:
    """Return the contact loads around the bearing; parameters as of `contact_chart`.

    unit: in which loads are read; by default one that suits them.
    """
    quantity, unit = contact_quantity("load"), unit or load_unit([one.solved for one in cases])

    def load(one: Shown, race: Race) -> Floats:
        return quantity.of(one.solved, race)

    races, rows = _chosen(cases, load, most)
    series: list[Line] = []
    for one in cases:
        by_row = rows_in_order(one.solved)
        for row in rows[one.place]:
            around = np.append(by_row[row], by_row[row][0])
            azimuth = DEGREE.of(one.solved.elements.azimuth[0, around])
            for race in races:
                name = one.named(race_name(race, row, len(by_row)))
                look = _look(race, one, row, cases, len(series))
                values = unit.of(load(one, race)[around])
                series.append(Line(azimuth, values, name, look, "both", (0, 1)))
    ring = said("Contact load ({unit}), seen from +x", unit=unit.symbol)
    return Chart(
        tuple(series),
        Axis(azimuth_name(own for one in cases for own in one.solved.rows.element), DEGREE.symbol),
        Axis(quantity.name, unit.symbol, zero=True, label=ring),
        _extremes(cases, load, ring, unit),
        polar=True,
        numbers_at=_emptiest(series),
    )


def _emptiest(series: Sequence[Line]) -> float:
    """Return the azimuth (°) for the numbers of the circles: where little is borne."""
    rim = rounded_up(greatest(line.y for line in series))
    borne = {}
    for direction in _DIRECTIONS:
        loads = [
            line.y[np.abs((line.x - direction + 180.0) % _TURN - 180.0) < 45.0] for line in series
        ]
        borne[direction] = float(np.max(np.concatenate(loads), initial=0.0))
        if borne[direction] < _LITTLE * rim:
            break  # as before, while a slider moves
    return min(borne, key=lambda direction: borne[direction])


def row_charts(cases: Sequence[Shown], most: int) -> list[Chart]:
    """Return the loads of the first rows, most of them, a chart each."""
    quantity, unit = contact_quantity("load"), load_unit([one.solved for one in cases])
    count = min(max(len(one.solved.rows) for one in cases), most)
    every = 90.0 if count <= 3 else 180.0
    ticks = tuple((angle, number(angle)) for angle in np.arange(0.0, _TURN, every).tolist())
    charts = []
    for row in range(count):
        series: list[Line] = []

        def load(one: Shown, race: Race, row: int = row) -> Floats:
            own = one.solved.elements.row == row
            return np.where(own, quantity.of(one.solved, race), np.nan)

        for one in cases:
            by_row = rows_in_order(one.solved)
            if row >= len(by_row):
                continue
            azimuth = np.mod(DEGREE.of(one.solved.elements.azimuth[0, by_row[row]]), _TURN)
            for race in RACES:
                values = unit.of(quantity.of(one.solved, race)[by_row[row]])
                name = one.named(race_name(race, row, count))
                look = race_look(race, one.place, row)
                series.append(Line(*_all_round(azimuth, values), name, look, "both", (1, 1)))
        name = said("row {number}", number=row)
        across = Axis(name, DEGREE.symbol, (0.0, _TURN), ticks=ticks, label=name)
        charts.append(
            Chart(tuple(series), across, Axis(quantity.name, unit.symbol, zero=True),
                  _extremes(cases, load, f"{name}, {quantity.name}", unit))
        )  # fmt: skip
    extremes = _extremes(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, unit
    )
    return [replace(charts[0], conclusion=extremes), *charts[1:]]
