"""Limits of bore and outside diameter of radial bearings: ISO 492, by tolerance class."""

from __future__ import annotations

from typing import Final, Literal

from rolamento.clearance.band import Band
from rolamento.clearance.tables import MICROMETRE, step_of, table
from rolamento.errors import InputError
from rolamento.units import from_si

__all__ = ["BEARING_TOLERANCE_SOURCE", "ToleranceClass", "bore_deviations", "outside_deviations"]

ToleranceClass = Literal["normal", "P6", "P5"]
BEARING_TOLERANCE_SOURCE: Final = "ISO 492:2014"


def bore_deviations(bore: float, tolerance_class: ToleranceClass = "normal") -> Band:
    """Limits of the mean bore from nominal (m); the upper one is 0.

    Raises
    ------
    InputError
        If the bore (m) is outside over 2.5 mm to 500 mm, or to what the class covers.
    """
    return _deviations("inner", bore, "bore", tolerance_class)


def outside_deviations(diameter: float, tolerance_class: ToleranceClass = "normal") -> Band:
    """Limits of the mean outside diameter from nominal (m); the upper one is 0.

    Raises
    ------
    InputError
        If the diameter (m) is outside over 6 mm to 630 mm, or to what the class covers.
    """
    return _deviations("outer", diameter, "outside_diameter", tolerance_class)


def _deviations(ring: str, diameter: float, field: str, tolerance_class: str) -> Band:
    data = table("iso492")[ring]
    if tolerance_class not in data or tolerance_class == "sizes_mm":
        known = ", ".join(name for name in data if name != "sizes_mm")
        raise InputError(
            f"must be one of {known}",
            field="tolerance_class",
            value=tolerance_class,
            example='tolerance_class = "normal"',
        )
    standard = BEARING_TOLERANCE_SOURCE
    step = step_of(diameter, data["sizes_mm"], field=field, standard=standard)
    if step >= len(data[tolerance_class]):
        raise InputError(
            f"has no table for {field} = {from_si(diameter, 'length')} here",
            field="tolerance_class",
            value=tolerance_class,
            example='tolerance_class = "normal"',
        )
    return Band(-data[tolerance_class][step] * MICROMETRE, 0.0)
