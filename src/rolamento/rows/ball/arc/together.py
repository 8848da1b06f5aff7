"""Ring and balls on grooves together: Newton's method, the balls of a case side by side in lanes.

The equations are those of `flanks`. Each ball is taken out of the ring's by a 2×2 solve: with the
force g and the stiffness k_i of its inner contacts, k of all of them, and r what is unbalanced,

    dX = k⁻¹ (r + k_i da),    g + k_i (da - dX) = (g - k_i k⁻¹ r) + (k_i - k_i k⁻¹ k_i) da,

where da is the step of the inner groove's centre. It proposes the ring's place and has no
safeguard: what does not settle is left to `flanks.settle_cases`, and all is judged as it is held.
"""

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import filling, inline_exact, inline_fast, kernel, vector_loop
from rolamento.numerics.dense import solve_dense
from rolamento.rows.ball import layout
from rolamento.rows.ball.arc.flanks import (
    ARM,
    BOTH,
    COLUMN,
    COS_FIRST,
    DEGREES,
    FAR,
    FLOOR,
    FORCE,
    INNER,
    LENGTH,
    OUTER,
    RADIAL_OFFSET,
    ROUNDING,
    SHIFT,
    SIN_FIRST,
    SLOPE,
    STIFFNESS,
    TERMS,
    TOWARD,
)
from rolamento.rows.ball.layout import lanes

STEPS: Final = 20
FIRST_STEPS: Final = 2
"""Steps that the balls take alone, before the ring moves."""
TOLERANCE: Final = 1e-8
"""What is unbalanced before the last step, which squares it, or less where a ball just touches."""
SOFT: Final = 1.5e-10
"""√m: of a contact pressed in by 10⁻²⁰ m, which holds a ball that is free."""

# --- a ball's workspace ---------------------------------------------------------------------------
_COS, _SIN, _USED, _X1, _X2 = (lanes(row) for row in range(5))
_R1, _R2, _K11, _K12, _K21, _K22 = (lanes(row) for row in range(5, 11))
_G1, _G2, _I11, _I12, _I21, _I22, _SCALE = (lanes(row) for row in range(11, 18))
_Q1, _Q2, _W11, _W12, _W21, _W22 = (lanes(row) for row in range(18, 24))
_ROWS: Final = 24

# --- the sums over the balls: force and stiffness, each times 1, cos, sin and their squares -------
_F1, _F2, _T11, _T12, _T21, _T22 = 0, 6, 12, 18, 24, 30
_C, _S, _CC, _CS, _SS = 1, 2, 3, 4, 5
_WORST: Final = 36
_HEAVIEST: Final = 37
_SUMS: Final = 38

_N: Final = np.uintp(layout.LANES)


@inline_fast
def _contact(
    p: Array, race: int, flank: float, y1: float, y2: float
) -> tuple[float, float, float, float, float, float, float]:
    """`flanks._contact` without a branch: load, its components, and their derivatives."""
    length = p[race + LENGTH]
    distance = max(sqrt(y1 * y1 + y2 * y2), 1e-30)
    inverse = 1.0 / distance
    s, c = y1 * inverse, y2 * inverse
    on_it = s * p[TOWARD] * flank + c * p[TOWARD + 1]
    approach = distance - length
    approach = approach if approach > ROUNDING * length else 0.0
    approach = approach if on_it > 0.0 else 0.0
    before, now = 1.0, c
    value = p[race + STIFFNESS] + p[race + STIFFNESS + 1] * c
    slope = p[race + SLOPE] + p[race + SLOPE + 1] * c
    for term in range(2, TERMS - 1):
        before, now = now, 2.0 * c * now - before
        value += p[race + STIFFNESS + term] * now
        slope += p[race + SLOPE + term] * now
    value += p[race + STIFFNESS + TERMS - 1] * (2.0 * c * now - before)
    root = sqrt(approach)
    load = value * approach * root
    stiff, turn = 1.5 * value * root, slope * approach * root * inverse * s
    rise1, rise2 = stiff * s - turn * c, stiff * c + turn * s
    across = load * inverse
    return (
        load, load * s, load * c,
        s * rise1 + across * c * c, s * rise2 - across * s * c,
        c * rise1 - across * s * c, c * rise2 + across * s * s,
    )  # fmt: skip


