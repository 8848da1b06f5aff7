"""Table E.1: the same tests analysed in several ways, from the printed ones to all of the data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from rolamento.verification.campanha_2008 import (
    as_if_failed,
    as_plotted,
    condition,
    five_failures,
    four_failures,
    minimum_life,
)
from rolamento.weibull import (
    LifeTest,
    WeibullFit,
    bounds,
    compare,
    published_life_test,
    rank_regression,
)
from rolamento_reproductions.campanha_2008.inputs import GIVEN
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    interval,
    life_by_all,
    shapes_of_fatigue,
    six_failures,
    without_test,
)
from rolamento_reproductions.record import Claim, Table, TableColumn
from rolamento_reproductions.text import Text, localised, said, same

__all__ = ["fits_table"]

_NONE: Final = same("–")
_WEAR: Final = 2.0
"""β above which the text has bearings."""


@dataclass(frozen=True, slots=True, eq=False)
class _Row:
    """One way of analysing some of the tests; without a fit there is a lower limit alone."""

    told: Text
    test: LifeTest
    shape: Text
    life: Text
    fit: WeibullFit | None = None

    @property
    def scale(self) -> Text:
        """η."""
        return _NONE if self.fit is None else said("{:.0f}", "{:.0f}", self.fit.scale)

    @property
    def mean(self) -> Text:
        """Mean life."""
        return _NONE if self.fit is None else said("{:.0f}", "{:.0f}", self.fit.mean)


def fits_table() -> Table:
    """Put the analyses side by side."""
    rows = _rows()

    def column(name: str, title: Text, cell: Callable[[_Row], Text]) -> TableColumn:
        return TableColumn(name, title, tuple(cell(row) for row in rows), sentences=name == "of")

    return Table(
        number="E.1",
        caption=said(
            "What the tests say, by which bearings are taken and how; in brackets limits of 90 %,"
            " for condition II the lower limit of 95 %. For lines through ranks none are given.",
            "O que dizem os ensaios, conforme os rolamentos tomados e o método; entre parênteses,"
            " limites de 90 %, na condição II o limite inferior de 95 %. Para retas por postos não"
            " são dados.",
        ),
        source=GIVEN.source_of("weibull"),
        columns=(
            column("of", said("Tests and method", "Ensaios e método"), lambda row: row.told),
            column("tested", said("tested", "ensaiados"), lambda row: same(str(row.test.size))),
            column("failed", said("failed", "falharam"), lambda row: same(str(row.test.failures))),
            column("shape", same("β"), lambda row: row.shape),
            column("scale_h", same("η (h)"), lambda row: row.scale),
            column("mean_h", said("mean (h)", "média (h)"), lambda row: row.mean),
            column("life_h", same("L_10h (h)"), lambda row: row.life),
        ),
        claims=(_steep(),),
        notes=(_other_limits(), _pooled()),
    )


def _rows() -> tuple[_Row, ...]:
    return (*_of_procedure_two(), *_of_condition_one(), *_of_condition_two())


def _of_procedure_two() -> tuple[_Row, ...]:
    four, five = four_failures(), five_failures()
    return (
        _of_line(
            said("procedure II, as plotted: 246.7 h", "procedimento II, como traçado: 246,7 h"),
            four,
            as_plotted(four),
        ),
        _of_line(
            said(
                "the same, ln t regressed on the ordinate (IEC 61649)",
                "os mesmos, ln t em regressão sobre a ordenada (IEC 61649)",
            ),
            four,
            rank_regression(four),
        ),
        _of_likelihood(
            said("the same, maximum likelihood", "os mesmos, máxima verossimilhança"),
            Tested.of(four),
        ),
        _of_line(
            said(
                "with test 5 failed and tests 2 to 4 suspended, once each, as plotted: 242.3 h",
                "com o ensaio 5 em falha e os ensaios 2 a 4 suspensos, uma vez cada, como traçado:"
                " 242,3 h",
            ),
            five,
            as_plotted(five),
        ),
    )


def _of_condition_one() -> tuple[_Row, ...]:
    return (
        _of_likelihood(
            said(
                "the six failures of condition I as if there were no other bearings, maximum"
                " likelihood (eqs. 2.7.5 and 2.7.6)",
                "as seis falhas da condição I como se não houvesse outros rolamentos, máxima"
                " verossimilhança (eqs. 2.7.5 e 2.7.6)",
            ),
            Tested.of(six_failures()),
        ),
        _of_likelihood(
            said(
                "condition I, all bearings, maximum likelihood",
                "condição I, todos os rolamentos, máxima verossimilhança",
            ),
            life_by_all(),
        ),
        _of_likelihood(said("the same without test 5", "o mesmo sem o ensaio 5"), without_test(5)),
        _of_likelihood(said("the same without test 1", "o mesmo sem o ensaio 1"), without_test(1)),
    )


def _of_condition_two() -> tuple[_Row, ...]:
    """The printed line, and lower limits by shapes of fatigue and by that of condition I."""
    hot, own = as_if_failed(), life_by_all().fit.shape
    shapes = {**shapes_of_fatigue(), f"{own:.2f}": own}
    return (
        _of_line(
            said(
                "condition II as if failed, as plotted: 117.4 h",
                "condição II como se falhasse, como traçado: 117,4 h",
            ),
            hot,
            as_plotted(hot),
        ),
        *(_at_shape(*pair) for pair in shapes.items()),
    )


def _of_line(told: Text, test: LifeTest, fit: WeibullFit) -> _Row:
    return _Row(
        told, test, said("{:.2f}", "{:.2f}", fit.shape), said("{:.1f}", "{:.1f}", fit.l10), fit
    )


def _of_likelihood(told: Text, tested: Tested) -> _Row:
    return _Row(told, tested.test, interval(tested.shape, 2), interval(tested.life), tested.fit)


def _at_shape(name: str, shape: float) -> _Row:
    """Condition II with a shape from elsewhere."""
    return _Row(
        said("condition II as it ended, β given", "condição II como terminou, β dado"),
        condition("II"),
        Text(name, localised(name, "pt")),
        said("at least {:.0f}", "no mínimo {:.0f}", minimum_life(shape)),
    )


# --- what follows -----------------------------------------------------------


def _steep() -> Claim:
    shape = life_by_all().shape
    return Claim(
        said(
            "For bearings β is normally above 2, for processes of wear stand out.",
            "Para rolamentos, normalmente β > 2, pois se destacam os processos de desgaste.",
        ),
        said(
            "Rolling fatigue of ball bearings has 10/9 (Lundberg and Palmgren), and a_1 in table"
            " 2.6.2 rests on 1.5. These tests cannot tell: {} with all bearings of condition I.",
            "A fadiga de rolamentos de esferas tem 10/9 (Lundberg e Palmgren), e a_1 na tabela"
            " 2.6.2 parte de 1,5. Estes ensaios não o decidem: {} com todos os rolamentos da"
            " condição I.",
            interval(shape, 2),
        ),
        holds=shape.lower > _WEAR,
    )


def _other_limits() -> Text:
    life = bounds(condition("I"), "L10", method="calibrated_likelihood_ratio")
    return said(
        "The limits of condition I are approximate, for nobody knows when the tests that failed"
        " would have been stopped. By the calibrated likelihood ratio they are {:.0f} to {:.0f} h.",
        "Os limites da condição I são aproximados, pois não se sabe quando se teriam parado os"
        " ensaios que falharam. Pela razão de verossimilhança calibrada são {:.0f} a {:.0f} h.",
        life.lower,
        life.upper,
    )


def _pooled() -> Text:
    whole = published_life_test("campanha_2008", group="procedure")
    first = whole.select(published_life_test("campanha_2008").group == "I")
    alike = compare(first, "homogeneous")
    return said(
        "Procedures I and II are taken together, as the text has it. That both have one"
        " distribution has p = {:.2f}: the four failures of procedure II lie much closer together"
        " than those of procedure I, and the line of all bearings is the best there is, not a good"
        " one.",
        "Os procedimentos I e II são tomados juntos, como no texto. Que ambos tenham uma só"
        " distribuição tem p = {:.2f}: as quatro falhas do procedimento II estão muito mais juntas"
        " que as do procedimento I, e a reta de todos os rolamentos é a melhor que há, não uma"
        " boa.",
        alike.p_value,
    )
