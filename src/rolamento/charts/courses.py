"""What the numbers of a chart show, in words: whether a line rises, falls or turns, and where."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.texts import number
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.charts.record import Axis

__all__ = ["course", "courses", "crossing", "extremes", "peak"]

Floats = NDArray[np.float64]
Points = tuple[str, Floats, Floats]
"""Name, places and numbers."""

_FIGURES: Final = 3
_MOST: Final = 3
"""Lines of which each has its words; of more only the highest and the lowest point are named."""
_STILL: Final = 1e-3
"""Part of the magnitude within which numbers stay the same."""
_ROUNDING: Final = 1e-9
"""Magnitude in units that people read, below which a number is nothing."""
_TURN: Final = 0.02
"""Part of its extent by which a line exceeds both ends where it turns."""


def course(name: str, x: Floats, y: Floats, across: Axis, upright: Axis) -> str:
    """Return how numbers run along an axis; empty without any that is finite.

    Parameters
    ----------
    name
        Of the line; by default that of its quantity.
    x, y
        (points,), in the units of the axes.
    across, upright
        The axes.

    >>> from rolamento.charts.record import Axis
    >>> speed, power = Axis("Speed", "rpm"), Axis("Power", "W")
    >>> course("", np.array([0.0, 50.0, 100.0]), np.array([1.0, 2.0, 5.0]), speed, power)
    'Power rises from 1 W at 0 rpm to 5 W at 100 rpm'
    """
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if not y.size:
        return ""
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    what = name or upright.name or upright.title

    def at(place: int) -> dict[str, str]:
        value, where = (_written(one[place]) for one in (y, x))
        return {"what": what, "value": upright.with_unit(value), "where": across.with_unit(where)}

    if y.size == 1:
        return said("{what}: {value} at {where}", **at(0))
    extent, ends = float(np.ptp(y)), (float(y[0]), float(y[-1]))
    if extent <= _STILL * float(np.abs(y).max()):
        return said("{what} stays at {value}", **at(0))
    top, foot = int(y.argmax()), int(y.argmin())
    if y[top] - max(ends) > _TURN * extent:
        return said("{what} is highest at {where}: {value}", **at(top))
    if min(ends) - y[foot] > _TURN * extent:
        return said("{what} is lowest at {where}: {value}", **at(foot))
    begin, end = at(0), at(-1)
    values = {**begin, "last": end["value"], "end": end["where"]}
    if ends[1] > ends[0]:
        return said("{what} rises from {value} at {where} to {last} at {end}", **values)
    return said("{what} falls from {value} at {where} to {last} at {end}", **values)


def courses(lines: Sequence[Points], across: Axis, upright: Axis) -> str:
    """Return how each of some lines runs; of many the highest and the lowest point of all."""
    known = [one for one in lines if np.isfinite(one[1] + one[2]).any()]
    if len(known) > _MOST:
        return extremes(known, across, upright)
    facts = "; ".join(course(*one, across, upright) for one in known)
    named = any(name.lower() not in ("", upright.name.lower()) for name, *_ in known)
    return f"{upright.name}: {facts}" if upright.name and named else facts


def extremes(lines: Sequence[Points], across: Axis, upright: Axis) -> str:
    """Return the highest and the lowest point of lines, of which one has a finite number."""
    y = np.concatenate([one for *_, one in lines])
    top, foot = (_point(lines, int(found(y)), across, upright)
                 for found in (np.nanargmax, np.nanargmin))  # fmt: skip
    what = upright.name or upright.title
    return said("{what}, highest: {top}; lowest: {foot}", what=what, top=top, foot=foot)


def peak(lines: Sequence[Points], across: Axis, upright: Axis) -> str:
    """Return the point of lines, of which one has a finite number, that is farthest from zero."""
    y = np.concatenate([one for *_, one in lines])
    most = _point(lines, int(np.nanargmax(np.abs(y))), across, upright)
    return said("{what}, largest: {most}", what=upright.name or upright.title, most=most)


def _point(lines: Sequence[Points], place: int, across: Axis, upright: Axis) -> str:
    """Return a point of lines, counted through all of them, and which it is on."""
    ends = np.cumsum([len(y) for *_, y in lines])
    line = int(np.searchsorted(ends, place, side="right"))
    name, x, y = lines[line]
    own = place - int(ends[line]) + len(y)
    values = {
        "value": upright.with_unit(_written(y[own])),
        "where": across.with_unit(_written(x[own])),
    }
    if not name:
        return said("{value} at {where}", **values)
    return said("{value} at {where} ({what})", **values, what=name)


def _written(value: float) -> str:
    return number(float(value) if abs(value) > _ROUNDING else 0.0, _FIGURES)


def crossing(x: Floats, y: Floats, level: float) -> float:
    """Return the first place where numbers pass a level, straight between points; NaN without.

    >>> crossing(np.array([0.0, 1.0, 2.0]), np.array([4.0, 2.0, 0.0]), 3.0)
    0.5
    """
    known = np.isfinite(x) & np.isfinite(y)
    x, away = x[known], y[known] - level
    passed = np.flatnonzero(away[:-1] * away[1:] <= 0.0)
    if not passed.size:
        return float("nan")
    one = int(passed[0])
    step = away[one] - away[one + 1]
    share = away[one] / step if step else 0.0
    return float(x[one] + share * (x[one + 1] - x[one]))
