"""A part of a signal's file, as one signal if it is short, and piece by piece if it is long."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, islice
from math import nan
from typing import Annotated, Any, Final, TypedDict

import numpy as np

from rolamento.errors import InputError, arguments, phrase
from rolamento.tasks.parameters import Progress
from rolamento.tasks.request import DECIMAL_MARK, Input, Request
from rolamento.vibration.reading import SignalFile
from rolamento.vibration.signal import Signal
from rolamento.words import marked, said

SIGNAL: Final = marked("Signal")
PIECE: Final = 2**20
"""Samples that are read at a time."""
_MOST_SIGNALS: Final = 500
_MOST_HOURS: Final = 1e9
_WHOLE: Final = 8
"""Pieces up to which a signal is taken as one."""

AtSpeed = Callable[[Signal, int], Signal]
"""Gives a piece of a signal its speed, from the number of its first sample on."""


class Reading(TypedDict, total=False):
    """What a file does not say of its signal; as of `rolamento.vibration.open_signal`."""

    channel: str | int | None
    rate: float | None
    unit: str | None
    scale: float | str | None
    decimal_mark: str | None


class SignalRequest(Request):
    """A use case that reads a signal, or a part of one: what its file may not say.

    Parameters
    ----------
    unit
        Unit of the samples: m/s^2, g, mm/s, um …; V or counts if they are not calibrated.
    rate
        Sampling rate, such as '50 kHz', instead of that in the file.
    channel
        Channel, by name or by number from 1.
    scale
        Sensitivity of the sensor, such as '100 mV/g'.
    start
        Start of the part to analyse, such as '2 s'.
    duration
        Duration of the part to analyse; by default to the end.
    decimal_mark
        Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.
    """

    unit: Annotated[
        str | None, Input("Unit of the samples", group=SIGNAL, example="m/s^2", essential=True)
    ] = None
    rate: Annotated[
        float | None,
        Input(
            "Sampling rate", "frequency", SIGNAL, example="50 kHz", essential=True, metavar="RATE"
        ),
    ] = None
    channel: Annotated[
        str | int | None, Input("Channel or variable", group=SIGNAL, example="1", essential=True)
    ] = None
    scale: Annotated[
        float | str | None, Input("Sensitivity of the sensor", group=SIGNAL, example="100 mV/g")
    ] = None
    start: Annotated[float, Input("Start", "time", SIGNAL, example="2 s")] = 0.0
    duration: Annotated[float | None, Input("Duration", "time", SIGNAL, example="10 s")] = None
    decimal_mark: Annotated[str | None, DECIMAL_MARK.below(SIGNAL)] = None

    @property
    def reading(self) -> Reading:
        """What the file may not say, as `rolamento.vibration.open_signal` takes it."""
        return {
            "channel": self.channel, "rate": self.rate, "unit": self.unit, "scale": self.scale,
            "decimal_mark": self.decimal_mark,
        }  # fmt: skip


@dataclass(slots=True)
class Streamed:
    """A signal of which only a piece is held, beside its first one.

    Attributes
    ----------
    first
        piece, for pictures; of a short signal, all of it
    pieces
        all that follow each other, from the first on; to be read once
    samples
        how many were read so far
    """

    first: Signal
    pieces: Signal | Iterable[Signal]
    samples: int

    @property
    def duration(self) -> float:
        """Duration of what was read so far; s."""
        return self.samples / self.first.rate


def part_of(file: SignalFile, start: float, duration: float | None) -> range:
    """Return the samples of a part of a file, as a range in steps of `PIECE`; start, duration in s.

    Raises
    ------
    InputError
        If the part does not lie within the file.
    """
    if not start >= 0.0:
        raise InputError(
            said("must be at least 0"), field="start", value=start, example=arguments(start=2)
        )
    first = round(start * file.rate)
    if first >= file.length:
        rule = said(
            "must be before the end of the signal, {duration:.6g} s", duration=file.duration
        )
        raise InputError(rule, field="start", value=f"{start:g} s", example=arguments(start=2))
    count = file.length - first
    if duration is not None:
        # a part of a sample more is no more than rounding
        if not 1 <= round(duration * file.rate) <= count + 1:
            rule = said(
                "must be positive and end within the signal, which lasts {duration:.6g} s",
                duration=file.duration,
            )
            raise InputError(
                rule, field="duration", value=f"{duration:g} s", example=arguments(duration=10)
            )
        count = min(round(duration * file.rate), count)
    return range(first, first + count, PIECE)


def streamed(pieces: Iterable[Signal], at: AtSpeed, read: Callable[[int], None]) -> Streamed:
    """Take a signal as one if it is short, and piece by piece if it is long.

    Parameters
    ----------
    pieces
        Consecutive parts, each read when it is asked for; at least one.
    at
        Gives each its speed.
    read
        Is called with how many samples were read, as they are read.
    """
    source = _with_speed(pieces, at)
    held = list(islice(source, _WHOLE + 1))
    found = Streamed(held[0], (), sum(len(piece.samples) for piece in held))
    read(found.samples)
    if len(held) <= _WHOLE:
        found.first = _joined(held)
        found.pieces = found.first
        return found

    def rest() -> Iterator[Signal]:
        for piece in source:
            found.samples += len(piece.samples)
            read(found.samples)
            yield piece

    found.pieces = chain(held, rest())
    return found


def _with_speed(pieces: Iterable[Signal], at: AtSpeed) -> Iterator[Signal]:
    first = 0
    for piece in pieces:
        yield at(piece, first)
        first += len(piece.samples)


def _joined(pieces: list[Signal]) -> Signal:
    if len(pieces) == 1:
        return pieces[0]
    speed = pieces[0].speed
    if speed is not None and speed.ndim:
        speed = np.concatenate([piece.speed for piece in pieces if piece.speed is not None])
    samples = np.concatenate([piece.samples for piece in pieces])
    return replace(pieces[0], samples=samples, speed=speed)


# --- several files ---------------------------------------------------------------------------


def files_of(signals: Any) -> list[Any]:
    """Return the files of a use case that takes one or several."""
    return [signals] if isinstance(signals, str | os.PathLike) else list(signals)


def check_files(files: Sequence[Any]) -> None:
    """Refuse none, and too many.

    Raises
    ------
    InputError
        With how many there may be.
    """
    if not 1 <= len(files) <= _MOST_SIGNALS:
        rule = said("must be 1 to {most} files", most=_MOST_SIGNALS)
        raise InputError(rule, field="signals", value=len(files))


def hours_of_files(hours: Sequence[Any], files: Sequence[Any]) -> list[float]:
    """Return the hours at which each of some files was recorded; NaN if they are not given.

    Raises
    ------
    InputError
        If they are no hours, or not as many.
    """
    count = len(files)
    if not hours:
        return [nan] * count
    try:
        times = [float(time) for time in hours]
    except ValueError:
        times = [nan]
    if len(times) != count or not all(0.0 <= time <= _MOST_HOURS for time in times):
        rule = said(
            "must be a number of hours, not negative, for each signal, here {count}", count=count
        )
        raise InputError(
            rule,
            field="hours",
            value=", ".join(map(str, hours)),
            example=arguments(hours=[60, 120, 180]),
        )
    return times


# --- signals whose size counts ---------------------------------------------------------------


def require_calibrated(source: SignalFile, path: str) -> None:
    """Refuse a file of which nobody knows what its samples are worth.

    Raises
    ------
    InputError
        With what has to be given.
    """
    if source.quantity != "unknown":
        return
    unit = source.unit
    if source.channel.unit == "1":
        raise InputError(
            said(
                "is not known: the file holds whole numbers, and no unit tells what the recorder's"
                " full scale is worth. Give that, or the sensitivity of the sensor with the"
                " recorder's range"
            ),
            field="scale",
            example=arguments(scale="5 g"),
            source=path,
        )
    raise InputError(
        said(
            "is not in the file: give the unit of a velocity, an acceleration or a "
            "displacement, or the sensitivity of the sensor"
        )
        if unit in ("", "1")
        else said(
            'is "{unit}": give the unit of a velocity, an acceleration or a '
            "displacement, or the sensitivity of the sensor",
            unit=unit,
        ),
        field="unit",
        example=phrase(
            marked("{first}, {second} or {third}"),
            first=arguments(unit="um/s"),
            second=arguments(unit="m/s^2"),
            third=arguments(scale="100 mV/g"),
        ),
        source=path,
    )


def blocks_at(source: SignalFile, speed: float | None, progress: Progress) -> Iterator[Signal]:
    """Read a file block by block, at a speed (rad/s) if one is given; report the progress."""
    for place, block in enumerate(source.blocks(PIECE), start=1):
        yield block if speed is None else replace(block, speed=np.asarray(speed))
        progress(place, -(-source.length // PIECE))
