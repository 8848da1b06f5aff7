"""Figures of life: over a field, over load with tests beside it, a_ISO, the load zone, what helps.

A theory has the same colour and line on all of them, by its rank.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import ceil, floor, log10
from typing import TYPE_CHECKING, Final, Literal, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from rolamento.charts import Axis, Bars, Chart, Labels, Line, Look, Mark, nothing, series_look
from rolamento.charts.axes_units import MEGAPASCAL, read_values
from rolamento.charts.courses import courses, crossing, extremes
from rolamento.charts.drawing import draw, figure
from rolamento.charts.field_axis import field_axis
from rolamento.charts.palette import SERIES
from rolamento.charts.record import Side
from rolamento.charts.texts import capitalised, no_result, no_result_count, number, theory_label
from rolamento.life.iso281_modified import MAXIMUM_FACTOR, life_modification_factor
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.theories import BY_RANK, THEORIES
from rolamento.studies.names import setting_name
from rolamento.units import HOUR
from rolamento.words import said
from rolamento.words.quantities import called

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
_MARGIN: Final = 0.2
_TICKS: Final = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0)


def life_figure(curves: Sequence[LifeCurve]) -> Figure:
    """Draw life over a field, with the case's title.

    Parameters
    ----------
    curves
        The case's own first, then its variants; over one field.
    """
    chart = lives_chart(curves)
    return figure(chart, title=curves[0].case.title, height=110.0)


def lives_by_theory(curves: Sequence[LifeCurve], axes: Axes | None = None) -> Axes:
    """Draw the life by every theory, as `lives_chart` has it, on axes."""
    return draw(lives_chart(curves), axes, height=110.0)


def lives_chart(curves: Sequence[LifeCurve]) -> Chart:
    """Return the life by every theory, faintly where it does not hold; of variants what leads.

    Lives are in hours, or in millions of revolutions where nothing turns at any point. An endless
    life leaves the frame at the top; a point without a result has a cross at its foot.
    """
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
    upright = Axis(said("Life"), "h" if turns else "10⁶ rev", limits, log=True)
    across = field_axis(own.over.field, own.values)
    leading = own.headline.theory.tolist()
    life, _, _, name, _ = max(lines, key=lambda line: leading.count(line[2]))
    facts = [courses([(name, x, life)], across, upright)]
    for mark in marks:
        at = across.with_unit(number(crossing(x, life, mark.at), 3))
        facts += [f"{mark.name}: {at}"] * bool(np.isfinite(crossing(x, life, mark.at)))
    chart = Chart(tuple(series), across, upright, "; ".join(facts), marks=marks)
    return chart.where_faint(said("faint: the theory is not valid there"))


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
    chart = load_chart(lives, by=by, tests=tests)
    return figure(chart, title=lives.case.title, height=115.0)


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
    return draw(load_chart(lives, by=by, tests=tests), axes, height=115.0)


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
        name = called("fatigue_load_limit")
        marks = (Mark(lives.fatigue_load, name, Look("grey", width=0.65)),)
    ran = np.array(
        [limits[0] * _LOAD_ROOM, *(n for one in tests for n in np.ravel(one.revolutions))]
    )
    least = float(ran[ran > 0.0].min()) / _LOAD_ROOM
    across = Axis(limits=(least, limits[1]), log=True, name=said("Life"), unit="10⁶ rev")
    ends = _upright_limits(lives, upright, by)
    upwards = replace(_upright(lives, by), limits=ends, log=True)
    known = own[np.isfinite(own) & (own > 0.0)]
    conclusion = (
        said("this case, {load}: {low} to {high} million revolutions by theory",
             load=upwards.with_unit(f"{upwards.name} {number(float(at[0]), 3)}"),
             low=number(float(known.min()), 3), high=number(float(known.max()), 3))
        if known.size else said("fatigue ends no life here")
    )  # fmt: skip
    chart = Chart(tuple(lines), across, upwards, conclusion, marks=marks)
    return chart.where_faint(said("faint: the theory is not valid there"))


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


def _upright(lives: LoadLives, by: By) -> Axis:
    if by == "pressure":
        return Axis(capitalised(called("max_pressure")), MEGAPASCAL.symbol)
    return Axis("P/C", label="P/C (ISO/TS 16281)" if lives.by_reference else "P/C (ISO 281)")


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
    return draw(modification_chart(summary), axes, height=110.0)


def modification_chart(summary: LifeSummary | None = None) -> Chart:
    """Return the chart of `aiso_chart`."""
    points = [] if summary is None else _factors_of(summary)
    rollers = summary is not None and summary.headline.element == "roller"
    limits = _wide_enough([line.x for line in points])
    upright = _FACTOR[0], _FACTOR[1] * _AISO_ROOM
    strength = np.geomspace(*limits, _POINTS)
    curves = [
        life_modification_factor(ratio, strength, 1.0, 1.0, rollers=rollers) for ratio in _RATIOS
    ]
    series: list[Line | Labels] = [
        Line(strength, factor, "", Look("grey", width=0.55)) for factor in curves
    ]
    for ratio, factor in zip(_RATIOS, curves, strict=True):
        text = f"{'κ = ' if ratio == max(_RATIOS) else ''}{number(ratio)}"
        place, side = _place_of_name(factor, _LABELLED.get(ratio, _HIGH))
        at = slice(place, place + 1)
        series.append(Labels(strength[at], factor[at], (text,), (side,)))
    if summary is not None and not points:
        none = said("there is no a_ISO for this case")
        series.append(Labels(strength[:1], strength[:1], (none,), ("right",), height=0.95))
    return Chart(
        (*series, *points),
        Axis(limits=limits, log=True, label="e_C C_u/P", ticks=_round_ticks(limits)),
        Axis(limits=upright, log=True, label="a_ISO", ticks=_round_ticks(upright)),
        "; ".join(line.name for line in points)
        if points and all(len(line.x) == 1 for line in points)
        else extremes(
            [(one.name, one.x, one.y) for one in points]
            or [("", strength, factor) for factor in curves],
            Axis("e_C C_u/P"),
            Axis("a_ISO"),
        ),
        symbols=True,
    )


def _round_ticks(ends: tuple[float, float]) -> tuple[tuple[float, str], ...]:
    """Return 1, 2 and 5 of each decade, as the standard's charts have them."""
    powers = range(floor(log10(ends[0])), ceil(log10(ends[1])) + 1)
    found = (step * 10.0**power for power in powers for step in (1.0, 2.0, 5.0))
    return tuple((one, number(one)) for one in found if ends[0] <= one * 1.001 <= ends[1] * 1.01)


