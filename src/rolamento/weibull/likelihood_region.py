"""Which shapes and lives go together: regions of equal likelihood.

Twice the fall of the logarithm of the likelihood from its maximum marks off a region that holds the
true pair of shape and scale in so many of a hundred tests. For many failures the fall that does so
is a quantile of chi-square with two degrees of freedom; for few it is greater. Here it is drawn:
tests are drawn again, with their censoring, and the fall at the true pair is seen. Where a test
ended with failures that is exact, for the fall's distribution knows no shape and no scale.

Source: Lawless (2003), sections 5.2 and 5.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.weibull import profile
from rolamento.weibull._checks import generator, sample_count, shares
from rolamento.weibull.bounds import all_bounds
from rolamento.weibull.censoring import right_censored_model
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.maximum_likelihood import maximum_likelihood
from rolamento.weibull.quantity import Quantity

__all__ = ["LikelihoodRegion", "likelihood_region"]

PROBABILITIES: Final = (0.5, 0.9, 0.95)
_NODES, _FEWER_NODES, _MANY_ROWS = 141, 41, 2000
_MARGIN: Final = 0.08
_FARTHEST_SHAPE, _FARTHEST_LIFE = np.log(30.0), np.log(1e4)
_AT_ONCE: Final = 2_000_000
_MOST_DRAWN: Final = 40_000_000
_LEAST_FITS: Final = 50


@dataclass(frozen=True, slots=True, eq=False)
class LikelihoodRegion:
    """How far the likelihood falls over shape and life; without numbers where there is no fit.

    Attributes
    ----------
    code
        "converged", or why there is none, a key of `fit.ADVICE`
    fit
        where the likelihood is greatest
    quantity
        that stands beside the shape: the scale, or a life
    shape, life
        (shapes,), (lives,) over which the fall is told; life in the unit of the test
    fall
        (lives, shapes) twice the fall of the logarithm of the likelihood
    probabilities, levels
        falls within which the true pair lies with these probabilities
    drawn
        whether the levels are drawn; from chi-square otherwise, which holds for many failures
    """

    code: str
    fit: WeibullFit
    quantity: Quantity
    shape: FloatArray
    life: FloatArray
    fall: FloatArray
    probabilities: tuple[float, ...]
    levels: tuple[float, ...]
    drawn: bool

    @property
    def converged(self) -> bool:
        """Whether there is a region."""
        return self.code == "converged"


def likelihood_region(
    test: LifeTest,
    quantity: str | Quantity = "scale",
    probabilities: Sequence[float] = PROBABILITIES,
    *,
    samples: int = 10_000,
    seed: int = 0,
) -> LikelihoodRegion:
    """Find the regions of equal likelihood of a test.

    Parameters
    ----------
    test
        With any kind of censoring.
    quantity
        "scale", or a life such as "L10", to stand beside the shape.
    probabilities
        That the regions are for.
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with.

    Raises
    ------
    InputError
        For another quantity, or a number out of range.
    """
    life = Quantity.of(quantity)
    if life.kind != "life":
        raise InputError(
            "must be scale or a life", field="quantity", value=life.name, example="L10"
        )
    wanted = tuple(float(p) for p in shares(probabilities, "probabilities"))
    count, random = sample_count(samples), generator(seed)
    fit = maximum_likelihood(test)
    if not fit.converged:
        nothing = np.array([])
        return LikelihoodRegion(
            fit.code, fit, life, nothing, nothing, np.empty((0, 0)), wanted, (), False
        )
    falls = _drawn_falls(test, fit, count, random)
    if falls is None:
        from scipy.stats import chi2

        levels = chi2.ppf(wanted, 2)
    else:
        levels = np.quantile(falls, wanted)
    shapes, lives = _grid(test, fit, life, float(np.max(levels)))
    return LikelihoodRegion(
        "converged", fit, life, shapes, lives, _falls_over(test, fit, life, shapes, lives), wanted,
        tuple(float(level) for level in levels), falls is not None,
    )  # fmt: skip


def _grid(
    test: LifeTest, fit: WeibullFit, life: Quantity, level: float
) -> tuple[FloatArray, FloatArray]:
    """Shapes and lives that hold the greatest region, evenly spread in their logarithms."""
    from scipy.special import ndtr

    # the limits of each by itself, at the same fall of the likelihood
    limits = [
        (one.lower, one.upper)
        for one in all_bounds(
            test,
            ["shape", life],
            method="likelihood_ratio",
            confidence=float(2.0 * ndtr(level**0.5) - 1.0),
        )
    ]
    estimates = fit.shape, float(life.at(np.array([fit.shape]), np.log([fit.scale]))[0])
    nodes = _NODES if len(test) <= _MANY_ROWS else _FEWER_NODES
    grids = []
    for (low, high), estimate, farthest in zip(
        limits, estimates, (_FARTHEST_SHAPE, _FARTHEST_LIFE), strict=True
    ):
        with np.errstate(divide="ignore"):
            ends = np.log(np.array([low, high])) - np.log(estimate)
        ends = np.where(np.isnan(ends), [-farthest, farthest], ends)
        below, above = np.clip(ends, -farthest, farthest)
        room = _MARGIN * (above - below)
        grids.append(estimate * np.exp(np.linspace(below - room, above + room, nodes)))
    return grids[0], grids[1]


def _falls_over(
    test: LifeTest, fit: WeibullFit, life: Quantity, shapes: FloatArray, lives: FloatArray
) -> FloatArray:
    likelihood = Likelihood.of(test)
    shape, log_life = (grid.ravel() for grid in np.meshgrid(shapes, np.log(lives)))
    shift = shape * (likelihood.origin - log_life) + life.log_risk
    step = max(_AT_ONCE // len(test), 1)
    values = [
        likelihood.value(shape[i : i + step], shift[i : i + step])
        for i in range(0, len(shape), step)
    ]
    top = likelihood.value(
        np.array([fit.shape]), np.array([fit.shape * (likelihood.origin - np.log(fit.scale))])
    )
    fall = 2.0 * (top[0] - np.concatenate(values))
    return np.where(np.isnan(fall), np.inf, fall).reshape(len(lives), len(shapes))


def _drawn_falls(
    test: LifeTest, fit: WeibullFit, samples: int, random: np.random.Generator
) -> FloatArray | None:
    """Falls at the true pair, of tests drawn at the fit; None where they cannot be drawn."""
    model = None if test.inspected else right_censored_model(test)
    if model is None or isinstance(model, str):
        return None
    samples = min(samples, max(_MOST_DRAWN // model.width, 100))
    step = max(_AT_ONCE // model.width, 1)
    log_scale = float(np.log(fit.scale))
    parts = [
        _falls_of(model.rows(fit.shape, log_scale, min(step, samples - first), random), fit)
        for first in range(0, samples, step)
    ]
    falls = np.concatenate(parts)
    return falls if len(falls) >= _LEAST_FITS else None


def _falls_of(rows: profile.Rows, fit: WeibullFit) -> FloatArray:
    """Falls at a fit, of tests that were drawn at it; those that have a fit of their own."""
    shape, log_scale = fit.shape, float(np.log(fit.scale))
    found = profile.fit_rows(rows)
    failures = np.broadcast_to(rows.failures, rows.log_time.shape)
    r = failures.sum(axis=1)
    failed = np.sum(failures * rows.log_time, axis=1)
    risk = np.sum(rows.units * np.exp(shape * (rows.log_time - log_scale)), axis=1)
    at_true = r * np.log(shape) + shape * (failed - r * log_scale) - risk
    with np.errstate(invalid="ignore"):
        at_best = r * np.log(found.shape) + found.shape * (failed - r * found.log_scale[0]) - r
        fall = 2.0 * (at_best - at_true)
    good = (found.code == profile.CONVERGED) & (r >= 2.0) & np.isfinite(fall)
    return np.asarray(np.maximum(fall[good], 0.0))
