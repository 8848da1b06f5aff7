"""The fast kurtogram: how impulsive a signal is in each of many bands.

Antoni, Mechanical Systems and Signal Processing 21 (2007), 108-124. From a low-pass prototype h of
cut-off 1/8 + ε (in samples per cycle) two quasi-analytic filters,

    h0(n) = h(n) e^(jπn/4),   h1(n) = h(n) e^(3jπn/4),

split a sequence in its lower and upper half; each output is decimated by 2, the upper one
multiplied by (-1)^n so that its band runs upward from 0 again, and split anew: 2^k bands on level
k. On every level three filters of a third of the bandwidth, from a prototype g of cut-off
1/12 + ε, moved to 1/12, 3/12 and 5/12 and decimated by 3, add 3·2^k bands. The figure of a band is
the kurtosis of its complex envelope c,

    K = ⟨|c|⁴⟩/⟨|c|²⟩² - 2      (⟨x⁴⟩/⟨x²⟩² - 3 for the real signal on level 0),

0 for Gaussian noise, with a standard deviation of 2/√n over n independent values, and -1 for a
steady tone. The prototypes are those of the author's own program: order 16, and 24 for thirds, with
cut-offs 0.2 and 0.2/1.5. They are short and wide, and neighbouring bands overlap.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import log2, sqrt
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray
from scipy import signal as scipy_signal

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_count, require_samples
from rolamento.vibration.envelope import analytic_signal
from rolamento.vibration.signal import Signal

__all__ = ["Kurtogram", "KurtogramBand", "KurtogramLevel", "kurtogram"]

Sequence1D = NDArray[Any]
Choice = Literal["kurtosis", "significance"]

FILTER_ORDER: Final = 16
CUTOFF: Final = 0.2
"""Of the prototype that halves; cycles per sample."""
_LEAST_VALUES: Final = 64
"""In a band: with fewer a kurtosis tells nothing."""
_MOST_LEVELS: Final = 12


@dataclass(frozen=True, slots=True)
class KurtogramBand:
    """One band of a kurtogram.

    Attributes
    ----------
    band
        Hz
    level
        log2 of how many bands share half the sampling rate
    kurtosis
        K, 0 for Gaussian noise
    significance
        K over its standard deviation in Gaussian noise
    """

    band: Band
    level: float
    kurtosis: float
    significance: float


@dataclass(frozen=True, slots=True, eq=False)
class KurtogramLevel:
    """All bands of one level, from low to high.

    Attributes
    ----------
    level
        log2 of the number of bands
    bandwidth
        Hz
    kurtosis
        (bands,)
    deviation
        standard deviation of the kurtosis of as many values of Gaussian noise
    """

    level: float
    bandwidth: float
    kurtosis: FloatArray
    deviation: float

    def band(self, index: int) -> KurtogramBand:
        """Return one band by its number."""
        value = float(self.kurtosis[index])
        edges = (index * self.bandwidth, (index + 1) * self.bandwidth)
        return KurtogramBand(edges, self.level, value, value / self.deviation)


@dataclass(frozen=True, slots=True, eq=False)
class Kurtogram:
    """Kurtosis over frequency and bandwidth; `picture` gives it as a grid.

    Attributes
    ----------
    rate
        Hz
    levels
        from all in one band to the narrowest
    """

    rate: float
    levels: tuple[KurtogramLevel, ...]

    def picture(self) -> FloatArray:
        """Kurtosis as a grid: a row per level, columns evenly from 0 to half the sampling rate."""
        columns = int(np.lcm.reduce([len(level.kurtosis) for level in self.levels]))
        return np.stack([np.repeat(lv.kurtosis, columns // len(lv.kurtosis)) for lv in self.levels])

    def best(self, by: Choice = "kurtosis") -> KurtogramBand:
        """Return the band that stands out most.

        Parameters
        ----------
        by
            "kurtosis": as published; a narrow band of few values may win by chance.
            "significance": kurtosis over its standard deviation in noise; leans to wide bands.

        Raises
        ------
        InputError
            If the choice is unknown.
        """
        if by not in ("kurtosis", "significance"):
            rule = "must be kurtosis or significance"
            raise InputError(rule, field="by", value=by, example='by = "kurtosis"')
        bands = (lv.band(i) for lv in self.levels for i in range(len(lv.kurtosis)))
        return max(bands, key=lambda band: float(getattr(band, by)))


def kurtogram(signal: Signal, levels: int | None = None) -> Kurtogram:
    """Fast kurtogram of a signal.

    Parameters
    ----------
    signal
        At least 256 samples.
    levels
        How often to halve the bands, from 1; by default as often as leaves 64 values in the
        narrowest band, and at most 8 times.

    Raises
    ------
    InputError
        If the signal is too short for that many levels.
    """
    require_samples(signal, 256, "a kurtogram")
    possible = min(_MOST_LEVELS, int(log2(len(signal.samples) / (3 * _LEAST_VALUES))))
    depth = (
        min(possible, 8)
        if levels is None
        else checked_count(levels, "levels", least=1, most=max(possible, 1), example="levels = 5")
    )
    samples = signal.samples - np.mean(signal.samples)
    # of the analytic signal, or noise that wide filters let in from below zero would be squared
    # with its own image, and look impulsive
    bands: list[Sequence1D] = [analytic_signal(signal)]
    halves = _filters(FILTER_ORDER, CUTOFF, (1.0 / 8.0, 3.0 / 8.0))
    thirds = _filters(3 * FILTER_ORDER // 2, CUTOFF / 1.5, (1.0 / 12.0, 3.0 / 12.0, 5.0 / 12.0))
    found = [_level(signal.rate, [samples])]
    for _ in range(depth):
        split = [part for band in bands for part in _split(band, thirds)]
        bands = [part for band in bands for part in _split(band, halves)]
        found += [_level(signal.rate, bands), _level(signal.rate, split)]
    return Kurtogram(signal.rate, tuple(sorted(found, key=lambda level: level.level)))


def _filters(order: int, cutoff: float, centres: tuple[float, ...]) -> list[Sequence1D]:
    prototype = scipy_signal.firwin(order + 1, cutoff, fs=1.0)
    turns = np.arange(order + 1)
    return [prototype * np.exp(2j * np.pi * centre * turns) for centre in centres]


def _split(band: Sequence1D, filters: list[Sequence1D]) -> list[Sequence1D]:
    """Filter and decimate by the number of filters, without the filters' run-in.

    A band of an odd place has come down upside up but half a band off: what lies above half the
    new rate is turned back to where it belongs.
    """
    count = len(filters)
    parts = []
    for place, taps in enumerate(filters):
        part = scipy_signal.upfirdn(taps, band, down=count)[: len(band) // count]
        part = part[-(-len(taps) // count) :]
        if place % 2 == 1:
            part[1::2] *= -1.0
        parts.append(part)
    return parts


def _level(rate: float, bands: list[Sequence1D]) -> KurtogramLevel:
    real = not np.iscomplexobj(bands[0])
    # variances of the kurtosis of n Gaussian values: 24/n real, 4/n complex
    deviation = sqrt((24.0 if real else 4.0) / len(bands[0]))
    return KurtogramLevel(
        level=log2(len(bands)),
        bandwidth=0.5 * rate / len(bands),
        kurtosis=np.array([_kurtosis(band, 3.0 if real else 2.0) for band in bands]),
        deviation=deviation,
    )


def _kurtosis(band: Sequence1D, of_noise: float) -> float:
    """Kurtosis less that of Gaussian noise; 0 for a band without power."""
    power = np.square(np.abs(band - np.mean(band)))
    greatest = float(np.max(power))
    if greatest == 0.0:
        return 0.0
    power /= greatest
    return float(np.mean(np.square(power)) / np.mean(power) ** 2) - of_noise
