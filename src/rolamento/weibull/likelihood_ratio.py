"""Limits and regions from the shape of the likelihood: its curvature, or how far it falls.

*Fisher.* The inverse of the observed information gives the variance of (a, b); limits are normal in
ln β, in ln t_R, and in -ln(-ln R).

*Likelihood ratio.* A value of a quantity lies within the limits as long as twice the fall of the
logarithm of the likelihood, at the best of the distributions that have that value, is less than a
quantile of chi-square with one degree of freedom.

With w = ln(-ln R) and c = ln t, a life t_R and the reliability at t are both the line b = w - a c
in the (a, b) of `likelihood`: along it the likelihood has one maximum, which a root finds.

*Calibrated.* Let R be the signed root of twice the fall of the likelihood from its maximum to a
value of a quantity, positive where the estimate lies above the value. For many failures R is
normal. For few it is drawn: of tests drawn at the fit, at the value that the fit has. Where the
test ended with failures the distribution of R depends on neither shape nor scale, and the limits
are exact; where the clock ended it R depends on them but little, much less than the pivots of
`sampled` do.

*Regions.* Twice the fall of the logarithm of the likelihood from its maximum marks off a region
that holds the true pair of shape and scale in so many of a hundred tests. For many failures the
fall that does so is a quantile of chi-square with two degrees of freedom; for few it is greater.
Here it is drawn: tests are drawn again, with their censoring, and the fall at the true pair is
seen. Where a test ended with failures that is exact, for the fall's distribution knows no shape and
no scale.

Sources: Lawless (2003), sections 5.2 and 5.3; Venzon and Moolgavkar (1988) for the profile; Jeng
and Meeker (2000) and Doganaksoy and Schmee (1993) for the calibration.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.root import ValueAndSlope, increasing_root
from rolamento.records import frozen
from rolamento.validate import generator, shares
from rolamento.weibull.drawing import (
    MINIMUM_FITS,
    Drawing,
    Inspected,
    model_of,
    portions,
    right_censored_model,
)
from rolamento.weibull.estimates import maximum_likelihood
from rolamento.weibull.fit import Estimand, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import CONVERGED, Likelihood, Rows, fit_rows, fits_of
from rolamento.weibull.limits import sample_count
from rolamento.words import said

Kind = Literal["shape", "life", "reliability"]
Limits = Callable[["Hill", Kind, FloatArray, list[int]], FloatArray]

_FARTHEST: Final = {"shape": 15.0, "life": 300.0, "reliability": 300.0}
_MUCH: Final = 1e200
PROBABILITIES: Final = (0.5, 0.9, 0.95)
_NODES, _FEWER_NODES, _MANY_ROWS = 141, 41, 2000
_MARGIN: Final = 0.08
_FARTHEST_SHAPE, _FARTHEST_LIFE = np.log(30.0), np.log(1e4)
_REGION_AT_ONCE: Final = 2_000_000
_MAXIMUM_DRAWN: Final = 40_000_000


def fisher_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Estimand], tails: FloatArray
) -> FloatArray:
    """Limits by the observed information: (quantities, tails); tails: probability below."""
    from scipy.special import ndtri

    points = np.asarray(ndtri(tails))

    def limits(hill: Hill, kind: Kind, level: FloatArray, places: list[int]) -> FloatArray:
        top, spread = hill.coordinate(kind, level), hill.spread(kind, level)
        found = top[:, np.newaxis] + points * spread[:, np.newaxis]
        return hill.value_of(kind, found)

    return _by_kind(test, fit, quantities, len(tails), limits)


def likelihood_ratio_limits(
    test: LifeTest, fit: WeibullFit, quantities: list[Estimand], roots: FloatArray
) -> FloatArray:
    """Limits by the likelihood ratio: (quantities, limits).

    roots: (quantities, limits), the roots of twice the fall of the likelihood there, with the sign
    of the limit less the estimate; quantiles of the normal distribution for many failures.
    """
    count = roots.shape[1]

    def limits(hill: Hill, kind: Kind, level: FloatArray, places: list[int]) -> FloatArray:
        lanes = _limits_of_kind(hill, kind, np.repeat(level, count), roots[places].ravel())
        return lanes.reshape(len(places), count)

    return _by_kind(test, fit, quantities, count, limits)


def profile_fall(
    test: LifeTest, fit: WeibullFit, quantity: Estimand, value: float
) -> tuple[float, float]:
    """Twice the fall of the likelihood at a value of a quantity, and its side: -1 or 1."""
    hill, level = _hill_of(test, fit), np.array([quantity.level])
    there = np.array([hill.coordinate_of(quantity.kind, value)])
    side = np.sign(there - hill.coordinate(quantity.kind, level))
    return max(float(hill.fall(quantity.kind, level, there)[0][0]), 0.0), float(side[0])


def _by_kind(
    test: LifeTest, fit: WeibullFit, quantities: list[Estimand], count: int, limits: Limits
) -> FloatArray:
    """Find the limits of all quantities of one kind at once."""
    found = np.empty((len(quantities), count))
    for kind in {quantity.kind for quantity in quantities}:
        places = [i for i, quantity in enumerate(quantities) if quantity.kind == kind]
        level = np.array([quantities[i].level for i in places])
        found[places] = limits(_hill_of(test, fit), kind, level, places)
    return found


def _limits_of_kind(hill: Hill, kind: Kind, level: FloatArray, roots: FloatArray) -> FloatArray:
    """Limits of quantities of one kind, one a lane."""
    side, farthest = np.sign(roots), np.full(len(roots), _FARTHEST[kind])
    top = hill.coordinate(kind, level)

    def excess(distance: FloatArray) -> tuple[FloatArray, FloatArray]:
        fall, slope = hill.fall(kind, level, top + side * distance)
        return fall - roots**2, side * slope

    start = np.minimum(np.abs(roots) * hill.spread(kind, level), 0.5 * farthest)
    moved, found = increasing_root(excess, start, np.zeros_like(start), farthest, tolerance=1e-10)
    # where the likelihood hardly falls however far one goes, that side is open
    if not np.all(found):
        moved = np.where(~found & (excess(farthest)[0] < 0.0), np.inf, moved)
    moved = np.where(roots == 0.0, 0.0, moved)
    with np.errstate(invalid="ignore"):
        return hill.value_of(kind, top + side * moved)


def _hill_of(test: LifeTest, fit: WeibullFit) -> Hill:
    return Hill(Likelihood.of(test), np.array([fit.shape]), np.log([fit.scale]))


class Hill:
    """The maximum of a likelihood, and how it falls around it; one, or one a lane.

    A quantity is measured where it is nearly normal: ln β, ln t_R from the likelihood's origin,
    -ln(-ln R). What it is for, its level, is that of `Estimand`; arrays (lanes,).

    Parameters
    ----------
    likelihood : of one test, or of many with the same times.
    shape, log_scale : (1,) or (lanes,), of its maximum.
    """

    def __init__(self, likelihood: Likelihood, shape: FloatArray, log_scale: FloatArray) -> None:
        self._likelihood = likelihood
        self._origin = likelihood.origin
        self._failures = np.atleast_1d(likelihood.failures)
        self._a, self._b = shape, shape * (self._origin - log_scale)
        self._top = likelihood.at(self._a, self._b)
        self._near = self._a

    def coordinate(self, kind: Kind, level: FloatArray) -> FloatArray:
        """Coordinates of quantities at the maximum."""
        if kind == "shape":
            return np.asarray(np.log(self._a) + 0.0 * level)
        if kind == "life":
            return np.asarray((level - self._b) / self._a)
        return np.asarray(-self._a * (level - self._origin) - self._b)

    def coordinate_of(self, kind: Kind, value: float) -> float:
        """Coordinate of another value."""
        if kind == "reliability":
            return -float(np.log(-np.log(value)))
        return float(np.log(value)) - (self._origin if kind == "life" else 0.0)

    def value_of(self, kind: Kind, coordinate: FloatArray) -> FloatArray:
        """Turn coordinates back."""
        with np.errstate(over="ignore"):
            if kind == "reliability":
                return np.asarray(np.exp(-np.exp(-coordinate)))
            shift = self._origin if kind == "life" else 0.0
            return np.asarray(np.exp(coordinate + shift))

    def spread(self, kind: Kind, level: FloatArray) -> FloatArray:
        """Standard deviation of the coordinates, by the observed information."""
        slope_a, slope_b = level - self._origin, np.ones_like(self._a)
        if kind == "shape":
            slope_a, slope_b = 1.0 / self._a + 0.0 * level, 0.0 * self._a
        elif kind == "life":
            slope_a, slope_b = self.coordinate(kind, level) / self._a, 1.0 / self._a
        aa, ab, bb = self._top.aa, self._top.ab, self._top.bb
        form = -bb * slope_a**2 + 2.0 * ab * slope_a * slope_b - aa * slope_b**2
        return np.asarray(np.sqrt(np.maximum(form / (aa * bb - ab * ab), 0.0)))

    def fall(
        self, kind: Kind, level: FloatArray, there: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Twice the fall of the likelihood at coordinates, and its slope; arrays (lanes,)."""
        if kind == "shape":
            a = np.exp(there)
            here = self._likelihood.at(a, self._best_b(a))
            slope = -a * here.a
        elif kind == "life":
            a = self._best_a(level, there)
            here = self._likelihood.at(a, level - a * there)
            slope = a * here.b
        else:
            c = level - self._origin
            a = self._best_a(-there, c)
            here = self._likelihood.at(a, -there - a * c)
            slope = here.b
        with np.errstate(over="ignore"):
            return np.minimum(2.0 * (self._top.value - here.value), _MUCH), _bounded(2.0 * slope)

    def _best_a(self, w: FloatArray, c: FloatArray) -> FloatArray:
        """Best a on the line b = w - a c."""

        def falling(a: FloatArray) -> tuple[FloatArray, FloatArray]:
            here = self._likelihood.at(a, w - a * c)
            with np.errstate(invalid="ignore", over="ignore"):
                value = -(here.a - c * here.b)
                slope = -(here.aa - 2.0 * c * here.ab + c * c * here.bb)
                return _compressed(a * value, value + a * slope, self._failures)

        # the last line was near this one
        start = self._near if self._near.shape == w.shape else self._a
        best = self._root(falling, start, w)
        self._near = np.where(np.isfinite(best) & (best > 0.0), best, self._a)
        return best

    def _best_b(self, a: FloatArray) -> FloatArray:
        """Best b at given a."""

        def falling(level: FloatArray) -> tuple[FloatArray, FloatArray]:
            with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
                here = self._likelihood.at(a, np.log(level))
                return _compressed(-here.b, -here.bb / level, self._failures)

        return np.asarray(np.log(self._root(falling, np.exp(self._b), a)))

    @staticmethod
    def _root(function: ValueAndSlope, start: FloatArray, like: FloatArray) -> FloatArray:
        zeros = np.zeros_like(like)
        root, _ = increasing_root(function, zeros + start, zeros, zeros + np.inf, tolerance=1e-10)
        return root


