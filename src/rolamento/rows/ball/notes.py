"""What the user should know about a result: limits passed, contacts lost, assumptions strained.

A note never changes a number. Each check returns sentences; `notes_on` collects them.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from math import acos, degrees, pi, radians
from typing import Final

import numpy as np

from rolamento.case.duty import AXES
from rolamento.catalogue import built_in_geometry
from rolamento.geometry import Race, edge_cosine
from rolamento.kinematics import RacewayControl, friction_demand
from rolamento.rows.ball import layout
from rolamento.rows.ball.batch_state import BatchState
from rolamento.rows.ball.detail import criterion
from rolamento.rows.ball.problem import ring_arms
from rolamento.rows.ball.rolling_notes import notes_on_rolling
from rolamento.rows.ball.wording import azimuths as _azimuths
from rolamento.rows.ball.wording import count as _count
from rolamento.state import BallState, ContactState, PreloadState, State

STATIC_PRESSURE_LIMIT: Final = 4.2e9
"""Pa; permanent set of 1e-4 ball diameters at the ball-groove contact (ISO 76)."""
SPEED_LIMIT: Final = 3.0e6
"""mm/min: n d_m of the fastest hybrid spindle bearings; 1 mm/min is 1 rpm times 1 mm."""
TILT_LIMIT: Final = radians(1.0)
"""rad: the equations take tilts as small; at 1 degree that costs up to 2 % of BD."""
FRICTION_LIMIT: Final = 0.1
"""Coefficient of friction above which a lubricated contact will hardly hold the ball."""
SPINNING_ANGLE: Final = radians(0.1)
"""rad: a ball at a smaller contact angle hardly spins, whichever race controls it."""
FREE_STIFFNESS: Final = 1e-9
"""Of the greatest stiffness: a direction with less is free."""
PAST_EDGE: Final = 1e-9
"""Of the groove's offset: what is less is rounding."""
PRELOAD_MARGIN: Final = 1.1
"""Times the load at which a row lifts off: what is nearer deserves a word."""


def notes_on(state: State, batch: BatchState) -> State:
    """Add the notes to a converged state."""
    notes = [
        *_lost_rows(state),
        *_lost_contacts(state),
        *_pressures(state),
        *_past_edge(state, batch),
        *_shoulders(state),
        *_speeds(state),
        *_tilts(state),
        *_free_directions(state, batch),
        *_control(state, batch),
        *_gyroscopic_slip(state),
        *notes_on_rolling(state),
        *_inferred_balls(state),
    ]
    return dataclasses.replace(state, notes=tuple(notes))


def _inferred_balls(state: State) -> Iterator[str]:
    """Balls that stand in for those that the catalogue does not tell."""
    bearing = state.case.bearing
    if bearing.designation is None or "inferred" not in bearing.origins.values():
        return
    name = bearing.designation
    alike = sum(one.reproduces for one in built_in_geometry(name).candidates)
    if alike > 1:
        yield (
            f"The balls of {name} are not published, but inferred from its ratings, which {alike}"
            " insides reproduce (rolamento catalogue show): the best one is taken."
        )
    else:
        yield (
            f"The balls of {name} are not published, but inferred from its ratings; no other"
            " standard balls reproduce them."
        )


def with_preload(state: State, preload: PreloadState | None) -> State:
    """Put the preload of a set into its state, and say so if a row is about to lose it."""
    notes = () if preload is None else tuple(_nearly_lost(state, preload))
    return dataclasses.replace(state, preload=preload, notes=state.notes + notes)


def _nearly_lost(state: State, preload: PreloadState) -> Iterator[str]:
    row = preload.lost_row
    if row is None or not 1.0 <= preload.loss_factor < PRELOAD_MARGIN:
        return
    if state.rows[row].loaded_balls:  # else _lost_rows says so
        yield (
            f"Row {row} is about to lose its preload: it lifts off the inner ring at "
            f"{preload.loss_factor:.3g} times this load. More preload keeps it in contact."
        )


def _lost_rows(state: State) -> Iterator[str]:
    """Rows of a set that the inner ring does not touch at all."""
    lost = [row.row for row in state.rows if row.loaded_balls == 0]
    if lost and len(lost) < len(state.rows):
        cause = "its preload is gone" if state.case.bearing.preload else "no preload holds it there"
        yield (
            f"No ball of row {', '.join(map(str, lost))} presses on the inner ring: {cause}, and "
            "the rest of the set carries the whole load. Where the bearing turns, such balls skid."
        )


