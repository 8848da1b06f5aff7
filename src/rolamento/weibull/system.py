"""Life of bearings in series: a machine that stops with the first of them.

The reliabilities multiply. If all have one shape e, lives for one reliability add up as

    L = (Σ L_i^(-e))^(-1/e),

with e = 10/9 for ball and 9/8 for roller bearings in the standards' ratings. With several shapes
there is no formula for the life: the product is inverted numerically.

Sources: Lundberg and Palmgren (1947); ISO 281:2007 for the exponents.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.validate import numbers, one_of, shares
from rolamento.weibull.limits import shape_of
from rolamento.words import said

EXPONENTS: Final = {"ball": 10.0 / 9.0, "roller": 9.0 / 8.0}
"""Weibull exponent of the standards' ratings."""
_MAXIMUM_PARTS: Final = 100_000


def system_rating_life(
    lives: ArrayLike,
    kind: Literal["ball", "roller"] = "ball",
    *,
    exponent: float | None = None,
) -> FloatArray:
    """Life of bearings that all have to last, for the reliability that theirs are for.

    Parameters
    ----------
    lives : array (..., bearings), above zero; in one unit. Infinite for one that never fails.
    kind : "ball" (10/9) or "roller" (9/8).
    exponent : another one, in place of the kind's.

    Returns
    -------
    array (...), in the unit of the lives.

    >>> print(f"{system_rating_life([1000.0, 1000.0]):.0f} million revolutions")
    536 million revolutions
    """
    one_of(kind, "kind", EXPONENTS)
    e = EXPONENTS[kind] if exponent is None else shape_of(exponent, "exponent")
    array = _positive_numbers(lives, "lives")
    shortest = array.min(axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(np.isinf(array), 0.0, shortest[..., np.newaxis] / array)
        return np.where(
            np.isinf(shortest), np.inf, shortest * np.sum(ratio**e, axis=-1) ** (-1.0 / e)
        )


def series_reliability(
    time: ArrayLike, shapes: ArrayLike, scales: ArrayLike, locations: ArrayLike = 0.0
) -> FloatArray:
    """Product of the reliabilities of Weibull distributions.

    Parameters
    ----------
    time : array.
    shapes, scales, locations : (bearings,), β, η, γ; one number stands for all.

    Returns
    -------
    R of the shape of the times.

    >>> print(f"{series_reliability(1000.0, [1.0, 1.0], [1000.0, 1000.0]):.4f}")
    0.1353
    """
    beta, eta, gamma = _distributions(shapes, scales, locations)
    t = numbers(time, "time", "[100.0, 200.0]")
    with np.errstate(over="ignore"):
        risk = np.sum((np.maximum(t[..., np.newaxis] - gamma, 0.0) / eta) ** beta, axis=-1)
    return np.asarray(np.exp(-risk))


def series_life(
    reliability: ArrayLike, shapes: ArrayLike, scales: ArrayLike, locations: ArrayLike = 0.0
) -> FloatArray:
    """Time that a series of bearings reaches with a reliability; any shapes.

    Parameters
    ----------
    reliability : array, between 0 and 1.
    shapes, scales, locations : (bearings,), β, η, γ; one number stands for all.

    Returns
    -------
    t of the shape of the reliabilities.
    """
    beta, eta, gamma = _distributions(shapes, scales, locations)
    risk = -np.log(shares(reliability, "reliability"))
    with np.errstate(over="ignore"):
        alone = gamma + eta * (risk[..., np.newaxis] / len(beta)) ** (1.0 / beta)
        least = alone.min(axis=-1)  # all have at least this share of the risk left
        most = (gamma + eta * risk[..., np.newaxis] ** (1.0 / beta)).min(axis=-1)

    def excess(t: FloatArray) -> tuple[FloatArray, FloatArray]:
        past = np.maximum(t[..., np.newaxis] - gamma, 0.0) / eta
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            terms = past**beta
            slope = np.where(past > 0.0, beta * terms / (past * eta), 0.0)
            total = terms.sum(axis=-1)
            return np.log(total / risk), slope.sum(axis=-1) / total

    start = 0.5 * (least + most)
    return increasing_root(excess, start, least, np.maximum(most, least))[0]


def lives_of_series(
    log_risk: FloatArray | float, shapes: FloatArray, log_scales: FloatArray
) -> FloatArray:
    """Logarithm of the time by which a series has used up a risk -ln R; of many series at once.

    Parameters
    ----------
    log_risk : ln(-ln R), a number or (...).
    shapes, log_scales : (..., parts), β and ln η of each part.

    Returns
    -------
    (...) ln t; NaN where there is none.
    """
    wanted = np.broadcast_to(np.asarray(log_risk, dtype=float), shapes.shape[:-1])
    each = wanted[..., np.newaxis]
    least = (log_scales + (each - np.log(shapes.shape[-1])) / shapes).min(axis=-1)
    most = (log_scales + each / shapes).min(axis=-1)  # one part alone uses up less than all

    def excess(y: FloatArray) -> tuple[FloatArray, FloatArray]:
        z = shapes * (y[..., np.newaxis] - log_scales)
        top = z.max(axis=-1)
        terms = np.exp(z - top[..., np.newaxis])
        total = terms.sum(axis=-1)
        return np.log(total) + top - wanted, np.sum(shapes * terms, axis=-1) / total

    return increasing_root(excess, 0.5 * (least + most), least, np.maximum(most, least))[0]


def _distributions(
    shapes: ArrayLike, scales: ArrayLike, locations: ArrayLike
) -> tuple[FloatArray, FloatArray, FloatArray]:
    beta, eta = _positive_numbers(shapes, "shapes"), _positive_numbers(scales, "scales")
    gamma = numbers(locations, "locations", "[0.0, 0.0]")
    try:
        beta, eta, gamma = np.broadcast_arrays(beta, eta, np.atleast_1d(gamma))
    except ValueError:  # of several lengths
        gamma = np.array([np.nan])
    if not np.all((gamma >= 0.0) & np.isfinite(gamma)) or beta.ndim != 1:
        raise InputError(
            said("must be one non-negative number for each bearing"),
            field="locations",
            example="[0.0, 0.0]",
        )
    if not (np.all(np.isfinite(eta)) and np.all(beta <= 1000.0)):
        raise InputError(said("must be finite, and the shapes at most 1000"), field="scales")
    return beta, eta, gamma


def _positive_numbers(values: ArrayLike, field: str) -> FloatArray:
    array = np.atleast_1d(numbers(values, field, "[1000.0, 800.0]"))
    if array.shape[-1] > _MAXIMUM_PARTS or not array.size or not np.all(array > 0.0):
        raise InputError(
            said("must be from 1 to {most} positive numbers", most=_MAXIMUM_PARTS),
            field=field,
            example="[1000.0, 800.0]",
        )
    return array
