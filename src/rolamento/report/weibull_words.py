"""What the page of a life test says, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["WEIBULL_WORDS", "WeibullWords", "counted"]

Forms = tuple[str, str]
"""For one, and for any other number."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WeibullWords:
    """The words of one language; `{…}` are filled in by the one who says it.

    schemes, fits, bound_methods, priors and hypotheses are by the engine's names.
    """

    # head
    untitled: str
    data: str
    source: str
    bearings: Forms
    failed: Forms
    suspended: Forms
    none_failed: str
    from_to: str
    groups: str
    schemes: Mapping[str, str]

    # quantities
    shape: str
    scale: str
    mean: str
    reliability_at: str

    # tables
    fit: str
    fitted_by: str
    fits: Mapping[str, str]
    location: str
    bounds: str
    estimate: str
    low: str
    high: str
    apart: str
    at_least: str
    at_most: str
    bounds_by: str
    bound_methods: Mapping[str, str]
    drawn: str
    dropped: str
    assumed: str
    assumed_shape: str
    prior: str
    priors: Mapping[str, str]
    median: str

    # calculated life
    calculated: str
    observed_ratio: str
    p_value: str
    contradicted: str
    verdicts: Mapping[str, str]
    calculated_legend: str

    # what the data say
    life_two_sided: str
    life_at_least: str
    life_at_most: str
    shape_below: str
    shape_above: str
    shape_open: str
    shape_given: str
    rating_inside: str
    rating_outside: str
    contradict: Mapping[str, str]
    none_contradict: str
    nothing: str

    # groups against each other
    comparison: str
    hypotheses: Mapping[str, str]
    differ: str
    do_not_differ: str
    ratio: str
    ratio_own_shapes: str
    no_ratio: str
    not_compared: str

    notes: str
    no_ranks: str
    too_many_for_ranks: str
    passed_over: str
    working: str
    written: str


