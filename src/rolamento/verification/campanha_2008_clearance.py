"""Clearance classes, and what the measuring load adds to a clearance, of Campanha's table.

The table gives one number for a range of bores and a class of clearance, and follows from the
radial equilibrium of usual bearings with a ball under the load: the least clearances share the load
among several balls, the wide ones leave it all to one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from rolamento.case.bearing import Bearing
from rolamento.case.material import Material
from rolamento.clearance.classes import CLEARANCE_CLASSES, class_clearance
from rolamento.clearance.measuring_load import measuring_load_correction
from rolamento.verification.check import Check
from rolamento.verification.published import MM, bearing_of, published

__all__ = ["checks", "measured_bearing"]

_MICROMETRE: Final = 1e-6
_NO_NAMES: Final = (
    "The table does not name its bearings: for each range of bores a usual one that fits is taken,"
    " with a ball under the load; C2 at both ends of its range, the other classes in the middle of"
    " theirs. Other bearings of the same range come out up to 2 µm away."
)


def checks() -> Iterator[Check]:
    """Compare the corrections and the classes."""
    data = published("campanha_2008")
    for row in data["measuring_load"]["row"]:
        yield from _corrections(data["measuring_load"]["source"], row)
    for printed in data["clearance_class"]:
        yield from _class(printed)


def measured_bearing(row: Mapping[str, Any]) -> Bearing:
    """Return the bearing that stands for a row of the table; its clearance is zero."""
    conformity = published("campanha_2008")["measuring_load"]["conformity"]
    return bearing_of(
        {**row, "inner_conformity": conformity, "outer_conformity": conformity},
        Material.named("100Cr6"),
        diametral_clearance=0.0,
    )


def _corrections(source: str, row: Mapping[str, Any]) -> Iterator[Check]:
    bearing = measured_bearing(row)
    for name in CLEARANCE_CLASSES:
        band = class_clearance(row["bore_mm"] * MM, name)
        printed = row[f"{name}_um"]
        clearances = (band.middle,) if len(printed) == 1 else band
        for number, clearance in zip(printed, clearances, strict=True):
            yield Check(
                source=f"{source}, {row['load_N']:g} N",
                quantity=f"ΔP_d, {row['bearing']} {name}",
                unit="µm",
                printed=number,
                computed=measuring_load_correction(bearing, clearance, row["load_N"]) / _MICROMETRE,
                explanation=_NO_NAMES,
            )


def _class(printed: Mapping[str, Any]) -> Iterator[Check]:
    band = class_clearance(printed["bore_mm"] * MM, printed["class"])
    for which, number, limit in zip(("min", "max"), printed["range_um"], band, strict=True):
        yield Check(
            source=printed["source"],
            quantity=f"P_d {which}, {printed['bearing']} {printed['class']}",
            unit="µm",
            printed=number,
            computed=limit / _MICROMETRE,
        )
