"""What stands on figures of vibration, in English and in Brazilian Portuguese."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rolamento.vibration.diagnosis import Component
    from rolamento.vibration.signal import Quantity

__all__ = ["VibrationWords", "vibration_words"]


@dataclass(frozen=True, slots=True, kw_only=True)
class VibrationWords:
    """The words of one language; `{…}` are filled in."""

    time: str
    quantities: Mapping[Quantity, str]
    period: str
    frequency: str
    orders: str
    bandwidth: str
    kurtosis: str
    best_band: str
    fault_band: str
    above_noise: str
    in_band: str
    parts: Mapping[Component, str]
    found: str
    expected: str
    sidebands: str
    unexplained: str
    noise: str
    threshold: str
    shaft: str
    too_short: str
    no_lines: str
    no_change: str


_ENGLISH: Final = VibrationWords(
    time="Time (s)",
    quantities={
        "acceleration": "Acceleration",
        "velocity": "Velocity",
        "displacement": "Displacement",
        "unknown": "Signal",
    },
    period="period of the {part}: {period} ms",
    frequency="Frequency (Hz)",
    orders="Order of the shaft",
    bandwidth="Bandwidth (Hz)",
    kurtosis="Kurtosis over that of noise",
    best_band="stands out most: {low} to {high} Hz",
    fault_band="fault clearest: {low} to {high} Hz",
    above_noise="Envelope² over noise (dB)",
    in_band="Band {low} to {high} Hz",
    parts={
        "outer_race": "outer race",
        "inner_race": "inner race",
        "ball": "ball",
        "cage": "cage",
    },
    found="{part}, found",
    expected="{part}, expected",
    sidebands="{part}, sidebands",
    unexplained="unexplained",
    noise="noise, mean",
    threshold="from here one line alone is not noise",
    shaft="multiples of the shaft",
    too_short="The signal is too short for a kurtogram.",
    no_lines="The signal allows no envelope spectrum.",
    no_change="The signal does not change.",
)

_PORTUGUESE: Final = VibrationWords(
    time="Tempo (s)",
    quantities={
        "acceleration": "Aceleração",
        "velocity": "Velocidade",
        "displacement": "Deslocamento",
        "unknown": "Sinal",
    },
    period="período da {part}: {period} ms",
    frequency="Frequência (Hz)",
    orders="Ordem do eixo",
    bandwidth="Largura de banda (Hz)",
    kurtosis="Curtose além da do ruído",
    best_band="mais se destaca: {low} a {high} Hz",
    fault_band="falha mais clara: {low} a {high} Hz",
    above_noise="Envelope² sobre o ruído (dB)",
    in_band="Faixa de {low} a {high} Hz",
    parts={
        "outer_race": "pista externa",
        "inner_race": "pista interna",
        "ball": "esfera",
        "cage": "gaiola",
    },
    found="{part}, achada",
    expected="{part}, esperada",
    sidebands="{part}, bandas laterais",
    unexplained="sem explicação",
    noise="ruído, média",
    threshold="daqui em diante uma só linha não é ruído",
    shaft="múltiplos do eixo",
    too_short="O sinal é curto demais para um curtograma.",
    no_lines="O sinal não permite um espectro do envelope.",
    no_change="O sinal não varia.",
)


def vibration_words(code: str) -> VibrationWords:
    """Return a language by its code, ``"en"`` or ``"pt"``; English for any other."""
    return _PORTUGUESE if code == "pt" else _ENGLISH
