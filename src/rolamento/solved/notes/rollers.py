"""Notes on rollers: lines, ends, tilt, what presses on them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento.contact.line import PRESSURE_LIMIT
from rolamento.numerics import FloatArray
from rolamento.solved.notes.bearing import (
    RADIAL_SHARE,
    misalignment,
    usual_misalignments,
    which_elements,
)
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

_PEAK: Final = 1.2
"""Pressure at a roller's end over the greatest elsewhere that deserves a note."""
_REACHES_END: Final = 0.7
"""Pressure at an end over the greatest on the roller from which on the end bears its share."""
_SHORT: Final = 0.7
"""Fraction of the slices of the most loaded roller: if fewer bear, it lies on a part of its
length."""


def rollers_unloaded(solved: Solved) -> Iterator[Note]:
    """Rollers that the inner ring does not touch, in rows that it touches at all."""
    free = ~solved.loaded[0] & solved.are_rollers
    free &= solved.loaded_elements[0, solved.elements.row] > 0
    if free.any():
        pressed = bool((solved.outer.load[0, free] > 0.0).any())
        yield Note("rollers_unloaded", {**which_elements(solved, free), "pressed_outward": pressed})


def line_pressures(solved: Solved) -> Iterator[Note]:
    """Pressures on rollers that indent the races."""
    for race, contacts in solved.contacts.items():
        over = (contacts.max_pressure[0] > PRESSURE_LIMIT) & solved.are_rollers
        if over.any():
            greatest = float(contacts.max_pressure[0, over].max())
            values = {"race": race, "max_pressure": greatest, "limit": PRESSURE_LIMIT}
            yield Note("line_pressure_high", {**values, **which_elements(solved, over)})


def misaligned(solved: Solved) -> Iterator[Note]:
    """A tilt between the rings beyond what makers let pass."""
    tilt = misalignment(solved)
    known = usual_misalignments(solved)
    if not known:
        return
    limit, kind = min(known, key=lambda one: one[0])
    if tilt > limit:
        wide = kind.usual_misalignment_of_wide
        values = {"tilt": tilt, "limit": limit, "element": kind.element}
        yield Note("rollers_misaligned", values if wide is None else {**values, "of_wide": wide})


def on_part_of_the_length(solved: Solved) -> Iterator[Note]:
    """A most loaded roller that lies on a part of its length only."""
    rollers = solved.rollers
    assert rollers is not None
    one = int(np.where(solved.are_rollers, solved.inner.load[0], -1.0).argmax())
    loads = (rollers.inner.load_per_length[0, one], rollers.outer.load_per_length[0, one])
    share = min(float((load > 0.0).mean()) for load in loads)
    if 0.0 < share < _SHORT:
        azimuth = float(solved.elements.azimuth[0, one])
        yield Note("roller_on_part_of_its_length", {"share": share, "azimuth": azimuth})


def ends(solved: Solved) -> Iterator[Note]:
    """Pressure peaks at the ends; of independent slices, ends that bear, which hides their peak."""
    rollers = solved.rollers
    assert rollers is not None
    coupled = solved.case.model.roller_contact == "coupled"
    loaded = solved.loaded[0] & solved.are_rollers
    found: list[tuple[float, dict[str, Any]]] = []
    for race, line in (("inner", rollers.inner), ("outer", rollers.outer)):
        end, inside = _end_and_inside(line.pressure[0])
        with np.errstate(invalid="ignore"):
            high = loaded & (end > (_PEAK if coupled else _REACHES_END) * inside)
        if high.any():
            worst = int(np.where(high, end, -1.0).argmax())
            values = {
                "race": race,
                "max_pressure": float(end[worst]),
                "ratio": float(end[worst] / inside[worst]) if inside[worst] > 0.0 else None,
            }
            barrels = all(one.barrels for one in solved.case.bearing.row_types)
            own = {"barrels": True} if barrels else {}
            found.append((float(end[worst]), {**values, **which_elements(solved, high), **own}))
    if found:  # of both races the one that suffers more
        worse = max(found, key=lambda one: one[0])[1]
        yield Note("edge_pressure_peak" if coupled else "edges_bear", worse)


def _end_and_inside(pressure: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The pressure at the more loaded end, and in the middle half of the length; (elements,)."""
    quarter = pressure.shape[1] // 4
    outside = max(quarter // 4, 1)
    ends = np.maximum(pressure[:, :outside].max(axis=1), pressure[:, -outside:].max(axis=1))
    return ends, pressure[:, quarter:-quarter].max(axis=1)


def axial_load_on_torus(solved: Solved) -> Iterator[Note]:
    """An axial load on a toroidal bearing, which lets the shaft shift until the rollers wedge."""
    axial = float(solved.load.fx[0])
    radial = float(np.hypot(solved.load.fy[0], solved.load.fz[0]))
    if any(one.floats and one.barrels for one in solved.case.bearing.row_types) and (
        abs(axial) > RADIAL_SHARE * radial
    ):
        values = {"axial": axial, "shift": abs(float(solved.displacement.x[0]))}
        yield Note("toroidal_under_axial_load", values)
