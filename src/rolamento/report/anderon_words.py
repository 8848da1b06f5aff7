"""What the page of a bearing's noise says, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rolamento.vibration.anderon import BandName
    from rolamento.vibration.signal import Quantity

__all__ = ["NOISE_WORDS", "NoiseWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseWords:
    """The words of one language; `{…}` are filled in by the one who says it."""

    accepted: str
    rejected: str
    not_accepted: str
    above: str
    unmeasured: str
    no_verdict: str
    accepted_all: str
    rejected_some: str

    speed: str
    speeds: Mapping[str, str]
    signal: str
    samples: str
    quantities: Mapping[Quantity, str]

    bands: Mapping[BandName, str]
    table: str
    heads: tuple[str, ...]
    limit_heads: tuple[str, ...]
    verdicts: Mapping[str, str]
    legend: str
    one: str

    signals: str
    signal_heads: tuple[str, ...]
    signals_legend: str
    over_time: str
    time_heads: tuple[str, ...]
    time_legend: str
    record: str

    notes: str
    note: Mapping[str, str]
    in_signals: str

    reading: str


_ENGLISH: Final = NoiseWords(
    accepted="Accepted: no band is above {part} % of its full scale.",
    rejected="Rejected: {bands}.",
    not_accepted="Not accepted: {bands}.",
    above="{band} band with {value} anderon, where {limit} are accepted",
    unmeasured="{band} band not measured",
    no_verdict="No verdict: no full scale is given (--full-scale).",
    accepted_all="Accepted: all {count} signals; no band is above {part} % of its full scale.",
    rejected_some="Rejected: {rejected} of {count} signals.",
    speed="speed",
    speeds={
        "right": "{speed} rpm, as in the test",
        "known": "{speed} rpm; the test has 1800 rpm",
        "unknown": "not told; 1800 rpm, as in the test, is assumed",
    },
    signal="signal",
    samples="{quantity}, {duration} s at {rate} Hz",
    quantities={
        "velocity": "velocity",
        "acceleration": "acceleration",
        "displacement": "displacement",
        "unknown": "signal",
    },
    bands={"low": "low", "medium": "medium", "high": "high"},
    table="Bands",
    heads=("", "Hz", "µm/s RMS", "anderon"),
    limit_heads=("full scale", "% of it", "limit", "verdict"),
    verdicts={
        "accepted": "accepted",
        "rejected": "rejected",
        "not_measured": "not measured",
        "none": "no verdict",
    },
    legend="RMS: radial velocity of the outer ring, in the bands of ISO 15242-2 for radial ball"
    " bearings. Anderon: microinch RMS of motion per radian of rotation and per root of the band's"
    " octaves; at {speed} rpm one is {factors} µm/s.",
    one="{factor} ({band})",
    signals="Signals",
    signal_heads=("", "h", "low", "medium", "high", "verdict"),
    signals_legend="Bands in anderon.",
    over_time="Over the test",
    time_heads=("", "first", "last", "ratio", "growth %/100 h", "rejected (h)"),
    time_legend="Ratio: last to first. Growth: of the logarithm, by least squares through all"
    " measurements. Rejected: between the last measurement before it and the first above the"
    " limit.",
    record="Noise of bearing {bearing}",
    notes="Notes",
    note={
        "speed_unknown": "The signal does not tell the speed: anderons hold for 1800 rpm. Give"
        " --speed if it was another.",
        "speed_differs": "The speed is not within −2 and +1 % of 1800 rpm, as ISO 15242-2 wants it:"
        " anderons are reckoned with the actual speed, but bands and limits are those of 1800 rpm.",
        "band_incomplete": "The sampling rate of {rate} Hz does not hold: {bands}.",
        "near_half_rate": "10 kHz is near half the sampling rate of {rate} Hz: a recorder's filter"
        " may take a part of the high band.",
        "acceleration": "Velocity is made of the acceleration, line by line of the spectrum.",
        "displacement": "Velocity is made of the displacement, line by line of the spectrum.",
        "sensitivity": "The samples are scaled by {sensitivity}, as given.",
        "full_scale_one": "The file holds whole numbers: the recorder's full scale is taken as"
        " 1 {unit}.",
    },
    in_signals="{note} ({signals})",
    reading="blocks of the signal",
)

_PORTUGUESE: Final = NoiseWords(
    accepted="Aprovado: nenhuma faixa passa de {part} % do seu fundo de escala.",
    rejected="Reprovado: {bands}.",
    not_accepted="Não aprovado: {bands}.",
    above="faixa {band} com {value} anderon, onde se aceitam {limit}",
    unmeasured="faixa {band} não medida",
    no_verdict="Sem veredito: nenhum fundo de escala foi dado (--full-scale).",
    accepted_all="Aprovados: todos os {count} sinais; nenhuma faixa passa de {part} % do seu fundo"
    " de escala.",
    rejected_some="Reprovados: {rejected} de {count} sinais.",
    speed="rotação",
    speeds={
        "right": "{speed} rpm, como no ensaio",
        "known": "{speed} rpm; o ensaio é a 1800 rpm",
        "unknown": "não informada; supõem-se as 1800 rpm do ensaio",
    },
    signal="sinal",
    samples="{quantity}, {duration} s a {rate} Hz",
    quantities={
        "velocity": "velocidade",
        "acceleration": "aceleração",
        "displacement": "deslocamento",
        "unknown": "sinal",
    },
    bands={"low": "baixa", "medium": "média", "high": "alta"},
    table="Faixas",
    heads=("", "Hz", "µm/s rms", "anderon"),
    limit_heads=("escala", "% dela", "limite", "veredito"),
    verdicts={
        "accepted": "aprovado",
        "rejected": "reprovado",
        "not_measured": "não medida",
        "none": "sem veredito",
    },
    legend="Rms: velocidade radial do anel externo, nas faixas da ISO 15242-2 para rolamentos"
    " radiais de esferas. Anderon: micropolegada rms de movimento por radiano de rotação e por raiz"
    " do número de oitavas da faixa; a {speed} rpm, um é {factors} µm/s.",
    one="{factor} ({band})",
    signals="Sinais",
    signal_heads=("", "h", "baixa", "média", "alta", "veredito"),
    signals_legend="Faixas em anderon.",
    over_time="Ao longo do ensaio",
    time_heads=("", "primeiro", "último", "razão", "aumento %/100 h", "reprovado (h)"),
    time_legend="Razão: do último ao primeiro. Aumento: do logaritmo, por mínimos quadrados em"
    " todas as medições. Reprovado: entre a última medição antes e a primeira acima do limite.",
    record="Ruído do rolamento {bearing}",
    notes="Observações",
    note={
        "speed_unknown": "O sinal não informa a rotação: os anderons valem para 1800 rpm. Dê"
        " --speed se foi outra.",
        "speed_differs": "A rotação não está entre −2 e +1 % de 1800 rpm, como pede a ISO 15242-2:"
        " os anderons são calculados com a rotação real, mas faixas e limites são os de 1800 rpm.",
        "band_incomplete": "A taxa de amostragem de {rate} Hz não contém: {bands}.",
        "near_half_rate": "10 kHz está perto da metade da taxa de amostragem de {rate} Hz: o filtro"
        " do gravador pode tirar parte da faixa alta.",
        "acceleration": "A velocidade é obtida da aceleração, linha a linha do espectro.",
        "displacement": "A velocidade é obtida do deslocamento, linha a linha do espectro.",
        "sensitivity": "As amostras são convertidas por {sensitivity}, como dado.",
        "full_scale_one": "O arquivo contém números inteiros: o fundo de escala do gravador é"
        " tomado como 1 {unit}.",
    },
    in_signals="{note} ({signals})",
    reading="blocos do sinal",
)

NOISE_WORDS: Final[Mapping[str, NoiseWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
