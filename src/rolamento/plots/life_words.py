"""What stands on figures of life, in English and in Brazilian Portuguese."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["LifeWords", "life_words"]


@dataclass(frozen=True, slots=True)
class LifeWords:
    """The words of one language."""

    life: str
    revolutions: str
    theories: Mapping[str, str]
    faint: str
    above: str
    endless: str
    own: str
    wanted: str
    load: str
    reference_load: str
    pressure: str
    fatigue_load: str
    failed: str
    standing: str
    factor: str
    viscosity_ratio: str
    with_additives: str
    no_factor: str
    zone: str
    zone_life: str
    clearance: str
    no_clearance: str
    best: str
    life_ratio: str
    changes: Mapping[str, str]
    fields: Mapping[str, str]


_ENGLISH: Final = LifeWords(
    life="Life (h)",
    revolutions="Life (10⁶ rev)",
    theories={
        "iso281": "ISO 281",
        "iso281_modified": "ISO 281, modified",
        "iso281_1990": "ISO 281:1990, adjusted",
        "iso16281": "ISO/TS 16281",
        "iso16281_modified": "ISO/TS 16281, modified",
        "ioannides_harris": "Ioannides–Harris (bound)",
        "l_able": "L_able",
        "tallian": "Tallian",
    },
    faint="faint: the theory does not hold there",
    above="{name}, above",
    endless="fatigue ends no life here",
    own="this case",
    wanted="wanted life",
    load="P/C (ISO 281)",
    reference_load="P/C (ISO/TS 16281)",
    pressure="Greatest contact pressure",
    fatigue_load="fatigue load limit C_u",
    failed="failed",
    standing="ended whole",
    factor="a_ISO",
    viscosity_ratio="κ =",
    with_additives="with additives",
    no_factor="there is no a_ISO for this case",
    zone="Load zone ε",
    zone_life="Life over that without clearance",
    clearance="below: diametral clearance under this load (µm)",
    no_clearance="no clearance",
    best="longest life",
    life_ratio="Life after over life before",
    changes={
        "less_load": "a tenth less load",
        "less_clearance": "5 µm less clearance",
        "more_clearance": "5 µm more clearance",
        "thicker_oil": "oil half as thick again",
        "cleaner_oil": "e_C greater by 0.2",
    },
    fields={
        "duty.load.fx": "Axial load",
        "duty.load.fy": "Radial load y",
        "duty.load.fz": "Radial load",
        "duty.inner_speed": "Speed of the inner ring",
        "duty.outer_speed": "Speed of the outer ring",
        "temperature.lubricant": "Temperature of the lubricant",
        "temperature.inner_ring": "Temperature of the inner ring",
        "temperature.outer_ring": "Temperature of the outer ring",
        "temperature.shaft": "Temperature of the shaft",
        "temperature.housing": "Temperature of the housing",
        "bearing.contact_angle": "Free contact angle",
        "bearing.diametral_clearance": "Diametral clearance",
        "bearing.inner_conformity": "Inner conformity",
        "bearing.outer_conformity": "Outer conformity",
        "life.contamination": "Contamination factor e_C",
        "life.viscosity_ratio": "Viscosity ratio κ",
        "life.reliability": "Reliability",
        "life.fatigue_load_limit": "Fatigue load limit C_u",
        "life.fatigue_limit": "Fatigue limit τ_u",
        "life.dynamic_rating": "Dynamic rating C",
    },
)

_PORTUGUESE: Final = LifeWords(
    life="Vida (h)",
    revolutions="Vida (10⁶ rotações)",
    theories={
        "iso281": "ISO 281",
        "iso281_modified": "ISO 281, modificada",
        "iso281_1990": "ISO 281:1990, ajustada",
        "iso16281": "ISO/TS 16281",
        "iso16281_modified": "ISO/TS 16281, modificada",
        "ioannides_harris": "Ioannides–Harris (limite)",
        "l_able": "L_able",
        "tallian": "Tallian",
    },
    faint="claro: a teoria não vale ali",
    above="{name}, acima",
    endless="a fadiga não acaba com nenhuma vida aqui",
    own="este caso",
    wanted="vida desejada",
    load="P/C (ISO 281)",
    reference_load="P/C (ISO/TS 16281)",
    pressure="Pressão máxima de contato",
    fatigue_load="limite de fadiga C_u",
    failed="falhou",
    standing="terminou inteiro",
    factor="a_ISO",
    viscosity_ratio="κ =",
    with_additives="com aditivos",
    no_factor="não há a_ISO para este caso",
    zone="Zona de carga ε",
    zone_life="Vida sobre a vida sem folga",
    clearance="abaixo: folga diametral sob esta carga (µm)",
    no_clearance="sem folga",
    best="vida mais longa",
    life_ratio="Vida depois sobre vida antes",
    changes={
        "less_load": "um décimo menos carga",
        "less_clearance": "5 µm menos folga",
        "more_clearance": "5 µm mais folga",
        "thicker_oil": "óleo 50 % mais viscoso",
        "cleaner_oil": "e_C maior em 0,2",
    },
    fields={
        "duty.load.fx": "Carga axial",
        "duty.load.fy": "Carga radial y",
        "duty.load.fz": "Carga radial",
        "duty.inner_speed": "Rotação do anel interno",
        "duty.outer_speed": "Rotação do anel externo",
        "temperature.lubricant": "Temperatura do lubrificante",
        "temperature.inner_ring": "Temperatura do anel interno",
        "temperature.outer_ring": "Temperatura do anel externo",
        "temperature.shaft": "Temperatura do eixo",
        "temperature.housing": "Temperatura da caixa",
        "bearing.contact_angle": "Ângulo de contato livre",
        "bearing.diametral_clearance": "Folga diametral",
        "bearing.inner_conformity": "Conformidade interna",
        "bearing.outer_conformity": "Conformidade externa",
        "life.contamination": "Fator de contaminação e_C",
        "life.viscosity_ratio": "Razão de viscosidade κ",
        "life.reliability": "Confiabilidade",
        "life.fatigue_load_limit": "Carga limite de fadiga C_u",
        "life.fatigue_limit": "Limite de fadiga τ_u",
        "life.dynamic_rating": "Capacidade dinâmica C",
    },
)

_LANGUAGES: Final[Mapping[str, LifeWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}


def life_words(code: str) -> LifeWords:
    """Return a language by its code, ``"en"`` or ``"pt"``; English for any other."""
    return _LANGUAGES.get(code, _ENGLISH)