@inline_fast
def _groove(p: Array, u: Array, c: float, s: float) -> tuple[float, float]:
    """Where the inner groove's middle stands at a ball; u: the ring, its tilts times the arm."""
    return u[0] + c * u[3] - s * u[4], p[RADIAL_OFFSET] + s * u[1] + c * u[2]


@inline_fast
def _middle(p: Array, flanks: Array) -> float:
    """X1 of a ball between centres in line: two flanks are even about the middle."""
    l_i, l_o, shift = p[INNER + LENGTH], p[OUTER + LENGTH], p[OUTER + SHIFT]
    aside = l_o / (l_o + l_i) * (p[INNER + SHIFT] + shift) - shift
    return aside if flanks.size == 1 else 0.0


@vector_loop
def _press(p: Array, flanks: Array, u: Array, b: Array) -> None:
    """Press the balls of all lanes against their arcs, the ring at u."""
    for i in range(_N):
        b[_R1 + i], b[_R2 + i] = 0.0, p[FORCE]
        b[_G1 + i], b[_G2 + i] = 0.0, 0.0
        b[_I11 + i], b[_I12 + i], b[_I21 + i], b[_I22 + i] = 0.0, 0.0, 0.0, 0.0
        b[_K11 + i], b[_K12 + i], b[_K21 + i], b[_K22 + i] = 0.0, 0.0, 0.0, 0.0
        b[_SCALE + i] = 0.0
    for f in range(flanks.size):
        flank = flanks[f]
        for i in range(_N):
            a1, a2 = _groove(p, u, b[_COS + i], b[_SIN + i])
            x1, x2 = b[_X1 + i], b[_X2 + i]
            q, f1, f2, k11, k12, k21, k22 = _contact(
                p, INNER, flank, a1 - x1 + flank * p[INNER + SHIFT], a2 - x2
            )
            b[_G1 + i] += f1
            b[_G2 + i] += f2
            b[_I11 + i] += k11
            b[_I12 + i] += k12
            b[_I21 + i] += k21
            b[_I22 + i] += k22
            o, h1, h2, o11, o12, o21, o22 = _contact(
                p, OUTER, flank, x1 + flank * p[OUTER + SHIFT], x2
            )
            b[_R1 + i] += f1 - h1
            b[_R2 + i] += f2 - h2
            b[_K11 + i] += k11 + o11
            b[_K12 + i] += k12 + o12
            b[_K21 + i] += k21 + o21
            b[_K22 + i] += k22 + o22
            b[_SCALE + i] = max(b[_SCALE + i], max(q, o))


@vector_loop
def _condense(p: Array, flanks: Array, u: Array, b: Array) -> None:
    """Let the balls follow the ring: dX = q + W da; G and I become what the ring sees.

    A ball that nothing touches stands in the middle.
    """
    l_i, l_o = p[INNER + LENGTH], p[OUTER + LENGTH]
    share, soft = l_o / (l_o + l_i), SOFT * p[BOTH]
    for i in range(_N):
        a1, a2 = _groove(p, u, b[_COS + i], b[_SIN + i])
        x1, x2, touched = b[_X1 + i], b[_X2 + i], b[_SCALE + i] + p[FORCE]
        b[_X1 + i] = x1 if touched > 0.0 else share * a1 + _middle(p, flanks)
        b[_X2 + i] = x2 if touched > 0.0 else share * a2
        k11, k12, k21, k22 = (
            b[_K11 + i] + soft, b[_K12 + i], b[_K21 + i], b[_K22 + i] + soft
        )  # fmt: skip
        i11, i12, i21, i22 = b[_I11 + i], b[_I12 + i], b[_I21 + i], b[_I22 + i]
        r1, r2 = b[_R1 + i], b[_R2 + i]
        inverse = 1.0 / (k11 * k22 - k12 * k21)
        q1, q2 = inverse * (k22 * r1 - k12 * r2), inverse * (k11 * r2 - k21 * r1)
        w11, w12 = inverse * (k22 * i11 - k12 * i21), inverse * (k22 * i12 - k12 * i22)
        w21, w22 = inverse * (k11 * i21 - k21 * i11), inverse * (k11 * i22 - k21 * i12)
        b[_Q1 + i], b[_Q2 + i] = q1, q2
        b[_W11 + i], b[_W12 + i], b[_W21 + i], b[_W22 + i] = w11, w12, w21, w22
        b[_G1 + i] -= i11 * q1 + i12 * q2
        b[_G2 + i] -= i21 * q1 + i22 * q2
        b[_I11 + i] = i11 - i11 * w11 - i12 * w21
        b[_I12 + i] = i12 - i11 * w12 - i12 * w22
        b[_I21 + i] = i21 - i21 * w11 - i22 * w21
        b[_I22 + i] = i22 - i21 * w12 - i22 * w22


