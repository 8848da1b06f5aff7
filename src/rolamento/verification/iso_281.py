"""Factors of ISO 281 that follow from a formula: f_c, reliability, where the axial load counts.

The limit e of the load ratio is where both lines of the equivalent load meet, (1 - X)/Y, with the
factors as the standard prints them; of two rows that face each other, (1 - X_2)/(Y_2 - Y_1).
"""

from __future__ import annotations

from collections.abc import Iterator
from math import radians
from typing import Final

from rolamento.life.equivalent_load import load_factors
from rolamento.life.reliability import reliability_factor
from rolamento.ratings import dynamic_factor_of_grooves
from rolamento.verification.check import Check, half_unit, last_unit
from rolamento.verification.published import published

__all__ = ["checks"]

_MPA: Final = 1e6
_STEEP_LOAD: Final = 1.0
"""Relative axial load at steep angles, where it does not matter; MPa."""
_OF_THE_FACTORS: Final = (
    "(1 - X)/Y with the printed factors, whose own rounding leaves the last digit open."
)
_HALF_DIGIT: Final = 0.005
"""Of the printed factors."""
_OF_TWO_ROWS: Final = (
    "(1 - X_2)/(Y_2 - Y_1) with the printed factors; the tolerance includes what their own rounding"
    " leaves open."
)


def checks() -> Iterator[Check]:
    """Compare f_c over the whole table, a_1 of both editions, and e of one row and of two."""
    data = published("iso_281")
    table = data["dynamic_factor"]
    for step, printed in enumerate(table["factors"], start=1):
        gamma = table["gamma_step"] * step
        yield Check(
            source=table["source"],
            quantity=f"f_c, γ = {gamma:.2f}",
            unit="",
            printed=printed,
            computed=float(dynamic_factor_of_grooves(gamma)),
        )
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
    for row in data["double_row"]["shallow"]:
        for load, printed in zip(ratio["relative_axial_load"], row["e"], strict=True):
            angle, source = row["contact_angle_deg"], data["double_row"]["source"]
            if printed:
                yield _load_ratio(source, angle, load, printed, double_row=True)


def _load_ratio(
    source: str, degrees: int, load: str, printed: str, *, double_row: bool = False
) -> Check:
    megapascal = float(load) if load else _STEEP_LOAD
    factors = load_factors(radians(degrees), megapascal * _MPA, double_row=double_row)
    rows = ", i = 2" if double_row else ""
    rise = float(factors.axial - factors.axial_below)
    short = 1.0 - float(factors.radial)
    room = half_unit(printed) + _HALF_DIGIT * (1.0 + 2.0 * short / rise) / rise
    return Check(
        source=source,
        quantity=f"e, {degrees}°" + (f", {load} MPa" if load else "") + rows,
        unit="",
        printed=printed,
        computed=short / rise,
        tolerance=room if double_row else last_unit(printed),
        explanation=_OF_TWO_ROWS if double_row else _OF_THE_FACTORS,
    )
