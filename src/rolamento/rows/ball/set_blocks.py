"""Rows of balls on one ring: Newton's method on ring, cages and balls of all rows together.

As `blocks` does for one row, many cases in lanes; then each row is held in exact arithmetic where
the proposal has it, and judged there. What comes out with a verdict on every row and the ring in
balance is final; everything else is left to `rolamento.system.ring`.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics.compiled import filling, filling_kernel, inline_exact
from rolamento.rows.ball import lanes, layout, set_lanes
from rolamento.rows.ball.accept import is_finite, judge
from rolamento.rows.ball.blocks import (
    begin_lane,
    in_lanes,
    put_ball,
    put_displacement,
    put_numbers,
    put_position,
    put_reaction,
    read_position,
    read_reaction,
    read_stiffness,
    worst_in_lane,
)
from rolamento.rows.ball.mirror import Mirror, mirror
from rolamento.rows.ball.set_lanes import SLIDE, STAND_ROWS, TILT, UNKNOWNS, WAY
from rolamento.rows.ball.single import FAR, OneCase, Ring, ring_around
from rolamento.rows.ball.types import Array
from rolamento.status import CONVERGED, NO_EQUILIBRIUM, NOT_CONVERGED, OVERLOADED
from rolamento.status import TOLERANCE as TOLERANCE_OF_ROWS

STATIC_STEPS: Final = 16
START_STEPS: Final = 5  # of a static start for moving balls
MOVING_STEPS: Final = 30
START_TOLERANCE: Final = 0.05  # of a static start for moving balls
TOLERANCE: Final = 1e-8  # before the last step, which squares it
BALANCED: Final = 1e-6
"""The same of a ring and its cages beside moving balls, whose steps decide."""
SPRINGS: Final = 9
"""As many balls, evenly spread, stand for those of a row where a static start is looked for."""
PRECISION: Final = 1e-10
"""Precision of the ring's exact balance, as `rolamento.system.ring` asks for it."""

HELD: Final = layout.INNER_SPEED
"""The first number of a duty that such a row needs: what loads and holds it is the ring's."""
PRESS: Final = STAND_ROWS  # how far the clamped rings press a row in
STANDING: Final = STAND_ROWS + 1  # numbers that say how a row stands on the ring

_LANES: Final = layout.LANES
_LEVER: Final = set_lanes.LEVER


class Rows(NamedTuple):
    """The rows of some cases; n of them.

    duty (rows, layout.DUTY - HELD, n), from HELD on, bearing (rows, the rest of layout.COLUMN or
    more, n or 1): their parameters; stand (rows, STANDING, n): how each stands on the ring;
    control (n or 1, balls of all rows), cosines and sines (balls); ends (rows + 1): where the balls
    of a row begin; directions (2, springs), spring_ends (rows + 1): of the few that stand for them
    at the start.
    """

    duty: Array
    bearing: Array
    stand: Array
    control: Array
    cosines: Array
    sines: Array
    ends: NDArray[np.int64]
    directions: Array
    spring_ends: NDArray[np.int64]


class BalanceRequest(NamedTuple):
    """What is asked of the rings, and where they begin; (n, UNKNOWNS) each, scaled by their arm.

    reach: of the longest step of a ring without inertia; firm: a stiffness that is small against
    any real one, so that a ring that touches nothing moves with its load; arm: of a tilt; (n,).
    """

    free: Array
    target: Array
    start: Array
    reach: Array
    firm: Array
    arm: Array


class Balance(NamedTuple):
    """What the kernel writes, over all cases.

    Of the ring: place, force (cases, UNKNOWNS), stiffness (cases, UNKNOWNS, UNKNOWNS), in SI;
    residual, steps and whether the verdict on the rows is final, (cases,). position: of all balls,
    (cases, balls, 2).
    Of the rows: displacement, scaled, reaction (rows, cases, 5), cage, row_residual, code (rows,
    cases), row_stiffness (rows, cases, 5, 5), or (rows, 0, 5, 5) where nobody asks for it.
    """

    place: Array
    force: Array
    stiffness: Array
    residual: Array
    steps: NDArray[np.int64]
    sound: NDArray[np.bool_]
    position: Array
    displacement: Array
    reaction: Array
    row_stiffness: Array
    cage: Array
    row_residual: Array
    code: NDArray[np.int64]


