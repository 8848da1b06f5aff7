"""A channel of a signal file: what a reader offers, which one is read, and what its samples mean.

The file and the user say so together: the rate, the unit and the quantity of the samples, and the
speed of the shaft, which is a number of the file or a channel of it beside the samples.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from types import MappingProxyType
from typing import Any, Final, NamedTuple, Self

import numpy as np

from rolamento.errors import FileError, InputError, arguments, nearest, phrase, respelled
from rolamento.io.numerals import Numerals
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import number
from rolamento.vibration.reading.metadata import SAME_RATE, RateClaim, TwoWays, short_name
from rolamento.vibration.reading.units import (
    SPEED_UNITS,
    checked_scale,
    checked_speed_unit,
    checked_unit,
    is_raw,
    is_unit,
    quantity_of_unit,
    speed_unit_in,
)
from rolamento.vibration.signal import SI_UNITS, Quantity, unit_scale
from rolamento.words import Note, marked, said
from rolamento.words.sentences.reading import claimed

__all__ = [
    "MOST_CHANNELS",
    "MOST_SAMPLES",
    "Channel",
    "Meaning",
    "ShaftSpeed",
    "Source",
    "channel_beside",
    "checked_channels",
    "chosen_channel",
    "chosen_speed",
]

MOST_SAMPLES: Final = 100_000_000
"""Maximum number of samples of one channel in memory at once: 0.8 GB."""
MOST_CHANNELS: Final = 1000

_HIGHEST_RATE: Final = 1e9
_MOST_LISTED: Final = 12


@frozen
class Channel:
    """What a file says of one of its channels.

    Attributes
    ----------
    name
        as the file gives it, without the unit; may be empty
    length
        number of samples
    rate
        sampling rate, Hz; None if the file does not say, or is in doubt
    unit
        of the samples in the file; "" if the file does not say
    quantity
        that the unit belongs to, or that the file names; unknown otherwise
    speed
        of the shaft, rad/s; None if the file does not say
    rate_doubt
        the ways in which the file says its rate, if they contradict each other, or the only one if
        it may be the speed of the shaft
    rate_aside
        name and value of a number that could be the rate, and is taken for something else
    rate_two_ways
        the line of the file that says its rate, if its point may be either mark
    """

    name: str
    length: int
    rate: float | None = None
    unit: str = ""
    quantity: Quantity = "unknown"
    speed: float | None = None
    rate_doubt: tuple[RateClaim, ...] = ()
    rate_aside: tuple[str, float] | None = None
    rate_two_ways: TwoWays | None = None


class Source(ABC):
    """An open file of one format.

    Attributes
    ----------
    channels
        that the file holds, in its order
    notes
        what a person should know of how the samples were taken from the file
    numbers
        single ones that the file gives by name
    """

    channels: tuple[Channel, ...]
    notes: tuple[Note, ...] = ()
    numbers: Mapping[str, float] = MappingProxyType({})

    @abstractmethod
    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels, which are of one length and differ.

        Parameters
        ----------
        channels
            their numbers, counted from 0
        start, count
            first sample and number of samples, which lie within the length

        Returns
        -------
        FloatArray
            (channels, samples)
        """

    def close(self) -> None:  # noqa: B027 - what is held whole has nothing to close
        """Let go of the file."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def checked_channels(channels: Iterable[Channel], source: str, kind: str) -> tuple[Channel, ...]:
    """Return the channels as a tuple, if there are some and not too many.

    Raises
    ------
    FileError
        If there are none, or more than 1000.
    """
    found: list[Channel] = []
    for channel in channels:
        if len(found) == MOST_CHANNELS:
            raise FileError(
                said("has more than {most} channels", most=MOST_CHANNELS), source=source
            )
        found.append(channel)
    if not found:
        raise FileError(
            said("is a {kind} without a channel of real numbers", kind=said(kind)), source=source
        )
    return tuple(found)


class Meaning:
    """Rate, quantity and unit of the signals of a channel, and the scale of its samples.

    Attributes
    ----------
    rate
        Hz
    quantity, unit
        of the signals: SI, unless the quantity is unknown
    scale
        by which samples of the file are multiplied
    notes
        that say so, or that the samples are not calibrated
    choices
        what was taken for the rate where the file says several
    """

    def __init__(
        self,
        channel: Channel,
        rate: float | None,
        unit: str | None,
        quantity: Quantity | None,
        scale: float | str | None,
    ) -> None:
        self.rate = _rate(channel, rate)
        self.choices = _choices(channel, self.rate, is_given=rate is not None)
        before = channel.unit if unit is None else _given_unit(channel, unit)
        uncalibrated = channel.unit == "1" and scale is None and before != "1"
        if uncalibrated:
            before = "1"
        if scale is None:
            self.quantity, self.unit, self.scale = _unit(channel, before, quantity)
        else:
            if quantity is None and channel.quantity != "unknown":
                quantity = channel.quantity
            self.scale, self.quantity = checked_scale(scale, before, quantity)
            self.unit = SI_UNITS[self.quantity]
        self.notes = _notes(before, None if scale is None else self.scale, self.unit)
        if uncalibrated and unit is not None:
            self.notes += (Note("full_scale_unknown", {"unit": checked_unit(unit)}),)


def chosen_channel(channels: tuple[Channel, ...], wanted: Any) -> int:
    """Number of the chosen channel, counted from 0."""
    if wanted is None:
        if len(channels) == 1:
            return 0
        raise InputError(
            said("must be chosen, by name or number: {channels}", channels=_listed(channels)),
            field="channel",
            example=_example(channels, 0),
        )
    names = [channel.name for channel in channels]
    if isinstance(wanted, str):
        found = [number for number, name in enumerate(names) if name == wanted]
        found = found or [n for n, name in enumerate(names) if name.lower() == wanted.lower()]
        ends = tuple(f"{mark}{wanted.lower()}" for mark in "./")  # within structures and groups
        found = found or [n for n, name in enumerate(names) if name.lower().endswith(ends)]
        if len(found) == 1:
            return found[0]
        if not found and wanted.isdecimal() and len(wanted) < 6:
            wanted = int(wanted)
    whole = isinstance(wanted, int | np.integer) and not isinstance(wanted, bool)
    if whole and 1 <= wanted <= len(channels):
        return int(wanted) - 1
    near = nearest(wanted, names) if isinstance(wanted, str) else ""
    raise InputError(
        said("must be one, and only one, of {channels}", channels=_listed(channels)),
        field="channel",
        value=wanted,
        example=_example(channels, names.index(near) if near else 0),
    )


def _listed(channels: tuple[Channel, ...]) -> str:
    entries = [f"{n} {channel.name}".rstrip() for n, channel in enumerate(channels, start=1)]
    more = len(entries) - _MOST_LISTED
    listed = ", ".join(entries[:_MOST_LISTED])
    return said("{listed} and {more} more", listed=listed, more=more) if more > 0 else listed


def _example(channels: tuple[Channel, ...], number: int) -> str:
    name = channels[number].name
    return arguments(channel=name or number + 1)


def _rate(channel: Channel, given: float | None) -> float:
    """Sampling rate by the user, or else by the file if it is sure of it."""
    if given is None and channel.rate_two_ways is not None:
        name, text, line = channel.rate_two_ways
        try:
            Numerals(commas=True, doubt=text).check(name)
        except InputError as error:
            raise error.with_details(line=line) from None
    if given is None and channel.rate is None:
        rule, field = said("is not in the file; give it, in Hz"), "rate"
        if channel.rate_doubt:
            doubt = claimed(channel.rate_doubt)
            rule = said("is ambiguous: in the file {doubt}; give it, in Hz", doubt=doubt)
            field = marked("sampling rate")
        raise InputError(rule, field=field, example=arguments(rate=51200.0))
    rate = channel.rate if given is None else given
    return number(rate, "rate", above=0.0, most=_HIGHEST_RATE, example=arguments(rate=51200.0))


def _choices(channel: Channel, rate: float, *, is_given: bool) -> tuple[Note, ...]:
    """What a person should know of how the rate was chosen."""
    if is_given:
        of_file = channel.rate
        if of_file is not None and abs(of_file - rate) > SAME_RATE * of_file:
            return (Note("rate_over_file", {"rate": rate, "file": of_file}),)
        if channel.rate_doubt:
            return (
                Note(
                    "rate_over_doubt", {"rate": rate, "claims": list(map(list, channel.rate_doubt))}
                ),
            )
        return ()
    if channel.rate_aside is None:
        return ()
    name, value = channel.rate_aside
    return (Note("rate_aside", {"rate": rate, "name": name, "value": value}),)


def _unit(channel: Channel, unit: str, quantity: Quantity | None) -> tuple[Quantity, str, float]:
    """Quantity, unit and scale of the signal, by the unit of its samples."""
    of_unit = quantity_of_unit(unit)
    if quantity is None:
        of_file = "unknown" if is_raw(unit) else channel.quantity
        quantity = of_unit if of_file == "unknown" else of_file
    if quantity == "unknown":
        unit_scale(quantity, unit)
        return "unknown", unit, 1.0
    if not unit or unit == "1":
        raise InputError(
            said(
                "of the samples is not in the file; give it with the quantity {quantity}",
                quantity=quantity,
            ),
            field="unit",
            example=arguments(unit=SI_UNITS.get(quantity, "m/s^2")),
        )
    return quantity, SI_UNITS.get(quantity, unit), unit_scale(quantity, unit)


def _notes(before: str, scale: float | None, unit: str) -> tuple[Note, ...]:
    """What was done to the samples that is not plain from their unit."""
    if scale is not None:
        values = {"before": before, "scale": scale, "unit": unit}
        return (Note("samples_multiplied", values),)
    if is_raw(before):
        return (Note("samples_not_calibrated", {"unit": before}),)
    return ()


def _given_unit(channel: Channel, given: Any) -> str:
    """Unit by the user; a unit that the file gives holds against it if it is known to be one."""
    unit = checked_unit(given)
    if channel.unit not in ("1", unit) and is_unit(channel.unit):
        raise InputError(
            phrase(
                marked('contradicts the file, which says "{unit}"; leave it out, and give {scale}'),
                unit=channel.unit,
                scale=arguments(scale="100 mV/g"),
            )
            if is_raw(channel.unit)
            else said('contradicts the file, which says "{unit}"; leave it out', unit=channel.unit),
            field="unit",
            value=given,
        )
    return unit


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
                said("needs a speed_channel, and none is given"),
                field="speed_unit",
                value=unit,
                example=arguments(speed_channel="rpm"),
            )
        return ShaftSpeed(source.channels[samples].speed)
    name = _name_of_number(source, wanted)
    if name is not None:
        return _steady(source.numbers[name], name, "", unit)
    number = _number_of(source, wanted)
    channel = source.channels[number]
    if number == samples:
        rule = said("is the channel of the samples; choose that of the speed")
        raise InputError(rule, field="speed_channel", value=wanted)
    if channel.length == 1:
        return _steady(float(source.read([number], 0, 1)[0, 0]), channel.name, channel.unit, unit)
    _check_alike(source.channels[samples], channel, wanted)
    return ShaftSpeed(None, number, _speed_scale(channel.name, channel.unit, unit))


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
        rule = error.rule
        if names:
            rule = phrase(marked("{rule}; or a number: {names}"), rule=rule, names=", ".join(names))
        example = respelled(error.example, {"channel": "speed_channel"})
        raise InputError(rule, field="speed_channel", value=error.value, example=example) from None


def _steady(value: float, name: str, of_file: str, unit: Any) -> ShaftSpeed:
    if not isfinite(value):
        rule = said("is not a finite number: the file does not give the speed")
        raise FileError(rule, field=short_name(name), value=value)
    return ShaftSpeed(value * _speed_scale(name, of_file, unit))


def _check_alike(samples: Channel, speed: Channel, wanted: Any) -> None:
    """Refuse a channel of speeds that has not one for each sample."""
    if speed.length != samples.length:
        raise FileError(
            said(
                "has {length} numbers, and the channel of the samples {length_2}; they "
                "must be equal",
                length=speed.length,
                length_2=samples.length,
            ),
            field="speed_channel",
            value=wanted,
        )
    rates = (speed.rate, samples.rate)
    if None not in rates and not abs(rates[0] - rates[1]) <= SAME_RATE * rates[1]:  # type: ignore[operator]
        raise FileError(
            said(
                "is sampled at {rate:.9g} Hz, and the samples at {rate_2:.9g} Hz",
                rate=speed.rate,
                rate_2=samples.rate,
            ),
            field="speed_channel",
            value=wanted,
        )


def _speed_scale(name: str, of_file: str, given: Any) -> float:
    """Value of one unit of speed in rad/s, by the user, by the file, or by the name."""
    if is_unit(of_file) and of_file not in SPEED_UNITS:
        raise InputError(
            said("is in {of_file}, which is not a unit of speed", of_file=of_file),
            field="speed_channel",
            value=name,
        )
    known = of_file or speed_unit_in(name)
    if given is None and known in SPEED_UNITS:
        return SPEED_UNITS[known]
    if given is None:
        values = {"name": short_name(name), "units": ", ".join(SPEED_UNITS), "of_file": of_file}
        raise InputError(
            said(
                'is needed for the speed "{name}", of which the file says "{of_file}": one of'
                " {units}",
                **values,
            )
            if of_file
            else said(
                'is needed for the speed "{name}", of which the file gives none: one of {units}',
                **values,
            ),
            field="speed_unit",
            example=arguments(speed_unit="rpm"),
        )
    unit = checked_speed_unit(given)
    if of_file in SPEED_UNITS and of_file != unit:
        raise InputError(
            said('contradicts the file, which says "{unit}"; leave it out', unit=of_file),
            field="speed_unit",
            value=given,
        )
    return SPEED_UNITS[unit]
