"""A picture as a record: what is drawn, on which axes, and what it says.

A chart knows no medium: `rolamento.charts.drawing` draws it with Matplotlib, and
`rolamento.charts.plotly` writes it for the page. Its numbers are in the units that people read.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.charts.axes_units import DEGREE, NONE
from rolamento.charts.palette import Look
from rolamento.records import frozen

__all__ = [
    "Axis", "Bars", "Chart", "Ellipses", "Labels", "Line", "Mark", "Spread", "Zone", "nothing",
    "widened",
]  # fmt: skip

Floats = NDArray[np.float64]
Form = Literal["line", "points", "both"]
Side = Literal["left", "right", "above"]

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
    label: str = ""

    @property
    def title(self) -> str:
        """What is written along the axis."""
        bare = self.unit == NONE.symbol or not self.name
        return self.label or (self.name if bare else f"{self.name} ({self.unit})")

    def with_unit(self, number: str) -> str:
        """Return a number with the unit of the axis."""
        if self.unit == NONE.symbol:
            return number
        return f"{number}{'' if self.unit == DEGREE.symbol else ' '}{self.unit}"


@frozen(eq=False)
class Line:
    """A line or points; around a polar frame ``x`` are azimuths (°), ``y`` radii.

    Attributes
    ----------
    x, y
        in the units of the axes, (points,); NaN leaves a gap, -inf is the foot of the frame
    name
        in the legend; empty: not in it
    look
        how it is drawn
    form
        "line", "points", or "both"
    wrapped
        how many points of its beginning and of its end stand there once more
    filled
        whether it is the outline of a body
    texts
        of the points, where they are looked at
    valid
        where it holds, (points,); elsewhere it is faint
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


@frozen(eq=False)
class Spread:
    """What lies between two lines, faintly filled; hatched where it is a body, on paper."""

    x: Floats
    low: Floats
    high: Floats
    name: str
    look: Look
    hatched: bool = False


@frozen(eq=False)
class Bars:
    """Bars that lie, beside categories of the upright axis.

    Attributes
    ----------
    values
        (bars,); one beyond the end of its axis, as an infinite one, fills the frame and has a
        break mark there
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
    """Words in the frame; sides: on which side of its point each stands."""

    x: Floats
    y: Floats
    texts: tuple[str, ...]
    sides: tuple[Side, ...]


Series = Line | Spread | Bars | Ellipses | Labels


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

    @property
    def alternative(self) -> str:
        """What it shows, for those who cannot see it."""
        return ". ".join(part for part in (self.title, self.conclusion) if part)

    @property
    def lines(self) -> tuple[Line, ...]:
        """Its series that are lines or points."""
        return tuple(one for one in self.series if isinstance(one, Line))


def nothing(why: str) -> Chart:
    """Return a chart without anything, that says why."""
    return Chart((), conclusion=why)


def widened(where: ArrayLike) -> NDArray[np.bool_]:
    """Reach from points to their neighbours before, so that the pieces of a line meet."""
    some = np.asarray(where, dtype=np.bool_)
    return np.asarray(some | np.append(some[1:], False)) if some.any() else some
