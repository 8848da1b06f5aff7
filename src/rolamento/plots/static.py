"""Static safety over the load, beside what is recommended, and the gaps of the rows."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.axes_units import readable_unit
from rolamento.charts.frame import add_title, empty_frame, label_x, label_y, legend_above
from rolamento.charts.style import new_figure, new_stacked_figure, series, styled
from rolamento.charts.texts import no_result
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.safety import LoadCurve

__all__ = ["static_figure"]

_ABOVE = (6.0, 2.5)
"""How far the picture goes up: times the recommended safety, and times that of the design load."""


def static_figure(curve: LoadCurve) -> Figure:
    """Draw the static safety over multiples of the design load; of sets the gaps below it.

    Parameters
    ----------
    curve
        What `rolamento.safety.static_over_load` gives.
    """
    rows = curve.gap.shape[1]
    with styled():
        if rows > 1:
            figure, frames = new_stacked_figure(2, height=140.0)
        else:
            figure, one = new_figure(height=95.0)
            frames = (one,)
        _safety(curve, frames[0])
        if rows > 1:
            frames[0].set_xlabel("")
            _gaps(curve, frames[1])
        if curve.case.title:
            add_title(figure, curve.case.title)
    return figure


def _safety(curve: LoadCurve, axes: Axes) -> None:
    if not np.isfinite(curve.safety).any():
        empty_frame(axes, no_result())
        return
    axes.plot(curve.factor, curve.safety, label=said("by stress"), **series(0).keywords())
    load = np.where(curve.found.solved.converged, curve.found.minimum("load"), np.nan)
    if np.isfinite(load).any():
        axes.plot(curve.factor, load, label=said("by load"), **series(1).keywords())
    known = [one for one in curve.found.recommended if one.safety is not None]
    if known:
        wanted = known[0].safety
        name = said("recommended ({maker})", maker=known[0].maker)
        axes.axhline(wanted or 0.0, color="#000000", linewidth=0.8, linestyle="--", label=name)
        design = float(np.interp(1.0, curve.factor, np.nan_to_num(curve.safety)))
        top = max(_ABOVE[0] * (wanted or 1.0), _ABOVE[1] * design)
        axes.set_ylim(0.0, min(top, 1.05 * float(np.nanmax(curve.safety))))
    _across(curve, axes)
    label_y(axes, said("Static safety"))
    legend_above(axes)


def _gaps(curve: LoadCurve, axes: Axes) -> None:
    read = readable_unit("m", curve.gap)
    for row in range(curve.gap.shape[1]):
        values = read.of(curve.gap[:, row])
        axes.plot(curve.factor, values, label=said("row {row}", row=row), **series(row).keywords())
    _across(curve, axes)
    axes.set_ylim(bottom=0.0)
    label_y(axes, read.label(said("Gap at the inner race")))
    legend_above(axes)


def _across(curve: LoadCurve, axes: Axes) -> None:
    axes.set_xlim(0.0, float(curve.factor[-1]))
    axes.axvline(1.0, color="#888888", linewidth=0.6)
    label_x(axes, said("Load over the design load"))
