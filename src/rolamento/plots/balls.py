"""What every element bears: loads, contact angles, pressures over azimuth; the load rosette."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import degrees
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.plots.axes_units import DEGREE, ReadableUnit, readable_unit
from rolamento.plots.contacts import (
    AROUND,
    ContactQuantity,
    QuantityName,
    azimuth_name,
    check_one_case,
    contact_quantity,
    free_angle,
    load_unit,
    race_name,
    rows_in_order,
)
from rolamento.plots.frame import GREY, empty_frame, label_x, label_y, legend_above, require_axes
from rolamento.plots.style import (
    INNER,
    OUTER,
    SERIES,
    in_style,
    new_figure,
    new_polar_figure,
    series,
)
from rolamento.plots.texts import no_result, number
from rolamento.solved import RACES, Solved
from rolamento.words import said

Floats = NDArray[np.float64]
_TURN: Final = 360.0
_STEP: Final = 45.0
_MARGIN: Final = 8.0
_MOST_LINES: Final = len(SERIES)


@in_style
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
    return _over_azimuth(solved, axes, contact_quantity("load"))


@in_style
def contact_angles(solved: Solved, axes: Axes | None = None) -> Axes:
    """Draw the loaded contact angles over azimuth, with the free angle where it is given.

    Parameters, result and errors as of `ball_loads`; where ball and race do not touch, nothing is
    drawn.
    """
    axes = _over_azimuth(solved, axes, contact_quantity("contact_angle"))
    free = free_angle(solved)
    if solved.converged[0] and free is not None:
        axes.axhline(
            degrees(free), color=GREY, linewidth=0.9, zorder=1.5, label=said("free (unloaded)")
        )
        legend_above(axes)
    return axes


@in_style
def pressures(solved: Solved, axes: Axes | None = None) -> Axes:
    """Draw the maximum pressures of the contacts over azimuth; of rollers along their length.

    Parameters, result and errors as of `ball_loads`; where ball and race do not touch, nothing is
    drawn.
    """
    return _over_azimuth(solved, axes, contact_quantity("max_pressure"))


@in_style
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
    axes = new_figure()[1] if axes is None else require_axes(axes)
    chosen = contact_quantity(quantity)
    shown = {label: solved for label, solved in states.items() if solved.converged[0]}
    if not shown:
        return empty_frame(axes, no_result(str(next(iter(states.values())).status.code[0])))
    rows = sum(len(solved.rows) for solved in shown.values())
    races: tuple[Race, ...] = RACES if rows * len(RACES) <= _MOST_LINES else ("inner",)
    if rows * len(races) > _MOST_LINES:
        raise InputError(
            said(
                "would make {count} lines; more than {most} cannot be told apart",
                count=rows * len(races),
                most=_MOST_LINES,
            ),
            field="states",
            value=len(states),
        )
    numbers = {
        (label, race): chosen.of(solved, race) for label, solved in shown.items() for race in races
    }
    unit = chosen.unit or readable_unit("N", np.concatenate(list(numbers.values())))
    place = 0
    for label, solved in shown.items():
        by_row = rows_in_order(solved)
        for row, balls in enumerate(by_row):
            azimuth = np.mod(DEGREE.of(solved.elements.azimuth[0, balls]), _TURN)
            for race in races:
                line = _all_round(azimuth, unit.of(numbers[label, race][balls]))
                own = f"{label}, {race_name(race, row, len(by_row))}"
                axes.plot(*line, label=own, **series(place).keywords(markers=True))
                place += 1
    for label in states.keys() - shown.keys():
        axes.plot([], [], label=f"{label}: {no_result()}", color=GREY, linestyle="")
    elements = [one for solved in shown.values() for one in solved.rows.element]
    _frame_azimuth(axes, unit.label(chosen.name), elements, from_zero=chosen.from_zero)
    return axes


def row_keywords(race: Race, row: int) -> dict[str, Any]:
    """Colour and line show the race, markers the row: filled ones, then hollow ones."""
    race_series = INNER if race == "inner" else OUTER
    if row == 0:
        return race_series.keywords(markers=True)
    shape: dict[str, Any] = {"marker": SERIES[(1 + row) % len(SERIES)].marker, "linewidth": 1.0}
    hollow = {"markerfacecolor": "white"} if row % 2 else {}
    return {**race_series.keywords(), **shape, **hollow}


def _over_azimuth(solved: Solved, axes: Axes | None, quantity: ContactQuantity) -> Axes:
    """Draw a number of every contact; without a unit, loads in one that fits them."""
    check_one_case(solved, "ball_loads")
    axes = new_figure()[1] if axes is None else require_axes(axes)
    if not solved.converged[0]:
        return empty_frame(axes, no_result(str(solved.status.code[0])))
    unit = quantity.unit or load_unit([solved])
    rows = rows_in_order(solved)
    for row, balls in enumerate(rows):
        azimuth = np.mod(DEGREE.of(solved.elements.azimuth[0, balls]), _TURN)
        for race in RACES:
            label = race_name(race, row, len(rows))
            line = _all_round(azimuth, unit.of(quantity.of(solved, race)[balls]))
            axes.plot(*line, label=label, **row_keywords(race, row))
    _frame_azimuth(
        axes, unit.label(quantity.name), solved.rows.element, from_zero=quantity.from_zero
    )
    return axes


def _frame_azimuth(axes: Axes, label: str, elements: Iterable[str], *, from_zero: bool) -> None:
    axes.set_xlim(-_MARGIN, _TURN + _MARGIN)
    axes.set_xticks(np.arange(0.0, _TURN + 1.0, _STEP))
    if from_zero:
        axes.set_ylim(bottom=0.0)
    label_x(axes, DEGREE.label(azimuth_name(elements)))
    label_y(axes, label)
    legend_above(axes)


def _all_round(azimuth: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Put elements in order, and before and after them the turns that come round to the same."""
    order = np.argsort(azimuth, kind="stable")
    turns = (-_TURN, 0.0, _TURN)
    around = np.concatenate([azimuth[order] + turn for turn in turns])
    near = (around >= -_TURN / 2) & (around <= 1.5 * _TURN)
    return around[near], np.tile(values[order], len(turns))[near]


