"""The slice law, the Hertz line contact and the stresses beneath it."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import integrate

import rolamento
from rolamento.case.material import Material
from rolamento.contact.hertz import effective_modulus, elliptical_contact
from rolamento.contact.line import (
    EXPONENT,
    contact_constant,
    half_width,
    max_pressure,
    pair_constant,
    roller_share,
    slice_places,
)
from rolamento.contact.slices import independent_slices
from rolamento.contact.subsurface import (
    ShearPlane,
    line_maximum_shear,
    line_orthogonal_shear,
    line_stresses,
    line_von_mises,
    maximum_shear,
)

STEEL = Material.named("100Cr6")
MODULUS = effective_modulus(STEEL, STEEL)
L, N = 9e-3, 35


def slices(
    approach: float, tilt: float, drop: np.ndarray, constant: float
) -> tuple[int, np.ndarray, np.ndarray]:
    place, load, answer = slice_places(L, drop.size), np.empty(drop.size), np.empty(6)
    number = independent_slices(approach, tilt, place, drop, L / drop.size, constant, load, answer)
    return number, load, answer


def test_constant_of_the_standard_for_steel() -> None:
    # 35948 L_we^(8/9) in N and mm
    assert pair_constant(1e-3, MODULUS) * 1e-3**EXPONENT == pytest.approx(35948.0, rel=1e-12)
    assert pair_constant(9e-3, MODULUS) * 1e-3**EXPONENT == pytest.approx(
        35948.0 * 9.0 ** (8.0 / 9.0), rel=1e-12
    )


def test_two_contacts_in_line_make_the_pair() -> None:
    load = 1234.0
    one = (load / contact_constant(L, MODULUS)) ** 0.9
    both = (load / pair_constant(L, MODULUS)) ** 0.9
    assert 2.0 * one == pytest.approx(both, rel=1e-12)


def test_stiffer_bodies_scale_the_law_as_its_dimensions_say() -> None:
    # a body k times as stiff under k times the load is deformed alike
    assert pair_constant(L, 1.7 * MODULUS) == pytest.approx(1.7 * pair_constant(L, MODULUS))
    # and all lengths m times as long carry m² times the load at m times the deflection
    load, longer = pair_constant(L, MODULUS) * 1e-5**EXPONENT, pair_constant(3 * L, MODULUS)
    assert longer * 3e-5**EXPONENT == pytest.approx(9.0 * load, rel=1e-12)


def test_rollers_part_of_the_compliance() -> None:
    ceramic = Material.named("Si3N4")
    assert roller_share(STEEL, STEEL) == pytest.approx(0.5)
    assert roller_share(ceramic, STEEL) + roller_share(STEEL, ceramic) == pytest.approx(1.0)
    assert roller_share(ceramic, STEEL) < 0.42


def test_line_contact_is_the_limit_of_slender_ellipses() -> None:
    q, rho = 2e5, 300.0
    slender = elliptical_contact(1.0, rho, 1e-9 * rho, MODULUS)
    # of an ellipse, the load per length in its middle plane is 3Q/(4a)
    middle = 0.75 / slender.semi_major
    assert half_width(middle, rho, MODULUS) == pytest.approx(slender.semi_minor, rel=1e-6)
    assert max_pressure(middle, rho, MODULUS) == pytest.approx(slender.max_pressure, rel=1e-6)
    b, p0 = half_width(q, rho, MODULUS), max_pressure(q, rho, MODULUS)
    assert 0.5 * np.pi * b * p0 == pytest.approx(q, rel=1e-14)
    assert np.isnan(half_width(-1.0, rho, MODULUS))


def test_slices_fill_the_length() -> None:
    places = slice_places(np.array([L, 2 * L]), N)
    assert places.shape == (2, N)
    np.testing.assert_allclose(places, -places[:, ::-1])
    assert places[0, -1] + 0.5 * L / N == pytest.approx(0.5 * L)
    assert places[1, N // 2] == 0.0


def test_straight_slices_without_tilt_are_the_closed_form() -> None:
    constant = pair_constant(L, MODULUS)
    for n in (1, 5, 35, 1001):
        number, load, answer = slices(8e-6, 0.0, np.zeros(n), constant / L)
        assert number == 0
        assert answer[0] == pytest.approx(constant * 8e-6**EXPONENT, rel=1e-12)
        assert answer[1] == pytest.approx(0.0, abs=1e-9)
        np.testing.assert_allclose(load, answer[0] / L)


def test_tilted_slices_tend_to_the_integral_of_the_law() -> None:
    constant = pair_constant(L, MODULUS) / L
    tilt, approach = 2e-3, 5e-6  # a part of the roller is free
    start = -approach / tilt
    load = integrate.quad(lambda x: constant * (approach + tilt * x) ** EXPONENT, start, L / 2)[0]
    moment = integrate.quad(
        lambda x: constant * x * (approach + tilt * x) ** EXPONENT, start, L / 2
    )[0]
    errors = []
    for n in (11, 101, 1001):
        answer = slices(approach, tilt, np.zeros(n), constant)[2]
        errors.append(abs(answer[0] / load - 1.0) + abs(answer[1] / moment - 1.0))
    assert errors[2] < 1e-4 < errors[0] < 0.02
    assert errors[2] < 0.2 * errors[1]


def test_derivatives_of_slices() -> None:
    drop = 0.5 * slice_places(L, N) ** 2
    constant = contact_constant(L, MODULUS) / L
    number, _, answer = slices(6e-6, 1e-3, drop, constant)
    assert number == 0
    steps = ((1e-10, 0.0), (0.0, 1e-8))
    for column, (d, t) in enumerate(steps):
        after = slices(6e-6 + d, 1e-3 + t, drop, constant)[2]
        before = slices(6e-6 - d, 1e-3 - t, drop, constant)[2]
        slope = (after[:2] - before[:2]) / (2.0 * (d + t))
        np.testing.assert_allclose(answer[2:].reshape(2, 2)[:, column], slope, rtol=1e-6)


def test_slices_apart_bear_nothing_and_no_number_is_told() -> None:
    number, load, answer = slices(-1e-6, 0.0, np.zeros(N), 1e15)
    assert number == 0
    assert not answer.any()
    assert not load.any()
    drop = np.zeros(N)
    drop[[0, -1]] = np.inf
    number, load, answer = slices(1e-6, 0.0, drop, 1e15)
    assert number == 0
    assert load[0] == load[-1] == 0.0
    for bad in (np.nan, np.inf):
        number, _, answer = slices(bad, 0.0, np.zeros(N), 1e15)
        assert number == 1
        assert np.isnan(answer).all()


@pytest.mark.parametrize(("x", "z"), [(0.0, 0.3), (0.5, 0.7), (-0.9, 0.2), (1.4, 1.0)])
def test_stresses_are_the_sum_of_line_loads(x: float, z: float) -> None:
    # Flamant: σ_r = -2P cos θ/(π r), the rest zero (Johnson, section 2.3)
    node, weight = np.polynomial.legendre.leggauss(120)
    angle = 0.5 * np.pi * node
    p = weight * 0.5 * np.pi * np.cos(angle) ** 2
    dx = x - np.sin(angle)
    r2 = dx * dx + z * z
    radial = -2.0 * p * z / (np.pi * r2)
    expected = [
        float((radial * dx * dx / r2).sum()),
        float((radial * z * z / r2).sum()),
        float((radial * dx * z / r2).sum()),
    ]
    found = line_stresses(x, z, 1.0, 1.0, 0.3)
    np.testing.assert_allclose([found.rolling, found.normal, found.shear], expected, atol=1e-9)
    assert found.along == pytest.approx(0.3 * (expected[0] + expected[1]), abs=1e-9)


def test_surface_bears_the_pressure_and_no_shear() -> None:
    x = np.array([0.0, 0.5, 1.0, 1.5])
    surface = line_stresses(x, 0.0, 1.0, 1.0, 0.3)
    pressure = np.sqrt(np.maximum(0.0, 1.0 - x * x))
    np.testing.assert_allclose(surface.normal, -pressure, atol=1e-12)
    np.testing.assert_allclose(surface.rolling, -pressure, atol=1e-12)
    np.testing.assert_allclose(surface.shear, 0.0, atol=1e-12)
    assert np.isnan(line_stresses(0.0, -1.0, 1.0, 1.0, 0.3).normal)
    assert np.isnan(line_stresses(0.0, 0.0, 1.0, 0.0, 0.3).normal)


@pytest.mark.parametrize("nu", [0.0, 0.15, 0.23, 0.25, 0.3, 0.45])
def test_maximum_shear_is_the_limit_of_slender_ellipses(nu: float) -> None:
    line, ellipse = line_maximum_shear(2e9, 1e-4, nu), maximum_shear(2e9, 3.0, 1e-4, nu)
    assert line.plane == ellipse.plane
    assert line.shear == pytest.approx(ellipse.shear, rel=1e-4)
    assert line.depth == pytest.approx(ellipse.depth, rel=1e-3, abs=1e-9)


def test_shears_of_the_whole_field() -> None:
    x, z = np.meshgrid(np.linspace(-2.0, 2.0, 401), np.linspace(0.0, 2.0, 401))
    field = line_stresses(x, z, 1.0, 1.0, 0.3)
    orthogonal = line_orthogonal_shear(1.0, 1.0)
    assert np.abs(field.shear).max() == pytest.approx(orthogonal.amplitude, rel=1e-4)
    assert z.flat[np.abs(field.shear).argmax()] == pytest.approx(orthogonal.depth, abs=0.01)
    most = line_von_mises(1.0, 1.0, 0.3)
    assert field.von_mises.max() == pytest.approx(most.stress, rel=1e-4)
    assert z.flat[field.von_mises.argmax()] == pytest.approx(most.depth, abs=0.01)
    assert line_maximum_shear(1.0, 1.0, 0.3).plane == ShearPlane.ROLLING


def test_a_result_has_the_stresses_of_line_contacts() -> None:
    solved = rolamento.solve(
        rolamento.Case.from_mapping(
            {
                "bearing": {
                    "element": "cylindrical",
                    "roller_count": 13,
                    "roller_diameter": "7.5 mm",
                    "effective_length": "9 mm",
                    "pitch_diameter": "39 mm",
                    "diametral_clearance": "20 um",
                },
                "duty": {"load": {"fz": "5 kN"}, "displacement": {"ry": "1 mrad"}},
            }
        )
    )
    assert solved.converged.all()
    inner = solved.inner
    loaded = inner.load[0] > 0.0
    np.testing.assert_allclose(
        inner.max_shear[0, loaded] / inner.max_pressure[0, loaded], 0.30028, rtol=1e-4
    )
    np.testing.assert_allclose(
        inner.orthogonal_shear_depth[0, loaded] / inner.semi_minor[0, loaded], 0.5, rtol=1e-12
    )
