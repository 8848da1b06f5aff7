"""A bearing in section, to scale: rings, elements, lines of contact, seats, and what acts on it.

The drawing is a record of outlines in metres; the app writes it as SVG in the colours of its
theme, and a report draws it with Matplotlib.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import acos, cos, hypot, pi, sin, sqrt, tan
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from rolamento.case.profile import Profile
from rolamento.case.roller_bearing import axis_angle
from rolamento.charts.style import MILLIMETRE, in_style
from rolamento.charts.texts import number
from rolamento.contact.profile import drop
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.solved import Solved

__all__ = ["Arrow", "Label", "Outline", "SectionDrawing", "draw_section", "section_drawing"]

Point = tuple[float, float]

_STEEP: Final = 1.3
"""Contact angle (rad) beyond which washers, not rings, lie side by side."""
_FLAT: Final = 0.03
"""Contact angle (rad) below which a line of contact is not drawn to the axis."""
_TOGETHER: Final = 0.9
"""Part of a bearing's width: rows closer than this are in one ring."""
_WALL: Final = 0.79
"""From the pitch circle to bore or outside, over the element's diameter, if unknown."""
_WIDE: Final = 1.42
"""Width over the element's diameter (of a ball) or length (of a roller), if unknown."""
_SHOULDER: Final = 0.3
"""Height of a shoulder above the pitch circle, over the ball's diameter."""
_RELIEVED: Final = 0.47
"""The same of a shoulder that is turned down."""
_EDGE: Final = 0.4
"""Angle (rad) from a contact to the edge of its groove."""
_RIB: Final = 0.2
"""Height of a rib over the roller's diameter, if unknown."""
_SUNK: Final = 0.32
"""From the balls' middles to the face of a grooved washer, over the ball's diameter."""
_ENDS: Final = 0.57
"""Diameter of a barrel roller at its ends, over that in the middle."""
_DEEPEST: Final = 0.05
"""Depth of a profile on the drawing, over the roller's diameter."""
_ARC: Final = 25
_CIRCLE: Final = tuple(
    (cos(a), sin(a)) for a in np.linspace(0.0, 2.0 * pi, 2 * _ARC, endpoint=False).tolist()
)
_LITTLE: Final = 0.01
"""Part of the greatest load below which an element counts as not loaded."""
_TOP, _BOTTOM = 0.0, pi
_SIDES: Final = (1.0, -1.0)
"""Above the axis, and below."""


class Outline(NamedTuple):
    """A closed outline, or a line.

    kind: "shaft", "housing", "ring", "spacer", "element", "loaded" (an element under load),
    "contact", "loaded-contact", "free-contact" or "axis". points: x and height over the axis, m.
    """

    kind: str
    points: tuple[Point, ...]
    closed: bool = True


class Arrow(NamedTuple):
    """What acts: from where to where (m); kind: "load" or "speed". turned: along an arc."""

    kind: str
    points: tuple[Point, ...]


class Label(NamedTuple):
    """A text at a place (m). anchor: "start", "middle" or "end"; kind as of what it names."""

    kind: str
    at: Point
    text: str
    anchor: str = "start"


@dataclass(frozen=True)
class SectionDrawing:
    """A bearing in section.

    Attributes
    ----------
    outlines
        back to front
    arrows, labels
        loads, speeds, sizes
    box
        left, bottom, width and height of all of it, m
    letter
        height of its letters, m
    said
        what is drawn, and what acts on it
    remark
        what is drawn, and how
    """

    outlines: tuple[Outline, ...]
    arrows: tuple[Arrow, ...]
    labels: tuple[Label, ...]
    box: tuple[float, float, float, float]
    letter: float
    said: str
    remark: str


def section_drawing(case: Case, solved: Solved | None = None) -> SectionDrawing:
    """Return a bearing in section.

    Parameters
    ----------
    case
        The case: bearing, seats, loads and speeds.
    solved
        Its result, a single case; None, or one without a result, draws the free contact angles.
    """
    found = solved if solved is not None and bool(solved.converged[0]) else None
    return _Drawer(case, found).drawn()


