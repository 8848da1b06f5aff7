"""How fast the shaft of `rolamento diagnose` turns: given, measured, or found in the vibration."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import pi
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.cli.diagnose_signal import AtSpeed
    from rolamento.cli.diagnose_tracking import Along
    from rolamento.report.diagnosis_result import ShaftSpeed, SpeedSource
    from rolamento.vibration.reading import ReadingNote, SignalFile
    from rolamento.vibration.signal import Signal

__all__ = ["AskedSpeed", "KnownSpeed", "known_speed"]

WITHIN: Final = 0.1
_EXAMPLE: Final = "--speed '1797 rpm'"
_RPM: Final = 30.0 / pi
_SAME_SPEED: Final = 1e-3
"""Part by which two statements of a speed may differ: it is not known better."""
_MOST_OFFERED: Final = 5

Rings = tuple[float | None, float | None]
Progress = Callable[[int, int], None]


@dataclass(frozen=True, slots=True)
class AskedSpeed:
    """What the options say of the speed; None where they do not.

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
    channel: str | None = None
    unit: str | None = None
    tacho: str | None = None
    pulses: int | None = None
    track: bool = False
    within: float | None = None

    def __post_init__(self) -> None:
        """Refuse options that contradict each other, or that wait for another."""
        ways = {
            "--speed-channel": self.channel is not None,
            "--tacho": self.tacho is not None,
            "--track": self.track,
        }
        chosen = [option for option, is_given in ways.items() if is_given]
        if len(chosen) > 1:
            raise InputError(
                f"is another way to the speed than {chosen[0]}: leave one of them out",
                source=chosen[1],
                example=f"{chosen[0]}, or --speed '1797 rpm' alone",
            )
        for option, value, needed, example in (
            ("--speed-unit", self.unit, "--speed-channel", "--speed-channel rpm --speed-unit rpm"),
            ("--pulses", self.pulses, "--tacho", "--tacho 2 --pulses 1"),
            ("--within", self.within, "--track", "--track --within 0.1"),
        ):
            if value is not None and not ways[needed]:
                rule = f"goes with {needed}, which is missing"
                raise InputError(rule, source=option, value=value, example=example)
        if self.measured:
            for option, speed in (("--speed", self.inner), ("--outer-speed", self.outer)):
                if speed is not None:
                    raise InputError(
                        f"is a steady speed, and {self.measured} a measured one of the ring that"
                        " turns: leave one of them out",
                        source=option,
                        value=f"{_RPM * speed:.6g} rpm",
                        example=f"{self.measured} alone",
                    )

    @property
    def measured(self) -> str:
        """The option of a speed that was measured; empty if there is none."""
        if self.channel is not None:
            return "--speed-channel"
        return "" if self.tacho is None else "--tacho"


@dataclass(frozen=True, slots=True)
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
        what a person should know where the options and the file tell different speeds
    """

    shaft: ShaftSpeed
    inner: float
    outer: float
    at: AtSpeed
    choices: tuple[ReadingNote, ...] = ()


def known_speed(
    asked: AskedSpeed, of_case: Rings, source: SignalFile, part: range, progress: Progress
) -> KnownSpeed:
    """Find out how fast the rings turn along a part of a signal.

    Parameters
    ----------
    asked
        By the options.
    of_case
        Speeds of the inner and outer ring by the case; rad/s.
    source, part
        The signal; opened with its channel of speeds, if one was asked for.
    progress
        Is told how much is done where the file has to be gone through.

    Raises
    ------
    InputError, FileError
        If no speed is known, it is 0 or comes near it, or a channel does not tell it.
    """
    if source.speed_channel is not None:
        return _of_channel(asked, of_case, source, part, progress)
    if asked.tacho is not None:
        return _of_tacho(asked, asked.tacho, of_case, source, part)
    steady = _steady(asked, of_case, source)
    if not asked.track:
        return steady
    from rolamento.cli.diagnose_tracking import found_in_vibration

    if steady.inner and steady.outer:
        raise _both_turn("--track")
    within = WITHIN if asked.within is None else asked.within
    nominal = steady.inner or steady.outer
    along, tracking = found_in_vibration(source, part, nominal, within, progress)
    if along is None:
        return replace(steady, shaft=replace(steady.shaft, tracking=tracking))
    shaft = replace(_shaft("vibration", along), tracking=tracking)
    return _measured(shaft, (steady.inner, steady.outer), _interpolated(along))


def _steady(asked: AskedSpeed, of_case: Rings, source: SignalFile) -> KnownSpeed:
    """Return the rings' speeds of the options, of the signal's file, of the case.

    What the file tells is the shaft's: the inner ring's, unless the outer one alone is given.
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
        rule = "is that of both rings: a bearing that does not turn tells nothing"
        raise InputError(rule, source="--speed", value="0 rpm", example=_EXAMPLE)
    known = _of_numbers(by, inner or 0.0, outer or 0.0)
    return replace(known, choices=_over_file(known.shaft.mean, of_file)) if by == "given" else known