@vector_loop
def _move(p: Array, step: Array, b: Array) -> None:
    """Take the balls along with a step of the ring, not too far."""
    longest = FAR * (p[INNER + LENGTH] + p[OUTER + LENGTH])
    for i in range(_N):
        c, s = b[_COS + i], b[_SIN + i]
        a1, a2 = step[0] + c * step[3] - s * step[4], s * step[1] + c * step[2]
        d1 = b[_Q1 + i] + b[_W11 + i] * a1 + b[_W12 + i] * a2
        d2 = b[_Q2 + i] + b[_W21 + i] * a1 + b[_W22 + i] * a2
        part = longest / max(longest, sqrt(d1 * d1 + d2 * d2))
        b[_X1 + i] += part * d1
        b[_X2 + i] += part * d2


@vector_loop
def _begin(p: Array, flanks: Array, u: Array, b: Array) -> None:
    """Put the balls of all lanes on the line of the groove centres."""
    l_i, l_o = p[INNER + LENGTH], p[OUTER + LENGTH]
    share = l_o / (l_o + l_i)
    for i in range(_N):
        a1, a2 = _groove(p, u, b[_COS + i], b[_SIN + i])
        b[_X1 + i], b[_X2 + i] = share * a1 + _middle(p, flanks), share * a2


@vector_loop
def _let_out(p: Array, b: Array) -> None:
    """Put the balls that the rings hardly grip where their centrifugal force presses them."""
    shift, length = p[OUTER + SHIFT], p[OUTER + LENGTH]
    into = (p[FORCE] / (4.0 * p[BOTH])) ** (2.0 / 3.0)
    rest = sqrt(max((length + into) ** 2 - shift * shift, 0.0))
    for i in range(_N):
        free = b[_SCALE + i] <= p[FORCE]
        b[_X1 + i] = 0.0 if free else b[_X1 + i]
        b[_X2 + i] = rest if free else b[_X2 + i]


@vector_loop
def _weigh(p: Array, b: Array, total: Array) -> None:
    """Take the balls' residuals and loads into the greatest of all."""
    floor, worst, heaviest = max(p[FLOOR], p[FORCE]), 0.0, 0.0
    for i in range(_N):
        error = max(abs(b[_R1 + i]), abs(b[_R2 + i])) / max(floor, b[_SCALE + i])
        worst = max(worst, b[_USED + i] * error)
        heaviest = max(heaviest, b[_USED + i] * b[_SCALE + i])
    total[_WORST] = max(total[_WORST], worst)
    total[_HEAVIEST] = max(total[_HEAVIEST], heaviest)