class Work(NamedTuple):
    """What the kernel works with; it makes no arrays of its own.

    In lanes: s of the rings, and of each row how it stands (v), its own (w, and the same as rings,
    (rows, layout.RING_ROWS, lanes)); of each ball (b), and of each that stands for some at the
    start (springs); holds: the case in each lane, and its steps. Of one row of one case: column,
    its parameters (parameters, 1); own, where it is held (5,); the sums over its balls, and their
    errors (balls, 2). Of a ball in lanes: touch (layout.TOUCH_ROWS * lanes), how it does. Of the
    judge in lanes: mirror, none; accepted (rows, lanes).
    """

    s: Array
    v: Array
    w: Array
    rings: Array
    b: Array
    springs: Array
    holds: NDArray[np.int64]
    steps: NDArray[np.int64]
    column: Array
    own: Array
    ring: Ring
    errors: Array
    mirror: Mirror
    touch: Array
    accepted: NDArray[np.bool_]

    @classmethod
    def of(cls, rows: int, balls: int, springs: int, parameters: int) -> Work:
        """Make room for rows of so many balls and springs in all, of so many parameters each."""
        w = in_lanes(rows, layout.RING_ROWS)
        return cls(
            s=in_lanes(1, set_lanes.SET_ROWS)[0],
            v=in_lanes(rows, STAND_ROWS),
            w=w,
            rings=w.reshape(rows, layout.RING_ROWS, _LANES),
            b=in_lanes(balls, layout.BALL_ROWS),
            springs=in_lanes(springs, layout.BALL_ROWS),
            holds=np.zeros(_LANES, np.int64),
            steps=np.zeros(_LANES, np.int64),
            column=np.zeros((parameters, 1)),
            own=np.zeros(layout.DEGREES_OF_FREEDOM),
            ring=ring_around(balls, False),
            errors=np.zeros((balls, 2)),
            mirror=mirror(balls, 0),
            touch=in_lanes(1, layout.TOUCH_ROWS)[0],
            accepted=np.zeros((rows, _LANES), np.bool_),
        )


@inline_exact
def _standing(stand: Array, row: int, k: int, u: Array, own: Array) -> None:
    """Write where a row is held by a ring at u."""
    way, lever = stand[row, WAY, k], stand[row, _LEVER, k]
    tilt, slide = stand[row, TILT, k], stand[row, SLIDE, k]
    own[0] = way * u[0] + slide * u[5] + stand[row, PRESS, k]
    own[1] = u[1] + lever * u[4]
    own[2] = u[2] - lever * u[3]
    own[3] = tilt * u[3]
    own[4] = tilt * u[4]


@inline_exact
def _put_balls(work: Work, lane: int, rows: Rows, row: int, k: int) -> None:
    """Put the balls of a row into a lane."""
    sigmas = k if rows.control.shape[0] > 1 else 0
    for j in range(rows.ends[row], rows.ends[row + 1]):
        sigma = rows.control[sigmas, j]
        put_ball(work.w[row], work.b[j], lane, rows.cosines[j], rows.sines[j], sigma)
    for j in range(rows.spring_ends[row], rows.spring_ends[row + 1]):
        cosine, sine = rows.directions[0, j], rows.directions[1, j]
        put_ball(work.w[row], work.springs[j], lane, cosine, sine, 1.0)


@inline_exact
def _stand_alike(w: Array, lane: int, rows: Rows, row: int, k: int) -> bool:
    """Whether the balls of a case stand where those of the case before it in the lane did."""
    duty = rows.duty[row]
    same = w[layout.COS_FIRST * _LANES + lane] == duty[layout.COS_FIRST - HELD, k]
    same = same and w[layout.SIN_FIRST * _LANES + lane] == duty[layout.SIN_FIRST - HELD, k]
    return bool(same and rows.control.shape[0] == 1)


