"""The fast path, case by case: fill the lanes, start, iterate, hand over.

What comes out is a proposal: `accept` checks every case in exact arithmetic, and `robust`
solves what was not proposed or not accepted.
"""

from __future__ import annotations

from math import sqrt
from typing import Final

import numpy as np

from rolamento.numerics.compiled import inline_exact, shared
from rolamento.rows.ball import lanes, layout
from rolamento.rows.ball.types import Array, Three

STATIC_STEPS: Final = 10
MOVING_STEPS: Final = 30
START_TOLERANCE: Final = 1e-2  # of a static start for a moving bearing
TOLERANCE: Final = 1e-5  # before the last step, which squares it

_LANES: Final = layout.LANES
_X: Final = layout.POSITION * _LANES


@inline_exact
def _over_penetration(p: Array, case: int, ball_count: int) -> Three:
    """A displacement x, y, z at which the heaviest ball carries more than its load.

    The potential of the contacts is convex: from the loaded side Newton's method comes down to
    the solution, from the unloaded side it overshoots.
    """
    length = p[layout.OUTER_LENGTH, case] + p[layout.INNER_LENGTH, case]
    a1, a2 = p[layout.AXIAL_OFFSET, case], p[layout.RADIAL_OFFSET, case]
    fx, fy, fz = p[layout.APPLIED, case], p[layout.APPLIED + 1, case], p[layout.APPLIED + 2, case]
    my, mz = p[layout.APPLIED + 3, case], p[layout.APPLIED + 4, case]
    stiffness = p[layout.SERIES_STIFFNESS, case] * ball_count
    radial = sqrt(fy * fy + fz * fz)
    toward_y = fy / radial if radial > 0.0 else 0.0
    toward_z = fz / radial if radial > 0.0 else 0.0
    tilt = toward_z * p[layout.IMPOSED + 3, case] - toward_y * p[layout.IMPOSED + 4, case]
    sine = sqrt(max(length * length - a2 * a2, 0.0)) / length

    if abs(fx) * a2 < radial * sine * length:
        # few balls carry, at the angle of the load itself
        load = sqrt(fx * fx + radial * radial)
        reach = length + (4.5 * load / stiffness) ** (2.0 / 3.0)
        x = reach * fx / load - a1 - tilt
        away = reach * radial / load - a2
    else:
        axial = (abs(fx) + 2.0 * sqrt(my * my + mz * mz)) / max(sine, 0.2)
        reach = length + (axial / stiffness) ** (2.0 / 3.0)
        x = sqrt(max(reach * reach - a2 * a2, 0.0)) * (1.0 if fx > 0.0 else -1.0) - a1
        away = (4.5 * radial / stiffness) ** (2.0 / 3.0)
    if fx == 0.0 or (fx < 0.0 and p[layout.ONE_SIDED, case] > 0.0):
        x = 0.0
    return x, away * toward_y, away * toward_z


@shared
def start(p: Array, case: int, ball_count: int, u: Array) -> None:
    """Write a first displacement of the ring: as held, or so that the balls carry too much."""
    column = case if p.shape[1] > 1 else 0
    x, y, z = _over_penetration(p, column, ball_count)
    guess = (x, y, z, 0.0, 0.0)
    for i in range(layout.DEGREES_OF_FREEDOM):
        free = p[layout.FREE + i, column] > 0.0
        u[i] = guess[i] if free else p[layout.IMPOSED + i, column]