class _Row(NamedTuple):
    """A row on the drawing. way: +1 or -1, how it faces; lean: of a roller's axis (rad)."""

    bearing: Any
    x: float
    way: float
    number: int

    @property
    def size(self) -> float:
        return float(self.bearing.element_diameter)

    @property
    def radius(self) -> float:
        return 0.5 * float(self.bearing.pitch_diameter)

    @property
    def angle(self) -> float:
        return float(self.bearing.contact_angle or 0.0)

    @property
    def kind(self) -> Any:
        return self.bearing.bearing_type

    @property
    def half_angle(self) -> float:
        return float(getattr(self.bearing, "roller_half_angle", None) or 0.0)

    @property
    def lean(self) -> float:
        return -self.way * float(axis_angle(self.bearing)) if self.kind.has_rollers else 0.0

    @property
    def length(self) -> float:
        return float(self.bearing.roller_length or self.bearing.effective_length)


@dataclass
class _Frame:
    """What no load changes: sizes, and the outlines of the bearing and of what is around it.

    behind: by the side of the axis, outlines behind those of the elements, `rolling`.
    """

    bearing: Any
    mounting: Any
    outlines: list[Outline] = field(default_factory=list)
    behind: dict[float, tuple[Outline, ...]] = field(default_factory=dict)
    rolling: dict[float, tuple[Outline, ...]] = field(default_factory=dict)
    deeper: float = 0.0

    def __post_init__(self) -> None:
        bearing, mounting = self.bearing, self.mounting
        self.rows = [
            _Row(one.bearing, float(one.position), float(one.sign), n)
            for n, one in enumerate(bearing.places)
        ]
        elements = [_Row(one.bearing, float(one.position), float(one.sign), n)
                    for n, one in enumerate(bearing.element_rows)]  # fmt: skip
        self.elements = elements
        size = max(one.size for one in elements)
        radius = max(one.radius for one in elements)
        published = bearing.published
        bore = _known("bore", mounting, published)
        outside = _known("outside_diameter", mounting, published)
        width = _known("width", mounting, published)
        self.bore_known, self.outside_known = bore is not None, outside is not None
        self.inside = 0.5 * bore if bore else max(radius - _WALL * size, 0.2 * radius)
        self.outside = 0.5 * outside if outside else radius + _WALL * size
        self.inside = min(self.inside, radius - 0.5 * size * cos(elements[0].angle))
        self.outside = max(self.outside, radius + 0.5 * size * cos(elements[0].angle))
        rolls = max((one.length for one in elements if one.kind.has_rollers), default=size)
        self.washers = elements[0].angle > _STEEP
        guessed = 2.2 * size if self.washers else _WIDE * max(rolls, 0.6 * size)
        self.width = width or guessed
        places = sorted({one.x for one in elements})
        together = min(np.diff(places), default=np.inf) < _TOGETHER * self.width
        if together and not width:
            self.width = max(self.width, places[-1] - places[0] + guessed)
        self.rings = (
            [(0.5 * (places[0] + places[-1]), elements)]
            if together or len(places) == 1
            else [(at, [one for one in elements if one.x == at]) for at in places]
        )
        half = 0.5 * self.width
        self.left = min(at for at, _ in self.rings) - half
        self.right = max(at for at, _ in self.rings) + half
        tall = 2.0 * self.outside
        self.letter = 0.05 * max(tall, 0.55 * (self.right - self.left + tall))
        reach = 0.16 * tall + 0.1 * (self.right - self.left)
        self.ends = (self.left - reach, self.right + reach)
        self.wall = 0.09 * tall
        self._shaft()
        for side in _SIDES:
            self._housing(side)
            for at, rows in self.rings:
                self._bearing(at, rows, side)
            self._spacers(side)
            self.behind[side] = self._taken()
            for row in elements:
                self._element(row, side)
            self.rolling[side] = self._taken()

    def _taken(self) -> tuple[Outline, ...]:
        taken, self.outlines = tuple(self.outlines), []
        return taken

    def _add(self, kind: str, points: Sequence[Point], side: float) -> None:
        self.outlines.append(Outline(kind, _on_side(points, side)))

    def _box(self, kind: str, left: float, right: float, low: float, high: float,
             side: float) -> None:  # fmt: skip
        self._add(kind, ((left, low), (left, high), (right, high), (right, low)), side)

    def _shaft(self) -> None:
        hollow = 0.5 * float(getattr(self.mounting, "shaft_bore", 0.0) or 0.0)
        hollow = min(hollow, 0.9 * self.inside)
        if hollow:
            for side in _SIDES:
                self._box("shaft", *self.ends, hollow, self.inside, side)
        else:
            self._box("shaft", *self.ends, -self.inside, self.inside, 1.0)

    def _housing(self, side: float) -> None:
        over = 0.12 * self.width
        self._box("housing", self.left - over, self.right + over, self.outside,
                  self.outside + self.wall, side)  # fmt: skip

    def _spacers(self, side: float) -> None:
        """Sleeves between the rings of bearings that stand apart."""
        row = self.elements[0]
        for (first, _), (second, _) in zip(self.rings, self.rings[1:], strict=False):
            start, end = first + 0.5 * self.width, second - 0.5 * self.width
            if end - start > 1e-6:
                low = self.inside + 0.6 * (row.radius - 0.3 * row.size - self.inside)
                high = self.outside - 0.6 * (self.outside - row.radius - 0.3 * row.size)
                self._box("spacer", start, end, self.inside, low, side)
                self._box("spacer", start, end, high, self.outside, side)

    def _bearing(self, at: float, rows: Sequence[_Row], side: float) -> None:
        left, right = at - 0.5 * self.width, at + 0.5 * self.width
        if self.washers:
            self._washers(rows[0], left, right, side)
            return
        ordered = sorted(rows, key=lambda one: one.x)
        outer = [point for row in ordered for point in self._outer_race(row, at, left, right)]
        inner = [point for row in ordered for point in self._inner_race(row, left, right)]
        outer = [(x, min(max(y, 0.0), self.outside)) for x, y in outer]
        inner = [(x, max(y, self.inside)) for x, y in inner]
        self._add("ring", [(left, self.outside), (left, outer[0][1]), *outer,
                           (right, outer[-1][1]), (right, self.outside)], side)  # fmt: skip
        self._add("ring", [(left, self.inside), (left, inner[0][1]), *inner,
                           (right, inner[-1][1]), (right, self.inside)], side)  # fmt: skip

    def _outer_race(self, row: _Row, at: float, left: float, right: float) -> list[Point]:
        kind, size = row.kind, row.size
        if kind.aligns or self.bearing.listed_type.aligns:  # a sphere about the middle
            ball = not kind.has_rollers
            away = 0.5 * size
            x = row.x + row.way * away * sin(row.angle) - at
            radius = hypot(row.radius + away * cos(row.angle), x)
            spread = 0.5 * (row.length if not ball else size)
            low, high = (left, at) if row.x < at else (at, right)
            if abs(row.x - at) < 0.1 * spread:
                low, high = left, right
            return [(float(u), sqrt(max(radius**2 - (float(u) - at) ** 2, 0.0)))
                    for u in np.linspace(low, high, _ARC)]  # fmt: skip
        if not kind.has_rollers:
            conformity = float(row.bearing.outer_conformity or 0.52)
            return _groove(row, conformity, way=row.way, outer=True)
        return self._roller_race(row, outer=True, ends=(left, right))

    def _inner_race(self, row: _Row, left: float, right: float) -> list[Point]:
        if not row.kind.has_rollers:
            conformity = float(row.bearing.inner_conformity or 0.52)
            return _groove(row, conformity, way=-row.way, outer=False)
        return self._roller_race(row, outer=False, ends=(left, right))

    def _roller_race(self, row: _Row, *, outer: bool, ends: Point) -> list[Point]:
        """The race under a roller, and the ribs that hold it."""
        side = 1.0 if outer else -1.0
        line = sorted(_turned(row, _halves(row), side))
        if row.kind.barrels:
            return line
        ribs = str(getattr(row.bearing, "outer_ribs" if outer else "inner_ribs", "none"))
        height = 2.0 * float(getattr(row.bearing, "rib_height", None) or 0.5 * _RIB * row.size)
        gap = 0.02 * row.length
        slope = (line[-1][1] - line[0][1]) / max(line[-1][0] - line[0][0], 1e-12)
        found: list[Point] = list(line)
        for end, mark, first in (
            (line[0], "-" if row.way > 0.0 else "+", True),
            (line[-1], "+" if row.way > 0.0 else "-", False),
        ):
            x = end[0] - gap if first else end[0] + gap
            edge = ends[0] if first else ends[1]
            flat = end[1] + slope * (x - end[0])
            if ribs in (mark, "both"):
                step = [(x, flat), (x, flat - side * height)]
            else:
                step = [(edge, end[1] + slope * (edge - end[0]))]
            found = [*reversed(step), *found] if first else [*found, *step]
        return found

    def _washers(self, row: _Row, left: float, right: float, side: float) -> None:
        """Two washers face to face: with a groove for balls, a rib behind cones."""
        for face, toward in ((left, -1.0), (right, 1.0)):
            race = self._washer_race(row, toward)
            points = [(face, self.inside), (face, self.outside), *race]
            self._add("ring", points, side)

    def _washer_race(self, row: _Row, toward: float) -> list[Point]:
        """The face of a washer from outside to inside; toward: its side of the rollers along x."""
        if not row.kind.has_rollers:
            inner, opening = row.x + toward * _SUNK * row.size, acos(2.0 * _SUNK)
            groove = [
                (row.x + toward * 0.5 * row.size * cos(a), row.radius + 0.5 * row.size * sin(a))
                for a in np.linspace(opening, -opening, _ARC).tolist()
            ]
            return [(inner, self.outside), *groove, (inner, self.inside)]
        ends = _turned(row, _halves(row), toward * row.way)
        (x_in, r_in), (x_out, r_out) = sorted((ends[0], ends[-1]), key=lambda point: point[1])
        slope = (x_out - x_in) / (r_out - r_in)
        inside = (x_in + slope * (self.inside - r_in), self.inside)
        if not (row.kind.conical and toward * row.way < 0.0):
            return [(x_out + slope * (self.outside - r_out), self.outside), inside]
        foot, rib = r_out + 0.02 * row.length, x_out - toward * _RIB * row.size
        return [(rib, self.outside), (rib, foot), (x_out + slope * (foot - r_out), foot), inside]

    def _element(self, row: _Row, side: float) -> None:
        if not row.kind.has_rollers:
            half, radius = 0.5 * row.size, row.radius
            circle = [(row.x + half * x, radius + half * y) for x, y in _CIRCLE]
            self._add("element", circle, side)
            return
        halves, self.deeper = _profiled(row)
        above, below = _turned(row, halves, 1.0), _turned(row, halves, -1.0)
        self._add("element", [*above, *reversed(below)], side)


