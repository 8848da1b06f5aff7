"""The shear field, its integral, and the life by stress volume."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import simpson

from rolamento.contact.hertz import elliptical_contact
from rolamento.contact.subsurface import orthogonal_shear, point_stresses
from rolamento.errors import InputError
from rolamento.geometry import race_curvature
from rolamento.life.ioannides_harris import (
    FATIGUE_LIMIT,
    Ellipses,
    fatigue_limit_of_pressure,
    material_constant,
    race_risk,
    risk_integral,
    stress_volume_life,
)
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.life.shear_field import FieldMesh, passing_shear, shear_integrals
from rolamento.numerics import FloatArray

EXPONENTS = {"stress_exponent": 31.0 / 3.0, "depth_exponent": 7.0 / 3.0}
MODULUS = 207e9 / 0.91
LOADS = np.array([[0.0, 300.0, 1200.0, 1500.0, 1200.0, 300.0, 0.0]])
# C, Z, D, d_m, f_i, f_o, alpha
BEARING = (23400.0, 7, 0.0115, 0.0435, 0.52, 0.53, 0.0)


def _ellipses(loads: FloatArray, race: str, conformity: float) -> Ellipses:
    curvature = race_curvature(0.0115, 0.0435, conformity, 0.0, race)  # type: ignore[arg-type]
    hertz = elliptical_contact(loads, curvature.rolling, curvature.across, MODULUS)
    return Ellipses(hertz.semi_major, hertz.semi_minor, hertz.max_pressure)


def _life(limit: float, **more: object) -> FloatArray:
    reference = reference_life(LOADS, LOADS, race_ratings(*BEARING))
    found = stress_volume_life(
        reference,
        _ellipses(LOADS, "inner", 0.52),
        _ellipses(LOADS, "outer", 0.53),
        fatigue_limit=limit,
        **more,  # type: ignore[arg-type]
    )
    return found.life


def test_field_has_the_orthogonal_shear_at_its_depth() -> None:
    for k in (1.0, 3.0, 8.0, 40.0):
        known = orthogonal_shear(1.0, k, 1.0)
        peak = passing_shear(0.0, known.depth, k)
        assert peak == pytest.approx(float(known.amplitude), rel=1e-9)
        around = passing_shear([0.0, 0.0, 0.1], known.depth * np.array([0.95, 1.05, 1.0]), k)
        assert np.all(around < peak)


def test_field_is_the_greatest_along_x() -> None:
    x = np.linspace(0.0, 32.0, 320_001)
    points = ((0.0, 0.05, 8.0), (0.9, 0.3, 8.0), (1.2, 0.5, 2.0), (0.3, 4.0, 1.0))
    far = ((1.45, 1.8, 17.0), (1.0, 0.01, 5.0), (1.5, 0.2, 60.0))
    for eta, zeta, k in (*points, *far):
        scan = np.abs(point_stresses(x, eta * k, zeta, 1.0, k, 1.0).shear).max()
        assert passing_shear(eta, zeta, k) == pytest.approx(float(scan), rel=1e-5)


@pytest.mark.parametrize("threshold", [0.0, 0.1, 0.17])
@pytest.mark.thirds
@pytest.mark.sweep
def test_mesh_converges(threshold: float) -> None:
    shapes = np.array([1.0, 2.0, 8.0, 20.0, 55.0])
    t = np.full(shapes.shape, threshold)
    fine = shear_integrals(t, shapes, mesh=FieldMesh(64, 96), **EXPONENTS).local
    errors = [
        float(np.max(np.abs(shear_integrals(t, shapes, mesh=mesh, **EXPONENTS).local / fine - 1.0)))
        for mesh in (FieldMesh(8, 12), FieldMesh(16, 24), FieldMesh())
    ]
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-4


@pytest.mark.parametrize(("threshold", "coarse"), [(0.0, 12), (0.1, 16), (0.17, 24)])
def test_order_of_the_mesh(threshold: float, coarse: int) -> None:
    """Twice the points each way: the error falls with their tenth power or so.

    The integrand is analytic but for the edge of the stressed region, where it grows with the power
    31/3. The higher the threshold, the smaller the region and the later this begins.
    """
    shapes = np.array([1.0, 2.0, 8.0, 20.0, 55.0])
    t = np.full(shapes.shape, threshold)

    def integral(points: int) -> FloatArray:
        mesh = FieldMesh(points, 3 * points // 2)
        return shear_integrals(t, shapes, mesh=mesh, **EXPONENTS).local

    exact = integral(64)
    first, second = (
        float(np.max(np.abs(integral(points) / exact - 1.0))) for points in (coarse, 2 * coarse)
    )
    assert 1e-12 < second < 1e-6
    assert np.log2(first / second) > 9.0


def test_integral_by_another_rule() -> None:
    """The sum beside Simpson's rule over the exact field, for a shape that is not tabulated."""
    k, threshold = 7.3, 0.13
    eta, zeta = np.linspace(0.0, 1.5, 201), np.linspace(0.04, 2.84, 281)
    shear = passing_shear(eta[:, np.newaxis], zeta, k)
    edge = (shear[-1].max(), shear[:, 0].max(), shear[:, -1].max())
    assert max(edge) < threshold  # all that is stressed beyond it lies inside
    risk = np.maximum(shear - threshold, 0.0) ** (31.0 / 3.0) * zeta ** (-7.0 / 3.0)
    expected = 2.0 * float(simpson(simpson(risk, x=zeta), x=eta))
    found = shear_integrals(np.array([threshold]), np.array([k]), **EXPONENTS).local
    assert found[0] == pytest.approx(expected, rel=1e-5)


