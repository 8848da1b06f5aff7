"""The oil: viscosity over temperature and pressure, density, viscosity index, α."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.oil import (
    astm_d341,
    astm_d341_line,
    barus,
    density_by_expansion,
    density_of_lubricating_oil,
    dynamic_viscosity,
    reference_viscosities,
    roelands,
    so_klaus,
    viscosity_100_of_index,
    viscosity_index,
    viscosity_temperature_coefficient,
    wooster,
)

TONNA = astm_d341_line(313.15, 66.9e-6, 373.15, 8.77e-6)

# The Tribology Handbook (Neale), section on mineral oils, table of typical physical properties:
# density at 25 °C (kg/m³); viscosity at 30, 60, 100 °C (mPa·s); α there (1e-8/Pa).
HANDBOOK_TEMPERATURES = np.array([303.15, 333.15, 373.15])
HANDBOOK = [
    (862.0, (18.6, 6.3, 2.4), (2.1, 1.6, 1.3)),
    (880.0, (45.0, 12.0, 3.9), (2.6, 2.0, 1.6)),
    (897.0, (171.0, 31.0, 7.5), (2.8, 2.3, 1.8)),
    (862.0, (42.0, 13.5, 4.3), (2.2, 1.9, 1.4)),
    (875.0, (153.0, 34.0, 9.1), (2.4, 2.1, 1.6)),
    (891.0, (810.0, 135.0, 27.0), (3.4, 2.8, 2.2)),
]

temperatures = st.floats(250.0, 450.0)


@given(
    cool=st.floats(250.0, 340.0),
    warmer=st.floats(5.0, 120.0),
    thick=st.floats(3.0, 5000.0),
    thinner=st.floats(0.05, 0.95),
)
def test_d341_passes_through_its_points(
    cool: float, warmer: float, thick: float, thinner: float
) -> None:
    thin = max(2.0, thick * thinner) * 1e-6
    line = astm_d341_line(cool, thick * 1e-6, cool + warmer, thin)
    assert float(astm_d341(cool, line)) == pytest.approx(thick * 1e-6, rel=1e-9)
    assert float(astm_d341(cool + warmer, line)) == pytest.approx(thin, rel=1e-9)


def test_d341_is_a_straight_line_and_falls() -> None:
    warm = np.linspace(260.0, 420.0, 50)
    shifted = astm_d341(warm, TONNA) * 1e6 + 0.7
    ordinate = np.log10(np.log10(shifted))
    slopes = np.diff(ordinate) / np.diff(np.log10(warm))
    np.testing.assert_allclose(slopes, -TONNA.slope, rtol=1e-9)
    assert np.all(np.diff(shifted) < 0.0)


@given(temperature=st.floats(270.0, 420.0))
def test_viscosity_temperature_coefficient_is_the_derivative(temperature: float) -> None:
    step = 1e-3
    around = np.array([temperature - step, temperature + step])
    slope = np.diff(np.log(astm_d341(around, TONNA)))[0] / (2.0 * step)
    found = float(viscosity_temperature_coefficient(temperature, TONNA))
    assert found == pytest.approx(-slope, rel=1e-6)


def test_the_viscosity_of_campanha_belongs_to_another_temperature() -> None:
    """12.89 mm²/s is what the line gives at 84.8 °C, not at the 83.4 °C of the text."""
    assert float(astm_d341(84.8 + 273.15, TONNA)) * 1e6 == pytest.approx(12.89, abs=0.005)
    assert float(astm_d341(83.4 + 273.15, TONNA)) * 1e6 > 13.3
    assert float(astm_d341(110.0 + 273.15, TONNA)) * 1e6 == pytest.approx(7.03, abs=0.005)


def test_dynamic_viscosity() -> None:
    assert float(dynamic_viscosity(12.89e-6, 880.0)) == pytest.approx(0.01134, rel=1e-3)


# --- viscosity index ---


@pytest.mark.parametrize(
    ("at_40", "at_100", "index"),
    [
        (73.3, 8.86, 92),  # the examples of ASTM D2270
        (22.83, 5.05, 156),
        (66.9, 8.77, 103),  # Campanha (2008), table 3.1
        (107.0, 14.3, 137),  # Bessette, NASA CP-3350, table 6
    ],
)
def test_viscosity_index_of_published_oils(at_40: float, at_100: float, index: int) -> None:
    assert viscosity_index(at_40 * 1e-6, at_100 * 1e-6) == pytest.approx(index, abs=1.0)


@pytest.mark.parametrize("limit", [3.8, 4.4, 5, 6.4, 7, 7.7, 9, 12, 15, 18, 22, 28, 40, 55, 70])
def test_the_polynomials_of_the_index_meet(limit: float) -> None:
    below, above = reference_viscosities(limit - 1e-9), reference_viscosities(limit)
    assert below == pytest.approx(above, rel=3e-3)


@given(at_40=st.floats(15.0, 2000.0), index=st.floats(0.0, 180.0))
def test_viscosity_of_an_index_has_that_index(at_40: float, index: float) -> None:
    hot = viscosity_100_of_index(at_40 * 1e-6, index)
    if not math.isnan(hot):
        # the polynomials do not meet exactly, by up to a unit or so of the index
        assert viscosity_index(at_40 * 1e-6, hot) == pytest.approx(index, abs=2.0)
        assert 2e-6 <= hot < at_40 * 1e-6


def test_no_index_for_thin_oils() -> None:
    assert math.isnan(viscosity_index(5e-6, 1.9e-6))
    assert math.isnan(viscosity_100_of_index(5e-6, 95.0))


# --- density ---


@given(temperature=temperatures, other=temperatures)
def test_density_returns_to_where_it_was(temperature: float, other: float) -> None:
    there = density_of_lubricating_oil(other, 880.0, temperature)
    back = float(density_of_lubricating_oil(temperature, there, other))
    assert back == pytest.approx(880.0, rel=1e-12)


def test_density_falls_by_its_coefficient() -> None:
    """0.6278/ρ at 15 °C: 7.1e-4 per kelvin for an oil of 880 kg/m³."""
    step = 0.01
    around = density_of_lubricating_oil([288.15 - step, 288.15 + step], 880.0, 288.15)
    assert np.diff(around)[0] / (2 * step) == pytest.approx(-0.6278, rel=1e-6)
    same = density_by_expansion([288.15 - step, 288.15 + step], 880.0, 288.15, 0.6278 / 880.0)
    assert np.diff(same)[0] / (2 * step) == pytest.approx(-0.6278, rel=1e-6)


# --- pressure ---


@given(viscosity=st.floats(1e-3, 10.0), alpha=st.floats(5e-9, 4e-8), pressure=st.floats(0.0, 2e9))
def test_without_pressure_both_laws_leave_the_viscosity(
    viscosity: float, alpha: float, pressure: float
) -> None:
    assert float(barus(0.0, viscosity, alpha)) == viscosity
    assert float(roelands(0.0, viscosity, alpha)) == pytest.approx(viscosity, rel=1e-12)
    step = 1e3
    for law in (barus, roelands):
        slope = math.log(float(law(step, viscosity, alpha)) / viscosity) / step
        assert slope == pytest.approx(alpha, rel=1e-3)
        assert float(law(pressure + 1e6, viscosity, alpha)) > float(law(pressure, viscosity, alpha))


def test_barus_and_roelands_part_at_a_gigapascal() -> None:
    """Campanha's oil: 1.2e5 against about 414 Pa·s."""
    assert float(barus(1e9, 0.01134, 1.62e-8)) == pytest.approx(1.23e5, rel=5e-3)
    assert float(roelands(1e9, 0.01134, 1.62e-8)) == pytest.approx(414.0, rel=5e-3)
    assert np.isinf(barus(1e12, 0.01, 2e-8))


