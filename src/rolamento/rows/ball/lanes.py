"""The fast path: Newton's method on ring and balls together, many cases abreast.

Each function is one pass over the lanes and compiles to vector code: no branch, no call that
is not inlined, every array index unsigned. A lane that fails turns to NaN or does not settle;
it is left for `robust`, and nothing here decides whether a result may be shown.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from rolamento.numerics.compiled import inline_fast, vector_loop
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import contact_fast, linearised_fast, polar_fast
from rolamento.rows.ball.layout import lanes
from rolamento.rows.ball.types import Array, Coefficients, Seven, Six, Three, Two

N = np.uintp(layout.LANES)

_COS, _SIN, _SIGMA, _LAMBDA = (
    lanes(r) for r in (layout.COS, layout.SIN, layout.SIGMA, layout.LAMBDA)
)
_X1, _X2 = lanes(layout.POSITION), lanes(layout.POSITION + 1)
_Q1, _Q2, _W11, _W12, _W21, _W22, _Z1, _Z2 = (lanes(layout.FOLLOW + i) for i in range(8))

_L_O, _L_I = lanes(layout.OUTER_LENGTH), lanes(layout.INNER_LENGTH)
_A1, _A2 = lanes(layout.AXIAL_OFFSET), lanes(layout.RADIAL_OFFSET)
_GAMMA, _C_F, _C_G = lanes(layout.GAMMA), lanes(layout.CENTRIFUGAL), lanes(layout.GYROSCOPIC)
_OMEGA_I, _OMEGA_O = lanes(layout.INNER_SPEED), lanes(layout.OUTER_SPEED)
_FRICTION_ARM = lanes(layout.FRICTION_ARM)
_K_O = lanes(layout.OUTER_STIFFNESS)
_K_I = lanes(layout.INNER_STIFFNESS)
_K_S = lanes(layout.SERIES_STIFFNESS)
_APPLIED, _FREE = lanes(layout.APPLIED), lanes(layout.FREE)
_UX, _UY, _UZ, _UP, _UQ = (lanes(layout.DISPLACEMENT + i) for i in range(5))
_DX, _DY, _DZ, _DP, _DQ = (lanes(layout.STEP + i) for i in range(5))
_FX, _FY, _FZ, _FP, _FQ = (lanes(layout.REACTION + i) for i in range(5))
_MATRIX = tuple(lanes(layout.MATRIX + i) for i in range(25))
_HOLD_RATE, _HOLD_OFFSET = lanes(layout.HOLD_RATE), lanes(layout.HOLD_OFFSET)
_OWN, _CAGE_WEIGHT = lanes(layout.OWN_ORBIT), lanes(layout.CAGE_WEIGHT)
_NOMINAL = lanes(layout.NOMINAL_ORBIT)
_CAGE, _DCAGE, _LAG = lanes(layout.CAGE), lanes(layout.CAGE_STEP), lanes(layout.LAG)
_BY_CAGE = tuple(lanes(layout.BY_CAGE + i) for i in range(5))
_LAG_BY_RING = tuple(lanes(layout.LAG_BY_RING + i) for i in range(5))
_LAG_BY_CAGE = lanes(layout.LAG_BY_CAGE)
_FAULT, _ASTRAY = lanes(layout.FAULT), lanes(layout.ASTRAY)
_OUTER_SHARE, _INERTIA_APPROACH = lanes(layout.OUTER_SHARE), lanes(layout.INERTIA_APPROACH)
_FIVE = np.uintp(layout.DEGREES_OF_FREEDOM)
_ONE = np.uintp(1)
_ROW = tuple(lanes(row) for row in range(layout.COEFFICIENTS))
_RESET = lanes(layout.FAULT + 1 - layout.REACTION)


@inline_fast
def _groove(w: Array, b: Array, i: int) -> Two:
    """Where the inner groove's centre stands at this ball: A1, A2."""
    c = b[_COS + i]
    s = b[_SIN + i]
    a1 = w[_A1 + i] + w[_UX + i] + c * w[_UP + i] - s * w[_UQ + i]
    a2 = w[_A2 + i] + c * w[_UZ + i] + s * w[_UY + i]
    return a1, a2


@inline_fast
def _coefficients(w: Array, first: np.uintp, i: int) -> Coefficients:
    """The seven coefficients of a contact's stiffness."""
    return (
        w[first + i], w[first + _ROW[1] + i], w[first + _ROW[2] + i], w[first + _ROW[3] + i],
        w[first + _ROW[4] + i], w[first + _ROW[5] + i], w[first + _ROW[6] + i],
    )  # fmt: skip