@in_style
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
    polar = new_polar_figure()[1] if axes is None else _turned(axes)
    if not solved.converged[0]:
        empty_frame(polar, no_result(str(solved.status.code[0])))
        return polar
    unit = load_unit([solved])
    draw_rosette(polar, solved, unit)
    polar.set_rlim(bottom=0.0)
    label = said("Contact load ({unit}), seen from +x", unit=unit.symbol)
    polar.set_xlabel(label, labelpad=6.0)
    legend_above(polar)
    number_circles(polar, solved, unit)
    return polar


def draw_rosette(axes: Axes, solved: Solved, unit: ReadableUnit) -> None:
    """Draw the lines of a rosette, of one case that has a result, in a unit; without a legend."""
    polar = _turned(axes)
    rows = rows_in_order(solved)
    for row, balls in enumerate(rows):
        around = np.append(balls, balls[0])
        for race in RACES:
            label = race_name(race, row, len(rows))
            azimuth = solved.elements.azimuth[0, around]
            load = unit.of(solved.contacts[race].load[0, around])
            polar.plot(azimuth, load, label=label, **row_keywords(race, row))
    polar.set_thetagrids(np.arange(0.0, 360.0, 45.0), AROUND)


def number_circles(axes: PolarAxes, solved: Solved, unit: ReadableUnit) -> None:
    """Write what the circles of a rosette stand for, clear of what its elements bear."""
    larger = np.maximum(*(solved.contacts[race].load[0] for race in RACES))
    _number_circles(axes, solved.elements.azimuth[0], unit.of(larger))


def _number_circles(axes: PolarAxes, azimuth: Floats, load: Floats) -> None:
    """Write what the circles stand for where the balls bear least, and clear of what they bear."""
    directions = np.arange(202.5, 562.5, 45.0)
    near = np.cos(azimuth - np.radians(directions)[:, np.newaxis]) > np.cos(np.pi / 4)
    borne = np.where(near, load, 0.0).max(axis=1)
    emptiest = int(borne.argmin())
    rim = float(axes.get_rmax())
    circles = np.asarray(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, rim))
    circles = circles[(circles > 0.0) & (circles <= rim)]
    clear = 2.0 * borne[emptiest]
    names = [number(circle) if circle > clear else "" for circle in circles]
    axes.set_rgrids(circles, names if any(names) else [number(c) for c in circles])
    axes.set_rlabel_position(directions[emptiest] % 360.0)


def _turned(axes: Axes) -> PolarAxes:
    if not isinstance(axes, PolarAxes):
        raise InputError(
            said("must be polar"), field="axes", example='figure.add_subplot(projection="polar")'
        )
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    return axes