def test_shapes_are_interpolated() -> None:
    """A shape between the tabulated ones, integrated on a plain grid of its own."""
    k = 5.0
    node, weight = np.polynomial.legendre.leggauss(60)
    eta, w_eta = 0.75 * (node + 1.0), 0.75 * weight
    zeta, w_zeta = 3.0 * (node + 1.0), 3.0 * weight
    shear = passing_shear(eta[:, np.newaxis], zeta, k)
    plain = 2.0 * w_eta @ (shear ** (31 / 3) * zeta ** (-7 / 3)) @ w_zeta
    found = shear_integrals(np.zeros(1), np.array([k]), **EXPONENTS).local
    assert found[0] == pytest.approx(float(plain), rel=1e-5)


def test_risk_grows_with_lundberg_and_palmgrens_power() -> None:
    loads = np.array([100.0, 200.0, 1600.0])
    risk = risk_integral(_ellipses(loads, "inner", 0.52), 0.0)
    assert risk[1:] / risk[0] == pytest.approx([2.0 ** (10 / 3), 16.0 ** (10 / 3)], rel=1e-9)
    mean = risk_integral(_ellipses(loads, "inner", 0.52), 0.0, depth="mean")
    assert mean[1:] / mean[0] == pytest.approx([2.0 ** (10 / 3), 16.0 ** (10 / 3)], rel=1e-9)
    # the mean depth is the greater one, by a third or so
    assert 0.65 < (mean[0] / risk[0]) ** (3.0 / 7.0) < 1.0


def test_risk_without_load_and_without_result() -> None:
    loads = np.array([0.0, np.nan, 50.0])
    risk = risk_integral(_ellipses(loads, "inner", 0.52), 2e9)
    assert risk[0] == 0.0
    assert np.isnan(risk[1])
    assert risk[2] == 0.0


def test_risk_of_races() -> None:
    even = np.full(5, 3.0)
    for turning in (True, False):
        assert race_risk(even, turning=turning) == pytest.approx(3.0)
    uneven = np.array([0.0, 10.0])
    # damage adds up on the ring that turns: the same load on every other ball does less harm
    assert race_risk(uneven, turning=True) < race_risk(uneven, turning=False)


def test_without_limit_it_is_the_reference_life() -> None:
    reference = reference_life(LOADS, LOADS, race_ratings(*BEARING))
    for depth in ("local", "mean"):
        assert _life(0.0, depth=depth) == pytest.approx(reference.life, rel=1e-12)


