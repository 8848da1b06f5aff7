"""Curves of one bearing: load over displacement, stiffness and contact angle over speed.

They take plain arrays in SI units: columns of a `Solved`, or variables of a study.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.plots.axes_units import DEGREE, RPM, readable_unit
from rolamento.plots.contacts import race_word
from rolamento.plots.frame import empty_frame, label_x, label_y, legend_above
from rolamento.plots.style import INNER, OUTER, in_style, new_figure, series
from rolamento.plots.texts import capitalised, no_result
from rolamento.solved import RACES
from rolamento.studies.names import variable_name
from rolamento.words import said

Floats = NDArray[np.float64]

MOST_MARKERS: Final = 30
"""A line of more points is drawn without markers."""

_DIRECTIONS: Final = ("x", "y", "z", "ry", "rz")
_LOADS: Final = ("fx", "fy", "fz", "my", "mz")
_LOWEST_CEILING: Final = 1.4
"""Where the least value is above the greatest over this, the axis does not begin at zero."""


@in_style
def load_displacement(
    displacement: ArrayLike,
    load: ArrayLike,
    axes: Axes | None = None,
    *,
    direction: str = "x",
    labels: Sequence[str] = (),
) -> Axes:
    """Draw a load over the displacement in its direction.

    Parameters
    ----------
    displacement
        (cases,), or (curves, cases), of the inner ring, in m or rad; NaN without a result.
    load
        Likewise, in N or N·m.
    axes
        To draw on; of a new figure if not given.
    direction
        ``"x"``, ``"y"``, ``"z"``, ``"ry"`` or ``"rz"``.
    labels
        Of the curves in the legend, where there are several.

    Returns
    -------
    Axes
        Those given.

    Raises
    ------
    InputError
        For another direction, arrays that do not go together, or a label too many or too few.
    """
    position = _position(direction)
    across, up = _together(displacement=displacement, load=load)
    across, up = np.atleast_2d(across), np.atleast_2d(up)
    names = list(labels) or [""] * len(across)
    if len(names) != len(across) or across.ndim > 2:
        raise InputError(
            said("must be one for each of {count} curves", count=len(across)), field="labels"
        )
    axes = new_figure()[1] if axes is None else axes
    if not np.isfinite(across + up).any():
        return empty_frame(axes, no_result())
    tilt = position > 2
    unit_x = readable_unit("rad" if tilt else "m", across)
    unit_y = readable_unit("N*m" if tilt else "N", up)
    for index, name in enumerate(names):
        look = series(index).keywords(markers=across.shape[1] <= MOST_MARKERS)
        axes.plot(unit_x.of(across[index]), unit_y.of(up[index]), label=name or None, **look)
    label_x(axes, unit_x.label(capitalised(variable_name(direction))))
    label_y(axes, unit_y.label(capitalised(variable_name(_LOADS[position]))))
    legend_above(axes)
    return axes


@in_style
def stiffness_over_speed(
    speed: ArrayLike,
    stiffness: ArrayLike,
    axes: Axes | None = None,
    *,
    directions: Sequence[str] = ("x", "y", "z"),
) -> Axes:
    """Draw stiffnesses of a bearing over the speed of its inner ring.

    Parameters
    ----------
    speed
        (cases,), in rad/s.
    stiffness
        (cases, 5, 5), as of `Solved.stiffness.array`; or (cases, directions), each already of its
        direction, such as ``np.stack([study["stiffness_xx"], study["stiffness_zz"]], axis=1)``.
    axes
        To draw on; of a new figure if not given.
    directions
        Which of ``"x"``, ``"y"``, ``"z"`` (N/m); or of the tilts ``"ry"``, ``"rz"`` (N·m/rad).

    Returns
    -------
    Axes
        Those given. A case without a result leaves a gap.

    Raises
    ------
    InputError
        For another direction, shifts and tilts on one axis, or arrays that do not go together.
    """
    positions = [_position(direction) for direction in directions]
    tilts = {position > 2 for position in positions}
    if len(tilts) != 1:
        raise InputError(
            said("must be displacements or tilts: they have different units"),
            field="directions",
            value=", ".join(directions),
            example='("x", "z")',
        )
    across, up = np.asarray(speed, dtype=np.float64), np.asarray(stiffness, dtype=np.float64)
    if up.ndim == 3 and up.shape[1:] == (5, 5):
        up = up[:, positions, positions]
    if across.ndim != 1 or up.shape != (len(across), len(positions)):
        raise InputError(
            said(
                "must be (cases, 5, 5) or (cases, directions) for {size} speeds, is {shape}",
                size=across.size,
                shape=up.shape,
            ),
            field="stiffness",
        )
    axes = new_figure()[1] if axes is None else axes
    if not np.isfinite(up).any():
        return empty_frame(axes, no_result())
    unit = readable_unit("N*m/rad" if tilts == {True} else "N/m", up)
    for index, direction in enumerate(directions):
        look = series(index).keywords(markers=len(across) <= MOST_MARKERS)
        axes.plot(RPM.of(across), unit.of(up[:, index]), label=f"{direction}–{direction}", **look)
    _from_zero(axes, up)
    label_x(axes, RPM.label(capitalised(variable_name("inner_speed"))))
    label_y(axes, unit.label(said("Stiffness")))
    legend_above(axes)
    return axes


@in_style
def contact_angle_over_speed(
    speed: ArrayLike,
    inner: ArrayLike,
    outer: ArrayLike,
    axes: Axes | None = None,
) -> Axes:
    """Draw inner and outer contact angles over the speed of the inner ring.

    Parameters
    ----------
    speed
        (cases,), in rad/s.
    inner, outer
        (cases,) of one ball, or (cases, balls), in rad: then a band from the least to the
        greatest of the balls, and a line through their median. NaN where there is no contact.
    axes
        To draw on; of a new figure if not given.

    Returns
    -------
    Axes
        Those given.

    Raises
    ------
    InputError
        For arrays that do not go together.
    """
    across = np.asarray(speed, dtype=np.float64)
    angles = {name: DEGREE.of(values) for name, values in zip(RACES, (inner, outer), strict=True)}
    for name, values in angles.items():
        if across.ndim != 1 or values.ndim not in (1, 2) or len(values) != len(across):
            raise InputError(
                said(
                    "must be (cases,) or (cases, balls) for {size} speeds, is {shape}",
                    size=across.size,
                    shape=values.shape,
                ),
                field=name,
            )
    axes = new_figure()[1] if axes is None else axes
    if not any(np.isfinite(values).any() for values in angles.values()):
        return empty_frame(axes, no_result())
    for race, look in zip(RACES, (INNER, OUTER), strict=True):
        _band(axes, RPM.of(across), angles[race], race, look.keywords())
    label_x(axes, RPM.label(capitalised(variable_name("inner_speed"))))
    label_y(axes, DEGREE.label(said("Contact angle")))
    legend_above(axes)
    return axes


def _band(axes: Axes, x: Floats, values: Floats, race: Race, look: Mapping[str, Any]) -> None:
    """Draw the middle of the balls' values, and how far they spread."""
    name = race_word(race)
    table = np.ma.masked_invalid(values.reshape(len(x), -1))
    least, middle, greatest = (
        np.ma.filled(found(table, axis=1).astype(np.float64), np.nan)
        for found in (np.ma.min, np.ma.median, np.ma.max)
    )
    if table.shape[1] > 1:
        spread = said("{race}, all balls", race=name)
        axes.fill_between(
            x, least, greatest, color=look["color"], alpha=0.18, linewidth=0.0, label=spread
        )
        name = said("{race}, median", race=name)
    axes.plot(x, middle, label=name, **look)


def _from_zero(axes: Axes, values: Floats) -> None:
    """Let the axis begin at zero, unless the values would then be squeezed together."""
    finite = values[np.isfinite(values)]
    if finite.min() >= 0.0 and finite.max() > _LOWEST_CEILING * finite.min():
        axes.set_ylim(bottom=0.0)


def _position(direction: str) -> int:
    if direction not in _DIRECTIONS:
        raise InputError(
            said("must be one of {known}", known=", ".join(_DIRECTIONS)),
            field="direction",
            value=direction,
        )
    return _DIRECTIONS.index(direction)


def _together(**arrays: ArrayLike) -> list[Floats]:
    """Bring arrays to one shape."""
    columns = [np.asarray(values, dtype=np.float64) for values in arrays.values()]
    try:
        return [np.array(column) for column in np.broadcast_arrays(*columns)]
    except ValueError:
        raise InputError(
            said("must have the same length: {arrays}", arrays=", ".join(arrays))
        ) from None
