"""A channel of a signal file, and what a reader of one format has to offer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Self

from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._limits import MOST_CHANNELS
from rolamento.vibration.signal import Quantity

__all__ = ["Channel", "ReadingNote", "Source", "checked_channels"]


@dataclass(frozen=True, slots=True)
class ReadingNote:
    """What was taken for what of two numbers that differ.

    Attributes
    ----------
    name
        for a program
    text
        a sentence for a person
    numbers
        in the sentence, by name, as text with their units
    """

    name: str
    text: str
    numbers: Mapping[str, str] = field(default_factory=dict, hash=False)


@dataclass(frozen=True, slots=True)
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
        the ways in which the file says its rate, if they contradict each other
    rate_aside
        name and value of a number that could be the rate, and is taken for something else
    """

    name: str
    length: int
    rate: float | None = None
    unit: str = ""
    quantity: Quantity = "unknown"
    speed: float | None = None
    rate_doubt: str = ""
    rate_aside: tuple[str, float] | None = None


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
    notes: tuple[str, ...] = ()
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
            raise FileError(f"holds more than {MOST_CHANNELS} channels", source=source)
        found.append(channel)
    if not found:
        raise FileError(f"is a {kind} without a channel of real numbers", source=source)
    return tuple(found)
