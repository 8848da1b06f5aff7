"""The tables of ISO 281 and ISO 76, and Campanha's lives of the 6305 (2008, 3.4.1 and 4.1.2)."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty
from rolamento.life import life
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.life.iso281_modified import fatigue_load_limit, life_modification_factor
from rolamento.life.iso16281 import race_ratings
from rolamento.life.load_zone import (
    catalogue_stiffness,
    continuous_life,
    load_zone,
    zone_life,
)
from rolamento.oil.state import viscosity_ratio
from rolamento.ratings import (
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_rating,
    static_factor,
    static_factor_of_grooves,
)
from rolamento.solution import solve
from rolamento.units import RPM
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import life_checks
from rolamento.verification.check import published
from rolamento.verification.standards import iso_76_checks, iso_281_checks

CHECKS = (*iso_281_checks(), *iso_76_checks(), *life_checks())
LOAD, SPEED, BALL, PITCH, BALLS = 10_800.0, 2000.0 * RPM, 0.010319, 0.0445, 8
RATING, MEASURED_RATING, STATIC_RATING = 20_600.0, 30_756.0, 11_200.0
OILS = (12.89e-6, 7.03e-6)  # conditions I and II


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source}: {c.quantity}")
def test_printed_number(check: Check) -> None:
    assert check.verdict != "fails", check


def test_there_is_something_to_compare() -> None:
    # f_c; a_1 of two editions; e of single rows; e of double rows; f_0; Campanha
    assert len(CHECKS) == 40 + 13 + 5 + 27 + 6 + 26 + 41 + 2


def test_what_is_compared_is_what_the_program_uses() -> None:
    """The tables of the verification and those that ratings are interpolated in are the same."""
    gamma = np.arange(1, 41) / 100.0
    dynamic = published("iso_281")["dynamic_factor"]["factors"]
    assert dynamic_factor(gamma) == pytest.approx([float(v) for v in dynamic], abs=1e-12)
    static = published("iso_76")["static_factor"]["factors"]
    found = static_factor(np.arange(41) / 100.0)
    assert found == pytest.approx([float(v) for v in static], abs=1e-12)


def test_closed_forms_between_the_steps() -> None:
    """Halfway between the tables' steps: interpolation and closed form, but for the bend of f_0."""
    gamma = np.arange(3, 80, 2) / 200.0
    dynamic = dynamic_factor_of_grooves(gamma) / dynamic_factor(gamma) - 1.0
    assert dynamic[0] < 0.012  # f_c rises with γ^0.3 at first
    assert np.abs(dynamic[2:]).max() < 3.2e-3
    static = static_factor_of_grooves(gamma) - static_factor(gamma)
    away = np.abs(gamma - 0.09) > 0.01  # the outer race decides below, the inner above
    assert np.abs(static[away]).max() < 0.09


@pytest.mark.parametrize("leading", [0.957 * 39.9, 98.0665 * 0.41 * 0.90])
def test_other_constants_do_not_give_the_table(leading: float) -> None:
    gamma = np.arange(1, 41) / 100.0
    scaled = dynamic_factor_of_grooves(gamma) * leading / (98.0665 * 0.41 * 0.95)
    assert (np.abs(scaled - dynamic_factor(gamma)) > 0.05).sum() >= 8


@pytest.mark.parametrize("degrees", [0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0])
def test_equivalent_load_and_the_theory_behind_it(degrees: float) -> None:
    """X and Y come from Lundberg and Palmgren's theory: the reference life of a bearing without
    clearance under a load that is mostly axial, by the equilibrium of its balls.

    The standard's factors have in them Lundberg and Palmgren's 1 - sin α/3: what axially loaded
    bearings lose by their balls' not sharing the load evenly (from general knowledge).
    """
    angle = np.radians(max(degrees, 0.01))
    bearing = Bearing(
        ball_count=16, ball_diameter=0.0127, pitch_diameter=0.07, contact_angle=angle,
        inner_conformity=0.52, outer_conformity=0.52,
    )  # fmt: skip
    relative = np.array([0.689, 2.07]) * 1e6
    axial = relative * 16 * 0.0127**2
    batch = solve(Case(bearing=bearing, duty=Duty()), fx=axial, fz=0.4 * axial)
    found = life(batch)
    assert batch.converged.all()
    by_balls = found.ratings.dynamic_of_set / np.cbrt(found["iso16281"].life)
    uneven = 1.0 - np.sin(angle) / 3.0
    assert by_balls == pytest.approx(uneven * found.loads.dynamic, rel=0.065)


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


