"""How fast the shaft turned by its own lines: a speed from a name plate or a file may be off.

A shaft that turns leaves lines at multiples of its frequency: unbalance, misalignment, looseness.
Of the spectrum's power over the noise about each line, R, the first ten multiples give

    L(f) = Σ min(ℓₙ, ℓ₍₅₎),   ℓₙ = max(ln(R(n f)/ln(100)), 0),   n = 1 … 10,

where ℓ₍₅₎ is the fifth largest of the ten: what counts are lines that one of a hundred lines of
noise reaches, and half of the multiples have to be there. A comb of impacts whose frequency is near
three times the shaft's has three of the ten, and counts for nothing; one near twice has five, and
none of them odd. L is the sum of that of the
samples and of that of the squared envelope of all the band. The given speed needs less: a third
multiple, ℓ₍₃₎.

Ten of fifteen usual deep-groove bearings have an inner race near five times the shaft or an outer
race near three times: damage makes a comb of a speed at which nothing turns. So a comb of another
speed needs its own first multiple, lines that would be a part's at the given speed do not count for
it, and it gives way to the highest first multiple of the vibration within the tolerance, where that
stands clear of the noise and of the comb's own. The speed is then that of the shaft's lines as they
lie between those of the spectrum (`lines.places_between`), from the first multiple on up.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, log
from typing import Final

import numpy as np
import scipy

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.vibration.diagnosis.band_spectra import limit
from rolamento.vibration.diagnosis.blocks import Block
from rolamento.vibration.diagnosis.lines import (
    MAINS,
    is_near_mains,
    leaked,
    places_between,
    power_of,
    tone_leakage,
)
from rolamento.vibration.diagnosis.whitening import Whitening, local_level

LOOKED_AT: Final = 0.1
"""Part by which the speed is looked for on either side of the given one."""
_MULTIPLES: Final = 10
_RARE: Final = log(100.0)
"""Power over that of the noise that one of a hundred lines of noise reaches."""
_HALF: Final = 5
"""None of the multiples counts for more than the fifth of them."""
_FEW: Final = 3
"""Or than the third, at the speed that was given."""
_ODD: Final = 2
"""Odd multiples that have to be there: a comb of twice the frequency has five of ten, all even."""
_STEPS: Final = 4
"""In which a line at the highest multiple is divided."""
_CLEAR: Final = 3.0
"""L from which on a comb is clear. In noise it takes five of ten lines of a chance of 1 % each to
be above 0 at all: some 1e-4, all speeds that are tried counted."""
_MARGIN: Final = 1.2
"""Ratio of L over that of any other speed."""
_FAR_MARGIN: Final = 2.0
"""The same ratio over that of all speeds within what was allowed, where the comb is beyond them."""
_APART: Final = 0.006
"""Part from which on a speed is another one."""
_AGREES: Final = 0.6
"""Fraction of the clearest comb: from there on the lines do not speak against the given speed."""
_FEW_CLEAR: Final = 6.0
"""L of three multiples from which on they speak for the given speed."""
_FIRST_CLEAR: Final = 10.0**1.5
"""Power of a first multiple over the noise, 15 dB, from which on it is the shaft's: in noise a line
has that once in e^31 times."""
_FIRST_ABOVE: Final = 10.0**0.4
"""Over that of another comb's first multiple, 4 dB, from which on it stays the shaft's. Of 134
recordings it decides 2, both of severe damage; the first multiples of the others that have a comb
elsewhere lie 10 to 39 dB below that comb's."""
_PLACE_ERROR: Final = 0.25
"""Lines by which the place of a clear one between those of the spectrum may be off."""
_TONE: Final = 3
"""Lines from which on another is not of the same tone."""
_FARTHEST: Final = 1.5
"""Lines within which the next multiple has to be known, or it is not looked for."""


@frozen
class ShaftLines:
    """What the shaft's own lines say of its speed.

    Attributes
    ----------
    factor
        of the speed over the given one; 1 unless the lines give another
    clearness
        L at that speed
    confirmed
        whether the lines give the speed, or agree with the given one
    """

    factor: float
    clearness: float
    confirmed: bool

    @property
    def is_another(self) -> bool:
        """Whether the speed is another one than was given."""
        return abs(self.factor - 1.0) > _APART


