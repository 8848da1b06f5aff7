"""Life, ratings and friction of double-row, four-point, self-aligning and thrust ball bearings."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty
from rolamento.friction.palmgren import friction_load, palmgren
from rolamento.friction.skf import constants_by_series, series_constants, skf_moment
from rolamento.life import LifeSummary, life
from rolamento.life.equivalent_load import minimum_axial_load
from rolamento.solution import solve
from rolamento.units import RPM
from rolamento.vibration import frequencies_of


def life_of(designation: str, speed: float = 100.0, **load: float) -> LifeSummary:
    duty = Duty(inner_speed=speed, load=load)
    return life(solve(Case(bearing=Bearing.named(designation), duty=duty)))


def notes(summary: LifeSummary, theory: str = "iso281") -> set[str]:
    return {name for name, where in summary[theory].notes.items() if where[0]}


def test_the_listed_rating_is_that_of_the_bearing() -> None:
    found = life_of("3206", fz=3000.0)
    assert found.ratings.dynamic_of_set[0] == pytest.approx(31e3)
    assert found.ratings.static_of_set[0] == pytest.approx(22.2e3)
    assert found["iso281"].life[0] == pytest.approx((31.0 / 3.0) ** 3)
    given = Case(
        bearing=Bearing.named("1210"), duty=Duty(load={"fz": 2000.0}),
        life={"dynamic_rating": 25e3, "static_rating": 9e3},
    )  # fmt: skip
    ratings = life(solve(given)).ratings
    assert ratings.dynamic_of_set[0] == pytest.approx(25e3)
    assert ratings.static_of_set[0] == pytest.approx(9e3)


def test_a_pair_of_single_rows_still_counts_by_the_row() -> None:
    pair = Bearing.named("7218B", arrangement="DB", spacing=0.03)
    given = Case(
        bearing=pair, duty=Duty(load={"fz": 20e3, "fx": 5e3}), life={"dynamic_rating": 1e5}
    )
    found = life(solve(given)).ratings
    assert found.dynamic_of_set[0] == pytest.approx(2**0.7 * 1e5)


@pytest.mark.parametrize("load", [3000.0, 5700.0, 9000.0])
def test_life_of_a_four_point_bearing_is_that_of_its_axial_rating(load: float) -> None:
    """(C_a/F_a)^3 with NSK's C_a of 57 kN."""
    found = life_of("QJ 210", fx=load)
    assert found["iso281"].life[0] == pytest.approx((57e3 / load) ** 3, rel=0.02)
    ratio = found["iso16281"].life[0] / found["iso281"].life[0]
    assert 1.0 < ratio < 2.1  # the contact angle rises; Y has an uneven share of the load in it


def test_both_sides_of_a_four_point_bearing_live_alike() -> None:
    there, back = (life_of("QJ 210", fx=sign * 5000.0) for sign in (1.0, -1.0))
    assert there["iso16281"].life == pytest.approx(back["iso16281"].life, rel=1e-6)
    assert there["iso281"].life == pytest.approx(back["iso281"].life)


def test_reference_life_of_a_self_aligning_bearing_is_near_its_rating_life() -> None:
    found = life_of("1210", fz=3000.0)
    assert found.ratings.dynamic_of_set[0] == pytest.approx(22.8e3)
    closed = Case(
        bearing=Bearing.named("1210", diametral_clearance=1e-9),
        duty=Duty(inner_speed=1.0, load={"fz": 3000.0}),
    )
    none = life(solve(closed))
    assert none["iso16281"].life[0] == pytest.approx(none["iso281"].life[0], rel=0.02)
    assert found["iso16281"].life[0] < none["iso16281"].life[0]
    assert found.limit.race[0] == "outer"  # the sphere is the weaker race
    assert "open_grooves" not in notes(found)


def test_life_of_a_thrust_bearing() -> None:
    found = life_of("51210", fx=8000.0)
    assert found["iso281"].life[0] == pytest.approx((49.0 / 8.0) ** 3)
    assert found["iso16281"].life[0] == pytest.approx((49.0 / 8.0) ** 3, rel=1e-3)
    assert found.loads.static[0] == pytest.approx(8000.0)
    assert found.loads.safety[0] == pytest.approx(111.0 / 8.0)
    assert not notes(found) & {"open_grooves", "thrust_bearing", "no_equivalent_load"}


def test_a_thrust_bearing_needs_axial_load() -> None:
    """NSK, page A98: C_0a/100 (n/n_max)² and C_0a/1000."""
    assert float(minimum_axial_load(111e3, 1480.0, 3600.0)) == pytest.approx(187.6, abs=0.1)
    assert float(minimum_axial_load(111e3, 100.0, 3600.0)) == pytest.approx(111.0)
    assert float(minimum_axial_load(111e3, 5000.0)) == pytest.approx(111.0)
    speed = 1480.0 * RPM
    assert "axial_load_too_small" in notes(life_of("51210", speed, fx=180.0))
    assert "axial_load_too_small" not in notes(life_of("51210", speed, fx=200.0))