@inline_exact
def fill(
    w: Array,
    b: Array,
    lane: int,
    p: Array,
    cosines: Array,
    sines: Array,
    control: Array,
    case: int,
    u: Array,
) -> None:
    """Put a case into a lane, its ring at u."""
    column = case if p.shape[1] > 1 else 0
    for row in range(layout.PARAMETERS):
        w[row * _LANES + lane] = p[row, column]
    for i in range(layout.DEGREES_OF_FREEDOM):
        w[(layout.DISPLACEMENT + i) * _LANES + lane] = u[i]
    series, outer = p[layout.SERIES_STIFFNESS, column], p[layout.OUTER_STIFFNESS, column]
    speed = p[layout.NOMINAL_ORBIT, column]
    w[layout.CAGE * _LANES + lane] = speed
    inertia = p[layout.CENTRIFUGAL, column] * speed * speed
    w[layout.OUTER_SHARE * _LANES + lane] = (series / outer) ** (2.0 / 3.0)
    w[layout.INERTIA_APPROACH * _LANES + lane] = (inertia / series) ** (2.0 / 3.0)
    c0, s0 = p[layout.COS_FIRST, column], p[layout.SIN_FIRST, column]
    sigmas = case if control.shape[0] > 1 else 0
    for j in range(cosines.size):
        sigma = control[sigmas, j]
        b[j, layout.COS * _LANES + lane] = cosines[j] * c0 - sines[j] * s0
        b[j, layout.SIN * _LANES + lane] = sines[j] * c0 + cosines[j] * s0
        b[j, layout.SIGMA * _LANES + lane] = sigma
        b[j, layout.LAMBDA * _LANES + lane] = p[layout.LAMBDA_INNER, column] if sigma > 0 else 2.0


@inline_exact
def _read_displacement(w: Array, lane: int, u: Array) -> None:
    for i in range(layout.DEGREES_OF_FREEDOM):
        u[i] = w[(layout.DISPLACEMENT + i) * _LANES + lane]


@inline_exact
def _unbalanced(w: Array, lane: int) -> float:
    """The ring's greatest unbalanced load, over the scale of its loads; NaN stays NaN."""
    worst = 0.0
    scale = 0.0
    for i in range(layout.DEGREES_OF_FREEDOM):
        applied = w[(layout.APPLIED + i) * _LANES + lane]
        reaction = w[(layout.REACTION + i) * _LANES + lane]
        scale = max(scale, abs(applied), abs(reaction))
        if w[(layout.FREE + i) * _LANES + lane] > 0.0:
            miss = abs(applied - reaction)
            worst = miss if not miss <= worst else worst
    return worst / scale if scale > 0.0 else worst


@inline_exact
def behind(w: Array, lane: int) -> float:
    """What the cage is behind its drive, over the rings' speeds; NaN stays NaN."""
    speed = abs(w[layout.INNER_SPEED * _LANES + lane]) + abs(w[layout.OUTER_SPEED * _LANES + lane])
    lag = w[layout.LAG * _LANES + lane] / w[layout.LAG_BY_CAGE * _LANES + lane]
    return float(abs(lag) / speed)


@inline_exact
def _lost(w: Array, lane: int) -> bool:
    """Whether a lane's ring has gone to NaN, as after a step without any stiffness."""
    total = w[layout.CAGE * _LANES + lane]
    for i in range(layout.DEGREES_OF_FREEDOM):
        total += w[(layout.DISPLACEMENT + i) * _LANES + lane]
    return bool(total != total)


@inline_exact
def any_astray(w: Array) -> bool:
    """Whether the ball just moved has left its place in some lane."""
    astray = 0.0
    for i in range(layout.ASTRAY * _LANES, (layout.ASTRAY + 1) * _LANES):
        astray = max(astray, w[i])
    return astray > 0.0