@vector_loop
def _add(b: Array, row: np.uintp, total: Array, first: int) -> None:
    """Add a number of all balls, times powers of their cosines and sines."""
    t0, t1, t2, t3, t4, t5 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(_N):
        c, s, value = b[_COS + i], b[_SIN + i], b[_USED + i] * b[row + i]
        t0 += value
        t1 += c * value
        t2 += s * value
        t3 += c * c * value
        t4 += c * s * value
        t5 += s * s * value
    total[first] += t0
    total[first + _C] += t1
    total[first + _S] += t2
    total[first + _CC] += t3
    total[first + _CS] += t4
    total[first + _SS] += t5


@inline_fast
def _to_ring(t: Array, force: Array, k: Array) -> None:
    """The ring's force (5,) and stiffness (5, 5) from the sums over the balls.

    Its rows take f1, s f2, c f2, c f1 and -s f1, with da = (dx + c dp - s dq, s dy + c dz).
    """
    force[0], force[1], force[2] = t[_F1], t[_F2 + _S], t[_F2 + _C]
    force[3], force[4] = t[_F1 + _C], -t[_F1 + _S]
    k[0, 0], k[0, 1], k[0, 2] = t[_T11], t[_T12 + _S], t[_T12 + _C]
    k[0, 3], k[0, 4] = t[_T11 + _C], -t[_T11 + _S]
    k[1, 0], k[1, 1], k[1, 2] = t[_T21 + _S], t[_T22 + _SS], t[_T22 + _CS]
    k[1, 3], k[1, 4] = t[_T21 + _CS], -t[_T21 + _SS]
    k[2, 0], k[2, 1], k[2, 2] = t[_T21 + _C], t[_T22 + _CS], t[_T22 + _CC]
    k[2, 3], k[2, 4] = t[_T21 + _CC], -t[_T21 + _CS]
    k[3, 0], k[3, 1], k[3, 2] = t[_T11 + _C], t[_T12 + _CS], t[_T12 + _CC]
    k[3, 3], k[3, 4] = t[_T11 + _CC], -t[_T11 + _CS]
    k[4, 0], k[4, 1], k[4, 2] = -t[_T11 + _S], -t[_T12 + _SS], -t[_T12 + _CS]
    k[4, 3], k[4, 4] = -t[_T11 + _CS], t[_T11 + _SS]


@filling
def _evaluate(
    p: Array, flanks: Array, u: Array, b: Array, total: Array, force: Array, stiffness: Array
) -> None:
    """Press all balls and sum up what the ring sees of them, following; b (blocks, …)."""
    total[:] = 0.0
    for block in range(b.shape[0]):
        own = b[block]
        _press(p, flanks, u, own)
        _weigh(p, own, total)
        _condense(p, flanks, u, own)
        _add(own, _G1, total, _F1)
        _add(own, _G2, total, _F2)
        _add(own, _I11, total, _T11)
        _add(own, _I12, total, _T12)
        _add(own, _I21, total, _T21)
        _add(own, _I22, total, _T22)
    _to_ring(total, force, stiffness)


