"""How a figure of a reproduction is drawn, from nothing but its columns."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import BytesIO
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure as Picture
from matplotlib.lines import Line2D
from matplotlib.patches import Circle
from matplotlib.ticker import Formatter, MaxNLocator, MultipleLocator
from PIL import Image

from rolamento.charts.style import INNER, OUTER, new_figure, new_stacked_figure, series, styled
from rolamento.words import manner
from rolamento_reproductions.record import (
    Curves,
    Ending,
    Figure,
    Floats,
    Line,
    Map,
    Maps,
    Panel,
    Positions,
)
from rolamento_reproductions.text import localised

_INDEXED: Final = re.compile(r"(?<![A-Za-z0-9_])([A-Za-zα-ω])_([A-Za-z0-9]+)(?![^\W²³])")
_LONE_SYMBOL: Final = re.compile(r"(?<![$\w{}])([α-ωQ])(?![\w$}])")


class Numbers(Formatter):
    """Numbers of an axis: as many decimals as its ticks need, in the manner of a language."""

    def __init__(self, ticked: Axis) -> None:
        self._ticked = ticked
        self._manner = manner()

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Return how a number stands at the axis."""
        places: Floats = np.asarray(self._ticked.get_majorticklocs(), dtype=np.float64)
        decimals = next(
            (n for n in range(7) if np.allclose(places, np.round(places, n), rtol=0, atol=1e-9)), 7
        )
        value = 0.0 if round(x, decimals) == 0.0 else x
        return self._manner.fixed(value, decimals)


def titled(title: str, unit: str) -> str:
    """Return an axis's title with its unit."""
    return f"{mathematical(title)} ({unit})" if unit else mathematical(title)


def mathematical(text: str) -> str:
    """Set symbols as mathematics: indices below, letters that stand for quantities slanted."""
    indexed = _INDEXED.sub(
        lambda found: (
            f"${found[1]}_{{{found[2]}}}$"
            if len(found[2]) == 1
            else f"${found[1]}_{{\\mathrm{{{found[2]}}}}}$"
        ),
        text,
    )
    return _LONE_SYMBOL.sub(r"$\1$", indexed)


_MAP_LEVELS: Final = 14
_SIGNED: Final = "RdBu_r"
_UNSIGNED: Final = "cividis"
_ARROWS: Final = (9, 5)
"""Number of panels, across and along."""
_MAP_INK: Final = "#202020"
_MAP_HEIGHT: Final = 53.0
_ARROW_REACH: Final = (0.6, 2.0 / 3.0)
"""Part of the grid that arrows cover, likewise."""


def draw_maps(figure: Figure, picture: Maps) -> Picture:
    """Draw the maps one below the other over the same ellipse."""
    drawing, frames = new_stacked_figure(
        len(picture.maps), height=8.0 + _MAP_HEIGHT * len(picture.maps)
    )
    for place, (one, axes) in enumerate(zip(picture.maps, frames, strict=True)):
        _draw_map(figure, picture, one, axes)
        last = place == len(frames) - 1
        _label_map(figure, picture, one, axes, last=last)
    return drawing


def _gridded(figure: Figure, name: str, count: int) -> Floats:
    return figure.column(name).numbers.reshape(count, -1)


def _draw_map(figure: Figure, picture: Maps, one: Map, axes: Axes) -> None:
    x, y, value = (_gridded(figure, n, picture.count) for n in (picture.x, picture.y, one.value))
    low, high = float(value.min()), float(value.max())
    parted = one.signed and low < 0.0 < high
    if parted:
        low, high = -max(-low, high), max(-low, high)
    levels = MaxNLocator(_MAP_LEVELS, symmetric=parted).tick_values(low, high)
    colours = _SIGNED if parted else _UNSIGNED
    filled = axes.contourf(x, y, value, levels=levels, cmap=colours)
    if parted:
        axes.contour(x, y, value, levels=[0.0], colors=_MAP_INK, linestyles="--", linewidths=1.2)
    for edge in (y[:, 0], y[:, -1]):
        axes.plot(x[:, 0], edge, color=_MAP_INK, linewidth=1.0)
    if one.arrows is not None:
        _draw_arrows(figure, picture, one.arrows, axes)
    bar = axes.figure.colorbar(filled, ax=axes, aspect=14.0, pad=0.02)
    bar.locator = MaxNLocator(6)
    bar.update_ticks()
    bar.ax.yaxis.set_major_formatter(Numbers(bar.ax.yaxis))
    bar.set_label(figure.column(one.value).unit)


