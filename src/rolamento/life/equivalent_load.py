"""Equivalent loads: P of rating life and P_0 of static safety, with X, Y and e.

A single row, or rows in tandem: P = F_r up to F_a/F_r = e, and X F_r + Y F_a beyond. Two rows
that face each other (a double row, or a pair back to back or face to face): P = F_r + Y_1 F_a up
to e, and X_2 F_r + Y_2 F_a beyond. Below 20° X, Y and e depend on F_a/(i Z D²); between the
angles and the loads of the table they are interpolated in proportion, outside the loads the end
values hold, as the standard has it.

Self-aligning bearings: e = 1.5 tan α, Y_1 = 0.42 cot α, X_2 = 0.65, Y_2 = 0.65 cot α, and at rest
Y_0 = 0.44 cot α. Thrust bearings have an axial P_a = X F_r + F_a with X = 1.25 tan α
(1 - 2/3 sin α) beyond e = 1.25 tan α, below which one direction does not do; at 90° P_a = F_a.

Roller bearings have factors by the angle alone, e = 1.5 tan α; see `_factors_of_rollers`. At 0° the
standard has P = F_r and no axial load; what ribs carry of it is calculated as the maker does.

Where a maker lists e, Y and Y_0 of a tapered roller bearing (`ListedFactors`), these lead: they are
rounded, and P is what the maker's customers find. Rows that face each other have the factors of one
row in the proportion of the standard, Y_1 = 0.45/0.4 Y, Y_2 = 0.67/0.4 Y and twice Y_0.

Sources: ISO 281:2007, tables 3, 5, 8 and 11; ISO 76:2006, tables 2 and 4, 5.2 and 8.2.
"""

from __future__ import annotations

from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.ratings import RatedType, RollerRated, rated_as
from rolamento.records import frozen
from rolamento.validate import numbers, positive
from rolamento.words import said

MAXIMUM_ANGLE: Final = float(np.radians(45.0))
"""Beyond it a bearing is a thrust bearing, with tables of its own."""
_ROUNDING: Final = 1e-9
_ROLLER_SINGLE, _ROLLER_DOUBLE, _ROLLER_BELOW = 0.4, 0.67, 0.45
"""X, and Y over cot α, of one row and of two rows beyond e; Y over cot α of two up to it."""
_SAME_AS: Final = {"e2": "e"}
"""e of double rows is that of single ones at most angles."""


@frozen
class LoadFactors:
    """X and Y up to e, beyond e, and e; arrays of one shape."""

    radial_below: FloatArray
    axial_below: FloatArray
    radial: FloatArray
    axial: FloatArray
    limit: FloatArray


@frozen
class EquivalentLoad:
    """P (N) and the factors that it was found with; arrays of one shape."""

    load: FloatArray
    radial_factor: FloatArray
    axial_factor: FloatArray
    limit: FloatArray


@frozen
class ListedFactors:
    """e, Y and Y_0 of one row, as the maker of a tapered roller bearing lists them."""

    limit: float
    axial: float
    static_axial: float


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
    radial, axial, below, limit = _interpolated(names, angle, load)
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
    kind: RatedType | RollerRated = "radial",
    wide: bool = False,
    listed: ListedFactors | None = None,
) -> EquivalentLoad:
    """Dynamic equivalent load: P, of thrust bearings the axial P_a.

    Parameters
    ----------
    radial_load, axial_load : arrays, F_r and F_a, zero or more; N.
    contact_angle, relative_axial_load, double_row : as `load_factors`; of all but radial ball
        bearings only the angle counts.
        All broadcast against each other.
    kind : what the bearing is rated as.
    wide : whether a cylindrical roller bearing, whose ribs carry the axial load, is of a wide
        series: 12, 20, 22, 23 and those of width 8, 9 and 30 on.
    listed : of radial roller bearings, the maker's factors, in the place of those by the angle.

    Returns
    -------
    EquivalentLoad of the broadcast shape; P_a is NaN where a thrust bearing has too little axial
    load for its radial one.

    ISO 281:2007, 5.1.2, 5.2.2, 7.2, 8.2 and tables 3, 5, 8 and 11.
    """
    radial = positive(radial_load, "radial_load", zero=True)
    axial = positive(axial_load, "axial_load", zero=True)
    if kind == "radial":
        found = load_factors(contact_angle, relative_axial_load, double_row=double_row)
    elif kind == "roller" and listed is not None:
        found = _factors_of_maker(listed, np.shape(contact_angle), double_row)
    elif kind in ("roller", "roller_thrust"):
        found = _factors_of_rollers(contact_angle, kind == "roller_thrust", double_row, wide)
    else:
        found = _factors_by_angle(contact_angle, kind)
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
    kind: RatedType | RollerRated = "radial",
    listed: ListedFactors | None = None,
) -> FloatArray:
    """Static equivalent load P_0 = X_0 F_r + Y_0 F_a, at least F_r; N.

    Parameters: arrays that broadcast, N and rad. Between the angles of the table X_0 and Y_0 are
    interpolated in proportion; two rows of radial contact count as one. Of roller bearings X_0 is
    0.5 and Y_0 0.22 cot α, or as listed, of two rows 1 and twice that; at 0° P_0 = F_r. Of thrust
    bearings P_0a = 2.3 F_r tan α + F_a, at 90° F_a. ISO 76:2006, tables 2 and 4, 5.1.2, 5.2.2, 7.2
    and 8.2.

    >>> print(f"{static_equivalent_load(1000.0, 2000.0, 0.0):.0f} N")
    1600 N
    """
    radial = positive(radial_load, "radial_load", zero=True)
    axial = positive(axial_load, "axial_load", zero=True)
    if kind == "roller":
        rows = 2.0 if double_row else 1.0
        y = 0.22 * _cotangent(contact_angle) if listed is None else listed.static_axial
        return np.asarray(np.maximum(radial, rows * (0.5 * radial + y * axial)))
    if kind != "radial":
        tangent = _tangent(contact_angle)
        if not rated_as(kind)["axial"]:
            return np.asarray(np.maximum(radial, radial + 0.44 / tangent * axial))
        return np.asarray(
            np.where(np.isinf(tangent), axial, 2.3 * radial * _finite(tangent) + axial)
        )
    table = toml_of("iso281")["static_equivalent_load"]
    degrees = np.degrees(_angle(contact_angle))
    names = ("X02", "Y02") if double_row else ("X0", "Y0")
    x, y = (np.interp(degrees, table["contact_angle_deg"], table[name]) for name in names)
    return np.asarray(np.maximum(radial, x * radial + y * axial))


