"""Run the kernels over many cases of a row of rollers: threads, and plain Python for one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics import FloatArray
from rolamento.numerics.threads import share_out
from rolamento.rows.ball.problem import directions
from rolamento.rows.roller.batch import DEGREES, hold_cases, settle_cases
from rolamento.rows.roller.columns import Cut

CHUNK: Final = 64
FEW_LAMINAE: Final = 2000
"""Slices of all rollers of one case that are solved without the compiler, if it is not loaded."""


@lru_cache(maxsize=64)
def _around(rollers: int) -> tuple[FloatArray, FloatArray]:
    """Where the rollers stand; not to be written to."""
    return directions(rollers)


@dataclass(slots=True)
class Solution:
    """The kernels' output arrays, over cases; SI.

    loads (cases, Z, 2, n) are kept of coupled slices only, those of others follow from the state.
    """

    state: FloatArray
    loads: FloatArray
    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    residual: FloatArray
    number: NDArray[np.int64]
    steps: NDArray[np.int64]

    @classmethod
    def empty(cls, cases: int, rollers: int, slices: int, coupled: bool) -> Solution:
        """Make room for so many cases."""
        kept = cases if coupled else 0
        return cls(
            state=np.full((cases, rollers, 2), np.nan),
            loads=np.zeros((kept, rollers, 2, slices)),
            force=np.full((cases, 5), np.nan),
            stiffness=np.full((cases, 5, 5), np.nan),
            scale=np.full(cases, np.nan),
            residual=np.full(cases, np.nan),
            number=np.full(cases, status.INVALID_INPUT),
            steps=np.zeros(cases, np.int64),
        )

    def arrays(self) -> tuple[NDArray[Any], ...]:
        """All arrays, in the order that the kernel takes them."""
        return (
            self.state, self.loads, self.force, self.stiffness, self.scale, self.residual,
            self.number, self.steps,
        )  # fmt: skip

    def put(self, cases: NDArray[np.intp], part: Self) -> None:
        """Copy the solution of some of the cases to their places."""
        for whole, piece in zip(self.arrays(), part.arrays(), strict=True):
            if len(whole):
                whole[cases] = piece


def hold(
    p: FloatArray, cut: Cut, rollers: int, threads: int | None, memory: FloatArray | None = None
) -> Solution:
    """Balance the rollers of every column, its ring where it is imposed.

    memory: a place of the ring and the state of the rollers there, from which they begin;
    (cases, 5 + 2 Z), NaN where there is none.
    """
    cases = p.shape[1]
    found = Solution.empty(cases, rollers, cut.slices, cut.coupled)
    begin = np.full((cases, DEGREES), np.nan)
    if memory is not None:
        begin[:] = memory[:, :DEGREES]
        found.state[:] = memory[:, DEGREES:].reshape(found.state.shape)
    out = found.arrays()
    p = np.ascontiguousarray(p)
    cosines, sines = _around(rollers)

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        loads = out[1] if cut.coupled else np.zeros((1, rollers, 2, cut.slices))
        own = (out[0], loads, *out[2:])
        kernel(p, cut.lines(), cosines, sines, begin, first, last, own)

    share_out(hold_cases, run, cases, chunk=CHUNK, threads=threads, little=_little(p, rollers, cut))
    return found


def settle(
    p: FloatArray, cut: Cut, rollers: int, threads: int | None
) -> tuple[FloatArray, FloatArray, NDArray[np.bool_], NDArray[np.int64]]:
    """Let the rings of every column go: where they and their rollers are, settled, and steps.

    Places (cases, 5), states (cases, Z, 2), whether each came to rest, and in how many steps.
    """
    cases = p.shape[1]
    rings, states = np.zeros((cases, DEGREES)), np.zeros((cases, rollers, 2))
    settled, steps = np.zeros(cases, np.bool_), np.zeros(cases, np.int64)
    p = np.ascontiguousarray(p)
    cosines, sines = _around(rollers)

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        kernel(p, cut.lines(), cosines, sines, first, last, rings, states, settled, steps)

    share_out(
        settle_cases, run, cases, chunk=CHUNK, threads=threads, little=_little(p, rollers, cut)
    )
    return rings, states, settled, steps


def _little(p: FloatArray, rollers: int, cut: Cut) -> bool:
    """Whether it is less work than loading the compiler."""
    return p.shape[1] == 1 and not cut.coupled and rollers * cut.slices <= FEW_LAMINAE
