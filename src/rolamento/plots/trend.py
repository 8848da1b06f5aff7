"""What was measured again and again while bearings ran, over their running time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, series_look
from rolamento.charts.drawing import draw
from rolamento.charts.frame import panels
from rolamento.charts.texts import capitalised, no_result, shown_text
from rolamento.plots.growth import over_time
from rolamento.words import marked, said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.clearance.wear import WearFit
    from rolamento.numerics.growth import Forecast
    from rolamento.weibull import Trend

__all__ = ["trend_chart", "trend_figure"]

QUANTITIES: Final[Mapping[str, str]] = {"radial clearance": marked("radial clearance")}
"""What columns of a record are called, of which the name is known."""

_HEIGHT: Final = 90.0
_PANEL: Final = 55.0
_CURVE: Final = 300
_FARTHEST: Final = 2.0
"""Times the measured time beyond the last measurement that is drawn at most."""
_TOP: Final = 0.96
"""Height in the frame at which rejected measurements are marked."""


def trend_figure(
    trend: Trend,
    fits: Mapping[str, WearFit] | None = None,
    limits: Mapping[tuple[str, int], Forecast] | None = None,
    acceptance: Mapping[int, float] | None = None,
) -> Figure:
    """Draw every quantity of a record, one below the other, with its title.

    fits: laws of wear, as of `trend_chart`. limits: when limits are reached, by bearing and place
    of the quantity. acceptance: values up to which a quantity is accepted, by its place.
    """
    count = len(trend.quantities)

    def lines(quantity: int, axes: Axes) -> None:
        own = {name: one for (name, place), one in (limits or {}).items() if place == quantity}
        chart = trend_chart(trend, quantity, fits, own, (acceptance or {}).get(quantity))
        draw(chart, axes, legend=not quantity)

    height = _HEIGHT if count == 1 else 25.0 + _PANEL * count
    drawn = (partial(lines, quantity) for quantity in range(count))
    return panels(*drawn, title=trend.title, height=height)


def trend_chart(
    trend: Trend,
    quantity: int = 0,
    fits: Mapping[str, WearFit] | None = None,
    limits: Mapping[str, Forecast] | None = None,
    acceptance: float | None = None,
) -> Chart:
    """Return a quantity of every bearing over its running time.

    Parameters
    ----------
    trend
        Of `rolamento.weibull.trend`.
    quantity
        Which of its columns.
    fits
        Of `wear_of_each`: laws of wear, by the bearings; then the points are not joined.
    limits
        When a limit is reached, by the bearings; "" of the only one.
    acceptance
        Up to which it is accepted.

    Returns
    -------
    Chart
        Rejected measurements are crosses at the top of the frame.
    """
    times, values = trend.times, trend.values[:, quantity]
    if not np.isfinite(values).any():
        return nothing(no_result())
    series = [
        line
        for index, name in enumerate(trend.names)
        for line in _bearing(trend, quantity, index, name, (fits or {}).get(name))
    ]
    series += _rejected(trend, quantity)
    marks: dict[float, Mark] = {}
    if acceptance is not None:
        marks[acceptance] = Mark(acceptance, said("limit of acceptance"), Look("bad", "longdash"))
    right, span = 1.03 * float(times.max()), float(np.ptp(times))
    for index, name in enumerate(trend.names):
        found = (limits or {}).get(name, (limits or {}).get(""))
        if found is None or not np.isfinite(found.growth.p_value):
            continue
        limit, end = found.crossing.limit, float(times.max()) + 0.15 * span
        if found.crossing.code == "reached":
            end = max(end, min(1.05 * found.crossing.time, float(times.max()) + _FARTHEST * span))
        grid = np.linspace(found.growth.mean_time, end, _CURVE)
        look = Look(series_look(index).color, "dot", width=0.65)
        series.append(Line(grid, found.growth.at(grid), "", look))
        right = max(right, end)
        marks[limit] = Mark(limit, "" if marks else said("limit"), Look("bad", "dash", width=0.65))
    top = max(1.15 * float(np.nanmax(values)), *(1.1 * limit for limit in marks), 0.0)
    name, unit = trend.quantities[quantity], trend.units[quantity]
    known = capitalised(said(QUANTITIES[name]) if name in QUANTITIES else name)
    return Chart(
        tuple(series),
        replace(over_time(trend.start, trend.time_unit),
                limits=(min(0.0, float(times.min())), right)),
        Axis(limits=(0.0, top) if np.nanmin(values) >= 0.0 else None,
             name=known, unit=unit),
        marks=tuple(marks.values()),
    )  # fmt: skip


def _bearing(
    trend: Trend, quantity: int, index: int, name: str, fit: WearFit | None
) -> Iterator[Line]:
    """Yield what was measured, and the law of wear."""
    look, (times, values) = series_look(index), trend.of_bearing(name, quantity)
    called = shown_text(name, 24)
    label = said("bearing {name}", name=called) if name else said("measured")
    if fit is None:
        yield Line(times, values, label, look, "both")
    else:
        yield Line(times, values, label, replace(look, width=0.75), "points")
    if fit is None or not times.size:
        return
    from rolamento.units import to_si

    grid = np.linspace(0.0, float(times[-1]), _CURVE)
    second = to_si(f"1 {trend.time_unit}", "time")
    scale = to_si(f"1 {trend.units[quantity]}", "length")
    label = said("bearing {name}, fitted", name=called) if name else said("fitted")
    yield Line(grid, fit.clearance(second * grid) / scale, label, look)


def _rejected(trend: Trend, quantity: int) -> Iterator[Line]:
    """Yield what was rejected, in the colour of its bearing."""
    label = said("rejected")
    for index, name in enumerate(trend.names):
        rows = (trend.bearings == name) & trend.rejected[:, quantity]
        if rows.any():
            look = Look(series_look(index).color, mark="thin", width=1.2)
            yield Line(trend.times[rows], np.zeros(int(rows.sum())), label, look, "points",
                       height=_TOP)  # fmt: skip
            label = ""
