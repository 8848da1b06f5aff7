"""Discrete lines of a spectrum, which gears, shafts and electric fields make, taken out.

A line counts as discrete if noise of the level about it would hardly ever reach it, and if it is
as narrow as the taper makes a steady tone. Blows that slip make broad humps, which stay.

One kind of discrete lines stays too: a full comb of the frequency of a fault, where most of all
lines that do not belong to the shaft are its teeth or their sidebands and at least every other
tooth is there. A bearing that hardly slips makes it, and no gear.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.leakage import reach, tone_leakage
from rolamento.vibration.diagnosis.runs import runs

__all__ = ["Comb", "Discrete", "discrete_lines", "local_level"]

_CHANCE: Final = 0.01
"""That noise has any line which is taken for a tone."""
_LEVEL_WIDTH: Final = 25.0
"""Hz over which a level is taken: narrower than resonances."""
_LEVEL_LINES: Final = 64
_TEETH: Final = 6
_SIDEBANDS: Final = 2
_MOST_CANDIDATES: Final = 20_000
_MOST_TONES: Final = 500


@dataclass(frozen=True, slots=True)
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


class Discrete(NamedTuple):
    """Lines of tones, and lines of combs of faults; (lines,) each."""

    tones: BoolArray
    teeth: BoolArray


def local_level(power: FloatArray, resolution: float) -> FloatArray:
    """Mean power of the noise about each line, from medians, unmoved by tones; as `power`.

    resolution: Hz.
    """
    width = min(max(_LEVEL_LINES, int(_LEVEL_WIDTH / resolution)), max(1, len(power) // 2))
    stretches = len(power) // width
    medians = np.median(power[: stretches * width].reshape(stretches, width), axis=1) / log(2.0)
    least = float(np.max(medians)) * 1e-14
    middles = (np.arange(stretches) + 0.5) * width
    logs = np.log(np.maximum(medians, least if least > 0.0 else 1.0))
    return np.asarray(np.exp(np.interp(np.arange(len(power)), middles, logs)))


def discrete_lines(
    spectrum: NDArray[np.complex128], level: FloatArray, combs: Sequence[Comb] = ()
) -> Discrete:
    """Which lines of a tapered block's spectrum belong to discrete tones, and which to a comb.

    Each tone has all lines over which it rises from the noise.

    Parameters
    ----------
    spectrum
        (lines,), of real samples.
    level
        (lines,), of the noise's power.
    combs
        Of faults.
    """
    ratio = np.square(np.abs(spectrum)) / level
    limit = log(len(ratio) / _CHANCE)
    starts, ends = runs(ratio > limit)
    peaks = np.array(
        [start + int(np.argmax(ratio[start:end])) for start, end in zip(starts, ends, strict=True)],
        dtype=np.int64,
    )
    leakage = tone_leakage()
    widths = np.array([2 * reach(leakage, ratio[peak] / limit) + 1 for peak in peaks])
    tones = peaks[ends - starts <= widths + 2] if len(peaks) else peaks
    teeth = np.zeros(len(tones), dtype=np.bool_)
    for comb in combs:
        teeth |= _teeth(tones, comb)
    found = Discrete(*(np.zeros(len(ratio), dtype=np.bool_) for _ in range(2)))
    for tone, of_comb in zip(tones, teeth, strict=True):
        width = reach(leakage, ratio[tone])
        found[1 if of_comb else 0][max(0, tone - width) : tone + width + 1] = True
    return found


def _teeth(tones: NDArray[np.int64], comb: Comb) -> BoolArray:
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


def _near_comb(tones: NDArray[np.int64], fundamental: float, spacing: float) -> BoolArray:
    """Which tones are multiples of a fundamental, or up to two spacings away from one."""
    sides = range(-_SIDEBANDS, _SIDEBANDS + 1) if spacing > 0.0 else range(1)
    places = tones.astype(np.float64)
    near = [_are_multiples(places - side * spacing, fundamental) for side in sides]
    return np.asarray(np.any(near, axis=0))


def _best_fundamental(tones: NDArray[np.int64], comb: Comb) -> float:
    """Of which most tones are multiples; tried in steps of a line at the last tone."""
    steps = int((comb.high - comb.low) * float(tones[-1]) / comb.low) + 2
    candidates = np.linspace(comb.low, comb.high, min(steps, _MOST_CANDIDATES))
    hits = [
        np.count_nonzero(_are_multiples(tones, part[:, None]), axis=1)
        for part in np.array_split(candidates, len(candidates) // 500 + 1)
    ]
    return float(candidates[np.argmax(np.concatenate(hits))])


def _are_multiples(
    tones: NDArray[np.int64] | FloatArray, fundamental: float | FloatArray, uncertainty: float = 0.0
) -> BoolArray:
    """Which tones lie within a line of a multiple, or within a part of themselves.

    That part counts up to a tenth of the fundamental; beyond, nothing can be told.
    """
    number = np.rint(tones / fundamental)
    off = np.abs(tones - number * fundamental)
    allowed = np.maximum(1.0, np.minimum(uncertainty * tones, 0.1 * fundamental))
    return np.asarray((number >= 1) & (off <= allowed))
