"""ISO 281:2007, ISO 76:2006 and ISO/TS 16281:2008 for roller bearings, and NSK's printed examples.

f_c of radial bearings at eight γ and the constants are as collected for this project from public
sources; the rest of table 7, and the columns of table 10, are carried from general knowledge of the
standard: the closed form gives every one of their numbers, rounded. NSK: Rolling Bearings (CAT. No.
E1102e), page A35, example 5.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.life.equivalent_load import equivalent_load, static_equivalent_load
from rolamento.life.iso281 import ROLLER_EXPONENT, basic_rating_life, hours
from rolamento.life.iso281_modified import (
    fatigue_load_limit,
    fatigue_load_limit_of_lines,
    life_modification_factor,
)
from rolamento.life.iso16281 import ROLLER_SLOPE, system_life
from rolamento.life.lamina import (
    edge_factor,
    lamina_life,
    one_number_of_slices,
    roller_race_ratings,
)
from rolamento.life.load_zone import (
    roller_clearance_function,
    roller_radial,
    roller_zone_life,
)
from rolamento.ratings import (
    roller_dynamic_factor,
    roller_dynamic_rating,
    roller_static_rating,
    roller_thrust_dynamic_factor,
)
from rolamento.ratings.ribs import permissible_axial_load_nsk, permissible_axial_load_skf
from rolamento.units import RPM

TABLE_7 = [
    52.1, 60.8, 66.5, 70.7, 74.1, 76.9, 79.2, 81.2, 82.8, 84.2, 85.4, 86.4, 87.1, 87.7, 88.2,
    88.5, 88.7, 88.8, 88.8, 88.7, 88.5, 88.2, 87.9, 87.5, 87.0, 86.4, 85.8, 85.2, 84.5, 83.8,
]  # fmt: skip
STEEL = 207e9 / (1.0 - 0.3**2)


def test_f_c_is_the_printed_table() -> None:
    found = roller_dynamic_factor(np.arange(1, 31) / 100.0)
    assert np.abs(found - TABLE_7).max() <= 0.05 + 1e-9


def test_f_c_of_thrust_bearings_is_the_printed_table() -> None:
    right = roller_thrust_dynamic_factor([0.01, 0.02], np.pi / 2)
    assert right == pytest.approx([105.4, 122.9], abs=0.05)
    for degrees, printed in ((50, (109.7, 127.8)), (65, (107.1, 124.7)), (80, (105.6, 123.0))):
        angle = np.radians(degrees)
        ratio = np.array([0.01, 0.02]) / np.cos(angle)
        factor = roller_thrust_dynamic_factor(ratio, angle)
        factor /= np.cos(angle) ** (7.0 / 9.0) * np.tan(angle)
        assert factor == pytest.approx(printed, abs=0.05)


def test_outside_the_table_there_is_no_factor() -> None:
    assert np.isnan(roller_dynamic_factor([0.009, 0.301])).all()
    assert np.isnan(roller_thrust_dynamic_factor([0.009, 0.301], np.pi / 2)).all()
    assert not np.isnan(roller_dynamic_factor([0.01, 0.30])).any()


def test_thrust_goes_over_into_ninety_degrees() -> None:
    near = roller_thrust_dynamic_factor(0.1, np.pi / 2 - 1e-9)
    assert near == pytest.approx(float(roller_thrust_dynamic_factor(0.1, np.pi / 2)), rel=1e-6)


def test_ratings_grow_as_the_formulas_have_it() -> None:
    row = (14, 10e-3, 12e-3, 60e-3)
    one, two = (float(roller_dynamic_rating(*row, rows=i)) for i in (1, 2))
    assert two / one == pytest.approx(2.0 ** (7.0 / 9.0))
    longer = float(roller_dynamic_rating(14, 10e-3, 24e-3, 60e-3))
    assert longer == pytest.approx(two)
    kinds = [float(roller_dynamic_rating(*row, kind=k)) for k in ("needle", "drawn_cup")]
    assert kinds[0] / kinds[1] == pytest.approx(1.1)
    assert float(roller_static_rating(*row)) == pytest.approx(44 * (1 - 1 / 6) * 14 * 12 * 10)
    thrust = roller_static_rating(*row, np.pi / 2, thrust=True)
    assert float(thrust) == pytest.approx(220 * 14 * 12 * 10)
    with pytest.raises(InputError, match="cylindrical"):
        roller_dynamic_rating(*row, kind="drawn_cup", thrust=True)


def test_static_rating_is_4000_mpa() -> None:
    """Hertz: the heaviest roller, 5 F_r/Z, on the inner raceway (ISO 76:2006, 7.1)."""
    count, diameter, length, pitch = 14, 10e-3, 12e-3, 60e-3
    load = 5.0 * float(roller_static_rating(count, diameter, length, pitch)) / count / length
    curvature = 2.0 / diameter / (1.0 - diameter / pitch)
    pressure = np.sqrt(load * STEEL * curvature / (2.0 * np.pi))
    assert pressure == pytest.approx(4000e6, rel=3e-3)


def test_equivalent_loads() -> None:
    angle = np.radians(14.0)
    e, cot = 1.5 * np.tan(angle), 1.0 / np.tan(angle)
    below, beyond = ((1000.0, 0.9 * e * 1000.0), (1000.0, 2.0 * e * 1000.0))
    single = [
        float(equivalent_load(*own, angle, 0.0, kind="roller").load) for own in (below, beyond)
    ]
    assert single == pytest.approx([1000.0, 400.0 + 0.4 * cot * beyond[1]])
    facing = [
        float(equivalent_load(*own, angle, 0.0, kind="roller", double_row=True).load)
        for own in (below, beyond)
    ]
    assert facing == pytest.approx([1000.0 + 0.45 * cot * below[1], 670.0 + 0.67 * cot * beyond[1]])
    # both lines meet at e, which is what e is
    at = equivalent_load(1.0, e * (1 + 1e-6), angle, 0.0, kind="roller")
    assert float(at.load) == pytest.approx(1.0, rel=1e-4)
    static = static_equivalent_load(1000.0, 3000.0, angle, kind="roller")
    assert float(static) == pytest.approx(500.0 + 0.22 * cot * 3000.0)
    assert float(static_equivalent_load(1000.0, 10.0, angle, kind="roller")) == 1000.0


def test_cylindrical_bearings_carry_axial_load_on_their_ribs() -> None:
    """SKF, Rolling bearings, page 509: e = 0.2 and Y = 0.6; of wide series 0.3 and 0.4."""
    loads = [float(equivalent_load(10.0, a, 0.0, 0.0, kind="roller").load) for a in (0, 2, 4)]
    assert loads == pytest.approx([10.0, 10.0, 9.2 + 0.6 * 4])
    wide = equivalent_load(10.0, 4.0, 0.0, 0.0, kind="roller", wide=True)
    assert float(wide.load) == pytest.approx(9.2 + 0.4 * 4)
    assert float(static_equivalent_load(10.0, 4.0, 0.0, kind="roller")) == 10.0


def test_thrust_roller_bearings_have_an_axial_load() -> None:
    angle = np.radians(60.0)
    slope = np.tan(angle)
    found = equivalent_load(100.0, 1000.0, angle, 0.0, kind="roller_thrust")
    assert float(found.load) == pytest.approx(slope * 100.0 + 1000.0)
    small = equivalent_load(1000.0, 1000.0, angle, 0.0, kind="roller_thrust")
    assert np.isnan(small.load)
    right = equivalent_load(0.0, 1000.0, np.pi / 2, 0.0, kind="roller_thrust")
    assert float(right.load) == 1000.0


def test_nsk_example_of_two_tapered_bearings() -> None:
    """HR30305DJ and HR30206J back to back at 600 min⁻¹ under 5500 N and 2000 N."""
    radial = (1569.0, 3931.0)
    axial = 2000.0 + 0.6 / 1.60 * radial[1]
    assert axial == pytest.approx(3474.0, abs=0.5)
    # NSK prints e = 0.83 and Y = 0.73, of a contact angle of 28.8 degrees
    angle = np.arctan(0.83 / 1.5)
    first = equivalent_load(radial[0], axial, angle, 0.0, kind="roller")
    assert float(first.axial_factor) == pytest.approx(0.73, abs=0.01)
    load = 0.4 * radial[0] + 0.73 * axial
    assert load == pytest.approx(3164.0, abs=1.0)
    for rating, own, printed in ((38e3, load, 109_750.0), (43e3, radial[1], 80_400.0)):
        life = basic_rating_life(rating, own, ROLLER_EXPONENT)
        # NSK's speed factor is rounded to 0.42
        assert float(hours(life, 600.0 * RPM)) == pytest.approx(printed, rel=0.02)


def test_a_iso_of_rollers() -> None:
    """0.1 where the standard's range ends, continuous between its three pieces, at most 50."""
    for edge in (0.4, 1.0):
        low, high = (
            float(life_modification_factor(edge * (1 + s), 0.5, 100.0, 300.0, rollers=True))
            for s in (-1e-9, 1e-9)
        )
        assert low == pytest.approx(high, rel=3e-4)
    end = life_modification_factor(0.1, 1.0, 100.0, 100.0, rollers=True)
    assert float(end) == pytest.approx(0.1, rel=1e-6)
    assert float(life_modification_factor(4.0, 1.0, 100.0, 1.0, rollers=True)) == 50.0
    rising = life_modification_factor(np.linspace(0.1, 4.0, 50), 0.5, 100.0, 500.0, rollers=True)
    assert np.all(np.diff(rising) >= 0.0)
    assert np.isnan(life_modification_factor(0.09, 1.0, 100.0, 100.0, rollers=True))


