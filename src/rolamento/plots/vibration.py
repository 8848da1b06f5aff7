"""Pictures of a vibration signal and of its diagnosis: waveform, kurtogram, envelope spectrum."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    number,
)
from rolamento.plots.style import INNER, new_figure, new_stacked_figure, styled
from rolamento.plots.vibration_kurtogram import kurtogram_figure, kurtogram_map, kurtogram_of
from rolamento.plots.vibration_spectrum import envelope_figure, envelope_lines
from rolamento.plots.vibration_words import vibration_words
from rolamento.plots.words import plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.diagnosis import Diagnosis
    from rolamento.vibration.signal import Signal

__all__ = [
    "diagnosis_figure",
    "envelope_figure",
    "envelope_lines",
    "kurtogram_figure",
    "kurtogram_map",
    "waveform",
    "waveform_figure",
]

Floats = NDArray[np.float64]

_COLUMNS: Final = 1500
"""Of a long waveform; in each, the least and the greatest sample are drawn."""
_PERIODS: Final = 12.0
"""Of a fault that are shown of its waveform."""
_MOST_MARKS: Final = 200
_PHASES: Final = 64
_UNITS: Final = {"m/s^2": "m/s²", "mm/s^2": "mm/s²", "um": "µm", "um/s": "µm/s", "1": ""}


def diagnosis_figure(
    signal: Signal, diagnosis: Diagnosis, *, title: str = "", language: str = "en"
) -> Figure:
    """Draw all about a diagnosis: the waveform, the kurtogram, and the envelope's spectrum.

    Parameters
    ----------
    signal
        That was diagnosed, or its first part.
    diagnosis
        Of it.
    title
        Over the figure.
    language
        ``"en"`` or ``"pt"``.

    Returns
    -------
    Figure
        Of a fault, the waveform shows a few of its periods, and the kurtogram its band.
    """
    fault, words = diagnosis.clearest_fault, vibration_words(language)
    period = span = band = None
    name = ""
    if fault is not None:
        period, band, name = 1.0 / fault.frequency, fault.band, words.parts[fault.component]
        end = min(_PERIODS * period, signal.duration)
        span = (0.0, end)
    with styled():
        figure, (first, second, third) = new_stacked_figure(3, height=230.0)
        waveform(signal, first, period=period, part=name, span=span, band=band, language=language)
        kurtogram_map(kurtogram_of(signal), second, band=band, language=language)
        envelope_lines(diagnosis, third, language=language)
        if title:
            add_title(figure, title)
    return figure


def waveform_figure(
    signal: Signal,
    *,
    period: float | None = None,
    span: tuple[float, float] | None = None,
    title: str = "",
    language: str = "en",
) -> Figure:
    """Draw a waveform, as `waveform`, with a title."""
    with styled():
        figure, axes = new_figure(height=70.0)
        waveform(signal, axes, period=period, span=span, language=language)
        if title:
            add_title(figure, title)
    return figure


def waveform(
    signal: Signal,
    axes: Axes | None = None,
    *,
    period: float | None = None,
    part: str = "",
    span: tuple[float, float] | None = None,
    band: tuple[float, float] | None = None,
    language: str = "en",
) -> Axes:
    """Draw a signal over time, with the blows of a fault marked if its period is given.

    Parameters
    ----------
    signal
        Of which a long stretch is drawn by its extremes.
    axes
        To draw on; of a new figure if not given.
    period
        To mark; s. The marks begin where the envelope, folded by the period, is greatest.
    part
        What the period belongs to, for the legend.
    span
        To show, from and to; s. By default all.
    band
        Of the envelope that tells where the marks begin; Hz.
    language
        ``"en"`` or ``"pt"``.
    """
    shared, words = plot_words(language), vibration_words(language)
    with styled():
        axes = new_figure(height=70.0)[1] if axes is None else axes
        first, last = _range(signal, span)
        samples = signal.samples[first:last]
        if samples.size < 2:
            return empty_frame(axes, words.no_lines)
        _draw(axes, samples, first, signal.rate)
        axes.set_xlim(first / signal.rate, last / signal.rate)
        if period is not None:
            text = words.period.format(part=part, period=number(1e3 * period, shared))
            _periods(axes, signal, (first, last), period, band, text)
        label_x(axes, words.time, shared)
        unit = _UNITS.get(signal.unit, signal.unit)
        label_y(axes, words.quantities[signal.quantity] + (f" ({unit})" if unit else ""), shared)
        legend_above(axes)
    return axes


def _range(signal: Signal, span: tuple[float, float] | None) -> tuple[int, int]:
    count = len(signal.samples)
    if span is None:
        return 0, count
    first = min(max(round(span[0] * signal.rate), 0), count)
    return first, min(max(round(span[1] * signal.rate), first), count)


def _draw(axes: Axes, samples: Floats, first: int, rate: float) -> None:
    """Draw samples as a line, or so many that they merge as the span of each column."""
    if len(samples) <= 4 * _COLUMNS:
        times = (first + np.arange(len(samples))) / rate
        axes.plot(times, samples, color=INNER.color, linewidth=0.7)
        return
    step = -(-len(samples) // _COLUMNS)
    starts = np.arange(0, len(samples), step)
    least, most = (np.minimum.reduceat(samples, starts), np.maximum.reduceat(samples, starts))
    middles = (first + starts + 0.5 * step) / rate
    axes.fill_between(middles, least, most, color=INNER.color, linewidth=0.4)


def _periods(
    axes: Axes,
    signal: Signal,
    place: tuple[int, int],
    period: float,
    band: tuple[float, float] | None,
    text: str,
) -> None:
    """Mark the blows of a fault: a comb that begins where the folded envelope is greatest."""
    start, end = place[0] / signal.rate, place[1] / signal.rate
    if not 0.0 < period < end - start or (end - start) / period > _MOST_MARKS:
        return
    first = start + _phase(signal, place, period, band)
    times = np.arange(first, end, period)
    for index, time in enumerate(times):
        label = None if index else text
        axes.axvline(time, color=GREY, linestyle=":", linewidth=0.9, zorder=1.5, label=label)


def _phase(
    signal: Signal, place: tuple[int, int], period: float, band: tuple[float, float] | None
) -> float:
    """Time from the first sample to the first blow, to a part of the period."""
    from dataclasses import replace

    from rolamento.vibration.demodulation import analytic_signal

    piece = replace(signal, samples=signal.samples[place[0] : place[1]], speed=None)
    # a narrow band of a short piece may hold no lines: then all frequencies tell
    narrow = band is None or (band[1] - band[0]) * piece.duration < 8.0
    power = np.square(np.abs(analytic_signal(piece, None if narrow else band)))
    times = np.arange(len(power)) / signal.rate
    bins = (np.mod(times, period) / period * _PHASES).astype(np.int64) % _PHASES
    totals = np.bincount(bins, power, _PHASES)
    counts = np.bincount(bins, minlength=_PHASES)
    means = np.divide(totals, counts, out=np.zeros(_PHASES), where=counts > 0)
    return float((np.argmax(means) + 0.5) / _PHASES * period)
