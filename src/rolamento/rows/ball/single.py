"""One ball or one case at a time, in exact arithmetic: the plain form of the equations.

`blocks` is fast; this is what it is measured by. A ball is evaluated as `ball` writes it, a
ring by a loop over its balls.
"""

from __future__ import annotations

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from rolamento.numerics.compiled import filling, inline_exact, shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import (
    contact_exact,
    inertia_exact,
    linearised_exact,
    polar_exact,
    stored_polynomial,
    touching_exact,
)
from rolamento.rows.ball.types import (
    Array,
    Cage,
    Linearised,
    Motion,
    Seven,
    Six,
    StaticBall,
    Three,
    Two,
)

OFF_GROOVE: Final = 2.0
"""Size of a ball's control from which on it is off the inner groove: past its edge, not pressed."""
FAR: Final = 1e9  # m
EPSILON: Final = 2.3e-16
LOAD_FLOOR: Final = 1e-6  # of the heaviest ball: below it a ball's own load is no scale


class Ring(NamedTuple):
    """What the balls of a case ask of its ring and its cage, summed up.

    reaction (5,) and matrix (5, 5): force, and its derivative by the ring's displacement, with
    the balls following; now (5,): the force before any step. by_cage (5,): the derivative by the
    cage's speed. lag (1,): how far the cage is behind its drive, the sum of h Q_i (ω_own - ω);
    lag_by_ring (5,), lag_by_cage (1,): its derivatives; pull (1,): the sum of h Q_i. load (1,):
    the sum of Q_i.
    follow (balls, 6): W by rows and z, with which a ball follows its groove and the cage.
    work (1,): evaluations of a ball that may still be spent.
    w (layout.RING_ROWS * LANES), b (blocks, layout.SETTLING_ROWS * LANES), k (layout.TOUCH_ROWS *
    LANES), left (balls,): room for balls that are settled side by side; no blocks elsewhere.
    """

    reaction: Array
    matrix: Array
    by_cage: Array
    lag: Array
    lag_by_ring: Array
    lag_by_cage: Array
    pull: Array
    load: Array
    now: Array
    follow: Array
    work: Array
    w: Array
    b: Array
    k: Array
    left: Array


class OneCase(NamedTuple):
    """One case, as the exact kernels take it.

    p: parameters, of which `case` is a column. moving: whether the balls have inertia. control,
    cosines, sines (balls,): what guides each ball, and where it stands from the first. u (5,): the
    ring's place, scaled, and x (balls, 2) the balls', both changed in place. ring, errors (balls,
    2): room for the sums and for the balls' residuals.
    """

    p: Array
    case: int
    moving: bool
    control: Array
    cosines: Array
    sines: Array
    u: Array
    x: Array
    ring: Ring
    errors: Array


@shared
def ring_around(balls: int, abreast: bool) -> Ring:
    """Make room for the sums over so many balls, and to settle them side by side or not."""
    lanes = layout.LANES
    blocks = (balls + lanes - 1) // lanes if abreast else 0
    return Ring(
        np.zeros(5), np.zeros((5, 5)), np.zeros(5), np.zeros(1), np.zeros(5), np.zeros(1),
        np.zeros(1), np.zeros(1), np.zeros(5), np.zeros((balls, 6)), np.zeros(1),
        np.zeros(layout.RING_ROWS * lanes if abreast else 0),
        np.zeros((blocks, layout.SETTLING_ROWS * lanes)),
        np.zeros(layout.TOUCH_ROWS * lanes), np.zeros(balls),
    )  # fmt: skip


@filling
def empty_ring(p: Array, case: int, cage: float, ring: Ring) -> None:
    """Set the sums to zero, the nominal speed's pull on the cage taken in."""
    ring.reaction[:] = 0.0
    ring.now[:] = 0.0
    ring.matrix[:] = 0.0
    ring.by_cage[:] = 0.0
    ring.lag_by_ring[:] = 0.0
    pull = p[layout.CAGE_WEIGHT, case]
    ring.lag[0] = pull * (p[layout.NOMINAL_ORBIT, case] - cage)
    ring.lag_by_cage[0] = -pull
    ring.pull[0] = pull
    ring.load[0] = 0.0


@inline_exact
def inner_length(p: Array, case: int, control: float) -> float:
    """Free length of the inner contact; an inner groove that the ball has left touches nothing."""
    length: float = p[layout.INNER_LENGTH, case]
    return length if abs(control) < OFF_GROOVE else FAR


