"""Squared-envelope spectra of a block in many bands at once, over orders of the shaft.

A machine in good order may modulate its noise too: once per revolution, with what else turns, and
slowly as its load wanders. Noise that is modulated so repeats its own pattern at that spacing, and
lines of its envelope are no longer independent of each other. The regular part is therefore
divided out of the squared envelope: what is left is noise of one level, and in it the impacts of a
fault. Of the lines S about a multiple n of what turns, and W of the taper's square about zero,

    m_n(θ) = Σ S_k e^(jkθ) / Σ W_k e^(jkθ),   over as many lines on either side as the line rises
                                              above the noise

is the modulation without what the taper makes of it; n = 0 is the slow part.

Those lines carry noise too, and the division takes it to all places that the modulation connects:
within as many lines of any other multiple, lines then depend on each other and are left out of the
search (`lines_connected`).

All lines of a block's spectrum have been given one size (cepstrum pre-whitening; see `whitening`):
the phases alone decide, no carrier weighs more than another, and what few carriers of a tone too
weak to be found can add is bounded. Half the sampling rate is divided in 1, 2, 3, 4, 6, 8 equal
bands, as in the fast kurtogram; the inverse transform of a band's lines is its analytic signal, at
no more samples than its squared envelope needs.

In noise the lines of a squared envelope's spectrum are sums of many products of independent
phases: complex Gaussian, their powers exponential about a level that falls slowly with frequency.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from math import ceil, log, nan
from typing import Final, NamedTuple

import numpy as np
import scipy

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, ComplexArray, FloatArray, IntArray
from rolamento.numerics.percentiles import median
from rolamento.numerics.threads import side_by_side
from rolamento.records import frozen
from rolamento.vibration._checks import Band
from rolamento.vibration.diagnosis.blocks import MOST_GAPS, Block, Watch
from rolamento.vibration.diagnosis.lines import envelope_leakage, power_of, reach, runs, taper
from rolamento.vibration.diagnosis.whitening import Comb, Whitening, even_places
from rolamento.vibration.noise_floor import HALF_WIDTH
from rolamento.vibration.order_tracking import interpolated
from rolamento.words import said

_LEFT_OUT_TO: Final = 0.3
"""Fraction of the noise: what a line may add to its neighbours before they are left out."""
_CONNECTED: Final = 3.0
"""Orders between which a modulation carries noise; farther, less than a hundredth of it."""
_LEAST_SPREAD: Final = 2
_MOST_SPREAD: Final = 6
_SPREAD_ORDERS: Final = 0.02


def most_spread(turns: float) -> int:
    """Lines on either side of one of the shaft's that are left out with it at most.

    Farther off, what its taper leaves is small beside damage; and damage at an order near a
    multiple of the shaft's (3.05 of many bearings of eight balls) would go with it.

    turns: lines per order.
    """
    return max(_LEAST_SPREAD, min(_MOST_SPREAD, round(_SPREAD_ORDERS * turns)))


class Place(NamedTuple):
    """A line to leave out: where, and how far it may be from there; lines of the spectrum."""

    line: float
    within: float


def shaft_places(
    regular: Sequence[float], turns: float, lines: int, uncertainty: float
) -> list[Place]:
    """Multiples of what turns, given by its orders."""
    return [
        Place(number * order * turns, 1.0 + uncertainty * number * order * turns)
        for order in regular
        for number in range(1, int(lines / (order * turns)) + 1)
    ]


def lines_connected(
    spreads: IntArray, places: Sequence[Place], turns: float, lines: int
) -> BoolArray:
    """Lines whose noise the division by the regular part made depend on that of others.

    About each place as far as the regular part reached about any other from which the modulation
    leads there, which falls off with the distance in orders.

    Parameters
    ----------
    spreads
        (bands, 1 + places), lines on either side of 0 and of each place that were taken for
        regular; -1 for none.
    places
        Of the shaft and what else turns.
    turns
        Lines per order.
    lines
        Of the spectra.

    Returns
    -------
    (bands, lines).
    """
    found = np.zeros((len(spreads), lines), dtype=np.bool_)
    centres = np.array([0.0, *(place.line for place in places)])
    regular = np.any(spreads[:, 1:] >= 0, axis=1)
    for number, place in enumerate(places, 1):
        near = np.abs(centres - centres[number]) <= _CONNECTED * turns + 1.0
        reached = np.max(spreads[:, near], axis=1)
        for band in np.flatnonzero(regular & (reached >= 0)):
            reach_here = float(reached[band]) + place.within
            first = max(0, ceil(place.line - reach_here))
            found[band, first : int(place.line + reach_here) + 1] = True
    return found


def lines_about(
    power: FloatArray, level: FloatArray, places: Iterable[Place], most: int
) -> BoolArray:
    """Lines at some places, in each band as far about them as the strongest there spreads.

    Parameters
    ----------
    power, level
        (bands, lines); mean of the noise about each line.
    places
        To leave out.
    most
        Lines on either side of a place that are left out with it at most.

    Returns
    -------
    (bands, lines).
    """
    found = np.zeros(power.shape, dtype=np.bool_)
    leakage = envelope_leakage()
    lines = power.shape[1]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.nan_to_num(power / level, nan=0.0, posinf=0.0)
    for place in places:
        first = max(0, ceil(place.line - place.within))
        last = min(lines, int(place.line + place.within) + 1)
        if first >= last:
            continue
        peaks = np.max(ratio[:, first:last], axis=1)
        spreads = np.minimum(reach(leakage, peaks / _LEFT_OUT_TO), most)[:, None]
        about = np.arange(max(0, first - most), min(lines, last + most))
        found[:, about] |= (about >= first - spreads) & (about < last + spreads)
    return found


def filled(power: FloatArray, left_out: BoolArray) -> FloatArray:
    """Powers with those of lines left out replaced by as many of their neighbours.

    A level that is a median over lines is then one of those that are left in.
    """
    found = power.copy()
    lines = power.shape[1]
    padded = np.pad(left_out, ((0, 0), (1, 1)))  # no run goes from one band into the next
    starts, ends = runs(padded.ravel())
    bands, starts = np.divmod(starts, lines + 2)
    starts, lengths = starts - 1, ends - (bands * (lines + 2) + starts)
    for length in np.unique(lengths).tolist():
        alike = lengths == length
        band, start = bands[alike][:, None], starts[alike][:, None]
        run = np.arange(length)
        neighbours = start + np.concatenate([run - length, run + length])
        inside = (neighbours >= 0) & (neighbours < lines)
        there = inside & ~left_out[band, np.where(inside, neighbours, 0)]
        whole = np.all(there, axis=1)
        # every other one of both sides
        found[band[whole], start[whole] + run] = power[band[whole], neighbours[whole, ::2]]
        for row in np.flatnonzero(~whole & np.any(there, axis=1)):
            some = neighbours[row, there[row]]
            chosen = np.resize(some[:: max(1, len(some) // length)], length)
            found[band[row], start[row] + run] = power[band[row], chosen]
    return found


# --- what is regular in a band's squared envelope ------------------------------------------------


_MARGIN: Final = 1.3
"""Lines that are kept before a product with the regular part, over those that are needed."""
_STEPS: Final = 4
"""Steps of an envelope, over the lines that are needed of it."""
_LEAST: Final = 0.1
"""Fraction of the mean: lower the regular part is not taken, or a few samples would be blown up."""
_NEIGHBOURS: Final = 50
_CHANCE: Final = 0.01
"""That noise has any line which is taken for regular."""
_FOR_TAPER: Final = 4096
"""Places at which the taper's moments are taken."""
_SPREAD_TO: Final = 0.3
"""Fraction of the noise: down to there the lines about a regular one are taken with it."""


