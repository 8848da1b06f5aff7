"""The fast path: Newton's method on ring and balls together, many cases in lanes.

Each function is one pass over the lanes and compiles to vector code: no branch, no call that
is not inlined, every array index unsigned. A lane that fails turns to NaN or does not settle;
it is left for `robust`, and nothing here decides whether a result may be shown.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, sqrt
from typing import Any, Final

import numpy as np

from rolamento.numerics.compiled import filling, inline_exact, inline_fast, vector_loop
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import (
    FRICTION_SLACK,
    LOST_ANGLE,
    max_with_nan,
    own_scale,
)
from rolamento.rows.ball.ball import (
    contact_fast,
    horner,
    linearised_exact,
    linearised_fast,
    long_polynomial,
    polar_fast,
    short_polynomial,
    touching_fast,
    touching_given,
    towards_exact,
)
from rolamento.rows.ball.elimination import elimination
from rolamento.rows.ball.layout import lanes
from rolamento.rows.ball.mirror import Mirror
from rolamento.rows.ball.settle import (
    LONGEST,
    NEWTON_STEPS,
    PLACE_SLACK,
    SHORTENED,
    SHORTENINGS,
)
from rolamento.rows.ball.single import cage_part, changes_groove, is_rounding
from rolamento.rows.ball.types import (
    Array,
    Five,
    Linearised,
    Motion,
    Seven,
    Six,
    Three,
    Touching,
    Two,
)
from rolamento.status import GREATEST_APPROACH

N = np.uintp(layout.LANES)

_COS, _SIN, _SIGMA = lanes(layout.COS), lanes(layout.SIN), lanes(layout.SIGMA)
_X1, _X2 = lanes(layout.POSITION), lanes(layout.POSITION + 1)
_Q1, _Q2, _W11, _W12, _W21, _W22, _Z1, _Z2 = (lanes(layout.FOLLOW + i) for i in range(8))

_L_O, _L_I = lanes(layout.OUTER_LENGTH), lanes(layout.INNER_LENGTH)
_A1, _A2 = lanes(layout.AXIAL_OFFSET), lanes(layout.RADIAL_OFFSET)
_GAMMA, _C_F, _C_G = lanes(layout.GAMMA), lanes(layout.CENTRIFUGAL), lanes(layout.GYROSCOPIC)
_OMEGA_I, _OMEGA_O = lanes(layout.INNER_SPEED), lanes(layout.OUTER_SPEED)
_FRICTION_ARM, _LAMBDA_INNER = lanes(layout.FRICTION_ARM), lanes(layout.LAMBDA_INNER)
_K_O = lanes(layout.OUTER_STIFFNESS)
_K_I = lanes(layout.INNER_STIFFNESS)
_K_S = lanes(layout.SERIES_STIFFNESS)
_APPLIED, _FREE = lanes(layout.APPLIED), lanes(layout.FREE)
_UX, _UY, _UZ, _UP, _UQ = (lanes(layout.DISPLACEMENT + i) for i in range(5))
_DX, _DY, _DZ, _DP, _DQ = (lanes(layout.STEP + i) for i in range(5))
_FX, _NX = lanes(layout.REACTION), lanes(layout.NOW)
_MATRIX = tuple(lanes(layout.MATRIX + i) for i in range(25))
_HOLD_RATE, _HOLD_OFFSET = lanes(layout.HOLD_RATE), lanes(layout.HOLD_OFFSET)
_OWN, _CAGE_WEIGHT = lanes(layout.OWN_ORBIT), lanes(layout.CAGE_WEIGHT)
_NOMINAL = lanes(layout.NOMINAL_ORBIT)
_CAGE, _DCAGE, _LAG = lanes(layout.CAGE), lanes(layout.CAGE_STEP), lanes(layout.LAG)
_BY_CAGE = tuple(lanes(layout.BY_CAGE + i) for i in range(5))
_LAG_BY_RING = tuple(lanes(layout.LAG_BY_RING + i) for i in range(5))
_LAG_BY_CAGE = lanes(layout.LAG_BY_CAGE)
_FAULT, _ASTRAY, _SETTLED = (lanes(row) for row in (layout.FAULT, layout.ASTRAY, layout.SETTLED))
_LAG_NOW, _PULL = lanes(layout.LAG_NOW), lanes(layout.PULL)
_HEAVIEST, _UNSOUND = lanes(layout.HEAVIEST), lanes(layout.UNSOUND)
_PRESSED = lanes(layout.PRESSED)
_REGROUPED, _DOUBTFUL = lanes(layout.REGROUPED), lanes(layout.DOUBTFUL)
_UNBALANCED, _BEHIND = lanes(layout.UNBALANCED), lanes(layout.BEHIND)
_LOADED, _STEPS = lanes(layout.LOADED), lanes(layout.STEPS)
_CAUTION = lanes(layout.CAUTION)
_ERROR, _SCALE = lanes(layout.ERROR), lanes(layout.SCALE)
_OFF, _LOST_WAY = lanes(layout.OFF), lanes(layout.LOST_WAY)
_KEPT1, _KEPT2, _ONWARD1, _ONWARD2 = (lanes(layout.KEPT + i) for i in range(4))
_MISS, _PART, _TRIED, _TAKEN, FATE = (lanes(layout.MISS + i) for i in range(5))
OPEN, SETTLED_BALL, FAILED = 0.0, 1.0, 2.0
_INNER_EDGE, _OUTER_EDGE = lanes(layout.INNER_EDGE), lanes(layout.OUTER_EDGE)
_ONE_SIDED, _BALL_DIAMETER = lanes(layout.ONE_SIDED), lanes(layout.BALL_DIAMETER)
_OUTER_SHARE, _INERTIA_APPROACH = lanes(layout.OUTER_SHARE), lanes(layout.INERTIA_APPROACH)
_TWO, _THREE, _FIVE = np.uintp(2), np.uintp(3), np.uintp(layout.DEGREES_OF_FREEDOM)
_INNER, _OUTER, _OWN_SPEED = (
    lanes(row) for row in (layout.INNER_CONTACT, layout.OUTER_CONTACT, layout.OWN_SPEED)
)
_ROW = tuple(lanes(row) for row in range(layout.COEFFICIENTS))
_RESET, _SUMS = lanes(layout.SUMS), np.uintp(layout.SUMS)

LOOSE_CAGE: Final = 0.1
"""Unbalanced load, over the ring's loads, below which the cage's speed is free: it follows what the
balls do, and far from balance they do what they will not."""
NEAR_CAGE: Final = 0.02
"""Fraction of the rings' speeds: the longest step of the cage, and what it may lag if the ring's
step is to account for it."""
LEAST_APPROACH: Final = 1e-9
"""Over the grooves' offsets: a ring has at least the stiffness of a contact so lightly pressed."""
LONGEST_STEP: Final = 0.3
"""Longest step of the ring, over the grooves' offsets."""
PATIENCE: Final = 6.0
"""Steps after which a ball that goes astray is no longer put where it began, and ring and ball take
none that is longer than"""
LATE_STEP: Final = 0.03
"""over the grooves' offsets."""
SHORT_STEP: Final = 0.25
"""Part of its step that such a ball takes at most."""
LEAST_PRESSED: Final = 0.1
"""Fraction of the approach under its own centrifugal force, at the outer race: no ball is pressed
less."""
PLACED: Final = 3e-10
"""A ball in a set is near enough for its last step where what that leaves, over its greatest load,
is less."""
DRIVE: Final = -1e-30
"""A cage that turns faster lags less, or all that is known of it is the direction to go."""


