"""Harris's table of a*, b* and δ* against F(ρ), and his examples 6.1 and 6.5, worked by hand.

Radaelli (2013) solves the examples again, by computer: where the two differ, the number that should
have been printed is Radaelli's. Each number is given twice here: as the equilibrium of this program
has it, and as the closed analysis with the authors' choices does (the continuous load integral
J_r(ε); the contact stiffness of the free contact angle).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from math import degrees, nan, pi, radians, sin
from typing import Any, Final, NamedTuple

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.material import Material
from rolamento.contact.hertz import hertz_coefficients
from rolamento.geometry import Race, race_curvature
from rolamento.numerics.elliptic import complete
from rolamento.solution import solve
from rolamento.static import axial_load, race_stiffness, radial_load, sjovall_radial
from rolamento.units import MILLIMETRE
from rolamento.verification.check import (
    Check,
    bearing_of,
    cut,
    half_unit,
    last_unit,
    modulus_of_constant,
    published,
    steel,
)
from rolamento.words import Note

PER_MM: Final = 10.0**4.5
"""N/m^1.5 in a N/mm^1.5."""
BY_INTEGRAL: Final = 0.005
"""The most, of a number, by which the integral of 9 balls may differ from counting them."""
AZIMUTHS: Final = (0, 40, 80, 120, 160)
RACES: Final[tuple[Race, ...]] = ("inner", "outer")


class Label(NamedTuple):
    """How a quantity is called, and its unit."""

    name: str
    unit: str


class Number(NamedTuple):
    """A computed number, and what the authors' choices make of it; None if there is no choice."""

    computed: float
    by_choice: float | None = None


RADIAL: Final[Mapping[str, Label]] = {
    "curvature_sum_inner": Label("Σρ_i", "1/mm"),
    "curvature_difference_inner": Label("F(ρ_i)", ""),
    "curvature_sum_outer": Label("Σρ_o", "1/mm"),
    "curvature_difference_outer": Label("F(ρ_o)", ""),
    "deflection_star_inner": Label("δ*_i", ""),
    "deflection_star_outer": Label("δ*_o", ""),
    "stiffness_inner": Label("K_i", "N/mm^1.5"),
    "stiffness_outer": Label("K_o", "N/mm^1.5"),
    "stiffness_combined": Label("K_n", "N/mm^1.5"),
    "load_zone_parameter": Label("ε", ""),
    "radial_integral": Label("J_r(ε)", ""),
    "radial_displacement": Label("δ_r", "mm"),
    "max_ball_load": Label("Q_max", "N"),
} | {f"ball_load_{azimuth}": Label(f"Q, ψ = {azimuth}°", "N") for azimuth in AZIMUTHS}
"""Example 6.1: a 209 bearing under radial load."""

