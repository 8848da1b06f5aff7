"""A ring that carries several rows, in lanes: what they ask of it, its step, and theirs.

Each row has a workspace of its own, as `lanes` has it, and stands where the ring holds it:
v = T u + e, with the T of `rolamento.assembly.ring`. The ring's force is the sum of T' f and its
stiffness that of T' k T. All is scaled as in `layout`, the ring's tilts by an arm of its own.
"""

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np

from rolamento.numerics.compiled import inline_fast, vector_loop
from rolamento.rows.ball import layout
from rolamento.rows.ball.layout import lanes
from rolamento.rows.ball.types import Array, Five, Six

UNKNOWNS: Final = 6

# --- the ring's workspace ---------------------------------------------------------------------
FREE: Final = 0  # 1 where the load is given
TARGET: Final = FREE + UNKNOWNS  # that load
PLACE: Final = TARGET + UNKNOWNS
MOVE: Final = PLACE + UNKNOWNS  # its step
FORCE: Final = MOVE + UNKNOWNS
MATRIX: Final = FORCE + UNKNOWNS
FIRM: Final = MATRIX + UNKNOWNS * UNKNOWNS  # a little stiffness of every free unknown
REACH: Final = FIRM + 1  # the longest step
SET_ROWS: Final = REACH + 1

# --- how a row stands on the ring -------------------------------------------------------------
WAY: Final = 0  # +1, or -1 where it is mirrored
LEVER: Final = 1  # its position along x, over the ring's arm
TILT: Final = 2  # its way times its arm over the ring's
SLIDE: Final = 3  # 1 where springs push its outer ring
STAND_ROWS: Final = 4

_N: Final = np.uintp(layout.LANES)
_FREE, _TARGET, _PLACE, _MOVE = lanes(FREE), lanes(TARGET), lanes(PLACE), lanes(MOVE)
_FORCE, _MATRIX = lanes(FORCE), lanes(MATRIX)
_FIRM, _REACH = lanes(FIRM), lanes(REACH)
_WAY, _LEVER, _TILT, _SLIDE = (lanes(row) for row in (WAY, LEVER, TILT, SLIDE))
_SIX, _FIVE = np.uintp(UNKNOWNS), np.uintp(layout.DEGREES_OF_FREEDOM)
_ONE, _TWO = np.uintp(1), np.uintp(2)
_AT = tuple(lanes(row) for row in range(UNKNOWNS * UNKNOWNS))
_LINE = lanes(UNKNOWNS)
_ROW_U, _ROW_STEP = lanes(layout.DISPLACEMENT), lanes(layout.STEP)
_ROW_F, _ROW_K = lanes(layout.REACTION), lanes(layout.MATRIX)
_OF_ROW = lanes(layout.DEGREES_OF_FREEDOM)


@vector_loop
def empty_set(s: Array) -> None:
    """Empty the sums over the rows."""
    for i in range(_FORCE, _FIRM):
        s[i] = 0.0


@inline_fast
def _on_ring(v: Array, i: int, row: Five) -> Six:
    """T' times five numbers of a row: what they are to the ring's unknowns."""
    r0, r1, r2, r3, r4 = row
    way, lever, tilt, slide = v[_WAY + i], v[_LEVER + i], v[_TILT + i], v[_SLIDE + i]
    return way * r0, r1, r2, tilt * r3 - lever * r2, tilt * r4 + lever * r1, slide * r0


@inline_fast
def _five(a: Array, first: np.uintp, stride: np.uintp, i: int) -> Five:
    """Five numbers that stand a stride apart."""
    second = first + stride
    third, fourth = second + stride, second + _TWO * stride
    return a[first + i], a[second + i], a[third + i], a[fourth + i], a[fourth + stride + i]


@vector_loop
def add_row(s: Array, v: Array, w: Array, t: Array) -> None:
    """Add a row's force and stiffness to the ring's; t: room for k T."""
    for i in range(_N):
        f0, f1, f2, f3, f4, f5 = _on_ring(v, i, _five(w, _ROW_F, _N, i))
        s[_FORCE + i] += f0
        s[_FORCE + _AT[1] + i] += f1
        s[_FORCE + _AT[2] + i] += f2
        s[_FORCE + _AT[3] + i] += f3
        s[_FORCE + _AT[4] + i] += f4
        s[_FORCE + _AT[5] + i] += f5
    for row in range(_FIVE):
        own, to = _ROW_K + row * _OF_ROW, row * _LINE
        for i in range(_N):
            k0, k1, k2, k3, k4, k5 = _on_ring(v, i, _five(w, own, _N, i))
            t[to + i] = k0
            t[to + _AT[1] + i] = k1
            t[to + _AT[2] + i] = k2
            t[to + _AT[3] + i] = k3
            t[to + _AT[4] + i] = k4
            t[to + _AT[5] + i] = k5
    for column in range(_SIX):
        to = _MATRIX + column * _N
        for i in range(_N):
            k0, k1, k2, k3, k4, k5 = _on_ring(v, i, _five(t, column * _N, _LINE, i))
            s[to + i] += k0
            s[to + _AT[6] + i] += k1
            s[to + _AT[12] + i] += k2
            s[to + _AT[18] + i] += k3
            s[to + _AT[24] + i] += k4
            s[to + _AT[30] + i] += k5


