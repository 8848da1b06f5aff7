"""All that a life test says, group by group: fits, bounds, a calculated life, comparisons."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from rolamento.errors import InputError
from rolamento.weibull.bounds import Sides, all_bounds
from rolamento.weibull.calculated import (
    VERDICT_METHODS,
    CalculatedLife,
    against_calculated_life,
)
from rolamento.weibull.comparison import Comparison, Hypothesis, compare
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.fixed_shape import fixed_shape
from rolamento.weibull.life_ratio import LifeRatio, life_ratio
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import maximum_likelihood
from rolamento.weibull.posterior import posterior
from rolamento.weibull.rank_regression import rank_regression
from rolamento.weibull.summary_record import (
    FIT_METHODS,
    AssumedShape,
    Credible,
    FitMethod,
    GroupSummary,
    LifeTestSummary,
    Wanted,
    has_ranks,
)
from rolamento.weibull.three_parameter import three_parameter
from rolamento.weibull.unbiased import unbiased

__all__ = [
    "FIT_METHODS",
    "AssumedShape",
    "Credible",
    "FitMethod",
    "GroupSummary",
    "LifeTestSummary",
    "Wanted",
    "summarise",
]

ASSUMED_SHAPES: Final = (1.0, 1.5, 2.0)
"""For a test that tells no shape of its own."""
MOST_GROUPS: Final = 20
_MOST_RATIOS: Final = 10
_HYPOTHESES: Final[tuple[Hypothesis, ...]] = ("common_shape", "same_life", "homogeneous")

Progress = Callable[[int, int], None]


def summarise(
    test: LifeTest,
    wanted: Wanted | None = None,
    *,
    by_group: bool = True,
    progress: Progress | None = None,
) -> LifeTestSummary:
    """Find all that a life test says.

    Parameters
    ----------
    test
        With any kind of censoring, with or without groups.
    wanted
        What to find; the default of `Wanted` if not given.
    by_group
        Whether to take each group by itself and to compare them; all together otherwise.
    progress
        Called with steps done and steps in all.

    Raises
    ------
    InputError
        For more than 20 groups to be taken by themselves, or what bounds and fits refuse.
    """
    asked = Wanted() if wanted is None else wanted
    tests = test.by_group() if by_group else {"": test}
    if len(tests) > MOST_GROUPS:
        raise InputError(
            f"must be {MOST_GROUPS} at most to be told by themselves; take another column, or all"
            " together",
            field="groups",
            value=len(tests),
        )
    compared = len(tests) > 1 and not test.inspected
    pairs = list(tests)[1 : _MOST_RATIOS + 1] if compared else []
    steps = len(tests) + (len(_HYPOTHESES) if compared else 0) + len(pairs)
    done = 0

    def step() -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(done, steps)

    groups = []
    for name, part in tests.items():
        groups.append(_group(name, part, asked))
        step()
    comparisons = []
    for hypothesis in _HYPOTHESES if compared else ():
        comparisons.append(compare(tests, hypothesis, samples=asked.samples, seed=asked.seed))
        step()
    ratios = []
    for other in pairs:
        ratios.append(_ratio(tests, other, comparisons, asked))
        step()
    return LifeTestSummary(test, asked, tuple(groups), tuple(comparisons), tuple(ratios))


def _group(name: str, test: LifeTest, asked: Wanted) -> GroupSummary:
    fits = _fits(test, asked)
    # without failures nothing bounds from above: all of the confidence goes to the lower bound
    sides = asked.sides if test.failures or asked.sides != "two" else "lower"
    bounds = all_bounds(
        test,
        asked.bounded(with_shape=asked.shape is None),
        method=asked.bounds,
        confidence=asked.confidence,
        sides=sides,
        samples=asked.samples,
        seed=asked.seed,
        shape=asked.shape,
    )
    alone = not any(bound.converged for bound in bounds)
    code, credible = _credible(test, asked)
    return GroupSummary(
        name,
        test,
        fits,
        bounds,
        _assumed(test, asked, sides) if alone and not credible else (),
        {label: _against(test, life, asked) for label, life in asked.calculated.items()},
        code,
        credible,
    )


def _fits(test: LifeTest, asked: Wanted) -> tuple[WeibullFit, ...]:
    """Fits by every method, the one that the bounds are about first."""
    fits = [] if asked.shape is None else [fixed_shape(test, asked.shape)]
    wanted = dict.fromkeys(asked.methods)
    if asked.shape is None:  # the bounds' own
        wanted = dict.fromkeys(("maximum_likelihood", *wanted))
    for method in wanted:
        if method.startswith("rank_regression") and not has_ranks(test):
            continue
        if method == "maximum_likelihood":
            fits.append(maximum_likelihood(test))
        elif method == "unbiased":
            fits.append(unbiased(test, samples=asked.samples, seed=asked.seed))
        elif method == "three_parameter":
            fits.append(three_parameter(test))
        else:
            fits.append(rank_regression(test, "x_on_y" if "x_on_y" in method else "y_on_x"))
    return tuple(fits)


def _assumed(test: LifeTest, asked: Wanted, sides: Sides) -> tuple[AssumedShape, ...]:
    quantities = (*asked.lives, *asked.shares)
    return tuple(
        AssumedShape(
            shape,
            all_bounds(test, quantities, confidence=asked.confidence, sides=sides, shape=shape),
        )
        for shape in ASSUMED_SHAPES
    )


def _against(test: LifeTest, life: float, asked: Wanted) -> CalculatedLife:
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


def _credible(test: LifeTest, asked: Wanted) -> tuple[str, tuple[Credible, ...]]:
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


def _ratio(
    tests: Mapping[str, LifeTest], other: str, comparisons: list[Comparison], asked: Wanted
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
