"""What heat and lack of oil in the inlets leave of the oil's rolling resistance."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento import Case
from rolamento.analysis import analyse
from rolamento.case.roller_bearing import RollerBearing
from rolamento.friction import Friction, friction
from rolamento.lubrication.film_thickness import (
    aihara,
    murch_wilson,
    replenishment,
    skf_inlet_heating,
    thermal_loading,
)
from rolamento.solution import solve
from rolamento.solved import RACES

RPM = np.pi / 30.0
OILED: dict[str, Any] = {"lubricant": "ISO VG 32", "temperature": {"lubricant": "45 degC"}}
PAIR: dict[str, Any] = {
    "bearing": {"designation": "7014 C DB", "spacing": "20 mm", "preload": "240 N"},
    "duty": {"inner_speed": "15000 rpm", "load": {"fx": "400 N", "fz": "800 N"}},
    **OILED,
}
ROLLERS: dict[str, Any] = {
    "bearing": {"designation": "NU 210"},
    "duty": {"inner_speed": "6000 rpm", "load": {"fz": "5 kN"}},
    **OILED,
}
BALLS: dict[str, Any] = {
    "bearing": {"designation": "6210"},
    "duty": {"inner_speed": "6000 rpm", "load": {"fz": "3 kN"}},
    **OILED,
}
EVERY = pytest.mark.parametrize("case", [BALLS, ROLLERS, PAIR], ids=["balls", "rollers", "pair"])


def found(case: dict[str, Any], **film: Any) -> Friction:
    given = {**case, **({"film": film} if film else {})}
    return friction(solve(Case.from_mapping(given)), friction_coefficient=0.05, compare=False)


def resistance(case: dict[str, Any], **film: Any) -> float:
    return float(found(case, **film).torque_by_source["rolling_resistance"][0])


def test_the_two_fits_of_the_thermal_inlet_agree() -> None:
    """Goksem and Hargreaves (1978) as NSK's D-BRAIN has them, by which Aihara made his.

    K_t = exp((0.658228 + 0.0106383 L^0.3174603) ln D - 0.162625 - ln(1 + 0.411483 L^0.707071)): the
    ratio to K_t at L = 0, for dynamic loadings D of bearings.
    """
    for dynamic in (1.0, 10.0, 100.0):
        for loading in (0.05, 0.5, 2.0, 6.5, 20.0):
            ratio = dynamic ** (0.0106383 * loading**0.3174603)
            goksem = ratio / (1.0 + 0.411483 * loading**0.707071)
            assert float(aihara(loading)) == pytest.approx(goksem, rel=0.2)


def test_factors_of_heat_by_hand_and_their_limits() -> None:
    """The spindle pair of 15 000 r/min: n d_m = 1.35e6 mm/min, 26 mm²/s, L = 6.5."""
    assert float(skf_inlet_heating(26e-6, 15000 * RPM, 90e-3)) == pytest.approx(0.49, abs=0.005)
    assert float(aihara(6.5)) == pytest.approx(1.0 / (1.0 + 0.29 * 6.5**0.78))
    for factor in (aihara, murch_wilson):
        assert float(factor(0.0)) == 1.0
        left = np.asarray(factor(np.geomspace(1e-6, 1e4, 60)))
        assert np.all(np.diff(left) < 0.0)
        assert np.all((left > 0.0) & (left <= 1.0))
    assert float(skf_inlet_heating(26e-6, 0.0, 90e-3)) == 1.0


@EVERY
def test_slow_turning_is_isothermal_and_flooded(case: dict[str, Any]) -> None:
    slow = {**case, "duty": {**case["duty"], "inner_speed": "0.01 rpm"}}
    bare = resistance(slow, thermal="none")
    assert resistance(slow) == pytest.approx(bare, rel=1e-6)
    replenished = {"starvation": "replenishment", "supply": "oil_air"}
    assert resistance(slow, **replenished) == pytest.approx(bare, rel=1e-4)


@EVERY
def test_heat_and_lack_of_oil_only_take_off(case: dict[str, Any]) -> None:
    bare, warm = resistance(case, thermal="none"), resistance(case)
    bath, air = (
        resistance(case, starvation="replenishment", supply=supply)
        for supply in ("bath", "oil_air")
    )
    assert bare > warm > bath > air > 0.0
    assert resistance(case, starvation="replenishment", supply="jet") == bath
    assert resistance(case, starvation="replenishment", supply="grease") == air


@EVERY
def test_the_resistance_has_the_factors_of_the_film(case: dict[str, Any]) -> None:
    """Contact by contact: Aihara's factor at its own speed, and one of the whole bearing."""
    film = {"starvation": "replenishment", "supply": "oil_air"}
    solved = solve(Case.from_mapping({**case, "film": film}))
    oil = solved.oil
    heat = {name: found(case, **given).heat["rolling_resistance"]
            for name, given in (("bare", {"thermal": "none"}), ("all", film))}  # fmt: skip
    own = analyse(Case.from_mapping({**case, "film": film}))
    assert own.film is not None
    for race in RACES:
        u = np.abs(solved.contacts[race].entrainment)
        loading = thermal_loading(
            oil.dynamic_viscosity[0], oil.viscosity_temperature[0], u, oil.thermal_conductivity
        )
        left = aihara(loading) * own.film.of(race).starvation_factor
        bare, whole = (getattr(heat[name], race) for name in ("bare", "all"))
        loaded = bare > 0.0
        assert loaded.any()
        np.testing.assert_allclose(whole[loaded], (bare * left)[loaded], rtol=1e-12)


