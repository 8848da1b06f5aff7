"""A machine, drawn: its shafts to scale on their bearings, how they bend, and what they carry."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import atan2
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.projections.polar import PolarAxes

from rolamento.charts import Axis, Chart, Labels, Line, Look, series_look
from rolamento.charts.axes_units import ReadableUnit, readable_unit
from rolamento.charts.contact_charts import rosette_chart
from rolamento.charts.contacts import Shown, load_unit, race_name
from rolamento.charts.drawing import draw
from rolamento.charts.frame import (
    GREY,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
    require_axes,
)
from rolamento.charts.record import Side
from rolamento.charts.style import (
    INNER,
    MILLIMETRE,
    OUTER,
    SERIES,
    WIDTH,
    Series,
    in_style,
    new_figure,
    series,
    styled,
)
from rolamento.charts.texts import no_result, number, shown_text
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
_PANELS: Final = (36.0, 34.0, 28.0)
"""Heights of the panels below the drawing, in mm."""
_BESIDE: Final = 51.0
"""Height of what stands between panels: legends, numbers, labels, the title; in mm."""
_PANEL: Final = 40.0
"""Height of one of the panels of section forces, in mm."""
_ROSETTE: Final = (50.0, 55.0)
"""Width and height of a rosette with its name, in mm."""
_ABREAST: Final = 3
"""Rosettes in a row."""
_SLOPE: Final = 1e3
"""mrad for a rad."""


@in_style
def machine_figure(solved: SolvedMachine, *, step: int = 0) -> Figure:
    """Draw a machine in four panels along its axis.

    Shafts to scale with bearings and loads, the line of deflection, bending moment and shear force,
    nominal stress.

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
    plan = planned(solved.machine, step)
    tall = plan.height + sum(_PANELS) + _BESIDE
    figure = Figure(figsize=(WIDTH * MILLIMETRE, tall * MILLIMETRE))
    grid = figure.add_gridspec(4, 1, height_ratios=(plan.height, *_PANELS))
    drawing = figure.add_subplot(grid[0])
    draw_planned(drawing, plan)
    lower = [figure.add_subplot(grid[row], sharex=drawing) for row in (1, 2, 3)]
    for axes in lower:
        axes.margins(x=0.0)
    if solved.status.converged[step]:
        _deflection(lower[0], solved, [step], named=False)
        _moments(lower[1], solved, step)
        _stress(lower[2], solved, step)
    else:
        for axes in lower:
            empty_frame(axes, said("no equilibrium"))
    for axes in lower[:-1]:
        axes.set_xlabel("")
        axes.tick_params(labelbottom=False)
    label_x(lower[-1], said("x (mm)"))
    add_title(figure, title_of(solved, step))
    return figure


# --- along the axis -------------------------------------------------------------------------------


def _along(one: SolvedShaft) -> np.ndarray:
    return np.asarray(_MM * (one.shaft.position + one.position))


def _named(one: SolvedShaft, text: str, several: bool) -> str:
    return f"{one.name}: {text}" if several else text


class _Line(NamedTuple):
    """A shaft in a step of the spectrum, and how it is drawn."""

    shaft: SolvedShaft
    step: int
    label: str
    look: Series


_PLANES: Final[tuple[Any, ...]] = ("-", "--", "-.")
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
    _deflection(axes, solved, steps, named=True)
    label_x(axes, said("x (mm)"))
    if lost := len(asked) - len(steps):
        legend = axes.get_legend()
        handles = [] if legend is None else list(legend.legend_handles)
        missing = Line2D([], [], linestyle="", label=f"{no_result()}: {lost}")
        legend_above(axes, handles=[*(one for one in handles if one is not None), missing])
    return axes