@inline_exact
def _put_ring(work: Work, lane: int, asked: BalanceRequest, k: int, bound: bool) -> None:
    """Put into a lane what is asked of its ring; bound: whether steps have an end."""
    work.s[set_lanes.SMALL_STIFFNESS * _LANES + lane] = asked.firm[k] if bound else 0.0
    work.s[set_lanes.REACH * _LANES + lane] = asked.reach[k] if bound else FAR
    for i in range(UNKNOWNS):
        work.s[(set_lanes.FREE + i) * _LANES + lane] = asked.free[k, i]
        work.s[(set_lanes.TARGET + i) * _LANES + lane] = asked.target[k, i]


@inline_exact
def _put_place(work: Work, lane: int, rows: Rows, k: int, u: Array) -> None:
    """Put the ring of a lane at u, and its rows where that holds them."""
    for i in range(UNKNOWNS):
        work.s[(set_lanes.PLACE + i) * _LANES + lane] = u[i]
    for row in range(rows.duty.shape[0]):
        _standing(rows.stand, row, k, u, work.own)
        put_displacement(work.w[row], lane, work.own)


@filling
def _begin(work: Work, rows: Rows) -> None:
    """Put the bearing into all lanes if all cases have the same."""
    if rows.bearing.shape[2] == 1:
        for row in range(rows.bearing.shape[0]):
            for lane in range(_LANES):
                put_numbers(work.w[row], layout.DUTY, lane, rows.bearing[row], 0)


@filling
def _fill(work: Work, lane: int, rows: Rows, asked: BalanceRequest, k: int) -> None:
    """Put a case into a lane; where its ring stands is left open."""
    _put_ring(work, lane, asked, k, False)
    for row in range(rows.duty.shape[0]):
        w = work.w[row]
        for i in range(STAND_ROWS):
            work.v[row, i * _LANES + lane] = rows.stand[row, i, k]
        alike = _stand_alike(w, lane, rows, row, k)
        put_numbers(w, HELD, lane, rows.duty[row], k)
        if rows.bearing.shape[2] > 1:
            put_numbers(w, layout.DUTY, lane, rows.bearing[row], k)
        begin_lane(w, lane)
        if not alike:
            _put_balls(work, lane, rows, row, k)
        w[layout.UNBALANCED * _LANES + lane] = 1.0


@filling
def _fill_all(work: Work, rows: Rows, block: int, count: int) -> None:
    """Put cases that follow each other into the lanes: row by row, as they lie in memory."""
    for row in range(rows.duty.shape[0]):
        w, alike = work.w[row], True
        for lane in range(count):
            alike = alike and _stand_alike(w, lane, rows, row, block + lane)
        for i in range(rows.duty.shape[1]):
            for lane in range(count):
                w[(HELD + i) * _LANES + lane] = rows.duty[row, i, block + lane]
        if rows.bearing.shape[2] > 1:
            for lane in range(count):
                put_numbers(w, layout.DUTY, lane, rows.bearing[row], block + lane)
        for i in range(STAND_ROWS):
            for lane in range(count):
                work.v[row, i * _LANES + lane] = rows.stand[row, i, block + lane]
        for lane in range(count):
            begin_lane(w, lane)
            if not alike:
                _put_balls(work, lane, rows, row, block + lane)


@inline_exact
def _read_place(s: Array, lane: int, place: Array) -> None:
    for i in range(UNKNOWNS):
        place[i] = s[(set_lanes.PLACE + i) * _LANES + lane]


@inline_exact
def _lost(place: Array) -> bool:
    """Whether a ring has gone to NaN, as after a step without any stiffness."""
    total = 0.0
    for i in range(UNKNOWNS):
        total += place[i]
    return bool(total != total)


