"""Other distributions beside Weibull's, for a life test that contradicts it, by their likelihoods.

    weibull              R = exp(-(t/η)^β)
    three_parameter      R = exp(-((t - γ)/η)^β)                     a failure-free time γ
    lognormal            R = Φ((μ - ln t)/σ)
    limited_population   R = 1 - p + p exp(-(t/η)^β)                 only a part p can fail
    mixture              R = p exp(-(t/η₁)^β₁) + (1 - p) exp(-(t/η₂)^β₂)   two populations
    two_modes            R = exp(-(t/η₁)^β₁ - (t/η₂)^β₂)             two modes of each bearing

All are fitted by maximum likelihood to the times alone. With k parameters and r failures

    AICc = -2 ln ℓ + 2k + 2k(k + 1)/(r - k - 1),

whose second order needs the failures, as suspensions bring little; smaller is better, and a
difference below 2 says little. It compares, and proves nothing: whether one population has two
modes, or two populations one each, is seen on the bearings and not in the times.

The likelihood of `mixture`, `limited_population` and `two_modes` grows without bound as a part of
them shrinks onto a single failure (β → ∞). Maxima with a shape beyond `MAXIMUM_SHAPE` are such
spikes and are passed over.

Sources: Meeker and Escobar (1998), chapters 4 and 5, sections 11.5 (limited population), 15.4
(modes); Hurvich and Tsai, Biometrika 76 (1989) 297, for AICc; Burnham and Anderson, Model Selection
and Multimodel Inference (2002), sections 2.4 and 2.6; Volinsky and Raftery, Biometrics 56 (2000)
256, for failures as the size of a censored sample; Kay, J. R. Statist. Soc. C 35 (1986), and
McLachlan and Peel, Finite Mixture Models (2000), section 3.8, for the spikes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from math import exp, inf, log
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, share
from rolamento.weibull.estimates import maximum_likelihood, three_parameter
from rolamento.weibull.fit import Outcome, WeibullFit
from rolamento.weibull.life_test import LifeTest

__all__ = ["MODELS", "LifeModel", "life_models"]

MODELS: Final = (
    "weibull",
    "three_parameter",
    "lognormal",
    "limited_population",
    "mixture",
    "two_modes",
)
MAXIMUM_SHAPE: Final = 30.0
_MINIMUM_SHAPE: Final = 0.1
_FARTHEST: Final = 9.0
"""Logarithm of how far a scale may lie from the data."""
_MOST_ROWS: Final = 5000
_LEAST: Final = 1e-300
_WORST: Final = 1e300
_DIFFERENCE: Final = 1e-5
_NEAR: Final = 1e-3
_MOST_STEPS: Final = 300


@frozen
class LifeModel(Outcome):
    """A distribution fitted to a life test by maximum likelihood; NaN where there is no fit.

    Attributes
    ----------
    name
        one of `MODELS`
    code
        "converged", or why there is no fit, a code that `advice` explains
    parameters
        by their names: shape, scale, location, share; mu and sigma of ln t; unit of the test
    log_likelihood
        of the data
    aicc
        Akaike's criterion of the second order; NaN with too few failures for it
    l10
        life that 90 % reach, in the unit of the test; infinite where more than that never fail
    """

    name: str
    code: str
    parameters: Mapping[str, float] = field(default_factory=dict)
    log_likelihood: float = np.nan
    aicc: float = np.nan
    l10: float = np.nan

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; None where there is no number."""
        return {
            "name": self.name,
            "status": self.status(),
            "parameters": {name: finite(x) for name, x in self.parameters.items()},
            "log_likelihood": finite(self.log_likelihood),
            "aicc": finite(self.aicc),
            "l10": finite(self.l10),
        }


class _Law(NamedTuple):
    """Logarithms of the density and of the reliability at times; arrays."""

    density: FloatArray
    reliability: FloatArray


_Shape = Callable[[FloatArray, FloatArray], _Law]
"""Function of ln t, (times, 1), and of the searched parameters, (parameters, points): (times,
points)."""


def life_models(test: LifeTest | ArrayLike, names: Iterable[str] = MODELS) -> tuple[LifeModel, ...]:
    """Fit distributions to a life test, for their likelihoods to be compared.

    Parameters
    ----------
    test
        With any kind of censoring; of modes of failure nothing is taken.
    names
        Of `MODELS`.

    Returns
    -------
    tuple of LifeModel
        In the order of the names. Code "no_maximum" where only a spike was found.
    """
    test = LifeTest.of(test)
    return tuple(_fitted(test, name) for name in names)


def aicc_of(log_likelihood: float, parameters: int, failures: int) -> float:
    """Akaike's criterion of the second order; NaN where the failures are too few for it."""
    spare = failures - parameters - 1
    if spare <= 0:
        return float("nan")
    return -2.0 * log_likelihood + 2.0 * parameters * (1.0 + (parameters + 1.0) / spare)


