"""Equivalent loads: P of rating life and P_0 of static safety, with X, Y and e.

A single row, or rows in tandem: P = F_r up to F_a/F_r = e, and X F_r + Y F_a beyond. Two rows
that face each other (a double row, or a pair back to back or face to face): P = F_r + Y_1 F_a up
to e, and X_2 F_r + Y_2 F_a beyond. Below 20° X, Y and e depend on F_a/(i Z D²); between the
angles and the loads of the table they are interpolated in proportion, outside the loads the end
values hold, as the standard has it.

Sources: ISO 281:2007, table 3; ISO 76:2006, table 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import numbers
from rolamento.errors import InputError
from rolamento.life._figures import figures, positive
from rolamento.numerics import FloatArray
from rolamento.words import said

MAXIMUM_ANGLE: Final = float(np.radians(45.0))
"""Beyond it a bearing is a thrust bearing, with tables of its own."""
_ROUNDING: Final = 1e-9
_SAME_AS: Final = {"e2": "e"}
"""e of double rows is that of single ones at most angles."""


@dataclass(frozen=True, slots=True)
class LoadFactors:
    """X and Y up to e, beyond e, and e; arrays of one shape."""

    radial_below: FloatArray
    axial_below: FloatArray
    radial: FloatArray
    axial: FloatArray
    limit: FloatArray


@dataclass(frozen=True, slots=True)
class EquivalentLoad:
    """P (N) and the factors that it was found with; arrays of one shape."""

    load: FloatArray
    radial_factor: FloatArray
    axial_factor: FloatArray
    limit: FloatArray


def load_factors(
    contact_angle: ArrayLike, relative_axial_load: ArrayLike, *, double_row: bool = False
) -> LoadFactors:
    """X, Y and e of radial ball bearings.

    Parameters
    ----------
    contact_angle : array, nominal α; rad, 0 to 45°.
    relative_axial_load : array that broadcasts with it, F_a/(i Z D²), i counting the rows that
        carry the axial load together; Pa.
    double_row : whether two rows face each other.

    Returns
    -------
    LoadFactors of the broadcast shape.

    Raises
    ------
    InputError
        For an angle beyond 45°: a thrust bearing.

    ISO 281:2007, table 3.
    """
    angle, load = np.broadcast_arrays(
        _angle(contact_angle), numbers(relative_axial_load, "relative_axial_load") * 1e-6
    )
    names = ("X2", "Y2", "Y1", "e2") if double_row else ("X", "Y", "Y1", "e")
    radial, axial, below, limit = (_interpolated(name, angle, load) for name in names)
    if not double_row:
        below = np.zeros_like(axial)
    return LoadFactors(np.ones_like(radial), below, radial, axial, limit)


def equivalent_load(
    radial_load: ArrayLike,
    axial_load: ArrayLike,
    contact_angle: ArrayLike,
    relative_axial_load: ArrayLike,
    *,
    double_row: bool = False,
) -> EquivalentLoad:
    """Dynamic equivalent load P.

    Parameters
    ----------
    radial_load, axial_load : arrays, F_r and F_a, zero or more; N.
    contact_angle, relative_axial_load, double_row : as `load_factors`.
        All broadcast against each other.

    Returns
    -------
    EquivalentLoad of the broadcast shape.

    ISO 281:2007, 5.1.2 and table 3.
    """
    radial = positive(radial_load, "radial_load", zero=True)
    axial = positive(axial_load, "axial_load", zero=True)
    found = load_factors(contact_angle, relative_axial_load, double_row=double_row)
    shallow = axial <= found.limit * radial * (1.0 + _ROUNDING)
    x = np.where(shallow, found.radial_below, found.radial)
    y = np.where(shallow, found.axial_below, found.axial)
    x, y, limit = np.broadcast_arrays(x, y, found.limit)
    return EquivalentLoad(x * radial + y * axial, x, y, limit)


def static_equivalent_load(
    radial_load: ArrayLike,
    axial_load: ArrayLike,
    contact_angle: ArrayLike,
    *,
    double_row: bool = False,
) -> FloatArray:
    """Static equivalent load P_0 = X_0 F_r + Y_0 F_a, at least F_r; N.

    Parameters: arrays that broadcast, N and rad. Between the angles of the table X_0 and Y_0 are
    interpolated in proportion; two rows of radial contact count as one. ISO 76:2006, table 2.
    """
    radial = positive(radial_load, "radial_load", zero=True)
    axial = positive(axial_load, "axial_load", zero=True)
    table = figures()["static_equivalent_load"]
    degrees = np.degrees(_angle(contact_angle))
    names = ("X02", "Y02") if double_row else ("X0", "Y0")
    x, y = (np.interp(degrees, table["contact_angle_deg"], table[name]) for name in names)
    return np.asarray(np.maximum(radial, x * radial + y * axial))


def static_safety(static_rating: ArrayLike, static_equivalent: ArrayLike) -> FloatArray:
    """Static safety S_0 = C_0/P_0; infinite without load. Parameters: arrays; N. ISO 76:2006."""
    rating = positive(static_rating, "static_rating")
    with np.errstate(divide="ignore"):
        return np.asarray(rating / positive(static_equivalent, "static_equivalent", zero=True))


def _angle(contact_angle: ArrayLike) -> FloatArray:
    angle = numbers(contact_angle, "contact_angle")
    if np.any((angle < 0.0) | (angle > MAXIMUM_ANGLE * (1.0 + _ROUNDING))):
        raise InputError(
            said("must be from 0 to 45°: above that, the tables for thrust bearings apply"),
            field="contact_angle",
            value=f"{float(np.degrees(np.nanmax(np.abs(angle)))):.4g} deg",
            example='contact_angle = "25 deg"',
        )
    return angle


def _interpolated(name: str, angle: FloatArray, load: FloatArray) -> FloatArray:
    """A factor at angles (rad) and relative axial loads (MPa), column by column of the table."""
    nodes, columns, loads = _table(name)
    degrees = np.degrees(angle)
    upper = np.clip(np.searchsorted(nodes, degrees), 1, nodes.size - 1)
    share = (degrees - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1])
    result = np.full(angle.shape, np.nan)
    for index in np.unique(upper):
        own = upper == index
        low, high = (np.interp(load[own], loads, columns[i]) for i in (index - 1, index))
        result[own] = low + share[own] * (high - low)
    return result


@cache
def _table(name: str) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Contact angles (degrees), a factor (angles, loads) and the relative axial loads (MPa)."""
    data: dict[str, Any] = figures()["equivalent_load"]
    loads = np.array(data["relative_axial_load"])
    same = _SAME_AS.get(name, name)  # where a line does not tell its own
    rows = [
        np.broadcast_to(np.asarray(row.get(name, row[same]), np.float64), loads.shape)
        for row in data["angle"]
    ]
    rows += [np.full(loads.shape, value) for value in data["steep"][same]]
    angles = [row["contact_angle_deg"] for row in data["angle"]] + data["steep"][
        "contact_angle_deg"
    ]
    return np.array(angles), np.array(rows), loads
