"""How far lines of a spectrum stand out of the noise about them, as probabilities.

A line of the spectrum of stationary noise, averaged over K independent spectra, is distributed as
a gamma variable of shape K about the local level: exponential for K = 1; the mean of c neighbouring
lines has the shape cK. The level is estimated by the median of the 2r + 1 lines about the place in
question. Among the M = 2r + 1 - c others it is then of rank k, and noise lifts the mean of the c
lines to T times the median with the probability

    p(T) = ∫ Q(cK, cT x(u)) f(u) du,   x(u) = P⁻¹(K, u),   f = beta density of the rank k of M,

with P and Q the incomplete gamma functions. The scatter of the median is in it, and it is the same
for any level (constant false-alarm rate by ordered statistics; Rohling, IEEE Transactions on
Aerospace and Electronic Systems 19 (1983), 608-621). One line that lies above the median leaves it
the rank k = r + 1 among the others, one below it k = r; of c lines half are counted as below, which
errs toward noise where more lie above. For one line and K = 1 it is the product

    p(T) = Π (M - i)/(M - i + T),   i = 0 … k - 1.

The *score* is -ln p: in noise an exponential variable of mean 1, whatever the spectrum's shape,
units, averages and the numbers of lines. The sum of n independent scores has the tail Q(n, sum).
"""

from __future__ import annotations

from functools import cache
from math import nan
from typing import Final

import numpy as np
from scipy import interpolate, ndimage, special

from rolamento.numerics import FloatArray, IntArray

Table = tuple[FloatArray, FloatArray]
HALF_WIDTH: Final = 250
"""Lines on either side whose median is the level."""
LOWEST_LINE: Final = 8
"""Below, there are too few lines between a line and zero to know the level."""
_REACHES: Final = np.array(
    [4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 65, 80, 100, 130, 160, 200, HALF_WIDTH]
)
"""Half widths near zero frequency; few, as each has its tables."""
_HIGHEST_RATIO: Final = 1e9
_NEAR: Final = 25
_FAR: Final = 50
"""Places of a table near T = 1 and far above."""
_DENSER: Final = 7
"""Steps between two places, filled in by a spline, for quick look-up."""
_NODES: Final = 50
_ENDS: Final = 1e-13
"""Of the distribution of the median, left out at either side."""


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
    (spectra, lines); NaN where there is no level, and where that is zero.
    """
    reach = np.broadcast_to(reaches(np.arange(power.shape[1])), power.shape)
    count = np.ones(power.shape, dtype=np.int64)
    return mean_scores(power, running_medians(power), count, reach, averages)


def running_medians(power: FloatArray) -> FloatArray:
    """Median of each line and its neighbours: `HALF_WIDTH` on either side, fewer near zero.

    power: (spectra, lines). Returns the same shape; NaN below `LOWEST_LINE` and in the last
    `HALF_WIDTH`.
    """
    lines = power.shape[1]
    medians = np.full(power.shape, np.nan)
    reach_of = reaches(np.arange(lines))
    for reach in _REACHES:
        served = np.flatnonzero(reach_of == reach)
        served = served[(served >= LOWEST_LINE) & (served + reach < lines)]
        if len(served) > 0:
            part = power[:, : served[-1] + reach + 1]
            # one long row is much faster; where bands meet in it, nothing is used
            size = 2 * int(reach) + 1
            found = ndimage.median_filter(part.ravel(), size=size, mode="nearest")
            medians[:, served] = found.reshape(part.shape)[:, served]
    return medians


def reaches(lines: IntArray) -> IntArray:
    """Lines on either side of which `running_medians` takes the median; as `lines`."""
    places = np.searchsorted(_REACHES, np.asarray(lines) // 2, side="right") - 1
    return np.asarray(_REACHES[np.maximum(places, 0)])


def mean_scores(
    mean: FloatArray,
    median: FloatArray,
    count: IntArray,
    reach: IntArray,
    averages: int,
) -> FloatArray:
    """Scores of means over some neighbouring lines, given the median about each.

    Parameters
    ----------
    mean, median
        Arrays of one shape.
    count
        How many lines are in each mean; same shape.
    reach
        Of the medians; same shape.
    averages
        K.

    Returns
    -------
    The same shape; NaN where there are no lines, more than the median's reach, no level, or it is
    zero.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        place = np.log1p(np.minimum(mean / median, _HIGHEST_RATIO))
    good = (median > 0.0) & (count > 0) & (count <= reach)
    kinds = np.where(good, np.searchsorted(_REACHES, reach) + len(_REACHES) * count, 0)
    flat, at = kinds.ravel(), place.ravel()
    frequent = int(np.argmax(np.bincount(flat, minlength=1)))
    found = np.full(at.shape, nan)
    if frequent:
        found = np.asarray(np.interp(at, *_scores_of_kind(frequent, averages)))
    others = np.flatnonzero(flat != frequent)
    others = others[np.argsort(flat[others], kind="stable")]
    ends = np.flatnonzero(np.diff(flat[others], append=-1)) + 1
    for alike in np.split(others, ends[:-1]):
        kind = int(flat[alike[0]]) if len(alike) else 0
        found[alike] = np.interp(at[alike], *_scores_of_kind(kind, averages)) if kind else nan
    return found.reshape(mean.shape)


