"""A machine in section, to scale: shafts, the symbols of their bearings, gears, pulleys, loads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from math import cos, hypot, sin, tan
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.patches import Ellipse, PathPatch, Polygon, Rectangle
from matplotlib.path import Path
from matplotlib.ticker import MaxNLocator

from rolamento.charts.frame import GREY, add_title, figure_of, label_x, require, require_axes
from rolamento.charts.style import MILLIMETRE, OUTER, in_style, new_figure
from rolamento.charts.texts import number, shown_text
from rolamento.errors import InputError
from rolamento.types import type_of_element
from rolamento.words import said
from rolamento.words.naming import machine_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.case.machine import Machine, MachineBearing, PointForce, Shaft
    from rolamento.case.machine_loads import Gear, Mass
    from rolamento.solved.machine import SolvedMachine

__all__ = ["draw_machine"]

MM: Final = 1e3
LOAD: Final = "#8A3A6B"
"""The house's purple, dark enough for small type."""
SPOKEN: Final = 1.65
"""Width of a character of small type on paper, in mm."""
LINE: Final = 3.75
"""Height of a line of it."""
SMALL: Final = 8.5
MOST: Final = 105.0
"""Greatest height of a drawing on paper, in mm."""
ACROSS: Final = 124.0
"""Its width, likewise."""

_SHAFT: Final = "#D9DEE3"
_RING: Final = "#9FB3C8"
_ELEMENT: Final = "#F5F7FA"
_GEAR: Final = "#E8D9B5"
_PULLEY: Final = "#CFE3D8"
_ARROW: Final = 8.0
"""Length of an arrow on paper, in mm."""
_MARGIN: Final = 1.5
_OUTSIDE: Final = 1.75
"""Outside diameter over the shaft's, of a bearing whose sizes nobody gives."""
_WIDTH_SHARE: Final = 0.22
"""Width over outside diameter, likewise."""
_FACE_SHARE: Final = 0.2
"""Width over diameter, of gears and pulleys."""
_LEAST: Final = 1e-3
"""Part of the greatest load below which there is no arrow."""
_APART: Final = 0.9
"""Part of a bearing's width: rows closer than this are in one ring."""
_STEEP: Final = 1.3
"""Contact angle beyond which washers, not rings, lie side by side; rad."""
_ENDS: Final = 0.57
"""Diameter of a barrel roller at its ends, over that in the middle."""


@in_style
def draw_machine(solved: SolvedMachine, axes: Axes | None = None, *, step: int = 0) -> Axes:
    """Draw shafts to scale, with bearings and how they are held, gears, pulleys and loads.

    Seen toward +y: x to the right, z up. Shafts about one axis lie one within the other; others
    lie one below the other. Dashed lines across a bearing are its lines of contact; where they
    meet the axis is its pressure centre.

    Parameters
    ----------
    solved
        From `rolamento.shaft`; it is drawn without a result as well.
    axes
        To draw on; of a new figure as high as is needed if not given.
    step
        Step of its spectrum whose loads are shown, from 0.

    Returns
    -------
    Axes
        Those given.

    Raises
    ------
    InputError
        If this is no solved machine, there is no such step, or the axes are none.
    """
    check_step(solved, step)
    if axes is None:
        plan = planned(solved.machine, step)
        figure, axes = new_figure(height=plan.height + 18.0)
        add_title(figure, title_of(solved, step))
    else:
        plan = planned(solved.machine, step, *paper_of(require_axes(axes)))
    draw_planned(axes, plan)
    label_x(axes, said("x (mm)"))
    return axes


def check_step(solved: SolvedMachine, step: int) -> None:
    """Refuse what is no solved machine, and steps that it has not."""
    from rolamento.solved.machine import SolvedMachine

    require(solved, SolvedMachine, "solved", 'rolamento.shaft("machine.toml")')
    if not 0 <= step < len(solved):
        raise InputError(
            said("must be at least {at_least} and at most {at_most}", at_least=0,
                 at_most=len(solved) - 1),
            field="step", value=step,
        )  # fmt: skip


def title_of(solved: SolvedMachine, step: int | None) -> str:
    """Return what a machine is called, and a step of its spectrum."""
    title = machine_title(solved.title)
    name = "" if step is None else solved.steps[step]
    return f"{title}: {name}" if name else title


def paper_of(axes: Axes) -> tuple[float, float]:
    """Return about how wide and high axes are on paper; mm."""
    figure, place = figure_of(axes), axes.get_position()
    return (
        figure.get_figwidth() * place.width / MILLIMETRE,
        figure.get_figheight() * place.height / MILLIMETRE,
    )


