"""The speed that a maker's experience allows bearings of a series, as n d_m.

Limiting speeds of a catalogue fall with the size so that n d_m hardly changes within a series and a
contact angle. The class of a series is the mean of n d_m over bearings that the maker lists.

Source: data/speeds.toml (NSK, E1102).
"""

from __future__ import annotations

from functools import cache
from math import degrees, pi
from typing import Any, Final, NamedTuple

from rolamento.io.data import toml_of
from rolamento.types import of_balls
from rolamento.words import Note

__all__ = ["SpeedClass", "speed_class"]

_SAME_ANGLE: Final = 4.0
"""Degrees within which a contact angle is that of a class."""
_TO_SI: Final = pi / 30.0 * 1e-3


class SpeedClass(NamedTuple):
    """n d_m of a series; m/s as ω d_m.

    Attributes
    ----------
    series
        As in a designation.
    grease, oil_bath
        Limits, as ω d_m.
    high_speed
        Limit with oil mist, oil-air or a jet, cage and accuracy made for it; NaN for rollers, of
        which nothing is on file.
    source
        Where they come from.
    """

    series: str
    grease: float
    oil_bath: float
    high_speed: float
    source: Note


@cache
def _rows() -> tuple[dict[str, Any], ...]:
    return tuple(toml_of("speeds")["classes"]["series"])


def speed_class(series: str, contact_angle: float | None) -> SpeedClass | None:
    """Return the class of single bearings of a series; None where the maker lists none.

    Parameters
    ----------
    series
        Such as ``"62"``, ``"70"`` or ``"NU2"``.
    contact_angle
        Nominal, of angular-contact ball bearings; rad, None of others.
    """
    data = toml_of("speeds")["classes"]
    for row in _rows():
        angle = row.get("contact_angle_deg")
        if series not in row["series"]:
            continue
        if angle is not None and (
            contact_angle is None or abs(degrees(contact_angle) - angle) > _SAME_ANGLE
        ):
            continue
        grease, oil = (_mean(row, name) for name in ("grease", "oil"))
        rollers = row.get("rollers", False)
        kind = of_balls(angled=angle is not None).key
        high = float("nan") if rollers else oil * data[f"high_speed_{kind}"]
        bearings = ", ".join(bearing["name"] for bearing in row["bearings"])
        source = data["source_of_rollers" if rollers else "source"]
        note = Note("source_speed_class", {"source": source, "bearings": bearings})
        return SpeedClass(series, grease, oil, high, note)
    return None


def _mean(row: dict[str, Any], name: str) -> float:
    """Mean of n d_m over the bearings of a series, as ω d_m in m/s."""
    products = [one[name] * 0.5 * (one["d"] + one["D"]) for one in row["bearings"]]
    return float(_TO_SI * sum(products) / len(products))
