"""The velocity of a signal over frequency, whatever quantity was measured.

Acceleration and displacement become velocity line by line of the spectrum: divided by, and times,
2πf. The density is Welch's, with Hann's window: what leaks from below a band falls with the cube of
the distance, so that a drift of the sensor, which integration would swell, does not reach it. The
signal may come in one piece or in many: segments run across the pieces, so that these give the
density of the whole signal.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import inf, sqrt
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.signal import Band, Quantity, Signal, pieces_of
from rolamento.vibration.spectrum import Spectrum, averaged_density, axis_of
from rolamento.words import said

_POWERS: Final[dict[Quantity, float]] = {
    "acceleration": -2.0, "velocity": 0.0, "displacement": 2.0
}  # fmt: skip


@frozen(eq=False)
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
    mean_squares
        (segments,) of the velocity in a band that was asked for; (m/s)², empty without one
    """

    density: Spectrum
    rate: float
    duration: float
    quantity: Quantity
    speed: float
    mean_squares: FloatArray


def velocity_of(
    signal: Signal | Iterable[Signal], resolution: float, band: Band | None = None
) -> Velocity:
    """Return the velocity of a signal.

    Parameters
    ----------
    signal
        Acceleration, velocity or displacement; in one piece, or as consecutive pieces of any
        length, of which no more than one and a segment is held at a time.
    resolution
        Distance of the lines: the segments are of one over that; Hz.
    band
        In which the mean square of each segment is wanted; Hz.

    Raises
    ------
    InputError
        If the quantity is unknown, the signal is shorter than a segment or does not change, or the
        pieces differ in rate, quantity or unit.
    """
    pieces = pieces_of(signal)
    first = next(pieces)
    if first.quantity not in _POWERS:
        raise InputError(
            said("must be velocity, acceleration or displacement"),
            field="quantity",
            value=first.quantity,
            example='quantity = "velocity"',
        )
    total = _Total(first, resolution, max(round(first.rate / resolution), 2), band)
    total.add(first)
    for piece in pieces:
        total.add(piece)
    return total.velocity()


@dataclass(slots=True, eq=False)
class _Total:
    """What pieces come to so far.

    first: of them; size: samples of a segment; waiting: samples that are in no density yet, the
    first half a segment but for the beginning; density: sum over `segments`; turned: sum of the
    speeds over all samples; squares: of the segments, in the band.
    """

    first: Signal
    resolution: float
    size: int
    band: Band | None = None
    waiting: list[FloatArray] = field(default_factory=list)
    density: FloatArray | None = None
    segments: int = 0
    samples: int = 0
    turned: float = 0.0
    least: float = inf
    most: float = -inf
    squares: list[FloatArray] = field(default_factory=list)

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
        if self.band is not None:
            self.squares.append(self._squares_of(whole, self.band))
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
            rule = said("must be at least {resolution:.6g} s", resolution=1.0 / self.resolution)
            raise InputError(rule, field="duration", value=duration, source=first.title)
        if self.least == self.most:
            raise InputError(
                said(
                    "is constant over {samples} samples: no sensor was connected, or it is "
                    "the wrong channel",
                    samples=self.samples,
                ),
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
        squares = np.concatenate(self.squares) if self.squares else np.zeros(0)
        speed = self.turned / self.samples
        return Velocity(density, first.rate, duration, first.quantity, speed, squares)

    def _squares_of(self, whole: Signal, band: Band) -> FloatArray:
        """Mean square of the velocity in a band, segment by segment."""
        from scipy.signal import spectrogram  # slow to import

        axis, _, densities = spectrogram(
            whole.samples, whole.rate, window="hann", nperseg=self.size, noverlap=self.size // 2
        )
        weights = parts_inside(axis, whole.rate / self.size, band)
        weights[1:] *= (2.0 * np.pi * axis[1:]) ** _POWERS[self.first.quantity]
        weights[0] = 0.0
        return np.asarray(weights @ densities)

    def _check(self, piece: Signal) -> None:
        for name in ("rate", "quantity", "unit"):
            value, wanted = getattr(piece, name), getattr(self.first, name)
            if value != wanted:
                rule = said("must be that of the first piece, {wanted}", wanted=wanted)
                raise InputError(rule, field=name, value=value, source=piece.title)


def rms_in(density: Spectrum, band: Band) -> float:
    """RMS of what lies in a band; lines at its edges count by their part inside."""
    inside = parts_inside(density.axis, density.resolution, band)
    return sqrt(float(np.sum(density.values * inside)))


def parts_inside(axis: FloatArray, resolution: float, band: Band) -> FloatArray:
    """Width of each line, Hz, that lies in a band; (lines,)."""
    half = 0.5 * resolution
    inside = np.minimum(axis + half, band[1]) - np.maximum(axis - half, band[0])
    return np.asarray(np.clip(inside, 0.0, None))