def place_of(machine: Machine, shaft: str, position: float) -> float:
    """Return a place on a shaft along the machine's x; m."""
    return machine.shaft(shaft).position + position


def levels(blocks: Sequence[tuple[float, float]]) -> list[int]:
    """Stagger texts so that none covers another.

    blocks: where the middle of each is, and how wide it is. Returns the level of each, from 0.
    """
    free: list[float] = []
    found = [0] * len(blocks)
    for index in sorted(range(len(blocks)), key=lambda one: blocks[one][0] - blocks[one][1] / 2.0):
        middle, wide = blocks[index]
        fitting = (one for one, taken in enumerate(free) if middle - 0.5 * wide >= taken)
        level = next(fitting, len(free))
        if level == len(free):
            free.append(0.0)
        free[level] = middle + 0.5 * wide
        found[index] = level
    return found


# --- where things go ------------------------------------------------------------------------------


class _Label(NamedTuple):
    """A text beside the machine: where along x it belongs, what it says, from which height."""

    x: float
    lines: tuple[str, ...]
    surface: float
    force: tuple[float, float, float] | None = None

    @property
    def wide(self) -> float:
        """On paper, mm."""
        text = SPOKEN * max(map(len, self.lines), default=0) + _MARGIN
        arrows = 0.0 if self.force is None else 2.0 * _ARROW * bool(self.force[0])
        return max(text, arrows)

    @property
    def high(self) -> float:
        """On paper, mm."""
        arrows = 0.0 if self.force is None else _ARROW + 2.0 * _MARGIN
        return LINE * len(self.lines) + arrows + 0.5 * _MARGIN


class Stacked(NamedTuple):
    """Labels at their levels: how far each is from the drawing, and how high all are; mm."""

    away: tuple[float, ...]
    high: float


def _stacked(labels: Sequence[_Label], paper: float) -> Stacked:
    found = levels([(MM * one.x, one.wide * paper) for one in labels])
    count = max(found, default=-1) + 1
    heights = [
        max(one.high for one, own in zip(labels, found, strict=True) if own == level)
        for level in range(count)
    ]
    return Stacked(tuple(sum(heights[:level]) for level in found), sum(heights))


@dataclass(frozen=True)
class Lane:
    """Shafts about one axis."""

    machine: Machine
    shafts: tuple[str, ...]
    step: int

    @cached_property
    def bearings(self) -> tuple[MachineBearing, ...]:
        """Those whose inner ring is on its shafts."""
        return tuple(one for one in self.machine.bearings if one.shaft in self.shafts)

    def on(self, parts: Iterable[Any]) -> Iterator[Any]:
        """Return the parts that are on its shafts."""
        return (one for one in parts if one.shaft in self.shafts)

    @cached_property
    def radius(self) -> float:
        """Greatest radius, m."""
        machine, found = self.machine, []
        for name in self.shafts:
            for one in machine.shaft(name).sections:
                found.append(0.5 * max(one.diameter, one.right_diameter))
        found += [_gear_radius(one) for one in self.on(machine.gears)]
        found += [0.5 * one.diameter for one in self.on(machine.belts)]
        found += [0.5 * (one.diameter or 0.0) for one in self.on(machine.masses)]
        found += [_sizes(machine, one)[0] for one in self.bearings]
        return max(found)

    @cached_property
    def springs(self) -> bool:
        """Whether something elastic stands on the ground below it."""
        held = any(self.machine.housing_of(one.name) for one in self.bearings)
        return held or any(one.to_shaft is None for one in self.on(self.machine.springs))

    @property
    def seat(self) -> float:
        """Room for housings above and below, on paper; mm."""
        return 10.0 if self.springs else 5.0

    @cached_property
    def above(self) -> tuple[_Label, ...]:
        """What acts on it."""
        spectrum = self.machine.spectrum
        forces = self.machine.forces(spectrum[self.step] if spectrum else None)
        top = max((hypot(*one.force[:3]) for one in forces), default=0.0)
        found = []
        for one in forces:
            torque = any(one.force[3:])
            if one.shaft in self.shafts and (hypot(*one.force[:3]) > _LEAST * top or torque):
                found.append(self._force(one, _LEAST * hypot(*one.force[:3])))
        return tuple(found)

    def _force(self, one: PointForce, least: float) -> _Label:
        lines = [shown_text(one.name, 26)] if one.name else []
        x, y, z = (part if abs(part) > least else 0.0 for part in one.force[:3])
        for symbol, part in zip(("Fx", "Fy", "Fz"), (x, y, z), strict=True):
            if part:
                lines.append(f"{symbol} {_newtons(part)}")
        greatest = max(map(abs, one.force[3:]))
        for symbol, part in zip(("Mx", "My", "Mz"), one.force[3:], strict=True):
            if abs(part) > _LEAST * greatest:
                lines.append(f"{symbol} {number(part, 3)} N·m")
        at = place_of(self.machine, one.shaft, one.position)
        return _Label(at, tuple(lines), self.surface(at, one.shaft), (x, y, z))

    @cached_property
    def below(self) -> tuple[_Label, ...]:
        """Names of bearings, and of what carries no force of its own."""
        machine, found = self.machine, []
        for one in self.bearings:
            x = place_of(machine, one.shaft, one.position)
            lines = [shown_text(one.name, 26)]
            if (size := _designation(one)) and size not in one.name:
                lines.append(size)
            found.append(_Label(x, tuple(lines), _sizes(machine, one)[0]))
        for mass in self.on(machine.masses):
            x = place_of(machine, mass.shaft, mass.position)
            weight = f"{number(mass.inertia.mass, 3)} kg"
            lines = [shown_text(mass.name, 26), weight] if mass.name else [weight]
            found.append(_Label(x, tuple(lines), 0.5 * (mass.diameter or 0.0)))
        for spring in self.on(machine.springs):
            if spring.name:
                x = place_of(machine, spring.shaft, spring.position)
                found.append(_Label(x, (shown_text(spring.name, 26),), self.surface(x)))
        return tuple(found)

    def surface(self, x: float, shaft: str | None = None) -> float:
        """Return how far from the axis the outermost part at a place is; m."""
        machine = self.machine
        names = self.shafts if shaft is None else (shaft,)
        found = [0.0]
        for one in map(machine.shaft, names):
            found += [0.5 * diameter for diameter in one.diameters_at(x - one.position)]
        for part in self.on([*machine.gears, *machine.belts]):
            away = abs(place_of(machine, part.shaft, part.position) - x)
            if part.shaft in names and away < 1e-9:
                found.append(0.5 * part.diameter)
        return max(found)


