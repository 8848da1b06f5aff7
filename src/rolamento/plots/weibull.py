"""What life tests look like: probability paper, and regions of equal likelihood.

On *probability paper* lives that follow Weibull's distribution lie on a straight line. Across runs
time, in its logarithm; upright ln ln 1/(1 - F), numbered by F, the share that has failed. *Regions*
show which shapes and lives go together with the data.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, NullLocator
from numpy.typing import NDArray

from rolamento.charts.frame import GREY, decades, empty_frame, legend_in_columns, panels
from rolamento.charts.style import Series, new_figure, series, styled
from rolamento.charts.texts import no_result, number, shown_text
from rolamento.weibull import EXPONENTS, plot_ordinate, plotting_positions
from rolamento.weibull.summary import has_ranks
from rolamento.words import manner, marked, said, said_in

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.weibull import (
        Band,
        GroupSummary,
        LifeTest,
        LifeTestSummary,
        LikelihoodRegion,
        WeibullFit,
    )

__all__ = ["contour_figure", "likelihood_contour", "weibull_figure", "weibull_paper"]

Floats = NDArray[np.float64]

FITS: Final[Mapping[str, str]] = {
    "maximum_likelihood": marked("maximum likelihood"),
    "unbiased": marked("unbiased shape"),
    "rank_regression_x_on_y": marked("rank regression, X on Y"),
    "rank_regression_y_on_x": marked("rank regression, Y on X"),
    "three_parameter": marked("three parameters"),
    "fixed_shape": marked("known shape"),
}

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
_CONTOUR_HEIGHT: Final = 105.0
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
_RATING_SHAPE: Final = EXPONENTS["ball"]


def weibull_figure(summary: LifeTestSummary, bands: Mapping[str, Band] | None = None) -> Figure:
    """Draw probability paper, as `weibull_paper`, with the title of the data."""
    entries = len(summary.groups) + len(summary.request.calculated) + 4
    entries += 2 * (summary.system is not None)
    entries += any(group.goodness.bent is not None for group in summary.groups)
    return panels(
        lambda axes: weibull_paper(summary, bands, axes),
        title=summary.test.title,
        height=_HEIGHT + _LEGEND_LINE * (entries // 2),
    )


def weibull_paper(
    summary: LifeTestSummary, bands: Mapping[str, Band] | None = None, axes: Axes | None = None
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

    Of failure modes all failures are drawn too, hollow and black, with the line of all modes
    together, which is a curve here. Where the data contradict a straight line, so is the broken one
    that fits best.

    Returns
    -------
    Axes
        Those given. Failures stand at their median ranks; suspended bearings, and failures between
        inspections, which have no rank, at the foot of the frame.
    """
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        found = bands or {}
        if not summary.has_result and not summary.test.failures:
            return empty_frame(axes, no_result())
        limits = _limits(summary, found)
        for index, group in enumerate(summary.groups):
            _draw_group(axes, group, index, found.get(group.name), limits)
        if len(summary.groups) == 1:
            _other_fits(axes, summary.groups[0], limits)
        _draw_system(axes, summary, limits[1])
        _mark_calculated(axes, summary)
        decades(axes, "x", limits[0])
        _percent_axis(axes, limits[1])
        axes.set_xlabel(said("Time ({unit})", unit=shown_text(summary.test.unit)), parse_math=False)
        legend_in_columns(axes)
    return axes