def _lost_contacts(state: State) -> Iterator[str]:
    """Balls that the inner ring does not touch."""
    free = [ball for ball in state.balls if ball.inner.load <= 1e-9 * ball.outer.load]
    if len(free) == len(state.balls):
        yield "No ball presses on the inner ring: without a load, its place is one of many."
        return
    touched = {row.row for row in state.rows if row.loaded_balls}
    free = [ball for ball in free if ball.row in touched]  # of the others _lost_rows has told
    if free:
        pressed = any(ball.outer.load > 0.0 for ball in free)
        model = state.case.model
        alone = model.cage == "none" and model.raceway_control != "friction"
        holder = "only centrifugal force presses on them" if pressed else "nothing presses on them"
        if pressed and not alone:
            holder += ", and they orbit with the cage"
        yield f"{_count(free)} without inner contact (azimuth {_azimuths(state, free)}): {holder}."
        if pressed and alone:
            yield (
                "The orbit of a ball without inner contact, and with it its centrifugal force, is "
                'a guess under model.cage = "none": raceway control says nothing about it. Under '
                '"loose" the cage drives it.'
            )


def _pressures(state: State) -> Iterator[str]:
    for race in ("inner", "outer"):
        over = [b for b in state.balls if getattr(b, race).max_pressure > STATIC_PRESSURE_LIMIT]
        if over:
            worst = max(getattr(ball, race).max_pressure for ball in over)
            yield (
                f"Contact pressure at the {race} race is up to {worst / 1e6:.0f} MPa, above "
                f"4200 MPa (ISO 76), where balls begin to dent the groove: {_count(over)} "
                f"(azimuth {_azimuths(state, over)})."
            )


def _past_edge(state: State, batch: BatchState) -> Iterator[str]:
    """Balls that the inner groove has left, so that nothing presses on them."""
    approach = np.concatenate([row.inner_approach()[0] for row in batch.rows])
    lengths = np.concatenate(
        [
            np.full(row.azimuth.shape[1], row.parameters[layout.INNER_LENGTH, 0])
            for row in batch.rows
        ]
    )
    parts = zip(state.balls, approach > PAST_EDGE * lengths, strict=True)
    past = [ball for ball, pressed in parts if pressed and ball.inner.load == 0.0]
    if past:
        yield (
            f"{_count(past)} past the edge of the inner groove (azimuth {_azimuths(state, past)}):"
            " no force is computed there. In the real bearing such a ball may bear on the edge of "
            "the shoulder, and the loads of all balls differ from those shown."
        )


def _shoulders(state: State) -> Iterator[str]:
    """Contact ellipses that run over the edge of their groove."""
    rows = [place.bearing for place in state.case.bearing.places]
    races: tuple[Race, Race] = ("inner", "outer")
    for race in races:
        radii = [getattr(row, f"{race}_conformity") * row.ball_diameter for row in rows]
        ends = [acos(float(edge_cosine(row, race))) for row in rows]
        parts = [
            (ball, _reach(getattr(ball, race), radii[ball.row]), ends[ball.row])
            for ball in state.balls
        ]
        over = [ball for ball, reach, edge in parts if reach > edge]
        if over:
            worst, reach, edge = max(parts, key=lambda part: part[1] - part[2])
            given = getattr(rows[worst.row], f"{race}_shoulder_height") is not None
            groove = "the groove" if given else "the groove, taken as a half circle,"
            yield (
                f"The contact ellipse runs over the {race} shoulder: it reaches "
                f"{degrees(reach):.1f}°, {groove} ends at {degrees(edge):.1f}° "
                f"({_count(over)}, azimuth {_azimuths(state, over)}). Pressure at the edge is "
                "higher than shown."
            )


def _reach(contact: ContactState, groove_radius: float) -> float:
    """Angle of the ellipse's far end from the bottom of the groove; of no contact, none."""
    if contact.load == 0.0:
        return 0.0
    return abs(contact.contact_angle) + contact.semi_major / groove_radius


