"""The fast path, case by case: fill the lanes, start, iterate, hand over, judge.

What comes out of the iteration is a proposal: `judge_blocks` checks every case in exact arithmetic,
as `accept` does, and `robust` solves what was not proposed or not accepted.
"""

from __future__ import annotations

from math import sqrt
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.compiled import filling, inline_exact, shared
from rolamento.rows.ball import lanes, layout
from rolamento.rows.ball.accept import is_finite, worst_ball
from rolamento.rows.ball.mirror import Mirror
from rolamento.rows.ball.single import FAR, arm_of, changes_groove
from rolamento.rows.ball.types import Array, Order

STATIC_STEPS: Final = 10
MOVING_STEPS: Final = 30
TRIALS: Final = 8  # of which balls are on the groove
START_TOLERANCE: Final = 0.2  # of a static start for a moving bearing
TOLERANCE: Final = 1e-6  # before the last step, which squares it, or less where a ball just touches

_LANES: Final = layout.LANES
_X: Final = layout.POSITION * _LANES


class Batch(NamedTuple):
    """Cases of one row of balls, as the kernels take them.

    duty (layout.DUTY, cases), bearing (the rest of layout.COLUMN, cases or 1): their parameters;
    control (cases or 1, balls): +1 or -1; cosines, sines (balls): of the balls' azimuths from the
    first; mirror: which of them the lanes hold.
    """

    duty: Array
    bearing: Array
    control: Array
    cosines: Array
    sines: Array
    mirror: Mirror


_LINE: Final = 8
"""Numbers of a cache line."""


class Room(NamedTuple):
    """Room for as many cases as there are lanes.

    rings (layout.RING_ROWS, lanes), and the same numbers in one row, w; b (balls, layout.BALL_ROWS
    * lanes): balls; holds, groupings (lanes): the case in each lane, or -1, and how often its balls
    changed groups; errors (balls, 2): of the balls of a case, their residuals and scales; touch
    (layout.TOUCH_ROWS * lanes): how a ball does.
    """

    rings: Array
    w: Array
    b: Array
    holds: Order
    groupings: Order
    errors: Array
    touch: Array


