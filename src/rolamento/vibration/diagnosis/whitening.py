"""A block's spectrum, tapered, without discrete tones, and whitened.

Gears, shafts and electric fields make discrete lines, which are taken out. A line counts as
discrete if noise of the level about it would hardly ever reach it, and if it is as narrow as the
taper makes a steady tone. Impacts that slip make broad humps, which stay.

One kind of discrete lines stays too: a full comb of the frequency of a fault, where most of all
lines that do not belong to the shaft are its teeth or their sidebands and at least every other
tooth is there. A bearing that hardly slips makes it, and no gear.

Tones are discrete where what makes them turns steadily: over time if the shaft does, else over its
angle. In the latter case the block is interpolated at even steps of the angle to find them, and
what they add up to is taken back to time and subtracted.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import ceil, log, sqrt
from typing import Final, NamedTuple

import numpy as np
import scipy

from rolamento.numerics import BoolArray, ComplexArray, FloatArray, IntArray
from rolamento.numerics.percentiles import median
from rolamento.records import frozen
from rolamento.vibration.diagnosis.blocks import Block
from rolamento.vibration.diagnosis.lines import power_of, reach, runs, taper, tone_leakage
from rolamento.vibration.order_tracking import interpolated

_CHANCE: Final = 0.01
"""That noise has any line which is taken for a tone."""
_LEVEL_WIDTH: Final = 25.0
"""Hz over which a level is taken: narrower than resonances."""
_LEVEL_LINES: Final = 64
_TEETH: Final = 6
_SIDEBANDS: Final = 2
_MOST_CANDIDATES: Final = 20_000
_MOST_TONES: Final = 500


@frozen
class Comb:
    """Where the comb of a fault may lie: its fundamental from low to high, in lines of a spectrum.

    `spacing` is that of its sidebands, 0 for none, and `shaft` the shaft's frequency, in lines;
    `uncertainty` the part by which the latter may be off.
    """

    low: float
    high: float
    spacing: float
    shaft: float
    uncertainty: float


def local_level(power: FloatArray, resolution: float) -> FloatArray:
    """Mean power of the noise about each line, from medians, unmoved by tones; as `power`.

    resolution: Hz.
    """
    width = min(max(_LEVEL_LINES, int(_LEVEL_WIDTH / resolution)), max(1, len(power) // 2))
    stretches = len(power) // width
    medians = median(power[: stretches * width].reshape(stretches, width)) / log(2.0)
    least = float(np.max(medians)) * 1e-14
    middles = (np.arange(stretches) + 0.5) * width
    logs = np.log(np.maximum(medians, least if least > 0.0 else 1.0))
    return np.asarray(np.exp(np.interp(np.arange(len(power)), middles, logs)))


class Tones(NamedTuple):
    """Discrete tones: power of each line over the noise (lines,), and the lines of their peaks."""

    ratio: FloatArray
    peaks: IntArray

    def parted(self, combs: Sequence[Comb]) -> tuple[BoolArray, BoolArray]:
        """Which lines belong to tones, and which to combs of faults; (lines,) each.

        Each tone has all lines over which it rises from the noise.
        """
        teeth = np.zeros(len(self.peaks), dtype=np.bool_)
        for comb in combs:
            teeth |= _teeth(self.peaks, comb)
        of_tones, of_combs = (np.zeros(len(self.ratio), dtype=np.bool_) for _ in range(2))
        widths = reach(tone_leakage(), self.ratio[self.peaks])
        for peak, width, is_tooth in zip(self.peaks, widths, teeth, strict=True):
            lines = of_combs if is_tooth else of_tones
            lines[max(0, peak - width) : peak + width + 1] = True
        return of_tones, of_combs


def tones_of(power: FloatArray, level: FloatArray) -> Tones:
    """Return the discrete tones of a tapered block.

    Parameters
    ----------
    power
        (lines,), of the spectrum of real samples.
    level
        (lines,), of the noise's power.
    """
    ratio = power / level
    limit = log(len(ratio) / _CHANCE)
    starts, ends = runs(ratio > limit)
    peaks = np.array(
        [start + int(np.argmax(ratio[start:end])) for start, end in zip(starts, ends, strict=True)],
        dtype=np.int64,
    )
    widths = 2 * reach(tone_leakage(), ratio[peaks] / limit) + 1
    return Tones(ratio, peaks[ends - starts <= widths + 2])


def _teeth(tones: IntArray, comb: Comb) -> BoolArray:
    """Which tones are teeth of a full comb or their sidebands; none if there is no full comb."""
    of_shaft = _are_multiples(tones, comb.shaft, comb.uncertainty)
    others = tones[~of_shaft]
    none = np.zeros(len(tones), dtype=np.bool_)
    if len(others) < _TEETH:
        return none
    best = _best_fundamental(others[:_MOST_TONES], comb)
    present = np.unique(np.rint(others[_are_multiples(others, best)] / best))
    full = len(present) >= _TEETH and 2.0 * len(present) >= np.ptp(present) + 1.0
    teeth = _near_comb(tones, best, comb.spacing) & ~of_shaft
    return teeth if full and 2 * np.count_nonzero(teeth) > len(others) else none


def _near_comb(tones: IntArray, fundamental: float, spacing: float) -> BoolArray:
    """Which tones are multiples of a fundamental, or up to two spacings away from one."""
    sides = range(-_SIDEBANDS, _SIDEBANDS + 1) if spacing > 0.0 else range(1)
    places = tones.astype(np.float64)
    near = [_are_multiples(places - side * spacing, fundamental) for side in sides]
    return np.asarray(np.any(near, axis=0))


def _best_fundamental(tones: IntArray, comb: Comb) -> float:
    """Fundamental of which most tones are multiples; tried in steps of a line at the last tone."""
    steps = int((comb.high - comb.low) * float(tones[-1]) / comb.low) + 2
    candidates = np.linspace(comb.low, comb.high, min(steps, _MOST_CANDIDATES))
    hits = [
        np.count_nonzero(_are_multiples(tones, part[:, None]), axis=1)
        for part in np.array_split(candidates, len(candidates) // 500 + 1)
    ]
    return float(candidates[np.argmax(np.concatenate(hits))])


def _are_multiples(
    tones: IntArray | FloatArray, fundamental: float | FloatArray, uncertainty: float = 0.0
) -> BoolArray:
    """Which tones lie within a line of a multiple, or within a part of themselves.

    That part counts up to a tenth of the fundamental; beyond, nothing can be said.
    """
    number = np.rint(tones / fundamental)
    off = np.abs(tones - number * fundamental)
    allowed = np.maximum(1.0, np.minimum(uncertainty * tones, 0.1 * fundamental))
    return np.asarray((number >= 1) & (off <= allowed))


# --- whitening -----------------------------------------------------------------------------------


_NOTHING: Final = 1e-20
"""Fraction of the maximum level: rounding."""
_BARE: Final = 1e-9
"""Fraction of the power: what noise has less of beside tones may be the rounding of 16 bits."""
_LARGEST: Final = log(50.0)
"""Power of a line over the noise's, which one of fifty lines of noise exceeds."""
_MEDIAN_OF_NOISE: Final = 0.6745
"""Median size of Gaussian noise over its deviation."""
_CHANCE_OF_LIMIT: Final = 0.01
"""That noise alone has a sample which is limited."""
_SHOCK: Final = 2.0
"""Times that: what gears, which are not noise, do not reach either."""


