"""Radaelli (2013), tables C.1 and C.2: every printed digit of the two static examples.

What the tables do not say: C.1 takes the continuous load integral J_r(ε) (counting balls gives
4527 N), C.2 freezes the contact stiffness at the free contact angle. The stiffness constant
2.15e5 stands for a modulus of 207.518 GPa at ν = 0.3; with the rounder 207.525 GPa the last
digits of K_n, δ_r and Q(80°) differ.
"""

from __future__ import annotations

import tomllib
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento.bearing import Bearing
from rolamento.contact.hertz import hertz_coefficients
from rolamento.geometry import Race, race_curvature
from rolamento.material import Material
from rolamento.static import axial_load, radial_load, sjovall_radial

DATA = tomllib.loads(
    (Path(__file__).parent / "data" / "radaelli_2013_static.toml").read_text("utf-8")
)
NU = DATA["poisson_ratio"]
# K = √8/3 · E/(1 - ν²) · Σρ^-½ δ*^-3/2, whence the modulus behind the printed constant.
MODULUS = DATA["stiffness_constant"] * 1e6 * 3.0 / np.sqrt(8.0) * (1.0 - NU**2)
STEEL = Material(name="steel", youngs_modulus=MODULUS, poisson_ratio=NU, density=7810.0)
PER_MM = 10.0**4.5  # N/m^1.5 in a N/mm^1.5
C1, C2 = DATA["table_C1"], DATA["table_C2"]


def bearing(name: str) -> Bearing:
    given: dict[str, Any] = dict(DATA[name])
    optional: dict[str, float] = {}
    if "contact_angle_deg" in given:
        optional["contact_angle"] = np.radians(given["contact_angle_deg"])
    else:
        optional["diametral_clearance"] = given["diametral_clearance_mm"] * 1e-3
    return Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * 1e-3,
        pitch_diameter=given["pitch_diameter_mm"] * 1e-3,
        inner_conformity=given["inner_conformity"],
        outer_conformity=given["outer_conformity"],
        ring_material=STEEL,
        ball_material=STEEL,
        **optional,
    )


def assert_printed(printed: str, value: float) -> None:
    """The value rounds to the printed digits."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    half_unit = 0.5 * 10.0**exponent
    assert abs(value - float(printed)) <= half_unit * (1.0 + 1e-9), (printed, value)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_curvatures_and_dimensionless_deflection(race: Race) -> None:
    rings = bearing("bearing_209")
    conformity = rings.inner_conformity if race == "inner" else rings.outer_conformity
    curvature = race_curvature(rings.ball_diameter, rings.pitch_diameter, conformity, 0.0, race)
    assert_printed(C1[f"curvature_sum_{race}_per_mm"], float(curvature.sum) * 1e-3)
    assert_printed(C1[f"curvature_difference_{race}"], float(curvature.difference))
    star = hertz_coefficients(curvature.difference).deflection
    assert_printed(C1[f"deflection_star_{race}"], float(star))


def test_radial_example() -> None:
    state = radial_load(bearing("bearing_209"), C1["radial_load_N"])
    assert state.distribution == "continuous"
    assert_printed(C1["stiffness_inner"], float(state.stiffness.inner) / PER_MM)
    assert_printed(C1["stiffness_outer"], float(state.stiffness.outer) / PER_MM)
    assert_printed(C1["stiffness_combined"], float(state.stiffness.combined) / PER_MM)
    assert_printed(C1["load_zone_parameter"], float(state.load_zone_parameter))
    assert_printed(C1["radial_integral"], float(sjovall_radial(state.load_zone_parameter)))
    assert_printed(C1["radial_displacement_mm"], float(state.radial_displacement) * 1e3)
    assert_printed(C1["max_ball_load_N"], float(state.max_ball_load))
    loads = dict(zip(np.degrees(state.ball_azimuths).round(), state.ball_loads, strict=True))
    for azimuth, printed in C1["ball_load_N"].items():
        assert_printed(printed, float(loads[float(azimuth)]))
        assert_printed(printed, float(loads[float(-int(azimuth) % 360)]))


def test_counting_the_balls_gives_another_answer() -> None:
    """The discrete sum, which the table does not use: 4527 N and 0.06047 mm."""
    state = radial_load(bearing("bearing_209"), C1["radial_load_N"], distribution="discrete")
    assert state.max_ball_load == pytest.approx(4527.0, abs=0.5)
    assert state.radial_displacement == pytest.approx(0.06047e-3, abs=0.5e-8)


def test_axial_example() -> None:
    state = axial_load(bearing("bearing_218"), C2["axial_load_N"], stiffness_angle="free")
    assert_printed(C2["contact_angle_rad"], float(state.contact_angle))
    assert_printed(C2["axial_displacement_mm"], float(state.axial_displacement) * 1e3)
    assert_printed(C2["ball_load_N"], float(state.ball_load))
    # The angle in degrees is cut, not rounded: 41.4949° is printed 41.494.
    cut = np.floor(np.degrees(float(state.contact_angle)) * 1e3) / 1e3
    assert_printed(C2["contact_angle_deg"], float(cut))


def test_axial_example_tells_the_two_stiffnesses_apart() -> None:
    """At the loaded angle δ_a = 0.03593 mm still prints alike, but differs in the next digits."""
    frozen, loaded = (
        axial_load(bearing("bearing_218"), 17800.0, stiffness_angle=angle)
        for angle in ("free", "loaded")
    )
    difference = float(frozen.axial_displacement - loaded.axial_displacement)
    assert 1e-9 < difference < 2e-9
