"""Press fits, temperature and rotation, against what mathematics says of them."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from rolamento import Bearing
from rolamento.case.material import Material
from rolamento.clearance.effects import (
    EXPANSION_100CR6,
    bore_shrinkage,
    catalogue_outer_raceway,
    clearance_change,
    clearance_change_of_rings,
    contact_pressure,
    expansion_of,
    finish_loss,
    interference_change,
    outside_growth,
    roughness_loss,
    spin_growth,
)
from rolamento.errors import InputError
from rolamento.studies.tolerance import clearance_from_temperature


@dataclass(frozen=True)
class Stuff:
    youngs_modulus: float = 207e9
    poisson_ratio: float = 0.3
    density: float = 7810.0


STEEL, LIGHT = Stuff(), Stuff(70e9, 0.33, 2700.0)
d, RACE, TIGHT = 0.025, 0.0342, 10e-6


def growth(bore: float, shaft: Stuff = STEEL, race: float = RACE) -> float:
    p = contact_pressure(TIGHT, d, bore=bore, outside=race, inner=shaft, outer=STEEL)
    return float(outside_growth(p, d, race, STEEL))


# --- fits -------------------------------------------------------------------------


@pytest.mark.parametrize("bore", [0.0, 0.006, 0.012, 0.02])
def test_one_material_gives_the_formula_of_makers(bore: float) -> None:
    k, k0 = d / RACE, bore / d
    assert growth(bore) == pytest.approx(TIGHT * k * (1 - k0**2) / (1 - k**2 * k0**2), rel=1e-12)


def test_a_solid_shaft_of_the_same_steel_passes_on_d_over_raceway() -> None:
    assert growth(0.0) == pytest.approx(TIGHT * d / RACE, rel=1e-12)


def test_a_thin_ring_on_a_solid_shaft_takes_all_of_the_interference() -> None:
    assert growth(0.0, race=d * (1 + 1e-7)) == pytest.approx(TIGHT, rel=1e-6)


def test_a_thin_shaft_gives_way_altogether() -> None:
    assert growth(d * (1 - 1e-7)) == pytest.approx(0.0, abs=1e-11)


def test_a_rigid_shaft_gives_more_than_steel_and_aluminium_less() -> None:
    rigid = Stuff(1e20)
    assert growth(0.0, rigid) > growth(0.0) > growth(0.0, LIGHT) > 0.0
    # all of the interference goes to the bore: u(a) = δ/2 fixes u(b)/u(a) of Lamé
    k, nu = d / RACE, STEEL.poisson_ratio
    ratio = 2 * k / (1 + nu + k * k * (1 - nu))
    assert growth(0.0, rigid) == pytest.approx(TIGHT * ratio, rel=1e-9)


def test_growth_is_linear_and_a_gap_does_nothing() -> None:
    p = contact_pressure(
        [-5e-6, 0.0, 1e-6, 2e-6], d, bore=0.0, outside=RACE, inner=STEEL, outer=STEEL
    )
    assert p[:2].tolist() == [0.0, 0.0]
    assert p[3] == pytest.approx(2 * p[2])


def test_outer_ring_in_a_housing() -> None:
    """One material: makers' formula, with a massive housing as limit."""
    D, race, housing = 0.062, 0.0548, 0.1
    for outside in (housing, inf):
        p = contact_pressure(TIGHT, D, bore=race, outside=outside, inner=STEEL, outer=STEEL)
        h, h0 = race / D, D / outside
        assert float(bore_shrinkage(p, D, race, STEEL)) == pytest.approx(
            TIGHT * h * (1 - h0**2) / (1 - h**2 * h0**2), rel=1e-12
        )


