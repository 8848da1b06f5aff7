"""A ring that carries several rows, in lanes: what they ask of it, its step, and theirs.

Each row has a workspace of its own, as `lanes` has it, and stands where the ring holds it:
v = T u + e, with the T of `rolamento.system.ring`. The ring's force is the sum of T' f and its
stiffness that of T' k T. All is scaled as in `layout`, the ring's tilts by an arm of its own.
"""

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np

from rolamento.numerics.compiled import inline_fast, vector_loop
from rolamento.rows.ball import layout
from rolamento.rows.ball.elimination import elimination
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
SMALL_STIFFNESS: Final = MATRIX + UNKNOWNS * UNKNOWNS  # a little stiffness of every free unknown
REACH: Final = SMALL_STIFFNESS + 1  # the longest step
UNBALANCED: Final = REACH + 1  # the greatest unbalanced load, over
LOADED: Final = UNBALANCED + 1  # the greatest of the loads on the ring and of its rows
SETTLED: Final = LOADED + 1  # above zero where all is at rest, NaN where it is lost
SET_ROWS: Final = SETTLED + 1

# --- how a row stands on the ring -------------------------------------------------------------
WAY: Final = 0  # +1, or -1 where it is mirrored
LEVER: Final = 1  # its position along x, over the ring's arm
TILT: Final = 2  # its way times its arm over the ring's
SLIDE: Final = 3  # 1 where springs push its outer ring
STAND_ROWS: Final = 4

_N: Final = np.uintp(layout.LANES)
_FREE, _TARGET, _PLACE, _MOVE = lanes(FREE), lanes(TARGET), lanes(PLACE), lanes(MOVE)
_FORCE, _MATRIX = lanes(FORCE), lanes(MATRIX)
_FIRM, _REACH = lanes(SMALL_STIFFNESS), lanes(REACH)
_UNBALANCED, _LOADED, _SETTLED = lanes(UNBALANCED), lanes(LOADED), lanes(SETTLED)
_WAY, _LEVER, _TILT, _SLIDE = (lanes(row) for row in (WAY, LEVER, TILT, SLIDE))
_SIX, _FIVE = np.uintp(UNKNOWNS), np.uintp(layout.DEGREES_OF_FREEDOM)
_ZERO, _ONE, _TWO, _THREE, _FOUR = (np.uintp(row) for row in range(5))
_AT = tuple(lanes(row) for row in range(UNKNOWNS * UNKNOWNS))
_LINE = lanes(UNKNOWNS)
_ROW_U, _ROW_STEP = lanes(layout.DISPLACEMENT), lanes(layout.STEP)
_ROW_F, _ROW_K = lanes(layout.REACTION), lanes(layout.MATRIX)
_ROW_FAULT, _ROW_BEHIND = lanes(layout.FAULT), lanes(layout.BEHIND)
_ROW_UNBALANCED, _CAGE = lanes(layout.UNBALANCED), lanes(layout.CAGE)
_OF_ROW = lanes(layout.DEGREES_OF_FREEDOM)

_solve_set = elimination(UNKNOWNS, UNKNOWNS, MATRIX, MOVE)


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


@inline_fast
def _add(s: Array, first: np.uintp, stride: np.uintp, i: int, six: Six) -> None:
    """Add six numbers where six stand a stride apart."""
    fourth, fifth = first + _THREE * stride, first + _FOUR * stride
    s[first + i] += six[0]
    s[first + stride + i] += six[1]
    s[first + _TWO * stride + i] += six[2]
    s[fourth + i] += six[3]
    s[fifth + i] += six[4]
    s[fifth + stride + i] += six[5]


@inline_fast
def _by_ring(w: Array, v: Array, row: np.uintp, i: int) -> Six:
    """A line of a row's stiffness, by the ring's unknowns: k T."""
    line: Six = _on_ring(v, i, _five(w, _ROW_K + row * _OF_ROW, _N, i))
    return line


@inline_fast
def _add_column(s: Array, v: Array, i: int, column: int, line: Five) -> None:
    """Add a column of T' (k T) to the ring's stiffness."""
    _add(s, _MATRIX + _AT[column], _LINE, i, _on_ring(v, i, line))