class ModulationPowers(NamedTuple):
    """Powers of the lines of squared envelopes, and what was divided out of them.

    plain, even: (bands, lines), as it is and without its regular part, of sums over the steps;
    depth: (bands, lines), squares of the modulation depth as it is: of e² = mean (1 + d cos(nθ +
    φ)) that is d², and a train of short impacts alone has d = 2 at each multiple; spreads: (bands,
    1 + regular places), lines on either side of 0 and of each place that were taken for regular, -1
    for none.
    """

    plain: FloatArray
    even: FloatArray
    depth: FloatArray
    spreads: IntArray


def limit(squared: FloatArray) -> None:
    """Make a squared envelope nowhere larger than what noise of its level would hardly reach.

    A few great shocks would otherwise weigh more than all the rest, and a few instants always have
    some period in common.
    """
    highest = log(len(squared) / _CHANCE) / log(2.0)
    # what is nowhere above that needs no median: half of it then are above their greatest over that
    if 2 * np.count_nonzero(squared > np.max(squared) / highest) > len(squared) + 1:
        return
    level = float(median(squared))
    if level > 0.0:
        np.minimum(squared, level * highest, out=squared)


class Turning(NamedTuple):
    """How a block's shaft turns, for a number of lines over its angle.

    fastest: highest line over time that those are made of, where the shaft is fastest; steps: even
    ones of the angle in which they are seen; times: (steps,), share of the block's time at each,
    None for a steady shaft.
    """

    fastest: int
    steps: int
    times: FloatArray | None

    @classmethod
    def of(cls, places: FloatArray | None, lines: int) -> Turning:
        """places: (samples,), share of the angle at each sample; None for a steady shaft."""
        steps = steps_of(lines)
        if places is None:
            return cls(int(_MARGIN * lines), steps, None)
        samples = len(places)
        fastest = int(_MARGIN * lines * float(np.max(np.diff(places))) * samples)
        at = np.interp(even_places(steps), places, np.arange(samples, dtype=np.float64))
        return cls(fastest, steps, at / samples)


