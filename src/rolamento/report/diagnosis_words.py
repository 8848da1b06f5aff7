"""What the page of a diagnosis says, by language; sentences by the engine's names of reasons."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rolamento.vibration.diagnosis import Component
    from rolamento.vibration.diagnosis.record import Verdict

__all__ = ["DIAGNOSIS_WORDS", "DiagnosisWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagnosisWords:
    """The words of one language; `{…}` are filled in by the one who says it.

    subjects begin a sentence, parts stand in tables, the_parts within a sentence.
    """

    subjects: Mapping[Component, str]
    parts: Mapping[Component, str]
    the_parts: Mapping[Component, str]
    all_of: str
    damaged: str
    one_line: str
    line_and_multiple: str
    line_and_multiples: str
    chance: str
    chance_below: str
    nothing_found: str
    untested: str
    no_verdict: str
    no_change: str

    bearing: str
    inside: str
    shaft: str
    speed: str
    outer_speed: str
    signal: str
    samples: str
    of_part: str
    indicators: str
    search: str
    searched: str

    table: str
    heads: tuple[str, ...]
    verdicts: Mapping[Verdict, str]
    legend: str

    why: str
    reason: Mapping[str, str]
    strongest: str
    carries: Mapping[str, str]
    sides: tuple[str, str]
    notes: str
    note: Mapping[str, str]

    reading: str


_ENGLISH: Final = DiagnosisWords(
    subjects={
        "outer_race": "The outer race",
        "inner_race": "The inner race",
        "ball": "A ball",
        "cage": "The cage",
    },
    parts={
        "outer_race": "outer race",
        "inner_race": "inner race",
        "ball": "ball",
        "cage": "cage",
    },
    the_parts={
        "outer_race": "the outer race",
        "inner_race": "the inner race",
        "ball": "the balls",
        "cage": "the cage",
    },
    all_of="{list} and {last}",
    damaged="{subject} is damaged: {lines}. Probability that a sound bearing looks like this:"
    " {chance}.",
    one_line="a line at {frequency} Hz",
    line_and_multiple="lines at {frequency} Hz and 1 multiple",
    line_and_multiples="lines at {frequency} Hz and {count} multiples",
    chance="at most {number}",
    chance_below="below {number}",
    nothing_found="Nothing found: no lines of {parts} stand out of the noise more than chance"
    " explains.",
    untested="Not tested: {parts}.",
    no_verdict="No verdict: this signal does not tell of any part of the bearing.",
    no_change="No verdict: the signal does not change.",
    bearing="bearing",
    inside="{name}: {count} balls of {ball} mm on {pitch} mm, contact angle {angle}°",
    shaft="shaft",
    speed="{speed} rpm ({frequency} Hz)",
    outer_speed="outer ring {speed} rpm",
    signal="signal",
    samples="{duration} s at {rate} Hz, {turns} revolutions",
    of_part="first {duration} s: ",
    indicators="RMS {rms}{unit}, crest factor {crest}, kurtosis {kurtosis} (3 for noise)",
    search="search",
    searched="cage within {tolerance} % of its nominal speed; false alarms in at most {alarm} %"
    " of sound bearings",
    table="Parts",
    heads=("", "nominal Hz", "found", "off %", "evidence", "verdict", "band kHz"),
    verdicts={"fault": "damaged", "nothing_found": "nothing", "not_tested": "untested"},
    legend="Evidence: -log10 of the probability that a sound bearing gives as clear a finding, all"
    " {trials} trials counted; from {least} on a part counts as damaged. Band: where it rings most"
    " clearly. Ball: its damage strikes twice a turn.",
    why="Why",
    reason={
        "harmonics_above_noise": "At {multiples} times order {order} ({frequency} Hz) the squared"
        " envelope rises {levels} dB above the noise about it.",
        "sidebands": "Sidebands at a spacing of {spacing} orders{strongest}: the damage goes"
        " through the load as {carries}.",
        "band": "Clearest between {low} and {high} Hz.",
        "improbable_in_noise": "Without damage anything as clear has a probability {chance}, all"
        " {trials} trials counted.",
        "off_nominal": "{deviation} % {side} the nominal order.",
        "cage_agrees": "It tells of the same cage speed as {others}.",
        "cage_disagrees": "It tells of another cage speed than {others}: one of the two may have"
        " another cause.",
        "nothing_above_noise": "The best of {trials} trials is what noise gives with a probability"
        " of {probability}.",
        "no_order": "Its order is not given.",
        "hidden": "All its lines coincide with multiples of the shaft or of what else is known to"
        " turn, or with those of a fault that was found.",
        "record_too_short": "The record is too short to tell its lines from the shaft's.",
        "rate_too_low": "The sampling rate is too low for its frequency.",
    },
    strongest=", up to {level} dB above the noise",
    carries={"ball": "the cage carries the ball", "ring": "the ring turns"},
    sides=("above", "below"),
    notes="Notes",
    note={
        "few_revolutions": "The record holds {turns} revolutions of the shaft; with more, weaker"
        " faults can be told.",
        "one_band": "The sampling rate leaves one band for the modulations that are looked for; a"
        " higher one tells where a fault rings.",
        "not_a_certificate": "Nothing found is a verdict about this record: damage too weak for"
        " its noise stays unseen.",
        "weak_lines": "None of the multiples of a part said to be damaged stands out by itself:"
        " lines of another cause may lie nearby. Check the speed, the bearing, and the picture.",
        "inferred_inside": "The inside of this bearing is inferred from its ratings: other insides"
        " have other frequencies (see rolamento frequencies).",
    },
    reading="blocks of the signal",
)

_PORTUGUESE: Final = DiagnosisWords(
    subjects={
        "outer_race": "A pista externa",
        "inner_race": "A pista interna",
        "ball": "Uma esfera",
        "cage": "A gaiola",
    },
    parts={
        "outer_race": "pista externa",
        "inner_race": "pista interna",
        "ball": "esfera",
        "cage": "gaiola",
    },
    the_parts={
        "outer_race": "a pista externa",
        "inner_race": "a pista interna",
        "ball": "as esferas",
        "cage": "a gaiola",
    },
    all_of="{list} e {last}",
    damaged="{subject} está danificada: {lines}. Probabilidade de que um rolamento são se mostre"
    " assim: {chance}.",
    one_line="uma linha em {frequency} Hz",
    line_and_multiple="linhas em {frequency} Hz e 1 múltiplo",
    line_and_multiples="linhas em {frequency} Hz e {count} múltiplos",
    chance="no máximo {number}",
    chance_below="menor que {number}",
    nothing_found="Nada encontrado; examinadas: {parts}. Nenhuma linha se destaca do ruído além"
    " do que o acaso explica.",
    untested="Não foi possível testar: {parts}.",
    no_verdict="Sem veredito: este sinal nada diz de nenhuma parte do rolamento.",
    no_change="Sem veredito: o sinal não varia.",
    bearing="rolamento",
    inside="{name}: {count} esferas de {ball} mm em {pitch} mm, ângulo de contato {angle}°",
    shaft="eixo",
    speed="{speed} rpm ({frequency} Hz)",
    outer_speed="anel externo {speed} rpm",
    signal="sinal",
    samples="{duration} s a {rate} Hz, {turns} voltas",
    of_part="primeiros {duration} s: ",
    indicators="RMS {rms}{unit}, fator de crista {crest}, curtose {kurtosis} (3 no ruído)",
    search="busca",
    searched="gaiola a até {tolerance} % da rotação nominal; alarmes falsos em no máximo {alarm} %"
    " dos rolamentos sãos",
    table="Partes",
    heads=("", "nominal Hz", "achada", "desvio %", "evidência", "veredito", "faixa kHz"),
    verdicts={"fault": "danificada", "nothing_found": "nada", "not_tested": "sem teste"},
    legend="Evidência: -log10 da probabilidade de que um rolamento são dê um achado tão claro,"
    " contadas todas as {trials} tentativas; a partir de {least} a parte conta como danificada."
    " Faixa: onde ela soa mais clara. Esfera: seu dano bate duas vezes por volta.",
    why="Por quê",
    reason={
        "harmonics_above_noise": "Em {multiples} vezes a ordem {order} ({frequency} Hz) o envelope"
        " ao quadrado sobe {levels} dB acima do ruído em volta.",
        "sidebands": "Bandas laterais a um espaçamento de {spacing} ordens{strongest}: o dano"
        " atravessa a carga enquanto {carries}.",
        "band": "Mais clara entre {low} e {high} Hz.",
        "improbable_in_noise": "Sem dano, algo tão claro tem probabilidade {chance}, contadas"
        " todas as {trials} tentativas.",
        "off_nominal": "{deviation} % {side} da ordem nominal.",
        "cage_agrees": "Indica a mesma rotação da gaiola que {others}.",
        "cage_disagrees": "Indica outra rotação da gaiola que {others}: uma das duas pode ter"
        " outra causa.",
        "nothing_above_noise": "A melhor de {trials} tentativas é o que o ruído dá com"
        " probabilidade {probability}.",
        "no_order": "Sua ordem não é dada.",
        "hidden": "Todas as suas linhas coincidem com múltiplos do eixo ou de algo mais que se sabe"
        " que gira, ou com as de uma falha encontrada.",
        "record_too_short": "O registro é curto demais para separar suas linhas das do eixo.",
        "rate_too_low": "A taxa de amostragem é baixa demais para sua frequência.",
    },
    strongest=", até {level} dB acima do ruído",
    carries={"ball": "a gaiola leva a esfera", "ring": "o anel gira"},
    sides=("acima", "abaixo"),
    notes="Observações",
    note={
        "few_revolutions": "O registro tem {turns} voltas do eixo; com mais, falhas mais fracas"
        " podem ser percebidas.",
        "one_band": "A taxa de amostragem deixa uma só faixa para as modulações procuradas; uma"
        " maior diz onde a falha soa.",
        "not_a_certificate": "Nada encontrado é um veredito sobre este registro: um dano fraco"
        " demais para o seu ruído não se vê.",
        "weak_lines": "Nenhum dos múltiplos de uma parte dita danificada se destaca por si: pode"
        " haver por perto linhas de outra causa. Confira a rotação, o rolamento e a figura.",
        "inferred_inside": "O interior deste rolamento é inferido das suas capacidades: outros"
        " interiores têm outras frequências (veja rolamento frequencies).",
    },
    reading="blocos do sinal",
)

DIAGNOSIS_WORDS: Final[Mapping[str, DiagnosisWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
