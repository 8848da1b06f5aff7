"""How far lines of a spectrum stand out of the noise about them, as probabilities.

A line of the spectrum of stationary noise, averaged over K independent spectra, is distributed as
a gamma variable of shape K about the local level: exponential for K = 1. The level is estimated by
the median of M lines about the one in question. Under noise, the probability that the line
reaches T times that median is

    p(T) = ∫ Q(K, T x(u)) f(u) du,   x(u) = P⁻¹(K, u),   f = beta density of the median's rank,

with P and Q the incomplete gamma functions; it takes the scatter of the median into account and is
the same for any level (constant false-alarm rate by ordered statistics; Rohling, IEEE Transactions
on Aerospace and Electronic Systems 19 (1983), 608-621). For K = 1 it is the product

    p(T) = Π (M - i)/(M - i + T),   i = 0 … rank - 1.

The *score* of a line is -ln p: in noise an exponential variable of mean 1, whatever the spectrum's
shape, units, averages and the number of neighbours. The sum of n independent scores has the tail
Q(n, sum).
"""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np
from scipy import ndimage, special

from rolamento.numerics import FloatArray

__all__ = ["HALF_WIDTH", "LOWEST_LINE", "line_scores", "log_gamma_tail", "median_tail"]

HALF_WIDTH: Final = 50
"""Lines on either side whose median is the level."""
LOWEST_LINE: Final = 8
"""Below, there are too few lines between a line and zero to tell the level."""
Table = tuple[FloatArray, FloatArray]

_REACHES: Final = (4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, HALF_WIDTH)
"""Half widths near zero frequency; few, as each has its tables."""
_HIGHEST_RATIO: Final = 1e9
_NEAR: Final = 200
_FAR: Final = 300
_NODES: Final = 60


def line_scores(power: FloatArray, *, averages: int) -> FloatArray:
    """-ln of the probability that noise lifts each line as far above its neighbours.

    Parameters
    ----------
    power
        (spectra, lines), of evenly spaced lines from zero frequency.
    averages
        K, of how many independent spectra each is the mean.

    Returns
    -------
    (spectra, lines); NaN below `LOWEST_LINE`, within the last `HALF_WIDTH`, and where all about is
    zero.
    """
    lines = power.shape[1]
    scores = np.full(power.shape, np.nan)
    for line in range(LOWEST_LINE, min(2 * HALF_WIDTH, lines)):
        reach = max(width for width in _REACHES if width <= line // 2)
        if line + reach < lines:
            about = power[:, line - reach : line + reach + 1]
            scores[:, line] = _scores(power[:, line], np.median(about, axis=1), reach, averages)
    inside = slice(2 * HALF_WIDTH, lines - HALF_WIDTH)
    if lines > 3 * HALF_WIDTH:
        # one long row is much faster; where its parts meet, the result is not used
        level = ndimage.median_filter(power.ravel(), size=2 * HALF_WIDTH + 1, mode="nearest")
        level = level.reshape(power.shape)[:, inside]
        scores[:, inside] = _scores(power[:, inside], level, HALF_WIDTH, averages)
    return scores


def _scores(power: FloatArray, level: FloatArray, reach: int, averages: int) -> FloatArray:
    """The median counts the line itself: the level is then of rank M/2 + 1 among the others.

    If the line lies below the median, of rank M/2.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.minimum(power / level, _HIGHEST_RATIO)
    above, below = median_tail(reach, averages)
    place = np.log1p(ratio)
    found = np.where(ratio < 1.0, np.interp(place, *below), np.interp(place, *above))
    return np.asarray(np.where(np.isnan(ratio), np.nan, found))


@cache
def median_tail(reach: int, averages: int) -> tuple[Table, Table]:
    """Tables of -ln p over ln(1 + T), for T from 1 and up to 1; M = 2·reach."""
    width = 12.0 / np.sqrt(averages)
    near = np.linspace(1.0, 1.0 + width, _NEAR)
    far = np.geomspace(1.0 + width, _HIGHEST_RATIO, _FAR)[1:]
    above = np.concatenate([near, far])
    low = max(0.0, 1.0 - width)
    below = np.concatenate([np.linspace(0.0, low, 20)[:-1], np.linspace(low, 1.0, _NEAR)])
    return (
        (np.log1p(above), _log_tail(above, 2 * reach, reach + 1, averages)),
        (np.log1p(below), _log_tail(below, 2 * reach, reach, averages)),
    )


def _log_tail(ratio: FloatArray, others: int, rank: int, averages: int) -> FloatArray:
    """-ln p(T), the level being the value of a rank among others."""
    if averages == 1:
        left = others - np.arange(rank)
        return np.asarray(np.sum(np.log1p(ratio[:, None] / left), axis=1))
    return -_log_mean_tail(ratio, others, rank, averages)


def _log_mean_tail(ratio: FloatArray, others: int, rank: int, averages: int) -> FloatArray:
    """Logarithm of the integral of the module's head, by Gauss-Legendre."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    above = others - rank
    ends = special.betaincinv(rank, above + 1, np.array([1e-14, 1.0 - 1e-14]))
    low, high = special.gammaincinv(averages, ends)
    x = low + 0.5 * (high - low) * (nodes + 1.0)
    u = special.gammainc(averages, x)
    log_density = (
        special.xlogy(rank - 1, u)
        + special.xlog1py(above, -u)
        - special.betaln(rank, above + 1)
        + special.xlogy(averages - 1, x)
        - x
        - special.gammaln(averages)
    )
    log_weight = np.log(weights * 0.5 * (high - low)) + log_density
    tails = log_gamma_tail(averages, ratio[:, None] * x[None]) + log_weight
    return np.asarray(special.logsumexp(tails, axis=1))


def log_gamma_tail(shape: float, x: FloatArray) -> FloatArray:
    """Logarithm of Q(shape, x), also where Q is too small for a number.

    There Q = x^(a-1) e^(-x)/Γ(a) · 1/(1 - (a-1)/(x + …)), the first terms of Legendre's continued
    fraction.
    """
    x = np.asarray(x, dtype=np.float64)
    tail = np.asarray(special.gammaincc(shape, x))
    with np.errstate(divide="ignore", invalid="ignore"):
        plain = np.log(tail)
        # 1/(x + 1 - a - (1 - a)/(x + 3 - a - 2 (2 - a)/(x + 5 - a)))
        last = x + 3.0 - shape - 2.0 * (2.0 - shape) / (x + 5.0 - shape)
        fraction = x + 1.0 - shape - (1.0 - shape) / last
        far = special.xlogy(shape, x) - x - special.gammaln(shape) - np.log(fraction)
    return np.asarray(np.where(tail > 1e-280, plain, far))
