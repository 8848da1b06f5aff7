"""Life tests from end to end: what one says, what a planned one will show, what grew meanwhile."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self, TypedDict, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from rolamento.errors import InputError, arguments, phrase
from rolamento.numerics.growth import Forecast, Law, forecast
from rolamento.records import frozen
from rolamento.tasks.life_tables import DATA, DATE_ORDER, SHIPPED, LifeTable
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import DECIMAL_MARK, PICTURE, Input, Product, Request
from rolamento.validate import one_of
from rolamento.vibration.reading.units import spelled
from rolamento.weibull import (
    METHODS,
    Demonstration,
    Estimand,
    FitMethod,
    LifeTest,
    LifeTestPlan,
    LifeTestRequest,
    LifeTestSummary,
    Method,
    ShapePrior,
    Sides,
    Trend,
    alternatives,
    bands_of,
    demonstrate,
    plan_for_ratio,
    plan_of,
    plans_for_ratio,
    published_life_test,
    published_text,
    published_trend,
    read_life_test,
    read_trend,
    regions_of,
    summarise,
    wear_of_each,
)
from rolamento.weibull.life_test import BLANK_GROUP, UNKNOWN_MODE
from rolamento.weibull.life_units import life_in, life_with_unit
from rolamento.weibull.trend import published_trend_text
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rolamento.clearance.wear import WearFit, WearLaw
    from rolamento.document import Document

__all__ = [
    "DemonstrationStudy",
    "DemonstrationTest",
    "LifeTestEvaluation",
    "PrecisionStudy",
    "PrecisionTest",
    "TrendEvaluation",
    "TrendLimit",
    "TrendStudy",
    "life_test_study",
]

FITS: Final[Mapping[str, FitMethod]] = {
    "ml": "maximum_likelihood",
    "unbiased": "unbiased",
    "rrx": "rank_regression_x_on_y",
    "rry": "rank_regression_y_on_x",
    "three-parameter": "three_parameter",
}
"""Methods of fitting by their short names."""

RATIOS: Final = (0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0)
"""True life over the one to be shown, for which the chances are given."""
SHAPES: Final = (0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0)
"""Shapes for which the result of the same test is given."""
_OTHER_FAILURES: Final = (0, 1, 2)
"""Failures allowed in the tests that stand beside the one that is planned."""
_LIMIT: Final = re.compile(r"([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d{1,3})?)\s*(.{0,20})")
_PRIOR: Final = re.compile(r"(?:(lognormal|uniform):)?([^:]{1,30})\.\.([^:]{1,30})")
_MOST_CALCULATED: Final = 8
_PLAN: Final = marked("Plan a test")
_SHAPE: Final = Input(
    "Shape", "number", _PLAN, example="1.5", default="1.5", essential=True, metavar="BETA"
)
_RELIABILITY: Final = Input(
    "Reliability", "fraction", _PLAN, example="0.9", default="0.9", essential=True, metavar="R"
)
_CONFIDENCE: Final = Input(
    "Confidence", "fraction", _PLAN, example="0.9", default="0.9", essential=True, metavar="C"
)
_MOST_SIZES: Final = 20
TREND: Final = marked("Alarm and trend")
WEAR_LAWS: Final[Mapping[str, WearLaw]] = {
    "running-in": "running_in",
    "running-in-and-steady": "running_in_and_steady",
    "power": "power",
}
_TRENDS: Final = ("campanha-2008-clearance", "campanha-2008-anderon")
_SAMPLES, _FEWEST_SAMPLES = 10_000, 1000
_MAXIMUM_DRAWN: Final = 5_000_000
"""Bearings in all drawn tests together, if it is left to the program."""


class RequestFields(TypedDict, total=False):
    """Fields of a `LifeTestRequest` that need no conversion."""

    methods: tuple[FitMethod, ...]
    bounds: Method | None
    confidence: float
    sides: Sides
    reliabilities: tuple[float, ...]
    shape: float | None
    prior: ShapePrior | None
    models: bool | None
    seed: int


# --- what a life test says -------------------------------------------------------------------


def life_test_study(
    data: LifeTest | ArrayLike | str | os.PathLike[str],
    *,
    only: Sequence[str] = (),
    only_mode: str | None = None,
    by_group: bool = True,
    by_mode: bool = True,
    times: Sequence[float | str] = (),
    calculated: Mapping[str, float | str] | None = None,
    samples: int | None = None,
    columns: Mapping[str, Any] | None = None,
    progress: Progress | None = None,
    **request: Unpack[RequestFields],
) -> LifeTestSummary:
    """Find all that a life test says: fits, bounds, comparisons of its groups.

    Parameters
    ----------
    data
        A CSV file, "-" for standard input; a `LifeTest`; or times, of bearings that all failed.
    only
        Groups to keep; all if none is named.
    only_mode
        Failure mode to keep: failures by others are suspensions.
    by_group
        Whether to take each group by itself and to compare them; all together otherwise.
    by_mode
        Whether to take each failure mode by itself and to put them together; all alike otherwise.
    times
        Of the reliabilities to be found: in the unit of the data, or as text with another.
    calculated
        Calculated lives by their names, likewise.
    samples
        Tests to draw; by default 10 000, fewer of large tests.
    columns
        Of a file, as of `read_life_test`.
    progress
        Called with steps done and steps in all.
    request
        Methods, bounds and what is known beforehand, as of `rolamento.weibull.LifeTestRequest`.

    Raises
    ------
    FileError, InputError
        If the data are no life test, or something is asked for that does not exist.
    """
    if isinstance(data, str | os.PathLike):
        test = read_life_test(data, **(columns or {}))
    else:
        test = LifeTest.of(data)
    test = only_groups(test, only)
    if only_mode is not None:
        test = of_mode(test, only_mode).noted(*notes_of_mode(test, only_mode))
    asked = LifeTestRequest(
        times=tuple(life_in(time, test.unit, "times") for time in times),
        calculated={
            name: life_in(life, test.unit, "calculated")
            for name, life in (calculated or {}).items()
        },
        samples=_enough_samples(test.size) if samples is None else samples,
        **request,
    )
    return summarise(test, asked, by_group=by_group, by_mode=by_mode, progress=progress)


def only_groups(test: LifeTest, names: Sequence[str]) -> LifeTest:
    if not names:
        return test
    known = list(dict.fromkeys(str(name) for name in test.group))
    names = ["" if name == said(BLANK_GROUP) and "" in known else name for name in names]
    for name in names:
        if name not in known:
            there = ", ".join(label for label in known[:10] if label)
            rule = (
                said("is not a group of the data; the groups are {there}", there=there)
                if there
                else said("is not a group of the data, which have none")
            )
            raise InputError(rule, field="only", value=name)
    return test.select(np.isin(test.group, list(names)))


def of_mode(test: LifeTest, name: str) -> LifeTest:
    """Return a test as one of a single mode, by its name whatever its case.

    Raises
    ------
    InputError
        If no bearing failed by that mode.
    """
    written = name.strip()
    if written == said(UNKNOWN_MODE) and "" in test.modes:
        return test.for_mode("")
    alike = [mode for mode in test.modes if mode.casefold() == written.casefold()]
    return test.for_mode(alike[0] if len(alike) == 1 and written not in test.modes else written)


def notes_of_mode(test: LifeTest, name: str) -> tuple[Note, ...]:
    """Return what is to be known where only one mode of a test counts."""
    others = test.failures - of_mode(test, name).failures
    values = {"mode": name.strip(), "others": others}
    found: tuple[Note, ...] = (Note("one_mode", values),) if others else ()
    if test.unknown_modes:
        unknown = {"count": test.unknown_modes, "failures": test.failures}
        found += (Note("modes_unknown", unknown),)
    return found


def _enough_samples(size: int) -> int:
    """Number of simulated tests: fewer for large tests, which take longer."""
    return max(min(_SAMPLES, _MAXIMUM_DRAWN // size), _FEWEST_SAMPLES)


def fits_named(names: Sequence[str], *, three_parameter: bool = False) -> tuple[FitMethod, ...]:
    """Return methods of fitting by their short names; the usual four where none is named.

    Raises
    ------
    InputError
        If there is no such method.
    """
    for name in names:
        one_of(name, "method", FITS, "ml")
    chosen = [*(names or ("ml", "unbiased", "rrx", "rry"))]
    chosen += ["three-parameter"] if three_parameter else []
    return tuple(dict.fromkeys(FITS[name] for name in chosen))


def bounds_known() -> list[str]:
    """Return the names of the methods of bounds that can be chosen."""
    return [method.replace("_", "-") for method in METHODS if method != "fixed_shape"]


def bounds_named(name: str) -> Method:
    """Return a method of bounds by its name, however its words are joined.

    Raises
    ------
    InputError
        If there is no such method.
    """
    known, word = bounds_known(), name.replace("_", "-")
    one_of(word, "bounds", known)
    return cast("Method", word.replace("-", "_"))


def prior_of(text: str) -> ShapePrior:
    """Return what is known of a shape beforehand: "1..2.5", or "uniform:1..2.5".

    Raises
    ------
    InputError
        If the text is no such range.
    """
    match = _PRIOR.fullmatch(text.strip())
    try:
        low, high = (float(match[2]), float(match[3])) if match else (0.0, 0.0)
    except ValueError:
        match = None
    if match is None:
        raise InputError(
            said("must be LOW..HIGH, the 90 % range of the shape, or uniform:LOW..HIGH"),
            field="prior",
            value=text,
            example="1..2.5",
        )
    try:
        return ShapePrior(low, high, kind="uniform" if match[1] == "uniform" else "lognormal")
    except InputError as error:
        raise error.with_details(source="prior") from None


def lives_named(
    texts: Sequence[str] | Mapping[str, float | str],
) -> Mapping[str, float | str]:
    """Return lives by their names, from "NAME=LIFE"; one without is called by what was written.

    Raises
    ------
    InputError
        If there are too many, or two of one name.
    """
    if len(texts) > _MOST_CALCULATED:
        rule = said("may be given at most {most} times", most=_MOST_CALCULATED)
        raise InputError(rule, field="calculated")
    if isinstance(texts, Mapping):
        return texts
    lives: dict[str, float | str] = {}
    for text in texts:
        name, _, life = text.rpartition("=")
        name = name.strip() or text.strip()
        if name in lives:
            raise InputError(
                said("gives two lives of the same name"), field="calculated", value=text
            )
        lives[name] = life
    return lives


# --- as a request ----------------------------------------------------------------------------

RESULTS: Final = marked("Results")
BOUNDS: Final = marked("Bounds")
FIT: Final = marked("Fit")


def _sides() -> Mapping[str, str]:
    return {
        "two": marked("lower and upper"),
        "lower": marked("lower only"),
        "upper": marked("upper only"),
    }


def _bounds() -> Mapping[str, str]:
    from rolamento.pages.weibull import BOUND_METHODS

    return {name: BOUND_METHODS[name.replace("-", "_")] for name in bounds_known()}


def _fits() -> Mapping[str, str]:
    from rolamento.pages.weibull import FITS as LABELS

    return {name: LABELS[method] for name, method in FITS.items()}


_JOINED: Final = {name.replace("-", "_"): name for name in bounds_known()}


class LifeTestEvaluation(LifeTable):
    """Fit a Weibull distribution to a life test, with bounds.

    What the test shows, and what it does not.

    Parameters
    ----------
    data
        Life test: columns time, status and, if any, group, rig, count and more; - for
        standard input.
    reliabilities
        Reliability to give lives for, 0.9 for L10; by default 0.9 and 0.5.
    times
        Time to give the reliability at, such as '100 h'.
    calculated
        Calculated life to compare with the data, such as 'ISO 281=58 h', for the first
        reliability.
    confidence
        Confidence of the bounds, such as 0.9.
    sides
        Sides of the bounds: two, lower or upper.
    bounds
        Bounds: pivotal, calibrated-likelihood-ratio, likelihood-ratio, fisher,
        bootstrap-bca, …; by default a method that is exact with few failures.
    samples
        Tests to simulate, 100 to a million; 10 000 by default, fewer for large tests.
    seed
        Seed of the random numbers.
    method
        Fitting method: ml, unbiased, rrx, rry, three-parameter; by default the
        first four.
    three_parameter
        Fit a failure-free time as well.
    models
        Fit other distributions beside, with their likelihoods; by default where the data
        contradict Weibull's.
    shape
        Shape from experience: only the scale is fitted (Weibayes).
    prior
        90 % range of the shape: gives a posterior as well.
    by_group
        Each group by itself, and compared; or all together.
    by_mode
        Each failure mode by itself, the others as suspensions, and all of them put
        together; or all failures alike.
    only_mode
        Only this failure mode: failures by others are suspensions.
    only
        Only this group.
    example
        A shipped life test: campanha-2008 or lieblein-zelen-1956.
    contour_of
        Quantity of the contours, over the shape: L10, L1, scale …

    >>> found = LifeTestEvaluation(data=[55.2, 81.0, 104.5], samples=1000).run()
    >>> f"{found.groups[0].main.shape:.2f}"
    '4.64'
    """

    data: Annotated[Any, Input("Life test", "file", metavar="DATA.csv")] = None
    reliabilities: Annotated[
        tuple[float, ...],
        Input(
            "Reliabilities",
            "numbers",
            RESULTS,
            example="0.9; 0.5",
            default="0.9; 0.5",
            essential=True,
            option="--reliability",
            metavar="R",
        ),
    ] = (0.9, 0.5)
    times: Annotated[
        tuple[float | str, ...],
        Input(
            "Times",
            "list",
            RESULTS,
            example="100 h; 500 h",
            essential=True,
            option="--time",
            metavar="TIME",
        ),
    ] = ()
    calculated: Annotated[
        tuple[str, ...],
        Input(
            "Calculated life",
            "list",
            RESULTS,
            example="ISO 281=58 h",
            essential=True,
            option="--calculated-life",
            metavar="[NAME=]LIFE",
        ),
    ] = ()
    confidence: Annotated[
        float,
        Input(
            "Confidence of bounds",
            "fraction",
            BOUNDS,
            example="0.9",
            default="0.9",
            essential=True,
            metavar="C",
        ),
    ] = 0.9
    sides: Annotated[
        str,
        Input(
            "Sides of the bounds", "choice", BOUNDS, choices=_sides, default="two", example="lower"
        ),
    ] = "two"
    bounds: Annotated[
        str | None,
        Input(
            "Method of the bounds",
            "choice",
            BOUNDS,
            choices=_bounds,
            aliases=_JOINED,
            on_page=marked("Left empty, a method that is exact with few failures."),
            metavar="METHOD",
            example="pivotal",
        ),
    ] = None
    samples: Annotated[
        int | None, Input("Tests to simulate", "count", BOUNDS, example="10000", at_computer=True)
    ] = None
    seed: Annotated[
        int, Input("Seed", "count", BOUNDS, example="0", default="0", at_computer=True)
    ] = 0
    method: Annotated[
        tuple[str, ...],
        Input(
            "Methods of fitting",
            "choices",
            FIT,
            choices=_fits,
            on_page=marked("By default the first four; the bounds refer to the first one chosen."),
            metavar="METHOD",
        ),
    ] = ()
    three_parameter: Annotated[
        bool, Input("Failure-free time", "switch", FIT, at_computer=True)
    ] = False
    models: Annotated[
        bool | None,
        Input("Other distributions beside", "switch", FIT, option="--models/--no-models"),
    ] = None
    shape: Annotated[
        float | None, Input("Shape from experience", "number", FIT, example="1.5", metavar="BETA")
    ] = None
    prior: Annotated[
        str | None,
        Input(
            "Range of the shape", group=FIT, example="1..2.5", option="--bayes", metavar="LOW..HIGH"
        ),
    ] = None
    by_group: Annotated[
        bool,
        Input(
            "Compare the groups",
            "switch",
            DATA,
            default="true",
            essential=True,
            option="--by-group/--pooled",
        ),
    ] = True
    by_mode: Annotated[
        bool,
        Input(
            "Separate the failure modes",
            "switch",
            DATA,
            default="true",
            essential=True,
            option="--by-mode/--modes-pooled",
        ),
    ] = True
    only_mode: Annotated[
        str | None,
        Input(
            "Only this failure mode", group=DATA, example="fatigue", option="--mode", metavar="MODE"
        ),
    ] = None
    only: Annotated[
        tuple[str, ...], Input("Only these groups", "list", DATA, example="I; II", metavar="GROUP")
    ] = ()
    example: Annotated[
        str | None,
        Input(
            "Example", "shipped", DATA, choices=lambda: dict.fromkeys(SHIPPED, ""), metavar="NAME"
        ),
    ] = None
    contour_of: Annotated[
        str,
        Input(
            "Quantity of the contours",
            group=RESULTS,
            example="L10",
            default="L10",
            metavar="LIFE",
            at_computer=True,
        ),
    ] = "L10"

    json_meaning: ClassVar = "Write everything as JSON, in the unit of the data"
    examples: ClassVar = (
        "Examples: weibull tests.csv --plot paper.png; weibull tests.csv --shape 1.5; weibull "
        "--example campanha-2008 --calculated-life 'ISO 281=58 h'."
    )
    waiting: ClassVar = marked("Simulating tests and fitting them …")
    headings: ClassVar = (DATA, FIT, BOUNDS, RESULTS)
    ships: ClassVar = True

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        if self.bounds is not None and self.shape is not None:
            rule = phrase(
                marked("cannot be combined with {shape}, which has its own bounds"),
                shape=arguments(shape=...),
            )
            raise InputError(rule, field="bounds", value=self.bounds)
        return self

    def run(self, progress: Progress = quietly) -> LifeTestSummary:
        """Evaluate the test.

        Raises
        ------
        FileError, InputError
            If the data are no life test, or something is asked for that does not exist.
        """
        columns = self.reading
        data = self.data
        if self.example is not None:
            data = published_life_test(self.example.replace("-", "_"), **columns)
        return life_test_study(
            data,
            only=self.only,
            only_mode=self.only_mode,
            by_group=self.by_group,
            by_mode=self.by_mode,
            times=self.times,
            calculated=lives_named(self.calculated),
            samples=self.samples,
            columns=columns,
            progress=progress,
            methods=fits_named(self.method, three_parameter=self.three_parameter),
            bounds=None if self.bounds is None else bounds_named(self.bounds),
            confidence=self.confidence,
            sides=cast("Sides", self.sides),
            reliabilities=tuple(self.reliabilities),
            shape=self.shape,
            prior=None if self.prior is None else prior_of(self.prior),
            models=self.models,
            seed=self.seed,
        )

    @classmethod
    def shipped_text(cls, name: str) -> str:
        """Return a shipped life test as CSV."""
        return published_text(name.replace("-", "_"))

    def page(self, found: LifeTestSummary) -> Document:
        """Return what people read of it."""
        from rolamento.pages.weibull import weibull_page

        return weibull_page(found)

    def complaint(self, found: LifeTestSummary) -> str:
        """Return why there is no result; "" if there is one."""
        return "" if found.has_result else str(found.groups[0].main.advice)

    def paper(self, found: LifeTestSummary) -> Figure:
        """Draw probability paper."""
        from rolamento.plots.weibull import weibull_figure

        return weibull_figure(found, bands_of(found))

    def contours(self, found: LifeTestSummary) -> Figure:
        """Draw the likelihood contours of a life over the shape."""
        from rolamento.plots.weibull import contour_figure

        try:
            regions = regions_of(found, self.contour_of)
        except InputError as error:
            field = "contour_of" if error.field == "quantity" else error.field
            raise error.with_details(field=field) from None
        return contour_figure(found, regions)

    products: ClassVar = {
        "plot": Product(marked("Draw probability paper: a .png, .svg or .pdf file."), paper),
        "contour": Product(marked("Draw the likelihood contours, likewise."), contours),
    }


# --- planned tests ---------------------------------------------------------------------------


@frozen
class DemonstrationStudy:
    """A test that is to show a life, and what stands beside it; times in one unit.

    Attributes
    ----------
    plan
        the test
    alternatives
        that show as much with other numbers of bearings and failures
    beside
        with as many bearings and other numbers of failures; none without a plan
    unit
        of the life and all times
    chances
        true life over the one to be shown, chance of passing, mean time until the end
    confidences
        shape, and the confidence that the same test gives at it
    """

    plan: Demonstration
    alternatives: tuple[Demonstration, ...]
    beside: tuple[Demonstration, ...]
    unit: str
    chances: tuple[tuple[float, float, float], ...]
    confidences: tuple[tuple[float, float], ...]

    @property
    def complaint(self) -> str:
        """Why there is no plan; "" if there is one."""
        return "" if self.plan.planned else str(self.plan.advice)

    def page(self) -> Document:
        """Return what people read of the plan."""
        from rolamento.pages.weibull_plan import demonstration_page

        return demonstration_page(self)

    def picture(self) -> Figure:
        """Draw the probability of passing the test over the true life."""
        from rolamento.plots.weibull_plan import chance_figure

        return chance_figure([self.plan, *self.beside], self.unit)

    def to_mapping(self) -> dict[str, Any]:
        """Give the plan as plain values; times in the unit that it names."""
        return {
            "schema": 2,
            "kind": "weibull_plan_demonstration",
            "unit": self.unit,
            **self.plan.to_mapping(),
            "chance_of_passing": [
                {"life_ratio": ratio, "chance": chance, "expected_time": time}
                for ratio, chance, time in self.chances
            ],
            "confidence_at_shape": [
                {"shape": shape, "confidence": confidence} for shape, confidence in self.confidences
            ],
            "alternatives": [other.to_mapping() for other in self.alternatives],
        }


class DemonstrationTest(Request):
    """Plan to demonstrate a life with few failures or none.

    Number of bearings against test time.

    Parameters
    ----------
    life
        Life to demonstrate, such as '1000 h'.
    bearings
        Available bearings: the test time is calculated.
    time
        Test time of each bearing: their number is calculated.
    failures_allowed
        Number of failures with which the test still passes.
    shape
        Expected shape of the Weibull distribution.
    reliability
        Reliability of the life: 0.9 for L10.
    confidence
        Confidence level, such as 0.9.

    >>> found = DemonstrationTest(life="1000 h", bearings=10).run()
    >>> f"{found.plan.time:.0f} {found.unit}"
    '1684 h'
    """

    life: Annotated[
        float | str, Input("Life to demonstrate", group=_PLAN, example="1000 h", essential=True)
    ]
    bearings: Annotated[
        int | None, Input("Bearings", "count", _PLAN, example="10", essential=True)
    ] = None
    time: Annotated[
        float | str | None, Input("Test time", group=_PLAN, example="500 h", essential=True)
    ] = None
    failures_allowed: Annotated[
        int,
        Input(
            "Failures allowed",
            "count",
            _PLAN,
            example="0",
            default="0",
            essential=True,
            metavar="K",
        ),
    ] = 0
    shape: Annotated[float, _SHAPE] = 1.5
    reliability: Annotated[float, _RELIABILITY] = 0.9
    confidence: Annotated[float, _CONFIDENCE] = 0.9

    json_meaning: ClassVar = "Write everything as JSON, in the unit of the life"
    examples: ClassVar = (
        "Examples: weibull-plan demonstration --life '1000 h' --bearings 10; weibull-plan "
        "demonstration --life '1000 h' --time '500 h' --failures-allowed 1."
    )

    def run(self, progress: Progress = quietly) -> DemonstrationStudy:
        """Plan the test.

        Raises
        ------
        InputError
            For a number or a unit that cannot be.
        """
        life, unit = _life_and_unit(self.life)
        each = None if self.time is None else life_in(self.time, unit, "time")
        plan = demonstrate(
            life,
            shape=self.shape,
            bearings=self.bearings,
            time=life if self.bearings is None and each is None else each,
            reliability=self.reliability,
            confidence=self.confidence,
            failures_allowed=self.failures_allowed,
        )
        others = [k for k in _OTHER_FAILURES if k != self.failures_allowed]
        chances, confidences = plan.chance_of_passing(RATIOS), plan.confidence_at(SHAPES)
        return DemonstrationStudy(
            plan,
            alternatives(plan),
            alternatives(plan, [plan.bearings], others) if plan.planned else (),
            unit,
            tuple(
                (ratio, chance, plan.expected_time(ratio))
                for ratio, chance in zip(RATIOS, chances.tolist(), strict=True)
            ),
            tuple(zip(SHAPES, confidences.tolist(), strict=True)),
        )

    products: ClassVar = {"plot": Product(PICTURE, lambda asked, found: found.picture())}


@frozen
class PrecisionStudy:
    """Tests that know a life within bounds.

    Attributes
    ----------
    plans
        all of one life, shape and confidence
    ratio
        of the bounds that is required; None where the tests were given
    unit
        of the life and all times; empty where times are multiples of the life
    """

    plans: tuple[LifeTestPlan, ...]
    ratio: float | None
    unit: str

    @property
    def time_label(self) -> str:
        """Unit of the times, or the life that they are multiples of."""
        return self.unit or Estimand.life(self.plans[0].reliability).name

    @property
    def planned(self) -> bool:
        """Whether there is any plan."""
        return any(plan.planned for plan in self.plans)

    @property
    def complaint(self) -> str:
        """Why there is no plan; "" if there is one."""
        return "" if self.planned else str(self.plans[0].advice)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.weibull_plan import precision_page

        return precision_page(self)

    def picture(self) -> Figure:
        """Draw what a narrower estimate costs."""
        from rolamento.plots.weibull_plan import cost_figure

        return cost_figure(self.plans, self.time_label)

    def to_mapping(self) -> dict[str, Any]:
        """Give the plans as plain values; times in the unit that they name."""
        return {
            "schema": 3,
            "kind": "weibull_plan_precision",
            "unit": self.unit,
            "required_ratio": self.ratio,
            "plans": [plan.to_mapping() for plan in self.plans],
        }


class PrecisionTest(Request):
    """Plan the precision of an estimated life.

    How many failures narrow the bounds, and how long that takes.

    Parameters
    ----------
    ratio
        Required ratio of upper to lower bound, such as 5.
    failures
        Failures of a given test, instead: which precision it gives.
    groups
        Bearings of that test, or rigs with several each.
    group_sizes
        Bearings per rig of a sudden-death test.
    life
        Expected life, such as '1000 h'; without it times are multiples of it.
    shape
        Expected shape of the Weibull distribution.
    reliability
        Reliability of the life: 0.9 for L10.
    confidence
        Confidence level, such as 0.9.
    samples
        Tests to simulate, 100 to a million.
    seed
        Seed of the random numbers.
    """

    ratio: Annotated[float | None, Input("Ratio of the bounds", "number", _PLAN, example="5")] = (
        None
    )
    failures: Annotated[int | None, Input("Failures", "count", _PLAN, example="6", metavar="R")] = (
        None
    )
    groups: Annotated[int | None, Input("Rigs", "count", _PLAN, example="8", metavar="G")] = None
    group_sizes: Annotated[
        tuple[int, ...],
        Input(
            "Bearings per rig", "numbers", _PLAN, example="4", option="--group-size", metavar="M"
        ),
    ] = ()
    life: Annotated[float | str | None, Input("Expected life", group=_PLAN, example="1000 h")] = (
        None
    )
    shape: Annotated[float, _SHAPE] = 1.5
    reliability: Annotated[float, _RELIABILITY] = 0.9
    confidence: Annotated[float, _CONFIDENCE] = 0.9
    samples: Annotated[
        int, Input("Tests to simulate", "count", _PLAN, example="1000", default="10000")
    ] = 10_000
    seed: Annotated[int, Input("Seed", "count", _PLAN, example="1", default="0")] = 0

    json_meaning: ClassVar = "Write everything as JSON, in the unit of the life"
    examples: ClassVar = (
        "Examples: weibull-plan precision --ratio 5 --life '1000 h'; weibull-plan precision"
        " --failures 6 --groups 6 --group-size 4."
    )
    waiting: ClassVar = marked("Simulating tests …")

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        if (self.ratio is None) == (self.failures is None):
            either = marked("give {ratio} or {failures}")
            rule: str = phrase(either, ratio=arguments(ratio=...), failures=arguments(failures=...))
            raise InputError(rule, field="ratio")
        if self.ratio is not None and self.groups is not None and len(self.group_sizes) > 1:
            rule = said("goes with a single group size")
            raise InputError(rule, field="groups", value=self.groups)
        if len(self.group_sizes) > _MOST_SIZES:
            rule = said("may be given at most {most} times", most=_MOST_SIZES)
            raise InputError(rule, field="group_sizes")
        return self

    def run(self, progress: Progress = quietly) -> PrecisionStudy:
        """Plan the test.

        Raises
        ------
        InputError
            For a number that cannot be.
        """
        life, unit = (1.0, "") if self.life is None else _life_and_unit(self.life)
        sizes = [int(size) if size == int(size) else size for size in self.group_sizes]
        keywords: dict[str, Any] = {
            "shape": self.shape, "life": life, "reliability": self.reliability,
            "confidence": self.confidence, "samples": self.samples, "seed": self.seed,
        }  # fmt: skip
        if self.failures is not None:
            plans = tuple(
                plan_of(self.failures, self.groups, size, **keywords) for size in sizes or [1]
            )
            return PrecisionStudy(plans, self.ratio, unit)
        assert self.ratio is not None
        if self.groups is not None:
            size = sizes[0] if sizes else 1
            plan = plan_for_ratio(self.ratio, groups=self.groups, group_size=size, **keywords)
            return PrecisionStudy((plan,), self.ratio, unit)
        if sizes:
            keywords["group_sizes"] = [size for size in sizes if size != 1]
        plans = plans_for_ratio(self.ratio, progress=progress, **keywords)
        return PrecisionStudy(plans, self.ratio, unit)

    products: ClassVar = {"plot": Product(PICTURE, lambda asked, found: found.picture())}


def _life_and_unit(life: float | str) -> tuple[float, str]:
    return life_with_unit(life, "life") if isinstance(life, str) else (life, "")


# --- what grew while bearings ran ------------------------------------------------------------


@frozen
class TrendLimit:
    """When a quantity of a bearing reaches a limit; in the units of the trend.

    Attributes
    ----------
    bearing
        its name; "" of the only one
    quantity
        place of the column
    forecast
        by both laws of growth
    """

    bearing: str
    quantity: int
    forecast: Forecast


@frozen(eq=False)
class TrendStudy:
    """What was measured while bearings ran, and what follows from it.

    Attributes
    ----------
    trend
        the record
    fits
        laws of wear, by the bearings
    limits
        when limits are reached, those that were asked for
    """

    trend: Trend
    fits: Mapping[str, WearFit]
    limits: tuple[TrendLimit, ...] = ()

    @property
    def complaint(self) -> str:
        """Nothing: what was measured is shown in any case."""
        return ""

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.trend import trend_page

        return trend_page(self)

    def picture(self) -> Figure:
        """Draw what was measured, with the laws."""
        from rolamento.pages.trend import trend_picture

        return trend_picture(self)

    def to_mapping(self) -> dict[str, Any]:
        """Give the record as plain values; the fits in SI units."""
        return {
            "schema": 2,
            "kind": "trend",
            **self.trend.to_mapping(),
            "wear": {name: asdict(fit) for name, fit in self.fits.items()},
            "limits": [
                {
                    "bearing": one.bearing,
                    "quantity": self.trend.quantities[one.quantity],
                    **one.forecast.to_mapping(),
                }
                for one in self.limits
            ],
        }


def _wear_laws() -> Mapping[str, str]:
    return dict.fromkeys(WEAR_LAWS, "")


def _growth_laws() -> Mapping[str, str]:
    return {"linear": marked("linear"), "exponential": marked("exponential")}


class TrendEvaluation(Request):
    """Show what changed in operation, and when it reaches a limit.

    Clearance, with a wear law; noise, vibration and other quantities.

    Parameters
    ----------
    data
        Columns of time or date, bearing and quantities, units in brackets; - for standard input.
    example
        Shipped: campanha-2008-clearance or campanha-2008-anderon.
    law
        Law of wear, fitted to the clearance: running-in, running-in-and-steady, power; running-in
        by default where the first quantity is a length.
    limits
        Limit of a quantity, such as '4.5 mm/s': when it is reached.
    growth
        Law of growth: linear or exponential; by default the likelier one.
    confidence
        Confidence of the time to the limit, such as 0.9.
    time
        Column of the times, if named otherwise.
    bearing
        Column of the bearings, if named otherwise.
    values
        Column of a quantity; by default all with a unit in brackets.
    decimal_mark
        Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.
    date_order
        Order of dates, day_first or month_first, for a table in which 03/04/2024 may be either.

    >>> found = TrendEvaluation(example="campanha-2008-clearance").run()
    >>> sorted(found.fits)
    ['10', '9']
    """

    data: Annotated[Any, Input("Measurements", "file", metavar="DATA.csv")] = None
    example: Annotated[
        str | None,
        Input(
            "Example", "shipped", DATA, choices=lambda: dict.fromkeys(_TRENDS, ""), metavar="NAME"
        ),
    ] = None
    law: Annotated[
        str | None,
        Input(
            "Law of wear", "choice", TREND, example="running-in", choices=_wear_laws,
            aliases={name.replace("-", "_"): name for name in WEAR_LAWS}, metavar="LAW",
        ),
    ] = None  # fmt: skip
    limits: Annotated[
        tuple[float | str, ...],
        Input(
            "Limits", "list", TREND, example="4.5 mm/s", option="--limit",
            metavar="[COLUMN=]VALUE",
        ),
    ] = ()  # fmt: skip
    growth: Annotated[
        str | None,
        Input(
            "Law of growth", "choice", TREND, example="linear", choices=_growth_laws, metavar="LAW"
        ),
    ] = None
    confidence: Annotated[
        float, Input("Confidence", "fraction", TREND, example="0.9", default="0.9", metavar="C")
    ] = 0.9
    time: Annotated[
        str | None,
        Input(
            "Column of the times", group=DATA, example="hours", option="--time-column",
            metavar="COLUMN",
        ),
    ] = None  # fmt: skip
    bearing: Annotated[
        str | None,
        Input(
            "Column of the bearings", group=DATA, example="bearing", option="--bearing-column",
            metavar="COLUMN",
        ),
    ] = None  # fmt: skip
    values: Annotated[
        tuple[str, ...],
        Input(
            "Columns of quantities", "list", DATA, example="noise", option="--value-column",
            metavar="COLUMN",
        ),
    ] = ()  # fmt: skip
    decimal_mark: Annotated[str | None, DECIMAL_MARK.below(DATA)] = None
    date_order: Annotated[str | None, DATE_ORDER] = None

    json_meaning: ClassVar = "Write everything as JSON"
    examples: ClassVar = "Example: trend --example campanha-2008-clearance --plot clearance.png."
    waiting: ClassVar = marked("Fitting …")
    headings: ClassVar = (DATA, TREND)
    columns: ClassVar = frozenset({"time", "bearing", "values"})
    ships: ClassVar = True

    @model_validator(mode="after")
    def _is_in_range(self) -> Self:
        if not 0.0 < self.confidence < 1.0:
            rule = said("must be between 0 and 1, exclusive")
            raise InputError(rule, field="confidence", value=self.confidence)
        return self

    @classmethod
    def shipped_text(cls, name: str) -> str:
        """Return a shipped record as CSV."""
        return published_trend_text(name.replace("-", "_"))

    def run(self, progress: Progress = quietly) -> TrendStudy:
        """Read the record, and fit what is asked for.

        Raises
        ------
        FileError, InputError
            If the data are no such record, the law that was asked for cannot be fitted, or a limit
            is none.
        """
        trend = self._record()
        law = None if self.law is None else WEAR_LAWS[self.law]
        try:
            fits = wear_of_each(trend, law or "running_in")
        except InputError:
            if law is not None:
                raise
            fits = {}
        growth = cast("Law | None", self.growth)
        found = []
        for given in self.limits:
            place, limit = _limit_of(trend, given)
            for name in trend.names:
                times, values = trend.of_bearing(name, place)
                if len(times):
                    when = forecast(times, values, limit, confidence=self.confidence, law=growth)
                    found.append(TrendLimit(name if len(trend.names) > 1 else "", place, when))
        return TrendStudy(trend, fits, tuple(found))

    def _record(self) -> Trend:
        if self.example is not None:
            return published_trend(self.example.replace("-", "_"))
        if isinstance(self.data, Trend):
            return self.data
        names = ("time", "bearing", "values", "decimal_mark", "date_order")
        return read_trend(self.data, **{name: getattr(self, name) for name in names})

    products: ClassVar = {"plot": Product(PICTURE, lambda asked, found: found.picture())}


def _limit_of(trend: Trend, given: float | str) -> tuple[int, float]:
    """Place of the quantity that a limit is of, and the limit in its unit."""
    name, equals, text = str(given).rpartition("=")
    known = [quantity.casefold() for quantity in trend.quantities]
    example = f"{trend.quantities[0]} = 4.5 {trend.units[0]}".strip()
    rule, place = "", 0
    if equals and name.strip().casefold() in known:
        place = known.index(name.strip().casefold())
    elif equals or len(known) > 1:
        rule = said(
            "must name its quantity; the table has {known}", known=", ".join(trend.quantities)
        )
    unit = trend.units[place]
    match = _LIMIT.fullmatch(text.strip())
    value = float(match[1].replace(",", ".")) if match else float("nan")
    if not rule and not (match and 0.0 < value < float("inf")):
        rule = said("must be a positive number")
    if not rule and match and match[2] and spelled(match[2]) != spelled(unit):
        rule = said("must be in the unit of the data, {unit}", unit=unit)
    if rule:
        raise InputError(rule, field="limits", value=given, example=example)
    return place, value