@inline_fast
def _add_row(w: Array, i: int, row: int, by_a1: float, by_a2: float, c: float, s: float) -> None:
    """Add a row of the ring's stiffness, given the derivatives by A1 and A2."""
    w[_MATRIX[row] + i] += by_a1
    w[_MATRIX[row + 1] + i] += s * by_a2
    w[_MATRIX[row + 2] + i] += c * by_a2
    w[_MATRIX[row + 3] + i] += c * by_a1
    w[_MATRIX[row + 4] + i] -= s * by_a1


@inline_fast
def _add_to_ring(w: Array, b: Array, i: int, force: Three, stiffness: Six) -> None:
    """Add one ball's force and stiffness to the ring's.

    With dA1 = dx + c dp - s dq and dA2 = s dy + c dz (p, q: the tilts times the arm), the rows
    x, y, z, p, q of the ring take f1, s f2, c f2, c h and -s h.
    """
    c = b[_COS + i]
    s = b[_SIN + i]
    f1, f2, h = force
    k11, k12, k21, k22, h1, h2 = stiffness
    w[_FX + i] += f1
    w[_FY + i] += s * f2
    w[_FZ + i] += c * f2
    w[_FP + i] += c * h
    w[_FQ + i] -= s * h
    _add_row(w, i, 0, k11, k12, c, s)
    _add_row(w, i, 5, s * k21, s * k22, c, s)
    _add_row(w, i, 10, c * k21, c * k22, c, s)
    _add_row(w, i, 15, c * h1, c * h2, c, s)
    _add_row(w, i, 20, -s * h1, -s * h2, c, s)


@inline_fast
def _add_to_cage(w: Array, b: Array, i: int, drive: Seven) -> None:
    """Add what the cage's speed does to one ball, and the ball to the cage's balance."""
    c = b[_COS + i]
    s = b[_SIN + i]
    c1, c2, hc, lag, lag1, lag2, lag_c = drive
    w[_BY_CAGE[0] + i] += c1
    w[_BY_CAGE[1] + i] += s * c2
    w[_BY_CAGE[2] + i] += c * c2
    w[_BY_CAGE[3] + i] += c * hc
    w[_BY_CAGE[4] + i] -= s * hc
    w[_LAG + i] += lag
    w[_LAG_BY_RING[0] + i] += lag1
    w[_LAG_BY_RING[1] + i] += s * lag2
    w[_LAG_BY_RING[2] + i] += c * lag2
    w[_LAG_BY_RING[3] + i] += c * lag1
    w[_LAG_BY_RING[4] + i] -= s * lag1
    w[_LAG_BY_CAGE + i] += lag_c


@vector_loop
def reset_sums(w: Array) -> None:
    """Empty the sums over the balls."""
    for i in range(_FX, _FX + _RESET):
        w[i] = 0.0


@vector_loop
def add_static_ball(w: Array, b: Array) -> None:
    """A ball without inertia: both contacts in series along the line of groove centres."""
    for i in range(N):
        a1, a2 = _groove(w, b, i)
        stiffness = _coefficients(w, _K_S, i)
        s, c, v, _, q, kn, ka = contact_fast(a1, a2, w[_L_I + i] + w[_L_O + i], stiffness)
        k11, k12, k21, k22 = polar_fast(s, c, kn, ka * v, 0.0, q * v)
        _add_to_ring(w, b, i, (q * s, q * c, q * s), (k11, k12, k21, k22, k11, k12))


