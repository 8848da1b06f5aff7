"""Balls on one or two flanks, one at a time: the kernels of `rolamento.rows.ball.arc.grooves`.

A case is a column of `COLUMN` numbers, SI. A ball's place (x, r) is counted from the middle of the
outer ring's groove centres, that of the inner ring's groove stands at a centre (x, r) from there.
"""

from __future__ import annotations

from math import sqrt
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import inline_exact, kernel, shared
from rolamento.numerics.dense import solve_dense
from rolamento.numerics.newton import (
    LEAST_DAMPING,
    LEAST_HELP,
    MOST_DAMPING,
    MUCH_SHORTER,
    OVERSHOOT,
    SHORTENINGS,
    STEPS,
)
from rolamento.status import (
    CONVERGED,
    GREATEST_APPROACH,
    NOT_CONVERGED,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
)

TERMS: Final = 14
"""Chebyshev terms in cos α, from -1 to 1, that give K to 1e-13 of its value up to D/d_m = 0.3,
to 2e-10 up to 0.5."""
PRECISION: Final = 1e-11
RING_PRECISION: Final = 1e-11
RING_STEPS: Final = 60
ROUNDING: Final = 1e-13
"""Fraction of an arc's length L: a lesser approach is no contact."""
POSITION_ROUNDING: Final = 4.0 * float(np.finfo(np.float64).eps)
"""Fraction of an arc's length L: how exactly a ball has a place beside it."""
EDGE: Final = 1e-9
"""Cosine: a contact at the very end of a half circle is past it."""
FAR: Final = 0.3
"""Fraction of the groove centres' distance: the longest step."""
DEGREES: Final = 5

# --- a case; of each race: L, the shift of its arcs, the cosine of its edge, K and dK/d cos α -----
INNER: Final = 0
LENGTH: Final = 0
SHIFT: Final = 1
RACE_EDGE: Final = 2
STIFFNESS: Final = 3
SLOPE: Final = STIFFNESS + TERMS
OUTER: Final = SLOPE + TERMS - 1
RADIAL_OFFSET: Final = 2 * OUTER
ARM: Final = RADIAL_OFFSET + 1
DIAMETER: Final = ARM + 1
TOWARD: Final = DIAMETER + 1  # the flank's own side, from the arc's centre: x, r
BOTTOM: Final = TOWARD + 2  # the arc's deepest point: x, r
FORCE: Final = BOTTOM + 2  # F_c
COS_FIRST: Final = FORCE + 1  # azimuth of the first ball
SIN_FIRST: Final = COS_FIRST + 1
FLOOR: Final = SIN_FIRST + 1  # a load that counts as none
BOTH: Final = FLOOR + 1  # K of both contacts in line
COLUMN: Final = BOTH + 1

Output = tuple[NDArray[Any], ...]
Contact = tuple[float, float, float, float, float, float, float, float]
"""Load, normal (x, r), approach, and the force's derivative by the place, by rows."""


@inline_exact
def _contact(p: Array, case: int, race: int, flank: float, y1: float, y2: float) -> Contact:
    """What an arc answers to a ball at (y1, y2) from its centre, on the flank's own side."""
    length = p[race + LENGTH, case]
    distance = max(sqrt(y1 * y1 + y2 * y2), 1e-30)
    s, c = y1 / distance, y2 / distance
    approach = distance - length
    on_it = s * p[TOWARD, case] * flank + c * p[TOWARD + 1, case] > 0.0
    if not (on_it and approach > ROUNDING * length):
        nothing = 0.0 * approach  # NaN stays NaN
        return nothing, s, c, approach, nothing, nothing, nothing, nothing
    # T_k = 2 c T_k-1 - T_k-2
    before, now = 1.0, c
    first, slopes = race + STIFFNESS, race + SLOPE
    value = p[first, case] + p[first + 1, case] * c
    slope = p[slopes, case] + p[slopes + 1, case] * c
    for term in range(2, TERMS):
        before, now = now, 2.0 * c * now - before
        value += p[first + term, case] * now
        if term < TERMS - 1:
            slope += p[slopes + term, case] * now
    root = sqrt(approach)
    load = value * approach * root
    stiff, turn = 1.5 * value * root, slope * approach * root / distance * s
    # along the normal (s, c): dQ/d(x, r); across it the load turns with the ball
    rise1, rise2 = stiff * s - turn * c, stiff * c + turn * s
    across = load / distance
    return (
        load, s, c, approach,
        s * rise1 + across * (1.0 - s * s), s * rise2 - across * s * c,
        c * rise1 - across * s * c, c * rise2 + across * (1.0 - c * c),
    )  # fmt: skip


