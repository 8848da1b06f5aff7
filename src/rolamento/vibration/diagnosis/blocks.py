"""A signal, in one piece or many, cut into blocks of the same number of shaft revolutions.

Noise statistics do not apply to stretches that do not change, and to copies of the record.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain
from math import pi
from typing import Final

import numpy as np
import scipy

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration._checks import pieces_of
from rolamento.vibration.diagnosis.lines import runs
from rolamento.vibration.order_tracking import revolutions_of, turns_per_sample
from rolamento.vibration.signal import Signal
from rolamento.words import marked, said

MOST_SAMPLES: Final = 2**21
"""Maximum number of samples of a block: keeps the memory of slow shafts bounded."""
_LEAST_SAMPLES: Final = 1024
_STEADY: Final = 1e-12


@frozen(eq=False)
class Block:
    """Samples over a number of revolutions.

    Attributes
    ----------
    samples
        (samples,)
    rate
        Hz
    turns
        revolutions of the shaft that the block spans
    places
        (samples,), revolutions since the block's beginning over `turns`, from 0 to 1; None if the
        shaft turns steadily
    """

    samples: FloatArray
    rate: float
    turns: float
    places: FloatArray | None


def blocks_of(pieces: Signal | Iterable[Signal], wanted: float) -> Iterator[Block]:
    """Cut pieces that follow each other into blocks of equal revolutions.

    A signal in one piece is cut into as many blocks of equal length as come nearest to what is
    wanted, and of pieces of unknown number the last, incomplete block is left out unless it is the
    only one.

    Parameters
    ----------
    pieces
        One signal, or consecutive parts of one, all with the shaft's speed and the same rate.
    wanted
        Revolutions in a block.

    Raises
    ------
    InputError
        If there are no samples, the speed is missing, or pieces do not belong together.
    """
    if isinstance(pieces, Signal):
        if len(pieces.samples) < 2:
            raise InputError(said("must be at least 2"), field=marked("number of samples"), value=1)
        if _steady(pieces):
            samples = len(pieces.samples)
            turns = (samples - 1) * turns_per_sample(pieces)
            length = _good_length(samples // _count(turns, samples, wanted))
            yield from _steady_blocks([pieces], length)
        else:
            yield from _varying_blocks([pieces], _turns_of_block(revolutions_of(pieces), wanted))
        return
    rest = pieces_of(pieces)
    first = next(rest)
    pieces = chain([first], rest)
    if _steady(first):
        samples = int(min(wanted / turns_per_sample(first), MOST_SAMPLES))
        yield from _steady_blocks(pieces, _good_length(samples))
    else:
        turns = min(wanted, MOST_SAMPLES * turns_per_sample(first))
        yield from _varying_blocks(pieces, turns)


def _count(turns: float, samples: int, wanted: float) -> int:
    """Into how many blocks a record in one piece is cut."""
    return max(1, round(turns / wanted), -(-samples // MOST_SAMPLES))


def _turns_of_block(angle: FloatArray, wanted: float) -> float:
    """Revolutions of each block of a record in one piece whose shaft changes its speed."""
    samples, total = len(angle), float(angle[-1])
    count = _count(total, samples, wanted)
    if count == 1:
        return float(angle[_good_length(samples) - 1]) * (1.0 + _STEADY)
    return total / count * (1.0 - _STEADY)


def _steady_blocks(pieces: Iterable[Signal], samples: int) -> Iterator[Block]:
    left = np.zeros(0)
    rate = turns = 0.0
    found = 0
    for piece in _alike(pieces, steady=True):
        rate, turns = piece.rate, turns_per_sample(piece)
        left = np.concatenate([left, piece.samples]) if len(left) else piece.samples
        while len(left) >= samples:
            yield Block(left[:samples], rate, samples * turns, None)
            left = left[samples:]
            found += 1
        left = left.copy()
    if found == 0 and len(left) > 0:
        short = left[: _good_length(len(left))]
        yield Block(short, rate, len(short) * turns, None)


def _varying_blocks(pieces: Iterable[Signal], turns: float) -> Iterator[Block]:
    left, angle = np.zeros(0), np.zeros(0)
    rate, found = 0.0, 0
    for piece in _alike(pieces, steady=False):
        rate = piece.rate
        assert piece.speed is not None
        start = angle[-1] + abs(float(piece.speed[0])) / (2.0 * pi * rate) if len(angle) else 0.0
        left = np.concatenate([left, piece.samples])
        angle = np.concatenate([angle, start + revolutions_of(piece)])
        begin = number = 0
        while angle[-1] >= (number + 1) * turns:
            end = begin + int(np.searchsorted(angle[begin:], (number + 1) * turns))
            yield Block(left[begin:end], rate, turns, angle[begin:end] / turns - number)
            begin, number = end, number + 1
        left, angle = left[begin:].copy(), angle[begin:] - number * turns
        found += number
    if found == 0 and len(left) > 1:
        yield Block(left, rate, float(angle[-1]), angle / angle[-1])


def _alike(pieces: Iterable[Signal], *, steady: bool) -> Iterator[Signal]:
    first: Signal | None = None
    for piece in pieces:
        first = piece if first is None else first
        same_speed = not steady or (_steady(piece) and piece.mean_speed == first.mean_speed)
        if piece.rate != first.rate or not same_speed or (not steady and _steady(piece)):
            raise InputError(
                said("must have the same rate, and all a steady speed or all a speed per sample"),
                field=marked("pieces of a signal"),
            )
        yield piece


def _steady(signal: Signal) -> bool:
    return signal.speed is None or signal.speed.ndim == 0


def _good_length(samples: int) -> int:
    """A length up to the given one that is a product of small primes, for fast transforms."""
    if samples < _LEAST_SAMPLES:
        return samples
    step = max(1, samples // 500)
    for length in range(samples, samples - step, -1):
        if scipy.fft.next_fast_len(length, real=True) == length:
            return length
    return samples


# --- what noise statistics do not apply to -------------------------------------------------------


_BEGINNING: Final = 64
"""Samples that noise does not give twice."""
_GAP: Final = 8
"""Equal samples that follow each other, from which on they are a gap."""
MOST_GAPS: Final = 20
"""That a record may have: more may well be periodic."""


class Watch:
    """Looks at a record block by block.

    Attributes
    ----------
    still
        blocks that hardly change
    repeats_after
        samples after which the record begins anew, one by one the same; None if it does not
    gaps
        runs of samples that only repeat the one before, in blocks that do change
    """

    def __init__(self) -> None:
        self.still = 0
        self.gaps = 0
        self.repeats_after: int | None = None
        self._beginning: FloatArray | None = None
        self._read = 0

    def usable(self, samples: FloatArray) -> bool:
        """Look at the next samples; return whether there is anything in them."""
        if self.repeats_after is None:
            self._look_for_beginning(samples)
        self._read += len(samples)
        still = _still(samples)
        self.still += still
        if not still:
            self.gaps += _gaps(samples)
        return not still

    def _look_for_beginning(self, samples: FloatArray) -> None:
        first = self._beginning is None
        if self._beginning is None:
            self._beginning = samples[:_BEGINNING].copy()
        # the beginning itself is no copy
        again = _place_of(self._beginning, samples[1:] if first else samples)
        if again is not None:
            self.repeats_after = self._read + first + again


def _gaps(samples: FloatArray) -> int:
    """How often so many samples follow each other that are equal."""
    starts, ends = runs(np.diff(samples) == 0.0)
    return int(np.count_nonzero(ends - starts >= _GAP))


def _still(samples: FloatArray) -> bool:
    """Whether most samples only repeat the one before: silence, steps, a sensor that hangs."""
    return 2 * int(np.count_nonzero(np.diff(samples))) < len(samples) - 1


def _place_of(sequence: FloatArray, samples: FloatArray) -> int | None:
    """Where a sequence that changes comes in samples; None if nowhere."""
    count = len(sequence)
    if len(samples) < count or np.ptp(sequence) == 0.0:
        return None
    places = np.flatnonzero(samples[: len(samples) - count + 1] == sequence[0])
    for step in range(1, count):
        if len(places) == 0:
            return None
        places = places[samples[places + step] == sequence[step]]
    return int(places[0]) if len(places) else None