def _groove(w: Array, b: Array, i: int) -> Two:
    """Where the inner groove's centre stands at this ball: A1, A2."""
    c = b[_COS + i]
    s = b[_SIN + i]
    a1 = w[_A1 + i] + w[_UX + i] + c * w[_UP + i] - s * w[_UQ + i]
    a2 = w[_A2 + i] + c * w[_UZ + i] + s * w[_UY + i]
    return a1, a2


@inline_exact
def _seven(w: Array, first: np.uintp, i: int) -> Seven:
    """Seven numbers of a lane that follow each other."""
    return (
        w[first + i], w[first + _ROW[1] + i], w[first + _ROW[2] + i], w[first + _ROW[3] + i],
        w[first + _ROW[4] + i], w[first + _ROW[5] + i], w[first + _ROW[6] + i],
    )  # fmt: skip


@inline_exact
def _three(w: Array, first: np.uintp, i: int) -> Three:
    return w[first + i], w[first + _ROW[1] + i], w[first + _ROW[2] + i]


@inline_exact
def _motion(w: Array, i: int) -> Motion:
    return (
        w[_GAMMA + i], w[_C_F + i], w[_C_G + i], w[_OMEGA_I + i], w[_OMEGA_O + i],
        w[_FRICTION_ARM + i],
    )  # fmt: skip


@inline_exact
def _put_three(w: Array, first: np.uintp, i: int, three: Three) -> None:
    """Write three numbers of a lane that follow each other."""
    w[first + i], w[first + _ROW[1] + i], w[first + _ROW[2] + i] = three


@inline_exact
def _put_touch(k: Array, i: int, touch: Touching) -> None:
    """Write how a ball touches."""
    inner, outer, own = touch
    _put_three(k, _INNER, i, inner[:3])
    _put_three(k, _INNER + _ROW[3], i, inner[3:6])
    k[_INNER + _ROW[6] + i], k[_OUTER + _ROW[6] + i] = inner[6], outer[6]
    _put_three(k, _OUTER, i, outer[:3])
    _put_three(k, _OUTER + _ROW[3], i, outer[3:6])
    _put_three(k, _OWN_SPEED, i, own)


def _linearised(inline: Callable[..., Any], formula: Callable[..., Linearised]) -> Any:
    """Build `ball.linearised` for a ball of a lane: how to compile it, and which form it has."""

    @inline
    def linearised(w: Array, b: Array, k: Array, i: int) -> Linearised:
        """k: how it touches."""
        touch = _seven(k, _INNER, i), _seven(k, _OUTER, i), _three(k, _OWN_SPEED, i)
        cage = (w[_CAGE + i], w[_HOLD_RATE + i], w[_HOLD_OFFSET + i], w[_OWN + i])
        sigma = b[_SIGMA + i]
        lambda_i = w[_LAMBDA_INNER + i] if sigma > 0.0 else 2.0
        ball: Linearised = formula(touch, _motion(w, i), cage, sigma, lambda_i)
        return ball

    return linearised


_linearised_fast = _linearised(inline_fast, linearised_fast)
_linearised_exact = _linearised(inline_exact, linearised_exact)


