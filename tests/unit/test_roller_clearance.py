"""Fits, temperatures and speeds on roller bearings: first principles, limits, symmetries."""

from __future__ import annotations

from itertools import pairwise
from math import atan, cos, pi, tan
from typing import Any

import numpy as np
import pytest

from rolamento import Case, InputError, load_case, parse_case
from rolamento.case import case_of
from rolamento.case.roller_bearing import RollerBearing
from rolamento.clearance import (
    CLEARANCE_CLASSES,
    class_clearance,
    clearance_of_case,
    operating_case,
)
from rolamento.clearance.chain import raceways
from rolamento.io.data import toml_of
from rolamento.solution import solve
from rolamento.system.mounted import preload_stages, running_set
from rolamento.system.preload import preload_of
from rolamento.tasks.clearance import mounted_clearance, mounted_samples

RPM = pi / 30.0
ALPHA = 12.5e-6

NU = """
[bearing]
element = "cylindrical"
roller_count = 16
roller_diameter = "11 mm"
effective_length = "11.4 mm"
pitch_diameter = "70.5 mm"
diametral_clearance = "0.05 mm"
[mounting]
bore = "50 mm"
outside_diameter = "90 mm"
[duty]
inner_speed = "0 rpm"
[duty.load]
fz = "5 kN"
"""
PAIR = """
[bearing]
element = "tapered"
roller_count = 24
roller_diameter = "6.4 mm"
effective_length = "13 mm"
pitch_diameter = "54.5 mm"
contact_angle = "14 deg"
roller_half_angle = "1.5 deg"
roller_profile = "none"
arrangement = "DB"
spacing = "60 mm"
preload = { offset = "8 um" }
[mounting]
bore = "40 mm"
outside_diameter = "68 mm"
[duty.load]
fx = "0 N"
"""
ANGLE, HALF, D, DM = 14.0 * pi / 180.0, 1.5 * pi / 180.0, 6.4e-3, 54.5e-3
ACROSS = D * cos(ANGLE - HALF)


def nu(**fields: Any) -> Case:
    return parse_case(NU).with_({key.replace("__", "."): v for key, v in fields.items()})


def pair(**fields: Any) -> Case:
    return parse_case(PAIR).with_({key.replace("__", "."): v for key, v in fields.items()})


def clearance(case: Case) -> float:
    return clearance_of_case(case).mean


def offset(case: Case) -> float:
    """How far the first row is pressed in, as it runs."""
    return preload_stages(case)[-1].offset[0]


# --- classes --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("bore", "name", "low", "high"),
    [
        (25, "CN", 20, 45),
        (50, "C3", 50, 80),
        (50, "C2", 5, 35),
        (100, "C4", 105, 140),
        (24, "CC", 20, 30),
        (500, "CC5", 625, 720),
        (40, "CM", 15, 30),
        (200, "CT", 65, 105),
    ],
)
def test_classes_of_rollers_as_nsk_prints_them(
    bore: float, name: str, low: float, high: float
) -> None:
    """NSK, Rolling Bearings (E1102e), tables 9.14 and 9.13.2."""
    band = class_clearance(1e-3 * bore, name, "cylindrical")
    assert (band.low * 1e6, band.high * 1e6) == pytest.approx((low, high))


def test_classes_rise_and_grow_with_the_bore() -> None:
    data = toml_of("iso5753", "rolamento.clearance")["cylindrical"]
    steps = len(data["bore_mm"]) - 1
    for names in (CLEARANCE_CLASSES, ("CC1", "CC2", "CC", "CC3", "CC4", "CC5")):
        for first, second in pairwise(names):
            for lower, upper in zip(data["classes"][first], data["classes"][second], strict=True):
                assert not lower or not upper or (lower[0] < upper[0] and lower[1] < upper[1])
    for name, pairs in data["classes"].items():
        full = [band for band in pairs if band]
        assert len(pairs) == steps, name
        assert all(low < high for low, high in full)
        assert full == sorted(full, key=lambda band: band[1])