@filling
def _settle_static(
    work: Work,
    rows: Rows,
    asked: BalanceRequest,
    chosen: NDArray[np.int64],
    moving: bool,
    found: Balance,
) -> None:
    """Newton's method on the rings alone, every ball on the line of the groove centres.

    Writes the places, and the steps: zero where a lane failed; its place is the start then. Balls
    in motion are put near theirs, from wherever the ring is after a few steps.
    """
    s, v, w, b = work.s, work.v, work.w, work.b
    tolerance = START_TOLERANCE if moving else TOLERANCE
    last = START_STEPS if moving else STATIC_STEPS
    springs, ends = (work.springs, rows.spring_ends) if moving else (b, rows.ends)
    for block in range(0, chosen.size, _LANES):
        count = min(_LANES, chosen.size - block)
        _fill_all(work, rows, block, count)
        for lane in range(count):
            k = block + lane
            found.steps[chosen[k]] = 0
            _put_ring(work, lane, asked, k, True)
            _put_place(work, lane, rows, k, asked.start[k])
        open_lanes = count
        for step in range(last):
            set_lanes.empty_set(s)
            for row in range(w.shape[0]):
                lanes.reset_sums(w[row])
                for j in range(ends[row], ends[row + 1]):
                    lanes.add_static_ball(w[row], springs[j])
                balls = rows.ends[row + 1] - rows.ends[row]
                lanes.multiply_reaction(w[row], balls / (ends[row + 1] - ends[row]))
                set_lanes.add_row(s, v[row], w[row])
            set_lanes.measure_set(s)
            for row in range(w.shape[0]):
                set_lanes.measure_row(s, w[row], tolerance)
            set_lanes.end_measure(s, tolerance)
            set_lanes.step_set(s)
            for row in range(w.shape[0]):
                set_lanes.move_row(s, v[row], w[row])
            for lane in range(count):
                case = chosen[block + lane]
                near = s[set_lanes.UNBALANCED * _LANES + lane] <= tolerance
                if found.steps[case] == 0 and (near or step + 1 == last):
                    # a place that does not depend on how long its neighbours take
                    found.steps[case] = step + 1
                    _read_place(s, lane, found.place[case])
                    open_lanes -= 1
            if open_lanes == 0:
                break
        for lane in range(count):
            case = chosen[block + lane]
            if _lost(found.place[case]):
                found.steps[case] = 0
            if found.steps[case] == 0:
                for i in range(UNKNOWNS):
                    found.place[case, i] = asked.start[block + lane, i]
            if moving:
                _put_place(work, lane, rows, block + lane, found.place[case])
        if moving:
            for row in range(w.shape[0]):
                for j in range(rows.ends[row], rows.ends[row + 1]):
                    lanes.place_ball(w[row], b[j])
                    lanes.settle_ball(w[row], b[j], work.touch)
            for lane in range(count):
                for j in range(b.shape[0]):
                    read_position(b[j], lane, found.position[chosen[block + lane]], j)


@filling
def _settle_moving(
    work: Work, rows: Rows, asked: BalanceRequest, chosen: NDArray[np.int64], found: Balance
) -> None:
    """Newton's method on rings and balls together, from the static places.

    A lane that has settled, failed or run out of steps takes the next case. Writes the places of
    rings, cages and balls, and the steps: zero where a lane failed.
    """
    s, v, w, b = work.s, work.v, work.w, work.b
    holds, steps = work.holds, work.steps
    waiting, working = 0, 0
    for lane in range(_LANES):
        holds[lane] = -1
        _fill(work, lane, rows, asked, 0)
        _put_place(work, lane, rows, 0, found.place[chosen[0]])
        for j in range(b.shape[0]):
            put_position(b[j], lane, found.position[chosen[0]], j)
    while waiting < chosen.size or working > 0:
        for lane in range(_LANES):
            if holds[lane] < 0 and waiting < chosen.size:
                case = chosen[waiting]
                _fill(work, lane, rows, asked, waiting)
                _put_place(work, lane, rows, waiting, found.place[case])
                for j in range(b.shape[0]):
                    put_position(b[j], lane, found.position[case], j)
                holds[lane] = waiting
                steps[lane] = 0
                waiting += 1
                working += 1

        set_lanes.empty_set(s)
        for row in range(w.shape[0]):
            lanes.reset_sums(w[row])
            for j in range(rows.ends[row], rows.ends[row + 1]):
                lanes.add_moving_ball(w[row], b[j], work.touch, TOLERANCE)
            lanes.measure_cage(w[row])
            lanes.condense_cage(w[row])
            set_lanes.add_row(s, v[row], w[row])
        set_lanes.measure_set(s)
        for row in range(w.shape[0]):
            set_lanes.measure_row(s, w[row], BALANCED)
        set_lanes.end_measure(s, BALANCED)
        set_lanes.step_set(s)
        for row in range(w.shape[0]):
            set_lanes.tell_row(s, w[row])
            set_lanes.move_row(s, v[row], w[row])
            lanes.step_cage(w[row])
            for j in range(rows.ends[row], rows.ends[row + 1]):
                lanes.follow_ring(w[row], b[j])
            if lanes.any_astray(w[row]):
                for j in range(rows.ends[row], rows.ends[row + 1]):
                    lanes.replace_ball(w[row], b[j])

        for lane in range(_LANES):
            k, steps[lane] = holds[lane], steps[lane] + 1
            settled = s[set_lanes.SETTLED * _LANES + lane]
            if k < 0 or (settled == 0.0 and steps[lane] < MOVING_STEPS):
                continue
            case = chosen[k]
            found.steps[case] = 0 if settled != settled else steps[lane]
            _read_place(s, lane, found.place[case])
            for row in range(w.shape[0]):
                found.cage[row, case] = w[row, layout.CAGE * _LANES + lane]
            for j in range(b.shape[0]):
                read_position(b[j], lane, found.position[case], j)
            holds[lane] = -1
            working -= 1


