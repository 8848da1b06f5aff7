"""One roller in balance between the rings, in its own plane.

    δ_k = u + w x_k - P_k,      Q_k = (K/n) max(δ_k, 0)^(10/9)

along each contact, with u and w linear in where ring and roller are. Response, the roller has the
energy of its springs less the work of its inertia: convex in η and ω, so that a guarded Newton's
method comes down to its only least value. Slices by ISO/TS 16281:2008, 5.3; docs/theory/rollers.md.
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from rolamento.contact.coupled import coupled_slices
from rolamento.contact.slices import independent_slices
from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import filling, inline_exact, shared
from rolamento.numerics.newton import LEAST_DAMPING, LEAST_HELP, MUCH_SHORTER
from rolamento.rows.roller import layout

EXPONENT: Final = 10.0 / 9.0
ROOT: Final = 1.0 / 9.0
STEPS: Final = 80
SHORTENINGS: Final = 25
OVERSHOOT: Final = 0.5
PRECISION: Final = 1e-12
ACCEPTED: Final = 1e-10
"""Residual of a roller over its loads, beyond rounding, at which it counts as balanced."""
EPSILON: Final = 2.3e-16
PLACED: Final = 0.02
"""Fraction of the roller's diameter: size of the places whose differences are approaches."""
HEAVY_DEPTH: Final = 1e-4
"""Fraction of the roller's diameter: approach under its inertia where it is heaviest: as profiles
drop."""
LIGHTER: Final = 100.0
"""From one stage to the next."""
NEGLIGIBLE: Final = 1e-7
"""Fraction of the roller's diameter: an approach whose load is none, beside which rollers are in
balance."""
ADDED: Final = 1e-9
"""Over the stiffness of a contact: added to a roller's own, so that what nothing holds stays."""
LONGEST: Final = 0.05
"""Fraction of the roller's diameter: a step of Newton's method."""

INNER, OUTER = 0, 1
SUMS: Final = 6
"""Number of sums of a contact: Q, M, and their derivatives by u, w, u, w; as
`rolamento.contact.slices`."""

Line: TypeAlias = tuple[bool, Array, Array, Array, Array, Array, Array]
"""A case's contacts along the roller: whether slices are coupled; x_k (n,); of the inner and the
outer contact, (2, n) each, drops of roller and race, curvatures, and the compression of the roller
itself; the influence table and scratch of `rolamento.contact.coupled`."""
Pressed: TypeAlias = tuple[Array, Array]
"""Sums of both contacts: sums (2, SUMS), and loads per length (2, n)."""
Forces: TypeAlias = tuple[float, float, float, float, float, float, float]
"""Unbalanced force on η and ω, their derivatives ηη, ηω, ωη, ωω, and the size of their parts."""


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


@filling
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


@filling
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
    qi, mi, qi_u, qi_w, mi_u, mi_w = sums[0]
    qo, mo, qo_u, qo_w, mo_u, mo_w = sums[1]
    force = p[layout.CENTRIFUGAL, column]
    lever = p[layout.RIB_LEVER, column]
    pushed, stiffness = rib(p, column, ring[0] + lever * (ring[2] + 2.0 * turn))
    g0 = ai * qi + ao * qo - force * p[layout.CENTRIFUGAL_SHIFT, column]
    g1 = bi * qi + mi + bo * qo - mo - force * p[layout.CENTRIFUGAL_TURN, column]
    g1 += 2.0 * lever * pushed - p[layout.MOMENT, column]
    h00 = ai * ai * qi_u + ao * ao * qo_u
    h01 = ai * (bi * qi_u + qi_w) + ao * (bo * qo_u - qo_w)
    h10 = ai * (bi * qi_u + mi_u) + ao * (bo * qo_u - mo_u)
    h11 = bi * (bi * qi_u + qi_w) + bi * mi_u + mi_w
    h11 += bo * (bo * qo_u - qo_w) - bo * mo_u + mo_w + 4.0 * lever * lever * stiffness
    scale = max(max(qi, qo), max(force, abs(pushed)))
    return g0, g1, h00, h01, h10, h11, scale


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


