"""Whether a life test contradicts a calculated life.

The life seen in the test over the calculated one has the interval of the life's bounds; if that
leaves 1 outside, the data contradict the calculation at that confidence. That they do not is no
proof: a short test contradicts nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import Any, Final, Literal

import numpy as np

from rolamento.errors import InputError
from rolamento.weibull._checks import generator, positive, sample_count, share
from rolamento.weibull.asymptotic import profile_fall
from rolamento.weibull.bounds import Bounds, Method, bounds
from rolamento.weibull.calibrated import calibrated_p_value
from rolamento.weibull.fixed_shape import fixed_shape_tails
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import maximum_likelihood
from rolamento.weibull.quantity import Quantity
from rolamento.weibull.sampled import pivotal_draws

__all__ = ["VERDICT_METHODS", "CalculatedLife", "Verdict", "against_calculated_life"]

Verdict = Literal["data contradict calculation", "data do not contradict calculation", "no verdict"]
VERDICT_METHODS: Final[tuple[Method, ...]] = (
    "pivotal",
    "calibrated_likelihood_ratio",
    "likelihood_ratio",
    "fixed_shape",
)
"""Methods of bounds that also give a p-value."""


@dataclass(frozen=True, slots=True, eq=False)
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

    verdict: Verdict
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
    def advice(self) -> str | None:
        """What a person can do, where there is none."""
        return self.observed.advice

    def to_mapping(self) -> dict[str, Any]:
        """Give the verdict as plain values; None where there is no number, or the end is open."""
        numbers = {name: getattr(self, name) for name in ("ratio", "lower", "upper", "p_value")}
        return {
            "verdict": self.verdict,
            "bearings_live": self.bearings_live,
            "calculated": self.calculated,
            **{name: value if isfinite(value) else None for name, value in numbers.items()},
            "observed": self.observed.to_mapping(),
        }


def against_calculated_life(
    test: LifeTest,
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
    life = positive(calculated, "calculated", "1000.0")
    quantity = Quantity.life(share(reliability, "reliability"))
    if method is not None and method not in VERDICT_METHODS:
        raise InputError(
            f"must be one of {', '.join(VERDICT_METHODS)} for a verdict",
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
        _p_value(test, quantity, life, found, sample_count(samples), shape),
    )


def _p_value(
    test: LifeTest,
    quantity: Quantity,
    life: float,
    found: Bounds,
    samples: int,
    shape: float | None,
) -> float:
    """Of two sides, by the method of the bounds."""
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
