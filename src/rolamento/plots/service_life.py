"""What ends a bearing, on one time line: horizontal bars over a logarithmic axis of hours."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Bars, Chart, Labels, Line, Look, Mark, nothing
from rolamento.charts.drawing import draw, figure
from rolamento.charts.record import Side
from rolamento.charts.texts import no_result
from rolamento.units import HOUR
from rolamento.words import manner, said
from rolamento.words.sentences.service_life import ENDING_NAMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.tasks.endings import Ending
    from rolamento.tasks.time_line import ServiceLife

__all__ = ["endings_chart", "service_life_figure", "time_line"]

_LEAST, _MOST = 100.0, 1e5
"""Hours that the axis shows at least."""
_WIDTH: Final = 22


def service_life_figure(found: ServiceLife) -> Figure:
    """Draw what ends a case, on one time line, as `endings_chart` has it."""
    tall = 38.0 + 11.0 * max(len(found.endings), 2)
    return figure(endings_chart(found), title=found.solved.title, height=tall)


def time_line(found: ServiceLife, axes: Axes | None = None) -> Axes:
    """Draw what ends a case, as `endings_chart` has it, on axes."""
    return draw(endings_chart(found), axes)


def endings_chart(found: ServiceLife) -> Chart:
    """Return a bar from low to high for each ending, a mark at its hours; words without a time.

    Parameters
    ----------
    found
        What `rolamento.tasks.service_life` gives.
    """
    if not found.endings:
        return nothing(no_result())
    series: list[Bars | Line | Labels] = []
    limits = _limits(found)
    for place, one in enumerate(found.endings):
        color = "outer" if one is found.first else "inner"
        if np.isfinite(one.hours) and one.hours > 0.0:
            series += _bar(place, one, color)
        else:
            series.append(_words(place, one, color if one is found.first else "grey", limits))
    required = found.required
    needed = () if required is None else (
        Mark(required, said("required life"), Look("ink", "dash", width=0.7), "x"),
    )  # fmt: skip
    names = (textwrap.fill(said(ENDING_NAMES[one.name]), _WIDTH) for one in found.endings)
    return Chart(
        tuple(series),
        Axis(limits=limits, log=True, name=said("Time"), unit="h"),
        Axis(categories=tuple(names)),
        _conclusion(found),
        marks=needed,
    )


def _limits(found: ServiceLife) -> tuple[float, float]:
    """Hours from which to which the axis goes."""
    known = [
        value
        for one in found.endings
        for value in (one.low, one.hours, one.high)
        if np.isfinite(value) and value > 0.0
    ]
    known += [] if found.required is None else [found.required]
    return 0.7 * min([*known, _LEAST]), 1.5 * max([*known, _MOST])


def _conclusion(found: ServiceLife) -> str:
    """Say what ends it first; where that has no time, what has the shortest known one too."""
    timed = [one for one in found.endings if np.isfinite(one.hours) and one.hours > 0.0]
    soonest = min(timed, key=lambda one: one.hours, default=None)
    named = {one.name: one for one in (found.first, soonest) if one is not None}
    facts = (f"{said(ENDING_NAMES[name])}: {_when(one)}" for name, one in named.items())
    return "; ".join(facts) or said("nothing ends it at a known time")


def _when(one: Ending) -> str:
    """Return the hours of an ending, or what is said of one that has no time."""
    if np.isfinite(one.hours) and one.hours > 0.0:
        return manner().number(HOUR * one.hours, ".2r h")
    return (
        said("at work, no time known") if one.acting
        else said("at once") if one.hours == 0.0
        else said("never") if one.hours == np.inf
        else said("not known")
    )  # fmt: skip


def _words(place: int, one: Ending, color: str, limits: tuple[float, float]) -> Labels:
    """Return what is said of an ending that has no time, where it stands."""
    middle: tuple[float, Side] = (float(np.sqrt(limits[0] * limits[1])), "on")
    ends: dict[float, tuple[float, Side]] = {0.0: (limits[0], "right"), np.inf: (limits[1], "left")}
    at, side = ends.get(one.hours, middle)
    return Labels(np.array([at]), np.array([float(place)]), (_when(one),), (side,), color)


def _bar(place: int, one: Ending, color: str) -> tuple[Bars, Line]:
    """Return an ending from low to high, hatched where upkeep puts it off, and its hours."""
    low = one.low if np.isfinite(one.low) else one.hours
    high = one.high if np.isfinite(one.high) else one.hours
    upkeep = one.kind == "upkeep"
    look = Look(color, hollow=upkeep, opacity=0.2 if upkeep else 0.45)
    point = Look(color, mark="triangle-left" if one.bound else "circle")
    return (
        Bars(np.array([high]), (place,), "", look, start=np.array([low])),
        Line(np.array([one.hours]), np.array([float(place)]), "", point, "points"),
    )
