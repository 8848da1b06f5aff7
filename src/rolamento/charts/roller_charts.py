"""What rollers bear along their length, and how one lies between its races.

Along a roller places are counted from its middle, toward +x; of a tapered one along its axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from rolamento.charts.along_roller import (
    LyingRoller,
    lying_roller,
    place_name,
    pressure_along,
    roller_label,
    tilted_name,
)
from rolamento.charts.axes_units import MEGAPASCAL, MILLIMETRE
from rolamento.charts.contacts import Shown
from rolamento.charts.courses import peak
from rolamento.charts.palette import Look, race_look
from rolamento.charts.record import Axis, Chart, Line, Mark, Spread
from rolamento.geometry import Race
from rolamento.solved import Solved
from rolamento.words import said

__all__ = ["along_chart", "between_chart", "pressure_line"]

ROOM: Final = 1.08
"""Length of the axis along a roller over its effective length."""


def pressure_line(
    solved: Solved, roller: int, race: Race, name: str, look: Look, *, faint: bool = False
) -> Line:
    """Return the maximum pressure (MPa) across the contact, along a roller (mm)."""
    rollers = solved.rollers
    assert rollers is not None
    x = MILLIMETRE.of(rollers.slice_place[0, roller])
    valid = np.zeros(len(x), dtype=np.bool_) if faint else None
    return Line(x, pressure_along(rollers, race)[roller], name, look, valid=valid)


def along_chart(
    lines: Sequence[Line],
    cases: Sequence[Solved],
    name: str,
    conclusion: str = "",
    marks: Sequence[Mark] = (),
) -> Chart:
    """Return lines along rollers, and where their effective length ends.

    Parameters
    ----------
    lines
        From `pressure_line`.
    cases
        Whose rollers they are.
    name
        What the upright axis is called.
    conclusion, marks
        As of a chart; by default it concludes in the highest point of its lines.
    """
    half = max(0.5e3 * float(np.nanmax(solved.rows.effective_length[0])) for solved in cases)
    look = Look("grey", "dot", width=0.5)
    ends = [Mark(end, "", look, "x") for end in (-half, half)]
    along = Axis(place_name(cases[0]), MILLIMETRE.symbol, (-ROOM * half, ROOM * half))
    upright = Axis(name, MEGAPASCAL.symbol, zero=True)
    most = conclusion or peak([(one.name, one.x, one.y) for one in lines], along, upright)
    return Chart(tuple(lines), along, upright, most, marks=(*marks, *ends))


def between_chart(one: Shown, roller: int) -> Chart:
    """Return a roller between its races, heights many times those of lengths; its body is cut.

    Parameters
    ----------
    one
        A case of a roller bearing.
    roller
        Counted from 0.
    """
    lies = lying_roller(one.solved, roller)
    x, reaches = lies.x, ROOM * float(np.abs(lies.x).max())
    name = one.named(tilted_name(roller_label(one.solved, roller), lies.tilt))
    outline = Line(
        np.r_[x, x[::-1], x[0]], np.r_[lies.above, lies.below[::-1], lies.above[0]], name,
        Look("ink", width=0.75), filled=True,
    )  # fmt: skip
    axis = Line(x, lies.axis, one.named(said("axis of the roller")),
                Look("grey", "longdashdot", width=0.6))  # fmt: skip
    inner = tilted_name(said("inner race"), lies.ring_tilt)
    return Chart(
        (
            *_bodies(lies),
            outline,
            *_pressed(lies),
            axis,
            Line(x, lies.race_above, one.named(said("outer race")), race_look("outer")),
            Line(x, lies.race_below, one.named(inner), race_look("inner")),
        ),
        Axis(place_name(one.solved), MILLIMETRE.symbol, (-reaches, reaches)),
        Axis(said("Radial height"), "µm", (lies.bottom, lies.top)),
        name,
        outlines=True,
    )  # fmt: skip


def _bodies(lies: LyingRoller) -> list[Spread]:
    """Return the bodies of the races, out of the frame."""
    far = np.full(len(lies.x), 10.0 * (lies.top - lies.bottom))
    grey = Look("grey")
    return [
        Spread(lies.x, lies.race_above, lies.top + far, "", grey, hatched=True),
        Spread(lies.x, lies.bottom - far, lies.race_below, "", grey, hatched=True),
    ]


def _pressed(lies: LyingRoller) -> list[Spread]:
    """Return where roller and races overlap: there they press on each other."""
    outer = np.where(lies.above > lies.race_above, lies.race_above, lies.above)
    inner = np.where(lies.below < lies.race_below, lies.race_below, lies.below)
    return [
        Spread(lies.x, outer, lies.above, "", race_look("outer")),
        Spread(lies.x, lies.below, inner, "", race_look("inner")),
    ]