@vector_loop
def add_row(s: Array, v: Array, w: Array) -> None:
    """Add a row's force and stiffness to the ring's."""
    for i in range(_N):
        _add(s, _FORCE, _N, i, _on_ring(v, i, _five(w, _ROW_F, _N, i)))
        k0, k1, k2 = _by_ring(w, v, _ZERO, i), _by_ring(w, v, _ONE, i), _by_ring(w, v, _TWO, i)
        k3, k4 = _by_ring(w, v, _THREE, i), _by_ring(w, v, _FOUR, i)
        _add_column(s, v, i, 0, (k0[0], k1[0], k2[0], k3[0], k4[0]))
        _add_column(s, v, i, 1, (k0[1], k1[1], k2[1], k3[1], k4[1]))
        _add_column(s, v, i, 2, (k0[2], k1[2], k2[2], k3[2], k4[2]))
        _add_column(s, v, i, 3, (k0[3], k1[3], k2[3], k3[3], k4[3]))
        _add_column(s, v, i, 4, (k0[4], k1[4], k2[4], k3[4], k4[4]))
        _add_column(s, v, i, 5, (k0[5], k1[5], k2[5], k3[5], k4[5]))


@vector_loop
def measure_set(s: Array) -> None:
    """Begin to measure how far the rings are from balance; NaN stays NaN."""
    for i in range(_N):
        worst, scale, lost = 0.0, 0.0, 0.0
        for row in range(_SIX):
            free, target = s[_FREE + row * _N + i], s[_TARGET + row * _N + i]
            miss = abs(target - s[_FORCE + row * _N + i])
            miss = miss if free > 0.0 else 0.0
            worst = worst if miss <= worst else miss
            scale = max(scale, abs(target) if free > 0.0 else 0.0)
            lost += s[_PLACE + row * _N + i]
        s[_UNBALANCED + i], s[_LOADED + i], s[_SETTLED + i] = worst, scale, 1.0 + 0.0 * lost


@vector_loop
def measure_row(s: Array, w: Array, tolerance: float) -> None:
    """Take a row into what is measured of its ring: its loads, and whether its balls settled."""
    for i in range(_N):
        scale = s[_LOADED + i]
        for row in range(_FIVE):
            scale = max(scale, abs(w[_ROW_F + row * _N + i]))
        s[_LOADED + i] = scale
        settled = 1.0 if w[_ROW_FAULT + i] <= 0.0 else 0.0
        settled = settled if w[_ROW_BEHIND + i] <= tolerance else 0.0
        s[_SETTLED + i] = s[_SETTLED + i] * settled + 0.0 * w[_CAGE + i]


@vector_loop
def end_measure(s: Array, tolerance: float) -> None:
    """Divide what is unbalanced by the loads: whether the rings are at rest."""
    for i in range(_N):
        scale = s[_LOADED + i]
        unbalanced = s[_UNBALANCED + i] / (scale if scale > 0.0 else 1.0)
        s[_UNBALANCED + i] = unbalanced
        s[_SETTLED + i] *= 1.0 if unbalanced <= tolerance else 0.0


@vector_loop
def tell_row(s: Array, w: Array) -> None:
    """A row is as far from balance as its ring."""
    for i in range(_N):
        w[_ROW_UNBALANCED + i] = s[_UNBALANCED + i]


@vector_loop
def step_set(s: Array) -> None:
    """One Newton step of the ring on its free unknowns, as far as it may go."""
    for i in range(_N):
        for row in range(_SIX):  # unit rows where it is held
            free = s[_FREE + row * _N + i]
            s[_MOVE + row * _N + i] = free * (s[_TARGET + row * _N + i] - s[_FORCE + row * _N + i])
            for column in range(_SIX):
                entry = _MATRIX + (row * _SIX + column) * _N
                unit = 1.0 if row == column else 0.0
                own = s[entry + i] + unit * s[_FIRM + i]
                s[entry + i] = free * own + (1.0 - free) * unit
        _solve_set(s, i, 0.0)
        length = 0.0
        for row in range(_SIX):
            length += s[_MOVE + row * _N + i] ** 2
        part = s[_REACH + i] / max(sqrt(length), s[_REACH + i])
        for row in range(_SIX):
            s[_MOVE + row * _N + i] *= part
            s[_PLACE + row * _N + i] += s[_MOVE + row * _N + i]


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
