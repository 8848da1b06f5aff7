"""Whether a Weibull distribution describes a life test: Anderson-Darling, and a dog-leg.

*Anderson and Darling's* distance between the share F_n that failed in the test (Kaplan-Meier, where
some are suspended) and the fitted F, up to the longest time or, where the last bearing failed, to
F = 1:

    A² = n ∫ (F_n - F)²/(F (1 - F)) dF,

which is summed exactly, for between two failures F_n is a constant c and

    ∫ (c - u)²/(u (1 - u)) du = c² ln u - (1 - c)² ln(1 - u) - u.

For complete data this is the usual sum, for a test that ended at its r-th failure that of Pettitt
and Stephens. *Inspected* failures have no times; there twice the difference of the logarithms of
the likelihoods takes its place, between the fit and a share of failures of its own for each
interval.

*A dog-leg* is a line on the Weibull plot that is broken at a time τ,

    H(t) = a (t/τ)^β₁ before τ,    a (t/τ)^β₂ after,

fitted by maximum likelihood at every τ that leaves three failures on either side, and set against
the straight line: twice the difference of the logarithms of the likelihoods. With given τ the
logarithm of the likelihood is concave in (β₁, β₂), so that Newton's method finds its one maximum.

Neither statistic has a table for parameters that are estimated from data with any censoring. Their
p-values are shares of tests drawn at the fit, with its censoring, and fitted again (parametric
bootstrap): (1 + as far or farther)/(1 + drawn).

Sources: Anderson and Darling, J. Amer. Statist. Assoc. 49 (1954) 765; Pettitt and Stephens,
Biometrika 63 (1976) 291; D'Agostino and Stephens, Goodness-of-Fit Techniques (1986), sections 4.7
and 7.2; Stute, Gonzáles Manteiga and Presedo Quindimil, Metrika 40 (1993) 243, for the bootstrap;
Davison and Hinkley (1997), section 4.2, for the p-value; Lawless (2003), section 10.2, for broken
hazards.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, generator
from rolamento.weibull.drawing import MINIMUM_FITS, Inspected, RightCensored, model_of, portions
from rolamento.weibull.estimates import fixed_shape, maximum_likelihood, rows_of
from rolamento.weibull.fit import Outcome, WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood import CONVERGED, Likelihood, Rows, fit_rows, fits_of
from rolamento.weibull.limits import sample_count, shape_of
from rolamento.words import Note

__all__ = ["DogLeg", "GoodnessOfFit", "anderson_darling", "goodness_of_fit"]

SIGNIFICANT: Final = 0.1
"""p-value below which the data contradict the distribution, or a straight line: that of the 90 %
bounds beside which it stands. Where the clock ended the test both are on the safe side of it."""
_LEAST_FAILURES: Final = 3
_EITHER_SIDE: Final = 3
"""Failures on either side of a break: two of them determine a slope, a third one tests it."""
_BREAKS: Final = 12
_STEPS: Final = 40
_MOST_SAMPLES: Final = 1000
_FEWEST_SAMPLES: Final = 200
_MAXIMUM_DRAWN: Final = 200_000
"""Times in all drawn tests together; fewer of large tests are drawn."""
_MOST_ROWS: Final = 20_000


@frozen
class DogLeg:
    """A line on the Weibull plot that is broken at a time.

    Attributes
    ----------
    time
        of the break, in the unit of the test
    ordinate
        ln ln 1/(1 - F) of the line there
    shape_before, shape_after
        slopes β₁ and β₂ of the two parts
    log_likelihood
        of the data, at this line
    statistic
        twice that, less that of the straight line
    p_value
        share of drawn tests without a break in which a broken line is at least as much better
    """

    time: float
    ordinate: float
    shape_before: float
    shape_after: float
    log_likelihood: float
    statistic: float
    p_value: float

    def life_at_ordinate(self, ordinate: FloatArray) -> FloatArray:
        """Times of the broken line at ordinates of the Weibull plot."""
        above = ordinate - self.ordinate
        slope = np.where(above < 0.0, self.shape_before, self.shape_after)
        return np.asarray(self.time * np.exp(above / slope))

    @property
    def significant(self) -> bool:
        """Whether the data contradict a straight line."""
        return self.p_value < SIGNIFICANT

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values."""
        names = (
            "time",
            "ordinate",
            "shape_before",
            "shape_after",
            "log_likelihood",
            "statistic",
            "p_value",
        )
        return {name: finite(getattr(self, name)) for name in names}