def axial_ratings(
    dynamic_rating: ArrayLike, static_rating: ArrayLike, contact_angle: ArrayLike
) -> tuple[FloatArray, FloatArray]:
    """C_a and C_0a of an angular-contact bearing: C_r / Y and C_0r / Y_0, N.

    Parameters
    ----------
    dynamic_rating, static_rating : arrays, C_r and C_0r of one row; N.
    contact_angle : array, 20° to 45°; rad.

    The axial load under which P = Y F_a is C_r; makers list four-point bearings so. ISO 281:2007,
    table 3; ISO 76:2006, table 2.
    """
    factors = load_factors(contact_angle, 0.0)
    table = toml_of("iso281")["static_equivalent_load"]
    static = np.interp(np.degrees(_angle(contact_angle)), table["contact_angle_deg"], table["Y0"])
    return (
        np.asarray(positive(dynamic_rating, "dynamic_rating") / factors.axial),
        np.asarray(positive(static_rating, "static_rating") / static),
    )


def with_thrust_grooves(
    dynamic_rating: ArrayLike, static_rating: ArrayLike, contact_angle: ArrayLike
) -> tuple[FloatArray, FloatArray]:
    """C_a and C_0a of an angular-contact bearing with the grooves of a thrust bearing (0.54); N.

    C_a = 1.91 tan α (1 - 0.333 sin α) C_r and C_0a = 0.7 C_0r / Y_0, with which the standards
    compare both kinds at their border of 45°. Parameters as of `axial_ratings`. ISO 281:2007 and
    ISO 76:2006, annexes on discontinuities.
    """
    angle = _angle(contact_angle)
    uneven = 1.0 - 0.333 * np.sin(angle)
    dynamic = 1.91 * np.tan(angle) * uneven * positive(dynamic_rating, "dynamic_rating")
    return np.asarray(dynamic), np.asarray(
        0.7 * axial_ratings(1.0, static_rating, contact_angle)[1]
    )


def minimum_axial_load(
    static_rating: ArrayLike, speed: ArrayLike, limiting_speed: ArrayLike | None = None
) -> FloatArray:
    """Least axial load that keeps the balls of a thrust bearing from sliding; N.

    Parameters
    ----------
    static_rating : array, C_0a; N.
    speed : array, of the rings against each other, unsigned.
    limiting_speed : array, the maker's with oil, in the same unit; without it only C_0a/1000.

    The greater of C_0a/100 (n/n_max)² and C_0a/1000. NSK, Rolling Bearings (CAT. No. E1102e), page
    A98, equations 10.1 and 10.2.
    """
    rating = positive(static_rating, "static_rating")
    ratio = (
        0.0
        if limiting_speed is None
        else numbers(speed, "speed") / numbers(limiting_speed, "limiting_speed")
    )
    return np.asarray(rating * np.maximum(np.square(ratio) / 100.0, 1e-3))


