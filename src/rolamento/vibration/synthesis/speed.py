"""How fast the shaft turns over a signal: steady, swinging, wandering, or as given.

A profile gives the shaft's speed at evenly spaced times; the angle follows by the trapezoidal
rule. The shaft turns one way throughout, for whatever depends on its angle.
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import check_count, number
from rolamento.vibration.signal import real_numbers
from rolamento.words import said

_MOST_SPEED: Final = 1e6
_MOST_POINTS: Final = 1_000_000
_TURN: Final = 2.0 * np.pi


@frozen
class SteadySpeed:
    """One speed throughout; rad/s."""

    speed: float


@frozen
class SwingingSpeed:
    """A mean and a sine: mean (1 + depth sin(2π frequency t + phase)).

    mean rad/s, depth a part of it, frequency Hz, phase rad.
    """

    mean: float
    depth: float
    frequency: float
    phase: float = 0.0


@frozen
class WanderingSpeed:
    """A random walk that is drawn back to its mean: an Ornstein-Uhlenbeck process.

    mean rad/s; deviation the standard deviation as a part of it; memory the time over which the
    speed forgets where it was (s).
    """

    mean: float
    deviation: float
    memory: float


@frozen(eq=False)
class GivenSpeed:
    """Speeds at times, straight between them and level beyond; arrays, s and rad/s."""

    times: FloatArray
    speeds: FloatArray


SpeedProfile: TypeAlias = SteadySpeed | SwingingSpeed | WanderingSpeed | GivenSpeed


def speeds_of(
    profile: SpeedProfile, count: int, rate: float, random: np.random.Generator
) -> FloatArray:
    """Return the shaft's speed at every sample.

    Parameters
    ----------
    profile
        One of the profiles.
    count, rate
        Samples, and samples per second.
    random
        Moves what wanders.

    Returns
    -------
    Array (), of a steady speed, or (count,); rad/s.

    Raises
    ------
    InputError
        If a number is out of range, or the shaft stops or turns back.
    """
    if isinstance(profile, SteadySpeed):
        speeds = np.asarray(profile.speed, dtype=np.float64)
    elif isinstance(profile, SwingingSpeed):
        speeds = _swinging(profile, np.arange(count) / rate)
    elif isinstance(profile, WanderingSpeed):
        speeds = _wandering(profile, count, rate, random)
    else:
        speeds = _given(profile, np.arange(count) / rate)
    least, most = float(np.min(speeds)), float(np.max(speeds))
    if not max(abs(least), abs(most)) <= _MOST_SPEED:
        raise InputError(
            said("must be finite numbers up to {most:.6g} rad/s", most=_MOST_SPEED),
            field="speed",
            example="188.5",
        )
    if least <= 0.0 <= most:
        raise InputError(
            said("must not stop or reverse"),
            field="speed",
            value=least,
            example="188.5",
        )
    return speeds


def angle_of(speeds: FloatArray, count: int, rate: float) -> FloatArray:
    """Return the shaft's angle at every sample (count,), from 0 on; rad."""
    if speeds.ndim == 0:
        return np.arange(count, dtype=np.float64) * (float(speeds) / rate)
    steps = 0.5 / rate * (speeds[1:] + speeds[:-1])
    return np.concatenate(([0.0], np.cumsum(steps)))


def _swinging(profile: SwingingSpeed, time: FloatArray) -> FloatArray:
    number(profile.depth, "depth", least=0.0, most=0.9, example="depth = 0.05")
    number(
        profile.frequency, "frequency", least=0.0, most=1e6, unit="Hz", example="frequency = 0.5"
    )
    swing = np.sin(_TURN * profile.frequency * time + profile.phase)
    return np.asarray(profile.mean * (1.0 + profile.depth * swing))


def _wandering(
    profile: WanderingSpeed, count: int, rate: float, random: np.random.Generator
) -> FloatArray:
    """Walk on a coarse grid, ten steps in the memory, and go straight between."""
    number(profile.deviation, "deviation", least=0.0, most=0.2, example="deviation = 0.01")
    number(profile.memory, "memory", least=1e-3, most=1e6, unit="s", example="memory = 0.5")
    step = profile.memory / 10.0
    points = int(count / rate / step) + 2
    if points > _MOST_POINTS:
        raise InputError(
            said(
                "gives more than {most} steps of a wandering speed; lengthen it, or "
                "shorten the duration",
                most=_MOST_POINTS,
            ),
            field="memory",
            value=profile.memory,
            example="memory = 0.5",
        )
    kept = np.exp(-0.1)
    pushes = np.sqrt(1.0 - kept**2) * random.standard_normal(points)
    place, walk = float(random.standard_normal()), np.empty(points)
    for index, push in enumerate(pushes.tolist()):
        walk[index] = place
        place = kept * place + push
    wander = np.interp(np.arange(count) / rate, step * np.arange(points), walk)
    return np.asarray(profile.mean * (1.0 + profile.deviation * wander))


def _given(profile: GivenSpeed, time: FloatArray) -> FloatArray:
    times = real_numbers(profile.times, "times", "times = [0.0, 10.0]")
    speeds = real_numbers(profile.speeds, "speeds", "speeds = [100.0, 200.0]")
    check_count("times", times.size, _MOST_POINTS)
    if times.ndim != 1 or times.shape != speeds.shape or not times.size:
        raise InputError(
            said("must be two rows of equal length"),
            field="times",
            example="times = [0.0, 10.0], speeds = [100.0, 200.0]",
        )
    if not (np.all(np.isfinite(times)) and np.all(np.diff(times) > 0.0)):
        raise InputError(
            said("must be finite and increasing"), field="times", example="times = [0.0, 10.0]"
        )
    return np.interp(time, times, speeds)
