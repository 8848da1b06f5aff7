"""How a roller lies between its races before they are pressed flat: tilt, profiles, overlap."""

from __future__ import annotations

from math import cos, sin
from typing import TYPE_CHECKING, NamedTuple

from rolamento.case.profile import Profile
from rolamento.case.roller_bearing import RollerBearing, raceway_radii
from rolamento.contact.profile import drop
from rolamento.numerics import FloatArray

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

__all__ = ["RollerOutline", "roller_outline"]


class RollerOutline(NamedTuple):
    """A roller's outline and those of its races over its length; (slices,), m.

    A taper is taken out, of barrel-shaped rollers the curvature of the outer race.

    place: from the roller's middle, toward +x of its row. drop: of its profile. inner, outer: how
    far it overlaps the races; below zero a gap. tilt, ring_tilt: slope of its axis and of the inner
    ring at its azimuth, positive where that +x end stands outward (rad).
    """

    place: FloatArray
    drop: FloatArray
    inner: FloatArray
    outer: FloatArray
    tilt: float
    ring_tilt: float


def roller_outline(solved: Solved, roller: int) -> RollerOutline:
    """Return how a roller of a single case lies between its races.

    Parameters
    ----------
    solved
        One case with a result.
    roller
        Which of the elements, a roller.

    Returns
    -------
    RollerOutline
        The overlap of a slice is the approach of the roller's middle, less what tilt and the
        profiles of roller and race take away there (ISO/TS 16281:2008, 4.2.2).
    """
    rollers = solved.rollers
    assert rollers is not None
    place = rollers.slice_place[0, roller]
    number = int(solved.elements.row[roller])
    row, sign = solved.case.bearing.places[number].bearing, float(solved.rows.sign[number])
    assert isinstance(row, RollerBearing)

    def dropped(profile: Profile) -> FloatArray:
        return drop(
            profile,
            place,
            length=row.effective_length,
            diameter=row.roller_diameter,
            tapered=row.bearing_type.crowned_whole,
        )

    if row.bearing_type.barrels:
        # what they have in common with the outer raceway is taken out, as a taper is
        profile, inner_race, outer_race = (float(radius) for radius in raceway_radii(row))
        own = 0.5 * place**2 * (1.0 / profile - 1.0 / outer_race)
        hollow = 0.5 * place**2 * (1.0 / inner_race - 1.0 / outer_race)
        races = {"inner": -hollow, "outer": 0.0 * place}
    else:
        own = dropped(row.roller_profile)
        races = {"inner": dropped(row.inner_profile), "outer": dropped(row.outer_profile)}
    tilt, azimuth = float(rollers.tilt[0, roller]), float(solved.elements.azimuth[0, roller])
    ry, rz = float(solved.displacement.ry[0]), float(solved.displacement.rz[0])
    ring = sign * (rz * sin(azimuth) - ry * cos(azimuth))
    slopes = {"inner": ring - tilt, "outer": tilt}
    inner, outer = (
        float(solved.contacts[race].approach[0, roller]) + slopes[race] * place - own - races[race]
        for race in ("inner", "outer")
    )
    return RollerOutline(place, own, inner, outer, tilt, ring)
