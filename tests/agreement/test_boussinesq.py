"""Stresses under the Hertz ellipse by adding up point loads, beside the closed forms.

A point load P on a half-space gives, at x, y, z with ρ² = x² + y² + z² and tension positive,

    σ_z = -3P z³/(2πρ⁵),   τ_xz = -3P x z²/(2πρ⁵),   τ_yz likewise,
    σ_x = P/2π {(1 - 2ν) [(x² - y²)/(r²ρ(ρ + z)) + z y²/(r²ρ³)] - 3 z x²/ρ⁵},   r² = x² + y²

(Boussinesq 1885; Johnson 1985, section 3.2). The pressure is cut into point loads on a mesh of the
ellipse: nothing here is shared with the program. The mesh has to be fine against the depth, so the
points lie at a tenth of b or deeper.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from rolamento.contact.hertz import elliptical_contact
from rolamento.contact.subsurface import (
    axis_stresses,
    maximum_shear,
    orthogonal_shear,
    point_stresses,
)
from rolamento.life.shear_field import passing_shear

Floats = NDArray[np.float64]
SHAPES = (1.0, 1.7, 4.0, 10.0)
RADIAL, ROUND = 120, 480


class PointLoads:
    """The Hertz pressure of 1 on an ellipse, b = 1 along x and a along y, as point loads."""

    def __init__(self, semi_major: float) -> None:
        node, weight = np.polynomial.legendre.leggauss(RADIAL)
        angle = 0.25 * np.pi * (node + 1.0)  # the radius is sin: the pressure's root becomes cos
        weight = 0.25 * np.pi * weight
        turn = 2.0 * np.pi * (np.arange(ROUND) + 0.5) / ROUND
        radius = np.sin(angle)[:, np.newaxis]
        self.x = radius * np.cos(turn)
        self.y = semi_major * radius * np.sin(turn)
        ring = weight * np.cos(angle) ** 2 * np.sin(angle) * 2.0 * np.pi / ROUND
        self.load = semi_major * np.broadcast_to(ring[:, np.newaxis], self.x.shape)

    def stresses(self, x: float, y: float, z: float, poisson: float) -> dict[str, float]:
        """All that is compared, at one point."""
        dx, dy = x - self.x, y - self.y
        r2 = dx * dx + dy * dy
        rho = np.sqrt(r2 + z * z)
        unit = self.load / (2.0 * np.pi)

        def along(first: Floats, second: Floats) -> float:
            near = (first**2 - second**2) / (r2 * rho * (rho + z)) + z * second**2 / (r2 * rho**3)
            return float(
                np.sum(unit * ((1.0 - 2.0 * poisson) * near - 3.0 * z * first**2 / rho**5))
            )

        return {
            "x": along(dx, dy),
            "y": along(dy, dx),
            "z": float(np.sum(-3.0 * unit * z**3 / rho**5)),
            "xz": self.shear(x, y, z),
        }

    def shear(self, x: float, y: float, z: float) -> float:
        """τ_xz alone."""
        dx, dy = x - self.x, y - self.y
        rho2 = dx * dx + dy * dy + z * z
        return float(-1.5 / np.pi * z * z * np.sum(self.load * dx / (rho2 * rho2 * np.sqrt(rho2))))

    def passing(self, y: float, z: float) -> float:
        """The greatest |τ_xz| along x."""
        found = minimize_scalar(
            lambda x: -abs(self.shear(x, y, z)), bounds=(0.02, 3.0), options={"xatol": 1e-4}
        )
        return float(-found.fun)


@pytest.fixture(scope="module", params=SHAPES, ids=lambda k: f"a/b = {k:g}")
def contact(request: pytest.FixtureRequest) -> tuple[float, PointLoads]:
    return request.param, PointLoads(request.param)


def test_point_loads_make_the_hertz_load(contact: tuple[float, PointLoads]) -> None:
    k, loads = contact
    assert float(loads.load.sum()) == pytest.approx(2.0 / 3.0 * np.pi * k, rel=1e-12)


@pytest.mark.parametrize("poisson", [0.0, 0.26, 0.3, 0.5])
def test_under_the_centre(contact: tuple[float, PointLoads], poisson: float) -> None:
    k, loads = contact
    for depth in (0.1, 0.3, 0.48, 0.8, 1.5, 4.0):
        summed = loads.stresses(0.0, 0.0, depth, poisson)
        closed = axis_stresses(depth, 1.0, k, 1.0, poisson)
        assert float(closed.minor) == pytest.approx(summed["x"], abs=1e-6)
        assert float(closed.major) == pytest.approx(summed["y"], abs=1e-6)
        assert float(closed.normal) == pytest.approx(summed["z"], abs=1e-6)


@pytest.mark.parametrize(
    ("across", "along"), [(0.0, 0.6), (0.0, 1.0), (0.4, 0.8), (0.9, 0.3), (1.1, 0.9), (0.3, 2.5)]
)
def test_beside_the_centre(contact: tuple[float, PointLoads], across: float, along: float) -> None:
    """τ_xz and σ_z inside, at the edge of and outside the ellipse; y = across a, x = along b."""
    k, loads = contact
    for depth in (0.3, 0.6, 1.2, 3.0):
        summed = loads.stresses(along, across * k, depth, 0.3)
        closed = point_stresses(along, across * k, depth, 1.0, k, 1.0)
        assert float(closed.shear) == pytest.approx(summed["xz"], abs=2e-6)
        assert float(closed.normal) == pytest.approx(summed["z"], abs=2e-6)


def test_greatest_orthogonal_shear(contact: tuple[float, PointLoads]) -> None:
    """The amplitude at its depth; above and below there is less."""
    k, loads = contact
    known = orthogonal_shear(1.0, k, 1.0)
    depth = float(known.depth)
    at_depth = loads.passing(0.0, depth)
    assert at_depth == pytest.approx(float(known.amplitude), rel=1e-5)
    for part in (0.8, 1.25):
        assert loads.passing(0.0, part * depth) < at_depth


@pytest.mark.parametrize(("across", "depth"), [(0.0, 0.25), (0.6, 0.45), (1.1, 0.7)])
def test_shear_that_passes_a_point(
    contact: tuple[float, PointLoads], across: float, depth: float
) -> None:
    """What the integral of Ioannides and Harris is made of."""
    k, loads = contact
    summed = loads.passing(across * k, depth)
    assert float(passing_shear(across, depth, k)) == pytest.approx(summed, rel=1e-5)


def test_greatest_shear_at_45_degrees(contact: tuple[float, PointLoads]) -> None:
    k, loads = contact
    known = maximum_shear(1.0, k, 1.0, 0.3)
    depth = float(known.depth)

    def shear(z: float) -> float:
        found = loads.stresses(0.0, 0.0, z, 0.3)
        principal = (found["x"], found["y"], found["z"])
        return 0.5 * (max(principal) - min(principal))

    assert shear(depth) == pytest.approx(float(known.shear), abs=1e-6)
    assert shear(0.9 * depth) < shear(depth) > shear(1.1 * depth)


def test_units_and_scale_of_a_bearings_contact() -> None:
    """The same in metres and pascals: 1 kN on the inner race of a 6305."""
    hertz = elliptical_contact(1000.0, 200.0 + 1.0 / 0.0172, 200.0 - 1.0 / 0.00537, 2.27e11)
    a, b, p0 = (float(v) for v in (hertz.semi_major, hertz.semi_minor, hertz.max_pressure))
    loads = PointLoads(a / b)
    summed = loads.stresses(0.7, 0.2 * a / b, 0.4, 0.3)
    closed = point_stresses(0.7 * b, 0.2 * a, 0.4 * b, p0, a, b)
    assert float(closed.shear) == pytest.approx(p0 * summed["xz"], rel=1e-5)
    assert float(closed.normal) == pytest.approx(p0 * summed["z"], rel=1e-5)