@filling
def _judge_in_lanes(
    work: Work, rows: Rows, block: int, chosen: NDArray[np.int64], found: Balance
) -> None:
    """Judge the rows of as many cases as there are lanes, with inertia, as `blocks` judges one row.

    Of what is accepted the sums stand in the lanes, as `accept.judge` has them; what is not is
    left to that one.
    """
    count = min(_LANES, chosen.size - block)
    for row in range(rows.duty.shape[0]):
        a, z = rows.ends[row], rows.ends[row + 1]
        w, b, bearing = work.w[row], work.b[a:z], rows.bearing[row]
        for lane in range(count):
            case = chosen[block + lane]
            put_displacement(w, lane, found.displacement[row, case])
            w[layout.CAGE * _LANES + lane] = found.cage[row, case]
            for j in range(z - a):
                put_position(b[j], lane, found.position[case], a + j)
        lanes.reset_sums(w)
        for j in range(z - a):
            lanes.mark_regrouped(w, b[j])
        lanes.judge_balls(w, b, work.mirror, bearing, work.touch)
        lanes.weigh_ring(w)
        for j in range(z - a):
            lanes.weigh_ball(w, b[j])
        for lane in range(count):
            case = chosen[block + lane]
            doubt = w[layout.UNSOUND * _LANES + lane] + w[layout.REGROUPED * _LANES + lane]
            # of bearings that differ the lanes have seven coefficients of K
            few = w[layout.TERMS * _LANES + lane] <= layout.COEFFICIENTS
            good = doubt == 0.0 and is_finite(found.displacement[row, case])
            good = good and (few or bearing.shape[1] == 1)
            residual = w[layout.UNBALANCED * _LANES + lane]
            if good and w[layout.DOUBTFUL * _LANES + lane] > 0.0:
                residual = worst_in_lane(work.rings[row], b, work.errors[: z - a], lane)
            good = good and residual <= TOLERANCE_OF_ROWS
            work.accepted[row, lane] = good
            found.code[row, case] = CONVERGED if good else NOT_CONVERGED
            found.row_residual[row, case] = residual


