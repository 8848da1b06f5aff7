"""Numbers that sum a signal up: size, peakedness, and how its power lies over frequency.

With the mean taken away, x the samples and ⟨·⟩ their mean:

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

from dataclasses import dataclass
from math import sqrt

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_band, require_samples
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import bins_of_band, power_density

__all__ = ["Indicators", "SpectralIndicators", "indicators", "spectral_indicators"]


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
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
    require_samples(signal, 16, "a spectrum")
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
