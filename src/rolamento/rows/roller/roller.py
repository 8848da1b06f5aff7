"""One roller in balance between the rings, in its own plane.

    δ_k = u + w x_k - P_k,      Q_k = (K/n) max(δ_k, 0)^(10/9)

along each contact, with u and w linear in where ring and roller are. Held, the roller has the
energy of its springs less the work of its inertia: convex in η and ω, so that a guarded Newton's
method comes down to its only least value. Slices by ISO/TS 16281:2008, 5.3; docs/theory/rollers.md.
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from rolamento.contact.coupled import coupled_slices
from rolamento.contact.slices import independent_slices
from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import inline_exact, shared
from rolamento.rows.roller import layout

EXPONENT: Final = 10.0 / 9.0
ROOT: Final = 1.0 / 9.0
STEPS: Final = 80
SHORTENINGS: Final = 25
OVERSHOOT: Final = 0.5
PRECISION: Final = 1e-12
NEGLIGIBLE: Final = 1e-7
"""Of the roller's diameter: an approach whose load is none, beside which rollers are in balance."""
GREATEST_APPROACH: Final = 0.02
"""Of the roller's diameter: beyond is no elastic contact."""
ADDED: Final = 1e-9
"""Over the stiffness of a contact: added to a roller's own, so that what nothing holds stays."""
LONGEST: Final = 0.05
"""Of the roller's diameter: a step of Newton's method."""

INNER, OUTER = 0, 1
SUMS: Final = 6
"""Of a contact: Q, M, and their derivatives by u, w, u, w; as `rolamento.contact.slices`."""

Line: TypeAlias = tuple[bool, Array, Array, Array, Array, Array, Array]
"""A case's contacts along the roller: whether slices are coupled; x_k (n,); of the inner and the
outer contact, (2, n) each, drops of roller and race, curvatures, and the compression of the roller
itself; the influence table and scratch of `rolamento.contact.coupled`."""
Pressed: TypeAlias = tuple[Array, Array]
"""Of both contacts: sums (2, SUMS), and loads per length (2, n)."""
Forces: TypeAlias = tuple[float, float, float, float, float, float]
"""Unbalanced force on η and ω, their derivatives ηη, ηω, ωω, and the size of what makes them up."""


@inline_exact
def rib(p: Array, column: int, apart: float) -> tuple[float, float]:
    """Force between the ribs of both rings through a roller, toward +x, and its derivative.

    apart: how far the inner ring's ribs have come toward the outer's, over the roller.
    """
    ahead, behind = apart - p[layout.RIB_PLAY, column], -apart - p[layout.RIB_PLAY, column]
    if ahead > 0.0:
        stiffness = p[layout.RIB_AHEAD, column]
        return stiffness * ahead, stiffness
    if behind > 0.0:
        stiffness = p[layout.RIB_BEHIND, column]
        return -stiffness * behind, stiffness
    return 0.0, 0.0


@shared
def press(
    p: Array, column: int, line: Line, ring: Array, shift: float, turn: float, found: Pressed
) -> Forces:
    """Press both contacts of a roller, which is over the inner ring at η and ω.

    ring: A, b, θ of the inner ring at the roller's centre; found: sums and loads, written.
    """
    sums, loads = found
    u, w = inner_line(p, column, shift, turn)
    press_contact(p, column, line, INNER, u, w, sums[INNER], loads[INNER])
    u, w = outer_line(p, column, ring, shift, turn)
    press_contact(p, column, line, OUTER, u, w, sums[OUTER], loads[OUTER])
    return balance(p, column, ring, turn, sums)


@shared
def press_contact(
    p: Array, column: int, line: Line, race: int, u: float, w: float, sums: Array, load: Array
) -> None:
    """Press one contact by the law of the case: independent slices or coupled ones."""
    coupled, place, drops, curvature, body, table, work = line
    width = p[layout.LENGTH, column] / place.size
    if coupled:
        coupled_slices(
            u, w, place, drops[race], width, p[layout.COMPLIANCE, column], curvature[race], table,
            body[race], load, work, sums,
        )  # fmt: skip
    else:
        constant = p[layout.INNER_CONSTANT + race, column] / p[layout.LENGTH, column]
        independent_slices(u, w, place, drops[race], width, constant, load, sums)


@inline_exact
def inner_line(p: Array, column: int, shift: float, turn: float) -> tuple[float, float]:
    """Approach of the inner contact's middle, and its slope."""
    u = p[layout.INNER_SHIFT, column] * shift + p[layout.INNER_TURN, column] * turn
    return u - p[layout.GAP, column], turn


