"""Where neither path leads to an equilibrium: step by step from one that is easily found.

A light load leaves the ring far from where it would stand unloaded, in a valley as narrow as the
balls' approach. A heavy load of the same direction makes it wide; from there the load comes down
to what is given. At speed the balls, thrown outward, push a lightly loaded ring along its axis
until the inner contacts are nearly as steep as they can be: from rest the speed goes up. Every step
starts from the equilibrium before, and is shortened where that does not do.
"""

from __future__ import annotations

from math import log, sqrt
from typing import Final

import numpy as np

from rolamento import status
from rolamento.numerics.compiled import inline_exact, shared
from rolamento.rows.ball import accept, layout
from rolamento.rows.ball.accept import inertia_of, judge
from rolamento.rows.ball.robust import escaped, solve_robust
from rolamento.rows.ball.single import OneCase
from rolamento.rows.ball.types import Array

HEAVY: Final = 0.05
"""Approach over the grooves' offsets under the heavy load."""
FIRST: Final = 1e-3
"""Fraction of the heaviest ball's load at rest: the inertia load to begin with."""
BOLDEST: Final = 2.5
TIMIDEST: Final = 1.002
MOST_STEPS: Final = 80


@inline_exact
def heaviest_factor(p: Array, case: int, balls: int) -> float:
    """By how much the given loads may grow before they press the balls in deeply."""
    length = p[layout.OUTER_LENGTH, case] + p[layout.INNER_LENGTH, case]
    load = 0.0
    for i in range(layout.DEGREES_OF_FREEDOM):
        if p[layout.FREE + i, case] > 0.0:
            load += abs(p[layout.APPLIED + i, case])
    heavy = 0.2 * balls * p[layout.SERIES_STIFFNESS, case] * (HEAVY * length) ** 1.5
    return max(heavy / load, 1.0) if load > 0.0 else 1.0


@shared
def put_factors(p: Array, case: int, load: float, speed: float, part: Array) -> None:
    """Fill in a case's parameters, its loads and its speeds multiplied."""
    part[:, 0] = p[:, case]
    for i in range(layout.DEGREES_OF_FREEDOM):
        part[layout.APPLIED + i, 0] *= load
    for row in (layout.INNER_SPEED, layout.OUTER_SPEED, layout.NOMINAL_ORBIT):
        part[row, 0] *= speed
    part[layout.CAGE_WEIGHT, 0] *= speed * speed
    part[layout.HOLD_RATE, 0] /= speed * speed if speed > 0.0 else 1.0


@shared
def _follow(one: OneCase, moving: bool, first: float) -> tuple[int, float, int, int, float]:
    """Follow the equilibrium from a first factor to 1: of the speed if moving, else of the load."""
    p, case, u, x, ring = one.p, one.case, one.u, one.x, one.ring
    part = np.empty((p.shape[0], 1))
    on_the_way = OneCase(
        part, 0, moving, one.control, one.cosines, one.sines, u, x, ring, one.errors
    )
    ratio, factor, done, steps = BOLDEST, first, 0.0, 0
    cage = first * p[layout.NOMINAL_ORBIT, case] if moving else 0.0
    good_u, good_x, good_cage = u.copy(), x.copy(), cage
    before_u, before = u.copy(), 0.0
    code, residual, unsupported = status.NOT_CONVERGED, np.nan, -1
    for _ in range(MOST_STEPS):
        put_factors(p, case, 1.0 if moving else factor, factor if moving else 1.0, part)
        _, more, escaping, cage = solve_robust(on_the_way, cage)
        steps += more
        code, residual, unsupported = judge(on_the_way, cage)
        if code == status.NOT_CONVERGED and escaping >= 0 and not moving:
            code = escaped(part, 0, x.shape[0], ring)
            lost = escaping if code == status.NO_EQUILIBRIUM else -1
            return code, residual, lost, steps, cage
        if code != status.NOT_CONVERGED:
            if factor == 1.0:
                break
            before_u[:], before = good_u, done
            good_u[:], good_x[:], good_cage, done = u, x, cage, factor
            ratio = min(BOLDEST, ratio * sqrt(ratio))
        else:
            ratio = sqrt(ratio)
            if done == 0.0 or ratio < TIMIDEST or ring.work[0] < 0.0:
                break
        u[:], x[:] = good_u, good_x
        factor = min(done * ratio, 1.0) if first < 1.0 else max(done / ratio, 1.0)
        cage = good_cage * factor / done if moving else 0.0
        if before > 0.0 and code != status.NOT_CONVERGED:  # on along the way it came
            ahead = log(factor / done) / log(done / before)
            for i in range(layout.DEGREES_OF_FREEDOM):
                u[i] += ahead * (good_u[i] - before_u[i])
    if factor != 1.0 and code != status.NOT_CONVERGED:
        code, unsupported = status.NOT_CONVERGED, -1
    return code, residual, unsupported, steps, cage


@shared
def solve_by_steps(one: OneCase) -> tuple[int, float, int, int, float]:
    """Equilibrium of a case from a start pressed in, in u and x: at rest first, then up to speed.

    Returns (code, residual, unsupported) as `judge` does, (iterations, cage's speed).
    """
    p, case, balls = one.p, one.case, one.cosines.size
    first = heaviest_factor(p, case, balls)
    code, residual, unsupported, steps, cage = _follow(one, False, first)
    done = code in (status.CONVERGED, status.OVER_SHOULDER, accept.NEEDS_INERTIA)
    if not one.moving or not done:
        return code, residual, unsupported, steps, cage
    heaviest = 0.0
    for j in range(balls):
        heaviest = max(heaviest, one.errors[j, 1])
    first = min(sqrt(FIRST * heaviest / inertia_of(p, case)), 1.0)
    if not first > 0.0:
        return status.NOT_CONVERGED, residual, -1, steps, cage
    code, residual, unsupported, more, cage = _follow(one, True, first)
    return code, residual, unsupported, steps + more, cage