def _sums(inline: Callable[..., Any], tilting: bool) -> tuple[Any, Any, Any]:
    """Build the sums over the balls: how to compile them, and whether the ring can tilt."""

    @inline
    def add_force(w: Array, first: np.uintp, i: int, c: float, s: float, force: Three) -> None:
        """Add one ball's force and moment to the ring's."""
        f1, f2, h = force
        w[first + i] += f1
        w[first + _ROW[1] + i] += s * f2
        w[first + _ROW[2] + i] += c * f2
        if tilting:
            w[first + _ROW[3] + i] += c * h
            w[first + _ROW[4] + i] -= s * h

    @inline
    def add_row(w: Array, i: int, row: int, by_a1: float, by_a2: float, c: float, s: float) -> None:
        """Add a row of the ring's stiffness, given the derivatives by A1 and A2."""
        w[_MATRIX[row] + i] += by_a1
        w[_MATRIX[row + 1] + i] += s * by_a2
        w[_MATRIX[row + 2] + i] += c * by_a2
        if tilting:
            w[_MATRIX[row + 3] + i] += c * by_a1
            w[_MATRIX[row + 4] + i] -= s * by_a1

    @inline
    def add_to_ring(w: Array, i: int, c: float, s: float, force: Three, stiffness: Six) -> None:
        """Add one ball's force and stiffness to the ring's.

        With dA1 = dx + c dp - s dq and dA2 = s dy + c dz (p, q: the tilts times the arm), the rows
        x, y, z, p, q of the ring take f1, s f2, c f2, c h and -s h.
        """
        k11, k12, k21, k22, h1, h2 = stiffness
        add_force(w, _FX, i, c, s, force)
        add_row(w, i, 0, k11, k12, c, s)
        add_row(w, i, 5, s * k21, s * k22, c, s)
        add_row(w, i, 10, c * k21, c * k22, c, s)
        if tilting:
            add_row(w, i, 15, c * h1, c * h2, c, s)
            add_row(w, i, 20, -s * h1, -s * h2, c, s)

    @inline
    def add_to_cage(w: Array, i: int, c: float, s: float, drive: Seven) -> None:
        """Add what the cage's speed does to one ball, and the ball to the cage's balance."""
        c1, c2, hc, lag, lag1, lag2, lag_c = drive
        w[_BY_CAGE[0] + i] += c1
        w[_BY_CAGE[1] + i] += s * c2
        w[_BY_CAGE[2] + i] += c * c2
        w[_LAG + i] += lag
        w[_LAG_BY_RING[0] + i] += lag1
        w[_LAG_BY_RING[1] + i] += s * lag2
        w[_LAG_BY_RING[2] + i] += c * lag2
        if tilting:
            w[_BY_CAGE[3] + i] += c * hc
            w[_BY_CAGE[4] + i] -= s * hc
            w[_LAG_BY_RING[3] + i] += c * lag1
            w[_LAG_BY_RING[4] + i] -= s * lag1
        w[_LAG_BY_CAGE + i] += lag_c

    return add_force, add_to_ring, add_to_cage


_groove_fast, groove_exact = inline_fast(_groove), inline_exact(_groove)


@vector_loop
def reset_sums(w: Array) -> None:
    """Empty the sums over the balls."""
    for i in range(_FX, _FX + _RESET):
        w[i] = 0.0


@vector_loop
def touch_ball(w: Array, b: Array, k: Array) -> None:
    """How a ball touches: k (layout.TOUCH_ROWS * LANES), for what is made of it next.

    By itself: the processor sees some four hundred instructions ahead, and each eight cases wait
    here for their own chain of roots and divisions.
    """
    for i in range(N):
        a1, a2 = _groove_fast(w, b, i)
        inner = (w[_L_I + i] + b[_OFF + i], _seven(w, _K_I, i))
        outer = (w[_L_O + i], _seven(w, _K_O, i))
        x1, x2 = b[_X1 + i], b[_X2 + i]
        touch = touching_fast(a1, a2, x1, x2, inner, outer, _motion(w, i), b[_SIGMA + i])
        _put_touch(k, i, touch)


def _balls(tilting: bool, placed: float) -> tuple[Any, Any]:
    """Build the passes over one ball of every lane, for rings that tilt and rings that do not.

    placed: what a ball's next step may leave of its residual, over its greatest load; where it is
    zero, only the residual counts.
    """
    _, add_to_ring, add_to_cage = _sums(inline_fast, tilting)

    @vector_loop
    def add_static_ball(w: Array, b: Array) -> None:
        """A ball without inertia: both contacts in series along the line of groove centres."""
        for i in range(N):
            a1, a2 = _groove_fast(w, b, i)
            stiffness = _seven(w, _K_S, i)
            s, c, v, _, q, kn, ka = contact_fast(a1, a2, w[_L_I + i] + w[_L_O + i], stiffness)
            k11, k12, k21, k22 = polar_fast(s, c, kn, ka * v, 0.0, q * v)
            force = (q * s, q * c, q * s)
            add_to_ring(w, i, b[_COS + i], b[_SIN + i], force, (k11, k12, k21, k22, k11, k12))

    @vector_loop
    def add_touching_ball(w: Array, b: Array, k: Array, tolerance: float) -> None:
        """A ball in motion: its residual, its step, and the ring's view of it.

        k: how it touches. tolerance: of its residual, over its own greatest load. A step leaves a
        part of the square of the residual over the load of the inner contact, which bends, and of
        its own square over approach and groove's offset, where it turns the load.
        """
        for i in range(N):
            residual, follow, force, stiffness, scale, touch, drive, _ = _linearised_fast(
                w, b, k, i
            )
            r1, r2 = residual
            q1, q2, w11, w12, w21, w22, z1, z2 = follow
            square, allowed = r1 * r1 + r2 * r2, tolerance * scale
            fault = square - allowed * allowed
            if placed > 0.0:
                bends = square - placed * scale * touch[0]
                turns = q1 * q1 + q2 * q2 - placed * w[_L_O + i] * touch[3]
                fault = min(fault, max(bends, turns))
            w[_FAULT + i] = max(w[_FAULT + i], fault)
            b[_Q1 + i], b[_Q2 + i], b[_Z1 + i], b[_Z2 + i] = q1, q2, z1, z2
            b[_W11 + i], b[_W12 + i], b[_W21 + i], b[_W22 + i] = w11, w12, w21, w22
            add_to_ring(w, i, b[_COS + i], b[_SIN + i], force, stiffness)
            add_to_cage(w, i, b[_COS + i], b[_SIN + i], drive)

    @filling
    def add_moving_ball(w: Array, b: Array, k: Array, tolerance: float) -> None:
        """Evaluate a ball in motion; k is room for how it touches."""
        touch_ball(w, b, k)
        add_touching_ball(w, b, k, tolerance)

    return add_static_ball, add_moving_ball


add_static_ball, add_moving_ball = _balls(tilting=True, placed=PLACED)

