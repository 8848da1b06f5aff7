"""The lives that the dissertation draws from its tests, and what all of the bearings say instead.

Limits are those of 90 %, both sides together, where no other confidence is told.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Final

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
    maximum_likelihood,
)
from rolamento_reproductions.campanha_2008.inputs import GIVEN, printed
from rolamento_reproductions.campanha_2008.numbers import Number
from rolamento_reproductions.text import Text, said

__all__ = [
    "Tested",
    "interval",
    "life_by_all",
    "lives_of_tests",
    "shapes_of_fatigue",
    "six_failures",
    "without_test",
]

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
