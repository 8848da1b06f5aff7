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

from rolamento.equilibrium import rows
from rolamento.equilibrium.accept import max_with_nan
from rolamento.equilibrium.settle import settle
from rolamento.equilibrium.single import (
    add_to_ring,
    direction,
    groove,
    linearised,
    moves,
    static_ball,
)
from rolamento.equilibrium.types import Array
from rolamento.numerics.compiled import shared
from rolamento.numerics.dense import solve_dense

RING_STEPS: Final = 60
SHORTENINGS: Final = 25
PRECISION: Final = 1e-11
LEAST_DAMPING: Final = 1e-10
MOST_DAMPING: Final = 1e4


@shared
def evaluate(
    p: Array,
    case: int,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    x: Array,
    reaction: Array,
    matrix: Array,
) -> tuple[bool, float]:
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
def _unbalance(
    p: Array, case: int, reaction: Array, greatest: float, unbalanced: Array
) -> tuple[float, float]:
    """Fill in the load on the free degrees of freedom that the balls do not bear.

    Returns (its greatest entry, the greatest load on the ring or in it).
    """
    error, scale = 0.0, greatest
    for i in range(rows.DEGREES_OF_FREEDOM):
        unbalanced[i] = 0.0
        if p[rows.FREE + i, case] > 0.0:
            applied = p[rows.APPLIED + i, case]
            unbalanced[i] = applied - reaction[i]
            error = max_with_nan(error, abs(unbalanced[i]))
            scale = max(scale, abs(applied))
    return error, scale


@shared
def _newton_step(
    p: Array, case: int, unbalanced: Array, matrix: Array, damping: float, step: Array
) -> bool:
    """The ring's step on its free degrees of freedom; False where the matrix is singular.

    The damping is relative to the greatest stiffness, or where no ball touches, to what a
    contact would have at a picometre of approach.
    """
    n = rows.DEGREES_OF_FREEDOM
    reference = 1.5e-6 * p[rows.SERIES_STIFFNESS, case]
    for i in range(n):
        reference = max(reference, abs(matrix[i, i]))
    a = np.zeros((n, n))
    for i in range(n):
        step[i] = unbalanced[i]
        free = p[rows.FREE + i, case] > 0.0
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
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    x: Array,
    step: Array,
    slope: float,
    reaction: Array,
    matrix: Array,
    unbalanced: Array,
) -> tuple[bool, float]:
    """Move the ring along the step until it does not overshoot by much, the balls with it.

    slope: the unbalanced load along the step, at its start. Returns what `evaluate` does.
    """
    reach = 0.3 * (p[rows.INNER_LENGTH, case] + p[rows.OUTER_LENGTH, case])
    part = min(1.0, reach / sqrt(_dot(step, step)))
    from_u, from_x = u.copy(), x.copy()
    settled, greatest = False, 0.0
    for _ in range(SHORTENINGS):
        for i in range(u.size):
            u[i] = from_u[i] + part * step[i]
        for j in range(x.shape[0]):
            x[j, 0], x[j, 1] = from_x[j, 0], from_x[j, 1]
        settled, greatest = evaluate(p, case, control, cosines, sines, u, x, reaction, matrix)
        _unbalance(p, case, reaction, greatest, unbalanced)
        ahead = _dot(step, unbalanced)
        if settled and ahead >= -0.5 * slope:
            break
        part *= min(max(slope / (slope - ahead), 0.1), 0.6) if settled else 0.3
    return settled, greatest


@shared
def solve_robust(
    p: Array, case: int, control: Array, cosines: Array, sines: Array, u: Array, x: Array
) -> tuple[bool, int, int]:
    """Equilibrium of one case from the start (u, x), in place: (settled, iterations, escaping).

    escaping is the degree of freedom along which the ring runs away from its balls, or -1.
    """
    reaction, unbalanced, step = np.zeros(5), np.zeros(5), np.zeros(5)
    matrix = np.zeros((5, 5))
    damping = 0.0
    settled, greatest = evaluate(p, case, control, cosines, sines, u, x, reaction, matrix)
    for iteration in range(1, RING_STEPS + 1):
        error, scale = _unbalance(p, case, reaction, greatest, unbalanced)
        if settled and error <= PRECISION * scale:
            return True, iteration, -1
        if not error < np.inf or damping > MOST_DAMPING:
            break
        for i in range(rows.DEGREES_OF_FREEDOM):
            if abs(u[i]) > p[rows.BALL_DIAMETER, case]:
                return False, iteration, i
        solvable = _newton_step(p, case, unbalanced, matrix, damping, step)
        slope = _dot(step, unbalanced)
        if not (solvable and slope > 0.0):
            damping = max(100.0 * damping, LEAST_DAMPING)
            continue
        settled, greatest = _line_search(
            p, case, control, cosines, sines, u, x, step, slope, reaction, matrix, unbalanced
        )
        if not settled:
            break
        damping = 0.01 * damping if damping > LEAST_DAMPING else 0.0
    return False, iteration, -1
