"""Severity of vibration: measured velocities on the zones that a machine may have."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from matplotlib.figure import Figure

from rolamento.charts.frame import GREY, add_title, label_x, label_y, panels
from rolamento.charts.style import new_figure, styled
from rolamento.charts.texts import shown_text
from rolamento.plots.growth import growth_lines
from rolamento.words import marked, said
from rolamento.words.sentences.severity import class_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.numerics.growth import Forecast
    from rolamento.vibration.severity import AlarmSetting, MachineClass, Severity

__all__ = ["severity_figure", "severity_trend_figure", "zone_bars"]

_MILLI: Final = 1e3
_COLOURS: Final = ("#BFE3C6", "#E7F0B5", "#FBD9A6", "#F3B0A1")
_ZONES: Final = ("A", "B", "C", "D")
_ROOM: Final = 1.45
"""Multiple of the axis beyond the boundary C/D, or beyond the greatest velocity."""
_MOST_NAMED: Final = 6
_ALARM: Final = marked("alarm")


def severity_figure(
    measured: Sequence[tuple[str, Severity]],
    classes: Sequence[MachineClass],
    *,
    setting: AlarmSetting | None = None,
    title: str = "",
) -> Figure:
    """Draw velocities on zones, as `zone_bars`, with a title."""
    return panels(
        lambda axes: zone_bars(measured, classes, axes, setting=setting),
        title=title,
        height=38.0 + 16.0 * len(classes),
    )


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
    with styled():
        axes = new_figure(height=38.0 + 16.0 * len(classes))[1] if axes is None else axes
        there = [(name, one) for name, one in measured if one.measured]
        greatest = max([machine.velocity[-1] for machine in classes], default=0.01)
        greatest = max([greatest, *(one.upper for _, one in there)]) * _ROOM * _MILLI
        for row, machine in enumerate(classes):
            edges = [0.0, *(_MILLI * edge for edge in machine.velocity), greatest]
            for zone, colour, low, high in zip(_ZONES, _COLOURS, edges, edges[1:], strict=False):
                axes.barh(row, high - low, left=low, height=0.62, color=colour, edgecolor="white")
                axes.text(0.5 * (low + high), row, zone, ha="center", va="center", fontsize=9.0,
                          color="#404040")  # fmt: skip
        _velocities(axes, there, len(classes))
        if setting is not None:
            for value, name in ((setting.alarm, said(_ALARM)), (setting.trip, said("trip"))):
                axes.axvline(_MILLI * value, color=GREY, linestyle=":", linewidth=1.2)
                axes.text(_MILLI * value, -0.46, name, fontsize=7.5, color=GREY, ha="left",
                          va="bottom", rotation=90.0)  # fmt: skip
        axes.set_yticks(range(len(classes)))
        axes.set_yticklabels([class_name(machine.name) for machine in classes])
        axes.set_ylim(len(classes) - 0.5, -0.85)
        axes.set_xlim(0.0, greatest)
        axes.grid(visible=False)
        label_x(axes, said("RMS velocity (mm/s)"))
    return axes


def _velocities(axes: Axes, measured: Sequence[tuple[str, Severity]], rows: int) -> None:
    named = len(measured) <= _MOST_NAMED
    for place, (name, one) in enumerate(measured):
        velocity = _MILLI * one.velocity
        axes.axvspan(_MILLI * one.lower, _MILLI * one.upper, color="black", alpha=0.12, lw=0.0)
        axes.axvline(velocity, color="black", linewidth=1.4)
        if named:
            axes.annotate(
                shown_text(name, 26), (velocity, -0.85), (3.0, -3.0 - 8.0 * (place % 2)),
                textcoords="offset points", fontsize=7.5, va="top", parse_math=False,
            )  # fmt: skip


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
    with styled():
        figure, axes = new_figure(height=95.0)
        growth_lines(axes, times, velocities, found, limit_name=said("limit"))
        top = axes.get_ylim()[1]
        if machine is not None:
            edges = [0.0, *(_MILLI * edge for edge in machine.velocity), 1e9]
            for zone, colour, low, high in zip(_ZONES, _COLOURS, edges, edges[1:], strict=False):
                if low < top:
                    axes.axhspan(low, min(high, top), color=colour, alpha=0.55, zorder=0.0, lw=0.0)
                    axes.text(0.995, 0.5 * (low + min(high, top)), zone, fontsize=9.0, ha="right",
                              va="center", color="#404040",
                              transform=axes.get_yaxis_transform())  # fmt: skip
        axes.set_ylim(0.0, top)
        label_x(
            axes,
            said("Days from {date}", date=start)
            if start
            else said("Running time ({unit})", unit="h"),
        )
        label_y(axes, said("RMS velocity (mm/s)"))
        if title:
            add_title(figure, title)
    return figure
