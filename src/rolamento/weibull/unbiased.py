"""Taking the bias out of the shape.

With few failures maximum likelihood makes the shape too great: on the mean by a third, of six.
Where the test ended with failures β̂/β has a distribution that knows no β and η, so that its
median, or its mean, can be drawn. Where the clock ended it the draws are made at the fit. Close to
the mean, within half a per cent from four failures on, comes

    β (n - 2)/(n - 0.68)        all of n failed.

The scale, which is hardly biased, is left. With two failures β̂ has no mean.

Sources: Thoman, Bain and Antle (1969); Ross (1994) for the formula.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal, get_args

import numpy as np

from rolamento.errors import InputError
from rolamento.weibull._checks import generator, one_of, sample_count
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import log_likelihood, maximum_likelihood
from rolamento.weibull.sampled import drawn_fits

__all__ = ["Correction", "bias_factor", "unbiased"]

Correction = Literal["median", "mean", "ross"]


def unbiased(
    test: LifeTest,
    correction: Correction = "median",
    *,
    samples: int = 10_000,
    seed: int = 0,
) -> WeibullFit:
    """Fit by maximum likelihood, with the bias of the shape taken out.

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
    count, random = sample_count(samples), generator(seed)
    fit = maximum_likelihood(test)
    if correction == "ross" and test.scheme != "complete":
        raise InputError(
            "is for tests without suspensions", field="correction", value="ross", example="median"
        )
    if not fit.converged:
        return WeibullFit.without(test, "unbiased", fit.code)
    exact = test.scheme in ("complete", "type_ii", "sudden_death")
    if correction != "median" and not (exact and test.failures >= 3):
        return WeibullFit.without(test, "unbiased", "no_mean")
    notes: tuple[str, ...] = ()
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
