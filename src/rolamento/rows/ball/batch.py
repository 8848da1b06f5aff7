"""Many cases through the fast path, the judgement and, where needed, the safe path."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.compiled import filling, inline_exact, kernel, shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import judge
from rolamento.rows.ball.blocks import (
    Batch,
    Room,
    judge_blocks,
    room_for,
    solve_moving,
    solve_static,
    start,
)
from rolamento.rows.ball.continuation import heaviest_factor, put_factors, solve_by_steps
from rolamento.rows.ball.edges import solve_off_groove
from rolamento.rows.ball.robust import escaped, solve_robust
from rolamento.rows.ball.single import direction, groove, read_ring, ring_around
from rolamento.rows.ball.types import Array, Order, Output

SEVERAL: Final = 8
"""Cases from which on the lanes are worth a second attempt: they take as long for one."""
SHARE: Final = 0.4
"""Part of the work that is left that one more attempt may take."""


@shared
def _start_safely(
    p: Array, column: int, cosines: Array, sines: Array, u: Array, x: Array, pressed: bool
) -> None:
    """A start for the safe path, every ball half way between the grooves.

    Pressed in too far at first; if that leads nowhere, from where the ring stands without load.
    """
    if pressed:
        start(p, column, cosines.size, u)
    else:
        for i in range(layout.DEGREES_OF_FREEDOM):
            u[i] = p[layout.IMPOSED + i, column]
    for j in range(cosines.size):
        c, s = direction(p, column, cosines[j], sines[j])
        a1, a2 = groove(p, column, u, c, s)
        x[j, 0], x[j, 1] = 0.5 * a1, 0.5 * a2


@filling
def _propose(
    batch: Batch,
    moving: bool,
    order: Order,
    cautious: bool,
    room: Room,
    accepted: NDArray[np.bool_],
    out: Output,
) -> None:
    """Take cases along the fast path; what moves is judged there, and accepted or not."""
    displacement, cage, position, reaction, stiffness, residual, _, _, iterations, _ = out
    solve_static(batch, order, moving, room, displacement, position, iterations)
    if not moving:
        return
    solve_moving(batch, order, cautious, room, displacement, cage, position, iterations)
    judge_blocks(
        batch, order, room, displacement, cage, position, reaction, stiffness, residual, accepted
    )
    for k in range(order.size):
        accepted[k] = accepted[k] and iterations[order[k]] > 0


@filling
def _mark_finite(batch: Batch, order: Order, finite: NDArray[np.bool_], room: Array) -> None:
    """Mark the cases whose parameters are numbers; room (cases).

    Row by row, as they lie in memory: so they are near when the lanes are filled.
    """
    room[:] = 0.0
    for row in range(layout.DUTY):
        for k in range(order.size):
            room[k] += 0.0 * batch.duty[row, order[k]]
    alike, bearing = batch.bearing.shape[1] == 1, 0.0
    for row in range(batch.bearing.shape[0]):
        if alike:
            bearing += 0.0 * batch.bearing[row, 0]
        else:
            for k in range(order.size):
                room[k] += 0.0 * batch.bearing[row, order[k]]
    for k in range(order.size):
        finite[k] = room[k] + bearing == 0.0


@inline_exact
def _put_column(batch: Batch, case: int, p: Array) -> None:
    """Put a case's parameters together in a column of their own; (layout.COLUMN or more, 1)."""
    bearing = case if batch.bearing.shape[1] > 1 else 0
    for row in range(p.shape[0]):
        later = row - layout.DUTY
        p[row, 0] = batch.duty[row, case] if later < 0 else batch.bearing[later, bearing]


