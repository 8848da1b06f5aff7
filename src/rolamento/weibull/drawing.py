"""Drawing a test again: what else could have been seen, were the lives of a given distribution.

Where the test ended with a failure (complete, stopped at the last failure, rigs stopped at their
first) nothing but lives is random, and drawn tests have exactly the right distribution. Where the
clock ended it, a suspended bearing keeps its time of suspension; of a failed one nobody knows when
it would have been suspended, and that time is drawn from those seen, beyond its failure: their
Kaplan-Meier distribution, in which failures and suspensions change parts. Inspected bearings are
all taken to be inspected at all the times of the data.

Of a real test one failure shows too little of a shape to be worth a number. A drawn test with one
failure has a likelihood with a maximum, if some bearing ran longer, and it counts: without those
tests the limits would take it for granted that two fail, and be too narrow.

Sources: Davison and Hinkley (1997), section 3.5 (conditional bootstrap); for the order statistics
of exponential lives, Rényi (1953).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Self, TypeAlias

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import (
    BatchFit,
    Likelihood,
    Rows,
    fit_common_shape,
    fit_rows,
    fits_of,
    joined,
)
from rolamento.words import Note

MAXIMUM_BLOCKS: Final = 20_000
_AT_ONCE: Final = 100_000
_MAXIMUM_DRAWN: Final = 400_000_000
MANY: Final = 0.1
"""Part of drawn tests without a fit from which on it is noted."""
MINIMUM_FITS: Final = 50


@frozen
class Drawing:
    """How tests were drawn.

    Attributes
    ----------
    code
        "converged", or why there are none
    samples, dropped
        drawn tests, and how many of them had no fit and are left out
    notes
        what limits it, each once
    """

    code: str
    samples: int = 0
    dropped: int = 0
    notes: tuple[Note, ...] = ()

    @classmethod
    def of(cls, model: Model, samples: int, dropped: int) -> Self:
        """Note what was modelled, and what was left out."""
        if model.exact:
            return cls._noted(samples, dropped, None)
        inspected = isinstance(model, Inspected)
        note = "inspections_shared" if inspected else "censoring_modelled"
        return cls._noted(samples, dropped, Note(note))

    @classmethod
    def resampled(cls, samples: int, dropped: int) -> Self:
        """Note what was left out of a plain bootstrap."""
        return cls._noted(samples, dropped, Note("large_sample_method"))

    @classmethod
    def _noted(cls, samples: int, dropped: int, note: Note | None) -> Self:
        if samples - dropped < MINIMUM_FITS:
            return cls("not_converged")
        notes = (note,) if note else ()
        if dropped > MANY * samples:
            notes = (*notes, Note("many_without_fit"))
        return cls("converged", samples, dropped, notes)


def portions(width: int, samples: int) -> list[int]:
    """Part so many drawn tests into portions that fit into memory; fewer of very large tests."""
    samples = min(samples, max(_MAXIMUM_DRAWN // width, 100))
    step = max(_AT_ONCE // width, 1)
    return [min(step, samples - first) for first in range(0, samples, step)]


def model_of(test: LifeTest) -> Model | str:
    """Return how to draw a test again; or the code of why it cannot be drawn."""
    if test.inspected:
        exact = bool(np.any(test.failed & np.isnan(test.lower)))
        if exact:
            return "not_modelled"
        model = Inspected.of(test)
        return "too_large" if model.width > MAXIMUM_BLOCKS else model
    return right_censored_model(test)


def right_censored_model(test: LifeTest) -> RightCensored | str:
    """Return how to draw a right-censored test again."""
    if test.scheme in ("complete", "type_ii"):
        model: RightCensored = FirstFailures(test.size, test.failures)
    else:
        model = Blocks.of(test)
    return "too_large" if model.width > MAXIMUM_BLOCKS else model


def draw_fits(
    model: Model, shape: float, log_scale: float, samples: int, random: np.random.Generator
) -> BatchFit:
    """Draw so many tests and fit each."""
    parts = []
    for count in portions(model.width, samples):
        if isinstance(model, Inspected):
            parts.append(fits_of(model.likelihood(shape, log_scale, count, random)))
        else:
            parts.append(fit_rows(model.rows(shape, log_scale, count, random)))
    return joined(parts)


def draw_common_fits(
    models: Sequence[RightCensored],
    shape: float,
    log_scales: FloatArray,
    samples: int,
    random: np.random.Generator,
) -> BatchFit:
    """Draw so many tests of groups with one shape, and fit them at a common one."""
    parts = []
    for count in portions(sum(model.width for model in models), samples):
        groups = [
            model.rows(shape, float(x), count, random)
            for model, x in zip(models, log_scales, strict=True)
        ]
        parts.append(fit_common_shape(groups))
    return joined(parts)


@frozen
class FirstFailures:
    """All bearings are stopped at the r-th failure of n; all fail where r = n."""

    size: int
    failures: int
    exact: bool = True

    @property
    def width(self) -> int:
        """Numbers in one drawn test."""
        return self.failures

    def rows(
        self, shape: float, log_scale: float, samples: int, random: np.random.Generator
    ) -> Rows:
        """Draw so many tests: the first r of n, one after the other."""
        running = self.size - np.arange(self.failures)
        gaps = random.standard_exponential((samples, self.failures)) / running
        units = np.ones(self.failures)
        units[-1] += self.size - self.failures
        log_time = log_scale + np.log(np.cumsum(gaps, axis=1)) / shape
        return Rows(log_time, np.ones(self.failures), units)


@frozen(eq=False)
class Blocks:
    """Bearings alone or in rigs, each block stopped at its first failure or by the clock.

    size: (blocks,) bearings. log_end: (blocks,) when the clock stops it; NaN where that is not
    known, because it failed before: then drawn among `known`, of which those before its failure are
    left out (`skipped`, their probability). cumulated: probability up to each of the known.
    """

    size: FloatArray
    log_end: FloatArray
    known: FloatArray
    cumulated: FloatArray
    skipped: FloatArray

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Build the blocks of a right-censored test."""
        size, time, failed = _blocks_of(test)
        known, jumps = _suspension_times(time, failed)
        cumulated = np.cumsum(jumps)
        before = np.searchsorted(known, time[failed], side="left")
        skipped = np.concatenate([[0.0], cumulated])[before]
        with np.errstate(divide="ignore"):
            log_known = np.append(np.log(known), np.inf)
        return cls(size, np.where(failed, np.nan, np.log(time)), log_known, cumulated, skipped)

    @property
    def width(self) -> int:
        """Numbers in one drawn test."""
        return len(self.size)

    @property
    def exact(self) -> bool:
        """Whether the clock never stopped anything."""
        return len(self.known) == 1

    def rows(
        self, shape: float, log_scale: float, samples: int, random: np.random.Generator
    ) -> Rows:
        """Draw so many tests."""
        life = random.standard_exponential((samples, self.width)) / self.size
        log_life = log_scale + np.log(life) / shape
        end = np.broadcast_to(self.log_end, log_life.shape)
        if not self.exact:
            end = end.copy()
            end[:, np.isnan(self.log_end)] = self.ends(samples, random)
        failed = (log_life <= end) | np.isnan(end)
        return Rows(np.where(failed, log_life, end), failed.astype(np.float64), self.size)

    def ends(self, samples: int, random: np.random.Generator) -> FloatArray:
        """Draw when the clock would have stopped the failed blocks: (samples, failed)."""
        share = random.random((samples, len(self.skipped)))
        place = np.searchsorted(
            self.cumulated, self.skipped + (1.0 - self.skipped) * share, side="right"
        )
        return np.asarray(self.known[place])