def _place_of_name(factor: Floats, height: float) -> tuple[int, Side]:
    """Return where κ stands on a curve: where it has room if it is steep, else at its end."""
    if factor[-1] > height:
        return int(np.argmax(factor > height)), "on"
    return len(factor) - 1, "right"


def load_zone_figure(life: ZoneLife) -> Figure:
    """Draw life over the load zone, as `life_over_zone`, with the case's title."""
    return figure(zone_chart(life), title=life.case.title, height=95.0)


def life_over_zone(life: ZoneLife, axes: Axes | None = None) -> Axes:
    """Draw life over the load zone, as `zone_chart` has it, on axes; by default of a new figure."""
    return draw(zone_chart(life), axes, height=95.0)


def zone_chart(life: ZoneLife) -> Chart:
    """Return life over the load zone ε of a radially loaded bearing, and the case's own place.

    Parameters
    ----------
    life
        Of `rolamento.tasks.life_over.lives_over_zone`; where the case's load is radial, the
        clearance that makes each zone under it stands below.
    """
    best, ratio = life.best
    label = said("longest life: ε = {zone}, {ratio}", zone=number(best, 2), ratio=_times(ratio))
    places = [(best, ratio, label, series_look(2))]
    if life.own is not None and life.zone[0] <= life.own[0] <= life.zone[-1]:
        own, ratio = life.own
        label = said("this case: ε = {zone}, {ratio}", zone=number(own, 2), ratio=_times(ratio))
        places.append((own, ratio, label, series_look(1)))
    points = (
        Line(np.array([zone]), np.array([height]), name, look, "points")
        for zone, height, name, look in places
    )
    name = said("Load zone ε")
    if np.isfinite(life.clearance).all():
        name = said("Load zone ε\nbelow: diametral clearance under this load (µm)")
    return Chart(
        (Line(life.zone, life.life_ratio, "", series_look(0)), *points),
        Axis(limits=(0.0, float(life.zone[-1])), label=name,
             ticks=tuple((tick, _zone_text(life, tick)) for tick in _TICKS)),
        Axis(limits=(0.0, 1.15 * float(np.max(life.life_ratio))),
             label=said("Life over life without clearance")),
        "; ".join(label for *_, label, _ in places),
        marks=(Mark(0.5, said("no clearance"), Look("grey", width=0.65), "x"),),
    )  # fmt: skip