def _draw_arrows(figure: Figure, picture: Maps, names: tuple[str, str], axes: Axes) -> None:
    """Show the direction at points of the grid, all arrows of one length."""
    x, y, across, along = (
        _gridded(figure, n, picture.count) for n in (picture.x, picture.y, *names)
    )
    rows, columns = (
        np.linspace((1.0 - reach) * (n - 1) / 2, (1.0 + reach) * (n - 1) / 2, k).round().astype(int)
        for n, k, reach in zip(x.shape, _ARROWS, _ARROW_REACH, strict=True)
    )
    at: Any = np.ix_(rows, columns)
    size = np.maximum(np.hypot(across[at], along[at]), np.finfo(np.float64).tiny)
    axes.quiver(
        x[at],
        y[at],
        across[at] / size,
        along[at] / size,
        color="white",
        edgecolor=_MAP_INK,
        linewidth=0.4,
        scale=26.0,
        width=0.005,
        pivot="middle",
        zorder=4.0,
    )


def _label_map(figure: Figure, picture: Maps, one: Map, axes: Axes, *, last: bool) -> None:
    x, y = figure.column(picture.x), figure.column(picture.y)
    axes.set_title(titled(str(one.title), ""), loc="left")
    axes.set_ylabel(titled(str(y.title), y.unit))
    if last:
        axes.set_xlabel(titled(str(x.title), x.unit))
    axes.set_xlim(1.04 * float(x.numbers.min()), 1.04 * float(x.numbers.max()))
    axes.set_ylim(1.1 * float(y.numbers.min()), 1.1 * float(y.numbers.max()))
    axes.grid(False)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(Numbers(axis))


_METADATA: Final[dict[str, dict[str, Any]]] = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": "Rolamento"},
}
"""Nothing that reveals when a picture was drawn, or with which release."""
_COLOURS: Final = 128
_DOTS: Final = 200.0
_MAX_LEGEND_COLUMNS: Final = 5
"""Height of a legend over a single panel."""
_INK: Final = "#303030"
_TURN: Final = 360.0
_SEEN: Final = 0.5 * _TURN + 5.0
_ROUNDING: Final = 1e-6
_NEAR_ZERO: Final = 0.02
"""Part of the x axis up to which it begins at zero."""
_SPARSE: Final = 0.18
"""Distance of markers over the axis's length, on a line that nothing else distinguishes."""


def rendered(figure: Figure, endings: Sequence[Ending]) -> dict[Ending, bytes]:
    """Draw a figure and return the content of its files; the same figure, the same bytes."""
    contents: dict[Ending, bytes] = {}
    with styled():
        picture = drawn(figure)
        for ending in endings:
            content = BytesIO()
            picture.savefig(content, format=ending, metadata=dict(_METADATA[ending]))
            contents[ending] = content.getvalue() if ending == "svg" else _fewer_colours(content)
    return contents


def _fewer_colours(content: BytesIO) -> bytes:
    """Keep as many colours as lines on white paper need: a third of the size."""
    small = BytesIO()
    with Image.open(content) as image:
        dots = image.info.get("dpi", (_DOTS, _DOTS))
        reduced = image.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
        reduced.save(small, "png", optimize=True, dpi=dots)
    return small.getvalue()


def drawn(figure: Figure) -> Picture:
    """Draw a figure."""
    with styled():
        if isinstance(figure.picture, Positions):
            return _positions(figure, figure.picture)
        if isinstance(figure.picture, Maps):
            return draw_maps(figure, figure.picture)
        return _curves(figure, figure.picture)


# --- lines ------------------------------------------------------------------