@shared
def in_lanes(count: int, rows: int) -> Array:
    """Workspaces of so many rows of lanes, (count, rows * lanes): no vector across cache lines."""
    size = count * rows * _LANES
    room = np.zeros(size + _LINE)
    first = -(room.ctypes.data // 8) % _LINE
    return room[first : first + size].reshape((count, rows * _LANES))


@shared
def room_for(balls: int) -> Room:
    """Make room for cases of so many balls."""
    rings = in_lanes(1, layout.RING_ROWS).reshape((layout.RING_ROWS, _LANES))
    return Room(
        rings,
        rings.reshape(rings.size),
        in_lanes(balls, layout.BALL_ROWS),
        np.full(_LANES, -1),
        np.zeros(_LANES, np.int64),
        np.zeros((balls, 2)),
        in_lanes(1, layout.TOUCH_ROWS)[0],
    )


@filling
def begin(room: Room, batch: Batch) -> None:
    """Empty the lanes, and put in the bearing if all cases have the same."""
    room.w[:] = 0.0
    room.b[:] = 0.0
    if batch.bearing.shape[1] == 1:
        for lane in range(_LANES):
            put_numbers(room.w, layout.DUTY, lane, batch.bearing, 0)


@filling
def start(p: Array, case: int, ball_count: int, u: Array) -> None:
    """Write a first displacement of the ring: as held, or so that the balls carry too much.

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
        reach = length + np.cbrt(4.5 * load / stiffness) ** 2
        x = reach * fx / load - a1 - tilt
        away = reach * radial / load - a2
    else:
        axial = (abs(fx) + 2.0 * sqrt(my * my + mz * mz)) / max(sine, 0.2)
        reach = length + np.cbrt(axial / stiffness) ** 2
        x = sqrt(max(reach * reach - a2 * a2, 0.0)) * (1.0 if fx > 0.0 else -1.0) - a1
        away = np.cbrt(4.5 * radial / stiffness) ** 2
    if fx == 0.0 or (fx < 0.0 and p[layout.ONE_SIDED, case] > 0.0):
        x = 0.0
    guess = (x, away * toward_y, away * toward_z, 0.0, 0.0)
    for i in range(layout.DEGREES_OF_FREEDOM):
        free = p[layout.FREE + i, case] > 0.0
        u[i] = guess[i] if free else p[layout.IMPOSED + i, case]


@inline_exact
def put_displacement(w: Array, lane: int, u: Array) -> None:
    """Write where a lane's ring stands; u (5,)."""
    for i in range(layout.DEGREES_OF_FREEDOM):
        w[(layout.DISPLACEMENT + i) * _LANES + lane] = u[i]


@inline_exact
def put_numbers(w: Array, first: int, lane: int, numbers: Array, column: int) -> None:
    """Put a case's parameters into a lane, from a row on, as many as there are."""
    for row in range(min(numbers.shape[0], layout.PARAMETERS - first)):
        w[(first + row) * _LANES + lane] = numbers[row, column]


@inline_exact
def begin_lane(w: Array, lane: int) -> None:
    """Let the cage turn at its nominal speed; no step is taken yet."""
    w[layout.CAGE * _LANES + lane] = w[layout.NOMINAL_ORBIT * _LANES + lane]
    w[layout.STEPS * _LANES + lane] = 0.0
    w[layout.CAUTION * _LANES + lane] = 1.0


@inline_exact
def put_ball(w: Array, b: Array, lane: int, cosine: float, sine: float, sigma: float) -> None:
    """Put a ball on its azimuth, under the control of one race: b of that ball."""
    c0, s0 = w[layout.COS_FIRST * _LANES + lane], w[layout.SIN_FIRST * _LANES + lane]
    b[layout.COS * _LANES + lane] = cosine * c0 - sine * s0
    b[layout.SIN * _LANES + lane] = sine * c0 + cosine * s0
    b[layout.SIGMA * _LANES + lane] = sigma
    b[layout.OFF * _LANES + lane] = 0.0


@inline_exact
def _stand_alike(w: Array, lane: int, batch: Batch, case: int) -> bool:
    """Whether the balls of a case stand where those of the case before it in the lane did."""
    cosine, sine = w[layout.COS_FIRST * _LANES + lane], w[layout.SIN_FIRST * _LANES + lane]
    same = cosine == batch.duty[layout.COS_FIRST, case]
    same = same and sine == batch.duty[layout.SIN_FIRST, case]
    return bool(same and batch.control.shape[0] == 1)


@inline_exact
def _put_balls(room: Room, lane: int, batch: Batch, case: int, alike: bool) -> None:
    """Put the balls of a case into a lane; alike: those before stood where these do."""
    sigmas = case if batch.control.shape[0] > 1 else 0
    for j in range(room.b.shape[0]):
        if alike:
            room.b[j, layout.OFF * _LANES + lane] = 0.0
        else:
            ball = batch.mirror.seats[j, 0]
            cosine, sine = batch.cosines[ball], batch.sines[ball]
            put_ball(room.w, room.b[j], lane, cosine, sine, batch.control[sigmas, ball])


@filling
def fill(room: Room, lane: int, batch: Batch, case: int) -> None:
    """Put a case into a lane; where its ring stands is left open."""
    alike = _stand_alike(room.w, lane, batch, case)
    put_numbers(room.w, 0, lane, batch.duty, case)
    if batch.bearing.shape[1] > 1:
        put_numbers(room.w, layout.DUTY, lane, batch.bearing, case)
    begin_lane(room.w, lane)
    _put_balls(room, lane, batch, case, alike)


@filling
def fill_all(room: Room, batch: Batch, cases: Order) -> None:
    """Put cases into all lanes, or the first of them: row by row, as they lie in memory."""
    w, alike = room.w, True
    for lane in range(cases.size):
        alike = alike and _stand_alike(w, lane, batch, cases[lane])
    for row in range(layout.DUTY):
        for lane in range(cases.size):
            w[row * _LANES + lane] = batch.duty[row, cases[lane]]
    if batch.bearing.shape[1] > 1:
        for row in range(layout.DUTY, layout.PARAMETERS):
            for lane in range(cases.size):
                w[row * _LANES + lane] = batch.bearing[row - layout.DUTY, cases[lane]]
    for lane in range(cases.size):
        begin_lane(w, lane)
        _put_balls(room, lane, batch, cases[lane], alike)


@inline_exact
def _read_displacement(w: Array, lane: int, u: Array) -> None:
    for i in range(layout.DEGREES_OF_FREEDOM):
        u[i] = w[(layout.DISPLACEMENT + i) * _LANES + lane]


@inline_exact
def _put_positions(b: Array, lane: int, x: Array, seats: Order) -> None:
    for j in range(b.shape[0]):
        b[j, _X + lane] = x[seats[j, 0], 0]
        b[j, _X + _LANES + lane] = x[seats[j, 0], 1]


@inline_exact
def put_position(b: Array, lane: int, x: Array, ball: int) -> None:
    """Put a ball of a lane where it is; b of that ball, x (balls, 2)."""
    b[_X + lane] = x[ball, 0]
    b[_X + _LANES + lane] = x[ball, 1]


@inline_exact
def read_position(b: Array, lane: int, x: Array, ball: int) -> None:
    """Write where a ball of a lane is; b of that ball, x (balls, 2)."""
    x[ball, 0] = b[_X + lane]
    x[ball, 1] = b[_X + _LANES + lane]


@inline_exact
def read_reaction(w: Array, lane: int, reaction: Array) -> None:
    """Write what a lane's balls ask of their ring, in SI; (5,)."""
    arm = w[layout.ARM * _LANES + lane]
    for i in range(layout.DEGREES_OF_FREEDOM):
        reaction[i] = arm_of(i, arm) * w[(layout.REACTION + i) * _LANES + lane]


@inline_exact
def read_stiffness(w: Array, lane: int, stiffness: Array) -> None:
    """Write the derivative of that by the ring's place, in SI; (5, 5)."""
    arm = w[layout.ARM * _LANES + lane]
    for i in range(layout.DEGREES_OF_FREEDOM):
        own = arm_of(i, arm)
        for j in range(layout.DEGREES_OF_FREEDOM):
            row = layout.MATRIX + layout.DEGREES_OF_FREEDOM * i + j
            stiffness[i, j] = own * arm_of(j, arm) * w[row * _LANES + lane]


@inline_exact
def put_reaction(w: Array, lane: int, reaction: Array, matrix: Array) -> None:
    """Put into a lane what its balls ask of their ring; scaled."""
    for i in range(layout.DEGREES_OF_FREEDOM):
        w[(layout.REACTION + i) * _LANES + lane] = reaction[i]
        for j in range(layout.DEGREES_OF_FREEDOM):
            row = layout.MATRIX + layout.DEGREES_OF_FREEDOM * i + j
            w[row * _LANES + lane] = matrix[i, j]


@inline_exact
def _read_positions(b: Array, lane: int, x: Array, seats: Order) -> None:
    """Write where the balls of a lane and their mirror images are."""
    for j in range(b.shape[0]):
        read_position(b[j], lane, x, seats[j, 0])
        read_position(b[j], lane, x, seats[j, 1])


@inline_exact
def _tilting(duty: Array, order: Order) -> bool:
    """Whether the ring of any case is free to tilt."""
    tilting = False
    for case in order:
        free = duty[layout.FREE + 3, case] + duty[layout.FREE + 4, case] > 0.0
        tilting = tilting or free
    return tilting


@filling
def _regroup(w: Array, b: Array, lane: int) -> int:
    """Take balls off the inner groove or put them on (see `edges`); how many changed."""
    changed, length = 0, w[layout.INNER_LENGTH * _LANES + lane]
    for j in range(b.shape[0]):
        a1, a2 = lanes.groove_exact(w, b[j], lane)
        x1, x2 = b[j, _X + lane], b[j, _X + _LANES + lane]
        off = b[j, layout.OFF * _LANES + lane] > 0.0
        if changes_groove(off, a1, a2, x1, x2, length):
            b[j, layout.OFF * _LANES + lane] = 0.0 if off else FAR
            changed += 1
    return changed


@filling
def _let_out(w: Array, b: Array, lane: int) -> None:
    """Put the balls that are off the inner groove where their centrifugal force holds them."""
    out = w[layout.OUTER_SHARE * _LANES + lane] * w[layout.INERTIA_APPROACH * _LANES + lane]
    for j in range(b.shape[0]):
        if b[j, layout.OFF * _LANES + lane] > 0.0:
            b[j, _X + lane] = 0.0
            b[j, _X + _LANES + lane] = w[layout.OUTER_LENGTH * _LANES + lane] + out


@inline_exact
def _lost(w: Array, lane: int) -> bool:
    """Whether a lane's ring has gone to NaN, as after a step without any stiffness."""
    total = w[layout.CAGE * _LANES + lane]
    for i in range(layout.DEGREES_OF_FREEDOM):
        total += w[(layout.DISPLACEMENT + i) * _LANES + lane]
    return bool(total != total)


@filling
def solve_static(
    batch: Batch,
    order: Order,
    moving: bool,
    room: Room,
    displacement: Array,
    position: Array,
    iterations: Order,
) -> None:
    """Newton's method on the ring alone, every ball on the line of the groove centres.

    order: the cases to solve. Blocks of lanes run until the slowest has settled. Writes
    displacement (cases, 5) and iterations (cases): zero, and the start unchanged, where a lane did
    not settle. Loosely where the balls are moving: then it is a start, and position (cases, balls,
    2) where they are put.
    """
    w, b = room.w, room.b
    begin(room, batch)
    tolerance = START_TOLERANCE if moving else TOLERANCE
    tilting = _tilting(batch.duty, order)
    for block in range(0, order.size, _LANES):
        count = min(_LANES, order.size - block)
        fill_all(room, batch, order[block : block + count])
        for lane in range(count):
            case = order[block + lane]
            start(room.rings, lane, batch.cosines.size, displacement[case])
            put_displacement(w, lane, displacement[case])
            iterations[case] = 0
        open_lanes = count
        for step in range(STATIC_STEPS):
            if tilting:
                lanes.step_static(w, b, batch.mirror)
            else:
                lanes.step_static_untilted(w, b, batch.mirror)
            for lane in range(count):
                case = order[block + lane]
                if iterations[case] == 0:
                    if not w[layout.UNBALANCED * _LANES + lane] <= tolerance:
                        continue
                    iterations[case] = step + 1
                    if not moving and step + 1 < STATIC_STEPS:
                        continue
                elif moving or iterations[case] != step:
                    continue
                # a place that does not depend on how long its neighbours take; at rest one step on
                open_lanes -= 1
                if _lost(w, lane):
                    iterations[case] = 0
                else:
                    _read_displacement(w, lane, displacement[case])
            if open_lanes == 0:
                break
        for lane in range(count):
            case = order[block + lane]
            put_displacement(w, lane, displacement[case])
        if moving:
            for j in range(b.shape[0]):
                lanes.place_ball(w, b[j])
                lanes.settle_ball(w, b[j], room.touch)
            for lane in range(count):
                _read_positions(b, lane, position[order[block + lane]], batch.mirror.seats)


@filling
def solve_moving(
    batch: Batch,
    order: Order,
    cautious: bool,
    warm: bool,
    room: Room,
    displacement: Array,
    cage: Array,
    position: Array,
    iterations: Order,
) -> None:
    """Newton's method on ring and balls together, from the displacement and position given.

    cautious: whether the cage is held back until the ring is near balance, late steps are short and
    balls that leave the inner groove are taken off it; a few cases settle only without. warm:
    whether the cage's speed is given too.
    A lane that has settled, failed or run out of steps takes the next case. Writes displacement
    (cases, 5), cage (cases), position (cases, balls, 2) and iterations (cases): zero where a lane
    failed, negative where it ran out of steps.
    """
    w, b = room.w, room.b
    begin(room, batch)
    tilting = _tilting(batch.duty, order)
    waiting = 0
    working = 0
    for lane in range(_LANES):
        room.holds[lane] = -1
        fill(room, lane, batch, order[0])
        put_displacement(w, lane, displacement[order[0]])
        _put_positions(b, lane, position[order[0]], batch.mirror.seats)
    while waiting < order.size or working > 0:
        for lane in range(_LANES):
            if room.holds[lane] < 0 and waiting < order.size:
                case = order[waiting]
                fill(room, lane, batch, case)
                put_displacement(w, lane, displacement[case])
                _put_positions(b, lane, position[case], batch.mirror.seats)
                w[layout.CAUTION * _LANES + lane] = 1.0 if cautious else 0.0
                if warm:
                    w[layout.CAGE * _LANES + lane] = cage[case]
                room.holds[lane] = case
                room.groupings[lane] = 0
                waiting += 1
                working += 1

        if tilting:
            lanes.step_moving(w, b, batch.mirror, room.touch, TOLERANCE)
        else:
            lanes.step_moving_untilted(w, b, batch.mirror, room.touch, TOLERANCE)

        for lane in range(_LANES):
            case = room.holds[lane]
            settled = w[layout.SETTLED * _LANES + lane]
            out_of_steps = w[layout.STEPS * _LANES + lane] >= MOVING_STEPS
            if case < 0 or (settled == 0.0 and not out_of_steps):
                continue
            if cautious and settled > 0.0 and _regroup(w, b, lane) > 0:
                settled = 0.0
                room.groupings[lane] += 1
                if room.groupings[lane] <= TRIALS:
                    w[layout.STEPS * _LANES + lane] = 0.0
                    _let_out(w, b, lane)
                if w[layout.STEPS * _LANES + lane] < MOVING_STEPS:
                    continue
            steps = int(w[layout.STEPS * _LANES + lane])
            iterations[case] = steps if settled > 0.0 else (-steps if settled == 0.0 else 0)
            _read_displacement(w, lane, displacement[case])
            cage[case] = w[layout.CAGE * _LANES + lane]
            _read_positions(b, lane, position[case], batch.mirror.seats)
            room.holds[lane] = -1
            working -= 1


@filling
def worst_in_lane(rings: Array, b: Array, errors: Array, lane: int) -> float:
    """The residual of a lane's case, where a ball's may be worse than the ring's.

    rings (layout.RING_ROWS, LANES): of its row; errors (balls, 2): room for those of its balls.
    """
    for j in range(b.shape[0]):
        errors[j, 0] = b[j, layout.ERROR * _LANES + lane]
        errors[j, 1] = b[j, layout.SCALE * _LANES + lane]
    heaviest, worst = rings[layout.HEAVIEST, lane], rings[layout.UNBALANCED, lane]
    return worst_ball(rings, lane, errors, heaviest, worst)


@filling
def judge_blocks(
    batch: Batch,
    order: Order,
    room: Room,
    displacement: Array,
    cage: Array,
    position: Array,
    reaction: Array,
    stiffness: Array,
    residual: Array,
    accepted: NDArray[np.bool_],
) -> None:
    """Judge proposals for moving balls as `accept.judge` does, many at a time.

    Writes reaction (cases, 5), stiffness (cases, 5, 5), both in SI, and residual (cases) where
    accepted, in that order; what is not is left to be judged one by one.
    """
    w, b = room.w, room.b
    begin(room, batch)
    for block in range(0, order.size, _LANES):
        count = min(_LANES, order.size - block)
        fill_all(room, batch, order[block : block + count])
        for lane in range(count):
            case = order[block + lane]
            put_displacement(w, lane, displacement[case])
            _put_positions(b, lane, position[case], batch.mirror.seats)
            w[layout.CAGE * _LANES + lane] = cage[case]
        lanes.reset_sums(w)
        for j in range(b.shape[0]):
            lanes.mark_regrouped(w, b[j])
        for lane in range(count):
            if w[layout.REGROUPED * _LANES + lane] > 0.0:
                _regroup(w, b, lane)
        lanes.judge_balls(w, b, batch.mirror, batch.bearing, room.touch)
        lanes.weigh_ring(w)
        for j in range(b.shape[0]):
            lanes.weigh_ball(w, b[j])
        for lane in range(count):
            case = order[block + lane]
            sound = w[layout.UNSOUND * _LANES + lane] == 0.0 and is_finite(displacement[case])
            # of bearings that differ the lanes have seven coefficients of K
            more = w[layout.TERMS * _LANES + lane] > layout.COEFFICIENTS
            if not sound or (more and batch.bearing.shape[1] > 1):
                accepted[block + lane] = False
                continue
            residual[case] = w[layout.UNBALANCED * _LANES + lane]
            if w[layout.DOUBTFUL * _LANES + lane] > 0.0:
                residual[case] = worst_in_lane(room.rings, b, room.errors, lane)
            accepted[block + lane] = residual[case] <= status.TOLERANCE
            read_reaction(w, lane, reaction[case])
            read_stiffness(w, lane, stiffness[case])
