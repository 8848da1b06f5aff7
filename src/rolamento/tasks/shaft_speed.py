"""How fast the shaft of a signal turns: given, measured, or found in the vibration itself.

A speed that was measured, by a tachometer or in the vibration, is known at knots, between which it
is taken as even. The vibration is searched stretch by stretch: the longer a stretch, the less it
takes for its revolutions to be miscounted by one.
"""

from __future__ import annotations

from dataclasses import asdict, replace
from itertools import pairwise
from math import ceil, floor, isnan, nan, pi
from typing import Any, Final, Literal, Protocol

import numpy as np

from rolamento.errors import FileError, InputError, arguments, phrase
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.parameters import Progress
from rolamento.tasks.signals import AtSpeed
from rolamento.units import rpm_of
from rolamento.vibration.order_tracking import revolutions_of
from rolamento.vibration.reading import SignalFile, open_signal
from rolamento.vibration.shaft_speed import estimate_speed, speed_from_pulses
from rolamento.vibration.signal import Signal
from rolamento.words import Note, manner, marked, said

SpeedSource = Literal["given", "file", "case", "channel", "pulses", "vibration"]
"""Where the speed is from: the user, the signal's file, the case; or what it was measured from."""

WITHIN: Final = 0.1
_EXAMPLE: Final = arguments(speed="1797 rpm")
_SAME_SPEED: Final = 1e-3
"""Part by which two statements of a speed may differ: it is not known better."""
_MOST_OFFERED: Final = 5
MOST_TACHO_SAMPLES: Final = 20_000_000
"""Maximum number of samples of a tachometer's channel, which is held in memory."""
MOST_STRETCH_SAMPLES: Final = 2**23
"""Maximum number of samples of vibration in which the speed is looked for at once."""
_STRETCH: Final = 1600.0
"""Revolutions; of many more, a path of the speed is less sure."""
_MARGIN: Final = 48.0
"""Revolutions by which stretches overlap: near its ends a path is least sure."""
_LEAST: Final = 96.0
"""Revolutions that a path needs."""
_KNOTS: Final = 8.0
"""In a revolution; a path is smooth over several."""

Rings = tuple[float | None, float | None]


@frozen
class Tracking:
    """What came of looking for the speed in the vibration itself.

    Attributes
    ----------
    nominal
        about which it was looked for; rad/s
    within
        part of that
    found
        whether the shaft stands out of the noise all along
    evidence
        -log10 of the probability that noise gives as clear a path, of the least clear stretch
    lost
        beginning and end of the first stretch in which it does not stand out, or in which the path
        does not follow it, s; None if found
    share
        of a clear harmonic's power that lies on the path, of the worst stretch; NaN without any
    """

    nominal: float
    within: float
    found: bool
    evidence: float
    lost: tuple[float, float] | None = None
    share: float = nan


@frozen
class ShaftSpeed:
    """How fast the shaft turned, and how that is known.

    Attributes
    ----------
    source
        where the speed is from
    mean, minimum, maximum
        over the signal, signed; rad/s
    channel
        that it was measured in
    pulses
        per revolution, of a tachometer
    tracking
        of a speed that was looked for in the vibration
    """

    source: SpeedSource
    mean: float
    minimum: float
    maximum: float
    channel: str = ""
    pulses: int | None = None
    tracking: Tracking | None = None

    @classmethod
    def steady(cls, source: SpeedSource, speed: float) -> ShaftSpeed:
        """Return a speed that is one number; rad/s."""
        return cls(source, speed, speed, speed)

    @property
    def is_steady(self) -> bool:
        """Whether one number was taken for all of the signal."""
        return self.source in ("given", "file", "case")

    @property
    def lost(self) -> bool:
        """Whether it was looked for in the vibration, and not found."""
        return self.tracking is not None and not self.tracking.found

    @property
    def lost_note(self) -> Note:
        """Where it was looked for in the vibration, and not found."""
        tracking = self.tracking
        assert tracking is not None
        start, end = tracking.lost or (nan, nan)
        values = {"start": start, "end": end, "within": tracking.within}
        key = "speed_not_found" if isnan(tracking.share) else "path_lost"
        shared = {"nominal": abs(tracking.nominal), "share": tracking.share}
        return Note(key, values | shared)

    def to_mapping(self) -> dict[str, Any]:
        """Return all of it as plain data, in rad/s."""
        return {
            "source": self.source,
            "mean": self.mean,
            "minimum": self.minimum,
            "maximum": self.maximum,
            "channel": self.channel or None,
            "pulses_per_revolution": self.pulses,
            "tracking": None if self.tracking is None else asdict(self.tracking),
        }


