"""The life tests, the lives drawn from them, and how these compare with calculated lives.

The tests' L_10h over a calculated one has an interval; only where that leaves 1 outside do the
tests contradict the calculation. That they do not is no proof of it.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.life.iso281 import MILLION
from rolamento.verification.campanha_2008 import (
    as_if_failed,
    as_plotted,
    condition,
    five_failures,
    four_failures,
    minimum_life,
)
from rolamento.weibull import (
    CalculatedLife,
    LifeTest,
    WeibullFit,
    against_calculated_life,
    bounds,
    compare,
    published_life_test,
    published_text,
    rank_regression,
)
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    HOUR,
    NONE,
    Number,
    basic_life_hours,
    load,
    numbers_table,
    printed,
    speed,
)
from rolamento_reproductions.campanha_2008.rating import nsk_numbers
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    figure_of_condition_one,
    figure_without_test_5,
    interval,
    life_by_all,
    lives_of_tests,
    shapes_of_fatigue,
    six_failures,
    without_test,
)
from rolamento_reproductions.record import Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, localised, said, same

_REJECTED: Final = 0.1
"""p below which two conditions are said to differ."""


@dataclass(frozen=True, slots=True, eq=False)
class _Judged:
    """A calculated life, and what the tests of a condition say of it; shape: "" where free."""

    key: str
    told: Text
    condition: str
    shape: str
    found: CalculatedLife

    @property
    def contradicted(self) -> bool:
        """Whether the tests leave no room for it."""
        return bool(self.found.bearings_live)


@cache
def _judged() -> tuple[_Judged, ...]:
    rating = (
        "basic",
        same("L_10h = (C/P)³"),
        basic_life_hours(printed("life")["dynamic_rating_N"]),
    )
    maker = {number.key: float(number.printed) for number in nsk_numbers()}
    reduced = float(GIVEN.inputs_of("load_zone")["reduced_life_h"])
    catalogue = said("L_able, catalogue", "L_able, catálogo")
    measured = said("L_able, measured grooves", "L_able, canais medidos")
    first = (
        rating,
        ("catalogue_I", catalogue, maker["catalogue_I"]),
        ("measured_I", measured, maker["measured_I"]),
        ("reduced", said("the same, corrected for ε", "a mesma, corrigida por ε"), reduced),
    )
    second = (
        rating,
        ("catalogue_II", catalogue, maker["catalogue_II"]),
        ("measured_II", measured, maker["measured_II"]),
    )
    return (
        *(
            _Judged(key, told, "I", "", against_calculated_life(condition("I"), life))
            for key, told, life in first
        ),
        *(
            _Judged(
                key, told, "II", name, against_calculated_life(condition("II"), life, shape=shape)
            )
            for key, told, life in second
            for name, shape in shapes_of_fatigue().items()
        ),
    )


def against_table() -> Table:
    """Set every calculated life against the tests."""
    rows = _judged()

    def column(name: str, title: Text, cells: list[Text]) -> TableColumn:
        return TableColumn(name, title, tuple(cells), sentences=name == "verdict")

    return Table(
        number="E.2",
        caption=said(
            "The calculated lives against the tests: the tests' L_10h over the calculated, with the"
            " interval of 90 %, and p, how often tests would lie at least as far off if the life"
            " were true. Contradicted is a life where the interval leaves 1 outside. Condition I:"
            " all bearings, β free. Condition II: nothing failed, so that β is given and only the"
            " lower end exists.",
            "As vidas calculadas contra os ensaios: L_10h dos ensaios sobre a calculada, com o"
            " intervalo de 90 %, e p, com que frequência ensaios ficariam ao menos tão longe se a"
            " vida fosse verdadeira. Contradita é a vida cujo intervalo deixa 1 de fora. Condição"
            " I: todos os rolamentos, β livre. Condição II: nada falhou, de modo que β é dado e só"
            " existe o extremo inferior.",
        ),
        source=GIVEN.source_of("weibull"),
        columns=(
            column("life", said("Calculated life", "Vida calculada"), [row.told for row in rows]),
            column(
                "calculated_h",
                said("calculated (h)", "calculada (h)"),
                [_with_digits(row.found.calculated, 1) for row in rows],
            ),
            column("condition", said("Condition", "Condição"), [same(r.condition) for r in rows]),
            column("shape", same("β"), [_shape(row.shape) for row in rows]),
            column("tests_h", said("tests (h)", "ensaios (h)"), [_lives(r.found) for r in rows]),
            column(
                "ratio",
                said("tests over calculated", "ensaios sobre calculada"),
                [_ratio_text(row.found) for row in rows],
            ),
            column("p", same("p"), [_probability(row.found.p_value) for row in rows]),
            column("verdict", said("verdict", "veredito"), [_verdict_text(row) for row in rows]),
        ),
        claims=(_no_agreement(), _small_error(), _film_and_life()),
        notes=(_outside(),),
    )


def _with_digits(value: float, digits: int) -> Text:
    form = f"{{:.{digits}f}}"
    return said(form, form, value)


def _shape(name: str) -> Text:
    return Text(name, localised(name, "pt")) if name else said("free", "livre")


def _range_text(low: float, high: float, digits: int) -> Text:
    form = f"{{:.{digits}f}}"
    if not isfinite(high):
        return said(f"at least {form}", f"no mínimo {form}", low)
    return said(f"{form} to {form}", f"{form} a {form}", low, high)


def _lives(found: CalculatedLife) -> Text:
    return _range_text(found.observed.lower, found.observed.upper, 0)


def _ratio_text(found: CalculatedLife) -> Text:
    return _range_text(found.lower, found.upper, 2)


def _probability(value: float) -> Text:
    if value < 0.001:
        return same("< {:.3f}", 0.001)
    return _with_digits(value, 2 if value >= 0.01 else 3)


def _verdict_text(row: _Judged) -> Text:
    if row.contradicted:
        longer = row.found.bearings_live == "longer"
        return (
            said("contradicted: the bearings live longer", "contradita: os rolamentos duram mais")
            if longer
            else said(
                "contradicted: the bearings live shorter", "contradita: os rolamentos duram menos"
            )
        )
    return said("not contradicted", "não contradita")


# --- statements -------------------------------------------------------------


def _names_of_rows(rows: tuple[_Judged, ...]) -> Text:
    """Name calculated lives by their hours: "57.8, 151.2 and 189"."""
    lives = sorted({row.found.calculated for row in rows})
    words = [f"{life:.1f}".removesuffix(".0") for life in lives]
    en, pt = words, [localised(word, "pt") for word in words]
    if not words:
        return said("none", "nenhuma")
    if len(words) == 1:
        return Text(en[0], pt[0])
    return Text(f"{', '.join(en[:-1])} and {en[-1]}", f"{'; '.join(pt[:-1])} e {pt[-1]}")


def _of_condition(name: str) -> tuple[_Judged, ...]:
    return tuple(row for row in _judged() if row.condition == name)


def _by_shapes(*, every: bool) -> tuple[_Judged, ...]:
    """Lives of condition II contradicted with every shape; or with some but not with every."""
    found = []
    for row in _of_condition("II"):
        verdicts = [r.contradicted for r in _of_condition("II") if r.key == row.key]
        if all(verdicts) if every else any(verdicts) and not all(verdicts):
            found.append(row)
    return tuple(found)


def _no_agreement() -> Claim:
    rows, first, life = _judged(), _of_condition("I"), life_by_all().life
    out = tuple(row for row in first if row.contradicted)
    return Claim(
        said(
            "Observed lives and the latest calculations do not agree; those of ISO 281 do not apply"
            " (chapter 5).",
            "Não houve concordância entre as vidas observadas e os mais atuais cálculos; os da ISO"
            " 281 não se aplicam (capítulo 5).",
        ),
        said(
            "The tests of condition I admit {:.0f} to {:.0f} h: {} h, not {} h (p = {:.2f}). Those"
            " of condition II do not admit {} h, and {} h by one β and not by the other. All that"
            " are contradicted are too short: the bearings live longer than calculated.",
            "Os ensaios da condição I admitem de {:.0f} a {:.0f} h: {} h, mas não {} h (p ="
            " {:.2f}). Os da condição II não admitem {} h, e {} h só com um dos β. Todas as"
            " contraditas são curtas demais: os rolamentos duram mais que o calculado.",
            life.lower,
            life.upper,
            _names_of_rows(tuple(row for row in first if not row.contradicted)),
            _names_of_rows(out),
            min((row.found.p_value for row in out), default=1.0),
            _names_of_rows(_by_shapes(every=True)),
            _names_of_rows(_by_shapes(every=False)),
        ),
        holds=all(row.contradicted for row in rows),
        partly=any(row.contradicted for row in rows),
    )


def _small_error() -> Claim:
    found = {row.key: row for row in _of_condition("I")}
    near, far = found["measured_I"], found["catalogue_I"]
    off = max(near.found.upper - 1.0, 1.0 - near.found.lower)
    return Claim(
        said(
            "189 h is near the tests, with a small error of 28 %; 41 h is far from them, with one"
            " of 490 % (chapter 4.1.2).",
            "189 h está próximo dos ensaios, com um erro pequeno, de 28 %; 41 h está longe, com"
            " 490 % (capítulo 4.1.2).",
        ),
        said(
            "With all bearings the tests are {:.2f} times 189 h ({:.2f} to {:.2f}) and {:.1f} times"
            " 41 h ({:.2f} to {:.1f}). Limits a factor of {:.0f} apart cannot tell 28 % from"
            " nothing, and leave 41 h just outside.",
            "Com todos os rolamentos os ensaios são {:.2f} vez 189 h ({:.2f} a {:.2f}) e {:.1f}"
            " vezes 41 h ({:.2f} a {:.1f}). Limites separados por um fator de {:.0f} não distinguem"
            " 28 % de nada, e deixam 41 h logo fora.",
            *(near.found.ratio, near.found.lower, near.found.upper),
            *(far.found.ratio, far.found.lower, far.found.upper),
            near.found.upper / near.found.lower,
        ),
        holds=far.contradicted and off <= _stated_share("measured_percent"),
        partly=far.contradicted and not near.contradicted,
    )


def _stated_share(name: str) -> float:
    return float(GIVEN.inputs_of("comparison")[name]) / 100.0


def _film_and_life() -> Claim:
    alike = compare(published_life_test("campanha_2008"), "same_life")
    first, second = condition("I"), condition("II")
    last = float(second.times.max())
    by_then = int((first.failed & (first.times <= last)).sum())
    maker = [row for row in _of_condition("II") if row.key == "catalogue_II"]
    return Claim(
        said(
            "Condition II shows that λ and life do not go together (chapter 5).",
            "A condição II mostra discrepância entre λ e a vida (capítulo 5).",
        ),
        said(
            "Its bearings live longer than the maker's 17 h, in which λ counts. But the tests do"
            " not tell the two conditions apart (p = {:.2f}): those of II were stopped at {:.0f} to"
            " {:.0f} h, by when no more than {} of the {} bearings of condition I had failed.",
            "Seus rolamentos duram mais que as 17 h do fabricante, em que λ conta. Mas os ensaios"
            " não distinguem as duas condições (p = {:.2f}): os da II foram parados entre {:.0f} e"
            " {:.0f} h, quando na condição I só havia falhado {} de {} rolamentos.",
            alike.p_value,
            float(second.times.min()),
            last,
            by_then,
            first.size,
        ),
        holds=alike.p_value < _REJECTED,
        partly=all(row.contradicted for row in maker),
    )


def _outside() -> Text:
    share = 100.0 * load() / printed("life")["dynamic_rating_N"]
    return said(
        "All of these lives lie outside what their methods are for: the load is {:.1f} % of the"
        " rating, and 50 % is the limit (tables B and C). That a life is not contradicted does not"
        " make it right.",
        "Todas essas vidas estão fora do que seus métodos admitem: a carga é {:.1f} % da"
        " capacidade, e 50 % é o limite (tabelas B e C). Uma vida não contradita não é por isso"
        " correta.",
        share,
    )


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
        return _NONE if self.fit is None else same("{:.0f}", self.fit.scale)

    @property
    def mean(self) -> Text:
        """Mean life."""
        return _NONE if self.fit is None else same("{:.0f}", self.fit.mean)


def fits_table() -> Table:
    """Put the analyses side by side."""
    rows = _fit_rows()

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


def _fit_rows() -> tuple[_Row, ...]:
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
    return _Row(told, test, same("{:.2f}", fit.shape), same("{:.1f}", fit.l10), fit)


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


_DOUBLE = 100.0
"""% above the calculated life."""


@dataclass(frozen=True, slots=True)
class RigTest:
    """One test: what ran how long (h), and what failed at its end."""

    number: int
    procedure: str
    condition: str
    hours: float
    bearings: tuple[int, ...]
    failed: tuple[int, ...]


@cache
def life_tests() -> tuple[RigTest, ...]:
    """Return the tests of tables 4.1.1 and 4.1.2."""
    lines = published_text("campanha_2008").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return tuple(_life_test_of(list(own)) for _, own in groupby(rows, key=lambda row: row["test"]))


def _life_test_of(rows: list[dict[str, str]]) -> RigTest:
    """Put the bearings of a test together."""
    first = rows[0]
    return RigTest(
        number=int(first["test"]),
        procedure=first["procedure"],
        condition=first["condition"],
        hours=float(first["time"]),
        bearings=tuple(int(row["bearing"]) for row in rows),
        failed=tuple(int(row["bearing"]) for row in rows if row["status"] == "failed"),
    )


def life_tests_section(title: Text) -> Section:
    """Show the tests, the lives drawn from them, and compute the comparisons."""
    return Section(
        title,
        (
            _record(),
            figure_of_condition_one(),
            figure_without_test_5(),
            _comparison(),
            fits_table(),
            against_table(),
        ),
    )


# --- tables 4.1.1 and 4.1.2 -------------------------------------------------


def _record() -> Table:
    tests = life_tests()
    rating = printed("life")["dynamic_rating_N"]
    turns = [test.hours * HOUR * speed() / (2.0 * np.pi * MILLION) for test in tests]

    def column(name: str, title: Text, cells: list[Any]) -> TableColumn:
        return TableColumn(name, title, tuple(str(cell) for cell in cells))

    return Table(
        number="4.1.1",
        caption=said(
            "The life tests of tables 4.1.1 and 4.1.2: running time, revolutions, and time over the"
            " rating life (C/P)³ = {:.1f} h. In procedure I two bearings run together, and the test"
            " ends with the first failure; in procedure II one is reinforced and does not count.",
            "Os ensaios de vida das tabelas 4.1.1 e 4.1.2: tempo, revoluções e tempo sobre a vida"
            " nominal (C/P)³ = {:.1f} h. No procedimento I dois rolamentos giram juntos e o ensaio"
            " termina com a primeira falha; no II um é reforçado e não conta.",
            basic_life_hours(rating),
        ),
        source=GIVEN.source_of("life_tests"),
        columns=(
            column("test", said("Test", "Ensaio"), [test.number for test in tests]),
            column("procedure", said("Procedure", "Procedimento"), [t.procedure for t in tests]),
            column("condition", said("Condition", "Condição"), [t.condition for t in tests]),
            column(
                "bearings",
                said("Bearings", "Rolamentos"),
                [_listed_numbers(t.bearings) for t in tests],
            ),
            column("hours", said("Time (h)", "Tempo (h)"), [f"{t.hours:.1f}" for t in tests]),
            column(
                "revolutions_1e6",
                said("10⁶ revolutions", "10⁶ revoluções"),
                [f"{n:.2f}" for n in turns],
            ),
            column(
                "over_rating_life",
                said("over (C/P)³", "sobre (C/P)³"),
                [f"{t.hours / basic_life_hours(rating):.2f}" for t in tests],
            ),
            column("failed", said("Failed", "Falhou"), [_listed_numbers(t.failed) for t in tests]),
        ),
        claims=(_six(), _third(), _sides()),
    )


def _listed_numbers(numbers: tuple[int, ...]) -> str:
    return " + ".join(str(number) for number in numbers) or "–"


def _six() -> Claim:
    failed = [number for test in life_tests() for number in test.failed]
    count = sum(len(test.bearings) for test in life_tests())
    return Claim(
        said("Only 6 of the 24 bearings failed.", "Apenas 6 dos 24 rolamentos falharam."),
        said(
            "{} of {}; the other {} were still running when their test ended. Their times are not"
            " lives, but lower bounds of lives.",
            "{} de {}; os outros {} ainda giravam ao fim de seu ensaio. Seus tempos não são vidas,"
            " mas limites inferiores de vidas.",
            len(failed),
            count,
            count - len(failed),
        ),
        (len(failed), count) == (6, 24),
    )


def _third() -> Claim:
    first = life_tests()[0]
    return Claim(
        said("In test 1 bearing 3 failed.", "No ensaio 1 falhou o rolamento 3."),
        said(
            "Bearings {} ran in it, and the text names bearing {} everywhere else.",
            "Nele giraram os rolamentos {}, e no resto do texto é o rolamento {}.",
            _listed_numbers(first.bearings),
            first.failed[0],
        ),
        3 in first.bearings,
    )


def _sides() -> Claim:
    drive = GIVEN.inputs_of("life_tests")["drive_side"]
    single = [test.bearings[0] for test in life_tests() if test.procedure == "II"]
    against = [number for number in single if (number % 2 == 1) != (number in drive)]
    return Claim(
        said(
            "Bearings of odd numbers sit at the drive side, of even numbers at the other.",
            "Rolamentos de numeração ímpar ficam do lado do acionamento; os pares, do lado oposto.",
        ),
        said(
            "Not in procedure II: tests 11 and 12 failed at the drive side, 13 and 14 at the other;"
            " bearings {} contradict the rule.",
            "Não no procedimento II: os ensaios 11 e 12 falharam do lado do acionamento, 13 e 14 do"
            " lado oposto; os rolamentos {} contradizem a regra.",
            said("{} and {}", "{} e {}", *against),
        ),
        holds=not against,
    )


# --- comparisons ------------------------------------------------------------


@cache
def comparison_numbers() -> tuple[Number, ...]:
    """Return the printed deviations of tested from calculated lives."""
    given = GIVEN.inputs_of("comparison")
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}
    reduced = float(GIVEN.inputs_of("load_zone")["reduced_life_h"])
    lives = {number.key: float(number.printed) for number in lives_of_tests()}
    without, hot = lives["life_without_5"], lives["life_II"]
    measured = calculated["measured_I"]
    return (
        Number(
            "measured",
            said("242.3 h over L_able = 189 h (%)", "242,3 h sobre L_able = 189 h (%)"),
            given["measured_percent"],
            _above(without, measured),
            NONE,
            said(
                "Of the tested over the calculated life, less one. The text does not say that it is"
                " the life printed as that without test 5; with the other it is {:.0f} %.",
                "Da vida ensaiada sobre a calculada, menos um. O texto não diz que é a impressa"
                " como sem o ensaio 5; com a outra são {:.0f} %.",
                _above(lives["life_I"], measured),
            ),
        ),
        Number(
            "catalogue",
            said("242.3 h over L_able = 41 h (%)", "242,3 h sobre L_able = 41 h (%)"),
            given["catalogue_percent"],
            _above(without, calculated["catalogue_I"]),
            NONE,
            said("“Near”; likewise.", "“Próximo de”; da mesma forma."),
        ),
        Number(
            "condition_II",
            said(
                "117.4 h over L_able = 69 h, condition II (%)",
                "117,4 h sobre L_able = 69 h, condição II (%)",
            ),
            given["condition_II_percent"],
            _above(hot, calculated["measured_II"]),
            NONE,
            said(
                "Likewise, with running times taken for failures.",
                "Da mesma forma, com os tempos de ensaio tomados por falhas.",
            ),
        ),
        Number(
            "reduced",
            said(
                "242.3 h over 151.2 h, corrected for ε (%)",
                "242,3 h sobre 151,2 h, corrigida por ε (%)",
            ),
            given["reduced_percent"],
            _above(without, reduced),
            NONE,
            said(
                "Likewise; the correction is in table D.",
                "Da mesma forma; a correção está na tabela D.",
            ),
        ),
    )


def _above(tested: float, calculated: float) -> float:
    """How far a tested life is above the calculated one; %."""
    return 100.0 * (tested / calculated - 1.0)


def _comparison() -> Table:
    return numbers_table(
        "E",
        said(
            "The lives L_10h drawn from the tests, with limits of 90 %, and how far the printed"
            " ones are above the calculated.",
            "As vidas L_10h tiradas dos ensaios, com limites de 90 %, e quanto as impressas superam"
            " as calculadas.",
        ),
        GIVEN.source_of("comparison"),
        (*lives_of_tests(), *comparison_numbers()),
        claims=(_more_than_double(),),
        notes=(
            said(
                "There is no right number beside the percentages, because none of the calculated"
                " lives holds (tables C and D), and with limits so wide they say nothing. Table"
                " E.2 sets all calculated lives against the tests.",
                "Não há número correto ao lado das porcentagens, pois nenhuma das vidas calculadas"
                " vale (tabelas C e D) e, com limites tão largos, elas nada dizem. A tabela E.2"
                " põe todas as vidas calculadas contra os ensaios.",
            ),
        ),
    )


def _more_than_double() -> Claim:
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}["measured_II"]
    tested = next(float(n.printed) for n in lives_of_tests() if n.key == "life_II")
    times = [test.hours for test in life_tests() if test.condition == "II"]
    above = [_above(time, calculated) for time in times]
    most = sum(value > _DOUBLE for value in above)
    return Claim(
        said(
            "In condition II the tests went more than 100 % beyond the predicted life without a"
            " failure.",
            "Na condição II os ensaios excederam a vida prevista em mais de 100 % sem falha.",
        ),
        said(
            "{} of {} tests did, the other by {:.0f} %; against 117.4 h, with which the text says"
            " it compares, it is {:.0f} %.",
            "{} de {} ensaios, o outro em {:.0f} %; contra as 117,4 h com que o texto diz comparar,"
            " são {:.0f} %.",
            most,
            len(times),
            min(above),
            _above(tested, calculated),
        ),
        holds=most == len(times),
        partly=most > 0,
    )
