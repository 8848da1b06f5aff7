"""Laws of the film: exponents, limits, entrainment of rolling, monotony."""

from __future__ import annotations

from math import cos, log

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.kinematics import ball_motion, rolling_entrainment_speed, surface_speeds
from rolamento.lubrication.film_thickness import (
    FilmGroups,
    central_film,
    film_groups,
    minimum_film,
)

speeds = st.floats(-2000.0, 2000.0)
ratios = st.floats(0.02, 0.4)


def groups(speed: float, load: float, material: float, ellipticity: float) -> FilmGroups:
    return FilmGroups(*(np.asarray(value) for value in (speed, load, material, ellipticity)))


@given(
    speed=st.floats(1e-13, 1e-9),
    load=st.floats(1e-8, 1e-2),
    material=st.floats(500.0, 10000.0),
    ellipticity=st.floats(1.0, 20.0),
)
def test_exponents(speed: float, load: float, material: float, ellipticity: float) -> None:
    base = (speed, load, material)
    for film, exponents in (
        (central_film, (0.67, -0.067, 0.53)),
        (minimum_film, (0.68, -0.073, 0.49)),
    ):
        for index, exponent in enumerate(exponents):
            up, down = list(base), list(base)
            up[index] *= 1.01
            down[index] /= 1.01
            ratio = float(film(groups(*up, ellipticity)) / film(groups(*down, ellipticity)))
            assert log(ratio) / log(1.01**2) == pytest.approx(exponent, abs=1e-9)


@given(ellipticity=st.floats(1.0, 30.0), growth=st.floats(1.01, 2.0))
def test_a_wider_contact_leaks_less(ellipticity: float, growth: float) -> None:
    narrow, wide = (groups(1e-11, 1e-6, 4500.0, k) for k in (ellipticity, ellipticity * growth))
    assert central_film(wide) >= central_film(narrow)
    assert minimum_film(wide) >= minimum_film(narrow)
    line = groups(1e-11, 1e-6, 4500.0, 1e3)
    assert float(central_film(line)) == pytest.approx(
        2.69 * 1e-11**0.67 * 4500.0**0.53 * 1e-6**-0.067, rel=1e-12
    )
    assert float(minimum_film(line)) == pytest.approx(
        3.63 * 1e-11**0.68 * 4500.0**0.49 * 1e-6**-0.073, rel=1e-12
    )


def test_no_speed_no_film_and_no_load_no_number() -> None:
    assert float(central_film(groups(0.0, 1e-6, 4500.0, 5.0))) == 0.0
    assert np.isnan(central_film(groups(1e-11, 0.0, 4500.0, 5.0)))
    assert np.isnan(minimum_film(groups(1e-11, np.nan, 4500.0, 5.0)))


def test_groups_of_the_rolling_radius() -> None:
    found = film_groups(2.0, 1000.0, 250.0, 5.0, 2.3e11, 0.02, 2e-8)
    assert float(found.speed) == pytest.approx(0.02 * 2.0 / (2.3e11 * 4e-3))
    assert float(found.load) == pytest.approx(1000.0 / (2.3e11 * 4e-3**2))
    assert float(found.material) == pytest.approx(4600.0)


@given(
    angle=st.floats(0.0, 1.2),
    ratio=ratios,
    inner=speeds,
    outer=speeds,
    control=st.sampled_from(["outer", "inner"]),
)
def test_entrainment_of_rolling_at_one_angle(
    angle: float, ratio: float, inner: float, outer: float, control: str
) -> None:
    """Mean speed (d_m/4)(1 - γ²)|ω_i - ω_o| at both races, whichever controls."""
    pitch = 0.1
    motion = ball_motion(angle, angle, ratio, inner, outer, control)  # type: ignore[arg-type]
    gamma = ratio * cos(angle)
    expected = float(rolling_entrainment_speed(pitch, gamma, inner, outer))
    for race, ring in (("inner", inner), ("outer", outer)):
        found = surface_speeds(
            race,  # type: ignore[arg-type]
            ratio * pitch,
            pitch,
            angle,
            ring,
            motion.orbital_speed,
            motion.ball_speed,
            motion.attitude,
        )
        scale = pitch * (abs(inner) + abs(outer) + 1.0)
        assert float(found.entrainment) == pytest.approx(expected, rel=1e-9, abs=1e-12 * scale)
        assert float(found.sliding) == pytest.approx(0.0, abs=1e-10 * scale)


@given(inner_angle=st.floats(0.1, 1.2), outer_angle=st.floats(0.1, 1.2), ratio=ratios, speed=speeds)
def test_nothing_slides_along_rolling_at_the_centre(
    inner_angle: float, outer_angle: float, ratio: float, speed: float
) -> None:
    """Also where the angles differ: the ball speeds were derived from rolling at both races."""
    motion = ball_motion(inner_angle, outer_angle, ratio, speed)
    for race, angle, ring in (("inner", inner_angle, speed), ("outer", outer_angle, 0.0)):
        found = surface_speeds(
            race,  # type: ignore[arg-type]
            ratio * 0.1,
            0.1,
            angle,
            ring,
            motion.orbital_speed,
            motion.ball_speed,
            motion.attitude,
        )
        assert float(found.sliding) == pytest.approx(0.0, abs=1e-10 * (abs(speed) + 1.0))


@given(
    angle=st.floats(0.0, 1.2),
    attitude=st.floats(-1.5, 1.5),
    yaw=st.floats(-1.0, 1.0),
    speed=speeds,
    orbit=speeds,
    ring=speeds,
)
def test_speeds_are_those_of_turning_bodies(
    angle: float, attitude: float, yaw: float, speed: float, orbit: float, ring: float
) -> None:
    """Against ω × r in three dimensions: along the shaft, outward, along the azimuth."""
    ball, pitch = 0.02, 0.1
    axis = np.array([cos(attitude) * cos(yaw), -np.sin(attitude), cos(attitude) * np.sin(yaw)])
    for race, side in (("inner", -1.0), ("outer", 1.0)):
        reach = 0.5 * side * ball * np.array([np.sin(angle), cos(angle), 0.0])
        place = reach + np.array([0.0, 0.5 * pitch, 0.0])
        of_ball = np.cross(speed * axis, reach)[2]
        of_ring = np.cross(np.array([ring - orbit, 0.0, 0.0]), place)[2]
        found = surface_speeds(race, ball, pitch, angle, ring, orbit, speed, attitude, yaw)  # type: ignore[arg-type]
        assert float(found.ball) == pytest.approx(of_ball, rel=1e-9, abs=1e-9)
        assert float(found.ring) == pytest.approx(of_ring, rel=1e-9, abs=1e-9)