def _deflection(axes: Axes, solved: SolvedMachine, steps: Sequence[int], *, named: bool) -> None:
    """Draw shafts in some steps; named: whether slopes stand beside the names of parts."""
    lines = _lines(solved, steps)
    single = len(lines) == 1
    for one in lines:
        moved = one.shaft.displacement[one.step]
        _plot_planes(axes, one, _along(one.shaft), 1e6 * moved[:, 1:3], single)
    _own_extent(axes, solved)
    places = _places(solved, lines)
    for one in lines:
        own = [place for place in places if place.shaft == one.shaft.name]
        at = np.array([_MM * place.x for place in own])
        # as the line is drawn, which is straight between nodes
        far = np.interp(at, _along(one.shaft), 1e6 * one.shaft.deflection[one.step])
        color = SERIES[2].color if single else one.look.color
        axes.plot(at, far, linestyle="", marker=one.look.marker, color=color, zorder=4)
    most = "≤ " if len(steps) > 1 else ""
    texts = [f"{most}{number(place.slope, 2)} mrad" for place in places]
    if named:
        texts = [f"{place.name} {text}" for place, text in zip(places, texts, strict=True)]
    _name_places(axes, [(place.x, text) for place, text in zip(places, texts, strict=True)])
    _marks(axes, solved)
    label_y(axes, said("Deflection (µm)"))
    legend_above(axes, handles=[] if single else _handles(lines))


def _plot_planes(axes: Axes, one: _Line, x: FloatArray, parts: FloatArray, single: bool) -> None:
    """Draw y, z and both together: by colours if there is but one line of each."""
    y, z = parts[:, 0], parts[:, 1]
    for plane, values in enumerate((y, z, np.hypot(y, z))):
        look: dict[str, Any] = SERIES[plane].keywords()
        if not single:
            look = {"color": one.look.color, "linestyle": _PLANES[plane],
                    "linewidth": 1.6 if plane == 2 else 0.9}  # fmt: skip
        axes.plot(x, values, label=_planes()[plane] if single else "_", **look)


def _planes() -> tuple[str, str, str]:
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
            found.append(_Line(one, step, ", ".join(names), series(len(found))))
    return found


def _handles(lines: Sequence[_Line]) -> list[Line2D]:
    """What stands for colours and for lines."""
    found = [
        Line2D([], [], color=one.look.color, marker=one.look.marker, label=one.label)
        for one in lines
    ]
    for style, name in zip(_PLANES, _planes(), strict=True):
        found.append(Line2D([], [], color=GREY, linestyle=style, label=name))
    return found


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


def _own_extent(axes: Axes, solved: SolvedMachine) -> None:
    """Show the whole machine, unless the axis is that of a drawing."""
    if len(axes.get_shared_x_axes().get_siblings(axes)) > 1:
        return
    ends = [end for one in solved.shafts.values() for end in (_along(one)[0], _along(one)[-1])]
    margin = 0.04 * (max(ends) - min(ends))
    axes.set_xlim(min(ends) - margin, max(ends) + margin)


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
        figure, axes = new_figure()
        empty_frame(axes, said("no equilibrium"))
        add_title(figure, title_of(solved, step))
        return figure
    lines = _lines(solved, [step])
    figure = Figure(figsize=(WIDTH * MILLIMETRE, 5.0 * _PANEL * MILLIMETRE))
    panels = figure.subplots(5, 1, sharex=True)
    shear, moment, axial, torque, stress = panels
    _in_planes(shear, lines, (1, 2), "N", said("Shear force"))
    _in_planes(moment, lines, (3, 4), "N*m", said("Bending moment"))
    forces = [one.shaft.force[step, ..., 0] for one in lines]
    _panel(axial, lines, forces, readable_unit("N", _flat(forces)), said("Axial force"))
    torques = [one.shaft.torque[step] for one in lines]
    _panel(torque, lines, torques, readable_unit("N*m", _flat(torques)), said("Torque"))
    stresses = [one.shaft.stress[step] for one in lines]
    _panel(stress, lines, stresses, readable_unit("Pa", 0.0), said("Equivalent stress"))
    stress.set_ylim(bottom=0.0)
    ends = [end for one in lines for end in (_along(one.shaft)[0], _along(one.shaft)[-1])]
    margin = 0.04 * (max(ends) - min(ends))
    shear.set_xlim(min(ends) - margin, max(ends) + margin)
    for axes in panels:
        _marks(axes, solved)
    machine = solved.machine
    _name_places(
        shear, [(place_of(machine, b.shaft, b.position), b.name) for b in machine.bearings]
    )
    legend_above(shear, handles=[] if len(lines) == 1 else _handles(lines))
    label_x(stress, said("x (mm)"))
    add_title(figure, title_of(solved, step))
    return figure


def _flat(values: Iterable[FloatArray]) -> FloatArray:
    return np.concatenate([one.ravel() for one in values])


