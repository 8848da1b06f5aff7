"""Ratings: the tables of the standards, the closed forms behind them, catalogue figures."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import ratings
from rolamento.catalogue import catalogue

MM = 1e-3
GAMMA = np.arange(1, 41) / 100.0


def test_values_of_the_tables() -> None:
    assert ratings.dynamic_factor([0.01, 0.19, 0.40]).tolist() == [29.1, 60.0, 48.4]
    assert ratings.static_factor([0.0, 0.09, 0.40]).tolist() == [14.7, 16.5, 9.4]
    assert ratings.dynamic_factor(0.205) == pytest.approx(59.85)


def test_no_number_outside_the_tables() -> None:
    assert np.isnan(ratings.dynamic_factor([0.009, 0.41, np.nan])).all()
    assert np.isnan(ratings.static_factor([-0.01, 0.41])).all()
    assert np.isnan(ratings.dynamic_factor_of_grooves([0.0, 1.0, -0.2])).all()
    assert np.isnan(ratings.dynamic_factor_of_grooves(0.2, 0.5, 0.52))
    assert np.isnan(ratings.static_factor_of_grooves([0.2, 1.2], [0.49, 0.52], 0.53)).all()


def test_closed_form_of_the_dynamic_factor_is_behind_the_table() -> None:
    found = ratings.dynamic_factor_of_grooves(GAMMA)
    np.testing.assert_allclose(found, ratings.dynamic_factor(GAMMA), rtol=2e-3)


def test_hertz_is_behind_the_table_of_the_static_factor() -> None:
    gamma = np.arange(1, 41) / 100.0
    found = ratings.static_factor_of_grooves(gamma)
    np.testing.assert_allclose(found, ratings.static_factor(gamma), rtol=5e-3)


@pytest.mark.parametrize(
    ("balls", "ball", "pitch", "dynamic", "static"),
    [
        # NSK's 6203, 6205 and 6305; geometry: Case Western (17/64 and 5/16 in), Campanha 2008
        (8, 6.747, 28.5, 9550.0, 4800.0),
        (9, 7.938, 39.04, 14000.0, 7850.0),
        (8, 10.319, 44.5, 20600.0, 11200.0),
    ],
)
def test_catalogue_ratings(
    balls: int, ball: float, pitch: float, dynamic: float, static: float
) -> None:
    geometry = (balls, ball * MM, pitch * MM)
    assert ratings.dynamic_rating(*geometry) == pytest.approx(dynamic, rel=5e-3)
    assert ratings.static_rating(*geometry) == pytest.approx(static, rel=1e-2)


def test_dynamic_rating_of_large_balls_is_continuous() -> None:
    below, above = ratings.dynamic_rating(20, np.array([25.4, 25.4001]) * MM, 0.2)
    assert above == pytest.approx(below, rel=1e-4)
    powers = ratings.dynamic_rating(20, [50.0 * MM, 100.0 * MM], [0.5, 1.0])
    assert powers[1] / powers[0] == pytest.approx(2.0**1.4)


def test_rows_and_angle() -> None:
    angle = np.radians(40.0)
    single = ratings.dynamic_rating(16, 22.23 * MM, 125.26 * MM, angle)
    double = ratings.dynamic_rating(16, 22.23 * MM, 125.26 * MM, angle, rows=2)
    assert double / single == pytest.approx(2.0**0.7)
    assert ratings.static_rating(16, 0.02, 0.2, angle, rows=2, factor=14.0) == pytest.approx(
        14.0 * 2 * 16 * 400.0 * np.cos(angle)
    )


def test_closer_grooves_carry_more() -> None:
    f = np.array([0.505, 0.515, 0.52, 0.53, 0.55])
    assert (np.diff(ratings.dynamic_factor_of_grooves(0.2, f, f)) < 0.0).all()
    assert (np.diff(ratings.static_factor_of_grooves(0.2, f, f)) < 0.0).all()


def test_campanha_dynamic_factor_of_measured_grooves() -> None:
    """He prints 88.6 for f_i = 5.21 mm / (13/32 in), f_o = 0.53 (Campanha 2008)."""
    ball = 13.0 / 32.0 * 25.4
    found = ratings.dynamic_factor_of_grooves(ball / 44.5, 5.21 / ball, 0.53)
    assert found == pytest.approx(88.6, abs=0.05)


def test_a_catalogue_keeps_the_static_formula() -> None:
    """C0 = f0 Z D²: the balls of NSK's 6205, of which Case Western counts nine of 5/16 in."""
    bearing = catalogue().find("6205").bearing
    assert bearing.static_rating is not None
    assert bearing.f0 is not None
    ball = np.sqrt(bearing.static_rating / (bearing.f0 * 9))
    assert ball == pytest.approx(7.938, rel=5e-3)
