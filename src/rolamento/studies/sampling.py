"""Draws that can be made in any order: counted, not consumed.

Draw i of a field follows from the seed, the field's name and i alone, by the counter-based
generator Philox (Salmon et al., 2011). So neither the order of the work nor its division among
threads and machines changes a sample, and another field beside it changes none of its draws.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from hashlib import blake2b
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.studies import fields

if TYPE_CHECKING:
    from rolamento.studies.scatter import Scatter

__all__ = ["Law", "Sampler", "factor_of", "truncated_normal", "uniform"]

Floats = NDArray[np.float64]

_LEAST_PIVOT: Final = 1e-12
_LEAST_REST: Final = 1e-6


class Law(NamedTuple):
    """A distribution in numbers: normal of a mean, or uniform without one, between two bounds."""

    mean: float | None
    spread: float
    low: float
    high: float

    def quantile(self, probability: Floats) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        from scipy.special import ndtri

        if self.mean is None:
            drawn = self.low + (self.high - self.low) * probability
        elif math.isinf(self.low) and math.isinf(self.high):
            drawn = self.mean + self.spread * ndtri(probability)
        else:
            low, high = (self.low - self.mean) / self.spread, (self.high - self.mean) / self.spread
            drawn = self.mean + self.spread * truncated_normal(probability, low, high)
        return np.clip(drawn, self.low, self.high)


def truncated_normal(probability: Floats, low: float, high: float) -> Floats:
    """Quantile of the standard normal distribution cut off at two bounds.

    In logarithms, and in the left tail whichever side it is: exact however far out the bounds.
    """
    from scipy.special import log_ndtr, ndtri_exp

    if low > 0.0:
        return -truncated_normal(1.0 - probability, -high, -low)
    below = np.log1p(-probability) + log_ndtr(low)
    return np.asarray(ndtri_exp(np.logaddexp(below, np.log(probability) + log_ndtr(high))))


def factor_of(matrix: Floats) -> Floats:
    """Cholesky factor of a correlation matrix, which may be singular.

    In plain loops rather than by LAPACK: the same bits on every machine.

    Raises
    ------
    InputError
        If the matrix is not positive semi-definite.
    """
    size = len(matrix)
    rest, factor = matrix.copy(), np.zeros((size, size))
    for j in range(size):
        pivot = float(rest[j, j])
        column = rest[j:, j].copy()
        if pivot > _LEAST_PIVOT:
            factor[j:, j] = column / math.sqrt(pivot)
        elif pivot < -_LEAST_PIVOT or np.abs(column).max() > _LEAST_REST:
            least = float(np.linalg.eigvalsh(matrix).min())
            raise InputError(
                "contradict each other: no fields can have them all (the matrix is not positive "
                f"semi-definite: its least eigenvalue is {least:.3g})",
                field="correlations",
            )
        rest[j:, j:] -= np.outer(factor[j:, j], factor[j:, j])
    return factor


class Sampler:
    """Draws of a scatter, from any one to any other."""

    def __init__(self, scatter: Scatter, seed: int) -> None:
        self._names = tuple(scatter.fields)
        self._laws = [
            distribution.law(fields.read_field(name), in_file=False)
            for name, distribution in scatter.fields.items()
        ]
        self._factor = factor_of(scatter.matrix())
        self._seed = seed

    def draw(self, first: int, last: int) -> dict[str, Floats]:
        """Return draws `first` to `last` - 1 of every field, SI units."""
        shares = [uniform(self._seed, name, first, last) for name in self._names]
        return {
            name: law.quantile(share)
            for name, law, share in zip(
                self._names, self._laws, self._correlated(shares), strict=True
            )
        }

    def _correlated(self, shares: Sequence[Floats]) -> list[Floats]:
        """Turn independent shares into correlated ones, by way of normal scores."""
        from scipy.special import ndtr, ndtri

        if (self._factor == np.eye(len(shares))).all():
            return list(shares)
        mixed = []
        scores: Mapping[int, Floats] = {i: ndtri(share) for i, share in enumerate(shares)}
        for i, row in enumerate(self._factor):
            weights = np.flatnonzero(row)
            if list(weights) == [i]:
                mixed.append(shares[i])
                continue
            score = np.zeros_like(shares[i])
            for j in weights:
                score += row[j] * scores[int(j)]
            # A share of exactly 0 or 1 would be infinitely far out.
            mixed.append(np.clip(ndtr(score), 2.0**-53, 1.0 - 2.0**-53))
        return mixed


def uniform(seed: int, name: str, first: int, last: int) -> Floats:
    """Draws `first` to `last` - 1 of a stream, uniform in the open interval (0, 1).

    Philox gives four numbers for each value of its counter; 52 bits of each make a share in the
    middle of its cell, so that neither 0 nor 1 occurs.
    """
    key = int.from_bytes(blake2b(f"{seed} {name}".encode(), digest_size=16).digest(), "little")
    counter = first // 4
    generator = np.random.Philox(counter=counter, key=key)
    bits = generator.random_raw(last - 4 * counter)[first - 4 * counter :]
    return ((bits >> np.uint64(12)).astype(np.float64) + 0.5) * 2.0**-52
