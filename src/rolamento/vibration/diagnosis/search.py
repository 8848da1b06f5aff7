"""The search: for each component the hypothesis, order and band that noise would least explain.

A hypothesis is a set of multiples of the fault's order, with or without sidebands, and a width that
slip has given the highest of them; lower ones are narrower in proportion. Damage that strikes in
a steady load shows its first multiples; a ring that turns through the load has sidebands; a ball
that strikes one race harder than the other shows odd multiples of its spin.

The mean power within a line's width has a score against the noise about it (see `noise_floor`), in
noise an exponential variable. A hypothesis has n lines, each at its multiple of the order that is
tried, and none of them counts for more than the median one, so that a few lines of another origin
do not pass for all. Of the scores s₁ ≤ … ≤ sₙ the spacings (n - j + 1)(sⱼ - sⱼ₋₁) are independent
exponential variables (Rényi, Acta Mathematica Academiae Scientiarum Hungaricae 4 (1953), 191-231),
therefore

    Σ min(sᵢ, sₘ) = Σ (n - j + 1)(sⱼ - sⱼ₋₁),  j = 1 … m,   m = n - ⌊n/2⌋

is a gamma variable of shape m. Its tail is one probability for each hypothesis, order and band. The
least of them is multiplied by how many were tried: the chance that noise does as well anywhere is
at most that (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import chain, pairwise
from math import exp, log, nan
from typing import Final, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.vibration.diagnosis.settings import Component, FaultOrders
from rolamento.vibration.noise_floor import log_gamma_tail, mean_scores, reaches

WIDTHS: Final = (1, 2, 4, 8, 16)
"""Widths of the highest multiple; in lines."""
_WIDTHS_WITH_SIDEBANDS: Final = WIDTHS[:4]
"""Sidebands lie close enough to share the noise that they are compared with; wide ones would feel
its scatter together."""

_PLAIN: Final[dict[Component, tuple[tuple[float, ...], ...]]] = {
    "outer_race": ((1,), (1, 2), (1, 2, 3), (1, 2, 3, 4, 5)),
    "inner_race": ((1,), (1, 2, 3)),
    "ball": ((1,), (1, 2, 3), (0.5, 1, 1.5, 2)),
    "cage": ((1,), (1, 2, 3)),
}

_WITH_SIDEBANDS: Final[tuple[tuple[tuple[float, ...], int], ...]] = (
    ((1,), 1),
    ((1, 2, 3), 1),
    ((1, 2, 3), 2),
)


@frozen
class SearchedLine:
    """One line of a hypothesis: multiple of the fault's order, sidebands away, and its width."""

    multiple: float
    sideband: int
    width: int


@frozen
class Hypothesis:
    """What damage may look like.

    Attributes
    ----------
    lines
        that should stand out together
    spacing
        of the sidebands, in orders; 0 if there are none
    width
        of the highest multiple, in lines
    """

    lines: tuple[SearchedLine, ...]
    spacing: float
    width: int

    @property
    def highest(self) -> float:
        """Highest multiple."""
        return max(line.multiple for line in self.lines)

    @property
    def step(self) -> float:
        """How fine a fundamental is: a line, or half of the width, at the highest multiple."""
        return max(1.0, 0.5 * self.width) / self.highest


def hypotheses_of(orders: FaultOrders, component: Component) -> tuple[Hypothesis, ...]:
    """Return all hypotheses for a component; none if it is not looked for."""
    if orders.fundamental(component) is None:
        return ()
    found = [
        _hypothesis(multiples, 0, 0.0, width) for multiples in _PLAIN[component] for width in WIDTHS
    ]
    spacing = orders.spacing(component)
    if spacing > 0.0:
        found += [
            _hypothesis(multiples, sidebands, spacing, width)
            for multiples, sidebands in _WITH_SIDEBANDS
            for width in _WIDTHS_WITH_SIDEBANDS
        ]
    return tuple(found)


def highest_order(orders: FaultOrders, component: Component, tolerance: float) -> float:
    """Highest order that any hypothesis for a component looks at; 0 if it is not looked for."""
    fundamental = orders.fundamental(component)
    if fundamental is None:
        return 0.0
    stretched = fundamental * (1.0 + orders.tolerance(component, tolerance))
    return max(
        line.multiple * stretched + abs(line.sideband) * hypothesis.spacing * (1.0 + tolerance)
        for hypothesis in hypotheses_of(orders, component)
        for line in hypothesis.lines
    )


