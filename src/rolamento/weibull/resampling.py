"""The bearings of a test drawn with replacement, and with one of them left out."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray
from rolamento.weibull import profile
from rolamento.weibull.censoring import fits_of
from rolamento.weibull.drawing import portions
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.profile import BatchFit, Rows

__all__ = ["MOST_ROWS", "jackknife_fits", "resampled_fits"]

MOST_ROWS: Final = 2000


def resampled_fits(test: LifeTest, samples: int, random: np.random.Generator) -> BatchFit:
    """Fits to so many tests of bearings drawn with replacement; rigs are drawn as a whole."""
    block, row, number = _blocks(test)
    total = int(number.sum())
    parts = []
    for count in portions(len(test), samples):
        drawn = random.multinomial(total, number / total, size=count).astype(np.float64)
        parts.append(_fits(test, drawn[:, block] * row))
    return profile.joined(parts)


def jackknife_fits(test: LifeTest) -> tuple[BatchFit, FloatArray]:
    """Fits with one bearing, or one rig, left out; and how many there are of each kind."""
    block, row, number = _blocks(test)
    left = number - np.eye(len(number))
    return _fits(test, left[:, block] * row), number


def _blocks(test: LifeTest) -> tuple[NDArray[np.int64], FloatArray, FloatArray]:
    """Return the block of each row, bearings of the row in one block, and blocks of each kind.

    A row without a rig is a kind of block, of one bearing, of which there are so many as its count
    says; a rig is a block that there is once.
    """
    alone = test.rig == ""
    block = np.zeros(len(test), dtype=np.int64)
    block[alone] = np.arange(np.count_nonzero(alone))
    in_row = np.where(alone, 1.0, test.counts)
    number = test.counts[alone].astype(np.float64)
    if not np.all(alone):
        rigs, which = np.unique(test.rig[~alone], return_inverse=True)
        block[~alone] = len(number) + which
        number = np.append(number, np.ones(len(rigs)))
    return block, in_row, number


def _fits(test: LifeTest, counts: FloatArray) -> BatchFit:
    """Fit the rows of a test with other counts, (samples, rows)."""
    if not test.inspected:
        log_time = np.broadcast_to(np.log(test.times), counts.shape)
        return profile.fit_rows(Rows(log_time, counts * test.failed, counts))
    plain = Likelihood.of(test)
    interval = ~np.isnan(test.lower)
    return fits_of(
        replace(
            plain,
            failed_counts=counts[:, test.failed & ~interval],
            suspended_counts=counts[:, ~test.failed],
            interval_counts=counts[:, interval],
        )
    )
