"""Maps of a contact ellipse: slip, pressure, and their product, with the lines of pure rolling."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Ellipse
from numpy.typing import NDArray

from rolamento.charts.axes_units import MILLIMETRE
from rolamento.charts.contacts import refuse_rollers
from rolamento.charts.frame import PlainNumbers, empty_frame, figure_of, label_x, label_y
from rolamento.charts.style import in_style, new_figure, new_stacked_figure
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

__all__ = ["QUANTITIES", "Quantity", "slip_map", "slip_maps"]

Floats = NDArray[np.float64]
Quantity = Literal["slip", "pressure", "pressure_slip"]
QUANTITIES: Final[tuple[Quantity, ...]] = ("slip", "pressure", "pressure_slip")

_GRID: Final = 161
_LEVELS: Final = 16
_ARROWS: Final = (13, 5)
_HEAVIEST: Final = -1

_UNITS: Final[Mapping[str, tuple[float, str]]] = {
    "slip": (1.0, "m/s"),
    "pressure": (1e-6, "MPa"),
    "pressure_slip": (1e-6, "W/mm²"),
}


@frozen
class _Contact:
    """One contact, its patch and motion as arrays of one."""

    patch: Patch
    motion: RelativeMotion

    @property
    def touches(self) -> bool:
        return bool(self.patch.load[0] > 0.0)


@in_style
def slip_map(
    solved: Solved,
    axes: Axes | None = None,
    *,
    quantity: Quantity = "slip",
    race: Race = "inner",
    ball: int = _HEAVIEST,
) -> Axes:
    """Draw slip, pressure or their product over one contact ellipse.

    The motion is that of the solved case, by its raceway control. Lines of pure rolling are dashed;
    arrows show how the race slips over the ball; a cross marks the maximum product.

    Parameters
    ----------
    solved
        A single solved case; without a result, a frame that says why is drawn.
    axes
        To draw on; of a new figure if not given.
    quantity
        ``"slip"``, ``"pressure"`` or ``"pressure_slip"``.
    race
        ``"inner"`` or ``"outer"``.
    ball
        Counted from 0; the one with the maximum load on this race if not given.

    Returns
    -------
    Axes
        Those given, with a colour bar beside them.

    Raises
    ------
    InputError
        If this is no ball bearing, there is no such ball, or the quantity is not known.
    """
    axes = new_figure(height=62.0)[1] if axes is None else axes
    one_of(quantity, "quantity", QUANTITIES)
    refuse_rollers(solved)
    if not solved.converged[0]:
        return empty_frame(axes, no_result(str(solved.status.code[0])))
    contact = _contact(solved, race, ball)
    if not contact.touches:
        return empty_frame(axes, said("ball and race do not touch"))
    _draw(axes, contact, quantity)
    return axes


@in_style
def slip_maps(solved: Solved, *, race: Race = "inner", ball: int = _HEAVIEST) -> tuple[Axes, ...]:
    """Draw slip, pressure and their product of one contact below each other, in a new figure.

    Parameters and errors as of `slip_map`.
    """
    _, frames = new_stacked_figure(len(QUANTITIES), height=170.0)
    for axes, quantity in zip(frames, QUANTITIES, strict=True):
        slip_map(solved, axes, quantity=quantity, race=race, ball=ball)
    return frames


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


def _draw(axes: Axes, contact: _Contact, quantity: Quantity) -> None:
    """Draw the map, the edge of the ellipse, the lines, the arrows and the maximum."""
    a, b = (
        float(MILLIMETRE.of(x)[0]) for x in (contact.patch.semi_major, contact.patch.semi_minor)
    )
    steps = np.linspace(-1.0, 1.0, _GRID)
    u, v = np.meshgrid(steps, steps, indexing="ij")
    factor, unit = _UNITS[quantity]
    values = factor * _values(contact, quantity, u, v)
    edge = Ellipse((0.0, 0.0), 2.0 * a, 2.0 * b, fill=False, linewidth=0.9, zorder=3.0)
    drawn = axes.contourf(a * u, b * v, values, levels=_LEVELS)
    drawn.set_gid("colour-map")  # pages in the dark leave it as it is
    axes.add_patch(edge)
    drawn.set_clip_path(edge)
    bar = figure_of(axes).colorbar(drawn, ax=axes, format=PlainNumbers())
    bar.set_label(f"{_name_of(quantity)} ({unit})")
    if quantity != "pressure":
        _draw_lines(axes, contact, a, b)
    if quantity == "slip":
        _draw_arrows(axes, contact, a, b)
    if quantity == "pressure_slip":
        _mark_maximum(axes, contact, a, b)
    axes.set_xlim(-1.05 * a, 1.05 * a)
    axes.set_ylim(-1.15 * b, 1.15 * b)
    axes.grid(False)
    label_x(axes, MILLIMETRE.label(said("Across rolling")))
    label_y(axes, MILLIMETRE.label(said("Along rolling")))
    if axes.get_legend_handles_labels()[0]:
        axes.legend(
            loc="lower left",
            bbox_to_anchor=(0.0, 1.0),
            ncols=2,
            facecolor="#8A8A8A",
            frameon=True,
            borderaxespad=0.2,
        )


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


def _draw_lines(axes: Axes, contact: _Contact, a: float, b: float) -> None:
    lines = rolling_lines(contact.patch, contact.motion)[0]
    label = said("no slip along rolling")
    for line in lines[np.isfinite(lines)]:
        reach = b * float(np.sqrt(1.0 - line**2))
        axes.plot([a * line, a * line], [-reach, reach], "w--", linewidth=1.1, label=label)
        label = "_"


def _draw_arrows(axes: Axes, contact: _Contact, a: float, b: float) -> None:
    """Direction of the slip at some points, all arrows of one length on the page."""
    across, along = (np.linspace(-0.9, 0.9, count) for count in _ARROWS)
    u, v = (array.ravel() for array in np.meshgrid(across, along, indexing="ij"))
    inside = u**2 + v**2 < 0.95
    u, v = u[inside], v[inside]
    slip = slip_velocity(contact.patch, contact.motion, u, v)
    speed = np.maximum(slip.speed[0], np.finfo(np.float64).tiny)
    axes.quiver(
        a * u,
        b * v,
        slip.transverse[0] / speed,
        slip.rolling[0] / speed,
        color="white",
        scale=34.0,
        width=0.0028,
        pivot="middle",
        zorder=4.0,
    )


def _mark_maximum(axes: Axes, contact: _Contact, a: float, b: float) -> None:
    found = maximum_pressure_slip(contact.patch, contact.motion)
    factor, unit = _UNITS["pressure_slip"]
    value = f"{number(float(factor * found.value[0]))} {unit}"
    axes.plot(
        [a * found.across[0]],
        [b * found.along[0]],
        "x",
        color="white",
        markersize=6.0,
        markeredgewidth=1.6,
        linestyle="none",
        label=said("maximum, {value}", value=value),
        zorder=4.0,
    )
