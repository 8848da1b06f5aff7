"""A Weibull distribution to decide by, with what is uncertain of it: fitted, or given.

What is uncertain of a fitted one is held as distributions that could have given the data: the
draws of `rolamento.weibull.sampled.pivotal_draws`, of which the quantiles of any quantity are its
limits. So all decisions, however they depend on β and η, have intervals of one kind, and those of a
life or a reliability are the pivotal bounds of `bounds`. At a known shape β, with r failures and
the total T = Σ t^β, draws of the scale are

    η^β = T/G,    G gamma-distributed with the shape r where failures ended the test,
                  and r + 1/2 where the clock did (between the exact limits of either side).

A distribution that is given has no uncertainty, and its decisions have no intervals.

Sources: Lawless (2003), sections 4.1 and 5.2, for pivots; Hong, Meeker and McCalley, Annals of
Applied Statistics 3 (2009), for decisions and predictions by draws of the parameters.
"""

from __future__ import annotations

from math import exp, isfinite, log
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, generator, number, share
from rolamento.weibull.estimates import ENDED_BY_FAILURES, fixed_shape, maximum_likelihood
from rolamento.weibull.fit import Outcome
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.limits import sample_count, shape_of, time_of
from rolamento.weibull.sampled import pivotal_draws
from rolamento.words import Note, said

__all__ = ["Interval", "LifeDistribution"]

_SAMPLES: Final = 10_000
_LEAST_SHAPE: Final = 0.1
"""Smallest shape of a distribution that is given: below it the mean is beyond all use."""


@frozen
class Interval:
    """A value with its limits; NaN where there are none."""

    value: float
    lower: float
    upper: float

    def to_mapping(self) -> dict[str, float | None]:
        """Give it as plain values; None where there is no number."""
        names = ("value", "lower", "upper")
        return {name: finite(getattr(self, name)) for name in names}


@frozen(eq=False)
class LifeDistribution(Outcome):
    """A Weibull distribution of lives, R(t) = exp(-(t/η)^β).

    Attributes
    ----------
    code
        "converged", or why there is none, a code that `advice` explains
    shape, scale
        β and η, the latter in the unit
    unit
        label of times
    method
        "given", "maximum_likelihood" or "fixed_shape"
    failures, size
        of the data; 0 of a given one
    shapes, scales
        (draws,) that could have given the data; empty where nothing is known of that
    samples, seed
        draws asked for, and what they were drawn with
    longest
        time in the data; NaN of a given one
    notes
        what limits it, each once
    """

    code: str
    shape: float
    scale: float
    unit: str
    method: str
    failures: int
    size: int
    shapes: FloatArray
    scales: FloatArray
    samples: int = 0
    seed: int = 0
    longest: float = np.nan
    notes: tuple[Note, ...] = ()

    @classmethod
    def given(
        cls,
        shape: float,
        *,
        scale: float | None = None,
        l10: float | None = None,
        unit: str = "h",
    ) -> Self:
        """Take a distribution as known.

        Parameters
        ----------
        shape
            β.
        scale, l10
            η, or the life that 90 % reach; one of the two, in the unit.
        unit
            Label of times.

        Raises
        ------
        InputError
            For neither or both of scale and L10, or a number that cannot be.
        """
        beta = shape_of(shape)
        if beta < _LEAST_SHAPE:
            rule = said("must be at least {least:.6g}", least=_LEAST_SHAPE)
            raise InputError(rule, field="shape", value=shape, example="1.5")
        if (scale is None) == (l10 is None):
            raise InputError(
                said("or l10 must be given, and not both"), field="scale", example="12000.0"
            )
        if scale is None:
            assert l10 is not None
            scale = number(l10, "l10", above=0.0, example="5000.0") * exp(-log(-log(0.9)) / beta)
        eta = time_of(scale, "scale")
        nothing = np.empty(0)
        return cls("converged", beta, eta, unit, "given", 0, 0, nothing, nothing)

    @classmethod
    def of_test(
        cls,
        test: LifeTest | ArrayLike,
        *,
        shape: float | None = None,
        samples: int = _SAMPLES,
        seed: int = 0,
    ) -> Self:
        """Fit a distribution by maximum likelihood, with what is uncertain of it.

        Parameters
        ----------
        test
            With any kind of censoring.
        shape
            β from experience: only the scale is fitted.
        samples, seed
            Draws, 100 to a million, and what they are drawn with.

        Raises
        ------
        InputError
            For a number that cannot be.
        """
        test = LifeTest.of(test)
        count, random = sample_count(samples), generator(seed)
        fit = maximum_likelihood(test) if shape is None else fixed_shape(test, shape)
        shapes = scales = np.empty(0)
        notes = fit.notes
        if fit.converged and shape is None:
            draws = pivotal_draws(test, fit, count, random)
            notes = (*notes, *draws.notes)
            if draws.code == "converged":
                shapes, scales = draws.shape, np.exp(draws.log_scale)
            else:
                notes = (*notes, Note("decision_without_draws"))
        elif fit.converged and not test.inspected:
            shapes, scales, exact = _drawn_at_shape(test, fit.shape, count, random)
            notes = notes if exact else (*notes, Note("bounds_approximate"))
        elif fit.converged:
            notes = (*notes, Note("decision_without_draws"))
        return cls(
            fit.code, fit.shape, fit.scale, test.unit, fit.method, fit.failures, fit.size,
            shapes, scales, count, int(seed), float(np.max(test.times)),
            tuple(dict.fromkeys(notes)),
        )  # fmt: skip

    @property
    def uncertain(self) -> bool:
        """Whether it is known how uncertain it is."""
        return len(self.shapes) > 0

    def interval(self, value: float, drawn: FloatArray, confidence: float) -> Interval:
        """Limits of a value, by what it is for every draw; NaN of a draw counts as infinite.

        Parameters
        ----------
        value
            At the estimate.
        drawn
            (draws,) values; infinite ones are beyond all others.
        confidence
            Of both limits together.
        """
        tail = 0.5 * (1.0 - share(confidence, "confidence"))
        if not len(drawn):
            return Interval(value, np.nan, np.nan)
        ordered = np.where(np.isnan(drawn), np.inf, drawn)
        low, high = np.quantile(ordered, [tail, 1.0 - tail], method="inverted_cdf")
        return Interval(value, float(low), float(high))

    def to_mapping(self) -> dict[str, Any]:
        """Give the distribution as plain values; None where there is no number."""
        return {
            "method": self.method,
            "status": self.status(),
            "shape": finite(self.shape),
            "scale": finite(self.scale),
            "unit": self.unit,
            "failures": self.failures,
            "size": self.size,
            "samples": self.samples,
            "seed": self.seed,
            "longest_time": finite(self.longest),
            "notes": [note.to_mapping() for note in self.notes],
        }


def _drawn_at_shape(
    test: LifeTest, shape: float, count: int, random: np.random.Generator
) -> tuple[FloatArray, FloatArray, bool]:
    """Draws at a known shape, and whether they are exact."""
    exact = test.scheme in ENDED_BY_FAILURES
    log_times = np.log(test.times)
    longest = float(log_times.max())
    total = float(test.counts @ np.exp(shape * (log_times - longest)))
    freedom = test.failures + (0.0 if exact else 0.5)
    log_scale = longest + (log(total) - np.log(random.standard_gamma(freedom, count))) / shape
    assert isfinite(longest)
    return np.full(count, shape), np.exp(log_scale), exact
