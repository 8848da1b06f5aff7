"""What a vibration record says of a bearing: at which speed, by which peaks, how surely."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict, replace
from functools import cached_property
from itertools import product
from math import ceil, inf, isfinite, pi
from typing import TYPE_CHECKING, Any, Final, Literal, TypeVar, Unpack

import numpy as np

from rolamento.case import Case, case_of
from rolamento.case.bearing import Bearing
from rolamento.case.case import BearingLike, name_of
from rolamento.case.fields import Changes
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import catalogue, rolling_bearings
from rolamento.errors import InputError, arguments
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.bearing import angle_of, at_speeds, has_load
from rolamento.tasks.parameters import Progress, quietly, speed_of
from rolamento.tasks.shaft_speed import KnownSpeed, ShaftSpeed, SpeedInputs, known_speed
from rolamento.tasks.signals import Reading, part_of, streamed
from rolamento.units import rpm_of
from rolamento.vibration import diagnosis as engine
from rolamento.vibration.diagnosis import (
    COMPONENTS,
    DAMAGE,
    Component,
    ComponentVerdict,
    Diagnosis,
    DiagnosisSettings,
    FaultOrders,
)
from rolamento.vibration.diagnosis.blocks import MOST_SAMPLES
from rolamento.vibration.frequencies import FaultFrequencies, frequencies_of, nominal_frequencies
from rolamento.vibration.frequency_band import open_counts, roller_counts
from rolamento.vibration.lookalikes import Lookalikes, lookalikes
from rolamento.vibration.noise_floor import LOWEST_LINE
from rolamento.vibration.reading import SignalFile, open_signal
from rolamento.vibration.reading.memory import SPEED
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import Indicators, indicators
from rolamento.vibration.unknown_bearing import UnknownBearing, unknown_bearing
from rolamento.words import Note, said
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.document import Document
    from rolamento.solved import Solved

SCHEMA: Final = 3
Part = TypeVar("Part")
Conclusion = Literal["fault", "undecided", "watch", "nothing_found", "no_verdict"]

_CLEAR: Final = 9.0
"""dB above the noise that a line of noise alone reaches once in three thousand."""
_WIDEST: Final = 0.1
"""Part by which a cage may be off in a search."""


@frozen
class TooShort:
    """Why a record has no diagnosis: by its length no race can be judged, known before it is read.

    Attributes
    ----------
    revolutions, required_revolutions
        that it has, or that the longest stretch has which is judged at once; and from which on it
        says something
    duration
        of that; s
    is_stretch
        whether the shaft is too slow for a stretch, and not the record too short
    """

    revolutions: float
    required_revolutions: float
    duration: float
    is_stretch: bool

    @property
    def reason(self) -> Literal["shaft_too_slow", "record_too_short"]:
        """Name of what is in the way."""
        return "shaft_too_slow" if self.is_stretch else "record_too_short"

    @property
    def statement(self) -> tuple[Note, ...]:
        """What it comes to: that the record is too short, or the shaft too slow for its rate."""
        times = self.required_revolutions / self.revolutions
        values = {
            "revolutions": self.revolutions,
            "duration": self.duration,
            "required": self.required_revolutions,
            "seconds": self.duration * times,
            "times": times,
        }
        return (Note("shaft_too_slow" if self.is_stretch else "record_short", values),)


class Concluded:
    """What comes to a verdict, and says so in sentences."""

    __slots__ = ()

    @property
    def verdict(self) -> Conclusion:
        """What it comes to."""
        raise NotImplementedError

    @property
    def statement(self) -> tuple[Note, ...]:
        """What it comes to, sentence by sentence."""
        raise NotImplementedError

    @property
    def complaint(self) -> str:
        """Why there is no verdict; "" if there is one."""
        if self.verdict not in ("no_verdict", "undecided"):
            return ""
        return " ".join(note.text for note in self.statement)

    def _head(self, kind: str) -> dict[str, Any]:
        """Return what its plain data begin with."""
        return {
            "schema": SCHEMA,
            "kind": kind,
            "verdict": self.verdict,
            "statement": _mappings(self.statement),
        }


@frozen(eq=False, slots=False)
class DiagnosisResult(Concluded):
    """All that a diagnosis of a vibration record finds, or why it has none.

    Attributes
    ----------
    too_short
        why the record has no diagnosis: `diagnosis` and `signal` are refused then; else None
    title
        of the signal
    bearing_name
        designation or title of the case
    bearing
        whose vibration this is
    frequencies
        that were looked for, at the mean speed: of the loaded bearing, or of its geometry
    settings
        how it was looked for
    duration
        of all; s
    reading_notes
        how the samples were taken from their file
    choices
        those of them that say which rate or speed was taken where it is given twice
    speed
        of the shaft; None if all that is known are the frequencies
    solved
        the loaded bearing; None if the frequencies are those of the geometry by choice
    slip
        part by which the cage was allowed to be off before the range over the balls widened it;
        None if nothing did
    covers_balls
        whether the orders of all loaded balls were looked for
    other_rows
        rows, counted from 0, whose balls have orders that were not
    lookalikes
        bearings of the catalogue that share what was found; None if nothing was
    """

    title: str
    bearing_name: str
    bearing: Bearing | RollerBearing
    frequencies: FaultFrequencies
    settings: DiagnosisSettings
    duration: float
    found: Diagnosis | None = None
    record: Signal | None = None
    too_short: TooShort | None = None
    reading_notes: tuple[Note, ...] = ()
    choices: tuple[Note, ...] = ()
    speed: ShaftSpeed | None = None
    solved: Solved | None = None
    slip: float | None = None
    covers_balls: bool = True
    other_rows: tuple[int, ...] = ()
    lookalikes: Lookalikes | None = None

    def _shown(self) -> dict[str, str]:
        shown = {
            "": f"{self.verdict}, {self.bearing_name}: {self.title}",
            "statement": " ".join(note.text for note in self.statement),
            "status": self.status,
            "duration": f"{self.duration:.4g} s",
        }
        if self.found is not None:
            shown["shaft"] = f"{self.found.shaft_frequency:.4g} Hz"
            for part in self.found.components:
                shown[part.component] = f"{part.verdict}, depth {part.depth:.3g}"
            shown["notes"] = str(len(self.notes))
        return shown

    @property
    def status(self) -> Literal["diagnosed", "shaft_too_slow", "record_too_short"]:
        """Whether there is a diagnosis, or why there is none."""
        return "diagnosed" if self.too_short is None else self.too_short.reason

    @property
    def diagnosis(self) -> Diagnosis:
        """What was found.

        Raises
        ------
        InputError
            If the record is too short for any: see `status`.
        """
        return self._had(self.found)

    @property
    def signal(self) -> Signal:
        """The signal that was diagnosed, or its first part if it is long.

        Raises
        ------
        InputError
            As of `diagnosis`.
        """
        return self._had(self.record)

    @property
    def faults(self) -> tuple[Component, ...]:
        """Parts that are damaged; none without a diagnosis."""
        return () if self.found is None else self.found.faults

    def _had(self, part: Part | None) -> Part:
        if part is None:
            raise InputError(
                said("has no diagnosis: {why}", why=" ".join(note.text for note in self.statement)),
                source=self.title,
            )
        return part

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
    def verdict(self) -> Conclusion:
        """What it comes to."""
        if self.too_short is not None:
            return "no_verdict"
        verdicts = {part.verdict for part in self.diagnosis.components}
        if "fault" in verdicts:
            return "fault"
        if self.still:
            return "no_verdict"
        if "undecided" in verdicts or self.diagnosis.undecided or self.diagnosis.impacts:
            return "undecided"
        if "watch" in verdicts or self.diagnosis.modulation:
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
    def statement(self) -> tuple[Note, ...]:
        """What it comes to, sentence by sentence."""
        if self.too_short is not None:
            return self.too_short.statement
        if self.speed_lost and not self.still and not self.diagnosis.stated:
            return (Note("no_speed_no_verdict"),)
        if self.verdict == "no_verdict" and not self.still:
            return self._said(self._untested())
        return self.diagnosis.statement(still=self.still)

    def _untested(self) -> tuple[Note, ...]:
        """Return what could not be tested, why, and that nothing stands out of the rest."""
        parts = self.diagnosis.components
        tested = [part.component for part in parts if part.verdict != "not_tested"]
        untested = [part for part in parts if part.verdict == "not_tested"]
        reasons = dict.fromkeys(reason for part in untested for reason in part.reasons)
        if not tested:
            return (Note("no_part_tested"), *reasons)
        without = {"parts": [part.component for part in untested]}
        rest = Note("nothing_in_the_rest", {"parts": tested})
        return (Note("no_verdict_without", without), *reasons, rest)

    @property
    def advice(self) -> tuple[Note, ...]:
        """What to do, the evidence against the verdict, and which bearings it may be about."""
        if self.verdict == "no_verdict":
            return ()
        return (*self.diagnosis.advice, *self._other_counts(), *self._shared())

    def _shared(self) -> tuple[Note, ...]:
        return () if self.lookalikes is None else (self.lookalikes.shared,)

    def _said(self, notes: Iterable[Note]) -> tuple[Note, ...]:
        """Return notes as they are said of what rolls in the bearing."""
        return tuple(of_element(note, self.diagnosis.element) for note in notes)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known: of the diagnosis, and of how it was made."""
        if self.too_short is not None:
            return ()
        return (*self.diagnosis.notes, *self._said(self._own_notes()))

    def _own_notes(self) -> Iterator[Note]:
        faults = [part for part in self.diagnosis.components if part.verdict == "fault"]
        if self.verdict in ("nothing_found", "watch"):
            yield Note("not_a_certificate")
        if self.lookalikes is not None and self.lookalikes.found:
            yield self.lookalikes.telling
        if any(_highest_line(part) < _CLEAR for part in faults):
            yield Note("weak_peaks")
        if self.speed is not None and self.speed.lost:
            yield self.speed.lost_note
        if self.solved is not None and self.frequencies.source != "loaded":
            yield Note("no_loaded_frequencies", {"reason": _why_not_loaded(self.solved)})
        if not self.covers_balls:
            yield Note("range_not_covered", {"tolerance": self.settings.tolerance})
        if self.other_rows:
            yield Note("other_rows", {"rows": list(self.other_rows)})
        if "inferred" in self.bearing.origins.values():
            yield Note("frequencies_of_estimated_geometry")
        yield from open_counts(self.bearing)

    def _other_counts(self) -> Iterator[Note]:
        """Say which peaks would be those of a race if the rollers were more or fewer."""
        turns, shaft = self.frequencies.turns, self.diagnosis.shaft_frequency
        shaft /= self.diagnosis.speed_factor
        passing = {"outer_race": turns.cage - turns.outer, "inner_race": turns.inner - turns.cage}
        counts = roller_counts(self.bearing).keys() - {self.frequencies.ball_count}
        stated = [part.frequency for part in self.diagnosis.stated]
        for frequency in (*stated, *(line.frequency for line in self.diagnosis.unexplained)):
            for part, count in product(passing, sorted(counts)):
                expected = count * abs(passing[part]) * shaft
                if abs(frequency - expected) <= self.settings.tolerance * expected:
                    values = {"part": part, "count": count, "frequency": frequency}
                    yield Note("peak_of_other_count", values)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.diagnosis import diagnosis_page

        return diagnosis_page(self)

    def picture(self) -> Picture | None:
        """Draw waveform, kurtogram and envelope spectrum; None of a record that is too short."""
        from rolamento.plots.vibration import diagnosis_figure

        if self.found is None:
            return None
        return diagnosis_figure(self.signal, self.found, title=f"{self.bearing_name}: {self.title}")

    def kurtogram(self) -> Picture | None:
        """Draw the kurtogram alone; None as of `picture`."""
        from rolamento.plots.vibration import kurtogram_figure

        if self.found is None:
            return None
        fault = self.found.clearest_fault
        band = None if fault is None else fault.band
        return kurtogram_figure(self.signal, band=band, title=f"{self.bearing_name}: {self.title}")

    def to_mapping(self) -> dict[str, Any]:
        """Return everything but the spectra as plain data, in SI units and Hz."""
        if (short := self.too_short) is not None:
            return {
                **self._head("diagnosis"),
                "reason": short.reason,
                "revolutions": short.revolutions,
                "required_revolutions": short.required_revolutions,
                "duration": short.duration,
            }
        diagnosis, signal = self.diagnosis, self.signal
        return {
            **self._head("diagnosis"),
            "title": self.title,
            "grade": diagnosis.grade,
            "faults": list(diagnosis.causes),
            "watched": list(diagnosis.watched),
            "undecided": [
                {"component": part, "shaft_frequency": frequency}
                for part, frequency in diagnosis.undecided
            ],
            "impacts": None if diagnosis.impacts is None else asdict(diagnosis.impacts),
            "slips": [
                {"component": part, "cage_deviation": slip} for part, slip in diagnosis.slips
            ],
            "advice": _mappings((*diagnosis.advice, *self._other_counts(), *self._shared())),
            "lookalikes": None if self.lookalikes is None else self.lookalikes.to_mapping(),
            "components": [part.to_mapping() for part in diagnosis.components],
            "unexplained": [asdict(line) for line in diagnosis.unexplained],
            "kurtosis": diagnosis.kurtosis,
            "false_alarm": diagnosis.false_alarm,
            "tolerance": diagnosis.tolerance,
            "slip": diagnosis.tolerance if self.slip is None else self.slip,
            "trials": diagnosis.trials,
            "shaft_frequency": diagnosis.shaft_frequency,
            "speed_tolerance": self.settings.speed_tolerance,
            "speed_factor": diagnosis.speed_factor,
            "speed_source": diagnosis.speed_source,
            "speed_confirmed": diagnosis.speed_confirmed,
            "speed": None if self.speed is None else self.speed.to_mapping(),
            "revolutions": diagnosis.revolutions,
            "blocks": diagnosis.blocks,
            "order_resolution": diagnosis.resolution,
            "bearing": self.bearing_name,
            "frequencies": self.frequencies.to_mapping(),
            "state": None if self.solved is None else self.solved.to_mapping()["status"],
            "signal": {
                "rate": signal.rate,
                "duration": self.duration,
                "quantity": signal.quantity,
                "unit": signal.unit,
                "indicators_of_first": signal.duration,
                "indicators": asdict(self.indicators),
                "reading_notes": _mappings(self.reading_notes),
            },
            "notes": _mappings(self.notes),
        }


