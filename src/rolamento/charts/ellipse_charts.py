"""Contact ellipses to scale, on a groove that is rolled out flat.

Across the groove an ellipse lies at its contact angle times the radius of the groove, counted
from the bottom; along it the balls stand side by side, not at their true distance, which is many
times the width of an ellipse.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rolamento.charts.axes_units import MILLIMETRE
from rolamento.charts.contacts import Shown
from rolamento.charts.groove import Slot
from rolamento.charts.palette import Look, race_look
from rolamento.charts.record import Axis, Chart, Ellipses, Line, Mark
from rolamento.charts.texts import number
from rolamento.geometry import Race
from rolamento.words import said

__all__ = ["ellipse_chart"]


def ellipse_chart(
    cases: Sequence[tuple[Shown, Sequence[Slot]]],
    race: Race,
    *,
    across: Axis,
    along: Axis,
    margin: float,
    prefix: str = "",
) -> Chart:
    """Return the ellipses of one race, and bottom and edges of its groove.

    Parameters
    ----------
    cases
        Each with the places of its balls, of which ``along`` says where they stand.
    race
        ``"inner"`` or ``"outer"``.
    across, along
        The upright axis, across the groove (mm), and that along it, likewise.
    margin
        How far (mm) an edge reaches beyond the first and the last ball of a row.
    prefix
        What stands before names, where the race does not stand elsewhere.
    """
    series: list[Ellipses | Line] = []
    for one, slots in cases:
        color = race_look(race, one.place)
        for over, what in ((False, said("contact ellipse")), (True, said("ellipse over the edge"))):
            own = [slot for slot in slots if slot.touches and slot.over_edge is over]
            if not own:
                continue
            look = Look("bad" if over else color.color, color.dash, width=0.6)
            columns = ("along", "across", "semi_minor", "semi_major")
            x, y, width, height = (np.array([getattr(slot, name) for slot in own])
                                   for name in columns)  # fmt: skip
            name = said("{race}: {what}", race=prefix, what=what) if prefix else what
            series.append(
                Ellipses(x, y, width, height, one.named(name), look, hatched=over,
                         filled=not one.place)
            )  # fmt: skip
        series += _edges(one, slots, margin)
    bottom = Mark(0.0, said("bottom of the groove"), Look("grey", "longdashdot", width=0.5))
    said_of = (_of_ellipses(one, slots) for one, slots in cases)
    return Chart(tuple(series), along, across, "; ".join(said_of), marks=(bottom,), outlines=True)


def _of_ellipses(one: Shown, slots: Sequence[Slot]) -> str:
    """Say how large the longest ellipse is, and how many run over the edge."""
    touching = [slot for slot in slots if slot.touches]
    if not touching:
        return one.named(said("no ball touches the race"))
    longest = max(touching, key=lambda slot: slot.semi_major)
    long, wide = (number(2.0 * one, 3) for one in (longest.semi_major, longest.semi_minor))
    count = sum(slot.over_edge for slot in touching)
    size = said("longest ellipse {long} mm × {wide} mm", long=long, wide=wide)
    over = said("{count} of {all} over the edge of the groove", count=count, all=len(touching))
    return one.named(f"{size}; {over}")


def _edges(one: Shown, slots: Sequence[Slot], margin: float) -> list[Line]:
    """Return the edges of the groove, below and above each row of balls."""
    x: list[float] = []
    y: list[float] = []
    for row in sorted({slot.row for slot in slots if slot.shoulder}):
        own = [slot for slot in slots if slot.row == row]
        for side in (-own[0].edge, own[0].edge):
            x += [own[0].along - margin, own[-1].along + margin, np.nan]
            y += [side, side, np.nan]
    look = Look("ink", "dot" if one.place else "solid", width=0.8)
    name = one.named(said("edge of the groove"))
    return [Line(np.array(x), np.array(y), name, look)] if x else []


def across_axis(name: str, low: float, high: float) -> Axis:
    """Return the axis across a groove, to the scale of that along it."""
    return Axis(name, MILLIMETRE.symbol, (low, high), equal=True)