def trials_grid(
    low: float, high: float, hypothesis: Hypothesis, spacing_freedom: float
) -> tuple[FloatArray, FloatArray]:
    """Fundamentals and sideband spacings to try, in lines of the spectrum.

    Steps are a line, or half of its width, at the highest multiple, and a line of the spacing. No
    line reaches with its width beyond what is allowed; there are none if it is wider than that.

    Parameters
    ----------
    low, high
        Of the fundamental; lines.
    hypothesis
        With its spacing in lines.
    spacing_freedom
        Part by which the spacing may be off.
    """
    step = hypothesis.step
    inside = 0.5 * max(0, hypothesis.width - 2) / hypothesis.highest
    count = max(0, int((high - low - 2.0 * inside) / step + 1.0))
    fundamentals = low + inside + step * np.arange(count, dtype=np.float64)
    reach = int(spacing_freedom * hypothesis.spacing)
    return fundamentals, hypothesis.spacing + np.arange(-reach, reach + 1, dtype=np.float64)


def _hypothesis(
    multiples: tuple[float, ...], sidebands: int, spacing: float, width: int
) -> Hypothesis:
    highest = max(multiples)
    lines = tuple(
        SearchedLine(multiple, side, max(1, round(width * multiple / highest)))
        for multiple in multiples
        for side in range(-sidebands, sidebands + 1)
    )
    return Hypothesis(lines, spacing, width)


# --- the search ----------------------------------------------------------------------------------


_FAR: Final = 1e5
_AT_ONCE: Final = 2**15
"""Scores that are looked up together: they stay near the processor."""


