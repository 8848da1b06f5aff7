"""What vibration analysis computes, written out by its definitions, to stand beside the package.

Nothing here is shared with `rolamento`, and nothing here is a fast transform:

* the transform itself is a product with a matrix of cosines and sines, or Goertzel's recursion for
  a single line; the engine has SciPy's FFT;
* the Hilbert transform is a convolution with its own kernel, 2/N cot(πn/N) for odd n of N even
  samples; the engine zeroes the negative half of a spectrum;
* the analytic signal of a band is a convolution with the kernel of the band (Dirichlet's, summed
  in closed form), or quadrature demodulation: down to zero frequency, low-pass by a long symmetric
  filter, as an analogue receiver does it; the engine picks lines of the spectrum;
* the kurtogram is a bank of filters at the full sampling rate, each moved to the frequency where
  its band really lies, and sampled afterwards; the engine filters and decimates in a tree, where
  every other band comes down upside down;
* the cyclic spectrum is the mean product of two short-time transforms, of the signal and of the
  signal moved by the modulation frequency, one modulation at a time; the engine scans all of them
  by transforms of transforms and corrects for the window (the *fast* coherence);
* the cepstrum is computed, liftered and transformed back; the engine divides by the spectrum's
  size;
* order tracking finds the instants of even angles by bisection of the angle as a function of
  time, and the samples there by a windowed sinc; the engine has splines of the fifth degree.

Sizes are those of small tests: most of this takes N² operations.

Sources: Oppenheim and Schafer, Discrete-Time Signal Processing (transforms, kernels, windows,
cepstrum); Antoni 2007 (kurtogram); Antoni, Xin and Hamzaoui 2017, equation of the averaged cyclic
periodogram.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin, sqrt

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]


# --- transforms ----------------------------------------------------------------------------------


def transform(samples: NDArray[np.generic]) -> Complexes:
    """Discrete Fourier transform as a matrix product, all lines; (N,)."""
    count = len(samples)
    places = np.arange(count)
    # whole numbers modulo N, so that no large angle loses digits
    angles = (2.0 * pi / count) * (np.outer(places, places) % count)
    return np.asarray((np.cos(angles) - 1j * np.sin(angles)) @ samples)


def back(lines: Complexes) -> Complexes:
    """Inverse of `transform`; (N,)."""
    return np.asarray(np.conj(transform(np.conj(lines))) / len(lines))


def goertzel(samples: Floats, line: float) -> complex:
    """One line of the transform, whole or not, by Goertzel's recursion (1958)."""
    angle = 2.0 * pi * line / len(samples)
    turn, before, last = 2.0 * cos(angle), 0.0, 0.0
    for value in samples.tolist():
        before, last = last, value + turn * last - before
    # s_{N-1} e^{jw} - s_{N-2}, turned back to the first sample
    found = complex(last * cos(angle) - before, last * sin(angle))
    return found * complex(cos(angle * len(samples)), -sin(angle * len(samples)))


