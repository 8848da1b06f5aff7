"""Notes on a bearing of any type, and what the other notes ask of a result."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, pi, radians
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS
from rolamento.numerics import BoolArray
from rolamento.types import BearingType
from rolamento.words import Note
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

MILLION: Final = 1e3 * pi / 30.0
"""10⁶ mm·rpm in rad·m/s."""
SPEED_LIMIT: Final = 3.0 * MILLION
"""n d_m of the fastest hybrid spindle bearings."""
TILT_LIMIT: Final = radians(1.0)
"""rad: the equations take tilts as small; at 1 degree that costs up to 2 % of BD."""
SPHERE_TILT_LIMIT: Final = radians(2.5)
"""rad: what makers permit of most self-aligning ball bearings, 1.5° to 3° by series (general
knowledge, no page at hand)."""
FREE_STIFFNESS: Final = 1e-9
"""Fraction of the greatest stiffness: a direction with less is free."""
PRELOAD_MARGIN: Final = 1.1
"""Times the load at which a row lifts off: what is nearer deserves a note."""
RADIAL_SHARE: Final = 0.01
"""Radial over axial load of a thrust bearing above which it is no longer what is left of rounding
or of an alignment."""


def other_than_said(solved: Solved) -> Iterator[Note]:
    """What the designation says and the solved bearing is not: they lead."""
    case = solved.case
    bearing = case.bearing
    resolved = bearing.resolved
    assert resolved is not None
    preload, own = resolved.designation.letters.preload, case.life
    if preload is not None and bearing.preload is None:
        values = {"part": preload.text, "meaning": preload.meaning}
        yield Note("designation_preload", {"designation": bearing.designation, **values})
    for note in resolved.notes:
        rated = own is not None and own.dynamic_rating is not None
        if note.key == "stainless_rating" and rated:
            continue
        if note.key == "pair_clearance_not_listed" and (
            not bearing.is_set or bearing.preload is not None
        ):
            continue
        yield note


def lost_rows(solved: Solved) -> Iterator[Note]:
    """Rows of a set that the inner ring does not touch at all."""
    if solved.case.bearing.bearing_type.has_arches:
        return  # one pair of arcs is all that an axial load needs
    loaded = solved.loaded_elements[0]
    lost = np.flatnonzero(loaded == 0).tolist()
    if lost and len(lost) < len(loaded):
        preloaded = solved.case.bearing.preload is not None
        key = "row_unloaded" if solved.rollers is None else "row_of_elements_unloaded"
        yield Note(key, {"rows": lost, "preloaded": preloaded})


def lost_contacts(solved: Solved) -> Iterator[Note]:
    """Balls that the inner ring does not touch."""
    free = ~solved.loaded[0]
    if free.all() and nothing_given(solved):
        yield Note("no_load_given", {"speed": turns(solved)})
        return
    if free.all():
        yield Note("no_ball_loaded" if solved.rollers is None else "no_element_loaded")
        return
    free &= ~solved.are_rollers
    if solved.case.bearing.bearing_type.has_arches:  # both rows of contacts are of the same balls
        free = np.tile(free.reshape(2, -1).all(axis=0), 2)
        free[len(free) // 2 :] = False
    else:  # rows that the ring does not touch at all have a note of their own
        free &= solved.loaded_elements[0, solved.elements.row] > 0
    if free.any():
        pressed = bool((solved.outer.load[0, free] > 0.0).any())
        model = solved.case.model
        alone = model.cage == "none" and model.raceway_control != "friction"
        balls = which_elements(solved, free)
        yield Note(
            "balls_unloaded",
            {**balls, "pressed_outward": pressed, "cage_drives": pressed and not alone},
        )
        if pressed and alone:
            yield Note("orbit_assumed", balls)


def speeds(solved: Solved) -> Iterator[Note]:
    """A speed beyond what such bearings are known to run at."""
    product = speed_factor(solved)
    if product > SPEED_LIMIT:
        yield Note("speed_factor_high", {"speed_factor": product, "limit": SPEED_LIMIT})


def tilts(solved: Solved) -> Iterator[Note]:
    """A tilt of the ring beyond what the equations, or makers, let pass."""
    worst = max(abs(float(solved.displacement.ry[0])), abs(float(solved.displacement.rz[0])))
    if solved.case.bearing.bearing_type.aligns:
        if worst > SPHERE_TILT_LIMIT:
            yield Note("tilt_beyond_self_aligning", {"tilt": worst, "limit": SPHERE_TILT_LIMIT})
        return
    if worst > TILT_LIMIT:
        yield Note("tilt_large", {"tilt": worst, "limit": TILT_LIMIT})


def free_directions(solved: Solved) -> Iterator[Note]:
    """Directions without load and without stiffness: their displacement is arbitrary."""
    if not np.any(solved.load):
        return  # nothing is held, and lost_contacts says so
    free = free_degrees(solved)
    if solved.case.bearing.bearing_type.aligns:
        free[3:] = False  # see free_tilt
    if solved.rollers is not None and all(one.floats for one in solved.case.bearing.row_types):
        free[0] = False  # cylindrical rollers let a shaft shift: that is what they are for
    kind = solved.case.bearing.bearing_type
    if kind.straight and kind.washers:
        free[1:3] = False  # flat washers do not hold each other
    arm = 0.5 * float(solved.rows.pitch_diameter[0, 0])
    arms = np.array([1.0, 1.0, 1.0, arm, arm])
    scaled = solved.stiffness.array[0] / np.outer(arms, arms)
    vectors, values, _ = np.linalg.svd(scaled[np.ix_(free, free)])
    names = [axis for axis, is_free in zip(AXES, free, strict=True) if is_free]
    for value, vector in zip(values, vectors.T, strict=True):
        if value <= FREE_STIFFNESS * np.abs(scaled).max():
            key = "direction_unsupported"
            if solved.rollers is not None:
                key = "direction_unsupported_by_rollers"
            yield Note(key, {"axis": names[int(np.abs(vector).argmax())]})


def free_tilt(solved: Solved) -> Iterator[Note]:
    """The tilt of a self-aligning bearing that is not given: nothing determines it."""
    if free_degrees(solved)[3:].any():
        yield Note("tilt_undetermined")


def estimated_geometry(solved: Solved) -> Iterator[Note]:
    """An internal geometry that stands in for one that the catalogue does not have."""
    bearing = solved.case.bearing
    name, resolved = bearing.designation, bearing.resolved
    assert resolved is not None
    if "inferred" not in bearing.origins.values():
        return
    alike = sum(one.reproduces for one in resolved.candidates)
    if bearing.from_given_ratings:
        yield Note("geometry_estimated_from_given", {"designation": name, "count": alike})
    elif alike > 1:
        yield Note("geometry_estimated", {"designation": name, "count": alike})
    else:
        yield Note("geometry_estimated_uniquely", {"designation": name})


def letters(solved: Solved) -> Iterator[Note]:
    """What of a designation changes nothing, or is not understood."""
    bearing = solved.case.bearing
    name, resolved = bearing.designation, bearing.resolved
    assert resolved is not None
    letters, listed = resolved.designation.letters, resolved.bearing
    if resolved.stands_in:
        known = {"maker": listed.maker, "listed": listed.designation}
        yield Note("designation_listed_as", {"designation": name, **known})
    if resolved.idle:
        parts = [list(part) for part in resolved.idle]
        yield Note("designation_without_effect", {"designation": name, "parts": parts})
    if letters.unknown:
        unknown = list(letters.unknown)
        yield Note("designation_not_understood", {"designation": name, "parts": unknown})


def nearly_lost(solved: Solved) -> Iterator[Note]:
    """A row of a preloaded set that is about to lift off."""
    if solved.preload is None:
        return
    row, factor = solved.preload.lost_row, solved.preload.loss_factor
    if row is None or factor is None or not 1.0 <= factor < PRELOAD_MARGIN:
        return
    if solved.loaded_elements[0, row]:  # else lost_rows says so
        yield Note("preload_nearly_lost", {"row": row, "factor": float(factor)})


def radial_load_on_thrust(solved: Solved) -> Iterator[Note]:
    """A radial load on a bearing whose grooves are for an axial one."""
    radial, axial = given_forces(solved)
    if is_washers(solved.case) and radial > RADIAL_SHARE * abs(axial):
        note = Note("thrust_under_radial_load", {"radial": radial, "axial": axial})
        yield of_element(note, solved.case.bearing.bearing_type.rolls)


# --- what notes ask -------------------------------------------------------------------------------


def nothing_given(solved: Solved) -> bool:
    """Return whether neither load, displacement nor preload loads the first case at all."""
    given = [f"duty.load.{name}" for name in LOADS] + [f"duty.displacement.{name}" for name in AXES]
    known = (solved.field(name)[0] for name in given)
    return not (any(value and isfinite(value) for value in known) or solved.loaded[0].any())


def which_elements(solved: Solved, chosen: BoolArray) -> dict[str, Any]:
    """Which balls or rollers of the first case a note is about; of a set also their rows."""
    rollers = solved.rollers is not None and bool(solved.are_rollers[chosen].any())
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


def usual_misalignments(solved: Solved) -> list[tuple[float, BearingType]]:
    """Tilt (rad) that makers let pass of each row for which a source gives it, with its type."""
    kinds = solved.case.bearing.row_types
    return [(one.usual_misalignment, one) for one in kinds if one.usual_misalignment is not None]


def speed_factor(solved: Solved) -> float:
    """The faster ring's n times d_m of the largest row; rad·m/s."""
    speed = max(abs(float(solved.field(f"duty.{race}_speed")[0])) for race in ("inner", "outer"))
    return speed * float(solved.rows.pitch_diameter[0].max())


def free_degrees(solved: Solved) -> BoolArray:
    """Which degrees of freedom take a load rather than a displacement; (5,)."""
    free = np.array(solved.case.duty.free)
    for i, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        free[i] |= f"duty.load.{load}" in solved.varied
        free[i] &= f"duty.displacement.{axis}" not in solved.varied
    return free


def given_forces(solved: Solved) -> tuple[float, float]:
    """Radial and axial load of the first case as given, 0 where a displacement is (N)."""
    fx, fy, fz = (float(np.nan_to_num(solved.field(f"duty.load.{n}")[0])) for n in LOADS[:3])
    return float(np.hypot(fy, fz)), fx


def is_washers(case: Case) -> bool:
    """Whether it is a thrust bearing of 90°, which is for axial load alone."""
    bearing = case.bearing
    return bearing.bearing_type.washers and (bearing.contact_angle or 0.0) > 0.5 * pi * (1.0 - 1e-9)


def turns(solved: Solved) -> bool:
    """Whether one ring turns past the other in the first case."""
    return bool(solved.field("duty.inner_speed")[0] != solved.field("duty.outer_speed")[0])
