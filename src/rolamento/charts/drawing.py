"""Charts on paper: drawn with Matplotlib."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator, MultipleLocator
from numpy.typing import NDArray

from rolamento.charts.contacts import AROUND
from rolamento.charts.frame import (
    decades,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
    require_axes,
)
from rolamento.charts.palette import LIGHT
from rolamento.charts.record import (
    FAINT,
    Axis,
    Bars,
    Chart,
    Ellipses,
    Labels,
    Line,
    Mark,
    Spread,
    widened,
)
from rolamento.charts.style import in_style, new_figure, new_polar_figure, of_look
from rolamento.charts.texts import number
from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["draw", "draw_series", "frame"]

Floats = NDArray[np.float64]

_WIDTH: Final = 1.4
"""Width of an ordinary line, in points."""
_MARK: Final = 4.0
_POINT: Final = 6.0
_BAND: Final = 0.18
"""Opacity of what lies between two lines."""
_BODY: Final = 0.12
"""Opacity of a zone, and of a body within its outline."""
_TEXT: Final = 8.0
_SIDES: Final[dict[str, dict[str, Any]]] = {
    "left": {"xytext": (-4, 0), "ha": "right", "va": "center"},
    "right": {"xytext": (6, 0), "ha": "left", "va": "center"},
    "above": {"xytext": (0, 3), "ha": "center", "va": "bottom"},
}


@in_style
def draw(chart: Chart, axes: Axes | None = None, *, legend: bool = True, title: str = "") -> Axes:
    """Draw a chart.

    Parameters
    ----------
    chart
        A record; one without series is a frame that says why.
    axes
        To draw on, polar ones for a polar chart; of a new figure if not given.
    legend
        Whether its names stand above the frame.
    title
        Over them.

    Returns
    -------
    Axes
        Those given.

    Raises
    ------
    InputError
        If the axes are none, or not of this kind.
    """
    if axes is None:
        axes = (new_polar_figure() if chart.polar else new_figure())[1]
    axes = _turned(axes) if chart.polar else require_axes(axes)
    axes.set_label(chart.alternative)
    if not chart.series:
        return empty_frame(axes, chart.conclusion)
    draw_series(chart, axes)
    if isinstance(axes, PolarAxes):
        axes.set_rlim(0.0, None if chart.y.limits is None else chart.y.limits[1])
        axes.set_xlabel("" if chart.y.hidden else chart.y.title, labelpad=6.0)
    else:
        frame(axes, "x", chart.x)
        frame(axes, "y", chart.y)
        _zones(axes, chart)
    if legend:
        legend_above(axes, title=title)
    if isinstance(axes, PolarAxes):
        _number_circles(axes, chart)
    return axes


def draw_series(chart: Chart, axes: Axes) -> None:
    """Draw what a chart shows, without its axes and its legend."""
    groups = [one for one in chart.series if isinstance(one, Bars)]
    for one in chart.series:
        if isinstance(one, Line):
            _line(axes, chart, one)
        elif isinstance(one, Spread):
            color = LIGHT[one.look.color]
            fill: dict[str, Any] = {"color": color, "alpha": _BAND}
            if one.hatched:
                fill = {"facecolor": "none", "edgecolor": color, "hatch": "////", "alpha": 0.5}
            axes.fill_between(one.x, one.low, one.high, linewidth=0.0, label=one.name, **fill)
        elif isinstance(one, Ellipses):
            _ellipses(axes, one)
        elif isinstance(one, Labels):
            for x, y, text, side in zip(one.x, one.y, one.texts, one.sides, strict=True):
                axes.annotate(text, (x, y), textcoords="offset points", fontsize=_TEXT,
                              **_SIDES[side])  # fmt: skip
    _bars(axes, chart, groups)
    for mark in chart.marks:
        _mark(axes, mark)


def _zones(axes: Axes, chart: Chart) -> None:
    """Draw bands below all, those of the axis across named by the legend."""
    for zone in chart.zones:
        across = zone.axis == "x"
        ends = axes.get_xlim() if across else axes.get_ylim()
        low, high = max(zone.low, ends[0]), min(zone.high, ends[1])
        if low >= high:
            continue
        look: dict[str, Any] = {"color": LIGHT[zone.color], "alpha": _BODY, "linewidth": 0.0}
        if across:
            axes.axvspan(low, high, label=zone.name, **look)
            continue
        axes.axhspan(low, high, **look)
        axes.annotate(
            zone.name, (1.0, high), (-3, -3), ha="right", va="top", fontsize=_TEXT,
            xycoords=("axes fraction", "data"), textcoords="offset points",
        )  # fmt: skip


def _line(axes: Axes, chart: Chart, line: Line) -> None:
    drawn: dict[str, Any] = {**of_look(line.look).keywords(markers=line.form != "line"),
                             "linewidth": _WIDTH * line.look.width}  # fmt: skip
    if line.form == "points":
        drawn |= {"linestyle": "none", "markersize": _POINT * line.look.width, "zorder": 3.0}
    if line.look.hollow:
        drawn["markerfacecolor"] = "white"
    x = np.radians(line.x) if chart.polar else line.x
    foot = np.isneginf(line.y)
    if foot.any():
        drawn |= {"transform": axes.get_xaxis_transform(), "clip_on": False}
        axes.plot(x[foot], np.zeros(int(foot.sum())), label=line.name or "_", **drawn)
        return
    if line.filled:
        axes.fill(x, line.y, color=LIGHT[line.look.color], alpha=_BODY, linewidth=0.0)
    valid = np.ones(len(x), dtype=np.bool_) if line.valid is None else line.valid
    fails = np.isfinite(line.y) & ~valid
    if valid.any() or not fails.any():
        y = line.y if line.valid is None else np.where(widened(valid), line.y, np.nan)
        axes.plot(x, y, label=line.name or "_", **drawn)
    if fails.any():
        axes.plot(x, np.where(widened(fails), line.y, np.nan), alpha=FAINT, **drawn,
                  label="_" if valid.any() else line.name or "_")  # fmt: skip


def _ellipses(axes: Axes, own: Ellipses) -> None:
    color = LIGHT[own.look.color]
    face: dict[str, Any] = {"facecolor": color if own.filled else "none"}
    if own.hatched:
        face = {"facecolor": "white", "hatch": "//////"}
    look = {**face, "edgecolor": color, "linewidth": 0.8}
    ellipses = EllipseCollection(
        2.0 * own.half_width, 2.0 * own.half_height, np.zeros(len(own.x)), units="xy",
        offsets=np.column_stack([own.x, own.y]), offset_transform=axes.transData, zorder=3.0,
        **look,
    )  # fmt: skip
    axes.add_collection(ellipses, autolim=False)
    axes.fill([np.nan], [np.nan], label=own.name or "_", **look)  # for the legend


def _bars(axes: Axes, chart: Chart, groups: list[Bars]) -> None:
    if not groups:
        return
    thick = 0.8 if chart.stacked else 0.8 / len(groups)
    reached = np.zeros(len(chart.y.categories))
    far = chart.x.limits[1] if chart.x.limits else 1.0
    for order, one in enumerate(groups):
        places = np.asarray(one.places)
        shift = 0.0 if chart.stacked else thick * (order - 0.5 * (len(groups) - 1))
        values = np.where(np.isposinf(one.values), far, one.values)
        left = reached[places] if chart.stacked else None
        drawn = axes.barh(places + shift, values, thick, left=left, label=one.name or "_",
                          color=LIGHT[one.look.color], zorder=2.0)  # fmt: skip
        for bar, fine in zip(drawn, one.valid, strict=False):
            bar.set_alpha(1.0 if fine else FAINT)
        if one.texts:
            axes.bar_label(drawn, labels=list(one.texts), padding=3, fontsize=_TEXT)
        if chart.stacked:
            reached[places] += values


def _mark(axes: Axes, mark: Mark) -> None:
    line = axes.axhline if mark.axis == "y" else axes.axvline
    look = of_look(mark.look)
    line(mark.at, color=look.color, linestyle=look.linestyle, linewidth=_WIDTH * mark.look.width,
         zorder=1.5, label=mark.name or "_")  # fmt: skip


# --- axes -----------------------------------------------------------------------------------------


def frame(axes: Axes, which: str, own: Axis) -> None:
    """Give an axis its label, limits, scale and ticks."""
    axis = axes.xaxis if which == "x" else axes.yaxis
    if own.hidden:
        axis.set_visible(False)
    (label_x if which == "x" else label_y)(axes, own.title)
    limits = getattr(axes, f"get_{which}lim")
    set_limits = getattr(axes, f"set_{which}lim")
    if own.log and own.limits is not None:
        decades(axes, which, own.limits)
    elif own.log:
        log_scale(axes, which)
    elif own.limits is not None:
        set_limits(*own.limits)
    elif own.zero and limits()[1] > 0.0 and _least(axes, which) >= 0.0:
        set_limits(0.0, None)
    if own.categories:
        axis.set_ticks(range(len(own.categories)), own.categories)
        set_limits(len(own.categories) - 0.5, -0.5)
        axes.grid(False, axis="y")
    elif own.ticks:
        axis.set_ticks([place for place, _ in own.ticks], [text for _, text in own.ticks])
    elif own.step and not own.log:
        axis.set_major_locator(MultipleLocator(own.step))
    if own.equal:
        axes.set_aspect("equal", adjustable="box")


def _least(axes: Axes, which: str) -> float:
    """Return the least number that is drawn."""
    box = axes.dataLim
    return float(box.x0 if which == "x" else box.y0)


# --- polar frames ---------------------------------------------------------------------------------


def _turned(axes: Axes) -> PolarAxes:
    if not isinstance(axes, PolarAxes):
        raise InputError(
            said("must be polar"), field="axes", example='figure.add_subplot(projection="polar")'
        )
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.set_thetagrids(np.arange(0.0, 360.0, 45.0), AROUND)
    return axes


def _number_circles(axes: PolarAxes, chart: Chart) -> None:
    """Write what the circles stand for, clear of the lines beside the numbers."""
    rim = float(axes.get_rmax())
    circles = np.asarray(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, rim))
    circles = circles[(circles > 0.0) & (circles <= rim)]
    near = [
        line.y[np.cos(np.radians(line.x - chart.numbers_at)) > np.cos(np.pi / 4)]
        for line in chart.lines
    ]
    clear = 2.0 * float(np.max(np.concatenate(near), initial=0.0)) if near else 0.0
    names = [number(circle) if circle > clear else "" for circle in circles]
    inward = "right" if 0.0 < chart.numbers_at % 360.0 < 180.0 else "left"
    shown = names if any(names) else [number(one) for one in circles]
    axes.set_rgrids(circles, shown, ha=inward)
    axes.set_rlabel_position(chart.numbers_at % 360.0)