def test_roelands_meets_barus_at_low_pressure() -> None:
    pressure = np.array([1e6, 5e6])
    ratio = roelands(pressure, 0.05, 2e-8) / barus(pressure, 0.05, 2e-8)
    np.testing.assert_allclose(ratio, 1.0, atol=1e-3)


def test_wooster_as_campanha_prints_it() -> None:
    assert float(wooster(11.34e-3)) == pytest.approx(1.62e-8, abs=0.005e-8)
    assert float(wooster(6.18e-3)) == pytest.approx(1.36e-8, abs=0.005e-8)


def test_both_correlations_against_measured_oils() -> None:
    """Eighteen measured values: Wooster within 30 %, So and Klaus within 40 %, 10 % at large."""
    errors: dict[str, list[float]] = {"wooster": [], "so_klaus": []}
    for density, viscosities, measured in HANDBOOK:
        eta = np.array(viscosities) * 1e-3
        rho = density_of_lubricating_oil(HANDBOOK_TEMPERATURES, density, 298.15)
        nu = eta / rho
        line = astm_d341_line(HANDBOOK_TEMPERATURES[0], nu[0], HANDBOOK_TEMPERATURES[2], nu[2])
        assert float(astm_d341(HANDBOOK_TEMPERATURES[1], line)) == pytest.approx(nu[1], rel=0.1)
        alpha = np.array(measured) * 1e-8
        errors["wooster"] += list(wooster(eta) / alpha - 1.0)
        errors["so_klaus"] += list(so_klaus(nu, rho, line.slope) / alpha - 1.0)
    assert np.abs(errors["wooster"]).max() < 0.3
    assert np.abs(errors["so_klaus"]).max() < 0.4
    assert abs(np.mean(errors["wooster"])) < 0.11
    assert abs(np.mean(errors["so_klaus"])) < 0.11


def test_so_klaus_has_nothing_to_say_below_one() -> None:
    assert np.isnan(so_klaus(0.9e-6, 850.0, 3.5))
