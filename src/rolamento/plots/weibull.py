"""What life tests look like: probability paper, and regions of equal likelihood.

On *probability paper* lives that follow Weibull's distribution lie on a straight line. Across runs
time, in its logarithm; upright ln ln 1/(1 - F), numbered by F, the share that has failed. *Regions*
show which shapes and lives go together with the data.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, once, series_look
from rolamento.charts.drawing import figure
from rolamento.charts.texts import no_result, number, shown_text
from rolamento.weibull import EXPONENTS, plot_ordinate, plotting_positions
from rolamento.weibull.summary import has_ranks
from rolamento.words import manner, marked, said, said_in

if TYPE_CHECKING:
    from rolamento.weibull import (
        Band,
        GroupSummary,
        LifeTest,
        LifeTestSummary,
        LikelihoodRegion,
        WeibullFit,
    )

__all__ = ["contour_figure", "paper_chart", "regions_chart", "weibull_figure"]

Floats = NDArray[np.float64]
Ends = tuple[float, float]

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
_RUG: Final = 0.03
"""Height of the first row of ticks over the axis, and of each row over the one before."""
_ROWS: Final = 8
"""Rows in which intervals of inspections lie over one another."""
_OTHERS: Final = ("dot", "dashdot", "dash", "dashdotdot", "fine")
_MARKS: Final = ("star", "cross", "x", "diamond", "triangle-down")
_MOST_MARKED: Final = 2000
_FARTHEST: Final = 30.0
"""Beyond the data by this factor nothing is shown, however far bounds reach."""
_CONTOUR_HEIGHT: Final = 105.0
_ESTIMATES: Final[Mapping[str, str]] = {
    "maximum_likelihood": "circle",
    "unbiased": "diamond",
    "rank_regression_x_on_y": "triangle-up",
    "rank_regression_y_on_x": "triangle-down",
    "fixed_shape": "square",
}
"""Marks of the fits of two parameters; a third parameter has no place here."""
_DASHES: Final = ("solid", "dash", "dot")
_RATING_SHAPE: Final = EXPONENTS["ball"]


def weibull_figure(summary: LifeTestSummary, bands: Mapping[str, Band] | None = None) -> Figure:
    """Draw probability paper, as `paper_chart` has it, with the title of the data."""
    return _figure(paper_chart(summary, bands), summary, _HEIGHT)


def _figure(chart: Chart, summary: LifeTestSummary, height: float) -> Figure:
    """Draw a chart with the title of the data, the higher the more names it has."""
    names = sum(bool(one.name) for one in chart.lines) + sum(bool(one.name) for one in chart.marks)
    tall = height + _LEGEND_LINE * (names // 2)
    return figure(chart, title=summary.test.title, height=tall)


def paper_chart(summary: LifeTestSummary, bands: Mapping[str, Band] | None = None) -> Chart:
    """Return failures, suspensions, fitted lines and their bounds on probability paper.

    Parameters
    ----------
    summary
        Of `rolamento.weibull.summary`: each group has a colour of its own. Of a test without
        groups all fits are drawn, the others thinly.
    bands
        Of `rolamento.weibull.band.confidence_band`, by the names of the groups.

    Of failure modes all failures are drawn too, hollow and black, with the line of all modes
    together, which is a curve here. Where the data contradict a straight line, so is the broken one
    that fits best.

    Returns
    -------
    Chart
        Failures stand at their median ranks; suspended bearings, and failures between
        inspections, which have no rank, at the foot of the frame.
    """
    if not summary.has_result and not summary.test.failures:
        return nothing(no_result())
    bands = bands or {}
    across, upright = _limits(summary, bands)
    ordinate = np.linspace(*upright, _CURVE)
    series = [
        line
        for index, group in enumerate(summary.groups)
        for line in _group(group, index, bands.get(group.name), across, ordinate)
    ]
    if len(summary.groups) == 1:
        others = [fit for fit in summary.groups[0].fits[1:] if fit.converged]
        series += [
            Line(fit.life_at_ordinate(ordinate), ordinate, said(FITS[fit.method]),
                 Look("grey", dash, width=0.65))
            for fit, dash in zip(others, _OTHERS, strict=False)
        ]  # fmt: skip
    series += _system(summary, ordinate)
    risk = summary.request.lives[0].log_risk
    series += [
        Line(np.array([value]), np.array([risk]), label,
             Look("ink", mark=_MARKS[index % len(_MARKS)], hollow=True, width=1.5), "points")
        for index, (label, value) in enumerate(_calculated_lives(summary))
    ]  # fmt: skip
    shown = [p for p in _PERCENTAGES if upright[0] <= plot_ordinate(p / 100.0) <= upright[1]]
    ticks = tuple((float(plot_ordinate(p / 100.0)), number(p)) for p in shown)
    return Chart(
        once(series),
        Axis(limits=across, log=True,
             name=said("Time"), unit=shown_text(summary.test.unit)),
        Axis(limits=upright, ticks=ticks, name=said("Failed"), unit="%"),
        "; ".join(map(_label_of, summary.groups)),
        marks=(Mark(float(plot_ordinate(0.1)), "", Look("grey", width=0.5)),),
    )  # fmt: skip


def _group(
    group: GroupSummary, index: int, band: Band | None, across: Ends, ordinate: Floats
) -> Iterator[Line]:
    """Yield the line, the points and the bounds of a group; the first of them has its name."""
    look, test, label = series_look(index), group.test, _label_of(group)
    if group.main.converged:
        yield Line(group.main.life_at_ordinate(ordinate), ordinate, label, look)
        label = ""
    if (bend := group.goodness.bent) is not None:
        name = said("dog-leg (p = {p})", p=number(bend.p_value, 2))
        yield Line(bend.life_at_ordinate(ordinate), ordinate, name, Look(look.color, "fine"))
    if test.failures and group.ranked:
        points = plotting_positions(test)
        y = plot_ordinate(points.failed_share)
        yield Line(points.times, y, label, replace(look, width=0.85), "points")
        label = ""
    if band is not None and band.converged:
        yield _bounds(band, look, across)
    yield from _at_the_foot(test, look, index, label, across[0])


def _system(summary: LifeTestSummary, ordinate: Floats) -> Iterator[Line]:
    """Yield the bearing as a whole, which fails by the first of its modes."""
    system, test = summary.system, summary.test
    if system is None:
        return
    if has_ranks(test):
        points = plotting_positions(test)
        y = plot_ordinate(points.failed_share)
        look = Look("ink", hollow=True, width=0.7)
        yield Line(points.times, y, said("all failures"), look, "points")
    if system.converged:
        name = said("all modes together")
        yield Line(system.life_at_ordinate(ordinate), ordinate, name, Look("ink"))


def _label_of(group: GroupSummary) -> str:
    test, fit = group.test, group.main
    name = f"{shown_text(group.name, 24)}: " if group.name else ""
    failed = said("{failed}/{size} failed", failed=test.failures, size=test.size)
    if not fit.converged:
        return f"{name}{failed}"
    shape, life = number(fit.shape, 3), number(fit.l10, 3)
    return f"{name}β = {shape}, L10 = {life} {shown_text(fit.unit)}, {failed}"


def _bounds(band: Band, look: Look, across: Ends) -> Line:
    """Return what lies between the bounds of the lives; the bound where it is of one side."""
    ordinate, confidence = plot_ordinate(band.failed_share), number(100.0 * band.confidence)
    thin = replace(look, width=0.7)
    if band.sides == "lower":
        label = said("lower bound ({confidence} %)", confidence=confidence)
        return Line(band.lower, ordinate, label, thin)
    if band.sides == "upper":
        label = said("upper bound ({confidence} %)", confidence=confidence)
        return Line(band.upper, ordinate, label, thin)
    # what lies beyond the frame is as good as on its edge
    lower, upper = (
        np.clip(limit, 0.5 * across[0], 2.0 * across[1]) for limit in (band.lower, band.upper)
    )
    x, y = np.r_[lower, upper[::-1], lower[:1]], np.r_[ordinate, ordinate[::-1], ordinate[:1]]
    edge = Look(look.color, width=0.5)
    return Line(x, y, said("{confidence} % bounds", confidence=confidence), edge, filled=True)


def _at_the_foot(test: LifeTest, look: Look, index: int, label: str, left: float) -> Iterator[Line]:
    """Yield suspended bearings, and failures between inspections, along the axis.

    label: of the group, where neither line nor points have it. left: end of the axis.
    """
    height = _RUG * (index + 0.6)
    suspended = np.unique(test.times[~test.failed])
    if suspended.size:
        name = said_in("bearings", "suspended")
        yield Line(suspended, np.zeros(suspended.size), f"{label}, {name}" if label else name,
                   Look(look.color, mark="tick", width=1.2), "points", height=height)  # fmt: skip
    between = ~np.isnan(test.lower)
    ends = np.unique(np.stack([test.lower[between], test.times[between]], axis=1), axis=0)
    ends = ends[:_MOST_MARKED]
    ends[:, 0] = np.maximum(ends[:, 0], left)
    for row in range(min(_ROWS, len(ends))):
        x = np.insert(ends[row::_ROWS], 2, np.nan, axis=1).ravel()
        yield Line(x, np.zeros(len(x)), said("failed between inspections"),
                   Look(look.color, width=1.4), height=height + 0.4 * _RUG * (1 + row))  # fmt: skip


def _limits(summary: LifeTestSummary, bands: Mapping[str, Band]) -> tuple[Ends, Ends]:
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


def _calculated_lives(summary: LifeTestSummary) -> Iterator[tuple[str, float]]:
    """Give the calculated lives with their labels."""
    life = summary.request.lives[0].name.replace(".", manner().mark)
    for name, value in summary.request.calculated.items():
        shown = f"{number(value)} {shown_text(summary.test.unit)}"
        shown = f"{shown_text(name, 24)}, {shown}" if name else shown
        yield said("calculated {life}: {name}", life=life, name=shown), value


# --- regions of equal likelihood -------------------------------------------------------------


def contour_figure(summary: LifeTestSummary, regions: Mapping[str, LikelihoodRegion]) -> Figure:
    """Draw regions, as `regions_chart` has them, with the title of the data."""
    return _figure(regions_chart(summary, regions), summary, _CONTOUR_HEIGHT)


def regions_chart(summary: LifeTestSummary, regions: Mapping[str, LikelihoodRegion]) -> Chart:
    """Return the regions within which shape and life lie with 50, 90 and 95 %.

    Parameters
    ----------
    summary
        Of `rolamento.weibull.summary`: of a test without groups the estimates of all methods
        of two parameters are marked.
    regions
        Of `rolamento.weibull.likelihood_region`, by the names of the groups; all of one
        quantity.

    Returns
    -------
    Chart
        The shape across, the life upright, both by their logarithms. Calculated lives are lines
        where the regions are of that life.
    """
    drawn = [
        (index, group, regions[group.name])
        for index, group in enumerate(summary.groups)
        if group.name in regions and regions[group.name].converged
    ]
    if not drawn:
        return nothing(no_result())
    own = [region for *_, region in drawn]
    lines = [line for index, group, region in drawn for line in _region(region, group, index)]
    points = _estimates(drawn[0][1].fits, own[0]) if len(summary.groups) == 1 else []
    marks = _marks_of_calculated(summary, own[0])
    across, upright = _ends(own, points, marks)
    if across[0] < _RATING_SHAPE < across[1]:
        label = said("10/9 of the rating standards")
        marks.append(Mark(_RATING_SHAPE, label, Look("grey", width=0.65), "x"))
    quantity, unit = own[0].quantity, shown_text(own[0].fit.unit)
    name = quantity.name.replace(".", manner().mark)
    life = said("Scale η ({unit})", unit=unit) if quantity.name == "scale" else f"{name} ({unit})"
    simulated = all(region.drawn for region in own)
    return Chart(
        once([*lines, *points]),
        Axis(limits=across, log=True, label=said("Shape β")),
        Axis(limits=upright, log=True, label=life),
        "; ".join(_label_of(group) for _, group, _ in drawn),
        marks=tuple(marks),
        over_names=said("regions of equal likelihood, with simulated levels") if simulated
        else said("regions of equal likelihood, for large samples"),
    )  # fmt: skip


def _region(region: LikelihoodRegion, group: GroupSummary, index: int) -> Iterator[Line]:
    """Yield the edges of a group's regions, the outermost first, so that inner ones are darker."""
    from contourpy import contour_generator

    look, name = series_look(index), f"{shown_text(group.name, 24)}: " if group.name else ""
    edges = contour_generator(region.shape, region.life, region.fall)
    levels = sorted(zip(region.levels, region.probabilities, strict=True))
    for place, (level, probability) in enumerate(levels):
        edge = Look(look.color, _DASHES[place % len(_DASHES)], width=0.8)
        for points in edges.lines(level):
            x, y = np.asarray(points).T
            yield Line(x, y, f"{name}{number(100.0 * probability)} %", edge, filled=True)
    if group.name:  # its maximum; of a test without groups all estimates are marked
        yield _estimate(region.fit, region, "", Look(look.color, mark=look.mark, width=0.7))


