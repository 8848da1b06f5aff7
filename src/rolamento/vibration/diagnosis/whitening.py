"""A block's spectrum, tapered, without discrete tones, and whitened.

Tones are discrete where what makes them turns steadily: over time if the shaft does, else over its
angle. In the latter case the block is interpolated at even steps of the angle to find them, and
what they add up to is taken back to time and subtracted.
"""

from __future__ import annotations

from math import ceil, log, sqrt
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.blocks import Block
from rolamento.vibration.diagnosis.leakage import taper
from rolamento.vibration.diagnosis.tones import Comb, discrete_lines, local_level
from rolamento.vibration.order_tracking import interpolated

__all__ = ["even_places", "whitened"]

ComplexArray = NDArray[np.complex128]

_NOTHING: Final = 1e-20
"""Of the greatest level: rounding."""
_BARE: Final = 1e-9
"""Of the power: what noise has less of beside tones may be the rounding of 16 bits."""
_LARGEST: Final = log(50.0)
"""Power of a line over the noise's, which one of fifty lines of noise exceeds."""
_MEDIAN_OF_NOISE: Final = 0.6745
"""Median size of Gaussian noise over its deviation."""
_CHANCE: Final = 0.01
"""That noise alone has a sample which is limited."""
_SHOCK: Final = 2.0
"""Times that: what gears, which are not noise, do not reach either."""


class Whitened(NamedTuple):
    """Spectrum of a block over the level of its noise; whether it kept a comb of discrete lines."""

    spectrum: ComplexArray
    has_comb: bool


def whitened(block: Block, *, remove_tones: bool, combs: list[Comb]) -> Whitened | None:
    """Spectrum of the tapered block over the level of its noise, and 0 where there were tones.

    No line is larger than one of noise hardly ever is, so that what is left of tones weighs little;
    and then no sample, so that a few great shocks do not weigh more than all the rest: a few
    instants always have some period in common. None if there is nothing beside the tones: what is
    left of a computed tone is rounding, and has any line.

    combs: of faults, whose discrete lines stay and keep their size over the noise.
    """
    count = len(block.samples)
    samples = _limited(block.samples - np.median(block.samples), _SHOCK)
    samples -= np.mean(samples)
    resolution = block.rate / count
    if block.places is None:
        spectrum = np.asarray(fft.rfft(samples * taper(even_places(count))))
    else:
        tapered = samples * taper(block.places)
        if remove_tones:
            tapered -= _turning_tones(samples, block.places, resolution, combs)
        spectrum = np.asarray(fft.rfft(tapered))
    power = np.square(np.abs(spectrum))
    level = local_level(power, resolution)
    if float(np.median(level)) * len(level) < _BARE * float(np.sum(power)):
        return None
    teeth = None
    if remove_tones and block.places is None:
        tones, teeth = discrete_lines(spectrum, level, combs)
    white = _even(spectrum, resolution, teeth)
    if teeth is not None:
        white[tones] = 0.0
    even = np.asarray(fft.irfft(white, count))
    limited = _limited(even, 1.0)
    if limited is not even:
        white = _even(np.asarray(fft.rfft(limited)), resolution, teeth)
    return Whitened(white, teeth is not None and bool(np.any(teeth)))


def even_places(count: int) -> FloatArray:
    """Middles of so many equal parts of a block, from 0 to 1."""
    return (np.arange(count, dtype=np.float64) + 0.5) / count


def _even(spectrum: ComplexArray, resolution: float, teeth: BoolArray | None) -> ComplexArray:
    """The lines over the level of the noise, limited but for the teeth of combs."""
    power = np.square(np.abs(spectrum))
    level = local_level(power, resolution)
    # of a line without power the phase is rounding
    level = np.maximum(level, _NOTHING * float(np.max(level)))
    white = spectrum / np.sqrt(np.maximum(level, power / _LARGEST))
    if teeth is not None:
        white[teeth] = spectrum[teeth] / np.sqrt(level[teeth])
    white[0] = 0.0
    return np.asarray(white)


def _limited(samples: FloatArray, margin: float) -> FloatArray:
    """Samples no larger than a margin times what noise of their level hardly ever reaches."""
    deviation = float(np.median(np.abs(samples))) / _MEDIAN_OF_NOISE
    largest = margin * deviation * sqrt(2.0 * log(len(samples) / _CHANCE))
    if max(float(np.max(samples)), -float(np.min(samples))) <= largest:
        return samples
    return np.clip(samples, -largest, largest)


def _turning_tones(
    samples: FloatArray, places: FloatArray, resolution: float, combs: list[Comb]
) -> FloatArray:
    """The sum of all that turns with the shaft, tapered; (samples,)."""
    count = len(samples)
    slowest = float(np.min(np.diff(places)))
    steps = fft.next_fast_len(min(ceil(1.0 / slowest), 4 * count), real=True)
    even = even_places(steps)
    at = np.interp(even, places, np.arange(count, dtype=np.float64))
    spectrum = np.asarray(fft.rfft(interpolated(samples, at) * taper(even)))
    # over time or over angle, lines are one over the block apart
    level = local_level(np.square(np.abs(spectrum)), resolution)
    spectrum[~discrete_lines(spectrum, level, combs).tones] = 0.0
    return interpolated(np.asarray(fft.irfft(spectrum, steps)), places * steps - 0.5)