def test_radial_load_on_a_thrust_bearing_is_named() -> None:
    found = life_of("51210", fx=8000.0, fz=1000.0)
    assert "radial_load_left_out" in notes(found)
    assert found["iso16281"].life[0] < 0.8 * found["iso281"].life[0]


def test_frequencies_at_a_right_angle() -> None:
    """Both washers are passed Z/2 times a turn, the cage turns half as fast as the shaft."""
    duty = Duty(inner_speed=100.0, load={"fx": 8000.0})
    found = frequencies_of(solve(Case(bearing=Bearing.named("51210"), duty=duty)))
    assert found.ball_pass_outer.order == pytest.approx(8.5)
    assert found.ball_pass_inner.order == pytest.approx(8.5)
    assert found.cage.order == pytest.approx(0.5)


def test_palmgren_of_the_kinds() -> None:
    assert float(friction_load(500.0, 2000.0, "thrust", np.pi / 2)) == 2000.0
    angle = np.radians(10.0)
    expected = 0.9 * 1000.0 / np.tan(angle) - 10.0
    assert float(friction_load(100.0, 1000.0, "self_aligning", angle)) == pytest.approx(expected)
    found = palmgren(
        kind="thrust", lubrication="oil_bath", speed=100.0, mean_diameter=0.064,
        kinematic_viscosity=30e-6, radial_load=0.0, axial_load=8000.0, static_load_ratio=8 / 111,
    )  # fmt: skip
    oil = 1e-10 * 1.5 * (30.0 * 100.0 / RPM) ** (2 / 3) * 64.0**3
    load = 0.0008 * (8 / 111) ** 0.33 * 8000.0 * 0.064
    assert float(found.total[0]) == pytest.approx(oil + load)


def test_skf_of_self_aligning_and_thrust_bearings_by_hand() -> None:
    place = {
        "speed": 1500 * RPM, "bore_diameter": 50e-3, "outside_diameter": 78e-3,
        "kinematic_viscosity": 30e-6,
    }  # fmt: skip
    thrust = skf_moment(series_constants("thrust"), **place, radial_load=0.0, axial_load=8000.0)
    factor = thrust.inlet_heating * thrust.replenishment
    rolling = 1.03e-6 * 64.0**1.83 * 8000.0**0.54 * (30 * 1500) ** 0.6
    assert thrust.rolling == pytest.approx(1e-3 * rolling * factor)
    sliding = 1.6e-2 * 64.0**0.05 * 8000.0 ** (4 / 3)
    assert thrust.sliding == pytest.approx(1e-3 * sliding * thrust.sliding_coefficient)
    aligning = skf_moment(
        constants_by_series("self_aligning")["22"], **place, radial_load=2000.0, axial_load=300.0
    )
    thrown = 3.12e-12 * 64.0**3.5 * 1500.0**2
    rolling = 3.13e-7 * 64.0**2 * (2000.0 + thrown + 5.54 * 300.0) ** 0.54 * (30 * 1500) ** 0.6
    factor = aligning.inlet_heating * aligning.replenishment
    assert aligning.rolling == pytest.approx(1e-3 * rolling * factor)


@pytest.mark.parametrize("designation", ["3206", "QJ 210", "1210", "51210"])
def test_friction_models_of_lubricated_bearings_take_the_kinds(designation: str) -> None:
    from rolamento.analysis import analyse

    load = {"fx": 3000.0} if designation in ("QJ 210", "51210") else {"fz": 3000.0}
    case = Case(
        bearing=Bearing.named(designation),
        duty=Duty(inner_speed=150.0, load=load),
        lubricant={"base_oil": "ISO VG 68", "friction_coefficient": 0.08},
        temperature={"lubricant": 333.15},
    )
    models = analyse(solve(case)).friction.models
    assert {"palmgren", "skf"} <= models.keys()
    totals = [float(models[name].total[0]) for name in ("palmgren", "skf")]
    assert 0.4 < totals[0] / totals[1] < 2.5


@pytest.mark.parametrize(
    ("kind", "angle", "most"),
    [("thrust", "90 deg", 0.54), ("thrust", "60 deg", 0.54), ("", "40 deg", 0.53)],
)
def test_ratings_have_no_step_where_grooves_open(kind: str, angle: str, most: float) -> None:
    """C and C_0 fall from the conformity on up to which the tables hold, without a step."""

    def rated(conformity: float) -> tuple[float, float]:
        own = {"ball_count": 15, "ball_diameter": "11 mm", "pitch_diameter": "65 mm"}
        own |= {"contact_angle": angle} | ({"kind": kind} if kind else {})
        grooves = {"inner_conformity": conformity if kind else min(conformity, 0.52)}
        grooves["outer_conformity"] = conformity
        bearing = Case(bearing=own | grooves, duty={"load": {"fx": "5 kN"}})
        found = life(solve(bearing)).ratings
        return float(found.dynamic[0, 0]), float(found.static[0, 0])

    inside, edge, beyond = rated(most - 1e-6), rated(most + 1e-6), rated(most + 0.01)
    assert edge == pytest.approx(inside, rel=1e-4)
    assert beyond[0] < 0.995 * inside[0]
    assert beyond[1] <= inside[1]
