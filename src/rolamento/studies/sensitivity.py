"""Which input matters most: rank correlation of a scatter study, and Sobol's indices.

Rank correlation costs nothing beyond the study, holds for correlated inputs in its partial form,
and sees what rises or falls throughout. Sobol's indices share out the variance of an output among
independent inputs, whatever the shape of the function, and cost a study of their own.

Sources: Spearman (1904); Bonett and Wright, Psychometrika 65 (2000) 23, for the interval; Conover
(1999), section 5.4; Iman and Conover, Technometrics 21 (1979) 499, for regression on ranks; Sobol,
Mathematics and Computers in Simulation 55 (2001) 271; Saltelli et al., Computer Physics
Communications 181 (2010) 259.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.studies.laws import Law
from rolamento.studies.tolerance import (
    FINEST,
    FLAT,
    PERCENTILES,
    Samples,
    ToleranceBand,
    ToleranceBands,
    samples_of,
    tolerance_bands,
)
from rolamento.validate import share, whole_number
from rolamento.words import said

if TYPE_CHECKING:
    from xarray import Dataset

    from rolamento.studies.study import Study

Floats = NDArray[np.float64]

CORRELATED: Final = 5.0
"""Standard errors 1/√(n-1) of rank correlation beyond which two inputs count as correlated."""

_FEWEST: Final = 8
_LEAST_REST: Final = 1e-10  # of a variance: what the others do not explain


@frozen(eq=False)
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


@frozen(eq=False)
class RankCorrelations:
    """All outputs against all inputs.

    Attributes
    ----------
    inputs
        names, in the order of the arrays
    among_inputs
        (inputs, inputs) rank correlation of the inputs
    correlated
        whether any two inputs are, so that the partial coefficients show which matters
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
        """Return coefficient and interval that show what matters: partial if inputs correlate."""
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
    share(confidence, "confidence", "0.95")
    samples = samples_of(dataset)
    if not samples.inputs:
        raise InputError(said("has no scattered input"), field="scatter.fields")
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
    for name in samples.outputs:
        values = np.abs(samples.values(name))
        most = float(np.max(values, initial=0.0, where=np.isfinite(values)))
        greatest[units[name]] = max(greatest.get(units[name], 0.0), most)
    return {
        name: max(FLAT * greatest[units[name]], FINEST.get(units[name], 0.0))
        for name in samples.outputs
    }


def _against_inputs(
    name: str, samples: Samples, inputs: _InputRanks, floor: float, confidence: float
) -> RankCorrelation:
    values = samples.values(name)
    shape = values.shape[:-1]
    found = np.full((6, len(samples.inputs), *shape), np.nan)
    for place in np.ndindex(shape):
        there = np.isfinite(values[place])
        one = values[place][there]
        if len(one) >= _FEWEST and np.ptp(one) > floor:
            found[(slice(None), slice(None), *place)] = _coefficients(
                inputs.among(there), one, confidence
            )
    return RankCorrelation(name, samples.axes_of(name), *found)


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


Model = Callable[[Mapping[str, Floats]], Mapping[str, Floats]]

_MOST_RUNS: Final = 2**22
_RUNS_AT_ONCE: Final = 2**14


@frozen(eq=False)
class SobolIndices:
    """How the variance of each output is shared out among the inputs.

    Attributes
    ----------
    inputs, outputs
        names, in the order of the arrays
    first_order, first_low, first_high
        (outputs, inputs) part of the variance that an input makes by itself, with its
        confidence interval; NaN for an output that does not vary
    total, total_low, total_high
        (outputs, inputs) part in which an input has a hand, together with others or alone
    samples
        of the design
    runs
        of the model: samples (inputs + 2)
    confidence
        of the intervals
    """

    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    first_order: Floats
    first_low: Floats
    first_high: Floats
    total: Floats
    total_low: Floats
    total_high: Floats
    samples: int
    runs: int
    confidence: float


