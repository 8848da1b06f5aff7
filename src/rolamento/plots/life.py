"""Figures of life: over a field, over load with tests beside it, a_ISO, the load zone, what helps.

A theory has the same colour and line on all of them, by its rank.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, series_look
from rolamento.charts.axes_units import MEGAPASCAL, read_values
from rolamento.charts.drawing import draw
from rolamento.charts.field_axis import field_axis
from rolamento.charts.frame import (
    GREY,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
    panels,
)
from rolamento.charts.style import SERIES, in_style, new_figure, styled
from rolamento.charts.texts import capitalised, no_result, no_result_count, number, theory_label
from rolamento.life.iso281_modified import MAXIMUM_FACTOR, life_modification_factor
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.theories import BY_RANK, THEORIES
from rolamento.studies.names import setting_name
from rolamento.units import HOUR
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.life import Change, LifeSummary
    from rolamento.tasks.life_over import LifeCurve, LoadLives, ZoneLife

__all__ = [
    "BearingTests",
    "aiso_chart",
    "helps_figure",
    "life_figure",
    "life_over_zone",
    "lives_by_theory",
    "load_over_life",
    "load_zone_figure",
    "sn_figure",
    "theory_look",
    "what_helps",
]

Floats = NDArray[np.float64]
By = Literal["load", "pressure"]

_LOAD_ROOM: Final = 1.15
_BLACK: Final = "#000000"
_ABOVE: Final = 10.0
"""How far an upper bound may lead the axis beyond the other theories."""
_ROOM: Final = 1.5
_VARIANTS: Final = ("solid", "dash", "dot", "dashdot", "dashdotdot", "longdash")
_RATIOS: Final = (0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0)
"""κ of the curves, as on the standard's charts."""
_STRENGTH: Final = (0.005, 5.0)
_FACTOR: Final = (0.1, MAXIMUM_FACTOR)
_POINTS: Final = 400
_AISO_ROOM: Final = 1.4
_LABELLED: Final = {4.0: 38.0, 3.0: 24.0, 2.0: 15.5, 1.5: 10.0, 1.0: 6.5}
"""a_ISO at which curves are named that crowd: down a slope, beside each other."""
_HIGH: Final = 27.0
"""The same for the others, where they run up that far."""
_BAR: Final = 0.62
_MARGIN: Final = 0.2
_TICKS: Final = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0)


def life_figure(curves: Sequence[LifeCurve]) -> Figure:
    """Draw life over a field, with the case's title.

    Parameters
    ----------
    curves
        The case's own first, then its variants; over one field.
    """
    return panels(
        lambda axes: lives_by_theory(curves, axes), title=curves[0].case.title, height=110.0
    )


