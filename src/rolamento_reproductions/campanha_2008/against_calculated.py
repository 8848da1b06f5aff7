"""Table E.2: the calculated lives of the dissertation against what the tests say.

The tests' L_10h over a calculated one has an interval; only where that leaves 1 outside do the
tests contradict the calculation. That they do not is no proof of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import isfinite
from typing import Final

from rolamento.verification.campanha_2008 import condition
from rolamento.weibull import (
    CalculatedLife,
    against_calculated_life,
    compare,
    published_life_test,
)
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    basic_life_hours,
    load,
    printed,
)
from rolamento_reproductions.campanha_2008.nsk import nsk_numbers
from rolamento_reproductions.campanha_2008.weibull import life_by_all, shapes_of_fatigue
from rolamento_reproductions.record import Claim, Table, TableColumn
from rolamento_reproductions.text import Text, localised, said, same

__all__ = ["against_table"]

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
        said("L_10h = (C/P)³", "L_10h = (C/P)³"),
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
                [_number(row.found.calculated, 1) for row in rows],
            ),
            column("condition", said("Condition", "Condição"), [same(r.condition) for r in rows]),
            column("shape", same("β"), [_shape(row.shape) for row in rows]),
            column("tests_h", said("tests (h)", "ensaios (h)"), [_lives(r.found) for r in rows]),
            column(
                "ratio",
                said("tests over calculated", "ensaios sobre calculada"),
                [_ratio(row.found) for row in rows],
            ),
            column("p", same("p"), [_probability(row.found.p_value) for row in rows]),
            column("verdict", said("verdict", "veredito"), [_verdict(row) for row in rows]),
        ),
        claims=(_no_agreement(), _small_error(), _film_and_life()),
        notes=(_outside(),),
    )


def _number(value: float, digits: int) -> Text:
    form = f"{{:.{digits}f}}"
    return said(form, form, value)


def _shape(name: str) -> Text:
    return Text(name, localised(name, "pt")) if name else said("free", "livre")


def _range(low: float, high: float, digits: int) -> Text:
    form = f"{{:.{digits}f}}"
    if not isfinite(high):
        return said(f"at least {form}", f"no mínimo {form}", low)
    return said(f"{form} to {form}", f"{form} a {form}", low, high)


def _lives(found: CalculatedLife) -> Text:
    return _range(found.observed.lower, found.observed.upper, 0)


def _ratio(found: CalculatedLife) -> Text:
    return _range(found.lower, found.upper, 2)


def _probability(value: float) -> Text:
    if value < 0.001:
        return said("< {:.3f}", "< {:.3f}", 0.001)
    return _number(value, 2 if value >= 0.01 else 3)


def _verdict(row: _Judged) -> Text:
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


def _named(rows: tuple[_Judged, ...]) -> Text:
    """Name calculated lives by their hours: "57.8, 151.2 and 189"."""
    lives = sorted({row.found.calculated for row in rows})
    words = [f"{life:.1f}".removesuffix(".0") for life in lives]
    en, pt = words, [localised(word, "pt") for word in words]
    if not words:
        return said("none", "nenhuma")
    if len(words) == 1:
        return Text(en[0], pt[0])
    return Text(
        f"{', '.join(en[:-1])} and {en[-1]}",
        f"{'; '.join(pt[:-1])} e {pt[-1]}",
    )


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
            _named(tuple(row for row in first if not row.contradicted)),
            _named(out),
            min((row.found.p_value for row in out), default=1.0),
            _named(_by_shapes(every=True)),
            _named(_by_shapes(every=False)),
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
        holds=far.contradicted and off <= _share("measured_percent"),
        partly=far.contradicted and not near.contradicted,
    )


def _share(name: str) -> float:
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
