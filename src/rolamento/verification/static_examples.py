"""Examples 6.1 and 6.5 of Harris (1991), which Radaelli (2013) solves again: what we get.

Both authors print the same quantities, Harris by hand and Radaelli by computer. Each number is
given twice here: as the equilibrium of this program has it, and as the closed analysis with the
authors' choices does (the continuous load integral J_r(ε); the contact stiffness of the free
contact angle).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from math import degrees, nan
from typing import Any, Final, NamedTuple

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.material import Material
from rolamento.contact.hertz import hertz_coefficients
from rolamento.geometry import Race, race_curvature
from rolamento.rows.ball import solve
from rolamento.state import State
from rolamento.static import axial_load, race_stiffness, radial_load, sjovall_radial
from rolamento.verification.published import MM, bearing_of, modulus_of_constant, published, steel

__all__ = [
    "AXIAL",
    "BY_INTEGRAL",
    "RADIAL",
    "Number",
    "Quantity",
    "axial_example",
    "bearing_209",
    "bearing_218",
    "radaelli_steel",
    "radial_example",
]

PER_MM: Final = 10.0**4.5
"""N/m^1.5 in a N/mm^1.5."""
BY_INTEGRAL: Final = 0.005
"""The most, of a number, by which the integral of 9 balls may differ from counting them."""
AZIMUTHS: Final = (0, 40, 80, 120, 160)
RACES: Final[tuple[Race, ...]] = ("inner", "outer")


class Quantity(NamedTuple):
    """How a quantity is called, and its unit."""

    name: str
    unit: str


class Number(NamedTuple):
    """A computed number, and what the authors' choices make of it; None if there is no choice."""

    computed: float
    by_choice: float | None = None


RADIAL: Final[Mapping[str, Quantity]] = {
    "curvature_sum_inner": Quantity("Σρ_i", "1/mm"),
    "curvature_difference_inner": Quantity("F(ρ_i)", ""),
    "curvature_sum_outer": Quantity("Σρ_o", "1/mm"),
    "curvature_difference_outer": Quantity("F(ρ_o)", ""),
    "deflection_star_inner": Quantity("δ*_i", ""),
    "deflection_star_outer": Quantity("δ*_o", ""),
    "stiffness_inner": Quantity("K_i", "N/mm^1.5"),
    "stiffness_outer": Quantity("K_o", "N/mm^1.5"),
    "stiffness_combined": Quantity("K_n", "N/mm^1.5"),
    "load_zone_parameter": Quantity("ε", ""),
    "radial_integral": Quantity("J_r(ε)", ""),
    "radial_displacement": Quantity("δ_r", "mm"),
    "max_ball_load": Quantity("Q_max", "N"),
} | {f"ball_load_{azimuth}": Quantity(f"Q, ψ = {azimuth}°", "N") for azimuth in AZIMUTHS}
"""Example 6.1: a 209 bearing under radial load."""

AXIAL: Final[Mapping[str, Quantity]] = {
    "axial_displacement": Quantity("δ_a", "mm"),
    "contact_angle_rad": Quantity("α", "rad"),
    "contact_angle_deg": Quantity("α", "°"),
    "ball_load": Quantity("Q", "N"),
}
"""Example 6.5: a 218 bearing under axial load."""


def radaelli_steel(youngs_modulus: float | None = None) -> Material:
    """Return the steel of Radaelli's constant 2.15e5, or with another modulus (Pa)."""
    data = published("radaelli_2013")
    nu = data["poisson_ratio"]
    modulus = modulus_of_constant(data["stiffness_constant"], nu)
    return steel(modulus if youngs_modulus is None else youngs_modulus, nu, data["density"])


def bearing_209(**changes: float | None) -> Bearing:
    """Return the bearing of Radaelli's table 5.1, which is that of example 6.1."""
    return bearing_of(published("radaelli_2013")["bearing_209"], radaelli_steel(), **changes)


def bearing_218(youngs_modulus: float | None = None, **changes: float | None) -> Bearing:
    """Return the bearing of Radaelli's table 5.2, which is that of example 6.5."""
    material = radaelli_steel(youngs_modulus)
    return bearing_of(published("radaelli_2013")["bearing_218"], material, **changes)


@cache
def radial_example() -> Mapping[str, Number]:
    """Solve example 6.1; by the keys of `RADIAL`, in their units."""
    load = published("radaelli_2013")["table_C1"]["radial_load_N"]
    bearing = bearing_209()
    integral = radial_load(bearing, load)
    state = solve(Case(bearing=bearing, duty=Duty(load=Load(fz=load))))
    counted = _load_by_azimuth(state)
    smeared = {round(degrees(a)): float(q) for a, q in zip(
        integral.ball_azimuths, integral.ball_loads, strict=True)}  # fmt: skip
    return {
        **_contact_numbers(bearing),
        "load_zone_parameter": Number(float(integral.load_zone_parameter)),
        "radial_integral": Number(float(sjovall_radial(integral.load_zone_parameter))),
        "radial_displacement": Number(
            state.displacement.z / MM, float(integral.radial_displacement) / MM
        ),
        "max_ball_load": Number(max(counted.values(), default=nan), float(integral.max_ball_load)),
        **{
            f"ball_load_{azimuth}": Number(counted.get(azimuth, nan), smeared[azimuth])
            for azimuth in AZIMUTHS
        },
    }


@cache
def axial_example() -> Mapping[str, Number]:
    """Solve example 6.5; by the keys of `AXIAL`, in their units."""
    load = published("radaelli_2013")["table_C2"]["axial_load_N"]
    bearing = bearing_218()
    frozen = axial_load(bearing, load, stiffness_angle="free")
    state = solve(Case(bearing=bearing, duty=Duty(load=Load(fx=load))))
    ball = state.balls[0].inner if state.balls else None
    angle = ball.contact_angle if ball else nan
    return {
        "axial_displacement": Number(
            state.displacement.x / MM, float(frozen.axial_displacement) / MM
        ),
        "contact_angle_rad": Number(angle, float(frozen.contact_angle)),
        "contact_angle_deg": Number(degrees(angle), degrees(float(frozen.contact_angle))),
        "ball_load": Number(ball.load if ball else nan, float(frozen.ball_load)),
    }


def _contact_numbers(bearing: Bearing) -> dict[str, Number]:
    """Curvatures, dimensionless deflection and stiffness of both races at contact angle zero."""
    found: dict[str, Any] = {}
    stiffness = race_stiffness(bearing, 0.0)
    for race in RACES:
        conformity = bearing.inner_conformity if race == "inner" else bearing.outer_conformity
        curvature = race_curvature(
            bearing.ball_diameter, bearing.pitch_diameter, conformity, 0.0, race
        )
        found[f"curvature_sum_{race}"] = curvature.sum * MM
        found[f"curvature_difference_{race}"] = curvature.difference
        found[f"deflection_star_{race}"] = hertz_coefficients(curvature.difference).deflection
        found[f"stiffness_{race}"] = getattr(stiffness, race) / PER_MM
    found["stiffness_combined"] = stiffness.combined / PER_MM
    return {key: Number(float(value)) for key, value in found.items()}


def _load_by_azimuth(state: State) -> dict[int, float]:
    """Loads on the inner contacts by azimuth in whole degrees."""
    return {round(degrees(ball.azimuth)): ball.inner.load for ball in state.balls}
