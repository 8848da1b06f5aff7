"""Cylindrical roller thrust bearings: equilibrium, ratings, friction, refusals."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import rolamento as ro
from rolamento.analysis.speed_limits import speed_limits
from rolamento.catalogue import catalogue, geometry_of
from rolamento.catalogue.roller_inference import inferred_rollers
from rolamento.contact.line import EXPONENT, pair_constant
from rolamento.errors import InputError
from rolamento.friction.skf import series_constants, skf_moment
from rolamento.ratings import roller_dynamic_rating
from rolamento.ratings.rollers import roller_static_rating

FLAT: dict[str, Any] = {
    "element": "cylindrical", "kind": "thrust", "roller_count": 24, "roller_diameter": 0.0075,
    "effective_length": 0.0072, "pitch_diameter": 0.064, "roller_profile": "none",
}  # fmt: skip


def of(**changes: Any) -> ro.RollerBearing:
    return ro.RollerBearing(**{**FLAT, **changes})


def test_an_axial_load_is_shared_evenly() -> None:
    solved = ro.solve(of(), fx=20e3, inner_speed=100.0)
    assert solved.inner.load[0] == pytest.approx(20e3 / 24, rel=1e-9)
    assert solved.outer.load[0] == pytest.approx(20e3 / 24, rel=1e-9)  # F_c goes to the cage
    assert solved.inner.contact_angle[0] == pytest.approx(np.pi / 2)
    modulus = float(solved.rows.modulus[0, 0])
    constant = float(pair_constant(0.0072, modulus))
    assert solved.displacement.x[0] == pytest.approx(
        (20e3 / 24 / constant) ** (1.0 / EXPONENT), rel=1e-6
    )


def test_a_moment_is_held_by_the_circle_of_rollers() -> None:
    """At first order K_m = ½ K_x (d_pw/2)², and the rollers' own tilting stiffness."""
    solved = ro.solve(of(), fx=20e3)
    stiffness = solved.stiffness.array[0]
    circle = 0.5 * stiffness[0, 0] * 0.032**2
    own = stiffness[3, 3] / circle - 1.0
    assert 0.0 < own < 0.02
    assert stiffness[3, 3] == pytest.approx(stiffness[4, 4], rel=1e-9)
    tilted = ro.solve(of(), fx=20e3, my=5.0)
    assert tilted.displacement.ry[0] == pytest.approx(5.0 / stiffness[3, 3], rel=0.01)
    assert tilted.load.my[0] == pytest.approx(5.0, rel=1e-9)


@pytest.mark.parametrize("load", [{"fx": -1e3}, {"fx": 20e3, "fz": 1e3}, {"fz": 1e3}])
def test_flat_washers_hold_no_other_load(load: dict[str, float]) -> None:
    solved = ro.solve(of(), **load)
    assert solved.status.code[0] == "no_equilibrium"
    assert solved.advice[0] is not None
    assert solved.advice[0].key.startswith("thrust_")
    assert "ball" not in str(solved.advice[0])
    assert "groove" not in str(solved.advice[0])
    assert np.isnan(solved.displacement.array).all()


def test_nothing_is_noted_of_directions_that_washers_do_not_hold() -> None:
    assert not [n for n in ro.solve(of(), fx=20e3).notes[0] if n.key.startswith("direction")]


def test_it_is_rated_for_axial_load() -> None:
    case = ro.Case(bearing=of(), duty={"inner_speed": "1000 rpm", "load": {"fx": "20 kN"}})
    found = ro.rating_life(case)
    shape = (24, 0.0075, 0.0072, 0.064, np.pi / 2)
    dynamic = float(roller_dynamic_rating(*shape, thrust=True))
    assert float(found.ratings.dynamic[0, 0]) == pytest.approx(dynamic)
    static = float(roller_static_rating(*shape, thrust=True))
    assert static == pytest.approx(1e6 * 220.0 * 24 * 0.0075 * 0.0072)
    hours = float(found.theories["iso281"].hours[0])
    assert hours * 6e4 == pytest.approx(1e6 * (dynamic / 20e3) ** (10.0 / 3.0), rel=1e-6)


def test_the_ends_of_the_rollers_slip() -> None:
    """Uniform load: P = μ F ω l/4 of each race at the relative speed ω/2."""
    case = ro.Case(
        bearing=of(),
        duty={"inner_speed": "1000 rpm", "load": {"fx": "20 kN"}},
        lubricant={"kind": "dry", "friction_coefficient": 0.1},
    )
    torque = ro.friction_torque(case)
    exact = 2.0 * 0.1 * 20e3 * 0.5 * 0.0072 / 4.0
    assert float(torque.torque_by_source["rolling_slip"][0]) == pytest.approx(exact, rel=2e-3)


def test_formula_of_skf_by_hand() -> None:
    made = skf_moment(
        series_constants("cylindrical_thrust"), speed=1000 * np.pi / 30, bore_diameter=0.05,
        outside_diameter=0.07, kinematic_viscosity=40e-6, radial_load=0.0, axial_load=20e3,
        supply="bath",
    )  # fmt: skip
    rolling = 2.25e-6 * 60.0**2.38 * 20e3**0.31 * 40e3**0.6
    assert made.rolling == pytest.approx(1e-3 * made.inlet_heating * made.replenishment * rolling)
    sliding = 0.154 * 60.0**0.62 * 20e3 * made.sliding_coefficient
    assert made.sliding == pytest.approx(1e-3 * sliding)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"diametral_clearance": 10e-6}, "diametral_clearance"),
        ({"contact_angle": 1.2}, "contact_angle"),
        ({"element": "needle"}, "kind"),
        ({"arrangement": "DB", "spacing": 0.02}, "arrangement"),
    ],
)
def test_what_flat_washers_have_not_is_refused(changes: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        of(**changes)
    assert caught.value.field == field


THRUST = [one for one in catalogue().bearings if one.kind == "cylindrical_thrust"]


def test_those_of_the_list_are_rated_by_their_rollers() -> None:
    """C_a by ISO 281 and C_0a by ISO 76, of rollers whose diameter SKF and NSK print."""
    assert len(THRUST) == 54 + 57
    for one in THRUST:
        assert geometry_of(one.designation).bearing == one
        found = inferred_rollers(one)[0]
        assert found.reproduces, one.designation
        assert found.roller_diameter == pytest.approx(one.roller_diameter)
        assert found.effective_length < one.section_height


def test_one_by_its_designation() -> None:
    case = ro.Case(bearing={"designation": "81110"}, duty={"load": {"fx": "10 kN"}})
    bearing = case.bearing
    assert isinstance(bearing, ro.RollerBearing)
    assert bearing.bearing_type.key == "cylindrical_thrust"
    assert bearing.row_angle == pytest.approx(np.pi / 2)
    solved = ro.solve(bearing, fx=10e3, inner_speed=100.0)
    assert solved.inner.load[0] == pytest.approx(10e3 / bearing.roller_count, rel=1e-9)
    speeds = speed_limits(case)
    assert {"no_reference_coefficients"} <= {note.key for note in speeds.notes}
    assert ro.fault_frequencies(bearing).notes[0].key == "rollers_slide_on_washers"
