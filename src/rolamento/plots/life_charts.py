"""Charts of one solved case's life: a_ISO, the load zone, and what would help."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.life.iso281_modified import GREATEST, life_modification_factor
from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
    number,
)
from rolamento.plots.life import in_order, theory_look
from rolamento.plots.life_words import LifeWords, life_words
from rolamento.plots.style import SERIES, new_figure, styled
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.life import Change, LifeSummary
    from rolamento.studies.life_diagram import ZoneLife

__all__ = ["aiso_chart", "helps_figure", "life_over_zone", "load_zone_figure", "what_helps"]

Floats = NDArray[np.float64]

_RATIOS: Final = (0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0)
"""κ of the curves, as on the standard's charts."""
_STRENGTH: Final = (0.005, 5.0)
_FACTOR: Final = (0.1, GREATEST)
_POINTS: Final = 400
_ROOM: Final = 1.4
_LABELLED: Final = {4.0: 38.0, 3.0: 24.0, 2.0: 15.5, 1.5: 10.0, 1.0: 6.5}
"""a_ISO at which curves are named that crowd: down a slope, beside each other."""
_HIGH: Final = 27.0
"""Likewise of the others, where they run up that far."""
_MARKERS: Final = {"iso281_modified": SERIES[1].marker, "iso16281_modified": SERIES[0].marker}
_BAR: Final = 0.62
_MARGIN: Final = 0.2
_TICKS: Final = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0)


def aiso_chart(
    summary: LifeSummary | None = None, axes: Axes | None = None, *, language: str = "en"
) -> Axes:
    """Draw a_ISO over e_C C_u/P for κ from 0.1 to 4, and where solved cases are on it.

    Parameters
    ----------
    summary
        Of `rolamento.life`, of one case or several; without it the chart alone.
    axes
        To draw on; of a new figure if not given.
    language
        ``"en"`` or ``"pt"``.

    Curves are without additives; a case with them may lie above its curve, at 3 at most.
    ISO 281:2007, 9.3.3: radial ball bearings.
    """
    shared, words = plot_words(language), life_words(language)
    with styled():
        axes = new_figure(height=110.0)[1] if axes is None else axes
        points = [] if summary is None else _factors_of(summary, words, shared)
        limits = _wide_enough([strength for *_, strength, _ in points])
        strength = np.geomspace(*limits, _POINTS)
        for ratio in _RATIOS:
            factor = life_modification_factor(ratio, strength, 1.0, 1.0)
            axes.plot(strength, factor, color=GREY, linewidth=0.8, zorder=1.5)
            _name_curve(axes, strength, factor, ratio, f"{words.viscosity_ratio} ", shared)
        for label, marker, colour, x, y in points:
            axes.plot(
                x, y, label=label, marker=marker, color=colour, linestyle="", markersize=9.0,
                markerfacecolor="none", markeredgewidth=1.6, zorder=3.0, clip_on=False,
            )  # fmt: skip
        log_scale(axes, "x", shared)
        log_scale(axes, "y", shared)
        axes.set_xlim(*limits)
        axes.set_ylim(_FACTOR[0], _FACTOR[1] * _ROOM)
        axes.set_xlabel(r"$e_C\,C_u/P$")
        axes.set_ylabel(r"$a_\mathrm{ISO}$")
        if summary is not None and not points:
            axes.text(0.04, 0.92, words.no_factor, transform=axes.transAxes, parse_math=False)
        legend_above(axes)
    return axes


def load_zone_figure(life: ZoneLife, language: str = "en") -> Figure:
    """Draw life over the load zone, as `life_over_zone`, with the case's title."""
    with styled():
        figure, axes = new_figure(height=95.0)
        life_over_zone(life, axes, language=language)
        if life.case.title:
            add_title(figure, life.case.title)
    return figure


def life_over_zone(life: ZoneLife, axes: Axes | None = None, *, language: str = "en") -> Axes:
    """Draw life over the load zone ε of a radially loaded bearing, and the case's own place.

    Parameters
    ----------
    life
        Of `rolamento.studies.life_diagram.lives_over_zone`; where the case's load is radial, the
        clearance that makes each zone under it stands below.
    axes, language
        As `aiso_chart`.
    """
    shared, words = plot_words(language), life_words(language)
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        axes.plot(life.zone, life.life_ratio, color=SERIES[0].color)
        axes.axvline(0.5, color=GREY, linewidth=0.9, label=words.no_clearance)
        best, ratio = life.best
        label = f"{words.best}: ε = {number(best, shared, 2)}, {_times(ratio, shared)}"
        axes.plot(best, ratio, label=label, **_mark(2))
        if life.own is not None and life.zone[0] <= life.own[0] <= life.zone[-1]:
            own, ratio = life.own
            label = f"{words.own}: ε = {number(own, shared, 2)}, {_times(ratio, shared)}"
            axes.plot(own, ratio, label=label, **_mark(1))
        _zone_ticks(axes, life, shared, words)
        label_y(axes, words.zone_life, shared)
        axes.set_xlim(0.0, float(life.zone[-1]))
        axes.set_ylim(0.0, 1.15 * float(np.max(life.life_ratio)))
        legend_above(axes)
    return axes


def helps_figure(changes: Sequence[Change], language: str = "en", title: str = "") -> Figure:
    """Draw what would help, as `what_helps`, with a title."""
    with styled():
        figure, axes = new_figure(height=24.0 + 9.0 * max(len(changes), 2))
        what_helps(changes, axes, language=language)
        if title:
            add_title(figure, title)
    return figure