def _bounded(values: FloatArray) -> FloatArray:
    """Keep what overflowed a number, so that a search can come back from it."""
    return np.nan_to_num(values, nan=_MUCH, posinf=_MUCH, neginf=-_MUCH)


def _compressed(
    value: FloatArray, slope: FloatArray, failures: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return what has the same root but does not grow like an exponential."""
    value, slope = _bounded(value), _bounded(slope)
    size = np.abs(value) + failures
    return np.sign(value) * np.log(size / failures), slope / size


# --- calibrated for few failures ------------------------------------------------------------------


def calibrated_limits(
    test: LifeTest,
    fit: WeibullFit,
    quantities: list[Estimand],
    tails: FloatArray,
    samples: int,
    random: np.random.Generator,
) -> tuple[FloatArray, Drawing]:
    """Limits by the calibrated likelihood ratio: (quantities, tails), and how they were drawn.

    tails: probability of lying below the limit.
    """
    roots, drawing = signed_roots(test, fit, quantities, samples, random)
    if drawing.code != "converged":
        return np.full((len(quantities), len(tails)), np.nan), drawing
    points = -np.quantile(roots, 1.0 - tails, axis=1).T
    return likelihood_ratio_limits(test, fit, quantities, points), drawing


def calibrated_p_value(
    test: LifeTest,
    fit: WeibullFit,
    quantity: Estimand,
    value: float,
    samples: int,
    random: np.random.Generator,
) -> float:
    """How often, of two sides, R would be as far out as at a value of a quantity."""
    roots, drawing = signed_roots(test, fit, [quantity], samples, random)
    if drawing.code != "converged":
        return float("nan")
    fall, side = profile_fall(test, fit, quantity, value)
    here = -side * fall**0.5
    beyond = min(int(np.sum(roots[0] >= here)), int(np.sum(roots[0] <= here)))
    return float(min(2.0 * (1 + beyond) / (1 + roots.shape[1]), 1.0))


def signed_roots(
    test: LifeTest,
    fit: WeibullFit,
    quantities: list[Estimand],
    samples: int,
    random: np.random.Generator,
) -> tuple[FloatArray, Drawing]:
    """R of tests drawn at a fit, at its own values: (quantities, samples that have a fit)."""
    model = model_of(test)
    if isinstance(model, str):
        return np.empty((len(quantities), 0)), Drawing(model)
    shape, log_scale = fit.shape, float(np.log(fit.scale))
    counts = portions(model.width, samples)
    parts = []
    for count in counts:
        if isinstance(model, Inspected):
            likelihood = model.likelihood(shape, log_scale, count, random)
            parts.append(_roots_of_inspected(likelihood, shape, log_scale, quantities))
        else:
            rows = model.rows(shape, log_scale, count, random)
            parts.append(_roots_of_right_censored(rows, shape, log_scale, quantities))
    roots = np.concatenate(parts, axis=1)
    return roots, Drawing.of(model, sum(counts), sum(counts) - roots.shape[1])


def _roots_of_right_censored(
    rows: Rows, shape: float, log_scale: float, quantities: list[Estimand]
) -> FloatArray:
    failures = np.broadcast_to(rows.failures, rows.log_time.shape).sum(axis=1)
    fit = fit_rows(rows)
    good = fit.code == CONVERGED
    lanes = _DrawnTests(rows.part(good), failures[good], fit.shape[good], fit.log_scale[0, good])
    return np.array([lanes.root(q, shape, log_scale) for q in quantities])


def _roots_of_inspected(
    likelihood: Likelihood, shape: float, log_scale: float, quantities: list[Estimand]
) -> FloatArray:
    fit = fits_of(likelihood)
    good = fit.code == CONVERGED
    hill = Hill(likelihood.lanes(good), fit.shape[good], fit.log_scale[0, good])
    roots = []
    for quantity in quantities:
        true = float(quantity.at(np.array([shape]), np.array([log_scale]))[0])
        there = np.full(np.count_nonzero(good), hill.coordinate_of(quantity.kind, true))
        level = np.full_like(there, quantity.level)
        side = np.sign(hill.coordinate(quantity.kind, level) - there)
        fall = hill.fall(quantity.kind, level, there)[0]
        roots.append(side * np.sqrt(np.maximum(fall, 0.0)))
    return np.array(roots)


class _DrawnTests:
    """Drawn tests with their fits."""

    def __init__(
        self, rows: Rows, failures: FloatArray, shape: FloatArray, log_scale: FloatArray
    ) -> None:
        self.y, self.units = rows.log_time, rows.units
        self.r = failures
        self.failed = np.einsum("ij,ij->i", np.broadcast_to(rows.failures, self.y.shape), self.y)
        self.shape, self.log_scale = shape, log_scale
        self.top = self._value(self.shape, self.r, -self.shape * self.log_scale)

    def root(self, quantity: Estimand, shape: float, log_scale: float) -> FloatArray:
        """Signed root at the value of a quantity that a distribution has."""
        true = float(quantity.at(np.array([shape]), np.array([log_scale]))[0])
        above = np.sign(quantity.at(self.shape, self.log_scale) - true)
        if quantity.kind == "shape":
            value = self._at_shape(true)
        else:
            # a life, and the reliability at a time, are points on the Weibull plot
            life = quantity.kind == "life"
            c = np.log(true) if life else np.log(quantity.value)
            w = quantity.log_risk if life else np.log(-np.log(true))
            value = self._through(float(c), float(w))
        return np.asarray(above * np.sqrt(np.maximum(2.0 * (self.top - value), 0.0)))

    def _value(self, a: FloatArray | float, risk: FloatArray, b: FloatArray) -> FloatArray:
        """Logarithm of the likelihood, but for Σ ln t of the failures."""
        return np.asarray(self.r * np.log(a) + a * self.failed + self.r * b - risk)

    def _at_shape(self, a: float) -> FloatArray:
        """Maximum at a shape."""
        longest = self.y.max(axis=1)
        weight = np.exp(a * (self.y - longest[:, np.newaxis])) * self.units
        b = np.log(self.r) - a * longest - np.log(weight.sum(axis=1))
        return self._value(a, self.r, b)

    def _through(self, c: float, w: float) -> FloatArray:
        """Maximum over the lines through the point (c, w) of the Weibull plot."""
        x, level = self.y - c, np.exp(w)
        sum_failed = self.failed - self.r * c

        def falling(a: FloatArray) -> tuple[FloatArray, FloatArray]:
            with np.errstate(over="ignore", invalid="ignore"):
                each = np.exp(a[:, np.newaxis] * x)
                each *= self.units
                each *= x
                first = level * each.sum(axis=1)
                second = level * np.einsum("ij,ij->i", each, x)
                value = a * (first - sum_failed) - self.r
                slope = first - sum_failed + a * second
            return _compressed(value, slope, self.r)

        zeros = np.zeros_like(self.shape)
        a, _ = increasing_root(falling, self.shape, zeros, zeros + np.inf, tolerance=1e-10)
        risk = np.sum(np.exp(a[:, np.newaxis] * x) * self.units, axis=1) * level
        return self._value(a, risk, w - a * c)


# --- regions --------------------------------------------------------------------------------------


@frozen(eq=False)
class LikelihoodRegion:
    """How far the likelihood falls over shape and life; without numbers where there is no fit.

    Attributes
    ----------
    code
        "converged", or why there is none, a code that `advice` explains
    fit
        where the likelihood is greatest
    quantity
        that stands beside the shape: the scale, or a life
    shape, life
        (shapes,), (lives,) over which the fall is given; life in the unit of the test
    fall
        (lives, shapes) twice the fall of the logarithm of the likelihood
    probabilities, levels
        falls within which the true pair lies with these probabilities
    drawn
        whether the levels are drawn; from chi-square otherwise, which holds for many failures
    """

    code: str
    fit: WeibullFit
    quantity: Estimand
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
    test: LifeTest | ArrayLike,
    quantity: str | Estimand = "scale",
    probabilities: ArrayLike = PROBABILITIES,
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
    test, life = LifeTest.of(test), Estimand.of(quantity)
    if life.kind != "life":
        raise InputError(
            said("must be scale or a life"), field="quantity", value=life.name, example="L10"
        )
    wanted = tuple(float(p) for p in np.atleast_1d(shares(probabilities, "probabilities")))
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
    shapes, lives = _grids_around(test, fit, life, float(np.max(levels)))
    return LikelihoodRegion(
        "converged", fit, life, shapes, lives, _falls_over(test, fit, life, shapes, lives), wanted,
        tuple(float(level) for level in levels), falls is not None,
    )  # fmt: skip


def _grids_around(
    test: LifeTest, fit: WeibullFit, life: Estimand, level: float
) -> tuple[FloatArray, FloatArray]:
    """Shapes and lives that hold the largest region, evenly spread in their logarithms."""
    # the limits of each by itself, at the same fall of the likelihood
    ends_of_fall = np.broadcast_to([-(level**0.5), level**0.5], (2, 2))
    limits = likelihood_ratio_limits(test, fit, [Estimand.of("shape"), life], ends_of_fall)
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
    test: LifeTest, fit: WeibullFit, life: Estimand, shapes: FloatArray, lives: FloatArray
) -> FloatArray:
    likelihood = Likelihood.of(test)
    shape, log_life = (grid.ravel() for grid in np.meshgrid(shapes, np.log(lives)))
    shift = shape * (likelihood.origin - log_life) + life.log_risk
    step = max(_REGION_AT_ONCE // len(test), 1)
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
    samples = min(samples, max(_MAXIMUM_DRAWN // model.width, 100))
    step = max(_REGION_AT_ONCE // model.width, 1)
    log_scale = float(np.log(fit.scale))
    parts = [
        _falls_of(model.rows(fit.shape, log_scale, min(step, samples - first), random), fit)
        for first in range(0, samples, step)
    ]
    falls = np.concatenate(parts)
    return falls if len(falls) >= MINIMUM_FITS else None


def _falls_of(rows: Rows, fit: WeibullFit) -> FloatArray:
    """Falls at a fit, of tests that were drawn at it; those that have a fit of their own."""
    shape, log_scale = fit.shape, float(np.log(fit.scale))
    found = fit_rows(rows)
    failures = np.broadcast_to(rows.failures, rows.log_time.shape)
    r = failures.sum(axis=1)
    failed = np.sum(failures * rows.log_time, axis=1)
    risk = np.sum(rows.units * np.exp(shape * (rows.log_time - log_scale)), axis=1)
    at_true = r * np.log(shape) + shape * (failed - r * log_scale) - risk
    with np.errstate(invalid="ignore"):
        at_best = r * np.log(found.shape) + found.shape * (failed - r * found.log_scale[0]) - r
        fall = 2.0 * (at_best - at_true)
    good = (found.code == CONVERGED) & (r >= 2.0) & np.isfinite(fall)
    return np.asarray(np.maximum(fall[good], 0.0))
