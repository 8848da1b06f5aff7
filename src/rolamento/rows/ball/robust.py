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
from rolamento.rows.ball.abreast import fill, settle_abreast
from rolamento.rows.ball.accept import max_with_nan
from rolamento.rows.ball.settle import NEAR, settle, settle_otherwise
from rolamento.rows.ball.single import (
    OneCase,
    Ring,
    add_to_cage,
    add_to_ring,
    cage_part,
    condense_cage,
    direction,
    empty_ring,
    groove,
    static_ball,
)
from rolamento.rows.ball.types import Array
from rolamento.status import GREATEST_APPROACH, NO_EQUILIBRIUM, OVERLOADED

RING_STEPS: Final = 100
SHORTENINGS: Final = 25
PRECISION: Final = 1e-11
CAGE_STEPS: Final = 40
LEAST_DAMPING: Final = 1e-10
MOST_DAMPING: Final = 1e4
NEAR_BALANCE: Final = 1e-3
"""Fraction of the loads: what is unbalanced where the ring's step need not be downhill. Where the
rings turn against each other, or the balls push the ring off, an equilibrium need not be a
minimum."""
LOOSE: Final = 1e-2
"""Fraction of the ring's unbalanced part that may be left of a ball, whose last step squares it,
while the ring is on its way."""
FARTHER, AFTER_RETREAT = 3.0, 2.0
"""Times the ring's last step: how far the next may go at first, where the last was not shortened
and where it was."""
NEAR_CAGE, LOOSE_CAGE = 1e-4, 1e-2
"""Residual of the cage that is left to its step along with the ring's: of a ring near balance, and
at most."""
BALANCED_CAGE: Final = 1e-6
"""And at the end: the step squares it."""
FOLLOWS, FOLLOWS_TIMIDLY = 0.2, 0.02
"""Fractions of the ring's longest step: a ball that would go farther is settled from where it was.
Where the rings turn against each other there are several equilibria, and it might end up in
another."""


@shared
def _settle_balls(one: OneCase, cage: float, near: float) -> tuple[bool, float]:
    """Settle every ball, from and into x, at the places of the ring and the speed of the cage.

    near: as of `settle`. Sums up what they ask of ring and cage. Returns (whether all settled, the
    greatest load of a ball); stops at one that does not settle.
    """
    p, case, moving, ring = one.p, one.case, one.moving, one.ring
    control, cosines, sines, u, x = one.control, one.cosines, one.sines, one.u, one.x
    empty_ring(p, case, cage, ring)
    greatest, abreast = 0.0, moving and ring.b.shape[0] > 0
    if abreast:
        greatest = settle_abreast(one, cage, near)
    for j in range(cosines.size):
        if abreast and ring.left[j] == 0.0:
            continue
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        if moving:
            if abreast:
                found, x[j, 0], x[j, 1], ball = settle_otherwise(
                    p, case, cage, control[j], a1, a2, near, ring.work
                )
            else:
                found, x[j, 0], x[j, 1], ball = settle(
                    p, case, cage, control[j], a1, a2, x[j, 0], x[j, 1], near, ring.work
                )
            if not found or ring.work[0] < 0.0:
                return False, greatest
            _, follow, force, stiffness, scale, touch, drive, before = ball
            if not scale > 0.0:
                ring.follow[j] = 0.0
                continue  # a ball that nothing touches
            for k in range(6):
                ring.follow[j, k] = follow[2 + k]
            add_to_cage(ring, c, s, before[4], drive)
        else:
            ring.work[0] -= 0.5
            x[j, 0], x[j, 1], force, stiffness, scale, touch = static_ball(
                p, case, control[j], a1, a2
            )
        ring.load[0] += touch[0]
        greatest = max(greatest, scale)
        add_to_ring(ring, c, s, force, stiffness)
    return not abreast or ring.work[0] >= 0.0, greatest


