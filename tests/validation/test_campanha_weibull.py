"""Campanha (2008), chapter 4.1: the lives L10 that are printed, and what the bearings really say.

All three are regressions of ln ln 1/(1 - F) on ln t with exact median ranks:

    246.7 h    the four failures of procedure II alone
    242.3 h    test 5 with them, and tests 2, 3 and 4 suspended, once each
    117.4 h    condition II, in which nothing failed, as if each test had ended with a failure
"""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from scipy.optimize import brentq

from rolamento.verification import Check
from rolamento.verification.campanha_2008 import (
    as_if_failed,
    as_plotted,
    condition,
    five_failures,
    four_failures,
    minimum_life,
    weibull_checks,
)
from rolamento.weibull import (
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
CHECKS = tuple(weibull_checks())
PRINTED = (246.7, 242.3, 117.4)


def rows_of(*numbers: int) -> np.ndarray:
    return np.isin(WHOLE.rig, [str(number) for number in numbers])


def test_what_was_tested() -> None:
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
    assert life.lower < 58.0  # the rating life, which the text calls far too short
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


# --- where the printed lives come from ------------------------------------------


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.printed} {c.quantity}")
def test_verified_numbers(check: Check) -> None:
    """As printed with the choices behind it; with all bearings another number, and proved."""
    assert check.verdict == ("agrees" if check.quantity == "L_10h" else "explained")


def test_printed_lives_at_the_rounding_of_the_print() -> None:
    tests = (four_failures(), five_failures(), as_if_failed())
    assert tuple(round(as_plotted(test).l10, 1) for test in tests) == PRINTED
    assert [(test.size, test.failures) for test in tests] == [(4, 4), (8, 5), (5, 5)]


def test_no_other_selection_gives_the_printed_lives() -> None:
    """Tests 1 to 5 out, once or with both bearings, beside the failures of procedure II.

    246.7 h is of none of them; wherever 242.3 h comes out, test 5 is a failure, test 1 is out, and
    three bearings of tests 2 to 4 are suspended.
    """
    once = {1: (38.2, True), 2: (124.7, False), 3: (118.4, False), 4: (184.4, False),
            5: (627.6, True)}  # fmt: skip
    alone = [(402.2, True), (460.9, True), (430.3, True), (271.3, True)]
    found: dict[float, list[tuple[int, ...]]] = {246.7: [], 242.3: []}
    for bearings in product((0, 1, 2), repeat=5):
        rows = list(alone)
        for (time, failed), count in zip(once.values(), bearings, strict=True):
            rows += [(time, failed)] * min(count, 1) + [(time, False)] * (count - 1)
        life = rank_regression(LifeTest(*zip(*rows, strict=True)), "y_on_x").l10
        if round(life, 1) in found:
            found[round(life, 1)].append(bearings)
    assert found[246.7] == [(0, 0, 0, 0, 0)]
    assert (0, 1, 1, 1, 1) in found[242.3]
    for first, *early, last in found[242.3]:
        assert (first, sum(early), last) == (0, 3, 1)


@pytest.mark.parametrize("choice", ["x_on_y", "benard", "likelihood"])
def test_other_methods_miss_a_printed_life(choice: str) -> None:
    """Benard's approximation gives 246.6, 241.5 and 117.3 h; the others are far off."""
    lives = []
    for test in (four_failures(), five_failures(), as_if_failed()):
        fit = {
            "x_on_y": lambda test=test: rank_regression(test, "x_on_y"),
            "benard": lambda test=test: rank_regression(test, "y_on_x", "benard"),
            "likelihood": lambda test=test: maximum_likelihood(test),
        }[choice]()
        lives.append(round(fit.l10, 1))
    assert all(life != printed for life, printed in zip(lives, PRINTED, strict=True)), lives


