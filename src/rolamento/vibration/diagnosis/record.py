"""What a diagnosis says: a verdict for each part of the bearing, with its reasons."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band
from rolamento.vibration.diagnosis.settings import Component
from rolamento.vibration.diagnosis.size import GRADES, Grade

Verdict = Literal["fault", "undecided", "watch", "nothing_found", "not_tested"]
"""Of a part: damaged; damaged or not, what speaks against it is as strong; lines as many healthy
bearings have; none, or none of its own; nothing can be told."""
SpeedSource = Literal["given", "shaft_lines", "fault_lines"]
"""What tells the speed of the shaft: what was given, its own lines, or those of the fault."""
Cause = Literal["outer_race", "inner_race", "ball", "cage", "ball_or_cage"]


@dataclass(frozen=True, slots=True)
class Reason:
    """Why a verdict is what it is: a name for a program, a sentence for a person."""

    name: str
    text: str


Note = Reason
"""Something about the whole diagnosis that its user should know."""


@dataclass(frozen=True, slots=True)
class MatchedLine:
    """One line of the squared envelope's spectrum that a fault was matched to.

    Attributes
    ----------
    multiple
        of the fault's order
    sideband
        how many spacings away
    order
        of the shaft
    frequency
        at the shaft's mean speed; Hz
    above_noise
        power of the strongest line within its width over the mean of the noise about it; dB, NaN if
        the line was left out
    """

    multiple: float
    sideband: int
    order: float
    frequency: float
    above_noise: float


@dataclass(frozen=True, slots=True)
class UnexplainedLine:
    """A line that stands out of the noise, and that neither bearing nor shaft explains.

    Attributes
    ----------
    order
        of the shaft
    frequency
        at the shaft's mean speed; Hz
    above_noise
        power over the mean of the noise about it; dB
    depth
        modulation depth of the squared envelope there
    band
        in which it is clearest; Hz
    probability
        that noise gives such a line anywhere, at most
    shaft_frequencies
        at which it would be the lowest line of a part, for parts and speeds that are near; Hz
    of_mains
        whether it is discrete, and at a multiple of 50 or 60 Hz
    """

    order: float
    frequency: float
    above_noise: float
    depth: float
    band: Band
    probability: float
    shaft_frequencies: tuple[tuple[Component, float], ...]
    of_mains: bool = False


@dataclass(frozen=True, slots=True)
class ComponentVerdict:
    """What the signal says of one part of the bearing.

    Attributes
    ----------
    component
        which part
    verdict
        "fault", "undecided", "watch", "nothing_found" or "not_tested"
    grade
        "severe", "damage", "watch" or "nothing": what the depth is worth
    depth
        modulation depth of the squared envelope at the order found, in the band named, over its
        mean; NaN if nothing is found there
    probability
        that noise without lines of the bearing gives as clear a finding anywhere in the search, at
        most; not that of a healthy bearing, which has such lines; NaN if not tested
    evidence
        -log10 of that, also where it is too small for a number
    order, nominal_order
        as found, and as expected; order is NaN unless something was found
    deviation
        order over the nominal one, less 1
    frequency
        of the fault as found, at the shaft's mean speed; Hz
    band
        in which it is clearest; Hz, None unless a fault was found
    lines
        multiples of the order that were matched
    sidebands
        about them that are clear, in the squared envelope as it is
    reasons
        why
    doubts
        what speaks against it
    """

    component: Component
    verdict: Verdict
    grade: Grade
    depth: float
    probability: float
    evidence: float
    nominal_order: float
    order: float
    deviation: float
    frequency: float
    band: Band | None
    lines: tuple[MatchedLine, ...]
    sidebands: tuple[MatchedLine, ...]
    reasons: tuple[Reason, ...]
    doubts: tuple[Reason, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class EnvelopeSpectra:
    """Spectra of the squared envelopes of all bands, for pictures.

    Attributes
    ----------
    order
        (lines,); of the shaft
    bands
        Hz
    above_noise
        (bands, lines), power over the mean of the noise about each line; NaN where that is unknown
    evidence
        (bands,) for each component that was looked for: -ln of the least probability of one trial
    """

    order: FloatArray
    bands: tuple[Band, ...]
    above_noise: FloatArray
    evidence: dict[Component, FloatArray]


@dataclass(frozen=True, slots=True, eq=False)
class Diagnosis:
    """What a signal says of a bearing.

    Attributes
    ----------
    components
        a verdict for each
    false_alarm
        probability that was allowed for any finding in noise without lines of the bearing
    tolerance
        part by which the cage was allowed to be off its nominal order
    trials
        how many hypotheses, orders and bands were tried together
    shaft_frequency
        mean, as it was taken; Hz
    speed_factor
        of that over the given one
    speed_source
        "given", "shaft_lines" or "fault_lines": what tells it
    speed_confirmed
        whether the shaft's own lines tell or agree with it, or it was certain
    undecided
        parts that would be damaged if the shaft ran at another speed, and that speed; Hz
    revolutions
        of the shaft that were used
    blocks
        of which the spectra are means
    resolution
        of the orders
    spectra
        that were searched
    unexplained
        lines that stand out and belong to nothing that is known, the clearest first
    notes
        names and sentences
    """

    components: tuple[ComponentVerdict, ...]
    false_alarm: float
    tolerance: float
    trials: int
    shaft_frequency: float
    speed_factor: float
    speed_source: SpeedSource
    speed_confirmed: bool
    undecided: tuple[tuple[Component, float], ...]
    revolutions: float
    blocks: int
    resolution: float
    spectra: EnvelopeSpectra
    unexplained: tuple[UnexplainedLine, ...]
    notes: tuple[Note, ...]

    @property
    def faults(self) -> tuple[Component, ...]:
        """Parts that are damaged by this verdict, the deepest modulation first."""
        return self._with("fault")

    @property
    def watched(self) -> tuple[Component, ...]:
        """Parts with lines as many healthy bearings have, the deepest modulation first."""
        return self._with("watch")

    @property
    def causes(self) -> tuple[Cause, ...]:
        """What is damaged, the deepest modulation first: lines of the cage may be a ball's."""
        return tuple(self.cause(part) for part in self.faults)

    def cause(self, component: Component) -> Cause:
        """What lines of a part speak for: those of a cage may be of a ball that it carries."""
        ball = self.of("ball")
        unknown = component == "cage" and ball.verdict != "fault" and ball.nominal_order > 0.0
        return "ball_or_cage" if unknown else component

    @property
    def grade(self) -> Grade:
        """Of the worst part that is stated."""
        stated = [part.grade for part in self.components if part.verdict in ("fault", "watch")]
        return max(stated, key=GRADES.index, default="nothing")

    def _with(self, verdict: Verdict) -> tuple[Component, ...]:
        parts = [part for part in self.components if part.verdict == verdict]
        return tuple(p.component for p in sorted(parts, key=lambda part: -part.depth))

    @property
    def clearest_fault(self) -> ComponentVerdict | None:
        """The fault with the most evidence; None if there is none."""
        faults = [part for part in self.components if part.verdict == "fault"]
        return max(faults, key=lambda part: part.evidence) if faults else None

    @property
    def clearest_band(self) -> int:
        """Number of the band of the clearest fault, unexplained line, or else best match."""
        fault, bands = self.clearest_fault, self.spectra.bands
        if fault is not None and fault.band in bands:
            return bands.index(fault.band)
        if self.unexplained:
            return bands.index(self.unexplained[0].band)
        scores = [
            np.nan_to_num(np.asarray(per_band, dtype=np.float64), nan=-1.0, posinf=1e300)
            for per_band in self.spectra.evidence.values()
        ]
        return int(np.argmax(np.max(scores, axis=0))) if scores else 0

    def of(self, component: Component) -> ComponentVerdict:
        """Return the verdict for a component."""
        return next(part for part in self.components if part.component == component)
