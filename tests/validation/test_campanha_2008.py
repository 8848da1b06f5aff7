"""Campanha (2008): the depth of the greatest shear under a ball of the 6305, and its oil film."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Load
from rolamento.geometry import Race
from rolamento.lubrication import film as film_of
from rolamento.solution import solve
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import (
    STRIBECK,
    checks,
    clearance_checks,
    inner_contact,
    right_film,
)
from rolamento.verification.check import bearing_of, published, steel

CLEARANCES = {check.quantity for check in clearance_checks()}
CHECKS = tuple(check for check in checks() if check.quantity not in CLEARANCES)
GIVEN = published("campanha_2008")["bearing_6305"]
LOAD = published("campanha_2008")["shear_depth"]["radial_load_N"]
AGREEING = {"viscosity index", "ν, 110 °C", "R, convex", "k, convex", "α", "L_10h"}
CLEARANCE = 0.013e-3  # least of class C3 for this bore, ISO 5753


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: c.quantity)
def test_printed_number(check: Check) -> None:
    assert check.verdict == ("agrees" if check.quantity in AGREEING else "explained"), check


def test_the_heaviest_ball_and_its_depth_are_those_of_the_equilibrium() -> None:
    """Stribeck's 5/Z, which leaves room for much clearance, is an upper bound."""
    material = steel(GIVEN["youngs_modulus_GPa"] * 1e9, GIVEN["poisson_ratio"])
    bearing: Bearing = bearing_of(
        {**GIVEN, "outer_conformity": GIVEN["inner_conformity"]},
        material,
        diametral_clearance=CLEARANCE,
    )
    inner = solve(Case(bearing=bearing, duty=Duty(load=Load(fz=LOAD)))).inner
    place = np.unravel_index(inner.load.argmax(), inner.load.shape)
    heaviest = float(inner.load[place])
    mean = LOAD / GIVEN["ball_count"]
    assert 4.37 * mean < heaviest < STRIBECK * mean
    check = CHECKS[0]
    assert inner.max_shear_depth[place] * 1e3 == pytest.approx(check.computed, rel=0.04)
    assert float(inner_contact(heaviest).semi_minor) == pytest.approx(
        inner.semi_minor[place], rel=1e-12
    )


def test_the_right_film_at_the_inner_race() -> None:
    film = published("campanha_2008")["film"]
    found = [right_film(film, condition) * 1e6 for condition in film["condition"]]
    assert found == pytest.approx([0.106, 0.065], abs=5e-4)


def test_the_films_of_the_equilibrium_are_of_the_same_size() -> None:
    """The bearing itself, solved, at the speed and with the viscosities that Campanha takes.

    Outer conformity 0.53. The oil is lighter at its temperature than at the 20 °C whose density
    Campanha takes, by 5 % and 7 %; the heat of shear takes 2 to 3 % of the film.
    """
    film = published("campanha_2008")["film"]
    material = steel(film["youngs_modulus_GPa"] * 1e9, GIVEN["poisson_ratio"])
    bearing: Bearing = bearing_of(
        {**GIVEN, "inner_conformity": film["groove_radius_mm"] / GIVEN["ball_diameter_mm"],
         "outer_conformity": 0.53},
        material,
        diametral_clearance=CLEARANCE,
    )  # fmt: skip
    for temperature, inner, outer in ((84.8, 0.106, 0.131), (110.0, 0.065, 0.080)):
        case = Case(
            bearing=bearing,
            duty=Duty(inner_speed="2000 rpm", load=Load(fz=LOAD)),
            lubricant="Shell Tonna S 68",
            temperature={"lubricant": temperature + 273.15},
        )
        found = film_of(solve(case))
        races: tuple[tuple[Race, float], ...] = (("inner", inner), ("outer", outer))
        for race, expected in races:
            thinnest = np.nanmin(found.of(race).central_thickness)
            assert thinnest * 1e6 == pytest.approx(expected, rel=0.08)
