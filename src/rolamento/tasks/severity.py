"""The severity of a machine's vibration, of files of signals: its zone, its alarm, its trend."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from io import StringIO
from math import isfinite, nan
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self, cast

import numpy as np
from pydantic import model_validator

from rolamento.errors import InputError, arguments
from rolamento.io.dates import dates_of, days_between, moment_after, moment_said
from rolamento.io.json import csv_number
from rolamento.numerics.growth import Forecast, Law, forecast
from rolamento.records import frozen
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input, Product
from rolamento.tasks.signals import (
    SIGNAL,
    SignalRequest,
    blocks_at,
    check_files,
    files_of,
    hours_of_files,
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
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rolamento.document import Document

__all__ = ["MeasuredSeverity", "SeverityResult", "VibrationSeverity"]

SCHEMA: Final = 1
_MILLI: Final = 1e-3
MACHINE: Final = marked("Machine")
TREND: Final = marked("Alarm and trend")
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
    def complaint(self) -> str:
        """Why there is no zone; "" if any signal was measured."""
        from rolamento.pages.severity import severity_statement

        return "" if self.worst is not None else severity_statement(self)

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

    def picture(self) -> Figure:
        """Draw the velocity on the zones, or over the hours."""
        from rolamento.pages.severity import trend_picture, zones_picture

        return zones_picture(self) if self.forecast is None else trend_picture(self)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.severity import severity_page

        return severity_page(self)

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


def _supports() -> Mapping[str, str]:
    return {"rigid": marked("rigid"), "flexible": marked("flexible")}


def _laws() -> Mapping[str, str]:
    return {"linear": marked("linear"), "exponential": marked("exponential")}


class VibrationSeverity(SignalRequest):
    """Show the vibration severity in mm/s and its zone.

    Broadband RMS velocity and zones A to D of ISO 20816-3; for several signals, over time.

    Parameters
    ----------
    signals
        Signal files: WAV, CSV, NPY, MATLAB and others. Several are of one machine.
    speed
        Speed of the shaft, such as '1480 rpm'; below 600 rpm the band begins at 2 Hz.
    power
        Rated power of the machine, such as '45 kW' or '60 cv': gives its group.
    support
        Support: rigid or flexible.
    group
        Group of ISO 20816-3, 1 or 2, instead of the power.
    machine_class
        Class of ISO 10816-1, I to IV, instead of a group.
    baseline
        Usual RMS velocity of the machine, such as '1.2 mm/s': sets the alarm.
    hours
        Running hours at which the signals were recorded, such as 0,500,1000.
    dates
        Dates of the signals instead, such as 2026-01-31,2026-02-28.
    limit
        Limit of the trend, such as '4.5 mm/s'; by default the alarm.
    law
        Law of growth: linear or exponential; by default the likelier one.
    confidence
        Confidence of the time to the limit, such as 0.9.
    """

    signals: Annotated[Any, Input("Signals", "files", essential=True, metavar="SIGNAL")]
    speed: Annotated[
        float | None,
        Input("Shaft speed", "quantity", MACHINE, example="1480 rpm", dimension="angular_speed"),
    ] = None
    power: Annotated[
        float | None,
        Input(
            "Rated power", "quantity", MACHINE, example="45 kW", dimension="power", essential=True
        ),
    ] = None
    support: Annotated[
        str | None,
        Input(
            "Support",
            "choice",
            MACHINE,
            example="rigid",
            choices=_supports,
            aliases={"rigido": "rigid", "rigida": "rigid", "flexivel": "flexible"},
            essential=True,
        ),
    ] = None
    group: Annotated[
        str | int | None,
        Input(
            "Group of ISO 20816-3",
            "choice",
            MACHINE,
            example="2",
            choices=lambda: {"1": "", "2": ""},
            metavar="N",
        ),
    ] = None
    machine_class: Annotated[
        str | None,
        Input(
            "Class of ISO 10816-1",
            "choice",
            MACHINE,
            example="II",
            choices=lambda: {"I": "", "II": "", "III": "", "IV": ""},
            option="--class",
            metavar="CLASS",
        ),
    ] = None
    baseline: Annotated[
        float | None,
        Input(
            "Usual velocity",
            "quantity",
            MACHINE,
            example="1.2 mm/s",
            dimension="velocity",
            metavar="VELOCITY",
        ),
    ] = None
    hours: Annotated[
        tuple[float, ...],
        Input("Running hours", "list", TREND, example="0,500,1000", separator=",", metavar="H,H,…"),
    ] = ()
    dates: Annotated[
        tuple[str, ...],
        Input(
            "Dates",
            "list",
            TREND,
            example="2026-01-31,2026-02-28",
            separator=",",
            metavar="DATE,DATE,…",
        ),
    ] = ()
    limit: Annotated[
        float | None,
        Input(
            "Limit", "quantity", TREND, example="4.5 mm/s", dimension="velocity", metavar="VELOCITY"
        ),
    ] = None
    law: Annotated[
        str | None,
        Input(
            "Law of growth",
            "choice",
            TREND,
            example="linear",
            choices=_laws,
            option="--growth",
            metavar="LAW",
        ),
    ] = None
    confidence: Annotated[
        float, Input("Confidence", "fraction", TREND, example="0.9", default="0.9", metavar="C")
    ] = 0.9

    examples: ClassVar = (
        "Examples: severity motor.csv --unit g --speed '1480 rpm' --power '45 kW' --support "
        "rigid; severity jan.wav feb.wav mar.wav --unit mm/s --hours 0,700,1400 --plot "
        "trend.png."
    )
    waiting: ClassVar = marked("blocks of the signal")
    headings: ClassVar = (MACHINE, SIGNAL, TREND)

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        check_files(self.files)
        if not 0.0 < self.confidence < 1.0:
            rule = said("must be between 0 and 1, exclusive")
            raise InputError(rule, field="confidence", value=self.confidence)
        for name in ("baseline", "limit"):
            value = getattr(self, name)
            if value is not None and not 0.0 < value <= 1e3:
                rule = said("must be a positive velocity")
                raise InputError(rule, field=name, value=value)
        if self.hours and self.dates:
            raise InputError(said("cannot be combined with hours"), field="dates")
        for name in ("limit", "law"):
            if getattr(self, name) is not None:
                self.check_times(name)
        return self

    @property
    def files(self) -> list[Any]:
        """The files, also where a single one is given."""
        return files_of(self.signals)

    def check_times(self, field: str = "record") -> None:
        """Refuse what needs times where there are none; field: what needs them.

        Raises
        ------
        InputError
            If neither hours nor dates are given.
        """
        if not (self.hours or self.dates):
            rule = said("needs the hours or dates of each signal")
            raise InputError(rule, field=field, example=arguments(hours="0,500"))

    def run(self, progress: Progress = quietly) -> SeverityResult:
        """Measure the severity.

        Raises
        ------
        FileError, InputError
            If a file cannot be read, does not say what it measures or does not change, or what is
            given contradicts itself.
        """
        classes = classes_of(
            group=None if self.group is None else int(self.group),
            support=self.support,
            power=self.power,
            machine_class=self.machine_class,
        )
        files = self.files
        times, first = hours_of_files(self.hours, files), ""
        dated: tuple[Note, ...] = ()
        if self.dates:
            times, first, dated = _days(self.dates, len(files))
        measured: list[MeasuredSeverity] = []
        for path, time in zip(files, times, strict=True):
            found = self._measured(path, time, () if measured else dated, progress)
            measured.append(found)
        if self.hours or self.dates:
            measured.sort(key=lambda one: one.hours)
        return SeverityResult(
            tuple(measured), classes, self.baseline, self.limit, cast("Law | None", self.law),
            self.confidence, first,
        )  # fmt: skip

    def _measured(
        self, path: Any, time: float, notes: tuple[Note, ...], progress: Progress
    ) -> MeasuredSeverity:
        opened = open_signal(path, start=self.start, duration=self.duration, **self.reading)
        with opened as source:
            name = os.fspath(path)
            require_calibrated(source, name)
            at = source.speed if self.speed is None else self.speed
            try:
                found = measure_severity(
                    blocks_at(source, self.speed, progress),
                    duration=source.duration,
                    speed=nan if at is None else at,
                )
            except InputError as error:
                raise error.with_details(source=name) from None
            scale = "" if self.scale is None else str(self.scale)
            choices = (*source.choices, *notes)
            return MeasuredSeverity(source.path.name, found, time, scale, source.notes, choices)

    products: ClassVar = {
        "plot": Product(
            marked("Draw the velocity on the zones, or over the hours: a .png, .svg or .pdf file."),
            lambda asked, found: found.picture(),
        ),
        "record": Product(
            marked("Write the velocities over the hours, as `rolamento trend` reads them."),
            lambda asked, found: found.record(),
            is_picture=False,
            check=check_times,
        ),
    }


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