@lru_cache(maxsize=64)
def _frame(bearing: Any, mounting: Any, given: frozenset[str]) -> _Frame:
    """Drawn once, while loads and speeds of a case change.

    given: the user's own fields, which bearings that are equal may differ in.
    """
    return _Frame(bearing, mounting)


@dataclass
class _Drawer:
    """Gathers a drawing."""

    case: Case
    solved: Solved | None
    outlines: list[Outline] = field(default_factory=list)
    arrows: list[Arrow] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def __post_init__(self) -> None:
        bearing = self.case.bearing
        self.frame = _frame(bearing, self.case.mounting, frozenset(bearing.model_fields_set))
        self.near = {
            (row.number, side): self._nearest(row, side)
            for row in self.frame.elements
            for side in _SIDES
        }

    def drawn(self) -> SectionDrawing:
        """Draw everything."""
        frame, letter, ends = self.frame, self.frame.letter, self.frame.ends
        for side in _SIDES:
            self.outlines += frame.behind[side]
            for row, outline in zip(frame.elements, frame.rolling[side], strict=True):
                loaded = self._load(row, side) > 0.0
                self.outlines.append(outline._replace(kind="loaded") if loaded else outline)
            for row in frame.elements:
                self._contact(row, side)
        axis = (ends[0] - 0.5 * letter, ends[1] + 0.5 * letter)
        self.outlines.append(Outline("axis", ((axis[0], 0.0), (axis[1], 0.0)), closed=False))
        self._acting(ends, letter)
        self._sizes(letter)
        low, high = ends[0] - 7.4 * letter, ends[1] + 7.6 * letter
        bottom = -frame.outside - frame.wall - 0.4 * letter
        box = (low, bottom, high - low, -2.0 * bottom)
        return SectionDrawing(
            tuple(self.outlines), tuple(self.arrows), tuple(self.labels), box, letter,
            self._sentence(self._remark()), " ".join(self._remark()),
        )  # fmt: skip

    def _line(self, kind: str, points: Sequence[Point], side: float) -> None:
        self.outlines.append(Outline(kind, _on_side(points, side), closed=False))

    def _nearest(self, row: _Row, side: float) -> int | None:
        """The element of a row that is nearest the top, or the bottom."""
        if self.solved is None:
            return None
        elements = self.solved.elements
        own = np.flatnonzero(np.asarray(elements.row) == row.number)
        if not own.size:
            return None
        azimuth = np.asarray(elements.azimuth[0])[own]
        away = np.abs(np.angle(np.exp(1j * (azimuth - (_TOP if side > 0.0 else _BOTTOM)))))
        return int(own[int(np.argmin(away))])

    def _load(self, row: _Row, side: float) -> float:
        place = self.near[row.number, side]
        if place is None or self.solved is None:
            return 0.0
        load = self.solved.inner.load[0]
        return float(load[place]) if load[place] > _LITTLE * load.max() else 0.0

    def _angles(self, row: _Row, side: float) -> tuple[float, float, bool]:
        """Contact angles of the inner and outer race, and whether they are those under load."""
        place = self.near[row.number, side]
        if place is None or self.solved is None or not self._load(row, side) > 0.0:
            return row.angle, row.angle, False
        found = [float(one.contact_angle[0, place])
                 for one in (self.solved.inner, self.solved.outer)]  # fmt: skip
        if not np.isfinite(found).all():
            return row.angle, row.angle, False
        return found[0], found[1], True

    def _contact(self, row: _Row, side: float) -> None:
        """The line of contact; to the axis where it is inclined, to show where rows lean."""
        inner, outer, loaded = self._angles(row, side)
        kind = "loaded-contact" if loaded else "free-contact"
        x, y, half = row.x, row.radius, 0.5 * row.size
        ends = [(x - row.way * half * sin(inner), y - half * cos(inner)), (x, y),
                (x + row.way * half * sin(outer), y + half * cos(outer))]  # fmt: skip
        angle = row.angle
        if _FLAT < angle <= _STEEP:
            apex = (x - row.way * y * tan(angle), 0.0)
            far = (x + row.way * (self.frame.outside - y) * tan(angle), self.frame.outside)
            self._line("contact", (apex, far), side)
        self._line(kind, ends, side)

    # --- what acts, and what it measures ----------------------------------------------------------

    def _acting(self, ends: Point, letter: float) -> None:
        """Loads and speeds; forces that the shaft puts on the inner ring."""
        frame, duty = self.frame, self.case.duty
        load = duty.load
        forces = {name: float(getattr(load, name) or 0.0) for name in ("fx", "fy", "fz")}
        middle = 0.5 * (frame.left + frame.right)
        reach = min(max(2.4 * letter, 0.62 * frame.inside), 0.85 * frame.inside)
        if forces["fz"]:
            up = 1.0 if forces["fz"] > 0.0 else -1.0
            self.arrows.append(Arrow("load", ((middle, 0.0), (middle, up * reach))))
            self._label("load", (middle + 0.4 * letter, up * (0.5 * reach)),
                        f"Fz {_newtons(forces['fz'])}")  # fmt: skip
        if forces["fy"]:
            size = 0.45 * letter
            at = (middle - 1.6 * letter, 0.45 * letter)
            turn = np.linspace(0.0, 2.0 * pi, _ARC).tolist()
            ring = tuple((at[0] + size * cos(a), at[1] + size * sin(a)) for a in turn)
            self.outlines.append(Outline("mark", ring))
            self._label("load", (at[0] - 0.7 * letter, at[1]), f"Fy {_newtons(forces['fy'])}",
                        "end")  # fmt: skip
        if forces["fx"]:
            start, end = ends[1] + 0.6 * letter, ends[1] + 3.4 * letter
            points = ((start, 0.0), (end, 0.0))
            self.arrows.append(Arrow("load", points if forces["fx"] > 0.0 else points[::-1]))
            self._label("load", (start, 0.75 * letter), f"Fx {_newtons(forces['fx'])}")
        moments = [f"{name.capitalize()} {number(float(getattr(load, name)), 3)} N·m"
                   for name in ("my", "mz") if getattr(load, name, None)]  # fmt: skip
        for place, text in enumerate(moments):
            self._label("load", (ends[1] + 0.6 * letter, -(1.1 + 1.25 * place) * letter), text)
        speed = duty.inner_speed
        if speed:
            self._turning(ends[0] + 0.35 * letter, letter, float(speed))
            self._label("speed", (ends[0] - 0.9 * letter, 0.75 * letter), _turns(float(speed)),
                        "end")  # fmt: skip
        if duty.outer_speed:
            at = (frame.left - 1.2 * letter, frame.outside - 0.2 * letter)
            self._label("speed", at, _turns(float(duty.outer_speed)), "end")

    def _turning(self, x: float, letter: float, speed: float) -> None:
        """An arc about the axis, with a head: how the shaft turns."""
        tall, wide = 0.55 * self.frame.inside, 0.9 * letter
        turn = np.linspace(-0.42 * pi, 0.42 * pi, _ARC)
        points = [(x - wide * cos(a), tall * sin(a)) for a in turn.tolist()]
        self.arrows.append(Arrow("speed", tuple(points if speed > 0.0 else points[::-1])))

    def _sizes(self, letter: float) -> None:
        """Bore and outside diameter with their tolerances, and the contact angle."""
        frame, mounting = self.frame, self.case.mounting
        x = frame.right + 0.12 * frame.width + 0.5 * letter
        if frame.outside_known:
            text = f"⌀{number(2e3 * frame.outside, 4)}"
            fit = getattr(mounting, "housing_tolerance", None)
            self._label("size", (x, frame.outside - 0.3 * letter), f"{text} {fit or ''}".strip())
        if frame.bore_known:
            text = f"⌀{number(2e3 * frame.inside, 4)}"
            fit = getattr(mounting, "shaft_tolerance", None)
            self._label("size", (x, frame.inside + 0.75 * letter), f"{text} {fit or ''}".strip())
        row = frame.elements[-1]
        _, outer, loaded = self._angles(row, 1.0)
        angle = outer if loaded else row.angle
        if not row.kind.has_rollers and (loaded or angle > _FLAT):
            text = f"α {number(float(np.degrees(angle)), 3)}°"
            self._label("angle", (x, row.radius + 0.2 * letter), text)

    def _label(self, kind: str, at: Point, text: str, anchor: str = "start") -> None:
        self.labels.append(Label(kind, at, text, anchor))

    def _remark(self) -> list[str]:
        """Return what is drawn, and how."""
        parts = [said("The bearing in section, to scale.")]
        if not self.frame.outside_known:
            parts.append(said("Sizes of its rings are not known: they are drawn as usual."))
        if self.frame.deeper:
            text = said("The profile of the rollers is drawn {times} times as deep.",
                        times=number(self.frame.deeper, 2))  # fmt: skip
            parts.append(text)
        arranged = getattr(self.case.bearing, "arrangement", None)
        if arranged:
            parts.append(said("Arrangement {name}.", name=arranged))
        return parts

    def _sentence(self, remark: Sequence[str]) -> str:
        """Return what is drawn, and what acts on it."""
        acting = [f"{one.text}." for one in self.labels if one.kind in ("load", "speed")]
        return " ".join([*remark, *acting])


