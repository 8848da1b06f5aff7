"""The noise of a bearing over frequency, in anderons: thirds of octaves, and the bands' levels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import isfinite, sqrt
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Labels, Line, Look, Mark, nothing, series_look
from rolamento.charts.drawing import draw, figure
from rolamento.charts.record import Side
from rolamento.charts.texts import number
from rolamento.words import said
from rolamento.words.sentences.noise import band_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.vibration.anderon import BandName, Noise
    from rolamento.weibull import Trend

__all__ = ["noise_bands", "noise_figure", "noise_trend_figure"]

_PARTS: Final = 8
"""Number of parts of a band: each a third of an octave."""
_ROOM: Final = 1.6


def noise_figure(
    noise: Noise, *, limits: Mapping[BandName, float] | None = None, title: str = ""
) -> Figure:
    """Draw noise over frequency, as `noise_bands`, with a title."""
    return figure(noise_chart(noise, limits or {}), title=title)


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
    return draw(noise_chart(noise, limits or {}), axes)


def noise_chart(noise: Noise, limits: Mapping[BandName, float]) -> Chart:
    """Return the chart of `noise_bands`."""
    from rolamento.vibration.anderon import noise_steps

    steps = noise_steps(noise, _PARTS)
    values = [band.anderons for band in noise.bands if isfinite(band.anderons)]
    values += [value for found in steps.values() for value in found.anderons.tolist()]
    sizes = [value for value in values if value > 0.0]
    if not sizes:
        return nothing(said("The sampling rate is too low for all of the bands."))
    sizes += limits.values()
    third, level, limit = series_look(0), Look("ink", width=1.4), Look("bad", "dash")
    names = {third: said("thirds of octaves"), level: said("level of the band"),
             limit: said("limit of acceptance")}  # fmt: skip
    series: list[Line] = []
    for band in noise.bands:
        ends = np.array(band.band)
        if band.name in steps:
            edges, own = steps[band.name]
            x, y = np.repeat(edges, 2)[1:-1], np.repeat(own, 2)
            series.append(Line(x, y, names.pop(third, ""), third))
            series.append(Line(ends, np.full(2, band.anderons), names.pop(level, ""), level))
        if band.name in limits:
            own_limit = np.full(2, limits[band.name])
            series.append(Line(ends, own_limit, names.pop(limit, ""), limit))
    middles = np.array([sqrt(band.band[0] * band.band[1]) for band in noise.bands])
    texts = tuple(band_name(band.name) for band in noise.bands)
    sides: list[Side] = ["on"] * len(texts)
    labels = Labels(middles, middles, texts, tuple(sides), "grey", 0.96)
    return Chart(
        (*series, labels),
        Axis(limits=(noise.bands[0].band[0], noise.bands[-1].band[1]), log=True,
             name=said("Frequency"), unit="Hz"),
        Axis(limits=(min(sizes) / _ROOM, max(sizes) * _ROOM**2), log=True,
             name=said("Noise"), unit="anderon"),
        "; ".join(f"{band_name(band.name)}: {number(band.anderons)} anderon"
                  for band in noise.bands if isfinite(band.anderons)),
        marks=tuple(Mark(band.band[0], "", Look("grey", width=0.5), "x") for band in noise.bands),
    )  # fmt: skip


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
    places = {place: (limits or {}).get(name) for place, name in enumerate(BANDS)}
    accepted = {place: limit for place, limit in places.items() if limit is not None}
    return trend_figure(translated, acceptance=accepted)
