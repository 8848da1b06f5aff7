"""Notes on a result, and advice where there is none.

A note never changes a number. Each check reads one solved case and returns notes: limits exceeded,
contacts lost, assumptions strained. Their sentences are in `rolamento.words.sentences.solved`.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, isfinite, pi, radians
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.bearing import ball_bearing
from rolamento.case.duty import AXES, LOADS
from rolamento.geometry import Race, edge_cosine
from rolamento.kinematics import (
    RacewayControl,
    ball_mass,
    centrifugal_force,
    friction_demand,
    jones_control,
    nominal_orbit,
)
from rolamento.numerics import BoolArray
from rolamento.roller_notes import (
    are_rollers,
    notes_on_rollers,
    rollers_without_equilibrium,
    which_elements,
)
from rolamento.status import (
    CONVERGED,
    GREATEST_APPROACH,
    INVALID_INPUT,
    NO_EQUILIBRIUM,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
    UNCONSTRAINED_BALL,
)
from rolamento.words import Note
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.solved import Solved

_MILLION: Final = 1e3 * pi / 30.0
"""10⁶ mm·rpm in rad·m/s."""
_FASTEST: Final = 4.0 * _MILLION
"""n d_m beyond which no ball bearing is known to have run. Bamberger, Zaretsky and Signer
(1976) ran main-shaft bearings of jet engines at 3e6 mm·rpm, by the bore."""
_PRESSURE_LIMIT: Final = 4.2e9
_PRESSURE_LIMIT_SELF_ALIGNING: Final = 4.6e9
"""Pa; permanent set of 1e-4 ball diameters at the contact of ball and race (ISO 76:2006)."""
SPEED_LIMIT: Final = 3.0 * _MILLION
"""n d_m of the fastest hybrid spindle bearings."""
TILT_LIMIT: Final = radians(1.0)
"""rad: the equations take tilts as small; at 1 degree that costs up to 2 % of BD."""
SPHERE_TILT_LIMIT: Final = radians(2.5)
"""rad: what makers permit of most self-aligning ball bearings, 1.5° to 3° by series (general
knowledge, no page at hand)."""
FRICTION_LIMIT: Final = 0.1
"""Coefficient of friction above which a lubricated contact will hardly hold the ball."""
SPINNING_ANGLE: Final = radians(0.1)
"""rad: a ball at a smaller contact angle hardly spins, whichever race controls it."""
FREE_STIFFNESS: Final = 1e-9
"""Fraction of the greatest stiffness: a direction with less is free."""
PAST_EDGE: Final = 1e-9
"""Fraction of the groove's offset: what is less is rounding."""
PRELOAD_MARGIN: Final = 1.1
"""Times the load at which a row lifts off: what is nearer deserves a note."""
SKID_LIMIT: Final = 0.05
"""Fraction of the cage's speed under outer raceway control: what differs more deserves a note."""
ORBIT_SLACK: Final = 1e-9
"""Fraction of the faster ring's speed: an orbit that is further outside both is no rounding."""
SPIN_LIMIT: Final = 0.05
"""Spin to roll at both races above which no race can be said to control a ball."""
FOUR_POINT_LOAD_RATIO: Final = 1.27
"""F_a/F_r from which on the balls of a four-point bearing (35°, series QJ 2 and QJ 3) bear on one
arc of each ring only, as they should: SKF, Rolling bearings, four-point contact ball bearings, load
ratio. SLF's catalogue has 1.2."""
_RADIAL_SHARE: Final = 0.01
"""Radial over axial load of a thrust bearing above which it is no longer what is left of rounding
or of an alignment."""


