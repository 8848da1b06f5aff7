"""Reads what was published: data files with the package, and the bearings that they describe."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi, radians, sqrt
from typing import Any, Final

from rolamento._data import toml_of
from rolamento.case.bearing import Bearing
from rolamento.case.material import Material

__all__ = ["MM", "MODULUS_SCALE", "RPM", "bearing_of", "modulus_of_constant", "published", "steel"]

MM: Final = 1e-3
RPM: Final = pi / 30.0
MODULUS_SCALE: Final = 3.0 / sqrt(8.0)
"""K = √8/3 · E/(1 - ν²) · Σρ^-½ δ*^-3/2 for two bodies of one material."""
_UNKNOWN_DENSITY: Final = 7810.0


def published(name: str) -> Mapping[str, Any]:
    """Return what a source prints, from its data file; not to be changed."""
    return toml_of(name, "rolamento.verification")


def modulus_of_constant(constant: float, poisson_ratio: float) -> float:
    """Return Young's modulus (Pa) that stands behind a printed constant of K in N and mm."""
    return constant * 1e6 * MODULUS_SCALE * (1.0 - poisson_ratio**2)


def steel(
    youngs_modulus: float, poisson_ratio: float, density: float = _UNKNOWN_DENSITY
) -> Material:
    """Return a source's steel; at rest its density does not matter."""
    return Material(
        name="steel", youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio, density=density
    )


def bearing_of(table: Mapping[str, Any], material: Material, **changes: float | None) -> Bearing:
    """Return the bearing of a data file's table, all of one material.

    Parameters
    ----------
    table
        In mm and degrees, as the sources print.
    material
        Of rings and balls.
    changes
        Fields of `Bearing` to be given instead (SI), None to leave one out.
    """
    fields: dict[str, Any] = {
        "ball_count": table["ball_count"],
        "ball_diameter": table["ball_diameter_mm"] * MM,
        "pitch_diameter": table["pitch_diameter_mm"] * MM,
        "inner_conformity": table["inner_conformity"],
        "outer_conformity": table["outer_conformity"],
        "ring_material": material,
    }
    if "contact_angle_deg" in table:
        fields["contact_angle"] = radians(table["contact_angle_deg"])
    if "diametral_clearance_mm" in table:
        fields["diametral_clearance"] = table["diametral_clearance_mm"] * MM
    fields |= changes
    return Bearing(**{name: value for name, value in fields.items() if value is not None})
