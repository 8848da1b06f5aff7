"""How many times longer one group of bearings lives than another.

At a common shape the ratio is the same for every reliability, and

    β̂ (ln ρ̂ - ln ρ)

with the common β̂ has a distribution that knows no β, η or ρ where both tests ended with failures:
draws of it give exact limits. Where the clock ended a test they are drawn at the fit.

Without a common shape the draws of each group's life by its own pivots are divided: a generalised
confidence interval, good but not exact.

Sources: McCool (1975, 1979) for the common shape; Krishnamoorthy, Lin and Xia (2009) for the other.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.weibull import profile
from rolamento.weibull._checks import generator, sample_count, share
from rolamento.weibull.censoring import draw_common_fits, right_censored_model
from rolamento.weibull.comparison import groups_of
from rolamento.weibull.fit import Outcome
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import maximum_likelihood, rows_of
from rolamento.weibull.quantity import Quantity
from rolamento.weibull.sampled import pivotal_draws

__all__ = ["LifeRatio", "life_ratio"]

_MANY = 0.1
_LEAST_FITS = 50


@dataclass(frozen=True, slots=True, eq=False)
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
        "converged", or why there is no result, a key of `fit.ADVICE`
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
        names in `fit.NOTES`
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
    notes: tuple[str, ...] = ()

    def to_mapping(self) -> dict[str, Any]:
        """Give the ratio as plain values; None where there is no number."""
        numbers = ("shape", "ratio", "lower", "upper", "p_value")
        found = {name: getattr(self, name) for name in numbers}
        return {
            "groups": list(self.groups),
            "reliability": self.reliability,
            "common_shape": self.common_shape,
            "status": {"code": self.code, "converged": self.converged, "advice": self.advice},
            **{name: value if isfinite(value) else None for name, value in found.items()},
            "confidence": self.confidence,
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": list(self.sentences()),
        }


def life_ratio(
    groups: Mapping[str, LifeTest] | LifeTest,
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
    find = _at_common_shape if common_shape else _at_own_shapes
    code, shape, log_ratio, drawn, notes = find(first, second, r, count, random)
    if code != "converged":
        return LifeRatio(labels, r, common_shape, code, confidence=level)
    tail = 0.5 * (1.0 - level)
    lower, upper = np.quantile(drawn, [tail, 1.0 - tail], method="inverted_cdf")
    if len(drawn) < (1.0 - _MANY) * count:
        notes = (*notes, "many_without_fit")
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


_Found = tuple[str, float, float, FloatArray, tuple[str, ...]]
_NOTHING = np.array([])


def _at_common_shape(
    first: LifeTest,
    second: LifeTest,
    reliability: float,
    samples: int,
    random: np.random.Generator,
) -> _Found:
    tests = (first, second)
    fit = profile.fit_common_shape([rows_of(test) for test in tests])
    if not (first.failures and second.failures) or fit.code[0] != profile.CONVERGED:
        code = "group_without_fit" if first.failures or second.failures else "no_failures"
        return code, np.nan, np.nan, _NOTHING, ()
    models = [right_censored_model(test) for test in tests]
    shape, log_scales = float(fit.shape[0]), fit.log_scale[:, 0]
    log_ratio = float(log_scales[0] - log_scales[1])
    drawable = [model for model in models if not isinstance(model, str)]
    if len(drawable) < len(models):
        return "too_large", np.nan, np.nan, _NOTHING, ()
    fits = draw_common_fits(drawable, shape, log_scales, samples, random)
    good = fits.code == profile.CONVERGED
    # a group in which nothing failed lives infinitely longer: an extreme draw, but one
    pivot = fits.shape[good] * (fits.log_scale[0, good] - fits.log_scale[1, good] - log_ratio)
    if len(pivot) < _LEAST_FITS:
        return "not_converged", np.nan, np.nan, _NOTHING, ()
    notes = () if all(model.exact for model in drawable) else ("censoring_modelled",)
    return "converged", shape, log_ratio, np.asarray(log_ratio - pivot / shape), notes


def _at_own_shapes(
    first: LifeTest,
    second: LifeTest,
    reliability: float,
    samples: int,
    random: np.random.Generator,
) -> _Found:
    quantity = Quantity.life(reliability)
    logs, estimates, notes = [], [], ["approximate"]
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
