"""What a benchmark finds, and how it is set against what was aimed at."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Direction = Literal["at least", "below"]


@dataclass(frozen=True, slots=True)
class Target:
    """A figure aimed at, on a machine with AVX-512 and on one without."""

    direction: Direction
    with_avx512: float
    without: float

    def value(self, avx512: bool) -> float:
        """The figure for this machine."""
        return self.with_avx512 if avx512 else self.without

    def reached(self, measured: float, avx512: bool) -> bool:
        """Whether a measured figure is good enough on this machine."""
        limit = self.value(avx512)
        return bool(measured >= limit if self.direction == "at least" else measured < limit)


@dataclass(frozen=True, slots=True)
class Figure:
    """One measured number; `unit` is what stands behind it in the table."""

    group: str
    name: str
    value: float
    unit: str = ""
    target: Target | None = None


@dataclass(slots=True)
class Findings:
    """What a benchmark brings back: figures, remarks, and what makes the run fail."""

    figures: list[Figure]
    remarks: list[str]
    failures: list[str]

    @classmethod
    def none(cls) -> Findings:
        """Nothing found yet."""
        return cls([], [], [])

    def add(self, other: Findings) -> None:
        """Take in what another benchmark found."""
        self.figures += other.figures
        self.remarks += other.remarks
        self.failures += other.failures


def at_least(value: float, without: float | None = None) -> Target:
    """A target from below, and a lower one for machines without AVX-512."""
    return Target("at least", value, value if without is None else without)


def below(value: float) -> Target:
    """A target from above."""
    return Target("below", value, value)


def has_avx512() -> bool:
    """Whether the processor says so; where it cannot be asked, it is taken not to."""
    try:
        return "avx512f" in Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace")
    except OSError:
        return False


def seconds(function: Callable[[], object], repeats: int) -> float:
    """The least wall time of several calls: the others were disturbed."""
    return alternately([function], repeats)[0]


def alternately(functions: Sequence[Callable[[], object]], repeats: int) -> list[float]:
    """The least wall time of each, called by turns, so that a disturbance hits all of them."""
    best = [float("inf")] * len(functions)
    for _ in range(repeats):
        for i, function in enumerate(functions):
            begin = time.perf_counter()
            function()
            best[i] = min(best[i], time.perf_counter() - begin)
    return best


def peak_megabytes() -> float:
    """Most memory that this process ever held."""
    try:
        status = Path("/proc/self/status").read_text(encoding="ascii", errors="replace")
    except OSError:
        import resource  # which Windows does not have

        # kilobytes, but bytes on macOS
        unit = 1e6 if sys.platform == "darwin" else 1e3
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit
    # getrusage would tell the most of the process that started this one, if that is more
    held = next(line for line in status.splitlines() if line.startswith("VmHWM:"))
    return float(held.split()[1]) / 1e3
