"""All that a life test says, group by group: fits, bounds, a calculated life, comparisons."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from typing import Any, Final, Literal, get_args

from numpy.typing import ArrayLike

from rolamento.errors import InputError, arguments
from rolamento.records import frozen
from rolamento.validate import finite, one_of
from rolamento.weibull.bounds import Band, Bounds, Method, Sides, all_bounds, confidence_band
from rolamento.weibull.comparison import (
    VERDICT_METHODS,
    CalculatedLife,
    Comparison,
    Hypothesis,
    LifeRatio,
    against_calculated_life,
    compare,
    life_ratio,
)
from rolamento.weibull.estimates import (
    Regression,
    fixed_shape,
    maximum_likelihood,
    plotting_positions,
    rank_regression,
    three_parameter,
)
from rolamento.weibull.fit import Estimand, WeibullFit
from rolamento.weibull.goodness import GoodnessOfFit, goodness_of_fit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.likelihood_ratio import LikelihoodRegion, likelihood_region
from rolamento.weibull.models import LifeModel, life_models
from rolamento.weibull.modes import ModeSystem, system_of_modes
from rolamento.weibull.posterior import ShapePrior, posterior
from rolamento.weibull.sampled import unbiased
from rolamento.words import Note, said

FitMethod = Literal[
    "maximum_likelihood",
    "unbiased",
    "rank_regression_x_on_y",
    "rank_regression_y_on_x",
    "three_parameter",
]
FIT_METHODS: Final = get_args(FitMethod)
MAXIMUM_RANKED: Final = 20_000
"""Failures up to which each gets its rank, and is drawn."""
_AT_SHAPE: Final[tuple[FitMethod, ...]] = ("maximum_likelihood", "rank_regression_x_on_y")
"""Methods that find the scale at a known shape; both regressions are one there."""
_OF_SHAPE: Final = ("unbiased", "three_parameter")
ASSUMED_SHAPES: Final = (1.0, 1.5, 2.0)
"""For a test that does not determine the shape."""
MAXIMUM_GROUPS: Final = 20
_MAXIMUM_RATIOS: Final = 10
_HYPOTHESES: Final[tuple[Hypothesis, ...]] = ("common_shape", "same_life", "homogeneous")

Progress = Callable[[int, int], None]


@frozen(kw_only=True)
class LifeTestRequest:
    """What is to be found of a life test.

    Attributes
    ----------
    methods
        of fitting, `FIT_METHODS`
    bounds
        method of the bounds; that of `rolamento.weibull.bounds` by default
    confidence, sides
        of the bounds
    reliabilities
        of the lives to be found; a calculated life is for the first
    times
        of the reliabilities to be found; unit of the test
    shape
        β from experience: then only the scale comes from the test
    prior
        what was known of the shape, for the posterior; None without
    calculated
        calculated lives by their names; unit of the test
    models
        whether other distributions are fitted beside; by default where the data contradict one of
        Weibull's
    samples, seed
        tests to draw, and what they are drawn with
    """

    methods: tuple[FitMethod, ...] = FIT_METHODS[:4]
    bounds: Method | None = None
    confidence: float = 0.9
    sides: Sides = "two"
    reliabilities: tuple[float, ...] = (0.9, 0.5)
    times: tuple[float, ...] = ()
    shape: float | None = None
    prior: ShapePrior | None = None
    calculated: Mapping[str, float] = field(default_factory=dict)
    models: bool | None = None
    samples: int = 10_000
    seed: int = 0

    def __post_init__(self) -> None:
        """Refuse unknown methods, and no life at all."""
        for name in ("methods", "reliabilities", "times"):
            many = getattr(self, name)
            if isinstance(many, str) or not isinstance(many, Iterable):
                raise InputError(said("must be a list"), field=name, value=many)
            object.__setattr__(self, name, tuple(many))
        for method in self.methods:
            one_of(method, "method", FIT_METHODS)
        if not self.reliabilities:
            raise InputError(said("must be at least one"), field="reliability", example="0.9")
        if self.shape is not None and self.bounds not in (None, "fixed_shape"):
            raise InputError(
                said("cannot be combined with other bounds"), field="shape", value=self.shape
            )
        if self.shape is not None and self.methods == FIT_METHODS[:4]:
            object.__setattr__(self, "methods", _AT_SHAPE)
        for method in self.methods if self.shape is not None else ():
            if method in _OF_SHAPE:
                rule = said("fits the shape too, which is given here")
                raise InputError(rule, field="method", value=method, example=_AT_SHAPE[0])

    @property
    def lives(self) -> tuple[Estimand, ...]:
        """Lives to be found."""
        return tuple(Estimand.life(r) for r in self.reliabilities)

    @property
    def shares(self) -> tuple[Estimand, ...]:
        """Reliabilities to be found."""
        return tuple(Estimand.reliability(time) for time in self.times)

    def bounded(self, with_shape: bool) -> tuple[Estimand, ...]:
        """Quantities that are bounded; the shape only where it is not given."""
        shape = (Estimand.of("shape"),) if with_shape else ()
        return (*shape, Estimand.of("scale"), *self.lives, *self.shares)

    def bounds_of(self, test: LifeTest) -> tuple[Sides, float]:
        """Sides and confidence of the bounds of a test.

        Without failures nothing bounds from above. The lower bound then has the confidence that
        it has among two-sided ones, so that all lower bounds of a page are of one kind.
        """
        if test.failures or self.sides != "two":
            return self.sides, self.confidence
        return "lower", 0.5 * (1.0 + self.confidence)


@frozen
class Credible:
    """Median and interval of a quantity after the test, with what was known before.

    Attributes
    ----------
    quantity, unit
        as it is written, and its label; empty for a shape or a reliability
    median, lower, upper, probability
        the quantity lies between the limits with the probability
    """

    quantity: str
    unit: str
    median: float
    lower: float
    upper: float
    probability: float

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; None where there is no number."""
        names = ("median", "lower", "upper")
        return {
            "quantity": self.quantity,
            "unit": self.unit,
            **{name: finite(getattr(self, name)) for name in names},
            "probability": self.probability,
        }


