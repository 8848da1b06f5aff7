"""What Palmgren's and SKF's friction models need, from a designation, its ratings and the film.

An oil is taken to stand in the housing as a low bath: the case does not say how it is supplied.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rolamento.case import Case

if TYPE_CHECKING:
    from rolamento.friction import MachineBearing
    from rolamento.life import LifeSummary
    from rolamento.lubrication import Film

__all__ = ["machine_of"]


def machine_of(case: Case, film: Film | None, life: LifeSummary | None) -> MachineBearing | None:
    """The bearing as those models know it.

    Parameters
    ----------
    case
        With a designation: single row.
    film, life
        Of its state: viscosity, static rating and static equivalent load.

    Returns
    -------
    MachineBearing or None
        None without a designation, a film or a static rating; SKF's constants for the deep-groove
        series that are on file, and for angular-contact bearings.
    """
    published = case.bearing.published
    if published is None or case.bearing.is_set or film is None or life is None:
        return None
    rating, load = float(life.ratings.static_of_set[0]), float(life.loads.static[0])
    if not (rating > 0.0 and load >= 0.0):
        return None
    from rolamento.catalogue import built_in_geometry
    from rolamento.friction import MachineBearing
    from rolamento.friction.skf import angular_contact_constants, deep_groove_series

    geometry = built_in_geometry(case.bearing.designation or "", False)
    deep = published.kind == "deep_groove"
    series = geometry.designation.series
    grease = case.lubricant is not None and case.lubricant.kind == "grease"
    return MachineBearing(
        kind=published.kind,
        bore_diameter=published.bore,
        outside_diameter=published.outside_diameter,
        kinematic_viscosity=film.kinematic_viscosity,
        static_load_rating=rating,
        static_load_ratio=load / rating,
        contact_angle=published.contact_angle or geometry.designation.contact_angle or 0.0,
        lubrication="grease" if grease else "oil_bath",
        supply="grease" if grease else "low_oil_bath",
        constants=deep_groove_series().get(series) if deep else angular_contact_constants(),
    )
