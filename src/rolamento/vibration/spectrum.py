"""Spectra of a signal: the record, amplitude spectrum and power density.

One-sided throughout. With X_k the discrete Fourier transform of N samples,

    amplitude  A_k = (2/N) |X_k|           a sine of amplitude A gives A on its line
    density    S_k = (2/(f_s N)) |X_k|²    Σ S_k f_s/N = mean square (Parseval)

where the factor 2 is left out at zero and at half the sampling rate. The averaged density is
Welch's (1967), with Hann's window.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from scipy import fft
from scipy import signal as scipy_signal

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration._checks import Band, checked_number, require_samples
from rolamento.vibration.signal import Signal

__all__ = [
    "EDGE",
    "Spectrum",
    "amplitude_spectrum",
    "averaged_density",
    "axis_of",
    "bins_of_band",
    "one_sided_amplitudes",
    "power_density",
]


@dataclass(frozen=True, slots=True, eq=False)
class Spectrum:
    """A one-sided spectrum on evenly spaced lines.

    Attributes
    ----------
    axis
        (lines,), from 0: Hz, or orders of the shaft
    values
        (lines,), in `unit`
    axis_unit
        "Hz" or "order"
    unit
        of the values
    resolution
        distance of the lines, in `axis_unit`
    averages
        how many independent spectra were averaged
    """

    axis: FloatArray
    values: FloatArray
    axis_unit: Literal["Hz", "order"]
    unit: str
    resolution: float
    averages: int = 1


EDGE: Final = 1e-6
"""Of the distance of the lines: one that is so little outside a band lies on its edge. Of 2²⁸
samples, rounding moves a line by 10⁻⁷."""
_LEAST: Final = 2


def amplitude_spectrum(signal: Signal) -> Spectrum:
    """Amplitudes of the lines of a signal, in its unit, over Hz.

    Raises
    ------
    InputError
        If there are fewer than two samples.
    """
    require_samples(signal, _LEAST, "a spectrum")
    count = len(signal.samples)
    amplitudes = one_sided_amplitudes(signal.samples)
    return Spectrum(
        axis=axis_of(len(amplitudes), signal.rate / count),
        values=amplitudes,
        axis_unit="Hz",
        unit=signal.unit,
        resolution=signal.rate / count,
    )


def power_density(signal: Signal) -> Spectrum:
    """Power over frequency of a signal, unit²/Hz; its sum times the resolution is the mean square.

    Raises
    ------
    InputError
        If there are fewer than two samples.
    """
    require_samples(signal, _LEAST, "a spectrum")
    count = len(signal.samples)
    power = np.square(np.abs(fft.rfft(signal.samples))) / (signal.rate * count)
    power[1 : (count + 1) // 2] *= 2.0
    return Spectrum(
        axis=axis_of(len(power), signal.rate / count),
        values=np.asarray(power),
        axis_unit="Hz",
        unit=f"({signal.unit or 'unit'})^2/Hz",
        resolution=signal.rate / count,
    )


def averaged_density(signal: Signal, resolution: float) -> Spectrum:
    """Welch's averaged power density: Hann's window, half overlapping, the mean taken away.

    Parameters
    ----------
    signal
        Shorter than one segment, it is one segment.
    resolution
        Distance of the lines: the segments are of one over that; Hz.

    Raises
    ------
    InputError
        If the resolution is not positive, or there are fewer than two samples.
    """
    require_samples(signal, _LEAST, "a spectrum")
    checked_number(resolution, "resolution", above=0.0, example="resolution = 1.0")
    samples = len(signal.samples)
    count = int(min(max(round(signal.rate / resolution), _LEAST), samples))
    frequency, density = scipy_signal.welch(
        signal.samples, signal.rate, window="hann", nperseg=count
    )
    return Spectrum(
        axis=np.asarray(frequency),
        values=np.asarray(density),
        axis_unit="Hz",
        unit=f"({signal.unit or 'unit'})^2/Hz",
        resolution=signal.rate / count,
        averages=max(1, (2 * samples) // count - 1),
    )


def one_sided_amplitudes(samples: FloatArray) -> FloatArray:
    """Amplitudes of the lines of samples, A_k of the module's head; (samples//2 + 1,)."""
    count = len(samples)
    amplitudes = np.abs(fft.rfft(samples)) / count
    amplitudes[1 : (count + 1) // 2] *= 2.0
    return np.asarray(amplitudes)


def axis_of(lines: int, resolution: float) -> FloatArray:
    """Evenly spaced lines from 0; (lines,)."""
    return np.arange(lines, dtype=np.float64) * resolution


def bins_of_band(axis: FloatArray, band: Band) -> BoolArray:
    """Which of evenly spaced lines lie in a band; both edges belong to it."""
    room = EDGE * float(axis[1] - axis[0]) if len(axis) > 1 else 0.0
    return np.asarray((axis >= band[0] - room) & (axis <= band[1] + room))