class Plan(NamedTuple):
    """Where a machine's parts are drawn.

    paper: mm of the machine for one on paper; height: on paper, mm; middle: y of each lane's axis.
    """

    machine: Machine
    lanes: tuple[Lane, ...]
    paper: float
    height: float
    width: float
    middle: tuple[float, ...]
    bottom: float


def planned(
    machine: Machine, step: int, width: float = ACROSS, height: float | None = None
) -> Plan:
    """Lay a drawing out, on paper of a size; as high as is needed if that is not given."""
    lanes = tuple(Lane(machine, names, step) for names in _coaxial(machine))
    low = MM * min(one.position for one in machine.shafts)
    high = MM * max(one.position + one.length for one in machine.shafts)
    inner = max(width - 20.0, 0.5 * width)
    paper = (high - low) / inner
    tall = sum(2.0 * MM * one.radius for one in lanes)
    for _ in range(4):  # a smaller scale staggers more labels, which need more room
        rooms = sum(
            _stacked(one.above, paper).high + _stacked(one.below, paper).high + 2.0 * one.seat
            for one in lanes
        )
        room = (MOST * len(lanes) if height is None else height) - rooms
        paper = max((high - low) / inner, tall / max(room, 10.0))
    y, middle = 0.0, []
    for one in lanes:
        y -= (_stacked(one.above, paper).high + one.seat) * paper + MM * one.radius
        middle.append(y)
        y -= (_stacked(one.below, paper).high + one.seat) * paper + MM * one.radius
    offset = middle[0]  # the first axis is at zero
    return Plan(
        machine, lanes, paper, -y / paper, width, tuple(m - offset for m in middle), y - offset
    )