def _in_planes(
    axes: Axes, lines: Sequence[_Line], planes: tuple[int, int], unit: str, name: str
) -> None:
    """Two components and what they make together."""
    single = len(lines) == 1
    both = [one.shaft.force[one.step][..., planes] for one in lines]
    read = readable_unit(unit, _flat([np.hypot(own[..., 0], own[..., 1]) for own in both]))
    for one, own in zip(lines, both, strict=True):
        x = np.repeat(_along(one.shaft), 2)
        _plot_planes(axes, one, x, read.of(own.reshape(-1, 2)), single)
    _label_panel(axes, name, read)


def _label_panel(axes: Axes, name: str, unit: ReadableUnit) -> None:
    """In two lines: panels are low."""
    label_y(axes, name)
    axes.set_ylabel(f"{name}\n({unit.symbol})", parse_math=False)


def _panel(
    axes: Axes, lines: Sequence[_Line], values: Sequence[FloatArray], unit: ReadableUnit, name: str
) -> None:
    for one, own in zip(lines, values, strict=True):
        color = "black" if len(lines) == 1 else one.look.color
        axes.plot(np.repeat(_along(one.shaft), 2), unit.of(own.ravel()), color=color,
                  linestyle="-" if len(lines) == 1 else one.look.linestyle)  # fmt: skip
    _label_panel(axes, name, unit)


def _moments(axes: Axes, solved: SolvedMachine, step: int) -> None:
    several = len(solved.shafts) > 1
    shear = axes.twinx()
    looks = [(INNER, OUTER), (SERIES[2], SERIES[3]), (SERIES[4], SERIES[5])] * len(solved.shafts)
    for one, (moment, force) in zip(solved.shafts.values(), looks, strict=False):
        x = np.repeat(_along(one), 2)
        axes.plot(x, one.bending_moment[step].ravel(), **moment.keywords(),
                  label=_named(one, said("bending moment"), several))  # fmt: skip
        shear.plot(x, one.shear_force[step].ravel(), **force.keywords())
        axes.plot([], [], label=_named(one, said("shear force"), several), **force.keywords())
    _marks(axes, solved)
    label_y(axes, said("Moment (N·m)"))
    label_y(shear, said("Shear force (N)"))
    shear.grid(visible=False)
    shear.spines["right"].set_visible(True)
    axes.set_ylim(bottom=0.0)
    shear.set_ylim(bottom=0.0)
    legend_above(axes)


def _stress(axes: Axes, solved: SolvedMachine, step: int) -> None:
    several = len(solved.shafts) > 1
    for one, style in zip(solved.shafts.values(), SERIES * 3, strict=False):
        axes.plot(np.repeat(_along(one), 2), 1e-6 * one.stress[step].ravel(),
                  label=one.name if several else "_", **style.keywords())  # fmt: skip
    _marks(axes, solved)
    label_y(axes, said("Stress (MPa)"))
    axes.set_ylim(bottom=0.0)
    if several:
        legend_above(axes)


def _marks(axes: Axes, solved: SolvedMachine) -> None:
    """Where bearings stand."""
    machine = solved.machine
    for one in machine.bearings:
        axes.axvline(_MM * place_of(machine, one.shaft, one.position), color=GREY, linewidth=0.6,
                     linestyle=":", zorder=0)  # fmt: skip


# --- over a field ---------------------------------------------------------------------------------


