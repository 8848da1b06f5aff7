"""Campanha (2008), chapter 4.1: the lives L10 that she prints, and what her bearings really say.

All three are regressions of ln ln 1/(1 - F) on ln t with exact median ranks:

    246.7 h    the four failures of procedure II alone
    242.3 h    test 5 with them, and tests 2, 3 and 4 suspended, once each
    117.4 h    condition II, in which nothing failed, as if each test had ended with a failure
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.reliability import (
    LifeTest,
    against_calculated_life,
    bounds,
    compare,
    maximum_likelihood,
    published_life_test,
    rank_regression,
)

WHOLE = published_life_test("campanha_2008")
BY_PROCEDURE = published_life_test("campanha_2008", group="procedure").by_group()
FIRST, SECOND = WHOLE.by_group().values()


def rows_of(*numbers: int) -> np.ndarray:
    return np.isin(WHOLE.rig, [str(number) for number in numbers])


def test_what_she_tested() -> None:
    assert (FIRST.size, FIRST.failures) == (14, 6)
    assert (SECOND.size, SECOND.failures) == (10, 0)
    assert BY_PROCEDURE["II"].scheme == "complete"
    assert list(WHOLE.times[rows_of(5)]) == [627.6, 627.6]


def test_life_of_condition_one() -> None:
    fit = rank_regression(BY_PROCEDURE["II"], "y_on_x")
    assert fit.l10 == pytest.approx(246.7, abs=0.05)
    assert fit.shape == pytest.approx(4.015, abs=5e-4)
    assert fit.scale == pytest.approx(432.0, abs=0.05)
    # the other regression, or likelihood, say something else
    assert rank_regression(BY_PROCEDURE["II"], "x_on_y").l10 == pytest.approx(258.4, abs=0.1)
    assert maximum_likelihood(BY_PROCEDURE["II"]).l10 == pytest.approx(310.9, abs=0.1)


def test_life_without_test_five() -> None:
    rows = WHOLE.select(rows_of(5, 11, 12, 13, 14) & WHOLE.failed)
    suspended = [124.7, 118.4, 184.4]
    test = LifeTest([*rows.times, *suspended], [True] * 5 + [False] * 3)
    assert rank_regression(test, "y_on_x").l10 == pytest.approx(242.3, abs=0.05)


def test_life_of_condition_two_as_if_failed() -> None:
    times = np.unique(SECOND.times)
    fit = rank_regression(LifeTest(times), "y_on_x")
    assert fit.l10 == pytest.approx(117.4, abs=0.05)


def test_what_the_bearings_say() -> None:
    """All fourteen of condition I: a life known within a factor of six, and less than printed."""
    fit = maximum_likelihood(FIRST)
    life = bounds(FIRST, "L10")
    assert fit.l10 == pytest.approx(165.1, abs=0.1)
    assert life.upper / life.lower > 5.0
    assert life.lower < 58.0  # the rating life, which she calls far too short
    rating = against_calculated_life(FIRST, 58.0)
    assert rating.verdict == "data do not contradict calculation"


def test_what_condition_two_says() -> None:
    """Nothing failed: a lower bound, at a shape from elsewhere, is all there is."""
    assert maximum_likelihood(SECOND).code == "no_failures"
    assert rank_regression(SECOND).code == "no_failures"
    life = bounds(SECOND, "L10", shape=1.5, sides="lower", confidence=0.95)
    total = float(np.sum(SECOND.times**1.5))
    assert life.lower == pytest.approx(
        (total * np.log(0.9) / np.log(0.05)) ** (1.0 / 1.5), rel=1e-9
    )
    assert against_calculated_life(SECOND, 17.0, shape=1.5).bearings_live == "longer"
    # and so the two conditions cannot be told apart
    assert not compare(WHOLE, "same_life").rejected(0.9)
