"""G. Lundberg, Elastische Berührung zweier Halbräume, Forschung auf dem Gebiete des Ingenieurwesens
10 (1939) 201.

The drop under which a roller on a half-space presses evenly along its whole length, over all but
the last few widths, is A ln 1/(1 - (2x/L)²) with A = 2q/(πE'): 0.00035 D on a plane at some
3000 MPa, the profile of ISO/TS 16281. The approach of a line of even load, in its middle, is
2Q (1 - ν²)/(π E L) (1.8864 + ln(L/2b)) of each body.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case.profile import Profile
from rolamento.contact.coupled import coupled_press
from rolamento.contact.line import half_width, max_pressure, slice_places
from rolamento.contact.profile import drop

MODULUS = 207e9 / (1.0 - 0.3**2)
D, L = 10e-3, 12e-3
PLANE = 2.0 / D


@pytest.mark.parametrize("pressure", [1.5e9, 3e9])
def test_logarithmic_profile_presses_evenly(pressure: float) -> None:
    load = 2.0 * np.pi * pressure**2 / (MODULUS * PLANE)
    assert max_pressure(load, PLANE, MODULUS) == pytest.approx(pressure)
    amplitude = 2.0 * load / (np.pi * MODULUS)
    if pressure == 3e9:
        assert amplitude / D == pytest.approx(0.00035, rel=0.01)
    b = half_width(load, PLANE, MODULUS)
    approach = 2.0 * load / (np.pi * MODULUS) * 2.0 * (1.8864 + np.log(L / (2.0 * b)))
    drops = drop(
        Profile(kind="logarithmic", amplitude=amplitude),
        slice_places(L, 101),
        length=L,
        diameter=D,
    )
    pressed = coupled_press(
        approach, 0.0, drops, effective_length=L, curvature=PLANE, modulus=MODULUS,
        roller_diameter=D, share=0.0,
    )  # fmt: skip
    np.testing.assert_allclose(pressed.max_pressure[8:-8], pressure, rtol=5e-3)
    np.testing.assert_allclose(pressed.load_per_length[8:-8], load, rtol=1e-2)
