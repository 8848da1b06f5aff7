"""Published decisions from Weibull distributions: replacement at least cost, failures to come."""

import pytest

from rolamento.weibull import (
    Fleet,
    LifeDistribution,
    LifeTest,
    age_replacement,
    fleet_forecast,
)


def test_reliasoft_optimum_replacement() -> None:
    """ReliaWiki, "Optimum Replacement Time Example": β = 2.5, η = 1000 h, costs 1 and 5.

    As reproduced in the guide of the package reliability (M. Reid), "Optimal replacement time":
    493.19 on its grid, minimum cost 0.0035 per hour.
    """
    found = age_replacement(LifeDistribution.given(2.5, scale=1000.0), 1.0, 5.0)
    assert found.age.value == pytest.approx(493.19, rel=5e-4)
    assert found.cost == pytest.approx(0.0035, abs=5e-5)


def test_bearing_cages_in_the_next_year() -> None:
    """Escobar and Meeker (1999), section 6; Meeker and Escobar (1998), section 12.7.

    1703 bearing cages of Abernethy and others (1983), 6 failed; 300 h more for each of the others:
    5.057 failures are expected.
    """
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
    law = LifeDistribution.of_test(test, samples=500)
    assert law.shape == pytest.approx(2.035, abs=5e-4)
    assert law.scale == pytest.approx(11792.0, abs=0.5)
    fleet = Fleet.of(list(running), 300.0, list(running.values()))
    found = fleet_forecast(law, fleet)
    assert found.end.expected == pytest.approx(5.057, abs=0.002)
    assert found.end.lower <= 5.0 <= found.end.upper
    assert found.end.upper > found.exact[1]
