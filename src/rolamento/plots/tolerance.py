"""Tolerance bands, drawn: how each output is distributed, and which inputs move it."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import (
    Axis,
    Bars,
    Chart,
    Labels,
    Line,
    Look,
    Mark,
    Zone,
    nothing,
    series_look,
    step_line,
)
from rolamento.charts.axes_units import PERCENT, readable_unit
from rolamento.charts.drawing import draw
from rolamento.charts.frame import require
from rolamento.charts.palette import LIGHT
from rolamento.charts.style import MILLIMETRE, WIDTH, styled
from rolamento.charts.texts import capitalised, number, shown_text
from rolamento.errors import InputError
from rolamento.studies.names import variable_name
from rolamento.studies.sensitivity import RankCorrelations, ToleranceStudy
from rolamento.studies.tolerance import (
    FINEST,
    ToleranceBand,
    ToleranceBands,
    histogram,
    varies,
)
from rolamento.words import said

Floats = NDArray[np.float64]

MOST_OUTPUTS: Final = 6
"""Maximum number of outputs of a figure: the first of the study."""

_ROW: Final = 58.0
_MOST_INPUTS: Final = 8


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
        grid = figure.subplots(len(chosen), 2, squeeze=False, width_ratios=[3, 2])
        for (left, right), band in zip(grid, chosen, strict=True):
            values = study.samples.values(band.name)
            draw(distribution_chart(values, bands, band), left)
            called = shown_text(_name(band.name, band.long_name), 60)
            left.set_title(called, loc="left", parse_math=False)
            draw(ranking_chart(ranks, band.name), right)
        failed = int(bands.without_result)
        if failed:
            text = said(
                "{failed} of {count} samples have no result and are left out",
                failed=failed,
                count=bands.samples,
            )
            figure.suptitle(text, fontsize=9.0, color=LIGHT["bad"], parse_math=False)
    return figure


def distribution_chart(values: Floats, bands: ToleranceBands, band: ToleranceBand) -> Chart:
    """Return how an output is distributed, its percentiles as lines, their intervals as bands."""
    there = values[np.isfinite(values)]
    if not there.size:
        return nothing(said("no sample has a result"))
    unit = readable_unit(band.units, there, band.name)
    drawn = unit.of(there)
    if not varies(there, band.units):  # a histogram needs a width
        constant = 0.0 if np.abs(there).max() <= FINEST.get(band.units, 0.0) else drawn[0]
        value = f"{number(float(constant))} {unit.symbol}".removesuffix(" –")
        return nothing(said("does not vary: {value}", value=value))
    shares, edges = histogram(drawn)
    series: list[Line | Labels] = [
        Line(*step_line(edges, PERCENT.of(shares)), "", series_look(0), filled=True)
    ]
    upright = Axis(label=unit.symbol, unit=unit.symbol)
    marks, zones = [], []
    for percent, value, low, high in zip(
        bands.percentiles, band.percentile, band.low, band.high, strict=True
    ):
        if not np.isfinite(value):
            continue
        at = float(unit.of(value))
        look = Look("ink", "solid" if percent == 50.0 else "dash", width=0.65)
        marks.append(Mark(at, "", look, "x"))
        text = (f"{number(percent, 6)} %",)
        series.append(Labels(np.array([at]), np.zeros(1), text, ("along",), height=0.99))
        ends = unit.of([value if np.isnan(end) else end for end in (low, high)])
        zones.append(Zone(float(ends[0]), float(ends[1]), "", "ink", "x"))
    return Chart(
        tuple(series),
        upright,
        Axis(limits=(0.0, 120.0 * float(shares.max())),
             name=said("Share of the samples"), unit=PERCENT.symbol),
        "; ".join(
            f"{number(percent, 6)} %: {upright.with_unit(number(float(unit.of(value)), 4))}"
            for percent, value in zip(bands.percentiles, band.percentile, strict=True)
        ),
        title=_name(band.name, band.long_name),
        marks=tuple(marks),
        zones=tuple(zones),
    )  # fmt: skip


def ranking_chart(ranks: RankCorrelations, output: str) -> Chart:
    """Return the rank correlations of an output with their intervals, the strongest first."""
    order = ranks.ranking(output)[:_MOST_INPUTS]
    if not order:
        return nothing(said("does not vary"))
    values, low, high = (array[list(order)] for array in ranks.telling(output))
    size = np.abs(np.stack([low, high]))
    crosses = low * high < 0.0
    nearest = np.where(crosses, 0.0, size.min(axis=0))
    names = [shown_text(_name(ranks.inputs[index]), 26) for index in order]
    signs = ["+" if value >= 0.0 else "−" for value in values]
    series: list[Bars | Line] = []
    for rises, look in ((True, series_look(0)), (False, Look("outer", hollow=True))):
        own = np.flatnonzero((values >= 0.0) == rises)
        if own.size:
            foot = np.zeros(own.size)
            series.append(Bars(np.abs(values[own]), tuple(own.tolist()), "", look, start=foot))
    x = np.stack([nearest, size.max(axis=0), np.full(len(order), np.nan)], axis=1).ravel()
    interval = Line(x, np.repeat(np.arange(float(len(order))), 3), "", Look("ink", width=0.7))
    partial = said("Partial rank correlation")
    return Chart(
        (*series, interval),
        Axis(limits=(0.0, 1.0), label=partial if ranks.correlated else said("Rank correlation")),
        Axis(categories=tuple(f"{a} ({b})" for a, b in zip(names, signs, strict=True))),
        f"{names[0]}: {number(float(values[0]), 3)}",
        title=_name(output),
    )


def _name(variable: str, long_name: str = "") -> str:
    return capitalised(variable_name(variable) or long_name or variable.replace("_", " "))
