"""Shape and scale from a test and from what was known of the shape before.

The prior on the shape is the user's, that on the scale is uninformative (1/η). Of a right-censored
test the scale can be integrated away: given β, η^(-β) has a gamma distribution with r and Σ v t^β,
and the shape has the density

    p(β) ∝ prior(β) β^(r-1) Π t_failed^β / (Σ v t^β)^r,

which is summed over a grid of ln β. Of an inspected test the likelihood itself is summed, over a
grid of ln η as well. One failure is enough; none is not, for then nothing bounds the life from
above.

Source: Hamada, Wilson, Reese and Martz (2008), chapter 4.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal, Self

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.validate import one_of, share
from rolamento.weibull.fit import Estimand, advice_on
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import Likelihood
from rolamento.weibull.limits import shape_of
from rolamento.words import Note, said

_REACH: Final = 60.0
_FARTHEST: Final = 300.0
_MAXIMUM_INSPECTED_ROWS: Final = 1000
_NODES: Final = 401
_SUM_NODES: Final = 101
_AT_ONCE: Final = 1_000_000
_NEXT_TO_NOTHING: Final = 40.0


@frozen
class ShapePrior:
    """What was known of the shape before the test.

    Attributes
    ----------
    low, high
        β lies between them with the probability
    probability
        of that, for "lognormal"; it is 1 for "uniform"
    kind
        "lognormal", or "uniform": anything between them alike, nothing outside
    """

    low: float
    high: float
    probability: float = 0.9
    kind: Literal["lognormal", "uniform"] = "lognormal"

    def __post_init__(self) -> None:
        """Refuse what is no prior."""
        one_of(self.kind, "kind", ("lognormal", "uniform"))
        low, high = shape_of(self.low, "low"), shape_of(self.high, "high")
        share(self.probability, "probability")
        if low >= high:
            raise InputError(
                said("must be greater than low"), field="high", value=high, example="2.0"
            )

    def log_density(self, log_shape: FloatArray) -> FloatArray:
        """Logarithm of the density of ln β, but for a constant."""
        if self.kind == "uniform":
            inside = (log_shape >= np.log(self.low)) & (log_shape <= np.log(self.high))
            return np.where(inside, log_shape, -np.inf)
        middle, spread = self._normal()
        return np.asarray(-0.5 * ((log_shape - middle) / spread) ** 2)

    def range(self) -> tuple[float, float]:
        """Return the range of ln β outside of which there is next to nothing."""
        if self.kind == "uniform":
            return float(np.log(self.low)), float(np.log(self.high))
        middle, spread = self._normal()
        return middle - 8.0 * spread, middle + 8.0 * spread

    def _normal(self) -> tuple[float, float]:
        from scipy.special import ndtri

        width = float(np.log(self.high / self.low))
        middle = 0.5 * float(np.log(self.high * self.low))
        return middle, 0.5 * width / float(ndtri(0.5 + 0.5 * self.probability))


@frozen(eq=False)
class Posterior:
    """What test and prior together say; quantiles NaN where there is no result.

    Attributes
    ----------
    code
        "converged", "no_failures", "no_maximum" or "too_large"
    prior
        of the shape
    unit
        label of times
    shapes, weights
        (nodes,) β and the probability of each, which sum to 1
    """

    code: str
    prior: ShapePrior
    unit: str
    shapes: FloatArray
    weights: FloatArray
    _given: GivenByGamma | GivenByGrid | None

    @property
    def advice(self) -> Note | None:
        """What a person can do, where there is no result."""
        return advice_on(self.code)

    def quantile(self, quantity: str | Estimand, probability: float) -> float:
        """Value below which a quantity lies with a probability.

        Parameters
        ----------
        quantity
            "shape", "scale", "L10", "R100" and so on.
        probability
            0.5 for the median.
        """
        wanted, p = Estimand.of(quantity), share(probability, "probability", "0.5")
        if self._given is None:
            return float("nan")
        if wanted.kind == "shape":
            return float(np.exp(self._shape_quantile(p)))
        from scipy.optimize import brentq

        if wanted.kind == "reliability":
            low, high = 1e-12, 1.0 - 1e-12
            ends = [self.probability_below(wanted, x) - p for x in (low, high)]
            if ends[0] >= 0.0 or ends[1] <= 0.0:
                return 0.0 if ends[0] >= 0.0 else 1.0
            return float(brentq(lambda x: self.probability_below(wanted, x) - p, low, high))

        def excess(u: float) -> float:
            return self.probability_below(wanted, np.exp(u)) - p

        low = high = float(self._given.middle)
        while excess(low) > 0.0 and low > -_FARTHEST:
            low = 2.0 * low - high - 1.0
        while excess(high) < 0.0 and high < _FARTHEST:
            high = 2.0 * high - low + 1.0
        if excess(low) > 0.0 or excess(high) < 0.0:
            return float("nan")
        return float(np.exp(brentq(excess, low, high, xtol=1e-12)))

    def interval(self, quantity: str | Estimand, probability: float = 0.9) -> tuple[float, float]:
        """Limits that a quantity lies between with a probability, as much left out on each side."""
        tail = 0.5 * (1.0 - share(probability, "probability"))
        return self.quantile(quantity, tail), self.quantile(quantity, 1.0 - tail)

    def probability_below(self, quantity: str | Estimand, value: float) -> float:
        """Probability that a quantity is less than a value."""
        wanted = Estimand.of(quantity)
        if self._given is None:
            return float("nan")
        if wanted.kind == "shape":
            grid = np.log(self.shapes)
            return float(np.interp(np.log(value), grid, self._cumulated(), left=0.0, right=1.0))
        if wanted.kind == "life":
            # t_R < x where the scale is less than x/(-ln R)^(1/β)
            log_scale = np.log(value) - wanted.log_risk / self.shapes
        else:
            log_scale = np.log(wanted.value) - np.log(-np.log(value)) / self.shapes
        return float(np.sum(self.weights * self._given.below(self.shapes, log_scale)))

    def _cumulated(self) -> FloatArray:
        sums = np.cumsum(self.weights)
        return np.asarray(sums - 0.5 * self.weights)

    def _shape_quantile(self, p: float) -> float:
        return float(np.interp(p, self._cumulated(), np.log(self.shapes)))


def posterior(test: LifeTest | ArrayLike, prior: ShapePrior) -> Posterior:
    """Combine a test with a prior on the shape.

    Parameters
    ----------
    test
        With any kind of censoring, and one failure at least.
    prior
        On the shape; for bearings, say, ``ShapePrior(1.0, 2.5)``.

    Raises
    ------
    InputError
        If `prior` is no `ShapePrior`.
    """
    test = LifeTest.of(test)
    if not isinstance(prior, ShapePrior):
        raise InputError(said("must be a prior"), field="prior", example="ShapePrior(1.0, 2.5)")
    code = "" if test.failures else "no_failures"
    if test.inspected and not code and not np.any((test.lower > 0.0) | np.isnan(test.lower)):
        code = "no_maximum"  # all failed before the first inspection: nothing bounds from below
    if test.inspected and not code and len(test) > _MAXIMUM_INSPECTED_ROWS:
        code = "too_large"
    if code:
        nothing = np.array([])
        return Posterior(code, prior, test.unit, nothing, nothing, None)
    given: GivenByGamma | GivenByGrid = (
        GivenByGrid.of(test) if test.inspected else GivenByGamma.of(test)
    )
    low, high = prior.range()
    for points in (given.search, given.search, _NODES):
        u = np.linspace(low, high, points)
        log_density = prior.log_density(u) + given.log_marginal(np.exp(u))
        density = np.exp(log_density - log_density.max())
        inside = np.flatnonzero(density > np.exp(-_REACH))
        low = u[max(inside[0] - 1, 0)]
        high = u[min(inside[-1] + 1, points - 1)]
    density[[0, -1]] *= 0.5
    return Posterior(
        "converged", prior, test.unit, np.exp(u), density / density.sum(), given.settled(np.exp(u))
    )


# --- how probable a scale is, given the shape and a test; prior 1/η -------------------------------


@frozen(eq=False)
class GivenByGamma:
    """Posterior of a right-censored test: given β, η^(-β) has a gamma distribution.

    z: logarithms of the times, from the longest, which is at `middle`. log_total: ln Σ v t^β of the
    shapes that count. search: points of ln β that are looked at to find where the density lies.
    """

    z: FloatArray
    units: FloatArray
    sum_failed: float
    failures: float
    middle: float
    log_total: FloatArray
    search: int = 201

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Prepare a test."""
        y = np.log(test.times)
        longest = float(y.max())
        z = y - longest
        units = test.counts.astype(np.float64)
        sum_failed = float(units @ (z * test.failed))
        return cls(z, units, sum_failed, float(test.failures), longest, np.empty(0))

    def log_marginal(self, shape: FloatArray) -> FloatArray:
        """Logarithm of the likelihood of each shape, with the scale integrated away."""
        r = self.failures
        return np.asarray(
            (r - 1.0) * np.log(shape) + shape * self.sum_failed - r * self._log_total(shape)
        )

    def settled(self, shape: FloatArray) -> Self:
        """Prepare for the shapes that count."""
        return replace(self, log_total=self._log_total(shape))

    def below(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Probability, for each shape, that the logarithm of the scale is less."""
        from scipy.special import gammaincc

        with np.errstate(over="ignore"):
            x = np.exp(self.log_total - shape * (log_scale - self.middle))
        return np.asarray(gammaincc(self.failures, x))

    def _log_total(self, shape: FloatArray) -> FloatArray:
        step = max(_AT_ONCE // len(self.z), 1)
        parts = [shape[i : i + step, np.newaxis] for i in range(0, len(shape), step)]
        return np.concatenate([np.log(np.exp(part * self.z) @ self.units) for part in parts])


@frozen(eq=False)
class GivenByGrid:
    """Posterior of an inspected test: given β, the likelihood over a grid of b = -β ln η.

    grid, cumulated: (shapes, nodes), b from `middle`, and the probability that b is greater.
    """

    likelihood: Likelihood
    middle: float
    grid: FloatArray
    cumulated: FloatArray
    search: int = 61

    @classmethod
    def of(cls, test: LifeTest) -> Self:
        """Prepare a test."""
        likelihood = Likelihood.of(test)
        nothing = np.empty((0, 0))
        return cls(likelihood, likelihood.origin, nothing, nothing)

    def log_marginal(self, shape: FloatArray) -> FloatArray:
        """Logarithm of the likelihood of each shape, with the scale integrated away."""
        value, step = self._over_scale(shape, _SUM_NODES)[1:]
        top = value.max(axis=1)
        total = np.sum(np.exp(value - top[:, np.newaxis]), axis=1) * step
        return np.asarray(top + np.log(total) - np.log(shape))  # dη/η = db/β

    def settled(self, shape: FloatArray) -> GivenByGrid:
        """Prepare for the shapes that count."""
        b, value, _ = self._over_scale(shape, _NODES)
        density = np.exp(value - value.max(axis=1, keepdims=True))
        # the scale falls as b rises
        tail = np.cumsum(density[:, ::-1], axis=1)[:, ::-1] - 0.5 * density
        return GivenByGrid(
            self.likelihood, self.middle, b, tail / density.sum(axis=1, keepdims=True)
        )

    def below(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Probability, for each shape, that the logarithm of the scale is less."""
        b = -shape * (log_scale - self.middle)
        return np.array(
            [
                np.interp(x, grid, tail, left=1.0, right=0.0)
                for x, grid, tail in zip(b, self.grid, self.cumulated, strict=True)
            ]
        )

    def _over_scale(
        self, shape: FloatArray, nodes: int
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Grid of b around the best, of each shape; logarithm of the likelihood there; its step."""
        low, high = self._ends(shape)
        b = np.linspace(low, high, nodes, axis=1)
        value = np.stack([self.likelihood.value(shape, column) for column in b.T], axis=1)
        return b, np.where(np.isnan(value), -np.inf, value), (high - low) / (nodes - 1)

    def _ends(self, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Where the likelihood of each shape has fallen to next to nothing."""
        best = self._best(shape)
        top = self.likelihood.value(shape, best)
        ends = []
        for sign in (-1.0, 1.0):
            near, far = np.zeros_like(shape), np.ones_like(shape)
            for _ in range(12):
                value = self.likelihood.value(shape, best + sign * far)
                far = np.where(value > top - _NEXT_TO_NOTHING, 2.0 * far, far)
            for _ in range(20):
                middle = 0.5 * (near + far)
                value = self.likelihood.value(shape, best + sign * middle)
                high = value > top - _NEXT_TO_NOTHING
                near, far = np.where(high, middle, near), np.where(high, far, middle)
            ends.append(best + sign * far)
        return ends[0], ends[1]

    def _best(self, shape: FloatArray) -> FloatArray:
        """Best b of each shape."""

        def falling(b: FloatArray) -> tuple[FloatArray, FloatArray]:
            here = self.likelihood.at(shape, b)
            return -here.b, -here.bb

        far = np.full_like(shape, 800.0)
        return increasing_root(falling, np.zeros_like(shape), -far, far)[0]