@inline_exact
def rounding(p: Array, column: int, ring: Array, slices: int, h00: float, h11: float) -> float:
    """Unbalanced load that rounding leaves of a roller with these stiffnesses (N).

    Approaches are differences of places of the size `PLACED`, or as far as the ring has gone, known
    to a few units in their last digit: more than a light roller is pressed in. The stiffness is at
    least that of one slice that carries the centrifugal force, and of ribs that may touch.
    """
    half = 0.5 * p[layout.LENGTH, column]
    slice_constant = p[layout.OUTER_CONSTANT, column] / slices
    slope = EXPONENT * slice_constant**0.9 * p[layout.CENTRIFUGAL, column] ** 0.1
    couple = (2.0 * p[layout.RIB_LEVER, column] / half) ** 2
    couple *= max(p[layout.RIB_AHEAD, column], p[layout.RIB_BEHIND, column])
    place = max(PLACED * p[layout.DIAMETER, column], max(abs(ring[0]), abs(ring[1])))
    known = 4.0 * EPSILON * place
    return float(known * max(max(slope, couple), max(h00, h11 / (half * half))))


@filling
def thrown_out(
    p: Array, column: int, ring: Array, place: Array, drop: Array
) -> tuple[float, float]:
    """Where its inertia presses a roller alone: into the outer race, below the resultant.

    A light roller stands on two slices like a table on its legs: those on either side of the
    resultant whose line no other slice crosses. Each carries its part by the lever rule. drop:
    (n,), of the outer contact.
    """
    across = p[layout.OUTER_SHIFT, column]
    load = p[layout.CENTRIFUGAL, column] * p[layout.CENTRIFUGAL_SHIFT, column] / across
    moment = p[layout.OUTER_TURN, column] * load - p[layout.MOMENT, column]
    moment -= p[layout.CENTRIFUGAL, column] * p[layout.CENTRIFUGAL_TURN, column]
    last = place.size - 1
    at = min(max(moment / load, place[0]), place[last])
    before, after, slope = 0, last, 0.0
    for _ in range(2 * place.size):
        low, high = -1, -1
        for k in range(place.size):
            above = drop[k] - slope * place[k]
            if not above < np.inf:
                continue
            if place[k] <= at and k < last:
                low = k if low < 0 or above < drop[low] - slope * place[low] else low
            else:
                high = k if high < 0 or above < drop[high] - slope * place[high] else high
        if low < 0 or high < 0 or (low == before and high == after):
            break
        before, after = low, high
        slope = (drop[after] - drop[before]) / (place[after] - place[before])
    part = (at - place[before]) / (place[after] - place[before])
    constant = p[layout.OUTER_CONSTANT, column] / place.size
    low_end = drop[before] + ((1.0 - part) * load / constant) ** (1.0 / EXPONENT)
    high_end = drop[after] + (part * load / constant) ** (1.0 / EXPONENT)
    slope = (high_end - low_end) / (place[after] - place[before])
    if not abs(slope) < np.inf:
        return middle(p, column, ring)
    turn = -ring[2] - slope
    without, _ = outer_line(p, column, ring, 0.0, turn)
    return (low_end - slope * place[before] - without) / across, turn


@shared
def _lightened(
    p: Array, column: int, line: Line, ring: Array, found: Pressed
) -> tuple[float, float, int]:
    """Find the balance of a roller by way of heavier ones: η, ω, and steps.

    Inertia that presses a slice in by less than an atom leaves Newton's method nothing to go by: a
    step from outside is as long as the bearing, one from inside leads out. Of a roller so heavy
    that it is pressed in as deep as profiles drop, the balance is found at once; from there its
    inertia comes down, and every stage starts pressed in too deep. Heavy slices know nothing of
    each other.
    """
    part = np.empty((p.shape[0], 1))
    part[:, 0] = p[:, column]
    alone = False, line[1], line[2], line[3], line[4], line[5], line[6]
    greatest = max(p[layout.INNER_CONSTANT, column], p[layout.OUTER_CONSTANT, column])
    heavy = greatest * (HEAVY_DEPTH * p[layout.DIAMETER, column]) ** EXPONENT
    shift, turn = middle(p, column, ring)
    steps, inertia = 0, p[layout.CENTRIFUGAL, column]
    factor = heavy / inertia if inertia > 0.0 else 1.0
    while 1.0 < factor < np.inf:
        for row in (layout.CENTRIFUGAL, layout.MOMENT):
            part[row, 0] = factor * p[row, column]
        press(part, 0, alone, ring, shift, turn, found)
        shift, turn, more = _by_newton(part, 0, alone, ring, shift, turn, found, PRECISION)
        steps += more
        factor /= LIGHTER
    press(p, column, line, ring, shift, turn, found)
    shift, turn, more = _by_newton(p, column, line, ring, shift, turn, found, PRECISION)
    return shift, turn, steps + more


