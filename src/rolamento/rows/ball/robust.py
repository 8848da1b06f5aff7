"""The safe path: the ring by a guarded Newton's method, every ball settled at every step.

With the inertia loads frozen the problem would be convex in the ring's displacement; they vary
little, and the unbalanced load along a step falls steadily: a step is shortened until it does not
overshoot by much.
Slower than `blocks` by an order; for what that path gives up.
"""

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np

from rolamento.numerics.compiled import shared
from rolamento.numerics.dense import solve_dense
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import GREATEST_APPROACH, max_with_nan
from rolamento.rows.ball.settle import settle
from rolamento.rows.ball.single import (
    Ring,
    add_to_cage,
    add_to_ring,
    cage_residual,
    condense_cage,
    direction,
    empty_ring,
    groove,
    linearised,
    static_ball,
)
from rolamento.rows.ball.types import Array
from rolamento.status import NO_EQUILIBRIUM, OVERLOADED

RING_STEPS: Final = 60
SHORTENINGS: Final = 25
PRECISION: Final = 1e-11
CAGE_STEPS: Final = 40
LEAST_DAMPING: Final = 1e-10
MOST_DAMPING: Final = 1e4


@shared
def _settle_balls(
    p: Array,
    case: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    cage: float,
    x: Array,
    ring: Ring,
) -> tuple[bool, float]:
    """Settle every ball, from and into x, at the places of the ring and the speed of the cage.

    Sums up what they ask of ring and cage. Returns (whether all settled, the greatest load of a
    ball); stops at one that does not settle.
    """
    empty_ring(p, case, cage, ring)
    greatest = 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        if moving:
            found, x[j, 0], x[j, 1] = settle(
                p, case, cage, control[j], a1, a2, x[j, 0], x[j, 1], ring.work
            )
            ring.work[0] -= 1.0
            if not found or ring.work[0] < 0.0:
                return False, greatest
            _, _, force, stiffness, scale, touch, drive, before = linearised(
                p, case, cage, control[j], a1, a2, x[j, 0], x[j, 1]
            )
            if not scale > 0.0:
                continue  # a ball that nothing touches
            add_to_cage(ring, c, s, before[4], drive)
        else:
            ring.work[0] -= 0.5
            x[j, 0], x[j, 1], force, stiffness, scale, touch = static_ball(
                p, case, control[j], a1, a2
            )
        ring.load[0] += touch[0]
        greatest = max(greatest, scale)
        add_to_ring(ring, c, s, force, stiffness)
    return True, greatest


@shared
def evaluate(
    p: Array,
    case: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    cage: float,
    x: Array,
    ring: Ring,
) -> tuple[bool, float, float]:
    """Bring balls and cage into balance at the ring's place u; sum up what they ask of the ring.

    Returns (whether they are, the greatest load of a ball, the cage's speed). The ring's force and
    stiffness are those with balls and cage following.
    """
    if not moving:
        settled, greatest = _settle_balls(
            p, case, moving, control, cosines, sines, u, cage, x, ring
        )
        return settled, greatest, cage
    slowest = min(p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case])
    fastest = max(p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case])
    for _ in range(CAGE_STEPS):
        settled, greatest = _settle_balls(
            p, case, moving, control, cosines, sines, u, cage, x, ring
        )
        if not settled:
            return False, greatest, cage
        if (
            cage_residual(p, case, ring.lag[0], ring.pull[0]) <= PRECISION
            or ring.lag_by_cage[0] == 0.0
        ):
            condense_cage(ring)
            return True, greatest, cage
        if ring.lag[0] > 0.0:
            slowest = cage
        else:
            fastest = cage
        speed = cage - ring.lag[0] / ring.lag_by_cage[0]
        cage = speed if slowest < speed < fastest else 0.5 * (slowest + fastest)
    return False, greatest, cage


@shared
def _unbalance(
    p: Array, case: int, reaction: Array, greatest: float, unbalanced: Array
) -> tuple[float, float]:
    """Fill in the load on the free degrees of freedom that the balls do not bear.

    Returns (its greatest entry, the greatest load on the ring or in it).
    """
    error, scale = 0.0, greatest
    for i in range(layout.DEGREES_OF_FREEDOM):
        unbalanced[i] = 0.0
        if p[layout.FREE + i, case] > 0.0:
            applied = p[layout.APPLIED + i, case]
            unbalanced[i] = applied - reaction[i]
            error = max_with_nan(error, abs(unbalanced[i]))
            scale = max(scale, abs(applied))
    return error, scale