def test_lame_against_an_integration_of_the_equilibrium() -> None:
    """u'' + u'/r - u/r² = 0 with σ_r = -p at the bore and 0 outside, integrated numerically."""
    a, b, p = 0.5 * d, 0.5 * RACE, 30e6
    E, nu = STEEL.youngs_modulus, STEEL.poisson_ratio

    def stress(r: float, u: float, slope: float) -> float:
        return E / (1 - nu**2) * (slope + nu * u / r)

    def ends(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        return np.array([(stress(a, *left) + p) / 1e6, stress(b, *right) / 1e6])

    r = np.linspace(a, b, 200)
    found = solve_bvp(
        lambda x, y: np.vstack((y[1], y[0] / x**2 - y[1] / x)), ends, r, np.zeros((2, 200)),
        tol=1e-9,
    )  # fmt: skip
    assert found.success
    assert float(outside_growth(p, d, RACE, STEEL)) == pytest.approx(2 * found.y[0, -1], rel=1e-6)


def test_smoothing() -> None:
    assert roughness_loss([20e-6, 1e-6, -4e-6], 5e-6) == pytest.approx([2e-6, 1e-6, 0.0])
    assert float(finish_loss(9e-6, 0.025, "ground")) == pytest.approx(9e-6 * (1 - 25 / 27))
    assert float(finish_loss(9e-6, 0.025, "turned")) == pytest.approx(9e-6 * (1 - 25 / 28))
    assert finish_loss([-3e-6], 0.025, "ground").tolist() == [0.0]


# --- temperature --------------------------------------------------------------------

BEARING = {"inner_raceway": 0.0342, "outer_raceway": 0.05484, "ball_diameter": 0.01032}


def change(inner: float, outer: float, balls: float, ball_expansion: float = 12.5e-6) -> float:
    return float(
        clearance_change(
            **BEARING,
            inner_rise=inner,
            outer_rise=outer,
            ball_rise=balls,
            ring_expansion=12.5e-6,
            ball_expansion=ball_expansion,
        )
    )


def test_temperatures_add_up() -> None:
    assert change(20, 10, 15) == pytest.approx(
        change(20, 0, 0) + change(0, 10, 0) + change(0, 0, 15)
    )
    assert change(40, 20, 30) == pytest.approx(2 * change(20, 10, 15))
    assert change(0, 0, 0) == 0.0


def test_a_bearing_that_is_warm_throughout_keeps_its_proportions() -> None:
    clearance = BEARING["outer_raceway"] - BEARING["inner_raceway"] - 2 * BEARING["ball_diameter"]
    assert change(50, 50, 50) == pytest.approx(12.5e-6 * 50 * clearance, abs=1e-18)


def test_the_rule_of_makers_is_the_case_of_balls_as_warm_as_the_inner_ring() -> None:
    """The raceways here leave no clearance, so that the two are the same."""
    assert change(10, 0, 10) == pytest.approx(
        float(clearance_change_of_rings(BEARING["outer_raceway"], 10)), rel=1e-12
    )
    assert catalogue_outer_raceway(0.025, 0.062) == pytest.approx(0.0546)


def test_ceramic_balls_take_less() -> None:
    assert change(10, 0, 10, 2.8e-6) > change(10, 0, 10)


def test_the_study_uses_the_same_rule() -> None:
    bearing = Bearing(
        ball_count=8,
        ball_diameter="10.319 mm",
        pitch_diameter="44.5 mm",
        diametral_clearance="0.02 mm",
        inner_conformity=0.52,
        outer_conformity=0.52,
    )
    found = clearance_from_temperature(bearing, [0.0, 10.0])
    rule = clearance_change_of_rings(bearing.pitch_diameter + bearing.ball_diameter, [0.0, 10.0])
    assert found == pytest.approx(20e-6 + rule, rel=1e-12)


def test_an_aluminium_housing_leaves_the_ring() -> None:
    lost = interference_change(
        0.062, inner_expansion=12.5e-6, inner_rise=50, outer_expansion=23e-6, outer_rise=50
    )
    assert lost == pytest.approx(-0.062 * 50 * 10.5e-6)


def test_expansions_on_file() -> None:
    assert expansion_of(Material.named("SUJ2"), "mounting.ball_expansion") == EXPANSION_100CR6
    with pytest.raises(InputError, match="is missing: the thermal expansion of") as error:
        expansion_of(Material.named("M50"), "mounting.ball_expansion")
    assert error.value.field == "mounting.ball_expansion"


# --- rotation -------------------------------------------------------------------------


def grown(diameter: float, speed: float = 1000.0, bore: float = d, outside: float = RACE) -> float:
    return float(spin_growth(speed, diameter, bore=bore, outside=outside, material=STEEL))


def test_growth_goes_with_the_square_of_the_speed() -> None:
    assert grown(RACE, 2000.0) == pytest.approx(4 * grown(RACE, 1000.0), rel=1e-12)
    assert grown(RACE, -1000.0) == grown(RACE, 1000.0)
    assert grown(RACE, 0.0) == 0.0


def test_a_thin_ring_grows_like_a_hoop() -> None:
    """σ = ρ ω² r², so Δd = ρ ω² d³/(4 E)."""
    found = grown(d, bore=d * (1 - 1e-6), outside=d * (1 + 1e-6))
    hoop = STEEL.density * 1000.0**2 * d**3 / (4 * STEEL.youngs_modulus)
    assert found == pytest.approx(hoop, rel=1e-5)


def test_a_solid_disc() -> None:
    """At the rim of a solid disc u = (1 - ν) ρ ω² b³/(4 E)."""
    rim = grown(d, bore=0.0, outside=d)
    u = (1 - 0.3) * STEEL.density * 1e6 * (d / 2) ** 3 / (4 * STEEL.youngs_modulus)
    assert rim == pytest.approx(2 * u, rel=1e-12)


def test_spin_against_an_integration_of_the_equilibrium() -> None:
    """u'' + u'/r - u/r² = -(1 - ν²) ρ ω² r/E, both sides free."""
    a, b, omega = 0.5 * d, 0.5 * RACE, 3000.0
    E, nu, rho = STEEL.youngs_modulus, STEEL.poisson_ratio, STEEL.density

    def ends(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        return np.array([left[1] + nu * left[0] / a, right[1] + nu * right[0] / b]) * 1e3

    r = np.linspace(a, b, 200)
    found = solve_bvp(
        lambda x, y: np.vstack(
            (y[1], y[0] / x**2 - y[1] / x - (1 - nu**2) * rho * omega**2 * x / E)
        ),
        ends, r, np.zeros((2, 200)), tol=1e-9,
    )  # fmt: skip
    assert found.success
    for diameter, u in ((d, found.y[0, 0]), (RACE, found.y[0, -1])):
        assert grown(diameter, omega) == pytest.approx(2 * u, rel=1e-6)