def what_helps(
    changes: Sequence[Change], axes: Axes | None = None, *, language: str = "en"
) -> Axes:
    """Draw a bar for each change: life after it over life before; the most helpful at the top.

    Parameters
    ----------
    changes
        Of `rolamento.life.sensitivity`; one without a ratio has a line without a bar.
    axes, language
        As `aiso_chart`.
    """
    shared, words = plot_words(language), life_words(language)
    with styled():
        axes = new_figure()[1] if axes is None else axes
        ratios = np.array([change.life_ratio for change in changes], dtype=np.float64)
        known = np.isfinite(ratios)
        if not known.any():
            return empty_frame(axes, shared.no_result)
        places = np.arange(len(changes))
        colours = [SERIES[2].color if ratio >= 1.0 else SERIES[1].color for ratio in ratios]
        axes.barh(places, np.where(known, ratios - 1.0, 0.0), _BAR, left=1.0, color=colours)
        for place, ratio in zip(places, ratios, strict=True):
            text = _times(ratio, shared) if np.isfinite(ratio) else shared.no_result
            side = -4 if ratio < 1.0 else 4
            axes.annotate(
                text, (ratio if np.isfinite(ratio) else 1.0, place), (side, 0),
                textcoords="offset points", va="center", ha="right" if side < 0 else "left",
                fontsize=8.0, parse_math=False,
            )  # fmt: skip
        axes.axvline(1.0, color=GREY, linewidth=0.9)
        names = [words.changes.get(change.name, change.name) for change in changes]
        axes.set_yticks(places, names, parse_math=False)
        axes.invert_yaxis()
        axes.grid(False, axis="y")
        least, most = min(float(ratios[known].min()), 1.0), max(float(ratios[known].max()), 1.0)
        room = _MARGIN * max(most - least, 0.1)
        axes.set_xlim(least - (room if least < 1.0 else 0.0), most + room)
        label_x(axes, words.life_ratio, shared)
    return axes


def _factors_of(
    summary: LifeSummary, words: LifeWords, shared: PlotWords
) -> list[tuple[str, str, str, Floats, Floats]]:
    """Label, marker, colour, e_C C_u/P and a_ISO of each modified theory; bounds left out."""
    found = []
    for theory in in_order(set(_MARKERS) & set(summary.theories)):
        record = summary[theory]
        factor, clean = record.factors["a_iso"], record.factors["contamination_factor"]
        load = record.factors.get("equivalent_load", summary.loads.dynamic)
        with np.errstate(divide="ignore", invalid="ignore"):
            strength = clean * summary.ratings.fatigue_of_set / load
        known = np.isfinite(factor) & ~record.below
        there = known & np.isfinite(strength) & (strength > 0.0)
        if not there.any():
            continue
        label = words.theories[theory]
        if there.sum() == 1:
            ratio = float(record.factors["viscosity_ratio"][there][0])
            label += f", {words.viscosity_ratio} {number(ratio, shared, 3)}"
            label += f", {words.factor} = {number(float(factor[there][0]), shared, 3)}"
        if summary.conditions.additives:
            label += f", {words.with_additives}"
        colour = theory_look(theory)["color"]
        found.append((label, _MARKERS[theory], colour, strength[there], factor[there]))
    return found


def _wide_enough(strengths: Sequence[Floats]) -> tuple[float, float]:
    """Return limits that hold all points, whole in the standard's own range."""
    all_of_them = np.concatenate([np.array(_STRENGTH), *strengths])
    least, most = float(all_of_them.min()), float(all_of_them.max())
    low = _STRENGTH[0] if least >= _STRENGTH[0] else least / 2.0
    return low, _STRENGTH[1] if most <= _STRENGTH[1] else most * 2.0


def _name_curve(
    axes: Axes, strength: Floats, factor: Floats, ratio: float, prefix: str, shared: PlotWords
) -> None:
    """Write κ on a curve: where it has room if it is steep, else at its right end."""
    height = _LABELLED.get(ratio, _HIGH)
    steep = float(factor[-1]) > height
    place = int(np.argmax(factor > height)) if steep else len(factor) - 1
    axes.annotate(
        (prefix if ratio == max(_RATIOS) else "") + number(ratio, shared),
        (float(strength[place]), float(factor[place])),
        (0.0, 0.0) if steep else (3.0, 0.0),
        textcoords="offset points",
        ha="center" if steep else "left",
        va="center",
        fontsize=7.0,
        annotation_clip=False,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6} if steep else None,
    )


def _zone_ticks(axes: Axes, life: ZoneLife, shared: PlotWords, words: LifeWords) -> None:
    """Number the zones, and below them the clearance that makes each under the case's load."""
    under_load = bool(np.isfinite(life.clearance).all())

    def written(zone: float) -> str:
        above = number(zone, shared)
        if not under_load:
            return above
        micrometres = round(1e6 * float(np.interp(zone, life.zone, life.clearance)))
        return f"{above}\n{number(float(micrometres), shared)}"

    axes.set_xticks(_TICKS, [written(tick) for tick in _TICKS])
    name = f"{words.zone}\n{words.clearance}" if under_load else words.zone
    axes.set_xlabel(name, parse_math=False)


def _times(ratio: float, shared: PlotWords) -> str:
    return f"× {number(ratio, shared, 3)}"


def _mark(index: int) -> dict[str, Any]:
    look = SERIES[index]
    return {"color": look.color, "marker": look.marker, "linestyle": "", "markersize": 7.0}