def shaft_lines(
    whitening: Whitening, tolerance: float, parts: Sequence[tuple[float, float, float]] = ()
) -> ShaftLines:
    """Compare the given speed of a block with what the shaft's own lines say.

    Parameters
    ----------
    whitening
        Of the block, at a steady speed.
    tolerance
        Part by which the speed may be off; 0 if it is certain. A clear comb farther off, up to
        `LOOKED_AT`, counts where there is none within.
    parts
        Lowest and highest order of each part at the given speed, and the spacing of its sidebands:
        lines there speak for no other speed.
    """
    block = whitening.block
    if tolerance == 0.0 or block.places is not None:
        return ShaftLines(1.0, 0.0, True)
    if block.turns < _MULTIPLES or not np.any(np.diff(block.samples)):
        return ShaftLines(1.0, 0.0, False)
    factors = _factors(block.turns)
    off = np.abs(factors - 1.0)
    ignored = _of_parts(factors, parts) | _on_mains(factors, block) & (off > _APART)
    ratios = [_ratios(power, block) for power in _powers(whitening)]
    heights = [np.where(ignored, 0.0, _heights(ratio, block, factors)) for ratio in ratios]
    found = _clearest(factors, heights, tolerance)
    own = _first_multiple(ratios[0], block, None if found is None else found.factor, tolerance)
    if own is not None:
        found = ShaftLines(own, 0.0 if found is None else found.clearness, True)
    if found is None:
        return ShaftLines(1.0, 0.0, False)
    return replace(found, factor=_refined(ratios[0], block, found.factor))


def _clearest(
    factors: FloatArray, heights: Sequence[FloatArray], tolerance: float
) -> ShaftLines | None:
    """Return the speed whose comb stands out; None if none does."""
    clearness = np.sum([_clearness(height, _HALF) for height in heights], axis=0)
    few = np.sum([_clearness(height, _FEW) for height in heights], axis=0)
    off = np.abs(factors - 1.0)
    near, allowed = off <= min(tolerance, _APART), off <= tolerance
    given, few_given = _best(clearness, near), _best(few, near)
    if clearness[given] >= max(_CLEAR, _AGREES * np.max(clearness)):
        return ShaftLines(float(factors[given]), float(clearness[given]), True)
    if few[few_given] >= max(_FEW_CLEAR, _AGREES * np.max(few)):
        return ShaftLines(float(factors[few_given]), float(clearness[given]), True)
    # what turns at another speed shows that by its first multiple
    turns = np.any([height[0] > 0.0 for height in heights], axis=0)
    clearness = np.where(turns | near, clearness, 0.0)
    least = max(_CLEAR, np.max(clearness) / _FAR_MARGIN)
    best = _best(clearness, allowed)
    if clearness[best] < least:
        best = _best(clearness, off <= LOOKED_AT)
    if clearness[best] >= least and _alone(factors, clearness, best):
        return ShaftLines(float(factors[best]), float(clearness[best]), True)
    return None


def _first_multiple(
    ratio: FloatArray, block: Block, comb: float | None, tolerance: float
) -> float | None:
    """Return the speed of the highest first multiple, if a comb of another speed gives way to it.

    ratio: power of the samples' lines over the noise; comb: its speed over the given one. Without a
    comb the line has to stand as clear of all others that may be a first multiple.
    """
    turns, resolution = block.turns, block.rate / len(block.samples)
    lines = np.arange(max(1, int((1.0 - tolerance) * turns)), ceil((1.0 + tolerance) * turns) + 1)
    hertz = np.asarray(lines * resolution, dtype=np.float64)
    of_mains = [is_near_mains(hertz, resolution, mains) for mains in MAINS]
    seen = np.where(np.any(of_mains, axis=0), 0.0, ratio[lines])
    highest = int(np.argmax(seen))
    if seen[highest] < _FIRST_ABOVE * leaked(ratio, int(lines[highest]), tone_leakage(), _TONE):
        return None
    apart = np.abs(lines - lines[highest]) > max(2.0, _APART * turns)
    if comb is None:
        rival = float(np.max(seen[apart], initial=0.0))
    else:
        about = round(comb * turns)
        rival = float(np.max(ratio[about - 1 : about + 2]))
    stays = seen[highest] >= max(_FIRST_CLEAR, _FIRST_ABOVE * rival)
    return float(lines[highest]) / turns if stays else None


