"""Cyclic spectral coherence: at which carriers a signal is modulated, and how fast.

After the fast estimator of Antoni, Xin and Hamzaoui, Mechanical Systems and Signal Processing 92
(2017), 248-277. With X(i, f_k) the transform of the i-th of K windows w (length N_w, each counting
time from its own middle), each pair of lines p apart gives one scan over the modulation frequency α

    S_p(α, f_k) = DFT_i{ X(i, f_k) X(i, f_k-p)* } / (K f_s ‖w‖²),

which of a modulation at α is r_p times the cyclic spectrum: the window's correlation with itself,

    r_p = R_w(α - p f_s/N_w)/R_w(0),    R_w(α) = Σ w² e^(2πjnα/f_s),

large where α is near p f_s/N_w. The published estimator adds the scans up, Σ S_p / Σ r_p. A scan
far from α counts in full there, though all that it has at α is what leaks: where there are strong
tones that is much, and the coherence comes out at ten or a thousand. Here each counts by its r_p,

    S(α, f) = Σ_p r_p S_p(α, f) / Σ_p r_p²,

the least-squares fit; in noise it scatters a twentieth more. It is the correlation of X with
Z = Σ r_p X(i, f_k-p), which stands for the transform at f - α, between lines. The power of that
carrier is taken from Z as well, over what Z has of white noise of power 1,

    S(f - α) = Σ_pq r_p r_q ⟨X(i, f_k-p) X(i, f_k-q)*⟩ / (f_s ‖w‖² Σ_pq r_p r_q ρ_pq),

ρ_pq = R_w((p - q) f_s/N_w)/R_w(0), so that the coherence γ = S(α, f)/√(S(f) S(f - α)) stays below
1.09 whatever the signal, by Schwarz's inequality. The mean of |γ|² over the carriers of a band is
the enhanced envelope spectrum: the share of the band's power that is modulated at α.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import scipy

from rolamento.errors import InputError
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.records import frozen
from rolamento.vibration._checks import (
    Band,
    checked_band,
    checked_count,
    checked_number,
    require_signal,
)
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import Spectrum, axis_of, bins_of_band
from rolamento.words import marked, said

_MOST_VALUES: Final = 2**26
"""Maximum number of values of the map, carriers times modulations: half a gigabyte."""
_AT_ONCE: Final = 2**16
"""Values that are transformed together: a megabyte, which stays in the processor's cache."""
_STEPS_PER_WINDOW: Final = 8
_LOBE: Final = 3
"""Lines on either side over which R_w of Hann's window reaches; it is zero there."""
_ROUNDING: Final = 1e-24
"""Fraction of the square of the maximum sample: a carrier with less power has none."""


@frozen(eq=False)
class CyclicCoherence:
    """Coherence between carriers a modulation apart.

    Attributes
    ----------
    modulation
        (modulations,), α from 0; Hz
    carrier
        (carriers,), f; Hz
    coherence
        (carriers, modulations), |γ|, from 0 to about 1 and below 1.09; 1 at α = 0, 0 where
        nothing can be said
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
    require_signal(signal)
    samples, rate = signal.samples, signal.rate
    checked_count(window, "window", least=16, most=65536, example="window = 256")
    window += window % 2
    checked_number(highest, "highest", above=0.0, most=0.25 * rate, example="highest = 500.0")
    step = max(1, min(window // _STEPS_PER_WINDOW, int(rate / (4.0 * highest))))
    blocks = (len(samples) - window) // step + 1
    if len(samples) < 32 * window:
        rule = said("must be at least {window}, 32 windows", window=32 * window)
        raise InputError(rule, field=marked("number of samples"), value=len(samples))
    modulations = int(highest * scipy.fft.next_fast_len(blocks) * step / rate) + 1
    carriers = window // 2 + 1
    if modulations * carriers > _MOST_VALUES or blocks * carriers > 4 * _MOST_VALUES:
        raise InputError(
            said(
                "gives a map of {carriers} × {modulations} values; at most {most} are "
                "allowed; shorten the record or the window",
                carriers=carriers,
                modulations=modulations,
                most=_MOST_VALUES,
            ),
            field="highest",
            value=highest,
        )
    from scipy.signal import get_window  # slow to import

    taper = get_window("hann", window)
    centred = samples - np.mean(samples)
    transform = _short_time(centred, taper, step, blocks)
    size = scipy.fft.next_fast_len(blocks)
    modulation = axis_of(modulations, rate / (size * step))
    least = _ROUNDING * float(np.max(np.abs(samples))) ** 2 * float(np.sum(np.square(taper)))
    return CyclicCoherence(
        modulation,
        axis_of(carriers, rate / window),
        _coherence(transform, taper, modulation * (window / rate), size, least),
    )


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
        rule = said("contains no carrier; carriers are {carrier:.4g} Hz apart", carrier=carrier[1])
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
    transform = np.ascontiguousarray(np.asarray(scipy.fft.rfft(views * taper, axis=1)).T)
    transform[1::2] *= -1.0
    return transform


def _coherence(
    transform: ComplexArray, taper: FloatArray, places: FloatArray, size: int, least: float
) -> FloatArray:
    """|γ| of the module's head; (carriers, modulations).

    places: of the modulations, counted in lines of the transform (modulations,); size: of the
    transform over the blocks; least: power of a line below which it is rounding.
    """
    reach = _reach(taper, places, min(int(np.ceil(places[-1])) + 1, len(transform) - 1))
    cross = _correlated(transform, reach, size)
    found = _power_below(transform, taper, reach, places)
    squares = np.cumsum(np.square(reach), axis=0)
    power = np.mean(np.square(np.abs(transform)), axis=1)
    for line, own in enumerate(power.tolist()):
        below = found[line]
        good = (places <= line) & (places > 0.0) & (below > least) & (own > least)
        scale = squares[min(line, len(squares) - 1)] * np.sqrt(own * np.where(good, below, 1.0))
        found[line] = np.where(good, np.abs(cross[line]) / np.where(good, scale, 1.0), 0.0)
    found[:, 0] = 1.0
    return found


def _reach(taper: FloatArray, places: FloatArray, pairs: int) -> FloatArray:
    """r_p of the module's head, 0 beyond the main lobe; (pairs + 1, modulations)."""
    found = _window_correlations(taper, places / len(taper), pairs) / float(np.sum(taper**2))
    away = np.abs(places - np.arange(pairs + 1)[:, np.newaxis])
    found[away >= _LOBE] = 0.0
    return found