def test_classes_that_a_kind_of_bearing_does_not_have() -> None:
    with pytest.raises(InputError, match="must be one of C2, CN"):
        class_clearance(0.025, "CC3")
    with pytest.raises(InputError, match=r"9\.13\.2"):
        class_clearance(0.3, "CM", "cylindrical")
    with pytest.raises(InputError, match="set at mounting") as error:
        clearance_of_case(pair(bearing__arrangement=None, bearing__spacing=None,
                               bearing__preload=None, mounting__clearance_class="C3"))  # fmt: skip
    assert error.value.field == "mounting.clearance_class"


# --- one row --------------------------------------------------------------------------------------


def test_the_inner_fit_grows_the_raceway_by_makers_formula() -> None:
    """One material and a solid shaft: ΔF = δ d/F, NSK E1102, chapter 15.2."""
    case = nu(mounting__clearance_class="C3", mounting__shaft_interference=13.5e-6)
    found = clearance_of_case(case)
    raceway = 70.5e-3 - 11e-3
    assert found.mean == pytest.approx(65e-6 - 13.5e-6 * 50e-3 / raceway, rel=1e-12)
    assert found.steps[0].source.values["name"] == "C3"


def test_the_outer_fit_and_a_massive_housing() -> None:
    """ΔE = δ E/D with a massive housing of the same steel."""
    found = clearance(nu(mounting__housing_interference=10e-6))
    assert found == pytest.approx(50e-6 - 10e-6 * 81.55e-3 / 90e-3, rel=1e-12)


def test_rollers_as_warm_as_their_inner_ring() -> None:
    """-α ΔT (d_pw + D_we), the makers' rule; as warm as each other, all grows like the rings."""
    warm = nu(temperature__inner_ring=353.15, temperature__outer_ring=343.15)
    grown = 50e-6 * (1.0 + 50.0 * ALPHA)
    assert clearance(warm) == pytest.approx(grown - ALPHA * 10.0 * 81.5e-3, rel=1e-9)
    even = nu(temperature__inner_ring=353.15, temperature__outer_ring=353.15)
    assert clearance(even) == pytest.approx(50e-6 * (1.0 + 60.0 * ALPHA), rel=1e-12)


def test_a_reading_is_the_clearance() -> None:
    found = clearance_of_case(nu(mounting__measured_clearance=45e-6))
    assert [step.name for step in found.steps] == ["initial"]
    assert found.mean == 45e-6
    with pytest.raises(InputError, match="applies to ball bearings"):
        clearance_of_case(nu(mounting__measured_clearance=45e-6, mounting__measuring_load=50.0))


def test_solve_takes_the_clearance_in_operation() -> None:
    case = nu(mounting__clearance_class="CN", mounting__shaft_tolerance="k5")
    running = operating_case(case)
    assert running.bearing.diametral_clearance == clearance(case)
    one, plain = solve(case), solve(running)
    assert one.displacement.z[0] == pytest.approx(plain.displacement.z[0], rel=1e-12)
    assert one.rollers is not None


def test_each_case_of_a_batch_is_as_solved_alone() -> None:
    values = np.array([5e-6, 20e-6, np.nan])
    case = nu(mounting__shaft_interference=1e-6)
    batch = solve(case, {"mounting.shaft_interference": values})
    for index, value in enumerate(values[:2]):
        alone = solve(nu(mounting__shaft_interference=value))
        assert batch.displacement.z[index] == pytest.approx(alone.displacement.z[0], rel=1e-9)
    assert not batch.converged[2]


def test_too_tight_a_fit_closes_the_bearing() -> None:
    with pytest.raises(InputError, match="closes the bearing"):
        operating_case(nu(mounting__shaft_interference=0.5e-3))
    with pytest.raises(InputError, match="must be less than the diameter of the inner raceway"):
        clearance_of_case(nu(mounting__bore=60e-3))
    assert not solve(nu(), {"mounting.shaft_interference": np.array([0.5e-3])}).converged[0]


