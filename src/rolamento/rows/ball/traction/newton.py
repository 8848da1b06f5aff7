"""Newton's method on ring, cage and balls, every ball eliminated by itself."""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from rolamento.numerics.compiled import filling, shared
from rolamento.numerics.dense import solve_dense
from rolamento.rows.ball import layout
from rolamento.rows.ball.single import direction
from rolamento.rows.ball.traction.balance import (
    BALL,
    BOTH,
    CAGE,
    RING,
    SEEN,
    Place,
    Sheet,
    cage_residual,
    evaluate,
)
from rolamento.rows.ball.traction.ball import HALF, Mesh, Rig, least_speed
from rolamento.rows.ball.types import Array

STEPS: Final = 40
SHORTENINGS: Final = 12
SHORTER: Final = 0.4
LONGEST: Final = 0.2  # step of a ball, of the groove's offset
INWARD: Final = 1e-6  # of the ball's radius: the size of a shift beside that of a speed
ASKED: Final = 4  # a ball's own step, and its derivatives by A1, A2, ω_m


class Step(NamedTuple):
    """Room for a step.

    follow (balls, BALL, ASKED): how balls follow ring and cage; matrix (RING, RING) and right
    (RING,): the equations of ring and cage; balls (balls, BALL): the balls' steps; system (BALL,
    BALL + ASKED) and seen (SEEN + 1, ASKED): of one ball.
    """

    follow: Array
    matrix: Array
    right: Array
    balls: Array
    system: Array
    seen: Array


@shared
def step_for(balls: int) -> Step:
    """Make room for so many balls."""
    return Step(
        np.empty((balls, BALL, ASKED)),
        np.empty((RING, RING)),
        np.empty(RING),
        np.empty((balls, BALL)),
        np.empty((BALL, BALL + ASKED)),
        np.empty((SEEN + 1, ASKED)),
    )


@filling
def eliminate_balls(rig: Rig, sheet: Sheet, step: Step) -> bool:
    """Let every ball follow ring and cage; False where a ball's matrix is singular.

    Fills step.follow; step.right, what the balls ask of ring and cage after their own steps, and
    step.matrix, its derivative. A ball that nothing touches stays where it is.
    """
    for i in range(RING):
        step.right[i] = 0.0
        for unknown in range(RING):
            step.matrix[i, unknown] = 0.0
    for j in range(rig.cosines.size):
        if sheet.forces[j, 0] == 0.0 and sheet.forces[j, 1] == 0.0:
            for row in range(BALL):
                for asked in range(ASKED):
                    step.follow[j, row, asked] = 0.0
            continue
        if not _follow(rig, sheet, step, j):
            return False
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        _add_to_ring(sheet.sight[j], step, c, s)
    return True


@filling
def _follow(rig: Rig, sheet: Sheet, step: Step, j: int) -> bool:
    """How a ball follows A1, A2 and ω_m, and what ring and cage then see of it."""
    half = rig.k[HALF]
    speed, inward = max(least_speed(rig)[1], 1e-300), INWARD * half
    system, follow, seen = step.system, step.follow[j], step.seen
    for row in range(BALL):
        weight = 1.0 if row < 2 else 1.0 / half
        for other in range(BALL):
            scale = inward if other < 2 else speed
            system[row, other] = sheet.matrix[j, row, other] * weight * scale
        system[row, BALL] = -sheet.residual[j, row] * weight
        for asked in range(1, ASKED):
            system[row, BALL + asked] = -sheet.inputs[j, row, asked - 1] * weight
    if not _solve_ball(system):
        return False
    for row in range(BALL):
        for asked in range(ASKED):
            follow[row, asked] = system[row, BALL + asked] * (inward if row < 2 else speed)
    for row in range(SEEN + 1):
        for asked in range(ASKED):
            value = 0.0 if asked == 0 else sheet.slope[j, row, BALL + asked - 1]
            for own in range(BALL):
                value += sheet.slope[j, row, own] * follow[own, asked]
            seen[row, asked] = value
    return True


@filling
def _solve_ball(system: Array) -> bool:
    """Solve for all right sides at once, in place; False where the matrix is singular."""
    greatest = 0.0
    for i in range(BALL):
        for j in range(BALL):
            greatest = max(greatest, abs(system[i, j]))
    for k in range(BALL):
        pivot = k
        for i in range(k + 1, BALL):
            if abs(system[i, k]) > abs(system[pivot, k]):
                pivot = i
        if not abs(system[pivot, k]) > 1e-15 * greatest:
            return False
        for j in range(k, BALL + ASKED):
            system[k, j], system[pivot, j] = system[pivot, j], system[k, j]
        for i in range(BALL):
            factor = system[i, k] / system[k, k]
            if i != k:
                for j in range(k, BALL + ASKED):
                    system[i, j] -= factor * system[k, j]
    for i in range(BALL):
        for j in range(BALL, BALL + ASKED):
            system[i, j] /= system[i, i]
    return True


@filling
def _add_to_ring(sight: Array, step: Step, c: float, s: float) -> None:
    """Add to the equations of ring and cage what they see of one ball, at azimuth (c, s)."""
    seen, matrix, right = step.seen, step.matrix, step.right
    for row in range(SEEN):
        seen[row, 0] += sight[row]
    for unknown in range(-1, RING):  # -1: the ball's own step
        f1, f2, h, along, h_r = 0.0, 0.0, 0.0, 0.0, 0.0
        both = 0.0
        for asked in range(ASKED):
            part = _share(unknown, asked, c, s)
            f1 += seen[0, asked] * part
            f2 += seen[1, asked] * part
            h += seen[2, asked] * part
            along += seen[3, asked] * part
            h_r += seen[4, asked] * part
            both += seen[BOTH, asked] * part
        told = (f1, s * f2 + c * along, c * f2 - s * along, c * h + s * h_r, c * h_r - s * h, both)
        for row in range(RING):
            if unknown < 0:
                right[row] += told[row]
            else:
                matrix[row, unknown] += told[row]


