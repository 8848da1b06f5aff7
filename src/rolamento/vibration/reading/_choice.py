"""Which channel is read, and what its samples mean, by the file and by the user together."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.errors import InputError, nearest
from rolamento.vibration._checks import checked_number
from rolamento.vibration.reading._channel import Channel
from rolamento.vibration.reading._metadata import plain_unit, quantity_of_unit
from rolamento.vibration.reading._timeline import agreed_rate
from rolamento.vibration.signal import SI_UNITS, Quantity, unit_scale

__all__ = ["Meaning", "chosen_channel"]

_HIGHEST_RATE: Final = 1e9
_MOST_LISTED: Final = 12


class Meaning:
    """Rate, quantity and unit of the signals of a channel, and the scale of its samples."""

    def __init__(
        self,
        channel: Channel,
        rate: float | None,
        unit: str | None,
        quantity: Quantity | None,
        source: str,
    ) -> None:
        self.rate = _rate(channel, rate, source)
        self.quantity, self.unit, self.scale = _unit(channel, unit, quantity)


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


def _rate(channel: Channel, given: float | None, source: str) -> float:
    """Sampling rate by the file, by the user, or by both if they agree."""
    if given is not None:
        checked_number(given, "rate", above=0.0, most=_HIGHEST_RATE, example="rate=51200.0")
    rate = agreed_rate(channel.rate, given, source)
    if rate is None:
        raise InputError(
            "is not in the file and is to be given, in Hz", field="rate", example="rate=51200.0"
        )
    return checked_number(
        float(rate), "rate", above=0.0, most=_HIGHEST_RATE, example="rate=51200.0"
    )


def _unit(
    channel: Channel, given: str | None, quantity: Quantity | None
) -> tuple[Quantity, str, float]:
    """Quantity, unit and scale of the signal, by the file and by the user."""
    unit = channel.unit if given is None else _given_unit(channel, given)
    of_unit = quantity_of_unit(unit)
    if quantity is None:
        quantity = of_unit if channel.quantity == "unknown" else channel.quantity
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


def _given_unit(channel: Channel, given: Any) -> str:
    if not isinstance(given, str):
        raise InputError("must be text", field="unit", value=given, example='unit="g"')
    unit = plain_unit(given)
    if channel.unit not in ("", "1", unit):
        raise InputError(
            f'contradicts the file, which says "{channel.unit}"; leave it out',
            field="unit",
            value=given,
        )
    return unit
