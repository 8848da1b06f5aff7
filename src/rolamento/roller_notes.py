"""Notes on rollers: as `rolamento.notes`, of what balls do not have: lines, ends, tilt, ribs."""

from __future__ import annotations

from collections.abc import Iterator
from math import tan
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import AXES
from rolamento.contact.line import PRESSURE_LIMIT
from rolamento.numerics import BoolArray, FloatArray
from rolamento.types import BearingType
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.solved import Rollers, Solved

__all__ = [
    "are_rollers",
    "misalignment",
    "notes_on_rollers",
    "rollers_without_equilibrium",
    "usual_misalignments",
    "which_elements",
]

_PEAK: Final = 1.2
"""Pressure at a roller's end over the greatest elsewhere that deserves a note."""
_REACHES_END: Final = 0.7
"""Pressure at an end over the greatest on the roller from which on the end bears its share."""
_SHORT: Final = 0.7
"""Fraction of the slices of the most loaded roller: if fewer bear, it lies on a part of its
length."""


def are_rollers(solved: Solved) -> BoolArray:
    """Which elements are rollers; (elements,)."""
    kinds = np.array([element != "ball" for element in solved.rows.element])
    return np.asarray(kinds[solved.elements.row])


def which_elements(solved: Solved, chosen: BoolArray) -> dict[str, Any]:
    """Which balls or rollers of the first case a note is about; of a set also their rows."""
    rollers = solved.rollers is not None and bool(are_rollers(solved)[chosen].any())
    found = {
        "rollers" if rollers else "balls": np.flatnonzero(chosen).tolist(),
        "azimuths": solved.elements.azimuth[0, chosen].tolist(),
    }
    if len(solved.rows) < 2:
        return found
    row = solved.elements.row
    whole = [int(one) for one in np.unique(row[chosen]) if chosen[row == one].all()]
    return {**found, "rows": row[chosen].tolist(), "whole_rows": whole}


def misalignment(solved: Solved) -> float:
    """Return the angle between the rings of the first case (rad)."""
    return float(np.hypot(solved.displacement.ry[0], solved.displacement.rz[0]))


def notes_on_rollers(solved: Solved) -> Iterator[Note]:
    """Return the notes on the rollers of a single case with a result."""
    rollers = solved.rollers
    assert rollers is not None
    yield from _unloaded(solved)
    yield from _pressures(solved)
    yield from _misaligned(solved)
    yield from _on_part_of_the_length(solved, rollers)
    yield from _ends(solved, rollers)


def _unloaded(solved: Solved) -> Iterator[Note]:
    """Rollers that the inner ring does not touch, in rows that it touches at all."""
    free = ~solved.loaded[0] & are_rollers(solved)
    free &= solved.loaded_elements[0, solved.elements.row] > 0
    if free.any():
        pressed = bool((solved.outer.load[0, free] > 0.0).any())
        yield Note("rollers_unloaded", {**which_elements(solved, free), "pressed_outward": pressed})


def _pressures(solved: Solved) -> Iterator[Note]:
    for race, contacts in solved.contacts.items():
        over = (contacts.max_pressure[0] > PRESSURE_LIMIT) & are_rollers(solved)
        if over.any():
            greatest = float(contacts.max_pressure[0, over].max())
            values = {"race": race, "max_pressure": greatest, "limit": PRESSURE_LIMIT}
            yield Note("line_pressure_high", {**values, **which_elements(solved, over)})


def _misaligned(solved: Solved) -> Iterator[Note]:
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


def usual_misalignments(solved: Solved) -> list[tuple[float, BearingType]]:
    """Tilt (rad) that makers let pass of each row for which a source gives it, with its type."""
    kinds = solved.case.bearing.row_types
    return [(one.usual_misalignment, one) for one in kinds if one.usual_misalignment is not None]


def _on_part_of_the_length(solved: Solved, rollers: Rollers) -> Iterator[Note]:
    """A most loaded roller that lies on a part of its length only."""
    one = int(np.where(are_rollers(solved), solved.inner.load[0], -1.0).argmax())
    loads = (rollers.inner.load_per_length[0, one], rollers.outer.load_per_length[0, one])
    share = min(float((load > 0.0).mean()) for load in loads)
    if 0.0 < share < _SHORT:
        azimuth = float(solved.elements.azimuth[0, one])
        yield Note("roller_on_part_of_its_length", {"share": share, "azimuth": azimuth})


def _ends(solved: Solved, rollers: Rollers) -> Iterator[Note]:
    """Pressure peaks at the ends; of independent slices, ends that bear, which hides their peak."""
    coupled = solved.case.model.roller_contact == "coupled"
    loaded = solved.loaded[0] & are_rollers(solved)
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


# --- advice ---------------------------------------------------------------------------------------


def rollers_without_equilibrium(
    case: Case, axis: int, load: tuple[float, float], *, tilts: bool
) -> Note:
    """Name the direction in which nothing supports a ring with rollers, and what would.

    Every tapered roller presses at α_o, and all together with F_a ≥ F_r tan α_o; with more axial
    load than that, rings that are kept aligned find their place. Then it is the free tilt that
    does not.

    Parameters
    ----------
    case
        Of the rows.
    axis
        The direction, as in `AXES`.
    load
        Axial and radial, as given (N).
    tilts
        Whether the ring is free to tilt.
    """
    kinds = case.bearing.row_types
    if axis == 0 and all(one.floats for one in kinds):
        return Note("ribs_do_not_hold")
    if axis == 0 and all(one.conical for one in kinds):
        signs = {place.sign for place in case.bearing.places}
        if len(signs) == 1:
            toward, away = ("+x", "-x") if signs == {1.0} else ("-x", "+x")
            axial, radial = load
            needed = radial * max(tan(place.bearing.row_angle) for place in case.bearing.places)
            if tilts and axial * signs.pop() > needed:
                return Note("tapered_free_to_tilt", {"axial": abs(axial), "needed": needed})
            return Note("tapered_unsupported_axially", {"toward": toward, "away": away})
    return Note("rollers_unsupported", {"axis": AXES[axis]})
