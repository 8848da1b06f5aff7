"""What every element bears: loads, contact angles, pressures over azimuth; the load rosette."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.projections.polar import PolarAxes

from rolamento.charts import Chart, Line, Look, nothing
from rolamento.charts.contact_charts import MOST_LINES, contact_chart, rosette_chart
from rolamento.charts.contacts import QuantityName, Shown, check_one_case
from rolamento.charts.drawing import draw
from rolamento.charts.texts import no_result
from rolamento.errors import InputError
from rolamento.solved import RACES, Solved
from rolamento.words import said


def ball_loads(solved: Solved, axes: Axes | None = None) -> Axes:
    """Draw the contact loads of balls or rollers over their azimuth, for each race and row.

    Parameters
    ----------
    solved
        One case; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.

    Returns
    -------
    Axes
        Those given. A contact without load is drawn as zero.

    Raises
    ------
    InputError
        If this is not one solved case, or the axes are none.
    """
    return draw(_chart(solved, "load", "ball_loads"), axes)


def contact_angles(solved: Solved, axes: Axes | None = None) -> Axes:
    """Draw the loaded contact angles over azimuth, with the free angle where it is given.

    Parameters, result and errors as of `ball_loads`; where ball and race do not touch, nothing is
    drawn.
    """
    return draw(_chart(solved, "contact_angle", "contact_angles"), axes)


def pressures(solved: Solved, axes: Axes | None = None) -> Axes:
    """Draw the maximum pressures of the contacts over azimuth; of rollers along their length.

    Parameters, result and errors as of `ball_loads`; where ball and race do not touch, nothing is
    drawn.
    """
    return draw(_chart(solved, "max_pressure", "pressures"), axes)


def compared_states(
    states: Mapping[str, Solved], quantity: QuantityName = "load", axes: Axes | None = None
) -> Axes:
    """Draw a number of the contacts of several states over azimuth, in one frame.

    Parameters
    ----------
    states
        Single cases, by what the legend is to call them.
    quantity
        ``"load"``, ``"contact_angle"`` or ``"max_pressure"``.
    axes
        To draw on; of a new figure if not given.

    Returns
    -------
    Axes
        Those given. Both races, or the inner race alone where there would be more lines than can
        be distinguished; of a state without a result the legend says so.

    Raises
    ------
    InputError
        If a state is not one solved case, or there are too many of them.
    """
    for solved in states.values():
        check_one_case(solved, "compared_states")
    shown = {label: solved for label, solved in states.items() if solved.converged[0]}
    if not shown:
        return draw(nothing(no_result(str(next(iter(states.values())).status.code[0]))), axes)
    rows = sum(len(solved.rows) for solved in shown.values())
    lines = rows * (len(RACES) if rows * len(RACES) <= MOST_LINES else 1)
    if lines > MOST_LINES:
        raise InputError(
            said(
                "would make {count} lines; more than {most} cannot be told apart",
                count=lines,
                most=MOST_LINES,
            ),
            field="states",
            value=len(states),
        )
    cases = [Shown(label, solved, place) for place, (label, solved) in enumerate(shown.items())]
    chart = contact_chart(cases, quantity, most=MOST_LINES)
    return draw(without_result(chart, [label for label in states if label not in shown]), axes)


def without_result(chart: Chart, names: Iterable[str]) -> Chart:
    """Add to the legend of a chart those that have no result."""
    none, look = np.empty(0), Look("grey", mark="thin")
    lines = (Line(none, none, f"{name}: {no_result()}", look, "points") for name in names)
    return replace(chart, series=(*chart.series, *lines))


def _chart(solved: Solved, column: QuantityName, function: str) -> Chart:
    check_one_case(solved, function)
    if not solved.converged[0]:
        return nothing(no_result(str(solved.status.code[0])))
    return contact_chart([Shown("", solved)], column)


def load_rosette(solved: Solved, axes: Axes | None = None) -> PolarAxes:
    """Draw the contact loads around the bearing: +z is up, azimuths run clockwise over +y.

    Parameters
    ----------
    solved
        One case; without a result, a frame that says why is drawn.
    axes
        Polar axes to draw on; of a new figure if not given.

    Returns
    -------
    PolarAxes
        Those given.

    Raises
    ------
    InputError
        If this is not one solved case, or the axes are not polar.
    """
    check_one_case(solved, "load_rosette")
    if not solved.converged[0]:
        chart = Chart((), conclusion=no_result(str(solved.status.code[0])), polar=True)
    else:
        chart = rosette_chart([Shown("", solved)])
    polar = draw(chart, axes)
    assert isinstance(polar, PolarAxes)
    return polar