@inline_exact
def outer_line(
    p: Array, column: int, ring: Array, shift: float, turn: float
) -> tuple[float, float]:
    """Approach of the outer contact's middle, and its slope."""
    u = p[layout.OUTER_SINE, column] * ring[0] + p[layout.OUTER_COSINE, column] * ring[1]
    u += p[layout.LEVER, column] * ring[2]
    u += p[layout.OUTER_SHIFT, column] * shift + p[layout.OUTER_TURN, column] * turn
    return u - p[layout.GAP, column], -(ring[2] + turn)


@inline_exact
def balance(p: Array, column: int, ring: Array, turn: float, sums: Array) -> Forces:
    """Sum up what acts on a roller."""
    ai, bi = p[layout.INNER_SHIFT, column], p[layout.INNER_TURN, column]
    ao, bo = p[layout.OUTER_SHIFT, column], p[layout.OUTER_TURN, column]
    qi, mi, ti, ci, di = sums[0, 0], sums[0, 1], sums[0, 2], sums[0, 3], sums[0, 5]
    qo, mo, to, co, do = sums[1, 0], sums[1, 1], sums[1, 2], sums[1, 3], sums[1, 5]
    force = p[layout.CENTRIFUGAL, column]
    lever = p[layout.RIB_LEVER, column]
    pushed, stiffness = rib(p, column, ring[0] + lever * (ring[2] + 2.0 * turn))
    g0 = ai * qi + ao * qo - force * p[layout.CENTRIFUGAL_SHIFT, column]
    g1 = bi * qi + mi + bo * qo - mo - force * p[layout.CENTRIFUGAL_TURN, column]
    g1 += 2.0 * lever * pushed - p[layout.GYROSCOPIC, column]
    h00 = ai * ai * ti + ao * ao * to
    h01 = ai * (bi * ti + ci) + ao * (bo * to - co)
    h11 = bi * bi * ti + 2.0 * bi * ci + di + bo * bo * to - 2.0 * bo * co + do
    h11 += 4.0 * lever * lever * stiffness
    scale = max(max(qi, qo), max(force, abs(pushed)))
    return g0, g1, h00, h01, h11, scale


@inline_exact
def middle(p: Array, column: int, ring: Array) -> tuple[float, float]:
    """Where both contacts of a roller have the same approach, all along."""
    turn = -0.5 * ring[2]
    outer, _ = outer_line(p, column, ring, 0.0, turn)
    inner, _ = inner_line(p, column, 0.0, turn)
    across = p[layout.OUTER_SHIFT, column] - p[layout.INNER_SHIFT, column]
    return (inner - outer) / across, turn


@inline_exact
def floor(p: Array, column: int) -> float:
    """A load that counts as none (N)."""
    greatest = max(p[layout.INNER_CONSTANT, column], p[layout.OUTER_CONSTANT, column])
    return float(greatest * (NEGLIGIBLE * p[layout.DIAMETER, column]) ** EXPONENT)


@inline_exact
def added(p: Array, column: int) -> float:
    """A stiffness that is small against any real one (N/m)."""
    greatest = max(p[layout.INNER_CONSTANT, column], p[layout.OUTER_CONSTANT, column])
    return float(ADDED * greatest * (1e-4 * p[layout.DIAMETER, column]) ** ROOT)


@shared
def thrown_out(p: Array, column: int, ring: Array, drops: Array) -> tuple[float, float]:
    """Where the centrifugal force presses a roller alone: into the outer race, along its line."""
    least = np.inf
    for k in range(drops.shape[1]):
        least = min(least, drops[OUTER, k])
    turn = -ring[2]
    load = p[layout.CENTRIFUGAL, column] * p[layout.CENTRIFUGAL_SHIFT, column]
    load /= p[layout.OUTER_SHIFT, column]
    depth = least + (load / p[layout.OUTER_CONSTANT, column]) ** (1.0 / EXPONENT)
    without, _ = outer_line(p, column, ring, 0.0, turn)
    return (depth - without) / p[layout.OUTER_SHIFT, column], turn


