"""The severity of a machine's vibration, of files of signals: its zone, its alarm, its trend."""

from __future__ import annotations

import csv
import os
from collections.abc import Sequence
from functools import cached_property
from io import StringIO
from math import isfinite, nan
from typing import Any, Final, Unpack

import numpy as np

from rolamento.errors import InputError, arguments
from rolamento.io.columns import folded_name
from rolamento.io.dates import dates_of, days_between, moment_after, moment_said
from rolamento.io.json import csv_number
from rolamento.numerics.growth import Forecast, Law, forecast
from rolamento.records import frozen
from rolamento.tasks.parameters import Progress, quietly, speed_of
from rolamento.tasks.signals import (
    Reading,
    blocks_at,
    require_calibrated,
)
from rolamento.vibration.reading import open_signal
from rolamento.vibration.severity import (
    AlarmSetting,
    MachineClass,
    Severity,
    Zone,
    alarm_setting,
    classes_of,
    measure_severity,
)
from rolamento.words import Note, said

__all__ = ["MeasuredSeverity", "SeverityResult", "vibration_severity"]

SCHEMA: Final = 1
_MOST_SIGNALS: Final = 500
_MOST_HOURS: Final = 1e9
_MILLI: Final = 1e-3
_SUPPORTS: Final = {"rigido": "rigid", "rigida": "rigid", "flexivel": "flexible"}
"""As a Brazilian calls them."""
_DAY: Final = 24.0
"""h."""