@frozen
class SpeedInputs:
    """What is said of the speed; None where nothing is.

    Attributes
    ----------
    inner, outer
        of the rings; rad/s
    channel
        of the file, with the speed
    tacho, pulses
        channel of the file with pulses, and how many there are in a revolution
    track, within
        whether to find the speed in the vibration, and by which part it may be off
    """

    inner: float | None = None
    outer: float | None = None
    channel: str | int | None = None
    unit: str | None = None
    tacho: str | int | None = None
    pulses: int | None = None
    track: bool = False
    within: float | None = None

    def __post_init__(self) -> None:
        """Refuse what contradicts each other, or waits for another."""
        ways = {
            "speed_channel": self.channel is not None,
            "tacho": self.tacho is not None,
            "track": self.track,
        }
        chosen = [way for way, is_given in ways.items() if is_given]
        if len(chosen) > 1:
            raise InputError(
                phrase(
                    marked("gives the speed in another way than {chosen}: leave one of them out"),
                    chosen=arguments(**{chosen[0]: ...}),
                ),
                field=chosen[1],
                example=phrase(
                    marked("{chosen}, or {speed} alone"),
                    chosen=arguments(**{chosen[0]: ...}),
                    speed=_EXAMPLE,
                ),
            )
        for parameter, value, needed, example in (
            (
                "speed_unit",
                self.unit,
                "speed_channel",
                arguments(speed_channel="rpm", speed_unit="rpm"),
            ),
            ("pulses", self.pulses, "tacho", arguments(tacho=2, pulses=1)),
            ("within", self.within, "track", arguments(track=True, within=0.1)),
        ):
            if value is not None and not ways[needed]:
                rule = phrase(
                    marked("needs {needed}, which is missing"), needed=arguments(**{needed: ...})
                )
                raise InputError(rule, field=parameter, value=value, example=example)
        if self.measured:
            for parameter, speed in (("speed", self.inner), ("outer_speed", self.outer)):
                if speed is not None:
                    raise InputError(
                        phrase(
                            marked(
                                "is a steady speed, but {measured} is the measured speed of the "
                                "rotating ring: leave one of them out"
                            ),
                            measured=arguments(**{self.measured: ...}),
                        ),
                        field=parameter,
                        value=f"{rpm_of(speed):.6g} rpm",
                        example=phrase(
                            marked("{argument} alone"),
                            argument=arguments(**{self.measured: ...}),
                        ),
                    )

    @property
    def measured(self) -> str:
        """The parameter of a speed that was measured; empty if there is none."""
        if self.channel is not None:
            return "speed_channel"
        return "" if self.tacho is None else "tacho"


@frozen
class KnownSpeed:
    """The speed along the part that is diagnosed.

    Attributes
    ----------
    shaft
        mean and range, and how they are known
    inner, outer
        mean speeds of the rings; rad/s
    at
        gives a piece of the signal its speed, from the number of its first sample in the part on
    choices
        what a person should know where a speed was given and the file gives another
    """

    shaft: ShaftSpeed
    inner: float
    outer: float
    at: AtSpeed
    choices: tuple[Note, ...] = ()


def known_speed(
    asked: SpeedInputs, of_case: Rings, source: SignalFile, part: range, progress: Progress
) -> KnownSpeed:
    """Find out how fast the rings turn along a part of a signal.

    Parameters
    ----------
    asked
        What is said of it.
    of_case
        Speeds of the inner and outer ring by the case; rad/s.
    source, part
        The signal; opened with its channel of speeds, if one was asked for.
    progress
        Is called with how much is done where the file has to be gone through.

    Raises
    ------
    InputError, FileError
        If no speed is known, it is 0 or comes near it, or a channel does not give it.
    """
    if source.speed_channel is not None:
        return _of_channel(asked, of_case, source, part, progress)
    if asked.tacho is not None:
        return _of_tacho(asked, asked.tacho, of_case, source, part)
    steady = _steady(asked, of_case, source)
    if not asked.track:
        return steady
    if steady.inner and steady.outer:
        raise _both_turn("track")
    within = WITHIN if asked.within is None else asked.within
    nominal = steady.inner or steady.outer
    along, tracking = found_in_vibration(source, part, nominal, within, progress)
    if along is None:
        return replace(steady, shaft=replace(steady.shaft, tracking=tracking))
    shaft = replace(_shaft_speed("vibration", along), tracking=tracking)
    return _of_turning_ring(shaft, (steady.inner, steady.outer), _interpolated(along))


