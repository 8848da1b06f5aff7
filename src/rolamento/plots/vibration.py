"""Pictures of a vibration signal and of its diagnosis: waveform, kurtogram, envelope spectrum.

A kurtogram shows how impulsive a signal is, over frequency and bandwidth; the spectrum that a
diagnosis searched is that of the squared envelope over noise, with the bearing's lines.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import (
    Axis,
    Chart,
    Field,
    Labels,
    Line,
    Look,
    Mark,
    Spread,
    Zone,
    nothing,
    series_look,
)
from rolamento.charts.courses import course, extremes
from rolamento.charts.drawing import draw, figure
from rolamento.charts.record import Side
from rolamento.charts.texts import capitalised, number
from rolamento.vibration.diagnosis import COMPONENTS
from rolamento.words import manner, said
from rolamento.words.naming import part_name
from rolamento.words.quantities import called

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.demodulation import Kurtogram
    from rolamento.vibration.diagnosis import ComponentVerdict, Diagnosis
    from rolamento.vibration.signal import Signal


Floats = NDArray[np.float64]
Span = tuple[float, float]
_COLUMNS: Final = 1500
"""Number of columns of a long waveform; in each, the least and the greatest sample are drawn."""
_PERIODS: Final = 12.0
"""Number of periods of a fault that are shown of its waveform."""
_MOST_MARKS: Final = 200
_PHASES: Final = 64
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
    return figure(
        waveform_chart(signal, **_of_fault(signal, diagnosis)),
        kurtogram_chart(kurtogram_of(signal), None if fault is None else fault.band),
        envelope_chart(diagnosis),
        title=title,
        height=230.0,
        own=True,
    )


def impacts_figure(signal: Signal, diagnosis: Diagnosis, *, title: str = "") -> Figure:
    """Draw the waveform of a diagnosis: of a fault a few periods, with its impacts marked."""
    chart = waveform_chart(signal, **_of_fault(signal, diagnosis))
    return figure(chart, title=title, height=70.0)


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
    signal: Signal, *, period: float | None = None, span: Span | None = None, title: str = ""
) -> Figure:
    """Draw a waveform, as `waveform`, with a title."""
    return figure(waveform_chart(signal, period=period, span=span), title=title, height=70.0)


def waveform(
    signal: Signal,
    axes: Axes | None = None,
    *,
    period: float | None = None,
    part: str = "",
    span: Span | None = None,
    band: Span | None = None,
) -> Axes:
    """Draw a signal over time, as `waveform_chart` has it, on axes; by default of a new figure."""
    return draw(
        waveform_chart(signal, period=period, part=part, span=span, band=band), axes, height=70.0
    )


def waveform_chart(
    signal: Signal,
    *,
    period: float | None = None,
    part: str = "",
    span: Span | None = None,
    band: Span | None = None,
) -> Chart:
    """Return a signal over time, with the impacts of a fault marked if its period is given.

    Parameters
    ----------
    signal
        Of which a long stretch is drawn by its extremes.
    period
        To mark; s. The marks begin where the envelope, folded by the period, is greatest.
    part
        What the period belongs to, for the legend.
    span
        To show, from and to; s. By default all.
    band
        Of the envelope that decides where the marks begin; Hz.
    """
    first, last = _sample_range(signal, span)
    samples = signal.samples[first:last]
    if samples.size < 2:
        return nothing(said("The signal has fewer than two samples here."))
    marks: list[Mark] = []
    if period is not None:
        name = said("period, {part}: {period:.4 ms}", part=part, period=period)
        look = Look("grey", "dot", width=0.65)
        times = _impacts(signal, (first, last), period, band)
        marks = [Mark(time, "" if place else name, look, "x") for place, time in enumerate(times)]
    unit = _UNITS.get(signal.unit, signal.unit)
    quantity = capitalised(called(signal.quantity))
    return Chart(
        (_samples(samples, first, signal.rate),),
        Axis(limits=(first / signal.rate, last / signal.rate), name=said("Time"), unit="s"),
        Axis(quantity, unit),
        marks[0].name
        if marks
        else extremes(
            [("", np.arange(first, last) / signal.rate, samples)],
            Axis(unit="s"),
            Axis(quantity, unit),
        ),
        marks=tuple(marks),
    )


def _sample_range(signal: Signal, span: tuple[float, float] | None) -> tuple[int, int]:
    count = len(signal.samples)
    if span is None:
        return 0, count
    first = min(max(round(span[0] * signal.rate), 0), count)
    return first, min(max(round(span[1] * signal.rate), first), count)


def _samples(samples: Floats, first: int, rate: float) -> Line | Spread:
    """Return samples as a line, or so many that they merge as the span of each column."""
    if len(samples) <= 4 * _COLUMNS:
        times = (first + np.arange(len(samples))) / rate
        return Line(times, samples, "", Look("inner", width=0.5))
    step = -(-len(samples) // _COLUMNS)
    starts = np.arange(0, len(samples), step)
    least, most = (np.minimum.reduceat(samples, starts), np.maximum.reduceat(samples, starts))
    middles = np.asarray((first + starts + 0.5 * step) / rate, dtype=np.float64)
    return Spread(middles, least, most, "", Look("inner"), solid=True)


def _impacts(
    signal: Signal, place: tuple[int, int], period: float, band: Span | None
) -> list[float]:
    """Return the impacts of a fault: a comb that begins where the folded envelope is greatest."""
    start, end = place[0] / signal.rate, place[1] / signal.rate
    if not 0.0 < period < end - start or (end - start) / period > _MOST_MARKS:
        return []
    times: list[float] = np.arange(
        start + _phase(signal, place, period, band), end, period
    ).tolist()
    return times


def _phase(
    signal: Signal, place: tuple[int, int], period: float, band: tuple[float, float] | None
) -> float:
    """Time from the first sample to the first impact, to a part of the period."""
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
_COLOURS: Final = 40


def kurtogram_of(signal: Signal) -> Kurtogram | None:
    """Return the kurtogram of a signal's first million samples; None if it has too few."""
    from rolamento.vibration.demodulation import kurtogram

    if len(signal.samples) < _LEAST_SAMPLES or np.ptp(signal.samples) == 0.0:
        return None
    part = signal.samples[:MOST_SAMPLES]
    return kurtogram(replace(signal, samples=part, speed=None))


