"""A signal, in one piece or many, cut into blocks of the same number of shaft revolutions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import pi
from typing import Final

import numpy as np
from scipy import fft

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration.order_tracking import revolutions_of, turns_per_sample
from rolamento.vibration.signal import Signal

__all__ = ["MOST_SAMPLES", "Block", "blocks_of"]

MOST_SAMPLES: Final = 2**21
"""Of a block: keeps the memory of slow shafts bounded."""
_LEAST_SAMPLES: Final = 1024
_STEADY: Final = 1e-12


@dataclass(frozen=True, slots=True, eq=False)
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
            raise InputError("must be at least 2", field="number of samples", value=1)
        if _steady(pieces):
            samples = len(pieces.samples)
            turns = (samples - 1) * turns_per_sample(pieces)
            length = _good_length(samples // _count(turns, samples, wanted))
            yield from _steady_blocks([pieces], length)
        else:
            yield from _varying_blocks([pieces], _turns_of_block(revolutions_of(pieces), wanted))
        return
    first, pieces = _peeked(pieces)
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
                "must have the same rate, and all one steady speed or all a speed per sample",
                field="pieces of a signal",
            )
        yield piece


def _peeked(pieces: Iterable[Signal]) -> tuple[Signal, Iterable[Signal]]:
    iterator = iter(pieces)
    first = next(iterator, None)
    if first is None:
        raise InputError("holds no samples", field="signal")

    def again() -> Iterator[Signal]:
        yield first
        yield from iterator

    return first, again()


def _steady(signal: Signal) -> bool:
    return signal.speed is None or signal.speed.ndim == 0


def _good_length(samples: int) -> int:
    """A length up to the given one that is a product of small primes, for fast transforms."""
    if samples < _LEAST_SAMPLES:
        return samples
    step = max(1, samples // 500)
    for length in range(samples, samples - step, -1):
        if fft.next_fast_len(length, real=True) == length:
            return length
    return samples
