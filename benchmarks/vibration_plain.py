"""What a user would write instead with NumPy and SciPy, band by band and filter by filter.

Nothing here is shared with the engine. There is no word on how sure a finding is, and nothing is
left out: shafts, gears and what they modulate would be taken for damage.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import signal
from scipy.interpolate import make_interp_spline

Floats = NDArray[np.float64]
Numbers = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a bearing: strikes per revolution, and the spacing of sidebands, 0 for none."""

    name: str
    order: float
    spacing: float


@dataclass(frozen=True, slots=True)
class Match:
    """Lines that fit a part best: mean power over the noise about it, and the order found."""

    score: float
    part: str
    order: float


def diagnose(
    samples: Floats,
    rate: float,
    speed: Floats,
    parts: Sequence[Part],
    divisions: Sequence[int],
    slip: float,
) -> Match:
    """Look for lines of parts in the squared envelopes of bands: all of equal width, by divisions.

    speed: of the shaft, rad/s; () or (samples,). slip: by which an order may be off.
    """
    turns = turned(speed, rate, len(samples))
    best = Match(0.0, "", np.nan)
    for division in divisions:
        width = 0.5 * rate / division
        for number in range(division):
            part_of_it = filtered(samples, rate, number * width, (number + 1) * width)
            squared = np.abs(signal.hilbert(part_of_it)) ** 2
            if speed.ndim:
                squared = np.interp(np.linspace(0.0, turns[-1], len(turns)), turns, squared)
            power = np.abs(np.fft.rfft(squared - squared.mean())) ** 2
            for part in parts:
                match = matched(power, float(turns[-1]), part, slip)
                best = max(best, match, key=lambda some: some.score)
    return best


def turned(speed: Floats, rate: float, count: int) -> Floats:
    """Revolutions of the shaft until each sample."""
    if speed.ndim == 0:
        return np.arange(count) * (float(speed) / (2.0 * np.pi * rate))
    steps = 0.5 * (speed[1:] + speed[:-1]) / (2.0 * np.pi * rate)
    return np.asarray(np.concatenate([[0.0], np.cumsum(steps)]), dtype=np.float64)


def filtered(samples: Floats, rate: float, low: float, high: float) -> Floats:
    """A band, without delay."""
    below, above = low > 0.0, high < 0.499 * rate
    if not below and not above:
        return samples
    if below and above:
        sections = signal.butter(4, [low, high], "bandpass", fs=rate, output="sos")
    else:
        edge, kind = (low, "highpass") if below else (high, "lowpass")
        sections = signal.butter(4, edge, kind, fs=rate, output="sos")
    return np.asarray(signal.sosfiltfilt(sections, samples))


def matched(power: Floats, turns: float, part: Part, slip: float) -> Match:
    """Best of all orders that slip allows: three multiples, with a sideband on either side."""
    low, high = part.order * (1.0 - slip) * turns, part.order * (1.0 + slip) * turns
    grid = np.arange(low, high, 1.0 / 3.0)
    scores = np.zeros(len(grid))
    sidebands = (-1, 0, 1) if part.spacing else (0,)
    for multiple in (1, 2, 3):
        for sideband in sidebands:
            places = np.rint(multiple * grid + sideband * part.spacing * turns).astype(int)
            about = power[max(1, places[0] - 100) : places[-1] + 100]
            scores += power[places] / np.median(about)
    best = int(np.argmax(scores))
    mean = float(scores[best]) / (3 * len(sidebands))
    return Match(mean, part.name, float(grid[best]) / turns)


def kurtogram_of_stft(
    samples: Floats, rate: float, levels: int, overlap: float
) -> dict[int, Floats]:
    """Spectral kurtosis by short-time transforms, of as many bands as the fast kurtogram has."""
    found = {}
    for level in range(1, levels + 1):
        for bands in (2**level, 3 * 2 ** (level - 1)):
            window = 2 * bands
            _, _, lines = signal.stft(
                samples,
                rate,
                nperseg=window,
                noverlap=int(overlap * window),
                boundary=None,
                padded=False,
            )
            power = np.abs(lines) ** 2
            found[bands] = np.mean(power**2, axis=1) / np.mean(power, axis=1) ** 2 - 2.0
    return found


