"""How often the bounds of each method hold: `python -m benchmarks.weibull_coverage [--quick]`.

Many life tests are drawn from one Weibull distribution, every method gives its bounds, and those
that hold the true value are counted. By the symmetry of the distribution the counts depend neither
on its shape nor on its scale. Takes most of an hour on one processor; `--quick` some ten seconds.
`--markdown FILE` writes docs/weibull-coverage.md.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Final

import numpy as np

from rolamento.weibull import (
    LifeTest,
    Method,
    all_bounds,
)

SHAPE, SCALE = 1.5, 1000.0
CONFIDENCE: Final = 0.9
QUANTITIES: Final = ("shape", "L10", "L50")
TRUE: Final = (SHAPE, *(SCALE * (-np.log(r)) ** (1.0 / SHAPE) for r in (0.9, 0.5)))
METHODS_SHOWN: Final[tuple[Method, ...]] = (
    "pivotal",
    "calibrated_likelihood_ratio",
    "likelihood_ratio",
    "fisher",
    "bootstrap_percentile",
    "bootstrap_bca",
)
SIZES: Final = (5, 10, 20, 50)


@dataclass(frozen=True, slots=True)
class Coverage:
    """Counts for one kind of test and one method; of (quantities,) arrays.

    low, high: tests whose interval lies wholly above, wholly below the true value. width: median
    ratio of upper to lower bound.
    """

    kind: str
    size: int
    method: str
    tests: int
    low: np.ndarray
    high: np.ndarray
    width: np.ndarray

    @property
    def held(self) -> np.ndarray:
        """Per cent of the tests whose bounds held, by quantity."""
        return 100.0 * (1.0 - (self.low + self.high) / self.tests)


def complete(size: int, random: np.random.Generator) -> LifeTest:
    """All bearings fail."""
    return LifeTest(SCALE * random.weibull(SHAPE, size))


def stopped_at_failure(size: int, random: np.random.Generator) -> LifeTest:
    """The test stops when half of the bearings have failed."""
    times = np.sort(SCALE * random.weibull(SHAPE, size))
    return _stopped(times, float(times[max(size // 2, 2) - 1]))


def stopped_by_clock(size: int, random: np.random.Generator) -> LifeTest:
    """The test stops when half of the bearings are to be expected to have failed."""
    return _stopped(SCALE * random.weibull(SHAPE, size), TRUE[2])


def withdrawn(size: int, random: np.random.Generator) -> LifeTest:
    """Each bearing is withdrawn at a time of its own; two of five outlive that."""
    times = SCALE * random.weibull(SHAPE, size)
    ends = SCALE * random.uniform(0.2, 2.0, size)
    return LifeTest(np.minimum(times, ends), times <= ends)


def sudden_death(size: int, random: np.random.Generator) -> LifeTest:
    """Rigs of four bearings, each stopped at its first failure; so many rigs."""
    return LifeTest.sudden_death(SCALE * random.weibull(SHAPE, (size, 4)).min(axis=1), 4)


KINDS: Final[dict[str, Callable[[int, np.random.Generator], LifeTest]]] = {
    "all failed": complete,
    "stopped at the failure of half": stopped_at_failure,
    "stopped by the clock, half failed": stopped_by_clock,
    "withdrawn at random, 2 of 5": withdrawn,
    "rigs of four, first failure": sudden_death,
}


def measure(kind: str, size: int, tests: int, samples: int, seed: int = 1) -> list[Coverage]:
    """Count for one kind of test, all methods on the same tests."""
    random = np.random.default_rng([seed, size, list(KINDS).index(kind)])
    found = np.full((len(METHODS_SHOWN), tests, len(QUANTITIES), 2), np.nan)
    for i in range(tests):
        test = KINDS[kind](size, random)
        while not _usable(test):  # what has no fit promises nothing
            test = KINDS[kind](size, random)
        for m, method in enumerate(METHODS_SHOWN):
            limits = all_bounds(
                test, QUANTITIES, method=method, confidence=CONFIDENCE, samples=samples, seed=i
            )
            found[m, i] = [[b.lower, b.upper] for b in limits]
    results = []
    for method, limits in zip(METHODS_SHOWN, found, strict=True):
        fine = ~np.isnan(limits).any(axis=(1, 2))
        lower, upper = limits[fine, :, 0], limits[fine, :, 1]
        with np.errstate(divide="ignore"):
            width = np.median(upper / lower, axis=0)
        low, high = (lower > TRUE).sum(axis=0), (upper < TRUE).sum(axis=0)
        results.append(Coverage(kind, size, method, int(fine.sum()), low, high, width))
    return results


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and show; the exit code."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.weibull_coverage")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--tests", type=int, default=800)
    parser.add_argument("--samples", type=int, default=1000)
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    parser.add_argument("--markdown", type=Path)
    options = parser.parse_args(arguments)
    tests, samples = (20, 200) if options.quick else (options.tests, options.samples)
    # the largest first, so that no process is left alone with it
    wanted = [(kind, size) for size in reversed(SIZES) for kind in KINDS]
    with ProcessPoolExecutor(options.processes) as pool:
        run = partial(measure, tests=tests, samples=samples)
        results = list(pool.map(run, *zip(*wanted, strict=True)))
    text = markdown(dict(zip(wanted, results, strict=True)), tests, samples)
    if options.markdown is None:
        print(text)
    else:
        options.markdown.write_text(text, encoding="utf-8")
    return 0


def markdown(results: dict[tuple[str, int], list[Coverage]], tests: int, samples: int) -> str:
    """Tables for the documentation."""
    error = 100.0 * (CONFIDENCE * (1.0 - CONFIDENCE) / tests) ** 0.5
    lines = [
        "# Weibull bounds: how often they hold",
        "",
        "Written by `python -m benchmarks.weibull_coverage --markdown docs/weibull-coverage.md`;"
        " what it means and",
        "which method is the default: [theory](theory/weibull.md#coverage).",
        "",
        f"{tests} drawn tests of each kind, {samples} samples of each where a method draws;"
        f" two-sided bounds of {100 * CONFIDENCE:.0f} %.",
        f"The number is the per cent of the tests whose bounds hold, with a standard error of"
        f" {error:.1f}; in brackets, how",
        "many lie wholly above and wholly below the true value (5 and 5 would be right), and the"
        " median of upper",
        "over lower bound.",
    ]
    for kind in KINDS:
        lines += ["", f"## {kind[0].upper()}{kind[1:]}", ""]
        what = "rigs" if "rigs" in kind else "bearings"
        lines += [
            f"| {what} | method | " + " | ".join(QUANTITIES) + " |",
            "|---|---|" + "---|" * len(QUANTITIES),
        ]
        for size in SIZES:
            for coverage in results[kind, size]:
                cells = " | ".join(_cell(coverage, i) for i in range(len(QUANTITIES)))
                lines.append(f"| {size} | {coverage.method} | {cells} |")
    return "\n".join(lines) + "\n"


def _cell(coverage: Coverage, quantity: int) -> str:
    low, high = (100.0 * x[quantity] / coverage.tests for x in (coverage.low, coverage.high))
    width = coverage.width[quantity]
    return f"{coverage.held[quantity]:.1f} ({low:.1f} / {high:.1f}; ×{width:.3g})"


def _stopped(times: np.ndarray, end: float) -> LifeTest:
    return LifeTest(np.minimum(times, end), times <= end)


def _usable(test: LifeTest) -> bool:
    return test.failures >= 2 and bool(np.ptp(test.times) > 0.0)


if __name__ == "__main__":
    raise SystemExit(main())
