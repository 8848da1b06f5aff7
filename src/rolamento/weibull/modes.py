"""Failure modes that compete: each by itself, and the bearing that fails by the first of them.

To a mode a failure by another is a suspension (`LifeTest.for_mode`). If the modes are independent
of each other, the likelihood of the lives and modes seen is the product of the likelihoods of these
tests, so that each mode is fitted by itself, and the reliabilities multiply:

    R(t) = Π R_j(t),    ℓ = Π ℓ_j,    share of mode j among failures at t = h_j(t)/Σ h(t).

Bounds of the whole come from draws of the modes: one draw of each mode's distributions that could
have given the data makes one of the whole, as the factors of the likelihood share no parameter.

Whether modes are independent the data cannot show (Tsiatis): a cause that brings on both makes the
lives without one of them come out wrong. Failures of an *unknown* mode are a mode by themselves
here. Then the whole is right, but each known mode comes out too long; `latest` and `earliest` of
`ModeResult` are what it is if none, and all, of them were of that mode.

Sources: Nelson (1982), chapter 5; Meeker and Escobar (1998), section 15.4; Crowder, Classical
Competing Risks (2001), sections 1.3 and 3.4; Tsiatis, Proc. Natl. Acad. Sci. 72 (1975) 20.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite
from rolamento.weibull.bounds import Bounds, Sides
from rolamento.weibull.distribution import LifeDistribution
from rolamento.weibull.estimates import fixed_shape, maximum_likelihood
from rolamento.weibull.fit import Estimand, Outcome, WeibullFit
from rolamento.weibull.goodness import GoodnessOfFit, goodness_of_fit
from rolamento.weibull.life_test import UNKNOWN_MODE, LifeTest
from rolamento.weibull.system import lives_of_series
from rolamento.words import Note, said

__all__ = ["METHOD", "ModeResult", "ModeSystem", "system_of_modes"]

METHOD: Final = "product_of_modes"


@frozen
class ModeResult:
    """One mode among the others.

    Attributes
    ----------
    name
        of the mode
    fit
        with all other failures suspended
    earliest
        the same if the failures of unknown mode were all of this one; None where there are none
    hazard_share
        part that it has in the cumulated hazard up to the first life that is asked for; NaN
        without
    """

    name: str
    fit: WeibullFit
    earliest: WeibullFit | None
    hazard_share: float

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; None where there is no number."""
        return {
            "name": self.name,
            "fit": self.fit.to_mapping(),
            "if_unknown_were_of_it": None if self.earliest is None else self.earliest.to_mapping(),
            "hazard_share": finite(self.hazard_share),
        }