@frozen(eq=False)
class MeasuredSeverity:
    """Severity of one signal.

    Attributes
    ----------
    title
        of the signal
    severity
        as measured
    hours
        at which it was recorded; NaN if not given
    sensitivity
        by which the samples were scaled, as given; "" if by none
    reading_notes, choices
        how the samples were taken from their file
    """

    title: str
    severity: Severity
    hours: float = nan
    sensitivity: str = ""
    reading_notes: tuple[Note, ...] = ()
    choices: tuple[Note, ...] = ()

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known of it."""
        notes = list(self.severity.notes)
        if self.sensitivity:
            notes.append(Note("scaled_by_sensitivity", {"sensitivity": self.sensitivity}))
        return (*notes, *self.choices)


@frozen(eq=False, slots=False)
class SeverityResult:
    """Severity of one signal or of several of a machine.

    Attributes
    ----------
    measured
        of every signal, in the order given, or of the hours
    classes
        that the machine may be of; one where that is known
    baseline
        usual RMS velocity of the machine, m/s; None if it is not known
    limit
        to which the trend is followed, m/s; None for the alarm
    law
        of growth, if one was asked for
    confidence
        of the interval of the time to the limit
    start
        date or moment from which the hours count, if the signals have dates; "" otherwise
    """

    measured: tuple[MeasuredSeverity, ...]
    classes: tuple[MachineClass, ...]
    baseline: float | None = None
    limit: float | None = None
    law: Law | None = None
    confidence: float = 0.9
    start: str = ""

    @property
    def time_unit(self) -> str:
        """Unit of the trend: days where the signals have dates, hours otherwise."""
        return "d" if self.start else "h"

    @property
    def time_scale(self) -> float:
        """Hours in that unit."""
        return _DAY if self.start else 1.0

    def date_of(self, one: MeasuredSeverity) -> str:
        """Date of a signal, as 2026-01-31; "" without."""
        if not self.start:
            return ""
        return moment_after(self.start, one.hours / _DAY)

    @property
    def machine(self) -> MachineClass | None:
        """The class, if it is known."""
        return self.classes[0] if len(self.classes) == 1 else None

    @property
    def worst(self) -> MeasuredSeverity | None:
        """The signal of the greatest velocity; the last one of a trend; None without any."""
        measured = [one for one in self.measured if one.severity.measured]
        if not measured:
            return None
        if isfinite(measured[-1].hours):
            return measured[-1]
        return max(measured, key=lambda one: one.severity.velocity)

    def zone_of(self, one: MeasuredSeverity, machine: MachineClass) -> Zone | None:
        """Zone of a signal, were the machine of a class: the worse of velocity and displacement."""
        if not one.severity.measured:
            return None
        moved = machine.zone_of_displacement(one.severity.displacement)
        return max(machine.zone_of(one.severity.velocity), moved or "A")

    @property
    def zone(self) -> Zone | None:
        """Zone of the machine: of the worst signal, where all classes agree on it."""
        worst = self.worst
        if worst is None:
            return None
        zones = {self.zone_of(worst, machine) for machine in self.classes}
        return zones.pop() if len(zones) == 1 else None

    @property
    def setting(self) -> AlarmSetting | None:
        """Alarm and trip, where the class is known."""
        return None if self.machine is None else alarm_setting(self.machine, self.baseline)

    @property
    def goal(self) -> float | None:
        """Velocity to which the trend is followed; m/s."""
        if self.limit is not None:
            return self.limit
        return None if self.setting is None else self.setting.alarm

    @cached_property
    def forecast(self) -> Forecast | None:
        """When the velocity reaches the limit, in `time_unit` and mm/s; None without times."""
        series = [one for one in self.measured if one.severity.measured]
        if len(series) < 2 or self.goal is None or not all(isfinite(one.hours) for one in series):
            return None
        return forecast(
            np.array([one.hours for one in series]) / self.time_scale,
            np.array([one.severity.velocity for one in series]) / _MILLI,
            self.goal / _MILLI,
            confidence=self.confidence,
            law=self.law,
        )

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known of the whole."""
        notes = [Note("severity_not_bearings")]
        worst, machine = self.worst, self.machine
        if machine is not None and worst is not None:
            moved = machine.zone_of_displacement(worst.severity.displacement)
            by_velocity = machine.zone_of(worst.severity.velocity)
            if moved is not None and moved > by_velocity:
                values = {"zone": moved, "by_velocity": by_velocity}
                notes.append(Note("severity_displacement_worse", values))
        return tuple(notes)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units; the trend in `time_unit` and mm/s."""
        setting = self.setting
        return {
            "schema": SCHEMA,
            "kind": "severity",
            "zone": self.zone,
            "classes": [
                {
                    "name": machine.name,
                    "standard": machine.standard,
                    "velocity": list(machine.velocity),
                    "displacement": list(machine.displacement),
                    "source": machine.source,
                    "quoted": machine.quoted,
                    "displacement_source": machine.displacement_source,
                }
                for machine in self.classes
            ],
            "baseline": self.baseline,
            "alarm": None if setting is None else setting.alarm,
            "trip": None if setting is None else setting.trip,
            "limit": self.goal,
            "start": self.start or None,
            "time_unit": self.time_unit,
            "signals": [self._signal(one) for one in self.measured],
            "trend": None if self.forecast is None else self.forecast.to_mapping(),
            "notes": [note.to_mapping() for note in self.notes],
        }

    def _signal(self, one: MeasuredSeverity) -> dict[str, Any]:
        return {
            "title": one.title,
            "hours": one.hours,
            **one.severity.to_mapping(),
            "zones": {machine.name: self.zone_of(one, machine) for machine in self.classes},
            "reading_notes": [note.to_mapping() for note in one.reading_notes],
            "notes": [note.to_mapping() for note in one.notes],
        }

    def record(self) -> str:
        """Return velocity over hours as the CSV that `rolamento trend` reads."""
        text = StringIO(newline="")
        writer = csv.writer(text, lineterminator="\n")
        text.write(f"# title: {said('Severity of vibration')}\n")
        time = "date" if self.start else "time (h)"
        writer.writerow((time, "bearing", "velocity (mm/s)"))
        for one in self.measured:
            velocity = one.severity.velocity / _MILLI
            at = self.date_of(one) or csv_number(one.hours)
            writer.writerow((at, "1", csv_number(velocity)))
        return text.getvalue()


def vibration_severity(
    paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    speed: str | float | None = None,
    group: int | None = None,
    support: str | None = None,
    power: str | float | None = None,
    machine_class: str | None = None,
    baseline: str | float | None = None,
    limit: str | float | None = None,
    law: Law | None = None,
    confidence: float = 0.9,
    hours: Sequence[float] | None = None,
    dates: Sequence[str] | None = None,
    start: float = 0.0,
    duration: float | None = None,
    progress: Progress = quietly,
    **reading: Unpack[Reading],
) -> SeverityResult:
    """Measure the severity of files of signals of one machine, in bounded memory.

    Parameters
    ----------
    paths
        A file or several: of several places, or of one over time.
    speed
        Of the shaft: text such as "1480 rpm", or rad/s; by default as a file gives it.
    group, support, power, machine_class
        Of the machine, as of `rolamento.vibration.severity.classes_of`; the power as text such as
        "45 kW", or in W.
    baseline
        Its usual velocity: text such as "1.2 mm/s", or m/s. It sets the alarm.
    limit
        To which a trend is followed, likewise; by default the alarm.
    law
        "linear" or "exponential", of that trend; by default the likelier one.
    confidence
        Of the interval of the time to the limit.
    hours, dates
        At which the signals were recorded: running hours, or days such as "2026-01-31".
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
    if not 0.0 < confidence < 1.0:
        rule = said("must be between 0 and 1, exclusive")
        raise InputError(
            rule, field="confidence", value=confidence, example=arguments(confidence=0.9)
        )
    if support is not None:
        support = _SUPPORTS.get(folded_name(support), support)
    classes = classes_of(
        group=group, support=support, power=_power(power), machine_class=machine_class
    )
    usual, goal = _velocity(baseline, "baseline"), _velocity(limit, "limit")
    times, first = _hours(hours, len(files)), ""
    dated: tuple[Note, ...] = ()
    if dates is not None:
        if hours is not None:
            raise InputError(said("cannot be combined with hours"), field="dates")
        times, first, dated = _days(dates, len(files))
    shaft = speed_of(speed, "speed")
    measured: list[MeasuredSeverity] = []
    for path, time in zip(files, times, strict=True):
        opened = open_signal(path, start=start, duration=duration, **reading)
        with opened as source:
            name = os.fspath(path)
            require_calibrated(source, name)
            at = source.speed if shaft is None else shaft
            try:
                found = measure_severity(
                    blocks_at(source, shaft, progress),
                    duration=source.duration,
                    speed=nan if at is None else at,
                )
            except InputError as error:
                raise error.with_details(source=name) from None
            scale = reading.get("scale")
            measured.append(
                MeasuredSeverity(
                    source.path.name,
                    found,
                    time,
                    "" if scale is None else str(scale),
                    source.notes,
                    (*source.choices, *(() if measured else dated)),
                )
            )
    if hours is not None or dates is not None:
        measured.sort(key=lambda one: one.hours)
    return SeverityResult(tuple(measured), classes, usual, goal, law, confidence, first)


