"""The speed of the shaft from the pulses of a tachometer, or from the vibration itself.

A pulse is a crossing of a level that the signal reaches after it has been well on the other side:
noise about the level makes no second pulse. The instants are interpolated between samples; the
angle of the shaft, known at the pulses, is a cubic spline between them, and the speed its slope.

Where nobody measured it, the harmonics of the shaft make a ridge in the spectra of consecutive
blocks. For a candidate frequency f in a block, the evidence is

    s(f) = Σ_h ln(1 + P(h f)/P_0(h f)),   h = 1 … H,

with P the power and P_0 the noise about it: sums of many harmonics, none of which alone decides.
The path of f over the blocks with the maximum sum is found by dynamic programming (Viterbi 1967),
its steps limited by how fast the shaft can change. The signal is then tracked along the path, and
the phase that its strongest harmonic still shows corrects it (Bonnardot et al., Mechanical Systems
and Signal Processing 19 (2005), 766-785).

The tracked signal shows whether there is a shaft at all: of its lines at orders 1 … H over
the noise about them the evidence is a sum of exponential variables, and the chance that noise
gives as much is counted over all paths that were searched. That there is a shaft does not mean that
the path follows it all along: on a true path a harmonic is one line over the angle, and what lies
beside that within a quarter of an order is of where the path was lost. The share of the line is
1.00 on paths that follow a run-up, and up to 0.79 on paths that lose one.
"""

from __future__ import annotations

from dataclasses import replace
from math import ceil, exp, floor, log, nan, pi
from typing import Final, Literal

import numpy as np
import scipy

from rolamento.errors import InputError, arguments
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import number, whole_number
from rolamento.vibration.noise_floor import line_scores, log_gamma_tail
from rolamento.vibration.order_tracking import order_tracked, revolutions_of
from rolamento.vibration.signal import Signal, require_signal
from rolamento.words import manner, marked, said

Edge = Literal["rising", "falling"]
_HYSTERESIS: Final = 0.2
"""Fraction of the span of the signal; to either side of the level half of it."""
_LEAST_PULSES: Final = 4
_MOST_PER_REVOLUTION: Final = 100_000
_JUMP: Final = 1.6
"""Ratio of neighbouring intervals: a pulse too many halves one, one missed doubles it."""


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
        rule = said("must be rising or falling")
        raise InputError(rule, field="edge", value=edge, example='edge = "rising"')
    require_signal(tacho)
    samples = tacho.samples if edge == "rising" else -tacho.samples
    low, high = np.quantile(samples, (0.05, 0.95))
    if high - low == 0.0:  # pulses shorter than a twentieth of the time
        low, high = np.min(samples), np.max(samples)
    if level is None:
        middle = 0.5 * float(low + high)
    else:
        number(level, "level", example="level = 2.5")
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
    from scipy.interpolate import CubicSpline, PchipInterpolator  # slow to import

    whole_number(
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
    speed = CubicSpline(times, angle)(at, 1)
    if np.min(speed) <= 0.0:
        speed = PchipInterpolator(times, angle)(at, 1)
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
            said("must be at least {least}", least=_LEAST_PULSES),
            field=marked("number of pulses"),
            value=len(times),
            example=arguments(level=0.5, edge="falling"),
        )
    intervals = np.diff(times)
    ratio = intervals[1:] / intervals[:-1]
    wrong = np.flatnonzero((ratio > _JUMP) | (ratio < 1.0 / _JUMP))
    if len(wrong) > 0:
        raise InputError(
            said(
                "are uneven near {times:.4g} s: one is missing or extra",
                times=times[wrong[0] + 1],
            ),
            field="pulses",
            example=arguments(level=0.5, pulses_per_revolution=2),
        )


# --- from the vibration itself -------------------------------------------------------------------


_TURN: Final = 2.0 * pi
_TURNS_PER_BLOCK: Final = 24
_PADDING: Final = 4
_CLEAR: Final = 20.0
"""Power over noise at which a phase is good to a few hundredths of a revolution."""
_SHARE: Final = 0.9
"""Fraction of a clear harmonic's power on the path; below, the path has been lost."""
_CLEAR_HARMONIC: Final = 100.0
"""Power about a harmonic over the noise in a line, from which on it can be asked where it lies."""
_BESIDE: Final = 0.25
"""Fraction of an order, to either side of a harmonic: what lies there is of that harmonic."""
_ON_PATH: Final = 3
"""Lines to either side, within which it lies on the path."""
_MOST_BLOCKS: Final = 20_000
_MOST_CANDIDATES: Final = 4_000


