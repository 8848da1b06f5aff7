"""What the page of a synthetic signal says, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rolamento.vibration.frequencies import FaultKind

__all__ = ["SYNTHESIS_WORDS", "SynthesisWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class SynthesisWords:
    """The words of one language; `{…}` are filled in by the one who says it."""

    written: str
    damaged: str
    sound: str
    the_faults: Mapping[FaultKind, str]
    all_of: str

    bearing: str
    shaft: str
    speeds: Mapping[str, str]
    outer_speed: str
    slip: str
    steady: str
    swinging: str
    wandering: str
    signal: str
    samples: str
    load: str
    loads: Mapping[str, str]
    load_turns: str
    noise: str
    noises: Mapping[str, str]
    level: str
    ratios: Mapping[str, str]
    modes: str
    mode: str
    seed: str
    files: str
    holds: Mapping[str, str]
    truth: str

    planted: str
    heads: tuple[str, ...]
    faults: Mapping[FaultKind, str]
    legend: str
    legend_no_noise: str
    lines: str
    line_heads: tuple[str, ...]
    surfaces: Mapping[str, str]
    shaft_line: str
    more: str
    too_high: str

    notes: str
    note: Mapping[str, str]
    next: str
    making: str


_ENGLISH: Final = SynthesisWords(
    written="Written: {path}, {duration} s {what}.",
    damaged="of a bearing with damage to {faults}",
    sound="of a sound bearing",
    the_faults={
        "outer_race": "the outer race",
        "inner_race": "the inner race",
        "ball": "a ball",
        "cage": "the cage",
    },
    all_of="{list} and {last}",
    bearing="bearing",
    shaft="shaft",
    speeds={"inner": "{speed} rpm ({frequency} Hz)", "outer": "inner ring {speed} rpm"},
    outer_speed="outer ring {speed} rpm",
    slip="the cage lags by {slip} %",
    steady="steady",
    swinging="swinging by {depth} % at {frequency} Hz",
    wandering="wandering by {deviation} % (standard deviation), memory {memory} s",
    signal="signal",
    samples="acceleration, {count} samples at {rate} Hz; RMS {rms} m/s²",
    load="load",
    loads={
        "uniform": "equal all round",
        "radial": "radial, load zone ε {extent}",
        "solved": "of the solved case",
    },
    load_turns="turning at {turns} times the shaft's speed",
    noise="noise",
    noises={"white": "white", "pink": "pink", "none": "none"},
    level="RMS {level} m/s²",
    ratios={"faults": "faults to noise {ratio} dB", "signal": "signal to noise {ratio} dB"},
    modes="rings at",
    mode="{frequency} Hz (damping {damping})",
    seed="seed",
    files="files",
    holds={
        ".wav": "32-bit floats in m/s²; rate",
        ".csv": "nine digits; rate, unit, mean speed",
        ".npz": "samples to the last bit; rate, mean speed",
    },
    truth="every impact, and all that is known",
    planted="Planted",
    heads=("", "order", "Hz", "impacts", "RMS m/s²", "to noise dB", "jitter %"),
    faults={
        "outer_race": "outer race",
        "inner_race": "inner race",
        "ball": "ball",
        "cage": "cage",
    },
    legend="Order: of the shaft. Impacts: with any force. RMS: of what the fault alone makes. To"
    " noise: of its power over that of the noise. Jitter: standard deviation of the intervals.",
    legend_no_noise="Order: of the shaft. Impacts: with any force. RMS: of what the fault alone"
    " makes. Jitter: standard deviation of the intervals.",
    lines="Lines",
    line_heads=("", "waves", "order", "Hz", "nm", "RMS m/s²"),
    surfaces={"outer": "outer race", "inner": "inner race", "ball": "ball"},
    shaft_line="shaft",
    more="{count} weaker lines are left out here.",
    too_high="{count} lines beyond half the rate are not in the signal.",
    notes="Notes",
    note={
        "unstruck": "Damage to {faults} makes no impact with any force: no ball is pressed where"
        " it lies, or the signal is too short.",
        "frequency": "Modulation of frequency is what Braga and Almeida suppose, not what impacts"
        " do: its envelope is flat.",
        "inferred_inside": "The inside of this bearing is inferred from its ratings (see rolamento"
        " catalogue).",
    },
    next="To look for it:",
    making="making the signal",
)

_PORTUGUESE: Final = SynthesisWords(
    written="Gravado: {path}, {duration} s {what}.",
    damaged="de um rolamento com dano em {faults}",
    sound="de um rolamento sadio",
    the_faults={
        "outer_race": "pista externa",
        "inner_race": "pista interna",
        "ball": "esfera",
        "cage": "gaiola",
    },
    all_of="{list} e {last}",
    bearing="rolamento",
    shaft="eixo",
    speeds={"inner": "{speed} rpm ({frequency} Hz)", "outer": "anel interno {speed} rpm"},
    outer_speed="anel externo {speed} rpm",
    slip="a gaiola atrasa {slip} %",
    steady="constante",
    swinging="oscilando {depth} % a {frequency} Hz",
    wandering="variando {deviation} % (desvio padrão), memória de {memory} s",
    signal="sinal",
    samples="aceleração, {count} amostras a {rate} Hz; rms {rms} m/s²",
    load="carga",
    loads={
        "uniform": "igual em toda a volta",
        "radial": "radial, zona de carga ε {extent}",
        "solved": "do caso resolvido",
    },
    load_turns="girando a {turns} vezes a rotação do eixo",
    noise="ruído",
    noises={"white": "branco", "pink": "rosa", "none": "nenhum"},
    level="rms {level} m/s²",
    ratios={"faults": "defeitos sobre ruído {ratio} dB", "signal": "sinal sobre ruído {ratio} dB"},
    modes="ressoa em",
    mode="{frequency} Hz (amortecimento {damping})",
    seed="semente",
    files="arquivos",
    holds={
        ".wav": "ponto flutuante de 32 bits em m/s²; taxa",
        ".csv": "nove algarismos; taxa, unidade, rotação média",
        ".npz": "amostras até o último bit; taxa, rotação média",
    },
    truth="cada impacto e tudo o que se sabe",
    planted="Inserido",
    heads=("", "ordem", "Hz", "impactos", "rms m/s²", "sobre ruído dB", "jitter %"),
    faults={
        "outer_race": "pista externa",
        "inner_race": "pista interna",
        "ball": "esfera",
        "cage": "gaiola",
    },
    legend="Ordem: do eixo. Impactos: os que têm força. Rms: do que o defeito faz sozinho. Sobre"
    " ruído: da sua potência sobre a do ruído. Jitter: desvio padrão dos intervalos.",
    legend_no_noise="Ordem: do eixo. Impactos: os que têm força. Rms: do que o defeito faz"
    " sozinho. Jitter: desvio padrão dos intervalos.",
    lines="Linhas",
    line_heads=("", "ondas", "ordem", "Hz", "nm", "rms m/s²"),
    surfaces={"outer": "pista externa", "inner": "pista interna", "ball": "esfera"},
    shaft_line="eixo",
    more="{count} linhas mais fracas não são mostradas aqui.",
    too_high="{count} linhas acima da metade da taxa não estão no sinal.",
    notes="Observações",
    note={
        "unstruck": "O dano em {faults} não faz nenhum impacto com força: nenhuma esfera é"
        " pressionada onde ele está, ou o sinal é curto demais.",
        "frequency": "A modulação de frequência é o que Braga e Almeida supõem, não o que os"
        " impactos fazem: a sua envoltória é plana.",
        "inferred_inside": "O interior deste rolamento é deduzido das suas capacidades (veja"
        " rolamento catalogue).",
    },
    next="Para procurá-lo:",
    making="fazendo o sinal",
)

SYNTHESIS_WORDS: Final[Mapping[str, SynthesisWords]] = {"en": _ENGLISH, "pt": _PORTUGUESE}
