"""Figures 4.1.1 and 4.1.2: the printed lines and those of all bearings on probability paper.

Across stands log₁₀ t, upright ln ln 1/(1 − F), so that lives of Weibull's distribution lie on a
straight line. Failures stand at their median ranks, suspended bearings at the foot.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.verification.campanha_2008_weibull import (
    as_plotted,
    condition,
    five_failures,
    four_failures,
)
from rolamento.weibull import (
    LifeTest,
    WeibullFit,
    confidence_band,
    plotting_positions,
)
from rolamento_reproductions.campanha_2008.inputs import GIVEN
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    life_by_all,
    lives_of_tests,
    six_failures,
    without_test,
)
from rolamento_reproductions.printed import Cell
from rolamento_reproductions.record import Claim, Column, Curves, Figure, Floats, Line, Panel
from rolamento_reproductions.text import Text, said

__all__ = ["figure_of_condition_one", "figure_without_test_5"]

_TEN_PERCENT: Final = 0.1
_HOURS: Final = (10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0)
_PERCENT: Final = (1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 63.2, 80.0, 90.0, 99.0)
_ORDINATE: Final = "ln ln 1/(1 − F)"


def figure_of_condition_one() -> Figure:
    """Draw the line of 246.7 h, and that of all bearings of condition I."""
    printed, _, _ = lives_of_tests()
    return _paper(
        "4.1.1",
        said(
            "The tests of condition I on Weibull paper: the line behind the printed L_10h, of the"
            " failures of procedure II alone, and that of all {} bearings by maximum likelihood"
            " with limits of 90 %, failures at their median ranks.",
            "Os ensaios da condição I em papel de Weibull: a reta por trás da L_10h impressa, só"
            " das falhas do procedimento II, e a de todos os {} rolamentos por máxima"
            " verossimilhança com limites de 90 %, as falhas em seus postos medianos.",
            condition("I").size,
        ),
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
        said(
            "The same “without test 5”: the line behind the printed L_10h, in which test 5 is a"
            " failure, and that of the {} bearings that are left without it.",
            "O mesmo “sem o ensaio 5”: a reta por trás da L_10h impressa, em que o ensaio 5 é uma"
            " falha, e a dos {} rolamentos que restam sem ele.",
            whole.test.size,
        ),
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
        "as_printed": _line(line, time),
        "failed_as_printed": _failures(chosen, time),
        "all_bearings": _line(whole.fit, time),
        "failed": _failures(whole.test, time),
        "least_life": short,
        "most_life": long,
        "not_failed": _suspended(whole.test, time),
        "ten_percent": np.full(time.size, _ordinate(_TEN_PERCENT)),
    }
    title = said(_ORDINATE, _ORDINATE)
    columns = (
        Column("time", "h", said("Time t", "Tempo t"), time),
        Column("log_time", "", said("Time t (h)", "Tempo t (h)"), np.log10(time)),
        *(Column(name, "", title, _within(values)) for name, values in upright.items()),
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
                    said("Failed", "Falharam"),
                    "%",
                    _lines(printed, line, whole),
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


def _lines(printed: str, line: WeibullFit, whole: Tested) -> tuple[Line, ...]:
    return (
        Line(
            "as_printed",
            1,
            said(
                "as printed: L_10h = {} h, β = {:.2f}",
                "como impresso: L_10h = {} h, β = {:.2f}",
                said("{:.1f}", "{:.1f}", float(printed)),
                line.shape,
            ),
        ),
        Line("failed_as_printed", 1, points=True),
        Line(
            "all_bearings",
            0,
            said(
                "{} bearings: L_10h = {:.0f} h, β = {:.2f}",
                "{} rolamentos: L_10h = {:.0f} h, β = {:.2f}",
                whole.test.size,
                whole.life.estimate,
                whole.fit.shape,
            ),
        ),
        Line("failed", 0, points=True),
        Line("least_life", 5, said("their limits of 90 %", "seus limites de 90 %")),
        Line("most_life", 5),
        Line(
            "not_failed",
            3,
            said("still running when stopped", "ainda giravam ao fim"),
            points=True,
        ),
        Line("ten_percent", 6, said("10 % failed", "10 % falharam")),
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


def _line(fit: WeibullFit, time: Floats) -> Floats:
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
        said(
            "Drawn are the lives of the bearings that failed in condition I, procedures I and II.",
            "Foi plotada a vida dos rolamentos que falharam na condição I, procedimentos I e II.",
        ),
        said(
            "{} failed, and the printed life is that of {}. The same regression of all {} gives"
            " {:.0f} h by themselves, and {:.0f} h with the bearings that did not fail in their"
            " ranks.",
            "Falharam {}, e a vida impressa é a de {}. A mesma regressão de todos os {} dá {:.0f} h"
            " por si sós, e {:.0f} h com os rolamentos que não falharam em seus postos.",
            len(six),
            len(four),
            len(six),
            as_plotted(six).l10,
            as_plotted(condition("I")).l10,
        ),
        holds=len(six) == len(four),
    )


def _left_out() -> Text:
    first = float(six_failures().times.min())
    count = condition("I").size
    early = 1.0 - float(as_plotted(four_failures()).reliability_at(first)) ** count
    return said(
        "The text argues that the failure of test 1 at {:.1f} h is no fault of the machine, and"
        " then leaves it out of the line. By that line one of {} bearings fails so early in"
        " {:.2f} % of such tests.",
        "O texto argumenta que a falha do ensaio 1 às {:.1f} h não é defeito do equipamento, e"
        " depois a deixa fora da reta. Por essa reta, um de {} rolamentos falha tão cedo em"
        " {:.2f} % dos ensaios assim.",
        first,
        count,
        100.0 * early,
    )


def _swapped() -> Claim:
    chosen, whole = five_failures(), without_test(5)
    _, printed, _ = lives_of_tests()
    lines = [as_plotted(test) for test in (four_failures(), chosen.select(chosen.rig != "5"))]
    return Claim(
        said(
            "Without the failure of test 5 L_10h is 242.3 h, with it 246.7 h.",
            "Sem a falha do ensaio 5, L_10h é 242,3 h; com ela, 246,7 h.",
        ),
        said(
            "The other way round: with test 5, and tests 2 to 4 as suspensions, the regression"
            " gives {:.1f} h; of procedure II alone {:.1f} h. All bearings but those of test 5 give"
            " {:.0f} h ({:.0f} to {:.0f}).",
            "É o contrário: com o ensaio 5, e os ensaios 2 a 4 como suspensões, a regressão dá"
            " {:.1f} h; só do procedimento II, {:.1f} h. Todos os rolamentos menos os do ensaio 5"
            " dão {:.0f} h ({:.0f} a {:.0f}).",
            as_plotted(chosen).l10,
            lines[0].l10,
            whole.life.estimate,
            whole.life.lower,
            whole.life.upper,
        ),
        holds=any(Cell(printed.printed, line.l10).agreement == "printed" for line in lines),
    )


def _any_three() -> Text:
    chosen = five_failures()
    early = int((~chosen.failed & (chosen.times < chosen.times[chosen.failed].min())).sum())
    return said(
        "The tests behind the printed line were inferred. Ranks see only that {} suspensions come"
        " before the first failure, not how long they ran: maximum likelihood of the same {} gives"
        " {:.0f} h.",
        "Os ensaios por trás da reta impressa foram inferidos. Os postos só veem que {} suspensões"
        " vêm antes da primeira falha, não quanto giraram: a máxima verossimilhança dos mesmos {}"
        " dá {:.0f} h.",
        early,
        chosen.size,
        Tested.of(chosen).fit.l10,
    )
