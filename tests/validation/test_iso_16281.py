"""Displacements of a reference program for ISO/TS 16281, against the general solver at rest.

The program's elliptic integrals are good to 1e-5 (it is off by one unit of the last digit, 7e-6).
Under axial load the bearing turns from 0° to 13.1°: with the stiffness frozen at the free angle,
as the standard has it, the closed solution gives the program's number within 1e-6; with the
stiffness at the loaded angle, as everywhere in the equilibrium, 4.7e-5 less.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Duty, Load
from rolamento.solution import solve
from rolamento.static import axial_load
from rolamento.verification import Check
from rolamento.verification.check import published
from rolamento.verification.standards import iso_16281_bearing, iso_16281_checks

CHECKS = tuple(iso_16281_checks())
DATA = published("iso_16281")
RADIAL, AXIAL = DATA["radial"]["example"], DATA["axial"]


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source}: {c.quantity}")
def test_printed_number(check: Check) -> None:
    assert check.verdict != "fails", check


@pytest.mark.parametrize("case", RADIAL, ids=lambda case: f"clearance {case['clearance_mm']} mm")
def test_radial(case: dict[str, float]) -> None:
    solved = solve(
        Case(
            bearing=iso_16281_bearing(case["clearance_mm"]), duty=Duty(load=Load(fz=case["load_N"]))
        )
    )
    assert solved.converged.all()
    assert solved.displacement.z * 1e6 == pytest.approx(float(case["displacement_um"]), rel=1e-5)
    assert abs(solved.displacement.y) < 1e-12 * solved.displacement.z


def test_axial() -> None:
    rings, force = iso_16281_bearing(AXIAL["clearance_mm"]), AXIAL["load_N"]
    printed = float(AXIAL["displacement_um"])
    frozen = axial_load(rings, force, stiffness_angle="free").axial_displacement
    assert float(frozen) * 1e6 == pytest.approx(printed, rel=1e-6)
    solved = solve(Case(bearing=rings, duty=Duty(load=Load(fx=force))))
    assert solved.converged.all()
    assert np.degrees(solved.inner.contact_angle[0, 0]) == pytest.approx(13.07, abs=0.01)
    assert solved.displacement.x * 1e6 == pytest.approx(printed, rel=1e-4)
    short = 1.0 - float(solved.displacement.x[0]) / float(frozen)
    assert short == pytest.approx(4.6e-5, abs=0.1e-5)