def test_a_single_tapered_row_only_moves_its_first_contact() -> None:
    case = pair(bearing__arrangement=None, bearing__spacing=None, bearing__preload=None,
                mounting__shaft_interference=10e-6)  # fmt: skip
    assert operating_case(case).bearing == case.bearing
    (note,) = mounted_clearance(case).notes
    fall = 10e-6 * 40e-3 / (DM - ACROSS)
    assert note.values["shift"] == pytest.approx(0.5 * fall / tan(ANGLE), rel=1e-9)


def test_a_needle_bearing_without_inner_ring_has_no_fits(tmp_path: Any) -> None:
    path = tmp_path / "hk.toml"
    path.write_text('[bearing]\ndesignation = "HK 2516"\ndiametral_clearance = "20 um"\n'
                    '[mounting]\nshaft_tolerance = "k5"\n[duty.load]\nfz = "1 kN"\n')  # fmt: skip
    with pytest.raises(InputError, match="the shaft is the inner raceway"):
        clearance_of_case(load_case(path))


# --- sets of tapered rows -------------------------------------------------------------------------


def test_fits_press_a_pair_in_by_half_their_growth_times_the_cotangent() -> None:
    grown = 10e-6 * 40e-3 / (DM - ACROSS) + 6e-6 * (DM + ACROSS) / 68e-3
    case = pair(mounting__shaft_interference=10e-6, mounting__housing_interference=6e-6)
    assert offset(case) == pytest.approx(8e-6 + 0.5 * grown / tan(ANGLE), rel=1e-9)


@pytest.mark.parametrize(("arrangement", "sign"), [("DB", -1.0), ("DF", 1.0)])
def test_temperatures_follow_timkens_rule(arrangement: str, sign: float) -> None:
    """Two rows lose α ΔT (d_o cot α ± L) of their axial play: + face to face, - back to back.

    Shaft, inner rings and rollers ΔT warmer than the rest; d_o/2 cot α of each row, L the distance
    of the rows; without a width shaft and housing make it. The Timken Company, Mounting, fitting
    and setting your bearings, chapter E 2.2.
    """
    case = pair(
        bearing__arrangement=arrangement,
        temperature__inner_ring=333.15,
        temperature__outer_ring=313.15,
    )
    lost = ALPHA * 20.0 * ((DM + ACROSS) / tan(ANGLE) + sign * 60e-3)
    assert 2.0 * (offset(case) - 8e-6) == pytest.approx(lost, rel=1e-3)


def test_what_is_as_warm_everywhere_changes_nothing() -> None:
    case = pair(temperature__inner_ring=353.15, temperature__outer_ring=353.15)
    assert offset(case) == pytest.approx(8e-6, rel=1e-9)


def test_springs_keep_their_force() -> None:
    case = pair(bearing__preload={"spring": 400.0}, mounting__shaft_interference=12e-6)
    stages = preload_stages(case)
    assert [stage.preload[1] for stage in stages] == pytest.approx([400.0, 400.0], rel=1e-6)


def test_the_running_set_is_the_mounted_one() -> None:
    case = pair(mounting__shaft_interference=6e-6, duty__load__fx=200.0, duty__load__fz=800.0)
    running = running_set(case)
    assert running.mounting is None
    assert isinstance(running.bearing, RollerBearing)
    one, plain = solve(case), solve(running)
    assert one.converged[0]
    assert one.displacement.x[0] == pytest.approx(plain.displacement.x[0], rel=1e-6)
    assert one.displacement.z[0] == pytest.approx(plain.displacement.z[0], rel=1e-6)


def test_scatter_of_the_rows_of_a_pair() -> None:
    case = pair(mounting__shaft_tolerance="k5", mounting__housing_tolerance="J7")
    drawn = mounted_samples(case, 2000, 1)
    limits = clearance_of_case(case.replace(bearing=case.bearing.places[0].bearing))
    assert limits.minimum <= drawn.clearance.min() <= drawn.clearance.max() <= limits.maximum


# --- preload --------------------------------------------------------------------------------------


