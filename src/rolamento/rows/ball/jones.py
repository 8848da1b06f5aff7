"""Raceway control ball by ball: the race that Jones's criterion names, found by trial."""

from __future__ import annotations

from typing import Final, Protocol, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.kinematics import RacewayControl
from rolamento.rows.ball.problem import Floats

PASSES: Final = 20
FLIPS: Final = 4
"""A ball that has changed its controlling race this often has none: it stays with the outer."""


class Solved(Protocol):
    """What is read of a solution, and how part of it is replaced."""

    code: NDArray[np.int64]
    iterations: NDArray[np.int64]
    safe: NDArray[np.bool_]

    def put(self, cases: NDArray[np.intp], part: Self) -> None:
        """Copy the solution of some of the cases to their places."""
        ...


S = TypeVar("S", bound=Solved)


class System(Protocol[S]):
    """Many cases that can be solved under a given raceway control."""

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and balls."""
        ...

    def solve(self, control: Floats, which: NDArray[np.intp] | None = None) -> S:
        """Solve all cases, or some; control: +1 or -1 (cases, balls) or (1, balls)."""
        ...

    def verdict(self, solution: S, control: Floats) -> NDArray[np.int64]:
        """Jones's criterion for every ball of every case; (cases, balls)."""
        ...


def solve_by_jones(system: System[S]) -> tuple[S, Floats, NDArray[np.int64]]:
    """Solve with the race in control that Jones's criterion names, ball by ball.

    Every ball starts under outer control. A ball keeps its control while the criterion favours
    neither race; one that changes over and over favours neither, and stays with the outer race.
    Returns the solution, the control (+1, -1) that it was solved with, and the criterion's
    verdict: 0 where it does not confirm that control.
    """
    control = np.ones(system.shape)
    flips = np.zeros(system.shape, np.int64)
    solution = system.solve(control)
    for _ in range(PASSES):
        verdict = system.verdict(solution, control)
        decided = (verdict != RacewayControl.INDETERMINATE) & (flips < FLIPS)
        wanted = np.where(decided, verdict, control)
        wanted[solution.code != status.CONVERGED] = control[solution.code != status.CONVERGED]
        flips += wanted != control
        wanted[flips >= FLIPS] = 1.0
        changed = np.flatnonzero((wanted != control).any(axis=1))
        control = wanted
        if not len(changed):
            break
        part = system.solve(control[changed], changed)
        part.iterations += solution.iterations[changed]
        part.safe |= solution.safe[changed]
        solution.put(changed, part)
    verdict = system.verdict(solution, control)
    confirmed = np.where(verdict == control, verdict, RacewayControl.INDETERMINATE)
    return solution, control, confirmed.astype(np.int64)