Number = TypeVar("Number", np.int64, np.float64)


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
        # bands side by side: what is taken of a line is one piece of memory
        self._sums = _from_zero(np.where(usable, power, 0.0))
        self._counts = _from_zero(usable.astype(np.int64))
        self._full = _from_zero(np.all(usable, axis=0, keepdims=True).astype(np.int64))[:, 0]
        self._medians = np.ascontiguousarray(medians.T)
        self._reaches = reaches(np.arange(self.lines))[:, None]
        self._averages = averages
        # one width after the other, and hardly any of it is ever touched
        size = WIDTHS[-1] * self.lines
        self._scores, self._there = (np.zeros((size, self.bands), kind) for kind in (float, bool))
        self._whole, self._wanted, self._known = np.zeros((3, size), dtype=np.bool_)

    def about(self, places: IntArray, width: int) -> FloatArray:
        """Score of what lies within so many lines about each place; (bands, places).

        0 where all lines are left out.
        """
        numbers = self.numbers(places, width)
        self.make(numbers)
        return np.asarray(self._scores[numbers].T)

    def numbers(self, places: IntArray, width: int | IntArray) -> IntArray:
        """By which scores about places are known; of those outside as of the lowest line."""
        inside = np.where((places > 0) & (places < self.lines), places, 0)
        return np.asarray(inside + self.lines * (width - 1))

    def make(self, *numbers: IntArray) -> None:
        """Make those scores that are not known, many together."""
        for some in numbers:
            self._wanted[some] = True
        new = np.flatnonzero(self._wanted & ~self._known)
        step = max(1, _AT_ONCE // self.bands)
        for some in (new[at : at + step] for at in range(0, len(new), step)):
            below, lines = np.divmod(some, self.lines)
            first = np.maximum(lines - below // 2, 1)
            last = np.minimum(lines + (below + 1) // 2 + 1, self.lines)
            full = self._full[last] - self._full[first] == below + 1
            # where no line is left out in any band, all bands are alike
            for part, alike in ((full, slice(1)), (~full, slice(None))):
                if np.any(part):
                    found = self._scored(lines[part], first[part], last[part], alike)
                    there = ~np.isnan(found)
                    self._scores[some[part]] = np.where(there, found, 0.0)
                    self._there[some[part]] = there
                    self._whole[some[part]] = np.all(there, axis=1)
        self._known[new] = True

    def take(self, numbers: IntArray) -> tuple[FloatArray, IntArray | None]:
        """Scores that are made, and of how many of them any line is there.

        numbers: (lines, …). Returns (lines, …, bands) and (…, bands); None in place of the latter
        where all are.
        """
        found = np.take(self._scores, numbers, axis=0)
        if np.all(self._whole[numbers]):
            return found, None
        return found, np.sum(self._there[numbers], axis=0)

    def _scored(self, lines: IntArray, first: IntArray, last: IntArray, bands: slice) -> FloatArray:
        """Scores of what lies from the first lines to before the last ones; (lines, bands).

        bands: those in which it is to be known how many lines there are.
        """
        counts = self._counts[last, bands] - self._counts[first, bands]
        means = (self._sums[last] - self._sums[first]) / np.maximum(counts, 1)
        reach = self._reaches[lines]
        return mean_scores(means, self._medians[lines], counts, reach, self._averages)


@frozen
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
    low, high
        between which the fundamental was looked for; lines
    hypothesis
        which
    trials
        how many were tried in the whole search
    per_band
        maximum evidence in each band
    """

    evidence: float
    band: int
    fundamental: float
    spacing: float
    low: float
    high: float
    hypothesis: Hypothesis
    trials: int
    per_band: tuple[float, ...]


@frozen
class Look:
    """What is looked for, and where.

    Attributes
    ----------
    hypotheses
        to try
    low, high
        of the fundamental; orders
    spacing_freedom
        part by which the spacing of sidebands may be off
    """

    hypotheses: tuple[Hypothesis, ...]
    low: float
    high: float
    spacing_freedom: float


def search(scores: Scores, looks: Sequence[Look], turns: float) -> list[Finding | None]:
    """Find what stands out most of all that hypotheses, orders and bands allow.

    Parameters
    ----------
    scores
        Of the lines.
    looks
        What for.
    turns
        Revolutions in a block: lines per order.

    Returns
    -------
    The best of each look; None if no line of any of its hypotheses is there.
    """
    tried = [[one for one in _trials_of(look, turns, scores) if one.numbers.size] for look in looks]
    scores.make(*(one.numbers for one in chain.from_iterable(tried)))
    return [
        _finding(look, turns, ones, [_evidence(scores, one) for one in ones])
        for look, ones in zip(looks, tried, strict=True)
    ]


def _finding(
    look: Look, turns: float, tried: Sequence[_Trials], found: Sequence[_Best]
) -> Finding | None:
    """Return the best of all trials of a look."""
    trials = sum(one.trials for one in found)
    if trials == 0:
        return None
    number = int(np.argmax([np.max(one.evidence) for one in found]))
    one, best = tried[number], found[number]
    spacing, band = np.unravel_index(int(np.argmax(best.evidence)), best.evidence.shape)
    per_band = np.max([np.max(one.evidence, axis=0) for one in found], axis=0, initial=0.0)
    return Finding(
        evidence=float(best.evidence[spacing, band]),
        band=int(band),
        fundamental=float(one.grid[best.at[spacing, band]]),
        spacing=float(one.spacings[spacing]),
        low=look.low * turns,
        high=look.high * turns,
        hypothesis=one.hypothesis,
        trials=trials,
        per_band=tuple(float(value) for value in per_band),
    )


def _trials_of(look: Look, turns: float, scores: Scores) -> Iterator[_Trials]:
    for plain in look.hypotheses:
        hypothesis = replace(plain, spacing=plain.spacing * turns)
        freedom = look.spacing_freedom
        yield _Trials.of(hypothesis, look.low * turns, look.high * turns, freedom, scores)


class _Trials(NamedTuple):
    """A hypothesis at fundamentals and spacings; its lines' scores, (lines, spacings, grid)."""

    hypothesis: Hypothesis
    grid: FloatArray
    spacings: FloatArray
    numbers: IntArray

    @classmethod
    def of(
        cls, hypothesis: Hypothesis, low: float, high: float, freedom: float, scores: Scores
    ) -> _Trials:
        """Return all trials but those at spacings where lines would share any of the spectrum's."""
        grid, spacings = trials_grid(low, high, hypothesis, freedom)
        middle = grid[len(grid) // 2] if len(grid) > 0 else nan
        spacings = spacings[[_apart(hypothesis, middle, spacing) for spacing in spacings]]
        lines = [(line.multiple, line.sideband, line.width) for line in hypothesis.lines]
        multiples, sidebands, widths = np.array(lines).T[:, :, None, None]
        places = np.rint(grid * multiples + sidebands * spacings[:, None]).astype(np.int64)
        return cls(hypothesis, grid, spacings, scores.numbers(places, widths.astype(np.int64)))


def _apart(hypothesis: Hypothesis, fundamental: float, spacing: float) -> bool:
    """Whether no two lines share any of the spectrum's: their scores would depend."""
    places = sorted(
        (line.multiple * fundamental + line.sideband * spacing, line.width)
        for line in hypothesis.lines
    )
    return all(
        above - below - 0.5 * (wide + width) >= 1.0
        for (below, width), (above, wide) in pairwise(places)
    )


class _Best(NamedTuple):
    """Greatest evidence over the fundamentals, its place in the grid, and how many were tried.

    evidence, at: (spacings, bands).
    """

    evidence: FloatArray
    at: IntArray
    trials: int


def _evidence(scores: Scores, trials: _Trials) -> _Best:
    """Greatest -ln of the probability of a hypothesis over its fundamentals.

    0 where too few of its lines are there: of several, one alone means nothing.
    """
    found, used = scores.take(trials.numbers)
    least = min(2, len(found))
    ordered = _descending(list(found))
    numbers = [len(found)] if used is None else np.flatnonzero(np.bincount(used.ravel())).tolist()
    size = (found.shape[1], found.shape[3])
    greatest, at, tried = np.zeros(size), np.zeros(size, dtype=np.int64), 0
    for number in numbers:
        if number < least:
            continue
        totals = _total(ordered, number)
        here = None if used is None else used == number
        tried += totals.size if here is None else int(np.count_nonzero(here))
        # the evidence rises with the total
        totals = totals if here is None else np.where(here, totals, -1.0)
        place, total = np.argmax(totals, axis=1), np.max(totals, axis=1)
        evidence = np.where(total < 0.0, 0.0, _tail(total, number - number // 2))
        at = np.where(evidence > greatest, place, at)
        greatest = np.maximum(greatest, evidence)
    return _Best(greatest, at, tried)


def _total(ordered: list[FloatArray], used: int) -> FloatArray:
    """Sum of independent scores, none counted above their median.

    ordered: scores from great to small, 0 where a line is left out; used: how many are not.
    """
    above = used // 2
    total = ordered[above] * (1 + above)
    for score in ordered[above + 1 : used]:
        total += score
    return total


def _tail(total: FloatArray, count: int) -> FloatArray:
    """-ln of the probability that so many independent scores add up to a total."""
    return total if count == 1 else np.interp(total, *_gamma_tails(count))


def _descending(rows: list[FloatArray]) -> list[FloatArray]:
    """Arrays ordered element by element, from great to small.

    A network of comparisons, which are whole arrays': Batcher's merge exchange (Knuth, The Art of
    Computer Programming 3, 5.2.2 M). The arrays are used up.
    """
    spare = np.empty_like(rows[0])
    step = top = 1 << (len(rows) - 1).bit_length() >> 1
    while step > 0:
        merged, bit, distance = top, 0, step
        while True:
            for low in range(len(rows) - distance):
                if low & step == bit:
                    one, other = rows[low], rows[low + distance]
                    rows[low] = np.maximum(one, other, out=spare)
                    rows[low + distance], spare = np.minimum(one, other, out=one), other
            if merged == step:
                break
            distance, merged, bit = merged - step, merged >> 1, step
        step >>= 1
    return rows


@cache
def _gamma_tails(count: int) -> tuple[FloatArray, FloatArray]:
    """Totals, and -ln of the tail of a gamma variable there."""
    near = np.linspace(0.0, 20.0 * count + 100.0, 3000)
    far = np.geomspace(20.0 * count + 101.0, _FAR, 300)
    places = np.concatenate([near, far])
    return places, -log_gamma_tail(count, places)


def _from_zero(values: NDArray[Number]) -> NDArray[Number]:
    """Running sums along lines, of what lies before each; of (bands, lines), (lines + 1, bands)."""
    return np.asarray(np.cumsum(np.pad(values.T, ((1, 0), (0, 0))), axis=0))


def chance(evidence: float, trials: int) -> tuple[float, float]:
    """Probability that noise does as well in so many trials, and -log10 of it.

    At most the number of trials times the probability of one; never over 1.
    """
    exponent = max(evidence - log(max(trials, 1)), 0.0)
    return exp(-exponent), exponent / log(10.0)
