"""Many cases through the fast path, the judgement and, where needed, the safe path.

Every case takes the same ways in the same order, whatever stands beside it: in lanes with caution,
in lanes without, then one by one from where it stands, from a ring pressed in and from one that is
free, from where caution had led, and step by step. So its result does not depend on its
neighbours. Each way is a kernel of its own, compiled when a case first needs it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.compiled import Kernel, inline_exact, kernel, shared
from rolamento.numerics.threads import ready
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import judge
from rolamento.rows.ball.blocks import (
    Batch,
    judge_blocks,
    room_for,
    solve_moving,
    solve_static,
    start,
)
from rolamento.rows.ball.continuation import heaviest_factor, put_factors, solve_by_steps
from rolamento.rows.ball.edges import solve_off_groove
from rolamento.rows.ball.robust import escaped, solve_robust
from rolamento.rows.ball.settle import held_up
from rolamento.rows.ball.single import (
    OFF_GROOVE,
    OneCase,
    direction,
    groove,
    read_ring,
    ring_around,
)
from rolamento.rows.ball.types import Array, Order, Output

STEPWISE: Final = 0.8
"""Part of the work that is left that going step by step may take."""
SHARE: Final = 0.2
"""Part of the work that is left that one more attempt may take."""


@shared
def _start_safely(
    p: Array,
    column: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    cage: float,
    u: Array,
    x: Array,
    pressed: bool,
) -> None:
    """A start for the safe path, every ball half way between the grooves or held up by its force.

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
        if moving and abs(control[j]) < OFF_GROOVE:
            side = 1.0 if a1 >= 0.0 else -1.0
            x1, x[j, 1] = held_up(p, column, cage, control[j], side * a1, a2)
            x[j, 0] = side * x1


@shared
def _refuse_unsound(batch: Batch, order: Order, done: NDArray[np.bool_], out: Output) -> None:
    """Give the cases whose parameters are no numbers their verdict.

    Row by row, as they lie in memory: so they are near when the lanes are filled.
    """
    room = np.zeros(order.size)
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
        done[k] = room[k] + bearing != 0.0
        if done[k]:
            out.number[order[k]] = status.INVALID_INPUT


@inline_exact
def _put_column(batch: Batch, case: int, p: Array) -> Array:
    """Put a case's parameters in a column of their own, (layout.COLUMN or more, 1).

    Returns the control of its balls.
    """
    bearing = case if batch.bearing.shape[1] > 1 else 0
    for row in range(p.shape[0]):
        later = row - layout.DUTY
        p[row, 0] = batch.duty[row, case] if later < 0 else batch.bearing[later, bearing]
    control: Array = batch.control[case if batch.control.shape[0] > 1 else 0]
    return control


@kernel
def propose_at_rest(batch: Batch, order: Order, done: NDArray[np.bool_], out: Output) -> None:
    """Balance the rings of cases without inertia in lanes, and judge them one by one.

    order: the cases; done (cases of order): those that have a verdict. What is not finite gets the
    code INVALID_INPUT and is left alone. out: as `solve_some`.
    """
    displacement, cage, position, reaction, stiffness, residual, code, unsupported = out[:8]
    iterations, safe = out.iterations, out.safe_path
    _refuse_unsound(batch, order, done, out)
    some = order[~done]
    balls = batch.cosines.size
    room = room_for(batch.mirror.seats.shape[0])
    solve_static(batch, some, False, room, displacement, position, iterations)
    ring, errors = ring_around(balls, False), np.zeros((balls, 2))
    p = np.empty((layout.DUTY + batch.bearing.shape[0], 1))
    for place in range(order.size):
        case = order[place]
        if done[place]:
            continue
        code[case], unsupported[case], safe[case] = status.NOT_CONVERGED, -1, False
        if iterations[case] > 0:
            control = _put_column(batch, case, p)
            one = OneCase(
                p, 0, False, control, batch.cosines, batch.sines, displacement[case],
                position[case], ring, errors,
            )  # fmt: skip
            code[case], residual[case], unsupported[case] = judge(one, cage[case])
            read_ring(ring, p[layout.ARM, 0], reaction[case], stiffness[case])
        done[place] = code[case] != status.NOT_CONVERGED and code[case] != status.OVER_SHOULDER


