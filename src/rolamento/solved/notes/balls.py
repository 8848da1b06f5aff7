"""Notes on balls: grooves, shoulders, spin, gyroscopic moments, the races that control them."""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, isfinite, radians
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.bearing import ball_bearing
from rolamento.geometry import edge_cosine
from rolamento.kinematics import RacewayControl, friction_demand, jones_control
from rolamento.solved.notes.bearing import turns, which_elements
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

_PRESSURE_LIMIT: Final = 4.2e9
_PRESSURE_LIMIT_SELF_ALIGNING: Final = 4.6e9
"""Pa; permanent set of 1e-4 ball diameters at the contact of ball and race (ISO 76:2006)."""
FRICTION_LIMIT: Final = 0.1
"""Coefficient of friction above which a lubricated contact will hardly hold the ball."""
SPINNING_ANGLE: Final = radians(0.1)
"""rad: a ball at a smaller contact angle hardly spins, whichever race controls it."""
PAST_EDGE: Final = 1e-9
"""Fraction of the groove's offset: what is less is rounding."""
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


def pressures(solved: Solved) -> Iterator[Note]:
    """Pressures on balls that indent the races."""
    limit = pressure_limit(solved.case)
    for race, contacts in solved.contacts.items():
        over = (contacts.max_pressure[0] > limit) & ~solved.are_rollers
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


def past_edge(solved: Solved) -> Iterator[Note]:
    """Balls that the inner groove has left, so that nothing presses on them."""
    inner, rows = solved.inner, solved.rows
    length = rows.per_element((rows.inner_conformity - 0.5) * rows.ball_diameter)
    past = ((inner.approach > PAST_EDGE * length) & (inner.load == 0.0))[0]
    if past.any():
        yield Note("ball_past_groove_edge", which_elements(solved, past))


def shoulders(solved: Solved) -> Iterator[Note]:
    """Contact ellipses that run over the edge of their groove."""
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


def arches(solved: Solved) -> Iterator[Note]:
    """Contact ellipses of a four-point bearing that run over the middle of their arch."""
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


def control(solved: Solved) -> Iterator[Note]:
    """Where Jones's criterion does not confirm the assumed raceway control."""
    assumed = solved.case.model.raceway_control
    if not turns(solved):
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


def orbits(solved: Solved) -> Iterator[Note]:
    """Balls that inner control drives faster or slower than either ring turns."""
    slow, fast = np.sort([solved.field(f"duty.{race}_speed")[0] for race in ("inner", "outer")])
    orbit = solved.elements.orbital_speed[0]
    outside = np.maximum(slow - orbit, orbit - fast) > ORBIT_SLACK * max(abs(slow), abs(fast))
    if outside.any():
        yield Note("orbit_outside", which_elements(solved, outside))


def gyroscopic_slip(solved: Solved) -> Iterator[Note]:
    """Balls whose gyroscopic moment needs more friction than a lubricated contact gives."""
    inner, outer, moment = solved.inner, solved.outer, solved.elements.gyroscopic_moment
    if solved.case.model.raceway_control == "none":  # both races share it
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


def gyroscopic_left_out(solved: Solved) -> Iterator[Note]:
    """The size of the moment that no balance of these balls holds, and the friction it takes."""
    if not turns(solved):
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


def rolling(solved: Solved) -> Iterator[Note]:
    """What friction does that raceway control would not show."""
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


def four_point_load(solved: Solved) -> Iterator[Note]:
    """A load under which balls of a four-point bearing bear on both arcs of a ring and slide."""
    radial = float(np.hypot(solved.load.fy[0], solved.load.fz[0]))
    axial = abs(float(solved.load.fx[0]))
    if axial < FOUR_POINT_LOAD_RATIO * radial:
        both = solved.loaded[0].reshape(2, -1).all(axis=0)
        values = {"ratio": axial / radial, "limit": FOUR_POINT_LOAD_RATIO}
        yield Note("four_point_under_radial_load", {**values, "both_arcs": int(both.sum())})
