"""Whether lives differ: groups of bearings, their ratio, a test against a calculated life.

*Hypotheses* about groups, by likelihood-ratio tests that hold for small groups too:

    common_shape    one shape, each group its scale, against shapes and scales of their own
    same_life       one shape and one scale, against one shape and scales of their own
    homogeneous     one shape and one scale, against shapes and scales of their own

Twice the difference of the logarithms of the likelihoods is close to chi-square for many failures,
and far from it for few. So tests of all groups are drawn again and again under the hypothesis, with
their censoring, and the p-value is the share of them that differ at least as much. Where all tests
ended with failures this is exact, for then the statistic's distribution depends on neither shape
nor scale.

A group in which nothing failed says something of lives and nothing of shapes.

*The ratio of two lives.* At a common shape the ratio is the same for every reliability, and

    β̂ (ln ρ̂ - ln ρ)

with the common β̂ has a distribution independent of β, η and ρ where both tests ended with failures:
draws of it give exact limits. Where the clock ended a test they are drawn at the fit.

Without a common shape the draws of each group's life by its own pivots are divided: a generalised
confidence interval, good but not exact.

*A calculated life.* The life seen in the test over the calculated one has the interval of the
life's bounds; if that leaves 1 outside, the data contradict the calculation at that confidence.
That they do not is no proof: a short test contradicts nothing.

Sources: McCool (1975, 1979); Lawless (2003), section 5.5; Davison and Hinkley (1997), section 4.2;
Krishnamoorthy, Lin and Xia (2009) for the ratio without a common shape.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, generator, number, one_of, share
from rolamento.weibull.bounds import Bounds, Method, bounds
from rolamento.weibull.drawing import (
    MANY,
    MINIMUM_FITS,
    RightCensored,
    draw_common_fits,
    portions,
    right_censored_model,
)
from rolamento.weibull.estimates import fixed_shape_tails, maximum_likelihood, rows_of
from rolamento.weibull.fit import Estimand, Outcome, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import (
    CONVERGED,
    NO_FAILURES,
    BatchFit,
    Rows,
    fit_common_shape,
    fit_rows,
)
from rolamento.weibull.likelihood_ratio import calibrated_p_value, profile_fall
from rolamento.weibull.limits import sample_count
from rolamento.weibull.sampled import pivotal_draws
from rolamento.words import Note, said

Groups = Mapping[str, LifeTest | ArrayLike] | LifeTest
Hypothesis = Literal["common_shape", "same_life", "homogeneous"]
_MAXIMUM_GROUPS: Final = 50
Contradiction = Literal[
    "data contradict calculation", "data do not contradict calculation", "no verdict"
]
VERDICT_METHODS: Final[tuple[Method, ...]] = (
    "pivotal",
    "calibrated_likelihood_ratio",
    "likelihood_ratio",
    "fixed_shape",
)
"""Methods of bounds that also give a p-value."""


@frozen(eq=False)
class Comparison(Outcome):
    """Result of a comparison; NaN where there is none.

    Attributes
    ----------
    hypothesis
        "common_shape", "same_life" or "homogeneous"
    code
        "converged", or why there is no result, a code that `advice` explains
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
        what limits it, each once
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
    notes: tuple[Note, ...] = ()

    def rejected(self, confidence: float = 0.9) -> bool:
        """Whether the data contradict the hypothesis at a confidence."""
        return self.p_value < 1.0 - confidence

    def to_mapping(self) -> dict[str, Any]:
        """Give the comparison as plain values; None where there is no number."""
        numbers = ("shape", "statistic", "p_value", "p_value_chi_square")
        return {
            "hypothesis": self.hypothesis,
            "status": self.status(),
            "groups": list(self.groups),
            "fits": [fit.to_mapping() for fit in self.fits],
            "scales": [finite(scale) for scale in self.scales],
            **{name: finite(getattr(self, name)) for name in numbers},
            "freedom": self.freedom,
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": [note.to_mapping() for note in self.notes],
        }


