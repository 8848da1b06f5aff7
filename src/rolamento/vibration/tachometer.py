"""The speed of the shaft from the pulses of a tachometer or keyphasor.

A pulse is a crossing of a level that the signal reaches after it has been well on the other side:
noise about the level makes no second pulse. The instants are interpolated between samples; the
angle of the shaft, known at the pulses, is a cubic spline between them, and the speed its slope.
"""

from __future__ import annotations

from math import pi
from typing import Final, Literal

import numpy as np
from scipy import interpolate

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import checked_count, checked_number
from rolamento.vibration.signal import Signal

__all__ = ["pulse_times", "speed_from_pulses"]

Edge = Literal["rising", "falling"]

_HYSTERESIS: Final = 0.2
"""Of the span of the signal; to either side of the level half of it."""
_LEAST_PULSES: Final = 4
_MOST_PER_REVOLUTION: Final = 100_000
_JUMP: Final = 1.6
"""Of neighbouring intervals: a pulse too many halves one, one missed doubles it."""


def pulse_times(tacho: Signal, level: float | None = None, edge: Edge = "rising") -> FloatArray:
    """Instants at which a signal crosses a level; (pulses,), s from the first sample.

    Parameters
    ----------
    tacho
        The channel with the pulses.
    level
        In its unit; by default midway between the lowest and the highest twentieth of the samples.
    edge
        "rising" or "falling".

    Raises
    ------
    InputError
        If the edge is unknown or the level is not finite.
    """
    if edge not in ("rising", "falling"):
        rule = "must be rising or falling"
        raise InputError(rule, field="edge", value=edge, example='edge = "rising"')
    samples = tacho.samples if edge == "rising" else -tacho.samples
    low, high = np.quantile(samples, (0.05, 0.95))
    if high - low == 0.0:  # pulses shorter than a twentieth of the time
        low, high = np.min(samples), np.max(samples)
    if level is None:
        middle = 0.5 * float(low + high)
    else:
        checked_number(level, "level", example="level = 2.5")
        middle = level if edge == "rising" else -level
    margin = 0.5 * _HYSTERESIS * float(high - low)
    return _crossings(samples, middle, margin) / tacho.rate


def speed_from_pulses(
    tacho: Signal,
    pulses_per_revolution: int = 1,
    *,
    level: float | None = None,
    edge: Edge = "rising",
) -> FloatArray:
    """Speed of the shaft at every sample of a tachometer channel.

    Before the first and after the last pulse the speed of the nearest interval holds on.

    Parameters
    ----------
    tacho, level, edge
        As `pulse_times`.
    pulses_per_revolution
        Of the shaft.

    Returns
    -------
    (samples,); rad/s.

    Raises
    ------
    InputError
        If there are fewer than four pulses, or one is missing or too many.
    """
    checked_count(
        pulses_per_revolution,
        "pulses_per_revolution",
        least=1,
        most=_MOST_PER_REVOLUTION,
        example="pulses_per_revolution = 1",
    )
    times = pulse_times(tacho, level, edge)
    _check_pulses(times)
    angle = np.arange(len(times)) * (2.0 * pi / pulses_per_revolution)
    at = np.clip(np.arange(len(tacho.samples)) / tacho.rate, times[0], times[-1])
    speed = interpolate.CubicSpline(times, angle)(at, 1)
    if np.min(speed) <= 0.0:
        speed = interpolate.PchipInterpolator(times, angle)(at, 1)
    first, last = np.diff(angle)[0] / np.diff(times)[[0, -1]]
    # a little inside the ends, where the slope of the spline is least sure
    speed = np.where(at <= times[1], first, np.where(at >= times[-2], last, speed))
    return np.asarray(speed)


def _crossings(samples: FloatArray, level: float, margin: float) -> FloatArray:
    """Places between samples where the signal rises through a level, having been below it."""
    side = np.zeros(len(samples), dtype=np.int8)
    side[samples > level + margin] = 1
    side[samples < level - margin] = -1
    clear = np.flatnonzero(side)
    rises = np.flatnonzero((side[clear][1:] == 1) & (side[clear][:-1] == -1))
    places = []
    for start, end in zip(clear[rises], clear[rises + 1], strict=True):
        stretch = samples[start : end + 1] - level
        before = int(np.flatnonzero(stretch <= 0.0)[-1])
        drop, rise = float(stretch[before]), float(stretch[before + 1])
        places.append(start + before - drop / (rise - drop))
    return np.array(places, dtype=np.float64)


def _check_pulses(times: FloatArray) -> None:
    if len(times) < _LEAST_PULSES:
        raise InputError(
            f"must be at least {_LEAST_PULSES}; check the level and the edge",
            field="number of pulses",
            value=len(times),
        )
    intervals = np.diff(times)
    ratio = intervals[1:] / intervals[:-1]
    wrong = np.flatnonzero((ratio > _JUMP) | (ratio < 1.0 / _JUMP))
    if len(wrong) > 0:
        raise InputError(
            f"are uneven near {times[wrong[0] + 1]:.4g} s: one is missing or one too many; check "
            "the level and the number per revolution",
            field="pulses",
        )