@kernel
def propose_moving(
    batch: Batch, order: Order, cautious: bool, warm: bool, done: NDArray[np.bool_], out: Output
) -> None:
    """Balance rings and balls of cases with inertia in lanes, and judge them there.

    As `propose_at_rest`; cautious: as `blocks.solve_moving`; warm: whether ring, balls and cage
    begin where they stand in out. What is not accepted is left to be
    judged one by one, where it settled (iterations > 0).
    """
    displacement, cage, position, reaction, stiffness, residual, code, unsupported = out[:8]
    iterations, safe = out.iterations, out.safe_path
    _refuse_unsound(batch, order, done, out)
    some = order[~done]
    if some.size == 0:
        return
    room = room_for(batch.mirror.seats.shape[0])
    accepted = np.zeros(some.size, np.bool_)
    if not warm:
        solve_static(batch, some, True, room, displacement, position, iterations)
    solve_moving(batch, some, cautious, warm, room, displacement, cage, position, iterations)
    judge_blocks(
        batch, some, room, displacement, cage, position, reaction, stiffness, residual, accepted
    )
    next_one = 0
    for place in range(order.size):
        if done[place]:
            continue
        case = order[place]
        done[place] = accepted[next_one] and iterations[case] > 0
        code[case] = status.CONVERGED if done[place] else status.NOT_CONVERGED
        unsupported[case], safe[case] = -1, False
        next_one += 1


@kernel
def solve_safely(
    batch: Batch, moving: bool, abreast: bool, order: Order, anew: bool, work: Array, out: Output
) -> None:
    """Solve cases one by one from where they stand, and where that fails and `anew`, from afresh.

    work (cases of order): how often a ball may still be evaluated, counted down. out: as
    `solve_some`; iterations: positive where a case settled and has not been judged, zero where it
    has no start.
    """
    displacement, cage, position, reaction, stiffness, residual, code, unsupported = out[:8]
    iterations, safe = out.iterations, out.safe_path
    cosines, sines = batch.cosines, batch.sines
    ring, errors = ring_around(cosines.size, abreast), np.zeros((cosines.size, 2))
    p = np.empty((layout.DUTY + batch.bearing.shape[0], 1))
    for place in range(order.size):
        case = order[place]
        control = _put_column(batch, case, p)
        u, x = displacement[case], position[case]
        one = OneCase(p, 0, moving, control, cosines, sines, u, x, ring, errors)
        if iterations[case] > 0 and code[case] == status.NOT_CONVERGED:
            code[case], residual[case], unsupported[case] = judge(one, cage[case])
        # a proposal that is not quite there is a start; failing that, begin anew
        escaping, fate, started = -1, status.NO_EQUILIBRIUM, iterations[case] != 0
        for attempt in range(3 if anew else 1):
            if code[case] != status.NOT_CONVERGED or (attempt == 0 and not started):
                continue
            if attempt > 0:
                cage[case] = p[layout.NOMINAL_ORBIT, 0]
                _start_safely(p, 0, moving, control, cosines, sines, cage[case], u, x, attempt == 1)
            ring.work[0] = SHARE * work[place]
            _, steps, escaping, cage[case] = solve_robust(one, cage[case])
            work[place] -= SHARE * work[place] - ring.work[0]
            fate = escaped(p, 0, cosines.size, ring)
            safe[case] = True
            iterations[case] = abs(iterations[case]) + steps
            code[case], residual[case], unsupported[case] = judge(one, cage[case])
        if anew and code[case] == status.NOT_CONVERGED and escaping >= 0:
            code[case] = fate
            unsupported[case] = escaping if fate == status.NO_EQUILIBRIUM else -1
        read_ring(ring, p[layout.ARM, 0], reaction[case], stiffness[case])


@kernel
def solve_stepwise(
    batch: Batch, moving: bool, abreast: bool, order: Order, work: Array, out: Output
) -> None:
    """Solve cases one by one from a heavy load or from rest, step by step; as `solve_safely`."""
    displacement, cage, position, reaction, stiffness, residual, code, unsupported = out[:8]
    iterations, safe = out.iterations, out.safe_path
    cosines, sines = batch.cosines, batch.sines
    ring, errors = ring_around(cosines.size, abreast), np.zeros((cosines.size, 2))
    p = np.empty((layout.DUTY + batch.bearing.shape[0], 1))
    heavy = np.empty((p.shape[0], 1))
    for place in range(order.size):
        case = order[place]
        control = _put_column(batch, case, p)
        u, x = displacement[case], position[case]
        put_factors(p, 0, heaviest_factor(p, 0, cosines.size), 0.0, heavy)
        _start_safely(heavy, 0, False, control, cosines, sines, 0.0, u, x, True)
        ring.work[0] = STEPWISE * work[place]
        code[case], residual[case], unsupported[case], steps, cage[case] = solve_by_steps(
            OneCase(p, 0, moving, control, cosines, sines, u, x, ring, errors)
        )
        work[place] -= STEPWISE * work[place] - ring.work[0]
        safe[case] = True
        iterations[case] = abs(iterations[case]) + steps
        read_ring(ring, p[layout.ARM, 0], reaction[case], stiffness[case])