def _curves(figure: Figure, curves: Curves) -> Picture:
    picture, axes = new_figure(height=82.0 + 5.0 * _legend_rows(curves))
    axes.remove()
    every = picture.subplots(1, len(curves.panels), sharey=True, squeeze=False)[0]
    for panel, place in zip(curves.panels, every, strict=True):
        _draw_panel(figure, panel, place, first=place is every[0])
    if len(curves.panels) == 1:
        _add_legend(curves.panels[0], picture)
    else:
        for panel, place in zip(curves.panels, every, strict=True):
            _add_legend(panel, place)
    return picture


def _draw_panel(figure: Figure, panel: Panel, axes: Axes, *, first: bool) -> None:
    x = figure.column(panel.x)
    for line in panel.lines:
        _draw_line(figure, panel, line, axes)
    axes.set_xlabel(titled(str(x.title), x.unit))
    if first:
        axes.set_ylabel(titled(str(panel.y_title), panel.y_unit))
    low, high = float(np.nanmin(x.numbers)), float(np.nanmax(x.numbers))
    if panel.around:
        low, high = -0.5 * _TURN, 0.5 * _TURN
    if 0.0 < low < _NEAR_ZERO * high:
        low = 0.0
    axes.set_xlim(low, high)
    if panel.tick is not None:
        axes.xaxis.set_major_locator(MultipleLocator(panel.tick))
    drawn = np.concatenate([figure.column(line.y).numbers for line in panel.lines])
    drawn = drawn[np.isfinite(drawn)]
    if not panel.from_zero:
        axes.margins(y=0.06)
    elif float(drawn.min(initial=0.0)) >= -_ROUNDING * float(np.abs(drawn).max(initial=0.0)):
        axes.set_ylim(bottom=0.0)
    else:
        axes.axhline(0.0, color=_INK, linewidth=0.8, zorder=1.5)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(Numbers(axis))
    for axis, ticks in ((axes.xaxis, panel.x_ticks), (axes.yaxis, panel.y_ticks)):
        if ticks:
            words = [localised(word) for _, word in ticks]
            axis.set_ticks([place for place, _ in ticks], words)


def _draw_line(figure: Figure, panel: Panel, line: Line, axes: Axes) -> None:
    x, y = figure.column(panel.x).numbers, figure.column(line.y).numbers
    rows = _rows_of_line(figure, line)
    x, y = x[rows], y[rows]
    keywords = _look(line)
    if line.points:
        axes.plot(x, y, **keywords, clip_on=False, zorder=3.0)
        return
    if line.marked is None:
        marker = {} if line.dashed is None else _sparse_marker(line)
        axes.plot(x, y, **keywords, **marker)
        return
    at = np.isfinite(figure.column(line.marked).numbers[rows])
    if panel.around:
        x, y, at = np.concatenate([x - _TURN, x, x + _TURN]), np.tile(y, 3), np.tile(at, 3)
        seen = np.abs(x) <= _SEEN
        x, y, at = x[seen], y[seen], at[seen]
    axes.plot(x, y, **{**keywords, "linewidth": 1.0})
    at &= np.abs(x) <= 0.5 * _TURN + _ROUNDING
    marker = {"linestyle": "none", "marker": series(line.look).marker, "clip_on": False}
    axes.plot(x[at], y[at], color=keywords["color"], zorder=3.0, **marker)


def _rows_of_line(figure: Figure, line: Line) -> Any:
    if line.by is None:
        return slice(None)
    name, value = line.by
    return np.isclose(figure.column(name).numbers, value, rtol=1e-12, atol=1e-9)


def _look(line: Line) -> dict[str, Any]:
    style = series(line.look).keywords(markers=line.points)
    if line.points:
        style["linestyle"] = "none"
    elif line.dashed is not None:
        style["linestyle"] = "--" if line.dashed else "-"
    return style


def _sparse_marker(line: Line) -> dict[str, Any]:
    """Mark a line here and there, each of a family at other places."""
    start = 0.03 + 0.03 * line.look
    return {"marker": series(line.look).marker, "markevery": (start, _SPARSE), "markersize": 3.5}


# --- legends ----------------------------------------------------------------


