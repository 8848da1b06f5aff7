"""A picture as a record: what is drawn, on which axes, and what it says.

A chart knows no medium: `rolamento.charts.drawing` draws it with Matplotlib, and
`rolamento.charts.plotly` writes it for the page. Its numbers are in the units that people read.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.charts.axes_units import DEGREE, NONE
from rolamento.charts.courses import courses
from rolamento.charts.palette import Look
from rolamento.charts.texts import number
from rolamento.records import frozen
from rolamento.words import said

__all__ = [
    "Arrows", "Axis", "Bars", "Chart", "Ellipses", "Field", "Labels", "Line", "Mark", "Spread",
    "Zone", "key", "nothing", "once", "step_line", "widened",
]  # fmt: skip

Floats = NDArray[np.float64]
Form = Literal["line", "points", "both", "sparse"]
Side = Literal["left", "right", "above", "on", "along"]
"""Where it stands by its point; "along" a line that stands there, on its left, upright on paper."""

BREAK: Final = "//"
"""The break mark of a bar that goes beyond its axis."""
FAINT: Final = 0.35
"""Opacity of what is shown though it does not hold."""


@frozen
class Axis:
    """An axis.

    Attributes
    ----------
    name
        of the quantity
    unit
        its symbol
    limits
        where it begins and ends; by default as its numbers need
    log
        whether it is logarithmic
    zero
        whether it begins at zero, where nothing is below
    least
        how far its ends are apart at least
    ticks
        where numbers stand, and what is written there
    categories
        names, downward, of what has no numbers; its places count from 0
    step
        from number to number, on a logarithmic axis in decades; 0 as the renderer likes
    equal
        whether it has the scale of the other axis
    hidden
        whether it is left out
    whole
        whether only whole numbers stand along it
    label
        written along it, where that is not its name with its unit
    """

    name: str = ""
    unit: str = NONE.symbol
    limits: tuple[float, float] | None = None
    log: bool = False
    zero: bool = False
    least: float = 0.0
    ticks: tuple[tuple[float, str], ...] = ()
    categories: tuple[str, ...] = ()
    step: float = 0.0
    equal: bool = False
    hidden: bool = False
    whole: bool = False
    label: str = ""

    @property
    def title(self) -> str:
        """What is written along the axis."""
        bare = self.unit in ("", NONE.symbol) or not self.name
        return self.label or (self.name if bare else f"{self.name} ({self.unit})")

    def with_unit(self, number: str) -> str:
        """Return a number with the unit of the axis."""
        if self.unit in ("", NONE.symbol):
            return number
        return f"{number}{'' if self.unit == DEGREE.symbol else ' '}{self.unit}"


@frozen(eq=False)
class Line:
    """A line or points; around a polar frame ``x`` are azimuths (°), ``y`` radii.

    Attributes
    ----------
    x, y
        in the units of the axes, (points,); NaN leaves a gap
    name
        in the legend; empty: not in it
    look
        how it is drawn
    form
        "line", "points", "both", or "sparse": a line with a mark here and there
    wrapped
        how many points of its beginning and of its end stand there once more
    filled
        whether it is the outline of a body
    texts
        of the points, where they are looked at
    valid
        where it holds, (points,); elsewhere it is faint
    height
        part of the height of the frame at which all of it stands, whatever y; 0 is its foot
    """

    x: Floats
    y: Floats
    name: str
    look: Look
    form: Form = "line"
    wrapped: tuple[int, int] = (0, 0)
    filled: bool = False
    texts: tuple[str, ...] = ()
    valid: NDArray[np.bool_] | None = None
    height: float | None = None

    @property
    def on_the_scale(self) -> bool:
        """Whether its points are numbers of both axes: not an outline, nor at a fixed height."""
        return self.height is None and not self.filled


@frozen(eq=False)
class Spread:
    """What lies between two lines, faintly filled; hatched where it is a body; or wholly."""

    x: Floats
    low: Floats
    high: Floats
    name: str
    look: Look
    hatched: bool = False
    solid: bool = False


@frozen(eq=False)
class Bars:
    """Bars that lie, beside categories of the upright axis.

    Attributes
    ----------
    values
        where they end, (bars,); one beyond the end of its axis, as an infinite one, fills the frame
        and has a break mark there
    start
        where they begin, (bars,), then each alone in its place; by default at zero, beside or on
        one another
    places
        to which categories they belong, (bars,)
    name, look
        as of a line
    texts
        what stands at them; by default nothing
    valid
        which hold, (bars,); others are faint
    """

    values: Floats
    places: tuple[int, ...]
    name: str
    look: Look
    texts: tuple[str, ...] = ()
    valid: tuple[bool, ...] = ()
    start: Floats | None = None

    def reading(self, across: Axis, upright: Axis) -> str:
        """Return its longest bar; empty without one that is finite."""
        if not np.isfinite(self.values).any():
            return ""
        one = int(np.nanargmax(np.where(np.isfinite(self.values), self.values, np.nan)))
        value = across.with_unit(number(float(self.values[one]), 3))
        place = upright.categories[self.places[one]]
        what = ", ".join(filter(None, (across.name, self.name))) or across.title
        return said("{what}, highest: {value} ({place})", what=what, value=value, place=place)


@frozen
class Mark:
    """A straight line through the whole frame, at a number of one axis."""

    at: float
    name: str
    look: Look
    axis: Literal["x", "y"] = "y"


@frozen
class Zone:
    """A band through the whole frame, from one number of an axis to another; infinite: its end."""

    low: float
    high: float
    name: str
    color: str
    axis: Literal["x", "y"] = "y"


@frozen(eq=False)
class Ellipses:
    """Ellipses that lie across the frame, (ellipses,) each.

    Attributes
    ----------
    x, y
        their centres
    half_width, half_height
        their semi-axes
    name, look
        as of a line
    filled
        whether they are bodies, not outlines
    hatched
        whether they are hatched
    """

    x: Floats
    y: Floats
    half_width: Floats
    half_height: Floats
    name: str
    look: Look
    filled: bool = True
    hatched: bool = False


@frozen(eq=False)
class Labels:
    """Words in the frame.

    Attributes
    ----------
    x, y
        their points
    texts
        what stands there
    sides
        on which side of its point each stands
    color
        a name of the palette
    height
        as of a line
    """

    x: Floats
    y: Floats
    texts: tuple[str, ...]
    sides: tuple[Side, ...]
    color: str = "ink"
    height: float | None = None


@frozen(eq=False)
class Field:
    """Numbers over the frame, as colours: of cells, or in bands between levels.

    Attributes
    ----------
    x, y
        lines between cells, (columns + 1,), (rows + 1,); or points, (rows, columns) each
    values
        (rows, columns); a cell of NaN is hatched
    scale
        what the colours stand for
    steps
        how many colours at most
    signed
        whether zero is in the middle of the colours
    missing
        what hatched cells are called
    """

    x: Floats
    y: Floats
    values: Floats
    scale: Axis
    steps: int = 9
    signed: bool = False
    missing: str = ""

    def reading(self, across: Axis, upright: Axis) -> str:
        """Return its range, and where the highest of its numbers stands."""
        if not np.isfinite(self.values).any():
            return ""
        top = np.unravel_index(int(np.nanargmax(self.values)), self.values.shape)
        x, y = self.x, self.y
        if x.ndim == 1:  # lines between cells
            x, y = np.meshgrid(0.5 * (x[:-1] + x[1:]), 0.5 * (y[:-1] + y[1:]))
        low, high = (self.scale.with_unit(number(float(found(self.values)), 3))
                     for found in (np.nanmin, np.nanmax))  # fmt: skip
        what = self.scale.name or self.scale.title
        if low == high:
            return said("{what} stays at {value}", what=what, value=low)
        return said(
            "{what} from {low} to {high}, highest at {x}, {y}", what=what, low=low, high=high,
            x=across.with_unit(number(float(x[top]) + 0.0, 3)),
            y=upright.with_unit(number(float(y[top]) + 0.0, 3)),
        )  # fmt: skip


@frozen(eq=False)
class Arrows:
    """Directions at points, all of one length, (arrows,) each; on colours, thus white."""

    x: Floats
    y: Floats
    across: Floats
    along: Floats


Series = Line | Spread | Bars | Ellipses | Labels | Field | Arrows


@frozen(eq=False)
class Chart:
    """A picture.

    Attributes
    ----------
    series
        what is drawn; nothing where there is nothing to draw, as the conclusion says
    x, y
        its axes; of a polar one its azimuth, and its radius
    conclusion
        what it says, in a line
    title
        what it shows
    marks, zones
        straight lines, and bands below all
    polar
        whether it is a rosette: 0° at the top, clockwise
    numbers_at
        azimuth (°) at which the numbers of its circles stand
    stacked
        whether bars of a place stand on one another, not beside
    outlines
        whether its lines are outlines of bodies: a table of their points says nothing
    over_names
        what stands over the names of its series
    symbols
        whether single letters with an index are symbols, and set as such
    """

    series: tuple[Series, ...]
    x: Axis = Axis()
    y: Axis = Axis()
    conclusion: str = ""
    title: str = ""
    marks: tuple[Mark, ...] = ()
    zones: tuple[Zone, ...] = ()
    polar: bool = False
    numbers_at: float = 0.0
    stacked: bool = False
    outlines: bool = False
    over_names: str = ""
    symbols: bool = False

    @property
    def says(self) -> str:
        """What it says, in a line: its conclusion; without one what its own numbers show."""
        if self.conclusion or self.outlines or self.stacked:
            return self.conclusion
        wide = [one for one in self.series if isinstance(one, Field | Bars)]
        if wide:  # lines lie over them
            return "; ".join(filter(None, (one.reading(self.x, self.y) for one in wide)))
        drawn = [(one.name, one.x, one.y) for one in self.lines if one.on_the_scale]
        return courses(drawn, self.x, self.y) or (said("No result") if drawn else "")

    @property
    def shows(self) -> str:
        """What it shows: its title; without one by its axes."""
        up, across = self.y.title, self.x.title
        if self.title or not (self.series and up and across) or self.polar:
            return self.title
        return said("{what} over {field}.", what=up, field=across).rstrip(".")

    def where_faint(self, text: str) -> Chart:
        """Return it with a text over the names of its series, if some of them are faint."""
        faint = any(line.valid is not None and not line.valid.all() for line in self.lines)
        return replace(self, over_names=text) if faint else self

    @property
    def lines(self) -> tuple[Line, ...]:
        """Its series that are lines or points."""
        return tuple(one for one in self.series if isinstance(one, Line))


def nothing(why: str) -> Chart:
    """Return a chart without anything, that says why."""
    return Chart((), conclusion=why)


def key(name: str, look: Look, form: Form = "line") -> Line:
    """Return a line without points, for its name among those of a chart."""
    return Line(np.array([np.nan]), np.array([np.nan]), name, look, form)


def once(series: Iterable[Line]) -> tuple[Line, ...]:
    """Return lines of which each name stands but once, with the first that has it."""
    names: set[str] = set()
    kept: list[Line] = []
    for one in series:
        kept.append(replace(one, name="") if one.name in names else one)
        names.add(one.name)
    return tuple(kept)


def step_line(edges: ArrayLike, values: ArrayLike) -> tuple[Floats, Floats]:
    """Return the outline of steps from edge to edge, (edges,), down to zero at both ends.

    >>> step_line([0.0, 1.0, 2.0], [3.0, 4.0])[1].tolist()
    [0.0, 3.0, 3.0, 4.0, 4.0, 0.0]
    """
    upright = np.asarray(values, dtype=np.float64)
    return np.repeat(edges, 2), np.concatenate([[0.0], np.repeat(upright, 2), [0.0]])


def widened(where: ArrayLike) -> NDArray[np.bool_]:
    """Reach from points to their neighbours before, so that the pieces of a line meet."""
    some = np.asarray(where, dtype=np.bool_)
    return np.asarray(some | np.append(some[1:], False)) if some.any() else some
