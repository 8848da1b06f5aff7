"""Contact ellipses to scale, on a groove that is rolled out flat.

Across the groove an ellipse lies at its contact angle times the radius of the groove, counted
from the bottom; along it the balls stand side by side, not at their true distance, which is many
times the width of an ellipse.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, floor, log10
from typing import Final, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rolamento.charts import Axis
from rolamento.charts.axes_units import DEGREE
from rolamento.charts.contacts import Shown, check_one_case, refuse_rollers, rows_in_order
from rolamento.charts.drawing import draw
from rolamento.charts.ellipse_charts import across_axis, ellipse_chart
from rolamento.charts.frame import empty_frame, require_axes
from rolamento.charts.groove import Slot, extent, slots_of
from rolamento.charts.style import in_style, new_figure, new_stacked_figure
from rolamento.charts.texts import capitalised, no_result, number
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.solved import RACES, Solved
from rolamento.validate import whole_number
from rolamento.words import said
from rolamento.words.quantities import called

_FRAME_SHAPE: Final = 3.3
"""Width of the drawing over its height, as it fits two to a page."""
_LABEL_CHARACTERS: Final = 80
SCALE_BAR: Final = "scale bar"
"""What the scale bar is called in an SVG file."""
_BARS: Final = (1, 2, 5)


class _Scale(NamedTuple):
    """How far a drawing reaches across the groove, and from ball to ball; mm."""

    low: float
    high: float
    step: float


@in_style
def contact_ellipses(
    solved: Solved,
    axes: Axes | None = None,
    *,
    race: Race = "inner",
    balls: Sequence[int] | None = None,
) -> Axes:
    """Draw the contact ellipses of one race to scale, where they lie across the groove.

    The edges of the groove are drawn where its shoulder height is given; an ellipse that runs
    over the edge, of a half circle where none is given, is hatched.

    Parameters
    ----------
    solved
        One case; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.
    race
        ``"inner"`` or ``"outer"``.
    balls
        Which of the balls, counted from 0; all if not given.

    Returns
    -------
    Axes
        Those given, with a second axis on the right for the contact angle, if all rows have
        the same groove.

    Raises
    ------
    InputError
        If this is not one solved case of a ball bearing, or it has no such ball.
    """
    check_one_case(solved, "contact_ellipses")
    refuse_rollers(solved)
    axes = new_figure()[1] if axes is None else require_axes(axes)
    if not solved.converged[0]:
        return empty_frame(axes, no_result(str(solved.status.code[0])))
    groups = _groups(solved, race, balls)
    return _draw(axes, solved, groups, race, _scale(groups))


@in_style
def ellipses_of_both_races(
    solved: Solved, *, balls: Sequence[int] | None = None
) -> tuple[Axes, Axes]:
    """Draw the ellipses of the inner race above those of the outer, in a new figure.

    Parameters and errors as of `contact_ellipses`; both races are drawn to the same scale.
    """
    check_one_case(solved, "ellipses_of_both_races")
    refuse_rollers(solved)
    _, (inner, outer) = new_stacked_figure(2)
    if not solved.converged[0]:
        message = no_result(str(solved.status.code[0]))
        return empty_frame(inner, message), empty_frame(outer, message)
    groups = {race: _groups(solved, race, balls) for race in RACES}
    scale = _scale([*groups["inner"], *groups["outer"]], races=2)
    _draw(inner, solved, groups["inner"], "inner", scale)
    _draw(outer, solved, groups["outer"], "outer", scale)
    return inner, outer


def _draw(
    axes: Axes, solved: Solved, groups: Sequence[list[Slot]], race: Race, scale: _Scale
) -> Axes:
    slots = _side_by_side(groups, scale.step)
    name = said("Across inner groove") if race == "inner" else said("Across outer groove")
    margin = 0.8 * scale.step
    along = Axis(
        limits=(-margin, slots[-1].along + margin), ticks=_ticks(slots),
        label=said("Azimuth of the ball (°); ellipses to scale, balls side by side"),
    )  # fmt: skip
    across = across_axis(name, scale.low, scale.high)
    cases = [(Shown("", solved), slots)]
    draw(ellipse_chart(cases, race, across=across, along=along, margin=margin), axes)
    axes.grid(False, axis="x")
    _name_rows(axes, slots)
    _draw_bar(axes)
    radii = {slot.groove_radius for slot in slots}
    if len(radii) == 1:
        _angle_axis(axes, radii.pop(), slots[0].bottom)
    return axes


def _ticks(slots: Sequence[Slot]) -> tuple[tuple[float, str], ...]:
    """Return the azimuths of the balls, as many as there is room for."""
    names = [number(float(DEGREE.of(slot.azimuth)) % 360.0) for slot in slots]
    every = ceil(sum(len(name) + 2 for name in names) / _LABEL_CHARACTERS)
    return tuple(zip((slot.along for slot in slots), names, strict=True))[::every]


def _groups(solved: Solved, race: Race, chosen: Sequence[int] | None) -> list[list[Slot]]:
    """Return the chosen balls, row by row."""
    picked = set(_picked(len(solved.elements.row), chosen))
    slots = slots_of(solved, race)
    groups = ([slots[ball] for ball in row if ball in picked] for row in rows_in_order(solved))
    return [group for group in groups if group]


def _scale(groups: Sequence[list[Slot]], races: int = 1) -> _Scale:
    """Find a scale that lets bottom, edges and ellipses in, and keeps the balls apart."""
    slots = [slot for group in groups for slot in group]
    low, high = extent(slots)
    height = high - low
    widest = max((slot.semi_minor for slot in slots if slot.touches), default=0.0)
    count = (len(slots) + len(groups)) / races
    step = max(_FRAME_SHAPE * height / count, 3.0 * widest)
    return _Scale(low - 0.2 * height, high + 0.06 * height, step)


def _side_by_side(groups: Sequence[list[Slot]], step: float) -> list[Slot]:
    """Set the balls side by side, and rows of balls apart."""
    placed: list[Slot] = []
    for place, group in enumerate(groups):
        first = len(placed) + place
        placed += [replace(slot, along=step * (first + j)) for j, slot in enumerate(group)]
    return placed


def _picked(count: int, chosen: Sequence[int] | None) -> Sequence[int]:
    if chosen is None:
        return range(count)
    for index in chosen:
        whole_number(index, "balls", 0, count - 1)
    if not chosen:
        raise InputError(said("must name at least one ball"), field="balls", example="[0, 1]")
    return chosen


def _draw_bar(axes: Axes) -> None:
    """Draw a scale bar of 1, 2 or 5 times a power of ten mm into the room below."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    longest = (right - left) / 8.0
    power = 10.0 ** floor(log10(longest))
    length = max(power * bar for bar in _BARS if power * bar <= longest * (1.0 + 1e-9))
    start, level = right - 0.03 * (right - left) - length, low + 0.05 * (high - low)
    ends = [start, start + length]
    axes.plot(
        ends, [level, level], "k-", linewidth=2.0, solid_capstyle="butt", gid=SCALE_BAR, zorder=4.0
    )
    axes.annotate(
        f"{number(length)} mm",
        (start + 0.5 * length, level),
        (0.0, 2.5),
        textcoords="offset points",
        ha="center",
        fontsize=8.0,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
    )


def _name_rows(axes: Axes, slots: Sequence[Slot]) -> None:
    rows = sorted({slot.row for slot in slots})
    for row in rows if len(rows) > 1 else ():
        begin = min(slot.along for slot in slots if slot.row == row)
        name = said("row {number}", number=row)
        axes.annotate(name, (begin, 0.03), xycoords=("data", "axes fraction"), fontsize=8.0)


def _angle_axis(axes: Axes, radius: float, bottom: float) -> None:
    """Put the contact angle on the right: distance from the bottom over the groove's radius."""
    degrees_per_mm, begin = DEGREE.factor / radius, DEGREE.factor * bottom

    def to_angle(across: ArrayLike) -> ArrayLike:
        return begin + np.asarray(across) * degrees_per_mm

    def from_angle(angle: ArrayLike) -> ArrayLike:
        return (np.asarray(angle) - begin) / degrees_per_mm

    angles = axes.secondary_yaxis("right", functions=(to_angle, from_angle))
    angles.spines["right"].set_visible(True)
    angles.tick_params(labelsize=8.0)
    angles.set_ylabel(DEGREE.label(capitalised(called("contact_angle"))))
