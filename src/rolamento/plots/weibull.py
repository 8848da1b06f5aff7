"""Probability paper: lives that follow Weibull's distribution lie on a straight line.

Across runs time, in its logarithm; upright ln ln 1/(1 - F), numbered by F, the share that has
failed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    number,
    shown_text,
)
from rolamento.plots.over_field import decades
from rolamento.plots.style import Series, new_figure, series, styled
from rolamento.plots.weibull_words import (
    WeibullPlotWords,
    legend_in_columns,
    weibull_plot_words,
)
from rolamento.plots.words import PlotWords, plot_words
from rolamento.weibull import plotting_positions

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.weibull import Band, GroupSummary, LifeTest, LifeTestSummary, WeibullFit

__all__ = ["weibull_figure", "weibull_paper"]

Floats = NDArray[np.float64]

_HEIGHT: Final = 120.0
_LEGEND_LINE: Final = 4.5
_PERCENTAGES: Final = (
    0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 70.0, 90.0, 95.0,
    99.0, 99.9,
)  # fmt: skip
_LEAST, _MOST = 0.01, 0.99
_CURVE: Final = 200
_SUSPENDED: Final[dict[str, Any]] = {
    "marker": "|", "markersize": 7.0, "markeredgewidth": 1.1, "linestyle": "",
}  # fmt: skip
_RUG: Final = 0.03
"""Height of the first row of ticks over the axis, and of each row over the one before."""
_OTHERS: Final = (":", "-.", "--", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 3)))
_MARKS: Final = ("*", "P", "X", "D", "v")
_MOST_MARKED: Final = 2000
_FARTHEST: Final = 30.0
"""Beyond the data by this factor nothing is shown, however far bounds reach."""


def weibull_figure(
    summary: LifeTestSummary, bands: Mapping[str, Band] | None = None, language: str = "en"
) -> Figure:
    """Draw probability paper, as `weibull_paper`, with the title of the data."""
    entries = len(summary.groups) + len(summary.wanted.calculated) + 4
    with styled():
        figure, axes = new_figure(height=_HEIGHT + _LEGEND_LINE * (entries // 2))
        weibull_paper(summary, bands, axes, language=language)
        if summary.test.title:
            add_title(figure, summary.test.title)
    return figure


def weibull_paper(
    summary: LifeTestSummary,
    bands: Mapping[str, Band] | None = None,
    axes: Axes | None = None,
    *,
    language: str = "en",
) -> Axes:
    """Draw failures, suspensions, fitted lines and their bounds on probability paper.

    Parameters
    ----------
    summary
        Of `rolamento.weibull.summary`: each group has a colour of its own. Of a test without
        groups all fits are drawn, the others thinly.
    bands
        Of `rolamento.weibull.band.confidence_band`, by the names of the groups.
    axes
        To draw on; of a new figure if not given.
    language
        ``"en"`` or ``"pt"``.

    Returns
    -------
    Axes
        Those given. Failures stand at their median ranks; suspended bearings, and failures between
        inspections, which have no rank, at the foot of the frame.
    """
    shared, words = plot_words(language), weibull_plot_words(language)
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        found = bands or {}
        if not summary.has_result and not summary.test.failures:
            return empty_frame(axes, shared.no_result)
        limits = _limits(summary, found)
        for index, group in enumerate(summary.groups):
            _group(axes, group, index, found.get(group.name), limits, shared, words)
        if len(summary.groups) == 1:
            _other_fits(axes, summary.groups[0], limits, words)
        _calculated(axes, summary, shared, words)
        decades(axes, "x", limits[0], shared)
        _percent_axis(axes, limits[1], shared, words)
        axes.set_xlabel(words.time.format(unit=shown_text(summary.test.unit)), parse_math=False)
        legend_in_columns(axes)
    return axes


def _group(
    axes: Axes,
    group: GroupSummary,
    index: int,
    band: Band | None,
    limits: tuple[tuple[float, float], tuple[float, float]],
    shared: PlotWords,
    words: WeibullPlotWords,
) -> None:
    look, test = series(index), group.test
    label: str | None = _label(group, shared, words)
    if group.main.converged:
        axes.plot(*_line(group.main, limits[1]), label=label, zorder=2.5, **look.keywords())
        label = None
    if test.failures and group.ranked:
        points = plotting_positions(test)
        axes.plot(
            points.times, _ordinate(points.failed_share), color=look.color, marker=look.marker,
            linestyle="", markersize=5.0, zorder=3.0, label=label,
        )  # fmt: skip
        label = None
    if band is not None and band.converged:
        _band(axes, band, look, limits[0], shared, words)
    _at_the_foot(axes, test, look, index, label, words)


def _label(group: GroupSummary, shared: PlotWords, words: WeibullPlotWords) -> str:
    test, fit = group.test, group.main
    name = f"{shown_text(group.name, 24)}: " if group.name else ""
    failed = words.of_failed.format(failed=test.failures, size=test.size)
    if not fit.converged:
        return f"{name}{failed}"
    shape, life = number(fit.shape, shared, 3), number(fit.l10, shared, 3)
    return f"{name}β = {shape}, L10 = {life} {shown_text(fit.unit)}, {failed}"


def _line(fit: WeibullFit, upright: tuple[float, float]) -> tuple[Floats, Floats]:
    """Times and ordinates of a fit from the lowest to the highest share."""
    ordinate = np.linspace(*upright, _CURVE)
    with np.errstate(over="ignore"):
        return fit.location + fit.scale * np.exp(ordinate / fit.shape), ordinate


def _band(
    axes: Axes,
    band: Band,
    look: Series,
    across: tuple[float, float],
    shared: PlotWords,
    words: WeibullPlotWords,
) -> None:
    """Fill between the bounds of the lives; where nothing failed, draw the lower ones."""
    ordinate, confidence = _ordinate(band.failed_share), number(100.0 * band.confidence, shared)
    if band.sides == "lower":
        label = words.lower_bound.format(confidence=confidence)
        axes.plot(
            band.lower, ordinate, color=look.color, linestyle=look.linestyle, linewidth=1.0,
            label=label, zorder=2.0,
        )  # fmt: skip
        return
    # what lies beyond the frame is as good as on its edge
    lower, upper = (
        np.clip(limit, 0.5 * across[0], 2.0 * across[1]) for limit in (band.lower, band.upper)
    )
    label = words.bounds.format(confidence=confidence)
    axes.fill_betweenx(
        ordinate, lower, upper, color=look.color, alpha=0.15, linewidth=0.0, zorder=1.2,
        label=_once(axes, label),
    )  # fmt: skip
    for limit in (lower, upper):
        axes.plot(limit, ordinate, color=look.color, linewidth=0.7, alpha=0.7, zorder=1.3)


def _other_fits(
    axes: Axes,
    group: GroupSummary,
    limits: tuple[tuple[float, float], tuple[float, float]],
    words: WeibullPlotWords,
) -> None:
    others = [fit for fit in group.fits[1:] if fit.converged]
    for fit, line in zip(others, _OTHERS, strict=False):
        name = words.fits.get(fit.method, fit.method)
        axes.plot(
            *_line(fit, limits[1]), color=GREY, linestyle=line, linewidth=0.9, label=name,
            zorder=2.0,
        )  # fmt: skip


def _at_the_foot(
    axes: Axes,
    test: LifeTest,
    look: Series,
    index: int,
    label: str | None,
    words: WeibullPlotWords,
) -> None:
    """Mark suspended bearings and failures between inspections along the axis.

    label: of the group, where neither line nor points have it.
    """
    height, place = _RUG * (index + 0.6), axes.get_xaxis_transform()
    suspended = np.unique(test.times[~test.failed])
    if suspended.size:
        axes.plot(
            suspended, np.full(suspended.size, height), color=look.color, transform=place,
            label=_once(axes, f"{label}, {words.suspended}" if label else words.suspended),
            zorder=2.8, **_SUSPENDED,
        )  # fmt: skip
    between = ~np.isnan(test.lower)
    if between.any():
        ends = np.unique(np.stack([test.lower[between], test.times[between]], axis=1), axis=0)
        label = _once(axes, words.inspected)
        for row, (first, last) in enumerate(ends[:_MOST_MARKED]):
            axes.plot(
                [max(first, 1e-3 * last), last], 2 * [height + 0.4 * _RUG * (1 + row % 8)],
                color=look.color, transform=place, linewidth=2.0, solid_capstyle="butt",
                label=label, zorder=2.7,
            )  # fmt: skip
            label = None


def _once(axes: Axes, label: str) -> str | None:
    """Return a label unless the legend has it."""
    return None if label in axes.get_legend_handles_labels()[1] else label


def _calculated(
    axes: Axes, summary: LifeTestSummary, shared: PlotWords, words: WeibullPlotWords
) -> None:
    """Mark calculated lives at the share that is to have failed by then."""
    life = summary.wanted.lives[0]
    ordinate = life.log_risk
    name_of_life = life.name.replace(".", shared.decimal_mark)
    for index, (name, value) in enumerate(summary.wanted.calculated.items()):
        shown = f"{number(value, shared)} {shown_text(summary.test.unit)}"
        shown = f"{shown_text(name, 24)}, {shown}" if name else shown
        axes.plot(
            value, ordinate, marker=_MARKS[index % len(_MARKS)], markersize=9.0, linestyle="",
            color="black", markerfacecolor="white", markeredgewidth=1.1, zorder=4.0,
            label=words.calculated.format(life=name_of_life, name=shown),
        )  # fmt: skip


def _limits(
    summary: LifeTestSummary, bands: Mapping[str, Band]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ends of both axes: all data, the lives that were wanted and their bounds within reason."""
    shares = [_LEAST, _MOST, *(1.0 - r for r in summary.wanted.reliabilities)]
    times: list[float] = [float(summary.test.times.min()), float(summary.test.times.max())]
    low, high = times[0] / _FARTHEST, times[1] * _FARTHEST
    for group in summary.groups:
        if group.test.failures and group.ranked:
            positions = plotting_positions(group.test)
            shares += [float(positions.failed_share.min()), float(positions.failed_share.max())]
        lives = [summary.wanted.lives[0].name]
        for bound in group.bounds:
            if bound.quantity in lives:
                times += [bound.lower, bound.upper]
        if group.main.converged:
            times += [float(x) for x in group.main.life_at([1.0 - _LEAST, 1.0 - _MOST])]
    inside = [float(np.clip(time, low, high)) for time in times if np.isfinite(time) and time > 0.0]
    # a calculated life is what the reader asks about, however far
    inside += summary.wanted.calculated.values()
    upright = _ordinate(np.array([min(shares) / 1.15, 1.0 - (1.0 - max(shares)) / 1.15]))
    return (0.8 * min(inside), 1.25 * max(inside)), (float(upright[0]), float(upright[1]))


def _percent_axis(
    axes: Axes, upright: tuple[float, float], shared: PlotWords, words: WeibullPlotWords
) -> None:
    """Number the upright axis by shares; those of L10 and of the scale are marked."""
    ticks = [p for p in _PERCENTAGES if upright[0] <= _ordinate(np.array(p / 100.0)) <= upright[1]]
    places = _ordinate(np.array(ticks) / 100.0)
    axes.set_yticks(places, [number(tick, shared) for tick in ticks])
    axes.set_yticks([], minor=True)
    axes.set_ylim(*upright)
    axes.set_ylabel(words.failed_share, parse_math=False)
    axes.axhline(float(_ordinate(np.array(0.1))), color=GREY, linewidth=0.7, zorder=1.0)


def _ordinate(failed_share: Any) -> Floats:
    with np.errstate(divide="ignore"):
        return np.asarray(np.log(-np.log1p(-np.asarray(failed_share, dtype=np.float64))))