def test_limit_lengthens_life_without_end() -> None:
    lives = [float(_life(limit)[0]) for limit in (0.0, 1e5, 50e6, 200e6, FATIGUE_LIMIT)]
    assert np.all(np.diff(lives) > 0.0)
    assert lives[1] == pytest.approx(lives[0], rel=0.01)
    assert _life(2e9)[0] == np.inf


def test_limit_that_vanishes() -> None:
    """As the limit goes to nothing the life goes to the reference life, in proportion."""
    for depth in ("local", "mean"):
        basic = float(_life(0.0, depth=depth)[0])
        gains = [float(_life(limit, depth=depth)[0]) / basic - 1.0 for limit in (2e5, 1e5, 5e4)]
        assert gains[0] < 0.02
        assert gains[0] / gains[1] == pytest.approx(2.0, rel=0.01)
        assert gains[1] / gains[2] == pytest.approx(2.0, rel=0.01)


@pytest.mark.parametrize(
    ("balls", "ball", "pitch", "inner", "outer", "degrees"),
    [
        (7, 0.0115, 0.0435, 0.52, 0.53, 0.0),
        (16, 0.0127, 0.070, 0.52, 0.52, 25.0),
        (16, 0.02223, 0.12526, 0.5232, 0.5232, 40.0),
        (24, 0.005, 0.050, 0.515, 0.525, 15.0),
        (8, 0.030, 0.090, 0.53, 0.53, 0.0),
    ],
)
def test_material_constants_agree_for_other_bearings(
    balls: int, ball: float, pitch: float, inner: float, outer: float, degrees: float
) -> None:
    """One steel in both races, whatever the size, the grooves and the contact angle."""
    angle = np.radians(degrees)
    cosine = np.cos(2.0 * np.pi * np.arange(balls) / balls)
    loads = 7e6 * ball**2 * np.maximum(cosine, 0.0)[np.newaxis] ** 1.5
    ratings = race_ratings(1e4, balls, ball, pitch, inner, outer, angle)
    reference = reference_life(loads, loads, ratings)
    constants = []
    for race, conformity, life, sign in (
        ("inner", inner, reference.inner, 1.0),
        ("outer", outer, reference.outer, -1.0),
    ):
        curvature = race_curvature(ball, pitch, conformity, angle, race)  # type: ignore[arg-type]
        hertz = elliptical_contact(loads, curvature.rolling, curvature.across, MODULUS)
        contacts = Ellipses(hertz.semi_major, hertz.semi_minor, hertz.max_pressure)
        risk = race_risk(risk_integral(contacts, 0.0), turning=race == "inner")
        small = ball * np.cos(angle)
        cycles = 0.5 * balls * (1.0 + sign * small / pitch)
        radius = 0.5 * (pitch - sign * small)
        constants.append(float(material_constant(life[0, 0], risk[0], cycles, radius)))
    assert constants[0] == pytest.approx(constants[1], rel=0.2)


def test_material_constants_of_both_races_agree() -> None:
    """Calibrated race by race, Ā comes out the same within about 20 %: one steel."""
    reference = reference_life(LOADS, LOADS, race_ratings(*BEARING))
    gamma = 0.0115 / 0.0435
    constants = []
    for race, conformity, life, sign in (
        ("inner", 0.52, reference.inner, 1.0),
        ("outer", 0.53, reference.outer, -1.0),
    ):
        risk = race_risk(
            risk_integral(_ellipses(LOADS, race, conformity), 0.0), turning=race == "inner"
        )
        cycles = 3.5 * (1.0 + sign * gamma)
        radius = 0.5 * (0.0435 - sign * 0.0115)
        constants.append(float(material_constant(life[0, 0], risk[0], cycles, radius)))
    assert constants[0] == pytest.approx(constants[1], rel=0.2)


def test_limit_by_pressure() -> None:
    assert fatigue_limit_of_pressure(1.5e9, 8.0) == pytest.approx(FATIGUE_LIMIT, rel=2e-3)


def test_wrong_words() -> None:
    with pytest.raises(InputError, match="depth"):
        risk_integral(_ellipses(LOADS, "inner", 0.52), 0.0, depth="deep")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="fatigue_limit"):
        risk_integral(_ellipses(LOADS, "inner", 0.52), -1.0)