_add_force_exact, _add_to_ring_exact, _add_to_cage_exact = _sums(inline_exact, tilting=True)


@inline_exact
def _if(bears: float, value: float) -> float:
    return value if bears > 0.0 else 0.0


@filling
def mark_regrouped(w: Array, b: Array) -> None:
    """Mark the lanes where a ball leaves the inner groove, or comes back to it (see `edges`)."""
    for i in range(N):
        a1, a2 = groove_exact(w, b, i)
        off, x1, x2 = b[_OFF + i] > 0.0, b[_X1 + i], b[_X2 + i]
        changes = 1.0 if changes_groove(off, a1, a2, x1, x2, w[_L_I + i]) else 0.0
        w[_REGROUPED + i] = max(w[_REGROUPED + i], changes)


@vector_loop
def reflect(w: Array, factors: Array) -> None:
    """Add to the sums over some balls what their mirror images do (see `mirror`)."""
    for row in range(_SUMS):
        for i in range(N):
            w[_FX + row * N + i] *= factors[row]


@vector_loop
def multiply_reaction(w: Array, factor: float) -> None:
    """Let each ball that was summed up stand for some: force and stiffness of the ring."""
    for i in range(_FX, _BY_CAGE[0]):
        w[i] *= factor


@filling
def start_cage(w: Array, part: float) -> None:
    """What the nominal speed pulls at the cage, before any ball does (see `single.empty_ring`)."""
    for i in range(N):
        pull = part * w[_CAGE_WEIGHT + i]
        w[_LAG + i] = pull * (w[_NOMINAL + i] - w[_CAGE + i])
        w[_LAG_NOW + i] = w[_LAG + i]
        w[_LAG_BY_CAGE + i] = -pull
        w[_PULL + i] = pull


@inline_exact
def _put(k: Array, contact: np.uintp, i: int, c: float, stiffness: Two) -> None:
    """Write cos a, K and dK/d(cos a) of a contact."""
    k[contact + i] = c
    k[contact + N + i], k[contact + _TWO * N + i] = stiffness


@inline_exact
def _take(k: Array, contact: np.uintp, i: int, coefficient: float) -> None:
    """Take one coefficient more of K, the next lower."""
    value, slope = contact + N + i, contact + _TWO * N + i
    k[value], k[slope] = horner(k[value], k[slope], k[contact + i], coefficient)


@filling
def touch_ball_exact(w: Array, b: Array, p: Array, k: Array) -> None:
    """How a ball touches, in exact arithmetic, K from as many coefficients as its bearing has.

    As `ball.stored_polynomial` does. p: of the bearings, from layout.DUTY on: of one, or of more,
    of which the lanes have seven coefficients; k: as of `touch_ball`.
    """
    _evaluate_stiffness(w, b, p, k)
    for i in range(N):
        a1, a2 = groove_exact(w, b, i)
        inner = (w[_L_I + i] + b[_OFF + i], (k[_INNER + N + i], k[_INNER + _TWO * N + i]))
        outer = (w[_L_O + i], (k[_OUTER + N + i], k[_OUTER + _TWO * N + i]))
        x1, x2 = b[_X1 + i], b[_X2 + i]
        touch = touching_given(a1, a2, x1, x2, inner, outer, _motion(w, i), b[_SIGMA + i])
        _put_touch(k, i, touch)


@filling
def _evaluate_stiffness(w: Array, b: Array, p: Array, k: Array) -> None:
    """Cos a, K and dK/d(cos a) of a ball's contacts, first of the rows that each has in k.

    p, k: as of `touch_ball_exact`.
    """
    for i in range(N):
        a1, a2 = groove_exact(w, b, i)
        x1, x2 = b[_X1 + i], b[_X2 + i]
        _, c_o, _, _ = towards_exact(x1, x2)
        _, c_i, _, _ = towards_exact(a1 - x1, a2 - x2)
        _put(k, _OUTER, i, c_o, short_polynomial(c_o, _seven(w, _K_O, i)))
        _put(k, _INNER, i, c_i, short_polynomial(c_i, _seven(w, _K_I, i)))
    count = int(p[layout.TERMS - layout.DUTY, 0])
    if p.shape[1] > 1 or count == layout.COEFFICIENTS:
        return
    for i in range(N):
        _put(k, _OUTER, i, k[_OUTER + i], (0.0, 0.0))
        _put(k, _INNER, i, k[_INNER + i], (0.0, 0.0))
    outer, inner = layout.OUTER_STIFFNESS, layout.INNER_STIFFNESS
    outer, inner = long_polynomial(outer), long_polynomial(inner)
    for power in range(count - 1, -1, -1):
        of_outer, of_inner = p[outer - layout.DUTY + power, 0], p[inner - layout.DUTY + power, 0]
        for i in range(N):
            _take(k, _OUTER, i, of_outer)
            _take(k, _INNER, i, of_inner)


@inline_exact
def _take_in(
    w: Array,
    i: int,
    c: float,
    s: float,
    bears: float,
    force: Three,
    stiffness: Six,
    drive: Seven,
    before: Five,
) -> None:
    """Add to the sums what a ball asks of ring and cage.

    One that nothing touches asks for nothing, and its derivatives are NaN.
    """
    f1, f2, h = force
    k11, k12, k21, k22, h1, h2 = stiffness
    c1, c2, hc, lag, lag1, lag2, lag_c = drive
    n1, n2, nh, lag_now, pull = before
    drive = (
        _if(bears, c1), _if(bears, c2), _if(bears, hc), _if(bears, lag), _if(bears, lag1),
        _if(bears, lag2), _if(bears, lag_c),
    )  # fmt: skip
    _add_to_cage_exact(w, i, c, s, drive)
    w[_PULL + i] += _if(bears, pull)
    _add_force_exact(w, _NX, i, c, s, (_if(bears, n1), _if(bears, n2), _if(bears, nh)))
    w[_LAG_NOW + i] += _if(bears, lag_now)
    force = (_if(bears, f1), _if(bears, f2), _if(bears, h))
    stiffness = (
        _if(bears, k11), _if(bears, k12), _if(bears, k21), _if(bears, k22), _if(bears, h1),
        _if(bears, h2),
    )  # fmt: skip
    _add_to_ring_exact(w, i, c, s, force, stiffness)


