"""Seals and oil bath: the formulas beside an independent evaluation, limits, letters, heat."""

from __future__ import annotations

from math import acos, pi, sin

import numpy as np
import pytest

from rolamento import Case, InputError, analyse
from rolamento.case import case_of
from rolamento.case.losses import Losses
from rolamento.friction.seals import drag_moment, fitted_seal, seal_moment

MOTOR = {
    "duty.load.fz": "1 kN",
    "duty.inner_speed": "1500 rpm",
    "lubricant": "ISO VG 100",
    "temperature.lubricant": "70 degC",
}
RPM = pi / 30.0


def motor(designation: str, **more: object) -> Case:
    return case_of(designation, {**MOTOR, **more})


@pytest.mark.parametrize(
    ("seal", "outside", "counterface", "expected"),
    [
        ("rs1", 52.0, 34.35, 0.023 * 34.35**2.25 + 2.0),
        ("rs1", 72.0, 50.0, 0.018 * 50.0**2.25 + 20.0),
        ("rs1", 90.0, 60.0, 0.018 * 60.0**2.25 + 15.0),
        ("rs1", 110.0, 69.0, 0.018 * 69.0**2.25),
        ("rsh", 52.0, 32.7, 0.028 * 32.7**2.25 + 2.0),
        ("rsl", 47.0, 28.8, 0.0018 * 28.8**2.25),
        ("rsl", 22.0, 14.0, 0.0),
    ],
)
def test_seals_of_deep_groove_bearings(
    seal: str, outside: float, counterface: float, expected: float
) -> None:
    found = seal_moment("deep_groove", seal, 1e-3 * outside, 1e-3 * counterface)
    assert 1e3 * found == pytest.approx(expected)


def test_one_seal_has_half_but_rsl_does_not() -> None:
    both, one = (seal_moment("deep_groove", "rs1", 0.052, 0.034, n) for n in (2, 1))
    assert one == pytest.approx(0.5 * both)
    low, alone = (seal_moment("deep_groove", "rsl", 0.047, 0.029, n) for n in (2, 1))
    assert alone == low


def test_what_is_not_in_the_table_is_nan() -> None:
    assert np.isnan(seal_moment("deep_groove", "rsh", 0.11, 0.07))
    assert np.isnan(seal_moment("tapered", "rs1", 0.08, 0.05))


def test_three_seals_are_refused() -> None:
    with pytest.raises(InputError, match="1 or 2"):
        seal_moment("deep_groove", "rs1", 0.052, 0.034, 3)


def by_hand(n: float, nu: float, level: float, d: float, outside: float) -> float:
    """Drag of a deep-groove bearing, N mm; V_M 5.5e-4 at H = d_m/2."""
    mean = 0.5 * (d + outside)
    spread = 3.1 * (d + outside) / (outside - d)
    t = 2.0 * acos((0.6 * mean - level) / (0.6 * mean))
    wetted = 0.36 * mean**2 * (t - sin(t)) * 0.05 * spread
    stirred = 0.4 * 5.5e-4 * spread * 1e-12 * mean**5 * n**2
    return float(
        stirred + 1.093e-7 * n**2 * mean**3 * (n * mean**2 * sin(0.5 * t) / nu) ** -1.379 * wetted
    )


def test_drag_of_balls_by_hand() -> None:
    found = drag_moment(
        "deep_groove", speed=3000.0 * RPM, bore_diameter=0.05, outside_diameter=0.11,
        kinematic_viscosity=46e-6, oil_level=0.04,
    )  # fmt: skip
    assert 1e3 * float(found) == pytest.approx(by_hand(3000.0, 46.0, 40.0, 50.0, 110.0))


BATH = {"bore_diameter": 0.05, "outside_diameter": 0.09, "kinematic_viscosity": 46e-6}