@inline_exact
def _flank(
    p: Array, case: int, flank: float, a1: float, a2: float, x1: float, x2: float
) -> tuple[Contact, Contact]:
    """The inner and the outer contact of a flank on a ball at (x1, x2), the groove at (a1, a2)."""
    inner = _contact(p, case, INNER, flank, a1 - x1 + flank * p[INNER + SHIFT, case], a2 - x2)
    outer = _contact(p, case, OUTER, flank, x1 + flank * p[OUTER + SHIFT, case], x2)
    return inner, outer


@shared
def _on_ball(
    p: Array, case: int, flanks: Array, a1: float, a2: float, x1: float, x2: float, k: Array
) -> tuple[float, float, float]:
    """The force that resists a ball, and the size of its loads; k (2, 2): its derivative."""
    f1, f2, scale = 0.0, 0.0, max(p[FLOOR, case], p[FORCE, case])
    k[:] = 0.0
    for flank in flanks:
        inner, outer = _flank(p, case, flank, a1, a2, x1, x2)
        f1 += outer[0] * outer[1] - inner[0] * inner[1]
        f2 += outer[0] * outer[2] - inner[0] * inner[2]
        k[0, 0] += inner[4] + outer[4]
        k[0, 1] += inner[5] + outer[5]
        k[1, 0] += inner[6] + outer[6]
        k[1, 1] += inner[7] + outer[7]
        scale = max(scale, inner[0], outer[0])
    # a light contact's approach is the difference of two lengths: no step betters its rounding
    rounding = POSITION_ROUNDING * max(p[INNER + LENGTH, case], p[OUTER + LENGTH, case])
    return f1, f2, max(scale, rounding * max(k[0, 0], k[1, 1]) / PRECISION)


@shared
def _settle(
    p: Array, case: int, flanks: Array, a1: float, a2: float, x: Array, k: Array
) -> tuple[float, float]:
    """Balance a ball from its place x (2,), in place: its residual and the size of its loads.

    The guarded Newton's method of `numerics.newton`, for one system. k (2, 2) is room.
    """
    target = p[FORCE, case]
    reach = p[INNER + LENGTH, case] + p[OUTER + LENGTH, case]
    longest, limit = FAR * reach, p[DIAMETER, case] + reach
    damping, residual, scale = 0.0, np.inf, 0.0
    f1, f2, scale = _on_ball(p, case, flanks, a1, a2, x[0], x[1], k)
    for step in range(STEPS):
        r1, r2 = -f1, target - f2
        error = max(abs(r1), abs(r2))
        residual = error / scale if scale > 0.0 else error
        if residual <= PRECISION or not error < np.inf or step == STEPS - 1:
            break
        if max(abs(x[0]), abs(x[1])) > limit or damping > MOST_DAMPING:
            break
        greatest = max(abs(k[0, 0]), abs(k[1, 1]), 1.5e-6 * p[BOTH, case])
        a, d = k[0, 0] / greatest + damping, k[1, 1] / greatest + damping
        b, c = k[0, 1] / greatest, k[1, 0] / greatest
        determinant = a * d - b * c
        slope, s1, s2 = -1.0, 0.0, 0.0
        if abs(determinant) > 0.0:
            s1 = (d * r1 - b * r2) / (determinant * greatest)
            s2 = (a * r2 - c * r1) / (determinant * greatest)
            slope = s1 * r1 + s2 * r2
        if not (slope > 0.0 and slope < np.inf):
            damping = max(100.0 * damping, LEAST_DAMPING)
            continue
        x1, x2 = x[0], x[1]
        whole = min(1.0, longest / sqrt(s1 * s1 + s2 * s2))
        part = taken = whole
        for _ in range(SHORTENINGS):
            taken = part
            x[0], x[1] = x1 + part * s1, x2 + part * s2
            f1, f2, scale = _on_ball(p, case, flanks, a1, a2, x[0], x[1], k)
            ahead = -s1 * f1 + s2 * (target - f2)
            if ahead >= -OVERSHOOT * slope:
                break
            part *= min(max(slope / (slope - ahead), 0.1), 0.6) if ahead < 0.0 else 0.3
        share = taken / whole
        if share < MUCH_SHORTER:
            damping = max(4.0 * damping, LEAST_HELP)
        elif share == 1.0:
            damping = 0.03 * damping if damping > LEAST_DAMPING else 0.0
    return residual, scale