def _legend_rows(curves: Curves) -> int:
    """Return how many rows the highest legend takes."""
    entries = max(
        sum(line.label is not None for line in panel.lines) + 2 * (panel.keys is not None)
        for panel in curves.panels
    )
    columns = _legend_columns(curves.panels[0], entries) if len(curves.panels) == 1 else 2
    return -(-entries // max(columns, 1))


def _legend_columns(panel: Panel, entries: int) -> int:
    """Return in how many columns the legend over a single panel stands."""
    if panel.legend_columns is not None:
        return panel.legend_columns
    return entries if entries <= _MAX_LEGEND_COLUMNS else _MAX_LEGEND_COLUMNS - 1


def _add_legend(panel: Panel, place: Picture | Axes) -> None:
    """Put the legend over the frame, where no data are; a line alone needs none."""
    handles = _legend_entries(panel)
    if not handles:
        return
    if isinstance(place, Picture):
        columns = _legend_columns(panel, len(handles))
        place.legend(handles=handles, loc="outside upper center", ncols=columns, handlelength=2.6)
    else:
        above = (0.0, 1.0)
        place.legend(
            handles=handles, loc="lower left", ncols=2, handlelength=2.6, bbox_to_anchor=above
        )


def _legend_entries(panel: Panel) -> list[Line2D]:
    handles = [
        _legend_entry(str(key), {"color": _INK, "linestyle": style})
        for key, style in zip(panel.keys or (), ("-", "--"), strict=False)
    ]
    for line in panel.lines:
        if line.label is None:
            continue
        look = _look(line)
        if line.marked is not None or line.dashed is not None:
            look["marker"] = series(line.look).marker
        handles.append(_legend_entry(str(line.label), look))
    return handles


def _legend_entry(label: str, look: dict[str, Any]) -> Line2D:
    return Line2D([], [], label=mathematical(label), **look)


# --- balls in their places --------------------------------------------------


def _positions(figure: Figure, picture: Positions) -> Picture:
    drawing, axes = new_figure(width=110.0, height=112.0)
    radius, ball = 0.5 * picture.pitch_diameter, 0.5 * picture.ball_diameter
    axes.set_aspect("equal")
    axes.set_axis_off()
    outline: dict[str, Any] = {"fill": False, "edgecolor": _INK, "linewidth": 1.0}
    for race, style in ((radius - ball, INNER), (radius + ball, OUTER)):
        axes.add_patch(Circle((0.0, 0.0), race, fill=False, edgecolor=style.color, linewidth=1.6))
    axes.add_patch(Circle((0.0, 0.0), radius, **{**outline, "linestyle": ":", "linewidth": 0.7}))
    for number, azimuth in zip(
        figure.column("ball").numbers, figure.column("azimuth").numbers, strict=True
    ):
        _draw_ball(axes, int(number), float(azimuth), radius, ball)
    reach = radius + 2.7 * ball
    _draw_axis_arrow(axes, (0.0, 0.45 * radius), "$z$, $F_{z}$", (0.06 * radius, -0.02 * radius))
    _draw_axis_arrow(axes, (0.45 * radius, 0.0), "$y$", (0.0, 0.07 * radius))
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    return drawing


def _draw_ball(axes: Axes, number: int, azimuth: float, radius: float, ball: float) -> None:
    # seen from +x: zero at the top, growing to the right, toward +y
    sine, cosine = np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth))
    place = radius * sine, radius * cosine
    axes.add_patch(Circle(place, ball, facecolor="#E8E8E8", edgecolor=_INK, linewidth=1.0))
    axes.text(*place, str(number), ha="center", va="center", fontsize=9.0)
    far = radius + 2.0 * ball
    text = localised(f"{azimuth:.1f}".removesuffix(".0")) + "°"
    axes.text(far * sine, far * cosine, text, ha="center", va="center", fontsize=7.5)


def _draw_axis_arrow(
    axes: Axes, tip: tuple[float, float], label: str, offset: tuple[float, float]
) -> None:
    arrow = {"arrowstyle": "-|>", "color": _INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", tip, (0.0, 0.0), arrowprops=arrow)
    axes.text(tip[0] + offset[0], tip[1] + offset[1], label, ha="left", va="bottom")