@filling
def _followed(
    p: Array,
    column: int,
    line: Line,
    ring: Array,
    state: Array,
    before: Array,
    found: Pressed,
) -> bool:
    """Take a roller along with the ring, and press it there; whether it may begin there.

    Between the races it goes half as far as the ring; what only its inertia presses stays at the
    outer race, where nothing has changed.
    """
    sums, loads = found
    old_shift, old_turn = middle(p, column, before)
    new_shift, new_turn = middle(p, column, ring)
    shift, turn = state[0] + new_shift - old_shift, state[1] + new_turn - old_turn
    u, w = inner_line(p, column, shift, turn)
    press_contact(p, column, line, INNER, u, w, sums[INNER], loads[INNER])
    if not sums[INNER, 0] > 0.0:
        approach, _ = outer_line(p, column, before, state[0], state[1])
        turn = state[1] + before[2] - ring[2]
        without, _ = outer_line(p, column, ring, 0.0, turn)
        shift = (approach - without) / p[layout.OUTER_SHIFT, column]
        u, w = inner_line(p, column, shift, turn)
        press_contact(p, column, line, INNER, u, w, sums[INNER], loads[INNER])
        if sums[INNER, 0] > 0.0:
            return False
    u, w = outer_line(p, column, ring, shift, turn)
    press_contact(p, column, line, OUTER, u, w, sums[OUTER], loads[OUTER])
    state[0], state[1] = shift, turn
    return bool(sums[OUTER, 0] > 0.0)


@shared
def relax(
    p: Array,
    column: int,
    line: Line,
    ring: Array,
    state: Array,
    found: Pressed,
    before: Array,
    near: bool,
    precision: float,
) -> tuple[bool, float, float, int]:
    """Find the balance of a roller.

    state: η, ω, written; before: where the ring was for it (3,); near: whether it was in balance
    there, and begins from there. found: sums and loads, written. Returns whether it is
    in balance, the unbalanced load over the scale of the loads, that scale, and Newton steps.
    """
    sums = found[0]
    half = 0.5 * p[layout.LENGTH, column]
    least = floor(p, column)
    accepted = max(ACCEPTED, precision)
    if not (near and _followed(p, column, line, ring, state, before, found)):
        shift, turn = middle(p, column, ring)
        press(p, column, line, ring, shift, turn, found)
        if sums[0, 0] + sums[1, 0] == 0.0 and p[layout.CENTRIFUGAL, column] > 0.0:
            shift, turn = thrown_out(p, column, ring, line[1], line[2][OUTER])
            press(p, column, line, ring, shift, turn, found)
    else:
        shift, turn = state[0], state[1]
    shift, turn, steps = _by_newton(p, column, line, ring, shift, turn, found, precision)
    for attempt in range(2):
        forces = balance(p, column, ring, turn, sums)
        size = max(forces[6], least)
        residual = max(abs(forces[0]), abs(forces[1]) / half) / size
        if residual > accepted:
            residual = max(
                residual - rounding(p, column, ring, line[1].size, forces[2], forces[5]) / size, 0.0
            )
        if residual <= accepted or attempt > 0:
            break
        shift, turn, more = _lightened(p, column, line, ring, found)
        steps += more
    state[0], state[1] = shift, turn
    return residual <= accepted, residual, size, steps


