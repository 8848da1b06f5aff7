"""Values that grow toward a limit, with the line through them and when it arrives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.charts import Axis, Chart, Line, Look, Mark, Spread, Zone, series_look
from rolamento.charts.texts import number
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.numerics.growth import Forecast

__all__ = ["growth_chart", "over_time"]

_CURVE: Final = 200
_FARTHEST: Final = 2.0
"""Spans of the measurements beyond the last one that are drawn at most."""


def growth_chart(
    times: Sequence[float],
    values: Sequence[float],
    found: Forecast,
    across: Axis,
    upright: Axis,
    zones: Sequence[Zone] = (),
) -> Chart:
    """Return measurements, the chosen law with its band, and the limit.

    Parameters
    ----------
    times, values
        Measured.
    found
        Of `rolamento.numerics.growth.forecast`.
    across, upright
        The axes; their limits are as the chart needs.
    zones
        Below all.
    """
    growth, crossing, look = found.growth, found.crossing, series_look(0)
    first, last = min(times), max(times)
    span = max(last - first, 1e-9 * max(abs(last), 1.0))
    reach = [last + 0.15 * span]
    reached = crossing.code == "reached"
    if reached:
        end = crossing.upper if isfinite(crossing.upper) else crossing.time
        reach += [min(1.05 * end - 0.05 * first, last + _FARTHEST * span)]
    grid = np.linspace(first, max(reach), _CURVE)
    series: list[Line | Spread] = []
    if isfinite(growth.p_value):
        law = said("exponential") if growth.law == "exponential" else said("linear")
        low, high = growth.band(grid, crossing.confidence)
        band = said("{confidence:.3 [%]} % band", confidence=crossing.confidence)
        series += [Spread(grid, low, high, band, look), Line(grid, growth.at(grid), law, look)]
    points = Look(look.color, width=0.75)
    series.append(Line(np.asarray(times), np.asarray(values), said("measured"), points, "points"))
    marks = [Mark(crossing.limit, said("limit"), Look("bad", "dash"))]
    conclusion = ""
    if reached and crossing.time <= grid[-1]:
        marks.append(Mark(crossing.time, "", Look("grey", width=0.65), "x"))
        ends = np.array([crossing.lower, min(crossing.upper, float(grid[-1]))])
        series.append(Line(ends, np.full(2, crossing.limit), said("time to the limit"),
                           Look("bad", width=3.0, opacity=0.5)))  # fmt: skip
        conclusion = f"{said('time to the limit')}: {across.with_unit(number(crossing.time))}"
    top = 1.25 * max(*values, crossing.limit)
    foot = 0.0 if min(values) >= 0.0 else min(values) - 0.05 * (top - min(values))
    return Chart(
        tuple(series),
        replace(across, limits=(first - 0.03 * span, float(grid[-1]))),
        replace(upright, limits=(foot, top)),
        conclusion,
        marks=tuple(marks),
        zones=tuple(zones),
    )


def over_time(start: str, unit: str = "h") -> Axis:
    """Return the axis of time: days from a date, or running time."""
    if start:
        return Axis(said("Days from {date}", date=start))
    return Axis(said("Running time"), unit)