@filling
def _judge_row(
    work: Work, rows: Rows, row: int, k: int, case: int, moving: bool, lane: int, found: Balance
) -> None:
    """Judge one row by itself; its sums go into its lane."""
    column, ring, a, z = work.column, work.ring, rows.ends[row], rows.ends[row + 1]
    own = k if rows.bearing.shape[2] > 1 else 0
    control = rows.control[k if rows.control.shape[0] > 1 else 0]
    for i in range(rows.duty.shape[1]):
        column[HELD + i, 0] = rows.duty[row, i, k]
    for i in range(rows.bearing.shape[1]):
        column[layout.DUTY + i, 0] = rows.bearing[row, i, own]
    one = OneCase(
        column, 0, moving, control[a:z], rows.cosines[a:z], rows.sines[a:z],
        found.displacement[row, case], found.position[case, a:z], ring, work.errors[: z - a],
    )  # fmt: skip
    code, residual, _ = judge(one, found.cage[row, case])
    found.code[row, case], found.row_residual[row, case] = code, residual
    put_reaction(work.w[row], lane, ring.reaction, ring.matrix)


@inline_exact
def _arm_of(unknown: int, arm: float) -> float:
    """What turns a scaled load of the ring into N or N·m; its last unknown is a slide."""
    return arm if layout.SHIFTS <= unknown < layout.DEGREES_OF_FREEDOM else 1.0


@filling
def _judge(
    work: Work,
    rows: Rows,
    asked: BalanceRequest,
    block: int,
    chosen: NDArray[np.int64],
    moving: bool,
    found: Balance,
) -> None:
    """Hold the rows of as many cases as there are lanes where the proposal has them, and measure.

    Rows in exact arithmetic; what they ask of their ring is put together in lanes.
    """
    s, v, w = work.s, work.v, work.w
    count = min(_LANES, chosen.size - block)
    _fill_all(work, rows, block, count)
    for lane in range(count):
        case = chosen[block + lane]
        _put_ring(work, lane, asked, block + lane, False)
        for row in range(w.shape[0]):
            own = found.displacement[row, case]
            _standing(rows.stand, row, block + lane, found.place[case], own)
            work.accepted[row, lane] = False
            found.code[row, case] = NOT_CONVERGED
    if moving:
        _judge_in_lanes(work, rows, block, chosen, found)
    for lane in range(count):
        case = chosen[block + lane]
        for row in range(w.shape[0]):
            if found.steps[case] > 0 and not work.accepted[row, lane]:
                _judge_row(work, rows, row, block + lane, case, moving, lane, found)
    set_lanes.empty_set(s)
    for row in range(w.shape[0]):
        set_lanes.add_row(s, v[row], w[row])
    set_lanes.measure_set(s)
    for row in range(w.shape[0]):
        set_lanes.measure_row(s, w[row], PRECISION)
    set_lanes.end_measure(s, PRECISION)
    for lane in range(count):
        case = chosen[block + lane]
        sound = found.steps[case] > 0
        for row in range(w.shape[0]):
            code = found.code[row, case]
            sound = sound and code in (CONVERGED, OVERLOADED, NO_EQUILIBRIUM)
            read_reaction(w[row], lane, found.reaction[row, case])
            if found.row_stiffness.shape[1] > 0:
                read_stiffness(w[row], lane, found.row_stiffness[row, case])
        arm, place = asked.arm[block + lane], found.place[case]
        force, stiffness = found.force[case], found.stiffness[case]
        for i in range(UNKNOWNS):
            own = _arm_of(i, arm)
            place[i] /= own
            force[i] = own * s[(set_lanes.FORCE + i) * _LANES + lane]
            for j in range(UNKNOWNS):
                entry = s[(set_lanes.MATRIX + UNKNOWNS * i + j) * _LANES + lane]
                stiffness[i, j] = own * _arm_of(j, arm) * entry
        found.residual[case] = s[set_lanes.UNBALANCED * _LANES + lane]
        found.sound[case] = sound and found.residual[case] <= PRECISION


@filling_kernel
def solve_sets(
    rows: Rows,
    asked: BalanceRequest,
    moving: bool,
    chosen: NDArray[np.int64],
    work: Work,
    found: Balance,
) -> None:
    """Propose the equilibrium of some cases, with or without inertia, and judge it.

    chosen: which cases they are, of all that `found` has room for; (n,).
    """
    _begin(work, rows)
    _settle_static(work, rows, asked, chosen, moving, found)
    if moving:
        _settle_moving(work, rows, asked, chosen, found)
    for block in range(0, chosen.size, _LANES):
        _judge(work, rows, asked, block, chosen, moving, found)