def sobol(
    study: Study,
    *,
    samples: int = 1024,
    confidence: float = 0.95,
    resamples: int = 200,
    threads: int | None = None,
) -> SobolIndices:
    """Find Sobol's indices of a study's outputs over its scattered fields.

    Parameters
    ----------
    study
        Its case, scatter, outputs and seed are used; its own count of draws is not.
    samples, confidence, resamples
        As in `sobol_of_model`.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If the study has axes or no scatter, its scattered fields are correlated, an output is
        one of each ball, or some draws have no result.
    """
    from rolamento.studies.fields import read_varied
    from rolamento.studies.plan import Plan

    scatter = study.scatter
    _check_study(study)
    assert scatter is not None
    laws = {
        name: distribution.law(read_varied(name), in_file=False)
        for name, distribution in scatter.fields.items()
    }
    plan = Plan(study)

    def model(inputs: Mapping[str, Floats]) -> dict[str, Floats]:
        return plan.values(inputs, threads)

    return sobol_of_model(
        model,
        laws,
        samples=samples,
        seed=study.seed,
        confidence=confidence,
        resamples=resamples,
        floors={one.name: FINEST.get(one.unit, 0.0) for one in plan.outputs},
    )


def _check_study(study: Study) -> None:
    if study.scatter is None:
        raise InputError(said("is missing: Sobol's indices need scattered fields"), field="scatter")
    for name in ("axes", "variants"):
        if getattr(study, name):
            raise InputError(
                said("must be left out for Sobol's indices, which are of one point"), field=name
            )
    correlated = next((one for one in study.scatter.correlations if one.coefficient != 0.0), None)
    if correlated is not None:
        raise InputError(
            said(
                "are given, but Sobol's indices need independent inputs; use rank "
                "correlation, whose partial form allows for it"
            ),
            field="scatter.correlations",
            value=" and ".join(correlated.fields),
        )
    for output in study.variables:
        if output.along:
            raise InputError(
                said(
                    "is one value for each ball; Sobol's indices are for outputs of the "
                    "whole bearing"
                )
                if output.along == "ball"
                else said(
                    "is one value for each row; Sobol's indices are for outputs of the whole "
                    "bearing"
                ),
                field="outputs",
                value=output.name,
                example=f"max_{output.name}" if output.along == "ball" else "max_inner_load",
            )


def sobol_of_model(
    model: Model,
    distributions: Mapping[str, Law],
    *,
    samples: int = 1024,
    seed: int = 0,
    confidence: float = 0.95,
    resamples: int = 200,
    floors: Mapping[str, float] | None = None,
) -> SobolIndices:
    """Find Sobol's indices of any function of independent inputs.

    Parameters
    ----------
    model
        Takes arrays of draws by input, gives arrays by output.
    distributions
        Of the inputs, by name.
    samples
        Of the design, a power of two from 16; the model runs samples (inputs + 2) times.
    seed
        Of the design and of the intervals.
    confidence
        Of the intervals, which are percentiles of bootstrap resamples.
    resamples
        Of the bootstrap, 10 to 10 000.
    floors
        By output, the extent below which it does not vary, beside a 1e-10th of its size.

    Raises
    ------
    InputError
        If a number is out of range, or the model has no result for some draws.

    The design is a scrambled Sobol sequence; the estimators are those of Saltelli et al. (2010),
    as `scipy.stats.sobol_indices` has them.
    """
    _check_numbers(samples, len(distributions), confidence, resamples)
    names = tuple(distributions)
    count = len(names)
    shares = _design(2 * count, samples, seed)
    first, second = (
        np.stack([_draws(distributions[name], half[i]) for i, name in enumerate(names)])
        for half in (shares[:count], shares[count:])
    )
    mixed = np.repeat(first[np.newaxis], count, axis=0)
    for i in range(count):
        mixed[i, i] = second[i]
    everything = np.concatenate([first, second, *mixed], axis=1)
    outputs, values = _run(model, names, everything)
    blocks = values.reshape(len(outputs), count + 2, samples)
    f_a, f_b, f_ab = blocks[:, 0], blocks[:, 1], np.moveaxis(blocks[:, 2:], 1, 0)
    finest = np.array([(floors or {}).get(name, 0.0) for name in outputs])
    flat = np.ptp(values, axis=1) <= np.maximum(FLAT * np.abs(values).max(axis=1), finest)
    point = _indices(f_a, f_b, f_ab)
    low, high = _bootstrap(f_a, f_b, f_ab, seed=seed, confidence=confidence, resamples=resamples)
    for array in (point, low, high):
        array[:, flat] = np.nan
    return SobolIndices(
        inputs=names,
        outputs=outputs,
        first_order=point[0],
        first_low=low[0],
        first_high=high[0],
        total=point[1],
        total_low=low[1],
        total_high=high[1],
        samples=samples,
        runs=everything.shape[1],
        confidence=confidence,
    )


