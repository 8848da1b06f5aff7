"""Failures expected in a fleet, with prediction bounds.

Bearing i has run t_i and will run x_i more. Left where it fails, it fails once at most, with the
probability p_i = 1 - R(x_i | t_i), and the number of failures has the Poisson-binomial distribution
of mean Σ p_i. Replaced by a new one where it fails, the bearings that follow count too: with the
renewal function M of new bearings,

    M(x) = F(x) + ∫_0^x M(x - u) dF(u),      M(x | t) = F(x | t) + ∫_0^x M(x - u) dF(u | t),

the expected number is Σ M(x_i | t_i). Both integrals are summed as Riemann-Stieltjes sums with the
distribution at the middle of each step (Xie). What is uncertain of the distribution is in the
prediction: failures are counted in draws of the distributions that could have given the data. The
exact Poisson-binomial probabilities are the discrete Fourier transform of their characteristic
function (Hong).

Abernethy's present risk, Σ F(t_i) over the bearings in service, is what should have failed among so
many bearings of these ages by now: far from what has failed, the distribution, or the table, does
not describe the fleet.

Sources: Meeker and Escobar, Statistical Methods for Reliability Data (1998), section 12.7; Escobar
and Meeker, Technometrics 41 (1999); Abernethy, The New Weibull Handbook (2006), chapter 4; Xie,
Communications in Statistics - Simulation 18 (1989); Hong, Computational Statistics & Data Analysis
59 (2013).
"""

from __future__ import annotations

from math import sqrt
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray, IntArray
from rolamento.records import frozen
from rolamento.validate import finite, generator, numbers, share, whole_number
from rolamento.weibull.distribution import LifeDistribution
from rolamento.weibull.limits import LONGEST_TIME
from rolamento.weibull.residual import conditional_reliability
from rolamento.words import Note, said

__all__ = [
    "Fleet",
    "FleetForecast",
    "FleetStep",
    "fleet_forecast",
    "poisson_binomial",
    "renewals",
]

MAXIMUM_UNITS: Final = 1_000_000
_MAXIMUM_ROWS: Final = 10_000
_NODES, _MOST_NODES = 400, 8000
"""Steps of the renewal integral: in a life η, and at most."""
_WHOLE: Final = 1.0 - 1e-9
_RENEWED_DRAWS: Final = 2000
_MOST_LIVES: Final = 10_000
"""One after the other at one place, in a draw."""
_RISKIEST: Final = 5
_MOST_DRAWN: Final = 20_000_000
"""Lives, or counts of rows, that are drawn at most."""
_FEWEST_DRAWS: Final = 200
_MOST_RENEWALS: Final = 200.0
"""Number of renewals of one bearing on the mean; beyond it a simulation is not worth its time."""
_SPREAD: Final = 12.0
_STEPS: Final = 12


@frozen(eq=False)
class Fleet:
    """Bearings in service.

    Attributes
    ----------
    ages
        (rows,) run since new; unit of the distribution
    ahead
        (rows,) that each will run until the date
    counts
        (rows,) bearings alike
    """

    ages: FloatArray
    ahead: FloatArray
    counts: IntArray

    @classmethod
    def of(cls, ages: ArrayLike, ahead: ArrayLike, counts: ArrayLike | None = None) -> Fleet:
        """Put a fleet together.

        Parameters
        ----------
        ages
            (rows,) 0 for a new bearing.
        ahead
            (rows,), or one for all.
        counts
            (rows,) whole numbers; 1 by default.

        Raises
        ------
        InputError
            If one is no time, or there are too many.
        """
        old = np.atleast_1d(numbers(ages, "ages", "[8000.0, 12000.0]")).astype(float)
        more = np.broadcast_to(numbers(ahead, "ahead", "2000.0").astype(float), old.shape).copy()
        many = np.ones(len(old)) if counts is None else np.atleast_1d(
            numbers(counts, "counts", "[1, 4]")
        )  # fmt: skip
        if old.ndim != 1 or not 1 <= len(old) <= _MAXIMUM_ROWS or many.shape != old.shape:
            rule = said(
                "all columns must have the same length, 1 to {most} rows", most=_MAXIMUM_ROWS
            )
            raise InputError(rule, field="ages", value=len(old))
        for field, values, example in (("ages", old, "8000.0"), ("ahead", more, "2000.0")):
            bad = ~((values >= 0.0) & (values <= LONGEST_TIME))
            if np.any(bad):
                rule = said("must be from {least:.6g} to {most:.6g}", least=0.0, most=LONGEST_TIME)
                raise InputError(rule, field=field, value=float(values[bad][0]), example=example)
        if np.any((many < 1) | (many != np.floor(many))) or float(many.sum()) > MAXIMUM_UNITS:
            rule = said("must be integers from 1, at most {most} in all", most=MAXIMUM_UNITS)
            raise InputError(rule, field="counts", example="[1, 4]")
        return cls(old, more, many.astype(np.int64))

    @property
    def size(self) -> int:
        """Number of bearings."""
        return int(self.counts.sum())

    def part(self, share_: float) -> Fleet:
        """Return the same fleet over a part of the way ahead."""
        return Fleet(self.ages, share_ * self.ahead, self.counts)


