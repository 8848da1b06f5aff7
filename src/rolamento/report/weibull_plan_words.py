"""What the pages of planned life tests say, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["PLAN_WORDS", "PlanWords"]

Forms = tuple[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanWords:
    """The words of one language; `{…}` are filled in by the one who says it."""

    # demonstration
    showing: str
    shape: str
    run: str
    without_failure: str
    with_failures: Forms
    shown: str
    just_as_wanted: str
    to_pass: str
    expected_end: str
    chance: str
    true_ratio: str
    passes: str
    ends_after: str
    other_shape: str
    shape_head: str
    shown_with: str
    any_shape: str
    trade: str
    bearings: str
    total: str
    allowed: Forms
    no_failure: str

    # precision
    precision: str
    known_to: str
    expected: str
    expected_multiples: str
    one: str
    several: str
    sudden_saves: str
    table: str
    tests: str
    groups: str
    failures: str
    ratio: str
    rarely: str
    shape_ratio: str
    ends: str
    from_to: str
    bearing_time: str
    rig_time: str
    all_fail: str
    part_fails: str
    sudden: str
    legend: str
    working: str


PLAN_WORDS: Final[Mapping[str, PlanWords]] = {
    "en": PlanWords(
        showing="To show an {quantity} of {life} {unit} with {confidence} % confidence",
        shape="shape {shape} from experience",
        run="Run {bearings} bearings for {time} {unit} each, {total} {unit} all together,"
        " {failures}.",
        without_failure="without a failure",
        with_failures=("with {count} failure at most", "with {count} failures at most"),
        shown="Passed, the test shows the life with {shown} % confidence.",
        just_as_wanted="Bearings that live just as long as wanted pass {chance} % of such tests.",
        to_pass="To pass with 90 %, their {quantity} has to be {life} {unit}, {ratio} times the one"
        " to be shown.",
        expected_end="Bearings just as wanted end the test after {time} {unit} on the mean, since"
        " one failure too many ends it.",
        chance="Chance of passing",
        true_ratio="true life over wanted",
        passes="passes %",
        ends_after="ends after {unit}",
        other_shape="If the shape is another",
        shape_head="shape",
        shown_with="shown with %",
        any_shape="The test is as long as the life: the shape does not matter for what it shows.",
        trade="As good: bearings against time each ({unit})",
        bearings="bearings",
        total="all, none failing",
        allowed=("{count} may fail", "{count} may fail"),
        no_failure="none may fail",
        precision="How precisely a test tells {quantity}",
        known_to="wanted: {confidence} % bounds a factor of {ratio} apart in half of the tests",
        expected="expected: shape {shape}, {quantity} {life} {unit}",
        expected_multiples="expected: shape {shape}; times are multiples of {quantity}",
        one="{bearings} bearings, {failures} failures: the {confidence} % bounds of {quantity} are"
        " a factor of {ratio} apart in half of the tests, and {rarely} or more in one of ten.",
        several="{bearings} bearings run until all have failed take {time} {unit}.",
        sudden_saves="Sudden death in {groups} groups of {size} is as precise with {failures}"
        " failures, and ends after {time} {unit}; it takes {bearings} bearings.",
        table="Tests that are as precise",
        tests="Tests",
        groups="rigs",
        failures="failures",
        ratio="factor",
        rarely="1 in 10",
        shape_ratio="of shape",
        ends="lasts {unit}",
        from_to="(90 %)",
        bearing_time="bearing·{unit}",
        rig_time="rig·{unit}",
        all_fail="all fail",
        part_fails="{percent} % fail",
        sudden="sudden death, {size} each",
        legend="Factor: between the bounds, in half of the tests; 1 in 10: exceeded by one test of"
        " ten; of shape: between the bounds of the shape. Lasts: mean, and between which"
        " 90 % end, all rigs running at once. {samples} tests drawn, seed {seed}.",
        working="Drawing tests …",
    ),
    "pt": PlanWords(
        showing="Para demonstrar {quantity} de {life} {unit} com {confidence} % de confiança",
        shape="forma {shape} da experiência",
        run="Ensaie {bearings} rolamentos por {time} {unit} cada, {total} {unit} ao todo,"
        " {failures}.",
        without_failure="sem nenhuma falha",
        with_failures=("com {count} falha no máximo", "com {count} falhas no máximo"),
        shown="Aprovado, o ensaio demonstra a vida com {shown} % de confiança.",
        just_as_wanted="Rolamentos que vivem exatamente o desejado são aprovados em {chance} % dos"
        " ensaios assim.",
        to_pass="Para aprovação com 90 %, sua {quantity} precisa ser de {life} {unit}, {ratio}"
        " vezes a que se quer demonstrar.",
        expected_end="Rolamentos que são exatamente o desejado encerram o ensaio após {time} {unit}"
        " em média, pois uma falha a mais o encerra.",
        chance="Chance de aprovação",
        true_ratio="vida real/desejada",
        passes="aprovados %",
        ends_after="termina após {unit}",
        other_shape="Se a forma for outra",
        shape_head="forma",
        shown_with="demonstrada com %",
        any_shape="O ensaio dura tanto quanto a vida: a forma não importa para o que ele"
        " demonstra.",
        trade="Equivalentes: rolamentos contra tempo de cada um ({unit})",
        bearings="rolamentos",
        total="todos, sem falha",
        allowed=("até {count} falha", "até {count} falhas"),
        no_failure="sem falha",
        precision="Com que precisão um ensaio diz {quantity}",
        known_to="desejado: limites de {confidence} % a um fator de {ratio} em metade dos ensaios",
        expected="esperado: forma {shape}, {quantity} de {life} {unit}",
        expected_multiples="esperado: forma {shape}; os tempos são múltiplos de {quantity}",
        one="{bearings} rolamentos, {failures} falhas: os limites de {confidence} % de {quantity}"
        " ficam a um fator de {ratio} em metade dos ensaios, e de {rarely} ou mais em um de dez.",
        several="{bearings} rolamentos ensaiados até que todos falhem levam {time} {unit}.",
        sudden_saves="A morte súbita em {groups} grupos de {size} é tão precisa com {failures}"
        " falhas, e termina após {time} {unit}; ela gasta {bearings} rolamentos.",
        table="Ensaios igualmente precisos",
        tests="Ensaios",
        groups="bancadas",
        failures="falhas",
        ratio="fator",
        rarely="1 em 10",
        shape_ratio="da forma",
        ends="dura {unit}",
        from_to="(90 %)",
        bearing_time="rolamento·{unit}",
        rig_time="bancada·{unit}",
        all_fail="todos falham",
        part_fails="{percent} % falham",
        sudden="morte súbita, {size} cada",
        legend="Fator: entre os limites, em metade dos ensaios; 1 em 10: superado por um ensaio de"
        " dez; da forma: entre os limites da forma. Dura: média, e entre o que 90 %"
        " terminam, todas as bancadas ao mesmo tempo. {samples} ensaios sorteados, semente {seed}.",
        working="Sorteando ensaios …",
    ),
}