def _on_side(points: Sequence[Point], side: float) -> tuple[Point, ...]:
    return tuple((x, side * y) for x, y in points)


def _known(name: str, *records: Any) -> float | None:
    for one in records:
        value = getattr(one, name, None)
        if value and np.isfinite(value):
            return float(value)
    return None


def _newtons(force: float) -> str:
    return f"{number(1e-3 * force, 3)} kN" if abs(force) >= 1e3 else f"{number(force, 3)} N"


def _turns(speed: float) -> str:
    return f"{number(speed * 30.0 / pi, 4)} rpm"


def _groove(row: _Row, conformity: float, *, way: float, outer: bool) -> list[Point]:
    """The groove of a ring, from its left shoulder to its right one."""
    side = 1.0 if outer else -1.0
    radius = max(conformity, 0.5) * row.size
    angle = 0.0 if row.bearing.bearing_type.has_arches else row.angle
    off = radius - 0.5 * row.size
    centre = (row.x - way * off * sin(angle), row.radius - side * off * cos(angle))
    usual = _SHOULDER * row.size
    high = min(usual, 0.5 * row.size * cos(min(angle + _EDGE, 1.45)))
    low = _RELIEVED * row.size if angle > 0.2 else usual
    heights = (low, high) if way > 0.0 else (high, low)
    edges = []
    for height, toward in zip(heights, (-1.0, 1.0), strict=True):
        up = side * (row.radius + side * height - centre[1]) / radius
        edges.append(toward * acos(min(max(up, -1.0), 1.0)))
    return [
        (centre[0] + radius * sin(a), centre[1] + side * radius * cos(a))
        for a in np.linspace(edges[0], edges[1], _ARC).tolist()
    ]


