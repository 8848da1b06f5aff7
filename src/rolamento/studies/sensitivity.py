"""Which input matters most: rank correlation of a scatter study, and Sobol's indices.

Rank correlation costs nothing beyond the study, holds for correlated inputs in its partial form,
and sees what rises or falls throughout. Sobol's indices share out the variance of an output among
independent inputs, whatever the shape of the function, and cost a study of their own.

Sources: Spearman (1904); Bonett and Wright, Psychometrika 65 (2000) 23, for the interval; Conover
(1999), section 5.4; Iman and Conover, Technometrics 21 (1979) 499, for regression on ranks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.studies.samples import FINEST, FLAT, SAMPLE, Samples, samples_of
from rolamento.studies.sobol_indices import HasQuantile, SobolIndices, sobol, sobol_of_model

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = [
    "CORRELATED",
    "HasQuantile",
    "RankCorrelation",
    "RankCorrelations",
    "SobolIndices",
    "rank_correlation",
    "sobol",
    "sobol_of_model",
]

Floats = NDArray[np.float64]

CORRELATED: Final = 5.0
"""Standard errors 1/√(n-1) of rank correlation beyond which two inputs count as correlated."""

_FEWEST: Final = 8
_LEAST_REST: Final = 1e-9  # of an input that the others do not explain


@dataclass(frozen=True, slots=True, eq=False)
class RankCorrelation:
    """One output against every input; NaN where an output does not vary or samples are too few.

    Attributes
    ----------
    output
        its name
    axes
        dimensions that remain: those of the arrays after the first
    coefficient, low, high
        (inputs, …) Spearman's, with its confidence interval
    partial, partial_low, partial_high
        (inputs, …) with the other inputs' part taken out of both
    """

    output: str
    axes: tuple[str, ...]
    coefficient: Floats
    low: Floats
    high: Floats
    partial: Floats
    partial_low: Floats
    partial_high: Floats


@dataclass(frozen=True, slots=True, eq=False)
class RankCorrelations:
    """All outputs against all inputs.

    Attributes
    ----------
    inputs
        names, in the order of the arrays
    among_inputs
        (inputs, inputs) rank correlation of the inputs
    correlated
        whether any two inputs are, so that the partial coefficients tell which matters
    confidence
        of the intervals
    outputs
        one for each output
    """

    inputs: tuple[str, ...]
    among_inputs: Floats
    correlated: bool
    confidence: float
    outputs: tuple[RankCorrelation, ...]

    def __getitem__(self, name: str) -> RankCorrelation:
        """Return the coefficients of an output."""
        for output in self.outputs:
            if output.output == name:
                return output
        raise KeyError(name)

    def telling(self, name: str) -> tuple[Floats, Floats, Floats]:
        """Return coefficient and interval that tell what matters: partial if inputs correlate."""
        one = self[name]
        if self.correlated:
            return one.partial, one.partial_low, one.partial_high
        return one.coefficient, one.low, one.high

    def ranking(self, name: str, place: tuple[int, ...] = ()) -> tuple[int, ...]:
        """Return the places of the inputs, the one that matters most first; none without rank."""
        values: Floats = np.abs(np.moveaxis(self.telling(name)[0], 0, -1)[place])
        order = np.argsort(-np.where(np.isnan(values), -1.0, values), kind="stable")
        return tuple(int(i) for i in order if not math.isnan(values[i]))


def rank_correlation(dataset: Dataset, *, confidence: float = 0.95) -> RankCorrelations:
    """Correlate every output of a scatter study with every input, by ranks.

    Parameters
    ----------
    dataset
        A study's result with the dimension ``"sample"``; further dimensions remain.
    confidence
        Of the intervals, above 0 and below 1.

    Raises
    ------
    InputError
        If the result has no scatter, or no input that is scattered.

    Samples without a result are left out; `tolerance_bands` counts them.
    """
    if not 0.0 < confidence < 1.0:
        raise InputError("must be between 0 and 1", field="confidence", value=confidence)
    samples = samples_of(dataset)
    if not samples.inputs:
        raise InputError("has no scattered input", field="scatter.fields")
    inputs = np.stack([one.values for one in samples.inputs])
    among = _spearman(inputs)
    limit = CORRELATED / math.sqrt(max(len(samples) - 1, 1))
    apart = ~np.eye(len(inputs), dtype=bool)
    floors = _floors(samples)
    return RankCorrelations(
        inputs=tuple(one.name for one in samples.inputs),
        among_inputs=among,
        correlated=bool(np.any(np.abs(among[apart]) > limit)),
        confidence=confidence,
        outputs=tuple(
            _against_inputs(name, samples, inputs, floors[name], confidence)
            for name in samples.outputs
        ),
    )


def _floors(samples: Samples) -> dict[str, float]:
    """Below which an output does not vary: on the scale of the outputs in its unit, or of any."""
    greatest: dict[str, float] = {}
    units = {name: str(array.attrs.get("units", "")) for name, array in samples.outputs.items()}
    for name, array in samples.outputs.items():
        values = np.abs(np.asarray(array.where(samples.solved).values, dtype=np.float64))
        most = float(np.max(values, initial=0.0, where=np.isfinite(values)))
        greatest[units[name]] = max(greatest.get(units[name], 0.0), most)
    return {
        name: max(FLAT * greatest[units[name]], FINEST.get(units[name], 0.0))
        for name in samples.outputs
    }


def _against_inputs(
    name: str, samples: Samples, inputs: Floats, floor: float, confidence: float
) -> RankCorrelation:
    array = samples.outputs[name]
    masked = array.where(samples.solved).transpose(..., SAMPLE)
    values = np.asarray(masked.values, dtype=np.float64)
    shape = values.shape[:-1]
    found = np.full((6, len(inputs), *shape), np.nan)
    for place in np.ndindex(shape):
        there = np.isfinite(values[place])
        one = values[place][there]
        if len(one) >= _FEWEST and np.ptp(one) > floor:
            found[(slice(None), slice(None), *place)] = _coefficients(
                inputs[:, there], one, confidence
            )
    return RankCorrelation(name, tuple(str(axis) for axis in masked.dims[:-1]), *found)


def _coefficients(inputs: Floats, output: Floats, confidence: float) -> Floats:
    """Plain and partial coefficients with their intervals; (6, inputs)."""
    count, samples = inputs.shape
    plain = _spearman(np.vstack([inputs, output]))[-1, :-1]
    partial = _partial(inputs, output)
    return np.stack(
        [
            plain,
            *_interval(plain, samples, confidence),
            partial,
            *_interval(partial, samples - (count - 1), confidence),
        ]
    )


def _spearman(variables: Floats) -> Floats:
    """Spearman's coefficients of all pairs; NaN for what is constant, 1 of each with itself."""
    from scipy.stats import spearmanr

    varies = np.flatnonzero(np.ptp(variables, axis=1) > 0.0)
    matrix = np.full((len(variables),) * 2, np.nan)
    np.fill_diagonal(matrix, 1.0)
    if len(varies) == 2:
        i, j = varies
        matrix[i, j] = matrix[j, i] = spearmanr(variables[i], variables[j]).statistic
    elif len(varies) > 2:
        matrix[np.ix_(varies, varies)] = spearmanr(variables[varies], axis=1).statistic
    return matrix


