"""Regions of equal likelihood: which shapes and lives go together with the data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, NullLocator

from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    number,
    shown_text,
)
from rolamento.plots.over_field import decades
from rolamento.plots.style import new_figure, series, styled
from rolamento.plots.weibull_words import (
    WeibullPlotWords,
    legend_in_columns,
    weibull_plot_words,
)
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.weibull import GroupSummary, LifeTestSummary, LikelihoodRegion, WeibullFit

__all__ = ["contour_figure", "likelihood_contour"]

_HEIGHT: Final = 105.0
_LEGEND_LINE: Final = 4.5
_LOOKS: Final[Mapping[str, tuple[str, str]]] = {
    "maximum_likelihood": ("o", "black"),
    "unbiased": ("D", "black"),
    "rank_regression_x_on_y": ("^", "black"),
    "rank_regression_y_on_x": ("v", "black"),
    "fixed_shape": ("s", "black"),
}
"""Markers of the fits of two parameters; a third parameter has no place here."""
_LINES: Final[tuple[Any, ...]] = ("-", "--", ":")
_SHORT, _TICKS = 4.0, 7
_RATING_SHAPE: Final = 10.0 / 9.0


def contour_figure(
    summary: LifeTestSummary, regions: Mapping[str, LikelihoodRegion], language: str = "en"
) -> Figure:
    """Draw regions, as `likelihood_contour`, with the title of the data."""
    entries = len(summary.groups) + len(summary.groups[0].fits) + len(summary.wanted.calculated) + 3
    with styled():
        figure, axes = new_figure(height=_HEIGHT + _LEGEND_LINE * (entries // 2))
        likelihood_contour(summary, regions, axes, language=language)
        if summary.test.title:
            add_title(figure, summary.test.title)
    return figure


def likelihood_contour(
    summary: LifeTestSummary,
    regions: Mapping[str, LikelihoodRegion],
    axes: Axes | None = None,
    *,
    language: str = "en",
) -> Axes:
    """Draw the regions within which shape and life lie with 50, 90 and 95 %.

    Parameters
    ----------
    summary
        Of `rolamento.weibull.summary`: of a test without groups the estimates of all methods
        of two parameters are marked.
    regions
        Of `rolamento.weibull.likelihood_region`, by the names of the groups; all of one
        quantity.
    axes
        To draw on; of a new figure if not given.
    language
        ``"en"`` or ``"pt"``.

    Returns
    -------
    Axes
        Those given: the shape across, the life upright, both by their logarithms. Calculated lives
        are lines where the regions are of that life.
    """
    shared, words = plot_words(language), weibull_plot_words(language)
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        drawn = [
            (index, group, regions[group.name])
            for index, group in enumerate(summary.groups)
            if group.name in regions and regions[group.name].converged
        ]
        if not drawn:
            return empty_frame(axes, shared.no_result)
        handles: list[Line2D] = []
        for index, group, region in drawn:
            handles += _region(axes, region, group, index, shared, words)
        if len(summary.groups) == 1:
            handles += _estimates(axes, drawn[0][1].fits, drawn[0][2], words)
        handles += _calculated(axes, summary, drawn[0][2], shared, words)
        _axes(axes, [region for *_, region in drawn], shared, words, handles)
        all_drawn = all(region.drawn for *_, region in drawn)
        title = words.drawn if all_drawn else words.chi_square
        legend_in_columns(axes, handles, title)
    return axes


def _region(
    axes: Axes,
    region: LikelihoodRegion,
    group: GroupSummary,
    index: int,
    shared: PlotWords,
    words: WeibullPlotWords,
) -> list[Line2D]:
    """Draw one group's regions, the innermost darkest; return what stands for them."""
    look, levels = series(index), sorted(region.levels)
    axes.contourf(
        region.shape, region.life, region.fall, levels=[0.0, *levels],
        colors=[look.color] * len(levels), alpha=0.12, zorder=1.2,
    )  # fmt: skip
    for level in levels:  # each again up to the outermost, so that the inner ones are darker
        axes.contourf(
            region.shape, region.life, region.fall, levels=[0.0, level],
            colors=[look.color], alpha=0.1, zorder=1.3,
        )  # fmt: skip
    styles = [_LINES[i % len(_LINES)] for i in range(len(levels))]
    axes.contour(
        region.shape, region.life, region.fall, levels=levels, colors=[look.color],
        linestyles=styles, linewidths=1.1, zorder=2.0,
    )  # fmt: skip
    if group.name:  # its maximum; of a test without groups all estimates are marked
        life = region.quantity.at(np.array([region.fit.shape]), np.log([region.fit.scale]))
        axes.plot(region.fit.shape, life, color=look.color, marker=look.marker, zorder=4.0)
    name = f"{shown_text(group.name, 24)}: " if group.name else ""
    keywords: dict[str, Any] = {"color": look.color, "linewidth": 1.1}
    return [
        Line2D(
            [], [], linestyle=style, **keywords,
            label=name + words.region.format(probability=number(100.0 * probability, shared)),
        )
        for probability, style in zip(sorted(region.probabilities), styles, strict=True)
    ]  # fmt: skip


