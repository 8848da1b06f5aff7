"""The balls of one case settled side by side, in lanes: what `settle` does first, for all of them.

The same Newton's method to the last bit, a ball a lane, and what settled is summed up there. A ball
that it fails is left to `settle.settle_otherwise`.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics.compiled import filling, inline_exact
from rolamento.rows.ball import lanes, layout
from rolamento.rows.ball.blocks import put_ball, put_displacement, put_numbers, put_position
from rolamento.rows.ball.settle import NEWTON_STEPS, SHORTENINGS
from rolamento.rows.ball.single import FAR, OFF_GROOVE, OneCase
from rolamento.rows.ball.types import Array

_LANES: Final = layout.LANES
_N: Final = np.uintp(layout.LANES)
COST: Final = 2.0
"""Evaluations of a ball one by one that take as long as one of all lanes."""
SUMMING: Final = 8.0
"""And as long as to fill the lanes, to add up over them, and the ring's step."""


@filling
def fill(one: OneCase) -> None:
    """Put a case into all lanes, and its balls into one each; the last lanes are left empty."""
    w, b, p = one.ring.w, one.ring.b, one.p
    for lane in range(_LANES):
        put_numbers(w, 0, lane, p, one.case)
    for block in range(b.shape[0]):
        for lane in range(_LANES):
            j = min(block * _LANES + lane, one.control.size - 1)
            sigma = 1.0 if one.control[j] > 0.0 else -1.0
            put_ball(w, b[block], lane, one.cosines[j], one.sines[j], sigma)
            if abs(one.control[j]) >= OFF_GROOVE:
                b[block, layout.OFF * _LANES + lane] = FAR


@inline_exact
def _is_open(b: Array) -> bool:
    """Whether a ball of the block neither settled nor failed."""
    open_still = 0.0
    for i in range(_N):
        open_still = max(open_still, 1.0 if b[lanes.FATE + i] == lanes.OPEN else 0.0)
    return open_still > 0.0


@filling
def settle_abreast(one: OneCase, cage: float, near: float) -> float:
    """Settle the balls that Newton's method settles; add up what they ask of ring and cage.

    near: as of `settle`. Writes x and ring.follow of those; ring.left (balls,) is above zero where
    a ball is left. Returns the greatest load of a ball.
    """
    p, ring, u, x = one.p, one.ring, one.u, one.x
    w, b, k, balls = ring.w, ring.b, ring.k, one.cosines.size
    for lane in range(_LANES):
        put_displacement(w, lane, u)
        w[layout.CAGE * _LANES + lane] = cage
    lanes.reset_sums(w)
    ring.work[0] -= SUMMING
    bearing = p[layout.DUTY :]
    for block in range(b.shape[0]):
        own, first = b[block], block * _LANES
        for lane in range(_LANES):
            put_position(own, lane, x, min(first + lane, balls - 1))
        lanes.begin_settling(own, min(balls - first, _LANES))
        passes = 0
        while _is_open(own) and passes < NEWTON_STEPS * (SHORTENINGS + 1):
            lanes.touch_ball_exact(w, own, bearing, k)
            lanes.settle_in_lane(w, own, k, near)
            passes += 1
        lanes.touch_ball_exact(w, own, bearing, k)
        lanes.sum_settled(w, own, k)
        ring.work[0] -= COST * (passes + 1)
        for lane in range(min(balls - first, _LANES)):
            j = first + lane
            ring.left[j] = own[lanes.FATE + np.uintp(lane)] - lanes.SETTLED_BALL
            if ring.left[j] == 0.0:
                x[j, 0] = own[layout.POSITION * _LANES + lane]
                x[j, 1] = own[(layout.POSITION + 1) * _LANES + lane]
                for i in range(6):
                    ring.follow[j, i] = own[(layout.FOLLOW + 2 + i) * _LANES + lane]
    return _take(one)


@filling
def _take(one: OneCase) -> float:
    """Add the sums over the lanes to the ring's; the greatest load of a ball."""
    ring, w = one.ring, one.ring.w
    greatest: float = w[layout.HEAVIEST * _LANES]
    for lane in range(1, _LANES):
        greatest = max(greatest, w[layout.HEAVIEST * _LANES + lane])
        for row in range(layout.REACTION, layout.REACTION + layout.SUMS):
            w[row * _LANES] += w[row * _LANES + lane]
    for i in range(layout.DEGREES_OF_FREEDOM):
        ring.reaction[i] += w[(layout.REACTION + i) * _LANES]
        ring.by_cage[i] += w[(layout.BY_CAGE + i) * _LANES]
        ring.lag_by_ring[i] += w[(layout.LAG_BY_RING + i) * _LANES]
        for j in range(layout.DEGREES_OF_FREEDOM):
            row = layout.MATRIX + layout.DEGREES_OF_FREEDOM * i + j
            ring.matrix[i, j] += w[row * _LANES]
    ring.lag[0] += w[layout.LAG * _LANES]
    ring.lag_by_cage[0] += w[layout.LAG_BY_CAGE * _LANES]
    ring.pull[0] += w[layout.PULL * _LANES]
    ring.load[0] += w[layout.PRESSED * _LANES]
    return greatest