def _zone_text(life: ZoneLife, zone: float) -> str:
    """Write a zone, and below it the clearance that makes it under the case's load."""
    if not np.isfinite(life.clearance).all():
        return number(zone)
    micrometres = round(1e6 * float(np.interp(zone, life.zone, life.clearance)))
    return f"{number(zone)}\n{number(float(micrometres))}"


def helps_figure(changes: Sequence[Change], title: str = "") -> Figure:
    """Draw what would help, as `what_helps`, with a title."""
    return figure(changes_chart(changes), title=title, height=24.0 + 9.0 * max(len(changes), 2))


def what_helps(changes: Sequence[Change], axes: Axes | None = None) -> Axes:
    """Draw what would help, as `changes_chart` has it, on axes; of a new figure if not given."""
    return draw(changes_chart(changes), axes)


def changes_chart(changes: Sequence[Change]) -> Chart:
    """Return a bar for each change: life after it over life before; the most helpful at the top.

    Parameters
    ----------
    changes
        Of `rolamento.life.sensitivity`; one without a ratio has a line without a bar.
    """
    ratios = np.array([change.life_ratio for change in changes], dtype=np.float64)
    known = np.isfinite(ratios)
    if not known.any():
        return nothing(no_result())
    shown = np.where(known, ratios, 1.0)
    less, more = np.flatnonzero(shown < 1.0), np.flatnonzero(shown >= 1.0)
    bars = [
        Bars(shown[own], tuple(own.tolist()), "", look, start=np.ones(len(own)))
        for own, look in ((more, series_look(2)), (less, Look("outer", hollow=True)))
        if own.size
    ]
    texts = tuple(
        _times(ratio) if fine else no_result() for ratio, fine in zip(ratios, known, strict=True)
    )
    sides: list[Side] = ["left" if ratio < 1.0 else "right" for ratio in shown]
    names = tuple(capitalised(change.note.text) for change in changes)
    least, most = min(float(shown.min()), 1.0), max(float(shown.max()), 1.0)
    room = _MARGIN * max(most - least, 0.1)
    return Chart(
        (*bars, Labels(shown, np.arange(float(len(shown))), texts, tuple(sides))),
        Axis(limits=(least - (1.5 * room if least < 1.0 else 0.0), most + room),
             label=said("Life after the change over life before")),
        Axis(categories=names),
        f"{names[0]}: {texts[0]}",
        marks=(Mark(1.0, "", Look("grey", width=0.65), "x"),),
    )  # fmt: skip


def _factors_of(summary: LifeSummary) -> list[Line]:
    """Return e_C C_u/P and a_ISO of each modified theory as points; bounds left out."""
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
        look = replace(series_look(THEORIES[theory].rank), hollow=True, width=1.5)
        found.append(Line(strength[there], factor[there], label, look, "points"))
    return found


def _wide_enough(strengths: Sequence[Floats]) -> tuple[float, float]:
    """Return limits that hold all points, whole in the standard's own range."""
    all_of_them = np.concatenate([np.array(_STRENGTH), *strengths])
    least, most = float(all_of_them.min()), float(all_of_them.max())
    low = _STRENGTH[0] if least >= _STRENGTH[0] else least / 2.0
    return low, _STRENGTH[1] if most <= _STRENGTH[1] else most * 2.0


def _times(ratio: float) -> str:
    return f"× {number(ratio, 3)}"
