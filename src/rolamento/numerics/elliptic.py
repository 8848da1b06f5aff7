"""Elliptic integrals, vectorised, to near machine precision.

The complete integrals come from the arithmetic-geometric mean, and Carlson's symmetric forms,
from which incomplete ones follow, by duplication. The complete integrals take the *complementary*
parameter 1 - m, which for a slender contact ellipse is the small number (b/a)^2: passing m
itself would lose it to rounding. SciPy has all of them (docs/adr/0003-own-elliptic-integrals.md).

Sources: NIST Digital Library of Mathematical Functions (DLMF), sections 19.2, 19.8, 19.36;
Carlson, Numerical Algorithms 10 (1995).
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import inline_exact, kernel
from rolamento.numerics.elementwise import of_each

_USUAL: Final = 1e-5
"""1 - m of an ellipse of 300 to 1: more slender ones take more steps."""
STEPS: Final = 5
"""Number of steps of the arithmetic-geometric mean, enough from there on."""
MOST_STEPS: Final = 11
"""The same down to the smallest number above zero."""
_DUPLICATIONS: Final = 11
"""Number of duplications of Carlson's integrals: some four bring arguments of 1e-16 and 1 near each
other, and each of the others divides their spread by 4, of which the series below leaves out the
sixth order."""


def complete(complement: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Complete integrals of the first and second kind, K and E, of the parameter m.

    Parameters
    ----------
    complement : array of any shape, 1 - m in [0, 1]; dimensionless.

    Returns
    -------
    K, E : arrays of that shape. K is infinite at 1 - m = 0; NaN outside the range.

    DLMF 19.8.5 and 19.8.6.
    """
    b, d = associate(complement)
    with np.errstate(invalid="ignore"):
        product = np.asarray(complement, dtype=np.float64) * d
    e = b + np.where(np.isinf(d), 0.0, product)
    return b + d, e


def associate(complement: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Associate complete integrals B = ∫cos²φ/Δ dφ and D = ∫sin²φ/Δ dφ over a quarter turn.

    Δ² = 1 - m sin²φ. K = B + D and E = B + (1 - m) D, and unlike (K - E)/m they keep their
    precision as m goes to 0.

    Parameters
    ----------
    complement : array of any shape, 1 - m in [0, 1]; dimensionless.

    Returns
    -------
    B, D : arrays of that shape. D is infinite at 1 - m = 0; NaN outside the range.

    DLMF 19.8.5 and 19.8.6, with c_n² divided by m term by term.
    """
    m1 = np.asarray(complement, dtype=np.float64)
    inside = (m1 > 0.0) & (m1 <= 1.0)
    whole = bool(inside.all())
    safe = m1 if whole else np.where(inside, m1, 1.0)
    if safe.min(initial=1.0) >= _USUAL:
        b, d = of_each(by_mean, _fill, 2, safe)
    else:
        b, d = by_mean(safe, MOST_STEPS)
    if whole:
        return np.asarray(b), np.asarray(d)
    tiny = m1 == 0.0
    return (
        np.where(inside, b, np.where(tiny, 1.0, np.nan)),
        np.where(inside, d, np.where(tiny, np.inf, np.nan)),
    )


@inline_exact
def by_mean(m1: FloatArray, steps: int = STEPS) -> tuple[FloatArray, FloatArray]:
    """B and D of a number or an array of 1 - m above zero, by so many steps of the mean."""
    g = np.sqrt(m1)
    a = 0.5 + 0.5 * g
    ratio = 0.25 * (1.0 - g) / (1.0 + g)  # c_1² / m
    c_squared = 0.25 * (1.0 - g) ** 2
    g = np.sqrt(g)
    weight, total = 1.0, 0.5 + ratio
    for _ in range(steps):
        a, g = 0.5 * (a + g), np.sqrt(a * g)
        scaled = c_squared / (16.0 * a * a)
        ratio, c_squared = ratio * scaled, c_squared * scaled
        weight *= 2.0
        total = total + weight * ratio
    k = np.pi / (a + g)
    d = k * total
    return k - d, d


@kernel
def _fill(m1: FloatArray, out: FloatArray) -> None:
    """Fill out, (2, numbers)."""
    for i in range(m1.size):
        out[0, i], out[1, i] = by_mean(m1[i])


@inline_exact
def carlson_rf_rd(x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Carlson's symmetric integrals R_F(x, y, 1) and R_D(x, y, 1), of numbers or of arrays.

    Parameters
    ----------
    x, y : numbers or arrays that broadcast, in [0, 1], at most one of them zero; the other above
        1e-16. Dimensionless.

    Returns
    -------
    R_F, R_D, to rounding, after a fixed number of duplications, which both integrals share; NaN for
    a negative argument.

    DLMF 19.36.1 and 19.36.2 after duplication, 19.26.18 and 19.26.20.
    """
    z, power, total = 1.0 + 0.0 * x, 1.0, 0.0 * x
    for _ in range(_DUPLICATIONS):
        a, b, c = np.sqrt(x), np.sqrt(y), np.sqrt(z)
        root = a * b + b * c + c * a
        total = total + power / (c * (z + root))
        power *= 0.25
        x, y, z = 0.25 * (x + root), 0.25 * (y + root), 0.25 * (z + root)
    mean = (x + y + z) / 3.0
    u, v = 1.0 - x / mean, 1.0 - y / mean
    e2, e3 = u * v - (u + v) ** 2, -u * v * (u + v)
    series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0
    first = series / np.sqrt(mean)
    mean = (x + y + 3.0 * z) / 5.0
    u, v = 1.0 - x / mean, 1.0 - y / mean
    w = -(u + v) / 3.0
    e2 = u * v - 6.0 * w * w
    e3 = (3.0 * u * v - 8.0 * w * w) * w
    e4 = 3.0 * (u * v - w * w) * w * w
    e5 = u * v * w * w * w
    series = (
        1.0
        - 3.0 * e2 / 14.0
        + e3 / 6.0
        + 9.0 * e2 * e2 / 88.0
        - 3.0 * e4 / 22.0
        - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0
    )
    return first, power * series / (mean * np.sqrt(mean)) + 3.0 * total
