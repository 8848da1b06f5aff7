"""The ellipse that two elliptic integrals ask for, as the contact of curved bodies is.

k = a/b ≥ 1 is the root of D(m) / (k² B(m)) = ratio, with m = 1 - 1/k² and the associate complete
integrals B and D: a ratio of 1 is the circle.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.elliptic import associate

_NEWTON_STEPS = 30
_LAST_STEP = 3e-8
_LARGEST_FITTED = 8.0
_START = (
    1.1698686464e-10, 0.666666530927, 2.42237504431e-06, -0.0030994631522, 3.28192735224e-05,
    8.21878367412e-05, 4.04784986688e-05, -2.93028322031e-05, 8.14136554243e-06,
    -1.33967322637e-06, 1.41421304054e-07, -9.47309419259e-09, 3.68731080548e-10,
    -6.37469260254e-12,
)  # fmt: skip
"""Of a polynomial in -ln ratio, fitted to ln k at Chebyshev's nodes from 0 to 8."""


class Ellipse(NamedTuple):
    """Of an ellipse: k and the complete integrals K and E of m = 1 - 1/k²."""

    ellipticity: FloatArray
    first: FloatArray
    second: FloatArray


def ellipse_of_log_ratio(log_ratio: FloatArray) -> Ellipse:
    """Ellipse of ln ratio ≤ 0, an array of any shape, by Newton on u = ln k.

    ln(D/B) - 2u is nearly straight in u: its slope runs from -3/2 at k = 1 toward -2. The last
    step is so short that its square is rounding, and the integrals follow along their slopes.
    """
    u = _start(log_ratio)
    for _ in range(_NEWTON_STEPS):
        m1 = np.exp(-2.0 * u)
        b, d = associate(m1)
        b_rate, d_rate = _rates(m1, b, d)
        step = (np.log(d / b) - 2.0 * u - log_ratio) / (2.0 - 2.0 * m1 * (d_rate - b_rate))
        step = np.maximum(step, -u)
        unsettled = np.abs(step) > _LAST_STEP
        if not unsettled.any():
            break
        u = u + step
    k = np.maximum(np.exp(u) * (1.0 + step), 1.0)
    if unsettled.any():
        k = np.where(unsettled, np.nan, k)
    slope = 2.0 * m1 * step
    b, d = b * (1.0 + slope * b_rate), d * (1.0 + slope * d_rate)
    return Ellipse(k, b + d, b + d / (k * k))


def _start(log_ratio: FloatArray) -> FloatArray:
    """Nearly ln k, for Newton: to 1e-8 up to a ratio of 3000, as between balls and grooves."""
    x = np.minimum(-log_ratio, _LARGEST_FITTED)
    u = np.full_like(x, _START[-1])
    for coefficient in _START[-2::-1]:
        u *= x
        u += coefficient
    return u - 0.5 * (log_ratio + x)


def _rates(m1: FloatArray, b: FloatArray, d: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Derivatives of ln B and ln D by m, from DLMF 19.4(i)."""
    m = 1.0 - m1
    wide = m > 1e-4
    twice = 2.0 * np.where(wide, m, 1.0)
    return (
        np.where(wide, (d - b) / (twice * b), 0.125),
        np.where(wide, (b / m1 - d) / (twice * d), 0.375),
    )