def _steady(asked: SpeedInputs, of_case: Rings, source: SignalFile) -> KnownSpeed:
    """Return the rings' speeds as given, of the signal's file, of the case.

    What the file gives is the shaft's: the inner ring's, unless the outer one alone is given.
    """
    inner, outer, of_file = asked.inner, asked.outer, source.speed
    by: SpeedSource = "given"
    if inner is None and outer is None:
        by = "case"
        if of_file is not None:
            by = "file"
            outer_turns = not of_case[0] and bool(of_case[1])
            inner, outer = (0.0, of_file) if outer_turns else (of_file, None)
    if inner is None:
        inner = of_case[0]
    if outer is None:
        outer = of_case[1]
    if inner is None and outer is None:
        raise _missing(source)
    if not inner and not outer:
        rule = said("is that of both rings: a bearing at rest shows nothing")
        raise InputError(rule, field="speed", value="0 rpm", example=_EXAMPLE)
    known = _of_numbers(by, inner or 0.0, outer or 0.0)
    return replace(known, choices=_over_file(known.shaft.mean, of_file)) if by == "given" else known


def _over_file(given: float, of_file: float | None) -> tuple[Note, ...]:
    """Return that the file gives another speed than the one that was given, if it does; rad/s."""
    if of_file is None or abs(abs(given) - abs(of_file)) <= _SAME_SPEED * abs(of_file):
        return ()
    return (Note("speed_over_file", {"speed": given, "file": of_file}),)


def _missing(source: SignalFile) -> InputError:
    """Ask for the speed, and offer the numbers of the file that may be it."""
    example: str = _EXAMPLE
    rule = said("is missing, and is given neither in the file nor in the case")
    if source.speeds_perhaps:
        entries = [f"{name} = {value:.6g}" for name, value in source.speeds_perhaps.items()]
        name = next(iter(source.speeds_perhaps))
        rule = said(
            "is missing, and is given neither in the file nor in the case; "
            "{numbers} in the file may be it, but without a unit",
            numbers=", ".join(entries[:_MOST_OFFERED]),
        )
        example = phrase(
            marked("{first}, or {second}"),
            first=_EXAMPLE,
            second=arguments(speed_channel=name, speed_unit="Hz"),
        )
    return InputError(rule, field="speed", example=example)


def _of_numbers(by: SpeedSource, inner: float, outer: float) -> KnownSpeed:
    speed = np.asarray(inner or outer)
    shaft = ShaftSpeed.steady(by, float(speed))
    return KnownSpeed(shaft, inner, outer, lambda piece, first: replace(piece, speed=speed))


def _of_channel(
    asked: SpeedInputs, of_case: Rings, source: SignalFile, part: range, progress: Progress
) -> KnownSpeed:
    """Take the speed that the signal has beside it, gone through once for its mean and range."""
    total, lowest, highest = 0.0, np.inf, -np.inf
    for number, place in enumerate(part, start=1):
        speed = source.read(place, min(part.step, part.stop - place)).speed
        assert speed is not None
        total += float(np.sum(speed))
        lowest, highest = min(lowest, float(np.min(speed))), max(highest, float(np.max(speed)))
        progress(number, len(part))
    assert source.speed_channel is not None
    name = source.speed_channel.name or str(asked.channel or "")
    shaft = ShaftSpeed("channel", total / (part.stop - part.start), lowest, highest, channel=name)
    _check_range(shaft, "speed_channel")
    return _of_turning_ring(shaft, _one_ring(of_case, "speed_channel"), lambda piece, first: piece)


def _of_tacho(
    asked: SpeedInputs, channel: str | int, of_case: Rings, source: SignalFile, part: range
) -> KnownSpeed:
    rings = _one_ring(of_case, "tacho")
    pulses = 1 if asked.pulses is None else asked.pulses
    along, name = of_tacho(source, part, channel, pulses)
    shaft = replace(_shaft_speed("pulses", along), channel=name, pulses=pulses)
    _check_range(shaft, "tacho")
    return _of_turning_ring(shaft, rings, _interpolated(along))


def _shaft_speed(by: SpeedSource, along: Along) -> ShaftSpeed:
    speed = along.speed
    return ShaftSpeed(by, float(speed.mean()), float(speed.min()), float(speed.max()))


