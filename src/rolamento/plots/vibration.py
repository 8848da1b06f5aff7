"""Pictures of a vibration signal and of its diagnosis: waveform, kurtogram, envelope spectrum.

A kurtogram shows how impulsive a signal is, over frequency and bandwidth; the spectrum that a
diagnosis searched is that of the squared envelope over noise, with the bearing's lines.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from rolamento.charts.frame import (
    GREY,
    add_title,
    empty_frame,
    figure_of,
    label_x,
    label_y,
    legend_above,
    legend_in_columns,
    panels,
)
from rolamento.charts.style import INNER, Series, new_figure, new_stacked_figure, series, styled
from rolamento.charts.texts import number, numbers, shown_text
from rolamento.vibration.diagnosis import COMPONENTS
from rolamento.words import manner, marked, said
from rolamento.words.naming import part_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.demodulation import Kurtogram
    from rolamento.vibration.diagnosis import Component, ComponentVerdict, Diagnosis
    from rolamento.vibration.signal import Signal


Floats = NDArray[np.float64]
_COLUMNS: Final = 1500
"""Number of columns of a long waveform; in each, the least and the greatest sample are drawn."""
_PERIODS: Final = 12.0
"""Number of periods of a fault that are shown of its waveform."""
_MOST_MARKS: Final = 200
_PHASES: Final = 64
_QUANTITIES: Final = {
    "acceleration": marked("Acceleration"),
    "velocity": marked("Velocity"),
    "displacement": marked("Displacement"),
    "unknown": marked("Signal"),
}
_UNITS: Final = {"m/s^2": "m/s²", "mm/s^2": "mm/s²", "um": "µm", "um/s": "µm/s", "1": ""}


def diagnosis_figure(signal: Signal, diagnosis: Diagnosis, *, title: str = "") -> Figure:
    """Draw all about a diagnosis: the waveform, the kurtogram, and the envelope's spectrum.

    Parameters
    ----------
    signal
        That was diagnosed, or its first part.
    diagnosis
        Of it.
    title
        Over the figure.

    Returns
    -------
    Figure
        Of a fault, the waveform shows a few of its periods, and the kurtogram its band.
    """
    fault = diagnosis.clearest_fault
    with styled():
        figure, (first, second, third) = new_stacked_figure(3, height=230.0)
        waveform(signal, first, **_of_fault(signal, diagnosis))
        kurtogram_map(kurtogram_of(signal), second, band=None if fault is None else fault.band)
        envelope_lines(diagnosis, third)
        if title:
            add_title(figure, title)
    return figure


def impacts_figure(signal: Signal, diagnosis: Diagnosis, *, title: str = "") -> Figure:
    """Draw the waveform of a diagnosis: of a fault a few periods, with its impacts marked."""
    return panels(
        lambda axes: waveform(signal, axes, **_of_fault(signal, diagnosis)),
        title=title,
        height=70.0,
    )


def _of_fault(signal: Signal, diagnosis: Diagnosis) -> dict[str, Any]:
    """Return what `waveform` shows of the clearest fault."""
    fault, element = diagnosis.clearest_fault, diagnosis.element
    if fault is None:
        return {}
    period = 1.0 / fault.frequency
    return {
        "period": period,
        "part": part_name(fault.component, element),
        "span": (0.0, min(_PERIODS * period, signal.duration)),
        "band": fault.band,
    }


def waveform_figure(
    signal: Signal,
    *,
    period: float | None = None,
    span: tuple[float, float] | None = None,
    title: str = "",
) -> Figure:
    """Draw a waveform, as `waveform`, with a title."""
    return panels(
        lambda axes: waveform(signal, axes, period=period, span=span), title=title, height=70.0
    )


def waveform(
    signal: Signal,
    axes: Axes | None = None,
    *,
    period: float | None = None,
    part: str = "",
    span: tuple[float, float] | None = None,
    band: tuple[float, float] | None = None,
) -> Axes:
    """Draw a signal over time, with the impacts of a fault marked if its period is given.

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
        Of the envelope that decides where the marks begin; Hz.
    """
    with styled():
        axes = new_figure(height=70.0)[1] if axes is None else axes
        first, last = _sample_range(signal, span)
        samples = signal.samples[first:last]
        if samples.size < 2:
            return empty_frame(axes, said("The signal has fewer than two samples here."))
        _draw_waveform(axes, samples, first, signal.rate)
        axes.set_xlim(first / signal.rate, last / signal.rate)
        if period is not None:
            text = said("period, {part}: {period:.4 ms}", part=part, period=period)
            _periods(axes, signal, (first, last), period, band, text)
        label_x(axes, said("Time (s)"))
        unit = _UNITS.get(signal.unit, signal.unit)
        label_y(axes, said(_QUANTITIES[signal.quantity]) + (f" ({unit})" if unit else ""))
        legend_above(axes)
    return axes


def _sample_range(signal: Signal, span: tuple[float, float] | None) -> tuple[int, int]:
    count = len(signal.samples)
    if span is None:
        return 0, count
    first = min(max(round(span[0] * signal.rate), 0), count)
    return first, min(max(round(span[1] * signal.rate), first), count)


def _draw_waveform(axes: Axes, samples: Floats, first: int, rate: float) -> None:
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
    """Mark the impacts of a fault: a comb that begins where the folded envelope is greatest."""
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
    """Time from the first sample to the first impact, to a part of the period."""
    from dataclasses import replace

    from rolamento.vibration.demodulation import analytic_signal

    piece = replace(signal, samples=signal.samples[place[0] : place[1]], speed=None)
    # a narrow band of a short piece may hold no lines: then all frequencies are used
    narrow = band is None or (band[1] - band[0]) * piece.duration < 8.0
    power = np.square(np.abs(analytic_signal(piece, None if narrow else band)))
    times = np.arange(len(power)) / signal.rate
    bins = (np.mod(times, period) / period * _PHASES).astype(np.int64) % _PHASES
    totals = np.bincount(bins, power, _PHASES)
    counts = np.bincount(bins, minlength=_PHASES)
    means = np.divide(totals, counts, out=np.zeros(_PHASES), where=counts > 0)
    return float((np.argmax(means) + 0.5) / _PHASES * period)


# --- the kurtogram -------------------------------------------------------------------------------


MOST_SAMPLES: Final = 2**20
"""Maximum number of samples of a signal that a picture is made of: more narrow the scatter and cost
seconds."""
_LEAST_SAMPLES: Final = 256
_BEST: Final = "#D55E00"
_FAULT: Final = "#FFFFFF"


def kurtogram_of(signal: Signal) -> Kurtogram | None:
    """Return the kurtogram of a signal's first million samples; None if it has too few."""
    from dataclasses import replace

    from rolamento.vibration.demodulation import kurtogram

    if len(signal.samples) < _LEAST_SAMPLES or np.ptp(signal.samples) == 0.0:
        return None
    part = signal.samples[:MOST_SAMPLES]
    return kurtogram(replace(signal, samples=part, speed=None))


