"""How every bearing of the catalogue rolls: balls or rollers, ratio of diameters and angle.

All that fault frequencies need. To infer the inside of a bearing takes its ratings and tenths of a
second; what was inferred is kept in ``data/rolling.csv``, which ``scripts/rolling.py`` writes anew.
"""

from __future__ import annotations

import csv
from functools import lru_cache
from importlib import resources

from rolamento.catalogue.designation import folded
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.roller_inference import nominal_angle
from rolamento.catalogue.search import catalogue
from rolamento.geometry import apex_half_angle
from rolamento.records import frozen

__all__ = ["RollingBearing", "rolling_bearings"]


@frozen
class RollingBearing:
    """What the fault frequencies of a bearing of the catalogue follow from.

    Attributes
    ----------
    designation
        As its maker writes it.
    element_count
        Z, balls or rollers of a row.
    diameter_ratio
        D/d_m.
    angle
        That of γ = D cos α/d_m, in rad: α, nominal, of balls, 0 for a deep-groove bearing, as under
        radial load; of rollers that of their axis.
    is_inferred
        Whether what rolls is inferred from the ratings, and not published.
    """

    designation: str
    element_count: int
    diameter_ratio: float
    angle: float
    is_inferred: bool


def rolling_bearings(*, of_rollers: bool = False) -> tuple[RollingBearing, ...]:
    """Return the ball or roller bearings of the catalogue whose inside is known or was inferred.

    Others, such as those of a user's catalogue without balls, are left out.
    """
    inferred = _inferred()
    found = []
    for bearing in {folded(one.designation): one for one in catalogue().bearings}.values():
        if bearing.has_rollers is not of_rollers:
            continue
        known = _published(bearing)
        inside = known or inferred.get((bearing.maker, folded(bearing.designation)))
        if inside is not None:
            angle = _angle(bearing, inside[1])
            found.append(RollingBearing(bearing.designation, *inside, angle, known is None))
    return tuple(found)


def _published(bearing: CatalogueBearing) -> tuple[int, float] | None:
    """Number of balls or rollers, and ratio of diameters."""
    count, size = (
        (bearing.roller_count, bearing.roller_diameter)
        if bearing.has_rollers
        else (bearing.ball_count, bearing.ball_diameter)
    )
    if count is None or size is None:
        return None
    return count, size / (bearing.pitch_diameter or bearing.mean_diameter)


def _angle(bearing: CatalogueBearing, ratio: float) -> float:
    if not bearing.has_rollers:
        return bearing.contact_angle or 0.0
    angle = nominal_angle(bearing)
    return angle if bearing.type.washers else angle - float(apex_half_angle(ratio, 1.0, angle))


@lru_cache(maxsize=1)
def _inferred() -> dict[tuple[str, str], tuple[int, float]]:
    """Balls or rollers, and ratio of diameters, by maker and designation."""
    file = resources.files("rolamento") / "data" / "rolling.csv"
    lines = [line for line in file.read_text("utf-8").splitlines() if not line.startswith("#")]
    return {
        (row["maker"], folded(row["designation"])): (
            int(row["element_count"]), float(row["diameter_ratio"])
        )
        for row in csv.DictReader(lines)
    }  # fmt: skip