@kernel
def solve_past_edge(
    batch: Batch, moving: bool, abreast: bool, order: Order, work: Array, out: Output
) -> None:
    """Balance rings without the balls that have left their groove; as `solve_safely`."""
    displacement, cage, position, reaction, stiffness, residual, code, unsupported = out[:8]
    iterations, safe = out.iterations, out.safe_path
    cosines, sines = batch.cosines, batch.sines
    ring, errors = ring_around(cosines.size, abreast), np.zeros((cosines.size, 2))
    p = np.empty((layout.DUTY + batch.bearing.shape[0], 1))
    on_groove = np.empty(cosines.size)
    for place in range(order.size):
        case = order[place]
        on_groove[:] = _put_column(batch, case, p)
        ring.work[0] = work[place]
        one = OneCase(
            p, 0, moving, on_groove, cosines, sines, displacement[case], position[case], ring,
            errors,
        )  # fmt: skip
        code[case], residual[case], unsupported[case], steps, cage[case] = solve_off_groove(
            one, cage[case]
        )
        safe[case] = True
        iterations[case] += steps
        read_ring(ring, p[layout.ARM, 0], reaction[case], stiffness[case])


def solve_some(
    batch: Batch,
    moving: bool,
    order: Order,
    fast: bool,
    most_work: float,
    out: Output,
    form: Callable[[Kernel[..., None]], Callable[..., None]] = ready,
    *,
    begun: bool = False,
) -> None:
    """Solve some of the cases, and judge every one; what is not finite is left alone.

    moving: whether these cases have inertia; fast: whether to try the lanes; most_work: how
    often a ball may be evaluated beside them before a case is given up; form: of the kernels,
    compiled or plain; begun: whether rings, balls and cages begin where they stand in out, beside
    the lanes.
    """
    code, iterations = out.number, out.iterations
    done = np.zeros(len(order), np.bool_)
    if not fast:
        with np.errstate(invalid="ignore"):
            _refuse_unsound(batch, order, done, out)
        left, cautious = order[~done], None
        code[left], iterations[left] = status.NOT_CONVERGED, -1 if begun else 0
        out.unsupported[left], out.safe_path[left] = -1, False
    elif moving:
        form(propose_moving)(batch, order, True, False, done, out)
        left = order[~done]
        cautious = [array[left].copy() for array in (*out[:3], iterations)]
        if left.size:
            done = np.zeros(left.size, np.bool_)
            form(propose_moving)(batch, left, False, False, done, out)
            cautious, left = [array[~done] for array in cautious], left[~done]
    else:
        form(propose_at_rest)(batch, order, done, out)
        left, cautious = order[~done], None
    if not left.size:
        return
    work = np.full(left.size, most_work)
    form(solve_safely)(batch, moving, fast, left, True, work, out)
    open_still = code[left] == status.NOT_CONVERGED
    if cautious is not None and open_still.any():
        again = left[open_still]
        for whole, part in zip((*out[:3], iterations), cautious, strict=True):
            whole[again] = part[open_still]
        _try(form(solve_safely), batch, moving, fast, (left, open_still, work), out, False)
        open_still = code[left] == status.NOT_CONVERGED
    if open_still.any():
        _try(form(solve_stepwise), batch, moving, fast, (left, open_still, work), out)
    past = code[left] == status.OVER_SHOULDER
    if past.any():
        _try(form(solve_past_edge), batch, moving, fast, (left, past, work), out)


def _try(
    kernel: Callable[..., None],
    batch: Batch,
    moving: bool,
    abreast: bool,
    cases: tuple[Order, NDArray[np.bool_], Array],
    out: Output,
    *more: bool,
) -> None:
    """Send some of the cases through a kernel: (all, which of them, the work that is left)."""
    order, which, work = cases
    own = work[which]
    kernel(batch, moving, abreast, order[which], *more, own, out)
    work[which] = own
