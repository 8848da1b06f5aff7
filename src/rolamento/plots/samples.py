"""Studies of samples: how an output is distributed, and how it goes with an input."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.plots.axes_units import NONE, PERCENT, ReadableUnit
from rolamento.plots.frame import GREY, label_x, label_y, legend_above, number
from rolamento.plots.study import (
    SAMPLE,
    Column,
    StudyData,
    input_of,
    inputs,
    most_telling,
    output_of,
)
from rolamento.plots.style import in_style, new_figure, series
from rolamento.plots.sweep import nothing_to_draw
from rolamento.plots.words import ENGLISH, PlotWords

__all__ = ["study_histogram", "study_scatter"]

Floats = NDArray[np.float64]

_PERCENTS: Final = ((5.0, "--"), (50.0, "-"), (95.0, "-."))
_FEWEST_BINS: Final = 5
_MOST_BINS: Final = 60


@in_style
def study_histogram(
    study: StudyData,
    variable: str = "",
    axes: Axes | None = None,
    *,
    words: PlotWords = ENGLISH,
) -> Axes:
    """Draw how an output is distributed over the samples, with median and percentiles.

    Parameters
    ----------
    study
        A Dataset of `rolamento.studies`.
    variable
        Name of the output; the most telling one if not given.
    axes
        To draw on; of a new figure if not given.
    words
        Language of the labels.

    Returns
    -------
    Axes
        Those given; shares are of the samples that have a result.

    Raises
    ------
    InputError
        If there is no such output, or it does not vary along samples alone.
    """
    output = _along_samples(study, variable, "histogram", words)
    axes = new_figure()[1] if axes is None else axes
    values = output.values[np.isfinite(output.values)]
    if not values.size:
        return nothing_to_draw(axes, study, words)
    bins = int(np.clip(np.ceil(2.0 * values.size ** (1.0 / 3.0)), _FEWEST_BINS, _MOST_BINS))
    weights = np.full(values.size, PERCENT.factor / values.size)
    axes.hist(
        values,
        bins=bins,
        weights=weights,
        facecolor="#9FC6DF",
        edgecolor=series(0).color,
        linewidth=0.6,
    )
    _draw_percentiles(axes, values, output.unit, words, upright=True)
    _count_missing(axes, output.values, words)
    label_x(axes, output.label, words)
    label_y(axes, PERCENT.label(words.share), words)
    legend_above(axes)
    return axes


@in_style
def study_scatter(
    study: StudyData,
    variable: str = "",
    axes: Axes | None = None,
    *,
    over: str = "",
    words: PlotWords = ENGLISH,
) -> Axes:
    """Draw an output of every sample over an input, with median and percentiles of the output.

    Parameters and errors as of `study_histogram`; `over` names an input, or another output; the
    first input if not given.
    """
    output = _along_samples(study, variable, "scatter", words)
    across = input_of(study, over or _first_input(study), words)
    if across.dims != (SAMPLE,):
        raise InputError("does not vary along the samples", field="over", value=across.name)
    axes = new_figure()[1] if axes is None else axes
    values = output.values[np.isfinite(output.values)]
    if not values.size:
        return nothing_to_draw(axes, study, words)
    axes.plot(
        across.values,
        output.values,
        "o",
        color=series(0).color,
        markersize=3.0,
        markeredgewidth=0.0,
        alpha=0.5,
        rasterized=True,
    )
    _draw_percentiles(axes, values, output.unit, words, upright=False)
    _count_missing(axes, output.values, words)
    label_x(axes, across.label, words)
    if across.texts:
        axes.set_xticks(np.arange(float(len(across.texts))), list(across.texts))
    label_y(axes, output.label, words)
    legend_above(axes)
    return axes


def _along_samples(study: StudyData, variable: str, kind: str, words: PlotWords) -> Column:
    output = output_of(study, variable or most_telling(study), words)
    if output.dims != (SAMPLE,):
        raise InputError(
            f"needs an output that varies along samples alone; {output.name} varies along"
            f" {', '.join(output.dims) or 'nothing'}",
            field="kind",
            value=kind,
            example="lines or map",
        )
    return output


def _first_input(study: StudyData) -> str:
    """Return the first input that was drawn at random."""
    along = (name for name in inputs(study) if tuple(study.coords[name].dims) == (SAMPLE,))
    name = next((name for name in along if name != SAMPLE), "")
    if not name:
        raise InputError("is missing: the study names no input", field="over")
    return name


def _draw_percentiles(
    axes: Axes, values: Floats, unit: ReadableUnit, words: PlotWords, *, upright: bool
) -> None:
    for percent, style in _PERCENTS:
        value = float(np.percentile(values, percent))
        name = words.median if percent == 50.0 else f"{percent:.0f} %"
        draw = axes.axvline if upright else axes.axhline
        label = f"{name}: {number(value, words)} {unit.symbol}".removesuffix(f" {NONE.symbol}")
        draw(value, color="black", linewidth=1.1, linestyle=style, label=label)


def _count_missing(axes: Axes, values: Floats, words: PlotWords) -> None:
    """Say in the legend how many samples have no result."""
    missing = int(np.isnan(values).sum())
    if missing:
        label = words.no_result_count.format(count=missing, total=values.size)
        axes.add_line(Line2D([], [], color=GREY, linestyle="", marker="x", label=label))
