"""The picture of a kurtogram: how impulsive a signal is, over frequency and bandwidth."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from rolamento.plots.frame import (
    add_title,
    empty_frame,
    figure_of,
    label_x,
    legend_above,
    number,
    shown_text,
)
from rolamento.plots.style import new_figure, styled
from rolamento.plots.vibration_words import VibrationWords, vibration_words
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.demodulation import Kurtogram
    from rolamento.vibration.signal import Signal

__all__ = ["kurtogram_figure", "kurtogram_map", "kurtogram_of"]

MOST_SAMPLES: Final = 2**20
"""Of a signal that a picture is made of: more narrow the scatter and cost seconds."""
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
    signal: Signal,
    *,
    band: tuple[float, float] | None = None,
    title: str = "",
    language: str = "en",
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
    language
        ``"en"`` or ``"pt"``.
    """
    with styled():
        figure, axes = new_figure(height=95.0)
        kurtogram_map(kurtogram_of(signal), axes, band=band, language=language)
        if title:
            add_title(figure, title)
    return figure


def kurtogram_map(
    found: Kurtogram | None,
    axes: Axes | None = None,
    *,
    band: tuple[float, float] | None = None,
    language: str = "en",
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
    language
        ``"en"`` or ``"pt"``.
    """
    shared, words = plot_words(language), vibration_words(language)
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        if found is None:
            return empty_frame(axes, words.too_short)
        values = found.picture()
        half, rows = 0.5 * found.rate, len(found.levels)
        picture = axes.imshow(
            values, extent=(0.0, half, rows, 0.0), aspect="auto", interpolation="nearest",
            vmin=min(0.0, float(values.min())),
        )  # fmt: skip
        axes.grid(visible=False)
        _bar(axes, picture, words, shared)
        _rows(axes, found, shared, words)
        label_x(axes, words.frequency, shared)
        _frames(axes, found, band, shared, words)
    return axes


def _bar(axes: Axes, picture: object, words: VibrationWords, shared: PlotWords) -> None:
    bar = figure_of(axes).colorbar(picture, ax=axes, pad=0.02)  # type: ignore[arg-type]
    bar.set_label(words.kurtosis, parse_math=False)
    bar.ax.yaxis.set_major_formatter(lambda value, _: number(value, shared))
    bar.ax.tick_params(labelsize=8.0)


def _rows(axes: Axes, found: Kurtogram, shared: PlotWords, words: VibrationWords) -> None:
    """Number the rows by their bandwidths."""
    step = 1 if len(found.levels) <= 9 else 2
    places = range(0, len(found.levels), step)
    labels = [number(found.levels[place].bandwidth, shared, 4) for place in places]
    axes.set_yticks([place + 0.5 for place in places], labels)
    axes.set_ylabel(words.bandwidth, parse_math=False)


def _frames(
    axes: Axes,
    found: Kurtogram,
    band: tuple[float, float] | None,
    shared: PlotWords,
    words: VibrationWords,
) -> None:
    """Frame the band that stands out most in its row; show the given one across all rows.

    By its significance: of thousands of narrow bands one is always impulsive by chance.
    """
    best, rows = found.best("significance"), len(found.levels)
    row = [level.level for level in found.levels].index(best.level)
    low, high = best.band
    label = words.best_band.format(low=number(low, shared), high=number(high, shared))
    frame = Rectangle(
        (low, row), high - low, 1.0, fill=False, edgecolor=_BEST, linewidth=1.6,
        label=shown_text(label), zorder=4.0,
    )  # fmt: skip
    axes.add_patch(frame)
    handles: list[Rectangle] = [frame]
    if band is not None:
        text = words.fault_band.format(low=number(band[0], shared), high=number(band[1], shared))
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