@shared
def solve_static(
    p: Array,
    control: Array,
    cosines: Array,
    sines: Array,
    first: int,
    last: int,
    tolerance: float,
    displacement: Array,
    iterations: Array,
) -> None:
    """Newton's method on the ring alone, every ball on the line of the groove centres.

    Blocks of lanes run until the slowest has settled. Writes displacement (cases, 5) and
    iterations (cases): zero, and the start unchanged, where a lane did not settle.
    """
    w = np.zeros(layout.RING_ROWS * _LANES)
    b = np.zeros((cosines.size, layout.BALL_ROWS * _LANES))
    for block in range(first, last, _LANES):
        count = min(_LANES, last - block)
        for lane in range(_LANES):
            case = min(block + lane, last - 1)
            start(p, case, cosines.size, displacement[case])
            iterations[case] = 0
            fill(w, b, lane, p, cosines, sines, control, case, displacement[case])
        open_lanes = count
        for step in range(STATIC_STEPS):
            lanes.reset_sums(w)
            for j in range(cosines.size):
                lanes.add_static_ball(w, b[j])
            for lane in range(count):
                if iterations[block + lane] == 0 and _unbalanced(w, lane) <= tolerance:
                    iterations[block + lane] = step + 1
                    open_lanes -= 1
            lanes.step_ring(w)
            if open_lanes == 0:
                break
        for lane in range(count):
            case = block + lane
            if iterations[case] > 0 and not _lost(w, lane):
                _read_displacement(w, lane, displacement[case])
            else:
                iterations[case] = 0


@shared
def solve_moving(
    p: Array,
    control: Array,
    cosines: Array,
    sines: Array,
    first: int,
    last: int,
    displacement: Array,
    cage: Array,
    position: Array,
    iterations: Array,
) -> None:
    """Newton's method on ring and balls together, from the static displacement.

    A lane that has settled, failed or run out of steps takes the next case. Writes displacement
    (cases, 5), cage (cases), position (cases, balls, 2) and iterations (cases): zero where a lane
    failed, negative where it ran out of steps.
    """
    balls = cosines.size
    w = np.zeros(layout.RING_ROWS * _LANES)
    b = np.zeros((balls, layout.BALL_ROWS * _LANES))
    holds = np.full(_LANES, -1)  # the case in each lane
    steps = np.zeros(_LANES, np.int64)
    settled = np.zeros(_LANES, np.bool_)
    waiting = first
    working = 0
    for lane in range(_LANES):
        fill(w, b, lane, p, cosines, sines, control, first, displacement[first])
    while waiting < last or working > 0:
        fresh = False
        for lane in range(_LANES):
            is_fresh = holds[lane] < 0 and waiting < last
            w[layout.ASTRAY * _LANES + lane] = 1.0 if is_fresh else 0.0
            if is_fresh:
                fill(w, b, lane, p, cosines, sines, control, waiting, displacement[waiting])
                holds[lane] = waiting
                steps[lane] = 0
                waiting += 1
                working += 1
                fresh = True
        if fresh:
            for j in range(balls):
                lanes.replace_ball(w, b[j])

        lanes.reset_sums(w)
        for j in range(balls):
            lanes.add_moving_ball(w, b[j], TOLERANCE)
        lanes.balance_cage(w)
        for lane in range(_LANES):
            at_rest = w[layout.FAULT * _LANES + lane] <= 0.0
            settled[lane] = at_rest and _unbalanced(w, lane) <= TOLERANCE
            settled[lane] = settled[lane] and behind(w, lane) <= TOLERANCE
            steps[lane] += 1
        lanes.condense_cage(w)
        lanes.step_ring(w)
        lanes.step_cage(w)
        for j in range(balls):
            lanes.follow_ring(w, b[j])
            if any_astray(w):
                lanes.replace_ball(w, b[j])

        for lane in range(_LANES):
            case = holds[lane]
            lost = _lost(w, lane)
            if case < 0 or not (settled[lane] or lost or steps[lane] >= MOVING_STEPS):
                continue
            iterations[case] = 0 if lost else (steps[lane] if settled[lane] else -steps[lane])
            _read_displacement(w, lane, displacement[case])
            cage[case] = w[layout.CAGE * _LANES + lane]
            for j in range(balls):
                position[case, j, 0] = b[j, _X + lane]
                position[case, j, 1] = b[j, _X + _LANES + lane]
            holds[lane] = -1
            working -= 1