def notes_on(solved: Solved) -> tuple[Note, ...]:
    """The notes on a single case; none without a result."""
    if not solved.converged[0]:
        return ()
    checks = (
        _other_than_said, _lost_rows, _lost_contacts, _pressures, _past_edge, _shoulders,
        _speeds, _tilts, _free_directions, _free_tilt, _control, _orbits, _gyroscopic_slip,
        _gyroscopic_left_out, _arches, _rolling, _estimated_geometry, _letters, _nearly_lost,
        _radial_load_on_thrust, _four_point_load, _axial_load_on_torus,
    )  # fmt: skip
    notes = tuple(note for check in checks for note in check(solved))
    return notes if solved.rollers is None else (*notes, *notes_on_rollers(solved))


def pressure_limit(case: Case) -> float:
    """Return the contact pressure from which balls of a bearing indent its races (Pa; ISO 76)."""
    sphere = case.bearing.bearing_type.aligns
    return _PRESSURE_LIMIT_SELF_ALIGNING if sphere else _PRESSURE_LIMIT


def jones_verdict(solved: Solved) -> NDArray[np.int64]:
    """Which race controls every element by Jones's criterion: codes (cases, elements)."""
    inner, outer = solved.inner, solved.outer
    return jones_control(
        inner.resistance_to_spin,
        outer.resistance_to_spin,
        inner.contact_angle,
        outer.contact_angle,
    )


def _lost_rows(solved: Solved) -> Iterator[Note]:
    """Rows of a set that the inner ring does not touch at all."""
    if solved.case.bearing.bearing_type.has_arches:
        return  # one pair of arcs is all that an axial load needs
    loaded = solved.loaded_elements[0]
    lost = np.flatnonzero(loaded == 0).tolist()
    if lost and len(lost) < len(loaded):
        preloaded = solved.case.bearing.preload is not None
        key = "row_unloaded" if solved.rollers is None else "row_of_elements_unloaded"
        yield Note(key, {"rows": lost, "preloaded": preloaded})


def _lost_contacts(solved: Solved) -> Iterator[Note]:
    """Balls that the inner ring does not touch."""
    free = ~solved.loaded[0]
    if nothing_given(solved):
        yield Note("no_load_given", {"speed": _turns(solved)})
        return
    if free.all():
        yield Note("no_ball_loaded" if solved.rollers is None else "no_element_loaded")
        return
    free &= ~are_rollers(solved)
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


def _pressures(solved: Solved) -> Iterator[Note]:
    limit = pressure_limit(solved.case)
    for race, contacts in solved.contacts.items():
        over = (contacts.max_pressure[0] > limit) & ~are_rollers(solved)
        if over.any():
            yield Note(
                "contact_pressure_high",
                {
                    "race": race,
                    "max_pressure": float(contacts.max_pressure[0, over].max()),
                    "limit": limit,
                    **which_elements(solved, over),
                },
            )


def _past_edge(solved: Solved) -> Iterator[Note]:
    """Balls that the inner groove has left, so that nothing presses on them."""
    if solved.rollers is not None:
        return
    if solved.case.bearing.bearing_type.has_arches:
        return  # a ball that is beside one arc is on the other
    inner, rows = solved.inner, solved.rows
    length = rows.per_element((rows.inner_conformity - 0.5) * rows.ball_diameter)
    past = ((inner.approach > PAST_EDGE * length) & (inner.load == 0.0))[0]
    if past.any():
        yield Note("ball_past_groove_edge", which_elements(solved, past))


def _shoulders(solved: Solved) -> Iterator[Note]:
    """Contact ellipses that run over the edge of their groove."""
    if solved.rollers is not None:
        return
    bearings = [place.bearing for place in solved.case.bearing.places]
    row = solved.elements.row
    for race, contacts in solved.contacts.items():
        ends = np.array([acos(float(edge_cosine(bearing, race))) for bearing in bearings])[row]
        if race == "outer" and solved.case.bearing.bearing_type.aligns:
            continue  # a sphere has no shoulder
        bottom = ball_bearing(solved.case).groove_bottom
        reach = np.abs(contacts.contact_angle - bottom) + contacts.semi_major / (
            contacts.conformity * contacts.ball_diameter
        )
        reach = np.where(contacts.load == 0.0, 0.0, reach)[0]
        over = reach > ends
        if over.any():
            worst = int(np.argmax(reach - ends))
            given = getattr(bearings[row[worst]], f"{race}_shoulder_height") is not None
            yield Note(
                "ellipse_over_shoulder",
                {
                    "race": race,
                    "reach": float(reach[worst]),
                    "edge": float(ends[worst]),
                    "shoulder_given": given,
                    **which_elements(solved, over),
                },
            )