def _halves(row: _Row) -> list[Point]:
    """Places along a roller, and half its diameter there."""
    length, half = row.length, 0.5 * row.size
    along = np.linspace(-0.5, 0.5, _ARC if row.kind.barrels else 2) * length
    if row.kind.barrels:
        shape = half * (1.0 - (1.0 - _ENDS) * 0.35 * (2.0 * along / length) ** 2)
    else:
        shape = half - row.way * tan(row.half_angle) * along
    return [(float(u), float(v)) for u, v in zip(along, shape, strict=True)]


def _profiled(row: _Row) -> tuple[list[Point], float]:
    """The same with the roller's profile, and how many times as deep it is drawn."""
    profile = getattr(row.bearing, "roller_profile", None)
    if row.kind.barrels or not isinstance(profile, Profile):
        return _halves(row), 0.0
    (first, _), (last, _) = (_halves(row)[0], _halves(row)[-1])
    half = 0.5 * row.length
    effective = min(0.5 * float(row.bearing.effective_length or row.length), half)
    place = np.linspace(-0.999, 0.999, 2 * _ARC + 1) * effective
    depth = drop(profile, place, length=2.0 * effective, diameter=row.size,
                 tapered=row.kind.crowned_whole)  # fmt: skip
    depth = np.where(np.isfinite(depth), depth, 0.0)
    deepest = float(depth.max())
    if not deepest > 0.0:
        return _halves(row), 0.0
    times = _rounded(_DEEPEST * row.size / deepest)
    taper = row.way * tan(row.half_angle)
    shape = [(float(u), 0.5 * row.size - taper * float(u) - times * float(d))
             for u, d in zip(place, depth, strict=True)]  # fmt: skip
    lowest = _DEEPEST * row.size
    ends = [(float(u), 0.5 * row.size - taper * float(u) - 1.3 * lowest) for u in (first, last)]
    return [ends[0], *shape, ends[1]], times


