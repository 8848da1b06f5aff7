"""The lives that the dissertation draws from its tests, and what all of the bearings say instead.

Limits are two-sided at 90 % where no other confidence is stated. On the probability paper of
figures 4.1.1 and 4.1.2 log₁₀ t stands across, ln ln 1/(1 − F) upright, so that lives of Weibull's
distribution lie on a straight line; failures stand at their median ranks, suspended bearings at the
foot.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Final

import numpy as np

from rolamento.verification.campanha_2008 import (
    SHAPE,
    as_if_failed,
    as_plotted,
    condition,
    five_failures,
    four_failures,
    minimum_life,
)
from rolamento.weibull import (
    Bounds,
    LifeTest,
    WeibullFit,
    all_bounds,
    confidence_band,
    maximum_likelihood,
    plotting_positions,
)
from rolamento_reproductions.campanha_2008.inputs import GIVEN, Number, printed, said
from rolamento_reproductions.record import Cell, Claim, Curves, Figure, Floats, Line, Panel, Series
from rolamento_reproductions.text import Text, fixed, same

_FIVE: Final = 5


@dataclass(frozen=True, slots=True, eq=False)
class Tested:
    """A test with its fit by maximum likelihood, and the limits of shape and L_10h."""

    test: LifeTest
    fit: WeibullFit
    shape: Bounds
    life: Bounds

    @classmethod
    def of(cls, test: LifeTest) -> Tested:
        """Fit a test, and bound it."""
        return cls(test, maximum_likelihood(test), *all_bounds(test, ("shape", "L10")))


@cache
def life_by_all() -> Tested:
    """Return what all bearings of condition I say."""
    return Tested.of(condition("I"))


@cache
def without_test(number: int) -> Tested:
    """Return what the bearings of condition I say without those of a test."""
    return Tested.of(condition("I", without=(number,)))


@cache
def six_failures() -> LifeTest:
    """Return the failed bearings of condition I, as if there were no others."""
    whole = condition("I")
    return whole.select(whole.failed)


def shapes_of_fatigue() -> dict[str, float]:
    """Return shapes of bearing fatigue, as they are written."""
    return {name: float(Fraction(name)) for name in GIVEN.inputs_of("weibull")["shapes"]}


def interval(bound: Bounds, digits: int = 0) -> Text:
    """Say an estimate with its limits."""
    return said(
        "interval",
        estimate=fixed(bound.estimate, digits),
        lower=fixed(bound.lower, digits),
        upper=fixed(bound.upper, digits),
    )


# --- the printed lives ------------------------------------------------------


@cache
def lives_of_tests() -> tuple[Number, ...]:
    """Return the lives that the dissertation draws from the tests."""
    return (_of_condition_one(), _without_five(), _of_condition_two())


def _printed(key: str) -> str:
    return str(printed("tested_life")[key]["printed"])


def _of_condition_one() -> Number:
    line, whole = as_plotted(four_failures()), life_by_all()
    return Number(
        "life_I",
        said("of_condition_one.life_i.quantity"),
        _printed("condition_I"),
        line.l10,
        interval(whole.life),
        said(
            "of_condition_one.life_i.reason",
            shape=line.shape,
            scale=line.scale,
            suspensions=whole.test.suspensions,
            size=whole.test.size,
        ),
    )


def _without_five() -> Number:
    chosen, whole = five_failures(), without_test(_FIVE)
    return Number(
        "life_without_5",
        said("without_five.life_without_5.quantity"),
        _printed("without_test_5"),
        as_plotted(chosen).l10,
        interval(whole.life),
        said(
            "without_five.life_without_5.reason",
            failures=chosen.failures,
            suspensions=chosen.suspensions,
            size=whole.test.size,
        ),
    )


def _of_condition_two() -> Number:
    chosen, hot = as_if_failed(), condition("II")
    return Number(
        "life_II",
        said("of_condition_two.life_ii.quantity"),
        _printed("condition_II"),
        as_plotted(chosen).l10,
        said("of_condition_two.life_ii.right", minimum_life=minimum_life(SHAPE)),
        said(
            "of_condition_two.life_ii.reason", chosen_count=len(chosen), size=hot.size, shape=SHAPE
        ),
    )


_TEN_PERCENT: Final = 0.1
_HOURS: Final = (10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0)
_PERCENT: Final = (1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 63.2, 80.0, 90.0, 99.0)
_ORDINATE: Final = "ln ln 1/(1 − F)"


def figure_of_condition_one() -> Figure:
    """Draw the line of 246.7 h, and that of all bearings of condition I."""
    printed, _, _ = lives_of_tests()
    return _paper(
        "4.1.1",
        said("figure_4_1_1.caption", size=condition("I").size),
        printed.printed,
        four_failures(),
        life_by_all(),
        (_of_all_failures(),),
        (_left_out(),),
    )


def figure_without_test_5() -> Figure:
    """Draw the line of 242.3 h, and that of all bearings but those of test 5."""
    _, printed, _ = lives_of_tests()
    whole = without_test(5)
    return _paper(
        "4.1.2",
        said("figure_4_1_2.caption", size=whole.test.size),
        printed.printed,
        five_failures(),
        whole,
        (_swapped(),),
        (_any_three(),),
    )


# --- the paper --------------------------------------------------------------


def _paper(
    number: str,
    caption: Text,
    printed: str,
    chosen: LifeTest,
    whole: Tested,
    claims: tuple[Claim, ...],
    notes: tuple[Text, ...],
) -> Figure:
    given = GIVEN.inputs_of("weibull")
    lowest, highest = given["lowest_h"], given["highest_h"]
    every = np.concatenate([chosen.times, whole.test.times])
    time = np.unique(np.concatenate([np.geomspace(lowest, highest, given["points"]), every]))
    short, long = _limits(whole.test, time)
    line = as_plotted(chosen)
    upright: dict[str, Floats] = {
        "as_printed": _fitted_line(line, time),
        "failed_as_printed": _failures(chosen, time),
        "all_bearings": _fitted_line(whole.fit, time),
        "failed": _failures(whole.test, time),
        "least_life": short,
        "most_life": long,
        "not_failed": _suspended(whole.test, time),
        "ten_percent": np.full(time.size, _ordinate(_TEN_PERCENT)),
    }
    title = same(_ORDINATE)
    columns = (
        Series("time", "h", said("paper.time"), time),
        Series("log_time", "", said("paper.log_time"), np.log10(time)),
        *(Series(name, "", title, _within(values)) for name, values in upright.items()),
    )
    return Figure(
        number=number,
        caption=caption,
        source=GIVEN.source_of("weibull"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "log_time",
                    said("paper.y_title"),
                    "%",
                    _paper_lines(printed, line, whole),
                    from_zero=False,
                    legend_columns=2,
                    x_ticks=tuple((float(np.log10(t)), f"{t:.0f}") for t in _HOURS),
                    y_ticks=tuple((float(_ordinate(p / 100.0)), f"{p:.3g}") for p in _PERCENT),
                ),
            )
        ),
        claims=claims,
        notes=notes,
    )


def _paper_lines(printed: str, line: WeibullFit, whole: Tested) -> tuple[Line, ...]:
    return (
        Line(
            "as_printed",
            1,
            said("paper_lines.as_printed_l", life=same("{:.1f}", float(printed)), shape=line.shape),
        ),
        Line("failed_as_printed", 1, points=True),
        Line(
            "all_bearings",
            0,
            said(
                "paper_lines.bearings_l_10h",
                size=whole.test.size,
                estimate=whole.life.estimate,
                shape=whole.fit.shape,
            ),
        ),
        Line("failed", 0, points=True),
        Line("least_life", 5, said("paper_lines.their_limits_90")),
        Line("most_life", 5),
        Line("not_failed", 3, said("paper_lines.still_running_when"), points=True),
        Line("ten_percent", 6, said("paper_lines.10_failed")),
    )


def _ordinate(failed_share: Any) -> Any:
    return np.log(-np.log1p(-np.asarray(failed_share, dtype=np.float64)))


def _ends() -> tuple[float, float]:
    """The ordinates between which the paper lies."""
    given = GIVEN.inputs_of("weibull")
    return float(_ordinate(given["least_failed"])), float(_ordinate(given["most_failed"]))


def _within(upright: Floats) -> Floats:
    """Leave out what lies beyond the paper."""
    low, high = _ends()
    return np.where((upright >= low) & (upright <= high), upright, np.nan)


def _fitted_line(fit: WeibullFit, time: Floats) -> Floats:
    return np.asarray(fit.shape * np.log(time / fit.scale))


def _failures(test: LifeTest, time: Floats) -> Floats:
    """Median ranks of the failures, at their times."""
    points = plotting_positions(test)
    found = np.full(time.size, np.nan)
    found[np.searchsorted(time, points.times)] = points.y
    return found


def _suspended(test: LifeTest, time: Floats) -> Floats:
    """The foot of the paper where bearings were suspended."""
    return np.where(np.isin(time, test.times[~test.failed]), _ends()[0], np.nan)


def _limits(test: LifeTest, time: Floats) -> tuple[Floats, Floats]:
    """Ordinates of the shortest and the longest lives that the tests leave room for."""
    band = confidence_band(test)
    upright = _ordinate(band.failed_share)
    across = np.log(time)
    lower, upper = (
        np.interp(across, np.log(ends), upright, left=np.nan, right=np.nan)
        for ends in (band.lower, band.upper)
    )
    return lower, upper


# --- statements -------------------------------------------------------------


def _of_all_failures() -> Claim:
    six, four = six_failures(), four_failures()
    return Claim(
        said("of_all_failures.statement"),
        said(
            "of_all_failures.finding",
            six_count_1=len(six),
            four_count=len(four),
            six_count_2=len(six),
            l10_1=as_plotted(six).l10,
            l10_2=as_plotted(condition("I")).l10,
        ),
        holds=len(six) == len(four),
    )


def _left_out() -> Text:
    first = float(six_failures().times.min())
    count = condition("I").size
    early = 1.0 - float(as_plotted(four_failures()).reliability_at(first)) ** count
    return said("left_out", first=first, count=count, early=100.0 * early)


def _swapped() -> Claim:
    chosen, whole = five_failures(), without_test(5)
    _, printed, _ = lives_of_tests()
    lines = [as_plotted(test) for test in (four_failures(), chosen.select(chosen.rig != "5"))]
    return Claim(
        said("swapped.statement"),
        said(
            "swapped.finding",
            as_plotted_l10=as_plotted(chosen).l10,
            lines_l10=lines[0].l10,
            estimate=whole.life.estimate,
            lower=whole.life.lower,
            upper=whole.life.upper,
        ),
        holds=any(Cell(printed.printed, line.l10).agreement == "printed" for line in lines),
    )


def _any_three() -> Text:
    chosen = five_failures()
    early = int((~chosen.failed & (chosen.times < chosen.times[chosen.failed].min())).sum())
    return said("any_three", early=early, size=chosen.size, l10=Tested.of(chosen).fit.l10)