def test_a_pair_of_straight_rollers_lifts_off_at_two_to_the_ten_ninths() -> None:
    """Where the force goes with δ^n, the load that lifts a row is 2^n times the preload."""
    case = pair(mounting=None, bearing__preload={"force": 500.0}, duty__load__fx=500.0)
    found = preload_of(case)
    assert found is not None
    assert found.at_rest == pytest.approx(500.0, rel=1e-6)
    assert found.lift_factor == pytest.approx(2.0 ** (10.0 / 9.0), rel=1e-5)
    assert found.loss_factor == found.lift_factor
    opposite = preload_of(case.with_({"duty.load.fx": -500.0}))
    assert opposite is not None
    assert opposite.lift_factor == pytest.approx(found.lift_factor, rel=1e-5)
    assert {found.lift_row, opposite.lift_row} == {0, 1}


def test_crowned_rollers_lift_off_later() -> None:
    """Their line of contact grows with the load, and ends with it: n falls toward 10/9."""

    def lift(preload: float) -> float:
        case = pair(mounting=None, bearing__roller_profile="iso",
                    bearing__preload={"force": preload}, duty__load__fx=preload)  # fmt: skip
        found = preload_of(case)
        assert found is not None
        return found.lift_factor

    light, heavy = lift(300.0), lift(30e3)
    assert 2.0 ** (10.0 / 9.0) < heavy < light


MIXED = """
[bearing]
element = "ball"
[[bearing.rows]]
element = "ball"
orientation = "-"
position = "-30 mm"
ball_count = 14
ball_diameter = "12.7 mm"
pitch_diameter = "70 mm"
contact_angle = "40 deg"
inner_conformity = 0.52
outer_conformity = 0.53
[[bearing.rows]]
element = "ball"
orientation = "+"
position = "-10 mm"
[[bearing.rows]]
element = "cylindrical"
position = "40 mm"
roller_count = 16
roller_diameter = "11 mm"
effective_length = "11.4 mm"
pitch_diameter = "70.5 mm"
diametral_clearance = "40 um"
[duty.load]
fx = "1 kN"
fz = "6 kN"
[mounting]
bore = "50 mm"
outside_diameter = "90 mm"
shaft_interference = "10 um"
[bearing.preload]
force = "400 N"
"""


def test_balls_and_rollers_on_one_shaft() -> None:
    """The roller row carries no preload, and its clearance falls by its own raceway's growth."""
    case = parse_case(MIXED)
    running = running_set(case)
    assert running.bearing.rows is not None
    row = running.bearing.rows[2]
    assert row.diametral_clearance == pytest.approx(40e-6 - 10e-6 * 50.0 / 59.5, rel=1e-6)
    plain = preload_of(case.replace(mounting=None))
    assert plain is not None
    assert plain.at_rest == pytest.approx(400.0, rel=1e-6)
    solved = solve(case)
    assert solved.converged[0]
    load = solved.rows.load[0]
    assert load[:, 0].sum() == pytest.approx(1000.0, rel=1e-8)
    assert load[:, 2].sum() == pytest.approx(6000.0, rel=1e-8)
    assert abs(load[2, 0]) < 1e-6 * 1000.0
    assert solved.rows.element == ("ball", "ball", "cylindrical")
    assert atan(load[2, 2] / 6000.0) > 0.0


@pytest.mark.parametrize(
    ("designation", "low", "high"),
    [("NU 210/C3", 50, 80), ("NU 210 CC3", 50, 65), ("NU210CM", 20, 35), ("NA 4910 CC", 30, 45)],
)
def test_the_class_of_a_designation(designation: str, low: float, high: float) -> None:
    case = case_of(designation, ["mounting.shaft_interference=0 um"])
    first = clearance_of_case(case).steps[0]
    assert first.clearance == pytest.approx((1e-6 * low, 0.5e-6 * (low + high), 1e-6 * high))


@pytest.mark.parametrize("text", [NU, PAIR])
def test_a_roller_and_the_clearance_fill_what_lies_between_the_raceways(text: str) -> None:
    """Rollers whose circle is given stand on the inner ring."""
    row = parse_case(text).bearing.places[0].bearing
    inner, outer, across, clearance = raceways(row)
    assert outer - inner == pytest.approx(2.0 * across + clearance, abs=1e-15)
    assert inner + across == pytest.approx(row.pitch_diameter, abs=1e-15)
    assert clearance == (row.diametral_clearance or 0.0)
