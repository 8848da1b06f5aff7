"""What a diagnosis says: a verdict for each part of the bearing, with its reasons."""

from __future__ import annotations

from dataclasses import asdict, replace
from math import isfinite, nan, pi
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.diagnosis.settings import Component
from rolamento.vibration.diagnosis.size import DAMAGE, GRADES, Grade, depth_of
from rolamento.vibration.signal import Band
from rolamento.words import Note
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.vibration.frequencies import RollingElement

Verdict = Literal["fault", "undecided", "watch", "nothing_found", "not_tested"]
"""Verdict of a part: damaged; undecided, as the evidence against it is as strong; peaks as in many
healthy bearings; none, or none of its own; could not be tested."""
SpeedSource = Literal["given", "shaft_lines", "fault_lines"]
"""Where the speed of the shaft comes from: as given, its own peaks, or those of the fault."""
Cause = Literal["outer_race", "inner_race", "ball", "cage", "ball_or_cage"]

_ADVICE: Final = {
    "severe": "replace_bearing",
    "damage": "plan_replacement",
    "watch": "measure_as_usual",
    "smooth": "compare_with_healthy",
    "undecided": "resolve_doubts",
}


@frozen
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


@frozen
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
    smooth
        whether it is as deep as damage, but comes without impacts: see `size.is_smooth`
    """

    order: float
    frequency: float
    above_noise: float
    depth: float
    band: Band
    probability: float
    shaft_frequencies: tuple[tuple[Component, float], ...]
    of_mains: bool = False
    smooth: bool = False

    def to_mapping(self) -> dict[str, Any]:
        """Return what a note says of it: frequencies in Hz, speeds in rad/s."""
        return {
            "order": self.order,
            "frequency": self.frequency,
            "above_noise": self.above_noise,
            "depth": self.depth,
            "band": list(self.band),
            "of_mains": self.of_mains,
            "smooth": self.smooth,
            "speeds": [[part, 2.0 * pi * shaft] for part, shaft in self.shaft_frequencies],
        }


@frozen
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
    band_kurtosis
        of the whitened samples in that band; 3 for noise, NaN without a band
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
    reasons: tuple[Note, ...]
    doubts: tuple[Note, ...] = ()
    band_kurtosis: float = nan

    def of_element(self, element: RollingElement) -> ComponentVerdict:
        """Return the verdict with its notes as they are said of balls, or of rollers."""
        reasons, doubts = (
            tuple(of_element(note, element) for note in notes)
            for notes in (self.reasons, self.doubts)
        )
        return replace(self, reasons=reasons, doubts=doubts)

    def to_mapping(self) -> dict[str, Any]:
        """Return all of it as plain mappings and lists."""
        return {
            "component": self.component,
            "verdict": self.verdict,
            "grade": self.grade,
            "depth": self.depth,
            "probability": self.probability,
            "evidence": self.evidence,
            "nominal_order": self.nominal_order,
            "order": self.order,
            "deviation": self.deviation,
            "frequency": self.frequency,
            "band": self.band,
            "band_kurtosis": self.band_kurtosis,
            "lines": [asdict(line) for line in self.lines],
            "sidebands": [asdict(line) for line in self.sidebands],
            "reasons": [note.to_mapping() for note in self.reasons],
            "doubts": [note.to_mapping() for note in self.doubts],
        }


@frozen(eq=False)
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
    squared_depth
        (bands, lines), mean squares of the modulation depth, less those of noise; 0 at lines of
        what turns
    evidence
        (bands,) for each component that was looked for: -ln of the least probability of one trial
    """

    order: FloatArray
    bands: tuple[Band, ...]
    above_noise: FloatArray
    squared_depth: FloatArray
    evidence: dict[Component, FloatArray]

    def depth_about(self, order: float, within: float) -> float:
        """Return the deepest modulation of any band near an order; NaN beyond the spectra.

        Noise lifts the deepest of many lines: it is at most that.

        within: part of the order to either side.
        """
        turns = 1.0 / float(self.order[1])
        lines = range(
            max(1, round(order * (1.0 - within) * turns)),
            round(order * (1.0 + within) * turns) + 1,
        )
        if not lines or lines[-1] >= len(self.order):
            return nan
        return max(depth_of(band, line, 1) for band in self.squared_depth for line in lines)