@filling
def _by_newton(
    p: Array,
    column: int,
    line: Line,
    ring: Array,
    shift: float,
    turn: float,
    found: Pressed,
    precision: float,
) -> tuple[float, float, int]:
    """Come down to the balance of a roller by Newton's method: η, ω, and steps.

    found: as the roller is pressed where it begins, then where it ends.
    """
    half = 0.5 * p[layout.LENGTH, column]
    least, extra = floor(p, column), added(p, column)
    longest = LONGEST * p[layout.DIAMETER, column]
    g0, g1, h00, h01, h10, h11, scale = balance(p, column, ring, turn, found[0])
    steps, damping, before = 0, 0.0, np.inf
    while True:
        left = max(abs(g0), abs(g1) / half)
        if not left > precision * max(scale, least) or steps >= STEPS:
            break
        if left <= rounding(p, column, ring, line[1].size, h00, h11) and left > 0.5 * before:
            break  # no step betters its rounding
        more = extra + damping * max(h00, h11 / (half * half))
        a, d = h00 + more, h11 / (half * half) + more
        b, c = h01 / half, h10 / half
        determinant = a * d - b * c
        s0 = -(d * g0 - b * g1 / half) / determinant
        s1 = -(a * g1 / half - c * g0) / determinant
        slope = -(g0 * s0 + g1 * s1 / half)
        length = max(abs(s0), abs(s1))
        if not (slope > 0.0 and length < np.inf):
            break
        steps += 1
        whole = min(1.0, longest / length)
        part = whole
        old_shift, old_turn, before = shift, turn, left
        for _ in range(SHORTENINGS):
            shift, turn = old_shift + part * s0, old_turn + part * s1 / half
            g0, g1, h00, h01, h10, h11, scale = press(p, column, line, ring, shift, turn, found)
            ahead = -(g0 * s0 + g1 * s1 / half)
            if ahead >= -OVERSHOOT * slope:
                break
            part *= min(max(slope / (slope - ahead), 0.1), 0.6)
        # along what hardly holds, a whole step would be cut to nothing in all the rest as well
        if part < MUCH_SHORTER * whole:
            damping = max(4.0 * damping, LEAST_HELP)
        elif part == 1.0:
            damping = 0.03 * damping if damping > LEAST_DAMPING else 0.0
        if shift == old_shift and turn == old_turn:
            break
    return shift, turn, steps


@filling
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

    The roller's own place follows: K = K_rr - K_rq K_qq⁻¹ K_qr. Coupled slices have no potential,
    and so no symmetry, to the last digits.
    """
    _, _, h00, h01, h10, h11, _ = balance(p, column, ring, turn, sums)
    sine, cosine = p[layout.OUTER_SINE, column], p[layout.OUTER_COSINE, column]
    lever, reach = p[layout.LEVER, column], p[layout.RIB_LEVER, column]
    ao, bo = p[layout.OUTER_SHIFT, column], p[layout.OUTER_TURN, column]
    q, m, q_u, q_w, m_u, m_w = sums[1]
    pushed, rate = rib(p, column, ring[0] + reach * (ring[2] + 2.0 * turn))
    force[0] = sine * q + pushed
    force[1] = cosine * q - p[layout.CENTRIFUGAL, column]
    force[2] = lever * q - m + reach * pushed - p[layout.MOMENT, column]
    half = 0.5 * p[layout.LENGTH, column]
    extra = added(p, column)
    h00, h11 = h00 + extra, h11 + extra * half * half
    determinant = h00 * h11 - h01 * h10
    # of Q and M of the outer contact by A, b, θ, then by η, ω
    q_turn, m_turn = bo * q_u - q_w, bo * m_u - m_w
    across = (sine, cosine, lever)
    ribs = (1.0, 0.0, reach)
    for i in range(3):
        turned_i = 1.0 if i == 2 else 0.0
        by_shift = ao * (across[i] * q_u - turned_i * m_u)
        by_turn = across[i] * q_turn - turned_i * m_turn + 2.0 * reach * rate * ribs[i]
        for k in range(3):
            turned_k = 1.0 if k == 2 else 0.0
            load = across[k] * q_u - turned_k * q_w
            moment = across[k] * m_u - turned_k * m_w
            on_shift = ao * load
            on_turn = bo * load - moment + 2.0 * reach * rate * ribs[k]
            stiffness[i, k] = across[i] * load - turned_i * moment + rate * ribs[i] * ribs[k]
            follow_shift = (h11 * on_shift - h01 * on_turn) / determinant
            follow_turn = (h00 * on_turn - h10 * on_shift) / determinant
            stiffness[i, k] -= by_shift * follow_shift + by_turn * follow_turn
