"""Which parts of an analysis a case asks for, and which it has what they need for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rolamento.case import Case
from rolamento.solved import Solved

if TYPE_CHECKING:
    from rolamento.case.rolling_bearing import RollingBearing
    from rolamento.friction import MachineBearing
    from rolamento.life import LifeSummary
    from rolamento.lubrication import Film


def has_oil(case: Case) -> bool:
    """Whether there is an oil or a grease."""
    return case.lubricant is not None and case.lubricant.kind != "dry"


def has_life(case: Case) -> bool:
    """Whether a life is asked for: by a designation, or the [life] table."""
    return case.life is not None or case.bearing.designation is not None


def has_friction(solved: Solved) -> bool:
    """Whether the coefficient of friction is known, or a film that it may be taken by."""
    if np.isfinite(solved.field("lubricant.friction_coefficient")).any():
        return True
    if not has_oil(solved.case):
        return False
    from rolamento.lubrication.films import has_film

    return has_film(solved)


def machines_known(
    solved: Solved, found: Film | None, life: LifeSummary | None = None
) -> tuple[MachineBearing, ...]:
    """Return what the torque models of whole bearings need; empty where it is not known.

    A bearing with a mounting is designated as it was delivered. found, life: film and life of the
    cases; life may be left out.
    """
    from rolamento.friction import machines_of
    from rolamento.friction.machine import are_designated, bearings_of
    from rolamento.life.basis import static_of_bearings
    from rolamento.life.hybrid import static_share
    from rolamento.life.row_ratings import nominal_contact_angle

    case = solved.case if solved.before_mounting is None else solved.before_mounting.case
    if found is None or not are_designated(case.bearing):
        return ()
    known = None if life is None else (life.ratings, life.loads)
    rating, load = static_of_bearings(solved, known)
    # the constants of the models are for the C_0 of steel bearings: it stands for their geometry
    shares = [static_share(one) for one in bearings_of(case.bearing)]
    if rating.shape[1] == len(shares) and any(share != 1.0 for share in shares):
        listed = [_lists_static_rating(one) for one in bearings_of(case.bearing)]
        of_steel = np.where(listed, np.nan, rating / np.array(shares))  # the list's goes before
        rating = np.where(np.array(shares) == 1.0, rating, of_steel)
    return machines_of(case, found, rating, load, nominal_contact_angle(solved))


def _lists_static_rating(bearing: RollingBearing) -> bool:
    """Whether the catalogue has the C_0 of the bearing with elements of steel."""
    published = bearing.published
    return published is not None and published.static_rating is not None