@shared
def escaped(p: Array, case: int, balls: int, ring: Ring) -> int:
    """Say what has become of a ring that left its place: pressed far into its balls, or past them.

    It is pressed in where a ball carries more than at the greatest approach, or all balls together
    could not carry the load with less.
    """
    deepest = GREATEST_APPROACH * p[layout.BALL_DIAMETER, case]
    crushing = p[layout.SERIES_STIFFNESS, case] * deepest * sqrt(deepest)
    load = ring.load[0]
    for i in range(layout.DEGREES_OF_FREEDOM):
        if p[layout.FREE + i, case] > 0.0:
            load = max(load, abs(p[layout.APPLIED + i, case]) / balls)
    return OVERLOADED if load > crushing else NO_EQUILIBRIUM


@shared
def _newton_step(
    p: Array, case: int, unbalanced: Array, matrix: Array, damping: float, step: Array
) -> bool:
    """The ring's step on its free degrees of freedom; False where the matrix is singular.

    The damping is relative to the greatest stiffness, or where no ball touches, to what a
    contact would have at a picometre of approach.
    """
    n = layout.DEGREES_OF_FREEDOM
    reference = 1.5e-6 * p[layout.SERIES_STIFFNESS, case]
    for i in range(n):
        reference = max(reference, abs(matrix[i, i]))
    a = np.zeros((n, n))
    for i in range(n):
        step[i] = unbalanced[i]
        free = p[layout.FREE + i, case] > 0.0
        for j in range(n):
            a[i, j] = matrix[i, j] if free else 0.0
        a[i, i] += damping * reference if free else reference
    return solve_dense(a, step)


@shared
def _dot(a: Array, b: Array) -> float:
    total = 0.0
    for i in range(a.size):
        total += a[i] * b[i]
    return total


@shared
def _line_search(
    p: Array,
    case: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    cage: float,
    x: Array,
    step: Array,
    slope: float,
    ring: Ring,
    unbalanced: Array,
) -> tuple[bool, float, float]:
    """Move the ring along the step until it does not overshoot by much, balls and cage with it.

    slope: the unbalanced load along the step, at its start. A ring that has lost all its balls
    has overshot, however small the load that is left unbalanced. Returns what `evaluate` does.
    """
    reach = 0.3 * (p[layout.INNER_LENGTH, case] + p[layout.OUTER_LENGTH, case])
    part = min(1.0, reach / sqrt(_dot(step, step)))
    touched = ring.load[0] > 0.0
    near, ahead_near = 0.0, slope
    from_u, from_x, from_cage = u.copy(), x.copy(), cage
    settled, greatest = False, 0.0
    for _ in range(SHORTENINGS):
        for i in range(u.size):
            u[i] = from_u[i] + part * step[i]
        for j in range(x.shape[0]):
            x[j, 0], x[j, 1] = from_x[j, 0], from_x[j, 1]
        settled, greatest, cage = evaluate(
            p, case, moving, control, cosines, sines, u, from_cage, x, ring
        )
        if ring.work[0] < 0.0:
            break
        if not settled:
            part = near + 0.3 * (part - near)
            continue
        _unbalance(p, case, ring.reaction, greatest, unbalanced)
        ahead = _dot(step, unbalanced)
        if ahead >= 0.0:
            break
        lost = touched and not ring.load[0] > 0.0
        if ahead >= -0.5 * slope and not lost:
            break
        share = 0.5 if lost else min(max(ahead_near / (ahead_near - ahead), 0.1), 0.6)
        part = near + share * (part - near)
    return settled, greatest, cage


@shared
def solve_robust(
    p: Array,
    case: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    start: float,
    x: Array,
    ring: Ring,
) -> tuple[bool, int, int, float]:
    """Equilibrium of one case from the start (u, cage's speed, x), u and x in place.

    Returns (settled, iterations, escaping, cage's speed); escaping is the degree of freedom along
    which the ring runs away from its balls, or -1. Fills the ring's sums; once its work is spent,
    the search ends.
    """
    unbalanced, step = np.zeros(5), np.zeros(5)
    damping = 0.0
    settled, greatest, cage = evaluate(p, case, moving, control, cosines, sines, u, start, x, ring)
    for iteration in range(1, RING_STEPS + 1):
        error, scale = _unbalance(p, case, ring.reaction, greatest, unbalanced)
        if settled and error <= PRECISION * scale:
            return True, iteration, -1, cage
        if not error < np.inf or damping > MOST_DAMPING or ring.work[0] < 0.0:
            break
        for i in range(layout.DEGREES_OF_FREEDOM):
            if abs(u[i]) > p[layout.BALL_DIAMETER, case]:
                return False, iteration, i, cage
        solvable = _newton_step(p, case, unbalanced, ring.matrix, damping, step)
        slope = _dot(step, unbalanced)
        if not (solvable and slope > 0.0):
            damping = max(100.0 * damping, LEAST_DAMPING)
            continue
        settled, greatest, cage = _line_search(
            p, case, moving, control, cosines, sines, u, cage, x, step, slope, ring, unbalanced
        )
        if not settled:
            break
        damping = 0.01 * damping if damping > LEAST_DAMPING else 0.0
    return False, iteration, -1, cage