def _refined(ratio: FloatArray, block: Block, factor: float) -> float:
    """Return the factor by which clear lines of the shaft lie, each within what those below allow.

    Without a clear first multiple it is that of the comb.
    """
    first, error = factor * block.turns, max(1.0, _APART * block.turns)
    for multiple in range(1, _MULTIPLES + 1):
        about, within = multiple * first, multiple * error
        low, high = max(1, ceil(about - within)), min(len(ratio) - 2, int(about + within))
        if low > high or (multiple > 1 and within > _FARTHEST):
            break
        line = low + int(np.argmax(ratio[low : high + 1]))
        if ratio[line] >= _FIRST_CLEAR:
            place = float(places_between(ratio, np.array([line]))[0])
            first, error = place / multiple, _PLACE_ERROR / multiple
        elif multiple == 1:
            break
    return first / block.turns


def _best(clearness: FloatArray, allowed: BoolArray) -> int:
    return int(np.argmax(np.where(allowed, clearness, -1.0)))


def _alone(factors: FloatArray, clearness: FloatArray, best: int) -> bool:
    """Whether no other speed has about as clear a comb."""
    others = clearness[np.abs(factors - factors[best]) > _APART]
    return bool(clearness[best] >= _MARGIN * np.max(others, initial=0.0))


def _factors(turns: float) -> FloatArray:
    """Speeds to try, over the given one."""
    step = 1.0 / (_STEPS * _MULTIPLES * turns)
    count = int(LOOKED_AT / step)
    return np.asarray(1.0 + step * np.arange(-count, count + 1), dtype=np.float64)


def _on_mains(factors: FloatArray, block: Block) -> BoolArray:
    """Which multiples lie on those of a mains' frequency; (multiples, speeds)."""
    resolution = block.rate / len(block.samples)
    hertz = np.arange(1, _MULTIPLES + 1)[:, None] * factors * block.turns * resolution
    near = [is_near_mains(hertz, resolution, mains) for mains in MAINS]
    return np.asarray(np.any(near, axis=0))


def _of_parts(factors: FloatArray, parts: Sequence[tuple[float, float, float]]) -> BoolArray:
    """Which multiples are a part's at the given speed; (multiples, speeds)."""
    orders = np.arange(1, _MULTIPLES + 1)[:, None] * factors
    found = np.zeros(orders.shape, dtype=np.bool_)
    for low, high, _ in parts:
        for multiple in range(1, int(np.max(orders) / low) + 1):
            found |= (orders >= multiple * low) & (orders <= multiple * high)
    return found


def _powers(whitening: Whitening) -> tuple[FloatArray, FloatArray]:
    """Powers of the lines of a block's samples, and of the squared envelope of what is whitened."""
    white = whitening.white(remove_tones=True)
    if white is None:
        return whitening.power, np.zeros(len(whitening.power))
    lines = white.spectrum
    squared = power_of(scipy.fft.ifft(lines, scipy.fft.next_fast_len(2 * len(lines))))
    limit(squared)
    return whitening.power, power_of(np.asarray(scipy.fft.rfft(squared)))


def _ratios(power: FloatArray, block: Block) -> FloatArray:
    """Powers of the lines from zero on over the noise about each; zeros without noise."""
    highest = int(2.0 * _MULTIPLES * (1.0 + LOOKED_AT) * block.turns) + 200
    power = power[1:highest]
    level = local_level(power, block.rate / len(block.samples))
    if not np.all(level > 0.0):
        return np.zeros(len(power) + 1)
    return np.concatenate([[0.0], power / level])


def _heights(ratio: FloatArray, block: Block, factors: FloatArray) -> FloatArray:
    """ℓ of each multiple at each speed; (multiples, speeds)."""
    multiples = np.arange(1, _MULTIPLES + 1)[:, None]
    lines = np.rint(multiples * factors * block.turns).astype(np.int64)
    found = ratio[np.minimum(lines, len(ratio) - 1)] * (lines < len(ratio))
    with np.errstate(divide="ignore"):
        return np.clip(np.log(found / _RARE), 0.0, None)


def _clearness(heights: FloatArray, number: int) -> FloatArray:
    """L at each speed; none of the multiples counts for more than so many of them reach."""
    found = np.sum(np.minimum(heights, np.sort(heights, axis=0)[-number]), axis=0)
    odd = np.count_nonzero(heights[::2] > 0.0, axis=0)
    return np.asarray(np.where(odd >= _ODD, found, 0.0))