@frozen(eq=False)
class SpeedEstimate:
    """The speed of the shaft as found in a signal.

    Attributes
    ----------
    found
        whether the shaft's harmonics stand out of noise, and lie on the path
    speed
        (samples,), rad/s; NaN if not found
    probability
        that noise alone gives as clear a path
    evidence
        -log10 of that, also where it is too small for a number
    share
        of the power about a clear harmonic that lies on the path, of the harmonic on which most
        does; NaN where none is clear
    """

    found: bool
    speed: FloatArray
    probability: float
    evidence: float
    share: float

    @property
    def is_off_path(self) -> bool:
        """Whether a harmonic is clear, and does not lie on the path."""
        return self.share < _SHARE


def estimate_speed(
    signal: Signal,
    nominal: float,
    *,
    tolerance: float = 0.1,
    harmonics: int = 8,
    agility: float = 0.02,
    false_alarm: float = 0.01,
) -> SpeedEstimate:
    """Estimate the speed of the shaft along a signal.

    Parameters
    ----------
    signal
        Of at least 96 revolutions.
    nominal
        About what the speed is; rad/s.
    tolerance
        Part by which it may be off anywhere in the record; up to 0.3, or neighbouring harmonics
        would be taken for each other.
    harmonics
        H, from 1.
    agility
        Part by which it may change within 12 revolutions.
    false_alarm
        Maximum probability at which noise is taken for a shaft.

    Raises
    ------
    InputError
        If an argument is out of range, the signal is too short or its rate too low.
    """
    frequency = number(nominal, "nominal", above=0.0, example="nominal = 188.5") / _TURN
    number(tolerance, "tolerance", above=0.0, most=0.3, example="tolerance = 0.1")
    whole_number(harmonics, "harmonics", least=1, most=100, example="harmonics = 8")
    number(agility, "agility", above=0.0, most=0.3, example="agility = 0.02")
    number(false_alarm, "false_alarm", above=0.0, most=0.5, example="false_alarm = 0.01")
    require_signal(signal)
    highest = 1.2 * harmonics * (1.0 + tolerance) * frequency
    if highest > 0.5 * signal.rate:
        raise InputError(
            said(
                "is too low for {harmonics} harmonics, which need {most:.6g} Hz",
                harmonics=harmonics,
                most=2.0 * highest,
            ),
            field="rate",
            value=signal.rate,
        )
    slow = _decimated(signal, highest)
    search = _Search.of(slow, frequency, tolerance, harmonics, agility)
    path, paths = search.path()
    speed = _TURN * search.at_samples(path)
    speed = _corrected(replace(slow, speed=speed), harmonics)
    evidence = _evidence(replace(slow, speed=speed), harmonics, paths)
    share = _share(replace(slow, speed=speed), harmonics)
    found = evidence > -log(false_alarm) and not share < _SHARE  # nor of NaN
    at = np.arange(len(signal.samples)) / signal.rate
    whole = np.interp(at, np.arange(len(speed)) / slow.rate, speed)
    return SpeedEstimate(
        found=found,
        speed=whole if found else np.full(len(whole), np.nan),
        probability=exp(-max(evidence, 0.0)),
        evidence=max(evidence, 0.0) / log(10.0),
        share=share,
    )