@filling
def judge_ball(w: Array, b: Array, k: Array) -> None:
    """A ball in motion as `accept.judge` sees it, to the last bit; what is wrong is UNSOUND.

    k: how it touches.
    """
    for i in range(N):
        a1, _ = groove_exact(w, b, i)
        x1, x2, l_o = b[_X1 + i], b[_X2 + i], w[_L_O + i]
        residual, _, force, stiffness, scale, touch, drive, before = _linearised_exact(w, b, k, i)
        load, c_i, c_o, approach, s_i = touch
        b[_ERROR + i] = sqrt(residual[0] ** 2 + residual[1] ** 2)
        b[_SCALE + i] = scale
        w[_HEAVIEST + i] = max(w[_HEAVIEST + i], scale)

        # without a branch: each condition is a number
        bears = 1.0 if scale > 0.0 else (0.0 if scale == scale else 1.0)
        slack = PLACE_SLACK * l_o
        side = 1.0 if a1 >= 0.0 else -1.0
        wrong = 0.0 if min(side * x1, side * (a1 - x1)) >= -slack else 1.0
        wrong = wrong if x2 > 0.0 else 1.0
        wrong = wrong if approach <= GREATEST_APPROACH * w[_BALL_DIAMETER + i] else 1.0
        unheld = 0.0 if abs(force[0]) + abs(force[1]) <= FRICTION_SLACK * scale else 1.0
        unheld = unheld if scale > 0.0 else 0.0
        unheld = unheld if load == 0.0 else 0.0
        turned = 1.0 if s_i <= LOST_ANGLE else 0.0
        turned *= w[_ONE_SIDED + i]
        inner_edge = turned if c_i > w[_INNER_EDGE + i] else 1.0
        inner_edge = inner_edge if load > 0.0 else 0.0
        outer_edge = 0.0 if c_o > w[_OUTER_EDGE + i] else bears
        w[_UNSOUND + i] = max(w[_UNSOUND + i], max(max(wrong, unheld), max(inner_edge, outer_edge)))

        _take_in(w, i, b[_COS + i], b[_SIN + i], bears, force, stiffness, drive, before)


@filling
def begin_settling(b: Array, balls: int) -> None:
    """Begin to settle the balls in the first lanes; the others are none."""
    for i in range(N):
        b[_KEPT1 + i], b[_KEPT2 + i] = b[_X1 + i], b[_X2 + i]
        b[_ONWARD1 + i], b[_ONWARD2 + i] = 0.0, 0.0
        b[_MISS + i], b[_PART + i] = inf, 1.0
        b[_TRIED + i], b[_TAKEN + i] = 0.0, 0.0
        b[FATE + i] = OPEN if i < balls else FAILED


@filling
def settle_in_lane(w: Array, b: Array, k: Array, near: float) -> None:
    """One trial of `settle`'s Newton's method for each ball that is open still.

    k: how it touches where it is; near: as of `settle`.
    """
    for i in range(N):
        residual, follow, _, _, scale, _, _, _ = _linearised_exact(w, b, k, i)
        trial = sqrt(residual[0] ** 2 + residual[1] ** 2)
        better = 1.0 if trial < b[_MISS + i] else 0.0
        longest = LONGEST * w[_L_O + i]
        length = sqrt(follow[0] * follow[0] + follow[1] * follow[1])
        part = longest / length if length > longest else 1.0
        part = part if better > 0.0 else SHORTENED * b[_PART + i]
        kept1 = b[_X1 + i] if better > 0.0 else b[_KEPT1 + i]
        kept2 = b[_X2 + i] if better > 0.0 else b[_KEPT2 + i]
        onward1 = follow[0] if better > 0.0 else b[_ONWARD1 + i]
        onward2 = follow[1] if better > 0.0 else b[_ONWARD2 + i]
        taken = b[_TAKEN + i] + better
        tried = 0.0 if better > 0.0 else b[_TRIED + i] + 1.0
        rest = trial - near * scale
        there = 1.0 if is_rounding(w[_L_O + i], w[_K_S + i], rest, scale) else 0.0
        there = there if better > 0.0 else 0.0
        fate = FAILED if max(tried - SHORTENINGS, taken - NEWTON_STEPS) >= 0.0 else OPEN
        fate = SETTLED_BALL if there > 0.0 else fate
        open_still = b[FATE + i] == OPEN
        b[_MISS + i] = (trial if better > 0.0 else b[_MISS + i]) if open_still else b[_MISS + i]
        b[_PART + i], b[_TRIED + i], b[_TAKEN + i] = part, tried, taken
        b[_KEPT1 + i] = kept1 if open_still else b[_KEPT1 + i]
        b[_KEPT2 + i] = kept2 if open_still else b[_KEPT2 + i]
        b[_ONWARD1 + i], b[_ONWARD2 + i] = onward1, onward2
        fate = fate if open_still else b[FATE + i]
        b[_X1 + i] = kept1 + part * onward1 if fate == OPEN else b[_KEPT1 + i]
        b[_X2 + i] = kept2 + part * onward2 if fate == OPEN else b[_KEPT2 + i]
        b[FATE + i] = fate


