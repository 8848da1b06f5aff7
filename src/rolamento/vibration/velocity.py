"""Power density of a velocity, of a signal in one piece or in many.

Acceleration and displacement become velocity line by line of the spectrum: divided by, and times,
2πf. Welch's segments run across the pieces, so that these give the density of the whole signal.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import inf
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration.signal import Quantity, Signal
from rolamento.vibration.spectrum import Spectrum, averaged_density, axis_of

__all__ = ["Velocity", "velocity_of"]

_POWERS: Final[dict[Quantity, float]] = {
    "acceleration": -2.0, "velocity": 0.0, "displacement": 2.0
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Velocity:
    """The velocity of a signal, over frequency.

    Attributes
    ----------
    density
        averaged power density, (m/s)²/Hz, 0 at zero frequency; over Hz
    rate
        of the samples; Hz
    duration
        of the signal; s
    quantity
        that was measured
    speed
        mean of the shaft's; rad/s, NaN if it is not known
    """

    density: Spectrum
    rate: float
    duration: float
    quantity: Quantity
    speed: float


def velocity_of(signal: Signal | Iterable[Signal], resolution: float) -> Velocity:
    """Return the velocity of a signal.

    Parameters
    ----------
    signal
        Acceleration, velocity or displacement; in one piece, or as consecutive pieces of any
        length, of which no more than one and a segment is held at a time.
    resolution
        Distance of the lines: the segments are of one over that; Hz.

    Raises
    ------
    InputError
        If the quantity is unknown, the signal is shorter than a segment or does not change, or the
        pieces differ in rate, quantity or unit.
    """
    pieces = iter([signal] if isinstance(signal, Signal) else signal)
    first = next(pieces, None)
    if first is None:
        raise InputError("holds no samples", field="signal")
    if first.quantity not in _POWERS:
        raise InputError(
            "must be velocity, acceleration or displacement",
            field="quantity",
            value=first.quantity,
            example='quantity = "velocity"',
        )
    total = _Total(first, resolution, max(round(first.rate / resolution), 2))
    total.add(first)
    for piece in pieces:
        total.add(piece)
    return total.velocity()


@dataclass(slots=True, eq=False)
class _Total:
    """What pieces come to so far.

    first: of them; size: samples of a segment; waiting: samples that are in no density yet, the
    first half a segment but for the beginning; density: sum over `segments`; turned: sum of the
    speeds over all samples.
    """

    first: Signal
    resolution: float
    size: int
    waiting: list[FloatArray] = field(default_factory=list)
    density: FloatArray | None = None
    segments: int = 0
    samples: int = 0
    turned: float = 0.0
    least: float = inf
    most: float = -inf

    def add(self, piece: Signal) -> None:
        """Take a piece into account."""
        self._check(piece)
        self.samples += len(piece.samples)
        self.turned += len(piece.samples) * piece.mean_speed
        self.least = min(self.least, float(np.min(piece.samples)))
        self.most = max(self.most, float(np.max(piece.samples)))
        self.waiting.append(piece.in_si.samples)
        overlap = self.size // 2
        hop = self.size - overlap
        segments = (sum(map(len, self.waiting)) - overlap) // hop
        if segments < 1:
            return
        held = self.waiting[0] if len(self.waiting) == 1 else np.concatenate(self.waiting)
        whole = Signal(held[: overlap + segments * hop], self.first.rate)
        density = segments * averaged_density(whole, self.first.rate / self.size).values
        self.density = density if self.density is None else self.density + density
        self.segments += segments
        self.waiting = [held[segments * hop :].copy()]

    def velocity(self) -> Velocity:
        """Return what all pieces come to.

        Raises
        ------
        InputError
            If they are shorter than a segment, or do not change.
        """
        first, duration = self.first, self.samples / self.first.rate
        if self.density is None:
            rule = f"must be at least {1.0 / self.resolution:g} s"
            raise InputError(rule, field="duration", value=duration, source=first.title)
        if self.least == self.most:
            raise InputError(
                f"does not change over {self.samples} samples: no sensor was there, or it is the"
                " wrong channel",
                field="signal",
                value=self.least,
                source=first.title,
            )
        resolution = first.rate / self.size
        axis = axis_of(len(self.density), resolution)
        values = np.zeros(len(axis))
        values[1:] = self.density[1:] / self.segments
        values[1:] *= (2.0 * np.pi * axis[1:]) ** _POWERS[first.quantity]
        density = Spectrum(axis, values, "Hz", "(m/s)^2/Hz", resolution, self.segments)
        return Velocity(density, first.rate, duration, first.quantity, self.turned / self.samples)

    def _check(self, piece: Signal) -> None:
        for name in ("rate", "quantity", "unit"):
            value, wanted = getattr(piece, name), getattr(self.first, name)
            if value != wanted:
                rule = f"must be that of the first piece, {wanted}"
                raise InputError(rule, field=name, value=value, source=piece.title)