def _rounded(value: float) -> float:
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(one * power for one in (5.0, 2.0, 1.0) if one * power <= value * 1.000001))


def _turned(row: _Row, halves: Sequence[Point], side: float) -> list[Point]:
    """Points of a roller, given along its own axis and across it, on one side of the axis."""
    c, s, radius = cos(row.lean), sin(row.lean), row.radius
    return [(row.x + u * c - side * v * s, radius + u * s + side * v * c) for u, v in halves]


# --- with Matplotlib ------------------------------------------------------------------------------

_LOOKS: Final[dict[str, dict[str, Any]]] = {
    "shaft": {"facecolor": "#E4E8EB", "edgecolor": "#5C6770", "linewidth": 0.6},
    "housing": {"facecolor": "#FFFFFF", "edgecolor": "#8A949B", "linewidth": 0.5,
                "hatch": "//////"},
    "ring": {"facecolor": "#B9C8D6", "edgecolor": "#1B2126", "linewidth": 0.8},
    "spacer": {"facecolor": "#DDE3E8", "edgecolor": "#5C6770", "linewidth": 0.6},
    "element": {"facecolor": "#F7F9FB", "edgecolor": "#1B2126", "linewidth": 0.8},
    "loaded": {"facecolor": "#BFE0E8", "edgecolor": "#1B2126", "linewidth": 0.8},
    "mark": {"facecolor": "#FFFFFF", "edgecolor": "#8A3A6B", "linewidth": 1.0},
    "contact": {"edgecolor": "#C04F00", "linewidth": 0.7, "linestyle": (0, (5, 3))},
    "loaded-contact": {"edgecolor": "#C04F00", "linewidth": 1.4},
    "free-contact": {"edgecolor": "#C04F00", "linewidth": 0.9},
    "axis": {"edgecolor": "#5C6770", "linewidth": 0.6, "linestyle": (0, (9, 2, 1, 2))},
}  # fmt: skip
_ACTS: Final = {"load": "#8A3A6B", "speed": "#0B6175", "size": "#1B2126", "angle": "#C04F00"}


