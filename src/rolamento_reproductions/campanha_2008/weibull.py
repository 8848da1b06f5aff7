"""The lives that the dissertation draws from its tests, and what all of the bearings say instead.

Limits are those of 90 %, both sides together, where no other confidence is told. On the probability
paper of figures 4.1.1 and 4.1.2 log₁₀ t stands across, ln ln 1/(1 − F) upright, so that lives of
Weibull's distribution lie on a straight line; failures stand at their median ranks, suspended
bearings at the foot.
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
from rolamento_reproductions.campanha_2008.inputs import GIVEN, Number, printed
from rolamento_reproductions.record import Cell, Claim, Curves, Figure, Floats, Line, Panel, Series
from rolamento_reproductions.text import Text, said, same

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
    form = f"{{:.{digits}f}}"
    return said(
        f"{form} ({form} to {form})",
        f"{form} ({form} a {form})",
        bound.estimate,
        bound.lower,
        bound.upper,
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
        said("L_10h of the tests, condition I (h)", "L_10h dos ensaios, condição I (h)"),
        _printed("condition_I"),
        line.l10,
        interval(whole.life),
        said(
            "Of the four failures of procedure II alone: ln ln 1/(1 − F) with exact median ranks,"
            " regressed on ln t, β = {:.2f}, η = {:.1f} h. The text says that bearings which failed"
            " are drawn, but not that two of these, at 38.2 and 627.6 h, are left out; and the {}"
            " that did not fail count too. Right: all {} by maximum likelihood, with"
            " limits of 90 %.",
            "Das quatro falhas só do procedimento II: ln ln 1/(1 − F) com postos medianos exatos,"
            " em regressão sobre ln t, β = {:.2f}, η = {:.1f} h. O texto diz que se plotam os"
            " rolamentos que falharam, mas não que dois deles, com 38,2 e 627,6 h, ficam de fora; e"
            " os {} que não falharam também contam. Correto: todos os {}, por máxima"
            " verossimilhança, com limites de 90 %.",
            line.shape,
            line.scale,
            whole.test.suspensions,
            whole.test.size,
        ),
    )


def _without_five() -> Number:
    chosen, whole = five_failures(), without_test(_FIVE)
    return Number(
        "life_without_5",
        said(
            "L_10h of the tests, condition I without test 5 (h)",
            "L_10h dos ensaios, condição I sem o ensaio 5 (h)",
        ),
        _printed("without_test_5"),
        as_plotted(chosen).l10,
        interval(whole.life),
        said(
            "Test 5 is in it: the same regression of {} failures, those of procedure II and test"
            " 5, with {} suspensions, tests 2, 3 and 4 once each. Ranks see only that these came"
            " before the failures. Test 1 is left out again. So 242.3 h is with test 5 and 246.7 h"
            " without it, as if the labels were swapped. Right: the {} bearings of the other"
            " tests.",
            "O ensaio 5 está nela: a mesma regressão de {} falhas, as do procedimento II e o ensaio"
            " 5, com {} suspensões, os ensaios 2, 3 e 4 uma vez cada. Os postos só veem que estas"
            " vieram antes das falhas. O ensaio 1 fica de fora outra vez. Assim, 242,3 h é com o"
            " ensaio 5 e 246,7 h sem ele, como se os rótulos estivessem trocados. Correto: os {}"
            " rolamentos dos outros ensaios.",
            chosen.failures,
            chosen.suspensions,
            whole.test.size,
        ),
    )


def _of_condition_two() -> Number:
    chosen, hot = as_if_failed(), condition("II")
    return Number(
        "life_II",
        said(
            "L_10h of the tests, condition II as if failed (h)",
            "L_10h dos ensaios, condição II como se falhasse (h)",
        ),
        _printed("condition_II"),
        as_plotted(chosen).l10,
        said("at least {:.0f}", "no mínimo {:.0f}", minimum_life(SHAPE)),
        said(
            "The same regression, each of {} tests taken to end with a failure. None of the {}"
            " bearings failed, and the end of a test is no life: it tells when somebody stopped the"
            " machine. What they do tell is a lower limit, here with β = {:.1f} and a confidence of"
            " 95 %; for other shapes see table E.1.",
            "A mesma regressão, com cada um de {} ensaios tomado como terminado em falha. Nenhum"
            " dos {} rolamentos falhou, e o fim de um ensaio não é uma vida: diz quando alguém"
            " parou a máquina. O que eles dizem é um limite inferior, aqui com β = {:.1f} e"
            " confiança de 95 %; para outras formas, ver a tabela E.1.",
            len(chosen),
            hot.size,
            SHAPE,
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
        "as_printed": _fitted_line(line, time),
        "failed_as_printed": _failures(chosen, time),
        "all_bearings": _fitted_line(whole.fit, time),
        "failed": _failures(whole.test, time),
        "least_life": short,
        "most_life": long,
        "not_failed": _suspended(whole.test, time),
        "ten_percent": np.full(time.size, _ordinate(_TEN_PERCENT)),
    }
    title = said(_ORDINATE, _ORDINATE)
    columns = (
        Series("time", "h", said("Time t", "Tempo t"), time),
        Series("log_time", "", said("Time t (h)", "Tempo t (h)"), np.log10(time)),
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
                    said("Failed", "Falharam"),
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
            said(
                "as printed: L_10h = {} h, β = {:.2f}",
                "como impresso: L_10h = {} h, β = {:.2f}",
                same("{:.1f}", float(printed)),
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
            "not_failed", 3, said("still running when stopped", "ainda giravam ao fim"), points=True
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