def _check_numbers(samples: int, inputs: int, confidence: float, resamples: int) -> None:
    if samples < 16 or samples & (samples - 1):
        raise InputError(
            said("must be a power of two, at least 16"),
            field="samples",
            value=samples,
            example="1024",
        )
    if inputs < 1 or samples * (inputs + 2) > _MOST_RUNS:
        raise InputError(
            said(
                "would need {samples} runs with {inputs} inputs; at most {most} are allowed",
                samples=samples * (inputs + 2),
                inputs=inputs,
                most=_MOST_RUNS,
            ),
            field="samples",
            value=samples,
            example="1024",
        )
    share(confidence, "confidence", "0.95")
    whole_number(resamples, "resamples", 10, 10_000, "100")


def _design(dimensions: int, samples: int, seed: int) -> Floats:
    """Return a scrambled Sobol sequence; (dimensions, samples) shares in (0, 1)."""
    import scipy
    from scipy.stats import qmc

    release = tuple(int(part) for part in scipy.__version__.split(".")[:2])
    keyword = "rng" if release >= (1, 15) else "seed"
    generator = np.random.default_rng(seed)
    sequence = qmc.Sobol(dimensions, scramble=True, bits=52, **{keyword: generator})
    # a share of exactly 0 would be infinitely far out
    drawn = np.asarray(sequence.random(samples), dtype=np.float64).T
    return np.asarray(np.clip(drawn, 2.0**-53, 1.0 - 2.0**-53))


def _draws(distribution: Law, shares: Floats) -> Floats:
    return np.asarray(distribution.quantile(shares), dtype=np.float64)


def _run(model: Model, names: Sequence[str], draws: Floats) -> tuple[tuple[str, ...], Floats]:
    """Run the model for all draws, in parts; refuse draws without a result."""
    parts: list[Mapping[str, Floats]] = []
    for begin in range(0, draws.shape[1], _RUNS_AT_ONCE):
        chunk = draws[:, begin : begin + _RUNS_AT_ONCE]
        parts.append(model(dict(zip(names, chunk, strict=True))))
    outputs = tuple(parts[0])
    values = np.stack([np.concatenate([part[name] for part in parts]) for name in outputs])
    failed = ~np.isfinite(values).all(axis=0)
    if failed.any():
        raise InputError(
            said(
                "{failed} of {count} draws have no result, and Sobol's indices need "
                "them all; narrow the distributions, or use rank correlation, which "
                "leaves them out",
                failed=int(failed.sum()),
                count=len(failed),
            ),
            field="scatter.fields",
        )
    return outputs, values


def _indices(f_a: Floats, f_b: Floats, f_ab: Floats) -> Floats:
    """First-order and total indices; (2, outputs, inputs)."""
    from scipy.stats import sobol_indices

    # what does not vary divides by zero, and is NaN
    with np.errstate(divide="ignore", invalid="ignore"):
        found = sobol_indices(func={"f_A": f_a, "f_B": f_b, "f_AB": f_ab}, n=f_a.shape[1])
    return np.stack([np.atleast_2d(found.first_order), np.atleast_2d(found.total_order)])


