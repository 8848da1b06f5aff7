"""The envelope of a signal in a band, and its spectra.

A damaged spot is met again and again, and each blow lets the structure ring: the ringing carries
the rate of the blows as a modulation of its *amplitude*, which the envelope recovers (Randall and
Antoni, Mechanical Systems and Signal Processing 25 (2011), 485-520). With z the analytic signal of
the band, the one-sided spectrum of which is that of the signal twice,

    envelope e = |z|,     squared envelope e² = |z|².

The spectrum of the squared envelope is the one to prefer: squaring makes no harmonics beyond those
of the modulation, and its lines in noise have a plain distribution (see docs/theory).
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_band, require_samples
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import EDGE, Spectrum, axis_of, one_sided_amplitudes

__all__ = ["analytic_signal", "envelope", "envelope_spectrum"]

ComplexArray = NDArray[np.complex128]
EnvelopeKind = Literal["squared", "plain"]

_LEAST_LINES = 4


def analytic_signal(signal: Signal, band: Band | None = None) -> ComplexArray:
    """Analytic signal of a band: its real part is the signal as filtered to the band.

    The filter has steep edges and no delay. Zero frequency is left out.

    Parameters
    ----------
    signal
        At least two samples.
    band
        Hz, with the lines on its edges; by default all up to half the sampling rate.

    Returns
    -------
    (samples,), in the signal's unit.

    Raises
    ------
    InputError
        If the band is outside the signal's range, or holds fewer than four lines.
    """
    require_samples(signal, 2, "an envelope")
    count = len(signal.samples)
    edges = (0.0, 0.5 * signal.rate) if band is None else checked_band(band, signal.rate)
    first, last = _lines(edges, signal.rate, count)
    spectrum = np.asarray(fft.rfft(signal.samples))
    one_sided = np.zeros(count, dtype=np.complex128)
    one_sided[first:last] = 2.0 * spectrum[first:last]
    if count % 2 == 0 and last > count // 2:
        one_sided[count // 2] *= 0.5
    return np.asarray(fft.ifft(one_sided, overwrite_x=True))


def envelope(signal: Signal, band: Band | None = None) -> Signal:
    """Hilbert envelope |z| of a signal in a band, in its unit; arguments as `analytic_signal`."""
    return Signal(
        np.abs(analytic_signal(signal, band)),
        signal.rate,
        signal.quantity,
        signal.unit,
        signal.speed,
        signal.title,
    )


def envelope_spectrum(
    signal: Signal, band: Band | None = None, *, kind: EnvelopeKind = "squared"
) -> Spectrum:
    """Amplitudes of the lines of the envelope, or of its square, without their mean.

    Parameters
    ----------
    signal, band
        As `analytic_signal`.
    kind
        "squared": of e², in unit²; "plain": of e, in unit.

    Returns
    -------
    Spectrum over Hz. Half the sum of the squares of its values is the variance of e² or e. The
    line at half the rate, which an even number of samples has, counts whole in that: of e² it is
    0, as no two lines of a band are that far apart, of e it is not.

    Raises
    ------
    InputError
        As `analytic_signal`, or if the kind is unknown.
    """
    if kind not in ("squared", "plain"):
        raise InputError(
            "must be squared or plain", field="kind", value=kind, example='kind = "squared"'
        )
    size: FloatArray = np.abs(analytic_signal(signal, band))
    if kind == "squared":
        size = np.square(size)
    values = one_sided_amplitudes(size - np.mean(size))
    resolution = signal.rate / len(size)
    unit = signal.unit or "unit"
    return Spectrum(
        axis=axis_of(len(values), resolution),
        values=values,
        axis_unit="Hz",
        unit=f"({unit})^2" if kind == "squared" else unit,
        resolution=resolution,
    )


def _lines(band: Band, rate: float, count: int) -> tuple[int, int]:
    """First line in a band, edges included, and the one after the last; not zero frequency."""
    first = max(1, int(np.ceil(band[0] * count / rate - EDGE)))
    last = min(count // 2, int(np.floor(band[1] * count / rate + EDGE))) + 1
    if last - first < min(_LEAST_LINES, count // 2):
        raise InputError(
            f"holds fewer than {_LEAST_LINES} of the signal's lines, which are "
            f"{rate / count:.3g} Hz apart",
            field="band",
            value=str(band),
            example="band = (2000.0, 4000.0)",
        )
    return first, last