def _speeds(state: State) -> Iterator[str]:
    duty = state.case.duty
    fastest = max(abs(duty.inner_speed), abs(duty.outer_speed)) * 30.0 / pi
    widest = max(place.bearing.pitch_diameter for place in state.case.bearing.places)
    product = fastest * widest * 1e3
    if product > SPEED_LIMIT:
        yield (
            f"The speed factor n·d_m = {product:.2g} mm/min is beyond what rolling bearings reach "
            f"({SPEED_LIMIT:.0e} mm/min): the rings' own growth and the heat are not in these "
            "numbers."
        )


def _tilts(state: State) -> Iterator[str]:
    worst = max(abs(state.displacement.ry), abs(state.displacement.rz))
    if worst > TILT_LIMIT:
        yield (
            f"The ring tilts by {degrees(worst):.2f}°: the equations take tilts as small, good "
            "to about 1°."
        )


def _free_directions(state: State, batch: BatchState) -> Iterator[str]:
    """Directions that are under no load and have no stiffness: their displacement is any."""
    free = np.array(state.case.duty.free)
    arms = ring_arms(batch.rows[0].parameters)[:, 0]
    scaled = state.stiffness / np.outer(arms, arms)
    greatest = np.abs(scaled).max()
    if all(load == 0.0 for load in state.load):
        return  # nothing is held, and _lost_contacts says so
    vectors, values, _ = np.linalg.svd(scaled[np.ix_(free, free)])
    names = [axis for axis, is_free in zip(AXES, free, strict=True) if is_free]
    for value, vector in zip(values, vectors.T, strict=True):
        if value <= FREE_STIFFNESS * greatest:
            name = names[int(np.abs(vector).argmax())]
            yield (
                f"No ball holds the ring along {name}: it carries no load there, and the "
                "displacement shown is one of many."
            )


def _control(state: State, batch: BatchState) -> Iterator[str]:
    """Where Jones's criterion does not bear out the raceway control that was assumed."""
    assumed = state.case.model.raceway_control
    if assumed in ("none", "friction") or not _turns(state):
        return
    if assumed == "jones":
        open_balls = [b for b in state.balls if b.raceway_control == "indeterminate"]
        if open_balls:
            yield (
                f"Jones's criterion favours neither race at {_count(open_balls)} (azimuth "
                f"{_azimuths(state, open_balls)}): they are taken as before, as controlled by the "
                "race that they last rolled on, first the outer."
            )
        return
    against = RacewayControl.INNER if assumed == "outer" else RacewayControl.OUTER
    verdict = [
        int(code) for row in batch.rows for code in criterion(row.parameters, row.balls())[0]
    ]
    contradicted = [
        ball
        for ball, code in zip(state.balls, verdict, strict=True)
        if code == against and abs(ball.inner.contact_angle) > SPINNING_ANGLE
    ]
    if contradicted:
        yield (
            f"Jones's criterion contradicts {assumed} raceway control at {_count(contradicted)} "
            f'(azimuth {_azimuths(state, contradicted)}); model.raceway_control = "jones" decides '
            "ball by ball."
        )


def _gyroscopic_slip(state: State) -> Iterator[str]:
    """Balls whose gyroscopic moment needs more friction than a lubricated contact gives."""
    if state.case.model.raceway_control == "friction":
        return
    diameters = [place.bearing.ball_diameter for place in state.case.bearing.places]
    demand = [_friction(ball, diameters[ball.row]) for ball in state.balls]
    parts = zip(state.balls, demand, strict=True)
    slipping = [ball for ball, friction in parts if friction > FRICTION_LIMIT]
    if slipping:
        yield (
            "To hold the gyroscopic moment as assumed, a coefficient of friction of "
            f"{max(demand):.2f} is needed, more than about {FRICTION_LIMIT}: "
            f"{_count(slipping)} will slip (azimuth {_azimuths(state, slipping)})."
        )


def _friction(ball: BallState, diameter: float) -> float:
    """The least friction with which the assumed race, or both, hold the ball."""
    if ball.gyroscopic_moment == 0.0:
        return 0.0
    if ball.raceway_control == "none":
        load, share = min(ball.inner.load, ball.outer.load), 1.0
    else:
        load, share = getattr(ball, _controlling(ball)).load, 2.0
    return float(friction_demand(ball.gyroscopic_moment, diameter, load, share))


def _controlling(ball: BallState) -> str:
    """Name the race that the ball was taken to roll on."""
    return "inner" if ball.raceway_control == "inner" else "outer"


def _turns(state: State) -> bool:
    return state.case.duty.inner_speed != state.case.duty.outer_speed
