"""Modulation of amplitude beside modulation of frequency, and what the envelope makes of each."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import Axis, Bars, Chart, Line, Look, series_look
from rolamento.charts.courses import extremes
from rolamento.charts.drawing import figure
from rolamento.charts.texts import capitalised
from rolamento.words import said
from rolamento.words.quantities import called

if TYPE_CHECKING:
    from rolamento.vibration.signal import Signal

__all__ = ["envelope_depths", "modulation_figure"]

Floats = NDArray[np.float64]
Band = tuple[float, float]

_PERIODS: Final = 3.2
_MULTIPLES: Final = (1, 2, 3)


def modulation_figure(
    amplitude: Signal, frequency: Signal, line: float, band: Band, *, title: str = ""
) -> Figure:
    """Draw two signals with their envelopes, and the lines of these.

    Parameters
    ----------
    amplitude, frequency
        Modulated in amplitude and in frequency; m/s².
    line
        Frequency of the modulation; Hz.
    band
        That holds only a part of the second signal; Hz.
    title
        Over the figure.
    """
    cut = said("envelope from {low:.4} to {high:.4 Hz}", low=band[0], high=band[1])
    by_amplitude, by_frequency = said("amplitude modulated"), said("frequency modulated")
    whole, places = said("envelope"), tuple(range(len(_MULTIPLES)))
    bars = (
        Bars(envelope_depths(signal, line, of_band), places, name, look)
        for signal, of_band, name, look in (
            (amplitude, None, f"{by_amplitude}, {whole}", series_look(0)),
            (frequency, None, f"{by_frequency}, {whole}", series_look(1)),
            (frequency, band, f"{by_frequency}, {cut}", Look("inner2", hollow=True)),
        )
    )
    multiples = tuple(said("{multiple}× {line:.4 Hz}", multiple=m, line=line) for m in _MULTIPLES)
    depths = Chart(
        tuple(bars),
        Axis(label=said("Peak of the envelope over its mean"), zero=True),
        Axis(categories=multiples),
    )
    return figure(
        _waveform(amplitude, line, band, (by_amplitude, whole, cut)),
        _waveform(frequency, line, band, (by_frequency, whole, cut)),
        depths,
        title=title,
        height=190.0,
        own=True,
    )


def envelope_depths(signal: Signal, line: float, band: Band | None = None) -> Floats:
    """Lines of the envelope at 1, 2 and 3 times a frequency (Hz), over the envelope's mean.

    Each is the greatest of the lines next to it: a record that does not hold a whole number of
    periods spreads it over some.
    """
    from rolamento.vibration.demodulation import envelope, envelope_spectrum

    spectrum = envelope_spectrum(signal, band, kind="plain")
    mean = float(np.mean(envelope(signal, band).samples))
    near = [np.abs(spectrum.axis - multiple * line) for multiple in _MULTIPLES]
    within = 1.5 * spectrum.resolution
    return np.array([spectrum.values[away <= within].max() / mean for away in near])


def _waveform(signal: Signal, line: float, band: Band, names: tuple[str, str, str]) -> Chart:
    """Return a few periods from the middle of a signal, with its envelopes."""
    from rolamento.vibration.demodulation import envelope

    middle = len(signal.samples) // 2
    end = min(middle + round(_PERIODS * signal.rate / line), len(signal.samples))
    time = np.arange(float(end - middle)) * (1e3 / signal.rate)
    lines = [Line(time, signal.samples[middle:end], names[0], Look("grey", width=0.45))]
    lines += [
        Line(time, envelope(signal, of_band).samples[middle:end], name, series_look(index))
        for index, (of_band, name) in enumerate(zip((None, band), names[1:], strict=True))
    ]
    across = Axis(limits=(0.0, float(time[-1])), name=said("Time"), unit="ms")
    upright = Axis(capitalised(called("acceleration")), "m/s²")
    envelopes = [(line.name, line.x, line.y) for line in lines[1:]]
    return Chart(tuple(lines), across, upright, extremes(envelopes, across, upright))
