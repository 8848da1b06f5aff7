"""Campanha (2008): the depth of the greatest shear under a ball of the 6305."""

from __future__ import annotations

import pytest

from rolamento import Bearing, Case, Duty, Load, solve
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import STRIBECK, checks, inner_contact
from rolamento.verification.published import bearing_of, published, steel

CHECKS = tuple(checks())
GIVEN = published("campanha_2008")["bearing_6305"]
LOAD = published("campanha_2008")["shear_depth"]["radial_load_N"]
CLEARANCE = 0.013e-3  # least of class C3 for this bore, ISO 5753


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: c.quantity)
def test_printed_number(check: Check) -> None:
    assert check.verdict == "explained", check


def test_the_heaviest_ball_and_its_depth_are_those_of_the_equilibrium() -> None:
    """Stribeck's 5/Z, which leaves room for much clearance, is an upper bound."""
    material = steel(GIVEN["youngs_modulus_GPa"] * 1e9, GIVEN["poisson_ratio"])
    bearing: Bearing = bearing_of(
        {**GIVEN, "outer_conformity": GIVEN["inner_conformity"]},
        material,
        diametral_clearance=CLEARANCE,
    )
    state = solve(Case(bearing=bearing, duty=Duty(load=Load(fz=LOAD))))
    heaviest = max((ball.inner for ball in state.balls), key=lambda contact: contact.load)
    mean = LOAD / GIVEN["ball_count"]
    assert 4.37 * mean < heaviest.load < STRIBECK * mean
    (check,) = CHECKS
    assert heaviest.max_shear_depth * 1e3 == pytest.approx(check.computed, rel=0.04)
    assert float(inner_contact(heaviest.load).semi_minor) == pytest.approx(
        heaviest.semi_minor, rel=1e-12
    )
