"""The noise of a bearing over frequency, in anderons: thirds of octaves, and the bands' levels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isfinite, sqrt
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.frame import (
    GREY,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
    panels,
)
from rolamento.charts.style import INNER, OUTER, new_figure, styled
from rolamento.words import said
from rolamento.words.sentences.noise import band_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.anderon import BandName, Noise, NoiseSteps
    from rolamento.weibull import Trend

__all__ = ["noise_bands", "noise_figure", "noise_trend_figure"]

_PARTS: Final = 8
"""Number of parts of a band: each a third of an octave."""
_ROOM: Final = 1.6


def noise_figure(
    noise: Noise, *, limits: Mapping[BandName, float] | None = None, title: str = ""
) -> Figure:
    """Draw noise over frequency, as `noise_bands`, with a title."""
    return panels(lambda axes: noise_bands(noise, axes, limits=limits), title=title, height=90.0)


def noise_bands(
    noise: Noise, axes: Axes | None = None, *, limits: Mapping[BandName, float] | None = None
) -> Axes:
    """Draw the anderons of thirds of octaves, with the level and the limit of each band.

    Parameters
    ----------
    noise
        Of `measure_noise`.
    axes
        To draw on; of a new figure if not given.
    limits
        Anderons by band up to which noise is accepted.
    """
    from rolamento.vibration.anderon import noise_steps

    with styled():
        axes = new_figure(height=90.0)[1] if axes is None else axes
        levels = [band.anderons for band in noise.bands if isfinite(band.anderons)]
        steps = noise_steps(noise, _PARTS)
        drawn = np.concatenate([found.anderons for found in steps.values()] or [np.zeros(0)])
        sizes = [value for value in (*levels, *drawn.tolist()) if value > 0.0]
        if not sizes:
            return empty_frame(axes, said("The sampling rate is too low for all of the bands."))
        _draw(axes, noise, steps, limits or {})
        label_x(axes, said("Frequency (Hz)"))
        label_y(axes, said("Noise (anderon)"))
        _frame(axes, noise, [*sizes, *(limits or {}).values()])
        log_scale(axes, "x")
        log_scale(axes, "y")
        legend_above(axes)
    return axes


def noise_trend_figure(trend: Trend, *, limits: Mapping[BandName, float] | None = None) -> Figure:
    """Draw the levels of the three bands over running time, with the limit of each.

    Parameters
    ----------
    trend
        With the bands, from low to high, as its quantities.
    limits
        Anderons by band up to which noise is accepted.
    """
    from rolamento.plots.trend import trend_figure
    from rolamento.vibration.anderon import BANDS

    translated = replace(trend, quantities=tuple(map(band_name, BANDS)))
    figure = trend_figure(translated)
    with styled():
        named = False
        for axes, name in zip(figure.axes, BANDS, strict=True):
            limit = (limits or {}).get(name)
            if limit is not None:
                label = "" if named else said("limit of acceptance")
                axes.axhline(limit, color=OUTER.color, linestyle="--", label=label)
                axes.set_ylim(top=max(axes.get_ylim()[1], 1.1 * limit))
                if not named:
                    legend_above(axes)
                named = True
    return figure


def _draw(
    axes: Axes, noise: Noise, steps: Mapping[BandName, NoiseSteps], limits: Mapping[BandName, float]
) -> None:
    """Draw steps, levels and limits, each kind named once in the legend."""
    named: set[str] = set()

    def label(text: str) -> str:
        known = text in named
        named.add(text)
        return "" if known else text

    for band in noise.bands:
        if band.name in steps:
            edges, values = steps[band.name]
            axes.stairs(values, edges, baseline=None, color=INNER.color, linewidth=1.0,
                        label=label(said("thirds of octaves")))  # fmt: skip
            axes.hlines(band.anderons, *band.band, color="black", linewidth=2.0,
                        label=label(said("level of the band")))  # fmt: skip
        if band.name in limits:
            axes.hlines(limits[band.name], *band.band, color=OUTER.color, linestyle="--",
                        label=label(said("limit of acceptance")))  # fmt: skip


def _frame(axes: Axes, noise: Noise, sizes: Sequence[float]) -> None:
    """Set the limits of the axes, and name the bands along the top."""
    axes.set_xlim(noise.bands[0].band[0], noise.bands[-1].band[1])
    axes.set_ylim(min(sizes) / _ROOM, max(sizes) * _ROOM**2)
    for band in noise.bands:
        low, high = band.band
        axes.axvline(low, color=GREY, linewidth=0.7, zorder=1.5)
        axes.text(sqrt(low * high), 0.985, band_name(band.name), va="top", ha="center",
                  fontsize=8.0, color=GREY, transform=axes.get_xaxis_transform())  # fmt: skip
