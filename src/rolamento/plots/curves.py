"""Curves of one bearing: load over displacement, stiffness and contact angle over speed.

They take plain arrays in SI units: columns of a `Solved`, or variables of a study.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from rolamento.charts import Axis, Chart, Line, Spread, nothing, race_look, series_look
from rolamento.charts.axes_units import DEGREE, RPM, readable_unit
from rolamento.charts.contacts import race_word
from rolamento.charts.drawing import draw
from rolamento.charts.record import Form
from rolamento.charts.texts import capitalised, no_result
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.solved import RACES
from rolamento.studies.names import variable_name
from rolamento.validate import one_of
from rolamento.words import said
from rolamento.words.quantities import called

Floats = NDArray[np.float64]

MOST_MARKERS: Final = 30
"""A line of more points is drawn without markers."""

_DIRECTIONS: Final = ("x", "y", "z", "ry", "rz")
_LOADS: Final = ("fx", "fy", "fz", "my", "mz")
_LOWEST_CEILING: Final = 1.4
"""Where the least value is above the greatest over this, the axis does not begin at zero."""


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
    if not np.isfinite(across + up).any():
        return draw(nothing(no_result()), axes)
    tilt = position > 2
    unit_x = readable_unit("rad" if tilt else "m", across)
    unit_y = readable_unit("N*m" if tilt else "N", up)
    lines = (
        Line(unit_x.of(across[index]), unit_y.of(up[index]), name, series_look(index),
             form_of(across.shape[1]))
        for index, name in enumerate(names)
    )  # fmt: skip
    over = Axis(capitalised(variable_name(direction)), unit_x.symbol)
    upright = Axis(capitalised(variable_name(_LOADS[position])), unit_y.symbol)
    return draw(Chart(tuple(lines), over, upright), axes)


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
    if not np.isfinite(up).any():
        return draw(nothing(no_result()), axes)
    unit = readable_unit("N*m/rad" if tilts == {True} else "N/m", up)
    lines = (
        Line(RPM.of(across), unit.of(up[:, index]), f"{direction}–{direction}",
             series_look(index), form_of(len(across)))
        for index, direction in enumerate(directions)
    )  # fmt: skip
    upright = Axis(said("Stiffness"), unit.symbol, zero=_from_zero(up))
    return draw(Chart(tuple(lines), _speed(), upright), axes)


def contact_angle_over_speed(
    speed: ArrayLike, inner: ArrayLike, outer: ArrayLike, axes: Axes | None = None
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
    if not any(np.isfinite(values).any() for values in angles.values()):
        return draw(nothing(no_result()), axes)
    series = [one for race in RACES for one in _band(RPM.of(across), angles[race], race)]
    return draw(
        Chart(tuple(series), _speed(), Axis(capitalised(called("contact_angle")), DEGREE.symbol)),
        axes,
    )


def _speed() -> Axis:
    return Axis(capitalised(variable_name("inner_speed")), RPM.symbol)


def form_of(points: int) -> Form:
    """Return how a line of so many points is drawn."""
    return "both" if points <= MOST_MARKERS else "line"


def _band(x: Floats, values: Floats, race: Race) -> list[Spread | Line]:
    """Return how far the balls' values spread, and their middle."""
    name, look = race_word(race), race_look(race)
    table = np.ma.masked_invalid(values.reshape(len(x), -1))
    least, middle, greatest = (
        np.ma.filled(found(table, axis=1).astype(np.float64), np.nan)
        for found in (np.ma.min, np.ma.median, np.ma.max)
    )
    if table.shape[1] == 1:
        return [Line(x, middle, name, look)]
    spread = said("{race}, all balls", race=name)
    return [Spread(x, least, greatest, spread, look),
            Line(x, middle, said("{race}, median", race=name), look)]  # fmt: skip


def _from_zero(values: Floats) -> bool:
    """Whether the axis begins at zero: not where the values would be squeezed together."""
    finite = values[np.isfinite(values)]
    return bool(finite.min() >= 0.0 and finite.max() > _LOWEST_CEILING * finite.min())


def _position(direction: str) -> int:
    one_of(direction, "direction", _DIRECTIONS)
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