@vector_loop
def add_moving_ball(w: Array, b: Array, tolerance: float) -> None:
    """A ball in motion: its residual, its step, and the ring's view of it."""
    for i in range(N):
        a1, a2 = _groove(w, b, i)
        outer = (w[_L_O + i], _coefficients(w, _K_O, i))
        inner = (w[_L_I + i], _coefficients(w, _K_I, i))
        motion = (
            w[_GAMMA + i], w[_C_F + i], w[_C_G + i], w[_OMEGA_I + i], w[_OMEGA_O + i],
            w[_FRICTION_ARM + i],
        )  # fmt: skip
        cage = (w[_CAGE + i], w[_HOLD_RATE + i], w[_HOLD_OFFSET + i], w[_OWN + i])
        residual, follow, force, stiffness, scale, _, drive, _ = linearised_fast(
            a1, a2, b[_X1 + i], b[_X2 + i], inner, outer, motion, cage, b[_SIGMA + i],
            b[_LAMBDA + i],
        )  # fmt: skip
        r1, r2 = residual
        allowed = tolerance * scale
        w[_FAULT + i] = max(w[_FAULT + i], r1 * r1 + r2 * r2 - allowed * allowed)
        q1, q2, w11, w12, w21, w22, z1, z2 = follow
        b[_Q1 + i], b[_Q2 + i], b[_Z1 + i], b[_Z2 + i] = q1, q2, z1, z2
        b[_W11 + i], b[_W12 + i], b[_W21 + i], b[_W22 + i] = w11, w12, w21, w22
        _add_to_ring(w, b, i, force, stiffness)
        _add_to_cage(w, b, i, drive)


@vector_loop
def follow_ring(w: Array, b: Array) -> None:
    """Move a ball by its own step and with the ring's."""
    for i in range(N):
        c = b[_COS + i]
        s = b[_SIN + i]
        da1 = w[_DX + i] + c * w[_DP + i] - s * w[_DQ + i]
        da2 = c * w[_DZ + i] + s * w[_DY + i]
        dw = w[_DCAGE + i]
        dx1 = b[_Q1 + i] + b[_W11 + i] * da1 + b[_W12 + i] * da2 + b[_Z1 + i] * dw
        dx2 = b[_Q2 + i] + b[_W21 + i] * da1 + b[_W22 + i] * da2 + b[_Z2 + i] * dw
        x1 = b[_X1 + i] + dx1
        x2 = b[_X2 + i] + dx2
        b[_X1 + i] = x1
        b[_X2 + i] = x2
        # a place between the axis plane and the line of groove centres, at the outer race
        a1, a2 = _groove(w, b, i)
        l_o = w[_L_O + i]
        side = 1.0 if a1 > 0.0 else -1.0
        inside = min(side * x1, side * (a1 * x2 - a2 * x1) / l_o) + 0.1 * l_o
        reach = sqrt(x1 * x1 + x2 * x2)
        inside = min(inside, min(1.5 * l_o - reach, reach - 0.8 * l_o))
        w[_ASTRAY + i] = 0.0 if inside > 0.0 else 1.0


@vector_loop
def _hold(w: Array) -> None:
    """Set up the ring's equations: the unbalanced load, and unit rows where it is held."""
    for row in range(_FIVE):
        for i in range(N):
            free = w[_FREE + row * N + i]
            w[_DX + row * N + i] = free * (w[_APPLIED + row * N + i] - w[_FX + row * N + i])
        for column in range(_FIVE):
            entry = _MATRIX[0] + (row * _FIVE + column) * N
            unit = 1.0 if row == column else 0.0
            for i in range(N):
                free = w[_FREE + row * N + i]
                w[entry + i] = free * w[entry + i] + (1.0 - free) * unit


@vector_loop
def _eliminate(w: Array) -> None:
    """Gauss's elimination and back substitution, the solution in place of the right side."""
    for pivot in range(_FIVE):
        diagonal = _MATRIX[0] + (pivot * _FIVE + pivot) * N
        for row in range(pivot + _ONE, _FIVE):
            below = _MATRIX[0] + (row * _FIVE + pivot) * N
            for i in range(N):
                w[below + i] /= w[diagonal + i]
            for column in range(pivot + _ONE, _FIVE):
                target = _MATRIX[0] + (row * _FIVE + column) * N
                source = _MATRIX[0] + (pivot * _FIVE + column) * N
                for i in range(N):
                    w[target + i] -= w[below + i] * w[source + i]
            for i in range(N):
                w[_DX + row * N + i] -= w[below + i] * w[_DX + pivot * N + i]
    for back in range(_FIVE):
        up = _FIVE - _ONE - back
        for column in range(up + _ONE, _FIVE):
            entry = _MATRIX[0] + (up * _FIVE + column) * N
            for i in range(N):
                w[_DX + up * N + i] -= w[entry + i] * w[_DX + column * N + i]
        diagonal = _MATRIX[0] + (up * _FIVE + up) * N
        for i in range(N):
            w[_DX + up * N + i] /= w[diagonal + i]


@vector_loop
def step_ring(w: Array) -> None:
    """One Newton step of the ring on its free degrees of freedom."""
    _hold(w)
    _eliminate(w)
    for i in range(_FIVE * N):
        w[_UX + i] += w[_DX + i]


