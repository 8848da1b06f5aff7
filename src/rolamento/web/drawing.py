"""What the app's pictures are made of: traces, axes and whole pictures for Plotly.js.

A picture is plain data. Colours are names ("inner", "outer2", "grey") that the page turns into
those of its theme; what is alike in all pictures (fonts, margins, grid) the page adds.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import ceil, floor, inf, isfinite, log10
from typing import Any, Final, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from rolamento.geometry import Race
from rolamento.words import manner

__all__ = [
    "FAINT",
    "NUMBER",
    "Picture",
    "axis",
    "decades",
    "empty",
    "line",
    "look",
    "numbers",
    "picture",
    "reach",
    "rounded_up",
]

NUMBER: Final = ",.4~r"
"""How numbers are shown where a pointer is: four figures."""
FAINT: Final = 0.45
"""Opacity of what is shown though it does not hold."""
_STEPS: Final = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_MANY: Final = 20
_ROOM: Final = 1.03
_PARTS: Final = 5
"""Into which an axis that does not begin at zero is divided, at least."""
_THIN_SPACE: Final = "\u2009"
_DASHES: Final[dict[tuple[Race, int], str]] = {
    ("inner", 0): "solid",
    ("outer", 0): "dash",
    ("inner", 1): "dashdot",
    ("outer", 1): "dot",
}
_SYMBOLS: Final = ("circle", "square", "triangle-up", "diamond", "cross", "star")


class Picture(TypedDict):
    """A picture as the page gets it.

    data, layout: of Plotly.js, with names of colours. summary: what it says, in a sentence. empty:
    whether there is nothing to draw, and the summary says why. key: of pictures that may be drawn
    over one another without a new frame.
    """

    data: list[dict[str, Any]]
    layout: dict[str, Any]
    summary: str
    empty: bool


def picture(data: Sequence[dict[str, Any]], summary: str, **layout: Any) -> Picture:
    """Return a picture of traces; layout: its axes and what else Plotly.js calls so."""
    marks = {"separators": manner().mark + _THIN_SPACE}
    return {"data": list(data), "layout": {**layout, **marks}, "summary": summary, "empty": False}


def empty(why: str) -> Picture:
    """Return a picture without anything, that says why."""
    return {"data": [], "layout": {}, "summary": why, "empty": True}


def numbers(values: ArrayLike) -> list[float | None]:
    """Return numbers as JSON has them; None where there is none."""
    found = np.asarray(values, dtype=np.float64)
    return [value if isfinite(value) else None for value in found.tolist()]


def look(race: Race, case: int = 0, row: int = 0, count: int = 0) -> dict[str, Any]:
    """Return how the line of a race is drawn: colour and dashes show race and case, marks the row.

    case: 0 or 1, of two that are compared. count: of marks; many are smaller.
    """
    color = race if case == 0 else f"{race}2"
    symbol = _SYMBOLS[row % len(_SYMBOLS)]
    marker = {"symbol": f"{symbol}-open" if case else symbol, "size": 7 if count <= _MANY else 4,
              "color": color}  # fmt: skip
    return {"line": {"color": color, "dash": _DASHES[race, case], "width": 2}, "marker": marker}


def line(x: ArrayLike, y: ArrayLike, name: str, hover: str, **more: Any) -> dict[str, Any]:
    """Return a line; hover: how a point of it is labelled, a template of Plotly.js."""
    return {
        "type": "scatter",
        "mode": "lines",
        "x": numbers(x),
        "y": numbers(y),
        "name": name,
        "hovertemplate": f"{hover}<extra>%{{fullData.name}}</extra>",
        **more,
    }


def axis(title: str, limits: Iterable[float] | None = None, **more: Any) -> dict[str, Any]:
    """Return an axis between two limits."""
    known = {} if limits is None else {"range": list(limits)}
    return {"title": {"text": title}, **known, **more}


def rounded_up(value: float) -> float:
    """Return the least round number that is not below a positive one."""
    if not (isfinite(value) and value > 0.0):
        return 1.0
    power = 10.0 ** floor(log10(value))
    return next(step * power for step in _STEPS if step * power >= value * (1.0 - 1e-12))


def reach(*values: ArrayLike, zero: bool = False, least: float = 0.0) -> list[float]:
    """Return round limits with room for all values; zero: from there on; least: so far apart.

    They stay where they are while a slider moves a little.
    """
    found = np.concatenate([np.ravel(np.asarray(one, dtype=np.float64)) for one in values])
    found = found[np.isfinite(found)]
    if not found.size:
        return [0.0, 1.0]
    low, high = float(found.min()), float(found.max())
    if zero and low >= 0.0:
        return [0.0, rounded_up(_ROOM * high)]
    if zero:
        return [-rounded_up(-_ROOM * low), rounded_up(_ROOM * high) if high > 0.0 else 0.0]
    step = rounded_up(max(high - low, 1e-2 * max(abs(low), abs(high)), least, 1e-9) / _PARTS)
    room = 0.1 * step
    return [step * floor((low - room) / step), step * ceil((high + room) / step)]


def decades(*values: ArrayLike) -> list[float] | None:
    """Return the logarithms of round limits around all positive values; None without any."""
    least, greatest = inf, 0.0
    for one in values:
        found = np.asarray(one, dtype=np.float64)
        found = found[np.isfinite(found) & (found > 0.0)]
        if found.size:
            least, greatest = min(least, float(found.min())), max(greatest, float(found.max()))
    if not greatest:
        return None
    low, high = log10(least), log10(greatest)
    return [floor(2.0 * low - 0.1) / 2.0, ceil(2.0 * high + 0.1) / 2.0]