def steps_of(lines: int) -> int:
    """Even steps of the shaft's angle in which so many lines are seen."""
    return int(scipy.fft.next_fast_len(_STEPS * lines, real=True))


def over_angle(squared: FloatArray, turning: Turning) -> FloatArray:
    """Squared envelopes, without what is too fast to matter, at even steps of the shaft's angle.

    squared: (bands, samples), evenly over the time of a block. Returns (bands, steps).
    """
    size = squared.shape[1]
    highest = min(turning.fastest, size // 2)
    spectra = np.asarray(scipy.fft.rfft(squared))[:, : highest + 1]
    if turning.times is None:
        return _at_steps(spectra, size, turning.steps)
    narrow = scipy.fft.next_fast_len(max(6 * highest, 16), real=True)
    times = turning.times * narrow
    return np.stack([interpolated(one, times) for one in _at_steps(spectra, size, narrow)])


class _Taper:
    """The taper's square at even steps of a block: (steps,), and the lines of its spectrum."""

    def __init__(self, steps: int) -> None:
        self.window = np.square(taper(even_places(steps)))
        self.sum = float(np.sum(self.window))
        self.lines: ComplexArray = np.asarray(scipy.fft.rfft(self.window))
        self._made: dict[int, FloatArray] = {}

    def made_of(self, spread: int) -> FloatArray:
        """What so many lines on either side of zero make; kept from zero at the block's ends."""
        if spread not in self._made:
            steps = len(self.window)
            kept = np.zeros_like(self.lines)
            kept[: spread + 1] = self.lines[: spread + 1]
            least = _LEAST * float(self.lines[0].real) / steps
            self._made[spread] = np.maximum(scipy.fft.irfft(kept, steps), least)
        return self._made[spread]


class _Places:
    """Where lines of what turns are, and the lines about each that its noise is taken of."""

    def __init__(self, places: Sequence[Place], lines: int) -> None:
        line, self._within = np.array(places, dtype=np.float64).reshape(-1, 2).T
        self.centres = np.array([0, *np.rint(line)], dtype=np.int64)
        first = np.maximum(1, np.ceil(line - self._within)).astype(np.int64)
        last = np.minimum(lines, (line + self._within).astype(np.int64) + 1)
        start = np.maximum(1, first - _NEIGHBOURS)
        self._count = np.minimum(lines, last + _NEIGHBOURS) - start
        self._there = (first < last) & (self._count >= _NEIGHBOURS)
        about = start[:, None] + np.arange(np.max(self._count, initial=0))
        self._beyond = np.arange(about.shape[1]) >= self._count[:, None]
        self._at_place = (about >= first[:, None]) & (about < last[:, None])
        self._about = np.minimum(about, lines - 1)

    def spreads(self, power: FloatArray, most: int) -> IntArray:
        """Lines on either side that each line rises above the noise; -1 if it does not.

        power: (bands, lines). Returns (bands, places).
        """
        about = power[:, self._about]
        peaks = np.max(about, axis=2, where=self._at_place, initial=0.0)
        about[:, self._beyond] = np.inf
        about.sort(axis=2)
        middle = np.maximum(np.stack([self._count - 1, self._count]) // 2, 0)
        noise = 0.5 * np.sum(about[:, np.arange(len(self._count)), middle], axis=1) / log(2.0)
        ratio = np.divide(peaks, noise, out=np.zeros_like(peaks), where=noise > 0.0)
        spread = np.minimum(reach(envelope_leakage(), ratio / _SPREAD_TO), most)
        rises = self._there & (ratio >= log(power.shape[1] / _CHANCE))
        return np.where(rises, spread + self._within.astype(np.int64), -1)


def modulation_powers(
    envelopes: FloatArray, window: _Taper, slow: int, regular: _Places, lines: int, most: int
) -> ModulationPowers:
    """Powers of the lines of squared envelopes: as they are, and without their regular part.

    Parameters
    ----------
    envelopes
        (bands, steps), over even steps of the shaft's angle.
    window
        Of as many steps.
    slow
        Lines up to which a modulation may be slow.
    regular
        Where lines of what turns are.
    lines
        How many are needed.
    most
        Lines on either side that are taken with a regular one at most.
    """
    steps = envelopes.shape[1]
    spectra: ComplexArray = np.asarray(scipy.fft.rfft(envelopes))
    mean = spectra[:, :1].real / window.lines[0].real
    plain = power_of(spectra[:, :lines] - mean * window.lines[:lines])
    if not np.all(mean > 0.0):
        if len(envelopes) > 1:
            each = [
                modulation_powers(one, window, slow, regular, lines, most)
                for one in envelopes[:, np.newaxis]
            ]
            return ModulationPowers(*map(np.concatenate, zip(*each, strict=True)))
        spreads = np.full((1, len(regular.centres)), -1, dtype=np.int64)
        return ModulationPowers(plain, plain.copy(), np.zeros_like(plain), spreads)
    slowest = [[min(slow, _slow_spread(power, slow))] for power in plain]
    spreads = np.concatenate([slowest, regular.spreads(plain, most)], axis=1)
    # lines about all places that spread as far are made one sum
    level = np.zeros_like(envelopes)
    for spread in np.unique(spreads[spreads >= 0]).tolist():
        bands = np.flatnonzero(np.any(spreads == spread, axis=1))
        kept = np.zeros((len(bands), spectra.shape[1]), dtype=np.complex128)
        for into, band in zip(kept, bands, strict=True):
            for centre in regular.centres[spreads[band] == spread]:
                about = slice(max(0, centre - spread), centre + spread + 1)
                into[about] += spectra[band, about]
        level[bands] += np.asarray(scipy.fft.irfft(kept, steps)) / window.made_of(spread)
    level /= mean
    even = np.divide(envelopes, np.maximum(level, _LEAST, out=level), out=level)
    even -= window.window * (np.sum(even, axis=1, keepdims=True) / window.sum)
    power = power_of(np.asarray(scipy.fft.rfft(even))[:, :lines])
    return ModulationPowers(plain, power, plain * (2.0 / spectra[:, :1].real) ** 2, spreads)


def _at_steps(spectra: ComplexArray, size: int, steps: int) -> FloatArray:
    """The first lines of spectra of so many samples, at another number of steps."""
    count = min(spectra.shape[1], steps // 2 + 1)
    return np.asarray(scipy.fft.irfft(spectra[:, :count], steps)) * (steps / size)


def _slow_spread(power: FloatArray, slow: int) -> int:
    """Lines from zero up to which the modulation rises above the noise; 0 if nowhere."""
    about = power[slow + 1 : slow + 1 + 2 * _NEIGHBOURS]
    noise = float(median(about)) / log(2.0) if len(about) else 0.0
    if noise <= 0.0:
        return slow
    ratio = power[1 : slow + 1] / noise
    rises = np.flatnonzero(ratio >= log(len(power) / _CHANCE))
    if len(rises) == 0:
        return 0
    return int(rises[-1] + 1 + reach(envelope_leakage(), ratio[rises[-1]] / _SPREAD_TO))


# --- all bands of all blocks ---------------------------------------------------------------------


_DIVISIONS: Final = (1, 2, 3, 4, 6, 8)
_LONG: Final = 2**17
"""Samples of a first block from which on threads share its bands."""
_AT_ONCE: Final = 2
"""Bands: SciPy transforms as many as two side by side in vector instructions."""
_BANDWIDTH: Final = 2.5
"""Bandwidth of the narrowest band, over the highest modulation frequency that is looked at in
it."""


@frozen
class Plan:
    """How blocks are analysed.

    Attributes
    ----------
    highest_order
        of the spectra
    slow_order
        up to which a modulation counts as slow
    regular
        orders of what turns
    remove_tones
        whether to take out discrete lines
    combs
        of faults whose discrete lines stay: lowest and highest order of each, and its spacing
    speed_uncertainty
        part by which a steady speed may be off
    speed_factor
        speed of the shaft over that of the blocks
    """

    highest_order: float
    slow_order: float
    regular: tuple[float, ...]
    remove_tones: bool
    combs: tuple[tuple[float, float, float], ...]
    speed_uncertainty: float
    speed_factor: float


@frozen(eq=False)
class BandSpectra:
    """Powers of the squared envelopes' lines, averaged over blocks.

    Attributes
    ----------
    plain
        (bands, lines), of the squared envelopes as they are, in arbitrary units
    power
        (bands, lines), of the squared envelopes with their regular part divided out
    depth
        (bands, lines), mean square of the modulation depth
    regular
        places of multiples of what turns
    spreads
        (bands, 1 + regular), maximum number of lines on either side of zero and of each of these
        that were taken for regular in any block; -1 for none
    bands
        Hz
    turns
        revolutions in a block: the lines are one over this apart, from order 0
    blocks
        how many were averaged
    still
        how many more were left out because they hardly change; if all are, the powers are 0
    samples
        how many were used
    rate
        Hz
    slow_order
        up to which the modulation is divided out
    bare
        likewise because they hold nothing but tones
    has_comb
        whether most hold a full comb of discrete lines at a part's frequency: impacts without slip
    dropouts
        whether samples only repeat the one before, again and again
    repeats_after
        samples after which the record begins anew, one by one the same; None if it does not
    kurtosis
        of the samples; 3 for noise, NaN if they do not change
    band_kurtosis
        (bands,), of the whitened samples in each band; 3 for noise
    """

    plain: FloatArray
    power: FloatArray
    depth: FloatArray
    regular: tuple[Place, ...]
    spreads: IntArray
    bands: tuple[Band, ...]
    turns: float
    blocks: int
    still: int
    samples: int
    rate: float
    slow_order: float
    bare: int
    has_comb: bool
    dropouts: bool
    repeats_after: int | None
    kurtosis: float
    band_kurtosis: FloatArray

    @property
    def shaft_frequency(self) -> float:
        """Mean over the record; Hz."""
        return self.turns * self.blocks * self.rate / self.samples


def band_spectra(blocks: Iterable[Whitening], plan: Plan) -> BandSpectra:
    """Squared-envelope spectra of many bands, averaged over blocks.

    Raises
    ------
    InputError
        If there are no blocks.
    """
    watch = Watch()
    sums: _Sums | None = None
    length = 0
    for whitening in blocks:
        samples = whitening.block.samples
        sums = _Sums(whitening.block, plan) if sums is None else sums
        length = len(samples)
        if watch.usable(samples):
            sums.add(whitening)
    if sums is None:
        raise InputError(said("has no samples"), field="signal")
    number, used = (sums.number, sums.samples) if sums.number else (1, length)
    return BandSpectra(
        plain=sums.powers[0] / number,
        power=sums.powers[1] / number,
        depth=sums.depths / number,
        regular=sums.regular,
        spreads=sums.spreads,
        bands=sums.bands,
        turns=sums.turns,
        blocks=number,
        still=watch.still,
        samples=used,
        rate=sums.rate,
        slow_order=plan.slow_order,
        bare=sums.bare,
        has_comb=2 * sums.combs > sums.number,
        dropouts=watch.gaps > MOST_GAPS,
        repeats_after=watch.repeats_after,
        kurtosis=sums.kurtosis,
        band_kurtosis=sums.band_kurtosis,
    )


class _Together(NamedTuple):
    """Bands one after the other, their lines in a block's spectrum, and samples of each at most."""

    bands: slice
    carriers: tuple[slice, ...]
    size: int


class _Sums:
    """Sums over blocks that are all like the first."""

    def __init__(self, first: Block, plan: Plan) -> None:
        turns, rate = first.turns * plan.speed_factor, first.rate
        lines = ceil(plan.highest_order * turns) + 1 + HALF_WIDTH
        self.turns, self.rate = turns, rate
        self.bands = _bands(rate, plan.highest_order * turns * rate / len(first.samples))
        # where the speed was measured all along, orders are as they are
        uncertainty = plan.speed_uncertainty if first.places is None else 0.0
        self._combs = [
            Comb(low * turns, high * turns, spacing * turns, turns, uncertainty)
            for low, high, spacing in plan.combs
        ]
        self.regular = tuple(shaft_places(plan.regular, turns, lines, uncertainty))
        self._places = _Places(self.regular, lines)
        self._window = _Taper(steps_of(lines))
        self._slow = max(1, int(plan.slow_order * turns))
        self._remove_tones = plan.remove_tones
        self.powers = np.zeros((2, len(self.bands), lines))
        self.depths = np.zeros((len(self.bands), lines))
        self.spreads = np.full((len(self.bands), 1 + len(self.regular)), -1, dtype=np.int64)
        self.number = self.samples = self.bare = self.combs = 0
        # of the samples, and of each band's squared envelope: Σ x, Σ x², … of each
        self._raw = np.zeros(4)
        self._squares = np.zeros((2, len(self.bands)))

    @property
    def kurtosis(self) -> float:
        """Kurtosis of all samples that were used."""
        mean, second, third, fourth = self._raw / max(self.samples, 1)
        variance = second - mean**2
        if variance <= 0.0:
            return nan
        central = fourth - 4.0 * mean * third + 6.0 * mean**2 * second - 3.0 * mean**4
        return float(central / variance**2)

    @property
    def band_kurtosis(self) -> FloatArray:
        """Kurtosis of each band: of a narrow band 1.5 E|a|⁴/(E|a|²)², with its envelope |a|."""
        first, second = self._squares / max(self.number, 1)
        window = np.square(taper(even_places(_FOR_TAPER)))
        of_taper = np.mean(np.square(window)) / np.mean(window) ** 2
        found = np.full(len(self.bands), nan)
        np.divide(1.5 * second, of_taper * first**2, out=found, where=first > 0.0)
        return found

    def add(self, whitening: Whitening) -> None:
        """Add a block's powers, plain and with the regular part divided out."""
        block = whitening.block
        found = whitening.white(remove_tones=self._remove_tones, combs=self._combs)
        if found is None:
            self.bare += 1
            return
        self.combs += found.has_comb
        turning = Turning.of(block.places, self.powers.shape[2])
        together = self._together(len(found.spectrum), 0.5 * block.rate, turning)
        of_bands = partial(self._of_bands, found.spectrum, turning)
        # of short blocks the interpreter's share is too large; in a long record, whose memory
        # must not grow, each thread would keep memory of its own
        shared = self.number == 0 and len(block.samples) >= _LONG
        side = side_by_side if shared else map
        for bands, (powers, squares) in zip(together, side(of_bands, together), strict=True):
            some = bands.bands
            self._squares[:, some] += squares
            self.powers[0, some] += powers.plain
            self.powers[1, some] += powers.even
            self.depths[some] += powers.depth
            self.spreads[some] = np.maximum(self.spreads[some], powers.spreads)
        self.number += 1
        self.samples += len(block.samples)
        self._raw += [np.sum(block.samples**power) for power in (1, 2, 3, 4)]

    def _together(self, lines: int, half_rate: float, turning: Turning) -> list[_Together]:
        """The bands of a block's spectrum of so many lines, some of one size at a time."""
        found: list[_Together] = []
        per_hertz = lines / half_rate
        for number, band in enumerate(self.bands):
            first, last = (round(edge * per_hertz) for edge in band)
            carriers = slice(max(1, first), last)
            # a squared envelope is twice as wide as its band; only what is looked at must not fold
            count = last - carriers.start
            size = int(scipy.fft.next_fast_len(min(2 * count, count + turning.fastest + 1)))
            if found and found[-1].size == size and len(found[-1].carriers) < _AT_ONCE:
                begin = found[-1].bands.start
                found[-1] = _Together(
                    slice(begin, number + 1), (*found[-1].carriers, carriers), size
                )
            else:
                found.append(_Together(slice(number, number + 1), (carriers,), size))
        return found

    def _of_bands(
        self, white: ComplexArray, turning: Turning, bands: _Together
    ) -> tuple[ModulationPowers, FloatArray]:
        """Powers of some bands of a block, of the sums over products of carriers.

        And (2, bands), means of the squared envelopes and of their squares.
        """
        size = bands.size
        one_sided = np.zeros((len(bands.carriers), size), dtype=np.complex128)
        for into, carriers in zip(one_sided, bands.carriers, strict=True):
            into[: carriers.stop - carriers.start] = white[carriers]
        squared = power_of(np.asarray(scipy.fft.ifft(one_sided, overwrite_x=True)))
        squares = np.stack([np.mean(squared**power, axis=1) for power in (1, 2)])
        squares *= np.array([[float(size) ** 2], [float(size) ** 4]])
        for one in squared:
            limit(one)
        envelopes = over_angle(squared, turning)
        powers = modulation_powers(
            envelopes,
            self._window,
            self._slow,
            self._places,
            self.powers.shape[2],
            most_spread(self.turns),
        )
        # however many steps it was taken in
        scale = float(size) ** 4 / float(envelopes.shape[1]) ** 2
        return powers._replace(plain=powers.plain * scale, even=powers.even * scale), squares


def _bands(rate: float, highest: float) -> tuple[Band, ...]:
    """Equal divisions of half the rate, none narrower than the modulations to be seen need."""
    half = 0.5 * rate
    divisions = [d for d in _DIVISIONS if d == 1 or half / d >= _BANDWIDTH * highest]
    return tuple((half * i / d, half * (i + 1) / d) for d in divisions for i in range(d))