class Whitened(NamedTuple):
    """Spectrum of a block over the level of its noise; whether it kept a comb of discrete lines."""

    spectrum: ComplexArray
    has_comb: bool


class Whitening:
    """A block on its way to a white spectrum; what shaft and bands both take of it is made once.

    No line is larger than one of noise hardly ever is, so that what is left of tones weighs little;
    and then no sample, so that a few great shocks do not weigh more than all the rest: a few
    instants always have some period in common.
    """

    def __init__(self, block: Block) -> None:
        self.block = block
        self._resolution = block.rate / len(block.samples)

    def white(self, *, remove_tones: bool, combs: Sequence[Comb] = ()) -> Whitened | None:
        """Spectrum over the level of its noise, and 0 where there were tones.

        None if there is nothing beside the tones: what is left of a computed tone is rounding, and
        has any line.

        combs: of faults, whose discrete lines stay and keep their size over the noise.
        """
        places = self.block.places
        if places is not None:
            lines = self._lines_without_tones(places, combs) if remove_tones else self._lines
            return None if lines.are_bare else Whitened(self._whitened(lines), has_comb=False)
        if self._lines.are_bare:
            return None
        if not remove_tones:
            return Whitened(self._whitened(self._lines), has_comb=False)
        tones, teeth = self._tones.parted(combs)
        if not np.any(teeth):
            return Whitened(self._without_tones, has_comb=False)
        return Whitened(self._whitened(self._lines, tones, teeth), has_comb=True)

    @cached_property
    def power(self) -> FloatArray:
        """Power of the lines of the tapered samples, great shocks and all; (lines,)."""
        samples, without_shocks = self._samples
        if without_shocks is samples:
            return self._lines.power
        return power_of(self._spectrum(samples - np.mean(samples)))

    @cached_property
    def _samples(self) -> tuple[FloatArray, FloatArray]:
        """About their median: as they are, and without great shocks, the same where none are."""
        samples = self.block.samples - median(self.block.samples)
        return samples, _limited(samples, _SHOCK)

    @cached_property
    def _lines(self) -> _Lines:
        _, samples = self._samples
        return _Lines.of(self._spectrum(samples - np.mean(samples)), self._resolution)

    @property
    def _taper(self) -> FloatArray:
        places = self.block.places
        return taper(even_places(len(self.block.samples)) if places is None else places)

    def _spectrum(self, samples: FloatArray) -> ComplexArray:
        return np.asarray(scipy.fft.rfft(samples * self._taper))

    def _lines_without_tones(self, places: FloatArray, combs: Sequence[Comb]) -> _Lines:
        """Lines over time, without all that turns with a shaft of varying speed."""
        _, limited = self._samples
        samples = limited - np.mean(limited)
        tones = _turning_tones(samples, places, self._resolution, combs)
        if tones is None:
            return self._lines
        without = np.asarray(scipy.fft.rfft(samples * self._taper - tones))
        return _Lines.of(without, self._resolution)

    @cached_property
    def _tones(self) -> Tones:
        return tones_of(self._lines.power, self._lines.level)

    @cached_property
    def _without_tones(self) -> ComplexArray:
        tones, _ = self._tones.parted(())
        return self._whitened(self._lines, tones)

    def _whitened(
        self, lines: _Lines, tones: BoolArray | None = None, teeth: BoolArray | None = None
    ) -> ComplexArray:
        """Lines over the level of the noise, 0 at tones; limited, lines and samples."""
        white = lines.even(teeth)
        if tones is not None:
            white[tones] = 0.0
        even = np.asarray(scipy.fft.irfft(white, len(self.block.samples)))
        limited = _limited(even, 1.0)
        if limited is even:
            return white
        return _Lines.of(np.asarray(scipy.fft.rfft(limited)), self._resolution).even(teeth)


