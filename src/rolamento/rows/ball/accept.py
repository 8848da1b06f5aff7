"""Whether a proposed equilibrium may be shown: every residual, every contact, in exact arithmetic.

Residuals alone do not prove a solution: a ball can balance where it can never be (the equations
have such roots, with alpha_o < 0 at an unloaded ball, or with friction where nothing presses).
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Final

from rolamento.numerics.compiled import filling, inline_exact
from rolamento.rows.ball import layout
from rolamento.rows.ball.settle import in_place
from rolamento.rows.ball.single import (
    LOAD_FLOOR,
    OneCase,
    Ring,
    add_force,
    add_to_cage,
    add_to_ring,
    cage_part,
    condense_cage,
    direction,
    empty_ring,
    groove,
    is_rounding,
    linearised,
    rounding,
    static_ball,
)
from rolamento.rows.ball.types import Array, Two
from rolamento.status import (
    CONVERGED,
    GREATEST_APPROACH,
    NO_EQUILIBRIUM,
    NOT_CONVERGED,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
    UNCONSTRAINED_BALL,
)

NEEDS_INERTIA: Final = 7  # to be solved again: at rest this would be the result

FRICTION_SLACK: Final = 1e-6  # of a ball's load, at a contact that carries none
LOST_ANGLE: Final = 1e-9  # rad, below which a one-sided bearing has left its shoulder


@filling
def judge(one: OneCase, cage: float) -> tuple[int, float, int]:
    """Measure a proposal: (code, residual, unsupported degree of freedom or -1).

    The residual is the greatest of the ring's (over the greatest load on it or in it), the
    cage's (over the rings' speeds) and the balls' (beyond rounding, each over its own greatest
    load, or a millionth of the heaviest ball's); where the balls are taken to be at rest though
    they turn, the inertia left out counts, over the heaviest ball's load.

    Fills the ring's reaction and its matrix, the derivative of the reaction with every ball and
    the cage following; places the balls of a bearing without inertia.
    """
    p, case, moving, ring, errors = one.p, one.case, one.moving, one.ring, one.errors
    control, cosines, sines, u, x = one.control, one.cosines, one.sines, one.u, one.x
    empty_ring(p, case, cage, ring)
    lag = ring.lag[0]
    one_sided = p[layout.ONE_SIDED, case] > 0.0
    placed, held, inside, lost, deepest, heaviest = True, True, True, -1, 0.0, 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        errors[j, 0] = 0.0
        if moving:
            residual, _, force, stiffness, scale, touch, drive, before = linearised(
                p, case, cage, control[j], a1, a2, x[j, 0], x[j, 1]
            )
            errors[j, 0] = sqrt(residual[0] ** 2 + residual[1] ** 2)
            placed = placed and in_place(p, case, a1, x[j, 0], x[j, 1])
            # a race that does not press on the ball has no friction for its gyroscopic moment
            if touch[0] == 0.0 and scale > 0.0:
                held = held and abs(force[0]) + abs(force[1]) <= FRICTION_SLACK * scale
            if scale > 0.0 or scale != scale:
                add_to_cage(ring, c, s, before[4], drive)
                add_force(ring.now, c, s, (before[0], before[1], before[2]))
                lag += before[3]
        else:
            x[j, 0], x[j, 1], force, stiffness, scale, touch = static_ball(
                p, case, control[j], a1, a2
            )
            add_force(ring.now, c, s, force)
        errors[j, 1] = scale
        heaviest = max(heaviest, scale)
        load, c_i, c_o, approach, s_i = touch
        deepest = max(deepest, approach)
        if load > 0.0:
            inside = inside and c_i > p[layout.INNER_EDGE, case]
            if one_sided and s_i <= LOST_ANGLE:
                lost = _turned_away(p, case, c, s)
        if scale > 0.0 or scale != scale:
            inside = inside and c_o > p[layout.OUTER_EDGE, case]
            add_to_ring(ring, c, s, force, stiffness)

    residual_of_all, left_out = weigh(p, case, moving, lag, heaviest, ring, errors)
    if left_out > TOLERANCE and residual_of_all <= left_out:
        return NEEDS_INERTIA, residual_of_all, -1
    # a ball whose place is NaN is not in place; one without inertia has none but the ring's
    if not is_finite(u) or not residual_of_all <= TOLERANCE or not placed:
        return NOT_CONVERGED, residual_of_all, -1
    if not held:
        return UNCONSTRAINED_BALL, residual_of_all, -1
    if lost >= 0:
        return NO_EQUILIBRIUM, residual_of_all, lost
    if deepest > GREATEST_APPROACH * p[layout.BALL_DIAMETER, case]:
        return OVERLOADED, residual_of_all, -1
    if not inside:
        return OVER_SHOULDER, residual_of_all, -1
    return CONVERGED, residual_of_all, -1


@filling
def weigh(
    p: Array, case: int, moving: bool, lag: float, heaviest: float, ring: Ring, errors: Array
) -> Two:
    """The residual of a proposal, and the part of it that left out inertia is; see `judge`.

    lag: what the cage is behind its drive; ring: the sums over the balls, of which the cage is
    taken out; errors (balls, 2): size of each ball's residual and scale of its own loads.
    """
    behind, left_out = 0.0, 0.0
    if moving:
        speeds = p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case]
        behind = cage_part(lag, ring.pull[0], speeds[0], speeds[1])
        condense_cage(ring)
    else:
        left_out = inertia_of(p, case) / heaviest if heaviest > 0.0 else inertia_of(p, case)
    scale, error = heaviest, 0.0
    for i in range(layout.DEGREES_OF_FREEDOM):
        if p[layout.FREE + i, case] > 0.0:
            applied = p[layout.APPLIED + i, case]
            scale = max(scale, abs(applied))
            error = max_with_nan(error, abs(applied - ring.now[i]))
    unbalanced = error / scale if scale > 0.0 else error
    residual = max_with_nan(unbalanced, behind + left_out)
    return worst_ball(p, case, errors, heaviest, residual), left_out


@inline_exact
def is_finite(u: Array) -> bool:
    """Whether the ring is anywhere."""
    return bool(abs(u[0] + u[1] + u[2] + u[3] + u[4]) < inf)


@inline_exact
def max_with_nan(a: float, b: float) -> float:
    """The greater of two numbers; NaN if either is."""
    return b if not b <= a else a + 0.0 * b


@inline_exact
def inertia_of(p: Array, case: int) -> float:
    """A bound of a ball's inertia loads: those at half the sum of the rings' speeds."""
    speed = 0.5 * (abs(p[layout.INNER_SPEED, case]) + abs(p[layout.OUTER_SPEED, case]))
    force = max(p[layout.CENTRIFUGAL, case], 5.0 * p[layout.GYROSCOPIC, case])
    return float(2.0 * force * speed * speed)


@inline_exact
def own_scale(scale: float, heaviest: float) -> float:
    """The load that a ball's residual is measured by: its own, or the floor; 1 N if none."""
    own = max(scale, LOAD_FLOOR * heaviest)
    return own if own > 0.0 else 1.0