@filling
def sum_settled(w: Array, b: Array, k: Array) -> None:
    """Add up what the settled balls ask of ring and cage, and take each ball's last step.

    One that this takes where no ball can be has failed. k: as of `settle_in_lane`.
    """
    for i in range(N):
        a1, _ = groove_exact(w, b, i)
        _, follow, force, stiffness, scale, touch, drive, before = _linearised_exact(w, b, k, i)
        x1, x2 = b[_X1 + i] + follow[0], b[_X2 + i] + follow[1]
        slack = PLACE_SLACK * w[_L_O + i]
        side = 1.0 if a1 >= 0.0 else -1.0
        placed = 1.0 if min(side * x1, side * (a1 - x1)) >= -slack else 0.0
        placed = placed if x2 > 0.0 else 0.0
        fate = b[FATE + i] if placed > 0.0 else FAILED
        bears = scale if fate == SETTLED_BALL else 0.0
        b[FATE + i] = fate
        b[_X1 + i], b[_X2 + i], b[_Z1 + i], b[_Z2 + i] = x1, x2, follow[6], follow[7]
        b[_W11 + i], b[_W12 + i] = follow[2], follow[3]
        b[_W21 + i], b[_W22 + i] = follow[4], follow[5]
        w[_PRESSED + i] += _if(bears, touch[0])
        w[_HEAVIEST + i] = max(w[_HEAVIEST + i], _if(bears, scale))
        _take_in(w, i, b[_COS + i], b[_SIN + i], bears, force, stiffness, drive, before)


@filling
def judge_balls(w: Array, b: Array, mirror: Mirror, p: Array, k: Array) -> None:
    """Judge all balls, those that have a mirror image first; p, k as of `touch_ball_exact`."""
    start_cage(w, 1.0 if mirror.pairs == 0 else 0.5)
    for j in range(mirror.pairs):
        touch_ball_exact(w, b[j], p, k)
        judge_ball(w, b[j], k)
    if mirror.pairs > 0:
        reflect(w, mirror.factors)
    for j in range(mirror.pairs, b.shape[0]):
        touch_ball_exact(w, b[j], p, k)
        judge_ball(w, b[j], k)


@filling
def weigh_ring(w: Array) -> None:
    """Measure ring and cage as `accept.weigh` does, to the last bit: UNBALANCED.

    The cage is taken out of the ring's reaction and matrix.
    """
    for i in range(N):
        w[_UNBALANCED + i] = 0.0
        w[_LOADED + i] = w[_HEAVIEST + i]
    for row in range(_FIVE):
        force, by_cage = _FX + row * N, _BY_CAGE[0] + row * N
        for i in range(N):
            free, applied = w[_FREE + row * N + i], w[_APPLIED + row * N + i]
            worse = max_with_nan(w[_UNBALANCED + i], abs(applied - w[_NX + row * N + i]))
            more = max(w[_LOADED + i], abs(applied))
            w[_UNBALANCED + i] = worse if free > 0.0 else w[_UNBALANCED + i]
            w[_LOADED + i] = more if free > 0.0 else w[_LOADED + i]
            part = w[by_cage + i] / w[_LAG_BY_CAGE + i]
            w[by_cage + i] = 0.0 if w[_LAG_BY_CAGE + i] == 0.0 else part
            w[force + i] -= w[by_cage + i] * w[_LAG + i]
        for column in range(_FIVE):
            entry = _MATRIX[0] + (row * _FIVE + column) * N
            lag = _LAG_BY_RING[0] + column * N
            for i in range(N):
                w[entry + i] -= w[by_cage + i] * w[lag + i]
    for i in range(N):
        behind = cage_part(w[_LAG_NOW + i], w[_PULL + i], w[_OMEGA_I + i], w[_OMEGA_O + i])
        scale = w[_LOADED + i]
        part = w[_UNBALANCED + i] / (scale if scale > 0.0 else 1.0)
        w[_UNBALANCED + i] = max_with_nan(part, behind)


@filling
def weigh_ball(w: Array, b: Array) -> None:
    """Mark the lanes where this ball's residual might be worse than UNBALANCED."""
    for i in range(N):
        error, scale = b[_ERROR + i], b[_SCALE + i]
        doubtful = 0.0 if error / own_scale(scale, w[_HEAVIEST + i]) <= w[_UNBALANCED + i] else 1.0
        rounds = is_rounding(w[_L_O + i], w[_K_S + i], error, scale)
        w[_DOUBTFUL + i] = max(w[_DOUBTFUL + i], 0.0 if rounds else doubtful)


@inline_fast
def _pressed(w: Array, i: int, x1: float, x2: float) -> Three:
    """A ball's place where it presses on the outer race, as one in motion does; its distance."""
    reach = sqrt(x1 * x1 + x2 * x2)
    least = w[_L_O + i] + LEAST_PRESSED * w[_OUTER_SHARE + i] * w[_INERTIA_APPROACH + i]
    stretch = least / reach if reach < least else 1.0
    return stretch * x1, stretch * x2, reach


@inline_fast
def _inside(w: Array, i: int, a1: float, a2: float, x1: float, x2: float, reach: float) -> Two:
    """How far a ball is inside its place, and how far off the race; below zero outside.

    Its place is between the axis plane and the line of groove centres, at the outer race.
    """
    l_o = w[_L_O + i]
    side = 1.0 if a1 > 0.0 else -1.0
    between = min(side * x1, side * (a1 * x2 - a2 * x1) / l_o) + 0.1 * l_o
    return between, min(1.5 * l_o - reach, reach - 0.8 * l_o)


@vector_loop
def settle_touching_ball(w: Array, b: Array, k: Array) -> None:
    """The same, k how it touches; not where it would go astray."""
    for i in range(N):
        a1, a2 = _groove_fast(w, b, i)
        _, step, _, _, _, _, _, _ = _linearised_fast(w, b, k, i)
        x1, x2, reach = _pressed(w, i, b[_X1 + i] + step[0], b[_X2 + i] + step[1])
        between, near = _inside(w, i, a1, a2, x1, x2, reach)
        stays = min(between, near) > 0.0
        b[_X1 + i] = x1 if stays else b[_X1 + i]
        b[_X2 + i] = x2 if stays else b[_X2 + i]