def amplitudes(samples: Floats) -> Floats:
    """Amplitude of each line from zero to half the rate."""
    count = len(samples)
    found = np.abs(transform(samples))[: count // 2 + 1] / count
    for line in range(1, len(found)):
        if 2 * line != count:
            found[line] *= 2.0
    return np.asarray(found)


def density(samples: Floats, rate: float) -> Floats:
    """Power density of each line from zero to half the rate."""
    count = len(samples)
    found = np.abs(transform(samples))[: count // 2 + 1] ** 2 / (rate * count)
    for line in range(1, len(found)):
        if 2 * line != count:
            found[line] *= 2.0
    return np.asarray(found)


def hann(count: int) -> Floats:
    """Hann's window, one period of it."""
    return np.array([0.5 * (1.0 - cos(2.0 * pi * n / count)) for n in range(count)])


def welch(samples: Floats, rate: float, size: int) -> Floats:
    """Welch's averaged density, segments half overlapping, the mean of each taken away."""
    window = hann(size)
    power = float(np.sum(window**2))
    total, segments = np.zeros(size // 2 + 1), 0
    start = 0
    while start + size <= len(samples):
        part = samples[start : start + size]
        part = part - np.mean(part)
        total += density(part * window, rate) * (size / power)
        segments += 1
        start += size - size // 2
    return total / segments


# --- envelopes -----------------------------------------------------------------------------------


def circular(samples: NDArray[np.generic], kernel: NDArray[np.generic]) -> NDArray[np.generic]:
    """Convolution on a ring, as the sum that it is."""
    count = len(samples)
    places = (np.arange(count)[:, None] - np.arange(count)[None]) % count
    return np.asarray(kernel[places] @ samples)


def hilbert_kernel(count: int) -> Floats:
    """Kernel whose convolution turns every cosine of the ring into a sine."""
    n = np.arange(count)
    kernel = np.zeros(count)
    if count % 2 == 0:
        odd = n % 2 == 1
        kernel[odd] = 2.0 / count / np.tan(pi * n[odd] / count)
    else:
        rest = n[1:]
        kernel[1:] = (1.0 - np.cos(pi * rest) / np.cos(pi * rest / count)) / (
            count * np.tan(pi * rest / count)
        )
    return kernel


def hilbert_envelope(samples: Floats) -> Floats:
    """Root of the sum of squares of a signal without its mean and of its Hilbert transform."""
    plain = samples - np.mean(samples)
    other = circular(plain, hilbert_kernel(len(samples)))
    return np.asarray(np.hypot(plain, other.real))


def band_analytic(samples: Floats, rate: float, low: float, high: float) -> Complexes:
    """Analytic signal of the lines of a band, both ends in it, by the kernel of the band.

    The kernel 2/N Σ exp(2πjkn/N) is Dirichlet's: a quotient of sines about the middle of the band.
    """
    count = len(samples)
    inside = [line for line in range(1, (count - 1) // 2 + 1) if low <= line * rate / count <= high]
    first, last = inside[0], inside[-1]
    middle, width = 0.5 * (first + last), len(inside)
    n = np.arange(1, count)
    kernel = np.empty(count, dtype=np.complex128)
    kernel[0] = width
    kernel[1:] = np.exp(2j * pi * middle * n / count) * (
        np.sin(pi * width * n / count) / np.sin(pi * n / count)
    )
    return np.asarray(circular(samples, 2.0 / count * kernel), dtype=np.complex128)


def quadrature_envelope(samples: Floats, rate: float, low: float, high: float, half: int) -> Floats:
    """Envelope of a band by quadrature demodulation; shorter by `half` samples at either end.

    The low-pass passes up to half the band's width and stops 0.2 of that width farther out, by
    100 dB (Kaiser's window), if it is long enough.
    """
    centre, width = 0.5 * (low + high), high - low
    n = np.arange(len(samples))
    down = samples * np.exp(-2j * pi * centre / rate * n)
    places = np.arange(-half, half + 1)
    cut = 0.6 * width / rate
    taps = 2.0 * cut * np.sinc(2.0 * cut * places) * np.kaiser(2 * half + 1, 10.0)
    taps /= np.sum(taps)
    return np.asarray(2.0 * np.abs(np.convolve(down, taps, "valid")))


# --- kurtogram -----------------------------------------------------------------------------------


def low_pass(order: int, cutoff: float) -> Floats:
    """Windowed sinc with Hamming's window, unity at zero; cut-off in cycles per sample."""
    places = np.arange(order + 1) - 0.5 * order
    window = 0.54 - 0.46 * np.cos(2.0 * pi * np.arange(order + 1) / order)
    taps = 2.0 * cutoff * np.sinc(2.0 * cutoff * places) * window
    return np.asarray(taps / np.sum(taps))


def filter_bank_kurtosis(
    analytic: Complexes, halvings: tuple[int, ...], third: int | None
) -> float:
    """Kurtosis of the complex envelope of one band of the kurtogram.

    Parameters
    ----------
    analytic
        Signal of which all bands are parts.
    halvings
        From the widest on, whether the lower (0) or the upper (1) half is taken.
    third
        Which third of the last one, 0 to 2; None for all of it.
    """
    half, three = low_pass(16, 0.2), low_pass(24, 0.2 / 1.5)
    stages = [(half, 2, side, (2 * side + 1) / 8.0) for side in halvings]
    if third is not None:
        stages.append((three, 3, third, (2 * third + 1) / 12.0))
    signal, lowest = analytic, 0.0
    start, step, length = 0, 1, len(analytic)
    for taps, parts, side, centre in stages:
        # the same filter at the full rate: taps `step` samples apart, moved to where the band is
        spread = np.zeros((len(taps) - 1) * step + 1, dtype=np.complex128)
        spread[::step] = taps
        at = lowest + centre / step
        spread *= np.exp(2j * pi * at * np.arange(len(spread)))
        signal = np.convolve(signal, spread)[: len(analytic)]
        lowest += 0.5 * side / parts / step
        # what is sampled: without the instants at which a filter has not yet run in
        drop = -(-len(taps) // parts)
        length = length // parts - drop
        start += step * parts * drop
        step *= parts
    instants = start + step * np.arange(length)
    envelope = signal[instants] * np.exp(-2j * pi * lowest * instants)
    power = np.abs(envelope - np.mean(envelope)) ** 2
    return float(np.mean(power**2) / np.mean(power) ** 2) - 2.0


# --- cyclic coherence ----------------------------------------------------------------------------


def cyclic_coherence(samples: Floats, rate: float, alpha: float, window: int, step: int) -> Floats:
    """|γ(α, f)| at the carriers f of a short-time transform; (window/2 + 1,).

    S(α, f) = ⟨X(i, f) Y(i, f)*⟩ with X of the signal and Y of the signal moved up by α.
    """
    count = len(samples)
    plain = samples - np.mean(samples)
    moved = plain * np.exp(2j * pi * alpha / rate * np.arange(count))
    taper = hann(window)
    lines, places = np.arange(window // 2 + 1), np.arange(window)
    waves = np.exp(-2j * pi / window * (np.outer(places, lines) % window))
    starts = np.arange(0, count - window + 1, step)
    index = starts[:, None] + places[None]
    one = (plain[index] * taper) @ waves
    other = (moved[index] * taper) @ waves
    cross = np.mean(one * np.conj(other), axis=0)
    powers = np.mean(np.abs(one) ** 2, axis=0) * np.mean(np.abs(other) ** 2, axis=0)
    return np.asarray(np.abs(cross) / np.sqrt(powers))


# --- pre-whitening, order tracking, separation ----------------------------------------------------


def cepstrum_whitened(samples: Floats) -> Floats:
    """Signal whose real cepstrum is zero but for its first value, RMS 1 about no mean."""
    lines = transform(samples - np.mean(samples))
    sizes = np.abs(lines)
    sizes[0] = 1.0
    cepstrum = back(np.log(sizes).astype(np.complex128)).real
    cepstrum[1:] = 0.0
    flat = np.exp(transform(cepstrum).real)
    phases = lines / sizes
    phases[0] = 0.0
    white = back(flat * phases).real
    return np.asarray(white / sqrt(float(np.mean(white**2))))


def tracked(
    samples: Floats, rate: float, turns: Callable[[Floats], Floats], per_turn: float, half: int = 40
) -> Floats:
    """Samples at even angles; NaN where they are too near the ends.

    Parameters
    ----------
    samples, rate
        Of the signal.
    turns
        Revolutions so far at times: rising, 0 at the first sample.
    per_turn
        Samples per revolution.
    half
        Samples on either side of which each is made.
    """
    end = (len(samples) - 1) / rate
    wanted = np.arange(int(turns(np.array([end]))[0] * per_turn) + 1) / per_turn
    low, high = np.zeros(len(wanted)), np.full(len(wanted), end)
    for _ in range(60):
        middle = 0.5 * (low + high)
        short = turns(middle) < wanted
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    places = high * rate
    first = np.floor(places).astype(int) - half + 1
    known = (first >= 0) & (first + 2 * half <= len(samples))
    index = np.clip(first[:, None] + np.arange(2 * half)[None], 0, len(samples) - 1)
    off = places[:, None] - index
    window = np.i0(12.0 * np.sqrt(np.maximum(1.0 - (off / half) ** 2, 0.0))) / np.i0(12.0)
    found = np.sum(samples[index] * np.sinc(off) * window, axis=1)
    return np.where(known, found, np.nan)


def fitted_tones(samples: Floats, rate: float, frequencies: tuple[float, ...]) -> Floats:
    """Sum of tones of known frequencies that comes nearest to a signal: least squares."""
    time = np.arange(len(samples)) / rate
    columns = [f(2.0 * pi * w * time) for w in frequencies for f in (np.cos, np.sin)]
    basis = np.stack(columns, axis=1)
    weights = np.linalg.solve(basis.T @ basis, basis.T @ samples)
    return np.asarray(basis @ weights)
