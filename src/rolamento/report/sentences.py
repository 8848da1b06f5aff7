"""The engine's advice and notes in Brazilian Portuguese.

The engine speaks English, with numbers in its sentences: a sentence is found by its pattern, and
said again with its numbers. One that nobody has translated stays as it is.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

__all__ = ["portuguese_sentence"]

_TERMS: Final = {
    "inner": "interna",
    "outer": "externa",
    "along x": "na direção x",
    "along y": "na direção y",
    "along z": "na direção z",
    "toward -x": "no sentido −x",
    "-x": "−x",
    "against tilting about y (ry)": "contra a inclinação em torno de y (ry)",
    "against tilting about z (rz)": "contra a inclinação em torno de z (rz)",
    "only centrifugal force presses on them": "só a força centrífuga age sobre elas",
    "only centrifugal force presses on them, and they orbit with the cage": (
        "só a força centrífuga age sobre elas, e elas orbitam com a gaiola"
    ),
    "nothing presses on them": "nada age sobre elas",
    "its preload is gone": "a pré-carga dela acabou",
    "no preload holds it there": "nenhuma pré-carga a segura",
    "the groove": "a pista",
    "the groove, taken as a half circle,": "a pista, tomada como um semicírculo,",
    "behind": "atrás",
    "ahead of": "à frente",
}

_GROUPS: Final = {
    "BALLS": r"(?P<balls>\d+ balls?)",
    "AZIMUTHS": r"(?P<azimuths>[^)]*)",
    "RACE": r"(?P<race>inner|outer)",
    "DIRECTION": r"(?P<direction>along [xyz]|toward -x|against tilting about [yz] \(r[yz]\))",
    "HOLDER": (
        r"(?P<holder>(?:only centrifugal force|nothing) presses on them"
        r"(?:, and they orbit with the cage)?)"
    ),
    "GROOVE": r"(?P<groove>the groove(?:, taken as a half circle,)?)",
    "CAUSE": r"(?P<cause>its preload is gone|no preload holds it there)",
    "AXIS": r"(?P<axis>\w+)",
    "SIDE2": r"(?P<side2>[-+]x)",
    "SIDE": r"(?P<side>[-+]x)",
    "ROWS": r"(?P<rows>\d+(?:, \d+)*)",
    "SENSE": r"(?P<sense>behind|ahead of)",
    "DESIGNATION": r"(?P<designation>\S(?:.*\S)?)",
    "NUMBER3": r"(?P<number3>[-+.\de]+)",
    "NUMBER2": r"(?P<number2>[-+.\de]+)",
    "NUMBER": r"(?P<number>[-+.\de]+)",
}

_LOST: Final = "Nothing supports the inner ring DIRECTION: "
_PERDIDO: Final = "Nada sustenta o anel interno {direction}: "

_SENTENCES: Final = (
    # advice
    (
        _LOST + "the balls never come to carry the load. Give a smaller load, or hold this degree"
        " of freedom with a displacement.",
        _PERDIDO + "as esferas nunca chegam a suportar a carga. Reduza a carga ou fixe este grau"
        " de liberdade com um deslocamento.",
    ),
    (
        _LOST + "an angular-contact bearing carries axial load toward +x only, and a radial load"
        " needs an axial load beside it (about fz tan(contact angle)). Turn the load round, add"
        " axial preload (duty.load.fx), or hold the ring with duty.displacement.x.",
        _PERDIDO + "um rolamento de contato angular só suporta carga axial no sentido +x, e uma"
        " carga radial precisa de uma carga axial a seu lado (cerca de fz tan(ângulo de contato))."
        " Inverta a carga, acrescente pré-carga axial (duty.load.fx) ou fixe o anel com"
        " duty.displacement.x.",
    ),
    (
        _LOST + "balls would have to carry on the shoulder that an angular-contact bearing lacks."
        " Add axial preload (duty.load.fx), lower the moment, or hold the tilt.",
        _PERDIDO + "as esferas teriam de se apoiar no rebordo que um rolamento de contato angular"
        " não tem. Acrescente pré-carga axial (duty.load.fx), reduza o momento ou fixe a"
        " inclinação.",
    ),
    (
        "Nothing supports the inner ring toward SIDE: all rows carry axial load toward SIDE2 only,"
        " and a radial load needs an axial load beside it in every row (about fz tan(contact"
        " angle)). Turn the load round, add axial load (duty.load.fx), take an arrangement with"
        ' rows that face each other, such as "DB", or hold the ring with duty.displacement.x.',
        "Nada sustenta o anel interno no sentido {side}: todas as carreiras só suportam carga axial"
        " no sentido {side2}, e uma carga radial precisa de uma carga axial a seu lado em cada"
        " carreira (cerca de fz tan(ângulo de contato)). Inverta a carga, acrescente carga axial"
        " (duty.load.fx), use um arranjo com carreiras opostas, como"
        ' "DB", ou fixe o anel com duty.displacement.x.',
    ),
    (
        "Nothing supports the inner ring toward SIDE: an axial load of NUMBER N pushes back the"
        " springs, which press with NUMBER2 N. Take springs that are stronger than the load, clamp"
        " the rings (bearing.preload.force), or turn the load or the set round: toward SIDE2 the"
        " rows that face + carry it without the springs.",
        "Nada sustenta o anel interno no sentido {side}: uma carga axial de {number} N empurra as"
        " molas, que pressionam com {number2} N, para trás. Use molas mais fortes que a carga,"
        " trave os anéis (bearing.preload.force) ou inverta a carga ou o conjunto: no sentido"
        " {side2} as carreiras orientadas para + a suportam sem as molas.",
    ),
    (
        "Springs of NUMBER N do not keep the balls of every row in place: in each row a radial load"
        " needs an axial load beside it (about fz tan(contact angle)), and a moment needs more."
        " Take stronger springs, clamp the rings (bearing.preload.force), lower the radial load or"
        " the moment, or hold the tilts.",
        "Molas de {number} N não mantêm no lugar as esferas de todas as carreiras: em cada carreira"
        " uma carga radial precisa de uma carga axial a seu lado (cerca de fz tan(ângulo de"
        " contato)), e um momento precisa de mais. Use molas mais fortes, trave os anéis"
        " (bearing.preload.force), reduza a carga radial ou o momento ou fixe as inclinações.",
    ),
    (
        "The inner ring moves so far that balls of a row would have to carry on the shoulder that"
        " an angular-contact bearing lacks. More preload or less play (bearing.preload), a smaller"
        " axial load or moment, or rings that are held from tilting keep them on their side.",
        "O anel interno se desloca tanto que esferas de uma carreira teriam de se apoiar no rebordo"
        " que um rolamento de contato angular não tem. Mais pré-carga ou menos folga"
        " (bearing.preload), uma carga axial ou um momento menor, ou anéis impedidos de se inclinar"
        " as mantêm do seu lado.",
    ),
    (
        "A ball would sink into its groove by more than NUMBER % of its diameter, far beyond any"
        " elastic contact: check the units of the loads and displacements.",
        "Uma esfera penetraria na pista mais de {number} % do seu diâmetro, muito além de qualquer"
        " contato elástico: confira as unidades das cargas e dos deslocamentos.",
    ),
    (
        "A number of this case is not finite, or out of its bounds.",
        "Um número deste caso não é finito, ou está fora dos seus limites.",
    ),
    (
        "An overspeed: the rings turn at n d_m = NUMBER million mm r/min, and no ball bearing is"
        " known to have run beyond some NUMBER2 million: centrifugal force presses the balls out of"
        " all elastic contact. Check the unit of the speed, or lower it.",
        "Rotação excessiva: os anéis giram a n d_m = {number} milhões de mm·rpm, e não se conhece"
        " rolamento de esferas que tenha passado de cerca de {number2} milhões: a força centrífuga"
        " tira as esferas de todo contato elástico. Verifique a unidade da rotação ou reduza-a.",
    ),
    (
        "The solver stopped at a residual of NUMBER of the loads, above NUMBER2, so it shows no"
        " result. Vary a load or the speed a little, hold the tilts, or approach the duty in"
        " steps; and please report the case.",
        "O cálculo parou com um resíduo de {number} das cargas, acima de {number2}, e por isso não"
        " mostra resultado. Varie um pouco uma carga ou a rotação, fixe as inclinações ou"
        " aproxime-se do serviço em passos; e, por favor, relate o caso.",
    ),
    (
        "This raceway control cannot hold a ball that a race loads too lightly to bear"
        ' its gyroscopic moment. Take model.cage = "loose", model.raceway_control = "jones" or'
        ' "outer", or more axial load.',
        "Este controle de pista não segura uma esfera que uma pista carrega pouco"
        ' demais para suportar o momento giroscópico dela. Use model.cage = "loose",'
        ' model.raceway_control = "jones" ou "outer", ou mais carga axial.',
    ),
    (
        "The centre of a loaded contact lies beyond the edge of its groove: the inner groove ends"
        " at a contact angle of NUMBER°, the outer at NUMBER2° (90° where no shoulder height is"
        " given: a half circle). Where speed drives the inner contact up its groove, a lower speed"
        " or more axial load or preload brings it back; where the load does, less axial load,"
        " moment or tilt, or a higher shoulder (bearing.inner_shoulder_height,"
        " bearing.outer_shoulder_height).",
        "O centro de um contato carregado fica além da borda da sua pista: a pista interna termina"
        " num ângulo de contato de {number}°, a externa em {number2}° (90° onde não se dá a altura"
        " do rebordo: um semicírculo). Onde é a rotação que leva o contato interno pista acima, uma"
        " rotação menor ou mais carga axial ou pré-carga o traz de volta; onde é a carga, menos"
        " carga axial, momento ou inclinação, ou um rebordo mais alto"
        " (bearing.inner_shoulder_height, bearing.outer_shoulder_height).",
    ),
    (
        "Between rings that turn against each other the balls may orbit so slowly that the"
        " gyroscopic moment overturns one that carries little load. Add axial load, or change the"
        " ratio of the speeds.",
        "Entre anéis que giram em sentidos opostos as esferas podem orbitar tão devagar que o"
        " momento giroscópico vira uma que leva pouca carga. Aumente a carga axial ou mude a"
        " razão das rotações.",
    ),
    (
        "Under friction alone the forces balance, but a ball stands where none can be or the power"
        " does not balance, so there is no result to show. Vary a little the load, the speed or"
        " lubricant.friction_coefficient, take the other model.mesh, more load or less"
        ' model.cage_drag; raceway_control = "jones" gives loads and angles close to these.',
        "Só com o atrito as forças se equilibram, mas uma esfera está onde nenhuma pode estar ou o"
        " balanço de potência não fecha, e por isso não há resultado a mostrar. Varie um pouco a"
        " carga, a rotação ou lubricant.friction_coefficient, use a outra model.mesh, mais carga ou"
        ' menos model.cage_drag; raceway_control = "jones" dá cargas e ângulos próximos destes.',
    ),
    (
        "Under friction alone the solver stopped at a residual of NUMBER of the loads, so it shows"
        " no result. Vary a little the load, the speed or lubricant.friction_coefficient, take the"
        ' other model.mesh, more load or less model.cage_drag; raceway_control = "jones" gives'
        " loads and angles close to these.",
        "Só com o atrito, o cálculo parou com um resíduo de {number} das cargas, e por isso não"
        " mostra resultado. Varie um pouco a carga, a rotação ou lubricant.friction_coefficient,"
        ' use a outra model.mesh, mais carga ou menos model.cage_drag; raceway_control = "jones"'
        " dá cargas e ângulos próximos destes.",
    ),
    # the clearance in operation
    (
        "Mounted, at its temperatures and speeds, the bearing has a diametral clearance of NUMBER"
        " µm, between NUMBER2 and NUMBER3 µm with all tolerances at their worst.",
        "Montado, às suas temperaturas e rotações, o rolamento tem folga diametral de {number} µm,"
        " entre {number2} e {number3} µm com todas as tolerâncias no pior caso.",
    ),
    (
        "The clearance in operation is negative at its mean: the balls are preloaded.",
        "A folga em operação é negativa na média: as esferas estão pré-carregadas.",
    ),
    (
        "The clearance in operation is negative at its minimum: some bearings are preloaded.",
        "A folga em operação é negativa no mínimo: alguns rolamentos ficam pré-carregados.",
    ),
    (
        "In operation nothing may be left of the inner ring's interference: it may creep.",
        "Em operação pode não restar interferência no anel interno: ele pode girar no eixo.",
    ),
    (
        "In operation nothing may be left of the outer ring's interference: it may creep.",
        "Em operação pode não restar interferência no anel externo: ele pode girar no alojamento.",
    ),
    (
        "The inner ring's interference may be more than a thousandth of the bore: the ring may"
        " crack (NTN, Ball and Roller Bearings, chapter 7.3).",
        "A interferência do anel interno pode passar de um milésimo do furo: o anel pode trincar"
        " (NTN, Ball and Roller Bearings, capítulo 7.3).",
    ),
    # notes
    (
        "The rings do not turn against each other, so friction has nothing to decide: this is the"
        " result of outer raceway control.",
        "Os anéis não giram um em relação ao outro, e o atrito nada tem a decidir: este é o"
        " resultado do controle pela pista externa.",
    ),
    (
        "The cage runs NUMBER % SENSE that of outer raceway control (NUMBER2 instead of NUMBER3"
        " rpm): the balls skid, and the fault frequencies move with the cage.",
        "A gaiola gira {number} % {sense} da do controle pela pista externa ({number2} em vez de"
        " {number3} rpm): as esferas escorregam, e as frequências de falha mudam com a gaiola.",
    ),
    (
        "BALLS spin at both races (azimuth AZIMUTHS), by up to NUMBER of the roll at the inner and"
        " NUMBER2 at the outer race: no raceway control describes them.",
        "{balls} com spin nas duas pistas (azimute {azimuths}), até {number} do rolamento na pista"
        " interna e {number2} na externa: nenhum controle de pista as descreve.",
    ),
    (
        "Row ROWS is about to lose its preload: it lifts off the inner ring at NUMBER times this"
        " load. More preload keeps it in contact.",
        "A carreira {rows} está prestes a perder a pré-carga: ela se solta do anel interno com"
        " {number} vezes esta carga. Mais pré-carga a mantém em contato.",
    ),
    (
        "No ball of row ROWS presses on the inner ring: CAUSE, and the rest of the set carries the"
        " whole load. Where the bearing turns, such balls skid.",
        "Nenhuma esfera da carreira {rows} pressiona o anel interno: {cause}, e o resto do conjunto"
        " suporta toda a carga. Onde o rolamento gira, tais esferas escorregam.",
    ),
    (
        "The orbit of a ball without inner contact, and with it its centrifugal force, is a guess"
        ' under model.cage = "none": raceway control says nothing about it. Under "loose" the cage'
        " drives it.",
        "A órbita de uma esfera sem contato interno, e com ela a sua força centrífuga, é um palpite"
        ' com model.cage = "none": o controle de pista nada diz sobre ela. Com "loose" a gaiola a'
        " arrasta.",
    ),
    (
        "No ball presses on the inner ring: without a load, its place is one of many.",
        "Nenhuma esfera pressiona o anel interno: sem carga, a posição dele é uma entre muitas.",
    ),
    (
        "BALLS without inner contact (azimuth AZIMUTHS): HOLDER.",
        "{balls} sem contato com a pista interna (azimute {azimuths}): {holder}.",
    ),
    (
        "BALLS past the edge of the inner groove (azimuth AZIMUTHS): no force is computed there. In"
        " the real bearing such a ball may bear on the edge of the shoulder, and the loads of all"
        " balls differ from those shown.",
        "{balls} além da borda da pista interna (azimute {azimuths}): ali não se calcula força"
        " alguma. No rolamento real, tal esfera pode apoiar-se na borda do rebordo, e as cargas de"
        " todas as esferas diferem das mostradas.",
    ),
    (
        "Contact pressure at the RACE race is up to NUMBER MPa, above NUMBER2 MPa (ISO 76), where"
        " balls begin to dent the groove: BALLS (azimuth AZIMUTHS).",
        "A pressão de contato na pista {race} chega a {number} MPa, acima de {number2} MPa"
        " (ISO 76), quando as esferas começam a marcar a pista: {balls} (azimute {azimuths}).",
    ),
    (
        "The contact ellipse runs over the RACE shoulder: it reaches NUMBER°, GROOVE ends at"
        " NUMBER2° (BALLS, azimuth AZIMUTHS). Pressure at the edge is higher than"
        " shown.",
        "A elipse de contato passa do rebordo da pista {race}: chega a {number}°, e {groove}"
        " termina a {number2}° ({balls}, azimute {azimuths}). A pressão na borda é maior que a"
        " mostrada.",
    ),
    (
        "The speed factor n·d_m = NUMBER mm/min is beyond what rolling bearings reach (NUMBER2"
        " mm/min): the rings' own growth and the heat are not in these numbers.",
        "O fator de velocidade n·d_m = {number} mm/min está além do que rolamentos alcançam"
        " ({number2} mm/min): a dilatação dos anéis e o calor não estão nestes números.",
    ),
    (
        "The ring tilts by NUMBER°: the equations take tilts as small, good to about NUMBER2°.",
        "O anel se inclina {number}°: as equações supõem inclinações pequenas, até cerca de"
        " {number2}°.",
    ),
    (
        "No ball holds the ring along AXIS: it carries no load there, and the displacement shown"
        " is one of many.",
        "Nenhuma esfera segura o anel em {axis}: ele não recebe carga ali, e o deslocamento"
        " mostrado é um entre muitos.",
    ),
    (
        "Jones's criterion favours neither race at BALLS (azimuth AZIMUTHS): they are taken as"
        " before, as controlled by the race that they last rolled on, first the outer.",
        "O critério de Jones não favorece nenhuma das pistas em {balls} (azimute {azimuths}):"
        " continua valendo o controle pela última pista em que rolaram, de início a externa.",
    ),
    (
        "Jones's criterion contradicts RACE raceway control at BALLS (azimuth AZIMUTHS);"
        ' model.raceway_control = "jones" decides ball by ball.',
        "O critério de Jones contradiz o controle pela pista {race} em {balls} (azimute"
        ' {azimuths}); model.raceway_control = "jones" decide esfera por esfera.',
    ),
    (
        "The balls of DESIGNATION are not published, but inferred from its ratings, which NUMBER"
        " insides reproduce (rolamento catalogue show): the best one is taken.",
        "As esferas de {designation} não são publicadas, e sim inferidas das capacidades, que"
        " {number} interiores reproduzem (rolamento catalogue show): toma-se o melhor.",
    ),
    (
        "The balls of DESIGNATION are not published, but inferred from its ratings; no other"
        " standard balls reproduce them.",
        "As esferas de {designation} não são publicadas, e sim inferidas das capacidades;"
        " nenhuma outra esfera normalizada as reproduz.",
    ),
    (
        "To hold the gyroscopic moment as assumed, a coefficient of friction of NUMBER is needed,"
        " more than about NUMBER2: BALLS will slip (azimuth AZIMUTHS).",
        "Para segurar o momento giroscópico como suposto, é preciso um coeficiente de atrito de"
        " {number}, mais que cerca de {number2}: {balls} vão escorregar (azimute {azimuths}).",
    ),
)


def portuguese_sentence(sentence: str) -> str:
    """Return the sentence in Portuguese, or as it is if nobody has translated it."""
    for pattern, template in _patterns():
        match = pattern.fullmatch(sentence)
        if match:
            groups = match.groupdict()
            return template.format(**{name: _said(name, text) for name, text in groups.items()})
    return sentence


@lru_cache(maxsize=1)
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple((re.compile(_expression(english)), said) for english, said in _SENTENCES)


def _expression(english: str) -> str:
    """Return the pattern of a sentence whose words in capitals stand for what varies."""
    names = "|".join(_GROUPS)
    parts = re.split(rf"\b({names})\b", english)
    return "".join(_GROUPS.get(part) or re.escape(part) for part in parts)


def _said(name: str, text: str) -> str:
    """Return a varying part in Portuguese: terms, counts, numbers with a decimal comma."""
    if name == "designation":
        return text
    if name == "balls":
        return text.replace("ball", "esfera")
    if name == "azimuths":
        words = {"row": "carreira", "all": "todas"}
        for english, said in words.items():
            text = text.replace(english, said)
        return text.replace(", ", "; ").replace(".", ",")
    return _TERMS.get(text, text.replace(".", ","))