@frozen
class GoodnessOfFit(Outcome):
    """How well a Weibull distribution describes a life test; NaN where that cannot be tested.

    Attributes
    ----------
    method
        "anderson_darling"; "likelihood_ratio" for failures found at inspections
    code
        "converged", or why there is no test, a code that `advice` explains
    statistic
        A², or twice the difference of the logarithms of the likelihoods
    p_value
        share of tests drawn at the fit that lie at least as far from their own fits
    dog_leg
        the broken line that fits best; None with too few failures, or at a known shape
    samples, dropped, seed
        tests drawn, how many had no fit, and with what they were drawn
    notes
        what limits it, each once
    """

    method: str
    code: str
    statistic: float = np.nan
    p_value: float = np.nan
    dog_leg: DogLeg | None = None
    samples: int = 0
    dropped: int = 0
    seed: int = 0
    notes: tuple[Note, ...] = ()

    @property
    def bent(self) -> DogLeg | None:
        """The dog-leg, if the data contradict a straight line."""
        return self.dog_leg if self.dog_leg is not None and self.dog_leg.significant else None

    @property
    def contradicted(self) -> bool:
        """Whether the data contradict the distribution, by either test."""
        return self.p_value < SIGNIFICANT or self.bent is not None

    def contradictions(self, unit: str) -> tuple[Note, ...]:
        """Return what speaks against the distribution, in notes that lead a page.

        unit: label of the times.
        """
        if self.bent is not None:
            bend = self.bent
            values = {
                "time": bend.time, "unit": unit, "before": bend.shape_before,
                "after": bend.shape_after, "p": bend.p_value,
            }  # fmt: skip
            steeper = bend.shape_after > bend.shape_before
            return (Note("dog_leg_steeper" if steeper else "dog_leg_flatter", values),)
        inspected = self.method == "likelihood_ratio"
        key = "weibull_contradicted_by_intervals" if inspected else "weibull_contradicted"
        return (Note(key, {"p": self.p_value}),) if self.contradicted else ()

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; None where there is no number."""
        return {
            "method": self.method,
            "status": self.status(),
            "statistic": finite(self.statistic),
            "p_value": finite(self.p_value),
            "contradicted": self.contradicted,
            "dog_leg": None if self.dog_leg is None else self.dog_leg.to_mapping(),
            "samples": self.samples,
            "dropped": self.dropped,
            "seed": self.seed,
            "notes": [note.to_mapping() for note in self.notes],
        }


def goodness_of_fit(
    test: LifeTest | ArrayLike,
    *,
    shape: float | None = None,
    samples: int = _MOST_SAMPLES,
    seed: int = 0,
) -> GoodnessOfFit:
    """Test whether a Weibull distribution describes a life test, and whether its plot is bent.

    Parameters
    ----------
    test
        With any kind of censoring; at least three failures.
    shape
        β from experience: then it is the distribution of that shape that is tested.
    samples, seed
        Tests to draw, 100 to a million, of which 1000 are taken at most, fewer of large tests; and
        what they are drawn with.

    Raises
    ------
    InputError
        For a number that cannot be.
    """
    test = LifeTest.of(test)
    count, random = min(sample_count(samples), _MOST_SAMPLES), generator(seed)
    known = None if shape is None else shape_of(shape)
    method = "likelihood_ratio" if test.inspected else "anderson_darling"
    fit = maximum_likelihood(test) if known is None else fixed_shape(test, known)
    if not fit.converged:
        return GoodnessOfFit(method, fit.code)
    model = model_of(test)
    if isinstance(model, str):
        return GoodnessOfFit(method, model)
    if test.failures < _LEAST_FAILURES:
        return GoodnessOfFit(method, "few_to_test")
    if len(test) > _MOST_ROWS:
        return GoodnessOfFit(method, "too_large")
    count = min(count, max(_MAXIMUM_DRAWN // model.width, _FEWEST_SAMPLES))
    if isinstance(model, Inspected):
        found = _of_inspected(test, fit, model, known, count, random)
    else:
        found = _of_times(test, fit, model, known, count, random)
    notes = () if model.exact else (
        Note("inspections_shared" if test.inspected else "censoring_modelled"),
    )  # fmt: skip
    return replace(found, seed=int(seed), notes=notes)


def _of_times(
    test: LifeTest,
    fit: WeibullFit,
    model: RightCensored,
    known: float | None,
    count: int,
    random: np.random.Generator,
) -> GoodnessOfFit:
    rows = _in_order(rows_of(test))  # of one sample
    at = np.array([fit.shape]), np.log([fit.scale])
    distance = float(anderson_darling(rows, *at)[0])
    bend = None if known is not None else _broken(rows, at[0])
    drawn, gains = [], []
    for portion in portions(model.width, count):
        many = _in_order(model.rows(fit.shape, float(np.log(fit.scale)), portion, random))
        shapes, log_scales, good = _fitted(many, known)
        if not np.any(good):
            continue
        many, shapes, log_scales = many.part(good), shapes[good], log_scales[good]
        drawn.append(anderson_darling(many, shapes, log_scales))
        if bend is not None and np.isfinite(bend.gain[0]):
            gains.append(_broken(many, shapes).gain)
    distances = np.concatenate(drawn) if drawn else np.empty(0)
    if len(distances) < MINIMUM_FITS:
        return GoodnessOfFit("anderson_darling", "not_converged")
    dog_leg = None
    if bend is not None and gains:
        gain = float(bend.gain[0])
        p = _p_value(gain, np.nan_to_num(np.concatenate(gains)))
        before, after = float(bend.before[0]), float(bend.after[0])
        away = rows.log_time - bend.log_time[0]
        risks = np.exp(np.where(away < 0.0, before, after) * away)
        dog_leg = DogLeg(
            float(np.exp(bend.log_time[0])),
            float(np.log(test.failures / np.sum(rows.units * risks))),
            before,
            after,
            fit.log_likelihood + 0.5 * gain,
            gain,
            p,
        )
    dropped = count - len(distances)
    p = _p_value(distance, distances)
    return GoodnessOfFit("anderson_darling", "converged", distance, p, dog_leg, count, dropped)


def _p_value(observed: float, drawn: FloatArray) -> float:
    """Share of the draws that are at least as far, the test itself among them."""
    near = observed * (1.0 - 1e-9)
    return float((1 + np.count_nonzero(drawn >= near)) / (1 + len(drawn)))


def _in_order(rows: Rows) -> Rows:
    """Return samples by their times, failures before suspensions at the same time; (S, N) each."""
    shape = rows.log_time.shape
    failures, units = (np.broadcast_to(array, shape) for array in rows[1:])
    order = np.lexsort((-failures, rows.log_time), axis=1)
    return Rows(*(np.take_along_axis(a, order, axis=1) for a in (rows.log_time, failures, units)))


def _fitted(rows: Rows, known: float | None) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Shape and logarithm of the scale of every sample, and whether there is a fit."""
    if known is None:
        fit = fit_rows(rows)
        return fit.shape, fit.log_scale[0], fit.code == CONVERGED
    total = rows.failures.sum(axis=1)
    longest = rows.log_time.max(axis=1)
    power = np.exp(known * (rows.log_time - longest[:, np.newaxis]))
    with np.errstate(divide="ignore"):
        log_scale = longest + (np.log(np.sum(rows.units * power, axis=1)) - np.log(total)) / known
    return np.full(len(total), known), log_scale, total > 0.0


