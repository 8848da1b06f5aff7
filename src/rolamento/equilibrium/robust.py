"""The safe path: the ring by a guarded Newton's method, every ball settled at every step.

With the inertia loads frozen the problem is convex in the ring's displacement, so the unbalanced
load along a step falls steadily: a step is shortened until it does not overshoot by much.
Slower than `blocks` by an order; for what that path gives up.
"""
# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np

from rolamento.equilibrium import rows
from rolamento.equilibrium.settle import settle
from rolamento.equilibrium.single import (
    add_to_ring,
    direction,
    groove,
    linearised,
    moves,
    static_ball,
)
from rolamento.numerics.compiled import shared
from rolamento.numerics.dense import solve_dense

RING_STEPS: Final = 60
SHORTENINGS: Final = 25
PRECISION: Final = 1e-11


@shared
def evaluate(p, case, control, cosines, sines, u, x, reaction, matrix):
    """Settle every ball at the ring's place u, from and into x; sum up their forces.

    Returns (whether all balls settled, the greatest load of a ball).
    """
    reaction[:] = 0.0
    matrix[:] = 0.0
    settled = True
    greatest = 0.0
    moving = moves(p, case)
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        if moving:
            found, x[j, 0], x[j, 1] = settle(p, case, control[j], a1, a2, x[j, 0], x[j, 1])
            settled = settled and found
            _, _, force, stiffness, scale, _ = linearised(
                p, case, control[j], a1, a2, x[j, 0], x[j, 1]
            )
            if not scale > 0.0:
                continue  # a ball that nothing touches
        else:
            x[j, 0], x[j, 1], force, stiffness, scale, _ = static_ball(p, case, a1, a2)
        greatest = max(greatest, scale)
        add_to_ring(reaction, matrix, c, s, force, stiffness)
    return settled, greatest


@shared
def _newton_step(p, case, unbalanced, matrix, damping, step):
    """The ring's step on its free degrees of freedom; False where the matrix is singular."""
    greatest = 0.0
    for i in range(5):
        greatest = max(greatest, abs(matrix[i, i]))
    reference = max(greatest, 1e-6 * p[rows.SERIES_STIFFNESS, case] * sqrt(1e-6))
    a = matrix.copy()
    for i in range(5):
        if p[rows.FREE + i, case] > 0.0:
            a[i, i] += damping * reference
        else:
            a[i, :] = 0.0
            a[i, i] = reference
        step[i] = unbalanced[i]
    return solve_dense(a, step)


@shared
def solve_robust(p, case, control, cosines, sines, u, x):
    """Equilibrium of one case from the start (u, x), in place: (settled, iterations, escaping).

    escaping is the degree of freedom along which the ring runs away from its balls, or -1.
    """
    reach = 0.3 * (p[rows.INNER_LENGTH, case] + p[rows.OUTER_LENGTH, case])
    reaction, unbalanced, step = np.zeros(5), np.zeros(5), np.zeros(5)
    matrix = np.zeros((5, 5))
    trial, place = u.copy(), x.copy()
    damping = 0.0
    settled, greatest = evaluate(p, case, control, cosines, sines, u, x, reaction, matrix)
    for iteration in range(1, RING_STEPS + 1):
        error, scale = 0.0, greatest
        for i in range(5):
            applied = p[rows.APPLIED + i, case]
            free = p[rows.FREE + i, case] > 0.0
            unbalanced[i] = applied - reaction[i] if free else 0.0
            error = abs(unbalanced[i]) if not abs(unbalanced[i]) <= error else error
            scale = max(scale, abs(applied) if free else 0.0)
        if settled and error <= PRECISION * scale:
            return True, iteration, -1
        if not error < np.inf:
            return False, iteration, -1
        for i in range(5):
            if abs(u[i]) > p[rows.BALL_DIAMETER, case]:
                return False, iteration, i
        if not _newton_step(p, case, unbalanced, matrix, damping, step):
            damping = max(100.0 * damping, 1e-10)
            continue
        length = sqrt(np.sum(step * step))
        slope = np.sum(step * unbalanced)
        if not slope > 0.0:
            damping = max(100.0 * damping, 1e-10)
            if damping > 1e4:
                return False, iteration, -1
            continue
        part = min(1.0, reach / length)
        for _ in range(SHORTENINGS):
            trial[:] = u + part * step
            place[:] = x
            settled, greatest = evaluate(
                p, case, control, cosines, sines, trial, place, reaction, matrix
            )
            ahead = 0.0
            for i in range(5):
                if p[rows.FREE + i, case] > 0.0:
                    ahead += step[i] * (p[rows.APPLIED + i, case] - reaction[i])
            if settled and ahead >= -0.5 * slope:
                break
            part *= min(max(slope / (slope - ahead), 0.1), 0.6) if settled else 0.3
        if not settled:
            return False, iteration, -1
        u[:] = trial
        x[:] = place
        damping = 0.0 if damping < 1e-9 else 0.01 * damping
    return False, RING_STEPS, -1
