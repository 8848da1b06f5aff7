"""Elliptical Hertz contact against its defining equations and limits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from scipy import integrate, special

from rolamento.contact.hertz import (
    brewe_hamrock_ellipticity,
    contact_stiffness,
    effective_modulus,
    elliptical_contact,
    ellipticity,
    hertz_coefficients,
    series_stiffness,
)


@dataclass(frozen=True)
class Elastic:
    youngs_modulus: float
    poisson_ratio: float


STEEL = Elastic(207e9, 0.3)
CERAMIC = Elastic(310e9, 0.26)
MODULUS = effective_modulus(STEEL, STEEL)


def test_effective_modulus() -> None:
    assert pytest.approx(207e9 / 0.91) == MODULUS
    mixed = effective_modulus(STEEL, CERAMIC)
    assert mixed == effective_modulus(CERAMIC, STEEL)
    assert mixed == pytest.approx(2.0 / (0.91 / 207e9 + (1.0 - 0.26**2) / 310e9))


def test_ellipticity_satisfies_the_classical_equation() -> None:
    """F = ((k²+1) E - 2 K)/((k²-1) E), with SciPy's integrals."""
    f = np.concatenate([np.linspace(0.01, 0.999, 200), 1.0 - np.geomspace(1e-9, 1e-3, 30)])
    k = ellipticity(f)
    first, second = special.ellipkm1(k**-2), special.ellipe(1.0 - k**-2)
    back = ((k**2 + 1.0) * second - 2.0 * first) / ((k**2 - 1.0) * second)
    np.testing.assert_allclose(back, f, rtol=0.0, atol=2e-14)


def test_ellipticity_keeps_its_digits_near_a_circle_and_near_a_line() -> None:
    small = np.array([0.0, 1e-15, 1e-9, 1e-6])
    np.testing.assert_allclose(ellipticity(small) - 1.0, 4.0 / 3.0 * small, rtol=2e-6, atol=4e-16)
    ratio = np.geomspace(1e-14, 1e-3, 20)  # ρ_min/ρ_max, straight from the curvatures
    k = elliptical_contact(1.0, 1.0, ratio, 1.0).ellipticity
    b = k**-2 * special.elliprd(0.0, 1.0, k**-2)
    d = special.elliprd(0.0, k**-2, 1.0)
    np.testing.assert_allclose(d / (k**2 * b), ratio, rtol=2e-14)


def test_ellipticity_outside_its_range_is_nan() -> None:
    assert np.all(np.isnan(ellipticity([-1e-9, 1.0, 1.1, np.nan, np.inf])))


def test_ellipticity_shape_and_order() -> None:
    f = np.linspace(0.0, 0.99, 12).reshape(3, 4)
    k = ellipticity(f)
    assert k.shape == (3, 4)
    assert np.all(np.diff(k.ravel()) > 0.0)


def test_circle_is_the_sphere_on_a_plane() -> None:
    """Closed forms for a sphere of radius R on a plane (Johnson, section 4.2(a))."""
    radius, load = 0.01, 50.0
    star = 0.5 * MODULUS
    contact = elliptical_contact(load, 1.0 / radius, 1.0 / radius, MODULUS)
    a = np.cbrt(0.75 * load * radius / star)
    assert contact.semi_major == pytest.approx(a, rel=1e-14)
    assert contact.semi_minor == pytest.approx(a, rel=1e-14)
    assert contact.deflection == pytest.approx(a**2 / radius, rel=1e-14)
    assert contact.max_pressure == pytest.approx(1.5 * load / (np.pi * a**2), rel=1e-14)
    assert contact.stiffness == pytest.approx(4.0 / 3.0 * star * np.sqrt(radius), rel=1e-14)


def test_narrow_ellipse_tends_to_the_line_contact() -> None:
    """Locally a line contact under the load per length at the middle, 3Q/(4a)."""
    contact = elliptical_contact(1000.0, 200.0, 1e-6, MODULUS)
    per_length = 0.75 * contact.load / contact.semi_major
    half_width = np.sqrt(8.0 * per_length / (np.pi * 200.0 * MODULUS))
    assert contact.ellipticity > 1e3
    assert contact.semi_minor == pytest.approx(half_width, rel=1e-5)


