"""Noise of bearings in anderons: all that the command finds, as JSON and as CSV."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from io import StringIO
from math import isfinite, nan
from typing import Any, Final, Literal

from rolamento.report.anderon_words import NOISE_WORDS, NoiseWords
from rolamento.report.numbers import Digits
from rolamento.report.page import one_line
from rolamento.report.plain_data import csv_number, json_text
from rolamento.vibration.anderon import (
    ACCEPTED,
    BANDS,
    Acceptance,
    BandName,
    Noise,
    accept,
    anderons_of_velocity,
)
from rolamento.vibration.anderon_trend import AnderonRecord, AnderonTrend, trend_of
from rolamento.vibration.reading import ReadingNote

__all__ = [
    "CSV_COLUMNS",
    "FullScale",
    "MeasuredNoise",
    "NoiseResult",
    "Verdict",
    "noise_csv",
    "noise_json",
    "noise_record",
]

SCHEMA: Final = 1

CSV_COLUMNS: Final = (
    "signal", "hours", "band", "low_Hz", "high_Hz", "velocity_um_per_s", "anderons",
    "full_scale_anderons", "accepted_to_anderons", "verdict",
)  # fmt: skip
"""The header of the CSV: one band of one signal in a row."""

Verdict = Literal["accepted", "rejected", "not_measured", "none"]
"""Of a band; of a signal never "not_measured"."""

_MICRO: Final = 1e6
_CLEAR_OF_FILTER: Final = 2.56
"""Sampling rate over the highest frequency that recorders usually keep whole."""


@dataclass(frozen=True, slots=True)
class FullScale:
    """Full scale of a band: in anderons, or as an RMS velocity (m/s)."""

    value: float
    is_velocity: bool = False

    def anderons(self, name: BandName, speed: float) -> float:
        """In anderons, at a speed (rad/s)."""
        return (
            anderons_of_velocity(self.value, BANDS[name], speed) if self.is_velocity else self.value
        )


@dataclass(frozen=True, eq=False)
class MeasuredNoise:
    """Noise of one signal.

    Attributes
    ----------
    title
        of the signal
    noise
        as measured
    hours
        of the test after which it was recorded; NaN if not told
    scaled_unit
        unit that the full scale of a file of whole numbers is taken for; "" otherwise
    sensitivity
        by which the samples were scaled; "" if none was given
    reading_notes
        how the samples were taken from their file
    choices
        those of them that tell what was taken for the rate where it is told twice
    """

    title: str
    noise: Noise
    hours: float = nan
    scaled_unit: str = ""
    sensitivity: str = ""
    reading_notes: tuple[str, ...] = ()
    choices: tuple[ReadingNote, ...] = ()

    @property
    def at_test_speed(self) -> bool:
        """Whether the speed is that of the test, as near as the standard wants it."""
        return "speed_differs" not in self.noise.notes

    @property
    def names_of_notes(self) -> tuple[str, ...]:
        """What is to be known of it, by names of the words."""
        names, velocity = list(self.noise.notes), self.noise.velocity
        if "band_incomplete" not in names and velocity.rate < _CLEAR_OF_FILTER * BANDS["high"][1]:
            names.append("near_half_rate")
        if velocity.quantity != "velocity":
            names.append(velocity.quantity)
        names += ["sensitivity"] if self.sensitivity else []
        names += ["full_scale_one"] if self.scaled_unit else []
        return tuple(names)

    def note(self, name: str, words: NoiseWords, digits: Digits) -> str:
        """Say one of them."""
        return words.note[name].format(
            rate=digits.short(self.noise.velocity.rate, 6),
            bands=", ".join(words.bands[name] for name in self.noise.missing),
            unit=self.scaled_unit,
            sensitivity=one_line(self.sensitivity),
        )


@dataclass(frozen=True, eq=False)
class NoiseResult:
    """All that the command finds.

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
        """Of every signal; None without full scales."""
        return tuple(
            accept(one.noise, self.scales_of(one), self.part) if self.full_scales else None
            for one in self.measured
        )

    def limits_of(self, one: MeasuredNoise) -> dict[BandName, float]:
        """Anderons up to which a signal is accepted."""
        return {name: self.part * scale for name, scale in self.scales_of(one).items()}

    def verdict_of(self, place: int, name: BandName) -> Verdict:
        """Of a band of the signal at a place in the list."""
        acceptance = self.acceptances[place]
        if acceptance is None or name not in acceptance.of_full_scale:
            return "none"
        if not isfinite(acceptance.of_full_scale[name]):
            return "not_measured"
        return "rejected" if name in acceptance.rejected else "accepted"

    @cached_property
    def verdicts(self) -> tuple[Verdict, ...]:
        """Of every signal."""
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
        """Over the test, if the hours of at least two signals are told."""
        if len(self.measured) < 2 or not all(isfinite(one.hours) for one in self.measured):
            return None
        records = [
            AnderonRecord(1, one.hours, {band.name: band.anderons for band in one.noise.bands})
            for one in self.measured
        ]
        return trend_of(records, self.limits_of(self.measured[0]))[0]


def noise_json(found: NoiseResult) -> str:
    """Return everything as one JSON object, in SI units, Hz, anderons and hours."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "anderon",
            "bearing": found.bearing,
            "accepted_part": found.part,
            "signals": [_mapping(found, place) for place in range(len(found.measured))],
            "trend": None if found.trend is None else [asdict(band) for band in found.trend.bands],
        }
    )


def _mapping(found: NoiseResult, place: int) -> dict[str, Any]:
    one, said = found.measured[place], NOISE_WORDS["en"]
    scales = found.scales_of(one)
    bands = [
        {
            **asdict(band),
            "full_scale": scales.get(band.name),
            "of_full_scale": band.anderons / scales.get(band.name, nan),
            "verdict": found.verdict_of(place, band.name),
        }
        for band in one.noise.bands
    ]
    return {
        "title": one.title,
        "verdict": found.verdicts[place],
        "hours": one.hours,
        "speed": one.noise.speed,
        "bands": bands,
        "rate": one.noise.velocity.rate,
        "duration": one.noise.velocity.duration,
        "quantity": one.noise.velocity.quantity,
        "reading_notes": list(one.reading_notes),
        "notes": [
            {"name": name, "text": one.note(name, said, Digits("."))} for name in one.names_of_notes
        ],
    }


def noise_csv(found: NoiseResult) -> str:
    """Return one band of one signal in a row below a header, lines ending in CR LF."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    for place, one in enumerate(found.measured):
        scales = found.scales_of(one)
        for band in one.noise.bands:
            scale = scales.get(band.name, nan)
            numbers = (*band.band, _MICRO * band.velocity, band.anderons, scale, found.part * scale)
            writer.writerow(
                (
                    one_line(one.title),
                    csv_number(one.hours),
                    band.name,
                    *(csv_number(number) for number in numbers),
                    found.verdict_of(place, band.name),
                )
            )
    return text.getvalue()


def noise_record(found: NoiseResult, language: str = "en") -> str:
    """Return the anderons over the hours as the CSV that `rolamento trend` reads.

    Only its title is in the language, ``"en"`` or ``"pt"``.
    """
    title = NOISE_WORDS[language].record.format(bearing=found.bearing)
    text = StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    text.write(f"# title: {title}\n")
    writer.writerow(("time (h)", "bearing", *(f"{name} (anderon)" for name in BANDS)))
    for one in found.measured:
        levels = (csv_number(one.noise.of(name).anderons) for name in BANDS)
        writer.writerow((csv_number(one.hours), found.bearing, *levels))
    return text.getvalue()
