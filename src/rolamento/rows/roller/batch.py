"""Many cases of a row of rollers: held at a place of the ring, or with the ring let go."""

from __future__ import annotations

from math import sqrt
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import inline_exact, kernel, shared
from rolamento.numerics.dense import solve_dense
from rolamento.rows.roller import layout
from rolamento.rows.roller.roller import (
    EXPONENT,
    OVERSHOOT,
    PRECISION,
    SHORTENINGS,
    SUMS,
    Line,
    added,
    condensed,
    floor,
    relax,
)

RING_STEPS: Final = 60
RING_PRECISION: Final = 1e-11
FIRST_PRECISION: Final = 1e-3
"""Residual of the rollers, over their loads, where a ring that is let go begins."""
LOOSER: Final = 1e-3
"""Than the square of what is left unbalanced of the ring, over its loads."""
FAR: Final = 0.3
"""Fraction of the roller's diameter: the longest step of the ring."""
DEGREES: Final = 5

Output = tuple[NDArray[Any], ...]


@shared
def ring_forces(
    p: Array,
    column: int,
    line: Line,
    cosines: Array,
    sines: Array,
    u: Array,
    rollers: tuple[Array, Array, Array],
    force: Array,
    stiffness: Array,
    near: bool,
    precision: float,
) -> tuple[int, float, float, int]:
    """Balance every roller, the ring held at u (x, y, z, ry, rz), and sum up what they answer.

    rollers: η and ω (Z, 2), loads per length (Z, 2, n), where the ring was for them (5,); force:
    (5,), stiffness: (5, 5); all written.
    near, precision: whether the rollers begin where they are, and how well they are balanced.
    Returns a number of `rolamento.status`, the worst residual of a roller, the greatest load and
    the steps.
    """
    states, loads, was = rollers
    sums = np.empty((2, SUMS))
    ring, before, own, tangent = np.empty(3), np.empty(3), np.empty(3), np.empty((3, 3))
    force[:] = 0.0
    stiffness[:] = 0.0
    worst, scale, steps = 0.0, 0.0, 0
    number = status.CONVERGED
    arm = p[layout.ARM, column]
    limit = heaviest(p, column)
    slice_limit = limit * p[layout.LENGTH, column] / loads.shape[2]
    c0, s0 = p[layout.COS_FIRST, column], p[layout.SIN_FIRST, column]
    for j in range(cosines.size):
        c = cosines[j] * c0 - sines[j] * s0
        s = sines[j] * c0 + cosines[j] * s0
        _at_roller(arm, c, s, u, ring)
        _at_roller(arm, c, s, was, before)
        found, residual, size, taken = relax(
            p, column, line, ring, states[j], (sums, loads[j]), before, near, precision
        )
        steps += taken
        worst = residual if not residual <= worst else worst
        scale = max(scale, size)
        if not found:
            number = status.NOT_CONVERGED
        # no slice carries more than the whole roller
        elif size > slice_limit and loads[j].max() > limit and number == status.CONVERGED:
            number = status.OVERLOADED
        condensed(p, column, ring, states[j, 1], sums, own, tangent)
        _add_roller(arm, c, s, own, tangent, force, stiffness)
    was[:] = u
    return number, worst, scale, steps


@inline_exact
def _at_roller(arm: float, c: float, s: float, u: Array, ring: Array) -> None:
    """Write A, b, θ of a ring at u where a roller is, (3,)."""
    ring[2] = c * u[3] - s * u[4]
    ring[0] = u[0] + arm * ring[2]
    ring[1] = s * u[1] + c * u[2]