def _mappings(notes: Iterable[Note]) -> list[dict[str, Any]]:
    return [note.to_mapping() for note in notes]


def _why_not_loaded(solved: Solved) -> dict[str, Any]:
    """Return the note of why a load gives no frequencies."""
    converged = bool(solved.converged[0])
    why = Note("no_ball_drives_cage") if converged else Note("no_solution_no_frequencies")
    return why.to_mapping()


_RACES: Final = ("outer_race", "inner_race")
"""Most damage begins on them: a record that is silent about one is not one of a healthy bearing."""


def _is_still(part: ComponentVerdict) -> bool:
    return part.verdict == "not_tested" and _has(part, "no_change")


def _has(part: ComponentVerdict, reason: str) -> bool:
    return any(one.key == reason for one in part.reasons)


def _highest_line(part: ComponentVerdict) -> float:
    """Return by how much the highest multiple of a fault stands out; dB, -inf if none is seen."""
    levels = [line.above_noise for line in part.lines if isfinite(line.above_noise)]
    return max(levels, default=-inf)


def diagnose(
    path: str | os.PathLike[str] | Signal | FloatArray,
    bearing: BearingLike,
    *,
    speed: str | float | None = None,
    outer_speed: str | float | None = None,
    speed_channel: str | int | None = None,
    speed_unit: str | None = None,
    tacho: str | int | None = None,
    pulses: int | None = None,
    track: bool = False,
    within: float | None = None,
    nominal: bool = False,
    angle: str | float | None = None,
    start: float = 0.0,
    duration: float | None = None,
    turning: tuple[float, ...] = (),
    elsewhere: tuple[float, ...] = (),
    search: DiagnosisSettings | None = None,
    changes: Changes = (),
    progress: Progress = quietly,
    **reading: Unpack[Reading],
) -> DiagnosisResult:
    """Diagnose which bearing components a vibration record shows to be damaged.

    Parameters
    ----------
    path
        Of a file; a long one is read piece by piece, in bounded memory. Or a signal in memory, or
        its samples, (samples,), with their ``rate``, and ``unit`` where their size counts.
    bearing
        Designation, case file or case: with a load, the loaded bearing's frequencies are sought.
    speed, outer_speed
        Of the rings, steady: text such as "1797 rpm", or rad/s; by default as the file gives it,
        or else the case.
    speed_channel, speed_unit
        Channel of the same file with the speed, and its unit if the file is silent.
    tacho, pulses
        Channel of the same file with pulses of the shaft, and how many there are in a revolution.
    track, within
        Whether to find the speed in the vibration itself, about ``speed``, and by which part it
        may be off anywhere.
    nominal
        Whether to look for the geometry's frequencies, whatever the load.
    angle
        Of contact, without a load: "zero", "free", an angle such as "15 deg", or rad.
    start, duration
        Of the part that is diagnosed; s.
    turning, elsewhere
        Orders of what else turns, and of the faults of other bearings: see `FaultOrders`.
    search
        How to look, and how sure to be.
    changes
        What goes over the case, by dotted name, such as ``{"duty.load.fz": "5 kN"}``.
    progress
        Called with blocks of the signal done and all; twice where the speed is found in it first.
    reading
        channel, rate, unit, scale and decimal_mark, as of `rolamento.vibration.open_signal`.

    Returns
    -------
    DiagnosisResult
        Its `status` says whether the record was long enough for a diagnosis.

    Raises
    ------
    FileError, InputError
        If a file cannot be read, or what is given contradicts itself or does not suffice.

    >>> noise = np.random.default_rng(0).normal(size=48_000)
    >>> diagnose(noise, "6205", speed="1797 rpm", rate=12_000.0).verdict
    'nothing_found'
    """
    case = _case_sought(bearing, changes)
    if isinstance(path, np.ndarray):
        path = _in_memory(path, reading.get("rate"))
    if isinstance(path, Signal) and path.speed is not None and path.speed.ndim:
        told = speed is None and outer_speed is None and tacho is None and not track
        speed_channel = SPEED if told and speed_channel is None else speed_channel
    asked = SpeedInputs(
        inner=speed_of(speed, "speed"),
        outer=speed_of(outer_speed, "outer_speed"),
        channel=speed_channel,
        unit=speed_unit,
        tacho=tacho,
        pulses=pulses,
        track=track,
        within=within,
    )
    of_case = case.duty.inner_speed or None, case.duty.outer_speed or None
    opened = open_signal(path, speed_channel=speed_channel, speed_unit=speed_unit, **reading)
    with opened as source:
        part = part_of(source, start, duration)
        known = known_speed(asked, of_case, source, part, progress)
        case = at_speeds(case, known.inner, known.outer)
        frequencies, solved = _frequencies_sought(case, nominal=nominal, angle=angle)
        wide = widened(frequencies, search or DiagnosisSettings())
        _check_rate(frequencies, known, source)
        common: dict[str, Any] = {
            "bearing_name": name_of(bearing, case),
            "bearing": case.bearing,
            "frequencies": frequencies,
            "settings": wide.settings,
            "solved": solved,
        }
        short = _too_short(frequencies, known, part.stop - part.start, source.rate)
        if short is not None:
            return DiagnosisResult(
                title=source.path.name, duration=short.duration, too_short=short, **common
            )
        pieces = (source.read(place, min(part.step, part.stop - place)) for place in part)
        held = streamed(pieces, known.at, lambda done: progress(-(-done // part.step), len(part)))
        orders = replace(FaultOrders.of(frequencies, turning), elsewhere=elsewhere)
        found = engine.diagnose(held.pieces, orders, wide.settings)
        return DiagnosisResult(
            title=held.first.title or source.path.name,
            duration=held.duration,
            found=found,
            record=held.first,
            reading_notes=(*source.notes, *known.choices),
            choices=(*source.choices, *known.choices),
            speed=known.shaft,
            slip=wide.slip,
            covers_balls=wide.covers_balls,
            other_rows=wide.other_rows,
            lookalikes=_lookalikes(found, frequencies, case.bearing, wide.settings),
            **common,
        )


@frozen(eq=False, slots=False)
class UnknownResult(Concluded):
    """The combs of a record whose bearing nobody knows, and the bearings that would have them.

    Attributes
    ----------
    title
        of the signal
    found
        combs, and bearings ranked
    """

    title: str
    found: UnknownBearing

    @property
    def verdict(self) -> Conclusion:
        """Undecided over a comb as deep as damage: of which part only the bearing would decide."""
        deep = any(comb.depth >= DAMAGE for comb in self.found.combs)
        return "undecided" if deep else "nothing_found"

    @property
    def statement(self) -> tuple[Note, ...]:
        """What it comes to."""
        combs, fits = self.found.combs, self.found.fits
        if not combs:
            return (Note("no_combs"),)
        values = {"frequency": combs[0].frequency, "order": combs[0].order, "depth": combs[0].depth}
        notes = [Note("deepest_comb", values)]
        if fits:
            named = [fit.designation for fit in fits[:3]]
            notes.append(Note("bearings_with_combs", {"count": len(fits), "named": named}))
        else:
            notes.append(Note("no_bearing_with_combs", {"compared": self.found.compared}))
        return tuple(notes)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.history import unknown_page

        return unknown_page(self)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data."""
        return {
            **self._head("unknown_bearing"),
            "title": self.title,
            **self.found.to_mapping(),
        }


def rank_bearings(
    path: str | os.PathLike[str] | Signal | FloatArray,
    *,
    speed: str | float | None = None,
    start: float = 0.0,
    duration: float | None = None,
    search: DiagnosisSettings | None = None,
    of_rollers: bool = False,
    **reading: Unpack[Reading],
) -> UnknownResult:
    """Find the combs of a record, and rank the bearings of the catalogue that would have them.

    Parameters
    ----------
    path, speed, start, duration, search, reading
        As of `diagnose`; the speed is steady.
    of_rollers
        Whether roller bearings are compared, and not ball bearings.

    Raises
    ------
    FileError, InputError
        If a file cannot be read, or the speed is not known.
    """
    if isinstance(path, np.ndarray):
        path = _in_memory(path, reading.get("rate"))
    asked = SpeedInputs(inner=speed_of(speed, "speed"))
    with open_signal(path, **reading) as source:
        part = part_of(source, start, duration)
        known = known_speed(asked, (None, None), source, part, quietly)
        pieces = (source.read(place, min(part.step, part.stop - place)) for place in part)
        held = streamed(pieces, known.at, lambda done: None)
        bearings = rolling_bearings(of_rollers=of_rollers)
        found = unknown_bearing(held.pieces, bearings, search)
        return UnknownResult(held.first.title or source.path.name, found)


def _in_memory(samples: FloatArray, rate: float | None) -> Signal:
    if rate is None:
        raise InputError(
            said("must be given with samples in memory"),
            field="rate",
            example=arguments(rate=12_000.0),
        )
    return Signal(samples, rate)


def _lookalikes(
    found: Diagnosis,
    frequencies: FaultFrequencies,
    bearing: Bearing | RollerBearing,
    settings: DiagnosisSettings,
) -> Lookalikes | None:
    """Return the bearings of the catalogue that share what was found, the sought one left out."""
    name = ""
    if bearing.designation is not None:
        with suppress(InputError):  # one that only the file of its case knows
            name = catalogue().find(bearing.designation).bearing.designation
    return lookalikes(
        found,
        FaultOrders.of(frequencies),
        rolling_bearings(of_rollers=frequencies.rolling_element == "roller"),
        speed_tolerance=settings.speed_tolerance,
        ratios=(frequencies.turns.inner, frequencies.turns.outer),
        designation=name,
    )


def _case_sought(bearing: BearingLike, changes: Changes) -> Case:
    """Return the case of a bearing; of a designation, one without a load."""
    try:
        return case_of(bearing, changes)
    except InputError as error:
        if error.field != "bearing.designation" or error.source:
            raise
        raise InputError(
            error.rule, field="bearing", value=error.value, example=arguments(bearing="6205")
        ) from None


def _frequencies_sought(
    case: Case, *, nominal: bool, angle: str | float | None
) -> tuple[FaultFrequencies, Solved | None]:
    """Return the frequencies to look for, and the loaded bearing's solution if its case has a load.

    Those of the loaded bearing, where it has a solution; else those of the geometry, with the
    contact angle that is wanted.
    """
    loaded = has_load(case) and not nominal
    if loaded and angle is not None:
        raise InputError(
            said("goes with the frequencies of the geometry; here the load determines the angle"),
            field="angle",
            value=angle,
            example=arguments(nominal=True, angle="free"),
        )
    inner, outer = case.duty.inner_speed, case.duty.outer_speed
    if inner == outer:
        raise InputError(
            said("equals that of the inner ring: nothing rolls"),
            field="outer_speed",
            value=f"{rpm_of(outer):.6g} rpm",
            example=arguments(outer_speed="0 rpm"),
        )
    solved: Solved | None = None
    if loaded:
        from rolamento.solution import solve

        solved = solve(case)
        if solved.converged[0]:
            found = frequencies_of(solved)
            if isfinite(found.cage.order):
                return found, solved
    choice = angle_of("zero" if angle is None else angle, case.bearing)
    return nominal_frequencies(case.bearing, inner, outer, contact_angle=choice), solved


@frozen
class WidenedSearch:
    """How widely to look.

    Attributes
    ----------
    settings
        with a tolerance that covers the range over the balls
    slip
        the tolerance before that, if the range is wider; else None
    covers_balls
        whether all loaded balls are covered: a search has its widest
    other_rows
        rows of a set, counted from 0, that are not
    """

    settings: DiagnosisSettings
    slip: float | None
    covers_balls: bool
    other_rows: tuple[int, ...]


def widened(frequencies: FaultFrequencies, settings: DiagnosisSettings) -> WidenedSearch:
    """Widen a search, as far as it may be, to the orders of all loaded balls."""
    orders = FaultOrders.of(frequencies)
    own, slip = _range_over_balls(frequencies, frequencies, orders), settings.tolerance
    tolerance = max(slip, min(own, _WIDEST))
    others = [row for row in frequencies.rows if row.row != frequencies.row]
    return WidenedSearch(
        settings=replace(settings, tolerance=tolerance),
        slip=slip if tolerance > slip else None,
        covers_balls=own <= tolerance,
        other_rows=tuple(
            row.row
            for row in others
            if _range_over_balls(frequencies, row, orders) > tolerance * (1.0 + 1e-9)
        ),
    )


def _range_over_balls(own: FaultFrequencies, row: FaultFrequencies, orders: FaultOrders) -> float:
    """Part by which the cage has to be allowed off for a search to cover the balls of a row."""
    widest = 0.0
    for part in COMPONENTS:
        line, sought_for = row.of_fault(part), own.of_fault(part).order
        for order in (line.minimum, line.maximum):
            if isfinite(order) and sought_for > 0.0:
                widest = max(widest, abs(order / sought_for - 1.0) / orders.tolerance(part, 1.0))
    return widest


def _check_rate(frequencies: FaultFrequencies, speed: KnownSpeed, source: SignalFile) -> None:
    """Refuse a record that cannot hold the fault frequencies: sampled less than twice a period.

    Raises
    ------
    InputError
        With the lowest rate (Shannon, 1949).
    """
    orders = [frequencies.of_fault(race).order for race in ("outer_race", "inner_race")]
    turns = max(abs(speed.shaft.minimum), abs(speed.shaft.maximum)) / (2.0 * pi)
    least = 2.0 * max(orders) * turns
    if source.rate > least:
        return
    raise InputError(
        said(
            "is too low: the races of the bearing are struck up to {race:.4g} times a second, which"
            " needs more than {least:.4g} Hz",
            race=max(orders) * turns,
            least=least,
        ),
        field="rate",
        value=source.rate,
        example=arguments(rate=25600.0),
        source=str(source.path),
    )


def _too_short(
    frequencies: FaultFrequencies, speed: KnownSpeed, samples: int, rate: float
) -> TooShort | None:
    """Return whether both races lie in the spectrum where no level of noise is known."""
    orders = [frequencies.of_fault(race).order for race in ("outer_race", "inner_race")]
    least = (LOWEST_LINE + 1) / max(orders)
    block = min(samples, MOST_SAMPLES) / rate
    fastest = max(abs(speed.shaft.minimum), abs(speed.shaft.maximum))
    turns = block * fastest / (2.0 * pi)
    if turns >= least:
        return None
    return TooShort(turns, ceil(10.0 * least) / 10.0, block, samples > MOST_SAMPLES)
