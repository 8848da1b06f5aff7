"""The life that leads: it never rises when the oil thins, or with dirt, load or speed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty, Load
from rolamento.life import Headline, LifeConditions, life
from rolamento.life.contamination import class_of_grease
from rolamento.solution import solve

MEETING = 2e-3
"""The standard's ranges of κ meet within this."""
OILS = np.concatenate([np.geomspace(10.0, 1e-4, 120), [0.101, 0.1, 0.0999, 1e-30]])
DIRTS = np.concatenate([np.linspace(1.0, 0.0, 60), [0.21, 0.2, 0.199, 1e-3, 1e-9]])

angular = st.builds(
    lambda balls, ball, slack, degrees: Bearing(
        ball_count=balls,
        ball_diameter=ball,
        pitch_diameter=ball / np.sin(np.pi / balls) * slack,
        contact_angle=np.radians(degrees),
        inner_conformity=0.52,
        outer_conformity=0.53,
    ),
    st.integers(8, 24),
    st.floats(0.004, 0.03),
    st.floats(1.08, 1.5),
    st.floats(12.0, 40.0),
)
grooved = st.builds(
    lambda balls, ball, slack, play: Bearing(
        ball_count=balls,
        ball_diameter=ball,
        pitch_diameter=ball / np.sin(np.pi / balls) * slack,
        diametral_clearance=play * ball,
        inner_conformity=0.52,
        outer_conformity=0.53,
    ),
    st.integers(7, 12),
    st.floats(0.004, 0.03),
    st.floats(1.15, 1.5),
    st.floats(0.0, 3e-3),
)
bearings = st.one_of(angular, grooved)
sizes = st.floats(0.3, 12.0)
"""Axial load over Z D², MPa."""


def leading(
    bearing: Bearing, conditions: LifeConditions, force: Any, speed: Any = 100.0, slope: float = 0.3
) -> Headline:
    """The life that leads of cases that differ in conditions, load or speed."""
    case = Case(bearing=bearing, duty=Duty(inner_speed=100.0, load=Load(fz=1.0)))
    batch = solve(case, fx=force, fz=slope * np.asarray(force), inner_speed=speed)
    found = life(batch, conditions).headline
    assert batch.converged.all()
    return found


def force_on(bearing: Bearing, size: float) -> float:
    return size * 1e6 * bearing.ball_count * bearing.ball_diameter**2


def falls(life: Any, worse: Any, *, within: float = 1e-9) -> None:
    """A life that does not rise in the order of what makes it worse."""
    ordered = np.asarray(life)[np.argsort(-np.asarray(worse), kind="stable")]
    assert np.all(ordered[1:] <= ordered[:-1] * (1.0 + within))


@settings(max_examples=20)
@given(bearings, sizes, st.floats(0.0, 1.0), st.booleans())
def test_thinner_oil_never_lengthens_it(
    bearing: Bearing, size: float, clean: float, additives: bool
) -> None:
    conditions = LifeConditions(viscosity_ratio=OILS, contamination=clean, additives=additives)
    found = leading(bearing, conditions, np.full(OILS.size, force_on(bearing, size)))
    falls(found.life, OILS, within=MEETING)
    assert np.array_equal(found.below | ~found.leads, (OILS < 0.1) | (clean == 0.0) | ~found.leads)
    assert set(found.theory) == {"iso16281_modified"}
    thin = found.life[OILS < 0.1]
    assert np.ptp(thin) <= 1e-12 * thin[0]


@settings(max_examples=10)
@given(bearings, sizes, st.sampled_from(("high", "normal", "slight", "severe", "very_severe")))
def test_thinner_oil_with_a_class_of_dirt_never_lengthens_it(
    bearing: Bearing, size: float, word: str
) -> None:
    """e_C of a class falls with κ itself, to 0."""
    conditions = LifeConditions(viscosity_ratio=OILS, contamination=class_of_grease(word))
    found = leading(bearing, conditions, np.full(OILS.size, force_on(bearing, size)))
    falls(found.life, OILS, within=MEETING)


@settings(max_examples=20)
@given(bearings, sizes, st.floats(1e-3, 6.0), st.booleans())
def test_more_dirt_never_lengthens_it(
    bearing: Bearing, size: float, ratio: float, additives: bool
) -> None:
    conditions = LifeConditions(viscosity_ratio=ratio, contamination=DIRTS, additives=additives)
    found = leading(bearing, conditions, np.full(DIRTS.size, force_on(bearing, size)))
    falls(found.life, DIRTS)
    assert np.array_equal(found.below, ((DIRTS == 0.0) | (ratio < 0.1)) & found.leads)


@settings(max_examples=20)
@given(
    bearings,
    st.one_of(st.none(), st.floats(1e-3, 6.0)),
    st.one_of(st.none(), st.floats(0.0, 1.0)),
    st.floats(0.0, 1.0),
)
def test_more_load_never_lengthens_it(
    bearing: Bearing, ratio: float | None, clean: float | None, slope: float
) -> None:
    """Whatever is known of the oil; where nothing holds any longer there is no life to lead."""
    force = force_on(bearing, 1.0) * np.geomspace(0.2, 60.0, 24)
    conditions = LifeConditions(viscosity_ratio=ratio, contamination=clean)
    found = leading(bearing, conditions, force, slope=slope)
    falls(found.life, -force)
    ended = np.flatnonzero(~found.leads)
    assert ended.size == 0 or np.all(~found.leads[ended[0] :])


@settings(max_examples=20)
@given(bearings, sizes, st.floats(1e-3, 6.0), st.floats(0.0, 1.0))
def test_more_speed_never_lengthens_it(
    bearing: Bearing, size: float, ratio: float, clean: float
) -> None:
    """In hours, of the same film: a given oil gets a better one with the speed."""
    most = 5e5 / (bearing.pitch_diameter * 1e3) * np.pi / 30.0
    speed = most * np.geomspace(0.01, 1.0, 20)
    force = np.full(speed.size, force_on(bearing, size))
    conditions = LifeConditions(viscosity_ratio=ratio, contamination=clean)
    falls(leading(bearing, conditions, force, speed).hours, -speed)


@settings(max_examples=20)
@given(bearings, sizes)
def test_what_is_not_known_is_taken_at_its_best(bearing: Bearing, size: float) -> None:
    """One of κ and e_C alone bounds the life; knowing the other as well never lengthens a bound."""
    force = np.full(OILS.size, force_on(bearing, size))
    basic = leading(bearing, LifeConditions(), force)
    half = leading(bearing, LifeConditions(viscosity_ratio=OILS), force)
    falls(half.life, OILS, within=MEETING)
    assert np.all(half.life <= basic.life)
    assert np.array_equal(half.below, (half.life < basic.life) & half.leads)
    assert np.all(half.below[OILS < 0.1] == half.leads[OILS < 0.1])
    for clean in (0.0, 0.3, 1.0):
        whole = leading(bearing, LifeConditions(viscosity_ratio=OILS, contamination=clean), force)
        assert np.all(whole.life[half.below] <= half.life[half.below] * (1.0 + 1e-12))
    force = force[: DIRTS.size]
    dirty = leading(bearing, LifeConditions(contamination=DIRTS), force)
    falls(dirty.life, DIRTS)
    assert np.all(dirty.below[DIRTS == 0.0] == dirty.leads[DIRTS == 0.0])
    assert dirty.life[DIRTS == 0.0] == pytest.approx(0.1 * basic.life[: (DIRTS == 0.0).sum()])
