"""What every ball bears, over its azimuth: loads, contact angles, pressures."""

from __future__ import annotations

from collections.abc import Callable
from math import degrees
from typing import Any, Final, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.plots.axes_units import DEGREE, MEGAPASCAL, ReadableUnit, readable_unit
from rolamento.plots.frame import GREY, empty_frame, label_x, label_y, legend_above, number
from rolamento.plots.reading import PlottedBall, PlottedState, contact_value, rows_of
from rolamento.plots.style import INNER, OUTER, SERIES, in_style, new_figure, new_polar_figure
from rolamento.plots.words import ENGLISH, PlotWords

Floats = NDArray[np.float64]
Race = Literal["inner", "outer"]
RACES: Final[tuple[Race, Race]] = ("inner", "outer")
_TURN: Final = 360.0
_STEP: Final = 45.0
_MARGIN: Final = 8.0


@in_style
def ball_loads(
    state: PlottedState, axes: Axes | None = None, *, words: PlotWords = ENGLISH
) -> Axes:
    """Draw the contact loads of the balls over their azimuth, for each race and row.

    Parameters
    ----------
    state
        A solved state; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.
    words
        Language of the labels.

    Returns
    -------
    Axes
        Those given. A contact without load is drawn as zero.
    """

    def loads(ball: PlottedBall, race: Race) -> float:
        return ball.inner.load if race == "inner" else ball.outer.load

    greatest = [loads(ball, race) for ball in state.balls for race in RACES]
    return _over_azimuth(
        state, axes, loads, readable_unit("N", greatest), words.ball_load, words, from_zero=True
    )


@in_style
def contact_angles(
    state: PlottedState, axes: Axes | None = None, *, words: PlotWords = ENGLISH
) -> Axes:
    """Draw the loaded contact angles over azimuth, with the free angle where it is given.

    Parameters and result as of `ball_loads`; where ball and race do not touch, nothing is drawn.
    """

    def angles(ball: PlottedBall, race: Race) -> float:
        return contact_value(ball, race, "contact_angle")

    axes = _over_azimuth(state, axes, angles, DEGREE, words.contact_angle, words)
    free = _free_angle(state)
    if state.status.converged and free is not None:
        axes.axhline(degrees(free), color=GREY, linewidth=0.9, zorder=1.5, label=words.free_angle)
        legend_above(axes)
    return axes


@in_style
def pressures(state: PlottedState, axes: Axes | None = None, *, words: PlotWords = ENGLISH) -> Axes:
    """Draw the greatest Hertz pressures of the contacts over azimuth.

    Parameters and result as of `ball_loads`; where ball and race do not touch, nothing is drawn.
    """

    def pressure(ball: PlottedBall, race: Race) -> float:
        return contact_value(ball, race, "max_pressure")

    return _over_azimuth(
        state, axes, pressure, MEGAPASCAL, words.max_pressure, words, from_zero=True
    )


def race_name(race: Race, row: int, rows: int, words: PlotWords) -> str:
    """Name the race, and the row if there are several."""
    name = words.inner if race == "inner" else words.outer
    return name if rows == 1 else f"{name}, {words.row.format(number=row)}"


def row_keywords(race: Race, place: int) -> dict[str, Any]:
    """Colour and line tell the race, markers the row: filled ones, then hollow ones."""
    race_series = INNER if race == "inner" else OUTER
    if place == 0:
        return race_series.keywords(markers=True)
    shape: dict[str, Any] = {"marker": SERIES[(1 + place) % len(SERIES)].marker, "linewidth": 1.0}
    hollow = {"markerfacecolor": "white"} if place % 2 else {}
    return {**race_series.keywords(), **shape, **hollow}


def _over_azimuth(
    state: PlottedState,
    axes: Axes | None,
    value: Callable[[PlottedBall, Race], float],
    unit: ReadableUnit,
    name: str,
    words: PlotWords,
    *,
    from_zero: bool = False,
) -> Axes:
    """Draw a number of every contact."""
    axes = new_figure()[1] if axes is None else axes
    if not state.status.converged:
        return empty_frame(axes, words.reason(state.status.code))
    rows = rows_of(state)
    for place, (row, balls) in enumerate(rows):
        azimuth = np.mod(DEGREE.of([ball.azimuth for ball in balls]), _TURN)
        for race in RACES:
            values = unit.of([value(ball, race) for ball in balls])
            label = race_name(race, row, len(rows), words)
            axes.plot(*_all_round(azimuth, values), label=label, **row_keywords(race, place))
    axes.set_xlim(-_MARGIN, _TURN + _MARGIN)
    axes.set_xticks(np.arange(0.0, _TURN + 1.0, _STEP))
    if from_zero:
        axes.set_ylim(bottom=0.0)
    label_x(axes, DEGREE.label(words.azimuth), words)
    label_y(axes, unit.label(name), words)
    legend_above(axes)
    return axes