def machine_over_figure(found: MachineCurve) -> Figure:
    """Draw a machine over one of its fields: lives, pressures, tilts and deflections.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ShaftRequest`.
    """
    machine, x = found.first.solved, found.values
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, 0.85 * WIDTH * MILLIMETRE))
        lives, pressures, tilts, bent = figure.subplots(2, 2, sharex=True).ravel()
        for name, style in zip(machine.bearings, SERIES * 20, strict=False):
            look = style.keywords()
            lives.plot(x, found.of_bearing(name, "hours"), label=name, **look)
            pressures.plot(x, 1e-6 * found.of_bearing(name, "max_pressure"), **look)
            tilts.plot(x, 1e3 * found.of_bearing(name, "tilt"), **look)
        lives.plot(x, found.hours, color="black", linewidth=2.0, label=said("together"))
        for name, style in zip(machine.shafts, SERIES * 20, strict=False):
            bent.plot(x, 1e6 * found.of_shaft(name, "deflection"), label=name, **style.keywords())
        for axes, label in (
            (lives, said("Life (h)")), (pressures, said("Maximum pressure (MPa)")),
            (tilts, said("Tilt between the rings (mrad)")), (bent, said("Deflection (µm)")),
        ):  # fmt: skip
            label_y(axes, label)
        log_scale(lives, "y")
        for axes in (pressures, tilts, bent):
            axes.set_ylim(bottom=0.0)
        for axes in (tilts, bent):
            label_x(axes, f"{found.key} ({found.unit})" if found.unit else found.key)
        legend_above(lives)
        legend_above(bent)
        add_title(figure, machine.title or said("Machine without a title"))
    return figure


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
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, 0.65 * WIDTH * MILLIMETRE))
        draw(campbell_chart(found), figure.add_subplot())
        add_title(figure, found.machine.title or said("Machine without a title"))
    return figure


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
    sides: list[Side] = ["right"] * len(orders)
    labels = Labels(end, np.array(orders) * rpm[-1] / 60.0, names, tuple(sides))
    return Chart((*lines, labels), _speed_of(found.shaft),
                 Axis(unit="Hz", zero=True, label=said("Natural frequency (Hz)")))  # fmt: skip


def _speed_of(shaft: str) -> Axis:
    return Axis(unit="rpm", label=said("Speed of {shaft} (rpm)", shaft=shaft))


def modes_figure(found: Modes, *, count: int = 4) -> Figure:
    """Draw the lowest mode shapes across the axis, one a panel, where they are greatest.

    Parameters
    ----------
    found
        From `rolamento.rotors.natural_modes`.
    count
        How many of them.
    """
    some = range(min(count, len(found)))
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, 34.0 * len(some) * MILLIMETRE))
        panels = figure.subplots(len(some), 1, sharex=True, squeeze=False)[:, 0]
        for mode, axes in zip(some, panels, strict=True):
            _mode(axes, found, mode)
        label_x(panels[-1], said("x (mm)"))
        legend_above(panels[0])
        add_title(figure, found.machine.title or said("Machine without a title"))
    return figure


def _mode(axes: Axes, found: Modes, mode: int) -> None:
    for name, shape in found.shape.items():
        x = _MM * (found.machine.shaft(name).position + found.position[name])
        own = shape[mode]
        for axis, text, style in _directions():
            values = own[:, axis]
            largest = values[np.abs(values).argmax()]
            turned = (values * np.conj(largest) / max(abs(largest), 1e-300)).real
            axes.plot(x, turned, label=text, **style.keywords())
    whirl = whirl_name(str(found.whirl[mode]))
    hertz = float(found.frequency[mode]) / (2.0 * np.pi)
    axes.set_ylabel(f"{number(hertz)} Hz\n{whirl}", fontsize=8.0, parse_math=False)
    axes.set_ylim(-1.1, 1.1)


def response_figure(found: UnbalanceResponse) -> Figure:
    """Draw what unbalance does over speed: orbits of the shafts, and forces at the bearings.

    Parameters
    ----------
    found
        From `rolamento.rotors.unbalance_response`.
    """
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, 0.75 * WIDTH * MILLIMETRE))
        orbits, forces = figure.subplots(2, 1, sharex=True)
        rpm, across = 30.0 / np.pi * np.abs(found.speed), _speed_of(found.shaft)
        orbit = {name: 1e6 * found.amplitude(name).max(axis=1) for name in found.displacement}
        force = {name: found.force_amplitude(name) for name in found.force}
        for axes, own, label in (
            (orbits, orbit, said("Greatest orbit (µm)")),
            (forces, force, said("Force at bearing (N)")),
        ):
            lines = (Line(rpm, values, name, series_look(place))
                     for place, (name, values) in enumerate(own.items()))  # fmt: skip
            draw(Chart(tuple(lines), across, Axis(log=True, label=label)), axes)
        orbits.set_xlabel("")
        add_title(figure, found.machine.title or said("Machine without a title"))
    return figure


def _directions() -> Iterable[tuple[int, str, Series]]:
    return zip((0, 1, 2), ("x", "y", "z"), (SERIES[2], SERIES[0], SERIES[1]), strict=True)
