"""Line contacts in K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985.

Section 4.2(c): the maximum shear is 0.30 p0 at z = 0.78 a, and the orthogonal shear 0.25 p0 at
0.5 a, x = ±0.87 a. Section 6.1: a line contact of ν = 0.3 begins to yield at p0 = 1.79 Y by von
Mises and at 1.67 Y by Tresca (eq. 6.4). Section 5.6: a cylinder between two plates is
compressed, from a contact to its middle, by P (1 - ν²)/(π E) {2 ln(4R/a) - 1} (eq. 5.57).
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.contact.coupled import coupled_press
from rolamento.contact.line import half_width
from rolamento.contact.subsurface import (
    line_maximum_shear,
    line_orthogonal_shear,
    line_stresses,
    line_von_mises,
)

NU = 0.3
E = 207e9
MODULUS = E / (1.0 - NU * NU)


def test_maximum_shear() -> None:
    shear = line_maximum_shear(1.0, 1.0, NU)
    assert shear.shear == pytest.approx(0.30, abs=0.005)
    assert shear.depth == pytest.approx(0.78, abs=0.01)


def test_orthogonal_shear() -> None:
    shear = line_orthogonal_shear(1.0, 1.0)
    assert shear.amplitude == 0.25
    assert line_stresses(0.87, shear.depth, 1.0, 1.0, NU).shear == pytest.approx(-0.25, abs=1e-4)


def test_first_yielding() -> None:
    assert 1.0 / line_von_mises(1.0, 1.0, NU).stress == pytest.approx(1.79, abs=0.005)
    assert 0.5 / line_maximum_shear(1.0, 1.0, NU).shear == pytest.approx(1.67, abs=0.005)


@pytest.mark.parametrize("slenderness", [10.0, 40.0])
def test_compression_of_a_long_cylinder(slenderness: float) -> None:
    """A rigid race leaves the roller's own compression; its ends count by D/L."""
    diameter = 10e-3
    length = slenderness * diameter
    rho = 2.0 / diameter
    rigid = 2.0 * MODULUS  # E' with all the compliance in the roller
    pressed = coupled_press(
        8e-6, 0.0, np.zeros(101), effective_length=length, curvature=rho, modulus=rigid,
        roller_diameter=diameter, share=1.0,
    )  # fmt: skip
    q = pressed.load_per_length[50]
    a = half_width(q, rho, rigid)
    johnson = q * (1.0 - NU * NU) / (np.pi * E) * (2.0 * np.log(2.0 * diameter / a) - 1.0)
    assert johnson == pytest.approx(8e-6, rel=0.02 / slenderness)
