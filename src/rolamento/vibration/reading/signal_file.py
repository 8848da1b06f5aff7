"""A signal file with a channel chosen, from which signals are taken whole or in blocks."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Self

import numpy as np

from rolamento.errors import FileError, InputError, arguments
from rolamento.io.foreign.bounds import guarded
from rolamento.io.numerals import checked_mark
from rolamento.numerics import FloatArray
from rolamento.validate import number, whole_number
from rolamento.vibration.reading.channels import (
    MOST_SAMPLES,
    Channel,
    Meaning,
    ShaftSpeed,
    Source,
    channel_beside,
    chosen_channel,
    chosen_speed,
)
from rolamento.vibration.reading.formats import open_source
from rolamento.vibration.reading.memory import SPEED, MemorySource
from rolamento.vibration.reading.metadata import speeds_perhaps
from rolamento.vibration.signal import Quantity, Signal
from rolamento.words import Note, marked, said

__all__ = ["SignalFile", "channels_of", "open_signal", "read_signal"]


class SignalFile:
    """An open signal file and one of its channels, or a part of it; `open_signal` makes it.

    It is a context manager: leaving it closes the file.

    Attributes
    ----------
    path
        of the file
    decimal_mark
        of a table of text, if it was given
    channels
        all that the file holds
    channel
        the one that was chosen
    rate
        sampling rate; Hz
    length
        number of samples of the part that was asked for, by default the whole channel
    quantity, unit
        of the signals that are read: SI, unless the quantity is unknown
    speed
        of the shaft, rad/s, if it is one number; None if the file does not say, or it is a channel
    speed_channel
        channel of the file that gives the speed sample by sample; None if there is none
    notes
        how the samples were taken from the file
    choices
        those of the notes that say which value was taken where the file gives several
    speeds_perhaps
        numbers of the file by name that may be the shaft's speed and do not say their unit
    """

    def __init__(
        self,
        path: Path,
        source: Source,
        number: int,
        meaning: Meaning,
        speed: ShaftSpeed,
        part: tuple[int, int],
        decimal_mark: str | None = None,
    ) -> None:
        self.path = path
        self.decimal_mark = decimal_mark
        self.channels = source.channels
        self.channel = source.channels[number]
        self.rate = meaning.rate
        self._first, self.length = part
        self.quantity: Quantity = meaning.quantity
        self.unit = meaning.unit
        self.speed = speed.value
        self.speed_channel = None if speed.channel is None else source.channels[speed.channel]
        self.choices: tuple[Note, ...] = meaning.choices
        self.notes = (*source.notes, *meaning.notes, *meaning.choices)
        self.speeds_perhaps = speeds_perhaps(source.numbers, meaning.rate)
        self._source = source
        self._wanted = (number,) if speed.channel is None else (number, speed.channel)
        self._scales = (meaning.scale, speed.scale)

    @property
    def calibrated(self) -> bool:
        """Whether the size of the samples means something: they are in m/s², m/s or m."""
        return self.quantity != "unknown"

    @property
    def duration(self) -> float:
        """Number of samples over the rate; s."""
        return self.length / self.rate

    def read(self, start: int = 0, count: int | None = None) -> Signal:
        """Return `count` samples from sample `start` on, all that follow by default.

        Raises
        ------
        InputError
            If they do not lie within the part or are more than 100 million.
        FileError
            If the file is damaged there, or a sample is not a finite number.
        """
        name = str(self.path)
        with guarded(name, marked("signal file")):
            start = whole_number(start, "start", least=0, most=self.length - 1, example="start = 0")
            rest = self.length - start
            if count is None:
                count = rest
            count = whole_number(count, "count", least=1, most=rest, example="count = 1000")
            if count > MOST_SAMPLES:
                raise InputError(
                    said(
                        "must be at most {most} at once; read a shorter duration, or blocks",
                        most=MOST_SAMPLES,
                    ),
                    field=marked("number of samples"),
                    value=count,
                    example=arguments(start=0.0, duration=60.0),
                )
            start += self._first
            rows = self._source.read(self._wanted, start, count)
            for row, scale, field in zip(rows, self._scales, ("", "speed"), strict=False):
                _refuse_not_finite(row, start, self.rate, field)
                if scale != 1.0:
                    row *= scale
            return self._signal(rows[0], rows[1] if len(rows) > 1 else None)

    def blocks(self, size: int, overlap: int = 0) -> Iterator[Signal]:
        """Return the channel in blocks.

        Parameters
        ----------
        size
            samples of a block; the last one may be shorter
        overlap
            samples of the block before with which a block begins; fewer than `size`

        Raises
        ------
        InputError
            If the numbers are not such.
        FileError
            As `read`.
        """
        size = whole_number(size, "size", least=1, most=MOST_SAMPLES, example="size = 65536")
        overlap = whole_number(overlap, "overlap", least=0, most=size - 1, example="overlap = 0")
        return self._blocks(size, overlap)

    def close(self) -> None:
        """Let go of the file."""
        self._source.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _blocks(self, size: int, overlap: int) -> Iterator[Signal]:
        block = self.read(0, min(size, self.length))
        yield block
        place = len(block.samples)
        while place < self.length:
            fresh = self.read(place, min(size - overlap, self.length - place))
            place += len(fresh.samples)
            kept = block.samples[len(block.samples) - overlap :]
            samples = np.concatenate([kept, fresh.samples]) if overlap else fresh.samples
            speed = fresh.speed
            if overlap and speed is not None and block.speed is not None and speed.ndim:
                speed = np.concatenate([block.speed[len(block.speed) - overlap :], speed])
            block = self._signal(samples, speed)
            yield block

    def _signal(self, samples: FloatArray, speed: FloatArray | None) -> Signal:
        title = self.path.name + (f", {self.channel.name}" if self.channel.name else "")
        if speed is None and self.speed is not None:
            speed = np.array(self.speed)
        return Signal(samples, self.rate, self.quantity, self.unit, speed, title[:300])


def open_signal(
    path: str | os.PathLike[str] | Signal,
    *,
    channel: str | int | None = None,
    rate: float | None = None,
    unit: str | None = None,
    quantity: Quantity | None = None,
    scale: float | str | None = None,
    speed_channel: str | int | None = None,
    speed_unit: str | None = None,
    decimal_mark: str | None = None,
    start: float = 0.0,
    duration: float | None = None,
) -> SignalFile:
    """Open a signal file of any format, for reading in blocks.

    Parameters
    ----------
    path
        WAV, CSV, .npy, .npz, MATLAB 5 to 7.3, HDF5, Parquet or universal file; or a signal in
        memory, which is read alike
    channel
        its name, or its number counted from 1; not needed if there is only one
    rate
        sampling rate, Hz; needed if the file does not say, or says it in several ways; over what
        it says, with a note
    unit
        of the samples in the file, such as "g", "m/s^2", "mm/s" or "um"; or "V", "mV", "uV",
        "counts" and "1" before calibration
    quantity
        acceleration, velocity, displacement or unknown; by default that of the unit
    scale
        sensitivity of the sensor, such as "100 mV/g", "3276.8 counts/g" or "0.5 g/V"; or what one
        unit of the samples is worth, as text, "10 g", or as a number of SI units: m/s², unless the
        quantity is another
    speed_channel
        channel of the shaft's speed at each sample, by name or number; or name of a single number
        that is the speed. By default what the file says by itself
    speed_unit
        rpm, rad/s, deg/s or Hz; not needed if the file says so, or the name ends in rpm or Hz
    decimal_mark
        "point" or "comma", of a table of text in which nothing shows whether 12.500 is 12.5
    start
        of the part to read, from the beginning of the file; s
    duration
        of the part, s; all that follows by default

    Raises
    ------
    FileError
        If the file cannot be read.
    InputError
        If there is no such channel or several to choose from, the rate or the unit of the speed is
        not known or in doubt, unit or scale is none, a unit contradicts the file, or the part does
        not lie within it.
    """
    if isinstance(path, Signal):
        source: Source = MemorySource(path)
        name = path.title or said("signal")
        if len(source.channels) > 1 and speed_channel is None:
            channel, speed_channel = 1, SPEED
    else:
        mark = None if decimal_mark is None else checked_mark(decimal_mark)
        source, name = open_source(path, mark), os.fspath(path)
    try:
        with guarded(str(name), marked("signal file")):
            beside = channel_beside(source, speed_channel) if channel is None else None
            number = chosen_channel(source.channels, channel) if beside is None else beside
            chosen = source.channels[number]
            if chosen.length == 0:
                raise FileError(said("has no samples in this channel"), field=chosen.name)
            meaning = Meaning(chosen, rate, unit, quantity, scale)
            part = _part(chosen.length, meaning.rate, start, duration)
            speed = chosen_speed(source, number, speed_channel, speed_unit)
            return SignalFile(Path(name), source, number, meaning, speed, part, decimal_mark)
    except BaseException:
        source.close()
        raise


def read_signal(
    path: str | os.PathLike[str],
    *,
    channel: str | int | None = None,
    rate: float | None = None,
    unit: str | None = None,
    quantity: Quantity | None = None,
    scale: float | str | None = None,
    speed_channel: str | int | None = None,
    speed_unit: str | None = None,
    decimal_mark: str | None = None,
    start: float = 0.0,
    duration: float | None = None,
) -> Signal:
    """Read a signal, or a part of it, into memory.

    Parameters
    ----------
    path, channel, rate, unit, quantity, scale, speed_channel, speed_unit, decimal_mark, start
        As `open_signal`.
    duration
        As `open_signal`.

    Raises
    ------
    FileError
        If the file cannot be read, or a sample is not a finite number.
    InputError
        As `open_signal`; also if the part has more than 100 million samples, or does not change:
        there is no signal in it.
    """
    with open_signal(
        path,
        channel=channel,
        rate=rate,
        unit=unit,
        quantity=quantity,
        scale=scale,
        speed_channel=speed_channel,
        speed_unit=speed_unit,
        decimal_mark=decimal_mark,
        start=start,
        duration=duration,
    ) as file:
        signal = file.read()
    samples = signal.samples
    if np.min(samples) == np.max(samples):
        raise FileError(
            said(
                "is constant over {count} samples: no sensor was connected, or it is "
                "the wrong channel",
                count=len(samples),
            ),
            field=file.channel.name or "channel",
            value=float(samples[0]),
            source=str(file.path),
        )
    return signal


def channels_of(path: str | os.PathLike[str]) -> tuple[Channel, ...]:
    """Return the channels of a signal file: names, lengths, and what it says of rates and units.

    Raises
    ------
    FileError
        If the file cannot be read.
    """
    with open_source(path) as source:
        return source.channels


def _part(length: int, rate: float, start: float, duration: float | None) -> tuple[int, int]:
    """First sample and number of samples of a part of a channel."""
    example = "start=0.0, duration=10.0"
    begin = number(start, "start", least=0.0, example=example)
    if begin * rate >= length:
        rule = said("must be before the end of the file, {length:.6g} s", length=length / rate)
        raise InputError(rule, field="start", value=start, example=example)
    first = min(round(begin * rate), length - 1)
    rest = length - first
    if duration is None:
        return first, rest
    wanted = number(duration, "duration", above=0.0, example=example)
    count = round(min(wanted * rate, rest + 2.0))
    if not 1 <= count <= rest + 1:
        raise InputError(
            said(
                "must be between one sample and the {rest:.6g} s after the start",
                rest=rest / rate,
            ),
            field="duration",
            value=duration,
            example=example,
        )
    return first, min(count, rest)


def _refuse_not_finite(samples: FloatArray, start: int, rate: float, field: str) -> None:
    """Refuse samples that are no numbers, and say how many there are and where the first is."""
    wrong = ~np.isfinite(samples)
    count = int(np.count_nonzero(wrong))
    if count:
        first = int(np.argmax(wrong))
        raise FileError(
            said(
                "{count} of {count_2} samples are not finite numbers; the first is "
                "sample {start} (counted from 0), at {start_2:.6g} s",
                count=count,
                count_2=len(samples),
                start=start + first,
                start_2=(start + first) / rate,
            ),
            field=field,
            value=float(samples[first]),
        )
