"""Lines of a spectrum: how far the taper spreads them, which are alike, which are of the mains."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np
import scipy

from rolamento.numerics import BoolArray, ComplexArray, FloatArray, IntArray

_TAPERED: Final = 0.1
"""Fraction of a block, half at either end: enough that strong tones do not spread far, and little
enough that the lines of noise stay independent of their neighbours."""
_LENGTH: Final = 4096
_OVERSAMPLING: Final = 8
_FINE: Final = 64


def taper(places: FloatArray) -> FloatArray:
    """Tukey's window at places of a block, rising from 0 to 1; as `places`."""
    window = np.ones_like(places)
    half = 0.5 * _TAPERED
    for edge, within in (
        (slice(int(np.searchsorted(places, half))), places),
        (slice(int(np.searchsorted(places, 1.0 - half)), None), 1.0 - places),
    ):
        window[edge] = 0.5 * (1.0 - np.cos(np.pi * np.clip(within[edge] / half, 0.0, 1.0)))
    return window


def power_of(spectrum: ComplexArray) -> FloatArray:
    """Squares of the absolute values of lines; as `spectrum`."""
    return np.asarray(np.square(spectrum.real) + np.square(spectrum.imag))


@cache
def tone_leakage() -> FloatArray:
    """Maximum power, over that of its peak, that a tone leaves so many lines away or farther."""
    return _spread(taper((np.arange(_LENGTH) + 0.5) / _LENGTH))


@cache
def envelope_leakage() -> FloatArray:
    """As `tone_leakage`, of a line in the spectrum of the squared envelope."""
    return _spread(np.square(taper((np.arange(_LENGTH) + 0.5) / _LENGTH)))


def reach(leakage: FloatArray, ratio: FloatArray) -> IntArray:
    """Lines from a peak within which it leaves more than 1 over a ratio of its power."""
    return np.asarray(np.searchsorted(-leakage, -1.0 / np.maximum(ratio, 1.0)))


@cache
def _halves() -> tuple[FloatArray, FloatArray]:
    """Power of a tone's second line over that of its first, and how far it lies from the first."""
    window = taper((np.arange(_LENGTH) + 0.5) / _LENGTH)
    power = np.square(np.abs(scipy.fft.rfft(window, _FINE * _LENGTH)[: _FINE + 1]))
    offsets = np.arange(_FINE // 2 + 1)
    return power[_FINE - offsets] / power[offsets], offsets / _FINE


def places_between(power: FloatArray, lines: IntArray) -> FloatArray:
    """Places of discrete tones between the lines of a tapered block, in lines.

    The ratio of a tone's two highest lines gives its place (Rife and Vincent, Bell System Technical
    Journal 49 (1970), 197-228), here with the taper's own ratio.

    Parameters
    ----------
    power
        (lines,), of a spectrum.
    lines
        (tones,), each the highest line of a tone, neither the first nor the last of the spectrum.
    """
    below, above = power[lines - 1], power[lines + 1]
    ratios, offsets = _halves()
    second = np.maximum(below, above) / np.maximum(power[lines], np.finfo(np.float64).tiny)
    offset = np.interp(second, ratios, offsets)
    return np.asarray(lines + np.where(above > below, offset, -offset), dtype=np.float64)


def leaked(power: FloatArray, line: int, leakage: FloatArray, apart: int) -> float:
    """Return the maximum power that lines so far away or farther leave at a line.

    leakage: as `tone_leakage` or `envelope_leakage` gives it.
    """
    about = np.arange(max(1, line - len(leakage) + 1), min(len(power), line + len(leakage)))
    away = np.abs(about - line)
    return float(np.max((power[about] * leakage[away])[away >= apart], initial=0.0))


def _spread(window: FloatArray) -> FloatArray:
    power = np.square(np.abs(scipy.fft.rfft(window, _OVERSAMPLING * _LENGTH)))
    # a peak may lie half a line off its line
    farther = np.maximum.accumulate(power[::-1])[::-1] / power[0]
    half = _OVERSAMPLING // 2
    lines = np.maximum(np.arange(_LENGTH // 4) * _OVERSAMPLING - half, 0)
    return np.asarray(farther[lines])


# --- neighbouring lines that are alike -----------------------------------------------------------


def runs(lines: BoolArray) -> tuple[IntArray, IntArray]:
    """First places of runs of true values, and the places after their last."""
    edges = np.flatnonzero(np.diff(lines, prepend=False, append=False))
    return edges[::2], edges[1::2]


# --- lines of the electric supply ----------------------------------------------------------------


MAINS: Final = (50.0, 60.0)
"""Hz."""
_OFF: Final = 0.001
"""Part by which a grid's frequency may be off."""
_LINES: Final = 1.5


def is_near_mains(hertz: FloatArray, resolution: float, mains: float) -> BoolArray:
    """Which frequencies are multiples of the mains', as far as lines so far apart can show; Hz."""
    number = np.maximum(np.rint(hertz / mains), 1.0)
    return np.abs(hertz - number * mains) <= np.maximum(_LINES * resolution, _OFF * hertz)
