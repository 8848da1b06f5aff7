"""Cyclic spectral coherence: at which carriers a signal is modulated, and how fast.

The fast estimator of Antoni, Xin and Hamzaoui, Mechanical Systems and Signal Processing 92 (2017),
248-277. With X(i, f_k) the transform of the i-th of K windows w (length N_w, each counting time
from its own middle), each pair of lines p apart gives one scan over the modulation frequency α

    S_p(α, f_k) = DFT_i{ X(i, f_k) X(i, f_k-p)* } / (K f_s ‖w‖²),

good about α = p f_s/N_w, where the window's correlation with itself,

    R_w(α) = Σ w² e^(2πjnα/f_s),

is large; the scans add up to the cyclic spectrum

    S(α, f) = R_w(0) Σ_p S_p(α, f) / Σ_p R_w(α - p f_s/N_w).

Over the powers of both carriers it is the coherence γ, and the mean of |γ|² over the carriers of
a band is the enhanced envelope spectrum: the share of the band's power that is modulated at α.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy import fft
from scipy import signal as scipy_signal

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_band, checked_count, checked_number
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import Spectrum, axis_of, bins_of_band

__all__ = ["CyclicCoherence", "cyclic_coherence", "enhanced_envelope_spectrum"]

ComplexArray = NDArray[np.complex128]

_MOST_VALUES: Final = 2**26
"""Of the map, carriers times modulations: half a gigabyte."""
_AT_ONCE: Final = 2**16
"""Values that are transformed together: a megabyte, which stays in the processor's cache."""
_STEPS_PER_WINDOW: Final = 8
_REACHED: Final = 0.1
"""Of R_w(0): with less, a scan says more of leakage than of the signal."""


@dataclass(frozen=True, slots=True, eq=False)
class CyclicCoherence:
    """Coherence between carriers a modulation apart.

    Attributes
    ----------
    modulation
        (modulations,), α from 0; Hz
    carrier
        (carriers,), f; Hz
    coherence
        (carriers, modulations), |γ|, from 0 to about 1; 1 at α = 0, 0 where nothing can be told
    """

    modulation: FloatArray
    carrier: FloatArray
    coherence: FloatArray


