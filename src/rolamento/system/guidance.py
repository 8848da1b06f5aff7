"""What guides each element: raceway control by the race that Jones's criterion names, by trial."""

from __future__ import annotations

from typing import Final, Protocol, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.kinematics import RacewayControl
from rolamento.numerics import FloatArray

PASSES: Final = 20
FLIPS: Final = 4
"""A ball that has changed its controlling race this often has none: it stays with the outer."""


class Solution(Protocol):
    """What is read of a solution, and how part of it is replaced."""

    @property
    def number(self) -> NDArray[np.int64]:
        """How each case went: a number of `rolamento.status`."""
        ...

    @property
    def iterations(self) -> NDArray[np.int64]:
        """Newton steps of each case."""
        ...

    @property
    def safe_path(self) -> NDArray[np.bool_]:
        """Whether the fast path needed help."""
        ...

    def put(self, cases: NDArray[np.intp], part: Self) -> None:
        """Copy the solution of some of the cases to their places."""
        ...


S = TypeVar("S", bound=Solution)


class System(Protocol[S]):
    """Many cases that can be solved under a given raceway control; outer control by itself."""

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and balls."""
        ...

    def guided(self, control: FloatArray) -> Self:
        """The same cases under another control: +1 or -1, (cases or 1, balls)."""
        ...

    def solve(self, which: slice | NDArray[np.intp] = slice(None)) -> S:
        """Solve all cases, or some."""
        ...

    def verdict(
        self, solution: S, which: slice | NDArray[np.intp] = slice(None)
    ) -> NDArray[np.int64]:
        """Jones's criterion for every ball of all cases, or some; (cases, balls).

        solution: of those cases.
        """
        ...


def solve_by_jones(system: System[S]) -> tuple[S, FloatArray, NDArray[np.int64]]:
    """Solve with the race in control that Jones's criterion names, ball by ball.

    Every ball starts under outer control. A ball keeps its control while the criterion favours
    neither race; one that changes over and over favours neither, and stays with the outer race.
    Returns the solution, the control (+1, -1) that it was solved with, and the criterion's
    verdict: 0 where it does not confirm that control.
    """
    control = np.ones(system.shape)
    flips = np.zeros(system.shape, np.int64)
    solution = system.solve()
    verdict = system.verdict(solution)
    for _ in range(PASSES):
        decided = (verdict != RacewayControl.INDETERMINATE) & (flips < FLIPS)
        wanted = np.where(decided, verdict, control)
        wanted[solution.number != status.CONVERGED] = control[solution.number != status.CONVERGED]
        flips += wanted != control
        wanted[flips >= FLIPS] = 1.0
        changed = np.flatnonzero((wanted != control).any(axis=1))
        control = wanted
        if not len(changed):
            break
        system = system.guided(control)
        part = system.solve(changed)
        part.iterations[:] += solution.iterations[changed]
        part.safe_path[:] |= solution.safe_path[changed]
        solution.put(changed, part)
        verdict[changed] = system.verdict(part, changed)
    confirmed = np.where(verdict == control, verdict, RacewayControl.INDETERMINATE)
    return solution, control, confirmed.astype(np.int64)
