"""Demodulation: the envelope of a signal in a band, whitened spectra, the kurtogram.

A damaged spot is met again and again, and each impact makes the structure ring: the ringing carries
the rate of the impacts as a modulation of its *amplitude*, which the envelope recovers (Randall and
Antoni, Mechanical Systems and Signal Processing 25 (2011), 485-520). With z the analytic signal of
the band, the one-sided spectrum of which is that of the signal twice,

    envelope e = |z|,     squared envelope e² = |z|².

The spectrum of the squared envelope is the one to prefer: squaring makes no harmonics beyond those
of the modulation, and its lines in noise have a plain distribution (see docs/theory).

Cepstrum pre-whitening: every line of the spectrum gets the same size and keeps its phase.

The real cepstrum is the inverse transform of ln |X|; set to zero but for its first value, what is
left is a spectrum of one size with the phases of the signal. Tones and resonances lose their
weight together, and impacts stand out (Sawalhi and Randall 2011; Borghesani et al., Mechanical
Systems and Signal Processing 36 (2013), 370-384).

The fast kurtogram: how impulsive a signal is in each of many bands.

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

from collections.abc import Callable, Iterable
from functools import partial
from itertools import chain
from math import log2, sqrt
from typing import Any, Final, Literal, NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.numerics.threads import side_by_side
from rolamento.records import frozen
from rolamento.vibration._checks import Band, checked_band, checked_count, require_samples
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import EDGE, Spectrum, axis_of, one_sided_amplitudes
from rolamento.words import marked, said

EnvelopeKind = Literal["squared", "plain"]
_LEAST_LINES = 4


def analytic_signal(signal: Signal, band: Band | None = None) -> ComplexArray:
    """Analytic signal of a band: its real part is the signal as filtered to the band.

    The filter has steep edges and no delay. Zero frequency is left out.

    Parameters
    ----------
    signal
        At least two samples.
    band
        Hz, with the lines on its edges; by default all up to half the sampling rate.

    Returns
    -------
    (samples,), in the signal's unit.

    Raises
    ------
    InputError
        If the band is outside the signal's range, or holds fewer than four lines.
    """
    require_samples(signal, 2, marked("an envelope"))
    count = len(signal.samples)
    edges = (0.0, 0.5 * signal.rate) if band is None else checked_band(band, signal.rate)
    first, last = _lines(edges, signal.rate, count)
    spectrum = np.asarray(scipy.fft.rfft(signal.samples))
    one_sided = np.zeros(count, dtype=np.complex128)
    one_sided[first:last] = 2.0 * spectrum[first:last]
    if count % 2 == 0 and last > count // 2:
        one_sided[count // 2] *= 0.5
    return np.asarray(scipy.fft.ifft(one_sided, overwrite_x=True))


def envelope(signal: Signal, band: Band | None = None) -> Signal:
    """Hilbert envelope |z| of a signal in a band, in its unit; arguments as `analytic_signal`."""
    return Signal(
        np.abs(analytic_signal(signal, band)),
        signal.rate,
        signal.quantity,
        signal.unit,
        signal.speed,
        signal.title,
    )


def envelope_spectrum(
    signal: Signal, band: Band | None = None, *, kind: EnvelopeKind = "squared"
) -> Spectrum:
    """Amplitudes of the lines of the envelope, or of its square, without their mean.

    Parameters
    ----------
    signal, band
        As `analytic_signal`.
    kind
        "squared": of e², in unit²; "plain": of e, in unit.

    Returns
    -------
    Spectrum over Hz. Half the sum of the squares of its values is the variance of e² or e. The
    line at half the rate, which an even number of samples has, counts whole in that: of e² it is
    0, as no two lines of a band are that far apart, of e it is not.

    Raises
    ------
    InputError
        As `analytic_signal`, or if the kind is unknown.
    """
    if kind not in ("squared", "plain"):
        raise InputError(
            said("must be squared or plain"), field="kind", value=kind, example='kind = "squared"'
        )
    size: FloatArray = np.abs(analytic_signal(signal, band))
    if kind == "squared":
        size = np.square(size)
    values = one_sided_amplitudes(size - np.mean(size))
    resolution = signal.rate / len(size)
    unit = signal.unit or "unit"
    return Spectrum(
        axis=axis_of(len(values), resolution),
        values=values,
        axis_unit="Hz",
        unit=f"({unit})^2" if kind == "squared" else unit,
        resolution=resolution,
    )


def _lines(band: Band, rate: float, count: int) -> tuple[int, int]:
    """First line in a band, edges included, and the one after the last; not zero frequency."""
    first = max(1, int(np.ceil(band[0] * count / rate - EDGE)))
    last = min(count // 2, int(np.floor(band[1] * count / rate + EDGE))) + 1
    if last - first < min(_LEAST_LINES, count // 2):
        raise InputError(
            said(
                "contains fewer than {least} lines of the signal, which are {rate:.3g} Hz apart",
                least=_LEAST_LINES,
                rate=rate / count,
            ),
            field="band",
            value=str(band),
            example="band = (2000.0, 4000.0)",
        )
    return first, last


# --- cepstrum pre-whitening ----------------------------------------------------------------------


def prewhitened(signal: Signal) -> Signal:
    """Return the signal with a white spectrum and its own phases.

    Its RMS about the mean is 1; its unit is "1". Lines without any power stay without.

    Raises
    ------
    InputError
        If there are fewer than four samples.
    """
    require_samples(signal, 4, marked("pre-whitening"))
    count = len(signal.samples)
    spectrum = np.asarray(scipy.fft.rfft(signal.samples))
    spectrum[0] = 0.0
    size = np.abs(spectrum)
    present = size > 0.0
    spectrum[present] /= size[present]
    white = scipy.fft.irfft(spectrum, count)
    rms = float(np.sqrt(np.mean(np.square(white))))
    samples = white / rms if rms > 0.0 else white
    return Signal(samples, signal.rate, "unknown", "1", signal.speed, signal.title)


# --- the fast kurtogram --------------------------------------------------------------------------


Bands = NDArray[Any]
"""(bands, values), real or complex."""
Choice = Literal["kurtosis", "significance"]
FILTER_ORDER: Final = 16
CUTOFF: Final = 0.2
"""Cut-off of the prototype that halves; cycles per sample."""
_ROUNDING: Final = 1e-24
"""Fraction of the square of the maximum sample, which is 1: a band with less power has none."""
_LEAST_VALUES: Final = 64
"""In a band: with fewer a kurtosis means nothing."""
_MOST_LEVELS: Final = 12
_OUTPUTS: Final = 8
"""Number of outputs of a filter in one row of a product; even, as every second one of some filters
is turned."""
_AT_ONCE: Final = 2**17
"""Values that are split together: two megabytes."""
_SHARED: Final = 2**18
"""Values from which on threads share their splitting."""
_ROWS: Final = 64
"""In one product of matrices: to share so narrow ones among BLAS's threads only costs."""