AXIAL: Final[Mapping[str, Label]] = {
    "axial_displacement": Label("δ_a", "mm"),
    "contact_angle_rad": Label("α", "rad"),
    "contact_angle_deg": Label("α", "°"),
    "ball_load": Label("Q", "N"),
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
    solved = solve(Case(bearing=bearing, duty=Duty(load=Load(fz=load))))
    azimuths = np.degrees(solved.elements.azimuth[0]).round().astype(int).tolist()
    counted = dict(zip(azimuths, solved.inner.load[0].tolist(), strict=True))
    smeared = {round(degrees(a)): float(q) for a, q in zip(
        integral.ball_azimuths, integral.ball_loads, strict=True)}  # fmt: skip
    return {
        **_contact_numbers(bearing),
        "load_zone_parameter": Number(float(integral.load_zone_parameter)),
        "radial_integral": Number(float(sjovall_radial(integral.load_zone_parameter))),
        "radial_displacement": Number(
            float(solved.displacement.z[0]) / MILLIMETRE,
            float(integral.radial_displacement) / MILLIMETRE,
        ),
        "max_ball_load": Number(max(counted.values()), float(integral.max_ball_load)),
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
    solved = solve(Case(bearing=bearing, duty=Duty(load=Load(fx=load))))
    angle = float(solved.inner.contact_angle[0, 0])
    return {
        "axial_displacement": Number(
            float(solved.displacement.x[0]) / MILLIMETRE,
            float(frozen.axial_displacement) / MILLIMETRE,
        ),
        "contact_angle_rad": Number(angle, float(frozen.contact_angle)),
        "contact_angle_deg": Number(degrees(angle), degrees(float(frozen.contact_angle))),
        "ball_load": Number(float(solved.inner.load[0, 0]), float(frozen.ball_load)),
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
        found[f"curvature_sum_{race}"] = curvature.sum * MILLIMETRE
        found[f"curvature_difference_{race}"] = curvature.difference
        found[f"deflection_star_{race}"] = hertz_coefficients(curvature.difference).deflection
        found[f"stiffness_{race}"] = getattr(stiffness, race) / PER_MM
    found["stiffness_combined"] = stiffness.combined / PER_MM
    return {key: Number(float(value)) for key, value in found.items()}


SYMBOLS: Final = {"semi_major": "a*", "semi_minor": "b*", "deflection": "δ*"}

_ABSCISSA: Final = Note("verify_harris_abscissa")
_MISPRINT: Final = Note("verify_harris_misprint")
_CUT: Final = Note("verify_harris_cut")
_LOW_DEFLECTION: Final = Note("verify_harris_low_deflection")
_INTEGRAL_BY_TABLE: Final = Note("verify_harris_integral_by_table")
_DISPLACEMENT: Final = Note("verify_harris_displacement")
_BY_HAND: Final = Note("verify_harris_by_hand")
_FROM_ANGLE: Final = Note("verify_harris_from_angle")


def checks() -> Iterator[Check]:
    """Compare the table of dimensionless parameters and both examples."""
    yield from _hertz_table()
    yield from _example_6_1()
    yield from _example_6_5()


def _hertz_table() -> Iterator[Check]:
    table = published("harris_1991")["hertz_table"]
    errata = {(e["curvature_difference"], e["column"]): e for e in table["errata"]}
    for row in table["rows"]:
        for column, printed in zip(table["columns"][1:], row[1:], strict=True):
            erratum = errata.get((row[0], column))
            yield _hertz_table_entry(table["source"], row, column, printed, erratum)


def _hertz_table_entry(
    source: str, row: list[str], column: str, printed: str, erratum: Mapping[str, Any] | None
) -> Check:
    """Compare one entry; the abscissa is rounded, too, and any number within that may be meant."""
    middle, width = float(row[0]), half_unit(row[0])
    computed, *ends = (
        float(getattr(hertz_coefficients(f), column))
        for f in (middle, middle - width, middle + width)
    )
    toward_print = max(ends) if float(printed) > computed else min(ends)
    return Check(
        source=source,
        quantity=f"{SYMBOLS[column]}, F = {row[0]}",
        unit="",
        printed=printed,
        computed=computed,
        tolerance=half_unit(printed) + abs(toward_print - computed),
        explanation=_MISPRINT if erratum else _ABSCISSA,
        evidence=_deflection_of_ellipse(row[1], row[2]) if erratum else None,
        corrected=erratum["corrected"] if erratum else "",
        deviation=float(erratum["units_off"]) * last_unit(printed) if erratum else 0.0,
    )


def _deflection_of_ellipse(semi_major: str, semi_minor: str) -> float:
    """δ* = 2 K(m) / (π a*) with m = 1 - (b*/a*)², from printed a* and b*. Harris (1991), 5."""
    a, b = float(semi_major), float(semi_minor)
    return float(2.0 * complete((b / a) ** 2)[0] / (pi * a))


def _example_6_1() -> Iterator[Check]:
    example = published("harris_1991")["example_6_1"]
    radaelli = published("radaelli_2013")["table_C1"]
    balls, integral = bearing_209().ball_count, float(example["printed"]["radial_integral"])
    heaviest = radaelli["radial_load_N"] / (balls * integral)
    found = radial_example()
    for key, printed in example["printed"].items():
        yield Check(
            source=example["source"],
            quantity=RADIAL[key].name,
            unit=RADIAL[key].unit,
            printed=printed,
            computed=found[key].computed,
            **_reason_6_1(key, printed, found[key], heaviest),
        )


def _reason_6_1(key: str, printed: str, number: Number, heaviest: float) -> dict[str, Any]:
    """Say why a number of example 6.1 differs, and what proves it; nothing where it does not.

    heaviest: Q_max = F_r/(Z J_r) with the printed J_r; N.
    """
    if key in ("curvature_difference_inner", "radial_integral"):
        evidence = cut(number.computed, printed)
        return {"explanation": _CUT, "evidence": evidence, "deviation": last_unit(printed)}
    if key.startswith(("deflection_star", "stiffness")):
        corrected = published("radaelli_2013")["table_C1"]["printed"][key]
        return {"explanation": _LOW_DEFLECTION, **_correction("table_C1", key, corrected)}
    if number.by_choice is None or float(printed) == 0.0:
        return {}
    if key == "radial_displacement":
        evidence = cut(number.by_choice, printed)
        reason: dict[str, Any] = {"explanation": _DISPLACEMENT, "evidence": evidence}
    else:
        share = number.by_choice / (radial_example()["max_ball_load"].by_choice or nan)
        reason = {"explanation": _INTEGRAL_BY_TABLE, "evidence": heaviest * share}
    return reason | {"deviation": BY_INTEGRAL * float(printed)}


def _example_6_5() -> Iterator[Check]:
    example = published("harris_1991")["example_6_5"]
    radaelli = published("radaelli_2013")
    angle = radians(float(example["printed"]["contact_angle_deg"]))
    for key, printed in example["printed"].items():
        if key == "ball_load":
            count = radaelli["bearing_218"]["ball_count"]
            load = radaelli["table_C2"]["axial_load_N"] / (count * sin(angle))
            reason: dict[str, Any] = {"explanation": _FROM_ANGLE, "evidence": load}
            reason |= {"deviation": _stated_share("table_C2", key) * float(printed)}
        else:
            corrected = example["corrected"][key]
            reason = {"explanation": _BY_HAND, **_correction("table_C2", key, corrected)}
        yield Check(
            source=example["source"],
            quantity=AXIAL[key].name,
            unit=AXIAL[key].unit,
            printed=printed,
            computed=axial_example()[key].computed,
            **reason,
        )


def _correction(table: str, key: str, corrected: str) -> dict[str, Any]:
    """Give a corrected number, and by how much the print is off as Radaelli's table states it."""
    deviation = _stated_share(table, key) * float(corrected) + half_unit(corrected)
    return {"corrected": corrected, "deviation": deviation}


def _stated_share(table: str, key: str) -> float:
    """Return the maximum difference of the two authors that rounds to the stated percentage."""
    percent = published("radaelli_2013")[table]["difference_percent"][key]
    return (float(percent) + half_unit(percent)) / 100.0