@in_style
def draw_section(drawing: SectionDrawing, *, width: float = 105.0, most: float = 78.0) -> Figure:
    """Draw a bearing in section on paper.

    Parameters
    ----------
    drawing
        Of `section_drawing`.
    width, most
        Greatest width and height, mm.
    """
    left, bottom, wide, tall = drawing.box
    scale = min(width / wide, most / tall)
    figure = Figure(figsize=(scale * wide * MILLIMETRE, scale * tall * MILLIMETRE))
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    for depth, one in enumerate(drawing.outlines):
        look = {"facecolor": "none", **_LOOKS[one.kind], "zorder": 2.0 + 0.001 * depth}
        codes = [Path.MOVETO, *[Path.LINETO] * (len(one.points) - 1)]
        points = list(one.points)
        if one.closed:
            points.append(points[0])
            codes.append(Path.CLOSEPOLY)
        axes.add_patch(PathPatch(Path(points, codes), **look))
    for arrow in drawing.arrows:
        colour = _ACTS[arrow.kind]
        x, y = zip(*arrow.points, strict=True)
        axes.plot(x[:-1] if len(x) > 2 else x, y[:-1] if len(x) > 2 else y, color=colour,
                  linewidth=1.6, zorder=6)  # fmt: skip
        axes.annotate("", arrow.points[-1], xytext=arrow.points[-2], zorder=6,
                      arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.6,
                                  "shrinkA": 0, "shrinkB": 0, "mutation_scale": 9})  # fmt: skip
    size = max(scale * drawing.letter * MILLIMETRE * 72.0 * 0.95, 5.0)
    for label in drawing.labels:
        aligned = {"start": "left", "middle": "center", "end": "right"}[label.anchor]
        halo = {"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.75}
        axes.text(*label.at, label.text, color=_ACTS[label.kind], ha=aligned, va="center",
                  fontsize=size, parse_math=False, zorder=8, bbox=halo)  # fmt: skip
    axes.set_xlim(left, left + wide)
    axes.set_ylim(bottom, bottom + tall)
    axes.set_aspect("equal")
    return figure