def _interpolated(along: Along) -> AtSpeed:
    def at(piece: Signal, first: int) -> Signal:
        return replace(piece, speed=along.at(first, len(piece.samples)))

    return at


def _of_turning_ring(shaft: ShaftSpeed, rings: Rings, at: AtSpeed) -> KnownSpeed:
    """Give the ring that turns its mean speed: the inner one, unless the outer alone is given."""
    outer_turns = not rings[0] and bool(rings[1])
    inner, outer = (0.0, shaft.mean) if outer_turns else (shaft.mean, 0.0)
    return KnownSpeed(shaft, inner, outer, at)


def _one_ring(of_case: Rings, parameter: str) -> Rings:
    """Return the rings' speeds, of which one may turn where a speed is measured."""
    if all(of_case):
        raise _both_turn(parameter)
    return of_case


def _both_turn(parameter: str) -> InputError:
    return InputError(
        said(
            "is the speed of one ring, but both rotate: the orders of the bearing "
            "would change with it"
        ),
        field=parameter,
        example=arguments(outer_speed="0 rpm"),
    )


def _check_range(shaft: ShaftSpeed, parameter: str) -> None:
    """Refuse a speed that changes its sign or comes near 0, before anything is diagnosed."""
    try:
        # the rule is that of order tracking; it looks at the extremes
        revolutions_of(Signal(np.zeros(2), 1.0, speed=np.array([shaft.minimum, shaft.maximum])))
    except InputError as error:
        raise InputError(
            phrase(
                marked("{rule}, with {start} and {duration}"),
                rule=error.rule,
                start=arguments(start=...),
                duration=arguments(duration=...),
            ),
            field=parameter,
            value=said("{low:.6 [rpm]} to {high:.6 rpm}", low=shaft.minimum, high=shaft.maximum),
            example=arguments(start=2, duration=10),
        ) from None


# --- along a record ---------------------------------------------------------------------------


class Along(Protocol):
    """A speed along a record, known at knots; rad/s."""

    @property
    def speed(self) -> FloatArray:
        """At the knots."""

    def at(self, first: int, count: int) -> FloatArray:
        """Return the speed at so many samples of the vibration, from the first one on."""


@frozen(eq=False)
class AtPlaces:
    """A speed at knots anywhere; places: (knots,), in samples of the vibration, rising."""

    places: FloatArray
    speed: FloatArray

    def at(self, first: int, count: int) -> FloatArray:
        """Return the speed at so many samples of the vibration, from the first one on."""
        wanted = first + np.arange(count, dtype=np.float64)
        return np.asarray(np.interp(wanted, self.places, self.speed))


@frozen(eq=False)
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


def of_tacho(source: SignalFile, part: range, channel: str | int, pulses: int) -> tuple[Along, str]:
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
    with _opened_tacho(source, channel) as tacho:
        ratio = tacho.rate / source.rate
        first = round(part.start * ratio)
        count = ceil((part.stop - part.start - 1) * ratio) + 1
        _check_extent(tacho, source, part, first + count)
        count = min(count, tacho.length - first)
        if count > MOST_TACHO_SAMPLES:
            raise InputError(
                said(
                    "is held in memory, up to {most} samples, {most_2:.6g} s; this record "
                    "has {count}",
                    most=MOST_TACHO_SAMPLES,
                    most_2=MOST_TACHO_SAMPLES / tacho.rate,
                    count=count,
                ),
                field="tacho",
                value=channel,
                example=arguments(duration=floor(MOST_TACHO_SAMPLES / tacho.rate)),
            )
        signal = tacho.read(first, count)
        name = tacho.channel.name or str(channel)
    return AtSamples(ratio, _speed_of_pulses(signal, pulses, channel)), name


