"""Run the kernels over many cases of rows of balls on one ring: threads, and what takes part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from typing import Any, Final

import numpy as np

from rolamento import status
from rolamento.numerics import FloatArray
from rolamento.numerics.threads import goes_plainly, ready, side_by_side
from rolamento.records import frozen
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import NEEDS_INERTIA
from rolamento.rows.ball.problem import Columns, directions, ring_arms
from rolamento.rows.ball.row import BallRow
from rolamento.rows.ball.run import BallResponse, has_inertia
from rolamento.rows.ball.set_blocks import (
    HELD,
    PRESS,
    SPRINGS,
    STANDING,
    Balance,
    BalanceRequest,
    Rows,
    Work,
    solve_sets,
)
from rolamento.rows.ball.set_lanes import LEVER, SLIDE, TILT, UNKNOWNS, WAY
from rolamento.rows.row import Indices, IntArray, OnRing, Proposal

__all__ = ["settle", "standing"]

CHUNK: Final = 1500
"""Cases of a call: their numbers lie together, no power of two apart."""
SMALL_STIFFNESS: Final = 1e-6
"""Fraction of the stiffness under load: what a ring that touches nothing is held by on its way."""
_HEAVIEST: Final = 4.5
"""How much more the heaviest ball of a row carries than the mean."""


def standing(ring: OnRing) -> FloatArray:
    """How each row stands on the ring, as `set_blocks.Rows` has it."""
    arms = ring.arms[0]
    stand = np.empty((len(ring.ways), STANDING, len(arms)))
    parts = zip(stand, ring.ways, ring.levers, ring.arms, ring.press, strict=True)
    for own, way, lever, arm, pressed in parts:
        own[WAY], own[LEVER], own[TILT] = way, lever / arms, way * arm / arms
        own[SLIDE] = 1.0 if ring.sprung and way < 0.0 else 0.0
        own[PRESS] = pressed
    return stand


def settle(rows: Sequence[BallRow], ring: OnRing) -> Proposal | None:
    """Balance the rings of some cases, with all their rows; None where that takes no compiler."""
    if goes_plainly(solve_sets, little=False):
        return None
    run = _Run.of(rows, ring)
    inertia = np.stack([has_inertia(p) for p in run.columns])
    still = ring.sound & ~inertia.any(axis=0)
    moving = ring.sound & inertia.all(axis=0)
    if still.any():
        run.solve(np.flatnonzero(still), moving=False)
        # what is left out of those is part of their residual: some have to be solved with it
        again = still & (run.found.code == NEEDS_INERTIA).any(axis=0)
        moving |= again & np.all([has_inertia(p, 0.0) for p in run.columns], axis=0)
    if moving.any():
        run.solve(np.flatnonzero(moving), moving=True)
    return run.proposal()


def _bounded(
    columns: Sequence[Columns],
    rows: Sequence[BallRow],
    stand: FloatArray,
    free: FloatArray,
    target: FloatArray,
    start: FloatArray,
    arm: FloatArray,
) -> BalanceRequest:
    """Say how far a ring may go at a time: through its play, and somewhat into its balls."""
    balls = [row.element_count for row in rows]
    stiffness = np.sum(
        [count * p[layout.SERIES_STIFFNESS] for count, p in zip(balls, columns, strict=True)],
        axis=0,
    )
    into = (_HEAVIEST * reduce(np.maximum, np.abs(target * free).T) / stiffness) ** (2.0 / 3.0)
    play = np.zeros_like(into)
    for p, own in zip(columns, stand, strict=True):
        reach = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
        square = np.maximum(reach**2 - p[layout.RADIAL_OFFSET] ** 2, 0.0)
        axial = np.sqrt(square) - p[layout.AXIAL_OFFSET]
        play = np.maximum(play, np.abs(axial) + np.abs(own[PRESS]))
    firm = SMALL_STIFFNESS * stiffness * np.sqrt(into)
    return BalanceRequest(free, target, start, 3.0 * into + play, firm, arm)


def _control_of(rows: Sequence[BallRow], which: Indices) -> FloatArray:
    """What guides the balls of all rows; (cases or 1, balls)."""
    parts = [row.control_of(which) for row in rows]
    cases = max(len(part) for part in parts)
    return np.concatenate([np.broadcast_to(p, (cases, p.shape[1])) for p in parts], axis=1)


@frozen
class _Run:
    """The numbers of the cases and the room for what is found; columns: of each row."""

    rows: Sequence[BallRow]
    columns: list[Columns]
    control: FloatArray
    stand: FloatArray
    asked: BalanceRequest
    found: Balance

    @classmethod
    def of(cls, rows: Sequence[BallRow], ring: OnRing) -> _Run:
        which = ring.which
        every = len(which) == rows[0].cases
        columns = [row.p if every else row.p.of(which) for row in rows]
        control, stand = _control_of(rows, which), standing(ring)
        asked = ring.free.astype(np.float64), ring.target, ring.start, ring.arms[0]
        count, n = len(rows), len(which)
        balls = sum(row.element_count for row in rows)
        five = layout.DEGREES_OF_FREEDOM
        found = Balance(
            place=np.empty((n, UNKNOWNS)),
            force=np.empty((n, UNKNOWNS)),
            stiffness=np.empty((n, UNKNOWNS, UNKNOWNS)),
            residual=np.full(n, np.nan),
            steps=np.zeros(n, np.int64),
            sound=np.zeros(n, np.bool_),
            position=np.empty((n, balls, 2)),
            displacement=np.empty((count, n, five)),
            reaction=np.empty((count, n, five)),
            row_stiffness=np.empty((count, n if ring.tangents else 0, five, five)),
            cage=np.full((count, n), np.nan),
            row_residual=np.full((count, n), np.nan),
            code=np.full((count, n), status.INVALID_INPUT),
        )
        return cls(rows, columns, control, stand, _bounded(columns, rows, stand, *asked), found)

    @property
    def _ends(self) -> IntArray:
        return np.cumsum([0, *(row.element_count for row in self.rows)])

    def solve(self, chosen: IntArray, *, moving: bool) -> None:
        """Solve some of the cases, in threads, chunks of them at a time."""
        counts = [row.element_count for row in self.rows]
        few = [min(count, SPRINGS) for count in counts]
        cosines, sines = np.concatenate([directions(count) for count in counts], axis=1)
        springs = np.concatenate([directions(count) for count in few], axis=1)
        spring_ends = np.cumsum([0, *few])
        longest = max(len(p.bearing) for p in self.columns)
        column = layout.DUTY + longest
        alike = all(p.bearing.shape[1] == 1 for p in self.columns)

        kernel, ends = ready(solve_sets), self._ends
        spare = list[Work]()

        def run(chosen: IntArray) -> None:
            first, last = int(chosen[0]), int(chosen[-1]) + 1
            # cases in a row are looked at, not copied
            some: Any = slice(first, last) if last - first == len(chosen) else chosen
            duty = np.stack([p.duty[HELD:, some] for p in self.columns])
            bearing = np.zeros((len(self.rows), longest, 1 if alike else len(chosen)))
            for own, columns in zip(bearing, self.columns, strict=True):
                part = columns.bearing
                own[: len(part)] = part if part.shape[1] == 1 else part[:, some]
            control = self.control if len(self.control) == 1 else self.control[some]
            # one order in memory: the kernels are compiled for each that they meet
            parts = duty, self.stand[:, :, some], control
            duty, stand, control = map(np.ascontiguousarray, parts)
            rows = Rows(
                duty, bearing, stand, control, cosines, sines, ends, springs, spring_ends,
            )  # fmt: skip
            asked = BalanceRequest(*(np.ascontiguousarray(one[some]) for one in self.asked))
            work = spare.pop() if spare else Work.of(len(self.rows), len(cosines), sum(few), column)
            kernel(rows, asked, moving, chosen, work, self.found)
            spare.append(work)

        chunks = [chosen[first : first + CHUNK] for first in range(0, len(chosen), CHUNK)]
        side_by_side(run, chunks, self.rows[0].threads)

    def proposal(self) -> Proposal:
        """What was found, row by row; NaN of what nothing was found of."""
        found = self.found
        lost = np.flatnonzero(found.steps == 0)
        for array in (found.place, found.force, found.stiffness, found.position):
            array[lost] = np.nan
        for array in (found.displacement, found.reaction, found.row_stiffness):
            if array.shape[1]:
                array[:, lost] = np.nan
        return Proposal(
            place=found.place,
            force=found.force,
            stiffness=found.stiffness,
            residual=np.fmax(found.residual, found.row_residual.max(axis=0)),
            steps=found.steps,
            sound=found.sound,
            rows=list(self._held()),
        )

    def _held(self) -> Iterator[BallResponse]:
        found, n = self.found, len(self.found.steps)
        tangents = found.row_stiffness
        if not tangents.shape[1]:
            tangents = np.broadcast_to(np.nan, (len(self.rows), n, *tangents.shape[2:]))
        for row, (p, a, z) in enumerate(
            zip(self.columns, self._ends[:-1], self._ends[1:], strict=True)
        ):
            yield BallResponse(
                displacement=found.displacement[row],
                cage=found.cage[row],
                position=found.position[:, a:z],
                force=found.reaction[row],
                stiffness=tangents[row],
                residual=found.row_residual[row],
                number=found.code[row],
                unsupported=np.full(n, -1),
                iterations=np.zeros(n, np.int64),
                safe_path=np.zeros(n, np.bool_),
                arms=ring_arms(p).T,
            )
