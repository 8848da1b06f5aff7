"""NASA/TM-2012-217115: the most heavily loaded roller, against Stribeck.

Their table of Z Q_max/F at zero clearance, with a roller or a gap under the load, whichever is
worse, is computed with Q ~ δ^1.11; with 10/9 the numbers are up to 3e-4 greater. The integral for
any clearance is Sjövall's J_r(ε), Harris, Rolling Bearing Analysis, 3rd ed. (1991), section 7.3,
for n = 10/9.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from rolamento.case import Case
from rolamento.contact.line import pair_constant
from rolamento.solution import solve

STRIBECK = {
    3: 3.000, 4: 4.000, 5: 4.281, 6: 4.100, 7: 4.027, 8: 4.076, 9: 4.111, 10: 4.087,
    20: 4.084, 30: 4.084, 40: 4.084, 50: 4.084,
}  # fmt: skip


def bearing(count: int, clearance: float = 0.0) -> dict[str, object]:
    return {
        "element": "cylindrical",
        "roller_count": count,
        "roller_diameter": "4 mm",
        "effective_length": "6 mm",
        "pitch_diameter": "120 mm",
        "diametral_clearance": f"{clearance} m",
        "roller_profile": "none",
    }


@pytest.mark.parametrize("count", STRIBECK)
def test_the_heaviest_roller_without_clearance(count: int) -> None:
    case = Case.model_validate({"bearing": bearing(count), "duty": {"load": {"fz": "1 kN"}}})
    solved = solve(case, {"duty.first_ball_azimuth": np.array([0.0, np.pi / count])})
    worst = count * solved.inner.load.max() / 1000.0
    assert worst == pytest.approx(STRIBECK[count], rel=4e-4)


@pytest.mark.parametrize("clearance", [-8e-6, -2e-6, 0.0, 5e-6, 40e-6])
def test_the_load_integral_of_many_rollers(clearance: float) -> None:
    """F = Z Q_max J_r(ε), ε = ½ (1 - s/(2 δ_r)), with the ring held at δ_r."""
    count, shift = 90, 30e-6
    case = Case.model_validate(
        {"bearing": bearing(count, clearance), "duty": {"displacement": {"z": f"{shift} m"}}}
    )
    solved = solve(case)
    deepest = shift - 0.5 * clearance
    greatest = float(pair_constant(6e-3, solved.rows.modulus[0, 0])) * deepest ** (10 / 9)
    load = solved.load.fz[0]
    assert solved.inner.load.max() == pytest.approx(greatest, rel=1e-9)
    epsilon = 0.5 * (1.0 - 0.5 * clearance / shift)
    end = np.arccos(np.clip(1.0 - 2.0 * epsilon, -1.0, 1.0))
    part, _ = quad(
        lambda psi: (1.0 - (1.0 - np.cos(psi)) / (2.0 * epsilon)) ** (10 / 9) * np.cos(psi),
        0.0, end,
    )  # fmt: skip
    assert load == pytest.approx(count * greatest * part / np.pi, rel=1e-3)