@filling
def worst_ball(p: Array, case: int, errors: Array, heaviest: float, worst: float) -> float:
    """The greatest residual of a ball, each on the scale of its own loads, or what is worse.

    errors (balls, 2): size of each ball's residual and scale of its own loads.
    """
    length, stiffness = p[layout.OUTER_LENGTH, case], p[layout.SERIES_STIFFNESS, case]
    for j in range(errors.shape[0]):
        error, scale = errors[j, 0], errors[j, 1]
        own = own_scale(scale, heaviest)
        # what rounding leaves of it is mostly nothing
        if not error / own <= worst and not is_rounding(length, stiffness, error, scale):
            error = max_with_nan(0.0, error - rounding(p, case, scale))
            worst = max_with_nan(worst, error / own)
    return worst


@filling
def _turned_away(p: Array, case: int, c: float, s: float) -> int:
    """The degree of freedom that has taken a groove's centre past the foot of its shoulder.

    With an axial load toward the shoulder it is a tilt, if the ring is free to tilt.
    """
    tilt_y = p[layout.FREE + 3, case] * abs(c)
    tilt_z = p[layout.FREE + 4, case] * abs(s)
    pulled = p[layout.FREE, case] > 0.0 and p[layout.APPLIED, case] <= 0.0
    if pulled or max(tilt_y, tilt_z) == 0.0:
        return 0
    return 3 if tilt_y >= tilt_z else 4
