"""What ends a bearing, on one time line: horizontal bars over a logarithmic axis of hours."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from rolamento.charts.frame import empty_frame, label_x, legend_above, log_scale, panels
from rolamento.charts.style import new_figure, series, styled
from rolamento.charts.texts import no_result
from rolamento.words import said
from rolamento.words.sentences.service_life import ENDING_NAMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.tasks.endings import Ending
    from rolamento.tasks.time_line import ServiceLife

__all__ = ["service_life_figure", "time_line"]

_YEAR: Final = 8760.0
_LEAST, _MOST = 100.0, 1e5
"""Hours that the axis shows at least."""
_WIDTH: Final = 22


def service_life_figure(found: ServiceLife) -> Figure:
    """Draw what ends a case, on one time line.

    Parameters
    ----------
    found
        What `rolamento.tasks.service_life` gives.
    """
    return panels(
        lambda axes: time_line(found, axes),
        title=found.solved.title,
        height=38.0 + 11.0 * max(len(found.endings), 2),
    )


def time_line(found: ServiceLife, axes: Axes | None = None) -> Axes:
    """Draw a bar for each ending from low to high, its hours as a mark; what has no time in words.

    Parameters
    ----------
    found
        As of `service_life_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        if not found.endings:
            return empty_frame(axes, no_result())
        low, high = _range(found)
        for place, one in enumerate(found.endings):
            _bar(axes, place, one, one is found.first, (low, high))
        names = [textwrap.fill(said(ENDING_NAMES[one.name]), _WIDTH) for one in found.endings]
        axes.set_yticks(np.arange(len(names)), names, parse_math=False)
        axes.set_ylim(len(names) - 0.4, -0.6)
        axes.grid(visible=False, axis="y")
        if found.required is not None:
            axes.axvline(
                found.required, color="#000000", linewidth=1.0, linestyle="--",
                label=said("required life"),
            )  # fmt: skip
        label_x(axes, said("Time (h)"))
        log_scale(axes, "x")
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0,)))
        axes.set_xlim(low, high)
        legend_above(axes)
    return axes


def _range(found: ServiceLife) -> tuple[float, float]:
    """Hours from which to which the axis goes."""
    known = [
        value
        for one in found.endings
        for value in (one.low, one.hours, one.high)
        if np.isfinite(value) and value > 0.0
    ]
    known += [] if found.required is None else [found.required]
    least, most = min([*known, _LEAST]), max([*known, _MOST])
    return 0.7 * least, 1.5 * most


def _bar(axes: Axes, place: int, one: Ending, is_first: bool, ends: tuple[float, float]) -> None:
    look = series(1 if is_first else 0)
    middle = float(np.sqrt(ends[0] * ends[1]))
    if not np.isfinite(one.hours) or one.hours == 0.0:
        text = (
            said("at work, no time known") if one.acting
            else said("at once") if one.hours == 0.0
            else said("never") if one.hours == np.inf
            else said("not known")
        )  # fmt: skip
        at, side = {0.0: (1.05 * ends[0], "left"), np.inf: (0.95 * ends[1], "right")}.get(
            one.hours, (middle, "center")
        )
        axes.text(
            at, place, text, ha=side, va="center", fontsize=8.0, parse_math=False,
            color=look.color if is_first else "#606060",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5},
        )  # fmt: skip
        return
    low = one.low if np.isfinite(one.low) else one.hours
    high = one.high if np.isfinite(one.high) else one.hours
    upkeep = one.kind == "upkeep"
    axes.barh(
        place, high - low, left=low, height=0.5, color="none" if upkeep else look.color,
        edgecolor=look.color, alpha=1.0 if upkeep else 0.45, linestyle=":" if upkeep else "-",
    )  # fmt: skip
    axes.plot(
        [one.hours], [place], linestyle="none", marker="<" if one.bound else "o",
        color=look.color, markersize=6.0,
    )  # fmt: skip
