"""Standards rate a bearing as it is delivered, whatever its fits, temperatures and speed do."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.life import conditions_of
from rolamento.life.basis import Basis
from rolamento.solution import solve

_DUTY = {"inner_speed": "15000 rpm", "load": {"fx": "600 N", "fz": "500 N"}}
_FITS = {"tolerance_class": "P5", "shaft_tolerance": "js4", "shaft_bore": "30 mm"}
_WARM = {"inner_ring": "42 degC", "outer_ring": "36 degC"}


def _case(designation: str, *, mounted: bool) -> Case:
    parts = {"bearing": {"designation": designation}, "duty": _DUTY}
    if mounted:
        parts |= {"mounting": _FITS, "temperature": _WARM}
    return Case.from_mapping(parts)


@pytest.mark.parametrize("designation", ["7014C", "7014C DB L"])
def test_fits_leave_ratings_and_equivalent_load_alone(designation: str) -> None:
    plain, mounted = (solve(_case(designation, mounted=own)) for own in (False, True))
    assert mounted.rows.free_contact_angle[0, 0] < 0.8 * plain.rows.free_contact_angle[0, 0]
    free, seated = (Basis.of(solved, conditions_of(solved)) for solved in (plain, mounted))
    for name in ("dynamic_of_set", "static_of_set"):
        np.testing.assert_allclose(getattr(seated.ratings, name), getattr(free.ratings, name))
    for name in ("radial_factor", "axial_factor", "limit", "dynamic", "static"):
        found, expected = getattr(seated.loads, name), getattr(free.loads, name)
        np.testing.assert_allclose(found, expected, rtol=1e-3, err_msg=name)
    # ISO 281:2007, table 3: X of 15°, one row and two, for F_a/F_r > e
    assert seated.loads.radial_factor[0] == pytest.approx(0.72 if "DB" in designation else 0.44)
    # the balls' loads are those of the fits
    assert seated.reference.life[0] < free.reference.life[0]


@pytest.mark.parametrize("designation", ["S 6012 C", "S 6012 C DB"])
def test_warm_grooves_are_rated_cold(designation: str) -> None:
    """Ceramic balls grow less than their grooves: these open when warm, and are rated cold."""
    own = {"designation": designation, "ball_material": "Si3N4"}
    own |= {"preload": "150 N"} if "DB" in designation else {}
    plain = Case.from_mapping({"bearing": own, "duty": _DUTY})
    hot = {"inner_ring": "90 degC", "outer_ring": "80 degC"}
    warmed = {"bearing": own, "duty": _DUTY, "mounting": _FITS, "temperature": hot}
    mounted = Case.from_mapping(warmed)
    cold, *warm = (
        solve(plain),
        solve(mounted),
        solve(mounted, fz=[400.0, 500.0]),
        solve(mounted, {"bearing.inner_conformity": np.array([0.52])}),
    )
    expected = Basis.of(cold, conditions_of(cold)).ratings
    for solved in warm:
        found = Basis.of(solved, conditions_of(solved)).ratings
        for name in ("dynamic_of_set", "static_of_set"):
            rated = getattr(found, name)
            np.testing.assert_allclose(rated, getattr(expected, name)[0], rtol=1e-3, err_msg=name)


@pytest.mark.parametrize("designation", ["7014C", "7014C DB L"])
def test_a_batch_is_rated_as_its_cases_alone(designation: str) -> None:
    case = _case(designation, mounted=True)
    if case.bearing.is_set:  # that of the letters is for the listed angle
        case = case.replace(bearing=case.bearing.replace(preload="290 N"))
    angles = np.radians([13.0, 15.0])
    many = solve(case, {"bearing.contact_angle": angles})
    together = Basis.of(many, conditions_of(many))
    np.testing.assert_allclose(together.contact_angle[:, 0], angles)
    alone = solve(case.replace(bearing=case.bearing.replace(contact_angle=float(angles[1]))))
    one = Basis.of(many[1], conditions_of(many[1]))
    np.testing.assert_allclose(one.loads.dynamic, together.loads.dynamic[1])
    by_itself = Basis.of(alone, conditions_of(alone))
    np.testing.assert_allclose(by_itself.loads.dynamic, one.loads.dynamic, rtol=1e-9)
    np.testing.assert_allclose(by_itself.reference.life, one.reference.life, rtol=1e-6)