def _scores_of_kind(kind: int, averages: int) -> Table:
    lines, place = divmod(kind, len(_REACHES))
    return _scores_by_ratio(int(_REACHES[place]), lines, averages)


def mean_over_median(averages: int) -> float:
    """Mean of the power of noise lines over its median."""
    return float(averages / special.gammaincinv(averages, 0.5))


@cache
def _scores_by_ratio(reach: int, count: int, averages: int) -> Table:
    """Table of -ln p over ln(1 + T); densest about T = 1, where p falls fastest."""
    width = 12.0 / np.sqrt(averages * count)
    near = 1.0 + width * np.linspace(0.0, 1.0, _NEAR) ** 1.5
    above = np.concatenate([near, np.geomspace(1.0 + width, _HIGHEST_RATIO, _FAR)[1:]])
    low = max(0.0, 1.0 - width)
    start = np.linspace(0.0, low, 6)[:-1] if low > 0.0 else np.zeros(0)
    below = np.concatenate([start, np.linspace(low, 1.0, _NEAR)])
    others = 2 * reach + 1 - count
    middle = reach + 1 - count // 2
    under = _dense(below, _score(below, others, middle - (count == 1), count, averages))
    over = _dense(above, _score(above, others, middle, count, averages))
    return np.concatenate([under[0][:-1], over[0]]), np.concatenate([under[1][:-1], over[1]])


def _dense(ratio: FloatArray, score: FloatArray) -> Table:
    """Scores between given ones, over ln(1 + T)."""
    places = np.log1p(ratio)
    steps = np.arange(_DENSER * (len(places) - 1) + 1) / _DENSER
    dense = np.interp(steps, np.arange(len(places)), places)
    return dense, np.asarray(interpolate.CubicSpline(places, score)(dense))


@cache
def _quadrature() -> tuple[FloatArray, FloatArray]:
    """Gauss and Legendre's nodes from 0 to 1, and their weights."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    return 0.5 * (nodes + 1.0), 0.5 * weights


def _score(ratio: FloatArray, others: int, rank: int, count: int, averages: int) -> FloatArray:
    """-ln p(T), the level being the value of a rank among others."""
    if averages == 1 and count == 1:
        left = others - np.arange(rank)
        return np.asarray(np.sum(np.log1p(ratio[:, None] / left), axis=1))
    nodes, weights = _quadrature()
    above = others - rank
    ends = special.betaincinv(rank, above + 1, np.array([_ENDS, 1.0 - _ENDS]))
    low, high = special.gammaincinv(averages, ends)
    x = low + (high - low) * nodes
    u = special.gammainc(averages, x)
    log_density = (
        special.xlogy(rank - 1, u)
        + special.xlog1py(above, -u)
        - special.betaln(rank, above + 1)
        + special.xlogy(averages - 1, x)
        - x
        - special.gammaln(averages)
    )
    log_weight = np.log(weights * (high - low)) + log_density
    tails = log_gamma_tail(averages * count, count * ratio[:, None] * x[None]) + log_weight
    return -np.asarray(special.logsumexp(tails, axis=1))


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
