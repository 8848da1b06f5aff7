"""Maximum likelihood of two parameters: the fit that everything else is measured by.

Right-censored tests by their profile equation (`profile`), inspected ones by Newton's method
(`concave`). Suspensions count with the time that they ran.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.weibull import concave, profile
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood

__all__ = ["CODES", "maximum_likelihood", "rows_of"]

CODES: Final = {
    profile.CONVERGED: "converged",
    profile.NO_FAILURES: "no_failures",
    profile.NO_SPREAD: "no_spread",
    profile.NOT_CONVERGED: "not_converged",
    concave.NO_MAXIMUM: "no_maximum",
}
FEW: Final = 5


def maximum_likelihood(test: LifeTest) -> WeibullFit:
    """Fit shape and scale by maximum likelihood.

    Parameters
    ----------
    test
        With any kind of censoring.

    Returns
    -------
    WeibullFit
        Without numbers for fewer than two failures, or where all fall together.
    """
    code = too_few(test)
    if code:
        return WeibullFit.without(test, "maximum_likelihood", code)
    shape, log_scale, name = _inspected(test) if test.inspected else _right_censored(test)
    if name != "converged":
        return WeibullFit.without(test, "maximum_likelihood", name)
    return found(test, "maximum_likelihood", shape, float(np.exp(log_scale)))


def rows_of(test: LifeTest) -> profile.Rows:
    """Give a right-censored test as one sample for the batch fit."""
    counts = test.counts.astype(np.float64)
    return profile.Rows(np.log(test.times)[np.newaxis], counts * test.failed, counts)


def too_few(test: LifeTest) -> str:
    """Return the code of a test that has too few failures for a shape; empty otherwise."""
    return {0: "no_failures", 1: "one_failure"}.get(test.failures, "")


def found(test: LifeTest, method: str, shape: float, scale: float, **more: float) -> WeibullFit:
    """Give the record of a fit to a test, with its likelihood and what to note."""
    location = more.get("location", 0.0)
    value = log_likelihood(test, shape, scale, location)
    notes = ("few_failures",) if test.failures < FEW else ()
    return WeibullFit(
        method,
        "converged",
        shape,
        scale,
        log_likelihood=value,
        failures=test.failures,
        size=test.size,
        unit=test.unit,
        notes=notes,
        **more,
    )


def log_likelihood(test: LifeTest, shape: float, scale: float, location: float = 0.0) -> float:
    """Logarithm of the likelihood of a test under a Weibull distribution."""
    likelihood = Likelihood.of(test, location)
    a, b = np.array([shape]), np.array([shape * (likelihood.origin - np.log(scale))])
    return float(likelihood.at(a, b).value[0])


def _right_censored(test: LifeTest) -> tuple[float, float, str]:
    fit = profile.fit_rows(rows_of(test))
    return float(fit.shape[0]), float(fit.log_scale[0, 0]), CODES[int(fit.code[0])]


def _inspected(test: LifeTest) -> tuple[float, float, str]:
    fit = concave.maximise(Likelihood.of(test))
    a, b = float(fit.a[0]), float(fit.b[0])
    return a, -b / a, CODES[int(fit.code[0])]
