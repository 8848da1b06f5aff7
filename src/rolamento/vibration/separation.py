"""Discrete and random parts of a signal, separated by what repeats and what does not.

Shafts and gears repeat exactly; a bearing's impacts do not, because its balls slip. Antoni and
Randall, Mechanical Systems and Signal Processing 18 (2004), 103-117: blocks of the signal are
predicted from blocks of the same length that lie a delay before, line by line,

    H(f) = ⟨X_d* X⟩ / ⟨|X_d|²⟩,

with X and X_d the windowed transforms of a block and of the delayed one and ⟨·⟩ the mean over the
record. |H| is near 1 on a tone and near 0 in noise, of which nothing is left after the delay. What
H predicts is the discrete part, the rest the random one.

Lines whose coherence could come of noise alone are set to zero: of K independent blocks, noise
exceeds the coherence γ² with the probability (1 - γ²)^(K-1) (Carter, Knapp and Nuttall 1973).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
import scipy

from rolamento.errors import InputError
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.records import frozen
from rolamento.vibration._checks import checked_count, checked_number, require_signal
from rolamento.vibration.signal import Signal
from rolamento.words import marked, said

_OVERLAP: Final = 4
"""Blocks start a quarter of their length apart; with Hann's window they then add up to a constant,
and one of three is independent of the last."""


@frozen(eq=False)
class Separation:
    """The two parts of a signal, which add up to it.

    Attributes
    ----------
    discrete, random
        signals
    frequency
        (lines,); Hz
    gain
        (lines,), |H| as applied: 0 where noise alone would explain it
    block
        number of samples of a block
    delay
        number of samples between a block and what predicts it
    """

    discrete: Signal
    random: Signal
    frequency: FloatArray
    gain: FloatArray
    block: int
    delay: int


def separate(
    signal: Signal,
    *,
    block: int | None = None,
    delay: int | None = None,
    false_alarm: float = 0.01,
) -> Separation:
    """Separate the discrete and random parts of a signal.

    The speed should be steady, or the signal be order-tracked first.

    Parameters
    ----------
    signal
        At least as long as a delay and three blocks.
    block
        Samples of a block: one over its duration is the width of a line. By default the power of
        two next below a thirtieth of the record, and no more than 65536.
    delay
        Samples; longer than the random part remembers. By default one block.
    false_alarm
        Probability that noise leaves any line in the discrete part.

    Raises
    ------
    InputError
        If the signal is too short, or an argument out of range.
    """
    require_signal(signal)
    count = len(signal.samples)
    size = (
        _default_block(count) if block is None else _checked_samples(block, "block", 16, count // 2)
    )
    lag = size if delay is None else _checked_samples(delay, "delay", 1, count // 2)
    checked_number(false_alarm, "false_alarm", above=0.0, most=0.5, example="false_alarm = 0.01")
    if count < lag + 3 * size:
        raise InputError(
            said("must be at least {lag}, a delay and three blocks", lag=lag + 3 * size),
            field=marked("number of samples"),
            value=count,
        )
    gain = _gain_of_lines(signal.samples, size, lag, false_alarm)
    discrete = _predicted(signal.samples, size, lag, gain)
    return Separation(
        discrete=replace(signal, samples=discrete),
        random=replace(signal, samples=signal.samples - discrete),
        frequency=np.asarray(scipy.fft.rfftfreq(size, 1.0 / signal.rate)),
        gain=np.abs(gain),
        block=size,
        delay=lag,
    )


def _checked_samples(value: int, field: str, least: int, most: int) -> int:
    return checked_count(
        value, field, least=least, most=max(least, most), example=f"{field} = 8192"
    )


def _default_block(count: int) -> int:
    return int(2 ** max(4, min(16, int(np.log2(max(count / 30, 2))))))


def _window(size: int) -> FloatArray:
    from scipy.signal import get_window  # slow to import

    return np.asarray(get_window("hann", size))


def _gain_of_lines(samples: FloatArray, size: int, delay: int, false_alarm: float) -> ComplexArray:
    window = _window(size)
    starts = range(delay, len(samples) - size + 1, size // _OVERLAP)
    cross = np.zeros(size // 2 + 1, dtype=np.complex128)
    power, power_before = np.zeros(size // 2 + 1), np.zeros(size // 2 + 1)
    for start in starts:
        now = scipy.fft.rfft(window * samples[start : start + size])
        before = scipy.fft.rfft(window * samples[start - delay : start - delay + size])
        cross += np.conj(before) * now
        power += np.square(np.abs(now))
        power_before += np.square(np.abs(before))
    both = power * power_before
    coherence = np.divide(np.square(np.abs(cross)), both, out=np.zeros_like(both), where=both > 0.0)
    independent = max(2.0, (len(samples) - delay) / size)
    limit = 1.0 - (false_alarm / len(cross)) ** (1.0 / (independent - 1.0))
    gain = np.zeros_like(cross)
    np.divide(cross, power_before, out=gain, where=(power_before > 0.0) & (coherence > limit))
    return gain


def _predicted(samples: FloatArray, size: int, delay: int, gain: ComplexArray) -> FloatArray:
    """Sum of the blocks as predicted, each weighted by the window; blocks overhang both ends."""
    window = _window(size)
    overhang = size - size // _OVERLAP
    total = np.zeros(len(samples) + 2 * overhang + size)
    weight = np.zeros_like(total)
    for start in range(-overhang, len(samples), size // _OVERLAP):
        step = _predicting_block(start, len(samples), size, delay)
        if step is None:
            continue
        source = start + step
        filtered = gain if step < 0 else np.conj(gain)
        block = scipy.fft.irfft(
            filtered * scipy.fft.rfft(window * samples[source : source + size]), size
        )
        place = slice(start + overhang, start + overhang + size)
        total[place] += window * block
        weight[place] += np.square(window)
    inside = slice(overhang, overhang + len(samples))
    total, weight = total[inside], weight[inside]
    return np.divide(total, weight, out=np.zeros_like(total), where=weight > 0.1)


def _predicting_block(start: int, count: int, size: int, delay: int) -> int | None:
    """Where the block lies that predicts another: a delay before, or after it at the beginning."""
    for step in (-delay, delay):
        if 0 <= start + step <= count - size:
            return step
    return None
