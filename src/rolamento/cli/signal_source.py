"""The file of a signal that a command reads, and what its options say of it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from rolamento.cli.quantities import number_given
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.vibration.reading import SignalFile

__all__ = ["SignalChoice", "choice_of", "in_options", "opened"]

_OPTIONS: Final = {
    name: f"--{name.replace('_', '-')}"
    for name in (
        *("channel", "rate", "unit", "scale", "start", "duration"),
        *("speed_channel", "speed_unit", "decimal_mark"),
    )
}
_ARGUMENT: Final = re.compile(rf'\b({"|".join(_OPTIONS)})=("[^"]*"|[\d.]+)')


@dataclass(frozen=True, slots=True)
class SignalChoice:
    """Which part of a file is the signal, and what the file does not tell of it.

    Attributes
    ----------
    channel
        name, or number from 1 on
    rate
        of sampling; Hz
    unit, scale
        of the samples, and sensitivity of the sensor
    start, duration
        of the part; s
    decimal_mark
        point or comma, of a table of text
    """

    channel: str | None = None
    rate: float | None = None
    unit: str | None = None
    scale: str | None = None
    start: float = 0.0
    duration: float | None = None
    decimal_mark: str | None = None


def choice_of(
    channel: str | None,
    rate: str | None,
    unit: str | None,
    scale: str | None,
    start: str | None,
    duration: str | None,
    decimal_mark: str | None = None,
) -> SignalChoice:
    """Return what the options of these names say.

    Raises
    ------
    InputError
        If a rate or a time is none.
    """
    return SignalChoice(
        channel=channel,
        rate=number_given(rate, "--rate", "frequency", "--rate '50 kHz'"),
        unit=unit,
        scale=scale,
        start=number_given(start, "--start", "time", "--start '2 s'") or 0.0,
        duration=number_given(duration, "--duration", "time", "--duration '10 s'"),
        decimal_mark=decimal_mark,
    )


def opened(
    path: str,
    choice: SignalChoice,
    *,
    part: bool = True,
    speed_channel: str | None = None,
    speed_unit: str | None = None,
) -> SignalFile:
    """Open the file of a signal; what is wrong is told in the words of the options.

    Parameters
    ----------
    path
        Of the file.
    choice
        What the options say.
    part
        Whether only the part that is chosen is wanted, or all of the signal.
    speed_channel, speed_unit
        A channel with the shaft's speed, if there is one.

    Raises
    ------
    FileError, InputError
        If it cannot be read, or does not tell what the options have to.
    """
    from rolamento.vibration.reading import open_signal

    try:
        return open_signal(
            path,
            channel=choice.channel,
            rate=choice.rate,
            unit=choice.unit,
            scale=choice.scale,
            speed_channel=speed_channel,
            speed_unit=speed_unit,
            decimal_mark=choice.decimal_mark,
            start=choice.start if part else 0.0,
            duration=choice.duration if part else None,
        )
    except InputError as error:
        raise in_options(error) from None


def in_options(error: InputError, names: Mapping[str, str] | None = None) -> InputError:
    """Return an error about a signal's file in words of the command.

    names: options of fields that are called otherwise than the field.
    """
    options = {**_OPTIONS, **(names or {})}

    def option(match: re.Match[str]) -> str:
        value = match[2].strip('"') if match[1] == "decimal_mark" else match[2]
        return f"{options[match[1]]} {value}"

    return type(error)(
        _ARGUMENT.sub(option, error.rule),
        field=options.get(error.field, error.field),
        value=error.value,
        example=_ARGUMENT.sub(option, error.example),
        source=error.source,
        line=error.line,
    )