@frozen(eq=False)
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
        "given", "shaft_lines" or "fault_lines": where it is from
    speed_confirmed
        whether the shaft's own lines give it or agree with it, or it was certain
    kurtosis
        of the samples that were used; 3 for noise
    undecided
        parts that would be damaged if the shaft ran at another speed, and that speed; Hz
    impacts
        the deepest peak that nothing explains, where nothing else is stated and it is as deep as
        damage; None if there is none
    slips
        parts whose peak that would be if the cage turned faster by a part than is allowed
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
        what its reader should know
    element
        what rolls, "ball" or "roller": what the component "ball" is
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
    impacts: UnexplainedLine | None
    slips: tuple[tuple[Component, float], ...]
    kurtosis: float
    revolutions: float
    blocks: int
    resolution: float
    spectra: EnvelopeSpectra
    unexplained: tuple[UnexplainedLine, ...]
    notes: tuple[Note, ...]
    element: RollingElement = "ball"

    @property
    def faults(self) -> tuple[Component, ...]:
        """Parts that are damaged by this verdict, the deepest modulation first."""
        return self._with("fault")

    @property
    def watched(self) -> tuple[Component, ...]:
        """Parts as deeply modulated as damaged ones, without impacts; the deepest first.

        A part whose peaks are as small as those of many healthy bearings is not named: they are
        as often another's.
        """
        return tuple(part for part in self._with("watch") if self.of(part).depth >= DAMAGE)

    @property
    def modulation(self) -> UnexplainedLine | None:
        """The deepest smooth modulation that nothing explains, where no part is as deep."""
        if self.undecided or self.impacts is not None:
            return None
        least = max((part.depth for part in self.stated), default=DAMAGE)
        smooth = [line for line in self.unexplained if line.smooth and not line.of_mains]
        deep = [line for line in smooth if line.depth >= max(least, DAMAGE)]
        return max(deep, key=lambda line: line.depth, default=None)

    @property
    def causes(self) -> tuple[Cause, ...]:
        """What is damaged, the deepest modulation first: lines of the cage may be a ball's."""
        return tuple(self.cause(part) for part in self.faults)

    def cause(self, component: Component) -> Cause:
        """Return whose peaks those of a part may be: of a cage, perhaps a ball that it carries."""
        ball = self.of("ball")
        unknown = component == "cage" and ball.verdict != "fault" and ball.nominal_order > 0.0
        return "ball_or_cage" if unknown else component

    @property
    def grade(self) -> Grade:
        """Grade of the worst part that is stated."""
        stated = [part.grade for part in self.components if part.verdict in ("fault", "watch")]
        return max(stated, key=GRADES.index, default="nothing")

    @property
    def stated(self) -> tuple[ComponentVerdict, ...]:
        """Parts that the verdict names, the deepest modulation first."""
        named = [p for p in self.components if p.verdict in ("fault", "undecided", "watch")]
        return tuple(sorted(named, key=lambda part: -part.depth))

    def statement(self, *, still: bool = False) -> tuple[Note, ...]:
        """Return what the diagnosis comes to.

        Parameters
        ----------
        still
            Whether the signal does not change at all: then its spectra mean nothing.
        """
        if still and not self.faults:
            return (Note("signal_constant"),)
        parts = self.components
        tested = [p.component for p in parts if p.verdict not in ("not_tested", "fault")]
        untested = [p.component for p in parts if p.verdict == "not_tested"]
        if not self.stated and not tested:
            return (Note("no_part_tested"),)
        notes = [self._stated(part) for part in self.stated]
        if self.undecided:
            speeds = [[part, 2.0 * pi * frequency] for part, frequency in self.undecided]
            notes.append(Note("undecided_speed", {"speeds": speeds}))
        elif self.impacts is not None:
            notes.insert(0, self._undecided_impacts(self.impacts))
        elif (smooth := self.modulation) is not None:
            values = {"frequency": smooth.frequency, "depth": smooth.depth}
            notes.insert(0, Note("unexplained_modulation", values))
        elif not self.stated:
            clear = any(part.probability <= self.false_alarm for part in parts)
            notes.append(Note("nothing_own" if clear else "nothing_found", {"parts": tested}))
        leading = self.stated or self.undecided or self.impacts or self.modulation
        if self.unexplained and not leading:
            deepest = max(self.unexplained, key=lambda line: line.depth)
            values = {"frequency": deepest.frequency, "depth": deepest.depth}
            notes.append(Note("other_peaks", values))
        if untested:
            notes.append(Note("parts_untested", {"parts": untested}))
        return tuple(of_element(note, self.element) for note in notes)

    def _stated(self, part: ComponentVerdict) -> Note:
        verdict = "part_severely_damaged" if part.grade == "severe" else "part_damaged"
        if part.verdict != "fault":
            smooth = "part_smooth" if part.depth >= DAMAGE else "peaks_watched"
            verdict = "part_undecided" if part.verdict == "undecided" else smooth
        seen = [line for line in part.lines if line.multiple != 1.0 and isfinite(line.above_noise)]
        values = {
            "part": self.cause(part.component),
            "frequency": part.frequency,
            "multiples": len(seen),
            "depth": part.depth,
        }
        return Note(verdict, values)

    def _undecided_impacts(self, line: UnexplainedLine) -> Note:
        values = {
            "frequency": line.frequency,
            "depth": line.depth,
            "slips": [list(one) for one in self.slips],
        }
        return Note("undecided_slip" if self.slips else "undecided_impacts", values)

    @property
    def advice(self) -> tuple[Note, ...]:
        """What to do, and the evidence against the verdict; empty where nothing is found."""
        if self.undecided:
            return (Note("find_speed"),)
        if self.impacts is not None:
            return (Note("find_cage_speed" if self.slips else "explain_impacts"),)
        if self.modulation is not None:
            return (Note("explain_impacts"),)
        if not self.stated:
            return ()
        doubts = dict.fromkeys(doubt for part in self.stated for doubt in part.doubts)
        against = [{"key": doubt.key, "values": dict(doubt.values)} for doubt in doubts]
        undecided = self.stated[0].verdict == "undecided"
        grade = "smooth" if self.watched else self.grade
        return (
            Note(_ADVICE["undecided" if undecided else grade]),
            Note("doubts", {"doubts": against}) if against else Note("no_doubts"),
        )

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

    @property
    def bands_shown(self) -> list[int]:
        """Numbers of the bands of all parts that are stated; without any, the clearest band."""
        found = {part.band for part in self.components}
        shown = [place for place, band in enumerate(self.spectra.bands) if band in found]
        return shown or [self.clearest_band]

    def of(self, component: Component) -> ComponentVerdict:
        """Return the verdict for a component."""
        return next(part for part in self.components if part.component == component)