@inline_exact
def _add_roller(
    arm: float, c: float, s: float, own: Array, tangent: Array, force: Array, stiffness: Array
) -> None:
    """Add a roller's force (3,) and stiffness (3, 3) to the ring's.

    With dA = dx + R dθ, db = s dy + c dz and dθ = c dry - s drz.
    """
    turned = arm * own[0] + own[2]
    force[0] += own[0]
    force[1] += s * own[1]
    force[2] += c * own[1]
    force[3] += c * turned
    force[4] -= s * turned
    for row in range(3):
        # by x, by b, by θ
        if row < 2:
            by_x, by_b, by_turn = tangent[row, 0], tangent[row, 1], tangent[row, 2]
        else:
            by_x = arm * tangent[0, 0] + tangent[2, 0]
            by_b = arm * tangent[0, 1] + tangent[2, 1]
            by_turn = arm * tangent[0, 2] + tangent[2, 2]
        by_turn += arm * by_x
        line = (by_x, s * by_b, c * by_b, c * by_turn, -s * by_turn)
        for k in range(DEGREES):
            if row == 0:
                stiffness[0, k] += line[k]
            elif row == 1:
                stiffness[1, k] += s * line[k]
                stiffness[2, k] += c * line[k]
            else:
                stiffness[3, k] += c * line[k]
                stiffness[4, k] -= s * line[k]


@inline_exact
def heaviest(p: Array, column: int) -> float:
    """Load per length beyond which is no elastic contact (N/m)."""
    greatest = max(p[layout.INNER_CONSTANT, column], p[layout.OUTER_CONSTANT, column])
    depth = status.GREATEST_APPROACH * p[layout.DIAMETER, column]
    return float(greatest / p[layout.LENGTH, column] * depth**EXPONENT)


@inline_exact
def line_of(lines: Line, case: int) -> Line:
    """The contacts of one case."""
    coupled, place, drops, curvature, body, table, work = lines
    own = case if place.shape[0] > 1 else 0
    shape = case if drops.shape[0] > 1 else 0
    bent = case if curvature.shape[0] > 1 else 0
    deep = case if body.shape[0] > 1 else 0
    return coupled, place[own], drops[shape], curvature[bent], body[deep], table, work


@kernel
def hold_cases(
    p: Array,
    lines: Line,
    cosines: Array,
    sines: Array,
    begin: Array,
    first: int,
    last: int,
    out: Output,
) -> None:
    """Hold the cases first..last-1 where p has their rings imposed.

    p: (layout.COLUMN, cases); lines: as `Line`, but for the table and the scratch with (cases or 1)
    in front. begin: the ring's places (cases, 5) at which the rollers are in the state that out
    has of them, NaN where they begin anew. out: state (cases, Z, 2), loads per length (cases or 1,
    Z, 2, n), force (cases, 5), stiffness (cases, 5, 5), scale, residual, number and steps (cases).
    """
    state, loads, force, stiffness, scale, residual, number, steps = out
    u, was = np.empty(DEGREES), np.empty(DEGREES)
    for case in range(first, last):
        line = line_of(lines, case)
        kept = loads[case if loads.shape[0] > 1 else 0]
        for i in range(DEGREES):
            u[i], was[i] = p[layout.IMPOSED + i, case], begin[case, i]
        near = abs(was[0]) < np.inf
        for look in range(3):
            number[case], residual[case], scale[case], steps[case] = ring_forces(
                p, case, line, cosines, sines, u, (state[case], kept, was),
                force[case], stiffness[case], near, PRECISION,
            )  # fmt: skip
            if not near:
                break
            if number[case] == status.NOT_CONVERGED:
                near = False
            elif look > 0 or not line[0]:
                break  # slices that are coupled know their derivatives only from loads nearby
        worst = scale[case]
        for i in range(DEGREES):
            arm = p[layout.ARM, case] if i > 2 else 1.0
            worst = max(worst, abs(force[case, i]) / arm)
        scale[case] = worst


@shared
def _start(p: Array, case: int, rollers: int, u: Array) -> None:
    """Write a first place: as held, or so that the heaviest roller carries too much."""
    constant = p[layout.INNER_CONSTANT, case] ** -0.9 + p[layout.OUTER_CONSTANT, case] ** -0.9
    constant = constant ** (-1.0 / 0.9) * rollers
    sine, cosine = p[layout.OUTER_SINE, case], p[layout.OUTER_COSINE, case]
    fx, fy, fz = p[layout.APPLIED, case], p[layout.APPLIED + 1, case], p[layout.APPLIED + 2, case]
    radial = sqrt(fy * fy + fz * fz)
    away = (4.5 * radial / (constant * cosine)) ** 0.9 + 2.0 * p[layout.GAP, case]
    into = 0.0
    if sine > 1e-6 and fx > 0.0:
        needed = max(fx / sine, 2.0 * radial / cosine)
        into = (needed / constant) ** 0.9 / sine
        away = (radial / (constant * cosine)) ** 0.9
    for i in range(DEGREES):
        u[i] = p[layout.IMPOSED + i, case]
    if p[layout.FREE, case] > 0.0:
        u[0] = into
    for i, part in ((1, fy), (2, fz)):
        if p[layout.FREE + i, case] > 0.0:
            u[i] = away * part / radial if radial > 0.0 else 0.0