def compare(
    groups: Groups,
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
    notes: tuple[Note, ...] = ()
    if hypothesis == "common_shape":
        tests, notes = _with_failures(tests)
    fits = tuple(maximum_likelihood(test) for test in tests.values())
    labels = tuple(tests)
    if len(tests) < 2:
        return Comparison(hypothesis, "group_without_fit", labels, fits, notes=notes)
    found = _statistic_of([rows_of(test) for test in tests.values()], hypothesis)
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
        drawn = _statistics_drawn(drawable, shape, log_scales, hypothesis, count, random)
        code = "converged" if len(drawn) >= MINIMUM_FITS else "not_converged"
        if not all(model.exact for model in drawable):
            notes = (*notes, Note("censoring_modelled"))
        if len(drawn) < (1.0 - MANY) * count:
            notes = (*notes, Note("many_without_fit"))
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


def groups_of(groups: Groups, most: int = _MAXIMUM_GROUPS) -> dict[str, LifeTest]:
    """Return right-censored tests by their labels.

    Raises
    ------
    InputError
        For fewer than two groups, too many, inspected tests, or units that differ.
    """
    if isinstance(groups, LifeTest):
        tests = groups.by_group()
    elif isinstance(groups, Mapping):
        tests = {str(name): LifeTest.of(test) for name, test in groups.items()}
    else:
        raise InputError(
            said("must be tests by label, or one test that has groups"),
            field="groups",
            example='{"A": [120.5, 88.0], "B": [300.0, 410.0]}',
        )
    if not 2 <= len(tests) <= most:
        rule = said("must be two") if most == 2 else said("must be 2 to {most}", most=most)
        raise InputError(rule, field="groups", value=len(tests))
    if any(test.inspected for test in tests.values()):
        raise InputError(
            said(
                "must have failure times, which inspections do not give; fit each by "
                "maximum likelihood"
            ),
            field="groups",
        )
    units = {test.unit for test in tests.values()}
    if len(units) > 1:
        raise InputError(
            said("must have the same unit"), field="groups", value=", ".join(sorted(units))
        )
    return tests


class _Statistic(NamedTuple):
    """value (samples,), fit under the hypothesis, and where there is a value."""

    value: FloatArray
    null: BatchFit
    good: BoolArray


def _statistic_of(groups: Sequence[Rows], hypothesis: Hypothesis) -> _Statistic:
    """Twice the difference of the logarithms of the likelihoods, of every sample."""
    null_groups = groups if hypothesis == "common_shape" else [_pooled_rows(groups)]
    null = fit_common_shape(null_groups)
    good = null.code == CONVERGED
    value = -_log_likelihood_of(null_groups, [null] * len(null_groups), range(len(null_groups)))
    if hypothesis == "same_life":
        full = [fit_common_shape(groups)] * len(groups)
        places: Sequence[int] = range(len(groups))
    else:
        full = [fit_rows(rows) for rows in groups]
        places = [0] * len(groups)
    for fit in full:  # a group without failures has no fit, and needs none
        good = good & np.isin(fit.code, (CONVERGED, NO_FAILURES))
    value = value + _log_likelihood_of(groups, full, places)
    return _Statistic(np.where(good, np.maximum(2.0 * value, 0.0), np.nan), null, good)


def _log_likelihood_of(
    groups: Sequence[Rows], fits: Sequence[BatchFit], places: Sequence[int]
) -> FloatArray:
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


def _pooled_rows(groups: Sequence[Rows]) -> Rows:
    return Rows(
        np.concatenate([rows.log_time for rows in groups], axis=1),
        *(
            np.concatenate(
                [np.broadcast_to(rows[i], rows.log_time.shape) for rows in groups], axis=1
            )
            for i in (1, 2)
        ),
    )


def _statistics_drawn(
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
        found = _statistic_of(groups, hypothesis)
        parts.append(found.value[found.good])
    return np.concatenate(parts)


def _with_failures(tests: dict[str, LifeTest]) -> tuple[dict[str, LifeTest], tuple[Note, ...]]:
    """Leave out the groups in which nothing failed."""
    kept = {label: test for label, test in tests.items() if test.failures}
    return kept, (Note("group_without_failures"),) if len(kept) < len(tests) else ()


# --- the ratio of two lives -----------------------------------------------------------------------


@frozen(eq=False)
class LifeRatio(Outcome):
    """Life of the first group over that of the second; NaN where there is none.

    Attributes
    ----------
    groups
        labels of the first and the second
    reliability
        that the lives are for
    common_shape
        whether both were taken to have one shape
    code
        "converged", or why there is no result, a code that `advice` explains
    shape
        the common one; NaN without
    ratio, lower, upper
        by maximum likelihood, and the limits of its interval
    confidence
        of the interval
    p_value
        of two sides, of equal lives
    samples, dropped, seed
        tests drawn, how many had no fit, and with what they were drawn
    notes
        what limits it, each once
    """

    groups: tuple[str, str]
    reliability: float
    common_shape: bool
    code: str
    shape: float = np.nan
    ratio: float = np.nan
    lower: float = np.nan
    upper: float = np.nan
    confidence: float = np.nan
    p_value: float = np.nan
    samples: int = 0
    dropped: int = 0
    seed: int = 0
    notes: tuple[Note, ...] = ()

    def to_mapping(self) -> dict[str, Any]:
        """Give the ratio as plain values; None where there is no number."""
        numbers = ("shape", "ratio", "lower", "upper", "p_value")
        return {
            "groups": list(self.groups),
            "reliability": self.reliability,
            "common_shape": self.common_shape,
            "status": self.status(),
            **{name: finite(getattr(self, name)) for name in numbers},
            "confidence": self.confidence,
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": [note.to_mapping() for note in self.notes],
        }


def life_ratio(
    groups: Groups,
    reliability: float = 0.9,
    *,
    common_shape: bool = True,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
) -> LifeRatio:
    """Ratio of the lives of two groups.

    Parameters
    ----------
    groups
        Two tests by their labels, or one test with two groups; right-censored.
    reliability
        That the lives are for; 0.9 for L10. At a common shape the ratio does not depend on it.
    common_shape
        Whether both have one shape (`compare` tests that).
    confidence
        Of the interval, with as much left out on each side.
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with.

    Raises
    ------
    InputError
        For other than two groups, or inspected tests.
    """
    tests = groups_of(groups, most=2)
    r, level = share(reliability, "reliability"), share(confidence, "confidence")
    count, random = sample_count(samples), generator(seed)
    (one, first), (other, second) = tests.items()
    labels = (one, other)
    find = _ratio_at_common_shape if common_shape else _ratio_at_own_shapes
    code, shape, log_ratio, drawn, notes = find(first, second, r, count, random)
    if code != "converged":
        return LifeRatio(labels, r, common_shape, code, confidence=level)
    tail = 0.5 * (1.0 - level)
    lower, upper = np.quantile(drawn, [tail, 1.0 - tail], method="inverted_cdf")
    if len(drawn) < (1.0 - MANY) * count:
        notes = (*notes, Note("many_without_fit"))
    sides = min(int(np.sum(drawn <= 0.0)), int(np.sum(drawn >= 0.0)))
    with np.errstate(over="ignore"):
        ratio, low, high = np.exp([log_ratio, lower, upper])
    return LifeRatio(
        labels,
        r,
        common_shape,
        code,
        shape,
        float(ratio),
        float(low),
        float(high),
        level,
        min(2.0 * (1 + sides) / (1 + len(drawn)), 1.0),
        count,
        count - len(drawn),
        int(seed),
        notes,
    )


_DrawnRatio = tuple[str, float, float, FloatArray, tuple[Note, ...]]
_NOTHING = np.array([])


def _ratio_at_common_shape(
    first: LifeTest,
    second: LifeTest,
    reliability: float,
    samples: int,
    random: np.random.Generator,
) -> _DrawnRatio:
    tests = (first, second)
    fit = fit_common_shape([rows_of(test) for test in tests])
    if not (first.failures and second.failures) or fit.code[0] != CONVERGED:
        code = "group_without_fit" if first.failures or second.failures else "no_failures"
        return code, np.nan, np.nan, _NOTHING, ()
    models = [right_censored_model(test) for test in tests]
    shape, log_scales = float(fit.shape[0]), fit.log_scale[:, 0]
    log_ratio = float(log_scales[0] - log_scales[1])
    drawable = [model for model in models if not isinstance(model, str)]
    if len(drawable) < len(models):
        return "too_large", np.nan, np.nan, _NOTHING, ()
    fits = draw_common_fits(drawable, shape, log_scales, samples, random)
    good = fits.code == CONVERGED
    # a group in which nothing failed lives infinitely longer: an extreme draw, but one
    pivot = fits.shape[good] * (fits.log_scale[0, good] - fits.log_scale[1, good] - log_ratio)
    if len(pivot) < MINIMUM_FITS:
        return "not_converged", np.nan, np.nan, _NOTHING, ()
    notes = () if all(model.exact for model in drawable) else (Note("censoring_modelled"),)
    return "converged", shape, log_ratio, np.asarray(log_ratio - pivot / shape), notes


def _ratio_at_own_shapes(
    first: LifeTest,
    second: LifeTest,
    reliability: float,
    samples: int,
    random: np.random.Generator,
) -> _DrawnRatio:
    quantity = Estimand.life(reliability)
    logs, estimates, notes = [], [], [Note("bounds_approximate")]
    for test in (first, second):
        fit = maximum_likelihood(test)
        if not fit.converged:
            return fit.code, np.nan, np.nan, _NOTHING, ()
        draws = pivotal_draws(test, fit, samples, random)
        if draws.code != "converged":
            return draws.code, np.nan, np.nan, _NOTHING, ()
        logs.append(draws.log_scale + quantity.log_risk / draws.shape)
        estimates.append(float(np.log(fit.life_at(reliability))))
        notes += draws.notes
    count = min(len(log) for log in logs)
    log_ratio = estimates[0] - estimates[1]
    drawn = logs[0][:count] - logs[1][:count]
    return "converged", np.nan, log_ratio, np.asarray(drawn), tuple(dict.fromkeys(notes))


# --- a calculated life ----------------------------------------------------------------------------


@frozen(eq=False)
class CalculatedLife:
    """A calculated life set against a test; NaN where the test has no result.

    Attributes
    ----------
    verdict
        "data contradict calculation", "data do not contradict calculation" or "no verdict"
    bearings_live
        "longer" or "shorter" than calculated, where the data contradict it; empty otherwise
    calculated
        the life given, in the unit of the test
    observed
        bounds on the life that the test shows
    ratio, lower, upper
        observed over calculated life, and its interval
    p_value
        of two sides: how often a test would be at least as far from the calculated life, were it
        true
    """

    verdict: Contradiction
    bearings_live: str
    calculated: float
    observed: Bounds
    ratio: float
    lower: float
    upper: float
    p_value: float

    @property
    def code(self) -> str:
        """Status of the bounds: "converged", or why there is no result."""
        return self.observed.code

    @property
    def advice(self) -> Note | None:
        """What a person can do, where there is none."""
        return self.observed.advice

    def to_mapping(self) -> dict[str, Any]:
        """Give the verdict as plain values; None where there is no number, or the end is open."""
        numbers = ("ratio", "lower", "upper", "p_value")
        return {
            "verdict": self.verdict,
            "bearings_live": self.bearings_live,
            "calculated": self.calculated,
            **{name: finite(getattr(self, name)) for name in numbers},
            "observed": self.observed.to_mapping(),
        }


def against_calculated_life(
    test: LifeTest | ArrayLike,
    calculated: float,
    reliability: float = 0.9,
    *,
    method: Method | None = None,
    confidence: float = 0.9,
    samples: int = 10_000,
    seed: int = 0,
    shape: float | None = None,
) -> CalculatedLife:
    """Set a calculated life against a test.

    Parameters
    ----------
    test
        With any kind of censoring.
    calculated
        Life by calculation, in the unit of the test.
    reliability
        That it is for; 0.9 for L10.
    method
        One of `VERDICT_METHODS`; the default is that of `bounds`.
    confidence
        Of the interval of two sides, and of the verdict.
    samples, seed, shape
        As of `bounds`. With a shape from experience the test needs no failure.

    Raises
    ------
    InputError
        For a life that is not above zero, a method that has no p-value here, and so on.
    """
    test, life = LifeTest.of(test), number(calculated, "calculated", above=0.0, example="1000.0")
    quantity = Estimand.life(share(reliability, "reliability"))
    if method is not None and method not in VERDICT_METHODS:
        raise InputError(
            said(
                "must be one of {known} for a verdict",
                known=", ".join(VERDICT_METHODS),
            ),
            field="method",
            value=method,
            example="pivotal",
        )
    found = bounds(
        test,
        quantity,
        method=method,
        confidence=confidence,
        samples=samples,
        seed=seed,
        shape=shape,
    )
    if not found.converged:
        nan = float("nan")
        return CalculatedLife("no verdict", "", life, found, nan, nan, nan, nan)
    lower, upper = found.lower / life, found.upper / life
    live = "longer" if lower > 1.0 else "shorter" if upper < 1.0 else ""
    return CalculatedLife(
        "data contradict calculation" if live else "data do not contradict calculation",
        live,
        life,
        found,
        found.estimate / life,
        lower,
        upper,
        _two_sided_p_value(test, quantity, life, found, samples, shape),
    )


def _two_sided_p_value(
    test: LifeTest,
    quantity: Estimand,
    life: float,
    found: Bounds,
    samples: int,
    shape: float | None,
) -> float:
    """p-value of two sides, by the method of the bounds."""
    if found.method == "fixed_shape" and shape is not None:
        return min(2.0 * min(fixed_shape_tails(test, shape, quantity, life)), 1.0)
    fit = maximum_likelihood(test)
    if found.method == "likelihood_ratio":
        from scipy.special import ndtr

        return float(2.0 * ndtr(-np.sqrt(profile_fall(test, fit, quantity, life)[0])))
    random = generator(found.seed)
    if found.method == "calibrated_likelihood_ratio":
        return calibrated_p_value(test, fit, quantity, life, samples, random)
    draws = pivotal_draws(test, fit, samples, random).of(quantity)
    less = min(int(np.sum(draws <= life)), int(np.sum(draws >= life)))
    return min(2.0 * (1 + less) / (1 + len(draws)), 1.0)
