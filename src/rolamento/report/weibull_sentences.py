"""What life tests and their plans say by the engine's names: notes, and advice without a result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.weibull import ADVICE, NOTES, PLAN_ADVICE

__all__ = ["said_advice", "said_note"]

_ADVICE: Final[Mapping[str, Mapping[str, str]]] = {
    "en": {
        "no_failures": "nothing failed. The test bounds the life from below only: with a shape"
        " from experience, --shape 1.5 say, the bounds tell how long at least the bearings live.",
        "one_failure": "one failure tells no shape. Take one from experience (--shape 1.5) or a"
        " range (--bayes 1..2.5), or test on.",
        "no_spread": "all failures could have come at one time, and no bearing ran longer: any"
        " steeper line fits better. Inspect more often, test on, or take a shape from experience"
        " (--shape 1.5).",
        "no_maximum": "the likelihood has no maximum. With three parameters it grows without bound"
        " as the location nears the first failure, or the failures are too few: take two."
        " With two, the inspections say that fewer fail as time goes on: look for a mixture of"
        " early failures and others.",
        "not_converged": "the search did not end; look for slips in the data.",
        "not_modelled": "exact times of failure beside inspected ones: such a test cannot be drawn"
        " again. Take --bounds likelihood-ratio or --bounds bootstrap-bca.",
        "too_large": "the test has too many bearings to be drawn again and again; take --bounds"
        " likelihood-ratio, which holds for so many.",
        "no_mean": "the mean of the shape does not exist for two failures, nor where the clock"
        " could have left so few: take the median.",
        "group_without_fit": "nothing failed in one of the groups, or its failures have no spread.",
        "not_shown": PLAN_ADVICE["not_shown"],
        "too_many_bearings": PLAN_ADVICE["too_many_bearings"],
        "too_long": PLAN_ADVICE["too_long"],
        "too_few_failures": PLAN_ADVICE["too_few_failures"],
        "too_many_failures": PLAN_ADVICE["too_many_failures"],
        "not_reached": PLAN_ADVICE["not_reached"],
    },
    "pt": {
        "no_failures": "nada falhou. O ensaio só limita a vida por baixo: com uma forma conhecida"
        " por experiência, --shape 1.5 por exemplo, os limites dizem quanto os rolamentos vivem no"
        " mínimo.",
        "one_failure": "uma falha não diz qual é a forma. Tome uma da experiência (--shape 1.5) ou"
        " uma faixa (--bayes 1..2.5), ou continue o ensaio.",
        "no_spread": "todas as falhas poderiam ter vindo ao mesmo tempo, e nenhum rolamento rodou"
        " mais: qualquer reta mais íngreme se ajusta melhor. Inspecione mais vezes, continue o"
        " ensaio ou tome uma forma da experiência (--shape 1.5).",
        "no_maximum": "a verossimilhança não tem máximo. Com três parâmetros ela cresce sem limite"
        " quando a localização se aproxima da primeira falha, ou as falhas são poucas: tome dois."
        " Com dois, as inspeções dizem que com o tempo menos falham: procure uma mistura de falhas"
        " precoces e outras.",
        "not_converged": "a busca não terminou; procure erros nos dados.",
        "not_modelled": "tempos exatos de falha ao lado de inspecionados: um ensaio assim não pode"
        " ser sorteado de novo. Tome --bounds likelihood-ratio ou --bounds bootstrap-bca.",
        "too_large": "o ensaio tem rolamentos demais para ser sorteado muitas vezes; tome --bounds"
        " likelihood-ratio, que vale para tantos.",
        "no_mean": "a média da forma não existe com duas falhas, nem onde o relógio poderia ter"
        " deixado tão poucas: tome a mediana.",
        "group_without_fit": "nada falhou num dos grupos, ou suas falhas não têm dispersão.",
        "not_shown": "Tantos rolamentos por tanto tempo não demonstram a vida com esta confiança."
        " Ensaie mais, ou por mais tempo; ou aceite menos falhas.",
        "too_many_bearings": "Seriam precisos mais rolamentos do que alguém ensaia. Ensaie-os por"
        " mais tempo, peça menos confiança ou uma vida que menos deles precisem alcançar.",
        "too_long": "Levaria mais tempo do que se pode dizer. Ensaie mais rolamentos ou peça menos"
        " confiança.",
        "too_few_failures": "Uma falha não diz qual é a forma, e limites não saem dela: planeje"
        " duas.",
        "too_many_failures": "Seriam precisas mais falhas do que aqui se planejam. Peça uma razão"
        " maior entre os limites, ou menos confiança.",
        "not_reached": "Tantos rolamentos não aproximam os limites a esse ponto, mesmo que todos"
        " falhem. Ensaie mais deles ou peça uma razão maior.",
    },
}

_PORTUGUESE_NOTES: Final[Mapping[str, str]] = {
    "location_at_zero": "A verossimilhança é máxima sem um tempo livre de falhas: estes são os"
    " números de dois parâmetros.",
    "likelihood_unbounded": "Quando a localização se aproxima da primeira falha, a verossimilhança"
    " cresce sem limite, o que não diz nada; toma-se o máximo antes disso.",
    "few_failures": "Menos de cinco falhas: forma e vida mal são conhecidas; veja os limites.",
    "suspensions_early": "A maioria das suspensões vem antes da primeira falha: os postos só"
    " conhecem delas a ordem; a máxima verossimilhança usa os tempos.",
    "censoring_modelled": "As suspensões de rolamentos que falharam, que não foram vistas, são"
    " sorteadas das que foram (Kaplan-Meier); os limites são aproximados.",
    "inspections_shared": "Supõe-se que todos os rolamentos foram inspecionados em todos os tempos"
    " dos dados; os limites são aproximados.",
    "many_without_fit": "Mais de um décimo dos ensaios sorteados não tem ajuste e fica de fora: os"
    " limites só valem para ensaios que o têm, e são estreitos demais.",
    "large_sample_method": "Este método é para muitas falhas: com poucas seus limites são muito"
    " estreitos.",
    "approximate": "Não se conhece método exato para isto; os limites são aproximados.",
    "group_without_failures": "Nada falhou num dos grupos: ele não tem forma e fica de fora onde só"
    " se comparam formas.",
}


def said_advice(code: str, language: str) -> str:
    """Say what a person can do, by the code of a status; the engine's words for a new one."""
    known = _ADVICE.get(language, _ADVICE["en"])
    return known.get(code) or ADVICE.get(code, code)


def said_note(name: str, language: str) -> str:
    """Say a note, by its name."""
    said = _PORTUGUESE_NOTES.get(name) if language == "pt" else None
    return said or NOTES.get(name, name)
