"""Severity of vibration: measured velocities on the zones that a machine may have."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Bars, Chart, Look, Mark, Zone
from rolamento.charts.drawing import draw, figure
from rolamento.charts.texts import shown_text
from rolamento.plots.growth import growth_chart, over_time
from rolamento.words import marked, said
from rolamento.words.sentences.severity import class_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.numerics.growth import Forecast
    from rolamento.vibration.severity import AlarmSetting, MachineClass, Severity

__all__ = ["severity_figure", "severity_trend_figure", "zone_bars"]

_MILLI: Final = 1e3
_ZONES: Final = {"A": "good", "B": "fifth", "C": "outer", "D": "bad"}
"""Their colours; each has its letter on it."""
_ROOM: Final = 1.45
"""Multiple of the axis beyond the boundary C/D, or beyond the greatest velocity."""
_MOST_NAMED: Final = 6
_DASHES: Final = ("solid", "dash", "dashdot", "longdash", "longdashdot", "dashdotdot")
_ALARM: Final = marked("alarm")


def severity_figure(
    measured: Sequence[tuple[str, Severity]],
    classes: Sequence[MachineClass],
    *,
    setting: AlarmSetting | None = None,
    title: str = "",
) -> Figure:
    """Draw velocities on zones, as `zone_bars`, with a title."""
    chart = zones_chart(measured, classes, setting)
    return figure(chart, title=title, height=_height(classes))


def zone_bars(
    measured: Sequence[tuple[str, Severity]],
    classes: Sequence[MachineClass],
    axes: Axes | None = None,
    *,
    setting: AlarmSetting | None = None,
) -> Axes:
    """Draw the zones of classes as bars, and measured velocities across them.

    Parameters
    ----------
    measured
        Names and severities; those without a velocity are left out.
    classes
        One bar each.
    axes
        To draw on; of a new figure if not given.
    setting
        Alarm and trip of the only class.
    """
    return draw(zones_chart(measured, classes, setting), axes, height=_height(classes))


def _height(classes: Sequence[MachineClass]) -> float:
    return 42.0 + 16.0 * len(classes)


def zones_chart(
    measured: Sequence[tuple[str, Severity]],
    classes: Sequence[MachineClass],
    setting: AlarmSetting | None = None,
) -> Chart:
    """Return the chart of `zone_bars`."""
    there = [(name, one) for name, one in measured if one.measured]
    top = max([machine.velocity[-1] for machine in classes], default=0.01)
    top = max([top, *(one.upper for _, one in there)]) * _ROOM
    ends = _MILLI * np.array([[0.0, *machine.velocity, top] for machine in classes])
    rows, few = tuple(range(len(classes))), len(there) <= _MOST_NAMED
    zones = (
        Bars(width, rows, "", Look(color, opacity=0.4), (zone,) * len(rows))
        for (zone, color), width in zip(_ZONES.items(), np.diff(ends).T, strict=True)
    )
    marks = [
        Mark(_MILLI * one.velocity, _with_velocity(name, one.velocity) if few else "",
             Look("ink", _DASHES[place % len(_DASHES)]), "x")
        for place, (name, one) in enumerate(there)
    ]  # fmt: skip
    if setting is not None:
        for value, name in ((setting.alarm, said(_ALARM)), (setting.trip, said("trip"))):
            marks.append(Mark(_MILLI * value, name, Look("grey", "dot", width=0.9), "x"))
    intervals = (Zone(_MILLI * one.lower, _MILLI * one.upper, "", "ink", "x") for _, one in there)
    return Chart(
        tuple(zones),
        Axis(limits=(0.0, _MILLI * top), name=said("RMS velocity"), unit="mm/s"),
        Axis(categories=tuple(class_name(machine.name) for machine in classes)),
        "; ".join(_with_zones(name, one, classes) for name, one in there)
        or "; ".join(_with_velocity(class_name(one.name), one.velocity[-1]) for one in classes),
        marks=tuple(marks),
        zones=tuple(intervals),
        stacked=True,
    )


def _with_velocity(name: str, velocity: float) -> str:
    value = said("{value:.3 mm/s}", value=velocity)
    return f"{shown_text(name, 26)}: {value}" if name else value


def _with_zones(name: str, one: Severity, classes: Sequence[MachineClass]) -> str:
    zones = dict.fromkeys(machine.zone_of(one.velocity) for machine in classes)
    return f"{_with_velocity(name, one.velocity)} ({', '.join(zones)})"


def severity_trend_figure(
    times: Sequence[float],
    velocities: Sequence[float],
    found: Forecast,
    machine: MachineClass | None,
    *,
    start: str = "",
    title: str = "",
) -> Figure:
    """Draw velocities over time with their trend, on the zones of the machine.

    Parameters
    ----------
    times, velocities
        Measured; h, or days from the start, and mm/s.
    found
        Of `rolamento.numerics.growth.forecast`.
    machine
        Class, if it is known.
    start
        Date from which the times count as days, if they do.
    title
        Of the figure.
    """
    edges = [] if machine is None else [0.0, *(_MILLI * e for e in machine.velocity), np.inf]
    zones = [
        Zone(low, high, zone, color)
        for (zone, color), low, high in zip(_ZONES.items(), edges, edges[1:], strict=False)
    ]
    upright = Axis(said("RMS velocity"), "mm/s")
    chart = growth_chart(times, velocities, found, over_time(start), upright, zones)
    return figure(chart, title=title, height=95.0)
