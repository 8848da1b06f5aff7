"""Run the kernels over a batch of single rows: threads, cases with and without inertia."""

from __future__ import annotations

import logging
from collections import Counter
from dataclasses import dataclass
from threading import Event
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.threads import COMPILING, side_by_side
from rolamento.rows.ball import accept, layout
from rolamento.rows.ball.batch import solve_cases
from rolamento.rows.ball.detail import ball_table, criterion
from rolamento.rows.ball.problem import Floats, directions

_log = logging.getLogger("rolamento")

CHUNK: Final = 2048
FEW: Final = 1
"""Cases that are solved without the compiler, if it has not been loaded yet."""
MOST_WORK: Final = 1.5e5
"""Evaluations of a ball that a case may cost beside the fast path: some 30 ms."""
PLAIN_WORK: Final = 1e4
"""The same without the compiler: a second or so, then it is worth loading."""
LOADING: Final = 400
"""Steps of balls that plain Python takes in the time that it takes to load the compiler."""
_taken: Final[Counter[str]] = Counter()
"""Steps of balls in plain Python so far: after `LOADING` compiled kernels are loaded, if there are
any on disk, so that few single cases wait neither for them nor long without."""
_ready: Final = Event()
"""Set once the compiled kernels have run: to ask for them takes as long as a small case."""
LEAST_INERTIA: Final = 1e-7
"""Approach under a ball's own centrifugal force, over the groove's offset, that still counts."""


@dataclass(slots=True)
class Solution:
    """The kernels' output arrays, in the scaled form of `rows`; filled in place."""

    displacement: Floats
    cage: Floats
    position: Floats
    reaction: Floats
    stiffness: Floats
    residual: Floats
    code: NDArray[np.int64]
    unsupported: NDArray[np.int64]
    iterations: NDArray[np.int64]
    safe: NDArray[np.bool_]

    @classmethod
    def room(cls, cases: int, balls: int) -> Solution:
        """Make room for so many cases, whatever stands in it."""
        n = layout.DEGREES_OF_FREEDOM
        return cls(
            displacement=np.empty((cases, n)),
            cage=np.full(cases, np.nan),  # none at rest
            position=np.empty((cases, balls, 2)),
            reaction=np.empty((cases, n)),
            stiffness=np.empty((cases, n, n)),
            residual=np.empty(cases),
            code=np.empty(cases, np.int64),
            unsupported=np.empty(cases, np.int64),
            iterations=np.empty(cases, np.int64),
            safe=np.empty(cases, np.bool_),
        )

    @classmethod
    def empty(cls, cases: int, balls: int) -> Solution:
        """Make room for so many cases, none of which has a result."""
        solution = cls.room(cases, balls)
        solution.forget(slice(None))
        return solution

    def forget(self, cases: NDArray[np.bool_] | slice) -> None:
        """Leave some of the cases without a result: input that cannot be solved."""
        for array in self.arrays():
            array[cases] = np.nan if array.dtype == np.float64 else 0
        self.code[cases], self.unsupported[cases] = status.INVALID_INPUT, -1

    def arrays(self) -> tuple[NDArray[np.generic], ...]:
        """All arrays, in the order that the kernel takes them."""
        return (
            self.displacement, self.cage, self.position, self.reaction, self.stiffness,
            self.residual, self.code, self.unsupported, self.iterations, self.safe,
        )  # fmt: skip

    def put(self, cases: NDArray[np.intp], part: Self) -> None:
        """Copy the solution of some of the cases to their places."""
        for whole, piece in zip(self.arrays(), part.arrays(), strict=True):
            whole[cases] = piece


def solve_columns(
    p: Floats,
    control: Floats,
    balls: int,
    *,
    threads: int | None = None,
    fast: bool = True,
    most_work: float = MOST_WORK,
) -> Solution:
    """Solve every column of parameters.

    p: (layout.COLUMN, cases); control: +1 or -1 (cases, balls) or (1, balls); most_work: how often
    a ball may be evaluated on a case beside the fast path. Columns that are not finite get the code
    INVALID_INPUT and are left alone.
    """
    cases = p.shape[1]
    solution = Solution.room(cases, balls)
    if cases == 0:
        return solution
    moving = has_inertia(p)
    p, control = np.ascontiguousarray(p), np.ascontiguousarray(control, dtype=np.float64)
    still = np.flatnonzero(~moving)
    if len(still):
        _run_threads(p, control, balls, still, False, threads, fast, most_work, solution)
        # what is left out of those is part of their residual: some have to be solved with it
        again = (solution.code == accept.NEEDS_INERTIA) | (solution.code == status.NOT_CONVERGED)
        moving |= again & turns(p)
    in_motion = np.flatnonzero(moving)
    if len(in_motion):
        _run_threads(p, control, balls, in_motion, True, threads, fast, most_work, solution)
    solution.forget(solution.code == status.INVALID_INPUT)
    return solution