def kurtogram_figure(signal: Signal, *, band: Span | None = None, title: str = "") -> Figure:
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
    return figure(kurtogram_chart(kurtogram_of(signal), band), title=title, height=95.0)


def kurtogram_chart(found: Kurtogram | None, band: Span | None = None) -> Chart:
    """Return a kurtogram: a row for each bandwidth, a frame about the band that stands out most.

    That is judged by its significance: of thousands of narrow bands one is always impulsive by
    chance.

    Parameters
    ----------
    found
        The kurtogram; None of a signal that is too short or does not change.
    band
        To mark as well, dashed; Hz.
    """
    if found is None:
        return nothing(said("The signal is too short for a kurtogram."))
    values, rows = found.picture(), len(found.levels)
    half, lowest = 0.5 * found.rate, min(0.0, float(values.min()))
    scale = Axis(limits=(lowest, float(values.max())), label=said("Kurtosis above that of noise"))
    x, y = np.linspace(0.0, half, values.shape[1] + 1), np.linspace(0.0, rows, len(values) + 1)
    colours = Field(x, y, values, scale, _COLOURS)
    best = found.best("significance")
    row = [level.level for level in found.levels].index(best.level)
    (low, high), most = best.band, Look("outer", width=1.15)
    name = said("stands out most: {low:.4} to {high:.4 Hz}", low=low, high=high)
    frames = [_frame(best.band, (row, row + 1.0), name, most)]
    if band is not None:
        text = said("fault clearest: {low:.4} to {high:.4 Hz}", low=band[0], high=band[1])
        frames.append(_frame(band, (0.03, rows - 0.03), text, Look("white", "dash", width=0.9)))
    step = 1 if rows <= 9 else 2
    ticks = ((place + 0.5, number(found.levels[place].bandwidth)) for place in range(0, rows, step))
    return Chart(
        (colours, *frames),
        Axis(limits=(0.0, half), name=said("Frequency"), unit="Hz"),
        Axis(limits=(float(rows), 0.0), ticks=tuple(ticks), name=said("Bandwidth"), unit="Hz"),
        name,
    )


