"""A speed that changes, for `rolamento diagnose`: by a tachometer, or found in the vibration.

Both give the speed at knots, between which it is taken as even. The vibration is searched stretch
by stretch: the longer a stretch, the less it takes for its revolutions to be miscounted by one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, floor, pi
from typing import TYPE_CHECKING, Final, Protocol

import numpy as np

from rolamento.cli.signal_source import in_options
from rolamento.errors import FileError, InputError
from rolamento.numerics import FloatArray
from rolamento.report.diagnosis_result import Tracking
from rolamento.vibration.reading import SignalFile, open_signal
from rolamento.vibration.shaft_speed import estimate_speed, speed_from_pulses

if TYPE_CHECKING:
    from rolamento.vibration.signal import Signal

__all__ = ["MOST_TACHO_SAMPLES", "Along", "found_in_vibration", "of_tacho"]

MOST_TACHO_SAMPLES: Final = 20_000_000
"""Of a tachometer's channel, which is held in memory."""
MOST_STRETCH_SAMPLES: Final = 2**23
"""Of vibration in which the speed is looked for at once."""
_STRETCH: Final = 1600.0
"""Revolutions; of many more, a path of the speed is less sure."""
_MARGIN: Final = 48.0
"""Revolutions by which stretches overlap: near its ends a path is least sure."""
_LEAST: Final = 96.0
"""Revolutions that a path needs."""
_KNOTS: Final = 8.0
"""In a revolution; a path is smooth over several."""

Progress = Callable[[int, int], None]


class Along(Protocol):
    """A speed along a record, known at knots; rad/s."""

    @property
    def speed(self) -> FloatArray:
        """At the knots."""

    def at(self, first: int, count: int) -> FloatArray:
        """Return the speed at so many samples of the vibration, from the first one on."""


@dataclass(frozen=True, slots=True, eq=False)
class AtPlaces:
    """A speed at knots anywhere; places: (knots,), in samples of the vibration, rising."""

    places: FloatArray
    speed: FloatArray

    def at(self, first: int, count: int) -> FloatArray:
        """Return the speed at so many samples of the vibration, from the first one on."""
        wanted = first + np.arange(count, dtype=np.float64)
        return np.asarray(np.interp(wanted, self.places, self.speed))


@dataclass(frozen=True, slots=True, eq=False)
class AtSamples:
    """A speed at every sample of another channel; ratio: samples of it for one of vibration."""

    ratio: float
    speed: FloatArray

    def at(self, first: int, count: int) -> FloatArray:
        """Return the speed at so many samples of the vibration, from the first one on."""
        wanted = (first + np.arange(count, dtype=np.float64)) * self.ratio
        low, high = int(wanted[0]), int(wanted[-1]) + 2
        knots = self.speed[low:high]
        return np.asarray(np.interp(wanted - low, np.arange(len(knots), dtype=np.float64), knots))


def of_tacho(source: SignalFile, part: range, channel: str, pulses: int) -> tuple[Along, str]:
    """Return the speed by the pulses of another channel of a signal's file, and its name.

    Parameters
    ----------
    source
        The signal.
    part
        Samples of it that are diagnosed.
    channel
        Name, or number from 1 on.
    pulses
        Per revolution.

    Raises
    ------
    InputError, FileError
        If there is no such channel, it does not cover the signal, is too long to be held, or its
        pulses are none.
    """
    with _opened(source, channel) as tacho:
        ratio = tacho.rate / source.rate
        first = round(part.start * ratio)
        count = ceil((part.stop - part.start - 1) * ratio) + 1
        _check_extent(tacho, source, part, first + count)
        count = min(count, tacho.length - first)
        if count > MOST_TACHO_SAMPLES:
            raise InputError(
                f"is held in memory, up to {MOST_TACHO_SAMPLES} samples, "
                f"{MOST_TACHO_SAMPLES / tacho.rate:.6g} s; these are {count}",
                source="--tacho",
                value=channel,
                example=f"--duration '{floor(MOST_TACHO_SAMPLES / tacho.rate)} s'",
            )
        signal = tacho.read(first, count)
        name = tacho.channel.name or channel
    return AtSamples(ratio, _speed_of(signal, pulses, channel)), name


def _opened(source: SignalFile, channel: str) -> SignalFile:
    """Open the channel of pulses; of a file that tells no rate, it has that of the signal.

    Where the signal's rate was given over that of the file, the channel's goes with it.
    """
    given: dict[str, float | None] = {"rate": None}
    mark = source.decimal_mark
    try:
        try:
            tacho = open_signal(source.path, channel=channel, decimal_mark=mark)
        except InputError as error:
            if error.field != "rate":
                raise
            given["rate"] = source.rate
            tacho = open_signal(source.path, channel=channel, rate=source.rate, decimal_mark=mark)
        of_file = source.channel.rate
        if of_file is not None and of_file != source.rate and given["rate"] is None:
            rate = tacho.rate * source.rate / of_file
            tacho.close()
            tacho = open_signal(source.path, channel=channel, rate=rate, decimal_mark=mark)
    except InputError as error:
        raise in_options(error, {"channel": "--tacho"}) from None
    if _place(tacho) == _place(source):
        tacho.close()
        raise InputError(
            "is the channel of the vibration; choose that of the pulses",
            source="--tacho",
            value=channel,
            example="--channel 1 --tacho 2",
        )
    if given["rate"] is not None and tacho.length != source.length:
        tacho.close()
        raise FileError(
            f"has {tacho.length} samples, and the vibration {source.length}: as the file tells no "
            "rates, they have to be as many",
            source="--tacho",
            value=channel,
        )
    return tacho