def _draw_group(
    axes: Axes,
    group: GroupSummary,
    index: int,
    band: Band | None,
    limits: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    look, test = series(index), group.test
    label: str | None = _label_of(group)
    if group.main.converged:
        axes.plot(*_line(group.main, limits[1]), label=label, zorder=2.5, **look.keywords())
        label = None
    _draw_dog_leg(axes, group, look, limits[1])
    if test.failures and group.ranked:
        points = plotting_positions(test)
        axes.plot(
            points.times, plot_ordinate(points.failed_share), color=look.color, marker=look.marker,
            linestyle="", markersize=5.0, zorder=3.0, label=label,
        )  # fmt: skip
        label = None
    if band is not None and band.converged:
        _draw_band(axes, band, look, limits[0])
    _at_the_foot(axes, test, look, index, label)


def _draw_system(axes: Axes, summary: LifeTestSummary, upright: tuple[float, float]) -> None:
    """Draw the bearing as a whole, which fails by the first of its modes."""
    system, test = summary.system, summary.test
    if system is None:
        return
    if has_ranks(test):
        points = plotting_positions(test)
        axes.plot(
            points.times, plot_ordinate(points.failed_share), color="black", marker="o",
            markerfacecolor="none", linestyle="", markersize=4.0, zorder=2.9,
            label=said("all failures"),
        )  # fmt: skip
    if system.converged:
        ordinate = np.linspace(*upright, _CURVE)
        axes.plot(
            system.life_at_ordinate(ordinate), ordinate, color="black", linewidth=1.3, zorder=2.6,
            label=said("all modes together"),
        )  # fmt: skip


def _draw_dog_leg(
    axes: Axes, group: GroupSummary, look: Series, upright: tuple[float, float]
) -> None:
    bend = group.goodness.bent
    if bend is None:
        return
    ordinate = np.linspace(*upright, _CURVE)
    label = said("dog-leg (p = {p})", p=number(bend.p_value, 2))
    axes.plot(
        bend.life_at_ordinate(ordinate), ordinate, color=look.color, linestyle=(0, (2, 2)),
        linewidth=1.4, zorder=2.4, label=_once(axes, label),
    )  # fmt: skip


def _label_of(group: GroupSummary) -> str:
    test, fit = group.test, group.main
    name = f"{shown_text(group.name, 24)}: " if group.name else ""
    failed = said("{failed}/{size} failed", failed=test.failures, size=test.size)
    if not fit.converged:
        return f"{name}{failed}"
    shape, life = number(fit.shape, 3), number(fit.l10, 3)
    return f"{name}β = {shape}, L10 = {life} {shown_text(fit.unit)}, {failed}"


def _line(fit: WeibullFit, upright: tuple[float, float]) -> tuple[Floats, Floats]:
    """Times and ordinates of a fit from the lowest to the highest share."""
    ordinate = np.linspace(*upright, _CURVE)
    return fit.life_at_ordinate(ordinate), ordinate


def _draw_band(axes: Axes, band: Band, look: Series, across: tuple[float, float]) -> None:
    """Fill between the bounds of the lives; draw those of one side alone."""
    ordinate, confidence = plot_ordinate(band.failed_share), number(100.0 * band.confidence)
    if band.sides != "two":
        label, limit = (
            (said("lower bound ({confidence} %)", confidence=confidence), band.lower)
            if band.sides == "lower"
            else (said("upper bound ({confidence} %)", confidence=confidence), band.upper)
        )
        axes.plot(
            limit, ordinate, color=look.color, linestyle=look.linestyle, linewidth=1.0,
            label=_once(axes, label), zorder=2.0,
        )  # fmt: skip
        return
    # what lies beyond the frame is as good as on its edge
    lower, upper = (
        np.clip(limit, 0.5 * across[0], 2.0 * across[1]) for limit in (band.lower, band.upper)
    )
    label = said("{confidence} % bounds", confidence=confidence)
    axes.fill_betweenx(
        ordinate, lower, upper, color=look.color, alpha=0.15, linewidth=0.0, zorder=1.2,
        label=_once(axes, label),
    )  # fmt: skip
    for limit in (lower, upper):
        axes.plot(limit, ordinate, color=look.color, linewidth=0.7, alpha=0.7, zorder=1.3)


def _other_fits(
    axes: Axes, group: GroupSummary, limits: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    others = [fit for fit in group.fits[1:] if fit.converged]
    for fit, line in zip(others, _OTHERS, strict=False):
        name = said(FITS[fit.method])
        axes.plot(
            *_line(fit, limits[1]), color=GREY, linestyle=line, linewidth=0.9, label=name,
            zorder=2.0,
        )  # fmt: skip


def _at_the_foot(axes: Axes, test: LifeTest, look: Series, index: int, label: str | None) -> None:
    """Mark suspended bearings and failures between inspections along the axis.

    label: of the group, where neither line nor points have it.
    """
    height, place = _RUG * (index + 0.6), axes.get_xaxis_transform()
    suspended_label = said_in("bearings", "suspended")
    suspended = np.unique(test.times[~test.failed])
    if suspended.size:
        axes.plot(
            suspended, np.full(suspended.size, height), color=look.color, transform=place,
            label=_once(axes, f"{label}, {suspended_label}" if label else suspended_label),
            zorder=2.8, **_SUSPENDED,
        )  # fmt: skip
    between = ~np.isnan(test.lower)
    if between.any():
        ends = np.unique(np.stack([test.lower[between], test.times[between]], axis=1), axis=0)
        label = _once(axes, said("failed between inspections"))
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


def _mark_calculated(axes: Axes, summary: LifeTestSummary) -> None:
    """Mark calculated lives at the share that is to have failed by then."""
    ordinate = summary.request.lives[0].log_risk
    for index, (label, value) in enumerate(_calculated_lives(summary)):
        axes.plot(
            value, ordinate, marker=_MARKS[index % len(_MARKS)], markersize=9.0, linestyle="",
            color="black", markerfacecolor="white", markeredgewidth=1.1, zorder=4.0, label=label,
        )  # fmt: skip


def _limits(
    summary: LifeTestSummary, bands: Mapping[str, Band]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ends of both axes: all data, the lives asked for and their bounds within reason."""
    shares = [_LEAST, _MOST, *(1.0 - r for r in summary.request.reliabilities)]
    times: list[float] = [float(summary.test.times.min()), float(summary.test.times.max())]
    low, high = times[0] / _FARTHEST, times[1] * _FARTHEST
    whole = [summary.test] if summary.system is not None else []
    for test in (*(group.test for group in summary.groups), *whole):
        if test.failures and has_ranks(test):
            positions = plotting_positions(test)
            shares += [float(positions.failed_share.min()), float(positions.failed_share.max())]
    for group in summary.groups:
        lives = [summary.request.lives[0].name]
        for bound in group.bounds:
            if bound.quantity in lives:
                times += [bound.lower, bound.upper]
        if group.main.converged:
            times += [float(x) for x in group.main.life_at([1.0 - _LEAST, 1.0 - _MOST])]
    inside = [float(np.clip(time, low, high)) for time in times if np.isfinite(time) and time > 0.0]
    # a calculated life is what the reader asks about, however far
    inside += summary.request.calculated.values()
    upright = plot_ordinate(np.array([min(shares) / 1.15, 1.0 - (1.0 - max(shares)) / 1.15]))
    return (0.8 * min(inside), 1.25 * max(inside)), (float(upright[0]), float(upright[1]))


def _percent_axis(axes: Axes, upright: tuple[float, float]) -> None:
    """Number the upright axis by shares; those of L10 and of the scale are marked."""
    ticks = [p for p in _PERCENTAGES if upright[0] <= plot_ordinate(p / 100.0) <= upright[1]]
    places = plot_ordinate(np.array(ticks) / 100.0)
    axes.set_yticks(places, [number(tick) for tick in ticks])
    axes.set_yticks([], minor=True)
    axes.set_ylim(*upright)
    axes.set_ylabel(said("Failed (%)"), parse_math=False)
    axes.axhline(float(plot_ordinate(0.1)), color=GREY, linewidth=0.7, zorder=1.0)


def _calculated_lives(summary: LifeTestSummary) -> Iterator[tuple[str, float]]:
    """Give the calculated lives with their labels."""
    life = summary.request.lives[0].name.replace(".", manner().mark)
    for name, value in summary.request.calculated.items():
        shown = f"{number(value)} {shown_text(summary.test.unit)}"
        shown = f"{shown_text(name, 24)}, {shown}" if name else shown
        yield said("calculated {life}: {name}", life=life, name=shown), value


# --- regions of equal likelihood -------------------------------------------------------------


def contour_figure(summary: LifeTestSummary, regions: Mapping[str, LikelihoodRegion]) -> Figure:
    """Draw regions, as `likelihood_contour`, with the title of the data."""
    entries = (
        len(summary.groups) + len(summary.groups[0].fits) + len(summary.request.calculated) + 3
    )
    return panels(
        lambda axes: likelihood_contour(summary, regions, axes),
        title=summary.test.title,
        height=_CONTOUR_HEIGHT + _LEGEND_LINE * (entries // 2),
    )


def likelihood_contour(
    summary: LifeTestSummary, regions: Mapping[str, LikelihoodRegion], axes: Axes | None = None
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

    Returns
    -------
    Axes
        Those given: the shape across, the life upright, both by their logarithms. Calculated lives
        are lines where the regions are of that life.
    """
    with styled():
        axes = new_figure(height=_CONTOUR_HEIGHT)[1] if axes is None else axes
        drawn = [
            (index, group, regions[group.name])
            for index, group in enumerate(summary.groups)
            if group.name in regions and regions[group.name].converged
        ]
        if not drawn:
            return empty_frame(axes, no_result())
        handles: list[Line2D] = []
        for index, group, region in drawn:
            handles += _draw_region(axes, region, group, index)
        if len(summary.groups) == 1:
            handles += _mark_estimates(axes, drawn[0][1].fits, drawn[0][2])
        handles += _lines_of_calculated(axes, summary, drawn[0][2])
        _set_axes(axes, [region for *_, region in drawn], handles)
        all_drawn = all(region.drawn for *_, region in drawn)
        title = (
            said("regions of equal likelihood, with simulated levels")
            if all_drawn
            else said("regions of equal likelihood, for large samples")
        )
        legend_in_columns(axes, handles, title)
    return axes


def _draw_region(
    axes: Axes, region: LikelihoodRegion, group: GroupSummary, index: int
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
        Line2D([], [], linestyle=style, **keywords, label=f"{name}{number(100.0 * probability)} %")
        for probability, style in zip(sorted(region.probabilities), styles, strict=True)
    ]


def _mark_estimates(
    axes: Axes, fits: Sequence[WeibullFit], region: LikelihoodRegion
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
            markersize=6.0, label=said(FITS[fit.method]), zorder=4.0,
        )  # fmt: skip
    return handles


def _lines_of_calculated(
    axes: Axes, summary: LifeTestSummary, region: LikelihoodRegion
) -> list[Line2D]:
    """Draw calculated lives, where the regions are of the life that they are for."""
    if summary.request.lives[0].name != region.quantity.name:
        return []
    handles: list[Line2D] = []
    for index, (label, value) in enumerate(_calculated_lives(summary)):
        handles.append(
            axes.axhline(
                value, color="black", linewidth=1.0, linestyle=_LINES[(index + 1) % len(_LINES)],
                label=label, zorder=1.8,
            )
        )  # fmt: skip
    return handles


def _set_axes(axes: Axes, regions: Sequence[LikelihoodRegion], handles: list[Line2D]) -> None:
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
    _set_scale(axes, "x", (min(shapes), max(shapes)))
    _set_scale(axes, "y", (min(lives), max(lives)))
    if min(shapes) < _RATING_SHAPE < max(shapes):
        line = axes.axvline(
            _RATING_SHAPE, color=GREY, linewidth=0.9, label=said("10/9 of the rating standards")
        )
        handles.append(line)
    quantity, unit = regions[0].quantity, shown_text(regions[0].fit.unit)
    axes.set_xlabel(said("Shape β"), parse_math=False)
    name = quantity.name.replace(".", manner().mark)
    label = said("Scale η ({unit})", unit=unit) if quantity.name == "scale" else f"{name} ({unit})"
    axes.set_ylabel(label, parse_math=False)


def _set_scale(axes: Axes, axis: str, limits: tuple[float, float]) -> None:
    """Make an axis logarithmic; a short one has even steps, for it has few round decades."""
    decades(axes, axis, limits)
    if limits[1] < _SHORT * limits[0]:
        scaled = getattr(axes, f"{axis}axis")
        scaled.set_major_locator(MaxNLocator(_TICKS, steps=[1, 2, 2.5, 5, 10]))
        scaled.set_minor_locator(NullLocator())
