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
"""

from __future__ import annotations

from dataclasses import dataclass
from math import log
from typing import Final

import numpy as np
from scipy import fft

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.band_spectra import limit
from rolamento.vibration.diagnosis.blocks import Block
from rolamento.vibration.diagnosis.lines import MAINS, is_near_mains, power_of
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
"""Of L over that of any other speed."""
_FAR_MARGIN: Final = 2.0
"""Likewise over that of all speeds within what was allowed, where the comb is beyond them."""
_APART: Final = 0.006
"""Part from which on a speed is another one."""
_AGREES: Final = 0.6
"""Of the clearest comb: from there on the lines do not speak against the given speed."""
_FEW_CLEAR: Final = 6.0
"""L of three multiples from which on they speak for the given speed."""


@dataclass(frozen=True, slots=True)
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


def shaft_lines(whitening: Whitening, tolerance: float) -> ShaftLines:
    """Compare the given speed of a block with what the shaft's own lines say.

    Parameters
    ----------
    whitening
        Of the block, at a steady speed.
    tolerance
        Part by which the speed may be off; 0 if it is certain. A clear comb farther off, up to
        `LOOKED_AT`, counts where there is none within.
    """
    block = whitening.block
    if tolerance == 0.0 or block.places is not None:
        return ShaftLines(1.0, 0.0, True)
    if block.turns < _MULTIPLES or not np.any(np.diff(block.samples)):
        return ShaftLines(1.0, 0.0, False)
    factors = _factors(block.turns)
    on_mains = _on_mains(factors, block) & (np.abs(factors - 1.0) > _APART)
    heights = [
        np.where(on_mains, 0.0, _heights(power, block, factors)) for power in _powers(whitening)
    ]
    clearness = np.sum([_clearness(height, _HALF) for height in heights], axis=0)
    few = np.sum([_clearness(height, _FEW) for height in heights], axis=0)
    off = np.abs(factors - 1.0)
    near, allowed = off <= min(tolerance, _APART), off <= tolerance
    given, few_given = _best(clearness, near), _best(few, near)
    if clearness[given] >= max(_CLEAR, _AGREES * np.max(clearness)):
        return ShaftLines(float(factors[given]), float(clearness[given]), True)
    if few[few_given] >= max(_FEW_CLEAR, _AGREES * np.max(few)):
        return ShaftLines(float(factors[few_given]), float(clearness[given]), True)
    least = max(_CLEAR, np.max(clearness) / _FAR_MARGIN)
    best = _best(clearness, allowed)
    if clearness[best] < least:
        best = _best(clearness, off <= LOOKED_AT)
    if clearness[best] >= least and _alone(factors, clearness, best):
        return ShaftLines(float(factors[best]), float(clearness[best]), True)
    return ShaftLines(1.0, float(clearness[given]), False)


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


def _powers(whitening: Whitening) -> tuple[FloatArray, FloatArray]:
    """Of the lines of a block's samples, and of the squared envelope of what is whitened."""
    white = whitening.white(remove_tones=True)
    if white is None:
        return whitening.power, np.zeros(len(whitening.power))
    lines = white.spectrum
    squared = power_of(fft.ifft(lines, fft.next_fast_len(2 * len(lines))))
    limit(squared)
    return whitening.power, power_of(np.asarray(fft.rfft(squared)))


def _heights(power: FloatArray, block: Block, factors: FloatArray) -> FloatArray:
    """ℓ of each multiple at each speed; (multiples, speeds)."""
    highest = int(2.0 * _MULTIPLES * (1.0 + LOOKED_AT) * block.turns) + 200
    power = power[1:highest]
    level = local_level(power, block.rate / len(block.samples))
    multiples = np.arange(1, _MULTIPLES + 1)[:, None]
    if not np.all(level > 0.0):
        return np.zeros((_MULTIPLES, len(factors)))
    lines = np.rint(multiples * factors * block.turns).astype(np.int64) - 1
    found = (power / level)[np.minimum(lines, len(power) - 1)] * (lines < len(power))
    with np.errstate(divide="ignore"):
        return np.clip(np.log(found / _RARE), 0.0, None)


def _clearness(heights: FloatArray, number: int) -> FloatArray:
    """L at each speed; none of the multiples counts for more than so many of them reach."""
    found = np.sum(np.minimum(heights, np.sort(heights, axis=0)[-number]), axis=0)
    odd = np.count_nonzero(heights[::2] > 0.0, axis=0)
    return np.asarray(np.where(odd >= _ODD, found, 0.0))
