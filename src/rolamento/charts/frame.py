"""What figures share around the data: numbers on axes, legends and titles outside, empty frames."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import (
    FixedLocator,
    FuncFormatter,
    LogLocator,
    MaxNLocator,
    NullFormatter,
    NullLocator,
    ScalarFormatter,
)

from rolamento.charts.palette import LIGHT
from rolamento.charts.style import new_stacked_figure, styled
from rolamento.charts.texts import marked_number, mathematical, numbers, shown_text
from rolamento.errors import InputError, kind_of
from rolamento.words import manner, said

GREY: Final = LIGHT["grey"]
_UPRIGHT_WIDTH: Final = 45
_TITLE_CHARACTERS_PER_INCH: Final = 13.0
_CHARACTERS_PER_INCH: Final = 17.0
_HANDLE_CHARACTERS: Final = 7
_HALF_LINE, _WHOLE_LINE = 49, 70.0
"""Characters, with its handle, of a label of which two stand over a frame; and of the frame."""
_DECADES: Final = 100.0
"""Greatest over least value from which on there is room for whole decades only."""
_NARROW: Final = 10.0
_SHORT, _EVEN = 4.0, 7
_WHOLE, _FEW, _MANY = (1.0,), (1.0, 2.0, 5.0), (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0)
"""Ticks in a decade of a wide, a middling and a narrow axis."""
_MOST_TICKS: Final = 9
_LONG: Final = 1e6
"""From here on a tick is written as a power of ten."""
_RAISED: Final = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class PlainNumbers(ScalarFormatter):
    """Numbers of ticks with the decimal mark that is spoken now, thousands apart, no offset."""

    def __init__(self) -> None:
        super().__init__(useOffset=False)
        self.set_powerlimits((-4, 7))
        self._mark = manner().mark

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Write the number of one tick."""
        return marked_number(super().__call__(x, pos), self._mark)


def in_lines(label: str) -> str:
    """Return the label of an upright axis, in two lines if it is long."""
    return "\n".join(textwrap.wrap(shown_text(label), _UPRIGHT_WIDTH))


def label_x(axes: Axes, label: str) -> None:
    """Label the axis across; what files call things is not read as mathematics."""
    axes.set_xlabel(shown_text(label), parse_math=False)
    axes.xaxis.set_major_formatter(PlainNumbers())


def label_y(axes: Axes, label: str) -> None:
    """Label the upright axis, likewise."""
    axes.set_ylabel(in_lines(label), parse_math=False)
    axes.yaxis.set_major_formatter(PlainNumbers())


def log_scale(axes: Axes, axis: str) -> None:
    """Make an axis, "x" or "y", logarithmic, with plain numbers at 1, 2, 5 and so on."""
    getattr(axes, f"set_{axis}scale")("log")
    scaled = getattr(axes, f"{axis}axis")
    scaled.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    scaled.set_minor_formatter(NullFormatter())
    scaled.set_major_formatter(FuncFormatter(numbers()))


def decades(axes: Axes, axis: str, limits: tuple[float, float]) -> None:
    """Make an axis, "x" or "y", logarithmic between two limits, however many decades there are."""
    getattr(axes, f"set_{axis}scale")("log")
    getattr(axes, f"set_{axis}lim")(*limits)
    span = limits[1] / limits[0]
    scaled = getattr(axes, f"{axis}axis")
    if span < _SHORT:  # few round decades: even steps
        scaled.set_major_locator(MaxNLocator(_EVEN, steps=[1, 2, 2.5, 5, 10]))
        scaled.set_minor_locator(NullLocator())
    else:
        subs = _WHOLE if span > _DECADES else _FEW if span > _NARROW else _MANY
        scaled.set_major_locator(LogLocator(subs=subs, numticks=_MOST_TICKS))
        scaled.set_minor_locator(LogLocator(subs="auto", numticks=_MOST_TICKS))
    scaled.set_minor_formatter(NullFormatter())
    plain = numbers()

    def written(value: float, place: object) -> str:
        power = round(float(np.log10(value)))
        if value >= _LONG and np.isclose(value, 10.0**power):
            return "10" + str(power).translate(_RAISED)
        return plain(value, place)

    scaled.set_major_formatter(FuncFormatter(written))