def lives_by_theory(curves: Sequence[LifeCurve], axes: Axes | None = None) -> Axes:
    """Draw the life by every theory, faintly where it does not hold; of variants what leads.

    Lives are in hours, or in millions of revolutions where nothing turns at any point. An endless
    life leaves the frame at the top; a point without a result has a cross at its foot.

    Parameters
    ----------
    curves
        As in `life_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    axes = new_figure(height=110.0)[1] if axes is None else axes
    return _draw_theories(lives_chart(curves), axes)


@in_style
def _draw_theories(chart: Chart, axes: Axes) -> Axes:
    """Draw a chart of theories, its legend in columns; say what its faint lines are."""
    faint = any(line.valid is not None and not line.valid.all() for line in chart.lines)
    over = said("faint: the theory is not valid there") if faint else ""
    return draw(replace(chart, over_names=over), axes)


def lives_chart(curves: Sequence[LifeCurve]) -> Chart:
    """Return the life by every theory, and what is required."""
    own = curves[0]
    turns = own.in_hours
    lines = list(_lines_of_theories(curves))
    limits = _limits_of_lives((life, theory) for life, _, theory, _, _ in lines)
    if limits is None:
        endless = any(np.isposinf(life).any() for life, *_ in lines)
        return nothing(said("fatigue ends no life here") if endless else no_result())
    x = read_values(own.over.field, own.values)[0]
    series = []
    for life, valid, _, name, look in lines:
        beyond = not np.any(life < limits[1])
        shown = said("{name}, above", name=name) if beyond else name
        series.append(Line(x, life, shown, look, valid=valid | ~np.isfinite(life)))
    marks: tuple[Mark, ...] = ()
    if turns and own.case.life is not None and own.case.life.required_life is not None:
        wanted = own.case.life.required_life / HOUR
        marks = (Mark(wanted, said("required life"), Look("grey", width=0.65)),)
        limits = min(limits[0], wanted / _ROOM), max(limits[1], wanted * _ROOM)
    missing = own.status != "converged"
    if missing.any():
        count = int(missing.sum())
        why, look = no_result_count(count, len(missing)), Look("grey", mark="thin")
        series.append(Line(x[missing], np.zeros(count), why, look, "points", height=0.0))
    upright = Axis(limits=limits, log=True, label=said("Life (h)") if turns
                   else said("Life (10⁶ rev)"))  # fmt: skip
    return Chart(tuple(series), field_axis(own.over.field, own.values), upright, marks=marks)


def theory_look(theory: str) -> Look:
    """Return the colour and line of a theory, the same on every figure."""
    rank = THEORIES[theory].rank
    look = series_look(rank)
    return look if rank < len(SERIES) else replace(look, dash="fine")


def _limits_of_lives(lives: Iterable[tuple[Floats, str]]) -> tuple[float, float] | None:
    """Return how far an axis of lives goes; None if there is none.

    An upper bound, decades above all others, leads it a little, and not at all from far away.
    """
    known = [(life[np.isfinite(life) & (life > 0.0)], theory) for life, theory in lives]
    known = [(life, theory) for life, theory in known if life.size]
    if not known:
        return None
    others = [life for life, theory in known if not THEORIES[theory].bound]
    least = min(float(life.min()) for life, _ in known)
    most = max(float(life.max()) for life, _ in known)
    if others:
        highest = max(float(life.max()) for life in others)
        near = any(
            life.min() < _ABOVE * highest for life, theory in known if THEORIES[theory].bound
        )
        most = min(most, _ABOVE * highest if near else highest)
    return least / _ROOM, most * _ROOM


def _lines_of_theories(
    curves: Sequence[LifeCurve],
) -> Iterable[tuple[Floats, NDArray[np.bool_], str, str, Look]]:
    """Life, where it is valid, theory, name and look of every line."""
    first = curves[0]
    for theory in _by_rank(first.theories):
        name, own = theory_label(theory), first[theory]
        if np.isnan(first.shown(own)).all():
            continue  # it knows nothing of such a bearing
        yield first.shown(own), own.valid, theory, name, theory_look(theory)
    for place, curve in enumerate(curves[1:], start=1):
        leading = curve.headline
        names = dict.fromkeys(theory for theory in leading.theory.tolist() if theory)
        look = Look("ink", _VARIANTS[place % len(_VARIANTS)])
        theories = " / ".join(map(theory_label, names))
        # in the unit of the first, whether this one turns or not
        led = leading.hours if first.in_hours else leading.life
        label = f"{theories}, {setting_name(curve.label)}"
        yield led, leading.valid, next(iter(names), REFERENCE.name), label, look


def _by_rank(theories: Iterable[str]) -> list[str]:
    return sorted(theories, key=BY_RANK.index)


# --- over load --------------------------------------------------------------------------------


class BearingTests(NamedTuple):
    """Bearings that ran: what they are called, how long and under what they ran, which failed.

    revolutions: millions; load: P/C, or Pa on a figure over pressure; failed: else they were
    taken off whole. Of each, (bearings,).
    """

    label: str
    revolutions: ArrayLike
    load: ArrayLike
    failed: ArrayLike


def sn_figure(lives: LoadLives, *, by: By = "load", tests: Sequence[BearingTests] = ()) -> Figure:
    """Draw life over load, as `load_over_life`, with the case's title."""
    return panels(
        lambda axes: load_over_life(lives, axes, by=by, tests=tests),
        title=lives.case.title,
        height=115.0,
    )


