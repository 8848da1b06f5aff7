"""Whether a proposed equilibrium may be shown: every residual, every contact, in exact arithmetic.

Residuals alone do not prove a solution: a ball can balance where it can never be (Harris's
equations have such roots, with alpha_o < 0 at an unloaded ball).
"""
# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

from math import sqrt
from typing import Final

from rolamento.equilibrium import rows
from rolamento.equilibrium.settle import in_place
from rolamento.equilibrium.single import (
    LOAD_FLOOR,
    add_to_ring,
    contacts,
    direction,
    groove,
    linearised,
    moves,
    static_ball,
)
from rolamento.numerics.compiled import shared

CONVERGED: Final = 0
NO_EQUILIBRIUM: Final = 1
NOT_CONVERGED: Final = 2
OVERLOADED: Final = 3
INVALID_INPUT: Final = 4

TOLERANCE: Final = 1e-9  # of ring and balls; what is promised is 1e-8
GREATEST_APPROACH: Final = 0.02  # of the ball diameter: far beyond any elastic contact
LOST_ANGLE: Final = 1e-9  # rad, below which a one-sided bearing has left its shoulder


@shared
def judge(p, case, control, cosines, sines, u, x, reaction, matrix):
    """Measure a proposal: (code, residual, unsupported degree of freedom or -1).

    The residual is the greatest of the ring's (over the greatest load on it or in it) and the
    balls' (each over its own greatest load, or a millionth of the heaviest ball's). Fills
    reaction (5) and matrix (5, 5), the derivative of the reaction with every ball following;
    places the balls of a bearing without inertia.
    """
    reaction[:] = 0.0
    matrix[:] = 0.0
    moving = moves(p, case)
    heaviest = 0.0
    placed = True
    lost = -1
    deepest = 0.0
    one_sided = p[rows.ONE_SIDED, case] > 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        if moving:
            _, _, force, stiffness, scale = linearised(
                p, case, control[j], a1, a2, x[j, 0], x[j, 1]
            )
        else:
            x[j, 0], x[j, 1], force, stiffness, scale = static_ball(p, case, a1, a2)
        if scale > 0.0 or scale != scale:
            add_to_ring(reaction, matrix, c, s, force, stiffness)
        heaviest = max(heaviest, scale)
        s_i, _, length_i, q_i, _, _, length_o, _, _, _ = contacts(
            p, case, control[j], a1, a2, x[j, 0], x[j, 1]
        )
        deepest = max(deepest, length_o - p[rows.OUTER_LENGTH, case])
        if q_i > 0.0:
            deepest = max(deepest, length_i - p[rows.INNER_LENGTH, case])
            placed = placed and (not moving or in_place(p, case, a1, x[j, 0], x[j, 1]))
            if one_sided and s_i <= LOST_ANGLE:
                lost = _turned_away(p, case, a1, c, s)

    scale = heaviest
    error = 0.0
    for i in range(5):
        if p[rows.FREE + i, case] > 0.0:
            applied = p[rows.APPLIED + i, case]
            scale = max(scale, abs(applied))
            miss = abs(applied - reaction[i])
            error = miss if not miss <= error else error
    residual = error / scale if scale > 0.0 else 0.0
    if moving:
        worst = _worst_ball(p, case, control, cosines, sines, u, x, heaviest)
        residual = worst if not worst <= residual else residual

    if not residual <= TOLERANCE or not placed:
        return NOT_CONVERGED, residual, -1
    if lost >= 0:
        return NO_EQUILIBRIUM, residual, lost
    if deepest > GREATEST_APPROACH * p[rows.BALL_DIAMETER, case]:
        return OVERLOADED, residual, -1
    return CONVERGED, residual, -1


@shared
def _turned_away(p, case, a1, c, s):
    """The degree of freedom that has taken a groove's centre past the foot of its shoulder."""
    if p[rows.FREE, case] > 0.0:
        return 0
    tilts = (p[rows.FREE + 3, case] * abs(c), p[rows.FREE + 4, case] * abs(s))
    if max(tilts[0], tilts[1]) == 0.0:
        return 0
    return 3 if tilts[0] >= tilts[1] else 4


@shared
def _worst_ball(p, case, control, cosines, sines, u, x, heaviest):
    """The greatest residual of a moving ball, each on the scale of its own loads."""
    worst = 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        residual, _, _, _, scale = linearised(p, case, control[j], a1, a2, x[j, 0], x[j, 1])
        own = max(scale, LOAD_FLOOR * heaviest)
        error = sqrt(residual[0] ** 2 + residual[1] ** 2)
        if own > 0.0:
            error /= own
        worst = error if not error <= worst else worst
    return worst
