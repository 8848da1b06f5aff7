"""Confidence bounds on shape, scale, lives and reliabilities: one function for all methods."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, generator, one_of, share
from rolamento.weibull.drawing import model_of
from rolamento.weibull.estimates import fixed_shape, fixed_shape_limits, maximum_likelihood
from rolamento.weibull.fit import Estimand, Outcome, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood_ratio import (
    calibrated_limits,
    fisher_limits,
    likelihood_ratio_limits,
)
from rolamento.weibull.limits import sample_count, shape_of
from rolamento.weibull.sampled import sampled_limits
from rolamento.words import Note, said

Method = Literal[
    "pivotal",
    "calibrated_likelihood_ratio",
    "likelihood_ratio",
    "fisher",
    "parametric_percentile",
    "parametric_bias_corrected",
    "bootstrap_percentile",
    "bootstrap_bca",
    "fixed_shape",
]
Sides = Literal["two", "lower", "upper"]
METHODS: Final = get_args(Method)
_ANALYTIC: Final = ("likelihood_ratio", "fisher")
_MAXIMUM_QUANTITIES: Final = 1000
_LEAST, _MOST, _POINTS = 0.001, 0.999, 61
MAXIMUM_BAND_SAMPLES: Final = 10_000
"""More make no difference that a picture could show."""


@frozen(eq=False)
class Bounds(Outcome):
    """Limits that a quantity lies between, in so many of a hundred tests; NaN where there are none.

    Attributes
    ----------
    quantity
        as it is written: "L10"
    method
        that gave them
    confidence
        share of tests whose limits hold
    sides
        "two", with as much left out on each side; "lower" or "upper", with the other end open: 0,
        infinite, or 1 of a reliability
    estimate
        by maximum likelihood, or at the given shape
    lower, upper
        in the unit of the test, for a life
    code
        "converged", or why there are none, a code that `advice` explains
    unit
        label of a life; empty for a shape or a reliability
    samples, dropped, seed
        tests drawn, how many of them had no fit, and with what they were drawn; 0 without drawing
    notes
        what limits it, each once
    """

    quantity: str
    method: str
    confidence: float
    sides: Sides
    estimate: float
    lower: float
    upper: float
    code: str
    unit: str
    samples: int = 0
    dropped: int = 0
    seed: int = 0
    notes: tuple[Note, ...] = ()

    @property
    def one_sided_confidence(self) -> float:
        """Confidence of each limit alone: each of two sides excludes half of what both exclude."""
        return 0.5 * (1.0 + self.confidence) if self.sides == "two" else self.confidence

    @property
    def ratio(self) -> float:
        """Upper over lower limit; infinite where one is open."""
        return np.inf if self.lower == 0.0 else self.upper / self.lower

    def contains(self, value: float) -> bool:
        """Whether a value lies between the limits."""
        return self.lower <= value <= self.upper

    def to_mapping(self) -> dict[str, Any]:
        """Give the bounds as plain values; None where there is no number, or the end is open."""
        return {
            "quantity": self.quantity,
            "method": self.method,
            "confidence": self.confidence,
            "sides": self.sides,
            "estimate": finite(self.estimate),
            "lower": finite(self.lower),
            "upper": finite(self.upper),
            "unit": self.unit,
            "status": self.status(),
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": [note.to_mapping() for note in self.notes],
        }


def bounds(
    test: LifeTest | ArrayLike,
    quantity: str | Estimand = "L10",
    *,
    method: Method | None = None,
    confidence: float = 0.9,
    sides: Sides = "two",
    samples: int = 10_000,
    seed: int = 0,
    shape: float | None = None,
) -> Bounds:
    """Bounds on one quantity.

    Parameters
    ----------
    test
        With any kind of censoring.
    quantity
        "shape", "scale", a life such as "L10", or a reliability at a time such as "R100".
    method
        By default "pivotal", which keeps its promise with few failures (docs/theory/weibull.md);
        "likelihood_ratio" where a test cannot be drawn again; "fixed_shape" where a shape is given.
    confidence
        Of both sides together, or of the one.
    sides
        "two", "lower" or "upper".
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with; the same seed, the same
        bounds.
    shape
        From experience: only the scale comes from the test, which needs no failure then.

    Raises
    ------
    InputError
        For an unknown method or quantity, a confidence out of range, and so on.
    """
    return all_bounds(
        test,
        [quantity],
        method=method,
        confidence=confidence,
        sides=sides,
        samples=samples,
        seed=seed,
        shape=shape,
    )[0]


def all_bounds(
    test: LifeTest | ArrayLike,
    quantities: Iterable[str | Estimand],
    *,
    method: Method | None = None,
    confidence: float = 0.9,
    sides: Sides = "two",
    samples: int = 10_000,
    seed: int = 0,
    shape: float | None = None,
) -> tuple[Bounds, ...]:
    """Bounds on many quantities, from the same drawn tests; parameters as of `bounds`.

    Raises
    ------
    InputError
        If `quantities` is no list of quantities, or an option is out of range.
    """
    test = LifeTest.of(test)
    if isinstance(quantities, str) or not isinstance(quantities, Iterable):
        raise InputError(said("must be a list"), field="quantities", example='["shape", "L10"]')
    wanted = [Estimand.of(quantity) for quantity in quantities]
    if not 0 < len(wanted) <= _MAXIMUM_QUANTITIES:
        raise InputError(
            said("must be from 1 to {most}", most=_MAXIMUM_QUANTITIES), field="quantities"
        )
    chosen = _chosen_method(test, method, shape)
    one_of(sides, "sides", get_args(Sides))
    tail = 1.0 - share(confidence, "confidence")
    tails = np.array({"two": [tail / 2.0, 1.0 - tail / 2.0], "lower": [tail],
                      "upper": [1.0 - tail]}[sides])  # fmt: skip
    count, random = sample_count(samples), generator(seed)
    if chosen == "fixed_shape":
        return _bounds_at_fixed_shape(test, shape_of(shape), wanted, confidence, sides, tails)
    fit = maximum_likelihood(test)
    limits = np.full((len(wanted), len(tails)), np.nan)
    code, drawn, notes = fit.code, (0, 0, 0), fit.notes
    if fit.converged and chosen in _ANALYTIC:
        limits = _analytic_limits(test, fit, chosen, wanted, tails)
        notes = (*notes, Note("large_sample_method"))
    elif fit.converged and chosen == "calibrated_likelihood_ratio":
        limits, drawing = calibrated_limits(test, fit, wanted, tails, count, random)
        code, drawn = drawing.code, (drawing.samples, drawing.dropped, int(seed))
        notes = (*notes, *drawing.notes)
    elif fit.converged:
        limits, draws = sampled_limits(test, fit, chosen, wanted, tails, count, random)
        code, drawn = draws.code, (draws.samples, draws.dropped, int(seed))
        notes = (*notes, *draws.notes)
    return _bounds_of(test, fit, wanted, chosen, confidence, sides, limits, code, drawn, notes)


def _chosen_method(test: LifeTest, method: str | None, shape: float | None) -> str:
    if method is None:
        if shape is not None:
            return "fixed_shape"
        return "likelihood_ratio" if isinstance(model_of(test), str) else "pivotal"
    one_of(method, "method", METHODS)
    if (method == "fixed_shape") != (shape is not None):
        raise InputError(
            said("goes with the method fixed_shape, which needs it"),
            field="shape",
            value=shape,
            example="1.5",
        )
    return method


def _analytic_limits(
    test: LifeTest, fit: WeibullFit, method: str, quantities: list[Estimand], tails: FloatArray
) -> FloatArray:
    if method == "fisher":
        return fisher_limits(test, fit, quantities, tails)
    from scipy.special import ndtri

    roots = np.broadcast_to(ndtri(tails), (len(quantities), len(tails)))
    return likelihood_ratio_limits(test, fit, quantities, roots)


def _bounds_at_fixed_shape(
    test: LifeTest,
    shape: float,
    quantities: list[Estimand],
    confidence: float,
    sides: Sides,
    tails: FloatArray,
) -> tuple[Bounds, ...]:
    if any(quantity.kind == "shape" for quantity in quantities):
        raise InputError(said("has no bounds where it is given"), field="shape", value=shape)
    fit = fixed_shape(test, shape)
    limits = np.array([fixed_shape_limits(test, shape, q, tails) for q in quantities])
    notes = (Note("inspections_shared"),) if test.inspected else ()
    return _bounds_of(
        test,
        fit,
        quantities,
        "fixed_shape",
        confidence,
        sides,
        limits,
        "converged",
        (0, 0, 0),
        notes,
    )


def _bounds_of(
    test: LifeTest,
    fit: WeibullFit,
    quantities: list[Estimand],
    method: str,
    confidence: float,
    sides: Sides,
    limits: FloatArray,
    code: str,
    drawn: tuple[int, int, int],
    notes: tuple[Note, ...],
) -> tuple[Bounds, ...]:
    at = np.array([fit.shape]), np.log([fit.scale])
    records = []
    for quantity, row in zip(quantities, limits, strict=True):
        low, high = quantity.ends if code == "converged" else (np.nan, np.nan)
        lower = float(row[0]) if sides != "upper" else low
        upper = float(row[-1]) if sides != "lower" else high
        bad = code == "converged" and (np.isnan(lower) or np.isnan(upper))
        records.append(
            Bounds(
                quantity.name, method, confidence, sides, float(quantity.at(*at)[0]), lower, upper,
                "not_converged" if bad else code, test.unit if quantity.kind == "life" else "",
                *drawn, tuple(dict.fromkeys(notes)),
            )
        )  # fmt: skip
    return tuple(records)


# --- the band around a fitted line ----------------------------------------------------------------


@frozen(eq=False)
class Band:
    """Bounds of lives over a range of reliabilities, each by itself.

    Attributes
    ----------
    code
        "converged", or why there is none, a code that `advice` explains
    method, confidence, sides
        of the bounds: two-sided, or of one side
    reliability
        (points,), falling
    estimate, lower, upper
        (points,) lives; NaN or infinite where there is no bound
    unit
        label of times
    """

    code: str
    method: str
    confidence: float
    sides: Sides
    reliability: FloatArray
    estimate: FloatArray
    lower: FloatArray
    upper: FloatArray
    unit: str

    @property
    def converged(self) -> bool:
        """Whether there is a band."""
        return self.code == "converged"

    @property
    def failed_share(self) -> FloatArray:
        """F = 1 - R."""
        return 1.0 - self.reliability


def confidence_band(
    test: LifeTest | ArrayLike,
    *,
    method: Method | None = None,
    confidence: float = 0.9,
    sides: Sides | None = None,
    samples: int = 10_000,
    seed: int = 0,
    shape: float | None = None,
) -> Band:
    """Bounds of the lives that 99.9 % down to 0.1 % of the bearings reach.

    Parameters
    ----------
    test
        With any kind of censoring.
    method, confidence, sides, samples, seed, shape
        As of `bounds`; by default "two", or "lower" without failures. Samples above 10 000 are not
        drawn.
    """
    test = LifeTest.of(test)
    first, last = (float(np.log(-np.log1p(-failed))) for failed in (_LEAST, _MOST))
    ordinate = np.linspace(first, last, _POINTS)
    reliability = np.exp(-np.exp(ordinate))
    sides = sides or ("two" if test.failures else "lower")
    found = all_bounds(
        test,
        [Estimand.life(float(r)) for r in reliability],
        method=method,
        confidence=confidence,
        sides=sides,
        samples=min(samples, MAXIMUM_BAND_SAMPLES),
        seed=seed,
        shape=shape,
    )
    estimate, lower, upper = np.array([[one.estimate, one.lower, one.upper] for one in found]).T
    code = next((one.code for one in found if one.converged), found[0].code)
    return Band(
        code, found[0].method, confidence, sides, reliability, estimate, lower, upper, test.unit
    )