@pytest.mark.parametrize(
    ("diameter", "length", "pitch"),
    [(7.5e-3, 9e-3, 39e-3), (20e-3, 30e-3, 150e-3), (40e-3, 40e-3, 300e-3)],
)
def test_fatigue_load_limit_from_the_contact_is_the_estimate(
    diameter: float, length: float, pitch: float
) -> None:
    """With the profile of ISO/TS 16281 both of ISO 281's ways agree; straight rollers bear more."""
    x = (np.arange(35) - 17.0) / 35.0
    drop = 0.00035 * diameter * -np.log(1.0 - (2.0 * x) ** 2)
    shape = (13, diameter, length, pitch)
    static = roller_static_rating(*shape)
    estimate = float(fatigue_load_limit(static, pitch, rollers=True))
    exact = float(fatigue_load_limit_of_lines(*shape, 0.0, STEEL, drop, drop))
    assert exact == pytest.approx(estimate, rel=0.06)
    straight = float(fatigue_load_limit_of_lines(*shape, 0.0, STEEL, 0 * drop, 0 * drop))
    size = min(1.0, 0.1 / pitch) ** 0.3
    # (1500/4000)² of the static load, shared 0.2453 Z instead of Z/5
    assert straight / size == pytest.approx(
        0.2453 * 5 * (1500 / 4000) ** 2 * float(static), rel=5e-3
    )


