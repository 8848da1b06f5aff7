"""What a roller bears along its length, and how it lies between the races.

Along a roller places are counted from its middle, toward +x; of a tapered one along its axis.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import floor, log10
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.plots.along_roller import (
    chosen_roller,
    lying_roller,
    most_loaded_rollers,
    place_name,
    pressure_along,
    pressure_name,
    roller_label,
    rollers_of,
    tilted_name,
)
from rolamento.plots.axes_units import MEGAPASCAL, MILLIMETRE
from rolamento.plots.contacts import check_one_case
from rolamento.plots.frame import GREY, empty_frame, label_x, label_y, legend_above, require_axes
from rolamento.plots.style import (
    INNER,
    OUTER,
    SERIES,
    in_style,
    new_figure,
    new_stacked_figure,
    series,
)
from rolamento.plots.texts import no_result, number
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

Floats = NDArray[np.float64]

_MOST_LINES: Final = len(SERIES)
_FAINT: Final[dict[str, Any]] = {"color": "#A8A8A8", "linewidth": 0.7}
_ROOM: Final = 1.08
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
    place, pressure = rollers.slice_place[0], pressure_along(rollers, race)
    loaded = [one for one in rollers_of(rollers) if np.nanmax(pressure[one]) > 0.0]
    peaks = most_loaded_rollers(solved, race)
    others = [one for one in loaded if one not in peaks]
    for one in others:
        axes.plot(MILLIMETRE.of(place[one]), pressure[one], zorder=2.0, **_FAINT)
    handles = [Line2D([], [], label=said("the other rollers"), **_FAINT)] if others else []
    for order, one in enumerate(peaks):
        look = INNER if race == "inner" else OUTER
        look = look if order == 0 else series(order + 1)
        handles += axes.plot(
            MILLIMETRE.of(place[one]),
            pressure[one],
            label=roller_label(solved, one),
            zorder=3.0,
            **{**look.keywords(), "linestyle": "-" if order == 0 else look.linestyle},
        )
    _frame_along(axes, solved, MEGAPASCAL.label(pressure_name(race)))
    legend_above(axes, handles=handles)
    return axes


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
    for order, (label, rollers) in enumerate(found.items()):
        if rollers is None:
            axes.plot([], [], label=f"{label}: {no_result()}", color=GREY, linestyle="")
            continue
        solved = states[label]
        one = most_loaded_rollers(solved, race)[0]
        x, y = MILLIMETRE.of(rollers.slice_place[0, one]), pressure_along(rollers, race)[one]
        name = said("{name}, {roller}", name=label, roller=roller_label(solved, one))
        axes.plot(x, y, label=name, **series(order).keywords())
    shown = next(solved for label, solved in states.items() if found[label] is not None)
    _frame_along(axes, shown, MEGAPASCAL.label(pressure_name(race)))
    legend_above(axes)
    return axes


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


def _frame_along(axes: Axes, solved: Solved, label: str) -> None:
    rollers = solved.rollers
    assert rollers is not None
    half = 0.5e3 * float(np.nanmax(solved.rows.effective_length[0]))
    axes.set_xlim(-_ROOM * half, _ROOM * half)
    axes.set_ylim(bottom=0.0)
    for end in (-half, half):  # of the effective length
        axes.axvline(end, color=GREY, linewidth=0.7, linestyle=(0, (2, 2)), zorder=1.5)
    label_x(axes, MILLIMETRE.label(place_name(solved)))
    label_y(axes, label)


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
    lies = lying_roller(solved, one)
    x = lies.x
    roller_line: dict[str, Any] = {"color": "black", "linewidth": 1.0, "zorder": 3.0}
    name = tilted_name(roller_label(solved, one), lies.tilt)
    axes.fill_between(x, lies.below, lies.above, color="#E4E4E4", linewidth=0.0, zorder=1.6)
    axes.plot(x, lies.above, label=name, **roller_line)
    axes.plot(x, lies.below, **roller_line)
    for end in (0, -1):
        axes.plot([x[end]] * 2, [lies.below[end], lies.above[end]], **roller_line)
    axes.plot(x, lies.axis, color=GREY, linewidth=0.8, linestyle=(0, (8, 2, 1, 2)), zorder=2.5)
    far = 10.0 * (lies.top - lies.bottom)
    outer_name = said("outer race")
    _draw_race(axes, x, lies.race_above, lies.above, lies.top + far, OUTER.color, outer_name)
    inner_name = tilted_name(said("inner race"), lies.ring_tilt)
    _draw_race(axes, x, lies.race_below, lies.below, lies.bottom - far, INNER.color, inner_name)
    _set_exaggeration(axes, x, lies.bottom, lies.top)
    label_x(axes, MILLIMETRE.label(place_name(solved)))
    axes.grid(False)
    legend_above(axes)
    return axes


def _draw_race(
    axes: Axes, x: Floats, race: Floats, roller: Floats, far: float, color: str, name: str
) -> None:
    """Draw the surface of a race, its body hatched, and where the roller presses into it."""
    axes.fill_between(
        x, race, far, facecolor="white", edgecolor="#B0B0B0", hatch="////", linewidth=0.0,
        zorder=1.5,
    )  # fmt: skip
    pressed = (roller - race) * (far - race) > 0.0
    axes.fill_between(
        x, race, roller, where=pressed.tolist(), color=color, alpha=0.35, linewidth=0.0,
        interpolate=True, zorder=2.0,
    )  # fmt: skip
    axes.plot(x, race, label=name, color=color, zorder=3.0)


def _set_exaggeration(axes: Axes, x: Floats, low: float, high: float) -> None:
    """Give heights a scale that is a round multiple of that of lengths, and say which."""
    length, height = float(np.ptp(x)) * _ROOM, high - low
    most = 1e3 * _SHAPE * length / height
    power = 10.0 ** floor(log10(most))
    times = max(step * power for step in _STEPS if step * power <= most)
    middle = 0.5 * (low + high)
    half = 0.5e3 * _SHAPE * length / times
    axes.set_xlim(-0.5 * length, 0.5 * length)
    axes.set_ylim(middle - half, middle + half)
    axes.set_box_aspect(_SHAPE)
    label_y(
        axes,
        said("Radial height (µm), {times} times exaggerated; the roller's body is cut",
             times=number(times)),
    )  # fmt: skip