@pytest.mark.parametrize("degrees", [0.0, 15.0, 25.0, 40.0])
def test_reference_life_is_the_rating_life_without_clearance(degrees: float) -> None:
    """(C/P)³ at a load zone of one half, conformity 0.52 and a continuous ring of balls.

    P is F_r there at every contact angle: the ball loads grow with 1/cos α, and so do the ratings
    of the races.
    """
    angle = np.radians(degrees)
    for count, gamma in ((7, 0.26), (12, 0.15), (20, 0.08), (40, 0.03)):
        pitch = BALL * np.cos(angle) / gamma
        factor = dynamic_factor_of_grooves(gamma, 0.52, 0.52)
        rating = float(dynamic_rating(count, BALL, pitch, angle, factor=factor))
        ratings = race_ratings(rating, count, BALL, pitch, 0.52, 0.52, angle)
        life = continuous_life(0.5, ratings, LOAD / np.cos(angle), count)
        assert life == pytest.approx((rating / LOAD) ** 3, rel=2e-3)


@pytest.mark.parametrize("degrees", [0.0, 25.0, 40.0])
def test_ratings_of_the_races_by_lundberg_and_palmgren(degrees: float) -> None:
    """Q_c = 98.1 (2f/(2f-1))^0.41 (1∓γ)^1.39/(1±γ)^(1/3) (γ/cos α)^0.3 D^1.8 Z^(-1/3), N and mm.

    With b_m λ = 1.235 the ratings of the races have to come out that the standard takes from C. The
    standard's 0.407, 0.389 and 1.044 are rounded.
    """
    angle, count, gamma, f_i, f_o = np.radians(degrees), 16, 0.18, 0.52, 0.53
    ball, pitch = 1e3 * BALL, 1e3 * BALL * np.cos(angle) / gamma
    common = 98.0665 * 1.235 * (gamma / np.cos(angle)) ** 0.3 * ball**1.8 * count ** (-1 / 3)
    inner = common * (2 * f_i / (2 * f_i - 1)) ** 0.41
    inner *= (1 - gamma) ** 1.39 / (1 + gamma) ** (1 / 3)
    outer = common * (2 * f_o / (2 * f_o - 1)) ** 0.41
    outer *= (1 + gamma) ** 1.39 / (1 - gamma) ** (1 / 3)
    factor = dynamic_factor_of_grooves(gamma, f_i, f_o)
    rating = dynamic_rating(count, BALL, pitch * 1e-3, angle, factor=factor)
    found = race_ratings(rating, count, BALL, pitch * 1e-3, f_i, f_o, angle)
    assert float(found.inner) == pytest.approx(inner, rel=0.01)
    assert float(found.outer) == pytest.approx(outer, rel=0.01)


def test_reference_life_of_many_balls_in_equilibrium() -> None:
    """The same identity from the solver: without clearance, averaged over where the balls stand."""
    bearing = Bearing(
        ball_count=24, ball_diameter=0.006, pitch_diameter=0.06, diametral_clearance=0.0,
        inner_conformity=0.52, outer_conformity=0.52,
    )  # fmt: skip
    case = Case(bearing=bearing, duty=Duty())
    places = np.linspace(0.0, 2.0 * np.pi / 24.0, 9)[:-1]
    batch = solve(case, {"duty.first_ball_azimuth": places}, fz=np.full(8, 900.0))
    found = life(batch)
    assert found["iso281"].life == pytest.approx((found.ratings.dynamic_of_set[0] / 900.0) ** 3)
    assert found["iso16281"].life.mean() == pytest.approx(found["iso281"].life[0], rel=0.02)
