"""The signal and the bearing of `rolamento diagnose`, from what its options say."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, islice
from math import isfinite
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.bearing import Bearing
    from rolamento.vibration.reading import SignalFile
    from rolamento.vibration.signal import Signal

__all__ = [
    "PIECE",
    "GivenBearing",
    "Streamed",
    "bearing_of",
    "part_of",
    "speed_given",
    "streamed",
    "to_number",
]

PIECE: Final = 2**20
"""Samples that are read at a time."""
_WHOLE: Final = 8
"""Pieces up to which a signal is taken as one."""
_RPM_EXAMPLE: Final = "--speed '1797 rpm'"
_MOST: Final = 1e12


@dataclass(frozen=True, slots=True)
class GivenBearing:
    """A bearing by its designation or of a case file; speeds in rad/s, None if not given."""

    name: str
    bearing: Bearing
    inner_speed: float | None
    outer_speed: float | None


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
        """Of what was read so far; s."""
        return self.samples / self.first.rate


def bearing_of(text: str) -> GivenBearing:
    """Return the bearing of a designation or a case file.

    Raises
    ------
    InputError, FileError
        If there is no such bearing, or the file is no case.
    """
    import rolamento

    if not text.lower().endswith((".toml", ".json")) and not _is_file(text):
        try:
            return GivenBearing(text, rolamento.Bearing.named(text), None, None)
        except InputError as error:
            raise error.with_details(source="--bearing") from None
    case = rolamento.load_case(text)
    speeds = (case.duty.inner_speed or None, case.duty.outer_speed or None)
    return GivenBearing(case.title or text, case.bearing, *speeds)


def speed_given(text: str | None, option: str) -> float | None:
    """Return a speed that an option gives; rad/s.

    Raises
    ------
    InputError
        If it is none.
    """
    if text is None:
        return None
    from rolamento.units import to_si

    try:
        return to_si(text, "angular_speed")
    except InputError as error:
        raise error.with_details(source=option, example=_RPM_EXAMPLE) from None


def to_number(text: str | None, option: str, units: dict[str, float], example: str) -> float | None:
    """Return a number that may have one of some units; None if it is not given.

    Raises
    ------
    InputError
        If it is none, or negative.
    """
    if text is None:
        return None
    number, _, unit = text.strip().partition(" ")
    unit = unit.strip()
    if not unit:
        cut = len(number.rstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"))
        number, unit = number[:cut], number[cut:]
    try:
        value = float(number) * units.get(unit, float("nan"))
    except ValueError:
        value = float("nan")
    if not (isfinite(value) and 0.0 <= value <= _MOST):
        names = ", ".join(name for name in units if name)
        rule = f"must be a number from 0 on, alone or in {names}"
        raise InputError(rule, source=option, value=text, example=example)
    return value


def part_of(file: SignalFile, start: float, duration: float | None) -> range:
    """Return the samples of a part of a file, as a range in steps of `PIECE`; start, duration in s.

    Raises
    ------
    InputError
        If the part does not lie within the file.
    """
    known = f"{file.duration:.6g} s"
    first = round(start * file.rate)
    if first >= file.length:
        rule = f"must lie before the end of the signal, {known}"
        raise InputError(rule, source="--start", value=f"{start:g} s", example="--start '2 s'")
    count = file.length - first
    if duration is not None:
        # a part of a sample more is no more than rounding
        if not 1 <= round(duration * file.rate) <= count + 1:
            rule = f"must be over 0 and end within the signal, which lasts {known}"
            example = "--duration '10 s'"
            raise InputError(rule, source="--duration", value=f"{duration:g} s", example=example)
        count = min(round(duration * file.rate), count)
    return range(first, first + count, PIECE)


def streamed(pieces: Iterable[Signal], speed: float, read: Callable[[int], None]) -> Streamed:
    """Take a signal as one if it is short, and piece by piece if it is long.

    Parameters
    ----------
    pieces
        Consecutive parts, each read when it is asked for; at least one.
    speed
        Of the shaft; rad/s.
    read
        Is told how many samples were read, as they are read.
    """
    source = (_at_speed(piece, speed) for piece in pieces)
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


def _at_speed(piece: Signal, speed: float) -> Signal:
    import numpy as np

    return replace(piece, speed=np.asarray(speed))


def _joined(pieces: list[Signal]) -> Signal:
    import numpy as np

    if len(pieces) == 1:
        return pieces[0]
    return replace(pieces[0], samples=np.concatenate([piece.samples for piece in pieces]))


def _is_file(text: str) -> bool:
    try:
        return os.path.isfile(text)
    except ValueError:
        return False
