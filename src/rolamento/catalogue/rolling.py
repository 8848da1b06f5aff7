"""How every bearing of the catalogue rolls: balls, ratio of diameters and contact angle.

All that fault frequencies need. To infer the balls of a bearing takes its ratings and tenths of a
second; what was inferred is kept in ``data/rolling.csv``, which ``scripts/rolling.py`` writes anew.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources

from rolamento.catalogue.designation import folded
from rolamento.catalogue.search import catalogue

__all__ = ["RollingBearing", "rolling_bearings"]


@dataclass(frozen=True, slots=True)
class RollingBearing:
    """What the fault frequencies of a bearing of the catalogue follow from.

    Attributes
    ----------
    designation
        As its maker writes it.
    ball_count
        Z, of a row.
    diameter_ratio
        D/d_m.
    contact_angle
        α, nominal, in rad; 0 for a deep-groove bearing, as under radial load.
    is_inferred
        Whether the balls are inferred from the ratings, and not published.
    """

    designation: str
    ball_count: int
    diameter_ratio: float
    contact_angle: float
    is_inferred: bool


def rolling_bearings() -> tuple[RollingBearing, ...]:
    """Return the bearings of the catalogue whose balls are published, or were inferred for it.

    Others, such as those of a user's catalogue without balls, are left out.
    """
    inferred = _inferred()
    found = []
    for bearing in {folded(one.designation): one for one in catalogue().bearings}.values():
        angle = bearing.contact_angle or 0.0
        count, ball = bearing.ball_count, bearing.ball_diameter
        if count is not None and ball is not None:
            ratio = ball / (bearing.pitch_diameter or bearing.mean_diameter)
            found.append(RollingBearing(bearing.designation, count, ratio, angle, False))
            continue
        key = (bearing.maker, folded(bearing.designation))
        if key in inferred:
            count, ratio = inferred[key]
            found.append(RollingBearing(bearing.designation, count, ratio, angle, True))
    return tuple(found)


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
