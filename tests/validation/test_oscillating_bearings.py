"""Oscillating bearings beside what others print: Harris's integrals, DG03, makers of robot gears.

Harris, T. A. (1991): Rolling Bearing Analysis, 3rd edition, table of J_1 and J_2 over the load zone
ε for point and line contact (also in Lundberg and Palmgren, 1947 and 1952).
Harris, T. A.; Rumbarger, J. H.; Butterfield, C. P. (2009): Wind Turbine Design Guideline DG03: Yaw
and Pitch Rolling Bearing Life, NREL/TP-500-42362; its small-angle ratings as transcribed in public
source code (frasere/ISO-281).
Harmonic Drive: engineering data SHG-2SH and CSF/CSG, life of the output bearing in oscillation.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import load_case, solve
from rolamento.life import life
from rolamento.life.oscillation import (
    critical_angle,
    oscillation_life,
    oscillations_per_revolution,
    window_factor,
)

# ε: J_1 and J_2 of points, J_1 and J_2 of lines
INTEGRALS = {
    0.1: (0.4275, 0.4608, 0.5287, 0.5633),
    0.2: (0.4806, 0.5100, 0.5772, 0.6073),
    0.3: (0.5150, 0.5427, 0.6079, 0.6359),
    0.4: (0.5411, 0.5673, 0.6309, 0.6571),
    0.5: (0.5625, 0.5875, 0.6495, 0.6744),
    0.6: (0.5808, 0.6045, 0.6653, 0.6888),
    0.7: (0.5970, 0.6196, 0.6792, 0.7015),
    0.8: (0.6104, 0.6330, 0.6906, 0.7127),
    0.9: (0.6248, 0.6453, 0.7028, 0.7229),
    1.0: (0.6372, 0.6566, 0.7132, 0.7323),
}


@pytest.mark.parametrize("zone", INTEGRALS)
@pytest.mark.parametrize("line", [False, True])
def test_what_a_ring_loses_that_hardly_moves(zone: float, line: bool) -> None:
    """(J_2/J_1)^p, within 0.5 % of the printed quotient: integrals of old, by hand."""
    azimuth = np.linspace(-np.pi, np.pi, 4000, endpoint=False)
    part = np.maximum(1.0 - (1.0 - np.cos(azimuth)) / (2.0 * zone), 0.0)
    exponent, slope, power = (4.0, 9.0 / 8.0, 1.1) if line else (3.0, 10.0 / 9.0, 1.5)
    found = window_factor(part**power, 1e-9, exponent=exponent, slope=slope)
    j_1, j_2 = INTEGRALS[zone][2:] if line else INTEGRALS[zone][:2]
    assert float(found) ** (1.0 / exponent) == pytest.approx(j_2 / j_1, rel=5e-3)


@pytest.mark.parametrize("count", [40, 100, 160])
@pytest.mark.parametrize(("slope", "of_angle", "of_count"), [
    (10.0 / 9.0, 3.0 / 10.0 * 3.0, 0.033 * 3.0),  # C_osc = C (180/θ)^(3/10) Z^0.033, p = 3
    (9.0 / 8.0, 2.0 / 9.0 * 4.0, 0.028 * 4.0),  # C_osc = C (180/θ)^(2/9) Z^0.028, p = 4
])  # fmt: skip
def test_small_angles_of_dg03(count: int, slope: float, of_angle: float, of_count: float) -> None:
    """The same powers of angle and number; DG03 is above by the 4^(1 - 1/e) that it rounds away.

    Its form does not meet (180/φ) at the critical angle; that of Lundberg and Palmgren does.
    """
    critical = critical_angle(count, 0.02, race="outer")
    angles = np.array([0.55, 0.7, 0.9]) * critical
    ours = oscillations_per_revolution(angles, critical, slope=slope)
    theirs = (np.pi / angles) ** of_angle * count**of_count
    np.testing.assert_allclose(theirs / ours, 4.0 ** (1.0 - 1.0 / slope), rtol=0.02)


def test_the_critical_angle_of_dg03() -> None:
    """θ_crit = 360°/(Z (1 ∓ γ)) is of θ = φ/2."""
    for race, sign in (("inner", 1.0), ("outer", -1.0)):
        ours = critical_angle(24, 0.1, race=race)
        assert np.degrees(ours) / 2.0 == pytest.approx(360.0 / (24.0 * (1.0 + sign * 0.1)))


@pytest.mark.parametrize(("name", "load", "exponent"), [
    ("7210 B", {"duty.load.fx": "4 kN"}, 3.0), ("NU 210", {"duty.load.fz": "8 kN"}, 10.0 / 3.0),
])  # fmt: skip
def test_makers_of_robot_gears(name: str, load: dict[str, str], exponent: float) -> None:
    """L_oc = 10^6/(60 n_1) (180/φ) (C/(f_w P_c))^B hours, one oscillation being 2 φ; f_w = 1."""
    solved = solve(load_case(name, load))
    summary = life(solved)
    ratio = summary.ratings.dynamic_of_set[0] / summary.loads.dynamic[0]
    found = oscillation_life(solved, np.radians(70.0), 0.5)
    hours = 1e6 / (60.0 * 30.0) * 180.0 / 70.0 * ratio**exponent  # 30 oscillations a minute
    assert 1e6 * found.makers / found.frequency / 3600.0 == pytest.approx(hours, rel=1e-9)