@frozen
class AssumedShape:
    """Results of a test that does not determine the shape, for an assumed shape."""

    shape: float
    bounds: tuple[Bounds, ...]

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values."""
        return {"shape": self.shape, "bounds": [bound.to_mapping() for bound in self.bounds]}


@frozen(eq=False)
class GroupSummary:
    """What one group or one failure mode says, or a test without either.

    Attributes
    ----------
    name
        label of the group or the mode; empty without
    test
        its part of the data
    fits
        by every requested method that applies; the bounds refer to the first
    bounds
        on shape, scale, lives and reliabilities
    assumed
        where the test does not determine the shape: results for usual shapes
    calculated
        calculated lives set against it, by their names
    prior_code, credible
        status of the posterior, empty if not requested; and its results
    goodness
        whether a Weibull distribution describes it
    models
        other distributions beside, where it does not, or if they are asked for
    """

    name: str
    test: LifeTest
    fits: tuple[WeibullFit, ...]
    bounds: tuple[Bounds, ...]
    assumed: tuple[AssumedShape, ...]
    calculated: Mapping[str, CalculatedLife]
    prior_code: str
    credible: tuple[Credible, ...]
    goodness: GoodnessOfFit
    models: tuple[LifeModel, ...] = ()

    @property
    def ranked(self) -> bool:
        """Whether the failures have ranks: their times are known, and they are not too many."""
        return has_ranks(self.test)

    @property
    def main(self) -> WeibullFit:
        """Fit that the bounds are about."""
        return self.fits[0]

    @property
    def bounded(self) -> bool:
        """Whether there are bounds on anything."""
        return any(bound.converged for bound in self.bounds)

    @property
    def has_result(self) -> bool:
        """Whether the group says anything in numbers of its own."""
        return self.main.converged or self.bounded or bool(self.credible)

    def bound(self, quantity: Estimand) -> Bounds | None:
        """Bounds on a quantity."""
        return next((one for one in self.bounds if one.quantity == quantity.name), None)

    def to_mapping(self) -> dict[str, Any]:
        """Give the group as plain values."""
        test = self.test
        points = _plotted_points(test) if self.ranked else []
        return {
            "name": self.name,
            "size": test.size,
            "failures": test.failures,
            "suspensions": test.suspensions,
            "scheme": test.scheme,
            "total_time": test.total_time,
            "points": points,
            "fits": [fit.to_mapping() for fit in self.fits],
            "bounds": [bound.to_mapping() for bound in self.bounds],
            "assumed_shapes": [one.to_mapping() for one in self.assumed],
            "calculated": {name: one.to_mapping() for name, one in self.calculated.items()},
            "posterior": {"code": self.prior_code, "of": [c.to_mapping() for c in self.credible]}
            if self.prior_code
            else None,
            "goodness_of_fit": self.goodness.to_mapping(),
            "models": [model.to_mapping() for model in self.models],
        }


@frozen(eq=False)
class LifeTestSummary:
    """What a life test says.

    Attributes
    ----------
    test
        the data, all groups together
    request
        what was asked for
    groups
        in the order of the data; one without a name where they are not parted. The failure modes
        where the data are taken by them
    system
        the modes put together; None without
    notes
        what is to be known of the whole
    comparisons
        whether the groups have shape and life in common
    ratios
        life of the first group over that of each other
    """

    test: LifeTest
    request: LifeTestRequest
    groups: tuple[GroupSummary, ...]
    comparisons: tuple[Comparison, ...] = ()
    ratios: tuple[LifeRatio, ...] = ()
    system: ModeSystem | None = None
    notes: tuple[Note, ...] = ()

    @property
    def has_result(self) -> bool:
        """Whether any group says anything in numbers of its own."""
        return any(group.has_result for group in self.groups)

    def to_mapping(self) -> dict[str, Any]:
        """Give the summary as plain values, times in the unit of the data; None for no number."""
        test, request = self.test, self.request
        return {
            "schema": 2,
            "kind": "weibull",
            "title": test.title,
            "source": test.source,
            "passed_over": list(test.passed_over),
            "notes": [note.to_mapping() for note in (*self.notes, *test.notes)],
            "unit": test.unit,
            "size": test.size,
            "failures": test.failures,
            "suspensions": test.suspensions,
            "confidence": request.confidence,
            "samples": request.samples,
            "seed": request.seed,
            "groups": [group.to_mapping() for group in self.groups],
            "comparisons": [one.to_mapping() for one in self.comparisons],
            "life_ratios": [one.to_mapping() for one in self.ratios],
            "by_mode": self.system is not None,
            "system": None if self.system is None else self.system.to_mapping(),
        }


def has_ranks(test: LifeTest) -> bool:
    """Whether the failures of a test have ranks: their times are known, and they are not many."""
    return not test.inspected and test.failures <= MAXIMUM_RANKED


def _plotted_points(test: LifeTest) -> list[dict[str, float]]:
    """Points of the Weibull plot."""
    positions = plotting_positions(test)
    columns = zip(positions.times, positions.rank, positions.failed_share, strict=True)
    return [
        {"time": float(time), "rank": float(rank), "failed_share": float(share)}
        for time, rank, share in columns
    ]


# --- how it is found ------------------------------------------------------------------------------


def summarise(
    test: LifeTest | ArrayLike,
    request: LifeTestRequest | None = None,
    *,
    by_group: bool = True,
    by_mode: bool = True,
    progress: Progress | None = None,
) -> LifeTestSummary:
    """Find all that a life test says.

    Parameters
    ----------
    test
        With any kind of censoring, with or without groups.
    request
        What to find; the default of `LifeTestRequest` if not given.
    by_group
        Whether to take each group by itself and to compare them; all together otherwise.
    by_mode
        Whether to take each failure mode by itself, the others as suspensions, and to put them
        together, where the data have several; all failures alike otherwise.
    progress
        Called with steps done and steps in all.

    Raises
    ------
    InputError
        For more than 20 groups or modes to be taken by themselves, groups and modes at once, or
        what bounds and fits refuse.
    """
    test = LifeTest.of(test)
    asked = LifeTestRequest() if request is None else request
    tests = test.by_group() if by_group else {"": test}
    modes = test.modes
    notes: tuple[Note, ...] = ()
    if len(modes) > 1 and by_mode:
        _check_groups_and_modes(tests, modes)
        tests = test.by_mode()
    elif len(modes) > 1:
        notes = (Note("modes_pooled", {"count": len(modes)}),)
    system_wanted = len(modes) > 1 and by_mode
    if len(tests) > MAXIMUM_GROUPS:
        raise InputError(
            said(
                "must be at most {most} to be shown one by one; choose another column, "
                "or all together",
                most=MAXIMUM_GROUPS,
            ),
            field="groups",
            value=len(tests),
        )
    compared = len(tests) > 1 and not test.inspected and not system_wanted
    pairs = list(tests)[1 : _MAXIMUM_RATIOS + 1] if compared else []
    steps = len(tests) + (len(_HYPOTHESES) if compared else 0) + len(pairs) + system_wanted
    done = 0

    def step() -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(done, steps)

    groups = []
    for name, part in tests.items():
        groups.append(_summary_of(name, part, asked))
        step()
    comparisons = []
    for hypothesis in _HYPOTHESES if compared else ():
        comparisons.append(compare(tests, hypothesis, samples=asked.samples, seed=asked.seed))
        step()
    ratios = []
    for other in pairs:
        ratios.append(_ratio_to_first(tests, other, comparisons, asked))
        step()
    system = None
    if system_wanted:
        system = system_of_modes(
            test,
            (*asked.lives, *asked.shares),
            shape=asked.shape,
            confidence=asked.confidence,
            sides=asked.sides,
            samples=asked.samples,
            seed=asked.seed,
        )
        step()
    return LifeTestSummary(
        test, asked, tuple(groups), tuple(comparisons), tuple(ratios), system, notes
    )


def _check_groups_and_modes(groups: Mapping[str, LifeTest], modes: tuple[str, ...]) -> None:
    if len(groups) > 1:
        raise InputError(
            said(
                "has {groups} groups and {modes} failure modes: choose one mode, so that its groups"
                " are compared; or one group, so that its modes are separated; or take the groups"
                " together",
                groups=len(groups),
                modes=len(modes),
            ),
            field="only_mode",
            example=arguments(only_mode=modes[0]),
        )


def _summary_of(name: str, test: LifeTest, asked: LifeTestRequest) -> GroupSummary:
    fits = _fits_by(test, asked)
    sides, confidence = asked.bounds_of(test)
    bounds = all_bounds(
        test,
        asked.bounded(with_shape=asked.shape is None),
        method=asked.bounds,
        confidence=confidence,
        sides=sides,
        samples=asked.samples,
        seed=asked.seed,
        shape=asked.shape,
    )
    goodness = goodness_of_fit(test, shape=asked.shape, samples=asked.samples, seed=asked.seed)
    beside = goodness.contradicted if asked.models is None else asked.models
    alone = not any(bound.converged for bound in bounds)
    code, credible = _credible_intervals(test, asked)
    return GroupSummary(
        name,
        test,
        fits,
        bounds,
        _at_assumed_shapes(test, asked) if alone and not credible else (),
        {
            label: _against_calculation(test, life, asked)
            for label, life in asked.calculated.items()
        },
        code,
        credible,
        goodness,
        life_models(test) if beside else (),
    )


def _fits_by(test: LifeTest, asked: LifeTestRequest) -> tuple[WeibullFit, ...]:
    """Fits by every method, the one that the bounds are about first."""
    fits = [] if asked.shape is None else [fixed_shape(test, asked.shape)]
    methods = dict.fromkeys(("maximum_likelihood", *asked.methods))  # the bounds' own is the first
    for method in methods:
        if method.startswith("rank_regression") and not has_ranks(test):
            continue
        if method == "maximum_likelihood" and asked.shape is not None:
            continue
        fits.append(fit_by(method, test, shape=asked.shape, samples=asked.samples, seed=asked.seed))
    return tuple(fits)


def fit_by(
    method: FitMethod,
    test: LifeTest,
    *,
    shape: float | None = None,
    samples: int = 10_000,
    seed: int = 0,
) -> WeibullFit:
    """Fit a test by a method of `FIT_METHODS`.

    Parameters
    ----------
    method, test
        The method and the data.
    shape
        A known shape, of the rank regressions alone.
    samples, seed
        Tests that the unbiased method draws, and what they are drawn with.

    Raises
    ------
    InputError
        If there is no such method.
    """
    one_of(method, "method", FIT_METHODS)
    if method == "maximum_likelihood":
        return maximum_likelihood(test)
    if method == "unbiased":
        return unbiased(test, samples=samples, seed=seed)
    if method == "three_parameter":
        return three_parameter(test)
    regression: Regression = "x_on_y" if "x_on_y" in method else "y_on_x"
    return rank_regression(test, regression, shape=shape)


def _at_assumed_shapes(test: LifeTest, asked: LifeTestRequest) -> tuple[AssumedShape, ...]:
    quantities = (*asked.lives, *asked.shares)
    sides, confidence = asked.bounds_of(test)
    return tuple(
        AssumedShape(
            shape,
            all_bounds(test, quantities, confidence=confidence, sides=sides, shape=shape),
        )
        for shape in ASSUMED_SHAPES
    )


def _against_calculation(test: LifeTest, life: float, asked: LifeTestRequest) -> CalculatedLife:
    return against_calculated_life(
        test,
        life,
        asked.reliabilities[0],
        method=asked.bounds if asked.bounds in VERDICT_METHODS else None,
        confidence=asked.confidence,
        samples=asked.samples,
        seed=asked.seed,
        shape=asked.shape,
    )


def _credible_intervals(test: LifeTest, asked: LifeTestRequest) -> tuple[str, tuple[Credible, ...]]:
    """Status of the posterior, and what it says."""
    if asked.prior is None:
        return "", ()
    found = posterior(test, asked.prior)
    if found.advice is not None:
        return found.code, ()
    credible = []
    for quantity in asked.bounded(with_shape=True):
        lower, upper = found.interval(quantity, asked.confidence)
        unit = test.unit if quantity.kind == "life" else ""
        median = found.quantile(quantity, 0.5)
        credible.append(Credible(quantity.name, unit, median, lower, upper, asked.confidence))
    return found.code, tuple(credible)


def _ratio_to_first(
    tests: Mapping[str, LifeTest], other: str, comparisons: list[Comparison], asked: LifeTestRequest
) -> LifeRatio:
    """Ratio of the first group's life to another's; at a common shape unless the data deny it."""
    first = next(iter(tests))
    common = comparisons[0]
    return life_ratio(
        {first: tests[first], other: tests[other]},
        asked.reliabilities[0],
        common_shape=not (common.converged and common.rejected(asked.confidence)),
        confidence=asked.confidence,
        samples=asked.samples,
        seed=asked.seed,
    )


def bands_of(summary: LifeTestSummary) -> dict[str, Band]:
    """Bounds of the lives over all reliabilities, by the groups that have any, as was asked for."""
    asked = summary.request
    return {
        group.name: confidence_band(
            group.test,
            method=asked.bounds,
            sides=asked.bounds_of(group.test)[0],
            confidence=asked.bounds_of(group.test)[1],
            samples=asked.samples,
            seed=asked.seed,
            shape=asked.shape,
        )
        for group in summary.groups
        if group.bounded
    }


def regions_of(summary: LifeTestSummary, quantity: str = "L10") -> dict[str, LikelihoodRegion]:
    """Regions of equal likelihood of shape and a life, by the groups."""
    asked = summary.request
    return {
        group.name: likelihood_region(group.test, quantity, samples=asked.samples, seed=asked.seed)
        for group in summary.groups
    }
