"""Thermal reference and permissible speeds against what a maker prints.

Reference speeds of 6000, 6206, 6210, 6310, NU205-E and 7210-B, and the permissible speed of an
NJ220 (K_L 0.52, K_P 0.565, f 0.939), from a maker's catalogue, by its symbols Schaeffler's HR 1.
Sizes and C_0r (N) stand beside them; those of the series 60, 62 and 63 are NSK's too (E1102).
f_0r and f_1r: ISO 15312:2003, annex A.
"""

from __future__ import annotations

from math import pi

import pytest

from rolamento.speeds import (
    ReferenceCoefficients,
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


def test_the_formula_holds_for_a_roller_bearing_too() -> None:
    """NU205-E, f_0r 2 and f_1r 3e-4 of series NU2: no coefficients of rollers are on file yet."""
    found = thermal_reference_speed(
        25e-3, 52e-3, 15e-3, 27_500.0, ReferenceCoefficients(2.0, 3.0e-4)
    )
    assert found * 30.0 / pi == pytest.approx(11_800, rel=WITHIN)


def test_permissible_speed_of_the_example() -> None:
    assert speed_ratio(0.52, 0.565) == pytest.approx(0.939, abs=1e-3)
