"""What the report says of life, in two languages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["LIFE_WORDS", "LifeWords"]


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
    reaches_less: str
    turns_only_less: str
    endless_life: str
    limit: str
    limit_of_row: str
    races: Mapping[str, str]
    helps_most: str
    nothing_helps: str
    helps: Mapping[str, str]
    wanted: str
    wanted_below: str
    more_than: str
    less_than: str
    lubrication_left_out: str
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
    bounds: str
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
    changes_legend: str


_ENGLISH: Final = LifeWords(
    names={
        "iso281": "ISO 281, basic",
        "iso281_modified": "ISO 281, modified",
        "iso281_1990": "ISO 281:1990, adjusted",
        "iso16281": "ISO/TS 16281, basic",
        "iso16281_modified": "ISO/TS 16281, modified",
        "ioannides_harris": "Ioannides and Harris",
        "l_able": "NSK, L_able",
        "tallian": "Tallian's form",
    },
    short={
        "iso281": ("ISO 281", "basic"),
        "iso281_modified": ("ISO 281", "modified"),
        "iso281_1990": ("281:1990", "adjusted"),
        "iso16281": ("TS 16281", "basic"),
        "iso16281_modified": ("TS 16281", "modified"),
        "ioannides_harris": ("Ioannides", "Harris"),
        "l_able": ("NSK", "L_able"),
        "tallian": ("Tallian", "form"),
    },
    long={
        "iso281": "rating life, ISO 281",
        "iso281_modified": "modified rating life, ISO 281",
        "iso281_1990": "adjusted rating life, ISO 281:1990",
        "iso16281": "reference life, ISO/TS 16281",
        "iso16281_modified": "modified reference life, ISO/TS 16281",
        "ioannides_harris": "stress-volume life, Ioannides and Harris",
        "l_able": "L_able, NSK",
        "tallian": "Tallian's form",
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
        "tallian": "P_ref up to C/2 and C_0; as good as the factors, which are the user's.",
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
    reaches_less=(
        "With {reliability} reliability {what} reaches less than {hours} h, {revolutions} million"
        " revolutions (bound of the {theory})."
    ),
    turns_only_less=(
        "With {reliability} reliability {what} reaches less than {revolutions} million revolutions"
        " (bound of the {theory}); nothing turns, so there are no hours."
    ),
    endless_life="No end of life by fatigue for {what} ({theory}).",
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
    wanted="The required {life} h have a reliability of {reliability}.",
    wanted_below="The required {life} h have a reliability below {reliability}.",
    more_than="more than {value}",
    less_than="less than {value}",
    lubrication_left_out=(
        "Oil and dirt are not in it: for them the case needs the viscosity (lubricant with its"
        " temperature, or life.viscosity_ratio) and the cleanliness (life.cleanliness, for"
        " instance)."
    ),
    none_holds="No theory that counts the load of every ball is valid for this case.",
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
    chosen="; ▸ leads",
    bounds="; bound: the life is below the number",
    validity="What each is for",
    every_theory="all",
    fails_for="not valid ({theories}): {reason}",
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
    changes_legend="life after one change over the life before, by the {theory}",
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
        "tallian": "forma de Tallian",
    },
    short={
        "iso281": ("ISO 281", "básica"),
        "iso281_modified": ("ISO 281", "modif."),
        "iso281_1990": ("281:1990", "ajustada"),
        "iso16281": ("TS 16281", "básica"),
        "iso16281_modified": ("TS 16281", "modif."),
        "ioannides_harris": ("Ioannides", "Harris"),
        "l_able": ("NSK", "L_able"),
        "tallian": ("forma de", "Tallian"),
    },
    long={
        "iso281": "vida nominal, ISO 281",
        "iso281_modified": "vida nominal modificada, ISO 281",
        "iso281_1990": "vida nominal ajustada, ISO 281:1990",
        "iso16281": "vida de referência, ISO/TS 16281",
        "iso16281_modified": "vida de referência modificada, ISO/TS 16281",
        "ioannides_harris": "vida por volume tensionado, Ioannides e Harris",
        "l_able": "L_able, NSK",
        "tallian": "forma de Tallian",
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
        "tallian": "P_ref até C/2 e C_0; tão boa quanto os fatores, que são do usuário.",
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
    reaches_less=(
        "Com {reliability} de confiabilidade {what} atinge menos de {hours} h, {revolutions}"
        " milhões de rotações (limite superior da {theory})."
    ),
    turns_only_less=(
        "Com {reliability} de confiabilidade {what} atinge menos de {revolutions} milhões de"
        " rotações (limite superior da {theory}); nada gira, e por isso não há horas."
    ),
    endless_life="A fadiga não acaba com a vida de {what} ({theory}).",
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
    wanted_below="As {life} h desejadas têm confiabilidade abaixo de {reliability}.",
    more_than="mais de {value}",
    less_than="menos de {value}",
    lubrication_left_out=(
        "Óleo e sujeira não estão nela: para isso o caso precisa da viscosidade (lubricant com a"
        " sua temperatura, ou life.viscosity_ratio) e da limpeza (life.cleanliness, por exemplo)."
    ),
    none_holds="Nenhuma teoria que conte a carga de cada esfera vale para este caso.",
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
    chosen="; ▸ a que conduz",
    bounds="; limite: a vida está abaixo do número",
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
    changes_legend="vida depois de uma mudança sobre a de antes, pela {theory}",
)

LIFE_WORDS: Final[Mapping[str, LifeWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
"""By language."""