@frozen(eq=False)
class Inspected:
    """Bearings inspected at all of `schedule`, stopped by the clock at one of these times."""

    schedule: FloatArray
    blocks: Blocks
    exact: bool = False

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Build the schedule of an inspected test without exact times of failure."""
        low = test.lower[test.lower > 0.0]
        return cls(np.log(np.unique(np.concatenate([low, test.times]))), Blocks.of(test))

    @property
    def width(self) -> int:
        """Numbers in one drawn test."""
        return self.blocks.width

    def likelihood(
        self, shape: float, log_scale: float, samples: int, random: np.random.Generator
    ) -> Likelihood:
        """Draw so many tests: one a lane of a likelihood."""
        rows = self.blocks.rows(shape, log_scale, samples, random)
        cells = len(self.schedule)
        failed = np.broadcast_to(rows.failures, rows.log_time.shape) > 0.0
        # who outlives the last inspection is suspended there
        failed &= rows.log_time <= self.schedule[-1]
        cell = np.minimum(np.searchsorted(self.schedule, rows.log_time - 1e-12), cells - 1)
        place = cell + cells * np.arange(samples)[:, np.newaxis]
        found, suspended = (
            np.bincount(place[which], minlength=samples * cells).reshape(samples, cells)
            for which in (failed, ~failed)
        )
        return Likelihood(
            0.0,
            np.empty(0),
            np.empty((samples, 0)),
            self.schedule,
            suspended.astype(np.float64),
            np.append(-np.inf, self.schedule[:-1]),
            self.schedule,
            found.astype(np.float64),
        )


RightCensored: TypeAlias = FirstFailures | Blocks
"""Models whose tests are right-censored, so that groups of them can be fitted together."""
Model: TypeAlias = RightCensored | Inspected
"""How a test is drawn: its width, and whether only lives are random (exact)."""


def _blocks_of(test: LifeTest) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Bearings that stop together, as one: how many, when, and whether for a failure."""
    alone = test.rig == ""
    counts = test.counts[alone]
    size = [np.ones(counts.sum())]
    time = [np.repeat(test.times[alone], counts)]
    failed = [np.repeat(test.failed[alone], counts)]
    if not np.all(alone):
        _, first, which = np.unique(test.rig[~alone], return_index=True, return_inverse=True)
        size.append(np.bincount(which, weights=test.counts[~alone]))
        time.append(test.times[~alone][first])
        failed.append(np.bincount(which, weights=test.failed[~alone]) > 0.0)
    return np.concatenate(size), np.concatenate(time), np.concatenate(failed)


def _suspension_times(time: FloatArray, failed: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Times at which the clock stopped something, and the probability of each (Kaplan-Meier)."""
    known, stopped = np.unique(time[~failed], return_counts=True)
    # a failure at the same time came first
    later = len(time) - np.searchsorted(np.sort(time), known, side="right")
    remaining = np.cumprod(later / (later + stopped))
    return known, np.concatenate([[1.0], remaining[:-1]])[: len(known)] - remaining