def _arches(solved: Solved) -> Iterator[Note]:
    """Contact ellipses of a four-point bearing that run over the middle of their arch."""
    bearing = solved.case.bearing
    if not bearing.bearing_type.has_arches:
        return
    shim = solved.field("bearing.shim_angle")[0]
    for race, contacts in solved.contacts.items():
        radius = contacts.conformity * contacts.ball_diameter
        middle = np.arcsin((1.0 - 0.5 / contacts.conformity) * np.sin(shim))
        reach = (contacts.contact_angle - contacts.semi_major / radius)[0]
        over = (contacts.load[0] > 0.0) & (reach < middle[0])
        if over.any():
            yield Note(
                "ellipse_over_arch",
                {"race": race, "reach": float(reach[over].min()), **which_elements(solved, over)},
            )


def _speeds(solved: Solved) -> Iterator[Note]:
    product = _speed_factor(solved)
    if product > SPEED_LIMIT:
        yield Note("speed_factor_high", {"speed_factor": product, "limit": SPEED_LIMIT})


def _speed_factor(solved: Solved) -> float:
    """The faster ring's n times d_m of the largest row; rad·m/s."""
    speed = max(abs(float(solved.field(f"duty.{race}_speed")[0])) for race in ("inner", "outer"))
    return speed * float(solved.rows.pitch_diameter[0].max())


def _tilts(solved: Solved) -> Iterator[Note]:
    worst = max(abs(float(solved.displacement.ry[0])), abs(float(solved.displacement.rz[0])))
    if solved.case.bearing.bearing_type.aligns:
        if worst > SPHERE_TILT_LIMIT:
            yield Note("tilt_beyond_self_aligning", {"tilt": worst, "limit": SPHERE_TILT_LIMIT})
        return
    if worst > TILT_LIMIT:
        yield Note("tilt_large", {"tilt": worst, "limit": TILT_LIMIT})


def _free_directions(solved: Solved) -> Iterator[Note]:
    """Directions without load and without stiffness: their displacement is arbitrary."""
    if not solved.load.array.any():
        return  # nothing is held, and _lost_contacts says so
    free = _free(solved)
    if solved.case.bearing.bearing_type.aligns:
        free[3:] = False  # see _free_tilt
    if solved.rollers is not None and all(one.floats for one in solved.case.bearing.row_types):
        free[0] = False  # cylindrical rollers let a shaft shift: that is what they are for
    if solved.rollers is not None and solved.case.bearing.bearing_type.washers:
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


def _free_tilt(solved: Solved) -> Iterator[Note]:
    """The tilt of a self-aligning bearing that is not given: nothing determines it."""
    if solved.case.bearing.bearing_type.aligns and _free(solved)[3:].any():
        yield Note("tilt_undetermined")


def _free(solved: Solved) -> BoolArray:
    """Which degrees of freedom take a load rather than a displacement; (5,)."""
    free = np.array(solved.case.duty.free)
    for i, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        free[i] |= f"duty.load.{load}" in solved.varied
        free[i] &= f"duty.displacement.{axis}" not in solved.varied
    return free