def kurtogram_figure(
    signal: Signal, *, band: tuple[float, float] | None = None, title: str = ""
) -> Figure:
    """Draw the kurtogram of a signal.

    Parameters
    ----------
    signal
        Of which the first million samples are used.
    band
        To mark, such as the one that a fault is clearest in; Hz.
    title
        Over the figure.
    """
    return panels(
        lambda axes: kurtogram_map(kurtogram_of(signal), axes, band=band), title=title, height=95.0
    )


def kurtogram_map(
    found: Kurtogram | None, axes: Axes | None = None, *, band: tuple[float, float] | None = None
) -> Axes:
    """Draw a kurtogram: a row for each bandwidth, a frame about the band that stands out most.

    Parameters
    ----------
    found
        The kurtogram; None of a signal that is too short or does not change.
    axes
        To draw on; of a new figure if not given.
    band
        To mark as well, dashed; Hz.
    """
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        if found is None:
            return empty_frame(axes, said("The signal is too short for a kurtogram."))
        values = found.picture()
        half, rows = 0.5 * found.rate, len(found.levels)
        picture = axes.imshow(
            values, extent=(0.0, half, rows, 0.0), aspect="auto", interpolation="nearest",
            vmin=min(0.0, float(values.min())),
        )  # fmt: skip
        axes.grid(visible=False)
        _color_bar(axes, picture)
        _label_levels(axes, found)
        label_x(axes, said("Frequency (Hz)"))
        _frames(axes, found, band)
    return axes


def _color_bar(axes: Axes, picture: object) -> None:
    bar = figure_of(axes).colorbar(picture, ax=axes, pad=0.02)  # type: ignore[arg-type]
    bar.set_label(said("Kurtosis above that of noise"), parse_math=False)
    bar.ax.yaxis.set_major_formatter(numbers())
    bar.ax.tick_params(labelsize=8.0)


def _label_levels(axes: Axes, found: Kurtogram) -> None:
    """Number the rows by their bandwidths."""
    step = 1 if len(found.levels) <= 9 else 2
    places = range(0, len(found.levels), step)
    labels = [number(found.levels[place].bandwidth, 4) for place in places]
    axes.set_yticks([place + 0.5 for place in places], labels)
    axes.set_ylabel(said("Bandwidth (Hz)"), parse_math=False)


