"""Growth to a limit: lines, their bands, and the times at which they arrive."""

import numpy as np
import pytest
from scipy import stats

from rolamento.numerics.growth import LAWS, fit_growth, forecast, growth_rate

TIMES = np.array([0.0, 500.0, 1100.0, 1600.0, 2300.0, 3000.0])
VALUES = np.array([1.02, 1.11, 1.31, 1.38, 1.66, 1.89])


def test_line_is_that_of_scipy() -> None:
    found, known = fit_growth(TIMES, VALUES, "linear"), stats.linregress(TIMES, VALUES)
    assert found.slope == pytest.approx(known.slope, rel=1e-12)
    assert found.slope_error == pytest.approx(known.stderr, rel=1e-9)
    assert found.p_value == pytest.approx(0.5 * known.pvalue, rel=1e-9)
    assert found.at(np.array(0.0)) == pytest.approx(known.intercept, rel=1e-12)


def test_exponential_is_the_line_through_logarithms() -> None:
    found = fit_growth(TIMES, VALUES, "exponential")
    known = stats.linregress(TIMES, np.log(VALUES))
    assert found.slope == pytest.approx(known.slope, rel=1e-12)
    assert growth_rate(TIMES, VALUES) == found.slope
    assert found.doubling_time() == pytest.approx(np.log(2.0) / known.slope)


@pytest.mark.parametrize("law", LAWS)
def test_limit_lies_on_line_and_band(law: str) -> None:
    crossing = fit_growth(TIMES, VALUES, law).reaches(2.8, 0.9)  # type: ignore[arg-type]
    growth = fit_growth(TIMES, VALUES, law)  # type: ignore[arg-type]
    assert crossing.code == "reached"
    assert growth.at(np.array(crossing.time)) == pytest.approx(2.8, rel=1e-9)
    assert growth.band(np.array(crossing.lower), 0.9)[1] == pytest.approx(2.8, rel=1e-9)
    assert growth.band(np.array(crossing.upper), 0.9)[0] == pytest.approx(2.8, rel=1e-9)


def test_interval_holds_as_often_as_it_says() -> None:
    random, times = np.random.default_rng(2), np.linspace(0.0, 10.0, 8)
    held = told = 0
    for _ in range(1500):
        found = fit_growth(times, 1.0 + 0.2 * times + random.normal(0.0, 0.25, 8), "linear")
        crossing = found.reaches(5.0, 0.9)
        told += crossing.code == "reached"
        held += crossing.code == "reached" and crossing.lower <= 20.0 <= crossing.upper
    assert told > 1450
    assert held / told == pytest.approx(0.9, abs=0.03)


def test_no_growth_has_no_time() -> None:
    flat = np.array([1.1, 0.9, 1.05, 0.95, 1.0, 1.02])
    assert forecast(TIMES, flat, 2.0).crossing.code in ("no_trend", "falling")
    assert forecast(TIMES, VALUES[::-1], 2.8).crossing.code == "falling"
    assert forecast(TIMES, VALUES, 1.5).crossing.code == "exceeded"
    assert forecast(TIMES[:2], VALUES[:2], 2.8).crossing.code == "too_few"
    for found in (forecast(TIMES, flat, 2.0), forecast(TIMES[:2], VALUES[:2], 2.8)):
        assert np.isnan(found.crossing.time)


def test_slope_is_told_significant_as_often_as_chance_has_it() -> None:
    """Without growth, "reached" comes in half of what the confidence leaves out."""
    random, times = np.random.default_rng(5), np.arange(6.0)
    reached = sum(
        fit_growth(times, random.normal(1.0, 0.1, 6), "linear").reaches(9.0, 0.9).code == "reached"
        for _ in range(2000)
    )
    assert reached / 2000 == pytest.approx(0.05, abs=0.015)


def test_likelier_law_is_chosen() -> None:
    random, times = np.random.default_rng(1), np.linspace(0.0, 10.0, 30)
    rising = np.exp(0.3 * times + random.normal(0.0, 0.05, 30))
    assert forecast(times, rising, 100.0).growth.law == "exponential"
    straight = 1.0 + 2.0 * times + random.normal(0.0, 0.2, 30)
    assert forecast(times, straight, 100.0).growth.law == "linear"
    assert forecast(times, rising, 100.0, law="linear").growth.law == "linear"
    assert len(forecast(times, straight - 5.0, 100.0).growths) == 1
