"""Values that grow toward a limit, with the line through them and when it arrives."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.charts.frame import GREY, legend_above
from rolamento.charts.style import INNER, OUTER
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.numerics.growth import Forecast

__all__ = ["growth_lines"]

_CURVE: Final = 200
_FARTHEST: Final = 2.0
"""Spans of the measurements beyond the last one that are drawn at most."""


def growth_lines(
    axes: Axes,
    times: Sequence[float],
    values: Sequence[float],
    found: Forecast,
    *,
    limit_name: str = "",
) -> None:
    """Draw measurements, the chosen law with its band, and the limit.

    Parameters
    ----------
    axes
        To draw on.
    times, values
        Measured.
    found
        Of `rolamento.numerics.growth.forecast`.
    limit_name
        What to call the limit in the legend.
    """
    growth, crossing = found.growth, found.crossing
    first, last = min(times), max(times)
    span = max(last - first, 1e-9 * max(abs(last), 1.0))
    reach = [last + 0.15 * span]
    if crossing.code == "reached":
        end = crossing.upper if isfinite(crossing.upper) else crossing.time
        reach += [min(1.05 * end - 0.05 * first, last + _FARTHEST * span)]
    grid = np.linspace(first, max(reach), _CURVE)
    axes.plot(
        times, values, linestyle="", marker=INNER.marker, color=INNER.color,
        label=said("measured"), zorder=4.0,
    )  # fmt: skip
    if isfinite(growth.p_value):
        law = said("exponential") if growth.law == "exponential" else said("linear")
        low, high = growth.band(grid, crossing.confidence)
        axes.plot(grid, growth.at(grid), color=INNER.color, label=law, zorder=3.0)
        label = said("{confidence:.3 [%]} % band", confidence=crossing.confidence)
        axes.fill_between(grid, low, high, color=INNER.color, alpha=0.15, linewidth=0.0,
                          label=label)  # fmt: skip
    axes.axhline(
        crossing.limit, color=OUTER.color, linestyle="--", label=limit_name or said("limit")
    )
    if crossing.code == "reached" and crossing.time <= grid[-1]:
        axes.axvline(crossing.time, color=GREY, linewidth=0.9)
        ends = [crossing.lower, min(crossing.upper, float(grid[-1]))]
        axes.plot(ends, [crossing.limit] * 2, color=OUTER.color, linewidth=4.0, alpha=0.5,
                  label=said("time to the limit"), solid_capstyle="butt")  # fmt: skip
    top = max(*values, crossing.limit)
    axes.set_xlim(first - 0.03 * span, float(grid[-1]))
    axes.set_ylim(0.0 if min(values) >= 0.0 else None, 1.25 * top)
    legend_above(axes)