def _control(solved: Solved) -> Iterator[Note]:
    """Where Jones's criterion does not confirm the assumed raceway control."""
    if solved.rollers is not None:
        return
    assumed = solved.case.model.raceway_control
    if assumed in ("none", "friction") or not _turns(solved) or _with_the_cage(solved):
        return
    if assumed == "jones":
        undecided = solved.elements.raceway_control[0] == RacewayControl.INDETERMINATE
        if undecided.any():
            yield Note("jones_undecided", which_elements(solved, undecided))
        return
    against = RacewayControl.INNER if assumed == "outer" else RacewayControl.OUTER
    spinning = np.abs(solved.inner.contact_angle[0]) > SPINNING_ANGLE
    contradicted = (jones_verdict(solved)[0] == against) & spinning
    if contradicted.any():
        yield Note(
            "jones_contradicts", {"assumed": assumed, **which_elements(solved, contradicted)}
        )


def _orbits(solved: Solved) -> Iterator[Note]:
    """Balls that inner control drives faster or slower than either ring turns."""
    if solved.case.model.raceway_control not in ("inner", "jones") or solved.rollers is not None:
        return
    slow, fast = np.sort([solved.field(f"duty.{race}_speed")[0] for race in ("inner", "outer")])
    orbit = solved.elements.orbital_speed[0]
    outside = np.maximum(slow - orbit, orbit - fast) > ORBIT_SLACK * max(abs(slow), abs(fast))
    if outside.any():
        yield Note("orbit_outside", which_elements(solved, outside))


def _gyroscopic_slip(solved: Solved) -> Iterator[Note]:
    """Balls whose gyroscopic moment needs more friction than a lubricated contact gives."""
    mode = solved.case.model.raceway_control
    if mode == "friction" or _with_the_cage(solved) or solved.rollers is not None:
        return
    inner, outer, moment = solved.inner, solved.outer, solved.elements.gyroscopic_moment
    if mode == "none":  # both races share it
        load, share = np.minimum(inner.load, outer.load), 1.0
    else:
        by_inner = solved.elements.raceway_control == RacewayControl.INNER
        load, share = np.where(by_inner, inner.load, outer.load), 2.0
    needed = friction_demand(moment, inner.ball_diameter, load, share)
    needed = np.where(moment == 0.0, 0.0, needed)[0]
    slipping = needed > FRICTION_LIMIT
    if slipping.any():
        greatest = float(needed.max())
        yield Note(
            "gyroscopic_slip",
            {
                "friction_coefficient": greatest if isfinite(greatest) else None,
                "limit": FRICTION_LIMIT,
                **which_elements(solved, slipping),
            },
        )


def _with_the_cage(solved: Solved) -> bool:
    """Whether the balls are balanced without their gyroscopic moment: see `rows.grooves`."""
    return solved.case.bearing.bearing_type.with_cage_only


def _gyroscopic_left_out(solved: Solved) -> Iterator[Note]:
    """The size of the moment that no balance of these balls holds, and the friction it takes."""
    if not _with_the_cage(solved) or not _turns(solved):
        return
    moment = np.abs(solved.elements.gyroscopic_moment[0])
    if not moment.any():
        return
    inner, outer = solved.inner, solved.outer
    load = (inner.load + outer.load)[0]
    faces = len(solved.rows)
    load, moment = (part.reshape(faces, -1).sum(axis=0) for part in (load, moment))
    diameter = inner.ball_diameter[0, : len(load)]
    # all contacts of the ball together hold it
    needed = friction_demand(moment, diameter, load, 2.0)
    greatest = float(needed.max())
    held = greatest <= FRICTION_LIMIT
    yield Note(
        "gyroscopic_moment_left_out" if held else "gyroscopic_moment_not_held",
        {
            "moment": float(moment.max()),
            "friction_coefficient": greatest if isfinite(greatest) else None,
            "limit": FRICTION_LIMIT,
        },
    )