@kernel
def solve_cases(
    batch: Batch,
    moving: bool,
    order: Order,
    fast: bool,
    most_work: float,
    out: Output,
) -> None:
    """Solve some of the cases, in the order given, and judge every one.

    What is not finite gets the code INVALID_INPUT and is left alone.

    moving: whether these cases have inertia; fast: whether to try the fast path; most_work: how
    often a ball may be evaluated on the others before a case is given up.
    out: displacement (cases, 5), the cage's speed (cases), position (cases, balls, 2), reaction
    (cases, 5), stiffness (cases, 5, 5), residual, code, unsupported and iterations (cases), safe
    (cases): whether the safe path was taken. Tilts in the displacement are scaled as in `layout`.
    """
    cosines, sines = batch.cosines, batch.sines
    (
        displacement, cage, position, reaction, stiffness, residual, code, unsupported, iterations,
        safe,
    ) = out  # fmt: skip
    finite = np.zeros(order.size, np.bool_)
    _mark_finite(batch, order, finite, np.zeros(order.size))
    for case in order[~finite]:
        code[case] = status.INVALID_INPUT
    order = order[finite]
    errors, on_groove = np.zeros((cosines.size, 2)), np.zeros(cosines.size)
    ring, room = ring_around(cosines.size), room_for(batch.mirror.seats.shape[0])
    p = np.empty((layout.DUTY + batch.bearing.shape[0], 1))
    accepted, few = np.zeros(order.size, np.bool_), False
    if fast and order.size > 0:
        _propose(batch, moving, order, True, room, accepted, out)
        left = np.flatnonzero(~accepted)
        few = left.size < SEVERAL
        if not few:
            done = np.zeros(left.size, np.bool_)
            _propose(batch, moving, order[left], False, room, done, out)
            accepted[left] = done
    for place in range(order.size):
        case = order[place]
        unsupported[case], safe[case] = -1, False
        if accepted[place]:
            code[case] = status.CONVERGED
            continue
        _put_column(batch, case, p)
        balls = batch.control[case if batch.control.shape[0] > 1 else 0]
        u, x = displacement[case], position[case]
        code[case] = status.NOT_CONVERGED
        iterations[case] = iterations[case] if fast else 0
        proposed = fast and iterations[case] != 0
        if proposed and iterations[case] > 0:
            code[case], residual[case], unsupported[case] = judge(
                p, 0, moving, balls, cosines, sines, u, cage[case], x, ring, errors
            )
        # a proposal that is not quite there is a start; failing that, begin anew
        escaping, fate, work = -1, status.NO_EQUILIBRIUM, most_work
        for attempt in range(3):
            if code[case] != status.NOT_CONVERGED or (attempt == 0 and not proposed):
                continue
            if attempt > 0:
                _start_safely(p, 0, cosines, sines, u, x, attempt == 1)
                cage[case] = p[layout.NOMINAL_ORBIT, 0]
            ring.work[0] = SHARE * work
            _, steps, escaping, cage[case] = solve_robust(
                p, 0, moving, balls, cosines, sines, u, cage[case], x, ring
            )
            work -= SHARE * work - ring.work[0]
            fate = escaped(p, 0, cosines.size, ring)
            safe[case] = True
            iterations[case] = abs(iterations[case]) + steps
            code[case], residual[case], unsupported[case] = judge(
                p, 0, moving, balls, cosines, sines, u, cage[case], x, ring, errors
            )
        if code[case] == status.NOT_CONVERGED and escaping >= 0:
            code[case] = fate
            unsupported[case] = escaping if fate == status.NO_EQUILIBRIUM else -1
        if code[case] == status.NOT_CONVERGED and few and moving:
            alone, steps = order[place : place + 1], iterations[case]
            _propose(batch, True, alone, False, room, accepted[place:], out)
            settled = iterations[case] > 0
            iterations[case] = steps + abs(iterations[case])
            if accepted[place]:
                code[case] = status.CONVERGED
                continue
            if settled:
                code[case], residual[case], unsupported[case] = judge(
                    p, 0, True, balls, cosines, sines, u, cage[case], x, ring, errors
                )
        if code[case] == status.NOT_CONVERGED:
            heavy = np.empty((p.shape[0], 1))
            put_factors(p, 0, heaviest_factor(p, 0, cosines.size), 0.0, heavy)
            _start_safely(heavy, 0, cosines, sines, u, x, True)
            ring.work[0] = 0.8 * work
            code[case], residual[case], unsupported[case], steps, cage[case] = solve_by_steps(
                p, 0, moving, balls, cosines, sines, u, x, ring, errors
            )
            work -= 0.8 * work - ring.work[0]
            iterations[case] += steps
        if code[case] == status.OVER_SHOULDER:
            on_groove[:] = balls
            ring.work[0] = work
            code[case], residual[case], unsupported[case], steps, cage[case] = solve_off_groove(
                p, 0, moving, on_groove, cosines, sines, u, cage[case], x, ring, errors
            )
            safe[case] = True
            iterations[case] += steps
        read_ring(ring, p[layout.ARM, 0], reaction[case], stiffness[case])