def _opened_tacho(source: SignalFile, channel: str | int) -> SignalFile:
    """Open the channel of pulses; of a file without a rate, it has that of the signal.

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
        raise error.spelled({"channel": "tacho"}) from None
    if _channel_number(tacho) == _channel_number(source):
        tacho.close()
        raise InputError(
            said("is the vibration channel; choose that of the pulses"),
            field="tacho",
            value=channel,
            example=arguments(channel=1, tacho=2),
        )
    if given["rate"] is not None and tacho.length != source.length:
        tacho.close()
        raise FileError(
            said(
                "has {length} samples, and the vibration {length_2}: since the file "
                "gives no rates, they must be equal",
                length=tacho.length,
                length_2=source.length,
            ),
            field="tacho",
            value=channel,
        )
    return tacho


def _channel_number(file: SignalFile) -> int:
    """Return the number of the channel that was chosen, counted from 0."""
    return next(i for i, channel in enumerate(file.channels) if channel is file.channel)


def _check_extent(tacho: SignalFile, source: SignalFile, part: range, end: int) -> None:
    """Refuse pulses that end before the vibration does."""
    # rounding may ask for one sample more than there are
    if end > tacho.length + 1:
        raise FileError(
            phrase(
                marked(
                    "ends at {duration:.6g} s, before the analysed signal, at {stop:.6g} "
                    "s; give a shorter {argument}"
                ),
                duration=tacho.duration,
                stop=part.stop / source.rate,
                argument=arguments(duration=...),
            ),
            field="tacho",
            value=tacho.channel.name or None,
        )


def _speed_of_pulses(signal: Signal, pulses: int, channel: str | int) -> FloatArray:
    try:
        return speed_from_pulses(signal, pulses)
    except InputError as error:
        rule = error.rule
        if error.field == "pulses_per_revolution":
            raise error.with_details(field="pulses", example=arguments(pulses=1)) from None
        if error.field == "number of pulses":
            rule = said("{rule}, here {count}", rule=rule, count=error.value)
        raise InputError(
            said(
                "{what}: {rule}; give the channel with the pulses, or a part of the "
                "record that has all of them",
                what=said(error.field or "pulses"),
                rule=rule,
            ),
            field="tacho",
            value=channel,
            example=arguments(tacho=2, pulses=1),
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
        Is called with how many stretches of how many are done.

    Raises
    ------
    InputError
        If the record is too short, its rate too low for the speed, or too high for its memory.
    """
    count = part.stop - part.start
    per_turn = 2.0 * pi * source.rate / abs(nominal)
    if count < _LEAST * per_turn:  # told before anything is read
        raise InputError(
            said(
                "must be at least {least:.6g} shaft revolutions at the nominal speed, "
                "{least_2:.3g} s",
                least=_LEAST,
                least_2=_LEAST * per_turn / source.rate,
            ),
            source="track",
            field="record",
            value=manner().number(count / per_turn, ".4 rev"),
            example=arguments(speed_channel="rpm"),
        )
    stretches = _stretches(count, per_turn)
    margin = ceil(_MARGIN * per_turn)
    step = max(1, int(per_turn / _KNOTS))
    places, speeds, evidence, share = [], [], np.inf, nan
    for number, (start, end) in enumerate(stretches, start=1):
        first, last = max(0, start - margin), min(count, end + margin)
        signal = source.read(part.start + first, last - first)
        try:
            found = estimate_speed(signal, abs(nominal), tolerance=within)
        except InputError as error:
            raise _of_tracking(error) from None
        evidence = min(evidence, found.evidence)
        if not found.found:
            lost = (part.start + start) / source.rate, (part.start + end) / source.rate
            failed = found.share if found.is_off_path else nan
            return None, Tracking(nominal, within, False, evidence, lost, failed)
        share = float(np.fmin(share, found.share))
        knots = np.arange(start, end, step)
        places.append(knots.astype(np.float64))
        speeds.append(found.speed[knots - first])
        progress(number, len(stretches))
    sign = -1.0 if nominal < 0.0 else 1.0
    along = AtPlaces(np.concatenate(places), sign * np.concatenate(speeds))
    return along, Tracking(nominal, within, True, float(evidence), share=share)


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
            said(
                "holds {most} samples in memory at once, and {least:.6g} revolutions "
                "are {least_2:.0f}: give a measured speed",
                most=MOST_STRETCH_SAMPLES,
                least=2.0 * _LEAST,
                least_2=2.0 * _LEAST * per_turn,
            ),
            field="track",
            example=arguments(speed_channel="rpm"),
        )
    number = max(1, round(turns / _STRETCH))
    if count > MOST_STRETCH_SAMPLES:
        number = max(number, -(-count // room))
    ends = np.rint(np.linspace(0, count, number + 1)).astype(int).tolist()
    return list(pairwise(ends))


def _of_tracking(error: InputError) -> InputError:
    """Say in words of the task what a path of the speed lacks."""
    if error.field == "tolerance":
        return InputError(
            said("must be a fraction above 0 and at most 0.3"),
            field="within",
            value=error.value,
            example=arguments(within=0.1),
        )
    of_record = error.field in ("record", "rate")
    example = arguments(speed_channel="rpm") if of_record else error.example
    return error.with_details(source="track", example=example)
