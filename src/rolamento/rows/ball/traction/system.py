"""Ring, cage and balls in balance with friction: from nearly viscous friction to Coulomb's.

At a high smoothing speed v0 the friction is nearly viscous and the equations nearly linear; it is
lowered step by step, each solution the start of the next.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Final

from rolamento.numerics.compiled import kernel, shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.settle import in_place
from rolamento.rows.ball.single import direction, groove
from rolamento.rows.ball.traction.balance import (
    FORCES,
    Place,
    add_reaction,
    sheet_for,
    start_amid_gaps,
    start_rolling,
)
from rolamento.rows.ball.traction.ball import Mesh, Rig, least_speed
from rolamento.rows.ball.traction.newton import copy_place, relax, ring_stiffness, step_for
from rolamento.rows.ball.types import Array

TOLERANCE: Final = 1e-10
ACCEPTED: Final = 5e-9
ENOUGH: Final = 1e-2  # before the smoothing is lowered
STAGES: Final = 60
BOLDEST: Final = 0.1  # of the smoothing before
TIMIDEST: Final = 0.95
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

    The smoothing, v0 over |ω_i - ω_o| D, falls from the first to the last of the two given, by a
    tenth at a time, or by less where that fails; the last is solved on the fine nodes as well.
    place holds the start, all but the motions, and takes the result; the nodes' least is filled
    in here. Fills reaction (5,), what the balls ask of the ring, forces (balls, FORCES) as of
    `Sheet`, and tangent (5, 5), the derivative of the ring's load by its displacement with balls
    and cage following.
    """
    balls = rig.cosines.size
    sheet, step = sheet_for(balls), step_for(balls)
    start_amid_gaps(rig, place)
    start_rolling(rig, place)
    good = Place(place.u.copy(), place.x.copy(), place.omega.copy())
    origin = Place(place.u.copy(), place.x.copy(), place.omega.copy())
    speed = least_speed(rig)[0]
    done, ratio, total, worst = inf, BOLDEST, 0, inf
    wanted, last, finished = smoothest, False, False
    for _ in range(STAGES):
        mesh = fine if last else coarse
        for node in range(mesh.least.size):
            mesh.least[node] = (wanted * speed) ** 2
        enough = TOLERANCE if last else ENOUGH
        worst, evaluations = relax(rig, place, origin, mesh, enough, sheet, step)
        total += evaluations
        if last:
            finished = worst <= ACCEPTED
            break
        if worst <= ENOUGH:
            done, last = wanted, wanted == smoothing
            copy_place(place, good)
            ratio = max(BOLDEST, ratio * ratio)
            wanted = max(done * ratio, smoothing)
            continue
        copy_place(good, place)
        if done == inf:
            wanted *= 10.0
            if wanted > MOST_VISCOUS:
                break
        else:
            ratio = sqrt(ratio)
            if ratio > TIMIDEST:
                break
            wanted = max(done * ratio, smoothing)
    if not finished:
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


@shared
def _all_in_place(rig: Rig, place: Place, forces: Array) -> bool:
    """Whether every ball that the inner ring touches stands where it can."""
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        a1, _ = groove(rig.p, rig.case, place.u, c, s)
        if forces[j, 0] > 0.0 and not in_place(rig.p, rig.case, a1, place.x[j, 0], place.x[j, 1]):
            return False
    return True