def test_starvation_by_an_inlet_distance_is_monotonic() -> None:
    torque = [
        resistance(BALLS, starvation="inlet_distance", inlet_distance=f"{distance} mm")
        for distance in (0.3, 0.5, 1.0, 3.0, 30.0)
    ]
    assert np.all(np.diff(torque) >= 0.0)
    assert torque[0] < 0.95 * torque[-1]
    assert torque[-1] == pytest.approx(resistance(BALLS), rel=1e-12)


def test_k_z_is_of_the_kind_of_bearing() -> None:
    """A double-row bearing and a four-point one have 3.1, a single row of angular contact 4.4."""
    for designation, constant in (("3206", 3.1), ("QJ 210", 3.1), ("7206 B", 4.4), ("1205", 4.8)):
        case = Case.from_mapping(
            {
                "bearing": {"designation": designation},
                "duty": {"inner_speed": "3000 rpm", "load": {"fz": "500 N", "fx": "500 N"}},
                "film": {"starvation": "replenishment", "supply": "bath"},
                **OILED,
            }
        )
        solved = solve(case)
        film = analyse(case).film
        assert film is not None
        bearing = case.bearing.published
        assert bearing is not None
        left = replenishment(
            solved.oil.kinematic_viscosity, 3000 * RPM, bearing.bore,
            bearing.outside_diameter, "bath", kind=constant,
        )  # fmt: skip
        assert np.nanmax(film.inner.starvation_factor) == pytest.approx(float(left[0]))


# --- what the torque is an upper bound of -------------------------------------------------------


@EVERY
def test_power_is_torque_times_speed_and_the_sum_of_the_heat(case: dict[str, Any]) -> None:
    for film in ({}, {"starvation": "replenishment", "supply": "oil_air"}):
        own = found(case, **film)
        speed = float(case["duty"]["inner_speed"].split()[0]) * RPM
        assert own.power[0] == pytest.approx(own.torque[0] * speed, rel=1e-12)
        heat = sum(loss.total[0] for loss in own.heat.values())
        assert heat == pytest.approx(own.power[0], rel=1e-12)
        assert own.torque[0] == pytest.approx(sum(p[0] for p in own.torque_by_source.values()))


def test_full_inlets_at_speed_make_an_upper_bound() -> None:
    fast = found(PAIR)
    assert fast.upper_bound[0]
    assert fast.bounds["inlets_flooded"][0]
    slow = {**PAIR, "duty": {**PAIR["duty"], "inner_speed": "300 rpm"}}
    assert not found(slow).upper_bound[0]
    assert not found(PAIR, starvation="replenishment", supply="oil_air").upper_bound[0]
    isothermal = found(PAIR, thermal="none", starvation="replenishment", supply="oil_air")
    assert list(isothermal.bounds) == ["inlets_isothermal"]
    assert isothermal.upper_bound[0]


def test_a_bound_without_a_designation_rests_on_the_rows() -> None:
    """Its sizes are not known: D - d is at least two elements, and more oil may be lacking."""
    pitch, ball = 89.82e-3, 11.90625e-3
    case = Case(**{
        "bearing": {"ball_count": 20, "ball_diameter": ball, "pitch_diameter": pitch,
                    "contact_angle": np.radians(15.0), "inner_conformity": 0.52,
                    "outer_conformity": 0.52},
        "duty": {"inner_speed": 15000 * RPM, "load": {"fx": 400.0, "fz": 300.0}},
        "lubricant": "ISO VG 32", "temperature": {"lubricant": 318.15},
    })  # fmt: skip
    own = friction(solve(case), friction_coefficient=0.05, compare=False)
    assert own.upper_bound[0]
    nu = float(solve(case).oil.kinematic_viscosity[0])
    lowest = replenishment(nu, 15000 * RPM, pitch - ball, pitch + ball, "bath", kind=4.4)
    known = replenishment(nu, 15000 * RPM, 70e-3, 110e-3, "bath", kind=4.4)
    assert float(lowest) < float(known)


def test_a_rib_without_a_film_makes_an_upper_bound() -> None:
    tapered: dict[str, Any] = {
        "bearing": {"designation": "30206"},
        "duty": {"inner_speed": "500 rpm", "load": {"fz": "4 kN", "fx": "2 kN"}},
        "lubricant": "ISO VG 68",
        "temperature": {"lubricant": "70 degC"},
    }
    assert found(tapered).bounds["rib_without_film"][0]
    rough = {"inner_roughness": "0.2 um", "outer_roughness": "0.2 um", "ball_roughness": "0.1 um"}
    own = Case.from_mapping(tapered).bearing.places[0].bearing
    assert isinstance(own, RollerBearing)
    assert own.roller_half_angle is not None
    radius = 0.95e3 * 0.5 * own.roller_diameter / np.sin(own.roller_half_angle)
    ended = {
        **tapered,
        "bearing": {"designation": "30206", "roller_end_radius": f"{radius} mm"},
        "surface": rough,
    }
    assert not found(ended).bounds["rib_without_film"][0]
