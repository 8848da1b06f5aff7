"""Coupled slices beside a solution over the whole area, which takes no shape of pressure for given.

Both are half-spaces here: the compression of the roller's body is left out (share = 0).
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from tests.agreement.reference_half_space import Pressed, press

from rolamento.case.profile import Profile
from rolamento.contact.coupled import CoupledPress, coupled_press
from rolamento.contact.line import slice_places
from rolamento.contact.profile import drop

E = 207e9 / (1.0 - 0.3**2)
D, L = 7.5e-3, 9e-3
RHO = 2.0 / D + 2.0 / 27e-3
SLICES, ACROSS = 35, 64
STRAIGHT, ISO = Profile(kind="none"), Profile(kind="iso")
CROWNED = Profile(kind="crowned", radius=1.0)
CASES = {
    "straight": (STRAIGHT, 5e-6, 0.0),
    "crowned": (CROWNED, 15e-6, 0.0),
    "point": (CROWNED, 4e-6, 5e-4),
    "logarithmic": (ISO, 12e-6, 0.0),
    "tilted": (ISO, 10e-6, 1e-3),
    "much tilted": (ISO, 12e-6, 3e-3),
    "end alone": (STRAIGHT, -2e-6, 3e-3),
}


@cache
def both(name: str) -> tuple[CoupledPress, Pressed]:
    given, approach, tilt = CASES[name]
    y = slice_places(L, SLICES)
    drops = drop(given, y, length=L, diameter=D)
    slices = coupled_press(
        approach, tilt, drops, effective_length=L, curvature=RHO, modulus=E, roller_diameter=D,
        share=0.0,
    )  # fmt: skip
    step = 2.4 * slices.half_width.max() / ACROSS
    x = (np.arange(ACROSS) - 0.5 * (ACROSS - 1)) * step
    interference = approach + tilt * y - drops - 0.5 * RHO * x[:, np.newaxis] ** 2
    return slices, press(interference, x, y, E)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.sweep
def test_load_and_moment(name: str) -> None:
    slices, whole = both(name)
    assert whole.gap_error < 1e-9
    assert slices.load == pytest.approx(whole.load, rel=8e-3)
    assert slices.moment == pytest.approx(whole.moment, rel=1.2e-2, abs=1e-6 * whole.load * L)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.sweep
def test_pressure_along_the_roller(name: str) -> None:
    slices, whole = both(name)
    along = whole.pressure.max(axis=0)
    np.testing.assert_allclose(
        slices.load_per_length, whole.load_per_length,
        atol=0.06 * whole.load_per_length.max(),
    )  # fmt: skip
    # the slices' own Hertz width is too wide at an edge, where half of the neighbours are missing
    assert slices.max_pressure.max() == pytest.approx(along.max(), rel=0.05)
    inner = slice(3, -3)
    np.testing.assert_allclose(slices.max_pressure[inner], along[inner], atol=0.02 * along.max())


def test_no_pressure_outside_of_the_contact() -> None:
    slices, whole = both("end alone")
    free = whole.load_per_length == 0.0
    assert free.sum() > 5
    # a slice that the reference cuts in two may press a little
    assert np.count_nonzero(slices.load_per_length[free]) <= 1