def _estimates(
    axes: Axes, fits: Sequence[WeibullFit], region: LikelihoodRegion, words: WeibullPlotWords
) -> list[Line2D]:
    handles: list[Line2D] = []
    for fit in fits:
        if fit.method not in _LOOKS or not fit.converged:
            continue
        marker, colour = _LOOKS[fit.method]
        life = region.quantity.at(np.array([fit.shape]), np.log([fit.scale]))
        filled = colour if fit.method == "maximum_likelihood" else "white"
        handles += axes.plot(
            fit.shape, life, marker=marker, color=colour, markerfacecolor=filled, linestyle="",
            markersize=6.0, label=words.fits[fit.method], zorder=4.0,
        )  # fmt: skip
    return handles


def _calculated(
    axes: Axes,
    summary: LifeTestSummary,
    region: LikelihoodRegion,
    shared: PlotWords,
    words: WeibullPlotWords,
) -> list[Line2D]:
    """Draw calculated lives, where the regions are of the life that they are for."""
    life = summary.wanted.lives[0]
    if life.name != region.quantity.name:
        return []
    handles: list[Line2D] = []
    name_of_life = life.name.replace(".", shared.decimal_mark)
    for index, (name, value) in enumerate(summary.wanted.calculated.items()):
        shown = f"{number(value, shared)} {shown_text(summary.test.unit)}"
        shown = f"{shown_text(name, 24)}, {shown}" if name else shown
        handles.append(
            axes.axhline(
                value, color="black", linewidth=1.0, linestyle=_LINES[(index + 1) % len(_LINES)],
                label=words.calculated.format(life=name_of_life, name=shown), zorder=1.8,
            )
        )  # fmt: skip
    return handles


def _axes(
    axes: Axes,
    regions: Sequence[LikelihoodRegion],
    shared: PlotWords,
    words: WeibullPlotWords,
    handles: list[Line2D],
) -> None:
    shapes = [float(shape) for region in regions for shape in region.shape[[0, -1]]]
    lives = [float(life) for region in regions for life in region.life[[0, -1]]]
    # lines and marks beyond the regions widen the frame, but by little
    placed = [line for line in handles if np.size(line.get_ydata())]
    upright = [float(np.asarray(line.get_ydata())[0]) for line in placed]
    points = [line for line in placed if line.get_linestyle() == "None"]
    across = [float(np.asarray(line.get_xdata())[0]) for line in points]
    low, high = min(lives) / 3.0, max(lives) * 3.0
    lives += [1.1 * y if y > max(lives) else y / 1.1 for y in upright if low < y < high]
    shapes += [x for x in across if min(shapes) / 2.0 < x < max(shapes) * 2.0]
    _scaled(axes, "x", (min(shapes), max(shapes)), shared)
    _scaled(axes, "y", (min(lives), max(lives)), shared)
    if min(shapes) < _RATING_SHAPE < max(shapes):
        line = axes.axvline(_RATING_SHAPE, color=GREY, linewidth=0.9, label=words.rating_shape)
        handles.append(line)
    quantity, unit = regions[0].quantity, shown_text(regions[0].fit.unit)
    axes.set_xlabel(words.shape, parse_math=False)
    name = quantity.name.replace(".", shared.decimal_mark)
    label = words.scale if quantity.name == "scale" else words.life
    axes.set_ylabel(label.format(life=name, unit=unit), parse_math=False)


def _scaled(axes: Axes, axis: str, limits: tuple[float, float], shared: PlotWords) -> None:
    """Make an axis logarithmic; a short one has even steps, for it has few round decades."""
    decades(axes, axis, limits, shared)
    if limits[1] < _SHORT * limits[0]:
        scaled = getattr(axes, f"{axis}axis")
        scaled.set_major_locator(MaxNLocator(_TICKS, steps=[1, 2, 2.5, 5, 10]))
        scaled.set_minor_locator(NullLocator())