def _frame(across: Span, upright: Span, name: str, look: Look) -> Line:
    (left, right), (low, high) = across, upright
    x, y = np.array([left, right, right, left, left]), np.array([low, low, high, high, low])
    return Line(x, y, name, look)


# --- the spectrum that was searched --------------------------------------------------------------


_FLOOR: Final = -3.0
"""dB; deeper than that noise means nothing."""
_ROOM: Final = 4.0
_LEAST_TOP: Final = 16.0
_HALF_PEAK: Final = 3
"""Lines on either side in which the top of a peak is looked for."""
_MOST_TURNS: Final = 1000.0
_RATIOS: Final = np.geomspace(1.0, 1e6, 4000)


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
    return figure(envelope_chart(diagnosis, band), title=title, height=95.0)


def envelope_lines(
    diagnosis: Diagnosis, axes: Axes | None = None, *, band: int | None = None
) -> Axes:
    """Draw the spectrum of `envelope_chart` on axes; of a new figure if not given."""
    return draw(envelope_chart(diagnosis, band), axes, height=95.0)


def envelope_chart(diagnosis: Diagnosis, band: int | None = None) -> Chart:
    """Return the squared envelope's spectrum in a band, with the frequencies of the bearing.

    Parameters
    ----------
    diagnosis
        Of `rolamento.vibration.diagnosis.verdict`.
    band
        Number in `diagnosis.spectra.bands`; by default that of the clearest fault, of the clearest
        unexplained peak if there is none, or else of the best match.

    Returns
    -------
    Chart
        Found lines have filled marks and their multiples, sidebands hollow ones; parts without a
        finding have the span in which they were looked for.
    """
    place = diagnosis.clearest_band if band is None else band
    above = diagnosis.spectra.above_noise[place]
    known = np.flatnonzero(np.isfinite(above))
    if known.size == 0:
        return nothing(said("The signal allows no envelope spectrum."))
    hertz = diagnosis.spectra.order * diagnosis.shaft_frequency
    level, end = _decibels(above), float(hertz[known[-1]])
    threshold, grey = line_threshold(diagnosis), Look("grey", width=0.65)
    chance = said("above this, a single peak is not noise")
    dashed = replace(grey, dash="dash")
    marks = [Mark(0.0, said("noise, mean"), grey), Mark(threshold, chance, dashed)]
    zones: list[Zone] = []
    spectrum = _Drawn(hertz, level, threshold)
    series: list[Line | Labels] = [
        Line(hertz, np.maximum(level, _FLOOR), "", Look("grey", width=0.45))
    ]
    series += _turns(diagnosis, end)
    found = []
    for number_of, part in enumerate(COMPONENTS):
        look, verdict = series_look(number_of), diagnosis.of(part)
        name = part_name(part, diagnosis.element)
        if verdict.band is not None:
            found.append(
                said("{part}, found at {frequency:.4 Hz}", part=name, frequency=verdict.frequency)
            )
            series += _found(verdict, name, look, spectrum)
        elif verdict.verdict == "nothing_found":
            nominal = verdict.nominal_order * diagnosis.shaft_frequency
            if nominal < end:
                expected = said("{part}, expected", part=name)
                marks.append(Mark(nominal, expected, replace(look, width=0.8), "x"))
                spread = diagnosis.tolerance * nominal
                zones.append(Zone(nominal - spread, nominal + spread, "", look.color, "x"))
    others = [line.frequency for line in diagnosis.unexplained]
    if others:
        series.append(_on_peaks(others, said("unexplained"), Look("ink", mark="query"), spectrum))
    top = max(_LEAST_TOP, threshold + 1.0, float(np.nanmax(level))) + _ROOM
    low, high = diagnosis.spectra.bands[place]
    return Chart(
        tuple(series),
        Axis(limits=(0.0, end), name=said("Frequency"), unit="Hz"),
        Axis(limits=(_FLOOR, top), name=said("Envelope² over noise"), unit="dB"),
        "; ".join(found)
        or course(
            said("no fault found; spectrum"),
            hertz,
            np.maximum(level, _FLOOR),
            Axis(unit="Hz"),
            Axis(unit="dB"),
        ),
        marks=tuple(marks),
        zones=tuple(zones),
        over_names=said("Band {low:.4} to {high:.4 Hz}", low=low, high=high),
    )


