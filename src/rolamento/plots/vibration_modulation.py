"""Modulation of amplitude beside modulation of frequency, and what the envelope makes of each."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts.frame import add_title, label_x, label_y, legend_above
from rolamento.charts.style import new_stacked_figure, series, styled
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.signal import Signal

__all__ = ["envelope_depths", "modulation_figure"]

Floats = NDArray[np.float64]
Band = tuple[float, float]

_PERIODS: Final = 3.2
_MULTIPLES: Final = (1, 2, 3)
_WIDTH: Final = 0.26


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
    whole = said("envelope")
    with styled():
        figure, (above, middle, below) = new_stacked_figure(3, height=190.0)
        _waveform(above, amplitude, line, band, (by_amplitude, whole, cut))
        _waveform(middle, frequency, line, band, (by_frequency, whole, cut))
        places = np.arange(len(_MULTIPLES), dtype=np.float64)
        for index, (signal, of_band, name) in enumerate(
            (
                (amplitude, None, f"{by_amplitude}, {whole}"),
                (frequency, None, f"{by_frequency}, {whole}"),
                (frequency, band, f"{by_frequency}, {cut}"),
            )
        ):
            depths = envelope_depths(signal, line, of_band)
            below.bar(
                places + (index - 1) * _WIDTH, depths, _WIDTH, label=name,
                color=series(index).color, hatch=("", "..", "//")[index], edgecolor="white",
            )  # fmt: skip
        label_x(below, said("Multiple of {line:.4 Hz}", line=line))
        label_y(below, said("Peak of the envelope over its mean"))
        below.set_xticks(places, [f"{multiple}×" for multiple in _MULTIPLES])
        legend_above(below)
        if title:
            add_title(figure, title)
    return figure


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


def _waveform(
    axes: Axes, signal: Signal, line: float, band: Band, names: tuple[str, str, str]
) -> None:
    """Draw a few periods from the middle of a signal, with its envelopes."""
    from rolamento.vibration.demodulation import envelope

    middle = len(signal.samples) // 2
    end = min(middle + round(_PERIODS * signal.rate / line), len(signal.samples))
    time = 1e3 * np.arange(end - middle) / signal.rate
    axes.plot(time, signal.samples[middle:end], color="#808080", linewidth=0.6, label=names[0])
    for index, of_band in enumerate((None, band)):
        heights = envelope(signal, of_band).samples[middle:end]
        axes.plot(
            time, heights, color=series(index).color, linestyle=series(index).linestyle,
            label=names[index + 1],
        )  # fmt: skip
    axes.set_xlim(0.0, float(time[-1]))
    label_x(axes, said("Time (ms)"))
    label_y(axes, said("Acceleration (m/s²)"))
    legend_above(axes)
