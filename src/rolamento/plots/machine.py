"""A machine, drawn: its shafts to scale on their bearings, how they bend, and what they carry."""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, hypot, sin, tan
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Patch, Polygon, Rectangle
from matplotlib.transforms import Affine2D

from rolamento.plots.frame import (
    GREY,
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
)
from rolamento.plots.style import INNER, MILLIMETRE, OUTER, SERIES, WIDTH, Series, styled
from rolamento.plots.texts import number
from rolamento.words import said
from rolamento.words.whirl import whirl_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.case.machine import Machine, MachineBearing, Shaft
    from rolamento.solved.machine import SolvedMachine, SolvedShaft
    from rolamento.solved.rotor import Campbell, Modes, UnbalanceResponse
    from rolamento.tasks.machines import MachineCurve

__all__ = [
    "campbell_figure",
    "machine_figure",
    "machine_over_figure",
    "modes_figure",
    "response_figure",
]

_MM: Final = 1e3
_SHAFT: Final = "#D9DEE3"
_RING: Final = "#9FB3C8"
_ELEMENT: Final = "#F5F7FA"
_GEAR: Final = "#E8D9B5"
_ACROSS: Final = 122.0
"""Width of the drawing, in mm; its height follows, within bounds."""
_LEAST, _MOST = 38.0, 105.0
_BELOW: Final = 118.0
"""Height of the panels below, in mm."""
_ROOM: Final = (2.0, 2.0)
"""Greatest radii below and above the axis: for names and arrows."""
_OUTSIDE: Final = 1.75
"""Outside diameter over the shaft's, of a bearing whose sizes nobody gives."""
_WIDTH_SHARE: Final = 0.22
"""Width over outside diameter, likewise."""
_SMALL: Final = 1e-3
"""Part of the greatest load: what is less has no arrow."""


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
    """
    low, high, greatest = _extent(solved.machine)
    tall = sum(_ROOM) * _MM * greatest
    panel = min(max(_ACROSS * tall / (_MM * (high - low)), _LEAST), _MOST)
    with styled():
        figure = Figure(figsize=(WIDTH * MILLIMETRE, (panel + _BELOW) * MILLIMETRE))
        rest = _BELOW / 2.8
        grid = figure.add_gridspec(4, 1, height_ratios=(panel, rest, rest, 0.8 * rest))
        drawing = figure.add_subplot(grid[0])
        wide = max(_MM * (high - low), _ACROSS * tall / panel) * 1.08
        middle = 0.5 * _MM * (low + high)
        drawing.set_xlim(middle - 0.5 * wide, middle + 0.5 * wide)
        _drawing(drawing, solved.machine, step, greatest)
        lower = [figure.add_subplot(grid[row], sharex=drawing) for row in (1, 2, 3)]
        if solved.status.converged[step]:
            _deflection(lower[0], solved, step)
            _moments(lower[1], solved, step)
            _stress(lower[2], solved, step)
        else:
            for axes in lower:
                empty_frame(axes, said("no equilibrium"))
        for axes in (drawing, *lower[:-1]):
            axes.tick_params(labelbottom=False)
        label_x(lower[-1], said("x (mm)"))
        name = solved.steps[step]
        title = solved.title or said("Machine without a title")
        add_title(figure, f"{title}: {name}" if name else title)
    return figure


# --- the machine to scale -------------------------------------------------------------------------


def _extent(machine: Machine) -> tuple[float, float, float]:
    """Where the machine begins and ends along x, and its greatest radius; m."""
    low = min(shaft.position for shaft in machine.shafts)
    high = max(shaft.position + shaft.length for shaft in machine.shafts)
    radii = [
        0.5 * max(s.diameter, s.right_diameter) for one in machine.shafts for s in one.sections
    ]
    radii += [0.5 * gear.diameter for gear in machine.gears]
    radii += [0.5 * mass.diameter for mass in machine.masses if mass.diameter is not None]
    for one in machine.bearings:
        inside = _radius_at(machine, one.shaft, one.position)
        radii.append(_sizes(one, inside)[0])
    return low, high, max(radii)


def _sizes(seated: MachineBearing, inside: float) -> tuple[float, float]:
    """Outside radius and width of a bearing: as its catalogue has them, or about; m."""
    bearing = seated.case.bearing
    published = bearing.published
    pitch = max(place.bearing.pitch_diameter for place in bearing.places)
    outside = 0.5 * (getattr(published, "outside_diameter", None) or 2.0 * pitch - 2.0 * inside)
    if outside <= 0.5 * pitch:
        outside = _OUTSIDE * inside
    return outside, getattr(published, "width", None) or _WIDTH_SHARE * 2.0 * outside


def _drawing(axes: Axes, machine: Machine, step: int, greatest: float) -> None:
    for shaft in machine.shafts:
        _draw_shaft(axes, shaft)
    for gear in machine.gears:
        x = _x(machine, gear.shaft, gear.position)
        wide = gear.face_width or 0.2 * gear.diameter
        _mirrored(axes, x, wide, _radius_at(machine, gear.shaft, gear.position),
                  0.5 * gear.diameter, _GEAR)  # fmt: skip
    for mass in machine.masses:
        if mass.diameter is not None and mass.width is not None:
            x = _x(machine, mass.shaft, mass.position)
            inside = _radius_at(machine, mass.shaft, mass.position)
            _mirrored(axes, x, mass.width, inside, 0.5 * mass.diameter, _GEAR)
    for bearing in machine.bearings:
        _draw_bearing(axes, machine, bearing)
    _loads(axes, machine, step, greatest)
    axes.axhline(0.0, color=GREY, linewidth=0.6, linestyle=(0, (8, 2, 1, 2)))
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(visible=False)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)


def _x(machine: Machine, shaft: str, position: float) -> float:
    return machine.shaft(shaft).position + position


def _radius_at(machine: Machine, shaft: str, position: float) -> float:
    return 0.5 * max(machine.shaft(shaft).diameters_at(position), default=0.0)


def _draw_shaft(axes: Axes, shaft: Shaft) -> None:
    """Draw the sections."""
    x = shaft.position
    for section in shaft.sections:
        left, right = 0.5 * section.diameter, 0.5 * section.right_diameter
        a, z = 0.5 * section.bore, 0.5 * section.right_bore
        for way in (1.0, -1.0):
            corners = [
                (x, way * a), (x, way * left), (x + section.length, way * right),
                (x + section.length, way * z),
            ]  # fmt: skip
            axes.add_patch(
                Polygon(_MM * np.array(corners), facecolor=_SHAFT, edgecolor="none", zorder=1)
            )
            axes.plot([_MM * x, _MM * (x + section.length)], [_MM * way * left, _MM * way * right],
                      color="black", linewidth=0.8, zorder=2)  # fmt: skip
            if section.bore or section.right_bore:
                axes.plot([_MM * x, _MM * (x + section.length)], [_MM * way * a, _MM * way * z],
                          color="black", linewidth=0.6, linestyle="--", zorder=2)  # fmt: skip
        for end, radius in ((x, left), (x + section.length, right)):
            axes.plot([_MM * end] * 2, [-_MM * radius, _MM * radius], color="black",
                      linewidth=0.8, zorder=2)  # fmt: skip
        x += section.length


def _mirrored(
    axes: Axes, x: float, width: float, inside: float, outside: float, color: str
) -> None:
    """A ring about the axis, cut: above and below it."""
    for way in (1.0, -1.0):
        low = inside if way > 0.0 else -outside
        axes.add_patch(
            Rectangle((_MM * (x - 0.5 * width), _MM * low), _MM * width, _MM * (outside - inside),
                      facecolor=color, edgecolor="black", linewidth=0.7, zorder=3)
        )  # fmt: skip


def _draw_bearing(axes: Axes, machine: Machine, seated: MachineBearing) -> None:
    """Draw rings, elements and lines of contact."""
    bearing, x = seated.case.bearing, _x(machine, seated.shaft, seated.position)
    inside = _radius_at(machine, seated.shaft, seated.position)
    outside, wide = _sizes(seated, inside)
    published, places = bearing.published, bearing.places
    rows = bearing.element_rows
    each = wide / (len(rows) if getattr(published, "width", None) and len(rows) > 1 else 1)
    for place in rows:
        at = x + seated.side * place.position
        one = each if len(places) == 1 else wide
        _draw_row(axes, place.bearing, at, seated.side * place.sign, inside, outside, one)
    for way in (1.0, -1.0):
        _draw_seat(axes, seated, x, way * outside, wide * max(len(places), 1))
    axes.annotate(
        seated.name, (_MM * x, -_MM * outside), xytext=(0, -9), textcoords="offset points",
        ha="center", va="top", fontsize=7.5, parse_math=False,
    )  # fmt: skip


def _draw_row(
    axes: Axes, row: Any, x: float, way: float, inside: float, outside: float, width: float
) -> None:
    size: Any = getattr(row, "ball_diameter", None)
    rollers = size is None
    size = getattr(row, "roller_diameter", 0.0) if size is None else size
    length: Any = getattr(row, "roller_length", None) or getattr(row, "effective_length", 0.0)
    radius = 0.5 * getattr(row, "pitch_diameter", 0.0)
    angle = getattr(row, "contact_angle", None) or 0.0
    half = getattr(row, "roller_half_angle", None) or 0.0
    lean = way * (angle - half) if rollers else 0.0
    for side in (1.0, -1.0):
        for low, high in ((inside, radius - 0.3 * size), (radius + 0.3 * size, outside)):
            bottom = low if side > 0.0 else -high
            axes.add_patch(
                Rectangle((_MM * (x - 0.5 * width), _MM * bottom), _MM * width,
                          _MM * max(high - low, 0.0), facecolor=_RING, edgecolor="black",
                          linewidth=0.6, zorder=3)
            )  # fmt: skip
        centre = (_MM * x, _MM * side * radius)
        look: dict[str, Any] = {
            "facecolor": _ELEMENT,
            "edgecolor": "black",
            "linewidth": 0.7,
            "zorder": 4,
        }
        shape: Patch = Ellipse(centre, _MM * size, _MM * size, **look)
        if rollers:
            corner = (centre[0] - 0.5 * _MM * length, centre[1] - 0.5 * _MM * size)
            shape = Rectangle(corner, _MM * length, _MM * size, **look)
            shape.set_transform(Affine2D().rotate_around(*centre, -side * lean) + axes.transData)
        axes.add_patch(shape)
        if angle > 0.0:  # the line of contact meets the axis on the side that the row faces away
            apex = x - way * radius * tan(angle)
            reach = outside - radius
            axes.plot(
                [_MM * apex, _MM * (x + way * reach * sin(angle) / max(cos(angle), 0.1))],
                [0.0, _MM * side * outside],
                color=OUTER.color, linewidth=0.7, linestyle=(0, (4, 2)), zorder=5,
            )  # fmt: skip


def _draw_seat(axes: Axes, seated: MachineBearing, x: float, y: float, width: float) -> None:
    """How the outer ring is held: hatched where it is, arrows where it slides."""
    if seated.outer_shaft is not None:
        return
    sign = 1.0 if y > 0.0 else -1.0
    if seated.located == "floating":
        axes.annotate(
            "", (_MM * (x - 0.7 * width), _MM * y + 2.5 * sign), zorder=6,
            xytext=(_MM * (x + 0.7 * width), _MM * y + 2.5 * sign),
            arrowprops={"arrowstyle": "<->", "color": GREY, "linewidth": 0.9},
        )  # fmt: skip
        return
    high = 3.0
    axes.add_patch(
        Rectangle((_MM * (x - 0.5 * width), _MM * y if sign > 0.0 else _MM * y - high),
                  _MM * width, high, facecolor="white", edgecolor=GREY, hatch="//////",
                  linewidth=0.4, zorder=2)
    )  # fmt: skip


def _loads(axes: Axes, machine: Machine, step: int, greatest: float) -> None:
    """Arrows of the forces in the plane of the drawing, and their sizes; y into it as a circle."""
    steps = machine.spectrum
    forces = machine.forces(steps[step] if steps else None)
    sizes = [hypot(*one.force[:3]) for one in forces]
    top = max(sizes, default=0.0)
    if not top > 0.0:
        return
    long = 0.45 * _MM * greatest
    for one, size in zip(forces, sizes, strict=True):
        if size < _SMALL * top:
            continue
        fx, fy, fz = one.force[:3]
        x = _MM * _x(machine, one.shaft, one.position)
        radial = hypot(fy, fz)
        text = f"{number(1e-3 * size)} kN" if size >= 1e3 else f"{number(size)} N"
        high = 1.05 * _MM * greatest
        arrow = {"arrowstyle": "-|>", "color": SERIES[3].color, "linewidth": 1.4}
        down = fz < 0.0 or (fz == 0.0 and fy < 0.0)
        if radial >= _SMALL * top:
            tail, head = (high + long, high) if down else (high, high + long)
            axes.annotate("", (x, head), xytext=(x, tail), arrowprops=arrow, zorder=7)
        if abs(fx) >= _SMALL * top:
            ahead = long if fx > 0.0 else -long
            axes.annotate("", (x + ahead, high), xytext=(x, high), arrowprops=arrow, zorder=7)
        axes.annotate(
            text, (x, high + long), xytext=(0, 2), textcoords="offset points", ha="center",
            va="bottom", fontsize=7.5, color=SERIES[3].color, parse_math=False, zorder=7,
        )  # fmt: skip


# --- along the axis -------------------------------------------------------------------------------


def _along(one: SolvedShaft) -> np.ndarray:
    return np.asarray(_MM * (one.shaft.position + one.position))


def _named(one: SolvedShaft, text: str, several: bool) -> str:
    return f"{one.name}: {text}" if several else text


def _deflection(axes: Axes, solved: SolvedMachine, step: int) -> None:
    several = len(solved.shafts) > 1
    styles = iter([*SERIES, *SERIES])
    for one in solved.shafts.values():
        for axis, name in ((1, "y"), (2, "z")):
            style = next(styles)
            axes.plot(
                _along(one), 1e6 * one.displacement[step, :, axis],
                label=_named(one, name, several), **style.keywords(),
            )  # fmt: skip
    _marks(axes, solved)
    label_y(axes, said("Deflection (µm)"))
    legend_above(axes)


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
        axes.axvline(_MM * _x(machine, one.shaft, one.position), color=GREY, linewidth=0.6,
                     linestyle=":", zorder=0)  # fmt: skip


# --- over a field ---------------------------------------------------------------------------------


def machine_over_figure(found: MachineCurve) -> Figure:
    """Draw a machine over one of its fields: lives, pressures, tilts and deflections.

    Parameters
    ----------
    found
        From `rolamento.tasks.machines.machine_over`.
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
        axes = figure.add_subplot()
        rpm, hertz = 30.0 / np.pi * np.abs(found.speed), found.frequency / (2.0 * np.pi)
        looks = {"forward": SERIES[0], "backward": SERIES[1], "axial": SERIES[2]}
        shown: set[str] = set()
        for branch in range(hertz.shape[1]):
            named = [str(one) for one in found.whirl[:, branch] if one]
            kind = max(set(named), key=named.count) if named else ""
            style = looks.get(kind, SERIES[6])
            label = "_" if kind in shown else whirl_name(kind)
            shown.add(kind)
            axes.plot(rpm, hertz[:, branch], label=label, **style.keywords())
        for order in sorted({one.order for one in found.critical} | {1.0}):
            line = order * rpm / 60.0
            axes.plot(rpm, line, color=GREY, linewidth=0.8)
            axes.annotate(f"{number(order)}×", (rpm[-1], line[-1]), fontsize=7.5, color=GREY,
                          xytext=(3, 0), textcoords="offset points", va="center")  # fmt: skip
        for one in found.critical:
            axes.plot(30.0 / np.pi * one.speed, one.frequency / (2.0 * np.pi), "o", color="black",
                      markersize=4.0, zorder=5)  # fmt: skip
        label_x(axes, said("Speed of {shaft} (rpm)", shaft=found.shaft))
        label_y(axes, said("Natural frequency (Hz)"))
        axes.set_ylim(bottom=0.0)
        legend_above(axes)
        add_title(figure, found.machine.title or said("Machine without a title"))
    return figure


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
        rpm = 30.0 / np.pi * np.abs(found.speed)
        for number_, name in enumerate(found.displacement):
            orbits.plot(rpm, 1e6 * found.amplitude(name).max(axis=1), label=name,
                        **SERIES[number_ % len(SERIES)].keywords())  # fmt: skip
        for number_, name in enumerate(found.force):
            forces.plot(rpm, found.force_amplitude(name), label=name,
                        **SERIES[number_ % len(SERIES)].keywords())  # fmt: skip
        label_y(orbits, said("Greatest orbit (µm)"))
        label_y(forces, said("Force at bearing (N)"))
        label_x(forces, said("Speed of {shaft} (rpm)", shaft=found.shaft))
        for axes in (orbits, forces):
            log_scale(axes, "y")
            legend_above(axes)
        add_title(figure, found.machine.title or said("Machine without a title"))
    return figure


def _directions() -> Iterable[tuple[int, str, Series]]:
    return zip((0, 1, 2), ("x", "y", "z"), (SERIES[2], SERIES[0], SERIES[1]), strict=True)
