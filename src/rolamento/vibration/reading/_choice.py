"""Which channel is read, and what its samples mean, by the file and by the user together."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.errors import InputError, nearest
from rolamento.vibration._checks import checked_number
from rolamento.vibration.reading._channel import Channel, ReadingNote
from rolamento.vibration.reading._scale import checked_scale
from rolamento.vibration.reading._timeline import SAME_RATE
from rolamento.vibration.reading._units import checked_unit, is_raw, is_unit, quantity_of_unit
from rolamento.vibration.signal import SI_UNITS, Quantity, unit_scale

__all__ = ["Meaning", "chosen_channel"]

_HIGHEST_RATE: Final = 1e9
_MOST_LISTED: Final = 12


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
        if scale is None:
            self.quantity, self.unit, self.scale = _unit(channel, before, quantity)
        else:
            if quantity is None and channel.quantity != "unknown":
                quantity = channel.quantity
            self.scale, self.quantity = checked_scale(scale, before, quantity)
            self.unit = SI_UNITS[self.quantity]
        self.notes = _notes(before, None if scale is None else self.scale, self.unit)


def chosen_channel(channels: tuple[Channel, ...], wanted: Any) -> int:
    """Number of the channel that is wanted, counted from 0."""
    if wanted is None:
        if len(channels) == 1:
            return 0
        raise InputError(
            f"is to be chosen, by name or number: {_listed(channels)}",
            field="channel",
            example=_example(channels, 0),
        )
    names = [channel.name for channel in channels]
    if isinstance(wanted, str):
        found = [number for number, name in enumerate(names) if name == wanted]
        found = found or [n for n, name in enumerate(names) if name.lower() == wanted.lower()]
        if len(found) == 1:
            return found[0]
        if not found and wanted.isdecimal() and len(wanted) < 6:
            wanted = int(wanted)
    whole = isinstance(wanted, int | np.integer) and not isinstance(wanted, bool)
    if whole and 1 <= wanted <= len(channels):
        return int(wanted) - 1
    near = nearest(wanted, names) if isinstance(wanted, str) else ""
    raise InputError(
        f"is not one of, or one and only one of: {_listed(channels)}",
        field="channel",
        value=wanted,
        example=_example(channels, names.index(near) if near else 0),
    )


def _listed(channels: tuple[Channel, ...]) -> str:
    entries = [f"{n} {channel.name}".rstrip() for n, channel in enumerate(channels, start=1)]
    more = len(entries) - _MOST_LISTED
    return ", ".join(entries[:_MOST_LISTED]) + (f" and {more} more" if more > 0 else "")


def _example(channels: tuple[Channel, ...], number: int) -> str:
    name = channels[number].name
    return f'channel="{name}"' if name else f"channel={number + 1}"


def _rate(channel: Channel, given: float | None) -> float:
    """Sampling rate by the user, or else by the file if it is sure of it."""
    if given is None and channel.rate is None:
        doubt = channel.rate_doubt
        rule = (
            f"is in doubt: in the file {doubt}; give it" if doubt else "is not in the file and is"
        )
        rule += ", in Hz" if doubt else " to be given, in Hz"
        raise InputError(rule, field="rate", example="rate=51200.0")
    rate = channel.rate if given is None else given
    return checked_number(rate, "rate", above=0.0, most=_HIGHEST_RATE, example="rate=51200.0")


def _choices(channel: Channel, rate: float, *, is_given: bool) -> tuple[ReadingNote, ...]:
    """What a person should know of how the rate was chosen."""
    hertz = f"{rate:.9g} Hz"
    if is_given:
        of_file = channel.rate
        if of_file is not None and abs(of_file - rate) > SAME_RATE * of_file:
            text = f"The sampling rate is {hertz} as given; the file says {of_file:.9g} Hz."
            numbers = {"rate": hertz, "file": f"{of_file:.9g} Hz"}
            return (ReadingNote("rate_over_file", text, numbers),)
        if channel.rate_doubt:
            text = f"The sampling rate is {hertz} as given; in the file {channel.rate_doubt}."
            numbers = {"rate": hertz, "doubt": channel.rate_doubt}
            return (ReadingNote("rate_over_doubt", text, numbers),)
        return ()
    if channel.rate_aside is None:
        return ()
    name, value = channel.rate_aside
    text = f"The sampling rate is {hertz}; {name} = {value:.9g} of the file is not taken for one."
    numbers = {"rate": hertz, "name": name, "value": f"{value:.9g}"}
    return (ReadingNote("rate_aside", text, numbers),)


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
            f"of the samples is not in the file; give it with the quantity {quantity}",
            field="unit",
            example=f'unit="{SI_UNITS.get(quantity, "m/s^2")}"',
        )
    return quantity, SI_UNITS.get(quantity, unit), unit_scale(quantity, unit)


def _notes(before: str, scale: float | None, unit: str) -> tuple[str, ...]:
    """What was done to the samples that is not plain from their unit."""
    if scale is not None:
        return (f"samples{f' in {before}' if before else ''} are multiplied by {scale:.6g} {unit}",)
    if is_raw(before):
        return (f"samples in {before} are not calibrated: no sensitivity was given",)
    return ()


def _given_unit(channel: Channel, given: Any) -> str:
    """Unit by the user; a unit that the file gives holds against it if it is known to be one."""
    unit = checked_unit(given)
    if channel.unit not in ("1", unit) and is_unit(channel.unit):
        instead = (
            'leave it out, and give scale="100 mV/g"' if is_raw(channel.unit) else "leave it out"
        )
        raise InputError(
            f'contradicts the file, which says "{channel.unit}"; {instead}',
            field="unit",
            value=given,
        )
    return unit