@inline_exact
def rolling(p: Array, case: int, cage: float, control: float) -> tuple[Motion, Cage, float, float]:
    """What `ball.inertia` takes of a case: motion, cage, which race controls the ball, lambda_i.

    The sign of `control` names the race; its size shows whether the ball is off the inner groove.
    """
    motion = (
        p[layout.GAMMA, case], p[layout.CENTRIFUGAL, case], p[layout.GYROSCOPIC, case],
        p[layout.INNER_SPEED, case], p[layout.OUTER_SPEED, case], p[layout.FRICTION_ARM, case],
    )  # fmt: skip
    handing_over = (
        cage, p[layout.HOLD_RATE, case], p[layout.HOLD_OFFSET, case], p[layout.OWN_ORBIT, case],
    )  # fmt: skip
    if control > 0.0:
        return motion, handing_over, 1.0, p[layout.LAMBDA_INNER, case]
    return motion, handing_over, -1.0, 2.0


@inline_exact
def direction(p: Array, case: int, cosine: float, sine: float) -> Two:
    """Cos and sin of a ball's azimuth, the first ball's taken in."""
    c0, s0 = p[layout.COS_FIRST, case], p[layout.SIN_FIRST, case]
    return cosine * c0 - sine * s0, sine * c0 + cosine * s0


@inline_exact
def groove(p: Array, case: int, u: Array, c: float, s: float) -> Two:
    """A1, A2: the inner groove's centre at azimuth (c, s), for the ring's displacement u."""
    a1 = p[layout.AXIAL_OFFSET, case] + u[0] + c * u[3] - s * u[4]
    a2 = p[layout.RADIAL_OFFSET, case] + c * u[2] + s * u[1]
    return a1, a2


@filling
def balance_along(
    p: Array, case: int, cage: float, control: float, a1: float, a2: float, x1: float, x2: float
) -> Three:
    """The residual of a ball along its outer normal and across it, and its F_c."""
    inner = (inner_length(p, case, control), (p, layout.INNER_STIFFNESS, case))
    outer = (p[layout.OUTER_LENGTH, case], (p, layout.OUTER_STIFFNESS, case))
    motion, handing_over, sigma, share = rolling(p, case, cage, control)
    touch = touching_exact(a1, a2, x1, x2, inner, outer, motion, sigma)
    force, turning, _ = inertia_exact(touch, motion, handing_over, sigma)
    s_i, c_i, _, _, q_i, _, _ = touch[0]
    s_o, c_o, _, _, q_o, _, _ = touch[1]
    at_i, at_o = share * turning[0], (2.0 - share) * turning[0]
    cosine = c_i * c_o + s_i * s_o
    sine = s_i * c_o - c_i * s_o
    along = q_i * cosine + at_i * sine - q_o + force[0] * c_o
    across = q_i * sine - at_i * cosine + at_o - force[0] * s_o
    return along, across, force[0]


@filling
def linearised(
    p: Array, case: int, cage: float, control: float, a1: float, a2: float, x1: float, x2: float
) -> Linearised:
    """`ball.linearised` for a ball of a case."""
    inner = (inner_length(p, case, control), (p, layout.INNER_STIFFNESS, case))
    outer = (p[layout.OUTER_LENGTH, case], (p, layout.OUTER_STIFFNESS, case))
    motion, handing_over, sigma, share = rolling(p, case, cage, control)
    touch = touching_exact(a1, a2, x1, x2, inner, outer, motion, sigma)
    ball: Linearised = linearised_exact(touch, motion, handing_over, sigma, share)
    return ball


@filling
def static_ball(p: Array, case: int, control: float, a1: float, a2: float) -> StaticBall:
    """A ball without inertia: its place X1, X2, then as of `linearised` from the force on.

    One that is not pressed stands amid its gap, where it touches neither groove; one that is off
    the inner groove at the centre of the outer.
    """
    inner = (inner_length(p, case, control), (p, layout.INNER_STIFFNESS, case))
    outer = (p[layout.OUTER_LENGTH, case], (p, layout.OUTER_STIFFNESS, case))
    series = (p, layout.SERIES_STIFFNESS, case)
    free = inner[0] + outer[0]
    s, c, v, delta, q, kn, ka = contact_exact(a1, a2, free, series)
    k11, k12, k21, k22 = polar_exact(s, c, kn, ka * v, 0.0, q * v)
    force, stiffness = (q * s, q * c, q * s), (k11, k12, k21, k22, k11, k12)
    touch = (q, c, c, delta, s)
    if abs(control) >= OFF_GROOVE:
        return 0.0, 0.0, force, stiffness, q, touch
    if q == 0.0:
        far = max(free, sqrt(a1 * a1 + a2 * a2))
        return a1 * outer[0] / free, a2 * outer[0] / far, force, stiffness, q, touch
    outer_stiffness, _ = stored_polynomial(c, outer[1])
    reach: float = outer[0] + (q / outer_stiffness) ** (2.0 / 3.0)
    return s * reach, c * reach, force, stiffness, q, touch