def cyclic_coherence(signal: Signal, highest: float, window: int = 256) -> CyclicCoherence:
    """Cyclic spectral coherence of a signal.

    Parameters
    ----------
    signal
        At least 32 windows long.
    highest
        Modulation frequency up to which to look; Hz. The map has as many modulations as one over
        the record's duration fits into it.
    window
        Samples of the short-time transform, even; the carriers are half as many, and the rate over
        this apart.

    Raises
    ------
    InputError
        If an argument is out of range, the signal is too short, or the map would be too large.
    """
    samples, rate = signal.samples, signal.rate
    checked_count(window, "window", least=16, most=65536, example="window = 256")
    window += window % 2
    checked_number(highest, "highest", above=0.0, most=0.25 * rate, example="highest = 500.0")
    step = max(1, min(window // _STEPS_PER_WINDOW, int(rate / (4.0 * highest))))
    blocks = (len(samples) - window) // step + 1
    if len(samples) < 32 * window:
        rule = f"must be at least {32 * window}, 32 windows"
        raise InputError(rule, field="number of samples", value=len(samples))
    modulations = int(highest * fft.next_fast_len(blocks) * step / rate) + 1
    carriers = window // 2 + 1
    if modulations * carriers > _MOST_VALUES or blocks * carriers > 4 * _MOST_VALUES:
        raise InputError(
            f"gives a map of {carriers} × {modulations} values; {_MOST_VALUES} are possible; "
            "shorten the record or the window",
            field="highest",
            value=highest,
        )
    taper = scipy_signal.get_window("hann", window)
    transform = _short_time(samples - np.mean(samples), taper, step, blocks)
    size = fft.next_fast_len(blocks)
    resolution = rate / (size * step)
    modulation = axis_of(modulations, resolution)
    cyclic = _cyclic_spectrum(transform, taper, modulation, rate, size)
    power = np.mean(np.square(np.abs(transform)), axis=1) / (rate * float(np.sum(taper**2)))
    carrier = axis_of(carriers, rate / window)
    return CyclicCoherence(modulation, carrier, _coherence(cyclic, power, carrier, modulation))


def enhanced_envelope_spectrum(coherence: CyclicCoherence, band: Band | None = None) -> Spectrum:
    """Mean of |γ|² over the carriers of a band, over the modulation frequency.

    Parameters
    ----------
    coherence
        From `cyclic_coherence`.
    band
        Of carriers; Hz. By default all.

    Raises
    ------
    InputError
        If the band holds no carrier.
    """
    carrier = coherence.carrier
    edges = (0.0, float(carrier[-1])) if band is None else band
    inside = bins_of_band(carrier, checked_band(edges, 2.0 * float(carrier[-1])))
    if not np.any(inside):
        rule = f"holds no carrier, which are {carrier[1]:.4g} Hz apart"
        raise InputError(rule, field="band", value=str(band))
    return Spectrum(
        axis=coherence.modulation,
        values=np.mean(np.square(coherence.coherence[inside]), axis=0),
        axis_unit="Hz",
        unit="1",
        resolution=float(coherence.modulation[1]),
    )


def _short_time(samples: FloatArray, taper: FloatArray, step: int, blocks: int) -> ComplexArray:
    """Transforms of consecutive windows, each counting time from its middle; (lines, blocks)."""
    window = len(taper)
    views = np.lib.stride_tricks.sliding_window_view(samples, window)[::step][:blocks]
    transform = np.ascontiguousarray(np.asarray(fft.rfft(views * taper, axis=1)).T)
    transform[1::2] *= -1.0
    return transform


def _cyclic_spectrum(
    transform: ComplexArray, taper: FloatArray, modulation: FloatArray, rate: float, size: int
) -> ComplexArray:
    """S(α, f) of the module's head; (carriers, modulations).

    The lowest carriers have fewer lines below them to pair with, and so fewer scans; where those
    do not reach α, the result is 0.
    """
    window, lines = len(taper), len(modulation)
    carriers, blocks = transform.shape
    pairs = min(int(np.ceil(modulation[-1] * window / rate)) + 1, carriers - 1)
    total = np.zeros((carriers, lines), dtype=np.complex128)
    product = np.zeros((max(1, _AT_ONCE // size), size), dtype=np.complex128)
    for first in range(0, carriers, len(product)):
        last = min(first + len(product), carriers)
        for apart in range(min(pairs, last - 1) + 1):
            upper = slice(max(first, apart), last)
            lower = slice(upper.start - apart, last - apart)
            some = product[: last - upper.start]
            np.multiply(transform[upper], np.conj(transform[lower]), out=some[:, :blocks])
            total[upper] += fft.fft(some, axis=1)[:, :lines]
    reach = np.cumsum(_window_correlations(taper, modulation / rate, pairs), axis=0)
    weights = reach[np.minimum(np.arange(carriers), pairs)]
    reached = weights > _REACHED * float(np.sum(np.square(taper)))
    np.divide(total, weights * (blocks * rate), out=total, where=reached)
    total[~reached] = 0.0
    return total


def _window_correlations(taper: FloatArray, alpha: FloatArray, pairs: int) -> FloatArray:
    """R_w(α - p/N_w) of a window that is even about its middle, for all p; (pairs + 1, alphas).

    R_w(α) = Σ w² cos(2παn) with n from the middle; α in cycles per sample. The cosine of a
    difference takes two tables for all p.
    """
    middle = len(taper) // 2
    places = np.arange(middle + 1)
    square = np.square(taper[middle::-1])
    square[1:middle] *= 2.0
    table = 2.0 * np.pi * alpha[:, np.newaxis] * places
    turned = 2.0 * np.pi / len(taper) * np.outer(places, np.arange(pairs + 1))
    weight = square[:, np.newaxis]
    return np.asarray(
        np.cos(table) @ (weight * np.cos(turned)) + np.sin(table) @ (weight * np.sin(turned))
    ).T


def _coherence(
    cyclic: ComplexArray, power: FloatArray, carrier: FloatArray, modulation: FloatArray
) -> FloatArray:
    """|S(α, f)| over √(S(f) S(f - α)); 0 where the lower carrier would be below zero."""
    found = np.zeros(cyclic.shape)
    found[:, 0] = 1.0
    for line, frequency in enumerate(carrier):
        lower = frequency - modulation
        both = power[line] * np.interp(lower, carrier, power)
        good = (lower >= 0.0) & (both > 0.0) & (modulation > 0.0)
        found[line, good] = np.abs(cyclic[line, good]) / np.sqrt(both[good])
    return found