@frozen(eq=False)
class _Search:
    """Blocks of a signal, and the candidates for the shaft's frequency in each."""

    signal: Signal
    block: int
    candidates: FloatArray
    harmonics: int
    reach: int

    @classmethod
    def of(
        cls, signal: Signal, frequency: float, tolerance: float, harmonics: int, agility: float
    ) -> _Search:
        block = int(_TURNS_PER_BLOCK * signal.rate / frequency)
        if len(signal.samples) < 4 * block:
            raise InputError(
                said(
                    "must be at least {turns_per_block} shaft revolutions at the nominal speed",
                    turns_per_block=4 * _TURNS_PER_BLOCK,
                ),
                field="record",
                value=manner().number(signal.duration * frequency, ".3 rev"),
            )
        # half the width of a line at the highest harmonic
        step = 0.5 * signal.rate / block / harmonics
        width = 2.0 * tolerance * frequency
        count = int(width / step) + 2
        blocks = 2 * len(signal.samples) // block
        if count > _MOST_CANDIDATES or blocks > _MOST_BLOCKS:
            raise InputError(
                said(
                    "gives {blocks} blocks of {count} candidates; at most {most} of "
                    "{most_2} are allowed",
                    blocks=blocks,
                    count=count,
                    most=_MOST_BLOCKS,
                    most_2=_MOST_CANDIDATES,
                ),
                field="record",
            )
        candidates = np.linspace(frequency * (1 - tolerance), frequency * (1 + tolerance), count)
        reach = max(1, round(agility * frequency / (candidates[1] - candidates[0])))
        return cls(signal, block, candidates, harmonics, reach)

    def path(self) -> tuple[FloatArray, float]:
        """Most probable frequency of each block, and ln of how many paths there were to choose."""
        scores = self._scores()
        total = scores[0].copy()
        origin = np.zeros(scores.shape, dtype=np.int32)
        count, width = scores.shape[1], 2 * self.reach + 1
        for block in range(1, len(scores)):
            padded = np.pad(total, self.reach, constant_values=-np.inf)
            choices = np.lib.stride_tricks.sliding_window_view(padded, width)
            best = np.argmax(choices, axis=1)
            origin[block] = np.arange(count) + best - self.reach
            total = choices[np.arange(count), best] + scores[block]
        place = int(np.argmax(total))
        path = np.empty(len(scores), dtype=np.int64)
        for block in range(len(scores) - 1, -1, -1):
            path[block] = place
            place = int(origin[block, place])
        ways = log(count) + (len(scores) - 1) * log(min(width, count))
        return self.candidates[path], ways

    def at_samples(self, path: FloatArray) -> FloatArray:
        """Frequencies of the blocks' middles as a smooth curve over all samples."""
        from scipy.interpolate import PchipInterpolator  # slow to import

        count = len(self.signal.samples)
        middles = np.linspace(0, count - self.block, len(path)) + 0.5 * self.block
        smooth = path
        if len(path) >= 5:
            from scipy.signal import savgol_filter  # slow to import

            smooth = savgol_filter(path, 5, 2, mode="interp")
        curve = PchipInterpolator(middles, smooth)
        return np.asarray(curve(np.clip(np.arange(count), middles[0], middles[-1])))

    def _scores(self) -> FloatArray:
        """Evidence s of the candidates in each block; (blocks, candidates)."""
        samples, block = self.signal.samples, self.block
        blocks = max(2, 2 * len(samples) // block - 1)
        starts = np.linspace(0, len(samples) - block, blocks).astype(np.int64)
        from scipy.signal import get_window  # slow to import

        window = get_window("hann", block)
        size = scipy.fft.next_fast_len(_PADDING * block, real=True)
        resolution = self.signal.rate / size
        orders = np.arange(1, self.harmonics + 1)
        lines = np.rint(orders[:, None] * self.candidates[None] / resolution).astype(np.int64)
        found = np.empty((blocks, len(self.candidates)))
        for row, start in enumerate(starts):
            power = np.square(np.abs(scipy.fft.rfft(window * samples[start : start + block], size)))
            # the noise about a harmonic: between it and its neighbours
            reach = round(float(np.mean(self.candidates)) / resolution)
            floor = [
                np.median(power[max(1, int(near.mean()) - reach) : int(near.mean()) + reach])
                for near in lines
            ]
            ratio = power[lines] / np.maximum(np.array(floor), 1e-300)[:, None]
            found[row] = np.sum(np.log1p(ratio), axis=0)
        return found


def _decimated(signal: Signal, highest: float) -> Signal:
    """The signal without what lies above the harmonics, at a rate that just holds them."""
    factor = int(0.5 * signal.rate / (1.25 * highest))
    if factor < 2:
        return replace(signal, speed=None)
    count = len(signal.samples) // factor
    spectrum = scipy.fft.rfft(signal.samples[: count * factor])[: count // 2 + 1]
    samples = scipy.fft.irfft(spectrum, count) / factor
    return Signal(samples, signal.rate / factor)


def _corrected(signal: Signal, harmonics: int) -> FloatArray:
    """Speed with what the phase of the clearest harmonic still shows, if one is clear; rad/s."""
    assert signal.speed is not None
    per_turn = 4.0 * (harmonics + 1)
    tracked = order_tracked(signal, per_turn)
    spectrum = np.asarray(scipy.fft.fft(tracked.samples))
    clear = [_clearness(spectrum, order, tracked.revolutions) for order in range(1, harmonics + 1)]
    precision = [order**2 * ratio for order, ratio in enumerate(clear, start=1)]
    order = int(np.argmax(precision)) + 1
    if clear[order - 1] < _CLEAR:
        return signal.speed
    side = _side_band(spectrum, order, tracked.revolutions)
    # order·angle is gone, as the side band was moved to zero; revolutions per revolution
    slope = np.gradient(np.unwrap(np.angle(side)), 1.0 / per_turn) / (_TURN * order)
    # the transform joins the record's ends: what is near them is left out
    margin = min(int(_TURNS_PER_BLOCK * per_turn / 2), len(slope) // 4)
    slope[:margin], slope[-margin:] = slope[margin], slope[-margin - 1]
    places = revolutions_of(signal)
    correction = np.interp(places, np.arange(len(slope)) / per_turn, slope)
    return np.asarray(signal.speed * (1.0 + correction))


def _clearness(spectrum: ComplexArray, order: int, turns: float) -> float:
    """Power about a harmonic over that of as wide bands farther off: of both sides the greater."""
    centre, reach = round(order * turns), _reach(turns)
    power = np.square(np.abs(spectrum[centre - 5 * reach : centre + 5 * reach + 1]))
    inside = float(np.mean(power[4 * reach : 6 * reach + 1]))
    outside = max(float(np.mean(power[: 3 * reach])), float(np.mean(power[-3 * reach :])))
    return inside / outside if outside > 0.0 else 0.0


def _side_band(spectrum: ComplexArray, order: int, turns: float) -> ComplexArray:
    """What lies about a harmonic, moved to zero frequency; over the angle."""
    centre, reach = round(order * turns), _reach(turns)
    moved = np.zeros_like(spectrum)
    offsets = np.arange(-reach, reach + 1)
    moved[offsets] = spectrum[centre + offsets]
    return np.asarray(scipy.fft.ifft(moved))


def _reach(turns: float) -> int:
    """Half width of a side band: a line for each block."""
    return max(2, round(turns / _TURNS_PER_BLOCK))


def _share(signal: Signal, harmonics: int) -> float:
    """Share of a clear harmonic's power that lies on the path, of the best one; NaN without any."""
    tracked = order_tracked(signal, 4.0 * (harmonics + 1))
    turns, window = tracked.revolutions, np.hanning(len(tracked.samples))
    power = np.square(np.abs(scipy.fft.rfft(window * (tracked.samples - np.mean(tracked.samples)))))
    best = nan
    for harmonic in range(1, harmonics + 1):
        lines = np.arange(
            max(1, ceil((harmonic - _BESIDE) * turns)),
            min(len(power), floor((harmonic + _BESIDE) * turns) + 1),
        )
        level = float(np.median(power[lines])) / log(2.0)
        # of noise alone a line in twenty is higher than that
        above = np.clip(power[lines] - 3.0 * level, 0.0, None)
        total = float(np.sum(above))
        if total >= _CLEAR_HARMONIC * level > 0.0:
            on_path = float(np.sum(above[np.abs(lines - harmonic * turns) <= _ON_PATH]))
            best = float(np.fmax(best, on_path / total))
    return best


def _evidence(signal: Signal, harmonics: int, ways: float) -> float:
    """-ln of the chance that noise gives as clear lines, over all paths searched."""
    tracked = order_tracked(signal, 4.0 * (harmonics + 1))
    turns = int(tracked.revolutions)
    samples = tracked.samples[: round(turns * tracked.samples_per_revolution)]
    power = np.square(np.abs(scipy.fft.rfft(samples - np.mean(samples))))
    scores = line_scores(power[np.newaxis], averages=1)[0]
    total = float(np.nansum(scores[turns * np.arange(1, harmonics + 1)]))
    return -float(log_gamma_tail(harmonics, np.array([total]))[0]) - ways
