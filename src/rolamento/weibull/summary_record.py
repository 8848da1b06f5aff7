"""The records of a life test's summary: what is wanted, and what each group and all of them say."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import Any, Final, Literal, get_args

from rolamento.errors import InputError
from rolamento.weibull._checks import one_of
from rolamento.weibull.bounds import Bounds, Method, Sides
from rolamento.weibull.calculated import CalculatedLife
from rolamento.weibull.comparison import Comparison
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_ratio import LifeRatio
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.posterior import ShapePrior
from rolamento.weibull.quantity import Quantity
from rolamento.weibull.ranks import plotting_positions

__all__ = [
    "FIT_METHODS",
    "AssumedShape",
    "Credible",
    "FitMethod",
    "GroupSummary",
    "LifeTestSummary",
    "Wanted",
    "has_ranks",
]

FitMethod = Literal[
    "maximum_likelihood",
    "unbiased",
    "rank_regression_x_on_y",
    "rank_regression_y_on_x",
    "three_parameter",
]
FIT_METHODS: Final = get_args(FitMethod)
MOST_RANKED: Final = 20_000
"""Failures up to which each gets its rank, and is drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
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
        that lives are wanted for; a calculated life is for the first
    times
        that reliabilities are wanted for; unit of the test
    shape
        β from experience: then only the scale comes from the test
    prior
        what was known of the shape, for the posterior; None without
    calculated
        calculated lives by their names; unit of the test
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
    samples: int = 10_000
    seed: int = 0

    def __post_init__(self) -> None:
        """Refuse unknown methods, and no life at all."""
        for method in self.methods:
            one_of(method, "method", FIT_METHODS)
        if not self.reliabilities:
            raise InputError("must be one at least", field="reliability", example="0.9")
        if self.shape is not None and self.bounds not in (None, "fixed_shape"):
            raise InputError("goes with no other bounds", field="shape", value=self.shape)

    @property
    def lives(self) -> tuple[Quantity, ...]:
        """Lives that are wanted."""
        return tuple(Quantity.life(r) for r in self.reliabilities)

    @property
    def shares(self) -> tuple[Quantity, ...]:
        """Reliabilities that are wanted."""
        return tuple(Quantity.reliability(time) for time in self.times)

    def bounded(self, with_shape: bool) -> tuple[Quantity, ...]:
        """Quantities that are bounded; the shape only where it is not given."""
        shape = (Quantity.of("shape"),) if with_shape else ()
        return (*shape, Quantity.of("scale"), *self.lives, *self.shares)


@dataclass(frozen=True, slots=True)
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
        values = {name: getattr(self, name) for name in names}
        return {
            "quantity": self.quantity,
            "unit": self.unit,
            **{name: value if isfinite(value) else None for name, value in values.items()},
            "probability": self.probability,
        }


@dataclass(frozen=True, slots=True)
class AssumedShape:
    """What a test that tells no shape would say, were the shape this."""

    shape: float
    bounds: tuple[Bounds, ...]

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values."""
        return {"shape": self.shape, "bounds": [bound.to_mapping() for bound in self.bounds]}


@dataclass(frozen=True, slots=True, eq=False)
class GroupSummary:
    """What one group says, or a test without groups.

    Attributes
    ----------
    name
        label of the group; empty without
    test
        its part of the data
    fits
        by every method that was wanted and can be; the first is what the bounds are about
    bounds
        on shape, scale, lives and reliabilities
    assumed
        where the test tells no shape: what it would say with shapes that are usual
    calculated
        calculated lives set against it, by their names
    prior_code, credible
        status of the posterior, empty if none was wanted; and what it says
    """

    name: str
    test: LifeTest
    fits: tuple[WeibullFit, ...]
    bounds: tuple[Bounds, ...]
    assumed: tuple[AssumedShape, ...]
    calculated: Mapping[str, CalculatedLife]
    prior_code: str
    credible: tuple[Credible, ...]

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

    def bound(self, quantity: Quantity) -> Bounds | None:
        """Bounds on a quantity."""
        return next((one for one in self.bounds if one.quantity == quantity.name), None)

    def to_mapping(self) -> dict[str, Any]:
        """Give the group as plain values."""
        test = self.test
        points = _points(test) if self.ranked else []
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
        }


@dataclass(frozen=True, slots=True, eq=False)
class LifeTestSummary:
    """What a life test says.

    Attributes
    ----------
    test
        the data, all groups together
    wanted
        what was asked for
    groups
        in the order of the data; one without a name where they are not parted
    comparisons
        whether the groups have shape and life in common
    ratios
        life of the first group over that of each other
    """

    test: LifeTest
    wanted: Wanted
    groups: tuple[GroupSummary, ...]
    comparisons: tuple[Comparison, ...] = ()
    ratios: tuple[LifeRatio, ...] = ()

    @property
    def has_result(self) -> bool:
        """Whether any group says anything in numbers of its own."""
        return any(group.has_result for group in self.groups)

    def to_mapping(self) -> dict[str, Any]:
        """Give the summary as plain values; None where there is no number."""
        test, wanted = self.test, self.wanted
        return {
            "title": test.title,
            "source": test.source,
            "passed_over": list(test.passed_over),
            "unit": test.unit,
            "size": test.size,
            "failures": test.failures,
            "suspensions": test.suspensions,
            "confidence": wanted.confidence,
            "samples": wanted.samples,
            "seed": wanted.seed,
            "groups": [group.to_mapping() for group in self.groups],
            "comparisons": [one.to_mapping() for one in self.comparisons],
            "life_ratios": [one.to_mapping() for one in self.ratios],
        }


def has_ranks(test: LifeTest) -> bool:
    """Whether the failures of a test have ranks: their times are known, and they are not many."""
    return not test.inspected and test.failures <= MOST_RANKED


def _points(test: LifeTest) -> list[dict[str, float]]:
    """Points of the Weibull plot."""
    positions = plotting_positions(test)
    columns = zip(positions.times, positions.rank, positions.failed_share, strict=True)
    return [
        {"time": float(time), "rank": float(rank), "failed_share": float(share)}
        for time, rank, share in columns
    ]