def _rolling(solved: Solved) -> Iterator[Note]:
    """What friction does that raceway control would not show."""
    if solved.case.model.raceway_control != "friction" or solved.rollers is not None:
        return
    rolling = solved.rolling
    if rolling is None:
        yield Note("friction_control_at_rest")
        return
    skid = float(rolling.skid[0])
    if abs(skid) > SKID_LIMIT:
        yield Note(
            "cage_skids",
            {
                "skid": skid,
                "cage_speed": float(rolling.cage_speed[0]),
                "control_cage_speed": float(rolling.control_cage_speed[0]),
            },
        )
    inner, outer = (np.abs(contacts.spin_to_roll[0]) for contacts in solved.contacts.values())
    spinning = (np.minimum(inner, outer) > SPIN_LIMIT) & (solved.inner.load[0] > 0.0)
    if spinning.any():
        yield Note(
            "spin_at_both_races",
            {
                "inner": float(inner[spinning].max()),
                "outer": float(outer[spinning].max()),
                **which_elements(solved, spinning),
            },
        )


def _estimated_geometry(solved: Solved) -> Iterator[Note]:
    """An internal geometry that stands in for one that the catalogue does not have."""
    bearing = solved.case.bearing
    name, resolved = bearing.designation, bearing.resolved
    if resolved is None or "inferred" not in bearing.origins.values():
        return
    alike = sum(one.reproduces for one in resolved.candidates)
    if bearing.from_given_ratings:
        yield Note("geometry_estimated_from_given", {"designation": name, "count": alike})
    elif alike > 1:
        yield Note("geometry_estimated", {"designation": name, "count": alike})
    else:
        yield Note("geometry_estimated_uniquely", {"designation": name})


def _other_than_said(solved: Solved) -> Iterator[Note]:
    """What the designation says and the solved bearing is not: they lead."""
    case = solved.case
    bearing = case.bearing
    resolved = bearing.resolved
    if resolved is None:
        return
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


def _letters(solved: Solved) -> Iterator[Note]:
    """What of a designation changes nothing, or is not understood."""
    bearing = solved.case.bearing
    name, resolved = bearing.designation, bearing.resolved
    if resolved is None:
        return
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


def _nearly_lost(solved: Solved) -> Iterator[Note]:
    if solved.preload is None:
        return
    row, factor = solved.preload.lost_row, solved.preload.loss_factor
    if row is None or factor is None or not 1.0 <= factor < PRELOAD_MARGIN:
        return
    if solved.loaded_elements[0, row]:  # else _lost_rows says so
        yield Note("preload_nearly_lost", {"row": row, "factor": float(factor)})


def _radial_load_on_thrust(solved: Solved) -> Iterator[Note]:
    """A radial load on a bearing whose grooves are for an axial one."""
    radial, axial = _given_forces(solved)
    if _is_washers(solved.case) and radial > _RADIAL_SHARE * abs(axial):
        yield Note("thrust_under_radial_load", {"radial": radial, "axial": axial})


def _four_point_load(solved: Solved) -> Iterator[Note]:
    """A load under which balls of a four-point bearing bear on both arcs of a ring and slide."""
    if not solved.case.bearing.bearing_type.has_arches:
        return
    radial = float(np.hypot(solved.load.fy[0], solved.load.fz[0]))
    axial = abs(float(solved.load.fx[0]))
    if axial < FOUR_POINT_LOAD_RATIO * radial:
        both = solved.loaded[0].reshape(2, -1).all(axis=0)
        values = {"ratio": axial / radial, "limit": FOUR_POINT_LOAD_RATIO}
        yield Note("four_point_under_radial_load", {**values, "both_arcs": int(both.sum())})


def nothing_given(solved: Solved) -> bool:
    """Return whether neither load, displacement nor preload loads the first case at all."""
    given = [f"duty.load.{name}" for name in LOADS] + [f"duty.displacement.{name}" for name in AXES]
    known = (solved.field(name)[0] for name in given)
    return not (any(value and isfinite(value) for value in known) or solved.loaded[0].any())