def _bootstrap(
    f_a: Floats, f_b: Floats, f_ab: Floats, *, seed: int, confidence: float, resamples: int
) -> tuple[Floats, Floats]:
    """Percentile intervals over resamples of the design; each (2, outputs, inputs)."""
    generator = np.random.default_rng([seed, 1])
    count = f_a.shape[1]
    found = []
    for _ in range(resamples):
        drawn = generator.integers(0, count, count)
        found.append(_indices(f_a[:, drawn], f_b[:, drawn], f_ab[..., drawn]))
    tail = 0.5 * (1.0 - confidence)
    low, high = np.quantile(np.stack(found), [tail, 1.0 - tail], axis=0)
    return low, high


@frozen(eq=False)
class ToleranceStudy:
    """What is known of a scatter study: its result taken apart.

    Attributes
    ----------
    title
        of the study
    samples
        what was drawn, and what came out
    bands
        percentiles of the outputs
    ranks
        of outputs and inputs; None without inputs
    sobol
        indices, if they were asked for
    """

    title: str
    samples: Samples
    bands: ToleranceBands
    ranks: RankCorrelations | None
    sobol: SobolIndices | None = None

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain values and arrays, in SI units."""
        bands = self.bands
        mapping: dict[str, Any] = {
            "schema": 1,
            "kind": "tolerance",
            "title": self.title,
            "samples": bands.samples,
            "without_result": bands.without_result,
            "failures": dict(bands.failures),
            "axes": {name: _coordinate(self.samples, name) for name in self.samples.axes},
            "inputs": {
                one.name: {"field": one.field, "units": one.units} for one in self.samples.inputs
            },
            "confidence": bands.confidence,
            "percentiles": bands.percentiles,
            "outputs": {band.name: _band_mapping(band) for band in bands.bands},
        }
        if self.ranks is not None:
            mapping["rank_correlation"] = _rank_mapping(self.ranks)
        if self.sobol is not None:
            names = ("first_order", "first_low", "first_high", "total", "total_low", "total_high")
            sobol = self.sobol
            mapping["sobol"] = {
                "inputs": sobol.inputs,
                "outputs": sobol.outputs,
                "samples": sobol.samples,
                "runs": sobol.runs,
                "confidence": sobol.confidence,
                **{name: getattr(sobol, name) for name in names},
            }
        return mapping

    @classmethod
    def of(
        cls,
        dataset: Dataset,
        percentiles: Sequence[float] = PERCENTILES,
        sobol: SobolIndices | None = None,
    ) -> ToleranceStudy:
        """Take a scatter study's result apart.

        Raises
        ------
        InputError
            If it has no scatter, or a percentile is out of range.
        """
        samples = samples_of(dataset)
        return cls(
            title=str(dataset.attrs.get("title", "")),
            samples=samples,
            bands=tolerance_bands(dataset, percentiles),
            ranks=rank_correlation(dataset) if samples.inputs else None,
            sobol=sobol,
        )


def _coordinate(samples: Samples, name: str) -> Any:
    coordinate = samples.coordinates.get(name)
    return None if coordinate is None else np.asarray(coordinate.values)


def _band_mapping(band: ToleranceBand) -> dict[str, Any]:
    return {
        "long_name": band.long_name,
        "units": band.units,
        "axes": band.axes,
        "count": band.count,
        "mean": band.mean,
        "standard_deviation": band.standard_deviation,
        "percentile": band.percentile,
        "low": band.low,
        "high": band.high,
    }


def _rank_mapping(ranks: RankCorrelations) -> dict[str, Any]:
    names = ("coefficient", "low", "high", "partial", "partial_low", "partial_high")
    return {
        "inputs": ranks.inputs,
        "among_inputs": ranks.among_inputs,
        "correlated": ranks.correlated,
        "confidence": ranks.confidence,
        "outputs": {
            one.output: {name: getattr(one, name) for name in names} for one in ranks.outputs
        },
    }