def draw_planned(axes: Axes, plan: Plan) -> None:
    """Draw a machine as it was laid out."""
    machine = plan.machine
    low = MM * min(one.position for one in machine.shafts)
    high = MM * max(one.position + one.length for one in machine.shafts)
    half = 0.5 * plan.width * plan.paper
    # limits that are fixed could not give way to one scale along both axes
    axes.update_datalim([
        (0.5 * (low + high) - half, plan.bottom),
        (0.5 * (low + high) + half, plan.bottom + plan.height * plan.paper),
    ])  # fmt: skip
    axes.margins(0.0)
    for lane, middle in zip(plan.lanes, plan.middle, strict=True):
        _Pen(axes, lane, middle, plan.paper).draw()
    for spring in machine.springs:
        _coupling(axes, plan, spring)
    _gravity(axes, machine)
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(visible=False)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    ticks = np.asarray(MaxNLocator(9, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    slack = 1e-6 * (high - low)
    axes.set_xticks(ticks[(ticks >= low - slack) & (ticks <= high + slack)])
    axes.spines["bottom"].set_bounds(low, high)


def _coaxial(machine: Machine) -> list[tuple[str, ...]]:
    """Names of the shafts about each axis."""
    axis = {one.name: one.name for one in machine.shafts}

    def join(one: str, other: str) -> None:
        kept, gone = axis[one], axis[other]
        for name, own in axis.items():
            if own == gone:
                axis[name] = kept

    for bearing in machine.bearings:
        if bearing.outer_shaft is not None:
            join(bearing.shaft, bearing.outer_shaft)
    for spring in machine.springs:
        if spring.to_shaft is not None:
            join(spring.shaft, spring.to_shaft)
    for one, other in combinations(machine.shafts, 2):
        if _fits(one, other) or _fits(other, one):
            join(one.name, other.name)
    return [names for lead in axis if (names := tuple(name for name in axis if axis[name] == lead))]


def _fits(within: Shaft, hollow: Shaft) -> bool:
    """Whether one shaft is in the bore of another."""
    low = max(within.position, hollow.position)
    high = min(within.position + within.length, hollow.position + hollow.length)
    if low >= high:
        return False
    thickest = max(
        max(section.diameter, section.right_diameter)
        for section, start in zip(within.sections, within.edges, strict=False)
        if start + within.position < high and start + section.length + within.position > low
    )
    narrowest = min(min(section.bore, section.right_bore) for section in hollow.sections)
    return thickest <= narrowest


def _newtons(force: float) -> str:
    return f"{number(1e-3 * force, 3)} kN" if abs(force) >= 1e3 else f"{number(force, 3)} N"


def _designation(seated: MachineBearing) -> str:
    table = seated.bearing
    within = table.get("designation") if isinstance(table, dict) else None
    return seated.designation or (str(within) if within else "")


def _radius_at(machine: Machine, shaft: str, position: float) -> float:
    return 0.5 * max(machine.shaft(shaft).diameters_at(position), default=0.0)


def _sizes(machine: Machine, seated: MachineBearing) -> tuple[float, float, float]:
    """Outside radius, width and bore radius of a bearing: those of its catalogue, or about; m."""
    inside = _radius_at(machine, seated.shaft, seated.position)
    bearing = seated.case.bearing
    published = bearing.published
    pitch = max(place.bearing.pitch_diameter for place in bearing.places)
    outside = 0.5 * (getattr(published, "outside_diameter", None) or 2.0 * pitch - 2.0 * inside)
    if outside <= 0.5 * pitch:
        outside = max(_OUTSIDE * inside, 0.6 * pitch)
    wide = getattr(published, "width", None) or _WIDTH_SHARE * 2.0 * outside
    return outside, wide, min(inside, 0.45 * pitch)


def _gear_radius(gear: Gear) -> float:
    return 0.5 * gear.diameter + 0.5 * _face(gear) * sin(gear.cone_angle or 0.0)


def _face(gear: Gear) -> float:
    return gear.face_width or _FACE_SHARE * gear.diameter


# --- with a pen -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Pen:
    """Draws the shafts about one axis; lengths along it in m, on paper in mm."""

    axes: Axes
    lane: Lane
    middle: float
    paper: float

    def draw(self) -> None:
        """Draw everything."""
        machine, lane = self.lane.machine, self.lane
        shafts = [machine.shaft(name) for name in lane.shafts]
        shafts.sort(key=lambda one: -max(section.diameter for section in one.sections))
        for depth, shaft in enumerate(shafts):  # what is within lies before what is round it
            self._shaft(shaft, 1.0 + 0.05 * depth)
        low = MM * min(one.position for one in shafts) - 4.0 * self.paper
        high = MM * max(one.position + one.length for one in shafts) + 4.0 * self.paper
        self.axes.plot([low, high], [self.middle] * 2, color=GREY, linewidth=0.6,
                       linestyle=(0, (8, 2, 1, 2)), zorder=2.5)  # fmt: skip
        for mass in lane.on(machine.masses):
            self._mass(mass)
        for gear in lane.on(machine.gears):
            self._gear(gear)
        for belt in lane.on(machine.belts):
            self._pulley(belt)
        for bearing in lane.bearings:
            self._bearing(bearing)
        self._names()
        self._forces()

    def _patch(self, corners: Iterable[tuple[float, float]], side: float, **look: Any) -> None:
        """A closed outline, x in m and distance from the axis in m, above or below it."""
        points = [(MM * x, self.middle + side * MM * y) for x, y in corners]
        codes = [Path.MOVETO, *[Path.LINETO] * (len(points) - 1), Path.CLOSEPOLY]
        look = {"edgecolor": "black", "linewidth": 0.7, "zorder": 3.0, **look}
        self.axes.add_patch(PathPatch(Path([*points, points[0]], codes), **look))

    def _box(self, left: float, right: float, low: float, high: float, side: float,
             **look: Any) -> None:  # fmt: skip
        """A rectangle likewise."""
        look = {"edgecolor": "black", "linewidth": 0.6, "zorder": 3.0, **look}
        bottom = self.middle + MM * (low if side > 0.0 else -high)
        self.axes.add_patch(
            Rectangle((MM * left, bottom), MM * (right - left), MM * max(high - low, 0.0), **look)
        )

    def _line(self, x: Sequence[float], y: Sequence[float], side: float = 1.0, **look: Any) -> None:
        look = {"color": "black", "linewidth": 0.7, "zorder": 5.0, **look}
        away = [self.middle + side * MM * one for one in y]
        self.axes.plot([MM * one for one in x], away, **look)

    def _shaft(self, shaft: Shaft, depth: float) -> None:
        x = shaft.position
        for section in shaft.sections:
            end = x + section.length
            left, right = 0.5 * section.diameter, 0.5 * section.right_diameter
            a, z = 0.5 * section.bore, 0.5 * section.right_bore
            for side in (1.0, -1.0):
                corners = np.array([(x, a), (x, left), (end, right), (end, z)]) * (MM, side * MM)
                corners[:, 1] += self.middle
                self.axes.add_patch(
                    Polygon(corners, facecolor=_SHAFT, edgecolor="none", zorder=depth)
                )
                self._line((x, end), (left, right), side, linewidth=0.8, zorder=depth + 0.01)
                if a or z:
                    self._line((x, end), (a, z), side, linewidth=0.6, linestyle="--",
                               zorder=depth + 0.01)  # fmt: skip
            for at, radius in ((x, left), (end, right)):
                self._line((at, at), (-radius, radius), linewidth=0.8, zorder=depth + 0.01)
            x = end

    # --- what shafts carry ------------------------------------------------------------------------

    def _mass(self, mass: Mass) -> None:
        x = place_of(self.lane.machine, mass.shaft, mass.position)
        if mass.diameter is None or mass.width is None:
            self.axes.plot(MM * x, self.middle, "o", markersize=7.0, color="black",
                           markerfacecoloralt="white", fillstyle="left", zorder=6)  # fmt: skip
            return
        inside = max(0.5 * mass.bore, _radius_at(self.lane.machine, mass.shaft, mass.position))
        for side in (1.0, -1.0):
            self._box(x - 0.5 * mass.width, x + 0.5 * mass.width, min(inside, 0.4 * mass.diameter),
                      0.5 * mass.diameter, side, facecolor="#E6E6E6", hatch="....",
                      zorder=2.0)  # fmt: skip

    def _gear(self, gear: Gear) -> None:
        machine = self.lane.machine
        x, radius = place_of(machine, gear.shaft, gear.position), 0.5 * gear.diameter
        cone = gear.cone_angle or 0.0
        half = 0.5 * _face(gear) * cos(cone)
        grows = tan(cone) * half * (1.0 if gear.apex == "-x" else -1.0)
        inside = min(_radius_at(machine, gear.shaft, gear.position), 0.7 * (radius - abs(grows)))
        for side in (1.0, -1.0):
            self._patch(
                ((x - half, inside), (x - half, radius - grows), (x + half, radius + grows),
                 (x + half, inside)),
                side, facecolor=_GEAR, zorder=2.2,
            )  # fmt: skip
            rim = 0.06 * radius
            self._line((x - half, x + half), (radius - grows - rim, radius + grows - rim), side,
                       linewidth=0.5, linestyle=(0, (6, 2, 1, 2)), zorder=2.3)  # fmt: skip

    def _pulley(self, belt: Any) -> None:
        """A groove in the rim."""
        machine = self.lane.machine
        x, radius = place_of(machine, belt.shaft, belt.position), 0.5 * belt.diameter
        half = 0.5 * _FACE_SHARE * belt.diameter
        inside = min(_radius_at(machine, belt.shaft, belt.position), 0.7 * radius)
        depth = 0.18 * radius
        for side in (1.0, -1.0):
            self._patch(
                ((x - half, inside), (x - half, radius), (x - 0.6 * half, radius),
                 (x - 0.25 * half, radius - depth), (x + 0.25 * half, radius - depth),
                 (x + 0.6 * half, radius), (x + half, radius), (x + half, inside)),
                side, facecolor=_PULLEY, zorder=2.2,
            )  # fmt: skip

    # --- bearings ---------------------------------------------------------------------------------

    def _bearing(self, seated: MachineBearing) -> None:
        machine, bearing = self.lane.machine, seated.case.bearing
        x = place_of(machine, seated.shaft, seated.position)
        outside, wide, inside = _sizes(machine, seated)
        rows = [(x + seated.side * one.position, seated.side * one.sign, one.bearing)
                for one in bearing.element_rows]  # fmt: skip
        places = sorted(at for at, _, _ in rows)
        apart = min(np.diff(places), default=wide)
        rings = [x] if apart < _APART * wide else places
        for at in rings:
            self._rings(rows[0][2], at, wide, inside, outside)
        for at, way, row in rows:
            self._element(row, at, way)
        for one in bearing.places:
            self._contact(one.bearing, x + seated.side * one.position, seated.side * one.sign,
                          inside, outside)  # fmt: skip
        half = 0.5 * (max(rings) - min(rings) + wide)
        middle = 0.5 * (max(rings) + min(rings))
        if seated.outer_shaft is not None:
            if seated.located == "floating":
                self._slides(middle, half, outside + 1.4 * self.paper / MM)
            return
        self._seat(seated, middle, half, outside, rows[0])

    def _rings(self, row: Any, x: float, wide: float, inside: float, outside: float) -> None:
        size, radius = row.element_diameter, 0.5 * row.pitch_diameter
        half = 0.5 * wide
        for side in (1.0, -1.0):
            if (row.contact_angle or 0.0) > _STEEP:  # washers
                for left, right in ((x - half, x - 0.3 * size), (x + 0.3 * size, x + half)):
                    self._box(left, right, inside, outside, side, facecolor=_RING)
                continue
            for low, high in ((inside, radius - 0.3 * size), (radius + 0.3 * size, outside)):
                self._box(x - half, x + half, low, high, side, facecolor=_RING)

    def _element(self, row: Any, x: float, way: float) -> None:
        size, radius = row.element_diameter, 0.5 * row.pitch_diameter
        look: dict[str, Any] = {"facecolor": _ELEMENT, "edgecolor": "black", "linewidth": 0.7,
                                "zorder": 4.0}  # fmt: skip
        kind = type_of_element(row.element)
        if not kind.has_rollers:
            for side in (1.0, -1.0):
                centre = (MM * x, self.middle + side * MM * radius)
                self.axes.add_patch(Ellipse(centre, MM * size, MM * size, **look))
            return
        length = row.roller_length or row.effective_length
        half = getattr(row, "roller_half_angle", None) or 0.0
        lean = -way * ((row.contact_angle or 0.0) - half)
        for side in (1.0, -1.0):
            outline = _roller(
                x, radius, size, length, lean, taper=way * tan(half), barrels=kind.barrels
            )
            self._patch(outline, side, **look)

    def _contact(self, row: Any, x: float, way: float, inside: float, outside: float) -> None:
        """The line of contact, to the axis on the side that the row faces away from."""
        angle = row.contact_angle or 0.0
        if not 0.0 < angle <= _STEEP:
            return
        radius = 0.5 * row.pitch_diameter
        apex = x - way * radius * tan(angle)
        for side in (1.0, -1.0):
            self._line((apex, x + way * (outside - radius) * tan(angle)), (0.0, outside), side,
                       color=OUTER.color, linewidth=0.8, linestyle=(0, (4, 2)))  # fmt: skip
        self.axes.plot(MM * apex, self.middle, "o", markersize=2.5, color=OUTER.color, zorder=6.0)

    def _seat(
        self, seated: MachineBearing, x: float, half: float, outside: float, row: tuple[Any, ...]
    ) -> None:
        """How the outer ring is held: by hatched shoulders, or free to slide; by springs or not."""
        unit = self.paper / MM
        hatched: dict[str, Any] = {"facecolor": "white", "edgecolor": GREY, "hatch": "//////",
                                   "linewidth": 0.5, "zorder": 2.8}  # fmt: skip
        elastic = self.lane.machine.housing_of(seated.name) is not None
        slides, shoulder = seated.located == "floating", 1.6 * unit
        gap = 0.5 * unit if slides else 0.0
        low, deep = outside + gap, 0.3 * (outside - 0.5 * row[2].pitch_diameter)
        right = seated.located in ("both", "+x")
        left = seated.located in ("both", "-x")
        body = {**hatched, "hatch": None, "facecolor": "#ECECEC"} if elastic else hatched
        for side in (1.0, -1.0):
            self._box(x - half - shoulder, x + half + shoulder, low, low + 1.8 * unit, side, **body)
            for held, start in ((left, x - half - shoulder), (right, x + half)):
                if held:
                    self._box(start, start + shoulder, outside - deep, low, side, **body)
            if elastic:
                bottom = low + 1.8 * unit
                self._spring((x, bottom), (x, bottom + 4.5 * unit), side)
                self._box(x - half, x + half, bottom + 4.5 * unit, bottom + 6.0 * unit, side,
                          **hatched)  # fmt: skip
        if slides:
            self._slides(x, half, low + 3.0 * unit)
        if seated.spring_force:
            push = row[1]  # the spring pushes the outer ring against the way of the row
            start, end = x + push * half, x + push * (half + 4.0 * unit)
            for side in (1.0, -1.0):
                self._spring((start, outside - deep), (end, outside - deep), side)
                self._box(min(end, end + push * shoulder), max(end, end + push * shoulder),
                          outside - 2.0 * deep, low + 1.8 * unit, side, **hatched)  # fmt: skip

    def _slides(self, x: float, half: float, y: float) -> None:
        """Arrows both ways."""
        reach = max(half, 2.5 * self.paper / MM)
        for side in (1.0, -1.0):
            at = self.middle + side * MM * y
            self.axes.annotate(
                "", (MM * (x - reach), at), xytext=(MM * (x + reach), at), zorder=6,
                annotation_clip=False,
                arrowprops={"arrowstyle": "<->", "color": GREY, "linewidth": 0.9, "shrinkA": 0,
                            "shrinkB": 0, "mutation_scale": 7},
            )  # fmt: skip

    def _spring(
        self, start: tuple[float, float], end: tuple[float, float], side: float = 1.0
    ) -> None:
        points = zigzag(start, end, 1.1 * self.paper / MM)
        self._line(points[:, 0].tolist(), points[:, 1].tolist(), side, linewidth=0.8)

    # --- names and loads --------------------------------------------------------------------------

    def _names(self) -> None:
        lane, labels = self.lane, self.lane.below
        base = self.middle - MM * lane.radius - lane.seat * self.paper
        for one, away in zip(labels, _stacked(labels, self.paper).away, strict=True):
            top = base - away * self.paper
            self.axes.plot([MM * one.x] * 2, [self.middle - MM * one.surface, top], color=GREY,
                           linewidth=0.5, linestyle=":", zorder=0.5)  # fmt: skip
            self.axes.annotate(
                "\n".join(one.lines), (MM * one.x, top), ha="center", va="top", fontsize=SMALL,
                linespacing=1.1, parse_math=False, zorder=7, bbox=_CLEAR,
            )  # fmt: skip
        for spring in lane.on(lane.machine.springs):
            if spring.to_shaft is None:
                x = place_of(lane.machine, spring.shaft, spring.position)
                unit, start = self.paper / MM, lane.surface(x, spring.shaft)
                self._spring((x, start), (x, start + 7.0 * unit), -1.0)
                self._box(x - 3.0 * unit, x + 3.0 * unit, start + 7.0 * unit, start + 8.5 * unit,
                          -1.0, facecolor="white", edgecolor=GREY, hatch="//////")  # fmt: skip

    def _forces(self) -> None:
        lane, labels = self.lane, self.lane.above
        base = self.middle + MM * lane.radius + lane.seat * self.paper
        for one, away in zip(labels, _stacked(labels, self.paper).away, strict=True):
            x, y = MM * one.x, base + away * self.paper
            self.axes.plot([x, x], [self.middle + MM * one.surface, y], color=LOAD, linewidth=0.5,
                           linestyle=":", zorder=0.5)  # fmt: skip
            assert one.force is not None
            self._arrows(x, y, one.force)
            self.axes.annotate(
                "\n".join(one.lines), (x, y + (_ARROW + _MARGIN) * self.paper), ha="center",
                va="bottom", fontsize=SMALL, linespacing=1.1, color=LOAD, parse_math=False,
                zorder=7, bbox=_CLEAR,
            )  # fmt: skip

    def _arrows(self, x: float, y: float, force: tuple[float, float, float]) -> None:
        """Up, down and along; into the paper as a cross in a circle, out of it as a point."""
        reach, middle = _ARROW * self.paper, y + 0.5 * _ARROW * self.paper
        look = {"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.3, "shrinkA": 0, "shrinkB": 0,
                "mutation_scale": 9}  # fmt: skip
        if force[2]:
            ends = (y + reach, y) if force[2] < 0.0 else (y, y + reach)
            self.axes.annotate("", (x, ends[1]), xytext=(x, ends[0]), arrowprops=look, zorder=7,
                               annotation_clip=False)  # fmt: skip
        if force[0]:
            ahead = reach if force[0] > 0.0 else -reach
            self.axes.annotate("", (x + ahead, middle), xytext=(x, middle), arrowprops=look,
                               zorder=7, annotation_clip=False)  # fmt: skip
        if force[1]:
            beside = (
                0.0
                if not (force[0] or force[2])
                else -0.4 * reach * (force[0] >= 0.0) + (0.4 * reach * (force[0] < 0.0))
            )
            self.axes.plot(x + beside, middle, "o", markersize=7.0, markerfacecolor="white",
                           markeredgecolor=LOAD, zorder=7.5)  # fmt: skip
            self.axes.plot(x + beside, middle, "x" if force[1] > 0.0 else ".", color=LOAD,
                           markersize=4.5 if force[1] > 0.0 else 5.0, zorder=7.6)  # fmt: skip


_CLEAR: Final[dict[str, Any]] = {"facecolor": "white", "edgecolor": "none", "pad": 0.6}


def _roller(
    x: float, radius: float, size: float, length: float, lean: float, *, taper: float, barrels: bool
) -> list[tuple[float, float]]:
    """Outline of a roller above the axis: x and distance from it.

    taper: how fast its radius shrinks along its own axis.
    """
    along = np.linspace(-0.5, 0.5, 9 if barrels else 2) * length
    half = 0.5 * size - taper * along
    if barrels:
        half = 0.5 * size * (1.0 - (1.0 - _ENDS) * (2.0 * along / length) ** 2)
    u, v = np.concatenate([along, along[::-1]]), np.concatenate([half, -half[::-1]])
    return [
        (x + a * cos(lean) - b * sin(lean), radius + a * sin(lean) + b * cos(lean))
        for a, b in zip(u.tolist(), v.tolist(), strict=True)
    ]


def zigzag(start: tuple[float, float], end: tuple[float, float], wide: float) -> np.ndarray:
    """Return the points of a spring between two places; wide: how far it swings out."""
    along = np.array([0.0, 0.18, *np.linspace(0.24, 0.76, 6), 0.82, 1.0])
    across = wide * np.array([0.0, 0.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 0.0, 0.0])
    first, last = np.asarray(start), np.asarray(end)
    way = last - first
    normal = np.array([-way[1], way[0]]) / max(hypot(*way), 1e-300)
    return np.asarray(first + np.outer(along, way) + np.outer(across, normal))


def _coupling(axes: Axes, plan: Plan, spring: Any) -> None:
    """A spring between two shafts."""
    if spring.to_shaft is None:
        return
    ends = []
    for shaft, at in ((spring.shaft, spring.position), (spring.to_shaft, spring.to_position)):
        lane = next(i for i, one in enumerate(plan.lanes) if shaft in one.shafts)
        x = place_of(plan.machine, shaft, at)
        ends.append([MM * x, plan.middle[lane]])
    if abs(ends[0][0] - ends[1][0]) < plan.paper:  # at one place: between surface and bore
        for end, shaft, at in zip(ends, (spring.shaft, spring.to_shaft),
                                  (spring.position, spring.to_position), strict=True):  # fmt: skip
            end[1] += MM * _radius_at(plan.machine, shaft, at)
    points = zigzag((ends[0][0], ends[0][1]), (ends[1][0], ends[1][1]), 1.3 * plan.paper)
    axes.plot(points[:, 0], points[:, 1], color="black", linewidth=1.0, zorder=6)


def _gravity(axes: Axes, machine: Machine) -> None:
    """Which way weights act, in a corner; nothing of what acts across the paper."""
    if machine.gravity is None:
        return
    x, _, z = machine.gravity.vector
    size = hypot(x, z)
    if size == 0.0:
        return
    axes.annotate(
        "g", (0.03, 0.93), (-20.0 * x / size, -20.0 * z / size), xycoords="axes fraction",
        textcoords="offset points", fontsize=SMALL, color=LOAD, ha="center", va="center",
        arrowprops={"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.0, "mutation_scale": 7},
    )  # fmt: skip
