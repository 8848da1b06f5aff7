"""What the models of lubricated machine bearings need beside solved cases."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.film_model import Supply
from rolamento.case.rolling_bearing import RollingBearing
from rolamento.friction.coefficient import USUAL_OIL
from rolamento.friction.palmgren import Lubrication, constants_by_type
from rolamento.friction.skf import SkfConstants, constants_by_series, constants_of
from rolamento.lubrication import Film
from rolamento.numerics import FloatArray
from rolamento.records import frozen

LUBRICATION: Final[dict[Supply, Lubrication]] = {
    "bath": "oil_bath",
    "jet": "oil_jet",
    "grease": "grease",
    "oil_air": "oil_mist",
}
"""Palmgren's words for the ways of supply: he knew oil mist where oil-air is used today."""


@frozen
class MachineBearing:
    """Size, rating and lubricant of a bearing, for Palmgren's and SKF's models.

    bore_diameter, outside_diameter m; kinematic_viscosity of the oil, or the grease's base oil,
    at its temperature, m²/s; static_load_rating C_0, N; static_load_ratio P_0/C_0 for Palmgren's
    model (left out without); contact_angle nominal, rad, for angular-contact and tapered roller
    bearings; constants of the series for SKF's model (left out without); axial_factor Y of tapered
    roller bearings; row: which row of the set it is, with its own load; None of a bearing that
    carries the whole load; rated_as_steel: whether C_0 is that of the bearing with steel balls.
    Viscosity, rating and ratio are numbers, or arrays (cases,).
    """

    kind: str
    bore_diameter: float
    outside_diameter: float
    kinematic_viscosity: float | FloatArray
    static_load_rating: float | FloatArray
    static_load_ratio: float | FloatArray | None = None
    contact_angle: float | FloatArray = 0.0
    supply: Supply = "grease"
    oil: str = USUAL_OIL
    constants: SkfConstants | None = None
    axial_factor: float | FloatArray | None = None
    row: int | None = None
    rated_as_steel: bool = False

    @property
    def mean_diameter(self) -> float:
        """d_m of these models, the mean of bore and outside diameter; m."""
        return 0.5 * (self.bore_diameter + self.outside_diameter)

    @property
    def lubrication(self) -> Lubrication:
        """The way of supply in Palmgren's words."""
        return LUBRICATION[self.supply]

    def part(self, some: slice) -> MachineBearing:
        """Return that of some of the cases."""
        varied: dict[str, Any] = {
            field.name: value[some]
            for field in fields(self)
            if isinstance(value := getattr(self, field.name), np.ndarray)
        }
        return replace(self, **varied)


def bearings_of(bearing: RollingBearing) -> tuple[RollingBearing, ...]:
    """The bearings of a set along +x; the one itself where its rows are rated together."""
    if bearing.rows_of_one_bearing > 1 or len(bearing.places) == 1:
        return (bearing,)
    return tuple(place.bearing for place in bearing.places)


def are_designated(bearing: RollingBearing) -> bool:
    """Whether every bearing of a set, or the one, has a designation."""
    return all(one.designation is not None for one in bearings_of(bearing))


def machines_of(
    case: Case,
    film: Film,
    static_load_rating: ArrayLike,
    static_load: ArrayLike,
    contact_angle: ArrayLike | None = None,
) -> tuple[MachineBearing, ...]:
    """Return the bearings as those models describe them, from their designations.

    Parameters
    ----------
    case
        `film.supply` says how the lubricant comes; an oil stands in a low bath if it does not.
    film
        Of the solved cases: supplies the viscosity.
    static_load_rating, static_load
        C_0 and P_0 of each bearing, numbers, (cases,) or (cases, bearings); N. Roller bearings need
        neither. Where there is no C_0, as of hybrid bearings, that of the list is taken.
    contact_angle
        Nominal, of each bearing, where it varies and neither the maker nor the designation says it;
        (cases, bearings), rad.

    Returns
    -------
    tuple of MachineBearing
        Along +x; empty where a bearing has no designation or no static rating. With SKF's constants
        for the deep-groove and self-aligning series that are on file, and for the other kinds.
    """
    bearings = bearings_of(case.bearing)
    shape = (len(film), len(bearings))
    rating, load = (
        np.broadcast_to(np.asarray(value, np.float64).reshape(-1, 1) if np.ndim(value) == 1
                        else np.asarray(value, np.float64), shape)
        for value in (static_load_rating, static_load)
    )  # fmt: skip
    angle = None if contact_angle is None else np.asarray(contact_angle, np.float64)
    found = [
        _machine(
            case, bearing, film, rating[:, index], load[:, index],
            bearing.places[0].bearing.row_angle if angle is None else angle[:, index],
        )
        for index, bearing in enumerate(bearings)
    ]  # fmt: skip
    if len(found) > 1:
        found = [one and replace(one, row=index) for index, one in enumerate(found)]
    known = [one for one in found if one is not None]
    return tuple(known) if len(known) == len(found) else ()


def _machine(
    case: Case,
    bearing: RollingBearing,
    film: Film,
    rating: FloatArray,
    load: FloatArray,
    row_angle: float | FloatArray,
) -> MachineBearing | None:
    resolved, lubricant = bearing.resolved, case.lubricant
    if resolved is None or lubricant is None:
        return None
    published, designation = resolved.bearing, resolved.designation
    angle = published.contact_angle or getattr(designation, "contact_angle", None) or 0.0
    supply = case.film.supply if case.film is not None else None
    shared: dict[str, Any] = {
        "bore_diameter": published.bore,
        "outside_diameter": published.outside_diameter,
        "kinematic_viscosity": film.kinematic_viscosity,
        "supply": supply or ("grease" if lubricant.kind == "grease" else "bath"),
        "oil": lubricant.oil.oil_type or USUAL_OIL,
    }
    if bearing.bearing_type.has_rollers:
        return _of_rollers(bearing, angle or row_angle, shared)
    rated = np.all(rating > 0.0)
    if not rated:
        rating = np.full(rating.shape, published.static_rating or np.nan)
    if not np.all((rating > 0.0) & (load >= 0.0)):
        return None
    return MachineBearing(
        kind=published.kind,
        static_load_rating=rating,
        static_load_ratio=load / rating,
        contact_angle=angle,
        constants=constants_of(published.kind, designation.series or published.designation[:2]),
        rated_as_steel=not rated,
        **shared,
    )


def _of_rollers(
    bearing: RollingBearing, angle: float | FloatArray, shared: dict[str, Any]
) -> MachineBearing:
    """A roller bearing, which needs no rating."""
    assert bearing.resolved is not None
    published, designation = bearing.resolved.bearing, bearing.resolved.designation
    kind = bearing.places[0].bearing.listed_type
    series = designation.series or ""
    if "E" in published.designation and f"{series}E" in constants_by_series(kind.key):
        series = f"{series}E"
    factor = published.axial_factor or (0.4 / np.tan(angle) if np.all(angle) else None)
    return MachineBearing(
        kind=kind.key,
        static_load_rating=1.0,
        static_load_ratio=0.0 if kind.key in constants_by_type() else None,
        contact_angle=angle,
        constants=constants_of(kind.key, series),
        axial_factor=factor if kind.axial_limit_of_maker else None,
        **shared,
    )