def test_how_long_the_suspended_ran_is_lost_on_ranks() -> None:
    """Any three suspensions before 271.3 h give 242.3 h; likelihood knows better."""
    late, early = (
        five_failures(),
        LifeTest(
            [*five_failures().times[five_failures().failed], 1.0, 2.0, 270.0],
            [True] * 5 + [False] * 3,
        ),
    )
    assert as_plotted(late).l10 == pytest.approx(as_plotted(early).l10, rel=1e-12)
    assert maximum_likelihood(late).l10 != pytest.approx(maximum_likelihood(early).l10, rel=0.01)


# --- what all bearings say ------------------------------------------------------


def by_equations(test: LifeTest) -> tuple[float, float]:
    """Shape and scale by McCool's equations for suspended tests, written out."""
    t = test.times
    failed = float(np.log(t[test.failed]).mean())
    shape = float(
        brentq(
            lambda b: float(t**b @ np.log(t)) / float((t**b).sum()) - 1.0 / b - failed, 0.1, 50.0
        )
    )
    return shape, float(((t**shape).sum() / test.failures) ** (1.0 / shape))


@pytest.mark.parametrize(
    ("without", "life"), [((), 165.1), ((5,), 150.5), ((1,), 293.9), ((1, 5), 311.6)]
)
def test_right_lives(without: tuple[int, ...], life: float) -> None:
    test = condition("I", without=without)
    fit = maximum_likelihood(test)
    assert (fit.shape, fit.scale) == pytest.approx(by_equations(test), rel=1e-9)
    assert fit.l10 == pytest.approx(life, abs=0.05)
    assert test.size == 14 - 2 * len(without)


def test_the_printed_line_has_no_room_for_test_1() -> None:
    line = as_plotted(four_failures())
    assert 1.0 - float(line.reliability_at(38.2)) ** 14 == pytest.approx(0.00082, abs=1e-5)
    # that of all bearings has
    whole = maximum_likelihood(FIRST)
    assert 1.0 - float(whole.reliability_at(38.2)) ** 14 == pytest.approx(0.076, abs=1e-3)


def test_the_scale_is_the_life_of_63_per_cent_and_no_mean() -> None:
    for fit in (maximum_likelihood(FIRST), as_plotted(four_failures())):
        assert float(fit.reliability_at(fit.scale)) == pytest.approx(np.exp(-1.0), rel=1e-12)
        assert fit.mean < 0.91 * fit.scale


@pytest.mark.parametrize(
    ("calculated", "contradicted"), [(58.0, False), (41.0, True), (189.0, False), (151.2, False)]
)
def test_calculated_lives_of_condition_one(calculated: float, contradicted: bool) -> None:
    """Only the maker's 41 h is outside of 90 %, and not of 95 %; none is longer than the tests."""
    found = against_calculated_life(FIRST, calculated)
    assert (found.bearings_live == "longer") == contradicted
    assert found.bearings_live != "shorter"
    assert against_calculated_life(FIRST, calculated, confidence=0.95).bearings_live == ""


@pytest.mark.parametrize(
    ("shape", "limit", "contradicted"),
    [(10.0 / 9.0, 61.2, {17.0, 58.0}), (1.5, 78.3, {17.0, 58.0, 69.0}), (2.0, 93.6, {17, 58, 69})],
)
def test_calculated_lives_of_condition_two(
    shape: float, limit: float, contradicted: set[float]
) -> None:
    assert minimum_life(shape) == pytest.approx(limit, abs=0.05)
    found = {
        life
        for life in (17.0, 58.0, 69.0, 117.4)
        if against_calculated_life(SECOND, life, shape=shape).bearings_live
    }
    assert found == contradicted


def test_the_two_procedures_hardly_have_one_distribution() -> None:
    """Taken together as in the text; the four of procedure II lie much closer together."""
    first = published_life_test("campanha_2008", group="procedure").select(WHOLE.group == "I")
    assert 0.05 < compare(first, "homogeneous").p_value < 0.1
    assert compare(first, "same_life").p_value > 0.2