@filling
def settle_ball(w: Array, b: Array, k: Array) -> None:
    """Move a ball by its own step, ring and cage at rest; k is room for how it touches."""
    touch_ball(w, b, k)
    settle_touching_ball(w, b, k)


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
        x1, x2, reach = _pressed(w, i, b[_X1 + i] + dx1, b[_X2 + i] + dx2)
        # where it was, for what comes after an astray ball
        b[_Q1 + i], b[_Q2 + i] = b[_X1 + i], b[_X2 + i]
        b[_X1 + i], b[_X2 + i] = x1, x2
        a1, a2 = _groove_fast(w, b, i)
        between, near = _inside(w, i, a1, a2, x1, x2, reach)
        # late, only how far it is off the race
        late = w[_CAUTION + i] * w[_STEPS + i] > PATIENCE
        inside = min(w[_L_O + i] if late else between, near)
        b[_LOST_WAY + i] = 0.0 if inside > 0.0 else (2.0 if late else 1.0)
        w[_ASTRAY + i] = max(w[_ASTRAY + i], b[_LOST_WAY + i])


@vector_loop
def measure_cage(w: Array) -> None:
    """How far the cage is from balance, the nominal speed's pull taken in; counts the steps."""
    for i in range(N):
        w[_STEPS + i] += 1.0
        w[_LAG + i] += w[_CAGE_WEIGHT + i] * (w[_NOMINAL + i] - w[_CAGE + i])
        w[_LAG_BY_CAGE + i] -= w[_CAGE_WEIGHT + i]
        speed = abs(w[_OMEGA_I + i]) + abs(w[_OMEGA_O + i])
        w[_BEHIND + i] = abs(w[_LAG + i] / w[_LAG_BY_CAGE + i]) / speed


def _ring(tilting: bool) -> tuple[Any, ...]:
    """Build the passes over the ring of every lane, for rings that tilt and rings that do not.

    The lanes are the outer loop: how many axes there are is known, so that the loops over them are
    written out and a lane's whole system stays in the processor's registers.
    """
    axes = _FIVE if tilting else _THREE
    solve_ring = elimination(int(axes), layout.DEGREES_OF_FREEDOM, layout.MATRIX, layout.STEP)

    @vector_loop
    def measure_ring(w: Array) -> None:
        """How far the ring is from balance; NaN stays NaN."""
        for i in range(N):
            unbalanced, loaded = 0.0, 0.0
            for row in range(axes):
                applied, reaction = w[_APPLIED + row * N + i], w[_FX + row * N + i]
                miss = abs(applied - reaction)
                miss = miss if w[_FREE + row * N + i] > 0.0 else 0.0
                unbalanced = unbalanced if miss <= unbalanced else miss
                loaded = max(loaded, max(abs(applied), abs(reaction)))
            w[_LOADED + i] = loaded
            w[_UNBALANCED + i] = unbalanced / (loaded if loaded > 0.0 else 1.0)

    @vector_loop
    def condense_cage(w: Array) -> None:
        """Let the cage follow the ring: its speed drops out of the ring's force and stiffness.

        As long as the ring is far from balance, or the cage is, its speed is taken as it is.
        """
        for i in range(N):
            near = max(w[_UNBALANCED + i] / LOOSE_CAGE, w[_BEHIND + i] / NEAR_CAGE)
            near = w[_CAUTION + i] * (near if w[_LAG_BY_CAGE + i] < DRIVE else 2.0)
            part = 1.0 / w[_LAG_BY_CAGE + i] if near <= 1.0 else 0.0
            for row in range(axes):
                by_cage = part * w[_BY_CAGE[0] + row * N + i]
                by_cage = by_cage if near <= 1.0 else 0.0
                w[_BY_CAGE[0] + row * N + i] = by_cage
                w[_FX + row * N + i] -= by_cage * w[_LAG + i]
                for column in range(axes):
                    entry = _MATRIX[0] + (row * _FIVE + column) * N
                    w[entry + i] -= by_cage * w[_LAG_BY_RING[0] + column * N + i]

    @vector_loop
    def step_ring(w: Array) -> None:
        """One Newton step of the ring on its free degrees of freedom, not too far.

        Where few balls bear the ring may move freely: no pivot is nearer to zero than the
        stiffness of a light contact.
        """
        for i in range(N):
            for row in range(axes):  # unit rows where it is held
                free = w[_FREE + row * N + i]
                w[_DX + row * N + i] = free * (w[_APPLIED + row * N + i] - w[_FX + row * N + i])
                for column in range(axes):
                    entry = _MATRIX[0] + (row * _FIVE + column) * N
                    unit = 1.0 if row == column else 0.0
                    w[entry + i] = free * w[entry + i] + (1.0 - free) * unit
            reach = w[_L_O + i] + w[_L_I + i]
            solve_ring(w, i, 1.5 * w[_K_S + i] * sqrt(LEAST_APPROACH * reach))
            late = w[_CAUTION + i] * w[_STEPS + i] > PATIENCE
            reach *= LATE_STEP if late else LONGEST_STEP
            step = max(max(abs(w[_DX + i]), abs(w[_DY + i])), abs(w[_DZ + i]))
            part = reach / step if step > reach else 1.0
            for row in range(axes):
                w[_DX + row * N + i] *= part
                w[_UX + row * N + i] += w[_DX + row * N + i]

    @vector_loop
    def step_cage(w: Array) -> None:
        """Take the cage's speed along with the ring's step."""
        for i in range(N):
            lag = w[_LAG + i]
            for row in range(axes):
                lag += w[_LAG_BY_RING[0] + row * N + i] * w[_DX + row * N + i]
            # no ball orbits faster or slower than both rings turn
            slowest = min(w[_OMEGA_I + i], w[_OMEGA_O + i])
            fastest = max(w[_OMEGA_I + i], w[_OMEGA_O + i])
            longest = NEAR_CAGE * (abs(w[_OMEGA_I + i]) + abs(w[_OMEGA_O + i]))
            longest = longest if w[_UNBALANCED + i] <= LOOSE_CAGE else 0.0
            whole = -lag / w[_LAG_BY_CAGE + i]
            change = -lag / min(w[_LAG_BY_CAGE + i], DRIVE)
            change = min(max(change, -longest), longest) if w[_CAUTION + i] > 0.0 else whole
            speed = min(max(w[_CAGE + i] + change, slowest), fastest)
            w[_DCAGE + i] = speed - w[_CAGE + i]
            w[_CAGE + i] = speed

    return measure_ring, condense_cage, step_ring, step_cage