def _place(file: SignalFile) -> int:
    """Return the number of the channel that was chosen, counted from 0."""
    return next(i for i, channel in enumerate(file.channels) if channel is file.channel)


def _check_extent(tacho: SignalFile, source: SignalFile, part: range, end: int) -> None:
    """Refuse pulses that end before the vibration does."""
    # rounding may ask for one sample more than there are
    if end > tacho.length + 1:
        raise FileError(
            f"ends at {tacho.duration:.6g} s, before the signal that is diagnosed, at "
            f"{part.stop / source.rate:.6g} s; give a shorter --duration",
            source="--tacho",
            value=tacho.channel.name or None,
        )


def _speed_of(signal: Signal, pulses: int, channel: str) -> FloatArray:
    try:
        return speed_from_pulses(signal, pulses)
    except InputError as error:
        rule, _, _ = error.rule.partition(";")
        if error.field == "pulses_per_revolution":
            raise error.with_details(field="", source="--pulses", example="--pulses 1") from None
        number = f", here {error.value}" if error.field == "number of pulses" else ""
        raise InputError(
            f"{error.field or 'the pulses'} {rule}{number}; give the channel that holds the pulses,"
            " or a part of the record with all of them",
            source="--tacho",
            value=channel,
            example="--tacho 2 --pulses 1",
        ) from None


def found_in_vibration(
    source: SignalFile, part: range, nominal: float, within: float, progress: Progress
) -> tuple[Along | None, Tracking]:
    """Find the speed in the vibration itself; None if the shaft does not stand out of its noise.

    Parameters
    ----------
    source, part
        The vibration.
    nominal
        About what the speed is; rad/s, signed.
    within
        Part by which it may be off anywhere.
    progress
        Is told how many stretches of how many are done.

    Raises
    ------
    InputError
        If the record is too short, its rate too low for the speed, or too high for its memory.
    """
    count = part.stop - part.start
    per_turn = 2.0 * pi * source.rate / abs(nominal)
    if count < _LEAST * per_turn:  # told before anything is read
        raise InputError(
            f"must be at least {_LEAST:g} revolutions of the shaft at its nominal speed,"
            f" {_LEAST * per_turn / source.rate:.3g} s",
            source="--track",
            field="record",
            value=f"{count / per_turn:.4g} revolutions",
            example="--speed-channel rpm",
        )
    stretches = _stretches(count, per_turn)
    margin = ceil(_MARGIN * per_turn)
    step = max(1, int(per_turn / _KNOTS))
    places, speeds, least = [], [], np.inf
    for number, (start, end) in enumerate(stretches, start=1):
        first, last = max(0, start - margin), min(count, end + margin)
        signal = source.read(part.start + first, last - first)
        try:
            found = estimate_speed(signal, abs(nominal), tolerance=within)
        except InputError as error:
            raise _of_tracking(error) from None
        least = min(least, found.evidence)
        if not found.found:
            lost = (part.start + start) / source.rate, (part.start + end) / source.rate
            return None, Tracking(nominal, within, False, least, lost)
        knots = np.arange(start, end, step)
        places.append(knots.astype(np.float64))
        speeds.append(found.speed[knots - first])
        progress(number, len(stretches))
    sign = -1.0 if nominal < 0.0 else 1.0
    along = AtPlaces(np.concatenate(places), sign * np.concatenate(speeds))
    return along, Tracking(nominal, within, True, float(least))


def _stretches(count: int, per_turn: float) -> list[tuple[int, int]]:
    """Cut so many samples into stretches of about as many revolutions; their ends.

    Raises
    ------
    InputError
        If a stretch that can be held in memory has too few revolutions.
    """
    room = MOST_STRETCH_SAMPLES - 2 * ceil(_MARGIN * per_turn)
    turns = count / per_turn
    if count > MOST_STRETCH_SAMPLES and room < _LEAST * per_turn:
        raise InputError(
            f"holds {MOST_STRETCH_SAMPLES} samples in memory at once, and {2.0 * _LEAST:g} "
            f"revolutions are {2.0 * _LEAST * per_turn:.0f}: give a measured speed",
            source="--track",
            example="--speed-channel rpm",
        )
    number = max(1, round(turns / _STRETCH))
    if count > MOST_STRETCH_SAMPLES:
        number = max(number, -(-count // room))
    ends = np.rint(np.linspace(0, count, number + 1)).astype(int).tolist()
    return list(pairwise(ends))


def _of_tracking(error: InputError) -> InputError:
    """Say in words of the command what a path of the speed lacks."""
    if error.field == "tolerance":
        return InputError(
            "must be a part over 0 and up to 0.3",
            source="--within",
            value=error.value,
            example="--within 0.1",
        )
    example = "--speed-channel rpm" if error.field in ("record", "rate") else error.example
    return error.with_details(source="--track", example=example)