@inline_exact
def add_force(total: Array, c: float, s: float, force: Three) -> None:
    """Add one ball's force and moment to the ring's."""
    f1, f2, h = force
    total[0] += f1
    total[1] += s * f2
    total[2] += c * f2
    total[3] += c * h
    total[4] -= s * h


@filling
def add_to_ring(ring: Ring, c: float, s: float, force: Three, stiffness: Six) -> None:
    """Add one ball's force and stiffness to the ring's (as lanes._add_to_ring does)."""
    k11, k12, k21, k22, h1, h2 = stiffness
    by_a1 = (k11, s * k21, c * k21, c * h1, -s * h1)
    by_a2 = (k12, s * k22, c * k22, c * h2, -s * h2)
    add_force(ring.reaction, c, s, force)
    for i in range(layout.DEGREES_OF_FREEDOM):
        row = ring.matrix[i]
        row[0] += by_a1[i]
        row[1] += s * by_a2[i]
        row[2] += c * by_a2[i]
        row[3] += c * by_a1[i]
        row[4] -= s * by_a1[i]


@filling
def add_to_cage(ring: Ring, c: float, s: float, pull: float, drive: Seven) -> None:
    """Add what the cage's speed does to one ball, and the ball to the cage's balance."""
    c1, c2, hc, lag, lag1, lag2, lag_c = drive
    ring.by_cage[0] += c1
    ring.by_cage[1] += s * c2
    ring.by_cage[2] += c * c2
    ring.by_cage[3] += c * hc
    ring.by_cage[4] -= s * hc
    ring.lag[0] += lag
    ring.lag_by_ring[0] += lag1
    ring.lag_by_ring[1] += s * lag2
    ring.lag_by_ring[2] += c * lag2
    ring.lag_by_ring[3] += c * lag1
    ring.lag_by_ring[4] -= s * lag1
    ring.lag_by_cage[0] += lag_c
    ring.pull[0] += pull


@filling
def condense_cage(ring: Ring) -> None:
    """Let the cage follow the ring: its speed drops out of the ring's force and stiffness."""
    if ring.lag_by_cage[0] == 0.0:
        return
    for i in range(layout.DEGREES_OF_FREEDOM):
        part = ring.by_cage[i] / ring.lag_by_cage[0]
        ring.reaction[i] -= part * ring.lag[0]
        for j in range(layout.DEGREES_OF_FREEDOM):
            ring.matrix[i, j] -= part * ring.lag_by_ring[j]


@inline_exact
def arm_of(axis: int, arm: float) -> float:
    """What turns a ring's scaled load of an axis into N or N·m."""
    return 1.0 if axis < layout.SHIFTS else arm


@filling
def read_ring(ring: Ring, arm: float, reaction: Array, stiffness: Array) -> None:
    """Write reaction (5,) and stiffness (5, 5) in SI; arm: R_i."""
    for i in range(layout.DEGREES_OF_FREEDOM):
        reaction[i] = arm_of(i, arm) * ring.reaction[i]
        for j in range(layout.DEGREES_OF_FREEDOM):
            stiffness[i, j] = arm_of(i, arm) * arm_of(j, arm) * ring.matrix[i, j]


@inline_exact
def cage_part(lag: float, pull: float, inner_speed: float, outer_speed: float) -> float:
    """How far the cage is from the mean of its drives, as a part of a ball's F_c, about."""
    scale = pull * (0.1 * (abs(inner_speed) + abs(outer_speed)))
    return abs(lag) / scale if scale > 0.0 else 0.0


@inline_exact
def changes_groove(
    off: bool, a1: float, a2: float, x1: float, x2: float, inner_length: float
) -> bool:
    """Whether a ball leaves the inner groove, pressed beyond its end, or comes back to it."""
    beyond = a2 <= x2
    pressed = abs(a1 - x1) > inner_length
    return not beyond if off else beyond and pressed


@inline_exact
def rounding(p: Array, case: int, load: float) -> float:
    """What rounding leaves of a ball's load Q, N.

    It turns on an approach (Q / K)^(2/3), which is known to a few units in the last place of the
    distance between ball and groove centre.
    """
    length: float = p[layout.OUTER_LENGTH, case]
    stiffness = p[layout.SERIES_STIFFNESS, case]
    slope: float = 1.5 * (stiffness * stiffness * load) ** (1.0 / 3.0)
    return 4.0 * EPSILON * length * slope


@inline_exact
def is_rounding(length: float, stiffness: float, error: float, load: float) -> bool:
    """Whether `rounding` is all of a ball's residual, N, found without a root.

    length: L_o; stiffness: of both contacts in series.
    """
    unit = 6.0 * EPSILON * length
    return error * error * error <= unit * unit * unit * stiffness * stiffness * load
