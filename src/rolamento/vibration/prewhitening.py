"""Cepstrum pre-whitening: every line of the spectrum gets the same size and keeps its phase.

The real cepstrum is the inverse transform of ln |X|; set to zero but for its first value, what is
left is a spectrum of one size with the phases of the signal. Tones and resonances lose their
weight together, and blows stand out (Sawalhi and Randall 2011; Borghesani et al., Mechanical
Systems and Signal Processing 36 (2013), 370-384).
"""

from __future__ import annotations

import numpy as np
from scipy import fft

from rolamento.vibration._checks import require_samples
from rolamento.vibration.signal import Signal

__all__ = ["prewhitened"]


def prewhitened(signal: Signal) -> Signal:
    """Return the signal with a white spectrum and its own phases.

    Its RMS about the mean is 1; its unit is "1". Lines without any power stay without.

    Raises
    ------
    InputError
        If there are fewer than four samples.
    """
    require_samples(signal, 4, "pre-whitening")
    count = len(signal.samples)
    spectrum = np.asarray(fft.rfft(signal.samples))
    spectrum[0] = 0.0
    size = np.abs(spectrum)
    present = size > 0.0
    spectrum[present] /= size[present]
    white = fft.irfft(spectrum, count)
    rms = float(np.sqrt(np.mean(np.square(white))))
    samples = white / rms if rms > 0.0 else white
    return Signal(samples, signal.rate, "unknown", "1", signal.speed, signal.title)