def _estimates(fits: Sequence[WeibullFit], region: LikelihoodRegion) -> list[Line]:
    return [
        _estimate(fit, region, said(FITS[fit.method]),
                  Look("ink", mark=_ESTIMATES[fit.method],
                       hollow=fit.method != "maximum_likelihood"))
        for fit in fits
        if fit.method in _ESTIMATES and fit.converged
    ]  # fmt: skip


def _estimate(fit: WeibullFit, region: LikelihoodRegion, name: str, look: Look) -> Line:
    life = region.quantity.at(np.array([fit.shape]), np.log([fit.scale]))
    return Line(np.array([fit.shape]), life, name, look, "points")


def _marks_of_calculated(summary: LifeTestSummary, region: LikelihoodRegion) -> list[Mark]:
    """Return calculated lives, where the regions are of the life that they are for."""
    if summary.request.lives[0].name != region.quantity.name:
        return []
    return [
        Mark(value, label, Look("ink", _DASHES[(index + 1) % len(_DASHES)], width=0.7))
        for index, (label, value) in enumerate(_calculated_lives(summary))
    ]


def _ends(
    regions: Sequence[LikelihoodRegion], points: Sequence[Line], marks: Sequence[Mark]
) -> tuple[Ends, Ends]:
    """Return ends of both axes: lines and marks beyond the regions widen them, but by little."""
    shapes = [float(shape) for region in regions for shape in region.shape[[0, -1]]]
    lives = [float(life) for region in regions for life in region.life[[0, -1]]]
    upright = [*(float(one.y[0]) for one in points), *(mark.at for mark in marks)]
    low, high = min(lives) / 3.0, max(lives) * 3.0
    lives += [1.1 * y if y > max(lives) else y / 1.1 for y in upright if low < y < high]
    beside = [float(one.x[0]) for one in points]
    shapes += [x for x in beside if min(shapes) / 2.0 < x < max(shapes) * 2.0]
    return (min(shapes), max(shapes)), (min(lives), max(lives))