def anderson_darling(rows: Rows, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
    """Distance A² of every sample from its distribution; (samples,).

    Parameters
    ----------
    rows
        Of `rolamento.weibull.likelihood`, (samples, rows) each, in the order of the times.
    shape, log_scale
        (samples,) β and ln η.
    """
    log_time = rows.log_time
    failures, units = (np.broadcast_to(array, log_time.shape) for array in rows[1:])
    running = np.cumsum(units[:, ::-1], axis=1)[:, ::-1]
    alive = np.cumprod(1.0 - failures / running, axis=1)
    share = 1.0 - alive
    risk = np.exp(shape[:, np.newaxis] * (log_time - log_scale[:, np.newaxis]))
    log_failed = np.log(-np.expm1(-risk))
    failed = -np.expm1(-risk)
    # between one time and the next the share that failed is constant
    steps = (
        share[:, :-1] ** 2 * np.diff(log_failed, axis=1)
        + alive[:, :-1] ** 2 * np.diff(risk, axis=1)
        - np.diff(failed, axis=1)
    ).sum(axis=1)
    first = risk[:, 0] - failed[:, 0]
    all_failed = failures[:, -1] >= running[:, -1]
    last = np.where(all_failed, -log_failed[:, -1] - (1.0 - failed[:, -1]), 0.0)
    return np.asarray(running[:, 0] * (first + steps + last))


# --- a broken line --------------------------------------------------------------------------------


@frozen
class _Broken:
    """Best broken line of every sample; gain is NaN where there is none. All (samples,)."""

    log_time: FloatArray
    before: FloatArray
    after: FloatArray
    gain: FloatArray


def _broken(rows: Rows, shape: FloatArray) -> _Broken:
    """Find the broken line that fits best; shape: (samples,) of the straight one."""
    log_time, failures, _ = rows
    rank = np.cumsum(failures, axis=1)
    total = rank[:, -1]
    found = np.full((4, len(total)), np.nan)
    gains = np.full(len(total), -np.inf)
    for part in np.linspace(0.0, 1.0, _BREAKS):
        # the break lies halfway between a failure and the next one
        below = np.floor(_EITHER_SIDE + part * (total - 2.0 * _EITHER_SIDE))[:, np.newaxis]
        failed = failures > 0.0
        low = np.where((rank <= below) & failed, log_time, -np.inf).max(axis=1)
        high = np.where((rank > below) & failed, log_time, np.inf).min(axis=1)
        able = (total >= 2 * _EITHER_SIDE) & np.isfinite(low) & np.isfinite(high) & (high > low)
        if not np.any(able):
            continue
        at = 0.5 * (low[able] + high[able])
        before, after, gain = _slopes(rows.part(able), at, shape[able])
        better = np.flatnonzero(able)[gain > gains[able]]
        which = gain > gains[able]
        gains[better] = gain[which]
        found[:, better] = [at[which], before[which], after[which], 2.0 * gain[which]]
    return _Broken(*found)


def _slopes(
    rows: Rows, at: FloatArray, shape: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Slopes before and after a break, and what they gain of the likelihood's logarithm."""
    log_time, failures, units = rows
    y = log_time - at[:, np.newaxis]
    halves = [np.where(y < 0.0, y, 0.0), np.where(y < 0.0, 0.0, y)]
    sides = [y < 0.0, y >= 0.0]
    total = failures.sum(axis=1)
    counts = [np.sum(failures * side, axis=1) for side in sides]
    sums = [np.sum(failures * half, axis=1) for half in halves]

    def value(b: list[FloatArray]) -> tuple[FloatArray, FloatArray]:
        z = b[0][:, np.newaxis] * halves[0] + b[1][:, np.newaxis] * halves[1]
        top = z.max(axis=1)
        weight = units * np.exp(z - top[:, np.newaxis])
        level = sum(c * np.log(x) + x * s for c, x, s in zip(counts, b, sums, strict=True))
        return level - total * (np.log(weight.sum(axis=1)) + top), weight

    slopes = [shape.copy(), shape.copy()]
    straight, weight = value(slopes)
    here = straight
    for _ in range(_STEPS):
        scale = weight.sum(axis=1)
        first = [np.sum(weight * half, axis=1) / scale for half in halves]
        second = [np.sum(weight * half**2, axis=1) / scale for half in halves]
        rise = [
            c / b + s - total * m for c, b, s, m in zip(counts, slopes, sums, first, strict=True)
        ]
        bend = [
            c / b**2 + total * (q - m * m)
            for c, b, m, q in zip(counts, slopes, first, second, strict=True)
        ]
        mixed = -total * first[0] * first[1]
        determinant = bend[0] * bend[1] - mixed**2
        step = [
            (rise[0] * bend[1] - rise[1] * mixed) / determinant,
            (rise[1] * bend[0] - rise[0] * mixed) / determinant,
        ]
        # slopes stay above zero, and none more than triples at once
        length = np.ones(len(at))
        for b, d in zip(slopes, step, strict=True):
            with np.errstate(divide="ignore", invalid="ignore"):
                length = np.where(d < 0.0, np.minimum(length, -0.8 * b / d), length)
                length = np.where(d > 0.0, np.minimum(length, 2.0 * b / d), length)
        for _ in range(20):
            tried = [b + length * d for b, d in zip(slopes, step, strict=True)]
            there, weight_there = value(tried)
            worse = ~(there >= here - 1e-12 * np.maximum(np.abs(here), 1.0))
            if not np.any(worse):
                break
            length = np.where(worse, 0.5 * length, length)
        gained = there - here
        slopes, here, weight = tried, there, weight_there
        if np.all(np.abs(gained) <= 1e-10 * np.maximum(np.abs(here), 1.0)):
            break
    return slopes[0], slopes[1], here - straight


# --- inspected failures ---------------------------------------------------------------------------


def _of_inspected(
    test: LifeTest,
    fit: WeibullFit,
    model: Inspected,
    known: float | None,
    count: int,
    random: np.random.Generator,
) -> GoodnessOfFit:
    """Set the fit against a share of failures of its own for each interval."""
    method = "likelihood_ratio"
    cells = _in_cells(test, model)
    if cells is None or known is not None:
        return GoodnessOfFit(method, "not_modelled")
    observed = float(_deviance(cells, np.array([fit.shape]), np.log([fit.scale]))[0])
    drawn = []
    for portion in portions(model.width, count):
        many = model.likelihood(fit.shape, float(np.log(fit.scale)), portion, random)
        fits = fits_of(many)
        good = fits.code == CONVERGED
        if np.any(good):
            drawn.append(_deviance(many.lanes(good), fits.shape[good], fits.log_scale[0, good]))
    distances = np.concatenate(drawn) if drawn else np.empty(0)
    if len(distances) < MINIMUM_FITS:
        return GoodnessOfFit(method, "not_converged")
    p = _p_value(observed, distances)
    return GoodnessOfFit(method, "converged", observed, p, None, count, count - len(distances))


def _in_cells(test: LifeTest, model: Inspected) -> Likelihood | None:
    """Return the test by the cells of the schedule; None where a failure spans several of them."""
    ends = np.exp(model.schedule)
    starts = np.append(0.0, ends[:-1])
    cell = np.argmin(np.abs(ends - test.times[:, np.newaxis]), axis=1)
    lower = np.where(test.failed, test.lower, starts[cell])
    if not np.allclose(lower, starts[cell], rtol=1e-9, atol=0.0):
        return None
    found, suspended = (
        np.bincount(cell[which], test.counts[which], len(ends)).astype(np.float64)[np.newaxis]
        for which in (test.failed, ~test.failed)
    )
    return Likelihood(
        0.0, np.empty(0), np.empty((1, 0)), model.schedule, suspended,
        np.append(-np.inf, model.schedule[:-1]), model.schedule, found,
    )  # fmt: skip


def _deviance(cells: Likelihood, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
    """Twice the logarithm of the likelihood that the fit lacks; (lanes,)."""
    failed, suspended = cells.interval_counts, cells.suspended_counts
    start = np.cumsum((failed + suspended)[:, ::-1], axis=1)[:, ::-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        part = failed / start
        free = np.where(failed > 0.0, failed * np.log(part), 0.0)
        free += np.where(start > failed, (start - failed) * np.log1p(-part), 0.0)
    fitted = cells.value(shape, -shape * log_scale)
    return np.asarray(np.maximum(2.0 * (free.sum(axis=1) - fitted), 0.0))