@pytest.mark.parametrize("kind", ["deep_groove", "cylindrical", "tapered", "spherical"])
def test_drag_grows_with_level_and_speed_and_is_nothing_at_rest(kind: str) -> None:
    def drag(speed: float, level: float) -> float:
        return float(drag_moment(kind, speed=speed, oil_level=level, width=0.02, **BATH))

    levels = [drag(300.0, level) for level in (0.0, 0.005, 0.02, 0.04, 0.07)]
    assert levels[0] == 0.0
    assert np.all(np.diff(levels) > 0.0)
    assert drag(0.0, 0.02) == 0.0
    assert drag(600.0, 0.02) > 1.5 * drag(300.0, 0.02)


def test_the_bearing_is_full_at_1_2_times_the_mean_diameter() -> None:
    full, more = (
        drag_moment("deep_groove", speed=300.0, oil_level=level, **BATH) for level in (0.084, 1.0)
    )
    assert full == more


def test_rollers_need_a_width() -> None:
    with pytest.raises(InputError, match="width"):
        drag_moment("cylindrical", speed=300.0, oil_level=0.02, **BATH)


@pytest.mark.parametrize(
    ("designation", "seal", "number", "alike"),
    [("6310-2RS1/C3", "rs1", 2, False), ("6205-2RSH", "rsh", 2, False),
     ("6205DDU", "rs1", 2, True), ("6205LLU", "rs1", 2, True)],
)  # fmt: skip
def test_the_designation_says_which_seals(
    designation: str, seal: str, number: int, alike: bool
) -> None:
    assert fitted_seal(case_of(designation).bearing, Losses()) == (seal, number, alike)


@pytest.mark.parametrize("designation", ["6310", "6310-2Z", "6205-2RZ"])
def test_open_and_shielded_bearings_have_no_contact_seals(designation: str) -> None:
    assert fitted_seal(case_of(designation).bearing, Losses()) is None
    assert analyse(motor(designation)).seals_and_bath is None


def test_what_is_given_goes_before_the_designation() -> None:
    bearing = case_of("6310-2RS1").bearing
    assert fitted_seal(bearing, Losses(seal="none")) == ("none", 2, False)
    given = motor("6310-2RS1", **{"losses.seal_moment": "30 N mm"})
    found = analyse(given).seals_and_bath
    assert found is not None
    assert found.seal[0] == pytest.approx(0.030)


def test_the_estimated_counterface_is_that_of_the_print() -> None:
    """SKF's 6205: d_1 34.35 mm, and the recess d_2 32.7 mm."""
    found = analyse(motor("6205-2RS1")).seals_and_bath
    assert found is not None
    (note,) = [one for one in found.notes if one.key == "seal_diameter_estimated"]
    assert 1e3 * note.values["diameter"] == pytest.approx(34.35, rel=0.02)


def test_power_is_torque_times_speed() -> None:
    found = analyse(motor("6310-2RS1", **{"losses.oil_level": "9.5 mm"})).seals_and_bath
    assert found is not None
    assert found.drag[0] > 0.0
    assert found.power == pytest.approx(found.torque * 1500.0 * RPM)


def test_the_heat_balance_counts_them() -> None:
    from rolamento.heat import heat_balance

    del_temperature = {"temperature": None, "heat.shaft_ambient": "5 W/K",
                       "heat.housing_ambient": "10 W/K"}  # fmt: skip
    plain, sealed = (
        heat_balance(motor(name).with_(del_temperature)) for name in ("6310", "6310-2RS1")
    )
    assert plain.root is not None
    assert sealed.root is not None
    assert sealed.root.power > plain.root.power + 20.0


def test_a_bath_without_oil_says_so() -> None:
    dry = case_of("6310", {"duty.load.fz": "1 kN", "duty.inner_speed": "1500 rpm",
                           "losses.oil_level": "5 mm", "lubricant.kind": "dry",
                           "lubricant.friction_coefficient": 0.1})  # fmt: skip
    found = analyse(dry).seals_and_bath
    assert found is not None
    assert found.drag[0] == 0.0
    assert "bath_without_oil" in {note.key for note in found.notes}


def test_the_page_has_the_whole() -> None:
    from rolamento.document.terminal import terminal
    from rolamento.pages.friction import friction_page

    text = terminal(friction_page(analyse(motor("6310-2RS1"))))
    assert "Whole bearing, with seals and oil bath" in text
