"""ISO 281: a_1, e, and Campanha's rating and lives of the 6305 (2008, chapters 3.4.1 and 4.1.2)."""

from __future__ import annotations

import pytest

from rolamento.life.basic import basic_rating_life, hours
from rolamento.life.load_zone import (
    catalogue_stiffness,
    continuous_life,
    load_zone,
    zone_life,
)
from rolamento.life.modified import fatigue_load_limit, life_modification_factor
from rolamento.life.reference import race_ratings
from rolamento.lubrication.viscosity_ratio import viscosity_ratio
from rolamento.ratings import dynamic_factor_of_grooves, dynamic_rating
from rolamento.verification import Check, campanha_2008_life
from rolamento.verification.iso_281 import checks
from rolamento.verification.published import RPM

CHECKS = (*checks(), *campanha_2008_life.checks())
LOAD, SPEED, BALL, PITCH, BALLS = 10_800.0, 2000.0 * RPM, 0.010319, 0.0445, 8
RATING, MEASURED_RATING, STATIC_RATING = 20_600.0, 30_756.0, 11_200.0
OILS = (12.89e-6, 7.03e-6)  # conditions I and II


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source}: {c.quantity}")
def test_printed_number(check: Check) -> None:
    assert check.verdict != "fails", check


def test_there_is_something_to_compare() -> None:
    assert len(CHECKS) == 13 + 5 + 27 + 6 + 2


def test_stand_in_for_nsks_curves_lands_near() -> None:
    """a_ISO with e_C = 0.8: 41 h and 17 h are printed; P/C = 0.52 is outside both methods."""
    found = []
    for oil in OILS:
        ratio = viscosity_ratio(oil, SPEED, PITCH)
        limit = fatigue_load_limit(STATIC_RATING, PITCH)
        factor = life_modification_factor(ratio, 0.8, limit, LOAD)
        found.append(float(hours(basic_rating_life(RATING, LOAD), SPEED) * factor))
    assert found == pytest.approx([41.0, 17.0], rel=0.03)


def test_stand_in_with_the_measured_grooves() -> None:
    """189 h and 69 h are printed; the fatigue limit raised as the dynamic rating is."""
    found = []
    for oil in OILS:
        ratio = viscosity_ratio(oil, SPEED, PITCH)
        limit = fatigue_load_limit(STATIC_RATING, PITCH) * MEASURED_RATING / RATING
        factor = life_modification_factor(ratio, 0.8, limit, LOAD)
        found.append(float(hours(basic_rating_life(MEASURED_RATING, LOAD), SPEED) * factor))
    assert found == pytest.approx([189.0, 69.0], rel=0.06)


def test_clearance_costs_a_few_per_cent_and_not_twenty() -> None:
    """Campanha takes the elastic deflection, 72 µm, for the clearance, and loses a fifth."""
    ratings = race_ratings(RATING, BALLS, BALL, PITCH, 0.52, 0.53, 0.0)
    stiffness = catalogue_stiffness(BALL)
    real = zone_life(load_zone([13e-6, 28e-6], LOAD, BALLS, stiffness), ratings)
    assert real == pytest.approx([0.96, 0.91], abs=0.01)
    mistaken = zone_life(load_zone(72e-6, LOAD, BALLS, stiffness), ratings)
    assert mistaken == pytest.approx(0.8, abs=0.015)


def test_reference_life_is_the_rating_life_without_clearance() -> None:
    """(C/P)³ at a load zone of one half, conformity 0.52 and a continuous ring of balls."""
    for count, gamma in ((7, 0.26), (12, 0.15), (20, 0.08)):
        pitch = BALL / gamma
        factor = dynamic_factor_of_grooves(gamma, 0.52, 0.52)
        rating = float(dynamic_rating(count, BALL, pitch, factor=factor))
        ratings = race_ratings(rating, count, BALL, pitch, 0.52, 0.52, 0.0)
        life = continuous_life(0.5, ratings, LOAD, count)
        assert life == pytest.approx((rating / LOAD) ** 3, rel=2e-3)
