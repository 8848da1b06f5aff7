"""How figures of Matplotlib look: sizes for print, and the looks of the palette in its words."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from functools import wraps
from typing import Any, Final, NamedTuple, ParamSpec, TypeVar

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from rolamento.charts import palette
from rolamento.charts.palette import LIGHT, Look

__all__ = [
    "INNER",
    "OUTER",
    "SERIES",
    "Series",
    "in_style",
    "new_figure",
    "new_polar_figure",
    "new_stacked_figure",
    "of_look",
    "series",
    "styled",
]

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")

MILLIMETRE: Final = 1.0 / 25.4
WIDTH: Final = 150.0
"""Width of a figure across a page, in mm."""


class Series(NamedTuple):
    """How one of several lines is drawn."""

    color: str
    linestyle: Any
    marker: str

    def keywords(self, *, markers: bool = False) -> dict[str, Any]:
        """Return keyword arguments for `Axes.plot`."""
        drawn: dict[str, Any] = {"color": self.color, "linestyle": self.linestyle}
        return {**drawn, "marker": self.marker} if markers else drawn


_DASHES: Final[Mapping[str, Any]] = {
    "solid": "-", "dash": "--", "dashdot": "-.", "dot": ":", "longdash": (0, (7, 2)),
    "longdashdot": (0, (8, 2, 1, 2)), "dashdotdot": (0, (5, 1, 1, 1, 1, 1)), "fine": (0, (1, 1)),
}  # fmt: skip
_MARKS: Final[Mapping[str, str]] = {
    "circle": "o", "square": "s", "triangle-up": "^", "diamond": "D", "triangle-down": "v",
    "cross": "P", "x": "X", "star": "*", "tick": "|", "thin": "x",
    "triangle-left": "<", "triangle-right": ">", "query": "$?$",
}  # fmt: skip


def of_look(look: Look) -> Series:
    """Return a look of the palette as Matplotlib has it, on white paper."""
    return Series(LIGHT.get(look.color, look.color), _DASHES[look.dash], _MARKS[look.mark])


SERIES: Final = tuple(map(of_look, palette.SERIES))
INNER: Final = SERIES[0]
OUTER: Final = SERIES[1]

_STYLE: Final[Any] = {
    "figure.dpi": 100.0,
    "savefig.dpi": 200.0,
    "figure.constrained_layout.use": True,
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.labelsize": 9.0,
    "legend.fontsize": 8.0,
    "legend.frameon": False,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "axes.grid": True,
    "grid.color": "#D0D0D0",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.4,
    "lines.markersize": 4.0,
    "image.cmap": "cividis",
    "hatch.linewidth": 0.6,
    "pdf.fonttype": 42,
    "svg.hashsalt": "rolamento",
}


def styled() -> AbstractContextManager[None]:
    """Return a context in which new figures look like ours; use it with ``with``."""
    context: AbstractContextManager[None] = rc_context(_STYLE)
    return context


def in_style(draw: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Make what a function draws look like ours, on axes of others as well."""

    @wraps(draw)
    def drawn(*args: Parameters.args, **keywords: Parameters.kwargs) -> Result:
        with styled():
            return draw(*args, **keywords)

    return drawn


def new_figure(*, width: float = WIDTH, height: float = 90.0) -> tuple[Figure, Axes]:
    """Return a figure, sizes in mm, and its axes; no window and no global state."""
    with styled():
        figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE))
        return figure, _own_style(figure.add_subplot())


def new_stacked_figure(
    count: int, *, width: float = WIDTH, height: float = 130.0
) -> tuple[Figure, tuple[Axes, ...]]:
    """Return a figure, sizes in mm, and axes one below the other."""
    with styled():
        figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE))
        places = range(1, count + 1)
        return figure, tuple(_own_style(figure.add_subplot(count, 1, place)) for place in places)


def new_polar_figure(*, width: float = 110.0, height: float = 100.0) -> tuple[Figure, PolarAxes]:
    """Return a figure with polar axes, zero at the top (+z), growing toward +y (to the right)."""
    with styled():
        figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE))
        axes = figure.add_subplot(projection="polar")
        assert isinstance(axes, PolarAxes)
        axes.set_theta_zero_location("N")
        axes.set_theta_direction(-1)
        _own_style(axes)
        return figure, axes


def _own_style(axes: Axes) -> Axes:
    """Pin what matplotlib would otherwise take from the settings of whoever saves the figure."""
    axes.tick_params(labelsize=_STYLE["xtick.labelsize"])
    axes.grid(True, color=_STYLE["grid.color"], linewidth=_STYLE["grid.linewidth"])
    return axes


def series(index: int) -> Series:
    """Return how the line of an index is drawn; after the last the cycle begins anew."""
    return SERIES[index % len(SERIES)]
