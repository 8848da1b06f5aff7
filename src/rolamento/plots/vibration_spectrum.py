"""The spectrum that a diagnosis searched: squared envelope over noise, with the bearing's lines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    label_x,
    label_y,
    number,
)
from rolamento.plots.style import Series, new_figure, series, styled
from rolamento.plots.vibration_words import VibrationWords, vibration_words
from rolamento.plots.weibull_words import legend_in_columns
from rolamento.plots.words import plot_words
from rolamento.vibration.diagnosis import COMPONENTS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.diagnosis import Component, Diagnosis

__all__ = ["envelope_figure", "envelope_lines", "line_threshold"]

Floats = NDArray[np.float64]

_FLOOR: Final = -3.0
"""dB; deeper than that noise tells nothing."""
_ROOM: Final = 4.0
_LEAST_TOP: Final = 16.0
_HALF_PEAK: Final = 3
"""Lines on either side in which the top of a peak is looked for."""
_LABEL_GAP: Final = 4.0
_RATIOS: Final = np.geomspace(1.0, 1e6, 4000)


class _Drawn(NamedTuple):
    """The line that marks stand on, and the words they get."""

    hertz: Floats
    level: Floats
    words: VibrationWords
    mark: str


def line_threshold(diagnosis: Diagnosis) -> float:
    """Power over the mean of the noise from which one line alone is told not to be noise; dB.

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


def envelope_figure(
    diagnosis: Diagnosis, *, band: int | None = None, title: str = "", language: str = "en"
) -> Figure:
    """Draw the spectrum of the squared envelope of a band, as `envelope_lines`, with a title."""
    with styled():
        figure, axes = new_figure(height=95.0)
        envelope_lines(diagnosis, axes, band=band, language=language)
        if title:
            add_title(figure, title)
    return figure


def envelope_lines(
    diagnosis: Diagnosis,
    axes: Axes | None = None,
    *,
    band: int | None = None,
    language: str = "en",
) -> Axes:
    """Draw the squared envelope's spectrum in a band, and mark where the bearing tells of damage.

    Parameters
    ----------
    diagnosis
        Of `rolamento.vibration.diagnosis.verdict`.
    axes
        To draw on; of a new figure if not given.
    band
        Number in `diagnosis.spectra.bands`; by default that of the clearest fault, of the clearest
        unexplained line if there is none, or else of the best match.
    language
        ``"en"`` or ``"pt"``.

    Returns
    -------
    Axes
        Those given. Found lines have filled marks and their multiples, sidebands hollow ones;
        parts without a finding have the span in which they were looked for.
    """
    shared, words = plot_words(language), vibration_words(language)
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        place = diagnosis.clearest_band if band is None else band
        above = diagnosis.spectra.above_noise[place]
        known = np.flatnonzero(np.isfinite(above))
        if known.size == 0:
            return empty_frame(axes, words.no_lines)
        hertz = diagnosis.spectra.order * diagnosis.shaft_frequency
        level = _decibels(above)
        threshold = line_threshold(diagnosis)
        axes.plot(hertz, np.maximum(level, _FLOOR), color="#606060", linewidth=0.6)
        axes.axhline(0.0, color=GREY, linewidth=0.9, label=words.noise)
        axes.axhline(threshold, color=GREY, linestyle="--", linewidth=0.9, label=words.threshold)
        top = max(_LEAST_TOP, threshold + 1.0, float(np.nanmax(level))) + _ROOM
        axes.set_ylim(_FLOOR, top)
        axes.set_xlim(0.0, float(hertz[known[-1]]))
        _shaft(axes, diagnosis, words)
        drawn = _Drawn(hertz, level, words, shared.decimal_mark)
        for number_of, part in enumerate(COMPONENTS):
            _mark(axes, diagnosis, part, series(number_of), drawn)
        _mark_unexplained(axes, diagnosis, drawn)
        label_x(axes, words.frequency, shared)
        label_y(axes, words.above_noise, shared)
        low, high = diagnosis.spectra.bands[place]
        title = words.in_band.format(low=number(low, shared), high=number(high, shared))
        legend_in_columns(axes, title=title)
    return axes


def _decibels(above: Floats) -> Floats:
    with np.errstate(divide="ignore", invalid="ignore"):
        level = 10.0 * np.log10(above)
    return np.where(np.isneginf(level), _FLOOR, level)


def _shaft(axes: Axes, diagnosis: Diagnosis, words: VibrationWords) -> None:
    """Tick the multiples of the shaft at the foot: they are left out of the search."""
    frequency, end = diagnosis.shaft_frequency, axes.get_xlim()[1]
    if frequency <= 0.0 or end / frequency > 1000.0:
        return
    places = frequency * np.arange(1, int(end / frequency) + 1)
    axes.plot(
        places, np.full(len(places), 0.015), transform=axes.get_xaxis_transform(), color="black",
        linestyle="", marker="|", markersize=5.0, label=words.shaft, clip_on=False,
    )  # fmt: skip


def _mark(
    axes: Axes,
    diagnosis: Diagnosis,
    part: Component,
    look: Series,
    drawn: _Drawn,
) -> None:
    hertz, level, words, mark = drawn
    verdict, name = diagnosis.of(part), words.parts[part]
    if verdict.band is not None:
        keywords: dict[str, Any] = {"color": look.color, "linestyle": "", "marker": look.marker}
        lines = [(line.frequency, f"{line.multiple:g}×") for line in verdict.lines]
        tops = [_top(place, hertz, level) for place, _ in lines]
        axes.plot(
            [place for place, _ in lines], tops, **keywords, label=words.found.format(part=name)
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
                sides, [_top(place, hertz, level) for place in sides], **keywords,
                markerfacecolor="white", label=words.sidebands.format(part=name),
            )  # fmt: skip
    elif verdict.verdict == "nothing_found":
        nominal = verdict.nominal_order * diagnosis.shaft_frequency
        if nominal < axes.get_xlim()[1]:
            axes.axvline(nominal, **look.keywords(), alpha=0.8, linewidth=1.1, zorder=1.5,
                         label=words.expected.format(part=name))  # fmt: skip
            spread = diagnosis.tolerance * nominal
            axes.axvspan(
                nominal - spread, nominal + spread, color=look.color, alpha=0.15, linewidth=0.0
            )


def _mark_unexplained(axes: Axes, diagnosis: Diagnosis, drawn: _Drawn) -> None:
    """Point at lines that stand out and belong to nothing that is known."""
    places = [line.frequency for line in diagnosis.unexplained]
    tops = [_top(place, drawn.hertz, drawn.level) for place in places]
    if not places:
        return
    axes.plot(
        places, tops, color="black", linestyle="", marker="$?$", markersize=7.0,
        label=drawn.words.unexplained,
    )  # fmt: skip


def _top(place: float, hertz: Floats, level: Floats) -> float:
    """Return the height of the peak at a frequency, as it is drawn."""
    index = int(np.searchsorted(hertz, place))
    near = level[max(index - _HALF_PEAK, 0) : index + _HALF_PEAK + 1]
    finite = near[np.isfinite(near)]
    return max(float(finite.max()), _FLOOR) if finite.size else 0.0
