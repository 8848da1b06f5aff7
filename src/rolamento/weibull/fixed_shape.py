"""A shape from experience, and only the scale from the test ("Weibayes").

With a known shape the times t^β are exponential: η^β = Σ v t^β / r, and 2 Σ v t^β / η^β has a
chi-square distribution: with 2r degrees of freedom where the test ended with a failure; where it
was ended by the clock 2r + 2 are on the safe side for the lower bound. So it bounds the life from
below even if nothing failed:

    η > (2 Σ v t^β / χ²_{C; 2r+2})^(1/β).

The bounds are as good as the shape is.

Sources: Abernethy (2006), chapter 6; Epstein and Sobel (1953).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.weibull._checks import shape_of
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.maximum_likelihood import found
from rolamento.weibull.quantity import Quantity

__all__ = ["fixed_shape", "fixed_shape_limits", "fixed_shape_tails", "log_scale_at"]

_ENDS_WITH_A_FAILURE = ("complete", "type_ii", "sudden_death")


def fixed_shape(test: LifeTest, shape: float) -> WeibullFit:
    """Fit the scale by maximum likelihood at a known shape.

    Parameters
    ----------
    test
        With any kind of censoring; one failure is enough.
    shape
        β, from earlier tests of the same kind.

    Returns
    -------
    WeibullFit
        With the shape but no scale if nothing failed (see `fixed_shape_limits`).
    """
    beta = shape_of(shape)
    if not test.failures:
        return replace(
            WeibullFit.without(test, "fixed_shape", "no_failures"), shape=beta, location=0.0
        )
    log_scale = log_scale_at(test, beta)
    if not np.isfinite(log_scale):
        return WeibullFit.without(test, "fixed_shape", "no_maximum")
    return found(test, "fixed_shape", beta, float(np.exp(log_scale)))


def fixed_shape_limits(
    test: LifeTest, shape: float, quantity: Quantity, tails: FloatArray
) -> FloatArray:
    """Limits of a life or a reliability at a known shape.

    Parameters
    ----------
    test
        With any kind of censoring, and any number of failures.
    shape
        β.
    quantity
        A life, the scale, or a reliability.
    tails
        (limits,) probability of being below the limit: 0.05 for a lower limit at 95 %.

    Returns
    -------
    (limits,); infinite, or 1, for an upper limit without failures.
    """
    from scipy.stats import chi2

    beta = shape_of(shape)
    limits = []
    for tail in tails:
        freedom, log_total = _evidence(test, beta, lower=bool(tail < 0.5))
        point = chi2.ppf(1.0 - tail, freedom) if freedom else 0.0
        with np.errstate(divide="ignore"):
            limits.append((np.log(2.0) + log_total - np.log(point)) / beta)
    return quantity.at(np.full(len(limits), beta), np.array(limits))


def fixed_shape_tails(
    test: LifeTest, shape: float, quantity: Quantity, life: float
) -> tuple[float, float]:
    """Confidence with which a life is less, and more, than a value, at a known shape.

    Both on the safe side; parameters as of `fixed_shape_limits`.
    """
    from scipy.stats import chi2

    beta = shape_of(shape)
    log_risk = quantity.log_risk - beta * np.log(life)
    tails = []
    for lower in (True, False):
        freedom, log_total = _evidence(test, beta, lower=lower)
        with np.errstate(over="ignore"):
            point = 2.0 * np.exp(log_total + log_risk)
        below = float(chi2.cdf(point, freedom)) if freedom else 0.0
        tails.append(1.0 - below if lower else (below if freedom else 1.0))
    return tails[0], tails[1]


def _evidence(test: LifeTest, shape: float, *, lower: bool) -> tuple[int, float]:
    """Degrees of freedom, and ln Σ v t^β, for a lower or an upper limit."""
    exact = test.scheme in _ENDS_WITH_A_FAILURE
    freedom = 2 * test.failures + (2 if lower and not exact else 0)
    # an inspected failure counts from where it was last seen whole, or to where it was found
    early = lower & ~np.isnan(test.lower)
    with np.errstate(divide="ignore"):
        log_time = np.log(np.where(early, test.lower, test.times))
    longest = float(log_time.max())
    if not np.isfinite(longest):
        return freedom, -np.inf
    total = np.sum(test.counts * np.exp(shape * (log_time - longest)))
    return freedom, shape * longest + float(np.log(total))


def log_scale_at(test: LifeTest, shape: float) -> float:
    """Logarithm of the scale that fits best at a shape; NaN where there is none."""
    if not test.inspected:
        y = np.log(test.times)
        longest = y.max()
        total = np.log(np.sum(test.counts * np.exp(shape * (y - longest))))
        return float(longest + (total - np.log(test.failures)) / shape)
    likelihood = Likelihood.of(test)
    a = np.array([shape])

    def falling(level: FloatArray) -> tuple[FloatArray, FloatArray]:
        here = likelihood.at(a, np.log(level))
        return -here.b, -here.bb / level

    middle = np.concatenate([likelihood.failed, likelihood.suspended, likelihood.upper])
    start = np.exp(-shape * np.array([middle.mean()]))
    found_, converged = increasing_root(falling, start, np.array([0.0]), np.array([np.inf]))
    if not converged[0]:
        return float("nan")
    return float(likelihood.origin - np.log(found_[0]) / shape)