def _fitted(test: LifeTest, name: str) -> LifeModel:
    if name in ("weibull", "three_parameter"):
        fit = maximum_likelihood(test) if name == "weibull" else three_parameter(test)
        return _of_fit(test, name, fit)
    plain = maximum_likelihood(test)
    if not plain.converged:
        return LifeModel(name, plain.code)
    if len(test) > _MOST_ROWS:
        return LifeModel(name, "too_large")
    return _maximum(test, name, plain)


def _of_fit(test: LifeTest, name: str, fit: WeibullFit) -> LifeModel:
    if not fit.converged:
        return LifeModel(name, fit.code)
    parameters = {"shape": fit.shape, "scale": fit.scale}
    if name == "three_parameter":
        parameters["location"] = fit.location
    aicc = aicc_of(fit.log_likelihood, len(parameters), test.failures)
    return LifeModel(name, "converged", parameters, fit.log_likelihood, aicc, fit.l10)


# --- the distributions, by ln t and the parameters that are searched ------------------------------


def _weibull(y: FloatArray, log_shape: FloatArray, log_scale: FloatArray) -> _Law:
    z = np.exp(log_shape) * (y - log_scale)
    risk = np.exp(np.minimum(z, 700.0))
    return _Law(log_shape + z - risk - y, -risk)


def _lognormal(y: FloatArray, x: FloatArray) -> _Law:
    from scipy.special import log_ndtr

    z = (y - x[0]) / np.exp(x[1])
    return _Law(-0.5 * z * z - 0.5 * log(2.0 * np.pi) - x[1] - y, log_ndtr(-z))


def _limited(y: FloatArray, x: FloatArray) -> _Law:
    law = _weibull(y, x[1], x[2])
    part = _log_share(x[0])
    return _Law(part + law.density, np.logaddexp(_log_share(-x[0]), part + law.reliability))


def _mixed(y: FloatArray, x: FloatArray) -> _Law:
    one, other = _weibull(y, x[1], x[2]), _weibull(y, x[3], x[4])
    p, q = _log_share(x[0]), _log_share(-x[0])
    return _Law(*(np.logaddexp(p + a, q + b) for a, b in zip(one, other, strict=True)))


def _two_modes(y: FloatArray, x: FloatArray) -> _Law:
    one, other = _weibull(y, x[0], x[1]), _weibull(y, x[2], x[3])
    alive = one.reliability + other.reliability
    hazard = np.logaddexp(one.density - one.reliability, other.density - other.reliability)
    return _Law(hazard + alive, alive)


def _log_share(logit: FloatArray) -> FloatArray:
    """Ln p of p = 1/(1 + e^-x)."""
    return np.asarray(-np.logaddexp(0.0, -logit))


_LAWS: Final[Mapping[str, tuple[_Shape, tuple[str, ...]]]] = {
    "lognormal": (_lognormal, ("mu", "sigma")),
    "limited_population": (_limited, ("share", "shape", "scale")),
    "mixture": (_mixed, ("share", "shape", "scale", "shape_2", "scale_2")),
    "two_modes": (_two_modes, ("shape", "scale", "shape_2", "scale_2")),
}


# --- how they are fitted --------------------------------------------------------------------------


def _maximum(test: LifeTest, name: str, plain: WeibullFit) -> LifeModel:
    """Search the greatest maximum from several places; spikes are passed over."""
    from scipy.optimize import minimize

    law, parameters = _LAWS[name]
    cost = _cost_of(test, law)
    y = np.log(test.times)
    bounds = np.array([_limits(one, float(y.min()), float(y.max())) for one in parameters])
    low, high = bounds.T
    steps = _DIFFERENCE * np.concatenate([np.eye(len(low)), -np.eye(len(low))]).T

    def value_and_slope(x: FloatArray) -> tuple[float, FloatArray]:
        """Value, and central differences, all points at once."""
        around = cost(np.column_stack([x, x[:, np.newaxis] + steps]))
        ahead, behind = np.split(around[1:], 2)
        return float(around[0]), np.asarray((ahead - behind) / (2.0 * _DIFFERENCE))

    best, where = inf, None
    for start in _starts(test, name, plain):
        found = minimize(
            value_and_slope, np.clip(start, low, high), jac=True, method="TNC", bounds=bounds,
            options={"maxfun": _MOST_STEPS, "ftol": 1e-11, "xtol": 1e-9, "gtol": 1e-9},
        )  # fmt: skip
        if np.isfinite(found.fun) and found.fun < best and not _at_an_edge(found.x, parameters):
            best, where = float(found.fun), found.x
    if where is None:
        return LifeModel(name, "no_maximum")
    return LifeModel(
        name,
        "converged",
        _named(where, parameters),
        -best,
        aicc_of(-best, len(parameters), test.failures),
        _life(law, where, float(y.min()), float(y.max())),
    )


