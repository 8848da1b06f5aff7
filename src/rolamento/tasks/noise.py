"""The noise of a bearing in anderons, of files of signals: whether it passes, and how it grows."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import cached_property
from io import StringIO
from math import isfinite, nan
from typing import Any, Final, Literal, Unpack

from rolamento.errors import InputError, arguments
from rolamento.io.json import csv_number
from rolamento.records import frozen
from rolamento.tasks.parameters import Progress, quietly, speed_of
from rolamento.tasks.signals import (
    Reading,
    blocks_at,
    require_calibrated,
)
from rolamento.vibration.anderon import (
    ACCEPTED,
    BANDS,
    Acceptance,
    BandName,
    Noise,
    accept,
    anderons_of_velocity,
    measure_noise,
)
from rolamento.vibration.anderon_trend import AnderonRecord, AnderonTrend, trend_of
from rolamento.vibration.reading import SignalFile, open_signal
from rolamento.words import Note, said

SCHEMA: Final = 2
_MICRO: Final = 1e6
_HIGHEST_RATE: Final = 2e7
_MOST_HOURS: Final = 1e9
_MOST_SIGNALS: Final = 500
_LONGEST_NAME: Final = 60

NoiseVerdict = Literal["accepted", "rejected", "not_measured", "none"]
"""Verdict of a band; of a signal never "not_measured"."""

_CLEAR_OF_FILTER: Final = 2.56
"""Sampling rate over the highest frequency that recorders usually keep whole."""


@frozen
class FullScale:
    """Full scale of a band: in anderons, or as an RMS velocity (m/s)."""

    value: float
    is_velocity: bool = False

    def anderons(self, name: BandName, speed: float) -> float:
        """In anderons, at a speed (rad/s)."""
        return (
            anderons_of_velocity(self.value, BANDS[name], speed) if self.is_velocity else self.value
        )


@frozen(eq=False, slots=False)
class MeasuredNoise:
    """Noise of one signal.

    Attributes
    ----------
    title
        of the signal
    noise
        as measured
    hours
        of the test after which it was recorded; NaN if not given
    scaled_unit
        unit that the full scale of a file of whole numbers is taken for; "" otherwise
    sensitivity
        by which the samples were scaled; "" if none was given
    reading_notes
        how the samples were taken from their file
    choices
        those of them that say which rate was taken where it is given twice
    """

    title: str
    noise: Noise
    hours: float = nan
    sensitivity: str = ""
    reading_notes: tuple[Note, ...] = ()
    choices: tuple[Note, ...] = ()

    @property
    def at_test_speed(self) -> bool:
        """Whether the speed is that of the test, as near as the standard wants it."""
        return not self._has("speed_differs")

    @property
    def speed_known(self) -> bool:
        """Whether the signal, or the user, gave the speed."""
        return not self._has("speed_unknown")

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known of it."""
        notes, velocity = list(self.noise.notes), self.noise.velocity
        near_half = velocity.rate < _CLEAR_OF_FILTER * BANDS["high"][1]
        if near_half and not self._has("band_incomplete"):
            notes.append(Note("near_half_rate", {"rate": velocity.rate}))
        if velocity.quantity != "velocity":
            notes.append(Note(f"velocity_from_{velocity.quantity}"))
        if self.sensitivity:
            notes.append(Note("scaled_by_sensitivity", {"sensitivity": self.sensitivity}))
        return tuple(notes)

    def _has(self, key: str) -> bool:
        return any(note.key == key for note in self.noise.notes)


