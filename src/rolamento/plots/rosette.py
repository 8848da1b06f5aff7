"""The load rosette: ball loads around the bearing, as one looks at it from +x."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.plots.axes_units import ReadableUnit, readable_unit
from rolamento.plots.balls import RACES, race_name, row_keywords
from rolamento.plots.frame import empty_frame, legend_above, number
from rolamento.plots.reading import PlottedState, rows_of
from rolamento.plots.style import in_style, new_polar_figure
from rolamento.plots.words import ENGLISH, PlotWords

__all__ = ["load_rosette"]

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
