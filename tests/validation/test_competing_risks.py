"""Published lives with failure modes.

Device-G: Meeker and Escobar, Statistical Methods for Reliability Data (1998), table 15.1 (30 units
in the field, kilocycles; S: electrical surge, W: wear-out) and section 15.4: maximum likelihood
gives μ 6.11 and σ 1.49 of the smallest extreme value distribution of ln t for S, 5.83 and 0.23
for W.

Armature bars: Doganaksoy, Hahn and Meeker, Reliability analysis by failure mode, Quality Progress
35 (2002) 47 (58 segments of insulation, hours; E: early, D: degradation), data as printed in SAS/QC
User's Guide, The RELIABILITY Procedure, "Weibull probability plot for two combined failure modes".
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.weibull import (
    Estimand,
    LifeTest,
    goodness_of_fit,
    life_models,
    maximum_likelihood,
    system_of_modes,
)

DEVICE_G = """275 W 13 S 147 W 23 S 181 W 30 S 65 S 10 S 300 - 173 S 106 S 300 - 300 - 212 W
300 - 300 - 300 - 2 S 261 S 293 W 88 S 247 S 28 S 143 S 300 - 23 S 300 - 80 S 245 W 266 W"""
BARS = """2 E 3 E 5 E 8 E 13 - 21 E 28 E 31 E 31 - 52 - 53 - 64 E 67 - 69 E 76 E 78 - 104 E 113
- 119 E 135 - 144 E 157 - 160 E 168 D 179 - 191 D 203 D 211 D 221 E 226 D 236 E 241 - 257 - 261
D 264 D 278 D 282 E 284 D 286 D 298 D 303 E 314 D 317 D 318 D 320 D 327 D 328 D 328 D 348 D 348
- 350 D 360 D 369 D 377 D 387 D 392 D 412 D 446 D"""


def life_test(text: str, unit: str) -> LifeTest:
    cells = text.split()
    modes = np.array(cells[1::2])
    return LifeTest(
        np.array(cells[::2], dtype=float), modes != "-", mode=np.where(modes == "-", "", modes),
        unit=unit,
    )  # fmt: skip


@pytest.mark.parametrize(("mode", "mu", "sigma"), [("S", 6.11, 1.49), ("W", 5.83, 0.23)])
def test_device_g(mode: str, mu: float, sigma: float) -> None:
    fit = maximum_likelihood(life_test(DEVICE_G, "kcycles").for_mode(mode))
    assert np.log(fit.scale) == pytest.approx(mu, abs=5e-3)
    assert 1.0 / fit.shape == pytest.approx(sigma, abs=5e-3)


def test_device_g_as_a_whole() -> None:
    """The product of both modes follows the share that failed, which one distribution does not."""
    test = life_test(DEVICE_G, "kcycles")
    whole = system_of_modes(test, [Estimand.of("L50"), Estimand.of("R200")], samples=500)
    # Kaplan-Meier: of 30 all under test, 16 failed by 200 kcycles
    seen = 1.0 - np.count_nonzero(test.failed & (test.times <= 200.0)) / 30.0
    assert whole.bounds[1].estimate == pytest.approx(seen, abs=0.05)
    assert whole.bounds[0].lower < 213.0 < whole.bounds[0].upper  # median of the sample
    assert whole.log_likelihood > whole.log_likelihood_pooled


def test_armature_bars() -> None:
    """Early failures with a falling rate, degradation with a steep one; pooled they are bent."""
    test = life_test(BARS, "h")
    assert (test.size, test.failures) == (58, 45)
    early, late = (maximum_likelihood(test.for_mode(mode)) for mode in "ED")
    assert early.shape < 1.0 < 5.0 < late.shape < 6.5
    pooled = goodness_of_fit(test, samples=500)
    assert pooled.bent is not None
    assert pooled.bent.shape_before < 1.0 < pooled.bent.shape_after
    assert pooled.p_value < 0.01
    for mode in "ED":
        assert not goodness_of_fit(test.for_mode(mode), samples=500).contradicted
    # the times alone, without the modes that were seen on the bars, tell the same
    models = {model.name: model for model in life_models(test)}
    best = min(models.values(), key=lambda model: model.aicc)
    assert best.name == "two_modes"
    shapes = sorted([best.parameters["shape"], best.parameters["shape_2"]])
    assert shapes == pytest.approx([early.shape, late.shape], rel=0.05)
    whole = system_of_modes(test, [Estimand.of("L10")], samples=500)
    assert best.log_likelihood == pytest.approx(whole.log_likelihood, abs=0.02)
    assert best.log_likelihood >= whole.log_likelihood - 1e-6
    assert best.l10 == pytest.approx(whole.bounds[0].estimate, rel=0.01)
