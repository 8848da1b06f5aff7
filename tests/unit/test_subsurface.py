"""Subsurface stresses against brute-force integration of point loads, and known limits."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import optimize

from rolamento.contact import subsurface
from rolamento.contact.subsurface import (
    ShearPlane,
    axis_stresses,
    maximum_shear,
    orthogonal_shear,
    point_stresses,
)


def boussinesq(
    point: tuple[float, float, float], k: float, nu: float
) -> tuple[float, float, float, float]:
    """σ_x, σ_y, σ_z, τ_xz at a point, summed over point loads; b = 1, a = k, p0 = 1.

    Each element of the pressure √(1 - x² - y²/k²) loads the half-space as a point force
    (Johnson, section 3.2).
    """
    count = 260
    node, weight = np.polynomial.legendre.leggauss(count)
    u = 0.25 * np.pi * (node + 1.0)
    theta = np.pi * np.arange(2 * count) / count
    radius = np.sin(u)[:, None]
    element = k * np.cos(u) ** 2 * np.sin(u) * weight * 0.25 * np.pi * np.pi / count
    x, y, z = point
    dx, dy = x - radius * np.cos(theta), y - k * radius * np.sin(theta)
    plane = dx**2 + dy**2
    rho = np.sqrt(plane + z * z)
    c = element[:, None] / (2.0 * np.pi)

    def direct(p: np.ndarray, q: np.ndarray) -> float:
        bend = (1.0 - z / rho) * (p**2 - q**2) / plane**2 + z * q**2 / (rho**3 * plane)
        return float((c * ((1.0 - 2.0 * nu) * bend - 3.0 * z * p**2 / rho**5)).sum())

    normal = float((-3.0 * c * z**3 / rho**5).sum())
    shear = float((-3.0 * c * dx * z**2 / rho**5).sum())
    return direct(dx, dy), direct(dy, dx), normal, shear


@pytest.mark.parametrize("k", [1.0, 1.0001, 2.0, 8.0])
@pytest.mark.parametrize("zeta", [0.25, 0.8, 3.0])
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_axis_stresses_equal_the_sum_of_point_loads(k: float, zeta: float, nu: float) -> None:
    stresses = axis_stresses(zeta, 1.0, k, 1.0, nu)
    expected = boussinesq((1e-9, 0.0, zeta), k, nu)[:3]
    found = (stresses.minor, stresses.major, stresses.normal)
    np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize("k", [1.0, 3.0, 9.0])
@pytest.mark.parametrize("point", [(0.7, 0.4, 0.5), (-1.3, 0.0, 0.6), (0.2, -5.0, 1.5)])
def test_point_stresses_equal_the_sum_of_point_loads(
    k: float, point: tuple[float, float, float]
) -> None:
    stresses = point_stresses(*point, 1.0, k, 1.0)
    *_, normal, shear = boussinesq(point, k, 0.3)
    assert stresses.normal == pytest.approx(normal, abs=1e-10)
    assert stresses.shear == pytest.approx(shear, abs=1e-10)


def test_surface_stresses_at_the_centre() -> None:
    """Johnson, section 4.2(c): -p0 [2ν + (1 - 2ν) b/(a+b)] along a, and with a along b."""
    k, nu = np.array([1.0, 2.0, 10.0]), 0.27
    stresses = axis_stresses(0.0, 2.0, k, 1.0, nu)
    np.testing.assert_allclose(stresses.major, -2.0 * (2 * nu + (1 - 2 * nu) / (1 + k)))
    np.testing.assert_allclose(stresses.minor, -2.0 * (2 * nu + (1 - 2 * nu) * k / (1 + k)))
    np.testing.assert_allclose(stresses.normal, -2.0)


def test_circle_has_its_closed_form_and_is_no_seam() -> None:
    zeta = np.linspace(0.0, 5.0, 41)
    exact = axis_stresses(zeta, 1.0, 1.0, 1.0, 0.3)
    angle = np.arctan2(1.0, zeta)
    radial = -1.3 * (1.0 - zeta * angle) + 0.5 / (1.0 + zeta**2)
    np.testing.assert_allclose(exact.minor, radial, atol=1e-14)
    np.testing.assert_allclose(exact.major, radial, atol=1e-14)
    np.testing.assert_allclose(exact.normal, -1.0 / (1.0 + zeta**2), atol=1e-15)
    near = axis_stresses(zeta, 1.0, 1.0 + 1e-9, 1.0, 0.3)
    np.testing.assert_allclose(near.minor, exact.minor, atol=3e-9)


def test_greatest_shear_of_circle_and_line() -> None:
    found = maximum_shear(1.0, [1.0, 1e8], 1.0, 0.3)
    np.testing.assert_allclose(found.shear, [0.310, 0.300], atol=5e-4)
    np.testing.assert_allclose(found.depth, [0.481, 0.786], atol=5e-4)
    # Line contact, closed form: (σ_x - σ_z)/2 = p0 ζ (1 - ζ/√(1 + ζ²)).
    line = optimize.minimize_scalar(
        lambda z: -z * (1.0 - z / np.hypot(1.0, z)), bounds=(0.1, 2.0), options={"xatol": 1e-10}
    )
    assert found.shear[1] == pytest.approx(-line.fun, abs=1e-8)
    assert found.depth[1] == pytest.approx(line.x, abs=1e-5)


def test_greatest_shear_is_the_greatest_of_a_fine_search() -> None:
    zeta = np.linspace(0.0, 3.0, 30001)
    for k, nu in [(1.3, 0.3), (5.0, 0.26), (9.0, 0.1), (40.0, 0.0), (2.0, 0.45)]:
        s = axis_stresses(zeta, 1.0, k, 1.0, nu)
        shears = 0.5 * np.abs([s.minor - s.normal, s.major - s.normal, s.minor - s.major])
        found = maximum_shear(1.0, k, 1.0, nu)
        assert found.shear == pytest.approx(shears.max(), abs=1e-8)
        plane, place = np.unravel_index(np.argmax(shears), shears.shape)
        assert found.depth == pytest.approx(zeta[place], abs=2e-4)
        assert found.plane == plane


def test_maximum_shear_is_a_peak_for_all_ellipses_and_materials() -> None:
    """By a search of its own: the derivative has a root there, and no point is higher."""
    k, nu = np.meshgrid(
        np.concatenate([[1.0, 1.0001], np.geomspace(1.01, 1e4, 25), [1e8]]),
        np.linspace(0.0, 0.49, 15),
    )
    found = maximum_shear(1.0, k, 1.0, nu)
    lower, upper = np.maximum(found.depth - 0.02, 0.0), found.depth + 0.02

    def shears(depth: np.ndarray) -> np.ndarray:
        s = axis_stresses(depth, 1.0, k, 1.0, nu)
        return 0.5 * np.abs([s.minor - s.normal, s.major - s.normal, s.minor - s.major])

    def own(depth: np.ndarray) -> np.ndarray:
        return np.take_along_axis(shears(depth), found.plane[np.newaxis], axis=0)[0]

    golden = 0.5 * (np.sqrt(5.0) - 1.0)
    for _ in range(60):
        near, far = upper - golden * (upper - lower), lower + golden * (upper - lower)
        rising = own(near) < own(far)
        lower, upper = np.where(rising, near, lower), np.where(rising, upper, far)
    np.testing.assert_allclose(found.shear, own(0.5 * (lower + upper)), rtol=1e-13)
    np.testing.assert_allclose(found.depth, 0.5 * (lower + upper), atol=1e-7)
    for depth in np.linspace(0.0, 1.5, 61):
        assert np.all(shears(np.full(k.shape, depth)).max(axis=0) <= found.shear * (1.0 + 1e-12))


def test_the_upright_plane_never_has_the_maximum() -> None:
    k, nu, zeta = np.meshgrid(
        np.geomspace(1.0, 1e4, 25), np.linspace(0.0, 0.49, 11), np.linspace(0.0, 5.0, 101)
    )
    s = axis_stresses(zeta, 1.0, k, 1.0, nu)
    beside = np.maximum(np.abs(s.minor - s.normal), np.abs(s.major - s.normal))
    assert np.all(np.abs(s.minor - s.major) <= beside)


def test_the_two_planes_are_alike_in_a_line_contact_at_0_2424() -> None:
    """Above that the search across rolling is left out: no ellipse has its maximum there."""
    plane = maximum_shear(1.0, 1e8, 1.0, [0.242, 0.2425]).plane
    np.testing.assert_array_equal(plane, [ShearPlane.TRANSVERSE, ShearPlane.ROLLING])
    slender = maximum_shear(1.0, np.geomspace(1.0001, 1e4, 60), 1.0, 0.2429)
    np.testing.assert_array_equal(slender.plane, ShearPlane.ROLLING)
    assert subsurface._ROLLING_ALONE > 0.2425


@pytest.mark.parametrize("nu", [0.3, 0.1])
def test_the_compiled_loop_gives_the_same_to_the_last_bit(nu: float) -> None:
    k = np.geomspace(1.0, 60.0, 50)
    for plane, across in ((ShearPlane.ROLLING, 0.0), (ShearPlane.TRANSVERSE, 1.0)):
        start, out = subsurface._start(k, np.full(50, nu), plane), np.empty((2, 50))
        given = (k, np.full(50, nu), start, np.full(50, across))
        subsurface._fill_peak.compiled(*given, out)
        np.testing.assert_array_equal(out, subsurface._peak(*given))


def test_plane_of_the_greatest_shear_changes_with_poissons_ratio() -> None:
    assert maximum_shear(1.0, 8.0, 1.0, 0.3).plane == ShearPlane.ROLLING
    assert maximum_shear(1.0, 8.0, 1.0, 0.0).plane == ShearPlane.TRANSVERSE


def test_orthogonal_shear_is_the_peak_of_the_field() -> None:
    """The closed forms against a search through the stress field."""
    for k in (1.0, 2.5, 12.0):
        closed = orthogonal_shear(1.0, k, 1.0)

        def swing(v: np.ndarray, k: float = k) -> float:
            return -abs(float(point_stresses(v[0], 0.0, v[1], 1.0, k, 1.0).shear))

        peak = optimize.minimize(swing, [0.85, 0.45], method="Nelder-Mead", tol=1e-13)
        assert closed.amplitude == pytest.approx(-peak.fun, rel=1e-10)
        assert closed.depth == pytest.approx(peak.x[1], rel=1e-5)


def test_orthogonal_shear_of_circle_and_line() -> None:
    found = orthogonal_shear(4.0, [2.0, 2e9], 2.0)
    assert found.amplitude[1] == pytest.approx(1.0, rel=1e-12)
    assert found.depth[1] == pytest.approx(1.0, rel=1e-12)
    t = (1.0 + np.sqrt(17.0)) / 4.0
    assert found.depth[0] == pytest.approx(2.0 / ((t + 1.0) * np.sqrt(2.0 * t - 1.0)))


def test_field_meets_the_boundary_conditions() -> None:
    x = np.array([0.0, 0.5, -0.5, 1.5])
    surface = point_stresses(x, 0.3, 0.0, 3.0, 2.0, 1.0)
    pressure = 3.0 * np.sqrt(np.maximum(0.0, 1.0 - x**2 - 0.15**2))
    np.testing.assert_allclose(surface.normal, -pressure)
    np.testing.assert_array_equal(surface.shear, 0.0)
    below = point_stresses(x, 0.3, 1e-9, 3.0, 2.0, 1.0)
    np.testing.assert_allclose(below.normal, -pressure, atol=1e-7)
    np.testing.assert_allclose(below.shear, 0.0, atol=1e-7)


def test_field_on_the_axis_is_the_axis_solution() -> None:
    z = np.geomspace(1e-3, 10.0, 20)
    field = point_stresses(0.0, 0.0, z, 1.0, 6.0, 1.0)
    np.testing.assert_allclose(field.normal, axis_stresses(z, 1.0, 6.0, 1.0, 0.3).normal)
    np.testing.assert_array_equal(field.shear, 0.0)


def test_field_in_equilibrium() -> None:
    """The normal stress on any plane below the surface carries the whole load."""
    edge = 400.0
    u, w = np.polynomial.legendre.leggauss(400)
    x, wx = np.sinh(np.arcsinh(edge) * u), np.arcsinh(edge) * np.cosh(np.arcsinh(edge) * u) * w
    grid = point_stresses(x[:, None], x[None, :], 0.7, 1.0, 4.0, 1.0)
    total = -float(wx @ grid.normal @ wx)
    assert total == pytest.approx(2.0 / 3.0 * np.pi * 4.0, rel=1e-5)


def test_unloaded_contact_has_no_stress() -> None:
    assert maximum_shear(0.0, 0.0, 0.0, 0.3).shear == 0.0
    assert orthogonal_shear(0.0, 0.0, 0.0).depth == 0.0
    assert axis_stresses(1.0, 0.0, 0.0, 0.0, 0.3).minor == 0.0
    assert np.isnan(point_stresses(0.0, 0.0, -1.0, 1.0, 2.0, 1.0).normal)


def test_vectorised_as_one_by_one() -> None:
    k, nu = np.array([[1.0], [4.0]]), np.array([0.2, 0.3, 0.4])
    together = maximum_shear(2.0, 1e-3 * k, 1e-3, nu)
    assert together.shear.shape == (2, 3)
    alone = maximum_shear(2.0, 4e-3, 1e-3, 0.3)
    assert together.depth[1, 1] == pytest.approx(float(alone.depth), rel=1e-12)