def _power(given: str | float | None) -> float | None:
    from rolamento.units import to_si

    if not isinstance(given, str):
        return given
    try:
        return to_si(given, "power")
    except InputError as error:
        raise error.with_details(field="power", example=arguments(power="45 kW")) from None


def _velocity(given: str | float | None, field: str) -> float | None:
    from rolamento.units import to_si

    example = f'{field}="1.8 mm/s"'
    if isinstance(given, str):
        try:
            given = to_si(given, "velocity")
        except InputError as error:
            raise error.with_details(field=field, example=example) from None
    if given is not None and not 0.0 < given <= 1e3:
        rule = said("must be a positive velocity")
        raise InputError(rule, field=field, value=given, example=example)
    return given


def _hours(hours: Sequence[float] | None, count: int) -> list[float]:
    if hours is None:
        return [nan] * count
    times = list(hours)
    if len(times) != count or not all(0.0 <= time <= _MOST_HOURS for time in times):
        rule = said(
            "must be a number of hours, not negative, for each signal, here {count}", count=count
        )
        raise InputError(
            rule,
            field="hours",
            value=", ".join(map(str, times)),
            example=arguments(hours=[60, 120, 180]),
        )
    return times


def _days(given: Sequence[str], count: int) -> tuple[list[float], str, tuple[Note, ...]]:
    """Hours from the first of some moments, that moment, and how the dates were read."""
    texts = [text.strip() for text in given]
    read = dates_of(texts)
    example = "2026-01-31,2026-02-28"
    read.check("dates", example)
    known = [moment for moment in map(read.moment, texts) if moment is not None]
    if len(texts) != count or len(known) != count:
        rule = said("must be a date for each signal, here {count}", count=count)
        raise InputError(rule, field="dates", value=", ".join(texts), example=example)
    hours = [_DAY * day for day in days_between(known, "dates")]
    return hours, moment_said(min(known)), read.notes