def _frames(axes: Axes, found: Kurtogram, band: tuple[float, float] | None) -> None:
    """Frame the band that stands out most in its row; show the given one across all rows.

    By its significance: of thousands of narrow bands one is always impulsive by chance.
    """
    best, rows = found.best("significance"), len(found.levels)
    row = [level.level for level in found.levels].index(best.level)
    low, high = best.band
    label = said("stands out most: {low:.4} to {high:.4 Hz}", low=low, high=high)
    frame = Rectangle(
        (low, row), high - low, 1.0, fill=False, edgecolor=_BEST, linewidth=1.6,
        label=shown_text(label), zorder=4.0,
    )  # fmt: skip
    axes.add_patch(frame)
    handles: list[Rectangle] = [frame]
    if band is not None:
        text = said("fault clearest: {low:.4} to {high:.4 Hz}", low=band[0], high=band[1])
        given = Rectangle(
            (band[0], 0.03), band[1] - band[0], rows - 0.06, fill=False, edgecolor=_FAULT,
            linestyle="--", linewidth=1.2, zorder=3.0,
        )  # fmt: skip
        axes.add_patch(given)
        # white does not show beside the picture: its key is grey
        handles.append(
            Rectangle((0, 0), 1, 1, fill=False, edgecolor="#707070", linestyle="--", label=text)
        )
    legend_above(axes, handles=handles)


# --- the spectrum that was searched --------------------------------------------------------------


_FLOOR: Final = -3.0
"""dB; deeper than that noise means nothing."""
_ROOM: Final = 4.0
_LEAST_TOP: Final = 16.0
_HALF_PEAK: Final = 3
"""Lines on either side in which the top of a peak is looked for."""
_LABEL_GAP: Final = 4.0
_RATIOS: Final = np.geomspace(1.0, 1e6, 4000)


class _Drawn(NamedTuple):
    """The line that marks stand on, and the decimal mark of their labels."""

    hertz: Floats
    level: Floats
    mark: str


def line_threshold(diagnosis: Diagnosis) -> float:
    """Power over the mean of the noise above which a single line is not noise; dB.

    All trials of the search are counted, as in the verdict.
    """
    from rolamento.vibration.noise_floor import HALF_WIDTH, mean_over_median, mean_scores

    shape = _RATIOS.shape
    scores = mean_scores(
        _RATIOS,
        np.ones(shape),
        np.ones(shape, dtype=np.int64),
        np.full(shape, HALF_WIDTH, dtype=np.int64),
        diagnosis.blocks,
    )
    wanted = np.log(max(diagnosis.trials, 1) / diagnosis.false_alarm)
    ratio = float(np.interp(wanted, scores, _RATIOS))
    return 10.0 * float(np.log10(ratio / mean_over_median(diagnosis.blocks)))


def envelope_figure(diagnosis: Diagnosis, *, band: int | None = None, title: str = "") -> Figure:
    """Draw the spectrum of the squared envelope of a band, as `envelope_lines`, with a title."""
    return panels(lambda axes: envelope_lines(diagnosis, axes, band=band), title=title, height=95.0)


def envelope_lines(
    diagnosis: Diagnosis, axes: Axes | None = None, *, band: int | None = None
) -> Axes:
    """Draw the squared envelope's spectrum in a band, with the frequencies of the bearing.

    Parameters
    ----------
    diagnosis
        Of `rolamento.vibration.diagnosis.verdict`.
    axes
        To draw on; of a new figure if not given.
    band
        Number in `diagnosis.spectra.bands`; by default that of the clearest fault, of the clearest
        unexplained peak if there is none, or else of the best match.

    Returns
    -------
    Axes
        Those given. Found lines have filled marks and their multiples, sidebands hollow ones;
        parts without a finding have the span in which they were looked for.
    """
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        place = diagnosis.clearest_band if band is None else band
        above = diagnosis.spectra.above_noise[place]
        known = np.flatnonzero(np.isfinite(above))
        if known.size == 0:
            return empty_frame(axes, said("The signal allows no envelope spectrum."))
        hertz = diagnosis.spectra.order * diagnosis.shaft_frequency
        level = _decibels(above)
        threshold = line_threshold(diagnosis)
        axes.plot(hertz, np.maximum(level, _FLOOR), color="#606060", linewidth=0.6)
        axes.axhline(0.0, color=GREY, linewidth=0.9, label=said("noise, mean"))
        above_chance = said("above this, a single peak is not noise")
        axes.axhline(threshold, color=GREY, linestyle="--", linewidth=0.9, label=above_chance)
        top = max(_LEAST_TOP, threshold + 1.0, float(np.nanmax(level))) + _ROOM
        axes.set_ylim(_FLOOR, top)
        axes.set_xlim(0.0, float(hertz[known[-1]]))
        _mark_shaft(axes, diagnosis)
        drawn = _Drawn(hertz, level, manner().mark)
        for number_of, part in enumerate(COMPONENTS):
            _mark_component(axes, diagnosis, part, series(number_of), drawn, threshold)
        _mark_unexplained(axes, diagnosis, drawn)
        label_x(axes, said("Frequency (Hz)"))
        label_y(axes, said("Envelope² over noise (dB)"))
        low, high = diagnosis.spectra.bands[place]
        title = said("Band {low:.4} to {high:.4 Hz}", low=low, high=high)
        legend_in_columns(axes, title=title)
    return axes


