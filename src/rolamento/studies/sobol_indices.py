"""Sobol's indices: how the variance of an output is shared out among independent inputs.

Sources: Sobol, Mathematics and Computers in Simulation 55 (2001) 271; Saltelli et al., Computer
Physics Communications 181 (2010) 259.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.studies.samples import FINEST, FLAT

if TYPE_CHECKING:
    from rolamento.studies.study import Study

__all__ = ["HasQuantile", "SobolIndices", "sobol", "sobol_of_model"]

Floats = NDArray[np.float64]
Model = Callable[[Mapping[str, Floats]], Mapping[str, Floats]]

_MOST_RUNS: Final = 2**22
_RUNS_AT_ONCE: Final = 2**14


class HasQuantile(Protocol):
    """A distribution: gives the value below which a share of the draws lies."""

    def quantile(self, probability: Floats, /) -> Floats:
        """Return values for shares in (0, 1)."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
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
    from rolamento.studies.fields import read_field
    from rolamento.studies.outputs import Solved, outputs_of
    from rolamento.studies.solving import solve

    scatter = study.scatter
    _check_study(study)
    assert scatter is not None
    laws = {
        name: distribution.law(read_field(name), in_file=False)
        for name, distribution in scatter.fields.items()
    }
    outputs = outputs_of(study.outputs)

    def model(inputs: Mapping[str, Floats]) -> dict[str, Floats]:
        cases = len(next(iter(inputs.values())))
        batch = solve(study.case, inputs, cases=cases, threads=threads)
        solved = Solved(batch, study.case, inputs)
        return {one.name: np.asarray(one.compute(solved), np.float64) for one in outputs}

    return sobol_of_model(
        model,
        laws,
        samples=samples,
        seed=study.seed,
        confidence=confidence,
        resamples=resamples,
        floors={one.name: FINEST.get(one.unit, 0.0) for one in outputs},
    )


def _check_study(study: Study) -> None:
    from rolamento.studies.outputs import outputs_of

    if study.scatter is None:
        raise InputError("is missing: Sobol's indices are of scattered fields", field="scatter")
    if study.axes:
        raise InputError("must be left out for Sobol's indices: one point at a time", field="axes")
    correlated = next((one for one in study.scatter.correlations if one.coefficient != 0.0), None)
    if correlated is not None:
        raise InputError(
            "are given, but Sobol's indices need independent inputs; use rank correlation, whose"
            " partial form allows for it",
            field="scatter.correlations",
            value=" and ".join(correlated.fields),
        )
    for output in outputs_of(study.outputs):
        if output.per_ball:
            raise InputError(
                "is one for each ball; Sobol's indices take outputs of the whole bearing",
                field="outputs",
                value=output.name,
                example=f"max_{output.name}",
            )


def sobol_of_model(
    model: Model,
    distributions: Mapping[str, HasQuantile],
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
            "must be a power of two, at least 16", field="samples", value=samples, example="1024"
        )
    if inputs < 1 or samples * (inputs + 2) > _MOST_RUNS:
        raise InputError(
            f"make {samples * (inputs + 2)} runs with {inputs} inputs; 1 to {_MOST_RUNS} are run",
            field="samples",
            value=samples,
            example="1024",
        )
    if not 0.0 < confidence < 1.0:
        raise InputError("must be between 0 and 1", field="confidence", value=confidence)
    if not 10 <= resamples <= 10_000:
        raise InputError("must be 10 to 10000", field="resamples", value=resamples)


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


def _draws(distribution: HasQuantile, shares: Floats) -> Floats:
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
            f"{int(failed.sum())} of {len(failed)} draws have no result, and Sobol's indices need"
            " all; narrow the distributions, or use rank correlation, which leaves them out",
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
