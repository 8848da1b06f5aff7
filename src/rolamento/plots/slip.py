"""Maps of a contact ellipse: slip, pressure, and their product, with the lines of pure rolling."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Literal

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rolamento.charts import Arrows, Axis, Chart, Field, Line, Look, nothing, once
from rolamento.charts.axes_units import MEGAPASCAL, MILLIMETRE, ReadableUnit
from rolamento.charts.contacts import refuse_rollers
from rolamento.charts.drawing import draw, figure
from rolamento.charts.texts import no_result, number
from rolamento.friction.slip import (
    Patch,
    RelativeMotion,
    maximum_pressure_slip,
    pressure_share,
    rolling_lines,
    slip_velocity,
    solved_motion,
)
from rolamento.geometry import Race
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.validate import one_of, whole_number
from rolamento.words import said

__all__ = ["QUANTITIES", "Quantity", "slip_chart", "slip_map", "slip_maps"]

Floats = NDArray[np.float64]
Quantity = Literal["slip", "pressure", "pressure_slip"]
QUANTITIES: Final[tuple[Quantity, ...]] = ("slip", "pressure", "pressure_slip")

_GRID: Final = 161
_LEVELS: Final = 24
_ARROWS: Final = (13, 5)
_HEAVIEST: Final = -1

_UNITS: Final[Mapping[str, ReadableUnit]] = {
    "slip": ReadableUnit("m/s", 1.0),
    "pressure": MEGAPASCAL,
    "pressure_slip": ReadableUnit("W/mm²", 1e-6),
}


@frozen
class _Contact:
    """One contact, its patch and motion as arrays of one."""

    patch: Patch
    motion: RelativeMotion

    @property
    def touches(self) -> bool:
        return bool(self.patch.load[0] > 0.0)


def slip_map(
    solved: Solved,
    axes: Axes | None = None,
    *,
    quantity: Quantity = "slip",
    race: Race = "inner",
    ball: int = _HEAVIEST,
) -> Axes:
    """Draw slip, pressure or their product over one contact ellipse, as `slip_chart` has it.

    axes: to draw on, with a colour bar beside them; of a new figure if not given.
    """
    return draw(slip_chart(solved, quantity, race, ball), axes, height=62.0)


def slip_maps(solved: Solved, *, race: Race = "inner", ball: int = _HEAVIEST) -> tuple[Axes, ...]:
    """Draw slip, pressure and their product of one contact below each other, in a new figure.

    Parameters and errors as of `slip_chart`.
    """
    charts = (slip_chart(solved, quantity, race, ball) for quantity in QUANTITIES)
    return tuple(figure(*charts, height=170.0, own=True).axes[: len(QUANTITIES)])


def slip_chart(
    solved: Solved, quantity: Quantity = "slip", race: Race = "inner", ball: int = _HEAVIEST
) -> Chart:
    """Return slip, pressure or their product over one contact ellipse.

    The motion is that of the solved case, by its raceway control. Lines of pure rolling are dashed;
    arrows show how the race slips over the ball; a cross marks the maximum product.

    Parameters
    ----------
    solved
        A single solved case; without a result, a chart that says why.
    quantity
        ``"slip"``, ``"pressure"`` or ``"pressure_slip"``.
    race
        ``"inner"`` or ``"outer"``.
    ball
        Counted from 0; the one with the maximum load on this race if not given.

    Raises
    ------
    InputError
        If this is no ball bearing, there is no such ball, or the quantity is not known.
    """
    one_of(quantity, "quantity", QUANTITIES)
    refuse_rollers(solved)
    if not solved.converged[0]:
        return nothing(no_result(str(solved.status.code[0])))
    contact = _contact(solved, race, ball)
    if not contact.touches:
        return nothing(said("ball and race do not touch"))
    a, b = (
        float(MILLIMETRE.of(x)[0]) for x in (contact.patch.semi_major, contact.patch.semi_minor)
    )
    u = np.linspace(-1.0, 1.0, _GRID)[:, np.newaxis] * np.ones(_GRID)
    v = np.sqrt(1.0 - u**2) * np.linspace(-1.0, 1.0, _GRID)
    unit = _UNITS[quantity]
    values = unit.of(_values(contact, quantity, u, v))
    turn = np.linspace(0.0, 2.0 * np.pi, _GRID)
    edge = Line(a * np.cos(turn), b * np.sin(turn), "", Look("ink", width=0.65))
    series: list[Field | Line | Arrows] = [
        Field(a * u, b * v, values, Axis(_name_of(quantity), unit.symbol), _LEVELS), edge,
    ]  # fmt: skip
    conclusion = ""
    if quantity != "pressure":
        series += _rolling(contact, a, b)
    if quantity == "slip":
        series.append(_arrows(contact, a, b))
    if quantity == "pressure_slip":
        found = maximum_pressure_slip(contact.patch, contact.motion)
        value = f"{number(float(unit.of(found.value[0])))} {unit.symbol}"
        conclusion = said("maximum, {value}", value=value)
        look = Look("white", mark="thin", width=1.4)
        series.append(Line(a * found.across[:1], b * found.along[:1], conclusion, look, "points"))
    return Chart(
        tuple(series),
        Axis(said("Across rolling"), MILLIMETRE.symbol, (-1.05 * a, 1.05 * a)),
        Axis(said("Along rolling"), MILLIMETRE.symbol, (-1.15 * b, 1.15 * b)),
        conclusion,
        _name_of(quantity),
    )


def _contact(solved: Solved, race: Race, ball: int) -> _Contact:
    patch, motion = Patch.of(solved.contacts[race]), solved_motion(solved, race)
    count = patch.load.shape[1]
    if ball == _HEAVIEST:
        ball = int(np.argmax(patch.load[0]))
    whole_number(ball, "ball", 0, count - 1, "0")

    def one(array: Floats) -> Floats:
        return np.asarray(array[0, ball : ball + 1])

    chosen = RelativeMotion(
        one(motion.drift), one(motion.roll), one(motion.twist), one(motion.tumble), motion.side
    )
    return _Contact(patch.mapped(one), chosen)


def _name_of(quantity: Quantity) -> str:
    return {
        "slip": said("Slip"),
        "pressure": said("Pressure"),
        "pressure_slip": said("Pressure times slip"),
    }[quantity]


def _values(contact: _Contact, quantity: Quantity, u: Floats, v: Floats) -> Floats:
    """The quantity in SI on a grid; outside the ellipse it is not shown."""
    pressure = np.asarray(pressure_share(u, v) * contact.patch.max_pressure[0])
    if quantity == "pressure":
        return pressure
    slip = slip_velocity(contact.patch, contact.motion, u.ravel(), v.ravel())
    speed = np.asarray(slip.speed[0].reshape(u.shape))
    return speed if quantity == "slip" else np.asarray(speed * pressure)


def _rolling(contact: _Contact, a: float, b: float) -> list[Line]:
    """Return lines along which nothing slips along rolling."""
    lines = rolling_lines(contact.patch, contact.motion)[0]
    look = Look("white", "dash", width=0.8)
    reach = b * np.sqrt(1.0 - np.square(lines))
    found = [
        Line(np.full(2, a * line), np.array([-end, end]), said("no slip along rolling"), look)
        for line, end in zip(lines, reach, strict=True)
        if np.isfinite(line)
    ]
    return list(once(found))


def _arrows(contact: _Contact, a: float, b: float) -> Arrows:
    """Return the direction of the slip at some points."""
    across, along = (np.linspace(-0.9, 0.9, count) for count in _ARROWS)
    u, v = (array.ravel() for array in np.meshgrid(across, along, indexing="ij"))
    inside = u**2 + v**2 < 0.95
    u, v = u[inside], v[inside]
    slip = slip_velocity(contact.patch, contact.motion, u, v)
    return Arrows(a * u, b * v, slip.transverse[0], slip.rolling[0])
