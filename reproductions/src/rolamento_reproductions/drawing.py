"""How a figure of a reproduction is drawn, from nothing but its columns: as charts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from io import BytesIO
from typing import Any, Final

import numpy as np
from matplotlib.figure import Figure as Picture
from PIL import Image

from rolamento.charts import (
    Arrows,
    Axis,
    Chart,
    Ellipses,
    Field,
    Labels,
    Look,
    Mark,
    key,
    series_look,
)
from rolamento.charts import Line as Drawn
from rolamento.charts.drawing import draw
from rolamento.charts.frame import panels
from rolamento.charts.record import Side
from rolamento.charts.style import new_figure, styled
from rolamento.charts.texts import mathematical
from rolamento.document.picture import picture_bytes
from rolamento_reproductions.record import (
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

_COLOURS: Final = 128
_DOTS: Final = 200.0
_TURN: Final = 360.0
_SEEN: Final = 0.5 * _TURN + 5.0
_ROUNDING: Final = 1e-6
_NEAR_ZERO: Final = 0.02
"""Part of the x axis up to which it begins at zero."""
_ABREAST: Final = 3
"""Names that stand beside each other over a frame, about."""
_MAP_LEVELS: Final = 20
_MAP_HEIGHT: Final = 53.0
_ARROWS: Final = (9, 5)
"""Their number, across and along."""
_ARROW_REACH: Final = (0.6, 2.0 / 3.0)
"""Part of the grid that arrows cover, likewise."""
_INK: Final = Look("ink", width=0.7)


def rendered(figure: Figure, endings: Sequence[Ending]) -> dict[Ending, bytes]:
    """Draw a figure and return the content of its files; the same figure, the same bytes."""
    picture = drawn(figure)
    contents: dict[Ending, bytes] = {}
    for ending in endings:
        content = picture_bytes(picture, ending)
        contents[ending] = content if ending == "svg" else _fewer_colours(content)
    return contents


def _fewer_colours(content: bytes) -> bytes:
    """Keep as many colours as lines on white paper need: a third of the size."""
    small = BytesIO()
    with Image.open(BytesIO(content)) as image:
        reduced = image.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
        reduced.save(small, "png", optimize=True, dpi=(_DOTS, _DOTS))
    return small.getvalue()


def drawn(figure: Figure) -> Picture:
    """Draw a figure: panels of lines side by side, maps one below the other."""
    charts, shown = charts_of(figure), figure.picture
    with styled():
        if isinstance(shown, Maps):
            picture = panels(*(partial(draw, one) for one in charts),
                             height=8.0 + _MAP_HEIGHT * len(charts))  # fmt: skip
            for axes, one in zip(picture.axes, charts, strict=False):
                axes.set_title(mathematical(one.title), loc="left")
            return picture
        if isinstance(shown, Positions):
            picture, axes = new_figure(width=110.0, height=112.0)
            draw(charts[0], axes)
            return picture
        names = max(sum(bool(line.name) for line in one.lines) for one in charts)
        rows = -(-names // (_ABREAST if len(charts) == 1 else 2))
        picture, alone = new_figure(height=82.0 + 5.0 * rows)
        alone.remove()
        every = picture.subplots(1, len(charts), sharey=True, squeeze=False)[0]
        for chart, axes in zip(charts, every, strict=True):
            draw(chart, axes)
            if axes is not every[0]:
                axes.set_ylabel("")
    return picture


def charts_of(figure: Figure) -> tuple[Chart, ...]:
    """Return the charts of a figure: a panel each, or a map."""
    shown = figure.picture
    if isinstance(shown, Positions):
        return (_places_of_balls(figure, shown),)
    if isinstance(shown, Maps):
        return tuple(_map(figure, shown, one) for one in shown.maps)
    return tuple(_panel(figure, panel) for panel in shown.panels)


# --- lines ------------------------------------------------------------------


def _panel(figure: Figure, panel: Panel) -> Chart:
    x = figure.column(panel.x)
    low, high = float(np.nanmin(x.numbers)), float(np.nanmax(x.numbers))
    if panel.around:
        low, high = -0.5 * _TURN, 0.5 * _TURN
    if 0.0 < low < _NEAR_ZERO * high:
        low = 0.0
    upright = np.concatenate([figure.column(line.y).numbers for line in panel.lines])
    upright = upright[np.isfinite(upright)]
    foot = -_ROUNDING * float(np.abs(upright).max(initial=0.0))
    above = float(upright.min(initial=0.0)) >= foot
    keys = [
        key(str(name), Look("ink", dash))
        for name, dash in zip(panel.keys or (), ("solid", "dash"), strict=False)
    ]
    lines = [one for line in panel.lines for one in _line(figure, panel, line)]
    x_ticks, y_ticks = (
        tuple((place, localised(word)) for place, word in ticks)
        for ticks in (panel.x_ticks, panel.y_ticks)
    )
    return Chart(
        (*keys, *lines),
        Axis(str(x.title), x.unit or "–", (low, high), ticks=x_ticks, step=panel.tick or 0.0),
        Axis(str(panel.y_title), panel.y_unit or "–", zero=panel.from_zero and above,
             ticks=y_ticks),
        title=str(figure.caption),
        marks=(Mark(0.0, "", Look("ink", width=0.55)),) * (panel.from_zero and not above),
        symbols=True,
    )  # fmt: skip


def _line(figure: Figure, panel: Panel, line: Line) -> Iterator[Drawn]:
    """Yield a line, and the marks on it."""
    x, y = figure.column(panel.x).numbers, figure.column(line.y).numbers
    rows = _rows_of(figure, line)
    x, y, name, look = x[rows], y[rows], str(line.label or ""), series_look(line.look)
    if line.dashed is not None:
        look = Look(look.color, "dash" if line.dashed else "solid", look.mark)
    if line.points:
        yield Drawn(x, y, name, replace(look, width=0.75), "points")
    elif line.marked is None:
        yield Drawn(x, y, name, look, "line" if line.dashed is None else "sparse")
    else:
        at = np.isfinite(figure.column(line.marked).numbers[rows])
        if panel.around:
            x, y, at = np.concatenate([x - _TURN, x, x + _TURN]), np.tile(y, 3), np.tile(at, 3)
            seen = np.abs(x) <= _SEEN
            x, y, at = x[seen], y[seen], at[seen]
        if name:
            yield key(name, look, "both")
        yield Drawn(x, y, "", Look(look.color, look.dash, width=0.7))
        at &= np.abs(x) <= 0.5 * _TURN + _ROUNDING
        yield Drawn(x[at], y[at], "", Look(look.color, mark=look.mark, width=0.7), "points")


def _rows_of(figure: Figure, line: Line) -> Any:
    if line.by is None:
        return slice(None)
    name, value = line.by
    return np.isclose(figure.column(name).numbers, value, rtol=1e-12, atol=1e-9)


# --- maps -------------------------------------------------------------------


def _map(figure: Figure, maps: Maps, one: Map) -> Chart:
    """Return a field over an ellipse, its edge, where it is zero, and directions."""
    grid = partial(_gridded, figure, maps)
    x, y, value = grid(maps.x), grid(maps.y), grid(one.value)
    across, upright, scale = (figure.column(name) for name in (maps.x, maps.y, one.value))
    series: list[Field | Drawn | Arrows] = [
        Field(x, y, value, Axis(label=scale.unit), _MAP_LEVELS, one.signed)
    ]
    if one.signed and value.min() < 0.0 < value.max():
        from contourpy import contour_generator

        zero = contour_generator(x, y, value).lines(0.0)
        lines = (np.asarray(line).T for line in zero)
        series += [Drawn(line[0], line[1], "", Look("ink", "dash", width=0.85)) for line in lines]
    series += [Drawn(x[:, 0], y[:, edge], "", _INK) for edge in (0, -1)]
    if one.arrows is not None:
        places = (
            np.linspace((1.0 - reach) * (n - 1) / 2, (1.0 + reach) * (n - 1) / 2, k)
            for n, k, reach in zip(x.shape, _ARROWS, _ARROW_REACH, strict=True)
        )
        at: Any = np.ix_(*(place.round().astype(int) for place in places))
        series.append(Arrows(*(part[at].ravel() for part in (x, y, *map(grid, one.arrows)))))
    return Chart(
        tuple(series),
        Axis(str(across.title), across.unit, (1.04 * float(x.min()), 1.04 * float(x.max()))),
        Axis(str(upright.title), upright.unit, (1.1 * float(y.min()), 1.1 * float(y.max()))),
        title=str(one.title),
        symbols=True,
    )


def _gridded(figure: Figure, maps: Maps, name: str) -> Floats:
    return figure.column(name).numbers.reshape(maps.count, -1)


# --- balls in their places --------------------------------------------------


def _places_of_balls(figure: Figure, shown: Positions) -> Chart:
    """Return balls between the races, seen from +x: zero at the top, growing toward +y."""
    radius, ball = 0.5 * shown.pitch_diameter, 0.5 * shown.ball_diameter
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    circles = (
        Drawn(size * np.sin(turn), size * np.cos(turn), "", look)
        for size, look in (
            (radius - ball, Look("inner", width=1.15)),
            (radius + ball, Look("outer", width=1.15)),
            (radius, Look("ink", "dot", width=0.5)),
        )
    )
    numbers, azimuth = (figure.column(name).numbers for name in ("ball", "azimuth"))
    sine, cosine = np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth))
    wide, far = np.full(len(azimuth), ball), radius + 2.0 * ball
    sides: list[Side] = ["on"] * len(azimuth)
    on = tuple(sides)
    angles = tuple(localised(f"{angle:.1f}".removesuffix(".0")) + "°" for angle in azimuth)
    names = tuple(f"{number:.0f}" for number in numbers)
    tip, foot = np.array([0.45 * radius]), np.zeros(1)
    reach = (-radius - 2.7 * ball, radius + 2.7 * ball)
    return Chart(
        (
            *circles,
            Ellipses(radius * sine, radius * cosine, wide, wide, "", Look("grey"), filled=False),
            Labels(radius * sine, radius * cosine, names, on),
            Labels(far * sine, far * cosine, angles, on),
            Drawn(np.append(foot, foot), np.append(foot, tip), "", _INK),
            Drawn(np.append(foot, tip), np.append(foot, foot), "", _INK),
            Drawn(foot, tip, "", Look("ink", mark="triangle-up"), "points"),
            Drawn(tip, foot, "", Look("ink", mark="triangle-right"), "points"),
            Labels(np.append(foot, tip), np.append(tip, foot), ("z, F_z", "y"), ("right", "above")),
        ),
        Axis(limits=reach, hidden=True),
        Axis(limits=reach, hidden=True, equal=True),
        title=str(figure.caption),
        conclusion=", ".join(map(" ".join, zip(names, angles, strict=True))),
        outlines=True,
        symbols=True,
    )