def _continuous(angle: float, slices: int = 35) -> tuple[float, np.ndarray, np.ndarray]:
    """C of a row, its races' ratings, and the loads that C makes on a ring of many rollers."""
    count, diameter, length, pitch = 13, 7.5e-3, 9e-3, 39e-3
    rating = float(roller_dynamic_rating(count, diameter, length, pitch, angle))
    races = roller_race_ratings(rating, count, diameter, pitch, angle)
    psi = (np.arange(2000) + 0.5) / 2000 * 2.0 * np.pi
    share = np.maximum(np.cos(psi), 0.0) ** (10.0 / 9.0)
    load = share / np.mean(share * np.cos(psi)) * rating / count / np.cos(angle)
    return (
        rating,
        np.array([races.inner, races.outer]),
        np.repeat(load[:, None] / slices, slices, 1),
    )


@pytest.mark.parametrize("degrees", [0.0, 15.0, 30.0])
def test_lamina_life_is_the_rating_life(degrees: float) -> None:
    """Straight lines, load zone ½, no edges, λν = 0.83 again: a million revolutions under C."""
    _, races, load = _continuous(np.radians(degrees))
    lives = [
        lamina_life(0.83 * race, load, turning=turning, edges=False)
        for race, turning in zip(races, (True, False), strict=True)
    ]
    assert float(system_life(np.array(lives), slope=ROLLER_SLOPE)) == pytest.approx(1.0, abs=0.02)


