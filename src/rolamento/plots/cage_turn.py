"""A turn of the cage, drawn: displacement, stiffness and their harmonics, and one ball's way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import (
    Axis,
    Bars,
    Chart,
    Labels,
    Line,
    nothing,
    race_look,
    series_look,
)
from rolamento.charts.axes_units import PERCENT, ReadableUnit
from rolamento.charts.contacts import race_name
from rolamento.charts.courses import peak
from rolamento.charts.drawing import draw
from rolamento.charts.frame import add_title
from rolamento.charts.style import MILLIMETRE, WIDTH, styled
from rolamento.charts.texts import number
from rolamento.solved import RACES
from rolamento.words import said, worded

if TYPE_CHECKING:
    from rolamento.studies.cage_turn import CageTurn

__all__ = ["cage_turn_figure"]

Floats = NDArray[np.float64]

_HEIGHT: Final = 145.0
_SHIFTS: Final = ("x", "y", "z")
_MOST_ORDERS: Final = 6
_DECADES: Final = 1e-5  # of the greatest amplitude: bars below are not drawn
_LENGTHS: Final = (ReadableUnit("µm", 1e6), ReadableUnit("nm", 1e9), ReadableUnit("pm", 1e12))
_SHARES: Final = (PERCENT, ReadableUnit("ppm", 1e6))
_STIFFNESS: Final = ReadableUnit("N/µm", 1e-6)


def cage_turn_figure(turn: CageTurn) -> Figure:
    """Draw a turn of the cage in four panels.

    How the ring moves about its mean place, how its stiffness varies, the load of one ball on its
    way round, and the amplitudes of the displacement's harmonics. Where a point has no result,
    displacement and stiffness are drawn as they are, with a gap.

    Parameters
    ----------
    turn
        From `rolamento.studies.cage_turn.cage_turn`.
    """
    charts = (displacement_chart(turn), load_chart(turn), stiffness_chart(turn),
              harmonics_chart(turn))  # fmt: skip
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, _HEIGHT * MILLIMETRE))
        for place, chart in enumerate(charts, start=1):
            axes = figure.add_subplot(2, 2, place, projection="polar" if chart.polar else None)
            draw(chart, axes)
            above = 6.0 if axes.get_legend() is None or not chart.series else 20.0
            axes.set_title(chart.title, loc="left", pad=40.0 if chart.polar else above)
        if turn.case.title:
            add_title(figure, turn.case.title)
    return figure


def displacement_chart(turn: CageTurn) -> Chart:
    """Return how the ring moves about its mean place, over the azimuth of the first element."""
    title = said("Displacement of the inner ring")
    if not np.isfinite(turn.solved.displacement.array).any():
        return replace(nothing(said("no point has a result")), title=title)
    variation = turn.variation("displacement")
    mean, extent = variation.mean[:3], variation.peak_to_peak[:3]
    unit = _fitting(_LENGTHS, extent) if turn.converged else _LENGTHS[0]
    values = turn.solved.displacement.array[:, :3]
    if turn.converged:
        values = np.where(extent, values - mean, 0.0)
    label = said("About the mean") if turn.converged else title
    return _over_angle(turn, unit.of(values), _SHIFTS, Axis(label, unit.symbol), title)


def stiffness_chart(turn: CageTurn) -> Chart:
    """Return how the stiffness of the ring varies, over the azimuth of the first element."""
    title = said("Stiffness")
    if not np.isfinite(turn.solved.stiffness.array).any():
        return replace(nothing(said("no point has a result")), title=title)
    variation = turn.variation("stiffness")
    extent, mean = np.diagonal(variation.peak_to_peak)[:3], np.diagonal(variation.mean)[:3]
    mean = np.where(mean == 0.0, 1.0, mean)  # cylindrical rollers do not hold the ring along x
    unit = _fitting(_SHARES, extent / np.abs(mean)) if turn.converged else _STIFFNESS
    values = np.diagonal(turn.solved.stiffness.array, axis1=1, axis2=2)[:, :3]
    if turn.converged:
        values = np.where(extent, values / mean - 1.0, 0.0)
    label = said("About the mean") if turn.converged else title
    names = [f"{name}–{name}" for name in _SHIFTS]
    return _over_angle(turn, unit.of(values), names, Axis(label, unit.symbol), title)


def _fitting(units: tuple[ReadableUnit, ...], extents: Floats) -> ReadableUnit:
    """Return the unit in which the greatest extent is at least a tenth, else the last."""
    greatest = float(np.nanmax(np.abs(extents)))
    fitting = (unit for unit in units if unit.factor * greatest >= 0.1)
    return next(fitting, units[0] if greatest == 0.0 else units[-1])


def _over_angle(
    turn: CageTurn, values: Floats, names: Sequence[str], upright: Axis, title: str
) -> Chart:
    """Return lines over the period, the first point of each repeated at the end."""
    angle = np.degrees(np.append(turn.angle, turn.period))
    closed = np.vstack([values, values[:1]])
    series: list[Line | Labels] = [
        Line(angle, closed[:, index], name, series_look(index)) for index, name in enumerate(names)
    ]
    if turn.converged and not values.any():  # a scale on which it is a line
        upright = replace(upright, limits=(-1.0, 1.0), ticks=((0.0, number(0.0)),))
        middle = np.array([0.5 * angle[-1]])
        still = (said("no variation"),)
        series.append(Labels(middle, middle, still, ("on",), "grey", 0.7))
    azimuth = worded(
        turn.elements,
        said("Azimuth of the first ball (°)"),
        said("Azimuth of the first roller (°)"),
    )
    across = Axis(limits=(0.0, float(np.degrees(turn.period))), label=azimuth)
    extent = np.nanmax(values, axis=0) - np.nanmin(values, axis=0)
    widest, value = names[extent.argmax()], upright.with_unit(number(float(extent.max()), 3))
    conclusion = (
        said("does not vary: {value}", value=value)
        if not extent.any()
        else said("{name} varies most, by {value} from peak to peak", name=widest, value=value)
    )
    return Chart(tuple(series), across, upright, conclusion, title=title)


def load_chart(turn: CageTurn) -> Chart:
    """Return the load of one element of each row on its way round."""
    title = worded(
        turn.elements,
        said("Load of one ball over a turn (kN)"),
        said("Load of one roller over a turn (kN)"),
    )
    upright = Axis(unit="kN", hidden=True)
    lines = [
        Line(np.degrees(np.append(own.azimuth, own.azimuth[0] + 2.0 * np.pi)),
             1e-3 * np.append(load, load[0]), race_name(race, own.row, len(turn.histories)),
             race_look(race, row=own.row))
        for own in turn.histories
        for race, load in zip(RACES, (own.inner.load, own.outer.load), strict=True)
    ]  # fmt: skip
    if not any(np.isfinite(line.y).any() for line in lines):
        return replace(nothing(said("no point has a result")), title=title)
    loads = [(one.name, one.x % 360.0, one.y) for one in lines]
    conclusion = peak(loads, Axis(unit="°"), upright)
    return Chart(tuple(lines), Axis(), upright, conclusion, title, polar=True, numbers_at=112.5)


def harmonics_chart(turn: CageTurn) -> Chart:
    """Return the amplitudes of the displacement's harmonics as bars, from a common foot."""
    title = said("Harmonics of the displacement")
    amplitudes = np.abs(turn.variation("displacement").harmonics[:_MOST_ORDERS, :3])
    if not turn.converged:
        return replace(nothing(said("not every point has a result")), title=title)
    if not amplitudes.any():
        return replace(nothing(said("no variation")), title=title)
    unit = _fitting(_LENGTHS, amplitudes)
    shown = unit.of(np.where(amplitudes > _DECADES * amplitudes.max(), amplitudes, np.nan))
    places = tuple(range(len(shown)))
    bars = (
        Bars(shown[:, index], places, name, series_look(index))
        for index, name in enumerate(_SHIFTS)
    )
    frequency = turn.passage_frequency
    passage = worded(
        turn.elements, said("Harmonic of the ball passage"), said("Harmonic of the roller passage")
    )
    behind = f"; 1× = {number(frequency)} Hz" if np.isfinite(frequency) else ""
    ends = 0.4 * float(np.nanmin(shown)), 2.0 * float(np.nanmax(shown))
    return Chart(
        tuple(bars),
        Axis(limits=ends, log=True, label=unit.label(said("Amplitude")) + behind, unit=unit.symbol),
        Axis(categories=tuple(f"{order}×" for order in range(1, len(shown) + 1)),
             label=passage),
        title=title,
    )  # fmt: skip
