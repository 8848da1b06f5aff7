"""Tolerance bands, drawn: how each output is distributed, and which inputs move it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts.axes_units import PERCENT, readable_unit
from rolamento.charts.frame import GREY, empty_frame, label_x, label_y, require
from rolamento.charts.style import MILLIMETRE, WIDTH, series, styled
from rolamento.charts.texts import capitalised, number, shown_text
from rolamento.errors import InputError
from rolamento.studies.names import variable_name
from rolamento.studies.sensitivity import RankCorrelations, ToleranceStudy
from rolamento.studies.tolerance import FINEST, FLAT, ToleranceBand, ToleranceBands
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Floats = NDArray[np.float64]

MOST_OUTPUTS: Final = 6
"""Maximum number of outputs of a figure: the first of the study."""

_ROW: Final = 58.0
_MOST_INPUTS: Final = 8
_FILL: Final = "#9FC6DF"
_BINS: Final = (8, 50)


def tolerance_figure(study: ToleranceStudy) -> Figure:
    """Draw the distribution of each output with its percentiles, and the inputs that move it.

    Percentiles are lines, their confidence intervals bands. Beside them stand the rank
    correlations with their intervals, the strongest at the top.

    Parameters
    ----------
    study
        From `rolamento.tasks.studies.tolerance`, without further axes; its first six outputs are
        drawn.

    Raises
    ------
    InputError
        If the study has axes beside the samples, or no scattered input.
    """
    require(study, ToleranceStudy, "study", "rolamento.tasks.studies.tolerance(file)")
    bands, ranks = study.bands, study.ranks
    if ranks is None:
        raise InputError(said("has no scattered input to draw"), field="scatter.fields")
    if bands.without_result.ndim or any(band.axes for band in bands.bands):
        raise InputError(
            said("has axes besides its samples; a figure of tolerance bands shows one point"),
            field="axes",
            example="rolamento plot RESULT",
        )
    chosen = bands.bands[:MOST_OUTPUTS]
    with styled():
        height = (_ROW * len(chosen) + 8.0) * MILLIMETRE
        figure = Figure(figsize=(WIDTH * MILLIMETRE, height))
        grid = figure.add_gridspec(len(chosen), 2, width_ratios=[3, 2])
        for row, band in enumerate(chosen):
            values = study.samples.values(band.name)
            left, right = (figure.add_subplot(grid[row, column]) for column in (0, 1))
            _distribution(left, values, bands, band)
            _ranking(right, ranks, band.name)
        failed = int(bands.without_result)
        if failed:
            text = said(
                "{failed} of {count} samples have no result and are left out",
                failed=failed,
                count=bands.samples,
            )
            figure.suptitle(text, fontsize=9.0, color="#B00000", parse_math=False)
    return figure


def _distribution(axes: Axes, values: Floats, bands: ToleranceBands, band: ToleranceBand) -> None:
    axes.set_title(shown_text(_name(band.name, band.long_name), 60), loc="left", parse_math=False)
    there = values[np.isfinite(values)]
    if not there.size:
        empty_frame(axes, said("no sample has a result"))
        return
    unit = readable_unit(band.units, there, band.name)
    bins = int(np.clip(np.ceil(2.0 * there.size ** (1.0 / 3.0)), *_BINS))
    weights = np.full(there.size, PERCENT.factor / there.size)
    drawn = unit.of(there)
    if np.ptp(there) <= max(
        FLAT * np.abs(there).max(), FINEST.get(band.units, 0.0)
    ):  # a histogram needs a width
        constant = 0.0 if np.abs(there).max() <= FINEST.get(band.units, 0.0) else drawn[0]
        value = f"{number(float(constant))} {unit.symbol}".removesuffix(" –")
        empty_frame(axes, said("does not vary: {value}", value=value))
        return
    axes.hist(
        drawn, bins=bins, weights=weights, facecolor=_FILL, edgecolor=series(0).color, linewidth=0.5
    )
    for percent, value, low, high in zip(
        bands.percentiles, band.percentile, band.low, band.high, strict=True
    ):
        if np.isfinite(value):
            _percentile(axes, percent, float(unit.of(value)))
            ends = unit.of([value if np.isnan(end) else end for end in (low, high)])
            axes.axvspan(float(ends[0]), float(ends[1]), color="black", alpha=0.12, linewidth=0.0)
    label_x(axes, unit.symbol)
    label_y(axes, PERCENT.label(said("Share of the samples")))
    axes.margins(y=0.18)


def _percentile(axes: Axes, percent: float, place: float) -> None:
    axes.axvline(place, color="black", linewidth=0.9, linestyle="-" if percent == 50.0 else "--")
    axes.text(
        place,
        0.98,
        f" {number(percent, 6)} %",
        transform=axes.get_xaxis_transform(),
        rotation=90.0,
        fontsize=7.0,
        ha="right",
        va="top",
    )


def _ranking(axes: Axes, ranks: RankCorrelations, output: str) -> None:
    order = ranks.ranking(output)[:_MOST_INPUTS]
    if not order:
        empty_frame(axes, said("does not vary"))
        return
    values, low, high = (array[list(order)] for array in ranks.telling(output))
    place = np.arange(len(order))[::-1]
    colours = [series(0).color if value >= 0.0 else series(1).color for value in values]
    hatches = ["" if value >= 0.0 else "///" for value in values]
    axes.barh(place, np.abs(values), height=0.6, color=colours, hatch=hatches, edgecolor="white")
    size = np.abs(np.stack([low, high]))
    reach = np.where(
        low * high < 0.0, [np.zeros_like(low), size.max(axis=0)], np.sort(size, axis=0)
    )
    for x, (nearest, farthest) in zip(place, reach.T, strict=True):
        axes.plot([nearest, farthest], [x, x], color="black", linewidth=1.0)
    names = [_name(ranks.inputs[index]) for index in order]
    signs = ["+" if value >= 0.0 else "−" for value in values]
    axes.set_yticks(
        place,
        [f"{shown_text(name, 26)} ({sign})" for name, sign in zip(names, signs, strict=True)],
        parse_math=False,
    )
    axes.set_xlim(0.0, 1.0)
    axes.grid(visible=False, axis="y")
    axes.axvline(0.0, color=GREY, linewidth=0.6)
    partial = said("Partial rank correlation")
    label_x(axes, partial if ranks.correlated else said("Rank correlation"))


def _name(variable: str, long_name: str = "") -> str:
    return capitalised(variable_name(variable) or long_name or variable.replace("_", " "))
