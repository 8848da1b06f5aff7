"""The spectrum of a band's squared envelope over orders of the shaft, and what is regular in it.

A machine in good order may modulate its noise too: once per revolution, with what else turns, and
slowly as its load wanders. Noise that is modulated so repeats its own pattern at that spacing, and
lines of its envelope are no longer independent of each other. The regular part is therefore
divided out of the squared envelope: what is left is noise of one level, and in it the blows of a
fault. Of the lines S about a multiple n of what turns, and W of the taper's square about zero,

    m_n(θ) = Σ S_k e^(jkθ) / Σ W_k e^(jkθ),   over as many lines on either side as the line rises
                                              above the noise

is the modulation without what the taper makes of it; n = 0 is the slow part.

Those lines carry noise too, and the division takes it to all places that the modulation connects:
within as many lines of any other multiple, lines then depend on each other and are left out of the
search (see `masks`).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis.leakage import envelope_leakage, reach, taper
from rolamento.vibration.diagnosis.masks import Place
from rolamento.vibration.diagnosis.whitening import even_places
from rolamento.vibration.order_tracking import interpolated

__all__ = ["ModulationPowers", "fastest_line", "limited", "modulation_powers", "over_angle"]

ComplexArray = NDArray[np.complex128]

_MARGIN: Final = 1.3
"""Lines that are kept before a product with the regular part, over those that are wanted."""
_STEPS: Final = 4
"""Steps of an envelope, over the lines that are wanted of it."""
_LEAST: Final = 0.1
"""Of the mean: lower the regular part is not taken, or a few samples would be blown up."""
_NEIGHBOURS: Final = 50
_CHANCE: Final = 0.01
"""That noise has any line which is taken for regular."""
_SPREAD_TO: Final = 0.3
"""Of the noise: down to there the lines about a regular one are taken with it."""


class ModulationPowers(NamedTuple):
    """Powers of the lines of a squared envelope, and what was divided out of it.

    plain, even: (lines,), as it is and without its regular part, of sums over the steps; depth:
    (lines,), squares of the modulation depth as it is: of e² = mean (1 + d cos(nθ + φ)) that is d²,
    and a train of short blows alone has d = 2 at each multiple; spreads: (1 + regular places,),
    lines on either side of 0 and of each place that were taken for regular, -1 for none.
    """

    plain: FloatArray
    even: FloatArray
    depth: FloatArray
    spreads: NDArray[np.int64]


def limited(squared: FloatArray) -> FloatArray:
    """A squared envelope, nowhere above what noise of its level would hardly reach.

    A few great shocks would otherwise weigh more than all the rest, and a few instants always have
    some period in common.
    """
    level = float(np.median(squared)) / log(2.0)
    return np.minimum(squared, level * log(len(squared) / _CHANCE)) if level > 0.0 else squared


def fastest_line(places: FloatArray | None, lines: int) -> int:
    """Highest line over time that lines over the angle are made of, where the shaft is fastest."""
    if places is None:
        return int(_MARGIN * lines)
    return int(_MARGIN * lines * float(np.max(np.diff(places))) * len(places))


def over_angle(squared: FloatArray, places: FloatArray | None, lines: int) -> FloatArray:
    """A squared envelope, without what is too fast to matter, at even steps of the shaft's angle.

    Parameters
    ----------
    squared
        Evenly over the time of a block.
    places
        (samples of the block,), share of the block's angle at each; None for a steady shaft.
    lines
        Of its spectrum that are wanted.
    """
    size = len(squared)
    steps = fft.next_fast_len(_STEPS * lines, real=True)
    spectrum = np.asarray(fft.rfft(squared))
    highest = min(fastest_line(places, lines), size // 2)
    if places is None:
        return _at_steps(spectrum[: highest + 1], size, steps)
    samples = len(places)
    narrow = fft.next_fast_len(max(6 * highest, 16), real=True)
    smooth = _at_steps(spectrum[: highest + 1], size, narrow)
    at = np.interp(even_places(steps), places, np.arange(samples, dtype=np.float64))
    return interpolated(smooth, at * (narrow / samples))


def modulation_powers(
    envelope: FloatArray, slow: int, regular: Sequence[Place], lines: int, most: int
) -> ModulationPowers:
    """Powers of the lines of a squared envelope: as it is, and with its regular part divided out.

    Parameters
    ----------
    envelope
        Over even steps of the shaft's angle.
    slow
        Lines up to which a modulation may be slow.
    regular
        Where lines of what turns are.
    lines
        How many are wanted.
    most
        Lines on either side that are taken with a regular one at most.
    """
    steps = len(envelope)
    window = np.square(taper(even_places(steps)))
    spectrum, of_window = np.asarray(fft.rfft(envelope)), np.asarray(fft.rfft(window))
    mean = float(spectrum[0].real / of_window[0].real)
    plain = np.square(np.abs(spectrum - mean * of_window))[:lines]
    spreads = np.full(1 + len(regular), -1, dtype=np.int64)
    if mean <= 0.0:
        return ModulationPowers(plain, plain.copy(), np.zeros(lines), spreads)
    spreads[0] = min(slow, _slow_spread(plain, slow))
    level = _part(spectrum, 0, int(spreads[0]), steps) / _base(of_window, int(spreads[0]), steps)
    for number, place in enumerate(regular, 1):
        spread = _spread(plain, place, most)
        if spread is not None:
            part = _part(spectrum, round(place.line), spread, steps)
            level += part / _base(of_window, spread, steps)
            spreads[number] = spread
    even = envelope / np.maximum(level / mean, _LEAST)
    even -= window * (np.sum(even) / np.sum(window))
    power = np.square(np.abs(fft.rfft(even)))[:lines]
    return ModulationPowers(plain, power, plain * (2.0 / spectrum[0].real) ** 2, spreads)


def _at_steps(spectrum: ComplexArray, size: int, steps: int) -> FloatArray:
    """The first lines of a spectrum of so many samples, at another number of steps."""
    count = min(len(spectrum), steps // 2 + 1)
    return np.asarray(fft.irfft(spectrum[:count], steps)) * (steps / size)


def _spread(power: FloatArray, place: Place, most: int) -> int | None:
    """Lines on either side that a regular line rises above the noise; None if it does not."""
    first = max(1, ceil(place.line - place.within))
    last = min(len(power), int(place.line + place.within) + 1)
    about = power[max(1, first - _NEIGHBOURS) : last + _NEIGHBOURS]
    if first >= last or len(about) < _NEIGHBOURS:
        return None
    noise = float(np.median(about)) / log(2.0)
    ratio = float(np.max(power[first:last])) / noise if noise > 0.0 else 0.0
    if ratio < log(len(power) / _CHANCE):
        return None
    return min(reach(envelope_leakage(), ratio / _SPREAD_TO), most) + int(place.within)


def _slow_spread(power: FloatArray, slow: int) -> int:
    """Lines from zero up to which the modulation rises above the noise; 0 if nowhere."""
    about = power[slow + 1 : slow + 1 + 2 * _NEIGHBOURS]
    noise = float(np.median(about)) / log(2.0) if len(about) else 0.0
    if noise <= 0.0:
        return slow
    ratio = power[1 : slow + 1] / noise
    rises = np.flatnonzero(ratio >= log(len(power) / _CHANCE))
    if len(rises) == 0:
        return 0
    return int(rises[-1]) + 1 + reach(envelope_leakage(), float(ratio[rises[-1]]) / _SPREAD_TO)


def _part(spectrum: ComplexArray, centre: int, spread: int, steps: int) -> FloatArray:
    """What the lines about a place make; without its mirror image below zero frequency."""
    kept = np.zeros_like(spectrum)
    lines = slice(max(0, centre - spread), centre + spread + 1)
    kept[lines] = spectrum[lines]
    return np.asarray(fft.irfft(kept, steps))


def _base(of_window: ComplexArray, spread: int, steps: int) -> FloatArray:
    """What the same number of lines make of the taper; kept from zero at the block's ends."""
    mean = float(of_window[0].real) / steps
    return np.maximum(_part(of_window, 0, spread, steps), _LEAST * mean)
