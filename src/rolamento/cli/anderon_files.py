"""The signals of `rolamento anderon`, measured block by block, and what its options say."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import isfinite, nan, sqrt
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.errors import FileError, InputError
from rolamento.report.anderon_result import FullScale, MeasuredNoise
from rolamento.vibration.anderon import (
    BANDS,
    BandName,
    BandNoise,
    Noise,
    anderons_of_velocity,
    measure_noise,
)
from rolamento.vibration.reading import SignalFile, open_signal
from rolamento.vibration.signal import unit_scale

if TYPE_CHECKING:
    from rolamento.vibration.signal import Signal

__all__ = ["Wanted", "full_scales_of", "hours_of", "measured_noise"]

_BLOCK: Final = 2**20
"""Samples that are held at a time, at least a segment of the spectrum."""
_SEGMENTS_A_SECOND: Final = 2.0
"""Of the averaged spectrum, as of `measure_noise`: blocks are cut where its segments begin."""
_HIGHEST_RATE: Final = 2e7
_MOST_HOURS: Final = 1e9
_MOST_SCALE: Final = 1e9
_SCALE_EXAMPLE: Final = "--full-scale low=30 or --full-scale low='120 um/s'"


@dataclass(frozen=True, slots=True)
class Wanted:
    """What the options say of the signals' files; speed in rad/s, None where not given."""

    channel: str | None = None
    rate: float | None = None
    unit: str | None = None
    scale: str | None = None
    start: float = 0.0
    duration: float | None = None
    speed: float | None = None


