"""The signals of `rolamento anderon`, measured block by block, and what its options say."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import isfinite, nan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.cli.signal_source import SignalChoice, opened
from rolamento.errors import InputError
from rolamento.report.anderon_result import FullScale, MeasuredNoise
from rolamento.vibration.anderon import BANDS, BandName, measure_noise
from rolamento.vibration.reading import SignalFile
from rolamento.vibration.signal import unit_scale

if TYPE_CHECKING:
    from rolamento.vibration.signal import Signal

__all__ = ["full_scales_of", "hours_of", "measured_noise"]

_BLOCK: Final = 2**20
"""Samples that are read at a time."""
_HIGHEST_RATE: Final = 2e7
_MOST_HOURS: Final = 1e9
_MOST_SCALE: Final = 1e9
_SCALE_EXAMPLE: Final = "--full-scale low=30 or --full-scale low='120 um/s'"


def measured_noise(
    path: str,
    choice: SignalChoice,
    hours: float,
    progress: Callable[[int, int], None],
    speed: float | None = None,
) -> MeasuredNoise:
    """Measure the noise of a signal's file, in bounded memory.

    Parameters
    ----------
    path, choice
        The file, and what the options say of it.
    hours
        Of the test at which it was recorded; NaN if that is not known.
    progress
        Is told how many parts are read, and of how many.
    speed
        Of the inner ring (rad/s); by default as the file tells it, or else that of the standard.

    Raises
    ------
    FileError, InputError
        If the file cannot be read, does not say what it measures, or does not change.
    """
    with opened(path, choice) as source:
        _check(source, path)
        try:
            noise = measure_noise(_blocks(source, speed, progress))
        except InputError as error:
            raise error.with_details(source=path) from None
        return MeasuredNoise(
            title=source.path.name,
            noise=noise,
            hours=hours,
            scaled_unit=_unit_of_full_scale(source, choice),
            sensitivity=choice.scale or "",
            reading_notes=source.notes,
            choices=source.choices,
        )


def _blocks(
    source: SignalFile, speed: float | None, progress: Callable[[int, int], None]
) -> Iterator[Signal]:
    """Blocks of the signal, at the speed that is given, if one is."""
    count = -(-source.length // _BLOCK)
    for place, block in enumerate(source.blocks(_BLOCK), start=1):
        yield block if speed is None else replace(block, speed=np.asarray(speed))
        progress(place, count)


def _check(source: SignalFile, path: str) -> None:
    """Refuse what has no velocity, and rates that bands up to 10 kHz have no use for."""
    if source.quantity == "unknown":
        unit = source.unit
        rule = f'is "{unit}"' if unit not in ("", "1") else "is not in the file"
        raise InputError(
            f"{rule}: give that of a velocity, an acceleration or a displacement, or the"
            " sensitivity of the sensor",
            field="--unit",
            example="--unit um/s, --unit m/s^2, --scale '100 mV/g'",
            source=path,
        )
    if source.rate > _HIGHEST_RATE:
        raise InputError(
            f"must be at most {_HIGHEST_RATE:g} Hz: the bands end at 10 kHz",
            field="--rate",
            value=source.rate,
            source=path,
        )


def _unit_of_full_scale(source: SignalFile, choice: SignalChoice) -> str:
    """Return the unit that a recorder's full scale is taken for; "" if nothing of the kind is."""
    if source.channel.unit != "1" or choice.scale is not None:
        return ""
    return choice.unit or ""


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
