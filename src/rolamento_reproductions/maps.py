"""How fields over a contact ellipse are drawn, from the columns of a figure."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Picture
from matplotlib.ticker import MaxNLocator

from rolamento.plots.style import new_stacked_figure
from rolamento_reproductions.labels import Numbers, titled
from rolamento_reproductions.record import Figure, Floats, Map, Maps
from rolamento_reproductions.text import Language

__all__ = ["draw_maps"]

_LEVELS: Final = 14
_SIGNED: Final = "RdBu_r"
_UNSIGNED: Final = "cividis"
_ARROWS: Final = (9, 5)
"""How many, across and along."""
_INK: Final = "#202020"
_HEIGHT: Final = 53.0
_REACH: Final = (0.6, 2.0 / 3.0)
"""Part of the grid that arrows cover, likewise."""


def draw_maps(figure: Figure, picture: Maps, language: Language) -> Picture:
    """Draw the maps one below the other over the same ellipse."""
    drawing, frames = new_stacked_figure(
        len(picture.maps), height=8.0 + _HEIGHT * len(picture.maps)
    )
    for place, (one, axes) in enumerate(zip(picture.maps, frames, strict=True)):
        _draw(figure, picture, one, axes, language)
        last = place == len(frames) - 1
        _label(figure, picture, one, axes, language, last=last)
    return drawing


def _gridded(figure: Figure, name: str, count: int) -> Floats:
    return figure.column(name).numbers.reshape(count, -1)


def _draw(figure: Figure, picture: Maps, one: Map, axes: Axes, language: Language) -> None:
    x, y, value = (_gridded(figure, n, picture.count) for n in (picture.x, picture.y, one.value))
    low, high = float(value.min()), float(value.max())
    parted = one.signed and low < 0.0 < high
    if parted:
        low, high = -max(-low, high), max(-low, high)
    levels = MaxNLocator(_LEVELS, symmetric=parted).tick_values(low, high)
    colours = _SIGNED if parted else _UNSIGNED
    filled = axes.contourf(x, y, value, levels=levels, cmap=colours)
    if parted:
        axes.contour(x, y, value, levels=[0.0], colors=_INK, linestyles="--", linewidths=1.2)
    for edge in (y[:, 0], y[:, -1]):
        axes.plot(x[:, 0], edge, color=_INK, linewidth=1.0)
    if one.arrows is not None:
        _draw_arrows(figure, picture, one.arrows, axes)
    bar = axes.figure.colorbar(filled, ax=axes, aspect=14.0, pad=0.02)
    bar.locator = MaxNLocator(6)
    bar.update_ticks()
    bar.ax.yaxis.set_major_formatter(Numbers(bar.ax.yaxis, language))
    bar.set_label(figure.column(one.value).unit)


def _draw_arrows(figure: Figure, picture: Maps, names: tuple[str, str], axes: Axes) -> None:
    """Show the direction at points of the grid, all arrows of one length."""
    x, y, across, along = (
        _gridded(figure, n, picture.count) for n in (picture.x, picture.y, *names)
    )
    rows, columns = (
        np.linspace((1.0 - reach) * (n - 1) / 2, (1.0 + reach) * (n - 1) / 2, k).round().astype(int)
        for n, k, reach in zip(x.shape, _ARROWS, _REACH, strict=True)
    )
    at: Any = np.ix_(rows, columns)
    size = np.maximum(np.hypot(across[at], along[at]), np.finfo(np.float64).tiny)
    axes.quiver(
        x[at],
        y[at],
        across[at] / size,
        along[at] / size,
        color="white",
        edgecolor=_INK,
        linewidth=0.4,
        scale=26.0,
        width=0.005,
        pivot="middle",
        zorder=4.0,
    )


def _label(
    figure: Figure, picture: Maps, one: Map, axes: Axes, language: Language, *, last: bool
) -> None:
    x, y = figure.column(picture.x), figure.column(picture.y)
    axes.set_title(titled(one.title.speak(language), ""), loc="left")
    axes.set_ylabel(titled(y.title.speak(language), y.unit))
    if last:
        axes.set_xlabel(titled(x.title.speak(language), x.unit))
    axes.set_xlim(1.04 * float(x.numbers.min()), 1.04 * float(x.numbers.max()))
    axes.set_ylim(1.1 * float(y.numbers.min()), 1.1 * float(y.numbers.max()))
    axes.grid(False)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(Numbers(axis, language))
