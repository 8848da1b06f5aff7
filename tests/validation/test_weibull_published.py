"""Published Weibull fits: stopped by the clock, withdrawn, inspected, three parameters."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from rolamento.weibull import (
    LifeTest,
    bounds,
    compare,
    maximum_likelihood,
    three_parameter,
)


def test_nist_handbook() -> None:
    """NIST/SEMATECH e-Handbook, 8.4.1.3: 20 units, stopped by the clock at 500 h."""
    times = [54.0, 187, 216, 240, 244, 335, 361, 373, 375, 386, 500]
    test = LifeTest(times, [True] * 10 + [False], counts=[1] * 10 + [10])
    fit = maximum_likelihood(test)
    assert test.scheme == "type_i"
    assert fit.shape == pytest.approx(1.7208, abs=5e-5)
    assert fit.scale == pytest.approx(606.5280, abs=1e-3)
    assert fit.mean == pytest.approx(540.737, abs=1e-3)
    assert fit.log_likelihood == pytest.approx(-75.135, abs=5e-4)


def test_bearing_cages() -> None:
    """Abernethy and others (1983): 1703 cages, 6 failures; Meeker and Escobar (1998), chapter 8."""
    failed = [230, 334, 423, 990, 1009, 1510]
    running = {
        50: 288, 150: 148, 250: 124, 350: 111, 450: 106, 550: 99, 650: 110, 750: 114, 850: 119,
        950: 127, 1050: 123, 1150: 93, 1250: 47, 1350: 41, 1450: 27, 1550: 11, 1650: 6, 1850: 1,
        2050: 2,
    }  # fmt: skip
    test = LifeTest(
        [*failed, *running],
        [True] * 6 + [False] * len(running),
        counts=[1] * 6 + list(running.values()),
    )
    fit = maximum_likelihood(test)
    assert test.size == 1703
    assert fit.shape == pytest.approx(2.035, abs=5e-4)
    assert fit.scale == pytest.approx(11_792.0, abs=0.5)
    assert fit.l10 == pytest.approx(3903.0, abs=0.5)
    # the promised 8000 h lies within bounds that far fewer than 10 % of the cages support
    life = bounds(test, "L10", method="likelihood_ratio", confidence=0.95)
    assert life.lower == pytest.approx(2094.0, rel=0.01)
    assert life.upper == pytest.approx(22_144.0, rel=0.01)


def test_inspected_turbine_parts() -> None:
    """Nelson (1982), page 415: 167 parts, eight inspections; fit of SAS/QC, PROC RELIABILITY."""
    ends = [6.12, 19.92, 29.64, 35.40, 39.72, 45.24, 52.32, 63.48]
    test = LifeTest(
        [*ends, 63.48],
        [True] * 8 + [False],
        lower=[0.0, *ends[:-1], np.nan],
        counts=[5, 16, 12, 18, 18, 2, 6, 17, 73],
        unit="months",
    )
    fit = maximum_likelihood(test)
    assert fit.shape == pytest.approx(1.4854, abs=5e-5)
    assert fit.scale == pytest.approx(71.6904, abs=5e-5)
    shape = bounds(test, "shape", method="fisher", confidence=0.95)
    assert (shape.lower, shape.upper) == pytest.approx((1.2242, 1.8022), abs=2e-4)


def test_three_parameters_of_an_alloy() -> None:
    """Meeker and Escobar (1998): alloy T7987; fit of SAS/QC, PROC RELIABILITY, Weibull3."""
    times = np.fromstring(
        """94 96 99 99 104 108 112 114 117 117 118 121 121 123 129 131 133 135 136 139 139 140 141
        141 143 144 149 149 152 153 159 159 159 159 162 168 168 169 170 170 171 172 173 176 177 180
        180 184 187 188 189 190 196 197 203 205 211 213 224 226 227 256 257 269 271 274 291 300 300
        300 300 300""",
        sep=" ",
    )
    fit = three_parameter(LifeTest(times, np.arange(72) < 67, unit="kcycles"))
    assert fit.location == pytest.approx(92.9928, abs=1e-3)
    assert fit.shape == pytest.approx(1.3202, abs=1e-4)
    assert fit.scale == pytest.approx(93.2642, abs=1e-3)


def test_five_bearing_steels() -> None:
    """McCool (1979): ten bearings of each of five steels; the fits are those of SciPy.

    That they have one shape is not contradicted; that they have one life is.
    """
    lives = {
        "I": [3.03, 5.53, 5.60, 9.30, 9.92, 12.51, 12.95, 15.21, 16.04, 16.84],
        "II": [3.19, 4.26, 4.47, 4.53, 4.67, 4.69, 5.78, 6.79, 9.37, 12.75],
        "III": [3.46, 5.22, 5.69, 6.54, 9.16, 9.40, 10.19, 10.71, 12.58, 13.41],
        "IV": [5.88, 6.74, 6.90, 6.98, 7.21, 8.14, 8.59, 9.80, 12.28, 25.46],
        "V": [6.43, 9.97, 10.39, 13.55, 14.45, 14.72, 16.81, 18.39, 20.84, 21.51],
    }
    groups = {name: LifeTest(times, unit="Mrev") for name, times in lives.items()}
    shapes = compare(groups, "common_shape")
    expected = [stats.weibull_min.fit(times, floc=0.0)[0] for times in lives.values()]
    assert [fit.shape for fit in shapes.fits] == pytest.approx(expected, rel=1e-3)
    assert not shapes.rejected(0.8)
    assert compare(groups, "same_life").rejected(0.99)
