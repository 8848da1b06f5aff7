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
_LEAST_REST: Final = 1e-10  # of a variance: what the others do not explain


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
    inputs = _InputRanks(np.stack([one.values for one in samples.inputs]))
    among = _correlation(inputs.among(np.ones(len(samples), dtype=bool)))
    limit = CORRELATED / math.sqrt(max(len(samples) - 1, 1))
    apart = ~np.eye(len(among), dtype=bool)
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
    name: str, samples: Samples, inputs: _InputRanks, floor: float, confidence: float
) -> RankCorrelation:
    array = samples.outputs[name]
    masked = array.where(samples.solved).transpose(..., SAMPLE)
    values = np.asarray(masked.values, dtype=np.float64)
    shape = values.shape[:-1]
    found = np.full((6, len(samples.inputs), *shape), np.nan)
    for place in np.ndindex(shape):
        there = np.isfinite(values[place])
        one = values[place][there]
        if len(one) >= _FEWEST and np.ptp(one) > floor:
            found[(slice(None), slice(None), *place)] = _coefficients(
                inputs.among(there), one, confidence
            )
    return RankCorrelation(name, tuple(str(axis) for axis in masked.dims[:-1]), *found)


def _coefficients(inputs: Floats, output: Floats, confidence: float) -> Floats:
    """Plain and partial coefficients with intervals, from the ranks of the inputs; (6, inputs)."""
    count, samples = inputs.shape
    matrix = _correlation(np.vstack([inputs, _ranks(output[np.newaxis])]))
    plain, partial = matrix[-1, :-1], _partial(matrix)
    return np.stack(
        [
            plain,
            *_interval(plain, samples, confidence),
            partial,
            *_interval(partial, samples - (count - 1), confidence),
        ]
    )


class _InputRanks:
    """Ranks of the inputs among some of the samples; kept, as the next output takes the same."""

    def __init__(self, inputs: Floats) -> None:
        self._inputs = inputs
        self._among: NDArray[np.bool_] = np.ones(0, dtype=bool)
        self._found: Floats = inputs

    def among(self, samples: NDArray[np.bool_]) -> Floats:
        if not np.array_equal(samples, self._among):
            self._among, self._found = samples, _ranks(self._inputs[:, samples])
        return self._found


def _ranks(variables: Floats) -> Floats:
    from scipy.stats import rankdata

    return np.asarray(rankdata(variables, axis=1), dtype=np.float64)


def _correlation(ranks: Floats) -> Floats:
    """Spearman's coefficients of all pairs; NaN for what is constant, 1 of each with itself.

    Pearson's of the ranks, as `scipy.stats.spearmanr` has them.
    """
    varies = np.flatnonzero(np.ptp(ranks, axis=1) > 0.0)
    matrix = np.full((len(ranks),) * 2, np.nan)
    matrix[np.ix_(varies, varies)] = np.corrcoef(ranks[varies]) if len(varies) else np.nan
    np.fill_diagonal(matrix, 1.0)
    return matrix


def _partial(matrix: Floats) -> Floats:
    """Correlation of the ranks of output and input, each without what the other inputs explain.

    matrix: of the ranks of inputs and output, the output last. With P the (pseudo-)inverse of the
    others' part and c their correlations, what is left of i and j together is r_ij - c_i P c_j.
    """
    output = len(matrix) - 1
    varying = [index for index in range(output) if np.isfinite(matrix[index, output])]
    coefficients = np.full(output, np.nan)
    for own in varying:
        others = [index for index in varying if index != own]
        pair = [own, output]
        explained = matrix[np.ix_(others, pair)]
        inverse = np.linalg.pinv(matrix[np.ix_(others, others)], hermitian=True)
        left = matrix[np.ix_(pair, pair)] - explained.T @ inverse @ explained
        if left[0, 0] <= _LEAST_REST:
            continue  # a copy of the others
        scale = math.sqrt(left[0, 0] * max(float(left[1, 1]), 0.0))
        coefficients[own] = left[0, 1] / scale if left[1, 1] > _LEAST_REST else 0.0
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
