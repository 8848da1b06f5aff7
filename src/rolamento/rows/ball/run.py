"""Run the kernels over a batch of single rows: threads, cases with and without inertia."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import prod
from operator import attrgetter
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.threads import goes_plainly, ready, share_out
from rolamento.rows.ball import accept, layout
from rolamento.rows.ball.batch import (
    propose_at_rest,
    propose_moving,
    solve_past_edge,
    solve_safely,
    solve_some,
    solve_stepwise,
)
from rolamento.rows.ball.blocks import Batch
from rolamento.rows.ball.detail import ball_table, criterion
from rolamento.rows.ball.mirror import AXES, mirror, planes
from rolamento.rows.ball.problem import Columns, Floats, directions, ring_arms
from rolamento.rows.ball.rolling import Rolling
from rolamento.rows.ball.types import Output

CHUNK: Final = 2048
FEW: Final = 1
"""Cases that are solved without the compiler, if it has not been loaded yet."""
MOST_WORK: Final = 1.5e5
"""Evaluations of a ball that a case may cost beside the fast path: some 30 ms."""
PLAIN_WORK: Final = 1e4
"""The same without the compiler: a second or so, then it is worth loading."""
LEAST_INERTIA: Final = 1e-7
"""Approach under a ball's own centrifugal force, over the groove's offset, that still counts."""
PLAIN: Final = attrgetter("python")
"""The form of a kernel that is not compiled."""
UNSCALED: Final = np.ones((1, layout.DEGREES_OF_FREEDOM))
"""The arms of a response whose place nobody asks for."""


@dataclass(slots=True)
class BallResponse:
    """Balls in their places, in the kernels' arrays, filled in place.

    The displacement is scaled as `layout` has it, by the lengths that turn places into SI: arms
    (cases or 1, 5). Force and stiffness are in SI. motion: of balls that friction alone moves.
    """

    displacement: Floats
    cage: Floats
    position: Floats
    force: Floats
    stiffness: Floats
    residual: Floats
    number: NDArray[np.int64]
    unsupported: NDArray[np.int64]
    iterations: NDArray[np.int64]
    safe_path: NDArray[np.bool_]
    arms: Floats
    motion: Rolling | None = None

    @classmethod
    def room(cls, cases: int, balls: int, arms: Floats = UNSCALED) -> BallResponse:
        """Make room for so many cases, whatever stands in it."""
        n = layout.DEGREES_OF_FREEDOM
        shapes = ((n,), (), (balls, 2), (n,), (n, n), ())
        ends = np.cumsum([0, *(cases * prod(shape) for shape in shapes)])
        # together: the system hands out many small pages more slowly than few large ones
        whole = np.empty(ends[-1])
        displacement, cage, position, force, stiffness, residual = (
            whole[a:z].reshape(cases, *shape)
            for a, z, shape in zip(ends[:-1], ends[1:], shapes, strict=True)
        )
        cage[:] = np.nan  # none at rest
        number, unsupported, iterations = (np.empty(cases, np.int64) for _ in range(3))
        return cls(
            displacement, cage, position, force, stiffness, residual, number, unsupported,
            iterations, np.empty(cases, np.bool_), arms,
        )  # fmt: skip

    @classmethod
    def empty(cls, cases: int, balls: int, arms: Floats = UNSCALED) -> BallResponse:
        """Make room for so many cases, none of which has a result."""
        response = cls.room(cases, balls, arms)
        response.forget(slice(None))
        return response

    def forget(self, cases: NDArray[np.bool_] | slice) -> None:
        """Leave some of the cases without a result: input that cannot be solved."""
        for array in self.arrays():
            array[cases] = np.nan if array.dtype == np.float64 else 0
        self.number[cases], self.unsupported[cases] = status.INVALID_INPUT, -1

    def arrays(self) -> Output:
        """All arrays, as the kernels take them."""
        return Output(*(getattr(self, name) for name in Output._fields))

    @property
    def place(self) -> Floats:
        """(cases, 5), m and rad."""
        return self.displacement / self.arms

    @property
    def face_forces(self) -> Floats:
        """(cases, 1, 5)."""
        return self.force[:, np.newaxis]

    @property
    def scale(self) -> Floats:
        """(cases,), N."""
        return np.asarray(np.abs(self.force / self.arms).max(axis=1))

    @property
    def memory(self) -> Floats | None:
        """Where moving balls are, and the cage's speed, for `solve_columns` to begin with.

        (cases, any); those at rest begin anew.
        """
        if np.isnan(self.cage).all():
            return None
        return np.column_stack([self.position.reshape(len(self.cage), -1), self.cage])

    def put(self, cases: NDArray[np.intp], part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        for whole, piece in zip(self.arrays(), part.arrays(), strict=True):
            if whole.flags.writeable:  # else no case has it
                whole[cases] = piece


def solve_columns(
    p: Columns,
    control: Floats,
    balls: int,
    *,
    threads: int | None = None,
    fast: bool = True,
    most_work: float = MOST_WORK,
    memory: Floats | None = None,
) -> BallResponse:
    """Solve every column of parameters.

    control: +1 or -1 (cases, balls) or (1, balls); most_work: how often a ball may be evaluated on
    a case beside the fast path; memory: of a `BallResponse` of columns much like these, from which
    moving balls begin where it is no NaN, their rings held. Columns that are not finite get the
    code INVALID_INPUT and are left alone.
    """
    cases = p.cases
    solution = BallResponse.room(cases, balls, ring_arms(p).T)
    if cases == 0:
        return solution
    moving, batch = has_inertia(p), _batch(p, control, balls)
    plane = planes(p, control) if fast else np.zeros(cases, np.int8)
    near, done = np.zeros(cases, np.bool_), np.zeros(cases, np.bool_)
    if memory is not None and fast:
        near = moving & np.isfinite(memory).all(axis=1)
        _begin_nearby(p, memory, near, solution)
    if near.any() and not goes_plainly(propose_moving, little=cases <= FEW):
        for number in (0, *AXES):
            own = batch._replace(mirror=mirror(balls, number))
            _run_warm(own, np.flatnonzero(near & (plane == number)), threads, solution)
        done = near & (solution.number == status.CONVERGED)
        near[:] = False
    for with_inertia in (False, True):
        which = moving & ~done if with_inertia else ~moving
        for number in (0, *AXES):
            own = batch._replace(mirror=mirror(balls, number))
            some = np.flatnonzero(which & (plane == number))
            _run_threads(own, some, with_inertia, threads, fast, most_work, solution, near)
        # what is left out at rest is part of the residual: some have to be solved with it
        left_out = solution.number == accept.NEEDS_INERTIA
        moving |= (left_out | (solution.number == status.NOT_CONVERGED)) & has_inertia(p, 0.0)
    invalid = solution.number == status.INVALID_INPUT
    if invalid.any():
        solution.forget(invalid)
    return solution


def _batch(p: Columns, control: Floats, balls: int) -> Batch:
    return Batch(
        np.ascontiguousarray(p.duty),
        np.ascontiguousarray(p.bearing),
        np.ascontiguousarray(control, dtype=np.float64),
        *directions(balls),
        mirror(balls, 0),
    )


def compile_all(p: Columns, control: Floats, balls: int) -> None:
    """Compile every kernel that some case may need, whether these cases do or not."""
    batch, out = _batch(p, control, balls), BallResponse.empty(p.cases, balls).arrays()
    none, done, work = np.zeros(0, np.int64), np.zeros(0, np.bool_), np.zeros(0)
    ready(propose_moving)(batch, none, True, False, done, out)
    ready(propose_at_rest)(batch, none, done, out)
    ready(solve_safely)(batch, True, True, none, True, work, out)
    for rarely in (solve_stepwise, solve_past_edge):
        ready(rarely)(batch, True, True, none, work, out)


def has_inertia(p: Columns, least: float = LEAST_INERTIA) -> NDArray[np.bool_]:
    """Which columns are solved with the balls' inertia from the first; all that have any: least 0.

    The others are tried as at rest: their centrifugal force alone would press a ball in by
    (F/K)^(2/3), not much more than the 1e-16 of the groove's offset to which that is known.
    least: that approach over the offset, from which on it counts.
    """
    speed = np.abs(p[layout.INNER_SPEED]) + np.abs(p[layout.OUTER_SPEED])
    force = np.maximum(p[layout.CENTRIFUGAL], 5.0 * p[layout.GYROSCOPIC]) * (0.5 * speed) ** 2
    with np.errstate(invalid="ignore"):
        approach = least * p[layout.OUTER_LENGTH]
        return np.asarray(force > p[layout.SERIES_STIFFNESS] * approach * np.sqrt(approach))


def _begin_nearby(
    p: Columns, memory: Floats, near: NDArray[np.bool_], solution: BallResponse
) -> None:
    """Put rings where they are held, and balls and cage where they were."""
    solution.displacement[near] = p[layout.IMPOSED : layout.IMPOSED + 5].T[near]
    solution.position[near] = memory[near, :-1].reshape(-1, *solution.position.shape[1:])
    solution.cage[near] = memory[near, -1]


def _run_warm(
    batch: Batch, which: NDArray[np.intp], threads: int | None, solution: BallResponse
) -> None:
    """Balance balls from where they stand; what does not settle is left not converged."""
    out, done = solution.arrays(), np.zeros(len(which), np.bool_)

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        kernel(batch, which[first:last], True, True, done[first:last], out)

    share_out(propose_moving, run, len(which), chunk=CHUNK, threads=threads, little=False)


def _run_threads(
    batch: Batch,
    which: NDArray[np.intp],
    moving: bool,
    threads: int | None,
    fast: bool,
    most_work: float,
    solution: BallResponse,
    near: NDArray[np.bool_],
) -> None:
    """Share some of the cases out to threads, in chunks small enough to keep all of them busy.

    near: which of all cases begin where they stand, where they are solved plainly.
    """
    cases, balls, out = len(which), batch.cosines.size, solution.arrays()
    if cases == 0:
        return
    first_kernel = (propose_moving if moving else propose_at_rest) if fast else solve_safely
    left: list[int] = []

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        some = which[first:last]
        if kernel is first_kernel:
            left.extend(
                case for case in some if not _interpret(batch, moving, case, out, near[case])
            )
        else:
            solve_some(batch, moving, some, fast, most_work, out)

    share_out(first_kernel, run, cases, chunk=CHUNK, threads=threads, little=cases <= FEW)
    if left:
        hard = np.array(left)
        solution.put(hard, BallResponse.empty(len(hard), balls))
        solve_some(batch, moving, hard, fast, most_work, out)


def _interpret(batch: Batch, moving: bool, case: int, out: Output, begun: bool) -> bool:
    """Solve a case without the compiler, which takes longer to load than a few cases to solve.

    As long as it takes where nothing is compiled yet: to wait for that takes longer. False where
    plain Python cannot divide by zero and go on, as compiled code can, and where the fast path,
    which is for compiled code only, might still find a solution.
    """
    for work in (PLAIN_WORK, MOST_WORK):
        try:
            solve_some(batch, moving, np.array([case]), False, work, out, PLAIN, begun=begun)
        except (ZeroDivisionError, OverflowError, ValueError):
            return False
        if out.number[case] != status.NOT_CONVERGED:
            return True
        if solve_stepwise.is_cached:
            return False
        begun = False
    return False


def ball_azimuths(p: Columns, balls: int) -> Floats:
    """Azimuth of every ball of every case in [0, 2π); (cases, balls)."""
    first = np.arctan2(p[layout.SIN_FIRST], p[layout.COS_FIRST])
    azimuth = first[:, np.newaxis] + 2.0 * np.pi * np.arange(balls) / balls
    wrapped = np.mod(azimuth, 2.0 * np.pi)
    return np.where(wrapped < 2.0 * np.pi, wrapped, 0.0)


def row_verdict(p: Columns, control: Floats, solution: BallResponse) -> NDArray[np.int64]:
    """Jones's criterion for every ball of a row; (cases, balls)."""
    return criterion(p, ball_table(p, control, solution.displacement, solution.position))