def measured_noise(
    path: str, wanted: Wanted, hours: float, progress: Callable[[int, int], None]
) -> MeasuredNoise:
    """Measure the noise of a signal's file, in bounded memory.

    Blocks overlap by half a segment of the averaged spectrum, so that all of them together have
    the segments of the whole signal: their mean is its spectrum, but for an end of less than one.

    Raises
    ------
    FileError, InputError
        If the file cannot be read, does not say what it measures, or does not change.
    """
    with open_signal(
        path,
        channel=wanted.channel,
        rate=wanted.rate,
        unit=wanted.unit,
        scale=wanted.scale,
        start=wanted.start,
        duration=wanted.duration,
    ) as source:
        _check(source, path)
        segment = max(round(source.rate / _SEGMENTS_A_SECOND), 2)
        overlap = segment // 2
        hop = segment - overlap
        size = overlap + hop * max(1, (_BLOCK - overlap) // hop)
        count = -(-max(source.length - overlap, 1) // (size - overlap))
        total = _Total()
        for place, block in enumerate(source.blocks(size, overlap), start=1):
            if place > 1 and block.duration * _SEGMENTS_A_SECOND < 1.0:
                break  # the end, of less than a segment
            total.add(_at_speed(block, wanted.speed), (len(block.samples) - overlap) // hop, path)
            progress(place, count)
        total.refuse_still(path)
        return MeasuredNoise(
            title=source.path.name,
            noise=total.noise,
            first=total.first,
            duration=source.duration,
            hours=hours,
            scaled_unit=_unit_of_full_scale(source, wanted),
            sensitivity=wanted.scale or "",
            reading_notes=source.notes,
        )


class _Total:
    """The mean square of the velocities of consecutive blocks, and their mean speed."""

    def __init__(self) -> None:
        self._first: tuple[Signal, Noise] | None = None
        self._notes: dict[str, None] = {}
        self._powers = np.zeros(len(BANDS))
        self._speeds = 0.0
        self._segments = 0
        self._least, self._most = np.inf, -np.inf

    def add(self, block: Signal, segments: int, path: str) -> None:
        """Take a block into account, by its segments of the averaged spectrum."""
        try:
            noise = measure_noise(block)
        except InputError as error:
            raise error.with_details(source=path) from None
        if self._first is None:
            self._first = block, noise
        weight = max(segments, 1)
        self._powers += weight * np.square([band.velocity for band in noise.bands])
        self._speeds += weight * noise.speed
        self._notes.update(dict.fromkeys(noise.notes))
        self._segments += weight
        self._least = min(self._least, float(np.min(block.samples)))
        self._most = max(self._most, float(np.max(block.samples)))

    def refuse_still(self, path: str) -> None:
        """Refuse a signal that does not change: it would pass every test."""
        if self._least == self._most:
            raise FileError(
                "does not change: no sensor was there, or it is the wrong channel", source=path
            )

    @property
    def first(self) -> Signal:
        """The first block."""
        assert self._first is not None
        return self._first[0]

    @property
    def noise(self) -> Noise:
        """Of all blocks together."""
        assert self._first is not None
        speed, bands = self._speeds / self._segments, []
        for band, power in zip(self._first[1].bands, self._powers.tolist(), strict=True):
            velocity = sqrt(power / self._segments)
            level = anderons_of_velocity(velocity, band.band, speed)
            bands.append(BandNoise(band.name, band.band, velocity, level))
        return Noise(speed, tuple(bands), tuple(self._notes))


def _check(source: SignalFile, path: str) -> None:
    """Refuse what has no velocity, and rates that bands up to 10 kHz have no use for."""
    if source.quantity == "unknown":
        unit = source.unit
        rule = f'is "{unit}"' if unit not in ("", "1") else "is not in the file"
        raise InputError(
            f"{rule}: give that of a velocity, an acceleration or a displacement, or the"
            " sensitivity of the sensor",
            field="unit",
            example="--unit um/s, --unit m/s^2, --scale '100 mV/g'",
            source=path,
        )
    if source.rate > _HIGHEST_RATE:
        raise InputError(
            f"must be at most {_HIGHEST_RATE:g} Hz: the bands end at 10 kHz",
            field="rate",
            value=source.rate,
            source=path,
        )


def _unit_of_full_scale(source: SignalFile, wanted: Wanted) -> str:
    """Return the unit that a recorder's full scale is taken for; "" if nothing of the kind is."""
    if source.channel.unit != "1" or wanted.scale is not None:
        return ""
    return wanted.unit or ""


def _at_speed(block: Signal, speed: float | None) -> Signal:
    return block if speed is None else replace(block, speed=np.asarray(speed))


def full_scales_of(given: Sequence[str]) -> dict[BandName, FullScale]:
    """Return the full scales that ``--full-scale BAND=VALUE`` gives, several with commas.

    Raises
    ------
    InputError
        If one is none, or given twice.
    """
    found: dict[BandName, FullScale] = {}
    for setting in (part for text in given for part in text.split(",")):
        key, equals, text = setting.partition("=")
        name = next((band for band in BANDS if band == key.strip().casefold()), None)
        if name is None or not equals:
            raise InputError(
                f"must be BAND=VALUE, with a BAND of {', '.join(BANDS)}",
                source="--full-scale",
                value=setting,
                example=_SCALE_EXAMPLE,
            )
        if name in found:
            raise InputError("is given twice", source="--full-scale", field=name)
        found[name] = _full_scale(text.strip(), name)
    return found


def _full_scale(text: str, name: BandName) -> FullScale:
    """Read a number of anderons, or a velocity with its unit."""
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
            "must be a number of anderons over 0, or a velocity in um/s, mm/s, m/s or in/s",
            source="--full-scale",
            field=name,
            value=text,
            example=_SCALE_EXAMPLE,
        )
    return FullScale(value, is_velocity)


def hours_of(text: str | None, count: int) -> list[float]:
    """Return the hours of each signal; NaN for all if they are not given.

    Raises
    ------
    InputError
        If they are not as many numbers from 0 on as there are signals.
    """
    if text is None:
        return [nan] * count
    try:
        hours = [float(part) for part in text.split(",")]
    except ValueError:
        hours = []
    if len(hours) != count or not all(0.0 <= value <= _MOST_HOURS for value in hours):
        raise InputError(
            f"must be a number of hours from 0 on for each signal, here {count}",
            source="--hours",
            value=text,
            example="--hours 60,120,180",
        )
    return hours
