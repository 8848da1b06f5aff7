"""What the page of a diagnosis says, by language; sentences by the engine's names of reasons."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rolamento.vibration.diagnosis import Component
    from rolamento.vibration.diagnosis.record import Cause, Verdict

__all__ = ["DIAGNOSIS_WORDS", "DiagnosisWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagnosisWords:
    """The words of one language; `{…}` are filled in by the one who says it.

    subjects begin a sentence, parts stand in tables, the_parts within a sentence. Of two words, one
    is for one of a kind, the other for more; one_below: the number below which it counts as one;
    to_do: by grade, or what is not decided; worth: of a depth, by grade.
    """

    subjects: Mapping[Cause, str]
    parts: Mapping[Component, str]
    the_parts: Mapping[Component, str]
    all_of: str
    any_of: str
    damaged: str
    severe: str
    watched: str
    undecided: str
    undecided_speed: str
    if_speed: str
    to_do: Mapping[str, str]
    against: str
    nothing_against: str
    one_line: str
    line_and_multiple: str
    line_and_multiples: str
    chance: str
    chance_below: str
    nothing_found: str
    nothing_own: str
    other_lines: str
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
    speed_by_lines: str
    speed_open: str
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
    worth: Mapping[str, str]
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
    of_mains: tuple[str, str]
    row: str

    reading: str
    tracking: str


_ENGLISH: Final = DiagnosisWords(
    subjects={
        "outer_race": "The outer race",
        "inner_race": "The inner race",
        "ball": "A ball",
        "cage": "The cage",
        "ball_or_cage": "A ball or the cage",
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
        "ball": "a ball",
        "cage": "the cage",
    },
    all_of="{list} and {last}",
    any_of="{list} or {last}",
    damaged="{subject} is damaged: {lines}, modulation depth {depth} %.",
    severe="{subject} is severely damaged: {lines}, modulation depth {depth} %.",
    watched="No damage stated. Watch {part}: {lines}, modulation depth {depth} %, as many healthy"
    " bearings have.",
    undecided="Not decided: {lines}, modulation depth {depth} %, would mean damage to {part}, but"
    " what speaks against it weighs as much.",
    undecided_speed="Not decided: damage to {parts}.",
    if_speed="{part} if the shaft ran at {speed} rpm",
    to_do={
        "severe": "Do: replace the bearing at the next stop; do not put it off.",
        "damage": "Do: measure again soon, and plan to replace the bearing.",
        "watch": "Do: nothing now; measure again as usual, and compare the depth.",
        "undecided": "Do: remove what speaks against it, or measure longer or elsewhere.",
        "undecided_speed": "Do: find out the speed of the shaft, and give it with --speed.",
    },
    against="Against it: {doubts}",
    nothing_against="Against it: nothing in this record.",
    one_line="a line at {frequency} Hz",
    line_and_multiple="lines at {frequency} Hz and 1 multiple",
    line_and_multiples="lines at {frequency} Hz and {count} multiples",
    chance="at most {number}",
    chance_below="below {number}",
    nothing_found="Nothing found: no lines of {parts} stand out of the noise more than chance"
    " explains.",
    nothing_own="Nothing found: what stands out at the lines of {parts} is of another origin, or"
    " too little to count.",
    other_lines="Other lines do: see the notes.",
    untested="Not tested: {parts}.",
    no_verdict="No verdict: this signal says nothing of any part of the bearing.",
    no_verdict_without="No verdict: not tested: {parts}.",
    rest="Nothing stands out of the noise for: {parts}.",
    too_slow="No verdict: the shaft is too slow for this sampling rate. The longest stretch that is"
    " judged at once, {duration} s, spans {turns} revolutions; below {least} nothing can be said of"
    " either race. Give the signal at a rate at least {times} times lower.",
    too_short="No verdict: the record is too short. It spans {turns} revolutions of the shaft,"
    " {duration} s; below {least} revolutions, {seconds} s, nothing can be said of either race.",
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
    speed_by_lines="by the shaft's own lines; {given} rpm {source}, {off} %",
    speed_open="the shaft's own lines do not tell it: lines were looked for within {tolerance} %",
    outer_speed="outer ring {speed} rpm",
    signal="signal",
    samples="{duration} s at {rate} Hz, {turns} revolutions",
    of_part="first {duration} s: ",
    indicators="RMS {rms}{unit}, crest factor {crest}, kurtosis {kurtosis} (3 for noise)",
    search="search",
    searched="cage within {tolerance} % of {expected}{wider}; noise alone gives a finding in at"
    " most {alarm} % of records",
    expected=("its nominal speed", "its speed under load"),
    wider=", wider than --slip to cover the range over the balls",
    table="Parts",
    heads=("", "expected Hz", "found", "off %", "depth %", "evidence", "verdict", "band kHz"),
    verdicts={
        "fault": "damaged",
        "undecided": "undecided",
        "watch": "watch",
        "nothing_found": "nothing",
        "not_tested": "untested",
    },
    legend="Depth: how far the squared envelope swings at that frequency, over its mean; damage"
    " from {damage} % on, severe from {severe} %. Evidence: -log10 of the probability that noise"
    " without such lines gives them, all {trials} trials counted; from {least} on it is a finding."
    " Healthy bearings have such lines too: depth decides. Band: where it rings most clearly. Ball:"
    " its damage strikes twice a turn.",
    why="Why",
    reason={
        "harmonics_above_noise": "At {multiples} times order {order} ({frequency} Hz) the squared"
        " envelope rises {levels} dB above the noise about it.",
        "sidebands": "Sidebands at a spacing of {spacing} {orders}{strongest}: the damage goes"
        " through the load as {carries}.",
        "band": "Clearest between {low} and {high} Hz.",
        "improbable_in_noise": "Noise without such lines gives anything as clear with a probability"
        " {chance}, all {trials} trials counted.",
        "depth": "Modulation depth {depth} %: {worth}.",
        "off_nominal": "{deviation} % {side} the expected order.",
        "nothing_above_noise": "The best of {trials} trials is what noise gives with a probability"
        " of {probability}.",
        "no_order": "Its order is not given.",
        "hidden": "Its lines coincide with multiples of the shaft or of what else is known to"
        " turn: nothing can be said of it.",
        "only_tones": "The signal holds tones, and beside them nothing.",
        "record_too_short": "The record is too short to tell its lines from the shaft's.",
        "rate_too_low": "The sampling rate is too low for its frequency.",
        "no_change": "The signal does not change: most samples only repeat the one before.",
        "at_edge": "It lies at the edge of what the allowed slip reaches, and may go on beyond:"
        " check the speed, the bearing and the contact angle.",
        "carries_the_ball": "Its lines stand out as those of the ball do: a damaged ball goes in"
        " and out of the load once in each turn of the cage. Nothing else points to the cage.",
        "of_first": "What stands out at its lines lies on multiples of those of {first}, or on"
        " sidebands of them. Nothing else points to this part.",
        "beside_first": "What stands out at its lines is too little beside {first}, or of another"
        " cage speed, to be stated as well.",
        "of_others": "What stands out at its lines is at the edge of where they are looked for, or"
        " has sidebands of the shaft: it probably comes from something else.",
        "not_strongest": "What stands out at its lines is as small as in many healthy bearings, and"
        " lines of another origin are as deep.",
        "stronger_line": "A line at {line} Hz (order {line_order}) that the part does not explain"
        " is as deep: {line_depth} %.",
        "on_mains": "{frequency} Hz is a multiple of 50 or 60 Hz, and the line does not slip: the"
        " mains give the same.",
        "dropouts": "Again and again some samples only repeat the one before: gaps of a"
        " transmission, or clipping, make lines of their own.",
        "on_shaft": "It lies on {multiple} times the shaft's frequency, though it stands out of all"
        " lower multiples: what has as many lobes and turns with the shaft gives the same.",
        "speed_open": "The shaft's own lines do not tell its speed; without slip it would be {off}"
        " % off the given one.",
        "other_speed": "By its own lines the shaft ran at {speed} rpm, {factor} % off the given"
        " speed: check it.",
        "no_slip": "Its impacts follow each other as evenly as a clock's, and those of a rolling"
        " bearing slip: another machine, or its drive, may give the same.",
        "open_depth": "The record is too short, or its noise too great, to tell this depth from one"
        " below the limit of {damage} %: measure longer.",
        "close_call": "The depth is near the limit of {damage} %, which a few healthy bearings"
        " reach, above all beside a damaged one.",
    },
    worth={
        "watch": "as many healthy bearings have",
        "damage": "more than healthy bearings have",
        "severe": "the band holds little but impacts",
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
        "dropouts": "Again and again some samples only repeat the one before: gaps of a"
        " transmission, or clipping, make lines of their own.",
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
    unexplained_line="{frequency} Hz (order {order}), depth {depth} %, {level} dB above the noise"
    " between {low} and {high} Hz",
    more_lines="{count} more",
    lowest_line=(
        "It would be the lowest line of: {parts}.",
        "The first would be the lowest line of: {parts}.",
    ),
    at_speed="{part} at {speed} rpm",
    of_mains=(
        "It is a multiple of 50 or 60 Hz, and does not slip: perhaps the mains.",
        "The first is a multiple of 50 or 60 Hz, and does not slip: perhaps the mains.",
    ),
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
        "ball_or_cage": "Uma esfera ou a gaiola",
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
        "ball": "uma esfera",
        "cage": "a gaiola",
    },
    all_of="{list} e {last}",
    any_of="{list} ou {last}",
    damaged="{subject} está danificada: {lines}, profundidade de modulação {depth} %.",
    severe="{subject} está gravemente danificada: {lines}, profundidade de modulação {depth} %.",
    watched="Nenhum dano afirmado. Acompanhe {part}: {lines}, profundidade de modulação {depth} %,"
    " como muitos rolamentos sadios têm.",
    undecided="Não decidido: {lines}, profundidade de modulação {depth} %, significaria que"
    " {part} está danificada, mas o que pesa contra é igualmente forte.",
    undecided_speed="Não decidido: estaria danificada {parts}.",
    if_speed="{part}, se o eixo girou a {speed} rpm",
    to_do={
        "severe": "Faça: troque o rolamento na próxima parada; não adie.",
        "damage": "Faça: meça de novo em breve e planeje a troca do rolamento.",
        "watch": "Faça: nada agora; meça de novo como de costume e compare a profundidade.",
        "undecided": "Faça: elimine o que pesa contra, ou meça por mais tempo ou em outro ponto.",
        "undecided_speed": "Faça: descubra a rotação do eixo e dê-a com --speed.",
    },
    against="Contra: {doubts}",
    nothing_against="Contra: nada neste registro.",
    one_line="uma linha em {frequency} Hz",
    line_and_multiple="linhas em {frequency} Hz e 1 múltiplo",
    line_and_multiples="linhas em {frequency} Hz e {count} múltiplos",
    chance="no máximo {number}",
    chance_below="menor que {number}",
    nothing_found="Nada encontrado; examinadas: {parts}. Nenhuma linha se destaca do ruído além"
    " do que o acaso explica.",
    nothing_own="Nada encontrado; examinadas: {parts}. O que se destaca em suas linhas tem outra"
    " origem, ou é pequeno demais para contar.",
    other_lines="Outras linhas se destacam: veja as observações.",
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
    speed_by_lines="pelas linhas do próprio eixo; {given} rpm {source}, {off} %",
    speed_open="as linhas do próprio eixo não a mostram: procurou-se a até {tolerance} %",
    outer_speed="anel externo {speed} rpm",
    signal="sinal",
    samples="{duration} s a {rate} Hz, {turns} voltas",
    of_part="primeiros {duration} s: ",
    indicators="RMS {rms}{unit}, fator de crista {crest}, curtose {kurtosis} (3 no ruído)",
    search="busca",
    searched="gaiola a até {tolerance} % {expected}{wider}; só ruído dá um achado em no máximo"
    " {alarm} % dos registros",
    expected=("da rotação nominal", "da sua rotação sob carga"),
    wider=", mais do que --slip, para cobrir a variação entre as esferas",
    table="Partes",
    heads=("", "esper. Hz", "achada", "desv.%", "prof.%", "evid.", "veredito", "faixa kHz"),
    verdicts={
        "fault": "danificada",
        "undecided": "indecisa",
        "watch": "acompanhar",
        "nothing_found": "nada",
        "not_tested": "sem teste",
    },
    legend="Profundidade (prof.): quanto o envelope ao quadrado oscila nessa frequência, sobre a"
    " sua média; dano a partir de {damage} %, grave a partir de {severe} %. Evidência (evid.):"
    " -log10 da probabilidade de que ruído sem tais linhas as dê, contadas todas as {trials}"
    " tentativas; a partir de {least} é um achado. Rolamentos sadios também têm tais linhas: decide"
    " a profundidade. Faixa: onde ressoa com mais clareza. Esfera: seu dano dá dois"
    " impactos por volta.",
    why="Por quê",
    reason={
        "harmonics_above_noise": "Em {multiples} vezes a ordem {order} ({frequency} Hz) o envelope"
        " ao quadrado sobe {levels} dB acima do ruído em volta.",
        "sidebands": "Bandas laterais a um espaçamento de {spacing} {orders}{strongest}: o dano"
        " atravessa a carga enquanto {carries}.",
        "band": "Mais clara entre {low} e {high} Hz.",
        "improbable_in_noise": "Ruído sem tais linhas dá algo tão claro com probabilidade"
        " {chance}, contadas todas as {trials} tentativas.",
        "depth": "Profundidade de modulação {depth} %: {worth}.",
        "off_nominal": "{deviation} % {side} da ordem esperada.",
        "nothing_above_noise": "A melhor de {trials} tentativas é o que o ruído dá com"
        " probabilidade {probability}.",
        "no_order": "Sua ordem não foi dada.",
        "hidden": "Suas linhas coincidem com múltiplos do eixo ou de algo mais que se sabe que"
        " gira: nada se pode dizer.",
        "only_tones": "O sinal tem tons e, ao lado deles, nada.",
        "record_too_short": "O registro é curto demais para separar suas linhas das do eixo.",
        "rate_too_low": "A taxa de amostragem é baixa demais para sua frequência.",
        "no_change": "O sinal não varia: a maioria das amostras só repete a anterior.",
        "at_edge": "Fica na borda do que o escorregamento permitido alcança, e pode seguir além:"
        " confira a rotação, o rolamento e o ângulo de contato.",
        "carries_the_ball": "Suas linhas se destacam como as da esfera: uma esfera danificada entra"
        " na carga e sai dela uma vez por volta da gaiola. Nada mais aponta para a gaiola.",
        "of_first": "O que se destaca em suas linhas cai em múltiplos das linhas que {first} gera,"
        " ou em bandas laterais deles. Nada mais aponta para esta parte.",
        "beside_first": "O que se destaca em suas linhas é pouco diante do que {first} mostra, ou"
        " de outra rotação da gaiola, para ser afirmado também.",
        "of_others": "O que se destaca em suas linhas está na borda de onde são procuradas, ou tem"
        " bandas laterais do eixo: é provavelmente de outra coisa.",
        "not_strongest": "O que se destaca em suas linhas é tão pequeno como em muitos rolamentos"
        " sadios, e linhas de outra origem são tão profundas quanto.",
        "stronger_line": "Uma linha em {line} Hz (ordem {line_order}) que a parte não explica é tão"
        " profunda quanto: {line_depth} %.",
        "on_mains": "{frequency} Hz é múltiplo de 50 ou 60 Hz, e a linha não escorrega: a rede"
        " elétrica dá o mesmo.",
        "dropouts": "Repetidas vezes algumas amostras só repetem a anterior: falhas de transmissão,"
        " ou saturação, fazem linhas próprias.",
        "on_shaft": "Cai em {multiple} vezes a frequência do eixo, embora se destaque de todos os"
        " múltiplos menores: o que tem tantos lóbulos e gira com o eixo dá o mesmo.",
        "speed_open": "As linhas do próprio eixo não mostram a sua rotação; sem escorregamento ela"
        " estaria {off} % fora da dada.",
        "other_speed": "Pelas suas próprias linhas o eixo girou a {speed} rpm, {factor} % fora da"
        " rotação dada: confira-a.",
        "no_slip": "Seus impactos se seguem com a regularidade de um relógio, e os de um rolamento"
        " escorregam: outra máquina, ou o acionamento, pode dar o mesmo.",
        "open_depth": "O registro é curto demais, ou seu ruído grande demais, para distinguir esta"
        " profundidade de uma abaixo do limite de {damage} %: meça por mais tempo.",
        "close_call": "A profundidade está perto do limite de {damage} %, que uns poucos rolamentos"
        " sadios alcançam, sobretudo ao lado de um danificado.",
    },
    worth={
        "watch": "como muitos rolamentos sadios têm",
        "damage": "mais do que rolamentos sadios têm",
        "severe": "a faixa quase só tem impactos",
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
        " maior diz onde a falha ressoa.",
        "dropouts": "Repetidas vezes algumas amostras só repetem a anterior: falhas de transmissão,"
        " ou saturação, fazem linhas próprias.",
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
    unexplained_line="{frequency} Hz (ordem {order}), profundidade {depth} %, {level} dB acima do"
    " ruído entre {low} e {high} Hz",
    more_lines="mais {count}",
    lowest_line=(
        "Seria a linha mais baixa de: {parts}.",
        "A primeira seria a linha mais baixa de: {parts}.",
    ),
    at_speed="{part} a {speed} rpm",
    of_mains=(
        "É um múltiplo de 50 ou 60 Hz e não escorrega: talvez seja a rede elétrica.",
        "A primeira é um múltiplo de 50 ou 60 Hz e não escorrega: talvez seja a rede elétrica.",
    ),
    row="fileira {row}",
    reading="blocos do sinal",
    tracking="blocos do sinal, para a rotação",
)

DIAGNOSIS_WORDS: Final[Mapping[str, DiagnosisWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