@frozen(eq=False, slots=False)
class NoiseResult:
    """Noise of one signal or of several of a bearing, and whether it is accepted.

    Attributes
    ----------
    measured
        of every signal, in the order given
    full_scales
        by band; of those that are set for the bearing's size and type
    part
        of the full scale up to which noise is accepted
    bearing
        what the bearing is called
    """

    measured: tuple[MeasuredNoise, ...]
    full_scales: Mapping[BandName, FullScale]
    part: float = ACCEPTED
    bearing: str = "1"

    def scales_of(self, one: MeasuredNoise) -> dict[BandName, float]:
        """Full scales in anderons at the speed of a signal."""
        return {
            name: scale.anderons(name, one.noise.speed) for name, scale in self.full_scales.items()
        }

    @cached_property
    def acceptances(self) -> tuple[Acceptance | None, ...]:
        """Verdicts of every signal; None without full scales."""
        return tuple(
            accept(one.noise, self.scales_of(one), self.part) if self.full_scales else None
            for one in self.measured
        )

    def limits_of(self, one: MeasuredNoise) -> dict[BandName, float]:
        """Anderons up to which a signal is accepted."""
        return {name: self.part * scale for name, scale in self.scales_of(one).items()}

    def verdict_of(self, place: int, name: BandName) -> NoiseVerdict:
        """Verdict of a band of the signal at a place in the list."""
        acceptance = self.acceptances[place]
        if acceptance is None or name not in acceptance.of_full_scale:
            return "none"
        if not isfinite(acceptance.of_full_scale[name]):
            return "not_measured"
        return "rejected" if name in acceptance.rejected else "accepted"

    @cached_property
    def verdicts(self) -> tuple[NoiseVerdict, ...]:
        """Verdicts of every signal."""
        return tuple(
            "none" if found is None else "accepted" if found.accepted else "rejected"
            for found in self.acceptances
        )

    @property
    def measures_nothing(self) -> bool:
        """Whether no signal holds any band."""
        bands = (band for one in self.measured for band in one.noise.bands)
        return not any(isfinite(band.anderons) for band in bands)

    @cached_property
    def trend(self) -> AnderonTrend | None:
        """Over the test, if the hours of at least two signals are given."""
        if len(self.measured) < 2 or not all(isfinite(one.hours) for one in self.measured):
            return None
        records = [
            AnderonRecord(1, one.hours, {band.name: band.anderons for band in one.noise.bands})
            for one in self.measured
        ]
        return trend_of(records, self.limits_of(self.measured[0]))[0]

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units, Hz, anderons and hours."""
        return {
            "schema": SCHEMA,
            "kind": "anderon",
            "bearing": self.bearing,
            "accepted_part": self.part,
            "signals": [self._signal(place) for place in range(len(self.measured))],
            "trend": None if self.trend is None else [asdict(band) for band in self.trend.bands],
        }

    def _signal(self, place: int) -> dict[str, Any]:
        one = self.measured[place]
        scales = self.scales_of(one)
        bands = [
            {
                **asdict(band),
                "full_scale": scales.get(band.name),
                "of_full_scale": band.anderons / scales.get(band.name, nan),
                "verdict": self.verdict_of(place, band.name),
            }
            for band in one.noise.bands
        ]
        return {
            "title": one.title,
            "verdict": self.verdicts[place],
            "hours": one.hours,
            "speed": one.noise.speed,
            "bands": bands,
            "rate": one.noise.velocity.rate,
            "duration": one.noise.velocity.duration,
            "quantity": one.noise.velocity.quantity,
            "reading_notes": [note.to_mapping() for note in one.reading_notes],
            "notes": [note.to_mapping() for note in one.notes],
        }

    def record(self) -> str:
        """Return the anderons over the hours as the CSV that `rolamento trend` reads.

        Only its title is in the language that is spoken.
        """
        text = StringIO(newline="")
        writer = csv.writer(text, lineterminator="\n")
        text.write(f"# title: {said('Noise of bearing {name}', name=self.bearing)}\n")
        writer.writerow(("time (h)", "bearing", *(f"{name} (anderon)" for name in BANDS)))
        for one in self.measured:
            levels = (csv_number(one.noise.of(name).anderons) for name in BANDS)
            writer.writerow((csv_number(one.hours), self.bearing, *levels))
        return text.getvalue()


def noise_level(
    paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    speed: str | float | None = None,
    full_scale: Mapping[BandName, FullScale | float] | None = None,
    accepted: float = ACCEPTED,
    hours: Sequence[float] | None = None,
    bearing: str = "1",
    start: float = 0.0,
    duration: float | None = None,
    progress: Progress = quietly,
    **reading: Unpack[Reading],
) -> NoiseResult:
    """Measure the noise of files of signals of one bearing, in bounded memory.

    Parameters
    ----------
    paths
        A file or several.
    speed
        Of the inner ring: text such as "1800 rpm", or rad/s; by default as a file gives it, or else
        that of the standard.
    full_scale
        By band: anderons, or a `FullScale`; without one there is no verdict.
    accepted
        Part of the full scale up to which noise is accepted.
    hours
        Of the test after which each signal was recorded.
    bearing
        What to call it.
    start, duration
        Of the part of each signal; s.
    progress
        Called with blocks of a file done and all.
    reading
        channel, rate, unit, scale and decimal_mark, as of `rolamento.vibration.open_signal`.

    Raises
    ------
    FileError, InputError
        If a file cannot be read, does not say what it measures or does not change, or a parameter
        is out of range.
    """
    files = [paths] if isinstance(paths, str | os.PathLike) else list(paths)
    if not 1 <= len(files) <= _MOST_SIGNALS:
        raise InputError(
            said("must be 1 to {most} files", most=_MOST_SIGNALS), field="signals", value=len(files)
        )
    if not bearing.strip() or len(bearing) > _LONGEST_NAME or not bearing.isprintable():
        rule = said("must be one line of at most {most} characters", most=_LONGEST_NAME)
        raise InputError(rule, field="bearing", value=bearing, example=arguments(bearing="9"))
    if not 0.0 < accepted <= 1.0:
        rule = said("must be a fraction above 0 and at most 1")
        raise InputError(rule, field="accepted", value=accepted, example=arguments(accepted=0.4))
    times = [nan] * len(files) if hours is None else list(hours)
    if hours is not None and (
        len(times) != len(files) or not all(0.0 <= time <= _MOST_HOURS for time in times)
    ):
        rule = said(
            "must be a number of hours, not negative, for each signal, here {count}",
            count=len(files),
        )
        raise InputError(
            rule,
            field="hours",
            value=", ".join(map(str, times)),
            example=arguments(hours=[60, 120, 180]),
        )
    inner_speed = speed_of(speed, "speed")
    if inner_speed == 0.0:
        rule = said("must not be 0: a stationary bearing makes no noise")
        raise InputError(rule, field="speed", example=arguments(speed="1800 rpm"))
    measured = []
    for path, time in zip(files, times, strict=True):
        opened = open_signal(path, start=start, duration=duration, **reading)
        with opened as source:
            noise = _noise_of(source, os.fspath(path), inner_speed, progress)
            scale = reading.get("scale")
            measured.append(
                MeasuredNoise(
                    title=source.path.name,
                    noise=noise,
                    hours=time,
                    sensitivity="" if scale is None else str(scale),
                    reading_notes=source.notes,
                    choices=source.choices,
                )
            )
    scales = {
        name: scale if isinstance(scale, FullScale) else FullScale(scale)
        for name, scale in (full_scale or {}).items()
    }
    found = NoiseResult(tuple(measured), scales, accepted, bearing)
    _check_speeds(found)
    return found


def _noise_of(source: SignalFile, path: str, speed: float | None, progress: Progress) -> Noise:
    """Measure a file whose unit is known, at the speed that is given, if one is."""
    require_calibrated(source, path)
    if source.rate > _HIGHEST_RATE:
        raise InputError(
            said("must be at most {most:.6g} Hz: the bands end at 10 kHz", most=_HIGHEST_RATE),
            field="rate",
            value=source.rate,
            source=path,
        )
    try:
        return measure_noise(blocks_at(source, speed, progress))
    except InputError as error:
        raise error.with_details(source=path) from None


def _check_speeds(found: NoiseResult) -> None:
    """Refuse a trend against velocities where the speeds differ: limits in anderons would too."""
    speeds = [one.noise.speed for one in found.measured]
    in_velocity = any(scale.is_velocity for scale in found.full_scales.values())
    if found.trend is not None and in_velocity and max(speeds) > 1.001 * min(speeds):
        raise InputError(
            said("must be in anderons, since the signals have different speeds"),
            field="full_scale",
            example=arguments(full_scale={"low": 30.0}),
        )