@filling
def _put_balls(p: Array, flanks: Array, cosines: Array, sines: Array, u: Array, b: Array) -> None:
    """Put the balls of a case where their search begins, each at its azimuth, the ring at u."""
    c0, s0 = p[COS_FIRST], p[SIN_FIRST]
    for place in range(b.shape[0] * layout.LANES):
        j, own, i = min(place, cosines.size - 1), b[place // layout.LANES], place % layout.LANES
        own[_COS + i] = cosines[j] * c0 - sines[j] * s0
        own[_SIN + i] = sines[j] * c0 + cosines[j] * s0
        own[_USED + i] = 1.0 if place < cosines.size else 0.0
    for block in range(b.shape[0]):
        _begin(p, flanks, u, b[block])
        if flanks.size > 1 and p[FORCE] > 0.0:
            _press(p, flanks, u, b[block])
            _let_out(p, b[block])


@inline_exact
def _pressed_in(p: Array, flanks: Array, balls: int, load: Array) -> tuple[float, float, float]:
    """x, y, z at which the heaviest ball carries more than its load, as `blocks.start` has it.

    From there Newton's method comes down to the place, from a loose ring it overshoots.
    """
    fx, fy, fz = load[0], load[1], load[2]
    length, a2 = p[OUTER + LENGTH] + p[INNER + LENGTH], p[RADIAL_OFFSET]
    a1 = p[OUTER + SHIFT] + p[INNER + SHIFT]
    if flanks.size == 1:
        fx = max(fx, 0.0)
    radial = sqrt(fy * fy + fz * fz)
    stiffness, sine = p[BOTH] * balls, sqrt(max(length * length - a2 * a2, 0.0)) / length
    if abs(fx) * a2 < radial * sine * length:
        whole = sqrt(fx * fx + radial * radial)
        reach = length + (4.5 * whole / stiffness) ** (2.0 / 3.0)
        x, away = reach * abs(fx) / whole - a1, reach * radial / whole - a2
    else:
        axial = abs(fx) + 2.0 * sqrt(load[3] * load[3] + load[4] * load[4]) / p[ARM]
        reach = length + (axial / (max(sine, 0.2) * stiffness)) ** (2.0 / 3.0)
        x = sqrt(max(reach * reach - a2 * a2, 0.0)) - a1
        away = (4.5 * radial / stiffness) ** (2.0 / 3.0)
    x = (x if fx > 0.0 else -x) if abs(fx) > 0.0 else 0.0
    part = away / radial if radial > 0.0 else 0.0
    return x, part * fy, part * fz


@kernel
def settle_together(
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
    """Let the rings of the cases first..last-1 go until the loads balance: a proposal.

    p: (COLUMN, cases); free, load (cases, 5): where the load is given, and it; rings (cases, 5):
    where they are held, written; settled and steps (cases): whether each came to rest, and in how
    many steps.
    """
    balls, width = cosines.size, layout.LANES
    b = np.zeros(((balls + width - 1) // width, _ROWS * width))
    own, total, arms = np.empty(COLUMN), np.empty(_SUMS), np.ones(DEGREES)
    u, step, force = np.empty(DEGREES), np.empty(DEGREES), np.empty(DEGREES)
    stiffness = np.empty((DEGREES, DEGREES))
    for case in range(first, last):
        for row in range(COLUMN):
            own[row] = p[row, case]
        arms[3:] = own[ARM]
        longest = FAR * (own[INNER + LENGTH] + own[OUTER + LENGTH])
        begun = _pressed_in(own, flanks, balls, load[case])
        for i in range(DEGREES):
            u[i], step[i] = rings[case, i] * arms[i], 0.0
        for i in range(layout.SHIFTS):
            u[i] = begun[i] if free[case, i] else u[i]
        _put_balls(own, flanks, cosines, sines, u, b)
        settled[case], steps[case] = False, 0
        for turn in range(-FIRST_STEPS, STEPS):
            _evaluate(own, flanks, u, b, total, force, stiffness)
            if turn >= 0:
                worst, size = 0.0, max(own[FLOOR], total[_HEAVIEST])
                for i in range(DEGREES):
                    size = max(size, abs(force[i]))
                    given = load[case, i] / arms[i]
                    step[i] = 0.0
                    if free[case, i]:
                        size = max(size, abs(given))
                        step[i] = given - force[i]
                    worst = worst if abs(step[i]) <= worst else abs(step[i])
                    for k in range(DEGREES):
                        if not (free[case, i] and free[case, k]):
                            stiffness[i, k] = 1.0 if i == k else 0.0
                done = worst <= TOLERANCE * size and total[_WORST] <= TOLERANCE
                if not (worst < np.inf and solve_dense(stiffness, step)):
                    break
                length = 0.0
                for i in range(DEGREES):
                    length += step[i] * step[i]
                part = longest / max(longest, sqrt(length))
                for i in range(DEGREES):
                    step[i] *= part
                    u[i] += step[i]
                steps[case] += 1
                if done:
                    for i in range(DEGREES):
                        rings[case, i] = u[i] / arms[i]
                    settled[case] = True
                    break
            for block in range(b.shape[0]):
                _move(own, step, b[block])
