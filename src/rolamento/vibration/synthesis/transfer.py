"""From an impact to the sensor: resonances that ring, and a path that weakens with the angle.

A mode of natural frequency f and damping ζ answers an impact of strength A at time t_k with

    A g exp(-ζ ω τ) sin(ω √(1 - ζ²) τ),    τ = t - t_k > 0,  ω = 2π f

(McFadden and Smith 1984). The sum over all impacts is the recursion y_n = r y_{n-1} + c_n with
r = exp(λ/rate), λ = ω (-ζ + i √(1 - ζ²)), whose imaginary part is the answer; an impact between
two samples enters at the next, as far turned and decayed as it is by then.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import ComplexArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.validate import check_count, number
from rolamento.vibration.signal import real_numbers
from rolamento.words import said

_TURN: Final = 2.0 * np.pi
_MOST_GAINS: Final = 3600
_NOTHING: Final = 40.0
"""Decay in nepers that leaves nothing in double precision."""
_WORTH: Final = 20
"""Answers that overlap at a sample on the mean, up to which adding them up is the faster way."""


@frozen
class Mode:
    """A resonance between bearing and sensor.

    Attributes
    ----------
    frequency
        natural frequency (Hz)
    damping
        part ζ of the critical damping
    gain
        acceleration (m/s²) at which it begins to ring after an impact of strength 1
    """

    frequency: float
    damping: float = 0.03
    gain: float = 1.0

    def __post_init__(self) -> None:
        number(
            self.frequency,
            "frequency",
            least=1e-3,
            most=1e8,
            unit="Hz",
            example="frequency = 3500.0",
        )
        number(self.damping, "damping", least=1e-5, most=0.9, example="damping = 0.03")
        number(self.gain, "gain", least=-1e9, most=1e9, unit="m/s²", example="gain = 10.0")


DEFAULT_MODES: Final = (Mode(3500.0, 0.03, 10.0),)
"""One resonance, in the range where housings of small motors have theirs; an assumption."""


@frozen
class TransferPath:
    """How much of an impact reaches the sensor, by the angle between them.

    Attributes
    ----------
    sensor_azimuth
        ψ of the sensor (rad), 0 at +z
    far_gain
        gain of an impact on the side away from the sensor; in between, it goes with the cosine.
        1 for a path that does not depend on the angle
    gains
        instead, gains at equal steps of the angle from the sensor, once around; straight between
    """

    sensor_azimuth: float = 0.0
    far_gain: float = 0.3
    gains: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        number(
            self.sensor_azimuth,
            "sensor_azimuth",
            least=-1e3,
            most=1e3,
            example="sensor_azimuth = 0.0",
        )
        number(self.far_gain, "far_gain", least=0.0, most=1.0, example="far_gain = 0.3")
        check_count("gains", len(self.gains), _MOST_GAINS)
        for gain in self.gains:
            number(gain, "gains", least=0.0, most=1e6, example="gains = (1.0, 0.5, 0.3, 0.5)")

    def at(self, azimuth: ArrayLike) -> FloatArray:
        """Gain of impacts at azimuths (rad); the shape of the azimuths."""
        angle = real_numbers(azimuth, "azimuth", "azimuth = [0.0, 1.57]") - self.sensor_azimuth
        if self.gains:
            steps = np.arange(len(self.gains)) * (_TURN / len(self.gains))
            return np.asarray(np.interp(angle, steps, self.gains, period=_TURN))
        return np.asarray(self.far_gain + (1.0 - self.far_gain) * 0.5 * (1.0 + np.cos(angle)))


def ringing(
    times: FloatArray, strengths: FloatArray, modes: Sequence[Mode], count: int, rate: float
) -> FloatArray:
    """Sum of the answers of all modes to all impacts; (count,), m/s².

    Parameters
    ----------
    times, strengths
        Of the impacts (impacts,), s and dimensionless; those outside the samples are left out.
    modes
        Below half the rate.
    count, rate
        Samples, and samples per second.

    Raises
    ------
    InputError
        If a mode is not below half the rate.
    """
    check_modes(modes, rate)
    first = np.ceil(times * rate)
    inside = (first >= 0.0) & (first < count)
    if not np.any(inside):
        return np.zeros(count)
    place = first[inside].astype(np.intp)
    delay = place / rate - times[inside]
    total = np.zeros(count)
    for mode in modes:
        root = _TURN * mode.frequency * (-mode.damping + 1j * sqrt(1.0 - mode.damping**2))
        entering = mode.gain * strengths[inside] * np.exp(root * delay)
        lasts = min(count, int(_NOTHING * rate / -root.real) + 1)
        answer = summed if place.size * lasts < _WORTH * count else recursion
        total += answer(place, entering, root / rate, lasts, count)
    return total


def modulated_in_frequency(
    cycles: FloatArray, modes: Sequence[Mode], rate: float, index: float, strength: float
) -> FloatArray:
    """Modes that ring on at a level, their frequencies swinging with the passages; m/s².

    The signal that Braga and Almeida (section 6) suppose: A sin(2π f t + index sin(2π n(t))) with
    n the passages so far. Impacts do not make it; it shows what an envelope makes of it.

    Parameters
    ----------
    cycles
        n at every sample (count,).
    modes, rate
        As of `ringing`.
    index
        Of the modulation (rad).
    strength
        Times the gains.
    """
    check_modes(modes, rate)
    time = np.arange(cycles.size) / rate
    swing = index * np.sin(_TURN * np.mod(cycles, 1.0))
    total = np.zeros(cycles.size)
    for mode in modes:
        total += strength * mode.gain * np.sin(_TURN * mode.frequency * time + swing)
    return total


def check_modes(modes: Sequence[Mode], rate: float) -> None:
    """Refuse modes that the samples cannot show."""
    check_count("modes", len(modes), 100)
    for mode in modes:
        if mode.frequency >= 0.5 * rate:
            raise InputError(
                said("must be below half the sampling rate, {rate:.6g} Hz", rate=0.5 * rate),
                field="modes.frequency",
                value=mode.frequency,
                example="rate = 51200.0",
            )


def fast_length(count: int) -> int:
    """Return the least number from count on whose only prime factors are 2, 3 and 5."""
    best = 1 << max(count - 1, 0).bit_length()
    five = 1
    while five < best:
        three = five
        while three < best:
            rest = -(-count // three)
            best = min(best, three * (1 << max(rest - 1, 0).bit_length()))
            three *= 3
        five *= 5
    return best


def summed(
    place: IntArray, entering: ComplexArray, root: complex, lasts: int, count: int
) -> FloatArray:
    """Answers of one mode, added impact by impact.

    Parameters
    ----------
    place
        Sample at which each impact enters (impacts,).
    entering
        What it is by then (impacts,).
    root
        λ/rate.
    lasts
        Samples until nothing is left of an answer.
    count
        Samples.
    """
    answer = np.exp(root * np.arange(lasts))
    cosine, sine = answer.real.copy(), answer.imag.copy()
    total = np.zeros(count + lasts)
    for first, real, imag in zip(
        place.tolist(), entering.real.tolist(), entering.imag.tolist(), strict=True
    ):
        total[first : first + lasts] += real * sine + imag * cosine
    return total[:count]


def recursion(
    place: IntArray, entering: ComplexArray, root: complex, lasts: int, count: int
) -> FloatArray:
    """The same as `summed`, as the recursion y_n = r y_{n-1} + c_n from rest, r = exp(root).

    The Fourier transform solves it on a ring, where the end runs on into the beginning; what it
    brings there is r^(n+1) y_end, and is taken away again. It takes as long for many impacts as
    for one.
    """
    length = fast_length(count)
    pushes = np.empty(length, dtype=np.complex128)
    pushes.real = np.bincount(place, entering.real, length)
    pushes.imag = np.bincount(place, entering.imag, length)
    turns = np.exp(-1j * _TURN / length * np.arange(length))
    around = np.fft.ifft(np.fft.fft(pushes) / (1.0 - np.exp(root) * turns))
    found = around.imag[:count].copy()
    found[:lasts] -= (around[-1] * np.exp(root * np.arange(1, lasts + 1))).imag
    return found
