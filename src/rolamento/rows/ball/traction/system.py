"""Ring, cage and balls in balance with friction: from nearly viscous friction to Coulomb's.

At a high smoothing speed v0 the friction is nearly viscous and the equations nearly linear; it is
lowered step by step, each solution the start of the next.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Final

from rolamento.numerics.compiled import filling, kernel
from rolamento.rows.ball import layout
from rolamento.rows.ball.settle import in_place
from rolamento.rows.ball.single import direction, groove
from rolamento.rows.ball.traction.balance import (
    FORCES,
    Place,
    Sheet,
    add_reaction,
    sheet_for,
    start_amid_gaps,
    start_rolling,
)
from rolamento.rows.ball.traction.ball import Mesh, Rig, least_speed
from rolamento.rows.ball.traction.newton import Step, copy_place, relax, ring_stiffness, step_for
from rolamento.rows.ball.types import Array

TOLERANCE: Final = 1e-10
ACCEPTED: Final = 5e-9
ATTEMPTS: Final = ((1.0, 3e-2), (0.1, 1e-2))
"""Boldly at first: of the smoothest, where the friction begins; enough to lower the smoothing."""
STAGES: Final = 60
BOLDEST: Final = 0.1  # of the smoothing before
TIMIDEST: Final = 0.95
NEARLY: Final = 1.01  # of the last smoothing: rounding makes no stage of its own
MOST_VISCOUS: Final = 1e3  # where nothing less viscous is a start

CONVERGED: Final = 0
NOT_CONVERGED: Final = 1
STRAYED: Final = 2


@kernel
def solve_with_friction(
    rig: Rig,
    place: Place,
    coarse: Mesh,
    fine: Mesh,
    smoothest: float,
    smoothing: float,
    reaction: Array,
    forces: Array,
    tangent: Array,
) -> tuple[int, float, int]:
    """Find the equilibrium with friction from that of raceway control: (code, residual, steps).

    The smoothing, v0 over |ω_i - ω_o| D, falls from the first to the last of the two given; what
    does not settle so is tried once more, with more care. place holds the start, all but the
    motions, and takes the result; the nodes' least is filled in here. Fills reaction (5,), what the
    balls ask of the ring, forces (balls, FORCES) as of `Sheet`, and tangent (5, 5), the derivative
    of the ring's load by its displacement with balls and cage following.
    """
    balls = rig.cosines.size
    sheet, step = sheet_for(balls), step_for(balls)
    start_amid_gaps(rig, place)
    start_rolling(rig, place)
    start = Place(place.u.copy(), place.x.copy(), place.omega.copy())
    good = Place(place.u.copy(), place.x.copy(), place.omega.copy())
    origin = Place(place.u.copy(), place.x.copy(), place.omega.copy())
    worst, total = inf, 0
    for share, enough in ATTEMPTS:
        copy_place(start, place)
        worst, evaluations = _sharpen(
            rig, place, coarse, fine, share * smoothest, smoothing, enough, good, origin, sheet,
            step,
        )  # fmt: skip
        total += evaluations
        if worst <= ACCEPTED:
            break
    if not worst <= ACCEPTED:
        return NOT_CONVERGED, worst, total
    ring_stiffness(rig, sheet, step, tangent)
    for i in range(layout.DEGREES_OF_FREEDOM):
        reaction[i] = 0.0
    for j in range(balls):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        add_reaction(c, s, sheet.sight[j], reaction)
        for i in range(FORCES):
            forces[j, i] = sheet.forces[j, i]
    return CONVERGED if _all_in_place(rig, place, forces) else STRAYED, worst, total


@filling
def _sharpen(
    rig: Rig,
    place: Place,
    coarse: Mesh,
    fine: Mesh,
    smoothest: float,
    smoothing: float,
    enough: float,
    good: Place,
    origin: Place,
    sheet: Sheet,
    step: Step,
) -> tuple[float, int]:
    """Lower the smoothing to its last value, in place: (greatest residual, evaluations).

    By a tenth at a time, or by less where that fails; the last is solved on the fine nodes as well.
    Infinite where the last is not reached. good, origin: room for places on the way.
    """
    copy_place(place, good)
    speed = least_speed(rig)[0]
    done, ratio, wanted, total = inf, BOLDEST, smoothest, 0
    for _ in range(STAGES):
        _smooth(coarse.least, wanted * speed)
        worst, evaluations = relax(rig, place, origin, coarse, enough, sheet, step)
        total += evaluations
        if worst <= enough:
            if wanted == smoothing:
                _smooth(fine.least, wanted * speed)
                worst, evaluations = relax(rig, place, origin, fine, TOLERANCE, sheet, step)
                return worst, total + evaluations
            done = wanted
            copy_place(place, good)
            ratio = max(BOLDEST, ratio * ratio)
        else:
            copy_place(good, place)
            if done == inf:
                wanted *= 10.0
                if wanted > MOST_VISCOUS:
                    break
                continue
            ratio = sqrt(ratio)
            if ratio > TIMIDEST:
                break
        wanted = done * ratio
        if wanted < NEARLY * smoothing:
            wanted = smoothing
    return inf, total


@filling
def _smooth(least: Array, speed: float) -> None:
    """Set v0² of all nodes."""
    for node in range(least.size):
        least[node] = speed * speed


@filling
def _all_in_place(rig: Rig, place: Place, forces: Array) -> bool:
    """Whether every ball that the inner ring touches stands where it can."""
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        a1, _ = groove(rig.p, rig.case, place.u, c, s)
        if forces[j, 0] > 0.0 and not in_place(rig.p, rig.case, a1, place.x[j, 0], place.x[j, 1]):
            return False
    return True
