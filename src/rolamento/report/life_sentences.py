"""What the engine notes on life, in Brazilian Portuguese, by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.analysis import NOTES as ANALYSIS_NOTES

__all__ = ["ANALYSIS_SENTENCES", "PORTUGUESE_CHANGES", "PORTUGUESE_NOTES", "said_analysis_note"]

PORTUGUESE_NOTES: Final[Mapping[str, str]] = {
    "load_above_half_rating": (
        "A carga equivalente passa da metade da capacidade dinâmica: os contatos se deformam"
        " plasticamente, e a norma não responde pela vida."
    ),
    "load_above_static_rating": (
        "A carga equivalente passa da capacidade estática: esperam-se marcas permanentes."
    ),
    "viscosity_ratio_too_small": (
        "A razão de viscosidade κ está abaixo de 0,1, onde a norma não dá fator: as superfícies se"
        " tocam, e a vida é menos de um décimo da básica."
    ),
    "contamination_severe": (
        "O fator de contaminação é 0: o desgaste, e não a fadiga, acaba com a vida, antes de um"
        " décimo da básica."
    ),
    "too_hot_for_steel": (
        "Os anéis, as esferas ou o lubrificante passam de 120 °C, o que o aço comum para rolamentos"
        " aguenta: dureza e dimensões mudam, e a capacidade cai. Peça anéis estabilizados."
    ),
    "unloaded": (
        "Nenhuma esfera leva carga de um anel ao outro: não há vida nominal. Sem uma carga mínima"
        " as esferas deslizam, e é isso que acaba com a vida."
    ),
    "no_force": (
        "Nenhuma força age de um anel ao outro: não há carga equivalente, e a norma não se aplica;"
        " a vida de referência conta o momento ou a pré-carga que solicita as esferas."
    ),
    "moment_governs": (
        "O momento solicita as esferas mais que as forças (2M/d_m > F), e a carga equivalente não"
        " inclui o momento; a vida de referência o conta, esfera por esfera."
    ),
    "no_fatigue_load_limit": (
        "Sem o limite de carga de fadiga C_u não há vida modificada: informe"
        " life.fatigue_load_limit."
    ),
    "no_equivalent_load": (
        "A norma não tem carga equivalente para este conjunto: as carreiras diferem, ou são"
        " mais que um tandem ou um par. A vida de referência vale para ele."
    ),
    "thrust_bearing": (
        "O ângulo de contato passa de 45°: um rolamento axial, para o qual estas teorias não valem."
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
    "viscosity_unknown": (
        "A viscosidade não foi dada: mesmo com o óleo mais viscoso, tanta sujeira deixa menos que"
        " isto."
    ),
    "contamination_unknown": (
        "A limpeza não foi dada: mesmo perfeitamente limpo, um óleo tão fino deixa menos que isto."
    ),
    "factors_of_the_user": (
        "Os fatores da forma de Tallian são do usuário: nenhum é público. O que não é dado segue"
        " Lundberg e Palmgren."
    ),
    "surface_left_out": (
        "Não há fatores de falhas a partir da superfície: só contam as que vêm de baixo dela."
    ),
    "moment_left_out": (
        "A carga equivalente não inclui o momento; a vida de referência o conta, esfera por esfera."
    ),
    "preload_left_out": (
        "A carga equivalente não inclui a pré-carga; a vida de referência a conta."
    ),
    "centrifugal_left_out": (
        "As esferas pressionam mais a pista externa que a interna, pela sua força centrífuga;"
        " a carga equivalente não inclui isso; a vida de referência, sim."
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
        "a_2 não é 1: a norma exige para isso evidências do fabricante."
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
    "light_load": (
        "A carga equivalente está abaixo de C/100, a carga mínima usual de rolamentos de esferas:"
        " as esferas podem deslizar em vez de rolar, o que nenhuma teoria de fadiga conta."
    ),
    "load_shared_otherwise": (
        "As esferas não dividem a carga como a norma supõe, com uma folga normal: a vida de"
        " referência, que conta a real, é menos da metade ou mais do dobro desta."
    ),
}
"""Of `rolamento.life.record.NOTES`."""

PORTUGUESE_CHANGES: Final[Mapping[str, str]] = {
    "less_load": "todas as forças e momentos um décimo menores",
    "less_clearance": "folga diametral 5 µm menor",
    "more_clearance": "folga diametral 5 µm maior",
    "thicker_oil": "viscosidade metade maior, cerca de um grau ISO VG",
    "cleaner_oil": "fator de contaminação 0,2 maior, no máximo 1",
}
"""Of `rolamento.life.sensitivity.CHANGES`."""

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