def _cost_of(test: LifeTest, law: _Shape) -> Callable[[FloatArray], FloatArray]:
    """Return what is to be least, of many points: minus the logarithm of the likelihood."""
    y = np.log(test.times)[:, np.newaxis]
    between = ~np.isnan(test.lower)
    exact, running = test.failed & ~between, ~test.failed
    counts = test.counts.astype(np.float64)
    with np.errstate(divide="ignore"):
        low = np.log(np.maximum(test.lower[between], _LEAST))[:, np.newaxis]

    def cost(x: FloatArray) -> FloatArray:
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            total = counts[exact] @ law(y[exact], x).density
            total += counts[running] @ law(y[running], x).reliability
            if between.any():
                first, last = (np.exp(law(at, x).reliability) for at in (low, y[between]))
                total += counts[between] @ np.log(np.maximum(first - last, _LEAST))
        return np.where(np.isfinite(total), -total, _WORST)

    return cost


def _limits(parameter: str, low: float, high: float) -> tuple[float, float]:
    if parameter.startswith("shape"):
        return log(_MINIMUM_SHAPE), log(MAXIMUM_SHAPE)
    if parameter == "sigma":
        return log(0.01), log(20.0)
    if parameter == "share":
        return -8.0, 8.0
    return low - _FARTHEST, high + _FARTHEST


def _at_an_edge(x: FloatArray, parameters: tuple[str, ...]) -> bool:
    """Whether a shape is as great or as small as it may be: a spike, or no maximum at all."""
    low, high = log(_MINIMUM_SHAPE) + _NEAR, log(MAXIMUM_SHAPE) - _NEAR
    shapes = [value for value, one in zip(x, parameters, strict=True) if one.startswith("shape")]
    return any(not low < value < high for value in shapes)


def _starts(test: LifeTest, name: str, plain: WeibullFit) -> list[list[float]]:
    """Places to search from: the plain fit, and the data parted at several of their failures."""
    shape, scale = log(plain.shape), log(plain.scale)
    failures = np.log(test.times[test.failed])
    if name == "lognormal":
        spread = max(float(np.std(failures)), 0.05)
        return [[float(np.mean(failures)), log(spread)], [scale, log(1.2 / plain.shape)]]
    if name == "limited_population":
        reached = np.clip(test.failures / test.size, 0.02, 0.98)
        places = ((shape, scale), (shape + 0.7, float(np.quantile(failures, 0.7))))
        return [
            [log(p / (1.0 - p)), *place]
            for p in (reached, 0.5 * (1.0 + reached), 0.99)
            for place in places
        ]
    starts = []
    for part in (0.15, 0.35, 0.6):
        cut = float(np.quantile(failures, part))
        early, late = failures[failures <= cut], failures[failures >= cut]
        if name == "mixture":
            logit = log(part / (1.0 - part))
            starts.append([logit, *_plain_start(early), *_plain_start(late)])
            starts.append([logit, log(0.8), float(early.mean()), *_plain_start(late)])
        else:
            first = float(early.mean()) - log(part)
            starts.append([log(0.7), first, log(4.0), float(np.quantile(late, 0.7))])
            starts.append([shape - 0.5, scale + 1.0, shape + 0.8, scale])
    return starts


def _plain_start(log_times: FloatArray) -> tuple[float, float]:
    """Shape and scale, in logarithms, that some failures have by their moments."""
    spread = max(float(np.std(log_times)), 0.1)
    return log(min(1.28 / spread, 10.0)), float(log_times.mean()) + 0.45 * spread


def _named(x: FloatArray, parameters: tuple[str, ...]) -> dict[str, float]:
    values = {}
    for value, one in zip(x.tolist(), parameters, strict=True):
        values[one] = (
            value if one == "mu" else 1.0 / (1.0 + exp(-value)) if one == "share" else exp(value)
        )
    if values.get("scale_2", inf) < values.get("scale", 0.0):  # the earlier part is named first
        turned = {one: values[f"{one}_2"] for one in ("shape", "scale")}
        turned |= {f"{one}_2": values[one] for one in ("shape", "scale")}
        if "share" in values:
            turned["share"] = 1.0 - values["share"]
        values |= turned
    return values


def _life(law: _Shape, x: FloatArray, low: float, high: float, reliability: float = 0.9) -> float:
    """Life that a share reach; infinite where it never falls so low."""
    from scipy.optimize import brentq

    wanted = log(share(reliability, "reliability"))

    def excess(y: float) -> float:
        return float(law(np.array([[y]]), x[:, np.newaxis]).reliability[0, 0]) - wanted

    first, last = low - 100.0, high + 3.0 * _FARTHEST
    if excess(last) > 0.0:
        return inf
    return float(np.exp(brentq(excess, first, last))) if excess(first) > 0.0 else 0.0
