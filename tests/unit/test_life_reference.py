"""Reference life from ball loads, and the load zone."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.life.iso16281 import (
    equivalent_ball_load,
    race_life,
    race_ratings,
    reference_life,
    system_life,
)
from rolamento.life.load_zone import (
    catalogue_stiffness,
    clearance_function,
    continuous_life,
    load_zone,
    mean_loads,
    zone_life,
)
from rolamento.ratings import dynamic_factor_of_grooves, dynamic_rating

BEARING = (23400.0, 7, 0.0115, 0.0435, 0.52, 0.53, 0.0)


def test_equal_loads_are_their_own_mean() -> None:
    for turning in (True, False):
        assert equivalent_ball_load(np.full(9, 250.0), turning=turning) == pytest.approx(250.0)
    assert equivalent_ball_load(np.zeros(9), turning=True) == 0.0


def test_mean_of_one_loaded_ball() -> None:
    load = [0.0, 0.0, 0.0, 800.0]
    assert equivalent_ball_load(load, turning=True) == pytest.approx(800.0 * 0.25 ** (1 / 3))
    assert equivalent_ball_load(load, turning=False) == pytest.approx(800.0 * 0.25**0.3)


def test_single_parts_and_systems() -> None:
    assert system_life([5.0]) == pytest.approx(5.0)
    assert system_life([5.0, np.inf]) == pytest.approx(5.0)
    assert system_life([np.inf, np.inf]) == np.inf
    assert np.isnan(system_life([np.nan, 5.0]))
    assert system_life([8.0, 8.0]) == pytest.approx(8.0 * 2.0**-0.9)
    assert system_life([1e-300, 1e-300]) == pytest.approx(1e-300 * 2.0**-0.9)


def test_ratings_of_the_races_make_the_rating() -> None:
    """Lundberg and Palmgren: both races together carry C at a load zone of one half."""
    for gamma in np.linspace(0.05, 0.35, 7):
        factor = dynamic_factor_of_grooves(gamma, 0.52, 0.52)
        rating = dynamic_rating(10, 0.01, 0.01 / gamma, factor=factor)
        ratings = race_ratings(rating, 10, 0.01, 0.01 / gamma, 0.52, 0.52, 0.0)
        load = 0.1 * rating
        life = continuous_life(0.5, ratings, load, 10)
        assert life == pytest.approx(1000.0, rel=2e-3)


def test_two_rows_are_weaker_than_one_with_half_the_load() -> None:
    ratings = race_ratings(*BEARING)
    load = np.array([[300.0, 700.0, 900.0, 700.0, 300.0, 0.0, 0.0]])
    one = reference_life(load, load, ratings)
    two = reference_life(np.tile(load, 2), np.tile(load, 2), ratings, (0, 7))
    assert two.life == pytest.approx(one.life * 2.0**-0.9)
    # the same as C of two rows, i^0.7 as much, under twice the load
    assert two.life == pytest.approx(one.life * (2.0**0.7 / 2.0) ** 3)
    assert two.row.shape == (1, 2)
    assert two.row[0] == pytest.approx(np.full(2, one.life[0]))


def test_turning_rings() -> None:
    ratings = race_ratings(*BEARING)
    load = np.array([[300.0, 700.0, 900.0, 700.0, 300.0, 0.0, 0.0]])
    inner = reference_life(load, load, ratings)
    outer = reference_life(load, load, ratings, inner_turning=False, outer_turning=True)
    both = reference_life(load, load, ratings, outer_turning=True)
    # the inner race decides, and one that stands under its load lives less
    assert outer.life < inner.life < both.life


def test_a_case_without_result_stays_without_life() -> None:
    load = np.array([[100.0] * 7, [np.nan] * 7, [0.0] * 7])
    life = reference_life(load, load, race_ratings(*BEARING)).life
    assert np.isfinite(life[0])
    assert np.isnan(life[1])
    assert life[2] == np.inf


def test_scale_of_race_life() -> None:
    assert race_life(1000.0, [1000.0, 500.0, 0.0]) == pytest.approx([1.0, 8.0, np.inf])


def test_load_zone_without_clearance() -> None:
    stiffness = catalogue_stiffness(0.010319)
    assert load_zone(0.0, 1000.0, 8, stiffness) == pytest.approx(0.5, rel=1e-12)
    zones = load_zone(np.array([-20e-6, -5e-6, 0.0, 5e-6, 50e-6]), 1000.0, 8, stiffness)
    assert np.all(np.diff(zones) < 0.0)
    target = 5e-6 * (stiffness * 8 / 1000.0) ** (2 / 3)
    assert clearance_function(zones[3]) == pytest.approx(float(target), rel=1e-9)
    assert np.isnan(load_zone(5e-6, 0.0, 8, stiffness))


def test_load_zone_of_the_catalogue_formula() -> None:
    # f = clearance D^(1/3) / (0.00044 (F_r/Z)^(2/3)) with N and mm
    d, clearance, ball = 10.319, 0.013, 10800.0 / 8
    zone = load_zone(clearance * 1e-3, 10800.0, 8, catalogue_stiffness(d * 1e-3))
    expected = clearance * d ** (1 / 3) / (0.00044 * ball ** (2 / 3))
    assert clearance_function(zone) == pytest.approx(expected, rel=1e-9)


def test_means_by_plain_sums() -> None:
    zones = np.array([0.1, 0.5, 0.9, 1.0, 1.5, 20.0])
    psi = 2.0 * np.pi * (np.arange(200_000) + 0.5) / 200_000
    turning, standing = mean_loads(zones)
    for zone, one, two in zip(zones, turning, standing, strict=True):
        w = np.maximum(1.0 - (1.0 - np.cos(psi)) / (2.0 * zone), 0.0)
        assert one == pytest.approx(np.mean(w**4.5) ** (1 / 3), rel=1e-9)
        assert two == pytest.approx(np.mean(w**5.0) ** 0.3, rel=1e-9)


def test_life_is_greatest_with_a_little_preload() -> None:
    ratings = race_ratings(*BEARING)
    zones = np.linspace(0.2, 2.0, 361)
    life = zone_life(zones, ratings)
    assert 0.7 <= zones[np.argmax(life)] <= 0.8
    assert zone_life(0.5, ratings) == pytest.approx(1.0)
