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

    subjects begin a sentence, parts stand in tables, the_parts within a sentence. Of two words, one
    is for one of a kind, the other for more; one_below: the number below which it counts as one.
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
    other_lines: str
    stronger_lines: str
    untested: str
    no_verdict: str
    no_verdict_without: str
    rest: str
    too_short: str
    too_slow: str
    no_change: str
    no_speed: str

    bearing: str
    inside: str
    frequencies: str
    nominal: str
    loaded: str
    angles: tuple[str, str]
    over_balls: str
    shaft: str
    speed: str
    speed_range: str
    speed_source: Mapping[str, str]
    outer_speed: str
    signal: str
    samples: str
    of_part: str
    indicators: str
    search: str
    searched: str
    expected: tuple[str, str]
    wider: str

    table: str
    heads: tuple[str, ...]
    verdicts: Mapping[Verdict, str]
    legend: str

    why: str
    reason: Mapping[str, str]
    one_harmonic: str
    at_expected: str
    order_words: tuple[str, str]
    one_below: float
    strongest: str
    carries: Mapping[str, str]
    sides: tuple[str, str]
    notes: str
    note: Mapping[str, str]
    unexplained: tuple[str, str]
    unexplained_line: str
    more_lines: str
    lowest_line: tuple[str, str]
    at_speed: str
    row: str

    reading: str
    tracking: str


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
    other_lines="Other lines do: see the notes.",
    stronger_lines="Stronger lines fit no part of this bearing: check speed and bearing.",
    untested="Not tested: {parts}.",
    no_verdict="No verdict: this signal does not tell of any part of the bearing.",
    no_verdict_without="No verdict: not tested: {parts}.",
    rest="Nothing stands out of the noise for: {parts}.",
    too_slow="No verdict: the shaft is too slow for this sampling rate. The longest stretch that is"
    " judged at once, {duration} s, spans {turns} revolutions; below {least} nothing can be told of"
    " any race. Give the signal at a rate at least {times} times lower.",
    too_short="No verdict: the record is too short. It spans {turns} revolutions of the shaft,"
    " {duration} s; below {least} revolutions, {seconds} s, nothing can be told of any race.",
    no_change="No verdict: the signal does not change.",
    no_speed="No verdict: the speed was not found in the vibration, and at a steady one nothing"
    " stands out of the noise.",
    bearing="bearing",
    inside="{name}: {count} balls of {ball} mm on {pitch} mm",
    frequencies="frequencies",
    nominal="of the geometry, contact angle {angle}°",
    loaded="of the loaded bearing, mean contact angle {angle}; cage order {cage}{range}",
    angles=("{inner}°", "{inner}° (inner), {outer}° (outer)"),
    over_balls=", {least} to {most} over the balls",
    shaft="shaft",
    speed="{speed} rpm ({frequency} Hz)",
    speed_range="mean {speed} rpm ({frequency} Hz), from {least} to {most} rpm",
    speed_source={
        "given": "as given",
        "file": "by the signal's file",
        "case": "of the case",
        "channel": "of the channel {channel}",
        "pulses": "by the pulses of the channel {channel}, {pulses} a revolution",
        "vibration": "found in the vibration within {within} % of {nominal} rpm",
        "lost": "taken as steady: it was not found in the vibration",
    },
    outer_speed="outer ring {speed} rpm",
    signal="signal",
    samples="{duration} s at {rate} Hz, {turns} revolutions",
    of_part="first {duration} s: ",
    indicators="RMS {rms}{unit}, crest factor {crest}, kurtosis {kurtosis} (3 for noise)",
    search="search",
    searched="cage within {tolerance} % of {expected}{wider}; false alarms in at most {alarm} %"
    " of sound bearings",
    expected=("its nominal speed", "its speed under load"),
    wider=", wider than --slip to cover the range over the balls",
    table="Parts",
    heads=("", "expected Hz", "found", "off %", "evidence", "verdict", "band kHz"),
    verdicts={"fault": "damaged", "nothing_found": "nothing", "not_tested": "untested"},
    legend="Evidence: -log10 of the probability that a sound bearing gives as clear a finding, all"
    " {trials} trials counted; from {least} on a part counts as damaged. Band: where it rings most"
    " clearly. Ball: its damage strikes twice a turn.",
    why="Why",
    reason={
        "harmonics_above_noise": "At {multiples} times order {order} ({frequency} Hz) the squared"
        " envelope rises {levels} dB above the noise about it.",
        "sidebands": "Sidebands at a spacing of {spacing} {orders}{strongest}: the damage goes"
        " through the load as {carries}.",
        "band": "Clearest between {low} and {high} Hz.",
        "improbable_in_noise": "Without damage anything as clear has a probability {chance}, all"
        " {trials} trials counted.",
        "off_nominal": "{deviation} % {side} the expected order.",
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
        "no_change": "The signal does not change: most samples only repeat the one before.",
        "at_edge": "It lies at the edge of what the allowed slip reaches, and may go on beyond:"
        " check the speed, the bearing and the contact angle.",
        "carries_the_ball": "Its lines stand out as those of the ball do: a damaged ball goes in"
        " and out of the load once in each turn of the cage. Nothing more tells of the cage.",
        "weak_beside_cage": "What stands out at its lines is weak beside the cage, whose multiples"
        " lie on them or near. Nothing more tells of the part.",
    },
    one_harmonic="At order {order} ({frequency} Hz) the squared envelope rises {levels} dB above"
    " the noise about it.",
    at_expected="At the expected order.",
    order_words=("order", "orders"),
    one_below=0.0,
    strongest=", up to {level} dB above the noise",
    carries={"ball": "the cage carries the ball", "ring": "the ring turns"},
    sides=("above", "below"),
    notes="Notes",
    note={
        "few_revolutions": "The record holds {turns} revolutions of the shaft; with more, weaker"
        " faults can be told.",
        "one_band": "The sampling rate leaves one band for the modulations that are looked for; a"
        " higher one tells where a fault rings.",
        "still_blocks": "Stretches of the record that hardly change were left out; used: {blocks}.",
        "repeated_data": "The record begins anew, sample by sample the same: copies hold no noise"
        " of their own, and the probabilities do not hold. Give one copy alone.",
        "not_a_certificate": "Nothing found is a verdict about this record: damage too weak for"
        " its noise stays unseen.",
        "weak_lines": "None of the multiples of a part said to be damaged stands out by itself:"
        " lines of another cause may lie nearby. Check the speed, the bearing, and the picture.",
        "inferred_inside": "The inside of this bearing is inferred from its ratings: other insides"
        " have other frequencies (see rolamento frequencies).",
        "speed_not_found": "From {start} to {end} s the shaft does not stand out of the"
        " vibration's noise, within {within} % of {nominal} rpm: the speed was taken as steady. If"
        " it was not, damage may stay unseen. Give a measured speed, or a part of the record.",
        "no_loaded_frequencies": "The frequencies that were looked for are those of the geometry."
        " {reason}",
        "range_not_covered": "Under this load the orders of some balls are more than"
        " {tolerance} % off: those were not looked for.",
        "other_rows": "The orders of {rows} are others, and were not looked for: allow more slip,"
        " or give that row as a bearing of its own.",
        "unexplained_lines": "The envelope's spectrum has lines that no part of this bearing and no"
        " multiple of the shaft explains.",
    },
    unexplained=(
        "No part of this bearing and no multiple of the shaft explains a line that stands out of"
        " the envelope's spectrum: {lines}. Check the speed and the bearing.",
        "No part of this bearing and no multiple of the shaft explains lines that stand out of the"
        " envelope's spectrum: {lines}. Check the speed and the bearing.",
    ),
    unexplained_line="{frequency} Hz (order {order}), {level} dB above the noise between {low} and"
    " {high} Hz",
    more_lines="{count} more",
    lowest_line=(
        "It would be the lowest line of: {parts}.",
        "The first would be the lowest line of: {parts}.",
    ),
    at_speed="{part} at {speed} rpm",
    row="row {row}",
    reading="blocks of the signal",
    tracking="blocks of the signal, for the speed",
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
    damaged="{subject} está danificada: {lines}. Probabilidade de que um rolamento sadio se mostre"
    " assim: {chance}.",
    one_line="uma linha em {frequency} Hz",
    line_and_multiple="linhas em {frequency} Hz e 1 múltiplo",
    line_and_multiples="linhas em {frequency} Hz e {count} múltiplos",
    chance="no máximo {number}",
    chance_below="menor que {number}",
    nothing_found="Nada encontrado; examinadas: {parts}. Nenhuma linha se destaca do ruído além"
    " do que o acaso explica.",
    other_lines="Outras linhas se destacam: veja as observações.",
    stronger_lines="Linhas mais fortes não são de nenhuma peça deste rolamento: confira a rotação"
    " e o rolamento.",
    untested="Não foi possível testar: {parts}.",
    no_verdict="Sem veredito: este sinal nada diz de nenhuma parte do rolamento.",
    no_verdict_without="Sem veredito: não foi possível testar: {parts}.",
    rest="Nada se destaca do ruído em: {parts}.",
    too_slow="Sem veredito: o eixo é lento demais para esta taxa de amostragem. O trecho mais longo"
    " julgado de uma vez, {duration} s, abrange {turns} voltas; abaixo de {least} nada se pode"
    " dizer de nenhuma pista. Dê o sinal a uma taxa pelo menos {times} vezes menor.",
    too_short="Sem veredito: o registro é curto demais. Ele abrange {turns} voltas do eixo,"
    " {duration} s; abaixo de {least} voltas, {seconds} s, nada se pode dizer de nenhuma pista.",
    no_change="Sem veredito: o sinal não varia.",
    no_speed="Sem veredito: a rotação não foi encontrada na vibração, e a uma constante nada"
    " se destaca do ruído.",
    bearing="rolamento",
    inside="{name}: {count} esferas de {ball} mm em {pitch} mm",
    frequencies="frequências",
    nominal="da geometria, ângulo de contato {angle}°",
    loaded="do rolamento sob carga, ângulo de contato médio {angle}; ordem da gaiola {cage}{range}",
    angles=("{inner}°", "{inner}° (interno), {outer}° (externo)"),
    over_balls=", de {least} a {most} entre as esferas",
    shaft="eixo",
    speed="{speed} rpm ({frequency} Hz)",
    speed_range="em média {speed} rpm ({frequency} Hz), de {least} a {most} rpm",
    speed_source={
        "given": "como dada",
        "file": "pelo arquivo do sinal",
        "case": "do caso",
        "channel": "do canal {channel}",
        "pulses": "pelos pulsos do canal {channel}, {pulses} por volta",
        "vibration": "encontrada na vibração a até {within} % de {nominal} rpm",
        "lost": "tomada como constante: não foi encontrada na vibração",
    },
    outer_speed="anel externo {speed} rpm",
    signal="sinal",
    samples="{duration} s a {rate} Hz, {turns} voltas",
    of_part="primeiros {duration} s: ",
    indicators="RMS {rms}{unit}, fator de crista {crest}, curtose {kurtosis} (3 no ruído)",
    search="busca",
    searched="gaiola a até {tolerance} % {expected}{wider}; alarmes falsos em no máximo"
    " {alarm} % dos rolamentos sadios",
    expected=("da rotação nominal", "da sua rotação sob carga"),
    wider=", mais do que --slip, para cobrir a variação entre as esferas",
    table="Partes",
    heads=("", "esperada Hz", "achada", "desvio %", "evidência", "veredito", "faixa kHz"),
    verdicts={"fault": "danificada", "nothing_found": "nada", "not_tested": "sem teste"},
    legend="Evidência: -log10 da probabilidade de que um rolamento sadio dê um achado tão claro,"
    " contadas todas as {trials} tentativas; a partir de {least} a parte conta como danificada."
    " Faixa: onde ela soa mais clara. Esfera: seu dano bate duas vezes por volta.",
    why="Por quê",
    reason={
        "harmonics_above_noise": "Em {multiples} vezes a ordem {order} ({frequency} Hz) o envelope"
        " ao quadrado sobe {levels} dB acima do ruído em volta.",
        "sidebands": "Bandas laterais a um espaçamento de {spacing} {orders}{strongest}: o dano"
        " atravessa a carga enquanto {carries}.",
        "band": "Mais clara entre {low} e {high} Hz.",
        "improbable_in_noise": "Sem dano, algo tão claro tem probabilidade {chance}, contadas"
        " todas as {trials} tentativas.",
        "off_nominal": "{deviation} % {side} da ordem esperada.",
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
        "no_change": "O sinal não varia: a maioria das amostras só repete a anterior.",
        "at_edge": "Fica na borda do que o escorregamento permitido alcança, e pode seguir além:"
        " confira a rotação, o rolamento e o ângulo de contato.",
        "carries_the_ball": "Suas linhas se destacam como as da esfera: uma esfera danificada entra"
        " na carga e sai dela uma vez por volta da gaiola. Nada mais fala da gaiola.",
        "weak_beside_cage": "O que se destaca em suas linhas é fraco ao lado da gaiola, cujos"
        " múltiplos caem nelas ou perto. Nada mais fala da peça.",
    },
    one_harmonic="Na ordem {order} ({frequency} Hz) o envelope ao quadrado sobe {levels} dB acima"
    " do ruído em volta.",
    at_expected="Na ordem esperada.",
    order_words=("ordem", "ordens"),
    one_below=2.0,
    strongest=", até {level} dB acima do ruído",
    carries={"ball": "a gaiola leva a esfera", "ring": "o anel gira"},
    sides=("acima", "abaixo"),
    notes="Observações",
    note={
        "few_revolutions": "O registro tem {turns} voltas do eixo; com mais, falhas mais fracas"
        " podem ser percebidas.",
        "one_band": "A taxa de amostragem deixa uma só faixa para as modulações procuradas; uma"
        " maior diz onde a falha soa.",
        "still_blocks": "Trechos do registro que quase não variam ficaram de fora; usados:"
        " {blocks}.",
        "repeated_data": "O registro recomeça, amostra por amostra igual: cópias não têm ruído"
        " próprio, e as probabilidades não valem. Dê uma só cópia.",
        "not_a_certificate": "Nada encontrado é um veredito sobre este registro: um dano fraco"
        " demais para o seu ruído não se vê.",
        "weak_lines": "Nenhum dos múltiplos de uma parte dita danificada se destaca por si: pode"
        " haver por perto linhas de outra causa. Confira a rotação, o rolamento e a figura.",
        "inferred_inside": "O interior deste rolamento é inferido das suas capacidades: outros"
        " interiores têm outras frequências (veja rolamento frequencies).",
        "speed_not_found": "De {start} a {end} s o eixo não se destaca do ruído da vibração, a até"
        " {within} % de {nominal} rpm: a rotação foi tomada como constante. Se não era, um dano"
        " pode passar despercebido. Dê uma rotação medida, ou uma parte do registro.",
        "no_loaded_frequencies": "As frequências procuradas são as da geometria. {reason}",
        "range_not_covered": "Sob esta carga as ordens de algumas esferas se afastam mais de"
        " {tolerance} %: essas não foram procuradas.",
        "other_rows": "As ordens de {rows} são outras e não foram procuradas: permita mais"
        " escorregamento, ou dê essa carreira como um rolamento próprio.",
        "unexplained_lines": "O espectro do envelope tem linhas que nenhuma parte deste rolamento e"
        " nenhum múltiplo do eixo explicam.",
    },
    unexplained=(
        "Nenhuma parte deste rolamento e nenhum múltiplo do eixo explicam uma linha que se destaca"
        " no espectro do envelope: {lines}. Confira a rotação e o rolamento.",
        "Nenhuma parte deste rolamento e nenhum múltiplo do eixo explicam linhas que se destacam no"
        " espectro do envelope: {lines}. Confira a rotação e o rolamento.",
    ),
    unexplained_line="{frequency} Hz (ordem {order}), {level} dB acima do ruído entre {low} e"
    " {high} Hz",
    more_lines="mais {count}",
    lowest_line=(
        "Seria a linha mais baixa de: {parts}.",
        "A primeira seria a linha mais baixa de: {parts}.",
    ),
    at_speed="{part} a {speed} rpm",
    row="fileira {row}",
    reading="blocos do sinal",
    tracking="blocos do sinal, para a rotação",
)

DIAGNOSIS_WORDS: Final[Mapping[str, DiagnosisWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
