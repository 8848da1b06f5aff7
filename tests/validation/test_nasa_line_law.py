"""NASA/TM-2012-217115: the stiffness of a roller between two races, 0.1647 E' L^(8/9) δ^(10/9).

E' = E/(1 - ν²) of steel on steel. It is a rival of ISO/TS 16281, whose 35948 N/mm^(10/9) is 0.1580
of the same form, and so 4 % softer; Palmgren's own 3.84e-5 Q^0.9 L^-0.8 mm of one contact (Harris
1991, chapter 6) is next to it. All of them take one exponent for all loads. Coupled slices, which
have none, are stiffer the wider the contact.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case.profile import Profile
from rolamento.contact.coupled import coupled_press
from rolamento.contact.line import EXPONENT, pair_constant, slice_places
from rolamento.contact.profile import drop

MODULUS = 207e9 / (1.0 - 0.3**2)
D = 10e-3


def nasa(length: float) -> float:
    return float(0.1647 * MODULUS * length ** (8.0 / 9.0))


def palmgren(length: float) -> float:
    """Of both contacts; N/m^(10/9)."""
    return float((2.0 * 3.84e-5) ** -EXPONENT * (1e3 * length) ** (8.0 / 9.0) * 1e3**EXPONENT)


@pytest.mark.parametrize("length", [5e-3, 10e-3, 40e-3])
def test_rival_laws_are_near(length: float) -> None:
    iso = float(pair_constant(length, MODULUS))
    assert nasa(length) / iso == pytest.approx(1.042, abs=0.002)
    assert palmgren(length) / iso == pytest.approx(1.038, abs=0.002)


@pytest.mark.parametrize("pressure", [1.2e9, 2e9, 3e9])
@pytest.mark.parametrize("slenderness", [1.0, 1.6])
def test_coupled_slices_are_near_all_of_them(slenderness: float, pressure: float) -> None:
    """Both contacts of a roller between planes, each with half of the approach."""
    length, rho = slenderness * D, 2.0 / D
    place = slice_places(length, 35)
    drops = drop(Profile(kind="iso"), place, length=length, diameter=D)
    q = 2.0 * np.pi * pressure**2 / (MODULUS * rho)
    approach = 0.5 * (q * length / float(pair_constant(length, MODULUS))) ** 0.9
    pressed = coupled_press(
        approach, 0.0, drops, effective_length=length, curvature=rho, modulus=MODULUS,
        roller_diameter=D,
    )  # fmt: skip
    own = np.maximum(2.0 * (approach - drops), 0.0) ** EXPONENT
    for law in (float(pair_constant(length, MODULUS)), nasa(length), palmgren(length)):
        load = law * own.mean()
        assert pressed.load == pytest.approx(load, rel=0.10)