def _axial_load_on_torus(solved: Solved) -> Iterator[Note]:
    """An axial load on a toroidal bearing, which lets the shaft shift until the rollers wedge."""
    axial = float(solved.load.fx[0])
    radial = float(np.hypot(solved.load.fy[0], solved.load.fz[0]))
    if any(one.floats and one.barrels for one in solved.case.bearing.row_types) and (
        abs(axial) > _RADIAL_SHARE * radial
    ):
        values = {"axial": axial, "shift": abs(float(solved.displacement.x[0]))}
        yield Note("toroidal_under_axial_load", values)


def _given_forces(solved: Solved) -> tuple[float, float]:
    """Radial and axial load of the first case as given, 0 where a displacement is (N)."""
    fx, fy, fz = (float(np.nan_to_num(solved.field(f"duty.load.{n}")[0])) for n in LOADS[:3])
    return float(np.hypot(fy, fz)), fx


def _is_washers(case: Case) -> bool:
    """Whether it is a thrust bearing of 90°, which is for axial load alone."""
    bearing = case.bearing
    return bearing.bearing_type.washers and (bearing.contact_angle or 0.0) > 0.5 * pi * (1.0 - 1e-9)


def _turns(solved: Solved) -> bool:
    return bool(solved.field("duty.inner_speed")[0] != solved.field("duty.outer_speed")[0])


# --- advice ---------------------------------------------------------------------------------------


def advice_on(solved: Solved, case: int = 0) -> Note | None:
    """What a person can do about a case without a result; None where there is one."""
    code = int(solved.status.number[case])
    if code == CONVERGED:
        return None
    given, residual = solved.case, float(solved.status.residual[case])
    if code == NO_EQUILIBRIUM:
        return _no_equilibrium(solved[case], int(solved.status.unsupported[case]))
    if code == INVALID_INPUT:
        return Note("invalid_input") if solved.refusals is None else solved.refusals.note(case)
    factor = _speed_factor(solved[case])
    if factor > _FASTEST:
        return Note("overspeed", {"speed_factor": factor, "limit": _FASTEST})
    rolls = any(place.bearing.element != "ball" for place in given.bearing.places)
    if code == OVERLOADED:
        key = "overloaded_rollers" if rolls else "overloaded"
        return Note(key, {"limit": GREATEST_APPROACH})
    if code == OVER_SHOULDER and given.bearing.bearing_type.washers:
        return _out_of_the_washers(solved[case])
    if code == OVER_SHOULDER:
        return Note(
            "over_shoulder",
            {"inner_edge": _edge(given, "inner"), "outer_edge": _edge(given, "outer")},
        )
    if rolls:
        return Note("not_converged", {**_residual(residual), "tolerance": TOLERANCE})
    alone = given.model.raceway_control == "inner" and given.model.cage == "none"
    if code == UNCONSTRAINED_BALL or alone:
        return Note("unconstrained_ball")
    if given.model.raceway_control == "friction":
        return _friction_alone(residual)
    inner, outer = (float(solved.field(f"duty.{race}_speed")[case]) for race in ("inner", "outer"))
    if inner * outer < 0.0:
        return Note("counter_rotation")
    if given.model.raceway_control == "inner":
        return Note("inner_control", _residual(residual))
    return Note("not_converged", {**_residual(residual), "tolerance": TOLERANCE})


def _residual(residual: float) -> dict[str, float | None]:
    return {"residual": residual if isfinite(residual) else None}


def _edge(case: Case, race: Race) -> float:
    """The contact angle (rad) at which the shallowest groove of a race ends."""
    return min(acos(float(edge_cosine(place.bearing, race))) for place in case.bearing.places)