@shared
def _begin(p: Array, case: int, flanks: Array, a1: float, a2: float, rest: float, x: Array) -> None:
    """Put a ball where its search begins: on the line of groove centres, or at rest outside."""
    l_i, l_o = p[INNER + LENGTH, case], p[OUTER + LENGTH, case]
    share = l_o / (l_o + l_i)
    x[0], x[1] = share * a1, share * a2
    if flanks.size == 1:  # two flanks are even about the middle
        x[0] += share * (p[INNER + SHIFT, case] + p[OUTER + SHIFT, case]) - p[OUTER + SHIFT, case]
    gripped = False
    for flank in flanks:
        inner, _ = _flank(p, case, flank, a1, a2, x[0], x[1])
        gripped = gripped or inner[0] > p[FORCE, case]
    if rest > 0.0 and not gripped:
        x[0], x[1] = 0.0, rest


@shared
def _rest(p: Array, case: int, flanks: Array, x: Array, k: Array) -> float:
    """Where F_c alone presses a ball into two outer flanks, the inner far away: its r, or 0."""
    if flanks.size < 2 or not p[FORCE, case] > 0.0:
        return 0.0
    # the inner arcs' centres near the ball's own: none touches it
    far = p[OUTER + LENGTH, case]
    x[0], x[1] = 0.0, far
    _settle(p, case, flanks, 0.0, far, x, k)
    outside: float = x[1]
    return outside


