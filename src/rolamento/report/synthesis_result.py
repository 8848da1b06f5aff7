"""A synthetic signal with its truth: what was planted, and how strong each part is."""

from __future__ import annotations

import shlex
from dataclasses import asdict, dataclass
from functools import cached_property
from math import isfinite, log10, nan, pi, sqrt
from typing import Any, Final, Literal, NamedTuple

import numpy as np

from rolamento.case.bearing import Bearing
from rolamento.report.plain_data import json_text
from rolamento.vibration.synthesis import (
    Fault,
    FaultTruth,
    GivenSpeed,
    Recipe,
    SteadySpeed,
    Synthesis,
)

__all__ = ["PlantedFault", "PlantedLine", "SynthesisResult", "truth_json"]

SCHEMA: Final = 1

LoadName = Literal["uniform", "radial", "solved"]

_TURN: Final = 2.0 * pi
_RPM: Final = 30.0 / pi


class PlantedFault(NamedTuple):
    """What a fault makes: impacts with any force, power over the noise's (dB)."""

    fault: Fault
    truth: FaultTruth
    impacts: int
    to_noise: float


class PlantedLine(NamedTuple):
    """A line of a wavy surface or the shaft: waves a turn, order, Hz, amplitude (m), RMS (m/s²)."""

    source: Literal["outer", "inner", "ball", "shaft"]
    waves: int
    order: float
    frequency: float
    amplitude: float
    rms: float


@dataclass(frozen=True, eq=False)
class SynthesisResult:
    """All that the command made.

    Attributes
    ----------
    name
        designation or title of the case
    source
        what BEARING was given as
    bearing
        whose vibration this is
    made
        the signal and its truth
    load, extent
        name of the load distribution; ε of a radial one
    path, truth_path
        where signal and truth were written; None if the truth was not
    """

    name: str
    source: str
    bearing: Bearing
    made: Synthesis
    load: LoadName
    extent: float
    path: str
    truth_path: str | None

    @property
    def recipe(self) -> Recipe:
        """That the signal was made by."""
        return self.made.truth.recipe

    @cached_property
    def rms(self) -> float:
        """Of the signal; m/s²."""
        return sqrt(float(np.mean(np.square(self.made.signal.samples))))

    @cached_property
    def faults(self) -> tuple[PlantedFault, ...]:
        """What each fault makes."""
        truth = self.made.truth
        found = []
        for fault, told in zip(self.recipe.faults, truth.faults, strict=True):
            struck = int(np.count_nonzero(told.strengths > 0.0))
            to_noise = _decibels(told.rms, truth.noise_level)
            found.append(PlantedFault(fault, told, struck, to_noise))
        return tuple(found)

    @cached_property
    def lines(self) -> tuple[PlantedLine, ...]:
        """Lines of waviness and of the shaft, the strongest first."""
        shaft = abs(float(np.mean(self.made.truth.speed))) / _TURN
        found = [
            PlantedLine(
                line.surface, line.waves, line.order, line.order * shaft, line.amplitude,
                line.amplitude * (_TURN * line.order * shaft) ** 2 / sqrt(2.0),
            )
            for line in self.made.truth.waviness_lines
        ]  # fmt: skip
        for order, size in enumerate(self.recipe.shaft_harmonics, start=1):
            place = order * shaft
            amplitude = size / (_TURN * place) ** 2
            found.append(
                PlantedLine("shaft", order, float(order), place, amplitude, size / sqrt(2.0))
            )
        return tuple(sorted(found, key=lambda line: -line.rms))

    @property
    def steady(self) -> bool:
        """Whether the shaft keeps its speed."""
        return self.recipe.speed is None or isinstance(self.recipe.speed, SteadySpeed)

    @property
    def command(self) -> str:
        """How to have the signal diagnosed; what its file tells is left out."""
        words = ["rolamento", "diagnose", self.path, "--bearing", self.source]
        found = self.recipe.frequencies
        if self.path.lower().endswith(".wav") or found.outer_speed != 0.0:
            words += ["--speed", f"{_RPM * found.inner_speed:.6g} rpm"]
        if found.outer_speed != 0.0:
            words += ["--outer-speed", f"{_RPM * found.outer_speed:.6g} rpm"]
        return shlex.join(words)


def truth_json(found: SynthesisResult) -> str:
    """Return the truth and the recipe as one JSON object, in SI units, Hz and dB."""
    recipe, truth = found.recipe, found.made.truth
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "synthesis",
            "bearing": found.name,
            "file": found.path,
            "unit": found.made.signal.unit,
            "rms": found.rms,
            **truth.to_mapping(),
            "faults": [
                {**one.truth.to_mapping(), "to_noise": one.to_noise} for one in found.faults
            ],
            "recipe": {
                "faults": [asdict(fault) for fault in recipe.faults],
                "load": {"kind": found.load, "extent": found.extent},
                "load_turns": recipe.load_turns,
                "path": asdict(recipe.path),
                "modes": [asdict(mode) for mode in recipe.modes],
                "shaft_harmonics": list(recipe.shaft_harmonics),
                "waviness": [asdict(one) for one in recipe.waviness],
                "noise": None if recipe.noise is None else asdict(recipe.noise),
                "speed": _profile(found),
            },
        }
    )


def _profile(found: SynthesisResult) -> dict[str, Any]:
    profile = found.recipe.speed
    if profile is None or isinstance(profile, GivenSpeed):
        return {"kind": "SteadySpeed", "speed": float(np.mean(found.made.truth.speed))}
    return {"kind": type(profile).__name__, **asdict(profile)}


def _decibels(rms: float, noise: float) -> float:
    if not (rms > 0.0 and noise > 0.0 and isfinite(rms)):
        return nan
    return 20.0 * log10(rms / noise)
