"""Whether groups of bearings differ: likelihood-ratio tests that hold for small groups.

    common_shape    one shape, each group its scale, against shapes and scales of their own
    same_life       one shape and one scale, against one shape and scales of their own
    homogeneous     one shape and one scale, against shapes and scales of their own

Twice the difference of the logarithms of the likelihoods is close to chi-square for many failures,
and far from it for few. So tests of all groups are drawn again and again under the hypothesis, with
their censoring, and the p-value is the share of them that differ at least as much. Where all tests
ended with failures this is exact, for then the statistic's distribution knows neither shape nor
scale.

A group in which nothing failed says something of lives and nothing of shapes.

Sources: McCool (1979); Lawless (2003), section 5.5; Davison and Hinkley (1997), section 4.2.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any, Final, Literal, NamedTuple, get_args

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull import profile
from rolamento.weibull._checks import generator, one_of, sample_count
from rolamento.weibull.censoring import right_censored_model
from rolamento.weibull.drawing import RightCensored, portions
from rolamento.weibull.fit import Outcome, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import maximum_likelihood, rows_of
from rolamento.weibull.profile import BatchFit, Rows

__all__ = ["Comparison", "Hypothesis", "compare", "groups_of"]

Hypothesis = Literal["common_shape", "same_life", "homogeneous"]

_MOST_GROUPS: Final = 50
_MANY: Final = 0.1
_LEAST_FITS: Final = 50


@dataclass(frozen=True, slots=True, eq=False)
class Comparison(Outcome):
    """Result of a comparison; NaN where there is none.

    Attributes
    ----------
    hypothesis
        "common_shape", "same_life" or "homogeneous"
    code
        "converged", or why there is no result, a key of `fit.ADVICE`
    groups
        labels of the groups that were compared
    fits
        own fit of each of them, by maximum likelihood
    shape, scales
        under the hypothesis; one scale for each group
    statistic, freedom
        twice the difference of the logarithms of the likelihoods, and its degrees of freedom
    p_value
        share of drawn tests that differ at least as much if the hypothesis is true
    p_value_chi_square
        the same by chi-square, for many failures
    samples, dropped, seed
        tests drawn, how many had no fit, and with what they were drawn
    notes
        names in `fit.NOTES`
    """

    hypothesis: Hypothesis
    code: str
    groups: tuple[str, ...]
    fits: tuple[WeibullFit, ...]
    shape: float = np.nan
    scales: tuple[float, ...] = ()
    statistic: float = np.nan
    freedom: int = 0
    p_value: float = np.nan
    p_value_chi_square: float = np.nan
    samples: int = 0
    dropped: int = 0
    seed: int = 0
    notes: tuple[str, ...] = ()

    def rejected(self, confidence: float = 0.9) -> bool:
        """Whether the data contradict the hypothesis at a confidence."""
        return self.p_value < 1.0 - confidence

    def to_mapping(self) -> dict[str, Any]:
        """Give the comparison as plain values; None where there is no number."""
        numbers = ("shape", "statistic", "p_value", "p_value_chi_square")
        return {
            "hypothesis": self.hypothesis,
            "status": {"code": self.code, "converged": self.converged, "advice": self.advice},
            "groups": list(self.groups),
            "fits": [fit.to_mapping() for fit in self.fits],
            "scales": [_finite(scale) for scale in self.scales],
            **{name: _finite(getattr(self, name)) for name in numbers},
            "freedom": self.freedom,
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": list(self.sentences()),
        }


def compare(
    groups: Mapping[str, LifeTest] | LifeTest,
    hypothesis: Hypothesis = "homogeneous",
    *,
    samples: int = 10_000,
    seed: int = 0,
) -> Comparison:
    """Test whether groups have a shape, or shape and life, in common.

    Parameters
    ----------
    groups
        Tests by their labels, or one test that has groups; two groups at least, right-censored.
    hypothesis
        See the module.
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with.

    Raises
    ------
    InputError
        For fewer than two groups, more than 50, or inspected tests.
    """
    one_of(hypothesis, "hypothesis", get_args(Hypothesis))
    count, random = sample_count(samples), generator(seed)
    tests = groups_of(groups)
    notes: tuple[str, ...] = ()
    if hypothesis == "common_shape":
        tests, notes = _with_failures(tests)
    fits = tuple(maximum_likelihood(test) for test in tests.values())
    labels = tuple(tests)
    if len(tests) < 2:
        return Comparison(hypothesis, "group_without_fit", labels, fits, notes=notes)
    found = _statistic([rows_of(test) for test in tests.values()], hypothesis)
    if not found.good[0]:
        code = "no_failures" if not any(t.failures for t in tests.values()) else "group_without_fit"
        return Comparison(hypothesis, code, labels, fits, notes=notes)
    models = [right_censored_model(test) for test in tests.values()]
    drawable = [model for model in models if not isinstance(model, str)]
    freedom = (len(tests) - 1) * (2 if hypothesis == "homogeneous" else 1)
    statistic = float(found.value[0])
    from scipy.stats import chi2

    shape, log_scales = float(found.null.shape[0]), found.null.log_scale[:, 0]
    log_scales = np.broadcast_to(log_scales, (len(tests),))
    code, drawn = "too_large", np.array([])
    if len(drawable) == len(models):
        drawn = _drawn(drawable, shape, log_scales, hypothesis, count, random)
        code = "converged" if len(drawn) >= _LEAST_FITS else "not_converged"
        if not all(model.exact for model in drawable):
            notes = (*notes, "censoring_modelled")
        if len(drawn) < (1.0 - _MANY) * count:
            notes = (*notes, "many_without_fit")
    more = int(np.count_nonzero(drawn >= statistic * (1.0 - 1e-12)))
    return Comparison(
        hypothesis,
        code,
        labels,
        fits,
        shape,
        tuple(float(np.exp(x)) for x in log_scales),
        statistic,
        freedom,
        (1 + more) / (1 + len(drawn)) if code == "converged" else np.nan,
        float(chi2.sf(statistic, freedom)),
        count if code == "converged" else 0,
        count - len(drawn) if code == "converged" else 0,
        int(seed),
        notes,
    )


def groups_of(
    groups: Mapping[str, LifeTest] | LifeTest, most: int = _MOST_GROUPS
) -> dict[str, LifeTest]:
    """Return right-censored tests by their labels.

    Raises
    ------
    InputError
        For fewer than two groups, too many, inspected tests, or units that differ.
    """
    tests = groups.by_group() if isinstance(groups, LifeTest) else dict(groups)
    if not 2 <= len(tests) <= most:
        rule = "must be two" if most == 2 else f"must be 2 to {most}"
        raise InputError(rule, field="groups", value=len(tests))
    if any(test.inspected for test in tests.values()):
        raise InputError(
            "must have times of failure, and inspections give none; fit each by maximum likelihood",
            field="groups",
        )
    units = {test.unit for test in tests.values()}
    if len(units) > 1:
        raise InputError("must have one unit", field="groups", value=", ".join(sorted(units)))
    return tests


class _Found(NamedTuple):
    """value (samples,), fit under the hypothesis, and where there is a value."""

    value: FloatArray
    null: BatchFit
    good: BoolArray


def _statistic(groups: Sequence[Rows], hypothesis: Hypothesis) -> _Found:
    """Twice the difference of the logarithms of the likelihoods, of every sample."""
    null_groups = groups if hypothesis == "common_shape" else [_pooled(groups)]
    null = profile.fit_common_shape(null_groups)
    good = null.code == profile.CONVERGED
    value = -_value(null_groups, [null] * len(null_groups), range(len(null_groups)))
    if hypothesis == "same_life":
        full = [profile.fit_common_shape(groups)] * len(groups)
        places: Sequence[int] = range(len(groups))
    else:
        full = [profile.fit_rows(rows) for rows in groups]
        places = [0] * len(groups)
    for fit in full:  # a group without failures has no fit, and needs none
        good = good & np.isin(fit.code, (profile.CONVERGED, profile.NO_FAILURES))
    value = value + _value(groups, full, places)
    return _Found(np.where(good, np.maximum(2.0 * value, 0.0), np.nan), null, good)


def _value(groups: Sequence[Rows], fits: Sequence[BatchFit], places: Sequence[int]) -> FloatArray:
    """Logarithm of the likelihood at the best scales, but for what all hypotheses share."""
    total = np.zeros(len(groups[0].log_time))
    for rows, fit, place in zip(groups, fits, places, strict=True):
        r = _failures(rows)
        failed = np.sum(rows.failures * rows.log_time, axis=1)
        with np.errstate(invalid="ignore"):
            term = r * np.log(fit.shape) + fit.shape * (failed - r * fit.log_scale[place]) - r
        total += np.where(r > 0.0, term, 0.0)
    return total


def _failures(rows: Rows) -> FloatArray:
    return np.asarray(np.broadcast_to(rows.failures, rows.log_time.shape).sum(axis=1))


def _pooled(groups: Sequence[Rows]) -> Rows:
    return Rows(
        np.concatenate([rows.log_time for rows in groups], axis=1),
        *(
            np.concatenate(
                [np.broadcast_to(rows[i], rows.log_time.shape) for rows in groups], axis=1
            )
            for i in (1, 2)
        ),
    )


def _drawn(
    models: Sequence[RightCensored],
    shape: float,
    log_scales: FloatArray,
    hypothesis: Hypothesis,
    samples: int,
    random: np.random.Generator,
) -> FloatArray:
    """Statistics of tests drawn under the hypothesis; those that have one."""
    parts = []
    for count in portions(sum(model.width for model in models), samples):
        groups = [
            model.rows(shape, float(x), count, random)
            for model, x in zip(models, log_scales, strict=True)
        ]
        found = _statistic(groups, hypothesis)
        parts.append(found.value[found.good])
    return np.concatenate(parts)


def _with_failures(tests: dict[str, LifeTest]) -> tuple[dict[str, LifeTest], tuple[str, ...]]:
    """Leave out the groups in which nothing failed."""
    kept = {label: test for label, test in tests.items() if test.failures}
    return kept, ("group_without_failures",) if len(kept) < len(tests) else ()


def _finite(value: float) -> float | None:
    return float(value) if isfinite(value) else None
