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

from collections.abc import Sequence
from functools import cache
from math import nan
from typing import Final, NamedTuple

import numpy as np
import scipy

from rolamento.numerics import FloatArray, IntArray

HALF_WIDTH: Final = 250
"""Lines on either side whose median is the level."""
LOWEST_LINE: Final = 8
"""Below, there are too few lines between a line and zero to know the level."""
_REACHES: Final = np.array(
    [4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 65, 80, 100, 130, 160, 200, HALF_WIDTH]
)
"""Half widths near zero frequency; few, as each has its tables."""
_PLACE_OF_REACH: Final = np.searchsorted(_REACHES, np.arange(HALF_WIDTH + 1))
_HIGHEST_RATIO: Final = 1e9
_NEAR: Final = 25
_FAR: Final = 50
"""Places of a table near T = 1 and far above."""
_DENSER: Final = 7
"""Steps between two places, filled in by a spline, for quick look-up."""
_CELLS_PER_UNIT: Final = 200.0
"""Cells per unit of ln(1 + T), in each of which it is known where a table's places begin."""
_NODES: Final = 50
_FEW: Final = 64
_ENDS: Final = 1e-13
"""Probability at the ends of the distribution of the median, left out at either side."""


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
    reach = reaches(np.arange(power.shape[1]))
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
            part = power[:, served[0] - reach : served[-1] + reach + 1]
            # one long row is much faster; where bands meet in it, nothing is used
            size = 2 * int(reach) + 1
            found = scipy.ndimage.median_filter(part.ravel(), size=size, mode="nearest")
            medians[:, served] = found.reshape(part.shape)[:, reach:-reach]
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
        How many lines are in each mean; of a shape that broadcasts to theirs.
    reach
        Of the medians; likewise.
    averages
        K.

    Returns
    -------
    The same shape; NaN where there are no lines, more than the median's reach, no level, or it is
    zero.
    """
    served = (count > 0) & (count <= reach)
    kinds = np.where(served, _PLACE_OF_REACH[reach] + len(_REACHES) * count, 0)
    present = np.flatnonzero(np.bincount(kinds.ravel()))
    counts, places = np.divmod(present[present > 0], len(_REACHES))
    tables: list[_Table] = []
    for lines in np.unique(counts).tolist():  # `present` rises with the number of lines
        alike = _REACHES[places[counts == lines]].tolist()
        tables += _scores_by_ratio(alike, lines, averages)
    if not tables:
        return np.full(mean.shape, nan)
    number = np.zeros(int(present[-1]) + 1, dtype=np.int64)
    number[present[present > 0]] = np.arange(len(tables))
    good = served & (median > 0.0)
    with np.errstate(all="ignore"):
        ratio = mean / median
    if not np.all(good):
        ratio[~good] = 0.0
    at = np.log(1.0 + np.minimum(ratio, _HIGHEST_RATIO))  # quicker than log1p
    found = _looked_up(tables, number[kinds], at)
    return found if np.all(good) else np.where(good, found, nan)


class _Table(NamedTuple):
    """Scores over ln(1 + T), straight between its places.

    places, scores, slopes: (places,), slopes up to the next; before: (cells,), the last place at or
    before the beginning of each of equal parts of the axis.
    """

    places: FloatArray
    scores: FloatArray
    slopes: FloatArray
    before: IntArray

    @classmethod
    def of(cls, places: FloatArray, scores: FloatArray) -> _Table:
        slopes = np.append(np.diff(scores) / np.diff(places), 0.0)
        cells = np.arange(int(places[-1] * _CELLS_PER_UNIT) + 2) / _CELLS_PER_UNIT
        return cls(places, scores, slopes, np.searchsorted(places, cells, side="right") - 1)


def _looked_up(tables: Sequence[_Table], which: IntArray, at: FloatArray) -> FloatArray:
    """What `numpy.interp` gives of tables of one range, each element of one of them; as `at`.

    which: the table's number, of a shape that broadcasts.

    In no order, which it takes a search for of every single one.
    """
    ends = np.cumsum([len(table.places) for table in tables])
    starts = np.append(0, ends[:-1])
    places, scores, slopes = (
        np.concatenate([table[part] for table in tables]) for part in range(3)
    )
    following = np.append(places[1:], np.inf)
    following[ends - 1] = np.inf
    before = np.stack([table.before + start for table, start in zip(tables, starts, strict=True)])
    cells = (at * _CELLS_PER_UNIT).astype(np.int64)
    found = before.ravel()[which * before.shape[1] + cells].ravel()
    flat = at.ravel()
    late = np.flatnonzero(flat >= following[found])
    while len(late) > 0:
        found[late] += 1
        late = late[flat[late] >= following[found[late]]]
    return np.asarray(slopes[found] * (flat - places[found]) + scores[found]).reshape(at.shape)


def mean_over_median(averages: int) -> float:
    """Mean of the power of noise lines over its median."""
    return float(averages / scipy.special.gammaincinv(averages, 0.5))


@cache
def _made(count: int, averages: int) -> dict[int, _Table]:
    """Tables that have been made, by the reach of the median."""
    return {}


def _scores_by_ratio(reaches: Sequence[int], count: int, averages: int) -> list[_Table]:
    """Tables of -ln p over ln(1 + T), one a reach."""
    made = _made(count, averages)
    new = [reach for reach in reaches if reach not in made]
    made.update(zip(new, _new_tables(new, count, averages), strict=True))
    return [made[reach] for reach in reaches]


def _new_tables(reaches: Sequence[int], count: int, averages: int) -> list[_Table]:
    """Tables that are densest about T = 1, where p falls fastest."""
    if not reaches:
        return []
    width = 12.0 / np.sqrt(averages * count)
    near = 1.0 + width * np.linspace(0.0, 1.0, _NEAR) ** 1.5
    above = np.concatenate([near, np.geomspace(1.0 + width, _HIGHEST_RATIO, _FAR)[1:]])
    low = max(0.0, 1.0 - width)
    start = np.linspace(0.0, low, 6)[:-1] if low > 0.0 else np.zeros(0)
    below = np.concatenate([start, np.linspace(low, 1.0, _NEAR)])
    under, over = [], []
    for reach in reaches:
        others, middle = 2 * reach + 1 - count, reach + 1 - count // 2
        under.append(_score(below, others, middle - (count == 1), count, averages))
        over.append(_score(above, others, middle, count, averages))
    at_under, found_under = _dense(below, under)
    at_over, found_over = _dense(above, over)
    places = np.concatenate([at_under[:-1], at_over])
    scores = np.concatenate([found_under[:-1], found_over])
    return [_Table.of(places, one) for one in scores.T]


def _dense(ratio: FloatArray, scores: Sequence[FloatArray]) -> tuple[FloatArray, FloatArray]:
    """Scores between given ones, over ln(1 + T); (places,) and (places, tables)."""
    places = np.log1p(ratio)
    steps = np.arange(_DENSER * (len(places) - 1) + 1) / _DENSER
    dense = np.interp(steps, np.arange(len(places)), places)
    return dense, _spline(places, np.stack(scores, axis=1), dense)


def _spline(places: FloatArray, values: FloatArray, at: FloatArray) -> FloatArray:
    """Cubic splines through some values, with the not-a-knot condition at the ends.

    `scipy.interpolate` takes as long to import as all else that a diagnosis does.

    values: (places, splines). Returns (at, splines).
    """
    steps = np.diff(places)
    slopes = np.diff(values, axis=0) / steps[:, None]
    matrix, right = np.zeros((len(places), len(places))), np.zeros_like(values)
    inner = np.arange(1, len(places) - 1)
    # of the slopes at the places: the second derivative is continuous at the inner ones,
    matrix[inner, inner - 1] = steps[1:]
    matrix[inner, inner] = 2.0 * (steps[1:] + steps[:-1])
    matrix[inner, inner + 1] = steps[:-1]
    right[1:-1] = 3.0 * (steps[1:, None] * slopes[:-1] + steps[:-1, None] * slopes[1:])
    # and the third at the outermost of these
    for end, neighbour, first, second in ((0, 1, 0, 1), (-1, -2, -1, -2)):
        both = steps[first] + steps[second]
        matrix[end, end], matrix[end, neighbour] = steps[second], both
        right[end] = (
            (steps[first] + 2.0 * both) * steps[second] * slopes[first]
            + steps[first] ** 2 * slopes[second]
        ) / both
    tangents = np.linalg.solve(matrix, right)
    piece = np.clip(np.searchsorted(places, at, side="right") - 1, 0, len(steps) - 1)
    t = ((at - places[piece]) / steps[piece])[:, None]
    h, below, above = steps[piece][:, None], values[piece], values[piece + 1]
    return np.asarray(
        below * (1.0 + 2.0 * t) * (1.0 - t) ** 2
        + above * t**2 * (3.0 - 2.0 * t)
        + h * t * (1.0 - t) * (tangents[piece] * (1.0 - t) - tangents[piece + 1] * t)
    )


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
    ends = scipy.special.betaincinv(rank, above + 1, np.array([_ENDS, 1.0 - _ENDS]))
    low, high = scipy.special.gammaincinv(averages, ends)
    x = low + (high - low) * nodes
    u = scipy.special.gammainc(averages, x)
    log_density = (
        scipy.special.xlogy(rank - 1, u)
        + scipy.special.xlog1py(above, -u)
        - scipy.special.betaln(rank, above + 1)
        + scipy.special.xlogy(averages - 1, x)
        - x
        - scipy.special.gammaln(averages)
    )
    log_weight = np.log(weights * (high - low)) + log_density
    tails = log_gamma_tail(averages * count, count * ratio[:, None] * x[None]) + log_weight
    greatest = np.max(tails, axis=1)
    return -np.asarray(greatest + np.log(np.sum(np.exp(tails - greatest[:, None]), axis=1)))


def log_gamma_tail(shape: float, x: FloatArray) -> FloatArray:
    """Logarithm of Q(shape, x), also where Q is too small for a number.

    There Q = x^(a-1) e^(-x)/Γ(a) · 1/(1 - (a-1)/(x + …)), the first terms of Legendre's continued
    fraction.
    """
    x = np.asarray(x, dtype=np.float64)
    tail = _gamma_tail(shape, x)
    is_far = ~(tail > 1e-280)
    found = np.log(tail, out=np.zeros_like(tail), where=~is_far)
    far = x[is_far]
    # 1/(x + 1 - a - (1 - a)/(x + 3 - a - 2 (2 - a)/(x + 5 - a)))
    last = far + 3.0 - shape - 2.0 * (2.0 - shape) / (far + 5.0 - shape)
    fraction = far + 1.0 - shape - (1.0 - shape) / last
    found[is_far] = (
        scipy.special.xlogy(shape, far) - far - scipy.special.gammaln(shape) - np.log(fraction)
    )
    return found


def _gamma_tail(shape: float, x: FloatArray) -> FloatArray:
    """Q(shape, x); of a small whole shape the quick sum e^-x Σ x^k/k!, NaN far out."""
    if shape > _FEW or shape != int(shape):
        return np.asarray(scipy.special.gammaincc(shape, x))
    series = np.ones_like(x)
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        for term in range(int(shape) - 1, 0, -1):
            series *= x / term
            series += 1.0
        return np.asarray(np.exp(-x) * series)
