"""Static safety over the load, beside what is recommended, and the gaps of the rows."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, series_look
from rolamento.charts.axes_units import readable_unit
from rolamento.charts.drawing import figure
from rolamento.charts.texts import no_result, number
from rolamento.words import said

if TYPE_CHECKING:
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
    charts = [_safety(curve), *([_gaps(curve)] if curve.gap.shape[1] > 1 else [])]
    return figure(*charts, title=curve.case.title, height=140.0 if len(charts) > 1 else 95.0)


def _safety(curve: LoadCurve) -> Chart:
    """Return the safety by stress and by load, beside what is recommended."""
    if not np.isfinite(curve.safety).any():
        return nothing(no_result())
    lines = [Line(curve.factor, curve.safety, said("by stress"), series_look(0))]
    load = np.where(curve.found.solved.converged, curve.found.minimum("load"), np.nan)
    if np.isfinite(load).any():
        lines.append(Line(curve.factor, load, said("by load"), series_look(1)))
    known = [one for one in curve.found.recommended if one.safety is not None]
    upright, marks = Axis(said("Static safety")), [_DESIGN]
    if known:
        wanted = known[0].safety or 0.0
        name = said("recommended ({maker})", maker=known[0].maker)
        marks.insert(0, Mark(wanted, name, Look("ink", "dash", width=0.6)))
        design = float(np.interp(1.0, curve.factor, np.nan_to_num(curve.safety)))
        top = max(_ABOVE[0] * (wanted or 1.0), _ABOVE[1] * design)
        limits = 0.0, min(top, 1.05 * float(np.nanmax(curve.safety)))
        upright = replace(upright, limits=limits)
    own = (f"{line.name} {number(float(np.interp(1.0, line.x, line.y)), 3)}" for line in lines)
    conclusion = said("at the design load: {safeties}", safeties=", ".join(own))
    return Chart(tuple(lines), _across(curve), upright, conclusion, marks=tuple(marks))


def _gaps(curve: LoadCurve) -> Chart:
    read = readable_unit("m", curve.gap)
    lines = tuple(
        Line(curve.factor, read.of(curve.gap[:, row]), said("row {row}", row=row), series_look(row))
        for row in range(curve.gap.shape[1])
    )
    upright = Axis(said("Gap at the inner race"), read.symbol, zero=True)
    return Chart(lines, _across(curve), upright, marks=(_DESIGN,))


_DESIGN: Final = Mark(1.0, "", Look("grey", width=0.45), "x")


def _across(curve: LoadCurve) -> Axis:
    return Axis(said("Load over the design load"), limits=(0.0, float(curve.factor[-1])))