@vector_loop
def balance_cage(w: Array) -> None:
    """Take the pull of the nominal speed into the cage's balance."""
    for i in range(N):
        w[_LAG + i] += w[_CAGE_WEIGHT + i] * (w[_NOMINAL + i] - w[_CAGE + i])
        w[_LAG_BY_CAGE + i] -= w[_CAGE_WEIGHT + i]


@vector_loop
def condense_cage(w: Array) -> None:
    """Let the cage follow the ring: its speed drops out of the ring's force and stiffness."""
    for row in range(_FIVE):
        force, by_cage = _FX + row * N, _BY_CAGE[0] + row * N
        for i in range(N):
            w[force + i] -= w[by_cage + i] * w[_LAG + i] / w[_LAG_BY_CAGE + i]
        for column in range(_FIVE):
            entry = _MATRIX[0] + (row * _FIVE + column) * N
            lag = _LAG_BY_RING[0] + column * N
            for i in range(N):
                w[entry + i] -= w[by_cage + i] * w[lag + i] / w[_LAG_BY_CAGE + i]


@vector_loop
def step_cage(w: Array) -> None:
    """Take the cage's speed along with the ring's step."""
    for i in range(N):
        w[_DCAGE + i] = -w[_LAG + i]
    for row in range(_FIVE):
        lag, step = _LAG_BY_RING[0] + row * N, _DX + row * N
        for i in range(N):
            w[_DCAGE + i] -= w[lag + i] * w[step + i]
    for i in range(N):
        # no ball orbits faster or slower than both rings turn
        slowest = min(w[_OMEGA_I + i], w[_OMEGA_O + i])
        fastest = max(w[_OMEGA_I + i], w[_OMEGA_O + i])
        speed = w[_CAGE + i] + w[_DCAGE + i] / w[_LAG_BY_CAGE + i]
        speed = min(max(speed, slowest), fastest)
        w[_DCAGE + i] = speed - w[_CAGE + i]
        w[_CAGE + i] = speed


@inline_fast
def _first_place(w: Array, b: Array, i: int) -> Two:
    """A place near equilibrium for a moving ball, whatever its load: X1, X2.

    The two approaches and the distance |A| make a triangle. A ball that the groove centres hardly
    reach (|A| < L_o + L_i) is held up by its centrifugal force at its apex; a heavily loaded
    ball leaves the line of centres only by the turning of its load.
    """
    a1, a2 = _groove(w, b, i)
    c_f = w[_C_F + i]
    stiffness = _coefficients(w, _K_S, i)
    l_o = w[_L_O + i]
    l_i = w[_L_I + i]
    s, c, inverse, _, q, _, _ = contact_fast(a1, a2, l_i + l_o, stiffness)
    speed = w[_CAGE + i]
    f_c = c_f * speed * speed

    length = 1.0 / inverse
    static = max(length - l_i - l_o, 0.0)
    alone = w[_INERTIA_APPROACH + i]
    approach = static + alone * sqrt(alone) / (sqrt(alone) + 1.5 * sqrt(static) + 1e-30)
    share = w[_OUTER_SHARE + i]
    l_o += share * approach
    l_i += (1.0 - share) * approach
    cosine = 0.5 * (l_o * l_o + length * length - l_i * l_i) * inverse / l_o
    sine = min(sqrt(max(1.0 - cosine * cosine, 0.0)), 0.5 * f_c * abs(s) / (q + 1e-30))
    sine = sine if s > 0.0 else -sine
    cosine = sqrt(1.0 - sine * sine)
    s_o = s * cosine - c * sine
    c_o = c * cosine + s * sine
    beyond = s_o * s < 0.0
    return l_o * (0.0 if beyond else s_o), l_o * (1.0 if beyond else c_o)


@vector_loop
def place_ball(w: Array, b: Array) -> None:
    """Put a moving ball near its equilibrium."""
    for i in range(N):
        b[_X1 + i], b[_X2 + i] = _first_place(w, b, i)


@vector_loop
def replace_ball(w: Array, b: Array) -> None:
    """Put a ball near its equilibrium again in the lanes where it has gone astray."""
    for i in range(N):
        x1, x2 = _first_place(w, b, i)
        astray = w[_ASTRAY + i] > 0.0
        b[_X1 + i] = x1 if astray else b[_X1 + i]
        b[_X2 + i] = x2 if astray else b[_X2 + i]
