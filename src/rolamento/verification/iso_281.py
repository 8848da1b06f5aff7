"""Factors of ISO 281 that follow from a formula: reliability, and where the axial load counts.

The limit e of the load ratio is where both lines of the equivalent load meet, (1 - X)/Y, with the
factors as the standard prints them.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import radians
from typing import Final

from rolamento.life.equivalent_load import load_factors
from rolamento.life.reliability import reliability_factor
from rolamento.verification.check import Check, last_unit
from rolamento.verification.published import published

__all__ = ["checks"]

_MPA: Final = 1e6
_STEEP_LOAD: Final = 1.0
"""Relative axial load at steep angles, where it does not matter; MPa."""
_OF_THE_FACTORS: Final = (
    "(1 - X)/Y with the printed factors, whose own rounding leaves the last digit open."
)


def checks() -> Iterator[Check]:
    """Compare a_1 of both editions, and e of single rows."""
    data = published("iso_281")
    for table in data["reliability"]:
        for percent, printed in zip(table["percent"], table["factor"], strict=True):
            yield Check(
                source=table["source"],
                quantity=f"a_1, {percent} %",
                unit="",
                printed=printed,
                computed=float(reliability_factor(float(percent) / 100.0, table["edition"])),
            )
    ratio = data["load_ratio"]
    for row in ratio["shallow"]:
        for load, printed in zip(ratio["relative_axial_load"], row["e"], strict=True):
            yield _load_ratio(ratio["source"], row["contact_angle_deg"], load, printed)
    for angle, printed in zip(ratio["steep_angle_deg"], ratio["steep_e"], strict=True):
        yield _load_ratio(ratio["source"], angle, "", printed)


def _load_ratio(source: str, degrees: int, load: str, printed: str) -> Check:
    megapascal = float(load) if load else _STEEP_LOAD
    factors = load_factors(radians(degrees), megapascal * _MPA)
    return Check(
        source=source,
        quantity=f"e, {degrees}°" + (f", {load} MPa" if load else ""),
        unit="",
        printed=printed,
        computed=float((1.0 - factors.radial) / factors.axial),
        tolerance=last_unit(printed),
        explanation=_OF_THE_FACTORS,
    )
