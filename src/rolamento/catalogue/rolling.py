"""How every bearing of the catalogue rolls: balls or rollers, ratio of diameters, contact angle.

All that fault frequencies need. To infer what is inside a bearing takes its ratings and up to tenths
of a second; what was inferred is kept in ``data/rolling.csv``, which ``scripts/rolling.py`` writes
anew. Of roller bearings that differ by their ribs only, it has one: NU for NJ, NUP and N.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources

from rolamento.catalogue.designation import folded
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.roller_inference import nominal_angle
from rolamento.catalogue.search import catalogue
from rolamento.geometry import apex_half_angle

__all__ = ["RollingBearing", "rolling_bearings"]


@dataclass(frozen=True, slots=True)
class RollingBearing:
    """What the fault frequencies of a bearing of the catalogue follow from.

    Attributes
    ----------
    designation
        As its maker writes it.
    ball_count
        Z, balls or rollers of a row.
    diameter_ratio
        D/d_m.
    contact_angle
        α, nominal, in rad; 0 for a deep-groove bearing, as under radial load; of tapered rollers
        the angle of their axis, α - φ.
    is_inferred
        Whether balls or rollers are inferred from the ratings, and not published.
    """

    designation: str
    ball_count: int
    diameter_ratio: float
    contact_angle: float
    is_inferred: bool


def rolling_bearings() -> tuple[RollingBearing, ...]:
    """Return the bearings of the catalogue whose inside is published, or was inferred for it.

    Others, such as those of a user's catalogue without balls, are left out.
    """
    inferred = _inferred()
    found = []
    for bearing in {folded(one.designation): one for one in catalogue().bearings}.values():
        count = bearing.roller_count if bearing.has_rollers else bearing.ball_count
        size = bearing.roller_diameter if bearing.has_rollers else bearing.ball_diameter
        if count is not None and size is not None:
            ratio = size / (bearing.pitch_diameter or bearing.mean_diameter)
            angle = _axis_angle(bearing, ratio)
            found.append(RollingBearing(bearing.designation, count, ratio, angle, False))
            continue
        key = (bearing.maker, folded(bearing.designation))
        if key in inferred:
            count, ratio = inferred[key]
            angle = _axis_angle(bearing, ratio)
            found.append(RollingBearing(bearing.designation, count, ratio, angle, True))
    return tuple(found)


def _axis_angle(bearing: CatalogueBearing, ratio: float) -> float:
    """The angle that D/d_m takes part with: α, of tapered rollers α - φ; rad."""
    angle = nominal_angle(bearing)
    if bearing.kind != "tapered":
        return angle
    return angle - float(apex_half_angle(ratio, 1.0, angle))


@lru_cache(maxsize=1)
def _inferred() -> dict[tuple[str, str], tuple[int, float]]:
    """Balls and ratio of diameters by maker and designation."""
    file = resources.files("rolamento") / "data" / "rolling.csv"
    lines = [line for line in file.read_text("utf-8").splitlines() if not line.startswith("#")]
    return {
        (row["maker"], folded(row["designation"])): (
            int(row["ball_count"]), float(row["diameter_ratio"])
        )
        for row in csv.DictReader(lines)
    }  # fmt: skip