def _partial(inputs: Floats, output: Floats) -> Floats:
    """Correlation of the ranks of output and input, each without what the other inputs explain."""
    from scipy.stats import rankdata

    ranks = rankdata(inputs, axis=1)
    ranks -= ranks.mean(axis=1, keepdims=True)
    target = rankdata(output)
    target -= target.mean()
    coefficients = np.full(len(ranks), np.nan)
    for index, own in enumerate(ranks):
        others = np.delete(ranks, index, axis=0).T
        rests = np.stack([own, target], axis=1)
        if others.shape[1]:
            rests -= others @ np.linalg.lstsq(others, rests, rcond=None)[0]
        own_rest, target_rest = np.linalg.norm(rests, axis=0)
        if own_rest <= _LEAST_REST * max(float(np.linalg.norm(own)), 1.0):
            continue  # a constant, or a copy of the others
        product = own_rest * target_rest
        coefficients[index] = rests[:, 0] @ rests[:, 1] / product if product > 0.0 else 0.0
    return np.asarray(np.clip(coefficients, -1.0, 1.0))


def _interval(coefficient: Floats, samples: int, confidence: float) -> tuple[Floats, Floats]:
    """Interval by Fisher's transform with the standard error of Bonett and Wright (2000)."""
    from scipy.special import ndtri

    if samples <= 3:
        return np.full_like(coefficient, np.nan), np.full_like(coefficient, np.nan)
    within = np.clip(coefficient, -1.0 + 1e-15, 1.0 - 1e-15)
    error = np.sqrt((1.0 + 0.5 * within**2) / (samples - 3))
    half = float(ndtri(0.5 * (1.0 + confidence))) * error
    middle = np.arctanh(within)
    return np.tanh(middle - half), np.tanh(middle + half)
