"""Laws of a turn of the cage: its period, its mirror image, what does not vary, what sums up.

The independent answers are the closed static sums of `rolamento.static` and SciPy's root finder on
the two equations of a radially loaded ring.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import root

from rolamento import Bearing, Case, Duty, Load, Model
from rolamento.solution import solve
from rolamento.static import race_stiffness, radial_load
from rolamento.studies.cage_turn import DEFAULT_POINTS, CageTurn, cage_turn

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.015 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
}


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(case(), fx=np.full(100, 1e4), inner_speed=100.0)


def case(rpm: float = 10_000.0, *, changes: dict[str, Any] | None = None, **load: float) -> Case:
    bearing = Bearing(**(ANGULAR | (changes or {})))
    return Case(bearing=bearing, duty=Duty(inner_speed=rpm * np.pi / 30.0, load=Load(**load)))


def radial_case(force: float = 8.9e3, **changes: Any) -> Case:
    return Case(bearing=Bearing(**(DEEP_GROOVE | changes)), duty=Duty(load=Load(fz=force)))


def extent(turn: CageTurn, axis: int = 2) -> float:
    assert turn.converged
    return float(turn.variation("displacement").peak_to_peak[axis])


@st.composite
def duties(draw: st.DrawFn) -> dict[str, float]:
    fx = draw(st.floats(3e3, 30e3))
    duty = {"fx": fx, "fz": fx * draw(st.floats(0.0, 0.6)), "fy": fx * draw(st.floats(-0.3, 0.3))}
    if draw(st.booleans()):
        duty |= {"my": fx * draw(st.floats(-2e-3, 2e-3)), "mz": fx * draw(st.floats(-2e-3, 2e-3))}
    return duty


# --- period and mirror ------------------------------------------------------------------------


@settings(max_examples=30)
@given(duties(), st.floats(0.0, 12_000.0), st.floats(0.0, 6.0), st.integers(1, 15))
def test_a_pitch_further_on_everything_is_as_before(
    duty: dict[str, float], rpm: float, angle: float, pitches: int
) -> None:
    given_case = case(rpm, **duty)
    turn = cage_turn(given_case, points=4)
    angles = angle + np.array([0.0, pitches * turn.period])
    batch = solve(given_case, first_ball_azimuth=angles)
    assume(bool(batch.converged.all()))
    np.testing.assert_allclose(*batch.displacement.array, rtol=1e-8, atol=1e-13)
    stiffness = batch.stiffness.array
    np.testing.assert_allclose(*stiffness, rtol=1e-7, atol=1e-8 * np.abs(stiffness).max())


@settings(max_examples=30)
@given(st.floats(3e3, 30e3), st.floats(0.05, 0.6), st.floats(0.0, 12_000.0), st.booleans())
def test_under_a_load_along_z_the_turn_is_its_own_mirror_image(
    fx: float, ratio: float, rpm: float, tilts: bool
) -> None:
    """x, z and ry are even in the azimuth, y and rz odd: mirrored, the ring turns backward."""
    moments = {"my": 0.0, "mz": 0.0} if tilts else {}
    turn = cage_turn(case(rpm, fx=fx, fz=ratio * fx, **moments), points=16)
    assume(turn.converged)
    mirrored = turn.solved.displacement.array[-np.arange(16)]
    signs = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
    np.testing.assert_allclose(
        signs * mirrored, turn.solved.displacement.array, rtol=1e-7, atol=1e-13
    )
    harmonics = turn.variation("displacement").harmonics
    even, odd = harmonics[:, [0, 2, 3]], harmonics[:, [1, 4]]
    scale = 1e-8 * np.abs(turn.solved.displacement.array).max()
    assert np.abs(even.imag).max() <= scale
    assert np.abs(odd.real).max() <= scale


# --- what does not vary -----------------------------------------------------------------------


@settings(max_examples=25)
@given(
    st.floats(500.0, 40e3),
    st.floats(0.0, 12_000.0),
    st.integers(3, 17),
    st.booleans(),
    st.sampled_from(["outer", "inner", "none"]),
)
def test_under_axial_load_alone_nothing_varies(
    fx: float, rpm: float, balls: int, tilts: bool, control: Any
) -> None:
    moments = {"my": 0.0, "mz": 0.0} if tilts else {}
    axial = case(rpm, changes={"ball_count": balls}, fx=fx, **moments)
    turn = cage_turn(axial.replace(model=Model(raceway_control=control)), points=16)
    assume(turn.converged)
    for quantity in ("displacement", "load", "stiffness"):
        variation = turn.variation(quantity)
        assert not variation.peak_to_peak.any()
        assert not variation.harmonics.any()
    assert turn.variation("displacement").mean[0] == pytest.approx(
        turn.solved.displacement.array[0, 0]
    )
    speed = turn.cage_speed
    assert speed.maximum - speed.minimum <= 1e-9 * abs(speed.mean)


# --- sums -------------------------------------------------------------------------------------


def test_the_loads_on_one_ball_over_a_revolution_add_up_to_the_loads_on_the_ring() -> None:
    """At rest Q acts along the contact: its mean over the way round is a Z-th of the load."""
    turn = cage_turn(case(0.0, fx=8e3, fz=6e3), points=32)
    history = turn.histories[0]
    push, angle = history.inner.load, history.inner.contact_angle
    sums = [
        16 * np.mean(push * np.sin(angle)),
        16 * np.mean(push * np.cos(angle) * np.cos(history.azimuth)),
        16 * np.mean(push * np.cos(angle) * np.sin(history.azimuth)),
    ]
    np.testing.assert_allclose(sums, [8e3, 6e3, 0.0], atol=1e-4)


@pytest.mark.parametrize("points", [9, 33])
def test_mean_and_harmonics_give_the_points_back(points: int) -> None:
    turn = cage_turn(radial_case(), points=points)
    variation = turn.variation("displacement")
    waves = np.exp(1j * np.outer(turn.angle, turn.orders))
    rebuilt = variation.mean + np.real(waves @ variation.harmonics)
    np.testing.assert_allclose(rebuilt, turn.solved.displacement.array, atol=1e-12)


def test_the_histories_hold_every_ball_of_every_instant() -> None:
    turn = cage_turn(case(fx=20e3, fz=15e3), points=12)
    (history,) = turn.histories
    np.testing.assert_allclose(history.azimuth, 2 * np.pi * np.arange(192) / 192, atol=1e-12)
    np.testing.assert_array_equal(
        np.sort(history.inner.load), np.sort(turn.solved.inner.load.ravel())
    )
    np.testing.assert_array_equal(
        np.sort(history.outer.load), np.sort(turn.solved.outer.load.ravel())
    )


# --- against other answers --------------------------------------------------------------------


@pytest.mark.parametrize("clearance", ["0.015 mm", "0 mm", "-0.004 mm", "0.06 mm"])
def test_a_radial_load_at_rest_agrees_with_the_closed_static_sums(clearance: str) -> None:
    """On the load line, between two balls, and everywhere else."""
    radial = radial_case(diametral_clearance=clearance)
    turn = cage_turn(radial, points=6)
    assert turn.converged
    for point, angle in enumerate(turn.angle):
        closed = radial_load(
            radial.bearing, 8.9e3, distribution="discrete", first_ball_azimuth=float(angle)
        )
        found = turn.solved.displacement.array[point, 1:3]
        expected = [float(closed.lateral_displacement), float(closed.radial_displacement)]
        np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-12)
        np.testing.assert_allclose(
            turn.solved.inner.load[point], closed.ball_loads, rtol=1e-6, atol=1e-3
        )


def test_one_instant_agrees_with_scipy() -> None:
    radial = radial_case()
    turn = cage_turn(radial, points=8)
    spring = float(race_stiffness(radial.bearing, 0.0).combined)
    azimuth = turn.angle[3] + 2 * np.pi * np.arange(9) / 9

    def unbalanced(place: Any) -> Any:
        squeeze = place[0] * np.cos(azimuth) + place[1] * np.sin(azimuth) - 7.5
        push = spring * (1e-6 * np.maximum(squeeze, 0.0)) ** 1.5
        return [push @ np.cos(azimuth) / 8.9e3 - 1.0, push @ np.sin(azimuth) / 8.9e3]

    found = root(unbalanced, [60.0, 0.0], tol=1e-12)
    assert found.success
    np.testing.assert_allclose(1e6 * turn.solved.displacement.array[3, [2, 1]], found.x, rtol=1e-8)


# --- convergence ------------------------------------------------------------------------------


def first_harmonics(given_case: Case, points: int) -> Any:
    return cage_turn(given_case, points=points).variation("displacement").harmonics[:3, 2]


def test_where_all_balls_stay_loaded_few_points_are_exact() -> None:
    """A smooth periodic function: the trapezoidal rule converges faster than any power."""
    loaded = case(fx=20e3, fz=15e3)
    exact = np.abs(first_harmonics(loaded, 256)[0])
    errors = [abs(np.abs(first_harmonics(loaded, n)[0]) - exact) / exact for n in (4, 6, 8)]
    assert errors[0] < 1e-4
    assert errors[1] < 0.1 * errors[0]
    assert errors[2] < 1e-7


def test_where_balls_leave_the_load_zone_the_error_falls_with_a_power_of_the_points() -> None:
    """Their load begins as the 3/2 power of the approach, so harmonics fall as order^-5/2."""
    exact = first_harmonics(radial_case(), 4096)
    scale = np.abs(exact).max()
    errors = [np.abs(first_harmonics(radial_case(), n) - exact).max() / scale for n in (16, 256)]
    assert errors[1] < errors[0] / 16.0**2
    assert np.abs(first_harmonics(radial_case(), DEFAULT_POINTS) - exact).max() < 1e-4 * scale


# --- tendencies -------------------------------------------------------------------------------


def test_an_axial_load_that_takes_up_every_ball_calms_the_turn() -> None:
    extents = [extent(cage_turn(case(0.0, fx=fx, fz=5e3))) for fx in (6e3, 8e3, 10e3)]
    assert extents[0] > 1e-8
    assert extents[1] < 1e-3 * extents[0]
    assert extents[2] < 1e-3 * extents[0]


def test_more_balls_calm_the_turn_while_all_are_loaded() -> None:
    turns = [
        cage_turn(case(0.0, changes={"ball_count": count}, fx=10e3, fz=5e3))
        for count in (6, 8, 10, 13)
    ]
    for fewer, more in pairwise(turns):
        assert fewer.solved.inner.load.min() > 0.0
        for axis in (0, 1, 2):
            assert extent(fewer, axis) > 5.0 * extent(more, axis) > 0.0


def test_an_interference_calms_the_turn() -> None:
    clearances = ("0.03 mm", "0.01 mm", "-0.04 mm")
    turns = [cage_turn(radial_case(diametral_clearance=clearance)) for clearance in clearances]
    across = [extent(turn, axis=1) for turn in turns]
    assert across[2] < 0.5 * min(across[:2])
