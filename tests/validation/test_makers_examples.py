"""Worked examples and tables of bearing makers: SKF 2016 and 2018, HCH, LYC and Minebea.

The numbers are in verification/data/makers_life.toml. What the print supports is half a unit of its
last digit; of factors with two decimals, whose zeros some makers leave out, half a hundredth.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Load
from rolamento.life import LifeConditions, life
from rolamento.life.equivalent_load import equivalent_load, load_factors
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.life.iso281_modified import life_modification_factor
from rolamento.life.spectrum import shaft_life
from rolamento.oil.state import reference_viscosity
from rolamento.solution import solve
from rolamento.units import RPM
from rolamento.verification import Check
from rolamento.verification.check import half_unit, published
from rolamento.verification.makers import life_checks

CHECKS = tuple(life_checks())
DATA = published("makers_life")
PUMP: Any = DATA["pump"]


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source}: {c.quantity}")
def test_printed_number(check: Check) -> None:
    assert check.verdict != "fails", check


def test_all_that_is_printed_is_compared() -> None:
    # 6309: two, HCH: two; the pump; LYC: 15°, 25°, 30°, 40°, static; Minebea; speed factors
    sets = 9 * 4 + 6 + 4 + 6 + 3 + 3 + 1 + 3
    assert len(CHECKS) == 4 + 1 + sets + 21 + 39
    assert [check.quantity for check in CHECKS if check.verdict == "explained"] == [
        "L_10h, 7312 DB"
    ]


def test_equivalent_load_of_the_pump() -> None:
    """P = 0.57 · 1.45 + 0.93 · 11.5 = 11.52 kN for the pair."""
    angle = math.radians(PUMP["contact_angle_deg"])
    loads = (PUMP["radial_load_N"], PUMP["axial_load_N"])
    found = equivalent_load(*loads, angle, 1e6, double_row=True)
    printed = PUMP["equivalent_load_kN"]
    assert float(found.load) * 1e-3 == pytest.approx(float(printed), abs=half_unit(printed))


def test_pump_from_end_to_end() -> None:
    """The same pair solved, with the maker's rating: P, C of the set and the hours."""
    pair = Bearing(
        ball_count=12, ball_diameter=0.022, pitch_diameter=0.095, inner_conformity=0.52,
        outer_conformity=0.53, contact_angle=math.radians(PUMP["contact_angle_deg"]),
        arrangement="DB", spacing=0.031,
    )  # fmt: skip
    duty = Duty(
        inner_speed=PUMP["speed_rpm"] * RPM,
        load=Load(fx=PUMP["axial_load_N"], fz=PUMP["radial_load_N"]),
    )
    rating = PUMP["dynamic_rating_N"]
    found = life(solve(Case(bearing=pair, duty=duty)), LifeConditions(dynamic_rating=rating))
    assert found.loads.dynamic[0] == pytest.approx(11521.5)
    assert found.ratings.dynamic_of_set[0] == pytest.approx(2.0**0.7 * rating)
    # 17 400 h with 1.62 for 2^0.7, whose cube makes 0.8 % of the life
    as_printed = found["iso281"].hours[0] * (PUMP["printed_pair"] / 2.0**0.7) ** 3
    assert as_printed == pytest.approx(float(PUMP["hours"]), abs=half_unit(PUMP["hours"]))


def test_makers_pair_by_the_races() -> None:
    """2^0.7 is what the product of reliabilities makes of two rows that share a load."""
    one = basic_rating_life(104000.0, 5000.0)
    two = shaft_life(np.array([one, one]))
    pair = basic_rating_life(2.0**0.7 * 104000.0, 10000.0)
    assert float(two) == pytest.approx(float(pair), rel=1e-12)


def test_clean_thick_oil_of_the_6309() -> None:
    """SKF reads ν_1 = 8.15 mm²/s off a diagram; the standard's formula has 9.65 (2016, p. 92).

    Its own a_SKF for this grade of bearings is another factor. The standard's a_ISO for the printed
    κ = 2.45, P_u/P = 0.134 and a clean oil stays below what the maker claims of it.
    """
    needed = float(reference_viscosity(3000.0 * RPM, 0.0725)) * 1e6
    assert needed == pytest.approx(4500.0 / math.sqrt(3000.0 * 72.5), rel=1e-12)
    assert 8.15 < needed < 1.2 * 8.15
    factor = float(life_modification_factor(2.45, 0.8, 1340.0, 10000.0))
    by_hand = (
        0.1
        * (1.0 - (2.5671 - 1.9987 / 2.45**0.071739) ** 0.83 * (0.8 * 0.134) ** (1.0 / 3.0)) ** -9.3
    )
    assert factor == pytest.approx(by_hand, rel=1e-12)


def test_factors_between_the_printed_lines_lie_between_the_numbers() -> None:
    table = DATA["lyc"]["shallow"]
    loads = [float(load) * 1e6 for load in DATA["lyc"]["relative_axial_load_MPa"]]
    middles = np.sqrt(np.array(loads[:-1]) * np.array(loads[1:]))
    found = load_factors(math.radians(15.0), middles, double_row=True)
    for name, values in (("Y_1", found.axial_below), ("Y_2", found.axial), ("e", found.limit)):
        printed = np.array([float(value) for value in table[name]])
        low, high = np.minimum(printed[:-1], printed[1:]), np.maximum(printed[:-1], printed[1:])
        assert np.all((values >= low - 1e-12) & (values <= high + 1e-12)), name


def test_one_example_by_hand() -> None:
    """6309: (55.3/10)³ = 169.1 million, and 60 · 3000 turns an hour."""
    assert float(hours(basic_rating_life(55300.0, 10000.0), 3000.0 * RPM)) == pytest.approx(
        5.53**3 * 1e6 / 180000.0
    )
