"""Synthetic vibration signals with a known truth: damage, waviness, the shaft, noise.

>>> from rolamento import Bearing
>>> from rolamento.vibration.frequencies import nominal_frequencies
>>> from rolamento.vibration.synthesis import Fault, Recipe, synthesise
>>> found = nominal_frequencies(Bearing.named("6205"), 188.2)
>>> made = synthesise(Recipe(frequencies=found, faults=(Fault(kind="outer_race"),), duration=1.0))
>>> made.signal.unit, len(made.truth.faults[0].times)
('m/s^2', 107)
"""

from __future__ import annotations

from rolamento.vibration.synthesis.assemble import (
    FaultTruth,
    Noise,
    Recipe,
    Synthesis,
    Truth,
    recipe_of,
    synthesise,
)
from rolamento.vibration.synthesis.faults import Fault, LoadDistribution
from rolamento.vibration.synthesis.speed import (
    GivenSpeed,
    SpeedProfile,
    SteadySpeed,
    SwingingSpeed,
    WanderingSpeed,
)
from rolamento.vibration.synthesis.transfer import DEFAULT_MODES, Mode, TransferPath
from rolamento.vibration.synthesis.waviness import Waviness, WavinessLine, waviness_lines

__all__ = [
    "DEFAULT_MODES",
    "Fault",
    "FaultTruth",
    "GivenSpeed",
    "LoadDistribution",
    "Mode",
    "Noise",
    "Recipe",
    "SpeedProfile",
    "SteadySpeed",
    "SwingingSpeed",
    "Synthesis",
    "TransferPath",
    "Truth",
    "WanderingSpeed",
    "Waviness",
    "WavinessLine",
    "recipe_of",
    "synthesise",
    "waviness_lines",
]
