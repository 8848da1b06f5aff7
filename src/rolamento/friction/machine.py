"""What the models of lubricated machine bearings need beside solved cases."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from math import tan
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.friction.palmgren import BearingKind, Lubrication
from rolamento.friction.skf import (
    SkfConstants,
    Supply,
    angular_contact_constants,
    deep_groove_series,
    roller_series,
    self_aligning_series,
    thrust_constants,
)
from rolamento.lubrication import Film
from rolamento.numerics import FloatArray


@dataclass(frozen=True, slots=True)
class MachineBearing:
    """Size, rating and lubricant of a bearing, for Palmgren's and SKF's models.

    bore_diameter, outside_diameter m; kinematic_viscosity of the oil, or the grease's base oil,
    at its temperature, m²/s; static_load_rating C_0, N; static_load_ratio P_0/C_0 for Palmgren's
    model (left out without); contact_angle nominal, rad, for angular-contact and tapered roller
    bearings; constants of the series for SKF's model (left out without); axial_factor Y of tapered
    roller bearings; by_row: whether each row of the set is such a bearing, with its own load.
    Viscosity, rating and ratio are numbers, or arrays (cases,).
    """

    kind: BearingKind
    bore_diameter: float
    outside_diameter: float
    kinematic_viscosity: float | FloatArray
    static_load_rating: float | FloatArray
    static_load_ratio: float | FloatArray | None = None
    contact_angle: float = 0.0
    lubrication: Lubrication = "grease"
    supply: Supply = "grease"
    oil: str = "mineral"
    constants: SkfConstants | None = None
    axial_factor: float | None = None
    by_row: bool = False

    @property
    def mean_diameter(self) -> float:
        """d_m of these models, the mean of bore and outside diameter; m."""
        return 0.5 * (self.bore_diameter + self.outside_diameter)

    def part(self, some: slice) -> MachineBearing:
        """Return that of some of the cases."""
        varied: dict[str, Any] = {
            field.name: value[some]
            for field in fields(self)
            if isinstance(value := getattr(self, field.name), np.ndarray)
        }
        return replace(self, **varied)


def machine_of(
    case: Case, film: Film, static_load_rating: ArrayLike, static_load: ArrayLike
) -> MachineBearing | None:
    """Return the bearing as those models describe it, from its designation.

    Parameters
    ----------
    case
        With a designation: one bearing, or a set of equal roller bearings. An oil is taken to stand
        in the housing as a low bath, for the case does not say how it is supplied.
    film
        Of the solved cases: supplies the viscosity.
    static_load_rating, static_load
        C_0 and P_0, numbers or (cases,); N. Roller bearings need neither.

    Returns
    -------
    MachineBearing or None
        None without a designation or a static rating; SKF's constants for the deep-groove and
        self-aligning series that are on file, and for the other kinds.
    """
    if case.bearing.element != "ball":
        return _of_rollers(case, film)
    told = case.bearing.told
    rating, load = np.broadcast_arrays(
        np.asarray(static_load_rating, np.float64),
        np.asarray(static_load, np.float64),
        film.temperature,
    )[:2]
    own = case.bearing.model_fields_set
    is_set = case.bearing.rows is not None or "arrangement" in own
    if told is None or is_set or not np.all((rating > 0.0) & (load >= 0.0)):
        return None
    published, designation = told.bearing, told.designation
    grease = case.lubricant is not None and case.lubricant.kind == "grease"
    kind: BearingKind = "needle" if published.kind == "drawn_cup" else published.kind
    return MachineBearing(
        kind=kind,
        bore_diameter=published.bore,
        outside_diameter=published.outside_diameter,
        kinematic_viscosity=film.kinematic_viscosity,
        static_load_rating=rating,
        static_load_ratio=load / rating,
        contact_angle=published.contact_angle or designation.contact_angle or 0.0,
        lubrication="grease" if grease else "oil_bath",
        supply="grease" if grease else "low_oil_bath",
        constants=_constants(kind, designation.series or published.designation[:2]),
    )


def _of_rollers(case: Case, film: Film) -> MachineBearing | None:
    """A roller bearing, or the equal ones of a set."""
    bearing = case.bearing
    told = bearing.told
    if told is None or bearing.rows is not None:
        return None
    published, designation = told.bearing, told.designation
    grease = case.lubricant is not None and case.lubricant.kind == "grease"
    element = bearing.places[0].bearing.element
    angle = published.contact_angle or bearing.places[0].bearing.row_angle
    kind: BearingKind = element if element in ("cylindrical", "tapered") else "needle"
    return MachineBearing(
        kind=kind,
        bore_diameter=published.bore,
        outside_diameter=published.outside_diameter,
        kinematic_viscosity=film.kinematic_viscosity,
        static_load_rating=1.0,
        static_load_ratio=0.0,
        contact_angle=angle,
        lubrication="grease" if grease else "oil_bath",
        supply="grease" if grease else "low_oil_bath",
        constants=None if kind == "needle" else roller_series(kind).get(designation.series or ""),
        axial_factor=(published.axial_factor or 0.4 / tan(angle)) if kind == "tapered" else None,
        by_row=len(bearing.places) > 1,
    )


def _constants(kind: BearingKind, series: str) -> SkfConstants | None:
    """SKF's constants of a bearing; None of a series that is not on file."""
    if kind == "deep_groove":
        return deep_groove_series().get(series)
    if kind == "self_aligning":
        return self_aligning_series().get(series)
    if kind == "thrust":
        return thrust_constants()
    return angular_contact_constants("single_row" if kind == "angular_contact" else kind)