def load_over_life(
    lives: LoadLives,
    axes: Axes | None = None,
    *,
    by: By = "load",
    tests: Sequence[BearingTests] = (),
) -> Axes:
    """Draw load over life by every theory: straight the basic one, bent those with a fatigue limit.

    Parameters
    ----------
    lives
        Of `rolamento.tasks.life_over.lives_over_load`.
    axes
        To draw on; of a new figure if not given.
    by
        Upright is P/C ("load"), or the greatest contact pressure ("pressure").
    tests
        Bearings that ran: filled marks of those that failed, hollow ones of the others.

    A line is faint where its theory does not hold; the case itself has a mark on each.
    """
    axes = new_figure(height=115.0)[1] if axes is None else axes
    return _draw_theories(load_chart(lives, by=by, tests=tests), axes)


def load_chart(lives: LoadLives, *, by: By = "load", tests: Sequence[BearingTests] = ()) -> Chart:
    """Return load over life; parameters as of `load_over_life`."""
    upright = lives.load if by == "load" else MEGAPASCAL.of(lives.pressure)
    found = {name: record.life for name, record in lives.theories.items()}
    limits = _limits_of_lives((life, name) for name, life in found.items())
    if limits is None or not np.isfinite(upright).any():
        return nothing(no_result())
    lines = []
    for theory in _by_rank(found):
        life, valid = found[theory], lives.theories[theory].valid
        if np.isnan(life).all():
            continue  # it knows nothing of such a bearing
        there = np.isfinite(life) & np.isfinite(upright)  # without an end: beyond the frame
        name, look = theory_label(theory), theory_look(theory)
        lines.append(Line(life[there], upright[there], name, look, valid=valid[there]))
    own = np.array([life[lives.own] for life in found.values()])
    at = np.full(len(own), upright[lives.own])
    lines.append(Line(own, at, said("this case"), Look("ink", hollow=True), "points"))
    for place, one in enumerate(tests):
        lines += _tested(one, place, by)
    marks: tuple[Mark, ...] = ()
    if by == "load":
        name = said("fatigue load limit C_u")
        marks = (Mark(lives.fatigue_load, name, Look("grey", width=0.65)),)
    ran = np.array(
        [limits[0] * _LOAD_ROOM, *(n for one in tests for n in np.ravel(one.revolutions))]
    )
    least = float(ran[ran > 0.0].min()) / _LOAD_ROOM
    across = Axis(limits=(least, limits[1]), log=True, label=said("Life (10⁶ rev)"))
    ends = _upright_limits(lives, upright, by)
    return Chart(tuple(lines), across, Axis(limits=ends, log=True, label=_upright_name(lives, by)),
                 marks=marks)  # fmt: skip


def _tested(tests: BearingTests, place: int, by: By) -> list[Line]:
    look = series_look(place + 1)
    ran, load = np.asarray(tests.revolutions, np.float64), np.asarray(tests.load, np.float64)
    upright = load if by == "load" else MEGAPASCAL.of(load)
    failed = np.asarray(tests.failed, np.bool_)
    return [
        Line(ran[chosen], upright[chosen], f"{tests.label}: {ended}",
             replace(look, hollow=ended != said("failed")), "points")
        for chosen, ended in ((failed, said("failed")), (~failed, said("suspended")))
        if chosen.any()
    ]  # fmt: skip


def _upright_limits(lives: LoadLives, upright: Floats, by: By) -> tuple[float, float]:
    known = upright[np.isfinite(upright)]
    least, most = float(known.min()), float(known.max())
    if by == "load":
        least = min(least, lives.fatigue_load)
    return least / _LOAD_ROOM, most * _LOAD_ROOM


def _upright_name(lives: LoadLives, by: By) -> str:
    if by == "pressure":
        return MEGAPASCAL.label(said("Maximum contact pressure"))
    return "P/C (ISO/TS 16281)" if lives.by_reference else "P/C (ISO 281)"


# --- a_ISO, the load zone, what would help ----------------------------------------------------


