"""A machine, drawn: its shafts to scale on their bearings, how they bend, and what they carry."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from math import atan2
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.projections.polar import PolarAxes

from rolamento.charts import Axis, Chart, Labels, Line, Look, Mark, key, nothing, series_look
from rolamento.charts.axes_units import MEGAPASCAL, ReadableUnit, readable_unit
from rolamento.charts.contact_charts import rosette_chart
from rolamento.charts.contacts import Shown, load_unit, race_name
from rolamento.charts.courses import peak
from rolamento.charts.drawing import draw
from rolamento.charts.drawing import figure as charts
from rolamento.charts.frame import add_title, empty_frame, label_x, require_axes
from rolamento.charts.palette import SERIES
from rolamento.charts.record import Side
from rolamento.charts.style import MILLIMETRE, WIDTH, in_style, new_figure, styled
from rolamento.charts.texts import capitalised, no_result, number, shown_text
from rolamento.errors import InputError
from rolamento.plots.machine_drawing import (
    LINE,
    LOAD,
    MM,
    SMALL,
    SPOKEN,
    check_step,
    draw_machine,
    draw_planned,
    levels,
    paper_of,
    place_of,
    planned,
    title_of,
)
from rolamento.solved import RACES
from rolamento.words import said
from rolamento.words.naming import machine_title
from rolamento.words.quantities import called
from rolamento.words.whirl import whirl_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.case.machine import MachineBearing
    from rolamento.case.machine_loads import Gear
    from rolamento.numerics import FloatArray
    from rolamento.solved import Solved
    from rolamento.solved.machine import SolvedMachine, SolvedShaft
    from rolamento.solved.rotor import Campbell, Modes, UnbalanceResponse
    from rolamento.tasks.machines import MachineCurve

__all__ = [
    "campbell_figure",
    "draw_bearings_in_place",
    "draw_deflection",
    "draw_machine",
    "draw_section_forces",
    "machine_figure",
    "machine_over_figure",
    "modes_figure",
    "response_figure",
]

_MM: Final = MM
_WIDE: Final = 1.2 * WIDTH
"""Width of a machine with two panels beside each other, in mm."""
_LOW: Final = 38.0
"""Height of one of them."""
_BESIDE: Final = 58.0
"""Height of what stands between them: legends, numbers, labels, the title; in mm."""
_PANEL: Final = 40.0
"""Height of one of the panels of section forces, in mm."""
_ROSETTE: Final = (50.0, 55.0)
"""Width and height of a rosette with its name, in mm."""
_ABREAST: Final = 3
"""Rosettes in a row."""
_NAMED: Final = 3
"""Critical speeds that a Campbell diagram names in words."""
_SLOPE: Final = 1e3
"""mrad for a rad."""


@in_style
def machine_figure(solved: SolvedMachine, *, step: int = 0) -> Figure:
    """Draw a machine, and what it carries along its axis.

    Shafts to scale with bearings and loads; below them the line of deflection beside the bending
    moment, the shear force beside the nominal stress.

    Parameters
    ----------
    solved
        From `rolamento.shaft`.
    step
        Of its spectrum, from 0.

    Raises
    ------
    InputError
        If this is no solved machine, or there is no such step.
    """
    check_step(solved, step)
    plan = planned(solved.machine, step, width=_WIDE - 15.0)
    tall = plan.height + 2.0 * _LOW + _BESIDE
    figure = Figure(figsize=(_WIDE * MILLIMETRE, tall * MILLIMETRE))
    grid = figure.add_gridspec(3, 2, height_ratios=(plan.height, _LOW, _LOW))
    draw_planned(figure.add_subplot(grid[0, :]), plan)
    lower = [figure.add_subplot(grid[row, column]) for row in (1, 2) for column in (0, 1)]
    if solved.status.converged[step]:
        lines = _lines(solved, [step])
        _draw_deflection(lower[0], solved, lines, named=False)
        moments = [one.shaft.bending_moment[step] for one in lines]
        shears = [one.shaft.shear_force[step] for one in lines]
        stresses = [one.shaft.stress[step] for one in lines]
        for axes, values, unit, name in (
            (lower[1], moments, _unit("N*m", moments), said("Moment")),
            (lower[2], shears, _unit("N", shears), said("Shear force")),
            (lower[3], stresses, MEGAPASCAL, said("Stress")),
        ):
            chart = _panel(lines, values, unit, name, solved)
            along = replace(chart.x, limits=_extent(lines))
            _draw_low(replace(chart, x=along, y=replace(chart.y, zero=True)), axes)
    else:
        for axes in lower:
            empty_frame(axes, said("no equilibrium"))
    for axes in lower[:2]:
        axes.set_xlabel("")
    add_title(figure, title_of(solved, step))
    return figure


# --- along the axis -------------------------------------------------------------------------------


def _along(one: SolvedShaft) -> FloatArray:
    return np.asarray(_MM * (one.shaft.position + one.position))


class _Line(NamedTuple):
    """A shaft in a step of the spectrum, and how it is drawn."""

    shaft: SolvedShaft
    step: int
    label: str
    look: Look


_PLANES: Final = ("solid", "dash", "dashdot")
"""Lines of y, z and both together, where colours are for shafts and steps."""


@in_style
def draw_deflection(
    solved: SolvedMachine, axes: Axes | None = None, *, step: int | None = None
) -> Axes:
    """Draw how far each shaft is from its axis, along it: y, z, and both together.

    Marks are at bearings and gears, on the line of both together; beside their names stands the
    slope of the shaft there, the greatest of the steps that are drawn.

    Parameters
    ----------
    solved
        From `rolamento.shaft`.
    axes
        To draw on; of a new figure if not given.
    step
        Step of its spectrum, from 0; all of them if not given.

    Returns
    -------
    Axes
        Those given; without a result, a frame that says so.

    Raises
    ------
    InputError
        If this is no solved machine, there is no such step, or there would be more lines than can
        be distinguished.
    """
    check_step(solved, 0 if step is None else step)
    if axes is None:
        figure, axes = new_figure(height=95.0)
        add_title(figure, title_of(solved, step))
    asked = range(len(solved)) if step is None else (step,)
    require_axes(axes)
    steps = [one for one in asked if solved.status.converged[one]]
    if not steps:
        return empty_frame(axes, said("no equilibrium"))
    lost = len(asked) - len(steps)
    missing = [key(f"{no_result()}: {lost}", Look("grey"), "points")] if lost else []
    return _draw_deflection(axes, solved, _lines(solved, steps), named=True, more=missing)


def _draw_deflection(
    axes: Axes,
    solved: SolvedMachine,
    lines: Sequence[_Line],
    *,
    named: bool,
    more: Sequence[Line] = (),
) -> Axes:
    """Draw shafts in some steps; named: whether slopes stand beside the names of parts."""
    single = len(lines) == 1
    series: list[Line] = []
    for one in lines:
        moved = 1e6 * one.shaft.displacement[one.step][:, 1:3]
        series += _planes(one, _along(one.shaft), moved, single)
    places = _places(solved, lines)
    for one in lines:
        own = [place for place in places if place.shaft == one.shaft.name]
        at = np.array([_MM * place.x for place in own])
        # as the line is drawn, which is straight between nodes
        far = np.interp(at, _along(one.shaft), 1e6 * one.shaft.deflection[one.step])
        color = series_look(2).color if single else one.look.color
        series.append(Line(at, far, "", Look(color, mark=one.look.mark, width=0.7), "points"))
    across = Axis("x", "mm", _extent(lines))
    named_lines = (*series, *([] if single else _keys(lines)), *more)
    upright = Axis(said("Deflection"), "µm")
    moved = [(o.label, _along(o.shaft), 1e6 * o.shaft.deflection[o.step]) for o in lines]
    conclusion = peak(moved, across, upright)
    chart = Chart(named_lines, across, upright, conclusion, marks=_marks(solved))
    draw(chart, axes)
    most = "≤ " if len({one.step for one in lines}) > 1 else ""
    texts = [f"{most}{number(place.slope, 2)} mrad" for place in places]
    if named:
        texts = [f"{place.name} {text}" for place, text in zip(places, texts, strict=True)]
    _name_places(axes, [(place.x, text) for place, text in zip(places, texts, strict=True)])
    return axes


def _planes(one: _Line, x: FloatArray, parts: FloatArray, single: bool) -> Iterator[Line]:
    """Yield y, z and both together: by colours if there is but one line of each."""
    y, z = parts[:, 0], parts[:, 1]
    for plane, values in enumerate((y, z, np.hypot(y, z))):
        look = Look(one.look.color, _PLANES[plane], width=1.15 if plane == 2 else 0.65)
        if single:
            look = series_look(plane)
        yield Line(x, values, _plane_names()[plane] if single else "", look)


def _plane_names() -> tuple[str, str, str]:
    return "y", "z", said("resultant")


def _lines(solved: SolvedMachine, steps: Sequence[int]) -> list[_Line]:
    """Return shafts and steps with colours of their own.

    Raises
    ------
    InputError
        If there are more than can be distinguished.
    """
    count = len(steps) * len(solved.shafts)
    if count > len(SERIES) and len(steps) > 1:
        raise InputError(
            said("would make {count} lines; more than {most} cannot be told apart",
                 count=count, most=len(SERIES)),
            field="step", example="step=0",
        )  # fmt: skip
    found: list[_Line] = []
    for step in steps:
        for one in solved.shafts.values():
            names = [one.name] if len(solved.shafts) > 1 else []
            names += [solved.steps[step]] if len(steps) > 1 else []
            found.append(_Line(one, step, ", ".join(names), series_look(len(found))))
    return found


def _keys(lines: Sequence[_Line]) -> Iterator[Line]:
    """Yield what stands for colours and for lines."""
    for one in lines:
        yield key(one.label, Look(one.look.color, mark=one.look.mark), "both")
    for dash, name in zip(_PLANES, _plane_names(), strict=True):
        yield key(name, Look("grey", dash))


class _Place(NamedTuple):
    """A bearing or a gear, and the slope of the shaft there, in mrad."""

    name: str
    shaft: str
    x: float
    slope: float


def _places(solved: SolvedMachine, lines: Sequence[_Line]) -> list[_Place]:
    machine = solved.machine
    found: list[_Place] = []
    parts: tuple[MachineBearing | Gear, ...] = (*machine.bearings, *machine.gears)
    for part in parts:
        own = [one for one in lines if one.shaft.name == part.shaft]
        slopes = [
            float(
                one.shaft.slope[one.step, int(np.abs(one.shaft.position - part.position).argmin())]
            )
            for one in own
        ]
        x = place_of(machine, part.shaft, part.position)
        name = part.name or said("gear")
        found.append(_Place(name, part.shaft, x, _SLOPE * max(slopes)))
    return found


def _name_places(axes: Axes, places: Sequence[tuple[float, str]]) -> None:
    """Write texts at places along the axis, over the data, where none covers another."""
    low, high = axes.get_xlim()
    wide, tall = paper_of(axes)
    scale = (high - low) / wide
    texts = [(_MM * x, shown_text(text, 40)) for x, text in places]
    room = [SPOKEN * len(text) * scale + 2.0 * scale for _, text in texts]
    inside = [
        (min(max(x, low + 0.5 * w), high - 0.5 * w), w)
        for (x, _), w in zip(texts, room, strict=True)
    ]
    found = levels(inside)
    share = min((max(found, default=-1) + 1) * LINE / tall, 0.6)
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom, bottom + (top - bottom) / (1.0 - share))
    for (_, text), (x, _), level in zip(texts, inside, found, strict=True):
        axes.annotate(
            text, (x, 1.0), xycoords=("data", "axes fraction"), ha="center", va="top",
            xytext=(0.0, -level * LINE * 72.0 / 25.4), textcoords="offset points",
            fontsize=SMALL, color="#404040", parse_math=False, zorder=6,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
        )  # fmt: skip


def _extent(lines: Sequence[_Line]) -> tuple[float, float]:
    """Return an axis that shows the whole machine."""
    ends = [end for one in lines for end in (_along(one.shaft)[0], _along(one.shaft)[-1])]
    margin = 0.04 * (max(ends) - min(ends))
    return min(ends) - margin, max(ends) + margin


# --- what is carried ------------------------------------------------------------------------------


@in_style
def draw_section_forces(solved: SolvedMachine, *, step: int = 0) -> Figure:
    """Draw shear force, bending moment, axial force, torque and equivalent stress along shafts.

    Each is what the right part puts on the left one, with a step where something acts: forces along
    y and z, moments about them. Bearings are dotted lines.

    Parameters
    ----------
    solved
        From `rolamento.shaft`.
    step
        Step of its spectrum, from 0.

    Returns
    -------
    Figure
        Five panels over one axis; without a result, a frame that says so.

    Raises
    ------
    InputError
        If this is no solved machine, or there is no such step.
    """
    check_step(solved, step)
    if not solved.status.converged[step]:
        return charts(nothing(said("no equilibrium")), title=title_of(solved, step))
    lines = _lines(solved, [step])
    figure = Figure(figsize=(WIDTH * MILLIMETRE, 5.0 * _PANEL * MILLIMETRE))
    panels = figure.subplots(5, 1, sharex=True)
    forces = [one.shaft.force[step, ..., 0] for one in lines]
    torques = [one.shaft.torque[step] for one in lines]
    stresses = [one.shaft.stress[step] for one in lines]
    stress = _panel(lines, stresses, MEGAPASCAL, said("Equivalent stress"), solved)
    for axes, chart in zip(
        panels,
        (
            _in_planes(lines, (1, 2), "N", said("Shear force"), solved),
            _in_planes(lines, (3, 4), "N*m", said("Bending moment"), solved),
            _panel(lines, forces, _unit("N", forces), said("Axial force"), solved),
            _panel(lines, torques, _unit("N*m", torques), said("Torque"), solved),
            replace(stress, y=replace(stress.y, zero=True)),
        ),
        strict=True,
    ):
        _draw_low(replace(chart, x=replace(chart.x, limits=_extent(lines))), axes)
        axes.set_xlabel("")
    machine = solved.machine
    _name_places(
        panels[0], [(place_of(machine, b.shaft, b.position), b.name) for b in machine.bearings]
    )
    label_x(panels[-1], said("x (mm)"))
    add_title(figure, title_of(solved, step))
    return figure


def _unit(unit: str, values: Iterable[FloatArray]) -> ReadableUnit:
    return readable_unit(unit, np.concatenate([one.ravel() for one in values]))


def _in_planes(
    lines: Sequence[_Line], planes: tuple[int, int], unit: str, name: str, solved: SolvedMachine
) -> Chart:
    """Return two components and what they make together."""
    single = len(lines) == 1
    both = [one.shaft.force[one.step][..., planes] for one in lines]
    read = _unit(unit, [np.hypot(own[..., 0], own[..., 1]) for own in both])
    series = [
        line
        for one, own in zip(lines, both, strict=True)
        for line in _planes(
            one, np.repeat(_along(one.shaft), 2), read.of(own.reshape(-1, 2)), single
        )
    ]
    # names stand once, over the first panel
    keys = list(_keys(lines)) if not single and planes[0] == 1 else []
    if planes[0] != 1:
        series = [replace(line, name="") for line in series]
    across, upright = Axis("x", "mm"), Axis(name, read.symbol)
    sums = [read.of(np.hypot(*own.reshape(-1, 2).T)) for own in both]
    places = [(one.label, np.repeat(_along(one.shaft), 2)) for one in lines]
    together = [(*place, own) for place, own in zip(places, sums, strict=True)]
    conclusion = peak(together, across, upright)
    return Chart((*series, *keys), across, upright, conclusion, marks=_marks(solved))


def _panel(
    lines: Sequence[_Line],
    values: Sequence[FloatArray],
    unit: ReadableUnit,
    name: str,
    solved: SolvedMachine,
) -> Chart:
    """Return a number along each shaft."""
    alone = len(lines) == 1
    series = tuple(
        Line(np.repeat(_along(one.shaft), 2), unit.of(own.ravel()), "",
             Look("ink") if alone else one.look)
        for one, own in zip(lines, values, strict=True)
    )  # fmt: skip
    across, upright = Axis("x", "mm"), Axis(name, unit.symbol)
    points = [(one.label, line.x, line.y) for one, line in zip(lines, series, strict=True)]
    return Chart(series, across, upright, peak(points, across, upright), marks=_marks(solved))


def _draw_low(chart: Chart, axes: Axes) -> None:
    """Draw a chart on a low panel, the label upright in two lines."""
    draw(chart, axes)
    axes.set_ylabel(f"{chart.y.name}\n({chart.y.unit})", parse_math=False)


def _marks(solved: SolvedMachine) -> tuple[Mark, ...]:
    """Return where bearings stand."""
    machine, look = solved.machine, Look("grey", "dot", width=0.45)
    return tuple(
        Mark(_MM * place_of(machine, one.shaft, one.position), "", look, "x")
        for one in machine.bearings
    )


# --- over a field ---------------------------------------------------------------------------------


def machine_over_figure(found: MachineCurve) -> Figure:
    """Draw a machine over one of its fields: lives, pressures, tilts and deflections.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ShaftRequest`.
    """
    machine = found.first.solved
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, 0.85 * WIDTH * MILLIMETRE))
        grid = figure.subplots(2, 2, sharex=True).ravel()
        for place, (axes, chart) in enumerate(zip(grid, machine_over_charts(found), strict=True)):
            draw(chart, axes, legend=place in (0, 3))
        for axes in grid[:2]:
            axes.set_xlabel("")
        add_title(figure, machine_title(machine.title))
    return figure


def machine_over_charts(found: MachineCurve) -> tuple[Chart, ...]:
    """Return the lives, pressures and tilts of bearings, and the deflections of shafts."""
    machine, x = found.first.solved, found.values
    across = Axis(found.key, found.unit)

    def chart(names: Iterable[str], of: Callable[[str], FloatArray], upright: Axis) -> Chart:
        lines = (Line(x, of(name), name, series_look(i)) for i, name in enumerate(names))
        return Chart(tuple(lines), across, upright)

    lives = chart(machine.bearings, lambda name: found.of_bearing(name, "hours"),
                  Axis(name=said("Life"), unit="h", log=True))  # fmt: skip
    whole = Line(x, found.hours, said("together"), Look("ink", width=1.4))
    return (
        replace(lives, series=(*lives.series, whole)),
        chart(machine.bearings, lambda name: 1e-6 * found.of_bearing(name, "max_pressure"),
              Axis(name=capitalised(called("max_pressure")), unit="MPa", zero=True)),
        chart(machine.bearings, lambda name: 1e3 * found.of_bearing(name, "tilt"),
              Axis(name=capitalised(called("ring_tilt")), unit="mrad", zero=True)),
        chart(machine.shafts, lambda name: 1e6 * found.of_shaft(name, "deflection"),
              Axis(name=said("Deflection"), unit="µm", zero=True)),
    )  # fmt: skip


# --- bearings in their places ---------------------------------------------------------------------


@in_style
def draw_bearings_in_place(solved: SolvedMachine, *, step: int = 0) -> Figure:
    """Draw the load rosette of each bearing, in the order in which they stand along x.

    All are on one scale and seen from the machine's +x: z is up, y to the right. Arrows show the
    radial force of the shaft on the inner ring, on one scale of their own.

    Parameters
    ----------
    solved
        From `rolamento.shaft`.
    step
        Step of its spectrum, from 0.

    Returns
    -------
    Figure
        Rosettes in rows; a bearing without a result has a frame that says why.

    Raises
    ------
    InputError
        If this is no solved machine, there is no such step, or it has no bearings.
    """
    check_step(solved, step)
    machine = solved.machine
    order = sorted(machine.bearings, key=lambda one: place_of(machine, one.shaft, one.position))
    if not order:
        raise InputError(said("has no bearings"), field="solved")
    seats = [solved.bearings[one.name] for one in order]
    single = [one.solved[step] for one in seats]
    shown = [one for one in single if one.converged[0]]
    rows, columns = -(-len(seats) // _ABREAST), min(_ABREAST, len(seats))
    across, tall = max(columns, 2) * _ROSETTE[0], rows * _ROSETTE[1] + 24.0
    figure = Figure(figsize=(across * MILLIMETRE, tall * MILLIMETRE))
    grid = figure.subplots(rows, columns, squeeze=False, subplot_kw={"projection": "polar"}).ravel()
    unit = load_unit(shown) if shown else readable_unit("N", 0.0)
    rim = 1.05 * max((_greatest(one, unit) for one in shown), default=1.0)
    top = max((float(one.radial_force[step]) for one in seats if one.solved.converged[step]),
              default=0.0)  # fmt: skip
    handles: dict[str, Any] = {}
    for axes, seated, own in zip(grid, seats, single, strict=False):
        assert isinstance(axes, PolarAxes)
        lines = [shown_text(seated.name, 34)]
        if own.converged[0]:
            chart = rosette_chart([Shown("", own)], unit=unit)
            radius = replace(chart.y, limits=(0.0, rim or 1.0), hidden=True)
            draw(replace(chart, y=radius), axes, legend=False)
            axes.tick_params(labelsize=7.0, pad=0.0)
            for line in axes.lines:
                line.set_markersize(2.5)
            for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
                handles.setdefault(label, handle)
            lines += _force_arrow(axes, seated.force[step], top)
        else:
            empty_frame(axes, no_result(str(own.status.code[0])))
        axes.set_title("\n".join(lines), fontsize=8.0, parse_math=False)
    for axes in grid[len(seats) :]:
        axes.set_visible(False)
    if len(handles) > len(RACES):  # a bearing of one row looks as the first row of others
        handles = {label: one for label, one in handles.items() if label not in _race_names()}
        figure.set_figheight(figure.get_figheight() + 10.0 * MILLIMETRE)
    arrow = Line2D([], [], color=LOAD, marker=">", label=said("force of the shaft"))
    figure.legend(
        handles=[*handles.values(), arrow], loc="outside lower center",
        ncols=3 if len(handles) == len(RACES) else 2, alignment="center", title_fontsize=8.0,
        title=said("Contact load ({unit}), seen from +x", unit=unit.symbol),
    )  # fmt: skip
    add_title(figure, title_of(solved, step))
    return figure


def _race_names() -> set[str]:
    return {race_name(race, 0, 1) for race in RACES}


def _greatest(solved: Solved, unit: ReadableUnit) -> float:
    return max(float(unit.of(solved.contacts[race].load[0]).max()) for race in RACES)


def _force_arrow(axes: PolarAxes, force: FloatArray, top: float) -> list[str]:
    """Draw the radial force; return what its size is, and that of the axial one."""
    fx, fy, fz = (float(part) for part in force[:3])
    radial = float(np.hypot(fy, fz))
    if radial > 1e-3 * top:
        axes.annotate(
            "", (atan2(fy, fz), axes.get_rmax() * radial / top), xytext=(0.0, 0.0), zorder=6,
            arrowprops={"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.8, "shrinkA": 0,
                        "shrinkB": 0},
        )  # fmt: skip
    if abs(fx) < 1e-3 * max(top, radial):
        fx = 0.0
    unit = readable_unit("N", [radial, fx])
    return [
        f"Fr {number(float(unit.of(radial)), 3)}, Fx {number(float(unit.of(fx)), 3)} {unit.symbol}"
    ]


# --- vibration ------------------------------------------------------------------------------------


def campbell_figure(found: Campbell) -> Figure:
    """Draw natural frequencies over speed, the orders of rotation, and where they meet.

    Parameters
    ----------
    found
        From `rolamento.rotors.campbell`.
    """
    return charts(
        campbell_chart(found), title=machine_title(found.machine.title), height=0.65 * WIDTH
    )


def campbell_chart(found: Campbell) -> Chart:
    """Return natural frequencies over speed, and the orders of rotation."""
    rpm, hertz = 30.0 / np.pi * np.abs(found.speed), found.frequency / (2.0 * np.pi)
    looks = {"forward": series_look(0), "backward": series_look(1), "axial": series_look(2)}
    lines: list[Line] = []
    shown: set[str] = set()
    for branch in range(hertz.shape[1]):
        named = [str(one) for one in found.whirl[:, branch] if one]
        kind = max(set(named), key=named.count) if named else ""
        name = "" if kind in shown else whirl_name(kind)
        shown.add(kind)
        lines.append(Line(rpm, hertz[:, branch], name, looks.get(kind, series_look(6))))
    orders = sorted({one.order for one in found.critical} | {1.0})
    lines += [Line(rpm, order * rpm / 60.0, "", Look("grey", width=0.6)) for order in orders]
    met = np.array([(30.0 / np.pi * one.speed, one.frequency / (2.0 * np.pi))
                    for one in found.critical]).reshape(-1, 2).T  # fmt: skip
    lines.append(Line(met[0], met[1], "", Look("ink", width=0.7), "points"))
    end = np.full(len(orders), rpm[-1])
    names = tuple(f"{number(order)}×" for order in orders)
    criticals = [
        said("{order}× meets {frequency:.3} Hz at {speed:.4} rpm", order=number(order),
             frequency=frequency, speed=speed)
        for order, speed, frequency in zip((one.order for one in found.critical), *met, strict=True)
    ]  # fmt: skip
    more = [said("{count} more", count=len(criticals) - _NAMED)] * (len(criticals) > _NAMED)
    sides: list[Side] = ["right"] * len(orders)
    labels = Labels(end, np.array(orders) * rpm[-1] / 60.0, names, tuple(sides))
    return Chart((*lines, labels), _speed_of(found.shaft),
                 Axis(unit="Hz", zero=True, name=said("Natural frequency")),
                 "; ".join([*criticals[:_NAMED], *more])
                 or said("no order meets a natural frequency up to {speed:.4} rpm", speed=rpm[-1]),
                 )  # fmt: skip


def _speed_of(shaft: str) -> Axis:
    return Axis(unit="rpm", name=said("Speed of {shaft}", shaft=shaft))


def modes_figure(found: Modes, *, count: int = 4) -> Figure:
    """Draw the lowest mode shapes across the axis, one a panel, where they are greatest.

    Parameters
    ----------
    found
        From `rolamento.rotors.natural_modes`.
    count
        How many of them.
    """
    shown = [mode_chart(found, mode) for mode in range(min(count, len(found)))]
    return charts(*shown, title=machine_title(found.machine.title), height=34.0 * len(shown))


def mode_chart(found: Modes, mode: int) -> Chart:
    """Return a mode shape across the axis; names of the directions stand with the first."""
    lines = []
    for place, (name, shape) in enumerate(found.shape.items()):
        x = _MM * (found.machine.shaft(name).position + found.position[name])
        for axis, look in ((0, series_look(2)), (1, series_look(0)), (2, series_look(1))):
            values = shape[mode][:, axis]
            largest = values[np.abs(values).argmax()]
            turned = (values * np.conj(largest) / max(abs(largest), 1e-300)).real
            lines.append(Line(x, turned, "" if mode or place else "xyz"[axis], look))
    hertz = number(float(found.frequency[mode]) / (2.0 * np.pi))
    label = f"{hertz} Hz\n{whirl_name(str(found.whirl[mode]))}"
    return Chart(tuple(lines), Axis("x", "mm"), Axis(limits=(-1.1, 1.1), label=label),
                 label.replace("\n", ", "))  # fmt: skip


def response_figure(found: UnbalanceResponse) -> Figure:
    """Draw what unbalance does over speed: orbits of the shafts, and forces at the bearings.

    Parameters
    ----------
    found
        From `rolamento.rotors.unbalance_response`.
    """
    rpm, across = 30.0 / np.pi * np.abs(found.speed), _speed_of(found.shaft)
    orbit = {name: 1e6 * found.amplitude(name).max(axis=1) for name in found.displacement}
    force = {name: found.force_amplitude(name) for name in found.force}
    shown = []
    for own, upright in (
        (orbit, Axis(said("Greatest orbit"), "µm", log=True)),
        (force, Axis(said("Force at bearing"), "N", log=True)),
    ):
        lines = (Line(rpm, values, name, series_look(place))
                 for place, (name, values) in enumerate(own.items()))  # fmt: skip
        shown.append(Chart(tuple(lines), across, upright))
    return charts(*shown, title=machine_title(found.machine.title), height=0.75 * WIDTH)
