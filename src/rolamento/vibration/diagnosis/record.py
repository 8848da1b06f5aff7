"""What a diagnosis says: a verdict for each part of the bearing, with its reasons."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band
from rolamento.vibration.diagnosis.orders import Component

__all__ = [
    "ComponentVerdict",
    "Diagnosis",
    "EnvelopeSpectra",
    "MatchedLine",
    "Note",
    "Reason",
    "UnexplainedLine",
    "Verdict",
]

Verdict = Literal["fault", "nothing_found", "not_tested"]


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
    band
        in which it is clearest; Hz
    probability
        that noise gives such a line anywhere, at most
    shaft_frequencies
        at which it would be the lowest line of a part, for parts and speeds that are near; Hz
    """

    order: float
    frequency: float
    above_noise: float
    band: Band
    probability: float
    shaft_frequencies: tuple[tuple[Component, float], ...]


@dataclass(frozen=True, slots=True)
class ComponentVerdict:
    """What the signal says of one part of the bearing.

    Attributes
    ----------
    component
        which part
    verdict
        "fault", "nothing_found" or "not_tested"
    probability
        that a bearing without damage gives as clear a finding anywhere in the search, at most; NaN
        if not tested
    evidence
        -log10 of that, also where it is too small for a number
    order, nominal_order
        of the fault as found, and as expected; order is NaN unless a fault was found
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
    """

    component: Component
    verdict: Verdict
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
        probability that was allowed for any fault in a bearing without damage
    tolerance
        part by which the cage was allowed to be off its nominal order
    trials
        how many hypotheses, orders and bands were tried together
    shaft_frequency
        mean; Hz
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
    revolutions: float
    blocks: int
    resolution: float
    spectra: EnvelopeSpectra
    unexplained: tuple[UnexplainedLine, ...]
    notes: tuple[Note, ...]

    @property
    def faults(self) -> tuple[Component, ...]:
        """Parts that are damaged by this verdict; none if nothing was found."""
        return tuple(part.component for part in self.components if part.verdict == "fault")

    def of(self, component: Component) -> ComponentVerdict:
        """Return the verdict for a component."""
        return next(part for part in self.components if part.component == component)
