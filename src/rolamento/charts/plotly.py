"""Charts for the page: traces, axes and whole pictures for Plotly.js.

A picture is plain data. Colours are names of the palette ("inner", "outer2", "grey") that the page
turns into those of its theme; what is alike in all pictures (fonts, margins, grid) the page adds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import isfinite
from typing import Any, Final, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.charts.axes_units import DEGREE
from rolamento.charts.contacts import AROUND
from rolamento.charts.limits import decades, reach
from rolamento.charts.palette import Look
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
    Side,
    Spread,
    widened,
)
from rolamento.words import manner

__all__ = ["Picture", "empty", "numbers", "picture"]

_NUMBER: Final = ",.4~r"
"""How numbers are shown where a pointer is: four figures."""
_MANY: Final = 20
_GAP: Final = 0.06
"""Part of its share that a panel leaves to the next."""
_DOWN: Final = ([0.54, 1.0], [0.0, 0.46])
"""Where panels below one another lie."""
_NAMED: Final = 0.07
"""Part of the frame from which on a zone has room for its name."""
_CLEAR: Final = "\u2003"
"""A space as wide as a letter is high."""
_THIN_SPACE: Final = "\u2009"
_MODES: Final = {
    "line": "lines", "points": "markers", "both": "lines+markers", "sparse": "lines+markers",
}  # fmt: skip
_FEW: Final = 6
"""Marks along a line of a few."""
_DASHES: Final = {"dashdotdot": "10px,2px,2px,2px,2px,2px", "fine": "2px,2px"}
_MARKS: Final = {"tick": "line-ns", "thin": "x-thin", "query": "asterisk"}
_CORNERS: Final = np.linspace(0.0, 2.0 * np.pi, 25)
_GROUP: Final = 0.8
"""Part of a category that its bars fill, as Plotly has it."""
_BEFORE_END: Final = 12
"""Pixels from the end of a bar to its break mark."""
_FINE: Final = 4
"""Decimals of the outline of an ellipse."""
_SIDES: Final = {"left": "middle left", "right": "middle right", "above": "top center",
                "on": "middle center", "along": "bottom left"}  # fmt: skip


class Picture(TypedDict):
    """A picture as the page gets it.

    data, layout: of Plotly.js, with names of colours. summary: what it says, in a sentence. empty:
    whether there is nothing to draw, and the summary says why.
    """

    data: list[dict[str, Any]]
    layout: dict[str, Any]
    summary: str
    empty: bool


def empty(why: str) -> Picture:
    """Return a picture without anything, that says why."""
    return {"data": [], "layout": {}, "summary": why, "empty": True}


def picture(*panels: Chart, down: bool = False, conclusion: str = "") -> Picture:
    """Return charts as one picture for the page.

    Parameters
    ----------
    panels
        Side by side, with the first one's upright axis.
    down
        Whether they, at most two, lie below one another instead, with the first one's axis across.
    conclusion
        What they say together; by default what the first one says.
    """
    first = panels[0]
    said = conclusion or first.says
    if not any(panel.series for panel in panels):
        return empty(said)
    data: list[dict[str, Any]] = []
    layout: dict[str, Any] = {}
    if first.polar:
        data, layout = _traces(first, []), {"polar": _polar_axes(first)}
    else:
        data, layout = _in_panels(panels, down)
    if first.outlines:
        layout["meta"] = {"drawing": True}
    if any(isinstance(one, Bars) for one in first.series):
        alone = any(isinstance(one, Bars) and one.start is not None for one in first.series)
        layout["barmode"] = "stack" if first.stacked else "overlay" if alone else "group"
    layout["separators"] = manner().mark + _THIN_SPACE
    return {"data": data, "layout": layout, "summary": said, "empty": False}


def _in_panels(panels: Sequence[Chart], down: bool) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    first, count = panels[0], len(panels)
    across, upright = _limits(panels, "x"), _limits(panels, "y")
    layout: dict[str, Any] = {"xaxis": _axis(first.x, across), "yaxis": _axis(first.y, upright)}
    data: list[dict[str, Any]] = []
    for place, panel in enumerate(panels):
        number = "" if place == 0 else str(place + 1)
        x, y = _limits([panel], "x") if not down else across, upright
        if down and count > 1:
            layout[f"yaxis{number}"] = {**_axis(panel.y, upright), "domain": _DOWN[place]}
        elif count > 1:
            ends = [place / count, (place + 1.0 - _GAP) / count]
            layout[f"xaxis{number}"] = {**_axis(panel.x, x), "domain": ends}
        where = {"yaxis" if down else "xaxis": f"{'y' if down else 'x'}{number}"} if number else {}
        data += [{**trace, **where} for trace in _traces(panel, [x, y])]
    if down and count > 1:
        layout["xaxis"] |= {"anchor": f"y{count}", "constrain": "domain"}
    if first.zones:
        layout |= _zones(first, {"x": across, "y": upright})
    if first.y.categories:
        lines = [_line_below(mark) for mark in first.marks if mark.axis == "x"]
        layout["shapes"] = layout.get("shapes", []) + lines
    if breaks := list(_breaks(first, across)):
        layout["annotations"] = layout.get("annotations", []) + breaks
    return data, layout


# --- axes -----------------------------------------------------------------------------------------


def _limits(panels: Sequence[Chart], axis: str) -> tuple[float, float]:
    """Return where an axis begins and ends, which holds what all panels have."""
    own: Axis = getattr(panels[0], axis)
    if own.limits is not None:
        return own.limits
    values = [values for panel in panels for values in _values(panel, axis)]
    if own.log:
        powers = decades(*values) or [0.0, 1.0]
        return 10.0 ** powers[0], 10.0 ** powers[1]
    low, high = reach(*values, zero=own.zero, least=own.least) if values else (0.0, 1.0)
    return low, high


def _values(chart: Chart, axis: str) -> Iterator[ArrayLike]:
    for one in chart.series:
        if isinstance(one, Bars):
            yield one.values if axis == "x" else one.places
        elif isinstance(one, Line | Labels) and one.height is not None and axis == "y":
            continue
        elif isinstance(one, Spread) and axis == "y":
            yield from (one.low, one.high)
        else:
            yield getattr(one, axis)
    for mark in chart.marks:
        if mark.axis == axis:
            yield [mark.at]


def _axis(own: Axis, limits: tuple[float, float]) -> dict[str, Any]:
    known: dict[str, Any] = {"title": {"text": own.title}}
    if own.categories:
        return {
            "autorange": "reversed", "automargin": True, "ticksuffix": "  ",
            "categoryorder": "array", "categoryarray": list(own.categories),
        }  # fmt: skip
    known["range"] = [float(end) for end in (np.log10(limits) if own.log else limits)]
    if own.log:
        known["type"] = "log"
    if own.whole:
        known["tickformat"] = "d"
    if own.step:
        known["dtick"] = own.step
        if not own.log:
            known["tick0"] = 0
    if own.ticks:
        places, texts = zip(*own.ticks, strict=True)
        known |= {"tickmode": "array", "tickvals": list(places),
                  "ticktext": [text.replace("\n", "<br>") for text in texts]}  # fmt: skip
    if own.equal:
        known |= {"scaleanchor": "x", "constrain": "domain"}
    if own.hidden:
        known |= {"visible": False, "fixedrange": True}
    return known


def _polar_axes(chart: Chart) -> dict[str, Any]:
    names = [name.replace("\n", "<br>") for name in AROUND]
    return {
        "angularaxis": {
            "rotation": 90, "direction": "clockwise", "tickmode": "array",
            "tickvals": [45 * place for place in range(len(names))], "ticktext": names,
        },
        "radialaxis": {
            **_axis(chart.y, _limits([chart], "y")), "angle": 90.0 - chart.numbers_at,
            "tickangle": 0, "nticks": 5,
        },
    }  # fmt: skip


def _zones(chart: Chart, limits: Mapping[str, tuple[float, float]]) -> dict[str, Any]:
    """Return bands below all, each with its name where there is room for it."""
    bands, names = [], []
    for zone in chart.zones:
        own, other = ("x", "y") if zone.axis == "x" else ("y", "x")
        first, last = limits[own]
        low, high = max(zone.low, first), min(zone.high, last)
        if low >= high:
            continue
        bands.append(
            {"type": "rect", f"{other}ref": "paper", f"{other}0": 0, f"{other}1": 1,
             f"{own}0": low, f"{own}1": high, "layer": "below", "line": {"width": 0},
             "fillcolor": f"{zone.color}-band"}
        )  # fmt: skip
        axis = chart.x if zone.axis == "x" else chart.y
        if high - low > _NAMED * (last - first) or axis.log:
            end = float(np.log10(high)) if axis.log else high
            names.append(
                {"text": zone.name, f"{other}ref": "paper", other: 1, own: end, "xanchor": "right",
                 "yanchor": "top", "showarrow": False}
            )  # fmt: skip
    return {"shapes": bands, "annotations": names}


# --- series ---------------------------------------------------------------------------------------


def _traces(chart: Chart, limits: Sequence[tuple[float, float]]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = []
    for one in chart.series:
        if isinstance(one, Bars):
            found.append(_bars(chart, one, limits[0]))
        elif isinstance(one, Spread):
            found.append(_spread(chart, one))
        elif isinstance(one, Ellipses):
            found.append(_ellipses(chart, one))
        elif isinstance(one, Labels):
            found.append(_labels(chart, one, limits))
        elif isinstance(one, Field):
            found.append(_field(one))
        elif isinstance(one, Arrows):
            turned = np.degrees(np.arctan2(one.across, one.along))
            marker = {"symbol": "arrow", "angle": numbers(turned), "size": 9, "color": "white"}
            found.append({"type": "scatter", "mode": "markers", "hoverinfo": "skip",
                          "x": numbers(one.x), "y": numbers(one.y), "marker": marker})  # fmt: skip
        elif one.valid is not None and not one.valid.all():
            found += _judged(chart, one, one.valid, limits)
        else:
            found.append(_line(chart, one, limits))
    return found + [_mark(chart, mark, limits) for mark in chart.marks]


def numbers(values: ArrayLike) -> list[float | None]:
    """Return numbers as JSON has them; None where there is none."""
    found = np.asarray(values, dtype=np.float64)
    return [value if isfinite(value) else None for value in found.tolist()]


def _hover(chart: Chart, *, across: bool = True) -> str:
    """Return how a point is labelled, as a template: both numbers, or the upright one alone."""
    first, second = ("theta", "r") if chart.polar else ("x", "y")
    up = chart.y.with_unit(f"%{{{second}:{_NUMBER}}}")
    if not across or chart.outlines or chart.x.hidden:
        return up
    unit = DEGREE.symbol if chart.polar else chart.x.unit
    return f"{Axis(unit=unit).with_unit(f'%{{{first}:{_NUMBER}}}')}, {up}"


def _named(hover: str) -> str:
    return f"{hover}<extra>%{{fullData.name}}</extra>"


def _stroke(look: Look) -> dict[str, Any]:
    return {"color": look.color, "dash": _DASHES.get(look.dash, look.dash), "width": 2 * look.width}


def _line(chart: Chart, line: Line, limits: Sequence[tuple[float, float]]) -> dict[str, Any]:
    names = ("theta", "r") if chart.polar else ("x", "y")
    heights: list[Any] = numbers(_raised(chart, line, limits))
    if chart.y.categories:
        heights = [chart.y.categories[int(place)] for place in line.y]
    trace: dict[str, Any] = {
        "type": "scatterpolar" if chart.polar else "scatter",
        "mode": _MODES[line.form],
        names[0]: numbers(line.x),
        names[1]: heights,
        "name": line.name,
        "hovertemplate": _named(_hover(chart)),
    }
    if line.form != "points":
        trace["line"] = _stroke(line.look)
    if line.form != "line":
        trace["marker"] = _marker(line)
    if line.form == "sparse":
        trace["marker"]["maxdisplayed"] = _FEW
    if line.look.opacity < 1.0:
        trace["opacity"] = line.look.opacity
    if line.form == "points":
        trace["cliponaxis"] = False
    if line.wrapped != (0, 0):
        begin, end = line.wrapped
        trace["meta"] = {**({"from": begin} if begin else {}), **({"to": -end} if end else {})}
    if line.texts:
        trace["text"] = list(line.texts)
        trace["hovertemplate"] = _texts_hover(chart, line)
    if line.height is not None:
        trace["meta"] = {"told": True}
    if line.filled:
        trace |= {"fill": "toself", "fillcolor": f"{line.look.color}-band"}
    return trace


def _raised(
    chart: Chart, own: Line | Labels, limits: Sequence[tuple[float, float]]
) -> NDArray[np.float64]:
    """Return upright numbers; of what stands at a height of the frame, those there."""
    if own.height is None:
        return own.y
    low, high = limits[1] if limits else (0.0, 1.0)
    if chart.y.log:
        return np.full(len(own.x), low * (high / low) ** own.height)
    return np.full(len(own.x), low + own.height * (high - low))


def _texts_hover(chart: Chart, line: Line) -> str:
    if line.form != "points":
        return "%{text}<extra></extra>"
    if chart.y.categories:
        return _named(chart.x.with_unit("%{text}: %{x:,.5~r}"))
    return f"%{{x:{_NUMBER}}}: %{{text}}<extra></extra>"


def _marker(line: Line) -> dict[str, Any]:
    look = line.look
    symbol = _MARKS.get(look.mark, look.mark)
    open_ = look.hollow or look.mark in _MARKS
    size: float = 7 if len(line.x) <= _MANY else 4
    if line.form == "points":
        size = 18 if look.mark == "tick" else round(8 * look.width)
    found = {"symbol": f"{symbol}-open" if open_ else symbol, "size": size, "color": look.color}
    if line.form == "points" and look.mark != "thin":
        width = 3 if look.mark == "tick" else 2 if look.hollow else 1.5
        found["line"] = {"width": width, "color": look.color if open_ else "ink"}
    return found


def _judged(
    chart: Chart, line: Line, valid: NDArray[np.bool_], limits: Sequence[tuple[float, float]]
) -> list[dict[str, Any]]:
    """Return a line where it holds, and faintly where it does not."""
    faint = {"opacity": FAINT, "name": "" if valid.any() else line.name}
    return [
        {**_line(chart, line, limits), "y": numbers(np.where(widened(own), line.y, np.nan)), **more}
        for own, more in ((valid, {}), (~valid, faint))
        if own.any()
    ]


def _spread(chart: Chart, spread: Spread) -> dict[str, Any]:
    """Return the outline of a band, up and back."""
    color = spread.look.color
    return {
        "type": "scatter", "mode": "lines", "name": spread.name, "fill": "toself",
        "x": numbers(np.r_[spread.x, spread.x[::-1]]),
        "y": numbers(np.r_[spread.high, spread.low[::-1]]),
        "hovertemplate": _named(_hover(chart)), "line": {"color": color, "width": 0},
        "fillcolor": color if spread.solid else f"{color}-band",
    }  # fmt: skip


def _bars(chart: Chart, bars: Bars, limits: tuple[float, float]) -> dict[str, Any]:
    found: dict[str, Any] = {
        "type": "bar",
        "orientation": "h",
        "x": numbers(np.where(np.isposinf(bars.values), limits[1], bars.values)),
        "y": [chart.y.categories[place] for place in bars.places],
        "name": bars.name,
        "hovertemplate": _named(f"%{{y}}: {chart.x.with_unit(f'%{{x:{_NUMBER}}}')}"),
        "marker": {"color": bars.look.color},
    }
    if bars.start is not None:
        found |= {"base": numbers(bars.start), "x": numbers(bars.values - bars.start)}
    if bars.texts:
        found |= {"text": list(bars.texts), "textposition": "auto", "insidetextanchor": "start",
                  "textangle": 0}  # fmt: skip
        found["hovertemplate"] = _named(f"%{{y}}: {chart.x.with_unit('%{text}')}")
    if bars.look.opacity < 1.0:
        found["marker"]["opacity"] = bars.look.opacity
    if bars.valid:
        found["marker"]["opacity"] = [1.0 if fine else FAINT for fine in bars.valid]
    return found


def _breaks(chart: Chart, across: tuple[float, float]) -> Iterator[dict[str, Any]]:
    """Yield a break mark at the end of each bar that goes beyond the axis."""
    groups = [one for one in chart.series if isinstance(one, Bars)]
    thick = _GROUP / len(groups) if groups else 0.0
    end = float(np.log10(across[1])) if chart.x.log else across[1]
    for order, one in enumerate(groups):
        shift = thick * (order - 0.5 * (len(groups) - 1))
        for place, value in zip(one.places, one.values.tolist(), strict=True):
            if value > across[1]:
                yield {"x": end, "y": place + shift, "text": BREAK, "showarrow": False,
                       "xshift": -_BEFORE_END, "bgcolor": "paper", "borderpad": 0}  # fmt: skip


def _ellipses(chart: Chart, own: Ellipses) -> dict[str, Any]:
    """Return their outlines, one after the other."""
    gap = np.full((len(own.x), 1), np.nan)
    x = own.x[:, np.newaxis] + own.half_width[:, np.newaxis] * np.cos(_CORNERS)
    y = own.y[:, np.newaxis] + own.half_height[:, np.newaxis] * np.sin(_CORNERS)
    fill = {"fill": "toself", "fillcolor": f"{own.look.color}-band"} if own.filled else {}
    return {
        "type": "scatter", "mode": "lines", "name": own.name,
        "x": numbers(np.round(np.hstack([x, gap]).ravel(), _FINE)),
        "y": numbers(np.round(np.hstack([y, gap]).ravel(), _FINE)),
        "hovertemplate": _named(_hover(chart)), "line": _stroke(own.look), **fill,
    }  # fmt: skip


def _labels(chart: Chart, labels: Labels, limits: Sequence[tuple[float, float]]) -> dict[str, Any]:
    return {
        "type": "scatter", "mode": "text", "hoverinfo": "skip",
        "x": numbers(labels.x), "y": numbers(_raised(chart, labels, limits)),
        "text": [_aside(text, side) for text, side in zip(labels.texts, labels.sides, strict=True)],
        "textposition": [_SIDES[side] for side in labels.sides],
        **({"textfont": {"color": labels.color}} if labels.color != "ink" else {}),
    }  # fmt: skip


def _field(own: Field) -> dict[str, Any]:
    """Return its cells as squares, its points as they are, coloured by their numbers."""
    x, y = own.x, own.y
    if x.ndim == 1:
        x, y = np.meshgrid(0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]))
    marker: dict[str, Any] = {
        "symbol": "square", "color": numbers(own.values.ravel()), "showscale": True,
        "colorscale": "RdBu" if own.signed else "Cividis", "size": 9,
        "colorbar": {"title": {"text": own.scale.title, "side": "right"}},
        **({"cmid": 0.0} if own.signed else {}),
    }  # fmt: skip
    return {
        "type": "scatter", "mode": "markers", "name": own.missing, "showlegend": False,
        "x": numbers(np.ravel(x)), "y": numbers(y.ravel()), "marker": marker,
        "hovertemplate": f"{own.scale.with_unit(f'%{{marker.color:{_NUMBER}}}')}<extra></extra>",
    }  # fmt: skip


def _aside(text: str, side: Side) -> str:
    """Return a label, its lines clear of what it stands beside."""
    before, after = {"right": (_CLEAR, ""), "left": ("", _CLEAR)}.get(side, ("", ""))
    return "<br>".join(f"{before}{line}{after}" for line in text.split("\n"))


def _line_below(mark: Mark) -> dict[str, Any]:
    """Return a mark as a line below bars, whose texts stay legible; `_mark` names it."""
    return {"type": "line", "layer": "below", "x0": mark.at, "x1": mark.at, "yref": "paper",
            "y0": 0, "y1": 1, "line": _stroke(mark.look)}  # fmt: skip


def _mark(chart: Chart, mark: Mark, limits: Sequence[tuple[float, float]]) -> dict[str, Any]:
    """Return a line from end to end of the frame, in the legend as any other."""
    names = chart.y.categories
    ends: list[Any] = list(limits[0] if mark.axis == "y" else limits[1])
    below = names and mark.axis == "x"
    if below:
        ends = [names[0], names[-1]]
    at = [mark.at, mark.at]
    own = chart.y if mark.axis == "y" else chart.x
    return {
        **({"visible": "legendonly"} if below else {}),
        "type": "scatter", "mode": "lines", "name": mark.name, "line": _stroke(mark.look),
        "x": ends if mark.axis == "y" else at, "y": at if mark.axis == "y" else ends,
        "hovertemplate": _named(own.with_unit(f"%{{{mark.axis}:{_NUMBER}}}")),
    }  # fmt: skip
