"""The lives L_10h that Campanha draws from the life tests, and what all of the tests say instead.

All three printed lives are regressions of ln ln 1/(1 - F) on ln t with exact median ranks, of some
of the tests.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

import numpy as np

from rolamento.verification.check import Check
from rolamento.verification.published import published
from rolamento.weibull import (
    LifeTest,
    WeibullFit,
    bounds,
    maximum_likelihood,
    published_life_test,
    rank_regression,
)

__all__ = [
    "CONFIDENCE",
    "SHAPE",
    "as_if_failed",
    "as_plotted",
    "checks",
    "condition",
    "five_failures",
    "four_failures",
    "least_life",
    "once_each",
]

SHAPE: Final = 1.5
"""Of bearing fatigue where a test tells none: that of the factor a_1 in ISO 281:1990."""
CONFIDENCE: Final = 0.95
"""Of the lower bound where nothing failed."""

_SURVIVORS: Final = 0.9
_FAILED_ALONE: Final = (11, 12, 13, 14)
"""The tests of procedure II."""
_WITH_FIVE: Final = (2, 3, 4, 5, *_FAILED_ALONE)
_TESTS_OF_II: Final = (6, 7, 8, 9, 10)
_DEVIATION: Final = 0.4
"""Of the printed life: the most by which the explanations below say that it is too long."""
_FOUR: Final = (
    "The text does not say it: exact median ranks, ln ln 1/(1 - F) regressed on ln t, of the four"
    " failures of procedure II alone."
)
_FIVE: Final = (
    "Printed as the life without test 5, and yet test 5 is in it: the same regression of procedure"
    " II and test 5 as failures, with tests 2 to 4 as suspensions, once each."
)
_AS_IF: Final = (
    "The same regression, had each of the five tests of condition II ended with a failure. Nothing"
    " failed in them."
)
_ALL: Final = (
    "Maximum likelihood of all the bearings that the text names, those that did not fail with the"
    " time that they ran. The proof: the text's likelihood equations, put right and written for"
    " tests that did not all fail. Up to 40 % of the printed life is too much."
)
_LOWEST: Final = (
    "Nothing failed: the ten bearings say no more than that L_10 is not below 78 h, at a confidence"
    " of 95 % and with the shape 1.5. The proof: (Σt^1.5 ln 0.9/ln 0.05)^(1/1.5)."
)


def condition(name: str, *, without: Iterable[int] = ()) -> LifeTest:
    """Return the tests of a condition, "I" or "II", both bearings of each; without some tests."""
    whole = published_life_test("campanha_2008").by_group()[name]
    return whole.select(~np.isin(whole.rig, [str(number) for number in without]))


def once_each(numbers: Iterable[int], *, failed: bool | None = None) -> LifeTest:
    """Return tests as the dissertation counts them: one row each, failed where one bearing did.

    Parameters
    ----------
    numbers
        Of the tests.
    failed
        What to take all of them for, if not as they ended.
    """
    whole = published_life_test("campanha_2008")
    chosen = [str(number) for number in numbers]
    times = [float(whole.times[whole.rig == name].max()) for name in chosen]
    ended = [bool(whole.failed[whole.rig == name].any()) for name in chosen]
    return LifeTest(times, ended if failed is None else failed, rig=chosen, unit=whole.unit)


def four_failures() -> LifeTest:
    """Return the tests behind 246.7 h."""
    return once_each(_FAILED_ALONE)


def five_failures() -> LifeTest:
    """Return the tests behind 242.3 h."""
    return once_each(_WITH_FIVE)


def as_if_failed() -> LifeTest:
    """Return the tests behind 117.4 h."""
    return once_each(_TESTS_OF_II, failed=True)


def as_plotted(test: LifeTest) -> WeibullFit:
    """Fit a line as the dissertation does."""
    return rank_regression(test, "y_on_x")


def checks() -> Iterator[Check]:
    """Compare the three lives: with the choices behind them, and with what all bearings say."""
    lives = published("campanha_2008")["tested_life"]
    for key, chosen, told, whole, right in (
        ("condition_I", four_failures(), _FOUR, condition("I"), _ALL),
        ("without_test_5", five_failures(), _FIVE, condition("I", without=(5,)), _ALL),
        ("condition_II", as_if_failed(), _AS_IF, condition("II"), _LOWEST),
    ):
        printed = lives[key]["printed"]
        yield Check(
            source=lives[key]["source"],
            quantity="L_10h",
            unit="h",
            printed=printed,
            computed=as_plotted(chosen).l10,
            explanation=told,
        )
        yield Check(
            source=lives[key]["source"],
            quantity="L_10h, all",
            unit="h",
            printed=printed,
            computed=maximum_likelihood(whole).l10 if whole.failures else least_life(SHAPE),
            explanation=right,
            evidence=_by_equations(whole) if whole.failures else _lower_bound(whole),
            corrected=lives[key]["corrected"],
            deviation=_DEVIATION * float(printed),
        )


def least_life(shape: float) -> float:
    """Return the lower bound of L_10h in condition II at a shape; h."""
    found = bounds(condition("II"), "L10", shape=shape, sides="lower", confidence=CONFIDENCE)
    return found.lower


def _by_equations(test: LifeTest) -> float:
    """L_10 by McCool's equations, without the engine."""
    from scipy.optimize import brentq

    time, log_time = test.times, np.log(test.times)
    failed = float(log_time[test.failed].mean())

    def profile(shape: float) -> float:
        power = time**shape
        return 1.0 / shape + failed - float(power @ log_time) / float(power.sum())

    shape = brentq(profile, 0.1, 50.0)
    scale = (float((time**shape).sum()) / test.failures) ** (1.0 / shape)
    return float(scale * (-np.log(_SURVIVORS)) ** (1.0 / shape))


def _lower_bound(test: LifeTest) -> float:
    """L_10 that a test without failures leaves possible, without the engine."""
    ratio = np.log(_SURVIVORS) / np.log(1.0 - CONFIDENCE)
    return float((float((test.times**SHAPE).sum()) * ratio) ** (1.0 / SHAPE))
