"""What was measured again and again while bearings ran, over their running time."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.frame import empty_frame, label_x, label_y, legend_above, panels
from rolamento.charts.style import new_figure, series, styled
from rolamento.charts.texts import capitalised, no_result, shown_text
from rolamento.words import marked, said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.clearance.wear import WearFit
    from rolamento.numerics.growth import Forecast
    from rolamento.weibull import Trend

__all__ = ["trend_figure", "trend_lines"]

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
) -> Figure:
    """Draw every quantity of a record, one below the other, with its title.

    fits: laws of wear, as of `trend_lines`. limits: when limits are reached, by bearing and place
    of the quantity.
    """
    count = len(trend.quantities)

    def lines(quantity: int, axes: Axes) -> None:
        own = {name: one for (name, place), one in (limits or {}).items() if place == quantity}
        trend_lines(trend, quantity, axes, fits=fits, limits=own, legend=not quantity)

    height = _HEIGHT if count == 1 else 25.0 + _PANEL * count
    drawn = (partial(lines, quantity) for quantity in range(count))
    return panels(*drawn, title=trend.title, height=height)


def trend_lines(
    trend: Trend,
    quantity: int = 0,
    axes: Axes | None = None,
    *,
    fits: Mapping[str, WearFit] | None = None,
    limits: Mapping[str, Forecast] | None = None,
    legend: bool = True,
) -> Axes:
    """Draw a quantity of every bearing over its running time.

    Parameters
    ----------
    trend
        Of `rolamento.weibull.trend`.
    quantity
        Which of its columns.
    axes
        To draw on; of a new figure if not given.
    fits
        Of `wear_of_each`: laws of wear, by the bearings; then the points are not joined.
    limits
        When a limit is reached, by the bearings; "" of the only one.
    legend
        Whether to show one.

    Returns
    -------
    Axes
        Those given. Rejected measurements are crosses at the top of the frame.
    """
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        if not np.isfinite(trend.values[:, quantity]).any():
            return empty_frame(axes, no_result())
        for index, name in enumerate(trend.names):
            _bearing(axes, trend, quantity, index, name, (fits or {}).get(name))
        _rejected(axes, trend, quantity)
        _label(axes, trend, quantity)
        if limits:
            _limits(axes, trend, limits)
        if legend:
            legend_above(axes)
    return axes


def _limits(axes: Axes, trend: Trend, limits: Mapping[str, Forecast]) -> None:
    """Draw the laws of growth until the limit, or as far again as was measured."""
    least, last = float(trend.times.min()), float(trend.times.max())
    ends = [last + 0.15 * (last - least)]
    named = False
    for index, name in enumerate(trend.names):
        found = limits.get(name, limits.get(""))
        if found is None or not np.isfinite(found.growth.p_value):
            continue
        crossing = found.crossing
        if crossing.code == "reached":
            ends.append(min(1.05 * crossing.time, last + _FARTHEST * (last - least)))
        grid = np.linspace(found.growth.mean_time, ends[-1], _CURVE)
        look = series(index)
        axes.plot(grid, found.growth.at(grid), color=look.color, linewidth=0.9, linestyle=":")
        label = None if named else said("limit")
        axes.axhline(crossing.limit, color="black", linewidth=0.9, linestyle="--", label=label)
        axes.set_ylim(top=max(axes.get_ylim()[1], 1.15 * crossing.limit))
        named = True
    axes.set_xlim(right=max(axes.get_xlim()[1], *ends))


def _bearing(
    axes: Axes, trend: Trend, quantity: int, index: int, name: str, fit: WearFit | None
) -> None:
    look, (times, values) = series(index), trend.of_bearing(name, quantity)
    keywords: dict[str, Any] = {"color": look.color, "marker": look.marker, "zorder": 3.0}
    label = said("bearing {name}", name=shown_text(name, 24)) if name else said("measured")
    line = "" if fit is not None else look.linestyle
    axes.plot(times, values, linestyle=line, label=label, **keywords)
    if fit is None or not times.size:
        return
    from rolamento.units import to_si

    grid = np.linspace(0.0, float(times[-1]), _CURVE)
    second = to_si(f"1 {trend.time_unit}", "time")
    scale = to_si(f"1 {trend.units[quantity]}", "length")
    axes.plot(
        grid, fit.clearance(second * grid) / scale, color=look.color, linestyle=look.linestyle,
        label=said("bearing {name}, fitted", name=shown_text(name, 24)) if name else said("fitted"),
        zorder=2.0,
    )  # fmt: skip


def _rejected(axes: Axes, trend: Trend, quantity: int) -> None:
    """Mark what was rejected, in the colour of its bearing."""
    labelled = False
    for index, name in enumerate(trend.names):
        rows = (trend.bearings == name) & trend.rejected[:, quantity]
        if rows.any():
            axes.plot(
                trend.times[rows], np.full(int(rows.sum()), _TOP), marker="x", linestyle="",
                color=series(index).color, markersize=7.0, markeredgewidth=1.6, clip_on=False,
                transform=axes.get_xaxis_transform(), label=None if labelled else said("rejected"),
            )  # fmt: skip
            labelled = True


def _label(axes: Axes, trend: Trend, quantity: int) -> None:
    name = trend.quantities[quantity]
    known = capitalised(said(QUANTITIES[name]) if name in QUANTITIES else name)
    running = said("Running time ({unit})", unit=trend.time_unit)
    label_x(axes, said("Days from {date}", date=trend.start) if trend.start else running)
    unit = trend.units[quantity]
    label_y(axes, f"{known} ({unit})" if unit else known)
    top = float(np.nanmax(trend.values[:, quantity]))
    least = float(np.nanmin(trend.values[:, quantity]))
    axes.set_xlim(min(0.0, float(trend.times.min())), 1.03 * float(trend.times.max()))
    if least >= 0.0:
        axes.set_ylim(0.0, 1.15 * top)