class _Drawn(NamedTuple):
    """The line that marks stand on, and the threshold of a line that is not noise."""

    hertz: Floats
    level: Floats
    threshold: float


def _decibels(above: Floats) -> Floats:
    with np.errstate(divide="ignore", invalid="ignore"):
        level = 10.0 * np.log10(above)
    return np.where(np.isneginf(level), _FLOOR, level)


def _turns(diagnosis: Diagnosis, end: float) -> Iterator[Line]:
    """Yield the multiples of the shaft at the foot: they are left out of the search."""
    frequency = diagnosis.shaft_frequency
    if frequency > 0.0 and end / frequency <= _MOST_TURNS:
        places = frequency * np.arange(1.0, int(end / frequency) + 1.0)
        yield Line(places, np.zeros(len(places)), said("multiples of the shaft speed"),
                   Look("ink", mark="tick", width=0.85), "points", height=0.015)  # fmt: skip


def _found(
    verdict: ComponentVerdict, name: str, look: Look, drawn: _Drawn
) -> Iterator[Line | Labels]:
    """Yield the lines of a fault with their multiples, and its sidebands."""
    lines = [(line.frequency, f"{line.multiple:g}×") for line in verdict.lines]
    lines += _further_multiples(verdict, drawn)
    point = replace(look, width=0.7)
    tops = _on_peaks([at for at, _ in lines], said("{part}, found", part=name), point, drawn)
    yield tops
    texts = tuple(text.replace(".", manner().mark) for _, text in lines)
    sides: list[Side] = ["above"] * len(texts)
    yield Labels(tops.x, tops.y, texts, tuple(sides), look.color)
    if verdict.sidebands:
        places = [line.frequency for line in verdict.sidebands]
        hollow = replace(point, hollow=True)
        yield _on_peaks(places, said("{part}, sidebands", part=name), hollow, drawn)


def _on_peaks(places: list[float], name: str, look: Look, drawn: _Drawn) -> Line:
    tops = [_peak_height(place, drawn.hertz, drawn.level) for place in places]
    return Line(np.array(places), np.array(tops), name, look, "points")


def _further_multiples(verdict: ComponentVerdict, drawn: _Drawn) -> list[tuple[float, str]]:
    """Return multiples of a fault beside those it was matched by, that are no noise either."""
    matched = {line.multiple for line in verdict.lines}
    last = float(drawn.hertz[np.flatnonzero(np.isfinite(drawn.level))[-1]])
    numbers = range(1, int(last / verdict.frequency) + 1)
    return [
        (number * verdict.frequency, f"{number}×")
        for number in numbers
        if number not in matched
        and _peak_height(number * verdict.frequency, drawn.hertz, drawn.level) >= drawn.threshold
    ]


def _peak_height(place: float, hertz: Floats, level: Floats) -> float:
    """Return the height of the peak at a frequency, as it is drawn."""
    index = int(np.searchsorted(hertz, place))
    near = level[max(index - _HALF_PEAK, 0) : index + _HALF_PEAK + 1]
    finite = near[np.isfinite(near)]
    return max(float(finite.max()), _FLOOR) if finite.size else 0.0
