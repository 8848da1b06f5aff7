"""Charts on paper: drawn with Matplotlib."""

from __future__ import annotations

from functools import partial
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.colors import BoundaryNorm, to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator, MultipleLocator
from numpy.typing import ArrayLike, NDArray

from rolamento.charts.contacts import AROUND
from rolamento.charts.frame import (
    PlainNumbers,
    decades,
    empty_frame,
    figure_of,
    in_lines,
    label_x,
    label_y,
    legend_above,
    log_scale,
    panels,
    require_axes,
)
from rolamento.charts.palette import LIGHT, Look
from rolamento.charts.record import (
    BREAK,
    FAINT,
    Arrows,
    Axis,
    Bars,
    Chart,
    Ellipses,
    Field,
    Labels,
    Line,
    Mark,
    Spread,
    widened,
)
from rolamento.charts.style import in_style, new_figure, new_polar_figure, of_look
from rolamento.charts.texts import mathematical, number
from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["draw", "draw_series", "figure", "frame"]

Floats = NDArray[np.float64]

_WIDTH: Final = 1.4
"""Width of an ordinary line, in points."""
_POINT: Final = 6.0
_MANY: Final = 300
"""From so many on points are small pieces of one picture."""
_BAND: Final = 0.18
"""Opacity of what lies between two lines."""
_BODY: Final = 0.12
"""Opacity of a zone, and of a body within its outline."""
_TEXT: Final = 8.0
_SIDES: Final[dict[str, dict[str, Any]]] = {
    "left": {"xytext": (-4, 0), "ha": "right", "va": "center"},
    "right": {"xytext": (6, 3), "ha": "left", "va": "center"},
    "above": {"xytext": (0, 3), "ha": "center", "va": "bottom"},
    "on": {
        "xytext": (0, 0),
        "ha": "center",
        "va": "center",
        "bbox": {"facecolor": "white", "linewidth": 0.0, "pad": 0.6},
    },
    "along": {"xytext": (-1, 0), "ha": "right", "va": "top", "rotation": 90.0, "fontsize": 7.0},
}
_SPARSE: Final = 0.18
"""Distance of marks along a line of a few, over the length of the frame."""
_ROUND: Final = (1, 2, 2.5, 5, 10)
_AS_IT_IS: Final = "colour-map"
"""Pages in the dark leave what is called so as it is: a map of colours, and what is white on it."""
_HATCH: Final[dict[str, Any]] = {
    "facecolor": "#E4E4E4", "edgecolor": "#A0A0A0", "hatch": "////", "linewidth": 0.0,
}  # fmt: skip


def figure(*charts: Chart, title: str = "", height: float = 90.0, own: bool = False) -> Figure:
    """Return a new figure of charts one below the other, with a title over all.

    Parameters
    ----------
    charts
        Their common axis across is named below the last, unless each has an axis of its own.
    title
        None if empty.
    height
        In mm.
    own
        Whether each has an axis of its own across.
    """
    return panels(*(partial(draw, one) for one in charts), title=title, height=height, own=own)