def test_surfaces_meet_inside_the_ellipse() -> None:
    """The surface displacement of the Hertz pressure closes the gap: δ - ½ ρ_x x² - ½ ρ_y y².

    The displacement is integrated by brute force in polar coordinates about the point (the
    Boussinesq kernel 1/r loses its pole), with nothing taken from the code but a, b, p0, δ.
    """
    rx, ry = 160.0, 12.0
    contact = elliptical_contact(3000.0, rx, ry, MODULUS)
    a, b, p0 = (float(v) for v in (contact.semi_major, contact.semi_minor, contact.max_pressure))
    theta = 2.0 * np.pi * (np.arange(4000) + 0.5) / 4000
    cos, sin = np.cos(theta), np.sin(theta)
    for x, y in [(0.0, 0.0), (0.6 * b, 0.0), (0.0, 0.7 * a), (-0.4 * b, 0.5 * a)]:
        # Pressure along a ray: p0 √(c0 - 2 c1 s - c2 s²), whose integral is elementary.
        c2 = (cos / b) ** 2 + (sin / a) ** 2
        c1 = x * cos / b**2 + y * sin / a**2
        c0 = 1.0 - (x / b) ** 2 - (y / a) ** 2
        root = np.sqrt(c0 * c2 + c1**2)
        chord = 0.5 * root**2 / c2**1.5 * (np.arccos(c1 / root) - c1 / root**2 * np.sqrt(c0 * c2))
        closing = 2.0 / (np.pi * MODULUS) * p0 * chord.mean() * 2.0 * np.pi
        gap = contact.deflection - 0.5 * rx * x**2 - 0.5 * ry * y**2
        assert closing == pytest.approx(float(gap), rel=1e-9)


def test_load_is_the_integral_of_the_pressure() -> None:
    contact = elliptical_contact([10.0, 1e4], 160.0, 12.0, MODULUS)
    area = np.pi * contact.semi_major * contact.semi_minor
    np.testing.assert_allclose(contact.mean_pressure * area, contact.load)
    dome = integrate.quad(lambda r: np.sqrt(1.0 - r * r) * 2.0 * r, 0.0, 1.0)[0]
    np.testing.assert_allclose(contact.max_pressure * area * dome, contact.load)


def test_stiffness_carries_the_load() -> None:
    contact = elliptical_contact(777.0, 160.0, 12.0, MODULUS)
    assert contact.stiffness * contact.deflection**1.5 == pytest.approx(777.0)
    assert contact.stiffness == contact_stiffness(160.0, 12.0, MODULUS)


def test_direction_of_the_lesser_curvature_does_not_change_the_ellipse() -> None:
    one, other = (elliptical_contact(5.0, *pair, MODULUS) for pair in [(100, 20), (20, 100)])
    assert one == other


def test_no_load_gives_zeros_and_bad_input_nan() -> None:
    contact = elliptical_contact([0.0, -1.0, np.nan, 1.0, 1.0], [9, 9, 9, -9, 9], 3.0, MODULUS)
    for name in ("semi_major", "semi_minor", "deflection", "max_pressure", "mean_pressure"):
        np.testing.assert_array_equal(np.isnan(getattr(contact, name)), [0, 1, 1, 1, 0])
        assert getattr(contact, name)[0] == 0.0
    assert contact.stiffness[0] > 0.0


def test_coefficients_are_those_of_the_contact() -> None:
    rolling, across, load = 160.0, 12.0, 500.0
    total = rolling + across
    size = np.cbrt(3.0 * load / (total * MODULUS))
    star = hertz_coefficients((rolling - across) / total)
    contact = elliptical_contact(load, rolling, across, MODULUS)
    assert contact.semi_major == pytest.approx(float(star.semi_major * size), rel=1e-13)
    assert contact.semi_minor == pytest.approx(float(star.semi_minor * size), rel=1e-13)
    deflection = float(star.deflection * size**2 * total / 2.0)
    assert contact.deflection == pytest.approx(deflection, rel=1e-13)


def test_series_stiffness_adds_deflections() -> None:
    total = (100.0 / 3e9) ** (2 / 3) + (100.0 / 5e9) ** (2 / 3)
    assert series_stiffness(3e9, 5e9) * total**1.5 == pytest.approx(100.0)


def test_brewe_hamrock_fit_is_near_the_exact_ellipticity_and_not_equal() -> None:
    ratio = np.array([1.5, 5.0, 20.0, 60.0])
    exact = elliptical_contact(1.0, ratio, 1.0, 1.0).ellipticity
    deviation = brewe_hamrock_ellipticity(ratio) / exact - 1.0
    assert np.all(np.abs(deviation) < 0.04)
    assert np.all(np.abs(deviation) > 1e-4)