def test_slices_do_not_matter_but_for_the_edge() -> None:
    """q_c = Q_c n^(-7/9): without the edge factor lives are the same for every n."""
    lives = {}
    for slices in (31, 35, 1001):
        _, races, load = _continuous(0.0, slices)
        lives[slices] = [
            float(lamina_life(races[0], load, turning=True, edges=edges)) for edges in (False, True)
        ]
    assert lives[31][0] == pytest.approx(lives[1001][0], rel=1e-9)
    # the trap: 2.33 at the outermost slice however narrow it is
    assert lives[1001][1] > 1.3 * lives[31][1]
    assert edge_factor(31)[[0, -1]] == pytest.approx([2.328, 2.328], abs=1e-3)
    assert edge_factor(1001)[500] == 1.0
    assert one_number_of_slices([35, 35]) == 35
    with pytest.raises(InputError, match="cannot be compared"):
        one_number_of_slices([35, 71])


def test_no_load_no_end() -> None:
    assert np.isposinf(lamina_life(1e4, np.zeros((5, 35)), turning=True))
    assert np.isnan(lamina_life(1e4, np.full((5, 35), np.nan), turning=True))


def test_permissible_axial_load_of_ribs() -> None:
    """NSK's equations 5.34 and 5.35; SKF's limits, of heat and of the rib's strength."""
    nsk = [
        float(permissible_axial_load_nsk(0.05, 1000.0 * RPM, 3, name)) for name in ("grease", "oil")
    ]
    assert nsk == pytest.approx(
        [
            9.8 * (900 * 2500 / 2500 - 0.023 * 50**2.5),
            9.8 * (490 * 2500 / 2000 - 0.000135 * 50**3.4),
        ]
    )
    assert float(permissible_axial_load_nsk(0.05, 1e4, 3)) == 0.0
    assert np.isnan(permissible_axial_load_nsk(0.21, 10.0, 3))
    assert np.isnan(permissible_axial_load_nsk(0.05, 10.0, 0))
    shape = (0.05, 0.11, 0.027, 112e3)
    slow = float(permissible_axial_load_skf(*shape, 20e3, 0.0))
    assert (
        slow == pytest.approx(2300 * 110**1.7 / 1000, rel=1e-3) == pytest.approx(6793.5, rel=1e-3)
    )
    fast = float(permissible_axial_load_skf(*shape, 20e3, 2000.0 * RPM))
    assert fast == pytest.approx(112 * 1e4 / (2000 * 160) * 1e3 - 0.1 * 20e3)
    # without a radial load nothing holds the rollers straight
    assert float(permissible_axial_load_skf(*shape, 0.0, 100.0)) == 0.0


def test_load_zone_of_rollers() -> None:
    """J_r at ½: 0.2453 with the exponent 1.1 (Harris 1991; ISO 281, B), 0.2448 with 10/9."""
    psi = (np.arange(4000) + 0.5) / 4000 * 2.0 * np.pi
    printed = np.mean(np.maximum(np.cos(psi), 0.0) ** 1.1 * np.cos(psi))
    assert printed == pytest.approx(0.2453, abs=5e-5)
    assert float(roller_radial(0.5)) == pytest.approx(0.2448, abs=5e-5)
    for zone in (0.3, 0.8, 2.0):
        load = np.maximum(1.0 - (1.0 - np.cos(psi)) / (2.0 * zone), 0.0) ** (10.0 / 9.0)
        assert float(roller_radial(zone)) == pytest.approx(np.mean(load * np.cos(psi)), rel=1e-5)
    falling = roller_clearance_function([0.2, 0.5, 1.0, 3.0])
    assert falling[1] == pytest.approx(0.0, abs=1e-12)
    assert np.all(np.diff(falling) < 0.0)
    races = roller_race_ratings(3e4, 13, 7.5e-3, 39e-3, 0.0)
    ratios = roller_zone_life([0.2, 0.5, 0.75, 3.0], races)
    assert ratios[1] == pytest.approx(1.0)
    assert ratios[2] > 1.0 > ratios[0]
    assert ratios[3] < 1.0