@frozen
class ModeSystem(Outcome):
    """A bearing that fails by the first of several modes.

    Attributes
    ----------
    code
        "converged"; "mode_without_fit" where a mode has too few failures for a distribution, so
        that the product would leave it out
    modes
        each by itself
    bounds
        on the lives and reliabilities of the whole
    pooled
        one Weibull distribution of all failures, whatever their mode: what is not to be used
    goodness
        of that one
    log_likelihood, log_likelihood_pooled
        of the times without their modes, under the product and under the single distribution
    unknown
        failures of which the mode is not known
    notes
        what limits it, each once
    """

    code: str
    modes: tuple[ModeResult, ...]
    bounds: tuple[Bounds, ...]
    pooled: WeibullFit
    goodness: GoodnessOfFit
    log_likelihood: float
    unknown: int
    notes: tuple[Note, ...] = ()

    @property
    def log_likelihood_pooled(self) -> float:
        """Logarithm of the likelihood of the times under the single distribution."""
        return self.pooled.log_likelihood

    def reliability_at(self, time: FloatArray) -> FloatArray:
        """Product of the reliabilities of the modes, at times."""
        fits = [one.fit for one in self.modes]
        return np.asarray(np.prod([fit.reliability_at(time) for fit in fits], axis=0))

    def life_at_ordinate(self, ordinate: FloatArray) -> FloatArray:
        """Times at ordinates of the Weibull plot; NaN without a system."""
        shapes = np.array([one.fit.shape for one in self.modes])
        scales = np.log([one.fit.scale for one in self.modes])
        each = np.broadcast_to(shapes, (len(ordinate), len(shapes)))
        return np.exp(lives_of_series(ordinate, each, np.broadcast_to(scales, each.shape)))

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; None where there is no number."""
        return {
            "status": self.status(),
            "modes": [one.to_mapping() for one in self.modes],
            "bounds": [bound.to_mapping() for bound in self.bounds],
            "pooled": self.pooled.to_mapping(),
            "goodness_of_fit_pooled": self.goodness.to_mapping(),
            "log_likelihood": finite(self.log_likelihood),
            "log_likelihood_pooled": finite(self.log_likelihood_pooled),
            "unknown": self.unknown,
            "notes": [note.to_mapping() for note in self.notes],
        }


def system_of_modes(
    test: LifeTest,
    quantities: Sequence[Estimand],
    *,
    shape: float | None = None,
    confidence: float = 0.9,
    sides: Sides = "two",
    samples: int = 10_000,
    seed: int = 0,
) -> ModeSystem:
    """Put the modes of a life test together.

    Parameters
    ----------
    test
        With modes of failure.
    quantities
        Lives and reliabilities of the whole; its hazard is shared out at the first life.
    shape
        β from experience, of every mode.
    confidence, sides, samples, seed
        Of the bounds, as of `rolamento.weibull.bounds`.

    Raises
    ------
    InputError
        For a number that cannot be.
    """
    names = test.modes
    tests = [test.for_mode(name) for name in names]
    laws = [
        LifeDistribution.of_test(one, shape=shape, samples=samples, seed=seed + place)
        for place, one in enumerate(tests)
    ]
    fits = [_fit(one, shape) for one in tests]
    pooled = _fit(test, shape)
    goodness = goodness_of_fit(test, shape=shape, samples=min(samples, 1000), seed=seed)
    whole = all(law.converged for law in laws)
    beta = np.array([law.shape for law in laws])
    log_eta = np.log([law.scale for law in laws])
    lives = [one for one in quantities if one.kind == "life"]
    shares = np.full(len(laws), np.nan)
    if whole and lives:
        level = float(lives_of_series(lives[0].log_risk, beta, log_eta))
        hazards = np.exp(beta * (level - log_eta))
        shares = hazards / hazards.sum()
    modes = tuple(
        ModeResult(
            name or said(UNKNOWN_MODE),
            fit,
            _fit(test.for_mode(name, or_unknown=True), shape) if name and "" in names else None,
            float(part),
        )
        for name, fit, part in zip(names, fits, shares, strict=True)
    )
    notes = tuple(dict.fromkeys((Note("modes_independent"), *_of_unknown(test))))
    if not whole:
        return ModeSystem(
            "mode_without_fit", modes, (), pooled, goodness, np.nan, test.unknown_modes, notes
        )
    bounds = _bounds(test, laws, quantities, confidence, sides, samples, seed)
    value = _log_likelihood(test, beta, log_eta)
    return ModeSystem(
        "converged", modes, bounds, pooled, goodness, value, test.unknown_modes, notes
    )


def _fit(test: LifeTest, shape: float | None) -> WeibullFit:
    return maximum_likelihood(test) if shape is None else fixed_shape(test, shape)


def _of_unknown(test: LifeTest) -> tuple[Note, ...]:
    found: tuple[Note, ...] = ()
    if test.unknown_modes:
        found += (Note("modes_unknown", {"count": test.unknown_modes, "failures": test.failures}),)
    if test.inspected:
        found += (Note("modes_at_inspections"),)
    return found


def _bounds(
    test: LifeTest,
    laws: Sequence[LifeDistribution],
    quantities: Sequence[Estimand],
    confidence: float,
    sides: Sides,
    samples: int,
    seed: int,
) -> tuple[Bounds, ...]:
    beta = np.array([[law.shape for law in laws]])
    log_eta = np.log([[law.scale for law in laws]])
    draws = min((len(law.shapes) for law in laws), default=0)
    many = np.array([law.shapes[:draws] for law in laws]).T
    many_scales = np.array([np.log(law.scales[:draws]) for law in laws]).T
    notes = tuple(dict.fromkeys(note for law in laws for note in law.notes))
    tail = 1.0 - confidence
    tails = {
        "two": (tail / 2.0, 1.0 - tail / 2.0),
        "lower": (tail, 1.0),
        "upper": (0.0, 1.0 - tail),
    }
    found = []
    for quantity in quantities:
        estimate = float(_values(quantity, beta, log_eta)[0])
        code, (low, high) = "converged" if draws else "not_modelled", (np.nan, np.nan)
        if draws:
            values = np.nan_to_num(_values(quantity, many, many_scales), nan=np.inf)
            low, high = np.quantile(values, tails[sides], method="inverted_cdf")
            low = quantity.ends[0] if sides == "upper" else low
            high = quantity.ends[1] if sides == "lower" else high
        found.append(
            Bounds(
                quantity.name, METHOD, confidence, sides, estimate, float(low), float(high), code,
                test.unit if quantity.kind == "life" else "", draws,
                samples - draws if draws else 0, int(seed), notes,
            )
        )  # fmt: skip
    return tuple(found)


def _values(quantity: Estimand, shapes: FloatArray, log_scales: FloatArray) -> FloatArray:
    """Quantity of the whole for every draw: (draws,)."""
    with np.errstate(over="ignore", invalid="ignore"):
        if quantity.kind == "life":
            return np.asarray(np.exp(lives_of_series(quantity.log_risk, shapes, log_scales)))
        risk = np.exp(shapes * (np.log(quantity.value) - log_scales))
        return np.asarray(np.exp(-risk.sum(axis=-1)))


def _log_likelihood(test: LifeTest, shapes: FloatArray, log_scales: FloatArray) -> float:
    """Logarithm of the likelihood of the times without their modes."""
    z = shapes * (np.log(test.times)[:, np.newaxis] - log_scales)
    alive = -np.exp(z).sum(axis=1)
    hazard = np.log(np.sum(shapes * np.exp(z), axis=1)) - np.log(test.times)
    between = ~np.isnan(test.lower)
    with np.errstate(divide="ignore", invalid="ignore"):
        first = -np.exp(shapes * (np.log(test.lower)[:, np.newaxis] - log_scales)).sum(axis=1)
        found = np.where(test.failed, hazard + alive, alive)
        inside = first + np.log(-np.expm1(alive - first))
    return float(test.counts @ np.where(between, inside, found))