def kurtogram_of_filters(samples: Floats, levels: int) -> dict[int, Floats]:
    """The filter bank of the fast kurtogram, one filter after the other."""
    halves = quasi_analytic(2, 16, 0.2)
    thirds = quasi_analytic(3, 24, 0.2 / 1.5)
    bands: list[Numbers] = [signal.hilbert(samples - samples.mean())]
    found = {}
    for _ in range(levels):
        split = [part for band in bands for part in parts_of(band, thirds)]
        bands = [part for band in bands for part in parts_of(band, halves)]
        for some in (bands, split):
            found[len(some)] = np.array([kurtosis(band) for band in some])
    return found


def quasi_analytic(parts: int, order: int, cutoff: float) -> list[Numbers]:
    """Filters of equal parts of a band."""
    low = signal.firwin(order + 1, cutoff, fs=1.0)
    turns = np.arange(order + 1)
    return [
        low * np.exp(2j * np.pi * (2 * part + 1) / (4 * parts) * turns) for part in range(parts)
    ]


def parts_of(band: Numbers, filters: Sequence[Numbers]) -> list[Numbers]:
    """A band through each filter and decimated, without the run-in; odd ones turned upside up."""
    step, found = len(filters), []
    for number, taps in enumerate(filters):
        part = signal.upfirdn(taps, band, down=step)[-(-len(taps) // step) : len(band) // step]
        if number % 2:
            part[1::2] *= -1.0
        found.append(part)
    return found


def kurtosis(band: Numbers) -> float:
    """Of a complex envelope, less that of noise."""
    power = np.abs(band - band.mean()) ** 2
    return float(np.mean(power**2) / np.mean(power) ** 2 - 2.0)


def over_angle(samples: Floats, turns: Floats, per_turn: float) -> Floats:
    """A signal at even steps of the shaft's angle, by splines of the fifth degree."""
    steps = np.arange(int(turns[-1] * per_turn) + 1) / per_turn
    places = np.arange(len(samples), dtype=np.float64)
    spline = make_interp_spline(places, samples, k=5)
    return np.asarray(spline(np.interp(steps, turns, places)))


def coherence(samples: Floats, rate: float, modulation: float, window: int, step: int) -> Floats:
    """Coherence of carriers one modulation apart, from zero to half the rate; (carriers,)."""
    time = np.arange(len(samples)) / rate
    moved = samples * np.exp(2j * np.pi * modulation * time)
    how: dict[str, Any] = {
        "fs": rate,
        "nperseg": window,
        "noverlap": window - step,
        "detrend": False,
        "return_onesided": False,
    }
    _, cross = signal.csd(moved, samples, **how)
    _, upper = signal.welch(samples, **how)
    _, lower = signal.welch(moved, **how)
    return np.asarray(np.abs(cross) / np.sqrt(upper * lower))[: window // 2]


# --- as a script: of a 6205 at a steady speed, from an archive of NumPy -----------------------


PARTS_OF_6205 = (
    Part("outer_race", 3.585, 0.0),
    Part("inner_race", 5.415, 1.0),
    Part("ball", 4.713, 0.3983),
    Part("cage", 0.3983, 0.0),
)


def main(path: str, picture: str | None = None) -> None:
    """Diagnose a file and print it; with a picture of the envelope's spectrum and a kurtogram."""
    with np.load(path) as file:
        samples, rate = file["acceleration"], float(file["fs"])
        speed = file["rpm"] * (np.pi / 30.0)
    match = diagnose(samples, rate, speed, PARTS_OF_6205, (1, 2, 3, 4, 6, 8), 0.02)
    print(f"{match.part} at order {match.order:.4f}, score {match.score:.1f}")
    if picture is None:
        return
    import matplotlib.pyplot as plt

    figure, (above, below) = plt.subplots(2)
    squared = np.abs(signal.hilbert(samples)) ** 2
    lines = np.abs(np.fft.rfft(squared - squared.mean()))
    above.plot(np.fft.rfftfreq(len(samples), 1.0 / rate)[:20_000], lines[:20_000])
    levels = kurtogram_of_stft(samples, rate, 8, 0.75)
    below.imshow([np.interp(np.arange(512), np.arange(len(k)) * 512 / len(k), k)
                  for k in levels.values()], aspect="auto")  # fmt: skip
    figure.savefig(Path(picture))


if __name__ == "__main__":
    main(*sys.argv[1:])
