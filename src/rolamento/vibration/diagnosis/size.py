"""How large a modulation is, and what that is worth: significance admits a finding, size decides.

The modulation depth d of a band's squared envelope e² = mean · (1 + d cos(nθ + φ) + …) is twice the
size of its line at n over its mean, here of the pre-whitened band, with the noise about the line
taken off. Any healthy bearing has lines at the frequencies of its parts, from load that varies and
from waviness; a long record makes the smallest of them certain. What they do not have is size.

A modulation without impacts has no depth over 4/3 (e² = (1 + cos)²) and hardly any over 1 (where e²
comes to nothing once in each period); a train of short impacts alone has 2.
"""

from __future__ import annotations

from functools import cache
from math import sqrt
from typing import Final, Literal

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis.lines import taper

Grade = Literal["nothing", "watch", "damage", "severe"]
GRADES: Final[tuple[Grade, ...]] = ("nothing", "watch", "damage", "severe")
"""The least first; "watch" are lines as in many healthy bearings."""
DAMAGE: Final = 0.30
"""Depth from which a part counts as damaged; docs/adr/0012 says how it was found."""
SEVERE: Final = 1.0
"""From there on the band holds hardly more than impacts."""
SMOOTH: Final = 0.65
"""Depth up to which a modulation counts as smooth where nothing is impulsive: see `is_smooth`."""
SMOOTH_RECORD: Final = 3.4
"""Kurtosis of the record below which that may be."""
SMOOTH_BAND: Final = 5.0
"""And of the whitened band; docs/adr/0031 says how the three were found."""
_REACH: Final = 2
"""Lines on either side of a discrete one that the taper spreads it over."""


def grade_of(depth: float) -> Grade:
    """Return what the depth of a line that stands out of the noise is worth."""
    return "severe" if depth >= SEVERE else "damage" if depth >= DAMAGE else "watch"


def is_smooth(depth: float, kurtosis: float, band_kurtosis: float) -> bool:
    """Whether a deep modulation comes without impacts: load that varies, not damage.

    Parameters
    ----------
    depth
        Of the modulation.
    kurtosis, band_kurtosis
        Of the record, and of its whitened band; 3 for noise.
    """
    return depth < SMOOTH and kurtosis < SMOOTH_RECORD and band_kurtosis < SMOOTH_BAND


def depth_of(squares: FloatArray, line: float, width: int) -> float:
    """Modulation depth of a line that slip may have made a hump of.

    Parameters
    ----------
    squares
        (lines,), mean squares of the depth in a band, less those of noise.
    line
        Where.
    width
        Width of the hump, in spectral lines.
    """
    reach = max(_REACH, width // 2 + 1)
    first, last = max(1, round(line) - reach), round(line) + reach + 1
    return sqrt(float(np.sum(np.clip(squares[first:last], 0.0, None))) / _bandwidth())


def depth_error(level: float, averages: int) -> float:
    """Standard deviation that noise gives the depth of a line well above it.

    Of a line's power S in noise n the mean of K has the variance 2 S n/K, and d goes with √S.

    Parameters
    ----------
    level
        Mean square of the depth that noise has in a line.
    averages
        K, of how many spectra it is a mean.
    """
    return sqrt(level / (2.0 * averages * _bandwidth()))


@cache
def _bandwidth() -> float:
    """Lines over which the taper spreads the square of a discrete line: its noise bandwidth."""
    window = np.square(taper((np.arange(4096) + 0.5) / 4096))
    return float(np.mean(np.square(window)) / np.mean(window) ** 2)
