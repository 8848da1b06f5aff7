"""Ranks of failures on the Weibull plot, also among suspensions.

The i-th of n failures has the median rank, the median of the Beta(i, n + 1 - i) distribution, close
to (i - 0.3)/(n + 0.4). A suspension takes an unknown place among the later failures; Johnson gives
a failure with m bearings still running, itself included, the rank

    i_new = i_old + (n + 1 - i_old)/(1 + m),

so that n + 1 - i is a product over the failures. Failures at the same time take successive ranks,
and a failure comes before a suspension at the same time.

Sources: Johnson (1964); Benard and Bos-Levenbach (1953).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.weibull._checks import one_of
from rolamento.weibull.life_test import LifeTest

__all__ = ["PlottingPositions", "Ranks", "median_rank", "plotting_positions"]

Ranks = Literal["median", "benard"]


@dataclass(frozen=True, slots=True, eq=False)
class PlottingPositions:
    """Where the failures stand on a Weibull plot, in the order of their times.

    Attributes
    ----------
    times
        (failures,) of failure; unit of the test
    rank
        (failures,) adjusted for suspensions
    failed_share
        (failures,) F: share of the bearings taken to have failed by then, 0 to 1
    """

    times: FloatArray
    rank: FloatArray
    failed_share: FloatArray

    @property
    def x(self) -> FloatArray:
        """Abscissa ln t of the Weibull plot."""
        return np.asarray(np.log(self.times))

    @property
    def y(self) -> FloatArray:
        """Ordinate ln ln 1/(1 - F) of the Weibull plot."""
        return np.asarray(np.log(-np.log1p(-self.failed_share)))


def plotting_positions(test: LifeTest, ranks: Ranks = "median") -> PlottingPositions:
    """Rank the failures of a test.

    Parameters
    ----------
    test
        Complete or right-censored.
    ranks
        "median" (exact, of the beta distribution) or "benard" (the approximation).

    Raises
    ------
    InputError
        For an inspected test, whose times of failure are not known.
    """
    one_of(ranks, "ranks", ("median", "benard"))
    if test.inspected:
        raise InputError(
            "ranks need times of failure, and inspections give none; fit by maximum likelihood",
            field="lower",
        )
    order = np.lexsort((~test.failed, test.times))
    counts, failed = test.counts[order], test.failed[order]
    before = np.cumsum(counts) - counts
    ones = np.repeat(before[failed], counts[failed])
    # successive places of failures that share a row
    start = np.repeat(np.cumsum(counts[failed]) - counts[failed], counts[failed])
    running = test.size - ones - (np.arange(len(ones)) - start)
    product = np.cumprod(running / (running + 1.0), dtype=np.float64)
    rank = np.asarray((test.size + 1.0) * (1.0 - product))
    times = np.asarray(np.repeat(test.times[order][failed], counts[failed]))
    return PlottingPositions(times, rank, median_rank(rank, test.size, ranks))


def median_rank(rank: ArrayLike, size: int, ranks: Ranks = "median") -> FloatArray:
    """Share taken to have failed at a rank, which need not be whole, among so many bearings."""
    i = np.asarray(rank, dtype=np.float64)
    if ranks == "benard":
        return np.asarray((i - 0.3) / (size + 0.4))
    from scipy.special import betaincinv

    return np.asarray(betaincinv(i, size + 1.0 - i, 0.5))
