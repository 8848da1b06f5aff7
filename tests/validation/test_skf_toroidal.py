"""SKF's CARB toroidal roller bearings: what axial displacement takes off the radial clearance.

SKF, General catalogue (6000 RU), pages 796 to 811: C_red = k_2 s²/B, k_2 printed of every bearing.
The chain of arcs has it as s²/(R_o + R_i - D_we).
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, solve
from rolamento.case import RollerBearing
from rolamento.catalogue import catalogue, geometry_of
from rolamento.catalogue.geometry import middle_clearance
from rolamento.catalogue.roller_inference import inferred_rollers

TOROIDAL = [one for one in catalogue().bearings if one.kind == "toroidal"]


def test_all_of_the_list_that_a_designation_finds() -> None:
    assert len(TOROIDAL) == 179
    assert sum(one.is_full_complement for one in TOROIDAL) == 76
    for one in TOROIDAL:
        assert geometry_of(one.designation).bearing == one


@pytest.mark.parametrize("designation", ["C 2318", "C 3044 M", "C 4028 V", "C 31/500 M"])
def test_what_axial_displacement_takes_off_the_clearance(designation: str) -> None:
    duty = {
        "inner_speed": "0 rpm",
        "load": {"fz": "100 N"},
        "displacement": {"x": "0 mm", "ry": 0.0, "rz": 0.0},
    }
    case = Case(bearing={"designation": designation}, duty=duty)
    bearing = geometry_of(designation).bearing
    assert bearing.clearance_factor is not None
    assert bearing.width is not None
    places = np.array([0.0, 5e-4, 1e-3, 2e-3])
    solved = solve(case, {"duty.displacement.x": places})
    assert solved.converged.all()
    drop = solved.displacement.array[:, 2]
    taken = 2.0 * (drop[0] - drop)
    printed = bearing.clearance_factor * places**2 / bearing.width
    assert taken == pytest.approx(printed, rel=3e-3)


def test_a_bearing_by_its_designation() -> None:
    case = Case(
        bearing={"designation": "C 2210 V/C4"},
        duty={"inner_speed": "500 rpm", "load": {"fx": "0 N", "fz": "10 kN"}},
    )
    assert isinstance(case.bearing, RollerBearing)
    assert case.bearing.bearing_type.key == "toroidal"
    assert case.bearing.diametral_clearance == middle_clearance(0.05, "C4", "toroidal")
    tapered = geometry_of("C 3044 K/C3")  # 220 mm: 288 to 363 µm; a cylindrical bore 262 to 337
    assert tapered.fields["diametral_clearance"] == pytest.approx(325.5e-6)
    assert geometry_of("C 3044/C3").fields["diametral_clearance"] == pytest.approx(299.5e-6)
    assert tapered.idle == ()
    solved = solve(case)
    assert solved.converged.all()
    assert solved.load.array[0, 2] == pytest.approx(1e4, rel=1e-9)


def test_rollers_have_both_printed_ratings() -> None:
    """C by ISO 281, 15 % more for SKF's Explorer class, and C_0 by ISO 76, as printed."""
    for one in TOROIDAL:
        found = inferred_rollers(one)[0]
        assert found.reproduces, one.designation
        assert one.width is not None
        assert found.effective_length < one.width
        assert found.filling > (0.93 if one.is_full_complement else 0.75), one.designation