@shared
def evaluate(one: OneCase, cage: float, error: float) -> tuple[bool, float, float, float]:
    """Bring balls and cage into balance at the ring's place u; sum up what they ask of the ring.

    error: what was last unbalanced of the ring's loads, as well as that deserves.
    Returns (whether they are, the greatest load of a ball, the cage's speed, its residual before
    the last step). The ring's force and stiffness are those with balls and cage following.
    """
    p, case, moving, x, ring = one.p, one.case, one.moving, one.x, one.ring
    inner, outer = p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case]
    slowest, fastest = min(inner, outer), max(inner, outer)
    greatest, behind = 0.0, np.inf
    near_ball = max(NEAR, LOOSE * min(error, 1.0))
    near_cage = max(NEAR_CAGE, LOOSE_CAGE * min(error, 1.0))
    for _ in range(CAGE_STEPS if moving else 1):
        settled, greatest = _settle_balls(one, cage, near_ball)
        if not (settled and moving) or ring.lag_by_cage[0] == 0.0:
            return settled, greatest, cage, 0.0
        behind = cage_part(ring.lag[0], ring.pull[0], inner, outer)
        if ring.lag[0] > 0.0:
            slowest = cage
        else:
            fastest = cage
        speed = cage - ring.lag[0] / ring.lag_by_cage[0]
        near = behind <= near_cage
        if not (slowest < speed < fastest or near):
            speed = 0.5 * (slowest + fastest)
        for j in range(len(x)):
            x[j, 0] += ring.follow[j, 4] * (speed - cage)
            x[j, 1] += ring.follow[j, 5] * (speed - cage)
        cage = speed
        if near:
            condense_cage(ring)
            return True, greatest, cage, behind
    return False, greatest, cage, behind


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
    one: OneCase,
    cage: float,
    error: float,
    reach: float,
    step: Array,
    slope: float,
    unbalanced: Array,
) -> tuple[bool, float, float, float, float]:
    """Move the ring along the step until it does not overshoot by much, balls and cage with it.

    error: as of `evaluate`; reach: how far it may go at first; slope: the unbalanced load along the
    step, at its start. A ring that has lost all its balls has overshot, however small the load that
    is left unbalanced. Returns what `evaluate` does, and the reach of the next step.
    """
    p, case, moving, ring = one.p, one.case, one.moving, one.ring
    cosines, sines, u, x = one.cosines, one.sines, one.u, one.x
    longest = 0.3 * (p[layout.INNER_LENGTH, case] + p[layout.OUTER_LENGTH, case])
    length = sqrt(_dot(step, step))
    part = min(1.0, min(reach, longest) / length)
    touched = ring.load[0] > 0.0
    near, ahead_near = 0.0, slope
    from_u, from_x, from_cage, follow = u.copy(), x.copy(), cage, ring.follow.copy()
    slowest = min(p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case])
    fastest = max(p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case])
    against = p[layout.INNER_SPEED, case] * p[layout.OUTER_SPEED, case] < 0.0
    farthest = longest * (FOLLOWS_TIMIDLY if against else FOLLOWS)
    drift = 0.0  # of the cage, along with the ring
    if moving and ring.lag_by_cage[0] != 0.0:
        drift = -_dot(ring.lag_by_ring, step) / ring.lag_by_cage[0]
    settled, greatest, behind = False, 0.0, 0.0
    for trial in range(SHORTENINGS):
        reach = part * length * (FARTHER if trial == 0 else AFTER_RETREAT)
        for i in range(u.size):
            u[i] = from_u[i] + part * step[i]
        change = part * drift
        change = change if slowest < from_cage + change < fastest else 0.0
        for j in range(x.shape[0]):
            c, s = direction(p, case, cosines[j], sines[j])
            da1 = part * (step[0] + c * step[3] - s * step[4])
            da2 = part * (c * step[2] + s * step[1])
            dx1 = follow[j, 0] * da1 + follow[j, 1] * da2 + follow[j, 4] * change
            dx2 = follow[j, 2] * da1 + follow[j, 3] * da2 + follow[j, 5] * change
            follows = moving and sqrt(dx1 * dx1 + dx2 * dx2) < farthest
            x[j, 0] = from_x[j, 0] + (dx1 if follows else 0.0)
            x[j, 1] = from_x[j, 1] + (dx2 if follows else 0.0)
        settled, greatest, cage, behind = evaluate(one, from_cage + change, error)
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
    return settled, greatest, cage, behind, reach


@shared
def solve_robust(one: OneCase, start: float) -> tuple[bool, int, int, float]:
    """Equilibrium of one case from the start (u, cage's speed, x), u and x in place.

    Returns (settled, iterations, escaping, cage's speed); escaping is the degree of freedom along
    which the ring runs away from its balls, or -1. Fills the ring's sums; once its work is spent,
    the search ends.
    """
    p, case, u, ring = one.p, one.case, one.u, one.ring
    unbalanced, step = np.zeros(5), np.zeros(5)
    ring.follow[:] = 0.0  # of another case, where a ball of this one does not settle at once
    damping, nearest, reach = 0.0, np.inf, np.inf
    if one.moving and ring.b.shape[0] > 0:
        fill(one)
    settled, greatest, cage, behind = evaluate(one, start, 0.0)
    for iteration in range(1, RING_STEPS + 1):
        error, scale = _unbalance(p, case, ring.reaction, greatest, unbalanced)
        balanced = settled and error <= PRECISION * scale
        if balanced and behind <= BALANCED_CAGE:
            return True, iteration, -1, cage
        if not error < np.inf or damping > MOST_DAMPING or ring.work[0] < 0.0:
            break
        if balanced:  # but for the cage
            settled, greatest, cage, behind = evaluate(one, cage, 0.0)
            continue
        for i in range(layout.DEGREES_OF_FREEDOM):
            if abs(u[i]) > p[layout.BALL_DIAMETER, case]:
                return False, iteration, i, cage
        solvable = _newton_step(p, case, unbalanced, ring.matrix, damping, step)
        slope = _dot(step, unbalanced)
        if solvable and slope < 0.0 and error <= min(NEAR_BALANCE * scale, 0.5 * nearest):
            nearest, slope = error, np.inf  # Newton's step as it is
        if not (solvable and slope > 0.0):
            damping = max(100.0 * damping, LEAST_DAMPING)
            continue
        settled, greatest, cage, behind, reach = _line_search(
            one, cage, error / scale, reach, step, slope, unbalanced
        )
        if not settled:
            break
        damping = 0.01 * damping if damping > LEAST_DAMPING else 0.0
    return False, iteration, -1, cage
