"""What the report says of life, in two languages; the engine's notes by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from rolamento.analysis import NOTES as ANALYSIS_NOTES
from rolamento.life.record import NOTES
from rolamento.life.sensitivity import CHANGES

__all__ = ["ANALYSIS_SENTENCES", "LIFE_WORDS", "LifeWords", "said_analysis_note"]


@dataclass(frozen=True, slots=True, kw_only=True)
class LifeWords:
    """All that is said of life in one language; `{…}` are filled in by the one who says it.

    names, short, long and valid are by theory, in the order in which tables have them; notes,
    changes and helps by the names of the engine.
    """

    # theories
    names: Mapping[str, str]
    short: Mapping[str, tuple[str, str]]
    long: Mapping[str, str]
    valid: Mapping[str, str]

    # the statement
    life: str
    one: str
    several: str
    reaches: str
    turns_only: str
    endless_life: str
    limit: str
    limit_of_row: str
    races: Mapping[str, str]
    helps_most: str
    nothing_helps: str
    helps: Mapping[str, str]
    wanted: str
    more_than: str
    less_than: str
    lubrication_left_out: str
    modified_fails: str
    none_holds: str
    not_to_be_used: str
    no_life: str

    # the table of theories
    theories: str
    million: str
    hour: str
    endless: str
    holds_here: str
    holds: str
    bound: str
    fails: str
    legend: str
    chosen: str
    validity: str
    every_theory: str
    fails_for: str

    # ratings, limit, changes
    ratings: str
    sources: Mapping[str, str]
    factors: str
    load_ratio: str
    static_safety: str
    reference_load: str
    limits: str
    share_of_risk: str
    share_of_row: str
    heaviest: str
    factor: Mapping[str, str]
    all_lives: str
    changes_heading: str
    changes: Mapping[str, str]
    changes_legend: str

    notes: Mapping[str, str]


_FAILS_BY_OIL: Final = "what oil and dirt take off is not in it"

_ENGLISH: Final = LifeWords(
    names={
        "iso281": "ISO 281, basic",
        "iso281_modified": "ISO 281, modified",
        "iso281_1990": "ISO 281:1990, adjusted",
        "iso16281": "ISO/TS 16281, basic",
        "iso16281_modified": "ISO/TS 16281, modified",
        "ioannides_harris": "Ioannides and Harris",
        "l_able": "NSK, L_able",
    },
    short={
        "iso281": ("ISO 281", "basic"),
        "iso281_modified": ("ISO 281", "modified"),
        "iso281_1990": ("281:1990", "adjusted"),
        "iso16281": ("TS 16281", "basic"),
        "iso16281_modified": ("TS 16281", "modified"),
        "ioannides_harris": ("Ioannides", "Harris"),
        "l_able": ("NSK", "L_able"),
    },
    long={
        "iso281": "rating life, ISO 281",
        "iso281_modified": "modified rating life, ISO 281",
        "iso281_1990": "adjusted rating life, ISO 281:1990",
        "iso16281": "reference life, ISO/TS 16281",
        "iso16281_modified": "modified reference life, ISO/TS 16281",
        "ioannides_harris": "stress-volume life, Ioannides and Harris",
        "l_able": "L_able, NSK",
    },
    valid={
        "iso281": (
            "one row, rows in tandem or a pair that faces each other; P up to C/2 and C_0. Oil and"
            " dirt do not count."
        ),
        "iso281_modified": "as the basic one, with κ ≥ 0.1 and oil not too dirty (e_C > 0).",
        "iso281_1990": "as the basic one; a_2 and a_3 are the user's.",
        "iso16281": (
            "any load, tilt, clearance, preload, set of rows and speed, ball by ball; P_ref up to"
            " C/2 and C_0. Oil and dirt do not count."
        ),
        "iso16281_modified": ("as the basic one, with κ ≥ 0.1 and oil not too dirty (e_C > 0)."),
        "ioannides_harris": (
            "clean oil and thick films: fatigue from below the surface alone. An upper bound."
        ),
        "l_able": "P up to C/2 and C_0, 20 r/min and more, 130 °C and less.",
    },
    life="Life",
    one="this bearing",
    several="this set",
    reaches=(
        "With {reliability} reliability {what} reaches {hours} h, {revolutions} million"
        " revolutions ({theory})."
    ),
    turns_only=(
        "With {reliability} reliability {what} reaches {revolutions} million revolutions"
        " ({theory}); nothing turns, so there are no hours."
    ),
    endless_life="Fatigue does not end the life of {what} ({theory}): {reason}",
    limit="The {race} ring limits it.",
    limit_of_row="The {race} ring of row {row} limits it.",
    races={"inner": "inner", "outer": "outer"},
    helps_most="{change} would help most: {ratio} times the life.",
    nothing_helps="None of the changes below gives a twentieth more.",
    helps={
        "less_load": "A tenth less load",
        "less_clearance": "5 µm less clearance",
        "more_clearance": "5 µm more clearance",
        "thicker_oil": "Thicker oil",
        "cleaner_oil": "Cleaner oil",
    },
    wanted="The {life} h that are wanted have a reliability of {reliability}.",
    more_than="more than {value}",
    less_than="less than {value}",
    lubrication_left_out=(
        "Oil and dirt are not in it: for them the case needs the viscosity (lubricant with its"
        " temperature, or life.viscosity_ratio) and the cleanliness (life.cleanliness, for"
        " instance)."
    ),
    modified_fails=f"The modified life does not hold here: {_FAILS_BY_OIL}.",
    none_holds="No theory of life holds for this case.",
    not_to_be_used="The numbers below are what the formulas give; do not rely on them.",
    no_life="There is no equilibrium to find a life from.",
    theories="Life by theory",
    million="Mrev",
    hour="h",
    endless="endless",
    holds_here="holds",
    holds="yes",
    bound="bound",
    fails="no",
    legend=(
        "for {reliability} reliability; Mrev millions of revolutions, κ viscosity ratio, e_C"
        " contamination factor"
    ),
    chosen="; ▸ knows most of those that hold",
    validity="What each is for",
    every_theory="all",
    fails_for="does not hold ({theories}): {reason}",
    ratings="Ratings and loads",
    sources={
        "given": "given",
        "dynamic": "from the geometry, ISO 281",
        "static": "from the geometry, ISO 76",
        "contacts": "where the weaker race reaches 1500 MPa, ISO 281",
        "estimate": "estimate C_0/22, ISO 281",
        "unknown": "not known",
    },
    factors="X = {x}, Y = {y}, e = {e}; C/P = {ratio}",
    load_ratio="C/P = {ratio}",
    static_safety="static safety C_0/P_0 = {safety}",
    reference_load="load of a rating life as long as the reference life",
    limits="What limits it",
    share_of_risk="the {race} ring has {share} of the risk",
    share_of_row="the {race} ring of row {row} has {share} of the risk",
    heaviest="ball {ball}, at {azimuth}°, presses hardest on it: {load} N",
    factor={
        "viscosity_ratio": "of oil, dirt and load it is the thin oil that costs most (κ = {kappa})",
        "contamination": "of oil, dirt and load it is the dirt that costs most (e_C = {clean})",
        "load": (
            "of oil, dirt and load it is the load: neither thicker nor cleaner oil would gain half"
            " as much again"
        ),
    },
    all_lives="all theories, and what would help: rolamento life",
    changes_heading="What would help",
    changes=CHANGES,
    changes_legend="life after one change over the life before, by the {theory}",
    notes=NOTES,
)

_PORTUGUESE: Final = LifeWords(
    names={
        "iso281": "ISO 281, básica",
        "iso281_modified": "ISO 281, modificada",
        "iso281_1990": "ISO 281:1990, ajustada",
        "iso16281": "ISO/TS 16281, básica",
        "iso16281_modified": "ISO/TS 16281, modif.",
        "ioannides_harris": "Ioannides e Harris",
        "l_able": "NSK, L_able",
    },
    short={
        "iso281": ("ISO 281", "básica"),
        "iso281_modified": ("ISO 281", "modif."),
        "iso281_1990": ("281:1990", "ajustada"),
        "iso16281": ("TS 16281", "básica"),
        "iso16281_modified": ("TS 16281", "modif."),
        "ioannides_harris": ("Ioannides", "Harris"),
        "l_able": ("NSK", "L_able"),
    },
    long={
        "iso281": "vida nominal, ISO 281",
        "iso281_modified": "vida nominal modificada, ISO 281",
        "iso281_1990": "vida nominal ajustada, ISO 281:1990",
        "iso16281": "vida de referência, ISO/TS 16281",
        "iso16281_modified": "vida de referência modificada, ISO/TS 16281",
        "ioannides_harris": "vida por volume tensionado, Ioannides e Harris",
        "l_able": "L_able, NSK",
    },
    valid={
        "iso281": (
            "uma carreira, carreiras em tandem ou um par de carreiras opostas; P até C/2 e C_0."
            " Óleo e sujeira não contam."
        ),
        "iso281_modified": "como a básica, com κ ≥ 0,1 e óleo não muito sujo (e_C > 0).",
        "iso281_1990": "como a básica; a_2 e a_3 são do usuário.",
        "iso16281": (
            "qualquer carga, inclinação, folga, pré-carga, conjunto de carreiras e rotação, esfera"
            " por esfera; P_ref até C/2 e C_0. Óleo e sujeira não contam."
        ),
        "iso16281_modified": ("como a básica, com κ ≥ 0,1 e óleo não muito sujo (e_C > 0)."),
        "ioannides_harris": (
            "óleo limpo e filmes espessos: só a fadiga a partir do interior. Um limite superior."
        ),
        "l_able": "P até C/2 e C_0, a partir de 20 rpm, até 130 °C.",
    },
    life="Vida",
    one="este rolamento",
    several="este conjunto",
    reaches=(
        "Com {reliability} de confiabilidade {what} atinge {hours} h, {revolutions} milhões de"
        " rotações ({theory})."
    ),
    turns_only=(
        "Com {reliability} de confiabilidade {what} atinge {revolutions} milhões de rotações"
        " ({theory}); nada gira, e por isso não há horas."
    ),
    endless_life="A fadiga não acaba com a vida de {what} ({theory}): {reason}",
    limit="O anel {race} a limita.",
    limit_of_row="O anel {race} da carreira {row} a limita.",
    races={"inner": "interno", "outer": "externo"},
    helps_most="{change} ajudaria mais: {ratio} vezes a vida.",
    nothing_helps="Nenhuma das mudanças abaixo dá um vigésimo a mais.",
    helps={
        "less_load": "Um décimo a menos de carga",
        "less_clearance": "Uma folga 5 µm menor",
        "more_clearance": "Uma folga 5 µm maior",
        "thicker_oil": "Um óleo mais viscoso",
        "cleaner_oil": "Um óleo mais limpo",
    },
    wanted="As {life} h desejadas têm confiabilidade de {reliability}.",
    more_than="mais de {value}",
    less_than="menos de {value}",
    lubrication_left_out=(
        "Óleo e sujeira não estão nela: para isso o caso precisa da viscosidade (lubricant com a"
        " sua temperatura, ou life.viscosity_ratio) e da limpeza (life.cleanliness, por exemplo)."
    ),
    modified_fails="A vida modificada não vale aqui: o que óleo e sujeira tiram não está nela.",
    none_holds="Nenhuma teoria de vida vale para este caso.",
    not_to_be_used="Os números abaixo são o que as fórmulas dão; não confie neles.",
    no_life="Não há equilíbrio de que se possa achar uma vida.",
    theories="Vida por teoria",
    million="Mrot",
    hour="h",
    endless="sem fim",
    holds_here="vale",
    holds="sim",
    bound="limite",
    fails="não",
    legend=(
        "para {reliability} de confiabilidade; Mrot milhões de rotações, κ razão de viscosidade,"
        " e_C fator de contaminação"
    ),
    chosen="; ▸ a que mais sabe entre as que valem",
    validity="Para que serve cada uma",
    every_theory="todas",
    fails_for="não vale ({theories}): {reason}",
    ratings="Capacidades e cargas",
    sources={
        "given": "dada",
        "dynamic": "da geometria, ISO 281",
        "static": "da geometria, ISO 76",
        "contacts": "quando a pista mais fraca chega a 1500 MPa, ISO 281",
        "estimate": "estimativa C_0/22, ISO 281",
        "unknown": "não se conhece",
    },
    factors="X = {x}, Y = {y}, e = {e}; C/P = {ratio}",
    load_ratio="C/P = {ratio}",
    static_safety="segurança estática C_0/P_0 = {safety}",
    reference_load="carga de uma vida nominal tão longa quanto a de referência",
    limits="O que a limita",
    share_of_risk="o anel {race} tem {share} do risco",
    share_of_row="o anel {race} da carreira {row} tem {share} do risco",
    heaviest="a esfera {ball}, a {azimuth}°, é a que mais o pressiona: {load} N",
    factor={
        "viscosity_ratio": (
            "entre óleo, sujeira e carga, é o óleo fino que mais custa (κ = {kappa})"
        ),
        "contamination": "entre óleo, sujeira e carga, é a sujeira que mais custa (e_C = {clean})",
        "load": (
            "entre óleo, sujeira e carga, é a carga: nem um óleo mais viscoso nem um mais limpo"
            " daria metade a mais"
        ),
    },
    all_lives="todas as teorias, e o que ajudaria: rolamento life",
    changes_heading="O que ajudaria",
    changes={
        "less_load": "todas as forças e momentos um décimo menores",
        "less_clearance": "folga diametral 5 µm menor",
        "more_clearance": "folga diametral 5 µm maior",
        "thicker_oil": "viscosidade metade maior, cerca de um grau ISO VG",
        "cleaner_oil": "fator de contaminação 0,2 maior, no máximo 1",
    },
    changes_legend="vida depois de uma mudança sobre a de antes, pela {theory}",
    notes={
        "load_above_half_rating": (
            "A carga equivalente passa da metade da capacidade dinâmica: os contatos se deformam"
            " plasticamente, e a norma não responde pela vida."
        ),
        "load_above_static_rating": (
            "A carga equivalente passa da capacidade estática: esperam-se marcas permanentes."
        ),
        "viscosity_ratio_too_small": (
            "A razão de viscosidade κ está abaixo de 0,1, onde a norma não dá fator."
        ),
        "contamination_severe": (
            "O fator de contaminação é 0: o desgaste, e não a fadiga, acaba com a vida; o número"
            " não é um limite."
        ),
        "oil_too_hot": (
            "O lubrificante passa de 120 °C, o que o aço comum para rolamentos aguenta: dureza e"
            " dimensões mudam, e a capacidade cai. Peça anéis estabilizados."
        ),
        "no_equivalent_load": (
            "A norma não tem carga equivalente para este conjunto: as carreiras diferem, ou são"
            " mais que um tandem ou um par. A vida de referência vale para ele."
        ),
        "thrust_bearing": (
            "O ângulo de contato passa de 45°: um rolamento axial, para o qual estas teorias não"
            " são."
        ),
        "no_dynamic_rating": (
            "A geometria está fora da tabela da norma (D cos α/d_m de 0,01 a 0,40), e nenhuma"
            " capacidade dinâmica foi dada; ou o caso não tem geometria."
        ),
        "too_slow": "O rolamento gira a menos de 20 rpm, para o que o fabricante não dá vida.",
        "too_hot": "O rolamento passa de 130 °C, para o que o fabricante não dá vida.",
        "outside_the_table": (
            "A razão de viscosidade ou a carga está fora da tabela de a_NSK do usuário, que não é"
            " continuada."
        ),
        "moment_left_out": (
            "A carga equivalente não conhece momento; a vida de referência o conta, esfera por"
            " esfera."
        ),
        "preload_left_out": (
            "A carga equivalente não conhece pré-carga; a vida de referência a conta."
        ),
        "centrifugal_left_out": (
            "As esferas pressionam mais a pista externa que a interna, pela sua força centrífuga;"
            " a carga equivalente nada sabe disso, a vida de referência o conta."
        ),
        "open_grooves": (
            "As pistas são mais abertas que 0,52 (interna) ou 0,53 (externa). Uma capacidade que"
            " não é dada é reduzida por isso; uma que é dada tem de ser a do próprio rolamento."
        ),
        "close_grooves": (
            "As pistas são mais fechadas que 0,52 (interna) ou 0,53 (externa). A norma avisa que"
            " pistas mais fechadas podem não aumentar a capacidade, e nenhuma é aumentada."
        ),
        "ceramic_balls": (
            "As esferas não são de aço. Com nitreto de silício a capacidade dinâmica é a de esferas"
            " de aço (ISO 20056-1); a estática não é, e tem de ser dada."
        ),
        "no_static_rating": (
            "Sem a capacidade estática do fabricante para estas esferas não há segurança estática."
        ),
        "viscosity_ratio_capped": ("A razão de viscosidade κ conta como 4, onde a norma termina."),
        "reliability_continued": (
            "A confiabilidade está fora da tabela da norma; a sua fórmula é continuada."
        ),
        "material_factor_unsupported": (
            "a_2 não é 1: a norma quer para isso provas do fabricante."
        ),
        "operation_factor_too_great": (
            "O óleo tem menos de 13 mm²/s, ou n d_m está abaixo de 10 000: a norma pede a_3 < 1."
        ),
        "operation_factor_unfounded": (
            "a_3 acima de 1 precisa de superfícies separadas por um filme; não compensa um aço."
        ),
        "stand_in_for_the_chart": (
            "a_NSK só é publicado em gráficos: a_ISO com e_C = a_c está aqui no seu lugar."
        ),
        "no_surface_stress": (
            "Só tensões abaixo da superfície, com limite de fadiga: sem atrito, marcas e asperezas"
            " isto é um limite superior, muito otimista a partir de 3 GPa."
        ),
        "below_fatigue_limit": (
            "Nenhum ponto é solicitado além do limite de fadiga: não há fim por fadiga."
        ),
        "at_rest": "Nada gira: não há horas.",
        "unloaded": "Nenhuma esfera leva carga: não há fadiga.",
    },
)

LIFE_WORDS: Final[Mapping[str, LifeWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
"""By language."""

ANALYSIS_SENTENCES: Final[Mapping[str, Mapping[str, str]]] = {
    "en": ANALYSIS_NOTES,
    "pt": {
        "no_temperature": (
            "Sem filme: a temperatura do lubrificante não foi dada (temperature.lubricant)."
        ),
        "no_coefficient": (
            "Sem atrito: o coeficiente de atrito do lubrificante não foi dado"
            " (lubricant.friction_coefficient)."
        ),
        "life_of_thrust_bearing": (
            "Sem vida: as teorias daqui são para rolamentos radiais, com ângulo de contato de até"
            " 45°."
        ),
        "life_without_rating": (
            "Sem vida: a geometria está fora da tabela da norma (D cos α/d_m de 0,01 a 0,40), e"
            " nenhuma capacidade dinâmica foi dada (life.dynamic_rating)."
        ),
        "l_able_without_viscosity": (
            "Sem L_able: não se conhece a razão de viscosidade; ela precisa de um lubrificante com"
            " a sua temperatura, ou de life.viscosity_ratio."
        ),
    },
}
"""Why a part of an analysis is missing, by language and name."""


def said_analysis_note(name: str, language: str) -> str:
    """Say in a language why a part of an analysis is missing."""
    return ANALYSIS_SENTENCES.get(language, ANALYSIS_NOTES)[name]