@vector_loop
def _hold(s: Array) -> None:
    """Set up the ring's equations: the unbalanced load, and unit rows where it is held."""
    for row in range(_SIX):
        for i in range(_N):
            free = s[_FREE + row * _N + i]
            s[_MOVE + row * _N + i] = free * (s[_TARGET + row * _N + i] - s[_FORCE + row * _N + i])
        for column in range(_SIX):
            entry = _MATRIX + (row * _SIX + column) * _N
            unit = 1.0 if row == column else 0.0
            for i in range(_N):
                free = s[_FREE + row * _N + i]
                own = s[entry + i] + unit * s[_FIRM + i]
                s[entry + i] = free * own + (1.0 - free) * unit


@vector_loop
def _eliminate(s: Array) -> None:
    """Gauss's elimination and back substitution, the solution in place of the right side."""
    for pivot in range(_SIX):
        diagonal = _MATRIX + (pivot * _SIX + pivot) * _N
        for row in range(pivot + _ONE, _SIX):
            below = _MATRIX + (row * _SIX + pivot) * _N
            for i in range(_N):
                s[below + i] /= s[diagonal + i]
            for column in range(pivot + _ONE, _SIX):
                target = _MATRIX + (row * _SIX + column) * _N
                source = _MATRIX + (pivot * _SIX + column) * _N
                for i in range(_N):
                    s[target + i] -= s[below + i] * s[source + i]
            for i in range(_N):
                s[_MOVE + row * _N + i] -= s[below + i] * s[_MOVE + pivot * _N + i]
    for back in range(_SIX):
        up = _SIX - _ONE - back
        for column in range(up + _ONE, _SIX):
            entry = _MATRIX + (up * _SIX + column) * _N
            for i in range(_N):
                s[_MOVE + up * _N + i] -= s[entry + i] * s[_MOVE + column * _N + i]
        diagonal = _MATRIX + (up * _SIX + up) * _N
        for i in range(_N):
            s[_MOVE + up * _N + i] /= s[diagonal + i]


@vector_loop
def step_set(s: Array) -> None:
    """One Newton step of the ring on its free unknowns, as far as it may go."""
    _hold(s)
    _eliminate(s)
    for i in range(_N):
        x, y, z = s[_MOVE + i], s[_MOVE + _AT[1] + i], s[_MOVE + _AT[2] + i]
        p, q, slide = s[_MOVE + _AT[3] + i], s[_MOVE + _AT[4] + i], s[_MOVE + _AT[5] + i]
        length = sqrt(x * x + y * y + z * z + p * p + q * q + slide * slide)
        part = s[_REACH + i] / max(length, s[_REACH + i])
        s[_MOVE + i] = part * x
        s[_MOVE + _AT[1] + i] = part * y
        s[_MOVE + _AT[2] + i] = part * z
        s[_MOVE + _AT[3] + i] = part * p
        s[_MOVE + _AT[4] + i] = part * q
        s[_MOVE + _AT[5] + i] = part * slide
    for i in range(_SIX * _N):
        s[_PLACE + i] += s[_MOVE + i]


@vector_loop
def move_row(s: Array, v: Array, w: Array) -> None:
    """Take a row along with the ring."""
    for i in range(_N):
        way, lever, tilt = v[_WAY + i], v[_LEVER + i], v[_TILT + i]
        p, q = s[_MOVE + _AT[3] + i], s[_MOVE + _AT[4] + i]
        w[_ROW_STEP + i] = way * s[_MOVE + i] + v[_SLIDE + i] * s[_MOVE + _AT[5] + i]
        w[_ROW_STEP + _AT[1] + i] = s[_MOVE + _AT[1] + i] + lever * q
        w[_ROW_STEP + _AT[2] + i] = s[_MOVE + _AT[2] + i] - lever * p
        w[_ROW_STEP + _AT[3] + i] = tilt * p
        w[_ROW_STEP + _AT[4] + i] = tilt * q
    for i in range(_FIVE * _N):
        w[_ROW_U + i] += w[_ROW_STEP + i]
