"""A machine drawn to scale, and where on the drawing its parts are: for a page to take hold of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple

from matplotlib.figure import Figure

from rolamento.charts.frame import label_x
from rolamento.charts.style import MILLIMETRE, in_style
from rolamento.plots.machine_drawing import ACROSS, MM, Lane, Plan, draw_planned, place_of, planned
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.case.machine import Machine

__all__ = ["Grip", "Sketch", "sketch_machine"]

POINT: Final = 72.0 * MILLIMETRE
"""Points for a millimetre on paper."""
_FOOT: Final = 11.0
"""Height of the scale below a drawing, in mm."""
_HEAD: Final = 4.0
"""Room above it, likewise: for the sign of gravity."""
_ON_TOP: Final = ("loads", "gears", "belts", "masses")


class Grip(NamedTuple):
    """Where a part of a machine is on its drawing.

    part: its dotted field, such as ``"loads.0"``. x, y: of the point to take hold of; axis: height
    of its shaft's axis; in points from the top left corner.
    """

    part: str
    x: float
    y: float
    axis: float


class Sketch(NamedTuple):
    """A drawing of a machine, lengths on it in points from its top left corner.

    left: where x = 0 is; scale: points for a metre. axes: height of the axis of each shaft, by
    name.
    """

    figure: Figure
    width: float
    height: float
    left: float
    scale: float
    axes: dict[str, float]
    grips: tuple[Grip, ...]


@in_style
def sketch_machine(machine: Machine, *, step: int = 0, width: float = ACROSS) -> Sketch:
    """Draw a machine as `rolamento.plots.machine_drawing.draw_machine` does, on paper of a width.

    Parameters
    ----------
    machine
        The machine, solved or not.
    step
        Of its spectrum, from 0.
    width
        Of the paper, in mm.
    """
    plan = planned(machine, step, width)
    tall = _HEAD + plan.height + _FOOT
    figure = Figure(figsize=(width * MILLIMETRE, tall * MILLIMETRE))
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.0, _FOOT / tall, 1.0, plan.height / tall))
    draw_planned(axes, plan)
    low = MM * min(one.position for one in machine.shafts)
    high = MM * max(one.position + one.length for one in machine.shafts)
    start = 0.5 * (low + high - width * plan.paper)
    axes.set_xlim(start, start + width * plan.paper)
    axes.set_ylim(plan.bottom, plan.bottom + plan.height * plan.paper)
    label_x(axes, said("x (mm)"))
    points = POINT / plan.paper
    top = plan.bottom + plan.height * plan.paper

    def down(y: float) -> float:
        return points * (top - y) + POINT * _HEAD

    return Sketch(
        figure=figure,
        width=POINT * width,
        height=POINT * tall,
        left=-points * start,
        scale=MM * points,
        axes={
            name: down(middle)
            for lane, middle in zip(plan.lanes, plan.middle, strict=True)
            for name in lane.shafts
        },
        grips=tuple(
            Grip(part, points * (MM * x - start), down(middle + MM * away), down(middle))
            for lane, middle in zip(plan.lanes, plan.middle, strict=True)
            for part, x, away in _parts(lane, plan)
        ),
    )


def _parts(lane: Lane, plan: Plan) -> Iterator[tuple[str, float, float]]:
    """What is on the shafts of a lane: its field, where it is along x, how far from the axis; m."""
    machine = lane.machine
    outside = {name.x: name.surface for name in lane.below[: len(lane.bearings)]}
    for index, bearing in enumerate(machine.bearings):
        if bearing.shaft in lane.shafts:
            x = place_of(machine, bearing.shaft, bearing.position)
            yield f"bearings.{index}", x, -outside[x] - 0.5 * lane.seat * plan.paper / MM
    for kind in _ON_TOP:
        for index, part in enumerate(getattr(machine, kind)):
            if part.shaft in lane.shafts:
                x = place_of(machine, part.shaft, part.position)
                away = lane.surface(x, part.shaft)
                if kind == "masses":
                    away = max(away, 0.5 * (part.diameter or 0.0))
                yield f"{kind}.{index}", x, away