@in_style
def draw(
    chart: Chart, axes: Axes | None = None, *, legend: bool = True, height: float = 90.0
) -> Axes:
    """Draw a chart.

    Parameters
    ----------
    chart
        A record; one without series is a frame that says why.
    axes
        To draw on, polar ones for a polar chart; of a new figure if not given.
    legend
        Whether its names stand above the frame.
    height
        Of a new figure, in mm.

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
        axes = (new_polar_figure() if chart.polar else new_figure(height=height))[1]
    axes = _turned(axes) if chart.polar else require_axes(axes)
    shows = chart.shows.replace("\n", ", ")
    axes.set_label(f"{shows}\n{chart.says}")  # of which pages make captions
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
        _unclipped(axes)
    if chart.symbols:
        for label in (axes.xaxis.label, axes.yaxis.label):
            label.set_text(mathematical(label.get_text()))
            label.set_parse_math(True)
    if legend:
        legend_above(axes, title=chart.over_names, symbols=chart.symbols)
        _white_as_grey(axes)
    if isinstance(axes, PolarAxes):
        _number_circles(axes, chart)
    return axes


def draw_series(chart: Chart, axes: Axes) -> None:
    """Draw what a chart shows, without its axes and its legend."""
    groups = [one for one in chart.series if isinstance(one, Bars)]
    for place, one in enumerate(chart.series):
        if isinstance(one, Line):
            _line(axes, chart, one, place)
        elif isinstance(one, Spread):
            color = LIGHT[one.look.color]
            fill: dict[str, Any] = {"color": color, "alpha": _BAND * one.look.opacity,
                                    "linewidth": 0.0}  # fmt: skip
            if one.solid:
                fill = {"color": color, "linewidth": 0.4}
            if one.hatched:
                fill |= {"facecolor": "none", "edgecolor": color, "hatch": "////", "alpha": 0.5}
                del fill["color"]
            axes.fill_between(one.x, one.low, one.high, label=one.name, **fill)
        elif isinstance(one, Ellipses):
            _ellipses(axes, one)
        elif isinstance(one, Labels):
            _labels(axes, one, symbols=chart.symbols)
        elif isinstance(one, Field):
            _field(axes, one)
        elif isinstance(one, Arrows):
            size = np.maximum(np.hypot(one.across, one.along), np.finfo(np.float64).tiny)
            axes.quiver(
                one.x, one.y, one.across / size, one.along / size, color="white", scale=30.0,
                width=0.004, edgecolor="#202020", linewidth=0.3, pivot="middle", zorder=4.0,
                gid=f"{_AS_IT_IS}-white",
            )  # fmt: skip
    _bars(axes, chart, groups)
    for mark in chart.marks:
        _mark(axes, mark, over=chart.stacked)


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


def _line(axes: Axes, chart: Chart, line: Line, place: int) -> None:
    look, point = line.look, line.form == "points"
    drawn: dict[str, Any] = {**of_look(look).keywords(markers=line.form != "line"),
                             "linewidth": _WIDTH * look.width}  # fmt: skip
    if look.opacity < 1.0:
        drawn["alpha"] = look.opacity
    if look.color == "white":
        drawn["gid"] = f"{_AS_IT_IS}-white"
    if chart.y.categories:
        drawn["zorder"] = 3.0
    if point:
        drawn |= {"linestyle": "none", "markersize": _POINT * look.width, "zorder": 3.0}
    elif line.form == "sparse":
        drawn["markevery"] = (0.03 * (1 + place % 6), _SPARSE)
    if look.hollow:
        drawn["markerfacecolor"] = "white"
    if point and len(line.x) > _MANY:
        drawn |= {"markeredgewidth": 0.0, "rasterized": True}
    x, y = np.radians(line.x) if chart.polar else line.x, line.y
    if line.height is not None:
        y = np.full(len(x), line.height)
        drawn |= {"transform": axes.get_xaxis_transform(), "clip_on": False}
    if line.filled:
        face = (*to_rgb(LIGHT[look.color]), _BODY * look.opacity)
        axes.fill(x, y, facecolor=face, edgecolor=drawn["color"], linestyle=drawn["linestyle"],
                  linewidth=drawn["linewidth"], label=line.name or "_", zorder=2.0)  # fmt: skip
        return
    valid = np.ones(len(x), dtype=np.bool_) if line.valid is None else line.valid
    fails = np.isfinite(y) & ~valid
    if valid.any() or not fails.any():
        shown = y if line.valid is None else np.where(widened(valid), y, np.nan)
        axes.plot(x, shown, label=line.name or "_", **drawn)
    if fails.any():
        axes.plot(x, np.where(widened(fails), y, np.nan), **{**drawn, "alpha": FAINT},
                  label="_" if valid.any() else line.name or "_")  # fmt: skip


def _labels(axes: Axes, own: Labels, *, symbols: bool) -> None:
    raised = own.height is not None
    y = np.full(len(own.x), own.height) if raised else own.y
    where: Any = axes.get_xaxis_transform() if raised else "data"
    for x, up, text, side in zip(own.x, y, own.texts, own.sides, strict=True):
        written = mathematical(text) if symbols else text
        axes.annotate(written, (x, up), xycoords=where, textcoords="offset points",
                      color=LIGHT[own.color], parse_math=symbols, annotation_clip=not raised,
                      **{"fontsize": _TEXT, **_SIDES[side]})  # fmt: skip


def _field(axes: Axes, own: Field) -> None:
    """Draw numbers as few colours, with the bar that says what they stand for."""
    low, high = own.scale.limits or (float(np.nanmin(own.values)), float(np.nanmax(own.values)))
    parted = own.signed and low < 0.0 < high
    if parted:
        low, high = -max(-low, high), max(-low, high)
    steps = MaxNLocator(own.steps, steps=_ROUND, symmetric=parted).tick_values(low, high)
    levels = _within(steps, low, high)
    colours = "RdBu_r" if parted else "cividis"
    if own.x.ndim == 1:
        drawn: Any = axes.pcolormesh(
            own.x, own.y, np.ma.masked_invalid(own.values), cmap=colours,
            norm=BoundaryNorm(levels, 256), rasterized=True, zorder=1.0,
        )  # fmt: skip
    else:
        drawn = axes.contourf(own.x, own.y, own.values, levels=levels, cmap=colours)
    drawn.set_gid(_AS_IT_IS)
    axes.grid(False)
    bar: Any = figure_of(axes).colorbar(drawn, ax=axes, format=PlainNumbers(), pad=0.02)
    bar.set_label(in_lines(own.scale.title), parse_math=False)
    bar.ax.tick_params(labelsize=_TEXT)
    bar.minorticks_off()
    if own.missing:
        axes.add_patch(Rectangle((0, 0), 1, 1, transform=axes.transAxes, zorder=0.5,
                                 label=own.missing, **_HATCH))  # fmt: skip


def _within(steps: ArrayLike, low: float, high: float) -> Floats:
    """Return the steps that hold all numbers, two at least."""
    bounds = np.asarray(steps, dtype=np.float64)
    first = max(int(np.searchsorted(bounds, low, side="right")) - 1, 0)
    last = min(int(np.searchsorted(bounds, high, side="left")), len(bounds) - 1)
    return bounds[first : max(last, first + 1) + 1]


def _unclipped(axes: Axes) -> None:
    """Draw marks whole that stand on the edge of the frame."""
    (left, right), (low, high) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    for line in axes.lines:
        x, y = (np.asarray(values, dtype=np.float64) for values in line.get_data())
        if line.get_linestyle() == "None" and line.get_transform() == axes.transData:
            inside = (x >= left) & (x <= right) & (y >= low) & (y <= high)
            line.set_clip_on(not inside[np.isfinite(x + y)].all())


def _white_as_grey(axes: Axes) -> None:
    """Show in the legend, on white paper, what is white on colours."""
    legend = axes.get_legend()
    for shown in () if legend is None else legend.legend_handles:
        if isinstance(shown, Line2D) and shown.get_color() == "white":
            shown.set_color(LIGHT["grey"])


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
    far = chart.x.limits[1] if chart.x.limits else np.inf
    for order, one in enumerate(groups):
        places = np.asarray(one.places)
        shift = 0.0 if chart.stacked else thick * (order - 0.5 * (len(groups) - 1))
        left = reached[places] if chart.stacked else np.zeros(len(places))
        if one.start is not None:
            left, shift, thick = one.start, 0.0, 0.5
        values = one.values if chart.stacked else np.minimum(one.values, far) - left
        drawn = axes.barh(places + shift, values, thick, left=left, label=one.name or "_",
                          color=_paler(one.look), zorder=2.0, edgecolor="white", linewidth=0.0,
                          hatch="//" if one.look.hollow else None)  # fmt: skip
        for bar, fine in zip(drawn, one.valid, strict=False):
            bar.set_alpha(1.0 if fine else FAINT)
        beyond = np.zeros(len(values), np.bool_) if chart.stacked else one.values > far
        if one.texts:
            inside = np.where(beyond, "", one.texts)
            kind: Any = {"label_type": "center"} if chart.stacked else {"padding": 3}
            axes.bar_label(drawn, labels=inside.tolist(), fontsize=_TEXT, **kind)
        for place in np.flatnonzero(beyond):
            at = (far, float(places[place]) + shift)
            axes.annotate(BREAK, at, (-10, 0), textcoords="offset points", ha="center", va="center",
                          bbox={"facecolor": "white", "linewidth": 0.0, "pad": 0.5})  # fmt: skip
            if one.texts:
                axes.annotate(one.texts[place], at, (-20, 0), textcoords="offset points",
                              ha="right", va="center", color="white", fontsize=_TEXT)  # fmt: skip
        if chart.stacked:
            reached[places] += values


def _paler(look: Look) -> tuple[float, ...]:
    """Return the colour of a look on white, through which nothing shows."""
    return tuple(1.0 - look.opacity * (1.0 - part) for part in to_rgb(LIGHT[look.color]))


def _mark(axes: Axes, mark: Mark, *, over: bool) -> None:
    line = axes.axhline if mark.axis == "y" else axes.axvline
    look = of_look(mark.look)
    line(mark.at, color=look.color, linestyle=look.linestyle, linewidth=_WIDTH * mark.look.width,
         zorder=3.0 if over else 1.5, label=mark.name or "_")  # fmt: skip


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
    elif own.whole:
        axis.set_major_locator(MaxNLocator(integer=True))
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
