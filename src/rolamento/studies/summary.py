"""What a person is told after a run: how many cases, how they ended, the range of each output."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.studies.outputs import Output
from rolamento.studies.plan import Part, Plan
from rolamento.studies.solving import CONVERGED, status_names

__all__ = ["OutputRange", "Spreads", "Summary"]

_MOST_KEPT: Final = 200_000
"""Values of an output that are kept for its median."""


@dataclass(frozen=True, slots=True)
class OutputRange:
    """Least, median and greatest value of an output over the cases with a result; SI units.

    every: the median is of every so-manieth case; 1 if of all.
    """

    output: Output
    least: float
    median: float
    greatest: float
    every: int


@dataclass(frozen=True, slots=True)
class Summary:
    """A run to a file.

    Attributes
    ----------
    path
        the result
    cases
        in all
    solved
        in this run; the others were kept from an earlier one
    seconds
        that this took
    counts
        of cases by status
    messages
        why some cases are not valid
    ranges
        of the outputs
    """

    path: Path
    cases: int
    solved: int
    seconds: float
    counts: Mapping[str, int]
    messages: tuple[str, ...]
    ranges: tuple[OutputRange, ...]

    @property
    def converged(self) -> int:
        """Cases with a result."""
        return self.counts.get("converged", 0)


class Spreads:
    """Gathers the ranges of the outputs, part by part, in bounded memory."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._every = -(-plan.cases // _MOST_KEPT)
        self._least = {output.name: math.inf for output in plan.outputs}
        self._greatest = {output.name: -math.inf for output in plan.outputs}
        self._kept: dict[str, list[NDArray[np.float32]]] = {o.name: [] for o in plan.outputs}

    def add(self, part: Part) -> None:
        """Take in a part."""
        first, _ = self._plan.bounds_of(part)
        chosen = slice(-first % self._every, None, self._every)
        solved = part.arrays["status"] == status_names()[CONVERGED]
        for output in self._plan.outputs:
            values = part.arrays[output.name]
            there = (
                values[solved & np.isfinite(values)]
                if values.ndim == 1
                else values[np.isfinite(values)]
            )
            if there.size:
                self._least[output.name] = min(self._least[output.name], float(there.min()))
                self._greatest[output.name] = max(self._greatest[output.name], float(there.max()))
            some = values[chosen][solved[chosen]]
            self._kept[output.name].append(_few(some).astype(np.float32))

    def ranges(self) -> tuple[OutputRange, ...]:
        """Return the ranges so far; NaN of an output without a value."""
        return tuple(self._range(output) for output in self._plan.outputs)

    def _range(self, output: Output) -> OutputRange:
        kept = np.concatenate(self._kept[output.name])
        kept = kept[np.isfinite(kept)]
        if not len(kept):
            return OutputRange(output, math.nan, math.nan, math.nan, self._every)
        least, greatest = self._least[output.name], self._greatest[output.name]
        return OutputRange(output, least, float(np.median(kept)), greatest, self._every)


def _few(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Of an output per ball, the values of every ball in turn: one for each case."""
    if values.ndim == 1:
        return values
    cases = np.arange(len(values))
    return np.asarray(values[cases, cases % values.shape[1]])
