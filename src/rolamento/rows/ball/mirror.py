"""Half the balls of a bearing whose load and ring lie in a plane of symmetry.

Where all that acts on a ring lies in a plane through its axis, and one half of its balls is the
mirror image of the other, so is what they do. The lanes then hold one half, and the balls in the
plane: of each sum over the balls the other half adds the same again, or takes it away.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.rows.ball import layout
from rolamento.rows.ball.problem import Columns, Floats
from rolamento.rows.ball.types import Array, Order

AXES: Final = {1: (1, 4), 2: (2, 3), 3: (1, 4), 4: (2, 3)}
"""Planes, and the axes of the ring that their mirror images turn round: x-z turns y and rz.

The first ball is on the z axis in the first two, x-z and x-y, and half a pitch from it in the
other two, the same planes.
"""
_ROUNDING: Final = 4e-16
"""Rounding of the cosine and sine of an azimuth."""


class Mirror(NamedTuple):
    """Which balls the lanes hold.

    seats (balls in the lanes, 2): each ball and its mirror image, or itself; pairs: how many have
    an image, which come first; factors (layout.SUMS): what the images make of the sums over those,
    twice or nothing; once of what is the greatest of all.
    """

    seats: Order
    pairs: int
    factors: Array


@lru_cache(maxsize=256)
def mirror(balls: int, plane: int) -> Mirror:
    """Half of so many balls and those in the plane; 0 is no plane, and all balls.

    An odd number has no mirror image in x-y.
    """
    own = np.arange(balls)
    if plane == 0:
        return Mirror(np.stack([own, own], axis=1), 0, np.ones(layout.SUMS))
    image = ((0 if _turns_y(plane) else balls // 2) - int(_is_between(plane)) - own) % balls
    seats = np.stack([own, image], axis=1)
    paired, alone = seats[own < image], seats[own == image]
    return Mirror(np.concatenate([paired, alone]), len(paired), _factors(plane))


def _turns_y(plane: int) -> bool:
    """Whether it is x-z."""
    return AXES[plane][0] == 1


def _is_between(plane: int) -> bool:
    """Whether the first ball is half a pitch from the z axis."""
    return plane > 2


def _factors(plane: int) -> Floats:
    sign = np.ones(layout.DEGREES_OF_FREEDOM)
    sign[list(AXES[plane])] = -1.0
    whole = np.ones(layout.REACTION + layout.SUMS)
    for first in (layout.REACTION, layout.NOW, layout.BY_CAGE, layout.LAG_BY_RING):
        whole[first : first + sign.size] = 1.0 + sign
    whole[layout.MATRIX : layout.MATRIX + sign.size**2] = 1.0 + np.outer(sign, sign).ravel()
    whole[[layout.LAG, layout.LAG_NOW, layout.LAG_BY_CAGE, layout.PULL]] = 2.0
    return whole[layout.REACTION :]


def planes(p: Columns, control: Floats) -> NDArray[np.int8]:
    """The plane in which each case is its own mirror image, or 0; control (cases or 1, balls)."""
    balls = control.shape[1]
    found = np.zeros(p.cases, np.int8)
    for plane, (shift, tilt) in AXES.items():
        if not _turns_y(plane) and balls % 2:
            continue
        first = np.pi / balls if _is_between(plane) else 0.0
        own, image = mirror(balls, plane).seats.T
        alike = (control[:, own] == control[:, image]).all(axis=1) & (found == 0)
        for row in (layout.APPLIED, layout.IMPOSED):
            alike &= (p[row + shift] == 0.0) & (p[row + tilt] == 0.0)
        alike &= np.abs(p[layout.SIN_FIRST] - np.sin(first)) <= _ROUNDING
        alike &= np.abs(p[layout.COS_FIRST] - np.cos(first)) <= _ROUNDING
        found[alike] = plane
    return found
