"""The noise of a bearing in anderons, of files of signals: whether it passes, and how it grows."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import cached_property
from io import StringIO
from math import isfinite, nan
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Literal, Self

from pydantic import model_validator

from rolamento.errors import InputError, arguments
from rolamento.io.json import csv_number
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
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rolamento.document import Document

BEARING: Final = marked("Bearing")
ACCEPTANCE: Final = marked("Acceptance")
SCHEMA: Final = 2
_MICRO: Final = 1e6
_HIGHEST_RATE: Final = 2e7
_SCALE_EXAMPLE: Final = arguments(full_scale="low=30")
_MOST_SCALE: Final = 1e9
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

    @property
    def complaint(self) -> str:
        """What no band measures, or which fails; "" of a bearing that passes."""
        if not (self.measures_nothing or "rejected" in self.verdicts):
            return ""
        from rolamento.pages.anderon import noise_statement

        return noise_statement(self)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.anderon import anderon_page

        return anderon_page(self)

    def picture(self) -> Figure:
        """Draw noise over frequency, or over the hours."""
        from rolamento.plots.anderon import noise_figure, noise_trend_figure
        from rolamento.weibull import parse_trend

        one = self.measured[0]
        limits = self.limits_of(one)
        if len(self.measured) == 1:
            return noise_figure(one.noise, limits=limits, title=one.title)
        return noise_trend_figure(parse_trend(self.record()), limits=limits)

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


class NoiseLevel(SignalRequest):
    """Show the noise in anderons and µm/s, and whether it passes.

    In the bands of an anderometer; for several signals, over the hours of a test.

    Parameters
    ----------
    signals
        Signal files: WAV, CSV, NPY, MATLAB and others. Several are of one bearing.
    speed
        Speed of the inner ring; by default that of the file, or else 1800 rpm.
    bearing
        Name of the bearing in the record.
    hours
        Hours of the test at which the signals were recorded, such as 60,120,180.
    full_scale
        Full scale of a band, low, medium or high, in anderons or as a velocity such as '120 um/s'.
    accepted
        Accepted fraction of the full scale, up to 1.
    """

    signals: Annotated[Any, Input("Signals", "files", essential=True, metavar="SIGNAL")]
    speed: Annotated[
        float | None,
        Input("Shaft speed", "quantity", BEARING, example="1800 rpm", dimension="angular_speed"),
    ] = None
    bearing: Annotated[
        str, Input("Name of the bearing", group=BEARING, example="9", default="1", metavar="NAME")
    ] = "1"
    hours: Annotated[
        tuple[float, ...],
        Input("Hours", "list", BEARING, example="60,120,180", separator=",", metavar="H,H,…"),
    ] = ()
    full_scale: Annotated[
        Any,
        Input(
            "Full scale", "list", ACCEPTANCE, example="low=30", separator=",", metavar="BAND=VALUE"
        ),
    ] = ()
    accepted: Annotated[
        float,
        Input("Accepted fraction", "fraction", ACCEPTANCE, example="0.4", default=str(ACCEPTED)),
    ] = ACCEPTED

    examples: ClassVar = (
        "Examples: anderon noise.wav --unit um/s --full-scale low=30,medium=60,high=60; "
        "anderon t060.csv t120.csv --hours 60,120 --plot trend.png."
    )
    waiting: ClassVar = marked("blocks of the signal")
    headings: ClassVar = (SIGNAL, BEARING, ACCEPTANCE)

    @model_validator(mode="after")
    def _are_in_range(self) -> Self:
        check_files(self.files)
        name = self.bearing
        if not name.strip() or len(name) > _LONGEST_NAME or not name.isprintable():
            rule = said("must be one line of at most {most} characters", most=_LONGEST_NAME)
            raise InputError(rule, field="bearing", value=name)
        if not 0.0 < self.accepted <= 1.0:
            rule = said("must be a fraction above 0 and at most 1")
            raise InputError(rule, field="accepted", value=self.accepted)
        if self.speed == 0.0:
            rule = said("must not be 0: a stationary bearing makes no noise")
            raise InputError(rule, field="speed")
        return self

    @property
    def files(self) -> list[Any]:
        """The files, also where a single one is given."""
        return files_of(self.signals)

    def _check_record(self) -> None:
        if not self.hours:
            rule = said("needs the hours of each signal")
            raise InputError(rule, field="record", example=arguments(hours="60,120,180"))

    def _check_picture(self) -> None:
        if len(self.files) > 1 and not self.hours:
            rule = said("needs the hours of each signal")
            raise InputError(rule, field="plot", example=arguments(hours="60,120,180"))

    def run(self, progress: Progress = quietly) -> NoiseResult:
        """Measure the noise.

        Raises
        ------
        FileError, InputError
            If a file cannot be read, does not say what it measures or does not change, or what is
            given contradicts itself.
        """
        given = self.full_scale
        scales = given if isinstance(given, Mapping) else _full_scales_of(given)
        full_scales = {
            name: scale if isinstance(scale, FullScale) else FullScale(scale)
            for name, scale in scales.items()
        }
        measured = []
        for path, time in zip(self.files, hours_of_files(self.hours, self.files), strict=True):
            opened = open_signal(path, start=self.start, duration=self.duration, **self.reading)
            with opened as source:
                noise = _noise_of(source, os.fspath(path), self.speed, progress)
                scale = "" if self.scale is None else str(self.scale)
                title, notes, choices = source.path.name, source.notes, source.choices
                measured.append(MeasuredNoise(title, noise, time, scale, notes, choices))
        found = NoiseResult(tuple(measured), full_scales, self.accepted, self.bearing)
        _check_speeds(found)
        return found

    products: ClassVar = {
        "plot": Product(
            marked("Draw noise over frequency, or over the hours: a .png, .svg or .pdf file."),
            lambda asked, found: found.picture(),
            check=_check_picture,
        ),
        "record": Product(
            marked("Write the levels over the hours, as `rolamento trend` reads them."),
            lambda asked, found: found.record(),
            is_picture=False,
            check=_check_record,
        ),
    }


def _full_scales_of(given: Sequence[str]) -> dict[BandName, FullScale]:
    """Return the full scales of texts ``BAND=VALUE``.

    Raises
    ------
    InputError
        If one is none, or given twice.
    """
    found: dict[BandName, FullScale] = {}
    for setting in given:
        key, equals, text = setting.partition("=")
        name = next((band for band in BANDS if band == key.strip().casefold()), None)
        if name is None or not equals:
            raise InputError(
                said("must be BAND=VALUE; BAND is one of {bands}", bands=", ".join(BANDS)),
                field="full_scale",
                value=setting,
                example=_SCALE_EXAMPLE,
            )
        if name in found:
            raise InputError(said("is given twice"), field="full_scale", value=name)
        found[name] = _full_scale(text.strip(), name)
    return found


def _full_scale(text: str, name: BandName) -> FullScale:
    """Read a number of anderons, or a velocity with its unit."""
    from rolamento.vibration.signal import unit_scale

    number, _, unit = text.partition(" ")
    unit = unit.strip().replace("µ", "u").replace("μ", "u")
    scale = 1.0
    try:
        is_velocity = unit not in ("", "An", "anderon", "anderons")
        if is_velocity:
            scale = unit_scale("velocity", unit)
        value = float(number) * scale
    except ValueError:  # an InputError of the unit is one too
        value = nan
    if not (isfinite(value) and 0.0 < value / scale <= _MOST_SCALE):
        raise InputError(
            said("must be a positive number of anderons, or a velocity in um/s, mm/s, m/s or in/s"),
            field="full_scale",
            value=f"{name}={text}",
            example=_SCALE_EXAMPLE,
        )
    return FullScale(value, is_velocity)


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