@shared
def _held(
    p: Array,
    case: int,
    flanks: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    position: Array,
    faces: Array,
    stiffness: Array,
) -> tuple[int, float, float]:
    """Balance every ball, the ring held at u (x, y, z, ry, rz), and sum up what they answer.

    position (balls, 2), faces (flanks, 5), stiffness (5, 5): written. Returns a number of
    `rolamento.status`, the worst residual of a ball, and the greatest load of an inner contact.
    """
    k, ring, lever = np.empty((2, 2)), np.empty((2, 2)), np.zeros((2, DEGREES))
    tangent, x = np.empty((2, 2)), np.empty(2)
    faces[:] = 0.0
    stiffness[:] = 0.0
    worst, heaviest = 0.0, 0.0
    deep, past = False, False
    arm, depth = p[ARM, case], GREATEST_APPROACH * p[DIAMETER, case]
    c0, s0 = p[COS_FIRST, case], p[SIN_FIRST, case]
    rest = _rest(p, case, flanks, x, k)
    for j in range(cosines.size):
        c = cosines[j] * c0 - sines[j] * s0
        s = sines[j] * c0 + cosines[j] * s0
        lever[0, 0], lever[0, 3], lever[0, 4] = 1.0, arm * c, -arm * s
        lever[1, 1], lever[1, 2] = s, c
        a1 = u[0] + arm * (c * u[3] - s * u[4])
        a2 = p[RADIAL_OFFSET, case] + s * u[1] + c * u[2]
        x = position[j]
        _begin(p, case, flanks, a1, a2, rest, x)
        residual, _ = _settle(p, case, flanks, a1, a2, x, k)
        worst = residual if not residual <= worst else worst
        ring[:] = 0.0
        k[:] = 0.0
        for f in range(flanks.size):
            inner, outer = _flank(p, case, flanks[f], a1, a2, x[0], x[1])
            heaviest = inner[0] if not inner[0] <= heaviest else heaviest
            f1, f2 = inner[0] * inner[1], inner[0] * inner[2]
            for i in range(DEGREES):
                faces[f, i] += lever[0, i] * f1 + lever[1, i] * f2
            ring[0, 0] += inner[4]
            ring[0, 1] += inner[5]
            ring[1, 0] += inner[6]
            ring[1, 1] += inner[7]
            k[0, 0] += inner[4] + outer[4]
            k[0, 1] += inner[5] + outer[5]
            k[1, 0] += inner[6] + outer[6]
            k[1, 1] += inner[7] + outer[7]
            bottom = p[BOTTOM, case] * flanks[f]
            for contact, edge in (
                (inner, p[INNER + RACE_EDGE, case]), (outer, p[OUTER + RACE_EDGE, case])
            ):  # fmt: skip
                if contact[0] > 0.0:
                    direction = contact[1] * bottom + contact[2] * p[BOTTOM + 1, case]
                    past = past or direction < edge + EDGE
                    deep = deep or contact[3] > depth
        # the ball follows the ring; where nothing holds it, it stays
        determinant = k[0, 0] * k[1, 1] - k[0, 1] * k[1, 0]
        for i in range(2):
            s1, s2 = 0.0, 0.0
            if determinant != 0.0:
                s1 = (k[1, 1] * ring[0, i] - k[0, 1] * ring[1, i]) / determinant
                s2 = (k[0, 0] * ring[1, i] - k[1, 0] * ring[0, i]) / determinant
            tangent[0, i] = ring[0, i] - ring[0, 0] * s1 - ring[0, 1] * s2
            tangent[1, i] = ring[1, i] - ring[1, 0] * s1 - ring[1, 1] * s2
        for i in range(DEGREES):
            for m in range(2):
                part = lever[0, i] * tangent[0, m] + lever[1, i] * tangent[1, m]
                for other in range(DEGREES):
                    stiffness[i, other] += part * lever[m, other]
    number = CONVERGED
    if past:
        number = OVER_SHOULDER
    if deep:
        number = OVERLOADED
    if not worst <= TOLERANCE:
        number = NOT_CONVERGED
    return number, worst, heaviest


@inline_exact
def _size(p: Array, case: int, faces: Array, heaviest: float, force: Array) -> float:
    """Sum the force up over the flanks; the size of what makes it up."""
    size: float = max(heaviest, p[FLOOR, case])
    for i in range(DEGREES):
        force[i] = 0.0
        for f in range(faces.shape[0]):
            force[i] += faces[f, i]
        size = max(size, abs(force[i]) / (p[ARM, case] if i > 2 else 1.0))
    return size


@inline_exact
def _gone(p: Array, case: int, u: Array) -> bool:
    """Whether a ring has moved by more than a ball."""
    away = max(abs(u[0]), abs(u[1]), abs(u[2]), p[ARM, case] * max(abs(u[3]), abs(u[4])))
    return bool(away > p[DIAMETER, case])


def beyond(p: Array, rings: Array) -> NDArray[np.bool_]:
    """Which of the rings (cases, 5) have moved by more than a ball; (cases,)."""
    arms = np.stack([np.ones(len(rings))] * 3 + [p[ARM]] * 2, axis=1)
    return np.asarray((np.abs(rings * arms) > p[DIAMETER][:, np.newaxis]).any(axis=1))


@kernel
def hold_cases(
    p: Array,
    flanks: Array,
    cosines: Array,
    sines: Array,
    place: Array,
    first: int,
    last: int,
    out: Output,
) -> None:
    """Hold the cases first..last-1 at their places (cases, 5).

    p: (COLUMN, cases); out: position (cases, balls, 2), forces by flank (cases, flanks, 5),
    stiffness (cases, 5, 5), scale, residual and number (cases).
    """
    position, faces, stiffness, scale, residual, number = out
    force = np.empty(DEGREES)
    for case in range(first, last):
        number[case], residual[case], heaviest = _held(
            p, case, flanks, cosines, sines, place[case], position[case], faces[case],
            stiffness[case],
        )  # fmt: skip
        scale[case] = _size(p, case, faces[case], heaviest, force)