def _all_round(azimuth: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Put balls in order, and before and after them the turns that come round to the same balls."""
    order = np.argsort(azimuth, kind="stable")
    turns = (-_TURN, 0.0, _TURN)
    around = np.concatenate([azimuth[order] + turn for turn in turns])
    near = (around >= -_TURN / 2) & (around <= 1.5 * _TURN)
    return around[near], np.tile(values[order], len(turns))[near]


def _free_angle(state: PlottedState) -> float | None:
    """The free contact angle, if one was given for the whole bearing."""
    bearing = state.case.bearing if state.case is not None else None
    if bearing is None or bearing.arrangement is not None or bearing.rows is not None:
        return None
    return bearing.contact_angle


_DIRECTIONS: Final = ("0°, +z", "45°", "90°\n+y", "135°", "180°", "225°", "270°", "315°")


@in_style
def load_rosette(
    state: PlottedState, axes: Axes | None = None, *, words: PlotWords = ENGLISH
) -> PolarAxes:
    """Draw the contact loads around the bearing: +z is up, azimuths run clockwise over +y.

    Parameters
    ----------
    state
        A solved state; without a result, a frame that says why is drawn.
    axes
        Polar axes to draw on; of a new figure if not given.
    words
        Language of the labels.

    Returns
    -------
    PolarAxes
        Those given.

    Raises
    ------
    InputError
        If the axes are not polar.
    """
    polar = new_polar_figure()[1] if axes is None else _turned(axes)
    if not state.status.converged:
        empty_frame(polar, words.reason(state.status.code))
        return polar
    loads = [getattr(ball, race).load for ball in state.balls for race in RACES]
    unit = readable_unit("N", loads)
    rows = rows_of(state)
    for place, (row, balls) in enumerate(rows):
        azimuth = np.array([ball.azimuth for ball in balls])
        for race in RACES:
            load = unit.of([getattr(ball, race).load for ball in balls])
            label = race_name(race, row, len(rows), words)
            polar.plot(_closed(azimuth), _closed(load), label=label, **row_keywords(race, place))
    _label(polar, unit.label(words.ball_load), words)
    _number_circles(polar, state, unit, words)
    return polar


def _closed(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.append(values, values[0])


def _number_circles(
    axes: PolarAxes, state: PlottedState, unit: ReadableUnit, words: PlotWords
) -> None:
    """Write what the circles stand for where the balls bear least, and clear of what they bear."""
    azimuth = np.array([ball.azimuth for ball in state.balls])
    load = unit.of([max(ball.inner.load, ball.outer.load) for ball in state.balls])
    directions = np.arange(202.5, 562.5, 45.0)
    near = np.cos(azimuth - np.radians(directions)[:, np.newaxis]) > np.cos(np.pi / 4)
    borne = np.where(near, load, 0.0).max(axis=1)
    emptiest = int(borne.argmin())
    rim = float(axes.get_rmax())
    circles = np.asarray(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, rim))
    circles = circles[(circles > 0.0) & (circles <= rim)]
    clear = 2.0 * borne[emptiest]
    names = [number(circle, words) if circle > clear else "" for circle in circles]
    axes.set_rgrids(circles, names if any(names) else [number(c, words) for c in circles])
    axes.set_rlabel_position(directions[emptiest] % 360.0)


def _turned(axes: Axes) -> PolarAxes:
    if not isinstance(axes, PolarAxes):
        raise InputError(
            "must be polar", field="axes", example='figure.add_subplot(projection="polar")'
        )
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    return axes


def _label(axes: PolarAxes, name: str, words: PlotWords) -> None:
    """Name the directions, and the unit of the circles."""
    axes.set_thetagrids(np.arange(0.0, 360.0, 45.0), _DIRECTIONS)
    axes.set_rlim(bottom=0.0)
    axes.set_xlabel(f"{name}, {words.seen_from}", labelpad=6.0)
    legend_above(axes)
