"""From columns of parameters to the result of a batch: one row by the kernels, sets around them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.rows.ball import layout
from rolamento.rows.ball.batch_state import BatchState, RowBatch
from rolamento.rows.ball.columns import Columns
from rolamento.rows.ball.jones import S, System, solve_by_jones
from rolamento.rows.ball.problem import Floats, ring_arms
from rolamento.rows.ball.rolling import Rolling
from rolamento.rows.ball.run import OneRow, Solution, ball_azimuths
from rolamento.rows.ball.sets import SLIDE, RowSet, SetSolution, pressed_in, transform

if TYPE_CHECKING:
    from rolamento.rows.ball.traction.solve import Film


def solve_columns_of(
    columns: Columns,
    *,
    threads: int | None = None,
    fast: bool = True,
    film: Film | None = None,
) -> BatchState:
    """Solve columns of parameters: of one row by the kernels alone, of a set around them.

    film: what shears in the contacts under friction control, instead of Coulomb's friction.
    """
    if not columns.is_plain:
        return _solve_set(columns, threads, fast)
    row = columns.rows[0]
    solution, control, verdict = _controlled(
        OneRow(row.p, row.balls, threads, fast), columns.control
    )
    rolling = None
    if columns.control == "friction":
        solution, rolling = _rolled(columns, solution, threads, film)
    arms = ring_arms(row.p).T
    free = row.p[layout.FREE : layout.FREE + 5].T > 0.0
    applied = row.p[layout.APPLIED : layout.APPLIED + 5].T
    failed = solution.code != status.CONVERGED
    load = np.where(free, applied, solution.reaction) * arms
    displacement = solution.displacement / arms
    stiffness = solution.stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :]
    for array in (load, displacement, stiffness, solution.position, solution.displacement):
        array[failed] = np.nan
    azimuth = ball_azimuths(row.p, row.balls)
    balls = RowBatch(
        row.p, control, solution.position, azimuth, solution.displacement, load, rolling
    )
    return _batch_state(solution, displacement, load, stiffness, verdict, (balls,))


def _rolled(
    columns: Columns, start: Solution, threads: int | None, film: Film | None
) -> tuple[Solution, Rolling | None]:
    """Let friction move the balls; rings that turn alike, or not at all, ask for none."""
    from rolamento.rows.ball.traction.solve import solve_rolling

    row = columns.rows[0]
    return solve_rolling(
        row.p, start, row.balls, columns.friction, columns.cage_drag,
        mesh=columns.mesh, film=film, threads=threads,
    )  # fmt: skip


def _controlled(system: System[S], mode: str) -> tuple[S, Floats, NDArray[np.int64]]:
    """Solve under the raceway control asked for: solution, control used, verdict to show."""
    if mode == "jones":
        return solve_by_jones(system)
    control = np.full((1, system.shape[1]), -1.0 if mode == "inner" else 1.0)
    solution = system.solve(control)
    everywhere = np.broadcast_to(control, system.shape)
    return solution, everywhere, everywhere.astype(np.int64)


def _solve_set(columns: Columns, threads: int | None, fast: bool) -> BatchState:
    system = RowSet(columns, pressed_in(columns, threads=threads), threads, fast)
    solution, control, verdict = _controlled(system, columns.control)
    first = columns.rows[0]
    arms = ring_arms(first.p).T
    failed = solution.code != status.CONVERGED
    load = np.where(columns.free.T, columns.load.T, solution.reaction[:, :5] * arms)
    displacement = solution.displacement[:, :5] / arms
    stiffness = _condensed(solution.stiffness, columns.preload == "spring")
    stiffness = stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :]
    parts = []
    for row, part, own in zip(columns.rows, solution.rows, system.split(control), strict=True):
        t = transform(row, first, sprung=False)[:, :, :5]
        carried = np.einsum("nij,ni->nj", t, part.reaction) * arms
        for array in (part.position, part.displacement, carried):
            array[failed] = np.nan
        azimuth = ball_azimuths(row.p, row.balls)
        parts.append(RowBatch(row.p, own, part.position, azimuth, part.displacement, carried))
    for array in (load, displacement, stiffness):
        array[failed] = np.nan
    return _batch_state(solution, displacement, load, stiffness, verdict, tuple(parts))


def _batch_state(
    solution: Solution | SetSolution,
    displacement: Floats,
    load: Floats,
    stiffness: Floats,
    verdict: NDArray[np.int64],
    parts: tuple[RowBatch, ...],
) -> BatchState:
    """Put a solution, its ring in SI units, and its rows together."""
    return BatchState(
        code=solution.code,
        unsupported=solution.unsupported,
        residual=solution.residual,
        iterations=solution.iterations,
        safe_path=solution.safe,
        displacement=displacement,
        load=load,
        stiffness=stiffness,
        raceway_control=verdict,
        rows=parts,
    )


def _condensed(stiffness: Floats, sprung: bool) -> Floats:
    """The ring's stiffness (cases, 5, 5), with the springs' slide following."""
    ring = stiffness[:, :5, :5].copy()
    if sprung:
        slide = stiffness[:, SLIDE, SLIDE]
        follow = np.divide(
            stiffness[:, SLIDE, :5], slide[:, np.newaxis], where=slide[:, np.newaxis] > 0.0,
            out=np.zeros((len(slide), 5)),
        )  # fmt: skip
        ring -= stiffness[:, :5, SLIDE, np.newaxis] * follow[:, np.newaxis, :]
    return ring