@kernel
def settle_cases(
    p: Array,
    flanks: Array,
    cosines: Array,
    sines: Array,
    free: NDArray[np.bool_],
    load: Array,
    rings: Array,
    first: int,
    last: int,
    settled: NDArray[np.bool_],
    steps: NDArray[np.int64],
) -> None:
    """Let the rings of the cases go until the loads balance: a proposal, to be judged as any.

    free, load (cases, 5): where the load is given, and it; rings (cases, 5): where they begin,
    written; settled and steps (cases): whether each came to rest, and in how many steps.
    """
    balls = cosines.size
    position, faces = np.empty((balls, 2)), np.empty((flanks.size, DEGREES))
    stiffness, matrix = np.empty((DEGREES, DEGREES)), np.empty((DEGREES, DEGREES))
    force, rest, step = np.empty(DEGREES), np.empty(DEGREES), np.empty(DEGREES)
    arms, old = np.ones(DEGREES), np.empty(DEGREES)
    for case in range(first, last):
        u = rings[case]
        arms[3:] = p[ARM, case]
        reach = p[INNER + LENGTH, case] + p[OUTER + LENGTH, case]
        settled[case], steps[case], damping = False, 0, 0.0
        number, _, heaviest = _held(p, case, flanks, cosines, sines, u, position, faces, stiffness)
        for _ in range(RING_STEPS):
            size = _size(p, case, faces, heaviest, force)
            worst, greatest = 0.0, 1.5e-6 * p[BOTH, case]
            for i in range(DEGREES):
                rest[i] = (load[case, i] - force[i]) / arms[i] if free[case, i] else 0.0
                worst = abs(rest[i]) if not abs(rest[i]) <= worst else worst
                if free[case, i]:
                    size = max(size, abs(load[case, i]) / arms[i])
                    greatest = max(greatest, abs(stiffness[i, i]) / arms[i] ** 2)
            if worst <= RING_PRECISION * size:
                settled[case] = number != NOT_CONVERGED
                break
            if not worst < np.inf or number == NOT_CONVERGED or damping > MOST_DAMPING:
                break
            if _gone(p, case, u):
                break
            for i in range(DEGREES):
                step[i], old[i] = rest[i], u[i]
                for m in range(DEGREES):
                    both = free[case, i] and free[case, m]
                    matrix[i, m] = stiffness[i, m] / (arms[i] * arms[m]) if both else 0.0
                matrix[i, i] += damping * greatest if free[case, i] else greatest
            solvable = solve_dense(matrix, step)
            slope, square = 0.0, 0.0
            for i in range(DEGREES):
                slope += step[i] * rest[i]
                square += step[i] * step[i]
            if not (solvable and slope > 0.0 and slope < np.inf):
                damping = max(100.0 * damping, LEAST_DAMPING)
                continue
            whole = min(1.0, FAR * reach / sqrt(square))
            part = taken = whole
            steps[case] += 1
            for _ in range(SHORTENINGS):
                taken = part
                for i in range(DEGREES):
                    u[i] = old[i] + part * step[i] / arms[i]
                number, _, heaviest = _held(
                    p, case, flanks, cosines, sines, u, position, faces, stiffness
                )
                ahead = 0.0
                for i in range(DEGREES):
                    if free[case, i]:
                        own = 0.0
                        for f in range(flanks.size):
                            own += faces[f, i]
                        ahead += step[i] * (load[case, i] - own) / arms[i]
                if ahead >= -OVERSHOOT * slope:
                    break
                part *= min(max(slope / (slope - ahead), 0.1), 0.6)
            if taken / whole < MUCH_SHORTER:
                damping = max(4.0 * damping, LEAST_HELP)
            elif taken == whole:
                damping = 0.03 * damping if damping > LEAST_DAMPING else 0.0