def even_places(count: int) -> FloatArray:
    """Middles of so many equal parts of a block, from 0 to 1."""
    return (np.arange(count, dtype=np.float64) + 0.5) / count


class _Lines(NamedTuple):
    """A block's lines, their power, and the level of the noise about each; (lines,) each."""

    spectrum: ComplexArray
    power: FloatArray
    level: FloatArray

    @classmethod
    def of(cls, spectrum: ComplexArray, resolution: float) -> _Lines:
        power = power_of(spectrum)
        return cls(spectrum, power, local_level(power, resolution))

    @property
    def are_bare(self) -> bool:
        """Whether there is nothing beside tones."""
        return bool(median(self.level) * len(self.level) < _BARE * np.sum(self.power))

    def even(self, teeth: BoolArray | None) -> ComplexArray:
        """The lines over the level of the noise, limited but for the teeth of combs."""
        # of a line without power the phase is rounding
        level = np.maximum(self.level, _NOTHING * float(np.max(self.level)))
        white = self.spectrum / np.sqrt(np.maximum(level, self.power / _LARGEST))
        if teeth is not None:
            white[teeth] = self.spectrum[teeth] / np.sqrt(level[teeth])
        white[0] = 0.0
        return np.asarray(white)


def _limited(samples: FloatArray, margin: float) -> FloatArray:
    """Samples no larger than a margin times what noise of their level hardly ever reaches."""
    deviation = float(median(np.abs(samples))) / _MEDIAN_OF_NOISE
    largest = margin * deviation * sqrt(2.0 * log(len(samples) / _CHANCE_OF_LIMIT))
    if max(float(np.max(samples)), -float(np.min(samples))) <= largest:
        return samples
    return np.clip(samples, -largest, largest)


def _turning_tones(
    samples: FloatArray, places: FloatArray, resolution: float, combs: Sequence[Comb]
) -> FloatArray | None:
    """The sum of all that turns with the shaft, tapered; (samples,), None if nothing does."""
    count = len(samples)
    slowest = float(np.min(np.diff(places)))
    steps = scipy.fft.next_fast_len(min(ceil(1.0 / slowest), 4 * count), real=True)
    even = even_places(steps)
    at = np.interp(even, places, np.arange(count, dtype=np.float64))
    # over time or over angle, lines are one over the block apart
    lines = _Lines.of(
        np.asarray(scipy.fft.rfft(interpolated(samples, at) * taper(even))), resolution
    )
    tones, _ = tones_of(lines.power, lines.level).parted(combs)
    if not np.any(tones):
        return None
    return interpolated(
        np.asarray(scipy.fft.irfft(np.where(tones, lines.spectrum, 0.0), steps)),
        places * steps - 0.5,
    )
