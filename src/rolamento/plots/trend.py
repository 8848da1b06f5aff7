"""What was measured again and again while bearings ran, over their running time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.plots.frame import add_title, empty_frame, label_x, label_y, legend_above, shown_text
from rolamento.plots.style import new_figure, new_stacked_figure, series, styled
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.clearance.wear import WearFit
    from rolamento.weibull import Trend

__all__ = ["trend_figure", "trend_lines"]

_HEIGHT: Final = 90.0
_PANEL: Final = 55.0
_CURVE: Final = 300
_TOP: Final = 0.96
"""Height in the frame at which rejected measurements are marked."""


@dataclass(frozen=True, slots=True)
class _Words:
    time: str
    bearing: str
    rejected: str
    law: str
    quantities: Mapping[str, str]


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words("Running time", "bearing {name}", "rejected", "bearing {name}, law", {}),
    "pt": _Words(
        "Tempo de ensaio",
        "rolamento {name}",
        "reprovado",
        "rolamento {name}, lei",
        {"radial clearance": "folga radial"},
    ),
}


def trend_figure(
    trend: Trend, fits: Mapping[str, WearFit] | None = None, language: str = "en"
) -> Figure:
    """Draw every quantity of a record, one below the other, with its title."""
    count = len(trend.quantities)
    with styled():
        if count == 1:
            figure, axes = new_figure(height=_HEIGHT)
            panels: tuple[Axes, ...] = (axes,)
        else:
            figure, panels = new_stacked_figure(count, height=25.0 + _PANEL * count)
        for quantity, axes in enumerate(panels):
            trend_lines(trend, quantity, axes, fits=fits, language=language, legend=not quantity)
        for axes in panels[:-1]:
            axes.set_xlabel("")
        if trend.title:
            add_title(figure, trend.title)
    return figure


def trend_lines(
    trend: Trend,
    quantity: int = 0,
    axes: Axes | None = None,
    *,
    fits: Mapping[str, WearFit] | None = None,
    language: str = "en",
    legend: bool = True,
) -> Axes:
    """Draw a quantity of every bearing over its running time.

    Parameters
    ----------
    trend
        Of `rolamento.weibull.trend`.
    quantity
        Which of its columns.
    axes
        To draw on; of a new figure if not given.
    fits
        Of `wear_of_each`: laws of wear, by the bearings; then the points are not joined.
    language
        ``"en"`` or ``"pt"``.
    legend
        Whether to show one.

    Returns
    -------
    Axes
        Those given. Rejected measurements are crosses at the top of the frame.
    """
    shared, words = plot_words(language), _WORDS["pt" if language == "pt" else "en"]
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        if not np.isfinite(trend.values[:, quantity]).any():
            return empty_frame(axes, shared.no_result)
        for index, name in enumerate(trend.names):
            _bearing(axes, trend, quantity, index, name, (fits or {}).get(name), words)
        _rejected(axes, trend, quantity, words)
        _label(axes, trend, quantity, shared, words)
        if legend:
            legend_above(axes)
    return axes


def _bearing(
    axes: Axes,
    trend: Trend,
    quantity: int,
    index: int,
    name: str,
    fit: WearFit | None,
    words: _Words,
) -> None:
    look, (times, values) = series(index), trend.of_bearing(name, quantity)
    keywords: dict[str, Any] = {"color": look.color, "marker": look.marker, "zorder": 3.0}
    label = words.bearing.format(name=shown_text(name, 24))
    line = "" if fit is not None else look.linestyle
    axes.plot(times, values, linestyle=line, label=label, **keywords)
    if fit is None or not times.size:
        return
    from rolamento.units import to_si

    grid = np.linspace(0.0, float(times[-1]), _CURVE)
    second = to_si(f"1 {trend.time_unit}", "time")
    scale = to_si(f"1 {trend.units[quantity]}", "length")
    axes.plot(
        grid, fit.clearance(second * grid) / scale, color=look.color, linestyle=look.linestyle,
        label=words.law.format(name=shown_text(name, 24)), zorder=2.0,
    )  # fmt: skip


def _rejected(axes: Axes, trend: Trend, quantity: int, words: _Words) -> None:
    """Mark what was rejected, in the colour of its bearing."""
    labelled = False
    for index, name in enumerate(trend.names):
        rows = (trend.bearings == name) & trend.rejected[:, quantity]
        if rows.any():
            axes.plot(
                trend.times[rows], np.full(int(rows.sum()), _TOP), marker="x", linestyle="",
                color=series(index).color, markersize=7.0, markeredgewidth=1.6, clip_on=False,
                transform=axes.get_xaxis_transform(), label=None if labelled else words.rejected,
            )  # fmt: skip
            labelled = True


def _label(axes: Axes, trend: Trend, quantity: int, shared: PlotWords, words: _Words) -> None:
    name = trend.quantities[quantity]
    known = words.quantities.get(name, name)
    label_x(axes, f"{words.time} ({trend.time_unit})", shared)
    label_y(axes, f"{known[:1].upper()}{known[1:]} ({trend.units[quantity]})", shared)
    top = float(np.nanmax(trend.values[:, quantity]))
    least = float(np.nanmin(trend.values[:, quantity]))
    axes.set_xlim(min(0.0, float(trend.times.min())), 1.03 * float(trend.times.max()))
    if least >= 0.0:
        axes.set_ylim(0.0, 1.15 * top)