@frozen
class KurtogramBand:
    """One band of a kurtogram.

    Attributes
    ----------
    band
        Hz
    level
        log2 of how many bands share half the sampling rate
    kurtosis
        K, 0 for Gaussian noise and for a band without power
    significance
        K over its standard deviation in Gaussian noise
    """

    band: Band
    level: float
    kurtosis: float
    significance: float


@frozen(eq=False)
class KurtogramLevel:
    """All bands of one level, from low to high.

    Attributes
    ----------
    level
        log2 of the number of bands
    bandwidth
        Hz
    kurtosis
        (bands,); 0 for a band without power
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


@frozen(eq=False)
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
            rule = said("must be kurtosis or significance")
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
    require_samples(signal, 256, marked("a kurtogram"))
    possible = min(_MOST_LEVELS, int(log2(len(signal.samples) / (3 * _LEAST_VALUES))))
    depth = (
        min(possible, 8)
        if levels is None
        else checked_count(levels, "levels", least=1, most=max(possible, 1), example="levels = 5")
    )
    # a kurtosis has no scale, and fourth powers may have none that is a number
    scale = float(np.max(np.abs(signal.samples))) or 1.0
    samples = (signal.samples - np.mean(signal.samples)) / scale
    found = [_level(signal.rate, [_Figures.of(samples[np.newaxis])])]
    # of the analytic signal, or noise that wide filters let in from below zero would be squared
    # with its own image, and look impulsive
    whole = analytic_signal(signal)[np.newaxis] / scale
    banks = _bank(2, FILTER_ORDER), _bank(3, 3 * FILTER_ORDER // 2)
    below = _explored(whole, banks, depth)
    found += [_level(signal.rate, figures) for parts in below for figures in parts]
    return Kurtogram(signal.rate, tuple(sorted(found, key=lambda level: level.level)))


@frozen(eq=False)
class _Bank:
    """Filters that split a band in equal parts, as one matrix.

    Each output of a filter is a sum of products, and so are several in a row: together a row of
    samples times a matrix. All filters of all bands are one product of matrices then, which takes
    a fraction of the time of one filter after the other.

    parts: into how many, and by how many to decimate; taps: of a filter; matrix: (samples of a row,
    parts times `_OUTPUTS`).
    """

    parts: int
    taps: int
    matrix: ComplexArray


class _Figures(NamedTuple):
    """Kurtosis of some bands (bands,), of how many values each, and whether those are real."""

    kurtosis: FloatArray
    values: int
    real: bool

    @classmethod
    def of(cls, bands: Bands) -> _Figures:
        real = not np.iscomplexobj(bands)
        return cls(_kurtosis(bands, 3.0 if real else 2.0), bands.shape[1], real)


class _Parts(NamedTuple):
    """Halves and thirds of the bands of a level, some bands after the other."""

    halves: list[_Figures]
    thirds: list[_Figures]


def _bank(parts: int, order: int) -> _Bank:
    """Filters of a number of parts, from the prototype of that order.

    A part of an odd place has come down upside up but half a band off: what lies above half the
    new rate is turned back to where it belongs.
    """
    turns = np.arange(order + 1)
    # `scipy.signal.firwin`, by Hamming's window, takes longer to import than all this
    prototype = np.sinc(4.0 * CUTOFF / parts * (turns - 0.5 * order)) * np.hamming(order + 1)
    prototype /= np.sum(prototype)
    matrix = np.zeros((parts * (_OUTPUTS - 1) + order + 1, parts, _OUTPUTS), dtype=np.complex128)
    for part, output in np.ndindex(parts, _OUTPUTS):
        taps = prototype * np.exp(2j * np.pi * (2 * part + 1) / (4 * parts) * turns)
        turned = -1.0 if part % 2 == 1 and output % 2 == 1 else 1.0
        matrix[parts * output + order - turns, part, output] = turned * taps
    return _Bank(parts, order + 1, matrix.reshape(len(matrix), -1))


def _explored(bands: ComplexArray, banks: tuple[_Bank, _Bank], depth: int) -> list[_Parts]:
    """Return the figures of all that bands are split in, so many levels down.

    One band after the other goes all the way down as soon as they are many values: what one level
    leaves is still in the processor's cache at the next.
    """
    if depth == 0:
        return []
    side: Callable[..., Iterable[Any]] = side_by_side if bands.size >= _SHARED else map
    if len(bands) > 1 and bands.size > _AT_ONCE:
        down = partial(_explored, banks=banks, depth=depth)
        levels = zip(*side(down, list(bands[:, np.newaxis])), strict=True)
        return [_Parts(*map(_in_a_row, zip(*parts, strict=True))) for parts in levels]
    halves, thirds = side(partial(_split, bands), banks)
    parts = _Parts([_Figures.of(halves)], [_Figures.of(thirds)])
    return [parts, *_explored(halves, banks, depth - 1)]


def _in_a_row(lists: Iterable[list[_Figures]]) -> list[_Figures]:
    return list(chain.from_iterable(lists))


def _split(bands: ComplexArray, bank: _Bank) -> ComplexArray:
    """Filter and decimate by the number of parts, without the filters' run-in; from low to high."""
    count, length = bands.shape
    step, beyond = bank.parts * _OUTPUTS, len(bank.matrix) - bank.parts * _OUTPUTS
    run_in = -(-bank.taps // bank.parts)
    outputs = length // bank.parts - run_in
    rows = -(-outputs // _OUTPUTS)
    stacks = -(-rows // _ROWS)
    first = bank.parts * run_in - bank.taps + 1
    used = bands[:, first : first + (rows * step) + beyond]
    samples = np.zeros((count, (stacks * _ROWS + 1) * step), dtype=np.complex128)
    samples[:, : used.shape[1]] = used
    # a row reaches into the one after it: the matrix in two parts saves writing both side by side
    size = (count, stacks, _ROWS, step)
    product = np.matmul(samples[:, :-step].reshape(size), bank.matrix[:step])
    product += np.matmul(samples[:, step:].reshape(size)[..., :beyond], bank.matrix[step:])
    parts = product.reshape(count, stacks * _ROWS, bank.parts, _OUTPUTS).transpose(0, 2, 1, 3)
    return np.asarray(parts.reshape(count * bank.parts, stacks * _ROWS * _OUTPUTS)[:, :outputs])


def _level(rate: float, figures: list[_Figures]) -> KurtogramLevel:
    kurtosis = np.concatenate([some.kurtosis for some in figures])
    # variances of the kurtosis of n Gaussian values: 24/n real, 4/n complex
    variance = (24.0 if figures[0].real else 4.0) / figures[0].values
    return KurtogramLevel(
        level=log2(len(kurtosis)),
        bandwidth=0.5 * rate / len(kurtosis),
        kurtosis=kurtosis,
        deviation=sqrt(variance),
    )


def _kurtosis(bands: Bands, of_noise: float) -> FloatArray:
    """Kurtosis of each band less that of Gaussian noise; 0 for a band without power.

    What rounding leaves in a band is as impulsive as chance has it.
    """
    values = bands.shape[1]
    mean = np.einsum("ij->i", bands)[:, np.newaxis] / values
    power = np.square(bands.real - mean.real)
    if np.iscomplexobj(bands):
        power += np.square(bands.imag - mean.imag)
    there = np.max(power, axis=1) > _ROUNDING
    level = np.where(there, np.einsum("ij->i", power) / values, 1.0)
    squares = np.einsum("ij,ij->i", power, power) / values
    return np.where(there, squares / np.square(level) - of_noise, 0.0)