@kernel
def settle_cases(
    p: Array,
    lines: Line,
    cosines: Array,
    sines: Array,
    first: int,
    last: int,
    rings: Array,
    states: Array,
    settled: NDArray[np.bool_],
    steps: NDArray[np.int64],
) -> None:
    """Let the rings of the cases go until the loads balance: a proposal, to be judged as any.

    As `hold_cases`; rings: places (cases, 5), states: of the rollers there (cases, Z, 2), settled:
    whether, and steps: in how many, (cases,) each, all written.
    """
    z = cosines.size
    loads = np.zeros((z, 2, lines[1].shape[1]))
    was, force = np.zeros(DEGREES), np.empty(DEGREES)
    stiffness, matrix = np.empty((DEGREES, DEGREES)), np.empty((DEGREES, DEGREES))
    rest, step, arms = np.empty(DEGREES), np.empty(DEGREES), np.empty(DEGREES)
    old = np.empty(DEGREES)
    for case in range(first, last):
        line = line_of(lines, case)
        loads[:] = 0.0
        u, rollers = rings[case], (states[case], loads, was)
        for i in range(DEGREES):
            arms[i] = p[layout.ARM, case] if i > 2 else 1.0
        _start(p, case, z, u)
        least, extra = floor(p, case), added(p, case)
        longest = FAR * p[layout.DIAMETER, case]
        precision = FIRST_PRECISION
        number, _, scale, _ = ring_forces(
            p, case, line, cosines, sines, u, rollers, force, stiffness, False, precision
        )
        settled[case], steps[case] = False, 0
        for _ in range(RING_STEPS):
            size = max(scale, least)
            worst = 0.0
            for i in range(DEGREES):
                free = p[layout.FREE + i, case] > 0.0
                rest[i] = (p[layout.APPLIED + i, case] - force[i]) / arms[i] if free else 0.0
                worst = max(worst, abs(rest[i]))
                size = max(size, abs(p[layout.APPLIED + i, case]) / arms[i])
            if worst <= RING_PRECISION * size and precision <= RING_PRECISION:
                settled[case] = True
                break
            if not worst < np.inf or number == status.NOT_CONVERGED:
                break
            for i in range(DEGREES):
                step[i] = rest[i]
                for k in range(DEGREES):
                    both = p[layout.FREE + i, case] > 0.0 and p[layout.FREE + k, case] > 0.0
                    matrix[i, k] = stiffness[i, k] / (arms[i] * arms[k]) if both else 0.0
                matrix[i, i] += extra
            if not solve_dense(matrix, step):
                break
            slope, length = 0.0, 0.0
            for i in range(DEGREES):
                slope += step[i] * rest[i]
                length = max(length, abs(step[i]))
                old[i] = u[i]
            if not (slope > 0.0 and length < np.inf):
                break
            part = min(1.0, longest / length)
            steps[case] += 1
            # as well as the next step deserves, whose error is the square of this one's
            precision = min(FIRST_PRECISION, max(LOOSER * (worst / size) ** 2, PRECISION))
            for _ in range(SHORTENINGS):
                for i in range(DEGREES):
                    u[i] = old[i] + part * step[i] / arms[i]
                number, _, scale, _ = ring_forces(
                    p, case, line, cosines, sines, u, rollers, force, stiffness, True, precision
                )
                ahead = 0.0
                for i in range(DEGREES):
                    if p[layout.FREE + i, case] > 0.0:
                        ahead += step[i] * (p[layout.APPLIED + i, case] - force[i]) / arms[i]
                if ahead >= -OVERSHOOT * slope:
                    break
                part *= min(max(slope / (slope - ahead), 0.1), 0.6)
