"""Greases beside published numbers.

NTN, grease replenishment (eshop.ntn-snr.com, figure 11.2): a 6206 under 2 kN at 3600 r/min is to be
relubricated after about 5500 h, read off the chart; no temperature above 80 °C.
TPI, Deep groove ball bearings (2202/TE), equations 7-1 and 7-2 and table 7.2, after Kawamura,
Minami and Hirata (2001).
SKF, relubrication: amounts of grease, and the adjustments of the interval.
NSK, Rolling Bearings (E1102), grease life of sealed ball bearings: two formulas.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.grease import base_interval, grease_life_kawamura, grease_life_nsk, skf_amount

RPM = np.pi / 30.0
ZERO = 273.15


def test_ntns_example_of_a_6206() -> None:
    """Off a chart: 10 %."""
    assert base_interval(3600 * RPM, 0.030) == pytest.approx(5500.0, rel=0.10)


@pytest.mark.parametrize(("ratio", "celsius", "logarithm"), [
    (0.25, 70.0, 6.54 - 0.65 - (0.025 - 0.003) * 70.0),
    (0.50, 90.0, 6.54 - 1.30 - (0.025 - 0.006) * 90.0),
    (1.00, 110.0, 6.54 - 2.60 - (0.025 - 0.012) * 110.0),
])  # fmt: skip
def test_nsks_general_purpose_grease(ratio: float, celsius: float, logarithm: float) -> None:
    assert np.log10(grease_life_nsk(ratio, ZERO + celsius)) == pytest.approx(logarithm)


@pytest.mark.parametrize(("ratio", "celsius", "logarithm"), [
    (0.25, 70.0, 6.12 - 0.35 - (0.018 - 0.0015) * 70.0),
    (0.60, 100.0, 6.12 - 0.84 - (0.018 - 0.0036) * 100.0),
    (1.00, 130.0, 6.12 - 1.40 - (0.018 - 0.006) * 130.0),
])  # fmt: skip
def test_nsks_wide_range_grease(ratio: float, celsius: float, logarithm: float) -> None:
    found = grease_life_nsk(ratio, ZERO + celsius, "wide_range")
    assert np.log10(found) == pytest.approx(logarithm)


@pytest.mark.parametrize(("thickener", "oil", "logarithm"), [
    ("urea", "ether", 8.50 - 2.02e-6 * 2e5 - 2.95e-2 * 120.0 - 8.36 * 0.05 + 0.18),
    ("urea", "mineral", 8.50 - 2.02e-6 * 2e5 - 2.95e-2 * 120.0 - 8.36 * 0.05 - 0.08),
    ("lithium", "mineral", 6.33 - 1.58e-6 * 2e5 - 2.18e-2 * 120.0 - 9.84 * 0.05 - 0.29),
    ("lithium", "silicone", 6.33 - 1.58e-6 * 2e5 - 2.18e-2 * 120.0 - 9.84 * 0.05 + 0.54),
])  # fmt: skip
def test_kawamuras_greases(thickener: str, oil: str, logarithm: float) -> None:
    found = grease_life_kawamura(2e5, ZERO + 120.0, 0.05, thickener, oil)  # type: ignore[arg-type]
    assert np.log10(found) == pytest.approx(logarithm)


def test_the_laws_agree_within_their_scatter() -> None:
    """At 80 °C and light load three sources lie within a factor of four of each other."""
    from rolamento.grease import grease_life_jtekt

    nsk = grease_life_nsk(0.35, ZERO + 80.0)
    kawamura = grease_life_kawamura(175e3, ZERO + 80.0, 0.05)
    jtekt = grease_life_jtekt(175e3, ZERO + 80.0, 0.05)
    lives = np.array([nsk, kawamura, jtekt])
    assert lives.max() / lives.min() < 4.0


def test_skfs_amounts() -> None:
    """G_p = 0.005 D B: of a 6310, 110 by 27 mm, 14.85 g."""
    assert 1e3 * skf_amount(0.110, 0.027) == pytest.approx(14.85)
    assert 1e3 * skf_amount(0.110, 0.027, "middle") == pytest.approx(5.94)
