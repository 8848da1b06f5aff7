"""Thermal reference and permissible speeds against what a maker prints.

Reference speeds of 6000, 6206, 6210, 6310, NU205-E and 7210-B, and the permissible speed of an
NJ220 (K_L 0.52, K_P 0.565, f 0.939), from a maker's catalogue, by its symbols Schaeffler's HR 1.
Sizes and C_0r (N) stand beside them; those of the series 60, 62 and 63 are NSK's too (E1102).
f_0r and f_1r: ISO 15312:2003, annex A.
"""

from __future__ import annotations

from math import pi

import pytest

from rolamento.analysis.speed_limits import speed_limits
from rolamento.case import case_of
from rolamento.case.bearing import Bearing
from rolamento.ratings import static_rating
from rolamento.speeds import (
    reference_coefficients,
    speed_ratio,
    thermal_reference_speed,
)

PRINTED = {
    "6000": ("60", 10, 26, 8, 1960, 27_600),
    "6206": ("62", 30, 62, 16, 11_300, 12_000),
    "6210": ("62", 50, 90, 20, 23_200, 8_200),
    "6310": ("63", 50, 110, 27, 38_000, 7_700),
    "7210-B": ("72", 50, 90, 20, 28_500, 7_900),
}
WITHIN = 0.015


@pytest.mark.parametrize("name", PRINTED)
def test_thermal_reference_speeds(name: str) -> None:
    series, bore, outside, width, rating, printed = PRINTED[name]
    coefficients = reference_coefficients(series)
    assert coefficients is not None
    found = thermal_reference_speed(1e-3 * bore, 1e-3 * outside, 1e-3 * width, rating, coefficients)
    assert found * 30.0 / pi == pytest.approx(printed, rel=WITHIN)


SKF = {
    # designation: series, d, D, T or B (mm), C_0r (kN), reference speed (r/min)
    "30203 J2": ("302", 17, 40, 13.25, 18.6, 13_000),
    "30204 J2/Q": ("302", 20, 47, 15.25, 28.0, 11_000),
    "30205 J2/Q": ("302", 25, 52, 16.25, 33.5, 10_000),
    "30206 J2/Q": ("302", 30, 62, 17.25, 44.0, 8_500),
    "30303 J2": ("303", 17, 47, 15.25, 25.0, 12_000),
    "30305 J2/Q": ("303", 25, 62, 18.25, 43.0, 9_000),
    "30306 J2/Q": ("303", 30, 72, 20.75, 56.0, 7_500),
    "32004 X/Q": ("320", 20, 42, 15, 27.0, 12_000),
    "32006 X/Q": ("320", 30, 55, 17, 44.0, 9_000),
    "32303 J2/Q": ("323", 17, 47, 20.25, 33.5, 11_000),
    "32304 J2/Q": ("323", 20, 52, 22.25, 45.5, 10_000),
    "32305 J2": ("323", 25, 62, 25.25, 63.0, 8_000),
    "32306 J2/Q": ("323", 30, 72, 28.75, 85.0, 7_000),
    "33205/Q": ("332", 25, 52, 22, 56.0, 9_000),
    "33206/Q": ("332", 30, 62, 25, 76.5, 7_500),
    "NJ 204 ECP": ("NJ2", 20, 47, 14, 22.0, 16_000),
    "NU 205 ECP": ("NU2", 25, 52, 15, 27.0, 14_000),
    "NU 304 ECP": ("NU3", 20, 52, 15, 26.0, 15_000),
}


def test_nu205_by_the_coefficients_on_file() -> None:
    coefficients = reference_coefficients("NU2")
    assert coefficients is not None
    found = thermal_reference_speed(25e-3, 52e-3, 15e-3, 27_500.0, coefficients)
    assert found * 30.0 / pi == pytest.approx(11_800, rel=WITHIN)


@pytest.mark.parametrize("name", SKF)
def test_skf_prints_reference_speeds_of_its_own_friction_model(name: str) -> None:
    """SKF's are not of the standard's f_0r: from the same to a quarter above it.

    SKF, Rolling bearings (catalogue), product tables of single-row cylindrical and tapered roller
    bearings.
    """
    series, bore, outside, width, rating, printed = SKF[name]
    coefficients = reference_coefficients(series)
    assert coefficients is not None
    found = thermal_reference_speed(
        1e-3 * bore, 1e-3 * outside, 1e-3 * width, 1e3 * rating, coefficients
    )
    assert 0.80 < found * 30.0 / pi / printed < 1.01


ANNEX = {
    "QJ2": (2.0, 3.7e-4), "QJ3": (3.0, 3.7e-4), "32": (5.0, 3.5e-4), "33": (7.0, 3.5e-4),
    "12": (2.5, 8e-5), "22": (3.0, 8e-5), "13": (3.5, 8e-5), "23": (4.0, 8e-5),
}  # fmt: skip


@pytest.mark.parametrize("series", ANNEX)
def test_coefficients_of_four_point_double_row_and_self_aligning_series(series: str) -> None:
    """ISO 15312:2003, annex A, figure by figure."""
    found = reference_coefficients(series)
    assert found is not None
    assert (found.f_0r, found.f_1r) == ANNEX[series]


def test_reference_speed_of_qj_210() -> None:
    """6600 r/min as a maker prints; C_0 of both pairs of arcs of 14 balls of 12.7 mm, 35°."""
    coefficients = reference_coefficients("QJ2")
    assert coefficients is not None
    bearing = case_of("QJ 210").bearing
    assert isinstance(bearing, Bearing)
    row = (bearing.ball_count, bearing.ball_diameter, bearing.pitch_diameter, bearing.contact_angle)
    rating = 2.0 * float(static_rating(*row))
    found = thermal_reference_speed(50e-3, 90e-3, 20e-3, rating, coefficients)
    assert found * 30.0 / pi == pytest.approx(6600, rel=WITHIN)
    (limit, *_) = speed_limits("QJ 210").limits
    assert (limit.name, limit.speed) == ("reference", pytest.approx(found))


def test_permissible_speed_of_the_example() -> None:
    assert speed_ratio(0.52, 0.565) == pytest.approx(0.939, abs=1e-3)