def legend_above(
    axes: Axes, *, handles: Sequence[Artist] = (), title: str = "", symbols: bool = False
) -> None:
    """Put the legend over the frame, where no data are, in as many columns as there is room for.

    handles: what to show, with labels of their own; all that is drawn if not given. symbols:
    whether letters with an index are set as such.
    """
    handles = handles or axes.get_legend_handles_labels()[0]
    if not handles:
        return
    polar = isinstance(axes, PolarAxes)
    labels = [shown_text(str(handle.get_label()), 60) for handle in handles]
    legend = axes.legend(
        handles,
        labels,
        loc="lower center" if polar else "lower left",
        bbox_to_anchor=(0.5, 1.15) if polar else (0.0, 1.0),
        ncols=_columns(axes, labels),
        borderaxespad=0.2,
        borderpad=0.2,
        columnspacing=1.4,
        handlelength=2.6,
        title=shown_text(title, 70) or None,
        alignment="left",
    )
    for text in (*legend.get_texts(), legend.get_title()):
        text.set_parse_math(symbols)
        if symbols:
            text.set_text(mathematical(text.get_text()))
    legend.get_title().set_fontsize(8.0)


def _columns(axes: Axes, labels: Sequence[str]) -> int:
    """Return how many labels stand side by side over a frame, one wide as the other."""
    room = figure_of(axes).get_figwidth() * axes.get_position().width * _CHARACTERS_PER_INCH
    if isinstance(axes.yaxis.get_major_locator(), FixedLocator):  # names stand beside it
        room -= max((len(one.get_text()) for one in axes.get_yticklabels()), default=0)
    widest = max(map(len, labels)) + _HANDLE_CHARACTERS
    least = 2 if widest <= _HALF_LINE and room > _WHOLE_LINE else 1
    return min(max(int(room / widest), least), len(labels))


def add_title(figure: Figure, title: str) -> None:
    """Put a title over a whole figure, in at most two lines that fit its width."""
    width = int(figure.get_figwidth() * _TITLE_CHARACTERS_PER_INCH)
    lines = textwrap.wrap(shown_text(title, 4 * width), width, max_lines=2, placeholder=" …")
    figure.suptitle("\n".join(lines), fontsize=9.5, parse_math=False)


def panels(
    *drawn: Callable[[Axes], object], title: str = "", height: float = 90.0, own: bool = False
) -> Figure:
    """Return a new figure of frames one below the other, with a title over all.

    Parameters
    ----------
    drawn
        What draws on the axes of each frame.
    title
        Over all; none if empty.
    height
        In mm.
    own
        Whether each has an axis of its own across; else only the last keeps its label.
    """
    with styled():
        figure, frames = new_stacked_figure(len(drawn), height=height)
        for draw, axes in zip(drawn, frames, strict=True):
            draw(axes)
        for axes in frames[: 0 if own else -1]:
            axes.set_xlabel("")
        if title:
            add_title(figure, title)
    return figure


def empty_frame(axes: Axes, message: str) -> Axes:
    """Draw a frame without data that says why."""
    axes.set_xticks([])
    axes.set_yticks([])
    axes.text(
        0.5,
        0.5,
        "\n".join(textwrap.wrap(shown_text(message, 200), 44)),
        transform=axes.transAxes,
        ha="center",
        va="center",
        fontsize=10.0,
        parse_math=False,
        bbox={"facecolor": "white", "edgecolor": GREY, "boxstyle": "round,pad=0.6"},
    )
    return axes


def figure_of(axes: Axes) -> Figure:
    """Return the figure that axes are part of."""
    figure = axes.get_figure(root=True)
    assert isinstance(figure, Figure)
    return figure


def require(given: object, kind: type, field: str, example: str) -> None:
    """Refuse what a figure cannot be drawn from.

    Raises
    ------
    InputError
        Naming what it has to be, and how that is made.
    """
    if not isinstance(given, kind):
        rule = said("must be a {name}", name=kind.__name__)
        raise InputError(rule, field=field, value=kind_of(given), example=example)


def require_axes(given: Axes) -> Axes:
    """Return the axes, if they are some.

    Raises
    ------
    InputError
        If not.
    """
    require(given, Axes, "axes", "figure.add_subplot()")
    return given
