"""Limits from many drawn tests: pivots, parametric and plain bootstrap.

*Pivots.* Of a fit to data of a Weibull distribution, β̂/β and β̂ ln(η̂/η) have distributions that do
not depend on β and η where the test ended with failures. Their draws W and V, turned around,

    β = β̂/W,    ln η = ln η̂ - V/β̂,

are draws of the distributions that could have given the data. The quantiles of any quantity over
them are its limits: exact (but for the number of draws) where the pivots are. Where the clock ended
the test they are drawn at the fit, with its censoring (`censoring`), and are close to pivots only.

*Parametric bootstrap.* The fits to tests drawn at the fit themselves; percentiles, plain or with
the shift of their median corrected.

*Bootstrap.* Fits to the data drawn with replacement, rigs as a whole; percentiles, plain or
corrected for bias and for the change of spread with the value (BCa).

Sources: Thoman, Bain and Antle (1969); McCool (1970, 1974); Lawless (2003), section 5.2; Efron and
Tibshirani (1993), chapters 13 and 14.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.weibull import profile
from rolamento.weibull.censoring import MOST_BLOCKS, draw_fits, model_of
from rolamento.weibull.drawing import Drawing
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.profile import BatchFit
from rolamento.weibull.quantity import Quantity
from rolamento.weibull.resampling import MOST_ROWS, jackknife_fits, resampled_fits

__all__ = ["Draws", "drawn_fits", "pivotal_draws", "sampled_limits"]


@dataclass(frozen=True, slots=True, eq=False)
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
        names in `fit.NOTES`
    """

    code: str
    shape: FloatArray
    log_scale: FloatArray
    samples: int
    dropped: int
    notes: tuple[str, ...] = ()

    def of(self, quantity: Quantity) -> FloatArray:
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
    quantities: list[Quantity],
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
    elif test.size > MOST_BLOCKS or len(test) > MOST_ROWS:
        draws = _nothing("too_large")
    else:
        fits = resampled_fits(test, samples, random)
        draws = _kept(fits, Drawing.resampled(len(fits.code), _without_fit(fits)))
    if draws.code != "converged":
        return np.full((len(quantities), len(tails)), np.nan), draws
    levels = _levels(test, fit, method, quantities, tails, draws)
    limits = [
        np.quantile(draws.of(quantity), level)
        for quantity, level in zip(quantities, levels, strict=True)
    ]
    return np.array(limits), draws


def drawn_fits(test: LifeTest, fit: WeibullFit, samples: int, random: np.random.Generator) -> Draws:
    """Draw tests at a fit and fit them: the draws of its parametric bootstrap."""
    model = model_of(test)
    if isinstance(model, str):
        return _nothing(model)
    fits = draw_fits(model, fit.shape, float(np.log(fit.scale)), samples, random)
    return _kept(fits, Drawing.of(model, len(fits.code), _without_fit(fits)))


def _kept(fits: BatchFit, drawing: Drawing) -> Draws:
    """Leave out what has no fit."""
    if drawing.code != "converged":
        return _nothing(drawing.code)
    good = fits.code == profile.CONVERGED
    return Draws(
        drawing.code,
        fits.shape[good],
        fits.log_scale[0, good],
        drawing.samples,
        drawing.dropped,
        drawing.notes,
    )


def _without_fit(fits: BatchFit) -> int:
    return int(np.count_nonzero(fits.code != profile.CONVERGED))


def _nothing(code: str) -> Draws:
    return Draws(code, np.array([]), np.array([]), 0, 0)


def _levels(
    test: LifeTest,
    fit: WeibullFit,
    method: str,
    quantities: list[Quantity],
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


def _acceleration(quantity: Quantity, fits: BatchFit, counts: FloatArray) -> float:
    """Change of the spread with the value, from fits without one bearing each."""
    good = fits.code == profile.CONVERGED
    with np.errstate(divide="ignore"):
        values = np.log(quantity.at(fits.shape[good], fits.log_scale[0, good]))
    counts = counts[good]
    if not len(values) or not np.all(np.isfinite(values)):
        return 0.0
    away = np.average(values, weights=counts) - values
    spread = float(counts @ away**2)
    return float(counts @ away**3) / (6.0 * spread**1.5) if spread > 0.0 else 0.0
