"""Laws of life: monotony, scaling, limits, order of steps; and the field against plain sums."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty, Load
from rolamento.life import LifeConditions, life
from rolamento.life.contamination import class_of_code, class_of_grease, contamination_factor
from rolamento.life.equivalent_load import (
    ListedFactors,
    equivalent_load,
    load_factors,
    static_equivalent_load,
)
from rolamento.life.iso281 import basic_rating_life
from rolamento.life.iso281_modified import life_modification_factor
from rolamento.life.iso16281 import race_ratings, reference_life, system_life
from rolamento.life.load_zone import clearance_function, continuous_life, load_zone
from rolamento.life.reliability import reliability_factor, reliability_of
from rolamento.life.shear_field import passing_shear
from rolamento.life.spectrum import miner_life, shaft_life
from rolamento.ratings import dynamic_factor_of_grooves, dynamic_rating
from rolamento.solution import solve

angles = st.floats(0.0, 45.0)
loads = st.floats(1.0, 1e5)
shares = st.floats(1e-3, 1.0)
lives = st.lists(st.floats(1e-3, 1e9), min_size=1, max_size=6)
EDITIONS = ("2007", "1990")


@given(st.floats(0.02, 0.9999), st.floats(0.02, 0.9999))
def test_more_reliability_is_less_life(one: float, other: float) -> None:
    low, high = sorted((one, other))
    for edition in EDITIONS:
        first, second = (reliability_factor(s, edition) for s in (low, high))
        assert first >= second
        assert reliability_of(first, edition) == pytest.approx(low, rel=1e-9)


@given(st.floats(0.1, 6.0), st.floats(0.0, 1.0), st.floats(1e-3, 1.0), st.floats(1.0, 2.0))
def test_modification_rises_with_oil_and_cleanliness_and_falls_with_load(
    ratio: float, clean: float, strength: float, more: float
) -> None:
    limit, load = strength * 1000.0, 1000.0
    here = life_modification_factor(ratio, clean, limit, load)
    assert 0.1 <= here <= 50.0
    # the standard's ranges of κ meet within 0.2 %
    assert life_modification_factor(ratio * more, clean, limit, load) >= here * (1.0 - 2e-3)
    assert life_modification_factor(ratio, min(clean * more, 1.0), limit, load) >= here * (
        1 - 1e-12
    )
    assert life_modification_factor(ratio, clean, limit, load * more) <= here * (1 + 1e-12)
    assert life_modification_factor(ratio, clean, limit, load, additives=True) >= here


@given(st.floats(0.1, 6.0), st.floats(0.01, 3.0))
def test_dirt_never_helps(ratio: float, diameter: float) -> None:
    for supply, codes in (
        ("circulating", ("-/13/10", "-/15/12", "-/17/14", "-/19/16")),
        ("bath", ("-/13/10", "-/15/12", "-/17/14", "-/19/16", "-/21/18")),
    ):
        factors = [
            float(contamination_factor(class_of_code(code, supply), ratio, diameter))  # type: ignore[arg-type]
            for code in codes
        ]
        assert all(0.0 <= factor <= 1.0 for factor in factors)
        assert factors == sorted(factors, reverse=True)
    words = ("high", "normal", "slight", "severe", "very_severe")
    greases = [
        float(contamination_factor(class_of_grease(word), ratio, diameter)) for word in words
    ]
    assert greases == sorted(greases, reverse=True)


@given(angles, loads, loads, st.booleans(), st.floats(1.01, 10.0))
def test_equivalent_load_grows_with_the_whole_load(
    degrees: float, radial: float, axial: float, double: bool, more: float
) -> None:
    angle, area = np.radians(degrees), 1e-3

    def load(factor: float) -> float:
        fr, fa = factor * radial, factor * axial
        return float(equivalent_load(fr, fa, angle, fa / area, double_row=double).load)

    assert load(more) > load(1.0)
    static = static_equivalent_load(radial, axial, angle, double_row=double)
    assert static >= radial
    assert static_equivalent_load(more * radial, more * axial, angle, double_row=double) == (
        pytest.approx(more * float(static))
    )


@given(angles, st.floats(1e3, 1e8))
def test_both_lines_of_the_equivalent_load_meet(degrees: float, relative: float) -> None:
    found = load_factors(np.radians(degrees), relative)
    beyond = float(found.radial + found.axial * found.limit)
    # exact but for rounding at the table's angles, within 3 % between them
    assert beyond == pytest.approx(1.0, abs=0.03)


@given(lives, st.floats(0.1, 10.0))
def test_a_system_lives_less_than_its_weakest_part(parts: list[float], scale: float) -> None:
    whole = float(system_life(parts))
    assert whole <= min(parts) * (1.0 + 1e-12)
    assert whole >= min(parts) * len(parts) ** -0.9 * (1.0 - 1e-12)
    assert system_life(np.array(parts) * scale) == pytest.approx(whole * scale, rel=1e-9)
    assert shaft_life(parts[::-1]) == pytest.approx(whole, rel=1e-9)
    assert shaft_life(parts, slope=[10 / 9] * len(parts)) == pytest.approx(whole, rel=1e-9)


@given(st.lists(st.tuples(st.floats(1e-3, 1e9), shares), min_size=1, max_size=6))
def test_a_spectrum_lies_between_its_steps(steps: list[tuple[float, float]]) -> None:
    life = np.array([step[0] for step in steps])
    share = np.array([step[1] for step in steps])
    share = share / share.sum()
    found = float(miner_life(life, share))
    assert life.min() * (1 - 1e-9) <= found <= life.max() * (1 + 1e-9)
    assert miner_life(life[::-1], share[::-1]) == pytest.approx(found, rel=1e-9)


@given(st.lists(st.floats(0.0, 1e4), min_size=3, max_size=12), st.floats(1.1, 5.0))
def test_reference_life_falls_with_the_cube_of_all_loads(balls: list[float], more: float) -> None:
    ratings = race_ratings(23400.0, len(balls), 0.0115, 0.0435, 0.52, 0.53, 0.0)
    q = np.array([balls]) + 1.0
    one = reference_life(q, q, ratings).life[0]
    assert reference_life(more * q, more * q, ratings).life[0] == pytest.approx(one / more**3)
    worse = q.copy()
    worse[0, 0] *= more
    assert reference_life(worse, worse, ratings).life[0] < one


@given(st.floats(1e-3, 1e3), st.floats(0.5, 2.0))
def test_load_zone_inverts_its_function(zone: float, load: float) -> None:
    stiffness, count = 8e9, 8
    clearance = float(clearance_function(zone)) * (load * 1e3 / count / stiffness) ** (2 / 3)
    assert load_zone(clearance, load * 1e3, count, stiffness) == pytest.approx(zone, rel=1e-6)


@given(st.floats(0.0, 1.4), st.floats(0.02, 5.0), st.floats(1.0, 50.0))
def test_passing_shear_is_bounded(eta: float, zeta: float, k: float) -> None:
    assert 0.0 <= passing_shear(eta, zeta, k) <= 0.25


@given(loads, st.floats(1.1, 4.0))
def test_basic_life_and_load(load: float, more: float) -> None:
    assert basic_rating_life(1e4, more * load) == pytest.approx(
        float(basic_rating_life(1e4, load)) / more**3
    )


def test_solved_cases_live_less_under_more_load() -> None:
    """Every theory, over loads from light to beyond what is allowed."""
    bearing = Bearing(
        ball_count=9,
        ball_diameter=0.0119,
        pitch_diameter=0.046,
        diametral_clearance=10e-6,
        inner_conformity=0.52,
        outer_conformity=0.53,
    )
    case = Case(bearing=bearing, duty=Duty(inner_speed=300.0, load=Load(fz=1.0)))
    batch = solve(case, fz=np.geomspace(300.0, 25_000.0, 40))
    conditions = LifeConditions(viscosity_ratio=1.2, contamination=0.6, material_factor=1.0)
    found = life(batch, conditions, stress_volume=True)
    for name, record in found.theories.items():
        finite = record.life[np.isfinite(record.life)]
        assert finite.size >= 10, name
        assert np.all(np.diff(finite) < 0.0), name
        assert np.all(np.isfinite(record.life) | np.isinf(record.life)), name
    limited, basic = found["ioannides_harris"].life, found["iso16281"].life
    assert np.all(limited >= basic)


bearings = st.builds(
    lambda balls, ball, slack, degrees, inner, outer: Bearing(
        ball_count=balls,
        ball_diameter=ball,
        pitch_diameter=ball / np.sin(np.pi / balls) * slack,
        contact_angle=np.radians(degrees),
        inner_conformity=inner,
        outer_conformity=outer,
    ),
    st.integers(8, 24),
    st.floats(0.004, 0.03),
    st.floats(1.08, 1.5),
    st.floats(12.0, 40.0),
    st.floats(0.51, 0.54),
    st.floats(0.51, 0.54),
)


@settings(max_examples=25)
@given(bearings, st.floats(0.3, 6.0), st.floats(0.0, 0.6), st.floats(1.1, 2.0))
def test_every_theory_falls_with_the_load(
    bearing: Bearing, size: float, slope: float, more: float
) -> None:
    """Any bearing; the whole load grows, in its direction."""
    axial = size * 1e6 * bearing.ball_count * bearing.ball_diameter**2 * np.array([1.0, more])
    case = Case(bearing=bearing, duty=Duty(inner_speed=100.0))
    batch = solve(case, fx=axial, fz=slope * axial)
    assert batch.converged.all()
    conditions = LifeConditions(viscosity_ratio=1.5, contamination=0.5, material_factor=1.0)
    found = life(batch, conditions, stress_volume=True)
    for name, record in found.theories.items():
        light, heavy = record.life
        assert heavy <= light, name
        assert heavy < light or np.isinf(light), name


@settings(max_examples=25)
@given(
    bearings,
    st.floats(0.3, 6.0),
    st.floats(0.1, 3.5),
    st.floats(1.02, 3.0),
    st.floats(0.02, 0.95),
    st.floats(0.01, 0.5),
)
def test_modified_lives_rise_with_oil_and_cleanliness(
    bearing: Bearing, size: float, ratio: float, thicker: float, clean: float, cleaner: float
) -> None:
    """Solved cases: more κ or more e_C never shortens a life; the basic ones do not change."""
    axial = size * 1e6 * bearing.ball_count * bearing.ball_diameter**2
    case = Case(bearing=bearing, duty=Duty(inner_speed=100.0))
    batch = solve(case, fx=np.full(3, axial), fz=np.full(3, 0.3 * axial))
    kappa = np.array([ratio, ratio * thicker, ratio])
    factor = np.array([clean, clean, min(clean + cleaner, 1.0)])
    conditions = LifeConditions(viscosity_ratio=kappa, contamination=factor)
    found = life(batch, conditions)
    for name in ("iso281_modified", "iso16281_modified"):
        here, with_thicker, with_cleaner = found[name].life
        assert with_thicker >= here * (1.0 - 2e-3), name  # the ranges of κ meet within 0.2 %
        assert with_cleaner >= here, name
        if found[name].factors["a_iso"][2] < 50.0:
            assert with_cleaner > here, name
    for name in ("iso281", "iso16281"):
        assert np.ptp(found[name].life) == 0.0, name


@given(st.floats(0.02, 0.35), st.floats(0.0, 45.0), st.integers(5, 40))
@pytest.mark.sweep
def test_rating_life_is_the_reference_life_of_half_a_ring(
    gamma: float, degrees: float, count: int
) -> None:
    """(C/P)³ at ε = ½ and grooves of 0.52, for every γ, contact angle and number of balls."""
    angle, ball = np.radians(degrees), 0.01
    pitch = ball * np.cos(angle) / gamma
    factor = dynamic_factor_of_grooves(gamma, 0.52, 0.52)
    rating = float(dynamic_rating(count, ball, pitch, angle, factor=factor))
    ratings = race_ratings(rating, count, ball, pitch, 0.52, 0.52, angle)
    life = continuous_life(0.5, ratings, 0.1 * rating / np.cos(angle), count)
    assert life == pytest.approx(1000.0, rel=2e-3)


@given(st.floats(8.0, 40.0), st.floats(0.0, 1e5), st.floats(0.0, 1e5))
def test_listed_factors_of_the_standard_s_angle_change_nothing(
    degrees: float, radial: float, axial: float
) -> None:
    angle = np.radians(degrees)
    cotangent = 1.0 / np.tan(angle)
    exact = ListedFactors(1.5 / cotangent, 0.4 * cotangent, 0.22 * cotangent)
    for double in (False, True):
        plain = equivalent_load(radial, axial, angle, 0.0, double_row=double, kind="roller")
        made = equivalent_load(
            radial, axial, angle, 0.0, double_row=double, kind="roller", listed=exact
        )
        still = static_equivalent_load(radial, axial, angle, double_row=double, kind="roller")
        made_still = static_equivalent_load(
            radial, axial, angle, double_row=double, kind="roller", listed=exact
        )
        assert made.load == pytest.approx(plain.load, rel=1e-12)
        assert made_still == pytest.approx(still, rel=1e-12)