measure_ring, condense_cage, step_ring, step_cage = _ring(tilting=True)


@inline_fast
def _first_place(w: Array, b: Array, i: int) -> Three:
    """A place near equilibrium for a moving ball, whatever its load: X1, X2, and if it is free.

    The two approaches and the distance |A| make a triangle. A ball that the groove centres hardly
    reach (|A| < L_o + L_i) is held up by its centrifugal force at its apex; a heavily loaded
    ball leaves the line of centres only by the turning of its load.
    """
    a1, a2 = _groove_fast(w, b, i)
    c_f = w[_C_F + i]
    stiffness = _seven(w, _K_S, i)
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
    x1, x2 = l_o * (0.0 if beyond else s_o), l_o * (1.0 if beyond else c_o)
    # one that the inner groove does not reach
    out = w[_L_O + i] + share * alone
    gap = max(a2 - out, 0.0)
    free = 1.0 if a1 * a1 + gap * gap < w[_L_I + i] * w[_L_I + i] else 0.0
    return 0.0 if free > 0.0 else x1, out if free > 0.0 else x2, free


@vector_loop
def place_ball(w: Array, b: Array) -> None:
    """Put a moving ball near its equilibrium."""
    for i in range(N):
        b[_X1 + i], b[_X2 + i], _ = _first_place(w, b, i)


@vector_loop
def replace_ball(w: Array, b: Array) -> None:
    """Bring a ball back in the lanes where it has gone astray.

    Near its equilibrium again; where it has been long on its way, it goes round in a circle, and
    takes only a part of its step.
    """
    for i in range(N):
        x1, x2, free = _first_place(w, b, i)
        astray = b[_LOST_WAY + i] - free
        d1, d2 = b[_X1 + i] - b[_Q1 + i], b[_X2 + i] - b[_Q2 + i]
        part = min(SHORT_STEP, LATE_STEP * w[_L_O + i] / sqrt(d1 * d1 + d2 * d2))
        back1 = b[_Q1 + i] + part * d1
        back2 = b[_Q2 + i] + part * d2
        x1 = back1 if astray > 1.0 else x1
        x2 = back2 if astray > 1.0 else x2
        b[_X1 + i] = x1 if b[_LOST_WAY + i] > 0.0 else b[_X1 + i]
        b[_X2 + i] = x2 if b[_LOST_WAY + i] > 0.0 else b[_X2 + i]
        b[_LOST_WAY + i] = 0.0


@vector_loop
def mark_settled(w: Array, tolerance: float) -> None:
    """Write what has become of each lane: 1 where all is at rest, NaN where it is lost, else 0."""
    for i in range(N):
        settled = 1.0 if w[_FAULT + i] <= 0.0 else 0.0
        settled = settled if w[_UNBALANCED + i] <= tolerance else 0.0
        settled = settled if w[_BEHIND + i] <= tolerance else 0.0
        # a step without any stiffness makes NaN of the ring
        lost = w[_CAGE + i] + w[_UX + i] + w[_UY + i] + w[_UZ + i] + w[_UP + i] + w[_UQ + i]
        w[_SETTLED + i] = settled + 0.0 * lost


@inline_exact
def any_astray(w: Array) -> bool:
    """Whether some ball has left its place in some lane."""
    astray = 0.0
    for i in range(N):
        astray = max(astray, w[_ASTRAY + i])
    return astray > 0.0


def _steps(tilting: bool) -> tuple[Any, Any]:
    """Build a whole step of all lanes, for rings that tilt and rings that do not."""
    add_static_ball, add_moving_ball = _balls(tilting, 0.0)
    measure_ring, condense_cage, step_ring, step_cage = _ring(tilting)

    @filling
    def step_static(w: Array, b: Array, mirror: Mirror) -> None:
        """Newton's step of the rings alone, every ball on the line of the groove centres.

        b (balls, layout.BALL_ROWS * LANES). UNBALANCED is how far they were from balance before.
        """
        reset_sums(w)
        for j in range(mirror.pairs):
            add_static_ball(w, b[j])
        if mirror.pairs > 0:
            reflect(w, mirror.factors)
        for j in range(mirror.pairs, b.shape[0]):
            add_static_ball(w, b[j])
        measure_ring(w)
        step_ring(w)

    @filling
    def step_moving(w: Array, b: Array, mirror: Mirror, k: Array, tolerance: float) -> None:
        """Newton's step of rings, cages and balls together.

        k is room for how a ball touches. SETTLED is what they were before it, to a tolerance of all
        residuals.
        """
        reset_sums(w)
        for j in range(mirror.pairs):
            add_moving_ball(w, b[j], k, tolerance)
        if mirror.pairs > 0:
            reflect(w, mirror.factors)
        for j in range(mirror.pairs, b.shape[0]):
            add_moving_ball(w, b[j], k, tolerance)
        measure_ring(w)
        measure_cage(w)
        condense_cage(w)
        step_ring(w)
        step_cage(w)
        for j in range(b.shape[0]):
            follow_ring(w, b[j])
        if any_astray(w):
            for j in range(b.shape[0]):
                replace_ball(w, b[j])
        mark_settled(w, tolerance)

    return step_static, step_moving


step_static, step_moving = _steps(tilting=True)
step_static_untilted, step_moving_untilted = _steps(tilting=False)
