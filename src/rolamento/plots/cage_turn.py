"""A turn of the cage, drawn: displacement, stiffness and their harmonics, and one ball's way."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from rolamento.plots.axes_units import PERCENT, ReadableUnit
from rolamento.plots.frame import (
    GREY,
    PlainNumbers,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    number,
)
from rolamento.plots.style import INNER, MILLIMETRE, OUTER, WIDTH, series, styled
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.studies.cage_turn import BallHistory, CageTurn

__all__ = ["cage_turn_figure"]

Floats = NDArray[np.float64]

_HEIGHT: Final = 145.0
_SHIFTS: Final = ("x", "y", "z")
_MOST_ORDERS: Final = 6
_DECADES: Final = 1e-5  # of the greatest amplitude: bars below are not drawn
_BAR: Final = 0.26
_LENGTHS: Final = (
    ReadableUnit("µm", 1e6),
    ReadableUnit("nm", 1e9),
    ReadableUnit("pm", 1e12),
)
_SHARES: Final = (PERCENT, ReadableUnit("ppm", 1e6))
_STIFFNESS: Final = ReadableUnit("N/µm", 1e-6)
_FURTHER_ROWS: Final = ("-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (7, 2)))


@dataclass(frozen=True, slots=True)
class _Words:
    """What the other figures do not say."""

    azimuth: str
    displacement: str
    stiffness: str
    about_mean: str
    one_ball: str
    harmonics: str
    harmonic: str
    amplitude: str
    of_frequency: str
    no_variation: str
    gap: str
    no_result: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        azimuth="Azimuth of the first ball (°)",
        displacement="Displacement of the inner ring",
        stiffness="Stiffness",
        about_mean="About the mean",
        one_ball="Load of one ball, once round (kN)",
        harmonics="Harmonics of the displacement",
        harmonic="Harmonic of the ball passage",
        amplitude="Amplitude",
        of_frequency="\n({frequency} Hz)",
        no_variation="no variation",
        gap="not every point has a result",
        no_result="no point has a result",
    ),
    "pt": _Words(
        azimuth="Azimute da primeira esfera (°)",
        displacement="Deslocamento do anel interno",
        stiffness="Rigidez",
        about_mean="Em torno da média",
        one_ball="Carga de uma esfera, uma volta (kN)",
        harmonics="Harmônicos do deslocamento",
        harmonic="Harmônico da passagem de esferas",
        amplitude="Amplitude",
        of_frequency="\n({frequency} Hz)",
        no_variation="sem variação",
        gap="nem todo ponto tem resultado",
        no_result="nenhum ponto tem resultado",
    ),
}


def cage_turn_figure(turn: CageTurn, language: str = "en") -> Figure:
    """Draw a turn of the cage in four panels.

    How the ring moves about its mean place, how its stiffness varies, the load of one ball on its
    way round, and the amplitudes of the displacement's harmonics. Where a point has no result,
    displacement and stiffness are drawn as they are, with a gap.

    Parameters
    ----------
    turn
        From `rolamento.studies.cage_turn.cage_turn`.
    language
        ``"en"`` or ``"pt"``.
    """
    shared, words = plot_words(language), _WORDS.get(language, _WORDS["en"])
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, _HEIGHT * MILLIMETRE))
        grid = figure.add_gridspec(2, 2)
        _displacements(figure.add_subplot(grid[0, 0]), turn, shared, words)
        polar = figure.add_subplot(grid[0, 1], projection="polar")
        assert isinstance(polar, PolarAxes)
        _ball_load(polar, turn.histories, shared, words)
        _stiffnesses(figure.add_subplot(grid[1, 0]), turn, shared, words)
        _harmonics(figure.add_subplot(grid[1, 1]), turn, shared, words)
        if turn.case.title:
            add_title(figure, turn.case.title)
    return figure


def _displacements(axes: Axes, turn: CageTurn, shared: PlotWords, words: _Words) -> None:
    if not np.isfinite(turn.solved.displacement.array).any():
        empty_frame(axes, words.no_result)
        return
    variation = turn.variation("displacement")
    extent = variation.peak_to_peak[:3]
    unit = _fitting(_LENGTHS, extent) if turn.converged else _LENGTHS[0]
    for index, name in enumerate(_SHIFTS):
        values = turn.solved.displacement.array[:, index]
        if turn.converged:
            values = _about(values, variation.mean[index], extent[index])
        _line(axes, turn, unit.of(values), index, name)
    label = words.about_mean if turn.converged else words.displacement
    _angle_panel(axes, turn, shared, words, unit.label(label))
    _level_if_flat(axes, turn.converged and not extent.any(), words)
    _headed(axes, words.displacement)


def _stiffnesses(axes: Axes, turn: CageTurn, shared: PlotWords, words: _Words) -> None:
    if not np.isfinite(turn.solved.stiffness.array).any():
        empty_frame(axes, words.no_result)
        return
    variation = turn.variation("stiffness")
    extent, mean = np.diagonal(variation.peak_to_peak)[:3], np.diagonal(variation.mean)[:3]
    unit = _fitting(_SHARES, extent / np.abs(mean)) if turn.converged else _STIFFNESS
    for index, name in enumerate(_SHIFTS):
        values = turn.solved.stiffness.array[:, index, index]
        if turn.converged:
            values = _about(values / mean[index], 1.0, extent[index])
        _line(axes, turn, unit.of(values), index, f"{name}–{name}")
    label = words.about_mean if turn.converged else words.stiffness
    _angle_panel(axes, turn, shared, words, unit.label(label))
    _level_if_flat(axes, turn.converged and not extent.any(), words)
    _headed(axes, words.stiffness)


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


def _angle_panel(axes: Axes, turn: CageTurn, shared: PlotWords, words: _Words, label: str) -> None:
    axes.set_xlim(0.0, float(np.degrees(turn.period)))
    axes.margins(y=0.08)
    label_x(axes, words.azimuth, shared)
    label_y(axes, label, shared)


def _headed(axes: Axes, title: str) -> None:
    """Put the legend, if there is one, over the frame, and the title over the legend."""
    legend_above(axes)
    axes.set_title(title, loc="left", pad=6.0 if axes.get_legend() is None else 20.0)


def _level_if_flat(axes: Axes, flat: bool, words: _Words) -> None:
    """Give what does not vary a scale on which it is a line, with a word beside it."""
    if flat:
        axes.set_ylim(-1.0, 1.0)
        axes.set_yticks([0.0])
        axes.text(0.5, 0.7, words.no_variation, transform=axes.transAxes, ha="center", color=GREY)


def _ball_load(
    axes: PolarAxes, histories: tuple[BallHistory, ...], shared: PlotWords, words: _Words
) -> None:
    if not any(np.isfinite(history.inner.load).any() for history in histories):
        empty_frame(axes, words.no_result)
        return
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    for history in histories:
        row = shared.row.format(number=history.row) if len(histories) > 1 else ""
        azimuth = np.append(history.azimuth, history.azimuth[0] + 2.0 * np.pi)
        for race, line, contact in (
            (shared.inner, INNER, history.inner),
            (shared.outer, OUTER, history.outer),
        ):
            look = line.keywords()
            if history.row:  # the race's colour, a line of the row's own
                look["linestyle"] = _FURTHER_ROWS[(history.row - 1) % len(_FURTHER_ROWS)]
            load = 1e-3 * np.append(contact.load, contact.load[0])
            axes.plot(azimuth, load, label=f"{race} {row}".strip(), **look)
    axes.set_ylim(bottom=0.0)
    axes.set_rlabel_position(112.5)
    axes.yaxis.set_major_formatter(PlainNumbers())
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2)
    axes.set_title(words.one_ball, pad=10.0)


def _harmonics(axes: Axes, turn: CageTurn, shared: PlotWords, words: _Words) -> None:
    amplitudes = np.abs(turn.variation("displacement").harmonics[:_MOST_ORDERS, :3])
    if not amplitudes.any() or not turn.converged:
        empty_frame(axes, words.no_variation if turn.converged else words.gap)
    else:
        unit = _fitting(_LENGTHS, amplitudes)
        _bars(axes, unit.of(amplitudes))
        label_y(axes, unit.label(words.amplitude), shared)
        axes.set_yscale("log")
    frequency = turn.passage_frequency
    known = np.isfinite(frequency)
    of = words.of_frequency.format(frequency=number(frequency, shared)) if known else ""
    axes.set_xlabel(words.harmonic + of, parse_math=False)
    _headed(axes, words.harmonics)


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