def _decibels(above: Floats) -> Floats:
    with np.errstate(divide="ignore", invalid="ignore"):
        level = 10.0 * np.log10(above)
    return np.where(np.isneginf(level), _FLOOR, level)


def _mark_shaft(axes: Axes, diagnosis: Diagnosis) -> None:
    """Tick the multiples of the shaft at the foot: they are left out of the search."""
    frequency, end = diagnosis.shaft_frequency, axes.get_xlim()[1]
    if frequency <= 0.0 or end / frequency > 1000.0:
        return
    places = frequency * np.arange(1, int(end / frequency) + 1)
    axes.plot(
        places, np.full(len(places), 0.015), transform=axes.get_xaxis_transform(), color="black",
        linestyle="", marker="|", markersize=5.0, clip_on=False,
        label=said("multiples of the shaft speed"),
    )  # fmt: skip


def _mark_component(
    axes: Axes, diagnosis: Diagnosis, part: Component, look: Series, drawn: _Drawn, threshold: float
) -> None:
    hertz, level, mark = drawn
    verdict, name = diagnosis.of(part), part_name(part, diagnosis.element)
    if verdict.band is not None:
        keywords: dict[str, Any] = {"color": look.color, "linestyle": "", "marker": look.marker}
        lines = [(line.frequency, f"{line.multiple:g}×") for line in verdict.lines]
        lines += _further_multiples(verdict, drawn, threshold)
        tops = [_peak_height(place, hertz, level) for place, _ in lines]
        axes.plot(
            [place for place, _ in lines], tops, **keywords, label=said("{part}, found", part=name)
        )
        for (place, text), top in zip(lines, tops, strict=True):
            axes.annotate(
                text.replace(".", mark), (place, top), xytext=(0.0, _LABEL_GAP),
                textcoords="offset points", ha="center", fontsize=7.0, color=look.color,
                annotation_clip=True,
            )  # fmt: skip
        if verdict.sidebands:
            sides = [line.frequency for line in verdict.sidebands]
            axes.plot(
                sides, [_peak_height(place, hertz, level) for place in sides], **keywords,
                markerfacecolor="white", label=said("{part}, sidebands", part=name),
            )  # fmt: skip
    elif verdict.verdict == "nothing_found":
        nominal = verdict.nominal_order * diagnosis.shaft_frequency
        if nominal < axes.get_xlim()[1]:
            axes.axvline(nominal, **look.keywords(), alpha=0.8, linewidth=1.1, zorder=1.5,
                         label=said("{part}, expected", part=name))  # fmt: skip
            spread = diagnosis.tolerance * nominal
            axes.axvspan(
                nominal - spread, nominal + spread, color=look.color, alpha=0.15, linewidth=0.0
            )


def _further_multiples(
    verdict: ComponentVerdict, drawn: _Drawn, threshold: float
) -> list[tuple[float, str]]:
    """Return multiples of a fault beside those it was matched by, that are no noise either."""
    matched = {line.multiple for line in verdict.lines}
    last = float(drawn.hertz[np.flatnonzero(np.isfinite(drawn.level))[-1]])
    numbers = range(1, int(last / verdict.frequency) + 1)
    return [
        (number * verdict.frequency, f"{number}×")
        for number in numbers
        if number not in matched
        and _peak_height(number * verdict.frequency, drawn.hertz, drawn.level) >= threshold
    ]


def _mark_unexplained(axes: Axes, diagnosis: Diagnosis, drawn: _Drawn) -> None:
    """Point at peaks that stand out and that nothing explains."""
    places = [line.frequency for line in diagnosis.unexplained]
    tops = [_peak_height(place, drawn.hertz, drawn.level) for place in places]
    if not places:
        return
    axes.plot(
        places, tops, color="black", linestyle="", marker="$?$", markersize=7.0,
        label=said("unexplained"),
    )  # fmt: skip


def _peak_height(place: float, hertz: Floats, level: Floats) -> float:
    """Return the height of the peak at a frequency, as it is drawn."""
    index = int(np.searchsorted(hertz, place))
    near = level[max(index - _HALF_PEAK, 0) : index + _HALF_PEAK + 1]
    finite = near[np.isfinite(near)]
    return max(float(finite.max()), _FLOOR) if finite.size else 0.0
