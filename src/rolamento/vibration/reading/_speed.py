"""The speed of the shaft: a number of the file, or a channel of it beside the samples."""

from __future__ import annotations

from math import isfinite
from typing import Any, Final, NamedTuple

from rolamento.errors import FileError, InputError
from rolamento.vibration.reading._channel import Channel, Source
from rolamento.vibration.reading._choice import chosen_channel
from rolamento.vibration.reading._metadata import short_name
from rolamento.vibration.reading._timeline import SAME_RATE
from rolamento.vibration.reading._units import (
    SPEED_UNITS,
    checked_speed_unit,
    is_unit,
    speed_unit_in,
)

__all__ = ["ShaftSpeed", "channel_beside", "chosen_speed"]

_MOST_LISTED: Final = 12
_EXAMPLE: Final = 'speed_unit="rpm"'


class ShaftSpeed(NamedTuple):
    """Where the speed of the shaft comes from.

    Attributes
    ----------
    value
        rad/s, if it is one number; None if it is not known or a channel
    channel
        number of the channel of speeds, counted from 0; None if there is none
    scale
        rad/s in one unit of the channel
    """

    value: float | None = None
    channel: int | None = None
    scale: float = 1.0


def chosen_speed(source: Source, samples: int, wanted: Any, unit: Any) -> ShaftSpeed:
    """Return the speed of the shaft that goes with a channel.

    Parameters
    ----------
    source
        the open file
    samples
        number of the channel of the signal, counted from 0
    wanted
        name of a channel or of a single number, or number of a channel counted from 1; None for
        what the file says by itself
    unit
        of the speed; None for that of the file, or with which the name ends

    Raises
    ------
    InputError
        If there is no such channel or number, or its unit is not known.
    FileError
        If the channels are not of one length and rate, or the number is not finite.
    """
    if wanted is None:
        if unit is not None:
            raise InputError(
                "is that of a speed_channel, and none is given",
                field="speed_unit",
                value=unit,
                example='speed_channel="rpm"',
            )
        return ShaftSpeed(source.channels[samples].speed)
    name = _name_of_number(source, wanted)
    if name is not None:
        return _steady(source.numbers[name], name, "", unit)
    number = _number_of(source, wanted)
    channel = source.channels[number]
    if number == samples:
        rule = "is the channel of the samples; choose that of the speed"
        raise InputError(rule, field="speed_channel", value=wanted)
    if channel.length == 1:
        return _steady(float(source.read([number], 0, 1)[0, 0]), channel.name, channel.unit, unit)
    _check_alike(source.channels[samples], channel, wanted)
    return ShaftSpeed(None, number, _scale(channel.name, channel.unit, unit))


def channel_beside(source: Source, wanted: Any) -> int | None:
    """Number of the one channel that is not that of the speed; None if there are more, or none.

    Raises
    ------
    InputError
        If there are two, and neither is that of the speed.
    """
    if wanted is None or len(source.channels) != 2 or _name_of_number(source, wanted) is not None:
        return None
    return 1 - _number_of(source, wanted)


def _name_of_number(source: Source, wanted: Any) -> str | None:
    """Name of a single number of the file, if no channel has that name."""
    if not isinstance(wanted, str):
        return None
    if any(channel.name.lower() == wanted.lower() for channel in source.channels):
        return None
    if wanted in source.numbers:
        return wanted
    found = [name for name in source.numbers if name.lower() == wanted.lower()]
    return found[0] if len(found) == 1 else None


def _number_of(source: Source, wanted: Any) -> int:
    """Number of the channel of speeds; the complaint names the single numbers too."""
    try:
        return chosen_channel(source.channels, wanted)
    except InputError as error:
        names = [short_name(name) for name in list(source.numbers)[:_MOST_LISTED]]
        more = f"; or a number: {', '.join(names)}" if names else ""
        example = error.example.replace("channel=", "speed_channel=", 1)
        raise InputError(
            error.rule + more, field="speed_channel", value=error.value, example=example
        ) from None


def _steady(value: float, name: str, of_file: str, unit: Any) -> ShaftSpeed:
    if not isfinite(value):
        rule = "is not a finite number: the file does not tell the speed"
        raise FileError(rule, field=short_name(name), value=value)
    return ShaftSpeed(value * _scale(name, of_file, unit))


def _check_alike(samples: Channel, speed: Channel, wanted: Any) -> None:
    """Refuse a channel of speeds that has not one for each sample."""
    if speed.length != samples.length:
        raise FileError(
            f"has {speed.length} numbers, and the channel of the samples {samples.length}; "
            "they have to be as many",
            field="speed_channel",
            value=wanted,
        )
    rates = (speed.rate, samples.rate)
    if None not in rates and not abs(rates[0] - rates[1]) <= SAME_RATE * rates[1]:  # type: ignore[operator]
        raise FileError(
            f"is sampled at {speed.rate:.9g} Hz, and the samples at {samples.rate:.9g} Hz",
            field="speed_channel",
            value=wanted,
        )


def _scale(name: str, of_file: str, given: Any) -> float:
    """Value of one unit of speed in rad/s, by the user, by the file, or by the name."""
    if is_unit(of_file) and of_file not in SPEED_UNITS:
        raise InputError(
            f"is in {of_file}, which is no unit of a speed", field="speed_channel", value=name
        )
    known = of_file or speed_unit_in(name)
    if given is None and known in SPEED_UNITS:
        return SPEED_UNITS[known]
    if given is None:
        says = f'the file says "{of_file}"' if of_file else "the file does not say it"
        raise InputError(
            f'of the speed "{short_name(name)}" is to be given, {says}: '
            f"one of {', '.join(SPEED_UNITS)}",
            field="speed_unit",
            example=_EXAMPLE,
        )
    unit = checked_speed_unit(given)
    if of_file in SPEED_UNITS and of_file != unit:
        raise InputError(
            f'contradicts the file, which says "{of_file}"; leave it out',
            field="speed_unit",
            value=given,
        )
    return SPEED_UNITS[unit]