def _factors_by_angle(contact_angle: ArrayLike, kind: RatedType | RollerRated) -> LoadFactors:
    """X, Y and e of self-aligning and of thrust bearings, which depend on the angle alone."""
    tangent = _tangent(contact_angle)
    ones = np.ones(np.shape(tangent))
    if not rated_as(kind)["axial"]:
        return LoadFactors(ones, 0.42 / tangent, 0.65 * ones, 0.65 / tangent, 1.5 * tangent)
    right = np.isinf(tangent)
    slope = _finite(tangent)
    sine = slope / np.sqrt(1.0 + slope**2)
    radial = np.where(right, 0.0, 1.25 * slope * (1.0 - 2.0 / 3.0 * sine))
    limit = np.where(right, 0.0, 1.25 * slope)
    nothing = np.where(right, 0.0, np.nan)
    return LoadFactors(nothing, np.where(right, 1.0, np.nan), radial, ones, limit)


def _factors_of_rollers(
    contact_angle: ArrayLike, thrust: bool, double_row: bool, wide: bool
) -> LoadFactors:
    """X, Y and e of roller bearings, radial or thrust.

    ISO 281:2007, table 8: e = 1.5 tan α; one row X = 0.4 and Y = 0.4 cot α beyond it, two rows
    Y = 0.45 cot α up to it, 0.67 and 0.67 cot α beyond. Table 11: thrust bearings X = tan α and
    Y = 1 beyond it, in two directions 1.5 tan α and 0.67 up to it; at 90° P_a = F_a. At 0° the ribs
    carry the axial load: SKF, Rolling bearings (17000 EN), page 509.
    """
    tangent = _tangent(contact_angle)
    ones = np.ones(np.shape(tangent))
    if thrust:
        right = np.isinf(tangent)
        slope = np.where(right, 0.0, _finite(tangent))
        below = (1.5 * slope, 0.67 * ones) if double_row else (np.nan * ones, np.nan * ones)
        x_below, y_below = (
            np.where(right, end, own) for end, own in zip((0, 1), below, strict=True)
        )
        return LoadFactors(x_below, y_below, slope, ones, 1.5 * slope)
    ribs = toml_of("iso281")["equivalent_load_of_ribs"]["wide" if wide else "narrow"]
    flat, cotangent = tangent == 0.0, _cotangent(contact_angle)
    x = _ROLLER_DOUBLE if double_row else _ROLLER_SINGLE
    return LoadFactors(
        ones,
        _ROLLER_BELOW * cotangent if double_row else 0.0 * ones,
        np.where(flat, ribs["X"], x),
        np.where(flat, ribs["Y"], x * cotangent),
        np.where(flat, ribs["e"], 1.5 * tangent),
    )


def _factors_of_maker(
    listed: ListedFactors, shape: tuple[int, ...], double_row: bool
) -> LoadFactors:
    """X, Y and e of tapered rows by the maker's factors of one row."""
    ones = np.ones(shape)
    x = _ROLLER_DOUBLE if double_row else _ROLLER_SINGLE
    below = _ROLLER_BELOW / _ROLLER_SINGLE * listed.axial if double_row else 0.0
    return LoadFactors(
        ones, below * ones, x * ones, x / _ROLLER_SINGLE * listed.axial * ones, listed.limit * ones
    )


def _cotangent(contact_angle: ArrayLike) -> FloatArray:
    """Return cot α, and 0 at 0°, where it has no part."""
    tangent = _tangent(contact_angle)
    return np.where(tangent > 0.0, 1.0 / np.where(tangent > 0.0, tangent, 1.0), 0.0)


def _tangent(contact_angle: ArrayLike) -> FloatArray:
    """Return tan α, infinite at 90°."""
    angle = numbers(contact_angle, "contact_angle")
    return np.where(angle >= np.pi / 2 * (1.0 - _ROUNDING), np.inf, np.tan(angle))


def _finite(tangent: FloatArray) -> FloatArray:
    return np.where(np.isinf(tangent), 1.0, tangent)


def static_safety(static_rating: ArrayLike, static_equivalent: ArrayLike) -> FloatArray:
    """Static safety S_0 = C_0/P_0; infinite without load. Parameters: arrays; N. ISO 76:2006.

    >>> print(f"{static_safety(38e3, 19e3):.1f}")
    2.0
    """
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


def _interpolated(
    names: tuple[str, ...], angle: FloatArray, load: FloatArray
) -> tuple[FloatArray, ...]:
    """Factors at angles (rad) and relative axial loads (MPa), column by column of the table."""
    tables = [_table(name) for name in names]
    nodes, _, loads = tables[0]  # the same of all factors
    degrees = np.degrees(angle)
    upper = np.clip(np.searchsorted(nodes, degrees), 1, nodes.size - 1)
    share = (degrees - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1])
    results = tuple(np.full(angle.shape, np.nan) for _ in names)
    for index in range(upper.min(), upper.max() + 1) if upper.size else ():
        own = upper == index
        under, part = load[own], share[own]
        for (_, columns, _), result in zip(tables, results, strict=True):
            low, high = (np.interp(under, loads, columns[i]) for i in (index - 1, index))
            result[own] = low + part * (high - low)
    return results


@cache
def _table(name: str) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Contact angles (degrees), a factor (angles, loads) and the relative axial loads (MPa)."""
    data: dict[str, Any] = toml_of("iso281")["equivalent_load"]
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
