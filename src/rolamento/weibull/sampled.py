"""Limits from many drawn tests: pivots, parametric and plain bootstrap; the bias of the shape.

*Pivots.* Of a fit to data of a Weibull distribution, β̂/β and β̂ ln(η̂/η) have distributions that do
not depend on β and η where the test ended with failures. Their draws W and V, turned around,

    β = β̂/W,    ln η = ln η̂ - V/β̂,

are draws of the distributions that could have given the data. The quantiles of any quantity over
them are its limits: exact (but for the number of draws) where the pivots are. Where the clock ended
the test they are drawn at the fit, with its censoring (`drawing`), and are close to pivots only.

*Parametric bootstrap.* The fits to tests drawn at the fit themselves; percentiles, plain or with
the shift of their median corrected.

*Bootstrap.* Fits to the data drawn with replacement, rigs as a whole; percentiles, plain or
corrected for bias and for the change of spread with the value (BCa).

Sources: Thoman, Bain and Antle (1969); McCool (1970, 1974); Lawless (2003), section 5.2; Efron and
Tibshirani (1993), chapters 13 and 14.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import generator, one_of
from rolamento.weibull.drawing import MAXIMUM_BLOCKS, Drawing, draw_fits, model_of, portions
from rolamento.weibull.estimates import ENDED_BY_FAILURES, log_likelihood, maximum_likelihood
from rolamento.weibull.fit import Estimand, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import (
    CONVERGED,
    BatchFit,
    Likelihood,
    Rows,
    fit_rows,
    fits_of,
    joined,
)
from rolamento.weibull.limits import sample_count
from rolamento.words import Note, said

Correction = Literal["median", "mean", "ross"]

MAXIMUM_RESAMPLED: Final = 2000


@frozen(eq=False)
class Draws:
    """Distributions that could have given the data, or the code of why there are none.

    Attributes
    ----------
    code
        "converged", "not_modelled", "too_large" or "not_converged"
    shape, log_scale
        (draws,) β and ln η
    samples, dropped
        drawn tests, and how many of them had no fit and are left out
    notes
        what limits it, each once
    """

    code: str
    shape: FloatArray
    log_scale: FloatArray
    samples: int
    dropped: int
    notes: tuple[Note, ...] = ()

    def of(self, quantity: Estimand) -> FloatArray:
        """Draws of a quantity."""
        return quantity.at(self.shape, self.log_scale)


def pivotal_draws(
    test: LifeTest, fit: WeibullFit, samples: int, random: np.random.Generator
) -> Draws:
    """Distributions that could have given the data, by pivots of maximum likelihood.

    Parameters
    ----------
    test, fit
        Data, and their fit of two parameters by maximum likelihood.
    samples
        Tests to draw.
    random
        Of NumPy.
    """
    drawn = drawn_fits(test, fit, samples, random)
    shape, log_scale = fit.shape, float(np.log(fit.scale))
    ratio = drawn.shape / shape
    shift = drawn.shape * (drawn.log_scale - log_scale)
    return Draws(
        drawn.code, shape / ratio, log_scale - shift / shape, drawn.samples, drawn.dropped,
        drawn.notes,
    )  # fmt: skip


def sampled_limits(
    test: LifeTest,
    fit: WeibullFit,
    method: str,
    quantities: list[Estimand],
    tails: FloatArray,
    samples: int,
    random: np.random.Generator,
) -> tuple[FloatArray, Draws]:
    """Limits of quantities: (quantities, tails), and the draws that they come from.

    tails: probability of lying below the limit.
    """
    if method == "pivotal":
        draws = pivotal_draws(test, fit, samples, random)
    elif method.startswith("parametric"):
        draws = drawn_fits(test, fit, samples, random)
    elif test.size > MAXIMUM_BLOCKS or len(test) > MAXIMUM_RESAMPLED:
        draws = _no_draws("too_large")
    else:
        fits = resampled_fits(test, samples, random)
        draws = _kept(fits, Drawing.resampled(len(fits.code), _without_fit(fits)))
    if draws.code != "converged":
        return np.full((len(quantities), len(tails)), np.nan), draws
    levels = _percentiles(test, fit, method, quantities, tails, draws)
    limits = [
        np.quantile(draws.of(quantity), level)
        for quantity, level in zip(quantities, levels, strict=True)
    ]
    return np.array(limits), draws


def drawn_fits(test: LifeTest, fit: WeibullFit, samples: int, random: np.random.Generator) -> Draws:
    """Draw tests at a fit and fit them: the draws of its parametric bootstrap."""
    model = model_of(test)
    if isinstance(model, str):
        return _no_draws(model)
    fits = draw_fits(model, fit.shape, float(np.log(fit.scale)), samples, random)
    return _kept(fits, Drawing.of(model, len(fits.code), _without_fit(fits)))


def _kept(fits: BatchFit, drawing: Drawing) -> Draws:
    """Leave out what has no fit."""
    if drawing.code != "converged":
        return _no_draws(drawing.code)
    good = fits.code == CONVERGED
    return Draws(
        drawing.code,
        fits.shape[good],
        fits.log_scale[0, good],
        drawing.samples,
        drawing.dropped,
        drawing.notes,
    )


def _without_fit(fits: BatchFit) -> int:
    return int(np.count_nonzero(fits.code != CONVERGED))


def _no_draws(code: str) -> Draws:
    return Draws(code, np.array([]), np.array([]), 0, 0)


def _percentiles(
    test: LifeTest,
    fit: WeibullFit,
    method: str,
    quantities: list[Estimand],
    tails: FloatArray,
    draws: Draws,
) -> list[FloatArray]:
    """Percentiles of the draws to take, of each quantity."""
    if method in ("pivotal", "parametric_percentile", "bootstrap_percentile"):
        return [tails] * len(quantities)
    from scipy.special import ndtr, ndtri

    shape, log_scale = np.array([fit.shape]), np.log([fit.scale])
    jackknife = jackknife_fits(test) if method == "bootstrap_bca" else None
    levels = []
    for quantity in quantities:
        values, estimate = draws.of(quantity), quantity.at(shape, log_scale)[0]
        below = np.mean(values < estimate) + 0.5 * np.mean(values == estimate)
        edge = 0.5 / len(values)
        shift = ndtri(np.clip(below, edge, 1.0 - edge))
        bend = 0.0 if jackknife is None else _acceleration(quantity, *jackknife)
        point = shift + ndtri(tails)
        levels.append(np.asarray(ndtr(shift + point / np.maximum(1.0 - bend * point, 1e-6))))
    return levels


def _acceleration(quantity: Estimand, fits: BatchFit, counts: FloatArray) -> float:
    """Change of the spread with the value, from fits without one bearing each."""
    good = fits.code == CONVERGED
    with np.errstate(divide="ignore"):
        values = np.log(quantity.at(fits.shape[good], fits.log_scale[0, good]))
    counts = counts[good]
    if not len(values) or not np.all(np.isfinite(values)):
        return 0.0
    away = np.average(values, weights=counts) - values
    spread = float(counts @ away**2)
    return float(counts @ away**3) / (6.0 * spread**1.5) if spread > 0.0 else 0.0


# --- bearings drawn with replacement --------------------------------------------------------------


def resampled_fits(test: LifeTest, samples: int, random: np.random.Generator) -> BatchFit:
    """Fits to so many tests of bearings drawn with replacement; rigs are drawn as a whole."""
    block, row, number = _blocks_of_rows(test)
    total = int(number.sum())
    parts = []
    for count in portions(len(test), samples):
        drawn = random.multinomial(total, number / total, size=count).astype(np.float64)
        parts.append(_fits_with_counts(test, drawn[:, block] * row))
    return joined(parts)


def jackknife_fits(test: LifeTest) -> tuple[BatchFit, FloatArray]:
    """Fits with one bearing, or one rig, left out; and how many there are of each kind."""
    block, row, number = _blocks_of_rows(test)
    left = number - np.eye(len(number))
    return _fits_with_counts(test, left[:, block] * row), number


def _blocks_of_rows(test: LifeTest) -> tuple[NDArray[np.int64], FloatArray, FloatArray]:
    """Return the block of each row, bearings of the row in one block, and blocks of each kind.

    A row without a rig is a kind of block, of one bearing, of which there are so many as its count
    says; a rig is a block that there is once.
    """
    alone = test.rig == ""
    block = np.zeros(len(test), dtype=np.int64)
    block[alone] = np.arange(np.count_nonzero(alone))
    in_row = np.where(alone, 1.0, test.counts)
    number = test.counts[alone].astype(np.float64)
    if not np.all(alone):
        rigs, which = np.unique(test.rig[~alone], return_inverse=True)
        block[~alone] = len(number) + which
        number = np.append(number, np.ones(len(rigs)))
    return block, in_row, number


def _fits_with_counts(test: LifeTest, counts: FloatArray) -> BatchFit:
    """Fit the rows of a test with other counts, (samples, rows)."""
    if not test.inspected:
        log_time = np.broadcast_to(np.log(test.times), counts.shape)
        return fit_rows(Rows(log_time, counts * test.failed, counts))
    plain = Likelihood.of(test)
    interval = ~np.isnan(test.lower)
    return fits_of(
        replace(
            plain,
            failed_counts=counts[:, test.failed & ~interval],
            suspended_counts=counts[:, ~test.failed],
            interval_counts=counts[:, interval],
        )
    )


# --- the bias of the shape ------------------------------------------------------------------------


def unbiased(
    test: LifeTest | ArrayLike,
    correction: Correction = "median",
    *,
    samples: int = 10_000,
    seed: int = 0,
) -> WeibullFit:
    """Fit by maximum likelihood, with the bias of the shape taken out.

    With few failures maximum likelihood makes the shape too great: on the mean by a third, of six.
    Where the test ended with failures β̂/β has a distribution independent of β and η, so that its
    median, or its mean, can be drawn. Where the clock ended it the draws are made at the fit. Close
    to the mean, within half a per cent from four failures on, comes

        β (n - 2)/(n - 0.68)        all of n failed.

    The scale, which is hardly biased, is left. With two failures β̂ has no mean.

    Sources: Thoman, Bain and Antle (1969); Ross (1994) for the formula.

    Parameters
    ----------
    test
        With any kind of censoring for "median"; ended by failures, three at least, for "mean"; with
        all bearings failed, three at least, for "ross".
    correction
        "median" or "mean": what the drawn β̂/β has at 1. "ross": the published formula.
    samples, seed
        Tests to draw, 100 to a million, and what they are drawn with.

    Returns
    -------
    WeibullFit
        Code "no_mean" where the mean does not exist, "not_modelled" or "too_large" where the test
        cannot be drawn.

    Raises
    ------
    InputError
        For "ross" where suspensions are in the test.
    """
    one_of(correction, "correction", get_args(Correction))
    test, count, random = LifeTest.of(test), sample_count(samples), generator(seed)
    fit = maximum_likelihood(test)
    if correction == "ross" and test.scheme != "complete":
        raise InputError(
            said("is for tests without suspensions"),
            field="correction",
            value="ross",
            example="median",
        )
    if not fit.converged:
        return WeibullFit.without(test, "unbiased", fit.code)
    exact = test.scheme in ENDED_BY_FAILURES
    if correction != "median" and not (exact and test.failures >= 3):
        return WeibullFit.without(test, "unbiased", "no_mean")
    notes: tuple[Note, ...] = ()
    if correction == "ross":
        factor = bias_factor(test.size)
    else:
        draws = drawn_fits(test, fit, count, random)
        if draws.code != "converged":
            return WeibullFit.without(test, "unbiased", draws.code)
        middle = np.median(draws.shape) if correction == "median" else np.mean(draws.shape)
        factor, notes = fit.shape / float(middle), draws.notes
    shape = fit.shape * factor
    return replace(
        fit,
        method="unbiased",
        shape=shape,
        log_likelihood=log_likelihood(test, shape, fit.scale),
        notes=tuple(dict.fromkeys((*fit.notes, *notes))),
    )


def bias_factor(size: int) -> float:
    """Factor on the shape that takes out the bias of its mean, for n bearings that all failed.

    Returns
    -------
    float
        Less than 1; NaN for fewer than three, where the mean does not exist.
    """
    return (size - 2.0) / (size - 0.68) if size >= 3 else float("nan")