@filling
def _share(unknown: int, asked: int, c: float, s: float) -> float:
    """The derivative of A1, A2 or ω_m by an unknown of ring and cage."""
    if unknown < 0 or asked == 0:
        return 1.0 if unknown < 0 and asked == 0 else 0.0
    if asked == 1:
        return 1.0 if unknown == 0 else c if unknown == 3 else -s if unknown == 4 else 0.0
    if asked == 2:
        return s if unknown == 1 else c if unknown == 2 else 0.0
    return 1.0 if unknown == CAGE else 0.0


@filling
def find_step(rig: Rig, orbit: float, sheet: Sheet, step: Step) -> bool:
    """Solve for the steps of ring, cage (into step.right) and balls; False where it cannot be."""
    if not eliminate_balls(rig, sheet, step):
        return False
    p, case, matrix, right = rig.p, rig.case, step.matrix, step.right
    speed, inward = max(least_speed(rig)[1], 1e-300), INWARD * rig.k[HALF]
    for i in range(layout.DEGREES_OF_FREEDOM):
        right[i] = p[layout.APPLIED + i, case] - right[i]
    right[CAGE] = -right[CAGE] - cage_residual(rig, orbit, sheet.forces)[0]
    for i in range(RING):
        free = i == CAGE or p[layout.FREE + min(i, 4), case] > 0.0
        largest = 0.0
        for unknown in range(RING):
            matrix[i, unknown] *= speed if unknown == CAGE else inward
            largest = max(largest, abs(matrix[i, unknown]))
        kept = free and largest > 0.0
        for unknown in range(RING):  # one size for all equations, and none for what is held
            unit = 1.0 if i == unknown else 0.0
            matrix[i, unknown] = matrix[i, unknown] / largest if kept else unit
        right[i] = right[i] / largest if kept else 0.0
    if not solve_dense(matrix, right):
        return False
    for i in range(RING):
        right[i] *= speed if i == CAGE else inward
    for j in range(rig.cosines.size):
        c, s = direction(p, case, rig.cosines[j], rig.sines[j])
        da1 = right[0] + c * right[3] - s * right[4]
        da2 = c * right[2] + s * right[1]
        for row in range(BALL):
            f = step.follow[j, row]
            step.balls[j, row] = f[0] + f[1] * da1 + f[2] * da2 + f[3] * right[CAGE]
    return True


@filling
def relax(
    rig: Rig, place: Place, origin: Place, mesh: Mesh, enough: float, sheet: Sheet, step: Step
) -> tuple[float, int]:
    """Newton's method at one smoothing speed, in place: (greatest residual, evaluations).

    origin: room for the place that a step begins at.
    """
    reach = LONGEST * rig.p[layout.OUTER_LENGTH, rig.case]
    before, part, worst = 0.0, 1.0, 0.0
    taken, shortened, evaluations = 0, 0, 0
    for _ in range(STEPS * SHORTENINGS):
        merit, worst = evaluate(rig, place, mesh, sheet)
        evaluations += 1
        if taken == 0 or merit < before:
            if worst <= enough or taken == STEPS:
                break
            if not find_step(rig, place.u[CAGE], sheet, step):
                break
            copy_place(place, origin)
            taken, shortened, before = taken + 1, 0, merit
            part = _longest_part(step.balls, reach)
        else:
            shortened += 1
            if shortened == SHORTENINGS:
                break
            part *= SHORTER
        _move(origin, step, part, place)
    return worst, evaluations


@filling
def copy_place(source: Place, target: Place) -> None:
    """Copy all unknowns."""
    for i in range(RING):  # element by element: slices take a compiler long
        target.u[i] = source.u[i]
    for j in range(source.x.shape[0]):
        for i in range(2):
            target.x[j, i] = source.x[j, i]
        for i in range(3):
            target.omega[j, i] = source.omega[j, i]


@filling
def _longest_part(steps: Array, reach: float) -> float:
    """The part of a step that moves no ball too far."""
    longest = 0.0
    for j in range(steps.shape[0]):
        longest = max(longest, abs(steps[j, 0]), abs(steps[j, 1]))
    return min(1.0, reach / longest) if longest > 0.0 else 1.0


@filling
def _move(origin: Place, step: Step, part: float, place: Place) -> None:
    """Go a part of the step from the origin."""
    for i in range(RING):
        place.u[i] = origin.u[i] + part * step.right[i]
    for j in range(step.balls.shape[0]):
        for i in range(2):
            place.x[j, i] = origin.x[j, i] + part * step.balls[j, i]
        for i in range(3):
            place.omega[j, i] = origin.omega[j, i] + part * step.balls[j, 2 + i]


@filling
def ring_stiffness(rig: Rig, sheet: Sheet, step: Step, tangent: Array) -> None:
    """The ring's load by its displacement, balls and cage following; (5, 5), NaN if singular."""
    found = eliminate_balls(rig, sheet, step)
    system = step.matrix
    turns = found and system[CAGE, CAGE] != 0.0
    for i in range(layout.DEGREES_OF_FREEDOM):
        for j in range(layout.DEGREES_OF_FREEDOM):
            cage = system[i, CAGE] * system[CAGE, j] / system[CAGE, CAGE] if turns else 0.0
            tangent[i, j] = system[i, j] - cage if found else np.nan
