"""All that a diagnosis is reported from: what was found, of which bearing, at which speed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import inf, isfinite
from typing import Final, Literal

from rolamento.case.bearing import Bearing
from rolamento.state import State
from rolamento.vibration.diagnosis import ComponentVerdict, Diagnosis, DiagnosisSettings
from rolamento.vibration.frequencies import FaultFrequencies
from rolamento.vibration.reading import ReadingNote
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import Indicators, indicators

__all__ = ["DiagnosisResult", "ShaftSpeed", "SpeedSource", "Tracking"]

SpeedSource = Literal["given", "file", "case", "channel", "pulses", "vibration"]
"""Who told the speed: an option, the signal's file, the case; or from what it was measured."""

_CLEAR: Final = 9.0
"""dB above the noise that a line of noise alone reaches once in three thousand."""


@dataclass(frozen=True, slots=True)
class Tracking:
    """What came of looking for the speed in the vibration itself.

    Attributes
    ----------
    nominal
        about which it was looked for; rad/s
    within
        part of that
    found
        whether the shaft stands out of the noise all along
    evidence
        -log10 of the probability that noise gives as clear a path, of the least clear stretch
    lost
        beginning and end of the first stretch in which it does not stand out, s; None if found
    """

    nominal: float
    within: float
    found: bool
    evidence: float
    lost: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class ShaftSpeed:
    """How fast the shaft turned, and how that is known.

    Attributes
    ----------
    source
        where the speed is from
    mean, least, most
        over the signal, signed; rad/s
    channel
        that it was measured in
    pulses
        per revolution, of a tachometer
    tracking
        of a speed that was looked for in the vibration
    """

    source: SpeedSource
    mean: float
    least: float
    most: float
    channel: str = ""
    pulses: int | None = None
    tracking: Tracking | None = None

    @classmethod
    def steady(cls, source: SpeedSource, speed: float) -> ShaftSpeed:
        """Return a speed that is one number; rad/s."""
        return cls(source, speed, speed, speed)

    @property
    def is_steady(self) -> bool:
        """Whether one number was taken for all of the signal."""
        return self.source in ("given", "file", "case")

    @property
    def lost(self) -> bool:
        """Whether it was looked for in the vibration, and not found."""
        return self.tracking is not None and not self.tracking.found


@dataclass(frozen=True, eq=False)
class DiagnosisResult:
    """All that the command finds.

    Attributes
    ----------
    title
        of the signal
    bearing_name
        designation or title of the case
    bearing
        whose vibration this is
    frequencies
        that were looked for, at the mean speed: of the loaded bearing, or of its geometry
    diagnosis, settings
        what was found, and how it was looked for
    signal
        that was diagnosed, or its first part if it is long
    duration
        of all; s
    reading_notes
        how the samples were taken from their file
    choices
        those of them that tell what was taken for the rate or the speed where it is told twice
    speed
        of the shaft; None if all that is known are the frequencies
    state
        of the loaded bearing; None if the frequencies are those of the geometry by choice
    slip
        part by which the cage was allowed to be off before the range over the balls widened it;
        None if nothing did
    covers_balls
        whether the orders of all loaded balls were looked for
    other_rows
        rows, counted from 0, whose balls have orders that were not
    """

    title: str
    bearing_name: str
    bearing: Bearing
    frequencies: FaultFrequencies
    diagnosis: Diagnosis
    settings: DiagnosisSettings
    signal: Signal
    duration: float
    reading_notes: tuple[str, ...] = ()
    choices: tuple[ReadingNote, ...] = ()
    speed: ShaftSpeed | None = None
    state: State | None = None
    slip: float | None = None
    covers_balls: bool = True
    other_rows: tuple[int, ...] = ()

    @cached_property
    def indicators(self) -> Indicators:
        """Size and peakedness of the signal, or of its first part."""
        return indicators(self.signal)

    @property
    def still(self) -> bool:
        """Whether the signal does not change at all."""
        parts = self.diagnosis.components
        if parts and all(_is_still(part) for part in parts):
            return True
        whole = self.signal.duration >= self.duration * (1.0 - 1e-9)
        return whole and self.indicators.peak_to_peak == 0.0

    @property
    def speed_lost(self) -> bool:
        """Whether the speed was looked for in the vibration, and not found."""
        return self.speed is not None and self.speed.lost

    @property
    def verdict(self) -> Literal["fault", "undecided", "watch", "nothing_found", "no_verdict"]:
        """What it comes to."""
        verdicts = {part.verdict for part in self.diagnosis.components}
        if "fault" in verdicts:
            return "fault"
        if self.still:
            return "no_verdict"
        if "undecided" in verdicts or self.diagnosis.undecided:
            return "undecided"
        if "watch" in verdicts:
            return "watch"
        nothing = "nothing_found" in verdicts and self.races_tested and not self.speed_lost
        return "nothing_found" if nothing else "no_verdict"

    @property
    def races_tested(self) -> bool:
        """Whether all races that are looked for were tested: else nothing found is no verdict."""
        sought = [part for part in self.diagnosis.components if not _has(part, "no_order")]
        parts = [part for part in sought if part.component in _RACES] or sought
        return bool(parts) and all(part.verdict != "not_tested" for part in parts)

    @property
    def own_notes(self) -> tuple[str, ...]:
        """Names of what is to be known beside the engine's notes."""
        faults = [part for part in self.diagnosis.components if part.verdict == "fault"]
        holds = {
            "not_a_certificate": self.verdict in ("nothing_found", "watch"),
            "weak_lines": any(_highest_line(part) < _CLEAR for part in faults),
            "speed_not_found": self.speed_lost,
            "no_loaded_frequencies": self.state is not None and self.frequencies.source != "loaded",
            "range_not_covered": not self.covers_balls,
            "other_rows": bool(self.other_rows),
            "inferred_inside": "inferred" in self.bearing.origins.values(),
        }
        return tuple(name for name, is_so in holds.items() if is_so)


_RACES: Final = ("outer_race", "inner_race")
"""Most damage begins on them: a record that is silent about one is not one of a healthy bearing."""


def _is_still(part: ComponentVerdict) -> bool:
    return part.verdict == "not_tested" and _has(part, "no_change")


def _has(part: ComponentVerdict, reason: str) -> bool:
    return any(one.name == reason for one in part.reasons)


def _highest_line(part: ComponentVerdict) -> float:
    """Return by how much the highest multiple of a fault stands out; dB, -inf if none is seen."""
    levels = [line.above_noise for line in part.lines if isfinite(line.above_noise)]
    return max(levels, default=-inf)
