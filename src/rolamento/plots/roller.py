"""What a roller bears along its length, and how it lies between the races.

Along a roller places are counted from its middle, toward +x; of a tapered one along its axis.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import floor, log10
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.axes import Axes

from rolamento.charts import Chart, Look, series_look
from rolamento.charts.along_roller import (
    chosen_roller,
    most_loaded_rollers,
    pressure_along,
    pressure_name,
    roller_label,
    rollers_of,
)
from rolamento.charts.contacts import Shown, check_one_case
from rolamento.charts.drawing import draw
from rolamento.charts.frame import empty_frame, require_axes
from rolamento.charts.palette import SERIES
from rolamento.charts.roller_charts import along_chart, between_chart, pressure_line
from rolamento.charts.style import in_style, new_figure, new_stacked_figure
from rolamento.charts.texts import no_result, number
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.plots.balls import without_result
from rolamento.solved import Solved
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.solved import Rollers

__all__ = [
    "compared_rollers",
    "pressure_along_rollers",
    "pressures_of_both_races",
    "roller_between_races",
]

_MOST_LINES: Final = len(SERIES)
_STEPS: Final = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)
_SHAPE: Final = 0.55
"""Height of the drawing of a roller over its length, on paper."""


# --- pressure along the rollers -----------------------------------------------------------------


@in_style
def pressure_along_rollers(
    solved: Solved, axes: Axes | None = None, *, race: Race = "inner"
) -> Axes:
    """Draw the pressure along every roller of one race, the most loaded roller of each row in full.

    Parameters
    ----------
    solved
        One case of a roller bearing; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.
    race
        ``"inner"`` or ``"outer"``.

    Returns
    -------
    Axes
        Those given. At each slice the maximum across the width of the contact; where roller and
        race do not touch, zero. Rollers that bear nothing are left out.

    Raises
    ------
    InputError
        If this is not one solved case, or one without rollers.
    """
    rollers = _rollers_of(solved, "pressure_along_rollers")
    axes = new_figure()[1] if axes is None else require_axes(axes)
    if rollers is None:
        return empty_frame(axes, no_result(str(solved.status.code[0])))
    pressure = pressure_along(rollers, race)
    peaks = most_loaded_rollers(solved, race)
    others = [
        one for one in rollers_of(rollers) if np.nanmax(pressure[one]) > 0.0 and one not in peaks
    ]
    grey = Look("grey", width=0.5)
    lines = [
        pressure_line(solved, one, race, "" if order else said("the other rollers"), grey,
                      faint=True)
        for order, one in enumerate(others)
    ]  # fmt: skip
    for order, one in enumerate(peaks):
        look = series_look(order + 1) if order else Look(race)
        lines.append(pressure_line(solved, one, race, roller_label(solved, one), look))
    return draw(along_chart(lines, [solved], pressure_name(race)), axes)


@in_style
def pressures_of_both_races(solved: Solved) -> tuple[Axes, Axes]:
    """Draw the pressure along the rollers at the inner race above that at the outer race.

    Parameters and errors as of `pressure_along_rollers`; both have the same scale.
    """
    _, (inner, outer) = new_stacked_figure(2, height=140.0)
    pressure_along_rollers(solved, inner, race="inner")
    pressure_along_rollers(solved, outer, race="outer")
    if solved.converged[0]:
        top = max(inner.get_ylim()[1], outer.get_ylim()[1])
        inner.set_ylim(0.0, top)
        outer.set_ylim(0.0, top)
        inner.set_xlabel("")
    return inner, outer


@in_style
def compared_rollers(
    states: Mapping[str, Solved], axes: Axes | None = None, *, race: Race = "inner"
) -> Axes:
    """Draw the pressure along the most loaded roller of several states, in one frame.

    Parameters
    ----------
    states
        Single cases of roller bearings, by what the legend is to call them.
    axes
        To draw on; of a new figure if not given.
    race
        ``"inner"`` or ``"outer"``.

    Raises
    ------
    InputError
        If a state is not one solved case of a roller bearing, or there are too many of them.
    """
    found = {label: _rollers_of(solved, "compared_rollers") for label, solved in states.items()}
    axes = new_figure()[1] if axes is None else require_axes(axes)
    if len(found) > _MOST_LINES:
        raise InputError(
            said(
                "would make {count} lines; more than {most} cannot be told apart",
                count=len(found),
                most=_MOST_LINES,
            ),
            field="states",
            value=len(found),
        )
    if all(rollers is None for rollers in found.values()):
        return empty_frame(axes, no_result(str(next(iter(states.values())).status.code[0])))
    lines = []
    for order, (label, solved) in enumerate(states.items()):
        if found[label] is not None:
            one = most_loaded_rollers(solved, race)[0]
            name = said("{name}, {roller}", name=label, roller=roller_label(solved, one))
            lines.append(pressure_line(solved, one, race, name, series_look(order)))
    shown = [solved for label, solved in states.items() if found[label] is not None]
    missing = [label for label, rollers in found.items() if rollers is None]
    return draw(without_result(along_chart(lines, shown, pressure_name(race)), missing), axes)


def _rollers_of(solved: Solved, figure: str) -> Rollers | None:
    """Return what a case has of rollers; None where it has no result.

    Raises
    ------
    InputError
        If this is not one case of a bearing with rollers.
    """
    check_one_case(solved, figure)
    if not solved.converged[0]:
        return None
    if solved.rollers is None:
        raise InputError(
            said("is for roller bearings; this bearing has balls"),
            field="solved",
            example='bearing.element = "cylindrical"',
        )
    return solved.rollers


# --- a roller between the races -------------------------------------------------------------------


@in_style
def roller_between_races(
    solved: Solved, axes: Axes | None = None, *, roller: int | None = None
) -> Axes:
    """Draw a roller between the races as they lie, before they are pressed flat: tilt and profile.

    Heights are many times exaggerated against lengths, how many times is written on the axis; the
    body of the roller is cut. Where the outlines overlap, they press on each other.

    Parameters
    ----------
    solved
        One case of a roller bearing; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.
    roller
        Counted from 0; by default that with the greatest pressure at the inner race.

    Returns
    -------
    Axes
        Those given.

    Raises
    ------
    InputError
        If this is not one solved case of a roller bearing, or it has no such roller.
    """
    rollers = _rollers_of(solved, "roller_between_races")
    axes = new_figure(height=102.0)[1] if axes is None else require_axes(axes)
    if rollers is None:
        return empty_frame(axes, no_result(str(solved.status.code[0])))
    one = chosen_roller(solved, rollers, roller)
    if one is None:
        return empty_frame(axes, said("no roller is loaded"))
    chart = between_chart(Shown("", solved), one)
    draw(_exaggerated(chart), axes)
    axes.grid(False)
    axes.set_box_aspect(_SHAPE)
    return axes


def _exaggerated(chart: Chart) -> Chart:
    """Give heights a scale that is a round multiple of that of lengths, and say which."""
    assert chart.x.limits is not None
    assert chart.y.limits is not None
    length, (low, high) = chart.x.limits[1] - chart.x.limits[0], chart.y.limits
    most = 1e3 * _SHAPE * length / (high - low)
    power = 10.0 ** floor(log10(most))
    times = max(step * power for step in _STEPS if step * power <= most)
    middle, half = 0.5 * (low + high), 0.5e3 * _SHAPE * length / times
    label = said("Radial height (µm), {times} times exaggerated; the roller's body is cut",
                 times=number(times))  # fmt: skip
    return replace(chart, y=replace(chart.y, limits=(middle - half, middle + half), label=label))
