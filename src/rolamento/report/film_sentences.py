"""What the engine notes on the film, in Brazilian Portuguese."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

__all__ = ["said_note"]

_NUMBER: Final = r"[-+.\de]+"

_SENTENCES: Final[tuple[tuple[str, str], ...]] = (
    (
        r"The lubricant is below its range at (?P<at>.+?): (?P<name>.+) is for (?P<limit>.+) and"
        r" more\.",
        "O lubrificante está abaixo da sua faixa a {at}: {name} serve a partir de {limit}.",
    ),
    (
        r"The lubricant is above its range at (?P<at>.+?): (?P<name>.+) is for at most"
        r" (?P<limit>.+)\.",
        "O lubrificante está acima da sua faixa a {at}: {name} serve até {limit}.",
    ),
    (
        r"At (?P<at>.+) the oil has less than 2 mm²/s, where the line of ASTM D341 does not hold as"
        r" it is used here\.",
        "A {at} o óleo tem menos de 2 mm²/s, onde a reta da ASTM D341 não vale como usada aqui.",
    ),
    (
        r"The pressure-viscosity coefficient is estimated \((?P<value>\S+) 1/GPa,"
        r" (?P<method>[^,]+), for mineral oils\)\.",
        "O coeficiente pressão-viscosidade é uma estimativa ({value} 1/GPa, {method}, para óleos"
        " minerais).",
    ),
    (
        r"The estimate of the pressure-viscosity coefficient fails for so thin an oil\.",
        "A estimativa do coeficiente pressão-viscosidade falha para um óleo tão fino.",
    ),
    (
        r"A grease is reckoned by its base oil, its inlets full; it may starve\.",
        "Uma graxa é calculada pelo seu óleo base, com as entradas cheias; ela pode faltar.",
    ),
    (
        r"Without the roughness of the surfaces there is no film parameter\.",
        "Sem a rugosidade das superfícies não há parâmetro de filme.",
    ),
    (
        r"Nothing turns: no film separates the surfaces\.",
        "Nada gira: nenhum filme separa as superfícies.",
    ),
    (
        r"Outside of what Hamrock and Dowson computed, as is usual for rolling bearings:"
        r" (?P<groups>.+)\.",
        "Fora do que Hamrock e Dowson calcularam, como é usual em rolamentos: {groups}.",
    ),
    (
        rf"The heat of shear in the inlet leaves only (?P<share>{_NUMBER}) % of the film at some"
        r" contacts\.",
        "O calor do cisalhamento na entrada deixa só {share} % do filme em alguns contatos.",
    ),
    (
        rf"Lack of oil in the inlet leaves only (?P<share>{_NUMBER}) % of the film at some"
        r" contacts\.",
        "A falta de óleo na entrada deixa só {share} % do filme em alguns contatos.",
    ),
    (
        rf"Film parameter down to (?P<least>{_NUMBER}): the asperities carry the load, and fatigue"
        r" is to be expected from the surface, with adhesive wear\.",
        "Parâmetro de filme de até {least}: as asperezas levam a carga, e deve-se esperar fadiga a"
        " partir da superfície, com desgaste adesivo.",
    ),
    (
        rf"Film parameter down to (?P<least>{_NUMBER}): the asperities carry the load, and fatigue"
        r" is to be expected from the surface\.",
        "Parâmetro de filme de até {least}: as asperezas levam a carga, e deve-se esperar fadiga a"
        " partir da superfície.",
    ),
    (
        rf"Viscosity ratio (?P<ratio>{_NUMBER}): the oil is thinner than the bearing needs"
        rf" \((?P<needed>{_NUMBER}) mm²/s\)\.",
        "Razão de viscosidade {ratio}: o óleo é mais fino do que o rolamento precisa ({needed}"
        " mm²/s).",
    ),
)


def said_note(note: str, language: str) -> str:
    """Return a note in a language, "en" or "pt"; as it is if nobody has translated it."""
    if language != "pt":
        return note
    for pattern, template in _patterns():
        match = pattern.fullmatch(note)
        if match:
            return template.format(**{k: _said(k, v) for k, v in match.groupdict().items()})
    return note


@lru_cache(maxsize=1)
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple((re.compile(english), said) for english, said in _SENTENCES)


def _said(name: str, text: str) -> str:
    """Return a varying part with decimal commas; names stay as they are."""
    if name == "name":
        return text
    written = re.sub(r"(?<=\d)\.(?=\d)", ",", text).replace("degC", "°C").replace(" and ", " e ")
    return re.sub(r", (?=[UWGk])", "; ", written).replace(" to ", " a ")
