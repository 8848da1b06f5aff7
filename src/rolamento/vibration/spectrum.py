"""Spectra of a signal, and numbers that sum it up.

One-sided throughout. With X_k the discrete Fourier transform of N samples,

    amplitude  A_k = (2/N) |X_k|           a sine of amplitude A gives A on its line
    density    S_k = (2/(f_s N)) |X_k|²    Σ S_k f_s/N = mean square (Parseval)

where the factor 2 is left out at zero and at half the sampling rate. The averaged density is
Welch's (1967), with Hann's window.

Indicators are of size, peakedness, and how the power lies over frequency. With the mean taken away,
x the samples and ⟨·⟩ their mean:

    RMS = √⟨x²⟩, peak = max |x|, crest factor = peak/RMS, shape factor = RMS/⟨|x|⟩,
    impulse factor = peak/⟨|x|⟩, clearance factor = peak/⟨√|x|⟩²,
    skewness = ⟨x³⟩/RMS³, kurtosis = ⟨x⁴⟩/RMS⁴ (3 for Gaussian noise).

The centre of the spectrum is its mean frequency weighted by power, the spread the standard
deviation about it, the flatness the geometric over the arithmetic mean of the power: 1 for noise
without colour, near 0 for tones.

Randall, Vibration-based Condition Monitoring (2011), chapter 5; Lei et al., Mechanical Systems and
Signal Processing 22 (2008), for the last four of the first group.
"""

from __future__ import annotations

from math import sqrt
from typing import Final, Literal

import numpy as np
import scipy

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.vibration._checks import (
    Band,
    checked_band,
    checked_number,
    require_samples,
    require_signal,
)
from rolamento.vibration.signal import Signal
from rolamento.words import marked


@frozen(eq=False)
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
"""Fraction of the distance of the lines: one that is so little outside a band lies on its edge. Of
2²⁸ samples, rounding moves a line by 10⁻⁷."""
_LEAST: Final = 2


def amplitude_spectrum(signal: Signal) -> Spectrum:
    """Amplitudes of the lines of a signal, in its unit, over Hz.

    Raises
    ------
    InputError
        If there are fewer than two samples.
    """
    require_samples(signal, _LEAST, marked("a spectrum"))
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
    require_samples(signal, _LEAST, marked("a spectrum"))
    count = len(signal.samples)
    power = np.square(np.abs(scipy.fft.rfft(signal.samples))) / (signal.rate * count)
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
    from scipy.signal import welch  # slow to import

    require_samples(signal, _LEAST, marked("a spectrum"))
    checked_number(resolution, "resolution", above=0.0, example="resolution = 1.0")
    samples = len(signal.samples)
    count = int(min(max(round(signal.rate / resolution), _LEAST), samples))
    frequency, density = welch(signal.samples, signal.rate, window="hann", nperseg=count)
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
    amplitudes = np.abs(scipy.fft.rfft(samples)) / count
    amplitudes[1 : (count + 1) // 2] *= 2.0
    return np.asarray(amplitudes)


def axis_of(lines: int, resolution: float) -> FloatArray:
    """Evenly spaced lines from 0; (lines,)."""
    return np.arange(lines, dtype=np.float64) * resolution


def bins_of_band(axis: FloatArray, band: Band) -> BoolArray:
    """Which of evenly spaced lines lie in a band; both edges belong to it."""
    room = EDGE * float(axis[1] - axis[0]) if len(axis) > 1 else 0.0
    return np.asarray((axis >= band[0] - room) & (axis <= band[1] + room))


# --- indicators: numbers that sum a signal up ----------------------------------------------------


@frozen
class Indicators:
    """Size and peakedness of a signal; factors are NaN for a signal that does not change.

    Attributes
    ----------
    unit
        of mean, rms, peak and peak_to_peak
    mean, rms, peak, peak_to_peak
        rms and peak about the mean
    crest, shape, impulse, clearance, skewness, kurtosis
        without unit
    """

    unit: str
    mean: float
    rms: float
    peak: float
    peak_to_peak: float
    crest: float
    shape: float
    impulse: float
    clearance: float
    skewness: float
    kurtosis: float


@frozen
class SpectralIndicators:
    """How the power of a signal lies over frequency within a band.

    Attributes
    ----------
    band
        Hz
    rms
        of what lies in the band, in `unit`
    centre, spread
        Hz
    flatness
        from 0 to 1
    """

    band: Band
    unit: str
    rms: float
    centre: float
    spread: float
    flatness: float


def indicators(signal: Signal) -> Indicators:
    """Return the indicators of a signal."""
    require_signal(signal)
    mean = float(np.mean(signal.samples))
    x = signal.samples - mean
    size = np.abs(x)
    peak = float(np.max(size))
    span = float(np.ptp(x))
    if peak == 0.0:
        nothing = [float("nan")] * 6
        return Indicators(signal.unit, mean, 0.0, 0.0, 0.0, *nothing)
    # over the peak, so that no power of it can over- or underflow
    x /= peak
    size /= peak
    rms = sqrt(float(np.mean(np.square(x))))
    mean_size = float(np.mean(size))
    return Indicators(
        unit=signal.unit,
        mean=mean,
        rms=rms * peak,
        peak=peak,
        peak_to_peak=span,
        crest=1.0 / rms,
        shape=rms / mean_size,
        impulse=1.0 / mean_size,
        clearance=1.0 / float(np.mean(np.sqrt(size))) ** 2,
        skewness=float(np.mean(x**3)) / rms**3,
        kurtosis=float(np.mean(np.square(np.square(x)))) / rms**4,
    )


def spectral_indicators(signal: Signal, band: Band | None = None) -> SpectralIndicators:
    """Return the spectral indicators of a signal within a band.

    Parameters
    ----------
    signal
        At least 16 samples.
    band
        Hz; by default all up to half the sampling rate.

    Raises
    ------
    InputError
        If the signal is too short or the band outside its range.
    """
    require_samples(signal, 16, marked("a spectrum"))
    edges = (0.0, 0.5 * signal.rate) if band is None else checked_band(band, signal.rate)
    spectrum = power_density(signal)
    inside = bins_of_band(spectrum.axis, edges)
    frequency, density = spectrum.axis[inside], spectrum.values[inside]
    total = float(np.sum(density))
    if total == 0.0:
        return SpectralIndicators(edges, signal.unit, 0.0, *([float("nan")] * 3))
    centre = float(np.sum(frequency * density)) / total
    spread = sqrt(float(np.sum(np.square(frequency - centre) * density)) / total)
    return SpectralIndicators(
        band=edges,
        unit=signal.unit,
        rms=sqrt(total * spectrum.resolution),
        centre=centre,
        spread=spread,
        flatness=_flatness(density),
    )


def _flatness(density: FloatArray) -> float:
    if np.min(density) <= 0.0:
        return 0.0
    return float(np.exp(np.mean(np.log(density))) / np.mean(density))
