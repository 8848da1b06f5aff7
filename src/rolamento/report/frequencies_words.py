"""What the page of fault frequencies says, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from rolamento.vibration.frequencies import NOTES, FaultKind, LineName

__all__ = ["FREQUENCY_WORDS", "FrequencyWords"]


@dataclass(frozen=True, slots=True)
class FrequencyWords:
    """The words of one language; `{…}` are filled in by the one who says it."""

    inside: str
    angle: str
    speeds: Mapping[str, str]
    shaft: str
    no_speed: str
    slip: str
    nominal: str
    loaded: str
    row: str
    lines: Mapping[LineName, str]
    nominal_heads: tuple[str, ...]
    loaded_heads: tuple[str, ...]
    band: str
    over_balls: str
    harmonics: str
    harmonics_in_orders: str
    faults: Mapping[FaultKind, str]
    spacing: str
    alternatives: str
    alternative_heads: tuple[str, ...]
    alternatives_legend: str
    notes: str
    note: Mapping[str, str]
    failed: str


FREQUENCY_WORDS: Final[Mapping[str, FrequencyWords]] = {
    "en": FrequencyWords(
        inside="{count} balls of {ball} mm on {pitch} mm",
        angle="contact angle {angle}°",
        speeds={"inner": "inner ring {speed} rpm", "outer": "outer ring {speed} rpm"},
        shaft="shaft {frequency} Hz",
        no_speed="no speed given: orders of the inner ring, which turns",
        slip="the cage lags by {slip} % against the outer ring",
        nominal="By the geometry",
        loaded="Under load",
        row="row {row}",
        lines={
            "cage": "cage",
            "ball_pass_outer": "outer race",
            "ball_pass_inner": "inner race",
            "ball_spin": "ball, one turn",
            "ball_spin_twice": "ball, both races",
        },
        nominal_heads=("", "order", "Hz", "from", "to", "Hz from", "to"),
        loaded_heads=("", "order", "Hz", "least", "mean", "most"),
        band="From, to: what the inside, the contact angle and the tolerances leave open, all at"
        " their worst together.",
        over_balls="Order: of the cage that the loads drive. Least, mean, most: over the {count}"
        " balls that the inner ring presses on.",
        harmonics="Harmonics and sidebands (Hz)",
        harmonics_in_orders="Harmonics and sidebands (orders)",
        faults={
            "outer_race": "outer race",
            "inner_race": "inner race",
            "ball": "ball",
            "cage": "cage",
        },
        spacing="Sidebands: of a load that stands still, with the ring that is damaged, or with"
        " the cage for a ball.",
        alternatives="What else the ratings allow (orders)",
        alternative_heads=("", "Z", "D mm", "d_m mm", "share %", "cage", "outer", "inner", "ball"),
        alternatives_legend="Ball: both races. × marks what misses a printed rating by more than"
        " three tolerances; the band leaves it out.",
        notes="Notes",
        note=NOTES,
        failed="The case has no solution: {reason}",
    ),
    "pt": FrequencyWords(
        inside="{count} esferas de {ball} mm em {pitch} mm",
        angle="ângulo de contato {angle}°",
        speeds={"inner": "anel interno {speed} rpm", "outer": "anel externo {speed} rpm"},
        shaft="eixo {frequency} Hz",
        no_speed="nenhuma rotação dada: ordens do anel interno, que gira",
        slip="a gaiola atrasa {slip} % em relação ao anel externo",
        nominal="Pela geometria",
        loaded="Sob carga",
        row="fileira {row}",
        lines={
            "cage": "gaiola",
            "ball_pass_outer": "pista externa",
            "ball_pass_inner": "pista interna",
            "ball_spin": "esfera, uma volta",
            "ball_spin_twice": "esfera, duas pistas",
        },
        nominal_heads=("", "ordem", "Hz", "de", "a", "Hz de", "a"),
        loaded_heads=("", "ordem", "Hz", "mínima", "média", "máxima"),
        band="De, a: o que o interior, o ângulo de contato e as tolerâncias deixam em aberto,"
        " todos juntos no pior caso.",
        over_balls="Ordem: da gaiola que as cargas conduzem. Mínima, média, máxima: entre as"
        " {count} esferas que o anel interno pressiona.",
        harmonics="Harmônicas e bandas laterais (Hz)",
        harmonics_in_orders="Harmônicas e bandas laterais (ordens)",
        faults={
            "outer_race": "pista externa",
            "inner_race": "pista interna",
            "ball": "esfera",
            "cage": "gaiola",
        },
        spacing="Bandas laterais: de uma carga parada, com o anel danificado, ou com a gaiola para"
        " uma esfera.",
        alternatives="O que mais as capacidades permitem (ordens)",
        alternative_heads=(
            "", "Z", "D mm", "d_m mm", "parte %", "gaiola", "externa", "interna", "esfera",
        ),
        alternatives_legend="Esfera: duas pistas. × marca o que erra uma capacidade impressa por"
        " mais de três tolerâncias; a faixa não o inclui.",
        notes="Observações",
        note={
            "angle_zero": "O rolamento é dado pela folga: ângulo de contato 0, como sob carga"
            " radial. Sob carga axial é o ângulo de contato livre ou mais.",
            "angle_free": "O rolamento é dado pela folga: ângulo de contato livre, como sob carga"
            " axial.",
            "at_rest": "Nada gira: as ordens são as do anel interno girando.",
            "turns_alike": "Os dois anéis giram juntos: nenhuma esfera rola.",
            "no_result": "O caso não tem solução, e por isso não há frequências sob carga.",
            "no_loaded_ball": "O anel interno não pressiona nenhuma esfera: nada conduz a gaiola.",
            "friction": "A rotação da gaiola é a do controle por atrito.",
        },
        failed="O caso não tem solução: {reason}",
    ),
}  # fmt: skip