def _correlated(transform: ComplexArray, reach: FloatArray, size: int) -> ComplexArray:
    """Σ r_p ⟨X(f_k) X(f_k-p)*⟩ at every modulation; (carriers, modulations).

    The lowest carriers have fewer lines below them to pair with, and so fewer scans.
    """
    lines = reach.shape[1]
    carriers, blocks = transform.shape
    total = np.zeros((carriers, lines), dtype=np.complex128)
    product = np.zeros((max(1, _AT_ONCE // size), size), dtype=np.complex128)
    held = [np.flatnonzero(row) for row in reach]
    near = [slice(found[0], found[-1] + 1) if len(found) else slice(0, 0) for found in held]
    for first in range(0, carriers, len(product)):
        last = min(first + len(product), carriers)
        for apart in range(min(len(reach), last)):
            upper = slice(max(first, apart), last)
            lower = slice(upper.start - apart, last - apart)
            some = product[: last - upper.start]
            np.multiply(transform[upper], np.conj(transform[lower]), out=some[:, :blocks])
            scan = scipy.fft.fft(some, axis=1)[:, near[apart]]
            total[upper, near[apart]] += reach[apart, near[apart]] / blocks * scan
    return total


def _power_below(
    transform: ComplexArray, taper: FloatArray, reach: FloatArray, places: FloatArray
) -> FloatArray:
    """Power of the carriers that lie a modulation lower, from Z; (carriers, modulations).

    In the units of ⟨|X|²⟩. The lines that Z is made of are the same for all modulations between
    two lines of the transform, and their powers and products one matrix.
    """
    carriers, blocks = transform.shape
    parts = transform.view(np.float64)  # real and imaginary: products of them add to the real part
    widest = min(2 * _LOBE, carriers)
    shared = [
        np.einsum("ij,ij->i", parts[apart:], parts[: carriers - apart]) / blocks
        for apart in range(widest)
    ]
    of_white = _reach(taper, np.zeros(1), widest)[:, 0]
    found = np.zeros((carriers, reach.shape[1]))
    for cell in range(int(places[-1]) + 1):
        inside = slice(*np.searchsorted(places, (cell, cell + 1)).tolist())
        near = range(max(0, cell + 1 - _LOBE), min(cell + _LOBE, len(reach) - 1) + 1)
        both = [(upper, lower) for upper in near for lower in near if upper <= lower]
        measured, white = np.zeros((2, carriers, len(both)))
        for column, (upper, lower) in enumerate(both):
            times = 1.0 if upper == lower else 2.0
            measured[lower:, column] = times * shared[lower - upper][: carriers - lower]
            white[lower:, column] = times * of_white[lower - upper]
        weights = np.stack([reach[upper, inside] * reach[lower, inside] for upper, lower in both])
        expected = white @ weights
        np.divide(measured @ weights, expected, out=found[:, inside], where=expected > 0.0)
    return found


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