@shared
def relax(
    p: Array, column: int, line: Line, ring: Array, state: Array, found: Pressed
) -> tuple[bool, float, float, int]:
    """Find the balance of a roller.

    state: η, ω, written; found: sums and loads, written. Returns whether it is in balance, the
    unbalanced load over the scale of the loads, that scale, and Newton steps.
    """
    sums = found[0]
    half = 0.5 * p[layout.LENGTH, column]
    least, extra = floor(p, column), added(p, column)
    longest = LONGEST * p[layout.DIAMETER, column]
    shift, turn = middle(p, column, ring)
    g0, g1, h00, h01, h11, scale = press(p, column, line, ring, shift, turn, found)
    if sums[0, 0] + sums[1, 0] == 0.0 and p[layout.CENTRIFUGAL, column] > 0.0:
        shift, turn = thrown_out(p, column, ring, line[2])
        g0, g1, h00, h01, h11, scale = press(p, column, line, ring, shift, turn, found)
    steps = 0
    while True:
        size = max(scale, least)
        residual = max(abs(g0), abs(g1) / half) / size
        if not residual > PRECISION or steps >= STEPS:
            break
        a, d = h00 + extra, h11 / (half * half) + extra
        b = h01 / half
        determinant = a * d - b * b
        s0 = -(d * g0 - b * g1 / half) / determinant
        s1 = -(a * g1 / half - b * g0) / determinant
        slope = -(g0 * s0 + g1 * s1 / half)
        length = max(abs(s0), abs(s1))
        if not (slope > 0.0 and length < np.inf):
            break
        steps += 1
        part = min(1.0, longest / length)
        old_shift, old_turn, old = shift, turn, residual
        for _ in range(SHORTENINGS):
            shift, turn = old_shift + part * s0, old_turn + part * s1 / half
            g0, g1, h00, h01, h11, scale = press(p, column, line, ring, shift, turn, found)
            ahead = -(g0 * s0 + g1 * s1 / half)
            if ahead >= -OVERSHOOT * slope:
                break
            part *= min(max(slope / (slope - ahead), 0.1), 0.6)
        if shift == old_shift and turn == old_turn and old <= 100.0 * PRECISION:
            break  # no step betters its rounding
    state[0], state[1] = shift, turn
    size = max(scale, least)
    residual = max(abs(g0), abs(g1) / half) / size
    return residual <= 100.0 * PRECISION, residual, size, steps


@shared
def condensed(
    p: Array,
    column: int,
    ring: Array,
    turn: float,
    sums: Array,
    force: Array,
    stiffness: Array,
) -> None:
    """What a roller in balance answers to the inner ring at its centre: force (3,), (3, 3).

    The roller's own place follows: K = K_rr - K_rq K_qq⁻¹ K_qr.
    """
    _, _, h00, h01, h11, _ = balance(p, column, ring, turn, sums)
    sine, cosine = p[layout.OUTER_SINE, column], p[layout.OUTER_COSINE, column]
    lever, reach = p[layout.LEVER, column], p[layout.RIB_LEVER, column]
    ao, bo = p[layout.OUTER_SHIFT, column], p[layout.OUTER_TURN, column]
    q, m, t, c, d = sums[1, 0], sums[1, 1], sums[1, 2], sums[1, 3], sums[1, 5]
    pushed, rate = rib(p, column, ring[0] + reach * (ring[2] + 2.0 * turn))
    force[0] = sine * q + pushed
    force[1] = cosine * q - p[layout.CENTRIFUGAL, column]
    force[2] = lever * q - m + reach * pushed - p[layout.GYROSCOPIC, column]
    turned = lever * t - c  # of the approach by the ring's tilt, weighted
    stiffness[0, 0] = sine * sine * t + rate
    stiffness[0, 1] = sine * cosine * t
    stiffness[0, 2] = sine * turned + rate * reach
    stiffness[1, 1] = cosine * cosine * t
    stiffness[1, 2] = cosine * turned
    stiffness[2, 2] = lever * lever * t - 2.0 * lever * c + d + rate * reach * reach
    r0, r1 = sine * ao * t, sine * (bo * t - c) + 2.0 * rate * reach
    s0, s1 = cosine * ao * t, cosine * (bo * t - c)
    u0, u1 = ao * turned, lever * (bo * t - c) - bo * c + d + 2.0 * rate * reach * reach
    half = 0.5 * p[layout.LENGTH, column]
    extra = added(p, column)
    a, e, b = h00 + extra, h11 + extra * half * half, h01
    determinant = a * e - b * b
    r, s, u = (r0, r1), (s0, s1), (u0, u1)
    stiffness[0, 0] -= (e * r[0] * r[0] - 2.0 * b * r[0] * r[1] + a * r[1] * r[1]) / determinant
    stiffness[1, 1] -= (e * s[0] * s[0] - 2.0 * b * s[0] * s[1] + a * s[1] * s[1]) / determinant
    stiffness[2, 2] -= (e * u[0] * u[0] - 2.0 * b * u[0] * u[1] + a * u[1] * u[1]) / determinant
    stiffness[0, 1] -= (
        e * r[0] * s[0] - b * (r[0] * s[1] + r[1] * s[0]) + a * r[1] * s[1]
    ) / determinant
    stiffness[0, 2] -= (
        e * r[0] * u[0] - b * (r[0] * u[1] + r[1] * u[0]) + a * r[1] * u[1]
    ) / determinant
    stiffness[1, 2] -= (
        e * s[0] * u[0] - b * (s[0] * u[1] + s[1] * u[0]) + a * s[1] * u[1]
    ) / determinant
    stiffness[1, 0], stiffness[2, 0] = stiffness[0, 1], stiffness[0, 2]
    stiffness[2, 1] = stiffness[1, 2]
