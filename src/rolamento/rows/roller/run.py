"""Run the kernels over many cases of a row of rollers: threads, and plain Python for one."""

from __future__ import annotations

import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from time import perf_counter
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import Kernel
from rolamento.numerics.threads import thread_count
from rolamento.rows.ball.problem import directions
from rolamento.rows.roller.batch import hold_cases, settle_cases
from rolamento.rows.roller.columns import Cut

_log = logging.getLogger("rolamento")

CHUNK: Final = 64
LITTLE: Final = 2000
"""Slices of all rollers of one case that are solved without the compiler, if it is not loaded."""
LONG: Final = 1.0
"""Seconds of plain Python in this process after which the compiler is worth loading."""
_spent: Final = [0.0]
_ready: Final[set[Kernel[..., None]]] = set()
"""What has been compiled or loaded: to ask each time takes as long as a small case."""


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


def hold(p: FloatArray, cut: Cut, rollers: int, threads: int | None) -> Solution:
    """Balance the rollers of every column, its ring where it is imposed."""
    cases = p.shape[1]
    found = Solution.empty(cases, rollers, cut.slices, cut.coupled)
    out = found.arrays()
    p = np.ascontiguousarray(p)
    cosines, sines = _around(rollers)

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        loads = out[1] if cut.coupled else np.zeros((1, rollers, 2, cut.slices))
        own = (out[0], loads, *out[2:])
        kernel(p, cut.lines(), cosines, sines, first, last, own)

    _run_threads(hold_cases, run, cases, rollers * cut.slices, cut.coupled, threads)
    return found


def settle(
    p: FloatArray, cut: Cut, rollers: int, threads: int | None
) -> tuple[FloatArray, NDArray[np.bool_], NDArray[np.int64]]:
    """Let the rings of every column go: places (cases, 5), whether each came to rest, and steps."""
    cases = p.shape[1]
    rings = np.zeros((cases, 5))
    settled, steps = np.zeros(cases, np.bool_), np.zeros(cases, np.int64)
    p = np.ascontiguousarray(p)
    cosines, sines = _around(rollers)

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        kernel(p, cut.lines(), cosines, sines, first, last, rings, settled, steps)

    _run_threads(settle_cases, run, cases, rollers * cut.slices, cut.coupled, threads)
    return rings, settled, steps


def _run_threads(
    kernel: Kernel[..., None],
    run: Callable[[Callable[..., Any], int, int], None],
    cases: int,
    slices: int,
    coupled: bool,
    threads: int | None,
) -> None:
    """Share the cases out to threads; one small one runs as plain Python while nothing is loaded.

    Loading the compiler takes longer than that.
    """
    little = cases == 1 and not coupled and slices <= LITTLE and kernel not in _ready
    if little and (_spent[0] < LONG or not kernel.is_cached):
        start = perf_counter()
        with np.errstate(all="ignore"):
            run(kernel, 0, 1)
        _spent[0] += perf_counter() - start
        return
    if kernel not in _ready and cases and not kernel.is_cached:
        _log.warning("compiling the solver for this machine, once: this takes about half a minute")
    compiled = kernel.compiled
    _ready.add(kernel)
    starts = range(0, cases, CHUNK)
    workers = min(thread_count(threads), len(starts))
    if workers <= 1:
        for first in starts:
            run(compiled, first, min(first + CHUNK, cases))
        return
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(lambda first: run(compiled, first, min(first + CHUNK, cases)), starts))