WEIBULL_WORDS: Final[Mapping[str, WeibullWords]] = {
    "en": WeibullWords(
        untitled="Life test",
        data="data",
        source="source",
        bearings=("{count} bearing", "{count} bearings"),
        failed=("{count} failed", "{count} failed"),
        suspended=("{count} suspended", "{count} suspended"),
        none_failed="none failed",
        from_to="{first} to {last} {unit}",
        groups="{count} groups",
        schemes={
            "complete": "all failed",
            "type_ii": "stopped at the last failure",
            "sudden_death": "rigs stopped at their first failure",
            "type_i": "stopped by the clock, all at one time",
            "multiple": "suspended at several times",
            "interval": "failures found at inspections",
        },
        shape="shape β",
        scale="scale η",
        mean="mean",
        reliability_at="R({time} {unit}) %",
        fit="Fit (lives in {unit})",
        fitted_by="fitted by",
        fits={
            "maximum_likelihood": "maximum likelihood",
            "unbiased": "  its shape unbiased",
            "rank_regression_x_on_y": "rank regression, X on Y",
            "rank_regression_y_on_x": "rank regression, Y on X",
            "three_parameter": "three parameters",
            "fixed_shape": "known shape",
        },
        location="nothing fails before {location} {unit}; the scale counts from there",
        bounds="{confidence} % bounds",
        estimate="estimate",
        low="from",
        high="to",
        apart="to/from",
        at_least="at least",
        at_most="at most",
        bounds_by="Bounds of {confidence} % by {method}{drawn}.",
        bound_methods={
            "pivotal": "pivots of maximum likelihood",
            "calibrated_likelihood_ratio": "calibrated likelihood ratio",
            "likelihood_ratio": "likelihood ratio",
            "fisher": "Fisher information",
            "parametric_percentile": "parametric bootstrap, percentiles",
            "parametric_bias_corrected": "parametric bootstrap, bias-corrected",
            "bootstrap_percentile": "bootstrap, percentiles",
            "bootstrap_bca": "bootstrap, bias-corrected and accelerated",
            "fixed_shape": "chi-square at the known shape",
        },
        drawn=", {samples} tests drawn, seed {seed}",
        dropped=", {dropped} of them without a fit",
        assumed="If the shape were known ({confidence} % bounds)",
        assumed_shape="shape β",
        prior="With what was known before: shape {low} to {high} with {probability} %, {kind}",
        priors={"lognormal": "lognormal", "uniform": "uniform"},
        median="median",
        calculated="Against calculated life ({quantity}, {confidence} %)",
        observed_ratio="observed/calculated",
        p_value="p",
        contradicted="contradicted",
        verdicts={"": "no", "longer": "yes: longer", "shorter": "yes: shorter"},
        calculated_legend="p: how often a test would lie so far from the calculated life, were it"
        " true.",
        life_two_sided="With {confidence} % confidence {share} % of such bearings live {lower}"
        " {unit} or longer. {quantity} is known to a factor of {apart}: {lower} to {upper} {unit}.",
        life_at_least="With {confidence} % confidence {share} % of such bearings live {lower}"
        " {unit} or longer.",
        life_at_most="With {confidence} % confidence no more than {share} % of such bearings live"
        " longer than {upper} {unit}.",
        shape_below="Shape below 1: the longer they have run, the fewer fail, as where some were"
        " bad from the start.",
        shape_above="Shape above 1: the longer they have run, the more fail, as by fatigue and"
        " wear.",
        shape_open="Shape 1 lies within the bounds: whether more or fewer fail as time goes on,"
        " these data do not tell.",
        shape_given="All of this is as good as the shape of {shape} that was given.",
        rating_inside="10/9, the shape of the rating standards, lies within the bounds.",
        rating_outside="10/9, the shape of the rating standards, lies outside the bounds.",
        contradict={
            "longer": "The data contradict {names}: the bearings live longer.",
            "shorter": "The data contradict {names}: the bearings live shorter.",
        },
        none_contradict="The data contradict none of the calculated lives given. That is no proof"
        " of any: few failures contradict little.",
        nothing="No result: {advice}",
        comparison="Groups against each other",
        hypotheses={
            "common_shape": "one shape",
            "same_life": "one life, at one shape",
            "homogeneous": "one shape and one life",
        },
        differ="The groups differ: {hypothesis} has p = {p}.",
        do_not_differ="The data do not tell the groups apart ({hypothesis}: p = {p}).",
        ratio="{quantity} of {first} over that of {second}: {ratio} (from {lower} to {upper} with"
        " {confidence} %, at one shape of {shape}); p = {p} of equal lives.",
        ratio_own_shapes="{quantity} of {first} over that of {second}: {ratio} (from {lower} to"
        " {upper} with {confidence} %, each at its own shape); p = {p} of equal lives.",
        no_ratio="{quantity} of {first} over that of {second}: no result. {advice}",
        not_compared="Failures were found at inspections: the groups are not compared.",
        notes="Notes",
        no_ranks="Failures were found at inspections: there is no rank regression and there are no"
        " points.",
        passed_over="Columns of the table that were passed over: {columns}.",
        too_many_for_ranks="So many failures get no ranks: there is no rank regression and there"
        " are no points.",
        working="Drawing tests and fitting them …",
        written="Wrote {path}",
    ),
    "pt": WeibullWords(
        untitled="Ensaio de vida",
        data="dados",
        source="fonte",
        bearings=("{count} rolamento", "{count} rolamentos"),
        failed=("{count} falhou", "{count} falharam"),
        suspended=("{count} suspenso", "{count} suspensos"),
        none_failed="nenhum falhou",
        from_to="{first} a {last} {unit}",
        groups="{count} grupos",
        schemes={
            "complete": "todos falharam",
            "type_ii": "encerrado na última falha",
            "sudden_death": "bancadas encerradas na primeira falha (morte súbita)",
            "type_i": "encerrado pelo relógio, todos ao mesmo tempo",
            "multiple": "suspensos em tempos diversos",
            "interval": "falhas encontradas em inspeções",
        },
        shape="forma β",
        scale="escala η",
        mean="média",
        reliability_at="R({time} {unit}) %",
        fit="Ajuste (vidas em {unit})",
        fitted_by="ajustado por",
        fits={
            "maximum_likelihood": "máxima verossimilhança",
            "unbiased": "  com a forma sem viés",
            "rank_regression_x_on_y": "reg. de postos, X em Y",
            "rank_regression_y_on_x": "reg. de postos, Y em X",
            "three_parameter": "três parâmetros",
            "fixed_shape": "forma conhecida",
        },
        location="nada falha antes de {location} {unit}; a escala conta a partir daí",
        bounds="Limites de {confidence} %",
        estimate="estimativa",
        low="de",
        high="a",
        apart="a/de",
        at_least="no mínimo",
        at_most="no máximo",
        bounds_by="Limites de {confidence} % por {method}{drawn}.",
        bound_methods={
            "pivotal": "pivôs da máxima verossimilhança",
            "calibrated_likelihood_ratio": "razão de verossimilhança calibrada",
            "likelihood_ratio": "razão de verossimilhança",
            "fisher": "informação de Fisher",
            "parametric_percentile": "bootstrap paramétrico, percentis",
            "parametric_bias_corrected": "bootstrap paramétrico, com correção de viés",
            "bootstrap_percentile": "bootstrap, percentis",
            "bootstrap_bca": "bootstrap, com correção de viés e aceleração",
            "fixed_shape": "qui-quadrado com a forma conhecida",
        },
        drawn=", {samples} ensaios sorteados, semente {seed}",
        dropped=", {dropped} deles sem ajuste",
        assumed="Se a forma fosse conhecida (limites de {confidence} %)",
        assumed_shape="forma β",
        prior="Com o que já se sabia: forma de {low} a {high} com {probability} %, {kind}",
        priors={"lognormal": "lognormal", "uniform": "uniforme"},
        median="mediana",
        calculated="Diante da vida calculada ({quantity}, {confidence} %)",
        observed_ratio="observada/calculada",
        p_value="p",
        contradicted="contradita",
        verdicts={"": "não", "longer": "sim: mais longa", "shorter": "sim: mais curta"},
        calculated_legend="p: com que frequência um ensaio ficaria tão longe da vida calculada, se"
        " ela fosse verdadeira.",
        life_two_sided="Com {confidence} % de confiança, {share} % destes rolamentos vivem {lower}"
        " {unit} ou mais. {quantity} é conhecida a menos de um fator de {apart}: de {lower} a"
        " {upper} {unit}.",
        life_at_least="Com {confidence} % de confiança, {share} % destes rolamentos vivem {lower}"
        " {unit} ou mais.",
        life_at_most="Com {confidence} % de confiança, não mais que {share} % destes rolamentos"
        " vivem mais que {upper} {unit}.",
        shape_below="Forma abaixo de 1: quanto mais já funcionaram, menos falham, como quando"
        " alguns eram ruins desde o início.",
        shape_above="Forma acima de 1: quanto mais já funcionaram, mais falham, como por fadiga e"
        " desgaste.",
        shape_open="A forma 1 está entre os limites: se com o tempo falham mais ou menos, estes"
        " dados não dizem.",
        shape_given="Tudo isto vale tanto quanto a forma de {shape} que foi dada.",
        rating_inside="10/9, a forma das normas de capacidade de carga, está entre os limites.",
        rating_outside="10/9, a forma das normas de capacidade de carga, está fora dos limites.",
        contradict={
            "longer": "Os dados contradizem {names}: os rolamentos vivem mais.",
            "shorter": "Os dados contradizem {names}: os rolamentos vivem menos.",
        },
        none_contradict="Os dados não contradizem nenhuma das vidas calculadas que foram dadas."
        " Isso não prova nenhuma delas: poucas falhas contradizem pouco.",
        nothing="Sem resultado: {advice}",
        comparison="Os grupos entre si",
        hypotheses={
            "common_shape": "uma só forma",
            "same_life": "uma só vida, com uma só forma",
            "homogeneous": "uma só forma e uma só vida",
        },
        differ="Os grupos diferem: {hypothesis} tem p = {p}.",
        do_not_differ="Os dados não distinguem os grupos ({hypothesis}: p = {p}).",
        ratio="{quantity} de {first} sobre a de {second}: {ratio} (de {lower} a {upper} com"
        " {confidence} %, com uma só forma de {shape}); p = {p} de vidas iguais.",
        ratio_own_shapes="{quantity} de {first} sobre a de {second}: {ratio} (de {lower} a {upper}"
        " com {confidence} %, cada um com sua forma); p = {p} de vidas iguais.",
        no_ratio="{quantity} de {first} sobre a de {second}: sem resultado. {advice}",
        not_compared="As falhas foram encontradas em inspeções: os grupos não são comparados.",
        notes="Observações",
        no_ranks="As falhas foram encontradas em inspeções: não há regressão de postos nem pontos.",
        passed_over="Colunas da tabela que não foram lidas: {columns}.",
        too_many_for_ranks="Tantas falhas não recebem postos: não há regressão de postos nem"
        " pontos.",
        working="Sorteando ensaios e ajustando-os …",
        written="{path} gravado",
    ),
}


def counted(forms: Forms, count: int, shown: str) -> str:
    """Say how many, in the form that goes with the number."""
    return forms[count != 1].format(count=shown)
