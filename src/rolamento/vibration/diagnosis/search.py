"""The search: for each component the hypothesis, order and band that noise would least explain.

The mean power within a line's width has a score against the noise about it (see `noise_floor`), in
noise an exponential variable. The scores of a hypothesis's lines, each at its multiple of the order
that is tried, add up to a gamma variable, whose tail is one probability for each hypothesis, order
and band. The least of them is multiplied by how many were tried: the chance that noise does as
well anywhere is at most that (Bonferroni).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from math import exp, log
from typing import Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.hypotheses import Hypothesis, trials_grid
from rolamento.vibration.noise_floor import log_gamma_tail, mean_scores, reaches

__all__ = ["Finding", "Scores", "search"]

PlaceArray = NDArray[np.int64]
Number = TypeVar("Number", np.int64, np.float64)

_FAR: Final = 1e5


class Scores:
    """Powers of the lines of all bands and the noise about them, ready for scores of any width.

    Parameters
    ----------
    power
        (bands, lines).
    left_out
        (bands, lines), which are not looked at.
    medians
        (bands, lines), of the noise about each line; see `noise_floor`.
    averages
        Of how many independent spectra the powers are means.
    """

    def __init__(
        self, power: FloatArray, left_out: BoolArray, medians: FloatArray, averages: int
    ) -> None:
        usable = ~(left_out | np.isnan(medians))
        self.bands, self.lines = power.shape
        self._sums = _from_zero(np.where(usable, power, 0.0))
        self._counts = _from_zero(usable.astype(np.int64))
        self._medians = medians
        self._averages = averages
        self._reach = np.broadcast_to(reaches(np.arange(self.lines)), power.shape)
        self._rows: dict[int, tuple[FloatArray, FloatArray]] = {}

    def about(self, places: PlaceArray, width: int) -> tuple[FloatArray, FloatArray]:
        """Score of what lies within so many lines about each place, and whether any does.

        (bands, places) each; 0 and 0 where all lines are left out.
        """
        if width not in self._rows:
            self._rows[width] = self._row(width)
        # the lowest line is never scored: places outside count as it
        inside = np.where((places > 0) & (places < self.lines), places, 0)
        scores, there = self._rows[width]
        return scores[:, inside], there[:, inside]

    def _row(self, width: int) -> tuple[FloatArray, FloatArray]:
        """Scores of so many lines about every line."""
        lines = np.arange(self.lines)
        first = np.clip(lines - (width - 1) // 2, 1, None)
        last = np.clip(lines + width // 2 + 1, None, self.lines)
        counts = self._counts[:, last] - self._counts[:, first]
        means = (self._sums[:, last] - self._sums[:, first]) / np.maximum(counts, 1)
        scores = mean_scores(means, self._medians, counts, self._reach, self._averages)
        there = ~np.isnan(scores)
        scores[~there] = 0.0
        return scores, there.astype(np.float64)


@dataclass(frozen=True, slots=True)
class Finding:
    """The best of a search.

    Attributes
    ----------
    evidence
        -ln of the probability of this one trial in noise
    band
        number of the band
    fundamental, spacing
        in lines
    hypothesis
        which
    lines_used
        how many of its lines were not left out
    trials
        how many were tried in the whole search
    per_band
        greatest evidence in each band
    """

    evidence: float
    band: int
    fundamental: float
    spacing: float
    hypothesis: Hypothesis
    lines_used: int
    trials: int
    per_band: tuple[float, ...]


def search(
    scores: Scores,
    hypotheses: tuple[Hypothesis, ...],
    turns: float,
    low: float,
    high: float,
    spacing_freedom: float,
) -> Finding | None:
    """Find what stands out most of all that hypotheses, orders and bands allow.

    Parameters
    ----------
    scores
        Of the lines.
    hypotheses
        To try.
    turns
        Revolutions in a block: lines per order.
    low, high
        Of the fundamental; orders.
    spacing_freedom
        Part by which the spacing of sidebands may be off.

    Returns
    -------
    None if no line of any hypothesis is there to look at.
    """
    best: Finding | None = None
    trials = 0
    per_band = np.zeros(scores.bands)
    for plain in hypotheses:
        hypothesis = replace(plain, spacing=plain.spacing * turns)
        grid, spacings = trials_grid(low * turns, high * turns, hypothesis, spacing_freedom)
        if hypothesis.width > max(2.0, (high - low) * turns * hypothesis.highest):
            continue
        for spacing in spacings:
            total, used = _sum(scores, hypothesis, grid, float(spacing))
            evidence = combined(used, total)
            trials += int(np.count_nonzero(used))
            per_band = np.maximum(per_band, np.max(evidence, axis=1, initial=0.0))
            band, place = np.unravel_index(int(np.argmax(evidence)), evidence.shape)
            value = float(evidence[band, place])
            if best is None or value > best.evidence:
                best = Finding(
                    evidence=value,
                    band=int(band),
                    fundamental=float(grid[place]),
                    spacing=float(spacing),
                    hypothesis=hypothesis,
                    lines_used=int(used[band, place]),
                    trials=0,
                    per_band=(),
                )
    if best is None or trials == 0:
        return None
    return replace(best, trials=trials, per_band=tuple(float(value) for value in per_band))


def _sum(
    scores: Scores, hypothesis: Hypothesis, grid: FloatArray, spacing: float
) -> tuple[FloatArray, FloatArray]:
    """Sum of the scores of a hypothesis's lines, and how many were there; (bands, grid)."""
    total = np.zeros((scores.bands, len(grid)))
    used = np.zeros_like(total)
    for line in hypothesis.lines:
        places = np.rint(grid * line.multiple + line.sideband * spacing).astype(np.int64)
        score, there = scores.about(places, line.width)
        total += score
        used += there
    return total, used


def combined(counts: FloatArray, totals: FloatArray) -> FloatArray:
    """-ln of the probability that so many independent scores add up to a total; as `totals`.

    0 where there are none.
    """
    found = np.where(counts == 1.0, totals, 0.0)
    for count in np.flatnonzero(np.bincount(counts.astype(np.int64).ravel())):
        if count > 1:
            here = counts == count
            found[here] = np.interp(totals[here], *_table(int(count)))
    return found


@cache
def _table(count: int) -> tuple[FloatArray, FloatArray]:
    """Totals, and -ln of the tail of a gamma variable there."""
    near = np.linspace(0.0, 20.0 * count + 100.0, 3000)
    far = np.geomspace(20.0 * count + 101.0, _FAR, 300)
    places = np.concatenate([near, far])
    return places, -log_gamma_tail(count, places)


def _from_zero(values: NDArray[Number]) -> NDArray[Number]:
    """Running sums along lines, of what lies before each; (bands, lines + 1)."""
    return np.asarray(np.cumsum(np.pad(values, ((0, 0), (1, 0))), axis=1))


def chance(evidence: float, trials: int) -> tuple[float, float]:
    """Probability that noise does as well in so many trials, and -log10 of it.

    At most the number of trials times the probability of one; never over 1.
    """
    exponent = max(evidence - log(trials), 0.0)
    return exp(-exponent), exponent / log(10.0)