def _over_file(given: float, of_file: float | None) -> tuple[ReadingNote, ...]:
    """Say that the file tells another speed than the one that was given, if it does; rad/s."""
    from rolamento.vibration.reading import ReadingNote

    if of_file is None or abs(abs(given) - abs(of_file)) <= _SAME_SPEED * abs(of_file):
        return ()
    numbers = {"speed": f"{_RPM * given:.6g} rpm", "file": f"{_RPM * of_file:.6g} rpm"}
    text = "The speed is {speed} as given; the file says {file}.".format(**numbers)
    return (ReadingNote("speed_over_file", text, numbers),)


def _missing(source: SignalFile) -> InputError:
    """Ask for the speed, and offer the numbers of the file that may be it."""
    rule, example = "is missing, and neither the file nor the case tells it", _EXAMPLE
    if source.speeds_perhaps:
        entries = [f"{name} = {value:.6g}" for name, value in source.speeds_perhaps.items()]
        name = next(iter(source.speeds_perhaps))
        rule += f"; its {', '.join(entries[:_MOST_OFFERED])} may be it, in a unit that it does not"
        rule += " say"
        example += f", or --speed-channel {name} --speed-unit Hz"
    return InputError(rule, source="--speed", example=example)


def _of_numbers(by: SpeedSource, inner: float, outer: float) -> KnownSpeed:
    import numpy as np

    from rolamento.report.diagnosis_result import ShaftSpeed

    speed = np.asarray(inner or outer)
    shaft = ShaftSpeed.steady(by, float(speed))
    return KnownSpeed(shaft, inner, outer, lambda piece, first: replace(piece, speed=speed))


def _of_channel(
    asked: AskedSpeed, of_case: Rings, source: SignalFile, part: range, progress: Progress
) -> KnownSpeed:
    """Take the speed that the signal has beside it, gone through once for its mean and range."""
    import numpy as np

    from rolamento.report.diagnosis_result import ShaftSpeed

    total, least, most = 0.0, np.inf, -np.inf
    for number, place in enumerate(part, start=1):
        speed = source.read(place, min(part.step, part.stop - place)).speed
        assert speed is not None
        total += float(np.sum(speed))
        least, most = min(least, float(np.min(speed))), max(most, float(np.max(speed)))
        progress(number, len(part))
    assert source.speed_channel is not None
    name = source.speed_channel.name or asked.channel or ""
    shaft = ShaftSpeed("channel", total / (part.stop - part.start), least, most, channel=name)
    _check_range(shaft, "--speed-channel")
    return _measured(shaft, _one_ring(of_case, "--speed-channel"), lambda piece, first: piece)


def _of_tacho(
    asked: AskedSpeed, channel: str, of_case: Rings, source: SignalFile, part: range
) -> KnownSpeed:
    from rolamento.cli.diagnose_tracking import of_tacho

    rings = _one_ring(of_case, "--tacho")
    pulses = 1 if asked.pulses is None else asked.pulses
    along, name = of_tacho(source, part, channel, pulses)
    shaft = replace(_shaft("pulses", along), channel=name, pulses=pulses)
    _check_range(shaft, "--tacho")
    return _measured(shaft, rings, _interpolated(along))


def _shaft(by: SpeedSource, along: Along) -> ShaftSpeed:
    from rolamento.report.diagnosis_result import ShaftSpeed

    speed = along.speed
    return ShaftSpeed(by, float(speed.mean()), float(speed.min()), float(speed.max()))


def _interpolated(along: Along) -> AtSpeed:
    def at(piece: Signal, first: int) -> Signal:
        return replace(piece, speed=along.at(first, len(piece.samples)))

    return at


def _measured(shaft: ShaftSpeed, rings: Rings, at: AtSpeed) -> KnownSpeed:
    """Give the ring that turns its mean speed: the inner one, unless the outer alone is told."""
    outer_turns = not rings[0] and bool(rings[1])
    inner, outer = (0.0, shaft.mean) if outer_turns else (shaft.mean, 0.0)
    return KnownSpeed(shaft, inner, outer, at)


def _one_ring(of_case: Rings, option: str) -> Rings:
    """Return the rings' speeds, of which one may turn where a speed is measured."""
    if all(of_case):
        raise _both_turn(option)
    return of_case


def _both_turn(option: str) -> InputError:
    return InputError(
        "is the speed of one ring, and both turn: the orders of the bearing would change with it",
        source=option,
        example="--set duty.outer_speed='0 rpm'",
    )


def _check_range(shaft: ShaftSpeed, option: str) -> None:
    """Refuse a speed that changes its sign or comes near 0, before anything is diagnosed."""
    import numpy as np

    from rolamento.vibration.order_tracking import revolutions_of
    from rolamento.vibration.signal import Signal

    try:
        # the rule is that of order tracking; it looks at the extremes
        revolutions_of(Signal(np.zeros(2), 1.0, speed=np.array([shaft.least, shaft.most])))
    except InputError as error:
        raise InputError(
            f"{error.rule}, with --start and --duration",
            source=option,
            value=f"{_RPM * shaft.least:.6g} to {_RPM * shaft.most:.6g} rpm",
            example="--start '2 s' --duration '10 s'",
        ) from None