def aiso_chart(summary: LifeSummary | None = None, axes: Axes | None = None) -> Axes:
    """Draw a_ISO over e_C C_u/P for κ from 0.1 to 4, and where solved cases are on it.

    Parameters
    ----------
    summary
        Of `rolamento.life`, of one case or several; without it the chart alone.
    axes
        To draw on; of a new figure if not given.

    Curves are without additives; a case with them may lie above its curve, at 3 at most.
    ISO 281:2007, 9.3.3: radial ball bearings, or those of rollers for a roller bearing.
    """
    with styled():
        axes = new_figure(height=110.0)[1] if axes is None else axes
        points = [] if summary is None else _factors_of(summary)
        rollers = summary is not None and summary.headline.element == "roller"
        limits = _wide_enough([strength for *_, strength, _ in points])
        strength = np.geomspace(*limits, _POINTS)
        for ratio in _RATIOS:
            factor = life_modification_factor(ratio, strength, 1.0, 1.0, rollers=rollers)
            axes.plot(strength, factor, color=GREY, linewidth=0.8, zorder=1.5)
            _name_curve(axes, strength, factor, ratio, "κ = ")
        for label, marker, colour, x, y in points:
            axes.plot(
                x, y, label=label, marker=marker, color=colour, linestyle="", markersize=9.0,
                markerfacecolor="none", markeredgewidth=1.6, zorder=3.0, clip_on=False,
            )  # fmt: skip
        log_scale(axes, "x")
        log_scale(axes, "y")
        axes.set_xlim(*limits)
        axes.set_ylim(_FACTOR[0], _FACTOR[1] * _AISO_ROOM)
        axes.set_xlabel(r"$e_C\,C_u/P$")
        axes.set_ylabel(r"$a_\mathrm{ISO}$")
        if summary is not None and not points:
            axes.text(
                0.04,
                0.92,
                said("there is no a_ISO for this case"),
                transform=axes.transAxes,
                parse_math=False,
            )
        legend_above(axes)
    return axes


def load_zone_figure(life: ZoneLife) -> Figure:
    """Draw life over the load zone, as `life_over_zone`, with the case's title."""
    return panels(lambda axes: life_over_zone(life, axes), title=life.case.title, height=95.0)


def life_over_zone(life: ZoneLife, axes: Axes | None = None) -> Axes:
    """Draw life over the load zone ε of a radially loaded bearing, and the case's own place.

    Parameters
    ----------
    life
        Of `rolamento.tasks.life_over.lives_over_zone`; where the case's load is radial, the
        clearance that makes each zone under it stands below.
    axes
        As `aiso_chart`.
    """
    with styled():
        axes = new_figure(height=95.0)[1] if axes is None else axes
        axes.plot(life.zone, life.life_ratio, color=SERIES[0].color)
        axes.axvline(0.5, color=GREY, linewidth=0.9, label=said("no clearance"))
        best, ratio = life.best
        label = said("longest life: ε = {zone}, {ratio}", zone=number(best, 2), ratio=_times(ratio))
        axes.plot(best, ratio, label=label, **_mark(2))
        if life.own is not None and life.zone[0] <= life.own[0] <= life.zone[-1]:
            own, ratio = life.own
            label = said("this case: ε = {zone}, {ratio}", zone=number(own, 2), ratio=_times(ratio))
            axes.plot(own, ratio, label=label, **_mark(1))
        _zone_ticks(axes, life)
        label_y(axes, said("Life over life without clearance"))
        axes.set_xlim(0.0, float(life.zone[-1]))
        axes.set_ylim(0.0, 1.15 * float(np.max(life.life_ratio)))
        legend_above(axes)
    return axes


def helps_figure(changes: Sequence[Change], title: str = "") -> Figure:
    """Draw what would help, as `what_helps`, with a title."""
    return panels(
        lambda axes: what_helps(changes, axes),
        title=title,
        height=24.0 + 9.0 * max(len(changes), 2),
    )


