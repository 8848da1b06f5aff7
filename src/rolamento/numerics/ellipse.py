"""The ellipse that two elliptic integrals ask for, as the contact of curved bodies is.

k = a/b ≥ 1 is the root of D(m) / (k² B(m)) = ratio, with m = 1 - 1/k² and the associate complete
integrals B and D: a ratio of 1 is the circle.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import inline_exact, kernel
from rolamento.numerics.elementwise import of_each
from rolamento.numerics.elliptic import associate

_NEWTON_STEPS = 30
_LAST_STEP = 3e-8
_LARGEST_FITTED = 8.0
_ROUND = 1e-8
"""Value of m, below which a slope is that of the circle: a difference over m would be rounding."""
_START = (
    1.1698686464e-10, 0.666666530927, 2.42237504431e-06, -0.0030994631522, 3.28192735224e-05,
    8.21878367412e-05, 4.04784986688e-05, -2.93028322031e-05, 8.14136554243e-06,
    -1.33967322637e-06, 1.41421304054e-07, -9.47309419259e-09, 3.68731080548e-10,
    -6.37469260254e-12,
)  # fmt: skip
"""Coefficients of a polynomial in -ln ratio, fitted to ln k at Chebyshev's nodes from 0 to 8."""


class Ellipse(NamedTuple):
    """Parameters of an ellipse: k and the complete integrals K and E of m = 1 - 1/k²."""

    ellipticity: FloatArray
    first: FloatArray
    second: FloatArray


def ellipse_of_log_ratio(log_ratio: FloatArray) -> Ellipse:
    """Ellipse of ln ratio ≤ 0, an array of any shape, by Newton on u = ln k.

    ln(D/B) - 2u is nearly straight in u: its slope runs from -3/2 at k = 1 toward -2. The last
    step is so short that its square is rounding, and the integrals follow along their slopes.
    """
    (u,) = of_each(_start, _fill_start, 1, log_ratio)
    for _ in range(_NEWTON_STEPS):
        m1 = np.exp(-2.0 * u)
        b, d = associate(m1)
        step, k, first, second = of_each(
            _followed, _fill_followed, 4, log_ratio, np.log(d / b), u, m1, b, d
        )
        unsettled = np.abs(step) > _LAST_STEP
        if not unsettled.any():
            break
        u = u + step
    if unsettled.any():
        k = np.where(unsettled, np.nan, k)
    return Ellipse(k, first, second)


@inline_exact
def _start(log_ratio: FloatArray) -> tuple[FloatArray]:
    """Nearly ln k, for Newton: to 1e-8 up to a ratio of 3000, as between balls and grooves."""
    x = np.minimum(-log_ratio, _LARGEST_FITTED)
    u = _START[-1] * x + _START[-2]
    for place in range(3, len(_START) + 1):
        u = u * x + _START[-place]
    return (u - 0.5 * (log_ratio + x),)


@kernel
def _fill_start(log_ratio: FloatArray, out: FloatArray) -> None:
    """Fill out, (1, numbers)."""
    for i in range(log_ratio.size):
        (out[0, i],) = _start(log_ratio[i])


@inline_exact
def _followed(
    log_ratio: FloatArray,
    logarithm: FloatArray,
    u: FloatArray,
    m1: FloatArray,
    b: FloatArray,
    d: FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Newton's step from u, and k, K and E after it; logarithm: ln(D/B)."""
    # derivatives of ln B and ln D by m, from DLMF 19.4(i); of a circle 1/8 and 3/8
    twice = 2.0 * (1.0 - m1 + _ROUND)
    b_rate = (d - b + 0.25 * _ROUND * b) / (twice * b)
    d_rate = (b / m1 - d + 0.75 * _ROUND * d) / (twice * d)
    step = (logarithm - 2.0 * u - log_ratio) / (2.0 - 2.0 * m1 * (d_rate - b_rate))
    step = np.maximum(step, -u)
    k = np.maximum((1.0 + step) / np.sqrt(m1), 1.0)
    slope = 2.0 * m1 * step
    b, d = b * (1.0 + slope * b_rate), d * (1.0 + slope * d_rate)
    return step, k, b + d, b + d / (k * k)


@kernel
def _fill_followed(
    log_ratio: FloatArray,
    logarithm: FloatArray,
    u: FloatArray,
    m1: FloatArray,
    b: FloatArray,
    d: FloatArray,
    out: FloatArray,
) -> None:
    """Fill out, (4, numbers)."""
    for i in range(u.size):
        out[0, i], out[1, i], out[2, i], out[3, i] = _followed(
            log_ratio[i], logarithm[i], u[i], m1[i], b[i], d[i]
        )