def _out_of_the_washers(solved: Solved) -> Note:
    """Advice where balls climb out of a thrust bearing's grooves, and the load that keeps them.

    Where there is a radial load, that it is the wrong bearing for it.

    With α_i = π - α_o, F_c = 2 Q cos α_o and F_a = Z Q sin α_o: at the edge of the outer groove
    F_a = ½ Z F_c tan α_o.
    """
    radial, axial = _given_forces(solved)
    if _is_washers(solved.case) and radial > _RADIAL_SHARE * abs(axial):
        return Note("thrust_carries_no_radial_load", {"radial": radial, "axial": axial})
    rows = solved.rows
    bearing = ball_bearing(solved.case)
    deepest = bearing.groove_bottom
    lowest = max(deepest - _edge(solved.case, "outer"), radians(0.1))
    orbit = nominal_orbit(
        float(rows.ball_diameter[0, 0] / rows.pitch_diameter[0, 0]) * np.cos(deepest),
        *(float(solved.field(f"duty.{race}_speed")[0]) for race in ("inner", "outer")),
    )
    mass = ball_mass(rows.ball_diameter[0, 0], bearing.ball_material.density)
    force = float(centrifugal_force(mass, rows.pitch_diameter[0, 0], orbit))
    if not solved.case.model.centrifugal_force:
        force = 0.0
    least = 0.5 * bearing.ball_count * force * float(np.tan(lowest))
    return Note(
        "thrust_over_shoulder",
        {
            "inner_edge": _edge(solved.case, "inner"),
            "outer_edge": _edge(solved.case, "outer"),
            "centrifugal_force": force,
            "minimum_load": least if force > 0.0 else None,
        },
    )


def _no_equilibrium(solved: Solved, axis: int) -> Note:
    """Name the direction that nothing supports, and what would."""
    case, bearing = solved.case, solved.case.bearing
    radial, axial_load = _given_forces(solved)
    if bearing.bearing_type.washers:
        note = Note("thrust_pushed_aside" if axial_load > 0.0 else "thrust_unsupported")
        if _is_washers(case) and axial_load > 0.0 and radial > _RADIAL_SHARE * axial_load:
            values = {"radial": radial, "axial": axial_load}
            note = Note("thrust_carries_no_radial_load", values)
        return of_element(note, bearing.bearing_type.rolls)
    if bearing.bearing_type.aligns and axis > 2:
        return Note("sphere_holds_no_moment", {"axis": AXES[axis]})
    if any(place.bearing.element != "ball" for place in bearing.places):
        tilts = bool(_free(solved)[3:].any())
        return rollers_without_equilibrium(case, axis, (axial_load, radial), tilts=tilts)
    if bearing.kind is not None:
        return Note("unsupported", {"axis": AXES[axis]})
    one_sided = [place.bearing.carries_one_way for place in bearing.places]
    if bearing.is_set and all(one_sided) and axis == 0:
        return _set_without_equilibrium(case, axial_load)
    if len(set(one_sided)) > 1:
        return Note("shoulder_lost")
    if not all(one_sided):
        return Note("unsupported", {"axis": AXES[axis]})
    if axis == 0:
        return Note("unsupported_axially")
    return Note("unsupported_one_sided", {"axis": AXES[axis]})


def _set_without_equilibrium(case: Case, axial: float) -> Note:
    """Why rows that carry axial load one way only have no equilibrium."""
    signs = {place.sign for place in case.bearing.places}
    if len(signs) == 1:
        toward, away = ("+x", "-x") if signs == {1.0} else ("-x", "+x")
        return Note("unsupported_tandem", {"toward": toward, "away": away})
    spring = None if case.bearing.preload is None else case.bearing.preload.spring
    if spring is None:
        return Note("shoulder_lost")
    if axial <= -spring:
        return Note("springs_overcome", {"load": -axial, "spring": spring})
    return Note("springs_weak", {"spring": spring})


def _friction_alone(residual: float) -> Note:
    """Advice where balls that friction controls found no balance, or one that cannot be shown."""
    if residual <= TOLERANCE:
        return Note("friction_without_balance")
    return Note("friction_not_converged", _residual(residual))