def what_helps(changes: Sequence[Change], axes: Axes | None = None) -> Axes:
    """Draw a bar for each change: life after it over life before; the most helpful at the top.

    Parameters
    ----------
    changes
        Of `rolamento.life.sensitivity`; one without a ratio has a line without a bar.
    axes
        As `aiso_chart`.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        ratios = np.array([change.life_ratio for change in changes], dtype=np.float64)
        known = np.isfinite(ratios)
        if not known.any():
            return empty_frame(axes, no_result())
        places = np.arange(len(changes))
        colours = [SERIES[2].color if ratio >= 1.0 else SERIES[1].color for ratio in ratios]
        axes.barh(places, np.where(known, ratios - 1.0, 0.0), _BAR, left=1.0, color=colours)
        for place, ratio in zip(places, ratios, strict=True):
            text = _times(ratio) if np.isfinite(ratio) else no_result()
            side = -4 if ratio < 1.0 else 4
            axes.annotate(
                text, (ratio if np.isfinite(ratio) else 1.0, place), (side, 0),
                textcoords="offset points", va="center", ha="right" if side < 0 else "left",
                fontsize=8.0, parse_math=False,
            )  # fmt: skip
        axes.axvline(1.0, color=GREY, linewidth=0.9)
        names = [capitalised(change.note.text) for change in changes]
        axes.set_yticks(places, names, parse_math=False)
        axes.invert_yaxis()
        axes.grid(False, axis="y")
        least, most = min(float(ratios[known].min()), 1.0), max(float(ratios[known].max()), 1.0)
        room = _MARGIN * max(most - least, 0.1)
        axes.set_xlim(least - (1.5 * room if least < 1.0 else 0.0), most + room)
        label_x(axes, said("Life after the change over life before"))
    return axes


def _factors_of(summary: LifeSummary) -> list[tuple[str, str, str, Floats, Floats]]:
    """Label, marker, colour, e_C C_u/P and a_ISO of each modified theory; bounds left out."""
    found = []
    for theory in _by_rank(summary.theories):
        record = summary[theory]
        if "a_iso" not in record.factors:
            continue
        factor, clean = record.factors["a_iso"], record.factors["contamination_factor"]
        load = record.factors.get("equivalent_load", summary.loads.dynamic)
        with np.errstate(divide="ignore", invalid="ignore"):
            strength = clean * summary.ratings.fatigue_in_factor / load
        known = np.isfinite(factor) & ~record.below
        there = known & np.isfinite(strength) & (strength > 0.0)
        if not there.any():
            continue
        label = theory_label(theory)
        if there.sum() == 1:
            ratio = float(record.factors["viscosity_ratio"][there][0])
            label += f", κ = {number(ratio, 3)}"
            label += f", a_ISO = {number(float(factor[there][0]), 3)}"
        if summary.conditions.additives:
            label = said("{theory}, with additives", theory=label)
        look = SERIES[THEORIES[theory].rank]
        found.append((label, look.marker, look.color, strength[there], factor[there]))
    return found


def _wide_enough(strengths: Sequence[Floats]) -> tuple[float, float]:
    """Return limits that hold all points, whole in the standard's own range."""
    all_of_them = np.concatenate([np.array(_STRENGTH), *strengths])
    least, most = float(all_of_them.min()), float(all_of_them.max())
    low = _STRENGTH[0] if least >= _STRENGTH[0] else least / 2.0
    return low, _STRENGTH[1] if most <= _STRENGTH[1] else most * 2.0


def _name_curve(axes: Axes, strength: Floats, factor: Floats, ratio: float, prefix: str) -> None:
    """Write κ on a curve: where it has room if it is steep, else at its right end."""
    height = _LABELLED.get(ratio, _HIGH)
    steep = float(factor[-1]) > height
    place = int(np.argmax(factor > height)) if steep else len(factor) - 1
    axes.annotate(
        (prefix if ratio == max(_RATIOS) else "") + number(ratio),
        (float(strength[place]), float(factor[place])),
        (0.0, 0.0) if steep else (3.0, 0.0),
        textcoords="offset points",
        ha="center" if steep else "left",
        va="center",
        fontsize=7.0,
        annotation_clip=False,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6} if steep else None,
    )


def _zone_ticks(axes: Axes, life: ZoneLife) -> None:
    """Number the zones, and below them the clearance that makes each under the case's load."""
    under_load = bool(np.isfinite(life.clearance).all())

    def written(zone: float) -> str:
        above = number(zone)
        if not under_load:
            return above
        micrometres = round(1e6 * float(np.interp(zone, life.zone, life.clearance)))
        return f"{above}\n{number(float(micrometres))}"

    axes.set_xticks(_TICKS, [written(tick) for tick in _TICKS])
    name = said("Load zone ε")
    if under_load:
        name = said("Load zone ε\nbelow: diametral clearance under this load (µm)")
    axes.set_xlabel(name, parse_math=False)


def _times(ratio: float) -> str:
    return f"× {number(ratio, 3)}"


def _mark(index: int) -> dict[str, Any]:
    look = SERIES[index]
    return {"color": look.color, "marker": look.marker, "linestyle": "", "markersize": 7.0}
