"""A turn of the cage, drawn: displacement, stiffness and their harmonics, and one ball's way."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from rolamento.charts.axes_units import PERCENT, ReadableUnit
from rolamento.charts.contacts import race_name
from rolamento.charts.frame import (
    GREY,
    PlainNumbers,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
)
from rolamento.charts.style import INNER, MILLIMETRE, OUTER, WIDTH, Series, series, styled
from rolamento.charts.texts import number
from rolamento.words import said, worded

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.geometry import Race
    from rolamento.studies.cage_turn import CageTurn, ContactHistory

__all__ = ["cage_turn_figure"]

Floats = NDArray[np.float64]

_HEIGHT: Final = 145.0
_SHIFTS: Final = ("x", "y", "z")
_MOST_ORDERS: Final = 6
_DECADES: Final = 1e-5  # of the greatest amplitude: bars below are not drawn
_BAR: Final = 0.26
_LENGTHS: Final = (ReadableUnit("µm", 1e6), ReadableUnit("nm", 1e9), ReadableUnit("pm", 1e12))
_SHARES: Final = (PERCENT, ReadableUnit("ppm", 1e6))
_STIFFNESS: Final = ReadableUnit("N/µm", 1e-6)
_FURTHER_ROWS: Final = ("-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (7, 2)))


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
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, _HEIGHT * MILLIMETRE))
        grid = figure.add_gridspec(2, 2)
        _displacements(figure.add_subplot(grid[0, 0]), turn)
        polar = figure.add_subplot(grid[0, 1], projection="polar")
        assert isinstance(polar, PolarAxes)
        _ball_load(polar, turn)
        _stiffnesses(figure.add_subplot(grid[1, 0]), turn)
        _harmonics(figure.add_subplot(grid[1, 1]), turn)
        if turn.case.title:
            add_title(figure, turn.case.title)
    return figure


def _displacements(axes: Axes, turn: CageTurn) -> None:
    if not np.isfinite(turn.solved.displacement.array).any():
        empty_frame(axes, said("no point has a result"))
        return
    variation = turn.variation("displacement")
    extent = variation.peak_to_peak[:3]
    unit = _fitting(_LENGTHS, extent) if turn.converged else _LENGTHS[0]
    for index, name in enumerate(_SHIFTS):
        values = turn.solved.displacement.array[:, index]
        if turn.converged:
            values = _about(values, variation.mean[index], extent[index])
        _line(axes, turn, unit.of(values), index, name)
    label = said("About the mean") if turn.converged else said("Displacement of the inner ring")
    _angle_panel(axes, turn, unit.label(label))
    _level_if_flat(axes, turn.converged and not extent.any())
    _headed(axes, said("Displacement of the inner ring"))


def _stiffnesses(axes: Axes, turn: CageTurn) -> None:
    if not np.isfinite(turn.solved.stiffness.array).any():
        empty_frame(axes, said("no point has a result"))
        return
    variation = turn.variation("stiffness")
    extent, mean = np.diagonal(variation.peak_to_peak)[:3], np.diagonal(variation.mean)[:3]
    mean = np.where(mean == 0.0, 1.0, mean)  # cylindrical rollers do not hold the ring along x
    unit = _fitting(_SHARES, extent / np.abs(mean)) if turn.converged else _STIFFNESS
    for index, name in enumerate(_SHIFTS):
        values = turn.solved.stiffness.array[:, index, index]
        if turn.converged:
            values = _about(values / mean[index], 1.0, extent[index])
        _line(axes, turn, unit.of(values), index, f"{name}–{name}")
    label = said("About the mean") if turn.converged else said("Stiffness")
    _angle_panel(axes, turn, unit.label(label))
    _level_if_flat(axes, turn.converged and not extent.any())
    _headed(axes, said("Stiffness"))


def _fitting(units: tuple[ReadableUnit, ...], extents: Floats) -> ReadableUnit:
    """Return the unit in which the greatest extent is at least a tenth, else the last."""
    greatest = float(np.nanmax(np.abs(extents)))
    fitting = (unit for unit in units if unit.factor * greatest >= 0.1)
    return next(fitting, units[0] if greatest == 0.0 else units[-1])


def _about(values: Floats, mean: float, extent: float) -> Floats:
    """Return what a quantity does about its mean; no rounding where it does nothing."""
    return values - mean if extent else np.zeros_like(values)


def _line(axes: Axes, turn: CageTurn, values: Floats, index: int, name: str) -> None:
    """Draw one line over the period, its first point repeated at the end."""
    angle = np.degrees(np.append(turn.angle, turn.period))
    axes.plot(angle, np.append(values, values[0]), label=name, **series(index).keywords())


def _angle_panel(axes: Axes, turn: CageTurn, label: str) -> None:
    axes.set_xlim(0.0, float(np.degrees(turn.period)))
    axes.margins(y=0.08)
    azimuth = worded(
        turn.elements,
        said("Azimuth of the first ball (°)"),
        said("Azimuth of the first roller (°)"),
    )
    label_x(axes, azimuth)
    label_y(axes, label)


def _headed(axes: Axes, title: str) -> None:
    """Put the legend, if there is one, over the frame, and the title over the legend."""
    legend_above(axes)
    axes.set_title(title, loc="left", pad=6.0 if axes.get_legend() is None else 20.0)


def _level_if_flat(axes: Axes, flat: bool) -> None:
    """Give what does not vary a scale on which it is a line, with a word beside it."""
    if flat:
        axes.set_ylim(-1.0, 1.0)
        axes.set_yticks([0.0])
        axes.text(0.5, 0.7, said("no variation"), transform=axes.transAxes, ha="center", color=GREY)


def _ball_load(axes: PolarAxes, turn: CageTurn) -> None:
    histories = turn.histories
    if not any(np.isfinite(history.inner.load).any() for history in histories):
        empty_frame(axes, said("no point has a result"))
        return
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    for history in histories:
        azimuth = np.append(history.azimuth, history.azimuth[0] + 2.0 * np.pi)
        races: tuple[tuple[Race, Series, ContactHistory], ...] = (
            ("inner", INNER, history.inner),
            ("outer", OUTER, history.outer),
        )
        for race, line, contact in races:
            look = line.keywords()
            if history.row:  # the race's colour, a line of the row's own
                look["linestyle"] = _FURTHER_ROWS[(history.row - 1) % len(_FURTHER_ROWS)]
            load = 1e-3 * np.append(contact.load, contact.load[0])
            axes.plot(azimuth, load, label=race_name(race, history.row, len(histories)), **look)
    axes.set_ylim(bottom=0.0)
    axes.set_rlabel_position(112.5)
    axes.yaxis.set_major_formatter(PlainNumbers())
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2)
    title = worded(
        turn.elements,
        said("Load of one ball over a turn (kN)"),
        said("Load of one roller over a turn (kN)"),
    )
    axes.set_title(title, pad=10.0)


def _harmonics(axes: Axes, turn: CageTurn) -> None:
    amplitudes = np.abs(turn.variation("displacement").harmonics[:_MOST_ORDERS, :3])
    if not amplitudes.any() or not turn.converged:
        empty_frame(
            axes, said("no variation") if turn.converged else said("not every point has a result")
        )
    else:
        unit = _fitting(_LENGTHS, amplitudes)
        _bars(axes, unit.of(amplitudes))
        label_y(axes, unit.label(said("Amplitude")))
        axes.set_yscale("log")
    frequency = turn.passage_frequency
    known = np.isfinite(frequency)
    label = worded(
        turn.elements, said("Harmonic of the ball passage"), said("Harmonic of the roller passage")
    )
    behind = f"\n({number(frequency)} Hz)" if known else ""
    axes.set_xlabel(label + behind, parse_math=False)
    _headed(axes, said("Harmonics of the displacement"))


def _bars(axes: Axes, amplitudes: Floats) -> None:
    """Draw a group of bars for each harmonic, from a common foot."""
    order = np.arange(1, len(amplitudes) + 1)
    greatest = amplitudes.max()
    shown = np.where(amplitudes > _DECADES * greatest, amplitudes, np.nan)
    for index, name in enumerate(_SHIFTS):
        look, place = series(index), order + _BAR * (index - 1)
        axes.bar(place, shown[:, index], width=0.92 * _BAR, color=look.color, label=name)
    axes.set_xticks(order)
    axes.set_xlim(0.5, len(amplitudes) + 0.5)
    axes.set_ylim(bottom=0.4 * np.nanmin(shown), top=2.0 * greatest)