@frozen
class FleetStep:
    """Failures until a part of the way ahead.

    Attributes
    ----------
    part
        of the way: 1 at its end
    expected
        number of failures, at the estimate
    lower, upper
        between which the number lies with the confidence: whole numbers; NaN without a prediction
    """

    part: float
    expected: float
    lower: float
    upper: float


@frozen(eq=False)
class FleetForecast:
    """Forecast the failures in a fleet.

    Attributes
    ----------
    distribution
        of the lives
    fleet
        the bearings
    renewed
        whether those that fail are replaced by new ones, which may fail too
    confidence
        of the prediction
    steps
        cumulated failures over equal parts of the way ahead
    exact
        limits of the number were the estimate the truth (Poisson-binomial); NaN for renewals
    none
        probability of no failure at all, with the uncertainty of the distribution
    now
        Σ F(t_i): what should have failed by now among bearings of these ages
    riskiest
        rows by falling probability of failure, the first few: place, and the probability
    draws
        of the prediction
    notes
        what limits it
    """

    distribution: LifeDistribution
    fleet: Fleet
    renewed: bool
    confidence: float
    steps: tuple[FleetStep, ...]
    exact: tuple[float, float]
    none: float
    now: float
    riskiest: tuple[tuple[int, float], ...]
    draws: int
    notes: tuple[Note, ...] = ()

    @property
    def end(self) -> FleetStep:
        """At the end of the way ahead."""
        return self.steps[-1]

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the unit of the distribution."""
        return {
            "distribution": self.distribution.to_mapping(),
            "bearings": self.fleet.size,
            "renewed": self.renewed,
            "confidence": self.confidence,
            "expected": finite(self.end.expected),
            "prediction": [finite(self.end.lower), finite(self.end.upper)],
            "prediction_at_estimate": [finite(limit) for limit in self.exact],
            "probability_of_none": finite(self.none),
            "expected_by_now": finite(self.now),
            "draws": self.draws,
            "steps": [
                {
                    "part": step.part,
                    "expected": finite(step.expected),
                    "lower": finite(step.lower),
                    "upper": finite(step.upper),
                }
                for step in self.steps
            ],
            "rows": [
                {"age": float(age), "ahead": float(ahead), "count": int(count)}
                for age, ahead, count in zip(
                    self.fleet.ages, self.fleet.ahead, self.fleet.counts, strict=True
                )
            ],
            "notes": [note.to_mapping() for note in self.notes],
        }


def poisson_binomial(probabilities: FloatArray, counts: IntArray) -> FloatArray:
    """Probabilities of 0, 1, 2 … successes, each with a probability of its own.

    Parameters
    ----------
    probabilities, counts
        (rows,), and how many there are of each.

    Returns
    -------
    (numbers,) up to twelve standard deviations above the mean, or to all.
    """
    mean = float(counts @ probabilities)
    spread = sqrt(float(counts @ (probabilities * (1.0 - probabilities))))
    most = int(min(counts.sum(), np.ceil(mean + _SPREAD * spread + 2.0 * _SPREAD)))
    size = most + 1
    half = size // 2 + 1
    log_cf = np.zeros(half, dtype=np.complex128)
    turn = np.exp(2j * np.pi * np.arange(half) / size)
    with np.errstate(divide="ignore"):
        for p, count in zip(probabilities, counts, strict=True):
            log_cf += count * np.log(1.0 - p + p * turn)
    found = np.fft.irfft(np.conj(np.exp(log_cf)), n=size)
    return np.asarray(np.clip(found, 0.0, 1.0))


def renewals(shape: float, scale: float, ages: FloatArray, ahead: FloatArray) -> FloatArray:
    """Expected failures at each place where bearings are replaced as they fail; (rows,).

    Parameters
    ----------
    shape, scale
        β, η.
    ages, ahead
        (rows,) of the bearing there now, and the time to come.
    """
    longest = float(ahead.max(initial=0.0))
    if longest == 0.0:
        return np.zeros(len(ages))
    # steps fine enough for the lives, all rows on one grid
    steps = int(min(_NODES * max(1.0, longest / scale), _MOST_NODES))
    grid = np.linspace(0.0, longest, steps + 1)
    with np.errstate(over="ignore"):
        at_ends = -np.expm1(-((grid / scale) ** shape))
        at_middles = -np.expm1(-(((grid[1:] - 0.5 * grid[1]) / scale) ** shape))
    m, rises = np.zeros(steps + 1), np.zeros(steps + 1)
    first = float(at_middles[0])
    if first > _WHOLE:  # a life is shorter than a step
        return np.full(len(ages), np.inf)
    for i in range(1, steps + 1):
        before = float(rises[1:i] @ at_middles[i - 1 : 0 : -1])
        m[i] = (at_ends[i] + before - first * m[i - 1]) / (1.0 - first)
        rises[i] = m[i] - m[i - 1]
    found = np.empty(len(ages))
    for row, (age, x) in enumerate(zip(ages, ahead, strict=True)):
        nodes = np.append(grid[grid < x], x)
        left = x - 0.5 * (nodes[1:] + nodes[:-1])
        failed = 1.0 - conditional_reliability(shape, scale, float(age), np.append(x, left))
        found[row] = float(failed[0]) + float(failed[1:] @ np.diff(np.interp(nodes, grid, m)))
    return found


def fleet_forecast(
    distribution: LifeDistribution,
    fleet: Fleet,
    *,
    renewed: bool = False,
    confidence: float = 0.9,
    steps: int = _STEPS,
    seed: int = 0,
) -> FleetForecast:
    """Count the failures of a fleet beforehand.

    Parameters
    ----------
    distribution
        Of the lives.
    fleet
        The bearings, and how long each will run.
    renewed
        Whether those that fail are replaced by new ones, which may fail too.
    confidence
        Of the prediction: both limits together.
    steps
        Equal parts of the way ahead, 1 to 100.
    seed
        Of the draws.

    Raises
    ------
    InputError
        For a number that cannot be, or more renewals than can be followed.
    """
    law = distribution
    share(confidence, "confidence")
    parts = np.arange(1, whole_number(steps, "steps", 1, 100) + 1) / steps
    random = generator(seed)
    notes: tuple[Note, ...] = () if law.uncertain else (Note("fleet_without_uncertainty"),)
    probability = _failing(law.shape, law.scale, fleet)
    expected = _expected(law, fleet, parts, renewed)
    if renewed:
        _check_renewals(float(expected[-1]), fleet)
    drawn = _counted(law, fleet, parts, renewed, random)
    tail = 0.5 * (1.0 - confidence)
    lower, upper = np.quantile(drawn, [tail, 1.0 - tail], axis=0, method="inverted_cdf")
    exact = (np.nan, np.nan)
    if not renewed:
        cumulated = np.cumsum(poisson_binomial(probability, fleet.counts))
        exact = _limits_of(cumulated, tail)
        if not law.uncertain:
            lower[-1], upper[-1] = exact
    if len(drawn) < 1000:
        notes = (*notes, Note("fleet_few_draws", {"draws": len(drawn)}))
    if not renewed and not law.uncertain:
        none = float(np.prod((1.0 - probability) ** fleet.counts))
    else:
        none = float(np.mean(drawn[:, -1] == 0))
    order = np.argsort(-probability, kind="stable")[:_RISKIEST]
    with np.errstate(over="ignore"):
        now = -np.expm1(-((fleet.ages / law.scale) ** law.shape))
    return FleetForecast(
        law,
        fleet,
        renewed,
        confidence,
        tuple(
            FleetStep(float(part), float(mean), float(low), float(high))
            for part, mean, low, high in zip(parts, expected, lower, upper, strict=True)
        ),
        exact,
        none,
        float(fleet.counts @ now),
        tuple((int(row), float(probability[row])) for row in order),
        len(drawn),
        notes,
    )


def _failing(shape: float, scale: float, fleet: Fleet) -> FloatArray:
    """Probability that each bearing fails on the way ahead; (rows,)."""
    chances = _chances(np.array([shape]), np.array([scale]), fleet.ages, fleet.ahead)
    return np.asarray(chances[0])


def _chances(
    shapes: FloatArray, scales: FloatArray, ages: FloatArray, ahead: FloatArray
) -> FloatArray:
    """Probability of failing on the way ahead, by distribution and row: (draws, rows)."""
    beta, eta = shapes[:, np.newaxis], scales[:, np.newaxis]
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        before = (ages / eta) ** beta
        longer = before * np.expm1(beta * np.log1p(ahead / np.maximum(ages, 1e-300)))
        whole = ((ages + ahead) / eta) ** beta  # where a power is beyond any number
        risk = np.where((ages > 0.0) & np.isfinite(longer), longer, whole)
    return np.asarray(-np.expm1(-np.where(ahead > 0.0, risk, 0.0)))


def _expected(law: LifeDistribution, fleet: Fleet, parts: FloatArray, renewed: bool) -> FloatArray:
    """Expected failures at the parts of the way; (parts,)."""
    ahead = np.outer(parts, fleet.ahead)
    if renewed:
        ages = np.broadcast_to(fleet.ages, ahead.shape).ravel()
        each = renewals(law.shape, law.scale, ages, ahead.ravel()).reshape(ahead.shape)
    else:
        one = np.array([law.shape]), np.array([law.scale])
        each = np.stack([_chances(*one, fleet.ages, row)[0] for row in ahead])
    return np.asarray(each @ fleet.counts)


def _limits_of(cumulated: FloatArray, tail: float) -> tuple[float, float]:
    """Numbers below and above which no more than the tails lie."""
    low = int(np.searchsorted(cumulated, tail, side="left"))
    high = int(np.searchsorted(cumulated, 1.0 - tail, side="left"))
    return float(low), float(min(high, len(cumulated) - 1))


def _check_renewals(expected: float, fleet: Fleet) -> None:
    """Refuse more lives one after the other than can be followed."""
    many = expected / fleet.size
    if not many <= _MOST_RENEWALS:
        raise InputError(
            said(
                "brings {many:.3} failures at each place; at most {most:.6g} can be followed",
                many=many,
                most=_MOST_RENEWALS,
            ),
            field="ahead",
            value=float(fleet.ahead.max()),
        )


def _counted(
    law: LifeDistribution,
    fleet: Fleet,
    parts: FloatArray,
    renewed: bool,
    random: np.random.Generator,
) -> FloatArray:
    """Cumulated failures at the parts of the way, in draws of the distribution: (draws, parts)."""
    width = (fleet.size if renewed else len(fleet.ages)) * len(parts)
    count = len(law.shapes) if law.uncertain else 10_000
    count = min(count, _RENEWED_DRAWS) if renewed else count
    count = max(min(count, _MOST_DRAWN // width), min(_FEWEST_DRAWS, count))
    shapes = law.shapes[:count] if law.uncertain else np.full(count, law.shape)
    scales = law.scales[:count] if law.uncertain else np.full(count, law.scale)
    if renewed:
        rows = np.repeat(np.arange(len(fleet.ages)), fleet.counts)
        ages, ahead = fleet.ages[rows], fleet.ahead[rows]
        lives = zip(shapes.tolist(), scales.tolist(), strict=True)
        each = [_renewed(shape, scale, ages, ahead, parts, random) for shape, scale in lives]
        return np.asarray(np.stack(each))
    found = np.empty((count, len(parts)))
    block = max(_MOST_DRAWN // (20 * len(fleet.ages)), 1)
    for first in range(0, count, block):
        beta, eta = shapes[first : first + block], scales[first : first + block]
        failed = np.zeros((len(beta), len(fleet.ages)))
        failed_counts = np.zeros((len(beta), len(fleet.ages)), dtype=np.int64)
        for place, part in enumerate(parts):
            # those that run on may fail in the next part
            so_far = _chances(beta, eta, fleet.ages, part * fleet.ahead)
            with np.errstate(invalid="ignore", divide="ignore"):
                more = np.where(failed < 1.0, (so_far - failed) / (1.0 - failed), 0.0)
            left = fleet.counts - failed_counts
            failed_counts += random.binomial(left, np.clip(more, 0.0, 1.0))
            failed = so_far
            found[first : first + block, place] = failed_counts.sum(axis=1)
    return found


def _renewed(
    shape: float,
    scale: float,
    ages: FloatArray,
    ahead: FloatArray,
    parts: FloatArray,
    random: np.random.Generator,
) -> FloatArray:
    """Cumulated failures at the parts of the way of one draw, with renewals: (parts,)."""
    total = np.zeros(len(parts))
    with np.errstate(over="ignore", divide="ignore"):
        risk = (ages / scale) ** shape + random.standard_exponential(len(ages))
        at = scale * risk ** (1.0 / shape) - ages
    ends = ahead
    for _ in range(_MOST_LIVES):
        failed = at <= ends
        at, ends = at[failed], ends[failed]
        if not len(at):
            break
        with np.errstate(divide="ignore", invalid="ignore"):
            place = np.searchsorted(parts, np.nan_to_num(at / ends), side="left")
        total += np.cumsum(np.bincount(np.minimum(place, len(parts) - 1), minlength=len(parts)))
        at = at + scale * random.standard_exponential(len(at)) ** (1.0 / shape)
    return total
