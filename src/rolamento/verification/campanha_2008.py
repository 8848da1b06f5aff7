"""A 6305 bearing: greatest shear under a ball, oil film, measured clearances, tested lives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.contact.hertz import HertzContact, effective_modulus, elliptical_contact
from rolamento.contact.subsurface import greatest_shear
from rolamento.geometry import race_curvature
from rolamento.verification import (
    campanha_2008_clearance,
    campanha_2008_film,
    campanha_2008_life,
    campanha_2008_weibull,
)
from rolamento.verification.check import Check
from rolamento.verification.published import MM, published, steel

__all__ = ["checks", "inner_contact"]

STRIBECK: Final = 5.0
"""Z times the heaviest ball's load over the radial load, with usual clearance. Stribeck (1901)."""
LINE_CONTACT_DEPTH: Final = 0.5
"""Depth over the minor semi-axis that the author takes."""
A_THIRD: Final = 1.0 / 3.0
"""Of the printed depth: the most by which the exact one may be greater."""

_WHOLE_LOAD: Final = (
    "The author puts the whole load on one ball, and the greatest shear at half the minor"
    " semi-axis. The heaviest of 8 balls carries 5/8 of the load, and the exact depth for this"
    " ellipse is nearly a third greater. Both with the conformity 0.52 of the catalogue, at the"
    " inner race."
)


def inner_contact(load: float) -> HertzContact:
    """Return the contact of a ball of the 6305 with the inner race, under a load in N."""
    given = published("campanha_2008")["bearing_6305"]
    material = steel(given["youngs_modulus_GPa"] * 1e9, given["poisson_ratio"])
    curvature = race_curvature(
        given["ball_diameter_mm"] * MM,
        given["pitch_diameter_mm"] * MM,
        given["inner_conformity"],
        0.0,
        "inner",
    )
    modulus = effective_modulus(material, material)
    return elliptical_contact(load, curvature.rolling, curvature.across, modulus)


def checks() -> Iterator[Check]:
    """Compare depth of the greatest shear, oil, film, clearances, rating, life and life tests."""
    yield _shear_depth()
    yield from campanha_2008_film.checks()
    yield from campanha_2008_clearance.checks()
    yield from campanha_2008_life.checks()
    yield from campanha_2008_weibull.checks()


def _shear_depth() -> Check:
    data = published("campanha_2008")
    given, printed = data["bearing_6305"], data["shear_depth"]
    whole = printed["radial_load_N"]
    contact = inner_contact(STRIBECK * whole / given["ball_count"])
    shear = greatest_shear(
        contact.max_pressure, contact.semi_major, contact.semi_minor, given["poisson_ratio"]
    )
    return Check(
        source=printed["source"],
        quantity="z(τ_max)",
        unit="mm",
        printed=printed["greatest_shear_depth_mm"],
        computed=float(shear.depth) / MM,
        explanation=_WHOLE_LOAD,
        deviation=A_THIRD * float(printed["greatest_shear_depth_mm"]),
        evidence=LINE_CONTACT_DEPTH * float(inner_contact(whole).semi_minor) / MM,
    )
