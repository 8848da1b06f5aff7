"""Maximum likelihood of right-censored lives, thousands of samples at once.

With d_i failures among the v_i bearings of row i, r = Σ d, the scale drops out of the likelihood,

    η = (Σ v t^β / r)^(1/β),

and the shape is the one root of

    Σ v t^β ln t / Σ v t^β - 1/β - Σ d ln t / r = 0,

whose left side rises with β from minus infinity. Groups that share a shape but not a scale have
r, and the sums over v, of their own:

    Σ_g r_g (Σ v t^β ln t / Σ v t^β)_g - r/β - Σ d ln t = 0.

There is no root where all failures fall together and no bearing ran longer. Times count from the
longest of each group, so that no power overflows.

Sources: Cohen (1965); McCool (1970); for groups, McCool (1979).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root

CONVERGED: Final = 0
NO_FAILURES: Final = 1
NO_SPREAD: Final = 3
NOT_CONVERGED: Final = 4

_LEAST_SPREAD: Final = 1e-9
_TOLERANCE: Final = 1e-12
_AT_ONCE: Final = 60_000


class Rows(NamedTuple):
    """Right-censored lives of many samples.

    log_time: (samples, rows), of failure or suspension. failures, units: how many bearings failed
    at that time, and how many were under test until then and stopped, failed ones included; both
    (rows,) or (samples, rows). A row without units counts for nothing.
    """

    log_time: FloatArray
    failures: FloatArray
    units: FloatArray

    def part(self, which: slice | NDArray[np.bool_]) -> Rows:
        """Return some of the samples."""
        return Rows(*(array if array.ndim == 1 else array[which] for array in self))


class BatchFit(NamedTuple):
    """Fits of many samples; NaN where there is none.

    shape, code: (samples,). log_scale: (groups, samples), infinite for a group without failures.
    """

    shape: FloatArray
    log_scale: FloatArray
    code: NDArray[np.int64]


def fit_rows(rows: Rows) -> BatchFit:
    """Shape and scale of every sample; log_scale (1, samples)."""
    return fit_common_shape([rows])


def fit_common_shape(groups: Sequence[Rows]) -> BatchFit:
    """Shape that groups share, and the scale of each, for every sample.

    Parameters
    ----------
    groups : with the same number of samples each.
    """
    samples = len(groups[0].log_time)
    width = sum(rows.log_time.shape[1] for rows in groups)
    step = max(_AT_ONCE // width, 1)
    parts = [
        _fit([rows.part(slice(first, first + step)) for rows in groups])
        for first in range(0, samples, step)
    ]
    return joined(parts)


def joined(parts: Sequence[BatchFit]) -> BatchFit:
    """Put fits of samples one behind the other."""
    return BatchFit(
        np.concatenate([part.shape for part in parts]),
        np.concatenate([part.log_scale for part in parts], axis=1),
        np.concatenate([part.code for part in parts]),
    )


class _Group(NamedTuple):
    """A group with times from its longest: z ≤ 0, and the sums over its failures."""

    z: FloatArray
    units: FloatArray
    longest: FloatArray
    failures: FloatArray
    sum_failed: FloatArray

    def part(self, which: NDArray[np.bool_]) -> _Group:
        units = self.units if self.units.ndim == 1 else self.units[which]
        return _Group(
            self.z[which],
            units,
            self.longest[which],
            self.failures[which],
            self.sum_failed[which],
        )


def _fit(groups: Sequence[Rows]) -> BatchFit:
    """Fit so many samples as the processor's cache holds."""
    prepared = [_prepared(rows) for rows in groups]
    total = np.sum([group.failures for group in prepared], axis=0)
    reach = -np.sum([group.sum_failed for group in prepared], axis=0)
    code = np.full(len(total), CONVERGED, dtype=np.int64)
    code[reach <= _LEAST_SPREAD * total] = NO_SPREAD
    code[total == 0.0] = NO_FAILURES
    good = code == CONVERGED
    shape = np.full(len(total), np.nan)
    log_scale = np.full((len(groups), len(total)), np.nan)
    if np.any(good):
        fine = prepared if np.all(good) else [group.part(good) for group in prepared]
        shape[good], converged = _root(fine, total[good], reach[good])
        code[good] = np.where(converged, CONVERGED, NOT_CONVERGED)
        log_scale[:, good] = [_log_scale(group, shape[good]) for group in fine]
    return BatchFit(shape, log_scale, code)


def _prepared(rows: Rows) -> _Group:
    log_time, failures, units = rows
    present = units > 0.0
    longest = np.max(np.where(present, log_time, -np.inf), axis=1, initial=-np.inf)
    longest = np.where(np.isfinite(longest), longest, 0.0)
    z = np.where(present, log_time - longest[:, np.newaxis], 0.0)
    each = np.broadcast_to(failures, z.shape)
    return _Group(z, units, longest, each.sum(axis=1), np.einsum("ij,ij->i", each, z))


def _root(
    groups: Sequence[_Group], total: FloatArray, reach: FloatArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Root of the profile equation times β, which is nearly a straight line."""

    def function(shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        value, slope = reach.copy(), np.zeros_like(shape)
        for group in groups:
            mean, variance = _moments(group, shape)
            value += group.failures * mean
            slope += group.failures * variance
        return shape * value - total, value + shape * slope

    lower = total / reach
    return increasing_root(
        function, 1.3 * lower, lower, np.full_like(lower, np.inf), tolerance=_TOLERANCE
    )


def _moments(group: _Group, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Mean and variance of z, weighted with v t^β."""
    weight = np.exp(shape[:, np.newaxis] * group.z)
    weight *= group.units
    first = weight * group.z
    total = weight.sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):  # a group without bearings
        mean = first.sum(axis=1) / total
        variance = np.einsum("ij,ij->i", first, group.z) / total - mean * mean
    return np.nan_to_num(mean), np.nan_to_num(variance)


def _log_scale(group: _Group, shape: FloatArray) -> FloatArray:
    weight = np.exp(shape[:, np.newaxis] * group.z) * group.units
    with np.errstate(divide="ignore"):
        return np.asarray(
            group.longest + (np.log(weight.sum(axis=1)) - np.log(group.failures)) / shape
        )