def turns(p: Floats) -> NDArray[np.bool_]:
    """Which columns have any inertia: a speed, and an effect that is switched on."""
    speed = np.abs(p[layout.INNER_SPEED]) + np.abs(p[layout.OUTER_SPEED])
    return np.asarray(speed * np.maximum(p[layout.CENTRIFUGAL], p[layout.GYROSCOPIC]) > 0.0)


def has_inertia(p: Floats) -> NDArray[np.bool_]:
    """Which columns are solved with the balls' inertia from the first.

    The others are tried as at rest: their centrifugal force alone would press a ball in by
    (F/K)^(2/3), not much more than the 1e-16 of the groove's offset to which that is known.
    """
    speed = np.abs(p[layout.INNER_SPEED]) + np.abs(p[layout.OUTER_SPEED])
    force = np.maximum(p[layout.CENTRIFUGAL], 5.0 * p[layout.GYROSCOPIC]) * (0.5 * speed) ** 2
    approach = np.cbrt(force / p[layout.SERIES_STIFFNESS]) ** 2
    with np.errstate(invalid="ignore"):
        return np.asarray(approach > LEAST_INERTIA * p[layout.OUTER_LENGTH])


def _run_threads(
    p: Floats,
    control: Floats,
    balls: int,
    which: NDArray[np.intp],
    moving: bool,
    threads: int | None,
    fast: bool,
    most_work: float,
    solution: Solution,
) -> None:
    """Share some of the cases out to threads, in chunks small enough to keep all of them busy."""
    cases = len(which)
    (cosines, sines), out = directions(balls), solution.arrays()
    if not _ready.is_set():
        plain = _taken["steps"] < LOADING or not solve_cases.is_cached
        if cases <= FEW and not solve_cases.is_loaded and plain:
            if _interpret(p, control, cosines, sines, moving, which, False, PLAIN_WORK, out):
                _taken["steps"] += balls * int(solution.iterations[which].sum())
                return
            solution.put(which, Solution.empty(cases, balls))
        if not solve_cases.is_cached:
            _log.warning(COMPILING)

    def run(first: int) -> None:
        chunk = which[first : first + CHUNK]
        solve_cases.compiled(p, control, cosines, sines, moving, chunk, fast, most_work, out)
        _ready.set()

    side_by_side(run, range(0, cases, CHUNK), threads)


def _interpret(*arguments: Any) -> bool:
    """Solve without the compiler, which takes longer to load than a few cases to solve.

    False where plain Python cannot divide by zero and go on, as compiled code can, and where the
    fast path, which is for compiled code only, might still find a solution.
    """
    try:
        with np.errstate(all="ignore"):
            solve_cases(*arguments)
    except (ZeroDivisionError, OverflowError, ValueError):
        return False
    codes = arguments[-1][6]
    return not (codes == status.NOT_CONVERGED).any()


def ball_azimuths(p: Floats, balls: int) -> Floats:
    """Azimuth of every ball of every case in [0, 2π); (cases, balls)."""
    first = np.arctan2(p[layout.SIN_FIRST], p[layout.COS_FIRST])
    azimuth = first[:, np.newaxis] + 2.0 * np.pi * np.arange(balls) / balls
    wrapped = np.mod(azimuth, 2.0 * np.pi)
    return np.where(wrapped < 2.0 * np.pi, wrapped, 0.0)


def row_verdict(p: Floats, control: Floats, solution: Solution) -> NDArray[np.int64]:
    """Jones's criterion for every ball of a row; (cases, balls)."""
    azimuth = ball_azimuths(p, control.shape[1])
    return criterion(p, ball_table(p, control, solution.displacement, solution.position, azimuth))
